#![doc = include_str!("../README.md")]
//!
//! # How it compares
//!
//! For each assignment, condition and `case` the lint computes two widths and two signs: those of the Rust
//! expression, and those of the Verilog expression (IEEE 1364-2001, tables 5-22 and 5-23: an operand is
//! evaluated at the width of its context). It accepts the statement only if it can show that every bit that
//! is used is equal in both. It reports every other statement. It also reports, as
//! [`Rule::SeveralOperators`], a statement that agrees but is not three-address code.
//!
//! Text that a block writes by hand (`Verilog::Custom` and the like) is opaque to this proof.
//! [`Design::opaque`] lists these texts, so that a caller can compare the list with a list of trusted texts.
//! In opaque text the lint checks only names, and memories without initial values.

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

/// Lists every place in `top` and the blocks in it where the emitted Verilog may differ from the Rust simulation.
///
/// Paths start with `top`, as in the text of `generate_verilog`. An empty list means that every generated
/// statement was shown to agree. It does not cover the blocks that [`Design::opaque`] lists.
pub fn lint(top: &dyn Block) -> Vec<Finding> {
    Design::of(top).findings()
}

/// A block and all blocks in it, as rust-hdl's printer reads them.
pub struct Design {
    modules: Vec<Module>,
}

impl Design {
    /// Reads the statements and declarations of `top` and the blocks in it.
    pub fn of(top: &dyn Block) -> Self {
        Self {
            modules: design::modules(top),
        }
    }

    /// The findings of [`lint`].
    pub fn findings(&self) -> Vec<Finding> {
        let mut findings = design::repeated_cores(&self.modules);
        for module in &self.modules {
            findings.extend(lint_module(module));
        }
        findings
    }

    /// The blocks whose Verilog is written by hand, which the lint cannot prove.
    ///
    /// Compare the result with a list of trusted texts. A register of the rust-hdl library is recognised by its
    /// whole text ([`OpaqueKind::Register`]), so only the remaining blocks need a review.
    pub fn opaque(&self) -> Vec<Opaque> {
        let modules = self.modules.iter();
        modules
            .filter_map(|module| Opaque::of(&module.path, &module.hdl))
            .collect()
    }

    /// The paths of the blocks whose statements rust-hdl generates, all of which are linted.
    pub fn generated(&self) -> Vec<&str> {
        let modules = self.modules.iter();
        modules
            .filter(|module| matches!(module.hdl, Verilog::Combinatorial(_)))
            .map(|module| module.path.as_str())
            .collect()
    }
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
