//! The capacity margin of many positions.

use super::kernel::{FourMargins, KernelRobot};
use super::margins::{BindingFacet, Required, capacity_limit};
use crate::error::Error;
use crate::geometry::{Placed, Point};
use crate::simd::{Kernel, WIDTH};
use crate::wrench::statics::{Part, Statics};

/// Capacity margins of a robot for a set of required wrenches; see [`capacity_limit`] for the definition.
///
/// # Example
/// ```
/// use cdpr_core::{Point, Required, testing, wrench::{CapacityMargin, Loads, Statics}};
/// let statics = Statics::new(testing::empty().robot(), &Loads::default())?;
/// let margin = CapacityMargin::new(statics, Required::balls(20.0, 0.0)?)?;
/// let (middle, above) = (Point::new(1.0, 1.0, 1.0), Point::new(1.0, 1.0, 2.5)); // above all outlets
/// assert!(margin.at(&middle) > margin.at(&above) && margin.at(&above) < 0.0);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct CapacityMargin {
    statics: Statics,
    required: Required,
    robot: Option<KernelRobot>,
    kernel: Kernel,
}

impl CapacityMargin {
    /// Capacity margins of a robot under its loads.
    ///
    /// # Errors
    /// A moment required of a point mass, which can exert none.
    pub fn new(statics: Statics, required: Required) -> Result<Self, Error> {
        if statics.point_mass() && required.needs_moment() {
            let problem =
                "found a required moment, expected none: all attachments coincide, so the cables exert no moment";
            return Err(Error::invalid("moment", problem));
        }
        let robot = match required {
            Required::Balls { force, moment } => {
                KernelRobot::new(&statics, [force, moment / statics.characteristic_length()])
            }
            Required::Polytope(_) => None,
        };
        Ok(CapacityMargin { statics, required, robot, kernel: Kernel::best() })
    }

    /// These margins computed without SIMD instructions, for comparison.
    pub fn portable(mut self) -> Self {
        self.kernel = Kernel::Portable;
        self
    }

    /// Whether margins are computed without SIMD instructions.
    pub fn is_portable(&self) -> bool {
        matches!(self.kernel, Kernel::Portable)
    }

    /// The statics of the robot.
    pub fn statics(&self) -> &Statics {
        &self.statics
    }

    /// Whether the four-position kernel supports this robot and requirement.
    pub fn by_kernel(&self) -> bool {
        self.robot.is_some()
    }

    /// The required wrenches.
    pub fn required(&self) -> &Required {
        &self.required
    }

    /// The margin at a position, N; NaN if a cable has no direction.
    pub fn at(&self, position: &Point) -> f64 {
        self.at_four(&[*position; WIDTH])[0]
    }

    /// The margins at four positions, N; each is equal to the result of [`CapacityMargin::at`].
    pub fn at_four(&self, positions: &[Point; WIDTH]) -> [f64; WIDTH] {
        let Some(robot) = &self.robot else { return positions.map(|p| self.defined_at(&p)) };
        let robot = robot.at_exits(&self.statics, positions);
        let mut margins = self.kernel.run(FourMargins { robot: &robot, positions: *positions });
        if self.statics.has_errors() {
            for (margin, position) in margins.iter_mut().zip(positions) {
                *margin -= self.statics.loss(position, Part::Whole).unwrap_or(f64::NAN);
            }
        }
        for (margin, position) in margins.iter_mut().zip(positions) {
            if margin.is_nan() {
                *margin = self.defined_at(position);
            }
        }
        margins
    }

    /// The margins at four poses by the kernel, N, with the wrenches [force; moment / ℓ] to balance there; NaN where the kernel is
    /// not sure. `None` if it does not support this robot and requirement.
    pub fn at_four_placed(&self, poses: &[Placed; WIDTH], balances: &[[f64; 6]; WIDTH]) -> Option<[f64; WIDTH]> {
        let robot = self.robot.as_ref()?.at_orientations(&self.statics, poses, balances);
        let positions = [poses[0].position, poses[1].position, poses[2].position, poses[3].position];
        let robot = robot.at_exits(&self.statics, &positions);
        let mut margins = self.kernel.run(FourMargins { robot: &robot, positions });
        if self.statics.has_errors() {
            for (margin, pose) in margins.iter_mut().zip(poses) {
                let turned = self.statics.turned(pose, *self.statics.balance());
                *margin -= turned.loss(&pose.position, Part::Whole).unwrap_or(f64::NAN);
            }
        }
        Some(margins)
    }

    /// The nearest facet, by definition rather than by the kernel; `None` if a cable has no direction.
    pub fn limit(&self, position: &Point) -> Option<BindingFacet<6>> {
        capacity_limit(&self.statics, &self.required, position)
    }

    #[cold]
    fn defined_at(&self, position: &Point) -> f64 {
        self.limit(position).map_or(f64::NAN, |limit| limit.margin)
    }
}
