"""A core of `photoncube generate --chains` as a LiteX module:

    from photoncube import Photoncube
    soc.core = Photoncube(soc.platform, "verilog/core-4-leaf-7-local7-rgb6d-n4096")
    soc.bus.add_slave("core", soc.core.bus, SoCRegion(origin=0x9000_0000, size=soc.core.SIZE, cached=False))
    soc.irq.add("core")

Needs LiteX and Migen alone. The streams' fields have the names that the core's *.streams.json gives them.
"""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace

from litex.gen import LiteXModule
from litex.soc.interconnect import stream
from litex.soc.interconnect.axi import AXILiteInterface
from migen import Cat, ClockSignal, Constant, Instance, ResetSignal, Signal


class Photoncube(LiteXModule):
    """The core in a folder of `photoncube generate`.

    - `photons`, `queries`: sinks, endpoints with a leaf or a query; the parameter `chain` names the chain, `last` ends a set
      or a batch.
    - `results`: source; `chain` is that of the query, `last` its `last`, `outside` is 1 where it was outside of its frame.
    - `bus`: AXI-Lite, 32 bits, for the registers. LiteX adapts it to the bus of the SoC.
    - `irq`: 1 while an event that is enabled is set; `ev.irq` is the same for `soc.irq.add`.

    Raises ValueError where the folder has not one core.
    """

    # Bytes of the region for the registers.
    SIZE = 1 << 12

    def __init__(self, platform, folder: str | Path) -> None:
        layout, verilog = read_core(Path(folder))
        platform.add_source(str(verilog))
        chain_bits = max(1, (layout["chains"] - 1).bit_length())
        self.photons = endpoint(layout["photons"], [("chain", chain_bits)])
        self.queries = endpoint(layout["queries"], [("chain", chain_bits)])
        self.results = endpoint(layout["results"], [("chain", chain_bits), ("outside", 1)])
        self.bus = AXILiteInterface(data_width=32, address_width=32)
        self.irq = Signal()
        self.ev = SimpleNamespace(irq=self.irq)
        self.specials += Instance(
            verilog.stem,
            i_aclk=ClockSignal(),
            i_aresetn=~ResetSignal(),
            o_irq=self.irq,
            **self.input_stream("photons", layout),
            **self.input_stream("queries", layout),
            **self.output_stream(layout),
            **bus_ports(self.bus, layout["address_bits"]),
        )

    def input_stream(self, name: str, layout: dict) -> dict:
        """The ports of a stream to the core."""
        sink, word = getattr(self, name), layout[name]
        data = Signal(word["bits"], name=f"{name}_tdata")
        self.comb += data.eq(Cat(*parts(sink, word)))
        return {
            f"i_s_axis_{name}_tdata": data,
            f"i_s_axis_{name}_tvalid": sink.valid,
            f"o_s_axis_{name}_tready": sink.ready,
            f"i_s_axis_{name}_tlast": sink.last,
            f"i_s_axis_{name}_tdest": sink.chain,
        }

    def output_stream(self, layout: dict) -> dict:
        """The ports of the stream from the core."""
        source, word = self.results, layout["results"]
        data = Signal(word["bits"], name="results_tdata")
        for field in word["fields"]:
            self.comb += getattr(source, field["name"]).eq(data[field["low"] : field["low"] + field["width"]])
        return {
            "o_m_axis_results_tdata": data,
            "o_m_axis_results_tvalid": source.valid,
            "i_m_axis_results_tready": source.ready,
            "o_m_axis_results_tlast": source.last,
            "o_m_axis_results_tid": source.chain,
            "o_m_axis_results_tuser": source.outside,
        }


def read_core(folder: Path) -> tuple[dict, Path]:
    """The layout of the words of a core, and its Verilog."""
    layouts = list(folder.glob("*.streams.json"))
    if len(layouts) != 1:
        raise ValueError(
            f"{folder}: found {len(layouts)} files *.streams.json, expected one;"
            " write the core there with `photoncube generate --machine M --chains N`"
        )
    verilog = layouts[0].with_name(layouts[0].name.replace(".streams.json", ".v"))
    layout = json.loads(layouts[0].read_text())
    if not verilog.is_file() or "address_bits" not in layout:
        raise ValueError(f"{layouts[0]}: found no {verilog.name} beside it, or no key `address_bits`; write the core again")
    return layout, verilog


def endpoint(word: dict, parameters: list[tuple[str, int]]) -> stream.Endpoint:
    """An endpoint with the fields of a word."""
    payload = [(field["name"], field["width"]) for field in word["fields"]]
    return stream.Endpoint(stream.EndpointDescription(payload, parameters))


def parts(sink: stream.Endpoint, word: dict) -> list:
    """The bits of a word from the lowest up: the fields, and zeros between them."""
    signals, end = [], 0
    for field in word["fields"]:
        if field["low"] > end:
            signals.append(Constant(0, field["low"] - end))
        signals.append(getattr(sink, field["name"]))
        end = field["low"] + field["width"]
    return signals


def bus_ports(bus: AXILiteInterface, address_bits: int) -> dict:
    """The ports of AXI4-Lite. The core has the lowest bits of an address."""
    ports = {}
    for channel, to_core, fields in (
        ("aw", True, ("addr", "prot")),
        ("w", True, ("data", "strb")),
        ("b", False, ("resp",)),
        ("ar", True, ("addr", "prot")),
        ("r", False, ("resp", "data")),
    ):
        signals = getattr(bus, channel)
        word, ready = ("i", "o") if to_core else ("o", "i")
        ports[f"{word}_s_axi_{channel}valid"] = signals.valid
        ports[f"{ready}_s_axi_{channel}ready"] = signals.ready
        for field in fields:
            signal = getattr(signals, field)
            ports[f"{word}_s_axi_{channel}{field}"] = signal[:address_bits] if field == "addr" else signal
    return ports
