//! The cables of a robot during a motion at fixed orientation: lengths, speeds, accelerations and tensions.

use nalgebra::{Matrix6, Matrix6xX, Vector6};

use super::curve::Jet;
use super::limits::Limits;
use crate::error::Error;
use crate::geometry::{Point, Vector};
use crate::model::Scene;
use crate::numerics::{RANK_RELATIVE, TENSION_RESERVE, TURNING};
use crate::wrench::{Balance, Demand, DemandFacets, FacetPair, Holding, StaticCable, Statics, TensionQp};

/// A cable between a fixed outlet and the platform.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Outlet, world, m.
    pub outlet: Point,
    /// From the platform's origin to the attachment, world axes, m.
    pub arm: Vector,
}

/// Length, speed and acceleration of a cable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Winding {
    /// Length, m.
    pub length: f64,
    /// Rate of the length, m/s; positive while the cable is let out.
    pub speed: f64,
    /// Rate of the speed, m/s².
    pub acceleration: f64,
}

/// What an acceleration needs of the available wrenches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TensionShare {
    /// The largest share of the slack at rest.
    pub share: f64,
    /// The least slack that is left, N.
    pub slack: f64,
}

/// The cables of a robot, and what their tensions must balance.
#[derive(Debug, Clone)]
pub struct Winches {
    cables: Vec<Line>,
    tensions: Option<Inertia>,
    note: Option<String>,
}

/// The tensions of a moving platform.
#[derive(Debug, Clone)]
struct Inertia {
    statics: Statics,
    mass: f64,
    /// Centre of mass from the platform's origin, world axes, divided by the characteristic length.
    center: Vector,
    /// Tension limits, N.
    limits: Vec<[f64; 2]>,
    /// The facets of the wrenches that are available with a reserve of tension.
    facets: DemandFacets,
}

impl Winches {
    /// The cables of a scene's robot at its orientation. Tensions are limited if its mass and all tension limits are known
    /// and the cables leave no motion free at the start: they could not balance inertia along it.
    ///
    /// # Errors
    /// Tension limits of some cables but not of all; a wrench margin without tensions; a moment that a point mass cannot
    /// balance.
    pub fn of(scene: &Scene, limits: &Limits, start: &Point) -> Result<Self, Error> {
        let robot = scene.robot();
        let turn = scene.orientation();
        let line = |cable: &crate::model::Cable| Line { outlet: cable.outlet, arm: turn * cable.attachment.coords };
        let cables = robot.cables().iter().map(line).collect();
        let (tensions, note) = match Inertia::of(scene, limits, start)? {
            Ok(inertia) => (Some(inertia), None),
            Err(why) => (None, Some(format!("tensions are not limited: {why}"))),
        };
        if let Some(note) = note.as_ref().filter(|_| limits.wrench_margin > 0.0) {
            return Err(Error::invalid("wrench_margin", format!("found a margin, but {note}")));
        }
        Ok(Winches { cables, tensions, note })
    }

    /// Why tensions are not limited, if they are not.
    pub fn note(&self) -> Option<&str> {
        self.note.as_deref()
    }

    /// The cables.
    pub fn cables(&self) -> &[Line] {
        &self.cables
    }

    /// Minimum and maximum tension of each cable, N; `None` if tensions are not limited.
    pub fn tension_limits(&self) -> Option<&[[f64; 2]]> {
        self.tensions.as_ref().map(|inertia| inertia.limits.as_slice())
    }

    /// Length, speed and acceleration of each cable at a position, with a velocity and acceleration of the platform.
    pub fn windings<'a>(
        &'a self,
        position: &'a Point,
        velocity: &'a Vector,
        acceleration: &'a Vector,
    ) -> impl Iterator<Item = Winding> + 'a {
        self.cables.iter().map(move |cable| {
            let line = position + cable.arm - cable.outlet;
            let length = line.norm();
            let speed = line.dot(velocity) / length;
            let turning = (velocity.norm_squared() - speed * speed).max(0.0) / length;
            Winding { length, speed, acceleration: line.dot(acceleration) / length + turning }
        })
    }

    /// Calls `visit` with the index of a place of a curve and each of the limits of tensions there: coefficients of s̈ and ṡ²,
    /// and the limit. An error is the index of the first place at which the cables cannot hold the platform at rest.
    pub fn for_each_tension_limit(&self, jets: &[Jet], mut visit: impl FnMut(usize, [f64; 3])) -> Result<(), usize> {
        let Some(inertia) = &self.tensions else { return Ok(()) };
        let demand = |jet: &Jet| (jet.position, [&jet.first, &jet.second].map(|v| inertia.wrench(v)));
        let demands: Vec<Demand> = jets.iter().map(demand).collect();
        let both = |k: usize, FacetPair { heights: [a, b], slack, .. }: &FacetPair| {
            visit(k, [*a, *b, slack[0]]);
            visit(k, [-a, -b, slack[1]]);
        };
        inertia.facets.for_each(&demands, both).map_or(Ok(()), Err)
    }

    /// For each position and acceleration the largest share of the slack at rest that the acceleration uses, over all facets
    /// of the available wrenches (above 1 if it needs more than the cables can exert), and the least slack that it leaves,
    /// N. An error is the index of the first position at which the cables cannot hold the platform at rest.
    pub fn tension_shares(&self, motions: &[(Point, Vector)]) -> Result<Vec<TensionShare>, usize> {
        let mut shares = vec![TensionShare { share: 0.0, slack: f64::INFINITY }; motions.len()];
        let Some(inertia) = &self.tensions else { return Ok(shares) };
        let nothing = Vector6::zeros();
        let demand = |(position, acceleration): &(Point, Vector)| (*position, [inertia.wrench(acceleration), nothing]);
        let demands: Vec<Demand> = motions.iter().map(demand).collect();
        let lacking = inertia.facets.for_each(&demands, |k, facets| {
            for (needed, slack) in [facets.heights[0], -facets.heights[0]].into_iter().zip(facets.slack) {
                let found = &mut shares[k];
                if needed > 0.0 {
                    found.share = found.share.max(needed / slack);
                }
                found.slack = found.slack.min((slack - needed) / facets.norm);
            }
        });
        lacking.map_or(Ok(shares), Err)
    }

    /// How much the slack of the available wrenches can drop below its values at both ends of a motion, in any direction, N;
    /// compare [`crate::wrench::Measure::sag`]. `bounds` are the largest norms of the first, second and fourth time derivative
    /// of the position, `time` is in s.
    pub fn sag(&self, ends: [&Point; 2], [speed, acceleration, fourth]: [f64; 3], time: f64) -> f64 {
        let Some(inertia) = &self.tensions else { return 0.0 };
        let cable = |(line, lever): (&StaticCable, f64)| {
            let [before, after] = ends.map(|p| (line.outlet - (p + line.arm)).norm());
            let shortest = 0.5 * (before + after - speed * time);
            if !(shortest > 0.0) {
                return f64::INFINITY;
            }
            let turn = (speed / shortest * time).min(2.0);
            let bend = time * time * (acceleration / shortest + TURNING[1] * (speed / shortest).powi(2));
            let [least, largest] = line.tension;
            lever * (0.25 * (largest - least) * turn + 0.125 * largest * bend)
        };
        let cables: f64 = inertia.statics.cables().iter().zip(inertia.levers()).map(cable).sum();
        cables + time * time / 8.0 * inertia.heaviness() * fourth
    }

    /// The tensions nearest to the middle of their limits at a position and acceleration, N; `None` if tensions are not
    /// limited.
    ///
    /// # Errors
    /// No tensions within the limits exist, although the motion was proved.
    pub fn tensions(
        &self,
        solver: &mut TensionQp,
        position: &Point,
        acceleration: &Vector,
    ) -> Result<Option<Vec<f64>>, Error> {
        let Some(inertia) = &self.tensions else { return Ok(None) };
        let found = inertia.solve(solver, position, acceleration, &inertia.limits)?;
        let at = [position.x, position.y, position.z];
        let problem = || Error::internal(format!("no tensions at {at:?} on a trajectory that was proved"));
        found.map(Some).ok_or_else(problem)
    }

    /// Whether tensions within the limits exist everywhere on a motion between two instants. `ends` are positions and
    /// accelerations, and `bounds` the largest norms of the first, second and fourth time derivative of the position in
    /// between; `time` is the time between them, s.
    ///
    /// The forces per length τ of the cables at both ends are interpolated linearly. What then misses in balance is zero at
    /// both ends, and its second derivative is bounded; the shortest correction is at most that over the smallest singular
    /// value of the matrix of cable vectors.
    ///
    /// # Errors
    /// A solver that reached no answer.
    pub fn hold_between(
        &self,
        solver: &mut TensionQp,
        ends: [(&Point, &Vector); 2],
        [speed, acceleration, fourth]: [f64; 3],
        time: f64,
    ) -> Result<bool, Error> {
        let Some(inertia) = &self.tensions else { return Ok(true) };
        let reserved = inertia.facets.statics().limits();
        let mut densities: [Vec<f64>; 2] = Default::default();
        let lengths = ends.map(|(position, _)| inertia.statics.lengths(position));
        for (k, (position, acceleration)) in ends.into_iter().enumerate() {
            let Some(tensions) = inertia.solve(solver, position, acceleration, &reserved)? else {
                return Ok(false);
            };
            densities[k] = tensions.iter().zip(&lengths[k]).map(|(t, l)| t / l).collect();
        }
        let eighth = time * time / 8.0;
        let levers: Vec<f64> = inertia.levers().collect();
        let share = |k: usize| {
            let change = (densities[1][k] - densities[0][k]).abs() / time;
            levers[k] * (densities[0][k].max(densities[1][k]) * acceleration + 2.0 * change * speed)
        };
        let missing: f64 = inertia.heaviness() * fourth + (0..levers.len()).map(share).sum::<f64>();
        let moved = levers.iter().map(|lever| lever * lever).sum::<f64>().sqrt() * speed * time;
        let correction = eighth * missing / (inertia.least_singular_value(ends[0].0) - moved);
        let holds = |k: usize| {
            let (l, tau) = (lengths[0][k].max(lengths[1][k]), densities[0][k].max(densities[1][k]));
            let shortest = lengths[0][k].min(lengths[1][k]) - speed * time;
            let change = (densities[1][k] - densities[0][k]).abs() / time;
            let bend = (acceleration + speed * speed / shortest) * tau + 2.0 * speed * change;
            let reserve = reserved[k][0] - inertia.limits[k][0];
            shortest > 0.0 && (l + speed * time) * correction + eighth * bend <= reserve
        };
        Ok(correction >= 0.0 && (0..levers.len()).all(holds))
    }
}

impl Inertia {
    /// The inertia of a scene's platform, or why tensions cannot be limited.
    fn of(scene: &Scene, limits: &Limits, start: &Point) -> Result<Result<Self, String>, Error> {
        let robot = scene.robot();
        if robot.mass().is_none() {
            return Ok(Err("the mass of the platform is unknown".to_string()));
        }
        if robot.cables().iter().all(|cable| cable.tension.is_none()) {
            return Ok(Err("the cables have no tension limits".to_string()));
        }
        let statics = Statics::of(scene)?;
        if let Some(moment) = statics.moment_on_point_mass() {
            let problem =
                format!("found a moment of {moment:.3} N·m about the point where all cables meet, expected none");
            return Err(Error::invalid("robot.center_of_mass", problem));
        }
        if let Some(hold) = statics.hold(start).filter(|hold| hold.holding == Holding::Underconstrained) {
            return Ok(Err(hold.sentence()));
        }
        let center = scene.orientation() * robot.center_of_mass().coords / statics.characteristic_length();
        Ok(Ok(Inertia {
            mass: robot.mass().unwrap_or_default(),
            center,
            limits: statics.limits(),
            facets: DemandFacets::new(statics.clone().with_reserve(TENSION_RESERVE), limits.wrench_margin),
            statics,
        }))
    }

    /// The wrench that accelerates the platform, as [force; moment / ℓ], N.
    fn wrench(&self, acceleration: &Vector) -> Vector6<f64> {
        let force = acceleration * self.mass;
        let moment = self.center.cross(&force);
        Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
    }

    /// The largest wrench for an acceleration of 1 m/s².
    fn heaviness(&self) -> f64 {
        self.mass * self.center.norm().hypot(1.0)
    }

    /// For each cable the norm of its wrench for a unit of its vector.
    fn levers(&self) -> impl Iterator<Item = f64> + '_ {
        let length = self.statics.characteristic_length();
        self.statics.cables().iter().map(move |cable| (cable.arm / length).norm().hypot(1.0))
    }

    /// The tensions within these limits that balance loads and inertia and are nearest to the middle; `None` if there are
    /// none.
    fn solve(
        &self,
        solver: &mut TensionQp,
        position: &Point,
        acceleration: &Vector,
        limits: &[[f64; 2]],
    ) -> Result<Option<Vec<f64>>, Error> {
        let Some(columns) = self.statics.columns(position) else { return Ok(None) };
        let wrench = self.statics.balance() + self.wrench(acceleration);
        match solver.solve(&Matrix6xX::from_columns(&columns), limits, &wrench, None)? {
            Balance::Feasible(tensions) => Ok(Some(tensions.as_slice().to_vec())),
            Balance::Infeasible => Ok(None),
            Balance::Undecided => Err(Error::internal(format!("the solver could not decide at {position:?}"))),
        }
    }

    /// The smallest singular value, other than zero, of the matrix of cable vectors and their moments, m.
    fn least_singular_value(&self, position: &Point) -> f64 {
        let length = self.statics.characteristic_length();
        let mut gram = Matrix6::zeros();
        for StaticCable { outlet, arm, .. } in self.statics.cables() {
            let line = outlet - (position + arm);
            let moment = arm.cross(&line) / length;
            let column = Vector6::new(line.x, line.y, line.z, moment.x, moment.y, moment.z);
            gram += column * column.transpose();
        }
        let squares = gram.symmetric_eigenvalues();
        let largest = squares.max();
        let counts = |square: &&f64| **square > (RANK_RELATIVE * RANK_RELATIVE).max(1e-14) * largest;
        squares.iter().filter(counts).fold(f64::INFINITY, |least, square| least.min(*square)).sqrt()
    }
}
