"""The contents of a certificate: structure and numbers, nothing about the scene."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ._vectors import Vector

SHARED_KEYS = {"format", "version", "scene", "orientation", "margin", "start", "goal", "box", "regions"}
KEYS = SHARED_KEYS | {"boxes"}
BOUND_KEYS = SHARED_KEYS | {"length", "edges", "corners"}
MOST_BOUND_REGIONS, MOST_PIECES, MOST_LENGTH = 1_000, 10_000, 1000
MOST_BOXES, MOST_REGIONS, MOST_HALF_SPACES, MOST_WEAK_BOXES = 1_000_000, 10_000, 1_000, 10_000
MOST_NUMBER = 1e12


@dataclass(frozen=True)
class WeakBox:
    """A box of positions, and a direction of forces and moments in which the cables are said to be too weak.

    `direction` is the one at the centre, `slopes` its changes along x, y and z, per metre; `weight` is by how much more the cables lack
    per metre below the last half-space of the region. All are empty or zero if the box is said to contain no position that counts.
    """

    corners: tuple[float, ...]
    direction: tuple[float, ...]
    slopes: tuple[tuple[float, ...], ...]
    weight: float


@dataclass(frozen=True)
class Region:
    """Positions inside all half-spaces n·x < d, and the pair that is said to forbid them, or "wrench" and boxes."""

    who: tuple[str, ...]
    half_spaces: list[tuple[float, ...]]
    boxes: list[WeakBox]

    @property
    def lacks_wrench(self) -> bool:
        """Whether the cables are said to be too weak in it."""
        return self.who == ("wrench",)


class Question:
    """What both kinds of certificates share: scene, orientation, margin, ends, box and regions."""

    def __init__(self, file: Mapping[str, Any], name: str, keys: set[str], most_regions: int) -> None:
        if not isinstance(file, Mapping) or file.get("format") != name:
            raise ValueError(f"format: found another file, expected a table with \"format\": \"{name}\"")
        if type(file.get("version")) is not int or file["version"] != 1:
            raise ValueError(f"version: found {file.get('version')!r}, expected 1")
        _keys("certificate", file, keys)
        regions = _items("regions", file["regions"], most_regions)
        if not isinstance(file["scene"], str):
            raise ValueError(f"scene: found {type(file['scene']).__name__}, expected a fingerprint")
        self.margin = _numbers("margin", [file["margin"]], 1)[0]
        if not 1e-8 <= self.margin <= 1e-6:
            raise ValueError(f"margin: found {self.margin!r}, expected 1e-8 to 1e-6 m")
        self.orientation = _numbers("orientation", file["orientation"], 4)
        self.start, self.goal = (_point(key, file[key]) for key in ("start", "goal"))
        low, high = (_numbers("box", corner, 3) for corner in _items("box", file["box"], 2, 2))
        self.box = low + high
        if not all(low[k] < high[k] for k in range(3)):
            raise ValueError(f"box: found {list(low)} to {list(high)}, expected min < max along each axis")
        self.regions = [self._region(f"regions[{k}]", region) for k, region in enumerate(regions)]

    @staticmethod
    def _region(place: str, region: Any) -> Region:
        _keys(place, region, {"who", "half_spaces"}, frozenset({"boxes"}))
        planes = _items(f"{place}.half_spaces", region["half_spaces"], MOST_HALF_SPACES)
        boxes = _items(f"{place}.boxes", region.get("boxes", []), MOST_WEAK_BOXES)
        found = Region(
            _names(f"{place}.who", region["who"]),
            [_numbers(f"{place}.half_spaces", plane, 4) for plane in planes],
            [_weak_box(f"{place}.boxes[{k}]", box) for k, box in enumerate(boxes)],
        )
        if boxes and not found.lacks_wrench:
            raise ValueError(f"{place}: found boxes for {list(found.who)}, expected them for \"wrench\" alone")
        return found


class Certificate(Question):
    """A certificate that there is no path, checked for structure and numbers only."""

    def __init__(self, file: Mapping[str, Any]) -> None:
        super().__init__(file, "cdpr-proof", KEYS, MOST_REGIONS)
        boxes = _items("boxes", file["boxes"], MOST_BOXES)
        self.boxes: list[tuple[float, ...]] = []
        self.kinds: list[int] = []
        self.reasons: dict[int, tuple[Any, ...]] = {}
        for k, box in enumerate(boxes):
            self._add_box(f"boxes[{k}]", box)

    def _add_box(self, place: str, box: Any) -> None:
        items = _items(place, box, 8, 7)
        corners, kind = _numbers(place, items[:6], 6), items[6]
        if not all(corners[k] < corners[k + 3] for k in range(3)):
            raise ValueError(f"{place}: found {list(corners)}, expected min < max along each axis")
        if type(kind) is not int or not -2 <= kind < len(self.regions):
            raise ValueError(f"{place}: found region {kind!r}, expected -2 to {len(self.regions) - 1}")
        if (kind == -2) != (len(items) == 8):
            raise ValueError(f"{place}: expected a reason if and only if the region is -2")
        if kind == -2:
            reason = _items(f"{place} (reason)", items[7], 7, 1)
            wrench = len(reason) == 7 and reason[0] == "wrench"
            self.reasons[len(self.boxes)] = (
                ("wrench", *_numbers(f"{place} (reason)", reason[1:], 6)) if wrench else _names(place, reason)
            )
        self.boxes.append(corners)
        self.kinds.append(kind)


@dataclass(frozen=True)
class Edge:
    """A part of the edge of a region in which two half-spaces meet; pieces: where each ends, and labels at both ends."""

    region: int
    planes: tuple[int, int]
    ends: tuple[Vector, Vector]
    pieces: list[tuple[float, ...]]


class Bound(Question):
    """A certificate that no path is shorter than a length, checked for structure and numbers only."""

    def __init__(self, file: Mapping[str, Any]) -> None:
        super().__init__(file, "cdpr-bound", BOUND_KEYS, MOST_BOUND_REGIONS)
        self.length = _numbers("length", [file["length"]], 1)[0]
        self.edges = [
            self._edge(f"edges[{k}]", edge) for k, edge in enumerate(_items("edges", file["edges"], MOST_PIECES))
        ]
        self.corners = [_numbers("corners", corner, 4) for corner in _items("corners", file["corners"], MOST_PIECES)]
        small = [self.length, *self.start, *self.goal, *self.box, *(x for corner in self.corners for x in corner)]
        small += [row[3] for region in self.regions for row in region.half_spaces]
        small += [x for edge in self.edges for place in (*edge.ends, *edge.pieces) for x in place]
        if max(map(abs, small)) > MOST_LENGTH:
            raise ValueError(f"found {max(small, key=abs)!r}, expected numbers up to {MOST_LENGTH} m")
        for k, region in enumerate(self.regions):
            if any(abs(math.hypot(*row[:3]) - 1) > 1e-9 for row in region.half_spaces):
                raise ValueError(f"regions[{k}]: found a normal of another length, expected 1")
        if sum(len(edge.pieces) for edge in self.edges) > MOST_PIECES:
            raise ValueError(f"edges: found more than {MOST_PIECES} pieces")

    def _edge(self, place: str, edge: Any) -> Edge:
        _keys(place, edge, {"region", "planes", "ends", "pieces"})
        region, planes = edge["region"], _items(place, edge["planes"], 2, 2)
        if type(region) is not int or not 0 <= region < len(self.regions):
            raise ValueError(f"{place}: found region {region!r}, expected an index")
        count = len(self.regions[region].half_spaces)
        if any(type(k) is not int or not 0 <= k < count for k in planes):
            raise ValueError(f"{place}: found half-spaces {planes!r:.60}, expected two indices")
        a, b = (_point(place, end) for end in _items(place, edge["ends"], 2, 2))
        pieces = [_numbers(place, piece, 3) for piece in _items(place, edge["pieces"], MOST_PIECES, 1)]
        shares = [0.0, *(piece[0] for piece in pieces)]
        if shares != sorted(shares) or shares[-1] != 1:
            raise ValueError(f"{place}: found pieces that do not end one after another, the last one at 1")
        return Edge(region, (planes[0], planes[1]), (a, b), pieces)


def parsed(text: str) -> Any:
    def constant(token: str) -> None:
        raise ValueError(f"found {token}, expected finite numbers only")

    def table(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        if len(dict(pairs)) < len(pairs):
            raise ValueError("found a key twice in one table")
        return dict(pairs)

    try:
        return json.loads(text, parse_constant=constant, object_pairs_hook=table)
    except json.JSONDecodeError as problem:
        raise ValueError(f"not a JSON file, or a truncated one: {problem}") from None
    except RecursionError:
        raise ValueError("found tables within tables without end, expected a certificate") from None


def _weak_box(place: str, items: Any) -> WeakBox:
    row = _items(place, items, 31, 6)
    if len(row) not in (6, 31):
        raise ValueError(f"{place}: found {len(row)} numbers, expected 6 or 31")
    row = _numbers(place, row, len(row))
    if not all(row[k] < row[k + 3] for k in range(3)):
        raise ValueError(f"{place}: found {list(row[:6])}, expected min < max along each axis")
    slopes = tuple(row[k : k + 6] for k in (12, 18, 24)) if len(row) == 31 else ()
    return WeakBox(row[:6], row[6:12], slopes, row[30] if slopes else 0.0)


def _keys(place: str, table: Any, expected: set[str], optional: frozenset[str] = frozenset()) -> None:
    if not isinstance(table, Mapping):
        raise ValueError(f"{place}: found {type(table).__name__}, expected a table")
    for key in sorted((set(map(str, table)) ^ expected) - (optional & set(table))):
        raise ValueError(f"{place}: {'missing' if key in expected else 'unknown'} key {key!r}")


def _items(place: str, items: Any, most: int, least: int = 0) -> Sequence[Any]:
    if not isinstance(items, list | tuple):
        raise ValueError(f"{place}: found {type(items).__name__}, expected a list")
    if not least <= len(items) <= most:
        expected = f"{least} to {most}" if least else f"at most {most}"
        raise ValueError(f"{place}: found {len(items)} {place if place in KEYS else 'items'}, expected {expected}")
    return items


def _numbers(place: str, items: Any, count: int) -> tuple[float, ...]:
    for x in _items(place, items, count, count):
        if type(x) not in (int, float) or not abs(x) <= MOST_NUMBER:  # NaN compares false
            raise ValueError(f"{place}: found {x!r:.40}, expected numbers up to {MOST_NUMBER:g}")
    return tuple(map(float, items))


def _point(place: str, items: Any) -> Vector:
    x, y, z = _numbers(place, items, 3)
    return x, y, z


def _names(place: str, items: Any) -> tuple[str, ...]:
    if not all(isinstance(name, str) for name in _items(place, items, 2, 1)):
        raise ValueError(f"{place}: found {items!r:.60}, expected names of one or two members")
    return tuple(items)
