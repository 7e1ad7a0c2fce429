//! A polytope around all points where a cable can leave its pulley.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::Pulley;
use crate::geometry::{Aabb, Point, Vector};
use crate::limits::MOST_WRAP_BOXES;
use crate::tolerances::{AXIS_IN_FACE, EXIT_EXCESS, MIN_CABLE_LENGTH, ROUNDING, SAME_SIDE, WRAP_EXCESS};

impl Pulley {
    /// Points whose convex hull contains the exits of the cables to all attachments in a box that have a
    /// [`departure`](Self::departure), world, m; `None` if none has one, unless that is too close to tell.
    ///
    /// Beyond these exits the hull extends by
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
    /// # Example
    /// ```
    /// use cdpr_core::{Point, geometry::{Aabb, Polytope, Vector}, geometry::Pulley};
    /// let pulley = Pulley { radius: 0.05, axis: Vector::z() };
    /// let (outlet, room) = (Point::origin(), Aabb { min: Point::new(1., 1., -3.), max: Point::new(3., 4., -1.) });
    /// let exits = Polytope::hull_of(&pulley.exits(&outlet, &room).unwrap())?;
    /// let exit = pulley.departure(&outlet, &Point::new(2.0, 2.0, -2.0)).unwrap().exit;
    /// assert!(exits.facets().iter().all(|facet| facet.height(&exit) < 1e-9));
    /// # Ok::<(), cdpr_core::geometry::PolytopeError>(())
    /// ```
    pub fn exits(&self, outlet: &Point, attachments: &Aabb) -> Option<Vec<Point>> {
        let frame = Frame::new(outlet, &self.axis);
        let view = frame.view(attachments);
        let [least, most] = self.wraps(&frame, attachments)?;
        let mut points = self.patch([least.max(0.0), most.min(TAU)], &view.swivel);
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
    /// for these; parts that could extend what is attained are divided, all of them at once: the result then depends on no order,
    /// so that the checkers of certificates find the same one.
    fn wraps(&self, frame: &Frame, attachments: &Aabb) -> Option<[f64; 2]> {
        let mut attained = [f64::INFINITY, f64::NEG_INFINITY];
        let (mut ranges, mut parts, mut count) = (Vec::new(), vec![*attachments], 1);
        loop {
            let mut found = Vec::new();
            for part in parts {
                let view = frame.view(&part);
                found.extend(self.wraps_within(view.distance, view.height).map(|range| (part, range)));
                // Attachments on the wheel or nearly count only in the ranges, since rounding decides whether they are attained.
                let leaving = view.samples.iter().filter_map(|sample| self.tangent(*sample));
                for wrap in leaving.filter(|tangent| tangent.free >= MIN_CABLE_LENGTH).map(|tangent| tangent.wrap()) {
                    attained = [attained[0].min(wrap), attained[1].max(wrap)];
                }
            }
            let exceeds = |[least, most]: [f64; 2]| f64::max(attained[0] - least, most - attained[1]) > WRAP_EXCESS;
            let (wide, narrow): (Vec<_>, Vec<_>) = found.into_iter().partition(|(_, range)| exceeds(*range));
            ranges.extend(narrow.into_iter().map(|(_, range)| range));
            count += wide.len();
            if wide.is_empty() || count > MOST_WRAP_BOXES {
                ranges.extend(wide.into_iter().map(|(_, range)| range));
                return ranges.into_iter().reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]);
            }
            parts = wide.iter().flat_map(|(part, _)| halves(part)).collect();
        }
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
}

/// Coordinates with the outlet as origin and the axis as third direction.
pub(super) struct Frame {
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
    pub(super) fn new(outlet: &Point, axis: &Vector) -> Self {
        let unit = Vector::ith(axis.iamin(), 1.0);
        let first = (unit - axis.dot(&unit) * axis).normalize();
        Frame { outlet: *outlet, directions: [first, axis.cross(&first), *axis] }
    }

    pub(super) fn world(&self, [x, y, h]: &[f64; 3]) -> Point {
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

/// The two halves of a box across its longest side; of sides that are equal up to rounding, across the first.
fn halves(whole: &Aabb) -> [Aabb; 2] {
    let sides = whole.max - whole.min;
    let longest = (0..3).find(|k| sides[*k] >= (1.0 - SAME_SIDE) * sides.max()).unwrap_or(0);
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
    use super::super::tests::{UPRIGHT, magnitude, random_pulley, random_vector};
    use super::*;
    use crate::geometry::{Polytope, distance};
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

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
            let exits = pulley.exits(&outlet, &room);
            let mut left = Vec::new();
            for k in 0..100 {
                // Every other sample is on an edge or at a corner.
                let share = Vector::from_fn(|_, _| {
                    let share: f64 = rng.random_range(-1.0..1.0);
                    if k % 2 == 0 { share } else { share.signum() * (1.5 * share.abs()).min(1.0) }
                });
                let at = (middle + share.component_mul(&half)).sup(&room.min).inf(&room.max);
                let Some(cable) = pulley.departure(&outlet, &at) else { continue };
                let wrap = cable.wrap;
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
            assert!(height <= rounding, "{case} {pulley:?} {outlet} {room:?} {height} {}", points.len());
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
        for room in [corner, face] {
            let points = UPRIGHT.exits(&Point::origin(), &room).unwrap();
            assert!(points.iter().all(|p| p.x > -1e-9), "{points:?}");
            assert!(points.iter().any(|p| p.x > 0.5) && points.len() < 100, "{points:?}");
        }
        let around = Aabb { min: Point::new(-1e-3, -4.0, 0.5), ..corner };
        assert!(UPRIGHT.exits(&Point::origin(), &around).unwrap().iter().any(|p| p.x < -0.5));
    }

    #[test]
    fn boxes_inside_the_wheel_or_below_the_outlet_have_no_exits() {
        let room = |min: [f64; 3], max: [f64; 3]| Aabb { min: Point::from(min), max: Point::from(max) };
        for none in [room([0.9, 0.0, 0.0], [1.1, 0.1, 0.1]), room([-1.0, -1.0, -5.0], [1.0, 1.0, -1e-3])] {
            assert_eq!(UPRIGHT.exits(&Point::origin(), &none), None);
        }
        let point = room([2.0, 0.0, 2.0], [2.0, 0.0, 2.0]);
        let exits = UPRIGHT.exits(&Point::origin(), &point).unwrap();
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
