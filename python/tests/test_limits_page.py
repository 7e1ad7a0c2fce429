"""The page of limits states the numbers of the code."""

import re

from conftest import ROOT

STATED = {
    "MOST_CABLES": "cables of a robot | 256 |",
    "MOST_WRENCH_CABLES": "with `[wrench]` | 24 |",
    "MOST_LOADS": "`loads` of a scene | 16 |",
    "MOST_BODIES": "all obstacles of a scene | 10 000 |",
    "MOST_CORNERS": "corners of one convex body | 1000 |",
    "MOST_ORIENTATIONS": "orientations of a scene | 1000 |",
    "MOST_TEXT_BYTES": "experiment files | 16 MB |",
    "MOST_XML_BYTES": "(XML) | 1 MB,",
    "MOST_XML_NODES": "100 000 nodes |",
    "MOST_CROSSINGS": "inner corners | 2000 |",
    "MOST_MESH_BYTES": "file | 100 MB |",
    "MOST_TRIANGLES": "triangles | 500 000 |",
    "MOST_POLYGON_CORNERS": "corners of a polygon | 2000 |",
    "MOST_PIECES": "connected pieces | 5000 |",
    "MOST_PARTS": "parts of one piece | 256 |",
    "MOST_PARTS_IN_ALL": "parts of all pieces | 5000 |",
    "MOST_PART_CORNERS": "an exact hull | 64 |",
    "MOST_SAMPLES": "samples of a motion | 10 000 000 |",
    "MOST_TRAJECTORY_BYTES": "trajectory file that is read | 200 MB |",
    "MOST_CERTIFICATE_BYTES": "certificate that is read | 200 MB |",
    "MOST_CERTIFICATE_BOXES": "boxes of a certificate | 1 000 000 |",
    "MOST_TABLE_BYTES": "table of a run | 1 GB |",
    "MOST_SECONDS": "time budget | 1 000 000 000 s |",
    "MOST_THREADS": "threads | 1024 |",
    "MOST_ROWS_PER_TRIAL": "per trial | 5000 |",
}
UNITS = {"MB": 10**6, "GB": 10**9}


def test_the_page_states_the_limits_of_the_code():
    code = (ROOT / "crates/cdpr-core/src/limits.rs").read_text()
    known = dict(re.findall(r"pub const (\w+): \w+ = ([\d_.e]+);", code))
    page = (ROOT / "docs/limits.md").read_text()
    for name, words in STATED.items():
        assert words in page, name
        number, unit = re.search(r"([\d ]*\d) ?(MB|GB)?", words.split("|")[1] if "|" in words[:-1] else words).groups()
        assert int(number.replace(" ", "")) * UNITS.get(unit, 1) == float(known[name].replace("_", "")), name
