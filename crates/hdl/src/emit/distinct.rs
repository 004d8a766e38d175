//! Finds the different blocks of a design and prints each once.
//!
//! rust-hdl prints a module for each *instance*: 24,000 modules and 20 MB for `tile-10`, of which a few hundred differ.

use std::collections::HashMap;

use rust_hdl::prelude::{
    Atom, AtomKind, Block, Logic, ModuleDefines, PinConstraint, Probe, TypeDescriptor, VCDValue,
    Verilog, VerilogLiteral,
};

use super::merge::{Printed, order};
use super::modules::split;

/// The different blocks of a design, children before parents.
pub(super) fn distinct(top: &dyn Block, name: &str) -> Vec<Distinct> {
    let mut collector = Collector::default();
    top.accept(name, &mut collector);
    collector.blocks
}

/// A block with all its equals. Blocks are equal if their statements, signals and children are; they print equal modules,
/// but for their paths.
pub(super) struct Distinct {
    /// The first of the paths of the equal blocks, in [`order`].
    path: String,
    /// The name of the block with that path in its parent.
    instance: String,
    hdl: Verilog,
    parts: Vec<Part>,
}

/// What a block declares, in the order of its fields.
#[derive(Debug)]
enum Part {
    Signal(Declared),
    /// A child, by its name and its number among the different blocks.
    Child(String, usize),
}

impl Distinct {
    /// The module that rust-hdl prints for the block.
    pub(super) fn module(&self, blocks: &[Self]) -> Printed {
        let mut printer = ModuleDefines::default();
        let statements = Statements(&self.hdl);
        let mut children = Vec::new();
        printer.visit_start_scope(&self.path, &statements);
        for part in &self.parts {
            match part {
                Part::Signal(signal) => printer.visit_atom(&signal.name, signal),
                Part::Child(name, number) => {
                    let child = &blocks[*number];
                    child.declare(name, &mut printer);
                    children.push((format!("{}${name}", self.path), child.path.clone()));
                }
            }
        }
        printer.visit_end_scope(&self.path, &statements);
        let modules = split(&printer.defines());
        let own = modules.into_iter().find(|module| module.name == self.path);
        Printed {
            body: own.expect("it is printed").body,
            path: self.path.clone(),
            instance: self.instance.clone(),
            children,
        }
    }

    /// Declares the block as a child: its parent's module has its name and its signals. Its statements are read only where it
    /// is a black box, which has a name of its own.
    fn declare(&self, name: &str, printer: &mut ModuleDefines) {
        let own = match &self.hdl {
            black_box @ Verilog::Blackbox(_) => Statements(black_box),
            _ => Statements(&Verilog::Empty),
        };
        printer.visit_start_scope(name, &own);
        for part in &self.parts {
            if let Part::Signal(signal) = part {
                printer.visit_atom(&signal.name, signal);
            }
        }
        printer.visit_end_scope(name, &own);
    }
}

/// A visitor that walks the tree as [`ModuleDefines`] does.
#[derive(Default)]
struct Collector {
    /// The blocks that were entered and not left: each is the parent of the next.
    open: Vec<Distinct>,
    /// The number of a block by the text of its statements and parts.
    numbers: HashMap<String, usize>,
    blocks: Vec<Distinct>,
}

impl Probe for Collector {
    fn visit_start_scope(&mut self, name: &str, node: &dyn Block) {
        let path = match self.open.last() {
            Some(parent) => format!("{}${name}", parent.path),
            None => name.to_owned(),
        };
        self.open.push(Distinct {
            path,
            instance: name.to_owned(),
            hdl: node.hdl(),
            parts: Vec::new(),
        });
    }

    fn visit_start_namespace(&mut self, name: &str, _node: &dyn Block) {
        unreachable!("{name} is an interface, and blocks have plain signals");
    }

    fn visit_atom(&mut self, name: &str, signal: &dyn Atom) {
        let parent = self.open.last_mut().expect("a signal is in a block");
        parent.parts.push(Part::Signal(Declared::of(name, signal)));
    }

    fn visit_end_scope(&mut self, _name: &str, _node: &dyn Block) {
        let block = self.open.pop().expect("it was entered");
        let instance = block.instance.clone();
        let number = self.number(block);
        if let Some(parent) = self.open.last_mut() {
            parent.parts.push(Part::Child(instance, number));
        }
    }
}

impl Collector {
    /// The number of the block, which is a new one if none equals it.
    fn number(&mut self, block: Distinct) -> usize {
        let next = self.blocks.len();
        let key = format!("{:?} {:?}", block.hdl, block.parts);
        let number = *self.numbers.entry(key).or_insert(next);
        match self.blocks.get_mut(number) {
            None => self.blocks.push(block),
            Some(known) => {
                if order(&block.path) < order(&known.path) {
                    (known.path, known.instance) = (block.path, block.instance);
                }
            }
        }
        number
    }
}

/// The declaration of a signal or constant.
#[derive(Debug)]
struct Declared {
    name: String,
    kind: AtomKind,
    bits: usize,
    descriptor: TypeDescriptor,
    verilog: VerilogLiteral,
}

impl Declared {
    fn of(name: &str, signal: &dyn Atom) -> Self {
        Self {
            name: name.to_owned(),
            kind: signal.kind(),
            bits: signal.bits(),
            descriptor: signal.descriptor(),
            verilog: signal.verilog(),
        }
    }
}

/// The printer reads what is declared, and nothing of a signal's state.
impl Atom for Declared {
    fn bits(&self) -> usize {
        self.bits
    }
    fn connected(&self) -> bool {
        true
    }
    fn changed(&self) -> bool {
        false
    }
    fn kind(&self) -> AtomKind {
        self.kind
    }
    fn descriptor(&self) -> TypeDescriptor {
        self.descriptor.clone()
    }
    fn vcd(&self) -> VCDValue {
        VCDValue::String(String::new())
    }
    fn id(&self) -> usize {
        0
    }
    fn verilog(&self) -> VerilogLiteral {
        self.verilog.clone()
    }
    fn constraints(&self) -> Vec<PinConstraint> {
        Vec::new()
    }
}

/// A block of which the printer reads the statements alone.
struct Statements<'a>(&'a Verilog);

impl Logic for Statements<'_> {
    fn update(&mut self) {}
    fn hdl(&self) -> Verilog {
        self.0.clone()
    }
}

impl Block for Statements<'_> {
    fn connect_all(&mut self) {}
    fn update_all(&mut self) {}
    fn has_changed(&self) -> bool {
        false
    }
    fn accept(&self, _name: &str, _probe: &mut dyn Probe) {}
}

#[cfg(test)]
mod tests {
    use rust_hdl::prelude::*;

    use super::*;

    /// Stores its input, with the bits of a constant inverted.
    #[derive(LogicBlock)]
    struct Step {
        clock: Signal<In, Clock>,
        a: Signal<In, Bits<8>>,
        y: Signal<Out, Bits<8>>,
        stored: DFF<Bits<8>>,
        inverted: Constant<Bits<8>>,
    }

    impl Logic for Step {
        #[hdl_gen]
        fn update(&mut self) {
            dff_setup!(self, clock, stored);
            self.stored.d.next = self.a.val() ^ self.inverted.val();
            self.y.next = self.stored.q.val();
        }
    }

    fn step(inverted: u8) -> Step {
        Step {
            clock: Signal::default(),
            a: Signal::default(),
            y: Signal::default(),
            stored: DFF::default(),
            inverted: Constant::new(inverted.to_bits()),
        }
    }

    #[derive(LogicBlock)]
    struct Steps {
        clock: Signal<In, Clock>,
        a: Signal<In, Bits<8>>,
        y: Signal<Out, Bits<8>>,
        steps: [Step; 2],
        other: Step,
    }

    impl Logic for Steps {
        #[hdl_gen]
        fn update(&mut self) {
            self.steps[0].a.next = self.a.val();
            self.steps[1].a.next = self.steps[0].y.val();
            self.other.a.next = self.steps[1].y.val();
            self.y.next = self.other.y.val();
            self.steps[0].clock.next = self.clock.val();
            self.steps[1].clock.next = self.clock.val();
            self.other.clock.next = self.clock.val();
        }
    }

    fn steps() -> Steps {
        let mut steps = Steps {
            clock: Signal::default(),
            a: Signal::default(),
            y: Signal::default(),
            steps: [step(1), step(1)],
            other: step(5),
        };
        steps.connect_all();
        steps
    }

    #[test]
    fn equal_blocks_are_one_and_a_constant_tells_blocks_apart() {
        let blocks = distinct(&steps(), "top");
        let paths: Vec<_> = blocks.iter().map(|block| block.path.as_str()).collect();
        let expected = ["top$steps$0$stored", "top$steps$0", "top$other", "top"];
        assert_eq!(paths, expected);
        let child = |name: &str, printed: &str| (format!("top${name}"), format!("top${printed}"));
        assert_eq!(
            blocks[3].module(&blocks).children,
            [
                child("steps$0", "steps$0"),
                child("steps$1", "steps$0"),
                child("other", "other"),
            ]
        );
    }

    #[test]
    fn a_block_is_printed_as_rust_hdl_prints_it_in_its_design() {
        let steps = steps();
        let mut printer = ModuleDefines::default();
        steps.accept("top", &mut printer);
        let whole = split(&printer.defines());
        assert_eq!(whole.len(), 7);
        let blocks = distinct(&steps, "top");
        for block in &blocks {
            let module = block.module(&blocks);
            let in_design = whole.iter().find(|other| other.name == module.path);
            assert_eq!(module.body, in_design.unwrap().body);
        }
    }
}
