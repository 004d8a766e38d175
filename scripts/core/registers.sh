#!/usr/bin/env bash
# Turns the SystemRDL of a core into a C header, HTML, Markdown and a Python model, by PeakRDL.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

usage() {
    cat <<USAGE
Usage: scripts/core/registers.sh FILE.rdl DIR

Writes into DIR, from the SystemRDL that \`photoncube generate --chains\` wrote: registers.h, registers.md, html/ and
python/. The programs are those of scripts/setup.sh.

Exit codes: 0 all is written; 1 a program is missing or refuses the file; 2 bad usage.
USAGE
}

if [[ ${1:-} == -h || ${1:-} == --help ]]; then
    usage
    exit 0
fi
if (($# != 2)); then
    usage >&2
    exit 2
fi
if [[ ! -f $1 ]]; then
    printf 'registers: found no file %s\n' "$1" >&2
    exit 2
fi
rdl=$1 out=$2
peakrdl=$("$root/scripts/setup.sh" --where-core)/peakrdl
mkdir -p "$out"
# The offsets of all registers, as the compiler lays the structure out, are held by a second file.
"$peakrdl" c-header "$rdl" -o "$out/registers.h" --testcase
"$peakrdl" markdown "$rdl" -o "$out/registers.md"
"$peakrdl" html "$rdl" -o "$out/html"
"$peakrdl" python "$rdl" -o "$out/python"
