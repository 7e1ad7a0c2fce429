"""Messages for ROS 2: what controllers of trajectories check before they accept one."""

import numpy as np
import pytest
import yaml

import cdpr

DRUM = {"radius": 0.06, "gear": 20.0, "zero": 4.0, "lead": 1.5}


def robot(**keys):
    """Eight cables in a box of 6 m × 4 m × 3 m, whose platform has a mass."""
    outlets = np.array([(x, y, z) for z in (3.0, 0.0) for x in (0.0, 6.0) for y in (0.0, 4.0)])
    attachments = np.where(outlets > (3.0, 2.0, -1.0), 1, -1) * (0.2, 0.2, -0.1)
    corners = [(x, y, z) for x in (-0.2, 0.2) for y in (-0.2, 0.2) for z in (-0.1, 0.1)]
    return cdpr.Robot(outlets, attachments, [corners], tensions=(10.0, 2000.0), mass=20.0, **keys)


def motion(rate, **keys):
    scene = cdpr.Scene(robot(**keys), workspace=((0, 0, 0), (6, 4, 3)))
    size = 1.0 if rate < 1000 else 0.05
    path = np.array([1.5, 1.5, 1.0]) + size * np.array([(0, 0, 0), (1.0, 1.0, 0.5), (1.5, 0.0, 0.2)])
    return cdpr.trajectory(scene, path, speed=1.0, acceleration=2.0, jerk=20.0, cable_speed=1.2, blend=0.05 * size, rate=rate)


def nanoseconds(time):
    assert set(time) == {"sec", "nanosec"} and 0 <= time["nanosec"] < 10**9
    return time["sec"] * 10**9 + time["nanosec"]


def refusals(message, *, takes_effort):
    """Why the joint_trajectory_controller of ros2_controllers would refuse a message: the checks of its
    ``validate_trajectory_msg``, with its defaults."""
    joints, points = message["joint_names"], message["points"]
    if not points:
        yield "no points"
    if not joints or len(set(joints)) < len(joints):
        yield "joints"
    if nanoseconds(message["header"]["stamp"]) != 0:
        yield "starts at another time than now"
    if any(velocity != 0.0 for velocity in points[-1]["velocities"]):  # its limit is float32's epsilon
        yield "moves at the end"
    times = [nanoseconds(point["time_from_start"]) for point in points]
    if any(b <= a for a, b in zip(times, times[1:])):
        yield "times do not increase"
    for point in points:
        if point["effort"] and not takes_effort:
            yield "effort"
        if len(point["positions"]) != len(joints):
            yield "positions"
        if any(len(point[key]) not in (0, len(joints)) for key in ("velocities", "accelerations", "effort")):
            yield "rates"


@pytest.mark.parametrize("rate", [1, 7.3, 100, 1000, 10_000])
def test_controllers_accept_messages(rate, tmp_path):
    moving = motion(rate, stiffnesses=7e5, drums=DRUM)
    rows = {"length": moving.cable_lengths, "command": moving.commands, "angle": moving.angles}
    for joints, positions in rows.items() if rate <= 100 else [("angle", moving.angles)]:
        for effort in (False, True) if rate < 10_000 else (True,):  # reading so many points again takes a minute
            moving.save(tmp_path / "motion.yaml", joints=joints, effort=effort)
            message = yaml.load((tmp_path / "motion.yaml").read_text(), yaml.CSafeLoader)
            assert list(refusals(message, takes_effort=effort)) == []
            assert ("effort" in refusals(message, takes_effort=False)) == effort
            found = {key: np.array([point[key] for point in message["points"]]) for key in ("positions", "velocities")}
            assert np.array_equal(found["positions"], positions)
            if rate >= 100 and joints != "length":
                # Cables hardly stretch: rates are near those of the lengths.
                factor = 1.0 if joints == "command" else DRUM["gear"] / DRUM["radius"]
                assert found["velocities"] == pytest.approx(factor * moving.cable_speeds, abs=0.02 * factor)
            if effort:
                of_cables = moving.torques if joints == "angle" else moving.tensions
                assert np.array_equal([point["effort"] for point in message["points"]], of_cables)


def test_joints_that_are_not_known_are_refused_and_nothing_is_written(tmp_path):
    stiff = motion(10)
    file = tmp_path / "motion.yaml"
    for joints, said in [("command", "without stiffness, they are the lengths"), ("angle", "need the drum of each cable")]:
        with pytest.raises(cdpr.FileError, match=said):
            stiff.save(file, joints=joints)
    with pytest.raises(cdpr.FileError, match="cannot hold joints, which only a ROS 2 message"):
        stiff.save(tmp_path / "motion.csv", joints="length")
    with pytest.raises(cdpr.InputError, match='joints: found "angles", expected one of length, command, angle'):
        stiff.save(file, joints="angles")
    assert not list(tmp_path.iterdir())
    without_stretch = motion(100, drums=DRUM)
    without_stretch.save(file, joints="angle")
    points = yaml.load(file.read_text(), yaml.CSafeLoader)["points"]
    speeds = without_stretch.cable_speeds * DRUM["gear"] / DRUM["radius"]
    assert np.array([point["velocities"] for point in points]) == pytest.approx(speeds, abs=0.01 * abs(speeds).max())
