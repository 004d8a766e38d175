//! A design as gates: what Yosys's generic synthesis makes of it.

use std::process::Command;

use photoncube_hdl::Emitted;
use photoncube_spec::Pins;

use super::{DeviceError, scratch_folder, write_file};
use crate::tools::{Tool, run};

/// Synthesises the design to a flat netlist of generic gates and flip-flops. Its ports are the
/// same; its registers are single
/// bits without their names, so only the output pins remain observed.
///
/// # Errors
/// Yosys is missing or refuses the text.
pub fn netlist(design: &Emitted) -> Result<Emitted, DeviceError> {
    let folder = scratch_folder()?;
    write_file(&folder.path().join("design.v"), &design.text)?;
    let script = format!(
        "read_verilog design.v; synth -flatten -top {}; check -assert; write_verilog -noattr netlist.v",
        design.top
    );
    run(Command::new(Tool::Yosys.find()?)
        .current_dir(folder.path())
        .args(["-q", "-p", &script]))?;
    let path = folder.path().join("netlist.v");
    let text = std::fs::read_to_string(&path).map_err(|source| DeviceError::File {
        action: "read",
        path: path.display().to_string(),
        source,
    })?;
    let pins = &design.pins;
    Ok(Emitted {
        text,
        register_paths: Vec::new(),
        pins: Pins {
            observed: pins.observed[..pins.outputs].to_vec(),
            ..pins.clone()
        },
        ..design.clone()
    })
}
