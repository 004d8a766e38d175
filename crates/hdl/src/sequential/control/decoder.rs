//! The decoder, which splits the control word into the fields of the spec's field table.

use photoncube_spec::{ControlWord, FIELDS, Field};
use rust_hdl::core::ast::{VerilogExpression, VerilogLiteral, VerilogStatement};
use rust_hdl::prelude::*;

/// Puts every field of a `W`-bit control word on a port of its own; `X` axis bits.
#[derive(LogicBlock, Default)]
pub(crate) struct Decoder<const W: usize, const X: usize> {
    pub word: Signal<In, Bits<W>>,
    pub write_query: Signal<Out, Bit>,
    pub write_photon: Signal<Out, Bit>,
    pub write_power: Signal<Out, Bit>,
    pub write_work: Signal<Out, Bit>,
    pub write_sum: Signal<Out, Bit>,
    pub work_source: Signal<Out, Bits<2>>,
    pub add_sum: Signal<Out, Bit>,
    pub takes_query: Signal<Out, Bit>,
    pub reads_group: Signal<Out, Bit>,
    pub takes_group: Signal<Out, Bit>,
    pub axis: Signal<Out, Bits<X>>,
    _dimension: u32,
}

impl<const W: usize, const X: usize> Decoder<W, X> {
    pub fn new(dimension: u32) -> Self {
        assert_eq!(W, photoncube_spec::control_word_bits(dimension) as usize);
        assert_eq!(X, (Field::Axis.row().width)(dimension) as usize);
        Self {
            _dimension: dimension,
            ..Self::default()
        }
    }

    fn flag(&self, field: Field) -> bool {
        self.field(field) != 0
    }

    fn field(&self, field: Field) -> u64 {
        let word = self.word.val().to_u64() as ControlWord;
        u64::from(field.of(word, self._dimension))
    }
}

impl<const W: usize, const X: usize> Logic for Decoder<W, X> {
    fn update(&mut self) {
        self.write_query.next = self.flag(Field::WriteQuery);
        self.write_photon.next = self.flag(Field::WritePhoton);
        self.write_power.next = self.flag(Field::WritePower);
        self.write_work.next = self.flag(Field::WriteWork);
        self.write_sum.next = self.flag(Field::WriteSum);
        self.work_source.next = self.field(Field::WorkSource).to_bits();
        self.add_sum.next = self.flag(Field::AddSum);
        self.takes_query.next = self.flag(Field::TakesQuery);
        self.reads_group.next = self.flag(Field::ReadsGroup);
        self.takes_group.next = self.flag(Field::TakesGroup);
        self.axis.next = self.field(Field::Axis).to_bits();
    }

    fn connect(&mut self) {
        self.write_query.connect();
        self.write_photon.connect();
        self.write_power.connect();
        self.write_work.connect();
        self.write_sum.connect();
        self.work_source.connect();
        self.add_sum.connect();
        self.takes_query.connect();
        self.reads_group.connect();
        self.takes_group.connect();
        self.axis.connect();
    }

    fn hdl(&self) -> Verilog {
        let slice = |field: Field| {
            let word = Box::new(VerilogExpression::Signal("word".to_owned()));
            let lsb = Box::new(VerilogExpression::Literal(VerilogLiteral::from(
                field.lsb(),
            )));
            match (field.row().width)(self._dimension) {
                1 => VerilogExpression::Index(word, lsb),
                width => VerilogExpression::Slice(word, width as usize, lsb),
            }
        };
        let assign = |field: Field| {
            let target = VerilogExpression::Signal(field.row().name.to_owned());
            VerilogStatement::Assignment(target, slice(field))
        };
        Verilog::Combinatorial(FIELDS.iter().map(|row| assign(row.field)).collect())
    }
}
