"""Shared by the tests: where the test data is."""

from pathlib import Path

import pytest

import cdpr

ROOT = Path(__file__).resolve().parents[2]
TESTDATA = ROOT / "testdata"


@pytest.fixture
def hard1() -> cdpr.Scene:
    return cdpr.Scene.load(TESTDATA / "scenes/hard1.toml")


@pytest.fixture
def empty() -> cdpr.Scene:
    return cdpr.Scene.load(TESTDATA / "scenes/empty.toml")
