"""Random words for a core: sets of photons and batches of queries, those of all chains mixed."""

from __future__ import annotations

from dataclasses import dataclass
from random import Random

from reference import AXES, FACINGS, PHOTONS, Beat
from shape import Shape


# No format has a larger exponent, also where its bits could hold one.
MOST_EXPONENT = 24


@dataclass(frozen=True)
class Wrong:
    """How often, from 0 to 1, a word is wrong in each way."""

    malformed: float = 0.0
    empty: float = 0.0
    too_long: float = 0.0
    outside: float = 0.0
    unknown_chain: float = 0.0


RIGHT = Wrong()
MANY_WRONG = Wrong(malformed=0.1, too_long=0.1, outside=0.1, unknown_chain=0.1)


@dataclass(frozen=True)
class Sizes:
    """How much a set and its batches have."""

    leaves: tuple[int, int]
    batches: tuple[int, int]


class Traffic:
    """Makes words of both input streams. Each chain gets its sets and its batches in one order, so no chain waits for ever."""

    def __init__(self, shape: Shape, random: Random, wrong: Wrong = RIGHT) -> None:
        self.shape = shape
        self.random = random
        self.wrong = wrong
        self.centre = self.point()

    def happens(self, chance: float) -> bool:
        """True that often."""
        return self.random.random() < chance

    def point(self) -> list[int]:
        """A cell anywhere in the frame of photons."""
        return [self.random.randint(0, self.shape.photons.fields[f"{axis}_0"].most) for axis in AXES]

    def near(self, centre: list[int], spread: int, most: int) -> list[int]:
        """A cell at most `spread` from a centre on each axis."""
        return [min(max(value + self.random.randint(-spread, spread), 0), most) for value in centre]

    def leaf(self, last: bool, chain: int) -> Beat:
        """A leaf of photons close together, near the centre of the set or, at times, anywhere."""
        fields = self.shape.photons.fields
        edge = 1 << self.shape.position_bits
        most = fields["x_0"].most
        middle = self.near(self.centre, edge, most) if self.happens(0.8) else self.point()
        # Half a leaf, which may be of one group, and a photon more are as frequent as all other numbers together.
        half = PHOTONS // 2
        photons = self.random.choice((half, half + 1, PHOTONS, self.random.randint(1, PHOTONS)))
        present = [place < photons for place in range(PHOTONS)]
        if self.happens(self.wrong.empty):
            present = [False] * PHOTONS
        elif self.happens(self.wrong.malformed):
            self.random.shuffle(present)
        # An absent photon has words too, which must not be looked at.
        values = {name: self.random.randint(0, field.most) for name, field in fields.items()}
        for place in range(PHOTONS):
            cell = self.near(middle, self.random.choice((2, edge // 4)), most)
            values |= {f"{axis}_{place}": value for axis, value in zip(AXES, cell)}
            values[f"present_{place}"] = int(present[place])
            if self.shape.has_exponent:
                values[f"exponent_{place}"] = self.random.randint(0, min(MOST_EXPONENT, fields["exponent_0"].most))
        values["facing"] = self.random.choice((0, 5, FACINGS - 1))
        word = self.shape.photons.pack(values)
        for bit in self.shape.photons.spare_bits():
            word |= self.random.getrandbits(1) << bit
        return Beat(word, chain, last)

    def query(self, last: bool, release: bool, chain: int) -> Beat:
        """A query near the centre of the set or, at times, anywhere."""
        most = self.shape.queries.fields["x"].most
        edge = 1 << (self.shape.position_bits + self.shape.extra_bits)
        centre = [value << self.shape.extra_bits for value in self.centre]
        cell = self.near(centre, edge, most) if self.happens(0.8) else self.near(centre, most, most)
        everything = (1 << FACINGS) - 1
        facings = everything if self.happens(0.6) else self.random.getrandbits(FACINGS)
        values = dict(zip(AXES, cell)) | {"tag": self.random.getrandbits(16), "facings": facings, "release": int(release)}
        if "radius_sq" in self.shape.queries.fields:
            # Of those near the field's end, most are above the largest radius.
            most = self.shape.queries.fields["radius_sq"].most
            least = most - (most >> 5) if self.happens(0.3) else 0
            values["radius_sq"] = self.random.randint(least, most)
        word = self.shape.queries.pack(values)
        if self.happens(self.wrong.outside):
            word |= 1 << self.random.choice(self.shape.queries.spare_bits())
        return Beat(word, chain, last)

    def set_of(self, chain: int, leaves: int) -> list[Beat]:
        """A set; now and then of more leaves than a bank holds."""
        if self.happens(self.wrong.too_long):
            leaves = self.shape.set_leaves + self.random.randint(1, 3)
        return [self.leaf(place == leaves - 1, chain) for place in range(leaves)]

    def batch(self, chain: int, release: bool) -> list[Beat]:
        """A batch, which `tlast` or the number of engines ends."""
        queries = self.random.randint(1, self.shape.engines)
        full = queries == self.shape.engines
        lasts = [False] * (queries - 1) + [not full or self.happens(0.7)]
        releasing = self.random.randrange(queries) if release else None
        return [self.query(last, place == releasing, chain) for place, last in enumerate(lasts)]

    def unknown(self, beats: list[Beat]) -> list[Beat]:
        """The words, with words for a chain that there is not between them where `tdest` can name one."""
        bits = max(1, (self.shape.chains - 1).bit_length())
        others = range(self.shape.chains, 1 << bits)
        mixed = []
        for beat in beats:
            if others and self.happens(self.wrong.unknown_chain):
                mixed.append(Beat(beat.word, self.random.choice(others), self.happens(0.5)))
            mixed.append(beat)
        return mixed

    def mix(self, parts: list[list[Beat]]) -> list[Beat]:
        """The words of all parts, each part in its order."""
        turns = [number for number, part in enumerate(parts) for _ in part]
        self.random.shuffle(turns)
        rests = [iter(part) for part in parts]
        return self.unknown([next(rests[turn]) for turn in turns])

    def round(self, sizes: Sizes, chains: list[int] | None = None) -> tuple[list[Beat], list[Beat]]:
        """A set for each of the chains and the batches that gather it; the last of them releases it."""
        sets, batches = [], []
        for chain in chains if chains is not None else range(self.shape.chains):
            self.centre = self.point()
            sets.append(self.set_of(chain, self.random.randint(*sizes.leaves)))
            number = self.random.randint(*sizes.batches)
            batches.append([query for place in range(number) for query in self.batch(chain, place == number - 1)])
        return self.mix(sets), self.mix(batches)
