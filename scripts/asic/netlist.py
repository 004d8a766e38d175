#!/usr/bin/env python3
"""Prepares a mapped netlist for placement: gives its registers a clock tree, and writes it in the languages of the flow.

    netlist.py MAPPED.v CELLS.sp NAME FOLDER [--no-clock-tree | --near PLACED.def]

FOLDER/NAME.blif is for placement, NAME.spice for the comparison with the layout, and NAME.v for the delays. All have the same
cells, named CELL_1, CELL_2 and so on as qflow names them. A port `a[3]` is `a_3` in all of them, since brackets mean other things
to other programs. NAME_exchanged.spice has a fault, two outputs exchanged, which the comparison must find. Standard output has
what was found, as JSON.
"""

import argparse
import collections
import json
import pathlib
import re
import sys

CLOCK = "clock"
REGISTER, CLOCK_PIN = "DFFPOSX1", "CLK"
BUFFER, BUFFER_IN, BUFFER_OUT = "CLKBUF1", "A", "Y"
# The most registers, or buffers, that a buffer of the clock drives.
MOST_REGISTERS, MOST_BUFFERS = 16, 8
POWER = ("vdd", "gnd")
NAME = r"(?:\\\S+\s|[A-Za-z_][\w$]*\s*)"


def fail(message):
    sys.exit(f"netlist.py: {message}")


class Netlist:
    """Cells, each a pair of its kind and its nets by pin, and the directions of the ports."""

    def __init__(self, path):
        text = re.sub(r"/\*.*?\*/", "", path.read_text(), flags=re.S)
        module = re.fullmatch(r"\s*module\s+(\S+)\s*\(.*?\)\s*;(.*)endmodule\s*", text, re.S)
        if not module:
            fail(f"{path}: found no module, or several; expected the one that `photoncube synth --asic --netlists` writes")
        self.top, body = module.groups()
        self.ports, self.cells, self.names = {}, [], {}
        for statement in body.split(";"):
            if statement.strip():
                self.read(path, statement.strip() + " ")

    def read(self, path, statement):
        if declared := re.fullmatch(rf"(input|output|wire)\s+({NAME})\s*", statement):
            if declared[1] != "wire":
                self.ports[self.name(declared[2])] = declared[1]
            return
        cell = re.fullmatch(rf"(\w+)\s+{NAME}\s*\((.*)\)\s*", statement, re.S)
        pins = re.findall(rf"\.(\w+)\(({NAME})\)", cell[2]) if cell else []
        if not cell or len(pins) != cell[2].count("."):
            fail(f"{path}: found `{statement.strip()}`, expected ports, wires, and cells with a net on each pin")
        self.cells.append((cell[1], {pin: self.name(net) for pin, net in pins}))

    def name(self, net):
        """The name of a net without brackets; two nets do not get one name."""
        net = net.strip().removeprefix("\\")
        plain = re.sub(r"\[(\d+)\]", r"_\1", net)
        if self.names.setdefault(plain, net) != net or plain in POWER:
            fail(f"found nets `{self.names[plain]}` and `{net}`, which would both be `{plain}`")
        return plain


def groups(items, most, place):
    """Divides the items into groups of nearly equal size, of near ones where their places are known."""
    count = -(-len(items) // most)
    if count <= 1:
        return [items]
    if place:
        spans = [max(place[i][axis] for i in items) - min(place[i][axis] for i in items) for axis in (0, 1)]
        axis = spans.index(max(spans))
        items = sorted(items, key=lambda item: place[item][axis])
    cut = len(items) * (count // 2) // count
    return groups(items[:cut], most, place) + groups(items[cut:], most, place)


def add_clock_tree(netlist, place):
    """Drives the registers by a tree of buffers, in which all are equally deep. Returns the number of buffers of each level."""
    pins = {i: pins for i, (kind, pins) in enumerate(netlist.cells) if kind == REGISTER}
    if not pins:
        fail(f"found no {REGISTER}, expected registers")
    others = [kind for kind, pins in netlist.cells if CLOCK in pins.values() and kind != REGISTER]
    if others or any(on[CLOCK_PIN] != CLOCK for on in pins.values()):
        fail(f"found a {REGISTER} with another clock, or the clock on {others}; expected all registers, and no other cell, on `{CLOCK}`")
    drivers, levels, pin, most = list(pins), [], CLOCK_PIN, MOST_REGISTERS
    while True:
        parts = groups(drivers, most, place)
        drivers = []
        for part in parts:
            net = f"{CLOCK}_{len(levels)}_{len(drivers)}"
            if net in netlist.names:
                fail(f"found a net `{net}`, which is to be the clock tree's")
            for reader in part:
                netlist.cells[reader][1][pin] = net
            drivers.append(len(netlist.cells))
            netlist.cells.append((BUFFER, {BUFFER_IN: CLOCK, BUFFER_OUT: net}))
            if place:
                place[drivers[-1]] = [sum(place[i][axis] for i in part) / len(part) for axis in (0, 1)]
        levels.append(len(parts))
        pin, most = BUFFER_IN, MOST_BUFFERS
        if len(parts) == 1:
            return levels


def places(path, instances):
    """The places of the cells in a DEF file of the same netlist without its clock tree."""
    found = dict((name, (int(x), int(y))) for name, x, y in re.findall(r"^- (\S+) \S+ \+ PLACED \( (-?\d+) (-?\d+) \)", path.read_text(), re.M))
    missing = [name for name in instances if name not in found]
    if missing:
        fail(f"{path}: found no place of {missing[0]}, expected the places of all cells")
    return {i: found[name] for i, name in enumerate(instances)}


def instances(netlist):
    """The name of each cell."""
    count = collections.Counter()
    names = []
    for kind, _ in netlist.cells:
        count[kind] += 1
        names.append(f"{kind}_{count[kind]}")
    return names


def pins_in_order(path):
    """The pins of each cell of the library, in the order of its subcircuit."""
    return {line.split()[1]: line.split()[2:] for line in path.read_text().splitlines() if line.lower().startswith(".subckt")}


def write(path, lines):
    part = path.with_name(path.name + ".part")
    part.write_text("\n".join(lines) + "\n")
    part.rename(path)


def blif(netlist, name):
    yield f".model {name}"
    for word, direction in ((".inputs", "input"), (".outputs", "output")):
        yield " ".join([word, *(port for port, of in netlist.ports.items() if of == direction)])
    for kind, pins in netlist.cells:
        yield " ".join([".gate", kind, *(f"{pin}={net}" for pin, net in pins.items())])
    yield ".end"


def spice(netlist, name, cells):
    order = pins_in_order(cells)
    yield cells.read_text()
    yield " ".join([".subckt", name, *netlist.ports, *POWER])
    for (kind, pins), instance in zip(netlist.cells, instances(netlist)):
        if set(order.get(kind, ())) != {*pins, *POWER}:
            fail(f"{cells}: found {kind} with the pins {order.get(kind)}, expected {sorted(pins)} and {POWER}")
        yield " ".join([f"X{instance}", *(pins.get(pin, pin) for pin in order[kind]), kind])
    yield f".ends {name}"


def exchange(netlist):
    """Exchanges the outputs of the first two cells of different kinds that have an output Y."""
    first = next(cell for cell in netlist.cells if "Y" in cell[1])
    second = next(cell for cell in netlist.cells if "Y" in cell[1] and cell[0] != first[0])
    first[1]["Y"], second[1]["Y"] = second[1]["Y"], first[1]["Y"]


def verilog(netlist, name):
    yield f"module {name}({', '.join(netlist.ports)});"
    yield from (f"  {direction} {port};" for port, direction in netlist.ports.items())
    for (kind, pins), instance in zip(netlist.cells, instances(netlist)):
        yield f"  {kind} {instance} ({', '.join(f'.{pin}({net})' for pin, net in pins.items())});"
    yield "endmodule"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mapped", type=pathlib.Path)
    parser.add_argument("cells", type=pathlib.Path)
    parser.add_argument("name")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--no-clock-tree", action="store_true", help="leave the clock as it is")
    parser.add_argument("--near", type=pathlib.Path, help="a placement without the clock tree, whose near registers share a buffer")
    args = parser.parse_args()
    netlist = Netlist(args.mapped)
    mapped, place = len(netlist.cells), None
    if args.near:
        place = places(args.near, instances(netlist))
    levels = [] if args.no_clock_tree else add_clock_tree(netlist, place)
    write(args.folder / f"{args.name}.blif", blif(netlist, args.name))
    write(args.folder / f"{args.name}.spice", spice(netlist, args.name, args.cells))
    write(args.folder / f"{args.name}.v", verilog(netlist, args.name))
    registers = sum(kind == REGISTER for kind, _ in netlist.cells)
    nets = {net for _, pins in netlist.cells for net in pins.values()} | set(netlist.ports)
    exchange(netlist)
    write(args.folder / f"{args.name}_exchanged.spice", spice(netlist, args.name, args.cells))
    print(json.dumps({"mapped_cells": mapped, "cells": len(netlist.cells), "nets": len(nets), "ports": len(netlist.ports),
                      "registers": registers, "clock_buffers": sum(levels), "clock_tree_levels": len(levels)}))


if __name__ == "__main__":
    main()
