//! The tensions of a moving platform, computed without the code that plans trajectories.

use nalgebra::{DVector, Matrix6xX, Vector6};

use super::faults::{FaultKind, Faults, Instant, number};
use crate::error::Error;
use crate::geometry::{Point, Vector};
use crate::model::Scene;
use crate::numerics::{RECORDED_BALANCE, RECORDED_RESERVE, RECORDED_TENSION};
use crate::wrench::{Balance, Statics, TensionQp};

/// The platform at an instant.
#[derive(Clone, Copy)]
pub struct State<'a> {
    /// Index of the sample.
    pub step: usize,
    /// s.
    pub time: f64,
    /// m.
    pub position: &'a Point,
    /// m/s².
    pub acceleration: &'a Vector,
    /// How far the acceleration may be from the true one, m/s².
    pub uncertain: f64,
}

impl<'a> State<'a> {
    fn fault(&self, kind: FaultKind, culprits: &'a [&'a str], [found, limit]: [Option<f64>; 2]) -> Instant<'a> {
        let excess = found.zip(limit).map_or(0.0, |(found, limit)| (found - limit).abs());
        Instant { step: self.step, time: self.time, kind, culprits, found, limit, excess }
    }
}

/// What the cables of a robot must balance.
pub struct Forces<'a> {
    names: Vec<&'a str>,
    /// Minimum and maximum tension of each cable, N, where they are known.
    limits: Vec<Option<[f64; 2]>>,
    /// With mass, kg, and centre of mass, world axes, divided by the characteristic length; or why they are unknown.
    statics: Result<(Statics, f64, Vector), String>,
}

impl<'a> Forces<'a> {
    /// Those of a scene.
    pub fn of(scene: &'a Scene) -> Self {
        let robot = scene.robot();
        let known = Statics::of(scene).map_err(|e| e.to_string()).map(|statics| {
            let center = scene.orientation() * robot.center_of_mass().coords / statics.characteristic_length();
            (statics, robot.mass().unwrap_or_default(), center)
        });
        let limits = robot.cables().iter().map(|cable| cable.tension).collect();
        Forces { names: robot.cable_names(), limits, statics: known }
    }

    /// Why the balance cannot be checked, if it cannot.
    pub fn unknown(&self) -> Option<&str> {
        self.statics.as_ref().err().map(String::as_str)
    }

    /// The wrench that the cables must exert, as [force; moment / ℓ], and its columns; `None` if it is unknown.
    fn needed(&self, position: &Point, acceleration: &Vector) -> Option<(Vector6<f64>, Matrix6xX<f64>)> {
        let (statics, mass, center) = self.statics.as_ref().ok()?;
        let force = acceleration * *mass;
        let moment = center.cross(&force);
        let inertia = Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
        Some((statics.balance() + inertia, Matrix6xX::from_columns(&statics.columns(position)?)))
    }

    /// Checks tensions at an instant.
    pub fn check(&self, state: &State, tensions: &[f64], faults: &mut Faults) {
        for ((name, limits), tension) in self.names.iter().zip(&self.limits).zip(tensions) {
            let Some([least, most]) = limits else { continue };
            let slack = RECORDED_TENSION * most;
            if !(*tension >= least - slack && *tension <= most + slack) {
                let limit = if tension < least { least } else { most };
                let culprits = [*name];
                let fault = state.fault(FaultKind::Tension, &culprits, [Some(*tension), Some(*limit)]);
                let [tension, least, most] = [*tension, *least, *most].map(number);
                faults.add(&fault, || format!("{name}: tension {tension} N, limits {least} N and {most} N"));
            }
        }
        let Some((wrench, columns)) = self.needed(state.position, state.acceleration) else { return };
        let missing = (columns * DVector::from_column_slice(tensions) - wrench).norm();
        let mass = self.statics.as_ref().map_or(0.0, |(_, mass, center)| mass * center.norm().hypot(1.0));
        let allowed = RECORDED_BALANCE * (1.0 + wrench.norm()) + mass * state.uncertain;
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

    /// Checks that there are tensions at an instant.
    ///
    /// # Errors
    /// Numbers that are not finite.
    pub fn exist(&self, state: &State, solver: &mut TensionQp, faults: &mut Faults) -> Result<(), Error> {
        let Ok((statics, ..)) = &self.statics else { return Ok(()) };
        let share = if state.uncertain > 0.0 { RECORDED_RESERVE } else { RECORDED_TENSION };
        let wider = |[least, most]: [f64; 2]| [least - share * (most - least), most + share * (most - least)];
        let limits: Vec<[f64; 2]> = statics.limits().into_iter().map(wider).collect();
        let found = match self.needed(state.position, state.acceleration) {
            Some((wrench, columns)) => matches!(solver.solve(&columns, &limits, &wrench, None)?, Balance::Feasible(_)),
            None => false,
        };
        if !found {
            let fault = state.fault(FaultKind::NoTensions, &[], [None, None]);
            faults.add(&fault, || "no tensions within the limits balance weight, load and inertia".to_string());
        }
        Ok(())
    }
}
