"""Cables of a scene, and all shapes that each can take, from the scene's plain data.

A cable leaves the frame anywhere in a cube around its outlet, with a half side of ``outlet_error``, and hangs below the straight line
between its ends. A cable of weight w per length, at the tension T in its middle and at the distances a and b along the line from both
ends, hangs lower by at most w a b / (2 T) (1 + w L / (4 T)), where L is the greatest length of the line. Bounds on that are rounded down,
which proves less.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from typing import Any

from ._hulls import Hull, nearest_points
from ._vectors import ON_SURFACE, Exact, Vector, dot, exact, minus, or_default, plus, scaled

KEYS = {"name", "outlet", "attachment", "tension", "diameter", "length"}
SHARED_KEYS = {"linear_density", "sag_tension", "outlet_error", "pulley", "stiffness", "drum"}
MOST_SLACKNESS = 0.2  # weight of the longest line as a share of the tension: the bound on the sag holds up to here
NEAR = 2  # the sag at an obstacle is bounded by its largest value there if the exits are farther than this multiple
TIE = 1e-9  # m: where the two are this close, rounding might choose the wrong bound, and only the straight line counts


@dataclass(frozen=True)
class Sag:
    """How a cable hangs: the unit vector against gravity, the bound is `curvature` a b, and the greatest length, m."""

    up: Vector
    curvature: float
    longest: float

    def lower(self, a: float) -> float:
        """How far the line hangs down at most at a distance from one end, m."""
        return self.curvature * a * (self.longest - a)

    def between(self, near: float, far: float) -> float:
        """How far it hangs down at most where the distance from the exit is in an interval, m."""
        near = max(near, 0.0)
        return self.lower(min(min(max(self.longest / 2, near), max(far, near)), self.longest))

    def upward(self, bound: float) -> Exact:
        """The vector upward, a little shorter than a bound, by more than rounding errors."""
        return scaled(exact(self.up), Fraction(max(bound * (1 - 1e-12) - 1e-12, 0.0)))


@dataclass(frozen=True)
class Cable:
    """A cable; the arm leads from the platform's origin to the attachment, in world axes."""

    outlet: Exact
    arm: Exact
    radius: float
    length: tuple[float, float]
    tension: tuple[float, float] | None
    exits: tuple[Exact, ...]
    sag: Sag | None

    def lowered(self, points: tuple[Exact, ...]) -> tuple[Exact, ...]:
        """The points at one end, and how low they count, since the cable can leave its other end lower than the line."""
        if self.sag is None:
            return points
        rise = self.sag.upward(self.sag.curvature * self.sag.longest**2)
        return (*points, *(minus(p, rise) for p in points))

    def near(self, part: Hull, gap: float) -> tuple[tuple[Exact, ...], tuple[Exact, ...], Hull]:
        """What bounds the cable near a part of an obstacle: exits, attachments (at the position 0), and the part.

        Either the part counts swept upward by how far the cable hangs down there, or, near the exits, the attachment counts lowered.
        """
        ends, sag = (self.arm,), self.sag
        if sag is None:
            return self.exits, ends, part
        exits = Hull(self.exits).floats
        deepest = sag.lower(sag.longest / 2)
        x, y, z = (deepest * u for u in sag.up)
        near = _boxes_apart(exits, [*part.floats, *((p[0] + x, p[1] + y, p[2] + z) for p in part.floats)]) - gap
        rise = sag.between(near, max(math.dist(e, v) for e in exits for v in part.floats) + deepest + gap)
        if abs(near - NEAR * rise) <= TIE:
            return self.exits, ends, part
        if near < NEAR * rise:
            return self.exits, self.lowered(ends), part
        upward = sag.upward(rise)
        return self.exits, ends, Hull((*part.points, *(plus(p, upward) for p in part.points)))


def cable_of(scene: Mapping[str, Any], index: int, arm: Exact, parts: Sequence[Hull]) -> Cable:
    """Return a cable of a scene, given its arm, and the platform's parts in the platform's frame."""
    spec, shared = scene["robot"]["cables"][index], scene["robot"].get("cable") or {}
    unknown = sorted(set(spec) - KEYS - SHARED_KEYS | set(shared) - SHARED_KEYS)
    if unknown:
        raise ValueError(f"scene: robot.cables[{index}] has the key {unknown[0]!r}, which this checker does not know")
    given = {key: or_default(spec.get(key), shared.get(key)) for key in SHARED_KEYS}
    if given["pulley"] is not None:
        raise ValueError(f"scene: robot.cables[{index}] runs round a pulley, about which certificates prove nothing")
    outlet, error = exact(spec["outlet"]), Fraction(given["outlet_error"] or 0)
    signs = (exact(signs) for signs in product((-1, 1), repeat=3))
    exits = tuple(plus(outlet, scaled(sign, error)) for sign in signs) if error else (outlet,)
    tension, length = spec.get("tension"), tuple(spec.get("length") or (0.0, math.inf))
    sag = None
    gravity = [float(x) for x in or_default(scene.get("gravity"), (0, 0, -9.81))]
    weight = (given["linear_density"] or 0.0) * math.hypot(*gravity)
    if weight > 0:
        kept = or_default(given["sag_tension"], tension[0] if tension else None)
        outside = min(nearest_points(Hull((exact(spec["attachment"]),)), part)[1] for part in parts)
        up = [-x / math.hypot(*gravity) for x in gravity]
        sag = _sag(scene["workspace"], Hull(exits).floats, outside, (up[0], up[1], up[2]), (weight, kept or 0.0))
    limits = max(length[0], ON_SURFACE), length[1]
    return Cable(outlet, arm, (spec.get("diameter") or 0.0) / 2, limits, tension, exits, sag)


def _sag(workspace: Mapping[str, Any], exits: list[Vector], outside: float, up: Vector, load: tuple[float, float]) -> Sag:
    """How a cable hangs whose attachment is in the workspace or at most `outside` beyond; `load`: its weight, the tension kept."""
    weight, kept = load
    sides = [(low - outside, high + outside) for low, high in zip(workspace["min"], workspace["max"], strict=True)]
    corners = [(x, y, z) for x in sides[0] for y in sides[1] for z in sides[2]]
    longest = max(math.dist(exit_, corner) for exit_ in exits for corner in corners)
    tension = kept + weight / 2 * (min(dot(up, p) for p in exits) - max(dot(up, p) for p in corners))
    if not (kept > 0 and tension > 0 and weight * longest <= MOST_SLACKNESS * tension):
        raise ValueError("scene: found a cable that hangs too low for the bound on its sag, expected one that is nearly straight")
    return Sag(up, weight / (2 * tension) * (1 + weight * longest / (4 * tension)), longest)


def _boxes_apart(a: list[Vector], b: list[Vector]) -> float:
    """Return the distance of the boxes around two sets of points, m."""
    sides = [[(min(p[k] for p in points), max(p[k] for p in points)) for k in range(3)] for points in (a, b)]
    return math.hypot(*(max(s[0] - t[1], t[0] - s[1], 0.0) for s, t in zip(*sides, strict=True)))
