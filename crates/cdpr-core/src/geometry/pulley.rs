//! Pulleys: where a cable leaves its last pulley, its length and direction, and a polytope around all exit points.
//!
//! The wheel has radius r. The cable meets its groove at the outlet, running in the direction of the axis, and goes
//! round the wheel from there; the wheel swivels about the axis through the outlet, its centre always on the side of
//! the attachment. In the swivel plane, with ρ the distance from the axis and h the height along it above the outlet,
//! the wheel's centre is at (r, 0). After a wrap angle w
//!
//! - the exit is at r (1 - cos w, sin w), where the outward normal of the wheel is n = (-cos w, sin w), and
//! - the cable runs in direction t = (sin w, cos w) to the attachment (ρ, h) = exit + f t, f being the free length.
//!
//! Hence f² = ρ (ρ - 2r) + h². From h + f = 2 cos²(w/2) (r tan(w/2) + f) and ρ = tan(w/2) (h + f) follows
//! tan(w/2) = ρ / (h + f) = (f - h) / (ρ - 2r), of which one form has no cancellation. With w from 0 to π this covers
//! all attachments outside the wheel, except those below the outlet (h < 0) that are closer to the axis than 2r: there
//! the cable would pull the platform away from the axis.
//!
//! **Gradient.** With dn = t dw and dt = -n dw, the exit moves by r t dw and the attachment by d = r t dw + t df - f n
//! dw. So w changes by dw = -n·d / f, and the length r w + f by r dw + df = t·d. Swivelling does not change it, so its
//! gradient is t: minus the unit vector from the attachment to the exit.
//!
//! **Convexity.** Along any segment on which the cable can leave the wheel, its length is a convex function of the
//! attachment. Its Hessian in the swivel plane is that of t, which changes by -n dw = n (n·d) / f: it is n nᵀ / f.
//! Across the plane it is (∂length/∂ρ) / ρ = sin w / ρ >= 0. On the axis, where ρ = 0, the gradient is continuous.
//!
//! Source: A. Pott, *Influence of pulley kinematics on cable-driven parallel robots*, Latest Advances in Robot
//! Kinematics, 2012. The convexity and the bounds are ours.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::geometry::{Aabb, Point, Vector};
use crate::limits::MOST_WRAP_BOXES;
use crate::tolerances::{AXIS_IN_FACE, EXIT_EXCESS, MIN_CABLE_LENGTH, NEAR_AXIS, ROUNDING, WRAP_EXCESS};

/// The last pulley of a cable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pulley {
    /// Radius at which the cable runs, m; not negative.
    pub radius: f64,
    /// Unit vector about which the pulley swivels, world axes: the direction in which the cable arrives at the outlet.
    pub axis: Vector,
}

/// How a taut cable leaves its pulley.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Departure {
    /// Where the cable leaves the wheel, world, m.
    pub exit: Point,
    /// Unit vector in which the cable pulls at the attachment, world axes: towards the exit. The gradient of the length
    /// with respect to the attachment is its negative.
    pub pull: Vector,
    /// Distance from the exit to the attachment, m.
    pub free: f64,
    /// Angle that the cable touches the wheel, from the outlet on, rad; from 0 to π.
    pub wrap: f64,
    /// Length of the cable from the outlet to the attachment: radius times wrap, plus free length, m.
    pub length: f64,
}

impl Pulley {
    /// How the taut cable to `attachment` leaves this pulley at `outlet`, both in the world, m.
    ///
    /// `None` if it cannot: the attachment is inside the wheel or closer to the exit than [`MIN_CABLE_LENGTH`]; or it
    /// is below the outlet and closer to the axis than twice the radius, so that the wrap would exceed π. An attachment
    /// on the axis above the outlet has a straight cable.
    ///
    /// # Source
    /// Pott 2012; the formulas are at the head of this module.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{Point, geometry::Vector, geometry::Pulley};
    /// let pulley = Pulley { radius: 1.0, axis: Vector::z() };
    /// let cable = pulley.departure(&Point::origin(), &Point::new(0.0, 2.0, 2.0)).unwrap();
    /// assert!((cable.exit - Point::new(0.0, 0.4, 0.8)).norm() < 1e-12); // a 3-4-5 triangle
    /// assert!((cable.pull - Vector::new(0.0, -0.8, -0.6)).norm() < 1e-12);
    /// assert!((cable.length - (2.0 * 0.5_f64.atan() + 2.0)).abs() < 1e-12);
    /// ```
    pub fn departure(&self, outlet: &Point, attachment: &Point) -> Option<Departure> {
        let line = attachment - outlet;
        let height = self.axis.dot(&line);
        let across = line - height * self.axis;
        let distance = across.norm();
        let Tangent { free, half: [x, y] } = self.tangent([distance, height])?;
        if !(free >= MIN_CABLE_LENGTH) {
            return None;
        }
        // On the axis both components across it are zero.
        let side = if distance > 0.0 { across / distance } else { Vector::zeros() };
        let share = 1.0 / (x * x + y * y);
        let (sine, cosine, versine) = (2.0 * x * y * share, (x - y) * (x + y) * share, 2.0 * y * y * share);
        let exit = outlet + self.radius * (versine * side + sine * self.axis);
        let pull = -(sine * side + cosine * self.axis);
        let wrap = 2.0 * libm::atan2(y, x);
        Some(Departure { exit, pull, free, wrap, length: self.radius * wrap + free })
    }

    /// Second derivative of the length while the attachment moves with this velocity, as if it moved on a line, m/s². The length
    /// changes at the rate of minus the pull times the velocity.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{Point, geometry::Vector, geometry::Pulley};
    /// let pulley = Pulley { radius: 1.0, axis: Vector::z() };
    /// let (outlet, attachment) = (Point::origin(), Point::new(0.0, 3.0, 1.0)); // a quarter turn, and 2 m along y
    /// assert!((pulley.bend(&outlet, &attachment, &Vector::z()) - 1.0 / 2.0).abs() < 1e-12); // up, the wheel turns
    /// assert!((pulley.bend(&outlet, &attachment, &Vector::x()) - 1.0 / 3.0).abs() < 1e-12); // aside, it swivels
    /// ```
    pub fn bend(&self, outlet: &Point, attachment: &Point, velocity: &Vector) -> f64 {
        let Some(Departure { pull, free, .. }) = self.departure(outlet, attachment) else { return f64::NAN };
        let line = attachment - outlet;
        let across = line - self.axis.dot(&line) * self.axis;
        let distance = across.norm();
        if !(distance > 0.0) {
            return (velocity - pull * pull.dot(velocity)).norm_squared() / free;
        }
        let side = across / distance;
        let aside = self.axis.cross(&side);
        let (in_plane, swivel) = (aside.cross(&pull).dot(velocity), aside.dot(velocity));
        in_plane * in_plane / free - pull.dot(&side) * swivel * swivel / distance
    }

    /// Upper bound of the speed of the exit, per speed of the attachment, while the free length is at least `free` (m,
    /// positive), the distance of the attachment from the axis at least `from_axis` (m), and the wrap at most `wrap`
    /// (rad, up to π). With 0 for `from_axis` or π for `wrap` it holds without that condition.
    ///
    /// In the swivel plane the exit moves by r dw, with |dw| <= |d| / f, along t. Across the plane it is turned about
    /// the axis together with the attachment, so that it moves by the ratio of their distances from the axis, ρₑ/ρ.
    /// Both motions are orthogonal, and so are their causes; hence the larger of r/f and ρₑ/ρ is a bound. Two bounds of
    /// the ratio: ρₑ = r (1 - cos w) increases with w; and ρ = ρₑ + f sin w gives ρₑ/ρ = r tan(w/2) / (r tan(w/2) + f),
    /// which increases with w and decreases with f.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{geometry::Vector, geometry::Pulley};
    /// use std::f64::consts::PI;
    /// let pulley = Pulley { radius: 0.05, axis: Vector::z() };
    /// assert_eq!(pulley.exit_speed_bound(0.5, 2.0, PI), 0.1); // the wheel turns: 0.05 / 0.5
    /// assert_eq!(pulley.exit_speed_bound(5.0, 2.0, PI), 0.05); // it swivels: at most 0.1 from the axis, / 2.0
    /// ```
    pub fn exit_speed_bound(&self, free: f64, from_axis: f64, wrap: f64) -> f64 {
        let (sine, cosine) = libm::sincos(0.5 * wrap.clamp(0.0, PI));
        let by_free = self.radius * sine / (self.radius * sine + free * cosine);
        let by_distance = 2.0 * self.radius * sine * sine / from_axis;
        f64::max(self.radius / free, by_free.min(by_distance))
    }

    /// Points whose convex hull contains the exits of the cables to all attachments in a box that have a
    /// [`departure`](Self::departure), world, m; `None` if none has one, unless that is too close to tell.
    ///
    /// The hull also contains the exits of cables that leave the wheel up to `sag` (rad, not negative) before or after
    /// the taut one in the swivel plane, though never before the outlet. Beyond these exits it extends by
    /// [`EXIT_EXCESS`] of the radius in each direction of their surface, at most 16 % in total for arcs up to 90°, and
    /// by what [`WRAP_EXCESS`] adds. It may be flat or a single point.
    ///
    /// **Why they are inside.** The exits are ρ(w) e + h(w) a, with a the axis, w from an interval and e from an arc of
    /// the unit circle across the axis. In direction u + v a, u across the axis, let s be the maximum of u·e over the
    /// arc. As ρ >= 0, an exit reaches at most max over w of ρ(w) s + h(w) v, and that is at most ρₖ s + hₖ v for a
    /// corner (ρₖ, hₖ), extreme in direction (s, v), of any convex polygon around the profile. If s >= 0, this corner
    /// is on the outer side of the polygon, where a ring of points ρₖ eⱼ + hₖ a with the arc in the hull of the eⱼ
    /// reaches as far. If s < 0, it is on the inner side, the arc is shorter than π, and s is u·e at one of its ends
    /// (where a cosine is negative, it is convex), so that the two points at the ends of the arc reach as far. Corners
    /// on the inner side therefore need no more than these.
    ///
    /// To an attachment on the axis, a sagging cable may leave in any direction across it. If the box comes that close,
    /// its small wraps have a ring all around.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{Point, geometry::{Aabb, Polytope, Vector}, geometry::Pulley};
    /// let pulley = Pulley { radius: 0.05, axis: Vector::z() };
    /// let (outlet, room) = (Point::origin(), Aabb { min: Point::new(1., 1., -3.), max: Point::new(3., 4., -1.) });
    /// let exits = Polytope::hull_of(&pulley.exits(&outlet, &room, 0.0).unwrap())?;
    /// let exit = pulley.departure(&outlet, &Point::new(2.0, 2.0, -2.0)).unwrap().exit;
    /// assert!(exits.facets().iter().all(|facet| facet.height(&exit) < 1e-9));
    /// # Ok::<(), cdpr_core::geometry::PolytopeError>(())
    /// ```
    pub fn exits(&self, outlet: &Point, attachments: &Aabb, sag: f64) -> Option<Vec<Point>> {
        let frame = Frame::new(outlet, &self.axis);
        let view = frame.view(attachments);
        let [least, most] = self.wraps(&frame, attachments)?;
        let mut points = self.patch([(least - sag).max(0.0), (most + sag).min(TAU)], &view.swivel);
        let near_axis = self.wrap_on_wheel(NEAR_AXIS);
        if sag > 0.0 && view.distance[0] <= NEAR_AXIS && least <= near_axis {
            points.extend(self.patch([0.0, near_axis + sag], &Swivel::Around));
        }
        points.dedup();
        Some(points.iter().map(|point| frame.world(point)).collect())
    }

    /// Points (x, y, h) in the frame of the pulley whose hull contains the exits for intervals of wrap and swivel.
    fn patch(&self, [least, most]: [f64; 2], swivel: &Swivel) -> Vec<[f64; 3]> {
        let radius = self.radius;
        let profile = arc(least, most - least, 1.0 + EXIT_EXCESS);
        let mut points = Vec::new();
        for Corner { angle, factor, half } in profile {
            let (sine, cosine) = libm::sincos(angle);
            // Tangents from the outlet on intersect on the attachment's side of the axis.
            let [rho, height] = [(radius * (1.0 - factor * cosine)).max(0.0), radius * factor * sine];
            // The outward normals at a corner are those of the arc from angle - half to angle + half.
            let outer = half == 0.0 || (angle + half >= FRAC_PI_2 && angle - half <= 3.0 * FRAC_PI_2);
            let ring = swivel.ring(outer.then(|| 1.0 + EXIT_EXCESS * radius / rho.max(ROUNDING * radius)));
            match ring.first() {
                Some(_) if rho <= ROUNDING * radius => points.push([0.0, 0.0, height]),
                _ => points.extend(ring.iter().map(|[x, y]| [rho * x, rho * y, height])),
            }
        }
        points
    }

    /// Interval that contains the wraps of all attachments in a box, at most [`WRAP_EXCESS`] wider on each side if
    /// [`MOST_WRAP_BOXES`] parts suffice; `None` if no cable leaves the wheel.
    ///
    /// The distances and heights of a part are bounded by intervals, and [`wraps_within`](Self::wraps_within) is exact
    /// for these; parts that could extend what is attained are divided.
    fn wraps(&self, frame: &Frame, attachments: &Aabb) -> Option<[f64; 2]> {
        let mut attained = [f64::INFINITY, f64::NEG_INFINITY];
        let mut parts = Vec::new();
        let mut look = |part: Aabb, parts: &mut Vec<(Aabb, [f64; 2])>| {
            let view = frame.view(&part);
            parts.extend(self.wraps_within(view.distance, view.height).map(|range| (part, range)));
            for wrap in view.samples.iter().filter_map(|sample| Some(self.tangent(*sample)?.wrap())) {
                attained = [attained[0].min(wrap), attained[1].max(wrap)];
            }
            attained
        };
        let mut attained = look(*attachments, &mut parts);
        for _ in 1..MOST_WRAP_BOXES {
            let excess = |(_, range): &(Aabb, [f64; 2])| f64::max(attained[0] - range[0], range[1] - attained[1]);
            let worst = (0..parts.len()).max_by(|i, j| excess(&parts[*i]).total_cmp(&excess(&parts[*j])))?;
            if excess(&parts[worst]) <= WRAP_EXCESS {
                break;
            }
            for half in halves(&parts.swap_remove(worst).0) {
                attained = look(half, &mut parts);
            }
        }
        parts.into_iter().map(|(_, range)| range).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
    }

    /// Smallest and largest wrap of the attachments at distances and heights from two intervals; `None` if no cable
    /// leaves the wheel to any of them. If a part of the wheel hides the largest one, the bound is that of a larger
    /// set.
    ///
    /// The gradient of w is -n/f = (cos w, -sin w)/f, so w decreases with the height; from an attachment that a cable
    /// reaches, it also reaches all above. So the smallest wrap is on the upper side of the rectangle, the largest on
    /// its lower side, or where the wheel covers that, on the wheel. Along the upper side:
    ///
    /// - above the wheel (h >= r) w <= π/2, and w increases with the distance;
    /// - left of the wheel likewise; right of it w >= π/2, and w decreases. So the smallest wrap is at an end.
    ///
    /// Along the lower side and the wheel, w likewise increases up to the distance at which the wheel ends at this
    /// height (2r if this is below the outlet), and decreases from there.
    fn wraps_within(&self, distance: [f64; 2], height: [f64; 2]) -> Option<[f64; 2]> {
        let radius = self.radius;
        let wrap = |distance: f64, height: f64| Some(self.tangent([distance, height])?.wrap());
        let least = distance.iter().filter_map(|distance| wrap(*distance, height[1])).reduce(f64::min)?;
        let above = height[0].max(0.0);
        let turning = if above < radius { radius + ((radius - above) * (radius + above)).sqrt() } else { distance[1] };
        let farthest = turning.clamp(distance[0], distance[1]);
        Some([least, wrap(farthest, height[0]).unwrap_or_else(|| self.wrap_on_wheel(farthest))])
    }

    /// Wrap up to the point of the wheel at a distance from the axis: the largest up to this distance.
    fn wrap_on_wheel(&self, distance: f64) -> f64 {
        2.0 * libm::atan2(distance.sqrt(), (2.0 * self.radius - distance).max(0.0).sqrt())
    }

    /// The taut cable to an attachment at a distance from the axis and a height above the outlet; `None` if the
    /// attachment is inside the wheel, or the wrap exceeds π.
    fn tangent(&self, [distance, height]: [f64; 2]) -> Option<Tangent> {
        let beyond = distance - 2.0 * self.radius;
        let free_squared = distance * beyond + height * height;
        if !(free_squared >= 0.0) || (height < 0.0 && beyond < 0.0) {
            return None;
        }
        let free = free_squared.sqrt();
        let half = if height >= 0.0 { [height + free, distance] } else { [beyond, free - height] };
        Some(Tangent { free, half })
    }
}

/// A taut cable in the swivel plane.
struct Tangent {
    /// Free length, m.
    free: f64,
    /// A vector (x, y), at half the wrap angle from the x axis.
    half: [f64; 2],
}

impl Tangent {
    fn wrap(&self) -> f64 {
        2.0 * libm::atan2(self.half[1], self.half[0])
    }
}

/// Coordinates with the outlet as origin and the axis as third direction.
struct Frame {
    outlet: Point,
    directions: [Vector; 3],
}

/// What the axis sees of a box.
struct View {
    /// Interval of the distances from the axis, m.
    distance: [f64; 2],
    /// Interval of the heights above the outlet, m.
    height: [f64; 2],
    swivel: Swivel,
    /// Distance and height of some points of the box: its corners, and the point of each edge nearest to the axis.
    samples: [[f64; 2]; 20],
}

impl Frame {
    fn new(outlet: &Point, axis: &Vector) -> Self {
        let unit = Vector::ith(axis.iamin(), 1.0);
        let first = (unit - axis.dot(&unit) * axis).normalize();
        Frame { outlet: *outlet, directions: [first, axis.cross(&first), *axis] }
    }

    fn world(&self, [x, y, h]: &[f64; 3]) -> Point {
        self.outlet + *x * self.directions[0] + *y * self.directions[1] + *h * self.directions[2]
    }

    /// Intervals are widened by rounding.
    fn view(&self, of: &Aabb) -> View {
        let corner =
            |k: usize| Point::from(Vector::from_fn(|i, _| if k >> i & 1 == 1 { of.max[i] } else { of.min[i] }));
        let corners: [[f64; 3]; 8] =
            std::array::from_fn(|k| self.directions.map(|d| d.dot(&(corner(k) - self.outlet))));
        let rounding =
            ROUNDING * [of.min, of.max, self.outlet].map(|p| p.coords.amax()).into_iter().fold(0.0, f64::max);
        let mut samples = [[0.0; 2]; 20];
        for (sample, [x, y, h]) in samples.iter_mut().zip(&corners) {
            *sample = [libm::hypot(*x, *y), *h];
        }
        let edges = (0..3).flat_map(|i| (0..8).filter(move |k| k >> i & 1 == 0).map(move |k| [k, k | 1 << i]));
        for (sample, [a, b]) in samples[8..].iter_mut().zip(edges) {
            let [a, b] = [corners[a], corners[b]].map(Vector::from);
            let along = b - a;
            let squared = along.xy().norm_squared();
            let share = if squared > 0.0 { (-a.xy().dot(&along.xy()) / squared).clamp(0.0, 1.0) } else { 0.0 };
            let nearest = a + share * along;
            *sample = [nearest.xy().norm(), nearest.z];
        }
        let interval = |of: usize| {
            let values = || samples.iter().map(|sample| sample[of]);
            [values().fold(f64::INFINITY, f64::min) - rounding, values().fold(f64::NEG_INFINITY, f64::max) + rounding]
        };
        // Seen along the axis, the box is the hull of its corners, and bounded by edges.
        let off_axis = corners.iter().filter(|[x, y, _]| libm::hypot(*x, *y) > rounding);
        let swivel = Swivel::towards(off_axis.map(|[x, y, _]| libm::atan2(*y, *x)).collect());
        let [nearest, farthest] = interval(0);
        let nearest = if matches!(swivel, Swivel::Around) { 0.0 } else { nearest.max(0.0) };
        View { distance: [nearest, farthest], height: interval(1), swivel, samples }
    }
}

/// The two halves of a box across its longest side.
fn halves(whole: &Aabb) -> [Aabb; 2] {
    let longest = (whole.max - whole.min).imax();
    let middle = 0.5 * (whole.min[longest] + whole.max[longest]);
    let [mut low, mut high] = [*whole; 2];
    (low.max[longest], high.min[longest]) = (middle, middle);
    [low, high]
}

/// The directions across the axis to which the wheel swivels, rad.
enum Swivel {
    /// All of them.
    Around,
    /// Those from `start` on, over a width of at most π.
    Arc { start: f64, width: f64 },
}

impl Swivel {
    /// The directions from the origin to the hull of points in these directions, and perhaps of the origin.
    fn towards(mut angles: Vec<f64>) -> Self {
        angles.sort_unstable_by(f64::total_cmp);
        let next = |k: usize| if k + 1 < angles.len() { angles[k + 1] } else { angles[0] + TAU };
        let gaps = (0..angles.len()).map(|k| (next(k), next(k) - angles[k]));
        match gaps.max_by(|a, b| a.1.total_cmp(&b.1)) {
            Some((start, gap)) if gap >= PI - AXIS_IN_FACE => Swivel::Arc { start, width: (TAU - gap).max(0.0) },
            _ => Swivel::Around,
        }
    }

    /// Points of the plane whose hull contains these directions of the unit circle, at most at the distance `factor`;
    /// without it, the ends of the arc.
    fn ring(&self, factor: Option<f64>) -> Vec<[f64; 2]> {
        let place = |Corner { angle, factor, .. }: Corner| {
            let (sine, cosine) = libm::sincos(angle);
            [factor * cosine, factor * sine]
        };
        match (self, factor) {
            (Swivel::Arc { start, width }, Some(factor)) => {
                arc(*start, *width, factor).into_iter().map(place).collect()
            }
            (Swivel::Arc { start, width }, None) => {
                [*start, start + width].map(|angle| place(Corner { angle, factor: 1.0, half: 0.0 })).to_vec()
            }
            (Swivel::Around, Some(factor)) => {
                let corners = (TAU / step(factor)).ceil().max(3.0);
                let half = PI / corners;
                let corner = |k| Corner { angle: 2.0 * half * f64::from(k), factor: 1.0 / libm::cos(half), half };
                (0..corners as u32).map(|k| place(corner(k))).collect()
            }
            (Swivel::Around, None) => Vec::new(),
        }
    }
}

/// A corner of a polygon around an arc of the unit circle: its direction, its distance from the centre, and half the
/// angle between its tangents; zero for an end of the arc.
struct Corner {
    angle: f64,
    factor: f64,
    half: f64,
}

/// Points whose hull contains an arc of the unit circle: its ends, and the corners of the polyline of tangents between
/// them, at most at the distance `factor` from the centre. An arc that is straight up to rounding needs only its ends.
fn arc(start: f64, width: f64, factor: f64) -> Vec<Corner> {
    let end = |angle| Corner { angle, factor: 1.0, half: 0.0 };
    let tangents = if width * width > 8.0 * ROUNDING { (width / step(factor)).ceil() } else { 0.0 };
    let half = 0.5 * width / tangents;
    let between = (0..tangents as u32).map(|k| {
        let angle = start + half * f64::from(2 * k + 1);
        Corner { angle, factor: 1.0 / libm::cos(half), half }
    });
    let last = (width > 0.0).then(|| end(start + width));
    std::iter::once(end(start)).chain(between).chain(last).collect()
}

/// Angle between two tangents of the unit circle that meet at this distance from its centre, rad.
fn step(distance: f64) -> f64 {
    2.0 * libm::acos(1.0 / distance)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Polytope, distance};
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    const UPRIGHT: Pulley = Pulley { radius: 1.0, axis: Vector::new(0.0, 0.0, 1.0) };

    fn random_vector(rng: &mut ChaCha8Rng, size: f64) -> Vector {
        Vector::from_fn(|_, _| rng.random_range(-size..size))
    }

    /// A number between 10^low and 10^high.
    fn magnitude(rng: &mut ChaCha8Rng, low: f64, high: f64) -> f64 {
        10.0_f64.powf(rng.random_range(low..high))
    }

    /// A pulley with a radius from 1 µm to 10 m and its outlet, in every third case along a coordinate axis.
    fn random_pulley(rng: &mut ChaCha8Rng) -> (Pulley, Point) {
        let axis = match rng.random_range(0..6) {
            0 => Vector::z(),
            1 => -Vector::y(),
            _ => random_vector(rng, 1.0).normalize(),
        };
        (Pulley { radius: magnitude(rng, -6.0, 1.0), axis }, Point::from(random_vector(rng, 10.0)))
    }

    /// Where the attachment is after a wrap and a free length, in the direction `angle` about the axis.
    fn attachment(pulley: &Pulley, outlet: &Point, [wrap, free, angle]: [f64; 3]) -> Point {
        let (sine, cosine) = wrap.sin_cos();
        let [rho, height] = [pulley.radius * (1.0 - cosine) + free * sine, pulley.radius * sine + free * cosine];
        Frame::new(outlet, &pulley.axis).world(&[rho * angle.cos(), rho * angle.sin(), height])
    }

    fn departure(attachment: [f64; 3]) -> Option<[f64; 5]> {
        let Departure { exit, free, wrap, length, .. } =
            UPRIGHT.departure(&Point::origin(), &Point::from(attachment))?;
        Some([exit.x, exit.z, free, wrap, length])
    }

    #[test]
    fn quarter_half_and_no_turn_and_a_triangle_of_3_4_and_5() {
        let near = |found: Option<[f64; 5]>, right: [f64; 5]| {
            let found = found.unwrap();
            assert!(found.iter().zip(right).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?} {right:?}");
        };
        near(departure([3.0, 0.0, 1.0]), [1.0, 1.0, 2.0, FRAC_PI_2, FRAC_PI_2 + 2.0]);
        near(departure([2.0, 0.0, -7.0]), [2.0, 0.0, 7.0, PI, PI + 7.0]);
        near(departure([0.0, 0.0, 5.0]), [0.0, 0.0, 5.0, 0.0, 5.0]);
        let wrap = 0.8_f64.asin();
        near(departure([2.0, 0.0, 2.0]), [0.4, 0.8, 2.0, wrap, wrap + 2.0]);
        near(departure([3.0, 0.0, 0.5]), {
            let (wheel, free) = (0.25_f64.atan2(1.0) + (1.0_f64 / 4.25_f64.sqrt()).acos(), 3.25_f64.sqrt());
            [1.0 + wheel.cos(), wheel.sin(), free, PI - wheel, PI - wheel + free]
        });
    }

    #[test]
    fn no_cable_into_the_wheel_nor_below_the_outlet_near_the_axis() {
        for inside in [[1.0, 0.0, 0.0], [0.5, 0.0, 0.5], [0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 0.0, 1.0 + 1e-15]] {
            assert_eq!(departure(inside), None, "{inside:?}");
        }
        for below in [[0.0, 0.0, -1.0], [1.9, 0.0, -5.0], [f64::NAN, 0.0, 1.0], [1.0, 0.0, f64::NAN]] {
            assert_eq!(departure(below), None, "{below:?}");
        }
        assert!(departure([2.1, 0.0, -5.0]).is_some());
    }

    #[test]
    fn beside_the_axis_the_cable_is_that_on_the_axis() {
        let on = departure([0.0, 0.0, 5.0]).unwrap();
        for beside in [1e-300, 1e-17, 1e-12] {
            let found = departure([beside, 0.0, 5.0]).unwrap();
            assert!(found.iter().zip(on).all(|(a, b)| (a - b).abs() <= beside), "{found:?}");
        }
    }

    #[test]
    fn a_pulley_without_radius_is_a_fixed_outlet() {
        let (pulley, outlet) = (Pulley { radius: 0.0, axis: Vector::z() }, Point::new(1.0, 2.0, 3.0));
        let cable = pulley.departure(&outlet, &Point::new(1.0, 5.0, -1.0)).unwrap();
        assert_eq!((cable.exit, cable.free, cable.length), (outlet, 5.0, 5.0));
        assert!((cable.pull - Vector::new(0.0, -0.6, 0.8)).norm() < 1e-15);
        let room = Aabb { min: Point::new(-9.0, -9.0, -9.0), max: Point::new(9.0, 9.0, 2.0) };
        assert_eq!(pulley.exits(&outlet, &room, 0.1), Some(vec![outlet]));
    }

    #[test]
    fn wraps_and_free_lengths_come_back_from_the_attachments_that_they_cause() {
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        for _ in 0..100_000 {
            let (pulley, outlet) = random_pulley(&mut rng);
            let (wrap, free) = (rng.random_range(1e-4..PI - 1e-4), magnitude(&mut rng, -3.0, 3.0));
            let at = attachment(&pulley, &outlet, [wrap, free, rng.random_range(0.0..TAU)]);
            let cable = pulley.departure(&outlet, &at).unwrap();
            assert!((cable.length - (pulley.radius * wrap + free)).abs() < 1e-11, "{pulley:?} {cable:?}");
            assert!(
                (cable.free - free).abs() < 1e-9 && (cable.wrap - wrap).abs() < 1e-9,
                "{pulley:?} {wrap} {cable:?}"
            );
            assert!((cable.exit - at - cable.free * cable.pull).norm() < 1e-11, "{pulley:?} {cable:?}");
        }
    }

    #[test]
    fn lengths_agree_with_the_angles_of_centre_and_tangent() {
        let mut rng = ChaCha8Rng::seed_from_u64(2);
        let mut left = 0;
        for _ in 0..100_000 {
            let (pulley, outlet) = random_pulley(&mut rng);
            let size = magnitude(&mut rng, -1.0, 3.0);
            let at = outlet + random_vector(&mut rng, size);
            let Some(cable) = pulley.departure(&outlet, &at) else { continue };
            left += 1;
            let height = (at - outlet).dot(&pulley.axis);
            let rho = (at - outlet).cross(&pulley.axis).norm();
            let to_centre = (rho - pulley.radius).hypot(height);
            let wheel = height.atan2(rho - pulley.radius) + (pulley.radius / to_centre).acos();
            let free = to_centre * (1.0 - (pulley.radius / to_centre).powi(2)).sqrt();
            let length = pulley.radius * (PI - wheel).rem_euclid(TAU) + free;
            assert!((cable.length - length).abs() < 1e-9, "{pulley:?} {at} {cable:?} {length}");
        }
        assert!(left > 50_000, "{left}");
    }

    #[test]
    fn the_gradient_of_the_length_is_minus_the_pull() {
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        for _ in 0..10_000 {
            let (pulley, outlet) = random_pulley(&mut rng);
            let (wrap, free) = (rng.random_range(0.01..PI - 0.01), magnitude(&mut rng, -0.5, 1.0));
            let at = attachment(&pulley, &outlet, [wrap, free, rng.random_range(0.0..TAU)]);
            let length = |d: Vector| pulley.departure(&outlet, &(at + d)).unwrap().length;
            let step = 1e-5;
            let gradient = Vector::from_fn(|i, _| {
                let d = step * Vector::ith(i, 1.0);
                (length(d) - length(-d)) / (2.0 * step)
            });
            let pull = pulley.departure(&outlet, &at).unwrap().pull;
            assert!((gradient + pull).norm() < 1e-7, "{pulley:?} {wrap} {free} {gradient} {pull}");
        }
    }

    #[test]
    fn the_length_is_convex_along_segments_on_which_the_cable_can_leave_the_wheel() {
        let mut rng = ChaCha8Rng::seed_from_u64(4);
        let mut segments = 0;
        for _ in 0..20_000 {
            let (pulley, outlet) = random_pulley(&mut rng);
            let size = pulley.radius * magnitude(&mut rng, 0.0, 2.0);
            let [from, to] = [(); 2].map(|()| outlet + random_vector(&mut rng, size));
            let lengths: Option<Vec<f64>> = (0..=32)
                .map(|k| Some(pulley.departure(&outlet, &from.lerp(&to, f64::from(k) / 32.0))?.length))
                .collect();
            let Some(lengths) = lengths else { continue };
            segments += 1;
            let rounding = 1e-14 * (10.0 + size);
            let convex = lengths.windows(3).all(|l| l[0] + l[2] - 2.0 * l[1] > -rounding);
            assert!(convex, "{pulley:?} {from} {to} {lengths:?}");
        }
        assert!(segments > 5_000, "{segments}");
    }

    #[test]
    fn exits_move_no_faster_than_their_bound_which_is_nearly_attained() {
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        let mut loose: [Vec<f64>; 2] = Default::default();
        while loose[0].len() < 1000 {
            let (pulley, outlet) = random_pulley(&mut rng);
            let pulley = Pulley { radius: pulley.radius.max(1e-3), ..pulley };
            let size = pulley.radius * magnitude(&mut rng, 0.5, 2.5);
            let middle = outlet + random_vector(&mut rng, size);
            let near: Vec<Point> = (0..60).map(|_| middle + random_vector(&mut rng, 0.3 * size)).collect();
            let cables: Option<Vec<Departure>> = near.iter().map(|at| pulley.departure(&outlet, at)).collect();
            let Some(cables) = cables else { continue };
            let [mut free, mut from_axis, mut wrap, mut fastest] = [f64::INFINITY, f64::INFINITY, 0.0, 0.0];
            for (at, cable) in near.iter().zip(&cables) {
                let step = 1e-4 * cable.free.min((at - outlet).cross(&pulley.axis).norm());
                let mut directions: Vec<Vector> = (0..20).map(|_| random_vector(&mut rng, 1.0).normalize()).collect();
                directions.push(pulley.axis.cross(&cable.pull).normalize());
                directions.push(directions[20].cross(&cable.pull));
                for direction in directions {
                    let moved = at + step * direction;
                    let Some(other) = pulley.departure(&outlet, &moved) else { continue };
                    fastest = f64::max(fastest, (other.exit - cable.exit).norm() / step);
                    for (at, cable) in [(at, cable), (&moved, &other)] {
                        free = cable.free.min(free);
                        from_axis = (at - outlet).cross(&pulley.axis).norm().min(from_axis);
                        wrap = cable.wrap.max(wrap);
                    }
                }
            }
            for (loose, wrap) in loose.iter_mut().zip([wrap, PI]) {
                let bound = pulley.exit_speed_bound(free, from_axis, wrap);
                assert!(fastest <= bound * (1.0 + 1e-4) + 1e-9, "{pulley:?} {middle} {size} {fastest} {bound}");
                loose.push(bound / fastest);
            }
        }
        for loose in &mut loose {
            loose.sort_by(f64::total_cmp);
            assert!(loose[500] < 3.0, "{}", loose[500]);
        }
    }

    #[test]
    fn wraps_of_boxes_are_attained_up_to_their_excess() {
        let mut rng = ChaCha8Rng::seed_from_u64(8);
        let mut over: Vec<f64> = Vec::new();
        while over.len() < 300 {
            let (pulley, outlet) = random_pulley(&mut rng);
            let away = (pulley.radius * magnitude(&mut rng, 0.0, 4.0)).min(1e3);
            let middle = outlet + random_vector(&mut rng, away);
            let half = random_vector(&mut rng, 0.5 * away).abs();
            let frame = Frame::new(&outlet, &pulley.axis);
            let Some([least, most]) = pulley.wraps(&frame, &Aabb { min: middle - half, max: middle + half }) else {
                continue;
            };
            let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
            for k in 0..9_261 {
                let share = Vector::new((k % 21) as f64, (k / 21 % 21) as f64, (k / 441) as f64) * 0.1;
                let share = share.map(|share| share - 1.0);
                let Some(cable) = pulley.departure(&outlet, &(middle + half.component_mul(&share))) else { continue };
                (low, high) = (cable.wrap.min(low), cable.wrap.max(high));
            }
            if low.is_finite() {
                assert!(least <= low && high <= most, "{pulley:?} {least} {low} {high} {most}");
                over.push(f64::max(low - least, most - high));
            }
        }
        over.sort_by(f64::total_cmp);
        assert!(over[150] < WRAP_EXCESS, "{}", over[150]);
    }

    /// How far points are outside the hull of others, in radii: over facets, or in some directions if it is flat.
    fn outside(points: &[Point], pulley: &Pulley, outlet: &Point, exits: &[Point]) -> f64 {
        let scaled = |points: &[Point]| -> Vec<Point> {
            points.iter().map(|p| Point::from((p - outlet) / pulley.radius)).collect()
        };
        let (points, exits) = (scaled(points), scaled(exits));
        let mut rng = ChaCha8Rng::seed_from_u64(6);
        let normals: Vec<Vector> = match Polytope::hull_of(&points) {
            Ok(hull) if hull.dimension() == 3 => hull.facets().iter().map(|facet| facet.normal).collect(),
            _ => (0..60).map(|_| random_vector(&mut rng, 1.0).normalize()).collect(),
        };
        let reach = |points: &[Point], normal: &Vector| {
            points.iter().map(|p| normal.dot(&p.coords)).fold(f64::NEG_INFINITY, f64::max)
        };
        normals.iter().map(|normal| reach(&exits, normal) - reach(&points, normal)).fold(f64::NEG_INFINITY, f64::max)
    }

    #[test]
    fn every_exit_is_in_the_hull() {
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        let (mut boxes, mut corners, mut unhulled) = (0, Vec::new(), 0);
        for case in 0..6_000 {
            let (pulley, outlet) = random_pulley(&mut rng);
            // Sizes and distances from a thousandth of the radius, so that boxes touch the wheel, to 1 km.
            let away = (pulley.radius * magnitude(&mut rng, -3.0, 6.0)).min(1e3);
            let size = (away * magnitude(&mut rng, -4.0, 0.7)).min(1e3);
            let half = random_vector(&mut rng, size).abs();
            let middle = match case % 6 {
                0 => outlet + away * pulley.axis, // around the axis, with an edge or corner on it, with a face on it
                1 => outlet + away * pulley.axis + half,
                2 => outlet + away * pulley.axis + half.x * Vector::x(),
                _ => outlet + random_vector(&mut rng, away),
            };
            let room = Aabb { min: middle - half, max: middle + half };
            let sag = if case % 4 == 0 { 0.0 } else { rng.random_range(0.0..0.3) };
            let exits = pulley.exits(&outlet, &room, sag);
            let mut left = Vec::new();
            for k in 0..100 {
                // Every other sample is on an edge or at a corner.
                let share = Vector::from_fn(|_, _| {
                    let share: f64 = rng.random_range(-1.0..1.0);
                    if k % 2 == 0 { share } else { share.signum() * (1.5 * share.abs()).min(1.0) }
                });
                let at = (middle + share.component_mul(&half)).sup(&room.min).inf(&room.max);
                let Some(cable) = pulley.departure(&outlet, &at) else { continue };
                let wrap = (cable.wrap + sag * f64::from(rng.random_range(-1..=1))).max(0.0);
                let side = at - outlet - pulley.axis.dot(&(at - outlet)) * pulley.axis;
                let any = pulley.axis.cross(&random_vector(&mut rng, 1.0)).normalize(); // on the axis
                let side = side.try_normalize(1e-14 * (10.0 + away + size)).unwrap_or(any);
                left.push(outlet + pulley.radius * ((1.0 - wrap.cos()) * side + wrap.sin() * pulley.axis));
            }
            if left.is_empty() {
                continue;
            }
            boxes += 1;
            let points = exits.expect("there are exits");
            corners.push(points.len());
            unhulled += usize::from(Polytope::hull_of(&points).is_err());
            let height = outside(&points, &pulley, &outlet, &left);
            let rounding = 1e-9_f64.max(1e-13 * (10.0 + away + size) / pulley.radius);
            assert!(height <= rounding, "{case} {pulley:?} {outlet} {room:?} {sag} {height} {}", points.len());
        }
        corners.sort_unstable();
        assert!(boxes > 3_000 && unhulled * 1000 < boxes, "{boxes} {unhulled}");
        let [middle, most] = [corners[boxes / 2], corners[boxes - 1]];
        assert!(middle <= 12 && most <= 200, "{middle} {most}");
    }

    #[test]
    fn a_box_that_touches_the_axis_has_exits_only_on_its_side() {
        let corner = Aabb { min: Point::new(0.0, 0.0, 0.5), max: Point::new(5.0, 4.0, 3.0) };
        let face = Aabb { min: Point::new(0.0, -4.0, 0.5), ..corner };
        for (room, sag, beyond) in [(corner, 0.0, 1e-9), (face, 0.0, 1e-9), (corner, 0.1, 0.03), (face, 0.1, 0.03)] {
            let points = UPRIGHT.exits(&Point::origin(), &room, sag).unwrap();
            assert!(points.iter().all(|p| p.x > -beyond), "{points:?}");
            assert!(points.iter().any(|p| p.x > 0.5) && points.len() < 100, "{points:?}");
        }
        let around = Aabb { min: Point::new(-1e-3, -4.0, 0.5), ..corner };
        assert!(UPRIGHT.exits(&Point::origin(), &around, 0.0).unwrap().iter().any(|p| p.x < -0.5));
    }

    #[test]
    fn boxes_inside_the_wheel_or_below_the_outlet_have_no_exits() {
        let room = |min: [f64; 3], max: [f64; 3]| Aabb { min: Point::from(min), max: Point::from(max) };
        for none in [room([0.9, 0.0, 0.0], [1.1, 0.1, 0.1]), room([-1.0, -1.0, -5.0], [1.0, 1.0, -1e-3])] {
            assert_eq!(UPRIGHT.exits(&Point::origin(), &none, 0.1), None);
        }
        let point = room([2.0, 0.0, 2.0], [2.0, 0.0, 2.0]);
        let exits = UPRIGHT.exits(&Point::origin(), &point, 0.0).unwrap();
        assert!(exits.iter().all(|p| (p - Point::new(0.4, 0.0, 0.8)).norm() < 1e-12), "{exits:?}");
    }

    #[test]
    fn the_hull_exceeds_the_exits_by_a_few_hundredths_of_the_radius() {
        for (degrees, most) in [(90.0_f64, 44), (60.0, 30), (45.0, 20), (20.0, 12), (5.0, 9), (0.1, 9), (1e-6, 4)] {
            let width = degrees.to_radians();
            for first in [0.0, 0.5, 1.0, 1.5, 2.0, 2.5] {
                if first + width > PI {
                    continue;
                }
                let swivel = Swivel::Arc { start: 0.3, width };
                let points = UPRIGHT.patch([first, first + width], &swivel);
                let grid = |k: usize| width * (k % 40) as f64 / 39.0;
                let exits: Vec<Point> = (0..1600)
                    .map(|k| {
                        let (wrap, angle) = (first + grid(k), 0.3 + grid(k / 40));
                        let rho = 1.0 - wrap.cos();
                        Point::new(rho * angle.cos(), rho * angle.sin(), wrap.sin())
                    })
                    .collect();
                let hull = Polytope::hull_of(&exits).unwrap();
                let away = |p: &Point| distance(&Polytope::hull_of(&[*p]).unwrap(), &hull).distance;
                let excess = points.iter().map(|p| away(&Point::from(*p))).fold(0.0, f64::max);
                assert!(excess < 0.16, "{degrees} {first} {excess}");
                assert!(points.len() <= most, "{degrees} {first} {}", points.len());
            }
        }
    }
}
