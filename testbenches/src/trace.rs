//! The trace module: Verilog around an emitted design that makes its registers observable.

use std::fmt::Write as _;

use photoncube_hdl::{BlockRam, Emitted};
use photoncube_spec::Pin;

/// The name of the module that [`trace_module`] writes.
pub(crate) const TRACE: &str = "photoncube_trace";

/// The name of the design in the trace module.
pub(crate) const DUT: &str = "dut";

/// Makes a module that contains the design, as [`DUT`], and has a port for each of its pins and registers. The
/// module reads registers by hierarchical reference, and fills block RAMs with zeros as the golden model
/// does. The design's own text is unchanged.
pub(crate) fn trace_module(design: &Emitted) -> String {
    trace_module_with(design, "")
}

/// Makes the trace module with the Verilog `inside` added, which can name all ports.
pub(crate) fn trace_module_with(design: &Emitted, inside: &str) -> String {
    let (outputs, registers) = design.pins.observed.split_at(design.pins.outputs);
    let mut ports: Vec<_> = design.clocked.then_some("clock").into_iter().collect();
    ports.extend(names(&design.pins.inputs));
    ports.extend(names(outputs));
    let connections: Vec<_> = ports
        .iter()
        .map(|name| format!(".{name}({name})"))
        .collect();
    ports.extend(names(registers));
    let mut text = format!("module {TRACE}({});\n", ports.join(", "));
    if design.clocked {
        text += "  input clock;\n";
    }
    declare(&mut text, "input", &design.pins.inputs);
    declare(&mut text, "output", &design.pins.observed);
    let _ = writeln!(text, "  {} {DUT}({});", design.top, connections.join(", "));
    for (name, path) in names(registers).zip(&design.register_paths) {
        let _ = writeln!(text, "  assign {name} = {DUT}.{path};");
    }
    if !design.block_rams.is_empty() {
        text += "  integer block_ram_word;\n";
    }
    for BlockRam { path, words } in &design.block_rams {
        let _ = writeln!(
            text,
            "  initial for (block_ram_word = 0; block_ram_word < {words}; block_ram_word = block_ram_word + 1)\n    \
             {DUT}.{path}[block_ram_word] = 0;"
        );
    }
    text + inside + "endmodule\n"
}

/// The pins' names, in order.
pub(crate) fn names(pins: &[Pin]) -> impl Iterator<Item = &str> {
    pins.iter().map(|pin| pin.name.as_str())
}

/// Appends a declaration of each pin, one a line.
pub(crate) fn declare(text: &mut String, kind: &str, pins: &[Pin]) {
    for pin in pins {
        let _ = match pin.width {
            1 => writeln!(text, "  {kind} {};", pin.name),
            width => writeln!(text, "  {kind} [{}:0] {};", width - 1, pin.name),
        };
    }
}
