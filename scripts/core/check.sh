#!/usr/bin/env bash
# Checks the emitted cores with tools of other people: cocotb, PeakRDL, FuseSoC, LiteX.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)

if (($# > 0)); then
    cat <<USAGE
Usage: scripts/core/check.sh

Writes small cores with \`photoncube generate\` and checks their Verilog by cocotb, whose tests must also find planted faults, their
SystemRDL by PeakRDL and the C compiler, both by FuseSoC, and the core in a LiteX SoC by simulation. PHOTONCUBE is the program
(default: the debug build).
USAGE
    [[ $1 == -h || $1 == --help ]] && exit 0
    exit 2
fi

program=${PHOTONCUBE:-${CARGO_TARGET_DIR:-$root/target}/debug/photoncube}
[[ -x $program ]] || {
    printf 'check: found no %s; build it with cargo, or set PHOTONCUBE\n' "$program" >&2
    exit 1
}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
python=$("$root/scripts/setup.sh" --where-core)/python
# A core with rounds and one without. FuseSoC and LiteX check the second.
for machine in leaf-4-radii-local7-rgb6d-n64 leaf-4-local7-rgb6d-n64; do
    "$program" generate --machine "$machine" --chains 1 --out "$scratch" >/dev/null
    core=$scratch/core-1-$machine
    words=("$core"/*.streams.json)
    registers=$scratch/registers-$machine
    "$here/registers.sh" "${words[0]%.streams.json}.rdl" "$registers"
    # PeakRDL's second file asserts the offsets of all registers when it runs.
    gcc -std=c11 -Wall -Wextra -Werror -fsyntax-only "$registers/registers.h"
    gcc -std=c11 -I "$registers" "$registers/registers.h.test.c" -o "$scratch/offsets"
    "$scratch/offsets"
    "$python" "$here/registers.py" "${words[0]}" "$registers"
done
"$here/fusesoc.sh" "$core"
"$root/scripts/litex/check.sh" "$core"
"$root/testbenches/cocotb/run.sh" --faults
# Queries with radii, of which some are above the largest.
"$root/testbenches/cocotb/run.sh" --machine leaf-4-radii-local7-rgb6d-n64 --test random_traffic --test wrong_words
