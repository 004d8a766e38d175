#!/usr/bin/env python3
"""Finds wires that qrouter leaves beside their via: loose.py NAME.def. Prints each and ends 1 where there is one.

Where a pin is off the tracks, qrouter 1.4.71 moves the first piece of its wire, and sometimes also the via at the other end of the
piece, but not the wire from there on. Both are then as far from each other as the pin is from the track. The checks of the layout
find that too, but later.
"""

import pathlib
import re
import sys

# A via further than this from its wire does not touch it: half the width of a via. In hundredths of a micrometre, as in the file.
HALF_VIA = 20
# Pins are at most half a track from one.
HALF_TRACK = 50


def corners(path):
    """The corners of a wire."""
    at = []
    for pair in re.findall(r"\( (\S+) (\S+) \)", path):
        at.append(tuple(float(to) if to != "*" else at[-1][axis] for axis, to in enumerate(pair)))
    return at


def loose(net):
    """The pieces of a net whose via is beside the wire that goes on there."""
    pieces = [(piece, corners(piece)) for piece in re.findall(r"(?:ROUTED|NEW) (.*)", net)]
    for i, (piece, at) in enumerate(pieces):
        others = [corner for j, (_, wire) in enumerate(pieces) if j != i for corner in wire]
        if len(at) > 1 and re.search(r" \w+ *;?$", piece.rstrip()) and at[-1] not in others:
            x, y = at[-1]
            gaps = [abs(to[0] - x) + abs(to[1] - y) for to in others if to[0] == x or to[1] == y]
            if gaps and HALF_VIA < min(gaps) <= HALF_TRACK:
                yield piece


def main():
    path = pathlib.Path(sys.argv[1])
    section = re.search(r"^NETS \d+ ;\n(.*?)^END NETS", path.read_text(), re.M | re.S)
    if not section:
        sys.exit(f"loose.py: {path}: found no nets, expected a routed design")
    found = [(net.split()[1], piece) for net in re.split(r"^(?=- )", section[1], flags=re.M) if net for piece in loose(net)]
    for net, piece in found:
        print(f"{path}: net {net}: found a via beside its wire: {piece}")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
