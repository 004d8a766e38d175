#!/usr/bin/env bash
# How far the pictures are from the truth: the tables of docs/accuracy.md.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/accuracy.sh [lighting | passes | confidence | target | radius | peer | before COMMIT]

Prints tables (Markdown), all but `peer` and `before` unless one is named:
  lighting    the Cornell box lit in several ways, against the path-traced reference
  passes      progressive photon mapping of it, and of it with balls of glass and metal, by f64 and by integers of
              the default photon format
  confidence  on scenes with and without mirrors and glass, how many pixels' error is within its bound
  target      on these scenes, where --error-target stops, and how far the picture is from the truth there
  radius      the chi-square rule of the radii beside the schedule, at equal photons, by what the map carries
  peer        CPU seconds to an error, beside Mitsuba's path tracer; installs it from PyPI into a folder of its own,
              and needs Debian's package libllvm19
  before      CPU seconds to an error, beside the program of an older commit, which is built first
The truth of `confidence` and `target` is f64 at convergence, made first: two minutes a scene. About 40 minutes on
two cores; `peer` ten minutes more, `before` six.
USAGE
}

case ${1-all} in
    all | lighting | passes | confidence | target | radius | peer) what=${1-all} ;;
    before)
        what=before commit=${2-}
        [[ -n $commit ]] || {
            usage >&2
            exit 2
        }
        ;;
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
          f"| {percent(b['bounded_share'])} | {b['seconds']:.1f} |")
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
    printf '\n`%s%s`:\n\n' "$scene" "${*:+ $*}"
    printf '| passes | photons | radius | f64: relMSE | integers: relMSE | noise | bias | bound | in bounds | seconds, integers |\n'
    printf '| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n'
    rows "$work/p-f64.json" "$work/p-format.json"
    printf '\nAfter the last pass, integers against f64 on the same photons: relMSE %s.\n' \
        "$(compare "$work/p-format.exr" "$work/p-f64.exr" rel_mse)"
}

passes() {
    passes_of cornell docs/reference/cornell.exr
    passes_of cornell docs/reference/cornell.exr --photons 200000 --samples 1 --direct rays
    passes_of cornell docs/reference/cornell.exr --final-gather 4
    passes_of docs/scenes/spheres.toml docs/reference/spheres.exr
}

# Scenes with their lighting: the default, and all light by the map, whose chi-square rule `radius` is about.
cases=("cornell" "cornell --direct map --caustics map --radius-rule schedule"
    "ring" "ring --direct map --caustics map --radius-rule schedule"
    "docs/scenes/balls.toml" "docs/scenes/mirrors.toml" "docs/scenes/spheres.toml")

# The picture of a scene in f64 at convergence, 64 x 64, made once.
truth_of() {
    local picture=$work/truth-$(basename "$1" .toml).exr
    [[ -e $picture ]] || photoncube progressive "$1" --size 64x64 -o "$picture" --engine f64 --photons 1000000 --in-range 30 \
        --samples 4 --direct rays:8 --passes 64 --seed 5000 >/dev/null
    printf '%s' "$picture"
}

confidence() {
    printf '\n| scene, options | confidence | passes: 4 | 16 | 64 |\n'
    printf '| --- | --- | --- | --- | --- |\n'
    local case share
    for case in "${cases[@]}"; do
        for share in 0.5 0.9; do
            # shellcheck disable=SC2086 # a scene and options
            photoncube progressive $case --size 64x64 -o "$work/c.exr" --engine format --confidence "$share" --passes 64 \
                --reference "$(truth_of "${case%% *}")" --json >"$work/c.json"
            python3 - "$work/c.json" "$case" "$share" <<'PY'
import json, sys
name, case, share = sys.argv[1:]
rows = {row["passes"]: row for row in json.load(open(name))["progress"]}
within = " | ".join(f"{100 * rows[passes]['bounded_share']:.1f} %" for passes in (4, 16, 64))
print(f"| `{case}` | {100 * float(share):.0f} % | {within} |")
PY
        done
    done
}

target() {
    printf '\n| scene, options | target | passes | bound | of it, bias | root of relMSE | stopped by |\n'
    printf '| --- | --- | --- | --- | --- | --- | --- |\n'
    local case target stop
    for case in "${cases[@]}"; do
        for target in 0.1 0.05; do
            stop="the target"
            # An exit code of 1 says that the target was not reached.
            # shellcheck disable=SC2086 # a scene and options
            photoncube progressive $case --size 64x64 -o "$work/t.exr" --engine format --error-target "$target" --passes 200 \
                --reference "$(truth_of "${case%% *}")" --json >"$work/t.json" 2>/dev/null || stop="the passes"
            python3 - "$work/t.json" "$case" "$target" "$stop" <<'PY'
import json, sys
name, case, target, stop = sys.argv[1:]
row = json.load(open(name))["progress"][-1]
print(f"| `{case}` | {float(target):.2f} | {row['passes']} | {row['error_bound']:.3f} | {2 ** 0.5 * row['estimated_bias']:.3f} "
      f"| {row['rel_mse'] ** 0.5:.3f} | {stop} |")
PY
        done
    done
}

# What the map of a picture carries, with the options for it.
carried=("all light: --direct map --caustics map" "all but direct: --direct rays:4 --caustics map"
    "all but caustics: --direct map --caustics own" "neither: --direct rays:4 --caustics own")

# The picture of a scene by integers at convergence, 64 x 64, made once: sooner than `truth_of`, and with as many photons.
truth_by_integers_of() {
    local picture=$work/integers-$(basename "$1" .toml).exr
    [[ -e $picture ]] || photoncube progressive "$1" --size 64x64 -o "$picture" --engine format --photons 500000 --in-range 30 \
        --samples 4 --direct rays:8 --passes 120 --seed 9000 >/dev/null
    printf '%s' "$picture"
}

radius() {
    printf '\n| scene | in the map | engine | photons traced | schedule: relMSE | chi-square: relMSE | ratio | bound | in bounds | seconds |\n'
    printf '| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n'
    local scene engine carries rule
    for scene in ring docs/scenes/caustic.toml cornell; do
        for carries in "${carried[@]}"; do
            for engine in format f64; do
                # One case in f64 shows that the engines do not differ here.
                [[ $engine == format || "$scene $carries" == "ring all light"* ]] || continue
                for rule in schedule chi-square; do
                    # shellcheck disable=SC2086 # options
                    photoncube progressive "$scene" --size 64x64 -o "$work/r.exr" --engine "$engine" ${carries#*: } \
                        --photons 50000 --samples 2 --passes 128 --radius-rule "$rule" \
                        --reference "$(truth_by_integers_of "$scene")" --json >"$work/r-$rule.json"
                done
                python3 - "$work" "$scene" "${carries%%:*}" "$engine" <<'PY'
import json, sys
work, scene, carries, engine = sys.argv[1:]
rules = [{row["passes"]: row for row in json.load(open(f"{work}/r-{rule}.json"))["progress"]}
         for rule in ("schedule", "chi-square")]
for passes in (16, 128):
    schedule, chi = (rule[passes] for rule in rules)
    print(f"| `{scene}` | {carries} | {engine} | {50000 * passes:,} | {schedule['rel_mse']:.2e} | {chi['rel_mse']:.2e} "
          f"| {chi['rel_mse'] / schedule['rel_mse']:.2f} | {chi['error_bound']:.3f} | {100 * chi['bounded_share']:.1f} % "
          f"| {schedule['seconds']:.0f}, {chi['seconds']:.0f} |")
PY
            done
        done
    done
}

peer() {
    local tools=${XDG_CACHE_HOME:-$HOME/.cache}/photoncube/peer
    [[ -x $tools/bin/python ]] || python3 -m venv "$tools"
    "$tools/bin/pip" install --quiet --requirement scripts/requirements-peer.txt
    local llvm=(/usr/lib/*-linux-gnu/libLLVM.so.19.1)
    if [[ ! -e ${llvm[0]} ]]; then
        echo "scripts/accuracy.sh: found no libLLVM 19, which Mitsuba compiles by; install Debian's package libllvm19" >&2
        exit 1
    fi
    printf '\n'
    DRJIT_LIBLLVM_PATH=${llvm[0]} "$tools/bin/python" scripts/path_tracer.py target/release/photoncube "$work"
}

# The program of an older commit beside this one, each with its default options, on scenes with and without caustics.
before() {
    git worktree add --quiet --detach "$work/old" "$commit"
    trap 'git worktree remove --force "$work/old"; rm -rf "$work"' EXIT
    cargo build --quiet --release --locked --manifest-path "$work/old/Cargo.toml"
    local scene rows=()
    for scene in cornell ring docs/scenes/spheres.toml docs/scenes/caustic.toml docs/scenes/balls.toml; do
        rows+=("$scene" "$(truth_by_integers_of "$scene")")
    done
    printf '\n'
    python3 scripts/accuracy_before.py "$work/old/target/release/photoncube" target/release/photoncube "${rows[@]}"
}

for table in lighting passes confidence target radius; do
    if [[ $what == all || $what == "$table" ]]; then
        "$table"
    fi
done
if [[ $what == peer || $what == before ]]; then
    "$what"
fi
