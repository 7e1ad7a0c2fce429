"""Options of searches for a path."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Literal, TypeAlias, TypedDict

from ._arrays import finite, number, whole
from ._given import flag, text
from ._questions import Engine, Interference, judges

Planner: TypeAlias = Literal["anytime", "two-trees", "rrt-connect", "modified-rrt", "rrt", "rrt-star"]
Post: TypeAlias = Literal["both", "backward", "forward", "backward-only", "forward-only", "taut", "none"]


class SearchOptions(TypedDict, total=False):
    """Keywords of :func:`cdpr.plan` that :func:`cdpr.plan_many` and :func:`cdpr.replan` take as well."""

    seed: int
    step: float | None
    post: Post | None
    budget: float | None
    repeats: int | None
    max_samples: int | None
    max_nodes: int | None
    keep_going: bool
    target_cost: float | None
    gap: float | None
    extend_step: float | None
    goal_bias: float | None
    check_goal: bool
    near_radius: float | None
    near_cap: float | None
    engine: Engine
    interference: Interference
    proof: bool


def unknown_option(options: Mapping[str, object]) -> str | None:
    """Return the first name that is no option of a search."""
    return min(set(options) - set(SearchOptions.__annotations__), default=None)


def search_options(
    planner: Planner,
    *,
    seed: int = 0,
    step: float | None = None,
    post: Post | None = None,
    budget: float | None = None,
    repeats: int | None = None,
    max_samples: int | None = None,
    max_nodes: int | None = None,
    keep_going: bool = False,
    target_cost: float | None = None,
    gap: float | None = None,
    extend_step: float | None = None,
    goal_bias: float | None = None,
    check_goal: bool = False,
    near_radius: float | None = None,
    near_cap: float | None = None,
    engine: Engine = "cspace",
    interference: Interference = "exact",
    proof: bool = True,
) -> tuple[str, str, str, int, float | None, str | None, int | None, float | None, str, bool]:
    """Return the options of a search as the core takes them."""
    settings = {
        "max_samples": None if max_samples is None else whole("max_samples", max_samples),
        "max_nodes": None if max_nodes is None else whole("max_nodes", max_nodes),
        "keep_going": flag("keep_going", keep_going),
        "target_cost": None if target_cost is None else finite("target_cost", target_cost),
        "gap": None if gap is None else finite("gap", gap),
        "extend_step": None if extend_step is None else finite("extend_step", extend_step),
        "goal_bias": None if goal_bias is None else finite("goal_bias", goal_bias),
        "check_goal": flag("check_goal", check_goal),
        "near_radius": None if near_radius is None else finite("near_radius", near_radius),
        "near_cap": None if near_cap is None else finite("near_cap", near_cap),
    }
    return (
        text("planner", planner),
        *judges(engine, interference),
        whole("seed", seed),
        None if step is None else number("step", step),
        None if post is None else text("post", post),
        None if repeats is None else whole("repeats", repeats),
        None if budget is None else number("budget", budget),
        json.dumps(settings),
        flag("proof", proof),
    )
