//! Which intervals a straight segment may connect.
//!
//! Most of the time of a bound goes into this question, and most of that into polyhedra that might block the segment.
//! So each link remembers the polyhedra that may block a part of it, and between parts of its intervals only these are
//! tried: soon few are left.

use std::collections::BinaryHeap;

use super::super::interval::{Label, Sides, Sight};
use super::labelling::Next;
use super::{GOAL, Neighbour, Network, START, node};
use crate::batch::each;
use crate::error::Error;
use crate::forbidden::Near;
use crate::geometry::{Point, Vector};
use crate::tolerances::SAME_POINT;
use crate::watch::Watch;

/// Number of intervals from which on links are searched in parallel.
const IN_PARALLEL: usize = 200;
/// Up to this many polyhedra, all are tried between whole edges; otherwise those near the segments.
const FEW: usize = 64;

/// The links of an interval to those with larger indices.
#[derive(Default)]
pub struct Links {
    links: Vec<Link>,
    /// The polyhedra that may block a part of a link, of one link after the other.
    hulls: Vec<u32>,
    /// Number of pairs of intervals examined.
    examined: usize,
}

/// A link: the other interval, on which sides of their edges the two intervals see each other, and the range of its polyhedra.
#[derive(Clone, Copy)]
struct Link {
    to: u32,
    sides: [Sides; 2],
    hulls: [u32; 2],
}

impl Links {
    fn hulls(&self, link: &Link) -> &[u32] {
        &self.hulls[link.hulls[0] as usize..link.hulls[1] as usize]
    }
}

impl Network<'_> {
    /// Finds the links of all intervals.
    pub(super) fn link_all(&mut self, watch: &Watch) -> Result<(), Error> {
        let found = each(self.len(), IN_PARALLEL, &|near: &mut Near, at| {
            watch.check()?;
            let (mut links, mut hint) = (Links::default(), None);
            for to in at + 1..self.len() {
                self.link_anew(&mut links, [at, to], &mut hint, near);
            }
            Ok(links)
        })?;
        self.take(found);
        Ok(())
    }

    /// Finds the links of the parts of intervals, given the parts of each interval and the links of whole ones that are
    /// `still_open`.
    pub(super) fn link_parts(
        &mut self,
        parts: &[Vec<usize>],
        still_open: &[Vec<bool>],
        watch: &Watch,
    ) -> Result<(), Error> {
        let old = std::mem::take(&mut self.onward);
        let found = each(parts.len(), IN_PARALLEL, &|(), whole| {
            watch.check()?;
            let of_part = |&at: &usize| self.links_of_part(at, parts, (&parts[whole], &old[whole], &still_open[whole]));
            Ok(parts[whole].iter().map(of_part).collect::<Vec<Links>>())
        })?;
        self.take(found.into_iter().flatten().collect());
        Ok(())
    }

    /// The links of a part of an interval, given the parts of the whole, its links, and which of them are open.
    fn links_of_part(
        &self,
        at: usize,
        parts: &[Vec<usize>],
        (beside, whole, still_open): (&[usize], &Links, &[bool]),
    ) -> Links {
        let mut links = Links::default();
        for &to in beside.iter().filter(|to| **to > at) {
            self.link(&mut links, [at, to], &[]); // all on one free edge: nothing blocks it
        }
        for (link, _) in whole.links.iter().zip(still_open).filter(|(_, open)| **open) {
            for &to in &parts[link.to as usize] {
                self.link(&mut links, [at, to], whole.hulls(link));
            }
        }
        links
    }

    /// For each interval, which of its links are on paths that are short enough.
    pub(super) fn still_open(&self) -> Vec<Vec<bool>> {
        let is_open = |at: usize, link: &Link| self.certified || self.through([at, link.to as usize], link.sides);
        let of = |(at, links): (usize, &Links)| links.links.iter().map(|link| is_open(at, link)).collect();
        self.onward.iter().enumerate().map(of).collect()
    }

    fn take(&mut self, found: Vec<Links>) {
        self.links = vec![Vec::new(); self.intervals.len()];
        for (at, links) in found.iter().enumerate() {
            self.examined += links.examined;
            for &Link { to, sides: [leaving, arriving], .. } in &links.links {
                self.links[at].push(Neighbour { at: to, leaving, arriving });
                self.links[to as usize].push(Neighbour { at: at as u32, leaving: arriving, arriving: leaving });
            }
        }
        self.onward = found;
    }

    /// Adds a link between two whole edges if there is one. The polyhedron that blocked the last pair is tried first.
    fn link_anew(&self, links: &mut Links, [at, to]: [usize; 2], hint: &mut Option<u32>, near: &mut Near) {
        let (from, other, list) = (&self.intervals[at], &self.intervals[to], self.hulls.list());
        let blocks = |hull: u32| self.sight([at, to], hull) == Sight::Blocked;
        links.examined += 1;
        let Some(sides) = self.sides([at, to]).filter(|_| !hint.is_some_and(blocks)) else { return };
        let blocker = if list.len() <= FEW {
            self.link_past(links, [at, to], sides, 0..list.len() as u32)
        } else {
            let reach = 0.5 * from.length.max(other.length);
            let hulls = self.hulls.near_within(&[from.middle(), other.middle()], reach, near);
            self.link_past(links, [at, to], sides, hulls.iter().copied())
        };
        *hint = blocker.or(*hint);
    }

    /// Adds a link between two parts if there is one, given the polyhedra that may be in the way.
    fn link(&self, links: &mut Links, [at, to]: [usize; 2], hulls: &[u32]) {
        links.examined += 1;
        if let Some(sides) = self.sides([at, to]) {
            self.link_past(links, [at, to], sides, hulls.iter().copied());
        }
    }

    /// Adds a link unless one of some polyhedra blocks it, which is returned.
    fn link_past(
        &self,
        links: &mut Links,
        [at, to]: [usize; 2],
        sides: [Sides; 2],
        hulls: impl Iterator<Item = u32>,
    ) -> Option<u32> {
        let first = links.hulls.len();
        for hull in hulls {
            match self.sight([at, to], hull) {
                Sight::Free => {}
                Sight::Partial => links.hulls.push(hull),
                Sight::Blocked => {
                    links.hulls.truncate(first);
                    return Some(hull);
                }
            }
        }
        links.links.push(Link { to: to as u32, sides, hulls: [first as u32, links.hulls.len() as u32] });
        None
    }

    /// How many of the segments between two intervals a polyhedron blocks; not all if the intervals touch.
    fn sight(&self, [at, to]: [usize; 2], hull: u32) -> Sight {
        let (from, other) = (&self.intervals[at], &self.intervals[to]);
        let touch = || (from.middle() - other.middle()).norm() < SAME_POINT;
        match from.sight(other, &self.hulls.list()[hull as usize]) {
            Sight::Blocked if touch() => Sight::Partial,
            sight => sight,
        }
    }

    /// On which sides of their edges two intervals see each other, if a path that is short enough may lead straight from one to the
    /// other, either way, as far as the labels and the edges themselves tell. A certificate does not distinguish sides.
    fn sides(&self, [a, b]: [usize; 2]) -> Option<[Sides; 2]> {
        let (from, to) = (&self.intervals[a], &self.intervals[b]);
        if self.certified {
            return from.may_connect(to).then_some([[true, false]; 2]);
        }
        if !self.nearly_through(a, b).contains(&true) || !from.may_run_along(to) {
            return None;
        }
        let sides = [from.sides_towards(to), to.sides_towards(from)];
        let may_bend = sides.iter().all(|sides| sides.contains(&true));
        (may_bend && self.through([a, b], sides)).then_some(sides)
    }

    /// Whether a path with a segment between two intervals, which see each other on some sides of their edges, may be short
    /// enough, as far as the labels tell.
    fn through(&self, [a, b]: [usize; 2], [of_a, of_b]: [Sides; 2]) -> bool {
        let one_way = |[a, b]: [usize; 2], [of_a, of_b]: [Sides; 2]| {
            let before = (0..2).filter(|side| of_a[*side]).map(|side| self.labels[START][self.across(node(a, side))]);
            let after = |side: usize| self.labels[GOAL][self.across(node(b, side))];
            before.filter(|label| *label != Label::UNKNOWN).any(|before| {
                let label = self.intervals[b].continued(&self.intervals[a], &before);
                (0..2).any(|side| of_b[side] && label.plus(&after(side)).least() < self.limit())
            })
        };
        let [there, back] = self.nearly_through(a, b);
        there && one_way([a, b], [of_a, of_b]) || back && one_way([b, a], [of_b, of_a])
    }

    /// The shortest path through middles of linked intervals, which no polyhedron blocks; empty if there is none (E. W. Dijkstra,
    /// 1959).
    pub fn shortest_way(&self) -> Vec<Point> {
        let mut links: Vec<Vec<(u32, &[u32])>> = vec![Vec::new(); self.len()];
        for (at, onward) in self.onward.iter().enumerate() {
            for link in &onward.links {
                links[at].push((link.to, onward.hulls(link)));
                links[link.to as usize].push((at as u32, onward.hulls(link)));
            }
        }
        let mut reached = vec![(f64::INFINITY, START); self.len()];
        reached[START].0 = 0.0;
        let mut queue = BinaryHeap::from([Next { least: 0.0, at: START as u32 }]);
        while let Some(Next { least, at }) = queue.pop() {
            let at = at as usize;
            if at == GOAL {
                break;
            }
            if least > reached[at].0 {
                continue;
            }
            let from = self.intervals[at].middle();
            for &(to, hulls) in &links[at] {
                let along = self.intervals[to as usize].middle() - from;
                let length = least + along.norm();
                if length < reached[to as usize].0 && !self.is_blocked((&from, &along), hulls) {
                    reached[to as usize] = (length, at);
                    queue.push(Next { least: length, at: to });
                }
            }
        }
        let mut chain = vec![GOAL];
        while reached[GOAL].0.is_finite() && chain[chain.len() - 1] != START {
            chain.push(reached[chain[chain.len() - 1]].1);
        }
        chain.reverse();
        if chain.len() < 2 { Vec::new() } else { chain.iter().map(|&at| self.intervals[at].middle()).collect() }
    }

    /// Whether one of some polyhedra contains a part of a segment.
    fn is_blocked(&self, (from, along): (&Point, &Vector), hulls: &[u32]) -> bool {
        let inside = |hull: &u32| self.hulls.list()[*hull as usize].inside_within(from, along, [0.0, 1.0]);
        let depth = 2.0 * SAME_POINT / along.norm();
        hulls.iter().filter_map(inside).any(|[from, to]| to - from > depth)
    }

    /// Whether a path with a segment between two intervals may be short enough, for each direction: a rough, quick
    /// test.
    fn nearly_through(&self, a: usize, b: usize) -> [bool; 2] {
        let (from, to) = (&self.intervals[a], &self.intervals[b]);
        let apart = (from.middle() - to.middle()).norm();
        let left = self.limit() - (apart - 0.5 * (from.length + to.length) - from.blur(to)).max(0.0);
        let least = |end: usize, at: usize| {
            let [a, b] = self.of_interval(end, at);
            a.least().min(b.least())
        };
        [least(START, a) + least(GOAL, b) < left, least(START, b) + least(GOAL, a) < left]
    }
}
