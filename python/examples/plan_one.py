"""Plan the paper's scene, check the path, and write it with a page to look at."""

from pathlib import Path

import cdpr

SCENES = Path(__file__).resolve().parents[2] / "testdata" / "scenes"


def main() -> None:
    """Plan hard1 with a few seeds and keep the shortest path."""
    scene = cdpr.Scene.load(SCENES / "hard1.toml")
    best = min((cdpr.plan(scene, seed=seed) for seed in range(20)), key=lambda result: result.cost)
    report = cdpr.check(scene, best)
    print(f"{scene}: {best.cost:.3f} m with {len(best.waypoints)} waypoints, valid: {report.valid}")
    best.save("path.json")
    cdpr.save_view("view.html", scene, best)


if __name__ == "__main__":
    main()
