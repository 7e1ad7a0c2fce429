//! The tensions of a moving platform, computed without the code that plans trajectories.

use std::borrow::Cow;

use nalgebra::{DVector, Matrix3, Matrix6xX, Vector6};

use super::faults::{FaultKind, Faults, Instant, number};
use super::recorded::Recorded;
use super::rules::{Column, Rules};
use crate::choice::Choice;
use crate::error::Error;
use crate::geometry::{Rotation, Vector};
use crate::model::{Distribution, Robot, Scene};
use crate::tolerances::{RECORDED_BALANCE, RECORDED_CHOICE, RECORDED_RESERVE, RECORDED_SHARE, RECORDED_TENSION};
use crate::trajectory::{Limit, Motion};
use crate::watch::Watch;
use crate::wrench::{Balance, Loads, Statics, TensionQp};

/// Tensions at all samples, and notes on what could not be checked.
pub fn check(
    scene: &Scene,
    motion: &Recorded,
    motions: &[Motion],
    rules: &Rules,
    faults: &mut Faults,
    watch: &Watch,
) -> Result<Vec<String>, Error> {
    let (forces, mut solver) = (Forces::of(scene), TensionQp::default());
    let limited = rules.winches.tension_limits().is_some();
    let named = motion.tension_distribution.or(scene.robot().spec().tension_distribution).filter(|_| limited);
    for (k, now) in motions.iter().enumerate() {
        watch.check()?;
        let derived = |known: bool, rate: fn(&Motion) -> Vector| if known { 0.0 } else { spread(motions, k, rate) };
        let turn_known = motion.orientations.is_none() || motion.angular_accelerations.is_some();
        let uncertain = [
            derived(motion.accelerations.is_some(), |now| now.acceleration),
            derived(turn_known, |now| now.angular_acceleration),
        ];
        let state = State { step: k, time: motion.times[k], motion: now, uncertain };
        match &motion.tensions {
            Some(tensions) => {
                forces.check(&state, &tensions[k], faults);
                if let Some(chosen) = named {
                    forces.compare(&state, &tensions[k], chosen, &mut solver, faults)?;
                }
                if limited {
                    let others = forces.cases().get(1..).unwrap_or_default();
                    forces.exist(&state, others, &mut solver, faults)?;
                }
            }
            None if limited => forces.exist(&state, forces.cases(), &mut solver, faults)?,
            None => {}
        }
        if rules.limits.wrench_margin() > 0.0 {
            margin(rules, &state, faults);
        }
    }
    let mut notes = match (&motion.tensions, forces.unknown()) {
        (Some(_), Some(why)) => vec![format!("the balance of the tensions is not checked: {why}")],
        (None, _) => rules.winches.note().map(str::to_string).into_iter().collect(),
        _ => Vec::new(),
    };
    notes.extend(rules.winches.assumption().map(str::to_string));
    Ok(notes)
}

/// Whether tensions exist, and the wrench margin is left, at the instants between the samples of a motion in exact form.
pub fn check_between(
    scene: &Scene,
    fine: &Recorded,
    motions: &[Motion],
    rules: &Rules,
    faults: &mut Faults,
    watch: &Watch,
) -> Result<(), Error> {
    if rules.winches.tension_limits().is_none() {
        return Ok(());
    }
    let (forces, mut solver) = (Forces::of(scene), TensionQp::default());
    for (k, now) in motions.iter().enumerate() {
        watch.check()?;
        let state = State { step: k, time: fine.times[k], motion: now, uncertain: [0.0; 2] };
        forces.exist(&state, forces.cases(), &mut solver, faults)?;
        if rules.limits.wrench_margin() > 0.0 {
            margin(rules, &state, faults);
        }
    }
    Ok(())
}

/// How far a derived acceleration may be from the true one: how much it differs from its neighbours, and a twentieth.
fn spread(motions: &[Motion], k: usize, rate: fn(&Motion) -> Vector) -> f64 {
    let (near, own) = (&motions[k.saturating_sub(1)..(k + 2).min(motions.len())], rate(&motions[k]));
    let differs = near.iter().map(|other| (rate(other) - own).norm()).fold(0.0, f64::max);
    differs + 0.05 * own.norm()
}

fn margin(rules: &Rules, state: &State, faults: &mut Faults) {
    let found = rules.winches.tension_shares(&[*state.motion]);
    let share = found.ok().and_then(|shares| shares.first().map(|found| found.share));
    if share.is_some_and(|share| share <= 1.0 + RECORDED_SHARE) {
        return;
    }
    let margin = rules.limits.wrench_margin();
    let (step, time, limit) = (state.step, state.time, Some(margin));
    let excess = share.unwrap_or(f64::INFINITY);
    let kind = FaultKind::WrenchMargin;
    faults.add(&Instant { step, time, kind, culprits: &[], found: None, limit, excess }, || {
        format!("less than the wrench margin of {} N is left", number(margin))
    });
}

/// The platform at an instant.
#[derive(Clone, Copy)]
struct State<'a> {
    /// Index of the sample.
    step: usize,
    /// Time of the instant, s.
    time: f64,
    /// The motion of the platform.
    motion: &'a Motion,
    /// How far acceleration and angular acceleration may be from the true ones, m/s² and rad/s².
    uncertain: [f64; 2],
}

impl<'a> State<'a> {
    fn fault(&self, kind: FaultKind, culprits: &'a [&'a str], [found, limit]: [Option<f64>; 2]) -> Instant<'a> {
        let excess = found.zip(limit).map_or(0.0, |(found, limit)| (found - limit).abs());
        Instant { step: self.step, time: self.time, kind, culprits, found, limit, excess }
    }
}

/// The loads that the cables of a robot must balance.
struct Forces<'a> {
    names: Vec<&'a str>,
    /// Minimum and maximum tension of each cable, N, where they are known.
    limits: Vec<Option<[f64; 2]>>,
    /// The platform in each load case, or why its loads are unknown.
    platforms: Result<Vec<Platform<'a>>, String>,
}

/// A platform with mass in one load case.
struct Platform<'a> {
    robot: &'a Robot,
    loads: Loads,
    /// The statics at the orientation of the scene.
    statics: Statics,
    /// Mass of the platform, kg.
    mass: f64,
    /// Inertia about the centre of mass, platform axes, kg·m².
    inertia: Matrix3<f64>,
}

impl Platform<'_> {
    fn statics_at(&self, orientation: &Rotation) -> Result<Cow<'_, Statics>, Error> {
        if *orientation == self.loads.orientation {
            return Ok(Cow::Borrowed(&self.statics));
        }
        Statics::new(self.robot, &self.loads.at(orientation)).map(Cow::Owned)
    }

    /// The wrench of inertia, as [force; moment / ℓ], N.
    fn inertia(&self, motion: &Motion) -> Vector6<f64> {
        let Motion { orientation, angular_velocity: turn, angular_acceleration: gain, .. } = motion;
        let center = orientation * self.robot.center_of_mass().coords;
        let [_, acceleration] = motion.of_point(&center);
        let axes = orientation.to_rotation_matrix();
        let tensor = axes * self.inertia * axes.transpose();
        let (force, length) = (acceleration * self.mass, self.loads.characteristic_length);
        let moment = (center.cross(&force) + tensor * gain + turn.cross(&(tensor * turn))) / length;
        Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
    }

    /// The wrench that the cables must exert, as [force; moment / ℓ], and the columns of the wrench matrix; `None`
    /// where a cable has no direction.
    fn needed(&self, motion: &Motion) -> Option<(Vector6<f64>, Matrix6xX<f64>)> {
        let statics = self.statics_at(&motion.orientation).ok()?;
        let columns = Matrix6xX::from_columns(&statics.columns(&motion.position)?);
        Some((statics.balance() + self.inertia(motion), columns))
    }

    /// How far the wrench may be from the true one, given how far the accelerations may be.
    fn uncertain(&self, [acceleration, turn]: [f64; 2]) -> f64 {
        let (length, arm) = (self.loads.characteristic_length, self.robot.center_of_mass().coords.norm());
        let heaviness = self.mass * (arm / length).hypot(1.0);
        heaviness * (acceleration + arm * turn) + self.inertia.norm() / length * turn
    }
}

impl<'a> Forces<'a> {
    /// The forces of a scene's robot.
    fn of(scene: &'a Scene) -> Self {
        let robot = scene.robot();
        let platform = |loads: Loads| {
            Ok(Platform {
                robot,
                statics: Statics::new(robot, &loads).map_err(|e| e.to_string())?,
                mass: loads.mass(robot).unwrap_or_default(),
                loads,
                inertia: robot.inertia().unwrap_or_default(),
            })
        };
        let platforms = Loads::cases(scene).into_iter().map(platform).collect();
        let limits = robot.cables().iter().map(|cable| cable.tension).collect();
        Forces { names: robot.cable_names(), limits, platforms }
    }

    /// Why the balance cannot be checked, if it cannot.
    fn unknown(&self) -> Option<&str> {
        self.platforms.as_ref().err().map(String::as_str)
    }

    /// The platform in each load case; none if the balance cannot be checked.
    fn cases(&self) -> &[Platform<'a>] {
        self.platforms.as_deref().unwrap_or_default()
    }

    /// Checks tensions at an instant.
    fn check(&self, state: &State, tensions: &[f64], faults: &mut Faults) {
        for ((name, limits), tension) in self.names.iter().zip(&self.limits).zip(tensions) {
            let Some([least, most]) = limits else { continue };
            let slack = RECORDED_TENSION * most;
            if !(*tension >= least - slack && *tension <= most + slack) {
                let limit = if tension < least { least } else { most };
                let culprits = [*name];
                let fault = state.fault(FaultKind::Limit(Limit::Tension), &culprits, [Some(*tension), Some(*limit)]);
                let [tension, least, most] = [*tension, *least, *most].map(number);
                faults.add(&fault, || format!("{name}: tension {tension} N, limits {least} N and {most} N"));
            }
        }
        let Some(platform) = self.cases().first() else { return };
        let Some((wrench, columns)) = platform.needed(state.motion) else { return };
        let missing = (columns * DVector::from_column_slice(tensions) - wrench).norm();
        let allowed = RECORDED_BALANCE * (1.0 + wrench.norm()) + platform.uncertain(state.uncertain);
        if !(missing <= allowed) {
            let fault = state.fault(FaultKind::Balance, &[], [Some(missing), Some(allowed)]);
            faults.add(&fault, || {
                let [missing, allowed] = [missing, allowed].map(number);
                format!(
                    "tensions miss the balance of weight, load and inertia by {missing} N, at most {allowed} N expected"
                )
            });
        }
    }

    /// Checks that balancing tensions at an instant are the chosen ones. Where accelerations are derived, or the choice has no
    /// tensions, nothing is compared.
    ///
    /// # Errors
    /// Numbers that are not finite.
    fn compare(
        &self,
        state: &State,
        tensions: &[f64],
        chosen: Distribution,
        solver: &mut TensionQp,
        faults: &mut Faults,
    ) -> Result<(), Error> {
        let known = state.uncertain.iter().all(|uncertain| *uncertain == 0.0);
        let Some(platform) = self.cases().first().filter(|_| known) else { return Ok(()) };
        let Some((wrench, columns)) = platform.needed(state.motion) else { return Ok(()) };
        let limits = platform.statics.limits();
        let Balance::Feasible(expected) = solver.distribute(chosen, &columns, &limits, &wrench)? else {
            return Ok(());
        };
        let allowed = RECORDED_CHOICE * (1.0 + platform.statics.largest_tension());
        let what = format!("tension by `{}`", chosen.name());
        for ((cable, found), expected) in self.names.iter().zip(tensions).zip(&expected) {
            let (kind, words) = (FaultKind::TensionDistribution, [what.as_str(), "N"]);
            let column = Column { kind, cable, found: *found, expected: *expected, allowed, words };
            column.check(state.step, state.time, faults);
        }
        Ok(())
    }

    /// Checks that there are tensions at an instant in each of these load cases.
    ///
    /// # Errors
    /// Numbers that are not finite.
    fn exist(
        &self,
        state: &State,
        cases: &[Platform],
        solver: &mut TensionQp,
        faults: &mut Faults,
    ) -> Result<(), Error> {
        let share =
            if state.uncertain.iter().any(|uncertain| *uncertain > 0.0) { RECORDED_RESERVE } else { RECORDED_TENSION };
        let wider = |[least, most]: [f64; 2]| [least - share * (most - least), most + share * (most - least)];
        for platform in cases {
            let limits: Vec<[f64; 2]> = platform.statics.limits().into_iter().map(wider).collect();
            let found = match platform.needed(state.motion) {
                Some((wrench, columns)) => {
                    matches!(solver.solve(&columns, &limits, &wrench, None)?, Balance::Feasible(_))
                }
                None => false,
            };
            if !found {
                let fault = state.fault(FaultKind::NoTensions, &[], [None, None]);
                let case = platform.loads.case.map_or(String::new(), |case| format!(" ({case})"));
                faults.add(&fault, || format!("no tensions within the limits balance weight, load and inertia{case}"));
            }
        }
        Ok(())
    }
}
