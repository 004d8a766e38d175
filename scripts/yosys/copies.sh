#!/usr/bin/env bash
# Shows that synthesis keeps the copies of a register, which are there for their places and nothing else.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/yosys/copies.sh [FILE]

FILE (default: hdl-out/tile-6-mixed/photoncube_tile_6_mixed.v) has the modules *_copy_1 and *_register_1.
Two copies of one bit must be two flip-flops of an ECP5 after synthesis; that the check can fail is shown
on two registers, which are merged into one.

Exit codes: 0 copies are kept; 1 they are not, or registers are; 2 bad usage, a missing file or tool.
USAGE
}

# shellcheck source=scripts/yosys/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
read_options "$@"
need "$prover"
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
file=${1:-$root/hdl-out/tile-6-mixed/photoncube_tile_6_mixed.v}
prefix=$(basename "$file" .v)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Whether two of the module $1 beside each other become $2 flip-flops.
become() {
    local module=${prefix}_$1
    sed -n "/^module $module(/,/^endmodule/p" "$file" >"$scratch/two.v"
    [[ -s $scratch/two.v ]] || {
        echo "copies: found no module $module in $file" >&2
        exit 2
    }
    cat >>"$scratch/two.v" <<VERILOG
module two(input wire clock, input wire d, output wire [1:0] q);
    $module a(.d(d), .q(q[0]), .clock(clock));
    $module b(.d(d), .q(q[1]), .clock(clock));
endmodule
VERILOG
    yosys_in "$scratch" "read_verilog two.v; synth_ecp5 -top two; select -assert-count $2 t:TRELLIS_FF" \
        >"$scratch/log" 2>&1
}

become copy_1 2 || {
    echo "copies: two copies did not stay two flip-flops:" >&2
    tail -3 "$scratch/log" >&2
    exit 1
}
become register_1 1 || {
    echo "copies: two registers did not become one flip-flop, so the check says nothing:" >&2
    tail -3 "$scratch/log" >&2
    exit 1
}
echo "copies: two copies of a register are kept, two registers are merged"
