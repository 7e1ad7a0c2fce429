"""Timed motions: checked against NumPy, as files and tables, and refused with a message."""

import copy
import dataclasses
import json
import pickle
import warnings

import matplotlib

matplotlib.use("Agg")
import numpy as np
import pandas
import pytest
from conftest import TESTDATA
from matplotlib import pyplot
from test_planning import AT_ONCE, interrupted_after

import cdpr
import cdpr.figures

PLATFORM = {"speed": 1.0, "acceleration": 2.0}
BLENDED = PLATFORM | {"blend": 0.03}


def scene_of(name):
    return cdpr.Scene.load(TESTDATA / f"scenes/{name}.toml")


@pytest.fixture(scope="module")
def cases():
    """Scene and motion by name: platform limits, cable limits, jerk, tensions."""
    hard1, hard3, cogiro = map(scene_of, ("hard1", "hard3", "cogiro"))
    return {
        "platform": (hard1, cdpr.trajectory(hard1, cdpr.plan(hard1), **BLENDED)),
        "stops": (hard3, cdpr.trajectory(hard3, cdpr.plan(hard3), **PLATFORM, blend=0)),
        "cables": (hard3, cdpr.trajectory(hard3, cdpr.plan(hard3), cable_speed=0.4, cable_acceleration=1.0, blend=0.02)),
        "jerk": (hard1, cdpr.trajectory(hard1, cdpr.plan(hard1), **BLENDED, jerk=20.0)),
        "tensions": (cogiro, cdpr.trajectory(cogiro, cdpr.plan(cogiro), speed=2.0, acceleration=4.0, wrench_margin=20.0)),
    }


CASES = ["platform", "stops", "cables", "jerk", "tensions"]


@pytest.fixture(params=CASES)
def case(request, cases):
    return cases[request.param]


def rotation(quaternion):
    w, x, y, z = quaternion
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip


def test_a_straight_line_takes_the_time_of_a_trapezoid(empty):
    motion = cdpr.trajectory(empty, [[0.5, 1, 1], [1.5, 1, 1]], **PLATFORM)
    assert motion.duration == pytest.approx(1.5, rel=1e-4) and motion.length == pytest.approx(1.0)
    speed = np.linalg.norm(motion.velocities, axis=1)
    trapezoid = np.minimum(1.0, 2 * np.minimum(motion.times, motion.duration - motion.times))
    assert np.abs(speed - trapezoid).max() < 1e-3
    assert motion.corners == () and [entry.limit for entry in motion.limiting] == ["acceleration", "speed", "acceleration"]
    assert motion.limits == PLATFORM | {"blend": 0.0}


def test_it_starts_and_ends_at_rest_at_the_ends_of_the_path(case):
    _, motion = case
    assert motion.positions[0] == pytest.approx(motion.waypoints[0], abs=1e-9)
    assert motion.positions[-1] == pytest.approx(motion.waypoints[-1], abs=1e-9)
    assert np.abs(motion.velocities[0]).max() < 1e-6 and np.abs(motion.cable_speeds[0]).max() < 1e-6
    for rows in (motion.velocities, motion.accelerations, motion.cable_speeds, motion.cable_accelerations):
        assert (rows[-1] == 0).all() and not np.signbit(rows[-1]).any()
    assert (motion.times == np.arange(len(motion.times)) / motion.rate).all()
    assert motion.duration <= motion.times[-1] < motion.duration + 1 / motion.rate


def test_velocities_and_accelerations_are_derivatives_of_positions(case):
    _, motion = case
    times = np.random.default_rng(0).uniform(0.01, motion.duration - 0.01, 2000)
    step = 1e-5
    before, now, after = motion.at(times - step), motion.at(times), motion.at(times + step)
    velocity = (after.position - before.position) / (2 * step)
    acceleration = (after.velocity - before.velocity) / (2 * step)
    assert np.abs(velocity - now.velocity).max() < 1e-3  # a jump of the acceleration within the step
    smooth = np.abs(after.acceleration - before.acceleration).max(axis=1) < 1e-2
    assert smooth.mean() > 0.8 and np.abs(velocity - now.velocity)[smooth].max() < 1e-7
    assert np.abs(acceleration - now.acceleration)[smooth].max() < 1e-2
    rates = (after.cable_lengths - before.cable_lengths) / (2 * step)
    assert np.abs(rates - now.cable_speeds)[smooth].max() < 1e-7
    rates = (after.cable_speeds - before.cable_speeds) / (2 * step)
    assert np.abs(rates - now.cable_accelerations)[smooth].max() < 1e-2


def test_cable_lengths_are_those_of_the_robot(case):
    scene, motion = case
    lengths = scene.robot.cable_lengths(motion.positions, orientation=motion.orientation)
    assert np.abs(lengths - motion.cable_lengths).max() < 1e-12
    assert motion.cables == scene.robot.cable_names
    lines = motion.positions[:, None] + scene.robot.attachments @ rotation(motion.orientation).T - scene.robot.outlets
    rates = np.einsum("nmk,nk->nm", lines, motion.velocities) / np.linalg.norm(lines, axis=2)
    assert np.abs(rates - motion.cable_speeds).max() < 1e-12


def test_every_limit_is_kept_at_every_instant(case):
    _, motion = case
    state = motion.at(np.linspace(0, motion.duration, 20_001))
    used = {
        "speed": np.linalg.norm(state.velocity, axis=1),
        "acceleration": np.linalg.norm(state.acceleration, axis=1),
        "cable_speed": np.abs(state.cable_speeds),
    }
    for key, values in used.items():
        if key in motion.limits:
            assert values.max() <= motion.limits[key] * (1 + 1e-9), key
    steps = np.diff(state.time)[:, None]
    if "jerk" in motion.limits:
        jerks = np.linalg.norm(np.diff(state.acceleration, axis=0), axis=1) / steps[:, 0]
        assert jerks.max() <= motion.limits["jerk"] * (1 + 1e-6)
    if "cable_acceleration" in motion.limits:
        rates = np.abs(np.diff(state.cable_speeds, axis=0) / steps)
        assert rates.max() <= motion.limits["cable_acceleration"] * (1 + 1e-6)
    if motion.tension_limits is not None:
        low, high = motion.tension_limits.T
        assert (state.tensions >= low - 1e-9).all() and (state.tensions <= high + 1e-9).all()


def test_tensions_balance_weight_and_inertia(cases):
    scene, motion = cases["tensions"]
    assert motion.note is None and motion.tensions.shape == motion.cable_lengths.shape
    assert (motion.tension_limits == scene.robot.tensions).all()
    matrices = cdpr.wrench_matrix(scene.robot, motion.positions, orientation=motion.orientation)
    pulled = np.einsum("nkm,nm->nk", matrices, motion.tensions)
    force = scene.robot.mass * (motion.accelerations - scene.gravity)
    center = rotation(motion.orientation) @ scene.robot.center_of_mass
    load = np.array(scene.wrench.get("load", [0.0] * 6))
    needed = np.hstack([force, np.cross(center, force)]) - load
    assert np.abs(pulled - needed).max() < 1e-5 * np.abs(needed).max()
    margins = cdpr.capacity_margin(scene.robot, motion.positions, orientation=motion.orientation)
    assert margins.min() > 20.0


def test_without_tension_limits_it_says_why(cases):
    _, motion = cases["platform"]
    assert motion.tensions is None and motion.tension_limits is None and motion.at(0.1).tensions is None
    assert motion.note.startswith("tensions are not limited: rank 5 of 6, underconstrained: no tensions resist turning")


def test_the_state_at_a_time_is_that_of_the_sample(case):
    _, motion = case
    state = motion.at(motion.times)
    columns = {
        "position": motion.positions, "velocity": motion.velocities, "acceleration": motion.accelerations,
        "cable_lengths": motion.cable_lengths, "cable_speeds": motion.cable_speeds, "tensions": motion.tensions,
        "cable_accelerations": motion.cable_accelerations,
    }  # fmt: skip
    for name, rows in columns.items():
        found = getattr(state, name)
        assert (found is None) == (rows is None) and (rows is None or (found == rows).all()), name
    one = motion.at(motion.times[7])
    assert one.position.shape == (3,) and one.cable_speeds.shape == (8,) and isinstance(one.time, float)
    assert (one.velocity == motion.velocities[7]).all()
    grid = motion.at(motion.times[:6].reshape(2, 3))
    assert grid.position.shape == (2, 3, 3) and grid.cable_lengths.shape == (2, 3, 8) and grid.time.shape == (2, 3)
    none = motion.at([])
    assert none.position.shape == (0, 3) and none.cable_lengths.shape == (0, 8)
    assert motion.at(-1.0).position == pytest.approx(motion.waypoints[0])
    assert (motion.at(motion.duration + 5).position == motion.positions[-1]).all()


def test_it_stops_at_corners_that_are_not_rounded(cases):
    scene, motion = cases["stops"]
    assert len(motion.corners) == len(motion.waypoints) - 2 and {corner.kind for corner in motion.corners} == {"stop"}
    for corner in motion.corners:
        state = motion.at(corner.time)
        assert np.linalg.norm(state.velocity) < 1e-5 and corner.deviation == 0
        assert state.position == pytest.approx(motion.waypoints[corner.waypoint], abs=1e-9)
    blended = cdpr.trajectory(scene, motion.waypoints, **PLATFORM, blend=0.03)
    assert blended.duration < motion.duration
    for corner in blended.corners:
        if corner.kind != "stop":
            assert np.linalg.norm(blended.at(corner.time).velocity) > 0.1 and 0 < corner.deviation <= 0.03 * (1 + 1e-9)


def test_the_curve_stays_within_the_deviation_and_is_valid(cases):
    scene, motion = cases["platform"]
    points = motion.at(np.linspace(0, motion.duration, 3000)).position
    starts, ends = motion.waypoints[:-1], motion.waypoints[1:]
    share = np.einsum("nsk,sk->ns", points[:, None] - starts, ends - starts) / ((ends - starts) ** 2).sum(axis=1)
    nearest = starts + np.clip(share, 0, 1)[..., None] * (ends - starts)
    assert np.linalg.norm(points[:, None] - nearest, axis=2).min(axis=1).max() <= 0.03 * (1 + 1e-6)
    assert scene.states_valid(points).all()


def test_what_binds_is_used_fully(cases):
    for name in ("platform", "cables"):
        _, motion = cases[name]
        assert motion.limiting and all(0 <= entry.start < entry.end <= motion.duration for entry in motion.limiting)
        for entry in motion.limiting:
            state = motion.at(np.linspace(entry.start, entry.end, 5)[1:-1])
            match entry.limit:
                case "speed":
                    used = np.linalg.norm(state.velocity, axis=1)
                case "acceleration":
                    used = np.linalg.norm(state.acceleration, axis=1)
                case "cable_speed":
                    used = np.abs(state.cable_speeds[:, motion.cables.index(entry.cable)])
                case _:
                    continue
            assert used.min() > 0.99 * motion.limits[entry.limit], entry
    assert {entry.limit for entry in cases["cables"][1].limiting} <= {"cable_speed", "cable_acceleration"}


def test_limits_of_the_scene_are_used_and_replaced(empty):
    scene = empty.replace(motion={"speed": 0.5, "acceleration": 2.0, "blend": 0.01})
    assert scene.motion == {"speed": 0.5, "acceleration": 2.0, "blend": 0.01} and empty.motion is None
    path = cdpr.plan(scene)
    assert cdpr.trajectory(scene, path).limits == {"speed": 0.5, "acceleration": 2.0, "blend": 0.01}
    assert cdpr.trajectory(scene, path, speed=1.0).limits["speed"] == 1.0
    with pytest.raises(TypeError):
        scene.motion["speed"] = 2.0
    with pytest.raises(cdpr.InputError, match="motion.*speed"):
        empty.replace(motion={"speed": -1.0})
    assert scene.replace(motion=None) == empty


def test_paths_of_all_kinds_are_taken(hard1):
    result = cdpr.plan(hard1)
    expected = cdpr.trajectory(hard1, result, **BLENDED)
    path = cdpr.Path(result.waypoints, result.cost)
    for given in (path, result.waypoints, result.waypoints.tolist()):
        assert cdpr.trajectory(hard1, given, **BLENDED) == expected
    assert (expected.waypoints == result.waypoints).all()


def test_the_orientation_is_that_of_the_path():
    scene = scene_of("plank")
    result = cdpr.plan(scene)
    motion = cdpr.trajectory(scene, result, **PLATFORM)
    assert (motion.orientation == result.orientation).all() and motion.orientation_name == result.orientation_name == "along"
    again = pickle.loads(pickle.dumps(motion))
    assert again == motion and again.at(0.3) == motion.at(0.3)


def test_a_path_of_another_scene_is_noticed(hard1):
    path = cdpr.plan(hard1)
    other = hard1.replace(workspace=[[0, 0, 0], [2, 2, 2.5]])
    with pytest.warns(cdpr.AnotherSceneWarning):
        cdpr.trajectory(other, path, **BLENDED)
    with pytest.raises(cdpr.InputError, match="another scene"):
        cdpr.trajectory(other, path, **BLENDED, strict=True)


def test_copies_are_equal_and_can_be_asked(case):
    _, motion = case
    times = np.linspace(0, motion.duration, 50)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for again in (pickle.loads(pickle.dumps(motion)), copy.copy(motion), copy.deepcopy(motion)):
            assert again == motion and again.at(times) == motion.at(times) and again.note == motion.note
    assert dataclasses.asdict(motion)["duration"] == dataclasses.replace(motion).duration == motion.duration
    with pytest.raises(AttributeError):
        motion.duration = 5.0
    with pytest.raises(TypeError, match="unhashable"):
        hash(motion)


def test_json_files_hold_everything(case, tmp_path):
    scene, motion = case
    motion.save(tmp_path / "motion.json")
    again = cdpr.load_trajectory(tmp_path / "motion.json", scene, strict=True)
    times = np.linspace(0, motion.duration, 50)
    assert again == motion and again.at(times) == motion.at(times)
    bare = cdpr.load_trajectory(tmp_path / "motion.json")
    state = bare.at(times)
    assert (state.acceleration == motion.at(times).acceleration).all() and state.cable_lengths is None
    file = json.loads((tmp_path / "motion.json").read_text())
    assert file["format"] == "cdpr-trajectory" and file["version"] == 1
    assert file["scene"]["name"] == scene.name and len(file["positions"]) == len(motion.times)


def test_a_file_without_the_exact_form_has_only_samples(cases, tmp_path):
    scene, motion = cases["platform"]
    motion.save(tmp_path / "motion.json")
    file = json.loads((tmp_path / "motion.json").read_text())
    del file["curve"], file["timing"]
    (tmp_path / "motion.json").write_text(json.dumps(file))
    bare = cdpr.load_trajectory(tmp_path / "motion.json", scene)
    assert (bare.tensions is None) == (motion.tensions is None) and (bare.positions == motion.positions).all()
    assert bare.limiting == motion.limiting and bare.note == motion.note
    with pytest.raises(cdpr.InputError, match="curve: found none"):
        bare.at(0.5)


def test_csv_files_hold_the_samples_in_the_columns_of_the_table(case, tmp_path):
    scene, motion = case
    motion.save(tmp_path / "motion.csv")
    table = pandas.read_csv(tmp_path / "motion.csv")
    assert list(table.columns) == list(motion.to_pandas().columns)
    assert (table.to_numpy() == motion.to_pandas().to_numpy()).all()
    again = cdpr.load_trajectory(tmp_path / "motion.csv", scene)
    assert again.to_pandas().equals(motion.to_pandas()) and again.duration == motion.times[-1]
    assert again.limits == {"blend": 0.0} and again.corners == () and again.tension_limits is None
    assert pickle.loads(pickle.dumps(again)) == again
    bare = cdpr.load_trajectory(tmp_path / "motion.csv")
    assert bare.to_pandas().equals(motion.to_pandas())
    with pytest.raises(cdpr.InputError, match="curve: found none"):
        again.at(0.5)
    assert len(cdpr.figures.trajectory(again)) == (4 if motion.tensions is None else 5)
    pyplot.close("all")
    again.save(tmp_path / "again.json")
    assert cdpr.load_trajectory(tmp_path / "again.json", scene) == again


def test_csv_files_of_other_sources_need_only_times_and_positions(empty, tmp_path):
    times = np.linspace(2, 3, 11)
    rows = [f"{t},{0.5 + 0.5 * (t - 2) ** 2},1,1" for t in times]
    (tmp_path / "motion.csv").write_text("t,x,y,z\n" + "\n".join(rows) + "\n")
    motion = cdpr.load_trajectory(tmp_path / "motion.csv", empty)
    assert motion.times == pytest.approx(times - 2) and motion.duration == pytest.approx(1.0)
    assert motion.velocities[1:-1, 0] == pytest.approx(times[1:-1] - 2) and motion.accelerations[:, 0] == pytest.approx(1.0)
    assert motion.cable_lengths == pytest.approx(empty.robot.cable_lengths(motion.positions))
    with pytest.raises(cdpr.InputError, match="found no such columns, expected them or the scene"):
        cdpr.load_trajectory(tmp_path / "motion.csv")


def test_yaml_files_are_messages_whose_joints_are_the_cables(cases, tmp_path):
    _, motion = cases["tensions"]
    motion.save(tmp_path / "motion.yaml")
    text = (tmp_path / "motion.yaml").read_text()
    assert all(cable in text for cable in motion.cables) and text.count("time_from_start") == len(motion.times)
    with pytest.raises(cdpr.FileError, match=r"motion\.yaml: found the extension \.yaml, expected \.json or \.csv"):
        cdpr.load_trajectory(tmp_path / "motion.yaml")


def test_files_of_other_scenes_and_other_files_are_noticed(cases, tmp_path, empty):
    scene, motion = cases["platform"]
    motion.save(tmp_path / "motion.json")
    with pytest.warns(cdpr.AnotherSceneWarning, match="motion.json"):
        again = cdpr.load_trajectory(tmp_path / "motion.json", empty)
    assert again.at(0.1).cable_lengths is None
    with pytest.raises(cdpr.InputError, match="another scene"):
        cdpr.load_trajectory(tmp_path / "motion.json", empty, strict=True)
    cdpr.plan(scene).save(tmp_path / "path.json")
    with pytest.raises(cdpr.InputError, match="path.json"):
        cdpr.load_trajectory(tmp_path / "path.json")
    with pytest.raises(cdpr.FileError):
        cdpr.load_trajectory(tmp_path / "nothing.json")
    for wrong in (lambda: motion.save(tmp_path / "motion.txt"), lambda: cdpr.load_trajectory(tmp_path / "motion.txt")):
        with pytest.raises(cdpr.FileError, match=r"motion\.txt: found the extension \.txt"):
            wrong()
    file = json.loads((tmp_path / "motion.json").read_text()) | {"positions": [[0, 0, 0]]}
    (tmp_path / "motion.json").write_text(json.dumps(file))
    with pytest.raises(cdpr.InputError, match="positions: found 1 entries"):
        cdpr.load_trajectory(tmp_path / "motion.json")


def test_tables_have_the_columns_of_the_file(case):
    _, motion = case
    table = motion.to_pandas()
    names = "t x y z qw qx qy qz vx vy vz ax ay az".split()
    for key in ("length", "speed", "acceleration", *(["tension"] if motion.tensions is not None else [])):
        names += [f"{key}:{cable}" for cable in motion.cables]
    assert list(table.columns) == names and table.index.name == "sample" and len(table) == len(motion.times)
    assert (table[["x", "y", "z"]].to_numpy() == motion.positions).all() and (table["t"] == motion.times).all()
    assert (table[["ax", "ay", "az"]].to_numpy() == motion.accelerations).all()
    assert (table[["qw", "qx", "qy", "qz"]].to_numpy() == motion.orientation).all()
    assert (table[f"speed:{motion.cables[3]}"] == motion.cable_speeds[:, 3]).all()


def strange(file):
    """Files whose exact form says something else than planning writes."""
    yield from ({"curve": curve} for curve in ([], {}, "a", [{}], [{"line": [[0, 0, 0], [0, 0, 0]]}], [{"bend": [[0, 0, 0]] * 6}], [[1]]))
    yield from ({"timing": timing} for timing in ([], {}, "a", [[0.0]], [["a"] * 5]))
    rows = np.array(file["timing"])
    yield {"timing": rows[::-1].tolist()}
    yield {"timing": (1e200 * rows).tolist()}
    yield {"timing": (rows * [1, 1, 30, 900, 1]).tolist()}
    yield {"curve": [{"line": [[-1e308, 0, 0], [1e308, 0, 0]]}]}
    yield {"curve": [{"line": [[0, 0, 0], [1e-300, 0, 0]]}]}


def test_files_that_say_strange_things_are_refused_or_answered(cases, tmp_path):
    scene, motion = cases["tensions"]
    motion.save(tmp_path / "motion.json")
    file = json.loads((tmp_path / "motion.json").read_text())
    refused = 0
    for change in strange(file):
        (tmp_path / "strange.json").write_text(json.dumps(file | change))
        try:
            found = cdpr.load_trajectory(tmp_path / "strange.json", scene)
            found.at(np.linspace(0, found.duration, 30))
        except cdpr.InputError:
            refused += 1
    assert refused >= 12


def test_the_rate_changes_the_samples_only(hard1):
    path = cdpr.plan(hard1)
    few, many = (cdpr.trajectory(hard1, path, **BLENDED, rate=rate) for rate in (2.5, 1000))
    assert few.duration == many.duration and len(few.times) < 15 and len(many.times) > 1000
    assert few.at(0.777) == many.at(0.777)


LINE = [[0.5, 1, 1], [1.5, 1, 1]]


@pytest.mark.parametrize(
    ("path", "given", "message"),
    [
        (LINE[:1], PLATFORM, "path: found 1 waypoints, expected at least two"),
        (np.ones((3, 2)), PLATFORM, r"path: found an array of shape \(3, 2\)"),
        ([0.5, 1, 1], PLATFORM, r"path: found an array of shape \(3,\)"),
        ([[0.5, 1, float("nan")], LINE[1]], PLATFORM, r"path\[0\]\[2\]: found nan"),
        ([["a", "b", "c"], ["d", "e", "f"]], PLATFORM, "path: found the text 'a'"),
        ([LINE[0], LINE[0]], PLATFORM, "waypoints: found only one position, expected a path that moves"),
        ([LINE[0], [9, 1, 1]], PLATFORM, r"waypoints\[0\]: found a segment that is not free"),
        (LINE, {}, "acceleration: found no limit, expected an acceleration, a jerk or a cable_acceleration"),
        (LINE, {"speed": 1.0}, "acceleration: found no limit"),
        (LINE, PLATFORM | {"speed": 0}, "speed: found 0"),
        (LINE, PLATFORM | {"speed": -1}, "speed: found -1"),
        (LINE, PLATFORM | {"acceleration": float("nan")}, "acceleration: found nan, expected a finite number"),
        (LINE, PLATFORM | {"jerk": float("inf")}, "jerk: found inf, expected a finite number"),
        (LINE, PLATFORM | {"cable_speed": "fast"}, "cable_speed: found the text 'fast', expected a number"),
        (LINE, PLATFORM | {"cable_acceleration": [1.0]}, r"cable_acceleration: found an array of shape \(1,\), expected a number"),
        (LINE, PLATFORM | {"blend": -0.1}, "blend: found -0.1"),
        (LINE, PLATFORM | {"wrench_margin": 5.0}, "wrench_margin: found a margin, but tensions are not limited"),
        (LINE, PLATFORM | {"speed": True}, "speed: found True, expected a number"),
        (LINE, PLATFORM | {"rate": 0}, "rate: found 0.0, expected a positive number"),
        (LINE, PLATFORM | {"rate": 1e9}, "rate: found 1000000000 per second for 1.5.* samples"),
        (LINE, PLATFORM | {"rate": float("nan")}, "rate: found nan, expected a finite number"),
    ],
)
def test_what_makes_no_sense_is_refused(empty, path, given, message):
    with pytest.raises(cdpr.InputError, match=message):
        cdpr.trajectory(empty, path, **given)


def test_other_nonsense_is_refused(empty, hard1):
    with pytest.raises(cdpr.InputError, match="waypoints: found no tensions within the limits that hold"):
        scene = scene_of("cogiro").replace(wrench=None)
        cdpr.trajectory(scene.without(*scene.obstacles), [[0, 0, 2.0], [0, 0, 2.2]], acceleration=1.0, wrench_margin=1e5)
    with pytest.raises(cdpr.InputError, match="path: found 0 waypoints"):
        cdpr.trajectory(hard1, cdpr.plan(hard1, max_samples=0), **PLATFORM)
    with pytest.raises(cdpr.InputError, match=r"waypoints\[0\]: found a segment that is not free .*pillar"):
        cdpr.trajectory(hard1, [[0.3, 1, 0.3], [1.7, 1, 1.7]], **PLATFORM)
    motion = cdpr.trajectory(empty, LINE, **PLATFORM)
    for time, message in [(float("nan"), "time: found nan"), ("1", "time: found the text '1'"), ([0, np.inf], "time: found inf")]:
        with pytest.raises(cdpr.InputError, match=message):
            motion.at(time)


def test_ctrl_c_is_answered_at_once():
    scene = scene_of("cogiro")
    path = cdpr.plan(scene)
    motion = cdpr.trajectory(scene, path, acceleration=4.0, blend=0.2)
    times = np.linspace(0, motion.duration, 3_000_000)
    for call in (lambda: motion.at(times), lambda: cdpr.trajectory(scene, path, acceleration=4.0, blend=0.2, rate=3e5)):
        for after in (0.2, 1.0, 2.0):  # the more there is to free, the longer it takes
            assert min(interrupted_after(after, call)[0] for _ in range(3)) < AT_ONCE / 2, (call, after)


def test_a_table_is_not_blamed_for_limits_that_its_scene_lacks(tmp_path):
    scene = cdpr.Scene.load(TESTDATA / "scenes/empty.toml")
    table = tmp_path / "motion.csv"
    table.write_text("t,x,y,z\n0,0.3,1,0.3\n1,0.3,1,0.8\n")
    loaded = cdpr.load_trajectory(table, scene.replace(motion={"speed": 1.0}))
    assert loaded.cable_lengths.tolist() == cdpr.load_trajectory(table, scene).cable_lengths.tolist()


def test_a_motion_in_place_of_a_path_is_named(cases):
    scene, motion = cases["platform"]
    with pytest.raises(cdpr.InputError, match="waypoints: found a Trajectory, expected"):
        cdpr.check(scene, motion)
