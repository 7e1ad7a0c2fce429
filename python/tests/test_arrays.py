"""Arrays in, arrays out: layouts, types, shapes, threads."""

import copy
import re
import threading
import time
import tracemalloc

import numpy as np
import pytest

import cdpr


@pytest.fixture
def motions():
    rng = np.random.default_rng(1)
    return rng.uniform(0.1, 1.9, (5000, 3)), rng.uniform(0.1, 1.9, (5000, 3))


def test_any_layout_type_and_thread_count_gives_the_same_answers(hard1, motions):
    starts, ends = motions
    expected = hard1.motions_valid(starts, ends)
    assert expected.dtype == np.bool_ and expected.shape == (5000,)
    assert 0.02 < expected.mean() < 0.98
    for threads in (1, 2, 3):
        assert (hard1.motions_valid(starts, ends, threads=threads) == expected).all()
    assert (hard1.motions_valid(np.asfortranarray(starts), ends[::-1][::-1]) == expected).all()
    assert (hard1.motions_valid(starts.tolist(), ends.tolist()) == expected).all()
    wide = np.zeros((5000, 5))
    wide[:, 1:4] = starts
    assert (hard1.motions_valid(wide[:, 1:4], ends) == expected).all()
    single = [hard1.explain_motion(p, q) is None for p, q in zip(starts[:50], ends[:50], strict=True)]
    assert (expected[:50] == single).all()


def test_integers_and_single_precision_are_converted(hard1):
    assert hard1.states_valid(np.array([[1, 1, 1]])).tolist() == [False]
    assert hard1.states_valid(np.array([[0.3, 1.0, 0.3]], dtype=np.float32)).tolist() == [True]


def test_no_rows_give_no_answers(hard1):
    assert hard1.states_valid(np.empty((0, 3))).shape == (0,)
    assert hard1.motions_valid(np.empty((0, 3)), np.empty((0, 3))).shape == (0,)


@pytest.mark.parametrize("shape", [(2,), (4, 2), (2, 3, 1), ()])
def test_wrong_shapes_are_value_errors_of_our_tree(hard1, shape):
    with pytest.raises(cdpr.InputError, match=r"points: found an array of shape .* expected \(\.\.\., 3\)") as caught:
        hard1.states_valid(np.zeros(shape))
    assert isinstance(caught.value, ValueError) and isinstance(caught.value, cdpr.CdprError)


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, 2e6])
def test_numbers_that_make_no_sense_are_named_by_index(hard1, bad):
    points = np.ones((4, 3))
    points[2, 1] = bad
    with pytest.raises(cdpr.InputError, match=r"points\[2\]\[1\]"):
        hard1.states_valid(points)
    with pytest.raises(cdpr.InputError, match=r"ends\[2\]\[1\]"):
        hard1.motions_valid(np.ones((4, 3)), points)


def test_other_nonsense_is_refused(hard1):
    with pytest.raises(cdpr.InputError, match=r"ends: found an array of shape \(2, 3\), expected \(4, 3\), one for each start"):
        hard1.motions_valid(np.ones((4, 3)), np.ones((2, 3)))
    with pytest.raises(cdpr.InputError, match="points"):
        hard1.states_valid([["a", "b", "c"]])
    with pytest.raises(cdpr.InputError, match="points"):
        hard1.states_valid([[1, 2, 3], [1, 2]])
    with pytest.raises(cdpr.InputError, match="points"):
        hard1.states_valid(np.ones((2, 3)) * 1j)
    with pytest.raises(cdpr.InputError, match="engine: found \"magic\", expected one of cspace, gjk"):
        hard1.states_valid([[1, 1, 1]], engine="magic")
    with pytest.raises(cdpr.InputError, match="interference"):
        hard1.states_valid([[1, 1, 1]], interference="none")
    with pytest.raises(cdpr.InputError, match="threads"):
        hard1.states_valid([[1, 1, 1]], threads=0)


@pytest.mark.parametrize("engine", ["cspace", "gjk"])
def test_engines_by_name_give_the_same_answers(hard1, motions, engine):
    starts, ends = motions
    assert (hard1.motions_valid(starts, ends, engine=engine) == hard1.motions_valid(starts, ends)).all()


def test_clearance_is_the_gap_in_the_world(hard1):
    points = [[0.3, 1.0, 0.3], [1.0, 1.0, 1.7], [1.0, 1.0, 0.75]]
    # Two cables end 0.05 m above each other; one passes the pillar's corner (0.85, 0.85, 1.5) on its way from the
    # origin to (0.925, 0.925, 1.675): |corner x way| / |way| = 0.0241215 m; the last is deep inside.
    found = hard1.clearance(points)
    assert found[:2] == pytest.approx([0.05, 0.0241215], abs=1e-7)
    assert found[2] < -0.15
    many = np.random.default_rng(5).uniform(0.1, 1.9, (2000, 3))
    assert (hard1.clearance(many, threads=1) == hard1.clearance(many, threads=2)).all()
    valid = hard1.states_valid(many)
    assert (hard1.clearance(many)[valid] >= 0).all() and (hard1.clearance(many)[~valid] <= 0).all()
    assert hard1.clearance(np.empty((0, 3))).shape == (0,)
    with pytest.raises(cdpr.InputError, match="threads"):
        hard1.clearance(many, threads=0)


def test_c_contiguous_input_is_not_copied(hard1):
    points = np.zeros((1_000_000, 3))
    tracemalloc.start()
    hard1.states_valid(points, threads=1)
    used = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert used < 2 * len(points)  # the answers and little else


def test_the_interpreter_is_released_during_long_calls(hard1):
    points = np.random.default_rng(2).uniform(0.1, 1.9, (1_000_000, 3))
    ticks = []

    def count():
        while not done.is_set():
            ticks.append(time.perf_counter())
            time.sleep(0.001)

    done = threading.Event()
    thread = threading.Thread(target=count)
    thread.start()
    begin = time.perf_counter()
    hard1.motions_valid(points, points[::-1], threads=1)
    end = time.perf_counter()
    done.set()
    thread.join()
    assert sum(begin < tick < end for tick in ticks) >= 5


def test_threads_may_share_a_scene(hard1, motions):
    starts, ends = motions
    expected = hard1.motions_valid(starts, ends)
    results = [None] * 4

    def work(k):
        results[k] = hard1.motions_valid(starts, ends, threads=1)

    threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all((result == expected).all() for result in results)


def test_what_is_no_number_is_named(hard1):
    for call, named in [
        (lambda: cdpr.plan(hard1, step="x"), "step"),
        (lambda: cdpr.plan(hard1, budget="1"), "budget"),
        (lambda: cdpr.plan("hard1.toml"), "scene"),
        (lambda: cdpr.check("hard1.toml", [[0, 0, 0], [1, 1, 1]]), "scene"),
        (lambda: hard1.replace(clearance="wide"), "clearance"),
        (lambda: hard1.replace(robot="paper"), "robot"),
        (lambda: hard1.with_obstacle("crate", None), "obstacles['crate']"),
        (lambda: hard1.states_valid([[1, 1, 1]], threads=-1), "threads"),
        (lambda: hard1.states_valid([[1, 1, 1]], threads="2"), "threads"),
        (lambda: cdpr.Scene(hard1.robot, workspace=hard1.workspace, orientations=["level"]), "orientations"),
    ]:
        with pytest.raises(cdpr.InputError, match=re.escape(named)):
            call()


def test_arrays_that_are_not_aligned_give_the_answers_of_their_copies() -> None:
    scene = cdpr.Scene.load("testdata/scenes/hard1.toml")
    places = np.array([[0.3, 1.0, 0.3], [0.3, 1.0, 1.7], [1.7, 1.0, 1.7]])
    shifted = np.frombuffer(b"abc" + places.tobytes(), dtype=np.float64, offset=3).reshape(-1, 3)
    records = np.zeros(3, dtype=np.dtype([("flag", "u1"), ("xyz", "f8", 3)], align=False))
    records["xyz"] = places
    for given in (shifted, records["xyz"], places[::-1][::-1], np.asfortranarray(places), places.astype(">f8")):
        assert not (given is shifted and given.flags.aligned)
        assert scene.states_valid(given).tolist() == scene.states_valid(places).tolist()
        assert cdpr.check(scene, given) == cdpr.check(scene, places)
        assert scene.motions_valid(given[:-1], given[1:]).tolist() == scene.motions_valid(places[:-1], places[1:]).tolist()
    assert not shifted.flags.aligned and not records["xyz"].flags.aligned


def moved(array: np.ndarray) -> np.ndarray:
    """An unaligned copy of an array, like those that Dask passes to its workers."""
    apart = np.ndarray(array.shape, array.dtype, bytearray(array.nbytes + 3), 3)
    apart[...] = array
    assert not apart.flags.aligned
    return apart


def test_results_whose_arrays_are_not_aligned_give_the_answers_of_their_copies() -> None:
    hard1, turn = (cdpr.Scene.load(f"testdata/scenes/{name}.toml") for name in ("hard1", "turn"))
    limits = {"speed": 1, "acceleration": 2, "turn_speed": 1, "turn_acceleration": 2}
    for scene in (hard1, turn):
        result = cdpr.plan(scene)
        apart = copy.copy(result)
        for name in ("waypoints", "orientations", "orientation"):
            if getattr(result, name) is not None:
                object.__setattr__(apart, name, moved(getattr(result, name)))
        object.__setattr__(apart, "tree", cdpr.SearchTree(moved(result.tree.states), moved(result.tree.parents)))
        assert cdpr.check(scene, apart) == cdpr.check(scene, result)
        assert cdpr.refine(scene, apart) == cdpr.refine(scene, result)
        assert cdpr.trajectory(scene, apart, **limits) == cdpr.trajectory(scene, result, **limits)
        assert cdpr._view.view(scene, apart).html == cdpr._view.view(scene, result).html
