"""Draw how RRT*'s cost falls towards the best known one as its tree grows; docs/reproduction.md shows the picture.

    python docs/figures/rrt_star_convergence.py docs/figures/rrt-star-convergence.svg

Needs matplotlib.
"""

import sys

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "cdpr"
import matplotlib.pyplot as plt
import numpy as np

import cdpr

NODES = [4000, 8000, 16_000, 32_000, 64_000]
SEEDS = range(10)
BALL = 0.3  # m
BEST_KNOWN = {"hard1": 2.4352, "hard3": 2.6561}  # m
COLOURS = {"hard1": "#1f6fb2", "hard3": "#c0392b"}


def costs(scene: cdpr.Scene, nodes: int) -> list[float]:
    """Raw cost for each seed, m."""
    options = {"post": "none", "near_radius": BALL, "keep_going": True, "max_nodes": nodes, "max_samples": 500_000}
    return [cdpr.plan(scene, "rrt-star", seed=seed, **options).raw_cost for seed in SEEDS]


def main() -> None:
    """Plan, and write the picture."""
    figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
    for name, best in BEST_KNOWN.items():
        scene = cdpr.Scene.load(f"testdata/scenes/{name}.toml")
        found = np.array([costs(scene, nodes) for nodes in NODES])
        middle = np.mean(found, axis=1)  # no number where a seed is unsolved
        axes.plot(NODES, middle, "o-", color=COLOURS[name], label=f"{name}, mean of {len(SEEDS)} seeds")
        axes.fill_between(NODES, np.min(found, axis=1), np.max(found, axis=1), color=COLOURS[name], alpha=0.2)
        axes.axhline(best, color=COLOURS[name], linestyle="--", linewidth=1, label=f"{name}, best known {best} m")
        print(name, [f"{cost:.4f}" for cost in middle], f"unsolved {int(np.isnan(found).sum())}")
    axes.set_xscale("log")
    axes.minorticks_off()
    axes.set_xticks(NODES, [f"{nodes:,}" for nodes in NODES])
    axes.set_xlabel("nodes of the tree")
    axes.set_ylabel("length of the path (m)")
    axes.legend()
    axes.grid(alpha=0.3)
    figure.savefig(sys.argv[1], metadata={"Date": None})


if __name__ == "__main__":
    main()
