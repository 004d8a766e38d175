//! Synthesises a design to gates, with Yosys's generic synthesis.

use photoncube_hdl::Emitted;
use photoncube_spec::{Pins, SignalPlace};

use super::{DeviceError, scratch_folder, write_file};
use crate::tools::yosys;

/// Yosys's `synth` with a modified step `memory_map` that keeps memories of more than 256 words. A photon
/// memory as flip-flops would be hundreds of thousands of them.
const SYNTH_WITH_MEMORY: &str = "-run begin:fine; opt -fast -full; memory_map t:$mem_v2 r:SIZE<=256 %i; \
                                 opt -undriven -fine; techmap; opt -fast; abc; opt_clean";

/// Writes a memory, which may give any word where it is read in the clock that writes it, as a plain memory with
/// the attribute that says so, and not as logic that makes that word unknown. Yosys does not read its own logic for
/// this back as a memory.
const WRITE_WITH_MEMORY: &str =
    "setparam -set RD_COLLISION_X_MASK 1'0 t:$mem_v2; setattr -unset src *; write_verilog";

/// Synthesises the design to a flat netlist of generic gates and flip-flops, with the design's ports. Its
/// registers are single bits without their names, so only the output pins are observed.
///
/// # Errors
/// Yosys is missing or refuses the text.
pub fn netlist(design: &Emitted) -> Result<Emitted, DeviceError> {
    Ok(with_outputs_alone(design, netlist_text(design, true)?))
}

/// The design with its text replaced by a netlist that has its ports. The registers have lost their names, so
/// only the output pins are observed.
pub fn with_outputs_alone(design: &Emitted, text: String) -> Emitted {
    let pins = &design.pins;
    Emitted {
        text,
        register_paths: Vec::new(),
        block_rams: Vec::new(),
        pins: Pins {
            observed: pins.observed[..pins.outputs].to_vec(),
            ..pins.clone()
        },
        ..design.clone()
    }
}

/// The netlist's text: flat, or with the modules of the design, each synthesised on its own.
///
/// # Errors
/// Yosys is missing or refuses the text.
pub(crate) fn netlist_text(design: &Emitted, is_flat: bool) -> Result<String, DeviceError> {
    let folder = scratch_folder()?;
    write_file(&folder.path().join("design.v"), &design.text)?;
    let mut registers = design.pins.observed.iter();
    let has_memory = registers.any(|pin| matches!(pin.place, SignalPlace::Memory { .. }));
    let steps = if has_memory { SYNTH_WITH_MEMORY } else { "" };
    let (flatten, write) = match (is_flat, has_memory) {
        (true, _) => ("-flatten", "write_verilog -noattr"),
        (false, false) => ("", "write_verilog -noattr"),
        (false, true) => ("", WRITE_WITH_MEMORY),
    };
    let script = format!(
        "read_verilog design.v; synth {flatten} -top {} {steps}; check -assert; {write} netlist.v",
        design.top
    );
    yosys()?.run(folder.path(), &script)?;
    let path = folder.path().join("netlist.v");
    std::fs::read_to_string(&path).map_err(|source| DeviceError::File {
        action: "read",
        path: path.display().to_string(),
        source,
    })
}
