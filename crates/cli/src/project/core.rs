//! The files of a core.

use std::path::PathBuf;

use anyhow::Result;
use photoncube_hdl::emit_core;
use photoncube_spec::{Core, CoreRegister, CoreStreams, StreamWord};
use serde_json::{Value, json};

use super::{Design, Project, ProjectFile, rdl};
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
    ];
    let design = Design {
        top: &top,
        clock: "aclk",
        text: emitted.text,
        ecp5_text: emitted.machine.ecp5_text,
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
        "engines": core.leaf().chain.engines(),
        "set_leaves": core.set_leaves(),
        "photons": word(&streams.photons),
        "queries": word(&streams.queries),
        "results": word(&streams.results),
        "registers": registers,
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
