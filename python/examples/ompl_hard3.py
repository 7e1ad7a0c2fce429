"""Plan a scene with RRT-Connect of OMPL on the checker of cdpr, pull the path taut, and write it."""

from ompl import geometric

import cdpr
import cdpr.ompl


def main() -> None:
    """Plan hard3."""
    scene = cdpr.example("hard3")
    setup = cdpr.ompl.simple_setup(scene)
    setup.setPlanner(geometric.RRTConnect(setup.getSpaceInformation()))
    if not cdpr.ompl.solve(setup, 10.0):
        raise SystemExit("no path in 10 s")
    raw = cdpr.ompl.path(setup)
    setup.simplifySolution()  # OMPL's own way of shortening
    simplified = cdpr.ompl.path(setup)
    rewound, taut = cdpr.rewind(scene, raw), cdpr.refine(scene, raw)
    print(f"found {raw.cost:.3f} m in {1e3 * setup.getLastPlanComputationTime():.1f} ms")
    print(f"simplified {simplified.cost:.3f} m, rewound {rewound.cost:.3f} m, taut {taut.cost:.3f} m")
    print(f"valid: {cdpr.check(scene, taut).valid}")
    taut.save("path.json")


if __name__ == "__main__":
    main()
