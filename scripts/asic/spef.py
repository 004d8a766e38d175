#!/usr/bin/env python3
"""Writes qrouter's resistances and capacitances of wires as SPEF, which OpenSTA reads.

    spef.py NAME.rc NAME.spef NETS

A line of NAME.rc is a net, its drivers, its number of readers and a tree: `( OHMS PICOFARADS WHAT , WHAT )`, where WHAT is a pin or
the next piece of wire, or ERROR at an end without a pin. Half of the capacitance of a piece is put at each of its ends. There must be NETS nets.
"""

import json
import pathlib
import sys

HEADER = """*SPEF "IEEE 1481-1998"
*DESIGN "{name}"
*DATE "none"
*VENDOR "Photoncube"
*PROGRAM "spef.py"
*VERSION "1"
*DESIGN_FLOW "NETLIST_TYPE_VERILOG"
*DIVIDER /
*DELIMITER :
*BUS_DELIMITER [ ]
*T_UNIT 1 NS
*C_UNIT 1 PF
*R_UNIT 1 OHM
*L_UNIT 1 HENRY
"""


def fail(message):
    sys.exit(f"spef.py: {message}")


def pin(text):
    """A pin of a cell, or a port, as SPEF names it."""
    cell, name = text.split("/")
    return name if cell == "PIN" else f"{cell}:{name}"


class Tree:
    """The pieces of wire of a net. Node 0 is its driver."""

    def __init__(self, path, line):
        words = line.split()
        self.net, drivers = words[0], int(words[1])
        self.driver, readers, tree = pin(words[2]), int(words[3]), words[4:]
        if drivers != 1:
            fail(f"{path}: net {self.net}: found {drivers} drivers, expected one")
        self.stumps = 0
        self.readers, self.resistances, self.capacitances = {}, [], [0.0]
        self.read(tree)
        if len(self.readers) != readers:
            fail(f"{path}: net {self.net}: found {len(self.readers)} readers in the tree, expected {readers}")

    def read(self, words):
        at, words = [0], iter(words)
        for word in words:
            if word == "(":
                ohms, picofarads = float(next(words)), float(next(words))
                node = len(self.capacitances)
                self.resistances.append((at[-1], node, ohms))
                self.capacitances[at[-1]] += picofarads / 2
                self.capacitances.append(picofarads / 2)
                at.append(node)
            elif word == ")":
                at.pop()
            elif word == "ERROR":
                # A piece of wire that ends nowhere.
                self.stumps += 1
            elif word != "," and pin(word) != self.driver:
                self.readers[pin(word)] = at[-1]

    def spef(self):
        node = lambda number: f"{self.net}:{number}" if number else self.driver
        yield f"*D_NET {self.net} {sum(self.capacitances):.6g}"
        yield "*CONN"
        for name, direction in ((self.driver, "O"), *((reader, "I") for reader in self.readers)):
            # The direction of a port is the other one, as seen from within.
            is_port = ":" not in name
            yield f"*{'P' if is_port else 'I'} {name} {direction if not is_port else 'IO'['IO'.index(direction) ^ 1]}"
        yield "*CAP"
        yield from (f"{number + 1} {node(number)} {value:.6g}" for number, value in enumerate(self.capacitances))
        yield "*RES"
        number = 0
        for number, (near, far, ohms) in enumerate(self.resistances, 1):
            yield f"{number} {node(near)} {node(far)} {max(ohms, 0.001):.6g}"
        for number, (reader, at) in enumerate(self.readers.items(), number + 1):
            yield f"{number} {node(at)} {reader} 0.001"
        yield "*END"


def main():
    rc, spef, nets = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), int(sys.argv[3])
    trees = [Tree(rc, line) for line in rc.read_text().splitlines() if line.strip()]
    if len(trees) != nets:
        fail(f"{rc}: found {len(trees)} nets, expected the netlist's {nets}")
    part = spef.with_name(spef.name + ".part")
    lines = [line for tree in trees for line in tree.spef()]
    part.write_text(HEADER.format(name=spef.stem) + "\n".join(lines) + "\n")
    part.rename(spef)
    print(json.dumps({"wire_capacitance_pf": sum(sum(tree.capacitances) for tree in trees),
                      "wire_stumps": sum(tree.stumps for tree in trees)}))


if __name__ == "__main__":
    main()
