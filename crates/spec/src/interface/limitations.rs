//! What a user of a machine or a core must design around.

use crate::core::Core;
use crate::machine::Machine;

/// A limitation, as text for people.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Limitation {
    /// What is limited, in a sentence.
    pub says: String,
    /// What to do about it.
    pub remedy: String,
}

fn limitation(says: impl Into<String>, remedy: impl Into<String>) -> Limitation {
    Limitation {
        says: says.into(),
        remedy: remedy.into(),
    }
}

pub(super) fn limitations(machine: &Machine) -> Vec<Limitation> {
    let is_of_several = machine.queries_at_once() > 1 && machine.leaf().is_none();
    let is_chain = machine.spatial().is_some() && machine.leaf().is_none();
    let rows = [
        (
            is_of_several,
            limitation(
                "A batch with fewer queries than the machine has engines waits for ever.",
                "Fill the batch with any query, and discard the result of that query.",
            ),
        ),
        (
            is_chain && !machine.has_memory(),
            limitation(
                "`group_ready` and `query_ready` depend on input pins in the same clock. AXI4-Stream allows such a path, AXI4 does not.",
                "Put a register in front of `group_last` and `group_valid`.",
            ),
        ),
        (
            machine.spatial().is_none(),
            limitation(
                "`group_ready` may rise only after `group_valid`.",
                "Do not wait for `group_ready` with `group_valid`.",
            ),
        ),
        (
            machine.keeps_sets(),
            limitation(
                format!(
                    "The group that fills a bank, number {}, ends the set without `group_last` too.",
                    machine.bank_groups().unwrap_or(0)
                ),
                "Split more photons into sets, send the query again with each set, and add the sums.",
            ),
        ),
        (
            machine.fixed_radius_sq().is_some(),
            limitation(
                "All queries have the search radius of the photon format.",
                "Where queries have radii of their own, take `stream` or a machine `leaf-D-radii`.",
            ),
        ),
        (
            true,
            limitation(
                format!(
                    "Inputs are not checked. With a word above its limit, or more than {} photons for a query, results are undefined.",
                    machine.max_photons()
                ),
                "Keep to the limits of the ports, and split the photons of a query that has more.",
            ),
        ),
        (
            true,
            limitation(
                "A word that is taken in a clock of reset is lost.",
                "Offer no word in a clock of reset.",
            ),
        ),
        (
            true,
            limitation(
                "The Quartus project was never run, because Quartus is not free.",
                "Read the reports of its first run. `scripts/quartus/check.sh` checks only that the files, modules and ports exist.",
            ),
        ),
    ];
    applying(rows)
}

impl Core {
    /// What a user of the core must design around.
    pub fn limitations(&self) -> Vec<Limitation> {
        applying([
            (
                true,
                limitation(
                    "A word for a busy chain holds back the words behind it on its stream, so two streams can wait for each other for ever.",
                    "Number the sets of each chain. Send all sets n before any set n + 1, and all queries on sets n before any query on a set \
                     n + 1. `crates/driver/src/schedule.rs` finds an order with fewer waits.",
                ),
            ),
            (
                true,
                limitation(
                    "A reset or a restart takes back a result that waits on `m_axis_results`, and forgets the queries under way.",
                    "Send the queries again.",
                ),
            ),
            (
                true,
                limitation(
                    "A word that moves in the first clock of `aresetn` = 0 is lost.",
                    "Offer no word in that clock.",
                ),
            ),
            (
                self.has_radii(),
                limitation(
                    "The registers of rounds must not change while a query is under way.",
                    "Read `under_way` until it is 0 before a write.",
                ),
            ),
            (
                self.has_radii(),
                limitation(
                    "All rounds of a batch gather from one set.",
                    "For the k nearest, put all leaves that a batch wants into one set.",
                ),
            ),
            (
                true,
                limitation(
                    "A simulator that reads the text as SystemVerilog may leave outputs unknown that depend on constants alone.",
                    "Read the text as Verilog-2001: give Icarus `-g2005`.",
                ),
            ),
            (
                true,
                limitation(
                    "Platform Designer has never read its component, because it is not free.",
                    "Check the interfaces of the component. `scripts/quartus/check.sh` runs it against stand-ins.",
                ),
            ),
        ])
    }
}

fn applying<const N: usize>(rows: [(bool, Limitation); N]) -> Vec<Limitation> {
    let rows = rows.into_iter().filter(|(applies, _)| *applies);
    rows.map(|(_, limitation)| limitation).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machines::{MACHINES, find_machine};

    fn says(machine: &str, part: &str) -> bool {
        let limitations = limitations(find_machine(machine).unwrap());
        limitations.iter().any(|row| row.says.contains(part))
    }

    #[test]
    fn a_machine_has_the_limitations_of_its_ports() {
        assert!(says("tile-6", "fewer queries") && !says("stream", "fewer queries"));
        assert!(
            says("stream", "depend on input pins") && !says("chip-lut", "depend on input pins")
        );
        assert!(says("paper", "only after `group_valid`") && !says("stream", "only after"));
        assert!(says("chip-lut", "number 1024, ends the set") && !says("tile-6", "ends the set"));
        assert!(says("tile-6", "search radius") && !says("stream", "search radius"));
        assert!(!says("leaf-5-local7-rgb6d-n64", "fewer queries"));
    }

    #[test]
    fn every_limitation_has_a_remedy_and_is_said_once() {
        let core = Core::new(find_machine("leaf-5-radii-local7-rgb6d-n64").unwrap(), 2).unwrap();
        let machines = MACHINES.iter().map(limitations);
        for rows in machines.chain([core.limitations()]) {
            for (index, row) in rows.iter().enumerate() {
                assert!(
                    row.says.ends_with('.') && row.remedy.ends_with('.'),
                    "{row:?}"
                );
                assert!(rows[..index].iter().all(|other| other.says != row.says));
            }
        }
    }
}
