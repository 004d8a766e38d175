"""What synth.sh and place.sh share: which machines there are, and the file that their figures go to."""

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

# The project file's word on ABC9: it spends area on speed only where a path is longer. Without it the
# design with DSP blocks takes three times the LUTs.
ABC9_TARGET = re.compile(r"^scratchpad -set abc9\.D (\d+)$", re.MULTILINE)


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


@dataclass(frozen=True)
class Figures:
    """The figures that one script measures of the machines in hdl-out."""

    name: str
    command: str
    result: Path

    def say(self, message):
        print(f"{self.name}: {message}", file=sys.stderr)

    def stop(self, code, message):
        self.say(message)
        sys.exit(code)

    def inputs(self, names):
        """The Verilog of the machines of these names; of all machines for none."""
        found = {}
        for path in sorted(Path("hdl-out").glob("*/*.v")):
            if path.parent.name in found:
                self.stop(2, f"found a second file {path.as_posix()}, expected one for each machine")
            found[path.parent.name] = path
        for name in names:
            if name not in found:
                self.stop(2, f"found no hdl-out/{name}/*.v, expected one of: {', '.join(found) or '(none)'}")
        if not found:
            self.stop(2, "found no hdl-out/*/*.v; write them with `cargo run --release -- generate`")
        return {name: found[name] for name in sorted(names or found)}

    def abc9_target_ps(self, path):
        """The target that the machine's Yosys script sets."""
        script = path.with_suffix(".ys")
        found = ABC9_TARGET.search(script.read_text() if script.exists() else "")
        if not found:
            self.stop(2, f"found no `scratchpad -set abc9.D` in {script.as_posix()}; write it with `photoncube generate`")
        return int(found.group(1))

    def check(self):
        """Whether the committed figures are about the committed Verilog."""
        paths = self.inputs([])
        if not self.result.exists():
            self.stop(1, f"found no {self.result}; write it with {self.command}")
        written = json.loads(self.result.read_text()).get("verilog_sha256", {})
        stale = [name for name in sorted(paths.keys() | written.keys())
                 if name not in paths or written.get(name) != digest(paths[name])]
        if stale:
            self.stop(1, f"found {self.result} about other Verilog than hdl-out has for {', '.join(stale)}; "
                      f"write it anew with {self.command}")
        print(f"{self.name}: {self.result} is about the committed Verilog ({len(paths)} machines)")

    def write(self, result):
        self.result.parent.mkdir(parents=True, exist_ok=True)
        prefix = f".{self.result.stem}-"
        with tempfile.NamedTemporaryFile("w", dir=self.result.parent, prefix=prefix, delete=False) as beside:
            try:
                json.dump(result, beside, indent=2)
                beside.write("\n")
                beside.flush()
                os.fchmod(beside.fileno(), 0o644)
                os.replace(beside.name, self.result)
            except BaseException:
                os.unlink(beside.name)
                raise
        self.say(f"wrote {self.result}")


@contextmanager
def scratch_folder(prefix):
    """A folder in the project, where the sandboxed tools can write; gone at the end."""
    Path("target").mkdir(exist_ok=True)
    folder = Path(tempfile.mkdtemp(prefix=prefix, dir="target"))
    try:
        yield folder
    finally:
        shutil.rmtree(folder)


def run(command, doing):
    """What the tool says; when it fails that is the error."""
    done = subprocess.run(command, capture_output=True, text=True)
    said = done.stdout + done.stderr
    if done.returncode != 0:
        raise ValueError(f"{doing}:\n{said[-2000:]}")
    return said


def yosys_version(yosys):
    # Not what follows: the folders and compilers of whoever built it.
    said = run([yosys, "-V"], "yosys does not say its version")
    return re.search(r"Yosys (\S+ \(git sha1 \w+)", said).group(1) + ")"


def package_version(tools, package):
    code = f"from importlib.metadata import version; print(version('{package}'))"
    return run([f"{tools}/python", "-c", code], f"found no package {package}").strip()


def show(rows):
    columns = list(rows[0])
    cells = [columns] + [[str(row[column]) for column in columns] for row in rows]
    widths = [max(len(line[at]) for line in cells) for at in range(len(columns))]
    for line in cells:
        print("  ".join(f"{cell:<{width}}" for cell, width in zip(line, widths)).rstrip())
