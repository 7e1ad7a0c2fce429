"""Bodies and orientations of a scene, from its plain data."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import combinations, product
from typing import Any, TypeAlias

from ._hulls import Hull
from ._vectors import COPLANAR, ON_SURFACE, Exact, Vector, cross, dot, exact, minus, plus, scaled, squared

Quaternion: TypeAlias = tuple[float, ...]


def is_flat(body: Hull) -> bool:
    """Tell whether a body has no volume, up to a few times the tolerance."""
    points = body.floats
    a = max(points, key=lambda p: math.dist(p, points[0]))
    b = max(points, key=lambda p: math.dist(p, a))
    edge = minus(b, a)
    normal = max((cross(edge, minus(p, a)) for p in points), key=lambda n: dot(n, n))
    size = math.hypot(*normal)
    return size == 0 or max(abs(dot(normal, minus(p, a))) for p in points) <= 4 * ON_SURFACE * size


def faces_at(point: Exact, body: Hull) -> list[Exact]:
    """Outward normals of the faces of a body that contain a point.

    Every plane through three vertices is a face if no vertex lies above it. Of those that coincide up to rounding, the
    one through the largest triangle counts.
    """
    vertices, (p,) = body.floats, Hull((point,)).floats
    faces: list[tuple[float, Vector, tuple[Vector, ...]]] = []
    for corners in combinations(vertices, 3):
        normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))
        size = math.hypot(*normal)
        if size <= 1e-9 * math.dist(corners[0], corners[1]) * math.dist(corners[0], corners[2]):
            continue  # the three are on a line
        unit = normal[0] / size, normal[1] / size, normal[2] / size
        if abs(dot(unit, minus(p, corners[0]))) > ON_SURFACE:
            continue
        heights = [dot(unit, minus(v, corners[0])) for v in vertices]
        if max(heights) <= COPLANAR:
            faces.append((size, unit, corners))
        elif min(heights) >= -COPLANAR:
            faces.append((size, minus((0.0, 0.0, 0.0), unit), corners))
    kept: list[tuple[Vector, Vector]] = []
    for _, unit, triangle in sorted(faces, reverse=True):
        if not any(_is_on(triangle, unit, face) for face in kept):
            kept.append((unit, triangle[0]))
    return [exact(unit) for unit, _ in kept]


def _is_on(triangle: Sequence[Vector], unit: Vector, face: tuple[Vector, Vector]) -> bool:
    """Tell whether a triangle with this normal is part of a face, given by its normal and a point."""
    normal, at = face
    return dot(normal, unit) >= 1 - 1e-9 and all(abs(dot(normal, minus(v, at))) <= COPLANAR for v in triangle)


def vertices_of(spec: Mapping[str, Any]) -> tuple[Exact, ...]:
    """Return the vertices of a body's spec, in place."""
    if spec.get("box") is not None:
        corners: Any = product(*((-side / 2, side / 2) for side in spec["box"]))
    elif spec.get("prism") is not None:
        corners = ((x, y, z) for x, y in spec["prism"]["base"] for z in (0.0, spec["prism"]["height"]))
    elif spec.get("vertices") is not None:
        corners = spec["vertices"]
    else:
        raise ValueError("scene: found a body without box, prism or vertices, expected convex parts")
    position = exact(spec.get("position") or (0, 0, 0))
    return tuple(plus(v, position) for v in rotated([exact(v) for v in corners], _quaternion(spec)).points)


def orientation_of(scene: Mapping[str, Any], given: Quaternion) -> Quaternion:
    """Return the orientation of the scene, or one of those that it leaves open, that equals the given one."""
    chosen = (scene.get("query") or {}).get("orientation")
    choices = list(_named(scene).values()) or [(1.0, 0.0, 0.0, 0.0)]
    if chosen is not None:
        choices = [_chosen(scene, chosen)]
    if abs(math.hypot(*given) - 1) > 1e-6:
        raise ValueError(f"orientation: found {list(given)}, expected a unit quaternion")
    for choice in choices:
        if _same(choice, given):
            return choice
    raise ValueError(f"orientation: found {list(given)}, but the scene has another orientation: another question")


def may_turn(scene: Mapping[str, Any], orientation: Quaternion) -> bool:
    """Tell whether paths of a scene may turn, or have ends at other orientations than this one."""
    query = scene.get("query") or {}
    ends = [query[key] for key in ("start_orientation", "goal_orientation") if query.get(key) is not None]
    return scene.get("turning") is not None or not all(_same(_chosen(scene, end), orientation) for end in ends)


def _named(scene: Mapping[str, Any]) -> dict[str, Quaternion]:
    return {spec["name"]: _quaternion(spec) for spec in scene.get("orientations") or []}


def _chosen(scene: Mapping[str, Any], chosen: Any) -> Quaternion:
    return _named(scene)[chosen] if isinstance(chosen, str) else tuple(chosen)


def _same(a: Quaternion, b: Quaternion) -> bool:
    sizes = math.hypot(*a), math.hypot(*b)
    return any(math.dist([x / sizes[0] for x in a], [s * x / sizes[1] for x in b]) <= 5e-10 for s in (1, -1))


def _quaternion(spec: Mapping[str, Any]) -> Quaternion:
    """Return the rotation of a body or orientation: R = Rz(yaw) Ry(pitch) Rx(roll)."""
    if spec.get("quaternion") is not None:
        return tuple(spec["quaternion"])
    degrees = spec.get("rpy_degrees")
    angles = spec.get("rpy") or (0.0, 0.0, 0.0) if degrees is None else [math.radians(angle) for angle in degrees]
    (a, b, c), (x, y, z) = ([f(angle / 2) for angle in angles] for f in (math.cos, math.sin))
    return a * b * c + x * y * z, x * b * c - a * y * z, a * y * c + x * b * z, a * b * z - x * y * c


def rotated(points: Sequence[Exact], quaternion: Quaternion) -> Hull:
    """Return the points rotated by a quaternion, whose length is divided out exactly."""
    w, *rest = map(Fraction, quaternion)
    axis = rest[0], rest[1], rest[2]
    size = w * w + squared(axis)
    if not any(axis):
        return Hull(tuple(points))
    twice = [scaled(cross(axis, p), 2 / size) for p in points]
    turned = [plus(p, plus(scaled(t, w), cross(axis, t))) for p, t in zip(points, twice, strict=True)]
    return Hull(tuple(exact([float(x) for x in p]) for p in turned))
