//! The control words of the sequential machine: one word for each step, which the control block stores and
//! broadcasts to all cells.

use crate::cell::{ControlWord, Field, SEQUENTIAL, Step};
use crate::hypercube::Hypercube;

/// Encodes the control word of a step. `takes_group` marks the last step of an iteration that reads the
/// group; [`crate::Microprogram::control_words`] finds that step. The word is the same in every dimension.
pub fn encode(step: Step, takes_group: bool) -> ControlWord {
    let any = Hypercube::MIN_DIMENSION;
    let takes = u32::from(takes_group) << SEQUENTIAL.lsb(Field::TakesGroup, any);
    SEQUENTIAL.own_fields(step, any) | takes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::Register;
    use crate::hypercube::Axis;

    #[test]
    fn every_step_has_a_word_of_its_own_and_its_fields_are_read_back() {
        let cube = Hypercube::new(5);
        let mut words = Vec::new();
        for row in SEQUENTIAL.ops {
            let axes: Vec<Option<Axis>> = if row.link.is_some() {
                cube.axes().map(Some).collect()
            } else {
                vec![None]
            };
            for axis in axes {
                let word = encode(Step { op: row.op, axis }, false);
                assert_eq!(
                    SEQUENTIAL.field(Field::Axis, word, 5),
                    axis.map_or(0, |axis| 1 << axis.bit()),
                    "{}",
                    row.op.mnemonic()
                );
                assert_eq!(
                    SEQUENTIAL.field(Field::ReadsGroup, word, 5) == 1,
                    row.reads_group()
                );
                words.push(word);
            }
        }
        let all = words.len();
        words.sort_unstable();
        words.dedup();
        assert_eq!(words.len(), all, "two steps share a control word");
    }

    #[test]
    fn a_word_writes_just_the_registers_of_its_op() {
        let writers = [
            (Register::Query, vec![Field::WriteQuery]),
            (Register::RadiusSq, vec![Field::WriteQuery]),
            (Register::Photon, vec![Field::WritePhoton]),
            (Register::Power(0), vec![Field::WritePower]),
            (Register::Work, vec![Field::WriteWork]),
            (Register::Sum, vec![Field::WriteQuery, Field::WriteSum]),
        ];
        for row in SEQUENTIAL.ops {
            let word = encode(Step::new(row.op), false);
            for (register, fields) in &writers {
                let written = fields
                    .iter()
                    .any(|&field| SEQUENTIAL.field(field, word, 4) == 1);
                assert_eq!(
                    written,
                    row.writes.contains(register),
                    "{} {register:?}",
                    row.op.mnemonic()
                );
            }
        }
    }
}
