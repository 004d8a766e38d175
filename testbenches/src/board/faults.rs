//! Faults in the Verilog of a board that the comparison must find.

use photoncube_hdl::Ulx3s;

use super::{BoardError, Comparison, Scenario};
use crate::controls::{Control, plant};
use crate::device::{BoardSimulation, FAULT, hdl_error};

/// A fault: what it is, the scenario that finds it, the module, a line of it, an expression in this line, and the one in its place.
struct BoardFault {
    what: &'static str,
    scenario: Scenario,
    module: &'static str,
    line: &'static str,
    from: &'static str,
    to: &'static str,
}

const FAULTS: [BoardFault; 11] = [
    BoardFault {
        what: "the CRC is not checked",
        scenario: Scenario::Damage,
        module: "frames_in",
        line: "wire crc_is_right = crc_next == 16'd0;",
        from: "crc_next == 16'd0",
        to: "1'b1",
    },
    BoardFault {
        what: "the number is not checked",
        scenario: Scenario::Damage,
        module: "frames_in",
        line: "number_is_right <= value == expected;",
        from: "value == expected",
        to: "1'b1",
    },
    BoardFault {
        what: "frames behind a wrong one are taken",
        scenario: Scenario::Damage,
        module: "frames_in",
        line: "if (error) deaf <= 1'b1;",
        from: "1'b1",
        to: "1'b0",
    },
    BoardFault {
        what: "the byte behind an escape is not changed",
        scenario: Scenario::Damage,
        module: "frames_in",
        line: "wire [7:0] value = byte_data ^ (escaped ? 8'd32 : 8'd0);",
        from: "escaped ? 8'd32 : 8'd0",
        to: "8'd0",
    },
    BoardFault {
        what: "the bytes of a wrong frame stay in the buffer",
        scenario: Scenario::Damage,
        module: "buffer",
        line: "if (revert) written <= kept;",
        from: "kept",
        to: "written",
    },
    BoardFault {
        what: "a byte is lost while the core does not take a word",
        scenario: Scenario::Full,
        module: "buffer",
        line: "wire fetch = (kept != read) & (~read_valid | read_ready);",
        from: "~read_valid | read_ready",
        to: "1'b1",
    },
    BoardFault {
        what: "the buffer takes a byte more than it holds",
        scenario: Scenario::Full,
        module: "buffer",
        line: "assign room = ~held[12];",
        from: "~held[12]",
        to: "1'b1",
    },
    BoardFault {
        what: "the credit of a frame is a byte too large",
        scenario: Scenario::Words,
        module: "dispatch",
        line: "if (takes) taken <= taken + 16'd1;",
        from: "16'd1",
        to: "((state == KIND) ? 16'd2 : 16'd1)",
    },
    BoardFault {
        what: "a result is lost while another is sent",
        scenario: Scenario::Words,
        module: "frames_out",
        line: "assign result_ready = idle & ~synced_waits",
        from: "idle & ~synced_waits",
        to: "~synced_waits",
    },
    BoardFault {
        what: "a session that begins forgets nothing",
        scenario: Scenario::Full,
        module: "on_line",
        line: "wire clear = reset | (sync & sync_begins);",
        from: "sync & sync_begins",
        to: "1'b0",
    },
    BoardFault {
        what: "a byte without a stop bit is taken",
        scenario: Scenario::Damage,
        module: "uart_receiver",
        line: "byte_broken <= ~level;",
        from: "~level",
        to: "1'b0",
    },
];

/// Plants each fault in the Verilog of a board. All are in one text, and a pin of the simulation chooses the one that acts.
///
/// # Errors
/// The simulation does not run.
pub fn board_controls(board: &Ulx3s, seed: u64) -> Result<Vec<Control>, BoardError> {
    let mut files = board.files().map_err(hdl_error(board.core().machine))?;
    for (fault, number) in FAULTS.iter().zip(1..) {
        let module = format!("{}_{}", files.core.top, fault.module);
        files.board = plant(&files.board, &module, fault.line, &fault.chosen(number))?;
    }
    let control = |(fault, number): (&BoardFault, usize)| {
        let mut simulation = BoardSimulation::of_files(board, &files)?;
        simulation.set_fault(number);
        let mut comparison = Comparison::new(board, files.core.digest, fault.scenario, seed);
        let found = match comparison.run(&mut simulation, &mut Default::default()) {
            Err(BoardError::Diverged { .. }) => true,
            Ok(()) => false,
            Err(other) => return Err(other),
        };
        Ok(Control {
            planted: format!("{}: {}", board.core().name(), fault.what),
            found,
        })
    };
    FAULTS.iter().zip(1..).map(control).collect()
}

impl BoardFault {
    /// Its line, with an expression that is the wrong one where the pin has the number.
    fn chosen(&self, number: usize) -> String {
        let Self { from, to, .. } = self;
        let chosen = format!("(({FAULT} == 8'd{number}) ? ({to}) : ({from}))");
        self.line.replacen(from, &chosen, 1)
    }
}
