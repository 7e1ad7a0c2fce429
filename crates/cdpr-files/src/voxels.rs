//! The boxes of a proved workspace as voxels of one size, and the surface of those inside.

use std::collections::HashMap;

use cdpr_core::geometry::{Point, TriangleMesh};
use cdpr_core::limits::MOST_VOXELS;
use cdpr_core::tolerances::FLAT;
use cdpr_core::workspace::{Boxes, Workspace};

/// Voxels as small as the smallest boxes, or larger if there would be too many; x varies fastest.
pub(super) struct Voxels {
    /// The lowest corner, m.
    pub origin: [f64; 3],
    /// Sides of a voxel, m.
    pub spacing: [f64; 3],
    /// Number of voxels along each axis.
    pub counts: [usize; 3],
    /// 1 if all positions of a voxel are valid, -1 if none is, otherwise 0.
    pub verdict: Vec<i8>,
}

impl Voxels {
    pub(super) fn of(found: &Workspace) -> Self {
        let Boxes { lower, upper, verdict, .. } = &found.boxes;
        let (min, max) = (found.within.min, found.within.max);
        let size: [f64; 3] = std::array::from_fn(|axis| max[axis] - min[axis]);
        let side = |axis: usize| (0..lower.len()).map(|k| upper[k][axis] - lower[k][axis]).fold(size[axis], f64::min);
        // Sides are the size of the whole over powers of two.
        let halvings =
            |axis: usize| if size[axis] > FLAT { (size[axis] / side(axis)).log2().round() as i32 } else { 0 };
        let mut halved: [i32; 3] = std::array::from_fn(halvings);
        while halved.iter().sum::<i32>() > MOST_VOXELS.ilog2() as i32 {
            let most = *halved.iter().max().expect("three axes");
            halved = halved.map(|n| if n == most { n - 1 } else { n });
        }
        let counts = halved.map(|n| 1usize << n);
        let spacing: [f64; 3] = std::array::from_fn(|axis| size[axis] / counts[axis] as f64);
        let mut voxels = vec![None; counts.iter().product()];
        for k in 0..verdict.len() {
            let place = |x: f64, axis: usize| {
                if spacing[axis] > 0.0 { (x - min[axis]) / spacing[axis] } else { 0.0 }
            };
            let range = |axis: usize| {
                let (low, high) = (place(lower[k][axis], axis), place(upper[k][axis], axis));
                let first = ((low + ON_WALL).floor().max(0.0) as usize).min(counts[axis] - 1);
                first..((high - ON_WALL).ceil().max(0.0) as usize).clamp(first + 1, counts[axis])
            };
            for z in range(2) {
                for y in range(1) {
                    for x in range(0) {
                        let voxel: &mut Option<i64> = &mut voxels[x + counts[0] * (y + counts[1] * z)];
                        *voxel = Some(if voxel.is_none_or(|known| known == verdict[k]) { verdict[k] } else { 0 });
                    }
                }
            }
        }
        // A flat box gets some thickness, for programs that show nothing without.
        let thick = spacing.iter().copied().fold(FLAT, f64::max);
        let is_flat = |axis: usize| size[axis] <= FLAT;
        Voxels {
            origin: std::array::from_fn(|axis| if is_flat(axis) { min[axis] - 0.5 * thick } else { min[axis] }),
            spacing: std::array::from_fn(|axis| if is_flat(axis) { thick } else { spacing[axis] }),
            counts,
            verdict: voxels.into_iter().map(|voxel| voxel.unwrap_or(0) as i8).collect(),
        }
    }

    fn is_inside(&self, at: [i64; 3]) -> bool {
        let within = (0..3).all(|axis| (0..self.counts[axis] as i64).contains(&at[axis]));
        let [x, y, z] = at.map(|n| n as usize);
        within && self.verdict[x + self.counts[0] * (y + self.counts[1] * z)] == 1
    }

    /// The surface of all voxels inside, with outward normals.
    pub(super) fn surface(&self) -> TriangleMesh {
        let mut surface = TriangleMesh::default();
        let mut known: HashMap<[i64; 3], usize> = HashMap::new();
        let [nx, ny, nz] = self.counts.map(|n| n as i64);
        let places = (0..nz).flat_map(|z| (0..ny).flat_map(move |y| (0..nx).map(move |x| [x, y, z])));
        for at in places.filter(|at| self.is_inside(*at)) {
            for (axis, upward) in (0..6).map(|face| (face / 2, face % 2 == 1)) {
                let mut beyond = at;
                beyond[axis] += if upward { 1 } else { -1 };
                if self.is_inside(beyond) {
                    continue;
                }
                // Counter-clockwise seen from beyond.
                let (mut a, mut b) = ((axis + 1) % 3, (axis + 2) % 3);
                if !upward {
                    std::mem::swap(&mut a, &mut b);
                }
                let corner = |along_a: i64, along_b: i64| {
                    let mut corner = at;
                    corner[axis] += i64::from(upward);
                    corner[a] += along_a;
                    corner[b] += along_b;
                    corner
                };
                let [p, q, r, s] = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)].map(|corner| {
                    *known.entry(corner).or_insert_with(|| {
                        let at = |axis: usize| self.origin[axis] + self.spacing[axis] * corner[axis] as f64;
                        surface.vertices.push(Point::new(at(0), at(1), at(2)));
                        surface.vertices.len() - 1
                    })
                });
                surface.triangles.extend([[p, q, r], [p, r, s]]);
            }
        }
        surface
    }
}

/// A box that reaches less than this share of a voxel into it does so by rounding.
const ON_WALL: f64 = 1e-6;
