//! Makes programs that compute a gather: a random walk over the steps that are possible next, which reserves
//! enough clocks to finish and spends the others on useless steps.

use photoncube_spec::{Axis, Hypercube, Microprogram, Op, Step};
use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_pcg::Pcg64;

/// The contents of the cells' work register.
#[derive(Clone)]
enum Work {
    Nothing,
    /// Squares that are still to be added across these axes.
    Squares(Vec<Axis>),
    /// Powers that are still to be added across these axes.
    Powers(Vec<Axis>),
}

/// The state of an iteration during the walk.
#[derive(Clone)]
struct State {
    cube: Hypercube,
    photon: bool,
    power: bool,
    work: Work,
    accumulated: bool,
}

/// The fewest clocks of an iteration that computes a gather.
pub(super) fn fewest_clocks(cube: Hypercube) -> usize {
    State::start(cube).needed()
}

/// A gather with a query phase of `query` clocks and an iteration of `iteration` clocks, at least
/// [`fewest_clocks`].
pub(super) fn gather_program(
    cube: Hypercube,
    query: usize,
    iteration: usize,
    rng: &mut Pcg64,
) -> Microprogram {
    let mut query = vec![Step::new(Op::Nop); query];
    let loads = rng.random_range(0..query.len());
    query[loads] = Step::new(Op::LoadQuery);
    let mut state = State::start(cube);
    let mut steps = Vec::new();
    for left in (0..iteration).rev() {
        let mut may = state.steps();
        may.retain(|&step| state.after(step).needed() <= left);
        // The group must be taken before the last clock of the iteration.
        may.retain(|step| left > 0 || !step.op.row().reads_group);
        let step = *may.choose(rng).expect("a nop is left, or what is needed");
        state = state.after(step);
        steps.push(step);
    }
    Microprogram::of_phases(&query, &steps)
}

impl State {
    fn start(cube: Hypercube) -> Self {
        Self {
            cube,
            photon: false,
            power: false,
            work: Work::Nothing,
            accumulated: false,
        }
    }

    /// The fewest clocks to the end of the iteration.
    fn needed(&self) -> usize {
        if self.accumulated {
            return 0;
        }
        let (roles, photons) = (
            self.cube.role_axes().count(),
            self.cube.photon_axes().count(),
        );
        let to_gate = usize::from(!self.power) + 1;
        match &self.work {
            Work::Powers(axes) => axes.len() + 1,
            Work::Squares(axes) => axes.len() + to_gate + photons + 1,
            Work::Nothing => usize::from(!self.photon) + 1 + roles + to_gate + photons + 1,
        }
    }

    /// All steps that keep the gather correct, useless ones included.
    fn steps(&self) -> Vec<Step> {
        let mut steps: Vec<_> = [Op::Nop, Op::LoadPhoton, Op::LoadPower]
            .map(Step::new)
            .into();
        if self.photon {
            steps.push(Step::new(Op::SquareDifference));
        }
        match &self.work {
            Work::Nothing => {}
            Work::Squares(axes) if axes.is_empty() => {
                steps.extend(self.power.then_some(Step::new(Op::Gate)));
            }
            Work::Powers(axes) if axes.is_empty() => {
                steps.extend((!self.accumulated).then_some(Step::new(Op::Accumulate)));
            }
            Work::Squares(axes) | Work::Powers(axes) => {
                steps.extend(axes.iter().copied().map(Step::exchange_add));
            }
        }
        steps
    }

    fn after(&self, step: Step) -> Self {
        let mut next = self.clone();
        match step.op {
            Op::Nop | Op::LoadQuery => {}
            Op::LoadPhoton => next.photon = true,
            Op::LoadPower => next.power = true,
            Op::SquareDifference => next.work = Work::Squares(self.cube.role_axes().collect()),
            Op::ExchangeAdd => {
                if let Work::Squares(axes) | Work::Powers(axes) = &mut next.work {
                    axes.retain(|&axis| Some(axis) != step.axis);
                }
            }
            Op::Gate => next.work = Work::Powers(self.cube.photon_axes().collect()),
            Op::Accumulate => next.accumulated = true,
        }
        next
    }
}
