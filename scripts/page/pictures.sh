#!/usr/bin/env bash
# Makes docs/page-desktop.webp and docs/page-phone.webp: the first screen of the page of `report cornell`.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)

if (($# > 0)); then
    cat <<USAGE
Usage: scripts/page/pictures.sh

Runs \`photoncube report cornell\`, which takes some minutes, and writes the first screen of its page into docs, as a
desktop and a dark phone show it. It needs what scripts/page/check.sh needs, and takes the tools that this installed.

Environment:
  PHOTONCUBE        the program (default: the debug build of this checkout)
  PHOTONCUBE_TOOLS  as for scripts/setup.sh
USAGE
    [[ $1 == -h || $1 == --help ]] && exit 0
    exit 2
fi

program=${PHOTONCUBE:-${CARGO_TARGET_DIR:-$root/target}/debug/photoncube}
tools=${PHOTONCUBE_TOOLS:-${XDG_CACHE_HOME:-$HOME/.cache}/photoncube}/page
[[ -x $program && -f $tools/installed ]] || {
    printf 'page: found no %s or no tools in %s; build the program, then run scripts/page/check.sh\n' "$program" "$tools" >&2
    exit 1
}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$program" report cornell --out "$scratch" >/dev/null
cp "$here/pictures.mjs" "$tools/"
node "$tools/pictures.mjs" "$(command -v chromium)" "$scratch/report-cornell.html" "$root/docs"
