#!/usr/bin/env bash
# Runs the cocotb tests on the Verilog of a core, in Icarus.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)

usage() {
    cat <<USAGE
Usage: testbenches/cocotb/run.sh [--long] [--faults] [--machine M] [--chains N] [--seed N] [--test NAME] [--help]

Writes the Verilog of a core with \`photoncube generate\` and drives it through cocotbext-axi in Icarus: random words
with random pauses on every port, wrong words, resets, registers. Every result, event and counter is compared with a
reference in Python. It ends 1 where anything differs, or where too few words were compared.

  --long       at least 100000 words on each stream, instead of a minute's worth
  --faults     then plant one fault after the other in the Verilog, and end 1 if the tests miss one
  --machine M  the leaf machine (default: leaf-4-local7-rgb6d-n64)
  --chains N   its number (default: 3, so that tdest can name a chain that there is not)
  --seed N     where the random numbers begin (default: 1)
  --test NAME  only this test of test_core.py
  --help       this text

Environment:
  PHOTONCUBE    the program (default: the debug build of this checkout)
  PHOTONCUBE_TOOLS  as for scripts/setup.sh, which installs cocotb

Exit codes: 0 all is equal; 1 something differs or a tool is missing; 2 bad usage.
USAGE
}

note() { printf 'cocotb: %s\n' "$*" >&2; }
bad_usage() {
    note "$@"
    exit 2
}

machine=leaf-4-local7-rgb6d-n64 chains=3 seed=1 long=0 faults=0 tests=()
while (($# > 0)); do
    case $1 in
        --long) long=1 ;;
        --faults) faults=1 ;;
        --machine | --chains | --seed | --test)
            (($# > 1)) || bad_usage "found nothing behind $1, expected a value"
            case $1 in
                --machine) machine=$2 ;;
                --chains) chains=$2 ;;
                --seed) seed=$2 ;;
                --test) tests+=(--test "$2") ;;
            esac
            shift
            ;;
        -h | --help)
            usage
            exit 0
            ;;
        *) bad_usage "found \`$1\`, expected --long, --faults, --machine, --chains, --seed, --test or --help" ;;
    esac
    shift
done
[[ $chains =~ ^[0-9]+$ && $seed =~ ^[0-9]+$ ]] || bad_usage "found --chains $chains --seed $seed, expected whole numbers"

program=${PHOTONCUBE:-${CARGO_TARGET_DIR:-$root/target}/debug/photoncube}
[[ -x $program ]] || {
    note "found no $program; build it with cargo, or set PHOTONCUBE"
    exit 1
}
python=$("$root/scripts/setup.sh" --where-core)/python
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$program" generate --machine "$machine" --chains "$chains" --out "$scratch" >/dev/null
core=$scratch/core-$chains-$machine

# Runs the tests on the core in the folder $1, with $2 rounds of traffic, $3 of wrong words, $4 resets and at least
# $5 words on each stream.
run_tests() {
    "$python" "$here/run.py" --core "$1" --build "$1/build" --rounds "$2" --wrong-rounds "$3" --resets "$4" \
        --least-beats "$5" --seed "$seed" "${@:6}"
}

if ((long)); then
    work=(13500 400 60) least=100000
else
    work=(16 12 4) least=$((100 * chains))
fi
# Where single tests are named, the words are those of these alone.
((${#tests[@]} == 0)) || least=0
run_tests "$core" "${work[@]}" "$least" "${tests[@]}"
((faults)) || exit 0

for fault in $("$python" "$here/faults.py" --list); do
    broken=$scratch/$fault/$(basename "$core")
    mkdir -p "$scratch/$fault"
    cp -r "$core" "$broken"
    rm -rf "$broken/build"
    for text in "$broken"/*.streams.json; do
        "$python" "$here/faults.py" "$fault" "${text%.streams.json}.v"
    done
    code=0
    run_tests "$broken" 0 12 2 0 --test wrong_words --test resets_in_flight >"$scratch/$fault/log" 2>&1 || code=$?
    # The tests themselves must have failed, not their start.
    if ((code != 1)) || ! grep -q 'tests passed' "$scratch/$fault/log"; then
        note "the tests missed the fault $fault (exit code $code):"
        tail -20 "$scratch/$fault/log" >&2
        exit 1
    fi
    printf 'cocotb: the fault %s was found\n' "$fault"
done
