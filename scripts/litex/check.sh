#!/usr/bin/env bash
# Simulates a core in a LiteX SoC, and shows that the simulation finds faults.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)

usage() {
    cat <<USAGE
Usage: scripts/litex/check.sh DIR [--seed N]

DIR has a core as \`photoncube generate --chains\` wrote it; nothing is written there. Simulates the core in an SoC by LiteX, without
a CPU, in Icarus: words through the streams, reads of registers over the SoC's Wishbone bus, the interrupt. All are compared with
the reference of testbenches/cocotb. Then plants faults in the core's Verilog, each of which must be found. The programs are those of
scripts/setup.sh.

Exit codes: 0 all is equal and every fault is found; 1 something differs or a fault is missed; 2 bad usage.
USAGE
}

note() { printf 'litex: %s\n' "$*" >&2; }

if [[ ${1:-} == -h || ${1:-} == --help ]]; then
    usage
    exit 0
fi
if (($# != 1)) && [[ $# -ne 3 || $2 != --seed || ! $3 =~ ^[0-9]+$ ]]; then
    usage >&2
    exit 2
fi
core=$1
words=("$core"/*.streams.json)
if [[ ! -f ${words[0]} ]]; then
    note "found no .streams.json in $core; expected the folder of a core"
    exit 2
fi
python=$("$root/scripts/setup.sh" --where-core)/python
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$python" "$here/simulate.py" --core "$core" --build "$scratch/build" "${@:2}"
# A counter and a stream.
for fault in count-down lose-word; do
    broken=$scratch/$fault
    mkdir "$broken"
    cp "$core"/*.v "$core"/*.streams.json "$broken"
    "$python" "$root/testbenches/cocotb/faults.py" "$fault" "$broken/$(basename "${words[0]}" .streams.json).v"
    code=0
    "$python" "$here/simulate.py" --core "$broken" --build "$scratch/build" "${@:2}" >"$scratch/log" 2>&1 || code=$?
    # The comparison must have failed, not its start.
    if ((code != 1)) || ! grep -q ': found ' "$scratch/log"; then
        note "the simulation missed the fault $fault (exit code $code):"
        tail -20 "$scratch/log" >&2
        exit 1
    fi
    printf 'litex: the fault %s was found\n' "$fault"
done
