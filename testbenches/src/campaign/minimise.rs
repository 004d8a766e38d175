//! Reduces the inputs that show a difference to a short regression case.

use std::ops::ControlFlow;

use photoncube_model::golden_machine;
use photoncube_spec::{Group, Machine, Pins};

use super::regression::{Regression, compare};
use crate::compare::Divergence;
use crate::device::{Device, DeviceError};
use crate::stimulus::{Source, generate, modelled, scrub_rows};
use crate::verify::VerifyError;

/// The most replays of the search for fewer or simpler inputs.
const MOST_REPLAYS: usize = 2_000;

/// Makes a regression case of a difference that random stimulus found. `open` opens the device anew.
///
/// # Errors
/// The device does not run, or the difference does not occur again.
pub fn minimised(
    machine: &Machine,
    divergence: &Divergence,
    open: &mut dyn FnMut() -> Result<Box<dyn Device>, DeviceError>,
) -> Result<Regression, VerifyError> {
    let case =
        |rows: &[u64]| Regression::new(machine, &divergence.device, divergence.to_string(), rows);
    let all = rows_up_to(machine, divergence)?;
    let mut search = Search {
        machine,
        columns: Pins::of(machine).inputs.len(),
        device: open()?,
        replays: 0,
    };
    if !search.fails(&all)? {
        // The difference depends on earlier contents of the device, so the case is not reduced.
        return Ok(case(&all));
    }
    let mut rows = search.shortest_end(&all)?;
    rows = search.without_rows(rows)?;
    rows = search.with_zeros(rows)?;
    // The replays must not depend on what the device held before, so each begins with a new device.
    search.device = open()?;
    let rows = if search.fails(&rows)? { rows } else { all };
    Ok(case(&rows))
}

/// The rows of the difference's chunk up to the clock that differs, without the rows with which every chunk
/// begins.
fn rows_up_to(machine: &Machine, divergence: &Divergence) -> Result<Vec<u64>, VerifyError> {
    let columns = Pins::of(machine).inputs.len();
    let wanted = (divergence.clock as usize + 1) * columns;
    let mut rows = Vec::new();
    let mut sink = |block: crate::stimulus::Block| {
        rows.extend(block.inputs);
        match rows.len() < wanted {
            true => ControlFlow::Continue(()),
            false => ControlFlow::Break(()),
        }
    };
    generate(
        machine,
        Source::Random,
        divergence.seed,
        u64::MAX,
        &mut sink,
    )?;
    rows.truncate(wanted);
    let begun = scrub_rows(machine).len();
    // Where the difference is in the rows with which every chunk begins, these rows are the case.
    Ok(if rows.len() > begun {
        rows.split_off(begun)
    } else {
        rows
    })
}

struct Search<'a> {
    machine: &'a Machine,
    columns: usize,
    device: Box<dyn Device>,
    replays: usize,
}

impl Search<'_> {
    /// Whether the device differs on these rows, and the rows follow the streams' rules.
    fn fails(&mut self, rows: &[u64]) -> Result<bool, VerifyError> {
        if rows.is_empty() || !is_legal(self.machine, rows) {
            return Ok(false);
        }
        self.replays += 1;
        let block = modelled(self.machine, rows);
        match compare(self.machine, self.device.as_mut(), &block) {
            Ok(()) => Ok(false),
            Err(VerifyError::Diverged(_)) => Ok(true),
            Err(error) => Err(error),
        }
    }

    /// The last rows that still fail, in the fewest that halving finds.
    fn shortest_end(&mut self, rows: &[u64]) -> Result<Vec<u64>, VerifyError> {
        let clocks = rows.len() / self.columns;
        let mut last = 1;
        while last < clocks {
            let end = &rows[rows.len() - last * self.columns..];
            if self.fails(end)? {
                return Ok(end.to_vec());
            }
            last *= 2;
        }
        Ok(rows.to_vec())
    }

    /// Removes rows, in large parts and then in smaller ones, while the rest still fails.
    fn without_rows(&mut self, mut rows: Vec<u64>) -> Result<Vec<u64>, VerifyError> {
        let mut clocks = (rows.len() / self.columns / 2).max(1);
        loop {
            let mut left_out = false;
            let mut first = 0;
            while first < rows.len() && self.replays < MOST_REPLAYS {
                let end = rows.len().min(first + clocks * self.columns);
                let rest = [&rows[..first], &rows[end..]].concat();
                if self.fails(&rest)? {
                    rows = rest;
                    left_out = true;
                } else {
                    first = end;
                }
            }
            let spent = self.replays >= MOST_REPLAYS;
            if spent || (clocks == 1 && !left_out) {
                return Ok(rows);
            }
            clocks = (clocks / 2).max(1);
        }
    }

    /// Replaces values by zeros, pin by pin and then value by value, while the case still fails.
    fn with_zeros(&mut self, mut rows: Vec<u64>) -> Result<Vec<u64>, VerifyError> {
        for pin in 0..self.columns {
            let mut zeroed = rows.clone();
            zeroed
                .iter_mut()
                .skip(pin)
                .step_by(self.columns)
                .for_each(|value| *value = 0);
            self.take_if_it_fails(&mut rows, zeroed)?;
        }
        for index in 0..rows.len() {
            let mut zeroed = rows.clone();
            zeroed[index] = 0;
            self.take_if_it_fails(&mut rows, zeroed)?;
        }
        Ok(rows)
    }

    fn take_if_it_fails(
        &mut self,
        rows: &mut Vec<u64>,
        simpler: Vec<u64>,
    ) -> Result<(), VerifyError> {
        if simpler != *rows && self.replays < MOST_REPLAYS && self.fails(&simpler)? {
            *rows = simpler;
        }
        Ok(())
    }
}

/// Whether the rows follow the rules: an offered group stays until it is taken, no query has more photons
/// than the machine declares, and none has a radius that the machine does not accept.
fn is_legal(machine: &Machine, rows: &[u64]) -> bool {
    let columns = Pins::of(machine).inputs.len();
    let most = machine.max_photons() / machine.photons_per_iteration() as u64;
    let mut model = golden_machine(machine);
    for row in scrub_rows(machine).chunks_exact(columns) {
        model.clock(&Pins::inputs_of(machine, row));
    }
    let mut offered: Option<Group> = None;
    let mut groups = 0;
    for row in rows.chunks_exact(columns) {
        let inputs = Pins::inputs_of(machine, row);
        let outputs = model.outputs(&inputs);
        let stays = offered
            .take()
            .is_none_or(|group| inputs.group_valid && inputs.group == group);
        let radius = machine.fixed_radius_sq().unwrap_or(inputs.query.radius_sq);
        if !stays || inputs.query.radius_sq != radius {
            return false;
        }
        if inputs.reset {
            groups = 0;
        } else if inputs.group_valid && outputs.group_ready {
            groups = if inputs.group.last { 0 } else { groups + 1 };
        } else if inputs.group_valid {
            offered = Some(inputs.group.clone());
        }
        if groups > most {
            return false;
        }
        model.clock(&inputs);
    }
    true
}
