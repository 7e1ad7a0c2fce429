"""Measure cdpr on four scenes and print the table of docs/performance.md.

    python benches/times.py

Run it in the folder of the project; it needs cdpr alone and takes about a minute. Times are processor time of all threads,
for the rows of planners the time of the search. Checks are the best of 15 runs over 20 000 random motions, other rows the
median over 51 seeds or 15 runs.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

import cdpr

SCENES = Path(__file__).parents[1] / "testdata/scenes"
NAMES = ("hard1", "hard3", "forest", "cogiro")
MOTIONS, RUNS, SEEDS = 20_000, 15, 51


def seconds(call: Callable[[], object]) -> float:
    start = time.process_time()
    call()
    return time.process_time() - start


def compiling(scene: cdpr.Scene) -> float:
    place = np.mean(scene.position_box, axis=0)
    fresh = [scene.replace(name=f"run {k}") for k in range(RUNS)]
    return median(seconds(lambda one=one: one.states_valid(place)) for one in fresh)


def motions(scene: cdpr.Scene, length: float | None, engine: str, count: int = MOTIONS) -> float:
    """Random motions between any two positions, or valid ones of a length in any direction."""
    random = np.random.default_rng(0)
    low, high = scene.position_box
    starts, ends = random.uniform(low, high, (2, count, 3))
    if length is not None:
        steps = random.normal(size=(count, 3))
        ends = np.clip(starts + length * steps / np.linalg.norm(steps, axis=1, keepdims=True), low, high)
        valid = scene.motions_valid(starts, ends)
        starts, ends = starts[valid], ends[valid]
    scene.motions_valid(starts[:1], ends[:1], engine=engine)
    return min(seconds(lambda: scene.motions_valid(starts, ends, engine=engine, threads=1)) for _ in range(RUNS)) / len(starts)


def clearances(scene: cdpr.Scene) -> float:
    places = np.random.default_rng(0).uniform(*scene.position_box, (2000, 3))
    return min(seconds(lambda: scene.clearance(places, threads=1)) for _ in range(RUNS)) / len(places)


def searching(scene: cdpr.Scene, planner: str, **options: Any) -> float:
    """The search alone, by the clock; the whole call also checks the path once more and finds its nearest approach."""
    results = [cdpr.plan(scene, planner, seed=seed, **options) for seed in range(SEEDS)]
    return median(result.stats["planning_seconds"] + result.stats["post_seconds"] for result in results)


def planning(scene: cdpr.Scene) -> float:
    cdpr.plan(scene)  # compiles
    return median(seconds(lambda seed=seed: cdpr.plan(scene, seed=seed)) for seed in range(SEEDS))


def timing(scene: cdpr.Scene) -> float:
    path = cdpr.plan(scene)
    return median(seconds(lambda: cdpr.trajectory(scene, path, speed=1, acceleration=2)) for _ in range(RUNS))


def margins(scene: cdpr.Scene) -> float:
    places = np.random.default_rng(0).uniform(*scene.position_box, (8000, 3))
    return min(seconds(lambda: cdpr.capacity_margin(scene.robot, places, force=50, threads=1)) for _ in range(RUNS)) / len(places)


ROWS: dict[str, Callable[[cdpr.Scene], float]] = {
    "compile the scene": compiling,
    "check a valid motion of 0.1 m": lambda scene: motions(scene, 0.1, "cspace"),
    "check any motion": lambda scene: motions(scene, None, "cspace"),
    "check any motion with `gjk`": lambda scene: motions(scene, None, "gjk", 1000),
    "clearance at a position": clearances,
    "`two-trees`, first path": lambda scene: searching(scene, "two-trees", post="none", proof=False),
    "`modified-rrt`, first path": lambda scene: searching(scene, "modified-rrt", post="none", proof=False),
    "a whole call of `plan`": planning,
    "time a motion": timing,
    "capacity margin at a position": margins,
}


def shown(value: float) -> str:
    for unit, factor in (("s", 1.0), ("ms", 1e3), ("µs", 1e6)):
        if value * factor >= 1:
            return f"{value * factor:.3g} {unit}"
    return f"{value * 1e9:.3g} ns"


def main() -> None:
    scenes = [cdpr.Scene.load(SCENES / f"{name}.toml") for name in NAMES]
    print("| | " + " | ".join(NAMES) + " |")
    print("|---" * (len(NAMES) + 1) + "|")
    for row, measure in ROWS.items():
        print(f"| {row} | " + " | ".join(shown(measure(scene)) for scene in scenes) + " |", flush=True)


if __name__ == "__main__":
    main()
