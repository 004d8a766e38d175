#!/usr/bin/env bash
# Whether Yosys runs every script that the generator writes.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/yosys/scripts.sh [--full] [FILE...]

Runs Yosys scripts (default: hdl-out/*/*.ys) with each Yosys that there is: the one on the PATH, and that of
`scripts/setup.sh --where`, which `photoncube synth` measures with. Each script runs as it is, but its step
`synth_ecp5` ends when it has read the cells and found every module: what follows is Yosys's own work, and
takes minutes for the larger machines. That a script can fail is shown on one whose design lacks a module.

  --full   map to the end

Exit codes: 0 all scripts run; 1 one fails; 2 bad usage, a missing file or a missing tool.
USAGE
}

# shellcheck source=scripts/yosys/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
last=' -run begin:coarse'
if [[ ${1-} == --full ]]; then
    last=
    shift
fi
read_options "$@"
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
files=("$@")
if (($# == 0)); then
    cd "$root"
    shopt -s nullglob
    files=(hdl-out/*/*.ys)
    if ((${#files[@]} == 0)); then
        echo "scripts: found no hdl-out/*/*.ys; write them with \`cargo run --release -- generate\`" >&2
        exit 2
    fi
fi
need yosys
where=$("$root/scripts/setup.sh" --where) || exit 2
programs=("$(command -v yosys)" "$where/yosys")
declare -A versions
for program in "${programs[@]}"; do
    read -r _ "versions[$program]" _ < <("$program" -V)
done

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Runs the script $2 with Yosys $1 in a copy of its folder, where it leaves its netlist.
runs() {
    local folder
    folder=$(mktemp -d "$scratch/XXXXXX")
    cp "$(dirname "$2")"/*.v "$folder"
    sed "s/^synth_ecp5 /synth_ecp5$last /" "$2" >"$folder/script.ys"
    (cd "$folder" && "$1" -q script.ys)
}

failed=0 ran=0
for file in "${files[@]}"; do
    [[ -f $file && $file == *.ys ]] || {
        echo "scripts: found no file $file, expected a Yosys script: *.ys" >&2
        exit 2
    }
    grep -q '^synth_ecp5 ' "$file" || {
        echo "scripts: $file has no line that begins with synth_ecp5" >&2
        exit 1
    }
    for program in "${programs[@]}"; do
        ran=$((ran + 1))
        if said=$(runs "$program" "$file" 2>&1); then
            echo "pass  $file (Yosys ${versions[$program]})"
        else
            failed=$((failed + 1))
            echo "FAIL  $file (Yosys ${versions[$program]})"
            tail -n 5 <<<"$said" | sed 's/^/    /'
        fi
    done
done

mkdir "$scratch/planted"
# A module that is instantiated and not there.
printf 'module top(input wire a, output wire b);\n    missing part(.a(a), .b(b));\nendmodule\n' >"$scratch/planted/top.v"
printf 'read_verilog top.v\nsynth_ecp5 -top top\n' >"$scratch/planted/top.ys"
for program in "${programs[@]}"; do
    if runs "$program" "$scratch/planted/top.ys" >/dev/null 2>&1; then
        echo "scripts: $program ran a script whose design lacks a module, so the check says nothing" >&2
        exit 1
    fi
done
((failed == 0)) || exit 1
echo "scripts: $ran runs of ${#files[@]} scripts, and a design that lacks a module refused"
