"""Holds the Python model that PeakRDL made of a core's SystemRDL to the addresses that the core has:
`python registers.py STREAMS.json DIR`, with DIR the folder that registers.sh wrote."""

from __future__ import annotations

import importlib
import json
import sys
from pathlib import Path


def main() -> int:
    """Reads each register of the model and looks which address that asks for."""
    layout = json.loads(Path(sys.argv[1]).read_text())
    name = "photoncube_" + layout["core"].replace("-", "_")
    sys.path.insert(0, str(Path(sys.argv[2]) / "python"))
    callbacks = importlib.import_module(f"{name}.lib").NormalCallbackSet
    model_class = getattr(importlib.import_module(f"{name}.reg_model.{name}"), f"{name}_cls")
    asked: list[int] = []

    def read(addr: int, width: int, accesswidth: int) -> int:
        """Answers a read of the model."""
        assert width == accesswidth == 32
        asked.append(addr)
        return addr ^ 0x5A5A

    model = model_class(callbacks=callbacks(read_callback=read))
    registers = {register.inst_name: register for register in model.get_readable_registers()}
    # `control` has only fields that are written.
    missing = layout["registers"].keys() - registers.keys()
    assert missing == {"control"}, f"the model lacks {sorted(missing)}"
    for register, address in layout["registers"].items():
        if register in missing:
            continue
        value = registers[register].read()
        assert (asked.pop(), value) == (address, address ^ 0x5A5A), f"{register} is not at {address:#x} in the model"
    print(f"registers: {len(registers)} registers of the Python model are where the core has them")
    return 0


if __name__ == "__main__":
    sys.exit(main())
