//! Boxes that tile a box, and what is connected through touching ones. Coordinates are only compared, never computed
//! with, so this is exact.

use cdpr_core::certificate::Bounds;
use cdpr_core::error::Error;
use cdpr_core::geometry::Vector;

/// Whether two boxes have a point in common.
pub fn touch(a: &Bounds, b: &Bounds) -> bool {
    (0..3).all(|k| a[0][k] <= b[1][k] && b[0][k] <= a[1][k])
}

/// The box that is a single point.
pub fn point(p: &[f64; 3]) -> Bounds {
    [*p, *p]
}

/// Maximum number of nested cuts: halving a box this many times leaves less than the smallest number.
const DEEPEST: usize = 500;

/// A tree of cuts, and the boxes that are still in it.
pub struct Tiling<'a> {
    boxes: &'a [Bounds],
    nodes: Vec<Node>,
}

/// Whether any box of this branch is still in the tree.
struct Node {
    bounds: Bounds,
    kept: bool,
    content: Content,
}

enum Content {
    Leaf(usize),
    Halves([usize; 2]),
}

impl<'a> Tiling<'a> {
    /// Proves that the boxes tile `bounds`: either there is one box and it equals `bounds`, or a plane that passes
    /// through no box cuts `bounds` into two, and the boxes on either side tile these.
    ///
    /// # Errors
    /// The boxes do not tile `bounds`, or not in that way.
    pub fn of(bounds: &Bounds, boxes: &'a [Bounds]) -> Result<Self, Error> {
        let mut tiling = Tiling { boxes, nodes: Vec::new() };
        tiling.add(bounds, (0..boxes.len()).collect(), 0)?;
        Ok(tiling)
    }

    fn add(&mut self, bounds: &Bounds, list: Vec<usize>, depth: usize) -> Result<usize, Error> {
        let content = match list[..] {
            [] => {
                let problem =
                    format!("found none in the box from {:?} to {:?}; expected a tiling", bounds[0], bounds[1]);
                return Err(Error::invalid("boxes", problem));
            }
            [only] if self.boxes[only] == *bounds => Content::Leaf(only),
            _ => {
                let (axis, cut) = self.cut(bounds, &list, depth)?;
                let (left, right) = list.into_iter().partition(|k| self.boxes[*k][1][axis] <= cut);
                let (mut low, mut high) = (*bounds, *bounds);
                (low[1][axis], high[0][axis]) = (cut, cut);
                Content::Halves([self.add(&low, left, depth + 1)?, self.add(&high, right, depth + 1)?])
            }
        };
        self.nodes.push(Node { bounds: *bounds, kept: true, content });
        Ok(self.nodes.len() - 1)
    }

    /// An axis and a coordinate inside the bounds, of a face of a box, where no box of the list is cut: the one nearest
    /// to the middle.
    fn cut(&self, bounds: &Bounds, list: &[usize], depth: usize) -> Result<(usize, f64), Error> {
        let nearest = |axis: usize| {
            let [low, high] = [bounds[0][axis], bounds[1][axis]];
            let off_middle = |x: &f64| (x - (0.5 * low + 0.5 * high)).abs();
            let faces = list.iter().flat_map(|k| [self.boxes[*k][0][axis], self.boxes[*k][1][axis]]);
            faces.filter(|x| low < *x && *x < high).min_by(|x, y| off_middle(x).total_cmp(&off_middle(y)))
        };
        let whole =
            |axis: usize, x: f64| list.iter().all(|k| self.boxes[*k][1][axis] <= x || x <= self.boxes[*k][0][axis]);
        let found = (0..3).find_map(|axis| nearest(axis).filter(|x| whole(axis, *x)).map(|x| (axis, x)));
        found.filter(|_| depth < DEEPEST).ok_or_else(|| {
            let [first, second] = [list[0], list[list.len() - 1]];
            let problem = format!(
                "found boxes that do not tile the box from {:?} to {:?}: no cut of it along a face near its middle \
                 leaves all boxes whole; expected boxes that come from halving",
                bounds[0], bounds[1]
            );
            Error::invalid(format!("boxes[{first}] to boxes[{second}]"), problem)
        })
    }

    /// Removes and returns all boxes in the tree that touch this one.
    pub fn take(&mut self, near: &Bounds) -> Vec<usize> {
        let mut taken = Vec::new();
        self.take_from(self.nodes.len() - 1, near, &mut taken);
        taken
    }

    fn take_from(&mut self, node: usize, near: &Bounds, taken: &mut Vec<usize>) {
        if !self.nodes[node].kept || !touch(&self.nodes[node].bounds, near) {
            return;
        }
        match self.nodes[node].content {
            Content::Leaf(k) => {
                taken.push(k);
                self.nodes[node].kept = false;
            }
            Content::Halves(halves) => {
                halves.iter().for_each(|half| self.take_from(*half, near, taken));
                self.nodes[node].kept = halves.iter().any(|half| self.nodes[*half].kept);
            }
        }
    }

    /// All open boxes that are connected to those that contain a point, through open boxes that touch, even if only in
    /// a corner. Removes them from the tree.
    pub fn connected(mut self, start: &[f64; 3], open: impl Fn(usize) -> bool) -> Vec<usize> {
        let mut found: Vec<usize> = self.take(&point(start)).into_iter().filter(|k| open(*k)).collect();
        let mut next = 0;
        while next < found.len() {
            let near = self.take(&self.boxes[found[next]].clone());
            found.extend(near.into_iter().filter(|k| open(*k)));
            next += 1;
        }
        found
    }
}

/// The middle of a box.
pub fn middle([low, high]: &Bounds) -> Vector {
    Vector::from_fn(|k, _| 0.5 * low[k] + 0.5 * high[k])
}
