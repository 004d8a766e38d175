#![doc = include_str!("../README.md")]
//!
//! # How it compares
//!
//! For each assignment, condition and `case` the lint computes two widths and two signs: what Rust gave the expression,
//! and what Verilog gives it (IEEE 1364-2001, tables 5-22 and 5-23: an operand is evaluated at the width of its
//! context). It accepts the statement only if it can show that every bit that is used is equal in both. A statement
//! for which it can show that, but which is no three-address code, is reported as [`Rule::SeveralOperators`].
//!
//! Text that a block writes by hand (`Verilog::Custom` and the like) is opaque to this proof: only names and memories
//! without initial values are checked in it, and [`opaque_blocks`] lists it.

mod agree;
mod compare;
mod custom;
mod design;
mod finding;
mod keyword;
mod lower;
mod name;
mod node;
mod rule;
mod shape;
mod statement;
mod text;

pub use custom::{Opaque, OpaqueKind};
pub use finding::Finding;
pub use rule::Rule;

use rust_hdl::prelude::{Block, Verilog};

use design::Module;
use finding::Findings;

/// Every place in `top` and the blocks in it where the emitted Verilog may differ from the Rust simulation.
///
/// Paths start with `top`, as in the text of `generate_verilog`. An empty answer means that every
/// generated statement was shown to agree; it says nothing of the blocks that
/// [`opaque_blocks`] lists.
pub fn lint(top: &dyn Block) -> Vec<Finding> {
    let modules = design::modules(top);
    let mut findings = design::repeated_cores(&modules);
    for module in &modules {
        findings.extend(lint_module(module));
    }
    findings
}

/// The blocks below `top` whose Verilog is text written by hand, which no lint can prove.
///
/// Hold the answer against a list of trusted texts: a register of the library is recognised by
/// its whole text ([`OpaqueKind::Register`]), so only what is left needs a decision.
pub fn opaque_blocks(top: &dyn Block) -> Vec<Opaque> {
    design::modules(top)
        .into_iter()
        .filter_map(|module| Opaque::of(&module.path, &module.hdl))
        .collect()
}

/// The paths of `top` and the blocks in it whose statements rust-hdl generates, all of which [`lint`] checks.
pub fn generated_blocks(top: &dyn Block) -> Vec<String> {
    design::modules(top)
        .into_iter()
        .filter(|module| matches!(module.hdl, Verilog::Combinatorial(_)))
        .map(|module| module.path)
        .collect()
}

fn lint_module(module: &Module) -> Vec<Finding> {
    let mut findings = Findings::new(&module.path);
    module.check_names(&mut findings);
    match &module.hdl {
        Verilog::Empty => module.check_empty(&mut findings),
        Verilog::Combinatorial(block) => statement::check(module, block, &mut findings),
        Verilog::Custom(text) => custom::check(module, text, &mut findings),
        Verilog::Wrapper(_) | Verilog::Blackbox(_) => {}
    }
    findings.into_vec()
}
