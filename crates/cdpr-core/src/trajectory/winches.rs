//! The cables of a robot during a motion: lengths, speeds, accelerations and tensions.

use super::jet::Jet;
use super::motion::Motion;
pub use super::moving_mass::Span;
use super::moving_mass::{CaseTensions, MovingMass};
use crate::error::Error;
use crate::geometry::{Leeway, Point, Pose, Pulley, Rotation, Vector};
use crate::model::spec::MotionSpec;
use crate::model::{Distribution, Scene};
use crate::wrench::TensionQp;
pub use crate::wrench::TensionShare;

/// A cable between its outlet, or the last pulley behind it, and the platform.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Outlet of the cable, world, m.
    pub outlet: Point,
    /// Attachment of the cable, platform frame, m.
    pub attachment: Point,
    /// The last pulley; `None` if the outlet is a fixed point.
    pub pulley: Option<Pulley>,
}

impl Line {
    /// From the platform's origin to the attachment at an orientation, world axes, m.
    pub fn arm(&self, orientation: &Rotation) -> Vector {
        orientation * self.attachment.coords
    }

    /// Length at a pose, round the pulley if there is one, m; NaN if the cable cannot leave it.
    pub fn length(&self, position: &Point, orientation: &Rotation) -> f64 {
        let attachment = position + self.arm(orientation);
        match &self.pulley {
            None => (attachment - self.outlet).norm(),
            Some(pulley) => pulley.departure(&self.outlet, &attachment).map_or(f64::NAN, |found| found.length),
        }
    }

    /// How far the attachment, given the arm, is from where the cable loses its direction.
    pub fn leeway(&self, position: &Point, arm: &Vector) -> Leeway {
        Leeway::of(self.pulley.as_ref(), &self.outlet, &(position + arm))
    }

    /// Coefficients of u and x in the acceleration of the length while its attachment has the velocity `first` √x and the
    /// acceleration `first` u + `second` x; NaN if the cable has no direction.
    pub fn rates(&self, attachment: &Point, [first, second]: [&Vector; 2]) -> [f64; 2] {
        if let Some(pulley) = &self.pulley {
            let Some(found) = pulley.departure(&self.outlet, attachment) else { return [f64::NAN; 2] };
            let bend = pulley.bend(&self.outlet, attachment, first);
            return [-found.pull.dot(first), bend - found.pull.dot(second)];
        }
        let line = attachment - self.outlet;
        let length = line.norm();
        let rate = line.dot(first) / length;
        [rate, (first.norm_squared() + line.dot(second) - rate * rate) / length]
    }

    /// Length, speed and acceleration during a motion, given [`Line::arm`] at the motion's orientation.
    pub fn winding(&self, motion: &Motion, arm: &Vector) -> Winding {
        let [velocity, acceleration] = motion.of_point(arm);
        if let Some(pulley) = &self.pulley {
            let attachment = motion.position + arm;
            let found = pulley.departure(&self.outlet, &attachment);
            let (length, pull) = found.map_or((f64::NAN, Vector::repeat(f64::NAN)), |found| (found.length, found.pull));
            let turning = pulley.bend(&self.outlet, &attachment, &velocity);
            return Winding { length, speed: -pull.dot(&velocity), acceleration: turning - pull.dot(&acceleration) };
        }
        let line = motion.position + arm - self.outlet;
        let length = line.norm();
        let speed = line.dot(&velocity) / length;
        let turning = (velocity.norm_squared() - speed * speed).max(0.0) / length;
        Winding { length, speed, acceleration: line.dot(&acceleration) / length + turning }
    }
}

/// Length, speed and acceleration of a cable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Winding {
    /// Length of the cable, m.
    pub length: f64,
    /// Rate of the length, m/s; positive while the cable is let out.
    pub speed: f64,
    /// Rate of the speed, m/s².
    pub acceleration: f64,
}

/// The cables of a robot, and the wrenches that their tensions must balance.
#[derive(Debug, Clone)]
pub struct Winches {
    cables: Vec<Line>,
    /// The platform in each load case; none if tensions are not limited.
    cases: Vec<MovingMass>,
    note: Option<String>,
}

/// Tensions at recent instants in each load case.
#[derive(Default)]
pub struct RecentTensions(Vec<CaseTensions>);

impl Winches {
    /// The cables of a scene's robot for motions along a path. Tensions are limited if the mass of the platform and all tension
    /// limits are known and the cables leave no motion free at the start, since they could not balance inertia along a free motion.
    /// Nor are they limited if the platform turns on cables that meet in one point of it.
    ///
    /// # Errors
    /// An empty path; tension limits of some cables but not of all; a wrench margin without tensions; a moment that a point mass
    /// cannot balance.
    pub fn of(scene: &Scene, limits: &MotionSpec, path: &[Pose]) -> Result<Self, Error> {
        let start = path.first().ok_or_else(|| Error::invalid("waypoints", "found none, expected at least two"))?;
        let cases = MovingMass::cases(scene, limits, start, !scene.keeps_orientation(path))?;
        let line = |cable: &crate::model::Cable| Line {
            outlet: cable.outlet,
            attachment: cable.attachment,
            pulley: cable.pulley,
        };
        let cables = scene.robot().cables().iter().map(line).collect();
        let (cases, note) = match cases {
            Ok(cases) => (cases, None),
            Err(why) => (Vec::new(), Some(format!("tensions are not limited: {why}"))),
        };
        if let Some(note) = note.as_ref().filter(|_| limits.wrench_margin() > 0.0) {
            return Err(Error::invalid("wrench_margin", format!("found a margin, but {note}")));
        }
        Ok(Winches { cables, cases, note })
    }

    /// These cables with another share of their range of tensions left unused at both ends.
    pub fn with_reserve(&self, share: f64, limits: &MotionSpec) -> Self {
        let cases = self.cases.iter().map(|mass| mass.with_reserve(share, limits)).collect();
        Winches { cases, ..self.clone() }
    }

    /// Why tensions are not limited, if they are not.
    pub fn note(&self) -> Option<&str> {
        self.note.as_deref()
    }

    /// The assumption about the platform's inertia, if the tensions depend on it.
    pub fn assumption(&self) -> Option<&'static str> {
        self.cases.first().and_then(MovingMass::assumption)
    }

    /// The cables, in the order of the robot.
    pub fn cables(&self) -> &[Line] {
        &self.cables
    }

    /// Minimum and maximum tension of each cable, N; `None` if tensions are not limited.
    pub fn tension_limits(&self) -> Option<&[[f64; 2]]> {
        self.cases.first().map(MovingMass::limits)
    }

    /// Length, speed and acceleration of each cable during a motion.
    pub fn windings<'a>(&'a self, motion: &'a Motion) -> impl Iterator<Item = Winding> + 'a {
        self.cables.iter().map(move |cable| cable.winding(motion, &cable.arm(&motion.orientation)))
    }

    /// Refuses a pose at which a cable cannot leave its pulley.
    pub fn all_leave_pulleys(&self, position: &Point, orientation: &Rotation) -> Result<(), Error> {
        let stuck = |cable: &Line| cable.pulley.is_some() && cable.length(position, orientation).is_nan();
        let Some(k) = self.cables.iter().position(stuck) else { return Ok(()) };
        let at = [position.x, position.y, position.z];
        let problem = format!(
            "found {at:?} m, where cable {k} cannot leave its pulley: its attachment is inside the wheel or below it"
        );
        Err(Error::invalid("waypoints", problem))
    }

    /// Calls `visit` with the index of a place of a curve and each tension limit there: coefficients of s̈ and ṡ², and
    /// the limit. Each place has the largest |s̈| and ṡ² that other limits allow, which may be infinite; limits that
    /// never take effect within these may be omitted. An error is the index of the first place at which the cables
    /// cannot hold the platform at rest.
    pub fn for_each_tension_limit(
        &self,
        places: &[(Jet, [f64; 2])],
        mut visit: impl FnMut(usize, [f64; 3]),
    ) -> Result<(), usize> {
        let lacking = self.cases.iter().filter_map(|mass| mass.for_each_limit(places, &mut visit).err());
        lacking.min().map_or(Ok(()), Err)
    }

    /// For each motion, the largest share of the slack at rest that inertia uses, over all facets of the available
    /// wrenches (above 1 if it needs more than the cables can exert), and the least slack that it leaves, N. An error
    /// is the index of the first motion at whose pose the cables cannot hold the platform at rest.
    pub fn tension_shares(&self, motions: &[Motion]) -> Result<Vec<TensionShare>, usize> {
        let mut shares = vec![TensionShare::NOTHING; motions.len()];
        let mut first_lacking = None;
        for mass in &self.cases {
            match mass.shares(motions) {
                Ok(found) => shares.iter_mut().zip(found).for_each(|(share, found)| *share = share.worse(found)),
                Err(k) => first_lacking = Some(first_lacking.map_or(k, |first: usize| first.min(k))),
            }
        }
        first_lacking.map_or(Ok(shares), Err)
    }

    /// How much the slack of the available wrenches can drop below its values at both ends of a motion, in any direction, N.
    pub fn sag(&self, span: &Span) -> f64 {
        self.cases.iter().map(|mass| mass.sag(span)).reduce(larger).unwrap_or(0.0)
    }

    /// A lower bound of how much the slack during a motion exceeds that of [`Winches::tension_shares`], which leaves a
    /// reserve of tension, N.
    pub fn spare(&self, span: &Span) -> f64 {
        -self.cases.iter().map(|mass| -mass.spare(span)).reduce(larger).unwrap_or(0.0)
    }

    /// The tensions that the robot keeps during a motion in the first load case, N; `None` if tensions are not limited.
    ///
    /// # Errors
    /// Tensions in closed form that exceed a limit. No tensions within the limits exist, although the motion was proved.
    pub fn tensions(&self, solver: &mut TensionQp, motion: &Motion) -> Result<Option<Vec<f64>>, Error> {
        let Some(mass) = self.cases.first() else { return Ok(None) };
        self.tensions_by(mass.distribution(), solver, motion)
    }

    /// The chosen ones of all tensions during a motion in the first load case, N; `None` if tensions are not limited.
    ///
    /// # Errors
    /// The errors of [`Winches::tensions`].
    pub fn tensions_by(
        &self,
        chosen: Distribution,
        solver: &mut TensionQp,
        motion: &Motion,
    ) -> Result<Option<Vec<f64>>, Error> {
        let Some(mass) = self.cases.first() else { return Ok(None) };
        let found = mass.solve(solver, motion, chosen)?;
        let at = [motion.position.x, motion.position.y, motion.position.z];
        if found.is_none() && chosen == Distribution::ClosedForm {
            let problem = format!(
                "found closed-form, which exceeds a tension limit at {at:?} m; the others keep the limits on this motion"
            );
            return Err(Error::invalid("tension_distribution", problem));
        }
        let problem = || Error::internal(format!("no tensions at {at:?} on a trajectory that was proved"));
        found.map(Some).ok_or_else(problem)
    }

    /// Whether tensions within the limits exist everywhere on a motion between two instants: if the number of parts of
    /// [`MovingMass::hold_between`] is at most 1.
    ///
    /// # Errors
    /// A solver that reached no answer.
    pub fn hold_between(&self, solver: &mut RecentTensions, span: &Span) -> Result<f64, Error> {
        solver.0.resize_with(self.cases.len(), CaseTensions::default);
        let parts = self.cases.iter().zip(&mut solver.0).map(|(mass, solver)| mass.hold_between(solver, span));
        parts.reduce(|a, b| Ok(larger(a?, b?))).unwrap_or(Ok(0.0))
    }
}

/// The larger of two numbers; NaN if one of them is NaN, so that nothing counts as proved.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::larger;

    #[test]
    fn nan_in_one_load_case_proves_nothing() {
        assert_eq!([larger(1.0, 2.0), larger(2.0, 1.0), larger(-f64::INFINITY, 1.0)], [2.0, 2.0, 1.0]);
        assert!([larger(f64::NAN, 1.0), larger(1.0, f64::NAN)].iter().all(|x| x.is_nan()));
    }
}
