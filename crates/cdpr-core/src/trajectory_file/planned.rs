//! The file of a planned trajectory.

use serde_json::{Value, json};

use super::{CornerKind, Limiting, TRAJECTORY_FORMAT, TRAJECTORY_VERSION, TrajectoryCorner, TrajectoryFile};
use crate::batch::each;
use crate::compiled::CompiledScene;
use crate::error::Error;
use crate::geometry::{Point, Pose, Rotation, Vector, rotation_as_written, wxyz, wxyz_in_turn};
use crate::limits::{LEAST_DEFAULT_RATE, MOST_SAMPLES};
use crate::model::{CommandRows, body};
use crate::path_file::SceneId;
use crate::tolerances::{RECORDED_OVERLAP, SAME_SAMPLE};
use crate::trajectory::timing::{Phase, Timing};
use crate::trajectory::turning_bend::TurningBend;
use crate::trajectory::{
    Attitude, Curve, IN_PARALLEL, Largest, Motion, NearestInTime, Passing, Sample, Trajectory, curve,
};
use crate::trajectory::{instants, nearest_in_time};
use crate::watch::Watch;
use crate::wrench::TensionQp;

impl TrajectoryFile {
    /// A trajectory of a scene along a path, sampled `rate` times per second until it is at rest at the end. Without a rate it is
    /// [`LEAST_DEFAULT_RATE`], or as many times a hundred as keep every point of the platform within [`RECORDED_OVERLAP`] of its motion at
    /// constant rates between samples: what a check of the samples alone allows.
    ///
    /// # Errors
    /// A rate that is not positive or gives too many samples; a solver that reached no answer; [`Error::interrupted`],
    /// [`Error::out_of_time`].
    pub fn of(
        compiled: &CompiledScene,
        path: &[Pose],
        trajectory: &Trajectory,
        rate: impl Into<Option<f64>>,
        watch: &Watch,
    ) -> Result<Self, Error> {
        let scene = compiled.scene();
        let rate = rate.into().unwrap_or_else(|| default_rate(trajectory, compiled.conditions().bodies.reach()));
        let times = sample_times(trajectory.duration(), rate)?;
        let samples = each(times.len(), IN_PARALLEL, &|solver: &mut TensionQp, k| {
            watch.check()?;
            // At rest at the end, even if rounding puts its time slightly earlier.
            let state = if k + 1 < times.len() { times[k] } else { f64::INFINITY };
            Ok(Sample { time: times[k], ..trajectory.sample(solver, state)? })
        })?;
        let turn = scene.orientation();
        let turns =
            trajectory.curve().pieces().iter().flat_map(|piece| piece.attitude().ends()).any(|end| end != *turn);
        let cables = scene.robot().cable_names();
        let (mut largest, nearest) = peaks(compiled, trajectory, &times, turns, watch)?;
        largest.include_tensions(samples.iter().filter_map(|sample| sample.tensions.as_deref()));
        let platform = |of: fn(&Motion) -> [f64; 3]| -> Vec<[f64; 3]> {
            samples.iter().map(|sample| of(&sample.motion).map(|x| x + 0.0)).collect()
        };
        let each = |of: fn(&crate::trajectory::Winding) -> f64| {
            // Zero has no sign.
            let row = |sample: &Sample| sample.windings.iter().map(|winding| of(winding) + 0.0).collect();
            samples.iter().map(row).collect()
        };
        let cable_lengths: Vec<Vec<f64>> = each(|winding| winding.length);
        let tensions: Option<Vec<Vec<f64>>> = samples.iter().map(|sample| sample.tensions.clone()).collect();
        let CommandRows { commands, angles, torques } =
            scene.robot().commands_at_each(&cable_lengths, tensions.as_deref());
        Ok(TrajectoryFile {
            format: TRAJECTORY_FORMAT.to_string(),
            version: TRAJECTORY_VERSION,
            scene: SceneId::of(scene),
            orientation: wxyz(turn),
            orientation_name: scene.orientation_name().map(str::to_string),
            duration: trajectory.duration(),
            length: trajectory.curve().length(),
            rate,
            limits: *trajectory.limits(),
            tension_limits: trajectory.winches().tension_limits().map(<[_]>::to_vec),
            tension_distribution: tensions.is_some().then(|| scene.robot().distribution()),
            waypoints: path.iter().map(|pose| pose.position.into()).collect(),
            waypoint_orientations: turns.then(|| wxyz_in_turn(path.iter().map(|pose| &pose.orientation))),
            corners: corners(trajectory),
            limiting: limiting(trajectory, &cables),
            largest: Some(largest),
            nearest,
            cables: cables.iter().map(ToString::to_string).collect(),
            positions: platform(|motion| motion.position.into()),
            velocities: platform(|motion| motion.velocity.into()),
            accelerations: platform(|motion| motion.acceleration.into()),
            orientations: turns.then(|| wxyz_in_turn(samples.iter().map(|sample| &sample.motion.orientation))),
            angular_velocities: turns.then(|| platform(|motion| motion.angular_velocity.into())),
            angular_accelerations: turns.then(|| platform(|motion| motion.angular_acceleration.into())),
            commands,
            angles,
            torques,
            cable_lengths,
            cable_speeds: each(|winding| winding.speed),
            tensions,
            cable_accelerations: Some(each(|winding| winding.acceleration)),
            curve: Some(exact_curve(trajectory.curve(), turns)),
            timing: Some(exact_timing(trajectory.timing())),
            times,
        })
    }
}

/// The largest rates of a trajectory with samples at these times, and its nearest approach.
fn peaks(
    compiled: &CompiledScene,
    trajectory: &Trajectory,
    times: &[f64],
    turns: bool,
    watch: &Watch,
) -> Result<(Largest, Option<NearestInTime>), Error> {
    let winches = trajectory.winches();
    let mut largest = Largest::default();
    let (mut instants_of, mut poses) = (Vec::new(), Vec::new());
    for (_, time) in instants(times, trajectory.duration()) {
        watch.check()?;
        let motion = trajectory.at(time);
        largest.include(&motion, turns, winches.windings(&motion));
        instants_of.push(time);
        poses.push(Pose::new(motion.position, motion.orientation));
    }
    Ok((largest, nearest_in_time(compiled, &instants_of, &poses, watch)?))
}

/// Samples per second that tell enough: a motion that accelerates by `a` deviates by a h²/8 from the straight line between two
/// positions h apart.
pub(crate) fn default_rate(trajectory: &Trajectory, reach: f64) -> f64 {
    let least: Vec<f64> = sample_times(trajectory.duration(), LEAST_DEFAULT_RATE).unwrap_or_default();
    let instants = instants(&least, trajectory.duration());
    let acceleration = |(_, time)| {
        let motion = trajectory.at(time);
        motion.acceleration.norm() + reach * motion.angular_acceleration.norm()
    };
    let most = instants.map(acceleration).fold(0.0, f64::max);
    let needed = (most / (8.0 * RECORDED_OVERLAP)).sqrt();
    let round = LEAST_DEFAULT_RATE * (needed / LEAST_DEFAULT_RATE).ceil().max(1.0);
    round.min((MOST_SAMPLES / trajectory.duration()).max(LEAST_DEFAULT_RATE))
}

/// Instants at a rate, up to the first at which the motion is at its end: whole periods of a controller.
fn sample_times(duration: f64, rate: f64) -> Result<Vec<f64>, Error> {
    let rate = body::positive("rate", rate)?;
    if duration * rate > MOST_SAMPLES {
        let problem =
            format!("found {rate} per second for {duration:.3} s, which makes more than {MOST_SAMPLES:e} samples");
        return Err(Error::invalid("rate", problem));
    }
    let periods = (duration * rate - SAME_SAMPLE).ceil().max(1.0) as u32;
    Ok((0..=periods).map(|k| f64::from(k) / rate).collect())
}

fn corners(trajectory: &Trajectory) -> Vec<TrajectoryCorner> {
    let corner = |corner: &crate::trajectory::Corner| TrajectoryCorner {
        waypoint: corner.waypoint,
        kind: match corner.passing {
            Passing::Rounded => CornerKind::Rounded,
            Passing::Outward => CornerKind::Outward,
            Passing::Stop => CornerKind::Stop,
        },
        deviation: corner.deviation,
        time: trajectory.timing().when(corner.at),
        turn: corner.turn,
    };
    trajectory.corners().iter().map(corner).collect()
}

fn limiting(trajectory: &Trajectory, cables: &[&str]) -> Vec<Limiting> {
    let named = |found: crate::trajectory::Limiting| {
        let cable = found.cable.map(|k| cables[k].to_string());
        Limiting { from: found.from, to: found.to, limit: found.limit, cable }
    };
    trajectory.limiting().into_iter().map(named).collect()
}

/// Lines as `{"line": [from, to]}`, bends as `{"bend": [six control points]}`, m; if the platform turns somewhere, with the
/// `orientations` at both ends and, where it does, the `length` of the parameter, m. Bends from one turn to another are
/// `{"turning_bend": [position, orientation]}` of the waypoint, with the rates of both along the lines before and after it,
/// `velocities`, m/m, and `spins`, rad/m, and the `length`.
fn exact_curve(curve: &Curve, turns: bool) -> Value {
    let piece = |piece: &curve::Piece| {
        if let Some(bend) = piece.turning() {
            return exact_bend(bend);
        }
        let control: Vec<[f64; 3]> = piece.control().iter().map(|point| (*point).into()).collect();
        let mut json = if piece.is_line() { json!({ "line": control }) } else { json!({ "bend": control }) };
        if turns {
            json["orientations"] = json!(piece.attitude().ends().map(|end| wxyz(&end)));
        }
        if piece.attitude().turns() {
            json["length"] = json!(piece.length);
        }
        json
    };
    curve.pieces().iter().map(piece).collect()
}

fn exact_bend(bend: &TurningBend) -> Value {
    let corner = json!([<[f64; 3]>::from(bend.corner().position), wxyz(&bend.corner().orientation)]);
    let [velocities, spins] = [bend.velocities(), bend.spins()].map(|rates| rates.map(<[f64; 3]>::from));
    json!({ "turning_bend": corner, "velocities": velocities, "spins": spins, "length": bend.length() })
}

/// Rows of time, s, and the parameter of the curve with its first three derivatives then, m, m/s, m/s², m/s³.
fn exact_timing(timing: &Timing) -> Value {
    let row = |phase: &Phase| json!([phase.time, phase.s, phase.speed, phase.acceleration, phase.jerk]);
    timing.phases().iter().map(row).collect()
}

/// Position, velocity and acceleration at an instant, from the exact form in a file.
impl TrajectoryFile {
    /// The motion of the platform at an instant, exactly; before the start or after the end, at rest there.
    ///
    /// # Errors
    /// A file without `curve` and `timing`, or with a form of them that planning does not write.
    pub fn exact(&self) -> Result<(Curve, Timing), Error> {
        let missing = |key: &str| Error::invalid(key, "found none, expected the exact form that planning writes");
        let held = rotation_as_written(self.orientation);
        let pieces = self.curve.as_ref().and_then(Value::as_array).ok_or_else(|| missing("curve"))?;
        let pieces: Vec<curve::Piece> = (pieces.iter().enumerate())
            .map(|(k, piece)| read_piece(piece, &held).ok_or_else(|| strange(&format!("curve[{k}]"))))
            .collect::<Result<_, _>>()?;
        let rows: Vec<[f64; 5]> = (self.timing.clone())
            .map(serde_json::from_value)
            .ok_or_else(|| missing("timing"))?
            .map_err(|_| strange("timing"))?;
        if pieces.is_empty() || rows.is_empty() {
            return Err(strange(if rows.is_empty() { "timing" } else { "curve" }));
        }
        let phase = |[time, s, speed, acceleration, jerk]: [f64; 5]| Phase { time, s, speed, acceleration, jerk };
        Ok((Curve::new(pieces), Timing::new(rows.into_iter().map(phase).collect(), self.duration)))
    }
}

fn strange(place: &str) -> Error {
    Error::invalid(place, "found something else than planning writes")
}

/// A piece; where it has no orientations, the platform is held at this one.
fn read_piece(piece: &Value, held: &Rotation) -> Option<curve::Piece> {
    if let Some(corner) = piece.get("turning_bend") {
        return read_bend(corner, piece);
    }
    let points = |key: &str| serde_json::from_value::<Vec<[f64; 3]>>(piece.get(key)?.clone()).ok();
    let attitude = match piece.get("orientations") {
        Some(ends) => {
            let ends = serde_json::from_value::<[[f64; 4]; 2]>(ends.clone()).ok()?;
            let [from, to] = ends.map(|end| body::unit_quaternion("", end).is_ok().then(|| rotation_as_written(end)));
            Attitude::between(from?, to?)
        }
        None => Attitude::held(*held),
    };
    if let Some([from, to]) = points("line").as_deref() {
        let (from, to): (Point, Point) = ((*from).into(), (*to).into());
        if attitude.turns() {
            let length = read_length(piece)?;
            return Some(curve::Piece::turning_line([from, to], attitude, length));
        }
        let line = || curve::Piece::line(from, to).held_at(attitude.ends()[0]);
        return (Vector::norm(&(to - from)) > 0.0).then(line);
    }
    let control: [[f64; 3]; curve::CONTROL] = points("bend")?.try_into().ok()?;
    let bend = || curve::Piece::bend(control.map(Point::from)).held_at(attitude.ends()[0]);
    (control[0] != control[1] && !attitude.turns()).then(bend)
}

/// A bend from one turn to another.
fn read_bend(corner: &Value, piece: &Value) -> Option<curve::Piece> {
    let (position, orientation) = serde_json::from_value::<([f64; 3], [f64; 4])>(corner.clone()).ok()?;
    body::unit_quaternion("", orientation).ok()?;
    let rates = |key: &str| serde_json::from_value::<[[f64; 3]; 2]>(piece.get(key)?.clone()).ok();
    let (velocities, spins) = (rates("velocities")?.map(Vector::from), rates("spins")?.map(Vector::from));
    let corner = Pose::new(position.into(), rotation_as_written(orientation));
    Some(curve::Piece::turning_bend(TurningBend::new(corner, velocities, spins, read_length(piece)?)))
}

/// The range of the parameter of a piece, m.
fn read_length(piece: &Value) -> Option<f64> {
    piece.get("length")?.as_f64().filter(|length| *length > 0.0 && length.is_finite())
}
