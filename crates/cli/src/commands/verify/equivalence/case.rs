//! `verify equivalence --case`: replays a counterexample.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use photoncube_hdl::Level;
use photoncube_spec::Machine;
use photoncube_testbench::{
    Device, DeviceKind, Recorder, Regression, VerifyError, Waves, comparison_controls,
};
use serde::Serialize;
use serde_json::json;

use super::super::outcome::{Outcome, UpToDifference};
use super::super::waves::WavesArgs;
use super::Equivalence;
use crate::verified::Line;

/// A case that was equal in a device.
#[derive(Debug, Serialize)]
struct Replayed {
    device: &'static str,
    vectors_compared: u64,
    signals_per_vector: usize,
    tool_version: String,
}

/// The columns of the table.
const COLUMNS: &str = "device vectors_compared signals_per_vector tool_version";

/// Replays the case of that file in each device, up to the first difference.
pub(super) fn replay(path: &Path, devices: &[DeviceKind], waves: &WavesArgs) -> Result<Outcome> {
    let text = fs::read_to_string(path)
        .with_context(|| format!("--case: cannot read {}", path.display()))?;
    let case = Regression::parse(&text).with_context(|| format!("--case {}", path.display()))?;
    let machine = case.machine()?;
    let clocks = waves.clocks().unwrap_or(1);
    let mut written = None;
    let mut all = UpToDifference::new(|replayed: &Replayed| replayed.vectors_compared);
    for &kind in devices {
        let (ended, recorded) = replay_in(machine, kind, &case, clocks)?;
        written = waves.write(Some(&recorded))?;
        if !all.add(kind.name(), ended)? {
            break;
        }
    }
    let details = json!({
        "machine": machine.name,
        "replayed": path.display().to_string(),
        "vectors_compared": all.vectors_compared,
        "mismatches": all.mismatches(),
        "devices": all.verdicts,
        "waves": written,
    });
    let verdicts = all.verdicts.iter();
    let lines = verdicts.map(|replayed| line(machine, path, replayed));
    let lines = lines.collect::<Result<Vec<_>>>()?;
    let controls = comparison_controls(devices.iter().copied())?;
    Ok(Outcome::new::<Equivalence>(controls, &details)?
        .rows("devices", COLUMNS)
        .waves(written.as_ref())
        .lines(lines)
        .findings(all.difference))
}

fn replay_in(
    machine: &Machine,
    kind: DeviceKind,
    case: &Regression,
    clocks: usize,
) -> Result<(Result<Replayed, VerifyError>, Waves)> {
    let device = kind.open(machine, Level::Machine)?;
    let mut recorder = Recorder::new(machine, device, clocks);
    let compared = case.replay(&mut recorder);
    let ended = compared.map(|vectors_compared| Replayed {
        device: kind.name(),
        vectors_compared,
        signals_per_vector: recorder.visible(),
        tool_version: recorder.tool_version().to_owned(),
    });
    Ok((ended, recorder.into_waves()))
}

fn line(machine: &Machine, path: &Path, replayed: &Replayed) -> Result<Line> {
    Ok(Line {
        aspect: "a case".to_owned(),
        by: format!("{}: {}", replayed.device, replayed.tool_version),
        volume: replayed.vectors_compared,
        unit: format!("vectors of {} signals", replayed.signals_per_vector),
        result: "0 mismatches".to_owned(),
        command: format!(
            "photoncube verify equivalence --case {} --against {}",
            path.display(),
            replayed.device
        ),
        ..Line::of_machine(machine.name)?
    })
}
