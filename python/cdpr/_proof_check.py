"""Check a cdpr-proof certificate: that no path from start to goal keeps a gap of more than the margin.

A certificate tiles the box of positions with boxes. Each box is open, inside a region of forbidden positions, or
forbidden as a whole for a stated reason. Each such set is convex and so is the set of positions that a pair of convex
bodies forbids. So a region is forbidden if its vertices are, and a box if its corners are. If the open boxes that
contain the start are not connected with those of the goal, each path enters a forbidden box.

All decisions are exact. Floating point only finds witnesses (nearest points), which are then verified in rationals.
This module shares no code with the program that writes certificates, and needs only the standard library.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from itertools import product
from typing import Any, TypeAlias, TypeVar

Vector: TypeAlias = tuple[float, float, float]
Exact: TypeAlias = tuple[Fraction, Fraction, Fraction]
Quaternion: TypeAlias = tuple[float, ...]
Pair: TypeAlias = tuple[int, int]
Test: TypeAlias = Callable[[Exact], bool]
N = TypeVar("N", float, Fraction)

ON_SURFACE = 1e-7  # m: a point this close to a body lies on it, a body this thin is flat, the shortest cable
KEYS = {"format", "version", "scene", "orientation", "margin", "start", "goal", "box", "regions", "boxes"}
MOST_BOXES, MOST_REGIONS, MOST_HALF_SPACES = 1_000_000, 10_000, 1_000
MOST_NUMBER = 1e12
NEAR_END = 0.999e-3  # m
TOUCHING = Fraction(1e-9)  # m: a gap that is less than required by no more than this is allowed
ROUNDING = Fraction(1e-12)  # m: by this much the witnesses of contact may be apart
FRACTIONS_OF_A_CABLE = (Fraction(1), Fraction(1, 16), Fraction(1, 256), Fraction(1, 4096))


def check_certificate(scene: Mapping[str, Any], certificate: Mapping[str, Any] | str, fingerprint: str | None) -> None:
    """Raise ValueError, with the reason, unless the certificate proves that this scene has no path.

    The scene is plain data with an inline robot and convex bodies; `fingerprint` is the scene's (None: do not compare).
    """
    file = _read(certificate) if isinstance(certificate, str) else certificate
    proof = Certificate(file)
    if fingerprint is not None and file["scene"] != fingerprint:
        raise ValueError(f"scene: found {file['scene']!r}, which is another scene; this one is {fingerprint!r}")
    model = Model(scene, proof)
    tree = _tile(proof.box, proof.boxes)
    _check_separation(proof, tree)
    for k, region in enumerate(proof.regions):
        vertices = _clip(proof.box, region.half_spaces)
        if not model.forbids(region.who, vertices):
            found = f"reaches more than the margin beyond the positions that {' and '.join(region.who)} forbid"
            raise ValueError(f"regions[{k}]: {found}")
    _check_inside(proof)
    for k, reason in proof.reasons.items():
        if not model.closes(reason, proof.boxes[k]):
            raise ValueError(f"boxes[{k}]: not all of its positions are forbidden by {list(reason)}")
    for end, point in enumerate((proof.start, proof.goal)):
        if end in model.touched:
            _check_open_around("goal" if end else "start", point, proof)


# Reading the file


@dataclass(frozen=True)
class Region:
    """Positions inside all half-spaces n·x < d, and the pair that is said to forbid them."""

    who: tuple[str, ...]
    half_spaces: list[tuple[float, ...]]


class Certificate:
    """The contents of a file, checked for structure and numbers only."""

    def __init__(self, file: Mapping[str, Any]) -> None:
        if not isinstance(file, Mapping) or file.get("format") != "cdpr-proof":
            raise ValueError("format: found another file, expected a table with \"format\": \"cdpr-proof\"")
        if type(file.get("version")) is not int or file["version"] != 1:
            raise ValueError(f"version: found {file.get('version')!r}, expected 1")
        _keys("certificate", file, KEYS)
        boxes = _items("boxes", file["boxes"], MOST_BOXES)
        regions = _items("regions", file["regions"], MOST_REGIONS)
        if not isinstance(file["scene"], str):
            raise ValueError(f"scene: found {type(file['scene']).__name__}, expected a fingerprint")
        self.margin = _numbers("margin", [file["margin"]], 1)[0]
        if not 1e-8 <= self.margin <= 1e-6:
            raise ValueError(f"margin: found {self.margin!r}, expected 1e-8 to 1e-6 m")
        self.orientation = _numbers("orientation", file["orientation"], 4)
        self.start, self.goal = (_numbers(key, file[key], 3) for key in ("start", "goal"))
        low, high = (_numbers("box", corner, 3) for corner in _items("box", file["box"], 2, 2))
        self.box = low + high
        self.regions = [self._region(f"regions[{k}]", region) for k, region in enumerate(regions)]
        self.boxes: list[tuple[float, ...]] = []
        self.kinds: list[int] = []
        self.reasons: dict[int, tuple[Any, ...]] = {}
        for k, box in enumerate(boxes):
            self._add_box(f"boxes[{k}]", box)

    @staticmethod
    def _region(place: str, region: Any) -> Region:
        _keys(place, region, {"who", "half_spaces"})
        planes = _items(f"{place}.half_spaces", region["half_spaces"], MOST_HALF_SPACES)
        who = _names(f"{place}.who", region["who"])
        return Region(who, [_numbers(f"{place}.half_spaces", plane, 4) for plane in planes])

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


def _read(text: str) -> Any:
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


def _keys(place: str, table: Any, expected: set[str]) -> None:
    if not isinstance(table, Mapping):
        raise ValueError(f"{place}: found {type(table).__name__}, expected a table")
    for key in sorted(set(map(str, table)) ^ expected):
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


def _names(place: str, items: Any) -> tuple[str, ...]:
    if not all(isinstance(name, str) for name in _items(place, items, 2, 1)):
        raise ValueError(f"{place}: found {items!r:.60}, expected names of one or two members")
    return tuple(items)


# (b), (c), (d): inside, tiling, separation


def _integers(numbers: Sequence[float]) -> tuple[list[int], int]:
    """The numbers times a common power of two that makes them integers, and this power."""
    ratios = [x.as_integer_ratio() for x in numbers]
    power = max((below for _, below in ratios), default=1)
    return [above * (power // below) for above, below in ratios], power


def _check_inside(proof: Certificate) -> None:
    """Each box that is closed by a region is inside it: n·x < d at its corner farthest along n."""
    coordinates, unit = _integers([x for box in proof.boxes for x in box])
    planes = [[_integers(plane)[0] for plane in region.half_spaces] for region in proof.regions]
    for k, kind in enumerate(proof.kinds):
        box = coordinates[6 * k : 6 * k + 6]
        for *n, d in planes[kind] if kind >= 0 else ():
            if sum(n[i] * box[i + 3 if n[i] > 0 else i] for i in range(3)) >= d * unit:
                raise ValueError(f"boxes[{k}]: found a corner outside region {kind}, expected all of the box inside")


def _tile(whole: tuple[float, ...], boxes: Sequence[tuple[float, ...]]) -> list[Any]:
    """A tree of cuts that proves that the boxes tile the whole: [axis, cut, below, above] or the index of a box."""
    root: list[Any] = [0, -math.inf, -1, -1]  # everything is above its cut
    stack = [(root, 3, whole, list(range(len(boxes))))]
    while stack:
        parent, side, cell, inside = stack.pop()
        if len(inside) == 1 and boxes[inside[0]] == cell:
            parent[side] = inside[0]
            continue
        cut = _cut(cell, [boxes[k] for k in inside])
        if cut is None:
            what = "boxes that do not tile" if inside else "no box in"
            raise ValueError(f"boxes: found {what} {list(cell[:3])} to {list(cell[3:])}, expected a tiling of the box")
        axis, at = cut
        below, above = list(cell), list(cell)
        below[axis + 3] = above[axis] = at
        parent[side] = node = [axis, at, -1, -1]
        stack.append((node, 2, tuple(below), [k for k in inside if boxes[k][axis + 3] <= at]))
        stack.append((node, 3, tuple(above), [k for k in inside if boxes[k][axis] >= at]))
    return root


def _cut(cell: tuple[float, ...], boxes: list[tuple[float, ...]]) -> tuple[int, float] | None:
    """The axis and coordinate of a plane through the cell that contains a face and passes through no box."""
    for axis in range(3):
        low, high = cell[axis], cell[axis + 3]
        faces = {x for box in boxes for x in (box[axis], box[axis + 3]) if low < x < high}
        at = min(faces, key=lambda x: abs(x - (low + high) / 2), default=low)
        if faces and not any(box[axis] < at < box[axis + 3] for box in boxes):
            return axis, at
    return None


def _touching(tree: list[Any], box: Sequence[float]) -> Iterator[int]:
    """The boxes of the tiling that touch this one, even if only in a point."""
    stack: list[Any] = [tree]
    while stack:
        node = stack.pop()
        if isinstance(node, int):
            yield node
            continue
        axis, at, below, above = node
        stack += ([below] if box[axis] <= at else []) + ([above] if box[axis + 3] >= at else [])


def _check_open_around(name: str, point: Sequence[float], proof: Certificate) -> None:
    """Nothing is closed within 1 mm of an end that touches something which the other end does not."""
    for k, box in enumerate(proof.boxes):
        near = all(box[i] < point[i] + NEAR_END and point[i] - NEAR_END < box[i + 3] for i in range(3))
        if near and proof.kinds[k] != -1:
            raise ValueError(f"{name}: found contact there, and boxes[{k}] closed beside it, expected it open for 1 mm")


def _check_separation(proof: Certificate, tree: list[Any]) -> None:
    def of(point: tuple[float, ...]) -> set[int]:
        inside = all(proof.box[k] <= point[k] <= proof.box[k + 3] for k in range(3))
        return {k for k in _touching(tree, point + point) if inside and proof.kinds[k] == -1}

    reached, goals = of(proof.start), of(proof.goal)
    for name, found in (("start", reached), ("goal", goals)):
        if not found:
            raise ValueError(f"{name}: found no open box that contains it, expected at least one")
    stack = list(reached)
    while stack:
        for k in _touching(tree, proof.boxes[stack.pop()]):
            if proof.kinds[k] == -1 and k not in reached:
                reached.add(k)
                stack.append(k)
    if reached & goals:
        raise ValueError("boxes: found start and goal connected through open boxes, expected them separated")


# (a): the vertices of a region, and nearest points


def _clip(box: Sequence[float], half_spaces: Sequence[Sequence[float]]) -> list[Exact]:
    """The vertices of a box cut by half-spaces n·x <= d."""
    # Each vertex with the planes through it. Two vertices share an edge if no third lies on all of their common planes.
    vertices = {_exact([box[i] for i in sides]): {-1 - i for i in sides} for sides in product((0, 3), (1, 4), (2, 5))}
    for k, plane in enumerate(half_spaces):
        n, d = _exact(plane[:3]), Fraction(plane[3])
        above = {v: _dot(n, v) - d for v in vertices}
        kept = {v: planes | ({k} if above[v] == 0 else set()) for v, planes in vertices.items() if above[v] <= 0}
        for v, w in product([v for v in kept if above[v] < 0], [w for w in vertices if above[w] > 0]):
            common = vertices[v] & vertices[w]
            if len(common) >= 2 and sum(common <= planes for planes in vertices.values()) == 2:
                kept[_along(v, w, above[v] / (above[v] - above[w]))] = common | {k}
        vertices = kept
    return list(vertices)


@dataclass(frozen=True)
class Hull:
    """The convex hull of points."""

    points: tuple[Exact, ...]

    @cached_property
    def floats(self) -> list[Vector]:
        return [(float(x), float(y), float(z)) for x, y, z in self.points]

    def support(self, x: Vector) -> int:
        """The index of the point farthest along x."""
        heights = [x[0] * p[0] + x[1] * p[1] + x[2] * p[2] for p in self.floats]
        return heights.index(max(heights))


def _near(a: Hull, b: Hull, gap: Fraction) -> bool:
    """Whether two points, one of each hull, are found at most `gap` apart; exact."""
    weights, distance = _nearest(a, b, 0.999 * float(gap))
    if distance > 2 * float(gap):
        return False
    between = _exact((0, 0, 0))
    for (i, j), w in weights.items():
        between = _add(between, _times(_sub(a.points[i], b.points[j]), Fraction(w)))
    return _square(between) <= (gap * sum(map(Fraction, weights.values()))) ** 2


def _nearest(a: Hull, b: Hull, enough: float = 0.0) -> tuple[dict[Pair, float], float]:
    """Nonnegative weights of point pairs that give nearest points of two hulls, and their distance; approximate.

    The point of the hull of the differences nearest to the origin, by Wolfe's algorithm: add the point farthest towards
    the origin, go to the point nearest to the origin of the simplex's plane, and drop points whose weights become 0 on
    the way. Ends early at the distance `enough`.
    """
    weights: dict[Pair, float] = {(0, 0): 1.0}
    distance, best = math.inf, weights
    for _ in range(100):
        points = {(i, j): _sub(a.floats[i], b.floats[j]) for i, j in weights}
        x, y, z = (sum(w * points[pair][k] for pair, w in weights.items()) for k in range(3))
        length = math.hypot(x, y, z)
        if not length < distance:  # no progress beyond rounding
            break
        distance, best = length, weights
        new = (a.support((-x, -y, -z)), b.support((x, y, z)))
        if distance <= enough or new in weights or len(weights) == 4:
            break
        points[new] = _sub(a.floats[new[0]], b.floats[new[1]])
        weights = _nearest_of_simplex({**weights, new: 0.0}, points)
    return best, distance


def _nearest_of_simplex(weights: dict[Pair, float], points: dict[Pair, Vector]) -> dict[Pair, float]:
    """Weights of a point of a simplex at least as near to the origin, the nearest one of some face of the simplex."""
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
    """Weights (sum 1) of the point nearest to the origin on the line, plane or space through up to four points."""
    to = _sub((0.0, 0.0, 0.0), points[0])
    edges = [_sub(p, points[0]) for p in points[1:]]
    if len(edges) == 3:
        rows = [_cross(edges[1], edges[2]), _cross(edges[2], edges[0]), _cross(edges[0], edges[1])]
        size = _dot(edges[0], rows[0])
    elif len(edges) == 2:
        normal = _cross(edges[0], edges[1])
        rows, size = [_cross(edges[1], normal), _cross(normal, edges[0])], _dot(normal, normal)
    else:
        rows, size = edges, sum(map(_square, edges))
    found = [_dot(row, to) / size if abs(size) > 1e-200 else 0.0 for row in rows]
    return [1 - sum(found), *found]


# The scene


@dataclass(frozen=True)
class Cable:
    """A cable; the arm leads from the platform's origin to the attachment, in world axes."""

    outlet: Exact
    arm: Exact
    radius: float
    length: tuple[float, float]
    tension: tuple[float, float] | None


class Model:
    """What a scene forbids, within the certificate's margin, at the certificate's orientation."""

    def __init__(self, scene: Mapping[str, Any], proof: Certificate) -> None:
        self.scene, self.margin, self.ends = scene, Fraction(proof.margin), (proof.start, proof.goal)
        self.touched: set[int] = set()  # ends (0: start, 1: goal) that touch something which the other does not
        robot, query = scene["robot"], scene.get("query") or {}
        for key, given in (("start", proof.start), ("goal", proof.goal)):
            if query.get(key) is not None and tuple(query[key]) != given:
                raise ValueError(f"{key}: found {list(given)}, but the scene asks about {query[key]}: another question")
        self.turn = _orientation(scene, proof.orientation)
        self.platform = [_turned(body, self.turn) for body in map(_body, robot["platform"])]
        self.obstacles: dict[str, list[Hull]] = {}
        for k, body in enumerate(scene.get("obstacles") or []):
            self.obstacles.setdefault(_or(body.get("name"), f"obstacle {k}"), []).append(Hull(_body(body)))
        self.cables = {_or(c.get("name"), f"cable {k}"): self._cable(c) for k, c in enumerate(robot["cables"])}
        self.rules: dict[frozenset[str], float | None] = {}
        self.rules |= {frozenset(pair): None for pair in scene.get("ignore") or []}
        self.rules |= {frozenset(pair): 0.0 for pair in scene.get("touch") or []}
        self.clearances: Mapping[str, Any] = scene.get("clearances") or {}
        self.rules |= {frozenset(rule["between"]): rule["clearance"] for rule in self.clearances.get("pairs") or []}
        corners = [v for body in self.platform for v in body.points]
        for k in range(3):
            low = Fraction(scene["workspace"]["min"][k]) - min(v[k] for v in corners)
            high = Fraction(scene["workspace"]["max"][k]) - max(v[k] for v in corners)
            if proof.box[k] > low + self.margin or proof.box[k + 3] < high - self.margin:
                found = f"{proof.box[k]} to {proof.box[k + 3]} along {'xyz'[k]}"
                raise ValueError(f"box: found {found}, expected at least {float(low)} to {float(high)}")
        self.tests = cache(self._tests)

    def _cable(self, spec: Mapping[str, Any]) -> Cable:
        arm = _turned([_exact(spec["attachment"])], self.turn).points[0]
        length = tuple(spec.get("length") or (0.0, math.inf))
        radius = (spec.get("diameter") or 0.0) / 2
        return Cable(_exact(spec["outlet"]), arm, radius, (max(length[0], ON_SURFACE), length[1]), spec.get("tension"))

    def _clearance(self, kind: str, who: tuple[str, ...]) -> float:
        rule = self.rules.get(frozenset(who), _or(self.clearances.get(kind), self.scene.get("clearance") or 0.0))
        if rule is None:
            raise ValueError(f"{' and '.join(who)}: found as a reason, but the scene ignores this pair")
        return float(rule)

    def forbids(self, who: tuple[str, ...], positions: Sequence[Exact]) -> bool:
        """Whether one pair of convex parts of the two members forbids all of these positions, and so their hull."""
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
        distances = [_nearest(Hull((fixed,)), body)[1] for body in bodies]
        carried = on_platform or min(distances) <= ON_SURFACE
        tests = []
        for body, distance in zip(bodies, distances, strict=True):
            required = _kept(clearance, cable.radius, distance if carried else math.inf)
            if distance > ON_SURFACE:
                tests.append(self._test(required, _crossing(fixed, zero, sign, body)))
            elif not _is_flat(body):
                tests.append(self._test(Fraction(0), _entering(fixed, zero, sign, body)))
        return tests

    def _test(self, required: Fraction, make: Callable[[Fraction], Test]) -> Test:
        """A test for less than the required distance plus the margin, or minus the depth of contact if both ends fail it.

        What the platform touches at the start and at the goal it may touch everywhere, such as a floor that it slides on.
        """
        test = make(required + self.margin)
        return make(max(required - TOUCHING, ROUNDING)) if self._touch([test(_exact(end)) for end in self.ends]) else test

    def _touch(self, at_ends: list[bool]) -> bool:
        """Whether both ends touch something; notes an end that alone touches it."""
        if at_ends[0] != at_ends[1]:
            self.touched.add(at_ends.index(True))
        return all(at_ends)

    def closes(self, reason: tuple[Any, ...], box: tuple[float, ...]) -> bool:
        """Whether a reason forbids all positions of a box."""
        corners = [_exact(corner) for corner in product(*zip(box[:3], box[3:], strict=True))]
        if reason[0] == "wrench" and len(reason) == 7:
            return self._lacks_wrench(_exact(reason[1:4]), _exact(reason[4:]), corners)
        if not all(name in self.cables for name in reason):
            return self.forbids(reason, corners)
        by = self._bad_length if len(reason) == 1 else self._too_near
        touched = self._touch([by(reason, [_exact(end)] * 8, self.margin) for end in self.ends])
        return by(reason, corners, -TOUCHING if touched else self.margin)

    def _bad_length(self, names: tuple[str, ...], corners: list[Exact], margin: Fraction) -> bool:
        cable = self.cables[names[0]]
        center, (least, most) = _sub(cable.outlet, cable.arm), cable.length
        farthest = max(_square(_sub(corner, center)) for corner in corners)
        nearest = [min(max(center[k], corners[0][k]), corners[7][k]) for k in range(3)]
        away = _square(_sub((nearest[0], nearest[1], nearest[2]), center))
        too_short = farthest <= max(Fraction(least) + margin, Fraction(0)) ** 2
        return too_short or (most < math.inf and away >= max(Fraction(most) - margin, Fraction(0)) ** 2)

    def _too_near(self, names: tuple[str, ...], corners: list[Exact], margin: Fraction) -> bool:
        """Two cables: the vector between two fixed fractions of them is linear in the position."""
        i, j = (self.cables[name] for name in names)
        outlets, arms = _sub(j.outlet, i.outlet), _sub(j.arm, i.arm)
        if names[0] == names[1] or min(_square(outlets), _square(arms)) <= Fraction(ON_SURFACE) ** 2:
            return False  # they share an end, and forbid nothing
        most = _nearest(Hull((_exact((0, 0, 0)),)), Hull((outlets, arms)))[1]
        required = _kept(self._clearance("cable_cable", names), i.radius + j.radius, most)
        center = _along(corners[0], corners[7], Fraction(1, 2))
        a, b = (Hull((cable.outlet, _add(center, cable.arm))) for cable in (i, j))
        weights = _nearest(a, b)[0]
        s, r = (min(Fraction(sum(w for pair, w in weights.items() if pair[k] == 1)), Fraction(1)) for k in range(2))
        points = ((_along(i.outlet, _add(p, i.arm), s), _along(j.outlet, _add(p, j.arm), r)) for p in corners)
        return all(_square(_sub(x, y)) <= max(required + margin, ROUNDING) ** 2 for x, y in points)

    def _lacks_wrench(self, force: Exact, moment: Exact, corners: list[Exact]) -> bool:
        """Whether everywhere in a box the cables exert less along [force; moment] than some required wrench."""
        wrench, cables = self.scene.get("wrench"), self.cables.values()
        if wrench is None or wrench.get("rule") == "grid" or any(cable.tension is None for cable in cables):
            raise ValueError("found a wrench as a reason, but the scene has no certified requirement on wrenches")
        arms = [cable.arm for cable in cables]
        one_point = all(_square(_sub(arm, arms[0])) <= Fraction(1e-6) ** 2 for arm in arms)
        if any(moment) and (one_point or (wrench.get("margin") == "projected" and any(force))):
            raise ValueError("found a wrench as a reason with a moment that does not count in this scene")
        robot, (zero, half) = self.scene["robot"], (_exact((0, 0, 0)), Fraction(1, 2))
        weight = _times(_exact(_or(self.scene.get("gravity"), (0, 0, -9.81))), Fraction(robot["mass"]))
        load = wrench.get("load") or (0,) * 6
        arm = _turned([_exact(robot.get("center_of_mass") or (0, 0, 0))], self.turn).points[0]
        demand = -_dot(force, _add(weight, _exact(load[:3])))
        demand -= _dot(moment, _add(_cross(arm, weight), _exact(load[3:])))
        if wrench.get("vertices"):
            extra = wrench["vertices"]
            demand += max(_dot(force, _exact(w[:3])) + _dot(moment, _exact(w[3:])) for w in extra)
        else:
            demand += Fraction(wrench.get("force") or 0) * _root(_square(force), 0)
            demand += Fraction(wrench.get("moment") or 0) * _root(_square(moment), 0)
        center, radius = _along(corners[0], corners[7], half), _square(_sub(corners[7], corners[0])) / 4
        available = Fraction(0)
        for cable in cables:
            line = _sub(_sub(cable.outlet, cable.arm), center)
            pull = _farthest(_add(force, _cross(moment, cable.arm)), line, radius)
            least, most = map(Fraction, cable.tension or zero)
            available += max(least * pull, most * pull)
        return available < demand


def _farthest(q: Exact, line: Exact, radius: Fraction) -> Fraction:
    """An upper bound of q·u for the directions u to points at most √radius from the end of the line.

    The angle between u and the line is at most a, with sin a = √radius / |line|. So q·u is at most |q| cos(b - a) if
    the angle b between q and the line is at least a, else |q|.
    """
    size, square = _square(q), _square(line)
    sine = _root(radius / square, 1) if radius < square else Fraction(1)
    inner = _dot(q, line)
    along = inner / _root(square, inner < 0) if sine < 1 else Fraction(0)  # |q| cos b, rounded up
    rest = 1 - sine * sine
    if sine >= 1 or (along >= 0 and along * along >= size * rest):
        return _root(size, 1)
    return along * _root(rest, along >= 0) + sine * _root(max(size - along * along, Fraction(0)), 1)


def _moving(part: Hull, obstacle: Hull) -> Callable[[Fraction], Test]:
    return lambda gap: cache(lambda p: _near(Hull(tuple(_add(v, p) for v in part.points)), obstacle, gap))


def _crossing(fixed: Exact, zero: Exact, sign: int, body: Hull) -> Callable[[Fraction], Test]:
    return lambda gap: cache(lambda p: _near(Hull((fixed, _add(zero, _times(p, sign)))), body, gap))


def _entering(fixed: Exact, zero: Exact, sign: int, body: Hull) -> Callable[[Fraction], Test]:
    """A cable that starts on a body must not enter it: its moving end is within the margin of the cone into the body.

    The end is that near if the point at some fraction of the cable is within this fraction of the margin of the body.
    """

    def near(p: Exact, margin: Fraction) -> bool:
        end = _add(zero, _times(p, sign))
        return any(_near(Hull((_along(fixed, end, s),)), body, s * margin) for s in FRACTIONS_OF_A_CABLE)

    return lambda margin: cache(lambda p: near(p, margin))


def _kept(clearance: float, radii: float, attainable: float) -> Fraction:
    """The required distance, as far as some position allows it; at a tie within rounding, the smaller one."""
    return Fraction(next((gap for gap in (clearance + radii, radii) if gap <= attainable - 1e-12), 0.0))


def _is_flat(body: Hull) -> bool:
    """Whether a body has no volume, up to a few times the tolerance."""
    points = body.floats
    a = max(points, key=lambda p: math.dist(p, points[0]))
    b = max(points, key=lambda p: math.dist(p, a))
    edge = _sub(b, a)
    normal = max((_cross(edge, _sub(p, a)) for p in points), key=lambda n: _dot(n, n))
    size = math.hypot(*normal)
    return size == 0 or max(abs(_dot(normal, _sub(p, a))) for p in points) <= 4 * ON_SURFACE * size


def _body(spec: Mapping[str, Any]) -> tuple[Exact, ...]:
    """The vertices of a body's spec, in place."""
    if spec.get("box") is not None:
        corners: Any = product(*((-side / 2, side / 2) for side in spec["box"]))
    elif spec.get("prism") is not None:
        corners = ((x, y, z) for x, y in spec["prism"]["base"] for z in (0.0, spec["prism"]["height"]))
    elif spec.get("vertices") is not None:
        corners = spec["vertices"]
    else:
        raise ValueError("scene: found a body without box, prism or vertices, expected convex parts")
    position = _exact(spec.get("position") or (0, 0, 0))
    return tuple(_add(v, position) for v in _turned([_exact(v) for v in corners], _quaternion(spec)).points)


def _orientation(scene: Mapping[str, Any], given: Quaternion) -> Quaternion:
    """The orientation of the scene, or one of those that it leaves open, that equals the given one."""
    named = {spec["name"]: _quaternion(spec) for spec in scene.get("orientations") or []}
    chosen = (scene.get("query") or {}).get("orientation")
    choices = list(named.values()) or [(1.0, 0.0, 0.0, 0.0)]
    if chosen is not None:
        choices = [named[chosen] if isinstance(chosen, str) else tuple(chosen)]
    if abs(math.hypot(*given) - 1) > 1e-6:
        raise ValueError(f"orientation: found {list(given)}, expected a unit quaternion")
    for choice in choices:
        sizes = math.hypot(*choice), math.hypot(*given)
        if any(math.dist([x / sizes[0] for x in choice], [s * x / sizes[1] for x in given]) <= 5e-10 for s in (1, -1)):
            return choice
    raise ValueError(f"orientation: found {list(given)}, but the scene has another orientation: another question")


def _quaternion(spec: Mapping[str, Any]) -> Quaternion:
    """The rotation of a body or orientation: R = Rz(yaw) Ry(pitch) Rx(roll)."""
    if spec.get("quaternion") is not None:
        return tuple(spec["quaternion"])
    degrees = spec.get("rpy_degrees")
    angles = spec.get("rpy") or (0.0, 0.0, 0.0) if degrees is None else [math.radians(angle) for angle in degrees]
    (a, b, c), (x, y, z) = ([f(angle / 2) for angle in angles] for f in (math.cos, math.sin))
    return a * b * c + x * y * z, x * b * c - a * y * z, a * y * c + x * b * z, a * b * z - x * y * c


def _turned(points: Sequence[Exact], quaternion: Quaternion) -> Hull:
    """The points rotated by a quaternion, whose length is divided out exactly."""
    w, *rest = map(Fraction, quaternion)
    axis = rest[0], rest[1], rest[2]
    size = w * w + _square(axis)
    if not any(axis):
        return Hull(tuple(points))
    twice = [_times(_cross(axis, p), 2 / size) for p in points]
    turned = [_add(p, _add(_times(t, w), _cross(axis, t))) for p, t in zip(points, twice, strict=True)]
    return Hull(tuple(_exact([float(x) for x in p]) for p in turned))


# Vectors, of floats or of fractions


def _or(value: Any, default: Any) -> Any:
    return default if value is None else value


def _exact(p: Sequence[Any]) -> Exact:
    return Fraction(p[0]), Fraction(p[1]), Fraction(p[2])


def _add(p: Exact, q: Exact) -> Exact:
    return p[0] + q[0], p[1] + q[1], p[2] + q[2]


def _sub(p: tuple[N, N, N], q: tuple[N, N, N]) -> tuple[N, N, N]:
    return p[0] - q[0], p[1] - q[1], p[2] - q[2]


def _times(p: Exact, s: Fraction | int) -> Exact:
    return p[0] * s, p[1] * s, p[2] * s


def _along(p: Exact, q: Exact, s: Fraction) -> Exact:
    return _add(p, _times(_sub(q, p), s))


def _dot(p: tuple[N, N, N], q: tuple[N, N, N]) -> N:
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def _square(p: tuple[N, N, N]) -> N:
    return _dot(p, p)


def _cross(p: tuple[N, N, N], q: tuple[N, N, N]) -> tuple[N, N, N]:
    return p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]


def _root(x: Fraction, up: int) -> Fraction:
    """The square root, rounded down (0) or up (1) at about its 64th binary digit."""
    shift = max(0, 65 + (x.denominator.bit_length() - x.numerator.bit_length()) // 2)
    return Fraction(math.isqrt((x.numerator << 2 * shift) // x.denominator) + up, 1 << shift)
