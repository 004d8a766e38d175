//! Invariants of a machine's registers: bits that are constant at a place of its program.
//!
//! They are guessed from a run of the golden model, then proven of the emitted Verilog by induction: they
//! hold at power-up, and if they hold, they hold one clock later. A guess that a counterexample refutes is
//! dropped, until the remaining guesses are proven.

mod followers;
mod relations;
mod wrapper;

use std::collections::{BTreeMap, BTreeSet};

use fpga_flow::Netlist;
use fpga_flow::netlist::{Module, Port};
use photoncube_hdl::Emitted;
use photoncube_spec::{Machine, Register, Role, SEQUENTIAL, SignalPlace, Step, Widths};

use followers::Followers;
use relations::Relation;

use super::design::{FLAT, read, run, yosys};
use super::kill::Kills;
use crate::device::{DeviceError, scratch_folder, write_file};
use crate::verify::VerifyError;

/// The number of rounds of counterexamples after which guesses are dropped.
const MOST_ROUNDS: usize = 100;

/// The number of counterexamples of a round. Yosys needs seconds to read the design, and less than one to
/// find another counterexample.
const MOST_AT_ONCE: usize = 256;

/// The most bits of a control block's register of which each value is considered.
const SMALL: u32 = 4;

/// The registers of a control block that show the place of the program: the next address, whether a result
/// waits, and in an overlapped machine the current control word, which shows the previous place.
const PLACE: [&str; 3] = ["control_address", "control_done", "control_word_x"];

/// The most flags whose triples are considered; each triple has 8 combinations.
const MOST_NEAR: usize = 12;

/// Commands that make the flat wrapper from the modules; the wrapper is in `wrapper.sv`.
const AROUND: &str = "read_verilog -formal -sv wrapper.sv\nhierarchy -top wrapper\nproc\nchformal -lower\nflatten\nopt_clean";

/// [`AROUND`] for a comparison of two designs, which also merges the logic that both share.
pub(super) fn around_two() -> String {
    AROUND.replace("opt_clean", "opt -full")
}

/// The values of a register at a place of the program.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
struct Values {
    /// The OR of all values.
    any: u64,
    /// The AND of all values.
    all: u64,
    /// The largest value.
    largest: u64,
}

/// A combination of values of small registers that never occurs.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Never(Vec<(usize, u64)>);

impl Never {
    fn is_refuted_by(&self, row: &[u64]) -> bool {
        self.0
            .iter()
            .all(|&(register, value)| row[register] == value)
    }
}

/// The guesses that a counterexample refutes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Refuted {
    /// The place of the program in the counterexample.
    place: u64,
    /// The registers whose bits at this place were guessed wrong.
    bits: Vec<usize>,
    /// The registers whose largest value at this place was guessed wrong.
    largest: Vec<usize>,
    /// The guesses of combinations that occur, by number; the numbers of relations follow.
    never: Vec<usize>,
}

/// A register of which nothing is known.
const UNKNOWN: Values = Values {
    any: u64::MAX,
    all: 0,
    largest: u64::MAX,
};

/// The design with its registers as ports, and the guesses about them.
pub(super) struct Invariants {
    /// The design in Yosys's own language, as module `gold`.
    gold: String,
    netlist: Netlist,
    /// The ports of `gold`, by name.
    ports: BTreeMap<String, Port>,
    /// The paths of the registers, and whether Yosys has a port for each.
    registers: Vec<String>,
    /// The registers' names as pins.
    names: Vec<String>,
    /// The registers of [`PLACE`] that the machine has; empty for machines without a program.
    place: Vec<usize>,
    /// For each place, which is the values of the `place` registers in a row: the values of all registers.
    known: BTreeMap<u64, Vec<Values>>,
    /// The ports of a query's sums, each with the number of bits that the most photons of a query need. The
    /// driver of the machine ensures that a query has no more photons, so this is assumed and not proven.
    declared: BTreeMap<String, u32>,
    /// The addresses of the steps that read a group which an earlier step has read.
    reads_again: Vec<usize>,
    /// Combinations that never occur: of small registers of the control block, or of all flags in machines
    /// without a program.
    never: Vec<Never>,
    /// Relations between registers of a photon memory or of a comparison of boxes.
    relations: Vec<Relation>,
    /// In machines without a program, the flags that follow others.
    followers: Followers,
}

/// The design in its netlist.
fn gold(netlist: &Netlist) -> Result<Module<'_>, DeviceError> {
    Ok(netlist.module("gold")?)
}

impl Invariants {
    /// Guesses the invariants and proves them.
    ///
    /// # Errors
    /// Yosys does not run, or the two readings of the golden model differ.
    pub fn new(
        machine: &Machine,
        design: &Emitted,
        kills: &Kills<'_>,
    ) -> Result<Self, VerifyError> {
        let folder = scratch_folder()?;
        let script = format!(
            "{FLAT}\nrename {} gold\nexpose -evert-dff -dff gold\nopt_clean\n\
             write_rtlil gold.il\nwrite_json gold.json",
            design.top
        );
        yosys(folder.path(), design, &script)?;
        let json = read(&folder.path().join("gold.json"))?;
        let netlist = Netlist::parse(&json).map_err(DeviceError::from)?;
        let registers = design.pins.observed[design.pins.outputs..].iter();
        let mut invariants = Self {
            gold: read(&folder.path().join("gold.il"))?,
            ports: gold(&netlist)?
                .ports()
                .into_iter()
                .map(|port| (port.name.clone(), port))
                .collect(),
            netlist,
            place: PLACE
                .iter()
                .filter_map(|name| registers.clone().position(|pin| pin.name == *name))
                .collect(),
            registers: design.register_paths.clone(),
            names: registers.clone().map(|pin| pin.name.clone()).collect(),
            known: BTreeMap::new(),
            declared: declared(machine, design),
            reads_again: reads_again(machine),
            never: Vec::new(),
            relations: Relation::of(machine),
            followers: Followers::default(),
        };
        let is_known = |relation| invariants.of(relation, "q").is_some();
        assert!(
            invariants.relations.iter().all(is_known),
            "a relation names no register of the design"
        );
        invariants.guess(design, kills)?;
        invariants.forget_largest(Widths::of(machine).work);
        invariants.settle()?;
        Ok(invariants)
    }

    fn guess(&mut self, design: &Emitted, kills: &Kills<'_>) -> Result<(), VerifyError> {
        let blocks = kills.blocks();
        let (columns, outputs) = (design.pins.observed.len(), design.pins.outputs);
        let pin = |index: usize| &design.pins.observed[outputs + index];
        let of_control = |index: usize| matches!(pin(index).place, SignalPlace::Control(_));
        let registers = (0..columns - outputs).map(|index| (index, pin(index).width));
        let flags: Vec<_> = registers.clone().filter(|(_, bits)| *bits == 1).collect();
        let start = vec![0; columns - outputs];
        let rows = || {
            let rows = blocks.iter().flat_map(|b| b.expected.chunks_exact(columns));
            rows.map(|row| &row[outputs..]).chain([&start[..]])
        };
        // A program shows the place of the work, except for the control block's own registers.
        self.never = match self.place.is_empty() {
            true => all_combinations(&flags, 2),
            false => {
                let small = |&(index, bits): &(usize, u32)| of_control(index) && bits <= SMALL;
                all_combinations(&registers.filter(small).collect::<Vec<_>>(), 3)
            }
        };
        for row in rows() {
            self.weaken(row);
        }
        kills.more_rows(&mut |row| self.weaken(&row[outputs..]))?;
        if self.place.is_empty() {
            let before = |&(flag, _): &(usize, u32)| {
                let before = self.flags_before(flag, &flags).into_iter();
                let before = before.map(|(flag, _)| flag);
                // A reset also passes from stage to stage; flags that it clears are followers all the same.
                let is_reset = |flag: &usize| self.names[*flag].contains("reset");
                (flag, before.filter(|flag| !is_reset(flag)).collect())
            };
            self.followers = Followers::of(flags.iter().map(before));
            let mut near = self.near_constants(&flags);
            let mut weaken = |row: &[u64]| near.retain(|never: &Never| !never.is_refuted_by(row));
            rows().for_each(&mut weaken);
            kills.more_rows(&mut |row| weaken(&row[outputs..]))?;
            self.never.extend(near);
        }
        self.join_after_reset(&of_control);
        Ok(())
    }

    /// Candidate invariants over triples of flags in the fan-in (1 or 2 clocks back) of constant flags.
    fn near_constants(&self, flags: &[(usize, u32)]) -> Vec<Never> {
        let is_constant = |(flag, _): &&(usize, u32)| {
            let mut values = self.known.values().map(|known| known[*flag]);
            values.all(|values| values.any == values.all)
        };
        let mut near = Vec::new();
        for &(flag, _) in flags.iter().filter(is_constant) {
            let first = self.flags_before(flag, flags);
            let second = first
                .iter()
                .flat_map(|&(flag, _)| self.flags_before(flag, flags));
            let all: BTreeSet<_> = first.iter().copied().chain(second).collect();
            let all: Vec<_> = all.into_iter().collect();
            if all.len() <= MOST_NEAR {
                near.extend(all_combinations(&all, 3));
            }
        }
        near
    }

    /// The flags that a flag's next value depends on.
    fn flags_before(&self, flag: usize, flags: &[(usize, u32)]) -> Vec<(usize, u32)> {
        let output = format!("{}.d", self.registers[flag]);
        let inputs = gold(&self.netlist)
            .expect("its ports were read")
            .fan_in(&output);
        let is_input =
            |(flag, _): &(usize, u32)| inputs.contains(&format!("{}.q", self.registers[*flag]));
        flags.iter().copied().filter(is_input).collect()
    }

    /// Adds the values after a reset, which may occur at any place: at the first place, the cells' registers
    /// may hold the values of every place. The run has shown the control block after resets.
    fn join_after_reset(&mut self, of_control: &dyn Fn(usize) -> bool) {
        let all = self.known.clone();
        let Some(first) = self.known.get_mut(&0) else {
            return;
        };
        for known in all.values() {
            for (index, (first, values)) in first.iter_mut().zip(known).enumerate() {
                if !of_control(index) {
                    first.any |= values.any;
                    first.all &= values.all;
                    first.largest = first.largest.max(values.largest);
                }
            }
        }
    }

    /// The place of the program in a row.
    fn place_of(&self, row: &[u64]) -> u64 {
        let place = self.place.iter();
        place.fold(0, |place, &index| {
            let bits = self.register(index, "q").map_or(0, |(_, bits)| bits);
            place << bits | row[index]
        })
    }

    /// Extends the guesses so that they allow the values in a row.
    fn weaken(&mut self, row: &[u64]) {
        self.never.retain(|never| !never.is_refuted_by(row));
        let place = self.place_of(row);
        let fresh = row.iter().map(|&value| Values {
            any: value,
            all: value,
            largest: value,
        });
        let Some(known) = self.known.get_mut(&place) else {
            self.known.insert(place, fresh.collect());
            return;
        };
        for (known, value) in known.iter_mut().zip(row) {
            known.any |= value;
            known.all &= value;
            known.largest = known.largest.max(*value);
        }
    }

    /// Drops the largest values of registers of more than `most_bits` bits, which are no sums of squares: the
    /// run reached these values by chance.
    fn forget_largest(&mut self, most_bits: u32) {
        for values in self.known.values_mut().flatten() {
            if self.place.is_empty() || values.largest >> most_bits != 0 {
                values.largest = UNKNOWN.largest;
            }
        }
    }

    /// Weakens the guesses until they are proven.
    fn settle(&mut self) -> Result<(), DeviceError> {
        for _ in 0..MOST_ROUNDS {
            let found = self.counterexamples()?;
            if found.is_empty() {
                return Ok(());
            }
            self.give_up(&found);
        }
        Err(DeviceError::BrokeOff {
            device: "yosys".to_owned(),
            message: format!(
                "no invariant of the registers was proven in {MOST_ROUNDS} rounds of counterexamples"
            ),
        })
    }

    /// Drops the guesses that a counterexample refutes. The guess of a register's bits is dropped as a whole
    /// and at all places, and so are the guesses of flags that follow a refuted pair. A largest value is
    /// dropped only at the place at which it was refuted.
    fn give_up(&mut self, found: &[Refuted]) {
        let mut refuted_never: BTreeSet<usize> = BTreeSet::new();
        for refuted in found {
            refuted_never.extend(&refuted.never);
            let Some(before) = self.known.get(&refuted.place).cloned() else {
                let anything = vec![UNKNOWN; self.registers.len()];
                self.known.insert(refuted.place, anything);
                continue;
            };
            for &index in &refuted.bits {
                let Values { any, all, .. } = before[index];
                let known = self.known.values_mut().map(|known| &mut known[index]);
                for values in known.filter(|values| (values.any, values.all) == (any, all)) {
                    (values.any, values.all) = (UNKNOWN.any, UNKNOWN.all);
                }
            }
            for &index in &refuted.largest {
                if let Some(known) = self.known.get_mut(&refuted.place) {
                    known[index].largest = UNKNOWN.largest;
                }
            }
        }
        let never = self.never.len();
        let (pairs, relations): (Vec<_>, Vec<_>) =
            refuted_never.iter().partition(|&&index| index < never);
        let pairs = pairs.into_iter().map(|&index| self.never[index].clone());
        let given_up = self.followers.behind(pairs);
        self.never.retain(|never| !given_up.contains(never));
        let mut index = never..;
        self.relations.retain(|_| {
            let index = index.next().expect("a number follows each");
            !relations.contains(&&index)
        });
    }

    /// Counterexamples: the guesses hold before a clock and not after it.
    fn counterexamples(&self) -> Result<Vec<Refuted>, DeviceError> {
        let folder = scratch_folder()?;
        write_file(&folder.path().join("gold.il"), &self.gold)?;
        write_file(&folder.path().join("wrapper.sv"), &self.refutation())?;
        let script = format!(
            "read_rtlil gold.il\n{AROUND}\ntee -o found.txt sat -set-assumes -set broken 1 \
             -max {MOST_AT_ONCE} -show refuted -show place wrapper\n"
        );
        run(folder.path(), &script)?;
        let said = read(&folder.path().join("found.txt"))?;
        let found: Vec<_> = models(&said)
            .into_iter()
            .map(|model| self.refuted_in(&model))
            .collect();
        match found.is_empty() && !said.contains("no model found") {
            false => Ok(found),
            true => Err(DeviceError::BrokeOff {
                device: "yosys".to_owned(),
                message: format!("neither a model nor that there is none:\n{said}"),
            }),
        }
    }

    /// The refuted guesses in a model of the wrapper.
    fn refuted_in(&self, model: &BTreeMap<&str, &str>) -> Refuted {
        let bits = model.get("refuted").copied().unwrap_or_default();
        let set = bits.bytes().rev().enumerate();
        let set = set.filter_map(|(index, bit)| (bit == b'1').then_some(index));
        let mut refuted = Refuted::default();
        let registers = self.registers.len();
        for index in set {
            match (index / registers, index % registers) {
                (0, index) => refuted.bits.push(index),
                (1, index) => refuted.largest.push(index),
                _ => refuted.never.push(index - 2 * registers),
            }
        }
        let place = model.get("place").copied().unwrap_or_default();
        refuted.place = u64::from_str_radix(place, 2).unwrap_or(0);
        refuted
    }
}

/// The ports of a query's sums: the result pins, and the sum register of each cell. Each is given with the
/// bits of the largest sum that the most photons of a query can reach.
fn declared(machine: &Machine, design: &Emitted) -> BTreeMap<String, u32> {
    let needed = Widths::of_numbers(&machine.numbers);
    let channels = machine.channels().names().iter();
    let pins = channels.map(|channel| (format!("result_{channel}"), needed.sum));
    let count = ("result_count".to_owned(), needed.count);
    let pins = pins.chain([count]);
    let registers = design.pins.observed[design.pins.outputs..].iter();
    let registers = registers.zip(&design.register_paths);
    let cells = registers.filter_map(|(pin, path)| match pin.place {
        SignalPlace::Cell {
            node,
            register: Register::Sum,
        } => {
            let counts = machine.hypercube().role(node) == Role::D;
            let bits = if counts { needed.count } else { needed.sum };
            Some((format!("{path}.q"), bits))
        }
        _ => None,
    });
    pins.chain(cells).collect()
}

/// The addresses of the steps of a sequential machine that read a group which the step before has read too.
fn reads_again(machine: &Machine) -> Vec<usize> {
    let steps = machine
        .microprogram()
        .map_or(Vec::new(), |program| program.steps());
    let reads = |step: &Step| SEQUENTIAL.op(step.op).reads_group();
    let pairs = steps.windows(2).enumerate();
    let again = pairs.filter(|(_, pair)| pair.iter().all(reads));
    again.map(|(address, _)| address + 1).collect()
}

/// All combinations of values of `count` of these registers, each given with its bits.
fn all_combinations(registers: &[(usize, u32)], count: usize) -> Vec<Never> {
    if count == 0 {
        return vec![Never(Vec::new())];
    }
    let mut all = Vec::new();
    for (index, &(register, bits)) in registers.iter().enumerate() {
        for rest in all_combinations(&registers[..index], count - 1) {
            for value in 0..1 << bits {
                let literals = [&rest.0[..], &[(register, value)]].concat();
                all.push(Never(literals));
            }
        }
    }
    all
}

/// The signals of each model in Yosys's tables, by name, in binary. A line has name, decimal, hexadecimal,
/// binary.
fn models(said: &str) -> Vec<BTreeMap<&str, &str>> {
    let mut models: Vec<BTreeMap<_, _>> = Vec::new();
    for line in said.lines() {
        let words: Vec<_> = line.split_whitespace().collect();
        match (&words[..], models.last_mut()) {
            (["Signal", "Name", ..], _) => models.push(BTreeMap::new()),
            ([name, .., bits], Some(model)) if name.starts_with('\\') => {
                model.insert(name.trim_start_matches('\\'), *bits);
            }
            _ => {}
        }
    }
    models
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_table_is_a_model() {
        let said = "SAT solving finished - model found:\n\n  Signal Name    Dec   Hex   Bin\n  ------ ---\n  \\p1     \
                    3     3    11\n  \\refuted    --    --    0101\n\n  Signal Name    Dec   Hex   Bin\n  \\p1   0   0   00\n";
        let models = models(said);
        assert_eq!(models.len(), 2);
        assert_eq!((models[0]["p1"], models[0]["refuted"]), ("11", "0101"));
        assert_eq!(models[1]["p1"], "00");
    }
}
