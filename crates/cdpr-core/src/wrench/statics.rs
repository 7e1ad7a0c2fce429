//! The tension limits of a robot's cables, and the wrench that they must balance, at one orientation.

mod hold;
mod loads;
mod outlets;

pub use hold::{FreeMotion, Hold, Holding};
pub use loads::Loads;
pub use outlets::{MORE_SPREAD, Origin, Part};

use nalgebra::Vector6;

use crate::error::Error;
use crate::geometry::{Placed, Point, Pulley, Rotation, Vector};
use crate::kinematics::meet_in_one_point;
use crate::limits::MOST_SCALE;
use crate::model::{Distribution, LoadCase, Robot, Scene, body};
use crate::tolerances::{MIN_CABLE_LENGTH, SAME_POINT};

/// A cable at a fixed orientation of the platform.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticCable {
    /// Outlet, world, m.
    pub outlet: Point,
    /// From the platform's origin to the attachment, world axes, m.
    pub arm: Vector,
    /// Minimum and maximum tension, N.
    pub tension: [f64; 2],
    /// Name of the cable.
    pub name: String,
    /// The last pulley; `None` if the outlet is a fixed point.
    pub pulley: Option<Pulley>,
    /// The true outlet is at most this far from `outlet`, m.
    pub outlet_error: f64,
}

impl StaticCable {
    /// Column of the wrench matrix, moments divided by `length`; not finite if the cable has no direction.
    #[inline]
    pub fn column(&self, position: &Point, length: f64) -> Vector6<f64> {
        let attachment = position + self.arm;
        let unit = match &self.pulley {
            Some(pulley) => {
                pulley.exit_and_pull(&self.outlet, &attachment).map_or(Vector::repeat(f64::NAN), |(_, pull)| pull)
            }
            None => {
                let line = self.outlet - attachment;
                let norm = line.norm();
                line / if norm >= MIN_CABLE_LENGTH { norm } else { f64::NAN }
            }
        };
        let moment = self.arm.cross(&unit) / length;
        Vector6::new(unit.x, unit.y, unit.z, moment.x, moment.y, moment.z)
    }
}

/// The statics of a robot: tension limits of all cables, and the wrench that they must balance.
///
/// Wrenches are measured as [force; moment / ℓ], N, with ℓ the characteristic length; forces and moments in world axes,
/// moments about the platform's origin.
///
/// # Source
/// The paper, section 3.3.
///
/// # Example
/// ```
/// use cdpr_core::{Point, testing, wrench::{Loads, Statics}};
/// let scene = testing::empty(); // a platform of 10 kg
/// let statics = Statics::new(scene.robot(), &Loads::of(&scene))?;
/// assert!((statics.balance()[2] - 98.1).abs() < 1e-12); // the cables pull up with its weight
/// # Ok::<(), cdpr_core::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Statics {
    cables: Vec<StaticCable>,
    balance: Vector6<f64>,
    length: f64,
    point_mass: bool,
    case: Option<LoadCase>,
    distribution: Distribution,
    /// Whether a cable has a pulley.
    pulleys: bool,
    /// Whether a true outlet may differ from the given one.
    errors: bool,
}

impl Statics {
    /// The statics of a robot under these loads.
    ///
    /// # Errors
    /// A robot without mass, a cable without tension limits, numbers that are not finite, a characteristic length that
    /// is not positive.
    pub fn new(robot: &Robot, loads: &Loads) -> Result<Self, Error> {
        let Loads { gravity, load, characteristic_length: length, .. } = loads;
        body::positive("characteristic_length", *length)?;
        if !(1.0 / MOST_SCALE..=MOST_SCALE).contains(length) {
            let problem =
                format!("found {length} m, expected a length from {:e} to {MOST_SCALE:e} m", 1.0 / MOST_SCALE);
            return Err(Error::invalid("characteristic_length", problem));
        }
        body::coordinates("gravity", gravity.as_ref())?;
        body::wrench("load", &(*load).into())?;
        let balance = loads.balance(robot).ok_or_else(|| {
            Error::invalid("robot.mass", "found none, expected the platform's mass in kg; wrench work needs it")
        })?;
        let cables = (robot.cables().iter().enumerate())
            .map(|(i, cable)| {
                let problem = "found none, expected [least, greatest] in N; wrench work needs it";
                let place = || Error::invalid(format!("robot.cables[{i}].tension"), problem);
                Ok(StaticCable {
                    outlet: cable.outlet,
                    arm: loads.orientation * cable.attachment.coords,
                    tension: cable.tension.ok_or_else(place)?,
                    name: cable.name.clone(),
                    pulley: cable.pulley,
                    outlet_error: cable.outlet_error,
                })
            })
            .collect::<Result<Vec<_>, Error>>()?;
        Ok(Statics {
            balance,
            length: *length,
            point_mass: meet_in_one_point(cables.iter().map(|cable| cable.arm)),
            pulleys: cables.iter().any(|cable| cable.pulley.is_some()),
            errors: cables.iter().any(|cable| cable.outlet_error > 0.0),
            cables,
            case: loads.case,
            distribution: robot.distribution(),
        })
    }

    /// The statics of a scene's robot at its orientation, in the first of its load cases.
    ///
    /// # Errors
    /// The errors of [`Statics::new`].
    pub fn of(scene: &Scene) -> Result<Self, Error> {
        Self::new(scene.robot(), &Loads::of(scene))
    }

    /// The statics of a scene's robot in each of its load cases, at an orientation.
    ///
    /// # Errors
    /// A robot without mass, a cable without tension limits, numbers that are not finite.
    pub fn cases(scene: &Scene, orientation: &Rotation) -> Result<Vec<Self>, Error> {
        Loads::cases(scene).iter().map(|loads| Self::new(scene.robot(), &loads.at(orientation))).collect()
    }

    /// The statics of a scene that has one load case, for functions that support only one.
    ///
    /// # Errors
    /// Several load cases; a robot without mass, a cable without tension limits, numbers that are not finite.
    pub fn only(scene: &Scene, what: &str) -> Result<Self, Error> {
        let cases = Loads::cases(scene).len();
        if cases > 1 {
            let problem = format!("found {cases} load cases, expected one: {what} is for one; give its `load`");
            return Err(Error::invalid("wrench", problem));
        }
        Self::of(scene)
    }

    /// The statics with each cable's range of tensions narrowed at both ends: by a share of the range or, if that is
    /// less, of a hundred times the tensions that occur at rest.
    pub fn with_reserve(mut self, share: f64) -> Self {
        let least = self.cables.iter().map(|cable| cable.tension[0]).fold(0.0, f64::max);
        let at_rest = self.balance.norm() + least;
        let occurring = if at_rest > 0.0 { 100.0 * at_rest } else { f64::INFINITY };
        for StaticCable { tension: [least, most], .. } in &mut self.cables {
            let reserve = share * (*most - *least).min(occurring);
            (*least, *most) = (*least + reserve, *most - reserve);
        }
        self
    }

    /// These cables on the platform after a turn, with the wrench to balance there, as [force; moment / ℓ], N.
    pub fn turned(&self, turn: &Placed, balance: Vector6<f64>) -> Self {
        let cable = |cable: &StaticCable| StaticCable { arm: turn.turned(&cable.arm), ..cable.clone() };
        Statics { cables: self.cables.iter().map(cable).collect(), balance, ..self.clone() }
    }

    /// The load case of the scene that these statics belong to, if it has several.
    pub fn load_case(&self) -> Option<LoadCase> {
        self.case
    }

    /// These statics with another choice of tensions.
    pub fn with_tensions(&self, chosen: Distribution) -> Self {
        Statics { distribution: chosen, ..self.clone() }
    }

    /// Which of all tensions that balance the loads the robot keeps.
    pub fn distribution(&self) -> Distribution {
        self.distribution
    }

    /// Cables in the order of the robot.
    pub fn cables(&self) -> &[StaticCable] {
        &self.cables
    }

    /// The wrench that the cables must exert for balance, −w_ext, as [force; moment / ℓ], N.
    pub fn balance(&self) -> &Vector6<f64> {
        &self.balance
    }

    /// The characteristic length ℓ, m.
    pub fn characteristic_length(&self) -> f64 {
        self.length
    }

    /// Whether all cables meet in one point of the platform: they can exert forces, but no moment about it.
    pub fn point_mass(&self) -> bool {
        self.point_mass
    }

    /// The moment of weight and load about the point where all cables of a point mass meet, N·m, if it exceeds
    /// rounding errors: the cables cannot balance it.
    pub fn moment_on_point_mass(&self) -> Option<f64> {
        let arm = self.cables.first().filter(|_| self.point_mass)?.arm;
        let force = Vector::new(self.balance[0], self.balance[1], self.balance[2]);
        let moment = Vector::new(self.balance[3], self.balance[4], self.balance[5]) * self.length;
        let left = (moment - arm.cross(&force)).norm();
        (left > SAME_POINT * (force.norm() + moment.norm())).then_some(left)
    }

    /// The largest tension of all cables, N: the scale of wrenches.
    pub fn largest_tension(&self) -> f64 {
        self.cables.iter().map(|cable| cable.tension[1]).fold(0.0, f64::max)
    }

    /// How the cables constrain the platform at a position regardless of their limits; `None` if a cable has no
    /// direction.
    pub fn hold(&self, position: &Point) -> Option<Hold> {
        let columns: Vec<_> = self.cables.iter().map(|cable| cable.column(position, 1.0)).collect();
        columns.iter().all(|column| column.x.is_finite()).then(|| Hold::of(&columns, self.point_mass))
    }

    /// Columns of the wrench matrix at a position, moments divided by ℓ; `None` if a cable has no direction.
    pub fn columns(&self, position: &Point) -> Option<Vec<Vector6<f64>>> {
        let columns: Vec<_> = self.cables.iter().map(|cable| cable.column(position, self.length)).collect();
        columns.iter().all(|column| column.x.is_finite()).then_some(columns)
    }
}
