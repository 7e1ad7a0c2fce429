"""The workflow of docs/howto/stations.md: its results, and that paths there and back have equal lengths."""

import itertools
import time
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT
from sybil import Sybil
from sybil.parsers.markdown import CodeBlockParser
from test_docs import Page

import cdpr

CABLES = ["SW low", "SW high", "NW low", "NW high", "NE low", "NE high", "SE low", "SE high"]
STATIONS = {
    "conveyor": [2.0, 6.0, 0.8],
    "mill": [7.5, 4.0, 0.9],
    "rack": [10.5, 6.5, 0.3],
    "pallet": [2.0, 2.0, 0.2],
    "bench": [10.0, 2.0, 0.1],
    "washer": [6.0, 1.5, 0.8],
}
PAIRS = list(itertools.permutations(STATIONS, 2))

pytestmark = [
    pytest.mark.long,
    pytest.mark.filterwarnings("ignore::cdpr.CdprWarning"),  # how the parts of the mill's mesh fill it
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The engineer's folder after all steps of the page."""
    folder = tmp_path_factory.mktemp("stations")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        page = Page(folder)
        parsers = [CodeBlockParser(language, evaluator) for language, evaluator in page.evaluators().items()]
        start = time.perf_counter()
        for example in Sybil(parsers).parse(ROOT / "docs/howto/stations.md").examples():
            example.evaluate()
        assert time.perf_counter() - start < 60  # takes a third of this on an idle machine
    return folder


@pytest.fixture
def hall(folder: Path) -> cdpr.Scene:
    return cdpr.Scene.load(folder / "hall.toml")


def test_every_ordered_pair_of_stations_has_a_valid_path(folder: Path, hall: cdpr.Scene) -> None:
    assert {path.stem for path in (folder / "paths").iterdir()} == {f"{a}-{b}" for a, b in PAIRS}
    for start, goal in PAIRS:
        path = cdpr.load_path(folder / f"paths/{start}-{goal}.json")
        assert path.waypoints[0].tolist() == STATIONS[start] and path.waypoints[-1].tolist() == STATIONS[goal]
        report = cdpr.check(hall, path, strict=True)
        assert report.valid, f"{start} to {goal}: {report}"
        assert report.min_clearance_not_exempt is not None and report.min_wrench_margin is not None
        assert report.min_clearance_not_exempt["value"] >= 0.05 - 1e-7
        assert report.min_wrench_margin["value"] >= 0.0


def test_cable_lengths_along_the_paths_are_distances_from_the_outlets(folder: Path, hall: cdpr.Scene) -> None:
    assert list(hall.robot.cable_names) == CABLES
    for start, goal in PAIRS:
        along = cdpr.tensions_along(hall, cdpr.load_path(folder / f"paths/{start}-{goal}.json"), step=0.05)
        lines = hall.robot.outlets - (along.positions[:, None] + hall.robot.attachments)
        assert np.allclose(along.lengths, np.linalg.norm(lines, axis=2), rtol=0, atol=1e-9)


@pytest.mark.parametrize("pair", list(itertools.combinations(STATIONS, 2)), ids="-".join)
def test_there_and_back_take_ways_of_one_length(folder: Path, pair: tuple[str, str]) -> None:
    there, back = (cdpr.load_path(folder / f"paths/{a}-{b}.json").cost for a, b in (pair, pair[::-1]))
    assert there == pytest.approx(back, rel=0.01)
