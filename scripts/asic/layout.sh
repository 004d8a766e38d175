#!/usr/bin/env bash
# Lays out a machine in the cells osu018 down to GDS, and checks the layout: design rules, and transistors against the netlist.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
readonly TECH=/usr/share/qflow/tech/osu018
readonly QFLOW=/usr/lib/qflow
# The geometry of the cells, which Debian leaves out of qflow-tech-osu018. The outlines in its LEF file are of the same cells.
readonly CELLS_SHA256=b471e4d2fb03e538548b5949d99036e47cb4aa7a16fd3129c3359c3a3e2d45f4
readonly CELLS_FROM="tech/osu018/osu018_stdcells.gds2 of https://github.com/RTimothyEdwards/qflow at commit 52ecda1"

# What graywolf begins with in qflow.
readonly QFLOW_SEED=12345
# The most placements that are routed.
readonly MOST_TRIES=6

usage() {
    cat <<USAGE
Usage: scripts/asic/layout.sh [MACHINE] [--cells FILE] [--density X] [--seed N] [--out DIR] [--record] [--help]

Lays out MACHINE (default: fit-ring, the smallest) in the cells osu018: the netlist of \`photoncube synth --asic\`, placed by
graywolf, routed by qrouter, and made into GDS by magic. Checks the GDS: design rules by magic, and its transistors against the
netlist by netgen; both checks must also find faults that the script plants. Computes the clock with the wires by OpenSTA, and draws
a picture. \`fit-ring\` takes 8 minutes, on one core, and 5 more for each further seed. Installs what is missing by \`scripts/setup.sh --layout\`.

  --cells FILE  the geometry of the cells: $CELLS_FROM;
                it is kept, so that later calls need no --cells
  --density X   the part of the rows that cells take, the rest is room for wires (default: 0.7)
  --seed N      what graywolf begins with (default: $QFLOW_SEED, which is qflow's); the next seeds follow where a layout
                is not clean
  --out DIR     where the layout and all logs go (default: out/layout-MACHINE)
  --record      also write docs/measured/layout-MACHINE.json, its logs there, and docs/layout-MACHINE.webp
  --help        this text

Environment: PHOTONCUBE is the program (default: the debug build).
Exit codes: 0 the layout is there and all checks hold; 1 a step or a check failed; 2 bad usage.
USAGE
}

fail() {
    printf 'layout: %s\n' "$*" >&2
    exit 1
}
misused() {
    printf 'layout: %s\n' "$*" >&2
    exit 2
}

machine='' cells='' density=0.7 seed=$QFLOW_SEED out='' record=0
while (($# > 0)); do
    case $1 in
        --cells | --density | --seed | --out)
            (($# > 1)) || misused "found $1 alone, expected a value after it"
            printf -v "${1#--}" '%s' "$2"
            shift
            ;;
        --record) record=1 ;;
        -h | --help)
            usage
            exit 0
            ;;
        -*) misused "found $1, expected --cells, --density, --seed, --out, --record or --help" ;;
        *)
            [[ -z $machine ]] || misused "found the machines $machine and $1, expected one"
            machine=$1
            ;;
    esac
    shift
done
machine=${machine:-fit-ring}
[[ $density =~ ^0\.[0-9]+$ ]] || misused "--density: found $density, expected a number between 0 and 1"
[[ $seed =~ ^[0-9]+$ ]] || misused "--seed: found $seed, expected a whole number"
out=${out:-$root/out/layout-$machine}
mkdir -p -- "$out"
out=$(cd "$out" && pwd)
[[ $out == *[[:space:]]* ]] && misused "--out: found $out, expected a path without spaces, which qflow cannot read"

program=${PHOTONCUBE:-${CARGO_TARGET_DIR:-$root/target}/debug/photoncube}
[[ -x $program ]] || fail "found no $program; build it with cargo, or set PHOTONCUBE"
"$root/scripts/setup.sh" --layout
python=$("$root/scripts/setup.sh" --where-layout)/python
kept=$(dirname "$(dirname "$(dirname "$python")")")/osu018_stdcells.gds2
if [[ -n $cells ]]; then
    [[ -r $cells ]] || misused "--cells: found no file $cells, expected $CELLS_FROM"
else
    cells=$kept
    [[ -r $cells ]] || fail "found no geometry of the cells; --cells names it: $CELLS_FROM"
fi
sum=$(sha256sum <"$cells")
[[ ${sum%% *} == "$CELLS_SHA256" ]] ||
    fail "$cells: found SHA-256 ${sum%% *}, expected $CELLS_SHA256, which is that of $CELLS_FROM"
if [[ $cells != "$kept" ]]; then
    cp -- "$cells" "$kept.part"
    mv -- "$kept.part" "$kept"
fi

# The name of the layout: of letters, digits and underscores, as all programs take it.
name=${machine//-/_}
flow=$out/flow
rm -rf -- "$flow"
# What an earlier call found is not this one's.
rm -f -- "$out"/{layout.json,layout.webp,drc.txt,lvs.txt}
mkdir -p -- "$flow"/{synthesis,log,source}
export NAME=$name LEF=$flow/cells.lef CELLS=$kept LIBERTY=$TECH/osu018_stdcells.lib

steps=6 step=0
begin() {
    step=$((step + 1))
    printf 'layout: %d of %d: %s\n' "$step" "$steps" "$*" >&2
}
# Runs a command with its output in the log $1.
logged() {
    local log=$out/$1
    shift
    "$@" >"$log" 2>&1 || fail "$1 failed with exit code $?; $log says why"
}
in_layout() { (cd "$flow/layout" && "$@"); }
# Runs the script $1 in magic, with the log $2.
magic_does() { logged "$2" in_layout magic -dnull -noconsole -rcfile "$TECH/osu018.magicrc" "$here/$1.tcl" </dev/null; }

begin "netlist of $machine"
"$program" synth --asic --machine "$machine" --netlists "$out" --json >"$out/synth.json" || exit
if grep -q '"ram_bits"' "$out/synth.json"; then
    fail "$machine has a photon memory, expected a machine without one, since osu018 has no RAM"
fi
netlist() { python3 "$here/netlist.py" "$out/$machine.v" "$TECH/osu018_stdcells.sp" "$name" "$flow/synthesis" "$@" >"$out/netlist.json"; }

# What qflow's scripts read.
python3 "$here/lef.py" "$TECH/osu018_stdcells.lef" "$LEF"
cat >"$flow/qflow_vars.sh" <<VARS
set projectpath=$flow
set techdir=$TECH
set techname=osu018
set sourcedir=$flow/source
set synthdir=$flow/synthesis
set layoutdir=$flow/layout
set logdir=$flow/log
set scriptdir=$QFLOW/scripts
set bindir=$QFLOW/bin
VARS
cat >"$flow/project_vars.sh" <<VARS
set leffile=$LEF
set initial_density=$density
set vddnet=vdd
set gndnet=gnd
VARS
# Without qrouter's third stage, which routes every net anew: an hour for few shorter wires.
readonly ROUTE="qrouter::standard_route ${name}_route.def false true"
# Places the cells from the seed $1, with the log $2.
place() {
    rm -rf -- "${flow:?}/layout"
    mkdir -- "$flow/layout"
    sed "s/^\*random.seed.*/*random.seed : $1/" "$TECH/osu018.par" >"$flow/layout/$name.par"
    printf '%s\nquit\n' "$ROUTE" >"$flow/layout/$name.cfg2"
    : >"$flow/log/synth.log"
    logged "$2" "$QFLOW/scripts/placement.sh" -k -d "$flow" "$name"
    [[ -s $flow/layout/$name.def ]] || fail "graywolf left no placement; $out/$2 says why"
}
# Whether qrouter connects all nets.
route() {
    "$QFLOW/scripts/router.sh" "$flow" "$name" >"$out/route.log" 2>&1 &&
        grep -q 'Final: No failed routes' "$flow/log/route.log" && python3 "$here/loose.py" "$flow/layout/$name.def" >"$out/loose.log"
}
# Makes the layout and checks its design rules, as it is and with a planted sliver.
make_layout() {
    magic_does layout layout.log
    magic_does gds gds.log
    for gds in "$name" "${name}_sliver"; do
        [[ -s $flow/layout/$gds.gds ]] || fail "magic left no $gds.gds; $out/gds.log says why"
    done
    grep -qx 'DRC errors: 0' "$flow/layout/drc.txt"
}

begin "placement without a clock tree, which shows what registers are near each other (2 minutes)"
netlist --no-clock-tree
place "$QFLOW_SEED" place-near.log
mv "$flow/layout/${name}_unroute.def" "$flow/near.def"
begin "placement, routing, and design rules, as it is and with a planted sliver of metal (5 minutes for each seed)"
netlist --near "$flow/near.def"
last=$((seed + MOST_TRIES))
while true; do
    place "$seed" place.log
    if ! route; then
        printf 'layout: seed %d: qrouter leaves nets open\n' "$seed" >&2
    elif ! make_layout; then
        printf 'layout: seed %d: %s against the design rules\n' "$seed" "$(grep '^DRC errors:' "$flow/layout/drc.txt")" >&2
    else
        break
    fi
    seed=$((seed + 1))
    ((seed < last)) || fail "found no clean layout with the seeds before $seed; $out/route.log, $out/loose.log and" \
        "$flow/layout/drc.txt say why; a lower --density leaves more room"
done

begin "transistors of the GDS, compared with the netlist: as it is, with the sliver, and with two outputs exchanged in the netlist"
extract() {
    export FILE=$1
    magic_does extract "extract-$1.log"
}
compare() { logged "$1.log" in_layout netgen-lvs -batch lvs "$2.spice $name" "$flow/synthesis/$3.spice $name" "$here/lvs.tcl" "$1.out" -json </dev/null; }
extract "$name"
extract "${name}_sliver"
compare lvs "$name" "$name"
compare lvs-sliver "${name}_sliver" "$name"
compare lvs-exchanged "$name" "${name}_exchanged"

begin "clock with wires"
nets=$(python3 -c 'import json, sys; print(json.load(sys.stdin)["nets"])' <"$out/netlist.json")
cp "$flow/synthesis/$name.v" "$flow/layout/"
in_layout python3 "$here/spef.py" "$name.rc" "$name.spef" "$nets" >"$out/wires.json"
logged timing.log in_layout sta -no_splash -exit "$here/timing.tcl"

begin "picture and figures"
"$python" "$here/picture.py" "$flow/layout/$name.gds" "$out/layout.webp"
"$python" "$here/report.py" "$machine" "$name" "$out" "$TECH" "$density" "$seed"
if ((record)); then
    cp -- "$out/layout.json" "$root/docs/measured/layout-$machine.json"
    cp -- "$out/drc.txt" "$root/docs/measured/layout-$machine-drc.log"
    cp -- "$out/lvs.txt" "$root/docs/measured/layout-$machine-lvs.log"
    cp -- "$out/layout.webp" "$root/docs/layout-$machine.webp"
fi
printf 'layout: %s is laid out; %s/layout.json has the figures, %s/layout/%s.gds is the layout\n' "$machine" "$out" "$flow" "$name" >&2
