//! Analysis of a list of triangles: its connected pieces, which of them enclose a body, and its defects.
//!
//! Defects that leave no doubt about the shape are mended: corners that are equal up to rounding are welded, coincident
//! faces of abutting bodies cancel, corners in the middle of another triangle's edge are joined to it, and triangles that
//! face the other way than their neighbours are turned.

use std::collections::{BTreeMap, HashMap};

use super::solid::{LOOK, SignedDistance, sorted};
use super::{Aabb, Point, TriangleMesh, Vector};
use crate::error::Error;
use crate::numerics::{MOST_MENDING_STEPS, WELD_RELATIVE};
use crate::watch::Watch;

/// Defects of a mesh, counted. None of them prevents the triangles from being obstacles.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Faults {
    /// Triangles with two equal corners, or without area in relation to their edges.
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
    /// Corners in the middle of another triangle's edge, which were joined to it.
    pub joined: usize,
    /// Triangles that faced the other way than their neighbours and were turned.
    pub turned: usize,
    /// Pairs of equal triangles that face each other between abutting bodies.
    pub facing: usize,
}

impl Faults {
    /// The defects as sentences for the user; empty if the mesh is sound.
    pub fn notes(&self) -> Vec<String> {
        let count = |number: usize, one: &str, many: &str| {
            (number > 0).then(|| format!("{number} {}", if number == 1 { one } else { many }))
        };
        let list = |parts: Vec<Option<String>>| parts.into_iter().flatten().collect::<Vec<_>>().join(", ");
        let wrong = list(vec![
            count(self.open_edges, "open edge (a hole)", "open edges (holes)"),
            count(self.turned_edges, "edge with a flipped triangle", "edges with a flipped triangle"),
            count(self.inside_out, "piece is inside out", "pieces are inside out"),
            count(self.degenerate, "degenerate triangle", "degenerate triangles"),
            count(self.doubled, "doubled triangle", "doubled triangles"),
        ]);
        let mended = list(vec![
            count(self.joined, "corner in the middle of an edge", "corners in the middle of edges"),
            count(self.turned, "flipped triangle", "flipped triangles"),
            count(self.facing, "coincident face between abutting bodies", "coincident faces between abutting bodies"),
        ]);
        let mut notes = Vec::new();
        if !wrong.is_empty() {
            notes.push(format!("the mesh is not sound: {wrong}"));
        }
        if !mended.is_empty() {
            notes.push(format!("the mesh was mended: {mended}"));
        }
        notes.extend(count(self.sheets, "piece has", "pieces have").map(|pieces| {
            format!("{pieces} no inside: treated as a thin surface, and the space behind it is not filled")
        }));
        notes
    }
}

/// A connected set of triangles, with the bodies of other pieces that it encloses as cavities.
pub struct Piece {
    /// Corners of every triangle, m: as they were given, and once more where welding moved them.
    pub triangles: Vec<[Point; 3]>,
    /// Triangles between abutting bodies of the piece, m. They bound nothing but must be covered, too.
    pub walls: Vec<[Point; 3]>,
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
    let mut welded = Welded::new(mesh, watch)?;
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
        if distance.is_some_and(|d| d.encloses(&welded.corners[cavity.triangles[0]][0])) {
            return Ok(Some(k));
        }
    }
    Ok(None)
}

/// What a triangle is for the topology of its surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Role {
    /// It bounds the body.
    Counts,
    /// It was added to close the gap, without width, between an edge and corners on it.
    Joins,
    /// It has two equal corners.
    Collapsed,
    /// It occurs elsewhere in the list.
    Doubled,
    /// An equal triangle or an equal flat face faces it: nothing is between the two.
    Wall,
}

/// A directed edge of a triangle: its ends, smaller index first; whether it runs from the larger to the smaller; the
/// triangle.
type Use = (u32, u32, bool, u32);

/// Directed outer edges of a face, in ascending order, and its triangles.
type Face = (Vec<[u32; 2]>, Vec<usize>);

/// Triangles over corners in which equal corners are identified.
struct Welded {
    /// Corners of each triangle as they were given.
    corners: Vec<[Point; 3]>,
    points: Vec<Point>,
    ids: Vec<[usize; 3]>,
    roles: Vec<Role>,
    /// Distance up to which corners are equal, m.
    near: f64,
    degenerate: usize,
    doubled: usize,
}

impl Welded {
    fn new(mesh: &TriangleMesh, watch: &Watch) -> Result<Self, Error> {
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
    fn connected(&self, watch: &Watch) -> Result<Vec<Vec<usize>>, Error> {
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

    fn shell(&mut self, mut triangles: Vec<usize>, faults: &mut Faults, watch: &Watch) -> Result<Shell, Error> {
        let corners: Vec<Point> = triangles.iter().flat_map(|k| self.corners[*k]).collect();
        let aabb = Aabb::around(&corners);
        let mut uses = self.uses(&triangles, watch)?;
        if self.face_each_other(&uses, watch)? {
            uses = self.uses(&triangles, watch)?;
        }
        let (mut open, mut turned) = defects(&uses);
        if open > 0
            && let Some((added, joined)) = self.joined(&triangles, &uses, watch)?
        {
            triangles.extend(added);
            uses = self.uses(&triangles, watch)?;
            (open, turned) = defects(&uses);
            faults.joined += joined;
        }
        if turned > 0
            && open == 0
            && let Some(flipped) = self.turned(&triangles, &uses, watch)?
        {
            faults.turned += flipped;
            turned = 0;
        }
        faults.open_edges += open;
        faults.turned_edges += turned;
        let volume = self.volume(&triangles);
        let bulk = WELD_RELATIVE * (aabb.max - aabb.min).iter().product::<f64>();
        let closed = open + turned == 0 && volume.abs() > bulk;
        let walls = triangles.iter().filter(|k| self.roles[**k] == Role::Wall).count();
        faults.facing += if closed { walls / 2 } else { 0 };
        Ok(Shell { triangles, volume: closed.then_some(volume), aabb })
    }

    /// Directed edges of the triangles that bound something, those between the same corners one after another.
    fn uses(&self, triangles: &[usize], watch: &Watch) -> Result<Vec<Use>, Error> {
        let mut uses: Vec<Use> = Vec::with_capacity(3 * triangles.len());
        for k in self.bounding(triangles) {
            let [a, b, c] = self.ids[k];
            uses.extend([[a, b], [b, c], [c, a]].map(|[i, j]| (i.min(j) as u32, i.max(j) as u32, i > j, k as u32)));
        }
        sorted(&mut uses, watch)?;
        Ok(uses)
    }

    /// Makes walls of the flat faces that coincide with one that faces them, however they are divided into triangles.
    /// Returns whether there are any.
    fn face_each_other(&mut self, uses: &[Use], watch: &Watch) -> Result<bool, Error> {
        if edges(uses).all(|same| same.len() <= 2) {
            return Ok(false);
        }
        let mut known: HashMap<Vec<[u32; 2]>, Vec<usize>> = HashMap::new();
        let mut walls = Vec::new();
        for (rim, face) in self.faces(uses, watch)? {
            let facing = {
                let mut rim: Vec<[u32; 2]> = rim.iter().map(|[i, j]| [*j, *i]).collect();
                rim.sort_unstable();
                rim
            };
            match known.remove(&facing) {
                Some(other) => walls.extend(face.into_iter().chain(other)),
                None => drop(known.insert(rim, face)),
            }
        }
        walls.iter().for_each(|k| self.roles[*k] = Role::Wall);
        Ok(!walls.is_empty())
    }

    /// The flat faces all of whose outer edges have more than two triangles, and whose inner edges have two.
    fn faces(&self, uses: &[Use], watch: &Watch) -> Result<Vec<Face>, Error> {
        let mut triangles: Vec<usize> = uses.iter().map(|edge| edge.3 as usize).collect();
        triangles.sort_unstable();
        triangles.dedup();
        let place = |edge: &Use| triangles.binary_search(&(edge.3 as usize)).expect("listed");
        let mut parent: Vec<usize> = (0..triangles.len()).collect();
        let mut outer: Vec<(&Use, bool)> = Vec::new();
        for (k, same) in edges(uses).enumerate() {
            if k % LOOK == 0 {
                watch.check()?;
            }
            match same {
                [one, other] if self.is_one_face(one, other) => {
                    let (i, j) = (root(&mut parent, place(one)), root(&mut parent, place(other)));
                    parent[i.max(j)] = i.min(j);
                }
                _ => outer.extend(same.iter().map(|edge| (edge, same.len() > 2))),
            }
        }
        let mut rims: BTreeMap<usize, (Vec<[u32; 2]>, bool)> = BTreeMap::new();
        for (edge, shared) in outer {
            let (rim, all_shared) = rims.entry(root(&mut parent, place(edge))).or_insert((Vec::new(), true));
            rim.push(if edge.2 { [edge.1, edge.0] } else { [edge.0, edge.1] });
            *all_shared &= shared;
        }
        rims.retain(|_, (_, all_shared)| *all_shared);
        let mut members: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (k, triangle) in triangles.iter().enumerate() {
            let face = root(&mut parent, k);
            if rims.contains_key(&face) {
                members.entry(face).or_default().push(*triangle);
            }
        }
        let mut faces = Vec::new();
        for ((mut rim, _), face) in rims.into_values().zip(members.into_values()) {
            if self.is_flat(&face) {
                rim.sort_unstable();
                faces.push((rim, face));
            }
        }
        Ok(faces)
    }

    /// Whether two triangles on both sides of an edge are part of one flat face.
    fn is_one_face(&self, one: &Use, other: &Use) -> bool {
        let [a, b] = [one, other].map(|edge| self.doubled_area(edge.3 as usize));
        one.2 != other.2 && a.dot(&b) > 0.0 && self.is_flat(&[one.3 as usize, other.3 as usize])
    }

    /// Whether all corners of triangles are in the plane of the largest one.
    fn is_flat(&self, triangles: &[usize]) -> bool {
        let area = |k: &usize| self.doubled_area(*k).norm();
        let largest = triangles.iter().max_by(|i, j| area(i).total_cmp(&area(j)));
        let Some(normal) = largest.and_then(|k| self.doubled_area(*k).try_normalize(0.0)) else { return false };
        let origin = self.points[self.ids[*largest.expect("a triangle")][0]];
        let height = |i: usize| normal.dot(&(self.points[i] - origin));
        triangles.iter().flat_map(|k| self.ids[*k]).all(|i| height(i).abs() <= self.near)
    }

    /// The triangles that bound something.
    fn bounding<'a>(&'a self, triangles: &'a [usize]) -> impl Iterator<Item = usize> + 'a {
        triangles.iter().copied().filter(|k| matches!(self.roles[*k], Role::Counts | Role::Joins))
    }

    /// Joins corners on open edges to these edges, if that closes the surface: adds triangles without area, and returns
    /// their indices and the number of corners.
    fn joined(&mut self, shell: &[usize], uses: &[Use], watch: &Watch) -> Result<Option<(Vec<usize>, usize)>, Error> {
        let open: Vec<[usize; 2]> = edges(uses)
            .filter(|same| same.len() == 1)
            .map(|same| if same[0].2 { [same[0].1, same[0].0] } else { [same[0].0, same[0].1] })
            .map(|edge| edge.map(|i| i as usize))
            .collect();
        let mut ends: Vec<usize> = open.iter().flatten().copied().collect();
        ends.sort_unstable();
        ends.dedup();
        let span = Aabb::around(&ends.iter().map(|i| self.points[*i]).collect::<Vec<_>>());
        let axis = (span.max - span.min).imax();
        ends.sort_by(|i, j| self.points[*i][axis].total_cmp(&self.points[*j][axis]).then(i.cmp(j)));
        let mut steps = 0;
        let mut chains: Vec<(Vec<usize>, [usize; 2])> = Vec::new();
        for [a, b] in open {
            let (p, q) = (self.points[a], self.points[b]);
            let along = q - p;
            let (low, high) = (p[axis].min(q[axis]) - self.near, p[axis].max(q[axis]) + self.near);
            let from = ends.partition_point(|i| self.points[*i][axis] < low);
            let mut between: Vec<(f64, usize)> = Vec::new();
            for i in ends[from..].iter().take_while(|i| self.points[**i][axis] <= high) {
                steps += 1;
                if steps % LOOK == 0 {
                    watch.check()?;
                }
                let offset = self.points[*i] - p;
                let share = offset.dot(&along) / along.norm_squared();
                if share > 0.0 && share < 1.0 && *i != a && *i != b && (offset - along * share).norm() <= self.near {
                    between.push((share, *i));
                }
            }
            if steps > MOST_MENDING_STEPS {
                return Ok(None);
            }
            between.sort_by(|x, y| x.0.total_cmp(&y.0));
            if !between.is_empty() {
                chains.push((between.into_iter().map(|(_, i)| i).collect(), [a, b]));
            }
        }
        let first = self.ids.len();
        let mut corners: Vec<usize> = chains.iter().flat_map(|(chain, _)| chain).copied().collect();
        for (chain, [a, b]) in chains {
            let mut last = a;
            for i in chain {
                self.ids.push([b, last, i]);
                last = i;
            }
        }
        self.corners.extend(self.ids[first..].iter().map(|t| t.map(|i| self.points[i])));
        self.roles.resize(self.ids.len(), Role::Joins);
        let added: Vec<usize> = (first..self.ids.len()).collect();
        let whole: Vec<usize> = shell.iter().chain(&added).copied().collect();
        let closed = defects(&self.uses(&whole, watch)?).0 == 0;
        if !closed || added.is_empty() {
            self.ids.truncate(first);
            self.corners.truncate(first);
            self.roles.truncate(first);
            return Ok(None);
        }
        corners.sort_unstable();
        corners.dedup();
        Ok(Some((added, corners.len())))
    }

    /// Turns triangles so that all agree with their neighbours, if that is possible, and returns their number. Of two
    /// consistent orientations of connected triangles, the one that more of their area has is kept.
    fn turned(&mut self, shell: &[usize], uses: &[Use], watch: &Watch) -> Result<Option<usize>, Error> {
        let mut neighbours: HashMap<usize, Vec<(usize, bool)>> = HashMap::new();
        for (k, same) in edges(uses).enumerate() {
            if k % LOOK == 0 {
                watch.check()?;
            }
            // Edges of more triangles do not tell which of them belong together.
            if let [(.., back, i), (.., other, j)] = same {
                neighbours.entry(*i as usize).or_default().push((*j as usize, back == other));
                neighbours.entry(*j as usize).or_default().push((*i as usize, back == other));
            }
        }
        let mut turn: HashMap<usize, bool> = HashMap::new();
        let mut turned = Vec::new();
        for (k, first) in self.bounding(shell).enumerate() {
            if k % LOOK == 0 {
                watch.check()?;
            }
            if turn.contains_key(&first) {
                continue;
            }
            turn.insert(first, false);
            let mut patch = vec![first];
            let mut at = 0;
            while at < patch.len() {
                let here = turn[&patch[at]];
                for (other, against) in neighbours.get(&patch[at]).into_iter().flatten() {
                    match turn.get(other) {
                        None => {
                            turn.insert(*other, here != *against);
                            patch.push(*other);
                        }
                        Some(there) if *there != (here != *against) => return Ok(None), // it has one side only
                        Some(_) => {}
                    }
                }
                at += 1;
            }
            let area = |k: &usize| self.doubled_area(*k).norm() * if turn[k] { 1.0 } else { -1.0 };
            let most_turn = patch.iter().map(area).sum::<f64>() > 0.0;
            turned.extend(patch.into_iter().filter(|k| turn[k] != most_turn));
        }
        self.turn(&turned);
        if defects(&self.uses(shell, watch)?) != (0, 0) {
            self.turn(&turned);
            return Ok(None);
        }
        Ok(Some(turned.len()))
    }

    fn turn(&mut self, triangles: &[usize]) {
        for k in triangles {
            self.ids[*k].swap(1, 2);
            self.corners[*k].swap(1, 2);
        }
    }

    fn doubled_area(&self, k: usize) -> Vector {
        let [a, b, c] = self.ids[k].map(|i| self.points[i]);
        (b - a).cross(&(c - a))
    }

    fn volume(&self, triangles: &[usize]) -> f64 {
        let Some(first) = triangles.first() else { return 0.0 };
        let origin = self.points[self.ids[*first][0]];
        let cone = |k: usize| {
            let [a, b, c] = self.ids[k].map(|i| self.points[i] - origin);
            a.dot(&b.cross(&c)) / 6.0
        };
        self.bounding(triangles).map(cone).sum()
    }

    /// Distance from the triangles of a shell, if one of them has an area.
    fn distance(&self, shell: &[usize], closed: bool, watch: &Watch) -> Result<Option<SignedDistance>, Error> {
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

    /// A piece; `None` if all triangles of the shell have no area.
    fn piece(&self, shell: Shell, watch: &Watch) -> Result<Option<Piece>, Error> {
        let closed = shell.volume.is_some();
        let Some(distance) = self.distance(&shell.triangles, closed, watch)? else { return Ok(None) };
        let (mut triangles, mut walls) = (Vec::with_capacity(shell.triangles.len()), Vec::new());
        for k in shell.triangles {
            let welded = self.ids[k].map(|i| self.points[i]);
            match self.roles[k] {
                Role::Joins => {} // it lies on edges of others
                Role::Wall if closed => walls.push(self.corners[k]),
                Role::Doubled if self.corners[k] == welded => {}
                _ => triangles.push(self.corners[k]),
            }
            if self.roles[k] == Role::Counts && self.corners[k] != welded {
                triangles.push(welded);
            }
        }
        Ok(Some(Piece { triangles, walls, distance, volume: shell.volume }))
    }
}

/// The first of the corners that are connected to one.
fn root(parent: &mut [usize], mut i: usize) -> usize {
    while parent[i] != i {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    i
}

/// The directed edges between the same corners, together.
fn edges(uses: &[Use]) -> impl Iterator<Item = &[Use]> {
    uses.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1))
}

/// Number of open edges, and of edges whose triangles disagree.
fn defects(uses: &[Use]) -> (usize, usize) {
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

#[cfg(test)]
mod tests {
    use super::super::convex_parts::convex_parts;
    use super::*;
    use crate::geometry::convex_mesh;
    use rand::SeedableRng;

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

    /// The band of a Möbius strip.
    fn one_sided() -> TriangleMesh {
        let corner = |k: usize| {
            let turn = std::f64::consts::TAU * (k / 2) as f64 / 8.0;
            let across = if k.is_multiple_of(2) { 0.2 } else { -0.2 };
            let (reach, height) = (1.0 + across * (0.5 * turn).cos(), across * (0.5 * turn).sin());
            Point::new(reach * turn.cos(), reach * turn.sin(), height)
        };
        let quad = |k: usize| {
            let [a, b] = [2 * k, 2 * k + 1];
            let [c, d] = if k == 7 { [1, 0] } else { [a + 2, b + 2] };
            [[a, c, b], [b, c, d]]
        };
        TriangleMesh { vertices: (0..16).map(corner).collect(), triangles: (0..8).flat_map(quad).collect() }
    }

    #[test]
    fn flipped_triangles_are_turned_and_a_surface_with_one_side_is_left_alone() {
        let mut mesh = cube(0.0, 1.0);
        (0..mesh.triangles.len()).step_by(4).for_each(|k| mesh.triangles[k].swap(1, 2));
        let (found, faults) = pieces(&mesh, &Watch::NONE).unwrap();
        assert_eq!(faults, Faults { turned: 3, ..Faults::default() });
        assert!((found[0].volume.unwrap() - 1.0).abs() < 1e-12);
        // Most of its area faces inward.
        mesh.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        assert_eq!(pieces(&mesh, &Watch::NONE).unwrap().1.inside_out, 1);
        let (found, faults) = pieces(&one_sided(), &Watch::NONE).unwrap();
        assert!(found[0].volume.is_none() && faults.open_edges > 0 && faults.turned == 0, "{faults:?}");
    }

    #[test]
    fn corners_on_edges_close_a_surface_with_and_without_triangles_between() {
        let whole = cube(0.0, 1.0);
        let [a, b, c] = whole.triangles[0];
        let middle = nalgebra::center(&whole.vertices[a], &whole.vertices[b]);
        let mut open = whole.clone();
        open.vertices.push(middle);
        let m = open.vertices.len() - 1;
        open.triangles.splice(0..1, [[a, m, c], [m, b, c]]);
        let mut closed = open.clone();
        closed.triangles.push([a, b, m]);
        for (mesh, faults) in
            [(open, Faults { joined: 1, ..Faults::default() }), (closed, Faults { degenerate: 1, ..Faults::default() })]
        {
            let (found, told) = pieces(&mesh, &Watch::NONE).unwrap();
            assert_eq!(told, faults);
            assert!((found[0].volume.unwrap() - 1.0).abs() < 1e-12);
            assert!((found[0].distance.at(&Point::new(0.5, 0.5, 0.5)).0 + 0.5).abs() < 1e-12);
        }
    }

    #[test]
    fn coincident_faces_of_abutting_bodies_cancel_and_two_sided_sheets_stay() {
        let first = cube(0.0, 1.0);
        let mut second = first.clone();
        second.vertices.iter_mut().for_each(|v| v.x = 2.0 - v.x); // mirrored, so that the same triangles meet at x = 1
        second.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        let (found, faults) = pieces(&joined(&[first.clone(), second]), &Watch::NONE).unwrap();
        assert_eq!((found.len(), &faults), (1, &Faults { facing: 2, ..Faults::default() }));
        assert!((found[0].volume.unwrap() - 2.0).abs() < 1e-12);
        assert_eq!(found[0].walls.len(), 4);
        assert!((found[0].distance.at(&Point::new(1.0, 0.5, 0.4)).0 + 0.4).abs() < 1e-12);
        // Faces that meet may be divided along different diagonals, and end where the surface goes on in their plane.
        let shifted = |[x, y]: [f64; 2], mirrored: bool| {
            let mut cube = first.clone();
            let height = |z: f64| if mirrored { 1.0 - z } else { z };
            cube.vertices.iter_mut().for_each(|v| *v = Point::new(v.x + x, v.y + y, height(v.z)));
            cube.triangles.iter_mut().filter(|_| mirrored).for_each(|t| t.swap(1, 2));
            cube
        };
        let angle = joined(&[first.clone(), shifted([1.0, 0.0], true), shifted([1.0, 1.0], false)]);
        let (found, faults) = pieces(&angle, &Watch::NONE).unwrap();
        assert_eq!((found.len(), found[0].walls.len()), (1, 8), "{faults:?}");
        assert!((found[0].volume.unwrap() - 3.0).abs() < 1e-12);
        let parts = convex_parts(&found[0], 0.01, 256, &Watch::NONE).unwrap();
        assert_eq!((parts.bodies.len(), parts.reach), (2, 0.0));
        assert!((parts.bodies.iter().map(|body| body.volume()).sum::<f64>() - 3.0).abs() < 1e-9);
        let [a, b, c] = first.triangles[0];
        let sheet = TriangleMesh { triangles: vec![[a, b, c], [b, a, c]], ..first };
        let (found, faults) = pieces(&sheet, &Watch::NONE).unwrap();
        assert!(found[0].volume.is_none() && found[0].triangles.len() == 2, "{faults:?}");
        assert!(found[0].distance.at(&sheet.vertices[a]).0 < 1e-12);
    }

    #[test]
    fn corners_are_welded_wherever_they_lie() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(8);
        let mesh = cube(0.0, 1.0);
        let mut shaken = || {
            use rand::RngExt;
            let by = Vector::from_fn(|_, _| rng.random_range(-1e-7..1e-7));
            move |p: Point| p + by
        };
        let soup = TriangleMesh {
            vertices: mesh.triangles.iter().flatten().map(|i| shaken()(mesh.vertices[*i])).collect(),
            triangles: (0..mesh.triangles.len()).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect(),
        };
        let (found, faults) = pieces(&soup, &Watch::NONE).unwrap();
        assert_eq!((found.len(), faults), (1, Faults::default()));
        assert!(found[0].triangles.len() > 12, "corners as given, and as welded");
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
        assert_eq!(with(&|t| t[0].swap(0, 1)), Faults { turned: 1, ..Faults::default() });
        assert_eq!(with(&|t| t.push(t[0])), Faults { doubled: 1, ..Faults::default() });
        assert_eq!(with(&|t| t.push([t[0][0], t[0][1], t[0][1]])), Faults { degenerate: 1, ..Faults::default() });
        let turned = pieces(&inside_out(sound.clone()), &Watch::NONE).unwrap().1;
        assert_eq!(turned, Faults { inside_out: 1, sheets: 1, ..Faults::default() });
        assert_eq!(turned.notes().len(), 2);
        assert!(Faults::default().notes().is_empty());
    }
}
