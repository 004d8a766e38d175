//! The checks that a design must pass before it is printed: rust-hdl's own checks, and the lint.

use photoncube_spec::Machine;
use rust_hdl::prelude::check_all;
use rust_hdl_lint::{Design, Finding, Opaque, OpaqueKind, Rule, lint};
use serde::{Deserialize, Serialize};

use super::{BlockRam, EmitError, TOP};
use crate::build::build;
use crate::generator::{self, GeneratorError};
use crate::level::Level;
use crate::pinned::Pinned;

/// Blocks whose Verilog is written by hand, which the lint cannot read. Each is simulated from its emitted
/// text, and exhaustively where it has no state.
const HAND_WRITTEN: &[&str] = &[
    "difference",
    "squarer",
    "magnitude_of",
    "split_magnitude",
    "memory",
    "digit_products",
    "cross_sum",
    "square_sum",
    "square_table",
    "split_0",
    "split_1",
    "difference_product",
    "split_product",
    "admission",
    "queue",
    "decision",
    "pair_first_delay",
    "group_last_delay",
    "first_copy",
    "done_copy",
    "group_words",
    "box_words",
    "pair_ram",
    "mask_ram",
    "flag_ram",
    "tag_ram",
    "kind_ram",
];

/// The parts of a design that the lint read, and its findings.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Linted {
    /// Blocks whose statements rust-hdl generates. Without a finding each statement is shown to mean in Verilog what
    /// it means in Rust.
    pub generated: usize,
    /// Registers of rust-hdl's library, recognised by their whole text.
    pub registers: usize,
    /// Blocks whose Verilog is written by hand and stands in the list of those that are simulated exhaustively.
    pub hand_written: usize,
    /// The findings, one for each wrong statement or block.
    pub findings: Vec<String>,
}

/// The whole machine as the lint sees it.
///
/// # Errors
/// The machine is neither built in nor has a generator.
pub fn lint_machine(machine: &Machine) -> Result<Linted, GeneratorError> {
    match build(machine, Level::Machine) {
        Ok(block) => Ok(lint_block(block.as_ref())),
        Err(_) => generator::lint(machine),
    }
}

/// The block of a whole machine as the lint sees it.
pub(crate) fn lint_block(block: &dyn Pinned) -> Linted {
    let design = Design::of(block);
    let opaque = design.opaque();
    let is_register = |opaque: &&Opaque| opaque.kind == OpaqueKind::Register;
    let registers = opaque.iter().filter(is_register).count();
    let unknown = unknown_texts(Level::Machine.name(), &opaque);
    Linted {
        generated: design.generated().len(),
        registers,
        hand_written: opaque.len() - registers - unknown.len(),
        findings: [statement_findings(&design, block), unknown].concat(),
    }
}

pub(super) fn check(name: &str, part: &str, block: &dyn Pinned) -> Result<(), EmitError> {
    check_all(block).map_err(|error| EmitError::Check {
        machine: name.to_owned(),
        reason: format!("{error:?}"),
    })?;
    let design = Design::of(block);
    let unknown = unknown_texts(part, &design.opaque());
    let findings = [statement_findings(&design, block), unknown].concat();
    if findings.is_empty() {
        return Ok(());
    }
    Err(EmitError::Lint {
        machine: name.to_owned(),
        findings: findings.join("\n"),
    })
}

/// The lint's findings, those about declared block RAMs left out.
fn statement_findings(design: &Design, block: &dyn Pinned) -> Vec<String> {
    let block_rams = block.block_rams();
    let found = design.findings();
    let found = found
        .iter()
        .filter(|finding| !is_block_ram(finding, &block_rams));
    found.map(ToString::to_string).collect()
}

/// Verilog written by hand in blocks that are not among [`HAND_WRITTEN`].
fn unknown_texts(part: &str, opaque: &[Opaque]) -> Vec<String> {
    let unknown = opaque.iter().filter(|opaque| {
        // An element of an array is named by its number.
        let is_name = |part: &&str| part.parse::<u32>().is_err();
        let instance = opaque.path.rsplit('$').find(is_name).unwrap_or_default();
        let instance = if instance == TOP { part } else { instance };
        opaque.kind != OpaqueKind::Register && !HAND_WRITTEN.contains(&instance)
    });
    unknown
        .map(|opaque| format!("{}: Verilog that the lint cannot read", opaque.path))
        .collect()
}

/// Whether a finding is about a memory that the block declares as one without initial values. A simulation
/// fills such a memory, and the power-up faults of `photoncube verify faults` show that no word is used
/// before it is written.
fn is_block_ram(finding: &Finding, block_rams: &[BlockRam]) -> bool {
    let Some(memory) = finding.statement.strip_prefix("memory ") else {
        return false;
    };
    // rust-hdl joins the instances of a path by `$`.
    let plain = |path: &str| path.replace(['$', '.'], "_");
    let found = plain(&format!("{}.{memory}", finding.path));
    let mut declared = block_rams
        .iter()
        .map(|ram| plain(&format!("{TOP}.{}", ram.path)));
    finding.rule == Rule::UninitialisedMemory && declared.any(|declared| declared == found)
}

/// Whether the lint finds the one mistake planted in a block, under its own rule, and nothing else there: a 12-bit sum
/// that is cast to 13 bits, whose carry is lost in Rust and kept in Verilog.
pub fn lint_control() -> bool {
    let mut block = planted::CastSum::default();
    rust_hdl::prelude::Block::connect_all(&mut block);
    matches!(&lint(&block)[..], [only] if only.rule == Rule::CastOfExpression)
}

mod planted {
    use rust_hdl::prelude::*;

    #[derive(LogicBlock, Default)]
    pub struct CastSum {
        pub a: Signal<In, Bits<12>>,
        pub b: Signal<In, Bits<12>>,
        pub sum: Signal<Out, Bits<13>>,
    }

    impl Logic for CastSum {
        #[hdl_gen]
        fn update(&mut self) {
            self.sum.next = bit_cast::<13, 12>(self.a.val() + self.b.val());
        }
    }
}
