//! Bodies made of unit cubes of a lattice against an exact answer. A point is inside such a body if all cubes around it
//! belong to the body, however it is divided into convex parts: single cubes, rows, parts of the mesh of its surface,
//! several obstacles; axis-parallel or rotated. Half of all cables, points and rods are in planes and lines of the lattice, where parts only touch each other.
//!
//! `CDPR_VERIFY=n` runs n times as many cases (`make verify`).

use cdpr_core::Scene;
use cdpr_core::collision::{CspaceEngine, GjkEngine, Interference, Validity};
use cdpr_core::geometry::{Piece, Point, Polytope, Rotation, Vector, convex_parts, pieces};
use cdpr_core::model::BodySpec;
use cdpr_core::numerics::MOST_PARTS;
use cdpr_core::watch::Watch;
use cdpr_tests::meshes::of_cubes;
use cdpr_tests::scenes::{body_spec, scene_with_a_cable};
use cdpr_tests::{effort, rng, rotation, vector};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// Cubes of a lattice, each with the number of the obstacle that it belongs to.
struct Cubes {
    size: i32,
    of: Vec<Option<usize>>,
}

impl Cubes {
    fn random(rng: &mut ChaCha8Rng, obstacles: usize) -> Self {
        let size: i32 = rng.random_range(2..=4);
        let share = [0.5, 0.8, 0.95, 1.0][rng.random_range(0..4)];
        let cube = |rng: &mut ChaCha8Rng| rng.random_bool(share).then(|| rng.random_range(0..obstacles));
        let mut of: Vec<Option<usize>> = (0..size.pow(3)).map(|_| cube(rng)).collect();
        of[0] = Some(0);
        Cubes { size, of }
    }

    fn at(&self, [x, y, z]: [i32; 3]) -> Option<usize> {
        let inside = [x, y, z].iter().all(|k| (0..self.size).contains(k));
        inside.then(|| self.of[((z * self.size + y) * self.size + x) as usize]).flatten()
    }

    /// The least and the greatest corner of each convex part, and its obstacle: single cubes, or rows along x.
    fn parts(&self, rows: bool) -> Vec<([Point; 2], usize)> {
        let mut parts: Vec<([Point; 2], usize)> = Vec::new();
        for k in 0..self.size.pow(3) {
            let [x, y, z] = [k % self.size, k / self.size % self.size, k / self.size.pow(2)];
            let Some(obstacle) = self.at([x, y, z]) else { continue };
            let [x, y, z] = [x, y, z].map(f64::from);
            let (low, high) = (Point::new(x, y, z), Point::new(x + 1.0, y + 1.0, z + 1.0));
            match parts.last_mut() {
                Some(([_, end], same)) if rows && *same == obstacle && *end == Point::new(x, y + 1.0, z + 1.0) => {
                    *end = high;
                }
                _ => parts.push(([low, high], obstacle)),
            }
        }
        parts
    }

    /// The convex parts and their obstacles, turned and moved, in one of three ways: single cubes, rows, or parts of the
    /// mesh of the surface of each obstacle.
    fn bodies(&self, rng: &mut ChaCha8Rng, (turn, shift): (&Rotation, &Vector)) -> Vec<(Polytope, usize)> {
        let way = rng.random_range(0..3);
        if way < 2 {
            let parts = self.parts(way == 1);
            return parts.into_iter().map(|(span, k)| (part(&span, turn, shift), k)).collect();
        }
        let of_obstacle = |k: usize| {
            let mut mesh = of_cubes(&|cube| self.at(cube) == Some(k), [self.size; 3]);
            mesh.vertices.iter_mut().for_each(|v| *v = *turn * *v + shift);
            let parts = |piece: &Piece| convex_parts(piece, 0.01, MOST_PARTS, &Watch::NONE).unwrap().bodies;
            pieces(&mesh, &Watch::NONE).unwrap().0.iter().flat_map(parts).collect::<Vec<_>>()
        };
        let obstacles = self.of.iter().flatten().max().map_or(0, |last| last + 1);
        (0..obstacles).flat_map(|k| of_obstacle(k).into_iter().map(move |body| (body, k))).collect()
    }

    /// Whether a point is inside the body: all cubes around it belong to obstacles that count.
    fn encloses(&self, point: &Point, counts: &dyn Fn(usize) -> bool) -> bool {
        let around = |x: f64| [(x.ceil() - 1.0) as i32, x.floor() as i32];
        let [xs, ys, zs] = [around(point.x), around(point.y), around(point.z)];
        let cubes = xs.iter().flat_map(|x| ys.iter().flat_map(|y| zs.iter().map(|z| [*x, *y, *z])));
        cubes.into_iter().all(|cube| self.at(cube).is_some_and(counts))
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
fn place(rng: &mut ChaCha8Rng, size: i32) -> Point {
    let special = rng.random_bool(0.5);
    let step = |rng: &mut ChaCha8Rng| if special && rng.random_bool(0.7) { 8 } else { 1 };
    Point::from(Vector::from_fn(|_, _| {
        let step = step(rng);
        f64::from(rng.random_range(-8 / step..=(size + 1) * 8 / step) * step) / 8.0
    }))
}

/// Another point, with some of the coordinates of the first.
fn beside(rng: &mut ChaCha8Rng, point: &Point, size: i32) -> Point {
    let other = place(rng, size);
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

/// A rotation and a shift; none for half of the scenes.
fn pose(rng: &mut ChaCha8Rng) -> (Rotation, Vector) {
    if rng.random_bool(0.5) { (Rotation::identity(), Vector::zeros()) } else { (rotation(rng), vector(rng, 5.0)) }
}

fn part([low, high]: &[Point; 2], turn: &Rotation, shift: &Vector) -> Polytope {
    let corner = |k: usize| Point::from(Vector::from_fn(|axis, _| [low, high][k >> axis & 1][axis]));
    let corners: Vec<Point> = (0..8).map(|k| turn * corner(k) + shift).collect();
    Polytope::hull_of(&corners).unwrap()
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
    let (turn, shift) = pose(rng);
    let placed = |p: &Point| turn * p + shift;
    let names: Vec<String> = (0..count).map(|k| format!("obstacle {k}")).collect();
    let bodies = cubes.bodies(rng, (&turn, &shift)).into_iter().map(|(body, k)| body_spec(Some(&names[k]), &body));
    let bodies: Vec<BodySpec> = bodies.collect();
    let by_cable = rng.random_bool(0.5);
    let (heeds, other) = if by_cable { ("cable", "platform") } else { ("platform", "cable") };
    let left_out = if count > 1 { rng.random_range(0..=count) } else { count };
    let there = |name: &&String| bodies.iter().any(|body| body.name.as_ref() == Some(*name));
    let mut ignore: Vec<[&str; 2]> = names.iter().filter(there).map(|name| [other, name.as_str()]).collect();
    ignore.extend(names.get(left_out).filter(there).map(|name| [heeds, name.as_str()]));
    let counts = |k: usize| k != left_out;

    // Corners of the platform, in the lattice, from its origin.
    let corner = |rng: &mut ChaCha8Rng| place(rng, 1).coords;
    let dimension = if by_cable { 0 } else { rng.random_range(0..3) };
    let corners: Vec<Vector> = std::iter::once(Vector::zeros()).chain((0..dimension).map(|_| corner(rng))).collect();
    let polygon: Vec<Point> = corners.iter().map(|c| Point::from(*c)).collect();
    if extent(&polygon) != dimension + 1 {
        return None;
    }
    let turned: Vec<Point> = corners.iter().map(|c| Point::from(turn * c)).collect();
    let platform = body_spec(None, &Polytope::hull_of(&turned).unwrap());
    let outlet = place(rng, size);
    let scene = scene_with_a_cable(vec![platform], [placed(&outlet), Point::origin()], bodies, &ignore).ok()?;
    let motion = |rng: &mut ChaCha8Rng, is_motion: bool| {
        let from = if by_cable { beside(rng, &outlet, size) } else { place(rng, size) };
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
    Some(compare(&scene, rng, &motion, &placed))
}

/// The platform is made of the cubes; its cable is attached to it or beside it.
fn platforms(rng: &mut ChaCha8Rng) -> Option<Counts> {
    let cubes = Cubes::random(rng, 1);
    let size = cubes.size;
    let (turn, shift) = pose(rng);
    let platform = cubes.bodies(rng, (&turn, &shift)).iter().map(|(body, _)| body_spec(None, body)).collect();
    let (attachment, outlet) = (place(rng, size), Point::from(vector(rng, 3.0)));
    let scene = scene_with_a_cable(platform, [outlet, turn * attachment + shift], Vec::new(), &[]).ok()?;
    // In the lattice of the platform it is the outlet that moves.
    let motion = |rng: &mut ChaCha8Rng, is_motion: bool| {
        let from = beside(rng, &attachment, size);
        let to = if is_motion { beside(rng, &from, size) } else { from };
        let apart = distance(&attachment, [&from, &to]) > 1e-6;
        apart.then(|| ([from, to], cubes.meet(&[attachment, from, to], &|_| true)))
    };
    Some(compare(&scene, rng, &motion, &|seen| outlet - (turn * seen + shift).coords))
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
