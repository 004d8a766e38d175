#!/usr/bin/env bash
# Lines of the golden model and the spec that their own tests use, by cargo llvm-cov; what is left is listed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly VERSION=0.6.21

usage() {
    cat <<USAGE
Usage: scripts/coverage.sh [--help]

Runs the tests of photoncube-model and photoncube-spec, and the unit tests of the testbench, under cargo llvm-cov
$VERSION, which it installs with rustup's llvm-tools if they are not there (some minutes), and prints for each file its lines and those that no test
used. The text of each such line stands behind it. What the emitted Verilog's coverage is, says
\`photoncube verify --coverage\`.

Exit codes: 0 the table is printed; 1 an installation or a test failed; 2 bad usage.
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

report=$(mktemp)
trap 'rm -f "$report"' EXIT
# The testbench's unit tests drive the golden model as every verification does.
cargo llvm-cov --locked -p photoncube-model -p photoncube-spec -p photoncube-testbench --lib \
    --test machine_equals_gather --test planes --test local_gather --test snapshots --test comparison \
    --ignore-filename-regex '/(testbenches|crates/hdl|crates/render)/' --json --output-path "$report" >&2
python3 scripts/coverage.py "$report"
