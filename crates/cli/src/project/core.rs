//! The files of a core.

use std::path::PathBuf;

use anyhow::Result;
use photoncube_hdl::emit_core;
use photoncube_spec::{Core, CoreRegister, CoreStreams, StreamWord};
use serde_json::{Value, json};

use super::{Design, Project, ProjectFile, example, platform, rdl};
use crate::digests::Digests;

/// Emits a core and makes all of its files, in a folder of its name.
pub fn core_project(core: &Core) -> Result<Project> {
    let emitted = emit_core(core)?;
    let digests = Digests {
        verilog_sha256: emitted.verilog_sha256(),
        ecp5_sha256: emitted.ecp5_sha256(),
    };
    let folder = PathBuf::from(core.name());
    let top = emitted.top;
    let file = |ending: &str, text: String| ProjectFile {
        path: folder.join(format!("{top}{ending}")),
        text,
    };
    let more = [
        file(".rdl", rdl::text(core, emitted.digest)),
        file(".streams.json", streams(core, emitted.digest)?),
        file("_hw.tcl", platform::text(core)),
    ];
    let design = Design {
        top: &top,
        clock: "aclk",
        text: emitted.text,
        ecp5_text: emitted.machine.ecp5_text,
        example: example::core_example(core)?,
    };
    let files = design.files(&folder);
    Ok(Project {
        files: files.into_iter().chain(more).collect(),
        digests,
    })
}

/// The words of the streams, for programs that pack and read them.
fn streams(core: &Core, digest: u64) -> Result<String> {
    let streams = CoreStreams::of(core);
    let rows = CoreRegister::all(core, digest);
    let registers: serde_json::Map<_, _> = rows
        .iter()
        .map(|row| (row.name.clone(), Value::from(row.address)))
        .collect();
    let text = json!({
        "core": core.name(),
        "machine": core.machine.name,
        "digest": format!("{digest:016x}"),
        "chains": core.chains,
        "engines": core.engines(),
        "set_leaves": core.set_leaves(),
        "photons": word(&streams.photons),
        "queries": word(&streams.queries),
        "results": word(&streams.results),
        "registers": registers,
        "address_bits": Core::ADDRESS_BITS,
    });
    Ok(serde_json::to_string_pretty(&text)? + "\n")
}

fn word(word: &StreamWord) -> Value {
    let fields = word.fields.iter();
    let fields: Vec<_> = fields
        .map(|field| json!({ "name": field.name, "low": field.low, "width": field.width }))
        .collect();
    json!({ "bits": word.bits, "fields": fields })
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{CORES, CoreRegister, CounterRow, find_machine};

    use super::*;

    /// A row of the page's table of registers may have two of them, with commas.
    #[test]
    fn the_page_of_cores_has_every_register_with_its_address() {
        let page = include_str!("../../../../docs/cores.md");
        let (chains, machine) = CORES[0];
        let core = Core::new(find_machine(machine).unwrap(), chains).unwrap();
        let mut shown = Vec::new();
        for row in page.lines().filter(|line| line.starts_with("| ")) {
            let cells: Vec<_> = row.split('|').map(str::trim).collect();
            let addresses = cells[1].split(", ");
            let names = cells[2].split(", ").map(|name| name.trim_matches('`'));
            shown.extend(
                addresses
                    .zip(names)
                    .map(|(address, name)| format!("{address} {name}")),
            );
        }
        let rows = CoreRegister::all(&core, 0);
        let (counters, others): (Vec<_>, Vec<_>) = rows.iter().partition(|row| {
            use CoreRegister as R;
            matches!(row.register, R::CounterLow(_) | R::CounterHigh(_))
        });
        assert!(!others.is_empty());
        for row in others {
            let expected = format!("{:03x} {}", row.address, row.name);
            assert!(
                shown.contains(&expected),
                "docs/cores.md has no `{expected}`"
            );
        }
        let expected = format!(
            "{:03x} and on {} counters",
            counters[0].address,
            CounterRow::ALL.len()
        );
        assert!(
            shown.contains(&expected),
            "docs/cores.md has no `{expected}`"
        );
    }
}
