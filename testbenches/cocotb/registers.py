"""The registers of a core as its SystemRDL says them, read by systemrdl-compiler."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from systemrdl import RDLCompiler
from systemrdl.node import RegNode
from systemrdl.rdltypes import OnWriteType


@dataclass(frozen=True)
class Register:
    """A register: masks of the bits that are read, that are written, and that a written 1 clears, and its value after
    `aresetn`. A field without a value after reset shows the state of the core, which is then 0."""

    name: str
    address: int
    readable: int
    writable: int
    cleared_by_one: int
    reset: int


def register_of(node: RegNode) -> Register:
    """The register of a node of the compiled SystemRDL."""
    readable = writable = cleared = reset = 0
    for field in node.fields():
        mask = ((1 << field.width) - 1) << field.low
        readable |= mask if field.is_sw_readable else 0
        writable |= mask if field.is_sw_writable else 0
        cleared |= mask if field.get_property("onwrite") == OnWriteType.woclr else 0
        reset |= (field.get_property("reset") or 0) << field.low
    return Register(node.inst_name, node.absolute_address, readable, writable, cleared, reset)


def read_registers(path: Path) -> dict[str, Register]:
    """All registers of a file, by name."""
    compiler = RDLCompiler()
    compiler.compile_file(str(path))
    nodes = compiler.elaborate().top.descendants()
    registers = [register_of(node) for node in nodes if isinstance(node, RegNode)]
    assert registers, f"found no register in {path}"
    return {register.name: register for register in registers}
