//! The gjk engine on whole scenes against slow exact tests that share no code with it: clipping for cables against
//! bodies, hulls of Minkowski differences for the platform, dense sampling for pairs of cables.
//!
//! The oracle answers hit or free only where that is proved by more than the tolerance; in between either is right.

mod support;

use cdpr_core::collision::{Checker, GjkEngine, Interference, Validity};
use cdpr_core::geometry::{Point, Polytope, Rotation, Vector};
use cdpr_core::model::{BodySpec, CableSpec, QuerySpec, RobotSource, RobotSpec, Scene, SceneSpec, WorkspaceSpec};
use cdpr_core::numerics::GAP_TOLERANCE;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use support::{body, clipped, direction, rng, rotation, surface_point, uniform, vector};

#[derive(Debug, Clone, Copy, PartialEq)]
enum Verdict {
    Hit,
    Free,
    Either,
}

fn body_spec(name: Option<&str>, body: &Polytope) -> BodySpec {
    let vertices = body.vertices().iter().map(|v| [v.x, v.y, v.z]).collect();
    BodySpec { name: name.map(str::to_string), vertices: Some(vertices), ..BodySpec::default() }
}

/// A platform of one to three parts, some of them flat, a segment or a point.
fn platform(rng: &mut ChaCha8Rng) -> Vec<Polytope> {
    let part = |rng: &mut ChaCha8Rng| {
        let sides: [f64; 3] = std::array::from_fn(|_| uniform(rng, 0.05, 0.4));
        let flat = match rng.random_range(0..6) {
            0 => [sides[0], sides[1], 0.0],
            1 => [sides[0], 0.0, 0.0],
            2 => [0.0; 3],
            _ => return if rng.random_bool(0.5) { body(rng) } else { Polytope::cuboid(sides).unwrap() },
        };
        Polytope::cuboid(flat).unwrap()
    };
    let count = rng.random_range(1..4);
    (0..count).map(|_| part(rng).transformed(&rotation(rng), &vector(rng, 0.3))).collect()
}

/// On a part (inside a facet, on an edge, at a corner), or off all of them.
fn attachment(rng: &mut ChaCha8Rng, parts: &[Polytope]) -> Point {
    loop {
        let part = &parts[rng.random_range(0..parts.len())];
        let solid = part.has_volume() && rng.random_bool(0.7);
        let at = if solid { surface_point(rng, part) } else { Point::from(vector(rng, 0.6)) };
        if parts.iter().all(|p| p.depth_of(&at) < 1e-9) {
            return at;
        }
    }
}

fn scene(rng: &mut ChaCha8Rng, clearance: f64, diameter: f64) -> Scene {
    let parts = platform(rng);
    let obstacles: Vec<Polytope> =
        (0..rng.random_range(0..4)).map(|_| body(rng).transformed(&rotation(rng), &vector(rng, 2.0))).collect();
    let outlet = |rng: &mut ChaCha8Rng| loop {
        let outlet = Point::from(vector(rng, 3.0));
        if obstacles.iter().all(|o| o.depth_of(&outlet) < -1e-3) {
            return outlet;
        }
    };
    let cables = (0..rng.random_range(1..7))
        .map(|_| CableSpec {
            name: None,
            outlet: outlet(rng).into(),
            attachment: attachment(rng, &parts).into(),
            tension: None,
            diameter: Some(diameter),
            length: None,
        })
        .collect();
    let turn = if rng.random_bool(0.3) { Rotation::identity() } else { rotation(rng) };
    Scene::new(SceneSpec {
        version: 1,
        name: None,
        gravity: None,
        clearance: Some(clearance),
        ignore: Vec::new(),
        workspace: WorkspaceSpec { min: [-10.0; 3], max: [10.0; 3] },
        robot: RobotSource::Inline(RobotSpec {
            version: None,
            name: None,
            mass: None,
            center_of_mass: None,
            platform: parts.iter().map(|p| body_spec(None, p)).collect(),
            cables,
        }),
        obstacles: obstacles.iter().enumerate().map(|(k, o)| body_spec(Some(&format!("o{k}")), o)).collect(),
        wrench: None,
        query: Some(QuerySpec { start: None, goal: None, orientation: Some([turn.w, turn.i, turn.j, turn.k]) }),
    })
    .unwrap()
}

/// What a scene is to the oracle: rotated arms and parts, hulls of obstacle minus part.
struct Oracle {
    outlets: Vec<Point>,
    arms: Vec<Vector>,
    parts: Vec<Polytope>,
    obstacles: Vec<Polytope>,
    differences: Vec<Polytope>,
}

impl Oracle {
    fn of(scene: &Scene) -> Self {
        let turn = scene.orientation();
        let parts: Vec<Polytope> =
            scene.robot().parts().iter().map(|p| p.transformed(turn, &Vector::zeros())).collect();
        let obstacles: Vec<Polytope> = scene.obstacles().iter().flat_map(|o| o.parts.clone()).collect();
        let difference = |o: &Polytope, p: &Polytope| {
            let points: Vec<Point> =
                o.vertices().iter().flat_map(|v| p.vertices().iter().map(move |w| v - w.coords)).collect();
            Polytope::hull_of(&points).unwrap()
        };
        Oracle {
            outlets: scene.robot().cables().iter().map(|c| c.outlet).collect(),
            arms: scene.robot().cables().iter().map(|c| turn * c.attachment.coords).collect(),
            differences: obstacles.iter().flat_map(|o| parts.iter().map(move |p| difference(o, p))).collect(),
            parts,
            obstacles,
        }
    }

    fn judge(&self, p: &Point, q: &Point) -> Verdict {
        let mut verdicts = vec![];
        verdicts.extend(self.differences.iter().map(|d| against(&[*p, *q], d)));
        for (outlet, arm) in self.outlets.iter().zip(&self.arms) {
            let triangle = [*outlet, p + arm, q + arm];
            verdicts.extend(self.obstacles.iter().map(|o| against(&triangle, o)));
            let seen = [Point::from(*arm), outlet - p.coords, outlet - q.coords];
            verdicts.extend(self.parts.iter().filter(|k| k.has_volume()).map(|k| against(&seen, k)));
            verdicts.extend(self.parts.iter().filter(|k| !k.has_volume()).map(|k| near_flat(&seen, k)));
        }
        for i in 0..self.arms.len() {
            verdicts.extend((i + 1..self.arms.len()).map(|j| self.cables(i, j, p, q)));
        }
        match verdicts {
            v if v.contains(&Verdict::Hit) => Verdict::Hit,
            v if v.contains(&Verdict::Either) => Verdict::Either,
            _ => Verdict::Free,
        }
    }

    /// Two cables by the sign of the volume they span, and their distance at its zero.
    fn cables(&self, i: usize, j: usize, p: &Point, q: &Point) -> Verdict {
        let ends = |t: f64| {
            let at = p + (q - p) * t;
            (at + self.arms[i], at + self.arms[j])
        };
        let (b, c) = (self.outlets[i], self.outlets[j]);
        let volume = |t: f64| {
            let (a, d) = ends(t);
            (a - b).dot(&(d - c).cross(&(c - b)))
        };
        let (start, end) = (volume(0.0), volume(1.0));
        if start.abs().min(end.abs()) < 1e-9 {
            return Verdict::Either;
        }
        if (start > 0.0) == (end > 0.0) {
            return Verdict::Free;
        }
        let (a, d) = ends(start / (start - end));
        match sampled_distance(&b, &a, &c, &d) {
            // Coplanar segments: they cross, or an end is nearest. Ends that nearly touch are left open.
            distance if distance < 1e-9 => Verdict::Hit,
            distance if distance > 1e-5 => Verdict::Free,
            _ => Verdict::Either,
        }
    }
}

fn against(polygon: &[Point], body: &Polytope) -> Verdict {
    if !clipped(polygon, body, -GAP_TOLERANCE).is_empty() {
        Verdict::Hit
    } else if clipped(polygon, body, GAP_TOLERANCE).is_empty() {
        Verdict::Free
    } else {
        Verdict::Either // touches; so does every cable its own part
    }
}

/// A cable against a part without volume: thickened by the tolerance it must be missed to be free.
fn near_flat(triangle: &[Point; 3], part: &Polytope) -> Verdict {
    let thick = part.vertices().iter().flat_map(|v| {
        (0..8).map(move |k| {
            let sign = |bit: usize| if k >> bit & 1 == 1 { 1e-5 } else { -1e-5 };
            v + Vector::new(sign(0), sign(1), sign(2))
        })
    });
    let thick = Polytope::hull_of(&thick.collect::<Vec<_>>()).unwrap();
    if clipped(triangle, &thick, 0.0).is_empty() { Verdict::Free } else { Verdict::Either }
}

/// Distance of two coplanar segments: 0 if they cross, else the least distance of an end from the other segment.
fn sampled_distance(a: &Point, b: &Point, c: &Point, d: &Point) -> f64 {
    let normal = (b - a).cross(&(d - c));
    let side = |p: &Point, q: &Point, r: &Point| (q - p).cross(&(r - p)).dot(&normal);
    if side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0 {
        return 0.0;
    }
    let to = |p: &Point, q: &Point, r: &Point| {
        let t = ((p - q).dot(&(r - q)) / (r - q).norm_squared()).clamp(0.0, 1.0);
        (p - (q + (r - q) * t)).norm()
    };
    to(a, c, d).min(to(b, c, d)).min(to(c, a, b)).min(to(d, a, b))
}

#[test]
fn states_and_motions_agree_with_exact_tests() {
    let mut rng = rng(7);
    let mut count = [0; 3];
    for case in 0..4_000 {
        let scene = scene(&mut rng, 0.0, 0.0);
        let oracle = Oracle::of(&scene);
        let exact = GjkEngine::new(&scene, Interference::Exact).unwrap();
        let swept = GjkEngine::new(&scene, Interference::Swept).unwrap();
        for _ in 0..30 {
            let p = Point::from(vector(&mut rng, 2.5));
            let q = match rng.random_range(0..5) {
                0 => p,
                1 => p + direction(&mut rng) * 10f64.powf(uniform(&mut rng, -9.0, 0.0)),
                _ => p + direction(&mut rng) * uniform(&mut rng, 0.01, 1.0),
            };
            let verdict = oracle.judge(&p, &q);
            count[verdict as usize] += 1;
            let valid = exact.motion_valid(&p, &q);
            let why = || format!("case {case}: {p} to {q}: oracle {verdict:?}, engine {:?}", exact.explain(&p, &q));
            assert!(verdict == Verdict::Either || valid == (verdict == Verdict::Free), "{}", why());
            assert_eq!(valid, exact.motion_valid(&q, &p), "not the same backwards: {}", why());
            if case % 8 == 0 {
                assert_eq!(valid, exact.explain(&p, &q).is_none(), "explanation contradicts: {}", why());
            }
            assert!(valid || !swept.motion_valid(&p, &q), "swept allows what exact refuses: {}", why());
        }
    }
    eprintln!("{} hits, {} free, {} left open", count[0], count[1], count[2]);
    assert!(count[0] > 20_000 && count[1] > 5_000);
}

#[test]
fn a_motion_is_as_near_as_its_nearest_state_and_kept_to_the_demand() {
    const SAMPLES: usize = 200;
    let mut rng = rng(8);
    let (mut near, mut far) = (0, 0);
    for case in 0..1_500 {
        let clearance = [0.0, 0.001, 0.05][case % 3];
        let diameter = [0.0, 0.01][case % 2];
        let scene = scene(&mut rng, clearance, diameter);
        let engine = GjkEngine::new(&scene, Interference::Exact).unwrap();
        if !engine.constraints().notes.is_empty() {
            continue; // some pairs are held to less
        }
        for _ in 0..4 {
            let p = Point::from(vector(&mut rng, 2.5));
            let q = p + direction(&mut rng) * 10f64.powf(uniform(&mut rng, -3.0, 0.0));
            let Some(found) = engine.clearance(&p, &q) else { continue };
            if found.value < -0.5 * diameter {
                continue; // overlap: how deep the swept bodies overlap is not how deep a state does
            }
            let sample = |k: usize| p + (q - p) * (k as f64 / SAMPLES as f64);
            let states = (0..=SAMPLES).map(|k| engine.clearance(&sample(k), &sample(k)).unwrap().value);
            let least = states.fold(f64::INFINITY, f64::min);
            let slack = 0.5 * (q - p).norm() / SAMPLES as f64;
            assert!(found.value <= least + 1e-7, "case {case}: a state is nearer ({least}) than the motion: {found:?}");
            assert!(found.value >= least - slack - 1e-7, "case {case}: no state is as near ({least}): {found:?}");
            let place = engine.clearance(&(p + (q - p) * found.at), &(p + (q - p) * found.at)).unwrap().value;
            assert!((place - found.value).abs() < 1e-6, "case {case}: not reached where it says: {place}, {found:?}");
            let kept = engine.motion_valid(&p, &q);
            if found.value < clearance - GAP_TOLERANCE {
                near += 1;
                assert!(!kept, "case {case}: allowed although nearer than {clearance}: {found:?}");
            } else if kept {
                far += 1;
            } else {
                let why = engine.explain(&p, &q).unwrap();
                let own = |v: &cdpr_core::collision::Violation| v.margin.is_some_and(|m| m < GAP_TOLERANCE);
                assert!(
                    found.value < clearance + GAP_TOLERANCE || own(&why),
                    "case {case}: refused for {why:?}, {found:?}"
                );
            }
        }
    }
    eprintln!("{near} nearer than demanded, {far} allowed");
    assert!(near > 100 && far > 300);
}
