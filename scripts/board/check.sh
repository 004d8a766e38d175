#!/usr/bin/env bash
# Whether four readers of Verilog take a board's Verilog, and whether nextpnr and ecppack make a bitstream of it.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/board/check.sh [--bitstream]

Writes the Verilog of the committed core on a ULX3S, with the model of the PLL, and gives it to scripts/yosys/check.sh.

  --bitstream  also: the PLL has the numbers of ecppll, and `photoncube board ulx3s` makes a bitstream whose clock is
               reached. It takes minutes and needs the tools of `scripts/setup.sh --synthesis`

Exit codes: 0 all holds; 1 something does not; 2 bad usage or a missing tool.
USAGE
}

bitstream=0
for argument in "$@"; do
    case $argument in
        --bitstream) bitstream=1 ;;
        -h | --help)
            usage
            exit 0
            ;;
        *)
            echo "board: found \`$argument\`, expected --bitstream or --help" >&2
            exit 2
            ;;
    esac
done
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
photoncube=${CARGO_TARGET_DIR:-target}/debug/photoncube
[[ -x $photoncube ]] || {
    echo "board: found no $photoncube; build it with \`cargo build --locked\`" >&2
    exit 2
}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$photoncube" board ulx3s --no-build --out "$scratch" >/dev/null
mkdir "$scratch/whole"
whole=$scratch/whole/photoncube_ulx3s.v
for file in "$scratch"/photoncube_ulx3s.v "$scratch"/photoncube_ulx3s_pll_model.v "$scratch"/photoncube_core_*.v; do
    # The ECP5's own cells are for the bitstream alone.
    [[ $file == *_ecp5.v ]] || cat "$file"
done >"$whole"
scripts/yosys/check.sh "$whole"
((bitstream)) || exit 0

tools=$(scripts/setup.sh --where) || exit 2
# The parameters that set the frequency. ecppll's phase is half of a divider, with a rounding error; nothing here depends on it.
numbers() { grep -oE '\.(CLK(I|FB|OP)_DIV|FEEDBK_PATH)\([^)]*\)' "$1" | sort; }
for mhz in 40 50 60 75; do
    "$photoncube" board ulx3s --no-build --mhz "$mhz" --out "$scratch" >/dev/null
    (cd "$scratch" && "$tools/yowasp-ecppll" -i 25 -o "$mhz" -f by_ecppll.v >/dev/null 2>&1)
    diff <(numbers "$scratch/photoncube_ulx3s_pll.v") <(numbers "$scratch/by_ecppll.v") || {
        echo "board: the PLL at $mhz MHz differs from that of ecppll" >&2
        exit 1
    }
    echo "pass  the PLL at $mhz MHz is that of ecppll"
done
"$photoncube" board ulx3s --out "$scratch"
# The preamble of a bitstream.
LC_ALL=C grep -qaP '\xff\xff\xbd\xb3' "$scratch/photoncube_ulx3s.bit" || {
    echo "board: found no preamble in the bitstream" >&2
    exit 1
}
