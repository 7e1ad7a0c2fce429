//! Bodies made of unit cubes of a lattice against an exact answer. A point is inside such a body if all cubes around it
//! belong to the body, however it is divided into convex parts: single cubes, rows, overlapping boxes, pyramids,
//! tetrahedra, parts of the mesh of its surface, several obstacles; axis-parallel or rotated, the cubes stretched or flat.
//! Half of all cables, points and rods are in planes and lines of the lattice, where parts only touch each other.
//!
//! `CDPR_VERIFY=n` runs n times as many cases (`make verify`).

use std::collections::BTreeSet;

use cdpr_core::Scene;
use cdpr_core::collision::{CspaceEngine, GjkEngine, Interference, Validity};
use cdpr_core::geometry::{MeshPiece, Point, Polytope, Rotation, Vector, convex_parts, pieces};
use cdpr_core::limits::MOST_PARTS;
use cdpr_core::model::BodySpec;
use cdpr_core::watch::Watch;
use cdpr_tests::meshes::of_cubes;
use cdpr_tests::scenes::{body_spec, scene_with_a_cable};
use cdpr_tests::{effort, rng, rotation, vector};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// Cubes of a lattice, each with the obstacles that contain it, and convex parts with these cubes as their union.
struct Cubes {
    size: i32,
    of: Vec<BTreeSet<usize>>,
    /// Corners of each part, and its obstacle.
    parts: Vec<(Vec<Point>, usize)>,
}

impl Cubes {
    fn random(rng: &mut ChaCha8Rng, obstacles: usize) -> Self {
        // Divisions of a single cube: the cube itself, its six pyramids from the centre, its six tetrahedra around a
        // diagonal.
        let divisions = [whole as fn(&Span) -> Vec<Vec<Point>>, pyramids, tetrahedra];
        let division = [0, 0, 0, 1, 2][rng.random_range(0..5)];
        let size: i32 = rng.random_range(2..=if division == 0 { 4 } else { 2 });
        let spans: Vec<(Span, usize)> = match rng.random_range(0..3) {
            0 if division == 0 => overlapping(rng, size, obstacles),
            mode => single(rng, size, obstacles, mode == 1 && division == 0),
        };
        let mut of = vec![BTreeSet::new(); size.pow(3) as usize];
        for ([low, high], obstacle) in &spans {
            for (k, cube) in of.iter_mut().enumerate() {
                let at = position(k as i32, size);
                if (0..3).all(|axis| low[axis] <= at[axis] && at[axis] < high[axis]) {
                    cube.insert(*obstacle);
                }
            }
        }
        let parts = spans.iter().flat_map(|(span, k)| divisions[division](span).into_iter().map(|part| (part, *k)));
        Cubes { size, of, parts: parts.collect() }
    }

    /// The convex parts and their obstacles, in the scene; at times those of the mesh of the surface of each obstacle.
    fn bodies(&self, rng: &mut ChaCha8Rng, place: &Place) -> Vec<(Polytope, usize)> {
        if place.scale != Vector::repeat(1.0) || rng.random_bool(0.7) {
            return self.parts.iter().map(|(part, k)| (place.body(part), *k)).collect();
        }
        let of_obstacle = |k: usize| {
            let mut mesh = of_cubes(&|cube| self.at(cube).is_some_and(|of| of.contains(&k)), [self.size; 3]);
            mesh.vertices.iter_mut().for_each(|v| *v = place.point(v));
            let parts = |piece: &MeshPiece| convex_parts(piece, 0.01, MOST_PARTS, &Watch::NONE).unwrap().bodies;
            pieces(&mesh, &Watch::NONE).unwrap().0.iter().flat_map(parts).collect::<Vec<_>>()
        };
        let obstacles: BTreeSet<usize> = self.of.iter().flatten().copied().collect();
        obstacles.into_iter().flat_map(|k| of_obstacle(k).into_iter().map(move |body| (body, k))).collect()
    }

    fn at(&self, [x, y, z]: [i32; 3]) -> Option<&BTreeSet<usize>> {
        let inside = [x, y, z].iter().all(|k| (0..self.size).contains(k));
        inside.then(|| &self.of[((z * self.size + y) * self.size + x) as usize])
    }

    /// Whether a point is inside the body: all cubes around it belong to obstacles that count.
    fn encloses(&self, point: &Point, counts: &dyn Fn(usize) -> bool) -> bool {
        let around = |x: f64| [(x.ceil() - 1.0) as i32, x.floor() as i32];
        let [xs, ys, zs] = [around(point.x), around(point.y), around(point.z)];
        let cubes = xs.iter().flat_map(|x| ys.iter().flat_map(|y| zs.iter().map(|z| [*x, *y, *z])));
        cubes.into_iter().all(|cube| self.at(cube).is_some_and(|of| of.iter().any(|k| counts(*k))))
    }

    /// Whether the convex hull of points in a plane, in their order around it, meets the inside of the body.
    ///
    /// The planes of the lattice divide it into pieces, on each of which all points have the same cubes around them. The
    /// inside is open, so the hull meets it only if a whole piece is in it.
    fn meet(&self, points: &[Point], counts: &dyn Fn(usize) -> bool) -> bool {
        let mut pieces = vec![points.to_vec()];
        for axis in 0..3 {
            for level in 0..=self.size {
                let cut = |piece: &Vec<Point>| {
                    let height = |p: &Point| p[axis] - f64::from(level);
                    if piece.iter().all(|p| height(p) == 0.0) {
                        return vec![piece.clone()];
                    }
                    [1.0, -1.0].map(|sign| below(piece, |p| sign * height(p))).to_vec()
                };
                pieces = pieces.iter().flat_map(cut).filter(|piece| extent(piece) == extent(points)).collect();
            }
        }
        pieces.iter().any(|piece| {
            let middle = piece.iter().map(|p| p.coords).sum::<Vector>() / piece.len() as f64;
            self.encloses(&Point::from(middle), counts)
        })
    }
}

/// The least and the greatest corner of a box of cubes.
type Span = [[i32; 3]; 2];

fn position(k: i32, size: i32) -> [i32; 3] {
    [k % size, k / size % size, k / size.pow(2)]
}

/// Each cube of a lattice belongs to one obstacle or to none; those of a row along x may be one part.
fn single(rng: &mut ChaCha8Rng, size: i32, obstacles: usize, rows: bool) -> Vec<(Span, usize)> {
    let share = [0.5, 0.8, 0.95, 1.0][rng.random_range(0..4)];
    let mut parts: Vec<(Span, usize)> = Vec::new();
    for k in 0..size.pow(3) {
        if k > 0 && !rng.random_bool(share) {
            continue;
        }
        let (low, obstacle) = (position(k, size), rng.random_range(0..obstacles));
        let high = low.map(|x| x + 1);
        match parts.last_mut() {
            Some(([_, end], same)) if rows && *same == obstacle && *end == [low[0], high[1], high[2]] => *end = high,
            _ => parts.push(([low, high], obstacle)),
        }
    }
    parts
}

/// Boxes of several cubes that may overlap.
fn overlapping(rng: &mut ChaCha8Rng, size: i32, obstacles: usize) -> Vec<(Span, usize)> {
    let span = |rng: &mut ChaCha8Rng| {
        let low: [i32; 3] = std::array::from_fn(|_| rng.random_range(0..size));
        [low, low.map(|x| rng.random_range(x + 1..=size))]
    };
    (0..rng.random_range(2..5 * size)).map(|_| (span(rng), rng.random_range(0..obstacles))).collect()
}

fn corner([low, high]: &Span, k: usize) -> Point {
    Point::from(Vector::from_fn(|axis, _| f64::from([low, high][k >> axis & 1][axis])))
}

fn whole(cube: &Span) -> Vec<Vec<Point>> {
    vec![(0..8).map(|k| corner(cube, k)).collect()]
}

fn pyramids(cube: &Span) -> Vec<Vec<Point>> {
    let middle = nalgebra::center(&corner(cube, 0), &corner(cube, 7));
    let face = |k: usize| (0..8).filter(move |corner| corner >> (k / 2) & 1 == k % 2);
    (0..6).map(|k| face(k).map(|k| corner(cube, k)).chain([middle]).collect()).collect()
}

fn tetrahedra(cube: &Span) -> Vec<Vec<Point>> {
    let ways = [[1, 3], [1, 5], [2, 3], [2, 6], [4, 5], [4, 6]];
    ways.map(|[a, b]| [0, a, b, 7].map(|k| corner(cube, k)).to_vec()).to_vec()
}

/// The corners of the part of a convex polygon, segment or point where a height is not positive.
fn below(polygon: &[Point], height: impl Fn(&Point) -> f64) -> Vec<Point> {
    let mut kept = Vec::new();
    for (k, p) in polygon.iter().enumerate() {
        let q = &polygon[(k + 1) % polygon.len()];
        if height(p) <= 0.0 {
            kept.push(*p);
        }
        if height(p) * height(q) < 0.0 {
            // A coordinate in which both agree stays exactly the same.
            kept.push(p + (q - p) * (height(p) / (height(p) - height(q))));
        }
    }
    kept
}

/// Number of dimensions of a hull of points.
fn extent(points: &[Point]) -> usize {
    let Some(first) = points.first() else { return 0 };
    let spokes = || points.iter().map(|p| p - first);
    let Some(longest) = spokes().max_by(|a, b| a.norm().total_cmp(&b.norm())).filter(|s| s.norm() > 1e-9) else {
        return 1;
    };
    if spokes().all(|spoke| spoke.cross(&longest).norm() < 1e-9) { 2 } else { 3 }
}

/// A point of which each coordinate is a multiple of 1/8, often an integer, in and around the lattice.
fn random_place(rng: &mut ChaCha8Rng, size: i32) -> Point {
    let special = rng.random_bool(0.5);
    let step = |rng: &mut ChaCha8Rng| if special && rng.random_bool(0.7) { 8 } else { 1 };
    Point::from(Vector::from_fn(|_, _| {
        let step = step(rng);
        f64::from(rng.random_range(-8 / step..=(size + 1) * 8 / step) * step) / 8.0
    }))
}

/// Another point, with some of the coordinates of the first.
fn beside(rng: &mut ChaCha8Rng, point: &Point, size: i32) -> Point {
    let other = random_place(rng, size);
    Point::from(Vector::from_fn(|k, _| if rng.random_bool(0.5) { point[k] } else { other[k] }))
}

/// Numbers of free and of forbidden states, then of motions.
type Counts = [usize; 4];

/// The ends of a motion, and whether it meets the body.
type Motion = ([Point; 2], bool);

/// Compares both engines with the exact answer on states and motions. `motion` draws one in the lattice, with the answer,
/// and `placed` gives its position in the scene.
fn compare(
    scene: &Scene,
    rng: &mut ChaCha8Rng,
    motion: &dyn Fn(&mut ChaCha8Rng, bool) -> Option<Motion>,
    placed: &dyn Fn(&Point) -> Point,
) -> Counts {
    let cspace = CspaceEngine::new(scene, Interference::Exact).unwrap();
    let gjk = GjkEngine::new(scene, Interference::Exact).unwrap();
    let mut counts = [0; 4];
    for k in 0..110 {
        let is_motion = k % 11 == 0;
        let Some((ends, hit)) = motion(rng, is_motion) else { continue };
        let [from, to] = ends.each_ref().map(placed);
        counts[2 * usize::from(is_motion) + usize::from(hit)] += 1;
        let told = [cspace.motion_valid(&from, &to), gjk.motion_valid(&from, &to)];
        assert!(told == [!hit; 2], "{ends:?}: cspace {}, gjk {}, exact {}", told[0], told[1], !hit);
        if k % 20 == 0 {
            let told = [cspace.violations(&from, &to), gjk.violations(&from, &to)];
            assert!(told.iter().all(|told| told.is_empty() != hit), "{ends:?}: {told:?}, exact {}", !hit);
        }
    }
    counts
}

fn sums(run: impl Fn(&mut ChaCha8Rng) -> Option<Counts> + Sync, first: u64, scenes: u64) -> Counts {
    let seeds = (0..scenes * effort()).into_par_iter();
    let found = seeds.filter_map(|seed| {
        let report = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| run(&mut rng(first + seed))));
        report.unwrap_or_else(|cause| {
            eprintln!("seed {}", first + seed);
            std::panic::resume_unwind(cause)
        })
    });
    let sums = found.reduce(|| [0; 4], |a, b| std::array::from_fn(|k| a[k] + b[k]));
    println!("{} states, {} motions: {sums:?}", sums[0] + sums[1], sums[2] + sums[3]);
    sums
}

/// Where the lattice is in the scene, and how long its cubes are along each axis.
struct Place {
    scale: Vector,
    turn: Rotation,
    shift: Vector,
}

impl Place {
    fn random(rng: &mut ChaCha8Rng) -> Self {
        let scale = match rng.random_bool(0.7) {
            true => Vector::repeat(1.0),
            false => Vector::from_fn(|_, _| [1.0, 0.2, 2.0][rng.random_range(0..3)]),
        };
        let upright = rng.random_bool(0.5);
        let (turn, shift) = if upright { Default::default() } else { (rotation(rng), vector(rng, 5.0)) };
        Place { scale, turn, shift }
    }

    fn direction(&self, in_lattice: &Vector) -> Vector {
        self.turn * in_lattice.component_mul(&self.scale)
    }

    fn point(&self, in_lattice: &Point) -> Point {
        Point::from(self.direction(&in_lattice.coords) + self.shift)
    }

    fn body(&self, corners: &[Point]) -> Polytope {
        let corners: Vec<Point> = corners.iter().map(|corner| self.point(corner)).collect();
        Polytope::hull_of(&corners).unwrap()
    }
}

/// Distance of a point from a segment.
fn distance(point: &Point, [from, to]: [&Point; 2]) -> f64 {
    let along = to - from;
    let share = (along.dot(&(point - from)) / along.norm_squared().max(1e-9)).clamp(0.0, 1.0);
    (from + along * share - point).norm()
}

/// The platform is a point, a rod or a triangle; either it or its cable ignores the obstacles, and some ignore one of
/// several.
fn obstacles(rng: &mut ChaCha8Rng) -> Option<Counts> {
    let count = [1, 1, 3][rng.random_range(0..3)];
    let cubes = Cubes::random(rng, count);
    let size = cubes.size;
    let place = Place::random(rng);
    let names: Vec<String> = (0..count).map(|k| format!("obstacle {k}")).collect();
    let parts = cubes.bodies(rng, &place);
    let bodies: Vec<BodySpec> = parts.iter().map(|(part, k)| body_spec(Some(&names[*k]), part)).collect();
    let by_cable = rng.random_bool(0.5);
    let (heeds, other) = if by_cable { ("cable", "platform") } else { ("platform", "cable") };
    let left_out = if count > 1 { rng.random_range(0..=count) } else { count };
    let there = |name: &&String| bodies.iter().any(|body| body.name.as_ref() == Some(*name));
    let mut ignore: Vec<[&str; 2]> = names.iter().filter(there).map(|name| [other, name.as_str()]).collect();
    ignore.extend(names.get(left_out).filter(there).map(|name| [heeds, name.as_str()]));
    let counts = |k: usize| k != left_out;

    // Corners of the platform, in the lattice, from its origin.
    let corner = |rng: &mut ChaCha8Rng| random_place(rng, 1).coords;
    let dimension = if by_cable { 0 } else { rng.random_range(0..3) };
    let corners: Vec<Vector> = std::iter::once(Vector::zeros()).chain((0..dimension).map(|_| corner(rng))).collect();
    let polygon: Vec<Point> = corners.iter().map(|c| Point::from(*c)).collect();
    if extent(&polygon) != dimension + 1 {
        return None;
    }
    let turned: Vec<Point> = corners.iter().map(|c| Point::from(place.direction(c))).collect();
    let platform = body_spec(None, &Polytope::hull_of(&turned).unwrap());
    let outlet = random_place(rng, size);
    let scene = scene_with_a_cable(vec![platform], [place.point(&outlet), Point::origin()], bodies, &ignore);
    assert_eq!(scene.is_err(), cubes.encloses(&outlet, &|_| true), "outlet {outlet}: {:?}", scene.err());
    let motion = |rng: &mut ChaCha8Rng, is_motion: bool| {
        let from = if by_cable { beside(rng, &outlet, size) } else { random_place(rng, size) };
        let to = if is_motion && dimension < 2 { beside(rng, &from, size) } else { from };
        if distance(&outlet, [&from, &to]) < 1e-6 {
            return None;
        }
        let swept: Vec<Point> = match (by_cable, dimension) {
            (true, _) => vec![outlet, from, to],
            (_, 0) => vec![from, to],
            (_, 1) => vec![from, from + corners[1], to + corners[1], to],
            _ => corners.iter().map(|c| from + c).collect(),
        };
        Some(([from, to], cubes.meet(&swept, &counts)))
    };
    Some(compare(&scene.ok()?, rng, &motion, &|seen| place.point(seen)))
}

/// The platform is made of the cubes; its cable is attached to it or beside it.
fn platforms(rng: &mut ChaCha8Rng) -> Option<Counts> {
    let cubes = Cubes::random(rng, 1);
    let size = cubes.size;
    let place = Place::random(rng);
    let platform = cubes.bodies(rng, &place).iter().map(|(part, _)| body_spec(None, part)).collect();
    let (attachment, outlet) = (random_place(rng, size), Point::from(vector(rng, 3.0)));
    let scene = scene_with_a_cable(platform, [outlet, place.point(&attachment)], Vec::new(), &[]);
    assert_eq!(scene.is_err(), cubes.encloses(&attachment, &|_| true), "attachment {attachment}: {:?}", scene.err());
    // In the lattice of the platform it is the outlet that moves.
    let motion = |rng: &mut ChaCha8Rng, is_motion: bool| {
        let from = beside(rng, &attachment, size);
        let to = if is_motion { beside(rng, &from, size) } else { from };
        let apart = distance(&attachment, [&from, &to]) > 1e-6;
        apart.then(|| ([from, to], cubes.meet(&[attachment, from, to], &|_| true)))
    };
    Some(compare(&scene.ok()?, rng, &motion, &|seen| outlet - place.point(seen).coords))
}

#[test]
fn obstacles_of_cubes_forbid_exactly_the_inside_of_their_union() {
    let sums = sums(obstacles, 0, 200);
    assert!(sums.iter().all(|count| *count > 200), "{sums:?}");
}

#[test]
fn platforms_of_cubes_forbid_cables_exactly_inside_their_union() {
    let sums = sums(platforms, 10_000_000, 150);
    assert!(sums.iter().all(|count| *count > 200), "{sums:?}");
}
