//! Shorter programs that still fail.

use photoncube_spec::{Hypercube, Microprogram, ScheduledStep, check_schedule};

/// A legal program with a step less, and what became of it; none where no such program fails.
pub(super) fn shorter<T>(
    program: &Microprogram,
    cube: Hypercube,
    fails: &dyn Fn(&Microprogram) -> Option<T>,
) -> Option<(Microprogram, T)> {
    let query = (0..program.query_clocks()).map(|clock| Microprogram {
        query: without(&program.query, clock),
        ..program.clone()
    });
    let iteration = (0..program.initiation_interval()).map(|clock| Microprogram {
        iteration: without(&program.iteration, clock),
        ..program.clone()
    });
    let legal = query
        .chain(iteration)
        .filter(|shorter| check_schedule(shorter, cube).is_ok());
    legal.into_iter().find_map(|shorter| {
        let found = fails(&shorter)?;
        Some((shorter, found))
    })
}

/// A phase without a clock.
fn without(phase: &[ScheduledStep], clock: u32) -> Vec<ScheduledStep> {
    let rest = phase.iter().filter(|scheduled| scheduled.clock != clock);
    let earlier = |scheduled: &ScheduledStep| ScheduledStep {
        clock: scheduled.clock - u32::from(scheduled.clock > clock),
        step: scheduled.step,
    };
    rest.map(earlier).collect()
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{Op, Step, parse_listing};

    use super::*;

    #[test]
    fn what_a_failure_does_not_need_is_left_out() {
        let cube = Hypercube::new(4);
        let long = "query:\n0 nop\n1 ldq\niteration:\n0 ldw\n1 ldp\n2 nop\n3 sqd\n4 add z\n5 sqd\n\
                    6 add w\n7 add z\n8 gate\n9 add x\n10 add y\n11 nop\n12 acc\n";
        let mut program = parse_listing(long).unwrap();
        let has_nop = |program: &Microprogram| {
            let nop = Step::new(Op::Nop);
            program.steps().contains(&nop).then_some(())
        };
        while let Some((shorter, ())) = shorter(&program, cube, &has_nop) {
            program = shorter;
        }
        assert_eq!(check_schedule(&program, cube), Ok(()));
        // The all-reduce and its query, and the nop.
        assert_eq!(program.steps().len(), 11);
        assert!(has_nop(&program).is_some());
    }
}
