//! A design as gates: what Yosys's generic synthesis makes of it.

use std::process::Command;

use photoncube_hdl::Emitted;
use photoncube_spec::{Pins, SignalPlace};

use super::{DeviceError, scratch_folder, write_file};
use crate::tools::{Tool, run};

/// Yosys's `synth` with another step `memory_map`, which leaves memories of more than 256 words: a photon memory as
/// flip-flops would be hundreds of thousands.
const SYNTH_WITH_MEMORY: &str = "-run begin:fine; opt -fast -full; memory_map t:$mem_v2 r:SIZE<=256 %i; \
                                 opt -undriven -fine; techmap; opt -fast; abc -fast; opt_clean";

/// Synthesises the design to a flat netlist of generic gates and flip-flops. Its ports are the
/// same; its registers are single bits without their names, so only the output pins remain observed.
///
/// # Errors
/// Yosys is missing or refuses the text.
pub fn netlist(design: &Emitted) -> Result<Emitted, DeviceError> {
    Ok(with_outputs_alone(design, netlist_text(design, true)?))
}

/// The design with a netlist of it as its text, which has its ports; its registers have lost their names, so only the
/// output pins remain observed.
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

/// The netlist's text: flat, or with the modules of the design, each synthesised for itself.
///
/// # Errors
/// Yosys is missing or refuses the text.
pub(crate) fn netlist_text(design: &Emitted, is_flat: bool) -> Result<String, DeviceError> {
    let folder = scratch_folder()?;
    write_file(&folder.path().join("design.v"), &design.text)?;
    let mut registers = design.pins.observed.iter();
    let has_memory = registers.any(|pin| matches!(pin.place, SignalPlace::Memory { .. }));
    let steps = if has_memory { SYNTH_WITH_MEMORY } else { "" };
    let flatten = if is_flat { "-flatten" } else { "" };
    let script = format!(
        "read_verilog design.v; synth {flatten} -top {} {steps}; check -assert; \
         write_verilog -noattr netlist.v",
        design.top
    );
    run(Command::new(Tool::Yosys.find()?)
        .current_dir(folder.path())
        .args(["-q", "-p", &script]))?;
    let path = folder.path().join("netlist.v");
    std::fs::read_to_string(&path).map_err(|source| DeviceError::File {
        action: "read",
        path: path.display().to_string(),
        source,
    })
}
