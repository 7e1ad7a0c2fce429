"""Draw a scene's path without and with [wrench] and the slack along both; docs/wrench.md shows the picture.

    cargo run --release -p cdpr-core --example wrench_along -- testdata/scenes/cogiro.toml > slack.csv
    python docs/figures/wrench_study.py testdata/scenes/cogiro.toml slack.csv docs/figures/wrench_study.png

Needs matplotlib.
"""

import csv
import sys
import tomllib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.patches import Rectangle

COLOURS = {"without": "#c0392b", "with": "#1f6fb2"}
BROKEN = {"linewidth": 5, "alpha": 0.35, "solid_capstyle": "butt"}


def read(name: str) -> dict[str, dict[str, list[float]]]:
    """Columns of the CSV for each of the two paths."""
    paths: dict[str, dict[str, list[float]]] = {}
    with open(name, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            columns = paths.setdefault(row.pop("wrench"), {})
            for key, value in row.items():
                columns.setdefault(key, []).append(float(value))
    return paths


def broken(path: dict[str, list[float]], key: str) -> list[float]:
    """A column, NaN where the demand is kept."""
    return [x if slack < 0.0 else float("nan") for x, slack in zip(path[key], path["slack"], strict=True)]


def draw_space(axes: plt.Axes, scene: dict, paths: dict, axis: tuple[int, int]) -> None:
    """Obstacles and both paths, seen along the axis that is left out."""
    for obstacle in scene["obstacles"]:
        low = [obstacle["position"][k] - obstacle["box"][k] / 2 for k in axis]
        size = [obstacle["box"][k] for k in axis]
        axes.add_patch(Rectangle(low, *size, facecolor="#b0b0b0", edgecolor="#606060"))
    keys = ["xyz"[k] for k in axis]
    for name, path in paths.items():
        axes.plot(*(broken(path, key) for key in keys), color=COLOURS[name], **BROKEN)
        axes.plot(*(path[key] for key in keys), color=COLOURS[name], label=f"{name} [wrench]")
    for end, marker in (("start", "o"), ("goal", "s")):
        place = scene["query"][end]
        axes.plot(place[axis[0]], place[axis[1]], marker, color="black", markersize=5)
        axes.annotate(end, (place[axis[0]], place[axis[1]]), xytext=(5, 5), textcoords="offset points")
    axes.set_xlabel(f"{keys[0]} (m)")
    axes.set_ylabel(f"{keys[1]} (m)")
    axes.set_aspect("equal", adjustable="datalim")
    axes.grid(alpha=0.3)


def main() -> None:
    """Read the scene and the CSV, write the picture."""
    scene_file, csv_file, picture = sys.argv[1:]
    with open(scene_file, "rb") as file:
        scene = tomllib.load(file)
    paths = read(csv_file)
    figure, (top, side, along) = plt.subplots(1, 3, figsize=(13, 4), layout="constrained")
    draw_space(top, scene, paths, (0, 1))
    top.set_title("from above")
    draw_space(side, scene, paths, (0, 2))
    side.set_title("from the side")
    for name, path in paths.items():
        along.plot(path["distance"], broken(path, "slack"), color=COLOURS[name], **BROKEN)
        along.plot(path["distance"], path["slack"], color=COLOURS[name], label=f"{name} [wrench]")
    along.axhline(0.0, color="black", linewidth=1)
    along.set_xlabel("distance along the path (m)")
    along.set_ylabel("slack (N)")
    along.set_title("capacity margin along the paths")
    along.legend()
    along.grid(alpha=0.3)
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    main()
