//! Cable directions and the wrench matrix; the pose that has given cable lengths.

mod forward;
pub mod freedom;

pub use forward::{ForwardKinematics, PoseEstimate};

use nalgebra::{DMatrix, Matrix6xX, Vector6};

use crate::error::Error;
use crate::geometry::{Departure, Point, Rotation, Vector};
use crate::model::{Cable, Robot};
use crate::tolerances::{MIN_CABLE_LENGTH, RANK_RELATIVE, SAME_POINT};

/// Wrench matrix of all cables, 6 × m, with the platform's origin at `position` and orientation `orientation`.
///
/// Column i is [uᵢ ; rᵢ × uᵢ] in world axes: uᵢ the unit vector along cable i from its attachment to where it leaves the
/// frame, rᵢ from the platform's origin to the attachment. Rows 0 to 2 are unitless, rows 3 to 5 are metres. Equilibrium is `W t + w_ext = 0`.
///
/// # Errors
/// A cable shorter than [`MIN_CABLE_LENGTH`], or one that cannot leave its pulley: its direction is undefined.
///
/// # Source
/// The paper, section 3.3; elsewhere in the field called the structure matrix.
///
/// # Example
/// ```
/// use cdpr_core::{Point, kinematics::wrench_matrix, testing};
/// let scene = testing::empty();
/// let w = wrench_matrix(scene.robot(), scene.orientation(), &Point::new(1.0, 1.0, 1.0))?;
/// let net = w * nalgebra::DVector::repeat(8, 1.0); // a symmetric robot in the middle, equal tensions:
/// assert!(net.norm() < 1e-12); // forces and moments cancel
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn wrench_matrix(robot: &Robot, orientation: &Rotation, position: &Point) -> Result<Matrix6xX<f64>, Error> {
    let mut columns = Vec::with_capacity(robot.cables().len());
    for cable in robot.cables() {
        let arm = orientation * cable.attachment.coords;
        let attachment = position + arm;
        let Some(Departure { pull: unit, .. }) = cable.departure(&attachment) else {
            return Err(no_direction(cable, &attachment));
        };
        let moment = arm.cross(&unit);
        columns.push(Vector6::new(unit.x, unit.y, unit.z, moment.x, moment.y, moment.z));
    }
    Ok(Matrix6xX::from_columns(&columns))
}

/// The error for a cable that has no direction with its attachment at this point.
fn no_direction(cable: &Cable, attachment: &Point) -> Error {
    let length = (cable.outlet - attachment).norm();
    let problem = match cable.pulley {
        None => format!("has length {length:.3e} m at this position, expected at least {MIN_CABLE_LENGTH:e} m"),
        Some(pulley) => format!(
            "cannot leave its pulley at this position: its attachment is {length:.3} m from the outlet, within the wheel \
             of radius {} m or below it",
            pulley.radius
        ),
    };
    Error::invalid(&cable.name, problem)
}

/// Whether vectors (attachments, arms) all coincide.
pub(crate) fn meet_in_one_point(arms: impl Iterator<Item = Vector>) -> bool {
    let arms: Vec<Vector> = arms.collect();
    arms.iter().all(|arm| (arm - arms[0]).norm() <= SAME_POINT)
}

/// Length of each cable from outlet to attachment, round its pulley if it has one, m, with the platform's origin at `position` and
/// orientation `orientation`; NaN where a cable cannot leave its pulley.
///
/// # Example
/// ```
/// use cdpr_core::{Point, kinematics::cable_lengths, testing};
/// let scene = testing::empty(); // symmetric, and this is its middle
/// let lengths = cable_lengths(scene.robot(), scene.orientation(), &Point::new(1.0, 1.0, 1.0));
/// assert!(lengths.len() == 8 && lengths.iter().all(|length| (length - lengths[0]).abs() < 1e-12));
/// ```
pub fn cable_lengths(robot: &Robot, orientation: &Rotation, position: &Point) -> Vec<f64> {
    robot.cables().iter().map(|cable| cable.length_to(&(position + orientation * cable.attachment.coords))).collect()
}

/// Rank of a wrench matrix; singular values below [`RANK_RELATIVE`] of the largest count as zero.
pub fn rank(wrench_matrix: &Matrix6xX<f64>) -> usize {
    let singular = singular_values(wrench_matrix);
    singular.iter().filter(|s| **s > RANK_RELATIVE * singular[0]).count()
}

/// Condition number of a wrench matrix: the ratio of its first to its sixth singular value; infinite if the rank is
/// below 6.
pub fn condition(wrench_matrix: &Matrix6xX<f64>) -> f64 {
    let singular = singular_values(wrench_matrix);
    if rank(wrench_matrix) == 6 { singular[0] / singular[5] } else { f64::INFINITY }
}

/// Singular values, largest first.
fn singular_values(wrench_matrix: &Matrix6xX<f64>) -> Vec<f64> {
    let matrix = DMatrix::from_column_slice(6, wrench_matrix.ncols(), wrench_matrix.as_slice());
    let mut singular: Vec<f64> = matrix.singular_values().iter().copied().collect();
    singular.sort_by(|a, b| b.total_cmp(a));
    singular
}
