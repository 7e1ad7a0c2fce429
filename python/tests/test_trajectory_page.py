"""The HTML page of a trajectory: it plays in real time and shows all curves with their limits, and what limits when."""

import copy
import datetime
import json
import math
import re
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import program
from motions import straight
from pages import HOSTILE, PHONE, SCENES, THROUGH_THE_PILLAR, Open, picture, plain, wait_until
from playwright.sync_api import Page

import cdpr

HARD1 = SCENES / "hard1.toml"
WAYPOINTS = [[0.3, 1.0, 0.3], [0.3, 1.0, 1.7], [1.7, 1.0, 1.7]]

Trajectory = dict[str, Any]
Show = Callable[..., Page]


@pytest.fixture(scope="module")
def whole() -> Trajectory:
    """A motion with a stop at its corner; 3.8 s."""
    return straight(cdpr.Scene.load(HARD1), WAYPOINTS)


@pytest.fixture
def motion(whole: Trajectory) -> Trajectory:
    return copy.deepcopy(whole)


def view(folder: Path, motion: Trajectory, scene: Path = HARD1) -> subprocess.CompletedProcess[str]:
    (folder / "motion.json").write_text(json.dumps(motion))
    command = [str(program()), "view", str(scene), "motion.json", "-o", "made.html"]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


@pytest.fixture
def show(open_page: Open, tmp_path: Path) -> Show:
    """Opens the page that the command line makes for a trajectory."""

    def shown(motion: Trajectory, scene: Path = HARD1, **options: Any) -> Page:
        made = view(tmp_path, motion, scene)
        assert made.returncode == 0, made.stderr
        return open_page(tmp_path / "made.html", **options)

    return shown


def data_of(page: Page) -> Any:
    return json.loads(page.locator("#cdpr-data").text_content() or "")


def readings(page: Page) -> list[str]:
    return [plain(text) for text in page.locator("#plot-list .reading").all_inner_texts()]


def test_plots_name_an_unusual_choice_of_tensions(show: Show, tmp_path: Path) -> None:
    hard1 = cdpr.Scene.load(HARD1)
    scene = hard1.replace(robot=hard1.robot.replace(tension_distribution="least"))
    scene.save(tmp_path / "least.toml")
    page = show(straight(scene, WAYPOINTS) | {"tension_distribution": "least"}, tmp_path / "least.toml")
    captions = page.locator("#plot-list figcaption").all_inner_texts()
    assert "cable tensions (least), N" in [text.split("\n")[0] for text in captions]


def test_the_page_shows_curves_with_their_limits_over_time(show: Show, motion: Trajectory) -> None:
    page = show(motion)
    assert plain(page.locator("#status").inner_text()).split("\n") == ["valid", "2.800 m in 3.80 s"]
    assert page.locator("#plots > summary").inner_text() == "over time"
    names = ["speed, m/s", "acceleration, m/s²", "cable speeds, m/s", "cable tensions, N", "what limits the motion"]
    captions = page.locator("#plot-list figcaption").all_inner_texts()
    assert [text.split("\n")[0] for text in captions] == names
    more = [text.split("\n")[0] for text in page.locator("#more-plots figcaption").all_inner_texts()]
    assert more == ["clearance to obstacles, m", "clearance within the robot, mm", "cable lengths, m"]
    bounds = [plain(text) for text in page.locator(".bound").all_inner_texts()]
    assert bounds == ["limit 1 m/s", "limit 2 m/s²", "limit 0.9 m/s", "limit -0.9 m/s", "limit 1000 N", "limit 10 N"]
    assert page.locator("#plot-list line.limit").count() == 6
    curves = [page.locator("#plot-list .plot").nth(k).locator("path.curve").count() for k in range(4)]
    assert curves == [1, 1, 8, 8]
    axes = page.locator("#plot-list .ground").all_inner_texts()
    assert len(axes) == 5 and all(text.split("\n") == ["0", "1", "2", "3", "time, s"] for text in axes)
    assert page.locator("#cable-table th").all_inner_texts() == ["cable", "length, m", "speed, m/s", "tension, N"]
    said = [plain(text) for text in page.locator("#plot-list p.more").all_inner_texts()]
    assert said == ["corners: 1 stop", "other limits: jerk 40 m/s³"]
    legend = page.locator(".legend-name").all_inner_texts()
    assert "trajectory" in legend and "final path" not in legend
    assert "path that it follows" not in legend  # it is the same way


def test_the_instant_is_marked_everywhere_with_its_numbers(show: Show, motion: Trajectory) -> None:
    page = show(motion)
    assert math.isclose(page.evaluate("cdprViewer.duration"), motion["duration"])
    assert page.evaluate("cdprViewer.length") is None
    for k in [0, 40, 150, 333, len(motion["times"]) - 1]:
        instant = motion["times"][k]
        page.locator("#slider").fill(str(instant))
        assert np.allclose(page.evaluate("cdprViewer.position()"), motion["positions"][k], atol=1e-5)
        assert plain(page.locator("#distance").inner_text()) == f"{instant:.2f} of 3.80 s"
        left = page.locator(".cursor").evaluate_all("(all) => all.map((one) => parseFloat(one.style.left))")
        assert len(left) == 8 and np.allclose(left, 100 * instant / motion["duration"], atol=1e-6)
        speed, pushed = (np.linalg.norm(motion[key][k]) for key in ["velocities", "accelerations"])
        assert readings(page)[:2] == [f"{speed:.3f} m/s", f"{pushed:.3f} m/s²"]
        rows = [row.locator("td.number").all_inner_texts() for row in page.locator("#cable-table tr").all()[1:]]
        expected = np.column_stack([motion[key][k] for key in ["cable_lengths", "cable_speeds", "tensions"]])
        assert np.allclose(np.array(rows, dtype=float), expected, atol=[2e-3, 1e-3, 0.51])
    area = page.locator(".area").first
    box = area.bounding_box()
    assert box is not None
    area.click(position={"x": box["width"] / 4, "y": 10})
    assert math.isclose(page.evaluate("cdprViewer.time()"), motion["duration"] / 4, rel_tol=0.02)


def test_it_says_what_limits_the_motion_when(show: Show, motion: Trajectory) -> None:
    fourth = motion["cables"][3]
    motion["limiting"] = [
        {"from": 0.0, "to": 0.25, "limit": "jerk", "cable": None},
        {"from": 0.25, "to": 0.5, "limit": "jerk", "cable": None},
        {"from": 0.5, "to": 1.0, "limit": "tension", "cable": fourth},
        {"from": 1.5, "to": 2.0, "limit": "cable_speed", "cable": motion["cables"][5]},
        {"from": 2.0, "to": motion["duration"], "limit": "cable_acceleration", "cable": fourth},
    ]
    page = show(motion)
    titles = page.locator(".piece").evaluate_all("(all) => all.map((one) => one.title)")
    assert [plain(title) for title in titles] == [
        "jerk, 0.00 to 0.50 s",
        "tension of cable 3, 0.50 to 1.00 s",
        "speed of cable 5, 1.50 to 2.00 s",
        "acceleration of cable 3, 2.00 to 3.80 s",
    ]
    style = "(all) => all.map((one) => getComputedStyle(one).backgroundColor)"
    colors = page.locator(".piece").evaluate_all(style)
    assert len(set(colors)) == 4
    assert page.locator(".key .solid").evaluate_all(style) == colors
    key = [re.sub(r"\s+", " ", plain(text)) for text in page.locator(".key li").all_inner_texts()]
    assert key[1:] == ["jerk 13 %", "tension 13 % cable 3", "cable speed 13 % cable 5", "cable acceleration 47 % cable 3"]
    said = {0.1: "jerk", 0.5: "tension of cable 3", 1.2: "nothing", 1.7: "speed of cable 5", 3.8: "acceleration of cable 3"}
    for instant, limit in said.items():
        page.evaluate(f"cdprViewer.setTime({instant})")
        assert readings(page)[-1] == limit
    stripes = page.locator(".piece-cable").evaluate_all(style)
    assert stripes[0] == stripes[2] != stripes[1]
    swatches = page.locator("#cable-table .swatch")
    assert swatches.nth(3).evaluate("(one) => getComputedStyle(one).borderTopColor") == stripes[0]
    corner = page.locator(".corner").evaluate_all("(all) => all.map((one) => one.title)")
    assert [plain(title) for title in corner] == ["waypoint 1 at 1.90 s: stop"]


@pytest.mark.long
def test_it_plays_in_real_time(show: Show, motion: Trajectory) -> None:
    page = show(motion)
    before = picture(page)
    # The clock of the page stands unless the test moves it, so that the result does not depend on how busy the machine is.
    page.clock.install(time=datetime.datetime(2026, 1, 1))
    page.clock.pause_at(datetime.datetime(2026, 1, 2))
    for speed, seconds in [(1, 1.0), (0.25, 1.0), (2, 0.7)]:
        page.evaluate("cdprViewer.setTime(0)")
        page.select_option("#speed", str(speed))
        page.locator("#play").click()
        page.clock.run_for(round(1000 * seconds))
        # As far as the latest picture.
        assert abs(page.evaluate("cdprViewer.time()") - speed * seconds) < 0.02 * speed
        page.locator("#play").click()
    assert picture(page) != before


@pytest.mark.long
def test_few_pictures_do_not_slow_it_down(show: Show, motion: Trajectory) -> None:
    page = show(motion)
    page.locator("#play").click()
    wait_until(page, "cdprViewer.time() > 0")
    first = page.evaluate("cdprViewer.time()")
    # No picture is drawn for 1.2 s.
    page.evaluate("() => { const end = performance.now() + 1200; while (performance.now() < end); }")
    page.wait_for_timeout(300)
    assert page.evaluate("cdprViewer.time()") - first > 1.2
    wait_until(page, "cdprViewer.time() === cdprViewer.duration", 8.0)
    assert page.locator("#play").get_attribute("aria-label") == "play"


def test_a_collision_is_listed_once_with_its_time(show: Show) -> None:
    motion = straight(cdpr.Scene.load(HARD1), THROUGH_THE_PILLAR)
    page = show(motion)
    assert page.locator("#status").inner_text().startswith("not valid")
    said = [plain(text) for text in page.locator(".violation").all_inner_texts()]
    (platform,) = [text for text in said if text.startswith("platform meets pillar")]
    assert platform == "platform meets pillar at 0.92 s, 225 mm deep"
    page.locator(".violation", has_text="platform meets").click()
    # Its side touches the pillar at x = 0.775.
    assert math.isclose(page.evaluate("cdprViewer.position()")[0], 0.775, abs_tol=1e-3)
    assert page.locator("#nearest.bad").inner_text().startswith("in collision here: ")
    crossed = picture(page)
    page.evaluate("cdprViewer.layers.violations.visible = false")
    assert picture(page) != crossed


@pytest.mark.long
def test_a_curve_beyond_its_limit_says_so(show: Show, motion: Trajectory) -> None:
    motion["limits"]["speed"], motion["limits"]["acceleration"] = 0.95, 40.0
    page = show(motion)
    speed, acceleration = (page.locator("#plot-list .plot").nth(k) for k in [0, 1])
    assert speed.locator(".bad").all_inner_texts() == ["1.000"]
    assert [plain(text) for text in acceleration.locator(".bound").all_inner_texts()] == ["↑ limit 40 m/s²"]
    assert acceleration.locator("line.limit").count() == 0
    assert page.locator(".plot .bad").count() == 1


@pytest.mark.long
def test_a_long_motion_keeps_its_extrema_on_a_small_page(show: Show) -> None:
    motion = straight(cdpr.Scene.load(HARD1), WAYPOINTS, rate=3000)
    motion["velocities"][7654] = [3.0, 4.0, 0.0]
    motion["tensions"][4321][2] = 5.0
    page = show(motion)
    shown = data_of(page)["trajectory"]
    assert max(shown["speed"]["values"]) == 5.0 and min(shown["tensions"][2]["values"]) == 5.0
    at = shown["speed"]["times"][shown["speed"]["values"].index(5.0)]
    assert math.isclose(at, motion["times"][7654], abs_tol=1e-6)
    assert len(shown["times"]) <= 2000 and len(shown["speed"]["times"]) <= 2000
    assert (shown["times"][0], shown["times"][-1]) == (0.0, pytest.approx(motion["duration"], abs=1e-6))
    page.evaluate(f"cdprViewer.setTime({motion['times'][5000]})")
    assert np.allclose(page.evaluate("cdprViewer.position()"), motion["positions"][5000], atol=1e-5)


@pytest.mark.long
def test_a_motion_without_tensions_or_limits_is_shown(show: Show, motion: Trajectory) -> None:
    motion |= {"tensions": None, "tension_limits": None, "limits": {"blend": 0.0}, "limiting": []}
    page = show(motion)
    assert page.locator(".bound").count() == 0 and page.locator(".key li").count() == 0
    assert readings(page)[-1] == "nothing"
    assert page.locator("#cable-table th").all_inner_texts() == ["cable", "length, m", "speed, m/s"]


@pytest.mark.long
@pytest.mark.parametrize("look", ["light", "dark"])
def test_it_fits_a_phone(show: Show, motion: Trajectory, look: str) -> None:
    page = show(motion, size=PHONE, look=look)
    assert page.evaluate("document.documentElement.scrollWidth") <= PHONE[0]
    page.locator("#tabs [data-tab=charts]").click()
    for part in ["#plots", "#bar", "#play", "#slider", "#speed", ".bound >> nth=0"]:
        box = page.locator(part).bounding_box()
        assert box is not None and box["x"] >= 0 and box["x"] + box["width"] <= PHONE[0], part
    assert page.locator("#plots").evaluate("(box) => box.scrollWidth <= box.clientWidth")
    page.locator("#play").click()
    wait_until(page, "cdprViewer.time() > 0")


@pytest.mark.long
@pytest.mark.parametrize("look", ["light", "dark"])
def test_labels_of_a_chart_do_not_cover_each_other(show: Show, motion: Trajectory, look: str) -> None:
    motion["limits"] |= {"speed": 0.99, "acceleration": 2.02, "cable_speed": 0.82}
    page = show(motion, look=look)
    for area in page.locator(".area").all():
        tops = area.locator(".scale, .bound").evaluate_all("(all) => all.map((one) => one.getBoundingClientRect().top)")
        assert all(b - a >= 11 for a, b in zip(sorted(tops), sorted(tops)[1:], strict=False)), tops


@pytest.mark.long
def test_names_stay_names(show: Show, tmp_path: Path) -> None:
    spec = cdpr.Scene.load(HARD1).to_dict()
    for number, cable in enumerate(spec["robot"]["cables"]):
        cable["name"] = f"{HOSTILE[number % len(HOSTILE)]} {number}"
    scene = cdpr.Scene.from_dict(spec)
    scene.save(tmp_path / "hostile.json")
    motion = straight(scene, WAYPOINTS)
    name = motion["cables"][0]
    motion["limiting"] = [{"from": 0.0, "to": 1.0, "limit": "tension", "cable": name}]
    page = show(motion, tmp_path / "hostile.json")
    assert readings(page)[-1] == f"tension of {name}"
    assert page.evaluate("window.hacked") is None and page.locator("#plots img, #plots script").count() == 0


def without(key: str) -> Callable[[Trajectory], Any]:
    return lambda motion: motion.pop(key)


def with_value(key: str, value: Any) -> Callable[[Trajectory], Any]:
    return lambda motion: motion.update({key: value})


WRONG: list[tuple[Callable[[Trajectory], Any], str]] = [
    (without("times"), "missing field `times`"),
    (with_value("version", 2), "version: found 2, expected 1"),
    (lambda motion: motion["velocities"].pop(), "velocities: found 380 entries, expected 381: one for each time"),
    (lambda motion: motion["cable_speeds"][7].pop(), "cable_speeds[7]: found 7 entries, expected 8: one for each cable"),
    (lambda motion: motion["times"].__setitem__(3, None), "times[3]: found null, expected a number"),
    (lambda motion: motion["tensions"][3].__setitem__(1, math.nan), "tensions"),
    (lambda motion: motion["cables"].__setitem__(2, "winch"), "cables: found cable 0, cable 1, winch"),
    (with_value("orientation", [0.0, 0.0, 0.0, 1.0]), "orientation: found a path at"),
]


@pytest.mark.parametrize(("change", "expected"), WRONG)
def test_a_wrong_file_is_refused_with_its_key(
    motion: Trajectory, tmp_path: Path, change: Callable[[Trajectory], Any], expected: str
) -> None:
    change(motion)
    made = view(tmp_path, motion)
    assert made.returncode == 2 and not (tmp_path / "made.html").exists()
    assert made.stderr.startswith(f"cdpr: motion.json: {expected}"), made.stderr


def test_a_motion_of_another_scene_is_shown_with_a_warning(motion: Trajectory, tmp_path: Path) -> None:
    made = view(tmp_path, motion, SCENES / "hard3.toml")
    assert made.returncode == 0 and "another scene" in made.stderr
