#!/usr/bin/env bash
# Measures the figures that `photoncube list`, the README and docs/machines.md show, and writes them to docs/measured/:
# area and Fmax by `photoncube synth`, then error, clocks and the comparison by `photoncube run` for each
# machine, on `cornell`, or on the scene that the machine is fitted to; and the fit of every built-in
# scene. Also refreshes the README's pictures.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

place_chains=0 place_cores=0 random_groups=0 liberty=
for option; do
    case $option in
        --place-chains) place_chains=1 ;;
        --place-cores) place_cores=1 ;;
        --random-groups) random_groups=1 ;;
        --liberty=*) liberty=${option#*=} ;;
        *)
            printf 'Usage: scripts/measure.sh [--place-chains] [--place-cores] [--random-groups] [--liberty=FILE]\n'
            printf 'Writes docs/measured/*.json, docs/cornell.png and docs/spheres.png.\n'
            printf '  --place-chains   also place the machines of several engines: hours\n'
            printf '  --place-cores    also place cores of one chain and of six: two hours\n'
            printf '  --random-groups  also compare each machine of less than 9 clocks in Verilator, on a\n'
            printf '                   million random groups: an hour\n'
            printf '  --liberty=FILE   also measure the machines in these standard cells, which have clock gates, beside those of\n                   osu018: two hours\n'
            [[ $option == -h || $option == --help ]] && exit 0
            exit 2
            ;;
    esac
done

mkdir -p target/measured
scripts/setup.sh --synthesis --asic
cargo build --locked --release
synth=(target/release/photoncube synth --update)
# Area and clock: of single engines and cells in all flows; of chains of engines on their own device.
measure_area_and_clock() {
    flows=() seeds=() chain_seeds=(--seeds 1)
    full_device=(--placer static --router router2)
    case $1 in
        # The median that the project names is of five.
        stream) seeds=(--seeds 5) ;;
        # Devices so full that nextpnr's default router does not come to an end with all seeds; its
        # default placer leaves some cells of the first far from theirs and finds no place for some of
        # the second.
        chip-mixed) flows=(--flow ecp5) chain_seeds=(--seeds 1 "${full_device[@]}") ;;
        tile-10) flows=(--flow ecp5-nodsp) chain_seeds=(--seeds 1 "${full_device[@]}") ;;
        tile-6-mixed) flows=(--flow ecp5 --flow ecp5-nodsp) ;;
        tile-4 | tile-5) ;;
        tile-* | chip-*) flows=(--flow ecp5-nodsp) ;;
    esac
    "${synth[@]}" --machine "$1" "${flows[@]}" "${seeds[@]}"
    if ((${#flows[@]} > 0 && place_chains)); then
        "${synth[@]}" --machine "$1" --flow place --grade 8 "${chain_seeds[@]}"
    fi
}
# The folder has all machines only after they were generated.
target/release/photoncube generate
for folder in hdl-out/*/; do
    machine=$(basename "$folder")
    # A core is no machine: its chains are measured below.
    [[ $machine == core-* ]] && continue
    printf '\n=== %s\n' "$machine"
    measure_area_and_clock "$machine"
    case $machine in
        stream | overlap | tile-* | chip-*)
            if ((random_groups)); then
                target/release/photoncube verify equivalence --machine "$machine" --against verilator \
                    --iterations 1000000 --json >"target/measured/verify-$machine.json"
                cp "target/measured/verify-$machine.json" docs/measured/
            fi
            ;;
    esac
    # The engines of longer chains are those of `tile-6`.
    case $machine in
        tile-4 | tile-5 | tile-[7-9] | tile-10 | tile-6-mixed | chip-*) continue ;;
    esac
    # A machine is named `fit-SCENE` after the scene that it is for.
    scene=cornell
    [[ $machine == fit-* ]] && scene=${machine#fit-}
    target/release/photoncube run "$scene" --machine "$machine" --out "target/measured/$machine"
    cp "target/measured/$machine/run.json" "docs/measured/run-$machine.json"
done
# Area, clock and energy in standard cells, also at the activities of a simulation. `tile-10` and the chips take half an hour each.
in_cells=(paper paper-dsp paper-12 paper-5d local local-half fit-cornell fit-ring fit-range stream overlap tile-{4,5,6,7,8,9,10} chip-lut
    chip-mixed tile-6-mixed leaf-7-local7-rgb6d-n4096 stream-shallow-local8-rgb8d-n16384 tile-{6,7}-shallow-local7-rgb6d-n4096)
# Measures machines in a library, named by the options, and records them in the library's file, whose name ends in $1.
measure_in_cells() {
    local ending=$1 library
    shift
    target/release/photoncube synth --asic --activity-of cornell "$@" --json >target/measured/asic.json
    library=$(python3 -c 'import json, sys; print(json.load(sys.stdin)["library"])' <target/measured/asic.json)
    cp target/measured/asic.json "docs/measured/asic-$library$ending.json"
}
measure_in_cells "" "${in_cells[@]/#/--machine=}"
# Of some machines also with clock gates, which osu018 has none of.
if [[ -n $liberty ]]; then
    measure_in_cells "" --liberty "$liberty" "${in_cells[@]/#/--machine=}"
    gated=(paper local fit-ring overlap stream stream-shallow-local8-rgb8d-n16384 tile-6 tile-6-shallow-local7-rgb6d-n4096)
    measure_in_cells -gated --liberty "$liberty" --clock-gating "${gated[@]/#/--machine=}"
fi
# The area of chains, from which `fit` and `run` compute how many a device holds.
chains=()
for dimension in 4 5 6 7 8 9; do
    chains+=(--machine "leaf-$dimension-local7-rgb6d-n4096")
done
target/release/photoncube synth "${chains[@]}" --flow ecp5 --json >target/measured/chains.json
cp target/measured/chains.json docs/measured/
# The machine with the highest peak. A seed takes half an hour.
if ((place_chains)); then
    fine=tile-10-fine-local7-mono1-n8192
    target/release/photoncube synth --machine "$fine" --flow ecp5 --flow place --grade 8 --seeds 2 --json \
        >"target/measured/$fine.json"
    cp "target/measured/$fine.json" docs/measured/
fi
# The clock of cores: chains, seeds, options of nextpnr.
place_core() {
    local core=core-$1-leaf-7-local7-rgb6d-n4096
    target/release/photoncube synth --machine leaf-7-local7-rgb6d-n4096 --chains "$1" --flow ecp5 --flow place --grade 8 \
        --seeds "$2" "${@:3}" --map-for 4500 --json >"target/measured/$core.json"
    cp "target/measured/$core.json" docs/measured/
}
if ((place_cores)); then
    place_core 1 3
    # A seed takes an hour. By the default placer the wires are a tenth longer, and the router was far from done after 26 minutes.
    place_core 6 1 --placer static
fi
for scene in cornell ring range; do
    target/release/photoncube fit "$scene" --json >"target/measured/fit-$scene.json"
    cp "target/measured/fit-$scene.json" docs/measured/
done
# The pictures of the README, by the emitted Verilog of a core in Verilator.
core=(--engine core --machine leaf-7-local7-rgb6d-n4096 --chains 6)
target/release/photoncube render cornell -o docs/cornell.png "${core[@]}"
target/release/photoncube progressive docs/scenes/spheres.toml -o docs/spheres.png "${core[@]}" --passes 16 \
    --photons 200000 --samples 1 --direct rays
printf '\nmeasured; a table of README.md, docs/machines.md or docs/formats.md may have changed: cargo test --bin photoncube prints it\n'
