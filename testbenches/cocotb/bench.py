"""Drives a core through cocotbext-axi, and watches its pins."""

from __future__ import annotations

import itertools
import os
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from random import Random

import cocotb
from cocotb.clock import Clock
from cocotb.handle import SimHandleBase
from cocotb.triggers import ClockCycles, Event, RisingEdge
from cocotbext.axi import (
    AxiLiteBus,
    AxiLiteMaster,
    AxiResp,
    AxiStreamBus,
    AxiStreamFrame,
    AxiStreamSink,
    AxiStreamSource,
)
from cocotbext.axi.axil_channels import AxiLiteAWTransaction, AxiLiteWTransaction

from reference import Beat, Reference, Result
from registers import Register, read_registers
from shape import read_shape

RESTART = 1
CLEAR_COUNTERS = 2
# Bits of the registers `events` and `interrupt_enable`, the lowest first.
EVENTS = ("done", "leaf_malformed", "set_too_long", "query_outside", "chain_unknown", "access_refused", "stalled")
# Counters of what happens on the pins: known in every clock.
PIN_COUNTERS = (
    "clocks",
    "results",
    "photons_in_range",
    "photon_stalls",
    "query_stalls",
    "result_stalls",
    "accesses_refused",
)
# Counters of what happens within: known once all words have left the core.
INNER_COUNTERS = (
    "leaves_read",
    "queries_read",
    "leaves_compared",
    "leaves_malformed",
    "leaves_refused",
    "queries_outside",
    "queries_refused",
    "leaves_wanted",
    "groups_played",
)
# What the names of the pins of the result stream begin with.
RESULTS = "m_axis_results_t"
# Clocks without any word on a stream after which a test gives up. The longest scan of the small cores is far shorter.
SILENT_CLOCKS = 600


class Watch:
    """Looks at the pins before every rising edge: it holds each result to the reference, holds the core to the rules of
    AXI on its outputs, and counts what the core's own counters must count."""

    def __init__(self, dut: SimHandleBase, reference: Reference, registers: dict[str, Register]) -> None:
        self.dut = dut
        self.reference = reference
        self.count_field = reference.shape.results.fields["count"]
        self.readable = {register.address for register in registers.values()}
        self.writable = {register.address for register in registers.values() if register.writable}
        self.control = registers["control"].address
        self.counts: Counter[str] = Counter()
        # What happened in the clock before, which the core counts now.
        self.before: Counter[str] = Counter()
        # The address of a read that was taken in the clock before.
        self.reading: int | None = None
        # That of a read whose answer was found in the clock before.
        self.found: int | None = None
        # The counts before the edge at which the answer to the last read was found.
        self.read_counts: Counter[str] = Counter()
        # Beats that moved on each stream since the start, through all resets.
        self.beats: Counter[str] = Counter()
        # The results since the drivers were last reset.
        self.received: list[Result] = []
        self.silent = 0
        self.restarts = False
        self.restarted = Event()
        self.held: dict[str, tuple[int, ...]] = {}

    def pin(self, name: str) -> int:
        """The value of a pin; a pin that is x or z ends the test."""
        return getattr(self.dut, name).value.integer

    async def run(self) -> None:
        """Watches for ever."""
        edge = RisingEdge(self.dut.aclk)
        while True:
            await edge
            if self.pin("aresetn") == 0:
                self.reset()
            else:
                self.clock()

    def reset(self) -> None:
        """`aresetn` is 0."""
        self.reference.restart()
        self.reference.clear_counters()
        self.reference.events.clear()
        self.counts.clear()
        self.before.clear()
        self.held.clear()
        self.received.clear()
        self.restarts = False
        self.reading = None
        self.found = None
        self.silent = 0

    def clock(self) -> None:
        """A clock edge without `aresetn`."""
        if self.restarts:
            self.held.pop(RESULTS, None)
            assert not self.pin(f"{RESULTS}valid"), "a result of before a restart is given in its clock"
        self.hold_outputs()
        counts = self.streams()
        if self.restarts:
            self.reference.restart()
            self.received.clear()
            self.restarts = False
        self.lite(counts)

    def hold_outputs(self) -> None:
        """What is valid and not taken must stay as it is."""
        for prefix, payload in (
            (RESULTS, ("data", "id", "last", "user")),
            ("s_axi_r", ("data", "resp")),
            ("s_axi_b", ("resp",)),
        ):
            valid = self.pin(f"{prefix}valid")
            held = self.held.pop(prefix, None)
            if not valid:
                assert held is None, f"{prefix}valid fell before {prefix}ready"
                continue
            values = tuple(self.pin(prefix + name) for name in payload)
            assert held is None or held == values, f"{prefix}* changed from {held} to {values} while it waited"
            if not self.pin(f"{prefix}ready"):
                self.held[prefix] = values

    def streams(self) -> Counter[str]:
        """The words that move on the three streams. Returns what happens in this clock."""
        counts: Counter[str] = Counter()
        moved = False
        for stream, stalls, take in (
            ("photons", "photon_stalls", self.reference.take_leaf),
            ("queries", "query_stalls", self.reference.take_query),
        ):
            prefix = f"s_axis_{stream}_t"
            if self.pin(f"{prefix}valid"):
                if self.pin(f"{prefix}ready"):
                    take(Beat(self.pin(f"{prefix}data"), self.pin(f"{prefix}dest"), bool(self.pin(f"{prefix}last"))))
                    self.beats[stream] += 1
                    moved = True
                else:
                    counts[stalls] += 1
        if self.pin(f"{RESULTS}valid"):
            if self.pin(f"{RESULTS}ready"):
                counts += self.result()
                moved = True
            else:
                counts["result_stalls"] += 1
        self.silent = 0 if moved else self.silent + 1
        return counts

    def waits(self) -> str:
        """The handshakes of all streams, for a message."""
        streams = ("s_axis_photons", "s_axis_queries", "m_axis_results")
        return ", ".join(
            f"{stream}: tvalid {self.pin(f'{stream}_tvalid')}, tready {self.pin(f'{stream}_tready')}" for stream in streams
        )

    def result(self) -> Counter[str]:
        """A result that leaves, and what it counts."""
        last, user = bool(self.pin(f"{RESULTS}last")), bool(self.pin(f"{RESULTS}user"))
        result = Result(self.pin(f"{RESULTS}data"), self.pin(f"{RESULTS}id"), last, user)
        self.reference.check(result)
        self.received.append(result)
        self.beats["results"] += 1
        photons = result.word >> self.count_field.low & self.count_field.most
        return Counter(results=1, photons_in_range=photons)

    def lite(self, counts: Counter[str]) -> None:
        """The accesses that are taken. Counters and commands take effect behind the edge. The answer to a read is found a clock later, and
        given in the clock behind that."""
        clears = False
        if self.reading is not None:
            self.read_counts = self.counts.copy()
        if self.found is not None and self.found not in self.readable:
            counts["accesses_refused"] += 1
        self.found = self.reading
        reads = self.pin("s_axi_arvalid") and self.pin("s_axi_arready")
        self.reading = self.pin("s_axi_araddr") & ~3 if reads else None
        writes = self.pin("s_axi_awvalid") and self.pin("s_axi_awready")
        taken = self.pin("s_axi_wvalid") and self.pin("s_axi_wready")
        assert writes == taken, "the core takes the address and the word of a write in one clock"
        if writes:
            address = self.pin("s_axi_awaddr") & ~3
            if address not in self.writable:
                counts["accesses_refused"] += 1
            elif address == self.control and self.pin("s_axi_wstrb") & 1:
                word = self.pin("s_axi_wdata")
                clears = bool(word & CLEAR_COUNTERS)
                if word & RESTART:
                    self.restarts = True
                    self.restarted.set()
        if counts["accesses_refused"]:
            self.reference.events.add("access_refused")
        if clears:
            self.counts.clear()
            self.reference.clear_counters()
        else:
            self.counts += self.before + Counter(clocks=1)
        self.before = counts


class Bench:
    """A core with a driver on each port."""

    def __init__(self, dut: SimHandleBase, seed: int) -> None:
        self.dut = dut
        folder = Path(os.environ["PHOTONCUBE_CORE"])
        self.random = Random(seed)
        self.shape = read_shape(next(folder.glob("*.streams.json")))
        self.registers = read_registers(next(folder.glob("*.rdl")))
        self.reference = Reference(self.shape)
        self.watch = Watch(dut, self.reference, self.registers)
        ports = {"clock": dut.aclk, "reset": dut.aresetn, "reset_active_level": False}
        # One lane for the whole word, because the core has no tkeep.
        lane = {"byte_lanes": 1}
        self.photons = AxiStreamSource(AxiStreamBus.from_prefix(dut, "s_axis_photons"), **ports, **lane)
        self.queries = AxiStreamSource(AxiStreamBus.from_prefix(dut, "s_axis_queries"), **ports, **lane)
        self.results = AxiStreamSink(AxiStreamBus.from_prefix(dut, "m_axis_results"), **ports, **lane)
        self.axi = AxiLiteMaster(AxiLiteBus.from_prefix(dut, "s_axi"), **ports)

    async def start(self) -> None:
        """Starts the clock and resets the core."""
        self.dut.aresetn.value = 0
        cocotb.start_soon(Clock(self.dut.aclk, 10, "ns").start())
        # All pins have a value behind the first clock edge.
        await RisingEdge(self.dut.aclk)
        cocotb.start_soon(self.watch.run())
        await self.reset()

    async def reset(self) -> None:
        """A reset by the pin, in which the drivers drop their words too."""
        self.dut.aresetn.value = 0
        await ClockCycles(self.dut.aclk, self.random.randint(2, 4))
        # Behind the edge at which the reset begins: at that edge the driver may receive one more result.
        self.forget()
        self.dut.aresetn.value = 1
        await ClockCycles(self.dut.aclk, 2)

    def forget(self) -> None:
        """The drivers drop the words that they have not begun, and the results that they have."""
        for port in (self.photons, self.queries, self.results):
            port.clear()

    async def restart(self) -> None:
        """A restart by register. The drivers of the streams are reset with the chains, in the clock behind the write."""
        self.watch.restarted.clear()
        write = cocotb.start_soon(self.write("control", RESTART))
        await self.watch.restarted.wait()
        self.forget()
        for port in (self.photons, self.queries, self.results):
            port.assert_reset(True)
        await write
        for port in (self.photons, self.queries, self.results):
            port.assert_reset(False)
        await ClockCycles(self.dut.aclk, 2)

    def pauses(self, chance: float) -> Iterator[bool]:
        """Pauses for a port: at times many in a row, so that words pile up before it."""
        random = Random(self.random.getrandbits(32))
        while True:
            is_paused = random.random() < chance
            yield from itertools.repeat(is_paused, random.choice((1, 1, 2, 3, 12 if is_paused else 3)))

    def pause(self, chance: float) -> None:
        """Sets random pauses on every port."""
        ports = [self.photons, self.queries, self.results]
        ports += [self.axi.write_if.aw_channel, self.axi.write_if.w_channel, self.axi.write_if.b_channel]
        ports += [self.axi.read_if.ar_channel, self.axi.read_if.r_channel]
        for port in ports:
            port.clear_pause_generator()
            port.pause = False
            if chance > 0:
                port.set_pause_generator(self.pauses(chance))

    async def read(self, name: str) -> int:
        """The value of a register."""
        return await self.read_at(self.registers[name].address)

    async def read_at(self, address: int) -> int:
        """The value at an address, which must be answered with OKAY."""
        answer = await self.axi.read(address, 4)
        assert answer.resp == AxiResp.OKAY, f"a read of {address:#x} was answered with {answer.resp!r}"
        return int.from_bytes(answer.data, "little")

    async def write(self, name: str, value: int) -> None:
        """Writes a register, which must be answered with OKAY."""
        answer = await self.axi.write(self.registers[name].address, value.to_bytes(4, "little"))
        assert answer.resp == AxiResp.OKAY, f"a write of {name} was answered with {answer.resp!r}"

    async def write_bytes(self, address: int, word: int, strobes: int) -> None:
        """Writes the bytes of a word whose strobe is 1, by the channels of the driver: its `write` knows only bytes side by
        side, and gives the address of the first."""
        channels = self.axi.write_if
        await channels.aw_channel.send(AxiLiteAWTransaction(awaddr=address, awprot=0))
        await channels.w_channel.send(AxiLiteWTransaction(wdata=word, wstrb=strobes))
        answer = await channels.b_channel.recv()
        assert int(answer.bresp) == AxiResp.OKAY, f"a write of {address:#x} was answered with {answer.bresp}"

    async def counter(self, name: str) -> int:
        """The value of a counter. The high word is that of the moment at which the low word was read."""
        low = await self.read(f"{name}_low")
        seen = self.watch.read_counts[name]
        value = low | await self.read(f"{name}_high") << 32
        if name in PIN_COUNTERS:
            assert value == seen, f"counter {name}: found {value}, expected {seen}"
        return value

    async def events(self) -> set[str]:
        """The events that occurred, which are then cleared."""
        word = await self.read("events")
        await self.write("events", word)
        return {name for bit, name in enumerate(EVENTS) if word >> bit & 1}

    def send(self, source: AxiStreamSource, beats: list[Beat]) -> None:
        """Sends words. A frame of cocotbext-axi ends with `tlast`; the last of the words has it in any case."""
        frame: list[Beat] = []
        for place, beat in enumerate(beats):
            frame.append(beat)
            if beat.last or place == len(beats) - 1:
                words, chains = [beat.word for beat in frame], [beat.chain for beat in frame]
                source.send_nowait(AxiStreamFrame(words, tdest=chains))
                frame = []

    async def drain(self) -> None:
        """Waits until all words were taken and all results have left."""
        while not (self.photons.idle() and self.queries.idle() and self.reference.owes() == 0):
            assert self.watch.silent < SILENT_CLOCKS, (
                f"silent for {SILENT_CLOCKS} clocks; {self.reference.owes()} results are owed; {self.watch.waits()}"
            )
            await RisingEdge(self.dut.aclk)
        # Counters and events are a clock late.
        await ClockCycles(self.dut.aclk, 4)
        assert self.reference.is_settled(), "the traffic has a query without a set"

    def check_sink(self) -> None:
        """The driver of the result stream must have seen the words that the pins showed."""
        words: list[tuple[int, int, bool]] = []
        while not self.results.empty():
            frame = self.results.recv_nowait(compact=False)
            ends = len(frame.tdata) - 1
            words += [(word, frame.tid[place], place == ends) for place, word in enumerate(frame.tdata)]
        # A frame that no `tlast` has ended yet is still in the driver.
        expected = [(result.word, result.chain, result.last) for result in self.watch.received]
        rest = expected[len(words) :]
        assert words == expected[: len(words)], "the driver of m_axis_results received other words than the pins showed"
        assert not any(last for _, _, last in rest), "the driver of m_axis_results missed a frame"
        del self.watch.received[: len(words)]

    async def check_quiet(self) -> None:
        """Holds the counters, the events and the state to the reference, once everything has left."""
        for name in PIN_COUNTERS:
            await self.counter(name)
        for name in INNER_COUNTERS:
            found, expected = await self.counter(name), self.reference.counters[name]
            assert found == expected, f"counter {name}: found {found}, expected {expected}"
        self.check_sink()
        assert await self.read("under_way") == 0
        assert await self.read("status") == 0
        found, expected = await self.events(), set(self.reference.events)
        self.reference.events.clear()
        assert found == expected, f"events: found {sorted(found)}, expected {sorted(expected)}"
