"""The names that the core defines are the same in Python's types and on the page."""

import re
from pathlib import Path
from typing import get_args

import pytest
from conftest import TESTDATA

import cdpr
from cdpr import _planning, _questions, _search

ROOT = Path(__file__).resolve().parents[2]


def known_names(**choice: str) -> list[str]:
    """The names that the core accepts instead of a wrong one."""
    scene = cdpr.Scene.load(TESTDATA / "scenes/hard1.toml")
    with pytest.raises(ValueError, match="expected one of") as error:
        cdpr.plan(scene, **choice)
    return re.findall(r"[\w-]+", str(error.value).partition("expected one of")[2])


@pytest.mark.parametrize(
    ("argument", "names"),
    [
        ("planner", _search.Planner),
        ("post", _search.Post),
        ("engine", _questions.Engine),
        ("interference", _questions.Interference),
        ("minimise", _planning.Minimise),
        ("maximise", _planning.Maximise),
    ],
)
def test_types_list_the_names_of_the_core(argument, names):
    assert set(get_args(names)) == set(known_names(**{argument: "?"}))


def test_the_page_offers_every_planner():
    listed = re.search(r"const PLANNERS = \[(.*)\]", (ROOT / "viewer/src/edit/toolbar.js").read_text())[1]
    assert re.findall(r"[\w-]+", listed) == list(get_args(_search.Planner))


def test_the_page_has_a_sentence_for_every_condition():
    kinds = (ROOT / "crates/cdpr-core/src/conditions/physical.rs").read_text().partition("pub enum Kind {")[2].partition("}")[0]
    kinds = {re.sub(r"(?<!^)([A-Z])", r"-\1", kind).lower() for kind in re.findall(r"^    (\w+),$", kinds, re.MULTILINE)}
    pairs = {"cable-platform", "cable-cable", "platform-obstacle", "cable-obstacle"}  # "cable 3 meets pillar"
    assert pairs < kinds
    sentences = (ROOT / "viewer/src/wording.js").read_text().partition("const SENTENCES = {")[2].partition("\n};")[0]
    assert set(re.findall(r"^  '?([\w-]+)'?:", sentences, re.MULTILINE)) == kinds - pairs
