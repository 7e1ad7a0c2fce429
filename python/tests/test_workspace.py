"""Proved workspaces in Python and in files."""

import json
import os
import signal
import subprocess
import threading
import time

import numpy as np
import pytest
from conftest import TESTDATA, program

import cdpr


def test_boxes_agree_with_the_check_of_positions():
    scene = cdpr.example("hard3")
    found = cdpr.workspace(scene, resolution=0.1)
    rng = np.random.default_rng(3)
    places = found.lower + rng.random(found.lower.shape) * (found.upper - found.lower)
    valid = scene.states_valid(places)
    assert valid[found.verdict == 1].all() and not valid[found.verdict == -1].any()
    boxes = (found.upper - found.lower).prod(axis=1)
    assert boxes.sum() == pytest.approx(found.total)
    assert found.volume.min >= boxes[found.verdict == 1].sum()
    assert sum(share.volume for share in found.shares.values()) >= boxes[found.verdict == -1].sum() * (1 - 1e-12)
    assert found.undecided <= boxes[found.verdict == 0].sum()
    assert all(boxes[found.part == k].sum() == pytest.approx(part.volume) for k, part in enumerate(found.parts))
    assert {found.causes[k].split(":")[0] for k in found.cause[found.cause >= 0]} <= set(found.shares)


def test_threads_change_nothing_and_files_say_the_same(tmp_path):
    scene = cdpr.example("hard1")
    found = cdpr.workspace(scene, resolution=0.15, threads=1)
    assert found == cdpr.workspace(scene, resolution=0.15, threads=3)
    for name in ("w.json", "w.npz", "w.vti", "w.stl"):
        found.save(tmp_path / name)
    written = json.loads((tmp_path / "w.json").read_text())
    assert written["volume"] == found.volume._asdict() and written["boxes"]["verdict"] == found.verdict.tolist()
    with np.load(tmp_path / "w.npz") as arrays:
        assert (arrays["lower"] == found.lower).all() and (arrays["verdict"] == found.verdict).all()
        assert arrays["causes"].tolist() == list(found.causes)
        assert json.loads(str(arrays["report"]))["decided"] == found.decided
    vti = (tmp_path / "w.vti").read_bytes()
    voxels = np.frombuffer(vti.split(b"\n_", 1)[1][8:].split(b"\n  </AppendedData>")[0], np.int8)
    finest = (found.upper - found.lower).min(axis=0).prod()
    boxes = (found.upper - found.lower).prod(axis=1)
    for verdict in (-1, 0, 1):
        assert (voxels == verdict).sum() * finest == pytest.approx(boxes[found.verdict == verdict].sum())
    stl = np.frombuffer((tmp_path / "w.stl").read_bytes()[84:], np.dtype([("f", "<f4", (4, 3)), ("a", "<u2")]))["f"][:, 1:]
    enclosed = np.einsum("ij,ij->i", stl[:, 0].astype(float), np.cross(stl[:, 1], stl[:, 2])).sum() / 6
    assert enclosed == pytest.approx(boxes[found.verdict == 1].sum(), rel=1e-5)


def test_the_command_gives_the_same(tmp_path):
    scene = str(TESTDATA / "scenes/plank.toml")
    told = subprocess.run(
        [program(), "workspace", "-", "--orientation", "along", "--resolution", "0.1", "--format", "json"],
        input=(TESTDATA / "scenes/plank.toml").read_text(), capture_output=True, text=True, check=True, cwd=TESTDATA / "scenes",
    )  # fmt: skip
    found = cdpr.workspace(cdpr.Scene.load(scene), orientation="along", resolution=0.1)
    report = json.loads(told.stdout)
    assert (report["volume"], report["boxes"]) == (found.volume._asdict(), len(found.verdict))
    assert report["orientation_name"] == "along"
    assert report["shares"].keys() == found.shares.keys()


def test_what_is_decided_until_ctrl_c_is_kept():
    scene = str(TESTDATA / "scenes/cogiro.toml")
    command = [program(), "workspace", scene, "--resolution", "0.001", "--format", "json"]
    running = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    time.sleep(1.5)
    running.send_signal(signal.SIGINT)
    clock = time.monotonic()
    out, _ = running.communicate()
    assert running.returncode == 130 and time.monotonic() - clock < 1.0
    assert json.loads(out)["ended"] == "interrupted"
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        threading.Timer(1.0, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        found = cdpr.workspace(cdpr.Scene.load(scene), resolution=0.001)
    finally:
        signal.signal(signal.SIGINT, before)
    assert found.ended == "interrupted" and found.undecided > 0


def test_a_budget_is_kept():
    clock = time.monotonic()
    found = cdpr.workspace(cdpr.example("cogiro"), budget=0.5)
    assert time.monotonic() - clock < 1.5 and found.ended == "budget"


def test_bad_questions_are_refused(tmp_path):
    scene = cdpr.example("hard1")
    for bad in ({"resolution": 0}, {"resolution": -1.0}, {"budget": 0}, {"threads": 0}, {"orientation": "tilted"}):
        with pytest.raises(cdpr.InputError, match=next(iter(bad))):
            cdpr.workspace(scene, **bad)
    with pytest.raises(cdpr.FileError, match=r"\.json, \.npz, \.vti or \.stl"):
        cdpr.workspace(scene, resolution=1).save(tmp_path / "w.html")


@pytest.mark.parametrize("valid_at", ["every", "any"])
def test_several_orientations(tmp_path, valid_at):
    scene = cdpr.Scene.load(TESTDATA / "scenes/plank.toml")
    names = ["along", "across"]
    found = cdpr.workspace(scene, orientations=names, valid_at=valid_at, resolution=0.1)
    rng = np.random.default_rng(4)
    places = found.lower + rng.random(found.lower.shape) * (found.upper - found.lower)
    each = np.array([scene.replace(orientation=name).states_valid(places) for name in names])
    valid = each.all(axis=0) if valid_at == "every" else each.any(axis=0)
    assert valid[found.verdict == 1].all() and not valid[found.verdict == -1].any()
    assert (found.verdict == 1).any() and (found.verdict == -1).any()
    assert found.valid_at == valid_at and len(found.orientations) == 2
    assert np.allclose(found.orientations[1], scene.replace(orientation="across").orientation)
    found.save(tmp_path / "w.json")
    written = json.loads((tmp_path / "w.json").read_text())
    assert written["orientation_name"] == "along" and written["more_orientations"][0]["name"] == "across"
    assert {cause["at"] for cause in written["causes"]} == {0, 1}
    command = [program(), "workspace", TESTDATA / "scenes/plank.toml", "--resolution", "0.1", "-o", tmp_path / "c.json"]
    several = ["--orientations", *names, "--valid-at", valid_at]
    told = subprocess.run([*command, *several], capture_output=True, text=True, check=True)
    assert (tmp_path / "c.json").read_bytes() == (tmp_path / "w.json").read_bytes()
    every = "every one" if valid_at == "every" else "any"
    first, second, *_ = told.stdout.splitlines()
    assert first == "plank: plank with 2 cables, 2 obstacles"
    assert second == f"positions valid at {every} of 2 orientations: along, across"
    one = subprocess.run([*command, "--orientations", "along"], capture_output=True, text=True, check=True)
    assert one.stdout.startswith('plank: plank with 2 cables, 2 obstacles, at "along"\nvolume')


def test_turns_between_orientations(tmp_path):
    scene = cdpr.Scene.load(TESTDATA / "scenes/plank.toml")
    names = ["along", "across"]
    found = cdpr.workspace(scene, orientations=names, valid_at="turns", resolution=0.05)
    every = cdpr.workspace(scene, orientations=names, resolution=0.05)
    assert 0 < found.volume.min <= found.volume.max <= every.volume.max + 1e-9
    assert found.valid_at == "turns" and len(found.orientations) == 10  # at most 10° apart
    ends = [found.orientations[0], found.orientations[-1]]
    np.testing.assert_allclose(ends, [scene.replace(orientation=name).orientation for name in names])
    middle = 0.5 * (found.lower + found.upper)
    at = np.linspace(0, len(middle) - 1, 200).astype(int)
    for place, verdict in zip(middle[at], found.verdict[at], strict=True):
        assert verdict == 0 or cdpr.check(scene, [place, place], ends).valid == (verdict == 1)
    assert cdpr.workspace(scene, orientations=names, valid_at="turns", resolution=0.05, threads=1) == found
    found.save(tmp_path / "w.json")
    given = json.dumps(scene.to_dict())
    command = [program(), "workspace", "-", "--orientations", *names, "--valid-at", "turns", "--resolution", "0.05", "-o", "c.json"]
    told = subprocess.run(command, input=given, capture_output=True, text=True, check=True, cwd=tmp_path)
    assert (tmp_path / "c.json").read_bytes() == (tmp_path / "w.json").read_bytes()
    assert told.stdout.splitlines()[1] == "positions valid during the turns from along to across; 10 orientations judged on the way"
    short = subprocess.run([*command, "-q", "--budget-ms", "200"], input=given, capture_output=True, text=True, cwd=tmp_path)
    assert short.returncode in (0, 1) and not short.stderr and json.loads((tmp_path / "c.json").read_text())["ended"] in ("budget", "complete")
    with pytest.raises(cdpr.InputError, match="orientations: found 1, expected at least two"):
        cdpr.workspace(scene, orientations=names[:1], valid_at="turns", resolution=0.5)
    one = [program(), "workspace", TESTDATA / "scenes/plank.toml", "--orientations", "along", "--valid-at", "turns"]
    refused = subprocess.run(one, capture_output=True, text=True)
    assert refused.returncode == 2 and "--orientations: found 1, expected at least two" in refused.stderr


def test_orientations_that_are_none_or_given_twice_are_refused():
    scene = cdpr.example("plank")
    for given, said in (
        ({"orientations": []}, "orientations: found none"),
        ({"orientations": "along"}, "orientations: found the text 'along', expected a sequence of orientations"),
        ({"orientations": ["along", "tilted"]}, "tilted"),
        ({"orientations": ["along"], "orientation": "across"}, "only one of the two"),
        ({"valid_at": "any"}, "without orientations"),
        ({"orientations": ["along"], "valid_at": "all"}, "valid_at: found"),
    ):
        with pytest.raises(cdpr.InputError, match=said):
            cdpr.workspace(scene, resolution=0.5, **given)
    one = cdpr.workspace(scene, orientations=["across"], resolution=0.2)
    assert one == cdpr.workspace(scene, orientation="across", resolution=0.2) and one.valid_at is None
    line = [program(), "workspace", TESTDATA / "scenes/plank.toml", "--valid-at", "any"]
    refused = subprocess.run(line, capture_output=True, text=True)
    assert refused.returncode == 2 and "--orientations" in refused.stderr
