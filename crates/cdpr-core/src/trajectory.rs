//! Timed motions along a path that keep every limit at every instant.
//!
//! A path of straight lines becomes a curve with continuous curvature ([`corners`]), which is proved free as a whole
//! (`free_space`). The fastest progress along it follows from the limits on a grid ([`rows`], [`fastest`]); a jerk
//! limit is kept by smoothing it ([`timing`]). Bounds between the instants of the grid ([`between`]) then show by how
//! much a limit may be exceeded, and the motion is planned again with tighter limits there. The remaining excess, far
//! below a thousandth, is removed by slowing down the whole motion.
//!
//! The platform may turn between two poses ([`stages`]): about a fixed axis, at a constant rate per length. Bends lead from one
//! turn to another ([`turning_bend`]).

pub mod attitude;
pub mod between;
pub mod corners;
pub mod curve;
pub mod fastest;
mod free_space;
pub mod jet;
mod limits;
pub mod motion;
pub mod moving_mass;
mod peaks;
pub mod rows;
mod schedule;
pub mod stages;
mod timed_plan;
pub mod timing;
pub mod turning_bend;
pub mod turning_corners;
pub mod winches;

pub use attitude::Attitude;
pub use corners::{Corner, Passing};
pub use curve::Curve;
pub use limits::Limit;
pub use motion::Motion;
pub use peaks::{Largest, NearestInTime, instants, nearest_in_time};
pub use timed_plan::{MOST_PATHS, Minimise, TimedPlan, plan_timed};
pub use timing::Timing;
pub use winches::{Winches, Winding};

use std::borrow::Cow;

use crate::batch::each;
use crate::collision::{Engine, Interference, Validity, Violation};
use crate::compiled::CompiledScene;
use crate::error::{Error, ErrorClass};
use crate::geometry::Pose;
use crate::model::spec::MotionSpec;
use crate::model::{Distribution, Scene};
use crate::plan::Query;
use crate::tolerances::{BEYOND_END, TENSION_RESERVES};
use crate::watch::Watch;
use crate::words::length;
use crate::wrench::TensionQp;
use between::{shares, tension_shares};
use schedule::Schedule;
use stages::along_path;

/// A timed motion of a robot's platform, from rest to rest.
#[derive(Debug, Clone)]
pub struct Trajectory {
    curve: Curve,
    corners: Vec<Corner>,
    timing: Timing,
    limits: MotionSpec,
    winches: Winches,
}

/// The state of platform and cables at an instant.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// Time since the start, s.
    pub time: f64,
    /// Motion of the platform.
    pub motion: Motion,
    /// Lengths and rates of the cables, in the order of the robot.
    pub windings: Vec<Winding>,
    /// Tension of each cable, N; `None` if tensions are not limited.
    pub tensions: Option<Vec<f64>>,
}

/// A limit that determines the motion for some time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limiting {
    /// Start of that time, s.
    pub from: f64,
    /// End of that time, s.
    pub to: f64,
    /// The limit that determines the motion.
    pub limit: Limit,
    /// Index of the cable that reaches the limit, for limits of cables.
    pub cable: Option<usize>,
}

impl Trajectory {
    /// The fastest motion along a free path of a scene that keeps the limits of the scene, replaced by those of `given`
    /// that are set. Corners are rounded within the allowed deviation where that is free. The curve keeps all conditions of the
    /// scene, clearances included; a limit of the clearance takes their place.
    ///
    /// Where a turn begins, ends or changes, the platform passes on a bend that is proved free, or stops.
    ///
    /// # Errors
    /// A path that is not free; limits that are missing or contradictory; a place where the cables cannot hold the platform;
    /// [`Error::interrupted`], [`Error::out_of_time`].
    ///
    /// # Source
    /// See [`fastest`] for the timing. Rounding and bounds between instants are new here.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{Point, Pose, Rotation, Vector};
    /// use cdpr_core::{CompiledScene, Trajectory, Watch, path::held, testing};
    /// use cdpr_core::MotionSpec;
    /// let scene = testing::empty();
    /// let limits = MotionSpec { speed: Some(1.0), acceleration: Some(2.0), ..MotionSpec::default() };
    /// let path = held(&scene, &[Point::new(0.5, 1.0, 1.0), Point::new(1.5, 1.0, 1.0)]);
    /// let compiled = CompiledScene::new(&scene, Default::default(), Default::default(), &Watch::NONE)?;
    /// let motion = Trajectory::new(&compiled, &path, &limits, &Watch::NONE)?;
    /// assert!((motion.duration() - 1.5).abs() < 1e-4); // half a second to speed up, half a second to slow down
    ///
    /// let yaw = |angle: f64| Pose::new(Point::new(1.0, 1.0, 1.0), Rotation::from_scaled_axis(Vector::z() * angle));
    /// let limits = MotionSpec { turn_speed: Some(0.1), turn_acceleration: Some(0.2), ..MotionSpec::default() };
    /// let turn = Trajectory::new(&compiled, &[yaw(0.0), yaw(0.1)], &limits, &Watch::NONE)?;
    /// assert!((turn.duration() - 1.5).abs() < 1e-4);
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn new(compiled: &CompiledScene, path: &[Pose], given: &MotionSpec, watch: &Watch) -> Result<Self, Error> {
        let scene = compiled.scene();
        let limits = given.in_scene(scene)?;
        let winches = Winches::of(scene, &limits, path)?;
        let held = scene.keeps_orientation(path);
        if held {
            bounded(&limits, &winches)?;
        }
        // Bends are proved by the exact engine, at the clearance that the motion keeps.
        let (engine, rule) = (Engine::Cspace, Interference::Exact);
        let own;
        let compiled = match limits.moving(scene)? {
            Cow::Borrowed(_) if compiled.is_for(engine, rule) => compiled,
            scene => {
                own = CompiledScene::new(&scene, engine, rule, watch)?;
                &own
            }
        };
        compiled.ready_for(path)?;
        refuse_not_free(compiled, path, watch).map_err(|e| e.with_hints(&limits.larger_clearance(scene)))?;
        let (curve, corners) = along_path(compiled, path, limits.blend(), watch)?;
        let slides = curve.pieces().iter().any(|piece| !piece.turns());
        if !held && (slides || limits.turn_acceleration.is_none()) {
            bounded(&limits, &winches)?;
        }
        if curve.turns() {
            bounded_turns(&limits, &winches)?;
        }
        Self::along(curve, corners, limits, winches, watch)
    }

    /// The fastest motion along a path that keeps more clearance from obstacles than the scene requires, such as a widest path: corners
    /// are rounded only as far as the motion keeps it within a micrometre. `clearance`, m; `None`, or less than that of the scene, is
    /// [`Trajectory::new`]. A limit of the clearance takes its place.
    ///
    /// # Errors
    /// The errors of [`Trajectory::new`]; a path that does not keep the clearance.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::plan::plan_widest;
    /// use cdpr_core::{CompiledScene, MotionSpec, PlanOptions, Trajectory, Watch, testing};
    /// let scene = testing::hard1();
    /// let found = plan_widest(&scene, &PlanOptions::default(), &())?.result;
    /// let compiled = CompiledScene::new(&scene, Default::default(), Default::default(), &Watch::NONE)?;
    /// let limits = MotionSpec { speed: Some(1.0), acceleration: Some(2.0), blend: Some(0.1), ..MotionSpec::default() };
    /// let kept = found.widest.map(|widest| widest.clearance);
    /// let wide = Trajectory::keeping(&compiled, kept, &found.path, &limits, &Watch::NONE)?;
    /// let free = Trajectory::new(&compiled, &found.path, &limits, &Watch::NONE)?;
    /// assert!(wide.duration() >= free.duration()); // with rounder corners, that one is faster
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn keeping(
        compiled: &CompiledScene,
        clearance: Option<f64>,
        path: &[Pose],
        given: &MotionSpec,
        watch: &Watch,
    ) -> Result<Self, Error> {
        let scene = compiled.scene();
        let kept = clearance.map(|clearance| clearance - BEYOND_END);
        let Some(kept) = kept.filter(|kept| *kept > scene.spec().clearance.unwrap_or(0.0)) else {
            return Self::new(compiled, path, given, watch);
        };
        let wider = scene.with_obstacle_clearance(kept)?;
        let wider = CompiledScene::new(&wider, Engine::Cspace, Interference::Exact, watch)?;
        Self::new(&wider, path, given, watch).map_err(|error| match error.place() {
            Some(place) if place.starts_with("waypoints") => error
                .with_hints(&[format!("the motion is to keep {} from obstacles, the width of the path", length(kept))]),
            _ => error,
        })
    }

    /// The fastest motion along a curve, which must be free. It stops at corners that are marked as stops.
    ///
    /// # Errors
    /// A place where the cables cannot hold or accelerate the platform; [`Error::interrupted`], [`Error::out_of_time`].
    pub fn along(
        curve: Curve,
        corners: Vec<Corner>,
        limits: MotionSpec,
        winches: Winches,
        watch: &Watch,
    ) -> Result<Self, Error> {
        let timed = |winches: &Winches| Schedule::new(&curve, &corners, &limits, winches, watch)?.timing(watch);
        // A path to the limit of what the cables can hold is timed with less room for proofs.
        let refused = |timing: &Result<Timing, Error>| {
            winches.tension_limits().is_some() && timing.as_ref().is_err_and(|e| e.place() == Some("waypoints"))
        };
        let (mut timing, mut tried) = (timed(&winches), winches.clone());
        for share in &TENSION_RESERVES[1..] {
            if !refused(&timing) {
                break;
            }
            tried = winches.with_reserve(*share, &limits);
            timing = timed(&tried);
        }
        Ok(Trajectory { timing: timing?, curve, corners, limits, winches: tried })
    }

    /// Duration of the motion, s.
    pub fn duration(&self) -> f64 {
        self.timing.duration()
    }

    /// The curve that the motion follows.
    pub fn curve(&self) -> &Curve {
        &self.curve
    }

    /// The progress along the curve.
    pub fn timing(&self) -> &Timing {
        &self.timing
    }

    /// How the corners of the path are passed.
    pub fn corners(&self) -> &[Corner] {
        &self.corners
    }

    /// The limits that the motion keeps.
    pub fn limits(&self) -> &MotionSpec {
        &self.limits
    }

    /// The cables during the motion.
    pub fn winches(&self) -> &Winches {
        &self.winches
    }

    /// The motion of the platform at an instant; before the start and after the end, at rest there.
    pub fn at(&self, time: f64) -> Motion {
        Motion::at(&self.curve, &self.timing, time)
    }

    /// Platform and cables at an instant. The solver is reused from one instant to the next.
    ///
    /// # Errors
    /// A solver that reached no answer.
    pub fn sample(&self, solver: &mut TensionQp, time: f64) -> Result<Sample, Error> {
        let motion = self.at(time);
        Ok(Sample {
            time,
            windings: self.winches.windings(&motion).collect(),
            tensions: self.winches.tensions(solver, &motion)?,
            motion,
        })
    }

    /// The limits that determine the motion, and when: at each instant one that is used to more than 99.9 %.
    pub fn limiting(&self) -> Vec<Limiting> {
        let mut shares = shares(&self.curve, &self.timing, &self.limits, &self.winches);
        let tensions = tension_shares(&self.curve, &self.timing, &self.winches, &Watch::NONE).unwrap_or_default();
        let binds = |k: &usize| tensions[*k] >= BINDING && tensions[*k] > shares[*k].0;
        let by_tension: Vec<usize> = (0..tensions.len()).filter(binds).collect();
        let scarcest = each(by_tension.len(), IN_PARALLEL, &|solver: &mut TensionQp, n| {
            Ok(self.scarcest_tension(solver, self.timing.phases()[by_tension[n]].time))
        });
        for (k, cable) in by_tension.into_iter().zip(scarcest.expect("nothing stops it")) {
            shares[k] = (tensions[k], cable.map(|cable| (Limit::Tension, Some(cable))));
        }
        let mut list: Vec<Limiting> = Vec::new();
        for (k, (share, reached)) in shares.into_iter().enumerate() {
            let [from, to] = [self.timing.phases()[k].time, self.timing.end_of(k)];
            let Some((limit, cable)) = reached.filter(|_| share >= BINDING) else { continue };
            match list.last_mut() {
                Some(last) if (last.limit, last.cable) == (limit, cable) && last.to >= from => last.to = to,
                _ => list.push(Limiting { from, to, limit, cable }),
            }
        }
        list
    }

    /// Index of the cable whose tension is nearest to one of its limits at an instant, as a share of its range.
    fn scarcest_tension(&self, solver: &mut TensionQp, time: f64) -> Option<usize> {
        let tensions = self.winches.tensions_by(Distribution::Middle, solver, &self.at(time)).ok()??;
        let room = |(tension, [least, most]): (&f64, &[f64; 2])| (tension - least).min(most - tension) / (most - least);
        let rooms: Vec<f64> = tensions.iter().zip(self.winches.tension_limits()?).map(room).collect();
        (0..rooms.len()).min_by(|a, b| rooms[*a].total_cmp(&rooms[*b]))
    }
}

/// Where an error is that concerns one path: that path, the robot with what it carries, and what limits turns if the platform turns on it.
/// Others concern the limits.
const OF_PATH: [&str; 3] = ["waypoints", "robot", "turn_acceleration"];

/// A motion along one of many paths or, in words, why that path has none, so that the others can be timed all the same.
///
/// # Errors
/// Errors that concern the limits of all paths.
pub(crate) fn unless_untimed<T>(timed: Result<T, Error>) -> Result<Result<T, String>, Error> {
    match timed {
        Ok(timed) => Ok(Ok(timed)),
        Err(error) if error.class() == ErrorClass::Interrupted => Ok(Err("interrupted".to_string())),
        Err(error) if error.place().is_some_and(|place| OF_PATH.iter().any(|start| place.starts_with(start))) => {
            Ok(Err(error.to_string()))
        }
        Err(error) => Err(error),
    }
}

/// From this number of instants on, tensions are computed on several threads.
pub(crate) const IN_PARALLEL: usize = 64;

/// Share of a limit from which it counts as binding.
const BINDING: f64 = 0.999;

/// Rejects limits under which the fastest motion would be arbitrarily fast, because accelerations have no limit.
fn bounded(limits: &MotionSpec, winches: &Winches) -> Result<(), Error> {
    if limits.acceleration.is_some()
        || limits.jerk.is_some()
        || limits.cable_acceleration.is_some()
        || winches.tension_limits().is_some()
    {
        return Ok(());
    }
    let note = winches.note().unwrap_or_default();
    let problem = format!("found no limit, expected an acceleration, a jerk or a cable_acceleration, since {note}");
    Err(Error::invalid("acceleration", problem))
}

/// Checks limits for motions between poses, each in its scene, of which the paths are still to be planned.
///
/// # Errors
/// Those of [`MotionSpec::in_scene`], and limits with which one of these motions can surely not be timed.
pub(crate) fn checked_limits<'a>(
    scene: &Scene,
    given: &MotionSpec,
    motions: impl IntoIterator<Item = (&'a Scene, [Pose; 2])>,
) -> Result<(), Error> {
    let limits = given.in_scene(scene)?;
    // A platform that turns on all of its way needs no acceleration.
    let mut held = motions.into_iter().filter(|(scene, [from, to])| !Query::of(scene).between(from, to).turns());
    held.try_for_each(|(scene, [from, _])| bounded(&limits, &Winches::of(scene, &limits, &[from])?))
}

/// Rejects limits under which a turning motion would be arbitrarily fast, because nothing limits how fast a turn may
/// begin: a limit of the acceleration of the platform's origin does not restrict it.
fn bounded_turns(limits: &MotionSpec, winches: &Winches) -> Result<(), Error> {
    let limited = limits.turn_acceleration.is_some() || limits.cable_acceleration.is_some();
    if limited || winches.tension_limits().is_some() {
        return Ok(());
    }
    let note = winches.note().unwrap_or_default();
    let problem = format!(
        "found no limit for a platform that turns, expected a turn_acceleration or a cable_acceleration, since {note}"
    );
    Err(Error::invalid("turn_acceleration", problem))
}

/// Refuses a path that is not proved to be free.
fn refuse_not_free(compiled: &CompiledScene, path: &[Pose], watch: &Watch) -> Result<(), Error> {
    for (segment, pair) in path.windows(2).enumerate() {
        watch.check()?;
        if !compiled.motion_valid(&pair[0], &pair[1]) {
            let first = compiled.violations(&pair[0], &pair[1]).into_iter().next();
            let unknown = || Error::invalid(format!("waypoints[{segment}]"), "found a segment that is not free");
            return Err(first.map_or_else(unknown, |violation| not_free(segment, &violation)));
        }
    }
    Ok(())
}

/// The error about a segment of a path that is not free.
fn not_free(segment: usize, violation: &Violation) -> Error {
    let problem = format!("found a segment that is not free ({}), expected a valid path", violation.sentence());
    Error::invalid(format!("waypoints[{segment}]"), problem)
}
