"""Plants a fault in the text of a core, to show that the tests find it: `python faults.py NAME FILE` changes the file,
`python faults.py --list` names the faults."""

from __future__ import annotations

import re
import sys
from pathlib import Path

# What is replaced and by what. Each change is of one character, and its place must be the only one.
FAULTS = {
    # The fifth photon of a last leaf is dropped where it is the leaf's last.
    "drop-photon": (r"\|leaf_present\[7:4\]", "|leaf_present[7:5]"),
    # Leaves go to other chains than tdest says.
    "swap-tdest": (r"leaf_chain = leaf_word", "leaf_chain = ~leaf_word"),
    # Results count down.
    "count-down": (r"counter_results \+ seen_result_moves", "counter_results - seen_result_moves"),
    # A slice loses the word in its second place where its first moves out.
    "lose-word": (r"second_full \| comes : 1'b1", "second_full & comes : 1'b1"),
    # Results of queries outside of their frame keep their sums.
    "keep-sums": (r"result_seen = result_outside \?", "result_seen = !result_outside ?"),
    # The bit that clears the counters restarts the core.
    "other-bit": (r"writes_control & write_word\[0\]", "writes_control & write_word[1]"),
}


def main() -> int:
    """Changes the file, or names the faults. Ends 2 where the fault is none of the table or has no place in it."""
    if sys.argv[1:] == ["--list"]:
        print(*FAULTS, sep="\n")
        return 0
    if len(sys.argv) != 3 or sys.argv[1] not in FAULTS:
        print(f"faults: expected {', '.join(FAULTS)}, then a file", file=sys.stderr)
        return 2
    pattern, replacement = FAULTS[sys.argv[1]]
    path = Path(sys.argv[2])
    text, places = re.subn(pattern, lambda _: replacement, path.read_text())
    if places != 1:
        print(f"faults: {sys.argv[1]} has {places} places in {path}, expected one", file=sys.stderr)
        return 2
    path.write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
