"""A trajectory file made independently of the program: straight lines at trapezoidal speed, a stop at each waypoint."""

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

import cdpr

Floats = NDArray[np.float64]

GRAVITY = np.array([0.0, 0.0, -9.81])
REFERENCE = 150.0  # N, what tensions are kept close to


def phases(length: float, speed: float, acceleration: float) -> Floats:
    """Durations of speeding up, of constant speed and of braking, s."""
    ramp = min(speed / acceleration, math.sqrt(length / acceleration))
    return np.array([ramp, max(0.0, length / (ramp * acceleration) - ramp), ramp])


def travelled(time: float, length: float, durations: Floats, acceleration: float) -> tuple[float, float, float]:
    """Distance, speed and acceleration along a line at a time."""
    up, whole = durations[0], float(durations.sum())
    if time < up:
        return acceleration * time**2 / 2, acceleration * time, acceleration
    if time <= whole - up:
        return acceleration * up * (time - up / 2), acceleration * up, 0.0
    left = whole - time
    return length - acceleration * left**2 / 2, acceleration * left, -acceleration


def straight(
    scene: cdpr.Scene,
    waypoints: ArrayLike,
    speed: float = 1.0,
    acceleration: float = 2.0,
    rate: float = 100.0,
    tensions: tuple[float, float] = (10.0, 1000.0),
) -> dict[str, Any]:
    """The contents of a trajectory file for a scene at the orientation (1, 0, 0, 0)."""
    path = np.array(waypoints, dtype=float)
    lines = np.diff(path, axis=0)
    lengths = np.linalg.norm(lines, axis=1)
    durations = [phases(length, speed, acceleration) for length in lengths]
    begins = np.concatenate([[0.0], np.cumsum([each.sum() for each in durations])])
    duration = float(begins[-1])
    times = np.append(np.arange(0.0, duration - 0.1 / rate, 1 / rate), duration)
    on = np.clip(np.searchsorted(begins, times, side="right") - 1, 0, len(lines) - 1)
    along = [travelled(t - begins[k], lengths[k], durations[k], acceleration) for t, k in zip(times, on, strict=True)]
    distances, speeds, accelerations = np.array(along).T
    ways = lines[on] / lengths[on, None]
    positions = path[on] + ways * distances[:, None]
    velocities, pushes = ways * speeds[:, None], ways * accelerations[:, None]
    to_outlets = scene.robot.outlets - (positions[:, None] + scene.robot.attachments)
    cable_lengths = np.linalg.norm(to_outlets, axis=2)
    cable_speeds = -np.einsum("tck,tk->tc", to_outlets, velocities) / cable_lengths
    return {
        "format": "cdpr-trajectory",
        "version": 1,
        "scene": {"name": scene.name, "fingerprint": scene._core.fingerprint()},
        "orientation": [1.0, 0.0, 0.0, 0.0],
        "orientation_name": None,
        "duration": duration,
        "length": float(lengths.sum()),
        "rate": rate,
        "limits": {"speed": speed, "acceleration": acceleration, "cable_speed": 0.9, "jerk": 40.0, "blend": 0.0},
        "tension_limits": [list(tensions)] * len(scene.robot.outlets),
        "waypoints": path.tolist(),
        "corners": [
            {"waypoint": k, "kind": "stop", "deviation": 0.0, "time": float(begins[k])} for k in range(1, len(lines))
        ],
        "limiting": [entry for k in range(len(lines)) for entry in binding(float(begins[k]), durations[k])],
        "cables": list(scene.robot.cable_names),
        "times": times.tolist(),
        "positions": positions.tolist(),
        "velocities": velocities.tolist(),
        "accelerations": pushes.tolist(),
        "cable_lengths": cable_lengths.tolist(),
        "cable_speeds": cable_speeds.tolist(),
        "tensions": balancing(scene, positions, pushes).tolist(),
    }


def binding(begin: float, durations: Floats) -> list[dict[str, Any]]:
    """What binds on a line."""
    ends = begin + np.concatenate([[0.0], np.cumsum(durations)])
    limits = ["acceleration", "speed", "acceleration"]
    return [
        {"from": float(a), "to": float(b), "limit": limit, "cable": None}
        for a, b, limit in zip(ends, ends[1:], limits, strict=False)
        if b > a
    ]


def balancing(scene: cdpr.Scene, positions: Floats, pushes: Floats) -> Floats:
    """Tensions under the accelerations, which are like another gravity."""
    reference = [REFERENCE] * len(scene.robot.outlets)
    rows = [
        cdpr.tension_distribution(scene.robot, [position], gravity=GRAVITY - push, reference=reference)[0]
        for position, push in zip(positions, pushes, strict=True)
    ]
    return np.array(rows)
