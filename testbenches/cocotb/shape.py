"""The shape of a core and the words of its streams, as `photoncube generate --chains` wrote them."""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Field:
    """Bits of a word: `width` of them from bit `low` on."""

    low: int
    width: int

    @property
    def most(self) -> int:
        """The largest value of the field."""
        return (1 << self.width) - 1


@dataclass(frozen=True)
class Word:
    """A stream's word: its length and its fields by name."""

    bits: int
    fields: dict[str, Field]

    def pack(self, values: dict[str, int]) -> int:
        """The word with these values; fields that are not named are 0."""
        word = 0
        for name, value in values.items():
            field = self.fields[name]
            assert 0 <= value <= field.most, f"{name} = {value} does not fit {field.width} bits"
            word |= value << field.low
        return word

    def values(self, word: int) -> dict[str, int]:
        """The values of all fields of a word."""
        return {name: word >> field.low & field.most for name, field in self.fields.items()}

    def spare_bits(self) -> list[int]:
        """The bits that no field has."""
        used = {field.low + bit for field in self.fields.values() for bit in range(field.width)}
        return [bit for bit in range(self.bits) if bit not in used]


@dataclass(frozen=True)
class Shape:
    """What the tests must know of a core."""

    core: str
    chains: int
    engines: int
    set_leaves: int
    digest: int
    photons: Word
    queries: Word
    results: Word
    registers: dict[str, int]
    position_bits: int
    extra_bits: int
    channels: tuple[str, ...]

    @property
    def top(self) -> str:
        """The name of the top module."""
        return "photoncube_" + self.core.replace("-", "_")

    @property
    def has_exponent(self) -> bool:
        """Whether each photon has an exponent."""
        return "exponent_0" in self.photons.fields


def read_shape(path: Path) -> Shape:
    """Reads the `.streams.json` of a core. The rules of distance follow from the format in the machine's name:
    `local` p [`x` x] are the bits of a position and the further bits of a query."""
    layout = json.loads(path.read_text())
    name = re.search(r"-local(\d+)(?:x(\d+))?-", layout["machine"])
    assert name, f"found machine {layout['machine']}, expected one of a local format"

    def word(stream: str) -> Word:
        fields = {row["name"]: Field(row["low"], row["width"]) for row in layout[stream]["fields"]}
        return Word(layout[stream]["bits"], fields)

    results = word("results")
    return Shape(
        core=layout["core"],
        chains=layout["chains"],
        engines=layout["engines"],
        set_leaves=layout["set_leaves"],
        digest=int(layout["digest"], 16),
        photons=word("photons"),
        queries=word("queries"),
        results=results,
        registers=layout["registers"],
        position_bits=int(name[1]),
        extra_bits=int(name[2] or 0),
        channels=tuple(name for name in results.fields if name not in ("count", "tag", "radius_sq")),
    )
