"""Builds a core's Verilog with Icarus and runs the tests of test_core.py on it. scripts call it through run.sh."""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections import Counter
from pathlib import Path

from cocotb.runner import get_results, get_runner

HERE = Path(__file__).parent


def arguments() -> argparse.Namespace:
    """The command line. run.sh says what each argument is."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--core", type=Path, required=True)
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--rounds", type=int, required=True)
    parser.add_argument("--wrong-rounds", type=int, required=True)
    parser.add_argument("--resets", type=int, required=True)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--least-beats", type=int, required=True)
    parser.add_argument("--test", action="append", default=[])
    return parser.parse_args()


def beats_of(totals: Path) -> Counter[str]:
    """The beats of all tests on each stream."""
    beats: Counter[str] = Counter()
    if totals.exists():
        for line in totals.read_text().splitlines():
            beats.update(json.loads(line))
    return beats


def main() -> int:
    """Runs the tests. Ends 1 where one fails or where fewer beats moved than were asked for."""
    given = arguments()
    folder, build = given.core.resolve(), given.build.resolve()
    source = next(folder.glob("*.streams.json")).name.removesuffix(".streams.json")
    totals = build / "totals.jsonl"
    build.mkdir(parents=True, exist_ok=True)
    totals.unlink(missing_ok=True)
    # cocotb's runner starts the simulator with this path, where the simulator's Python finds the tests.
    sys.path.insert(0, str(HERE))
    runner = get_runner("icarus")
    runner.build(
        verilog_sources=[folder / f"{source}.v"],
        hdl_toplevel=source,
        build_dir=build,
        # Verilog-2005 is the language of the text. In SystemVerilog, variables have their initial values before `always @(*)` waits for
        # a change, so that Icarus never runs a block whose inputs stay as they are.
        build_args=["-g2005"],
        timescale=("1ns", "1ps"),
        always=True,
    )
    environment = {
        "PHOTONCUBE_CORE": str(folder),
        "PHOTONCUBE_ROUNDS": str(given.rounds),
        "PHOTONCUBE_WRONG": str(given.wrong_rounds),
        "PHOTONCUBE_RESETS": str(given.resets),
        "PHOTONCUBE_SEED": str(given.seed),
        "PHOTONCUBE_TOTALS": str(totals),
        "COCOTB_LOG_LEVEL": os.environ.get("COCOTB_LOG_LEVEL", "INFO"),
    }
    results = runner.test(
        hdl_toplevel=source,
        test_module="test_core",
        testcase=given.test or None,
        build_dir=build,
        test_dir=build,
        extra_env=environment,
    )
    tests, failures = get_results(results)
    beats = beats_of(totals)
    streams = ("photons", "queries", "results")
    moved = ", ".join(f"{beats[stream]} {stream}" for stream in streams)
    print(f"cocotb: {source}: {tests - failures} of {tests} tests passed; beats: {moved}")
    if tests == 0:
        print("cocotb: no test ran", file=sys.stderr)
        return 1
    short = [stream for stream in streams if beats[stream] < given.least_beats]
    if short:
        print(f"cocotb: fewer than {given.least_beats} beats of {', '.join(short)}", file=sys.stderr)
    return int(failures > 0 or bool(short))


if __name__ == "__main__":
    sys.exit(main())
