#!/usr/bin/env bash
# Every check that this project holds, from a fresh clone: installs what is missing, then runs them
# one after the other and stops at the first that fails.
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

name=start
times=()
report() {
    local code=$?
    printf '\nseconds by stage:\n'
    ((${#times[@]} == 0)) || printf '%6d  %s\n' "${times[@]}"
    printf '%6d  in all\n' "$SECONDS"
    ((code == 0)) || printf '\nstage failed: %s (exit code %d, at %d s)\n' "$name" "$code" "$SECONDS" >&2
}
trap report EXIT

stage() {
    local start=$SECONDS
    name=$1
    shift
    printf '\n=== %s (at %d s)\n' "$name" "$SECONDS"
    "$@"
    times+=($((SECONDS - start)) "$name")
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

stage "set-up" scripts/setup.sh
stage "format" cargo fmt --all --check
stage "layers" scripts/check_layers.sh
stage "clippy" cargo clippy --locked --workspace --all-targets -- -D warnings
stage "docs" env RUSTDOCFLAGS="-D warnings" cargo doc --locked --workspace --no-deps
stage "build" cargo test --locked --workspace --no-run --quiet
stage "tests" cargo test --locked --workspace
stage "examples" examples
stage "all Verilog" all_verilog
stage "Verilog checks" scripts/yosys/check.sh
stage "Yosys scripts" scripts/yosys/scripts.sh
stage "Quartus projects" scripts/quartus/check.sh
stage "second texts" scripts/yosys/ecp5.sh
stage "copies of registers" scripts/yosys/copies.sh

printf '\nall stages passed\n'
