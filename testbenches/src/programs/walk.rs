//! Makes programs that compute a gather: a random walk over the steps after which the checker still accepts the
//! contents of the registers. It reserves enough clocks to finish and spends the others on useless steps.

use photoncube_spec::{Content, Contents, Hypercube, Microprogram, Op, Register, SEQUENTIAL, Step};
use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_pcg::Pcg64;

/// The fewest clocks of an iteration that computes a gather.
pub(super) fn fewest_clocks(cube: Hypercube) -> usize {
    needed(&loaded(cube), cube)
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
    let mut cell = loaded(cube);
    let mut steps = Vec::new();
    for left in (0..iteration).rev() {
        let mut may = next(&cell, cube);
        may.retain(|(_, after)| needed(after, cube) <= left);
        // The group must be taken before the last clock of the iteration.
        may.retain(|(step, _)| left > 0 || !SEQUENTIAL.op(step.op).reads_group());
        let (step, after) = may.choose(rng).expect("a nop is left, or what is needed");
        steps.push(*step);
        cell = after.clone();
    }
    Microprogram::of_phases(&query, &steps)
}

/// A cell's contents after the query is loaded.
fn loaded(cube: Hypercube) -> Contents {
    let load = Step::new(Op::LoadQuery);
    let loaded = Contents::default().after(load, cube);
    loaded.expect("the query's load reads no register")
}

/// The fewest clocks to the end of the iteration.
fn needed(cell: &Contents, cube: Hypercube) -> usize {
    if cell.of(Register::Sum) != Content::SumOf(0) {
        return 0;
    }
    let missing = |register| usize::from(cell.of(register) != Content::Loaded);
    let without = |all: usize, axes: u32| all - axes.count_ones() as usize;
    let (roles, photons) = (cube.role_axes().count(), cube.photon_axes().count());
    let to_gate = missing(Register::Power(0)) + 1;
    match cell.of(Register::Work) {
        Content::Gated(axes) => without(photons, axes) + 1,
        Content::Distance(axes) => without(roles, axes) + to_gate + photons + 1,
        _ => missing(Register::Photon) + 1 + roles + to_gate + photons + 1,
    }
}

/// All steps that keep the gather correct, useless ones included, with the contents after each.
fn next(cell: &Contents, cube: Hypercube) -> Vec<(Step, Contents)> {
    let rows = SEQUENTIAL.ops.iter().filter(|row| !row.reads_query());
    let steps = rows.flat_map(|row| match row.link {
        None => vec![Step::new(row.op)],
        Some(_) => cube.axes().map(|axis| Step::across(row.op, axis)).collect(),
    });
    let after = steps.filter_map(|step| Some((step, cell.after(step, cube).ok()?)));
    after
        .filter(|(_, after)| after.of(Register::Sum) != Content::SumOf(2))
        .collect()
}
