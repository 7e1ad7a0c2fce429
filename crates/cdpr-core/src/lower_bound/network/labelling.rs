//! Labels of all intervals from start or goal.
//!
//! Labels are lowered until none exceeds what its neighbours allow, as in label-correcting shortest-path algorithms. With linear
//! labels this need not terminate, because they can keep lowering each other in a cycle. So a label becomes constant after a
//! number of changes, and after further changes it is replaced by a sum of distances.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::super::interval::Label;
use super::{Neighbour, Network, node};
use crate::error::Error;
use crate::tolerances::LABEL_STEP;
use crate::watch::Watch;

/// Changes of a label after which it becomes constant. Constant labels cannot lower each other forever.
const MOST_CHANGES: u8 = 12;
/// Changes of a label after which it becomes constant in a search for a certificate, which has no other way to settle.
const MOST_CHANGES_CERTIFIED: u8 = 200;
/// Changes of a label after which it is replaced by the value that it has if all labels are constant.
const MOST_CHANGES_IN_ALL: u8 = 16;
/// Labels between two checks of the watch.
const POLL: usize = 256;

/// The labels from one end.
pub struct Labels {
    pub labels: Vec<Label>,
    /// For each node, the node from which its label comes.
    pub before: Vec<u32>,
    /// Number of links passed.
    pub passed: usize,
}

/// Labels from one end while they fall.
struct Falling<'n, 'h> {
    network: &'n Network<'h>,
    end: usize,
    /// Labels do not fall below these, if there are any.
    floors: &'n [Label],
    /// Labels from the other end: lower bounds of the remaining distance.
    ahead: &'n [Label],
    labels: Vec<Label>,
    before: Vec<u32>,
    changes: Vec<u8>,
    /// Changes after which a label becomes constant.
    most: u8,
    waiting: Vec<bool>,
    queue: BinaryHeap<Next>,
    /// Sums of distances from the end, once they are needed.
    distances: Option<Vec<f64>>,
}

impl Network<'_> {
    /// The labels from an end, which fall until none exceeds what its neighbours allow; `None` if more than some number of links
    /// would have to be passed. They do not fall below `floors`, if there are any.
    pub(super) fn labels_from(
        &self,
        end: usize,
        [floors, ahead]: [&[Label]; 2],
        effort: usize,
        watch: &Watch,
    ) -> Result<Option<Labels>, Error> {
        let mut falling = Falling::new(self, end, [floors, ahead]);
        let (mut count, mut passed) = (0, 0);
        while let Some(at) = falling.next() {
            count += 1;
            if passed > effort {
                return Ok(None);
            }
            if count % POLL == 0 {
                watch.check()?;
            }
            let leaving = self.across(at) % 2;
            let is_onward = |link: &&Neighbour| link.leaving[leaving] && link.at as usize != end;
            for Neighbour { at: to, arriving, .. } in self.links[at / 2].iter().filter(is_onward) {
                passed += 1;
                for side in (0..2).filter(|side| arriving[*side]) {
                    falling.pass(at, node(*to as usize, side));
                }
            }
        }
        let Falling { labels, before, .. } = falling;
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
            for to in self.links[at].iter().map(|link| link.at as usize) {
                let distance = least + self.intervals[to].distance(&self.intervals[at]);
                if distance < distances[to] {
                    distances[to] = distance;
                    queue.push(Next { least: distance, at: to as u32 });
                }
            }
        }
        distances
    }
}

impl<'n, 'h> Falling<'n, 'h> {
    fn new(network: &'n Network<'h>, end: usize, [floors, ahead]: [&'n [Label]; 2]) -> Self {
        let (nodes, first) = (2 * network.len(), node(end, 0));
        let mut labels = vec![Label::UNKNOWN; nodes];
        labels[first..first + 2].fill(Label::constant(0.0));
        let mut waiting = vec![false; nodes];
        waiting[first] = true;
        Falling {
            network,
            end,
            floors,
            ahead,
            labels,
            before: vec![first as u32; nodes],
            changes: vec![0; nodes],
            most: if network.certified { MOST_CHANGES_CERTIFIED } else { MOST_CHANGES },
            waiting,
            queue: BinaryHeap::from([Next { least: 0.0, at: first as u32 }]),
            distances: None,
        }
    }

    /// The next node whose label fell.
    fn next(&mut self) -> Option<usize> {
        loop {
            let at = self.queue.pop()?.at as usize;
            if std::mem::take(&mut self.waiting[at]) {
                return Some(at);
            }
        }
    }

    /// Lowers the label of a node to what a linked one allows.
    fn pass(&mut self, at: usize, to: usize) {
        let new = self.continued(at, to);
        let ahead = &self.ahead[self.network.across(to)];
        if !self.may_fall(to, &new) || new.plus(ahead).least() >= self.network.limit() {
            return;
        }
        self.before[to] = at as u32;
        if to / 2 == 1 - self.end {
            self.labels[to] = self.labels[to].lower(&new); // the search ends there
            return;
        }
        self.changes[to] += u8::from(!self.network.certified || self.changes[to] < self.most);
        self.labels[to] = self.lowered(to, &new);
        self.waiting[to] = true;
        self.queue.push(Next { least: self.labels[to].plus(ahead).least(), at: to as u32 });
    }

    /// The largest label that the label of a node allows for a linked node.
    fn continued(&self, at: usize, to: usize) -> Label {
        let [from, interval] = [at, to].map(|node| &self.network.intervals[node / 2]);
        let is_constant = |node: usize| self.changes[node] >= self.most;
        match (is_constant(at), is_constant(to)) {
            (true, true) => Label::constant(self.labels[at].least() + interval.distance(from)),
            (false, true) => Label::constant(interval.continued(from, &self.labels[at]).least()),
            (_, false) => interval.continued(from, &self.labels[at]),
        }
    }

    /// Whether a label has to fall, and may.
    fn may_fall(&self, to: usize, new: &Label) -> bool {
        let label = &self.labels[to];
        let falls = (0..2).any(|k| new.0[k] < label.0[k] - LABEL_STEP);
        let is_settled = !self.network.certified && self.changes[to] == MOST_CHANGES_IN_ALL;
        falls && !is_settled && self.floors.get(to) != Some(label)
    }

    /// The label of a node after one more change.
    fn lowered(&mut self, to: usize, new: &Label) -> Label {
        let lower = self.labels[to].lower(new);
        let label = match self.changes[to] {
            1 => *new,
            count if count == self.most => Label::constant(lower.least()),
            MOST_CHANGES_IN_ALL if !self.network.certified => {
                let distances = self.distances.get_or_insert_with(|| self.network.distances_from(self.end));
                self.network.labels[self.end][to].higher(&Label::constant(distances[to / 2]))
            }
            _ => lower,
        };
        self.floors.get(to).map_or(label, |floor| label.higher(floor))
    }
}

/// An entry of a queue from which the smallest value is taken first.
#[derive(PartialEq)]
pub(super) struct Next {
    pub least: f64,
    pub at: u32,
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
