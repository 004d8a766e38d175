//! Power-up without initial values of registers, as on a device that does not load them: finds the unknown
//! signals, and checks that a reset and the first query make all of them known.

use std::collections::BTreeSet;

use photoncube_hdl::Emitted;
use photoncube_spec::{Machine, Pins};

use super::difference::difference;
use super::idle::all_rows;
use super::{FaultClass, FaultVerdict};
use crate::device::{Device, Icarus, Observed};
use crate::stimulus::scrub_rows;
use crate::verify::{VerifyError, nothing_compared, wrong_count};

/// The text without the initial values of registers and of memories that start as zeros; tables of constants
/// keep their values. Block RAMs start with unknown words. Also returns the number of initial values that
/// were removed.
pub fn without_initial_values(design: &Emitted) -> (Emitted, usize) {
    // A table is a block that assigns words of an array.
    let is_table = |value: &str| value.starts_with("initial begin") && value.contains("] = ");
    let places = verilog_eval::initial_values(&design.text).into_iter();
    let removed: Vec<_> = places
        .filter(|place| !is_table(&design.text[place.clone()]))
        .collect();
    let mut text = design.text.clone();
    for place in removed.iter().rev() {
        text.replace_range(place.clone(), "");
    }
    let design = Emitted {
        text,
        block_rams: Vec::new(),
        ..design.clone()
    };
    (design, removed.len())
}

/// Verifies a text without its initial values. Until a reset and the first queries have passed, a value must
/// be the golden model's or unknown, and the streams' handshakes must be known from the reset on. After that,
/// every value must be the model's.
pub(super) fn verify_power_up(
    machine: &Machine,
    design: &Emitted,
    seed: u64,
) -> Result<FaultVerdict, VerifyError> {
    let pins = Pins::of(machine);
    let (bare, _) = without_initial_values(design);
    let block = all_rows(machine, FaultClass::UnknownPowerUp, seed)?;
    let settled = scrub_rows(machine).len() / Pins::of(machine).inputs.len();
    let mut device = Icarus::new(&bare)?;
    let mut observed = Observed::default();
    device.replay(&block.inputs, &mut observed)?;
    if observed.values.len() != block.expected.len() {
        return Err(wrong_count(&device, block.clocks, &observed).into());
    }
    if let Some(index) = first_wrong(&pins, &block.expected, &observed, settled) {
        let rows = (&pins, &block, &observed);
        return Err(difference(machine, rows, &device, index));
    }
    let found = Unknowns::of(&pins, &observed);
    if found.at_power_up == 0 || block.clocks <= settled || block.results == 0 {
        return Err(nothing_compared(device.name(), 0, block.results, 0));
    }
    Ok(FaultVerdict {
        machine: machine.name,
        fault: FaultClass::UnknownPowerUp.name(),
        device: device.name().to_owned(),
        tool_version: device.tool_version().to_owned(),
        injections: found.at_power_up,
        injected: found.words(&pins, settled),
        results_compared: block.results,
        vectors_compared: block.clocks as u64,
        signals_per_vector: pins.observed.len(),
        known_after_reset: found.known_after_reset.into_iter().collect(),
    })
}

fn first_wrong(
    pins: &Pins,
    expected: &[u64],
    observed: &Observed,
    settled: usize,
) -> Option<usize> {
    let visible = pins.observed.len();
    let unknown: BTreeSet<_> = observed
        .unknown
        .iter()
        .map(|unknown| unknown.index)
        .collect();
    let is_handshake = |index: usize| {
        let name = pins.observed[index % visible].name.as_str();
        ["query_ready", "group_ready", "result_valid"].contains(&name)
    };
    let must_be_known = |index: usize| {
        let clock = index / visible;
        clock >= settled || (clock > 0 && is_handshake(index))
    };
    let is_wrong = |&index: &usize| match unknown.contains(&index) {
        true => must_be_known(index),
        false => observed.values[index] != expected[index],
    };
    (0..expected.len()).find(is_wrong)
}

/// The unknown signals at some times.
struct Unknowns {
    /// The number of unknown signals in the first clock.
    at_power_up: u64,
    /// The number of unknown signals in the clock after the reset.
    after_reset: u64,
    /// The names of the signals that are known in that clock, by the reset or from the pins, without the
    /// numbers of cells and places.
    known_after_reset: BTreeSet<String>,
    /// The first clock from which on no signal is unknown.
    known_from: usize,
}

impl Unknowns {
    fn of(pins: &Pins, observed: &Observed) -> Self {
        let visible = pins.observed.len();
        let of_clock = |clock: usize| -> BTreeSet<usize> {
            let unknown = observed.unknown.iter().map(|unknown| unknown.index);
            let of_clock = unknown.filter(|index| index / visible == clock);
            of_clock.map(|index| index % visible).collect()
        };
        let (before, after) = (of_clock(0), of_clock(1));
        let set = before.difference(&after);
        let last = observed.unknown.last();
        Self {
            at_power_up: before.len() as u64,
            after_reset: after.len() as u64,
            known_after_reset: set
                .map(|&column| kind(&pins.observed[column].name))
                .collect(),
            known_from: last.map_or(0, |unknown| unknown.index / visible + 1),
        }
    }

    fn words(&self, pins: &Pins, settled: usize) -> String {
        format!(
            "of {} signals unknown at power-up, {} a clock after the reset, none from clock {} on; the first queries are \
             through in clock {settled}",
            pins.observed.len(),
            self.after_reset,
            self.known_from,
        )
    }
}

/// A signal's name without its numbers.
fn kind(name: &str) -> String {
    let is_word = |part: &&str| part.parse::<u32>().is_err();
    Vec::from_iter(name.split('_').filter(is_word)).join("_")
}

#[cfg(test)]
mod tests {
    use photoncube_hdl::{Level, emit};
    use photoncube_spec::MACHINES;

    use super::*;

    #[test]
    fn only_tables_of_constants_keep_their_initial_values() {
        for machine in MACHINES.iter().filter(|m| m.queries_at_once() <= 4) {
            let design = emit(machine, Level::Machine).unwrap();
            let (bare, removed) = without_initial_values(&design);
            assert!(removed > 4, "{}", machine.name);
            let tables = design.text.matches("squares[0] = ").count();
            assert_eq!(
                bare.text.matches("initial ").count(),
                tables,
                "{}",
                machine.name
            );
            assert_eq!(bare.register_paths, design.register_paths);
            assert_eq!(bare.block_rams, []);
            assert_eq!(!design.block_rams.is_empty(), machine.has_memory());
        }
    }
}
