//! Reduces a program that fails to the shortest program that still fails.

use photoncube_spec::{Axis, Hypercube, Microprogram, Op, Step, check_streams};

/// Removes steps while `fails` returns true for the rest, then simplifies the remaining steps. In the result
/// no step and no two steps can be removed, and no step can be simplified.
pub(super) fn shrink<E>(
    program: &Microprogram,
    cube: Hypercube,
    fails: &mut dyn FnMut(&Microprogram) -> Result<bool, E>,
) -> Result<Microprogram, E> {
    let mut best = Phases::of(program);
    loop {
        let mut smaller = None;
        for candidate in best.candidates() {
            let program = candidate.program();
            // A program that loses queries or never ends is not a valid case.
            if check_streams(&program, cube).is_ok() && fails(&program)? {
                smaller = Some(candidate);
                break;
            }
        }
        match smaller {
            Some(candidate) => best = candidate,
            None => return Ok(best.program()),
        }
    }
}

/// The steps of both phases in a row, with the number of those in the query phase.
#[derive(Clone)]
struct Phases {
    steps: Vec<Step>,
    query: usize,
}

impl Phases {
    fn of(program: &Microprogram) -> Self {
        Self {
            steps: program.steps(),
            query: program.query_clocks() as usize,
        }
    }

    fn program(&self) -> Microprogram {
        let (query, iteration) = self.steps.split_at(self.query);
        Microprogram::of_phases(query, iteration)
    }

    /// Smaller programs, the smallest first. The order in which they are smaller is well-founded.
    fn candidates(&self) -> Vec<Self> {
        let count = self.steps.len();
        let mut candidates = Vec::new();
        let mut size = count / 2;
        while size > 0 {
            let starts = (0..count).step_by(size);
            candidates.extend(starts.map(|start| self.without(|i| i / size == start / size)));
            size /= 2;
        }
        for first in 0..count {
            let pairs = (0..first).map(|second| self.without(|i| i == first || i == second));
            candidates.extend(pairs);
        }
        candidates.extend((0..count).flat_map(|place| self.simpler(place)));
        candidates
    }

    fn without(&self, left_out: impl Fn(usize) -> bool) -> Self {
        let kept = |&(index, _): &(usize, &Step)| !left_out(index);
        let steps = self.steps.iter().enumerate().filter(kept);
        Self {
            steps: steps.map(|(_, &step)| step).collect(),
            query: (0..self.query).filter(|&i| !left_out(i)).count(),
        }
    }

    /// The program with a nop in the place of a step, or with that step on the first axis.
    fn simpler(&self, place: usize) -> impl Iterator<Item = Self> + '_ {
        let step = self.steps[place];
        let simple = match (step.op, step.axis) {
            (Op::Nop, _) => vec![],
            (_, None | Some(Axis::X)) => vec![Step::new(Op::Nop)],
            (op, Some(_)) => {
                let axis = Some(Axis::X);
                vec![Step::new(Op::Nop), Step { op, axis }]
            }
        };
        simple.into_iter().map(move |step| {
            let mut simpler = self.clone();
            simpler.steps[place] = step;
            simpler
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shortest(fails: impl Fn(&[Step]) -> bool) -> Vec<String> {
        let cube = Hypercube::new(4);
        let program = Microprogram::all_reduce(cube);
        let mut tried = |program: &Microprogram| Ok::<_, ()>(fails(&program.steps()));
        let program = shrink(&program, cube, &mut tried).unwrap();
        assert_eq!(check_streams(&program, cube), Ok(()));
        program.steps().iter().map(Step::to_string).collect()
    }

    fn has(steps: &[Step], op: Op) -> bool {
        steps.iter().any(|step| step.op == op)
    }

    #[test]
    fn only_what_fails_and_what_the_streams_need_is_left() {
        let gate = shortest(|steps| has(steps, Op::Gate));
        assert_eq!(gate, ["ldq", "ldp", "gate"]);
        let add = shortest(|steps| has(steps, Op::Add));
        assert_eq!(add, ["ldq", "ldp", "add x"]);
        assert_eq!(shortest(|_| true), ["ldq", "ldp", "nop"]);
    }

    #[test]
    fn two_steps_that_hold_each_other_are_left_out_together() {
        let adds = |steps: &[Step]| steps.iter().filter(|s| s.op == Op::Add).count();
        // With one of its four adds removed, the program does not fail.
        let fails = |steps: &[Step]| has(steps, Op::Gate) && adds(steps).is_multiple_of(2);
        assert_eq!(shortest(fails), ["ldq", "ldp", "gate"]);
    }

    #[test]
    fn what_cannot_be_tried_ends_the_search() {
        let cube = Hypercube::new(4);
        let program = Microprogram::all_reduce(cube);
        let result = shrink(&program, cube, &mut |_| Err("no tool"));
        assert_eq!(result, Err("no tool"));
    }
}
