"""Certificates of scenes whose cables sag, or leave the frame near their outlets.

crates/cdpr-certify/tests/hanging.rs makes them; CDPR_HANGING names a file that it wrote, to be judged instead of the few stored ones.
"""

import copy
import json
import os
from pathlib import Path
from typing import Any

import pytest

import cdpr
from cdpr._certify import check_certificate

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


def test_both_checkers_judge_alike():
    counts = [0, 0]
    lines = Path(os.environ.get("CDPR_HANGING") or DATA / "hanging.jsonl").read_text().splitlines()
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


def test_pulleys_have_no_certificates(tmp_path):
    pulley = {"radius": 1e-4, "axis": [0.0, 0.0, 1.0]}
    spec = slit(1e-4, outlet_error=1e-4)
    file = tmp_path / "proof.json"
    cdpr.plan(cdpr.Scene.from_dict(spec)).proof.save(file)
    for own in (True, False):
        turned = copy.deepcopy(spec)
        turned["robot"].setdefault("cable", {})
        (turned["robot"]["cables"][0] if own else turned["robot"]["cable"])["pulley"] = pulley
        assert "runs round a pulley" in judged(turned, json.loads(file.read_text()), None)
        scene = cdpr.Scene.from_dict(turned)
        found = cdpr.plan(scene)
        if found.status == "no_path":
            with pytest.raises(cdpr.CdprError, match="runs round a pulley"):
                found.proof.save(tmp_path / "none.json")
        with pytest.raises(cdpr.CdprError, match="pulley"):
            cdpr.lower_bound(scene, goal=[0.9, 0.05, 1.0], certificate=tmp_path / "none.json")
        assert not (tmp_path / "none.json").exists()
