"""Positions where the cables cannot exert a required wrench."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from ._cables import Cable
from ._certificate import Bound, Region, WeakBox
from ._tiling import tiling_of
from ._vectors import (
    ON_SURFACE,
    SAME_END,
    Exact,
    Vector,
    cross,
    dot,
    exact,
    interpolated,
    minus,
    or_default,
    plus,
    root_of,
    scaled,
    squared,
)

ROUNDING = 1e-12  # m: positions this far outside of the box of positions count, too
RESERVE = 1e-12  # share of all terms: far above the rounding errors of a few hundred operations
MORE_SPREAD = Fraction(1, 10**7)  # m, added to the distance of a cable's line from its origin: far more than rounding errors
ABOVE = 1 + 1e-12  # where rounding must not make a distance smaller
LEAN = 0.1  # a cable counts as tight if it provides this share of the largest change in a box
PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))  # the coordinates of products


class Requirement:
    """What a scene requires of its cables, and what they can exert."""

    def __init__(self, scene: Mapping[str, Any], cables: Sequence[Cable], to_center: Exact) -> None:
        self.cables, self.to_center = cables, to_center
        wrench = scene.get("wrench")
        if wrench is None or wrench.get("rule") == "grid" or any(cable.tension is None for cable in cables):
            raise ValueError("found a wrench as a reason, but the scene has no certified requirement on wrenches")
        self.wrench: Mapping[str, Any] = wrench
        self.gravity = exact(or_default(scene.get("gravity"), (0, 0, -9.81)))
        self.mass = Fraction(scene["robot"]["mass"])

    def corner(self, force: Exact, moment: Exact, *, has: tuple[bool, bool] | None = None) -> tuple[Exact, Exact]:
        """Return a required wrench, as force and moment, that is about the largest one in a direction.

        `has` tells whether the direction has forces and moments, if it differs elsewhere.
        """
        has_force, has_moment = has or (any(force), any(moment))
        arms = [cable.arm for cable in self.cables]
        one_point = all(squared(minus(arm, arms[0])) <= Fraction(SAME_END) ** 2 for arm in arms)
        if has_moment and (one_point or (self.wrench.get("margin") == "projected" and has_force)):
            raise ValueError("found a wrench as a reason with a moment that does not count in this scene")

        def largest(wrenches: Sequence[tuple[Exact, Exact]]) -> tuple[Exact, Exact]:
            return max(wrenches, key=lambda w: dot(force, w[0]) + dot(moment, w[1]))

        def halves(numbers: Sequence[float]) -> tuple[Exact, Exact]:
            return exact(numbers[:3]), exact(numbers[3:])

        if self.wrench.get("vertices"):
            parts = [largest([halves(w) for w in self.wrench["vertices"]])]
        else:
            parts = [(_along(self.wrench.get("force"), force), _along(self.wrench.get("moment"), moment))]
        loads = self.wrench.get("loads") or [self.wrench.get("load") or (0,) * 6]
        parts.append(largest([halves([-x for x in load]) for load in loads]))
        weights = [scaled(self.gravity, -carried) for carried in {self.mass, self.mass + Fraction(self.wrench.get("payload") or 0)}]
        parts.append(largest([(weight, cross(self.to_center, weight)) for weight in weights]))
        forces, moments = zip(*parts, strict=True)
        return plus(plus(forces[0], forces[1]), forces[2]), plus(plus(moments[0], moments[1]), moments[2])

    def lacks(self, force: Exact, moment: Exact, corners: Sequence[Exact]) -> bool:
        """Tell whether everywhere in a box the cables exert less along [force; moment] than some required wrench."""
        worst = self.corner(force, moment)
        center, radius = interpolated(corners[0], corners[7], Fraction(1, 2)), root_of(squared(minus(corners[7], corners[0])) / 4, 1)
        available = Fraction(0)
        for cable in self.cables:
            origin, spread = _origin(cable, center, float(radius) * ABOVE)
            line = minus(minus(origin, cable.arm), center)
            pull = _farthest(plus(force, cross(moment, cable.arm)), line, (radius + spread) ** 2)
            least, most = map(Fraction, cable.tension or (0, 0))
            available += max(least * pull, most * pull)
        return available < dot(force, worst[0]) + dot(moment, worst[1])

    def lacks_in(self, box: WeakBox, plane: Sequence[float]) -> bool:
        """Tell whether the cables are too weak at all positions of a box below a plane, in a direction linear in the position.

        A unit of tension provides h = q·l / |l|, with q = c_f + c_m × arm and the line l from the attachment to the outlet, or to where the
        cable leaves its pulley at the centre; then h differs by at most |q| times how much the direction differs. With r the
        reciprocal of the length at the centre, and x = r² l² - 1, it is r q·l (1 - x/2 + 3x²/8), up to 5/16 |x|³ / (1 - |x|)^3.5
        of r q·l. So the sum of max(t_min h, t_max h), less c·w and a multiple of the height above the plane, is quadratic in the
        position, up to a rest. It is negative in the whole box if at the centre it is negative by more than all other terms together.
        """
        if box.weight < 0:
            raise ValueError(f"found the weight {box.weight}, expected one of at least 0")
        low, high = exact(box.corners[:3]), exact(box.corners[3:])
        center = interpolated(low, high, Fraction(1, 2))
        half = [float(high[k] - center[k]) * (1 + 1e-15) + ROUNDING for k in range(3)]
        direction, changes = box.direction, [[half[k] * x for x in row] for k, row in enumerate(box.slopes)]
        has = any(any(row[:3]) for row in (direction, *changes)), any(any(row[3:]) for row in (direction, *changes))
        required = [float(x) for part in self.corner(exact(direction[:3]), exact(direction[3:]), has=has) for x in part]
        total = Quadratic(-_product(direction, required), [-_product(change, required) for change in changes], [0.0] * 6, 0.0)
        size = sum(math.hypot(*row) for row in (direction, *changes)) * math.hypot(*required)
        for cable in self.cables:
            origin, spread = _origin(cable, center, math.hypot(*half) * ABOVE)
            arm, line = [float(x) for x in cable.arm], [float(x) for x in minus(minus(origin, cable.arm), center)]
            pulls = [_pull(row, arm) for row in (direction, *changes)]
            height, astray = _height(pulls, line, half), _astray(line, math.hypot(*half), float(spread))
            if height is None or astray is None:
                return False
            height.rest += sum(math.hypot(*pull) for pull in pulls) * astray
            least, most = cable.tension or (0.0, 0.0)
            way = sum(map(abs, (*height.slope, *height.curve))) + height.rest
            tight = height.at_center > LEAN * way
            total.add(most if tight else least, height)
            # Where the other limit provides more, it does so by at most the height times the difference.
            total.rest += (most - least) * max(way - height.at_center if tight else way + height.at_center, 0.0)
            reach = sum(math.hypot(*row[:3]) + math.hypot(*row[3:]) * math.hypot(*arm) for row in (direction, *changes))
            size += most * reach * (1 + math.hypot(*half) / math.hypot(*line)) ** 2
        above = float(dot(exact(plane[:3]), center) - Fraction(plane[3])) - 2 * ROUNDING
        total.at_center -= box.weight * above
        total.slope = [slope - box.weight * plane[k] * half[k] for k, slope in enumerate(total.slope)]
        size += box.weight * (abs(above) + math.hypot(*half))
        curved = sum(max(square, 0.0) for square in total.curve[:3]) + sum(map(abs, total.curve[3:]))
        return total.at_center + sum(map(abs, total.slope)) + curved + total.rest < -RESERVE * size


@dataclass
class Quadratic:
    """A function of the offset from the centre of a box, in half sides; it is larger or smaller by at most `rest`."""

    at_center: float
    slope: list[float]
    curve: list[float]
    rest: float

    def add(self, factor: float, other: Quadratic) -> None:
        self.at_center += factor * other.at_center
        self.slope = [a + factor * b for a, b in zip(self.slope, other.slope, strict=True)]
        self.curve = [a + factor * b for a, b in zip(self.curve, other.curve, strict=True)]
        self.rest += abs(factor) * other.rest


def check_lack(requirement: Requirement, proof: Bound, region: Region, vertices: Sequence[Exact]) -> None:
    """Raise ValueError unless wrenches lack at all positions of a region that a path shorter than the length can reach."""
    boxes = [box.corners for box in region.boxes]
    if not region.half_spaces:
        raise ValueError("half_spaces: found none, expected some")
    if not boxes:
        raise ValueError("boxes: found none, expected boxes that show that wrenches lack")
    whole = (*(min(box[k] for box in boxes) for k in range(3)), *(max(box[k] for box in boxes) for k in range(3, 6)))
    if not all(whole[k] <= p[k] <= whole[k + 3] for p in vertices for k in range(3)):
        raise ValueError("boxes: found a position of the region in none, expected all in them")
    tiling_of(whole, boxes)
    plane = region.half_spaces[-1]
    for k, box in enumerate(region.boxes):
        if not box.direction:
            if not _is_beyond(box.corners, plane, proof):
                raise ValueError(f"boxes[{k}]: found no direction, and positions that count")
        elif not requirement.lacks_in(box, plane):
            raise ValueError(f"boxes[{k}]: found no proof that the cables are too weak in this direction")


def _is_beyond(box: Sequence[float], plane: Sequence[float], proof: Bound) -> bool:
    """Tell whether a box is above a plane, or so far from start and goal that no path through it is shorter than the length."""
    low, high, normal = exact(box[:3]), exact(box[3:]), exact(plane[:3])
    if sum(min(normal[k] * low[k], normal[k] * high[k]) for k in range(3)) > Fraction(plane[3]):
        return True

    def distance(end: Vector) -> Fraction:
        p = exact(end)
        away = exact([max(low[k] - p[k], p[k] - high[k], Fraction(0)) for k in range(3)])
        return root_of(squared(away), 0) if any(away) else Fraction(0)

    return distance(proof.start) + distance(proof.goal) >= Fraction(proof.length)


def _origin(cable: Cable, center: Exact, reach: float) -> tuple[Exact, Fraction]:
    """Return a point, and how far at most a cable's line passes from it while the platform is up to `reach` from a position.

    It is the outlet, where the cable leaves its pulley at the position, or the middle of all points where it can leave it.
    """
    if cable.wheel is None or not cable.pulley:
        return cable.outlet, Fraction(0)
    x, y, z = plus(center, cable.arm)
    near = cable.wheel.exit_near((float(x), float(y), float(z)), reach)
    middle, spread = cable.middle_exit
    if near is not None and near[1] < spread:
        return exact(near[0]), Fraction(near[1]) + MORE_SPREAD
    return middle, spread + MORE_SPREAD


def _astray(line: Sequence[float], reach: float, spread: float) -> float | None:
    """Return how much directions to the end of a line, from up to `reach` around its start, differ at most from those of a cable that
    passes the end at a distance of `spread`, as the length of a vector; None if they may be any."""
    distance = math.hypot(*line) - reach
    if spread == 0:
        return 0.0
    if not distance - spread > ON_SURFACE:
        return None
    sine = spread / distance
    return sine / math.sqrt(0.5 + 0.5 * math.sqrt(1 - sine * sine)) * ABOVE


def _height(pulls: list[list[float]], line: list[float], half: list[float]) -> Quadratic | None:
    """Return what a unit of tension provides, from q at the centre and its changes over half sides; None near the outlet."""
    q, *changes = pulls
    length = math.hypot(*line)
    if not length > 0:
        return None
    r2 = 1 / length**2
    # q·l and x, each with its slope and its curve.
    inner = _product(q, line)
    inner_slope = [_product(changes[a], line) - half[a] * q[a] for a in range(3)]
    inner_curve = [
        -(half[b] * changes[a][b] + (half[a] * changes[b][a] if a != b else 0.0)) for a, b in PAIRS
    ]
    x_slope = [-2 * r2 * line[a] * half[a] for a in range(3)]
    x_curve = [r2 * half[a] ** 2 for a in range(3)] + [0.0] * 3
    x1, x2 = sum(map(abs, x_slope)), sum(x_curve)
    most = (x1 + x2) * (1 + 1e-12) + 1e-14
    if most > 0.5:
        return None
    slope = [inner_slope[a] - inner * x_slope[a] / 2 for a in range(3)]
    curve = []
    for k, (a, b) in enumerate(PAIRS):
        twice = 1 if a == b else 2
        steep = inner_slope[a] * x_slope[b] + (inner_slope[b] * x_slope[a] if a != b else 0.0)
        curve.append(inner_curve[k] - inner * x_curve[k] / 2 + 0.375 * twice * inner * x_slope[a] * x_slope[b] - steep / 2)
    n0, n1, n2 = abs(inner), sum(map(abs, inner_slope)), sum(map(abs, inner_curve))
    rest = 0.375 * n0 * x2 * (2 * x1 + x2)  # what is left out of the square of x,
    rest += n1 * (x2 / 2 + 0.375 * most**2) + n2 * (most / 2 + 0.375 * most**2)  # of the products,
    rest += (n0 + n1 + n2) * 0.3125 * most**3 / (1 - most) ** 3.5  # and of the series
    return Quadratic(inner / length, [x / length for x in slope], [x / length for x in curve], rest * (1 + 1e-12) / length)


def _pull(direction: Sequence[float], arm: Sequence[float]) -> list[float]:
    force, moment = direction[:3], direction[3:]
    return [force[k] + moment[k - 2] * arm[k - 1] - moment[k - 1] * arm[k - 2] for k in range(3)]


def _product(a: Sequence[float], b: Sequence[float]) -> float:
    return math.fsum(x * y for x, y in zip(a, b, strict=True))


def _along(length: float | None, direction: Exact) -> Exact:
    """Return a vector along another one that is at most so long, and hardly shorter."""
    size = root_of(squared(direction), 1) if length and any(direction) else Fraction(0)
    return scaled(direction, Fraction(length or 0) / size) if size else exact((0, 0, 0))


def _farthest(q: Exact, line: Exact, radius: Fraction) -> Fraction:
    """Return an upper bound of q·u for the directions u to points at most √radius from the end of the line.

    The angle between u and the line is at most a, with sin a = √radius / |line|. So q·u is at most |q| cos(b - a) if
    the angle b between q and the line is at least a, else |q|.
    """
    size, square = squared(q), squared(line)
    sine = root_of(radius / square, 1) if radius < square else Fraction(1)
    inner = dot(q, line)
    along = inner / root_of(square, inner < 0) if sine < 1 else Fraction(0)  # |q| cos b, rounded up
    rest = 1 - sine * sine
    if sine >= 1 or (along >= 0 and along * along >= size * rest):
        return root_of(size, 1)
    return along * root_of(rest, along >= 0) + sine * root_of(max(size - along * along, Fraction(0)), 1)
