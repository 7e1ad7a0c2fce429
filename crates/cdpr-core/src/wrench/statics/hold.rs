//! How the cables can hold the platform at a position regardless of tension limits: the rank of the wrench matrix, and
//! its consequences.

use nalgebra::{Matrix6xX, SVector, Vector6};

use crate::geometry::{Point, Rotation};
pub use crate::kinematics::freedom::{FreeMotion, Hold, Holding};
use crate::kinematics::{meet_in_one_point, wrench_matrix};
use crate::model::Robot;
use crate::tolerances::TENSION_RATIO;
use crate::wrench::tensions::{Balance, FeasibilityLp};
use crate::wrench::zonotope::Span;

/// Components of a twist below this share of the largest one are rounding errors.
const NEGLIGIBLE: f64 = 1e-6;

impl Hold {
    /// How a platform is constrained by these columns of a wrench matrix, forces and moments in metres; for a point
    /// mass only forces count.
    pub fn of(columns: &[Vector6<f64>], point_mass: bool) -> Self {
        if point_mass {
            let forces: Vec<SVector<f64, 3>> = columns.iter().map(|c| c.fixed_rows::<3>(0).into()).collect();
            return Self::of_generators(&forces);
        }
        Self::of_generators(columns)
    }

    /// How the cables of a robot constrain the platform at a position; `None` if a cable has no direction.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{Point, testing, wrench::{Hold, Holding}};
    /// let scene = testing::empty(); // the paper's symmetric robot
    /// let hold = Hold::at(scene.robot(), scene.orientation(), &Point::new(1.0, 1.0, 1.0)).unwrap();
    /// assert_eq!((hold.rank, hold.holding), (5, Holding::Underconstrained));
    /// assert_eq!(hold.free_motions[0].words(), "turning about z");
    /// ```
    pub fn at(robot: &Robot, orientation: &Rotation, position: &Point) -> Option<Self> {
        let matrix = wrench_matrix(robot, orientation, position).ok()?;
        let columns: Vec<Vector6<f64>> = matrix.column_iter().map(Into::into).collect();
        Some(Self::of(&columns, meet_in_one_point(robot.cables().iter().map(|cable| cable.attachment.coords))))
    }

    fn of_generators<const N: usize>(generators: &[SVector<f64, N>]) -> Self {
        let span = Span::of(generators);
        let holding = match (span.rank() == N, pull_against_each_other(generators)) {
            (false, _) => Holding::Underconstrained,
            (true, true) => Holding::FullyConstrained,
            (true, false) => Holding::Suspended,
        };
        let motion =
            |row: SVector<f64, N>| FreeMotion { twist: std::array::from_fn(|k| row.get(k).copied().unwrap_or(0.0)) };
        let free_motions = reduced(span.left_null().to_vec()).into_iter().map(motion).collect();
        Hold { rank: span.rank(), full_rank: N, holding, free_motions }
    }
}

/// Whether positive tensions, none of them more than [`TENSION_RATIO`] times another, cancel each other.
fn pull_against_each_other<const N: usize>(generators: &[SVector<f64, N>]) -> bool {
    let row = |row: usize, column: usize| generators[column].get(row).copied().unwrap_or(0.0);
    let matrix = Matrix6xX::from_fn(generators.len(), row);
    let limits = vec![[1.0, TENSION_RATIO]; generators.len()];
    matches!(FeasibilityLp::new().solve(&matrix, &limits, &Vector6::zeros()), Ok(Balance::Feasible(_)))
}

/// A basis of the same space in which each vector has a 1 where all others have a 0, so that rotations about and
/// translations along an axis appear as such.
fn reduced<const N: usize>(mut basis: Vec<SVector<f64, N>>) -> Vec<SVector<f64, N>> {
    let mut pivots: Vec<usize> = Vec::new();
    for k in 0..basis.len() {
        let open = |axis: &usize| !pivots.contains(axis);
        let size = |row: usize, axis: usize| basis[row][axis].abs();
        let places = (k..basis.len()).flat_map(|row| (0..N).filter(open).map(move |axis| (row, axis)));
        let largest = places.max_by(|a, b| size(a.0, a.1).total_cmp(&size(b.0, b.1)));
        let (row, axis) = largest.expect("fewer vectors than axes");
        basis.swap(k, row);
        let pivot = basis[k] / basis[k][axis];
        basis[k] = pivot;
        for other in (0..basis.len()).filter(|other| *other != k) {
            let factor = basis[other][axis];
            basis[other] -= pivot * factor;
        }
        pivots.push(axis);
    }
    let mut rows: Vec<(usize, SVector<f64, N>)> = pivots.into_iter().zip(basis.into_iter().map(tidied)).collect();
    rows.sort_by_key(|(axis, _)| *axis);
    rows.into_iter().map(|(_, row)| row).collect()
}

/// Scaled so that the largest component is 1, with rounding errors set to 0.
fn tidied<const N: usize>(row: SVector<f64, N>) -> SVector<f64, N> {
    let largest = row[row.iamax()];
    row.map(|x| if (x / largest).abs() <= NEGLIGIBLE { 0.0 } else { x / largest })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector;

    fn cable(direction: [f64; 3], arm: [f64; 3]) -> Vector6<f64> {
        let (unit, arm) = (Vector::from(direction).normalize(), Vector::from(arm));
        let moment = arm.cross(&unit);
        Vector6::new(unit.x, unit.y, unit.z, moment.x, moment.y, moment.z)
    }

    #[test]
    fn point_masses_are_classified_as_held() {
        let up = [[1.0, 1.0, 1.0], [-1.0, 1.0, 1.0], [0.0, -1.0, 1.0]];
        let mut columns: Vec<_> = up.iter().map(|d| cable(*d, [0.0; 3])).collect();
        let hold = Hold::of(&columns, true);
        assert_eq!((hold.rank, hold.full_rank, hold.holding), (3, 3, Holding::Suspended));
        columns.push(cable([0.0, 0.0, -1.0], [0.0; 3]));
        assert_eq!(Hold::of(&columns, true).holding, Holding::FullyConstrained);
        columns.truncate(2);
        let hold = Hold::of(&columns, true);
        assert_eq!(hold.holding, Holding::Underconstrained);
        assert_eq!(hold.free_motions.len(), 1);
        let across = Vector::from_column_slice(&hold.free_motions[0].twist[..3]);
        assert!(up[..2].iter().all(|d| Vector::from(*d).dot(&across).abs() < 1e-12), "{hold:?}");
    }

    #[test]
    fn upright_cables_leave_three_motions_free_and_name_them() {
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let columns: Vec<_> = corners.iter().map(|[x, y]| cable([0.0, 0.0, 1.0], [*x, *y, 0.0])).collect();
        let hold = Hold::of(&columns, false);
        assert_eq!((hold.rank, hold.holding), (3, Holding::Underconstrained));
        assert_eq!(
            hold.sentence(),
            "rank 3 of 6, underconstrained: no tensions resist moving along x, nor moving along y, nor turning about z"
        );
    }

    #[test]
    fn a_swing_turns_while_it_moves() {
        // Four cables from the corners of an oblong ceiling to those of a square: it swings sideways and turns at the
        // same time.
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let columns: Vec<_> = corners.iter().map(|[x, y]| cable([1.5 * x, *y, 1.0], [0.2 * x, 0.2 * y, 0.1])).collect();
        let hold = Hold::of(&columns, false);
        assert_eq!(hold.rank, 4);
        for motion in &hold.free_motions {
            let twist = Vector6::from(motion.twist);
            assert!(columns.iter().all(|column| column.dot(&twist).abs() < 1e-9), "{motion:?}");
            assert!(motion.words().contains(" while "), "{}", motion.words());
        }
    }
}
