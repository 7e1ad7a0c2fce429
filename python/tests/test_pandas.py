"""Results as tables of pandas."""

import subprocess
import sys

import numpy as np
import pandas
import pytest
from conftest import TESTDATA

import cdpr


def test_waypoints_nodes_and_history(hard1):
    result = cdpr.plan(hard1, "modified-rrt", seed=3)
    table = result.to_pandas()
    assert list(table.columns) == ["s", "x", "y", "z"] and table.index.name == "waypoint"
    assert (table[["x", "y", "z"]].to_numpy() == result.waypoints).all()
    assert table["s"].iloc[0] == 0 and table["s"].iloc[-1] == pytest.approx(result.cost)
    assert cdpr.refine(hard1, result).to_pandas()["s"].is_monotonic_increasing
    nodes = result.tree.to_pandas()
    assert (nodes[["x", "y", "z"]].to_numpy() == result.tree.states).all()
    assert nodes["parent"].tolist() == result.tree.parents.tolist()
    history = result.history_to_pandas()
    assert history["cost"].tolist() == [milestone.cost for milestone in result.history] and len(history) >= 1
    unsolved = cdpr.plan(hard1, max_samples=0)
    assert unsolved.to_pandas().shape == (0, 4) and unsolved.history_to_pandas().shape == (0, 3)


def test_violations(hard1):
    report = cdpr.check(hard1, [[0.3, 1, 0.3], [0.3, 1, 0.4], [1.7, 1, 1.7]])
    table = report.to_pandas()
    assert len(table) == len(report.violations) and set(table["segment"]) == {1}
    assert table["culprits"].tolist() == [violation.culprits for violation in report.violations]
    assert "margin" in cdpr.check(hard1, cdpr.plan(hard1)).to_pandas().columns


def test_tensions_and_maps(empty):
    along = cdpr.tensions_along(empty, [[0.3, 1, 0.3], [1.7, 1, 1.7]], step=0.1)
    table = along.to_pandas()
    assert (table[[f"tension:{name}" for name in empty.robot.cable_names]].to_numpy() == along.tensions).all()
    assert (table["length:cable 7"] == along.lengths[:, 7]).all() and (table["s"] == along.s).all()
    assert np.array_equal(table["moment_margin"], along.moment_margin, equal_nan=True)
    found = cdpr.wrench_map(empty, step=0.5, projected=True)
    nodes = found.to_pandas()
    row = nodes.iloc[7]
    index = np.unravel_index(7, found.margin.shape)
    assert row["margin"] == found.margin[index] and row[["x", "y", "z"]].tolist() == found.positions[index].tolist()
    assert set(nodes.columns) == {"x", "y", "z", "margin", "force_margin", "moment_margin"}
    assert isinstance(nodes, pandas.DataFrame)


def test_without_pandas_it_says_what_to_install():
    code = f"""
import sys
sys.modules["pandas"] = None
import cdpr
result = cdpr.plan(cdpr.Scene.load({str(TESTDATA / "scenes/hard1.toml")!r}))
try:
    result.to_pandas()
except ImportError as problem:
    print(problem)
"""
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "to_pandas needs pandas: pip install 'cdpr[pandas]'"
