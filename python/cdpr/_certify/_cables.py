"""Cables of a scene, and all shapes that each can take, from the scene's plain data.

A cable leaves the frame anywhere in a cube around its outlet, with a half side of ``outlet_error``, or in such a cube around any point
where it can leave its pulley, and hangs below the straight line between its ends. A cable of weight w per length, at the tension T in its middle and at the distances a and b along the line from both
ends, hangs lower by at most w a b / (2 T) (1 + w L / (4 T)), where L is the greatest length of the line. Bounds on that are rounded down,
which proves less.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from typing import Any

from ._hulls import Hull, nearest_points
from ._pulleys import Box, Pulley, inward
from ._vectors import ON_SURFACE, Exact, Vector, dot, exact, minus, or_default, plus, root_of, scaled, squared

KEYS = {"name", "outlet", "attachment", "tension", "diameter", "length"}
SHARED_KEYS = {"linear_density", "sag_tension", "outlet_error", "pulley", "stiffness", "drum"}
MOST_SLACKNESS = 0.2  # weight of the longest line as a share of the tension: the bound on the sag holds up to here
NEAR = 2  # the exits count lowered if an obstacle is farther from them than this multiple of it, otherwise the attachment does
TIE = 1e-8  # m: where the two are this close, rounding might choose the wrong bound, and only the straight line counts
DETOUR = Fraction("5.141592654")  # a little more than half a turn and the width of a wheel: π + 2, in radii

@dataclass(frozen=True)
class Sag:
    """How a cable hangs: the unit vector against gravity, the bound is `curvature` a b, the greatest length, m, and a box around all lines."""

    up: Vector
    curvature: float
    longest: float
    lines: Box

    def lower(self, a: float) -> float:
        """How far the line hangs down at most at a distance from one end, m."""
        return self.curvature * a * (self.longest - a)

    def lowering(self, reach: float) -> float:
        """How much lower one end must count for the line from there to the other end to be below the cable up to a distance, m."""
        return self.curvature * min(max(reach, 0.0), self.longest) * self.longest

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
    wheel: Pulley | None

    @property
    def pulley(self) -> bool:
        """Whether it runs round a pulley, so that a straight line from the outlet may not be one of its shapes."""
        return self.detour > 0

    @property
    def detour(self) -> Fraction:
        """How much longer than a straight line from the outlet the cable is at most, m."""
        return DETOUR * Fraction(self.wheel.radius) if self.wheel else Fraction(0)

    @cached_property
    def middle_exit(self) -> tuple[Exact, Fraction]:
        """The middle of all points where the cable can leave its pulley, and how far from it they are at most."""
        x, y, z = (sum(axis, Fraction(0)) / len(self.exits) for axis in zip(*self.exits, strict=True))
        middle = (x, y, z)
        return middle, max(root_of(squared(minus(exit_, middle)), 1) for exit_ in self.exits)

    def lowered(self, points: tuple[Exact, ...], by: float | None = None) -> tuple[Exact, ...]:
        """The points at one end, and how low they count: by default, so low that the whole cable is above the line from there."""
        if self.sag is None:
            return points
        rise = self.sag.upward(self.sag.lowering(self.sag.longest) if by is None else by)
        return (*points, *(minus(p, rise) for p in points))

    def near(self, part: Hull, gap: float, mounted: bool) -> tuple[tuple[Exact, ...], tuple[Exact, ...]]:
        """What bounds the cable near a part of an obstacle: exits, and attachments (at the position 0).

        Either the exits count lowered so far that the cable is above the line from there where it can reach the part, or, near the
        exits, the attachment counts lowered. An obstacle on which the outlet is `mounted` is seen from the outlet alone.
        """
        ends, sag = (self.arm,), self.sag
        leaving = (self.outlet,) if mounted else self.exits
        if sag is None:
            return leaving, ends
        exits = Hull(leaving).floats
        deepest = sag.curvature * sag.longest**2 / 4
        x, y, z = (deepest * u for u in sag.up)
        whole = [*part.floats, *((p[0] + x, p[1] + y, p[2] + z) for p in part.floats)]
        near = _boxes_apart(exits, whole) - gap
        reach = max(math.dist(e, v) for e in exits for v in part.floats) + deepest + gap
        common = [(max(s[0] - gap, t[0]), min(s[1] + gap, t[1])) for s, t in zip(_box(whole), sag.lines, strict=True)]
        farthest = math.hypot(*(max(s[1] - t[0], t[1] - s[0]) for s, t in zip(common, _box(exits), strict=True)))
        fall = sag.lowering(min(farthest, reach)) if all(low <= high for low, high in common) else 0.0
        if abs(near - NEAR * fall) <= TIE and not mounted:
            return leaving, ends
        if near > NEAR * fall and not mounted:
            return self.lowered(leaving, fall), ends
        return leaving, self.lowered(ends, sag.lowering(sag.longest - near))


def cable_of(scene: Mapping[str, Any], index: int, arm: Exact, parts: Sequence[Hull]) -> Cable:
    """Return a cable of a scene, given its arm, and the platform's parts in the platform's frame."""
    spec, shared = scene["robot"]["cables"][index], scene["robot"].get("cable") or {}
    unknown = sorted(set(spec) - KEYS - SHARED_KEYS | set(shared) - SHARED_KEYS)
    if unknown:
        raise ValueError(f"scene: robot.cables[{index}] has the key {unknown[0]!r}, which this checker does not know")
    given = {key: or_default(spec.get(key), shared.get(key)) for key in SHARED_KEYS}
    outlet, error = exact(spec["outlet"]), Fraction(given["outlet_error"] or 0)
    cube = [scaled(exact(signs), error) for signs in product((-1, 1), repeat=3)] if error else [exact((0, 0, 0))]
    pulley = None if given["pulley"] is None else Pulley(Hull((outlet,)).floats[0], given["pulley"])
    attachments = _attachments(scene["workspace"], exact(spec["attachment"]), parts)

    def exits_towards(lower: Vector) -> tuple[Exact, ...]:
        """Where the cable leaves the frame, taut, to attachments or to points lower than these by at most a vector."""
        exact_exits = [outlet]
        if pulley is not None:
            aims = [(low - float(error), high + float(error)) for low, high in attachments]
            x, y, z = ((low + min(by, 0.0), high + max(by, 0.0)) for (low, high), by in zip(aims, lower, strict=True))
            exact_exits = [exact(p) for p in inward(pulley.exits((x, y, z)))]
        return tuple(plus(p, corner) for p in exact_exits for corner in cube)

    tension, length = spec.get("tension"), tuple(spec.get("length") or (0.0, math.inf))
    gravity = [float(x) for x in or_default(scene.get("gravity"), (0, 0, -9.81))]
    weight = (given["linear_density"] or 0.0) * math.hypot(*gravity)
    sag = None
    if weight > 0:
        kept = or_default(given["sag_tension"], tension[0] if tension else None)
        x, y, z = (-x / math.hypot(*gravity) for x in gravity)
        # Where the cable leaves its pulley depends on the sag, and the greatest length on where it leaves.
        reach = math.hypot(*(max(high - o, o - low) for (low, high), o in zip(attachments, map(float, outlet), strict=True)))
        reach += float(error) + (2 * pulley.radius if pulley else 0.0)
        deepest = MOST_SLACKNESS / 2 * (1 + MOST_SLACKNESS / 4) * reach
        exits = exits_towards((-deepest * x, -deepest * y, -deepest * z))
        sag = _sag(attachments, Hull(exits).floats, (x, y, z), (weight, kept or 0.0))
        deepest = sag.lowering(sag.longest)
        exits = exits_towards((-deepest * x, -deepest * y, -deepest * z)) if pulley else exits
    else:
        exits = exits_towards((0.0, 0.0, 0.0))
    limits = max(length[0], ON_SURFACE), length[1]
    return Cable(outlet, arm, (spec.get("diameter") or 0.0) / 2, limits, tension, exits, sag, pulley)


def _attachments(workspace: Mapping[str, Any], attachment: Exact, parts: Sequence[Hull]) -> Box:
    """A box that contains the attachment while the platform is in the workspace."""
    outside = min(nearest_points(Hull((attachment,)), part)[1] for part in parts)
    x, y, z = ((low - outside, high + outside) for low, high in zip(workspace["min"], workspace["max"], strict=True))
    return x, y, z


def _sag(sides: Box, exits: list[Vector], up: Vector, load: tuple[float, float]) -> Sag:
    """How a cable hangs whose attachment is in a box; `load`: its weight, the tension kept."""
    weight, kept = load
    corners = [(x, y, z) for x in sides[0] for y in sides[1] for z in sides[2]]
    longest = max(math.dist(exit_, corner) for exit_ in exits for corner in corners)
    tension = kept + weight / 2 * (min(dot(up, p) for p in exits) - max(dot(up, p) for p in corners))
    if not (kept > 0 and tension > 0 and weight * longest <= MOST_SLACKNESS * tension):
        raise ValueError("scene: found a cable that hangs too low for the bound on its sag, expected one that is nearly straight")
    lines = _box([*exits, *corners])
    return Sag(up, weight / (2 * tension) * (1 + weight * longest / (4 * tension)), longest, lines)


def _box(points: Sequence[Vector]) -> Box:
    """Return the extent of points along each axis."""
    x, y, z = ((min(p[k] for p in points), max(p[k] for p in points)) for k in range(3))
    return x, y, z


def _boxes_apart(a: list[Vector], b: list[Vector]) -> float:
    """Return the distance of the boxes around two sets of points, m."""
    return math.hypot(*(max(s[0] - t[1], t[0] - s[1], 0.0) for s, t in zip(_box(a), _box(b), strict=True)))
