#!/usr/bin/env python3
"""Writes the library's LEF file as qrouter 1.4.71 needs it: lef.py CELLS.lef OUT.lef.

- A wire has two edges, of which qrouter counts one: the capacitance of an edge is doubled.
- Where a wire ends at the arms of pin Q of DFFPOSX1, which lie between the tracks, qrouter leaves a via beside its wire in one of some
  thousand nets: the arms are no place for wires to end. The stem of the pin remains, which lies on a track.
"""

import pathlib
import re
import sys

CELL, PIN = "DFFPOSX1", "Q"
# The arms are wider than they are high; the stem is higher than it is wide.
ARMS = 4


def is_arm(rectangle):
    left, bottom, right, top = map(float, rectangle.split()[1:5])
    return right - left >= top - bottom


def without_arms(cell):
    """The cell with the arms of the pin among its obstructions."""
    pin = re.search(rf"  PIN {PIN}\n.*?  END {PIN}\n", cell, re.S)
    arms = [line for line in pin[0].splitlines() if " RECT " in line and is_arm(line)]
    head, obstructions, rest = cell[pin.end() :].partition("  OBS \n")
    layer = "      LAYER metal1 ;\n"
    if len(arms) != ARMS or layer not in rest:
        sys.exit(f"lef.py: {CELL}, pin {PIN}: found {len(arms)} arms, expected {ARMS}, and obstructions in metal 1")
    stem = "".join(line for line in pin[0].splitlines(keepends=True) if line.rstrip("\n") not in arms)
    return cell[: pin.start()] + stem + head + obstructions + rest.replace(layer, layer + "".join(f"{arm}\n" for arm in arms), 1)


def main():
    source, target = map(pathlib.Path, sys.argv[1:3])
    text, edges = re.subn(r"(EDGECAPACITANCE\s+)([\d.e+-]+)", lambda found: f"{found[1]}{2 * float(found[2]):e}", source.read_text())
    text, cells = re.subn(rf"^MACRO +{CELL}\n.*?^END {CELL}\n", lambda found: without_arms(found[0]), text, flags=re.M | re.S)
    if not edges or cells != 1:
        sys.exit(f"lef.py: {source}: found {edges} capacitances of edges and {cells} cells {CELL}, expected some and one")
    target.write_text(text)


if __name__ == "__main__":
    main()
