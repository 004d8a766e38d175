//! The findings of the lint.

use std::fmt;

use super::rule::Rule;

/// A place where the emitted Verilog may differ from the simulation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The name of the block's module in the emitted text, such as `top$cell$3`.
    pub path: String,
    /// The rule that the statement breaks.
    pub rule: Rule,
    /// The statement in a form close to Verilog, with loop variables in place of their values.
    pub statement: String,
    /// The name, index or pattern that breaks the rule, where the rule is about one.
    pub detail: Option<String>,
    /// A suggestion of the code to write instead.
    pub advice: &'static str,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Finding {
            path,
            rule,
            statement,
            detail,
            advice,
        } = self;
        write!(
            f,
            "{path}: {}: {statement}: expected {}",
            rule.name(),
            rule.expected()
        )?;
        if let Some(detail) = detail {
            write!(f, ", found {detail}")?;
        }
        write!(f, "; {advice}")
    }
}

/// A broken rule, before the statement that breaks it is known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Fault {
    pub(super) rule: Rule,
    pub(super) detail: Option<String>,
}

impl Fault {
    pub(super) fn about(rule: Rule, detail: impl fmt::Display) -> Self {
        Fault {
            rule,
            detail: Some(format!("`{detail}`")),
        }
    }
}

impl From<Rule> for Fault {
    fn from(rule: Rule) -> Self {
        Fault { rule, detail: None }
    }
}

/// Collects the findings of one block.
pub(super) struct Findings {
    path: String,
    list: Vec<Finding>,
}

impl Findings {
    pub(super) fn new(path: &str) -> Self {
        Findings {
            path: path.to_owned(),
            list: Vec::new(),
        }
    }

    /// Adds a finding, once for each statement and rule, because a loop visits a statement many times.
    pub(super) fn add(&mut self, fault: impl Into<Fault>, statement: &str) {
        let Fault { rule, detail } = fault.into();
        if self
            .list
            .iter()
            .any(|known| known.rule == rule && known.statement == statement)
        {
            return;
        }
        self.list.push(Finding {
            path: self.path.clone(),
            rule,
            statement: statement.to_owned(),
            detail,
            advice: rule.advice(),
        });
    }

    pub(super) fn into_vec(self) -> Vec<Finding> {
        self.list
    }
}
