//! The method `exhaustive`: every pair of inputs of every unit, every difference with every radius.

use anyhow::Result;
use clap::Args;
use photoncube_hdl::{Unit, has_unit};
use photoncube_testbench::{
    Controls, DeviceKind, LaneVerdict, Radii, Tool, UnitVerdict, exhaustive_controls,
    exhaustive_lane, exhaustive_unit,
};
use serde::Serialize;

use super::method::Method;
use super::options::{Devices, devices, devices_where, tools};
use super::outcome::{Outcome, equal};
use crate::progress;
use crate::table::grouped;
use crate::verified::Line;

/// See [`Method::ABOUT`].
#[derive(Args, Debug)]
pub struct Exhaustive {
    /// What to compare the golden model with: rust-hdl, text, icarus, verilator, netlist; comma-separated, or all; fastest is
    /// text for units, and verilator for lanes, or text where that is missing
    #[arg(
        long,
        value_name = "LIST",
        value_delimiter = ',',
        default_value = "fastest"
    )]
    against: Vec<Devices>,
}

/// The columns of the tables.
const UNIT_COLUMNS: &str = "part operand_bits pairs_compared vectors_compared mismatches device";
const LANE_COLUMNS: &str = "machine scope operand_bits pairs_compared vectors_compared device";

/// The comparisons of units and lanes.
#[derive(Debug, Default, Serialize)]
struct Comparisons {
    parts: Vec<UnitVerdict>,
    lanes: Vec<LaneVerdict>,
    vectors_compared: u64,
    mismatches: u64,
}

impl Method for Exhaustive {
    const NAME: &'static str = "exhaustive";
    const ABOUT: &'static str = "Compare every pair of inputs of every unit at 6 and at 8 bits, and every difference with \
        every radius at 8 bits through the lanes of a machine";
    const EXAMPLES: &'static [&'static str] = &["photoncube verify exhaustive"];

    fn tools(&self) -> Vec<Tool> {
        tools(&self.against)
    }

    fn run(&self) -> Result<Outcome> {
        let controls = Controls::gathered(exhaustive_controls()?)?;
        let mut all = Comparisons::default();
        // Most of a short run is the building of a simulation, and there are many units.
        for kind in devices_where(&self.against, DeviceKind::Text) {
            units(kind, &mut all)?;
        }
        for kind in devices(&self.against) {
            lanes(kind, &mut all)?;
        }
        let lines = all.parts.iter().map(unit_line);
        let lines = lines.chain(all.lanes.iter().map(lane_line));
        Ok(Outcome::new::<Self>(controls, &all)?
            .rows("parts", UNIT_COLUMNS)
            .rows("lanes", LANE_COLUMNS)
            .lines(lines.collect::<Result<Vec<_>>>()?)
            .findings(all.parts.iter().filter_map(finding)))
    }
}

fn units(kind: DeviceKind, all: &mut Comparisons) -> Result<()> {
    let units = Unit::ALL
        .into_iter()
        .flat_map(|unit| Unit::BITS.map(|bits| (unit, bits)));
    let built: Vec<_> = units.filter(|&(unit, bits)| has_unit(unit, bits)).collect();
    let bar = progress::bar("units", built.len() as u64);
    for (unit, bits) in built {
        let found = exhaustive_unit(unit, bits, kind)?;
        all.vectors_compared += found.vectors_compared;
        all.mismatches += found.mismatches;
        all.parts.push(found);
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(())
}

fn lanes(kind: DeviceKind, all: &mut Comparisons) -> Result<()> {
    for radii in Radii::ALL {
        let bar = progress::bar("lanes", 1000);
        let position = |done: f64| bar.set_position((done * 1000.0) as u64);
        let found = equal(exhaustive_lane(kind, radii, &position))?;
        bar.finish_and_clear();
        all.vectors_compared += found.vectors_compared;
        all.lanes.push(found);
    }
    Ok(())
}

/// The finding of a unit that has a mismatch.
fn finding(unit: &UnitVerdict) -> Option<String> {
    (unit.mismatches > 0).then(|| {
        format!(
            "{} of {} bits in {}: {} mismatches in {} pairs; the first: {}",
            unit.unit,
            unit.operand_bits,
            unit.device,
            unit.mismatches,
            unit.pairs_compared,
            unit.first_mismatch.as_deref().unwrap_or("none")
        )
    })
}

fn command(device: &str) -> String {
    format!("photoncube verify exhaustive --against {device}")
}

fn unit_line(unit: &UnitVerdict) -> Result<Line> {
    Ok(Line {
        by: format!("{}: {}", unit.device, unit.tool_version),
        volume: unit.pairs_compared,
        unit: "pairs of inputs, all".to_owned(),
        result: format!(
            "{} mismatches in {} vectors",
            unit.mismatches,
            grouped(unit.vectors_compared)
        ),
        command: command(&unit.device),
        ..Line::of_unit(unit.unit, unit.operand_bits)?
    })
}

fn lane_line(lane: &LaneVerdict) -> Result<Line> {
    Ok(Line {
        aspect: lane.scope.to_owned(),
        by: format!("{}: {}", lane.device, lane.tool_version),
        volume: lane.pairs_compared,
        unit: format!("pairs of {}-bit difference and radius", lane.operand_bits),
        result: format!(
            "equal in {} vectors of {} signals",
            grouped(lane.vectors_compared),
            lane.signals_per_vector
        ),
        command: command(&lane.device),
        ..Line::of_machine(lane.machine)?
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mismatch_is_a_finding() {
        let sound = UnitVerdict {
            unit: "add",
            operand_bits: 6,
            device: "text".into(),
            tool_version: "1".into(),
            pairs_compared: 4096,
            vectors_compared: 4096,
            mismatches: 0,
            first_mismatch: None,
        };
        assert_eq!(finding(&sound), None);
        let wrong = UnitVerdict {
            mismatches: 1,
            first_mismatch: Some("a=1 b=2".into()),
            ..sound
        };
        let told = finding(&wrong).unwrap();
        assert!(
            told.contains("add of 6 bits") && told.contains("a=1 b=2"),
            "{told}"
        );
    }
}
