#!/usr/bin/env bash
# Whether the Quartus projects and the components for Platform Designer name files, modules and ports that are there.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/quartus/check.sh [FOLDER...]

Reads the Quartus project (*.qpf, *.qsf, *.sdc) of each folder (default: hdl-out/*/) as Quartus's Tcl would, in
the Tcl of Yosys: every assignment must be known, every file be there, and the top module have every port that is
named. Where the folder has a component of Platform Designer (*_hw.tcl), every interface of it must have the roles and
properties that its type needs, and every port of the top module be in one, with its direction and width. No more is shown
by it: Quartus and Platform Designer are not free and were not run. That a project can fail is shown on one whose clock
has another name, and that a component can fail on one mistake after the other.

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
    (cd "$1" && PROJECT=$(basename "${projects[0]}" .qpf) yosys -Q -q -c "$here/check.tcl") || return 1
    component_passes "$1"
}

# A folder without a component passes.
component_passes() {
    local components=("$1"/*_hw.tcl)
    [[ -f ${components[0]-} ]] || return 0
    (cd "$1" && TOP=$(basename "${components[0]}" _hw.tcl) yosys -Q -q -c "$here/component.tcl")
}

# Mistakes in a component: what the check must say of one, and the sed command that makes it. The last three are found by
# Yosys, which compares the ports with the module's.
mistakes() {
    cat <<'MISTAKES'
no role wvalid|/ wvalid /d
unknown role tlost|s/ tlast / tlost /
expected Output|/ tid /s/Output/Input/
found 31 bits|/ rdata /s/32$/31/
no associatedClock|0,/associatedClock aclk/{/associatedClock aclk/d}
expected an interface of type clock|s/associatedClock aclk/associatedClock aresetn/
found no file|s/PATH photoncube/PATH other/
Assertion failed|/ tdata /s/512$/256/
Assertion failed|/ irq irq irq /s/irq irq irq/irq interrupt irq/
Assertion failed|/ tdest /d
MISTAKES
}

failed=0 components=0
for folder in "${folders[@]}"; do
    [[ -d $folder ]] || {
        echo "projects: found no folder $folder, expected one with a Quartus project" >&2
        exit 2
    }
    passes "$folder" || {
        echo "FAIL  $folder" >&2
        failed=$((failed + 1))
    }
    for file in "$folder"/*_hw.tcl; do
        [[ -f $file ]] && component=$folder components=$((components + 1))
    done
done
((${#folders[@]} > 0)) || {
    echo "projects: found no hdl-out/*/; write them with \`cargo run --release -- generate\`" >&2
    exit 2
}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp "${folders[0]}"/* "$scratch"
sed -i 's/get_ports [a-z]*/get_ports clk/' "$scratch"/*.sdc
if passes "$scratch" >/dev/null 2>&1; then
    echo "projects: a clock on a port that is not there was not refused, so the check says nothing" >&2
    exit 1
fi

# One mistake after the other in a component, each of which must be found.
found=0
if ((components > 0)); then
    rm "$scratch"/*
    cp "$component"/*.v "$scratch"
    while IFS='|' read -r expected edit; do
        for file in "$component"/*_hw.tcl; do sed "$edit" "$file" >"$scratch/$(basename "$file")"; done
        if said=$(component_passes "$scratch" 2>&1) || [[ $said != *"$expected"* ]]; then
            echo "projects: the mistake \`$edit\` in a component was not refused with \`$expected\`, but: $said" >&2
            exit 1
        fi
        found=$((found + 1))
    done < <(mistakes)
fi
((failed == 0)) || exit 1
echo "projects: ${#folders[@]} pass, and one that names a wrong port is refused"
echo "components: $components pass, and $found mistakes in one are refused"
