//! Runs OpenSTA on a mapped netlist, and reads the period and the powers from what it prints.

use std::path::{Path, PathBuf};

use super::activity::SOURCE;
use super::library::Library;
use super::{ACTIVITIES, CLOCK, LIBERTY, NETLIST, POWERED};
use crate::error::{Result, ensure, unexpected, write};
use crate::program::{Program, run};
use crate::yosys::version_of;

static PROGRAM: Program = Program {
    names: ["opensta", "sta"],
    version_option: "-version",
    version_after: "",
};

/// An installed OpenSTA.
#[derive(Clone, Debug)]
pub struct Sta {
    path: PathBuf,
}

/// The period and the powers of a design.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Times {
    /// The shortest clock period, in ns.
    pub period_ns: f64,
    pub registers: Power,
    pub logic: Power,
}

/// The power of some cells at the clock period [`PERIOD_NS`].
#[derive(Copy, Clone, Debug, PartialEq)]
pub(super) struct Power {
    /// What switches in the cells, in watts.
    pub internal_w: f64,
    /// What switches on the nets that the cells drive, in watts.
    pub switching_w: f64,
    /// What flows at rest, in watts.
    pub leakage_w: f64,
}

/// For each transition of a pin, OpenSTA of [`Sta::VERSION`] adds the energies of its rise and of its fall; later versions take their mean. The
/// rows of a cell's energies by its inputs are weighted so that the weights add up to 1 in registers, inverters, buffers, and gates of
/// two inputs, but to 0.75 in a NAND of three, to 1.75 in an AND-OR-invert and to 2 in an XOR whose rows have conditions.
const OVERCOUNT: f64 = 0.5;

/// The clock period at which powers are computed, in ns. The energy of a cycle does not depend on it.
const PERIOD_NS: f64 = 10.0;

/// The name of the row with the powers of the registers behind inputs.
const SOURCES: &str = "Sources";
/// The name of the row with the power that registers behind clock gates do not take.
const STOPPED: &str = "Stopped";

impl Power {
    /// The energy of a clock cycle, in picojoules.
    pub(super) fn cycle_energy_pj(self) -> f64 {
        1e3 * (self.internal_w + self.switching_w) * PERIOD_NS
    }
}

impl Sta {
    /// The version of OpenSTA whose powers are understood here: other versions count energies otherwise.
    pub const VERSION: &str = "2.0.17";

    /// Finds OpenSTA on the PATH. It tells its version in the folder `scratch`.
    ///
    /// # Errors
    /// It is not there, or is not of [`Self::VERSION`].
    pub fn find(scratch: &Path) -> Result<Self> {
        let path = PROGRAM.find(None)?;
        check_version(&version_of(&PROGRAM, &path, scratch)?)?;
        Ok(Self { path })
    }

    /// Measures the netlist in the folder. Inputs come from registers of the library, and all paths end within a clock period.
    pub(super) fn measure(
        &self,
        folder: &Path,
        top: &str,
        library: &Library,
        activity: f64,
    ) -> Result<Times> {
        let file = "times.tcl";
        write(&folder.join(file), &script(top, library, activity))?;
        let said = run(&self.path, ["-no_splash", "-exit", file], folder)?;
        times(&said)
    }

    /// The powers of the registers and of the logic of the netlist [`POWERED`] at the activities that [`ACTIVITIES`] gives its pins,
    /// without the registers behind its inputs.
    ///
    /// OpenSTA takes every register behind a clock gate for one that each edge of the clock reaches. `gated` is
    /// [`Told::gated`](super::activity::Told::gated), by which the energy of the edges that do not is subtracted.
    pub(super) fn powers(
        &self,
        folder: &Path,
        top: &str,
        gated: Option<&str>,
    ) -> Result<[Power; 2]> {
        let run_script = |file: &str, script: String| -> Result<String> {
            write(&folder.join(file), &script)?;
            Ok(run(&self.path, ["-no_splash", "-exit", file], folder)?)
        };
        let [mut registers, mut logic] = powers(&run_script("powers.tcl", powers_script(top))?)?;
        if let Some(gated) = gated {
            let said = run_script("stopped.tcl", stopped_script(top, gated))?;
            let stopped = power(&said, STOPPED)?;
            registers.internal_w -= stopped.internal_w;
            logic.switching_w -= stopped.switching_w;
        }
        Ok([registers, logic])
    }
}

fn check_version(found: &str) -> Result<()> {
    ensure(found == Sta::VERSION, || {
        format!(
            "found OpenSTA {found}, expected {}, which Debian 12 has",
            Sta::VERSION
        )
    })
}

/// [`Power`] of the design, and the sum over the registers behind its inputs. OpenSTA's own `set_power_activity -pins` passes over
/// outputs of cells, so the script calls what it calls.
fn powers_script(top: &str) -> String {
    let linked = linked(POWERED, top);
    format!(
        "{linked}source {ACTIVITIES}
report_power -digits 9
set internal 0.0
set switching 0.0
set leakage 0.0
foreach source [get_cells -quiet {SOURCE}*] {{
  lassign [sta::instance_power $source [sta::cmd_corner]] in through rest
  set internal [expr {{$internal + $in}}]
  set switching [expr {{$switching + $through}}]
  set leakage [expr {{$leakage + $rest}}]
}}
puts \"{SOURCES} $internal $switching $leakage [expr {{$internal + $switching + $leakage}}]\"
"
    )
}

/// The power of the clock edges that do not reach the registers behind clock gates, and of the nets to them, see [`Sta::powers`].
fn stopped_script(top: &str, gated: &str) -> String {
    let linked = linked(POWERED, top);
    format!(
        "{linked}source {ACTIVITIES}
{gated}set internal 0.0
foreach {{register part}} $stopped {{
  lassign [sta::instance_power [get_cells $register] [sta::cmd_corner]] in through rest
  set internal [expr {{$internal + $part * $in}}]
}}
set switching 0.0
foreach {{gate part}} $stopped_nets {{
  lassign [sta::instance_power [get_cells $gate] [sta::cmd_corner]] in through rest
  set switching [expr {{$switching + $part * $through}}]
}}
puts \"{STOPPED} $internal $switching 0.0 [expr {{$internal + $switching}}]\"
"
    )
}

/// The commands that read a netlist and give it its clock.
fn linked(netlist: &str, top: &str) -> String {
    format!(
        "set_cmd_units -time ns -power W
read_liberty {LIBERTY}
read_verilog {netlist}
link_design {top}
create_clock -name {CLOCK} -period {PERIOD_NS} [get_ports {CLOCK}]
"
    )
}

fn script(top: &str, library: &Library, activity: f64) -> String {
    let register = &library.register().cell;
    let linked = linked(NETLIST, top);
    format!(
        "{linked}foreach port [all_inputs] {{
  if {{[get_name $port] != \"{CLOCK}\"}} {{
    set_driving_cell -lib_cell {} -pin {} $port
    set_input_delay 0 -clock {CLOCK} $port
  }}
}}
set_output_delay 0 -clock {CLOCK} [all_outputs]
report_worst_slack -digits 6
set_power_activity -global -activity {activity} -duty 0.5
report_power -digits 9
",
        register.cell, register.output
    )
}

/// The figures in what OpenSTA printed.
fn times(said: &str) -> Result<Times> {
    Ok(Times {
        period_ns: PERIOD_NS - row(said, "worst slack")?[0],
        registers: power(said, "Sequential")?,
        logic: power(said, "Combinational")?,
    })
}

/// The powers of registers and logic in what OpenSTA printed, without those of the registers behind inputs.
fn powers(said: &str) -> Result<[Power; 2]> {
    let [all, sources] = [power(said, "Sequential")?, power(said, SOURCES)?];
    let registers = Power {
        internal_w: all.internal_w - sources.internal_w,
        switching_w: all.switching_w - sources.switching_w,
        leakage_w: all.leakage_w - sources.leakage_w,
    };
    Ok([registers, power(said, "Combinational")?])
}

/// The numbers in a row of what OpenSTA printed.
fn row(said: &str, name: &str) -> Result<Vec<f64>> {
    // OpenSTA goes on after an error, with results that are of something else.
    if let Some(error) = said.lines().find(|line| line.starts_with("Error")) {
        return Err(unexpected(format!("OpenSTA says: {error}")));
    }
    let line = said.lines().find_map(|line| line.strip_prefix(name));
    let words = line.into_iter().flat_map(str::split_whitespace);
    let numbers: Vec<f64> = words.map_while(|word| word.parse().ok()).collect();
    match numbers.is_empty() {
        true => Err(unexpected(format!(
            "found no `{name}` in what OpenSTA says"
        ))),
        false => Ok(numbers),
    }
}

fn power(said: &str, name: &str) -> Result<Power> {
    match row(said, name)?[..] {
        [internal, switching, leakage, _total] => Ok(Power {
            internal_w: OVERCOUNT * internal,
            switching_w: switching,
            leakage_w: leakage,
        }),
        _ => Err(unexpected(format!(
            "found another table of powers in what OpenSTA says, row `{name}`"
        ))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SAID: &str = "\
worst slack 6.738280
Group                     Internal    Switching      Leakage        Total
                             Power        Power        Power        Power
----------------------------------------------------------------
Sequential           1.100000e-01 1.000000e-02 7.000000e-07 1.200007e-01  81.6%
Combinational        2.300000e-02 4.000000e-03 6.000000e-07 2.700060e-02  18.4%
Total                1.330000e-01 1.400000e-02 1.300000e-06 1.470013e-01 100.0%
";

    #[test]
    fn the_period_and_the_powers_are_read() {
        let times = times(SAID).unwrap();
        assert!((times.period_ns - 3.261_72).abs() < 1e-9);
        // Half of 0.11 W and 0.01 W, in 10 ns.
        assert!((times.registers.cycle_energy_pj() - 650.0).abs() < 1e-6);
        assert!((times.logic.cycle_energy_pj() - 155.0).abs() < 1e-6);
        assert!((times.logic.leakage_w - 6e-7).abs() < 1e-15);
    }

    #[test]
    fn another_version_is_refused() {
        assert_eq!(
            PROGRAM.version("2.0.17 c018cb2\n").as_deref(),
            Some(Sta::VERSION)
        );
        check_version(Sta::VERSION).unwrap();
        let error = check_version("2.6.0").unwrap_err().to_string();
        assert!(
            error.contains("2.6.0") && error.contains("2.0.17"),
            "{error}"
        );
    }

    #[test]
    fn an_error_or_a_missing_row_is_told() {
        let error = times(&format!("Error: mapped.v, line 1 syntax error\n{SAID}"));
        assert!(
            error
                .unwrap_err()
                .to_string()
                .contains("line 1 syntax error")
        );
        let error = times(&SAID.replace("Sequential", "Registers"));
        assert!(error.unwrap_err().to_string().contains("`Sequential`"));
        let error = times(&SAID.replace("worst slack", "slack"));
        assert!(error.unwrap_err().to_string().contains("`worst slack`"));
    }
}
