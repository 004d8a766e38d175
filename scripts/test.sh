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
# A first build is faster without the data for incremental builds, and with one codegen unit a crate; the tests then run
# faster too. Where incremental data exist, the settings of the profile stay, so that nothing is compiled anew. Cargo makes
# their folder in any case.
compgen -G "${CARGO_TARGET_DIR:-target}/debug/incremental/*" >/dev/null ||
    export CARGO_INCREMENTAL=0 CARGO_PROFILE_DEV_CODEGEN_UNITS=1

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

# The compilers need no tool, and the tools are downloaded while the compilers work.
set_up() {
    stage "set-up" scripts/setup.sh --asic --ccache
    stage "set-up of engines" scripts/setup.sh --cluster
}

# Starts a command as a process group, which ends as one when the script is interrupted.
start() {
    set -m
    "$@" &
    set +m
    streams+=($!)
}

# Runs a function whose output `finish` prints.
logged() { "$1" >"$scratch/$1.log" 2>&1; }

finish() {
    local code=0
    wait "$2" || code=$?
    cat "$scratch/$1.log"
    return "$code"
}

stage "rustfmt and clippy" scripts/setup.sh --rust
# Rust links with the C compiler, which the set-up installs where there is none.
if command -v cc >/dev/null; then start logged set_up; else set_up; fi
stage "format" cargo fmt --all --check
stage "layers" scripts/check_layers.sh
stage "clippy" cargo clippy --locked --workspace --all-targets -- -D warnings
stage "docs" env RUSTDOCFLAGS="-D warnings" cargo doc --locked --workspace --no-deps
stage "build" cargo test --locked --workspace --no-run --quiet
stage "examples" examples
((${#streams[@]} == 0)) || finish set_up "${streams[0]}"
streams=()

# Two streams, because most checks wait for one simulator or one Yosys at a time. Every test is in one of them:
# the second has the test files that the first leaves out.
first_stream() {
    stage "test files a to d" cargo test --locked --workspace --test '[a-d]*' -- --include-ignored
    stage "unit tests" cargo test --locked --workspace --lib --bins -- --include-ignored
    stage "doc tests" cargo test --locked --workspace --doc
    stage "all Verilog" all_verilog
    stage "Verilog checks" scripts/yosys/check.sh
    stage "second texts" scripts/yosys/ecp5.sh
    stage "example testbenches" scripts/testbenches.sh
    stage "Yosys scripts" scripts/yosys/scripts.sh
    stage "Quartus projects" scripts/quartus/check.sh
    stage "copies of registers" scripts/yosys/copies.sh
}
second_stream() {
    stage "test files e to z" cargo test --locked --workspace --test '[!a-d]*' -- --include-ignored
    stage "cores by standard tools" scripts/core/check.sh
    stage "board" scripts/board/check.sh
    stage "engines of clusters" scripts/cluster/check.sh
}

start first_stream
start logged second_stream
code=0
wait "${streams[0]}" || code=$?
finish second_stream "${streams[1]}" || code=$?
streams=()
((code == 0)) || exit "$code"

printf '\nall stages passed\n'
