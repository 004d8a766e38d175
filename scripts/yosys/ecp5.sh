#!/usr/bin/env bash
# Proves that the second texts for the ECP5 are the modules that they stand in for.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/yosys/ecp5.sh [FILE...]

FILE (default: hdl-out/*/*_ecp5.v) holds second texts of some modules of the Verilog beside it, made of
cells of the ECP5. For each module Yosys's SAT solver proves that both texts are the same function: of
carry chains, with Yosys's own model of the carry cell; of squarers in DSP blocks and block RAMs, with
the models in crates/fpga-flow/models/ecp5_blocks.v, from power-up and from any state. That the proofs can fail is
shown on a chain and a comparison with one wrong LUT each, a table with one wrong word and a product with
one wrong operand.

Exit codes: 0 all are proven; 1 one is not; 2 bad usage, a missing file or a missing tool.
USAGE
}

# shellcheck source=scripts/yosys/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
read_options "$@"

files=("$@")
if (($# == 0)); then
    cd "$(dirname "${BASH_SOURCE[0]}")/../.."
    shopt -s nullglob
    files=(hdl-out/*/*_ecp5.v)
fi
need "$prover"
if ((${#files[@]} == 0)); then
    echo "ecp5: found no hdl-out/*/*_ecp5.v; write them with \`cargo run --release -- generate\`" >&2
    exit 2
fi

blocks=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../crates/fpga-flow/models" && pwd)/ecp5_blocks.v

# Module $2 of the text $1.
module_of() { sed -n "/^module $2(/,/^endmodule/p" "$1"; }

# Module $2 of the text $1 and those that it holds, with names that start with $3.
with_parts() {
    local text
    text=$(module_of "$1" "$2")
    echo "$text"
    sed -n "s/^    \($3[A-Za-z0-9_]*\) [A-Za-z0-9_]*(\$/\1/p" <<<"$text" | sort -u | while read -r part; do
        with_parts "$1" "$part" "$3"
    done
}

# Clocks after which nothing is left in a squarer of what was in it before: more than it has registers
# in a row.
clocks=5

# Whether the modules `dut` of the texts $1 and $2 in the scratch folder are one function. What has no clock is compared once,
# other modules in the first clocks from power-up, and in the last of them from any state.
is_proven() {
    local prove="sat -verify -prove trigger 0 miter"
    grep -q "input wire clock;" "$scratch/$1" && prove="sat -verify -seq $clocks -prove trigger 0 miter;
        setattr -unset init miter/w:*;
        sat -verify -seq $clocks -prove-skip $((clocks - 1)) -prove trigger 0 miter"
    yosys_in "$scratch" "read_verilog $1; hierarchy -top dut; proc; flatten; memory -nomap; memory_map; opt_clean;
        rename -top gold; design -stash gold;
        read_verilog -D NO_INCLUDES +/ecp5/cells_sim.v; read_verilog -overwrite blocks.v; read_verilog $2;
        hierarchy -top dut; proc; flatten; select -assert-none t:not_modelled; opt; memory -nomap; memory_map; opt_clean;
        rename -top gate; design -stash gate;
        design -copy-from gold -as gold gold; design -copy-from gate -as gate gate;
        miter -equiv -flatten gold gate miter; hierarchy -top miter; opt; $prove" >/dev/null 2>&1
}

# What makes a second text wrong: a bit of a LUT, of a table's word, of an operand.
wrong() {
    case $1 in
        *DP16KD*) echo "s/\\(INITVAL_05(320'h[0-9a-f]*\\)[0-9a-f])/\\1f)/" ;;
        *MULT18X18D*) echo 's/\.B17(operand\[9\])/.B17(operand[8])/' ;;
        *LUT4*) echo "0,/INIT(16'h\([0-9a-f]*\)[0-9a-f])/s//INIT(16'h\15)/" ;;
        *) echo "0,/INIT1(16'h\([0-9a-f]*\)[0-9a-f])/s//INIT1(16'h\15)/" ;;
    esac
}

scratch=$(mktemp -d)
cp "$blocks" "$scratch/blocks.v"
trap 'rm -rf "$scratch"' EXIT

declare -A seen refuted
failed=0 proven=0
for file in "${files[@]}"; do
    base=${file%_ecp5.v}.v
    [[ $file == *_ecp5.v && -f $file && -f $base ]] || {
        echo "ecp5: found no $file beside $base, expected both" >&2
        exit 2
    }
    # The modules of a core's chains have the name of its machine.
    count=0 prefix=$(basename "$base" .v | sed 's/^photoncube_core_[0-9]*_/photoncube_/')_
    for module in $(sed -n 's/^module \([A-Za-z0-9_]*\).*/\1/p' "$file"); do
        count=$((count + 1))
        name="s/^module $module(/module dut(/; s/\b$prefix/part_/g"
        with_parts "$base" "$module" "$prefix" | sed "$name" >"$scratch/gold.v"
        module_of "$file" "$module" | sed "$name" >"$scratch/gate.v"
        # Machines of one format have the same modules.
        texts=$(cat "$scratch/gold.v" "$scratch/gate.v" | sha256sum)
        [[ ${seen[$texts]-} ]] && continue
        if ! is_proven gold.v gate.v; then
            echo "FAIL  $file: $module is not proven to be that of $base" >&2
            failed=$((failed + 1))
            continue
        fi
        seen[$texts]=1 proven=$((proven + 1))
        edit=$(wrong "$(cat "$scratch/gate.v")")
        [[ ${refuted[$edit]-} ]] && continue
        sed "$edit" "$scratch/gate.v" >"$scratch/wrong.v"
        if cmp -s "$scratch/gate.v" "$scratch/wrong.v" || is_proven gold.v wrong.v; then
            echo "ecp5: a wrong $module was not refuted, so the proofs say nothing" >&2
            exit 1
        fi
        refuted[$edit]=1
    done
    echo "read  $file ($count modules)"
done
((failed == 0)) || exit 1
echo "ecp5: $proven different modules proven, and ${#refuted[@]} wrong ones refuted"
