//! Makes the bitstream of a design with its pins, for an ECP5.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::design::Design;
use crate::devices::Device;
use crate::error::{FlowError, Result, read, write};
use crate::flow::Flow;
use crate::program::{Program, run};
use crate::tools::Tools;
use crate::utilisation::{Resource, resources};

static ECPPACK: Program = Program {
    names: ["yowasp-ecppack", "ecppack"],
    version_option: "--version",
    version_after: "Version ",
};

/// A design in a package, with its pins.
#[derive(Clone, Debug)]
pub struct Pinned<'a> {
    /// The design. Its files are in the folder, see [`Design::write`].
    pub design: &'a Design,
    /// The FPGA: an ECP5.
    pub device: &'static Device,
    /// Its package.
    pub package: &'a str,
    /// Its speed grade.
    pub grade: u32,
    /// The flow that maps the design.
    pub flow: &'static Flow,
    /// See [`Flow::script`], in picoseconds.
    pub abc9_target_ps: u32,
    /// The pins and the clocks, as nextpnr reads them.
    pub lpf: &'a str,
    /// The seed of placement.
    pub seed: u32,
}

/// A clock of a design.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReachedClock {
    /// The name of its net.
    pub net: String,
    /// The highest frequency that the routed design reaches, in MHz.
    pub fmax_mhz: f64,
    /// The frequency that it must reach.
    pub needed_mhz: f64,
}

/// The result of [`bitstream`].
#[derive(Clone, Debug)]
pub enum Packed {
    /// The bitstream, and what was reached. A bitstream whose clock is not reached does not work.
    Done {
        /// The file.
        bytes: Vec<u8>,
        /// The clocks.
        clocks: Vec<ReachedClock>,
        /// The resources that are used.
        resources: Vec<Resource>,
    },
    /// The design needs more than the device has: all resources that it needs.
    TooLarge(Vec<Resource>),
}

/// A step of the flow.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum PackStep {
    /// Yosys maps the design.
    Map,
    /// nextpnr places and routes it.
    Place,
    /// ecppack writes the bitstream.
    Pack,
}

/// The names of the files in the folder.
const NETLIST: &str = "netlist.json";
const LPF: &str = "pins.lpf";
const CONFIG: &str = "routed.config";
const REPORT: &str = "report.json";
const LOG: &str = "nextpnr.log";
const BITSTREAM: &str = "design.bit";

/// The packer of bitstreams, in a folder, or on the PATH.
///
/// # Errors
/// It is not there.
pub fn packer(folder: Option<&Path>) -> Result<PathBuf> {
    // It runs in another folder, in which a relative path would have another meaning.
    let folder = folder.map(|folder| {
        std::path::absolute(folder).map_err(|source| FlowError::File {
            action: "read",
            path: folder.to_owned(),
            source,
        })
    });
    Ok(ECPPACK.find(folder.transpose()?.as_deref())?)
}

/// Maps, places, routes and packs a design. All files are in the folder.
///
/// # Errors
/// A tool fails for another reason than the size of the design.
pub fn bitstream(
    tools: &Tools,
    packer: &Path,
    folder: &Path,
    what: &Pinned<'_>,
    begins: &dyn Fn(PackStep),
) -> Result<Packed> {
    begins(PackStep::Map);
    let script = format!(
        "{}; {} -json {NETLIST}",
        what.design.read_commands(what.flow.family),
        what.flow.script(&what.design.top, what.abc9_target_ps)
    );
    tools.yosys().run(folder, &script)?;
    begins(PackStep::Place);
    write(&folder.join(LPF), what.lpf)?;
    let placed = tools.nextpnr(folder, &options(what));
    // The log has the resources as soon as the netlist is packed, also where placing then fails.
    let resources = resources(&read(&folder.join(LOG)).unwrap_or_default());
    match placed {
        Err(_) if resources.iter().any(Resource::is_lacking) => {
            return Ok(Packed::TooLarge(resources));
        }
        Err(error) => return Err(error),
        Ok(_) => {}
    }
    let clocks = clocks(&read(&folder.join(REPORT))?)?;
    begins(PackStep::Pack);
    run(
        packer,
        ["--compress", "--input", CONFIG, "--bit", BITSTREAM],
        folder,
    )?;
    let path = folder.join(BITSTREAM);
    let bytes = std::fs::read(&path).map_err(|source| FlowError::File {
        action: "read",
        path,
        source,
    })?;
    Ok(Packed::Done {
        bytes,
        clocks,
        resources,
    })
}

/// nextpnr's options.
fn options(what: &Pinned<'_>) -> Vec<String> {
    let (grade, seed) = (what.grade.to_string(), what.seed.to_string());
    let options = [
        "--quiet",
        "--log",
        LOG,
        "--json",
        NETLIST,
        what.device.option,
        "--package",
        what.package,
        "--speed",
        &grade,
        "--lpf",
        LPF,
        "--seed",
        &seed,
        "--textcfg",
        CONFIG,
        "--report",
        REPORT,
        // The caller judges the clocks.
        "--timing-allow-fail",
    ];
    options.map(str::to_owned).into()
}

/// The clocks in nextpnr's report.
fn clocks(report: &str) -> Result<Vec<ReachedClock>> {
    #[derive(Deserialize)]
    struct Report {
        fmax: BTreeMap<String, Clock>,
    }
    #[derive(Deserialize)]
    struct Clock {
        achieved: f64,
        constraint: f64,
    }
    let report: Report = serde_json::from_str(report).map_err(|source| FlowError::Json {
        writer: "nextpnr's `--report`",
        source,
    })?;
    let clocks = report.fmax.into_iter().map(|(net, of)| ReachedClock {
        net,
        fmax_mhz: of.achieved,
        needed_mhz: of.constraint,
    });
    Ok(clocks.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_clocks_are_those_of_the_report() {
        let report = r#"{"critical_paths": [], "fmax": {"$glbnet$clock": {"achieved": 61.5, "constraint": 50.0}}}"#;
        let clocks = clocks(report).unwrap();
        assert_eq!(clocks.len(), 1);
        assert_eq!((clocks[0].fmax_mhz, clocks[0].needed_mhz), (61.5, 50.0));
        assert!(super::clocks("{}").is_err());
    }

    #[test]
    fn a_packer_that_is_missing_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let error = packer(Some(folder.path())).unwrap_err().to_string();
        assert!(error.contains("yowasp-ecppack or ecppack"), "{error}");
    }
}
