//! Synthesises a design to gates, with Yosys's generic synthesis.

use std::collections::BTreeSet;

use photoncube_hdl::Emitted;
use photoncube_spec::Pins;

use super::{DeviceError, scratch_folder, write_file};
use crate::tools::yosys;

/// The names of the arrays of a design that are block RAMs.
pub(crate) fn block_ram_names(design: &Emitted) -> BTreeSet<&str> {
    let names = design.block_rams.iter();
    names
        .filter_map(|ram| ram.path.rsplit('.').next())
        .collect()
}

/// The options of Yosys's `synth` with a modified step `memory_map` that keeps the block RAMs. As flip-flops they would be
/// hundreds of thousands.
fn synth_with_memory(block_rams: &BTreeSet<&str>) -> String {
    // In a flat design the name of a memory follows the path of its module.
    let names = block_rams.iter().map(|name| format!("c:*{name} "));
    let unions = " %u".repeat(block_rams.len() - 1);
    format!(
        "-run begin:fine; opt -fast -full; memory_map t:$mem_v2 {}{unions} %d; opt -undriven -fine; techmap; opt -fast; \
         abc; opt_clean",
        names.collect::<String>()
    )
}

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
    let block_rams = block_ram_names(design);
    let has_memory = !block_rams.is_empty();
    let steps = match has_memory {
        true => synth_with_memory(&block_rams),
        false => String::new(),
    };
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
