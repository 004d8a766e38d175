#!/usr/bin/env bash
# Compiles a machine's Quartus project. NOT TESTED: Quartus is not free to install here, so this
# script has run only as far as its error messages. The Verilog and the project are committed plain
# text; if the flow fails for you, that is a fault worth reporting.
set -euo pipefail

usage() {
    cat <<'USAGE'
Usage: scripts/quartus/build.sh MACHINE

Runs Quartus (analysis, fit, timing) on a copy of hdl-out/MACHINE; the reports are in
target/quartus/MACHINE. Needs quartus_sh on the PATH; not tested, as no free Quartus was at hand.

Exit codes: 0 compiled; 2 bad usage or something is missing; any other is Quartus's own.
USAGE
}

missing() {
    printf 'quartus: found no %s, expected %s\n' "$1" "$2" >&2
    exit 2
}

case ${1-} in
    -h | --help)
        usage
        exit 0
        ;;
    '' | -* | *[!a-z0-9-]*)
        usage >&2
        exit 2
        ;;
esac
(($# == 1)) || {
    usage >&2
    exit 2
}

machine=$1
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
command -v quartus_sh >/dev/null || missing "quartus_sh on the PATH" "Quartus Prime's bin folder there"
[[ -d hdl-out/$machine ]] ||
    missing "hdl-out/$machine" "one of: $(cd hdl-out && echo *) (\`cargo run --release -- generate\` writes them)"
shopt -s nullglob
projects=("hdl-out/$machine"/*.qpf)
((${#projects[@]} == 1)) || missing "single .qpf in hdl-out/$machine (${#projects[@]} there)" "exactly one project"

# Quartus writes all over its project's folder: keep it out of what is committed.
build=target/quartus/$machine
rm -rf -- "$build"
mkdir -p -- "$build"
cp -- "hdl-out/$machine"/* "$build/"
cd "$build"
exec quartus_sh --flow compile "$(basename "${projects[0]}" .qpf)"
