#!/usr/bin/env python3
"""Runs the shards of a photoncube command as tasks of HyperQueue, one for each core, and merges them.

    scripts/cluster/on_hyperqueue.py SHARDS FOLDER COMMAND...
    scripts/cluster/on_hyperqueue.py 8 out/box progressive cornell --passes 64

FOLDER, which all nodes share, gets each shard's state file I-of-SHARDS.state and output I-of-SHARDS.log, and at the end
merged.state; see docs/cluster.md. HyperQueue runs a shard again whose worker is lost; a shard that fails itself ends the job.
HQ_SERVER_DIR is the folder of a running `hq server` of the wheel's version; without it the workers are on this machine, one
for each core and at least two. PHOTONCUBE is the program (default: photoncube, from the PATH).
Exit codes: 0 merged; 1 a shard or the merge failed; 2 bad usage or no HyperQueue."""
import os, subprocess, sys


def fail(code, message):
    print(f"on_hyperqueue.py: {message}", file=sys.stderr)
    sys.exit(code)


try:
    import hyperqueue as hq
except ImportError as error:
    fail(2, f"{error}; `scripts/setup.sh --cluster` installs HyperQueue, and its --where-cluster prints where")
if len(sys.argv) < 4 or not sys.argv[1].isdecimal() or int(sys.argv[1]) < 1:
    fail(2, f"found {sys.argv[1:]}, expected SHARDS FOLDER COMMAND..., as `8 out/box progressive cornell --passes 64`")
program, shards, folder = os.environ.get("PHOTONCUBE", "photoncube"), int(sys.argv[1]), os.path.abspath(sys.argv[2])
os.makedirs(folder, exist_ok=True)
names, job = [f"{folder}/{i}-of-{shards}" for i in range(1, shards + 1)], hq.Job(default_workdir=os.getcwd())
for shard, name in enumerate(names, 1):
    job.program([program, *sys.argv[3:], "--shard", f"{shard}/{shards}", "--state", f"{name}.state"],
                env={"RAYON_NUM_THREADS": "1", **os.environ}, stdout=f"{name}.log", stderr=f"{name}.log", name=f"shard {shard}")
try:
    local = hq.LocalCluster() if "HQ_SERVER_DIR" not in os.environ else None
    for _ in range(max(2, os.cpu_count() or 1) if local else 0):
        local.start_worker(hq.cluster.WorkerConfig(cores=1))
    client = local.client() if local else hq.Client(os.environ["HQ_SERVER_DIR"])
    client.wait_for_jobs([client.submit(job)])
    subprocess.check_call([program, "merge", *(f"{name}.state" for name in names), "-o", f"{folder}/merged.state"])
except Exception as error:  # HyperQueue's own errors have no type of their own.
    fail(1, f"a shard or the merge failed: {error}; the same command goes on from the state files in {folder}")
