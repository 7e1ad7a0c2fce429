"""The boxes of a certificate: inside their regions, tiling the box of positions, separating start and goal."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

from ._certificate import Certificate

NEAR_END = 0.999e-3  # m


def _integers(numbers: Sequence[float]) -> tuple[list[int], int]:
    """Return the numbers times a common power of two that makes them integers, and this power."""
    ratios = [x.as_integer_ratio() for x in numbers]
    power = max((below for _, below in ratios), default=1)
    return [above * (power // below) for above, below in ratios], power


def check_inside(proof: Certificate) -> None:
    """Check that each box that is closed by a region is inside it: n·x < d at its corner farthest along n."""
    coordinates, unit = _integers([x for box in proof.boxes for x in box])
    planes = [[_integers(plane)[0] for plane in region.half_spaces] for region in proof.regions]
    for k, kind in enumerate(proof.kinds):
        box = coordinates[6 * k : 6 * k + 6]
        for *n, d in planes[kind] if kind >= 0 else ():
            if sum(n[i] * box[i + 3 if n[i] > 0 else i] for i in range(3)) >= d * unit:
                raise ValueError(f"boxes[{k}]: found a corner outside region {kind}, expected all of the box inside")


def tiling_of(whole: tuple[float, ...], boxes: Sequence[tuple[float, ...]]) -> list[Any]:
    """Return a tree of cuts that proves that the boxes tile the whole: [axis, cut, below, above] or the index of a box."""
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
    """Return the axis and coordinate of a plane through the cell that contains a face and passes through no box."""
    for axis in range(3):
        low, high = cell[axis], cell[axis + 3]
        faces = {x for box in boxes for x in (box[axis], box[axis + 3]) if low < x < high}
        at = min(faces, key=lambda x: abs(x - (low + high) / 2), default=low)
        if faces and not any(box[axis] < at < box[axis + 3] for box in boxes):
            return axis, at
    return None


def _touching(tree: list[Any], box: Sequence[float]) -> Iterator[int]:
    """Return the boxes of the tiling that touch this one, even if only in a point."""
    stack: list[Any] = [tree]
    while stack:
        node = stack.pop()
        if isinstance(node, int):
            yield node
            continue
        axis, at, below, above = node
        stack += ([below] if box[axis] <= at else []) + ([above] if box[axis + 3] >= at else [])


def check_open_around(name: str, point: Sequence[float], proof: Certificate) -> None:
    """Nothing is closed within 1 mm of an end that touches something which the other end does not."""
    for k, box in enumerate(proof.boxes):
        near = all(box[i] < point[i] + NEAR_END and point[i] - NEAR_END < box[i + 3] for i in range(3))
        if near and proof.kinds[k] != -1:
            raise ValueError(f"{name}: found contact there, and boxes[{k}] closed beside it, expected it open for 1 mm")


def check_separation(proof: Certificate, tree: list[Any]) -> None:
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
