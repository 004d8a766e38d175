#!/usr/bin/env bash
# Whether the example testbenches pass, and fail where an expected result is wrong.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/testbenches.sh [FILE...]

Runs testbenches *_tb.v, as `photoncube generate` writes them, in Icarus (default: those in hdl-out that are committed), each
with the Verilog beside it. Each must pass, and must fail after one bit of its first expected result is changed.

Exit codes: 0 all hold; 1 one does not; 2 bad usage, a missing file or a missing tool.
USAGE
}

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=scripts/yosys/common.sh
source "$here/yosys/common.sh"
read_options "$@"
need iverilog vvp
files=("$@")
if (($# == 0)); then
    cd "$here/.."
    mapfile -t files < <(git ls-files 'hdl-out/*_tb.v')
fi
((${#files[@]} > 0)) || {
    echo "testbenches: git names no hdl-out/*_tb.v; write them with \`cargo run --release -- generate\`, or name files" >&2
    exit 2
}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# What the testbench $1 says of the Verilog $2.
run() {
    iverilog -g2005 -o "$scratch/run" "$2" "$1" && vvp -n "$scratch/run"
}

for file in "${files[@]}"; do
    design=${file%_tb.v}.v
    [[ $file == *_tb.v && -f $file && -f $design ]] || {
        echo "testbenches: found $file, expected a file NAME_tb.v with a file NAME.v beside it" >&2
        exit 2
    }
    said=$(run "$file" "$design" 2>&1) || true
    if ! grep -q '^PASSED: [1-9]' <<<"$said" || grep -q '^FAILED' <<<"$said"; then
        printf 'testbenches: %s does not pass:\n%s\n' "$file" "$(tail -20 <<<"$said")" >&2
        exit 1
    fi
    # The lowest bit of the first field.
    sed "s/ results\[0\] = {\([0-9]*\)'d/ results[0] = {\1'd1 ^ \1'd/" "$file" >"$scratch/wrong.v"
    if cmp -s "$file" "$scratch/wrong.v"; then
        echo "testbenches: $file has no first result to change, so its pass says nothing" >&2
        exit 1
    fi
    wrong=$(run "$scratch/wrong.v" "$design" 2>&1) || true
    if grep -q '^PASSED' <<<"$wrong" || ! grep -q '^FAILED: .* 1 .*wrong$' <<<"$wrong"; then
        printf 'testbenches: %s does not fail by one result where one is changed:\n%s\n' "$file" "$(tail -20 <<<"$wrong")" >&2
        exit 1
    fi
    printf 'pass  %s (%s; fails where a result is changed)\n' "$file" "$(grep '^PASSED' <<<"$said" | sed 's/^PASSED: //')"
done
