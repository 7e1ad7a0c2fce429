"""What the page says of a path, in a real browser: the result card, charts, the table of cables, and violations."""

import json
import math
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
from conftest import program
from pages import THROUGH_THE_PILLAR, SCENES, Open, picture, plain
from playwright.sync_api import Page

import cdpr


@pytest.mark.long
def test_the_raw_path_is_listed_where_it_differs_from_the_final_one(open_page: Open, hard1: cdpr.Scene) -> None:
    rewound = cdpr.plan(hard1, "modified-rrt", seed=3)
    assert not np.array_equal(rewound.raw_waypoints, rewound.waypoints)
    for path, listed in [(rewound, True), (cdpr.plan(hard1), False)]:
        names = open_page(hard1, path).locator(".legend-name").all_inner_texts()
        assert ("raw path" in names) == listed


def test_via_points_are_numbered(open_page: Open, hard1: cdpr.Scene) -> None:
    path = cdpr.plan(hard1, via=[[1.0, 1.0, 1.8], [1.7, 1.0, 1.5]])
    labels = open_page(hard1, path).locator(".label", has_text=re.compile("^via "))
    assert labels.all_inner_texts() == ["via 1", "via 2"]
    first, second = (label.bounding_box() for label in labels.all())
    assert first is not None and second is not None and first["x"] != second["x"]
    assert open_page(hard1, cdpr.plan(hard1)).locator(".label", has_text=re.compile("^via ")).count() == 0


def scale_labels(page: Page, plot: str) -> list[float]:
    """Numbers beside a chart; without a unit, they are in the unit of the chart's title."""
    return [float(text) for text in page.locator(".plot", has_text=plot).locator(".scale").all_inner_texts()]


@pytest.mark.long
def test_the_clearance_chart_shows_what_is_required(open_page: Open, hard1: cdpr.Scene) -> None:
    careful = hard1.replace(clearance=0.02, clearances={("cable 3", "pillar"): 0.08})
    page = open_page(careful, cdpr.plan(careful))
    chart = page.locator(".plot", has_text="clearance to obstacles")
    floor = chart.locator("path.limit").get_attribute("d") or ""
    heights = {float(place) for place in re.findall(r"[ML][\d.]+ ([\d.]+)", floor)}
    assert len(heights) == 2  # 20 mm, and 80 mm where cable 3 is the tightest
    bounds = [text.replace("\xa0", " ") for text in chart.locator(".bound").all_inner_texts()]
    assert bounds == ["min 0.08 m", "min 0.02 m"]
    assert page.locator("#nearest.bad").count() == 0
    said = set()
    for share in np.linspace(0, 1, 60):
        page.evaluate("(share) => cdprViewer.setDistance(share * cdprViewer.length)", share)
        said.add(page.locator("#nearest").inner_text().replace("\xa0", " "))
    assert all(re.fullmatch(r"least room here: .+, [\d.]+ m?m apart, (20|80) mm required", text) for text in said)
    assert any("cable 3 and pillar" in text and "80 mm required" in text for text in said)
    assert any("20 mm required" in text for text in said)


def test_what_comes_too_near_is_red_and_listed_with_gap_and_demand(open_page: Open, hard1: cdpr.Scene) -> None:
    path = cdpr.plan(hard1.replace(clearance=0.01))
    page = open_page(hard1.replace(clearance=0.05), path.waypoints)
    first = page.locator(".violation").first.inner_text().replace("\xa0", " ")
    assert re.fullmatch(r"\S+ \d comes too near pillar after .*, only [\d.]+ [µm]?m apart, 50 mm required", first), first
    page.locator(".violation").first.click()
    assert re.match(r"(too near|in collision) here: ", page.locator("#nearest.bad").inner_text())


@pytest.mark.long
def test_each_axis_has_one_unit_and_the_distance_stands_under_each_chart(open_page: Open, cogiro: cdpr.Scene) -> None:
    page = open_page(cogiro, [[0.0, 2.2, 1.7], [0.0, 2.2, 5.0]])
    grounds = [text.split("\n") for text in page.locator(".ground").all_inner_texts()]
    assert grounds == [["0", "1", "2", "3", "distance, m"]] * page.locator(".plot").count()
    assert len(grounds) == 5
    titles = page.locator("#cable-table th").all_inner_texts()
    assert titles == ["cable", "length, m", "tension, N"]
    for plot in ["cable lengths", "clearance to obstacles", "clearance within the robot"]:
        assert scale_labels(page, plot)
    numbers = page.locator("#cable-table td.number").all_inner_texts()
    assert all(re.fullmatch(r"-?[\d.]+|–", text) for text in numbers)


def test_a_wrench_margin_that_is_missing_is_shown_in_red(open_page: Open, cogiro: cdpr.Scene) -> None:
    page = open_page(cogiro, [cogiro.start, [0.0, 0.0, 5.8]])
    page.evaluate("cdprViewer.setDistance(cdprViewer.length)")
    assert re.fullmatch(r"capacity margin: [\d.]+\sN short of the demand", page.locator("#wrench.bad").inner_text())
    page.evaluate("cdprViewer.setDistance(0)")
    assert page.locator("#wrench.bad").count() == 0


def test_the_result_card_says_how_good_the_path_is_and_leads_to_its_tightest_place(
    open_page: Open, tmp_path: Path
) -> None:
    made = [tmp_path / "made.html", tmp_path / "path.json"]
    command = [program(), "plan", SCENES / "hard1.toml", "--seed", "3", "--html", made[0], "-o", made[1]]
    subprocess.run(list(map(str, command)), check=True, capture_output=True)
    found = json.loads(made[1].read_text())
    page = open_page(made[0])
    assert plain(page.locator("#status").inner_text()).split("\n") == ["solved", f"{found['cost']:.3f} m"]
    said = re.fullmatch(r"at most ([\d.]+) % above the shortest", plain(page.locator("#remarks").inner_text()))
    assert said is not None
    excess = found["cost"] / found["lower_bound"] - 1
    assert excess <= float(said[1]) / 100 < 1.2 * excess
    assert re.fullmatch(r"anytime · seed 3 · <?[\d. ]+ m?s", plain(page.locator("#planner").inner_text()))
    nearest, own = page.locator(".tightest").all()
    assert "nearest obstacle" in nearest.inner_text() and "touching" in nearest.inner_text()
    assert "within the robot" in own.inner_text() and "50 mm" in plain(own.inner_text())
    nearest.click()
    assert page.locator("#nearest").inner_text().endswith(" touch")
    # The chart's least value is the true closest approach, which is at a waypoint.
    chart = page.locator(".plot", has_text="clearance to obstacles")
    assert "touching" in chart.locator(".scale").all_inner_texts()
    places = np.cumsum(np.linalg.norm(np.diff(found["waypoints"], axis=0), axis=1))
    assert min(abs(places - page.evaluate("cdprViewer.distance()"))) < 1e-6


@pytest.mark.long
def test_without_a_bound_the_card_compares_with_the_straight_line(open_page: Open, hard1: cdpr.Scene) -> None:
    found = cdpr.plan(hard1)
    excess = 100 * (found.cost / np.linalg.norm(hard1.goal - hard1.start) - 1)
    said = plain(open_page(hard1, found).locator("#remarks").inner_text())
    assert re.fullmatch(rf"{math.ceil(excess)} % longer than the straight line", said)


@pytest.mark.long
def test_an_invalid_start_says_its_reason_and_shows_the_culprit(open_page: Open, hard1: cdpr.Scene) -> None:
    inside = hard1.replace(start=[1.0, 1.0, 0.5])
    page = open_page(inside, cdpr.plan(inside))
    assert page.locator("#status").inner_text() == "start not valid"
    worst, *others, place = (line for line in plain(page.locator("#remarks").inner_text()).splitlines() if line)
    assert worst == "platform meets pillar, 225 mm deep" and len(others) == 5
    assert place == "a valid position near it: (1.328, 1, 0.5)"
    outlined = picture(page)
    page.get_by_label("least room here").uncheck()
    assert picture(page) != outlined


@pytest.mark.long
def test_a_cable_is_brought_out_everywhere(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1, cdpr.plan(hard1))
    before = picture(page)
    row = page.locator("#cable-table tr").nth(4)
    row.hover()
    assert page.locator(".curve.lit").count() == 2  # lengths and tensions
    assert page.locator(".curve.faded").count() == 14
    lit = picture(page)
    assert lit != before
    page.mouse.move(640, 700)
    assert page.locator(".curve.lit").count() == 0 and picture(page) == before
    row.focus()
    assert picture(page) == lit
    row.blur()
    # In space and on a curve as well.
    x, y = page.locator(".label.cable", has_text=re.compile("^7$")).evaluate(
        "(label) => { const { left, top } = label.getBoundingClientRect(); return [left, top]; }"
    )
    page.mouse.move(x - 20, y + 20)
    assert page.locator("#cable-table tr.lit").all_inner_texts()[0].startswith("cable 7")
    area = page.locator(".plot", has_text="cable lengths").locator(".area")
    area.hover(position={"x": 2, "y": 40})
    assert page.locator("#cable-table tr.lit").count() == 1
    # Space, curves and table have the same colour.
    stroke = page.locator(".plot", has_text="cable lengths").locator(".curve").nth(3)
    border = page.locator(".label.cable", has_text=re.compile("^3$"))
    swatch = page.locator("#cable-table .swatch").nth(3)
    colours = [
        stroke.evaluate("(one) => getComputedStyle(one).stroke"),
        border.evaluate("(one) => getComputedStyle(one).borderTopColor"),
        swatch.evaluate("(one) => getComputedStyle(one).borderTopColor"),
    ]
    assert len(set(colours)) == 1


@pytest.mark.long
def test_the_gap_is_a_segment_with_its_length_while_the_obstacle_is_seen(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1, cdpr.plan(hard1))
    page.evaluate("cdprViewer.setDistance(0.3 * cdprViewer.length)")
    drawn = picture(page)
    gaps = page.locator(".label.gap:visible")
    reading = page.locator(".plot", has_text="clearance to obstacles").locator(".reading")
    assert plain(reading.inner_text()) in [plain(text) for text in gaps.all_inner_texts()]
    count = gaps.count()
    page.evaluate("cdprViewer.layers.obstacles.parts.pillar.visible = false")
    picture(page)
    assert gaps.count() == count - 1
    page.evaluate("cdprViewer.layers.obstacles.parts.pillar.visible = true")
    page.evaluate("cdprViewer.layers.nearest.visible = false")
    assert picture(page) != drawn and gaps.count() == 0


@pytest.mark.long
def test_violations_at_one_place_are_one_item(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1, THROUGH_THE_PILLAR)
    assert page.locator(".violation").count() == 3
    fold = page.locator(".same-place").first
    assert fold.locator("summary").inner_text() == "and 3 more at this place"
    fold.locator("summary").click()
    assert all("meets pillar" in text for text in fold.locator("li").all_inner_texts())


def test_a_changed_path_does_not_keep_its_old_claims(open_page: Open, tmp_path: Path) -> None:
    path = {"waypoints": [[0.3, 1.0, 0.3], [0.3, 1.0, 1.3]], "status": "solved", "cost": 0.5, "raw_cost": 2.0}
    (tmp_path / "path.json").write_text(json.dumps(path))
    made = tmp_path / "made.html"
    command = [program(), "view", SCENES / "hard1.toml", tmp_path / "path.json", "-o", made]
    subprocess.run(list(map(str, command)), check=True, capture_output=True)
    page = open_page(made)
    assert plain(page.locator("#status").inner_text()).split("\n") == ["valid", "1.000 m"]
    assert plain(page.locator("#remarks").inner_text()) == "changed since it was planned: its file states 0.500 m"


def test_waypoints_are_marked_on_slider_and_charts(open_page: Open, hard1: cdpr.Scene) -> None:
    found = cdpr.plan(hard1)
    page = open_page(hard1, found)
    inner = len(found.waypoints) - 2
    assert page.locator("#stops .stop").count() == inner
    assert page.locator(".area .waypoint").count() == inner * page.locator(".area").count()
