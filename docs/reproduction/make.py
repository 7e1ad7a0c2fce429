"""Fills the tables of docs/reproduction.md: `make reproduction` runs all their experiments first.

    python docs/reproduction/make.py [FOLDER]

FOLDER holds the runs of `cdpr batch experiments/NAME.toml -o FOLDER/NAME`. What the page needs of each is written to
results/NAME.json, which is under version control; without FOLDER, the tables are filled from these files. Each file also holds the
fingerprint of its experiment and the rows of its first trials, so that a test can tell whether it is still true.
"""

import inspect
import json
import math
import re
import sys
import tomllib
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import cdpr

HERE = Path(__file__).resolve().parent
RESULTS = HERE / "results"
PAGE = HERE.parent / "reproduction.md"

sys.path.append(str(HERE))
from recording import ROOT, recorded, written  # noqa: E402

PAPER = ROOT / "crates/cdpr-study/src/report/paper.toml"

RRT_STAR, RRT_STAR_POST = "RRT*", "RRT* + post-processing"
MODIFIED, MODIFIED_POST = "modified RRT", "modified RRT + post-processing"
FOUR = (RRT_STAR, RRT_STAR_POST, MODIFIED, MODIFIED_POST)


# Numbers in text


def digits(number: float, significant: int = 3) -> str:
    """With so many significant digits, and without an exponent."""
    if number == 0 or not math.isfinite(number):
        return "0" if number == 0 else "–"
    decimals = max(0, significant - 1 - math.floor(math.log10(abs(number))))
    return f"{number:.{decimals}f}"


def table(head: list[str], rows: Iterable[Iterable[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


class Run:
    """What is kept of one run."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.found = json.loads((RESULTS / f"{name}.json").read_text())
        self.of = {(entry["scenario"], entry["method"]): entry for entry in self.found["methods"]}

    def mean(self, scenario: str, method: str, measure: str) -> float:
        return self.of[scenario, method][measure]["mean"]

    def median(self, scenario: str, method: str, measure: str) -> float:
        return self.of[scenario, method][measure]["median"]

    def spread(self, scenario: str, method: str, measure: str, scale: float = 1.0, decimals: int | None = None) -> str:
        described = self.of[scenario, method][measure]
        mean, sd = scale * described["mean"], scale * described["sd"]
        if decimals is None:
            return f"{digits(mean)} ± {digits(sd, 2)}"
        return f"{mean:.{decimals}f} ± {sd:.{decimals}f}"


def ratio(a: dict[str, float], n_a: int, b: dict[str, float], n_b: int) -> tuple[float, float]:
    """The ratio of two independent means and half its 95 % confidence interval, by the delta method."""
    value = a["mean"] / b["mean"]
    relative = a["sd"] ** 2 / n_a / a["mean"] ** 2 + b["sd"] ** 2 / n_b / b["mean"] ** 2
    return value, 1.96 * value * math.sqrt(relative)


def compared(a: tuple[Run, str, str, str], b: tuple[Run, str, str, str]) -> tuple[float, float]:
    (run_a, *place_a, measure_a), (run_b, *place_b, measure_b) = a, b
    one, other = run_a.of[tuple(place_a)], run_b.of[tuple(place_b)]
    return ratio(one[measure_a], one["solved"], other[measure_b], other["solved"])


def share(run: Run, scenario: str, a: str, b: str, measure: str) -> str:
    """a as a percentage of b, its interval, and the percentage of medians."""
    value, half = compared((run, scenario, a, measure), (run, scenario, b, measure))
    medians = run.median(scenario, a, measure) / run.median(scenario, b, measure)
    interval = f"({digits(100 * (value - half))} to {digits(100 * (value + half))})"
    return f"{digits(100 * value)} % {interval}; of medians {digits(100 * medians, 2)} %"


def less(a: tuple[Run, str, str, str], b: tuple[Run, str, str, str]) -> str:
    """By how much a is less than b, with its interval."""
    value, half = compared(a, b)
    word, sign = ("", 1) if value < 1 else (" longer", -1)
    middle, half = sign * 100 * (1 - value), 100 * half
    return f"{middle:.2f} %{word} ({middle - half:.2f} to {middle + half:.2f})".replace("(-", "(−")


# Tables of the page, by the names of their places in it


def table1() -> str:
    """The paper's parameters, and ours from the files."""
    scene = cdpr.Scene.load(ROOT / "testdata/scenes/empty.toml").to_dict()
    low, high, body = scene["workspace"]["min"], scene["workspace"]["max"], scene["robot"]["platform"][0]["box"]
    random = cdpr.schema("experiment")["$defs"]["RandomScenesSpec"]["properties"]
    step = inspect.signature(cdpr.rewind).parameters["step"].default

    def sides(numbers: Iterable[float]) -> str:
        return " × ".join(f"{number:g} m" for number in numbers)

    def span(key: str) -> str:
        return "{:g} to {:g} m, uniform".format(*random[key]["default"])

    def place(key: str) -> str:
        return "[" + ", ".join(f"{number:g}" for number in scene["query"][key]) + "]"

    rows = [
        ["workspace", "2 m × 2 m × 2 m", sides(b - a for a, b in zip(low, high, strict=True)), "`workspace` of the scenes"],
        ["end-effector", "0.15 m × 0.15 m × 0.05 m", sides(body), "`platform` of `testdata/robots/paper.toml`"],
        ["initial position", "[0.3, 1, 0.3]", place("start"), "`query.start` of the scenes"],
        ["goal position", "[1.7, 1, 1.7]", place("goal"), "`query.goal` of the scenes"],
        ["step distance", "0.1 m", f"{step:g} m", "default of `--step` and, for RRT and RRT\\*, of `--extend-step`"],
        ["height of obstacles", "0.5–1.5 m", span("height"), "default of `random.height`"],
        ["width of obstacles", "0.1–0.3 m", span("width") + ", square base", "default of `random.width`"],
    ]
    return table(["description", "paper", "cdpr", "where"], rows)


def table2(run: Run, printed: dict[tuple[str, str], dict[str, list[float]]]) -> str:
    head = ["", "planning, ms: mean, median", "motion checks: mean", "compiling, µs: mean", "post-processing, ms, median", "cost, m"]

    def row(scenario: str, method: str) -> list[str]:
        post = method.endswith("post-processing")
        return [
            f"{scenario}, {method}",
            f"{run.spread(scenario, method, 'planning_seconds', 1e3)}, {digits(1e3 * run.median(scenario, method, 'planning_seconds'))}",
            f"{run.mean(scenario, method, 'motion_checks'):.0f}",
            digits(1e6 * run.mean(scenario, method, "compile_seconds")),
            digits(1e3 * run.median(scenario, method, "post_seconds")) if post else "",
            run.spread(scenario, method, "cost", decimals=3),
        ]

    def theirs(scenario: str, method: str) -> str:
        def pair(measure: str) -> str:
            found = printed[scenario, method].get(measure)
            return "–" if found is None else f"{found[0]:.3f} ± {found[1]:.3f}"

        return "; ".join(pair(measure) for measure in ("planning_seconds", "post_seconds", "cost"))

    places = list(run.of)
    scenarios = sorted({scenario for scenario, _ in places})
    rows = [row(scenario, method) for scenario in scenarios for method in FOUR]
    if all((scenario, method) in printed for scenario in scenarios for method in FOUR):
        head.append("paper: planning, s; post-processing, s; cost, m")
        shown = [theirs(scenario, method) for scenario in scenarios for method in FOUR]
        rows = [[*row, found] for row, found in zip(rows, shown, strict=True)]
    return table(head, rows)


def printed_means() -> dict[tuple[str, str], dict[str, list[float]]]:
    """What the paper prints in its Table 2."""
    experiments = tomllib.loads(PAPER.read_text())["experiments"]
    means = next(entry["means"] for entry in experiments if "table2" in entry["names"])
    return {tuple(entry["of"]): entry for entry in means}


def deviations(paper: Run, ours: Run) -> str:
    """The standard deviations of planning times, as shares of their means."""
    printed = printed_means()

    def relative(run: Run, place: tuple[str, str]) -> str:
        described = run.of[place]["planning_seconds"]
        return f"{described['sd'] / described['mean']:.2f}"

    def row(scenario: str, method: str) -> list[str]:
        mean, sd = printed[scenario, method]["planning_seconds"]
        place = scenario, method
        return [f"{scenario}, {method}", f"{sd / mean:.2f}", relative(paper, place), relative(ours, place)]

    rows = [row(scenario, method) for scenario in ("hard1", "hard3") for method in FOUR]
    return table(["standard deviation over mean", "paper", "paper's rules", "cdpr's rules"], rows)


def probabilities(paper: Run, ours: Run) -> str:
    experiments = tomllib.loads(PAPER.read_text())["experiments"]
    theirs = next(entry["p_values"] for entry in experiments if "table2" in entry["names"])

    def shown(p: float) -> str:
        return "< 0.001" if p < 0.001 else f"{p:.4f}"

    groups = sorted(theirs)
    rows = [
        ["paper", *(theirs[group] for group in groups)],
        ["by the paper's rules", *(shown(paper.found["p"][group]) for group in groups)],
        ["cdpr's rules", *(shown(ours.found["p"][group]) for group in groups)],
    ]
    return table(["group", *groups], rows)


def claims(paper: Run, ours: Run) -> str:
    """The claims about Table 2, under both sets of rules."""
    radii_paper, radii = Run("radii_paper"), Run("radii")
    both = ((paper, radii_paper), (ours, radii))

    def shares(scenario: str, measure: str) -> list[str]:
        return [share(run, scenario, MODIFIED, RRT_STAR, measure) for run, _ in both]

    def counted(scenario: str) -> list[str]:
        def one(run: Run) -> str:
            of = {method: run.of[scenario, method] for method in (MODIFIED, RRT_STAR)}
            times = {k: m["planning_seconds"]["mean"] + m["compile_seconds"]["mean"] for k, m in of.items()}
            return f"{digits(100 * times[MODIFIED] / times[RRT_STAR])} %"

        return [one(run) for run, _ in both]

    def shorter(scenario: str, method: str | None) -> list[str]:
        def one(run: Run, wide: Run) -> str:
            other = (run, scenario, RRT_STAR, "cost") if method is None else (wide, scenario, method, "raw_cost")
            return less((run, scenario, MODIFIED, "cost"), other)

        return [one(run, wide) for run, wide in both]

    def reduced(scenario: str, before: str, after: str) -> list[str]:
        return [less((run, scenario, after, "cost"), (run, scenario, before, "cost")) for run, _ in both]

    def versus(text: Callable[[Run, str], str]) -> list[str]:
        return ["; ".join(text(run, scenario) for scenario in ("hard1", "hard3")) for run, _ in both]

    def final(run: Run, scenario: str) -> str:
        costs = (run.mean(scenario, method, "cost") for method in (RRT_STAR_POST, MODIFIED_POST))
        return " vs ".join(f"{cost:.3f}" for cost in costs) + " m"

    def waypoints(run: Run, scenario: str) -> str:
        return " vs ".join(f"{run.mean(scenario, method, 'waypoints'):.1f}" for method in (MODIFIED, RRT_STAR))

    def winds(run: Run, scenario: str) -> str:
        return " vs ".join(f"{run.found['winding'][f'{scenario} | {method}'][0]:.0f}°" for method in (MODIFIED, RRT_STAR))

    def longer(run: Run, scenario: str) -> str:
        star, modified = (run.median(scenario, method, "post_seconds") for method in (RRT_STAR_POST, MODIFIED_POST))
        return f"{star / modified:.1f} times (medians)"

    def growth(method: str) -> list[str]:
        def one(run: Run) -> str:
            mean, median = (
                getattr(run, which)("hard3", method, "planning_seconds") / getattr(run, which)("hard1", method, "planning_seconds")
                for which in ("mean", "median")
            )
            return f"× {digits(mean, 2)} (medians × {digits(median, 2)})"

        return [one(run) for run, _ in both]

    star_post, modified_post = "post-processing shortens RRT\\*'s path", "post-processing shortens modified RRT's path"
    rows = [
        ["time of modified RRT, share of RRT\\*'s, one obstacle", "0.87 %", *shares("hard1", "planning_seconds"),
         "yes, much less pronounced"],
        ["time of modified RRT, share of RRT\\*'s, three obstacles", "28.62 %", *shares("hard3", "planning_seconds"),
         "**no**: no significant difference of means"],
        ["the same share with compiling counted in every trial, one obstacle", "–", *counted("hard1"), "as above: GJK compiles almost nothing"],
        ["the same share with compiling counted in every trial, three obstacles", "–", *counted("hard3"), "as above"],
        ["motion checks of modified RRT, share of RRT\\*'s, one obstacle", "not stated", *shares("hard1", "motion_checks"), "modified RRT makes fewer"],
        ["motion checks of modified RRT, share of RRT\\*'s, three obstacles", "not stated", *shares("hard3", "motion_checks"), "modified RRT makes more"],
        ["path of modified RRT shorter than RRT\\*'s, radius of at most one step (0.1 m), one obstacle", "19.88 %", *shorter("hard1", None),
         "yes, but this RRT\\* is RRT with a little rewiring"],
        ["path of modified RRT shorter than RRT\\*'s, radius of at most one step, three obstacles", "13.40 %", *shorter("hard3", None),
         "yes, but this RRT\\* is RRT with a little rewiring"],
        ["path of modified RRT shorter than RRT\\*'s, radius 0.3 m, one obstacle", "19.88 %", *shorter("hard1", "RRT*, 0.3 m"), "**no**: longer"],
        ["path of modified RRT shorter than RRT\\*'s, radius 0.3 m, three obstacles", "13.40 %", *shorter("hard3", "RRT*, 0.3 m"), "**no**: longer"],
        ["path of modified RRT shorter than RRT\\*'s, radius by the formula without a cap, one obstacle", "19.88 %", *shorter("hard1", "RRT*, uncapped"),
         "**no**: longer"],
        ["path of modified RRT shorter than RRT\\*'s, radius by the formula without a cap, three obstacles", "13.40 %", *shorter("hard3", "RRT*, uncapped"), "**no**: longer"],
        ["fewer waypoints, hard1; hard3", "in a figure", *versus(waypoints), "yes"],
        ["less winding, hard1; hard3 (200 trials)", "in a figure", *versus(winds), "yes"],
        [f"{star_post}, one obstacle", "35.31 %", *reduced("hard1", RRT_STAR, RRT_STAR_POST), "yes"],
        [f"{modified_post}, one obstacle", "17.11 %", *reduced("hard1", MODIFIED, MODIFIED_POST), "yes, less"],
        [f"{star_post}, three obstacles", "34.20 %", *reduced("hard3", RRT_STAR, RRT_STAR_POST), "yes, less"],
        [f"{modified_post}, three obstacles", "18.44 %", *reduced("hard3", MODIFIED, MODIFIED_POST), "yes, somewhat less"],
        ["shortest in the end: RRT\\* with post-processing; hard1; hard3", "both scenes", *versus(final), "yes"],
        ["post-processing of RRT\\*'s path takes longer; hard1; hard3", "2.0; 1.9 times", *versus(longer), "yes"],
        ["RRT\\*'s time hardly depends on the scene (hard3 over hard1)", "× 0.97", *growth(RRT_STAR), "**no**"],
        ["modified RRT's time depends on the scene", "× 32", *growth(MODIFIED), "yes"],
    ]  # fmt: skip
    return table(["claim of the paper", "paper", "paper's rules", "cdpr's rules", "holds by the paper's rules?"], rows)


def windings(run: Run) -> str:
    """Waypoints of all trials, turning of the first ones."""

    def row(method: str) -> list[str]:
        cells = []
        for scenario in ("hard1", "hard3"):
            mean, sd = run.found["winding"][f"{scenario} | {method}"]
            cells += [run.spread(scenario, method, "waypoints", decimals=1), f"{mean:.0f} ± {sd:.0f}°"]
        return [method.replace("*", "\\*"), *cells]

    head = ["", "waypoints, hard1", "turning, hard1 (200 trials)", "waypoints, hard3", "turning, hard3 (200 trials)"]
    return table(head, [row(method) for method in FOUR])


def radii() -> str:
    found, paper = Run("radii"), Run("radii_paper")
    base = {True: Run("table2_paper"), False: Run("table2")}

    def row(rules: str, run: Run, scenario: str, method: str, shown: str, raw: str) -> list[str]:
        after = RRT_STAR_POST if method == RRT_STAR else method
        return [
            rules, scenario, shown,
            digits(1e3 * run.median(scenario, method, "planning_seconds")),
            run.spread(scenario, method, raw, decimals=3),
            f"{run.mean(scenario, method, raw.replace('cost', 'waypoints')):.1f}",
            run.spread(scenario, after, "cost", decimals=3),
        ]  # fmt: skip

    rows = []
    for is_paper, wide in ((True, paper), (False, found)):
        rules = "paper's" if is_paper else "cdpr's"
        for scenario in ("hard1", "hard3"):
            rows.append(row(rules, base[is_paper], scenario, RRT_STAR, "at most one step (0.1 m)", "cost"))
            rows.append(row(rules, wide, scenario, "RRT*, 0.3 m", "0.3 m", "raw_cost"))
            rows.append(row(rules, wide, scenario, "RRT*, uncapped", "by the formula, uncapped", "raw_cost"))
    return table(["rules", "scene", "radius", "planning, ms: median", "path, m", "waypoints: mean", "after post-processing, m"], rows)


def ablations(run: Run) -> str:
    names = {
        MODIFIED: "Modified RRT",
        "no goal test, goal bias 0.05": "without the goal test, goal bias 0.05",
        "no goal test, goal bias 0.1": "without the goal test, goal bias 0.1",
        "steps": "steps of 0.1 m instead of direct connections",
        "steps, goal bias 0.05": "steps and goal bias 0.05 (RRT as it is usually run)",
        "steps, goal bias 0.1": "steps and goal bias 0.1",
        "RRT": "plain RRT",
        "RRT, 500 000 samples": "plain RRT, 500 000 samples",
    }

    def row(scenario: str, method: str) -> list[str]:
        entry = run.of[scenario, method]
        return [
            scenario, names[method],
            f"{100 * entry['solved'] / entry['n']:.1f} %",
            f"{run.found['samples'][f'{scenario} | {method}']:.0f}",
            f"{run.median(scenario, method, 'motion_checks'):.0f}",
            digits(1e3 * run.median(scenario, method, "planning_seconds")),
            f"{run.mean(scenario, method, 'raw_cost'):.3f}",
            f"{run.mean(scenario, method, 'waypoints'):.1f}",
        ]  # fmt: skip

    rows = [row(scenario, method) for scenario in ("empty", "hard1", "hard3") for method in names]
    head = ["scene", "planner", "solved", "samples", "motion checks", "planning, ms", "cost, m: mean", "waypoints: mean"]
    return table(head, rows)


def rank6_claims(paper: Run, full: Run, full_paper: Run) -> str:
    """The claims of Table 2 on the robot of full rank beside those on the other."""
    runs = ((paper, ""), (full_paper, "_rank6"), (full, "_rank6"))

    def shares(scenario: str, measure: str) -> list[str]:
        return [share(run, scenario + suffix, MODIFIED, RRT_STAR, measure) for run, suffix in runs]

    def reduced(scenario: str, before: str, after: str) -> list[str]:
        return [less((run, scenario + suffix, after, "cost"), (run, scenario + suffix, before, "cost")) for run, suffix in runs]

    def line(text: str, theirs: tuple[str, str], of: Callable[[str], list[str]]) -> list[list[str]]:
        return [[f"{text}, {scenario}", printed, *of(scenario)] for scenario, printed in zip(("hard1", "hard3"), theirs, strict=True)]

    rows = [
        *line("time of modified RRT, share of RRT\\*'s", ("0.87 %", "28.62 %"), lambda s: shares(s, "planning_seconds")),
        *line("the same in motion checks", ("not stated",) * 2, lambda s: shares(s, "motion_checks")),
        *line("path of modified RRT shorter", ("19.88 %", "13.40 %"), lambda s: reduced(s, RRT_STAR, MODIFIED)),
        *line("post-processing shortens RRT\\*'s path", ("35.31 %", "34.20 %"), lambda s: reduced(s, RRT_STAR, RRT_STAR_POST)),
        *line("post-processing shortens modified RRT's path", ("17.11 %", "18.44 %"), lambda s: reduced(s, MODIFIED, MODIFIED_POST)),
    ]
    return table(["claim", "paper", "`paper.toml`, paper's rules", "rank 6, paper's rules", "rank 6, cdpr's rules"], rows)


def wrenches(run: Run) -> str:
    names = {
        "without wrenches": "none", "paper": "the paper's: two spheres at the nearest point of a grid of 5 cm",
        "corners": "capacity margin at all corners of a grid's cells", "certified": "capacity margin certified along motions (cdpr's default)",
    }  # fmt: skip

    def row(scenario: str) -> list[str]:
        entry = run.of[scenario, MODIFIED_POST]
        return [
            names[scenario], *(f"{share:.0f} %" for share in run.found["accepted"][scenario]), f"{entry['solved']} of {entry['n']}",
            digits(1e3 * run.median(scenario, MODIFIED_POST, "planning_seconds")),
            digits(1e3 * run.mean(scenario, MODIFIED_POST, "compile_seconds")),
            run.spread(scenario, MODIFIED_POST, "cost", decimals=3),
        ]  # fmt: skip

    head = ["rule for wrenches", "positions accepted", "of all, accepted where the weight cannot be held", "solved", "planning, ms: median", "compiling, ms: mean", "cost, m"]
    return table(head, [row(scenario) for scenario in names])


def fig7(run: Run) -> str:
    entries = [entry for entry in run.found["methods"] if entry["sweep"]]
    by_step = {entry["sweep"]["step"]: entry for entry in entries}
    steps = (0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5)

    def line(name: str, of: Callable[[dict[str, Any]], str]) -> list[str]:
        return [name, *(of(by_step[step]) for step in steps)]

    rows = [
        line("mean reduction, %", lambda entry: f"{100 * entry['reduction']['mean']:.2f}"),
        line("mean time, ms", lambda entry: digits(1e3 * entry["post_seconds"]["mean"])),
        line("median time, ms", lambda entry: digits(1e3 * entry["post_seconds"]["median"])),
    ]
    return table(["step, m", *(str(step) for step in steps)], rows)


def fig8(run: Run) -> str:
    head = [
        "repeats", "backward first, %", "forward first, %", "difference of these means", "mean of the gap", "largest gap",
        "gap > 0.01 points", "gap > 1 point", "gap > 5 points", "keeping the better gains (over backward, over forward)",
    ]  # fmt: skip

    def row(repeats: str) -> list[str]:
        backward, forward, gap, largest, one, five, best, difference, spread, some = run.found["gaps"][repeats]
        interval = f"{difference:.2f} ({difference - spread:.2f} to {difference + spread:.2f})".replace("-", "−")
        numbers = [f"{backward:.2f}", f"{forward:.2f}", interval, f"{gap:.2f}", f"{largest:.2f}"]
        return [repeats, *numbers, f"{some:.0f} %", f"{one:.1f} %", f"{five:.1f} %", f"{best - backward:.2f}, {best - forward:.2f}"]

    return table(head, [row(repeats) for repeats in ("1", "2", "3", "10")])


def solved(*names: str) -> str:
    """How many random scenes are solved, and what became of the others."""
    rows = []
    for name in names:
        entry = Run(name).found["methods"][0]
        statuses = entry["statuses"]
        assert set(statuses) <= {"solved", "no_path", "budget_spent"}, statuses
        missed = statuses.get("budget_spent", 0)
        rows.append([f"`{name}.toml`", *(str(x) for x in (entry["n"], entry["solved"], statuses.get("no_path", 0), missed))])
    return table(["experiment", "scenes", "solved", "proved to have no path", "missed"], rows)


def orders(run: Run) -> str:
    names = {
        "backward-only": "Algorithm 4 alone", "forward-only": "Algorithm 5 alone", "backward": "backward, then forward",
        "forward": "forward, then backward", "both": "the shorter of these two",
    }  # fmt: skip
    by_post = {(entry["scenario"], entry["sweep"]["post"]): entry for entry in run.found["methods"]}

    def row(post: str) -> list[str]:
        entries = [by_post[scenario, post] for scenario in ("hard1", "hard3")]
        return [names[post], *(f"{100 * entry['reduction']['mean']:.2f} %" for entry in entries)]

    return table(["mean reduction", "hard1", "hard3"], [row(post) for post in names])


def steps_of_rrt_star(run: Run) -> str:
    methods = [f"RRT*, step {step}" for step in ("0.05", "0.1", "0.2", "0.4", "0.8")] + [MODIFIED]
    rows = [[scene, *(f"{run.mean(scene, method, 'cost'):.3f}" for method in methods)] for scene in ("hard1", "hard3")]
    return table(["", "0.05 m", "0.1 m", "0.2 m", "0.4 m", "0.8 m", "modified RRT"], rows)


def prisms(run: Run) -> str:
    scenes = ["1 prism", "3 prisms", "5 prisms", "7 prisms"]
    star, modified = "RRT*, step 0.1", MODIFIED

    def line(name: str, method: str) -> list[str]:
        return [name, *(f"{run.median(scene, method, 'motion_checks'):.0f}" for scene in scenes)]

    def rate(scene: str) -> str:
        entries = [run.of[scene, method] for method in (star, modified)]
        return ", ".join(f"{100 * entry['solved'] / entry['n']:.0f}" for entry in entries) + " %"

    rows = [
        line("RRT\\*", star), line("modified RRT", modified),
        ["solved, RRT\\* and modified RRT", *(rate(scene) for scene in scenes)],
    ]  # fmt: skip
    return table(["prisms", "1", "3", "5", "7"], rows)


def tables() -> dict[str, str]:
    """All tables of the page."""
    paper, ours, printed = Run("table2_paper"), Run("table2"), printed_means()
    discussion, full, full_paper = Run("discussion"), Run("table2_rank6"), Run("table2_rank6_paper")
    return {
        "table1": table1(),
        "claims": claims(paper, ours),
        "table2, the paper's rules": table2(paper, printed),
        "table2, cdpr's rules": table2(ours, printed),
        "deviations": deviations(paper, ours),
        "t-tests": probabilities(paper, ours),
        "winding": windings(ours),
        "radii": radii(),
        "ablations, the paper's rules": ablations(Run("ablations_paper")),
        "ablations, cdpr's rules": ablations(Run("ablations")),
        "rank 6": rank6_claims(paper, full, full_paper),
        "table2, rank 6, the paper's rules": table2(full_paper, {}),
        "table2, rank 6, cdpr's rules": table2(full, {}),
        "wrenches": wrenches(Run("wrench_rank6")),
        "orders": orders(Run("orders_paper")),
        "random scenes": solved("fig7_paper", "fig7", "fig8_paper", "fig8"),
        "fig7, the paper's rules": fig7(Run("fig7_paper")),
        "fig7, cdpr's rules": fig7(Run("fig7")),
        "fig8, the paper's rules": fig8(Run("fig8_paper")),
        "fig8, cdpr's rules": fig8(Run("fig8")),
        "steps": steps_of_rrt_star(discussion),
        "prisms": prisms(discussion),
    }


def filled(page: str, made: dict[str, str]) -> str:
    """The page with these tables in their places, `<!-- table: NAME -->` to `<!-- end -->`."""
    places = re.findall(r"<!-- table: (.*?) -->", page)
    if sorted(places) != sorted(made):
        raise SystemExit(f"places {sorted(places)}, tables {sorted(made)}")

    def fill(place: re.Match[str]) -> str:
        return f"<!-- table: {place[1]} -->\n\n{made[place[1]]}\n\n<!-- end -->"

    return re.sub(r"<!-- table: (.*?) -->.*?<!-- end -->", fill, page, flags=re.DOTALL)


if __name__ == "__main__":
    for run in sorted(Path(sys.argv[1]).iterdir()) if len(sys.argv) > 1 else ():
        if (run / "summary.json").exists():
            RESULTS.mkdir(exist_ok=True)
            (RESULTS / f"{run.name}.json").write_text(written(recorded(run)))
    PAGE.write_text(filled(PAGE.read_text(), tables()))
