//! The method `--exhaustive`: every pair of inputs of every unit, every difference with every radius.

use anyhow::{Result, bail};
use photoncube_hdl::{Unit, has_unit};
use photoncube_testbench::{
    DeviceKind, LaneVerdict, Radii, UnitVerdict, VerifyError, exhaustive_lane, exhaustive_unit,
};
use serde::Serialize;

use super::equivalence::devices;
use crate::args::VerifyArgs;
use crate::failure::CheckFailed;
use crate::verified::{Line, grouped, record};
use crate::{output, progress, table};

/// The comparisons of units and lanes.
#[derive(Debug, Default, Serialize)]
struct Report {
    parts: Vec<UnitVerdict>,
    lanes: Vec<LaneVerdict>,
    vectors_compared: u64,
    mismatches: u64,
}

/// Compares all units and the lanes in each device.
pub fn execute(args: &VerifyArgs, json: bool) -> Result<()> {
    let mut report = Report::default();
    for kind in devices(args, &[DeviceKind::fastest()])? {
        units(kind, &mut report)?;
        lanes(kind, &mut report)?;
    }
    output::print(json, &report, || text(&report))?;
    verdict(&report)?;
    match &args.record {
        Some(path) => record(path, &lines(&report)?),
        None => Ok(()),
    }
}

fn units(kind: DeviceKind, report: &mut Report) -> Result<()> {
    let all = Unit::ALL
        .into_iter()
        .flat_map(|unit| Unit::BITS.map(|bits| (unit, bits)));
    let built: Vec<_> = all.filter(|&(unit, bits)| has_unit(unit, bits)).collect();
    let bar = progress::bar("units", built.len() as u64);
    for (unit, bits) in built {
        let found = exhaustive_unit(unit, bits, kind)?;
        report.vectors_compared += found.vectors_compared;
        report.mismatches += found.mismatches;
        report.parts.push(found);
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(())
}

fn lanes(kind: DeviceKind, report: &mut Report) -> Result<()> {
    for radii in Radii::ALL {
        let bar = progress::bar("lanes", 1000);
        let position = |done: f64| bar.set_position((done * 1000.0) as u64);
        let found = match exhaustive_lane(kind, radii, &position) {
            Ok(found) => found,
            Err(VerifyError::Diverged(divergence)) => bail!(CheckFailed(divergence.to_string())),
            Err(error) => return Err(error.into()),
        };
        bar.finish_and_clear();
        report.vectors_compared += found.vectors_compared;
        report.lanes.push(found);
    }
    Ok(())
}

/// Fails on a mismatch, and where nothing was compared.
fn verdict(report: &Report) -> Result<()> {
    let wrong = |unit: &&UnitVerdict| unit.mismatches > 0 || unit.pairs_compared == 0;
    let account = |unit: &UnitVerdict| {
        format!(
            "{} of {} bits in {}: {} mismatches in {} pairs; the first: {}",
            unit.unit,
            unit.operand_bits,
            unit.device,
            unit.mismatches,
            unit.pairs_compared,
            unit.first_mismatch.as_deref().unwrap_or("none")
        )
    };
    let wrong: Vec<_> = report.parts.iter().filter(wrong).map(account).collect();
    if !wrong.is_empty() {
        return Err(CheckFailed(wrong.join("\n")).into());
    }
    if report.parts.is_empty() || report.lanes.iter().all(|lane| lane.pairs_compared == 0) {
        return Err(CheckFailed("nothing was compared".to_owned()).into());
    }
    Ok(())
}

fn lines(report: &Report) -> Result<Vec<Line>> {
    let command = |device: &str| format!("photoncube verify --exhaustive --against {device}");
    let unit = |unit: &UnitVerdict| -> Result<Line> {
        Ok(Line {
            method: "exhaustive".to_owned(),
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
    };
    let lane = |lane: &LaneVerdict| -> Result<Line> {
        Ok(Line {
            method: format!("exhaustive: {}", lane.scope),
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
    };
    let units = report.parts.iter().map(unit);
    units.chain(report.lanes.iter().map(lane)).collect()
}

fn text(report: &Report) -> String {
    let header = ["unit", "bits", "pairs", "vectors", "mismatches", "device"];
    let unit = |unit: &UnitVerdict| {
        vec![
            unit.unit.to_owned(),
            unit.operand_bits.to_string(),
            grouped(unit.pairs_compared),
            grouped(unit.vectors_compared),
            unit.mismatches.to_string(),
            unit.device.clone(),
        ]
    };
    let lane = |lane: &LaneVerdict| {
        vec![
            format!("{}: difference and {}", lane.machine, lane.scope),
            lane.operand_bits.to_string(),
            grouped(lane.pairs_compared),
            grouped(lane.vectors_compared),
            // The first mismatch ends the comparison with an error.
            "none".to_owned(),
            lane.device.clone(),
        ]
    };
    let units = report.parts.iter().map(unit);
    let rows: Vec<_> = units.chain(report.lanes.iter().map(lane)).collect();
    table::markdown(&header, &rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit() -> UnitVerdict {
        UnitVerdict {
            unit: "add",
            operand_bits: 6,
            device: "text".into(),
            tool_version: "1".into(),
            pairs_compared: 4096,
            vectors_compared: 4096,
            mismatches: 0,
            first_mismatch: None,
        }
    }

    fn lane() -> LaneVerdict {
        LaneVerdict {
            machine: "stream",
            device: "text".into(),
            tool_version: "1".into(),
            operand_bits: 8,
            radii: 1,
            scope: "",
            pairs_compared: 256,
            photon_tests: 256,
            vectors_compared: 256,
            signals_per_vector: 1,
        }
    }

    fn report(unit: UnitVerdict) -> Report {
        Report {
            parts: vec![unit],
            lanes: vec![lane()],
            ..Report::default()
        }
    }

    #[test]
    fn a_mismatch_and_nothing_compared_fail() {
        assert!(verdict(&report(unit())).is_ok());
        let wrong = UnitVerdict {
            mismatches: 1,
            first_mismatch: Some("a=1 b=2".into()),
            ..unit()
        };
        let error = verdict(&report(wrong)).unwrap_err().to_string();
        assert!(
            error.contains("add of 6 bits") && error.contains("a=1 b=2"),
            "{error}"
        );
        let nothing = UnitVerdict {
            pairs_compared: 0,
            ..unit()
        };
        assert!(verdict(&report(nothing)).is_err());
        assert!(verdict(&Report::default()).is_err());
    }
}
