//! The clock of a machine over several seeds of placement.

use fpga_flow::{CriticalPath, Flow, Placer, Router};
use serde::Serialize;

use super::figures::PlaceRow;

/// The clock of a machine in a speed grade.
#[derive(Clone, Debug, Serialize)]
pub struct Clock {
    /// The machine's name.
    pub machine: String,
    /// The flow that mapped the machine.
    pub flow: &'static Flow,
    /// The speed grade of the device; `None` where it has only one.
    pub speed_grade: Option<u32>,
    /// The placer of the machine.
    pub placer: Placer,
    /// The router of the machine.
    pub router: Router,
    /// The number of seeds of placement.
    pub seeds: usize,
    /// The median over the seeds, in MHz.
    pub fmax_mhz: f64,
    /// The clock of the worst seed, in MHz.
    pub fmax_mhz_low: f64,
    /// The clock of the best seed, in MHz.
    pub fmax_mhz_high: f64,
    /// The critical path of the seed that is nearest to the median, of those whose path was read.
    pub path: Option<CriticalPath>,
}

impl Clock {
    /// The speed grade as text.
    pub fn grade(&self) -> String {
        let grade = self.speed_grade.map(|grade| grade.to_string());
        grade.unwrap_or_else(|| "only one".to_owned())
    }
}

/// The clocks: one for each machine and speed grade, in the order of the rows.
pub fn clocks(rows: &[PlaceRow]) -> Vec<Clock> {
    let mut keys: Vec<(&str, Option<u32>)> = Vec::new();
    for row in rows {
        let key = (row.machine.as_str(), row.speed_grade);
        if !keys.contains(&key) {
            keys.push(key);
        }
    }
    let clock = |(machine, grade)| {
        let rows = rows.iter();
        let rows: Vec<_> = rows
            .filter(|row| row.machine == machine && row.speed_grade == grade)
            .collect();
        clock(&rows)
    };
    keys.into_iter().filter_map(clock).collect()
}

/// The clock of the rows of one machine and grade.
fn clock(rows: &[&PlaceRow]) -> Option<Clock> {
    let first = rows.first()?;
    let mhz: Vec<_> = rows.iter().map(|row| row.fmax_mhz).collect();
    let fmax_mhz = median(mhz.clone())?;
    let off = |row: &&&PlaceRow| (row.fmax_mhz - fmax_mhz).abs();
    let with_path = rows.iter().filter(|row| row.path.is_some());
    let typical = with_path.min_by(|a, b| off(a).total_cmp(&off(b)));
    Some(Clock {
        machine: first.machine.clone(),
        flow: first.flow,
        speed_grade: first.speed_grade,
        placer: first.placer,
        router: first.router,
        seeds: rows.len(),
        fmax_mhz,
        fmax_mhz_low: mhz.iter().copied().fold(f64::INFINITY, f64::min),
        fmax_mhz_high: mhz.iter().copied().fold(0.0, f64::max),
        path: typical.and_then(|row| row.path.clone()),
    })
}

/// The median; for an even number of values, the mean of the two in the middle; `None` for no values.
fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    let (&low, &high) = (
        values.get(values.len().checked_sub(1)? / 2)?,
        values.get(values.len() / 2)?,
    );
    Some(f64::midpoint(low, high))
}

#[cfg(test)]
mod tests {
    use fpga_flow::Binding;

    use super::*;

    fn row(machine: &str, speed_grade: u32, seed: u32, fmax_mhz: f64) -> PlaceRow {
        PlaceRow {
            machine: machine.to_owned(),
            flow: Flow::find("ecp5-nodsp").unwrap(),
            speed_grade: Some(speed_grade),
            seed,
            placer: Placer::default(),
            router: Router::default(),
            fmax_mhz,
            netlist_sha256: "00".to_owned(),
            path: None,
            endpoints: None,
        }
    }

    fn path(from: &str) -> Option<CriticalPath> {
        Some(CriticalPath {
            from: from.to_owned(),
            to: "to".to_owned(),
            logic_ns: 1.0,
            routing_ns: 2.0,
            longest_net_ns: 1.5,
            carry_chains: 1,
            carry_cells: 4,
            lut_levels: 2,
            dsp_levels: 0,
            binds: Binding::CarryChains,
        })
    }

    #[test]
    fn the_clock_is_the_median_over_the_seeds_of_that_machine_and_grade() {
        let mut rows = [
            row("one", 6, 1, 90.5),
            row("one", 6, 2, 70.25),
            row("one", 6, 3, 80.0),
            row("one", 8, 1, 100.0),
            row("two", 6, 1, 50.0),
        ];
        rows[0].path = path("far");
        rows[1].path = path("near");
        let clocks = clocks(&rows);
        assert_eq!(clocks.len(), 3);
        let first = &clocks[0];
        assert_eq!((first.seeds, first.fmax_mhz), (3, 80.0));
        assert_eq!((first.fmax_mhz_low, first.fmax_mhz_high), (70.25, 90.5));
        assert_eq!(first.path.as_ref().unwrap().from, "near");
        assert_eq!(
            (clocks[1].speed_grade, clocks[1].fmax_mhz),
            (Some(8), 100.0)
        );
        assert_eq!(clocks[2].path, None);
    }

    #[test]
    fn the_median_is_in_the_middle() {
        assert_eq!(median(vec![]), None);
        assert_eq!(median(vec![3.0]), Some(3.0));
        assert_eq!(median(vec![4.0, 1.0]), Some(2.5));
        assert_eq!(median(vec![9.0, 1.0, 2.0]), Some(2.0));
    }
}
