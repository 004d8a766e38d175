"""Prints what `cargo llvm-cov --json` counted: each file's lines, and the lines that no test used."""

import json
import sys
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


def main():
    report = json.loads(Path(sys.argv[1]).read_text())
    root = Path.cwd()
    files = report["data"][0]["files"]
    if not files:
        sys.exit("coverage: nothing was counted")
    print("| file | lines used | of | percent |\n| --- | --- | --- | --- |")
    used = total = 0
    for file in files:
        lines = file["summary"]["lines"]
        used += lines["covered"]
        total += lines["count"]
        name = Path(file["filename"]).relative_to(root)
        print(f"| {name} | {lines['covered']} | {lines['count']} | {lines['percent']:.1f} |")
    print(f"| all | {used} | {total} | {100 * used / total:.1f} |")
    print("\nnot used:")
    for file in files:
        path = Path(file["filename"])
        text = path.read_text().splitlines()
        for number in unused_lines(file["segments"]):
            statement = text[number - 1].strip()
            if statement.strip("{}();, ") == "":
                continue
            print(f"{path.relative_to(root)}:{number}: {statement}")


if __name__ == "__main__":
    main()
