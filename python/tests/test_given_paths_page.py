"""Pages of paths that were not planned, are not valid or have no length, and pages that cannot be edited, in a real browser."""

import subprocess
from pathlib import Path
from typing import Any

import pytest
from conftest import program
from pages import SCENES, STATUS, THROUGH_THE_PILLAR, Open, edit, settled, status, wait_until, where

import cdpr


def test_a_path_that_was_not_planned_stays_until_something_changes(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1, cdpr.plan(hard1).waypoints)
    edit(page)
    wait_until(page, "document.querySelector('.edit-text').textContent !== ''")
    assert status(page) == "this path stays until something changes"
    page.get_by_role("button", name="plan a new path").click()
    assert "above the shortest" in settled(page)
    assert not page.get_by_role("button", name="plan a new path").is_visible()


def test_a_path_that_is_not_valid_says_so_and_a_new_one_is_planned(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1, THROUGH_THE_PILLAR)
    edit(page)
    assert settled(page) == "this path is not valid (9 violations); it stays until something changes"
    page.get_by_role("button", name="plan a new path").click()
    wait_until(page, f"{STATUS}.dataset.kind === 'good'")
    assert page.locator("#status .chip").inner_text() == "solved"


@pytest.mark.parametrize("waypoints", [[[0.3, 1, 0.3]], [[0.3, 1, 0.3]] * 2, [[0.3, 1, 0.3], [1.7, 1, 1.7]], None])
def test_nothing_goes_wrong_without_length(open_page: Open, hard1: cdpr.Scene, waypoints: Any) -> None:
    page = open_page(hard1, waypoints)
    edit(page)
    page.wait_for_timeout(300)
    done = page.evaluate("cdpr.plan({ start: [0.3, 1, 0.3], goal: [0.3, 1, 0.3] })")
    assert (done["status"], done["cost"]) == ("solved", 0)
    page.wait_for_timeout(300)
    assert not page.locator("#plots").is_visible()
    assert "NaN" not in page.content().split('id="cdpr-data"')[0]


def test_the_bar_and_the_card_state_the_same_quality(open_page: Open, tmp_path: Path) -> None:
    made = tmp_path / "made.html"
    command = [program(), "plan", SCENES / "hard1.toml", "--html", made]
    subprocess.run(list(map(str, command)), check=True, capture_output=True)
    page = open_page(made)
    quality = page.locator("#remarks").inner_text().replace("\xa0", " ")
    assert "above the shortest" in quality
    edit(page)
    assert settled(page).endswith(f" · {quality}")


def test_charts_that_come_with_a_path_make_room_or_fold(open_page: Open, hard1: cdpr.Scene) -> None:
    inside = hard1.replace(start=[1, 1, 0.6])
    result = cdpr.plan(inside)
    for turned in [False, True]:
        page = open_page(inside, result, file=f"{turned}.html")
        page.mouse.move(640, 500)
        if turned:
            page.mouse.wheel(0, -200)
        edit(page)
        page.get_by_role("button", name="move to the nearest valid place").click()
        wait_until(page, f"{STATUS}.dataset.kind === 'good'")
        page.wait_for_timeout(300)
        assert page.evaluate("document.getElementById('plots').open") is not turned
        left, right = [where(page, name)[0] for name in ("outlet of cable 4", "outlet of cable 7")]
        free = page.evaluate("document.getElementById('plots').getBoundingClientRect().left")
        assert turned or (320 < left < right < free)


@pytest.mark.parametrize("kind", ["timed motion", "forbidden regions", "--static"])
def test_pages_that_only_show_say_why_on_key_e(open_page: Open, hard1: cdpr.Scene, tmp_path: Path, kind: str) -> None:
    if kind == "forbidden regions":
        made = tmp_path / "regions.html"
        subprocess.run([program(), "shadows", SCENES / "hard1.toml", "-o", made], check=True, capture_output=True)
        page = open_page(made)
    else:
        path = cdpr.plan(hard1)
        timed = kind == "timed motion"
        page = open_page(hard1, cdpr.trajectory(hard1, path, speed=1, acceleration=2) if timed else path, live=False)
    assert page.locator("#edit-missing").count() == 0
    page.keyboard.press("e")
    said = page.locator("#edit-missing").inner_text()
    assert kind in said and ("cdpr view" in said) is (kind != "--static")
