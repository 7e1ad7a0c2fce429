"""Plan the paper's scene, check the path, and write it with a page to look at."""

from pathlib import Path

import cdpr

SCENES = Path(__file__).resolve().parents[2] / "testdata" / "scenes"


def main() -> None:
    """Plan hard1."""
    scene = cdpr.Scene.load(SCENES / "hard1.toml")
    best = cdpr.plan(scene)
    report = cdpr.check(scene, best)
    print(f"{scene}: {best.cost:.3f} m with {len(best.waypoints)} waypoints, valid: {report.valid}")
    best.save("path.json")
    cdpr.save_view("view.html", scene, best)


if __name__ == "__main__":
    main()
