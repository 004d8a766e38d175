//! The tools of the tests.

use std::path::Path;
use std::process::Command;

use fpga_flow::Yosys;

/// The Yosys of `scripts/setup.sh --where`, or else one on the PATH.
pub fn yosys() -> Yosys {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scripts/setup.sh");
    let said = Command::new(script).arg("--where").output();
    let said = said.map_or(String::new(), |output| {
        String::from_utf8_lossy(&output.stdout).trim().to_owned()
    });
    let folder = (!said.is_empty()).then(|| Path::new(&said));
    Yosys::find(folder).unwrap()
}
