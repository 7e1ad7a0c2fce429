"""Where a shortest path may bend: edges and corners of regions that no other region covers, in rationals.

A region looks like a cone from a point of its closure. A shortest path that bends there passes a cone whose section with
the plane of the bend is less than a half plane, so the point lies on an edge of that region. If another region's cone
contains this one, it takes its place; of equal cones the first one counts. A path crosses the edges it bends at, so it bends
at most once on each part of an edge outside all regions. It never bends at a corner that no other region or side of the
box touches. crates/cdpr-certify/src/bends.rs has the proofs.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations
from typing import TypeAlias

from ._certificate import Bound
from ._hulls import clipped_on_planes
from ._vectors import Exact, Vector, cross, dot, exact, interpolated, minus, squared

Row: TypeAlias = tuple[float, ...]
Gap: TypeAlias = tuple[Fraction, Fraction]

NEAR = 1e-10  # m: the listed place of a bend is at most this far from the bend
SURPLUS = 1e-9  # m: sums of lengths must exceed their limit by this, because of rounding
NO_DIRECTION = 1e-12  # m: the direction of a vector this short is not accurate enough
SEARCH_STEPS = 100


class Bends:
    """The listed places that a bound needs: rows of edges with the planes that a bend crosses, corners, and their number."""

    def __init__(self, proof: Bound) -> None:
        self.proof, self.count = proof, 0
        self.edges: dict[int, tuple[Row, ...]] = {}
        self.corners: set[int] = set()
        self.planes = [[(exact(row[:3]), Fraction(row[3])) for row in region.half_spaces] for region in proof.regions]
        for k in range(len(proof.regions)):
            try:
                self._find(k)
            except ValueError as problem:
                raise ValueError(f"regions[{k}]: {problem}") from None

    def _find(self, region: int) -> None:
        corners = clipped_on_planes(self.proof.box, self.proof.regions[region].half_spaces)
        own = {at: sorted(k for k in on if k >= 0) for at, on in corners.items()}
        ends = set()
        for a, b in combinations(corners, 2):
            on = corners[a] & corners[b]
            planes = sorted(k for k in on if k >= 0)
            if self._rank(region, planes) == 2 and sum(on <= planes_of for planes_of in corners.values()) == 2:
                ends |= {a, b}
                self._edge(region, planes, (a, b))
        for at, planes in own.items():
            rank = self._rank(region, planes)
            if rank == 3 or (rank == 2 and at not in ends):
                self._corner(region, planes, at, rank == 3 and min(corners[at]) >= 0)

    def _rank(self, region: int, planes: Sequence[int]) -> int:
        normals = [self.planes[region][k][0] for k in planes]
        lines = [line for n, m in combinations(normals, 2) if any(line := cross(n, m))]
        if not lines:
            return min(len(normals), 1)
        return 3 if any(dot(lines[0], n) for n in normals) else 2

    def _others(self, region: int, planes: Sequence[int]) -> Iterator[list[tuple[Exact, Fraction]]]:
        """For each region whose cone may contain this one's: its half-spaces that are not among these planes."""
        rows = {self.proof.regions[region].half_spaces[k] for k in planes}
        for k, other in enumerate(self.proof.regions):
            if k != region and (k < region or not rows <= set(other.half_spaces)):
                yield [h for h, row in zip(self.planes[k], other.half_spaces, strict=True) if row not in rows]

    def _edge(self, region: int, planes: list[int], ends: tuple[Exact, Exact]) -> None:
        covers = [cover for rest in self._others(region, planes) if (cover := _covered(rest, ends))]
        for gap in _gaps(covers):
            places = [interpolated(*ends, t) for t in gap]
            if self._is_too_far(places):
                continue
            self.count += 1
            for k, edge in enumerate(self.proof.edges):
                own = edge.region == region and edge.planes[0] != edge.planes[1] and set(edge.planes) <= set(planes)
                if own and all(_is_near(place, edge.ends) for place in places):
                    rows = tuple(self.proof.regions[region].half_spaces[j] for j in planes)
                    self.edges[k] = rows if len(rows) == 2 else ()
                    break
            else:
                self._expect_corner(places, "an edge that is free")

    def _corner(self, region: int, planes: list[int], at: Exact, inside: bool) -> None:
        def touches(half_spaces: Sequence[tuple[Exact, Fraction]]) -> bool:
            return all(dot(n, at) <= d for n, d in half_spaces)

        is_alone = inside and not any(touches(other) for k, other in enumerate(self.planes) if k != region)
        covered = any(all(dot(n, at) < d for n, d in rest) for rest in self._others(region, planes))
        if not (is_alone or covered or self._is_too_far([at, at])):
            self.count += 1
            self._expect_corner([at], "a corner that is free")

    def _expect_corner(self, places: Sequence[Exact], found: str) -> None:
        for k, (x, y, z, _) in enumerate(self.proof.corners):
            if all(_is_near(place, ((x, y, z), (x, y, z))) for place in places):
                self.corners.add(k)
                return
        raise ValueError(f"found {found} at {[float(x) for x in places[0]]}, expected it in the list")

    def _is_too_far(self, places: Sequence[Exact]) -> bool:
        """Tell whether all ways through a segment are as long as the bound: their length is convex, so a tangent decides."""
        ends = self.proof.start, self.proof.goal
        a, b = [(float(x), float(y), float(z)) for x, y, z in places]

        def via(t: float) -> float:
            return sum(math.dist(_between(a, b, t), end) for end in ends)

        low, high = 0.0, 1.0
        for _ in range(SEARCH_STEPS):
            s, t = low + (high - low) / 3, high - (high - low) / 3
            low, high = (low, t) if via(s) <= via(t) else (s, high)
        lowest = _between(a, b, min((0.0, (low + high) / 2, 1.0), key=via))
        units = [unit(minus(lowest, end)) for end in ends]
        tangent = [sum(dot(u, minus(x, end)) for u, end in zip(units, ends, strict=True)) for x in (a, b)]
        return min(tangent) >= self.proof.length + SURPLUS


def unit(v: Vector) -> Vector:
    size = math.hypot(*v)
    return (v[0] / size, v[1] / size, v[2] / size) if size > NO_DIRECTION else (0.0, 0.0, 0.0)


def _between(a: Vector, b: Vector, t: float) -> Vector:
    return a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t


def _covered(half_spaces: Sequence[tuple[Exact, Fraction]], ends: tuple[Exact, Exact]) -> Gap | None:
    """Return the open part of an edge inside half-spaces; it begins before 0 or ends after 1 if it contains that end."""
    low, high = Fraction(-1), Fraction(2)
    for n, d in half_spaces:
        a, b = (dot(n, end) - d for end in ends)
        if a >= 0 and b >= 0:
            return None
        if b >= 0:
            high = min(high, a / (a - b))
        elif a >= 0:
            low = max(low, a / (a - b))
    return (low, high) if low < high else None


def _gaps(covers: list[Gap]) -> list[Gap]:
    """Return the closed parts of an edge, perhaps single points, that open parts leave."""
    at, gaps = Fraction(0), []
    for low, high in sorted(covers):
        if at <= low and at <= 1:
            gaps.append((at, low))
        at = max(at, high)
    return [*gaps, (at, Fraction(1))] if at <= 1 else gaps


def _is_near(place: Exact, ends: tuple[Vector, Vector]) -> bool:
    """Tell whether a place is near a segment: the nearest point is guessed, the distance is exact."""
    along = minus(ends[1], ends[0])
    p = float(place[0]), float(place[1]), float(place[2])
    square = dot(along, along)
    share = min(max(dot(minus(p, ends[0]), along) / square, 0.0), 1.0) if square > 0 else 0.0
    at = interpolated(exact(ends[0]), exact(ends[1]), Fraction(share))
    return math.dist(p, tuple(map(float, at))) < 2 * NEAR and squared(minus(place, at)) <= Fraction(NEAR) ** 2
