//! A machine by name, and variations of it that are built in.

use anyhow::{Result, bail};
use clap::Args;
use photoncube_hdl::generator::{self, Step};
use photoncube_spec::{CORES, Core, MACHINES, Machine, Widths, find_machine};

use crate::progress;

/// Which machine.
#[derive(Args, Clone, Debug)]
pub struct MachineArgs {
    /// The machine, by name (see `photoncube list`)
    #[arg(long, default_value = MACHINES[0].name, value_name = "M")]
    pub machine: String,
    /// The variant of it with coordinates of N bits
    #[arg(long, value_name = "N")]
    pub coordinate_bits: Option<u32>,
    /// The variant of it on a hypercube of N dimensions
    #[arg(long, value_name = "N")]
    pub dimension: Option<u32>,
}

/// Which machine, if one is asked for.
#[derive(Args, Clone, Debug)]
pub struct ChosenMachineArgs {
    /// The machine, by name (see `photoncube list`) [default: what `photoncube fit` finds]
    #[arg(long, value_name = "M")]
    pub machine: Option<String>,
    /// The variant of it with coordinates of N bits
    #[arg(long, value_name = "N", requires = "machine")]
    pub coordinate_bits: Option<u32>,
    /// The variant of it on a hypercube of N dimensions
    #[arg(long, value_name = "N", requires = "machine")]
    pub dimension: Option<u32>,
}

impl ChosenMachineArgs {
    /// The machine asked for; none where none is.
    pub fn find(&self) -> Result<Option<&'static Machine>> {
        let named = self.machine.clone().map(|machine| MachineArgs {
            machine,
            coordinate_bits: self.coordinate_bits,
            dimension: self.dimension,
        });
        named.map(|args| args.find()).transpose()
    }
}

/// How many chains a core has.
#[derive(Args, Clone, Debug)]
pub struct CoreArgs {
    /// The chains of the core
    #[arg(long, default_value_t = CORES[0].0, value_name = "N")]
    pub chains: u32,
}

impl CoreArgs {
    /// The core of so many of the machine of that name.
    pub fn find(&self, machine: &str) -> Result<Core> {
        Ok(Core::new(find_machine(machine)?, self.chains)?)
    }
}

/// Makes what a custom machine's Verilog comes from: its generator, which cargo builds when a machine is used for the
/// first time. It shows what cargo compiles. A named machine needs none.
pub fn prepare(machine: &Machine) -> Result<()> {
    if MACHINES.contains(machine) {
        return Ok(());
    }
    let spinner = progress::spinner("building the machine's generator:");
    spinner.enable_steady_tick(progress::TICK);
    generator::prepare(machine, &mut |Step::Compiles(_)| spinner.inc(1))?;
    spinner.finish_and_clear();
    Ok(())
}

impl MachineArgs {
    /// The machine asked for, whose Verilog can be emitted.
    pub fn find_to_emit(&self) -> Result<&'static Machine> {
        let machine = self.find()?;
        prepare(machine)?;
        Ok(machine)
    }

    /// The machine asked for.
    pub fn find(&self) -> Result<&'static Machine> {
        let named = find_machine(&self.machine)?;
        let coordinate_bits = self.coordinate_bits.unwrap_or_else(|| bits(named));
        let dimension = self.dimension.unwrap_or(named.dimension);
        if (coordinate_bits, dimension) == (bits(named), named.dimension) {
            return Ok(named);
        }
        let is_wanted = |machine: &&Machine| {
            machine.plain().is_some()
                && named.plain().is_some()
                && machine.organisation == named.organisation
                && machine.squarer == named.squarer
                && (bits(machine), machine.dimension) == (coordinate_bits, dimension)
        };
        match MACHINES.iter().find(is_wanted) {
            Some(machine) => Ok(machine),
            None => bail!(
                "machine `{}` with {coordinate_bits}-bit coordinates on a {dimension}-D hypercube \
                 is not built in; built in are {}",
                named.name,
                built_in()
            ),
        }
    }
}

fn bits(machine: &Machine) -> u32 {
    Widths::of(machine).coordinate
}

fn built_in() -> String {
    let describe = |m: &Machine| format!("{} ({} bits, {}-D)", m.name, bits(m), m.dimension);
    MACHINES.iter().map(describe).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn find(machine: &str, bits: Option<u32>, dimension: Option<u32>) -> Result<&'static str> {
        let args = MachineArgs {
            machine: machine.to_owned(),
            coordinate_bits: bits,
            dimension,
        };
        args.find().map(|machine| machine.name)
    }

    #[test]
    fn variants_are_found_by_their_numbers() {
        assert_eq!(find("paper", None, None).unwrap(), "paper");
        assert_eq!(find("paper", Some(12), None).unwrap(), "paper-12");
        assert_eq!(find("paper", None, Some(5)).unwrap(), "paper-5d");
    }

    #[test]
    fn what_is_not_built_in_is_refused_with_what_is() {
        let error = find("paper", Some(9), None).unwrap_err().to_string();
        assert!(
            error.contains("9-bit") && error.contains("paper-12 (12 bits, 4-D)"),
            "{error}"
        );
        assert!(find("paper-dsp", Some(12), None).is_err());
        assert!(find("local", Some(8), None).is_err());
        assert!(find("overlap", None, Some(5)).is_err());
        assert!(find("pentium", None, None).is_err());
    }
}
