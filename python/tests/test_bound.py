"""The checker of certificates of bounds accepts true bounds, and nothing else."""

import copy
import json
import math
import random
import subprocess
import time
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import Any

import pytest

import cdpr
from cdpr._certify import check_certificate
from cdpr._certify._bodies import rotated
from cdpr._certify._hulls import Hull, _between_floats, are_near, nearest_points
from cdpr._certify._vectors import exact, plus
from conftest import TESTDATA, program

DATA = Path(__file__).parent / "data"
PATH = 2.5918  # m: length of a path of the sample

Table = dict[str, Any]


def sample() -> tuple[Table, Table]:
    """A scene with three prisms, and a certificate of a bound."""
    scene, file = (json.loads((DATA / f"bound-three{end}.json").read_text()) for end in (".scene", ""))
    return scene, file


def refused(scene: Table, file: Table | str, reason: str = ".") -> None:
    with pytest.raises(ValueError, match=reason) as problem:
        check_certificate(scene, file, None)
    assert len(str(problem.value)) < 500


def test_sample_is_a_proof():
    scene, file = sample()
    check_certificate(scene, file, file["scene"])
    check_certificate({**scene, "query": None}, json.dumps(file), None)
    assert PATH / 1.011 < file["length"] < PATH


@pytest.mark.long
def test_damages_are_refused():
    scene, file = sample()
    draw = random.Random(1)
    long = [k for k, edge in enumerate(file["edges"]) if math.dist(*edge["ends"]) > 0.05]
    needed = [k for k in long[:12] if not accepts(scene, {**file, "edges": file["edges"][:k] + file["edges"][k + 1 :]})]
    assert len(needed) > 3
    for round_ in range(36):
        damaged = copy.deepcopy(file)
        edge = damaged["edges"][draw.choice(needed)]
        match round_ % 6:
            case 0:
                damaged["length"] = PATH + draw.random()
            case 1:
                damaged["edges"].remove(edge)
            case 2:
                edge["ends"][draw.randrange(2)][draw.randrange(3)] += 1e-3
            case 3:
                for row in draw.choice(damaged["regions"])["half_spaces"]:
                    row[3] += 1e-5
            case 4:
                damaged["start"][draw.randrange(3)] += 1e-6
            case 5:
                damaged["length"] += 0.1
                for piece in (piece for other in damaged["edges"] for piece in other["pieces"]):
                    piece[1] += 0.1
                    piece[2] += 0.1
        refused(scene, damaged)


def accepts(scene: Table, file: Table) -> bool:
    try:
        check_certificate(scene, file, None)
    except ValueError:
        return False
    return True


def test_ends_are_in_the_box_and_in_no_region():
    point = {"platform": [{"vertices": [[0, 0, 0]]}], "cables": [{"outlet": [0, 0, 2], "attachment": [0, 0, 0]}]}
    workspace = {"min": [-1, -1, -1], "max": [3, 1, 1]}
    wall = {"name": "wall", "box": [0.5, 1, 4], "position": [0.75, 0, 0]}
    scene = {"version": 1, "workspace": workspace, "robot": point, "obstacles": [wall]}
    within = [[-1, 0, 0, -0.5], [1, 0, 0, 1], [0, -1, 0, 0.5], [0, 1, 0, 0.5]]
    file = {"format": "cdpr-bound", "version": 1, "scene": "", "orientation": [1, 0, 0, 0], "margin": 1e-6}
    file |= {"goal": [2, 0, 0], "edges": [], "corners": []}

    def told(start: list[float], floor: float, half_spaces: list[list[float]], length: float, reason: str) -> None:
        region = {"who": ["platform", "wall"], "half_spaces": half_spaces}
        box = [[-1, -1, floor], [3, 1, 1]]
        refused(scene, {**file, "start": start, "length": length, "box": box, "regions": [region]}, reason)

    # The box may lack rounding errors; no more, or a slit below the wall would lie outside.
    under = [[0, 0, 1, -1 + 0.4e-12], [0, 0, -1, 1.1]]
    told([0, 0, -1], -1 + 0.9e-12, under, 999, r"start: found \[0.0, 0.0, -1.0\], expected it in the box")
    told([0, 0, 0], -1 + 0.9e-12, under, 999, r"regions\[0\].half_spaces: found no position of the box in them")
    told([0, 0, 0], -1 + 0.9e-6, under, 999, "box: found -0.9999991 to 1.0 along z, expected at least -1.0 to 1.0")
    for x in (0.75, 0.5 + 1e-9):
        told([x, 0, 0], -1, within, 999, r"start: found it inside regions\[0\], expected it in no region")


def test_distances_of_needles_and_thin_plates_are_proved():
    """Rounding misleads the search for nearest points there. Where it does, an exact search decides."""
    generator = random.Random(1)
    stalled = 0
    for _ in range(200):
        half = [10 ** generator.uniform(-6, -3), 10 ** generator.uniform(-6, -3), 0.5]
        turn = [generator.gauss(0, 1) for _ in range(4)]
        corners = rotated([exact(corner) for corner in product(*((-x, x) for x in half))], tuple(turn)).points
        center = exact([generator.uniform(0.3, 1.7) for _ in range(3)])
        plate = Hull(tuple(exact([float(x) for x in plus(corner, center)]) for corner in corners))
        end, share = plate.points[0], Fraction(generator.uniform(1, 2))
        aim = plus(end, exact([generator.gauss(0, 1e-8) for _ in range(3)]))
        needle = Hull((exact((0, 0, 0)), exact([float(x * share) for x in aim])))
        distance = cdpr.distance([[float(x) for x in p] for p in needle.points], [[float(x) for x in p] for p in plate.points])
        weights, found = nearest_points(needle, plate)
        assert abs(found - max(distance, 0)) < 1e-12
        assert are_near(needle, plate, Fraction(found + 1e-13)) and not are_near(needle, plate, Fraction(found - 1e-13))
        stalled += math.hypot(*_between_floats(needle, plate, weights)) > found + 1e-12
    assert stalled, "no case needs the exact search"


def test_bad_contents_are_named_in_bounded_time():
    scene, file = sample()
    refused(scene, {**file, "version": 2}, "version: found 2")
    refused(scene, {**file, "length": math.nan}, "length: found nan")
    refused(scene, {**file, "length": 2000.0}, "expected numbers up to 1000")
    refused(scene, {**file, "more": 1}, "unknown key 'more'")
    refused(scene, {**file, "corners": [[0.0, 0.0, 0.0]]}, "corners: found 3 items")
    refused(scene, {**file, "edges": []}, "an edge that is free")
    first, *others = file["edges"]
    for key, value, reason in [
        ("region", 99, "found region 99"),
        ("region", True, "found region True"),
        ("planes", [0, 99], "found half-spaces"),
        ("pieces", [[0.5, 0.0, 0.0]], "do not end one after another"),
        ("pieces", [[0.5, 0.0, 0.0]] * 10_000_000, "expected 1 to 10000"),
    ]:
        began = time.monotonic()
        refused(scene, {**file, "edges": [{**first, key: value}, *others]}, reason)
        assert time.monotonic() - began < 10
    text = json.dumps(file)
    for end in range(0, len(text), 1999):
        refused(scene, text[:end])


@pytest.mark.parametrize(("slit", "finite"), [(2e-7, True), (2e-8, False)])
def test_a_bound_is_infinite_only_beyond_its_own_margin(slit, finite):
    """Planning proves that no path keeps 1e-6 m; a bound is about all that keep 1e-7 m."""
    y, z = 0.08 + slit, 0.05 + slit
    bars = [
        ("left", 0.6, 4, -y - 0.3, 0),
        ("right", 0.6, 4, y + 0.3, 0),
        ("below", 2 * y, 0.6, 0, -z - 0.3),
        ("above", 2 * y, 0.6, 0, z + 0.3),
    ]
    scene = cdpr.Scene.from_dict(
        {
            "version": 1,
            "workspace": {"min": [-0.45] * 3, "max": [0.45] * 3},
            "robot": {
                "platform": [{"box": [0.2, 0.16, 0.1]}],
                "cables": [{"name": "cable", "outlet": [0, 0, 5], "attachment": [0, 0, 0.05]}],
            },
            "obstacles": [
                {"name": name, "box": [0.2, width, height], "position": [0, *at]} for name, width, height, *at in bars
            ],
            "ignore": [["cable", name] for name, *_ in bars],
            "query": {"start": [-0.32, 0.01, 0.02], "goal": [0.32, -0.02, 0.01]},
        }
    )
    assert cdpr.plan(scene).status == "no_path"
    assert math.isfinite(cdpr.lower_bound(scene, budget=5)) == finite


def test_lower_bound_writes_a_certificate(tmp_path):
    scene = cdpr.Scene.load(TESTDATA / "scenes/hard1.toml")
    file = tmp_path / "bound.json"
    bound = cdpr.lower_bound(scene, gap=0.001, certificate=file)
    assert cdpr.plan(scene).cost / bound < 1.0011
    assert json.loads(file.read_text())["length"] == bound
    assert cdpr.check_proof(scene, file)
    with pytest.raises(cdpr.FileError, match="another scene"):
        cdpr.check_proof(scene.without("pillar"), file)
    closed = cdpr.Scene.load(TESTDATA / "scenes/closed.toml")
    with pytest.raises(cdpr.CdprError, match="nothing to certify"):
        cdpr.lower_bound(closed, gap=0.01, budget=5, certificate=file)


def with_wrenches(tmp_path: Path, pulley: Table | None = None, gap: float = 0.03) -> tuple[Table, Table, int]:
    """A scene whose wrenches close the shorter paths, a certificate, and the index of a region where wrenches lack."""
    spec = cdpr.Scene.load(TESTDATA / "scenes" / "mpi_simulator.toml").to_dict()
    scene = cdpr.Scene.from_dict({**spec, "robot": {**spec["robot"], "cable": {"pulley": pulley}}} if pulley else spec)
    bound = cdpr.lower_bound(scene, gap=gap, certificate=tmp_path / "bound.json")
    assert cdpr.check_proof(scene, tmp_path / "bound.json")
    file = json.loads((tmp_path / "bound.json").read_text())
    lacking = [k for k, region in enumerate(file["regions"]) if region["who"] == ["wrench"]]
    assert file["length"] == pytest.approx(bound) and bound > 7.5 and lacking
    return scene.to_dict(), file, lacking[0]


def test_certificates_count_required_wrenches(tmp_path):
    scene, file, region = with_wrenches(tmp_path)
    check_certificate(scene, file, None)

    def damaged(change: Any, reason: str) -> None:
        other = copy.deepcopy(file)
        change(other["regions"][region], other)
        refused(scene, other, reason)

    boxes = file["regions"][region]["boxes"]
    plane = file["regions"][region]["half_spaces"][-1]
    ends = file["start"], file["goal"]
    centers = [[(box[k] + box[k + 3]) / 2 for k in range(3)] for box in boxes]
    counting = [
        k
        for k, center in enumerate(centers)
        if len(boxes[k]) == 31
        and sum(n * x for n, x in zip(plane[:3], center, strict=True)) < plane[3]
        and sum(math.dist(center, end) for end in ends) < file["length"]
    ]
    assert len(counting) > 20
    for k in counting[::28]:
        damaged(lambda found, _, k=k: found["boxes"].pop(k), "boxes")
        damaged(lambda found, _, k=k: found["boxes"].__setitem__(k, boxes[k][:6]), f"boxes.{k}.: found no direction")
        weak = f"boxes.{k}.: found no proof"
        for row in (
            [*boxes[k][:6], *(-x for x in boxes[k][6:])],
            [*boxes[k][:6], *boxes[k][9:12], *boxes[k][6:9], *boxes[k][12:]],
            [*boxes[k][:6], *[0.0] * 25],
        ):
            damaged(lambda found, _, k=k, row=row: found["boxes"].__setitem__(k, row), weak if row[30] >= 0 else "weight|no proof")
    damaged(lambda found, _: found.update(boxes=[]), "boxes: found none")
    damaged(lambda found, _: found.update(half_spaces=found["half_spaces"][:-1]), "boxes")
    damaged(lambda found, _: found["half_spaces"][-1].__setitem__(3, plane[3] + 1.0), "boxes")
    damaged(lambda found, _: found.update(who=["platform"]), "boxes")
    (low, high), larger = file["box"], 0
    for side, (*normal, offset) in enumerate(file["regions"][region]["half_spaces"][:-1]):
        axis = max(range(3), key=lambda k: abs(normal[k]))
        if offset < (high[axis] if normal[axis] > 0 else -low[axis]):
            damaged(lambda found, _, k=side: found["half_spaces"][k].__setitem__(3, 1e3), "of the region in none")
            larger += 1
    assert larger > 0
    damaged(lambda found, _: found["boxes"][0].pop(), "expected 6 or 31|at least|found")
    damaged(lambda _, whole: whole.update(length=whole["length"] * 1.2), "found no direction")
    refused({**scene, "wrench": {**scene["wrench"], "force": 0.0}}, file, "found no proof")
    refused({**scene, "wrench": None}, file, "no certified requirement")


def test_certificates_count_wrenches_round_pulleys(tmp_path):
    scene, file, _ = with_wrenches(tmp_path, {"radius": 0.05, "axis": [0.0, 0.0, 1.0]}, gap=0.05)
    check_certificate(scene, file, None)
    # Cables that leave their pulleys elsewhere, or of which less is known.
    for pulley in ({"radius": 0.3, "axis": [0.0, 0.0, 1.0]}, {"radius": 0.05, "axis": [0.6, 0.0, -0.8]}):
        refused({**scene, "robot": {**scene["robot"], "cable": {"pulley": pulley}}}, file)


@pytest.mark.long
@pytest.mark.parametrize("pulley", [None, {"radius": 0.05, "axis": [0.0, 0.0, 1.0]}])
def test_checkers_agree_on_damaged_wrench_boxes(tmp_path, pulley):
    """Both checkers reach the same verdict on every changed certificate."""
    scene, file, region = with_wrenches(tmp_path, pulley, gap=0.05)
    draw, agreed = random.Random(3), [0, 0]
    directed = [k for k, box in enumerate(file["regions"][region]["boxes"]) if len(box) == 31]
    (tmp_path / "scene.json").write_text(json.dumps(scene))
    for _ in range(15):
        other = copy.deepcopy(file)
        row = other["regions"][region]["boxes"][draw.choice(directed)]
        kind = draw.randrange(3)
        for k in (range(6, 12), range(12, 30), range(30, 31))[kind]:
            row[k] *= 1 + draw.choice((0.02, 0.3, 3.0)) * draw.uniform(-1, 1)
        (tmp_path / "other.json").write_text(json.dumps(other))
        command = [program(), "check", tmp_path / "scene.json", tmp_path / "other.json"]
        by_rust = subprocess.run(command, capture_output=True, check=False).returncode == 0
        assert accepts(scene, other) == by_rust, (kind, row)
        agreed[by_rust] += 1
    assert min(agreed) > 2, agreed
