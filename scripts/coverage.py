"""Prints what `cargo llvm-cov --json` counted: each file's lines, and those that no test used, each with its reason.

Usage: coverage.py REPORT REASONS. REASONS has tables `[[reason]]` with `because` and `lines`, each `file: text of the
line`; a line without a reason, or a reason without a line, fails.
"""

import json
import sys
import tomllib
from pathlib import Path


def unused_lines(segments):
    """The lines of which a region was entered never. A segment: line, column, count, has_count, is_entry, is_gap."""
    lines = {}
    for (line, _, count, has_count, _, is_gap), following in zip(segments, segments[1:] + [None]):
        if not has_count or is_gap:
            continue
        last = following[0] if following else line
        for number in range(line, last + 1):
            lines[number] = max(lines.get(number, 0), count)
    return sorted(number for number, count in lines.items() if count == 0)


def statements(file, root):
    """Each unused line that says something: its place, and as the reasons name it."""
    path = Path(file["filename"])
    text = path.read_text().splitlines()
    name = path.relative_to(root)
    for number in unused_lines(file["segments"]):
        statement = text[number - 1].strip()
        if statement.strip("{}();, "):
            yield f"{name}:{number}", f"{name}: {statement}"


def print_table(files, root):
    print("| file | lines used | of | percent |\n| --- | --- | --- | --- |")
    used = total = 0
    for file in files:
        lines = file["summary"]["lines"]
        used += lines["covered"]
        total += lines["count"]
        name = Path(file["filename"]).relative_to(root)
        print(f"| {name} | {lines['covered']} | {lines['count']} | {lines['percent']:.1f} |")
    print(f"| all | {used} | {total} | {100 * used / total:.1f} |")


def main():
    report = json.loads(Path(sys.argv[1]).read_text())
    rows = tomllib.loads(Path(sys.argv[2]).read_text())["reason"]
    reasons = {line: row["because"] for row in rows for line in row["lines"]}
    root = Path.cwd()
    files = report["data"][0]["files"]
    if not files:
        sys.exit("coverage: nothing was counted")
    print_table(files, root)
    print("\nnot used:")
    unexplained = set()
    explained = set()
    for file in files:
        for place, line in statements(file, root):
            (explained if line in reasons else unexplained).add(line)
            print(f"{place}: {line.split(': ', 1)[1]}\n    {reasons.get(line, 'NO REASON')}")
    stale = reasons.keys() - explained
    for line in sorted(stale):
        print(f"a reason for what was used, or is not there: {line}", file=sys.stderr)
    if unexplained or stale:
        sys.exit(f"coverage: {len(unexplained)} lines without a reason, {len(stale)} reasons without a line")


if __name__ == "__main__":
    main()
