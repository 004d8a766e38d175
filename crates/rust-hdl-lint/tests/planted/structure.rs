//! Planted mistakes in whole blocks: names, memories, missing or hand-written text.

use crate::blocks::*;
use rust_hdl::prelude::ast::{VerilogExpression, VerilogOp, VerilogStatement};
use rust_hdl::prelude::*;

const K: LiteralType = 5;

/// A hand-written tree: `target = left + right`.
fn sum(target: &str, left: &str, right: &str) -> Verilog {
    let name = |name: &str| VerilogExpression::Signal(name.into());
    let value =
        VerilogExpression::Binary(Box::new(name(left)), VerilogOp::Add, Box::new(name(right)));
    Verilog::Combinatorial(vec![VerilogStatement::Assignment(name(target), value)])
}

/// A block around a core that is declared elsewhere.
#[derive(LogicBlock, Default)]
pub struct Wrapped {
    pub i: Signal<In, Bit>,
    pub o: Signal<Out, Bit>,
}

impl Logic for Wrapped {
    fn update(&mut self) {
        self.o.next = self.i.val();
    }
    fn connect(&mut self) {
        self.o.connect();
    }
    fn hdl(&self) -> Verilog {
        Verilog::Wrapper(Wrapper {
            code: "BUF inner(.I(i), .O(o));".into(),
            cores: "(* blackbox *)\nmodule BUF(input I, output O);\nendmodule".into(),
        })
    }
}

fn words(count: u64) -> impl Iterator<Item = Bits<8>> {
    (0..count).map(|word| word.into())
}

planted! {
    only_a_literal: ConstantOnlyBlock
    bad { y: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = 7.into();
        }
    }
    good { y: O<12>, state: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = 7.into();
            self.state.next = self.a.val();
        }
    }

    only_constants: ConstantOnlyBlock
    bad { y: O<12>, k: Constant<Bits<12>> = Constant::new(7.into()), passed: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.passed.next = self.k.val();
            self.y.next = self.passed.val();
        }
    }
    good { y: O<12>, k: Constant<Bits<12>> = Constant::new(7.into()) } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val() + self.k.val();
        }
    }

    ram_without_contents: UninitialisedMemory
    bad { y: O<8>, clock: Signal<In, Clock>, ram: RAM<Bits<8>, 3> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.ram.read_clock.next = self.clock.val();
            self.ram.write_clock.next = self.clock.val();
            self.ram.read_address.next = self.three.val();
            self.ram.write_address.next = self.three.val();
            self.ram.write_data.next = self.a.val().get_bits::<8>(0);
            self.ram.write_enable.next = self.x.val();
            self.y.next = self.ram.read_data.val();
        }
    }
    good { y: O<8>, clock: Signal<In, Clock>, ram: RAM<Bits<8>, 3> = words(8).into() } {
        #[hdl_gen]
        fn update(&mut self) {
            self.ram.read_clock.next = self.clock.val();
            self.ram.write_clock.next = self.clock.val();
            self.ram.read_address.next = self.three.val();
            self.ram.write_address.next = self.three.val();
            self.ram.write_data.next = self.a.val().get_bits::<8>(0);
            self.ram.write_enable.next = self.x.val();
            self.y.next = self.ram.read_data.val();
        }
    }

    rom_with_a_gap: UninitialisedMemory
    bad { y: O<8>, clock: Signal<In, Clock>, rom: SyncROM<Bits<8>, 3> = words(7).into() } {
        #[hdl_gen]
        fn update(&mut self) {
            self.rom.clock.next = self.clock.val();
            self.rom.address.next = self.three.val();
            self.y.next = self.rom.data.val();
        }
    }
    good { y: O<8>, clock: Signal<In, Clock>, rom: SyncROM<Bits<8>, 3> = words(8).into() } {
        #[hdl_gen]
        fn update(&mut self) {
            self.rom.clock.next = self.clock.val();
            self.rom.address.next = self.three.val();
            self.y.next = self.rom.data.val();
        }
    }

    memory_in_text: UninitialisedMemory
    bad { y: O<12> } {
        fn update(&mut self) {}
        fn connect(&mut self) {
            self.y.connect();
        }
        fn hdl(&self) -> Verilog {
            Verilog::Custom("(* no_rw_check *) reg [11:0] mem [0:7];\n\
                always @(posedge x) begin\n  y <= mem[three]; mem[three] <= a;\nend".into())
        }
    }
    good { y: O<12> } {
        fn update(&mut self) {}
        fn connect(&mut self) {
            self.y.connect();
        }
        fn hdl(&self) -> Verilog {
            Verilog::Custom("(* no_rw_check *) reg [11:0] mem [0:7];\ninteger k;\n\
                initial for (k = 0; k < 8; k = k + 1) mem[k] = 12'h0;\n\
                always @(posedge x) begin\n  y <= mem[three]; mem[three] <= a;\nend".into())
        }
    }

    const_in_expression: UndeclaredConstant
    bad { y: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val() + K;
        }
    }
    good { y: O<12>, k: Constant<Bits<12>> = Constant::new(K.into()) } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val() + self.k.val();
        }
    }

    stale_operand: StaleName
    bad { y: O<12> } {
        fn update(&mut self) {}
        fn connect(&mut self) {
            self.y.connect();
        }
        fn hdl(&self) -> Verilog {
            sum("y", "a", "gone$q")
        }
    }
    good { y: O<12> } {
        fn update(&mut self) {}
        fn connect(&mut self) {
            self.y.connect();
        }
        fn hdl(&self) -> Verilog {
            sum("y", "a", "b")
        }
    }

    stale_target: StaleName
    bad { y: O<12> } {
        fn update(&mut self) {}
        fn connect(&mut self) {
            self.y.connect();
        }
        fn hdl(&self) -> Verilog {
            sum("old_y", "a", "b")
        }
    }
    good { new_y: O<12> } {
        fn update(&mut self) {}
        fn connect(&mut self) {
            self.new_y.connect();
        }
        fn hdl(&self) -> Verilog {
            sum("new_y$next", "a", "b")
        }
    }

    stale_text: StaleName
    bad { y: O<12> } {
        fn update(&mut self) {}
        fn connect(&mut self) {
            self.y.connect();
        }
        fn hdl(&self) -> Verilog {
            Verilog::Custom("always @(*) y = a & old_mask; // old_mask was renamed".into())
        }
    }
    good { y: O<12> } {
        fn update(&mut self) {}
        fn connect(&mut self) {
            self.y.connect();
        }
        fn hdl(&self) -> Verilog {
            Verilog::Custom("wire [11:0] mask = 12'hff0;\nalways @(*) y = a & mask;".into())
        }
    }

    hand_written_width: WidthMismatch
    bad { y: O<13> } {
        fn update(&mut self) {}
        fn connect(&mut self) {
            self.y.connect();
        }
        fn hdl(&self) -> Verilog {
            sum("y", "a", "b")
        }
    }
    good { y: O<12> } {
        fn update(&mut self) {}
        fn connect(&mut self) {
            self.y.connect();
        }
        fn hdl(&self) -> Verilog {
            sum("y", "a", "b")
        }
    }

    hand_written_operands: WidthMismatch
    bad { y: O<12> } {
        fn update(&mut self) {}
        fn connect(&mut self) {
            self.y.connect();
        }
        fn hdl(&self) -> Verilog {
            sum("y", "a", "three")
        }
    }
    good { y: O<12> } {
        fn update(&mut self) {}
        fn connect(&mut self) {
            self.y.connect();
        }
        fn hdl(&self) -> Verilog {
            sum("y", "a", "x")
        }
    }

    verilog_keyword: KeywordName
    bad { begin: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.begin.next = self.a.val();
        }
    }
    good { first: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.first.next = self.a.val();
        }
    }

    keyword_of_an_instance: KeywordName
    bad { y: O<12>, clock: Signal<In, Clock>, cell: DFF<Bits<12>> } {
        #[hdl_gen]
        fn update(&mut self) {
            dff_setup!(self, clock, cell);
            self.cell.d.next = self.a.val();
            self.y.next = self.cell.q.val();
        }
    }
    good { y: O<12>, clock: Signal<In, Clock>, cell: [DFF<Bits<12>>; 1] } {
        #[hdl_gen]
        fn update(&mut self) {
            self.cell[0].clock.next = self.clock.val();
            self.cell[0].d.next = self.a.val();
            self.y.next = self.cell[0].q.val();
        }
    }

    system_verilog_keyword: KeywordName
    bad { priority: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.priority.next = self.a.val();
        }
    }
    good { rank: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.rank.next = self.a.val();
        }
    }

    update_without_text: MissingHdl
    bad { y: O<12> } {
        fn update(&mut self) {
            self.y.next = self.a.val();
        }
        fn connect(&mut self) {
            self.y.connect();
        }
    }
    good { y: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val();
        }
    }

    core_in_two_instances: RepeatedCore
    bad { y: BitO, one_core: Wrapped, two_core: Wrapped } {
        #[hdl_gen]
        fn update(&mut self) {
            self.one_core.i.next = self.x.val();
            self.two_core.i.next = self.one_core.o.val();
            self.y.next = self.two_core.o.val();
        }
    }
    good { y: BitO, one_core: Wrapped } {
        #[hdl_gen]
        fn update(&mut self) {
            self.one_core.i.next = self.x.val();
            self.y.next = self.one_core.o.val();
        }
    }
}
