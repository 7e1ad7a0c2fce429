//! Poses, and motions on which a body moves straight and turns at constant rates.

use nalgebra::{Matrix3, Quaternion};

use super::{ConvexShape, Point, Polytope, Rotation, SupportMap, Vector};
use crate::geometry::convex::polytope::farthest;
use crate::geometry::pairs::features::Boundary;
use crate::tolerances::{HALF_TURN, NO_TURN, ROUNDED_UNIT};

/// Position and orientation of the platform.
///
/// # Example
/// ```
/// use cdpr_core::{Point, Pose, Rotation, Vector};
/// let from = Pose::new(Point::origin(), Rotation::identity());
/// let to = Pose::new(Point::new(1.0, 0.0, 0.0), Rotation::from_scaled_axis(Vector::z()));
/// let middle = from.toward(&to).at(0.5);
/// assert_eq!(middle.position, Point::new(0.5, 0.0, 0.0));
/// assert!((middle.orientation.angle() - 0.5).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Position of the platform's origin, world, m.
    pub position: Point,
    /// Rotation from the platform frame to the world frame; both signs of the quaternion are the same rotation.
    pub orientation: Rotation,
}

impl Pose {
    /// The pose with this position and orientation.
    pub fn new(position: Point, orientation: Rotation) -> Self {
        Pose { position, orientation }
    }

    /// A point of the platform frame in the world.
    pub fn place(&self, point: &Point) -> Point {
        self.position + self.orientation * point.coords
    }

    /// Angle of the shorter turn to another orientation, rad, from 0 to π.
    pub fn angle_to(&self, other: &Pose) -> f64 {
        let turn = (other.orientation * self.orientation.inverse()).into_inner();
        2.0 * libm::atan2(turn.imag().norm(), turn.w.abs())
    }

    /// Whether all components of the pose are finite.
    pub fn is_finite(&self) -> bool {
        self.position.iter().chain(self.orientation.coords.iter()).all(|x| x.is_finite())
    }

    /// The motion to another pose: straight, with the shorter turn, both at constant rates.
    ///
    /// If the orientations differ by a half turn, the direction of the turn is always chosen in the same way, so that the motion
    /// back passes the same poses.
    pub fn toward(&self, other: &Pose) -> PoseMotion {
        let (a, b) = (signed(&self.orientation), signed(&other.orientation));
        let swapped = b.iter().partial_cmp(a.iter()) == Some(std::cmp::Ordering::Less);
        let (first, second) =
            if swapped { (&other.orientation, &self.orientation) } else { (&self.orientation, &other.orientation) };
        let turn = (second * first.inverse()).into_inner();
        let mut sine = turn.imag();
        if turn.w < -HALF_TURN {
            sine = -sine;
        } else if turn.w <= HALF_TURN && sine.iter().find(|x| x.abs() > HALF_TURN).is_some_and(|x| *x < 0.0) {
            sine = -sine; // either way round is a half turn
        }
        if swapped {
            sine = -sine;
        }
        let angle = 2.0 * libm::atan2(sine.norm(), turn.w.abs());
        let (axis, angle) = if angle > NO_TURN { (sine.normalize(), angle) } else { (Vector::x(), 0.0) };
        PoseMotion { from: *self, to: *other, axis, angle }
    }
}

/// The rotation by an angle, rad, about a unit axis. Unlike those of the standard library, the sine and cosine used
/// here have the same digits on every platform, so that the same seed gives the same path in a browser.
pub fn turn_about(axis: &Vector, angle: f64) -> Rotation {
    let (sine, cosine) = libm::sincos(0.5 * angle);
    Rotation::new_unchecked(Quaternion::from_parts(cosine, axis * sine))
}

/// The rotation by roll, pitch and yaw, rad: about x, then about y, then about z, all fixed axes. Like [`turn_about`], the
/// same on every platform.
pub fn from_roll_pitch_yaw(angles: [f64; 3]) -> Rotation {
    let [(sr, cr), (sp, cp), (sy, cy)] = angles.map(|angle| libm::sincos(0.5 * angle));
    Rotation::new_unchecked(Quaternion::new(
        cr * cp * cy + sr * sp * sy,
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
    ))
}

/// A rotation as the quaternion w x y z.
pub fn wxyz(rotation: &Rotation) -> [f64; 4] {
    [rotation.w, rotation.i, rotation.j, rotation.k]
}

/// Rotations as quaternions w x y z, with signs chosen so that their components change least from one to the next.
pub fn wxyz_in_turn<'a>(rotations: impl IntoIterator<Item = &'a Rotation>) -> Vec<[f64; 4]> {
    let mut found: Vec<[f64; 4]> = Vec::new();
    for rotation in rotations {
        let digits = wxyz(rotation);
        let jumps = found.last().is_some_and(|last| last.iter().zip(digits).map(|(a, b)| a * b).sum::<f64>() < 0.0);
        found.push(if jumps { digits.map(|x| -x) } else { digits });
    }
    found
}

/// The rotation of a quaternion w x y z of about unit length. If its length is 1 up to rounding, its digits are kept, so that a
/// pose is read back exactly as it was written. Otherwise a path that touches its limits could be valid when written and invalid
/// when read.
pub fn rotation_as_written([w, x, y, z]: [f64; 4]) -> Rotation {
    let quaternion = Quaternion::new(w, x, y, z);
    match (quaternion.norm() - 1.0).abs() <= ROUNDED_UNIT {
        true => Rotation::new_unchecked(quaternion),
        false => Rotation::from_quaternion(quaternion),
    }
}

/// A quaternion with the sign that makes its first component positive.
fn signed(rotation: &Rotation) -> [f64; 4] {
    let digits = wxyz(rotation);
    let first = digits.iter().find(|x| x.abs() > HALF_TURN).copied().unwrap_or(1.0);
    digits.map(|x| x * first.signum())
}

/// A motion between two poses: straight, turning about a fixed axis, both at constant rates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PoseMotion {
    /// Pose at the start of the motion.
    pub from: Pose,
    /// Pose at the end of the motion.
    pub to: Pose,
    /// Unit axis of the turn, world axes; arbitrary without a turn.
    pub axis: Vector,
    /// Angle of the turn, rad, from 0 to π.
    pub angle: f64,
}

impl PoseMotion {
    /// The pose at a fraction of the motion, 0 to 1.
    pub fn at(&self, t: f64) -> Pose {
        if t >= 1.0 { self.to } else { self.beyond(t) }
    }

    /// The pose at a fraction that may be larger than 1: beyond the end, at the same rates.
    pub fn beyond(&self, t: f64) -> Pose {
        let turned = turn_about(&self.axis, self.angle * t);
        Pose::new(self.from.position + (self.to.position - self.from.position) * t, turned * self.from.orientation)
    }

    /// The motion as seen by bodies that are given at the orientation `reference`.
    pub fn relative_to(&self, reference: &Rotation) -> Turning {
        let start = *(self.from.orientation * reference.inverse()).to_rotation_matrix().matrix();
        let cross = self.axis.cross_matrix();
        Turning {
            from: self.from.position,
            step: self.to.position - self.from.position,
            axis: self.axis,
            body_axis: start.tr_mul(&self.axis),
            angle: self.angle,
            series: [start, cross * start, cross * cross * start],
        }
    }
}

/// A pose of bodies that are given at some orientation of reference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placed {
    /// Position of the platform's origin, world, m.
    pub position: Point,
    /// Rotation from the orientation of reference.
    pub turn: Matrix3<f64>,
}

impl Placed {
    /// A pose of bodies that are given at the orientation `reference`.
    pub fn new(pose: &Pose, reference: &Rotation) -> Self {
        let turn = pose.orientation * reference.inverse();
        Placed { position: pose.position, turn: *turn.to_rotation_matrix().matrix() }
    }

    /// The orientation of reference at a position.
    pub fn translated(position: &Point) -> Self {
        Placed { position: *position, turn: Matrix3::identity() }
    }

    /// World position of a point of the platform.
    #[inline]
    pub fn point(&self, arm: &Vector) -> Point {
        self.position + self.turned(arm)
    }

    /// A vector of the platform in world axes.
    // Written out, since the product of the library is not inlined into hot loops.
    #[inline]
    pub fn turned(&self, v: &Vector) -> Vector {
        let m = &self.turn;
        let row = |k: usize| m[(k, 0)] * v.x + m[(k, 1)] * v.y + m[(k, 2)] * v.z;
        Vector::new(row(0), row(1), row(2))
    }

    /// A vector of the world in the axes of the platform.
    #[inline]
    pub fn turned_back(&self, v: &Vector) -> Vector {
        let m = &self.turn;
        let column = |k: usize| m[(0, k)] * v.x + m[(1, k)] * v.y + m[(2, k)] * v.z;
        Vector::new(column(0), column(1), column(2))
    }

    /// Position of a point of the world in the frame of the platform.
    #[inline]
    pub fn seen(&self, point: &Point) -> Point {
        Point::from(self.turned_back(&(point - self.position)))
    }
}

/// A [`PoseMotion`] of bodies that are given at some orientation of reference.
#[derive(Debug, Clone, Copy)]
pub struct Turning {
    from: Point,
    step: Vector,
    axis: Vector,
    body_axis: Vector,
    angle: f64,
    /// The turn is the sum of these with weights 1, sin and 1 - cos of the angle (Rodrigues).
    series: [Matrix3<f64>; 3],
}

impl Turning {
    /// The pose at a fraction of the motion.
    #[inline]
    pub fn at(&self, t: f64) -> Placed {
        let position = self.from + self.step * t;
        if self.angle == 0.0 {
            return Placed { position, turn: self.series[0] };
        }
        let (sine, cosine) = libm::sincos(self.angle * t);
        let turn = self.series[0] + self.series[1] * sine + self.series[2] * (1.0 - cosine);
        Placed { position, turn }
    }

    /// Whether the motion stays at one pose.
    pub fn is_still(&self) -> bool {
        self.angle == 0.0 && self.step == Vector::zeros()
    }

    /// The least cosine, during the motion, of the angle between a unit direction of the platform and where it points at the
    /// orientation of reference.
    pub fn least_along(&self, direction: &Vector) -> f64 {
        let [constant, sine, versine] = self.series.each_ref().map(|part| direction.dot(&(part * direction)));
        let at = |angle: f64| {
            let (s, c) = libm::sincos(angle);
            constant + sine * s + versine * (1.0 - c)
        };
        let still = libm::atan2(-sine, versine).rem_euclid(std::f64::consts::PI);
        [0.0, still, self.angle].into_iter().filter(|angle| *angle <= self.angle).map(at).fold(f64::INFINITY, f64::min)
    }

    /// The whole motion.
    pub fn whole(&self) -> TurningPiece {
        self.piece([0.0, 1.0], [self.at(0.0), self.at(1.0)])
    }

    /// Both halves of a piece of the motion.
    pub fn halves(&self, piece: &TurningPiece) -> [TurningPiece; 2] {
        let [low, high] = piece.during;
        let middle = 0.5 * (low + high);
        let [start, end] = piece.ends;
        [self.piece([low, middle], [start, piece.middle]), self.piece([middle, high], [piece.middle, end])]
    }

    fn piece(&self, during: [f64; 2], ends: [Placed; 2]) -> TurningPiece {
        let share = during[1] - during[0];
        TurningPiece {
            during,
            ends,
            middle: self.at(0.5 * (during[0] + during[1])),
            axis: self.axis,
            body_axis: self.body_axis,
            angle: self.angle * share,
            step: self.step * share,
            apart: Apart::default(),
        }
    }
}

/// How far two motions may differ at the same time. In the world, a vector a of the platform differs by at most `turned` |a|; in
/// the platform's frame, a vector of the world differs by as much.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Apart {
    /// Largest difference in the position of the platform's origin, m.
    pub position: f64,
    /// Largest difference of a unit vector of the platform, m/m.
    pub turned: f64,
}

impl Apart {
    /// Largest difference of a point within `reach`, m, of the platform's origin, m.
    #[inline]
    pub fn of(&self, reach: f64) -> f64 {
        self.position + self.turned * reach
    }

    /// Largest difference, m, of a point whose vector from the platform's origin is no longer than the longest of
    /// these, m. If the motions do not differ, no lengths are computed.
    #[inline]
    fn of_vectors(&self, vectors: &[Vector]) -> f64 {
        match *self == Apart::default() {
            true => 0.0,
            false => self.of(vectors.iter().map(Vector::norm).fold(0.0, f64::max)),
        }
    }
}

/// A piece of a [`Turning`], or all motions that stay within some distance of one.
///
/// A point of the platform at distance ρ from the axis is accelerated by θ² ρ (time from 0 to 1), at right angles to the axis;
/// so it stays within θ² ρ / 8 of the chord, at the same time. What [`Apart`] allows is added, in all directions.
#[derive(Debug, Clone, Copy)]
pub struct TurningPiece {
    /// The fractions of the motion between which the piece lies.
    pub during: [f64; 2],
    /// The poses at both ends of the piece.
    pub ends: [Placed; 2],
    /// The pose halfway through the piece.
    pub middle: Placed,
    /// Unit axis of the turn, world axes.
    pub axis: Vector,
    /// Unit axis of the turn, in the frame of the platform.
    pub body_axis: Vector,
    /// Angle of the turn, rad.
    pub angle: f64,
    /// The translation, m.
    pub step: Vector,
    /// How far the platform may be from this motion.
    pub apart: Apart,
}

impl TurningPiece {
    /// The motions that stay this close to the piece.
    pub fn within(self, apart: Apart) -> Self {
        TurningPiece { apart, ..self }
    }

    /// World positions of a point of the platform at both ends of the piece.
    // Here and in hot loops written out, since `map` of arrays is not always inlined.
    #[inline]
    pub fn points(&self, arm: &Vector) -> [Point; 2] {
        [self.ends[0].point(arm), self.ends[1].point(arm)]
    }

    /// The most by which a point of the platform deviates from its chord, m.
    #[inline]
    pub fn sag(&self, arm: &Vector) -> f64 {
        self.sag_along(arm, 1.0)
    }

    /// Largest deviation of a point of the platform from its chord, m, along a direction with this
    /// [share](TurningPiece::share_along).
    #[inline]
    pub fn sag_along(&self, arm: &Vector, share: f64) -> f64 {
        self.sag_of_sum(arm, 1.0, share)
    }

    /// Largest deviation from its chord of a weighted sum of points of the platform, m, along a direction with this
    /// [share](TurningPiece::share_along). `arm` is the weighted sum of their vectors from the platform's origin and `weight` that of their
    /// weights: 0 for the vector from one point to another, which does not depend on where the platform is.
    #[inline]
    pub fn sag_of_sum(&self, arm: &Vector, weight: f64, share: f64) -> f64 {
        let bent = 0.125 * self.angle * self.angle * across(arm, &self.body_axis);
        share * bent + Apart { position: self.apart.position * weight.abs(), ..self.apart }.of_vectors(&[*arm])
    }

    /// The most by which any point at a distance of at most `reach`, m, from the platform's origin deviates from its chord, m.
    #[inline]
    pub fn sag_within(&self, reach: f64) -> f64 {
        self.sag_within_along(reach, 1.0)
    }

    /// Largest deviation from its chord of any point within `reach`, m, of the platform's origin, m, along a direction
    /// with this [share](TurningPiece::share_along).
    #[inline]
    pub fn sag_within_along(&self, reach: f64, share: f64) -> f64 {
        0.125 * self.angle * self.angle * reach * share + self.apart.of(reach)
    }

    /// The share of deviations by the turn that counts along a unit direction of the world.
    #[inline]
    pub fn share_along(&self, direction: &Vector) -> f64 {
        across(direction, &self.axis)
    }

    /// The most by which a fixed point of the world deviates from its chord in the frame of the platform, m: there it is
    /// accelerated by θ² times its distance from the axis, and by 2 θ times the translation across the axis (Coriolis).
    #[inline]
    pub fn sag_seen(&self, point: &Point) -> f64 {
        self.sag_seen_along(point, 1.0)
    }

    /// Largest deviation of a fixed point of the world from its chord in the frame of the platform, m, along a
    /// direction of the platform whose component across the axis is `share`.
    #[inline]
    pub fn sag_seen_along(&self, point: &Point, share: f64) -> f64 {
        let lines = [point - self.ends[0].position, point - self.ends[1].position];
        let distance = across(&lines[0], &self.axis).max(across(&lines[1], &self.axis));
        let bent = 0.125 * self.angle * (self.angle * distance + 2.0 * across(&self.step, &self.axis));
        bent * share + self.apart.of_vectors(&lines)
    }

    /// Largest distance travelled by a point within `reach`, m, of the platform's origin, plus twice its largest deviation, m.
    /// The point is never farther than half of this from where it is at the nearer end of the piece.
    #[inline]
    pub fn travel(&self, reach: f64) -> f64 {
        self.step.norm() + self.angle * reach + 2.0 * self.apart.of(reach)
    }
}

/// Length of the component of a vector at right angles to a unit axis.
#[inline]
fn across(vector: &Vector, axis: &Vector) -> f64 {
    vector.cross(axis).norm()
}

/// The hull of a body at both ends of a piece of a motion.
#[derive(Debug, Clone, Copy)]
pub struct TurnedSweep<'a> {
    /// The body, at the orientation of reference.
    pub body: &'a Polytope,
    /// The poses at both ends.
    pub ends: &'a [Placed; 2],
}

impl SupportMap for TurnedSweep<'_> {
    #[inline]
    fn support(&self, direction: &Vector) -> Point {
        let [first, last] = &self.ends;
        let (a, b) = (support_at(self.body, first, direction), support_at(self.body, last, direction));
        if b.coords.dot(direction) > a.coords.dot(direction) { b } else { a }
    }

    fn center(&self) -> Point {
        let [a, b] = self.ends.each_ref().map(|end| end.point(&self.body.centroid().coords));
        nalgebra::center(&a, &b)
    }
}

/// The point of a body at a pose that is farthest along a direction.
#[inline]
fn support_at(body: &Polytope, at: &Placed, direction: &Vector) -> Point {
    at.point(&farthest(body.vertices(), &at.turned_back(direction)).coords)
}

/// A body at a pose.
#[derive(Debug, Clone, Copy)]
pub struct PlacedBody<'a> {
    /// The body, at the orientation of reference.
    pub body: &'a Polytope,
    /// The pose of the body.
    pub at: &'a Placed,
}

impl SupportMap for PlacedBody<'_> {
    #[inline]
    fn support(&self, direction: &Vector) -> Point {
        support_at(self.body, self.at, direction)
    }

    fn center(&self) -> Point {
        self.at.point(&self.body.centroid().coords)
    }
}

impl ConvexShape for PlacedBody<'_> {
    fn normals(&self) -> impl Iterator<Item = Vector> {
        self.body.normal_axes().iter().map(|normal| self.at.turned(normal))
    }

    fn edges(&self) -> impl Iterator<Item = Vector> + Clone {
        self.body.edge_axes().iter().map(|edge| self.at.turned(edge))
    }

    fn boundary(&self) -> Boundary {
        let Boundary { edges, faces } = self.body.boundary();
        let moved = |corner: &Point| self.at.point(&corner.coords);
        Boundary {
            edges: edges.iter().map(|edge| edge.each_ref().map(moved)).collect(),
            faces: faces.iter().map(|face| face.iter().map(moved).collect()).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotations_are_those_of_nalgebra() {
        for angles in [[0.3, -1.2, 2.9], [0.0, 0.0, 0.5 * std::f64::consts::PI], [-3.0, 1.6, 0.0]] {
            let [roll, pitch, yaw] = angles;
            let expected = Rotation::from_euler_angles(roll, pitch, yaw);
            assert!((from_roll_pitch_yaw(angles).coords - expected.coords).norm() < 1e-15);
            let axis = Vector::new(roll, pitch, yaw).normalize();
            assert!((turn_about(&axis, yaw).coords - Rotation::from_scaled_axis(axis * yaw).coords).norm() < 1e-15);
        }
    }
}
