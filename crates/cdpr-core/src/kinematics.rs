//! Cable directions and the wrench matrix.

use nalgebra::{DMatrix, Matrix6xX, Vector6};

use crate::error::Error;
use crate::geometry::Point;
use crate::model::Scene;
use crate::numerics::{MIN_CABLE_LENGTH, RANK_RELATIVE};

/// Wrench matrix of all cables with the platform's origin at `position` and turned as the scene says: 6 × m.
///
/// Column i is [uᵢ ; rᵢ × uᵢ] in world axes: uᵢ the unit vector from attachment i to its outlet, rᵢ from the platform's
/// origin to the attachment. Rows 0 to 2 are unitless, rows 3 to 5 are metres. Equilibrium is `W t + w_ext = 0`.
///
/// # Errors
/// A cable shorter than [`MIN_CABLE_LENGTH`]: its direction is undefined.
///
/// # Source
/// The paper, section 3.3; elsewhere in the field called the structure matrix.
///
/// # Example
/// ```
/// use cdpr_core::{geometry::Point, kinematics::wrench_matrix, testing};
/// let w = wrench_matrix(&testing::empty(), &Point::new(1.0, 1.0, 1.0))?;
/// let net = w * nalgebra::DVector::repeat(8, 1.0); // a symmetric robot in the middle, equal tensions:
/// assert!(net.norm() < 1e-12); // forces and moments cancel
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn wrench_matrix(scene: &Scene, position: &Point) -> Result<Matrix6xX<f64>, Error> {
    let cables = scene.robot().cables();
    let mut columns = Vec::with_capacity(cables.len());
    for cable in cables {
        let arm = scene.orientation() * cable.attachment.coords;
        let line = cable.outlet - (position + arm);
        if !(line.norm() >= MIN_CABLE_LENGTH) {
            let problem =
                format!("has length {:.3e} m at this position, expected at least {MIN_CABLE_LENGTH:e} m", line.norm());
            return Err(Error::invalid(&cable.name, problem));
        }
        let unit = line.normalize();
        let moment = arm.cross(&unit);
        columns.push(Vector6::new(unit.x, unit.y, unit.z, moment.x, moment.y, moment.z));
    }
    Ok(Matrix6xX::from_columns(&columns))
}

/// Rank of a wrench matrix, singular values below [`RANK_RELATIVE`] of the largest counting as zero.
pub fn rank(wrench_matrix: &Matrix6xX<f64>) -> usize {
    let singular = DMatrix::from_column_slice(6, wrench_matrix.ncols(), wrench_matrix.as_slice()).singular_values();
    singular.iter().filter(|s| **s > RANK_RELATIVE * singular.max()).count()
}
