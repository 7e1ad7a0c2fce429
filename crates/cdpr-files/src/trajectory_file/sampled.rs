//! Samples of any source as a whole trajectory, without limits.

use cdpr_core::Scene;
use cdpr_core::error::Error;
use cdpr_core::geometry::{Vector, path_length, rotation_as_written, wxyz};
use cdpr_core::model::CommandRows;
use cdpr_core::model::spec::MotionSpec;
use cdpr_core::path::held;
use cdpr_core::path_file::SceneId;
use cdpr_core::trajectory::{Motion, Winches, Winding};
use cdpr_core::trajectory_check::Recorded;
use cdpr_core::trajectory_file::{TRAJECTORY_FORMAT, TRAJECTORY_VERSION, TrajectoryFile};

use super::LoadedTrajectory;

impl LoadedTrajectory {
    /// The whole trajectory: as it is in a JSON file, otherwise its samples, without limits. With a scene, at the orientation of the
    /// trajectory and with its cables in the order of the robot (as [`scene_of_loaded`](super::scene_of_loaded) gives them), lengths
    /// and speeds of cables that a table does not have are computed.
    ///
    /// # Errors
    /// A table without orientation or cables, and no scene.
    pub fn whole(self, scene: Option<&Scene>) -> Result<TrajectoryFile, Error> {
        let LoadedTrajectory { motion, cables, orientation, file } = self;
        let Some(scene) = scene else { return file.map_or_else(|| sampled(&motion, cables, orientation, None), Ok) };
        let cables = scene.robot().cable_names().iter().map(ToString::to_string).collect();
        let orientation = Some(wxyz(scene.orientation()));
        file.map_or_else(|| sampled(&motion, cables, orientation, Some(scene)), Ok)
    }
}

/// Converts the samples of a table to a trajectory without limits. The samples become the waypoints, and time starts at the first
/// one. If the table has no cable lengths or speeds, they are computed from the robot of the scene.
fn sampled(
    motion: &Recorded,
    cables: Vec<String>,
    orientation: Option<[f64; 4]>,
    scene: Option<&Scene>,
) -> Result<TrajectoryFile, Error> {
    let missing = |columns: &str| Error::invalid(columns, "found no such columns, expected them or the scene");
    // The orientation of a scene counts only where the platform does not turn; without a scene, no cables are computed.
    let orientation = orientation.or_else(|| motion.orientations.as_ref().map(|turns| wxyz(&turns[0])));
    let orientation = orientation.ok_or_else(|| missing("qw"))?;
    let motions = motion.motions(&rotation_as_written(orientation));
    let winches = scene.map(|scene| Winches::of(scene, &MotionSpec::default(), &held(scene, &motion.positions[..1])));
    let winches = winches.transpose()?;
    let windings = |of: fn(&Winding) -> f64| {
        let row = |winches: &Winches, now: &Motion| winches.windings(now).map(|w| of(&w)).collect();
        winches.as_ref().map(|winches| motions.iter().map(|now| row(winches, now)).collect())
    };
    let columns =
        |known: &Option<Vec<Vec<f64>>>, of, name| known.clone().or_else(|| windings(of)).ok_or_else(|| missing(name));
    let cable_lengths = columns(&motion.cable_lengths, |winding| winding.length, "length")?;
    let computed = scene.map(|scene| scene.robot().commands_at_each(&cable_lengths, motion.tensions.as_deref()));
    let CommandRows { commands, angles, torques } = motion.winches.clone().or(computed.unwrap_or_default());
    let [first, .., last] = motion.times[..] else { return Err(missing("t")) };
    let positions: Vec<[f64; 3]> = motion.positions.iter().map(|p| (*p).into()).collect();
    let rows = |rate: fn(&Motion) -> Vector| -> Vec<[f64; 3]> { motions.iter().map(|now| rate(now).into()).collect() };
    Ok(TrajectoryFile {
        format: TRAJECTORY_FORMAT.to_string(),
        version: TRAJECTORY_VERSION,
        scene: scene.map_or_else(|| SceneId { name: String::new(), fingerprint: String::new() }, SceneId::of),
        orientation,
        orientation_name: None,
        duration: last - first,
        length: path_length(&motion.positions),
        rate: (motion.times.len() - 1) as f64 / (last - first),
        limits: MotionSpec { blend: Some(0.0), ..MotionSpec::default() },
        tension_limits: None,
        tension_distribution: motion.tension_distribution,
        waypoints: positions.clone(),
        waypoint_orientations: None,
        corners: Vec::new(),
        limiting: Vec::new(),
        largest: None,
        nearest: None,
        times: motion.times.iter().map(|time| time - first).collect(),
        velocities: rows(|now| now.velocity),
        accelerations: rows(|now| now.acceleration),
        orientations: motion.orientations.as_ref().map(|turns| turns.iter().map(wxyz).collect()),
        angular_velocities: motion.orientations.as_ref().map(|_| rows(|now| now.angular_velocity)),
        angular_accelerations: motion.orientations.as_ref().map(|_| rows(|now| now.angular_acceleration)),
        cable_lengths,
        cable_speeds: columns(&motion.cable_speeds, |winding| winding.speed, "speed")?,
        tensions: motion.tensions.clone(),
        commands,
        angles,
        torques,
        cable_accelerations: motion.cable_accelerations.clone().or_else(|| windings(|winding| winding.acceleration)),
        curve: None,
        timing: None,
        cables,
        positions,
    })
}
