"""Compare `cdpr.trajectory` with TOPP-RA (https://github.com/hungpham2511/toppra) and copp (https://copp.pro) on the
same curves and limits.

    pip install toppra copp-py
    python benches/trajectory_toppra.py
    python benches/trajectory_toppra.py "hard1, platform" --grid 1000

Run it in the folder of the project. For each case, cdpr plans a path and a motion along it; the others then get the
curve of that motion, in the exact form of the trajectory file, and the same limits as linear rows a u + b x <= c in u
= s'' and x = s'^2, at N grid points. Stretches between stops are solved one after the other, each with its share of
the N points, at least 100. TOPP-RA's discretization is "interpolation": the rows of both ends of an interval hold, as
they do in copp's solver `topp2_ra`. copp is a Rust library; PyPI's copp-py is its Python binding. Two limits differ:

- The norm of the platform's acceleration is not linear. It is replaced by tangents in the plane of the curve's first
  two derivatives, from outside: the others may exceed the limit by 1/cos(pi/tangents) - 1 (0.002 % for 512 tangents),
  so their durations are a little too short.
- cdpr leaves 0.01 % of the range of each tension unused, for its proof between instants; the rows use all of it.

"excess" is the largest violation of a limit at twenty instants within every interval (of cdpr: at 20 000 instants),
as a share of the limit. Times are processor time, of all threads. Those of cdpr include its check of the path, the
proof that the curve is free, and the proofs between instants; those of the others are rows and solution, and do not
include any of this.
"""

from __future__ import annotations

import argparse
import itertools
import json
import logging
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import cdpr

try:
    import copp_py as copp
    import toppra
    from toppra.algorithm import TOPPRA
    from toppra.constraint import DiscretizationType, LinearConstraint
    from toppra.interpolator import AbstractGeometricPath
except ImportError as error:
    raise SystemExit(f"found no package {error.name}, expected it: pip install toppra copp-py") from None

Floats = NDArray[np.float64]
SCENES = Path(__file__).parents[1] / "testdata/scenes"
CASES: dict[str, tuple[str, dict[str, float]]] = {
    "hard1, platform": ("hard1", {"speed": 1.0, "acceleration": 2.0, "blend": 0.03}),
    "hard3, platform": ("hard3", {"speed": 1.0, "acceleration": 2.0, "blend": 0.03}),
    "hard3, cables": ("hard3", {"cable_speed": 0.5, "cable_acceleration": 1.0, "blend": 0.03}),
    "cogiro, tensions": ("cogiro", {"blend": 0.0}),
    "cogiro, tensions and platform": ("cogiro", {"acceleration": 8.0, "blend": 0.2}),
    "cogiro, all": ("cogiro", {"speed": 2.0, "acceleration": 4.0, "cable_speed": 1.5, "blend": 0.2}),
}
LEAST = 100  # intervals of a stretch
WITHIN = 20  # instants in each interval
INSTANTS = 20_000
AT_ONCE = 1000  # grid points whose facets are computed at once
NO_SLACK = 1e-9


class Curve(AbstractGeometricPath):  # type: ignore[misc]
    """A stretch of the curve of a trajectory file."""

    def __init__(self, pieces: list[dict[str, Any]]) -> None:
        self.powers, lengths = [], []
        for piece in pieces:
            (kind, points) = next(iter(piece.items()))
            control = np.array(points)
            degree = len(control) - 1
            lengths.append(degree * float(np.linalg.norm(control[1] - control[0])))
            self.powers.append(powers(control))
            assert (kind, degree) in (("line", 1), ("bend", 5))
        self.starts = np.concatenate([[0.0], np.cumsum(lengths)])

    def __call__(self, path_positions: Any, order: int = 0) -> Floats:
        s = np.atleast_1d(path_positions)
        found = np.zeros((len(s), 3))
        piece = np.clip(np.searchsorted(self.starts, s, side="right") - 1, 0, len(self.powers) - 1)
        for k in np.unique(piece):
            mine, length = piece == k, self.starts[k + 1] - self.starts[k]
            u = (s[mine] - self.starts[k]) / length
            found[mine] = np.polynomial.polynomial.polyval(u, derivative(self.powers[k], order)).T / length**order
        return found if np.ndim(path_positions) else found[0]

    @property
    def dof(self) -> int:
        return 3

    @property
    def path_interval(self) -> Floats:
        return np.array([0.0, self.starts[-1]])

    @property
    def waypoints(self) -> tuple[Floats, Floats]:
        return self.starts, self(self.starts)

    def grid(self, count: int) -> Floats:
        """About so many intervals of equal length, at least eight on each piece; joints of pieces are among the points."""
        shares = np.maximum(8, np.round(count * np.diff(self.starts) / self.starts[-1])).astype(int)
        parts = [np.linspace(a, b, n, endpoint=False) for a, b, n in zip(self.starts, self.starts[1:], shares, strict=False)]
        return np.append(np.concatenate(parts), self.starts[-1])


def powers(control: Floats) -> Floats:
    """Coefficients of the powers of the parameter from 0 to 1, from control points."""
    if len(control) == 2:
        return np.array([control[0], control[1] - control[0]])
    found, differences, binomial = [control[0]], control, 1.0
    for k in range(1, len(control)):
        differences = np.diff(differences, axis=0)
        binomial *= (len(control) - k) / k
        found.append(binomial * differences[0])
    return np.array(found)


def derivative(coefficients: Floats, order: int) -> Floats:
    return coefficients if order == 0 else np.polynomial.polynomial.polyder(coefficients, order)


def stretches(file: dict[str, Any]) -> Iterator[Curve]:
    """The stretches of a curve between stops."""
    stops = [file["waypoints"][corner["waypoint"]] for corner in file["corners"] if corner["kind"] == "stop"]
    pieces: list[dict[str, Any]] = []
    for piece in file["curve"]:
        if pieces and any(np.allclose(next(iter(piece.values()))[0], stop, rtol=0, atol=1e-9) for stop in stops):
            yield Curve(pieces)
            pieces = []
        pieces.append(piece)
    yield Curve(pieces)


Rows = tuple[Floats, Floats, Floats]  # a, b, c of a u + b x <= c, each (n, rows)


class Limits:
    """The limits of a motion along a curve, as rows."""

    def __init__(self, scene: cdpr.Scene, motion: cdpr.Trajectory, tangents: int) -> None:
        self.robot, self.limits, self.tangents = scene.robot, motion.limits, tangents
        self.turn, self.gravity = motion.orientation, scene.gravity
        self.tensions = motion.tension_limits
        self.load = np.array((scene.wrench or {}).get("load", [0.0] * 6))
        w, x, y, z = self.turn
        self.rotation = np.array([
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ])  # fmt: skip

    def rows(self, q: Floats, q1: Floats, q2: Floats) -> Iterator[Rows]:
        """Blocks of rows at positions with these derivatives."""
        if (speed := self.limits.get("speed")) is not None:
            yield np.zeros((len(q), 1)), (q1**2).sum(axis=1, keepdims=True), np.full((len(q), 1), speed**2)
        if (most := self.limits.get("acceleration")) is not None:
            yield from blocks(self.tangent_rows(q1, q2, most))
        lines = q[:, None] + self.robot.attachments @ self.rotation.T - self.robot.outlets
        lengths = np.linalg.norm(lines, axis=2)
        rates = np.einsum("nmk,nk->nm", lines, q1) / lengths
        if (speed := self.limits.get("cable_speed")) is not None:
            yield np.zeros_like(rates), rates**2, np.full_like(rates, speed**2)
        if (most := self.limits.get("cable_acceleration")) is not None:
            bends = ((q1**2).sum(axis=1)[:, None] + np.einsum("nmk,nk->nm", lines, q2) - rates**2) / lengths
            yield np.hstack([rates, -rates]), np.hstack([bends, -bends]), np.full((len(q), 2 * rates.shape[1]), most)
        if self.tensions is not None:
            yield from blocks(self.facet_rows(q, q1, q2))

    def tangent_rows(self, q1: Floats, q2: Floats, most: float) -> Rows:
        """Tangents of the disc |q1 u + q2 x| <= most, in the plane of both."""
        e1 = q1 / np.linalg.norm(q1, axis=1, keepdims=True)
        across = q2 - (q2 * e1).sum(axis=1, keepdims=True) * e1
        size = np.linalg.norm(across, axis=1, keepdims=True)
        e2 = np.where(size > 1e-12, across / np.maximum(size, 1e-300), 0.0)
        angles = 2 * np.pi * np.arange(self.tangents) / self.tangents
        part = [np.cos(angles) * (v * e1).sum(axis=1)[:, None] + np.sin(angles) * (v * e2).sum(axis=1)[:, None] for v in (q1, q2)]
        return part[0], part[1], np.full_like(part[0], most)

    def facet_rows(self, q: Floats, q1: Floats, q2: Floats) -> Rows:
        """The facets of the wrenches that the cables can exert."""
        assert self.tensions is not None and self.robot.mass is not None
        matrices = cdpr.wrench_matrix(self.robot, q, orientation=self.turn)
        center = self.rotation @ self.robot.center_of_mass

        def wrench(accelerations: Floats) -> Floats:
            force = self.robot.mass * accelerations
            return np.hstack([force, np.cross(center, force)])

        at_rest = wrench(np.broadcast_to(-self.gravity, q.shape)) - self.load
        demands = wrench(q1), wrench(q2)
        found = []
        for first in range(0, len(q), AT_ONCE):
            part = slice(first, first + AT_ONCE)
            normals = facet_normals(matrices[part])
            heights = np.einsum("nfk,nkm->nfm", normals, matrices[part])
            ends = heights[..., None] * self.tensions
            outs = ends.max(axis=3).sum(axis=2), -ends.min(axis=3).sum(axis=2)
            a, b, rest = (np.einsum("nfk,nk->nf", normals, values[part]) for values in (*demands, at_rest))
            found.append((np.hstack([a, -a]), np.hstack([b, -b]), np.hstack([outs[0] - rest, outs[1] + rest])))
        a, b, c = (np.vstack(column) for column in zip(*found, strict=True))
        return a, b, c


def facet_normals(matrices: Floats) -> Floats:
    """Unit normals of all pairs of parallel facets of zonotopes, (n, f, 6): across each five generators."""
    generators = matrices / np.linalg.norm(matrices, axis=1, keepdims=True)
    subsets = list(itertools.combinations(range(matrices.shape[2]), 5))
    chosen = np.stack([generators[:, :, subset] for subset in subsets], axis=1)  # (n, f, 6, 5)
    minors = [np.delete(chosen, row, axis=2) for row in range(6)]
    normals = np.stack([(-1) ** row * np.linalg.det(minor) for row, minor in enumerate(minors)], axis=2)
    sizes = np.linalg.norm(normals, axis=2, keepdims=True)
    return np.where(sizes > 1e-10, normals / np.maximum(sizes, 1e-300), 0.0)


def blocks(rows: Rows, size: int = 16) -> Iterator[Rows]:
    """Few rows at a time: TOPP-RA multiplies each block with a square matrix."""
    for first in range(0, rows[0].shape[1], size):
        a, b, c = (column[:, first : first + size] for column in rows)
        yield a, b, c


class Block(LinearConstraint):  # type: ignore[misc]
    """Rows a u + b x <= c with c >= 0, at the grid points."""

    def __init__(self, rows: Rows) -> None:
        super().__init__()
        slack = np.maximum(rows[2], NO_SLACK)
        self.a, self.b = rows[0] / slack, rows[1] / slack
        self.identical = True
        self.set_discretization_type(DiscretizationType.Interpolation)

    def compute_constraint_params(self, path: Any, gridpoints: Any, *args: Any, **kwargs: Any) -> tuple[Any, ...]:
        count = self.a.shape[1]
        params = (self.a, self.b, np.zeros_like(self.a), np.eye(count), np.ones(count))
        a, b, c, f, g, _, _ = toppra.constraint.linear_constraint.canlinear_colloc_to_interpolate(
            *params, None, None, np.asarray(gridpoints), identical=True
        )
        return a, b, c, f, g, None, None


def by_toppra(curve: Curve, grid: Floats, rows: list[Rows]) -> Floats | None:
    """The speeds at grid points that TOPP-RA finds."""
    algorithm = TOPPRA([Block(block) for block in rows], curve, gridpoints=grid, solver_wrapper="seidel")
    _, speeds, _ = algorithm.compute_parameterization(0.0, 0.0)
    return None if speeds is None or not np.isfinite(speeds).all() else speeds


def by_copp(curve: Curve, grid: Floats, rows: list[Rows]) -> Floats | None:
    """The speeds at grid points that copp finds; in its rows, a is the factor of x and b that of u."""
    constraints = copp.constraints.Constraints(curve.dof)
    constraints.append_s(grid)
    for a, b, c in rows:
        slack = np.maximum(c, NO_SLACK)
        constraints.add_constraint_2nd(b / slack, a / slack, np.ones_like(slack), 0)
    try:
        squares = copp.solver.topp2_ra.solve(copp.solver.topp2_ra.Problem(constraints, (0, len(grid) - 1), (0.0, 0.0)))
    except copp.core.CoppError as error:
        print(f"copp: {error}")
        return None
    return np.sqrt(np.maximum(squares, 0.0))


Solver = Callable[[Curve, Floats, list[Rows]], Floats | None]
SOLVERS: dict[str, Solver] = {"TOPP-RA": by_toppra, "copp": by_copp}


def solved(solver: Solver, curve: Curve, limits: Limits, count: int) -> tuple[float, float, float, float]:
    """Duration, seconds for rows, seconds for the solution, and largest excess between grid points."""
    began = time.process_time()
    grid = curve.grid(count)
    rows = list(limits.rows(*(curve(grid, order) for order in range(3))))
    made = time.process_time()
    speeds = solver(curve, grid, rows)
    done = time.process_time()
    if speeds is None:
        return np.nan, made - began, done - made, np.nan
    steps, x = np.diff(grid), speeds**2
    u = np.diff(x) / (2 * steps)
    share = (np.arange(WITHIN) + 0.5) / WITHIN
    s = (grid[:-1, None] + steps[:, None] * share).ravel()
    state = u.repeat(WITHIN), (x[:-1, None] + 2 * (u * steps)[:, None] * share).ravel()
    duration = float((2 * steps / (speeds[1:] + speeds[:-1])).sum())
    return duration, made - began, done - made, excess(curve, limits, s, *state)


def excess(curve: Curve, limits: Limits, s: Floats, u: Floats, x: Floats) -> float:
    """Largest violation of a limit at these states, as a share of it."""
    most = 0.0
    for first in range(0, len(s), 20 * AT_ONCE):
        part = slice(first, first + 20 * AT_ONCE)
        q, q1, q2 = (curve(s[part], order) for order in range(3))
        for a, b, c in limits.rows(q, q1, q2):
            used = (a * u[part, None] + b * x[part, None]) / np.maximum(c, NO_SLACK)
            most = max(most, float(used.max()) - 1)
        if (limit := limits.limits.get("acceleration")) is not None:
            accelerations = q1 * u[part, None] + q2 * x[part, None]
            most = max(most, float(np.linalg.norm(accelerations, axis=1).max()) / limit - 1)
    return most


def own_excess(motion: cdpr.Trajectory) -> float:
    """Largest violation of a limit by cdpr's motion."""
    state = motion.at(np.linspace(0, motion.duration, INSTANTS))
    of: dict[str, Callable[[], Any]] = {
        "speed": lambda: np.linalg.norm(state.velocity, axis=1).max(),
        "acceleration": lambda: np.linalg.norm(state.acceleration, axis=1).max(),
        "cable_speed": lambda: np.abs(state.cable_speeds).max(),
    }
    used = [of[key]() / limit - 1 for key, limit in motion.limits.items() if key in of]
    if motion.tension_limits is not None and state.tensions is not None:
        low, high = motion.tension_limits.T
        beyond = np.maximum(low - state.tensions, state.tensions - high) / (high - low)
        used.append(beyond.max())
    return max(0.0, *used) if used else 0.0


def compare(name: str, grids: list[int], tangents: int) -> None:
    scene_name, given = CASES[name]
    scene = cdpr.Scene.load(SCENES / f"{scene_name}.toml")
    path = cdpr.plan(scene)
    cdpr.trajectory(scene, path, **given)  # compiles the scene
    began = time.process_time()
    motion = cdpr.trajectory(scene, path, **given)
    taken = time.process_time() - began
    with tempfile.TemporaryDirectory() as folder:
        motion.save(Path(folder) / "motion.json")
        file = json.loads((Path(folder) / "motion.json").read_text())
    size, beyond = len(file["timing"]), own_excess(motion)
    print(f"| {name} | cdpr | {size} | {motion.duration:.6f} | | {taken:.2f} | {beyond:.1e} |")
    limits = Limits(scene, motion, tangents)
    for count, (tool, solver) in itertools.product(grids, SOLVERS.items()):
        curves = list(stretches(file))
        whole = sum(curve.starts[-1] for curve in curves)
        counts = [max(LEAST, round(count * curve.starts[-1] / whole)) for curve in curves]
        parts = np.array([solved(solver, curve, limits, number) for curve, number in zip(curves, counts, strict=True)])
        duration, made, done = parts[:, :3].sum(axis=0)
        change = f"{100 * (motion.duration / duration - 1):+.3f} %"
        seconds = f"{made:.2f} + {done:.2f}"
        print(f"| | {tool} | {count} | {duration:.6f} | {change} | {seconds} | {parts[:, 3].max():.1e} |", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", nargs="*", metavar="CASE", help=f"some of: {'; '.join(CASES)}")
    parser.add_argument("--grid", nargs="+", type=int, default=[1000, 10_000], help="numbers of intervals")
    parser.add_argument("--tangents", type=int, default=512, help="tangents for the acceleration")
    arguments = parser.parse_args()
    logging.getLogger("toppra").setLevel(logging.ERROR)
    if unknown := set(arguments.cases) - set(CASES):
        parser.error(f"found {', '.join(sorted(unknown))}, expected some of {'; '.join(CASES)}")
    print("| case | | intervals | duration (s) | cdpr is longer by | time (s) | excess |\n|---|---|---|---|---|---|---|")
    for name in arguments.cases or CASES:
        compare(name, arguments.grid, arguments.tangents)


if __name__ == "__main__":
    main()
