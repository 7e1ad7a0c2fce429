//! Intervals of free edges, linear functions on them, and how such a function continues from one interval to another.

use super::free_edges::{Corner, FreeEdge};
use crate::forbidden::HPolyhedron;
use crate::geometry::segment_segment::closest;
use crate::geometry::{HalfSpace, Point, Vector, shortest_over};
use crate::tolerances::{BLOCKED_DEPTH, ON_SURFACE, SAME_POINT};

/// An interval of a free edge, or a single point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Both ends of the interval.
    pub ends: [Point; 2],
    /// Length of the interval, m.
    pub length: f64,
    /// The interval stands for all positions within this distance of it, m.
    radius: f64,
    /// Unit vector from the first end to the second; zero for a point.
    along: Vector,
    middle: Point,
    /// The edge that the interval lies on; `None` for corners, and for start and goal, where a path need not bend.
    edge: Option<Edge>,
}

/// The free edge of an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Edge {
    /// Number of the edge.
    number: u32,
    /// The planes that meet in the edge.
    planes: [HalfSpace; 2],
    /// The part of the edge, as fractions.
    range: [f64; 2],
}

/// Whether only the first face of an edge is visible from somewhere, and whether only the second is.
pub type Sides = [bool; 2];

/// A linear function on an interval, by its values at both ends: a lower bound of the distance from start or goal, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Label(pub [f64; 2]);

/// If two intervals are closer than this share of their length, they count as near each other.
const NEAR: f64 = 0.25;
/// Minimum distance of a tangent from the ends of an interval that is near another, as a share of its length.
const BESIDE: f64 = 1.0 / 16.0;
/// Slopes steeper than 1 minus this are 1: the nearest point is then an end.
const STEEP: f64 = 1e-12;

impl Label {
    /// The label before any bound is known.
    pub const UNKNOWN: Label = Label([f64::INFINITY; 2]);

    /// The label with the same value everywhere.
    pub fn constant(value: f64) -> Self {
        Label([value; 2])
    }

    /// Smallest value of the label, m.
    #[inline]
    pub fn least(&self) -> f64 {
        self.0[0].min(self.0[1])
    }

    /// Value of the label in the middle of the interval, m.
    pub fn middle(&self) -> f64 {
        0.5 * (self.0[0] + self.0[1])
    }

    /// The sum of this function and another.
    #[inline]
    pub fn plus(&self, other: &Label) -> Label {
        Label([self.0[0] + other.0[0], self.0[1] + other.0[1]])
    }

    /// A linear lower bound of both functions.
    pub fn lower(&self, other: &Label) -> Label {
        Label([self.0[0].min(other.0[0]), self.0[1].min(other.0[1])])
    }

    /// The one of two functions that is higher in the middle.
    pub fn higher(&self, other: &Label) -> Label {
        if other.middle() > self.middle() { *other } else { *self }
    }

    /// The function on a part of the interval, given as fractions.
    pub fn part(&self, part: [f64; 2]) -> Label {
        if *self == Label::UNKNOWN {
            return *self;
        }
        Label(part.map(|share| self.0[0] + share * (self.0[1] - self.0[0])))
    }

    /// The fractions between which the function is below a value; `None` if nowhere.
    pub fn below(&self, value: f64) -> Option<[f64; 2]> {
        let [a, b] = self.0.map(|at_end| at_end - value);
        match (a < 0.0, b < 0.0) {
            (true, true) => Some([0.0, 1.0]),
            (true, false) => Some([0.0, a / (a - b)]),
            (false, true) => Some([a / (a - b), 1.0]),
            (false, false) => None,
        }
    }
}

impl Interval {
    /// A whole free edge with its number.
    pub fn of((number, edge): (usize, &FreeEdge)) -> Self {
        let edge_of = Edge { number: number as u32, planes: edge.planes, range: [0.0, 1.0] };
        Interval::new([edge.from, edge.to], Some(edge_of))
    }

    /// Start or goal as an interval without length.
    pub fn point(place: Point) -> Self {
        Interval::new([place, place], None)
    }

    /// A corner, where paths may bend in any way.
    pub fn corner(Corner { center, radius }: &Corner) -> Self {
        Interval { radius: *radius, ..Interval::point(*center) }
    }

    fn new([a, b]: [Point; 2], edge: Option<Edge>) -> Self {
        let length = (b - a).norm();
        let along = if length > SAME_POINT { (b - a) / length } else { Vector::zeros() };
        Interval { ends: [a, b], along, middle: a + (b - a) * 0.5, length, edge, radius: 0.0 }
    }

    /// The middle of the interval.
    #[inline]
    pub fn middle(&self) -> Point {
        self.middle
    }

    /// The point at a fraction of the interval's length.
    #[inline]
    pub fn at(&self, share: f64) -> Point {
        self.ends[0] + (self.ends[1] - self.ends[0]) * share
    }

    /// A part of the interval, given as fractions.
    pub fn part(&self, part: [f64; 2]) -> Interval {
        let within =
            |[from, to]: [f64; 2]| part.map(|share| if share == 1.0 { to } else { from + share * (to - from) });
        let edge = self.edge.map(|edge| Edge { range: within(edge.range), ..edge });
        Interval { radius: self.radius, ..Interval::new(part.map(|share| self.at(share)), edge) }
    }

    /// The distance from another interval, m.
    pub fn distance(&self, other: &Interval) -> f64 {
        let distance = closest(&self.ends[0], &self.ends[1], &other.ends[0], &other.ends[1]).distance;
        (distance - self.blur(other)).max(0.0)
    }

    /// How much smaller the distance between two positions may be than the distance between the points that represent them on the
    /// intervals, m.
    #[inline]
    pub fn blur(&self, other: &Interval) -> f64 {
        self.radius + other.radius
    }

    /// The point of the interval through which a path between two positions is shortest.
    pub fn nearest_way(&self, places: [&Point; 2]) -> Point {
        if self.length <= SAME_POINT {
            return self.middle();
        }
        let best = shortest_over(&self.ends[0], &self.along, places);
        self.ends[0] + self.along * best.clamp(0.0, self.length)
    }

    /// A linear lower bound, for points y of this interval, of the smallest `label(x) + |y - x|` over the points x of
    /// another one. That value is convex in y, so any tangent will do.
    pub fn continued(&self, from: &Interval, label: &Label) -> Label {
        self.continued_at(self.tangent_from(from), from, label)
    }

    /// A linear lower bound like [`Interval::continued`], with the tangent placed at this fraction of the interval.
    pub fn continued_at(&self, share: f64, from: &Interval, label: &Label) -> Label {
        let y = self.at(share);
        let (value, gradient) = from.reach(label, &y);
        let value = value - self.blur(from);
        Label(self.ends.map(|end| value + gradient.dot(&(end - y))))
    }

    /// The smallest value of `label(x) + |y - x|` over the points x of this interval, and a subgradient of it in y.
    fn reach(&self, label: &Label, y: &Point) -> (f64, Vector) {
        let way = y - self.ends[0];
        let slope = if self.length > SAME_POINT { (label.0[1] - label.0[0]) / self.length } else { 0.0 };
        let slope = slope.clamp(-1.0, 1.0); // if it is steeper, the nearest point is an end as well
        let foot = way.dot(&self.along);
        let height = (way.norm_squared() - foot * foot).max(0.0).sqrt();
        let flatness = 1.0 - slope * slope;
        let nearest = match flatness > STEEP {
            true => foot - slope * height / flatness.sqrt(),
            false if slope > 0.0 => 0.0,
            false => self.length,
        };
        let nearest = nearest.clamp(0.0, self.length);
        let way = way - self.along * nearest;
        let distance = way.norm();
        let share = if self.length > SAME_POINT { nearest / self.length } else { 0.0 };
        let least = label.part([share; 2]).least();
        match distance > SAME_POINT {
            true => (least + distance, way / distance),
            false => (least - distance, self.along * slope), // the tangent at the nearest point, less the way from there
        }
    }

    /// Where to place the tangent of a function continued from another interval, as a fraction. The middle is best, unless the
    /// intervals nearly touch. Then the function is linear on both sides of the nearest point, and a tangent placed far from
    /// there would be so low that the two intervals would keep lowering each other forever.
    fn tangent_from(&self, from: &Interval) -> f64 {
        let apart = (self.middle() - from.middle()).norm() > (0.5 + NEAR) * self.length + 0.5 * from.length;
        if self.length <= SAME_POINT || apart {
            return 0.5;
        }
        let nearest = closest(&self.ends[0], &self.ends[1], &from.ends[0], &from.ends[1]);
        if nearest.distance > NEAR * self.length { 0.5 } else { nearest.s.clamp(BESIDE, 1.0 - BESIDE) }
    }

    /// The sides of the edge on which a shortest path that bends here may arrive straight from another interval. Exactly one of
    /// the two faces of the edge must be visible from there: if both are, a taut string would come off the edge; if neither is,
    /// the body is in the way. The path leaves on the other side.
    pub fn sides_towards(&self, other: &Interval) -> Sides {
        let Some(Edge { planes, .. }) = &self.edge else { return [true; 2] };
        let (a, b) = (other.heights(&planes[0]), other.heights(&planes[1]));
        let near = ON_SURFACE + other.radius;
        [is_between(b, a, near), is_between(a, b, near)]
    }

    /// The heights of both ends above a plane, m.
    #[inline]
    fn heights(&self, plane: &HalfSpace) -> [f64; 2] {
        [plane.height(&self.ends[0]), plane.height(&self.ends[1])]
    }

    /// Whether a shortest path may run along an edge from one of these intervals to the other, if they are on the same edge. It meets
    /// an edge at the same angle as it leaves it, so it can join the edge only at an end, and leave it only at the other.
    pub fn may_run_along(&self, other: &Interval) -> bool {
        match (&self.edge, &other.edge) {
            (Some(own), Some(others)) if own.number == others.number => {
                let joins = |a: &Edge, b: &Edge| a.range[0] == 0.0 && b.range[1] == 1.0;
                joins(own, others) || joins(others, own)
            }
            _ => true,
        }
    }

    /// Whether a shortest path that bends inside both edges may lead straight from one of these intervals to the other: not if they
    /// are on the same line, since it crosses the edges.
    pub fn may_connect(&self, other: &Interval) -> bool {
        let on_one_line = match (&self.edge, &other.edge) {
            (Some(a), Some(b)) => a.planes.iter().all(|plane| b.planes.contains(plane)),
            _ => false,
        };
        let may_bend_towards = |a: &Interval, b: &Interval| a.sides_towards(b).contains(&true);
        !on_one_line && may_bend_towards(self, other) && may_bend_towards(other, self)
    }

    /// The number of the interval's edge and the interval's part of it, as fractions; `None` for a point.
    pub fn of_edge(&self) -> Option<(usize, [f64; 2])> {
        self.edge.map(|edge| (edge.number as usize, edge.range))
    }

    /// How many of the segments between two intervals a polyhedron blocks. It blocks all of them if at some fraction of their
    /// length the segments between the ends, and therefore all others, are inside; it blocks none if at no fraction any segment
    /// can be inside.
    pub fn sight(&self, other: &Interval, hull: &HPolyhedron) -> Sight {
        let (mut all, mut any) = ([0.0, 1.0], [0.0, 1.0]);
        let depth = BLOCKED_DEPTH + self.radius.max(other.radius);
        for plane in hull.planes() {
            let [[a, b], [c, d]] = [self.heights(plane), other.heights(plane)];
            any = narrowed(any, [a.min(b) + depth, c.min(d) + depth]);
            if any[0] >= any[1] {
                return Sight::Free;
            }
            all = narrowed(all, [a.max(b) + depth, c.max(d) + depth]);
        }
        if all[0] < all[1] { Sight::Blocked } else { Sight::Partial }
    }
}

/// How many of the segments between two intervals a polyhedron blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sight {
    /// The polyhedron blocks none of them, and so none between parts of the intervals.
    Free,
    /// The polyhedron may block some of them.
    Partial,
    /// The polyhedron blocks all of them.
    Blocked,
}

/// The part of a range of fractions of a way in which it is below zero, given its heights at both ends; empty if its
/// first bound is not below its second.
#[inline]
fn narrowed([low, high]: [f64; 2], [a, b]: [f64; 2]) -> [f64; 2] {
    if a >= 0.0 && b >= 0.0 {
        return [1.0, 0.0];
    }
    if a > 0.0 {
        [low.max(a / (a - b)), high]
    } else if b > 0.0 {
        [low, high.min(a / (a - b))]
    } else {
        [low, high]
    }
}

/// Whether some point of an interval is below one plane and above another, given the heights of its ends above both planes and
/// the error of these heights.
#[inline]
fn is_between(under: [f64; 2], over: [f64; 2], near: f64) -> bool {
    let (below, above) = (Label(under), Label([-over[0], -over[1]]));
    if below.least() >= near || above.least() >= near {
        return false;
    }
    // Usually one of the two conditions holds everywhere, and no point has to be computed.
    let is_everywhere = |heights: &Label| heights.0[0].max(heights.0[1]) < near;
    is_everywhere(&below) || is_everywhere(&above) || overlap(below.below(near), above.below(near))
}

/// Whether two ranges have a common place.
fn overlap(a: Option<[f64; 2]>, b: Option<[f64; 2]>) -> bool {
    a.zip(b).is_some_and(|(a, b)| a[0].max(b[0]) <= a[1].min(b[1]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    fn vector(rng: &mut ChaCha8Rng) -> Vector {
        Vector::from_fn(|_, _| rng.random_range(-1.0..1.0))
    }

    fn place(rng: &mut ChaCha8Rng) -> Point {
        Point::from(vector(rng))
    }

    /// A long edge through the origin, between planes with these normals.
    fn edge_between(normals: [Vector; 2]) -> Interval {
        let along = normals[0].cross(&normals[1]).normalize() * 10.0;
        let planes = normals.map(|normal| HalfSpace::through(&Point::origin(), normal));
        Interval::of((0, &FreeEdge { from: Point::from(-along), to: Point::from(along), planes }))
    }

    /// Whether the way between two places over an edge through the origin has the wedge on its inner side.
    fn bends_round(normals: [Vector; 2], along: &Vector, places: [&Point; 2]) -> bool {
        let [a, b] = places.map(|place| place.coords - along * along.dot(&place.coords));
        let turn = |v: &Vector, w: &Vector| along.dot(&v.cross(w));
        let between = |ray: &Vector| turn(&a, ray) * turn(&a, &b) > 0.0 && turn(ray, &b) * turn(&a, &b) > 0.0;
        let face = |k: usize| {
            let ray = along.cross(&normals[k]);
            if ray.dot(&normals[1 - k]) < 0.0 { ray } else { -ray }
        };
        between(&face(0)) && between(&face(1))
    }

    #[test]
    fn a_taut_path_passes_from_one_side_of_an_edge_to_the_other() {
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        let mut taut = 0;
        for _ in 0..3000 {
            let normals = [(); 2].map(|_| vector(&mut rng).normalize());
            let (edge, places) = (edge_between(normals), [place(&mut rng), place(&mut rng)]);
            if !bends_round(normals, &edge.along, places.each_ref()) {
                continue;
            }
            let [from, to] = places.map(|place| edge.sides_towards(&Interval::point(place)));
            assert!([[true, false], [false, true]].contains(&from) && to == [from[1], from[0]], "{from:?} {to:?}");
            taut += 1;
        }
        assert!(taut > 100, "{taut}");
    }

    #[test]
    fn a_label_holds_for_all_positions_for_which_an_interval_stands() {
        let mut rng = ChaCha8Rng::seed_from_u64(2);
        for _ in 0..3000 {
            let edge = Interval::new([place(&mut rng), place(&mut rng)], None);
            let corner = Interval::corner(&Corner { center: place(&mut rng), radius: rng.random_range(0.0..0.3) });
            let position = |rng: &mut ChaCha8Rng, interval: &Interval, share: f64| {
                interval.at(share) + vector(rng).normalize() * interval.radius * rng.random_range(0.0..1.0)
            };
            for [from, to] in [[&edge, &corner], [&corner, &edge], [&corner, &corner]] {
                let first = rng.random_range(0.0..2.0);
                let second = if from.length > 0.0 { rng.random_range(0.0..2.0) } else { first };
                let label = Label([first, second]);
                let continued = to.continued(from, &label);
                for _ in 0..20 {
                    let [s, t] = [rng.random(), rng.random()];
                    let (x, y) = (position(&mut rng, from, s), position(&mut rng, to, t));
                    let way = label.part([s; 2]).least() + (y - x).norm();
                    assert!(continued.part([t; 2]).least() <= way + 1e-12);
                    assert!(label.least() + to.distance(from) <= way + 1e-12);
                }
            }
        }
    }
}
