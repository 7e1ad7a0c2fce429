//! Convex bodies as geoms of MuJoCo.

use cdpr_core::geometry::{Aabb, Point, Polytope, Rotation, Vector, wxyz};
use cdpr_core::tolerances::ON_SURFACE;
use nalgebra::{Matrix3, Rotation3};

use super::element::{Element, written};

/// Half the thickness of a body that is flat, a segment or a point, m: MuJoCo needs a volume.
pub const HALF_THICKNESS: f64 = 5e-5;

/// A convex body as a geom, and its mesh if it is not a box. The mesh gets the name `mesh`.
pub fn geom(body: &Polytope, mesh: &str) -> (Element, Option<Element>) {
    if let Some((sides, center, turn)) = cuboid(body) {
        let geom = Element::new("geom").with("type", "box").with_numbers("size", &sides.map(|side| 0.5 * side));
        let geom = geom.with_numbers("pos", center.coords.as_slice());
        let level = turn.angle() == 0.0;
        return (if level { geom } else { geom.with_numbers("quat", &wxyz(&turn)) }, None);
    }
    // MuJoCo stores corners in single precision, so they are given from the centre.
    let center = body.centroid();
    let corners: Vec<Vector> = body.vertices().iter().map(|corner| corner - center).collect();
    let corners = if body.has_volume() { corners } else { thickened(&corners) };
    let numbers: Vec<f64> = corners.iter().flat_map(|corner| [corner.x, corner.y, corner.z]).collect();
    let geom = Element::new("geom").with("type", "mesh").with("mesh", mesh);
    let asset = Element::new("mesh").with("name", mesh).with("vertex", written(&numbers));
    (geom.with_numbers("pos", center.coords.as_slice()), Some(asset))
}

/// The sides, centre and orientation of a body that is a box.
fn cuboid(body: &Polytope) -> Option<([f64; 3], Point, Rotation)> {
    let corners = body.vertices();
    if !body.has_volume() || corners.len() != 8 || body.normal_axes().len() != 3 {
        return None;
    }
    let mut left = body.normal_axes().to_vec();
    // The axis of each column is the one nearest to that of the world.
    let mut axes = Matrix3::zeros();
    for k in 0..3 {
        let nearest = (0..left.len()).max_by(|&a, &b| left[a][k].abs().total_cmp(&left[b][k].abs()))?;
        let axis = left.swap_remove(nearest);
        axes.set_column(k, &(axis * if axis[k] < 0.0 { -1.0 } else { 1.0 }));
    }
    if axes.determinant() < 0.0 {
        axes.column_mut(2).neg_mut();
    }
    let local: Vec<Point> = corners.iter().map(|corner| Point::from(axes.tr_mul(&corner.coords))).collect();
    let within = Aabb::around(&local);
    let (sides, middle) = (within.max - within.min, nalgebra::center(&within.min, &within.max));
    let is_corner = |p: &Point| (0..3).all(|k| ((p[k] - middle[k]).abs() - 0.5 * sides[k]).abs() <= ON_SURFACE);
    let square = (axes.tr_mul(&axes) - Matrix3::identity()).abs().max() * sides.norm() <= ON_SURFACE;
    let turn = Rotation::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
    (square && local.iter().all(is_corner)).then(|| (sides.into(), Point::from(axes * middle.coords), turn))
}

/// The corners of a body that extends [`HALF_THICKNESS`] farther along each axis.
fn thickened(corners: &[Vector]) -> Vec<Vector> {
    let side = |bit: usize| if bit == 0 { -HALF_THICKNESS } else { HALF_THICKNESS };
    let shifts: Vec<Vector> = (0..8).map(|k| Vector::new(side(k & 1), side(k & 2), side(k & 4))).collect();
    corners.iter().flat_map(|corner| shifts.iter().map(move |shift| corner + shift)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_are_recognised_however_they_are_given() {
        let sides = [0.2, 0.4, 0.7];
        let place = Vector::new(3.0, -2.0, 1.0);
        for turn in [Rotation::identity(), Rotation::from_euler_angles(0.3, -1.2, 2.0)] {
            let body = Polytope::cuboid(sides).unwrap().transformed(&turn, &place);
            let given = Polytope::from_vertices(body.vertices()).unwrap();
            let (found, center, axes) = cuboid(&given).expect("a box");
            assert!((center.coords - place).norm() < 1e-12);
            // The same corners.
            let again = Polytope::cuboid(found).unwrap().transformed(&axes, &center.coords);
            for corner in again.vertices() {
                assert!(body.vertices().iter().any(|other| (other - corner).norm() < 1e-9), "{corner}");
            }
        }
        let skew = [[0.0, 0.0], [1.0, 0.0], [1.3, 1.0], [0.3, 1.0]];
        let corners: Vec<Point> = skew.iter().flat_map(|&[x, y]| [0.0, 1.0].map(|z| Point::new(x, y, z))).collect();
        assert!(cuboid(&Polytope::from_vertices(&corners).unwrap()).is_none());
    }

    #[test]
    fn flat_bodies_get_a_volume() {
        let body = Polytope::from_vertices(&[Point::new(0.0, 0.0, 1.0), Point::new(1.0, 0.0, 1.0)]).unwrap();
        let (geom, mesh) = geom(&body, "m");
        assert!(geom.to_string().contains("pos=\"0.5 0 1\""), "{geom}");
        assert_eq!(mesh.unwrap().to_string().matches("0.50005 ").count(), 8);
    }
}
