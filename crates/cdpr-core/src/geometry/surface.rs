//! Analysis of a list of triangles: its connected pieces, which of them enclose a body, and its defects.

use std::collections::{BTreeMap, HashMap, HashSet};

use super::solid::{LOOK, SignedDistance, sorted};
use super::{Aabb, Point, TriangleMesh, Vector};
use crate::error::Error;
use crate::numerics::WELD_RELATIVE;
use crate::watch::Watch;

/// Defects of a mesh, counted. None of them prevents the triangles from being obstacles.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Faults {
    /// Triangles with two equal corners or without area.
    pub degenerate: usize,
    /// Triangles that occur in the list more than once.
    pub doubled: usize,
    /// Edges of a single triangle: the rims of holes.
    pub open_edges: usize,
    /// Edges whose two triangles disagree on which side is outside.
    pub turned_edges: usize,
    /// Pieces that enclose a body but are turned inside out.
    pub inside_out: usize,
    /// Pieces without an interior, for any of these reasons.
    pub sheets: usize,
}

impl Faults {
    /// The defects as sentences for the user; empty if the mesh is sound.
    pub fn notes(&self) -> Vec<String> {
        let count = |number: usize, one: &str, many: &str| {
            (number > 0).then(|| format!("{number} {}", if number == 1 { one } else { many }))
        };
        let wrong: Vec<String> = [
            count(self.open_edges, "open edge (a hole)", "open edges (holes)"),
            count(self.turned_edges, "edge with a flipped triangle", "edges with a flipped triangle"),
            count(self.inside_out, "piece is inside out", "pieces are inside out"),
            count(self.degenerate, "degenerate triangle", "degenerate triangles"),
            count(self.doubled, "doubled triangle", "doubled triangles"),
        ]
        .into_iter()
        .flatten()
        .collect();
        let mut notes = Vec::new();
        if !wrong.is_empty() {
            notes.push(format!("the mesh is not sound: {}", wrong.join(", ")));
        }
        notes.extend(count(self.sheets, "piece has", "pieces have").map(|pieces| {
            format!("{pieces} no inside: treated as a thin surface, and the space behind it is not filled")
        }));
        notes
    }
}

/// A connected set of triangles, with the bodies of other pieces that it encloses as cavities.
pub struct Piece {
    /// Corners of every triangle, m, as they were given.
    pub triangles: Vec<[Point; 3]>,
    /// Distance from the surface, negative inside.
    pub distance: SignedDistance,
    /// Enclosed volume, m³; `None` for a sheet.
    pub volume: Option<f64>,
}

/// Splits a mesh into pieces.
///
/// # Errors
/// The errors of the watch.
pub fn pieces(mesh: &TriangleMesh, watch: &Watch) -> Result<(Vec<Piece>, Faults), Error> {
    let welded = Welded::new(mesh, watch)?;
    let mut faults = Faults { degenerate: welded.degenerate, doubled: welded.doubled, ..Faults::default() };
    let mut shells = Vec::new();
    for list in welded.connected(watch)? {
        shells.push(welded.shell(list, &mut faults, watch)?);
    }
    let cavities: Vec<Shell> = shells.extract_if(.., |s| s.volume.is_some_and(|v| v < 0.0)).collect();
    for cavity in cavities {
        match enclosing(&welded, &shells, &cavity, watch)? {
            Some(k) => shells[k].join(cavity),
            None => {
                faults.inside_out += 1;
                shells.push(Shell { volume: None, ..cavity });
            }
        }
    }
    faults.sheets = shells.iter().filter(|s| s.volume.is_none()).count();
    let pieces: Vec<Option<Piece>> = shells.into_iter().map(|s| welded.piece(s, watch)).collect::<Result<_, _>>()?;
    Ok((pieces.into_iter().flatten().collect(), faults))
}

/// A connected surface: indices of its triangles, and its volume if it is closed.
struct Shell {
    triangles: Vec<usize>,
    volume: Option<f64>,
    aabb: Aabb,
}

impl Shell {
    fn join(&mut self, cavity: Shell) {
        self.triangles.extend(cavity.triangles);
        self.volume = self.volume.zip(cavity.volume).map(|(a, b)| a + b);
    }
}

/// The smallest closed shell around a cavity.
fn enclosing(welded: &Welded, shells: &[Shell], cavity: &Shell, watch: &Watch) -> Result<Option<usize>, Error> {
    let around = |s: &Shell| {
        s.volume.is_some() && (0..3).all(|k| s.aabb.min[k] < cavity.aabb.min[k] && s.aabb.max[k] > cavity.aabb.max[k])
    };
    let mut candidates: Vec<usize> = (0..shells.len()).filter(|k| around(&shells[*k])).collect();
    candidates.sort_by(|a, b| shells[*a].volume.partial_cmp(&shells[*b].volume).expect("finite"));
    for k in candidates {
        let distance = welded.distance(&shells[k].triangles, true, watch)?;
        if distance.is_some_and(|d| d.at(&welded.corners[cavity.triangles[0]][0]).0 < 0.0) {
            return Ok(Some(k));
        }
    }
    Ok(None)
}

/// Triangles over corners in which nearly equal corners are identified, for questions of connectivity; positions use
/// the corners as given.
struct Welded {
    corners: Vec<[Point; 3]>,
    points: Vec<Point>,
    ids: Vec<[usize; 3]>,
    /// Whether a triangle counts: it has an area, and is the first of its duplicates.
    counts: Vec<bool>,
    degenerate: usize,
    doubled: usize,
}

impl Welded {
    fn new(mesh: &TriangleMesh, watch: &Watch) -> Result<Self, Error> {
        let aabb = Aabb::around(&mesh.vertices);
        let cell = WELD_RELATIVE * (aabb.max - aabb.min).amax().max(f64::MIN_POSITIVE);
        let mut places: HashMap<[i64; 3], usize> = HashMap::new();
        let mut points = Vec::new();
        let mut id_of = |p: &Point| {
            let key = std::array::from_fn(|k| ((p[k] - aabb.min[k]) / cell).round() as i64);
            *places.entry(key).or_insert_with(|| {
                points.push(*p);
                points.len() - 1
            })
        };
        let mut vertex_ids = Vec::with_capacity(mesh.vertices.len());
        for (k, p) in mesh.vertices.iter().enumerate() {
            if k % LOOK == 0 {
                watch.check()?;
            }
            vertex_ids.push(id_of(p));
        }
        let ids: Vec<[usize; 3]> = mesh.triangles.iter().map(|t| t.map(|i| vertex_ids[i])).collect();
        let corners: Vec<[Point; 3]> = mesh.triangles.iter().map(|t| t.map(|i| mesh.vertices[i])).collect();
        let mut welded = Welded { counts: vec![true; ids.len()], corners, points, ids, degenerate: 0, doubled: 0 };
        welded.sort_out(watch)?;
        Ok(welded)
    }

    fn sort_out(&mut self, watch: &Watch) -> Result<(), Error> {
        let mut known = HashSet::new();
        for (k, [a, b, c]) in self.ids.iter().copied().enumerate() {
            if k % LOOK == 0 {
                watch.check()?;
            }
            let collapsed = a == b || b == c || c == a;
            let first = [[a, b, c], [b, c, a], [c, a, b]].into_iter().min().expect("three");
            let doubled = !collapsed && !known.insert(first);
            let flat = self.doubled_area(k).norm() == 0.0;
            self.degenerate += usize::from(collapsed || flat);
            self.doubled += usize::from(doubled);
            self.counts[k] = !collapsed && !doubled;
        }
        Ok(())
    }

    fn doubled_area(&self, k: usize) -> Vector {
        let [a, b, c] = self.ids[k].map(|i| self.points[i]);
        (b - a).cross(&(c - a))
    }

    /// Triangles grouped by the surface to which they belong.
    fn connected(&self, watch: &Watch) -> Result<Vec<Vec<usize>>, Error> {
        let mut parent: Vec<usize> = (0..self.points.len()).collect();
        fn root(parent: &mut [usize], mut i: usize) -> usize {
            while parent[i] != i {
                parent[i] = parent[parent[i]];
                i = parent[i];
            }
            i
        }
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

    fn shell(&self, triangles: Vec<usize>, faults: &mut Faults, watch: &Watch) -> Result<Shell, Error> {
        let counted = self.counted(&triangles);
        let mut uses: Vec<(usize, usize, bool)> = Vec::with_capacity(3 * counted.len());
        for [a, b, c] in counted {
            uses.extend([[a, b], [b, c], [c, a]].map(|[i, j]| (i.min(j), i.max(j), i > j)));
        }
        sorted(&mut uses, watch)?;
        let (mut open, mut turned) = (0, 0);
        for same in uses.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            let back = same.iter().filter(|(_, _, back)| *back).count();
            open += usize::from(same.len() == 1);
            turned += usize::from(same.len() > 1 && 2 * back != same.len());
        }
        faults.open_edges += open;
        faults.turned_edges += turned;
        let corners: Vec<Point> = triangles.iter().flat_map(|k| self.corners[*k]).collect();
        let aabb = Aabb::around(&corners);
        let volume = self.volume(&triangles);
        let bulk = WELD_RELATIVE * (aabb.max - aabb.min).iter().product::<f64>();
        let closed = open + turned == 0 && volume.abs() > bulk;
        Ok(Shell { triangles, volume: closed.then_some(volume), aabb })
    }

    fn counted(&self, triangles: &[usize]) -> Vec<[usize; 3]> {
        triangles.iter().filter(|k| self.counts[**k]).map(|k| self.ids[*k]).collect()
    }

    fn volume(&self, triangles: &[usize]) -> f64 {
        let Some(first) = triangles.first() else { return 0.0 };
        let origin = self.points[self.ids[*first][0]];
        let cone = |t: [usize; 3]| {
            let [a, b, c] = t.map(|i| self.points[i] - origin);
            a.dot(&b.cross(&c)) / 6.0
        };
        self.counted(triangles).into_iter().map(cone).sum()
    }

    fn distance(&self, triangles: &[usize], closed: bool, watch: &Watch) -> Result<Option<SignedDistance>, Error> {
        let with_area = triangles.iter().filter(|k| self.counts[**k] && self.doubled_area(**k).norm() > 0.0);
        let mut place: HashMap<usize, usize> = HashMap::new();
        let mut points = Vec::new();
        let mut compact = |i: usize| {
            *place.entry(i).or_insert_with(|| {
                points.push(self.points[i]);
                points.len() - 1
            })
        };
        let list: Vec<[usize; 3]> = with_area.map(|k| self.ids[*k].map(&mut compact)).collect();
        SignedDistance::new(&points, &list, closed, watch)
    }

    /// A piece; `None` if all triangles of the shell have no area.
    fn piece(&self, shell: Shell, watch: &Watch) -> Result<Option<Piece>, Error> {
        let Some(distance) = self.distance(&shell.triangles, shell.volume.is_some(), watch)? else { return Ok(None) };
        let triangles = shell.triangles.iter().map(|k| self.corners[*k]).collect();
        Ok(Some(Piece { triangles, distance, volume: shell.volume }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::convex_mesh;

    fn cube(from: f64, to: f64) -> TriangleMesh {
        let corner = |x: f64| Point::new(x, x, x);
        convex_mesh(&[], &Aabb { min: corner(from), max: corner(to) }).unwrap()
    }

    fn inside_out(mut mesh: TriangleMesh) -> TriangleMesh {
        mesh.triangles.iter_mut().for_each(|t| t.swap(0, 1));
        mesh
    }

    fn joined(parts: &[TriangleMesh]) -> TriangleMesh {
        let mut whole = TriangleMesh::default();
        parts.iter().for_each(|part| whole.append(part));
        whole
    }

    #[test]
    fn bodies_apart_are_pieces_and_a_cavity_belongs_to_the_body_around_it() {
        let room = joined(&[cube(0.0, 4.0), inside_out(cube(1.0, 3.0)), cube(1.5, 2.5), cube(5.0, 6.0)]);
        let (pieces, faults) = pieces(&room, &Watch::NONE).unwrap();
        assert_eq!(faults, Faults::default());
        let volumes: Vec<f64> = pieces.iter().map(|p| p.volume.unwrap().round()).collect();
        assert_eq!(volumes, [56.0, 1.0, 1.0]);
        let wall = &pieces[0].distance;
        assert!((wall.at(&Point::new(2.0, 2.0, 1.2)).0 - 0.2).abs() < 1e-12);
        assert!((wall.at(&Point::new(2.0, 2.0, 0.3)).0 + 0.3).abs() < 1e-12);
    }

    #[test]
    fn triangles_listed_by_coordinates_hang_together() {
        let mesh = cube(0.0, 1.0);
        let soup = TriangleMesh {
            vertices: mesh.triangles.iter().flatten().map(|i| mesh.vertices[*i]).collect(),
            triangles: (0..mesh.triangles.len()).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect(),
        };
        let (pieces, faults) = pieces(&soup, &Watch::NONE).unwrap();
        assert_eq!((pieces.len(), faults), (1, Faults::default()));
        assert!((pieces[0].volume.unwrap() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn what_is_wrong_is_counted() {
        let sound = cube(0.0, 1.0);
        let with = |change: &dyn Fn(&mut Vec<[usize; 3]>)| {
            let mut mesh = sound.clone();
            change(&mut mesh.triangles);
            pieces(&mesh, &Watch::NONE).unwrap().1
        };
        assert_eq!(with(&|t| t.truncate(t.len() - 1)), Faults { open_edges: 3, sheets: 1, ..Faults::default() });
        assert_eq!(with(&|t| t[0].swap(0, 1)), Faults { turned_edges: 3, sheets: 1, ..Faults::default() });
        assert_eq!(with(&|t| t.push(t[0])), Faults { doubled: 1, ..Faults::default() });
        assert_eq!(with(&|t| t.push([t[0][0], t[0][1], t[0][1]])), Faults { degenerate: 1, ..Faults::default() });
        let turned = pieces(&inside_out(sound.clone()), &Watch::NONE).unwrap().1;
        assert_eq!(turned, Faults { inside_out: 1, sheets: 1, ..Faults::default() });
        assert_eq!(turned.notes().len(), 2);
        assert!(Faults::default().notes().is_empty());
    }
}
