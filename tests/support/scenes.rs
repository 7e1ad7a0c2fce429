//! Random scenes, including hostile ones, and slow exact tests of whole scenes that share no code with the engines:
//! clipping for cables against bodies, hulls of Minkowski differences for the platform, dense sampling for pairs of
//! cables.
//!
//! The oracle answers "hit" or "free" only if this is proved by more than the tolerance; otherwise either is right.

use cdpr_core::Error;
use cdpr_core::geometry::{Point, Polytope, Rotation, Vector};
use cdpr_core::model::{
    BodySpec, CableSpec, ClearancesSpec, PairClearanceSpec, QuerySpec, RobotSource, RobotSpec, Scene, SceneSpec,
    WorkspaceSpec,
};
use cdpr_core::testing::{paper_robot, paper_scene};
use cdpr_core::tolerances::GAP_TOLERANCE;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::{body, clipped, rotation, surface_point, uniform, vector};

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Verdict {
    Hit,
    Free,
    Either,
}

pub fn body_spec(name: Option<&str>, body: &Polytope) -> BodySpec {
    let vertices = body.vertices().iter().map(|v| [v.x, v.y, v.z]).collect();
    BodySpec { name: name.map(str::to_string), vertices: Some(vertices), ..BodySpec::default() }
}

/// A scene with a robot that has one cable, "cable", from an outlet to an attachment; pairs are ignored by name.
pub fn scene_with_a_cable(
    platform: Vec<BodySpec>,
    ends: [Point; 2],
    obstacles: Vec<BodySpec>,
    ignore: &[[&str; 2]],
) -> Result<Scene, Error> {
    let [outlet, attachment] = ends.map(|p| [p.x, p.y, p.z]);
    let name = Some("cable".to_string());
    let cable = CableSpec { name, outlet, attachment, ..CableSpec::default() };
    let mut spec = paper_scene("one cable", obstacles);
    spec.robot = RobotSource::Inline(RobotSpec { mass: None, platform, cables: vec![cable], ..paper_robot() });
    spec.workspace = WorkspaceSpec { min: [-60.0; 3], max: [60.0; 3] };
    spec.ignore = ignore.iter().map(|pair| pair.map(str::to_string)).collect();
    spec.query = None;
    Scene::new(spec)
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

/// Options for random scenes.
#[derive(Debug, Clone, Copy, Default)]
pub struct Kind {
    pub clearance: f64,
    pub diameter: f64,
    /// Outlets on obstacles, obstacles of abutting parts, cable length limits, small workspaces.
    pub special: bool,
    /// Clearances by kind and by pair, and pairs that may touch.
    pub mixed: bool,
}

pub fn scene(rng: &mut ChaCha8Rng, kind: Kind) -> Scene {
    loop {
        if let Ok(scene) = Scene::new(spec(rng, kind)) {
            return scene;
        }
    }
}

/// Random clearances for some kinds and pairs, and pairs that may touch: each pair occurs at most once.
fn mixed(rng: &mut ChaCha8Rng, spec: SceneSpec) -> SceneSpec {
    let demand = |rng: &mut ChaCha8Rng| [0.0, 0.001, 0.02, 0.1][rng.random_range(0..4)];
    let kind = |rng: &mut ChaCha8Rng| rng.random_bool(0.6).then(|| demand(rng));
    let RobotSource::Inline(robot) = &spec.robot else { unreachable!("random scenes have their robot in place") };
    let cables = (0..robot.cables.len()).map(|k| format!("cable {k}")).chain(["platform".to_string()]);
    let robot: Vec<String> = cables.collect();
    let mut obstacles: Vec<String> = spec.obstacles.iter().map(|o| o.name.clone().unwrap()).collect();
    obstacles.dedup();
    let mut clearances = ClearancesSpec {
        platform_obstacle: kind(rng),
        cable_obstacle: kind(rng),
        cable_platform: kind(rng),
        cable_cable: kind(rng),
        pairs: Vec::new(),
    };
    let mut touch = Vec::new();
    for (k, a) in robot.iter().enumerate() {
        for b in robot[k + 1..].iter().chain(&obstacles) {
            let between = if rng.random_bool(0.5) { [a.clone(), b.clone()] } else { [b.clone(), a.clone()] };
            match rng.random_range(0..6) {
                0 => touch.push(between),
                1 | 2 => clearances.pairs.push(PairClearanceSpec { between, clearance: demand(rng) }),
                _ => {}
            }
        }
    }
    SceneSpec { touch, clearances: Some(clearances), ..spec }
}

fn spec(rng: &mut ChaCha8Rng, kind: Kind) -> SceneSpec {
    let spec = uniform_spec(rng, kind);
    if kind.mixed { mixed(rng, spec) } else { spec }
}

fn uniform_spec(rng: &mut ChaCha8Rng, Kind { clearance, diameter, special, .. }: Kind) -> SceneSpec {
    let parts = platform(rng);
    let mut obstacles: Vec<(String, Polytope)> = (0..rng.random_range(0..4))
        .map(|k| (format!("o{k}"), body(rng).transformed(&rotation(rng), &vector(rng, 2.0))))
        .collect();
    if special && rng.random_bool(0.3) {
        let (turn, at) = (rotation(rng), vector(rng, 1.5));
        let sides: [f64; 3] = std::array::from_fn(|_| uniform(rng, 0.1, 0.6));
        let half = |shift: f64| {
            let moved = Polytope::cuboid(sides).unwrap().transformed(&Rotation::identity(), &(Vector::x() * shift));
            ("pair".to_string(), moved.transformed(&turn, &at))
        };
        obstacles.extend([half(0.5 * sides[0]), half(-0.5 * sides[0])]);
    }
    let outlet = |rng: &mut ChaCha8Rng| loop {
        let on = special && !obstacles.is_empty() && rng.random_bool(0.2);
        let outlet = if on {
            let k = rng.random_range(0..obstacles.len());
            surface_point(rng, &obstacles[k].1)
        } else {
            Point::from(vector(rng, 3.0))
        };
        if obstacles.iter().all(|(_, o)| o.depth_of(&outlet) < if on { 1e-9 } else { -1e-3 }) {
            return outlet;
        }
    };
    let cables = (0..rng.random_range(1..7))
        .map(|_| CableSpec {
            outlet: outlet(rng).into(),
            attachment: attachment(rng, &parts).into(),
            tension: None,
            diameter: Some(diameter),
            length: (special && rng.random_bool(0.2)).then(|| [uniform(rng, 0.1, 1.0), uniform(rng, 3.0, 5.0)]),
            ..CableSpec::default()
        })
        .collect();
    let turn = if rng.random_bool(0.3) { Rotation::identity() } else { rotation(rng) };
    let half = if special && rng.random_bool(0.5) { uniform(rng, 1.5, 4.0) } else { 10.0 };
    SceneSpec {
        version: 1,
        name: None,
        gravity: None,
        clearance: Some(clearance),
        ignore: Vec::new(),
        touch: Vec::new(),
        clearances: None,
        orientations: Vec::new(),
        stations: Vec::new(),
        payloads: Vec::new(),
        task: Vec::new(),
        workspace: WorkspaceSpec { min: [-half; 3], max: [half; 3] },
        robot: RobotSource::Inline(RobotSpec {
            version: None,
            name: None,
            mass: None,
            center_of_mass: None,
            inertia: None,
            platform: parts.iter().map(|p| body_spec(None, p)).collect(),
            cables,
            cable: None,
            tension_distribution: None,
        }),
        obstacles: obstacles.iter().map(|(name, o)| body_spec(Some(name), o)).collect(),
        wrench: None,
        motion: None,
        turning: None,
        query: Some(QuerySpec { orientation: Some([turn.w, turn.i, turn.j, turn.k].into()), ..QuerySpec::default() }),
    }
}

/// The oracle's view of a scene: rotated arms and parts, hulls of obstacle minus part.
pub struct Oracle {
    outlets: Vec<Point>,
    arms: Vec<Vector>,
    parts: Vec<Polytope>,
    obstacles: Vec<Polytope>,
    differences: Vec<Polytope>,
}

impl Oracle {
    pub fn of(scene: &Scene) -> Self {
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

    pub fn judge(&self, p: &Point, q: &Point) -> Verdict {
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

    /// Two cables by the sign of the volume that they span, and their distance at its zero.
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
        // Coplanar segments: they cross, or an end is closest. Ends that nearly touch are left undecided.
        let end_distance = nearest_end(&b, &a, &c, &d);
        match cross(&b, &a, &c, &d) {
            true if end_distance > GAP_TOLERANCE => Verdict::Hit,
            false if end_distance > 1e-5 => Verdict::Free,
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
        Verdict::Either // touches, as every cable touches its own part
    }
}

/// A cable against a part without volume: it is free if it misses the part thickened by the tolerance.
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

/// Whether two coplanar segments cross.
fn cross(a: &Point, b: &Point, c: &Point, d: &Point) -> bool {
    let normal = (b - a).cross(&(d - c));
    let side = |p: &Point, q: &Point, r: &Point| (q - p).cross(&(r - p)).dot(&normal);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

/// Smallest distance of an end of two segments from the other segment.
fn nearest_end(a: &Point, b: &Point, c: &Point, d: &Point) -> f64 {
    let to = |p: &Point, q: &Point, r: &Point| {
        let t = ((p - q).dot(&(r - q)) / (r - q).norm_squared()).clamp(0.0, 1.0);
        (p - (q + (r - q) * t)).norm()
    };
    to(a, c, d).min(to(b, c, d)).min(to(c, a, b)).min(to(d, a, b))
}
