#!/usr/bin/env python3
"""Reads emitted Verilog with slang, a strict front end (PyPI's pyslang), as Verilog-2005 with all its warnings.

Usage: slang.py FILE...

A file *_ecp5.v is read with the file beside it, without the modules there that it replaces; the FPGA's cells are not
declared in either, so these alone may be unknown. A testbench *_tb.v is read with the file beside it. An error fails, and
so does a warning that EXPLAINED has no reason for. That an error and a warning are found is shown on planted text first.

Exit codes: 0 all files pass; 1 one does not; 2 bad usage or no pyslang.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

OPTIONS = ["--std", "1364-2005", "--single-unit", "-Wextra", "-Wpedantic", "-Wconversion", "--error-limit=0"]
CELLS_ARE_UNKNOWN = ["--ignore-unknown-modules"]

# The warning, the line that it is about, what must hold of the two, and why nothing is wrong with it.
EXPLAINED = [
    (
        r"implicit conversion truncates from \d+ to (?P<width>\d+) bits",
        r"= \(\(\w+\) & (?P<mask>\d+)'h[0-9a-f]+\);$",
        lambda found: found["width"] == found["mask"],
        "rust-hdl's narrowing cast: the mask has the width that is left, so no bit is lost that it keeps",
    ),
    (
        r"implicit conversion expands from [123] to 4 bits",
        r"wire \[3:0\] digit_\d = root\[\d+:\d+\];$",
        lambda found: True,
        "the highest digit of a root whose width is no multiple of four: zeros go before it",
    ),
    (
        r"implicit conversion truncates from (?P<all>\d+) to (?P<width>\d+) bits",
        r"always @\(\*\) square = \{digit_square\(digit_\d\), .*\}$",
        lambda found: 0 < int(found["all"]) - int(found["width"]) < 8,
        "the square of a short highest digit, whose high bits are 0 since the digit's are",
    ),
    (
        r"implicit conversion changes signedness",
        r"wire signed \[\d+:0\] d = difference;$",
        lambda found: True,
        "a difference in two's complement, which the module's ports hold as plain bits",
    ),
]

PLANTED = {
    "error: identifier 'b' used before its declaration": "module m(input a, output c);\n  assign c = b;\n  wire b = a;\nendmodule\n",
    "[-Wwidth-trunc]": "module m(input [1:0] a, output c);\n  assign c = a;\nendmodule\n",
}

FOUND = re.compile(r"^(?P<file>[^\s:]+):(?P<line>\d+):\d+: (?:fatal )?(?P<kind>error|warning): (?P<what>.*)$", re.MULTILINE)


def said_of(path, options):
    """What slang says of a file, all its lines."""
    run = [sys.executable, __file__, "--raw", *OPTIONS, *options, str(path)]
    done = subprocess.run(run, capture_output=True, text=True)
    return done.stdout + done.stderr


def raw(arguments):
    """Slang itself, in a process of its own, as it writes past Python's streams."""
    from pyslang import driver

    slang = driver.Driver()
    slang.addStandardArgs()
    ready = slang.parseCommandLine(" ".join(["slang", *arguments])) and slang.processOptions() and slang.parseAllSources()
    return 0 if ready and slang.runFullCompilation(False) else 1


def with_overrides(path):
    """The text of a machine with its overrides for the ECP5 in place of the modules that they replace."""
    overrides = path.read_text()
    text = path.with_name(path.name.replace("_ecp5.v", ".v")).read_text()
    for name in re.findall(r"^module (\w+)", overrides, re.MULTILINE):
        text, replaced = re.subn(rf"^module {name}\(.*?^endmodule$", "", text, flags=re.MULTILINE | re.DOTALL)
        if replaced != 1:
            raise SystemExit(f"slang: {path}: module {name} stands {replaced} times beside it, expected once")
    return text + overrides


def with_design(path):
    """The text of a machine and of its testbench."""
    return path.with_name(path.name.replace("_tb.v", ".v")).read_text() + path.read_text()


def reason(what, line):
    """Why a warning is none, if it is."""
    for warning, about, holds, why in EXPLAINED:
        of_warning, of_line = re.search(warning, what), re.search(about, line.strip())
        if of_warning and of_line and holds(of_warning.groupdict() | of_line.groupdict()):
            return why
    return None


def complaints(path, scratch):
    """What slang finds in a file that has no explanation, and the explanations that were used."""
    options, read = [], path
    if path.name.endswith("_ecp5.v"):
        options, read = CELLS_ARE_UNKNOWN, scratch / "design.v"
        read.write_text(with_overrides(path))
    if path.name.endswith("_tb.v"):
        read = scratch / "design.v"
        read.write_text(with_design(path))
    said = said_of(read, options)
    lines = read.read_text().splitlines()
    unexplained, used = [], set()
    for found in FOUND.finditer(said):
        line = lines[int(found["line"]) - 1]
        why = reason(found["what"], line) if found["kind"] == "warning" else None
        if why:
            used.add(why)
        else:
            unexplained.append(f"{path}:{found['line']}: {found['kind']}: {found['what']}\n    {line.strip()}")
    if "Build succeeded" not in said and not unexplained:
        unexplained.append(f"{path}: slang says: {said.strip() or 'nothing'}")
    return unexplained, used


def check_that_faults_are_found(scratch):
    for expected, text in PLANTED.items():
        path = scratch / "planted.v"
        path.write_text(text)
        if expected not in said_of(path, []):
            raise SystemExit(f"slang: planted text was not refused with `{expected}`, so the check says nothing")


def main(paths):
    if not paths or any(path.startswith("-") for path in paths):
        print(__doc__, file=sys.stderr)
        return 2
    try:
        import pyslang  # noqa: F401
    except ImportError:
        print("slang: this Python has no pyslang; scripts/setup.sh installs it", file=sys.stderr)
        return 2
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        check_that_faults_are_found(scratch)
        for path in map(Path, paths):
            unexplained, _ = complaints(path, scratch)
            failed += bool(unexplained)
            print("\n".join(unexplained), end="\n" if unexplained else "")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(raw(sys.argv[2:]) if sys.argv[1:2] == ["--raw"] else main(sys.argv[1:]))
