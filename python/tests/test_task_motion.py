"""Timed motions of tasks: weights and rates worked out from the samples, files that are damaged, and what is refused."""

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import TESTDATA, program

import cdpr

TOWER = TESTDATA / "tasks/tower.toml"
LIMITS = {"speed": 1.0, "acceleration": 2.0}
OPTIONS = ["--speed", "1", "--acceleration", "2"]
GRAVITY = 9.81


def run(folder: Path, *line: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([program(), *line], cwd=folder, capture_output=True, text=True)


def crane(mass: float) -> cdpr.Scene:
    """Eight cables that hold the platform in every direction, and a load that hangs below it."""
    load = {"body": {"box": [0.3, 0.3, 0.3], "position": [0, 0, -0.4]}, "mass": mass, "at": [1.0, 1.0, 2.0]}
    rows = [{"go": [-1.0, 1.0, 2.0]}, {"pick": "load"}, {"go": [-1.0, -1.0, 2.5]}, {"place": "load"}, {"go": [0.0, 1.0, 2.0]}]
    scene = cdpr.example("cogiro").without("column")
    return scene.replace(payloads={"load": load}, task=rows, start=None, goal=None, wrench=None)


def pull(scene: cdpr.Scene, motion: cdpr.Trajectory) -> np.ndarray:
    """The sum of the vertical forces of the cables at each sample, N."""
    assert motion.tensions is not None
    lines = scene.robot.outlets - (motion.positions[:, None] + scene.robot.attachments)
    return (motion.tensions * (lines / np.linalg.norm(lines, axis=2, keepdims=True))[..., 2]).sum(axis=1)


def test_tensions_carry_what_is_carried() -> None:
    scene = crane(80.0)
    task = cdpr.task(scene, motion=LIMITS, rate=50)
    own = scene.robot.mass
    assert own is not None and task.motion is not None
    for leg, carried in zip(task.legs, (0.0, 80.0, 0.0), strict=True):
        assert leg.motion is not None and leg.starts is not None and leg.ends is not None
        assert leg.ends - leg.starts == pytest.approx(leg.motion.duration)
        needed = (own + carried) * (GRAVITY + leg.motion.accelerations[:, 2])
        np.testing.assert_allclose(pull(scene, leg.motion), needed, rtol=1e-6)
        # The whole motion contains the leg's samples; the first of them is the last one of the leg before.
        first = round(leg.starts * 50)
        part = slice(first + 1, first + len(leg.motion.times))
        for name in ("positions", "velocities", "accelerations", "orientations", "cable_lengths", "cable_speeds", "tensions"):
            np.testing.assert_array_equal(getattr(task.motion, name)[part], getattr(leg.motion, name)[1:])
        np.testing.assert_allclose(task.motion.times[part], leg.starts + leg.motion.times[1:], atol=1e-12)
    assert task.legs[-1].ends == pytest.approx(task.motion.duration)
    assert [(kind, name) for _, kind, name in task.actions] == [("pick", "load"), ("place", "load")]
    assert [time for time, _, _ in task.actions] == [task.legs[1].starts, task.legs[2].starts]
    with pytest.raises(cdpr.InputError):
        task.motion.at(0.0)


def test_rates_of_the_whole_motion_keep_the_limits() -> None:
    task = cdpr.task(cdpr.Scene.load(TOWER), motion={**LIMITS, "blend": 0.05})
    motion = task.motion
    assert motion is not None and np.allclose(np.diff(motion.times), 0.01)
    steps = np.diff(motion.positions, axis=0) / 0.01
    assert np.linalg.norm(steps, axis=1).max() <= 1.0 + 1e-9
    assert np.linalg.norm(np.diff(steps, axis=0), axis=1).max() / 0.01 <= 2.0 + 1e-6
    for time, _, name in task.actions:
        here = motion.positions[round(time * 100)]
        at = task.legs[[leg.starts for leg in task.legs].index(time)]
        assert np.allclose(here, at.waypoints[0], atol=1e-9) and name in cdpr.Scene.load(TOWER).payloads


def test_a_leg_that_cannot_be_timed_is_named_and_the_others_are_kept(tmp_path: Path) -> None:
    # A load that the cables do not hold.
    task = cdpr.task(crane(5000.0), motion=LIMITS)
    assert task.status == "solved" and task.motion is None and task.actions == ()
    assert [leg.motion is not None for leg in task.legs] == [True, False, True]
    assert task.legs[1].reason is not None and "waypoints" in task.legs[1].reason and task.legs[0].starts is None
    task.save(tmp_path / "task")
    assert not (tmp_path / "task/leg-2-motion.json").exists() and (tmp_path / "task/leg-3-motion.json").exists()
    # Motions of an earlier task must not be taken for those of the last one.
    cdpr.task(cdpr.Scene.load(TOWER), motion=LIMITS).save(tmp_path / "task")
    task.save(tmp_path / "task")
    assert not [name for name in ("motion.json", "leg-2-motion.json", "leg-4.json") if (tmp_path / "task" / name).exists()]
    crane(5000.0).save(tmp_path / "crane.json")
    checked = run(tmp_path, "check", "crane.json", "task/task.json")
    assert checked.returncode == 1 and "1 leg without a motion" in checked.stdout and "cannot be timed: waypoints" in checked.stdout
    made = run(tmp_path, "task", "crane.json", "-o", "again", "--trajectory", "motion.json", *OPTIONS)
    assert made.returncode == 1 and "no motion: " in made.stdout and "but it cannot be timed: waypoints" in made.stdout
    assert json.loads((tmp_path / "again/task.json").read_text()) == json.loads((tmp_path / "task/task.json").read_text())


def test_saved_motions_are_what_the_command_writes(tmp_path: Path) -> None:
    task = cdpr.task(cdpr.Scene.load(TOWER), motion=LIMITS)
    task.save(tmp_path / "python")
    assert run(tmp_path, "task", str(TOWER), "-o", "command", "--trajectory", "motion.json", *OPTIONS).returncode == 0
    for name in ("task.json", "motion.json", *(f"leg-{k}-motion.json" for k in range(1, 8))):
        one, other = (json.loads((tmp_path / folder / name).read_text()) for folder in ("python", "command"))
        assert one == other, name
    assert cdpr.load_trajectory(tmp_path / "python/motion.json") == task.motion
    assert task == cdpr.task(cdpr.Scene.load(TOWER), motion=LIMITS, threads=1)
    checked = run(tmp_path, "check", str(TOWER), "python/task.json", "--strict", *OPTIONS)
    assert checked.returncode == 0 and " s\n" in checked.stdout, checked.stderr


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("made")
    for name in ("csv", "yaml", "json"):
        assert run(folder, "task", str(TOWER), "-o", name, "--trajectory", f"motion.{name}", *OPTIONS).returncode == 0
    return folder


def checked(made: Path, folder: Path, name: str, damage: Any) -> subprocess.CompletedProcess[str]:
    shutil.copytree(made / name, folder / name)
    damage(folder / name)
    return run(folder, "check", str(TOWER), f"{name}/task.json")


def edited(file: str, change: Any) -> Any:
    def damage(folder: Path) -> None:
        known = json.loads((folder / file).read_text())
        change(known)
        (folder / file).write_text(json.dumps(known))

    return damage


def lines_of(file: str, change: Any) -> Any:
    def damage(folder: Path) -> None:
        lines = (folder / file).read_text().splitlines(keepends=True)
        change(lines)
        (folder / file).write_text("".join(lines))

    return damage


def swapped(folder: Path) -> None:
    shutil.copy(folder / "leg-1-motion.json", folder / "leg-2-motion.json")


@pytest.mark.parametrize(
    ("name", "damage", "said"),
    [
        ("json", lambda folder: None, ""),
        ("json", edited("task.json", lambda task: task["legs"][2]["motion"].update(start=1.27)), "legs[2].motion: found"),
        ("json", edited("task.json", lambda task: task["legs"][2]["motion"].update(duration=1.0)), "legs[2].motion: found"),
        ("json", edited("task.json", lambda task: task["motion"]["actions"][0].update(time=3.44)), "motion: found"),
        ("json", edited("task.json", lambda task: task["motion"]["actions"].pop()), "motion: found"),
        ("json", edited("task.json", lambda task: task.pop("motion")), "motion: found none, expected one"),
        ("json", edited("task.json", lambda task: task["legs"][2]["motion"].update(file="leg-9.json")), "cannot be read"),
        ("json", edited("task.json", lambda task: task["legs"][2]["motion"].update(speed=1)), "speed"),
        ("json", edited("task.json", lambda task: task["legs"][2].pop("motion")), "motion: found one, expected none, since a leg has none"),
        ("json", swapped, "legs[1].motion.file: found leg-2-motion.json, whose motion follows another path"),
        ("json", edited("motion.json", lambda motion: motion["positions"][300].__setitem__(1, 1.0)), "positions[300][1]: found"),
        ("json", edited("motion.json", lambda motion: motion["corners"].pop()), "corners: found"),
        ("csv", lambda folder: None, ""),
        ("csv", lines_of("motion.csv", lambda lines: lines.pop(200)), "line 201: found"),
        ("csv", lines_of("motion.csv", lambda lines: lines.__delitem__(slice(129, 345))), "line 130: found"),
        ("csv", lines_of("motion.csv", lambda lines: lines.__delitem__(slice(1990, None))), "found no more lines"),
        ("yaml", lambda folder: None, ""),
        ("yaml", lines_of("motion.yaml", lambda lines: lines.pop(40)), "line 41: found"),
    ],
)
def test_what_is_not_the_motion_of_the_legs_is_found(made: Path, tmp_path: Path, name: str, damage: Any, said: str) -> None:
    found = checked(made, tmp_path, name, damage)
    assert found.returncode == (2 if said else 0), (found.stdout, found.stderr)
    assert said in found.stderr


def test_a_motion_that_does_not_hold_in_its_leg_is_a_fault(made: Path, tmp_path: Path) -> None:
    slow = run(made, "check", str(TOWER), "json/task.json", "--speed", "0.5", "--format", "json")
    report = json.loads(slow.stdout)
    assert slow.returncode == 1 and not report["valid"] and report["duration"] > 20
    assert all(leg["motion"]["faults"][0]["message"].startswith("speed ") for leg in report["legs"])
    told = run(made, "check", str(TOWER), "json/task.json", "--speed", "0.5").stdout
    assert "faults of motions" in told and "leg 2, tower to corner, carrying tower,  at " in told
    # Without velocities that fit, the samples of a leg are a fault of that leg.
    shutil.copytree(made / "json", tmp_path / "json")
    edited("leg-4-motion.json", lambda motion: motion["velocities"][100].__setitem__(0, 5.0))(tmp_path / "json")
    edited("motion.json", lambda motion: motion["velocities"][672].__setitem__(0, 5.0))(tmp_path / "json")
    wrong = run(tmp_path, "check", str(TOWER), "json/task.json")
    assert wrong.returncode == 1 and "leg 4, crate to table, carrying crate,  at 1.000 s" in wrong.stdout, wrong.stderr


def test_what_no_timing_can_be_is_refused(tmp_path: Path) -> None:
    scene = cdpr.Scene.load(TOWER)
    for options, said in (
        ({"motion": {}}, "acceleration: found no limit"),
        ({"motion": {"speed": -1}}, "motion.speed: found -1"),
        ({"motion": {"spede": 1}}, "spede"),
        ({"motion": 3}, "motion: found 3"),
        ({"rate": 100}, "rate: found without motion"),
        ({"motion": LIMITS, "rate": -1.0}, "rate: found -1"),
    ):
        with pytest.raises(cdpr.InputError, match=said):
            cdpr.task(scene, **options)  # type: ignore[arg-type]
    for line, said in (
        (["--trajectory", "motion.txt", *OPTIONS], "motion.txt: found the extension .txt, expected .json, .csv or .yaml"),
        (["--trajectory", "task.json", *OPTIONS], "task.json: is not the name of a file of its own"),
        (["--trajectory", "leg-1.json", *OPTIONS], "leg-1.json: is not the name"),
        (["--trajectory", "../motion.json", *OPTIONS], "../motion.json: is not the name"),
        (["--trajectory", "motion.json"], "acceleration: found no limit"),
        (["--trajectory", "motion.yaml", "--effort", *OPTIONS], "cannot hold tensions as effort"),
        (["--trajectory", "motion.csv", "--effort", *OPTIONS], "cannot hold effort"),
        (["--effort"], "--effort: found without"),
        (OPTIONS, "--speed: found without --trajectory"),
    ):
        found = run(tmp_path, "task", str(TOWER), "-o", "task", *line)
        assert (found.returncode, found.stdout) == (2, "") and said in found.stderr, (line, found.stderr)
    assert not (tmp_path / "task").exists()
