#!/usr/bin/env bash
# Measures the figures that `photoncube list` and the README show, and writes them to docs/measured/:
# area by scripts/yosys/synth.sh and speed by scripts/yosys/place.sh, then error, clocks and the proof
# by `photoncube run` on the built-in scene, for each machine. Also refreshes the README's picture.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if (($# > 0)); then
    printf 'Usage: scripts/measure.sh\nWrites docs/measured/*.json and docs/cornell.png.\n'
    [[ $1 == -h || $1 == --help ]] && exit 0
    exit 2
fi

scripts/setup.sh --synthesis
scripts/yosys/synth.sh
scripts/yosys/place.sh
cargo build --locked --release
for folder in hdl-out/*/; do
    machine=$(basename "$folder")
    printf '\n=== %s\n' "$machine"
    target/release/photoncube run --machine "$machine" --out "target/measured/$machine"
    cp "target/measured/$machine/run.json" "docs/measured/run-$machine.json"
done
cp target/measured/paper/cornell.png docs/cornell.png
printf '\nmeasured; if the table of `photoncube list` changed, paste it into README.md\n'
