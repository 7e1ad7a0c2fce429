//! Triangles over corners in which equal corners are identified: which triangles bound something, and how they hang together.

use std::collections::{BTreeMap, HashMap};

use super::solid::{LOOK, SignedDistance, sorted};
use crate::error::Error;
use crate::geometry::{Aabb, Point, TriangleMesh, Vector};
use crate::tolerances::WELD_RELATIVE;
use crate::watch::Watch;

/// Role of a triangle in the topology of its surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// The triangle bounds the body.
    Counts,
    /// The triangle was added to close the gap, without width, between an edge and corners on it.
    Joins,
    /// The triangle has two equal corners.
    Collapsed,
    /// The triangle occurs elsewhere in the list.
    Doubled,
    /// An equal triangle or an equal flat face faces it: nothing is between the two.
    Wall,
}

/// A directed edge of a triangle: its ends, smaller index first; whether it runs from the larger to the smaller; the
/// triangle.
pub(super) type Use = (u32, u32, bool, u32);

/// Triangles over corners in which equal corners are identified.
pub(super) struct Welded {
    /// Corners of each triangle as they were given.
    pub(super) corners: Vec<[Point; 3]>,
    pub(super) points: Vec<Point>,
    pub(super) ids: Vec<[usize; 3]>,
    pub(super) roles: Vec<Role>,
    /// Distance up to which corners are equal, m.
    pub(super) near: f64,
    pub(super) degenerate: usize,
    pub(super) doubled: usize,
}

impl Welded {
    pub(super) fn new(mesh: &TriangleMesh, watch: &Watch) -> Result<Self, Error> {
        let aabb = Aabb::around(&mesh.vertices);
        let near = WELD_RELATIVE * (aabb.max - aabb.min).amax().max(f64::MIN_POSITIVE);
        let (vertex_ids, points) = welded_points(&mesh.vertices, &aabb.min, near, watch)?;
        let ids: Vec<[usize; 3]> = mesh.triangles.iter().map(|t| t.map(|i| vertex_ids[i])).collect();
        let corners: Vec<[Point; 3]> = mesh.triangles.iter().map(|t| t.map(|i| mesh.vertices[i])).collect();
        let roles = vec![Role::Counts; ids.len()];
        let mut welded = Welded { corners, points, ids, roles, near, degenerate: 0, doubled: 0 };
        welded.sort_out(watch)?;
        Ok(welded)
    }

    /// Finds the roles of the triangles as they are given.
    fn sort_out(&mut self, watch: &Watch) -> Result<(), Error> {
        // For each set of three corners, the first triangle of each orientation.
        let mut known: HashMap<[usize; 3], [Option<usize>; 2]> = HashMap::new();
        for k in 0..self.ids.len() {
            if k % LOOK == 0 {
                watch.check()?;
            }
            let [a, b, c] = self.ids[k];
            if a == b || b == c || c == a {
                self.degenerate += 1;
                self.roles[k] = Role::Collapsed;
                continue;
            }
            self.degenerate += usize::from(self.is_needle(k));
            let mut key = [a, b, c];
            key.sort_unstable();
            let forward = [[a, b, c], [b, c, a], [c, a, b]].contains(&key);
            let same = known.entry(key).or_default();
            if same[usize::from(forward)].is_some() {
                self.doubled += 1;
                self.roles[k] = Role::Doubled;
            } else {
                same[usize::from(forward)] = Some(k);
                if let [Some(i), Some(j)] = *same {
                    (self.roles[i], self.roles[j]) = (Role::Wall, Role::Wall);
                }
            }
        }
        Ok(())
    }

    /// Whether a triangle has no area in relation to its edges: it is nowhere wider than what is welded.
    fn is_needle(&self, k: usize) -> bool {
        let [a, b, c] = self.ids[k].map(|i| self.points[i]);
        let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
        (b - a).cross(&(c - a)).norm() <= self.near * longest
    }

    /// Triangles grouped by the surface to which they belong.
    pub(super) fn connected(&self, watch: &Watch) -> Result<Vec<Vec<usize>>, Error> {
        let mut parent: Vec<usize> = (0..self.points.len()).collect();
        for [a, b, c] in &self.ids {
            for other in [b, c] {
                let (i, j) = (root(&mut parent, *a), root(&mut parent, *other));
                parent[i.max(j)] = i.min(j);
            }
        }
        let mut groups: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (k, [a, ..]) in self.ids.iter().enumerate() {
            if k % LOOK == 0 {
                watch.check()?;
            }
            groups.entry(root(&mut parent, *a)).or_default().push(k);
        }
        Ok(groups.into_values().collect())
    }

    /// Directed edges of the triangles that bound something, those between the same corners one after another.
    pub(super) fn uses(&self, triangles: &[usize], watch: &Watch) -> Result<Vec<Use>, Error> {
        let mut uses: Vec<Use> = Vec::with_capacity(3 * triangles.len());
        for k in self.bounding(triangles) {
            let [a, b, c] = self.ids[k];
            uses.extend([[a, b], [b, c], [c, a]].map(|[i, j]| (i.min(j) as u32, i.max(j) as u32, i > j, k as u32)));
        }
        sorted(&mut uses, watch)?;
        Ok(uses)
    }

    /// The triangles that bound something.
    pub(super) fn bounding<'a>(&'a self, triangles: &'a [usize]) -> impl Iterator<Item = usize> + 'a {
        triangles.iter().copied().filter(|k| matches!(self.roles[*k], Role::Counts | Role::Joins))
    }

    pub(super) fn doubled_area(&self, k: usize) -> Vector {
        let [a, b, c] = self.ids[k].map(|i| self.points[i]);
        (b - a).cross(&(c - a))
    }

    pub(super) fn volume(&self, triangles: &[usize]) -> f64 {
        let Some(first) = triangles.first() else { return 0.0 };
        let origin = self.points[self.ids[*first][0]];
        let cone = |k: usize| {
            let [a, b, c] = self.ids[k].map(|i| self.points[i] - origin);
            a.dot(&b.cross(&c)) / 6.0
        };
        self.bounding(triangles).map(cone).sum()
    }

    /// Distance from the triangles of a shell, if one of them has an area.
    pub(super) fn distance(
        &self,
        shell: &[usize],
        closed: bool,
        watch: &Watch,
    ) -> Result<Option<SignedDistance>, Error> {
        let belongs = |k: &usize| match self.roles[*k] {
            Role::Counts | Role::Joins => true,
            Role::Collapsed | Role::Doubled => false,
            Role::Wall => !closed,
        };
        let used: Vec<usize> = shell.iter().copied().filter(belongs).collect();
        if !used.iter().any(|k| self.doubled_area(*k).norm() > 0.0) {
            return Ok(None);
        }
        let mut place: HashMap<usize, usize> = HashMap::new();
        let mut points = Vec::new();
        let mut compact = |i: usize| {
            *place.entry(i).or_insert_with(|| {
                points.push(self.points[i]);
                points.len() - 1
            })
        };
        let list: Vec<[usize; 3]> = used.iter().map(|k| self.ids[*k].map(&mut compact)).collect();
        SignedDistance::new(&points, &list, closed, watch)
    }
}

/// The representative of the set of connected corners that a corner belongs to.
pub(super) fn root(parent: &mut [usize], mut i: usize) -> usize {
    while parent[i] != i {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    i
}

/// The directed edges between the same corners, together.
pub(super) fn edges(uses: &[Use]) -> impl Iterator<Item = &[Use]> {
    uses.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1))
}

/// Number of open edges, and of edges whose triangles disagree.
pub(super) fn defects(uses: &[Use]) -> (usize, usize) {
    let (mut open, mut turned) = (0, 0);
    for same in edges(uses) {
        let back = same.iter().filter(|(_, _, back, _)| *back).count();
        open += usize::from(same.len() == 1);
        turned += usize::from(same.len() > 1 && 2 * back != same.len());
    }
    (open, turned)
}

/// For each vertex, the index of the first one that is at most `near` metres away; and these first ones.
fn welded_points(
    vertices: &[Point],
    corner: &Point,
    near: f64,
    watch: &Watch,
) -> Result<(Vec<usize>, Vec<Point>), Error> {
    // Cells so large that most vertices have to be looked for in one of them only. Each lists its vertices as a chain.
    let size = 16.0 * near;
    let mut cells: HashMap<[i64; 3], usize> = HashMap::new();
    let (mut points, mut next): (Vec<Point>, Vec<usize>) = (Vec::new(), Vec::new());
    let mut ids = Vec::with_capacity(vertices.len());
    for (k, p) in vertices.iter().enumerate() {
        if k % LOOK == 0 {
            watch.check()?;
        }
        let cell =
            |shift: f64| -> [i64; 3] { std::array::from_fn(|a| ((p[a] - corner[a] + shift) / size).floor() as i64) };
        let (low, high) = (cell(-near), cell(near));
        let mut found = usize::MAX;
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let mut at = cells.get(&[x, y, z]).copied().unwrap_or(usize::MAX);
                    while at != usize::MAX {
                        if (points[at] - p).amax() <= near {
                            found = found.min(at);
                        }
                        at = next[at];
                    }
                }
            }
        }
        if found == usize::MAX {
            found = points.len();
            points.push(*p);
            next.push(cells.insert(cell(0.0), found).unwrap_or(usize::MAX));
        }
        ids.push(found);
    }
    Ok((ids, points))
}
