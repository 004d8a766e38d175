//! The microprogram of a sequential machine: which op runs in which clock.

use super::control::encode;
use crate::cell::{ControlWord, Op, SEQUENTIAL, ScheduledStep, Step, phase_clocks};
use crate::hypercube::Hypercube;

/// The fewest address bits of a control store. Every store has at least 16 places, so short programs need no
/// program-counter width of their own. The places behind the program hold the control word that does nothing.
const MIN_ADDRESS_BITS: u32 = 4;

/// The program of a sequential machine. One phase runs once for each query, the other once for each group of
/// photons.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Microprogram {
    /// The steps of the query phase, which runs once for each query before its first group.
    pub query: Vec<ScheduledStep>,
    /// The steps of the iteration phase, which runs once for each group. Its length is the initiation
    /// interval.
    pub iteration: Vec<ScheduledStep>,
}

impl Microprogram {
    /// Makes the paper's program (Ryu, Kim, Lee, figures 3 to 5) in our all-reduce reading: square, add
    /// across the role axes, gate, add across the photon axes, accumulate.
    ///
    /// The iteration takes 9 clocks on the 4-D cube, and one more for each further axis.
    pub fn all_reduce(cube: Hypercube) -> Self {
        let mut steps = vec![
            Step::new(Op::LoadPhoton),
            Step::new(Op::LoadPower),
            Step::new(Op::SquareDifference),
        ];
        steps.extend(cube.role_axes().map(Step::exchange_add));
        steps.push(Step::new(Op::Gate));
        steps.extend(cube.photon_axes().map(Step::exchange_add));
        steps.push(Step::new(Op::Accumulate));
        Self {
            query: ScheduledStep::one_a_clock(&[Step::new(Op::LoadQuery)]),
            iteration: ScheduledStep::one_a_clock(&steps),
        }
    }

    /// Makes the program of these steps, one step in each clock.
    pub fn of_phases(query: &[Step], iteration: &[Step]) -> Self {
        Self {
            query: ScheduledStep::one_a_clock(query),
            iteration: ScheduledStep::one_a_clock(iteration),
        }
    }

    /// Clocks from one group to the next.
    pub fn initiation_interval(&self) -> u32 {
        phase_clocks(&self.iteration)
    }

    /// Clocks that the query phase takes.
    pub fn query_clocks(&self) -> u32 {
        phase_clocks(&self.query)
    }

    /// Clocks from a query's first step to the step that takes the query, inclusive.
    pub fn clocks_up_to_the_query(&self) -> u64 {
        let mut query = self.query.iter();
        let taker = query.find(|scheduled| SEQUENTIAL.op(scheduled.step.op).reads_query());
        taker.map_or(0, |taker| u64::from(taker.clock) + 1)
    }

    /// Clocks from a query's first step to the first clock in which its result can be taken, for `groups`
    /// groups while no stream waits.
    pub fn latency_clocks(&self, groups: u64) -> u64 {
        u64::from(self.query_clocks()) + groups * u64::from(self.initiation_interval())
    }

    /// Clocks that a query occupies the machine while no stream waits: the latency and the one clock in which
    /// the result is taken.
    pub fn occupied_clocks(&self, groups: u64) -> u64 {
        self.workload_clocks(1, groups)
    }

    /// Clocks of a whole workload while no stream waits. `groups` counts the groups of all queries.
    pub fn workload_clocks(&self, queries: u64, groups: u64) -> u64 {
        let each_query = u64::from(self.query_clocks()) + 1;
        queries * each_query + groups * u64::from(self.initiation_interval())
    }

    /// The steps in the order of their clocks, query phase first, one for each clock. A control block with a
    /// program counter runs them in this order. A clock without a step gets a nop.
    pub fn steps(&self) -> Vec<Step> {
        let fill = |phase: &[ScheduledStep]| {
            (0..phase_clocks(phase))
                .map(|clock| step_at(phase, clock).unwrap_or(Step::new(Op::Nop)))
                .collect::<Vec<_>>()
        };
        let mut steps = fill(&self.query);
        steps.extend(fill(&self.iteration));
        steps
    }

    /// Bits of the program counter; at least those of a control store of 16 places.
    pub fn address_bits(&self) -> u32 {
        let last = self.steps().len().saturating_sub(1);
        (usize::BITS - last.leading_zeros()).max(MIN_ADDRESS_BITS)
    }

    /// The widths of the control block's registers, in the order of [`SEQUENTIAL`].
    pub(crate) fn control_widths(&self) -> [u32; 3] {
        [self.address_bits(), 1, 1]
    }

    /// Encodes the program: one control word for each of [`Self::steps`].
    pub fn control_words(&self) -> Vec<ControlWord> {
        let steps = self.steps();
        let taker = steps
            .iter()
            .rposition(|step| SEQUENTIAL.op(step.op).reads_group());
        steps
            .iter()
            .enumerate()
            .map(|(address, &step)| encode(step, Some(address) == taker))
            .collect()
    }
}

fn step_at(phase: &[ScheduledStep], clock: u32) -> Option<Step> {
    phase.iter().find(|s| s.clock == clock).map(|s| s.step)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::Field;

    #[test]
    fn the_papers_program_takes_nine_clocks_for_four_photons() {
        let cube = Hypercube::new(4);
        assert_eq!(Microprogram::all_reduce(cube).initiation_interval(), 9);
        assert_eq!(cube.photons(), 4);
    }

    #[test]
    fn another_axis_costs_one_clock_and_doubles_the_photons() {
        let cube = Hypercube::new(5);
        assert_eq!(Microprogram::all_reduce(cube).initiation_interval(), 10);
        assert_eq!(cube.photons(), 8);
    }

    #[test]
    fn each_group_is_taken_once() {
        let words = Microprogram::all_reduce(Hypercube::new(4)).control_words();
        let takes: Vec<_> = words
            .iter()
            .map(|&word| SEQUENTIAL.field(Field::TakesGroup, word, 4))
            .collect();
        assert_eq!(takes, [0, 0, 1, 0, 0, 0, 0, 0, 0, 0]);
    }
}
