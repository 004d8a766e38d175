//! The decoder, which splits a cell's control word into the fields of the spec's field table.

use photoncube_spec::overlap::{ControlWord, FIELDS, Field, control_word_bits};
use rust_hdl::core::ast::{VerilogExpression, VerilogLiteral, VerilogStatement};
use rust_hdl::prelude::*;

/// Puts every field of a `W`-bit control word on a port of its own.
#[derive(LogicBlock, Default)]
pub(crate) struct Decoder<const W: usize> {
    pub word: Signal<In, Bits<W>>,
    pub write_photon: Signal<Out, Bit>,
    pub write_power: Signal<Out, Bit>,
    pub move_power: Signal<Out, Bits<7>>,
    pub write_square: Signal<Out, Bit>,
    pub write_work: Signal<Out, Bit>,
    pub write_sum: Signal<Out, Bit>,
    pub write_distance: Signal<Out, Bit>,
    pub distance_source: Signal<Out, Bits<2>>,
    pub axis: Signal<Out, Bits<4>>,
    pub gate: Signal<Out, Bit>,
    pub add_sum: Signal<Out, Bit>,
    pub send_work: Signal<Out, Bit>,
    pub send_distance: Signal<Out, Bit>,
}

impl<const W: usize> Decoder<W> {
    pub fn new() -> Self {
        assert_eq!(W, control_word_bits() as usize);
        Self::default()
    }

    fn flag(&self, field: Field) -> bool {
        self.field(field) != 0
    }

    fn field(&self, field: Field) -> u64 {
        let word = self.word.val().to_u64() as ControlWord;
        u64::from(field.of(word))
    }
}

impl<const W: usize> Logic for Decoder<W> {
    fn update(&mut self) {
        self.write_photon.next = self.flag(Field::WritePhoton);
        self.write_power.next = self.flag(Field::WritePower);
        self.move_power.next = self.field(Field::MovePower).to_bits();
        self.write_square.next = self.flag(Field::WriteSquare);
        self.write_work.next = self.flag(Field::WriteWork);
        self.write_sum.next = self.flag(Field::WriteSum);
        self.write_distance.next = self.flag(Field::WriteDistance);
        self.distance_source.next = self.field(Field::DistanceSource).to_bits();
        self.axis.next = self.field(Field::Axis).to_bits();
        self.gate.next = self.flag(Field::Gate);
        self.add_sum.next = self.flag(Field::AddSum);
        self.send_work.next = self.flag(Field::SendWork);
        self.send_distance.next = self.flag(Field::SendDistance);
    }

    fn connect(&mut self) {
        self.write_photon.connect();
        self.write_power.connect();
        self.move_power.connect();
        self.write_square.connect();
        self.write_work.connect();
        self.write_sum.connect();
        self.write_distance.connect();
        self.distance_source.connect();
        self.axis.connect();
        self.gate.connect();
        self.add_sum.connect();
        self.send_work.connect();
        self.send_distance.connect();
    }

    fn hdl(&self) -> Verilog {
        let assignments = FIELDS.iter().map(|row| {
            let target = VerilogExpression::Signal(row.name.to_owned());
            VerilogStatement::Assignment(target, slice(row.field))
        });
        Verilog::Combinatorial(assignments.collect())
    }
}

fn slice(field: Field) -> VerilogExpression {
    let word = Box::new(VerilogExpression::Signal("word".to_owned()));
    let lsb = Box::new(VerilogExpression::Literal(VerilogLiteral::from(
        field.lsb(),
    )));
    match field.row().width {
        1 => VerilogExpression::Index(word, lsb),
        width => VerilogExpression::Slice(word, width as usize, lsb),
    }
}
