//! The set of forces, or of moments, that the cables can exert at a position, as a surface for display (the paper,
//! Figure 4b).
//!
//! Both are zonotopes in three dimensions: a centre plus half-generators ±hᵢ, one for each direction of cables. A
//! corner is a bit pattern of signs, and a facet is spanned by the half-generators orthogonal to its normal. Corners
//! are therefore found and matched by their bit patterns, without comparing coordinates.

use std::collections::BTreeMap;

use super::margins::{BindingFacet, force_limit, moment_limit};
use crate::error::Error;
use crate::geometry::{Point, Polytope, TriangleMesh, Vector};
use crate::limits::SET_CABLES;
use crate::tolerances::DEPENDENT;
use crate::wrench::statics::{StaticCable, Statics};
use crate::wrench::zonotope::Span;

/// The available wrench set reduced to three dimensions, and the points of interest in it.
#[derive(Debug, Clone, PartialEq)]
pub struct AvailableSet {
    /// Dimension of the set, 0 to 3.
    pub rank: usize,
    /// Surface of the set, triangles counter-clockwise seen from outside; coordinates in N for forces, N·m for moments,
    /// not m.
    ///
    /// A set of rank 3 has a closed surface; one of rank 2 is a two-sided polygon, closed as well, but without
    /// volume; one of rank 1 is a segment, with two ends and no triangle; one of rank 0 is a single point.
    pub mesh: TriangleMesh,
    /// The force (moment) that balances the loads, N (N·m).
    pub balance: Vector,
    /// Signed distance from `balance` to the boundary, N (N·m): the force (moment) margin. Negative outside.
    pub margin: f64,
}

impl AvailableSet {
    /// The largest ball in the set around the balancing force (moment), as centre and radius; `None` if that is
    /// outside, and for a flat set, which contains no ball.
    pub fn ball(&self) -> Option<(Vector, f64)> {
        (self.margin > 0.0).then_some((self.balance, self.margin))
    }
}

/// The forces that the cables can exert at a position, regardless of the moment.
///
/// Any number of cables is allowed, as long as their forces point in at most [`SET_CABLES`] directions.
///
/// # Errors
/// A position where a cable has no direction; too many directions; a surface that does not close because of rounding.
///
/// # Source
/// The paper, section 3.3 and Figure 4b; its sphere is [`AvailableSet::ball`].
///
/// # Example
/// ```
/// use cdpr_core::{Point, testing, wrench::{Statics, force_set}};
/// let statics = Statics::of(&testing::empty())?;
/// let set = force_set(&statics, &Point::new(1.0, 1.0, 1.0))?; // in the middle of the cube: four directions, both ways
/// assert_eq!((set.rank, set.mesh.vertices.len()), (3, 14)); // a rhombic dodecahedron
/// let (center, radius) = set.ball().expect("it can bear its weight");
/// assert!((center.z - 98.1).abs() < 1e-12 && radius > 0.0);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn force_set(statics: &Statics, position: &Point) -> Result<AvailableSet, Error> {
    let columns = with_direction(statics, position)?;
    let forces: Vec<Vector> = columns.iter().map(|w| w.fixed_rows::<3>(0).into()).collect();
    let limit = force_limit(statics, position).ok_or_else(no_margin)?;
    available_set(statics, &forces, statics.balance().fixed_rows::<3>(0).into(), &limit)
}

/// The moments about the platform's origin that the cables can exert at a position, regardless of the force, N·m.
///
/// # Errors
/// The errors of [`force_set`]; a point mass, which has no moments.
pub fn moment_set(statics: &Statics, position: &Point) -> Result<AvailableSet, Error> {
    if statics.point_mass() {
        let problem = "found a platform whose attachments coincide, expected one that cables can rotate";
        return Err(Error::invalid("robot", problem));
    }
    let length = statics.characteristic_length();
    let columns = with_direction(statics, position)?;
    let moments: Vec<Vector> = columns.iter().map(|w| w.fixed_rows::<3>(3) * length).collect();
    let limit = moment_limit(statics, position).ok_or_else(no_margin)?;
    available_set(statics, &moments, statics.balance().fixed_rows::<3>(3) * length, &limit)
}

fn no_margin() -> Error {
    Error::invalid("position", "found no margin there")
}

/// The columns of the wrench matrix; the error names a cable without direction.
fn with_direction(statics: &Statics, position: &Point) -> Result<Vec<nalgebra::Vector6<f64>>, Error> {
    statics.columns(position).ok_or_else(|| {
        let length = statics.characteristic_length();
        let lost = |cable: &&StaticCable| !cable.column(position, length).x.is_finite();
        let name = statics.cables().iter().find(lost).map_or("cable", |cable| &cable.name);
        let problem = format!("found [{}, {}, {}], where {name} has no direction", position.x, position.y, position.z);
        Error::invalid("position", problem)
    })
}

fn available_set(
    statics: &Statics,
    generators: &[Vector],
    balance: Vector,
    limit: &BindingFacet<3>,
) -> Result<AvailableSet, Error> {
    let limits: Vec<[f64; 2]> = statics.cables().iter().map(|cable| cable.tension).collect();
    let set = Zonotope::new(generators, &limits)?;
    let (rank, mesh) = set.surface()?;
    Ok(AvailableSet { rank, mesh, balance, margin: limit.margin })
}

/// {centre + Σ sᵢ hᵢ : −1 ≤ sᵢ ≤ 1} with nonzero h, no two of which are parallel.
struct Zonotope {
    middle: Vector,
    halves: Vec<Vector>,
}

/// A corner: bit i is set if sᵢ is 1 rather than −1.
type Corner = u64;

impl Zonotope {
    /// The set {Σ tᵢ gᵢ : t within limits}; generators that are negligible compared with the longest are dropped,
    /// parallel ones are combined.
    fn new(generators: &[Vector], limits: &[[f64; 2]]) -> Result<Self, Error> {
        let each = || generators.iter().zip(limits);
        let middle = each().map(|(g, [least, greatest])| g * (0.5 * (least + greatest))).sum();
        let all: Vec<Vector> = each().map(|(g, [least, greatest])| g * (0.5 * (greatest - least))).collect();
        let longest = all.iter().map(Vector::norm).fold(0.0, f64::max);
        let mut halves: Vec<Vector> = Vec::new();
        for half in all.into_iter().filter(|half| half.norm() > DEPENDENT * longest) {
            let along = |h: &&mut Vector| h.cross(&half).norm() <= DEPENDENT * h.norm() * half.norm();
            match halves.iter_mut().find(along) {
                Some(own) => *own += half * own.dot(&half).signum(),
                None => halves.push(half),
            }
        }
        if halves.len() > SET_CABLES {
            let problem = format!("found {} directions, expected at most {SET_CABLES}", halves.len());
            return Err(Error::invalid("robot.cables", problem));
        }
        Ok(Zonotope { middle, halves })
    }

    /// Rank and surface.
    fn surface(&self) -> Result<(usize, TriangleMesh), Error> {
        let span = Span::of(&self.halves);
        let all: Vec<usize> = (0..self.halves.len()).collect();
        let mesh = match (span.rank(), span.left_null()) {
            (3, _) => self.solid()?,
            (2, [normal, ..]) => {
                let ring = self.ring(&all, normal);
                let back = ring.iter().rev().copied().collect();
                self.mesh(&[ring, back])
            }
            (1, [across, other, ..]) => {
                let axis = across.cross(other);
                let ends = [1.0, -1.0].map(|sign| self.position(self.farthest(&(axis * sign))));
                TriangleMesh { vertices: ends.to_vec(), triangles: Vec::new() }
            }
            _ => TriangleMesh { vertices: vec![self.position(0)], triangles: Vec::new() },
        };
        Ok((span.rank(), mesh))
    }

    /// The closed surface of a set of rank 3.
    fn solid(&self) -> Result<TriangleMesh, Error> {
        let mut rings = Vec::new();
        for i in 0..self.halves.len() {
            for j in i + 1..self.halves.len() {
                let normal = self.halves[i].cross(&self.halves[j]).normalize();
                let spanning = self.spanning(&normal, [i, j]);
                if spanning[..2] == [i, j] {
                    rings.extend([normal, -normal].map(|normal| self.ring(&spanning, &normal)));
                }
            }
        }
        let mesh = self.mesh(&rings);
        if mesh.is_watertight() { Ok(mesh) } else { self.hull(&mesh) }
    }

    /// The half-generators that span the facet with this normal, in order; the two that define it always belong.
    fn spanning(&self, normal: &Vector, given: [usize; 2]) -> Vec<usize> {
        let level = |k: &usize| self.halves[*k].dot(normal).abs() <= DEPENDENT * self.halves[*k].norm();
        (0..self.halves.len()).filter(|k| given.contains(k) || level(k)).collect()
    }

    /// The corners of the facet spanned by these half-generators, counter-clockwise seen from the tip of its normal:
    /// starting at the corner that is lowest along one direction, the half-generators are added by angle, and then
    /// subtracted.
    fn ring(&self, spanning: &[usize], normal: &Vector) -> Vec<Corner> {
        let mut corner = self.farthest(normal);
        let u = self.halves[spanning[0]].normalize();
        let v = normal.cross(&u);
        let mut turned: Vec<(f64, Corner)> = Vec::with_capacity(spanning.len());
        for &k in spanning {
            let (x, y, bit) = (self.halves[k].dot(&u), self.halves[k].dot(&v), 1 << k);
            let backward = y < 0.0 || (y == 0.0 && x < 0.0);
            corner = if backward { corner | bit } else { corner & !bit };
            turned.push((if backward { (-y).atan2(-x) } else { y.atan2(x) }, bit));
        }
        turned.sort_by(|a, b| a.0.total_cmp(&b.0));
        let walk = turned.iter().chain(&turned);
        walk.map(|(_, bit)| {
            let here = corner;
            corner ^= bit;
            here
        })
        .collect()
    }

    /// A corner that is farthest along a direction.
    fn farthest(&self, direction: &Vector) -> Corner {
        let bit = |(k, half): (usize, &Vector)| Corner::from(half.dot(direction) > 0.0) << k;
        self.halves.iter().enumerate().map(bit).sum()
    }

    fn position(&self, corner: Corner) -> Point {
        let signed = |(k, half): (usize, &Vector)| if corner >> k & 1 == 1 { *half } else { -half };
        Point::from(self.middle + self.halves.iter().enumerate().map(signed).sum::<Vector>())
    }

    /// The surface of these facets; equal corners become one vertex.
    fn mesh(&self, rings: &[Vec<Corner>]) -> TriangleMesh {
        let (mut places, mut vertices) = (BTreeMap::new(), Vec::new());
        let mut place = |corner: &Corner| {
            *places.entry(*corner).or_insert_with(|| {
                vertices.push(self.position(*corner));
                vertices.len() - 1
            })
        };
        let faces: Vec<Vec<usize>> = rings.iter().map(|ring| ring.iter().map(&mut place).collect()).collect();
        TriangleMesh::of_faces(vertices, &faces)
    }

    /// The hull of the corners, for sets with nearly dependent half-generators, which rounding classifies
    /// differently from facet to facet.
    fn hull(&self, open: &TriangleMesh) -> Result<TriangleMesh, Error> {
        let size = self.halves.iter().map(Vector::norm).sum::<f64>(); // tolerances of hulls are absolute
        let even: Vec<Point> = open.vertices.iter().map(|p| Point::from((p.coords - self.middle) / size)).collect();
        let problem = |e| Error::invalid("position", format!("found a set without closed surface there: {e}"));
        let body = Polytope::hull_of(&even).map_err(problem)?;
        let vertices = body.vertices().iter().map(|p| Point::from(p.coords * size + self.middle)).collect();
        let faces: Vec<Vec<usize>> = body.facets().iter().map(|facet| facet.corners.clone()).collect();
        Ok(TriangleMesh::of_faces(vertices, &faces))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn zonotope(generators: &[[f64; 3]]) -> (usize, TriangleMesh) {
        let generators: Vec<Vector> = generators.iter().map(|g| Vector::from(*g)).collect();
        let limits = vec![[0.0, 1.0]; generators.len()];
        Zonotope::new(&generators, &limits).unwrap().surface().unwrap()
    }

    #[test]
    fn three_axes_span_a_cube_and_parallel_ones_make_it_longer() {
        let (rank, cube) = zonotope(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        assert_eq!((rank, cube.vertices.len(), cube.triangles.len()), (3, 8, 12));
        assert!(cube.is_watertight() && cube.volume() == 1.0);
        let (_, longer) = zonotope(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -2.0], [0.0; 3]]);
        assert!(longer.is_watertight() && longer.vertices.len() == 8 && longer.volume() == 3.0);
        assert!(longer.vertices.iter().all(|p| (-2.0..=1.0).contains(&p.z)));
    }

    #[test]
    fn coplanar_generators_share_a_facet() {
        // A hexagonal prism: three directions in a plane and one across.
        let (s, c) = (60f64.to_radians().sin(), 0.5);
        let (_, prism) = zonotope(&[[1.0, 0.0, 0.0], [c, s, 0.0], [-c, s, 0.0], [0.0, 0.0, 1.0]]);
        assert_eq!((prism.vertices.len(), prism.triangles.len()), (12, 2 * 4 + 6 * 2));
        assert!(prism.is_watertight() && (prism.volume() - 3.0 * s).abs() < 1e-15);
    }

    #[test]
    fn flat_sets_are_a_polygon_with_two_sides_a_segment_or_a_point() {
        let (rank, flat) = zonotope(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]]);
        assert_eq!((rank, flat.vertices.len(), flat.triangles.len()), (2, 6, 8));
        assert!(flat.is_watertight() && flat.volume() == 0.0 && (flat.area() - 2.0 * 3.0).abs() < 1e-15);
        let (rank, segment) = zonotope(&[[1.0, 2.0, 2.0], [-2.0, -4.0, -4.0]]);
        assert_eq!((rank, segment.triangles.len()), (1, 0));
        assert!(((segment.vertices[1] - segment.vertices[0]).norm() - 9.0).abs() < 1e-14);
        let (rank, point) = zonotope(&[[0.0; 3]]);
        assert_eq!((rank, point.vertices, point.triangles.len()), (0, vec![Point::origin()], 0));
    }

    #[test]
    fn nearly_dependent_directions_give_a_closed_surface() {
        // Tilts near the tolerance, at which directions are in one plane for one pair but not for another.
        for k in 0..200 {
            let tilt = |n: i32| f64::from((k * 7 + n * n * 13) % 41 - 20) * 0.2 * DEPENDENT;
            let direction = |n: i32| {
                let (sin, cos) = (f64::from(n) * 0.4).sin_cos();
                [cos, sin, tilt(n)]
            };
            let generators: Vec<[f64; 3]> = (0..6).map(direction).chain([[0.1, 0.2, 1.0]]).collect();
            let (rank, mesh) = zonotope(&generators);
            assert!(rank == 3 && mesh.is_watertight(), "{k}");
        }
    }
}
