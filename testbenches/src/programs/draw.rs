//! Draws random programs; a program is a function of the machine and a seed.

use photoncube_hdl::most_steps;
use photoncube_spec::{
    Hypercube, Machine, Microprogram, OpRow, SEQUENTIAL, Step, check_schedule, check_streams,
};
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use super::walk::{fewest_clocks, gather_program};

/// The class of a program, which decides how it is checked.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum ProgramClass {
    /// The schedule checker accepts the program. It computes a gather, and its results are compared with the
    /// direct gather.
    Gather,
    /// The sequencer can run the program; the cells' results have no meaning.
    Free,
}

impl ProgramClass {
    /// The class of a program; `None` where a query would be lost or never end.
    pub fn of(program: &Microprogram, cube: Hypercube) -> Option<Self> {
        if check_schedule(program, cube).is_ok() {
            return Some(Self::Gather);
        }
        check_streams(program, cube).is_ok().then_some(Self::Free)
    }
}

/// A program, and the data of its draw.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DrawnProgram {
    /// The program.
    pub program: Microprogram,
    /// The class of the program.
    pub class: ProgramClass,
    /// The number of programs drawn until this one: programs without a class, and this one.
    pub drawn: u64,
    /// The seed from which the program is drawn.
    pub seed: u64,
}

impl DrawnProgram {
    /// The number of steps of query phase and iteration.
    pub(super) fn steps(&self) -> u64 {
        self.program.steps().len() as u64
    }
}

/// Draws programs until one has a class.
///
/// # Panics
/// Where the machine runs no microprogram.
pub fn draw_program(machine: &Machine, seed: u64) -> DrawnProgram {
    let (cube, most) = (machine.hypercube(), most_steps(machine));
    assert!(most > 0, "machine `{}` runs no program", machine.name);
    let rng = &mut Pcg64::seed_from_u64(seed);
    let mut drawn = 0;
    loop {
        drawn += 1;
        let program = any_program(cube, most, rng);
        if let Some(class) = ProgramClass::of(&program, cube) {
            return DrawnProgram {
                program,
                class,
                drawn,
                seed,
            };
        }
    }
}

/// Half of the programs are gathers by construction, a quarter are gathers with a few edits, a quarter have
/// random steps.
fn any_program(cube: Hypercube, most: usize, rng: &mut Pcg64) -> Microprogram {
    let query = rng.random_range(1..=3);
    let fewest = fewest_clocks(cube);
    match rng.random_range(0..4) {
        0 => {
            let iteration = rng.random_range(2..=most - query);
            random_steps(cube, query, iteration, rng)
        }
        kind => {
            let iteration = rng.random_range(fewest..=most - query);
            let program = gather_program(cube, query, iteration, rng);
            match kind {
                1 => edited(&program, cube, rng),
                _ => program,
            }
        }
    }
}

/// Random steps in both phases: the query phase has one `ldq` and no group step, the iteration has no `ldq`.
fn random_steps(cube: Hypercube, query: usize, iteration: usize, rng: &mut Pcg64) -> Microprogram {
    let inner = |row: &OpRow| row.stream.is_none();
    let mut steps: Vec<_> = (0..query).map(|_| any_step(cube, inner, rng)).collect();
    let loads = rng.random_range(0..query);
    steps[loads] = any_step(cube, OpRow::reads_query, rng);
    let outside = |row: &OpRow| !row.reads_query();
    let iteration: Vec<_> = (0..iteration)
        .map(|_| any_step(cube, outside, rng))
        .collect();
    Microprogram::of_phases(&steps, &iteration)
}

/// One to three edits: a step is replaced by a random one, removed, repeated, or exchanged with another.
fn edited(program: &Microprogram, cube: Hypercube, rng: &mut Pcg64) -> Microprogram {
    let mut query = program.query_clocks() as usize;
    let mut steps = program.steps();
    for _ in 0..rng.random_range(1..=3) {
        let place = rng.random_range(0..steps.len());
        match rng.random_range(0..4) {
            0 => steps[place] = any_step(cube, |_| true, rng),
            1 => {
                steps.remove(place);
                query -= usize::from(place < query);
            }
            // The repeated step replaces another, so that the program does not grow.
            2 => {
                let other = rng.random_range(0..steps.len());
                steps[other] = steps[place];
            }
            _ => {
                let other = rng.random_range(0..steps.len());
                steps.swap(place, other);
            }
        }
    }
    let (query, iteration) = steps.split_at(query);
    Microprogram::of_phases(query, iteration)
}

/// A random step of the op table that satisfies `wanted`, on a random axis of the cube.
fn any_step(cube: Hypercube, wanted: impl Fn(&OpRow) -> bool, rng: &mut Pcg64) -> Step {
    let rows: Vec<_> = SEQUENTIAL.ops.iter().filter(|row| wanted(row)).collect();
    let row = rows.choose(rng).expect("the op table has such an op");
    let axes: Vec<_> = cube.axes().collect();
    Step {
        op: row.op,
        axis: row
            .link
            .map(|_| *axes.choose(rng).expect("a cube has axes")),
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use photoncube_spec::find_machine;

    use super::*;

    fn drawn(machine: &str, programs: u64) -> Vec<DrawnProgram> {
        let machine = find_machine(machine).unwrap();
        (0..programs)
            .map(|seed| draw_program(machine, seed))
            .collect()
    }

    #[test]
    fn every_op_on_every_axis_is_drawn_in_both_classes() {
        for name in ["paper", "paper-5d"] {
            let cube = find_machine(name).unwrap().hypercube();
            let ops = SEQUENTIAL.ops;
            let links = ops.iter().filter(|row| row.link.is_some()).count();
            let all = ops.len() - links + links * cube.axes().count();
            for class in [ProgramClass::Gather, ProgramClass::Free] {
                let of_class = drawn(name, 200).into_iter().filter(|d| d.class == class);
                let steps = of_class.flat_map(|drawn| drawn.program.steps());
                assert_eq!(steps.collect::<HashSet<_>>().len(), all, "{name} {class:?}");
            }
        }
    }

    #[test]
    fn programs_differ_in_length_and_order_and_fill_the_store() {
        for (name, most) in [("paper", 32), ("paper-5d", 32), ("local", 16)] {
            let drawn = drawn(name, 400);
            let programs: HashSet<_> = drawn.iter().map(|d| d.program.steps()).collect();
            assert!(programs.len() > 380, "{name}: {}", programs.len());
            let lengths: HashSet<_> = programs.iter().map(Vec::len).collect();
            let longest = lengths.iter().max();
            assert_eq!(longest, Some(&most), "{name}: {lengths:?}");
            assert!(lengths.len() > most / 2, "{name}: {lengths:?}");
            let gathers = drawn.iter().filter(|d| d.class == ProgramClass::Gather);
            assert!((160..300).contains(&gathers.count()), "{name}");
        }
    }

    #[test]
    fn what_is_built_as_a_gather_is_one_by_the_checker() {
        let rng = &mut Pcg64::seed_from_u64(1);
        for cube in [4, 5, 7].map(Hypercube::new) {
            let fewest = fewest_clocks(cube);
            let all_reduce = Microprogram::all_reduce(cube);
            assert_eq!(fewest, all_reduce.initiation_interval() as usize);
            for index in 0..200 {
                let program = gather_program(cube, 1 + index % 3, fewest + index % 20, rng);
                assert_eq!(check_schedule(&program, cube), Ok(()), "{program}");
            }
        }
    }
}
