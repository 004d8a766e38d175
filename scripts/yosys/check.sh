#!/usr/bin/env bash
# Whether four readers of Verilog take what the generator emits, without a single complaint.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/yosys/check.sh [FILE...]

Checks emitted Verilog (default: hdl-out/*/*.v); the top module has the name of its file. Overrides of single
modules (*_ecp5.v) are no designs: slang reads them with the file beside them, scripts/yosys/ecp5.sh proves them. Testbenches
(*_tb.v) are read by slang and Icarus with the file beside them.
  yosys      no missing module, no latch, no loop, no driver conflict, no undriven net
  iverilog   Verilog-2001 with all warnings
  verilator  all warnings but WIDTH, UNUSEDSIGNAL, UNUSEDPARAM and DECLFILENAME
  slang      Verilog-2005 by the letter, with all warnings; what it says of a width is explained line by line
A warning is a failure.

Exit codes: 0 all pass; 1 a file fails; 2 bad usage, a missing file or a missing tool.
USAGE
}

# rust-hdl declares one module per block in one file and never trims an operand.
readonly WAIVED=(-Wno-WIDTH -Wno-UNUSEDSIGNAL -Wno-UNUSEDPARAM -Wno-DECLFILENAME)

by_yosys() {
    # -e makes every warning an error: undeclared names are only warned of.
    yosys -q -e . -p "read_verilog \"$1\"; hierarchy -check -top $2; proc;
        select -assert-none t:\$dlatch t:\$adlatch t:\$dlatchsr t:\$sr; flatten; check -assert"
}
by_iverilog() {
    local files=("$1")
    [[ $1 == *_tb.v ]] && files=("${1%_tb.v}.v" "$1")
    iverilog -g2001 -Wall -s "$2" -o /dev/null "${files[@]}"
}
by_slang() { "$python" "$slang" "$1"; }
by_verilator() { verilator --lint-only -Wall "${WAIVED[@]}" --top-module "$2" "$1"; }

# shellcheck source=scripts/yosys/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
read_options "$@"

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
slang=$here/slang.py
python=$("$here/../setup.sh" --where)/python || exit 2
files=("$@")
if (($# == 0)); then
    cd "$(dirname "${BASH_SOURCE[0]}")/../.."
    shopt -s nullglob
    files=(hdl-out/*/*.v)
    if ((${#files[@]} == 0)); then
        echo "check: found no hdl-out/*/*.v, expected one for each machine; write them with \`cargo run --release -- generate\`" >&2
        exit 2
    fi
fi
need yosys iverilog verilator

for file in "${files[@]}"; do
    if [[ ! -f $file || ! $file =~ ^[[:alnum:]_./-]+\.v$ ]]; then
        echo "check: found no file $file, expected Verilog: *.v with only letters, digits and _./- in its path" >&2
        exit 2
    fi
done

# What the four say of a file; fails if one complains.
check_file() {
    local file=$1 top said tool bad=() tools=(yosys iverilog verilator slang)
    top=$(basename "$file" .v)
    case $file in
        *_ecp5.v) tools=(slang) ;;
        *_tb.v) tools=(iverilog slang) ;;
    esac
    for tool in "${tools[@]}"; do
        # A tool that says anything has complained, whatever it returns.
        if ! said=$("by_$tool" "$file" "$top" 2>&1) || [[ -n $said ]]; then
            bad+=("$tool")
            head -n 40 <<<"${said:-(no message)}" | sed "s/^/    $tool: /"
        fi
    done
    if ((${#bad[@]} == 0)); then
        printf 'pass  %s (%s)\n' "$file" "${tools[*]}"
    else
        printf 'FAIL  %s (%s)\n' "$file" "${bad[*]}"
        return 1
    fi
}

# A file for each core at a time, each with what is said of it in a file.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cores=$(nproc)
pids=()
for i in "${!files[@]}"; do
    ((i < cores)) || wait "${pids[i - cores]}" || true
    check_file "${files[i]}" >"$scratch/$i" &
    pids+=($!)
done
failed=0
for i in "${!files[@]}"; do
    wait "${pids[i]}" || failed=$((failed + 1))
    cat "$scratch/$i"
done
if ((failed > 0)); then
    printf 'check: %d of %d files fail\n' "$failed" "${#files[@]}" >&2
    exit 1
fi
