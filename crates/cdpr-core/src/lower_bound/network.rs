//! Intervals of free edges, and which of them a straight segment may connect.

mod linking;

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::interval::{Interval, Label};
use crate::error::Error;
use crate::forbidden::HPolyhedra;
use crate::geometry::Point;
use crate::numerics::{LABEL_STEP, SAME_POINT};
use crate::watch::Watch;
use linking::Links;

/// Indices of the two intervals that are points.
pub const START: usize = 0;
pub const GOAL: usize = 1;

/// Changes of a label after which it becomes constant. Constant labels cannot lower each other for ever.
const MOST_CHANGES: u8 = 12;
/// The same for certificates, which have no other way to settle.
const MOST_CHANGES_CERTIFIED: u8 = 200;
/// Changes of a label after which it is what constant labels everywhere give.
const MOST_CHANGES_IN_ALL: u8 = 60;
/// Rounds in which the points of a path slide along their intervals.
const SLIDES: usize = 8;
/// The rest of an interval, beside the part that matters, becomes a part of its own from this share of the length on.
const BESIDE: f64 = 1.0 / 8.0;
/// Labels between two checks of the watch.
const POLL: usize = 256;

/// The labels from one end.
struct Labels {
    labels: Vec<Label>,
    /// For each interval the one from which its label comes.
    before: Vec<u32>,
    /// Number of links passed.
    passed: usize,
}

/// What may lie on a path from start to goal that is short enough.
pub struct Network<'h> {
    hulls: &'h HPolyhedra,
    /// For a certificate: the labels from the start alone prove the bound, without those of earlier rounds.
    certified: bool,
    /// Paths of at least this length do not matter, m.
    enough: f64,
    intervals: Vec<Interval>,
    /// Lower bounds of the distance from start and from goal.
    labels: [Vec<Label>; 2],
    /// For each interval those with a larger or smaller index to which a segment may lead.
    links: Vec<Vec<u32>>,
    /// The same links, each once, with the polyhedra that may block a part of them.
    onward: Vec<Links>,
    /// For each interval the one from which its label from the start comes.
    before: Vec<u32>,
    /// The largest number of intervals so far.
    most: usize,
    /// Number of pairs of intervals examined so far.
    examined: usize,
}

impl<'h> Network<'h> {
    /// Start, goal and intervals, with all links.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn new(
        hulls: &'h HPolyhedra,
        [start, goal]: [&Point; 2],
        intervals: impl Iterator<Item = Interval>,
        (enough, certified): (f64, bool),
        watch: &Watch,
    ) -> Result<Self, Error> {
        let ends = [Interval::point(*start), Interval::point(*goal)];
        let intervals: Vec<Interval> = ends.into_iter().chain(intervals).collect();
        let labels = ends.each_ref().map(|end| straight(end, &intervals));
        let (most, links) = (intervals.len(), vec![Vec::new(); intervals.len()]);
        let (onward, before, examined) = (Vec::new(), Vec::new(), 0);
        let mut network =
            Network { hulls, certified, enough, intervals, labels, links, onward, before, most, examined };
        network.link_all(watch)?;
        Ok(network)
    }

    /// Number of intervals.
    pub fn len(&self) -> usize {
        self.intervals.len()
    }

    /// Number of pairs of intervals examined so far.
    pub fn examined(&self) -> usize {
        self.examined
    }

    /// What sums of labels have to reach for a path to be long enough: labels may be too large by [`LABEL_STEP`] for each
    /// bend. A shortest path bends at most twice on each interval, since it keeps to an interval between two of its points.
    fn limit(&self) -> f64 {
        self.enough + self.error()
    }

    fn error(&self) -> f64 {
        if self.certified {
            return 0.0;
        }
        LABEL_STEP * (2 * self.most + 2) as f64
    }

    /// Labels all intervals anew, from the goal and from the start; returns a lower bound of the length of all paths, m:
    /// infinite if none is short enough, `None` if this takes more than some effort.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn label(&mut self, effort: usize, watch: &Watch) -> Result<Option<f64>, Error> {
        for end in [GOAL, START] {
            let Some(Labels { labels: new, before, passed }) =
                self.labels_from(end, [&[], &self.labels[1 - end]], effort, watch)?
            else {
                return Ok(None);
            };
            self.before = before;
            self.examined += passed;
            for (old, new) in self.labels[end].iter_mut().zip(new) {
                *old = old.higher(&new);
            }
        }
        Ok(Some(self.labels[START][GOAL].least() - self.error()))
    }

    /// Labels all intervals anew as a certificate needs it: without what is known from earlier rounds. The label of the goal, m,
    /// infinite if no path is short enough; `None` if this takes more than some effort.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn certify(&mut self, effort: usize, watch: &Watch) -> Result<Option<f64>, Error> {
        for end in [GOAL, START] {
            let behind = straight(&self.intervals[end], &self.intervals);
            // The checkers place the tangent of the way that is left in the middle.
            let left = |to: &Interval| to.continued_at(0.5, &self.intervals[1 - end], &Label::constant(0.0));
            let ahead: Vec<Label> = self.intervals.iter().map(left).collect();
            let Some(Labels { labels, passed, .. }) = self.labels_from(end, [&behind, &ahead], effort, watch)? else {
                return Ok(None);
            };
            self.examined += passed;
            self.labels[end] = labels;
        }
        Ok(Some(self.labels[START][GOAL].least()))
    }

    /// Whether the label of the goal shows that no path is short enough.
    pub fn is_proved(&self) -> bool {
        self.labels[START][GOAL].least() >= self.enough
    }

    /// The intervals with their labels from the start, without start and goal.
    pub fn labelled(&self) -> impl Iterator<Item = (&Interval, &Label)> {
        self.intervals.iter().zip(&self.labels[START]).skip(2)
    }

    /// The labels from an end, which fall until none exceeds what its neighbours allow; `None` if more than some number of links
    /// would have to be passed. They do not fall below `floors`, if there are any.
    fn labels_from(
        &self,
        end: usize,
        [floors, ahead]: [&[Label]; 2],
        effort: usize,
        watch: &Watch,
    ) -> Result<Option<Labels>, Error> {
        let mut labels = vec![Label::UNKNOWN; self.len()];
        let mut before = vec![end as u32; self.len()];
        let mut changes = vec![0u8; self.len()];
        let mut waiting = vec![false; self.len()];
        let mut queue = BinaryHeap::from([Next { least: 0.0, at: end as u32 }]);
        let mut distances = None;
        let most = if self.certified { MOST_CHANGES_CERTIFIED } else { MOST_CHANGES };
        (labels[end], waiting[end]) = (Label::constant(0.0), true);
        let (mut count, mut passed) = (0, 0);
        while let Some(Next { at, .. }) = queue.pop() {
            let at = at as usize;
            if !std::mem::take(&mut waiting[at]) {
                continue;
            }
            count += 1;
            passed += self.links[at].len();
            if passed > effort {
                return Ok(None);
            }
            if count % POLL == 0 {
                watch.check()?;
            }
            for to in self.links[at].iter().map(|&to| to as usize).filter(|&to| to != end) {
                let is_constant = |k: usize| changes[k] >= most;
                let mut new = if is_constant(to) && is_constant(at) {
                    Label::constant(labels[at].least() + self.intervals[to].distance(&self.intervals[at]))
                } else {
                    self.intervals[to].continued(&self.intervals[at], &labels[at])
                };
                if is_constant(to) {
                    new = Label::constant(new.least());
                }
                let falls = (0..2).any(|k| new.0[k] < labels[to].0[k] - LABEL_STEP);
                let at_floor = floors.get(to) == Some(&labels[to]);
                let is_settled = at_floor || !self.certified && changes[to] == MOST_CHANGES_IN_ALL;
                if !falls || is_settled || new.plus(&ahead[to]).least() >= self.limit() {
                    continue;
                }
                before[to] = at as u32;
                if to == 1 - end {
                    labels[to] = labels[to].lower(&new); // the search ends there
                    continue;
                }
                changes[to] += u8::from(!self.certified || changes[to] < most);
                labels[to] = match changes[to] {
                    1 => new,
                    count if count == most => Label::constant(labels[to].lower(&new).least()),
                    MOST_CHANGES_IN_ALL if !self.certified => {
                        let distances = distances.get_or_insert_with(|| self.distances_from(end));
                        self.labels[end][to].higher(&Label::constant(distances[to]))
                    }
                    _ => labels[to].lower(&new),
                };
                if let Some(floor) = floors.get(to) {
                    labels[to] = labels[to].higher(floor);
                }
                waiting[to] = true;
                queue.push(Next { least: labels[to].plus(&ahead[to]).least(), at: to as u32 });
            }
        }
        Ok(Some(Labels { labels, before, passed }))
    }

    /// Sums of distances between linked intervals from an end: E. W. Dijkstra (1959). Rougher than linear labels, but sound where
    /// those do not settle.
    fn distances_from(&self, end: usize) -> Vec<f64> {
        let mut distances = vec![f64::INFINITY; self.len()];
        let mut queue = BinaryHeap::from([Next { least: 0.0, at: end as u32 }]);
        distances[end] = 0.0;
        while let Some(Next { least, at }) = queue.pop() {
            let at = at as usize;
            if least > distances[at] {
                continue;
            }
            for to in self.links[at].iter().map(|&to| to as usize) {
                let distance = least + self.intervals[to].distance(&self.intervals[at]);
                if distance < distances[to] {
                    distances[to] = distance;
                    queue.push(Next { least: distance, at: to as u32 });
                }
            }
        }
        distances
    }

    /// Keeps the parts of intervals that may lie on a path that is short enough, halved if they are longer than `least`,
    /// m; returns whether any was halved.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn refine(&mut self, least: f64, watch: &Watch) -> Result<bool, Error> {
        let mut children: Vec<Vec<usize>> = vec![vec![START], vec![GOAL]];
        let mut intervals = self.intervals[..2].to_vec();
        let mut labels = self.labels.each_ref().map(|labels| labels[..2].to_vec());
        let mut halved = false;
        for at in 2..self.len() {
            let own = self.labels.each_ref().map(|labels| labels[at]);
            let kept = own[START].plus(&own[GOAL]).below(self.limit());
            let first = intervals.len();
            let parts: Vec<[f64; 2]> = match self.certified {
                false => kept.into_iter().flat_map(|part| halves(part, self.intervals[at].length, least)).collect(),
                true => kept.map_or(vec![[0.0, 1.0]], |part| divided(part, self.intervals[at].length, least)),
            };
            for part in parts {
                intervals.push(self.intervals[at].part(part));
                (0..2).for_each(|end| labels[end].push(own[end].part(part)));
            }
            halved |= intervals.len() > first + 1;
            children.push((first..intervals.len()).collect());
        }
        let still_open = self.still_open();
        (self.intervals, self.labels) = (intervals, labels);
        self.most = self.most.max(self.len());
        self.link_parts(&children, &still_open, watch)?;
        Ok(halved)
    }

    /// The shortest path over the intervals from which the label of the goal comes; empty if there is none.
    pub fn cheapest_way(&self) -> Vec<Point> {
        let mut chain = vec![GOAL];
        while chain[chain.len() - 1] != START {
            let before = self.before[chain[chain.len() - 1]] as usize;
            if chain.contains(&before) || self.labels[START][before] == Label::UNKNOWN {
                return Vec::new();
            }
            chain.push(before);
        }
        let chain: Vec<&Interval> = chain.iter().rev().map(|&at| &self.intervals[at]).collect();
        let mut way: Vec<Point> = chain.iter().map(|interval| interval.middle()).collect();
        for _ in 0..SLIDES {
            for k in 1..way.len() - 1 {
                way[k] = chain[k].nearest_way([&way[k - 1], &way[k + 1]]);
            }
        }
        way.dedup_by(|a, b| (*a - *b).norm() < SAME_POINT);
        way
    }
}

/// Lower bounds of the distance from an end to intervals, by straight lines.
fn straight(end: &Interval, intervals: &[Interval]) -> Vec<Label> {
    intervals.iter().map(|interval| interval.continued(end, &Label::constant(0.0))).collect()
}

/// A whole interval of some length in parts: the part that matters in halves, and what is beside it unless that is short.
fn divided([from, to]: [f64; 2], length: f64, least: f64) -> Vec<[f64; 2]> {
    if length <= least {
        return vec![[0.0, 1.0]];
    }
    let [from, to] = [if from < BESIDE { 0.0 } else { from }, if to > 1.0 - BESIDE { 1.0 } else { to }];
    if to - from < BESIDE {
        return vec![[0.0, 0.5], [0.5, 1.0]]; // no tiny parts
    }
    let cuts = [0.0, from, 0.5 * (from + to), to, 1.0];
    cuts.windows(2).map(|pair| [pair[0], pair[1]]).filter(|[from, to]| from < to).collect()
}

/// A part of an interval of some length, or both halves of the part if it is longer than `least`, m.
fn halves([from, to]: [f64; 2], length: f64, least: f64) -> Vec<[f64; 2]> {
    if length * (to - from) <= least {
        return vec![[from, to]];
    }
    let middle = 0.5 * (from + to);
    vec![[from, middle], [middle, to]]
}

/// An interval whose label fell; the smallest is next.
#[derive(PartialEq)]
struct Next {
    least: f64,
    at: u32,
}

impl Eq for Next {}

impl Ord for Next {
    fn cmp(&self, other: &Self) -> Ordering {
        other.least.total_cmp(&self.least).then(other.at.cmp(&self.at))
    }
}

impl PartialOrd for Next {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
