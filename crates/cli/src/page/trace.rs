//! A group of photons through a sequential machine, with the real values of all registers, clock by clock.

use anyhow::{Context, Result, bail};
use photoncube_model::gather;
use photoncube_render::{PhotonMap, Scene, ViewOptions, workload};
use photoncube_spec::{
    CellTables, Machine, Microprogram, Photon, Pins, Query, Register, SEQUENTIAL, SignalPlace, Step,
};

use crate::rows::Rows;

/// A query and the photons of some groups.
pub struct Example {
    query: Query,
    /// The photons.
    pub photons: Vec<Photon>,
    /// The number of these photons that are in range.
    pub in_range: u64,
}

/// The groups of the workload from which the example is taken.
const GROUPS: u64 = 200;

impl Example {
    /// A query of a view and `groups` groups of the photons that it gathers. Of these all but one are in range, if there
    /// is such a query.
    ///
    /// # Errors
    /// The machine cannot hold the scene, or no query of the view gathers a photon.
    pub fn of(
        scene: &Scene,
        map: &PhotonMap,
        machine: &Machine,
        view: &ViewOptions,
        groups: usize,
    ) -> Result<Self> {
        let queries = workload(scene, map, machine, view, GROUPS, view.seed)?;
        let count = groups * machine.photons_per_iteration();
        let mut best: Option<Self> = None;
        for (query, photons) in queries {
            let near = |photon: &Photon| -> Result<bool> {
                Ok(gather(machine, &query, [*photon])?.count > 0)
            };
            let (mut inside, mut outside) = (Vec::new(), Vec::new());
            for photon in photons {
                match near(&photon)? {
                    true => inside.push(photon),
                    false => outside.push(photon),
                }
            }
            let wanted = inside.len().min(count - 1);
            let chosen = inside.into_iter().take(wanted).chain(outside);
            let photons: Vec<_> = chosen.take(count).collect();
            let example = Self {
                query,
                photons,
                in_range: wanted as u64,
            };
            if example.photons.len() == count && wanted == count - 1 {
                return Ok(example);
            }
            if best
                .as_ref()
                .is_none_or(|best| best.in_range < example.in_range)
            {
                best = Some(example);
            }
        }
        best.context("no query of the view gathers a photon")
    }

    /// So many equal queries, each with the photons.
    pub fn workload(&self, queries: usize) -> Vec<(Query, Vec<Photon>)> {
        vec![(self.query, self.photons.clone()); queries]
    }
}

/// The registers of all cells, clock by clock.
pub struct Trace {
    /// The steps, one a clock.
    pub steps: Vec<Step>,
    /// The clocks of the steps, as [`clock_names`].
    pub clocks: Vec<String>,
    /// The mnemonics of a cell's registers.
    pub registers: Vec<&'static str>,
    /// Before the first step and after each: for each node, the values of its registers.
    pub states: Vec<Vec<Vec<u64>>>,
}

impl Trace {
    /// Runs the golden model of a sequential machine on an example, from the query's load to the result.
    ///
    /// # Errors
    /// The machine has no program, or the golden model refuses the example.
    pub fn of(machine: &Machine, example: &Example) -> Result<Self> {
        let Some(program) = machine.microprogram() else {
            bail!("machine `{}` has no microprogram", machine.name);
        };
        let (program, clocks) = (program.steps(), clock_names(&program));
        let rows = Rows::of(machine, &example.workload(1))?.observed;
        let pins = Pins::of(machine);
        let place = |wanted| pins.observed.iter().position(|pin| pin.place == wanted);
        let control = place(SignalPlace::Control(0)).context("a program has an address")?;
        // The address is 0 while the machine waits, too; it leaves 0 in the clock that loads the query.
        let mut pairs = rows.windows(2);
        let loads = pairs.rposition(|pair| pair[0][control] == 0 && pair[1][control] == 1);
        let loads = loads.context("the golden model loaded no query")?;
        let end = loads + program.len();
        if end >= rows.len() {
            bail!(
                "the golden model of `{}` gave {} rows, expected more than {end}",
                machine.name,
                rows.len()
            );
        }
        let nodes = machine.hypercube().nodes();
        let tables: &CellTables = &SEQUENTIAL;
        let columns = |node: usize| -> Option<Vec<usize>> {
            let of = |register: Register| place(SignalPlace::Cell { node, register });
            tables
                .registers
                .iter()
                .map(|row| of(row.register))
                .collect()
        };
        let columns: Option<Vec<_>> = (0..nodes).map(columns).collect();
        let columns = columns.context("every register is observed")?;
        let state = |row: &Vec<u64>| -> Vec<Vec<u64>> {
            let of_node =
                |columns: &Vec<usize>| columns.iter().map(|&column| row[column]).collect();
            columns.iter().map(of_node).collect()
        };
        Ok(Self {
            clocks,
            steps: program,
            registers: tables.registers.iter().map(|row| row.mnemonic).collect(),
            states: rows[loads..=end].iter().map(state).collect(),
        })
    }
}

/// The names of a program's clocks as its listing has them: `query 0`, and the clocks of an iteration, `0` and on.
pub fn clock_names(program: &Microprogram) -> Vec<String> {
    let of_query = (0..program.query_clocks()).map(|clock| format!("query {clock}"));
    let of_iteration = (0..program.initiation_interval()).map(|clock| clock.to_string());
    of_query.chain(of_iteration).collect()
}

/// An example of the built-in scene `ring`, for tests.
#[cfg(test)]
pub fn example(machine: &Machine, groups: usize) -> Example {
    let scene = Scene::built_in("ring").unwrap();
    let options = photoncube_render::TraceOptions {
        photons: 5_000,
        seed: 1,
    };
    let traced = photoncube_render::trace(&scene, &options, &|_| ()).unwrap();
    let map = PhotonMap::new(&scene, traced.photons, 0.2).unwrap();
    let view = ViewOptions {
        width: 16,
        height: 16,
        ..ViewOptions::default()
    };
    Example::of(&scene, &map, machine, &view, groups).unwrap()
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{Op, Role, find_machine};

    use super::*;

    fn traced(machine: &Machine) -> (Example, Trace) {
        let example = example(machine, 1);
        let trace = Trace::of(machine, &example).unwrap();
        (example, trace)
    }

    /// The sum of a D cell after the last step is the number of photons in range, and the step `sqd` leaves the
    /// square of the difference in each cell.
    #[test]
    fn the_values_are_those_of_the_program() {
        let machine = find_machine("paper").unwrap();
        let (example, trace) = traced(machine);
        assert_eq!((example.photons.len(), example.in_range), (4, 3));
        assert_eq!(trace.states.len(), trace.steps.len() + 1);
        let column = |name: &str| {
            trace
                .registers
                .iter()
                .position(|other| *other == name)
                .unwrap()
        };
        let [q, p, v, s] = ["q", "p", "v", "s"].map(column);
        let end = trace.states.last().unwrap();
        let counts = machine.hypercube().result_node(Role::D);
        assert_eq!(end[counts][s], example.in_range);
        let squares = trace
            .steps
            .iter()
            .position(|step| step.op == Op::SquareDifference);
        let after = &trace.states[squares.unwrap() + 1];
        assert!(
            after
                .iter()
                .all(|cell| cell[v] == cell[q].abs_diff(cell[p]).pow(2))
        );
        assert!(after.iter().any(|cell| cell[v] > 0));
    }

    #[test]
    fn a_machine_without_a_program_has_no_steps() {
        let (example, _) = traced(find_machine("paper").unwrap());
        let error = Trace::of(find_machine("stream").unwrap(), &example)
            .err()
            .unwrap();
        assert!(
            error.to_string().contains("`stream` has no microprogram"),
            "{error}"
        );
    }
}
