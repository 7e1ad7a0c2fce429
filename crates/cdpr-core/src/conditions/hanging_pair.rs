//! Two cables of which at least one can take several shapes.
//!
//! A cable that hangs at most σ below its chord, in the middle, lies between the chord and a parabola, and so in the hull of the
//! chord and of the points σ below it at a quarter and at three quarters of its length: these are on the tangents at both ends
//! and in the middle. With several exit points, the hull of all these hulls is meant. The pair must keep the distance of both hulls.
//! That is less than necessary where the cables would not reach the same shape at the same time.
//!
//! The sag is that of the longest chord during a piece of a motion. The corners of the hulls then move linearly with the platform, so
//! a gap along a fixed direction is a concave function of time and smallest at an end: each piece is bounded along the direction that
//! separates the hulls halfway.

use super::bodies::CableAt;
use crate::geometry::gjk::shape_distance;
use crate::geometry::segment_segment::closest;
use crate::geometry::separating_axes::gap_along;
use crate::geometry::{Cuboid, Fan, Point, Vector, proximity};
use crate::limits::{HANGING_HALVINGS, HANGING_PIECES};
use crate::tolerances::{GAP_TOLERANCE, TOUCH_DEPTH};

/// Two cables, at least one of which can take several shapes.
pub struct HangingPair<'a> {
    /// The cables.
    pub cables: [&'a CableAt; 2],
}

/// Pieces of a motion that are still to be examined, as fractions of it: each halving adds one.
struct Waiting {
    pieces: [[f64; 2]; HANGING_HALVINGS],
    count: usize,
}

impl Waiting {
    fn whole() -> Self {
        Waiting { pieces: [[0.0, 1.0]; HANGING_HALVINGS], count: 1 }
    }

    fn pop(&mut self) -> Option<[f64; 2]> {
        self.count = self.count.checked_sub(1)?;
        Some(self.pieces[self.count])
    }

    /// Leaves both halves for later, the first one on top; false if there is no more room.
    fn halve(&mut self, [start, end]: [f64; 2]) -> bool {
        let room = self.count + 2 <= HANGING_HALVINGS;
        if room {
            let middle = 0.5 * (start + end);
            self.pieces[self.count] = [middle, end];
            self.pieces[self.count + 1] = [start, middle];
            self.count += 2;
        }
        room
    }
}

impl HangingPair<'_> {
    /// How deep the cables hang at most while the platform moves between two positions, m: the length of a chord is greatest at one
    /// of them.
    fn depths(&self, ends: [&Point; 2]) -> [f64; 2] {
        self.cables
            .map(|cable| ends.map(|position| cable.sag(&(position + cable.arm), 0.0)).into_iter().fold(0.0, f64::max))
    }

    /// The hulls of both cables with the platform at a position, if they hang at most this deep.
    fn at(&self, position: &Point, depths: [f64; 2]) -> [Fan<'_>; 2] {
        let [i, j] = self.cables;
        [i.shapes(&(position + i.arm), depths[0]), j.shapes(&(position + j.arm), depths[1])]
    }

    /// The distance of the cables' axes at a position, m, negative where the hulls overlap, and their nearest points.
    pub fn nearest(&self, position: &Point) -> (f64, [Point; 2], Vector) {
        let [a, b] = self.at(position, self.depths([position; 2]));
        let found = shape_distance(&a, &b);
        (found.signed(), [found.on_a, found.on_b], found.axis)
    }

    /// Whether the cables come nearer than `gap` metres, which must be positive, at some instant of a motion, or too close to
    /// that to tell.
    pub fn nearer_than(&self, gap: f64, from: &Point, to: &Point) -> bool {
        !self.clearly_apart(gap, [from, to]) && self.hulls_nearer_than(gap, from, to)
    }

    /// [`HangingPair::nearer_than`] by the distance of the hulls alone.
    fn hulls_nearer_than(&self, gap: f64, from: &Point, to: &Point) -> bool {
        let wanted = gap - TOUCH_DEPTH;
        let place = |t: f64| from + (to - from) * t;
        let shortest = GAP_TOLERANCE / (to - from).norm();
        let mut waiting = Waiting::whole();
        for _ in 0..HANGING_PIECES {
            let Some([start, end]) = waiting.pop() else { return false };
            let middle = 0.5 * (start + end);
            let depths = self.depths([&place(middle); 2]);
            let [a, b] = self.at(&place(middle), depths);
            let found = proximity(&a, &b, wanted, wanted);
            if found.upper < wanted || (found.lower < wanted && !(end - start > shortest)) {
                return true;
            }
            if self.gap_between([&place(start), &place(end)], &found.axis) >= wanted {
                continue;
            }
            if !waiting.halve([start, end]) {
                return true;
            }
        }
        waiting.count > 0
    }

    /// Whether the cables stay at least `gap` metres apart between two positions of the platform, by a test that fails for some
    /// cables that do. It decides most motions, much faster than the distance of the hulls.
    ///
    /// A yes is certain, because the gap along any fixed unit direction is at most the distance of two sets, and this one is too
    /// small rather than too large:
    ///
    /// - A corner of a hull is (1 - s) exit + s end + fall, with a share s and a fall of [`CableAt::outline`]. The exits are in a
    ///   ball of the radius [`CableAt::exit_error`] around the outlet, which reaches that much farther than the outlet along any
    ///   direction, so the corner reaches at most (1 - s) times that much farther than one of a cable from the outlet.
    /// - A cable hangs deepest with its longest chord. The length of a chord is a convex function of the position, so it is greatest
    ///   at an end of the motion, and with the depths of both ends the hulls contain those at each instant.
    /// - With fixed depths, the corners move linearly. The farthest of one cable is a convex function of time and the nearest of the
    ///   other a concave one, so the gap between them is concave and smallest at an end of the motion.
    ///
    /// The direction, the shortest way between the cables halfway if they were straight, only decides how often the test succeeds.
    #[inline]
    fn clearly_apart(&self, gap: f64, ends: [&Point; 2]) -> bool {
        let [i, j] = self.cables;
        let middle = nalgebra::center(ends[0], ends[1]);
        let nearest = closest(&i.outlet, &(middle + i.arm), &j.outlet, &(middle + j.arm));
        // Not a number if a position is not.
        if !(nearest.distance > gap && nearest.distance.is_finite()) {
            return false;
        }
        let axis = nearest.offset / nearest.distance;
        let depths = self.depths(ends);
        // The farthest corner of a hull along a direction.
        let farthest = |cable: &CableAt, depth: f64, along: &Vector, position: &Point| {
            let exit = along.dot(&cable.outlet.coords) + cable.exit_error();
            let end = along.dot(&(position + cable.arm).coords);
            let heights =
                cable.outline(depth).map(|(share, fall)| exit * (1.0 - share) + end * share + along.dot(&fall));
            heights.into_iter().fold(f64::NEG_INFINITY, f64::max)
        };
        let room =
            |position: &Point| -farthest(j, depths[1], &-axis, position) - farthest(i, depths[0], &axis, position);
        room(ends[0]).min(room(ends[1])) >= gap
    }

    /// Whether the cables stay at least `gap` metres apart at all positions of a box, by a test that fails for some that do.
    ///
    /// If they hang as deep as anywhere in the box, each corner of a hull moves by a share of how far the platform moves. So the gap along
    /// the direction that separates the hulls at the centre is a concave function of how far it moves in that direction.
    pub fn apart_over(&self, gap: f64, positions: &Cuboid) -> bool {
        let corners = positions.corners();
        let deepest = |cable: &CableAt| {
            let depths = corners.iter().map(|corner| cable.sag(&(corner + cable.arm), 0.0));
            depths.fold(0.0, f64::max)
        };
        let depths = self.cables.map(deepest);
        let [a, b] = self.at(&positions.center, depths);
        let found = proximity(&a, &b, f64::INFINITY, gap);
        let way = found.axis * found.axis.abs().dot(&positions.half);
        let room = |step: &Vector| {
            let [a, b] = self.at(&(positions.center + step), depths);
            gap_along(&a, &b, &found.axis)
        };
        found.lower >= gap && room(&way) >= gap && room(&-way) >= gap
    }

    /// The least distance of the cables' axes during a motion, m, to within [`GAP_TOLERANCE`] or slightly more.
    pub fn least(&self, from: &Point, to: &Point) -> f64 {
        let place = |t: f64| from + (to - from) * t;
        let mut best = self.nearest(from).0;
        if from == to {
            return best;
        }
        best = best.min(self.nearest(to).0);
        let mut waiting = Waiting::whole();
        for _ in 0..HANGING_PIECES {
            let Some([start, end]) = waiting.pop() else { break };
            let middle = 0.5 * (start + end);
            let (distance, _, axis) = self.nearest(&place(middle));
            best = best.min(distance);
            let open = self.gap_between([&place(start), &place(end)], &axis) < best - GAP_TOLERANCE;
            if open && !waiting.halve([start, end]) {
                break;
            }
        }
        best
    }

    /// The least gap along a unit direction, from the first cable to the second, between two positions, m.
    fn gap_between(&self, ends: [&Point; 2], axis: &Vector) -> f64 {
        let depths = self.depths(ends);
        let gap = |position: &Point| {
            let [a, b] = self.at(position, depths);
            gap_along(&a, &b, axis)
        };
        gap(ends[0]).min(gap(ends[1]))
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::conditions::CableCable;
    use crate::conditions::bodies::Bodies;
    use crate::conditions::physical::{Interference, PhysicalCondition};
    use crate::model::spec::{CableDefaultsSpec, CableSpec, PulleySpec, RobotSource};
    use crate::model::{BodySpec, Scene};
    use crate::testing::hard1;

    /// A cable to a platform that is a point.
    #[derive(Clone, Copy)]
    struct Rope {
        outlet: [f64; 3],
        attachment: [f64; 3],
        /// kg/m
        density: f64,
    }

    /// Two ropes that pull with 20 N or more, with outlets known to within `error` metres, maybe over pulleys of a radius.
    fn two_ropes(ropes: [Rope; 2], error: f64, radius: Option<f64>) -> Option<Bodies> {
        let mut spec = hard1().spec().clone();
        spec.obstacles.clear();
        let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("the robot is in the scene") };
        robot.cable = Some(CableDefaultsSpec {
            sag_tension: Some(20.0),
            outlet_error: Some(error),
            pulley: radius.map(|radius| PulleySpec { radius, axis: [0.0, 0.0, 1.0] }),
            ..CableDefaultsSpec::default()
        });
        let cable = |Rope { outlet, attachment, density }| CableSpec {
            outlet,
            attachment,
            linear_density: Some(density),
            ..CableSpec::default()
        };
        robot.cables = ropes.map(cable).into();
        robot.platform = vec![BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() }];
        Scene::new(spec).ok().map(|scene| Bodies::of(&scene))
    }

    /// Points of a shape that a cable can take: from an exit, with this share of the greatest sag.
    fn shape(cable: &CableAt, exit: &Point, share: f64, position: &Point) -> Vec<Point> {
        let end = position + cable.arm;
        let depth = share * cable.sag(&end, 0.0);
        let point = |k: u32| {
            let s = f64::from(k) / 12.0;
            exit + (end - exit) * s - Vector::z() * (4.0 * s * (1.0 - s) * depth)
        };
        (0..=12).map(point).collect()
    }

    fn distance(a: &[Point], b: &[Point]) -> f64 {
        let pairs = a.windows(2).flat_map(|p| b.windows(2).map(move |q| closest(&p[0], &p[1], &q[0], &q[1]).distance));
        pairs.fold(f64::INFINITY, f64::min)
    }

    /// The least distance of shapes from all extreme exits, straight or as deep as possible, at either end of a motion, m.
    fn sampled(cables: [&CableAt; 2], ends: [&Point; 2]) -> f64 {
        let shapes = |k: usize, position: &Point| -> Vec<Vec<Point>> {
            let of = |exit: &Point| [0.0, 1.0].map(|share| shape(cables[k], exit, share, position));
            cables[k].exits().iter().flat_map(of).collect()
        };
        let at = |position: &Point| {
            let (first, second) = (shapes(0, position), shapes(1, position));
            first.iter().flat_map(|a| second.iter().map(|b| distance(a, b))).fold(f64::INFINITY, f64::min)
        };
        at(ends[0]).min(at(ends[1]))
    }

    /// The sampled shapes show how near the cables come; the quick test must not miss a tenth of a millimetre of that, whichever cable
    /// is first and whichever way the platform moves. While it stands still, no more than a tenth may be wasted either.
    #[test]
    fn the_quick_test_counts_all_shapes_of_both_cables_at_both_ends_of_a_motion() {
        let rope = |outlet, attachment, density| Rope { outlet, attachment, density };
        let cases = [
            // Outlets side by side, and cables that part from there.
            ([rope([1.0, 1.0, 2.0], [-0.3, 0.0, 0.0], 0.0), rope([1.1, 1.0, 2.0], [0.3, 0.0, 0.0], 0.0)], 0.005),
            // A heavy cable crosses above a light one, and hangs deeper the farther the platform is to the right.
            ([rope([0.0, 1.0, 1.0], [1.0, 0.0, 0.1], 0.05), rope([1.0, 0.0, 0.8], [0.0, 1.0, -0.1], 0.0)], 0.0),
            ([rope([0.0, 1.0, 1.0], [1.0, 0.0, 0.1], 0.05), rope([1.0, 0.0, 0.8], [0.0, 1.0, -0.1], 0.02)], 0.001),
            // A level cable passes a steep one, the nearer the smaller y.
            ([rope([0.0, 1.0, 1.0], [1.0, 0.0, 0.1], 0.0), rope([1.0, 1.3, 2.0], [0.0, 0.3, -0.4], 0.0)], 0.001),
        ];
        let ways = [Vector::zeros(), Vector::x() * 0.3, Vector::y() * 0.2, Vector::z() * -0.1];
        for (number, (ropes, error)) in cases.into_iter().enumerate() {
            let bodies = two_ropes(ropes, error, None).expect("a sound scene");
            for way in ways {
                let near = Point::new(1.0, 1.0, 0.9);
                let far = near + way;
                let least = sampled([&bodies.cables[0], &bodies.cables[1]], [&near, &far]);
                for (first, second) in [(0, 1), (1, 0)] {
                    let pair = HangingPair { cables: [&bodies.cables[first], &bodies.cables[second]] };
                    for ends in [[&near, &far], [&far, &near]] {
                        let at =
                            format!("case {number}, cable {first} first, from {} to {}: {least}", ends[0], ends[1]);
                        assert!(!pair.clearly_apart(least + 1e-4, ends), "{at}");
                        assert!(pair.nearer_than(least + 1e-4, ends[0], ends[1]), "{at}");
                        assert!(way.norm() > 0.0 || pair.clearly_apart(0.9 * least, ends), "{at}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_quick_test_says_nothing_about_positions_that_are_not_numbers() {
        let rope = |x: f64| Rope { outlet: [x, 1.0, 2.0], attachment: [x - 1.0, 0.0, 0.0], density: 0.01 };
        let bodies = two_ropes([rope(0.5), rope(1.5)], 0.001, None).expect("a sound scene");
        let pair = HangingPair { cables: [&bodies.cables[0], &bodies.cables[1]] };
        let at = Point::new(1.0, 1.0, 1.0);
        assert!(pair.clearly_apart(0.9, [&at, &at]));
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e200] {
            let away = Point::new(1.0, x, 1.0);
            for ends in [[&at, &away], [&away, &at], [&away, &away]] {
                assert!(!pair.clearly_apart(0.9, ends), "{x}");
            }
        }
    }

    /// Random pairs, a third of them with outlets side by side, and a third such that the lines between outlets and between
    /// attachments are parallel; each with some motions.
    fn random_pairs(count: usize, mut judge: impl FnMut(&mut ChaCha8Rng, &Bodies, [&Point; 2])) {
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        let mut done = 0;
        while done < count {
            let mut place = |low: f64, high: f64| [(); 3].map(|()| rng.random_range(low..high));
            let (outlet, elsewhere, aside) = (place(0.0, 2.0), place(0.0, 2.0), place(-0.1, 0.1));
            let mut attachments = [place(-0.5, 0.5), place(-0.5, 0.5)];
            let beside = [0, 1, 2].map(|axis| outlet[axis] + aside[axis]);
            let kind = rng.random_range(0..3);
            let other = if kind == 0 { beside } else { elsewhere };
            if kind == 1 {
                let scale = rng.random_range(0.02..0.3);
                attachments[1] = [0, 1, 2].map(|axis| attachments[0][axis] + scale * (other[axis] - outlet[axis]));
            }
            let mut rope = |outlet: [f64; 3], attachment: [f64; 3]| Rope {
                outlet,
                attachment,
                density: [0.0, 0.006, 0.05][rng.random_range(0..3)],
            };
            let ropes = [rope(outlet, attachments[0]), rope(other, attachments[1])];
            let error = [0.001, 0.005, 0.03][rng.random_range(0..3)];
            let radius = [None, None, Some(0.02)][rng.random_range(0..3)];
            let Some(bodies) = two_ropes(ropes, error, radius) else { continue };
            done += 1;
            for length in [0.0, 0.1, 0.1, 1.0] {
                let mut at = || Point::from([(); 3].map(|()| rng.random_range(0.2..1.8)));
                let (from, toward) = (at(), at());
                let to = from + (toward - from).normalize() * length;
                judge(&mut rng, &bodies, [&from, &to]);
            }
        }
    }

    #[test]
    fn cables_that_are_clearly_apart_keep_their_distance() {
        let mut counts = [[0; 2]; 2];
        random_pairs(200, |rng, bodies, ends| {
            let cables = [&bodies.cables[0], &bodies.cables[1]];
            let pair = HangingPair { cables };
            let least = pair.nearest(ends[0]).0.min(pair.nearest(ends[1]).0);
            if least <= 1e-3 {
                return;
            }
            for (kind, shares) in [(0, 0.8..1.05), (1, 0.1..0.5)] {
                let gap = least * rng.random_range(shares);
                let clearly = pair.clearly_apart(gap, ends);
                let nearer = pair.hulls_nearer_than(gap, ends[0], ends[1]);
                let at = || format!("{cables:?}: {} to {}, gap {gap} of {least}", ends[0], ends[1]);
                assert!(!clearly || !nearer, "{}", at());
                for _ in 0..if clearly { 10 } else { 0 } {
                    let t = [0.0, 1.0, rng.random()][rng.random_range(0..3)];
                    let position = ends[0] + (ends[1] - ends[0]) * t;
                    let [a, b] = cables.map(|cable| {
                        let exits = cable.exits();
                        shape(cable, &exits[rng.random_range(0..exits.len())], rng.random(), &position)
                    });
                    assert!(distance(&a, &b) >= gap, "{}, at {t}", at());
                }
                if !nearer {
                    counts[kind][usize::from(clearly)] += 1;
                }
            }
        });
        // The test must be worth its time. It decides 48 % of those that are nearly too close and 78 % of those plainly apart: with
        // exits or sag twice as large 38 to 40 % and 70 to 72 %, along the way between the middles of the cables 20 % and 41 %.
        let [close, plain] = counts.map(|[open, decided]| f64::from(decided) / f64::from(open + decided));
        assert!(close > 0.44 && plain > 0.74, "not decided and decided: {counts:?}");
    }

    /// A position where a point of the second cable is this far from a point of the first, given as shares of the way from exit to
    /// attachment, if there is one in the room.
    fn meeting(cables: [&CableAt; 2], exits: [&Point; 2], shares: [f64; 2], apart: &Vector) -> Option<Point> {
        let mut position = Point::origin();
        for _ in 0..20 {
            let [first, second] = [0, 1].map(|k| {
                let (cable, s) = (cables[k], shares[k]);
                let depth = cable.sag(&(position + cable.arm), 0.0);
                exits[k].coords * (1.0 - s) + cable.arm * s - Vector::z() * (4.0 * s * (1.0 - s) * depth)
            });
            position = Point::from((second - first - apart) / (shares[0] - shares[1]));
        }
        position.iter().all(|x| (0.0..2.0).contains(x)).then_some(position)
    }

    /// Asserts that a position where points of two cables are nearer than required, given as shares of the way from exit to attachment,
    /// is in the wedge of those; returns which of the two, if there is such a position.
    fn in_wedge(bodies: &Bodies, exits: [&Point; 2], shares: [f64; 2], clearance: f64, way: &Vector) -> Option<usize> {
        let cables = [&bodies.cables[0], &bodies.cables[1]];
        let condition = CableCable::new(&bodies.cables, 0, 1, clearance)?;
        let position = meeting(cables, exits, shares, &(way * (0.999 * condition.gap)))?;
        let wedges = condition.wedges()?;
        let distance = HangingPair { cables }.nearest(&position).0;
        assert!(distance <= condition.gap + 1e-9, "{cables:?}: {position}, {shares:?}");
        let which = usize::from(shares[0] < shares[1]);
        assert!(
            wedges[which].iter().all(|plane| plane.height(&position) <= 1e-9),
            "{cables:?}: {position}, {shares:?}"
        );
        Some(which)
    }

    #[test]
    fn positions_where_two_cables_are_too_near_are_in_a_wedge() {
        let rope = |x: f64, y: f64, density: f64| Rope { outlet: [x, 0.1, 1.0], attachment: [0.0, y, 0.0], density };
        // Near its attachment, a long cable hangs almost as deep as its tangent there.
        let level = two_ropes([rope(1.0, 0.0, 0.0), rope(1.2, 0.18, 0.05)], 0.0, None).expect("a sound scene");
        let outlets = [&level.cables[0].outlet, &level.cables[1].outlet];
        assert_eq!(in_wedge(&level, outlets, [1.0, 0.9], 0.0, &Vector::z()), Some(0));
        let mut found = [0; 2];
        random_pairs(100, |rng, bodies, _| {
            for _ in 0..30 {
                let exits = [0, 1].map(|k: usize| {
                    let exits = bodies.cables[k].exits();
                    &exits[rng.random_range(0..exits.len())]
                });
                // Where both shares are nearly the same, both exits count in full.
                let share = 1.0 - rng.random::<f64>() * [1.0, 0.3][rng.random_range(0..2)];
                let beyond = f64::min(share + rng.random_range(0.02..0.2), 1.0);
                let mut shares = [share, [1.0, beyond][rng.random_range(0..2)]];
                let first = rng.random_range(0..2);
                shares.swap(0, first);
                let way = Vector::from_fn(|_, _| rng.random_range(-1.0..1.0)).normalize();
                let clearance = [0.0, 0.01][rng.random_range(0..2)];
                if let Some(which) = in_wedge(bodies, exits, shares, clearance, &way) {
                    found[which] += 1;
                }
            }
        });
        assert!(found.iter().all(|count| *count > 300), "{found:?}");
    }

    /// A box that a pair allows as a whole holds no position that it refuses; boxes without such positions are found unless they are large, or
    /// the cables nearly too close.
    #[test]
    fn boxes_that_a_pair_allows_hold_no_position_that_it_refuses() {
        let mut counts = [[0; 2]; 3];
        random_pairs(60, |rng, bodies, [at, _]| {
            let clearance = [0.0, 0.02, 0.1][rng.random_range(0..3)];
            let Some(pair) = CableCable::new(&bodies.cables, 0, 1, clearance) else { return };
            for (kind, size) in [1e-6, 0.05, 0.3].into_iter().enumerate() {
                let half = Vector::from_fn(|_, _| rng.random_range(0.0..size));
                let allowed = pair.allows_all(bodies, &Cuboid::new(at - half, at + half));
                let mut keeps = true;
                for k in 0..5 {
                    let side = |_, _| rng.random_range(-1.5..1.5f64).clamp(-1.0, 1.0);
                    let share = if k == 0 { Vector::zeros() } else { Vector::from_fn(side) };
                    let position = at + half.component_mul(&share);
                    let slack = pair.slack(bodies, &position);
                    assert!(!allowed || slack >= -1e-9, "{position} {half} {slack} {bodies:?}");
                    keeps &= slack > 1e-3;
                }
                if keeps {
                    counts[kind][usize::from(allowed)] += 1;
                }
            }
        });
        let decided = counts.map(|[open, decided]| f64::from(decided) / f64::from(open + decided));
        assert!(decided[0] > 0.99 && decided[1] > 0.75 && decided[2] > 0.45, "not decided and decided: {counts:?}");
    }

    /// A box that a pair forbids as a whole holds no position that it does not refuse; of the boxes that are hardly larger than a
    /// position, nearly all that are refused are found if the cables do not hang, also round pulleys.
    #[test]
    fn boxes_that_a_pair_forbids_hold_only_positions_that_it_refuses() {
        let (mut forbidden, mut refused) = ([0; 2], [[0; 2]; 2]);
        random_pairs(1000, |rng, bodies, [at, _]| {
            let clearance = [0.02, 0.1, 0.3][rng.random_range(0..3)];
            let Some(pair) = CableCable::new(&bodies.cables, 0, 1, clearance) else { return };
            let refuses = |position: &Point| pair.breaks(bodies, Interference::Exact, position, position);
            let round = usize::from(bodies.cables[0].pulley.is_some());
            for size in [1e-6, 0.01, 0.05] {
                let half = Vector::from_fn(|_, _| rng.random_range(0.0..size));
                let found = pair.forbids_all(bodies, &Cuboid::new(at - half, at + half), -2.0 * TOUCH_DEPTH);
                let hangs = bodies.cables.iter().any(|cable| cable.sag(&(at + cable.arm), 0.0) > 0.0);
                if size < 1e-3 && !hangs && pair.gap > 0.0 && refuses(at) {
                    refused[round][usize::from(found)] += 1;
                }
                for _ in 0..if found { 20 } else { 0 } {
                    let side = |_, _| rng.random_range(-1.5..1.5f64).clamp(-1.0, 1.0);
                    let position = at + half.component_mul(&Vector::from_fn(side));
                    assert!(refuses(&position), "{position} {half} {bodies:?}");
                }
                forbidden[round] += usize::from(found && size > 1e-3);
            }
        });
        let [missed, found] = [0, 1].map(|k| refused.map(|counts| counts[k]));
        assert!(forbidden.iter().all(|count| *count > 50), "{forbidden:?}");
        assert!((0..2).all(|k| missed[k] * 10 < found[k]), "{missed:?} {found:?}");
    }
}
