"""Where a cable can leave its last pulley, from the scene's plain data.

The cable meets the wheel of radius r at the outlet, in the direction of the axis, and touches it over the wrap angle w; the wheel swivels
about the axis towards the attachment. In its plane, with the distance from the axis first and the height above the outlet second, the
centre of the wheel is at (r, 0), and the exit at r (1 - cos w, sin w). The cable leads from there in the direction (sin w, cos w) to the
attachment (d, h). Its free length is f = √(d (d - 2 r) + h²), and tan(w / 2) = d / (h + f).

By the definition of a scene, a polytope bounds the exits to all attachments in a box: its corners are those of polygons around the arc
of all wraps and around the arc of all swivel directions. Bounds on the wraps come from boxes, which are halved until what their distances
and heights allow exceeds what some of their points attain by at most WRAP_EXCESS. This module repeats that definition in floating point.
Where rounding decides, it chooses fewer corners or fails. crates/cdpr-core/src/geometry/pulley/exits.rs has the proofs.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise, product
from typing import Any, TypeAlias

from ._vectors import ON_SURFACE, Vector, cross, dot, minus

Interval: TypeAlias = tuple[float, float]
Box: TypeAlias = tuple[Interval, Interval, Interval]

EXIT_EXCESS = 0.08  # corners around an arc are at most this farther from its centre, as a share of the radius
WRAP_EXCESS = 0.01  # rad
MOST_BOXES = 256  # a box is divided into at most about as many; then the bounds are wider
AXIS_IN_FACE = 1e-12  # rad: a box that the axis sees over a half turn and no more than this has the axis in a face
SAME_SIDE = 1e-9  # sides that differ by no more than this share are equally long: the first of them is halved
ROUNDING = 1e-14  # of heights and distances, as a share of the largest coordinate
TIE = 1e-9  # a number this close to where it would count otherwise may do so because of rounding
LEAST_LEEWAY = 1e-6  # the centre of a wheel is farther than its rim by more than this share of its radius, or rounding might decide
INWARD = 1e-9  # m: corners are moved inward by this, more than rounding errors and far less than the margin


@dataclass(frozen=True)
class Seen:
    """What the axis sees of a box: intervals of distance and height, the arc of directions (None: all round), and some of its points."""

    distance: Interval
    height: Interval
    arc: Interval | None
    samples: tuple[Interval, ...]


class Pulley:
    """The last pulley of a cable."""

    def __init__(self, outlet: Vector, spec: Mapping[str, Any]) -> None:
        self.outlet, self.radius = outlet, float(spec["radius"])
        axis = _unit((float(spec["axis"][0]), float(spec["axis"][1]), float(spec["axis"][2])))
        least = min(range(3), key=lambda k: abs(axis[k]))
        x, y, z = (float(k == least) - axis[least] * axis[k] for k in range(3))
        first = _unit((x, y, z))
        self.directions = first, cross(axis, first), axis

    def exits(self, attachments: Box) -> list[Vector]:
        """Points whose hull contains all points where the cable leaves the wheel, taut, to an attachment in a box."""
        seen = self._seen(attachments)
        least, most = self._wraps(attachments)
        found = [self._world(*p) for p in self._corners((max(least, 0.0), min(most, math.tau)), seen.arc)]
        return list(dict.fromkeys(found))

    def exit_near(self, attachment: Vector, reach: float) -> tuple[Vector, float] | None:
        """Where the cable leaves the wheel to an attachment, and how far at most its line passes from there while the attachment is up to
        `reach` away; None if the cable may have no direction, or rounding might decide.

        With the least free length f, the wrap differs by at most reach / f. As the wrap changes, the exit moves along the cable while the
        cable turns, so it leaves the cable's line by at most r (reach / f)² / 2. As the wheel swivels, the exit moves across the line by
        at most `reach` times its distance from the axis over the attachment's, which is larger.
        """
        across, beside, height = (dot(d, minus(attachment, self.outlet)) for d in self.directions)
        distance, radius = math.hypot(across, beside), self.radius
        tangent = self._tangent(distance, height)
        to_center = math.hypot(distance - radius, height) - reach
        below = math.hypot(max(distance - 2 * radius, 0.0), max(height, 0.0)) - reach
        if tangent is None or not (tangent[0] >= ON_SURFACE and to_center > (1 + LEAST_LEEWAY) * radius and below >= 0):
            return None
        free, wrap = math.sqrt((to_center - radius) * (to_center + radius)), tangent[1]
        rho = radius * (1 - math.cos(wrap))
        side = rho / distance if distance > 0 else 0.0
        wrapped = radius * reach / free
        farthest, nearest = min(rho + wrapped, 2 * radius), distance - reach
        swivelled = reach * (farthest / nearest if nearest > farthest else 1.0)
        if not swivelled + wrapped < free:
            return None
        return self._world(side * across, side * beside, radius * math.sin(wrap)), swivelled + wrapped * reach / free / 2

    def _corners(self, wraps: Interval, arc: Interval | None) -> Iterator[Vector]:
        """Corners of the polytope, in the directions of this pulley.

        Where the normals of the wheel point towards the axis, the ends of the arc of directions reach as far as any others.
        """
        for angle, factor, half in _around(wraps, 1 + EXIT_EXCESS):
            rho = max(self.radius * (1 - factor * math.cos(angle)), 0.0)
            height = self.radius * factor * math.sin(angle)
            outer = not half or math.pi / 2 + TIE <= angle + half and angle - half <= 3 * math.pi / 2 - TIE
            if arc is None and not outer:
                continue
            if rho <= ROUNDING * self.radius:
                yield 0.0, 0.0, height
                continue
            widest = 1 + EXIT_EXCESS * self.radius / rho
            if arc is None:
                ring = _all_round(widest)
            elif outer:
                ring = [(angle, factor) for angle, factor, _ in _around(arc, widest)]
            else:
                ring = [(angle, 1.0) for angle in arc]
            yield from ((rho * by * math.cos(angle), rho * by * math.sin(angle), height) for angle, by in ring)

    def _world(self, *p: float) -> Vector:
        x, y, z = (o + sum(s * d[k] for s, d in zip(p, self.directions, strict=True)) for k, o in enumerate(self.outlet))
        return x, y, z

    def _seen(self, box: Box) -> Seen:
        places = {signs: minus(self._corner(box, signs), self.outlet) for signs in product((0, 1), repeat=3)}
        corners = {signs: tuple(dot(d, p) for d in self.directions) for signs, p in places.items()}
        rounding = ROUNDING * max(abs(x) for x in (*self.outlet, *(x for side in box for x in side)))
        samples = [(math.hypot(x, y), h) for x, y, h in corners.values()]
        for signs, k in product(corners, range(3)):
            if not signs[k]:  # the point of an edge that is nearest to the axis
                a, b = corners[signs], corners[(*signs[:k], 1, *signs[k + 1 :])]
                x, y, h = (s - r for r, s in zip(a, b, strict=True))
                square = x * x + y * y
                share = min(max(-(a[0] * x + a[1] * y) / square, 0.0), 1.0) if square > 0 else 0.0
                samples.append((math.hypot(a[0] + share * x, a[1] + share * y), a[2] + share * h))
        angles = sorted(math.atan2(y, x) for x, y, _ in corners.values() if math.hypot(x, y) > rounding)
        arc = _arc_of(angles)
        (low, high), height = ((min(s[k] for s in samples) - rounding, max(s[k] for s in samples) + rounding) for k in range(2))
        return Seen((max(low, 0.0) if arc else 0.0, high), height, arc, tuple(samples))

    @staticmethod
    def _corner(box: Box, signs: tuple[int, ...]) -> Vector:
        return box[0][signs[0]], box[1][signs[1]], box[2][signs[2]]

    def _wraps(self, attachments: Box) -> Interval:
        """Bounds on the wraps to all attachments in a box."""
        bounds: Interval = (math.inf, -math.inf)
        attained: Interval = (math.inf, -math.inf)
        boxes, count = [attachments], 1
        while boxes:
            found = []
            for box in boxes:
                seen = self._seen(box)
                if (range_ := self._wraps_within(seen.distance, seen.height)) is not None:
                    found.append((box, range_))
                tangents = (self._tangent(*sample) for sample in seen.samples)
                for wrap in (wrap for free, wrap in filter(None, tangents) if free >= ON_SURFACE):
                    attained = min(attained[0], wrap), max(attained[1], wrap)
            excesses = [max(attained[0] - low, high - attained[1]) for _, (low, high) in found]
            if any(abs(excess - WRAP_EXCESS) <= TIE for excess in excesses):
                raise ValueError("scene: found a pulley for which rounding decides how exactly its wraps are known")
            wide = [box for (box, _), excess in zip(found, excesses, strict=True) if excess > WRAP_EXCESS]
            count += len(wide)
            divides = count <= MOST_BOXES
            for (_, (low, high)), excess in zip(found, excesses, strict=True):
                if not (divides and excess > WRAP_EXCESS):
                    bounds = min(bounds[0], low), max(bounds[1], high)
            boxes = [half for box in wide for half in _halves(box)] if divides else []
        if bounds[0] > bounds[1]:
            raise ValueError("scene: found a pulley that the cable cannot leave, expected one in the way to the workspace")
        return bounds

    def _wraps_within(self, distance: Interval, height: Interval) -> Interval | None:
        """Bounds on the wraps to attachments at distances and heights from two intervals, None if there are none.

        The wrap decreases with the height. It increases with the distance up to where the wheel ends at this height, and decreases from
        there; where the wheel is in the way, it is largest on the wheel.
        """
        least = min((found[1] for d in distance if (found := self._tangent(d, height[1]))), default=None)
        if least is None:
            return None
        above = max(height[0], 0.0)
        turning = self.radius + math.sqrt((self.radius - above) * (self.radius + above)) if above < self.radius else distance[1]
        farthest = min(max(turning, distance[0]), distance[1])
        found = self._tangent(farthest, height[0])
        on_wheel = 2 * math.atan2(math.sqrt(farthest), math.sqrt(max(2 * self.radius - farthest, 0.0)))
        return least, found[1] if found else on_wheel

    def _tangent(self, distance: float, height: float) -> Interval | None:
        """Free length and wrap of the taut cable to an attachment, None if it is in the wheel or the wrap would exceed a half turn."""
        beyond = distance - 2 * self.radius
        square = distance * beyond + height * height
        if square < 0 or (height < 0 and beyond < 0):
            return None
        free = math.sqrt(square)
        x, y = (height + free, distance) if height >= 0 else (beyond, free - height)
        return free, 2 * math.atan2(y, x)


def inward(points: Sequence[Vector]) -> list[Vector]:
    """Move points a little towards their mean, so that rounding errors prove less."""
    mean = [sum(p[k] for p in points) / len(points) for k in range(3)]
    moved = []
    for p in points:
        far = math.dist(p, mean)
        share = min(INWARD / far, 1.0) if far > 0 else 0.0
        x, y, z = (a + share * (m - a) for a, m in zip(p, mean, strict=True))
        moved.append((x, y, z))
    return moved


def _around(arc: Interval, farthest: float) -> Iterator[tuple[float, float, float]]:
    """Corners around an arc of the unit circle, no farther from its centre than this: angle, distance, half the angle between its tangents.

    These are the ends of the arc, and between them the corners of a polyline of tangents.
    """
    start, end = arc
    width = end - start
    yield start, 1.0, 0.0
    steps = width / _step(farthest)
    if width * width > 8 * ROUNDING and abs(steps - round(steps)) > TIE:
        half = width / math.ceil(steps) / 2
        yield from ((start + half * (2 * k + 1), 1 / math.cos(half), half) for k in range(math.ceil(steps)))
    if width > 0:
        yield end, 1.0, 0.0


def _all_round(farthest: float) -> list[tuple[float, float]]:
    """Angles and distances of the corners of a polygon around the unit circle; where rounding decides how many, of one in it."""
    steps = math.tau / _step(farthest)
    count = max(math.ceil(steps), 3)
    distance = 1.0 if abs(steps - round(steps)) <= TIE else 1 / math.cos(math.pi / count)
    return [(math.tau / count * k, distance) for k in range(count)]


def _step(distance: float) -> float:
    """Return the angle between two tangents of the unit circle that meet at this distance from its centre."""
    return 2 * math.acos(1 / distance)


def _arc_of(angles: list[float]) -> Interval | None:
    """Return the shortest arc with all of these angles, ascending, unless it exceeds a half turn."""
    if not angles:
        return None
    gaps = [(b - a, b) for a, b in pairwise([*angles, angles[0] + math.tau])]
    gap, start = max(gaps, key=lambda pair: pair[0])
    return (start, start + math.tau - gap) if gap >= math.pi - AXIS_IN_FACE else None


def _halves(box: Box) -> list[Box]:
    sides = [high - low for low, high in box]
    k = next(k for k in range(3) if sides[k] >= (1 - SAME_SIDE) * max(sides))
    middle = 0.5 * (box[k][0] + box[k][1])
    low, high = [*box], [*box]
    low[k], high[k] = (box[k][0], middle), (middle, box[k][1])
    return [(low[0], low[1], low[2]), (high[0], high[1], high[2])]


def _unit(v: Vector) -> Vector:
    size = math.sqrt(dot(v, v))
    return v[0] / size, v[1] / size, v[2] / size
