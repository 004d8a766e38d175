#!/usr/bin/env python3
"""CPU seconds to an error: Mitsuba's path tracer beside `photoncube progressive` with its default options.

Usage: path_tracer.py PHOTONCUBE WORK_FOLDER

PHOTONCUBE is the program; WORK_FOLDER gets the scenes and the pictures. Scenes: the Cornell box with boxes, with a ball of glass, with a mirror ball; 128 x 128 pixels. The
truth is Mitsuba's path tracer with SAMPLES samples a pixel in each of two halves; their difference gives its own noise, which is
taken off every error. The measure is relMSE without the light and the pixels that touch it. Seconds are of all threads, user and system, of
the render call for Mitsuba (compiled before, by a picture that does not count) and of the whole program for photoncube. Both
curves are interpolated on a logarithmic scale; ~ marks what lies beyond the measured points.
"""

import json
import os
import resource
import sys
from pathlib import Path

import mitsuba as mi
import numpy as np

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "docs" / "reference"))
import mitsuba_scene
from cpu_seconds import progressive, seconds, time_to

SIDE = 128
SAMPLES = 8192
MITSUBA_SAMPLES = [64, 128, 256, 512, 1024, 2048]
PASSES = [2, 4, 8, 16, 32]
LEVELS = [1e-2, 5e-3, 2e-3]
# Pixels brighter than this, and their neighbours, show the light; `photoncube compare` masks them as well.
LIGHT = 5.0


def scenes():
    """The Cornell box, and the same walls with one ball."""
    with open(ROOT / "crates" / "render" / "scenes" / "cornell.json", encoding="utf-8") as file:
        boxes = json.load(file)
    walls = {name: shape for name, shape in boxes["shapes"].items() if shape["kind"] == "quad"}
    white = {"type": "rgb", "value": [1.0, 1.0, 1.0]}
    balls = {
        "glass": {"type": "dielectric", "int_ior": 1.5, "ext_ior": 1.0},
        "mirror": {"type": "conductor", "material": "none", "specular_reflectance": white},
    }
    yield "boxes", boxes
    for name, material in balls.items():
        ball = {"kind": "sphere", "center": [0.0, -0.55, 0.0], "radius": 0.45, "bsdf": material}
        yield name, boxes | {"name": name, "shapes": walls | {"ball": ball}}


class Mitsuba:
    """A scene in Mitsuba, compiled."""

    def __init__(self, text):
        self.scene = mitsuba_scene.load(text, SIDE, 1)
        self.render(1, 0)

    def render(self, samples, seed):
        return np.array(mi.render(self.scene, spp=samples, seed=seed)).astype(float)

    def timed(self, samples, seed):
        start = seconds(resource.RUSAGE_SELF)
        picture = self.render(samples, seed)
        return seconds(resource.RUSAGE_SELF) - start, picture


def photoncube(program, scene, picture, passes):
    """The seconds and the picture of a run with the default options."""
    used, _ = progressive(program, scene, picture, SIDE, passes)
    return used, np.array(mi.Bitmap(str(picture))).astype(float)


def mask(picture):
    """The pixels that do not touch the light."""
    bright = np.pad(picture.max(axis=2) > LIGHT, 1)
    rows = [bright[y : y + SIDE, x : x + SIDE] for y in range(3) for x in range(3)]
    return ~np.any(rows, axis=0)


def rel_mse(picture, truth, kept):
    relative = (picture - truth) ** 2 / (truth**2 + 1e-4)
    return relative.mean(axis=2)[kept].mean()


def time_or_guess(curve, level):
    """The seconds to an error, and ~ where that is extrapolated beyond the measured points."""
    found = time_to(curve, level)
    if found is not None:
        return found, ""
    errors, times = np.log(sorted((error, time) for time, error in curve)).T
    level = np.log(level)
    ends = slice(0, 2) if level < errors[0] else slice(-2, None)
    slope, start = np.polyfit(errors[ends], times[ends], 1)
    return np.exp(slope * level + start), "~"


def measure(program, work, name, text):
    """The curves of both, as (seconds, net error)."""
    peer = Mitsuba(text)
    halves = [peer.render(SAMPLES, seed) for seed in (1000, 2000)]
    truth = (halves[0] + halves[1]) / 2
    mi.Bitmap(truth.astype(np.float32)).write(str(work / f"{name}-truth.exr"))
    kept = mask(truth)
    # The variance of the mean of two is a quarter of that of their difference.
    noise = rel_mse(halves[0], halves[1], kept) / 4
    scene = work / f"{name}.json"
    scene.write_text(json.dumps(text), encoding="utf-8")
    runs = [peer.timed(samples, 1 + seed) for seed, samples in enumerate(MITSUBA_SAMPLES)]
    own = [photoncube(program, scene, work / f"{name}.exr", passes) for passes in PASSES]
    net = lambda runs: [(time, max(rel_mse(picture, truth, kept) - noise, noise)) for time, picture in runs]
    return net(runs), net(own), noise


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, work = sys.argv[1], Path(sys.argv[2])
    mi.set_variant("llvm_ad_rgb")
    levels, curves = [], []
    for name, text in scenes():
        peer, own, noise = measure(program, work, name, text)
        for who, sizes, curve in (("Mitsuba, samples", MITSUBA_SAMPLES, peer), ("photoncube, passes", PASSES, own)):
            for size, (time, error) in zip(sizes, curve):
                curves.append(f"| {name} | {who} | {size} | {time:.2f} | {error:.2e} |")
        for level in LEVELS:
            (theirs, their_mark), (ours, our_mark) = time_or_guess(peer, level), time_or_guess(own, level)
            levels.append(
                f"| {name} | {level:.0e} | {their_mark}{theirs:.2f} | {our_mark}{ours:.2f} | {theirs / ours:.1f} | {noise:.1e} |"
            )
    print("| scene | to relMSE | Mitsuba, CPU s | photoncube, CPU s | ratio | noise of the truth |")
    print("| --- | --- | --- | --- | --- | --- |")
    print("\n".join(levels))
    print("\n| scene | program | size | CPU s | relMSE |")
    print("| --- | --- | --- | --- | --- |")
    print("\n".join(curves))


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    main()
