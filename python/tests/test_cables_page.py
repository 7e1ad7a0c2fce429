"""Cables with pulleys and weight in the page: as they run and hang, or straight."""

from typing import Any

import pytest
from pages import Open, picture

import cdpr

WEIGHT = {"linear_density": 0.1, "sag_tension": 30.0}
PULLEY = {"pulley": {"radius": 0.1, "axis": [0.0, 0.0, 1.0]}}
HANGING = "as low as they can hang"
ROUND = "round their pulleys"


def bent(scene: cdpr.Scene, cable: dict[str, Any]) -> cdpr.Scene:
    """The scene with cables that all have these keys."""
    spec = scene.to_dict()
    return cdpr.Scene.from_dict(spec | {"robot": spec["robot"] | {"cable": cable}})


@pytest.mark.parametrize(
    ("cable", "names"), [({}, []), (WEIGHT, [HANGING]), (PULLEY, [ROUND]), (WEIGHT | PULLEY, [HANGING])]
)
def test_the_switch_is_there_for_cables_that_bend(
    open_page: Open, empty: cdpr.Scene, cable: dict[str, Any], names: list[str]
) -> None:
    page = open_page(bent(empty, cable), live=False)
    found = page.locator(".legend-row .legend-name").all_inner_texts()
    assert [name for name in found if name in (HANGING, ROUND)] == names
    assert page.evaluate("'hanging' in cdprViewer.layers") == bool(names)
    if not names:
        return
    before = picture(page)
    switch = page.get_by_label(names[0], exact=True)
    switch.uncheck()
    straight = picture(page)
    assert straight != before
    switch.check()
    assert picture(page) == before


def test_a_cable_is_brought_out_where_it_hangs(open_page: Open, empty: cdpr.Scene) -> None:
    page = open_page(bent(empty, WEIGHT | PULLEY), [[0.4, 1.0, 1.0], [0.6, 1.0, 1.0]], live=False)
    row = page.locator("#cable-table tr").nth(5)
    pictures = [picture(page)]
    for _ in range(2):
        row.hover()
        pictures.append(picture(page))
        page.get_by_label(HANGING, exact=True).click()
    row.hover()
    assert picture(page) == pictures[1]
    assert len(set(pictures)) == 3
