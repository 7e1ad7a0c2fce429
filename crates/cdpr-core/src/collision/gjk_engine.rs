//! The paper's engine: GJK between obstacles and what platform and cables sweep (sections 3.1 and 3.2). It works for any
//! convex shape, yields distances, and is the reference for faster engines.

use super::constraint::{Constraint, Constraints, Demand};
use super::validity::{Clearance, Interference, Validity, Violation};
use crate::error::Error;
use crate::geometry::gjk::{nearer_than, overlap, shape_distance};
use crate::geometry::{Aabb, ConvexShape, Point, Polytope, Swept, Triangle, Vector, segment_segment};
use crate::model::Scene;
use crate::numerics::{BISECTION_STEPS, TOUCH_DEPTH};

/// Answers the constraints of a scene at its orientation by GJK.
///
/// # Example
/// ```
/// use cdpr_core::collision::{GjkEngine, Interference, Validity};
/// use cdpr_core::{geometry::Point, testing};
/// let scene = testing::hard1();
/// let engine = GjkEngine::new(&scene, Interference::Exact)?;
/// let (start, goal) = (scene.start().unwrap(), scene.goal().unwrap());
/// assert!(engine.state_valid(&start));
/// assert!(!engine.motion_valid(&start, &goal)); // the pillar stands in between
/// # Ok::<(), cdpr_core::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct GjkEngine {
    constraints: Constraints,
    interference: Interference,
}

impl GjkEngine {
    /// The engine for a scene.
    ///
    /// # Errors
    /// As [`Constraints::new`].
    pub fn new(scene: &Scene, interference: Interference) -> Result<Self, Error> {
        Ok(GjkEngine { constraints: Constraints::new(scene)?, interference })
    }

    /// The constraints that the engine answers.
    pub fn constraints(&self) -> &Constraints {
        &self.constraints
    }

    /// Whether no cable meets another or the platform at a position.
    pub fn free_of_interference(&self, position: &Point) -> bool {
        let internal = |c: &&Constraint| matches!(c, Constraint::CableCable(_) | Constraint::CablePlatform { .. });
        !self.constraints.list.iter().filter(internal).any(|c| self.breaks(c, position, position))
    }

    /// Whether a motion breaks one constraint.
    fn breaks(&self, constraint: &Constraint, from: &Point, to: &Point) -> bool {
        let c = &self.constraints;
        match constraint {
            Constraint::Workspace { .. } | Constraint::CableLength { .. } => {
                self.room(constraint, from, to) < -TOUCH_DEPTH
            }
            Constraint::CablePlatform { cable, body, demand } => {
                let cable = &c.cables[*cable];
                let along = |p: &Point| cable.outlet - (p + cable.arm);
                let sweep = || cable.sweep_seen_from_platform(from, to);
                cable_breaks(demand, sweep, [along(from), along(to)], &c.platform[*body])
            }
            Constraint::CableCable(pair) => {
                let swept = || {
                    let sweep = |cable: usize| c.cables[cable].sweep(from, to);
                    nearer_than(&sweep(pair.first), &sweep(pair.second), pair.gap.max(2.0 * TOUCH_DEPTH))
                };
                (pair.crosses(from, to))
                    || (self.interference == Interference::Swept && swept())
                    || (self.interference == Interference::Exact && pair.gap > 0.0 && pair.nearer_than_gap(from, to))
            }
            Constraint::PlatformObstacle { part, body, gap } => {
                let (part, obstacle) = (&c.platform[*part], &c.obstacles[*body]);
                let bounds = part.aabb().swept(&from.coords, &to.coords);
                let swept = Swept::new(part, from.coords, to - from);
                !bounds.apart_by(obstacle.body.aabb(), *gap)
                    && too_close(&swept, &obstacle.body, *gap, obstacle.seam.unwrap_or(TOUCH_DEPTH))
            }
            Constraint::CableObstacle { cable, body, demand } => {
                let cable = &c.cables[*cable];
                let along = |p: &Point| p + cable.arm - cable.outlet;
                let sweep = || cable.sweep(from, to);
                cable_breaks(demand, sweep, [along(from), along(to)], &c.obstacles[*body].body)
            }
        }
    }

    /// Room left in the workspace or in the length of a cable over a motion, m; negative outside.
    fn room(&self, constraint: &Constraint, from: &Point, to: &Point) -> f64 {
        match constraint {
            Constraint::Workspace { min, max } => {
                let room = |p: &Point| (p - min).inf(&(max - p)).min();
                room(from).min(room(to))
            }
            Constraint::CableLength { cable, min, max } => {
                let cable = &self.constraints.cables[*cable];
                let (p, q) = (from + cable.arm, to + cable.arm);
                let longest = (p - cable.outlet).norm().max((q - cable.outlet).norm());
                let shortest = segment_segment::closest(&p, &q, &cable.outlet, &cable.outlet).distance;
                (shortest - min).min(max - longest)
            }
            _ => f64::INFINITY,
        }
    }

    /// Gap in the world that a constraint is about, over a motion, m: distance or minus depth, of surfaces. None where
    /// no distance is to be kept: room, ends that touch by construction, pairs that can never keep what is demanded.
    fn gap(&self, constraint: &Constraint, from: &Point, to: &Point) -> Option<f64> {
        let counts = match constraint {
            Constraint::Workspace { .. } | Constraint::CableLength { .. } => false,
            Constraint::CableCable(pair) => !pair.excused,
            Constraint::PlatformObstacle { body, .. } => self.constraints.obstacles[*body].seam.is_none(),
            Constraint::CablePlatform { demand, .. } | Constraint::CableObstacle { demand, .. } => {
                matches!(demand, Demand::Apart { .. })
            }
        };
        counts.then(|| self.distance(constraint, from, to))
    }

    /// Distance or minus depth, of surfaces, between those whom a constraint is about, over a motion; for workspace and
    /// cable length the room left, m.
    fn distance(&self, constraint: &Constraint, from: &Point, to: &Point) -> f64 {
        let c = &self.constraints;
        match constraint {
            Constraint::Workspace { .. } | Constraint::CableLength { .. } => self.room(constraint, from, to),
            Constraint::CablePlatform { cable, body, .. } => {
                let cable = &c.cables[*cable];
                shape_distance(&cable.sweep_seen_from_platform(from, to), &c.platform[*body]).signed() - cable.radius
            }
            Constraint::CableCable(pair) => pair.least_distance(from, to).0 - pair.radii,
            Constraint::PlatformObstacle { part, body, .. } => {
                let swept = Swept::new(&c.platform[*part], from.coords, to - from);
                shape_distance(&swept, &c.obstacles[*body].body).signed()
            }
            Constraint::CableObstacle { cable, body, .. } => {
                let cable = &c.cables[*cable];
                shape_distance(&cable.sweep(from, to), &c.obstacles[*body].body).signed() - cable.radius
            }
        }
    }

    /// Whether a broken constraint is about a seam while the cable breaks that of a part beside the seam as well, which
    /// tells the true culprit and depth.
    fn told_by_others(&self, constraint: &Constraint, broken: &[&Constraint]) -> bool {
        let c = &self.constraints;
        let Constraint::CableObstacle { cable, body, .. } = constraint else { return false };
        let seam = &c.obstacles[*body];
        let part_beside = |other: &&Constraint| match other {
            Constraint::CableObstacle { cable: same, body, .. } => {
                let part = &c.obstacles[*body];
                same == cable && part.seam.is_none() && seam.between.contains(&part.between[0])
            }
            _ => false,
        };
        seam.seam.is_some() && broken.iter().any(part_beside)
    }

    /// Where and how badly a motion breaks a constraint that it is known to break.
    fn violation(&self, constraint: &Constraint, from: &Point, to: &Point) -> Violation {
        // What a motion sweeps only grows, so the first contact and the last are found by bisection on the whole test.
        let first = first_true(|t| self.breaks(constraint, from, &at(from, to, t)));
        let last = 1.0 - first_true(|t| self.breaks(constraint, &at(from, to, 1.0 - t), to));
        let margin = match constraint {
            Constraint::CableCable(pair) if self.interference == Interference::Swept => {
                // The triangles meet, maybe at different times: that is the gap this rule is about.
                let sweep = |cable: usize| self.constraints.cables[cable].sweep(from, to);
                shape_distance(&sweep(pair.first), &sweep(pair.second)).distance - pair.radii
            }
            Constraint::CableCable(_) | Constraint::Workspace { .. } | Constraint::CableLength { .. } => {
                self.distance(constraint, from, to)
            }
            _ => least_between(first, last, |t| self.distance(constraint, &at(from, to, t), &at(from, to, t))),
        };
        Violation {
            at: first,
            kind: self.constraints.kind(constraint),
            culprits: self.constraints.culprits(constraint),
            margin: Some(margin),
        }
    }
}

impl Validity for GjkEngine {
    fn state_valid(&self, position: &Point) -> bool {
        self.motion_valid(position, position)
    }

    fn motion_valid(&self, from: &Point, to: &Point) -> bool {
        let finite = from.iter().chain(to.iter()).all(|x| x.is_finite());
        finite && !self.constraints.list.iter().any(|constraint| self.breaks(constraint, from, to))
    }

    fn violations(&self, from: &Point, to: &Point) -> Vec<Violation> {
        let broken = self.constraints.list.iter().filter(|constraint| self.breaks(constraint, from, to));
        let broken: Vec<&Constraint> = broken.collect();
        let told = broken.iter().filter(|constraint| !self.told_by_others(constraint, &broken));
        let mut violations: Vec<Violation> = told.map(|constraint| self.violation(constraint, from, to)).collect();
        violations.sort_by(|a, b| a.at.total_cmp(&b.at).then(a.kind.cmp(&b.kind)));
        merge_parts(violations)
    }

    fn clearance(&self, from: &Point, to: &Point) -> Option<Clearance> {
        let gaps = self.constraints.list.iter().filter_map(|c| Some((self.gap(c, from, to)?, c)));
        let (value, nearest) = gaps.min_by(|a, b| a.0.total_cmp(&b.0))?;
        let reached = |t: f64| self.gap(nearest, from, &at(from, to, t)).is_some_and(|gap| gap <= value + TOUCH_DEPTH);
        Some(Clearance { value, at: first_true(reached), culprits: self.constraints.culprits(nearest) })
    }
}

/// One violation per kind and culprits: a body of several parts is one body.
fn merge_parts(violations: Vec<Violation>) -> Vec<Violation> {
    let mut merged: Vec<Violation> = Vec::new();
    for violation in violations {
        match merged.iter_mut().find(|v| v.kind == violation.kind && v.culprits == violation.culprits) {
            Some(known) => known.margin = known.margin.zip(violation.margin).map(|(a, b)| a.min(b)),
            None => merged.push(violation),
        }
    }
    merged
}

/// Whether a moving cable breaks a demand: by the triangle it sweeps, or by its direction (at the start and at the end of
/// the motion) from where it ends on the body.
#[inline]
fn cable_breaks(demand: &Demand, sweep: impl FnOnce() -> Triangle, along: [Vector; 2], body: &Polytope) -> bool {
    let (gap, touch) = match demand {
        Demand::Leave { normals } => return goes_below_all(normals, along[0], along[1]),
        Demand::Apart { gap } => (*gap, TOUCH_DEPTH),
        Demand::Outside { touch } => (0.0, *touch),
    };
    let cable = sweep();
    !Aabb::around(&cable.corners).apart_by(body.aabb(), gap) && too_close(&cable, body, gap, touch)
}

#[inline]
fn too_close(a: &impl ConvexShape, b: &impl ConvexShape, gap: f64, touch: f64) -> bool {
    if gap > 0.0 { nearer_than(a, b, gap) } else { overlap(a, b, touch) }
}

/// Whether a direction that goes linearly from `start` to `end` lies below all planes through the origin at some instant.
fn goes_below_all(normals: &[Vector], start: Vector, end: Vector) -> bool {
    let (mut low, mut high) = (0.0f64, 1.0f64);
    for normal in normals {
        let (a, b) = (normal.dot(&start) + TOUCH_DEPTH, normal.dot(&end) + TOUCH_DEPTH);
        match (a < 0.0, b < 0.0) {
            (true, true) => {}
            (false, false) => return false,
            (false, true) => low = low.max(a / (a - b)),
            (true, false) => high = high.min(a / (a - b)),
        }
    }
    low < high
}

fn at(from: &Point, to: &Point, t: f64) -> Point {
    if t >= 1.0 { *to } else { from + (to - from) * t }
}

/// The first t in [0, 1] where a test that stays true once it is true becomes true; it must be true at 1.
fn first_true(test: impl Fn(f64) -> bool) -> f64 {
    if test(0.0) {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..BISECTION_STEPS {
        let middle = 0.5 * (low + high);
        if test(middle) { high = middle } else { low = middle }
    }
    high
}

/// Least value of a function between two instants: samples, then golden sections around the best.
fn least_between(low: f64, high: f64, value: impl Fn(f64) -> f64) -> f64 {
    const SAMPLES: usize = 16;
    const SECTIONS: usize = 40;
    let step = (high - low).max(0.0) / SAMPLES as f64;
    let sample = |k: usize| (value(low + step * k as f64), k);
    let (mut least, k) = (0..=SAMPLES).map(sample).min_by(|a, b| a.0.total_cmp(&b.0)).expect("some samples");
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let (mut a, mut b) = (low + step * k.saturating_sub(1) as f64, low + step * (k + 1).min(SAMPLES) as f64);
    for _ in 0..SECTIONS {
        let (left, right) = (b - golden * (b - a), a + golden * (b - a));
        let (at_left, at_right) = (value(left), value(right));
        least = least.min(at_left).min(at_right);
        if at_left <= at_right { b = right } else { a = left }
    }
    least
}
