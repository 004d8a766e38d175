#!/usr/bin/env bash
# How far the pictures are from the truth: the tables of docs/accuracy.md.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/accuracy.sh [lighting | passes | confidence]

Prints tables (Markdown), all three unless one is named:
  lighting    the Cornell box lit in several ways, against the path-traced reference
  passes      progressive photon mapping of it, and of it with balls of glass and metal, by f64 and by integers of
              the default photon format
  confidence  on each built-in scene, how many pixels' error is within its bound, against f64 at convergence
About fifteen minutes on two cores, most of them for the last.
USAGE
}

case ${1-all} in
    all | lighting | passes | confidence) what=${1-all} ;;
    -h | --help)
        usage
        exit 0
        ;;
    *)
        usage >&2
        exit 2
        ;;
esac

cd "$(dirname "${BASH_SOURCE[0]}")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
reference=docs/reference/cornell.exr
size=(--size 128x128)

cargo build --quiet --release --locked
photoncube() {
    cargo run --quiet --release --locked -- "$@"
}

# One expression of a command's JSON, `r`.
json() {
    python3 -c 'import json, sys; r = json.load(sys.stdin); print(eval(sys.argv[1]))' "$1"
}

compare() {
    photoncube compare "$1" "$2" --json | json "f\"{r['$3']:.2e}\""
}

lighting() {
    printf '\n| options | f64: relMSE | integers: relMSE | between the two: relMSE | seconds, integers |\n'
    printf '| --- | --- | --- | --- | --- |\n'
    local light seconds
    for light in "" "--area covered" "--direct rays:4" "--direct rays:4 --area covered" \
        "--direct rays:4 --area covered --final-gather 16" \
        "--direct rays:4 --area covered --final-gather 64"; do
        # shellcheck disable=SC2086 # options
        photoncube render cornell "${size[@]}" -o "$work/f64.exr" --engine f64 $light >/dev/null
        # shellcheck disable=SC2086
        seconds=$(photoncube render cornell "${size[@]}" -o "$work/format.exr" --engine format $light --json |
            json "f\"{r['seconds']:.1f}\"")
        local options="\`$light\`"
        [[ -n $light ]] || options='no option: all light from the photon map'
        printf '| %s | %s | %s | %s | %s |\n' "$options" \
            "$(compare "$work/f64.exr" "$reference" rel_mse)" \
            "$(compare "$work/format.exr" "$reference" rel_mse)" \
            "$(compare "$work/format.exr" "$work/f64.exr" rel_mse)" "$seconds"
    done
}

# The rows of two runs beside each other.
rows() {
    python3 - "$@" <<'PY'
import json, sys
f64, integers = (json.load(open(name))["progress"] for name in sys.argv[1:3])
percent = lambda value: "-" if value is None else f"{100 * value:.1f} %"
for a, b in zip(f64, integers):
    print(f"| {b['passes']} | {b['photons']} | {b['search_radius']:.4f} | {a['rel_mse']:.2e} | {b['rel_mse']:.2e} "
          f"| {percent(b['estimated_noise'])} | {percent(b['estimated_bias'])} | {percent(b['error_bound'])} "
          f"| {percent(b['bounded_share'])} |")
PY
}

# A scene in passes, beside its path-traced picture.
passes_of() {
    local scene=$1 truth=$2 engine
    shift 2
    for engine in f64 format; do
        photoncube progressive "$scene" "${size[@]}" -o "$work/p-$engine.exr" --engine "$engine" "$@" \
            --passes 64 --reference "$truth" --json >"$work/p-$engine.json"
    done
    printf '\n`%s` with `%s`:\n\n' "$scene" "$*"
    printf '| passes | photons | radius | f64: relMSE | integers: relMSE | noise | bias | bound | in bounds |\n'
    printf '| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n'
    rows "$work/p-f64.json" "$work/p-format.json"
    printf '\nAfter the last pass, integers against f64 on the same photons: relMSE %s.\n' \
        "$(compare "$work/p-format.exr" "$work/p-f64.exr" rel_mse)"
}

passes() {
    passes_of cornell docs/reference/cornell.exr --direct rays --area covered
    passes_of docs/scenes/spheres.toml docs/reference/spheres.exr --direct rays --caustics own --area covered
}

confidence() {
    printf '\n| scene | confidence | passes | bound | in bounds | bound of the f64 reference |\n'
    printf '| --- | --- | --- | --- | --- | --- |\n'
    local scene share bound
    for scene in cornell ring range; do
        bound=$(photoncube progressive "$scene" --size 64x64 -o "$work/$scene.exr" --engine f64 --area covered \
            --direct rays:4 --caustics own:30 --photons 400000 --in-range 30 --passes 128 --seed 5000 --json |
            json "f\"{100 * r['progress'][-1]['error_bound']:.1f} %\"")
        for share in 0.5 0.9; do
            photoncube progressive "$scene" --size 64x64 -o "$work/c.exr" --engine format --area covered \
                --confidence "$share" --passes 32 --reference "$work/$scene.exr" --json >"$work/c.json"
            python3 - "$work/c.json" "$scene" "$share" "$bound" <<'PY'
import json, sys
name, scene, share, bound = sys.argv[1:]
for row in json.load(open(name))["progress"]:
    if row["passes"] in (4, 32):
        print(f"| {scene} | {100 * float(share):.0f} % | {row['passes']} | {100 * row['error_bound']:.1f} % "
              f"| {100 * row['bounded_share']:.1f} % | {bound} |")
PY
        done
    done
}

for table in lighting passes confidence; do
    if [[ $what == all || $what == "$table" ]]; then
        "$table"
    fi
done
