"""Tests of the emitted Verilog of a core through standard drivers. Environment:

PHOTONCUBE_CORE    the folder with the core's Verilog, SystemRDL and words of streams
PHOTONCUBE_ROUNDS  rounds of random traffic; a round is a set and its batches for each chain
PHOTONCUBE_WRONG   rounds of traffic with wrong words
PHOTONCUBE_RESETS  resets while words are under way
PHOTONCUBE_SEED    where the random numbers begin
PHOTONCUBE_TOTALS  a file to which each test adds the beats that it compared
"""

from __future__ import annotations

import json
import logging
import os
from collections.abc import Callable
from pathlib import Path
from random import Random

import cocotb
from cocotb.handle import SimHandleBase
from cocotb.triggers import ClockCycles, RisingEdge
from cocotbext.axi import AxiResp

from bench import CLEAR_COUNTERS, EVENTS, PIN_COUNTERS, Bench
from reference import Beat
from traffic import MANY_WRONG, RIGHT, Sizes, Traffic, Wrong

SMALL = Sizes(leaves=(1, 4), batches=(1, 4))
LARGE = Sizes(leaves=(1, 8), batches=(1, 6))
ROUNDS = int(os.environ.get("PHOTONCUBE_ROUNDS", "20"))
WRONG_ROUNDS = int(os.environ.get("PHOTONCUBE_WRONG", "20"))
RESETS = int(os.environ.get("PHOTONCUBE_RESETS", "4"))
SEED = int(os.environ.get("PHOTONCUBE_SEED", "1"))
# Clocks after which a test no longer waits for something that a few words cause.
MOST_CLOCKS = 2000
# Rounds between two comparisons of all counters.
ROUNDS_AT_ONCE = max(5, ROUNDS // 100)


async def begun(dut: SimHandleBase, seed: int) -> Bench:
    """A bench behind its first reset."""
    bench = Bench(dut, SEED * 1000 + seed)
    for port in (bench.photons, bench.queries, bench.results, bench.axi.write_if, bench.axi.read_if):
        # Each frame and each access is a line otherwise.
        port.log.setLevel(logging.ERROR)
    await bench.start()
    return bench


async def until(bench: Bench, what: str, happens: Callable[[], object]) -> None:
    """Waits for a clock in which something has happened."""
    for _ in range(MOST_CLOCKS):
        if happens():
            return
        await RisingEdge(bench.dut.aclk)
    raise AssertionError(f"waited {MOST_CLOCKS} clocks for {what}")


def finish(bench: Bench, least: int = 1) -> None:
    """Adds the beats of a test to the totals. A test of traffic that compared nothing fails."""
    beats = dict(bench.watch.beats)
    for stream in ("photons", "queries", "results"):
        assert beats.get(stream, 0) >= least, f"only {beats.get(stream, 0)} beats on the stream of {stream}"
    with Path(os.environ["PHOTONCUBE_TOTALS"]).open("a") as totals:
        totals.write(json.dumps(beats) + "\n")


def rounds_of(traffic: Traffic, sizes: Sizes, rounds: int) -> tuple[list[Beat], list[Beat]]:
    """The words of several rounds, one after the other."""
    photons, queries = [], []
    for _ in range(rounds):
        more_photons, more_queries = traffic.round(sizes)
        photons += more_photons
        queries += more_queries
    return photons, queries


async def read_counters(bench: Bench) -> None:
    """Reads counters of the pins, and now and then a register that there is not, for as long as words move."""
    random = Random(bench.random.getrandbits(32))
    while True:
        await bench.counter(random.choice(PIN_COUNTERS))
        if random.random() < 0.2:
            await bench.axi.read(0x1F0, 4)
        await ClockCycles(bench.dut.aclk, random.randint(1, 100))


async def transfer(bench: Bench, traffic: Traffic, sizes: Sizes, rounds: int) -> None:
    """Sends rounds of traffic with pauses of another density each time, and checks everything after each."""
    while rounds > 0:
        some = min(rounds, ROUNDS_AT_ONCE)
        rounds -= some
        photons, queries = rounds_of(traffic, sizes, some)
        bench.pause(bench.random.choice((0.0, 0.2, 0.5)))
        reader = cocotb.start_soon(read_counters(bench))
        bench.send(bench.photons, photons)
        bench.send(bench.queries, queries)
        await bench.drain()
        reader.kill()
        # A read that was under way ends before the next one begins.
        await bench.axi.wait()
        bench.pause(0.0)
        await bench.check_quiet()
        bench.dut._log.info("%d rounds to come; beats so far: %s", rounds, dict(bench.watch.beats))


@cocotb.test()
async def random_traffic(dut: SimHandleBase) -> None:
    """Right words for all chains, with random pauses on every port."""
    bench = await begun(dut, 1)
    await transfer(bench, Traffic(bench.shape, bench.random, RIGHT), SMALL, ROUNDS)
    finish(bench, ROUNDS)


@cocotb.test()
async def wrong_words(dut: SimHandleBase) -> None:
    """Wrong words between right ones: the right ones lose nothing, and each wrong one is counted."""
    bench = await begun(dut, 2)
    await transfer(bench, Traffic(bench.shape, bench.random, MANY_WRONG), LARGE, WRONG_ROUNDS)
    # Leaves without any photon, for which the rules do not say whether they are wanted.
    await transfer(bench, Traffic(bench.shape, bench.random, Wrong(empty=0.3)), SMALL, WRONG_ROUNDS // 4)
    finish(bench, WRONG_ROUNDS)


@cocotb.test()
async def resets_in_flight(dut: SimHandleBase) -> None:
    """Resets by pin and by register at any moment, and then traffic that must be answered in full."""
    bench = await begun(dut, 3)
    traffic = Traffic(bench.shape, bench.random, MANY_WRONG)
    for number in range(RESETS):
        bench.pause(bench.random.choice((0.0, 0.3)))
        photons, queries = rounds_of(traffic, SMALL, 4)
        bench.send(bench.photons, photons)
        bench.send(bench.queries, queries)
        await ClockCycles(dut.aclk, bench.random.randint(1, 200))
        if number % 2:
            await bench.restart()
            # What was lost within is counted already.
            await bench.write("control", CLEAR_COUNTERS)
            await bench.events()
            bench.reference.events.clear()
        else:
            bench.pause(0.0)
            await bench.reset()
            assert await bench.events() == set()
        await transfer(bench, traffic, SMALL, 1)
    finish(bench, RESETS)


@cocotb.test()
async def a_word_waits_through_a_restart(dut: SimHandleBase) -> None:
    """A leaf that waits on the pins during a restart is not lost: it is the first of the first set behind it."""
    bench = await begun(dut, 4)
    traffic = Traffic(bench.shape, bench.random)
    leaves = [traffic.leaf(True, 0) for _ in range(24)]
    bench.send(bench.photons, leaves)
    await until(bench, "20 clocks in which a leaf waits", lambda: bench.watch.counts["photon_stalls"] >= 20)
    taken = bench.watch.beats["photons"]
    assert 2 <= taken < len(leaves), f"{taken} leaves were taken, expected two sets, the queue of the chain and the slice"
    await bench.write("control", 1)
    await ClockCycles(dut.aclk, 50)
    bench.send(bench.queries, [traffic.query(True, True, 0) for _ in range(len(leaves) - taken)])
    await bench.drain()
    bench.check_sink()
    finish(bench)


@cocotb.test()
async def one_query(dut: SimHandleBase) -> None:
    """A single query: the clocks in which it is under way, the event done, the pin irq."""
    bench = await begun(dut, 5)
    traffic = Traffic(bench.shape, bench.random)
    await bench.write("interrupt_enable", 1 << EVENTS.index("done"))
    bench.send(bench.photons, [traffic.leaf(True, 0)])
    await ClockCycles(dut.aclk, 60)
    assert await bench.counter("busy_clocks") == 0
    bench.send(bench.queries, [traffic.query(True, True, 0)])
    await until(bench, "a query that moves", lambda: bench.watch.beats["queries"])
    moved = bench.watch.counts["clocks"]
    bench.results.pause = True
    await until(bench, "a result that waits", lambda: bench.watch.counts["result_stalls"])
    status = await bench.read("status")
    assert status == 0b1001, f"status: found {status:#b}, expected busy and result_waits"
    assert await bench.read("under_way") == 1
    assert dut.irq.value == 0
    bench.results.pause = False
    await until(bench, "a result that moves", lambda: bench.watch.beats["results"])
    left = bench.watch.counts["clocks"]
    # That no query is left is known a clock late, and an event is a clock late.
    await ClockCycles(dut.aclk, 3)
    assert dut.irq.value == 1
    # It is given in the clock behind the one in which it moved. That it came and that its result went are both counted a clock late.
    busy = await bench.counter("busy_clocks")
    assert busy == left - moved - 1, f"busy_clocks: found {busy}, expected {left - moved - 1}"
    await bench.check_quiet()
    assert dut.irq.value == 0
    finish(bench)


@cocotb.test()
async def each_event_alone(dut: SimHandleBase) -> None:
    """Each wrong word sets its bit and no other, raises `irq` where enabled, and leaves the others as they are."""
    bench = await begun(dut, 6)
    shape = bench.shape
    plain = Traffic(shape, bench.random)
    outside = Traffic(shape, bench.random, Wrong(outside=1.0))
    # With two, four, eight or sixteen chains tdest has no other number.
    no_chain = shape.chains if shape.chains & (shape.chains - 1) or shape.chains == 1 else None
    swapped = plain.leaf(True, 0)
    fields = shape.photons.fields
    for place in range(8):
        swapped = Beat(swapped.word & ~(1 << fields[f"present_{place}"].low), 0, True)
    swapped = Beat(swapped.word | 1 << fields["present_3"].low, 0, True)
    right_leaf, right_query = [plain.leaf(True, 0)], [plain.query(True, True, 0)]
    too_long = [plain.leaf(place == shape.set_leaves, 0) for place in range(shape.set_leaves + 1)]
    cases = [
        ("leaf_malformed", [swapped], right_query),
        ("set_too_long", too_long, right_query),
        ("query_outside", right_leaf, [outside.query(True, True, 0)]),
    ]
    if no_chain is not None:
        unknown_leaf, unknown_query = plain.leaf(False, no_chain), plain.query(False, False, no_chain)
        cases.append(("chain_unknown", [unknown_leaf, *right_leaf], right_query))
        cases.append(("chain_unknown", right_leaf, [unknown_query, *right_query]))
    for event, photons, queries in cases:
        await bench.write("interrupt_enable", 1 << EVENTS.index(event))
        assert dut.irq.value == 0
        bench.send(bench.photons, photons)
        bench.send(bench.queries, queries)
        await bench.drain()
        assert bench.reference.events == {event, "done"}
        assert dut.irq.value == 1, f"no irq by {event}"
        await bench.check_quiet()
        assert dut.irq.value == 0
    finish(bench)


@cocotb.test()
async def stalled(dut: SimHandleBase) -> None:
    """A query without photons makes the core silent: the event occurs after the clocks that were set, and not before. The
    photons come then, and nothing is lost."""
    bench = await begun(dut, 7)
    traffic = Traffic(bench.shape, bench.random)
    limit = 100
    await bench.write("stall_limit", limit)
    await bench.write("interrupt_enable", 1 << EVENTS.index("stalled"))
    bench.send(bench.queries, [traffic.query(True, True, 0)])
    await until(bench, "a query that moves", lambda: bench.watch.beats["queries"])
    # The query waits in the slice for a clock: the core is silent from the clock in which it is under way.
    clocks = 0
    while dut.irq.value == 0:
        await RisingEdge(dut.aclk)
        clocks += 1
        assert clocks < 2 * limit, "the event stalled did not occur"
    # Behind the edge at which the query moved: a clock in the slice, one by which the query is counted late, the silent ones, two by
    # which these are counted late, one by which events are late, and one in which the pin is read.
    assert clocks == limit + 6, f"stalled after {clocks} clocks, expected {limit + 6}"
    bench.reference.events.add("stalled")
    bench.send(bench.photons, [traffic.leaf(True, 0)])
    await bench.drain()
    await bench.check_quiet()
    # A limit of 0 is none.
    await bench.write("stall_limit", 0)
    bench.send(bench.queries, [traffic.query(True, True, 0)])
    await ClockCycles(dut.aclk, 3 * limit)
    assert await bench.events() == set()
    bench.send(bench.photons, [traffic.leaf(True, 0)])
    await bench.drain()
    await bench.check_quiet()
    finish(bench)


@cocotb.test()
async def registers_by_their_description(dut: SimHandleBase) -> None:
    """Every register of the SystemRDL: address, value after reset, what a write changes, byte by byte."""
    bench = await begun(dut, 8)
    assert {name: register.address for name, register in bench.registers.items()} == bench.shape.registers
    for register in bench.registers.values():
        if register.name.startswith("clocks_"):
            continue
        found = await bench.read_at(register.address)
        assert found == register.reset, f"{register.name}: found {found:#x}, expected {register.reset:#x} after reset"
    shape = bench.shape
    assert bench.registers["shape"].reset == shape.chains | shape.engines << 8 | shape.set_leaves << 16
    digest = await bench.read("digest_low") | await bench.read("digest_high") << 32
    assert digest == shape.digest
    refused = 0
    for register in bench.registers.values():
        if not register.writable:
            answer = await bench.axi.write(register.address, b"\xff\xff\xff\xff")
            assert answer.resp == AxiResp.SLVERR, f"a write of {register.name} was answered with {answer.resp!r}"
            refused += 1
        elif register.readable and not register.cleared_by_one:
            await written_byte_by_byte(bench, register.name)
    assert await bench.read("identity") == bench.registers["identity"].reset
    assert await bench.counter("accesses_refused") == refused
    assert await bench.events() == {"access_refused"}


async def written_byte_by_byte(bench: Bench, name: str) -> None:
    """Writes some bytes of a register, in any places, and leaves the others."""
    register = bench.registers[name]
    value = register.reset
    for strobes in range(16):
        word = bench.random.getrandbits(32)
        await bench.write_bytes(register.address, word, strobes)
        mask = sum(0xFF << 8 * byte for byte in range(4) if strobes >> byte & 1)
        value = (value & ~mask | word & mask) & register.writable
        found = await bench.read(name)
        assert found == value, f"{name}: found {found:#x}, expected {value:#x} by strobes {strobes:#06b}"


@cocotb.test()
async def addresses_that_are_not_aligned(dut: SimHandleBase) -> None:
    """The low two bits of an address are not looked at: a byte of a register is read and written at its own address."""
    bench = await begun(dut, 10)
    register = bench.registers["stall_limit"]
    value = register.reset
    for byte in (1, 2, 3, 0):
        data = bench.random.randbytes(1)
        answer = await bench.axi.write(register.address + byte, data)
        assert answer.resp == AxiResp.OKAY, f"a write of byte {byte} was answered with {answer.resp!r}"
        value = value & ~(0xFF << 8 * byte) | data[0] << 8 * byte
        assert await bench.read("stall_limit") == value
        answer = await bench.axi.read(register.address + byte, 1)
        assert (answer.resp, answer.data) == (AxiResp.OKAY, data), f"found {answer} for byte {byte}, expected {data!r}"
    assert await bench.counter("accesses_refused") == 0


@cocotb.test()
async def addresses_without_a_register(dut: SimHandleBase) -> None:
    """Every other word of the map answers reads and writes with SLVERR, sets the event and is counted."""
    bench = await begun(dut, 9)
    known = {register.address for register in bench.registers.values()}
    others = [address for address in range(0, 512, 4) if address not in known]
    assert others
    for number, address in enumerate(others):
        answer = await bench.axi.read(address, 4)
        assert answer.resp == AxiResp.SLVERR, f"a read of {address:#x} was answered with {answer.resp!r}"
        answer = await bench.axi.write(address, b"\0\0\0\0")
        assert answer.resp == AxiResp.SLVERR, f"a write of {address:#x} was answered with {answer.resp!r}"
        if number in (0, len(others) - 1):
            assert await bench.counter("accesses_refused") == 2 * (number + 1)
            assert await bench.events() == {"access_refused"}
    await bench.write("control", CLEAR_COUNTERS)
    assert await bench.counter("accesses_refused") == 0
