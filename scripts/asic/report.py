#!/usr/bin/env python3
"""Judges a layout by the logs of its checks, and writes its figures to OUT/layout.json.

    report.py MACHINE NAME OUT TECH DENSITY SEED

Ends 1, and writes nothing, where a check found something, did not find what was planted, or saw nothing.
"""

import collections
import hashlib
import importlib.metadata
import json
import pathlib
import re
import subprocess
import sys

import klayout.db as db

FILL = "FILL"
PACKAGES = ("graywolf", "magic", "netgen-lvs", "opensta", "qflow", "qflow-tech-osu018", "qrouter")
PER_MICRON = 100


def fail(message):
    sys.exit(f"report.py: {message}")


def expect(holds, message):
    if not holds:
        fail(message)


def number(text, path, what):
    """The number after `what: ` in a log."""
    found = re.search(rf"^{re.escape(what)}: (-?[\d.]+)$", text, re.M)
    return float(found[1]) if found else fail(f"{path}: found no `{what}`, expected its number")


def sha256(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def design_rules(path):
    """The errors of the layout, those with the planted fault, and the pieces of metal that were made larger."""
    text = path.read_text()
    found, planted = (int(number(text, path, f"DRC errors{of}")) for of in ("", " with a planted sliver"))
    expect(number(text, path, "kinds of cells") > 1, f"{path}: found no cells, expected a layout with cells")
    expect(found == 0, f"{path}: found {found} errors against the design rules, expected none")
    expect(planted > 0, f"{path}: found no error with a planted sliver, expected one: the check is blind")
    patches = len(re.findall(r"^patch of metal", text, re.M))
    return {"drc_errors": found, "drc_errors_planted": planted, "metal_patches": patches}


class Comparison:
    """What netgen said of a layout and a netlist."""

    def __init__(self, folder, title):
        self.path = folder / f"{title}.out"
        self.text = self.path.read_text()
        cells = json.loads((folder / f"{title}.json").read_text())
        # Each cell of the library, and last the whole.
        self.kinds = {cell["name"][0]: cell for cell in cells}
        self.top = cells[-1]

    def faults(self):
        """What does not match; nothing where all does, down to the sizes of transistors and the names of pins."""
        found = [line for line in self.text.splitlines() if re.search(r"property errors|failed pin|do not match|not equivalent|Mismatch", line)]
        for cell in self.kinds.values():
            lists = ("badnets", "badelements", "properties")
            found += [f"{cell['name'][0]}: {key}" for key in lists if cell.get(key)]
            found += [f"{cell['name'][0]}: {key}" for key in ("nets", "devices", "pins") if key not in cell or not same(cell[key])]
        if self.text.rstrip().splitlines()[-1] != "Circuits match uniquely.":
            found.append("no match at the end")
        return found

    def cells(self):
        return {kind: count for kind, count in self.top["devices"][1]}

    def transistors(self):
        """The transistors of the whole, by those of its cells."""
        of = {kind: sum(count for _, count in cell["devices"][0]) for kind, cell in self.kinds.items()}
        return sum(count * of[kind] for kind, count in self.cells().items())


def same(pair):
    """Whether both circuits have the same; lists in any order."""
    left, right = (sorted(map(str, side)) if isinstance(side, list) else side for side in pair)
    return left == right


def comparisons(folder, netlist):
    whole = Comparison(folder, "lvs")
    faults = whole.faults()
    expect(not faults, f"{whole.path}: found {len(faults)} differences of layout and netlist, expected none; the first: {faults[:1]}")
    cells, nets = sum(whole.cells().values()), whole.top["nets"][0]
    # Besides the nets of the netlist there are two of power.
    expect(cells == netlist["cells"] > 0, f"{whole.path}: found {cells} cells, expected {netlist['cells']}")
    expect(nets == netlist["nets"] + 2, f"{whole.path}: found {nets} nets, expected {netlist['nets'] + 2}")
    for title in ("lvs-sliver", "lvs-exchanged"):
        planted = Comparison(folder, title)
        expect(planted.faults(), f"{planted.path}: found a match, expected that the planted fault is found: the check is blind")
    return whole, {"lvs": "match", "lvs_cells": cells, "lvs_nets": nets, "lvs_transistors": whole.transistors(),
                   "lvs_sliver_planted": "no match", "lvs_exchange_planted": "no match"}


def wires(path, text):
    """The length of all wires of signals, and the number of their vias."""
    section = re.search(r"^NETS \d+ ;(.*?)^END NETS", text, re.M | re.S)
    expect(section, f"{path}: found no nets")
    length = vias = 0
    for route in re.findall(r"(?:ROUTED|NEW) \S+ (.*)", section[1]):
        at = None
        for x, y, via in re.findall(r"\( (\S+) (\S+) \)|(\w+)", route):
            if via:
                vias += 1
                continue
            x, y = (float(to) if to != "*" else at[axis] for axis, to in enumerate((x, y)))
            length += abs(x - at[0]) + abs(y - at[1]) if at else 0
            at = (x, y)
    return {"wire_length_um": length / PER_MICRON, "vias": vias}


def sizes(path):
    """The width and the height of each cell of a LEF file."""
    return {kind: (float(width), float(height)) for kind, width, height in
            re.findall(r"^MACRO (\S+).*?^\s*SIZE\s+([\d.]+)\s+BY\s+([\d.]+)", path.read_text(), re.M | re.S)}


def placed(path, text, gds, netlist, lef):
    """The cells and the area; in the GDS must be what was placed."""
    cells = re.findall(r"^- \S+ (\S+) \+ PLACED \( (-?\d+) (-?\d+) \)", text, re.M)
    kinds = collections.Counter(kind for kind, _, _ in cells)
    layout = db.Layout()
    layout.read(str(gds))
    drawn = collections.Counter(layout.cell(instance.cell_index).name for instance in layout.top_cell().each_inst())
    expect(drawn == kinds, f"{gds}: found other cells than {path} has, expected the same")
    standard = kinds.total() - kinds[FILL]
    expect(standard == netlist["cells"] > 0, f"{path}: found {standard} cells, expected {netlist['cells']}")
    spans = [(int(x) / PER_MICRON, int(y) / PER_MICRON, *lef[kind]) for kind, x, y in cells]
    width = max(x + w for x, _, w, _ in spans) - min(x for x, _, _, _ in spans)
    height = max(y + h for _, y, _, h in spans) - min(y for _, y, _, _ in spans)
    area = sum(lef[kind][0] * lef[kind][1] * count for kind, count in kinds.items() if kind != FILL)
    die = layout.top_cell().dbbox()
    return {"die_width_um": round(die.width(), 3), "die_height_um": round(die.height(), 3), "die_area_um2": round(die.width() * die.height()),
            "core_area_um2": round(width * height), "cell_area_um2": round(area), "core_utilisation": area / (width * height),
            "standard_cells": standard, "fill_cells": kinds[FILL]}


def clocks(path, netlist, row):
    text = path.read_text()
    expect("\nError" not in f"\n{text}", f"{path}: found an error, expected none")
    of = lambda what: number(text, path, what)
    expect(of("registers") == netlist["registers"] > 0, f"{path}: found the clock of {of('registers')} registers, expected {netlist['registers']}")
    fmax_of_cells = 1e3 / of("period with cells alone, ns")
    expect(abs(fmax_of_cells - row["fmax_mhz"]) < 1e-3 * row["fmax_mhz"],
           f"{path}: found {fmax_of_cells} MHz without wires, expected the {row['fmax_mhz']} MHz of `synth --asic`")
    hold = re.search(r"^hold:.*?(-?[\d.]+)\s+slack \((MET|VIOLATED)\)", text, re.M | re.S)
    expect(hold and hold[2] == "MET", f"{path}: found a register that takes its input too early (hold), or no such check; expected a slack above 0")
    fmax = 1e3 / of("period with wires, ns")
    expect(fmax < fmax_of_cells, f"{path}: found {fmax} MHz with wires and {fmax_of_cells} without, expected less with wires")
    return {"fmax_mhz_without_wires": row["fmax_mhz"], "fmax_mhz": fmax, "clock_latency_ns": of("clock latency, ns"),
            "clock_skew_ns": round(of("last clock, ns") - of("first clock, ns"), 3), "hold_slack_ns": float(hold[1])}


def versions():
    def of(package):
        return subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], check=True, capture_output=True, text=True).stdout
    return {package: of(package) for package in PACKAGES} | {"klayout": importlib.metadata.version("klayout")}


def main():
    machine, name = sys.argv[1:3]
    out, tech = (pathlib.Path(argument) for argument in sys.argv[3:5])
    folder = out / "flow" / "layout"
    synth = json.loads((out / "synth.json").read_text())
    netlist = json.loads((out / "netlist.json").read_text())
    [row] = [row for row in synth["machines"] if row["machine"] == machine]
    expect(netlist["mapped_cells"] == row["standard_cells"], f"found {netlist['mapped_cells']} cells in the netlist, expected {row['standard_cells']}")
    rules = design_rules(folder / "drc.txt")
    whole, compared = comparisons(folder, netlist)
    definition = folder / f"{name}.def"
    text = definition.read_text()
    figures = {
        "machine": machine,
        "verilog_sha256": row["verilog_sha256"],
        "netlist_sha256": sha256(out / f"{machine}.v"),
        "library": synth["library"],
        "library_sha256": synth["library_sha256"],
        "density": float(sys.argv[5]),
        "placement_seed": int(sys.argv[6]),
        "tool_versions": versions() | synth["tool_versions"],
        **placed(definition, text, folder / f"{name}.gds", netlist, sizes(tech / "osu018_stdcells.lef")),
        "registers": netlist["registers"],
        "clock_buffers": netlist["clock_buffers"],
        "clock_tree_levels": netlist["clock_tree_levels"],
        "nets": netlist["nets"],
        "ports": netlist["ports"],
        **wires(definition, text),
        **json.loads((out / "wires.json").read_text()),
        **rules,
        **compared,
        **clocks(out / "timing.log", netlist, row),
    }
    for source, target in ((folder / "drc.txt", "drc.txt"), (whole.path, "lvs.txt")):
        (out / target).write_text(source.read_text())
    part = out / "layout.json.part"
    part.write_text(json.dumps(figures, indent=2) + "\n")
    part.rename(out / "layout.json")
    print(json.dumps(figures, indent=2))


if __name__ == "__main__":
    main()
