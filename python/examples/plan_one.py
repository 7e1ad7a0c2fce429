"""Plan the paper's scene, check the path, and write it with a page to look at."""

import cdpr


def main() -> None:
    """Plan hard1."""
    scene = cdpr.example("hard1")
    best = cdpr.plan(scene)
    report = cdpr.check(scene, best)
    print(f"{scene}: {best.cost:.3f} m with {len(best.waypoints)} waypoints, valid: {report.valid}")
    best.save("path.json")
    cdpr.save_view("view.html", scene, best)


if __name__ == "__main__":
    main()
