#!/usr/bin/env bash
# Proves that the carry chains for the ECP5 are the modules that they stand in for.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/yosys/ecp5.sh [FILE...]

FILE (default: hdl-out/*/*_ecp5.v) holds second texts of some modules of the Verilog beside it, made of
ECP5 carry cells. For each module Yosys's SAT solver proves that both texts are the same function, with
Yosys's own model of the cell. That the proof can fail is shown on a chain with one wrong LUT.

Exit codes: 0 all are proven; 1 one is not; 2 bad usage, a missing file or a missing tool.
USAGE
}

case ${1-} in
    -h | --help)
        usage
        exit 0
        ;;
    -*)
        usage >&2
        exit 2
        ;;
esac

files=("$@")
if (($# == 0)); then
    cd "$(dirname "${BASH_SOURCE[0]}")/../.."
    shopt -s nullglob
    files=(hdl-out/*/*_ecp5.v)
fi
command -v yosys >/dev/null || {
    echo "ecp5: no yosys on the PATH; scripts/setup.sh installs it" >&2
    exit 2
}
if ((${#files[@]} == 0)); then
    echo "ecp5: found no hdl-out/*/*_ecp5.v; write them with \`cargo run --release -- generate\`" >&2
    exit 2
fi

# Module $2 of the text $1, under the name `dut`. Such modules hold no others.
module_of() { sed -n "/^module $2(/,/^endmodule/p" "$1" | sed "1s/^module $2(/module dut(/"; }

# Whether the modules `dut` of the texts $1 and $2 are one function.
is_proven() {
    yosys -q -p "read_verilog $1; proc; memory_map; opt_clean; rename dut gold; design -stash gold;
        read_verilog +/ecp5/cells_sim.v $2; hierarchy -top dut; proc; flatten; rename dut gate;
        design -stash gate;
        design -copy-from gold -as gold gold; design -copy-from gate -as gate gate;
        miter -equiv -flatten gold gate miter; sat -verify -prove trigger 0 miter" >/dev/null 2>&1
}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

declare -A seen
failed=0 proven=0 refuted=0
for file in "${files[@]}"; do
    base=${file%_ecp5.v}.v
    [[ $file == *_ecp5.v && -f $file && -f $base ]] || {
        echo "ecp5: found no $file beside $base, expected both" >&2
        exit 2
    }
    count=0
    for module in $(sed -n 's/^module \([A-Za-z0-9_]*\).*/\1/p' "$file"); do
        count=$((count + 1))
        module_of "$base" "$module" >"$scratch/gold.v"
        module_of "$file" "$module" >"$scratch/gate.v"
        # Machines of one format have the same modules.
        texts=$(cat "$scratch/gold.v" "$scratch/gate.v" | sha256sum)
        [[ ${seen[$texts]-} ]] && continue
        if ! is_proven "$scratch/gold.v" "$scratch/gate.v"; then
            echo "FAIL  $file: $module is not proven to be that of $base" >&2
            failed=$((failed + 1))
            continue
        fi
        seen[$texts]=1 proven=$((proven + 1))
        if ((refuted == 0)); then
            # One bit of a LUT.
            sed "0,/INIT1(16'h\([0-9a-f]*\)[0-9a-f])/s//INIT1(16'h\15)/" "$scratch/gate.v" >"$scratch/wrong.v"
            if cmp -s "$scratch/gate.v" "$scratch/wrong.v" || is_proven "$scratch/gold.v" "$scratch/wrong.v"; then
                echo "ecp5: a chain with a wrong LUT was not refuted, so the proofs say nothing" >&2
                exit 1
            fi
            refuted=1
        fi
    done
    echo "read  $file ($count modules)"
done
((failed == 0)) || exit 1
echo "ecp5: $proven different modules proven, and a wrong one refuted"
