#!/usr/bin/env bash
# Opens the pages of `report` and `run` in headless Chromium and checks them; then plants faults in a page, each of which
# must be found.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)

usage() {
    cat <<USAGE
Usage: scripts/page/check.sh [--screenshots DIR] [--help]

Writes the pages of small runs of \`photoncube report\` and \`photoncube run\`, and opens each in headless Chromium. No
request may leave the page, and nothing may be logged as an error. The slider, the charts and the hypercube are used by
mouse and by key; each drawn value is compared with the table. axe-core looks for barriers in light and in dark. The page
may not be wider than a screen of 360, 768 and 1280 pixels. Then faults are planted in a page, and each must be found.

  --screenshots DIR  keep the screenshots there
  --help             this text

It needs Chromium, node and npm: Debian's packages chromium, nodejs and npm. It installs puppeteer-core and axe-core from
npm, in the versions of package-lock.json, into the folder of scripts/setup.sh.

Environment:
  PHOTONCUBE        the program (default: the debug build of this checkout)
  PHOTONCUBE_TOOLS  as for scripts/setup.sh

Exit codes: 0 the pages pass and all faults are found; 1 something differs or a tool is missing; 2 bad usage.
USAGE
}

fail() {
    printf 'page: %s\n' "$*" >&2
    exit 1
}

screenshots=
while (($# > 0)); do
    case $1 in
        --screenshots)
            (($# > 1)) || { usage >&2; exit 2; }
            screenshots=$2
            shift
            ;;
        -h | --help) usage; exit 0 ;;
        *) usage >&2; exit 2 ;;
    esac
    shift
done

program=${PHOTONCUBE:-${CARGO_TARGET_DIR:-$root/target}/debug/photoncube}
[[ -x $program ]] || fail "found no $program; build it with cargo, or set PHOTONCUBE"
for tool in chromium node npm; do
    command -v "$tool" >/dev/null || fail "found no $tool; install it: apt-get install chromium nodejs npm"
done

tools=${PHOTONCUBE_TOOLS:-${XDG_CACHE_HOME:-$HOME/.cache}/photoncube}/page
mkdir -p "$tools"
cp "$here/package.json" "$here/package-lock.json" "$here/check.mjs" "$tools/"
if ! cmp -s "$tools/package-lock.json" "$tools/installed"; then
    (cd "$tools" && npm ci --no-audit --no-fund --silent)
    cp "$tools/package-lock.json" "$tools/installed"
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
screenshots=${screenshots:-$scratch/screenshots}
mkdir -p "$screenshots" "$scratch/faults"
small=(--photons 20000 --seed 1)
"$program" report ring "${small[@]}" --maps 4 --size 16x16 --picture-size 96x96 --out "$scratch" >/dev/null
"$program" run cornell "${small[@]}" --machine local --size 64x64 --samples 1 --iterations 50 --out "$scratch" >/dev/null
open_pages() { node "$tools/check.mjs" "$(command -v chromium)" "$@"; }
open_pages "$screenshots" "$scratch/report-ring.html" "$scratch/cornell.html"

# A fault: its name, what is replaced, and by what. What is replaced must be in the page.
faults=(
    'a picture from elsewhere|<footer>|<footer><img src="https://example.org/x.png" alt="x">'
    'an error in the script|"use strict";|"use strict"; console.error("planted");'
    'text of low contrast|</style>|.verdict{color:#bbb}</style>'
    'a slider that does nothing|slider.addEventListener("input", show)|0'
    'a mark that shows nothing|point.addEventListener("focus", show)|0'
    'the state before, drawn as the one after|const now = states\[at\]|const now = states[Math.max(0, at - 1)]'
    'registers of an engine of the clock before|cell.textContent = clocks\[at\]|cell.textContent = clocks[Math.max(0, at - 1)]'
    'keys that do nothing|ArrowLeft: "back"|ArrowLeft: "next"'
    'a button without a name|<button type="button" data-go="first">First|<button type="button" data-go="first">'
    'a picture without a text|alt="The scene by the reference in f64"|'
    'a page wider than a phone|</style>|h1{width:900px}</style>'
)
for fault in "${faults[@]}"; do
    IFS='|' read -r name from to <<<"$fault"
    sed "s|$from|$to|" "$scratch/report-ring.html" >"$scratch/faults/fault.html"
    ! cmp -s "$scratch/report-ring.html" "$scratch/faults/fault.html" || fail "the fault has no place in the page: $name"
    code=0
    open_pages "$scratch/faults" "$scratch/faults/fault.html" >"$scratch/faults/log" 2>&1 || code=$?
    if ((code != 1)) || ! grep -q '^page: wrong: ' "$scratch/faults/log"; then
        sed 's/^/page:   /' "$scratch/faults/log" >&2
        fail "the check missed a fault (exit code $code): $name"
    fi
    printf 'page: found: %s\n' "$name"
done
printf 'page: 2 pages passed, %s of %s planted faults found\n' "${#faults[@]}" "${#faults[@]}"
