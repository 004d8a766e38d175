#!/usr/bin/env python3
"""CPU seconds to an error: `photoncube progressive` of two versions with their default options.

Usage: accuracy_before.py OLD NEW SCENE TRUTH [SCENE TRUTH ...]

OLD and NEW are programs; TRUTH is a picture of 64 x 64 pixels. Prints the curves, and for the least error that both reach the seconds that
each takes to it, interpolated on a logarithmic scale; < marks an error that the first point is below already. Seconds are user and
system time of all threads, of the whole program.
"""

import json
import sys
import tempfile

from cpu_seconds import progressive, time_to

SIDE = 64
PASSES = [2, 4, 8, 16, 32, 64]


def point(program, scene, truth, passes):
    """The CPU seconds and the relMSE of a picture."""
    with tempfile.TemporaryDirectory() as folder:
        picture = f"{folder}/picture.exr"
        used, said = progressive(program, scene, picture, SIDE, passes, "--reference", truth, "--json")
    return used, json.loads(said)["progress"][-1]["rel_mse"]


def time_or_bound(curve, error):
    """The seconds to an error, which the last point reaches, and < where all points are below it."""
    found = time_to(curve, error)
    return (curve[0][0], "<") if found is None else (found, "")


def main():
    if len(sys.argv) < 5 or len(sys.argv) % 2 == 0:
        sys.exit(__doc__)
    old, new, *rest = sys.argv[1:]
    curves = {}
    for scene, truth in zip(rest[::2], rest[1::2]):
        for version, program in (("before", old), ("now", new)):
            curves[scene, version] = [point(program, scene, truth, passes) for passes in PASSES]
    print("| scene | to relMSE | before, CPU s | now, CPU s | ratio |")
    print("| --- | --- | --- | --- | --- |")
    for scene in rest[::2]:
        both = [curves[scene, version] for version in ("before", "now")]
        error = max(curve[-1][1] for curve in both)
        (before, _), (now, mark) = (time_or_bound(curve, error) for curve in both)
        print(f"| `{scene}` | {error:.1e} | {before:.2f} | {mark}{now:.2f} | {'>' if mark else ''}{before / now:.0f} |")
    print("\nThe curves:\n\n| scene | version | passes | CPU s | relMSE |\n| --- | --- | --- | --- | --- |")
    for (scene, version), curve in curves.items():
        for passes, (seconds, error) in zip(PASSES, curve):
            print(f"| `{scene}` | {version} | {passes} | {seconds:.2f} | {error:.2e} |")


main()
