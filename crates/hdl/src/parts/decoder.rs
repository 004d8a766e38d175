//! The decoder, which splits a control word into the fields of the spec's field table.

use photoncube_spec::{CellTables, FieldRow};
use rust_hdl::core::ast::{VerilogExpression, VerilogLiteral, VerilogStatement};
use rust_hdl::prelude::*;

/// Declares the block `Decoder`, which puts every field of a control word on a port of its own: the tables of the
/// cell; the bits of the word, and other parameters; each field, with its port and the port's type.
macro_rules! decoder {
    ($tables:ident, <$w:ident $(, $g:ident)*>, $($field:ident $port:ident [$($type:tt)+],)+) => {
        /// Puts every field of a control word on a port of its own.
        #[derive(LogicBlock, Default)]
        pub(crate) struct Decoder<const $w: usize $(, const $g: usize)*> {
            pub word: Signal<In, Bits<$w>>,
            $(pub $port: Signal<Out, $($type)+>,)+
            _dimension: u32,
        }

        impl<const $w: usize $(, const $g: usize)*> Decoder<$w $(, $g)*> {
            /// The decoder of a machine whose network has that dimension.
            pub fn new(dimension: u32) -> Self {
                assert_eq!($w, $tables.word_bits(dimension) as usize);
                Self { _dimension: dimension, ..Self::default() }
            }

            fn field(&self, field: Field) -> u64 {
                let word = self.word.val().to_u64() as ControlWord;
                u64::from($tables.field(field, word, self._dimension))
            }
        }

        impl<const $w: usize $(, const $g: usize)*> Logic for Decoder<$w $(, $g)*> {
            fn update(&mut self) {
                $(self.$port.next = Word::from_number(self.field(Field::$field));)+
            }

            fn connect(&mut self) {
                $(self.$port.connect();)+
            }

            fn hdl(&self) -> Verilog {
                $crate::parts::assignments(&$tables, self._dimension)
            }
        }
    };
}

pub(crate) use decoder;

/// The Verilog of a decoder.
pub(crate) fn assignments(tables: &CellTables, dimension: u32) -> Verilog {
    let assign = |row: &FieldRow| {
        let word = Box::new(VerilogExpression::Signal("word".to_owned()));
        let lsb = VerilogLiteral::from(tables.lsb(row.field, dimension));
        let lsb = Box::new(VerilogExpression::Literal(lsb));
        let slice = match (row.width)(dimension) {
            1 => VerilogExpression::Index(word, lsb),
            width => VerilogExpression::Slice(word, width as usize, lsb),
        };
        let target = VerilogExpression::Signal(row.name.to_owned());
        VerilogStatement::Assignment(target, slice)
    };
    Verilog::Combinatorial(tables.fields.iter().map(assign).collect())
}
