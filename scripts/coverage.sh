#!/usr/bin/env bash
# Lines of the golden model that the tests use, by cargo llvm-cov; what is left is listed with a reason.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly VERSION=0.6.21

usage() {
    cat <<USAGE
Usage: scripts/coverage.sh [--help]

Runs the tests of photoncube-model, the unit tests of the testbench and its comparison of all named machines with their
emitted text, under cargo llvm-cov $VERSION, which it installs with rustup's llvm-tools if they are not there (some
minutes). Prints for each file of the golden model its lines and those that were used, then each line that was not, with
the reason in scripts/coverage_reasons.toml. What the coverage of the emitted Verilog is, says
\`photoncube verify coverage\`.

Exit codes: 0 each unused line has a reason; 1 one has none, a reason is for no line, or an installation or a test
failed; 2 bad usage.
USAGE
}

case ${1-} in
    '') ;;
    -h | --help) usage && exit 0 ;;
    *) usage >&2 && exit 2 ;;
esac

if [[ $(cargo llvm-cov --version 2>/dev/null) != "cargo-llvm-cov $VERSION" ]]; then
    rustup component add llvm-tools
    cargo install --locked "cargo-llvm-cov@$VERSION"
fi

# Tests of both packages at once, so that what they stand on is built once.
count() {
    cargo llvm-cov --no-report --locked -p photoncube-model -p photoncube-testbench "$@" >&2
}

report=$(mktemp)
trap 'rm -f "$report"' EXIT
cargo llvm-cov clean --profraw-only
count --lib --test local_gather --test machine_equals_gather --test planes --test spatial --test streams --test comparison
# `text` is in the names of its trials.
count --test equivalence -- text
cargo llvm-cov report --ignore-filename-regex '/(testbenches|crates/(hdl|render|spec)|tests)/|tests\.rs$' --json \
    --output-path "$report" >&2
python3 scripts/coverage.py "$report" scripts/coverage_reasons.toml
