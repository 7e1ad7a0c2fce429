"""Choices of tensions: against SciPy, along paths and motions, in files, tables and on the command line."""

import json
import subprocess

import numpy as np
import pytest
from conftest import program
from scipy.optimize import LinearConstraint, minimize

import cdpr

POWERS = {"middle": 2, "least": 2, "p4": 4, "p8": 8}


@pytest.mark.parametrize("name", ["cogiro", "ipanema2", "caroca"])
def test_each_choice_is_least_by_scipy(name):
    scene = cdpr.example(name)
    robot, rng = scene.robot, np.random.default_rng(3)
    low, high = robot.tensions.T
    (lowest, highest), orientation = scene.workspace, scene.orientation
    positions = rng.uniform(lowest, highest, (200, 3))
    held = np.isfinite(cdpr.tension_distribution(robot, positions, orientation=orientation)).all(axis=1)
    positions = positions[held][:6]
    assert len(positions) == 6
    matrices = cdpr.wrench_matrix(robot, positions, orientation=orientation)
    for choice, power in POWERS.items():
        about, unit = (0 * low if choice == "least" else (low + high) / 2), high.max()
        found = cdpr.tension_distribution(robot, positions, tensions=choice, orientation=orientation)
        nearest = cdpr.tension_distribution(robot, positions, orientation=orientation)
        for matrix, t, start in zip(matrices, found, nearest, strict=True):
            assert (t >= low).all() and (t <= high).all()
            assert np.abs(matrix @ (t - start)).max() < 1e-9 * unit
            free = np.linalg.svd(matrix)[2][6:]  # rows span what keeps the balance

            def sum_of(y):
                return (np.abs((start + y @ free - about) / unit) ** power).sum()  # noqa: B023

            bounds = LinearConstraint(free.T, (low - start) / unit, (high - start) / unit)
            best = minimize(lambda y: sum_of(unit * y), np.zeros(len(free)), constraints=bounds, method="trust-constr", tol=1e-10)
            own = (np.abs((t - about) / unit) ** power).sum()
            assert own <= best.fun * (1 + 1e-6) + 1e-12


def test_paths_and_motions_hold_the_chosen_tensions(tmp_path):
    example = cdpr.example("cogiro")
    scene = example.replace(obstacles=None, touch=None, ignore=None, wrench=None)
    path = [scene.start, scene.start + [0.5, 0.2, 0.3]]
    middle = cdpr.trajectory(scene, path, speed=1.0, acceleration=2.0)
    assert middle.tension_distribution == "middle"
    chosen = scene.replace(robot=scene.robot.replace(tension_distribution="least"))
    for motion in (cdpr.trajectory(scene, path, speed=1.0, acceleration=2.0, tensions="least"), cdpr.trajectory(chosen, path, speed=1.0, acceleration=2.0)):
        assert motion.tension_distribution == "least" and motion.duration == middle.duration
        assert (np.linalg.norm(motion.tensions, axis=1) <= np.linalg.norm(middle.tensions, axis=1) + 1e-9).all()
        between = motion.at(0.123456).tensions
        assert np.linalg.norm(between) < np.linalg.norm(middle.at(0.123456).tensions)
        motion.save(tmp_path / "motion.json")
        loaded = cdpr.load_trajectory(tmp_path / "motion.json", scene)  # the choice is no part of the scene's identity
        assert loaded == motion and (loaded.at(0.123456).tensions == between).all()
    least, own = cdpr.tensions_along(scene, path, tensions="least"), cdpr.tensions_along(chosen, path)
    assert (least.tensions == own.tensions).all()
    assert (least.tensions != cdpr.tensions_along(scene, path).tensions).any()
    at = cdpr.wrench_at(scene, scene.start, tensions="p4")
    assert at.tension_distribution == "p4" and at.feasible == cdpr.wrench_at(scene, scene.start).feasible
    assert np.abs(at.tensions - cdpr.tension_distribution(scene.robot, scene.start, tensions="p4", orientation=scene.orientation)).max() < 1e-9


def test_the_closed_form_is_refused_where_it_exceeds_a_limit():
    scene = cdpr.example("cogiro").replace(obstacles=None, touch=None, ignore=None, wrench=None)
    at, other = (cdpr.wrench_at(scene, [5, 2, 3], tensions=choice) for choice in ("closed-form", "middle"))
    assert at.balanced and np.isnan(at.tensions).all() and np.isfinite(other.tensions).all()
    assert np.isnan(cdpr.tension_distribution(scene.robot, [5, 2, 3], tensions="closed-form")).all()
    with pytest.raises(cdpr.InputError, match="tension_distribution: found closed-form, which exceeds a tension limit"):
        cdpr.trajectory(scene, [[4, 2, 3], [5, 2, 3]], speed=1.0, acceleration=1.0, tensions="closed-form")
    with pytest.raises(cdpr.InputError, match="expected one of middle, least, p4, p8, closed-form"):
        cdpr.wrench_at(scene, [0, 0, 2], tensions="p5")
    with pytest.raises(cdpr.InputError, match="tensions: found a reference as well"):
        cdpr.tension_distribution(scene.robot, [0, 0, 2], tensions="p4", reference=np.full(8, 100.0))


def test_choices_on_the_command_line(tmp_path):
    scene = cdpr.example("cogiro").replace(obstacles=None, touch=None, ignore=None, wrench=None)
    scene.save(tmp_path / "scene.toml")
    (tmp_path / "path.csv").write_text("x,y,z\n0,0,2\n0.5,0.2,2.3\n")

    def cdpr_(*arguments, text=None, expected=0):
        done = subprocess.run([program(), *arguments], cwd=tmp_path, capture_output=True, text=True, input=text, check=False)
        assert done.returncode == expected, done.stderr
        return done

    limits = ("--speed", "1", "--acceleration", "2", "-q")
    for choice in ("least", "p8"):
        cdpr_("trajectory", "scene.toml", "path.csv", "-o", "motion.json", "--tensions", choice, *limits)
        assert json.loads((tmp_path / "motion.json").read_text())["tension_distribution"] == choice
        cdpr_("check", "scene.toml", "motion.json")
        wrong = json.loads(cdpr_("check", "scene.toml", "motion.json", "--tensions", "p4", "--format", "json", expected=1).stdout)
        assert {fault["kind"] for fault in wrong["faults"]} == {"tension_distribution"}
        rows = json.loads(cdpr_("wrench", "scene.toml", "--along", "path.csv", "--tensions", choice, "--format", "json").stdout)["rows"]
        own = cdpr.tensions_along(scene, [[0, 0, 2], [0.5, 0.2, 2.3]], tensions=choice)
        assert np.abs(own.tensions - [row["tensions"] for row in rows]).max() < 1e-9
    # A table does not name its choice: that of the robot counts.
    cdpr_("trajectory", "scene.toml", "path.csv", "-o", "motion.csv", *limits)
    least = scene.replace(robot=scene.robot.replace(tension_distribution="least"))
    least.save(tmp_path / "least.toml")
    cdpr_("check", "scene.toml", "motion.csv")
    assert "tension by `least`" in cdpr_("check", "least.toml", "motion.csv", expected=1).stdout
    cdpr_("check", "least.toml", "motion.csv", "--tensions", "middle")
    report = cdpr_("wrench", "-", "--at", "0", "0", "2", "-q", text=(tmp_path / "least.toml").read_text()).stdout
    assert "the smallest tensions:" in report
    refused = cdpr_("trajectory", "scene.toml", "-", "--tensions", "closed-form", *limits, text="x,y,z\n4,2,3\n5,2,3\n", expected=2)
    assert "--tensions: found closed-form, which exceeds a tension limit" in refused.stderr


def test_turning_platforms_and_several_load_cases():
    scene = cdpr.example("ipanema2").replace(obstacles=None, touch=None, ignore=None, wrench=None, turning={})
    at, turned = scene.start, [np.cos(0.1), 0, 0, np.sin(0.1)]
    ends = [[1.0, 0, 0, 0], turned]
    path = cdpr.Path([at, at], 0.0, orientations=ends)
    for choice in ("least", "p4"):
        along = cdpr.tensions_along(scene, path, tensions=choice)
        expected = cdpr.tension_distribution(scene.robot, at, orientation=turned, tensions=choice)
        assert np.abs(along.tensions[-1] - expected).max() < 1e-6
    found = [
        cdpr.trajectory(scene, [at, at], ends, turn_speed=0.5, turn_acceleration=1.0, tensions=choice) for choice in ("middle", "least")
    ]
    norms = [np.linalg.norm(motion.tensions, axis=1) for motion in found]
    assert found[0].duration == found[1].duration and (norms[1] < norms[0]).all()
    # Tables of tensions are for the first of several loads; reports for the least favourable one.
    loads = [[0.0, 0, 0, 0, 0, 0], [0.0, 0, -20.0, 0, 0, 0]]
    with pytest.warns(cdpr.CdprWarning, match="first of `loads`"):
        loaded = scene.replace(wrench={"loads": loads})
    rows = cdpr.tensions_along(loaded, [at, at + [0.1, 0, 0]], tensions="p8").tensions
    assert np.abs(rows[0] - cdpr.tension_distribution(scene.robot, at, tensions="p8", orientation=scene.orientation)).max() < 1e-6
    report = cdpr.wrench_at(loaded, at, tensions="p8")
    load = loads[int(report.load_case is not None and "2" in report.load_case)]
    assert np.abs(report.tensions - cdpr.tension_distribution(scene.robot, at, load=load, tensions="p8", orientation=scene.orientation)).max() < 1e-6
