"""A platform at rest on elastic cables, computed independently of the core: pulleys after Pott, equilibrium by SciPy."""

import numpy as np
from scipy.optimize import root
from scipy.spatial.transform import Rotation

GRAVITY = np.array([0.0, 0.0, -9.81])


def taut(robot, attachments):
    """Length of each taut cable to attachments in the world (m), and the unit vector in which it pulls there."""
    found = [_round(*ends) for ends in zip(robot.outlets, robot.pulleys, attachments, strict=True)]
    return np.array([length for length, _ in found]), np.array([pull for _, pull in found])


def _round(outlet, pulley, attachment):
    line = attachment - outlet
    if pulley is None:
        return np.linalg.norm(line), -line / np.linalg.norm(line)
    radius, axis = pulley["radius"], np.array(pulley["axis"]) / np.linalg.norm(pulley["axis"])
    height = line @ axis
    across = line - height * axis
    distance = np.linalg.norm(across)
    side = across / distance
    to_centre = np.hypot(distance - radius, height)
    free = np.sqrt(to_centre**2 - radius**2)
    wrap = np.pi - np.arctan2(height, distance - radius) - np.arccos(radius / to_centre)
    exit_ = outlet + radius * ((1 - np.cos(wrap)) * side + np.sin(wrap) * axis)
    return radius * (wrap % (2 * np.pi)) + free, (exit_ - attachment) / np.linalg.norm(exit_ - attachment)


def lengths_at(robot, position, turn):
    """Length of each taut cable with the platform at a position (m), turned by a Rotation."""
    return taut(robot, position + turn.apply(robot.attachments))[0]


def settled(robot, position, commands, *, turn=None, force=None):
    """Where a platform whose winches were commanded these lengths comes to rest, from a pose near by: displacement (m) and turn (rad).

    The stiffness of the cables and the leads of the drums are those of the robot; `force` (N) acts at the centre of mass.
    """
    turn = Rotation.identity() if turn is None else turn
    leads = np.array([(drum or {}).get("lead", 0.0) for drum in robot.drums])
    weight = robot.mass * GRAVITY + (0 if force is None else force)

    def missing(step):
        moved = Rotation.from_rotvec(step[3:]) * turn
        arms = moved.apply(robot.attachments)
        lengths, pulls = taut(robot, position + step[:3] + arms)
        tensions = robot.stiffnesses * np.maximum((leads + lengths) / (leads + commands) - 1, 0)
        forces = pulls * tensions[:, None]
        moments = np.cross(arms, forces).sum(axis=0) + np.cross(moved.apply(robot.center_of_mass), weight)
        return np.append(forces.sum(axis=0) + weight, moments) / 1e3

    found = root(missing, np.array([0.0, 0.0, -0.005, 0.0, 0.0, 0.0]), tol=1e-12)
    assert np.abs(missing(found.x)).max() < 1e-8, found
    return found.x[:3], found.x[3:]
