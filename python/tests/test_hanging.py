"""Certificates of scenes whose cables sag, run round pulleys, or leave the frame near their outlets.

crates/cdpr-certify/tests/hanging.rs and pulleys.rs make them; CDPR_HANGING, CDPR_PULLEYS and CDPR_PULLEYS_POINTS name files that these
wrote, to be judged instead of the few stored ones.
"""

import copy
import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cdpr
from cdpr._certify import check_certificate
from cdpr._certify._bodies import vertices_of
from cdpr._certify._cables import cable_of
from cdpr._certify._hulls import Hull, nearest_points
from cdpr._certify._vectors import exact

DATA = Path(__file__).parent / "data"

Table = dict[str, Any]


def slit(height: float, **cable: Any) -> Table:
    """A slit between two blocks, which the cable must pass on the way from start to goal."""

    def block(name: str, low: float, high: float) -> Table:
        return {"name": name, "box": [0.01, 0.002, high - low], "position": [0.007, 1.0, (low + high) / 2]}

    return {
        "version": 1,
        "workspace": {"min": [0.8, 0.0, 0.6], "max": [2.0, 2.0, 1.4]},
        "robot": {
            "platform": [{"vertices": [[0.0, 0.0, 0.0]]}],
            "cables": [{"outlet": [0.0, 1.0, 1.0], "attachment": [0.0, 0.0, 0.0], **cable}],
        },
        "obstacles": [block("lower", -3.0, 1.0 - height / 2), block("upper", 1.0 + height / 2, 5.0)],
        "query": {"start": [0.85, 0.05, 1.0], "goal": [0.85, 1.95, 1.0]},
    }


def judged(scene: Table, certificate: Table, fingerprint: str | None) -> str:
    """Why a certificate is refused, or nothing if it is accepted."""
    try:
        check_certificate(scene, certificate, fingerprint)
    except ValueError as problem:
        assert len(str(problem)) < 1000
        return str(problem) or "."
    return ""


@pytest.mark.parametrize("name", ["hanging", "pulleys"])
def test_both_checkers_judge_alike(name):
    counts = [0, 0]
    lines = Path(os.environ.get(f"CDPR_{name.upper()}") or DATA / f"{name}.jsonl").read_text().splitlines()
    for number, line in enumerate(lines):
        scene, certificate, others = json.loads(line)
        assert not judged(scene, certificate, certificate["scene"]), number
        for other, accepted in others:
            problem = judged(other, certificate, None)
            if accepted != (not problem):
                pytest.fail(f"scene {number}: Rust says {accepted}, Python {problem!r}")
            counts[accepted] += 1
    assert min(counts) > 0


@pytest.fixture(scope="module")
def proved(tmp_path_factory) -> tuple[Table, Table]:
    """A scene that has no path because its cable sags, and the certificate."""
    spec = slit(0.0005, linear_density=0.1, tension=[25.0, 100.0])
    scene = cdpr.Scene.from_dict(spec)
    file = tmp_path_factory.mktemp("proof") / "proof.json"
    found = cdpr.plan(scene)
    assert found.status == "no_path"
    found.proof.save(file)
    assert cdpr.check_proof(scene, file)
    assert cdpr.plan(cdpr.Scene.from_dict(slit(0.0005))).status == "solved"
    return scene.to_dict(), json.loads(file.read_text())


@pytest.mark.parametrize(
    "changes",
    [
        {"linear_density": 0.0},
        {"linear_density": 0.05},
        {"sag_tension": 60.0},
        {"tension": [60.0, 100.0]},
    ],
)
def test_less_sag_is_refused(proved, changes):
    scene, file = copy.deepcopy(proved[0]), proved[1]
    scene["robot"]["cables"][0].update(changes)
    assert "beyond the positions" in judged(scene, file, None)


def test_defaults_of_all_cables_count(proved):
    scene, file = copy.deepcopy(proved[0]), proved[1]
    cable = scene["robot"]["cables"][0]
    scene["robot"]["cable"] = {"linear_density": cable.pop("linear_density"), "sag_tension": 25.0}
    cable["tension"] = [1.0, 100.0]
    assert not judged(scene, file, None)
    cable["sag_tension"] = 60.0
    assert "beyond the positions" in judged(scene, file, None)
    assert "beyond the positions" in judged({**proved[0], "gravity": [0.0, 0.0, -5.0]}, file, None)


def test_cables_that_hang_too_low_and_unknown_keys_are_refused(proved):
    scene, file = copy.deepcopy(proved[0]), proved[1]
    cable = scene["robot"]["cables"][0]
    cable["linear_density"] = 1.0
    assert "hangs too low" in judged(scene, file, None)
    cable.update(linear_density=0.1, twist=1.0)
    assert "the key 'twist', which this checker does not know" in judged(scene, file, None)


def pulley_scenes() -> Iterator[tuple[Table, list[Any], list[Any]]]:
    """Scenes, positions that the checker in Rust judged, and the corners around all exits of each cable."""
    file = Path(os.environ.get("CDPR_PULLEYS_POINTS") or DATA / "pulley-points.jsonl")
    return (json.loads(line) for line in file.read_text().splitlines())


def test_exits_are_those_of_the_scene_and_never_beyond():
    count = 0
    for scene, _, stored in pulley_scenes():
        parts = [Hull(vertices_of(part)) for part in scene["robot"]["platform"]]
        for k, exits in enumerate(stored):
            if exits is None:
                continue
            own = Hull(cable_of(scene, k, exact(scene["robot"]["cables"][k]["attachment"]), parts).exits)
            known = Hull(tuple(exact(p) for p in exits))
            assert all(nearest_points(Hull((p,)), known)[1] < 1e-9 for p in own.points)
            assert all(nearest_points(Hull((p,)), own)[1] < 2e-9 for p in known.points)
            count += len(own.points)
    assert count > 100


def test_real_exits_are_among_those_of_the_scene():
    spec = slit(0.01, pulley={"radius": 0.05, "axis": [0.0, 0.0, 1.0]})
    scene = cdpr.Scene.from_dict(spec)
    parts = [Hull(vertices_of(part)) for part in spec["robot"]["platform"]]
    exits = Hull(cable_of(spec, 0, exact([0.0, 0.0, 0.0]), parts).exits)
    low, high = (np.array(spec["workspace"][key]) for key in ("min", "max"))
    for position in low + (high - low) * np.random.default_rng(3).random((200, 3)):
        # The cable leaves the wheel along its pull, at a distance of the radius from the axle.
        line = position - [0.0, 1.0, 1.0]
        side, distance = line[:2] / np.hypot(*line[:2]), np.hypot(*line[:2])
        free = np.sqrt(distance * (distance - 0.1) + line[2] ** 2)
        wrap = 2 * np.arctan2(distance, line[2] + free)
        exit_ = [0.0, 1.0, 1.0] + 0.05 * np.array([*(1 - np.cos(wrap)) * side, np.sin(wrap)])
        assert scene.robot.cable_lengths(position)[0] == pytest.approx(0.05 * wrap + free, abs=1e-12)
        assert nearest_points(Hull((exact(exit_.tolist()),)), exits)[1] < 2e-9


def judged_forbidden(scene: Table, points: list[Any]) -> str:
    """Why not all of the small boxes around these positions are accepted as forbidden."""
    half = 1e-6

    def around(at: list[float]) -> list[list[float]]:
        return [[*(sign * (k == i) for i in range(3)), sign * at[k] + half] for k in range(3) for sign in (1.0, -1.0)]

    file = {
        "format": "cdpr-bound", "version": 1, "scene": "", "margin": 1e-7, "length": 0.1, "box": [[-9.0] * 3, [9.0] * 3],
        **{key: scene["query"][key] for key in ("orientation", "start", "goal")}, "edges": [], "corners": [],
        "regions": [{"who": who, "half_spaces": around(at)} for who, at, _ in points],
    }  # fmt: skip
    return judged(scene, file, None)


def test_positions_are_judged_alike():
    counts = [0, 0]
    for number, (scene, points, _) in enumerate(pulley_scenes()):
        forbidden, free = ([point for point in points if point[2] == verdict] for verdict in (True, False))
        # Bends come last: a free edge or corner in the list of them says that all regions are accepted.
        problem = judged_forbidden(scene, forbidden)
        assert not problem or "that is free" in problem, f"{number} {problem}"
        for point in free:
            assert "forbid" in judged_forbidden(scene, [point]), f"{number} {point}"
        counts = [counts[0] + len(free), counts[1] + len(forbidden)]
    assert min(counts) > 0


def test_pulleys_have_certificates(tmp_path):
    spec = json.loads((DATA / "pulleys.jsonl").read_text().splitlines()[0])[0]
    pulley = spec["robot"]["cables"][0]["pulley"]
    scene, file = cdpr.Scene.from_dict(spec), tmp_path / "proof.json"
    found = cdpr.plan(scene)
    assert found.status == "no_path"
    found.proof.save(file)
    assert cdpr.check_proof(scene, file)
    certificate = json.loads(file.read_text())
    for changed in (None, {**pulley, "radius": 0.01}, {**pulley, "axis": [1.0, 0.0, 0.0]}):
        other = copy.deepcopy(scene.to_dict())
        other["robot"]["cables"][0]["pulley"] = changed
        assert judged(other, certificate, None)
    assert cdpr.lower_bound(scene, goal=[0.9, 0.05, 1.0], certificate=file) > 0
    assert cdpr.check_proof(scene, file, goal=[0.9, 0.05, 1.0])


@pytest.mark.parametrize(("force", "radius", "lacks"), [(1.8, 0.0, True), (2.1, 0.3, False), (2.2, 0.3, True)])
def test_wrenches_lack_only_from_wherever_cables_leave_their_pulleys(force, radius, lacks):
    """In the middle, two cables together pull to no side; in the box, one on a large wheel may pull farther aside."""
    pulley = {"radius": radius, "axis": [0.0, 0.0, -1.0]} if radius else None
    cables = [
        {"outlet": [x, 0.0, 2.0], "attachment": [0.1 * x, 0.0, 0.0], "tension": [1.0, 100.0]} for x in (-2.0, 2.0)
    ]
    low, high = [-1.0, -0.01, 1.0], [1.0, 0.01, 1.02]
    scene = {
        "version": 1,
        "workspace": {"min": low, "max": high},
        "wrench": {"force": force},
        "robot": {
            "mass": 1.0,
            "platform": [{"vertices": [[0.0, 0.0, 0.0]]}],
            "cable": {"pulley": pulley},
            "cables": cables,
        },
    }

    def box(start: float, end: float, *verdict: Any) -> list[Any]:
        return [start, *low[1:], end, *high[1:], *verdict]

    certificate = {
        "format": "cdpr-proof",
        "version": 1,
        "scene": "0" * 64,
        "orientation": [1.0, 0.0, 0.0, 0.0],
        "margin": 1e-6,
        "start": [-0.5, 0.0, 1.01],
        "goal": [0.5, 0.0, 1.01],
        "box": [low, high],
        "regions": [],
        "boxes": [
            box(-1.0, -0.01, -1),
            box(-0.01, 0.01, -2, ["wrench", 0, 1, 0, 0, 0, 0]),
            box(0.01, 1.0, -1),
        ],
    }
    problem = judged(scene, certificate, None)
    assert not problem if lacks else "boxes[1]: not all" in problem
