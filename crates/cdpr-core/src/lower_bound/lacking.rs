//! Convex polyhedra of positions where the cables certainly cannot provide the required wrenches.
//!
//! They are sought only where a path that is shorter than wanted would lead through such positions. There, the deepest one is chosen.
//! A plane goes through a position between it and the end of the wrenches that lack, across the gradient of the slack there: below the
//! plane, wrenches lack over some distance on all sides, since the facets of the available set bend little. A box around the deepest
//! position grows as long as a proof succeeds that wrenches lack in all of it that is below the plane. So where paths would be far too
//! short, polyhedra are large and rough, and they become finer as paths come closer to possible ones.
//!
//! The proof divides the box until a bound of the slack to one facet is negative in each part: the bounds by which `cdpr workspace`
//! decides boxes, but only for the positions below the plane. For a certificate, another proof has to succeed, too (`weak_boxes`).

use std::cell::Cell;

use super::free_edges::Ellipsoid;
use crate::certificate::WeakBox;
use crate::collision::{Checker, Unproved};
use crate::error::Error;
use crate::forbidden::HPolyhedron;
use crate::geometry::{Cuboid, HalfSpace, Point, Quadratic, Vector, path_length};
use crate::watch::Watch;

/// Positions at this distance are examined along a segment, as a share of the length of the ellipsoid.
const SPACING: f64 = 1.0 / 64.0;
/// Maximum number of positions examined along a segment.
const MOST_PLACES: usize = 16;
/// Half side of the boxes in which gradients are taken, as a share of the length of the ellipsoid.
const SMALL: f64 = 1e-4;
/// First step of the search for the end of the wrenches that lack, as a share of the length of the ellipsoid.
const STEP: f64 = 1.0 / 512.0;
/// The place where they end is found to this share of its distance.
const CLOSE: f64 = 1.0 / 16.0;
/// The plane leaves this share of that distance.
const RESERVE: f64 = 0.25;
/// A normal at the end is used if its cosine with the first one is at least this.
const ALIKE: f64 = 0.5;
/// Half side of the first box, as a share of that distance; it is at most this share of the length of the ellipsoid, too.
const FIRST: f64 = 0.25;
const LARGEST_FIRST: f64 = 1.0 / 32.0;
/// Number of times that the first box is halved at most.
const HALVINGS: usize = 4;
/// Boxes smaller than this share of the first one are not divided, and no face moves by less.
const LEAST: f64 = 0.25;
/// For a certificate, boxes smaller than this share of the first one are not divided.
const FINEST: f64 = LEAST / 256.0;
/// A polyhedron that reaches the end of the box of positions goes on beyond it, m.
const BEYOND: f64 = 1.0;
/// Shares of the slope of a function by which the height above a plane is weighted.
const WEIGHTS: [f64; 3] = [1.0, 0.8, 1.25];

/// Finds the polyhedra within an ellipsoid: paths as short as wanted do not leave it, so what is outside may be in them.
pub struct Lacking<'c> {
    checker: &'c dyn Checker,
    within: &'c Ellipsoid,
    low: Point,
    high: Point,
    judged: Cell<usize>,
    certifies: Option<&'c Certifies<'c>>,
}

/// Boxes by which a certificate shows that wrenches lack in the part of a box that is below a plane; `None` if it cannot, with parts of at
/// least about half some size, m. Only what writes certificates has it, so that it is no part of the page.
pub type Certifies<'c> = dyn Fn(&Cuboid, (&HalfSpace, f64), &Watch) -> Result<Option<Vec<WeakBox>>, Error> + 'c;

/// A polyhedron where wrenches lack.
#[derive(Debug, Clone)]
pub struct LackingPolyhedron {
    pub polyhedron: HPolyhedron,
    /// For a certificate, boxes that prove it.
    pub boxes: Vec<WeakBox>,
}

/// A position where wrenches lack, and about how far from there they do in the direction in which that ends soonest.
#[derive(Clone, Copy)]
struct Deep {
    place: Point,
    depth: f64,
    normal: Vector,
}

impl<'c> Lacking<'c> {
    /// Polyhedra in a box of positions; `None` if the scene requires no wrenches.
    pub fn new(checker: &'c dyn Checker, within: &'c Ellipsoid, [low, high]: [&Point; 2]) -> Option<Self> {
        let at_start = checker.wrench_over(&Cuboid::new(within.start, within.start), None);
        let requires_wrenches = at_start.is_none_or(|unproved| !unproved.is_empty());
        let lacking = Lacking { checker, within, low: *low, high: *high, judged: Cell::new(0), certifies: None };
        requires_wrenches.then_some(lacking)
    }

    /// Only polyhedra with boxes that prove them in a certificate.
    pub fn certified(self, certifies: &'c Certifies<'c>) -> Self {
        Lacking { certifies: Some(certifies), ..self }
    }

    /// Number of boxes and positions examined so far.
    pub fn judged(&self) -> usize {
        self.judged.get()
    }

    /// A polyhedron for each segment of a path that leads through positions where wrenches lack; none if the path is not shorter than
    /// wanted.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn on(&self, way: &[Point], watch: &Watch) -> Result<Vec<LackingPolyhedron>, Error> {
        let mut found = Vec::new();
        if way.len() < 2 || path_length(way) >= self.within.length {
            return Ok(found);
        }
        for pair in way.windows(2).filter(|pair| !self.checker.motion_valid(&pair[0], &pair[1])) {
            let Some(deep) = self.deepest(&pair[0], &pair[1], watch)? else { continue };
            let Some((depth, plane)) = self.plane(&deep) else { continue };
            found.extend(self.grown(&deep.place, depth, &plane, watch)?);
        }
        Ok(found)
    }

    /// Whether wrenches certainly lack at a position.
    fn lacks(&self, place: &Point) -> bool {
        self.judged.set(self.judged.get() + 1);
        self.checker.wrench_over(&Cuboid::new(*place, *place), None).is_none()
    }

    /// Among the examined positions of a segment where wrenches lack, the one that is deepest by the slope of the slack there.
    fn deepest(&self, from: &Point, to: &Point, watch: &Watch) -> Result<Option<Deep>, Error> {
        let count =
            ((to - from).norm() / (SPACING * self.within.length)).ceil().clamp(2.0, MOST_PLACES as f64) as usize;
        let mut best: Option<Deep> = None;
        for k in 0..count {
            watch.check()?;
            let place = from + (to - from) * ((k as f64 + 0.5) / count as f64);
            let deep = if self.lacks(&place) { self.facets(&place).into_iter().reduce(deeper) } else { None };
            best = best.into_iter().chain(deep).reduce(deeper);
        }
        Ok(best)
    }

    /// What lacks to each facet at a position.
    fn facets(&self, place: &Point) -> Vec<Deep> {
        let half = SMALL * self.within.length;
        let around = Cuboid::new(place - Vector::repeat(half), place + Vector::repeat(half));
        let slack = self.checker.wrench_slack(&around, None);
        let of = |side: &Quadratic| {
            let gradient = Vector::from(side.slope) / half;
            let normal = gradient.try_normalize(0.0)?;
            (side.at_center < 0.0).then(|| Deep { place: *place, depth: -side.at_center / gradient.norm(), normal })
        };
        slack.sides.iter().filter_map(of).collect()
    }

    /// How far wrenches lack from a position along the gradient, and a plane a little before the end.
    fn plane(&self, deep: &Deep) -> Option<(f64, HalfSpace)> {
        let at = |distance: f64| deep.place + deep.normal * distance;
        let [mut inside, mut outside] = [0.0, STEP * self.within.length];
        while self.lacks(&at(outside)) {
            inside = outside;
            if inside > self.within.length {
                return Some((inside, HalfSpace::through(&at(inside), deep.normal)));
            }
            outside *= 2.0;
        }
        while outside - inside > CLOSE * outside {
            let middle = 0.5 * (inside + outside);
            if self.lacks(&at(middle)) {
                inside = middle
            } else {
                outside = middle
            }
            if outside < 2.0 * SMALL * self.within.length {
                return None;
            }
        }
        let last = self.facets(&at(inside)).into_iter().reduce(|a, b| if b.depth < a.depth { b } else { a });
        let normal =
            last.map(|last| last.normal).filter(|normal| normal.dot(&deep.normal) >= ALIKE).unwrap_or(deep.normal);
        Some((inside, HalfSpace::through(&(at(inside) - normal * (RESERVE * inside)), normal)))
    }

    /// A box around a position, cut by a plane: as large as can be proved.
    fn grown(
        &self,
        place: &Point,
        depth: f64,
        plane: &HalfSpace,
        watch: &Watch,
    ) -> Result<Option<LackingPolyhedron>, Error> {
        let mut half = (FIRST * depth).min(LARGEST_FIRST * self.within.length);
        let around = |half: f64| Cuboid::new(place - Vector::repeat(half), place + Vector::repeat(half));
        let mut halvings = 0;
        while self.all_lack(&around(half), (plane, LEAST * half), watch)?.is_none() {
            halvings += 1;
            if halvings > HALVINGS {
                return Ok(None);
            }
            half *= 0.5;
        }
        let Cuboid { mut low, mut high, .. } = around(half);
        let mut steps = [4.0 * half; 6];
        while steps.iter().any(|step| *step >= LEAST * half) {
            for face in (0..6).filter(|face| steps[*face] >= LEAST * half).collect::<Vec<_>>() {
                let (axis, upward) = (face / 2, face % 2 == 1);
                let end = if upward { self.high[axis] } else { self.low[axis] };
                let (mut from, mut to) = (low, high);
                if upward {
                    (from[axis], to[axis]) = (high[axis], (high[axis] + steps[face]).min(end));
                } else {
                    (from[axis], to[axis]) = ((low[axis] - steps[face]).max(end), low[axis]);
                }
                if !(from[axis] < to[axis]) {
                    steps[face] = 0.0;
                } else if self.all_lack(&Cuboid::new(from, to), (plane, LEAST * half), watch)?.is_some() {
                    (low, high) = (low.inf(&from), high.sup(&to));
                    steps[face] *= 2.0;
                } else {
                    steps[face] *= 0.5;
                }
            }
        }
        // Boxes that grew one beside the other do not come from halving, as checkers expect it.
        let boxes = match self.certifies {
            None => Some(Vec::new()),
            Some(_) => self.all_lack(&Cuboid::new(low, high), (plane, FINEST * half), watch)?,
        };
        let Some(boxes) = boxes else { return Ok(None) };
        let side = |axis: usize, upward: bool| {
            let (corner, end) = if upward { (high, self.high) } else { (low, self.low) };
            let normal = Vector::ith(axis, if upward { 1.0 } else { -1.0 });
            let beyond = if corner[axis] == end[axis] { BEYOND } else { 0.0 };
            HalfSpace::through(&corner, normal).widened(beyond)
        };
        let sides = (0..6).map(|face| side(face / 2, face % 2 == 1));
        Ok(Some(LackingPolyhedron { polyhedron: HPolyhedron::exact(sides.chain([*plane]).collect()), boxes }))
    }

    /// Boxes, if a certificate needs them, that show that wrenches lack at all positions of a box that are below a plane and in the
    /// ellipsoid; `None` if that is not certain. Parts smaller than `least`, m, are not divided.
    fn all_lack(
        &self,
        positions: &Cuboid,
        (plane, least): (&HalfSpace, f64),
        watch: &Watch,
    ) -> Result<Option<Vec<WeakBox>>, Error> {
        let Some(certifies) = self.certifies else {
            return Ok(self.certainly_lack(positions, (plane, least), None, watch)?.then(Vec::new));
        };
        let boxes = certifies(positions, (plane, least), watch)?;
        self.judged.set(self.judged.get() + boxes.as_ref().map_or(1, Vec::len));
        Ok(boxes)
    }

    /// Whether wrenches certainly lack at all positions of a box that are below a plane and in the ellipsoid.
    fn certainly_lack(
        &self,
        positions: &Cuboid,
        (plane, least): (&HalfSpace, f64),
        known: Option<&[Unproved]>,
        watch: &Watch,
    ) -> Result<bool, Error> {
        let distance = |end: &Point| ((end - positions.center).abs() - positions.half).sup(&Vector::zeros()).norm();
        let via = distance(&self.within.start) + distance(&self.within.goal);
        if via >= self.within.length || positions.lowest(plane) >= 0.0 {
            return Ok(true);
        }
        watch.check()?;
        self.judged.set(self.judged.get() + 1);
        let Some(unproved) = self.checker.wrench_over(positions, known) else { return Ok(true) };
        if unproved.iter().all(|of| *of == Unproved::Nothing) {
            return Ok(false);
        }
        let slack = self.checker.wrench_slack(positions, Some(&unproved));
        if slack.sides.iter().any(|side| lowered(side, positions, plane).any(|(_, less)| less.greatest() < 0.0)) {
            return Ok(true);
        }
        let suffices = slack.complete && slack.sides.iter().all(|side| side.at_center >= side.below);
        if positions.half.max() < least || suffices && plane.height(&positions.center) < 0.0 {
            return Ok(false);
        }
        for part in positions.parts() {
            if !self.certainly_lack(&part, (plane, least), Some(&unproved), watch)? {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

fn deeper(a: Deep, b: Deep) -> Deep {
    if b.depth > a.depth { b } else { a }
}

/// A function over a box less some multiples of the height above a plane, with each multiple: where the box is below the plane, the
/// function is at most that.
pub fn lowered<'a>(
    side: &'a Quadratic,
    positions: &'a Cuboid,
    plane: &'a HalfSpace,
) -> impl Iterator<Item = (f64, Quadratic)> + use<'a> {
    let rise = plane.normal.component_mul(&positions.half);
    let along = Vector::from(side.slope).dot(&rise) / rise.norm_squared();
    WEIGHTS.iter().map(move |weight| {
        let factor = (weight * along).max(0.0);
        let mut less = *side;
        less.at_center -= factor * plane.height(&positions.center);
        (0..3).for_each(|axis| less.slope[axis] -= factor * rise[axis]);
        (factor, less)
    })
}
