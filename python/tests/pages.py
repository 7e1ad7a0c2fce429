"""Shared by the tests of HTML pages: a browser, pages opened in it, and what they show."""

import os
import re
import shutil
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Browser, Page, sync_playwright

import cdpr

ROOT = Path(__file__).resolve().parents[2]
SCENES = ROOT / "testdata/scenes"
SCREENSHOTS = ROOT / "target/screenshots"
FLAGS = (
    "--no-sandbox --disable-gpu --use-angle=swiftshader --enable-unsafe-swiftshader --disable-quic --no-first-run"
).split()
NAMES = ("chromium", "google-chrome", "chromium-browser")
HOW = (
    "no Chromium found: install the package chromium (Debian) or Google Chrome, or name its program in CDPR_CHROMIUM; "
    "as root on Debian `make test` installs it"
)
MOST_BYTES = 2_000_000
BYTES_OF_PLANNER = 1_020_000  # in a live page
DESK = (1280, 800)
PHONE = (390, 800)
# What the page itself has made: nothing is fetched.
INSIDE = ("data:", "blob:")
# A path through the pillar of hard1.
THROUGH_THE_PILLAR = [[0.3, 1.0, 0.3], [1.7, 1.0, 1.7]]
HOSTILE = [
    "</script><script>window.hacked = 1</script>",
    "<img src=x onerror='window.hacked = 1'>",
    "\"><svg onload=\"window.hacked = 1\">",
    "<!--<script>{{data}}/*{{script}}*/",
    "__proto__",
]

# What the page that plans says about its path, and whether that is its answer.
STATUS = "document.querySelector('.edit-status')"
SETTLED = f"['good', 'bad'].includes({STATUS}.dataset.kind) && !{STATUS}.classList.contains('busy')"

Open = Callable[..., Page]


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    program = os.environ.get("CDPR_CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), None)
    if program is None:
        (pytest.fail if os.environ.get("CI") else pytest.skip)(HOW)
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=FLAGS)
        yield browser
        browser.close()


@pytest.fixture
def open_page(browser: Browser, tmp_path: Path, request: pytest.FixtureRequest) -> Iterator[Open]:
    """Opens the page of a scene and path, or a page that has been made; checks afterwards that nothing went wrong and
    nothing was fetched."""
    complaints: list[str] = []
    pages: list[Page] = []

    def complain(text: str) -> None:
        complaints.append(text)

    def opened(
        scene: cdpr.Scene | Path,
        path: Any = None,
        size: tuple[int, int] = DESK,
        look: Any = "light",
        file: str = "view.html",
        live: bool = True,
    ) -> Page:
        if isinstance(scene, Path):
            shutil.copy(scene, tmp_path / file)
        else:
            cdpr.save_view(tmp_path / file, scene, path, live=live)
        assert (tmp_path / file).stat().st_size < MOST_BYTES + live * BYTES_OF_PLANNER
        context = browser.new_context(viewport={"width": size[0], "height": size[1]}, color_scheme=look)
        page = context.new_page()
        own = (tmp_path / file).as_uri()
        page.on("console", lambda message: complain(message.text) if message.type == "error" else None)
        page.on("pageerror", lambda error: complain(str(error)))
        page.on("dialog", lambda dialog: (complain(f"dialog {dialog.message}"), dialog.dismiss()))
        page.on("request", lambda r: None if r.url == own or r.url[:5] in INSIDE else complain(f"request {r.url}"))
        page.goto(own)
        wait_until(page, "Boolean(window.cdprViewer?.ready)")
        pages.append(page)
        return page

    yield opened
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    for number, page in enumerate(pages):
        name = re.sub(r"[^a-z0-9]+", "-", request.node.name.removeprefix("test_").lower()).strip("-")
        page.screenshot(path=SCREENSHOTS / f"{name}-{number}.png")
        page.context.close()
    assert complaints == []


def wait_until(page: Page, condition: str, seconds: float = 60.0) -> None:
    """Waits in Python: the page's own policy forbids Playwright to evaluate text within it."""
    end = time.monotonic() + seconds
    while not page.evaluate(condition):
        assert time.monotonic() < end, f"waited {seconds} s for {condition}"
        page.wait_for_timeout(20)


def picture(page: Page) -> str:
    """The 3D view with its labels as a base64 PNG."""
    return str(page.evaluate("cdprViewer.picture().toDataURL()"))


def plain(text: str) -> str:
    """A text of the page with ordinary spaces."""
    return text.replace("\xa0", " ")


def settled(page: Page, seconds: float = 30.0) -> str:
    """Waits for the answer and returns what the page says about it."""
    wait_until(page, SETTLED, seconds)
    return status(page)


def status(page: Page) -> str:
    return page.locator(".edit-text").inner_text().replace("\xa0", " ")


def where(page: Page, name: str) -> np.ndarray[Any, Any]:
    """Where a thing is on the page, px."""
    place = page.evaluate("(name) => cdpr.where(name)", name)
    return np.array([place["x"], place["y"]])


def edit(page: Page) -> None:
    page.keyboard.press("e")
    assert page.locator("#edit-toggle").inner_text() == "Done"
