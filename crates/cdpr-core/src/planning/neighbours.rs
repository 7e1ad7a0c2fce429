//! Nearest-neighbour search: a k-d tree of points (J. L. Bentley, 1975) that grows with the nodes, with a few points
//! per leaf.
//!
//! All boxes are tight, because most samples of a search are far from the whole tree. For any order of insertion,
//! answers are exact and no function recurses.

use super::space::StateSpace;
use super::tree::Tree;
use crate::geometry::Point;
use crate::tolerances::ROUNDING;

/// Points in a leaf before it is divided; scanning this many costs about as much as one more level.
const LEAF: usize = 16;

/// Points of nodes 0, 1, 2, …
///
/// The caller provides distances as a function of the node; they must never be smaller than the distances of the
/// points. Among nodes at equal distance the older one counts as nearest.
///
/// # Example
/// ```
/// use cdpr_core::{Point, planning::Neighbours};
/// let places = [Point::new(0.0, 0.0, 0.0), Point::new(1.0, 0.0, 0.0), Point::new(0.0, 2.0, 0.0)];
/// let mut neighbours = Neighbours::default();
/// places.iter().for_each(|place| neighbours.push(*place));
/// let target = Point::new(0.0, 1.5, 0.0);
/// let distance = |node: usize| (places[node] - target).norm();
/// assert_eq!(neighbours.nearest(&target, distance), Some(2));
/// let mut near = neighbours.within(&target, 1.6, distance);
/// near.sort_by(|a, b| a.0.total_cmp(&b.0));
/// assert_eq!(near, [(0.5, 2), (1.5, 0)]);
/// ```
#[derive(Debug, Clone, Default)]
pub struct Neighbours {
    count: usize,
    places: Vec<Point>,
    cells: Vec<Cell>,
    stack: Vec<(f64, usize)>,
}

/// Number of points up to which a linear scan is faster than the tree.
const IN_LINE: usize = 512;

/// Up to `COUNT` nodes by squared distance, m².
#[derive(Debug, Clone)]
pub struct Few<const COUNT: usize> {
    nodes: [usize; COUNT],
    squares: [f64; COUNT],
    count: usize,
}

impl<const COUNT: usize> Few<COUNT> {
    fn new() -> Self {
        Few { nodes: [0; COUNT], squares: [f64::INFINITY; COUNT], count: 0 }
    }

    #[inline]
    fn see(&mut self, node: usize, square: f64) {
        if square < self.squares[COUNT - 1] {
            let mut at = COUNT - 1;
            while at > 0 && self.squares[at - 1] > square {
                (self.squares[at], self.nodes[at]) = (self.squares[at - 1], self.nodes[at - 1]);
                at -= 1;
            }
            (self.squares[at], self.nodes[at]) = (square, node);
            self.count = (self.count + 1).min(COUNT);
        }
    }

    /// Distance within which another node would be one of the nearest, m.
    fn reach(&self) -> f64 {
        self.squares[COUNT - 1].sqrt()
    }

    /// The nodes, nearest first.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes[..self.count]
    }
}

/// A bounding box of points: divided in two, or a leaf.
#[derive(Debug, Clone)]
struct Cell {
    min: [f64; 3],
    max: [f64; 3],
    content: Content,
}

#[derive(Debug, Clone)]
enum Content {
    Leaf(Vec<([f64; 3], usize)>),
    /// The child with points below the threshold; the other child follows it.
    Divided {
        axis: usize,
        threshold: f64,
        below: usize,
    },
}

impl Neighbours {
    /// Adds the point of the next node.
    pub fn push(&mut self, place: Point) {
        self.places.push(place);
    }

    /// Inserts points that were added since the last query into the tree.
    fn catch_up(&mut self) {
        for node in self.count..self.places.len() {
            self.insert(node, self.places[node].into());
        }
        self.count = self.places.len();
    }

    fn insert(&mut self, node: usize, place: [f64; 3]) {
        if node == 0 {
            self.cells.push(Cell::leaf(vec![(place, node)]));
            return;
        }
        let mut at = 0;
        loop {
            let cell = &mut self.cells[at];
            cell.extend(&place);
            match &mut cell.content {
                Content::Divided { axis, threshold, below } => at = *below + usize::from(place[*axis] >= *threshold),
                Content::Leaf(places) => {
                    places.push((place, node));
                    if places.len() > LEAF {
                        self.divide(at);
                    }
                    return;
                }
            }
        }
    }

    /// Divides a leaf in the middle of its longest side; if all points coincide, they stay together.
    fn divide(&mut self, leaf: usize) {
        let below = self.cells.len();
        let Cell { min, max, content } = &mut self.cells[leaf];
        let axis = (0..3).max_by(|a, b| (max[*a] - min[*a]).total_cmp(&(max[*b] - min[*b]))).expect("three axes");
        let middle = min[axis] + 0.5 * (max[axis] - min[axis]);
        let threshold = if middle > min[axis] { middle } else { max[axis] };
        if !(threshold > min[axis]) {
            return;
        }
        let Content::Leaf(places) = std::mem::replace(content, Content::Divided { axis, threshold, below }) else {
            return; // not a leaf
        };
        let (low, high) = places.into_iter().partition(|(place, _)| place[axis] < threshold);
        self.cells.extend([Cell::leaf(low), Cell::leaf(high)]);
    }

    /// `Nearest` of the paper; `None` if there are no nodes.
    pub fn nearest(&mut self, target: &Point, distance: impl Fn(usize) -> f64) -> Option<usize> {
        self.catch_up();
        let mut best = (f64::INFINITY, usize::MAX);
        self.visit(target, f64::INFINITY, |node| {
            let found = (distance(node), node);
            if found < best {
                best = found;
            }
            best.0
        });
        (best.1 != usize::MAX).then_some(best.1)
    }

    /// `Near` of the paper: distances and indices of all nodes within a radius, in no particular order.
    pub fn within(&mut self, target: &Point, radius: f64, distance: impl Fn(usize) -> f64) -> Vec<(f64, usize)> {
        self.catch_up();
        let mut found = Vec::new();
        self.visit(target, radius, |node| {
            let far = distance(node);
            if far <= radius {
                found.push((far, node));
            }
            radius
        });
        found
    }

    /// The node of a tree that is nearest to a state.
    pub(super) fn nearest_to<S: StateSpace>(&mut self, space: &S, tree: &Tree<S>, state: &S::State) -> Option<usize> {
        self.nearest(&space.place(state), |node| space.distance(tree.state(node), state))
    }

    /// The nodes whose points are nearest, nearest first; fewer if there are not enough.
    pub fn nearest_few<const COUNT: usize>(&mut self, target: &Point) -> Few<COUNT> {
        let mut few = Few::new();
        if self.places.len() < IN_LINE {
            self.places.iter().enumerate().for_each(|(node, place)| few.see(node, (place - target).norm_squared()));
            return few;
        }
        self.catch_up();
        let places = std::mem::take(&mut self.places);
        self.visit(target, f64::INFINITY, |node| {
            few.see(node, (places[node] - target).norm_squared());
            few.reach()
        });
        self.places = places;
        few
    }

    /// The nodes of a tree near a state, with their distances.
    pub(super) fn near<S: StateSpace>(
        &mut self,
        space: &S,
        tree: &Tree<S>,
        state: &S::State,
        radius: f64,
    ) -> Vec<(f64, usize)> {
        self.within(&space.place(state), radius, |node| space.distance(tree.state(node), state))
    }

    /// Calls `see` for every node whose point is within reach; `see` returns the new reach. Closer boxes come first.
    fn visit(&mut self, target: &Point, reach: f64, mut see: impl FnMut(usize) -> f64) {
        let target: [f64; 3] = (*target).into();
        let squared = |reach: f64| reach * reach * (1.0 + ROUNDING); // includes a point exactly at the reach
        let mut limit = squared(reach);
        self.stack.clear();
        self.stack.extend((!self.cells.is_empty()).then_some((0.0, 0)));
        while let Some((gap, cell)) = self.stack.pop() {
            if gap > limit {
                continue;
            }
            match &self.cells[cell].content {
                Content::Leaf(places) => {
                    for (place, node) in places {
                        if square(|axis| place[axis] - target[axis]) <= limit {
                            limit = squared(see(*node));
                        }
                    }
                }
                Content::Divided { below, .. } => {
                    let mut children = [*below, *below + 1].map(|child| (self.cells[child].gap(&target), child));
                    if children[0].0 < children[1].0 {
                        children.swap(0, 1);
                    }
                    self.stack.extend(children.iter().filter(|(gap, _)| *gap <= limit));
                }
            }
        }
    }
}

impl Cell {
    fn leaf(places: Vec<([f64; 3], usize)>) -> Self {
        let (min, max) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        let mut cell = Cell { min, max, content: Content::Leaf(Vec::new()) };
        places.iter().for_each(|(place, _)| cell.extend(place));
        cell.content = Content::Leaf(places);
        cell
    }

    fn extend(&mut self, place: &[f64; 3]) {
        for axis in 0..3 {
            self.min[axis] = self.min[axis].min(place[axis]);
            self.max[axis] = self.max[axis].max(place[axis]);
        }
    }

    /// Squared distance of a point from the box.
    fn gap(&self, p: &[f64; 3]) -> f64 {
        square(|axis| (self.min[axis] - p[axis]).max(p[axis] - self.max[axis]).max(0.0))
    }
}

fn square(coordinate: impl Fn(usize) -> f64) -> f64 {
    let [x, y, z] = [0, 1, 2].map(coordinate);
    x * x + y * y + z * z
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    /// Random points, some duplicated, or many on a grid so that ties are frequent.
    fn places(seed: u64, grid: bool) -> Vec<Point> {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut number = || if grid { f64::from(rng.random_range(0..4)) } else { rng.random::<f64>() };
        (0..500).map(|_| Point::new(number(), number(), number())).collect()
    }

    #[test]
    fn nearest_matches_exhaustive_search() {
        for seed in 0..20 {
            let places = places(seed, seed % 2 == 1);
            let targets = self::places(100 + seed, seed % 4 == 1);
            let mut tree = Neighbours::default();
            for (k, target) in targets.iter().enumerate() {
                tree.push(places[k]);
                let distance = |node: usize| (places[node] - target).norm();
                let nearest = (0..=k).min_by(|a, b| distance(*a).total_cmp(&distance(*b)));
                assert_eq!(tree.nearest(target, distance), nearest);
                let mut near = tree.within(target, 0.3, distance);
                near.sort_by_key(|(_, node)| *node);
                let all: Vec<(f64, usize)> = (0..=k).map(|n| (distance(n), n)).filter(|(d, _)| *d <= 0.3).collect();
                assert_eq!(near, all);
            }
        }
    }

    #[test]
    fn an_empty_tree_has_no_nearest_node_and_deep_trees_work() {
        let mut tree = Neighbours::default();
        assert_eq!(tree.nearest(&Point::origin(), |_| 0.0), None);
        (0..20_000).for_each(|_| tree.push(Point::origin()));
        assert_eq!(tree.nearest(&Point::origin(), |_| 0.0), Some(0));
    }
}
