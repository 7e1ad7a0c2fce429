"""Random command lines, over files of one folder: every option of every command, as the help lists them.

Each line ends with status 0, 1 or 2, changes no input, writes nothing but the outputs that it names, prints JSON with `--format
json`, and says the same in text, JSON and files; `check` accepts what `plan` wrote. A new option must also be drawn by `Draw`.
"""

from __future__ import annotations

import json
import os
import random
import re
import shutil
import subprocess
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

import pytest
from command_lines import LIMITS, OF_MOTIONS, OPTIONS, SCENES, Draw, contents, kept, options_of, run
from conftest import TESTDATA

import cdpr

pytestmark = pytest.mark.filterwarnings("ignore::cdpr.CdprWarning")

LINES = int(os.environ.get("CDPR_COMMAND_LINES", "400"))  # of the long test
CHUNKS = 8


@pytest.fixture(scope="session")
def inputs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of scenes, robots, meshes, paths, motions, proofs, tasks, experiments and runs."""
    folder = tmp_path_factory.mktemp("inputs")
    for name in SCENES:
        scene = cdpr.Scene.load(TESTDATA / f"scenes/{name}.toml")
        between = scene.start + 0.05 * (scene.goal - scene.start)  # so near the start that nothing is hit, but on "plank" and "turn"
        scene = scene.replace(stations={"dock": scene.start, "upper rack": scene.goal, "between": between})
        scene.save(folder / f"{name}.toml")
        scene.save(folder / f"{name}.json")
        ended = ["--budget-ms", "2000", "--max-samples", "3000"]
        run(folder, ["plan", f"{name}.toml", "-o", f"{name}-path.json", "--proof", f"{name}-proof.json", *ended])
        if json.loads((folder / f"{name}-path.json").read_text())["status"] != "solved":
            continue
        path = cdpr.load_path(folder / f"{name}-path.json")
        path.save(folder / f"{name}-path.csv")
        turns = [path.orientation] * len(path.waypoints) if path.orientations is None else path.orientations
        cdpr.Path(path.waypoints, path.cost, orientations=turns).save(folder / f"{name}-poses.csv")
        for kind in ("json", "csv"):
            made = run(folder, ["trajectory", f"{name}.toml", f"{name}-path.json", "-o", f"{name}-motion.{kind}", *LIMITS])
            assert made.returncode == 0, made.stderr
    # One that can be shortened.
    made = run(folder, ["plan", "hard1.toml", "--planner", "rrt", "--post", "none", "-o", "hard1-raw.csv"])
    assert made.returncode == 0, made.stderr
    shutil.copy(TESTDATA / "robots/cogiro.toml", folder / "robot.toml")
    for source in ("robots/paper.toml", "meshes/machine.stl", "meshes/platform.stl", "gazebo/caroca.yaml"):
        shutil.copy(TESTDATA / source, folder)
    shutil.copytree(TESTDATA / "caspr/CoGiRo", folder / "CoGiRo")
    robot = cdpr.Robot.load(folder / "robot.toml")
    header = ",".join(f"length:cable {k}" for k in range(8))
    rows = [",".join(map(str, row)) for row in robot.cable_lengths([[0, 0, 2], [0.01, 0, 2], [0.02, 0, 2.01]])]
    (folder / "encoders.csv").write_text("\n".join([header, *rows]) + "\n")
    for name in SCENES:
        scene = cdpr.Scene.load(folder / f"{name}.toml")
        start = scene.robot.cable_lengths(scene.start, orientation=scene.orientation)
        (folder / f"{name}-lengths.csv").write_text(",".join(map(str, start)) + "\n")
    (folder / "mesh.toml").write_text(
        'version = 1\nrobot = "paper.toml"\n[workspace]\nmin = [0, 0, 0]\nmax = [2, 2, 2]\n[[obstacles]]\nmesh = "machine.stl"\n'
        'units = "mm"\nscale = 0.2\n[query]\nstart = [0.3, 1.0, 1.3]\ngoal = [1.7, 1.0, 1.7]\n'
    )
    (folder / "trials.toml").write_text(
        'version = 1\nname = "trials"\ntrials = 4\n[[scenarios]]\nname = "a"\nscene = "hard1.toml"\n'
        '[[methods]]\nname = "RRT"\nplanner = "rrt"\n'
    )
    shutil.copy(TESTDATA / "tasks/tower.toml", folder)
    made = run(folder, ["task", "tower.toml", "-o", "tower-task"])
    assert made.returncode == 0, made.stderr
    for part in ("0..2", "2..4"):
        made = run(folder, ["batch", "trials.toml", "-o", f"run{part[0]}", "--trials", part])
        assert made.returncode == 0, made.stderr
    return folder


def tried(folder: Path, drawn: Draw) -> subprocess.CompletedProcess[str]:
    """Runs a line and checks everything that holds for every line."""
    before = contents(folder)
    try:
        return as_promised(folder, drawn, before)
    finally:
        for name in contents(folder):
            if name not in before:
                (folder / name).unlink()
        for made in drawn.outputs:
            shutil.rmtree(folder / made, ignore_errors=True)


def as_promised(folder: Path, drawn: Draw, before: dict[str, str]) -> subprocess.CompletedProcess[str]:
    done = run(folder, drawn.line)
    told = (" ".join(drawn.line), done.returncode, done.stdout[-2000:], done.stderr[-2000:])
    assert done.returncode in (0, 1, 2), told
    assert "panic" not in done.stderr and "bug in cdpr" not in done.stderr, told
    after = contents(folder)
    assert {name: after.get(name) for name in before} == before, told
    named = [Path(name) for name in [*drawn.outputs, *drawn.replaced, "run0/report.html", "run2/report.html"]]
    new = [Path(name) for name in after if name not in before]
    assert all(any(name == made or made in name.parents for made in named) for name in new), (told, new)
    streamed = any("-" in values for values in drawn.options.values()) or "-" in drawn.positional
    if done.returncode == 2:
        assert done.stderr and (streamed or not done.stdout), told
    elif drawn.options.get("--format") == ["json"] and not streamed:
        json.loads(done.stdout)
    if done.returncode < 2 and not streamed:
        agrees(folder, drawn, done)
    return done


def agrees(folder: Path, drawn: Draw, done: subprocess.CompletedProcess[str]) -> None:
    """Text, JSON and file say the same, and `check` accepts what was written."""
    told = (" ".join(drawn.line), done.returncode, done.stdout[-2000:], done.stderr[-2000:])
    options, printed, said = drawn.options, {}, re.sub(r"\x1b\[[\d;]*m", "", done.stdout)
    if options.get("--format") == ["json"]:
        printed = json.loads(done.stdout)
    written = {option: folder / options[option][0] for option in ("--output", "--trajectory", "--proof") if option in options}
    path = written.get("--output")
    saved = json.loads(path.read_text()) if path and path.suffix == ".json" and path.exists() else {}
    scene = drawn.positional[0] if drawn.positional else ""
    if drawn.command == "plan":
        status = printed.get("status") or ("solved" if re.search(r"^solved: ", said, re.MULTILINE) else "other")
        assert (status == "solved") == (done.returncode == 0), told
        assert not saved or (saved["status"] == "solved") == (status == "solved"), told
        check(folder, drawn, scene, written, printed or saved, done)
    if drawn.command == "task" and done.returncode == 0:
        limits = kept(options, "--tensions", *OF_MOTIONS)
        checked = run(folder, ["check", scene, f"{options['--output'][0]}/task.json", *kept(options, "--orientation"), *limits])
        assert checked.returncode == 0, (told, checked.stdout, checked.stderr)
    length = {"plan": r"^solved: ([\d.]+) m ", "post": r"^([\d.]+) m with ", "check": r"^(?:not )?valid: ([\d.]+) m,"}.get(drawn.command)
    text = re.search(length, said, re.MULTILINE) if length and not printed else None
    if text and saved.get("cost"):
        assert abs(float(text[1]) - saved["cost"]) <= 5.1e-5, told
    if printed and saved and drawn.command in ("plan", "post"):
        assert printed["cost"] == saved["cost"] and printed["waypoints"] == saved["waypoints"], told
    if drawn.command == "check" and "valid" in printed:
        assert printed["valid"] == (done.returncode == 0), told
    if drawn.command == "trajectory" and saved:
        timed = re.search(r"^timed: ([\d.]+) s along ([\d.]+) m", said, re.MULTILINE)
        found = (printed["duration"], printed["length"]) if printed else (float(timed[1]), float(timed[2]))
        assert abs(found[0] - saved["duration"]) <= 5.1e-5 and abs(found[1] - saved["length"]) <= 5.1e-5, told


def check(folder: Path, drawn: Draw, scene: str, written: dict[str, Path], result: dict, done: subprocess.CompletedProcess[str]) -> None:
    """`check` with the same options accepts what `plan` wrote."""
    options = drawn.options
    turned = kept(options, "--orientation")
    if not turned and (name := result.get("orientation_name")) and drawn.scene == "plank":
        turned = ["--orientation", name]
    for option, file in written.items():
        if not file.exists() or file.suffix == ".yaml" or (option != "--proof" and done.returncode == 1):
            continue
        if option != "--proof" and {"--start-orientation", "--goal-orientation"} & set(options):
            turned = []  # `check` has no such options
        own_ends = option == "--proof" and {"--start-lengths", "--replan"} & set(options)
        own = {
            "--output": kept(options, "--engine", "--interference"),
            "--proof": ends_of(file) if own_ends else kept(options, "--start", "--goal"),
            "--trajectory": kept(options, "--engine", "--interference", *OF_MOTIONS),
        }[option]
        if drawn.scene == "plank" and not turned:
            continue  # only the path file would say which orientation was chosen
        checked = run(folder, ["check", scene, file.name, *turned, *own])
        assert checked.returncode == 0, (" ".join(drawn.line), option, checked.args, checked.stdout, checked.stderr)


def ends_of(proof: Path) -> list[str]:
    """Options that ask about the start and goal of a proof."""
    said = json.loads(proof.read_text())
    return [str(word) for end in ("start", "goal") for word in (f"--{end}", *said[end])]


@pytest.fixture
def folder(inputs: Path, tmp_path: Path) -> Path:
    return shutil.copytree(inputs, tmp_path / "copy")


@pytest.mark.parametrize("width", ["60", "80", "100", "200"])
def test_options_are_read_from_help_of_any_width(width: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", width)
    assert {command: options_of(command) for command in OPTIONS} == OPTIONS
    assert OPTIONS["plan"]["--budget-ms"][0]


def test_every_scene_can_be_read(folder: Path) -> None:
    for scene in [*(f"{name}.{kind}" for name in SCENES for kind in ("toml", "json")), "mesh.toml"]:
        told = run(folder, ["info", scene])
        assert told.returncode == 0, (scene, told.stderr)


@pytest.mark.parametrize("command", OPTIONS)
def test_every_option_of_every_command_is_drawn(command: str, folder: Path) -> None:
    for option in OPTIONS[command]:
        drawn = Draw(f"{command} {option}", folder, command, option)
        assert option in drawn.line
        tried(folder, drawn)


@pytest.mark.long
@pytest.mark.timeout(0)
@pytest.mark.parametrize("chunk", range(CHUNKS))
def test_random_lines(chunk: int, folder: Path) -> None:
    ended, wrong = random_lines(folder, range(chunk, LINES, CHUNKS))
    assert not wrong
    assert sum(count for (_, status), count in ended.items() if status == 0) >= LINES // CHUNKS // 4, ended
    assert ended["plan", 0], ended


def random_lines(folder: Path, numbers: Iterable[int]) -> tuple[Counter[tuple[str, int]], list[str]]:
    """How often the lines of each command ended with each status, and what is wrong with them."""
    # Poses from lengths have few options, and lines of their own.
    weights = {command: 1 + len({*options} - {"--start-lengths"}) for command, options in OPTIONS.items() if command != "pose"}
    ended, wrong = Counter[tuple[str, int]](), []
    for k in numbers:
        command = random.Random(k).choices(list(weights), list(weights.values()))[0]
        try:
            ended[command, tried(folder, Draw(f"line {k}", folder, command)).returncode] += 1
        except (AssertionError, subprocess.TimeoutExpired) as problem:
            wrong.append(f"line {k}: {problem}")
    return ended, wrong


# Options that change no answer, by design or with nearly all inputs: why, and of which command, if not of all.
SAME_ANSWERS = {
    "--quiet": "says less, if there is more to say than the result",
    "--verbose": "says more, if there is more to say",
    "--color": "colours the verdict, if there is one",
    "--strict": "refuses the path of another scene, which is no answer",
    "--engine": "both engines give the same answers",
    "--interference": "differs only where cables that cross sweep the same region",
    "--orientation": "the only one of most scenes",
    "batch --threads": "trials are the same on any number of threads",
    "tour --threads": "tours are the same on any number of threads",
    "task --effort": "needs tensions, which the robot of the task does not have",
    "task --threads": "tasks are the same on any number of threads",
    "batch --resume": "a new run has nothing to resume",
    "check --start": "a proof is of its own start and goal",
    "check --goal": "a proof is of its own start and goal",
    "check --blend": "the motions stay near their paths, or do not say which they follow",
    "export --control": "lengths need the stiffness of the cables, which none of the scenes has",
    "import --bodies": "the file that is found without it",
    "import --cable-set": "the only one of this model",
    "import --platform": "a mesh that this robot's cables do not fit",
    "new --force": "replaces a file, which is no input here",
    "trajectory --effort": "needs tensions, which few of the robots have",
    "trajectory --joints": "needs a ROS 2 message, which few lines write",
    "trajectory --motion-clearance": "takes the place of a clearance, which none of the scenes has",
    "schema --format": "a schema is JSON",
}


def answer(folder: Path, line: list[str]) -> tuple[int, str, str, dict[str, bytes]]:
    """Everything that a line gives, without the times that it took."""

    def timeless(text: str) -> str:
        return re.sub(r'("(?:\w+_)?seconds": )[^,\s]+|[\d.]+ ms\b', r"\1", text)

    before = contents(folder)
    done = run(folder, line)
    new = [name for name, found in contents(folder).items() if before.get(name) != found]
    written = {name: timeless((folder / name).read_bytes().decode("latin-1")).encode() for name in new}
    for name in new:
        (folder / name).unlink()
    return done.returncode, timeless(done.stdout), timeless(done.stderr), written


@pytest.mark.long
@pytest.mark.timeout(0)
@pytest.mark.parametrize("command", [command for command in OPTIONS if command != "plan"])  # whose searches may not end
def test_every_option_has_an_effect(command: str, folder: Path) -> None:
    idle = []
    for option in OPTIONS[command]:
        excused = {option, f"{command} {option}"} & set(SAME_ANSWERS)
        if not excused and not any(has_effect(folder, command, option, k) for k in range(60)):
            idle.append(option)
    assert not idle


def has_effect(folder: Path, command: str, option: str, k: int) -> bool | None:
    """Whether an answer is another one without the option; None if the line is refused or its answer depends on the clock."""
    drawn = Draw(f"effect {command} {option} {k}", folder, command, option)
    if drawn.replaced or any("-" in values for values in drawn.options.values()):
        return None
    words = {name: [name, *values] for name, values in drawn.options.items()}
    line = [command, *drawn.positional]
    found = answer(folder, [*line, *(word for part in words.values() for word in part)])
    if found[0] == 2:
        return None
    less = answer(folder, [*line, *(word for name, part in words.items() if name != option for word in part)])
    return found != less
