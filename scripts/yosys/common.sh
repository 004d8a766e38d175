# What the scripts beside this have in common; to be sourced, after `usage` is defined.

# Stops at what is asked of the script but files: -h and --help print the usage, no other option is known.
read_options() {
    case ${1-} in
        -h | --help)
            usage
            exit 0
            ;;
        -*)
            usage >&2
            exit 2
            ;;
    esac
}

# Stops where one of the tools is missing.
need() {
    local tool
    for tool in "$@"; do
        command -v "$tool" >/dev/null || {
            echo "$(basename "$0" .sh): no $tool on the PATH; scripts/setup.sh installs it" >&2
            exit 2
        }
    done
}

# The Yosys that proves and measures: the one of pinned version, or the distribution's where that is missing.
prover=$("$(dirname "${BASH_SOURCE[0]}")/../setup.sh" --where 2>/dev/null)/yosys || prover=yosys

# Runs the Yosys commands $2 in the folder $1, which has their files.
yosys_in() {
    (cd "$1" && "$prover" -q -p "$2")
}
