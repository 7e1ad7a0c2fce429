"""Time the planner inside the page, in Chromium: default options, one plan for each seed, as the page reports them.

    pip install playwright
    python benches/page_times.py                   # hard1 hard3 forest cogiro closed
    python benches/page_times.py hard3 --seeds 101

Run it in the folder of the project. It needs Chromium or Google Chrome, whose program CDPR_CHROMIUM can name. The first
plan of each page is left out: it compiles the planner.
"""

from __future__ import annotations

import argparse
import os
import shutil
import statistics
import tempfile
from pathlib import Path

from playwright.sync_api import Page, sync_playwright

import cdpr

SCENES = ("hard1", "hard3", "forest", "cogiro", "closed")
BROWSERS = ("chromium", "google-chrome", "chromium-browser")
FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]


def milliseconds(page: Page, seed: int) -> float:
    """The time of one plan; the page reports none for an answer that it remembers."""
    return float(page.evaluate("(seed) => cdpr.plan({ seed }).then((answer) => answer.milliseconds)", seed))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", default=SCENES, help="names in testdata/scenes")
    parser.add_argument("--seeds", type=int, default=31, help="number of plans (default: 31)")
    args = parser.parse_args()
    program = os.environ.get("CDPR_CHROMIUM") or next(filter(None, map(shutil.which, BROWSERS)), None)
    with sync_playwright() as playwright, tempfile.TemporaryDirectory() as folder:
        browser = playwright.chromium.launch(executable_path=program, args=FLAGS)
        print("| scene | median | shortest | longest |\n|---|---|---|---|")
        for name in args.scenes:
            file = Path(folder) / f"{name}.html"
            cdpr.save_view(file, cdpr.Scene.load(f"testdata/scenes/{name}.toml"))
            page = browser.new_page()
            page.goto(file.as_uri())
            page.wait_for_function("window.cdpr !== undefined")
            times = [milliseconds(page, seed) for seed in range(args.seeds + 1)][1:]
            print(f"| {name} | {statistics.median(times):.1f} ms | {min(times):.1f} ms | {max(times):.1f} ms |", flush=True)
            page.close()
        browser.close()


if __name__ == "__main__":
    main()
