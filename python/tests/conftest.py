"""Shared by the tests: the location of the test data, delivery of Ctrl-C, and pages in a browser."""

import os
import signal
from pathlib import Path

import pytest
from pages import browser, open_page  # noqa: F401 (fixtures)

import cdpr

ROOT = Path(__file__).resolve().parents[2]
TESTDATA = ROOT / "testdata"


def program() -> Path:
    """The program as built for the Rust tests, or as named by CDPR."""
    found = ROOT / os.environ.get("CDPR", "target/debug/cdpr")
    assert found.exists(), f"no {found}: build it by `make program`"
    return found


def pytest_configure() -> None:
    # A shell ignores SIGINT in processes that a script starts in the background, and their children inherit that.
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture
def hard1() -> cdpr.Scene:
    return cdpr.Scene.load(TESTDATA / "scenes/hard1.toml")


@pytest.fixture
def empty() -> cdpr.Scene:
    return cdpr.Scene.load(TESTDATA / "scenes/empty.toml")


@pytest.fixture(scope="module")
def cogiro() -> cdpr.Scene:
    return cdpr.Scene.load(TESTDATA / "scenes/cogiro.toml")
