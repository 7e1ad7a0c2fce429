"""The notebooks of python/examples run, and their stored output is reproduced."""

import nbformat
import pytest
from conftest import ROOT
from nbclient import NotebookClient

EXAMPLES = ROOT / "python/examples"
NOTEBOOKS = sorted(path.name for path in EXAMPLES.glob("*.ipynb"))
MOST_BYTES = 400_000


def outputs(notebook):
    """The printed output and the number of pictures of each cell."""
    found = []
    for cell in notebook.cells:
        shown = cell.get("outputs", [])
        assert all(output.output_type in ("stream", "display_data") for output in shown), cell.source
        assert all(output.name == "stdout" for output in shown if output.output_type == "stream"), cell.source
        text = "".join(output.text for output in shown if output.output_type == "stream")
        found.append((text, sum("image/png" in output.get("data", {}) for output in shown)))
    return found


def test_there_are_four():
    assert NOTEBOOKS == ["move_outlets.ipynb", "plan_first_path.ipynb", "winch_table.ipynb", "wrench_feasible.ipynb"]


@pytest.mark.long
@pytest.mark.parametrize("name", NOTEBOOKS)
def test_a_notebook_runs_and_prints_what_is_stored(name):
    stored = nbformat.read(EXAMPLES / name, as_version=4)
    fresh = nbformat.read(EXAMPLES / name, as_version=4)
    NotebookClient(fresh, timeout=300, kernel_name="python3", resources={"metadata": {"path": str(EXAMPLES)}}).execute()
    assert outputs(fresh) == outputs(stored)
    assert sum(pictures for _, pictures in outputs(stored)) >= 5


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_a_notebook_is_small_and_tells_nothing_of_the_machine(name):
    text = (EXAMPLES / name).read_text()
    assert len(text) < MOST_BYTES
    assert str(ROOT) not in text and "site-packages" not in text
    notebook = nbformat.read(EXAMPLES / name, as_version=4)
    assert notebook.metadata.kernelspec.name == "python3"
    assert all(not cell.metadata for cell in notebook.cells)
