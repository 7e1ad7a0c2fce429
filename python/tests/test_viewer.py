"""The HTML page in a real browser: everything that a reader can see or press."""

import copy
import itertools
import json
import math
import sys
import time
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from pages import THROUGH_THE_PILLAR, HOSTILE, PHONE, SCREENSHOTS, Open, picture, wait_until
from playwright.sync_api import Browser, Page

import cdpr


def colors(page: Page) -> int:
    """The number of colours in the 3D view."""
    return int(
        page.evaluate("""() => {
            const canvas = cdprViewer.picture();
            const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
            return new Set(new Uint32Array(data.buffer)).size;
        }""")
    )


def along(waypoints: Any, distance: float) -> np.ndarray[Any, Any]:
    """The position at a distance along a path."""
    array = np.asarray(waypoints, dtype=float)
    ends = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(array, axis=0), axis=1))])
    return np.array([np.interp(distance, ends, array[:, axis]) for axis in range(3)])


@pytest.fixture(scope="module")
def planned(cogiro: cdpr.Scene) -> cdpr.Result:
    result = cdpr.plan(cogiro, seed=0)
    assert result.solved
    return result


def test_page_shows_scene_path_and_plots(open_page: Open, cogiro: cdpr.Scene, planned: cdpr.Result) -> None:
    page = open_page(cogiro, planned)
    assert page.title() == "cogiro – cdpr"
    assert colors(page) > 100
    plots = ["clearance to obstacles, m", "clearance within the robot, m", "cable lengths, m", "cable tensions, N"]
    plots += ["capacity margin beyond the demand, N"]
    captions = page.locator(".plot figcaption").all_inner_texts()
    assert [text.split("\n")[0] for text in captions] == plots
    assert page.locator("#cable-table tr").count() == 9
    assert page.locator("#nearest").inner_text().startswith("nearest here: ")
    page.evaluate("cdprViewer.setDistance(cdprViewer.length)")
    demand = cogiro.to_dict()["wrench"]
    margin = cdpr.capacity_margin(cogiro.robot, [cogiro.goal], force=demand["force"], moment=demand["moment"])[0]
    said = page.locator("#wrench").inner_text().replace("\xa0", " ")
    assert said == f"capacity margin: {margin:.4g} N beyond the demand"


@pytest.mark.long
def test_start_and_goal_are_those_of_the_path(open_page: Open, hard1: cdpr.Scene) -> None:
    path = cdpr.plan(hard1, start=[0.5, 1.0, 1.6], goal=[1.0, 1.6, 1.6])
    page = open_page(hard1, path)
    data = json.loads(page.locator("#cdpr-data").text_content() or "")
    assert [data["start"], data["goal"]] == [path.waypoints[0].tolist(), path.waypoints[-1].tolist()]
    still = open_page(hard1, file="still.html")
    assert json.loads(still.locator("#cdpr-data").text_content() or "")["goal"] == [1.7, 1.0, 1.7]


@pytest.mark.long
def test_the_position_of_the_platform_is_shown(open_page: Open, hard1: cdpr.Scene, empty: cdpr.Scene) -> None:
    page = open_page(hard1, THROUGH_THE_PILLAR)
    page.evaluate("cdprViewer.setDistance(0.5 * cdprViewer.length)")
    assert page.locator("#position").inner_text() == "platform at (1.000, 1.000, 1.000)\xa0m"
    still = open_page(empty, file="still.html")
    x, y, z = empty.start
    assert still.locator("#position").inner_text() == f"platform at ({x:.3f}, {y:.3f}, {z:.3f})\xa0m"


@pytest.mark.long
@pytest.mark.parametrize("which", ["planned", "bad"])
def test_every_switch_changes_the_picture(
    open_page: Open, cogiro: cdpr.Scene, planned: cdpr.Result, hard1: cdpr.Scene, which: str
) -> None:
    page = open_page(cogiro, planned) if which == "planned" else open_page(hard1, THROUGH_THE_PILLAR)
    page.evaluate("document.querySelectorAll('details').forEach((fold) => { fold.open = true; })")
    page.evaluate("Object.values(cdprViewer.layers).forEach((layer) => { layer.visible = true; })")
    page.evaluate("cdprViewer.setDistance(0.4 * cdprViewer.length)")
    rows = page.locator(".legend-row")
    names = rows.locator(".legend-name").all_inner_texts()
    layers = {"platform", "obstacles", "names of obstacles", "cables", "names of cables", "outlets and frame"}
    layers |= {"final path", "start and goal", "workspace", "least room here", "swept by cables"}
    layers |= {"shadows of obstacles", "cable 0", "column" if which == "planned" else "pillar"}
    tree = f"search tree ({np.sum(planned.tree.parents != np.arange(len(planned.tree.parents)))} edges)"
    layers |= {"wrench-feasible workspace", tree} if which == "planned" else {"violations"}
    assert layers <= set(names) and "raw path" not in names
    before = picture(page)
    for number, name in enumerate(names):
        box = rows.nth(number).locator("input")
        box.click()
        assert picture(page) != before, name
        box.click()
        assert picture(page) == before, name


@pytest.mark.long
def test_obstacles_are_switched_one_by_one_and_together(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(cdpr.Scene.from_dict(with_obstacles(hard1.to_dict(), 100)))
    fold = page.locator(".fold", has_text="by name (100)")
    assert not fold.get_by_text("cube 42", exact=True).is_visible()
    fold.locator("summary").click()
    everything = picture(page)
    seen = {everything}
    for name in ["cube 0", "cube 42", "cube 99"]:
        fold.get_by_label(name, exact=True).uncheck()
        seen.add(picture(page))
    fold.get_by_role("button", name="none").click()
    assert page.evaluate("Object.values(cdprViewer.layers.obstacles.parts).some((part) => part.visible)") is False
    without = picture(page)
    switch = page.get_by_label("obstacles", exact=True)
    switch.uncheck()
    assert picture(page) == without
    switch.check()
    fold.get_by_role("button", name="all").click()
    assert picture(page) == everything
    assert len(seen | {without}) == 5


@pytest.mark.long
def test_a_hundred_obstacles_and_a_tree_of_5000_nodes_are_few_draw_calls(open_page: Open, hard1: cdpr.Scene) -> None:
    scene = cdpr.Scene.from_dict(with_obstacles(hard1.to_dict(), 100))
    points = np.random.default_rng(0).uniform(0.2, 1.8, (10_000, 3))
    start, *_, goal = points[scene.states_valid(points)]
    found = cdpr.plan(scene, "rrt", start=start, goal=goal, keep_going=True, max_nodes=5000, max_samples=10**6)
    assert found.stats["nodes"] >= 5000
    page = open_page(scene, found)
    assert page.evaluate("cdprViewer.layers.searchTree.visible") is False  # it would hide the scene
    before = picture(page)
    calls = page.evaluate("cdprViewer.statistics().calls")
    page.evaluate("cdprViewer.layers.searchTree.visible = true")
    assert picture(page) != before
    statistics = page.evaluate("cdprViewer.statistics()")
    assert statistics["calls"] == calls + 1 < 40
    assert statistics["lines"] >= found.stats["nodes"] - 1
    measured("100-obstacles-5000-nodes", page)


def test_the_papers_scene_is_small_and_soon_there(open_page: Open, hard1: cdpr.Scene, tmp_path: Path) -> None:
    page = open_page(hard1, cdpr.plan(hard1, seed=0))
    assert (tmp_path / "view.html").stat().st_size < 2_110_000
    measured("hard1", page)


def test_a_static_page_is_smaller_and_offers_no_editing(
    open_page: Open, hard1: cdpr.Scene, tmp_path: Path
) -> None:
    page = open_page(hard1, cdpr.plan(hard1, seed=0), live=False)
    assert (tmp_path / "view.html").stat().st_size < 1_000_000
    assert not page.locator("#edit-toggle").is_visible()


def measured(what: str, page: Page) -> None:
    """Records measurements of the page; they depend on the machine, so nothing is asserted."""
    wait_until(page, "cdprViewer.statistics().firstPicture !== null")
    size = Path(page.url.removeprefix("file://")).stat().st_size
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    found = {"bytes": size, **page.evaluate("cdprViewer.statistics()")}
    (SCREENSHOTS / f"measured-{what}.json").write_text(json.dumps(found))


@pytest.mark.long
def test_views_section_and_look_change_the_picture(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1, THROUGH_THE_PILLAR)
    first = picture(page)
    seen = {first}
    for button in ["#view-x", "#view-y", "#view-z"]:
        page.locator(button).click()
        seen.add(picture(page))
    page.locator("#reset").click()
    assert picture(page) == first
    for axis in "xyz":
        page.select_option("#section", axis)
        seen.add(picture(page))
    page.locator("#section-at").fill("0.25")
    seen.add(picture(page))
    page.select_option("#section", "")
    assert picture(page) == first
    page.locator("#look").click()
    seen.add(picture(page))
    assert len(seen) == 9
    page.locator("#look").click()
    assert picture(page) == first


@pytest.mark.long
def test_dark_look_follows_the_system(open_page: Open, empty: cdpr.Scene) -> None:
    background = "getComputedStyle(document.body).backgroundColor"
    light, dark = (open_page(empty, look=look).evaluate(background) for look in ["light", "dark"])
    assert (light, dark) == ("rgb(246, 247, 249)", "rgb(20, 23, 28)")


@pytest.mark.long
def test_play_moves_the_platform_and_speed_counts(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1, THROUGH_THE_PILLAR)
    before = picture(page)
    page.select_option("#speed", "4")
    # On a busy machine the end may be reached first; a click would then play again from the start.
    pause = """(() => {
        const play = document.querySelector('#play'), plays = play.dataset.playing === 'true';
        if (plays) play.click();
        return plays;
    })()"""
    for _ in range(20):
        page.locator("#play").click()
        wait_until(page, "cdprViewer.distance() > 0.2 * cdprViewer.length")
        if page.evaluate(pause):
            break
    page.wait_for_timeout(100)  # a frame that is already pending
    distance, position = page.evaluate("[cdprViewer.distance(), cdprViewer.position()]")
    assert np.allclose(position, along(THROUGH_THE_PILLAR, distance))
    assert picture(page) != before
    page.wait_for_timeout(200)
    assert page.evaluate("cdprViewer.distance()") == distance
    page.locator("#play").click()
    # The whole path takes 8 s at speed 1.
    wait_until(page, "cdprViewer.distance() === cdprViewer.length", 8.0)


def test_slider_sets_the_pose_and_plots_follow(open_page: Open, cogiro: cdpr.Scene, planned: cdpr.Result) -> None:
    page = open_page(cogiro, planned)
    length = page.evaluate("cdprViewer.length")
    assert math.isclose(length, planned.cost, rel_tol=1e-12)
    for share in [0.0, 0.3, 1.0]:
        page.locator("#slider").fill(str(share * length))
        position = np.array(page.evaluate("cdprViewer.position()"))
        assert np.allclose(position, along(planned.waypoints, share * length), atol=1e-9)
        # The orientation of this scene is the identity.
        lines = cogiro.robot.outlets - (position + cogiro.robot.attachments)
        shown = [float(text.split()[0]) for text in page.locator("#cable-table td:nth-child(2)").all_inner_texts()]
        assert np.allclose(shown, np.linalg.norm(lines, axis=1), atol=1e-3 + length / 300)
        left = page.locator(".cursor").first.evaluate("(cursor) => parseFloat(cursor.style.left)")
        assert math.isclose(left, 100 * share, abs_tol=1e-6)
    area = page.locator(".area").first
    box = area.bounding_box()
    assert box is not None
    area.click(position={"x": box["width"] / 2, "y": 10})
    assert math.isclose(page.evaluate("cdprViewer.distance()"), length / 2, rel_tol=0.02)


def test_a_collision_is_shown_and_jumped_to(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1, THROUGH_THE_PILLAR)
    assert page.locator("#status").inner_text().startswith("not valid")
    report = cdpr.check(hard1, THROUGH_THE_PILLAR)
    first = report.violations[0]
    assert page.locator("#violation-count").inner_text() == f"{len(report.violations)} violations at 3 places"
    button = page.locator(".violation").first
    assert all(name in button.inner_text() for name in first.culprits)
    button.click()
    assert math.isclose(page.evaluate("cdprViewer.distance()"), first.at * report.length, rel_tol=1e-9)
    assert page.locator("#nearest.bad").inner_text().startswith("in collision here: ")
    assert page.locator(".fault").count() == page.locator(".plot").count() * len(report.violations)
    crossed = picture(page)
    page.evaluate("cdprViewer.layers.violations.visible = false")
    assert picture(page) != crossed
    page.evaluate("cdprViewer.setDistance(0)")
    assert page.locator("#nearest.bad").count() == 0


@pytest.mark.long
def test_keys_do_what_buttons_do(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1, THROUGH_THE_PILLAR)
    first = picture(page)
    seen = {first}
    for key in ["1", "2", "3"]:
        page.keyboard.press(key)
        seen.add(picture(page))
    page.keyboard.press("r")
    assert picture(page) == first
    page.keyboard.press("s")
    assert page.locator("#section").input_value() == "x"
    page.keyboard.press("d")
    seen.add(picture(page))
    assert len(seen) == 5
    page.keyboard.press("End")
    assert page.evaluate("cdprViewer.distance() === cdprViewer.length")
    page.keyboard.press("ArrowLeft")
    assert math.isclose(page.evaluate("cdprViewer.distance() / cdprViewer.length"), 0.99)
    page.keyboard.press("Home")
    page.keyboard.press(" ")
    wait_until(page, "cdprViewer.distance() > 0")
    page.keyboard.press(" ")
    assert page.locator("#play").get_attribute("aria-label") == "play"
    reached = set()
    focus = "(({ id, className, tagName }) => id || className || tagName)(document.activeElement)"
    for _ in range(60):
        page.keyboard.press("Tab")
        reached.add(page.evaluate(focus))
    assert {"CANVAS", "play", "slider", "speed", "reset", "section", "save", "look", "violation"} <= reached


@pytest.mark.long
def test_picture_is_saved(open_page: Open, hard1: cdpr.Scene, tmp_path: Path) -> None:
    page = open_page(hard1, THROUGH_THE_PILLAR)
    for press in [lambda: page.locator("#save").click(), lambda: page.keyboard.press("p")]:
        with page.expect_download() as found:
            press()
        assert found.value.suggested_filename == "hard1.png"
        found.value.save_as(tmp_path / "saved.png")
        assert (tmp_path / "saved.png").read_bytes().startswith(b"\x89PNG")


def test_a_phone_has_one_sheet_with_tabs_and_targets_for_fingers(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1, THROUGH_THE_PILLAR, size=PHONE)
    assert page.evaluate("document.documentElement.scrollWidth") <= PHONE[0]
    assert colors(page) > 100
    row = page.locator("#tools").bounding_box()
    assert row is not None and row["y"] + row["height"] < 60  # one row, which scrolls
    for part in ["#panel", "#bar", "#play", "#slider", "#speed", "#tabs", "#reset", "#keys"]:
        page.locator(part).scroll_into_view_if_needed()
        box = page.locator(part).bounding_box()
        assert box is not None and box["x"] >= 0 and box["x"] + box["width"] <= PHONE[0], part
    targets = "#tools button, #tools select, #play, #slider, #speed, #tabs button, .tightest, .violation"
    for box in page.locator(targets).evaluate_all("(all) => all.map((one) => one.getBoundingClientRect().toJSON())"):
        assert box["height"] >= 44
    before = picture(page)
    page.locator("#view-z").click()
    assert picture(page) != before
    parts = {"result": "#status", "legend": ".legend-row", "charts": ".area"}
    for tab, shown in parts.items():
        page.locator(f"#tabs [data-tab={tab}]").click() if tab != "result" else None
        seen = {name: page.locator(part).first.is_visible() for name, part in parts.items()}
        assert seen == {name: name == tab for name in parts}, shown
    page.locator("#tabs [data-tab=charts]").click()
    assert not page.locator(".area").first.is_visible()  # the sheet is folded
    page.locator("#play").click()
    wait_until(page, "cdprViewer.distance() > 0")


@pytest.mark.long
def test_keys_are_listed_behind_a_question_mark(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1, THROUGH_THE_PILLAR)
    assert not page.locator("#help").is_visible()
    page.locator("#keys").click()
    assert "Shift + arrows" in page.locator("#help").inner_text()
    page.locator("#help-close").click()
    page.keyboard.press("?")
    assert page.locator("#help").is_visible()
    page.keyboard.press("Escape")
    assert not page.locator("#help").is_visible()


@pytest.mark.long
def test_a_printed_page_has_picture_result_charts_and_table(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1, cdpr.plan(hard1), look="dark")
    page.evaluate("window.dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    for part in ["#print-picture canvas", "#status", ".tightest", ".area", "#cable-table"]:
        assert page.locator(part).first.is_visible(), part
    for part in ["#view", "#bar", "#tools", "#legend"]:
        assert not page.locator(part).is_visible(), part
    assert page.evaluate("getComputedStyle(document.documentElement).getPropertyValue('--text')") == "#1b1f24"
    assert page.evaluate("document.documentElement.scrollHeight > window.innerHeight")
    page.emulate_media(media="screen")
    page.evaluate("window.dispatchEvent(new Event('afterprint'))")
    assert page.locator("#print-picture canvas").count() == 0


@pytest.mark.long
def test_forced_colours_keep_the_play_icon(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1, THROUGH_THE_PILLAR)
    page.emulate_media(forced_colors="active")
    icon = "getComputedStyle(document.getElementById('play'), '::before')"
    text = page.evaluate("getComputedStyle(document.getElementById('play')).color")
    assert page.evaluate(f"{icon}.backgroundColor") == text != page.evaluate(
        "getComputedStyle(document.getElementById('play')).backgroundColor"
    )


@pytest.mark.long
def test_labels_do_not_cover_each_other(open_page: Open, cogiro: cdpr.Scene, planned: cdpr.Result) -> None:
    page = open_page(cogiro, planned, size=PHONE)
    page.evaluate("cdprViewer.layers.cableNames.visible = true")
    page.evaluate("cdprViewer.setDistance(0.45 * cdprViewer.length)")
    picture(page)
    boxes = page.evaluate("""[...document.querySelectorAll('.label:not([hidden])')].map((label) => {
        const { left, right, top, bottom } = label.getBoundingClientRect();
        return [left, right, top, bottom];
    })""")
    assert len(boxes) >= 11
    for (a, b, c, d), (e, f, g, h) in itertools.combinations(boxes, 2):
        assert b <= e + 0.5 or f <= a + 0.5 or d <= g + 0.5 or h <= c + 0.5


@pytest.mark.long
def test_names_cannot_inject_anything(open_page: Open, hard1: cdpr.Scene) -> None:
    spec = hard1.to_dict()
    spec["name"] = spec["robot"]["name"] = HOSTILE[0]
    for number, cable in enumerate(spec["robot"]["cables"]):
        cable["name"] = f"{HOSTILE[number % 3]} {number}"
    side = {"box": [0.1, 0.1, 0.1]}
    spec["obstacles"] = [{"name": n, **side, "position": [1.0, 1.0, 0.2 + 0.3 * k]} for k, n in enumerate(HOSTILE)]
    page = open_page(cdpr.Scene.from_dict(spec), THROUGH_THE_PILLAR)
    page.evaluate("Object.values(cdprViewer.layers).forEach((layer) => { layer.visible = true; })")
    page.evaluate("cdprViewer.setDistance(0.5 * cdprViewer.length)")
    page.wait_for_timeout(300)
    assert page.evaluate("window.hacked") is None
    assert page.locator("#panel img, #panel svg, #panel script, #labels *:not(.label), #nearest *").count() == 0
    assert page.locator("#title").inner_text() == HOSTILE[0]
    labels = page.locator(".label").all_inner_texts()
    assert set(HOSTILE) <= set(labels)
    assert spec["robot"]["cables"][1]["name"] in page.locator("#cable-table .cable-name").all_inner_texts()[1]


def scaled(spec: dict[str, Any], factor: float) -> dict[str, Any]:
    """The same scene at another size."""

    def times(value: Any) -> Any:
        return [times(v) for v in value] if isinstance(value, list) else value * factor

    spec = copy.deepcopy(spec)
    spec["workspace"] = {key: times(value) for key, value in spec["workspace"].items()}
    for cable in spec["robot"]["cables"]:
        cable |= {"outlet": times(cable["outlet"]), "attachment": times(cable["attachment"])}
    for body in [*spec["robot"]["platform"], *spec["obstacles"]]:
        body |= {key: times(body[key]) for key in ("box", "position") if key in body}
    spec["query"] = {key: times(value) for key, value in spec["query"].items()}
    return spec


def with_cables(spec: dict[str, Any], count: int) -> dict[str, Any]:
    """The same scene with another number of cables, around the ceiling."""
    spec = copy.deepcopy(spec)
    turns = [2 * math.pi * k / count for k in range(count)]
    spec["robot"]["cables"] = [
        {
            "outlet": [1 + math.cos(a), 1 + math.sin(a), 2.0],
            "attachment": [0.07 * math.cos(a), 0.07 * math.sin(a), 0.025],
            "tension": [1.0, 500.0],
        }
        for a in turns
    ]
    return spec


def with_obstacles(spec: dict[str, Any], count: int) -> dict[str, Any]:
    """The same scene with cubes on a grid on the floor and the walls."""
    spec = copy.deepcopy(spec)
    side = math.ceil(count ** (1 / 3))
    places = [[0.1 + 1.8 * (n // k % side) / side for k in (1, side, side * side)] for n in range(count)]
    spec["obstacles"] = [{"name": f"cube {n}", "box": [0.03] * 3, "position": p} for n, p in enumerate(places)]
    return spec


ODD = ["kilometres", "millimetres", "3 cables", "24 cables", "no obstacles", "1000 obstacles"]


@pytest.mark.long
@pytest.mark.parametrize("which", ODD)
def test_huge_and_odd_scenes_open_and_frame_themselves(open_page: Open, hard1: cdpr.Scene, which: str) -> None:
    spec = hard1.to_dict()
    path = np.array([[0.3, 1.0, 0.3], [0.5, 1.2, 0.9]])
    change: dict[str, Callable[[], dict[str, Any]]] = {
        "kilometres": lambda: scaled(spec, 1e3),
        "millimetres": lambda: scaled(spec, 1e-3),
        "3 cables": lambda: with_cables(spec, 3),
        "24 cables": lambda: with_cables(spec, 24),
        "no obstacles": lambda: with_obstacles(spec, 0),
        "1000 obstacles": lambda: with_obstacles(spec, 1000),
    }
    factor = {"kilometres": 1e3, "millimetres": 1e-3}.get(which, 1.0)
    scene = cdpr.Scene.from_dict(change[which]())
    start = time.perf_counter()
    page = open_page(scene, path * factor)
    # Generous: software rendering on a busy machine.
    assert time.perf_counter() - start < 30
    assert colors(page) > 20
    if factor != 1.0:
        same = open_page(hard1, path, file="same.html")
        for each in (page, same):
            each.evaluate("cdprViewer.layers.obstacleNames.visible = cdprViewer.layers.startGoal.visible = false")
        assert abs(colors(page) - colors(same)) < 0.2 * colors(same)
    lengths = page.locator(".plot", has_text="cable lengths").locator("path")
    curves = lengths.evaluate_all("(all) => all.map((p) => p.getAttribute('style'))")
    assert len(set(curves)) == len(curves) == len(scene.robot.outlets)
    half = 0.5 * page.evaluate("cdprViewer.length")
    page.evaluate("(half) => cdprViewer.setDistance(half)", half)
    assert np.allclose(page.evaluate("cdprViewer.position()"), along(path * factor, half))


def test_show_opens_a_tab_and_a_notebook_frames_the_page(
    browser: Browser, hard1: cdpr.Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[str] = []
    monkeypatch.setattr("webbrowser.open_new_tab", lambda url: opened.append(url) or True)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    view = cdpr.show(hard1, THROUGH_THE_PILLAR)
    (file,) = tmp_path.iterdir()
    assert opened == [file.as_uri()]
    assert file.read_text(encoding="utf-8") == view.html
    page = browser.new_page()
    page.set_content(f"<body>{view._repr_html_()}")
    frame = page.frames[1]
    frame.wait_for_selector("#title >> text=hard1")
    assert frame.evaluate("cdprViewer.ready") and frame.evaluate("cdprViewer.length") > 1.9
    assert frame.evaluate("document.getElementById('details').open")  # a notebook is wide enough for the legend
    page.close()


def test_show_opens_no_tab_in_a_notebook(hard1: cdpr.Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    shell = SimpleNamespace(config={"IPKernelApp": {}})
    monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: shell))
    monkeypatch.setattr("webbrowser.open_new_tab", lambda url: pytest.fail(f"opened {url}"))
    assert cdpr.show(hard1)._repr_html_().startswith("<iframe srcdoc=")
