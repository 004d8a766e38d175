#!/usr/bin/env bash
# Runs the shards of a photoncube command as a job array of Slurm, then a job that merges them, and waits for both.
#
#   scripts/cluster/slurm.sh SHARDS FOLDER COMMAND...
#   scripts/cluster/slurm.sh 8 out/box progressive cornell --passes 64
#
# FOLDER, which all nodes share, gets the state file of each shard, I-of-SHARDS.state, its output, I-of-SHARDS.log,
# and at the end merged.state; see docs/cluster.md. Slurm queues a shard again whose node fails; a shard that fails
# itself cancels the merge. sbatch reads its options from SBATCH_PARTITION, SBATCH_TIMELIMIT and the like.
# PHOTONCUBE is the program on the nodes (default: photoncube, from the PATH).
# Exit codes: 0 merged; 1 a shard or the merge failed; 2 bad usage or no Slurm.
#SBATCH --job-name=photoncube
#SBATCH --requeue
#SBATCH --open-mode=append
set -euo pipefail

fail() {
    printf 'slurm.sh: %s\n' "${*:2}" >&2
    exit "$1"
}

[[ $# -ge 3 && $1 =~ ^[1-9][0-9]*$ ]] ||
    fail 2 "found \`$*\`, expected SHARDS FOLDER COMMAND..., as \`8 out/box progressive cornell --passes 64\`"
program=${PHOTONCUBE:-photoncube} shards=$1 folder=$2 shard=${SLURM_ARRAY_TASK_ID:-}
shift 2
# This very script is the job of each shard.
[[ -z $shard ]] || exec env RAYON_NUM_THREADS="${RAYON_NUM_THREADS:-${SLURM_CPUS_PER_TASK:-1}}" \
    "$program" "$@" --shard "$shard/$shards" --state "$folder/$shard-of-$shards.state"
command -v sbatch >/dev/null || fail 2 "found no sbatch on the PATH; \`scripts/setup.sh --cluster\` installs Slurm on Debian"
mkdir -p -- "$folder"

array=$(sbatch --parsable --array="1-$shards" --output="$folder/%a-of-$shards.log" "$0" "$shards" "$folder" "$@") ||
    fail 1 "sbatch did not take the shards, see above"
merge=$(printf '%q merge %q/*-of-%q.state -o %q' "$program" "$folder" "$shards" "$folder/merged.state")
job=$(sbatch --parsable --wait --dependency="afterok:${array%%;*}" --kill-on-invalid-dep=yes \
    --output="$folder/merge.log" --wrap="$merge") || true
# sbatch ends with 0 when the job for which it waits is cancelled, so its state counts.
[[ $(scontrol show job "${job%%;*}") == *JobState=COMPLETED* ]] ||
    fail 1 "the shards, job $array, or their merge failed: see $folder/*.log; the same command goes on from the state files"
