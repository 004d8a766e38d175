//! What always holds of a machine's registers: the bits that are constant at an address of its program.
//!
//! Which these are is guessed from the golden model's run and then proven of the emitted Verilog by induction: they
//! hold at power-up, and where they hold they hold one clock later. A guess that is refuted by a counterexample is
//! weakened by it, until the rest is proven.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::process::Command;

use photoncube_hdl::Emitted;
use photoncube_spec::{Machine, SignalPlace};

use super::design::{FLAT, read, yosys};
use super::netlist::Netlist;
use crate::device::{DeviceError, scratch_folder, write_file};
use crate::stimulus::Block;
use crate::tools::{Tool, run};

/// Counterexamples after which a guess is given up: each weakens it by a bit at least, most by many.
const MOST_ROUNDS: usize = 300;

/// The most flags whose triples are looked at: there are 8 for each.
const MOST_NEAR: usize = 12;

/// From the modules to the flat wrapper, which stands in `wrapper.sv`.
pub(super) const WRAPPED: &str = "read_verilog -formal -sv wrapper.sv\nhierarchy -top wrapper\nproc\n\
                                  flatten\nopt -full";

/// The values of a register at an address.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
struct Values {
    /// All of them, or-ed.
    any: u64,
    /// All of them, and-ed.
    all: u64,
}

/// Registers of one bit, and what they never hold together.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Never(Vec<(usize, u64)>);

impl Never {
    fn is_refuted_by(&self, row: &[u64]) -> bool {
        self.0
            .iter()
            .all(|&(register, value)| row[register] == value)
    }
}

/// Any value at all.
const UNKNOWN: Values = Values {
    any: u64::MAX,
    all: 0,
};

/// The design whose registers are ports, and what is known of these.
pub(super) struct Invariants {
    /// The design in Yosys's own language, as module `gold`.
    gold: String,
    netlist: Netlist,
    /// The paths of the registers, and whether Yosys has a port for each.
    registers: Vec<String>,
    /// The register that says where the program is.
    address: Option<usize>,
    /// For each address what its registers hold.
    known: BTreeMap<u64, Vec<Values>>,
    /// The most photons that a query may have: whoever drives the machine keeps to it, so this is not proven.
    max_photons: u64,
    /// What flags never hold together; only of machines without a program, whose flags say where the work is.
    never: Vec<Never>,
}

impl Invariants {
    /// Guesses and proves them.
    ///
    /// # Errors
    /// Yosys does not run.
    pub fn new(machine: &Machine, design: &Emitted, blocks: &[Block]) -> Result<Self, DeviceError> {
        let folder = scratch_folder()?;
        let script = format!(
            "{FLAT}\nrename {} gold\nexpose -evert-dff -dff gold\nopt_clean\n\
             write_ilang gold.il\nwrite_json gold.json",
            design.top
        );
        yosys(folder.path(), design, &script)?;
        let json = read(&folder.path().join("gold.json"))?;
        let registers = design.pins.observed[design.pins.outputs..].iter();
        let is_address = |place| {
            matches!(
                place,
                SignalPlace::Control(0) | SignalPlace::OverlapControl(0)
            )
        };
        let mut invariants = Self {
            gold: read(&folder.path().join("gold.il"))?,
            netlist: Netlist::parse(&json, "gold")?,
            address: registers.clone().position(|pin| is_address(pin.place)),
            registers: design.register_paths.clone(),
            known: BTreeMap::new(),
            max_photons: machine.max_photons(),
            never: Vec::new(),
        };
        invariants.guess(design, blocks);
        invariants.settle()?;
        Ok(invariants)
    }

    fn guess(&mut self, design: &Emitted, blocks: &[Block]) {
        let (columns, outputs) = (design.pins.observed.len(), design.pins.outputs);
        let flag = |index: &usize| design.pins.observed[outputs + index].width == 1;
        let flags: Vec<_> = (0..columns - outputs).filter(flag).collect();
        let start = vec![0; columns - outputs];
        let rows = || {
            let rows = blocks.iter().flat_map(|b| b.expected.chunks_exact(columns));
            rows.map(|row| &row[outputs..]).chain([&start[..]])
        };
        if self.address.is_none() {
            self.never = all_combinations(&flags, 2);
        }
        for row in rows() {
            self.weaken(row);
        }
        if self.address.is_none() {
            let mut near = self.near_constants(&flags);
            for row in rows() {
                near.retain(|never| !never.is_refuted_by(row));
            }
            self.never.extend(near);
        }
        self.join_after_reset();
    }

    /// Triples of the flags that those which stand still depend on, at one or two clocks' distance: what keeps them still.
    fn near_constants(&self, flags: &[usize]) -> Vec<Never> {
        let is_constant = |flag: &&usize| {
            let mut values = self.known.values().map(|known| known[**flag]);
            values.all(|values| values.any == values.all)
        };
        let mut near = Vec::new();
        for &flag in flags.iter().filter(is_constant) {
            let first = self.flags_before(flag, flags);
            let second = first
                .iter()
                .flat_map(|&flag| self.flags_before(flag, flags));
            let all: BTreeSet<_> = first.iter().copied().chain(second).collect();
            let all: Vec<_> = all.into_iter().collect();
            if all.len() <= MOST_NEAR {
                near.extend(all_combinations(&all, 3));
            }
        }
        near
    }

    /// The flags that a flag's next value depends on.
    fn flags_before(&self, flag: usize, flags: &[usize]) -> Vec<usize> {
        let inputs = self.netlist.fan_in(&format!("{}.d", self.registers[flag]));
        let is_input =
            |flag: &usize| inputs.contains(format!("{}.q", self.registers[*flag]).as_str());
        flags.iter().copied().filter(is_input).collect()
    }

    /// A reset may come anywhere: at the first address is what may be at any.
    fn join_after_reset(&mut self) {
        let all = self.known.clone();
        let Some(first) = self.known.get_mut(&0) else {
            return;
        };
        for known in all.values() {
            for (first, values) in first.iter_mut().zip(known) {
                first.any |= values.any;
                first.all &= values.all;
            }
        }
        if let Some(address) = self.address {
            first[address] = Values { any: 0, all: 0 };
        }
    }

    /// Takes note of what the registers may hold; whether that is news.
    fn weaken(&mut self, row: &[u64]) -> bool {
        let pairs = self.never.len();
        self.never.retain(|never| !never.is_refuted_by(row));
        let address = self.address.map_or(0, |index| row[index]);
        let fresh = row.iter().map(|&value| Values {
            any: value,
            all: value,
        });
        let Some(known) = self.known.get_mut(&address) else {
            self.known.insert(address, fresh.collect());
            return true;
        };
        let before = known.clone();
        for (known, value) in known.iter_mut().zip(row) {
            known.any |= value;
            known.all &= value;
        }
        before != *known || pairs != self.never.len()
    }

    /// Takes note of a counterexample; whether it is one. What it refutes is given up, not cut down bit by bit, and so
    /// is the same guess of the same register at other addresses.
    fn give_up(&mut self, row: &[u64]) -> bool {
        let address = self.address.map_or(0, |index| row[index]);
        let Some(before) = self.known.get(&address).cloned() else {
            return self.weaken(row);
        };
        if !self.weaken(row) {
            return false;
        }
        let refuted: Vec<_> = self.known[&address]
            .iter()
            .zip(&before)
            .map(|(known, before)| known != before)
            .collect();
        for (at, known) in &mut self.known {
            for (index, values) in known.iter_mut().enumerate() {
                let is_same = *at == address || *values == before[index];
                if refuted[index] && is_same {
                    *values = UNKNOWN;
                }
            }
        }
        true
    }

    /// Weakens the guess until it is proven.
    fn settle(&mut self) -> Result<(), DeviceError> {
        for _ in 0..MOST_ROUNDS {
            let Some(row) = self.counterexample()? else {
                return Ok(());
            };
            if !self.give_up(&row) {
                break;
            }
        }
        Err(DeviceError::BrokeOff {
            device: "yosys".to_owned(),
            message: format!(
                "no invariant of the registers was proven with {MOST_ROUNDS} counterexamples"
            ),
        })
    }

    /// Registers after a clock in which what is known held before and does not hold after it.
    fn counterexample(&self) -> Result<Option<Vec<u64>>, DeviceError> {
        let folder = scratch_folder()?;
        write_file(&folder.path().join("gold.il"), &self.gold)?;
        let mut text = self.wrapper("gold", "");
        let _ = writeln!(text, "  always @* assert({});\nendmodule", self.holds("d"));
        write_file(&folder.path().join("wrapper.sv"), &text)?;
        let solve = "tee -o found.txt sat -set-assumes -prove-asserts -show-ports wrapper";
        let script = format!("read_ilang gold.il\n{WRAPPED}\n{solve}\n");
        write_file(&folder.path().join("script.ys"), &script)?;
        run(Command::new(Tool::Yosys.find()?)
            .current_dir(folder.path())
            .args(["-q", "script.ys"]))?;
        let found = read(&folder.path().join("found.txt"))?;
        if found.contains("SAT proof finished - no model found: SUCCESS!") {
            return Ok(None);
        }
        let row = (0..self.registers.len()).map(|index| {
            let next = self.register(index, "d");
            next.map_or(0, |(port, _)| shown_value(&found, &port))
        });
        Ok(Some(row.collect()))
    }

    /// The number of a port in the wrapper.
    fn port_number(&self, name: &str) -> usize {
        self.netlist
            .ports
            .keys()
            .position(|port| port == name)
            .unwrap_or(0)
    }

    /// A module `wrapper` up to its last lines, with all inputs of a module as ports, and what is known assumed.
    pub fn wrapper(&self, module: &str, prefix: &str) -> String {
        let ports = self.netlist.ports.iter().enumerate();
        let inputs: Vec<_> = ports
            .filter(|(_, (_, port))| port.direction == "input" || prefix.is_empty())
            .collect();
        let declared = inputs.iter().map(|(number, (_, port))| {
            let (direction, high) = (&port.direction, port.width() - 1);
            format!("  {direction} [{high}:0] p{number}")
        });
        let connected = inputs
            .iter()
            .map(|(number, (name, _))| format!("    .\\{prefix}{name} (p{number})"));
        format!(
            "module wrapper(\n{}\n);\n  {module} inside(\n{}\n  );\n  always @* assume({}{});\n",
            declared.collect::<Vec<_>>().join(",\n"),
            connected.collect::<Vec<_>>().join(",\n"),
            self.holds("q"),
            self.declared_count()
        )
    }

    /// That the register of the result's count has no bit above those of the most photons; Yosys names it as the pin
    /// that it drives.
    fn declared_count(&self) -> String {
        let Some(port) = self.netlist.ports.get("result_count.q") else {
            return String::new();
        };
        let above = (self.max_photons.ilog2() + 1) as usize;
        let (number, bits) = (self.port_number("result_count.q"), port.width());
        match above < bits {
            true => format!(" && p{number}[{}:{above}] == 0", bits - 1),
            false => String::new(),
        }
    }

    /// What is known, of the registers as they are (`q`) or as they will be (`d`).
    fn holds(&self, when: &str) -> String {
        let at = |(address, known): (&u64, &Vec<Values>)| {
            let mut terms = Vec::new();
            let address_port = self.address.and_then(|index| self.register(index, when));
            if let Some((port, bits)) = address_port {
                terms.push(format!("{port} == {bits}'d{address}"));
            }
            for (index, values) in known.iter().enumerate() {
                let Some((port, bits)) = self.register(index, when) else {
                    continue;
                };
                let never = !values.any & (u64::MAX >> (u64::BITS - bits));
                if never != 0 {
                    terms.push(format!("({port} & {bits}'d{never}) == 0"));
                }
                if values.all != 0 {
                    terms.push(format!("(~{port} & {bits}'d{}) == 0", values.all));
                }
            }
            format!("({})", terms.join(" && "))
        };
        let cases: Vec<_> = self.known.iter().map(at).collect();
        let mut all = vec![format!("({})", cases.join(" || "))];
        all.extend(self.never.iter().filter_map(|never| {
            let literals: Option<Vec<_>> = never
                .0
                .iter()
                .map(|&(register, value)| {
                    let (port, _) = self.register(register, when)?;
                    Some(format!("{port} == 1'd{value}"))
                })
                .collect();
            Some(format!("!({})", literals?.join(" && ")))
        }));
        all.join(" && ")
    }

    /// The wrapper's name of a register, with its width.
    fn register(&self, index: usize, when: &str) -> Option<(String, u32)> {
        let name = format!("{}.{when}", self.registers[index]);
        let port = self.netlist.ports.get(&name)?;
        let bits = u32::try_from(port.width()).ok()?;
        Some((format!("p{}", self.port_number(&name)), bits))
    }
}

/// All values of each so many registers.
fn all_combinations(registers: &[usize], count: usize) -> Vec<Never> {
    if count == 0 {
        return vec![Never(Vec::new())];
    }
    let mut all = Vec::new();
    for (index, &register) in registers.iter().enumerate() {
        for rest in all_combinations(&registers[..index], count - 1) {
            for value in [0, 1] {
                let literals = [&rest.0[..], &[(register, value)]].concat();
                all.push(Never(literals));
            }
        }
    }
    all
}

/// The value of a port in Yosys's table: name, decimal, hexadecimal, binary; 0 where it is not shown.
fn shown_value(table: &str, port: &str) -> u64 {
    let name = format!("\\{port}");
    let line = table
        .lines()
        .map(|line| line.split_whitespace().collect::<Vec<_>>())
        .find(|words| words.first().is_some_and(|word| *word == name));
    let bits = line.and_then(|words| words.last().copied());
    bits.and_then(|bits| u64::from_str_radix(&bits.replace('x', "0"), 2).ok())
        .unwrap_or(0)
}
