//! Digests of the committed Verilog, which tell whether a recorded result is about it or stale.
//!
//! `photoncube generate` writes them beside the Verilog, because emitting all machines takes too long for
//! every command that shows a result. `generate --check` compares them with the emitted text.

use std::collections::BTreeMap;

use anyhow::{Context, Result};
use photoncube_hdl::Emitted;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// The name of the file in the folder of all machines' Verilog.
pub const FILE: &str = "digests.json";

const COMMITTED: &str = include_str!("../../../hdl-out/digests.json");

/// The digests of one machine's Verilog.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Digests {
    /// See [`Emitted::verilog_sha256`].
    pub verilog_sha256: String,
    /// See [`Emitted::ecp5_sha256`].
    pub ecp5_sha256: String,
}

/// The digests of all machines and cores, and of the leaf machines of the cores, by name.
pub type ByMachine = BTreeMap<String, Digests>;

impl Digests {
    /// The digests of an emitted design.
    pub fn of(emitted: &Emitted) -> Self {
        Self {
            verilog_sha256: emitted.verilog_sha256(),
            ecp5_sha256: emitted.ecp5_sha256(),
        }
    }
}

/// SHA-256 of a whole file, comments and all, in hexadecimal digits; what `sha256sum` prints of it.
pub fn of_file(text: &str) -> String {
    let bytes = Sha256::digest(text);
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The text of the digests' file.
pub fn text(digests: &ByMachine) -> Result<String> {
    Ok(serde_json::to_string_pretty(digests)? + "\n")
}

/// The digests of the committed Verilog.
pub fn committed() -> Result<ByMachine> {
    serde_json::from_str(COMMITTED).with_context(|| format!("hdl-out/{FILE}"))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use photoncube_spec::{CORES, Core, MACHINES, RECORDED_CORES, find_machine};

    use super::*;

    #[test]
    fn a_file_has_the_digest_that_sha256sum_prints() {
        // printf 'photon\n' | sha256sum
        let printed = "4fb56389b4b4a07d0db7066b57a516cbc50dca0fa00496ae4031bf5cde507c56";
        assert_eq!(of_file("photon\n"), printed);
    }

    #[test]
    fn every_machine_has_its_digests() {
        let committed = committed().unwrap();
        let machines = MACHINES.iter().map(|machine| machine.name.to_owned());
        let cores = CORES.iter().chain(&RECORDED_CORES);
        let cores = cores.map(|&(chains, machine)| {
            let machine = find_machine(machine).unwrap();
            Core::new(machine, chains).unwrap().name()
        });
        let chains = CORES.iter().chain(&RECORDED_CORES);
        let chains = chains.map(|&(_, machine)| machine.to_owned());
        let designs: BTreeSet<_> = machines.chain(cores).chain(chains).collect();
        assert!(committed.keys().eq(&designs));
        assert_eq!(text(&committed).unwrap(), COMMITTED);
        let paper = &committed["paper"];
        assert_eq!(
            paper.verilog_sha256, paper.ecp5_sha256,
            "it has no second texts"
        );
        let stream = &committed["stream"];
        assert_ne!(stream.verilog_sha256, stream.ecp5_sha256);
    }
}
