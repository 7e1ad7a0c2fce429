"""Simulate a motion that `cdpr export` wrote, in MuJoCo, and draw how far the platform is off.

    pip install 'cdpr[mujoco,figures]'
    cdpr export hall.toml motion.json -o model.xml
    python simulate.py model.xml -o away.png

Where the controls are tensions, each is that of the motion plus a spring and a damper on the length of its cable: tensions alone
let errors grow. Where they are lengths, they are those of the motion. `--push` pushes the platform for a tenth of a second.
"""

import argparse
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import mujoco
import numpy as np


def simulate(model, rows, gains, push):
    """Times (s), and how far the platform is from its motion then (m) and turned from it (rad)."""
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    cables, begin = len(rows["cables"]), rows["t"][0]
    times = np.arange(begin, rows["t"][-1], model.opt.timestep)
    named = ("ctrl", "lengths", "speeds", "positions", "quaternions", "tensions")
    at = {name: columns_at(times, rows["t"], rows[name]) for name in named}
    by_tension = np.array_equal(rows["ctrl"][:, :cables], rows["tensions"])
    platform = model.body("platform").id
    away, turned = np.zeros((2, len(times)))
    for k, time in enumerate(times):
        away[k] = np.linalg.norm(data.qpos[:3] - at["positions"][k])
        expected = at["quaternions"][k] / np.linalg.norm(at["quaternions"][k])
        turned[k] = 2 * np.arccos(min(1.0, abs(data.qpos[3:7] @ expected)))
        data.xfrc_applied[platform, :3] = push if abs(time - 0.5 * (begin + rows["t"][-1])) < 0.05 else 0
        data.ctrl = at["ctrl"][k]
        if by_tension:
            mujoco.mj_step1(model, data)  # lengths and speeds now
            error = data.ten_length - rows["tendon_leads"] - at["lengths"][k]
            rate = data.ten_velocity - at["speeds"][k]
            data.ctrl[:cables] += gains[0] * error + gains[1] * rate  # MuJoCo keeps it between 0 and the largest tension
            mujoco.mj_step2(model, data)
        else:
            mujoco.mj_step(model, data)
    return times, away, turned


def columns_at(times, known, columns):
    """Columns of numbers at other times, on straight lines between samples."""
    return np.column_stack([np.interp(times, known, column) for column in columns.T])


def draw(file, title, times, away, turned):
    """Both deviations over time."""
    figure, axes = plt.subplots(2, 1, sharex=True, figsize=(7, 4), layout="constrained")
    for ax, numbers, label in zip(axes, (1e3 * away, np.degrees(turned)), ("away, mm", "turned, °"), strict=True):
        ax.plot(times, numbers, linewidth=1)
        ax.set_ylabel(label)
        ax.set_ylim(bottom=0)
        ax.grid(alpha=0.3)
    axes[0].set_title(title)
    axes[1].set_xlabel("time, s")
    figure.savefig(file, dpi=150)


def main() -> None:
    """Simulate a model and its motion."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", type=Path, help="model.xml, with model.npz beside it")
    parser.add_argument("-o", "--output", type=Path, default=Path("away.png"), help="picture to write")
    what = "of the spring, N/m, and of the damper, N·s/m, of each cable; default 100 and 10 times the mass of the platform"
    parser.add_argument("--gains", type=float, nargs=2, metavar=("P", "D"), help=what)
    parser.add_argument("--push", type=float, nargs=3, default=[0, 0, 0], metavar=("X", "Y", "Z"), help="force, N")
    args = parser.parse_args()
    model = mujoco.MjModel.from_xml_path(str(args.model))
    rows = dict(np.load(args.model.with_suffix(".npz")))
    mass = float(model.body("platform").mass[0])
    gains = args.gains or [100 * mass, 10 * mass]
    times, away, turned = simulate(model, rows, gains, args.push)
    print(f"away at most {1e3 * away.max():.3f} mm, turned at most {np.degrees(turned.max()):.4f}°")
    print(f"at the end {1e3 * away[-1]:.3f} mm and {np.degrees(turned[-1]):.4f}°")
    draw(args.output, f"{args.model.stem}: from the motion as planned", times, away, turned)


if __name__ == "__main__":
    main()
