"""Compare cdpr's proofs of turning motions with coal, which samples, and with FCL's continuous collision.

    pip install coal python-fcl
    python benches/turning_coal.py
    python benches/turning_coal.py hard1 --motions 200 --answers 2000

Run it in the folder of the project. Motions have 0.1 m and 5 degrees about any axis, as in
benches/benches/turning.rs: the position moves straight and the platform turns about a fixed axis, both at constant
rates. Two tables:

Times, for motions that are valid, all checked one after the other on one thread, in microseconds of processor time
per motion; the shortest of several rounds.

- "cdpr, all": `Scene.motions_valid`, one call for all: platform, cables, workspace; everything except wrenches.
- "cdpr, platform": the same in a scene that ignores all cables, in a workspace that never binds.
- "coal, sampled": `coal.collide` of platform and each obstacle at 101 poses, every 1 mm and 0.05 degrees.
- "FCL, continuous": `fcl.continuousCollide` of platform and each obstacle (coal 3.0.3 has no continuous collision,
  neither in Python nor in its C++ headers). Conservative advancement; the motion is FCL's "linear": as here, a
  straight translation and a turn about a fixed axis.

coal and FCL are called from Python once for each pair and pose; "of it, calls" is what as many calls of coal take for
two spheres, whose distance is a formula. Placing the platform (poses as matrices) is not part of any time of coal or
FCL.

Answers, for the platform alone and for motions that start within 0.1 m of an obstacle, each compared with a walk:
coal's distance along the motion in steps of the distance divided by the largest speed of a point, but at least 0.01
mm. Motions whose least distance is within 0.01 mm of contact, either way, are counted as "close" and not compared.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import cdpr

try:
    import coal
    import fcl
except ImportError as error:
    raise SystemExit(f"found no package {error.name}, expected it: pip install coal python-fcl") from None

Floats = NDArray[np.float64]
SCENES = Path(__file__).parents[1] / "testdata/scenes"
NAMES = ["hard1", "hard3", "cogiro"]
LENGTH, ANGLE, TILT = 0.1, np.radians(5), 0.2  # m, rad, largest angle at the start, rad
POSES = 101
FCL = [(10, 1e-4), (1000, 1e-6)]  # iterations and error of the time of contact; the first are the defaults
ROUNDS = 5
NEAR = 0.1  # m, of an obstacle at the start of motions whose answers are compared
CLOSE = 1e-5  # m
OUT_OF_REACH = 1e3  # m


@dataclass
class Motions:
    """Motions as positions (n, 3) and world-from-platform quaternions w x y z (n, 4) at both ends."""

    starts: Floats
    ends: Floats
    before: Floats
    after: Floats

    def __getitem__(self, rows: Any) -> Motions:
        return Motions(self.starts[rows], self.ends[rows], self.before[rows], self.after[rows])

    def valid(self, scene: cdpr.Scene) -> NDArray[np.bool_]:
        return scene.motions_valid(self.starts, self.ends, self.before, self.after, threads=1)

    def poses(self, shares: Floats) -> tuple[Floats, Floats]:
        """Rotations (n, k, 3, 3) and positions (n, k, 3) at shares (n, k) of the motions."""
        positions = self.starts[:, None] + shares[..., None] * (self.ends - self.starts)[:, None]
        turn = product(self.after, self.before * [1, -1, -1, -1])
        sine = np.linalg.norm(turn[:, 1:], axis=1)
        half = np.arctan2(sine, turn[:, 0])[:, None] * shares
        axes = (turn[:, 1:] / np.maximum(sine, 1e-300)[:, None])[:, None]
        so_far = np.concatenate([np.cos(half)[..., None], np.sin(half)[..., None] * axes], axis=2)
        return matrices(product(so_far, self.before[:, None])), positions


def product(a: Floats, b: Floats) -> Floats:
    """Product of quaternions w x y z."""
    w = a[..., :1] * b[..., :1] - (a[..., 1:] * b[..., 1:]).sum(axis=-1, keepdims=True)
    xyz = a[..., :1] * b[..., 1:] + b[..., :1] * a[..., 1:] + np.cross(a[..., 1:], b[..., 1:])
    return np.concatenate([w, xyz], axis=-1)


def matrices(q: Floats) -> Floats:
    """Rotation matrices of quaternions w x y z."""
    w, x, y, z = np.moveaxis(q, -1, 0)
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), [0, 1], [-2, -1])


def drawn(random: np.random.Generator, count: int, box: Floats, reference: Floats) -> Motions:
    """Random motions that start in a box, within a small turn of the reference."""

    def directions() -> Floats:
        vectors = random.uniform(-1, 1, (count, 3))
        return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)

    def turned(angles: Floats, quaternions: Floats) -> Floats:
        turns = np.hstack([np.cos(angles / 2)[:, None], np.sin(angles / 2)[:, None] * directions()])
        return product(turns, quaternions)

    starts = random.uniform(*box, (count, 3))
    before = turned(random.uniform(0, TILT, count), np.broadcast_to(reference, (count, 4)))
    return Motions(starts, starts + LENGTH * directions(), before, turned(np.full(count, ANGLE), before))


def filled(draw: Callable[[], Motions], keep: Callable[[Motions], Any], count: int) -> Motions:
    """So many of the motions that are kept."""
    parts, found = [], 0
    while found < count:
        motions = draw()
        parts.append(motions[np.asarray(keep(motions))])
        found += len(parts[-1].starts)
    columns = [[getattr(part, name) for part in parts] for name in ("starts", "ends", "before", "after")]
    return Motions(*(np.concatenate(column)[:count] for column in columns))


class Bodies:
    """Platform and obstacles as shapes of coal and of FCL: boxes, or hulls of corners."""

    def __init__(self, scene: cdpr.Scene) -> None:
        platform = [corners_of(part) for part in scene.robot.to_dict()["platform"]]
        obstacles = [part for parts in scene.obstacles.values() for part in parts]
        self.reach = max(float(np.linalg.norm(corners, axis=1).max()) for corners in platform)
        self.platform = [Body(corners, np.zeros(3)) for corners in platform]  # what turns, turns about the origin
        self.obstacles = [Body(corners, (corners.min(axis=0) + corners.max(axis=0)) / 2) for corners in obstacles]

    def distance(self, rotation: Floats, position: Floats) -> float:
        """Coal's distance between platform and obstacles, negative if they overlap."""
        placed, request, least = coal.Transform3s(rotation, position), coal.DistanceRequest(), OUT_OF_REACH
        for part in self.platform:
            for obstacle in self.obstacles:
                result = coal.DistanceResult()
                least = min(least, coal.distance(part.coal, placed, obstacle.coal, obstacle.place, request, result))
        return least


class Body:
    """A box along the axes around a center, or the hull of corners."""

    def __init__(self, corners: Floats, center: Floats) -> None:
        corners = corners - center
        half = corners.max(axis=0)
        if len(corners) == 8 and np.allclose(np.abs(corners), half, rtol=0, atol=1e-12):
            self.coal, self.fcl = coal.Box(*(2 * half)), fcl.Box(*(2 * half))
        else:
            self.coal, self.fcl = hulls(corners)
        self.place = coal.Transform3s(np.eye(3), center)
        self.object = fcl.CollisionObject(self.fcl, fcl.Transform(np.eye(3), center))


def corners_of(part: dict[str, Any]) -> Floats:
    """Corners of a part of a platform, a box or a list of vertices, in its frame."""
    if set(part) - {"box", "vertices", "position"}:
        raise SystemExit(f"found a platform with {', '.join(part)}, expected boxes or vertices without a turn")
    if "vertices" in part:
        corners = np.array(part["vertices"])
    else:
        corners = np.stack(np.meshgrid(*([-side / 2, side / 2] for side in part["box"])), axis=-1).reshape(-1, 3)
    return corners + part.get("position", np.zeros(3))


def hulls(corners: Floats) -> tuple[Any, Any]:
    """The hull of corners for coal and for FCL."""
    points = coal.StdVec_Vec3s()
    points.extend(list(corners))
    hull = coal.Convex.convexHull(points, True, "Qt")
    triangles = [hull.polygons(k) for k in range(hull.num_polygons)]
    faces = np.array([[3, *(triangle[k] for k in range(3))] for triangle in triangles])
    return hull, fcl.Convex(np.array([hull.point(k) for k in range(hull.num_points)]), len(faces), faces.ravel())


def placed(motions: Motions, count: int, kind: Callable[[Floats, Floats], Any]) -> list[list[Any]]:
    """Poses at equal distances along each motion, in a package's own form."""
    rotations, positions = motions.poses(np.tile(np.linspace(0, 1, count), (len(motions.starts), 1)))
    return [[kind(*pose) for pose in zip(*rows, strict=True)] for rows in zip(rotations, positions, strict=True)]


def sampled(platform: list[Any], obstacles: list[tuple[Any, Any]], motions: list[list[Any]]) -> list[bool]:
    """Whether coal finds each motion free, at poses."""
    request, result = coal.CollisionRequest(), coal.CollisionResult()

    def collide(shape: Any, pose: Any, obstacle: Any, place: Any) -> bool:
        result.clear()
        return bool(coal.collide(shape, pose, obstacle, place, request, result))

    return [
        not any(collide(shape, pose, *other) for pose in poses for shape in platform for other in obstacles)
        for poses in motions
    ]


def continuous(bodies: Bodies, motions: list[list[Any]], iterations: int, error: float) -> list[bool]:
    """Whether FCL finds each motion free, from both ends."""
    request = fcl.ContinuousCollisionRequest(
        num_max_iterations=iterations,
        toc_err=error,
        ccd_motion_type=fcl.CCDMotionType.CCDM_LINEAR,
        ccd_solver_type=fcl.CCDSolverType.CCDC_CONSERVATIVE_ADVANCEMENT,
    )
    movers = [part.object for part in bodies.platform]
    still = [(body.object, body.object.getTransform()) for body in bodies.obstacles]

    def collide(mover: Any, ends: list[Any], obstacle: Any, place: Any) -> bool:
        mover.setTransform(ends[0])
        result = fcl.ContinuousCollisionResult()
        fcl.continuousCollide(mover, ends[1], obstacle, place, request, result)
        return bool(result.is_collide)

    return [not any(collide(mover, ends, *other) for mover in movers for other in still) for ends in motions]


def least_distance(bodies: Bodies, motion: Motions, whole: bool = False) -> float:
    """The least distance along a motion, by the walk; unless `whole`, it ends where bodies clearly overlap."""
    shortest = CLOSE / (LENGTH + ANGLE * bodies.reach)
    share, least = 0.0, OUT_OF_REACH
    while True:
        rotation, position = (values[0, 0] for values in motion.poses(np.array([[share]])))
        gap = bodies.distance(rotation, position)
        least = min(least, gap)
        if share == 1 or (least < -CLOSE and not whole):
            return least
        share = min(1.0, share + max(shortest, shortest * gap / CLOSE))


def processor_time(work: Callable[[], Any]) -> float:
    """Shortest processor time of some rounds, s."""
    found = []
    for _ in range(ROUNDS):
        began = time.process_time()
        work()
        found.append(time.process_time() - began)
    return min(found)


def without_cables(scene: cdpr.Scene) -> cdpr.Scene:
    """A scene in which only platform and obstacles count."""
    cables, others = scene.robot.cable_names, ("platform", *scene.obstacles)
    ignore = [(a, b) for k, a in enumerate(cables) for b in (*cables[k + 1 :], *others)]
    room = [[-OUT_OF_REACH] * 3, [OUT_OF_REACH] * 3]
    return scene.replace(ignore=ignore, workspace=room)


def times(name: str, scene: cdpr.Scene, count: int, seed: int) -> str:
    """A row of the table of times."""
    random = np.random.default_rng(seed)
    motions = filled(lambda: drawn(random, 10_000, scene.workspace, scene.orientation), lambda m: m.valid(scene), count)
    alone, bodies = without_cables(scene), Bodies(scene)
    seconds = [processor_time(lambda: motions.valid(scene)), processor_time(lambda: motions.valid(alone))]
    few = motions[: min(count, 200)]  # the samples of 1000 would take seconds
    poses, ends = placed(few, POSES, coal.Transform3s), placed(motions, 2, fcl.Transform)
    shapes, pairs = [part.coal for part in bodies.platform], [(body.coal, body.place) for body in bodies.obstacles]
    balls = [coal.Sphere(1e-3)] * len(shapes), [(coal.Sphere(1e-3), place) for _, place in pairs]
    work = [
        (lambda: sampled(shapes, pairs, poses), len(few.starts)),
        (lambda: sampled(*balls, poses), len(few.starts)),
        (lambda: continuous(bodies, ends, *FCL[0]), count),
    ]
    cells = [1e6 * value / count for value in seconds] + [1e6 * processor_time(run) / number for run, number in work]
    return f"| {name} | {len(bodies.obstacles)} | " + " | ".join(f"{value:.3g}" for value in cells) + " |"


def answers(name: str, scene: cdpr.Scene, count: int, seed: int) -> list[str]:
    """Rows of the table of answers."""
    random, bodies, alone = np.random.default_rng(seed), Bodies(scene), without_cables(scene)

    def near(motions: Motions) -> list[bool]:
        rotations, positions = (values[:, 0] for values in motions.poses(np.zeros((len(motions.starts), 1))))
        return [0 < bodies.distance(*pose) < NEAR for pose in zip(rotations, positions, strict=True)]

    corners = np.vstack([corner for parts in scene.obstacles.values() for corner in parts])
    margin = NEAR + bodies.reach
    box = np.array([corners.min(axis=0) - margin, corners.max(axis=0) + margin])
    motions = filled(lambda: drawn(random, 1000, box, scene.orientation), near, count)
    least = np.array([least_distance(bodies, motions[[k]]) for k in range(count)])
    clear = np.abs(least) > CLOSE
    free = least > 0
    shapes, pairs = [part.coal for part in bodies.platform], [(body.coal, body.place) for body in bodies.obstacles]
    poses, ends = placed(motions, POSES, coal.Transform3s), placed(motions, 2, fcl.Transform)
    tools = {"cdpr": motions.valid(alone), "coal, sampled": sampled(shapes, pairs, poses)}
    for iterations, error in FCL:
        tools[f"FCL, {iterations} iterations, {error:g}"] = continuous(bodies, ends, iterations, error)
    rows = []
    for tool, found in tools.items():
        said = np.array(found)
        wrong = clear & (said != free)
        depths = [abs(least_distance(bodies, motions[[k]], whole=True)) for k in np.flatnonzero(wrong)]
        gap = f"{1e3 * max(depths):.3f}" if depths else "–"
        cells = (clear & free).sum(), (clear & ~free).sum(), (~clear).sum(), (wrong & said).sum(), (wrong & ~said).sum()
        rows.append(f"| {name} | {tool} | " + " | ".join(map(str, cells)) + f" | {gap} |")
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help=f"some of: {', '.join(NAMES)}")
    parser.add_argument("--motions", type=int, default=1000, help="whose times are measured")
    parser.add_argument("--answers", type=int, default=10_000, help="motions whose answers are compared")
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    if unknown := set(given.scenes) - set(NAMES):
        parser.error(f"found {', '.join(sorted(unknown))}, expected some of {', '.join(NAMES)}")
    scenes = {name: cdpr.Scene.load(SCENES / f"{name}.toml").replace(wrench=None) for name in given.scenes or NAMES}
    print("µs | obstacles | cdpr, all | cdpr, platform | coal, sampled | of it, calls | FCL, continuous")
    for name, scene in scenes.items():
        print(times(name, scene, given.motions, given.seed), flush=True)
    print("scene | tool | free | blocked | close | false free | false blocked | by at most (mm)")
    for name, scene in scenes.items():
        print("\n".join(answers(name, scene, given.answers, given.seed)), flush=True)


if __name__ == "__main__":
    main()
