//! Blocks that only connect other blocks.
//!
//! A rust-hdl kernel has no form for `engine[e].photon[k]`, and its loops have fixed lengths. A block of
//! wires therefore states each wire once, in a method `wires`. Its simulation, its claims and its Verilog all
//! run through that method, so that they cannot diverge. The Verilog is a tree of plain assignments, which
//! the lint reads like any other.

use rust_hdl::core::ast::{VerilogExpression, VerilogStatement};
use rust_hdl::prelude::Verilog;

/// The purpose of a run through a block's wires.
pub(crate) enum Wiring {
    /// The run copies values, in the simulation.
    Update,
    /// The run claims the signals that are driven.
    Connect,
    /// The run records the names of target and source.
    Names(Wires),
}

/// Target and source of each wire, with the target's name as rust-hdl prints it.
pub(crate) type Wires = Vec<(String, VerilogExpression)>;

/// Prints the Verilog of wires.
pub(crate) fn verilog(wires: &Wires) -> Verilog {
    let assign = |(to, from): &(String, VerilogExpression)| {
        VerilogStatement::Assignment(VerilogExpression::Signal(to.clone()), from.clone())
    };
    Verilog::Combinatorial(wires.iter().map(assign).collect())
}

/// The name that rust-hdl prints for a path below `self`.
macro_rules! wire_name {
    ($a:ident) => {
        stringify!($a).to_owned()
    };
    ($a:ident [$i:expr]) => {
        format!("{}${}", stringify!($a), $i)
    };
    ($a:ident . $b:ident) => {
        format!("{}${}", stringify!($a), stringify!($b))
    };
    ($a:ident [$i:expr] . $b:ident) => {
        format!("{}${}${}", stringify!($a), $i, stringify!($b))
    };
    ($a:ident . $b:ident [$j:expr]) => {
        format!("{}${}${}", stringify!($a), stringify!($b), $j)
    };
    ($a:ident [$i:expr] . $b:ident [$j:expr]) => {
        format!("{}${}${}${}", stringify!($a), $i, stringify!($b), $j)
    };
}

/// Declares wires, each as `(target) = (source);` with paths below `self`.
macro_rules! wires {
    ($self:ident, $wiring:ident: $(($($to:tt)+) = ($($from:tt)+);)+) => {
        $(match $wiring {
            $crate::spatial::wiring::Wiring::Update => {
                let value = $self.$($from)+.val();
                $self.$($to)+.next = value;
            }
            $crate::spatial::wiring::Wiring::Connect => $self.$($to)+.connect(),
            $crate::spatial::wiring::Wiring::Names(names) => {
                let from = $crate::spatial::wiring::wire_name!($($from)+);
                let from = rust_hdl::core::ast::VerilogExpression::Signal(from);
                names.push(($crate::spatial::wiring::wire_name!($($to)+), from));
            }
        })+
    };
}

/// Declares targets that are always 0, each as `(target);`.
macro_rules! zeros {
    ($self:ident, $wiring:ident: $(($($to:tt)+);)+) => {
        $(match $wiring {
            $crate::spatial::wiring::Wiring::Update => {
                $self.$($to)+.next = Default::default();
            }
            $crate::spatial::wiring::Wiring::Connect => $self.$($to)+.connect(),
            $crate::spatial::wiring::Wiring::Names(names) => {
                let zero = Synth::verilog($self.$($to)+.next);
                let zero = rust_hdl::core::ast::VerilogExpression::Literal(zero);
                names.push(($crate::spatial::wiring::wire_name!($($to)+), zero));
            }
        })+
    };
}

/// Implements [`rust_hdl::prelude::Logic`] for a block with `wires` and `_wires`. The block's widths are given as in
/// its type: `logic_of_wires!(Stage<W>);`.
macro_rules! logic_of_wires {
    ($block:ident $(<$($width:ident),+>)?) => {
        impl $(<$(const $width: usize),+>)? Logic for $block $(<$($width),+>)? {
            fn update(&mut self) {
                self.wires(&mut $crate::spatial::wiring::Wiring::Update);
            }

            fn connect(&mut self) {
                self.wires(&mut $crate::spatial::wiring::Wiring::Connect);
            }

            fn hdl(&self) -> Verilog {
                $crate::spatial::wiring::verilog(&self._wires)
            }
        }
    };
}

/// Records the names of a block's wires; the last step of its constructor.
macro_rules! with_wires {
    ($block:expr) => {{
        let mut block = $block;
        let mut wiring = $crate::spatial::wiring::Wiring::Names(Vec::new());
        block.wires(&mut wiring);
        if let $crate::spatial::wiring::Wiring::Names(names) = wiring {
            block._wires = names;
        }
        block
    }};
}

pub(crate) use {logic_of_wires, wire_name, wires, with_wires, zeros};
