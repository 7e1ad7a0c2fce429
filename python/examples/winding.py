"""How much the paths of Table 2 wind: waypoints, and the sum of the angles by which a path turns.

Plans the first trials of a saved run again, each with the seed of its row; give the folder that `cdpr batch` wrote.
"""

import csv
import json
import sys
from collections import defaultdict
from pathlib import Path

import numpy as np

import cdpr

TRIALS = 200


def turning(waypoints: np.ndarray) -> float:
    """Return the sum of the angles between segments, degrees."""
    way = np.diff(waypoints, axis=0)
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    return float(np.degrees(np.arccos(np.clip((way[:-1] * way[1:]).sum(axis=1), -1, 1))).sum())


def measured(folder: Path) -> dict[tuple[str, str], np.ndarray]:
    """Return waypoints and turning (degrees) of the first trials of every scenario and method, (trials, 2) each."""
    found = defaultdict(list)
    scenes = {name: cdpr.example(name) for name in ("hard1", "hard3")}
    rules = {rule["method"]: rule for rule in json.loads((folder / "run.json").read_text())["rules"]}
    with open(folder / "trials.csv", newline="") as file:
        for row in csv.DictReader(file):
            if int(row["trial"]) < TRIALS and row["status"] == "solved":
                rule = rules[row["method"]]
                options = {"post": rule["post"], "interference": rule["interference"]}  # both engines give the same paths
                result = cdpr.plan(scenes[row["scenario"]], rule["planner"], seed=int(row["seed"]), **options)
                if abs(result.cost - float(row["cost"])) > 1e-12:
                    raise SystemExit(f"trial {row['trial']} of {row['method']} came out differently")
                found[row["scenario"], row["method"]].append((len(result.waypoints), turning(result.waypoints)))
    return {place: np.array(numbers) for place, numbers in found.items()}


def main(folder: Path) -> None:
    """Print mean and standard deviation of waypoints and turning for every scenario and method."""
    for (scenario, method), numbers in measured(folder).items():
        (waypoints, angle), (sd_waypoints, sd_angle) = numbers.mean(axis=0), numbers.std(axis=0, ddof=1)
        print(f"{scenario}, {method}: {waypoints:.1f} ± {sd_waypoints:.1f} waypoints, {angle:.0f} ± {sd_angle:.0f} degrees")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
