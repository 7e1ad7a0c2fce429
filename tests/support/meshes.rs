//! Meshes made by tests, and their files.

use std::fs;
use std::path::Path;

use cdpr_core::geometry::{Point, Rotation, TriangleMesh, Vector};

/// Faces of a body made by extruding a polygon (counter-clockwise) from one height to another.
pub fn prism(base: &[[f64; 2]], from: f64, to: f64, caps: &[[usize; 3]]) -> TriangleMesh {
    let n = base.len();
    let vertices = [from, to].iter().flat_map(|z| base.iter().map(|[x, y]| Point::new(*x, *y, *z))).collect();
    let mut triangles = Vec::new();
    for &[a, b, c] in caps {
        triangles.extend([[a, c, b], [a + n, b + n, c + n]]);
    }
    for i in 0..n {
        let j = (i + 1) % n;
        triangles.extend([[i, j, j + n], [i, j + n, i + n]]);
    }
    TriangleMesh { vertices, triangles }
}

pub fn block(from: [f64; 3], to: [f64; 3]) -> TriangleMesh {
    let base = [[from[0], from[1]], [to[0], from[1]], [to[0], to[1]], [from[0], to[1]]];
    prism(&base, from[2], to[2], &[[0, 1, 2], [0, 2, 3]])
}

pub fn turned(mesh: &TriangleMesh, rotation: &Rotation) -> TriangleMesh {
    TriangleMesh { vertices: mesh.vertices.iter().map(|v| rotation * v).collect(), ..mesh.clone() }
}

pub fn joined(parts: &[TriangleMesh]) -> TriangleMesh {
    let mut whole = TriangleMesh::default();
    parts.iter().for_each(|part| whole.append(part));
    whole
}

pub fn inside_out(mut mesh: TriangleMesh) -> TriangleMesh {
    mesh.triangles.iter_mut().for_each(|t| t.swap(0, 1));
    mesh
}

/// A column with a foot, one body: an L extruded 0.3 m along y.
pub fn angle() -> TriangleMesh {
    let outline = [[0.85, 0.0], [1.6, 0.0], [1.6, 0.1], [1.15, 0.1], [1.15, 1.5], [0.85, 1.5]];
    let caps = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]];
    let upright = Rotation::from_axis_angle(&Vector::x_axis(), std::f64::consts::FRAC_PI_2);
    let mut mesh = turned(&prism(&outline, 0.0, 0.3, &caps), &upright); // (x, z, -y) -> (x, y, z)
    mesh.vertices.iter_mut().for_each(|v| v.y += 1.15);
    mesh
}

/// A table as a single surface: a plate with four legs that grow out of it.
pub fn table() -> TriangleMesh {
    let ([from, to], [low, high]) = ([[-0.6, -0.6], [2.6, 2.6]], [2.2, 2.3]);
    let width = 0.2;
    let lines = |k: usize| [from[k], from[k] + width, to[k] - width, to[k]];
    let (xs, ys) = (lines(0), lines(1));
    let mut mesh = TriangleMesh::default();
    let mut quad = |corners: [[f64; 3]; 4]| {
        let vertices = corners.map(Point::from).to_vec();
        mesh.append(&TriangleMesh { vertices, triangles: vec![[0, 1, 2], [0, 2, 3]] });
    };
    let is_leg = |i: usize, j: usize| i != 1 && j != 1;
    for i in 0..3 {
        for j in 0..3 {
            let ([x, u], [y, v]) = ([xs[i], xs[i + 1]], [ys[j], ys[j + 1]]);
            let bottom = if is_leg(i, j) { 0.0 } else { low };
            quad([[x, y, high], [u, y, high], [u, v, high], [x, v, high]]);
            quad([[x, y, bottom], [x, v, bottom], [u, v, bottom], [u, y, bottom]]);
            let mut side = |a: [f64; 2], b: [f64; 2], outer: bool| {
                if is_leg(i, j) {
                    quad([[a[0], a[1], 0.0], [b[0], b[1], 0.0], [b[0], b[1], low], [a[0], a[1], low]]);
                }
                if outer {
                    quad([[a[0], a[1], low], [b[0], b[1], low], [b[0], b[1], high], [a[0], a[1], high]]);
                }
            };
            side([x, y], [u, y], j == 0);
            side([u, y], [u, v], i == 2);
            side([u, v], [x, v], j == 2);
            side([x, v], [x, y], i == 0);
        }
    }
    mesh
}

pub fn torus(around: usize, across: usize) -> TriangleMesh {
    let (large, small, middle) = (0.62, 0.1, Vector::new(1.0, 1.0, 1.0));
    let angle = |k: usize, n: usize| 2.0 * std::f64::consts::PI * k as f64 / n as f64;
    let vertex = |k: usize| {
        let (u, v) = (angle(k / across, around), angle(k % across, across));
        let reach = large + small * v.cos();
        Point::new(reach * u.cos(), reach * u.sin(), small * v.sin()) + middle
    };
    let at = |i: usize, j: usize| (i % around) * across + j % across;
    let quads = (0..around * across).map(|k| (k / across, k % across));
    let triangles = quads.flat_map(|(i, j)| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    TriangleMesh { vertices: (0..around * across).map(vertex).collect(), triangles: triangles.collect() }
}

/// A closed room: walls 0.2 m thick around a hollow of 3.2 m.
pub fn room() -> TriangleMesh {
    joined(&[block([-0.8; 3], [2.8; 3]), inside_out(block([-0.6; 3], [2.6; 3]))])
}

pub fn write_obj(path: &Path, mesh: &TriangleMesh, scale: f64) {
    let vertices = mesh.vertices.iter().map(|v| format!("v {} {} {}\n", v.x / scale, v.y / scale, v.z / scale));
    let faces = mesh.triangles.iter().map(|[a, b, c]| format!("f {} {} {}\n", a + 1, b + 1, c + 1));
    fs::write(path, vertices.chain(faces).collect::<String>()).unwrap();
}

pub fn write_stl(path: &Path, mesh: &TriangleMesh) {
    let single = |p: Point| stl_io::Vertex::new([p.x as f32, p.y as f32, p.z as f32]);
    let triangle = |t: &[usize; 3]| stl_io::Triangle {
        normal: stl_io::Vertex::new([0.0; 3]),
        vertices: t.map(|i| single(mesh.vertices[i])),
    };
    let mut bytes = Vec::new();
    stl_io::write_stl(&mut bytes, mesh.triangles.iter().map(triangle)).unwrap();
    fs::write(path, bytes).unwrap();
}

/// A closed surface of revolution around the z axis: radius and height as functions of the fraction from one pole to
/// the other, 0 to 1.
pub fn revolved(around: usize, across: usize, outline: impl Fn(f64) -> [f64; 2]) -> TriangleMesh {
    let mut vertices = Vec::new();
    for i in 1..across {
        let [radius, height] = outline(i as f64 / across as f64);
        for j in 0..around {
            let turn = std::f64::consts::TAU * j as f64 / around as f64;
            vertices.push(Point::new(radius * turn.cos(), radius * turn.sin(), height));
        }
    }
    let poles = [vertices.len(), vertices.len() + 1];
    vertices.extend([0.0, 1.0].map(|way| Point::new(0.0, 0.0, outline(way)[1])));
    let at = |i: usize, j: usize| (i - 1) * around + j % around;
    let mut triangles = Vec::new();
    for j in 0..around {
        triangles.push([poles[0], at(1, j + 1), at(1, j)]);
        triangles.push([poles[1], at(across - 1, j), at(across - 1, j + 1)]);
        for i in 1..across - 1 {
            triangles.extend([[at(i, j), at(i, j + 1), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i + 1, j)]]);
        }
    }
    TriangleMesh { vertices, triangles }
}

/// A ball of radius 0.5 m.
pub fn ball(around: usize, across: usize) -> TriangleMesh {
    revolved(around, across, |way| {
        let angle = std::f64::consts::PI * way;
        [0.5 * angle.sin(), -0.5 * angle.cos()]
    })
}

/// A capsule 1.2 m long, 0.4 m wide.
pub fn capsule(around: usize, across: usize) -> TriangleMesh {
    revolved(around, across, |way| {
        let angle = std::f64::consts::PI * way;
        [0.2 * angle.sin(), -0.2 * angle.cos() + if way > 0.5 { 0.4 } else { -0.4 }]
    })
}

/// A ball with nearly equal triangles: an icosahedron whose triangles are repeatedly divided into four.
pub fn icosphere(levels: usize, radius: f64) -> TriangleMesh {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let corner = |k: usize| {
        let mut v = [0.0; 3];
        v[k / 4] = if k & 1 == 0 { 1.0 } else { -1.0 };
        v[(k / 4 + 1) % 3] = if k & 2 == 0 { golden } else { -golden };
        Point::from(Vector::from(v).normalize() * radius)
    };
    let mut vertices: Vec<Point> = (0..12).map(corner).collect();
    let side = 2.0 * radius / (1.0 + golden * golden).sqrt();
    let mut triangles = Vec::new();
    for [a, b, c] in (0..12).flat_map(|a| (0..a).flat_map(move |b| (0..b).map(move |c| [a, b, c]))) {
        let [p, q, r] = [a, b, c].map(|i| vertices[i].coords);
        if [p - q, q - r, r - p].iter().all(|edge| (edge.norm() - side).abs() < 1e-6 * radius) {
            triangles.push(if (q - p).cross(&(r - p)).dot(&p) > 0.0 { [a, b, c] } else { [a, c, b] });
        }
    }
    for _ in 0..levels {
        let mut middles = std::collections::HashMap::new();
        let mut finer = Vec::new();
        for [a, b, c] in triangles {
            let [ab, bc, ca] = [[a, b], [b, c], [c, a]].map(|[i, j]: [usize; 2]| {
                *middles.entry([i.min(j), i.max(j)]).or_insert_with(|| {
                    vertices.push(Point::from((vertices[i].coords + vertices[j].coords).normalize() * radius));
                    vertices.len() - 1
                })
            });
            finer.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
        }
        triangles = finer;
    }
    TriangleMesh { vertices, triangles }
}

/// The surface of a body made of unit cubes, from its squares: each with two triangles, all corners shared.
pub fn of_cubes(filled: &dyn Fn([i32; 3]) -> bool, size: [i32; 3]) -> TriangleMesh {
    let mut mesh = TriangleMesh::default();
    let mut places = std::collections::HashMap::new();
    for x in 0..size[0] {
        for y in 0..size[1] {
            for z in 0..size[2] {
                let at = [x, y, z];
                for (axis, up) in (0..3).flat_map(|axis| [(axis, 0), (axis, 1)]) {
                    let mut beside = at;
                    beside[axis] += 2 * up - 1;
                    let within = (0..3).all(|a| (0..size[a]).contains(&beside[a]));
                    if !filled(at) || (within && filled(beside)) {
                        continue;
                    }
                    let corner = |u: i32, v: i32| {
                        let mut corner = at;
                        corner[axis] += up;
                        corner[(axis + 1) % 3] += u;
                        corner[(axis + 2) % 3] += v;
                        corner
                    };
                    let square = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)].map(|corner| {
                        *places.entry(corner).or_insert_with(|| {
                            mesh.vertices.push(Point::from(corner.map(f64::from)));
                            mesh.vertices.len() - 1
                        })
                    });
                    let [a, b, c, d] = square;
                    mesh.triangles.extend(if up == 1 { [[a, b, c], [a, c, d]] } else { [[a, c, b], [a, d, c]] });
                }
            }
        }
    }
    mesh
}
