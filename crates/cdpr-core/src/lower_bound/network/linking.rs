//! Which intervals a straight segment may connect.
//!
//! Most of the time of a bound goes into this question, and most of that into polyhedra that might block the segment.
//! So each link remembers the polyhedra that may block a part of it, and between parts of its intervals only these are
//! tried: soon few are left.

use rayon::prelude::*;

use super::super::interval::Sight;
use super::Network;
use crate::error::Error;
use crate::forbidden::Near;
use crate::numerics::SAME_POINT;
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

/// A link: the other interval, and the range of its polyhedra.
#[derive(Clone, Copy)]
struct Link {
    to: u32,
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
        let found = in_order(self.len(), &|near, at| {
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
        let found = in_order(parts.len(), &|_, whole| {
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
        let is_open = |at: usize, link: &Link| self.certified || self.through(at, link.to as usize);
        let of = |(at, links): (usize, &Links)| links.links.iter().map(|link| is_open(at, link)).collect();
        self.onward.iter().enumerate().map(of).collect()
    }

    fn take(&mut self, found: Vec<Links>) {
        self.links = vec![Vec::new(); self.intervals.len()];
        for (at, links) in found.iter().enumerate() {
            self.examined += links.examined;
            for Link { to, .. } in &links.links {
                self.links[at].push(*to);
                self.links[*to as usize].push(at as u32);
            }
        }
        self.onward = found;
    }

    /// Adds a link between two whole edges if there is one. The polyhedron that blocked the last pair is tried first.
    fn link_anew(&self, links: &mut Links, [at, to]: [usize; 2], hint: &mut Option<u32>, near: &mut Near) {
        let (from, other, list) = (&self.intervals[at], &self.intervals[to], self.hulls.list());
        let blocks = |hull: u32| self.sight([at, to], hull) == Sight::Blocked;
        if !self.may_connect(at, to) || hint.is_some_and(blocks) {
            links.examined += 1;
            return;
        }
        let blocker = if list.len() <= FEW {
            self.link_past(links, [at, to], 0..list.len() as u32)
        } else {
            let reach = 0.5 * from.length.max(other.length);
            let hulls = self.hulls.near_within(&[from.middle(), other.middle()], reach, near);
            self.link_past(links, [at, to], hulls.iter().copied())
        };
        *hint = blocker.or(*hint);
    }

    /// Adds a link between two parts if there is one, given the polyhedra that may be in the way.
    fn link(&self, links: &mut Links, [at, to]: [usize; 2], hulls: &[u32]) {
        if self.may_connect(at, to) {
            self.link_past(links, [at, to], hulls.iter().copied());
        } else {
            links.examined += 1;
        }
    }

    /// Adds a link unless one of some polyhedra blocks it, which is returned.
    fn link_past(&self, links: &mut Links, [at, to]: [usize; 2], hulls: impl Iterator<Item = u32>) -> Option<u32> {
        let first = links.hulls.len();
        links.examined += 1;
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
        links.links.push(Link { to: to as u32, hulls: [first as u32, links.hulls.len() as u32] });
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

    /// Whether a path that is short enough may lead straight from one interval to another, either way, as far as the
    /// labels and the edges themselves tell.
    fn may_connect(&self, a: usize, b: usize) -> bool {
        let (from, to) = (&self.intervals[a], &self.intervals[b]);
        if self.certified {
            return from.may_connect(to);
        }
        self.nearly_through(a, b).contains(&true)
            && from.may_run_along(to)
            && from.may_bend_towards(to)
            && to.may_bend_towards(from)
            && self.through(a, b)
    }

    /// Whether a path with a segment between two intervals may be short enough, as far as the labels tell.
    fn through(&self, a: usize, b: usize) -> bool {
        let [f, g] = &self.labels;
        let continued = |a: usize, b: usize| self.intervals[b].continued(&self.intervals[a], &f[a]);
        let one_way = |a: usize, b: usize| continued(a, b).plus(&g[b]).least() < self.limit();
        let [there, back] = self.nearly_through(a, b);
        there && one_way(a, b) || back && one_way(b, a)
    }

    /// The same for each direction, roughly and quickly.
    fn nearly_through(&self, a: usize, b: usize) -> [bool; 2] {
        let (from, to) = (&self.intervals[a], &self.intervals[b]);
        let apart = (from.middle() - to.middle()).norm();
        let left = self.limit() - (apart - 0.5 * (from.length + to.length) - from.blur(to)).max(0.0);
        let [f, g] = &self.labels;
        [f[a].least() + g[b].least() < left, f[b].least() + g[a].least() < left]
    }
}

/// What is found for each index, in order, on several threads if that pays.
fn in_order<T: Send>(
    count: usize,
    found: &(dyn Fn(&mut Near, usize) -> Result<T, Error> + Sync),
) -> Result<Vec<T>, Error> {
    if count >= IN_PARALLEL {
        return (0..count).into_par_iter().map_init(Near::default, found).collect();
    }
    let mut near = Near::default();
    (0..count).map(|at| found(&mut near, at)).collect()
}
