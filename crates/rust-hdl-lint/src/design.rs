//! The modules of a design with the names that each declares, as rust-hdl's printer declares them.

use std::collections::BTreeMap;

use rust_hdl::prelude::{Atom, AtomKind, Block, Probe, TypeKind, Verilog, VerilogLiteral};

use super::finding::{Finding, Findings};
use super::keyword::is_usable_name;
use super::rule::Rule;

/// The role of a declared name in its module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// An input, or a wire that a child drives. Its change can trigger an `always @(*)`.
    Outside,
    /// An output, a local, or a child's input, which the module itself drives.
    Driven,
    Constant,
    Variant,
}

/// A declared name with its widths and value.
#[derive(Clone, Debug)]
pub(super) struct Symbol {
    pub(super) role: Role,
    /// The width in Rust.
    pub(super) width: usize,
    /// The width in the Verilog declaration.
    pub(super) declared: usize,
    pub(super) kind: TypeKind,
    /// The value of a constant or of an enum variant.
    pub(super) value: Option<u128>,
}

impl Symbol {
    pub(super) fn is_signed(&self) -> bool {
        matches!(self.kind, TypeKind::Signed(_))
    }
}

/// A block, which rust-hdl prints as a module.
pub(super) struct Module {
    pub(super) path: String,
    pub(super) hdl: Verilog,
    /// Every name that the module's text may use.
    pub(super) symbols: BTreeMap<String, Symbol>,
    /// The names of the block's own atoms and children.
    own: Vec<String>,
}

impl Module {
    /// Checks that the block's names are legal names in Verilog.
    pub(super) fn check_names(&self, findings: &mut Findings) {
        for name in self.own.iter().filter(|name| !is_usable_name(name)) {
            findings.add(Rule::KeywordName, &format!("field {name}"));
        }
    }

    /// Checks that a block without text has no signal to drive.
    pub(super) fn check_empty(&self, findings: &mut Findings) {
        let driven = |name: &&String| {
            self.symbols
                .get(*name)
                .is_some_and(|symbol| symbol.role == Role::Driven)
        };
        if let Some(name) = self.own.iter().find(driven) {
            findings.add(Rule::MissingHdl, &format!("field {name}"));
        }
    }
}

/// Lists all modules of a design, parents before children.
pub(super) fn modules(top: &dyn Block) -> Vec<Module> {
    let mut collector = Collector::default();
    top.accept("top", &mut collector);
    collector.modules
}

/// Finds the texts of cores that the printer would emit more than once.
pub(super) fn repeated_cores(modules: &[Module]) -> Vec<Finding> {
    let mut owners: BTreeMap<&str, &str> = BTreeMap::new();
    let mut list = Vec::new();
    for module in modules {
        let core = match &module.hdl {
            Verilog::Wrapper(wrapper) => wrapper.cores.trim(),
            Verilog::Blackbox(blackbox) => blackbox.code.trim(),
            _ => "",
        };
        if core.is_empty() {
            continue;
        }
        if let Some(first) = owners.insert(core, &module.path) {
            let mut findings = Findings::new(&module.path);
            findings.add(
                Rule::RepeatedCore,
                &format!("core already declared for {first}"),
            );
            list.extend(findings.into_vec());
        }
    }
    list
}

/// A visitor that walks the tree as rust-hdl's own `ModuleDefines` does, and makes the names that it makes.
#[derive(Default)]
struct Collector {
    modules: Vec<Module>,
    /// The open scopes: an index into `modules` and the scope's name.
    open: Vec<(usize, String)>,
    namespace: Vec<String>,
}

impl Collector {
    fn parent(&self) -> Option<usize> {
        self.open
            .len()
            .checked_sub(2)
            .map(|place| self.open[place].0)
    }

    fn declare_in_parent(&mut self, name: &str, signal: &dyn Atom) {
        let role = match signal.kind() {
            AtomKind::InputParameter => Role::Driven,
            AtomKind::OutputParameter | AtomKind::InOutParameter => Role::Outside,
            _ => return,
        };
        let Some((parent, (_, child))) = self.parent().zip(self.open.last()) else {
            return;
        };
        let name = format!("{child}${name}");
        self.modules[parent]
            .symbols
            .insert(name, symbol(signal, role));
    }
}

impl Probe for Collector {
    fn visit_start_scope(&mut self, name: &str, node: &dyn Block) {
        let path = match self.open.last() {
            Some((parent, _)) => {
                self.modules[*parent].own.push(name.to_owned());
                format!("{}${name}", self.modules[*parent].path)
            }
            None => name.to_owned(),
        };
        self.namespace.clear();
        self.open.push((self.modules.len(), name.to_owned()));
        self.modules.push(Module {
            path,
            hdl: node.hdl(),
            symbols: BTreeMap::new(),
            own: Vec::new(),
        });
    }

    fn visit_start_namespace(&mut self, name: &str, _node: &dyn Block) {
        self.namespace.push(name.to_owned());
    }

    fn visit_atom(&mut self, name: &str, signal: &dyn Atom) {
        let Some(&(module, _)) = self.open.last() else {
            return;
        };
        let mut parts = self.namespace.clone();
        parts.push(name.to_owned());
        let name = parts.join("$");
        let role = match signal.kind() {
            AtomKind::InputParameter | AtomKind::InOutParameter => Role::Outside,
            AtomKind::Constant => Role::Constant,
            _ => Role::Driven,
        };
        self.declare_in_parent(&name, signal);
        let kind = signal.descriptor().kind;
        for place in [Some(module), self.parent()].into_iter().flatten() {
            declare_variants(&mut self.modules[place].symbols, &kind, signal.bits());
        }
        self.modules[module]
            .symbols
            .insert(name.clone(), symbol(signal, role));
        self.modules[module].own.push(name);
    }

    fn visit_end_namespace(&mut self, _name: &str, _node: &dyn Block) {
        self.namespace.pop();
    }

    fn visit_end_scope(&mut self, _name: &str, _node: &dyn Block) {
        self.open.pop();
    }
}

fn symbol(signal: &dyn Atom, role: Role) -> Symbol {
    let literal = Literal::of(&signal.verilog());
    let constant = role == Role::Constant;
    Symbol {
        role,
        width: signal.bits(),
        declared: if constant {
            literal.bits
        } else {
            signal.bits()
        },
        kind: signal.descriptor().kind,
        value: literal.value.filter(|_| constant),
    }
}

/// Declares the variants of an enum, as the printer does: in the block that holds it and in its parent, as
/// plain (32-bit) numbers.
fn declare_variants(symbols: &mut BTreeMap<String, Symbol>, kind: &TypeKind, width: usize) {
    match kind {
        TypeKind::Enum(labels) => {
            for (value, label) in labels.iter().enumerate() {
                let variant = Symbol {
                    role: Role::Variant,
                    width,
                    declared: 32,
                    kind: kind.clone(),
                    value: Some(value as u128),
                };
                symbols.insert(label.replace("::", "$"), variant);
            }
        }
        TypeKind::Composite(fields) => {
            for field in fields {
                declare_variants(symbols, &field.kind.kind, type_width(&field.kind.kind));
            }
        }
        TypeKind::Bits(_) | TypeKind::Signed(_) => {}
    }
}

/// The width of a type in bits, from its description.
fn type_width(kind: &TypeKind) -> usize {
    match kind {
        TypeKind::Bits(width) | TypeKind::Signed(width) => *width,
        TypeKind::Enum(labels) => labels.len().next_power_of_two().trailing_zeros() as usize,
        TypeKind::Composite(fields) => fields.iter().map(|f| type_width(&f.kind.kind)).sum(),
    }
}

/// A literal as the printer prints it. Its fields are private in rust-hdl.
pub(super) struct Literal {
    pub(super) bits: usize,
    /// The value, if it is not negative and fits `u128`.
    pub(super) value: Option<u128>,
}

impl Literal {
    pub(super) fn of(literal: &VerilogLiteral) -> Self {
        let text = format!("{literal:x}");
        let (bits, digits) = text.split_once("'h").unwrap_or(("32", &text));
        Literal {
            bits: bits.parse().unwrap_or(32),
            value: u128::from_str_radix(digits, 16).ok(),
        }
    }
}
