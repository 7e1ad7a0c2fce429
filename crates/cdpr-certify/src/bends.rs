//! Where a shortest path may bend, exactly: edges and corners of regions that no other region covers.
//!
//! A region looks like a cone C from a point x of its closure. Where a shortest path bends at x, from direction u to
//! direction v, a cone meets the angle between u and v, contains neither, and so meets the plane of u and v in less than a
//! half plane. So C is no half-space, and x lies on an edge of that region.
//!
//! - If another region's cone contains C, it blocks that angle as well, so C need not be considered: either x is inside the other
//!   region, or all planes of that region through x are planes of C as well. Of equal cones, the first one counts.
//! - Inside an edge, the edge crosses the plane of u and v. So a path bends at most once on each part of an edge outside all
//!   regions: between two bends it would run along the edge.
//! - At a corner at which no other region and no side of the box is near, a path never bends. Its cone C lies in a wedge between
//!   a plane through u and one through v. On the unit sphere, both ways around the wedge are 2π in all. One of them is shorter
//!   than π, or both are π and one can be cut short, since C does not contain both ends of the wedge's edge. So there is a
//!   shorter path beside the corner.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use cdpr_core::certificate::{BoundCertificate, EdgeRow};
use cdpr_core::error::Error;
use cdpr_core::geometry::Vector;
use cdpr_core::watch::Watch;

use crate::exact::{Exact, cross, dot, exact, exact3, minus, plus, times};
use crate::polyhedron::{Corner, HalfSpace, Place, corners_on_planes};

/// Largest distance of the listed place of a bend from the bend, m.
pub const NEAR: f64 = 1e-10;
/// Margin by which sums of lengths must exceed their limit where rounding could matter, m.
const SURPLUS: f64 = 1e-9;
/// Length below which a vector has no direction, m: the length of a unit vector made of it would not be accurate
/// enough.
pub const NO_DIRECTION: f64 = 1e-12;
/// Steps of a search along an edge.
const SEARCH_STEPS: usize = 100;
/// Half-spaces before those of the region: the sides of the box.
const SIDES: usize = 6;

/// Which parts of a certificate are needed.
pub struct Listed {
    /// For each edge: whether it is needed, and the two planes that a bend crosses, if exactly two planes meet there.
    pub edges: Vec<Option<Option<[usize; 2]>>>,
    /// For each corner, whether it is needed.
    pub corners: Vec<bool>,
    /// Maximum number of bends of a path.
    pub bends: usize,
}

/// Checks that a certificate lists all places where a path shorter than its length may bend.
pub fn listed(certificate: &BoundCertificate, watch: &Watch) -> Result<Listed, Error> {
    let edges = vec![None; certificate.edges.len()];
    let mut listed = Listed { edges, corners: vec![false; certificate.corners.len()], bends: 0 };
    let regions: Vec<Vec<HalfSpace>> =
        certificate.regions.iter().map(|region| region.half_spaces.iter().map(HalfSpace::of).collect()).collect();
    for index in 0..regions.len() {
        let mut finder = Finder { certificate, regions: &regions, index, listed: &mut listed, watch };
        finder.region().map_err(|e| e.under(&format!("regions[{index}]")))?;
    }
    Ok(listed)
}

/// Finds the bends at one region.
struct Finder<'a> {
    certificate: &'a BoundCertificate,
    regions: &'a [Vec<HalfSpace>],
    index: usize,
    listed: &'a mut Listed,
    watch: &'a Watch<'a>,
}

impl Finder<'_> {
    fn region(&mut self) -> Result<(), Error> {
        let corners = corners_on_planes(&self.certificate.bounds, &self.certificate.regions[self.index].half_spaces);
        let own = |on: &BTreeSet<usize>| on.iter().filter(|k| **k >= SIDES).map(|k| k - SIDES).collect::<Vec<_>>();
        let mut is_end = vec![false; corners.len()];
        for (a, from) in corners.iter().enumerate() {
            for (b, to) in corners.iter().enumerate().skip(a + 1) {
                let on = &from.on & &to.on;
                let planes = own(&on);
                let mut others = corners.iter().enumerate().filter(|(k, _)| ![a, b].contains(k));
                if self.is_edge(&planes) && others.all(|(_, third)| !on.is_subset(&third.on)) {
                    (is_end[a], is_end[b]) = (true, true);
                    self.edge(&planes, [&from.place, &to.place])?;
                }
            }
        }
        for (corner, is_end) in corners.iter().zip(is_end) {
            let planes = own(&corner.on);
            let is_pointed = self.is_pointed(&planes);
            if is_pointed || self.is_edge(&planes) && !is_end {
                self.corner(corner, &planes, is_pointed)?;
            }
        }
        Ok(())
    }

    fn half_spaces(&self) -> &[HalfSpace] {
        &self.regions[self.index]
    }

    /// Whether two of these planes are not parallel.
    fn is_edge(&self, planes: &[usize]) -> bool {
        let normal = |k: &usize| self.half_spaces()[*k].normal();
        let nonzero = |a, b| cross(normal(a), normal(b)).iter().any(|x| x.sign().is_ne());
        planes.iter().enumerate().any(|(k, a)| planes[k + 1..].iter().any(|b| nonzero(a, b)))
    }

    /// Whether these planes have only a point in common.
    fn is_pointed(&self, planes: &[usize]) -> bool {
        let normal = |k: &usize| self.half_spaces()[*k].normal();
        let volume = |a, b, c| dot(&cross(normal(a), normal(b)), normal(c)).sign().is_ne();
        let pairs = planes.iter().enumerate().flat_map(|(k, a)| planes[k + 1..].iter().map(move |b| (a, b)));
        pairs.into_iter().any(|(a, b)| planes.iter().any(|c| volume(a, b, c)))
    }

    /// The half-spaces of another region that are not among some of this one; `None` if that region has all of these
    /// and comes later, so that its cone does not replace this one.
    fn others_than(&self, planes: &[usize], other: usize) -> Option<Vec<&HalfSpace>> {
        let rows = |region: usize| &self.certificate.regions[region].half_spaces;
        let shared = |row: &[f64; 4]| planes.iter().any(|k| rows(self.index)[*k] == *row);
        let has_all = planes.iter().all(|k| rows(other).contains(&rows(self.index)[*k]));
        let all = self.regions[other].iter().zip(rows(other));
        (!has_all || other < self.index).then(|| all.filter(|(_, row)| !shared(row)).map(|(half, _)| half).collect())
    }

    /// Checks that every uncovered part of an edge is listed, unless every path through it is too long.
    fn edge(&mut self, planes: &[usize], ends: [&Place; 2]) -> Result<(), Error> {
        self.watch.check()?;
        let covers = (0..self.regions.len()).filter(|other| *other != self.index);
        let covers = covers.filter_map(|other| covered(&self.others_than(planes, other)?, ends)).collect();
        for gap in gaps(covers) {
            let places = gap.each_ref().map(|at| at.between(ends));
            if self.is_too_far(&places) {
                continue;
            }
            self.listed.bends += 1;
            let crossed = <[usize; 2]>::try_from(planes).ok();
            let of_edge = |row: &EdgeRow| {
                row.region == self.index
                    && row.planes[0] != row.planes[1]
                    && row.planes.iter().all(|k| planes.contains(k))
            };
            let rows = self.certificate.edges.iter().enumerate().filter(|(_, row)| of_edge(row));
            let mut rows = rows.filter(|(_, row)| places.iter().all(|place| is_near(place, &row.ends)));
            if let Some((k, _)) = rows.next() {
                self.listed.edges[k] = Some(crossed);
            } else if !self.at_corner(&places) {
                let [a, b] = places.map(|place| -> [f64; 3] { place.to_f64().into() });
                let problem = format!("found an edge that is free from {a:?} to {b:?}, expected it among the edges");
                return Err(Error::invalid("", problem));
            }
        }
        Ok(())
    }

    /// Checks that a corner where a path may bend is listed.
    fn corner(&mut self, corner: &Corner, planes: &[usize], is_pointed: bool) -> Result<(), Error> {
        self.watch.check()?;
        let height = |half: &HalfSpace| half.height(&corner.place).sign();
        let others = || (0..self.regions.len()).filter(|other| *other != self.index);
        let dominated =
            |other| self.others_than(planes, other).is_some_and(|rest| rest.iter().all(|h| height(h).is_lt()));
        let near = |other: usize| self.regions[other].iter().all(|half| height(half).is_le());
        let is_alone = is_pointed && corner.on.iter().all(|k| *k >= SIDES) && !others().any(near);
        let place = [corner.place.clone(), corner.place.clone()];
        if is_alone || others().any(dominated) || self.is_too_far(&place) {
            return Ok(());
        }
        self.listed.bends += 1;
        if self.at_corner(&place) {
            return Ok(());
        }
        let at: [f64; 3] = corner.place.to_f64().into();
        Err(Error::invalid("", format!("found a corner at {at:?} that is free, expected it among the corners")))
    }

    /// Whether two places are near one listed corner; marks that corner as needed.
    fn at_corner(&mut self, places: &[Place; 2]) -> bool {
        let near = |[x, y, z, _]: &[f64; 4]| places.iter().all(|place| is_near(place, &[[*x, *y, *z]; 2]));
        let found = self.certificate.corners.iter().position(near);
        found.iter().for_each(|k| self.listed.corners[*k] = true);
        found.is_some()
    }

    /// Whether all ways from the start through a segment to the goal are at least as long as the certificate's length:
    /// the length is convex, so a tangent decides.
    fn is_too_far(&self, [a, b]: &[Place; 2]) -> bool {
        let ends = [Vector::from(self.certificate.start), Vector::from(self.certificate.goal)];
        let [a, b] = [a.to_f64(), b.to_f64()];
        let via = |t: f64| ends.iter().map(|end| (a + (b - a) * t - end).norm()).sum::<f64>();
        let [mut low, mut high] = [0.0, 1.0];
        for _ in 0..SEARCH_STEPS {
            let [s, t] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
            if via(s) <= via(t) { high = t } else { low = s }
        }
        let lowest = a
            + (b - a)
                * [0.0, 0.5 * (low + high), 1.0].into_iter().min_by(|s, t| via(*s).total_cmp(&via(*t))).unwrap_or(0.5);
        let tangent = |x: &Vector| ends.iter().map(|end| unit(&(lowest - end)).dot(&(x - end))).sum::<f64>();
        tangent(&a).min(tangent(&b)) >= self.certificate.length + SURPLUS
    }
}

/// The direction of a vector; zero if it has none.
pub fn unit(v: &Vector) -> Vector {
    v.try_normalize(NO_DIRECTION).unwrap_or_default()
}

/// A fraction of an edge: `above` / `below`, which is positive.
#[derive(Clone)]
struct Share {
    above: Exact,
    below: Exact,
}

impl Share {
    fn of(x: f64) -> Self {
        Share { above: exact(x), below: exact(1.0) }
    }

    fn order(&self, other: &Share) -> Ordering {
        (&self.above * &other.below - &other.above * &self.below).sign()
    }

    fn larger(self, other: Share) -> Share {
        if self.order(&other).is_lt() { other } else { self }
    }

    /// The place at this fraction.
    fn between(&self, [from, to]: [&Place; 2]) -> Place {
        let weights = [(&self.below - &self.above) * &to.scale, &self.above * &from.scale];
        let at = plus(&times(&weights[0], &from.at), &times(&weights[1], &to.at));
        Place { at, scale: &self.below * &(&from.scale * &to.scale) }
    }
}

/// The open part of an edge inside half-spaces; it begins before 0 or ends after 1 if it contains that end.
fn covered(half_spaces: &[&HalfSpace], [from, to]: [&Place; 2]) -> Option<[Share; 2]> {
    let (mut low, mut high) = (Share::of(-1.0), Share::of(2.0));
    for half in half_spaces {
        let (a, b) = (half.height(from) * &to.scale, half.height(to) * &from.scale);
        let crossing = || match (&a - &b).sign() {
            Ordering::Less => Share { above: -&a, below: &b - &a },
            _ => Share { above: a.clone(), below: &a - &b },
        };
        match (a.sign().is_lt(), b.sign().is_lt()) {
            (true, true) => {}
            (true, false) => high = if crossing().order(&high).is_lt() { crossing() } else { high },
            (false, true) => low = low.larger(crossing()),
            (false, false) => return None,
        }
    }
    low.order(&high).is_lt().then_some([low, high])
}

/// The closed parts of an edge, perhaps single points, that open parts leave.
fn gaps(mut covers: Vec<[Share; 2]>) -> Vec<[Share; 2]> {
    covers.sort_by(|a, b| a[0].order(&b[0]));
    let mut at = Share::of(0.0);
    let mut gaps = Vec::new();
    for [low, high] in covers {
        if low.order(&at).is_ge() && at.order(&Share::of(1.0)).is_le() {
            gaps.push([at.clone(), low]);
        }
        at = at.larger(high);
    }
    if at.order(&Share::of(1.0)).is_le() {
        gaps.push([at, Share::of(1.0)]);
    }
    gaps
}

/// Whether a place is within [`NEAR`] of a segment: the nearest point is guessed, the distance is exact.
fn is_near(place: &Place, ends: &[[f64; 3]; 2]) -> bool {
    let [from, to] = ends.map(Vector::from);
    let along = to - from;
    let share = (place.to_f64() - from).dot(&along) / along.norm_squared();
    let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
    let at = plus(&exact3(&from), &times(&exact(share), &minus(&exact3(&to), &exact3(&from))));
    let gap = minus(&place.at, &times(&place.scale, &at));
    let reach = exact(NEAR) * &place.scale;
    dot(&gap, &gap) <= &reach * &reach
}
