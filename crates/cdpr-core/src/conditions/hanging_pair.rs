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
use crate::geometry::{Fan, Point, Vector, proximity};
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
        if self.clearly_apart(gap, [from, to]) {
            return false;
        }
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
    /// cables that do: along the shortest way between the straight cables halfway, with a ball around each outlet in place of its
    /// exits. It decides most motions, some fifty times faster than the distance of the hulls.
    #[inline]
    fn clearly_apart(&self, gap: f64, ends: [&Point; 2]) -> bool {
        let [i, j] = self.cables;
        let middle = nalgebra::center(ends[0], ends[1]);
        let nearest = closest(&i.outlet, &(middle + i.arm), &j.outlet, &(middle + j.arm));
        let Some(axis) = nearest.offset.try_normalize(gap) else { return false };
        let depths = self.depths(ends);
        // The farthest corner of a hull along a direction.
        let farthest = |cable: &CableAt, depth: f64, along: &Vector, position: &Point| {
            let exit = along.dot(&cable.outlet.coords) + cable.exit_error();
            let end = along.dot(&(position + cable.arm).coords);
            let heights = cable.outline(depth).map(|(share, by)| exit * (1.0 - share) + end * share + along.dot(&by));
            heights.into_iter().fold(f64::NEG_INFINITY, f64::max)
        };
        // A concave function of time, so it is least at an end.
        let room =
            |position: &Point| -farthest(j, depths[1], &-axis, position) - farthest(i, depths[0], &axis, position);
        room(ends[0]).min(room(ends[1])) >= gap
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

    use super::*;
    use crate::conditions::bodies::Bodies;
    use crate::model::spec::{CableDefaultsSpec, PulleySpec, RobotSource};
    use crate::model::{BodySpec, Scene};
    use crate::testing::hard1;

    /// Ropes over pulleys at the corners of a cube, to attachments anywhere near the platform's origin.
    fn with_ropes(linear_density: f64, radius: f64, mut attachment: impl FnMut() -> [f64; 3]) -> Bodies {
        let mut spec = hard1().spec().clone();
        let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("the robot is in the scene") };
        let pulley = Some(PulleySpec { radius, axis: [0.0, 0.0, 1.0] });
        robot.cable = Some(CableDefaultsSpec {
            linear_density: Some(linear_density),
            sag_tension: Some(20.0),
            pulley,
            ..CableDefaultsSpec::default()
        });
        robot.cables.iter_mut().for_each(|cable| cable.attachment = attachment());
        robot.platform = vec![BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() }];
        Bodies::of(&Scene::new(spec).unwrap())
    }

    #[test]
    fn cables_that_are_clearly_apart_keep_their_distance() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(5);
        let mut decided = [0, 0];
        for (density, radius) in [(0.006, 0.02), (0.05, 0.05), (0.07, 0.001)] {
            for _ in 0..150 {
                let bodies = with_ropes(density, radius, || [(); 3].map(|()| rng.random_range(-0.5..0.5)));
                let mut at = || Point::from([(); 3].map(|()| rng.random_range(0.2..1.8)));
                let (from, near) = (at(), at());
                let to = from + (near - from) * 0.1;
                let (first, second) = (rng.random_range(0..8), rng.random_range(0..8));
                let [i, j] = [first, second].map(|k: usize| &bodies.cables[k]);
                if first == second {
                    continue;
                }
                let pair = HangingPair { cables: [i, j] };
                let least = pair.least(&from, &to);
                if least <= 1e-3 {
                    continue;
                }
                let gap = least * rng.random_range(0.8..1.05);
                let apart = least - gap;
                let clearly = pair.clearly_apart(gap, [&from, &to]);
                assert!(!clearly || apart >= -GAP_TOLERANCE, "{first}, {second}: {from}, {to}, gap {gap}, {apart}");
                if apart > 0.0 {
                    decided[usize::from(clearly)] += 1;
                }
            }
        }
        // The test must be worth its time.
        assert!(decided[1] > decided[0], "{decided:?}");
        println!("{decided:?}");
    }
}
