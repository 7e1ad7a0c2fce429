"""Commands that are interrupted at random moments: what was found until then is written, and valid."""

from __future__ import annotations

import json
import random
import signal
import subprocess
from pathlib import Path

import pytest
from conftest import TESTDATA, program

pytestmark = pytest.mark.long

MOMENTS = 20
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
        try:
            running.wait(random.Random(100 + moment).uniform(0.02, 1.5))
        except subprocess.TimeoutExpired:
            running.send_signal(sent)
        out, err = running.communicate(timeout=30)
        # At one orientation the straight line is free: nothing is shorter, and the search may end by itself.
        ended = {130, 0} if name == "orientations" else {130}
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
