//! Finds the constant bits of a machine. Yosys propagates constants over the whole flattened machine, with
//! the initial values of registers, and leaves these bits as 0 or 1.

use std::collections::HashSet;

use fpga_flow::Netlist;
use fpga_flow::netlist::Bit;
use photoncube_hdl::Emitted;

use crate::device::{DeviceError, scratch_folder, write_file};
use crate::tools::yosys;

/// Constant bits by their path in the top instance, such as `cell_12.photon_q`, with the bit.
pub(super) type Constants = HashSet<(String, u32)>;

/// `-norom`: a table with a constant address is a constant, a memory is not. `keep`: signals without a reader
/// are propagated too.
const PASSES: &str =
    "proc -norom; flatten; setattr -set keep 1 w:*; opt -full; write_json netlist.json";

/// Finds the constant bits of a design.
///
/// # Errors
/// Yosys is missing or refuses the text.
pub(super) fn constants(design: &Emitted) -> Result<Constants, DeviceError> {
    let folder = scratch_folder()?;
    write_file(&folder.path().join("design.v"), &design.text)?;
    let top = &design.top;
    let script = format!("read_verilog design.v; hierarchy -top {top}; {PASSES}");
    yosys()?.run(folder.path(), &script)?;
    let path = folder.path().join("netlist.json");
    let text = std::fs::read_to_string(&path).map_err(|source| DeviceError::File {
        action: "read",
        path: path.display().to_string(),
        source,
    })?;
    Ok(constants_of(&Netlist::parse(&text)?))
}

fn constants_of(netlist: &Netlist) -> Constants {
    let nets = netlist.modules().flat_map(|(_, module)| module.nets());
    let bits = nets.flat_map(|(name, bits)| {
        // An undriven bit is `x`, which is not a constant.
        let is_constant = |bit: &Bit| matches!(bit, Bit::Constant(value) if value != "x");
        let bits = (0..).zip(bits).filter(move |(_, bit)| is_constant(bit));
        bits.map(move |(index, _)| (name.to_owned(), index))
    });
    bits.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constant_bits_are_those_without_a_wire() {
        let text = r#"{"modules": {"top": {"netnames": {"a.q": {"bits": [4, "0", "1", "x"]}}}}}"#;
        let constants = constants_of(&Netlist::parse(text).unwrap());
        let expected = [1, 2].map(|bit| ("a.q".to_owned(), bit));
        assert_eq!(constants, HashSet::from(expected));
    }
}
