"""The tables of docs/cores.md and docs/machines.md about pictures: renders each with a core's emitted Verilog in Verilator and prints
Markdown.

    python3 scripts/core/pictures.py             # six scenes, by six chains and by one: a table for both pages
    python3 scripts/core/pictures.py --rounds    # one scene with each estimator, by a core with rounds
    python3 scripts/core/pictures.py --quick     # either table on small pictures, in a minute

The clocks are counted by the core, so they do not depend on the computer. Queries a second are those clocks at the median clock
frequency of docs/measured/core-*.json."""

from __future__ import annotations

import argparse
import json
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

HOUSE = Path(__file__).resolve().parents[2]
PROGRAM = HOUSE / "target/release/photoncube"
CHAIN = "leaf-7-local7-rgb6d-n4096"
CHAIN_WITH_ROUNDS = "leaf-7-radii-local7-rgb6d-n4096"
# The number of chains of the cores that were placed and routed.
PLACED = (6, 1)
# Scenes, each with its options.
SCENES = (
    ("cornell", ""),
    ("cornell", "--photons 210000 --size 512x512"),
    ("ring", "--photons 500000"),
    ("range", ""),
    ("docs/scenes/spheres.toml", ""),
    ("docs/scenes/balls.toml", ""),
)
# Six chains only: one takes six times as many clocks.
ROUNDS = [(PLACED[0], estimator) for estimator in ("fixed", "ladder:4:cone", "knn:50")]
QUICK = "--photons 5000 --size 16x16"
HEADER_OF_ONE = [
    "scene and options",
    "queries",
    "tests for each photon in range",
    "clocks fed",
    "queries a clock",
    "clocks",
    "forecast",
]


def render(picture: str, machine: str, chains: int) -> dict:
    """Renders the picture with a core of the emitted Verilog and returns what `render --json` says of the core."""
    print(f"rendering {picture} by {chains} x {machine}", file=sys.stderr, flush=True)
    with tempfile.TemporaryDirectory() as folder:
        command = [PROGRAM, "render", *picture.split(), "-o", f"{folder}/picture.exr", "--json"]
        command += ["--engine", "core", "--machine", machine, "--chains", str(chains)]
        done = subprocess.run(command, cwd=HOUSE, stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout)["core"]


def megahertz(chains: int) -> float:
    """The median clock of the placed core of that many chains, in MHz."""
    measured = json.loads((HOUSE / f"docs/measured/core-{chains}-{CHAIN}.json").read_text())
    return statistics.median(placed["fmax_mhz"] for placed in measured["placements"])


def table(header: list[str], rows: list[list[str]]) -> str:
    """A Markdown table."""
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join(f"| {' | '.join(cells)} |" for cells in lines)


def scenes(quick: bool) -> str:
    """The tables of the scenes: photon tests for each photon in range, engines fed, queries a second; and of one chain its clocks."""
    header = ["scene and options", "tests for each in range"]
    for chains in PLACED:
        of = f"{chains} chain{'s' if chains > 1 else ''}"
        header += [f"fed, {of}", f"M queries/s, {of}"]
    rows = []
    rows_of_one = []
    for scene, options in SCENES:
        picture = f"{scene} {QUICK if quick else options}".strip()
        cores = [render(picture, CHAIN, chains) for chains in PLACED]
        row = [f"`{picture}`", f"{cores[0]['tests_per_photon_in_range']:.2f}"]
        for chains, core in zip(PLACED, cores):
            queries = core["queries_per_clock"] * megahertz(chains)
            row += [f"{100 * core['engines_fed']:.0f} %", f"{queries:.1f}"]
        rows.append(row)
        rows_of_one.append(row_of_one(picture, cores[PLACED.index(1)]))
    return f"{table(header, rows)}\n\n{table(HEADER_OF_ONE, rows_of_one)}"


def row_of_one(picture: str, core: dict) -> list[str]:
    """A row of the table of one chain in docs/machines.md."""
    clocks = core["clocks"]
    queries = round(core["queries_per_clock"] * clocks)
    tests, fed = core["tests_per_photon_in_range"], f"{100 * core['engines_fed']:.0f} %"
    row = [f"`{picture}`", f"{queries:,}", f"{tests:.2f}", fed, f"{core['queries_per_clock']:.4f}"]
    return row + [f"{clocks:,}", f"{core['clocks_forecast']:,}"]


def rounds(quick: bool) -> str:
    """The table of the estimators of a core with rounds."""
    rows = []
    for chains, estimator in ROUNDS:
        options = QUICK if quick else "--size 256x256"
        core = render(f"cornell {options} --estimator {estimator}", CHAIN_WITH_ROUNDS, chains)
        clocks, rate, fed = core["clocks"], core["estimates_per_clock"], core["engines_fed"]
        rows.append([f"`{estimator}`", str(chains), f"{clocks:,}", f"{rate:.4f}", f"{100 * fed:.0f} %"])
    return table(["estimator", "chains", "clocks", "estimates a clock", "engines fed"], rows)


def main() -> None:
    """Prints the table that was asked for."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", action="store_true", help="the table of the estimators")
    parser.add_argument("--quick", action="store_true", help=f"all pictures with {QUICK}")
    chosen = parser.parse_args()
    print(rounds(chosen.quick) if chosen.rounds else scenes(chosen.quick))


if __name__ == "__main__":
    main()
