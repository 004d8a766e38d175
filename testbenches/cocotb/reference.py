"""What a core must answer, by the rules of the specification (crates/spec/src/core, leaf and formats).

It knows nothing of clocks. It is given the words that the streams took, in their order, and says which results must leave
each chain and what the counters must be once all of them have left.
"""

from __future__ import annotations

from collections import Counter, deque
from dataclasses import dataclass, field

from shape import Shape

PHOTONS = 8
GROUP = 4
FACINGS = 32
AXES = ("x", "y", "z")

Borders = list[tuple[int, int]]


@dataclass(frozen=True)
class Beat:
    """A word of an input stream: `tdata`, `tdest`, `tlast`."""

    word: int
    chain: int
    last: bool


@dataclass(frozen=True)
class Result:
    """A word of the result stream. `user` is 1 where the query is outside of its frame."""

    word: int
    chain: int
    last: bool
    user: bool


@dataclass(frozen=True)
class Photon:
    """A present photon: the cell that it is in, and its powers."""

    cell: tuple[int, ...]
    power: tuple[int, ...]


@dataclass(frozen=True)
class Leaf:
    """A leaf of a set: the photons of each group. The last leaf of a set has one group if it has no photons in its second half."""

    groups: list[list[Photon]]
    facing: int


@dataclass(frozen=True)
class Query:
    """A query of a batch."""

    cell: tuple[int, ...]
    radius_sq: int
    own_radius: dict[str, int]
    tag: int
    facings: int
    release: bool
    last: bool
    outside: bool


class Geometry:
    """Distances in half fine steps, in which the middles of all cells are integers."""

    def __init__(self, shape: Shape) -> None:
        self.extra = shape.extra_bits
        radius = (1 << (shape.position_bits + shape.extra_bits)) - 2
        self.radius_sq = (2 * radius) ** 2
        self.most = shape.photons.fields["x_0"].most
        self.largest_word = radius**2 - min(1, self.extra)

    def photon(self, cell: int) -> int:
        """The middle of a photon's cell."""
        return (2 * cell + 1) << self.extra

    def at_most_largest(self, word: int) -> int:
        """The radius that a field `radius_sq` means: one above the largest means the largest."""
        return min(word, self.largest_word)

    def of_word(self, word: int) -> int:
        """The squared radius of a query whose word has the field `radius_sq`."""
        return 4 * word + 3 * min(1, self.extra)

    def distance(self, query: int, photon: int) -> int:
        """From a photon's cell to a query's cell, along an axis."""
        return (2 * query + 1) - self.photon(photon)

    def is_near(self, query: Query, photon: Photon) -> bool:
        """Whether the photon is in range of the query."""
        distances = map(self.distance, query.cell, photon.cell)
        return sum(distance**2 for distance in distances) <= query.radius_sq

    def box(self, photons: list[Photon]) -> Borders:
        """The box around a group. Without photons, its low borders are the highest cell and its high borders the lowest."""
        return borders([photon.cell for photon in photons]) if photons else [(self.most, 0)] * len(AXES)

    def boxes_are_near(self, queries: Borders, photons: Borders) -> bool:
        """Whether the box of a group is in range of the box of a batch."""
        total = 0
        for (query_low, query_high), (photon_low, photon_high) in zip(queries, photons):
            above = self.distance(query_low, photon_high)
            below = self.distance(query_high, photon_low)
            # Where the boxes overlap, the gap is the smallest distance that there is.
            gap = below if below < 0 else above if above >= 0 else min(1, self.extra)
            total += gap**2
        return total <= self.radius_sq


def borders(cells: list[tuple[int, ...]]) -> Borders:
    """The box around cells: on each axis, the lowest and the highest."""
    return [(min(values), max(values)) for values in zip(*cells)]


@dataclass
class Chain:
    """The words of a chain that are not used yet, and the results that it owes."""

    leaves: list[Leaf] = field(default_factory=list)
    sets: deque[list[Leaf]] = field(default_factory=deque)
    queries: list[Query] = field(default_factory=list)
    batches: deque[list[Query]] = field(default_factory=deque)
    results: deque[Result] = field(default_factory=deque)
    drops: bool = False


class Reference:
    """The expected answers of a core, its counters and its events."""

    def __init__(self, shape: Shape) -> None:
        self.shape = shape
        self.geometry = Geometry(shape)
        self.spare = sum(1 << bit for bit in shape.queries.spare_bits())
        self.counters: Counter[str] = Counter()
        self.events: set[str] = set()
        self.restart()

    def restart(self) -> None:
        """Forgets all words under way. Counters and events stay."""
        self.chains = [Chain() for _ in range(self.shape.chains)]

    def clear_counters(self) -> None:
        """Sets all counters to 0."""
        self.counters.clear()

    def take_leaf(self, beat: Beat) -> None:
        """A word of the photon stream."""
        if beat.chain >= len(self.chains):
            self.events.add("chain_unknown")
            self.counters["leaves_refused"] += 1
            return
        chain = self.chains[beat.chain]
        if chain.drops:
            self.counters["leaves_refused"] += 1
            chain.drops = not beat.last
            return
        values = self.shape.photons.values(beat.word)
        present = [values[f"present_{place}"] for place in range(PHOTONS)]
        self.counters["leaves_read"] += 1
        if present != sorted(present, reverse=True):
            self.counters["leaves_malformed"] += 1
            self.events.add("leaf_malformed")
        short = beat.last and not any(present[GROUP:])
        halves = (range(GROUP), range(GROUP, PHOTONS))
        groups = [[self.photon(values, place) for place in half if present[place]] for half in halves]
        chain.leaves.append(Leaf(groups[:1] if short else groups, values["facing"]))
        full = len(chain.leaves) == self.shape.set_leaves
        if full and not beat.last:
            self.events.add("set_too_long")
            chain.drops = True
        if full or beat.last:
            chain.sets.append(chain.leaves)
            chain.leaves = []
            self.answer(beat.chain)

    def photon(self, values: dict[str, int], place: int) -> Photon:
        """The photon at a place of a leaf."""
        shift = values[f"exponent_{place}"] if self.shape.has_exponent else 0
        cell = tuple(values[f"{axis}_{place}"] for axis in AXES)
        return Photon(cell, tuple(values[f"{channel}_{place}"] << shift for channel in self.shape.channels))

    def take_query(self, beat: Beat) -> None:
        """A word of the query stream."""
        if beat.chain >= len(self.chains):
            self.events.add("chain_unknown")
            self.counters["queries_refused"] += 1
            return
        chain = self.chains[beat.chain]
        values = self.shape.queries.values(beat.word)
        cell = tuple(values[axis] for axis in AXES)
        frame = 4 << (self.shape.position_bits + self.shape.extra_bits)
        outside = bool(beat.word & self.spare) or max(cell) >= frame
        self.counters["queries_read"] += 1
        if outside:
            self.counters["queries_outside"] += 1
            self.events.add("query_outside")
        own = {name: self.geometry.at_most_largest(value) for name, value in values.items() if name == "radius_sq"}
        query = Query(
            cell=cell,
            radius_sq=self.geometry.of_word(own["radius_sq"]) if own else self.geometry.radius_sq,
            own_radius=own,
            tag=values["tag"],
            facings=values["facings"],
            release=bool(values["release"]),
            last=beat.last,
            outside=outside,
        )
        chain.queries.append(query)
        if beat.last or len(chain.queries) == self.shape.engines:
            chain.batches.append(chain.queries)
            chain.queries = []
            self.answer(beat.chain)

    def answer(self, number: int) -> None:
        """The results of all batches of a chain whose set is there."""
        chain = self.chains[number]
        while chain.batches and chain.sets:
            batch, leaves = chain.batches.popleft(), chain.sets[0]
            facings = batch[0].facings
            gathered = [leaf for leaf in leaves if facings >> leaf.facing & 1]
            photons = [photon for leaf in gathered for group in leaf.groups for photon in group]
            for query in batch:
                chain.results.append(self.result(number, query, photons))
            self.count_played(batch, leaves)
            if any(query.release for query in batch):
                chain.sets.popleft()

    def result(self, chain: int, query: Query, photons: list[Photon]) -> Result:
        """The sums over the photons in range; 0 for a query outside of its frame."""
        near = [] if query.outside else [photon for photon in photons if self.geometry.is_near(query, photon)]
        values = {
            channel: sum(photon.power[place] for photon in near)
            for place, channel in enumerate(self.shape.channels)
        }
        values |= {"count": len(near), "tag": query.tag} | query.own_radius
        self.counters["results"] += 1
        self.counters["photons_in_range"] += len(near)
        self.events.add("done")
        return Result(self.shape.results.pack(values), chain, query.last, query.outside)

    def count_played(self, batch: list[Query], leaves: list[Leaf]) -> None:
        """Counts what a batch compares and plays."""
        self.counters["leaves_compared"] += len(leaves)
        box = borders([query.cell for query in batch])
        facings = batch[0].facings
        # For each leaf, its groups that are wanted.
        wanted = [
            (facings >> leaf.facing & 1)
            * sum(self.geometry.boxes_are_near(box, self.geometry.box(group)) for group in leaf.groups)
            for leaf in leaves
        ]
        self.counters["leaves_wanted"] += sum(map(bool, wanted))
        # The last pair is always played: where none of its leaves is wanted, as one group without photons.
        last_pair = wanted[(len(wanted) - 1) // 2 * 2 :]
        self.counters["groups_played"] += sum(wanted) + (not any(last_pair))

    def owes(self) -> int:
        """Results that must still leave."""
        return sum(len(chain.results) for chain in self.chains)

    def is_settled(self) -> bool:
        """Whether every query has a set, so that all of them are answered in the end."""
        return not any(chain.batches or chain.queries for chain in self.chains)

    def check(self, result: Result) -> None:
        """Holds a result that left the core to the next that its chain owes."""
        assert result.chain < len(self.chains), f"{result} is of no chain"
        owed = self.chains[result.chain].results
        assert owed, f"{result} was not asked for"
        expected = owed.popleft()
        assert result == expected, (
            f"found {result} with {self.shape.results.values(result.word)},"
            f" expected {expected} with {self.shape.results.values(expected.word)}"
        )
