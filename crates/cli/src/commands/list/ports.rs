//! The widths and the clocks of machines, as tables: those of docs/ports.md and of the datasheets.

use photoncube_spec::{Machine, Widths};

use crate::table::Table;

/// The bits of the ports of machines, and their channels.
pub fn widths<'a>(machines: impl Iterator<Item = &'a Machine>) -> Table {
    let header = "machine, query, radius_sq, photon, channels, power, exponent, sum, count";
    table_of_machines(header, machines, widths_of)
}

/// The clocks of machines, the queries and photons of a clock, and the most photons of a query.
pub fn clocks<'a>(machines: impl Iterator<Item = &'a Machine>) -> Table {
    let header = "machine, queries, lanes, a group, more, at least, latency, max photons";
    table_of_machines(header, machines, clocks_of)
}

/// A table with a row for each machine: its name and these numbers, `-` where there is none.
fn table_of_machines<'a>(
    header: &str,
    machines: impl Iterator<Item = &'a Machine>,
    row: impl Fn(&Machine) -> Vec<Option<f64>>,
) -> Table {
    let cell = |number: Option<f64>| number.map_or("-".to_owned(), |number| number.to_string());
    let cells = |machine: &Machine| {
        let name = [machine.name.to_owned()].into_iter();
        name.chain(row(machine).into_iter().map(cell)).collect()
    };
    let header: Vec<_> = header.split(", ").collect();
    Table::new(&header, machines.map(cells))
}

/// The widths of a machine's ports and the number of its channels; `None` where it has no such port.
fn widths_of(machine: &Machine) -> Vec<Option<f64>> {
    let of = Widths::of(machine);
    let radius_sq = machine.fixed_radius_sq().map_or(of.radius_sq, |_| 0);
    let channels = machine.channels().count();
    let all = [
        of.coordinate,
        radius_sq,
        of.photon,
        channels,
        of.mantissa,
        of.exponent,
        of.sum,
        of.count,
    ];
    all.map(|bits| (bits > 0).then_some(bits.into())).to_vec()
}

/// The clocks of a machine.
fn clocks_of(machine: &Machine) -> Vec<Option<f64>> {
    let spatial = machine.spatial();
    let group = machine.rate().interval();
    let overlapped = machine.overlap_program().map(|p| p.occupied_clocks(2));
    let two = overlapped.or(machine.microprogram().map(|p| p.occupied_clocks(2)));
    let more = two.map(|clocks| clocks as f64 - 2.0 * group);
    vec![
        Some(machine.queries_at_once() as f64),
        Some(machine.photons_per_iteration() as f64),
        Some(group),
        more.or(spatial.map(|spatial| spatial.batch_gap_clocks().into())),
        spatial.map(|spatial| spatial.least_batch_clocks().into()),
        spatial.map(|spatial| spatial.latency_clocks().into()),
        Some(machine.max_photons() as f64),
    ]
}
