//! Walks a block's statements with its loops unrolled, as the printer does.

use rust_hdl::prelude::ast::{
    VerilogBlockOrConditional, VerilogConditional, VerilogExpression, VerilogLink,
    VerilogLinkDetails, VerilogLoop, VerilogMatch, VerilogStatement,
};

use super::agree;
use super::design::{Module, Role, Symbol};
use super::finding::{Fault, Findings};
use super::lower::Frame;
use super::name;
use super::node::Node;
use super::rule::Rule;
use super::shape;
use super::text;

/// Checks all statements of a generated or hand-written tree.
pub(super) fn check(module: &Module, block: &[VerilogStatement], findings: &mut Findings) {
    let frame = Frame {
        module,
        loops: Vec::new(),
        reads_outside: false,
    };
    let mut walker = Walker {
        frame,
        findings,
        first_target: None,
    };
    walker.block(block);
    if let (Some(target), false) = (walker.first_target, walker.frame.reads_outside) {
        findings.add(Rule::ConstantOnlyBlock, &format!("always @(*) {target}"));
    }
}

struct Walker<'a> {
    frame: Frame<'a>,
    findings: &'a mut Findings,
    /// The target of the first assignment, if there is one.
    first_target: Option<String>,
}

impl Walker<'_> {
    fn block(&mut self, block: &[VerilogStatement]) {
        for statement in block {
            self.statement(statement);
        }
    }

    fn statement(&mut self, statement: &VerilogStatement) {
        match statement {
            VerilogStatement::Assignment(target, value) => self.assignment(target, value),
            VerilogStatement::SliceAssignment {
                base,
                width,
                offset,
                replacement,
            } => {
                self.slice_assignment(base, *width, offset, replacement);
            }
            VerilogStatement::If(conditional) => self.conditional(conditional),
            VerilogStatement::Match(choice) => self.choice(choice),
            VerilogStatement::Loop(repeated) => self.repeated(repeated),
            VerilogStatement::Comment(_) => {}
            VerilogStatement::Link(links) => links.iter().for_each(|link| self.link(link)),
            VerilogStatement::Macro(block) => self.block(block),
        }
    }

    fn assignment(&mut self, target: &VerilogExpression, value: &VerilogExpression) {
        let statement = format!("{} = {}", text::expression(target), text::expression(value));
        self.first_target.get_or_insert_with(|| statement.clone());
        let width = self.target(target).map(|symbol| symbol.width);
        self.assign(width, value, &statement);
    }

    fn slice_assignment(
        &mut self,
        base: &VerilogExpression,
        width: usize,
        offset: &VerilogExpression,
        value: &VerilogExpression,
    ) {
        let place =
            VerilogExpression::Slice(Box::new(base.clone()), width, Box::new(offset.clone()));
        let statement = format!("{} = {}", text::expression(&place), text::expression(value));
        self.first_target.get_or_insert_with(|| statement.clone());
        // The target is written, not read.
        let reads = self.frame.reads_outside;
        let width = self
            .target(base)
            .and(self.frame.lower(&place))
            .map(|_| width);
        self.frame.reads_outside = reads;
        self.assign(width, value, &statement);
    }

    fn assign(&mut self, width: Result<usize, Fault>, value: &VerilogExpression, text: &str) {
        let value = self.frame.lower(value);
        let checked = width.and_then(|width| Ok((width, value?)));
        let verdict = checked.and_then(|(width, value)| {
            agree::check_assignment(width, &value)?;
            three_address(&value)
        });
        self.report(verdict, text);
    }

    /// The symbol that the assignment writes.
    fn target(&self, target: &VerilogExpression) -> Result<Symbol, Fault> {
        let VerilogExpression::Signal(path) = target else {
            return Err(Fault::about(Rule::StaleName, text::expression(target)));
        };
        let symbol = self.frame.symbol(path)?;
        match symbol.role {
            Role::Driven | Role::Outside => Ok(symbol.clone()),
            Role::Constant | Role::Variant => Err(Fault::about(Rule::StaleName, path)),
        }
    }

    fn conditional(&mut self, conditional: &VerilogConditional) {
        let statement = format!("if ({})", text::expression(&conditional.test));
        let verdict = self.frame.lower(&conditional.test).and_then(|test| {
            agree::check_alone(&test)?;
            three_address(&test)
        });
        self.report(verdict, &statement);
        self.block(&conditional.then);
        match &conditional.otherwise {
            VerilogBlockOrConditional::Block(block) => self.block(block),
            VerilogBlockOrConditional::Conditional(statement) => self.statement(statement),
            VerilogBlockOrConditional::None => {}
        }
    }

    fn choice(&mut self, choice: &VerilogMatch) {
        let statement = format!("case ({})", text::expression(&choice.test));
        let verdict = self.frame.lower(&choice.test).and_then(|test| {
            agree::check_alone(&test)?;
            match shape::is_operand(&test) {
                true => Ok(()),
                // The patterns are 32 bits wide and would widen the selector.
                false => Err(Rule::CompareOfExpression.into()),
            }
        });
        self.report(verdict, &statement);
        for case in &choice.cases {
            let verdict = self.pattern(&case.condition);
            self.report(verdict, &format!("{statement} {}:", case.condition));
            self.block(&case.block);
        }
    }

    fn pattern(&self, pattern: &str) -> Result<(), Fault> {
        if pattern == "default" || is_number(pattern) {
            return Ok(());
        }
        match self.frame.symbol(pattern) {
            Ok(Symbol {
                role: Role::Variant,
                ..
            }) => Ok(()),
            _ => Err(Fault::about(Rule::CasePattern, pattern)),
        }
    }

    fn repeated(&mut self, repeated: &VerilogLoop) {
        let index = &repeated.index;
        if self.frame.module.symbols.contains_key(index) {
            self.findings
                .add(Rule::ShadowedName, &format!("for {index}"));
        }
        for value in repeated.from.as_usize()..repeated.to.as_usize() {
            self.frame.loops.push((index.clone(), value));
            self.block(&repeated.block);
            self.frame.loops.pop();
        }
    }

    fn link(&mut self, link: &VerilogLink) {
        let (VerilogLink::Forward(details)
        | VerilogLink::Backward(details)
        | VerilogLink::Bidirectional(details)) = link;
        let VerilogLinkDetails {
            my_name,
            owner_name,
            other_name,
        } = details;
        for side in [owner_name, other_name] {
            let path = match name::readable(my_name) {
                own if own.is_empty() => side.clone(),
                own => format!("{side}${own}"),
            };
            let verdict = self.frame.symbol(&path).map(|_| ());
            self.report(
                verdict,
                &format!("link {} {}", name::readable(&path), other_name),
            );
        }
    }

    fn report(&mut self, verdict: Result<(), Fault>, statement: &str) {
        if let Err(fault) = verdict {
            self.findings.add(fault, statement);
        }
    }
}

fn three_address(value: &Node) -> Result<(), Fault> {
    match shape::is_three_address(value) {
        true => Ok(()),
        false => Err(Rule::SeveralOperators.into()),
    }
}

/// Whether a pattern is a decimal number, or one with Verilog's size and base, as in hand-written trees.
fn is_number(pattern: &str) -> bool {
    let decimal = |text: &str| !text.is_empty() && text.bytes().all(|c| c.is_ascii_digit());
    let Some((size, based)) = pattern.split_once('\'') else {
        return decimal(pattern);
    };
    let digits = match based.split_at_checked(1) {
        Some(("d", digits)) => decimal(digits),
        Some(("h", digits)) => u128::from_str_radix(digits, 16).is_ok(),
        Some(("b", digits)) => u128::from_str_radix(digits, 2).is_ok(),
        _ => false,
    };
    decimal(size) && digits
}
