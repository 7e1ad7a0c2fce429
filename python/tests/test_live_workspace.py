"""The page that proves where the platform can be while someone edits, in a real browser."""

import re

import pytest
from pages import PHONE, Open, edit, plain, settled, wait_until, where
from playwright.sync_api import Error, Page

import cdpr

LINE = "document.querySelector('.edit-volume')"
PROVED = f"{LINE}.textContent.startsWith('valid') && !{LINE}.classList.contains('busy')"
SPY = """() => {
    const post = Worker.prototype.postMessage;
    window.asked = [];
    Worker.prototype.postMessage = function (message) { asked.push(message.request); post.call(this, message); };
}"""


def proving(page: Page) -> str:
    """Switches the proof on or off, and returns what the page then says about the workspace."""
    page.get_by_role("button", name="workspace", exact=True).click()
    return proved(page)


def proved(page: Page) -> str:
    wait_until(page, PROVED)
    return plain(page.locator(".edit-volume").inner_text())


def volume(text: str, begin: str = "valid[^:]*: ") -> tuple[float, float]:
    """Bounds of the volume in a text, m³."""
    found = re.search(begin + r"([\d.]+)(?: to ([\d.]+))? m³", text)
    assert found is not None, text
    return float(found[1]), float(found[2] or found[1])


def exact(scene: cdpr.Scene) -> tuple[float, float]:
    found = cdpr.workspace(scene, resolution=0.02)
    return found.volume.min, found.volume.max


def agree(one: tuple[float, float], other: tuple[float, float]) -> bool:
    """Whether bounds of the same number do not contradict each other; those of the page have four digits."""
    return max(one[0], other[0]) <= 1.001 * min(one[1], other[1])


def moved(scene: cdpr.Scene, cable: int, outlet: list[float]) -> cdpr.Scene:
    data = scene.to_dict()
    data["robot"]["cables"][cable]["outlet"] = outlet
    return cdpr.Scene.from_dict(data)


def test_the_volume_follows_an_outlet(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1, cdpr.plan(hard1, seed=0))
    bare = page.evaluate("cdprViewer.statistics().triangles")
    edit(page)
    first = proving(page)
    assert agree(volume(first), exact(hard1)) and "before" not in first
    assert "cable 3 / pillar" in first and "32.1 %" in first
    assert page.evaluate("cdprViewer.statistics().triangles") > bare
    at = where(page, "outlet of cable 0")
    page.mouse.move(*at)
    page.mouse.down()
    page.evaluate(SPY)
    for step in range(1, 21):
        page.mouse.move(*(at + [2 * step, -step]))
        page.wait_for_timeout(20)
    page.mouse.up()
    settled(page)
    last = proved(page)
    asked = [one for one in page.evaluate("asked") if one and one["ask"] == "workspace"]
    outlet = asked[-1]["scene"]["robot"]["cables"][0]["outlet"]
    assert outlet != [0.0, 0.0, 0.0] and asked[0]["budget_ms"] < asked[-1]["budget_ms"]
    assert agree(volume(last), exact(moved(hard1, 0, outlet)))
    assert volume(last, "before: ") == volume(first)
    page.keyboard.press("Control+z")
    wait_until(page, f"{LINE}.textContent.includes('before: {str(volume(last)[0])[:4]}')")
    assert agree(volume(proved(page)), exact(hard1))
    page.get_by_role("button", name="workspace", exact=True).click()
    assert page.locator(".edit-volume").is_hidden()


def test_only_what_changes_the_workspace_is_proved_again(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1, cdpr.plan(hard1, seed=0))
    edit(page)
    proving(page)
    page.evaluate(SPY)
    page.evaluate("cdpr.plan({ start: [0.3, 1, 0.4] })")
    assert [one["ask"] for one in page.evaluate("asked") if one and one["ask"] == "workspace"] == []
    page.evaluate("cdpr.move('pillar', [1.2, 1, 0.75])")
    assert "before" in proved(page)
    assert page.evaluate("asked.filter((one) => one?.ask === 'workspace').length") >= 1
    page.keyboard.press("e")
    assert page.locator(".edit-volume").is_hidden()
    edit(page)
    assert page.locator(".edit-volume").is_hidden()


@pytest.mark.parametrize("name", ["cogiro", "plank", "turn"])
def test_scripts_and_the_line_agree_with_the_program(open_page: Open, name: str) -> None:
    scene = cdpr.example(name)
    page = open_page(scene)
    found = page.evaluate("cdpr.workspace({ budgetMs: 3000 })")
    choices = {"plank": {"orientations": ["across", "along"], "valid_at": "any"}}
    known = cdpr.workspace(scene, budget=3.0, **choices.get(name, {}))
    assert agree((found["volume"]["min"], found["volume"]["max"]), (known.volume.min, known.volume.max))
    assert 0.3 < found["decided"] <= 1.0
    edit(page)
    line = proving(page)
    assert agree(volume(line), (known.volume.min, known.volume.max))
    assert ("valid at any of 2 orientations: " in line) == (name == "plank")


def test_what_cannot_be_proved_says_why(open_page: Open, hard1: cdpr.Scene) -> None:
    flat = hard1.replace(workspace=([0, 0.925, 0], [2, 1.075, 2]))
    page = open_page(flat, size=PHONE)
    page.keyboard.press("e")
    page.get_by_role("button", name="workspace", exact=True).click()
    wait_until(page, f"{LINE}.textContent.includes('flat')")
    assert page.locator(".edit-volume").get_attribute("data-kind") == "bad"
    with pytest.raises(Error, match="flat"):
        page.evaluate("cdpr.workspace()")
    with pytest.raises(Error, match="budgetMs: expected a positive number"):
        page.evaluate("cdpr.workspace({ budgetMs: -1 })")
