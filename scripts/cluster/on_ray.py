#!/usr/bin/env python3
"""Runs the shards of a photoncube command as tasks of Ray, one for each core, and merges them.

    scripts/cluster/on_ray.py SHARDS FOLDER COMMAND...
    scripts/cluster/on_ray.py 8 out/box progressive cornell --passes 64

FOLDER, which all nodes share, gets the state file of each shard, I-of-SHARDS.state, and at the end merged.state; see
docs/cluster.md. A shard that fails, or whose node does, is tried twice more, and goes on from its state file. Ray takes
the cluster that RAY_ADDRESS names or that it finds, and otherwise the cores of this machine. PHOTONCUBE is the program
(default: photoncube, from the PATH). Exit codes: 0 merged; 1 a shard or the merge failed; 2 bad usage or no Ray.
"""
import os, subprocess, sys


def fail(code, message):
    print(f"on_ray.py: {message}", file=sys.stderr)
    sys.exit(code)


try:
    import ray
except ImportError as error:
    fail(2, f"{error}; `scripts/setup.sh --cluster` installs Ray, and its --where-cluster prints where")
if len(sys.argv) < 4 or not sys.argv[1].isdecimal() or int(sys.argv[1]) < 1:
    fail(2, f"found {sys.argv[1:]}, expected SHARDS FOLDER COMMAND..., as `8 out/box progressive cornell --passes 64`")
program, shards, folder = os.environ.get("PHOTONCUBE", "photoncube"), int(sys.argv[1]), os.path.abspath(sys.argv[2])
states = [f"{folder}/{shard}-of-{shards}.state" for shard in range(1, shards + 1)]
os.makedirs(folder, exist_ok=True)
environment = {"RAYON_NUM_THREADS": "1", **os.environ}
run = ray.remote(max_retries=2, retry_exceptions=True)(subprocess.check_call)
try:
    ray.init(logging_level="warning")
    ray.get([run.remote([program, *sys.argv[3:], "--shard", f"{shard}/{shards}", "--state", state], cwd=os.getcwd(), env=environment)
             for shard, state in enumerate(states, 1)])
    subprocess.check_call([program, "merge", *states, "-o", f"{folder}/merged.state"])
except (ray.exceptions.RayError, subprocess.CalledProcessError, OSError) as error:
    fail(1, f"a shard or the merge failed: {error}; the same command goes on from the state files in {folder}")
