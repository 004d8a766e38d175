#!/usr/bin/env bash
# Runs FuseSoC on a core: lint, simulation in two simulators, synthesis.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)

usage() {
    cat <<USAGE
Usage: scripts/core/fusesoc.sh DIR [TARGET...]

DIR has a core as \`photoncube generate --chains\` wrote it; nothing is written there. Runs these targets of FuseSoC, or
those that are named: lint (Verilator), icarus and verilator (the example testbench), synth (Yosys to
the cells of ECP5). The programs are those of scripts/setup.sh; synth takes the distribution's Yosys, because FuseSoC's scripts
are in Tcl, which YoWASP's Yosys lacks.

Exit codes: 0 all targets pass; 1 one fails; 2 bad usage.
USAGE
}

note() { printf 'fusesoc: %s\n' "$*" >&2; }

if [[ ${1:-} == -h || ${1:-} == --help ]]; then
    usage
    exit 0
fi
if (($# == 0)); then
    usage >&2
    exit 2
fi
core=$1
shift
targets=("$@")
((${#targets[@]})) || targets=(lint icarus verilator synth)
for target in "${targets[@]}"; do
    case $target in
        lint | icarus | verilator | synth) ;;
        *)
            note "found target \`$target\`, expected lint, icarus, verilator or synth"
            exit 2
            ;;
    esac
done
words=("$core"/*.streams.json)
if [[ ! -f ${words[0]} ]]; then
    note "found no .streams.json in $core; expected the folder of a core"
    exit 2
fi
top=$(basename "${words[0]}" .streams.json)
tools=$("$root/scripts/setup.sh" --where-core)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

mkdir "$scratch/library"
cp "$core/$top.v" "$core/${top}_tb.v" "$scratch/library/"
sed "s/@TOP@/$top/g" "$here/core.in" >"$scratch/library/$top.core"
# FuseSoC keeps its settings and what it has downloaded in the home folder; here it has neither.
export XDG_CONFIG_HOME=$scratch/config XDG_CACHE_HOME=$scratch/cache XDG_DATA_HOME=$scratch/data
cd "$scratch"

for target in "${targets[@]}"; do
    start=$SECONDS
    if ! "$tools/fusesoc" --cores-root "$scratch/library" run --target "$target" --build-root "$scratch/build-$target" \
        "photoncube:cores:$top:0" >"$scratch/log" 2>&1; then
        note "target $target failed:"
        tail -30 "$scratch/log" >&2
        exit 1
    fi
    if [[ $target == icarus || $target == verilator ]] && ! grep -q '^PASSED: [1-9]' "$scratch/log"; then
        note "the testbench did not pass in $target:"
        tail -30 "$scratch/log" >&2
        exit 1
    fi
    if [[ $target == synth && -z $(find "$scratch/build-synth" -name "photoncube_*$top*.json" -size +1k) ]]; then
        note "synth wrote no netlist"
        exit 1
    fi
    printf 'fusesoc: target %s of %s passed (%d s)\n' "$target" "$top" $((SECONDS - start))
done
