//! The formats, limits and clocks of a machine, one fact a row.

use crate::formats::Numbers;
use crate::formats::Squarer;
use crate::machine::Machine;
use crate::spatial::Spatial;

/// One fact about a machine, as text for people.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fact {
    /// The name of the quantity.
    pub name: &'static str,
    /// The quantity's value with its unit.
    pub value: String,
}

pub(super) fn facts(machine: &Machine) -> Vec<Fact> {
    let rows = [
        ("cells", Some(machine.hypercube().nodes().to_string())),
        ("numbers", Some(numbers(machine))),
        (
            "power unit",
            Some(
                "the photon map's own: its largest power in any channel is the largest word"
                    .to_owned(),
            ),
        ),
        ("frame", Some(frame())),
        ("search radius", radius(machine)),
        (
            "most photons",
            Some(format!("{} a query", machine.max_photons())),
        ),
        ("squarers", Some(squarers(machine))),
        ("clocks", Some(clocks(machine))),
        ("latency", latency(machine)),
    ];
    let row = |(name, value): (_, Option<String>)| value.map(|value| Fact { name, value });
    rows.into_iter().filter_map(row).collect()
}

fn numbers(machine: &Machine) -> String {
    match &machine.numbers {
        Numbers::Plain(format) => format!(
            "plain: {}-bit coordinates, {}-bit powers",
            format.coordinate_bits, format.power_bits
        ),
        Numbers::Local(format) => format!(
            "photon format {}, {} bits a stored photon",
            format.name(),
            machine.bits_per_photon()
        ),
    }
}

/// Where the host must put the frame. The machine looks at differences of coordinates only, so it cannot notice a wrong place.
fn frame() -> String {
    let blocks = Numbers::FRAME_BLOCKS;
    format!(
        "{blocks} x {blocks} x {blocks} blocks; a block's edge is at least the search radius; a query has its place in the inner 2 x 2 x 2 \
         blocks, so that all photons in range are in the frame"
    )
}

/// The fixed search radius of a machine that has no pin for it.
fn radius(machine: &Machine) -> Option<String> {
    let radius_sq = machine.fixed_radius_sq()?;
    let format = machine.format()?;
    let distance = match format.half_steps() {
        false => "d^2",
        true => "the sum of m (m + 1)",
    };
    Some(format!(
        "fixed, {} of a block edge's {} steps: in range where {distance} <= {radius_sq}",
        format.radius_steps(),
        format.edge_steps()
    ))
}

fn squarers(machine: &Machine) -> String {
    let Some(spatial) = machine.spatial() else {
        return machine.squarer.name().to_owned();
    };
    let kinds = [Squarer::Digits, Squarer::Product, Squarer::Table];
    let engines = spatial.engines();
    let of = |squarer| {
        let same = |&engine: &usize| spatial.kind(machine.squarer, engine).squarer == squarer;
        (squarer, (0..engines).filter(same).count())
    };
    let found: Vec<_> = kinds.map(of).into_iter().filter(|(_, n)| *n > 0).collect();
    match found.as_slice() {
        [(squarer, _)] => squarer.name().to_owned(),
        several => {
            let parts = several.iter().map(|(s, n)| format!("{} in {n}", s.name()));
            format!(
                "{} of {engines} engines",
                parts.collect::<Vec<_>>().join(", ")
            )
        }
    }
}

fn clocks(machine: &Machine) -> String {
    let lanes = machine.photons_per_iteration();
    match (
        machine.spatial(),
        machine.overlap_program(),
        machine.microprogram(),
    ) {
        (Some(spatial), ..) => spatial_clocks(spatial),
        (_, Some(program), _) => format!(
            "{} for {} groups of {lanes} photons; {} for a query of 1 group, {} for one of 100",
            program.interval,
            program.groups,
            program.occupied_clocks(1),
            program.occupied_clocks(100)
        ),
        (.., Some(program)) => format!(
            "{} for a group of {lanes} photons, and {} more a query",
            program.initiation_interval(),
            program.occupied_clocks(0),
        ),
        _ => String::new(),
    }
}

fn spatial_clocks(spatial: &Spatial) -> String {
    let group = format!("1 for a group of {} photons", Spatial::LANES);
    let (gap, least) = (spatial.batch_gap_clocks(), spatial.least_batch_clocks());
    match (spatial.engines(), gap) {
        (1, 0) => format!("{group}; a change of query costs none"),
        (_, 0) => format!("{group}; at least {least} a batch"),
        _ => format!("{group} and {gap} more a batch; at least {least} a batch"),
    }
}

fn latency(machine: &Machine) -> Option<String> {
    let spatial = machine.spatial()?;
    let first = format!("{} clocks from", spatial.latency_clocks());
    Some(match spatial.engines() {
        1 => format!("{first} a query's last group to its result"),
        _ => format!(
            "{first} a batch's last group to its first result, {} more to each further one",
            Spatial::RESULT_CLOCKS
        ),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machines::find_machine;

    fn fact(machine: &str, name: &str) -> Option<String> {
        let facts = facts(find_machine(machine).unwrap());
        let fact = facts.into_iter().find(|fact| fact.name == name);
        fact.map(|fact| fact.value)
    }

    #[test]
    fn mixed_machines_name_each_kind_of_squarer() {
        let squarers = |machine| fact(machine, "squarers").unwrap();
        assert_eq!(squarers("paper-dsp"), "product");
        assert_eq!(squarers("tile-10"), "digits");
        assert_eq!(
            squarers("chip-mixed"),
            "digits in 30, product in 10, table in 24 of 64 engines"
        );
    }

    #[test]
    fn only_a_fixed_radius_is_a_fact() {
        assert_eq!(fact("stream", "search radius"), None);
        assert_eq!(
            fact("tile-6", "search radius").unwrap(),
            "fixed, 126 of a block edge's 128 steps: in range where d^2 <= 15876"
        );
    }

    #[test]
    fn clocks_are_those_of_the_programs() {
        let clocks = |machine| fact(machine, "clocks").unwrap();
        assert_eq!(
            clocks("paper"),
            "9 for a group of 4 photons, and 2 more a query"
        );
        assert_eq!(
            clocks("tile-6-mixed"),
            "1 for a group of 4 photons and 3 more a batch; at least 10 a batch"
        );
        assert!(clocks("overlap").starts_with("3 for 2 groups of 4 photons; "));
    }
}
