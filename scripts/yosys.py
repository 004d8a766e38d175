#!/usr/bin/env python3
"""The command line of Yosys for PyPI's pyosys, which is Yosys as a Python library. scripts/setup.sh installs this file
as `yosys` beside the library. A command that fails ends the program with code 1 and a message on standard error."""

import argparse
import os
import subprocess

from pyosys import libyosys


def arguments():
    parser = argparse.ArgumentParser(prog="yosys", description="Yosys, by PyPI's pyosys.", allow_abbrev=False)
    parser.add_argument("-V", action="store_true", help="print the version")
    parser.add_argument("-q", action="store_true", help="print warnings and errors alone")
    parser.add_argument("-p", metavar="COMMANDS", help="run these commands; after the script, where there is one")
    parser.add_argument("-s", metavar="SCRIPT", help="run this script")
    parser.add_argument("script", nargs="?", metavar="SCRIPT", help="as -s")
    chosen = parser.parse_args()
    if chosen.s and chosen.script:
        parser.error("expected one script")
    return chosen


def main():
    chosen = arguments()
    if chosen.V:
        print(libyosys.yosys_maybe_version())
        return
    if chosen.q:
        # The library writes its log, with the warnings, to the standard output of the process, and errors to standard error. An
        # error ends the process at once, so another one has to filter the log.
        warnings = subprocess.Popen(["grep", "Warning: "], stdin=subprocess.PIPE, stdout=2)
        os.dup2(warnings.stdin.fileno(), 1)
        warnings.stdin.close()
    design = libyosys.Design()
    script = chosen.s or chosen.script
    if script:
        libyosys.run_pass(f"script {script}", design)
    if chosen.p:
        libyosys.run_pass(chosen.p, design)


if __name__ == "__main__":
    main()
