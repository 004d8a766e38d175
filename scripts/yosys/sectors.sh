#!/usr/bin/env bash
# What the counters of the chi-square rule would cost in the machine `stream`.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/yosys/sectors.sh [FOLDER]

The chi-square rule of `photoncube progressive` counts the photons in range of a query in 8 sectors: two rings, by a second
comparison of each photon's squared distance, and four quadrants, by the signs of two differences. The counters are not
in any machine. This script writes them as Verilog, from the modules of `stream` in FOLDER (default: hdl-out/stream), and
prints their cells of the ECP5 by Yosys beside those of `stream`:
  8, full   as the machine counts its photons: each counter has the width of result_count and a register for the result
  8, least  counters of 8 bits, which are read where they count: the machine waits while they are
  4, full   quadrants of one ring: a gather at half the squared radius, which passes make anyway, gives those of the other
  4, least  the same with counters of 8 bits that are read where they count
Icarus shows first that all count right: 4000 groups in 40 queries, against a plain count.

Exit codes: 0 the table is printed; 1 a count is wrong; 2 bad usage, a missing file or a missing tool.
USAGE
}

# shellcheck source=scripts/yosys/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
read_options "$@"
need "$prover" iverilog vvp python3
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=${1:-$root/hdl-out/stream}
[[ -e $folder/photoncube_stream.v && -e $folder/photoncube_stream_ecp5.v ]] || {
    echo "sectors: found no photoncube_stream.v and photoncube_stream_ecp5.v in $folder" >&2
    exit 2
}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp "$folder"/photoncube_stream{,_ecp5}.v "$(dirname "${BASH_SOURCE[0]}")"/sectors{,_tb}.v "$scratch"

for rings in 2 1; do
    for full in 1 0; do
        iverilog -g2005 -P"sectors_tb.RINGS=$rings" -P"sectors_tb.FULL=$full" -s sectors_tb -o "$scratch/tb" \
            "$scratch/photoncube_stream.v" "$scratch/sectors.v" "$scratch/sectors_tb.v"
        vvp -n "$scratch/tb" >"$scratch/said"
        grep -q '^right: 40 queries$' "$scratch/said" || {
            echo "sectors: $((4 * rings)) counters, FULL=$full: a count is wrong:" >&2
            head -3 "$scratch/said" >&2
            exit 1
        }
    done
done

# The cells of the top module $2 with the parameters $3, as the script of the machine maps them, into the file $1.
cells() {
    yosys_in "$scratch" "read_verilog photoncube_stream.v sectors.v; read_verilog -overwrite photoncube_stream_ecp5.v;
        ${3:+chparam $3 $2;} scratchpad -set abc9.D 10000; synth_ecp5 -top $2; tee -q -o out.json stat -json" >"$scratch/log" 2>&1 || {
        tail -3 "$scratch/log" >&2
        exit 2
    }
    mv "$scratch/out.json" "$scratch/$1"
}
cells stream.json photoncube_stream ''
for rings in 2 1; do
    cells "$((4 * rings)), full.json" sectors "-set RINGS $rings -set FULL 1"
    cells "$((4 * rings)), least.json" sectors "-set RINGS $rings -set FULL 0"
done

python3 - "$scratch" <<'PY'
import json, sys

def figures(name):
    cells = json.load(open(f"{sys.argv[1]}/{name}.json"))["design"]["num_cells_by_type"]
    lut4, ccu2c, ff = (cells.get(kind, 0) for kind in ("LUT4", "CCU2C", "TRELLIS_FF"))
    return lut4, ccu2c, lut4 + 2 * ccu2c, ff

stream = figures("stream")
print("| | LUT4 | CCU2C | LUT4 equivalents | of those of `stream` | FF |")
print("| --- | --- | --- | --- | --- | --- |")
for name in ("stream", "8, full", "8, least", "4, full", "4, least"):
    lut4, ccu2c, both, ff = figures(name)
    print(f"| {name} | {lut4} | {ccu2c} | {both} | {100 * both / stream[2]:.0f} % | {ff} |")
PY
