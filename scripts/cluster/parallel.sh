#!/usr/bin/env bash
# Runs the shards of a photoncube command by GNU parallel, as many at a time as there are cores, and merges them.
#
#   scripts/cluster/parallel.sh SHARDS FOLDER COMMAND...
#   scripts/cluster/parallel.sh 8 out/box progressive cornell --passes 64
#
# FOLDER gets the state file of each shard, I-of-SHARDS.state, and at the end merged.state; see docs/cluster.md.
# A shard that fails is tried twice more, and goes on from its state file. When it fails again, no further shard begins.
# GNU parallel reads options from the variable PARALLEL: `-j 4`, or `--sshloginfile nodes --workdir .` for other machines.
# PHOTONCUBE is the program (default: photoncube, from the PATH).
# Exit codes: 0 merged; 1 a shard or the merge failed; 2 bad usage or no GNU parallel.
set -euo pipefail

fail() {
    printf 'parallel.sh: %s\n' "${*:2}" >&2
    exit "$1"
}

[[ $# -ge 3 && $1 =~ ^[1-9][0-9]*$ ]] ||
    fail 2 "found \`$*\`, expected SHARDS FOLDER COMMAND..., as \`8 out/box progressive cornell --passes 64\`"
[[ $(parallel --version 2>/dev/null) == "GNU parallel"* ]] ||
    fail 2 "found no GNU parallel on the PATH; \`scripts/setup.sh --cluster\` installs it on Debian"
program=${PHOTONCUBE:-photoncube} shards=$1 folder=$2
shift 2
mkdir -p -- "$folder"

seq "$shards" | parallel --quote --retries 3 --halt soon,fail=1 \
    env RAYON_NUM_THREADS="${RAYON_NUM_THREADS:-1}" "$program" "$@" --shard "{}/$shards" --state "$folder/{}-of-$shards.state" ||
    fail 1 "a shard failed, see above; the same command goes on from the state files in $folder"
"$program" merge "$folder"/*-of-"$shards".state -o "$folder/merged.state" || fail 1 "the merge failed, see above"
