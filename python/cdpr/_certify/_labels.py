"""Labels of pieces of edges: lower bounds of the distance from the start, up to STEP for each bend.

A label may be anything up to the straight distance from the start. For any other piece and each one that may come before
it, one of these must hold, or the certificate is refused:

- The label grows no faster than the distance along some unit vector. That is linear, so the ends decide.
- One region blocks all segments between the two pieces.
- The pieces are on one line, or a path cannot bend at one of them towards the other. It can only if, from the other one,
  exactly one of the planes that meet in the edge is seen from outside.
- With the straight way to the goal, the path is too long.

All numbers are at most 1000, so rounding errors are below 1e-11, far less than the reserve of every decision.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ._bends import NEAR, NO_DIRECTION, Bends, Row, _between, unit
from ._certificate import Bound
from ._vectors import Vector, dot, minus

STEP = 2e-8  # m: how much a label may exceed the length of a path for each bend
LACKING = 1.9e-8  # m: accepted shortfall of the inequality of two labels; STEP also covers 2 NEAR and rounding
DEPTH = 5e-10  # m: depth from which a place counts as inside a region
LEVEL = 1e-9  # m: what counts as on a plane
BESIDE = 1 / 16

assert LACKING + 2 * NEAR + 1e-10 < STEP


@dataclass(frozen=True)
class Piece:
    """A piece of an edge or a corner, labels at both ends, and the planes that a bend crosses (none: unknown)."""

    ends: tuple[Vector, Vector]
    labels: tuple[float, float]
    planes: tuple[Row, ...] = ()


def pieces_of(proof: Bound, bends: Bends) -> Iterator[Piece]:
    for k, planes in bends.edges.items():
        at, (a, b) = 0.0, proof.edges[k].ends
        for end, *labels in proof.edges[k].pieces:
            yield Piece((_between(a, b, at), _between(a, b, end)), (labels[0], labels[1]), planes)
            at = end
    for x, y, z, label in (proof.corners[k] for k in bends.corners):
        yield Piece(((x, y, z), (x, y, z)), (label, label))


def check_labels(proof: Bound, bends: Bends) -> None:
    enough = proof.length + STEP * (bends.count + 2)
    start = Piece((proof.start, proof.start), (0.0, 0.0))
    goal = Piece((proof.goal, proof.goal), (enough, enough))
    sources = [start, *pieces_of(proof, bends)]
    targets = [piece for piece in (*sources[1:], goal) if not _grows_slowly(start, piece)]
    highest = {id(piece): _highest(proof, piece) for piece in [*sources, goal]}
    for a in sources:
        recent = 0
        for b in targets:
            if a is b or _grows_slowly(a, b) or not (_may_bend(a, b) and _may_bend(b, a)):
                continue
            blocks = [recent, *range(len(proof.regions))] if proof.regions else []
            above = highest[id(a)], highest[id(b)]
            recent = next((k for k in blocks if _blocks(above[0][k], above[1][k])), -1)
            if recent < 0 and not _is_too_long(a, b, proof.goal, enough):
                what = "the goal" if b is goal else f"the piece around {_between(*b.ends, 0.5)}"
                raise ValueError(
                    f"edges: found the label {sum(b.labels) / 2} of {what}, expected what it can be after the piece around "
                    f"{_between(*a.ends, 0.5)}, or less"
                )
            recent = max(recent, 0)


def _grows_slowly(a: Piece, b: Piece) -> bool:
    return any(_lacking(a, b, u) <= LACKING for u in _units(a, b))


def _units(a: Piece, b: Piece) -> Iterator[Vector]:
    """Unit vectors that may prove something: tangents in the middle of b and near a, that between nearest points, and zero."""
    yield _tangent(a, b, 0.5)
    s, t = _nearest(a.ends, b.ends)
    yield _tangent(a, b, min(max(t, BESIDE), 1 - BESIDE))
    yield unit(minus(_between(*b.ends, t), _between(*a.ends, s)))
    yield 0.0, 0.0, 0.0


def _lacking(a: Piece, b: Piece, u: Vector) -> float:
    """By how much the labels grow more than along a unit vector, m."""
    until = [label - dot(u, end) for label, end in zip(b.labels, b.ends, strict=True)]
    since = [label - dot(u, end) for label, end in zip(a.labels, a.ends, strict=True)]
    return max(until) - min(since)


def _is_too_long(a: Piece, b: Piece, goal: Vector, enough: float) -> bool:
    ahead = unit(minus(goal, _between(*b.ends, 0.5)))
    left = tuple(enough - dot(ahead, minus(goal, end)) for end in b.ends)
    until = Piece(b.ends, (left[0], left[1]))
    return any(_lacking(a, until, u) <= 0 for u in _units(a, b))


def _tangent(a: Piece, b: Piece, share: float) -> Vector:
    """Return the unit vector in whose direction a place of b is reached soonest from a, given the label of a."""
    y, way = _between(*b.ends, share), minus(a.ends[1], a.ends[0])
    length, to = math.hypot(*way), minus(y, a.ends[0])
    if length <= NO_DIRECTION:
        return unit(to)
    along = way[0] / length, way[1] / length, way[2] / length
    slope = min(max((a.labels[1] - a.labels[0]) / length, -1.0), 1.0)
    foot, flat = dot(to, along), math.sqrt(1 - slope * slope)
    height = math.dist(to, _between((0.0, 0.0, 0.0), along, foot))
    nearest = foot - slope * height / flat if flat > 1e-6 else -slope * math.inf
    nearest = min(max(nearest, 0.0), length)
    ahead = minus(to, _between((0.0, 0.0, 0.0), along, nearest))
    return unit(ahead) if math.hypot(*ahead) > NO_DIRECTION else _between((0.0, 0.0, 0.0), along, slope)


def _nearest(a: Sequence[Vector], b: Sequence[Vector]) -> tuple[float, float]:
    """Return the fractions at which two segments are nearest."""
    v, w, gap = minus(a[1], a[0]), minus(b[1], b[0]), minus(b[0], a[0])
    vv, ww, vw = dot(v, v), dot(w, w), dot(v, w)

    def onto(x: float, square: float) -> float:
        return min(max(x / square, 0.0), 1.0) if square > 0 else 0.0

    s, t = onto(dot(gap, v) * ww - dot(gap, w) * vw, vv * ww - vw * vw), 0.0
    for _ in range(2):
        t = onto(s * vw - dot(gap, w), ww)
        s = onto(t * vw + dot(gap, v), vv)
    return s, t


def _height(row: Row, p: Vector) -> float:
    return row[0] * p[0] + row[1] * p[1] + row[2] * p[2] - row[3]


def _highest(proof: Bound, piece: Piece) -> list[list[float]]:
    """For each region the larger height of both ends over each plane."""
    a, b = piece.ends
    return [[max(_height(row, a), _height(row, b)) for row in region.half_spaces] for region in proof.regions]


def _blocks(a: Sequence[float], b: Sequence[float]) -> bool:
    """Tell whether at some fraction of the way these heights, which change linearly, are all below zero."""
    low, high = 0.0, 1.0
    for x, y in zip(a, b, strict=True):
        if x + DEPTH >= 0 and y + DEPTH >= 0:
            return False
        if x + DEPTH > 0:
            low = max(low, (x + DEPTH) / (x - y))
        elif y + DEPTH > 0:
            high = min(high, (x + DEPTH) / (x - y))
    middle = (low + high) / 2
    return all(x + middle * (y - x) < -DEPTH / 2 for x, y in zip(a, b, strict=True))


def _may_bend(at: Piece, other: Piece) -> bool:
    """Tell whether a shortest path may bend at a piece towards another one: from somewhere there one of both planes is seen."""
    if not at.planes:
        return True
    if set(at.planes) == set(other.planes):
        return False  # on one line, which paths cross
    a, b = ([_height(row, end) for end in other.ends] for row in at.planes)
    return _meet(a, [-x for x in b]) or _meet(b, [-x for x in a])


def _meet(a: Sequence[float], b: Sequence[float]) -> bool:
    """Tell whether two linear functions are at most LEVEL at a common fraction."""
    low, high = 0.0, 1.0
    for x, y in (a, b):
        if x > LEVEL and y > LEVEL:
            return False
        if x > LEVEL:
            low = max(low, (x - LEVEL) / (x - y) - 1e-9)
        elif y > LEVEL:
            high = min(high, (x - LEVEL) / (x - y) + 1e-9)
    return low <= high
