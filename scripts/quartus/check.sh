#!/usr/bin/env bash
# Whether the Quartus projects name files, modules and ports that are there.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/quartus/check.sh [FOLDER...]

Reads the Quartus project (*.qpf, *.qsf, *.sdc) of each folder (default: hdl-out/*/) as Quartus's Tcl would, in
the Tcl of Yosys: every assignment must be known, every file be there, and the top module have every port that is
named. No more is shown by it: Quartus itself is not free. That a project can fail is shown on one whose clock
has another name.

Exit codes: 0 all pass; 1 one fails; 2 bad usage, a missing folder or a missing tool.
USAGE
}

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=scripts/yosys/common.sh
source "$here/../yosys/common.sh"
read_options "$@"
need yosys
folders=("$@")
if (($# == 0)); then
    cd "$here/../.."
    shopt -s nullglob
    folders=(hdl-out/*/)
fi

passes() {
    local projects=("$1"/*.qpf)
    ((${#projects[@]} == 1)) && [[ -f ${projects[0]} ]] || return 1
    (cd "$1" && PROJECT=$(basename "${projects[0]}" .qpf) yosys -Q -q -c "$here/check.tcl")
}

failed=0
for folder in "${folders[@]}"; do
    [[ -d $folder ]] || {
        echo "projects: found no folder $folder, expected one with a Quartus project" >&2
        exit 2
    }
    passes "$folder" || {
        echo "FAIL  $folder" >&2
        failed=$((failed + 1))
    }
done
((${#folders[@]} > 0)) || {
    echo "projects: found no hdl-out/*/; write them with \`cargo run --release -- generate\`" >&2
    exit 2
}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp "${folders[0]}"/* "$scratch"
sed -i 's/get_ports clock/get_ports clk/' "$scratch"/*.sdc
if passes "$scratch" >/dev/null 2>&1; then
    echo "projects: a clock on a port that is not there was not refused, so the check says nothing" >&2
    exit 1
fi
((failed == 0)) || exit 1
echo "projects: ${#folders[@]} pass, and one that names a wrong port is refused"
