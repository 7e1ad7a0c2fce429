"""What docs/reproduction.md needs of the runs of its experiments: from the folder of a run to the text of results/NAME.json."""

import csv
import json
import math
import re
import statistics
import sys
import tomllib
from collections import defaultdict
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).resolve().parents[2]

sys.path.append(str(ROOT / "python/examples"))
import winding  # noqa: E402

import cdpr  # noqa: E402

# The runs whose paths are planned again to measure how much they wind.
WINDING = ("table2", "table2_paper")
# The run for which the share of positions that each scenario accepts is counted, over so many random ones.
ACCEPTING, POSITIONS = "wrench_rank6", 3000

# Trials of each method whose rows are kept.
FIRST = 3
MEASURES = (
    "planning_seconds", "post_seconds", "raw_cost", "cost", "reduction", "waypoints", "motion_checks", "compile_seconds",
)  # fmt: skip


def rounded(value: Any) -> Any:
    """Six digits: more than any table shows."""
    match value:
        case float():
            return float(f"{value:.6g}")
        case list():
            return [rounded(entry) for entry in value]
        case _:
            return value


def rows_of(file: Path) -> list[dict[str, str]]:
    with file.open(newline="") as opened:
        return list(csv.DictReader(opened))


def recorded(run: Path) -> dict[str, Any]:
    """What the page needs of a run."""
    summary, trials = json.loads((run / "summary.json").read_text()), rows_of(run / "trials.csv")
    methods = []
    for entry in summary["methods"]:
        kept = {key: entry[key] for key in ("scenario", "method", "sweep", "n", "solved", "statuses") if key in entry}
        for measure in MEASURES:
            described = entry[measure]
            keys = ("mean", "sd", "median")
            kept[measure] = {key: rounded(described[key]) for key in keys if described[key] is not None}
        counts = [int(row["raw_waypoints"]) for row in trials if (row["scenario"], row["method"]) == place(entry) and row["raw_waypoints"]]
        kept["raw_waypoints"] = {"mean": rounded(statistics.mean(counts))} if counts else {}
        methods.append(kept)
    result = {
        "fingerprint": summary["fingerprint"],
        "p": {test["group"]: rounded(test["p"]) for test in summary["t_tests"]},
        "methods": methods,
        "first": first_trials(trials),
    }
    if (gaps := order_gaps(trials)) is not None:
        result["gaps"] = gaps
    if (run / "history.csv").exists():
        result["samples"] = samples_to_first_path(rows_of(run / "history.csv"))
    if run.name in WINDING:
        angles = {place: numbers[:, 1] for place, numbers in winding.measured(run).items()}
        shown = {f"{scenario} | {method}": [rounded(float(a.mean())), rounded(float(a.std(ddof=1)))] for (scenario, method), a in angles.items()}
        result["winding"] = shown
    if run.name == ACCEPTING:
        result["accepted"] = accepted(run)
    return result


def accepted(run: Path) -> dict[str, list[float]]:
    """The share of random positions, in percent, that the scene of each scenario accepts, obstacles left out, and the share that it accepts
    although no tensions within the limits hold the weight there."""
    experiments = ROOT / "experiments"
    scenarios = tomllib.loads((experiments / f"{run.name}.toml").read_text())["scenarios"]
    shares = {}
    for scenario in scenarios:
        scene = cdpr.Scene.load(experiments / scenario["scene"])
        empty = scene.without(*scene.obstacles)
        low, high = empty.workspace
        positions = np.random.default_rng(0).uniform(low, high, (10 * POSITIONS, 3))
        inside = positions[empty.replace(wrench=None).states_valid(positions)][:POSITIONS]
        taken = empty.states_valid(inside)
        falls = cdpr.capacity_margin(empty.robot, inside) < 0
        shares[scenario["name"]] = [rounded(100 * float(share.mean())) for share in (taken, taken & falls)]
    return shares


def written(result: dict[str, Any]) -> str:
    """JSON with a line for each method, which can be compared with another version."""

    def lines(value: Any) -> str:
        match value:
            case list():
                return "[\n" + ",\n".join(json.dumps(entry) for entry in value) + "\n]"
            case dict():
                return "{\n" + ",\n".join(f"{json.dumps(key)}: {json.dumps(entry)}" for key, entry in value.items()) + "\n}"
            case _:
                return json.dumps(value)

    return "{\n" + ",\n".join(f"{json.dumps(key)}: {lines(value)}" for key, value in result.items()) + "\n}\n"


def place(entry: dict[str, Any]) -> tuple[str, str]:
    return entry["scenario"], entry["method"]


def first_trials(trials: Iterable[dict[str, str]]) -> dict[str, list[list[str]]]:
    """What follows from the seeds of the first trials, by scenario and method."""
    columns = ("status", "raw_cost", "cost", "raw_waypoints", "waypoints", "nodes", "motion_checks")
    found = defaultdict(list)
    for row in trials:
        if int(row["trial"]) < FIRST:
            found[f"{row['scenario']} | {row['method']}"].append([row[column] for column in columns])
    return dict(found)


def samples_to_first_path(history: Iterable[dict[str, str]]) -> dict[str, float]:
    """The median number of samples until the first path, over the trials that have one."""
    found: dict[str, dict[str, int]] = defaultdict(dict)
    for row in history:
        found[f"{row['scenario']} | {row['method']}"].setdefault(row["trial"], int(row["samples"]))
    return {key: statistics.median(trials.values()) for key, trials in found.items()}


def order_gaps(trials: list[dict[str, str]]) -> dict[str, Any] | None:
    """For each number of repeats, how far the two orders of rewinding are apart, in points of the raw cost."""
    pattern = re.compile(r", (backward|forward), repeats 0*(\d+)$")
    gains: dict[int, dict[tuple[str, str], dict[str, float]]] = defaultdict(lambda: defaultdict(dict))
    for row in trials:
        if (place := pattern.search(row["method"])) and row["cost"]:
            gain = 100 * (1 - float(row["cost"]) / float(row["raw_cost"]))
            gains[int(place[2])][row["scenario"], row["trial"]][place[1]] = gain
    if not gains:
        return None
    table = {}
    for repeats, by_trial in sorted(gains.items()):
        pairs = [(both["backward"], both["forward"]) for both in by_trial.values()]
        apart = [abs(a - b) for a, b in pairs]
        differences = [a - b for a, b in pairs]
        best = statistics.mean(max(pair) for pair in pairs)
        spread = 1.96 * statistics.stdev(differences) / math.sqrt(len(pairs))
        table[str(repeats)] = rounded([
            statistics.mean(a for a, _ in pairs),
            statistics.mean(b for _, b in pairs),
            statistics.mean(apart),
            max(apart),
            100 * sum(gap > 1 for gap in apart) / len(apart),
            100 * sum(gap > 5 for gap in apart) / len(apart),
            best,
            statistics.mean(differences),
            spread,
            100 * sum(gap > 0.01 for gap in apart) / len(apart),
        ])  # fmt: skip
    return table
