"""Planning for the shortest time: `plan(minimise="time")`."""

import copy
import pickle
import time
import warnings

import pytest
from conftest import TESTDATA
from test_planning import AT_ONCE, interrupted_after

import cdpr

LIMITS = {"speed": 1.0, "acceleration": 2.0, "blend": 0.03}
TURNS = {"turn_speed": 1.5, "turn_acceleration": 4.0}


def scene_of(name, **changes):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cdpr.CdprWarning)
        scene = cdpr.Scene.load(TESTDATA / f"scenes/{name}.toml")
        return scene.replace(**changes) if changes else scene


def fastest(scene, planner="two-trees", **options):
    return cdpr.plan(scene, planner, **{"minimise": "time", "motion": LIMITS} | options)


def test_a_longer_path_is_chosen_if_its_motion_is_faster():
    scene, limits = scene_of("forest"), LIMITS | {"blend": 0.01}
    found, shortest = fastest(scene, motion=limits), cdpr.plan(scene, "two-trees")
    assert found.cost > shortest.cost
    assert found.trajectory.duration < 0.99 * cdpr.trajectory(scene, shortest, **limits).duration
    assert fastest(scene, motion=limits).trajectory == found.trajectory  # the seed determines it


@pytest.mark.parametrize("name", ["hard1", "turn", "plank"])
def test_the_motion_is_that_along_the_path(name):
    scene, limits = scene_of(name), LIMITS | TURNS
    found = fastest(scene, "anytime", motion=limits)
    assert found.trajectory == cdpr.trajectory(scene, found, **limits)
    assert found.trajectory.waypoints.tolist() == found.waypoints.tolist()
    assert cdpr.check(scene, found, strict=True).valid
    assert (found.orientations is not None, found.trajectory.turns) == (name == "turn", name == "turn")
    assert found.orientation_name == found.trajectory.orientation_name == {"plank": "along", "turn": "along"}.get(name)


def test_copies_keep_the_motion(hard1):
    found = fastest(hard1)
    for again in (copy.deepcopy(found), pickle.loads(pickle.dumps(found))):
        assert again == found and again.trajectory.at(0.7) == found.trajectory.at(0.7)
    assert found != cdpr.plan(hard1, "two-trees")


def test_limits_of_the_scene_are_used_and_replaced(hard1):
    scene = hard1.replace(motion=LIMITS)
    assert fastest(scene, motion=None).trajectory == fastest(scene, motion={}).trajectory
    assert fastest(scene, motion={"speed": 0.5}).trajectory.limits == LIMITS | {"speed": 0.5}
    assert cdpr.plan(scene, "two-trees").trajectory is None


def test_path_and_motion_keep_the_clearances_of_the_scene(hard1):
    scene = hard1.replace(clearance=0.02)
    found = fastest(scene)
    assert found.trajectory.nearest["value"] >= 0.02 - 1e-9 and found.min_clearance["required"] == 0.02
    assert cdpr.check(scene, found, strict=True).valid


def test_without_a_path_there_is_no_motion(hard1):
    closed = fastest(scene_of("closed"))
    assert (closed.status, closed.trajectory) == ("no_path", None) and closed.proof
    inside = fastest(hard1, goal=[1, 1, 1])
    assert (inside.status, inside.trajectory) == ("goal_invalid", None) and inside.reason
    assert fastest(hard1, budget=1e-4).trajectory is None


def test_all_paths_together_take_no_more_than_the_budget(hard1):
    took = []
    for _ in range(3):  # the best counts, on a busy machine
        began = time.perf_counter()
        found = fastest(hard1, "anytime", budget=1.5)
        took.append(time.perf_counter() - began)
        assert found.solved and found.trajectory
    assert min(took) < 1.5 + AT_ONCE, took


def test_ctrl_c_keeps_the_fastest_motion_so_far(hard1):
    found = []
    # Each of six paths has a second: Ctrl-C comes while the third is planned.
    interrupted_after(2.5, lambda: found.append(fastest(hard1, "anytime", budget=6.0)), raises=None)
    assert found[0].solved and found[0].trajectory == cdpr.trajectory(hard1, found[0], **LIMITS)


def test_ctrl_c_before_the_first_path_is_complete_keeps_that_path(hard1):
    found = []

    def plan():
        found.append(fastest(hard1, "anytime", budget=60.0))

    took = [interrupted_after(1.0, plan, raises=None)[0] for _ in range(3)]
    assert all(each.solved and each.trajectory is None for each in found)
    assert min(took) < AT_ONCE, took  # the best counts, on a busy machine


def test_improvements_are_reported_and_a_failure_there_is_raised(hard1):
    costs = []
    found = fastest(hard1, "anytime", on_improvement=lambda _, cost, waypoints: costs.append(cost))
    assert costs == sorted(costs, reverse=True) and found.cost >= costs[-1] - 1e-9
    with pytest.raises(ZeroDivisionError):
        fastest(hard1, "anytime", on_improvement=lambda *_: 1 / 0)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"minimise": "length"}, 'motion: found with minimise="length", where it has no effect'),
        ({"motion": {"speed": -1}}, "motion.speed: found -1, expected a finite positive number"),
        ({"motion": {"sped": 1}}, "motion.sped: unknown field .* did you mean `speed`"),
        ({"motion": 3}, "motion: found 3, expected a mapping"),
        ({"motion": {"speed": 1}}, "acceleration: found no limit"),
    ],
)
def test_limits_that_make_no_sense_are_refused(hard1, options, message):
    with pytest.raises(cdpr.InputError, match=message):
        fastest(hard1, **options)
