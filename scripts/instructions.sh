#!/usr/bin/env bash
# Whether the fast gather equals the plain gather on processors that this machine is not: under emulators.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/instructions.sh [--cases N] [NAME...]

Runs the tests of the fast gather (crates/model/tests/planes) under QEMU's emulators of other processors (default: all):

  neon      64-bit Arm
  avx2      x86-64 with AVX2, without AVX-512; only on x86-64
  portable  x86-64 without AVX2, where only the portable loops run; only on x86-64

Each run first checks that the emulated processor offers the instruction sets of its name. Installs what is missing
(scripts/setup.sh --emulators). Ten minutes on two cores, most of them to build.

  --cases N  random scenes for each property (default: 300; without an emulator the tests use 2000)

Limits: an emulator shows that results are equal, and nothing of speed. QEMU 7.2 emulates no AVX-512, which is tested
only where the processor has it. An emulator may have faults of its own that a processor has not, and the reverse.

Exit codes: 0 all tests pass; 1 one does not; 2 bad usage.
USAGE
}

cases=300 names=()
while (($# > 0)); do
    case $1 in
        -h | --help)
            usage
            exit 0
            ;;
        --cases)
            cases=${2-}
            shift
            ;;
        neon | avx2 | portable) names+=("$1") ;;
        *)
            printf 'instructions: found `%s`, expected --cases, neon, avx2 or portable\n' "$1" >&2
            exit 2
            ;;
    esac
    shift
done
[[ $cases =~ ^[1-9][0-9]*$ ]] || {
    printf 'instructions: found --cases `%s`, expected a number above 0\n' "$cases" >&2
    exit 2
}

cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/setup.sh --emulators
if ((${#names[@]} == 0)); then
    names=(neon)
    [[ $(uname -m) == x86_64 ]] && names+=(avx2 portable)
fi

# Runs the tests for the target $1 under the emulator $2. The instruction sets must be those of $3.
emulate() {
    local target=$1 variable=${1^^}
    variable=CARGO_TARGET_${variable//-/_}
    printf '\n=== %s, in %s\n' "$3" "$2"
    env "${variable}_RUNNER=$2" PHOTONCUBE_INSTRUCTIONS="$3" PROPTEST_CASES="$cases" \
        cargo test --locked --package photoncube-model --test planes --target "$target"
}

for name in "${names[@]}"; do
    case $name in
        neon)
            export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc
            emulate aarch64-unknown-linux-gnu "qemu-aarch64 -L /usr/aarch64-linux-gnu" "NEON, portable"
            ;;
        avx2) emulate x86_64-unknown-linux-gnu "qemu-x86_64 -cpu max" "AVX2, portable" ;;
        portable) emulate x86_64-unknown-linux-gnu "qemu-x86_64 -cpu Nehalem" "portable" ;;
    esac
done
