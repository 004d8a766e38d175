#!/usr/bin/env bash
# Measures the figures that `photoncube list` and the README show, and writes them to docs/measured/:
# area and Fmax by `photoncube synth`, then error, clocks and the proof by `photoncube run` for each
# machine, on `cornell`, or on the scene that the machine is fitted to; and the fit of every built-in
# scene. Also refreshes the README's picture.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if (($# > 0)); then
    printf 'Usage: scripts/measure.sh\nWrites docs/measured/*.json and docs/cornell.png.\n'
    [[ $1 == -h || $1 == --help ]] && exit 0
    exit 2
fi

scripts/setup.sh --synthesis
cargo build --locked --release
target/release/photoncube synth
for folder in hdl-out/*/; do
    machine=$(basename "$folder")
    printf '\n=== %s\n' "$machine"
    # A machine is named `fit-SCENE` after the scene that it is for.
    scene=cornell
    [[ $machine == fit-* ]] && scene=${machine#fit-}
    target/release/photoncube run "$scene" --machine "$machine" --out "target/measured/$machine"
    cp "target/measured/$machine/run.json" "docs/measured/run-$machine.json"
done
for scene in cornell ring range; do
    target/release/photoncube fit "$scene" --json >"target/measured/fit-$scene.json"
    cp "target/measured/fit-$scene.json" docs/measured/
done
cp target/measured/paper/cornell.png docs/cornell.png
printf '\nmeasured; if the table of `photoncube list` changed, paste it into README.md\n'
