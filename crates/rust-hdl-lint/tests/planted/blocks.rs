//! Macros and helpers for the planted examples.

use rust_hdl::prelude::*;
use rust_hdl_lint::{Finding, Rule, lint};

pub type I<const N: usize> = Signal<In, Bits<N>>;
pub type O<const N: usize> = Signal<Out, Bits<N>>;
pub type L<const N: usize> = Signal<Local, Bits<N>>;
pub type SignedI<const N: usize> = Signal<In, Signed<N>>;
pub type SignedO<const N: usize> = Signal<Out, Signed<N>>;
pub type SignedL<const N: usize> = Signal<Local, Signed<N>>;
pub type BitI = Signal<In, Bit>;
pub type BitO = Signal<Out, Bit>;
pub type BitL = Signal<Local, Bit>;

/// A planted mistake and its corrected form.
pub struct Case {
    pub name: &'static str,
    pub rule: Rule,
    pub bad: fn() -> Vec<Finding>,
    pub good: fn() -> Vec<Finding>,
}

/// The lint's findings for a block that is built as in a test bench.
pub fn findings<B: Block>(mut block: B) -> Vec<Finding> {
    block.connect_all();
    lint(&block)
}

/// Declares a block with the inputs that all examples share, its own fields, and a kernel.
macro_rules! block {
    ($name:ident { $($field:ident: $type:ty $(= $value:expr)?),* $(,)? } $($kernel:tt)*) => {
        #[derive(LogicBlock)]
        pub struct $name {
            pub a: I<12>, pub b: I<12>, pub c: I<12>,
            pub m: I<16>, pub n: I<16>, pub o: I<16>, pub p: I<16>,
            pub s: SignedI<16>, pub t: SignedI<16>, pub u: SignedI<34>, pub v: SignedI<8>,
            pub three: I<3>, pub four: I<4>, pub one: I<1>,
            pub x: BitI, pub z: BitI,
            $(pub $field: $type,)*
        }
        impl Default for $name {
            fn default() -> Self {
                Self {
                    a: Default::default(), b: Default::default(), c: Default::default(),
                    m: Default::default(), n: Default::default(), o: Default::default(),
                    p: Default::default(), s: Default::default(), t: Default::default(),
                    u: Default::default(), v: Default::default(), three: Default::default(),
                    four: Default::default(), one: Default::default(), x: Default::default(),
                    z: Default::default(),
                    $($field: crate::blocks::value_or_default!($($value)?),)*
                }
            }
        }
        impl Logic for $name { $($kernel)* }
    };
}

macro_rules! value_or_default {
    () => {
        Default::default()
    };
    ($value:expr) => {
        $value
    };
}

/// Makes a table of pairs: a wrong block and its corrected twin.
macro_rules! planted {
    ($($name:ident: $rule:ident
        bad { $($bad_field:tt)* } { $($bad:tt)* }
        good { $($good_field:tt)* } { $($good:tt)* }
    )+) => {
        $(mod $name {
            use super::*;
            crate::blocks::block!(Bad { $($bad_field)* } $($bad)*);
            crate::blocks::block!(Good { $($good_field)* } $($good)*);
        })+
        pub const CASES: &[crate::blocks::Case] = &[$(crate::blocks::Case {
            name: stringify!($name),
            rule: rust_hdl_lint::Rule::$rule,
            bad: || crate::blocks::findings($name::Bad::default()),
            good: || crate::blocks::findings($name::Good::default()),
        }),+];
    };
}

pub(crate) use {block, planted, value_or_default};
