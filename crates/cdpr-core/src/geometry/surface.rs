//! Analysis of a list of triangles: its connected pieces, which of them enclose a body, and its defects.
//!
//! Corners that are equal up to rounding are welded (`welded`), and defects that leave no doubt about the shape are mended
//! (`mending`).

mod mending;
pub mod solid;
mod welded;

use super::{Aabb, Point, TriangleMesh};
use crate::error::Error;
use crate::tolerances::WELD_RELATIVE;
use crate::watch::Watch;
use solid::SignedDistance;
use welded::{Role, Welded, defects};

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
pub struct MeshPiece {
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
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn pieces(mesh: &TriangleMesh, watch: &Watch) -> Result<(Vec<MeshPiece>, Faults), Error> {
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
    let pieces: Vec<Option<MeshPiece>> =
        shells.into_iter().map(|s| welded.piece(s, watch)).collect::<Result<_, _>>()?;
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

impl Welded {
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

    /// A piece; `None` if all triangles of the shell have no area.
    fn piece(&self, shell: Shell, watch: &Watch) -> Result<Option<MeshPiece>, Error> {
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
        Ok(Some(MeshPiece { triangles, walls, distance, volume: shell.volume }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector;
    use crate::geometry::convex_mesh;
    use crate::geometry::convex_parts;
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
    fn separate_bodies_are_pieces_and_cavities_are_not() {
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
    fn flipped_triangles_are_turned_except_on_a_mobius_strip() {
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
    fn t_junctions_are_closed() {
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
    fn coincident_faces_cancel_but_two_sided_sheets_stay() {
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
