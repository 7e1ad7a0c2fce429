"""Compare cdpr's bound of the shortest path with Drake's GraphOfConvexSets, on the same forbidden polyhedra.

    pip install drake
    python benches/shortest_drake.py
    python benches/shortest_drake.py hard1 --gap 0.0001

Run it in the folder of the project. cdpr plans a path with a gap, and writes a certificate of its bound, which lists
the forbidden polyhedra (docs/understand/bounds.md). Their complement in the box of positions is divided into convex
cells, exactly up to 1e-6 m: a cell that polyhedra still meet is cut along the plane of one of their faces, the one that
cuts the fewest other polyhedra. Where faces of two cells overlap with some area, the cells are neighbours.

Each cell is a vertex of Drake's graph, with two points in it and the distance between them as its cost; an edge
between neighbours makes the second point of one the first of the other. So the cheapest path through the graph is the
shortest path. The convex relaxation bounds its length from below; paths rounded from it bound it from above. Clarabel
solves, on one thread. The division is plain Python with NumPy. All times are processor time, of all threads.
"""

from __future__ import annotations

import argparse
import json
import logging
import tempfile
import time
from collections import defaultdict
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import cdpr

try:
    from pydrake.geometry.optimization import GraphOfConvexSets, GraphOfConvexSetsOptions, HPolyhedron, Point
    from pydrake.solvers import Binding, ClarabelSolver, Constraint, Cost, L2NormCost, LinearEqualityConstraint
except ImportError as error:
    raise SystemExit(f"found no package {error.name}, expected it: pip install drake") from None

Floats = NDArray[np.float64]
SCENES = Path(__file__).parents[1] / "testdata/scenes"
NAMES = ["hard1", "hard3"]
FIRST, LAST = slice(0, 3), slice(3, 6)  # of the two points of a cell
THIN = 1e-6  # m; what is thinner is left out
BALANCE = 0.1  # cut polyhedra for each polyhedron that one side has more than the other
Faces = dict[int, Floats]  # corners of each face, in order around it, by the number of its plane


class Planes:
    """Planes [n, d], n·x = d with |n| = 1; equal ones have one number, whichever way they face."""

    def __init__(self) -> None:
        self.rows = np.empty((0, 4))

    def number(self, plane: Floats) -> int:
        for sign in (1, -1):
            same = np.abs(self.rows - sign * plane).max(axis=1, initial=0) < THIN
            if same.any():
                return int(same.argmax())
        self.rows = np.vstack([self.rows, plane])
        return len(self.rows) - 1


def box_faces(planes: Planes, low: Floats, high: Floats) -> Faces:
    faces = {}
    for axis in range(3):
        for value in (low[axis], high[axis]):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            corners = np.empty((4, 3))
            corners[:, axis] = value
            corners[:, u] = [low[u], high[u], high[u], low[u]]
            corners[:, v] = [low[v], low[v], high[v], high[v]]
            faces[planes.number(np.append(np.eye(3)[axis], value))] = corners
    return faces


def around(points: Floats, normal: Floats) -> Floats:
    """Points of a plane in order around their middle, each once."""
    kept: list[Floats] = []
    for point in points:
        if all(np.abs(point - other).max() > THIN / 10 for other in kept):
            kept.append(point)
    found = np.array(kept)
    e1, e2 = axes_of(normal)
    rays = found - found.mean(axis=0)
    return found[np.argsort(np.arctan2(rays @ e2, rays @ e1))]


def axes_of(normal: Floats) -> tuple[Floats, Floats]:
    e1 = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    e1 /= np.linalg.norm(e1)
    return e1, np.cross(normal, e1)


def clipped(polygon: Floats, heights: Floats) -> Floats:
    """The part of a polygon where heights of its corners, linear in between, are not negative."""
    found = []
    for k, (point, height) in enumerate(zip(polygon, heights, strict=True)):
        before, below = polygon[k - 1], heights[k - 1]
        if below * height < 0:
            found.append(before + below / (below - height) * (point - before))
        if height >= 0:
            found.append(point)
    return np.array(found).reshape(-1, 3)


def split(faces: Faces, number: int, plane: Floats) -> tuple[Faces | None, Faces | None]:
    """The parts of a polyhedron below and above a plane; none where it is not thicker than THIN."""
    heights = {key: polygon @ plane[:3] - plane[3] for key, polygon in faces.items()}
    if max(values.max() for values in heights.values()) <= THIN:
        return faces, None
    if min(values.min() for values in heights.values()) >= -THIN:
        return None, faces
    sides: tuple[Faces, Faces] = {}, {}
    for key, polygon in faces.items():
        snapped = np.where(np.abs(heights[key]) <= THIN, 0.0, heights[key])
        for side, sign in zip(sides, (-1, 1), strict=True):
            part = clipped(polygon, sign * snapped)
            if len(part) > 2 and (sign * snapped > 0).any():
                side[key] = part
    for side in sides:
        corners = np.vstack(list(side.values()))
        side[number] = around(corners[np.abs(corners @ plane[:3] - plane[3]) <= 2 * THIN], plane[:3])
    return sides


def volume(faces: Faces) -> float:
    middle = np.vstack(list(faces.values())).mean(axis=0)
    total = 0.0
    for polygon in faces.values():
        rays = polygon - middle
        total += np.abs(np.cross(rays[1:-1], rays[2:]) @ rays[0]).sum() / 6
    return total


def free_cells(planes: Planes, box: Faces, regions: list[list[int]], polyhedra: list[Faces]) -> list[Faces]:
    """The complement of polyhedra in a box, as convex cells: by cuts along planes of their faces."""
    found, waiting = [], [(box, dict(enumerate(polyhedra)))]
    while waiting:
        cell, inside = waiting.pop()
        if not inside:
            found.append(cell)
            continue
        number = best_cut(planes, cell, regions, inside)
        if number is None:
            continue
        plane = planes.rows[number]
        parts = {key: split(part, number, plane) for key, part in inside.items()}
        for k, side in enumerate(split(cell, number, plane)):
            if side is not None:
                waiting.append((side, {key: part[k] for key, part in parts.items() if part[k] is not None}))
    return found


def best_cut(planes: Planes, cell: Faces, regions: list[list[int]], inside: dict[int, Faces]) -> int | None:
    """The plane of a face inside the cell that cuts the fewest polyhedra and leaves about as many on both sides.

    None if a polyhedron has no face inside: it fills the cell.
    """
    faces = {key: [number for number in regions[key] if number in part] for key, part in inside.items()}
    numbers = sorted(set().union(*faces.values()))
    rows = planes.rows[numbers]
    heights = np.vstack(list(cell.values())) @ rows[:, :3].T - rows[:, 3]
    cuts = (heights.max(axis=0) > THIN) & (heights.min(axis=0) < -THIN)
    candidates = [number for number, cut in zip(numbers, cuts, strict=True) if cut]
    if any(set(candidates).isdisjoint(mine) for mine in faces.values()):
        return None
    clouds = [np.vstack(list(part.values())) for part in inside.values()]
    firsts = np.cumsum([0] + [len(cloud) for cloud in clouds[:-1]])
    heights = np.vstack(clouds) @ rows[cuts, :3].T - rows[cuts, 3]
    above = np.maximum.reduceat(heights, firsts) > THIN
    below = np.minimum.reduceat(heights, firsts) < -THIN
    uneven = np.abs(above.sum(axis=0) - below.sum(axis=0))
    return candidates[int(np.argmin((above & below).sum(axis=0) + BALANCE * uneven))]


def neighbouring(planes: Planes, cells: list[Faces]) -> list[tuple[int, int]]:
    """Pairs of cells that meet in more than a line."""
    on: dict[int, list[tuple[int, Floats]]] = defaultdict(list)
    for k, cell in enumerate(cells):
        for number, polygon in cell.items():
            on[number].append((k, polygon))
    middles = [np.vstack(list(cell.values())).mean(axis=0) for cell in cells]
    found = []
    for number, faces in on.items():
        normal, d = planes.rows[number, :3], planes.rows[number, 3]
        upper = [(k, polygon) for k, polygon in faces if middles[k] @ normal > d]
        lower = [(k, polygon) for k, polygon in faces if middles[k] @ normal < d]
        for a, first in upper:
            for b, second in lower:
                gaps = np.maximum(first.min(axis=0) - second.max(axis=0), second.min(axis=0) - first.max(axis=0))
                if gaps.max() <= THIN and overlap(first, second, normal):
                    found.append((a, b))
    return found


def overlap(first: Floats, second: Floats, normal: Floats) -> bool:
    """Whether what two convex polygons of a plane have in common has a width."""
    middle, polygon = second.mean(axis=0), first
    for k in range(len(second)):
        inward = np.cross(normal, second[k] - second[k - 1])
        length = np.linalg.norm(inward)
        if length <= THIN:
            continue
        inward *= np.sign(inward @ (middle - second[k])) / length
        polygon = clipped(polygon, (polygon - second[k]) @ inward)
        if len(polygon) < 3:
            return False
    rays = polygon - polygon[0]
    area = np.linalg.norm(np.cross(rays[1:-1], rays[2:]).sum(axis=0)) / 2
    return bool(area > THIN * np.ptp(polygon, axis=0).max())


def as_set(planes: Planes, cell: Faces) -> HPolyhedron:
    rows = planes.rows[list(cell)]
    middle = np.vstack(list(cell.values())).mean(axis=0)
    outward = np.where(rows[:, :3] @ middle > rows[:, 3], -1, 1)[:, None] * rows
    return HPolyhedron(outward[:, :3], outward[:, 3])


class Graph:
    """Drake's graph of cells, start and goal."""

    def __init__(self, planes: Planes, cells: list[Faces], neighbours: list[tuple[int, int]], ends: Floats) -> None:
        self.graph = GraphOfConvexSets()
        self.start, self.goal = (self.graph.AddVertex(Point(end)) for end in ends)
        distance = L2NormCost(np.hstack([np.eye(3), -np.eye(3)]), np.zeros(3))
        vertices = []
        for cell in cells:
            vertices.append(self.graph.AddVertex(as_set(planes, cell).CartesianProduct(as_set(planes, cell))))
            vertices[-1].AddCost(Binding[Cost](distance, vertices[-1].x()))
        for a, b in neighbours:
            for u, v in ((vertices[a], vertices[b]), (vertices[b], vertices[a])):
                self.connect(u, v, LAST, FIRST)
        for cell, vertex in zip(cells, vertices, strict=True):
            if as_set(planes, cell).PointInSet(ends[0], THIN):
                self.connect(self.start, vertex, FIRST, FIRST)
            if as_set(planes, cell).PointInSet(ends[1], THIN):
                self.connect(vertex, self.goal, LAST, FIRST)

    def connect(self, u: GraphOfConvexSets.Vertex, v: GraphOfConvexSets.Vertex, of_u: slice, of_v: slice) -> None:
        """An edge whose two points are equal."""
        edge = self.graph.AddEdge(u, v)
        equal = LinearEqualityConstraint(np.hstack([np.eye(3), -np.eye(3)]), np.zeros(3))
        edge.AddConstraint(Binding[Constraint](equal, np.concatenate([edge.xu()[of_u], edge.xv()[of_v]])))

    def solved(self, paths: int) -> tuple[float, float, float, float]:
        """Length of the relaxation and of the shortest rounded path, m, and seconds for both."""
        options = GraphOfConvexSetsOptions()
        options.convex_relaxation, options.preprocessing, options.max_rounded_paths = True, False, 0
        options.solver = ClarabelSolver()
        began = time.process_time()
        relaxed = self.graph.SolveShortestPath(self.start, self.goal, options)
        bounded = time.process_time()
        if not relaxed.is_success():
            raise SystemExit(f"found no solution: {relaxed.get_solution_result()}")
        options.max_rounded_paths, options.max_rounding_trials = paths, 10 * paths
        ways = self.graph.SamplePaths(self.start, self.goal, relaxed, options)
        results = [self.graph.SolveConvexRestriction(way, options) for way in ways]
        shortest = min((result.get_optimal_cost() for result in results if result.is_success()), default=np.inf)
        return relaxed.get_optimal_cost(), shortest, bounded - began, time.process_time() - bounded


def compare(name: str, gap: float, paths: int) -> None:
    scene = cdpr.Scene.load(SCENES / f"{name}.toml")
    began = time.process_time()
    result = cdpr.plan(scene, gap=gap)
    planned = time.process_time()
    bound = cdpr.lower_bound(scene, gap=gap)
    bounded = time.process_time()
    print(f"{name}\n  cdpr.plan: {planned - began:.3f} s, {result.cost:.6f} m, at most {100 * gap:g} % too long")
    print(f"  cdpr.lower_bound: {bounded - planned:.3f} s, {bound:.6f} m, gap {100 * (result.cost / bound - 1):.4f} %")
    with tempfile.TemporaryDirectory() as folder:
        cdpr.lower_bound(scene, gap=0.01, certificate=Path(folder) / "bound.json")
        certificate = json.loads((Path(folder) / "bound.json").read_text())
    began = time.process_time()
    planes, box = Planes(), np.array(certificate["box"], dtype=float).reshape(2, 3)
    faces = box_faces(planes, *box)
    regions, polyhedra = [], []
    for region in certificate["regions"]:
        numbers = [planes.number(np.array(row)) for row in region["half_spaces"]]
        part: Faces | None = faces
        for number, row in zip(numbers, region["half_spaces"], strict=True):
            part = split(part, number, np.array(row))[0] if part else None
        if part:
            regions.append(numbers)
            polyhedra.append(part)
    cells = free_cells(planes, faces, regions, polyhedra)
    neighbours = neighbouring(planes, cells)
    divided = time.process_time()
    free = sum(map(volume, cells))
    graph = Graph(planes, cells, neighbours, np.array([certificate["start"], certificate["goal"]]))
    made = time.process_time()
    graph = Graph(planes, cells, neighbours, np.array([certificate["start"], certificate["goal"]]))
    made = time.process_time()
    print(f"  division: {divided - began:.2f} s, {len(polyhedra)} polyhedra, {len(cells)} cells of {free:.3f} m³")
    sizes = f"{graph.graph.num_vertices()} vertices, {graph.graph.num_edges()} edges"
    print(f"  graph: {made - divided:.2f} s, {sizes}", flush=True)
    length, path, relaxing, rounding = graph.solved(paths)
    excess = 100 * (result.cost / length - 1)
    print(f"  Drake's bound: {relaxing:.3f} s, {length:.6f} m; gap of cdpr's path {excess:.5f} %")
    print(f"  Drake's path: {rounding:.3f} s, {path:.6f} m, gap {100 * (path / length - 1):.5f} %")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help=f"some of: {', '.join(NAMES)}")
    parser.add_argument("--gap", type=float, default=0.001, help="of cdpr")
    parser.add_argument("--paths", type=int, default=1000, help="paths rounded from Drake's relaxation")
    given = parser.parse_args()
    if unknown := set(given.scenes) - set(NAMES):
        parser.error(f"found {', '.join(sorted(unknown))}, expected some of {', '.join(NAMES)}")
    logging.getLogger("drake").setLevel(logging.WARNING)
    for name in given.scenes or NAMES:
        compare(name, given.gap, given.paths)


if __name__ == "__main__":
    main()
