//! All inputs of a wrench map's margins, so that a map is used only for the robot and loads it was computed for.

use nalgebra::Vector6;
use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::fingerprint::fingerprint_of;
use crate::wrench::{Required, Statics};

/// All inputs of a margin besides the position: geometry, tension limits, loads, orientation, required wrenches.
///
/// Mass, centre of mass, gravity and further load act through one wrench, `balance`; orientation and attachments act
/// through the arms. So two problems with the same identity have the same margins, bit for bit. Names do not count.
///
/// # Example
/// ```
/// use cdpr_core::{Required, testing, wrench::{Loads, MapIdentity, Statics}};
/// let robot = |mass| {
///     let spec = cdpr_core::model::RobotSpec { mass: Some(mass), ..testing::paper_robot() };
///     Statics::new(&cdpr_core::Robot::try_from(spec)?, &Loads::default())
/// };
/// let [light, heavy] = [10.0, 12.0].map(|mass| robot(mass).unwrap());
/// let required = Required::balls(50.0, 5.0)?;
/// let [light, heavy] = [light, heavy].map(|statics| MapIdentity::of(&statics, &required));
/// assert_ne!(light.fingerprint(), heavy.fingerprint());
/// assert!(light.first_difference(&heavy).unwrap().starts_with("wrench to balance (weight and load)"));
/// # Ok::<(), cdpr_core::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MapIdentity {
    /// Cables in the order of the robot.
    pub cables: Vec<CableIdentity>,
    /// The wrench that the cables must exert for balance, [force, N; moment / ℓ, N], world axes.
    pub balance: [f64; 6],
    /// Characteristic length ℓ, m.
    pub characteristic_length: f64,
    /// The required wrenches around the balancing wrench.
    pub required: RequiredIdentity,
}

/// A cable at a fixed orientation of the platform.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CableIdentity {
    /// Outlet, world, m.
    pub outlet: [f64; 3],
    /// From the platform's origin to the attachment, world axes, m.
    pub arm: [f64; 3],
    /// Minimum and maximum tension, N.
    pub tension: [f64; 2],
    /// The last pulley: its radius, m, and axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pulley: Option<PulleyIdentity>,
    /// The true outlet is at most this far away, m; `None` if it is exact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub outlet_error: Option<f64>,
}

/// The last pulley of a cable.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PulleyIdentity {
    /// Radius, m.
    pub radius: f64,
    /// Unit vector about which it swivels, world axes.
    pub axis: [f64; 3],
}

/// [`Required`] as plain data.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum RequiredIdentity {
    /// Balls of forces and moments.
    Balls {
        /// Radius of the force ball, N.
        force: f64,
        /// Radius of the moment ball, N·m.
        moment: f64,
    },
    /// Corners of a polytope, each [force; moment] in N and N·m.
    Polytope(Vec<[f64; 6]>),
}

impl MapIdentity {
    /// The identity of the margins of these statics for this requirement.
    pub fn of(statics: &Statics, required: &Required) -> Self {
        let cable = |cable: &crate::wrench::StaticCable| CableIdentity {
            outlet: unsigned_zeros(cable.outlet.into()),
            arm: unsigned_zeros(cable.arm.into()),
            tension: unsigned_zeros(cable.tension),
            pulley: (cable.pulley.as_ref())
                .map(|p| PulleyIdentity { radius: p.radius, axis: unsigned_zeros(p.axis.into()) }),
            outlet_error: Some(cable.outlet_error).filter(|error| *error > 0.0),
        };
        let corner = |w: &Vector6<f64>| unsigned_zeros((*w).into());
        MapIdentity {
            cables: statics.cables().iter().map(cable).collect(),
            balance: unsigned_zeros((*statics.balance()).into()),
            characteristic_length: statics.characteristic_length(),
            required: match required {
                Required::Balls { force, moment } => {
                    let [force, moment] = unsigned_zeros([*force, *moment]);
                    RequiredIdentity::Balls { force, moment }
                }
                Required::Polytope(corners) => RequiredIdentity::Polytope(corners.iter().map(corner).collect()),
            },
        }
    }

    /// A short hash of the identity: 16 hexadecimal digits.
    pub fn fingerprint(&self) -> String {
        fingerprint_of(&serde_json::to_string(self).expect("plain data"))
    }

    /// A description of the first difference to another identity: `tension of cables[3]: [10.0, 900.0] and not
    /// [10.0, 1000.0]`, this one's value first. `None` if they are equal.
    pub fn first_difference(&self, other: &Self) -> Option<String> {
        if self.cables.len() != other.cables.len() {
            return Some(format!("{} cables and not {}", self.cables.len(), other.cables.len()));
        }
        let pairs = self.cables.iter().zip(&other.cables).enumerate();
        let cables = pairs.flat_map(|(k, (a, b))| {
            [
                differs(&format!("outlet of cables[{k}]"), &a.outlet, &b.outlet),
                differs(&format!("attachment of cables[{k}], turned to the orientation"), &a.arm, &b.arm),
                differs(&format!("tension of cables[{k}]"), &a.tension, &b.tension),
                differs(&format!("pulley of cables[{k}]"), &a.pulley, &b.pulley),
                differs(&format!("outlet_error of cables[{k}]"), &a.outlet_error, &b.outlet_error),
            ]
        });
        let rest = [
            differs("characteristic length", &self.characteristic_length, &other.characteristic_length),
            differs("wrench to balance (weight and load)", &self.balance, &other.balance),
            differs("required wrenches", &self.required, &other.required),
        ];
        cables.chain(rest).flatten().next()
    }

    /// Rejects a map with a different identity.
    ///
    /// # Errors
    /// Names the first difference.
    pub fn expect(&self, found: &Self) -> Result<(), Error> {
        let Some(difference) = found.first_difference(self) else { return Ok(()) };
        let problem = format!(
            "found a map of another robot, load or demand, with {difference}; expected identity {}, found {}; make the \
             map anew",
            self.fingerprint(),
            found.fingerprint()
        );
        Err(Error::invalid("identity", problem))
    }
}

/// −0 and 0 are the same number and should have the same fingerprint.
fn unsigned_zeros<const N: usize>(numbers: [f64; N]) -> [f64; N] {
    numbers.map(|x| x + 0.0)
}

fn differs<T: PartialEq + std::fmt::Debug>(what: &str, a: &T, b: &T) -> Option<String> {
    (a != b).then(|| format!("{what}: {a:?} and not {b:?}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Robot;
    use crate::geometry::{Rotation, Vector};
    use crate::model::{PulleySpec, RobotSpec};
    use crate::testing::paper_robot;
    use crate::wrench::Loads;

    fn identity(change: impl Fn(&mut RobotSpec, &mut Loads)) -> MapIdentity {
        let (mut spec, mut loads) = (paper_robot(), Loads::default());
        change(&mut spec, &mut loads);
        let statics = Statics::new(&Robot::try_from(spec).unwrap(), &loads).unwrap();
        MapIdentity::of(&statics, &Required::balls(50.0, 5.0).unwrap())
    }

    #[test]
    fn every_input_of_the_margins_changes_the_identity() {
        let own = identity(|_, _| {});
        type Change = fn(&mut RobotSpec, &mut Loads);
        let pulley = |spec: &mut RobotSpec, _: &mut Loads| {
            spec.cables[2].pulley = Some(PulleySpec { radius: 0.05, axis: [0.0, 0.0, 1.0] });
        };
        let changes: [(&str, Change); 10] = [
            ("outlet of cables[3]", |spec, _| spec.cables[3].outlet[2] += 0.1),
            ("attachment of cables[0]", |_, loads| loads.orientation = Rotation::from_scaled_axis(Vector::z())),
            ("tension of cables[5]: [10.0, 900.0] and not", |spec, _| spec.cables[5].tension = Some([10.0, 900.0])),
            ("pulley of cables[2]", pulley),
            ("outlet_error of cables[1]", |spec, _| spec.cables[1].outlet_error = Some(0.01)),
            ("7 cables and not 8", |spec, _| spec.cables.truncate(7)),
            ("characteristic length: 0.5 and not 1.0", |_, loads| loads.characteristic_length = 0.5),
            ("wrench to balance", |spec, _| spec.center_of_mass = Some([0.01, 0.0, 0.0])),
            ("wrench to balance", |_, loads| loads.gravity.z = -1.6),
            ("wrench to balance", |_, loads| loads.load[5] = 1.0),
        ];
        for (words, change) in changes {
            let other = identity(change);
            assert_ne!(own.fingerprint(), other.fingerprint(), "{words}");
            let error = own.expect(&other).unwrap_err().to_string();
            assert!(error.contains(words) && error.contains(&other.fingerprint()), "{error}");
        }
        assert!(own.expect(&identity(|spec, _| spec.name = None)).is_ok());
    }

    #[test]
    fn identities_depend_on_demands_not_signs_of_zero() {
        let statics = Statics::new(&Robot::try_from(paper_robot()).unwrap(), &Loads::default()).unwrap();
        let of = |required: Required| MapIdentity::of(&statics, &required);
        let balls = of(Required::balls(0.0, 0.0).unwrap());
        assert_eq!(balls.fingerprint(), of(Required::balls(-0.0, 0.0).unwrap()).fingerprint());
        let corner = of(Required::Polytope(vec![Vector6::zeros()]));
        assert!(balls.first_difference(&corner).unwrap().starts_with("required wrenches"));
    }

    #[test]
    fn an_identity_survives_json_bit_for_bit() {
        let own = identity(|spec, loads| {
            spec.cables[2].outlet[0] = 0.1 + 0.2;
            loads.orientation = Rotation::from_scaled_axis(Vector::new(0.1, 0.2, 0.3));
        });
        let read: MapIdentity = serde_json::from_str(&serde_json::to_string(&own).unwrap()).unwrap();
        assert_eq!(read, own);
    }
}
