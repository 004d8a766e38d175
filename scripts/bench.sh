#!/usr/bin/env bash
# How fast the gather is, beside what people use today: rates, and their ratios.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/bench.sh [FILTER]

Measures, in one run and on the same photons and queries, the fixed-point gather (with this processor's
fastest instructions, and portably), a uniform grid of f32 photons in AVX2, and kiddo's kd-tree; on one
thread and on two; uniform and caustic photons. Prints Criterion's measurements and a table of rates and
ratios. About five minutes; FILTER takes those measurements only whose names contain it.
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
