#!/usr/bin/env python3
"""Path-traces a scene in the reference renderer's words by Mitsuba itself (pip install mitsuba==3.9.1).

Usage: mitsuba_scene.py SCENE.json PICTURE.exr [SIDE [SAMPLES]]

Quads, boxes of six quads, and spheres; diffuse, dielectric and conductor, as in docs/scenes/spheres.json and in
crates/render/scenes.
"""

import json
import sys

import mitsuba as mi


def matrix(columns):
    """A transform of the images of x, y, z and the origin."""
    rows = [[c[axis] for c in columns] for axis in range(3)]
    return mi.ScalarTransform4f([row[:] for row in rows] + [[0, 0, 0, 1]])


def quad(corners):
    """Mitsuba's rectangle is [-1, 1]^2, facing +z."""
    a, b, _, d = corners
    u = [(b[i] - a[i]) / 2 for i in range(3)]
    v = [(d[i] - a[i]) / 2 for i in range(3)]
    n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    middle = [a[i] + u[i] + v[i] for i in range(3)]
    return {"type": "rectangle", "to_world": matrix([u, v, n, middle])}


def rgb(value):
    return {"type": "rgb", "value": value["value"]}


def bsdf(text):
    if text["type"] == "diffuse":
        return {"type": "diffuse", "reflectance": rgb(text["reflectance"])}
    if text["type"] == "dielectric":
        return {"type": "dielectric", "int_ior": text["int_ior"], "ext_ior": text["ext_ior"]}
    return {"type": "conductor", "material": "none", "specular_reflectance": rgb(text["specular_reflectance"])}


def forms(text):
    if text["kind"] == "sphere":
        return [{"type": "sphere", "center": text["center"], "radius": text["radius"]}]
    corners = text["vertices"]
    faces = text.get("quads_ccw_outward", [[0, 1, 2, 3]])
    return [quad([corners[index] for index in face]) for face in faces]


def shapes(name, text):
    """The shapes of one entry of a scene file: one, or one for each face."""
    for index, found in enumerate(forms(text)):
        found["bsdf"] = bsdf(text["bsdf"])
        if "emitter" in text:
            found["emitter"] = {"type": "area", "radiance": rgb(text["emitter"]["radiance"])}
        yield f"{name.replace('-', '_')}_{index}", found


def load(text, side, samples):
    """The scene, for Mitsuba's variant that is set."""
    camera = text["camera"]
    scene = {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": -1, "rr_depth": 8},
        "sensor": {
            "type": "perspective",
            "fov": camera["fov_deg"],
            "fov_axis": camera["fov_axis"],
            "to_world": mi.ScalarTransform4f(camera["to_world"]),
            "film": {"type": "hdrfilm", "width": side, "height": side, "rfilter": {"type": "box"}, "pixel_format": "rgb", "component_format": "float32"},
            "sampler": {"type": "independent", "sample_count": samples},
        },
    }
    for name, value in text["shapes"].items():
        scene.update(shapes(name, value))
    return mi.load_dict(scene)


def main():
    source, target = sys.argv[1:3]
    side = int(sys.argv[3]) if len(sys.argv) > 3 else 128
    samples = int(sys.argv[4]) if len(sys.argv) > 4 else 4096
    mi.set_variant("scalar_rgb")
    with open(source, encoding="utf-8") as file:
        text = json.load(file)
    mi.Bitmap(mi.render(load(text, side, samples))).write(target)


if __name__ == "__main__":
    main()
