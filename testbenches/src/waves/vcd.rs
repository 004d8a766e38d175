//! The waveform as a value change dump.

use std::io;

use vcd::{IdCode, ReferenceIndex, SimulationCommand, TimescaleUnit, Value, VarType, Writer};

use super::scopes::{Scope, Shown, Signal};
use super::{NS_PER_CLOCK, Row, Waves};
use crate::compare::Actual;

/// A value of a signal.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Change {
    Bits(Vec<Value>),
    Text(String),
}

/// The text of the dump.
pub(super) fn written(waves: &Waves, scopes: &[Scope]) -> Vec<u8> {
    let mut text = Vec::new();
    write(waves, scopes, &mut text).expect("a vector takes all bytes");
    text
}

fn write(waves: &Waves, scopes: &[Scope], to: &mut Vec<u8>) -> io::Result<()> {
    let mut writer = Writer::new(to);
    writer.version(&format!("photoncube {}", env!("CARGO_PKG_VERSION")))?;
    writer.comment(&format!(
        "{}: values before the rising edge that ends a clock. Clock n of the run begins at {NS_PER_CLOCK} n ns.",
        waves.subject
    ))?;
    writer.timescale(1, TimescaleUnit::NS)?;
    let signals = declared(scopes, &mut writer)?;
    let mut before: Vec<Option<Change>> = vec![None; signals.len()];
    for (clock, row) in waves.clocks().zip(&waves.rows) {
        let steps = waves.steps.as_ref();
        let steps = steps.map(|steps| steps.texts(&row.inputs, &row.model));
        let steps = steps.unwrap_or_default();
        writer.timestamp(Waves::time(clock))?;
        let is_first = before.iter().all(Option::is_none);
        if is_first {
            writer.begin(SimulationCommand::Dumpvars)?;
        }
        for ((id, signal), before) in signals.iter().zip(&mut before) {
            let now = Some(value(waves, row, &steps, signal));
            if now != *before || signal.shown == Shown::Clock {
                change(&mut writer, *id, now.as_ref())?;
                *before = now;
            }
        }
        if is_first {
            writer.end()?;
        }
        writer.timestamp(Waves::time(clock) + NS_PER_CLOCK / 2)?;
        let clocks = signals
            .iter()
            .filter(|(_, signal)| signal.shown == Shown::Clock);
        clocks
            .clone()
            .try_for_each(|(id, _)| writer.change_scalar(*id, Value::V0))?;
    }
    writer.timestamp(Waves::time(waves.clocks().end))
}

/// Declares all signals.
fn declared<'a>(
    scopes: &'a [Scope],
    writer: &mut Writer<&mut Vec<u8>>,
) -> io::Result<Vec<(IdCode, &'a Signal)>> {
    let mut signals = Vec::new();
    let mut open: &[String] = &[];
    for scope in scopes {
        let shared = open
            .iter()
            .zip(&scope.path)
            .take_while(|(a, b)| a == b)
            .count();
        for _ in shared..open.len() {
            writer.upscope()?;
        }
        for name in &scope.path[shared..] {
            writer.add_module(name)?;
        }
        open = &scope.path;
        for signal in &scope.signals {
            let id = match signal.bits {
                None => writer.add_var(VarType::String, 1, &signal.name, None)?,
                Some(1) => writer.add_wire(1, &signal.name)?,
                Some(bits) => {
                    let range = ReferenceIndex::Range(bits - 1, 0);
                    writer.add_var(VarType::Wire, bits, &signal.name, Some(range))?
                }
            };
            signals.push((id, signal));
        }
    }
    for _ in open {
        writer.upscope()?;
    }
    writer.enddefinitions()?;
    Ok(signals)
}

fn change(
    writer: &mut Writer<&mut Vec<u8>>,
    id: IdCode,
    change: Option<&Change>,
) -> io::Result<()> {
    match change {
        None => Ok(()),
        Some(Change::Text(text)) => writer.change_string(id, text),
        Some(Change::Bits(bits)) => match bits[..] {
            [bit] => writer.change_scalar(id, bit),
            _ => writer.change_vector(id, bits),
        },
    }
}

fn value(waves: &Waves, row: &Row, steps: &[String], signal: &Signal) -> Change {
    let width = signal.bits.unwrap_or(1);
    match signal.shown {
        Shown::Clock => known(1, 1),
        Shown::Input(column) => known(row.inputs[column], width),
        Shown::Step(index) => text(&steps[index]),
        Shown::Differs => known(u64::from(!row.differing.is_empty()), 1),
        Shown::Differing => text(&waves.names_differing(row)),
        Shown::Device(column) => match &row.device[column] {
            Actual::Known(value) => known(*value, width),
            Actual::Unknown(digits) => unknown(digits, width),
        },
        Shown::Model(column) => known(row.model[column], width),
    }
}

/// A value in its bits, the highest first.
fn known(value: u64, width: u32) -> Change {
    let bit = |bit: u32| Value::from(value >> bit & 1 != 0);
    Change::Bits((0..width).rev().map(bit).collect())
}

/// A value in hexadecimal with the digits x and z.
fn unknown(digits: &str, width: u32) -> Change {
    let bits = digits.chars().flat_map(|digit| match digit.to_digit(16) {
        Some(value) => [3, 2, 1, 0].map(|bit| Value::from(value >> bit & 1 != 0)),
        None if digit.eq_ignore_ascii_case(&'z') => [Value::Z; 4],
        None => [Value::X; 4],
    });
    let bits: Vec<_> = bits.collect();
    let missing = (width as usize).saturating_sub(bits.len());
    let padded = vec![Value::V0; missing].into_iter().chain(bits.clone());
    let cut = (missing + bits.len()).saturating_sub(width as usize);
    Change::Bits(padded.skip(cut).collect())
}

/// A text as viewers read it: a value has no spaces.
fn text(text: &str) -> Change {
    Change::Text(text.replace(", ", ",").replace(' ', "_"))
}
