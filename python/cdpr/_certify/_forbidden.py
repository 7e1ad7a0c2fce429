"""The positions that a scene forbids, derived from the scene alone."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache, cached_property
from itertools import combinations, product
from typing import Any, TypeAlias

from ._bodies import faces_at, is_flat, may_turn, orientation_of, rotated, vertices_of
from ._cables import Cable, cable_of
from ._certificate import Bound, Certificate
from ._hulls import Hull, are_near, are_near_at, nearest_points
from ._vectors import (
    ON_SURFACE,
    SAME_END,
    Exact,
    cross,
    dot,
    exact,
    interpolated,
    minus,
    or_default,
    plus,
    scaled,
    squared,
)
from ._wrenches import Requirement

Test: TypeAlias = Callable[[Exact], bool]

TOUCHING = Fraction(1e-9)  # m: a gap that is less than required by no more than this is allowed
ROUNDING = Fraction(1e-12)  # m: the witnesses of contact may be this far apart


class Model:
    """What a scene forbids, within the certificate's margin, at the certificate's orientation."""

    def __init__(self, scene: Mapping[str, Any], proof: Certificate | Bound, *, at_one_end: bool = False) -> None:
        self.at_one_end = at_one_end
        self.scene, self.ends, self.touching = scene, (proof.start, proof.goal), Fraction(proof.margin)
        # Positions beyond the sides of the box, which may lack rounding errors along each axis, are within the margin too.
        self.margin = self.touching - 2 * ROUNDING
        self.touched: set[int] = set()  # ends (0: start, 1: goal) that touch something which the other does not
        robot, query = scene["robot"], scene.get("query") or {}
        for key, given in (("start", proof.start), ("goal", proof.goal)):
            if query.get(key) is not None and tuple(query[key]) != given:
                raise ValueError(f"{key}: found {list(given)}, but the scene asks about {query[key]}: another question")
        self.turn = orientation_of(scene, proof.orientation)
        if may_turn(scene, self.turn):
            raise ValueError("scene: found one whose platform may turn; a certificate holds for one orientation only")
        parts = [Hull(vertices_of(part)) for part in robot["platform"]]
        self.platform = [rotated(part.points, self.turn) for part in parts]
        self.obstacles: dict[str, list[Hull]] = {}
        for k, body in enumerate(scene.get("obstacles") or []):
            self.obstacles.setdefault(or_default(body.get("name"), f"obstacle {k}"), []).append(Hull(vertices_of(body)))
        names = [or_default(cable.get("name"), f"cable {k}") for k, cable in enumerate(robot["cables"])]
        self.cables = {name: self._cable(k, parts) for k, name in enumerate(names)}
        self.rules: dict[frozenset[str], float | None] = {}
        self.rules |= {frozenset(pair): None for pair in scene.get("ignore") or []}
        self.rules |= {frozenset(pair): 0.0 for pair in scene.get("touch") or []}
        self.clearances: Mapping[str, Any] = scene.get("clearances") or {}
        self.rules |= {frozenset(rule["between"]): rule["clearance"] for rule in self.clearances.get("pairs") or []}
        corners = [v for body in self.platform for v in body.points]
        for k in range(3):
            low = Fraction(scene["workspace"]["min"][k]) - min(v[k] for v in corners)
            high = Fraction(scene["workspace"]["max"][k]) - max(v[k] for v in corners)
            if proof.box[k] > low + ROUNDING or proof.box[k + 3] < high - ROUNDING:
                found = f"{proof.box[k]} to {proof.box[k + 3]} along {'xyz'[k]}"
                raise ValueError(f"box: found {found}, expected at least {float(low)} to {float(high)}")
        self.tests = cache(self._tests)

    def _cable(self, index: int, parts: Sequence[Hull]) -> Cable:
        attachment = exact(self.scene["robot"]["cables"][index]["attachment"])
        return cable_of(self.scene, index, rotated([attachment], self.turn).points[0], parts)

    def _clearance(self, kind: str, who: tuple[str, ...]) -> float:
        rule = self.rules.get(frozenset(who), or_default(self.clearances.get(kind), self.scene.get("clearance") or 0.0))
        if rule is None:
            raise ValueError(f"{' and '.join(who)}: found as a reason, but the scene ignores this pair")
        return float(rule)

    def forbids(self, who: tuple[str, ...], positions: Sequence[Exact]) -> bool:
        """Tell whether one pair of convex parts of the two members forbids all of these positions, and so their hull."""
        return any(all(test(p) for p in positions) for test in self.tests(who))

    def _tests(self, who: tuple[str, ...]) -> list[Test]:
        """For each pair of convex parts, whether it forbids a position, or one at most the margin away."""
        first, *others = sorted(who, key=lambda name: (name not in self.cables, name != "platform"))
        other = others[0] if others else ""
        if first == "platform" and other in self.obstacles:
            required = Fraction(self._clearance("platform_obstacle", who))
            pairs = product(self.platform, self.obstacles[other])
            return [self._test(required, _moving(part, obstacle)) for part, obstacle in pairs]
        if first not in self.cables or (other != "platform" and other not in self.obstacles):
            raise ValueError(f"found {list(who)}, expected a cable or the platform, and an obstacle or the platform")
        cable, on_platform = self.cables[first], other == "platform"
        bodies = self.platform if on_platform else self.obstacles[other]
        clearance = self._clearance("cable_platform" if on_platform else "cable_obstacle", who)
        # Seen from the bodies, one end of the cable is fixed, and the other one is at `zero` for the position 0.
        fixed, zero, sign = (cable.arm, cable.outlet, -1) if on_platform else (cable.outlet, cable.arm, 1)
        lowered = cable.lowered(cable.exits if on_platform else (zero,))
        distances = [nearest_points(Hull((fixed,)), body)[1] for body in bodies]
        carried = on_platform or min(distances) <= ON_SURFACE
        tests = []
        for body, distance in zip(bodies, distances, strict=True):
            required = _kept(clearance, cable.radius, distance if carried else math.inf)
            if distance > ON_SURFACE:
                shapes = ((fixed,), lowered) if on_platform else cable.near(body, clearance + cable.radius, carried)
                tests.append(self._test(required, _crossing(*shapes, body, sign)))
            elif not is_flat(body):
                tests.append(self._test(Fraction(0), _entering(fixed, zero, lowered, sign, body)))
        return tests

    def _test(self, required: Fraction, make: Callable[[Fraction], Test]) -> Test:
        """Tell whether a gap exceeds the required one by at most the margin.

        What the platform touches at both start and goal (or at one of them, if that is enough) it may touch everywhere,
        such as a floor that it slides on: the gap must then be smaller than required by more than contact.
        """
        touches = make(required + self.touching)
        touched = self._touch([touches(exact(end)) for end in self.ends])
        return make(_contact(required) if touched else required + self.margin)

    def _touch(self, at_ends: list[bool]) -> bool:
        """Tell whether both ends touch something, or one if that is enough; note an end that alone touches it."""
        if at_ends[0] != at_ends[1]:
            self.touched.add(at_ends.index(True))
        return any(at_ends) if self.at_one_end else all(at_ends)

    def closes(self, reason: tuple[Any, ...], box: tuple[float, ...]) -> bool:
        """Tell whether a reason forbids all positions of a box."""
        corners = [exact(corner) for corner in product(*zip(box[:3], box[3:], strict=True))]
        if reason[0] == "wrench" and len(reason) == 7:
            return self.requirement.lacks(exact(reason[1:4]), exact(reason[4:]), corners)
        if not all(name in self.cables for name in reason):
            return self.forbids(reason, corners)
        if len(reason) == 2:
            return self._too_near(reason, corners)
        cable, none = self.cables[reason[0]], Fraction(0)
        # Round a pulley, a cable is longer than the straight line from the outlet, by at most a detour: an end may be at a limit.
        ends = [_bad_length(cable, [exact(end)] * 8, self.touching, (none, cable.detour)) for end in self.ends]
        return _bad_length(cable, corners, -TOUCHING if self._touch(ends) else self.margin, (cable.detour, none))

    def _too_near(self, names: tuple[str, ...], corners: list[Exact]) -> bool:
        """Tell whether two cables are too near: the vector between fixed weighted means of their ends is linear in the position.

        Straight cables from wherever they can leave the frame are among the shapes that must keep clear of each other.
        """
        i, j = (self.cables[name] for name in names)
        outlets, arms = minus(j.outlet, i.outlet), minus(j.arm, i.arm)
        if names[0] == names[1] or min(squared(outlets), squared(arms)) <= Fraction(SAME_END) ** 2:
            return False  # they share an end, and forbid nothing
        most = nearest_points(Hull((exact((0, 0, 0)),)), Hull((outlets, arms)))[1]
        required = _kept(self._clearance("cable_cable", names), i.radius + j.radius, most)

        def shapes(p: Exact) -> tuple[Hull, Hull]:
            return Hull((*i.exits, plus(p, i.arm))), Hull((*j.exits, plus(p, j.arm)))

        touched = self._touch([are_near(*shapes(exact(end)), required + self.touching) for end in self.ends])
        allowed = _contact(required) if touched else required + self.margin
        weights = nearest_points(*shapes(interpolated(corners[0], corners[7], Fraction(1, 2))))[0]
        return all(are_near_at(weights, *shapes(p), allowed) for p in corners)

    @cached_property
    def requirement(self) -> Requirement:
        """What the scene requires of its cables."""
        to_center = exact(self.scene["robot"].get("center_of_mass") or (0, 0, 0))
        return Requirement(self.scene, list(self.cables.values()), rotated([to_center], self.turn).points[0])


def _bad_length(cable: Cable, corners: list[Exact], margin: Fraction, by: tuple[Fraction, Fraction]) -> bool:
    """Tell whether the straight line from the outlet is outside the limits of length at all positions in a box.

    It is shorter or longer, by less than the margin and more than the two numbers `by`.
    """
    center, (least, most) = minus(cable.outlet, cable.arm), cable.length
    farthest = max(squared(minus(corner, center)) for corner in corners)
    nearest = [min(max(center[k], corners[0][k]), corners[7][k]) for k in range(3)]
    away = squared(minus((nearest[0], nearest[1], nearest[2]), center))
    short = Fraction(least) + margin - by[0]
    too_short = short >= 0 and farthest <= short**2
    return too_short or (most < math.inf and away >= max(Fraction(most) - margin - by[1], Fraction(0)) ** 2)


def _moving(part: Hull, obstacle: Hull) -> Callable[[Fraction], Test]:
    return lambda gap: cache(lambda p: are_near(Hull(tuple(plus(v, p) for v in part.points)), obstacle, gap))


def _crossing(fixed: Sequence[Exact], moving: Sequence[Exact], body: Hull, sign: int) -> Callable[[Fraction], Test]:
    def cable(p: Exact) -> Hull:
        return Hull((*fixed, *(plus(end, scaled(p, sign)) for end in moving)))

    return lambda gap: cache(lambda p: are_near(cable(p), body, gap))


def _entering(fixed: Exact, zero: Exact, lowered: Sequence[Exact], sign: int, body: Hull) -> Callable[[Fraction], Test]:
    """A cable that starts on a body must not enter it: its moving end is within the margin of the cone into the body.

    The cone is below all faces that contain the fixed end; where the moving end counts as any of `lowered`, it is wider, by as much as
    the lowest one is below `zero` along each face's normal, or narrower if that is above. Its point nearest to the end is the end itself, its foot on a face or on the line where
    two faces meet, the point where three do, or the fixed end. However thin the body is, the cone is the same.
    """
    faces = [(n, max(dot(n, minus(zero, end)) for end in lowered)) for n in faces_at(fixed, body)]
    corners: list[Exact] = [exact((0, 0, 0))]
    for (n, a), (m, b), (o, c) in combinations(faces, 3):
        volume = dot(n, cross(m, o))
        if volume and (a or b or c):
            found = plus(scaled(cross(m, o), a), plus(scaled(cross(o, n), b), scaled(cross(n, m), c)))
            corners.append(scaled(found, 1 / volume))

    def feet(end: Exact) -> Iterator[Exact]:
        yield end
        yield from corners
        yield from (minus(end, scaled(n, (dot(n, end) - depth) / squared(n))) for n, depth in faces)
        for (n, a), (m, b) in combinations(faces, 2):
            line = cross(n, m)
            if any(line):
                own = plus(scaled(cross(m, line), a), scaled(cross(line, n), b))
                yield scaled(plus(scaled(line, dot(line, end)), own), 1 / squared(line))

    def near(p: Exact, margin: Fraction) -> bool:
        end = minus(plus(zero, scaled(p, sign)), fixed)
        inside = (foot for foot in feet(end) if all(dot(n, foot) <= depth for n, depth in faces))
        return bool(faces) and any(squared(minus(foot, end)) <= margin**2 for foot in inside)

    return lambda margin: cache(lambda p: near(p, margin))


def _contact(required: Fraction) -> Fraction:
    """The gap up to which something is forbidden that touches at the ends; it may be negative, which no gap is."""
    return required - TOUCHING if required > 0 else ROUNDING


def _kept(clearance: float, radii: float, attainable: float) -> Fraction:
    """Return the required distance, as far as some position allows it.

    By the definition of a scene, a shortfall of 0.5e-9 m does not count. Here only rounding errors are ignored, which
    proves less.
    """
    return Fraction(next((gap for gap in (clearance + radii, radii) if gap <= attainable + 1e-12), 0.0))
