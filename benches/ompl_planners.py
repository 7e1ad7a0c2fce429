"""Compare OMPL's planners on cdpr's checker with cdpr's own, and print the tables of docs/ompl.md.

    pip install '.[ompl]'
    python benches/ompl_planners.py

Run it in the folder of the project; it takes about two minutes. The first table is the first path, median of 51 runs,
the second the length after one second, median of 5 runs. Times are those of the search alone, for OMPL processor time of
all threads.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median
from typing import Any

from ompl import base, geometric

import cdpr
import cdpr.ompl

SCENES = Path(__file__).parents[1] / "testdata/scenes"
NAMES = ("hard1", "hard3", "forest")
Answer = tuple[float, float]  # seconds, metres


def by_ompl(planner: str, seconds: float | None) -> Callable[[cdpr.Scene, int], Answer]:
    def run(scene: cdpr.Scene, _: int) -> Answer:
        setup = cdpr.ompl.simple_setup(scene)
        information = setup.getSpaceInformation()
        setup.setPlanner(getattr(geometric, planner)(information))
        if seconds is not None:
            setup.setOptimizationObjective(base.PathLengthOptimizationObjective(information))
        setup.setup()
        start = time.process_time()
        solved = cdpr.ompl.solve(setup, seconds or 5.0) and setup.haveExactSolutionPath()
        return time.process_time() - start, cdpr.ompl.path(setup).cost if solved else math.inf

    return run


def by_cdpr(planner: str, **options: Any) -> Callable[[cdpr.Scene, int], Answer]:
    def run(scene: cdpr.Scene, seed: int) -> Answer:
        result = cdpr.plan(scene, planner, seed=seed, **options)
        return result.stats["planning_seconds"] + result.stats["post_seconds"], result.cost

    return run


FIRST = {
    "OMPL's RRT-Connect": by_ompl("RRTConnect", None),
    "OMPL's PRM": by_ompl("PRM", None),
    '`rrt-connect`, `post="none"`': by_cdpr("rrt-connect", post="none", proof=False),
    '`two-trees`, `post="none"`': by_cdpr("two-trees", post="none", proof=False),
    "`two-trees`": by_cdpr("two-trees", proof=False),
}
LATER = {
    "BIT\\*": by_ompl("BITstar", 1.0),
    "Informed RRT\\*": by_ompl("InformedRRTstar", 1.0),
    "AORRTC": by_ompl("AORRTC", 1.0),
    "`anytime`, when it stops": by_cdpr("anytime"),
}


def table(rows: dict[str, Callable[[cdpr.Scene, int], Answer]], runs: int, timed: bool) -> None:
    scenes = [cdpr.Scene.load(SCENES / f"{name}.toml") for name in NAMES]
    print("\n| | " + " | ".join(NAMES) + " |\n" + "|---" * (len(NAMES) + 1) + "|")
    for name, run in rows.items():
        cells = []
        for scene in scenes:
            run(scene, 0)  # compiles
            times, lengths = zip(*(run(scene, seed) for seed in range(runs)))
            cells.append((f"{float(f'{1e3 * median(times):.2g}'):g} / " if timed else "") + f"{median(lengths):.4g}")
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)


def main() -> None:
    table(FIRST, 51, timed=True)
    table(LATER, 5, timed=False)


if __name__ == "__main__":
    main()
