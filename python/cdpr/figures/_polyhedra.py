"""Convex solids in parallel projection: visible faces, order of depth, and hidden parts of lines."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from .._arrays import Floats

# How far a line may dip below the surface of a solid and still count as lying on it, relative to the size of the solid.
# Pictures are thousands of dots wide, so this is far below what can be seen.
_ON_SURFACE = 1e-6
# Normals closer than this belong to one flat face.
_SAME_NORMAL = 1e-6


@dataclass(frozen=True, eq=False)
class Solid:
    """A convex body: corners (n, 3), and faces as corners counter-clockwise seen from outside."""

    vertices: Floats
    faces: list[list[int]]
    colour: str
    name: str

    @cached_property
    def normals(self) -> Floats:
        """Outward unit normal of each face."""
        return np.array([normal(self.vertices[face]) for face in self.faces], dtype=np.float64).reshape(-1, 3)

    @cached_property
    def offsets(self) -> Floats:
        """Offset of each face: normal · x <= offset inside."""
        return np.array([np.max(self.vertices @ n) for n in self.normals], dtype=np.float64)

    @property
    def slack(self) -> float:
        """Depth at which a point counts as lying on the surface, m."""
        return _ON_SURFACE * float(np.ptp(self.vertices, axis=0).max())

    def has_on_surface(self, points: Floats) -> bool:
        """Tell whether all points lie on one face."""
        heights = points @ self.normals.T - self.offsets
        return bool((heights < self.slack).all() and (heights > -self.slack).all(axis=0).any())


def normal(corners: Floats) -> Floats:
    """Return the unit normal of a polygon, by Newell's sum; zero where it has no area."""
    spokes = corners[1:] - corners[0]
    area = np.cross(spokes[:-1], spokes[1:]).sum(axis=0)
    length = float(np.linalg.norm(area))
    unit: Floats = area / length if length > 0 else np.zeros(3)
    return unit


def hidden(solid: Solid, start: Floats, end: Floats, toward: Floats) -> tuple[float, float] | None:
    """Return the part of a segment that a solid hides, as fractions; None if all of it is visible.

    A point a + t (b − a) is hidden if going on by some s >= 0 towards the viewer meets the solid. Those (t, s) are a
    convex polygon, cut from a rectangle by one line for each face.
    """
    if not solid.faces:
        return None
    reach = float(np.max(np.abs([*solid.vertices, start, end]))) * 4 + 1
    corners = [(0.0, 0.0), (1.0, 0.0), (1.0, reach), (0.0, reach)]
    along, up = solid.normals @ (end - start), solid.normals @ toward
    limits = solid.offsets - solid.slack - solid.normals @ start
    for a, b, c in zip(along.tolist(), up.tolist(), limits.tolist(), strict=True):
        corners = _cut(corners, a, b, c)
    if not corners:
        return None
    fractions = [t for t, _ in corners]
    return min(fractions), max(fractions)


def _cut(corners: list[tuple[float, float]], a: float, b: float, c: float) -> list[tuple[float, float]]:
    """Clip a convex polygon to a t + b s < c."""
    kept: list[tuple[float, float]] = []
    heights = [a * t + b * s - c for t, s in corners]
    for k, (point, height) in enumerate(zip(corners, heights, strict=True)):
        before, height_before = corners[k - 1], heights[k - 1]
        if (height < 0) != (height_before < 0):
            share = height_before / (height_before - height)
            kept.append((before[0] + share * (point[0] - before[0]), before[1] + share * (point[1] - before[1])))
        if height < 0:
            kept.append(point)
    return kept


def visible(solids: list[Solid], start: Floats, end: Floats, toward: Floats) -> list[Floats]:
    """Return the parts of a segment that no solid hides, each (2, 3)."""
    gaps = sorted(gap for solid in solids if (gap := hidden(solid, start, end, toward)))
    parts, shown_from = [], 0.0
    for first, last in [*gaps, (1.0, 1.0)]:
        if first > shown_from:
            share = np.array([[shown_from], [first]])
            parts.append((1 - share) * start + share * end)  # exact at both ends
        shown_from = max(shown_from, last)
    return parts


def back_to_front(solids: list[Solid], toward: Floats) -> list[Solid]:
    """Order solids so that each comes before those that hide it.

    A face of one of two disjoint convex solids decides; if none does, the solid with the nearer centre comes later.
    """
    by_depth = sorted(solids, key=lambda solid: float(solid.vertices.mean(axis=0) @ toward))
    low, high = np.array([_paper_box(solid.vertices, toward) for solid in by_depth]).reshape(-1, 2, 2).swapaxes(0, 1)
    meets: NDArray[np.bool_] = np.logical_and(np.all(low[:, None] < high, axis=2), np.all(low < high[:, None], axis=2))
    waiting = {
        k: {int(j) for j in np.flatnonzero(meets[k]) if j != k and _before(front, by_depth[j], toward)}
        for k, front in enumerate(by_depth)
    }
    ordered: list[int] = []
    while waiting:
        following = next((k for k, behind in waiting.items() if behind.isdisjoint(waiting)), next(iter(waiting)))
        del waiting[following]
        ordered.append(following)
    return [by_depth[k] for k in ordered]


def _before(front: Solid, back: Solid, toward: Floats) -> bool:
    """Tell whether a face of one solid shows that the first is nearer to the eye."""
    return _beyond(back, front.vertices, back.normals @ toward > 0) or _beyond(
        front, back.vertices, front.normals @ toward < 0
    )


def _beyond(solid: Solid, points: Floats, faces: NDArray[np.bool_]) -> bool:
    """Tell whether all points lie outside of one of these faces."""
    heights = points @ solid.normals[faces].T - solid.offsets[faces]
    return bool((heights.min(axis=0) > -solid.slack).any())


def overlap(a: Floats, b: Floats, toward: Floats) -> bool:
    """Tell whether the pictures of two sets of points can overlap, by their boxes on the paper."""
    (low, high), (other_low, other_high) = _paper_box(a, toward), _paper_box(b, toward)
    return bool((low < other_high).all() and (other_low < high).all())


def _paper_box(points: Floats, toward: Floats) -> tuple[Floats, Floats]:
    flat = points @ np.column_stack(paper_axes(toward))
    return flat.min(axis=0), flat.max(axis=0)


def paper_axes(toward: Floats) -> tuple[Floats, Floats]:
    """World directions of right and up on the paper."""
    right = np.cross([0.0, 0.0, 1.0], toward)
    if not right.any():
        right = np.array([0.0, 1.0, 0.0])
    right = right / np.linalg.norm(right)
    return right, np.cross(toward, right)


def faces_of_mesh(vertices: Floats, triangles: NDArray[np.int64]) -> list[Floats]:
    """Merge triangles of a closed mesh that lie in one plane and share an edge to polygons, each (k, 3)."""
    normals = [normal(vertices[triangle]) for triangle in triangles]
    owner = {(int(t[k - 1]), int(t[k])): index for index, t in enumerate(triangles) for k in range(3)}
    group = list(range(len(triangles)))

    def root(index: int) -> int:
        while group[index] != index:
            index = group[index]
        return index

    for (i, j), index in owner.items():
        other = owner.get((j, i))
        flat = not normals[index].any()
        if other is not None and (flat or float(normals[index] @ normals[other]) > 1 - _SAME_NORMAL):
            group[root(index)] = root(other)
    members: dict[int, list[int]] = defaultdict(list)
    for index in range(len(triangles)):
        members[root(index)].append(index)
    return [polygon for found in members.values() for polygon in _outlines(vertices, triangles[found])]


def _outlines(vertices: Floats, triangles: NDArray[np.int64]) -> list[Floats]:
    """Return the outline of flat triangles that share edges; the triangles themselves if the outline is not a single loop."""
    edges = {(int(t[k - 1]), int(t[k])) for t in triangles for k in range(3)}
    following = {i: j for i, j in edges if (j, i) not in edges}
    loop = [next(iter(following))] if following else []
    while loop and (after := following.get(loop[-1])) is not None and after != loop[0] and len(loop) <= len(following):
        loop.append(after)
    if len(loop) != len(following) or len(following) != len([e for e in edges if e[::-1] not in edges]):
        return [vertices[triangle] for triangle in triangles]
    return [vertices[loop]]
