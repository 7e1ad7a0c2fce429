"""Commands that are interrupted at random moments: what was found until then is written, and valid."""

from __future__ import annotations

import contextlib
import json
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from conftest import TESTDATA, program

import cdpr

pytestmark = pytest.mark.long

MOMENTS = 10
FOREVER = ["--keep-going", "--max-samples", "100000000"]
LIMITS = ["--speed", "1", "--acceleration", "2", "--blend", "0.02"]
TIMED = ["--trajectory", "motion.json", *LIMITS]
COMMANDS = {
    "anytime": ["hard3", *FOREVER],
    "rrt": ["hard1", "--planner", "rrt", *FOREVER],
    "rrt-star": ["hard1", "--planner", "rrt-star", *FOREVER],
    "modified-rrt": ["hard1", "--planner", "modified-rrt", *FOREVER],
    "two-trees": ["hard1", "--planner", "two-trees", *FOREVER],
    "rrt-connect": ["hard1", "--planner", "rrt-connect", *FOREVER],
    "proof": ["hard1", "--proof", "proof.json", *FOREVER],
    "trajectory": ["hard1", *TIMED, *FOREVER],
    "time": ["hard1", *TIMED, "--minimise", "time", *FOREVER],
    "widest": ["hard1", "--maximise", "clearance", *FOREVER],
    "widest, with wrenches": ["acrobot", "--maximise", "clearance", "--proof", "proof.json", *FOREVER],
    "gap": ["cogiro", "--gap", "0.0001"],
    "turning": ["turn", *FOREVER],
    "turning, timed": ["turn", *TIMED, "--turn-speed", "1", "--turn-acceleration", "2", *FOREVER],
    "orientations": ["plank", *FOREVER],
    "orientations, two trees": ["plank", "--planner", "two-trees", *FOREVER],
}


@pytest.mark.parametrize("name", COMMANDS)
def test_what_was_found_is_kept_at_any_moment(name, tmp_path):
    scene, *options = COMMANDS[name]
    file = str(TESTDATA / f"scenes/{scene}.toml")
    found = 0
    for moment in range(MOMENTS):
        for left in tmp_path.iterdir():
            left.unlink()
        command = [program(), "plan", file, "-o", "path.json", *options]
        running = subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        sent = random.Random(moment).choice([signal.SIGINT, signal.SIGTERM])
        after = 0.02 * 75 ** random.Random(100 + moment).random()  # up to 1.5 s; early on, more is yet to be written
        try:
            running.wait(after)
        except subprocess.TimeoutExpired:
            running.send_signal(sent)
        out, err = running.communicate(timeout=30)
        # At one orientation the straight line is free: nothing is shorter, and the search may end by itself.
        ended = {130, 0} if name == "orientations" else {130}
        if after < 0.2 and not out:
            ended.add(-sent)  # on a busy machine, before the program has begun
        assert running.returncode in ended, (running.returncode, out, err)
        if not (tmp_path / "path.json").exists():
            assert "solved" not in out and not list(tmp_path.iterdir()), (out, err)
            continue
        path = json.loads((tmp_path / "path.json").read_text())
        if path["status"] != "solved":
            continue
        found += 1
        turned = ["--orientation", path["orientation_name"]] if path.get("orientation_name") else []
        for written in Path(tmp_path).iterdir():
            limits = LIMITS if written.name == "motion.json" else []
            checked = subprocess.run(
                [program(), "check", file, written.name, *turned, *limits], cwd=tmp_path, capture_output=True, text=True
            )
            assert checked.returncode == 0, (written.name, checked.stdout, checked.stderr)
    assert found >= MOMENTS // 3, found


def test_the_command_of_the_package_ends_as_the_program_does(tmp_path):
    scene = str(TESTDATA / "scenes/forest.toml")
    command = [sys.executable, "-m", "cdpr", "plan", scene, "--gap", "1e-9", "-v", "-o", "path.json"]
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as running:
        # Until a path was found, Python may still be loading, and there is nothing to write.
        assert any(line.endswith("waypoints\n") for line in running.stderr)
        running.send_signal(signal.SIGINT)
        out, err = running.communicate(timeout=30)
    assert running.returncode == 130, (out, err)
    assert "interrupted; this is the best path found so far" in err, (out, err)
    assert cdpr.check(cdpr.Scene.load(scene), cdpr.load_path(tmp_path / "path.json")).valid


@pytest.mark.skipif(sys.platform == "win32", reason="needs pipes of Unix")
def test_an_answer_is_written_however_slowly_it_is_printed(tmp_path):
    reader, writer = os.pipe()
    os.set_blocking(writer, False)
    with contextlib.suppress(BlockingIOError):
        while True:
            os.write(writer, bytes(4096))  # until the pipe is full
    os.set_blocking(writer, True)
    command = [program(), "plan", str(TESTDATA / "scenes/hard1.toml"), "-o", "path.json", *FOREVER]
    running = subprocess.Popen(command, cwd=tmp_path, stdout=writer, stderr=subprocess.DEVNULL)
    os.close(writer)
    time.sleep(2.0)
    running.send_signal(signal.SIGINT)
    time.sleep(1.0)
    with os.fdopen(reader, "rb") as pipe:
        printed = pipe.read().strip(b"\0").decode()
    assert running.wait(30) == 130
    assert "solved" in printed and json.loads((tmp_path / "path.json").read_text())["status"] == "solved"


PLANNERS = ["anytime", "two-trees", "rrt-connect", "modified-rrt", "rrt", "rrt-star"]

# Calls in Python that are interrupted, or out of time, at random moments: prints what they gave, one line of JSON each.
CALLS = """
import json, os, random, signal, sys, threading, time, warnings
import cdpr

warnings.simplefilter("ignore")
file, planner, moments = sys.argv[1], sys.argv[2], int(sys.argv[3])
scene, chance = cdpr.Scene.load(file), random.Random(planner)
options = {"goal_bias": 0.1} if planner in ("rrt", "rrt-star") else {}
began = time.perf_counter()
first = cdpr.plan(scene, planner, **options)
assert first.solved
enough = 0.5 + 5 * (time.perf_counter() - began)

def interrupted(after):
    timer = threading.Timer(after, lambda: os.kill(os.getpid(), signal.SIGINT))
    signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        timer.start()  # on a busy machine, Ctrl-C may come before the search begins
        return cdpr.plan(scene, planner, keep_going=True, max_samples=10**9, **options)
    except KeyboardInterrupt:
        return None
    finally:
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # a search for a straight path may end first
        timer.join()

def out_of_time(after):
    return cdpr.plan(scene, planner, keep_going=True, max_samples=10**9, budget=after, **options)

for ended in (interrupted, out_of_time):
    for after in [*(chance.uniform(0.001, enough) for _ in range(moments)), enough]:
        found = ended(after)
        solved = found is not None and found.solved
        valid = solved and cdpr.check(scene, found).valid
        told = solved and found.cost > 0 and found.stats["planning_seconds"] > 0
        print(json.dumps([ended.__name__, after < enough, solved, valid, told]), flush=True)
"""


@pytest.mark.parametrize("planner", PLANNERS)
@pytest.mark.parametrize("scene", ["hard1", "turn", "plank"])
def test_calls_in_python_keep_what_was_found_at_any_moment(scene, planner):
    file = str(TESTDATA / f"scenes/{scene}.toml")
    command = [sys.executable, "-c", CALLS, file, planner, str(MOMENTS // 4)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=280)
    assert done.returncode == 0, done.stderr
    answers = [json.loads(line) for line in done.stdout.splitlines()]
    assert len(answers) == 2 * (MOMENTS // 4 + 1)
    for name, early, solved, valid, told in answers:
        assert (valid and told) if solved else early, (name, answers)


# Calls that give nothing if they are interrupted, and afterwards answer as before.
NOTHING = """
import os, signal, sys, threading
import numpy as np
import cdpr

signal.signal(signal.SIGINT, signal.default_int_handler)
scenes = sys.argv[1]
hard1, turn = (cdpr.Scene.load(f"{scenes}/{name}.toml") for name in ("hard1", "turn"))
limits = {"speed": 1, "acceleration": 2, "turn_speed": 1, "turn_acceleration": 2}
zigzag = [[0.3, 1.0, 0.3 + 0.01 * (k % 2)] for k in range(400)]
calls = {
    "lower_bound": lambda effort: cdpr.lower_bound(hard1, gap=1e-12 if effort else 0.1),
    "trajectory": lambda effort: cdpr.trajectory(hard1, zigzag if effort else zigzag[:3], blend=0.001, **limits).duration,
    "check": lambda effort: cdpr.check(hard1, zigzag * (500 if effort else 1), engine="gjk").valid,
}
for name, call in calls.items():
    before = call(False)
    for after in (0.001, 0.01, 0.1, 0.3):
        timer = threading.Timer(after, lambda: os.kill(os.getpid(), signal.SIGINT))
        try:
            timer.start()  # on a busy machine, Ctrl-C may come before the first call
            while True:
                call(True)
        except KeyboardInterrupt:
            timer.join()
        assert call(False) == before, name
print("as before")
"""


def test_calls_in_python_that_give_nothing_answer_again_after_ctrl_c():
    command = [sys.executable, "-c", NOTHING, str(TESTDATA / "scenes")]
    done = subprocess.run(command, capture_output=True, text=True, timeout=280)
    assert (done.returncode, done.stdout) == (0, "as before\n"), done.stderr
