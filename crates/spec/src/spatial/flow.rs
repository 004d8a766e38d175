//! The listing of a spatial machine, which has no program: the steps of a group through an engine, clock by
//! clock.

use super::cuts::Cut;
use super::{EngineKind, Radius, Spatial};
use crate::formats::Squarer;

/// A step of a group through an engine, with or without a pipeline register.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FlowRow {
    /// The clock at whose end the step's value is in its register, counted from the clock in which the group
    /// arrives. A step without a register has the clock of the next register.
    pub clock: u32,
    /// The roles of the cells that do the step.
    pub cells: &'static str,
    /// The engine's units that the step uses, and how many of each.
    pub units: &'static str,
    /// A description of the step.
    pub step: &'static str,
    /// Whether a pipeline register holds the step's value.
    pub registered: bool,
}

/// The units of an engine. All of them work in every clock.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct EngineUnits {
    /// `(A-B)^2`: one for each coordinate of each photon.
    pub squares: usize,
    /// `A+B` of distances: two for each photon.
    pub distance_adds: usize,
    /// `if A>B, output 0`: one for each photon and word that is summed.
    pub gates: usize,
    /// `A+B` of powers and counts: a tree over the group, and the sum.
    pub power_adds: usize,
}

impl EngineUnits {
    /// Counts the units of an engine for that number of channels. Three channels need 24 adds. On 16 adders,
    /// one in each cell, these would take 1.5 clocks, so Y and D cells have two adders.
    pub fn of(channels: usize) -> Self {
        let words = channels + 1;
        Self {
            squares: 3 * Spatial::LANES,
            distance_adds: 2 * Spatial::LANES,
            gates: words * Spatial::LANES,
            power_adds: words * Spatial::LANES,
        }
    }

    /// All adds of a group: distances, powers and counts.
    pub fn adds(&self) -> usize {
        self.distance_adds + self.power_adds
    }
}

/// The cells, the units and the description of the value at a pipeline place.
fn step(cut: Cut) -> (&'static str, &'static str, &'static str) {
    match cut {
        Cut::Difference => ("X Y Z", "square", "d = query - photon"),
        Cut::Magnitude => ("X Y Z", "square", "the magnitude of d"),
        Cut::Products => ("X Y Z", "square", "products of the magnitude's digits"),
        Cut::Cross => (
            "X Y Z",
            "square",
            "the product of the two digits; from a table, d^2",
        ),
        Cut::Square => ("X Y Z", "square", "d^2"),
        Cut::SquareDelay => ("X Y Z", "", "d^2, on its way to the sum"),
        Cut::Pair => ("Y", "add", "x^2 + y^2, across z"),
        Cut::Distance => ("D", "add", "x^2 + y^2 + z^2, across w and z"),
        Cut::Range => ("D", "gate", "distance <= radius_sq"),
        Cut::RangeDelay => ("D", "", "the decision, on its way to the sums"),
        Cut::Decision => ("X Y Z D", "", "whether it is in range, beside each sum"),
        Cut::Gate => ("X Y Z D", "gate", "the power, or 0 out of range"),
        Cut::PairPower => ("X Y Z D", "gate, add", "the sum of two photons, across x"),
        Cut::GroupPower => ("X Y Z D", "add", "the sum of four, across y"),
    }
}

impl Spatial {
    /// Lists the steps of a group through an engine whose squarers are the machine's own kind, `own`.
    pub fn flow(&self, own: Squarer) -> Vec<FlowRow> {
        let kind = EngineKind {
            squarer: own,
            cuts: self.cuts,
        };
        let mut clock = 0;
        let mut rows = vec![row(0, "X Y Z", "", "the photons' coordinates arrive", true)];
        for cut in Cut::ALL {
            let registered = self.cuts.has(cut);
            if cut == Cut::RangeDelay {
                let wait = "the decision waits for engines with slower squarers";
                for _ in 0..self.range_waits(kind) {
                    clock += 1;
                    rows.push(row(clock, "D", "", wait, true));
                }
            }
            // At these places there is nothing to list without a register.
            if [Cut::SquareDelay, Cut::RangeDelay, Cut::Decision].contains(&cut) && !registered {
                continue;
            }
            if cut == Cut::Gate {
                let arrive = "the photons' powers arrive, with them whether each is in range";
                rows.push(row(clock, "X Y Z D", "", arrive, true));
            }
            let (cells, units, step) = step(cut);
            rows.push(row(clock + 1, cells, units, step, registered));
            clock += u32::from(registered);
        }
        rows.push(row(clock + 1, "X Y Z D", "add", "the query's sums", true));
        rows
    }

    /// A short text that states the source of the search radius.
    pub fn radius_name(&self) -> &'static str {
        match self.radius {
            Radius::Query => "of each query",
            Radius::Format => "the format's",
        }
    }
}

fn row(
    clock: u32,
    cells: &'static str,
    units: &'static str,
    step: &'static str,
    registered: bool,
) -> FlowRow {
    FlowRow {
        clock,
        cells,
        units,
        step,
        registered,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machines::MACHINES;

    #[test]
    fn the_sums_come_when_the_latencies_say() {
        for machine in MACHINES {
            let Some(spatial) = machine.spatial() else {
                continue;
            };
            let flow = spatial.flow(machine.squarer);
            let sums = flow.last().unwrap();
            let latency = spatial.latency() + spatial.cuts.power_latency();
            assert_eq!(sums.clock, latency);
            assert!(flow.windows(2).all(|pair| pair[0].clock <= pair[1].clock));
        }
    }

    #[test]
    fn an_engine_has_24_adds_a_group() {
        assert_eq!(EngineUnits::of(3).adds(), 24);
    }
}
