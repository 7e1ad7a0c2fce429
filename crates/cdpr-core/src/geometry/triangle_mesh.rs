//! Closed triangle meshes.

use std::collections::BTreeMap;

use super::{Point, Vector};

/// A closed surface of triangles.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TriangleMesh {
    /// Corners of the triangles, m.
    pub vertices: Vec<Point>,
    /// Corners of each triangle in counter-clockwise order seen from outside, as indices into the vertices.
    pub triangles: Vec<[usize; 3]>,
}

impl TriangleMesh {
    /// The surface of faces given by their corners in counter-clockwise order; the faces are convex.
    pub(crate) fn of_faces(vertices: Vec<Point>, faces: &[Vec<usize>]) -> Self {
        let fan = |face: &Vec<usize>| {
            let corners = face.clone();
            (1..corners.len() - 1).map(move |k| [corners[0], corners[k], corners[k + 1]])
        };
        TriangleMesh { triangles: faces.iter().flat_map(fan).collect(), vertices }
    }

    /// Adds another surface; the two share no vertices.
    pub fn append(&mut self, other: &TriangleMesh) {
        let shift = self.vertices.len();
        self.vertices.extend(&other.vertices);
        self.triangles.extend(other.triangles.iter().map(|t| t.map(|i| i + shift)));
    }

    /// Directed edges of all triangles.
    pub fn edges(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        self.triangles.iter().flat_map(|&[i, j, k]| [[i, j], [j, k], [k, i]])
    }

    /// Whether every edge belongs to exactly two triangles, which run through it in opposite directions: the surface is
    /// closed and consistently oriented.
    pub fn is_watertight(&self) -> bool {
        let mut uses: BTreeMap<[usize; 2], u32> = BTreeMap::new();
        self.edges().for_each(|edge| *uses.entry(edge).or_default() += 1);
        uses.iter().all(|([i, j], count)| i != j && *count == 1 && uses.contains_key(&[*j, *i]))
    }

    /// Enclosed volume, m³: positive if the normals point outward; overlaps of closed pieces count multiply.
    pub fn volume(&self) -> f64 {
        let Some(origin) = self.vertices.first() else { return 0.0 };
        let spoke = |i: usize| self.vertices[i] - origin;
        self.triangles.iter().map(|&[i, j, k]| spoke(i).dot(&spoke(j).cross(&spoke(k)))).sum::<f64>() / 6.0
    }

    /// Area of the surface, m².
    pub fn area(&self) -> f64 {
        self.triangles.iter().map(|t| 0.5 * self.doubled_area(t).norm()).sum()
    }

    /// Outward unit normal of a triangle; `None` if it has no area.
    pub fn normal(&self, triangle: &[usize; 3]) -> Option<Vector> {
        self.doubled_area(triangle).try_normalize(0.0)
    }

    fn doubled_area(&self, &[i, j, k]: &[usize; 3]) -> Vector {
        let [a, b, c] = [self.vertices[i], self.vertices[j], self.vertices[k]];
        (b - a).cross(&(c - a))
    }

    /// The surface with its vertices rounded to single precision. Vertices that are connected by an edge and become
    /// equal are merged, so that the surface stays closed in file formats that list triangles by coordinates.
    pub fn in_single_precision(&self) -> Self {
        let rounded = |p: &Point| p.map(|x| f64::from(x as f32));
        let vertices = self.vertices.iter().map(rounded).collect();
        TriangleMesh { vertices, triangles: self.triangles.clone() }.without_short_edges(0.0)
    }

    /// The surface with edges up to a length, m, contracted to a point, unless the surface would not remain closed.
    pub(super) fn without_short_edges(mut self, shortest: f64) -> Self {
        while let Some([i, j]) = self.short_edge(shortest) {
            self.triangles.retain(|t| !(t.contains(&i) && t.contains(&j)));
            self.triangles.iter_mut().flatten().filter(|v| **v == j).for_each(|v| *v = i);
        }
        self.compact()
    }

    fn short_edge(&self, shortest: f64) -> Option<[usize; 2]> {
        self.edges().find(|edge| self.may_contract(edge, shortest))
    }

    /// Whether an edge is short and its ends share only the two triangles beside it (the link condition: contraction
    /// then changes neither genus nor closedness).
    fn may_contract(&self, &[i, j]: &[usize; 2], shortest: f64) -> bool {
        if i > j || (self.vertices[j] - self.vertices[i]).norm() > shortest {
            return false;
        }
        let neighbours = |v: usize| self.triangles.iter().filter(move |t| t.contains(&v)).flatten();
        let mut common: Vec<usize> = neighbours(i).copied().filter(|k| neighbours(j).any(|l| l == k)).collect();
        common.retain(|k| *k != i && *k != j);
        common.sort_unstable();
        common.dedup();
        let [a, b] = common[..] else { return false };
        let is_face = |v: usize| self.triangles.iter().any(|t| [v, a, b].iter().all(|corner| t.contains(corner)));
        !(is_face(i) && is_face(j)) // both only in a tetrahedron, which has no vertex to spare
    }

    /// Removes the vertices that no triangle uses.
    fn compact(self) -> Self {
        let mut place = vec![None; self.vertices.len()];
        let mut vertices = Vec::new();
        let mut moved = |i: usize| {
            *place[i].get_or_insert_with(|| {
                vertices.push(self.vertices[i]);
                vertices.len() - 1
            })
        };
        let triangles = self.triangles.iter().map(|t| t.map(&mut moved)).collect();
        TriangleMesh { vertices, triangles }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tetrahedron() -> TriangleMesh {
        let vertices = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point::from).to_vec();
        TriangleMesh { vertices, triangles: vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]] }
    }

    #[test]
    fn a_tetrahedron_is_closed_with_its_volume_and_area() {
        let mesh = tetrahedron();
        assert!(mesh.is_watertight());
        assert!((mesh.volume() - 1.0 / 6.0).abs() < 1e-15);
        assert!((mesh.area() - (1.5 + 0.75f64.sqrt())).abs() < 1e-15);
    }

    #[test]
    fn holes_turned_triangles_and_doubled_ones_are_not_watertight() {
        let mesh = tetrahedron();
        let with = |triangles: Vec<[usize; 3]>| TriangleMesh { triangles, ..mesh.clone() };
        assert!(!with(mesh.triangles[1..].to_vec()).is_watertight());
        let mut turned = mesh.triangles.clone();
        turned[0].swap(0, 1);
        assert!(!with(turned).is_watertight());
        assert!(!with([mesh.triangles.clone(), mesh.triangles.clone()].concat()).is_watertight());
        assert!(!with([mesh.triangles.clone(), vec![[0, 0, 0]]].concat()).is_watertight());
    }

    #[test]
    fn surfaces_side_by_side_stay_closed() {
        let mut pair = tetrahedron();
        pair.append(&tetrahedron());
        assert!(pair.is_watertight() && pair.vertices.len() == 8);
        assert!((pair.volume() - 1.0 / 3.0).abs() < 1e-15);
    }

    #[test]
    fn vertices_that_single_precision_makes_equal_are_merged() {
        // A tetrahedron with one corner cut off so close to it that the three new corners round to the old one.
        let t = 1e-12;
        let cut = [[1.0 - t, 0.0, 0.0], [1.0 - t, t, 0.0], [1.0 - t, 0.0, t]];
        let vertices = [&[[0.0; 3], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], &cut[..]].concat();
        let vertices = vertices.into_iter().map(|v| Point::from(v) + Vector::repeat(1.0)).collect();
        let faces = [vec![0, 1, 4, 3], vec![0, 3, 5, 2], vec![0, 2, 1], vec![1, 2, 5, 4], vec![3, 4, 5]];
        let mesh = TriangleMesh::of_faces(vertices, &faces);
        let rounded = mesh.in_single_precision();
        assert!(mesh.is_watertight() && rounded.is_watertight());
        assert_eq!((mesh.triangles.len(), rounded.triangles.len(), rounded.vertices.len()), (8, 4, 4));
    }
}
