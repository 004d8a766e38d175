//! What the lint reports.

use std::fmt;

use super::rule::Rule;

/// One place where the emitted Verilog may differ from the simulation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The block: the name of its module in the emitted text, such as `top$cell$3`.
    pub path: String,
    /// The rule that it breaks.
    pub rule: Rule,
    /// The statement, near to how Verilog has it; loop variables are not yet replaced.
    pub statement: String,
    /// The name, index or pattern in question, where the rule is about one.
    pub detail: Option<String>,
    /// What to write instead.
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

/// A broken rule, before it is known which statement broke it.
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

/// The findings of one block.
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

    /// Adds a finding, once for each statement and rule: a loop visits a statement many times.
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
