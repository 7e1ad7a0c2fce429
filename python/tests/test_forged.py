"""Certificates that are false on purpose: the checker in Python refuses what the one in Rust refuses, and accepts what it accepts.

crates/cdpr-certify/tests/forged.rs makes them; CDPR_FORGED names a file that it wrote, to be judged instead of the few stored ones.
"""

import json
import os
from pathlib import Path
from typing import Any

import pytest

from cdpr._certify import check_certificate

DATA = Path(__file__).parent / "data"


def judged(scene: dict[str, Any], certificate: dict[str, Any]) -> str:
    """Why a certificate is refused, or nothing if it is accepted."""
    try:
        check_certificate(scene, certificate, certificate["scene"])
    except ValueError as problem:
        assert len(str(problem)) < 1000
        return str(problem) or "."
    return ""


def test_both_checkers_judge_alike():
    cases = Path(os.environ.get("CDPR_FORGED") or DATA / "forged.jsonl").read_text().splitlines()
    counts = [0, 0]
    for number, line in enumerate(cases):
        case = json.loads(line)
        for k, (certificate, accepted) in enumerate(case["certificates"]):
            problem = judged(case["scene"], certificate)
            if accepted != (not problem):
                pytest.fail(f"scene {number}, certificate {k}: Rust says {accepted}, Python {problem!r}")
            counts[accepted] += 1
            assert not (accepted and certificate["format"] == "cdpr-proof")  # every scene has a path
    assert min(counts) > 0
