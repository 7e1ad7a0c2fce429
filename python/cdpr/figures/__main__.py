"""Draw the figures of a run: ``python -m cdpr.figures FOLDER -o DIR``."""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from matplotlib import pyplot

from .._batch import BatchResult, load_tables, summary_rows
from ._charts import boxes, repeats, step_sweep
from ._convergence import convergence
from ._style import COLUMN, style

_MOST_BOXES = 12  # in one figure; of longer sweeps, every k-th variant is drawn


def drawn(batch: BatchResult) -> Iterator[str]:
    """Draw path lengths of each scenario, also over time, reductions and times of each sweep: one title for each new figure."""
    rows = [row for row in summary_rows(batch) if row["solved"]]
    together: dict[tuple[str, str], list[dict[str, Any]]] = {}
    for row in rows:
        together.setdefault((row["scenario"], row.get("of", "")), []).append(row)
    for (scenario, swept), variants in together.items():
        first = min((row["repeats"] for row in variants if "repeats" in row), default=None)
        names = [row["method"] for row in variants if row.get("repeats") == first]
        names = names[:: -(-len(names) // _MOST_BOXES)]
        _, ax = pyplot.subplots(figsize=(max(COLUMN, 0.8 * len(names)), 2.4), layout="constrained")
        ax.set_title(scenario)
        boxes(batch, "reduction" if swept else "cost", scenario=scenario, methods=names, ax=ax)
        yield f"{scenario} {swept} reduction" if swept else f"{scenario} cost"
    for key, chart in (("step", step_sweep), ("repeats", repeats)):
        if any(key in row for row in rows):
            chart(batch, "reduction")
            yield f"reduction over {key}"
            chart(batch, "post_seconds")
            yield f"time over {key}"
    for scenario in dict.fromkeys(row["scenario"] for row in rows if batch.history is not None):
        convergence(batch, scenario=scenario)[0].set_title(scenario)
        yield f"{scenario} convergence"


def main() -> None:
    """Read the command line, and write every figure."""
    parser = argparse.ArgumentParser(prog="python -m cdpr.figures", description="Draw the figures of a run of cdpr batch.")
    parser.add_argument("folder", type=Path, help="folder of the run")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="DIR", help="folder of the figures")
    parser.add_argument("--format", choices=["svg", "pdf", "png"], default="svg", help="default: svg")
    given = parser.parse_args()
    try:
        batch = load_tables(given.folder)
        given.output.mkdir(parents=True, exist_ok=True)
        with style():
            for k, title in enumerate(drawn(batch), 1):
                name = "-".join(re.findall("[a-z0-9]+", title.lower()))[:80]
                pyplot.savefig(given.output / f"{k:02}-{name}.{given.format}")
                pyplot.close()
    except (OSError, ValueError) as problem:
        parser.error(str(problem))


if __name__ == "__main__":
    main()
