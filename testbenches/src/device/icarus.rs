//! Runs Verilog in Icarus, a slow 4-state simulator, in which a value that was never set is X.

use std::fmt::Write as _;
use std::fs::File;
use std::io::{BufRead, BufReader, Error, ErrorKind, Write};
use std::path::Path;
use std::process::{ChildStdin, ChildStdout, Command};

use fpga_flow::asic::Activities;
use photoncube_hdl::Emitted;
use tempfile::TempDir;

use super::activity::activities;
use super::process::Process;
use super::{Device, DeviceError, Observed, Unknown, netlist, scratch_folder, write_file};
use crate::tools::{Tool, run};
use crate::trace::{DUT, TRACE, declare, names, trace_module};

/// The compiled simulation.
const COMPILED: &str = "bench.vvp";
/// The file of the changes of nets.
const DUMP: &str = "nets.vcd";
/// The argument with which a simulation writes it.
const DUMP_ARGUMENT: &str = "dump";

/// What Icarus says before its first answer where it writes that file.
const DUMP_OPENED: &str = "VCD info: ";

/// A design in a running Icarus simulation.
pub struct Icarus {
    name: &'static str,
    version: String,
    /// The width of each input.
    widths: Vec<u32>,
    /// For each input, the inputs that must all be 1 for its word to be known.
    governing: Vec<Vec<usize>>,
    visible: usize,
    process: Process,
    /// The folder of the compiled simulation, which must exist while it runs, and of its dump.
    folder: TempDir,
}

impl Icarus {
    /// Compiles the design and starts it.
    ///
    /// # Errors
    /// Icarus is missing or refuses the text.
    pub fn new(design: &Emitted) -> Result<Self, DeviceError> {
        Self::start("icarus", design, Tool::Iverilog.version()?)
    }

    /// Starts the compiled design anew, from power-up. Every change of a net of its top module is written to a file, of some 5 bytes a
    /// change, in the folder for temporary files.
    ///
    /// # Errors
    /// The simulation does not start.
    pub fn dumping(self) -> Result<Self, DeviceError> {
        let process = simulation(self.name, self.folder.path(), &[DUMP_ARGUMENT])?;
        Ok(Self { process, ..self })
    }

    /// Ends a simulation that is [`dumping`](Self::dumping), and counts what the nets of the design's top module did in
    /// its first `clocks` clocks.
    ///
    /// # Errors
    /// The simulation failed or had fewer clocks, or a net was neither 0 nor 1 in one.
    pub fn activities(mut self, clocks: u64) -> Result<Activities, DeviceError> {
        self.process.finish()?;
        let path = self.folder.path().join(DUMP);
        let counted =
            File::open(&path).and_then(|dump| activities(BufReader::new(dump), DUT, clocks));
        counted.map_err(|source| DeviceError::File {
            action: "read",
            path: path.display().to_string(),
            source,
        })
    }

    /// Compiles the design and starts it. The word of an input is all x, except in clocks in which all inputs
    /// that govern it are 1.
    pub(crate) fn with_idle_unknown(
        design: &Emitted,
        governing: Vec<Vec<usize>>,
    ) -> Result<Self, DeviceError> {
        Ok(Self {
            governing,
            ..Self::new(design)?
        })
    }

    /// Synthesises the design to gates, compiles these and starts them.
    ///
    /// # Errors
    /// Yosys or Icarus is missing or refuses the text.
    pub fn of_netlist(design: &Emitted) -> Result<Self, DeviceError> {
        let version = format!("{}, {}", Tool::Yosys.version()?, Tool::Iverilog.version()?);
        Self::start("netlist", &netlist(design)?, version)
    }

    fn start(name: &'static str, design: &Emitted, version: String) -> Result<Self, DeviceError> {
        let folder = scratch_folder()?;
        let text = [design.text.as_str(), &trace_module(design), &bench(design)];
        let source = folder.path().join("bench.v");
        write_file(&source, &text.join("\n"))?;
        run(Command::new(Tool::Iverilog.find()?)
            .current_dir(folder.path())
            .args(["-g2005", "-s", "bench", "-o", COMPILED])
            .arg(&source))?;
        let process = simulation(name, folder.path(), &[])?;
        Ok(Self {
            name,
            version,
            widths: design.pins.inputs.iter().map(|pin| pin.width).collect(),
            governing: vec![Vec::new(); design.pins.inputs.len()],
            visible: design.pins.observed.len(),
            process,
            folder,
        })
    }
}

/// Starts the compiled simulation in its folder.
fn simulation(
    name: &'static str,
    folder: &Path,
    arguments: &[&str],
) -> Result<Process, DeviceError> {
    let mut simulate = Command::new(Tool::Vvp.find()?);
    let arguments = arguments.iter().map(|argument| format!("+{argument}"));
    // -n: where the simulation stops, it ends and does not prompt.
    simulate.args(["-n", COMPILED]).args(arguments);
    Process::start(name, simulate.current_dir(folder), folder)
}

impl Device for Icarus {
    fn name(&self) -> &str {
        self.name
    }

    fn tool_version(&self) -> &str {
        &self.version
    }

    fn visible(&self) -> usize {
        self.visible
    }

    fn replay(&mut self, inputs: &[u64], observed: &mut Observed) -> Result<(), DeviceError> {
        let clocks = inputs.len() / self.widths.len();
        let (widths, governing, visible) = (&self.widths, &self.governing, self.visible);
        self.process.converse(
            |stdin| write_frame(stdin, inputs, widths, governing),
            |stdout| read_frame(stdout, clocks, visible, observed),
        )
    }
}

fn write_frame(
    stdin: &mut ChildStdin,
    inputs: &[u64],
    widths: &[u32],
    governing: &[Vec<usize>],
) -> std::io::Result<()> {
    let columns = widths.len();
    let mut text = format!("{}\n", inputs.len() / columns);
    for row in inputs.chunks_exact(columns) {
        for (column, value) in row.iter().enumerate() {
            let is_known = governing[column].iter().all(|&valid| row[valid] != 0);
            if is_known {
                let _ = write!(text, "{value:x} ");
            } else {
                text += &"x".repeat(widths[column].div_ceil(4) as usize);
                text += " ";
            }
        }
        text += "\n";
        if text.len() > 1 << 16 {
            stdin.write_all(text.as_bytes())?;
            text.clear();
        }
    }
    stdin.write_all(text.as_bytes())
}

fn read_frame(
    stdout: &mut BufReader<ChildStdout>,
    clocks: usize,
    visible: usize,
    observed: &mut Observed,
) -> std::io::Result<()> {
    let mut line = String::new();
    for _ in 0..clocks {
        line.clear();
        stdout.read_line(&mut line)?;
        if line.starts_with(DUMP_OPENED) {
            line.clear();
            stdout.read_line(&mut line)?;
        }
        let before = observed.values.len();
        for word in line.split_whitespace() {
            let index = observed.values.len();
            observed.values.push(match u64::from_str_radix(word, 16) {
                Ok(value) => value,
                Err(_) if is_four_state(word) => {
                    let text = word.to_owned();
                    observed.unknown.push(Unknown { index, text });
                    0
                }
                Err(_) => return Err(nonsense(&line)),
            });
        }
        if observed.values.len() != before + visible {
            return Err(nonsense(&line));
        }
    }
    Ok(())
}

fn is_four_state(word: &str) -> bool {
    let legal = |letter: char| letter.is_ascii_hexdigit() || "xXzZ".contains(letter);
    word.chars().all(legal)
}

fn nonsense(line: &str) -> Error {
    let text = if line.is_empty() {
        "no answer".to_owned()
    } else {
        format!("cannot read its answer `{}`", line.trim())
    };
    Error::new(ErrorKind::InvalidData, text)
}

/// The Verilog testbench. It reads the number of clocks, then a line of hexadecimal inputs for each clock,
/// and writes a line of observed values for each.
fn bench(design: &Emitted) -> String {
    const STDIN: &str = "32'h8000_0000";
    const STDOUT: &str = "32'h8000_0001";
    let pins = &design.pins;
    let inputs: Vec<_> = names(&pins.inputs).collect();
    let observed: Vec<_> = names(&pins.observed).collect();
    let clock = design.clocked.then_some("clock");
    let ports = clock.iter().chain(&inputs).chain(&observed);
    let ports: Vec<_> = ports.map(|name| format!(".{name}({name})")).collect();
    let mut text = "module bench;\n".to_owned();
    text += "  reg clock = 0;\n  integer clocks, read;\n";
    declare(&mut text, "reg", &pins.inputs);
    declare(&mut text, "wire", &pins.observed);
    let read = " %h".repeat(inputs.len());
    // Icarus cannot read a word of many thousand characters, so a line is read in parts of this many values.
    const VALUES: usize = 256;
    let writes: String = observed
        .chunks(VALUES)
        .map(|chunk| {
            let format = "%h ".repeat(chunk.len());
            format!("        $write(\"{format}\", {});\n", chunk.join(", "))
        })
        .collect();
    let _ = write!(
        text,
        r#"  {TRACE} trace({ports});
  initial begin
    if ($test$plusargs("{DUMP_ARGUMENT}")) begin
      $dumpfile("{DUMP}");
      $dumpvars(1, trace.{DUT});
    end
    read = $fscanf({STDIN}, "%d", clocks);
    while (read == 1) begin
      while (clocks > 0) begin
        read = $fscanf({STDIN}, "{read}", {inputs});
        if (read != {count}) $finish(0);
        clock = 0;
        #1 ;
{writes}        $display("");
        clock = 1;
        #1 clocks = clocks - 1;
      end
      $fflush({STDOUT});
      read = $fscanf({STDIN}, "%d", clocks);
    end
    $finish(0);
  end
endmodule
"#,
        ports = ports.join(", "),
        inputs = inputs.join(", "),
        count = inputs.len(),
    );
    text
}
