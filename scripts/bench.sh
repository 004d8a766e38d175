#!/usr/bin/env bash
# How fast the gather is, beside what people use today: rates, and their ratios.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/bench.sh [FILTER | scaling | threads | peers [FILTER] | build [PHOTONS]...]

Measures, in one run and on the same photons and queries, the fixed-point gather (with each set of
instructions of this processor), a uniform grid of f32 photons in AVX2, and kiddo's kd-tree; on one
thread and on two; photons on a floor, uniform, with a caustic, and on a floor that lies along no axis. Prints
Criterion's measurements and a table of rates and ratios. docs/measured/bench.md has such a table, and docs/speed.md
explains its columns. Six to ten minutes; FILTER takes those measurements only whose names contain it.

`scaling` measures on one thread how time and memory grow from 1e5 to 1e7 photons instead, with as many in
range and with one radius. Three to five minutes and several GB of memory.

`threads` measures what a second thread gives, one thread and two in turn, beside what it gives to
work that touches no memory. About three minutes.

`peers` measures the gather and the grid in turn on one thread, 61 rounds each, and prints the median of the rounds'
ratios, which other work on the machine changes little. Beside the tests a second it has those that the processor's
instruction ports would allow, and the share reached. About a minute for each workload on a quiet machine; x86-64 only.

`build` measures tracing, sorting and the planes, with the most memory that they take, and what the peers
build from the same photons; each with the gather of 2^20 queries. PHOTONS are 1e5 1e6 1e7 if not given: up to four
minutes and 2 GB of memory. 1e8 takes ten times as much of both as 1e7.
USAGE
}

case ${1-} in
    -h | --help)
        usage
        exit 0
        ;;
    -*)
        usage >&2
        exit 2
        ;;
esac

cd "$(dirname "${BASH_SOURCE[0]}")/.."
CRITERION_HOME=${CRITERION_HOME:-$PWD/target/criterion}
export CRITERION_HOME
cargo bench --locked -p photoncube-benches --bench gather -- "$@"
