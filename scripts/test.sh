#!/usr/bin/env bash
# Every check that this project holds, from a fresh clone: installs what is missing, then runs the checks. The
# tests run in two streams; a stage that fails ends its stream.
#
# Only the dev profile is built (it is optimised, see Cargo.toml). The tests themselves hold the hard cases, the
# committed Verilog and its figures: `hard-cases`, `generate --check` and `synth --check` would say them again.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if (($# > 0)); then
    printf 'Usage: scripts/test.sh\nInstalls what the full tests need (scripts/setup.sh) and runs them all.\n'
    [[ $1 == -h || $1 == --help ]] && exit 0
    exit 2
fi

export REQUIRE_EDA=1

scratch=$(mktemp -d)
streams=()
report() {
    local code=$? stream
    for stream in "${streams[@]}"; do
        kill -- -"$stream" 2>/dev/null || true
    done
    printf '\nseconds by stage:\n'
    cat "$scratch/seconds" 2>/dev/null || true
    printf '%6d  in all\n' "$SECONDS"
    ((code == 0)) || printf '\nfailed: %s (exit code %d, at %d s)\n' "$(cat "$scratch"/running.* 2>/dev/null)" "$code" "$SECONDS" >&2
    rm -rf "$scratch"
}
trap report EXIT

# Runs a command as a stage of this name. `running.N` names the stage in which process N is.
stage() {
    local start=$SECONDS
    printf 'stage "%s" ' "$1" >"$scratch/running.$BASHPID"
    printf '\n=== %s (at %d s)\n' "$1" "$SECONDS"
    "${@:2}"
    printf '%6d  %s\n' $((SECONDS - start)) "$1" >>"$scratch/seconds"
    rm "$scratch/running.$BASHPID"
}

# The tests have built what follows; cargo would build it once more for one package alone.
built=${CARGO_TARGET_DIR:-target}/debug

# Each is a program of seconds.
examples() {
    local file name arguments
    for file in crates/*/examples/*.rs testbenches/examples/*.rs; do
        name=$(basename "$file" .rs) arguments=()
        [[ $name == scaling ]] && arguments=(tile-10 133)
        "$built/examples/$name" "${arguments[@]}" >/dev/null || {
            echo "test: the example $file failed" >&2
            return 1
        }
    done
}

# The Verilog of all machines, of which only some are committed in full; each file by its committed digest.
all_verilog() {
    "$built/photoncube" generate
    (cd hdl-out && sha256sum --quiet --check SHA256SUMS)
}

stage "set-up" scripts/setup.sh --asic --ccache
stage "set-up of engines" scripts/setup.sh --cluster
stage "format" cargo fmt --all --check
stage "layers" scripts/check_layers.sh
stage "clippy" cargo clippy --locked --workspace --all-targets -- -D warnings
stage "docs" env RUSTDOCFLAGS="-D warnings" cargo doc --locked --workspace --no-deps
stage "build" cargo test --locked --workspace --no-run --quiet
stage "examples" examples
stage "all Verilog" all_verilog

# Two streams, because most checks wait for one simulator or one Yosys at a time. Every test is in one of them:
# the second has the test files that the first leaves out.
first_stream() {
    stage "test files a to d" cargo test --locked --workspace --test '[a-d]*' -- --include-ignored
    stage "unit tests" cargo test --locked --workspace --lib --bins -- --include-ignored
    stage "doc tests" cargo test --locked --workspace --doc
    stage "Verilog checks" scripts/yosys/check.sh
    stage "example testbenches" scripts/testbenches.sh
    stage "Yosys scripts" scripts/yosys/scripts.sh
    stage "Quartus projects" scripts/quartus/check.sh
    stage "second texts" scripts/yosys/ecp5.sh
    stage "copies of registers" scripts/yosys/copies.sh
    stage "cores by standard tools" scripts/core/check.sh
    stage "board" scripts/board/check.sh
    stage "engines of clusters" scripts/cluster/check.sh
}
second_stream() {
    stage "test files e to z" cargo test --locked --workspace --test '[!a-d]*' -- --include-ignored
}

# With job control, each stream is a process group, which ends as one when the script is interrupted.
set -m
first_stream &
second_stream >"$scratch/second.log" 2>&1 &
set +m
streams=($(jobs -p))
code=0
for stream in "${streams[@]}"; do
    wait "$stream" || code=$?
done
streams=()
cat "$scratch/second.log"
((code == 0)) || exit "$code"

printf '\nall stages passed\n'
