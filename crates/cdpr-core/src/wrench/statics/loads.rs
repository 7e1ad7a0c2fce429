//! The loads on the platform: its weight, a payload and constant wrenches, in one or several load cases.

use nalgebra::Vector6;

use crate::geometry::{Rotation, Vector};
use crate::model::{LoadCase, Robot, Scene};

/// The loads on the platform, and the units in which its wrenches are measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Loads {
    /// Rotation from the platform frame to the world frame.
    pub orientation: Rotation,
    /// Gravity, world axes, m/s².
    pub gravity: Vector,
    /// A mass carried at the platform's centre of mass, kg.
    pub payload: f64,
    /// A further constant wrench, world axes, with its moment about the platform's origin, N and N·m.
    pub load: Vector6<f64>,
    /// Length by which moments are divided, so that they are comparable to forces, m.
    pub characteristic_length: f64,
    /// The load case of the scene that these loads belong to, if it has several.
    pub case: Option<LoadCase>,
}

impl Default for Loads {
    fn default() -> Self {
        Loads {
            orientation: Rotation::identity(),
            gravity: crate::model::GRAVITY.into(),
            payload: 0.0,
            load: Vector6::zeros(),
            characteristic_length: 1.0,
            case: None,
        }
    }
}

impl Loads {
    /// The first load case of a scene: its orientation, its gravity and its `[wrench]` table, with the first of several loads and
    /// without the payload.
    pub fn of(scene: &Scene) -> Self {
        Self::cases(scene).swap_remove(0)
    }

    /// All load cases of a scene: each of its loads without the payload, then each with the payload.
    pub fn cases(scene: &Scene) -> Vec<Self> {
        let wrench = scene.wrench().cloned().unwrap_or_default();
        let loads = wrench.loads.unwrap_or_else(|| vec![wrench.load.unwrap_or_default()]);
        let of = loads.len();
        let case = |payload: f64, k: usize| {
            let (load, carried) = ((of > 1).then_some([k + 1, of]), wrench.payload.map(|_| payload > 0.0));
            let several = load.is_some() || carried.is_some();
            Loads {
                orientation: *scene.orientation(),
                gravity: scene.gravity(),
                payload,
                load: loads[k].into(),
                characteristic_length: wrench.characteristic_length.unwrap_or(Loads::default().characteristic_length),
                case: several.then_some(LoadCase { load, payload: carried }),
            }
        };
        let payloads = [Some(0.0), wrench.payload].into_iter().flatten();
        payloads.flat_map(|payload| (0..of).map(move |k| (payload, k))).map(|(payload, k)| case(payload, k)).collect()
    }

    /// These loads on a platform with another orientation.
    pub fn at(&self, orientation: &Rotation) -> Self {
        Loads { orientation: *orientation, ..self.clone() }
    }

    /// The mass of a robot's platform including a payload, kg; `None` if it is unknown.
    pub fn mass(&self, robot: &Robot) -> Option<f64> {
        Some(robot.mass()? + self.payload)
    }

    /// The wrench that the cables of a robot must exert for balance, [force; moment / ℓ], N; `None` without its mass.
    pub fn balance(&self, robot: &Robot) -> Option<Vector6<f64>> {
        Some(self.balance_of(self.mass(robot)?, &robot.center_of_mass().coords))
    }

    /// The wrench that the cables must exert for balance if platform and payload have this mass together, kg, and this centre of
    /// mass, platform frame, m.
    pub fn balance_of(&self, mass: f64, center: &Vector) -> Vector6<f64> {
        let weight = self.gravity * mass;
        let moment = (self.orientation * center).cross(&weight);
        let force = weight + self.load.fixed_rows::<3>(0);
        let moment = (moment + self.load.fixed_rows::<3>(3)) / self.characteristic_length;
        -Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
    }
}
