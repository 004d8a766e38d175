//! Compares every difference with every radius, in the lanes of the machine whose radius has 8 bits.

use photoncube_hdl::{Level, emit};
use photoncube_spec::{Machine, Photon, PhotonFormat, Query, Widths, find_machine};
use serde::Serialize;

use crate::device::{Device, DeviceError, DeviceKind, RustHdl, hdl_error};
use crate::stimulus::Source;
use crate::verify::{VerifyError, VerifyOptions, nothing_compared, verify_device};

/// The machine. Each of its queries has its own radius, and a lane squares 8 bits.
const MACHINE: &str = "stream";
/// Bits of a difference and of a radius.
const BITS: u32 = 8;
/// The directions from query to photon: two on each of three axes.
const DIRECTIONS: u64 = 6;
/// The number of queries of a run, whose photons are in memory at once.
const QUERIES: usize = 4096;

/// The radii that the lanes are tested with.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Radii {
    /// The square of each radius, one less and one more, with every lane, axis and direction.
    Squares,
    /// Every `radius_sq` that a query may have. Each difference is in one of the lanes; axes and directions
    /// take turns.
    All,
}

impl Radii {
    /// Both sets of radii.
    pub const ALL: [Self; 2] = [Self::Squares, Self::All];

    fn words(self) -> &'static str {
        match self {
            Self::Squares => {
                "radius_sq of each radius squared, less 1, plus 1; in each lane, on each axis, to either side"
            }
            Self::All => "every radius_sq; in one lane each, axes and sides in turn",
        }
    }

    fn values(self, machine: &Machine) -> Vec<u32> {
        match self {
            Self::Squares => radii(machine),
            Self::All => (0..=largest(machine)).collect(),
        }
    }

    /// The queries of a run, with the direction of their photons.
    fn runs(self, radii: &[u32]) -> Vec<(&[u32], u64)> {
        match self {
            Self::Squares => (0..DIRECTIONS)
                .map(|direction| (radii, direction))
                .collect(),
            Self::All => radii.chunks(QUERIES).zip((0..DIRECTIONS).cycle()).collect(),
        }
    }

    /// How often each difference occurs, each time in another lane.
    fn turns(self, machine: &Machine) -> u32 {
        match self {
            Self::Squares => machine.photons_per_iteration() as u32,
            Self::All => 1,
        }
    }
}

/// A record of the comparison of the lanes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct LaneVerdict {
    /// The name of the machine.
    pub machine: &'static str,
    /// The name of the device.
    pub device: String,
    /// The tool behind the device, with its version.
    pub tool_version: String,
    /// Bits of a difference, and of a radius.
    pub operand_bits: u32,
    /// The number of values of `radius_sq`.
    pub radii: u64,
    /// A description of the radii, lanes and directions.
    pub scope: &'static str,
    /// The number of different pairs of a difference and a `radius_sq`.
    pub pairs_compared: u64,
    /// The number of photon tests that compared these pairs.
    pub photon_tests: u64,
    /// The number of clocks. Every visible signal was compared in each.
    pub vectors_compared: u64,
    /// The number of signals in a vector.
    pub signals_per_vector: usize,
}

/// Compares the lanes of a machine in a device. Calls `progress` with the fraction that is done.
///
/// # Errors
/// The first difference; or the device or the stimulus fails.
pub fn exhaustive_lane(
    kind: DeviceKind,
    radii: Radii,
    progress: &dyn Fn(f64),
) -> Result<LaneVerdict, VerifyError> {
    let machine = find_machine(MACHINE).expect("a named machine");
    if let Some(missing) = kind.missing_tool() {
        return Err(DeviceError::from(missing).into());
    }
    let design = emit(machine, Level::Machine).map_err(hdl_error(machine))?;
    let mut open = || match kind {
        DeviceKind::RustHdl => Ok(Box::new(RustHdl::new(machine, Level::Machine)?) as Box<_>),
        _ => kind.open_text(&design),
    };
    exhaustive_lane_device(&mut open, radii, progress)
}

/// Compares the lanes in devices that `open` opens, one for each run.
///
/// # Errors
/// The first difference; or the device or the stimulus fails.
pub fn exhaustive_lane_device(
    open: &mut dyn FnMut() -> Result<Box<dyn Device>, DeviceError>,
    radii: Radii,
    progress: &dyn Fn(f64),
) -> Result<LaneVerdict, VerifyError> {
    let machine = find_machine(MACHINE).expect("a named machine");
    let values = radii.values(machine);
    let runs = radii.runs(&values);
    let mut verdict: Option<LaneVerdict> = None;
    for (run, &(some, direction)) in runs.iter().enumerate() {
        let queries = queries(machine, some, direction, radii.turns(machine));
        let found = compare_run(machine, &queries, open()?.as_mut())?;
        match &mut verdict {
            None => {
                verdict = Some(LaneVerdict {
                    radii: values.len() as u64,
                    scope: radii.words(),
                    pairs_compared: (values.len() << BITS) as u64,
                    ..found
                });
            }
            Some(all) => {
                all.vectors_compared += found.vectors_compared;
                all.photon_tests += found.photon_tests;
            }
        }
        progress((run + 1) as f64 / runs.len() as f64);
    }
    verdict.ok_or_else(|| nothing_compared(MACHINE, 0, 0, 0))
}

/// Compares queries with all their photons. The caller knows which pairs of difference and radius these are.
fn compare_run(
    machine: &Machine,
    queries: &[(Query, Vec<Photon>)],
    device: &mut dyn Device,
) -> Result<LaneVerdict, VerifyError> {
    let tests: usize = queries.iter().map(|(_, photons)| photons.len()).sum();
    let options = VerifyOptions {
        iterations: u64::MAX,
        seed: 0,
        source: Source::Workload {
            queries,
            repeat: "photoncube verify exhaustive",
        },
    };
    let verdict = verify_device(machine, device, &options, &|_| ())?;
    let groups = (tests / machine.photons_per_iteration()) as u64;
    if (verdict.iterations, verdict.results_compared) != (groups, queries.len() as u64) {
        let (iterations, results) = (verdict.iterations, verdict.results_compared);
        return Err(nothing_compared(device.name(), iterations, results, 0));
    }
    Ok(LaneVerdict {
        machine: machine.name,
        device: verdict.device,
        tool_version: verdict.tool_version,
        operand_bits: BITS,
        radii: 0,
        scope: "",
        pairs_compared: 0,
        photon_tests: tests as u64,
        vectors_compared: verdict.vectors_compared,
        signals_per_vector: verdict.signals_per_vector,
    })
}

/// The largest `radius_sq` that a query may have.
fn largest(machine: &Machine) -> u32 {
    machine.format().map_or(0, PhotonFormat::largest_in_range)
}

/// The squares of all radii with their neighbours. Between two of these values no difference changes its
/// decision.
fn radii(machine: &Machine) -> Vec<u32> {
    let around = |r: u32| [(r * r).saturating_sub(1), r * r, r * r + 1];
    let mut radii: Vec<_> = (0..1 << BITS).flat_map(around).collect();
    radii.retain(|&radius_sq| radius_sq <= largest(machine));
    radii.sort_unstable();
    radii.dedup();
    radii
}

/// A query for each radius in the middle of the frame, with photons at every difference on one axis and in
/// one direction. The list repeats, each time with the photons in other lanes.
fn queries(
    machine: &Machine,
    radii: &[u32],
    direction: u64,
    turns: u32,
) -> Vec<(Query, Vec<Photon>)> {
    let (axis, above) = ((direction / 2) as usize, direction.is_multiple_of(2));
    let middle = 1 << (Widths::of(machine).coordinate - 1);
    let lanes = machine.photons_per_iteration() as u32;
    let full = (1 << Widths::of(machine).mantissa) - 1;
    let photon = |difference: u32| {
        let mut position = [middle; 3];
        position[axis] = match above {
            true => middle + difference,
            false => middle - difference,
        };
        Photon {
            position,
            // Each difference has its own power, so that a wrong photon cannot replace the right one.
            power: [difference & full, full - (difference & full), full],
            exponent: 0,
        }
    };
    // In each turn the differences of a group are rotated over the lanes.
    let turned = |turn: u32| {
        let place = move |index: u32| index - index % lanes + (index + turn) % lanes;
        (0..1_u32 << BITS).map(move |index| photon(place(index)))
    };
    let photons: Vec<_> = (0..turns).flat_map(turned).collect();
    let query = |&radius_sq| Query {
        position: [middle; 3],
        radius_sq,
    };
    let with_photons = |radius_sq| (query(radius_sq), photons.clone());
    radii.iter().map(with_photons).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_lane_gets_every_difference_with_every_radius() {
        let machine = find_machine(MACHINE).unwrap();
        assert_eq!(machine.format().unwrap().radius_bits(), BITS);
        let radii = radii(machine);
        for r in 0..(1 << BITS) - 1 {
            assert!(radii.contains(&(r * r)), "{r}");
        }
        for direction in 0..DIRECTIONS {
            let queries = queries(machine, &radii, direction, Radii::Squares.turns(machine));
            let asked: BTreeSet<_> = queries.iter().map(|(q, _)| q.radius_sq).collect();
            assert_eq!(asked.len(), radii.len());
            let (query, photons) = &queries[0];
            for lane in 0..4 {
                let of_lane = photons.iter().skip(lane).step_by(4);
                assert_eq!(differences(query, of_lane, direction).len(), 1 << BITS);
            }
        }
    }

    #[test]
    fn every_radius_meets_every_difference() {
        let machine = find_machine(MACHINE).unwrap();
        let values = Radii::All.values(machine);
        let runs = Radii::All.runs(&values);
        let met: BTreeSet<_> = runs.iter().flat_map(|(some, _)| *some).collect();
        assert_eq!(met.len(), largest(machine) as usize + 1);
        // A clamped difference is all ones, and is always out of range.
        assert_eq!(largest(machine), 254 * 254);
        for direction in 0..DIRECTIONS {
            let queries = queries(machine, &values[..1], direction, 1);
            let (query, photons) = &queries[0];
            assert_eq!(
                differences(query, photons.iter(), direction).len(),
                1 << BITS
            );
        }
    }

    fn differences<'p>(
        query: &Query,
        photons: impl Iterator<Item = &'p Photon>,
        direction: u64,
    ) -> BTreeSet<u32> {
        let axis = (direction / 2) as usize;
        photons
            .map(|p| p.position[axis].abs_diff(query.position[axis]))
            .collect()
    }
}
