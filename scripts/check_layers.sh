#!/usr/bin/env bash
# The direction of dependencies (ARCHITECTURE.md): which package of the workspace may see which, and
# that crates/hdl and crates/rust-hdl-lint alone see rust-hdl. Reads the manifests through `cargo metadata`, so a renamed, an
# optional, a build- or a target-dependency counts like any other.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if (($# > 0)); then
    printf 'Usage: scripts/check_layers.sh\nExit codes: 0 the direction holds; 1 it does not; 2 bad usage or a missing tool.\n'
    [[ $1 == -h || $1 == --help ]] && exit 0
    exit 2
fi
command -v python3 >/dev/null || {
    echo "layers: no python3 on the PATH; scripts/setup.sh installs it" >&2
    exit 2
}

metadata=$(cargo metadata --format-version 1 --no-deps) || exit 2
METADATA=$metadata exec python3 - <<'PYTHON'
import json
import os
import re
import sys
from pathlib import Path

# The folder, the package, what it may depend on, and what its tests may depend on besides.
LAYERS = [
    ("crates/rust-hdl-lint", "rust-hdl-lint", "", ""),
    ("crates/verilog-eval", "verilog-eval", "", ""),
    # No code: the features that all builds share. The tests of every other package depend on it.
    ("crates/workspace-features", "workspace-features", "", ""),
    # Its version 0.11, from outside.
    ("crates/svg", "svg", "svg", ""),
    ("crates/fpga-flow", "fpga-flow", "verilog-eval", ""),
    ("crates/spec", "photoncube-spec", "", ""),
    ("crates/model", "photoncube-model", "spec", ""),
    ("crates/hdl", "photoncube-hdl", "spec rust-hdl-lint verilog-eval", ""),
    ("crates/render", "photoncube-render", "spec model", ""),
    ("crates/driver", "photoncube-driver", "spec model render", ""),
    ("crates/hard-cases", "photoncube-hard-cases", "spec model render", ""),
    ("testbenches", "photoncube-testbench", "spec model hdl verilog-eval fpga-flow", "render driver hard-cases"),
    ("benches", "photoncube-benches", "", "spec model render"),
    ("crates/cli", "photoncube", "spec model hdl render driver hard-cases testbench fpga-flow", "verilog-eval"),
]
GENERATOR = re.compile(r"rust-hdl(-(?!lint$).+)?")
GENERATOR_SEEN_BY = ["photoncube-hdl", "rust-hdl-lint"]
GENERATOR_VERSION = "=0.46.0"
# Rust sources outside those: the word, comments and quoted text apart.
IN_SOURCE = re.compile(r"\brust_hdl(_(core|hls|macros|sim|widgets))?\b")
NOT_CODE = re.compile(
    r"""//[^\n]*|/\*.*?\*/|\br(?P<hashes>\#*)".*?"(?P=hashes)|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\\n])'""",
    re.DOTALL,
)

metadata = json.loads(os.environ["METADATA"])
root = Path(metadata["workspace_root"])
packages = {package["name"]: package for package in metadata["packages"]}
layers = {name: (folder, allowed.split(), tests.split()) for folder, name, allowed, tests in LAYERS}
faults = []


def short(name):
    return name.removeprefix("photoncube-")


def fault(where, found, expected):
    faults.append(f"{where}: found {found}; expected {expected}")


for name in sorted(set(packages) | set(layers)):
    if name not in layers:
        fault("workspace", f"package {name}", "only packages that scripts/check_layers.sh has a row for")
        continue
    folder, allowed, tests = layers[name]
    manifest = f"{folder}/Cargo.toml"
    if name not in packages:
        fault("workspace", f"no package {name}", f"it in {folder}")
        continue
    package = packages[name]
    at = Path(package["manifest_path"]).relative_to(root).as_posix()
    if at != manifest:
        fault(name, at, manifest)
    for dependency in package["dependencies"]:
        other = dependency["name"]
        kind = dependency["kind"] or "normal"
        if GENERATOR.fullmatch(other):
            if name not in GENERATOR_SEEN_BY:
                fault(manifest, f"a {kind} dependency on {other}", "rust-hdl in crates/hdl and crates/rust-hdl-lint alone")
            elif other == "rust-hdl" and dependency["req"] != GENERATOR_VERSION:
                fault(manifest, f'rust-hdl = "{dependency["req"]}"', f'"{GENERATOR_VERSION}"')
        elif other in packages:
            may = allowed + ([*tests, "workspace-features"] if kind == "dev" else [])
            if short(other) not in may:
                fault(manifest, f"a {kind} dependency on {other}", f"none but on {', '.join(may) or 'nothing of ours'}")

binaries = sorted(
    f"{package['name']}/{target['name']}"
    for package in packages.values()
    for target in package["targets"]
    if "bin" in target["kind"]
)
if binaries != ["photoncube/photoncube"]:
    fault("workspace", f"the binaries {', '.join(binaries) or '(none)'}", "photoncube alone")

sources = 0
for folder, name, _, _ in LAYERS:
    if name in GENERATOR_SEEN_BY:
        continue
    for source in sorted((root / folder).rglob("*.rs")):
        sources += 1
        code = NOT_CODE.sub(lambda match: "\n" * match.group().count("\n"), source.read_text(encoding="utf-8"))
        for number, line in enumerate(code.splitlines(), 1):
            word = IN_SOURCE.search(line)
            if word:
                where = f"{source.relative_to(root).as_posix()}:{number}"
                fault(where, f"the name {word.group()}", "it in crates/hdl and crates/rust-hdl-lint alone")
if sources == 0:
    fault("workspace", "no Rust source to look at", "some")

for line in faults:
    print(f"layers: {line}", file=sys.stderr)
if faults:
    sys.exit(1)
print(f"layers: the direction holds ({len(packages)} packages, {sources} sources without rust-hdl)")
PYTHON
