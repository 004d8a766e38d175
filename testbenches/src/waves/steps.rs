//! What the program of a machine does in a clock, as text.

use photoncube_spec::overlap::Program;
use photoncube_spec::{Inputs, Machine, Pins, Role, SignalPlace, Step};

use crate::compare::{Activity, activity};

/// The text of a clock in which no step is done.
const NOTHING: &str = "-";
/// The text of a clock in which the result waits to be taken.
const HAS_RESULT: &str = "has result";

/// The steps of a machine's program.
#[derive(Debug)]
pub(super) struct Steps {
    machine: Machine,
    program: Listing,
    /// The column of the control block's first register.
    control: usize,
}

#[derive(Debug)]
enum Listing {
    /// The steps of a sequential machine, by address.
    Sequential(Vec<Step>),
    /// The control words of the four roles of an overlapped machine, by address, with the texts of the clock.
    Overlapped(Vec<OverlapRow>),
}

/// An address of an overlapped program.
#[derive(Debug)]
struct OverlapRow {
    words: [u64; Role::ALL.len()],
    texts: Vec<String>,
}

/// Registers of an overlapped machine's control block, see [`photoncube_spec::OVERLAPPED`]: the next address.
const ADDRESS: usize = 0;
/// Whether the result waits to be taken.
const DONE: usize = 4;
/// The current control words, by role.
const WORDS: usize = 5;

impl Steps {
    /// The steps of a machine; `None` for a machine without a program.
    pub fn of(machine: &Machine) -> Option<Self> {
        let sequential = machine
            .microprogram()
            .map(|program| Listing::Sequential(program.steps()));
        let overlapped = || {
            machine
                .overlap_program()
                .map(|program| Listing::Overlapped(rows(&program)))
        };
        let pins = Pins::of(machine);
        let mut places = pins.observed.iter().map(|pin| pin.place);
        Some(Self {
            machine: *machine,
            program: sequential.or_else(overlapped)?,
            control: places.position(|place| place == SignalPlace::Control(0))?,
        })
    }

    /// The names of the texts: one for all cells, and in an overlapped machine one for each role.
    pub fn names(&self) -> Vec<String> {
        let step = "step".to_owned();
        match self.program {
            Listing::Sequential(_) => vec![step],
            Listing::Overlapped(_) => {
                let roles = Role::ALL.map(|role| format!("step_{}", role.name().to_lowercase()));
                [step].into_iter().chain(roles).collect()
            }
        }
    }

    /// The texts of a clock, from its input pins and the signals that the golden model shows.
    pub fn texts(&self, inputs: &[u64], observed: &[u64]) -> Vec<String> {
        let control = &observed[self.control..];
        match &self.program {
            Listing::Sequential(steps) => {
                let inputs: Inputs = Pins::inputs_of(&self.machine, inputs);
                let [address, _, done] = [0, 1, 2].map(|index| control[index]);
                vec![
                    match activity(steps[address as usize], done != 0, &inputs) {
                        Activity::WaitsFor(step) => format!("waits for {step}"),
                        Activity::HasResult => HAS_RESULT.to_owned(),
                        activity => activity.to_string(),
                    },
                ]
            }
            Listing::Overlapped(rows) => overlapped(rows, control),
        }
    }
}

/// The program of an overlapped machine, by address.
fn rows(program: &Program) -> Vec<OverlapRow> {
    let words = Role::ALL.map(|role| program.control_words(role));
    let row = |address: u32| OverlapRow {
        words: std::array::from_fn(|role| words[role][address as usize].into()),
        texts: texts(program, address),
    };
    (0..program.end_address()).map(row).collect()
}

fn texts(program: &Program, address: u32) -> Vec<String> {
    let (step, roles) = match address.checked_sub(program.epilogue_address()) {
        None => (
            format!("kernel {address}"),
            Role::ALL.map(|role| program.listed(address, role)),
        ),
        Some(clock) => {
            let mut steps = program.epilogue.iter().filter(|step| step.clock == clock);
            let step = steps
                .next()
                .map_or(NOTHING.to_owned(), |step| step.step.to_string());
            (format!("epilogue {clock}"), Role::ALL.map(|_| step.clone()))
        }
    };
    [step].into_iter().chain(roles).collect()
}

/// The texts of the address whose control words the machine has. Where several addresses have these words, it is
/// the one before the next address.
fn overlapped(rows: &[OverlapRow], control: &[u64]) -> Vec<String> {
    let words = &control[WORDS..][..Role::ALL.len()];
    let mut found = rows
        .iter()
        .enumerate()
        .filter(|(_, row)| row.words == *words);
    let before = (control[ADDRESS] as usize).checked_sub(1);
    let first = found.clone().next();
    let found = found
        .find(|(address, _)| Some(*address) == before)
        .or(first);
    let idle = |text: &str| {
        let roles = Role::ALL.map(|_| NOTHING.to_owned());
        [text.to_owned()].into_iter().chain(roles).collect()
    };
    match found {
        _ if control[DONE] != 0 => idle(HAS_RESULT),
        Some((_, row)) => row.texts.clone(),
        None => idle(NOTHING),
    }
}
