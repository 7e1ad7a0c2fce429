//! The inertia of a platform: as given, or that of its parts at uniform density.

use nalgebra::{Matrix3, SymmetricEigen};

use super::spec::InertiaSpec;
use crate::error::Error;
use crate::geometry::{Point, Polytope, Vector};
use crate::tolerances::INERTIA_ROUNDING;

/// The tensor of an inertia about the centre of mass, platform axes, kg·m².
///
/// # Errors
/// Numbers that are not finite, a tensor that is not symmetric or not positive definite, or principal moments that no body
/// has: one of them is larger than the sum of the other two.
///
/// # Example
/// ```
/// use cdpr_core::model::{InertiaSpec, inertia::checked};
/// assert_eq!(checked("inertia", &InertiaSpec::Diagonal([1.0, 2.0, 2.5]))?[(2, 2)], 2.5);
/// assert!(checked("inertia", &InertiaSpec::Diagonal([1.0, 2.0, 3.5])).is_err());
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn checked(place: &str, spec: &InertiaSpec) -> Result<Matrix3<f64>, Error> {
    let tensor = match spec {
        InertiaSpec::Diagonal(moments) => Matrix3::from_diagonal(&Vector::from(*moments)),
        InertiaSpec::Tensor(rows) => Matrix3::from_fn(|row, column| rows[row][column]),
    };
    let problem = |problem: String| Err(Error::invalid(place, problem));
    if let Some(number) = tensor.iter().find(|x| !x.is_finite()) {
        return problem(format!("found {number}, expected finite numbers, kg·m²"));
    }
    let rounding = INERTIA_ROUNDING * tensor.abs().max();
    for (row, column) in [(0, 1), (0, 2), (1, 2)] {
        let [above, below] = [tensor[(row, column)], tensor[(column, row)]];
        if (above - below).abs() > rounding {
            return problem(format!(
                "found {above} in row {row}, column {column}, but {below} in row {column}, column {row}; expected a symmetric \
                 tensor"
            ));
        }
    }
    let symmetric = 0.5 * (tensor + tensor.transpose());
    let mut moments = SymmetricEigen::new(symmetric).eigenvalues;
    moments.as_mut_slice().sort_by(f64::total_cmp);
    let [least, middle, most] = moments.into();
    if !(least > 0.0) {
        return problem(format!("found a principal moment of {least} kg·m², expected positive ones"));
    }
    if most > least + middle + rounding {
        return problem(format!(
            "found the principal moments {least}, {middle} and {most} kg·m², expected none larger than the sum of the other two"
        ));
    }
    Ok(symmetric)
}

/// The inertia of bodies of this total mass, kg, at uniform density, about their common centre of mass, kg·m². Bodies of less
/// than the largest dimension among them have no mass; points have no inertia.
pub fn uniform(mass: f64, parts: &[Polytope]) -> Matrix3<f64> {
    let simplices = all_simplices(parts);
    let Some((center, total)) = center(&simplices) else { return Matrix3::zeros() };
    let moments: Matrix3<f64> = simplices.iter().map(|simplex| simplex.second_moments(&center) * (mass / total)).sum();
    Matrix3::identity() * moments.trace() - moments
}

/// The centre of the volume of a body, or of its area or length if it has no volume.
pub fn center_of_volume(body: &Polytope) -> Point {
    center(&simplices(body, body.dimension())).map_or_else(|| body.centroid(), |(center, _)| center.into())
}

/// The inertia about a point at this distance from the centre of mass, less that about the centre of mass, kg·m².
pub fn of_point(mass: f64, from: &Vector) -> Matrix3<f64> {
    (Matrix3::identity() * from.norm_squared() - from * from.transpose()) * mass
}

/// Simplices that make up those of the bodies that have the largest dimension among them.
fn all_simplices(parts: &[Polytope]) -> Vec<Simplex> {
    let dimension = parts.iter().map(Polytope::dimension).max().unwrap_or(0);
    parts.iter().filter(|part| part.dimension() == dimension).flat_map(|part| simplices(part, dimension)).collect()
}

/// The centre and the total size of simplices; `None` if they have none.
fn center(simplices: &[Simplex]) -> Option<(Vector, f64)> {
    let total: f64 = simplices.iter().map(|simplex| simplex.size).sum();
    let center = || simplices.iter().map(|simplex| simplex.center() * (simplex.size / total)).sum();
    (total > 0.0).then(|| (center(), total))
}

/// A simplex of a body.
struct Simplex {
    corners: Vec<Vector>,
    /// Length, area or volume of the simplex.
    size: f64,
}

impl Simplex {
    fn new(corners: &[Point]) -> Self {
        let edges: Vec<Vector> = corners[1..].iter().map(|corner| corner - corners[0]).collect();
        let size = match edges[..] {
            [a] => a.norm(),
            [a, b] => 0.5 * a.cross(&b).norm(),
            [a, b, c] => a.cross(&b).dot(&c).abs() / 6.0,
            _ => 0.0,
        };
        Simplex { corners: corners.iter().map(|corner| corner.coords).collect(), size }
    }

    fn center(&self) -> Vector {
        self.corners.iter().sum::<Vector>() / self.corners.len() as f64
    }

    /// The integral of x xᵀ over the simplex, with x from `center`: with n corners it is its size times (Σ x xᵀ + s sᵀ) over
    /// n (n + 1), where s is the sum of the corners.
    fn second_moments(&self, center: &Vector) -> Matrix3<f64> {
        let from: Vec<Vector> = self.corners.iter().map(|corner| corner - center).collect();
        let (sum, count) = (from.iter().sum::<Vector>(), from.len() as f64);
        let squares: Matrix3<f64> = from.iter().map(|x| x * x.transpose()).sum();
        (squares + sum * sum.transpose()) * (self.size / (count * (count + 1.0)))
    }
}

/// Simplices that make up a body of this dimension.
fn simplices(body: &Polytope, dimension: usize) -> Vec<Simplex> {
    let corners = body.vertices();
    match dimension {
        1 => vec![Simplex::new(corners)],
        2 => {
            let ring = in_order(corners, body);
            (1..ring.len() - 1).map(|k| Simplex::new(&[ring[0], ring[k], ring[k + 1]])).collect()
        }
        3 => {
            let fan = |facet: &crate::geometry::Facet| {
                let ring: Vec<Point> = facet.corners.iter().map(|&k| corners[k]).collect();
                let tip = body.centroid();
                (1..ring.len() - 1).map(|k| Simplex::new(&[tip, ring[0], ring[k], ring[k + 1]])).collect::<Vec<_>>()
            };
            body.facets().iter().flat_map(fan).collect()
        }
        _ => Vec::new(),
    }
}

/// The corners of a flat convex body in order around its centre.
fn in_order(corners: &[Point], body: &Polytope) -> Vec<Point> {
    let center = body.centroid();
    let first = corners[0] - center;
    let by_area = |a: &&Point, b: &&Point| {
        let area = |p: &Point| first.cross(&(p - center)).norm();
        area(a).total_cmp(&area(b))
    };
    let Some(aside) = corners.iter().max_by(by_area) else { return Vec::new() };
    let normal = first.cross(&(aside - center));
    let side = normal.cross(&first);
    let angle = |p: &Point| (p - center).dot(&side).atan2((p - center).dot(&first) * normal.norm());
    let mut ring = corners.to_vec();
    ring.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    ring
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Rotation;

    fn close(found: &Matrix3<f64>, expected: [f64; 3]) {
        let expected = Matrix3::from_diagonal(&Vector::from(expected));
        assert!((found - expected).norm() < 1e-12 * (1.0 + expected.norm()), "{found} {expected}");
    }

    #[test]
    fn boxes_plates_and_rods_have_the_inertia_of_the_textbook() {
        let (mass, [a, b, c]) = (12.0, [0.3, 0.4, 0.5]);
        let solid = Polytope::cuboid([a, b, c]).unwrap();
        close(&uniform(mass, std::slice::from_ref(&solid)), [b * b + c * c, a * a + c * c, a * a + b * b]);
        // Wherever it is.
        let moved = solid.transformed(&Rotation::identity(), &Vector::new(3.0, -2.0, 1.0));
        close(&uniform(mass, &[moved]), [b * b + c * c, a * a + c * c, a * a + b * b]);
        let plate: Vec<Point> =
            [[-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [1.0, -1.0]].map(|[x, y]| Point::new(x * a, y * b, 7.0)).to_vec();
        let plate = Polytope::from_vertices(&plate).unwrap();
        close(&uniform(mass, &[plate]), [4.0 * b * b, 4.0 * a * a, 4.0 * (a * a + b * b)]);
        let rod = Polytope::from_vertices(&[Point::new(0.0, 0.0, 0.0), Point::new(0.0, 0.0, c)]).unwrap();
        close(&uniform(mass, &[rod]), [c * c, c * c, 0.0]);
        let point = Polytope::from_vertices(&[Point::new(0.1, 0.2, 0.3)]).unwrap();
        close(&uniform(mass, &[point]), [0.0; 3]);
    }

    #[test]
    fn inertia_is_additive_and_flat_parts_are_massless() {
        let half = |x: f64| {
            Polytope::cuboid([0.5, 0.4, 0.2]).unwrap().transformed(&Rotation::identity(), &Vector::new(x, 0.0, 0.0))
        };
        let plate: Vec<Point> = [[0.0, 0.0], [9.0, 0.0], [0.0, 9.0]].map(|[x, y]| Point::new(x, y, 0.0)).to_vec();
        let parts = [half(-0.25), half(0.25), Polytope::from_vertices(&plate).unwrap()];
        close(&uniform(1.2, &parts), [0.1 * 0.2, 0.1 * 1.04, 0.1 * 1.16]);
    }

    #[test]
    fn a_diagonal_and_rows_are_read() {
        let read = |text: &str| serde_json::from_str::<InertiaSpec>(text);
        assert_eq!(read("[1, 2.5, 3]").unwrap(), InertiaSpec::Diagonal([1.0, 2.5, 3.0]));
        let rows = [[1.0, 0.1, 0.0], [0.1, 2.0, 0.0], [0.0, 0.0, 2.5]];
        assert_eq!(read(&serde_json::to_string(&rows).unwrap()).unwrap(), InertiaSpec::Tensor(rows));
        for wrong in
            ["[1, 2]", "[1, 2, 3, 4]", "[[1, 0], [0, 2, 0], [0, 0, 2.5]]", "[[1, 0, 0], 2, 3]", "3", "[true, 1, 1]"]
        {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn inertias_that_no_body_has_are_refused() {
        let said = |spec| checked("inertia", &spec).unwrap_err().to_string();
        assert!(said(InertiaSpec::Diagonal([1.0, f64::NAN, 1.0])).contains("NaN"));
        assert!(said(InertiaSpec::Diagonal([1.0, 0.0, 1.0])).contains("expected positive"));
        assert!(said(InertiaSpec::Diagonal([1.0, 1.0, 2.1])).contains("sum of the other two"));
        let skew = [[1.0, 0.1, 0.0], [0.2, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert!(said(InertiaSpec::Tensor(skew)).contains("0.1 in row 0, column 1, but 0.2"));
        let coupled = [[1.0, 0.9, 0.0], [0.9, 1.0, 0.0], [0.0, 0.0, 1.0]];
        // Principal moments 0.1, 1 and 1.9.
        assert!(said(InertiaSpec::Tensor(coupled)).contains("sum of the other two"));
        let plate = checked("inertia", &InertiaSpec::Diagonal([1.0, 2.0, 3.0])).unwrap();
        assert_eq!(plate.trace(), 6.0);
    }
}
