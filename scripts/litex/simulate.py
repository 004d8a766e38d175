"""Simulates a core in a LiteX SoC without a CPU: `python simulate.py --core DIR --build DIR [--seed N]`.

Players push a set of photons and a batch of queries for each chain through the core's endpoints; a master on the SoC's Wishbone bus
then reads registers. Icarus runs the Verilog that LiteX makes, and each result, counter and the interrupt is compared with the
reference of testbenches/cocotb. Ends 0 where all are equal, 1 where one differs, 2 on bad usage.
"""

from __future__ import annotations

import argparse
import logging
import re
import subprocess
import sys
from pathlib import Path
from random import Random

from litex.build.generic_platform import Pins
from litex.build.sim.platform import SimPlatform
from litex.gen import LiteXModule
from litex.soc.integration.soc import SoCRegion
from litex.soc.integration.soc_core import SoCMini
from litex.soc.interconnect import stream, wishbone
from migen import FSM, Array, Cat, ClockDomain, Constant, Display, Finish, If, Memory, Module, NextState, NextValue, Signal

from photoncube import Photoncube

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "testbenches" / "cocotb"))

from reference import Beat, Reference, Result  # noqa: E402
from shape import Shape, Word, read_shape  # noqa: E402
from traffic import Sizes, Traffic  # noqa: E402

ORIGIN = 0x9000_0000
ENABLE = "interrupt_enable"
# The registers that are read when all results are there, and what each must be.
COUNTERS = ("leaves_read", "queries_read", "results", "photons_in_range", "leaves_compared", "leaves_wanted", "groups_played")
IDENTITY = int.from_bytes(b"PCUB", "big")
# Clocks and seconds after which the simulation gives up.
MOST_CLOCKS = 4000
MOST_SECONDS = 300
BENCH = """\
module bench;
    reg clock = 0, reset = 1;
    always #5 clock = ~clock;
    initial begin #100 reset = 0; #@TIME@ $display("late"); $finish; end
    soc soc(.sys_clk(clock), .sys_rst(reset));
endmodule
"""


class Player(Module):
    """Gives words to a sink, one after the other. Between them it rests for some clocks. It is no LiteXModule, of which LiteX would put the
    memory on the bus."""

    def __init__(self, sink: stream.Endpoint, word: Word, beats: list[Beat]) -> None:
        signals = [getattr(sink, name) for name in word.fields] + [sink.chain, sink.last]
        values = [pack(word, beat, len(sink.chain)) for beat in beats]
        # A word more, which is on the pins behind the last.
        self.specials.memory = memory = Memory(len(Cat(*signals)), len(values) + 1, init=[*values, 0])
        port = memory.get_port(async_read=True)
        self.specials += port
        place, rest = Signal(max=len(values) + 1), Signal(2)
        self.comb += [
            port.adr.eq(place),
            Cat(*signals).eq(port.dat_r),
            sink.valid.eq((place != len(values)) & (rest == 0)),
        ]
        self.sync += [
            If(rest != 0, rest.eq(rest - 1)),
            If(sink.valid & sink.ready, place.eq(place + 1), rest.eq(place)),
        ]


def pack(word: Word, beat: Beat, chain_bits: int) -> int:
    """The fields of a word side by side, then the chain and `last`."""
    packed, bits = 0, 0
    for name, value in word.values(beat.word).items():
        packed |= value << bits
        bits += word.fields[name].width
    return packed | beat.chain << bits | int(beat.last) << (bits + chain_bits)


class Master(LiteXModule):
    """Enables all interrupts, and after `start` reads words. Prints what it reads, and the interrupt; then ends the simulation."""

    def __init__(self, enable: int, reads: list[int], start: Signal, irq: Signal) -> None:
        self.bus = bus = wishbone.Interface(data_width=32, adr_width=30, addressing="word")
        addresses = Array(Constant(address >> 2, 30) for address in reads)
        place = Signal(max=len(reads) + 1)
        access = [bus.cyc.eq(1), bus.stb.eq(1), bus.sel.eq(0xF)]
        self.fsm = fsm = FSM(reset_state="ENABLE")
        fsm.act("ENABLE", *access, bus.we.eq(1), bus.adr.eq(enable >> 2), bus.dat_w.eq(0xFFFF_FFFF), If(bus.ack, NextState("WAIT")))
        fsm.act("WAIT", If(start, NextState("READ")))
        fsm.act(
            "READ",
            *access,
            bus.adr.eq(addresses[place]),
            If(bus.ack, NextValue(place, place + 1), If(place == len(reads) - 1, NextState("END"))),
        )
        self.sync += [
            If(fsm.ongoing("READ") & bus.ack, Display("read %d %x %d", place, bus.dat_r, bus.err)),
            If(fsm.ongoing("END"), Display("irq %d", irq), Finish()),
        ]


class Soc(SoCMini):
    """The core, a player for each input stream, and the master in the place of a CPU."""

    def __init__(self, platform: SimPlatform, folder: Path, shape: Shape, photons: list[Beat], queries: list[Beat]) -> None:
        SoCMini.__init__(self, platform, clk_freq=100_000_000, ident_version=False)
        self.cd_sys = ClockDomain("sys")
        self.comb += [self.cd_sys.clk.eq(platform.request("sys_clk")), self.cd_sys.rst.eq(platform.request("sys_rst"))]
        self.core = core = Photoncube(platform, folder)
        self.bus.add_slave("core", core.bus, SoCRegion(origin=ORIGIN, size=core.SIZE, cached=False))
        self.submodules += Player(core.photons, shape.photons, photons)
        self.submodules += Player(core.queries, shape.queries, queries)
        taken, wait = Signal(32), Signal(2)
        results = core.results
        self.comb += results.ready.eq(wait == 3)
        fields = [getattr(results, name) for name in shape.results.fields]
        shown = " ".join(["%d"] * (3 + len(fields)))
        self.sync += [
            wait.eq(wait + 1),
            If(
                results.valid & results.ready,
                taken.eq(taken + 1),
                Display(f"result {shown}", results.chain, results.last, results.outside, *fields),
            ),
        ]
        # The interrupts go where a CPU has its own.
        self.cpu.interrupt = Signal(32)
        self.irq.enable()
        self.irq.add("core")
        interrupt = Signal()
        self.comb += interrupt.eq(self.cpu.interrupt[self.irq.locs["core"]])
        registers = [ORIGIN + shape.registers[name] for name in names_read()]
        self.master = Master(ORIGIN + shape.registers[ENABLE], registers, taken == len(queries), interrupt)
        self.bus.add_master("master", self.master.bus)


def names_read() -> list[str]:
    """The registers that the master reads."""
    return ["identity", *(f"{name}_low" for name in COUNTERS)]


def traffic(shape: Shape, seed: int) -> tuple[list[Beat], list[Beat], Reference]:
    """A set and a batch for each chain, of which some query of each chain has photons in range."""
    count = shape.results.fields["count"]
    for attempt in range(10000):
        photons, queries = Traffic(shape, Random(10000 * seed + attempt)).round(Sizes(leaves=(3, 5), batches=(1, 1)))
        reference = Reference(shape)
        for beat in photons:
            reference.take_leaf(beat)
        for beat in queries:
            reference.take_query(beat)
        if all(any(result.word >> count.low & count.most for result in chain.results) for chain in reference.chains):
            return photons, queries, reference
    raise AssertionError("found no traffic with photons in range")


def simulation(folder: Path, build: Path, shape: Shape, photons: list[Beat], queries: list[Beat]) -> str:
    """What the simulation prints."""
    logging.disable(logging.INFO)
    platform = SimPlatform("SIM", [("sys_clk", 0, Pins(1)), ("sys_rst", 0, Pins(1))])
    soc = Soc(platform, folder, shape, photons, queries)
    soc.finalize()
    build.mkdir(parents=True, exist_ok=True)
    # An `always` for each signal. With one for several, which is LiteX's default, Icarus does not end the first time step.
    verilog = platform.get_verilog(soc.get_fragment(), name="soc", regular_comb=False)
    texts = {"soc.v": verilog.main_source, "bench.v": BENCH.replace("@TIME@", str(10 * MOST_CLOCKS)), **verilog.data_files}
    for name, text in texts.items():
        (build / name).write_text(text)
    sources = [source[0] for source in platform.sources]
    run = build / "bench.vvp"
    subprocess.run(["iverilog", "-g2005", "-o", run, "-s", "bench", "bench.v", "soc.v", *sources], cwd=build, check=True)
    # The players read their words from files in the folder.
    return subprocess.run(["vvp", "-n", run], cwd=build, check=True, capture_output=True, text=True, timeout=MOST_SECONDS).stdout


def check(said: str, reference: Reference) -> int:
    """Holds what was printed to the reference. Returns the number of results; raises AssertionError where one differs."""
    shape, results = reference.shape, 0
    for line in re.findall(r"^result (.*)$", said, re.MULTILINE):
        chain, last, outside, *values = map(int, line.split())
        word = shape.results.pack(dict(zip(shape.results.fields, values)))
        reference.check(Result(word, chain, bool(last), bool(outside)))
        results += 1
    assert results > 0 and reference.owes() == 0, f"found {results} results, {reference.owes()} more are owed"
    found = {names_read()[int(place)]: (int(word, 16), int(error)) for place, word, error in re.findall(r"read +(\d+) (\w+) (\d)", said)}
    expected = {f"{name}_low": (reference.counters[name], 0) for name in COUNTERS} | {"identity": (IDENTITY, 0)}
    assert found == expected, f"found registers {found}, expected {expected}"
    assert re.search(r"^irq 1$", said, re.MULTILINE), "found no interrupt, expected one by the event `done`"
    return results


def main() -> int:
    """Simulates a core."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--core", type=Path, required=True, help="the folder of a core")
    parser.add_argument("--build", type=Path, required=True, help="where the simulation is built")
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    folder = given.core.resolve()
    shape = read_shape(next(folder.glob("*.streams.json")))
    photons, queries, reference = traffic(shape, given.seed)
    said = simulation(folder, given.build.resolve(), shape, photons, queries)
    try:
        results = check(said, reference)
    except AssertionError as wrong:
        print(f"litex: {shape.core}: {wrong}", file=sys.stderr)
        return 1
    print(f"litex: {shape.core}: {len(photons)} leaves, {results} results, {len(names_read())} registers and the interrupt are right")
    return 0


if __name__ == "__main__":
    sys.exit(main())
