//! Two cables stay clear of each other during a translation of the platform.
//!
//! With u = p + arm_i - B_i (cable i as a vector), w = B_j - B_i and q = arm_j - arm_i, both constant, cable i runs
//! from B_i to B_i + u and cable j from B_i + w to B_i + u + q. They can meet only where u lies in the plane of w and
//! q: a plane of positions, which a straight motion passes at one instant. There u = α w + β q, and the cables cross
//! iff (α ≥ 1 and β ≥ 0) or (α ≤ 0 and β ≤ -1): two wedges whose edges (an end of one cable on the other) only touch.
//!
//! If w and q are parallel, the cables are coplanar at every position: with the same direction they meet only on the
//! line of the outlets, with opposite directions they always cross, so every motion is rejected, with a note. In the
//! paper's robot as laid out here, all pairs along an edge of the cube are parallel with the same direction. With a
//! clearance, the squared distance between two features (lines, ends) of the moving cables is a quotient of quadratics
//! in time, stationary at the roots of a quadratic. The paper's rule, disjoint swept triangles, is selectable
//! (`swept`); it is stricter, and rejects triangles that touch.
//!
//! The regions at a fixed orientation are those of S. Perreault, P. Cardou, C. Gosselin and M. Otis, "Geometric
//! determination of the interference-free constant-orientation workspace of parallel cable-driven mechanisms", Journal of
//! Mechanisms and Robotics 2, 2010.

use super::bodies::{Bodies, CableAt, Shapes};
use super::exempt::{Remarks, kept};
use super::fattened::Fattened;
use super::hanging_pair::HangingPair;
use super::instants::{both_positive_somewhere, instants_in_plane, stationary_points};
use super::physical::{Broken, Interference, Kind, PhysicalCondition};
use super::region::{Region, Scale, widened};
use crate::error::Error;
use crate::geometry::gjk::{nearer_than, shape_distance};
use crate::geometry::segment_segment::{self, SegmentPair};
use crate::geometry::{
    Aabb, Cuboid, HalfSpace, Placed, Point, Triangle, TriangleMesh, TurningPiece, Vector, farthest, proximity,
    wedge_mesh,
};
use crate::model::{Member, Scene};
use crate::tolerances::{NEARLY_PARALLEL, ON_SURFACE, PARALLEL, ROUNDING, TOUCH_DEPTH};
use crate::watch::Watch;

/// How many straight cables are tried to show that a pair is too near, if the cables can leave the frame at several points.
const EXITS_TRIED: usize = 6;

/// Two cables that share neither outlet nor attachment stay clear of each other.
#[derive(Debug, Clone, PartialEq)]
pub struct CableCable {
    /// Index of cable i.
    pub first: usize,
    /// Index of cable j.
    pub second: usize,
    /// Required distance between the cables' axes, m; 0 means only that they must not cross.
    pub gap: f64,
    /// Sum of the cables' radii, m.
    pub radii: f64,
    /// min over r in [0, 1] of |(1 - r) w + r q|, m: the largest distance that any position allows.
    pub best_gap: f64,
    /// Whether either cable can take several shapes.
    hangs: bool,
    /// Whether either cable leaves a pulley, so that a straight line from its outlet may not be one of its shapes.
    leaves_pulleys: bool,
    /// How much farther apart straight cables from the outlets must be than these shapes, at most, m.
    deviation: f64,
    /// What exits and sag add to the distance between points of the cables, per share of the way from attachment to outlet, m.
    spread: f64,
    /// arm_i - B_i, so that u = p + offset.
    offset: Vector,
    w: Vector,
    q: Vector,
    plane: Plane,
}

/// Relative orientation of w and q.
#[derive(Debug, Clone, PartialEq)]
enum Plane {
    /// w and q span a plane with this unit normal; sine of the angle between them.
    Spanned { normal: Vector, sine: f64 },
    /// w and q are parallel with the same direction: the cables meet only if both lie on the line of the outlets.
    Parallel,
    /// w and q are parallel with opposite directions: the cables always cross.
    Opposite,
}

impl CableCable {
    /// The condition on a pair, or `None` if the cables share an outlet or an attachment and thus touch by
    /// construction. The required distance includes as much of `clearance`, m, as the pair [can keep](super::exempt).
    pub fn new(cables: &[CableAt], first: usize, second: usize, clearance: f64) -> Option<Self> {
        let (i, j) = (&cables[first], &cables[second]);
        let (w, q) = (j.outlet - i.outlet, j.arm - i.arm);
        if w.norm() <= ON_SURFACE || q.norm() <= ON_SURFACE {
            return None;
        }
        let cross = w.cross(&q);
        let sine = cross.norm() / (w.norm() * q.norm());
        let plane = if sine > PARALLEL {
            Plane::Spanned { normal: cross.normalize(), sine }
        } else if w.dot(&q) > 0.0 {
            Plane::Parallel
        } else {
            Plane::Opposite
        };
        let origin = Point::origin();
        let best_gap = segment_segment::closest(&origin, &origin, &Point::from(w), &Point::from(q)).distance;
        let radii = i.radius + j.radius;
        let gap = kept(clearance, radii, best_gap);
        let offset = i.arm - i.outlet.coords;
        let sag = |cable: &CableAt| cable.envelope.as_ref().map_or(0.0, |e| e.deepest());
        let (exits, sag) = (i.exit_error() + j.exit_error(), sag(i).max(sag(j)));
        // The outline of a cable that hangs by σ leaves the attachment along tangents, four times as deep at the outlet.
        let (deviation, spread) = (exits + sag, exits + 4.0 * sag);
        let [hangs, leaves_pulleys] = [i.envelope.is_some() || j.envelope.is_some(), i.pulley.or(j.pulley).is_some()];
        Some(CableCable {
            first,
            second,
            gap,
            radii,
            best_gap,
            hangs,
            leaves_pulleys,
            deviation,
            spread,
            offset,
            w,
            q,
            plane,
        })
    }

    /// Whether the cables cross at every position of the platform.
    pub fn always_crossing(&self) -> bool {
        self.plane == Plane::Opposite && !self.leaves_pulleys
    }

    fn u(&self, position: &Point) -> Vector {
        position.coords + self.offset
    }

    /// Whether the cables cross at some instant of the motion.
    pub fn crosses(&self, from: &Point, to: &Point) -> bool {
        let (u0, u1) = (self.u(from), self.u(to));
        match &self.plane {
            Plane::Opposite => true,
            Plane::Parallel => self.overlaps_on_outlet_line(&u0, &u1),
            Plane::Spanned { normal, sine } => {
                let (s0, s1) = (normal.dot(&u0), normal.dot(&u1));
                let Some((t0, t1)) = instants_in_plane(s0, s1) else { return false };
                let at = |t: f64| self.coordinates(&(u0 + (u1 - u0) * t), normal);
                self.meets_wedge(at(t0), at(t1), *sine)
            }
        }
    }

    /// Whether the triangles that the cables sweep are further apart than `gap`, tested along one direction: the common
    /// normal of the cables' axes halfway. Rounding of this direction does no harm, since the gap along it is measured.
    pub fn sweeps_apart(&self, from: &Point, to: &Point, gap: f64) -> bool {
        let (u0, u1) = (self.u(from), self.u(to));
        let u = (u0 + u1) * 0.5;
        let normal = u.cross(&(u + self.q - self.w));
        let first = [0.0, normal.dot(&u0), normal.dot(&u1)];
        let second = [self.w, u0 + self.q, u1 + self.q].map(|corner| normal.dot(&corner));
        let low = |h: [f64; 3]| h[0].min(h[1]).min(h[2]);
        let high = |h: [f64; 3]| h[0].max(h[1]).max(h[2]);
        let room = (low(second) - high(first)).max(low(first) - high(second));
        room > gap * normal.norm() && room > 0.0
    }

    /// Two convex sets of positions; outside both, the cables neither cross nor come closer than the gap. `None` if
    /// rounding or the gap is too large to bound them.
    ///
    /// If points λ of cable i and μ < λ of cable j are nearer than g, then u = k (f + e) with f = (1 - μ) w + μ q and k = 1 /
    /// (λ - μ), so that k (1 - μ) >= 1. Straight cables from the outlets have |e| < g; to that, exits and sag add at most
    /// (1 - μ) times the spread s, since 1 - λ < 1 - μ. With u = α w + β q + ..., and ∇α and ∇β the gradients of these
    /// coordinates, let m = (g + s) ∇α + g ∇β. Then m·f = g + (1 - μ) s > |e|, and K = m / (1 - |m|) has K·u >= k (m·f - |m| |e|)
    /// / (1 - |m|) >= k |e|: what e adds to any linear function is at most K·u times the length of its gradient. That is a wedge
    /// of positions, as thick as it is far. For μ > λ, the cables change places: the same holds for -(u + q - w).
    pub fn wedges(&self) -> Option<[Vec<HalfSpace>; 2]> {
        let gap = self.gap + 2.0 * TOUCH_DEPTH;
        let at_outlets = gap + self.spread;
        let bounds: Vec<(Vector, f64)> = match &self.plane {
            Plane::Spanned { normal, sine } if *sine > NEARLY_PARALLEL => {
                let area = normal.dot(&self.w.cross(&self.q));
                let (alpha, beta) = (self.q.cross(normal) / area, normal.cross(&self.w) / area);
                let m = alpha * at_outlets + beta * gap;
                let thick = m / (1.0 - m.norm());
                let thin = |n: Vector| (n - thick, 0.0);
                let at_least = |n: Vector, bound: f64| (-(n + thick * n.norm()), -bound);
                let wedge = vec![thin(*normal), thin(-normal), at_least(alpha, 1.0), at_least(beta, 0.0)];
                (m.norm() < 1.0).then_some(wedge)?
            }
            // All f lie along the outlets' line except for what `aside` adds, so the wedges are four-sided cones around it.
            plane if *plane != Plane::Opposite && self.w.dot(&self.q) > 0.0 => {
                let line = self.w.normalize();
                let along = line.dot(&self.q);
                let aside = gap + (self.q - line * along).norm();
                // The bounds of f + e across and along the line are linear in μ, so that both ends decide.
                let (first, last) = (self.w.norm() - at_outlets, along - aside);
                let kappa = (at_outlets / first).max(aside / last);
                let across = any_normal(&line);
                let sides =
                    [across, -across, line.cross(&across), -line.cross(&across)].map(|n| (n - line * kappa, 0.0));
                let beyond = (-line * (1.0 + kappa), -self.w.norm());
                (first > 0.0 && last > 0.0).then(|| sides.into_iter().chain([beyond]).collect())?
            }
            _ => return None,
        };
        let placed = |sign: f64, by: &Vector| {
            let half_space = |(n, bound): &(Vector, f64)| {
                let (normal, length) = (n.normalize() * sign, n.norm());
                HalfSpace { normal, offset: bound / length }.moved(by)
            };
            bounds.iter().map(half_space).collect()
        };
        Some([placed(1.0, &-self.offset), placed(-1.0, &(self.w - self.q - self.offset))])
    }

    /// α and β of u = α w + β q, for u near the plane of w and q with this normal.
    fn coordinates(&self, u: &Vector, normal: &Vector) -> [f64; 2] {
        let area = normal.dot(&self.w.cross(&self.q));
        [normal.dot(&u.cross(&self.q)) / area, normal.dot(&self.w.cross(u)) / area]
    }

    /// Whether the straight line between two points of the plane enters either wedge by more than the touching depth.
    fn meets_wedge(&self, a: [f64; 2], b: [f64; 2], sine: f64) -> bool {
        // Distance from an edge of the wedge is the coordinate times the height of the parallelogram on that side.
        let (tip, outlet) = (TOUCH_DEPTH / (self.w.norm() * sine), TOUCH_DEPTH / (self.q.norm() * sine));
        let beyond = |x: [f64; 2]| [x[0] - 1.0 - tip, x[1] - outlet];
        let before = |x: [f64; 2]| [-x[0] - tip, -1.0 - x[1] - outlet];
        both_positive_somewhere(beyond(a), beyond(b)) || both_positive_somewhere(before(a), before(b))
    }

    /// For w and q of the same direction: whether both cables come to lie on the line of the outlets and overlap there.
    fn overlaps_on_outlet_line(&self, u0: &Vector, u1: &Vector) -> bool {
        let line = self.w.normalize();
        let aside = |u: &Vector| u - line * line.dot(u);
        let (a0, a1) = (aside(u0), aside(u1));
        let step = a1 - a0;
        let nearest =
            if step.norm_squared() > 0.0 { (-a0.dot(&step) / step.norm_squared()).clamp(0.0, 1.0) } else { 0.0 };
        if (a0 + step * nearest).norm() > TOUCH_DEPTH {
            return false;
        }
        let instants = if step.norm() <= TOUCH_DEPTH { [0.0, 1.0] } else { [nearest, nearest] };
        let (along, far, apart) = (|t: f64| line.dot(&(u0 + (u1 - u0) * t)), self.q.norm(), self.w.norm());
        // Cable i covers [0, x], cable j covers [apart, x + far]: overlap iff x > apart, or x + far < 0.
        instants.iter().any(|&t| along(t) > apart + TOUCH_DEPTH || along(t) + far < -TOUCH_DEPTH)
    }

    /// Closest points of the two cables at one position.
    pub fn nearest(&self, position: &Point) -> SegmentPair {
        let u = self.u(position);
        let at = Point::from;
        segment_segment::closest(&Point::origin(), &at(u), &at(self.w), &at(u + self.q))
    }

    /// Whether the cables come closer than the gap at some instant of the motion.
    pub fn nearer_than_gap(&self, from: &Point, to: &Point) -> bool {
        !(self.least_distance(from, to).0 >= self.gap - TOUCH_DEPTH)
    }

    /// Smallest distance between the cables' axes during a motion, m, and an instant at which it is attained.
    ///
    /// The distance has a continuous slope, so its minimum is at an end of the motion or where the distance of two
    /// features (line and line, end and line, end and end) is stationary. With v = u + q - w, the vector of cable j,
    /// each squared distance is a quotient of quadratics in time, because u × v = u × (q - w), (u - w) × v = (u - w) ×
    /// q, v × w = (u + q) × w and so on are linear. It is stationary at the roots of a quadratic; testing all of them
    /// is exact.
    pub fn least_distance(&self, from: &Point, to: &Point) -> (f64, f64) {
        if self.crosses(from, to) {
            return (0.0, 0.0);
        }
        let (u0, step, w, q) = (self.u(from), to - from, self.w, self.q);
        let (linear_u, linear_v) = (Linear(u0, step), Linear(u0 + q - w, step));
        let (u, v) = (linear_u.square(), linear_v.square());
        let across = q.cross(&w);
        let volume = Linear(Vector::x() * across.dot(&u0), Vector::x() * across.dot(&step));
        let quotients = [
            (volume.square(), linear_u.cross(&(q - w)).square()), // line and line
            (Linear(u0 - w, step).cross(&q).square(), v),         // attachment i and line j
            (linear_u.cross(&q).square(), u),                     // attachment j and line i
            (linear_u.cross(&w).square(), u),                     // outlet j and line i
            (Linear(u0 + q, step).cross(&w).square(), v),         // outlet i and line j
            (Linear(u0 - w, step).square(), [1.0, 0.0, 0.0]),     // attachment i and outlet j
            (Linear(u0 + q, step).square(), [1.0, 0.0, 0.0]),     // attachment j and outlet i
        ];
        let mut best = (self.nearest(from).distance, 0.0);
        if step == Vector::zeros() {
            return best;
        }
        let stationary = quotients.iter().flat_map(|(n, d)| stationary_points(n, d));
        for t in stationary.filter(|t| *t > 0.0 && *t < 1.0).chain([1.0]) {
            let distance = self.nearest(&(from + step * t)).distance;
            if distance < best.0 {
                best = (distance, t);
            }
        }
        best
    }
}

impl CableCable {
    /// The triangles that both cables sweep during a motion.
    #[inline]
    fn sweeps(&self, bodies: &Bodies, from: &Point, to: &Point) -> (Triangle, Triangle) {
        (bodies.cables[self.first].sweep(from, to), bodies.cables[self.second].sweep(from, to))
    }

    /// Both cables with all their shapes, if one of them has several.
    #[inline]
    fn hanging<'a>(&self, bodies: &'a Bodies) -> Option<HangingPair<'a>> {
        self.hangs.then(|| HangingPair { cables: [&bodies.cables[self.first], &bodies.cables[self.second]] })
    }

    /// Whether the second cable stays above the first by the required distance along a unit direction, if the direction is one
    /// (not NaN), while they hang at most this deep. It does if all four pairs of their ends do.
    #[inline]
    fn apart_along(&self, across: &Vector, depths: [f64; 2], bodies: &Bodies, piece: &TurningPiece) -> bool {
        let (i, j) = (&bodies.cables[self.first], &bodies.cables[self.second]);
        let height = |point: &Point| across.dot(&point.coords);
        let apart = |room: f64, sag: f64| room - sag > 0.0 && room - sag >= self.gap - TOUCH_DEPTH;
        let ([first_i, last_i], [first_j, last_j]) = (piece.points(&i.arm), piece.points(&j.arm));
        let at_i = [height(&first_i), height(&last_i)];
        let at_j = [height(&first_j), height(&last_j)];
        let share = piece.share_along(across);
        if self.hangs {
            let top = i.exits().iter().map(height).fold(f64::NEG_INFINITY, f64::max);
            let bottom = j.exits().iter().map(height).fold(f64::INFINITY, f64::min);
            let (corners_i, corners_j) = (i.outline(depths[0]), j.outline(depths[1]));
            let all = |(s, d): &(f64, Vector)| {
                corners_j.iter().all(|(r, e)| {
                    let below = across.dot(&(e - d));
                    let room = |k: usize| bottom * (1.0 - r) + at_j[k] * r - (top * (1.0 - s) + at_i[k] * s) + below;
                    apart(room(0).min(room(1)), piece.sag_of_sum(&(j.arm * *r - i.arm * *s), r - s, share))
                })
            };
            return corners_i.iter().all(all);
        }
        let (outlet_i, outlet_j) = (height(&i.outlet), height(&j.outlet));
        apart(outlet_j - outlet_i, 0.0)
            && apart(outlet_j - at_i[0].max(at_i[1]), piece.sag_along(&i.arm, share))
            && apart(at_j[0].min(at_j[1]) - outlet_i, piece.sag_along(&j.arm, share))
            && apart((at_j[0] - at_i[0]).min(at_j[1] - at_i[1]), piece.sag_of_sum(&(j.arm - i.arm), 0.0, share))
    }

    /// Whether the lines of two straight cables always keep the required distance, |u · (w × q)| / |u × v| for the vectors u and v of the
    /// cables, w from outlet to outlet and q from attachment to attachment.
    ///
    /// Between the ends of a piece, chords of u and q make u · (w × q) a quadratic in time, which deviates from its chord by at most a
    /// quarter of its leading coefficient; deviations from these chords change it by at most their product with the area that they meet.
    fn skew(&self, bodies: &Bodies, piece: &TurningPiece) -> bool {
        let (i, j) = (&bodies.cables[self.first], &bodies.cables[self.second]);
        let (w, arm) = (j.outlet - i.outlet, j.arm - i.arm);
        let u = piece.points(&i.arm).map(|end| end - i.outlet);
        let q = piece.ends.each_ref().map(|at| at.turned(&arm));
        let largest = |of: [Vector; 2]| of[0].norm().max(of[1].norm());
        let volume = |u: &Vector, q: &Vector| u.dot(&w.cross(q));
        let [first, last] = [0, 1].map(|k| volume(&u[k], &q[k]));
        let [off_i, off_j, off_q] = [piece.sag(&i.arm), piece.sag(&j.arm), piece.sag_of_sum(&arm, 0.0, 1.0)];
        let bent = 0.25 * volume(&(u[1] - u[0]), &(q[1] - q[0])).abs()
            + off_i * largest(q.map(|q| w.cross(&q)))
            + off_q * (largest(u.map(|u| u.cross(&w))) + off_i * w.norm());
        let longest_i = largest(u) + off_i;
        let longest_j = largest([0, 1].map(|k| u[k] + q[k] - w)) + off_j;
        let least = first.abs().min(last.abs()) - bent;
        first * last > 0.0 && least >= self.gap.max(TOUCH_DEPTH) * longest_i * longest_j
    }

    /// The outlets and attachments of both cables at a pose.
    #[inline]
    fn lines(&self, bodies: &Bodies, at: &Placed) -> [(Point, Point); 2] {
        let (i, j) = (&bodies.cables[self.first], &bodies.cables[self.second]);
        [(i.outlet, at.point(&i.arm)), (j.outlet, at.point(&j.arm))]
    }

    /// The distance between axes that the swept rule requires, m.
    #[inline]
    fn swept_gap(&self) -> f64 {
        self.gap.max(2.0 * TOUCH_DEPTH)
    }
}

impl PhysicalCondition for CableCable {
    fn all(scene: &Scene, bodies: &Bodies, first: usize, remarks: &mut Remarks, _: &Watch) -> Result<Vec<Self>, Error> {
        let mut all = Vec::new();
        for i in 0..bodies.cables.len() {
            for j in i + 1..bodies.cables.len() {
                let members = [Member::Cable(i), Member::Cable(j)];
                if scene.pairs().ignores(members[0], members[1]) {
                    continue;
                }
                let clearance = scene.pairs().clearance(members[0], members[1]);
                let Some(pair) = CableCable::new(&bodies.cables, i, j, clearance) else { continue };
                if pair.always_crossing() {
                    let [i, j] = members.map(|cable| bodies.name(cable));
                    remarks.notes.push(format!("{i} and {j} cross at every position"));
                } else {
                    let index = first + all.len();
                    remarks.exempt_if_unattainable(bodies, (index, members), [clearance, pair.radii, pair.best_gap]);
                }
                all.push(pair);
            }
        }
        Ok(all)
    }

    fn sentence(found: &Broken) -> String {
        found.meets(found.name(0), found.name(1))
    }

    fn kind(&self) -> Kind {
        Kind::CableCable
    }

    fn members(&self, _: &Bodies) -> Vec<Member> {
        vec![Member::Cable(self.first), Member::Cable(self.second)]
    }

    fn within_robot(&self) -> bool {
        true
    }

    fn required(&self, _: &Bodies) -> f64 {
        self.gap - self.radii
    }

    fn is_about_gap(&self, _: &Bodies) -> bool {
        true
    }

    fn distance(&self, bodies: &Bodies, from: &Point, to: &Point) -> f64 {
        let least = self.hanging(bodies).map_or_else(|| self.least_distance(from, to).0, |pair| pair.least(from, to));
        least - self.radii
    }

    fn shapes(&self, bodies: &Bodies, ends: &[Placed; 2]) -> Option<Shapes> {
        bodies.shapes_of(&[self.first, self.second], ends)
    }

    fn nearest_points(&self, bodies: &Bodies, position: &Point) -> Option<[Point; 2]> {
        let (i, j) = (&bodies.cables[self.first], &bodies.cables[self.second]);
        if let Some(pair) = self.hanging(bodies) {
            let (_, [on_i, on_j], axis) = pair.nearest(position);
            return Some([on_i + axis * i.radius, on_j - axis * j.radius]);
        }
        let pair = self.nearest(position);
        let along = |cable: &CableAt, share: f64| cable.outlet + (position + cable.arm - cable.outlet) * share;
        let axis = pair.offset.try_normalize(0.0).unwrap_or_else(Vector::zeros);
        Some([along(i, pair.s) + axis * i.radius, along(j, pair.r) - axis * j.radius])
    }

    fn worst_distance(&self, bodies: &Bodies, interference: Interference, from: &Point, to: &Point) -> Option<f64> {
        Some(match interference {
            Interference::Exact => self.distance(bodies, from, to),
            Interference::Swept => {
                // The triangles may meet at different times; this rule measures the gap between the triangles.
                let (first, second) = self.sweeps(bodies, from, to);
                shape_distance(&first, &second).distance - self.radii - self.deviation
            }
        })
    }

    /// Straight cables from any two points where the cables can leave the frame are among the shapes that must keep clear of each other.
    /// The vector between the points of two of them that are nearest to each other at the centre is a linear function of the position.
    /// The cables tried are those from the middle of the exits, then from points nearer to the other cable.
    fn forbids_all(&self, bodies: &Bodies, positions: &Cuboid, margin: f64) -> bool {
        if self.always_crossing() {
            return true;
        }
        let [i, j] = [self.first, self.second].map(|k| &bodies.cables[k]);
        let limit = self.gap + margin;
        let reach = 2.0 * (i.exit_error() + j.exit_error());
        let [mut exit_i, mut exit_j] = [i, j].map(CableAt::middle_exit);
        for _ in 0..EXITS_TRIED {
            let (u, w) = (self.u(&positions.center) + (i.outlet - exit_i), exit_j - exit_i);
            let at = Point::from;
            let SegmentPair { s, r, .. } = segment_segment::closest(&Point::origin(), &at(u), &at(w), &at(u + self.q));
            let between = u * s - (w + (u + self.q - w) * r);
            if (between.abs() + positions.half * (s - r).abs()).norm() <= limit {
                return true;
            }
            if reach == 0.0 || between.norm() > limit + reach {
                return false;
            }
            let [step_i, step_j] = [farthest(i.exits(), &-between) - exit_i, farthest(j.exits(), &between) - exit_j];
            let nearer = step_i * (1.0 - s) - step_j * (1.0 - r);
            let by = -between.dot(&nearer) / nearer.norm_squared();
            if !(by > 0.0) {
                return false;
            }
            (exit_i, exit_j) = (exit_i + step_i * by.min(1.0), exit_j + step_j * by.min(1.0));
        }
        false
    }

    /// With shares s and r along the cables, the squared distance of two points on them is a convex quadratic form. At the centre
    /// it exceeds its least value d² by at least λ|Δ|², with λ the smaller eigenvalue of its matrix and Δ the change of (s, r).
    /// Within ρ of the centre the vector between the points changes by at most ρ|s − r|. So the distance stays above
    /// √(d² + λ|Δ|²) − ρ(σ + √2|Δ|), with σ = |s − r| where they are nearest; the least of these is at least
    /// d √(1 − 2ρ²/λ) − ρσ. Where the attachments are nearest, σ is 0: they keep their distance wherever the platform is.
    fn allows_all(&self, bodies: &Bodies, positions: &Cuboid) -> bool {
        if let Some(pair) = self.hanging(bodies) {
            return pair.apart_over(self.swept_gap(), positions);
        }
        let rho = positions.half.norm();
        if self.slack(bodies, &positions.center) >= rho {
            return true;
        }
        let SegmentPair { distance, s, r, .. } = self.nearest(&positions.center);
        let u = self.u(&positions.center);
        let v = u + self.q - self.w;
        let (a, b, c) = (u.norm_squared(), v.norm_squared(), u.dot(&v));
        let least = 0.5 * (a + b - ((a - b).powi(2) + 4.0 * c * c).sqrt()) - ROUNDING * (a + b);
        let left = 1.0 - 2.0 * rho * rho / least;
        self.gap > 0.0 && left > 0.0 && distance * left.sqrt() - rho * (s - r).abs() >= self.gap - 0.5 * TOUCH_DEPTH
    }

    #[inline]
    fn breaks(&self, bodies: &Bodies, interference: Interference, from: &Point, to: &Point) -> bool {
        let swept = || {
            let (first, second) = self.sweeps(bodies, from, to);
            nearer_than(&first, &second, self.swept_gap() + self.deviation)
        };
        if let Some(pair) = self.hanging(bodies) {
            return match interference {
                Interference::Swept => swept(),
                Interference::Exact => !self.certainly_keeps(from, to) && pair.nearer_than(self.swept_gap(), from, to),
            };
        }
        self.crosses(from, to)
            || (interference == Interference::Swept && swept())
            || (interference == Interference::Exact && self.gap > 0.0 && self.nearer_than_gap(from, to))
    }

    fn slack_at(&self, bodies: &Bodies, at: &Placed) -> f64 {
        if self.hangs {
            let [a, b] = [self.first, self.second].map(|k| {
                let cable = &bodies.cables[k];
                let end = at.point(&cable.arm);
                cable.shapes(&end, cable.sag(&end, 0.0))
            });
            return shape_distance(&a, &b).signed() - self.swept_gap();
        }
        let [(a, p), (b, q)] = self.lines(bodies, at);
        segment_segment::closest(&a, &p, &b, &q).distance - self.gap
    }

    /// Along a fixed direction, the shortest way from one cable to the other halfway; or because the cables never lie in one plane.
    #[inline]
    fn kept_during_turn(&self, bodies: &Bodies, piece: &TurningPiece) -> bool {
        if self.hangs {
            // The length of the chord is a convex function of the attachment, so it is greatest at an end of the piece.
            let cables = [self.first, self.second].map(|k| &bodies.cables[k]);
            let depths = cables.map(|cable| {
                let sag = |end: &Point| cable.sag(end, piece.sag(&cable.arm));
                piece.points(&cable.arm).iter().map(sag).fold(0.0, f64::max)
            });
            let [a, b] = [0, 1].map(|k| cables[k].shapes(&piece.middle.point(&cables[k].arm), depths[k]));
            let axis = proximity(&a, &b, f64::INFINITY, 0.0).axis;
            return self.apart_along(&axis, depths, bodies, piece);
        }
        let [(a, p), (b, q)] = self.lines(bodies, &piece.middle);
        let nearest = segment_segment::closest(&a, &p, &b, &q).offset;
        nearest.norm() > TOUCH_DEPTH && self.apart_along(&nearest.normalize(), [0.0; 2], bodies, piece)
            || self.skew(bodies, piece)
    }

    /// The triangles may meet although no position in between is forbidden.
    fn exceeds_regions(&self, interference: Interference) -> bool {
        interference == Interference::Swept
    }

    #[inline]
    fn certainly_keeps(&self, from: &Point, to: &Point) -> bool {
        self.sweeps_apart(from, to, self.swept_gap() + self.deviation)
    }

    fn regions(&self, _: &Bodies, scale: &Scale, _: &Fattened) -> Vec<Region> {
        match self.wedges() {
            Some(wedges) => wedges.map(|wedge| Region::within(Some(widened(&wedge, scale.rounding)))).into(),
            None => vec![Region::within(None)],
        }
    }

    /// The known outer bounds on the crossings of two cables at a distance are loose.
    fn regions_are_loose(&self) -> bool {
        self.gap > 0.0 || self.hangs
    }

    /// Positions where the cables cross: with u = p + arm_i - B_i = α w + β q, where w is from outlet to outlet and q
    /// from attachment to attachment, α ≥ 1 and β ≥ 0, or α ≤ 0 and β ≤ -1. The set is flat, and has no area if w and q
    /// are parallel.
    fn surfaces(&self, bodies: &Bodies, by: &Vector, within: &Aabb) -> Option<Vec<TriangleMesh>> {
        let (i, j) = (&bodies.cables[self.first], &bodies.cables[self.second]);
        let (w, q) = (j.outlet - i.outlet, j.arm - i.arm);
        let origin = i.outlet - i.arm + by;
        let wedges = [(origin + w, [w, q]), (origin - q, [-w, -q])];
        Some(wedges.iter().filter_map(|(apex, sides)| wedge_mesh(apex, *sides, within)).collect())
    }
}

/// A unit vector perpendicular to the given unit vector.
fn any_normal(direction: &Vector) -> Vector {
    let axis = Vector::ith(direction.iamin(), 1.0);
    direction.cross(&axis).normalize()
}

/// A vector that is linear in time: value at 0, slope.
#[derive(Clone, Copy)]
struct Linear(Vector, Vector);

impl Linear {
    fn cross(self, fixed: &Vector) -> Linear {
        Linear(self.0.cross(fixed), self.1.cross(fixed))
    }

    /// Coefficients of the squared length, constant first.
    fn square(self) -> [f64; 3] {
        [self.0.norm_squared(), 2.0 * self.0.dot(&self.1), self.1.norm_squared()]
    }
}

#[cfg(test)]
mod tests;
