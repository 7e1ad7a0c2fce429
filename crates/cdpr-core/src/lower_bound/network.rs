//! Intervals of free edges, what is known about paths through them, and their refinement.

mod labelling;
mod linking;

use super::interval::{Interval, Label, Sides};
use crate::error::Error;
use crate::forbidden::HPolyhedra;
use crate::geometry::Point;
use crate::tolerances::{LABEL_STEP, SAME_POINT};
use crate::watch::Watch;
use labelling::Labels;
use linking::Links;

/// Indices of the two intervals that are points.
pub const START: usize = 0;
pub const GOAL: usize = 1;

/// Rounds in which the points of a path slide along their intervals.
const SLIDES: usize = 8;
/// The rest of an interval beside the part that matters becomes a separate part if it is at least this share of the
/// length.
const BESIDE: f64 = 1.0 / 8.0;

/// An interval to which a segment may lead from another, and on which sides of their edges the two see each other.
#[derive(Clone, Copy)]
struct Neighbour {
    at: u32,
    leaving: Sides,
    arriving: Sides,
}

/// Everything that may lie on a sufficiently short path from start to goal.
pub struct Network<'h> {
    hulls: &'h HPolyhedra,
    /// For a certificate: the labels from the start alone prove the bound, without those of earlier rounds.
    certified: bool,
    /// Paths of at least this length do not matter, m.
    enough: f64,
    intervals: Vec<Interval>,
    /// Lower bounds of the distance from start and from goal, for each node: an interval, and the side of its edge on which
    /// paths from there arrive. They leave on the other side, or they would not be shortest.
    labels: [Vec<Label>; 2],
    /// For each interval those with a larger or smaller index to which a segment may lead.
    links: Vec<Vec<Neighbour>>,
    /// Every link of `links` once, with the polyhedra that may block a part of it.
    onward: Vec<Links>,
    /// For each node, the node from which its label from the start comes.
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

    /// A path is long enough if its sum of labels reaches this. Labels may be too large by [`LABEL_STEP`] for each bend, and a
    /// shortest path bends at most twice on each interval: between two points of an interval it stays on the interval.
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
        Ok(Some(self.goal_label() - self.error()))
    }

    /// Labels all intervals anew as a certificate needs it: without what is known from earlier rounds. The label of the goal, m,
    /// infinite if no path is short enough; `None` if this takes more than some effort.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn certify(&mut self, effort: usize, watch: &Watch) -> Result<Option<f64>, Error> {
        for end in [GOAL, START] {
            let behind = straight(&self.intervals[end], &self.intervals);
            // For the remaining path to the goal, the checkers place the tangent in the middle.
            let left = |to: &Interval| to.continued_at(0.5, &self.intervals[1 - end], &Label::constant(0.0));
            let ahead: Vec<Label> = self.intervals.iter().map(left).flat_map(|label| [label; 2]).collect();
            let Some(Labels { labels, passed, .. }) = self.labels_from(end, [&behind, &ahead], effort, watch)? else {
                return Ok(None);
            };
            self.examined += passed;
            self.labels[end] = labels;
        }
        Ok(Some(self.goal_label()))
    }

    /// The label of the goal, m.
    fn goal_label(&self) -> f64 {
        self.labels[START][node(GOAL, 0)].least()
    }

    /// The node of the other side of an interval. A certificate does not distinguish sides: all paths arrive on the
    /// first.
    fn across(&self, node: usize) -> usize {
        if self.certified { node } else { node ^ 1 }
    }

    /// The labels from an end on an interval, for both sides.
    fn of_interval(&self, end: usize, at: usize) -> [Label; 2] {
        [0, 1].map(|side| self.labels[end][node(at, side)])
    }

    /// Whether the label of the goal shows that no path is short enough.
    pub fn is_proved(&self) -> bool {
        self.goal_label() >= self.enough
    }

    /// The intervals with their labels from the start, without start and goal.
    pub fn labelled(&self) -> impl Iterator<Item = (&Interval, &Label)> {
        self.intervals.iter().zip(self.labels[START].iter().step_by(2)).skip(2)
    }

    /// Keeps the parts of intervals that may lie on a path that is short enough, halved if they are longer than `least`,
    /// m; returns whether any was halved.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn refine(&mut self, least: f64, watch: &Watch) -> Result<bool, Error> {
        let mut children: Vec<Vec<usize>> = vec![vec![START], vec![GOAL]];
        let mut intervals = self.intervals[..2].to_vec();
        let mut labels = self.labels.each_ref().map(|labels| labels[..node(2, 0)].to_vec());
        let mut halved = false;
        for at in 2..self.len() {
            let own = [START, GOAL].map(|end| self.of_interval(end, at));
            let kept = (0..2).filter_map(|side| {
                let after = self.across(side);
                own[START][side].plus(&own[GOAL][after]).below(self.limit())
            });
            let kept = kept.reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]);
            let first = intervals.len();
            let parts: Vec<[f64; 2]> = match self.certified {
                false => kept.into_iter().flat_map(|part| halves(part, self.intervals[at].length, least)).collect(),
                true => kept.map_or(vec![[0.0, 1.0]], |part| divided(part, self.intervals[at].length, least)),
            };
            for part in parts {
                intervals.push(self.intervals[at].part(part));
                (0..2).for_each(|end| labels[end].extend(own[end].map(|label| label.part(part))));
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
        let (start, mut chain) = (node(START, 0), vec![node(GOAL, 0)]);
        while chain[chain.len() - 1] != start {
            let before = self.before[chain[chain.len() - 1]] as usize;
            if chain.contains(&before) || self.labels[START][before] == Label::UNKNOWN {
                return Vec::new();
            }
            chain.push(before);
        }
        let chain: Vec<&Interval> = chain.iter().rev().map(|&at| &self.intervals[at / 2]).collect();
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

/// The node of an interval and a side.
fn node(at: usize, side: usize) -> usize {
    2 * at + side
}

/// Lower bounds of the distance from an end to intervals, on both sides, by straight lines.
fn straight(end: &Interval, intervals: &[Interval]) -> Vec<Label> {
    let of = |interval: &Interval| [interval.continued(end, &Label::constant(0.0)); 2];
    intervals.iter().flat_map(of).collect()
}

/// Divides a whole interval of some length: the part that matters into halves, and the rest beside it into separate
/// parts unless
/// they are short.
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
