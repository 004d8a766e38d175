#!/usr/bin/env bash
# Runs a small command on each engine of scripts/cluster/, with two workers on this machine, and compares what they make.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)

readonly ENGINES=(parallel slurm snakemake ray hyperqueue)

usage() {
    cat <<USAGE
Usage: scripts/cluster/check.sh [ENGINE...]

Runs a picture in 7 shards on each engine (default: ${ENGINES[*]}), on this machine. The merged file must be that of one shard, byte
for byte. The first two shards wait for each other, so a single worker fails. The second shard is killed once: the engine runs it
again, or its file fails, and goes on when it runs again. A shard whose state file is of other work must fail. GNU parallel and
HyperQueue, this one by a server that runs already, also share out a sweep. Slurm is one node, controller and all, on the loopback
address and for this run alone. PHOTONCUBE is the program (default: the debug build). scripts/setup.sh --cluster installs the engines.

Exit codes: 0 all holds; 1 something does not; 2 bad usage or a missing tool.
USAGE
}

note() { printf 'cluster: %s\n' "$*" >&2; }
fail() {
    note "${@:2}"
    exit "$1"
}

engines=("$@")
((${#engines[@]})) || engines=("${ENGINES[@]}")
for engine in "${engines[@]}"; do
    case $engine in
        parallel | slurm | snakemake | ray | hyperqueue) ;;
        -h | --help)
            usage
            exit 0
            ;;
        *) fail 2 "found \`$engine\`, expected one of: ${ENGINES[*]}" ;;
    esac
done

real=${PHOTONCUBE:-${CARGO_TARGET_DIR:-$root/target}/debug/photoncube}
[[ -x $real ]] || fail 2 "found no program $real; build it with cargo, or set PHOTONCUBE"
real=$(realpath -- "$real")
unset PHOTONCUBE RAYON_NUM_THREADS RAY_ADDRESS HQ_SERVER_DIR SLURM_CONF
PATH=$("$root/scripts/setup.sh" --where-cluster):$PATH
(($(nproc) >= 2)) || fail 2 "found 1 core, expected two for two workers"
for file in parallel.sh slurm.sh Snakefile on_ray.py on_hyperqueue.py; do
    lines=$(wc -l <"$here/$file")
    ((lines <= 40)) || fail 1 "scripts/cluster/$file: found $lines lines, expected at most 40: it is to be read and copied"
done

scratch=$(mktemp -d)
# Ray's cluster has a password of this run alone, sends nothing to Ray's makers, and leaves nothing in the home folder.
RAY_AUTH_TOKEN=$(od -An -N32 -tx1 /dev/urandom | tr -d ' \n')
export RAY_ADDRESS=local RAY_USAGE_STATS_ENABLED=0 RAY_AUTH_TOKEN TMPDIR=$scratch/tmp RAY_TMPDIR=$scratch/tmp
mkdir "$TMPDIR"
daemons=()
clean_up() {
    local code=$? daemon
    rm -f "$scratch/server/ready"
    for daemon in "${daemons[@]}"; do kill "$daemon" 2>/dev/null || true; done
    wait
    rm -rf "$scratch"
    exit "$code"
}
trap clean_up EXIT
cd "$scratch"

version_of() {
    case $1 in
        parallel) parallel --version | sed -n '1s/^GNU //p' ;;
        slurm) sbatch --version ;;
        *) python3 -c 'import importlib.metadata as m, sys; print(sys.argv[1], m.version(sys.argv[1]))' "$1" ;;
    esac
}

# Runs a command's words on an engine: ENGINE SHARDS FOLDER COMMAND...
run_on() {
    case $1 in
        parallel | slurm) "$here/$1.sh" "${@:2}" ;;
        ray | hyperqueue) "$here/on_$1.py" "${@:2}" ;;
        snakemake) snakemake -s "$here/Snakefile" --cores 2 --config shards="$2" folder="$3" command="${*:4}" ;;
    esac
}

# A file that a user would find as `photoncube`, for the run in the folder $1: its first two shards wait for each other, and its
# second one is killed after that, once.
make_program() {
    mkdir -p "$1/bin"
    cat >"$1/bin/photoncube" <<PROGRAM
#!/usr/bin/env bash
meet() {
    if [[ \${RAYON_NUM_THREADS:-} != 1 ]]; then
        echo "found RAYON_NUM_THREADS=\${RAYON_NUM_THREADS:-}, expected 1: there is a shard for each core" >&2
        exit 1
    fi
    : >"$1/begun-\$1"
    for ((tenths = 0; tenths < 300; tenths++)); do
        [[ -e $1/begun-\$2 ]] && return
        sleep 0.1
    done
    echo "shard \$2 did not begin within 30 s while shard \$1 ran: expected two workers" >&2
    exit 1
}
case " \$* " in
    *" --shard 1/7 "*) meet 1 2 ;;
    *" --shard 2/7 "*)
        meet 2 1
        mkdir "$1/killed" 2>/dev/null && kill -KILL \$\$
        ;;
esac
exec "$real" "\$@"
PROGRAM
    chmod +x "$1/bin/photoncube"
}

# One node with two processors. Nothing but this machine reaches it, so nobody has to say who he is.
start_slurm() {
    local folder=$scratch/slurm-node name ports
    for name in sbatch slurmctld slurmd; do
        command -v "$name" >/dev/null || fail 2 "found no $name; \`scripts/setup.sh --cluster\` installs Slurm"
    done
    name=$(hostname -s)
    # Two that are free, so that two of these runs do not meet.
    read -ra ports < <(python3 -c 'import socket
sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(2)]
print(*(each.getsockname()[1] for each in sockets))')
    mkdir -p "$folder/state" "$folder/spool"
    export SLURM_CONF=$folder/slurm.conf
    cat >"$SLURM_CONF" <<CONF
ClusterName=check
SlurmctldHost=$name(127.0.0.1)
SlurmctldPort=${ports[0]}
SlurmdPort=${ports[1]}
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
AuthType=auth/none
CredType=cred/none
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1
MpiDefault=none
NodeName=$name NodeAddr=127.0.0.1 CPUs=2
PartitionName=all Nodes=ALL Default=YES
CONF
    slurmctld -D >"$folder/slurmctld.log" 2>&1 &
    daemons+=($!)
    slurmd -D >"$folder/slurmd.log" 2>&1 &
    daemons+=($!)
    local tenths
    for ((tenths = 0; tenths < 300; tenths++)); do
        [[ $(sinfo --noheader --format=%T 2>/dev/null) == idle ]] && return
        sleep 0.1
    done
    tail -n 20 "$folder"/*.log >&2
    fail 1 "Slurm's node was not idle within 30 s, see above"
}

# A server as on a cluster, with two workers, which the file of HyperQueue does not start itself.
start_hyperqueue() {
    # SIGTERM does not end it; without the file it ends itself.
    python3 -c 'import hyperqueue.cluster as c, os, sys, time
with c.LocalCluster(sys.argv[1]) as local:
    local.start_worker(c.WorkerConfig(cores=1))
    local.start_worker(c.WorkerConfig(cores=1))
    ready = sys.argv[1] + "/ready"
    open(ready, "w").close()
    for _ in range(6000):
        if not os.path.exists(ready): break
        time.sleep(0.1)' "$1" >"$1.log" 2>&1 &
    local tenths
    for ((tenths = 0; tenths < 300; tenths++)); do
        [[ -e $1/ready ]] && return
        sleep 0.1
    done
    cat "$1.log" >&2
    fail 1 "HyperQueue's server did not start within 30 s, see above"
}

# What one shard of the command $2... makes, merged: the file $1.
one_shard() {
    "$real" "${@:2}" --shard 1/1 --state "$1.one" >/dev/null
    "$real" merge "$1.one" -o "$1" >/dev/null
}

# Holds the merged file of the folder $1 to the file $2.
must_equal() {
    [[ -s $1/merged.state ]] || fail 1 "$1: found no merged.state"
    cmp "$1/merged.state" "$2" || fail 1 "$1: merged.state differs from that of one shard"
}

readonly PICTURE=(progressive ring --passes 7 --size 8x8 --photons 500 --samples 1)
readonly SWEEP=(report --sweep ring --in-range 20 --maps 3 --photons 500)

one_shard picture "${PICTURE[@]}"
one_shard other "${PICTURE[@]}" --seed 2
if cmp --silent picture other; then fail 1 "pictures of two seeds are equal, so the comparison says nothing"; fi

# Ends the check of an engine, after what the engine said.
fail_with_log() {
    cat "$engine.log" "$engine"/*/*.log >&2 2>/dev/null || true
    fail 1 "$engine: $*"
}

for engine in "${engines[@]}"; do
    if [[ $engine == slurm ]]; then start_slurm; fi
    version=$(version_of "$engine") || fail 2 "found no $engine; \`scripts/setup.sh --cluster\` installs it"
    start=$SECONDS

    # Two workers, one of which is killed.
    make_program "$scratch/$engine"
    case $engine in slurm | hyperqueue) retries=0 ;; *) retries=1 ;; esac
    code=0
    PATH=$scratch/$engine/bin:$PATH run_on "$engine" 7 "$engine/box" "${PICTURE[@]}" >"$engine.log" 2>&1 || code=$?
    [[ -e $engine/killed ]] || fail_with_log "no shard was killed"
    if ((retries)); then
        ((code == 0)) || fail_with_log "found exit code $code, expected that the killed shard runs again"
        again="ran again"
    else
        ((code == 1)) || fail_with_log "found exit code $code with a killed shard, expected 1"
        [[ ! -e $engine/box/merged.state ]] || fail_with_log "found a merged.state although a shard was killed"
        PATH=$scratch/$engine/bin:$PATH run_on "$engine" 7 "$engine/box" "${PICTURE[@]}" >"$engine.log" 2>&1 ||
            fail_with_log "the second run, after a killed shard, failed"
        again="ended the run, and a second run went on"
    fi
    must_equal "$engine/box" picture

    # A shard that cannot be done.
    mkdir -p "$engine/planted"
    "$real" "${PICTURE[@]}" --seed 2 --shard 3/7 --state "$engine/planted/3-of-7.state" >/dev/null
    code=0
    PHOTONCUBE=$real run_on "$engine" 7 "$engine/planted" "${PICTURE[@]}" >"$engine.log" 2>&1 || code=$?
    ((code == 1)) || fail_with_log "found exit code $code with a state of other work, expected 1"
    grep -qs "the state is that of other work" "$engine.log" "$engine"/planted/*.log ||
        fail_with_log "the run failed, and not because of the planted state"
    [[ ! -e $engine/planted/merged.state ]] || fail_with_log "found a merged.state although a shard failed"

    printf 'cluster: %s: 7 shards of progressive, two at a time, make the file of one shard (%d bytes);\n' \
        "$version" "$(stat -c %s "$engine/box/merged.state")"
    printf '         one that was killed %s; one with the state of other work failed (%d s)\n' "$again" $((SECONDS - start))

    if [[ $engine == parallel || $engine == hyperqueue ]]; then
        [[ -e sweep ]] || one_shard sweep "${SWEEP[@]}"
        server=
        if [[ $engine == hyperqueue ]]; then
            start_hyperqueue "$scratch/server"
            server=$scratch/server
        fi
        (
            [[ -z $server ]] || export HQ_SERVER_DIR=$server
            PHOTONCUBE=$real run_on "$engine" 3 "$engine/sweep" "${SWEEP[@]}" >"$engine.log" 2>&1
        ) || fail_with_log "the sweep failed"
        must_equal "$engine/sweep" sweep
        printf 'cluster: %s: 3 shards of report --sweep, %d rows, make the file of one shard\n' \
            "$version" $(($(wc -l <"$engine/sweep/merged.state") - 1))
    fi
done
