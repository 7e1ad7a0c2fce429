"""Threads of Python run while the core works, which releases the interpreter."""

import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from conftest import TESTDATA

import cdpr

# Minimum processor time of a call for a meaningful test, s, and the maximum share of its duration during which a thread that ticks
# every millisecond may be silent; if the call held the interpreter, it would be silent all the time.
LONG, SILENT = 0.5, 0.5


def longest_pause(call):
    """Run a call beside a ticking thread; returns its answer, its duration and the longest time without a tick, s."""
    ticks, done = [time.perf_counter()], threading.Event()

    def tick():
        while not done.wait(0.001):
            ticks.append(time.perf_counter())

    ticker = threading.Thread(target=tick)
    ticker.start()
    began = time.perf_counter()
    answer = call()
    ended = time.perf_counter()
    done.set()
    ticker.join()
    during = [began, *(moment for moment in ticks if began < moment < ended), ended]
    return answer, ended - began, max(np.diff(during))


def plenty(scene):
    """Calls whose duration grows with their argument."""
    more = {"keep_going": True, "post": "none", "near_radius": 0.3}
    points = np.random.default_rng(0).uniform(0.15, 1.85, (400_000, 3))
    return {
        "motions_valid": lambda n: scene.motions_valid(points[:n], points[:n][::-1].copy(), engine="gjk", threads=1),
        "states_valid": lambda n: scene.states_valid(points[:n], engine="gjk", threads=1),
        "clearance": lambda n: scene.clearance(points[:n], threads=1),
        "plan": lambda n: cdpr.plan(scene, "rrt-star", seed=1, max_samples=n, **more),
        "trajectory": lambda n: cdpr.trajectory(scene, [[0.3, 1, 0.3], [0.3, 1, 1]], acceleration=0.01, rate=n),
        "wrench_map": lambda n: cdpr.wrench_map(scene, step=1.7 / n ** (1 / 3), threads=1),
        "capacity_margin": lambda n: cdpr.capacity_margin(scene.robot, points[:n], threads=1),
    }


@pytest.mark.parametrize("name", list(plenty(None)))
def test_a_ticking_thread_goes_on(hard1, name):
    call = plenty(hard1)[name]
    n, worked = 500, 0.0
    while worked < LONG and n < 400_000:  # enough work for a result on any machine, also if it stands still for a moment
        n *= 2
        began = time.process_time()
        _, took, pause = longest_pause(lambda n=n: call(n))
        worked = time.process_time() - began
    assert worked >= LONG and pause < SILENT * took, (n, worked, took, pause)


def test_threads_plan_at_once_and_find_what_one_finds(hard1):
    def found(seed):
        return cdpr.plan(hard1, "modified-rrt", seed=seed, keep_going=True, max_samples=3000).waypoints.tolist()

    points = np.random.default_rng(1).uniform(0.1, 1.9, (20_000, 3))
    alone = [found(seed) for seed in range(12)]
    answers = hard1.motions_valid(points, points[::-1])
    with ThreadPoolExecutor(6) as pool:
        plans = [pool.submit(found, seed) for seed in range(12)]
        checks = [pool.submit(hard1.motions_valid, points, points[::-1]) for _ in range(6)]
        gaps = [pool.submit(hard1.clearance, points[:500]) for _ in range(6)]
        assert [plan.result() for plan in plans] == alone
        assert all((check.result() == answers).all() for check in checks)
        assert all((gap.result() == gaps[0].result()).all() for gap in gaps)


def test_engines_are_compiled_once_whoever_asks_first():
    scene = cdpr.Scene.load(TESTDATA / "scenes/forest.toml")
    with ThreadPoolExecutor(4) as pool:
        answers = list(pool.map(lambda _: scene.states_valid([[1.0, 1.0, 1.0], [6.0, 4.0, 3.0]]).tolist(), range(8)))
    assert all(answer == answers[0] for answer in answers)


def test_ctrl_c_reaches_the_main_thread_while_others_work():
    code = f"""
import threading, time, cdpr
import numpy as np
scene, closed = (cdpr.Scene.load({str(TESTDATA / "scenes")!r} + f"/{{name}}.toml") for name in ("hard1", "closed"))
points = np.random.default_rng(0).uniform(0.1, 1.9, (2_000_000, 3))
ask = lambda: scene.motions_valid(points, points[::-1].copy(), engine="gjk", threads=1)
other = threading.Thread(target=ask, daemon=True)
other.start()
print("ready", flush=True)
try:
    cdpr.plan(closed, "rrt", max_samples=10**12, proof=False)
except KeyboardInterrupt:
    print("interrupted", other.is_alive(), flush=True)
"""
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "ready\n"
    time.sleep(0.3)
    process.send_signal(signal.SIGINT)
    assert process.stdout.readline() == "interrupted True\n"
    process.stdout.close()
    process.kill()
    process.wait()
