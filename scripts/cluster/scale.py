#!/usr/bin/env python3
"""How work that is shared out scales: measured with two workers, and computed from that for a thousand.

Each worker has one core, so two idle cores are needed. Prints the page docs/measured/cluster.md:

    cargo build --locked --workspace --release
    scripts/cluster/scale.py > docs/measured/cluster.md

--quick makes the work so small that the figures mean nothing: it shows that the script runs.
"""

import argparse
import filecmp
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PROGRAM = os.environ.get("PHOTONCUBE", "target/release/photoncube")
WORKERS = 1000
VECTORS = 1e12
PHOTONS = 1e10
PIXELS = 3840 * 2160
PASS_PHOTONS = 1e7


def run(words, core=None):
    """Starts a command, on one core if that is given."""
    pinned = ["taskset", "-c", str(core)] if core is not None else []
    return subprocess.Popen([*pinned, PROGRAM, *words, "--json"], stdout=subprocess.PIPE, text=True)


def ended(process):
    """The report of a command that must succeed."""
    text, _ = process.communicate()
    if process.returncode != 0:
        sys.exit(f"{' '.join(process.args)}: ended with code {process.returncode}")
    return json.loads(text)


def shards(work, of, folder):
    """The seconds of all shards at once, each on a core of its own, and of merging; the reports, and the merged file."""
    states = [folder / f"{index}-{of}" for index in range(1, of + 1)]
    for state in states:
        state.unlink(missing_ok=True)
    begin = time.monotonic()
    workers = [
        run([*work, "--shard", f"{core + 1}/{of}", "--state", str(state)], core)
        for core, state in enumerate(states)
    ]
    reports = [ended(worker) for worker in workers]
    merged = folder / f"merged-{of}"
    merging = time.monotonic()
    ended(run(["merge", *map(str, states), "-o", str(merged)], 0))
    end = time.monotonic()
    return end - begin, end - merging, reports, merged


def works(quick):
    """The commands to measure, by name."""
    jobs, iterations = ("4", "2000") if quick else ("8", "200000")
    passes, size = ("4", "16x16") if quick else ("64", "256x256")
    photons, view = ("2000", "8x8") if quick else ("100000", "24x24")
    return {
        "verify campaign": ["verify", "campaign", "--jobs", jobs, "--iterations", iterations, "--machine", "paper"],
        "report --sweep": ["report", "--sweep", "cornell", "ring", "--in-range", "50,200", "--photons", photons,
                           "--maps", "4", "--size", view],
        "progressive": ["progressive", "cornell", "--passes", passes, "--size", size, "--photons", "100000",
                        "--samples", "1"],
    }


def merge_rate(work, folder, times):
    """Bytes a second of merging `times` files of the shards of a work, and the bytes of one."""
    states = []
    for index in range(1, times + 1):
        state = folder / f"part-{index}"
        ended(run([*work, "--shard", f"{index}/{times}", "--state", str(state)]))
        states.append(state)
    size = sum(state.stat().st_size for state in states)
    begin = time.monotonic()
    ended(run(["merge", *map(str, states), "-o", str(folder / "merged")], 0))
    return size / (time.monotonic() - begin), size / times


def pass_costs(quick):
    """The seconds of a pass for each photon and for each pixel, on one core."""
    photons, size = (2000, 16) if quick else (200_000, 256)

    def of(photons, size):
        """The seconds of a pass, without what a command does once."""
        times = []
        for passes in (2, 6):
            with tempfile.TemporaryDirectory() as folder:
                begin = time.monotonic()
                ended(run(["progressive", "cornell", "--passes", str(passes), "--size", f"{size}x{size}", "--samples", "1",
                           "--photons", str(photons), "--shard", "1/1", "--state", f"{folder}/state"], 0))
                times.append(time.monotonic() - begin)
        return (times[1] - times[0]) / 4

    base, of_photons, of_pixels = of(photons, size), of(4 * photons, size), of(photons, 2 * size)
    return (of_photons - base) / (3 * photons), (of_pixels - base) / (3 * size * size)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=3, help="rounds of one worker and two, in turn")
    parser.add_argument("--quick", action="store_true", help="so little work that the figures mean nothing")
    args = parser.parse_args()
    if (os.cpu_count() or 1) < 2:
        sys.exit("found one core, expected two: two workers have a core each")
    rows, found = [], {}
    for name, work in works(args.quick).items():
        with tempfile.TemporaryDirectory() as folder:
            folder = Path(folder)
            shards(work, 2, folder)  # simulators are built once, and kept
            rounds = []
            for number in range(args.rounds):
                one, two = shards(work, 1, folder), shards(work, 2, folder)
                if not filecmp.cmp(one[3], two[3], shallow=False):
                    sys.exit(f"{name}: the merged files of one worker and of two differ")
                rounds.append((one, two))
                print(f"{name}, round {number + 1}: {one[0] / two[0]:.2f}", file=sys.stderr)
            ratio = statistics.median([one[0] / two[0] for one, two in rounds])
            one, two = rounds[-1]
            found[name] = (one, statistics.median([one[0] for one, _ in rounds]), one[3].stat().st_size)
            rows.append(f"| `{name}` | {statistics.median([o[0] for o, _ in rounds]):.1f} | {statistics.median([t[0] for _, t in rounds]):.1f} "
                        f"| {ratio:.2f} | {two[1]:.2f} |")
    print("# Two workers, and a thousand\n")
    print("Written by `scripts/cluster/scale.py`. [cluster.md](../cluster.md) says what shards are.\n")
    print("## Measured\n")
    print(f"The median of {args.rounds} rounds; each worker has one core. The time of two workers has that of merging "
          "in it. The merged files\nof one worker and of two are equal, byte for byte.\n")
    print("| work | one worker, s | two workers, s | ratio | of it merging, s |")
    print("| --- | --- | --- | --- | --- |")
    print("\n".join(rows))
    lines = scaled_lines(found, args.quick)
    print("\n## Computed\n")
    print("\n".join(lines))


def scaled_lines(found, quick):
    """What a thousand workers need, by the measured times."""
    campaign, seconds, size = found["verify campaign"]
    vectors = campaign[2][0]["vectors_compared"]
    jobs = int(works(quick)["verify campaign"][3])
    worker_rate, line = vectors / seconds, size / jobs
    all_jobs = VECTORS / (vectors / jobs)
    with tempfile.TemporaryDirectory() as folder:
        picture = works(quick)["progressive"]
        wide = [word if word not in ("256x256", "16x16") else ("64x64" if quick else "1024x1024") for word in picture]
        wide[wide.index("--passes") + 1] = "8"
        rate, bytes_each = merge_rate(wide, Path(folder), 8)
    pixels = (64 if quick else 1024) ** 2
    with tempfile.TemporaryDirectory() as folder:
        small = works(True)["report --sweep"]
        line_rate, _ = merge_rate(small, Path(folder), 8)
    each_photon, each_pixel = pass_costs(quick)
    pass_seconds = each_photon * PASS_PHOTONS + each_pixel * PIXELS
    all_passes = PHOTONS / PASS_PHOTONS
    state = bytes_each / pixels * PIXELS
    return [
        f"- {VECTORS:.0e} vectors of `paper` are {all_jobs:,.0f} jobs like those measured. {WORKERS:,} workers of one core need "
        f"{VECTORS / worker_rate / WORKERS / 3600:.1f} hours at\n  {worker_rate:,.0f} vectors a second each. Their state files "
        f"have {all_jobs * line / 1e6:,.0f} MB in all, {line:.0f} bytes a job, which merge in "
        f"{all_jobs * line / line_rate:.0f} s\n  ({line_rate / 1e6:.0f} MB/s), a line of each file in memory.",
        f"- A picture of 3840 x 2160 pixels and {PHOTONS:.0e} photons is {all_passes:,.0f} passes of {PASS_PHOTONS:.0e} photons. A "
        f"pass takes {pass_seconds / 60:.0f} minutes on one core: {1e6 * each_photon:.2f} us\n  a photon and {1e6 * each_pixel:.2f} us a "
        f"pixel, by pictures of other sizes. A state file has {state / 1e9:.1f} GB "
        f"({bytes_each / pixels:.0f} bytes a pixel).\n  One process merges {WORKERS:,} of them in "
        f"{state * WORKERS / rate / 3600:.1f} hours ({rate / 1e6:.0f} MB/s), in the memory of two states. This binds first.",
        f"- In two steps (`--partial`), 32 processes that merge 32 files each, and one that merges theirs, need "
        f"{state * 64 / rate / 60:.0f} minutes.",
    ]


if __name__ == "__main__":
    main()
