"""The options of every command, as the help lists them, and random lines of them over files of one folder."""

from __future__ import annotations

import hashlib
import random
import re
import subprocess
from pathlib import Path

from conftest import program

SECONDS = 120  # a line that takes longer hangs

# Scenes, and what planning in them takes; names of orientations.
SCENES = {"hard1": [], "closed": [], "plank": ["along", "across"], "turn": ["along", "across"], "cogiro": [], "concave": []}
LIMITS = ["--speed", "1", "--acceleration", "2", "--turn-speed", "1", "--turn-acceleration", "2"]
OF_MOTIONS = ["speed", "acceleration", "turn-speed", "turn-acceleration", "jerk", "cable-speed", "cable-acceleration", "blend"]
OF_MOTIONS = [f"--{name}" for name in [*OF_MOTIONS, "motion-clearance", "wrench-margin"]]
INPUT = "(an input)"


def run(folder: Path, line: list[str]) -> subprocess.CompletedProcess[str]:
    command = [program(), *line]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=SECONDS, stdin=subprocess.DEVNULL)


def options_of(command: str) -> dict[str, tuple[bool, list[str]]]:
    """Each option in the help of a command: whether it takes values, and those it may have if they are listed."""
    return options_in(subprocess.run([program(), command, "--help"], capture_output=True, text=True, check=True).stdout)


def options_in(shown: str) -> dict[str, tuple[bool, list[str]]]:
    found: dict[str, tuple[bool, list[str]]] = {}
    listed = shown.partition("\nOptions:\n")[2].partition("\nExamples:\n")[0]  # a wrapped example may begin with an option
    for entry in re.split(r"\n(?= {2,6}-)", listed):
        head = re.match(r"\s*(?:-\w, )?(--[\w-]+)( <)?", entry)
        if head and head[1] not in ("--help", "--version"):
            named = re.findall(r"^ +- ([\w-]+)(?:: .*)?$", entry, re.MULTILINE) if "Possible values:" in entry else []
            inline = re.search(r"\[possible values: ([^\]]*)\]", " ".join(entry.split()))
            found[head[1]] = (head[2] is not None, named or (inline[1].split(", ") if inline else []))
    return found


def commands() -> list[str]:
    shown = subprocess.run([program(), "--help"], capture_output=True, text=True, check=True).stdout
    names = re.findall(r"^  ([a-z]+) ", shown.partition("Commands:\n")[2].partition("\n\n")[0], re.MULTILINE)
    return [name for name in names if name != "help"]


OPTIONS = {command: options_of(command) for command in commands()}


def contents(folder: Path) -> dict[str, str]:
    # Beside a mesh, its convex parts are kept.
    files = sorted(path for path in folder.rglob("*") if path.is_file() and not path.name.endswith(".parts.json"))
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest() for path in files}


class Draw:
    """Draws one line of a command."""

    def __init__(self, seed: str, folder: Path, command: str, must: str | None = None) -> None:
        self.random, self.folder, self.command = random.Random(seed), folder, command
        self.outputs: list[str] = []
        self.replaced: list[str] = []
        self.scene = self.random.choice(list(SCENES) + ["mesh"] * (command in ("plan", "info", "shadows")))
        options = {option: self.value(option) for option in self.chosen(must)}
        # Tours and tasks may search for ever only for a `--gap`.
        if command in ("plan", "tour", "task") and not {"--budget-ms", "--max-samples"} & set(options):
            options |= {"--budget-ms": self.value("--budget-ms")}
        self.options = options
        self.positional = self.files()
        self.replaces_an_input()
        parts = [[option, *values] for option, values in self.options.items()]
        self.random.shuffle(parts)
        # Before options: some take any number of values.
        self.line = [command, *self.positional, *(word for part in parts for word in part)]

    def often(self, probability: float) -> bool:
        return self.random.random() < probability

    def chosen(self, must: str | None) -> list[str]:
        known = [option for option in OPTIONS[self.command] if option not in ("--quiet", "--verbose")]
        some = self.random.sample(known, min(self.random.choice([0, 1, 1, 2, 3]), len(known)))
        some += [] if must is None else [must]
        some += {
            "wrench": [self.random.choice(["--at", "--grid", "--along"])] if not {"--at", "--grid", "--along"} & set(some) else [],
            "trajectory": ["--speed", "--acceleration"] + ["--turn-speed", "--turn-acceleration"] * (self.scene == "turn"),
            "new": ["--robot"] if {"--obstacle", "--start", "--goal"} & set(some) else [],
        }.get(self.command, [])
        needed = {"view", "shadows", "export", "import", "batch", "merge", "task"}
        some += ["--output"] if self.command in needed or "--grid" in some else []
        also = {"--units": "--obstacle" if self.command == "new" else "--platform", "--projected": "--grid", "--effort": "--trajectory", "--joints": "--trajectory"}
        also |= {"--static": "--html", "--minimise": "--trajectory", "--within": "--maximise", "--rate": "--trajectory", "--margin": "--at", "--obstacle": "--robot"}
        also |= dict.fromkeys(OF_MOTIONS, {"plan": "--trajectory", "task": "--trajectory", "tour": "--by"}.get(self.command, ""))
        for option in some:  # grows, for what is added may need more
            if also.get(option) in OPTIONS[self.command] and self.often(0.9):
                some.append(also[option])
        if "--trajectory" in some and self.command in ("plan", "task") or "--by" in some:
            some += ["--speed", "--acceleration", "--turn-speed", "--turn-acceleration"]
        if self.often(0.3):
            some.append(self.random.choice(["--quiet", "--verbose"]))
        if must is None and self.often(0.3) and "--format" in OPTIONS[self.command]:
            some.append("--format")
        return list(dict.fromkeys(some))

    def value(self, option: str) -> list[str]:
        takes, choices = OPTIONS[self.command][option]
        if not takes:
            return []
        if choices and option != "--by":
            return [self.random.choice(choices)]
        value = getattr(self, f"{self.command}_{option[2:].replace('-', '_')}", None) or getattr(self, option[2:].replace("-", "_"))
        found = value()
        return found if isinstance(found, list) else [str(found)]

    def number(self, *numbers: float) -> float:
        return self.random.choice(numbers)

    def position(self) -> list[str]:
        here = {"cogiro": [(0, 0, 2), (2, 1, 1.5)], "turn": [(0.5, 0.5, 0.15), (1.0, 0.4, 1.2)], "plank": [(0.45, 1, 0.5), (1.55, 1, 0.5)]}
        places = here.get(self.scene, [(0.3, 1, 0.3), (1.7, 1, 1.7), (0.3, 1, 1.5), (1, 1, 1)])
        place = self.random.choice([*places, *places, (9, 9, 9), (-1, 0, 0)])
        return [str(x) for x in place]

    def station(self) -> str:
        return self.random.choice(["dock", "upper rack", "between", "dokc"])

    def place(self) -> list[str]:
        return [self.station()] if self.often(0.2) else self.position()

    start = goal = at = via = place

    def within(self) -> float:
        return self.number(1, 1.02, 1.1, 3, 0.9)

    def goal_box(self) -> list[str]:
        return self.random.choice([["0.2", "0.8", "0.2", "0.6", "1.2", "1.6"], ["1.6", "1", "1.6", "1.9", "1", "1.8"], ["1", "1", "1", "0", "0", "0"]])

    guess = new_start = new_goal = position
    tour_start = station

    def stations(self) -> str:
        return self.random.choice(["dock,upper rack", "upper rack,dock,between", "dock", "dock,dokc"])

    def matrix(self) -> str:
        return self.new_file(".csv")

    def orientation(self) -> str:
        return self.random.choice([*SCENES.get(self.scene, []), *SCENES.get(self.scene, []), "1,0,0,0", "0.6,0,0,0.8", "askew"])

    start_orientation = goal_orientation = orientation

    def orientations(self) -> list[str]:
        return [self.orientation() for _ in range(self.random.choice([1, 2, 2]))]

    def pose_orientation(self) -> str:
        return self.random.choice(["1,0,0,0", "1,0,0,0", "0.6,0,0,0.8", "level"])

    def start_lengths(self) -> str:
        return self.given("lengths.csv")

    def new_file(self, *endings: str) -> str:
        if self.often(0.04):
            return "-"
        if self.often(0.06):
            return INPUT
        if self.often(0.05) and self.outputs:
            return self.random.choice(self.outputs)
        self.outputs.append(f"made{len(self.outputs)}{'.odd' if self.often(0.04) else self.random.choice(endings)}")
        return self.outputs[-1]

    def output(self) -> str:
        endings = {
            "plan": (".json", ".csv"), "post": (".json", ".csv"), "trajectory": (".json", ".csv", ".yaml"), "view": (".html",),
            "shadows": (".obj", ".stl", ".ply", ".html"), "import": (".toml", ".json"), "report": (".html",), "man": ("",), "batch": ("",),
            "merge": ("",), "export": (".xml",), "wrench": (".npz", ".vti", ".csv"), "workspace": (".json", ".npz", ".vti", ".stl"), "pose": (".csv", ".json"),
            "tour": (".json", ".csv"), "task": ("",),
        }
        made = self.new_file(*endings[self.command])
        if self.command == "export":
            self.outputs.append(str(Path(made).with_suffix(".npz")))  # the motion
        return made

    def replaces_an_input(self) -> None:
        """Puts the name of an input in place of `INPUT`."""
        read = [*self.positional, *(word for option in ("--along", "--robot", "--platform", "--start-lengths", "--replan") for word in self.options.get(option, []))]
        read += ["machine.stl", "paper.toml"] * ("mesh.toml" in read) + ["hard1.toml"] * ("trials.toml" in read)
        read = [name for name in read if name not in (INPUT, "-")]
        self.outputs += ["made"] * (not read)
        chosen = self.random.choice(read or ["made"])
        if INPUT in self.positional or any(INPUT in words for words in self.options.values()):
            self.replaced.append(chosen)
        self.options = {option: [chosen if word == INPUT else word for word in words] for option, words in self.options.items()}
        self.positional = [chosen if word == INPUT else word for word in self.positional]

    def html(self) -> str:
        return self.new_file(".html")

    def trajectory(self) -> str:
        return self.new_file(".json", ".csv", ".yaml")

    def task_trajectory(self) -> str:
        return self.random.choice(["motion.json", "motion.csv", "motion.yaml", "leg-1.json", "../motion.csv", "motion.odd"])

    def example_files(self) -> str:
        return self.new_file("")

    def tour_by(self) -> str:
        return "length" if self.often(0.1) else "time"

    def proof(self) -> str:
        return self.new_file(".json")

    def given(self, *kinds: str) -> str:
        """An input of one of these kinds, usually of the scene."""
        whole = [name for name in contents(self.folder) if name.endswith((".json", ".csv", ".toml"))]
        fitting = [f"{self.scene}-{kind}" for kind in kinds if (self.folder / f"{self.scene}-{kind}").exists()]
        return self.random.choice(fitting if fitting and self.often(0.9) else whole)

    def replan(self) -> str:
        return self.given("path.json", "path.csv", "poses.csv")

    def along(self) -> str:
        return self.given("path.json", "path.csv", "poses.csv")

    def files(self) -> list[str]:
        scene = f"{self.scene}.toml" if self.scene == "mesh" or self.often(0.7) else f"{self.scene}.json"
        any_path = ("path.json", "path.csv", "poses.csv")
        any_motion = ("motion.json", "motion.csv")
        match self.command:
            case "plan" | "info" | "shadows" | "workspace" | "wrench" | "tour":
                return [scene]
            case "task":
                return ["tower.toml" if self.often(0.9) else scene]
            case "post" | "trajectory":
                return [scene, self.given(*any_path, *["raw.csv"] * 3)]
            case "check":
                limits = set(OF_MOTIONS) & set(self.options)
                ends = {"--start", "--goal"} & set(self.options)
                if not (limits or ends or "--at" in self.options) and self.often(0.1):
                    return ["tower.toml", "tower-task/task.json"]
                wanted = any_motion if limits else ("proof.json",) if ends else (*any_path, *any_motion, "proof.json")
                return [scene] if "--at" in self.options else [scene, self.given(*wanted)]
            case "export":
                return [scene, self.given(*any_motion)] if self.often(0.8) else [scene]
            case "view":
                return [scene, self.given(*any_path, *any_motion, "proof.json")] if self.often(0.8) else [scene]
            case "new":
                return [self.new_file(".toml", ".json")] if self.often(0.1 if "--example-files" in self.options else 0.8) else []
            case "import":
                return [self.random.choice(["CoGiRo", "CoGiRo/CoGiRo_cables.xml", "caroca.yaml"])]
            case "pose":
                return ["robot.toml", "encoders.csv" if self.often(0.9) else self.given("lengths.csv")]
            case "batch":
                return ["trials.toml"]
            case "merge":
                return self.random.choice([["run0", "run2"], ["run0"], ["run0", "run0"]])
            case "report":
                return [self.random.choice(["run0", "run2", "CoGiRo"])]
            case "completions":
                return [self.random.choice(["bash", "fish", "zsh"])]
            case "schema":
                return self.random.choice([[], ["scene"], ["robot"], ["path"], ["experiment"]])
            case "man":
                return []
            case other:
                raise AssertionError(f"no files are known for the command {other}")

    def cable(self) -> list[str]:
        return self.random.choice([["cable 0"], ["cable 1", "cable 0"], ["nope"]])

    def shadows_obstacle(self) -> list[str]:
        return self.random.choice([["pillar"], ["left"], ["nope"]])

    def new_obstacle(self) -> list[str]:
        return self.random.choice([["machine.stl"], ["machine.stl", "platform.stl"], ["hard1.toml"]])

    def robot(self) -> str:
        return self.random.choice(["paper.toml", "robot.toml", "hard1.toml"])

    def platform(self) -> str:
        return "platform.stl"

    def bodies(self) -> str:
        return self.random.choice(["CoGiRo/CoGiRo_bodies.xml", "caroca.yaml"])

    def cable_set(self) -> str:
        return self.random.choice(["original", "gazebo_sim", "nope"])

    def trials(self) -> str:
        return self.random.choice(["1", "0..2", "2..1", "1..3"])

    def threads(self) -> int:
        return self.random.choice([1, 2, 0])

    def budget_ms(self) -> float:
        return self.number(1, 50, 200)

    def seed(self) -> int:
        return self.random.choice([0, 1, 7, 2**64 - 1])

    def max_samples(self) -> int:
        return self.random.choice([0, 10, 1000])

    max_nodes = max_samples

    def repeats(self) -> int:
        return self.random.choice([0, 1, 3])

    def step(self) -> float:
        return self.number(0.02, 0.1, 0.5, 0, -1)

    extend_step = near_radius = near_cap = step

    def goal_bias(self) -> float:
        return self.number(0, 0.1, 1, 2)

    def target_cost(self) -> float:
        return self.number(0.5, 2.6, 5)

    def gap(self) -> float:
        return self.number(0.001, 0.1)

    def resolution(self) -> float:
        return self.number(0.5, 0.2, 0, -1)

    def grid(self) -> float:
        return self.number(0.5, 1, 3)

    def force(self) -> float:
        return self.number(0, 5, 100, -3)

    moment = force

    def margin(self) -> float:
        return self.number(0, 0.001, 0.05)

    def rate(self) -> float:
        return self.number(50, 100, 333.3, 1e9)

    def speed(self) -> float:
        return self.number(0.5, 1, 20)

    turn_speed = cable_speed = speed

    def acceleration(self) -> float:
        return self.number(0.5, 2, 50)

    turn_acceleration = cable_acceleration = acceleration

    def jerk(self) -> float:
        return self.number(2, 50)

    def blend(self) -> float:
        return self.number(0, 0.02, 0.2)

    motion_clearance = blend

    def wrench_margin(self) -> float:
        return self.number(0, 1, 1e4)


def kept(options: dict[str, list[str]], *names: str) -> list[str]:
    return [word for name in names if name in options for word in (name, *options[name])]
