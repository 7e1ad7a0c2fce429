//! Distance from a surface of triangles, signed where the surface encloses something. parry's hierarchy of boxes finds
//! the nearest triangle; here its vectors (glam) meet ours.

use parry3d_f64::math::Vector as Glam;
use parry3d_f64::query::PointQueryWithLocation;
use parry3d_f64::shape::{TriMesh, TriMeshFlags};

use super::Point;

/// A surface that can be asked for distances.
pub struct SignedDistance {
    mesh: TriMesh,
    closed: bool,
}

impl SignedDistance {
    /// Of triangles over points; `closed` if they enclose a body, counter-clockwise seen from outside. None without
    /// triangles.
    pub fn new(points: &[Point], triangles: &[[usize; 3]], closed: bool) -> Option<Self> {
        let vertices = points.iter().map(|p| Glam::new(p.x, p.y, p.z)).collect();
        let indices = triangles.iter().map(|t| t.map(|i| i as u32)).collect();
        let mesh = TriMesh::with_flags(vertices, indices, TriMeshFlags::ORIENTED).ok()?;
        Some(Self { mesh, closed })
    }

    /// Distance of a point, m, negative inside the body, and the nearest point of the surface.
    pub fn at(&self, point: &Point) -> (f64, Point) {
        let (found, _) = self.mesh.project_local_point_and_get_location(Glam::new(point.x, point.y, point.z), false);
        let nearest = Point::new(found.point.x, found.point.y, found.point.z);
        let distance = (nearest - point).norm();
        (if self.closed && found.is_inside { -distance } else { distance }, nearest)
    }
}
