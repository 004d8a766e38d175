//! Makes the files of a machine: its Verilog, an example of how to drive it, and the project files for Yosys and Quartus.

mod core;
mod example;
mod platform;
mod rdl;

use std::path::{Path, PathBuf};

use anyhow::Result;
use photoncube_hdl::{Level, emit};
use photoncube_spec::Machine;

pub use self::core::core_project;
pub use self::example::Set;
use crate::digests::Digests;
use crate::files;
use crate::outputs::{self, Output};

/// The contents of a machine's folder.
pub struct Project {
    /// The files, the Verilog first.
    pub files: Vec<ProjectFile>,
    /// The digests of the Verilog.
    pub digests: Digests,
}

/// A file of a machine's folder.
pub struct ProjectFile {
    /// The path of the file in the output folder.
    pub path: PathBuf,
    /// The contents of the file.
    pub text: String,
}

/// The clock period that the project files set, a target for the tools and not a measured figure.
const TARGET_CLOCK_NS: u32 = 10;

/// The delay in ps above which Yosys's ABC9 trades area for speed, in the project files and in all
/// measurements of `photoncube synth`. Without it the design with DSP blocks takes three times the LUTs.
pub const ABC9_TARGET_PS: u32 = 1000 * TARGET_CLOCK_NS;

/// The version of Yosys that the areas of docs/measured/ are by.
const YOSYS: &str = "0.70";

/// The endings of the files that a machine's Yosys script writes beside itself: the netlist and the areas.
const BY_YOSYS: [&str; 2] = ["json", "stat"];

/// The files that a machine's Yosys script writes into the machine's folder, as paths in the output folder.
pub fn written_by_yosys(design: &str) -> Vec<PathBuf> {
    let top = photoncube_spec::module_prefix(design);
    let path = |ending: &str| PathBuf::from(design).join(format!("{top}.{ending}"));
    BY_YOSYS.map(path).into()
}

/// Emits a machine and makes all of its files.
pub fn project(machine: &Machine) -> Result<Project> {
    let emitted = emit(machine, Level::Machine)?;
    let digests = Digests::of(&emitted);
    let folder = PathBuf::from(machine.name);
    let design = Design {
        top: &emitted.top,
        clock: "clock",
        text: emitted.text,
        ecp5_text: emitted.ecp5_text,
        example: example::machine_example(machine)?,
    };
    let files = design.files(&folder);
    Ok(Project { files, digests })
}

/// A design with the files that every design has.
struct Design<'a> {
    top: &'a str,
    /// The name of the clock's port.
    clock: &'a str,
    text: String,
    ecp5_text: Option<String>,
    /// A testbench.
    example: String,
}

impl Design<'_> {
    /// The Verilog, the Yosys script, the Quartus project and the example, in a folder.
    fn files(self, folder: &Path) -> Vec<ProjectFile> {
        let top = self.top;
        let file = |ending: &str, text: String| ProjectFile {
            path: folder.join(format!("{top}{ending}")),
            text,
        };
        let mut files = vec![
            file(".v", self.text),
            file(".ys", yosys(top, self.ecp5_text.is_some())),
            file(".qpf", format!("PROJECT_REVISION = \"{top}\"\n")),
            file(".qsf", quartus(top, self.clock)),
            file(".sdc", constraints(self.clock)),
            file("_tb.v", self.example),
        ];
        files.extend(self.ecp5_text.map(|text| file("_ecp5.v", text)));
        files
    }
}

/// Writes the files of a machine into a folder of its name in `out`, which `option` gave, and returns their paths, the
/// Verilog first. None of them may be one of `inputs`.
pub fn write(
    machine: &Machine,
    option: &'static str,
    out: &Path,
    inputs: &[PathBuf],
) -> Result<Vec<String>> {
    let files = project(machine)?.files;
    let path = |file: &ProjectFile| out.join(&file.path);
    let outputs = files.iter().map(|file| Output::within(option, path(file)));
    outputs::check(&outputs.collect::<Vec<_>>(), inputs)?;
    files::write_all(files.iter().map(|file| (path(file), file.text.as_bytes())))?;
    Ok(files
        .iter()
        .map(|file| path(file).display().to_string())
        .collect())
}

fn yosys(top: &str, has_second_texts: bool) -> String {
    let second_texts = match has_second_texts {
        false => String::new(),
        true => format!(
            "# Modules made of the ECP5's own cells, where Yosys would spend LUTs and flip-flops; proven equal by\n\
             # scripts/yosys/ecp5.sh.\n\
             read_verilog -overwrite {top}_ecp5.v\n"
        ),
    };
    format!(
        "# yosys {top}.ys: maps the design to ECP5, whose cells `synth_ecp5` reads before it checks that no module\n\
         # is missing. It writes {top}.json, the netlist, and {top}.stat, the areas.\n\
         # Photoncube's own figures are by Yosys {YOSYS}; another version counts otherwise.\n\
         read_verilog {top}.v\n\
         {second_texts}\
         # ABC9 trades area for speed only where a path is longer than this, in ps.\n\
         scratchpad -set abc9.D {ABC9_TARGET_PS}\n\
         synth_ecp5 -top {top} -json {top}.json\n\
         # Into a file, because YoWASP's Yosys prints nothing more to a pipe once ABC has run.\n\
         tee -o {top}.stat stat\n"
    )
}

/// The Quartus project. The streams are virtual pins, because the machine is a block of a larger design, and
/// no package has that many pins.
fn quartus(top: &str, clock: &str) -> String {
    format!(
        "# quartus_sh --flow compile {top}\n\
         set_global_assignment -name FAMILY \"Cyclone V\"\n\
         set_global_assignment -name DEVICE 5CSEMA5F31C6\n\
         set_global_assignment -name TOP_LEVEL_ENTITY {top}\n\
         set_global_assignment -name VERILOG_INPUT_VERSION VERILOG_2001\n\
         set_global_assignment -name VERILOG_FILE {top}.v\n\
         set_global_assignment -name SDC_FILE {top}.sdc\n\
         set_instance_assignment -name VIRTUAL_PIN ON -to *\n\
         set_instance_assignment -name VIRTUAL_PIN OFF -to {clock}\n"
    )
}

fn constraints(clock: &str) -> String {
    format!("create_clock -name {clock} -period {TARGET_CLOCK_NS} [get_ports {clock}]\n")
}

#[cfg(test)]
mod tests {
    use photoncube_spec::MACHINES;

    use super::*;

    #[test]
    fn no_script_checks_the_hierarchy_before_the_cells_are_read() {
        for machine in MACHINES.iter().filter(|m| m.queries_at_once() == 1) {
            let files = project(machine).unwrap().files;
            let script = files
                .iter()
                .find(|file| file.path.extension() == Some("ys".as_ref()));
            let script = &script.expect("every machine has a script").text;
            assert!(!script.contains("hierarchy"), "{script}");
            assert!(script.contains("synth_ecp5 -top"), "{script}");
        }
    }

    #[test]
    fn a_script_names_the_files_that_it_writes() {
        let machine = photoncube_spec::find_machine("stream").unwrap();
        let script = yosys(&machine.module_prefix(), true);
        for path in written_by_yosys(machine.name) {
            let name = path.file_name().unwrap().to_str().unwrap();
            let writes = format!("-json {name}\n");
            let prints = format!("tee -o {name} stat\n");
            assert!(
                script.contains(&writes) || script.contains(&prints),
                "{script}"
            );
        }
    }

    #[test]
    fn the_scripts_name_the_version_of_the_recorded_areas() {
        let areas = include_str!("../../../../docs/measured/synthesis.json");
        assert!(areas.contains(&format!("\"yosys\": \"{YOSYS} (")));
    }
}
