#!/usr/bin/env python3
"""CPU seconds to an error: `photoncube progressive` of two versions with their default options.

Usage: accuracy_before.py OLD NEW SCENE TRUTH [SCENE TRUTH ...]

OLD and NEW are programs; TRUTH is a picture of 64 x 64 pixels. Prints the curves, and for the least error that both reach the seconds that
each takes to it, interpolated on a logarithmic scale; < marks an error that the first point is below already. Seconds are user and
system time of all threads, of the whole program.
"""

import json
import math
import resource
import subprocess
import sys
import tempfile

PASSES = [2, 4, 8, 16, 32, 64]


def point(program, scene, truth, passes):
    """The CPU seconds and the relMSE of a picture."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "progressive", scene, "--size", "64x64", "-o", f"{folder}/picture.exr", "--engine", "format"]
        command += ["--passes", str(passes), "--reference", truth, "--json"]
        said = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return seconds, json.loads(said)["progress"][-1]["rel_mse"]


def seconds_to(curve, error):
    """The seconds at which a curve falls to an error that it reaches, and < where its first point is below."""
    points = [(math.log(seconds), math.log(reached)) for seconds, reached in curve]
    wanted = math.log(error)
    if wanted > points[0][1]:
        return "<", curve[0][0]
    for (t0, e0), (t1, e1) in zip(points, points[1:]):
        if e1 <= wanted <= e0:
            return "", math.exp(t0 + (t1 - t0) * (wanted - e0) / (e1 - e0))
    return "", curve[-1][0]


def main():
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
        (_, old_seconds), (mark, new_seconds) = (seconds_to(curve, error) for curve in both)
        ratio = f"{'>' if mark else ''}{old_seconds / new_seconds:.0f}"
        print(f"| `{scene}` | {error:.1e} | {old_seconds:.2f} | {mark}{new_seconds:.2f} | {ratio} |")
    print("\nThe curves:\n\n| scene | version | passes | CPU s | relMSE |\n| --- | --- | --- | --- | --- |")
    for (scene, version), curve in curves.items():
        for passes, (seconds, error) in zip(PASSES, curve):
            print(f"| `{scene}` | {version} | {passes} | {seconds:.2f} | {error:.2e} |")


main()
