//! The timed motions of a task: one for each leg, in the scene that holds on it, and the whole one that goes through all of them.
//!
//! A leg is a motion from rest to rest. The next one begins with the first sample at which it has ended, so the samples of the whole
//! motion are whole periods of a controller, and each leg's samples are among them. At a stop, the quantities that depend on what is
//! carried are those of the leg that ends there: picked and placed is after that sample.

use crate::batch::each_long;
use crate::compiled::CompiledScene;
use crate::error::Error;
use crate::geometry::wxyz;
use crate::model::Scene;
use crate::model::spec::MotionSpec;
use crate::path_file::SceneId;
use crate::tolerances::SAME_SAMPLE;
use crate::trajectory::{Largest, NearestInTime, Trajectory, checked_limits, unless_untimed};
use crate::trajectory_file::{CornerKind, Limiting, TrajectoryCorner, TrajectoryFile, default_rate};
use crate::watch::{Interrupt, Watch};

use super::{LegPlan, Task, TaskLeg, TaskLegs, same_pose, words};

/// How the legs of a task are timed.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct TaskTiming {
    /// Limits that replace those of the scene where they are set.
    pub limits: MotionSpec,
    /// Samples per second; if not given, what the leg with the largest accelerations needs.
    pub rate: Option<f64>,
}

impl TaskTiming {
    /// Refuses limits with which a leg can surely not be timed, before it is planned.
    ///
    /// # Errors
    /// Limits that are missing or contradictory.
    pub fn checked(&self, scene: &Scene, legs: &TaskLegs) -> Result<(), Error> {
        checked_limits(scene, &self.limits, legs.legs.iter().map(|leg| (&leg.scene, [leg.from.pose, leg.to.pose])))
    }
}

/// The motions of a task.
#[derive(Debug, Clone, PartialEq)]
pub struct TaskMotion {
    /// The motion of each leg as a file of the leg's scene, or why there is none; that is empty for a leg without a path.
    pub legs: Vec<Result<TrajectoryFile, String>>,
    /// The motion through all legs, if each of them has one.
    pub whole: Option<WholeMotion>,
    /// Why tensions are not limited, if they are not; what was assumed about inertia; that speeds are not limited, if they are not.
    pub notes: Vec<String>,
}

/// The motion through all legs of a task.
#[derive(Debug, Clone, PartialEq)]
pub struct WholeMotion {
    /// The motion as samples: no one scene holds on all of it, so there is no exact form. The file names the scene of the task.
    pub file: TrajectoryFile,
    /// When each leg starts, s.
    pub starts: Vec<f64>,
    /// When the last sample is, s.
    pub end: f64,
}

impl TaskMotion {
    /// When a leg starts in the whole motion and when it has ended, s.
    pub fn time_of(&self, leg: usize) -> Option<[f64; 2]> {
        let (whole, motion) = (self.whole.as_ref()?, self.legs[leg].as_ref().ok()?);
        Some([whole.starts[leg], whole.starts[leg] + motion.duration])
    }
}

impl Task {
    /// This task with the motions of its legs, each in the scene that holds on it.
    ///
    /// # Errors
    /// The errors of [`TaskTiming::checked`], a bad rate. A leg that cannot be timed for another reason has that in place of a motion.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::model::{Scene, SceneSpec, TaskRowSpec};
    /// use cdpr_core::task::{TaskTiming, plan_task};
    /// use cdpr_core::{MotionSpec, PlanOptions};
    /// let task = [[1.7, 1.0, 1.0], [1.7, 1.0, 0.3]].map(|go| TaskRowSpec { go: Some(go.into()), ..TaskRowSpec::default() });
    /// let spec = SceneSpec { task: task.to_vec(), query: None, ..cdpr_core::testing::hard1().spec().clone() };
    /// let scene = Scene::new(spec)?;
    /// let limits = MotionSpec { speed: Some(1.0), acceleration: Some(2.0), ..MotionSpec::default() };
    /// let task = plan_task(&scene, &PlanOptions::default(), None, &|| false, &|_, _| ())?;
    /// let task = task.timed(&scene, &TaskTiming { limits, rate: None }, None, &|| false)?;
    /// let whole = task.motion.and_then(|motion| motion.whole).expect("every leg has a motion");
    /// assert!((whole.file.duration - 1.2).abs() < 1e-3); // 0.7 m: half a second to speed up and to slow down, and 0.2 s between
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn timed(
        self,
        scene: &Scene,
        timing: &TaskTiming,
        threads: Option<usize>,
        stop: &Interrupt,
    ) -> Result<Self, Error> {
        timing.checked(scene, &self.legs)?;
        let legs = &self.legs.legs;
        let along = each_long(legs.len(), threads, &|_, _| (), &|k| match self.plans[k].path.is_empty() {
            true => Ok(Err(String::new())),
            false => unless_untimed(along(&legs[k], &self.plans[k], &timing.limits, &Watch::on(stop))),
        })?;
        // All legs have the samples per second that the fastest of them needs.
        let needed = |timed: &Timed| default_rate(&timed.trajectory, timed.compiled.conditions().bodies.reach());
        let rate = timing.rate.unwrap_or_else(|| along.iter().flatten().map(needed).fold(0.0, f64::max));
        let motions = each_long(legs.len(), threads, &|_, _| (), &|k| match &along[k] {
            Ok(Timed { trajectory, compiled }) => {
                let path = &self.plans[k].path;
                unless_untimed(TrajectoryFile::of(compiled, path, trajectory, rate, &Watch::on(stop)))
            }
            Err(reason) => Ok(Err(reason.clone())),
        })?;
        let complete: Option<Vec<&TrajectoryFile>> = motions.iter().map(|motion| motion.as_ref().ok()).collect();
        let whole = complete.map(|legs| WholeMotion::of(scene, &legs)).transpose()?;
        let trajectories = || along.iter().flatten().map(|timed| &timed.trajectory);
        let unlimited = trajectories().find_map(|timed| timed.winches().note());
        let turning = trajectories().filter(|timed| timed.curve().turns());
        let assumed = turning.filter_map(|timed| timed.winches().assumption()).next();
        let speeds = trajectories().find_map(|timed| timed.limits().note());
        let notes = [unlimited, assumed, speeds].into_iter().flatten().map(str::to_string).collect();
        Ok(Task { motion: Some(TaskMotion { legs: motions, whole, notes }), ..self })
    }
}

/// The motion of a leg in its compiled scene.
struct Timed {
    trajectory: Trajectory,
    compiled: CompiledScene,
}

fn along(leg: &TaskLeg, plan: &LegPlan, limits: &MotionSpec, watch: &Watch) -> Result<Timed, Error> {
    let compiled = CompiledScene::new(&leg.scene, Default::default(), Default::default(), watch)?;
    let trajectory = Trajectory::new(&compiled, &plan.path, limits, watch)?;
    Ok(Timed { trajectory, compiled })
}

impl WholeMotion {
    /// The motions of legs one after another. At least one is required; `scene` is that of the task.
    ///
    /// # Errors
    /// Legs with other cables or samples per second than the first one, samples that are not at whole periods, or a leg that begins at
    /// another place than the one before it ends.
    pub fn of(scene: &Scene, legs: &[&TrajectoryFile]) -> Result<Self, Error> {
        let first = legs[0];
        for (k, leg) in legs.iter().enumerate() {
            fits(first, leg, k.checked_sub(1).map(|k| legs[k])).map_err(|e| e.under(&format!("legs[{k}].motion")))?;
        }
        let mut periods = vec![0usize]; // before each leg, and in all
        periods.extend(legs.iter().scan(0, |sum, leg| {
            *sum += leg.times.len() - 1;
            Some(*sum)
        }));
        let time = |periods: usize| periods as f64 / first.rate;
        let starts: Vec<f64> = periods[..legs.len()].iter().map(|periods| time(*periods)).collect();
        let timed = || legs.iter().zip(&starts);
        let (waypoints, corners) = path(legs, &starts);
        let orientation = wxyz(scene.orientation());
        let turns = legs.iter().any(|leg| leg.orientations.is_some() || leg.orientation != orientation);
        let held = |rows: Option<&Vec<[f64; 4]>>, leg: &TrajectoryFile, count: usize| {
            rows.cloned().unwrap_or_else(|| vec![leg.orientation; count])
        };
        let still = |rows: Option<&Vec<[f64; 3]>>, leg: &TrajectoryFile| {
            rows.cloned().unwrap_or_else(|| vec![[0.0; 3]; leg.times.len()])
        };
        let tensions = known(legs, |leg| leg.tensions.as_ref());
        let last = legs.len() - 1;
        let file = TrajectoryFile {
            scene: SceneId::of(scene),
            orientation,
            orientation_name: scene.orientation_name().map(str::to_string),
            duration: starts[last] + legs[last].duration,
            length: legs.iter().map(|leg| leg.length).sum(),
            tension_limits: first.tension_limits.clone().filter(|_| tensions.is_some()),
            tension_distribution: first.tension_distribution.filter(|_| tensions.is_some()),
            waypoints,
            waypoint_orientations: turns.then(|| {
                let rows = legs.iter().map(|leg| held(leg.waypoint_orientations.as_ref(), leg, leg.waypoints.len()));
                chained(&rows.collect::<Vec<_>>())
            }),
            corners,
            limiting: timed().flat_map(|(leg, start)| later(&leg.limiting, *start)).collect(),
            largest: largest(legs),
            nearest: timed().filter_map(|(leg, start)| nearest(leg, *start)).min_by(|a, b| a.value.total_cmp(&b.value)),
            times: (0..=periods[legs.len()]).map(time).collect(),
            positions: rows(legs, |leg| leg.positions.clone()),
            velocities: rows(legs, |leg| leg.velocities.clone()),
            accelerations: rows(legs, |leg| leg.accelerations.clone()),
            orientations: turns.then(|| rows(legs, |leg| held(leg.orientations.as_ref(), leg, leg.times.len()))),
            angular_velocities: turns.then(|| rows(legs, |leg| still(leg.angular_velocities.as_ref(), leg))),
            angular_accelerations: turns.then(|| rows(legs, |leg| still(leg.angular_accelerations.as_ref(), leg))),
            cable_lengths: rows(legs, |leg| leg.cable_lengths.clone()),
            cable_speeds: rows(legs, |leg| leg.cable_speeds.clone()),
            cable_accelerations: known(legs, |leg| leg.cable_accelerations.as_ref()),
            commands: known(legs, |leg| leg.commands.as_ref()),
            angles: known(legs, |leg| leg.angles.as_ref()),
            torques: known(legs, |leg| leg.torques.as_ref()),
            tensions,
            curve: None,
            timing: None,
            // All legs have these in common.
            format: first.format.clone(),
            version: first.version,
            rate: first.rate,
            limits: first.limits,
            cables: first.cables.clone(),
        };
        Ok(WholeMotion { file, starts, end: time(periods[legs.len()]) })
    }
}

/// Checks that a leg can follow the one before it, and has the samples of the first one.
fn fits(first: &TrajectoryFile, leg: &TrajectoryFile, before: Option<&TrajectoryFile>) -> Result<(), Error> {
    if leg.cables != first.cables {
        let problem = format!("found {}, expected those of the first leg", leg.cables.join(", "));
        return Err(Error::invalid("cables", problem));
    }
    if leg.rate != first.rate {
        let problem = format!("found {} samples per second, expected {} as on the first leg", leg.rate, first.rate);
        return Err(Error::invalid("rate", problem));
    }
    let whole = |(k, time): (usize, &f64)| (time * leg.rate - k as f64).abs() <= SAME_SAMPLE;
    if let Some((k, time)) = leg.times.iter().enumerate().find(|sample| !whole(*sample)) {
        let problem = format!("found {time} s, expected {k} periods at {} samples per second", leg.rate);
        return Err(Error::invalid(format!("times[{k}]"), problem));
    }
    let Some(before) = before else { return Ok(()) };
    let (end, begin) = (before.poses()[before.times.len() - 1], leg.poses()[0]);
    if !same_pose(&end, &begin) {
        let problem = format!("found {}, expected where the leg before ends, {}", words(&begin), words(&end));
        return Err(Error::invalid("positions[0]", problem));
    }
    Ok(())
}

/// Rows of legs, each of which begins with the last row of the one before.
fn chained<T: Clone>(legs: &[Vec<T>]) -> Vec<T> {
    let fresh = legs.iter().enumerate().flat_map(|(k, rows)| &rows[usize::from(k > 0)..]);
    fresh.cloned().collect()
}

fn rows<T: Clone>(legs: &[&TrajectoryFile], of: impl Fn(&TrajectoryFile) -> Vec<T>) -> Vec<T> {
    chained(&legs.iter().map(|leg| of(leg)).collect::<Vec<_>>())
}

/// The rows of a quantity, if they are known of all legs.
fn known(legs: &[&TrajectoryFile], of: impl Fn(&TrajectoryFile) -> Option<&Vec<Vec<f64>>>) -> Option<Vec<Vec<f64>>> {
    let all: Option<Vec<Vec<Vec<f64>>>> = legs.iter().map(|leg| of(leg).cloned()).collect();
    all.map(|all| chained(&all))
}

/// The waypoints of all legs, and how they are passed: between two legs with a stop.
fn path(legs: &[&TrajectoryFile], starts: &[f64]) -> (Vec<[f64; 3]>, Vec<TrajectoryCorner>) {
    let (mut waypoints, mut corners) = (Vec::new(), Vec::new());
    for (k, (leg, start)) in legs.iter().zip(starts).enumerate() {
        let before = waypoints.len().max(1) - 1;
        if let Some(last) = k.checked_sub(1) {
            let time = starts[last] + legs[last].duration;
            corners.push(TrajectoryCorner {
                waypoint: before,
                kind: CornerKind::Stop,
                deviation: 0.0,
                time,
                turn: false,
            });
        }
        let later = |corner: &TrajectoryCorner| TrajectoryCorner {
            waypoint: before + corner.waypoint,
            time: start + corner.time,
            ..corner.clone()
        };
        corners.extend(leg.corners.iter().map(later));
        waypoints.extend_from_slice(&leg.waypoints[usize::from(k > 0)..]);
    }
    (waypoints, corners)
}

fn later(limiting: &[Limiting], start: f64) -> impl Iterator<Item = Limiting> {
    limiting.iter().map(move |entry| Limiting { from: start + entry.from, to: start + entry.to, ..entry.clone() })
}

fn nearest(leg: &TrajectoryFile, start: f64) -> Option<NearestInTime> {
    leg.nearest.as_ref().map(|nearest| NearestInTime { time: start + nearest.time, ..nearest.clone() })
}

fn largest(legs: &[&TrajectoryFile]) -> Option<Largest> {
    let all: Option<Vec<Largest>> = legs.iter().map(|leg| leg.largest).collect();
    all?.into_iter().reduce(|largest, leg| largest.and(&leg))
}
