"""Exact vertices of regions, and distances of convex hulls (found in floats, verified exactly)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from typing import TypeAlias

from ._vectors import Exact, Vector, cross, dot, exact, interpolated, minus, plus, root_of, scaled, squared

Pair: TypeAlias = tuple[int, int]

DISTANCE_ROUNDING = 1e-14  # largest error of a distance, as a share of the largest coordinate


def clipped(box: Sequence[float], half_spaces: Sequence[Sequence[float]]) -> list[Exact]:
    """Return the vertices of a box cut by half-spaces n·x <= d; none if what remains has no volume."""
    return list(clipped_on_planes(box, half_spaces))


def clipped_on_planes(box: Sequence[float], half_spaces: Sequence[Sequence[float]]) -> dict[Exact, set[int]]:
    """Return the vertices with the half-spaces in whose planes they lie; negative numbers are sides of the box."""
    # Each vertex with the planes through it. Two vertices share an edge if no third lies on all of their common planes.
    corners = {exact([box[i] for i in sides]): {-1 - i for i in sides} for sides in product((0, 3), (1, 4), (2, 5))}
    vertices = list(corners.items())
    for k, plane in enumerate(half_spaces):
        n, d = exact(plane[:3]), Fraction(plane[3])
        above = [(dot(n, v) - d, v, planes) for v, planes in vertices]
        if all(height >= 0 for height, *_ in above):
            return {}
        kept = [(v, planes if height < 0 else planes | {k}) for height, v, planes in above if height <= 0]
        for low, high in product([row for row in above if row[0] < 0], [row for row in above if row[0] > 0]):
            common = low[2] & high[2]
            if len(common) >= 2 and sum(common <= planes for _, planes in vertices) == 2:
                kept.append((interpolated(low[1], high[1], low[0] / (low[0] - high[0])), common | {k}))
        vertices = kept
    return dict(vertices)


@dataclass(frozen=True)
class Hull:
    """The convex hull of points."""

    points: tuple[Exact, ...]

    @cached_property
    def floats(self) -> list[Vector]:
        return [(float(x), float(y), float(z)) for x, y, z in self.points]

    def support(self, x: Vector) -> int:
        """Return the index of the point farthest along x."""
        heights = [x[0] * p[0] + x[1] * p[1] + x[2] * p[2] for p in self.floats]
        return heights.index(max(heights))


def are_near(a: Hull, b: Hull, gap: Fraction) -> bool:
    """Tell whether two hulls are at most `gap` apart; exact both ways, since what touches at an end is excused elsewhere.

    Two points prove that they are, two planes across the direction between these that they are not. If neither does, as
    for needles and thin plates where rounding misleads the search, an exact search decides.
    """
    if gap < 0:
        return False
    weights, distance = _guess(a, b, 0.999 * float(gap))
    if distance <= 2 * float(gap) and are_near_at(weights, a, b, gap):
        return True
    across = exact(_between_floats(a, b, weights))
    apart = min(dot(across, p) for p in a.points) - max(dot(across, p) for p in b.points)
    if apart > 0 and apart**2 > gap**2 * squared(across):
        return False
    return _squared_distance(a, b) <= gap**2


def are_near_at(weights: dict[Pair, float], a: Hull, b: Hull, gap: Fraction) -> bool:
    """Tell whether the two points of the hulls with these nonnegative weights are at most `gap` apart; exact."""
    between = _between(a, b, {pair: Fraction(w) for pair, w in weights.items()})
    return gap >= 0 and squared(between) <= (gap * sum(map(Fraction, weights.values()))) ** 2


def nearest_points(a: Hull, b: Hull) -> tuple[dict[Pair, float], float]:
    """Nonnegative weights of point pairs that give about nearest points of two hulls, and the distance up to rounding errors."""
    weights, distance = _guess(a, b, 0.0)
    size = max(abs(x) for p in (*a.floats, *b.floats) for x in p)
    across = _between_floats(a, b, weights)
    apart = min(dot(across, p) for p in a.floats) - max(dot(across, p) for p in b.floats)
    if distance > DISTANCE_ROUNDING * size and distance - apart / distance > DISTANCE_ROUNDING * size:
        distance = float(root_of(_squared_distance(a, b), 0))
    return weights, distance


def _between_floats(a: Hull, b: Hull, weights: dict[Pair, float]) -> Vector:
    points = [(w, minus(a.floats[i], b.floats[j])) for (i, j), w in weights.items()]
    x, y, z = (sum(w * p[k] for w, p in points) for k in range(3))
    return x, y, z


def _between(a: Hull, b: Hull, weights: dict[Pair, Fraction]) -> Exact:
    between = exact((0, 0, 0))
    for (i, j), w in weights.items():
        between = plus(between, scaled(minus(a.points[i], b.points[j]), w))
    return between


def _squared_distance(a: Hull, b: Hull) -> Fraction:
    """The square of the distance of two hulls: Wolfe's algorithm in rationals, in which every step comes nearer, so it ends."""
    weights: dict[Pair, Fraction] = {(0, 0): Fraction(1)}
    while True:
        best = _between(a, b, weights)
        towards_a = [dot(best, p) for p in a.points]
        towards_b = [dot(best, p) for p in b.points]
        new = towards_a.index(min(towards_a)), towards_b.index(max(towards_b))
        square = squared(best)
        if square <= min(towards_a) - max(towards_b):
            return square
        weights = _exactly_nearest({**weights, new: Fraction(0)}, a, b)


def _exactly_nearest(weights: dict[Pair, Fraction], a: Hull, b: Hull) -> dict[Pair, Fraction]:
    """Return the weights of the point nearest to the origin of some face of a simplex, nearer than the given point or the same."""
    while True:
        goal = dict(zip(weights, _foot([minus(a.points[i], b.points[j]) for i, j in weights]), strict=True))
        steps = [weights[pair] / (weights[pair] - w) for pair, w in goal.items() if w < 0]
        step = min(steps, default=Fraction(1))
        moved = {pair: w + step * (goal[pair] - w) for pair, w in weights.items()}
        weights = {pair: w for pair, w in moved.items() if w > 0}
        if not steps:
            return weights


def _foot(points: list[Exact]) -> list[Fraction]:
    """Weights (sum 1) of the point nearest to the origin on the line, plane or space through one to four independent points."""
    edges, count = [minus(p, points[0]) for p in points[1:]], len(points) - 1
    rows = [[*(dot(e, f) for f in edges), -dot(e, points[0])] for e in edges]
    for k in range(count):
        pivot = next(i for i in range(k, count) if rows[i][k])
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        rows = [row if i == k else [x - row[k] * y for x, y in zip(row, rows[k], strict=True)] for i, row in enumerate(rows)]
    found = [row[-1] for row in rows]
    return [1 - sum(found, Fraction(0)), *found]


def _guess(a: Hull, b: Hull, enough: float) -> tuple[dict[Pair, float], float]:
    """Like :func:`nearest_points`, without a proof.

    The point of the hull of the differences nearest to the origin, by Wolfe's algorithm: add the point farthest towards
    the origin, go to the point nearest to the origin of the simplex's plane, and drop points whose weights become 0 on
    the way. Ends early at the distance `enough`.
    """
    weights: dict[Pair, float] = {(0, 0): 1.0}
    distance, best = math.inf, weights
    for _ in range(100):
        points = {(i, j): minus(a.floats[i], b.floats[j]) for i, j in weights}
        x, y, z = (sum(w * points[pair][k] for pair, w in weights.items()) for k in range(3))
        length = math.hypot(x, y, z)
        if not length < distance:  # no progress beyond rounding
            break
        distance, best = length, weights
        new = (a.support((-x, -y, -z)), b.support((x, y, z)))
        if distance <= enough or new in weights or len(weights) == 4:
            break
        points[new] = minus(a.floats[new[0]], b.floats[new[1]])
        weights = _nearest_of_simplex({**weights, new: 0.0}, points)
    return best, distance


def _nearest_of_simplex(weights: dict[Pair, float], points: dict[Pair, Vector]) -> dict[Pair, float]:
    """Return the weights of a point of a simplex at least as near to the origin, the nearest one of some face of the simplex."""
    while True:
        goal = dict(zip(weights, _nearest_of_plane([points[pair] for pair in weights]), strict=True))
        if all(w > 0 for w in goal.values()):
            return goal
        out = [pair for pair in weights if goal[pair] <= 0]
        steps = {pair: weights[pair] / (weights[pair] - goal[pair]) if weights[pair] else 0.0 for pair in out}
        first = min(out, key=lambda pair: steps[pair])
        ends = {pair: w + steps[first] * (goal[pair] - w) for pair, w in weights.items() if pair != first}
        weights = {pair: max(w, 0.0) for pair, w in ends.items()}


def _nearest_of_plane(points: list[Vector]) -> list[float]:
    """Return the weights (sum 1) of the point nearest to the origin on the line, plane or space through up to four points."""
    to = minus((0.0, 0.0, 0.0), points[0])
    edges = [minus(p, points[0]) for p in points[1:]]
    if len(edges) == 3:
        rows = [cross(edges[1], edges[2]), cross(edges[2], edges[0]), cross(edges[0], edges[1])]
        size = dot(edges[0], rows[0])
    elif len(edges) == 2:
        normal = cross(edges[0], edges[1])
        rows, size = [cross(edges[1], normal), cross(normal, edges[0])], dot(normal, normal)
    else:
        rows, size = edges, sum(map(squared, edges))
    found = [dot(row, to) / size if abs(size) > 1e-200 else 0.0 for row in rows]
    return [1 - sum(found), *found]
