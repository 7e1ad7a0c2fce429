//! Cables that sag and leave the frame near their outlets: every shape that they can take, found by other means, keeps clear on a
//! motion that is called free.

use cdpr_core::collision::{CspaceEngine, GjkEngine, Interference, Validity};
use cdpr_core::geometry::gjk::shape_distance;
use cdpr_core::geometry::{Point, Polytope, Triangle, Vector, segment_segment};
use cdpr_core::model::{CableDefaultsSpec, PulleySpec, RobotSource, Sag, Scene, SceneSpec};
use cdpr_core::planning::{StateSpace, TranslationSpace};
use cdpr_core::turning::TurningEngine;
use cdpr_core::{Checker, Pose, Rotation};
use cdpr_tests::scenes::{Kind, scene};
use cdpr_tests::{built_scene, direction, effort, rng, rotation, uniform};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};
use std::sync::Arc;

/// A cable of a material between two points.
struct Hung {
    /// Weight per unstretched length, N/m.
    weight: f64,
    /// Tension at the lower end of the integration, the platform, N.
    tension: f64,
    /// 1 / (E A), 1/N.
    compliance: f64,
}

impl Hung {
    /// Horizontal distance and height of the point at a length from the platform where the cable starts at a slope, rad.
    fn at(&self, slope: f64, length: f64) -> [f64; 2] {
        let (w, h, v) = (self.weight, self.tension * slope.cos(), self.tension * slope.sin());
        let top = v + w * length;
        let across = h / w * ((top / h).asinh() - (v / h).asinh()) + h * length * self.compliance;
        let up = ((h * h + top * top).sqrt() - (h * h + v * v).sqrt()) / w
            + (v * length + 0.5 * w * length * length) * self.compliance;
        [across, up]
    }

    /// The length at which the cable is at a horizontal distance.
    fn length(&self, slope: f64, across: f64) -> f64 {
        let (mut low, mut high) = (0.0, 2.0 * across / slope.cos() + 10.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if self.at(slope, middle)[0] < across { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }

    /// Points of the cable from the platform at the origin to an exit at this horizontal distance and height.
    fn points(&self, across: f64, up: f64, count: usize) -> Vec<[f64; 2]> {
        // The cable starts lower than its chord by about half of q cos(chord); much lower, it would hang down and come up again.
        let chord = up.atan2(across);
        let slackness = self.weight * across.hypot(up) / self.tension;
        let (mut low, mut high) = (chord - slackness * chord.cos(), chord);
        for _ in 0..60 {
            let slope = 0.5 * (low + high);
            let reached = self.at(slope, self.length(slope, across))[1] > up;
            if reached { high = slope } else { low = slope }
        }
        let slope = 0.5 * (low + high);
        let length = self.length(slope, across);
        (0..=count).map(|k| self.at(slope, length * k as f64 / count as f64)).collect()
    }
}

/// Lets a random taut cable hang, and compares its sag with the bound at many points.
#[test]
fn catenaries_lie_within_the_bound_on_the_sag_which_is_at_most_six_percent_larger() {
    let mut rng = rng(43);
    let (mut least, mut most) = (f64::INFINITY, 0.0f64);
    for _ in 0..2_000 * effort() {
        let length = 10f64.powf(uniform(&mut rng, 0.0, 2.0));
        let slope = uniform(&mut rng, -85.0, 85.0).to_radians();
        let (across, up) = (length * slope.cos(), length * slope.sin());
        let slackness = uniform(&mut rng, 0.001, 0.2);
        // In the middle; at the platform it is lower by half the weight of the height.
        let middle = 10f64.powf(uniform(&mut rng, 1.0, 4.0));
        let weight = slackness * middle / length;
        let tension = middle - 0.5 * weight * up;
        let compliance = [0.0, 1e-2 / middle][rng.random_range(0..2)];
        let sag = Sag { up: Vector::z(), weight, tension: middle, longest: length };
        let chord = Vector::new(across, 0.0, up);
        let mut deepest = [0.0f64; 2];
        for [x, z] in (Hung { weight, tension, compliance }).points(across, up, 20) {
            let below = x * up / across - z;
            let from_platform = x / across * chord.norm();
            let bound = sag.between(length, [length - from_platform; 2]);
            assert!(below <= bound + 1e-9 * length, "{slope} {slackness} {compliance}: {below} {bound}");
            deepest = [deepest[0].max(below), deepest[1].max(bound)];
        }
        let ratio = deepest[1] / deepest[0];
        (least, most) = (least.min(ratio), most.max(ratio));
    }
    println!("the bound is {least:.4} to {most:.4} times the sag");
    assert!(least >= 1.0 && most <= 1.06, "{least} {most}");
}

/// A random scene whose cables hang and whose outlets are not known exactly.
fn hanging(rng: &mut ChaCha8Rng, kind: Kind) -> Scene {
    loop {
        let mut spec: SceneSpec = scene(rng, kind).spec().clone();
        let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("the robot is in the scene") };
        spec.workspace.min = [-3.0; 3];
        spec.workspace.max = [3.0; 3];
        robot.cable = Some(CableDefaultsSpec {
            linear_density: [None, Some(0.02), Some(0.03)][rng.random_range(0..3)],
            sag_tension: Some([20.0, 100.0][rng.random_range(0..2)]),
            outlet_error: [None, Some(0.003), Some(0.05)][rng.random_range(0..3)],
            pulley: rng
                .random_bool(0.5)
                .then(|| PulleySpec { radius: [0.03, 0.15][rng.random_range(0..2)], axis: direction(rng).into() }),
            ..CableDefaultsSpec::default()
        });
        if rng.random_bool(0.2) {
            spec.gravity = Some([uniform(rng, -9.0, 9.0), uniform(rng, -9.0, 9.0), uniform(rng, -9.0, 9.0)]);
        }
        if let Ok(scene) = Scene::new(spec) {
            return scene;
        }
    }
}

/// Points of one shape that a cable can take: exit within the error, tension at the platform at or above the least.
fn shape(rng: &mut ChaCha8Rng, scene: &Scene, cable: usize, end: &Point) -> Vec<Point> {
    let cable = &scene.robot().cables()[cable];
    let error = if rng.random_bool(0.7) { cable.outlet_error } else { cable.outlet_error * rng.random::<f64>() };
    let exit = cable.departure(end).expect("a valid pose").exit + direction(rng) * error;
    let weight = cable.linear_density * scene.gravity().norm();
    let count = 16;
    if weight == 0.0 {
        return (0..=count).map(|k| end + (exit - end) * (k as f64 / count as f64)).collect();
    }
    let up = -scene.gravity().normalize();
    let line = exit - end;
    let rise = up.dot(&line);
    let aside = line - up * rise;
    if aside.norm() < 0.1 * line.norm() {
        return (0..=count).map(|k| end + line * (k as f64 / count as f64)).collect();
    }
    let tension = cable.sag_tension.unwrap() * if rng.random_bool(0.7) { 1.0 } else { uniform(rng, 1.0, 4.0) };
    let hung = Hung { weight, tension, compliance: [0.0, 1e-5][rng.random_range(0..2)] };
    let along = aside.normalize();
    hung.points(aside.norm(), rise, count).into_iter().map(|[x, z]| end + along * x + up * z).collect()
}

/// How deep one random shape of all cables is in something at a pose, m; negative if nothing is wrong.
fn deepest(rng: &mut ChaCha8Rng, scene: &Scene, position: &Point, turn: &Rotation) -> f64 {
    let robot = scene.robot();
    let ends: Vec<Point> = robot.cables().iter().map(|cable| position + turn * cable.attachment.coords).collect();
    let shapes: Vec<Vec<Point>> = (0..ends.len()).map(|k| shape(rng, scene, k, &ends[k])).collect();
    let mut worst = f64::NEG_INFINITY;
    for (k, points) in shapes.iter().enumerate() {
        let outlet = &robot.cables()[k].outlet;
        let radius = 0.5 * robot.cables()[k].diameter;
        for obstacle in scene.obstacles() {
            let carries = obstacle.parts.iter().any(|part| !part.active_normals(outlet).is_empty());
            for part in obstacle.parts.iter().filter(|_| !carries) {
                worst = points.iter().map(|p| part.depth_of(p)).fold(worst, f64::max);
            }
        }
        for part in robot.parts() {
            let seen = |p: &Point| Point::from(turn.inverse_transform_vector(&(p - position)));
            worst = points.iter().map(|p| part.depth_of(&seen(p))).fold(worst, f64::max);
        }
        for (j, others) in shapes.iter().enumerate().skip(k + 1) {
            let apart = |a: &Point, b: &Point| (a - b).norm() > 1e-6;
            let cables = [&robot.cables()[k], &robot.cables()[j]];
            if !apart(&cables[0].outlet, &cables[1].outlet) || !apart(&cables[0].attachment, &cables[1].attachment) {
                continue;
            }
            let radii = radius + 0.5 * cables[1].diameter;
            // Thick cables that overlap wherever the platform is are exempt, and named in a note: some points of their axes, at the same
            // share of both lengths, are never farther apart than the least of the means of the vectors between their ends.
            let zero = Point::origin();
            let outlets = cables[1].outlet - cables[0].outlet;
            let attachments = scene.orientation() * (cables[1].attachment - cables[0].attachment);
            let attainable = segment_segment::closest(&zero, &zero, &outlets.into(), &attachments.into()).distance;
            let radii = if attainable < radii { 0.0 } else { radii };
            for a in points.windows(2) {
                for b in others.windows(2) {
                    let near = segment_segment::closest(&a[0], &a[1], &b[0], &b[1]).distance;
                    worst = worst.max(radii - near - 1e-4); // the chords of a sampled catenary
                }
            }
        }
    }
    worst
}

/// Judges random motions of random scenes, and samples the true shapes on those that are called free.
fn judge(seed: u64, scenes: u64, kind: Kind) -> [u64; 4] {
    let mut counts = [0; 4];
    for number in 0..scenes {
        let mut rng = rng(1000 * seed + number);
        let scene = hanging(&mut rng, kind);
        let gjk = GjkEngine::new(&scene, Interference::Exact).unwrap();
        let cspace = CspaceEngine::new(&scene, Interference::Exact).unwrap();
        let turning = TurningEngine::new(&scene, Arc::new(cspace.clone())).unwrap();
        let space = TranslationSpace::of(gjk.conditions());
        for _ in 0..40 {
            let Some(p) = space.sample(&mut rng) else { break };
            let q = p + direction(&mut rng) * uniform(&mut rng, 0.0, 0.5);
            let valid = cspace.motion_valid(&p, &q);
            let shallow = |checker: &dyn Checker| {
                checker.violations(&p, &q).iter().all(|v| v.margin.is_some_and(|m| m.abs() <= 1e-6))
            };
            assert!(
                valid == gjk.motion_valid(&p, &q) || (shallow(&cspace) && shallow(&gjk)),
                "{p} {q}: {valid} {:?} {:?}\n{}",
                cspace.violations(&p, &q),
                gjk.violations(&p, &q),
                serde_json::to_string(scene.spec()).unwrap()
            );
            let turn = rotation(&mut rng);
            let angle = uniform(&mut rng, 0.0, 0.3);
            let axis = turn.axis().unwrap_or(Vector::z_axis());
            let ends = [(p, 0.0), (q, angle)]
                .map(|(at, angle)| Pose::new(at, Rotation::from_axis_angle(&axis, angle) * scene.orientation()));
            let turning_valid = turning.motion_valid(&ends[0], &ends[1]);
            for (which, free) in [(0, valid), (2, turning_valid)] {
                counts[which] += u64::from(free);
                counts[which + 1] += u64::from(!free);
                for _ in 0..if free { 4 } else { 0 } {
                    let t = [0.0, 1.0, rng.random::<f64>()][rng.random_range(0..3)];
                    let turn = if which == 0 {
                        *scene.orientation()
                    } else {
                        Rotation::from_axis_angle(&axis, angle * t) * scene.orientation()
                    };
                    let found = deepest(&mut rng, &scene, &(p + (q - p) * t), &turn);
                    assert!(
                        found <= 1e-7,
                        "{found} m deep at {t} of {p} to {q}, turning {which} by {angle}\n{}",
                        serde_json::to_string(scene.spec()).unwrap()
                    );
                }
            }
        }
    }
    counts
}

#[test]
fn no_shape_of_any_cable_collides_on_motions_that_are_called_free() {
    let kinds = [
        Kind::default(),
        Kind { special: true, ..Kind::default() },
        Kind { clearance: 0.05, diameter: 0.01, ..Kind::default() },
        Kind { special: true, mixed: true, diameter: 0.004, clearance: 0.02 },
    ];
    let counts: Vec<[u64; 4]> =
        kinds.iter().enumerate().map(|(k, kind)| judge(430 + k as u64, 12 * effort(), *kind)).collect();
    println!("free and refused, translating and turning: {counts:?}");
    assert!(counts.iter().all(|c| c.iter().all(|count| *count > 50)), "{counts:?}");
}

/// Two cables of different weight to a small platform, and nothing else, as a scene to which things can be added.
fn two_cables(rng: &mut ChaCha8Rng) -> Value {
    loop {
        let place =
            |rng: &mut ChaCha8Rng, half: f64| -> [f64; 3] { std::array::from_fn(|_| uniform(rng, -half, half)) };
        let cable = |rng: &mut ChaCha8Rng| {
            let density = [0.0, 0.02, 0.3][rng.random_range(0..3)];
            let (diameter, error) =
                ([0.0, 0.01][rng.random_range(0..2)], [0.0, 0.0, 0.003, 0.05][rng.random_range(0..4)]);
            let pulley = rng.random_bool(0.3).then(|| json!({"radius": 0.1, "axis": place(rng, 1.0)}));
            json!({
                "outlet": place(rng, 3.0), "attachment": place(rng, 0.5), "diameter": diameter, "outlet_error": error,
                "linear_density": density, "sag_tension": 1.0 + 9.81 * density * uniform(rng, 30.0, 60.0), "pulley": pulley,
            })
        };
        let gravity = if rng.random_bool(0.5) { [0.0, 0.0, -9.81] } else { (direction(rng) * 9.81).into() };
        let spec = json!({
            "version": 1, "gravity": gravity, "workspace": {"min": [-2, -2, -2], "max": [2, 2, 2]},
            "robot": {"platform": [{"box": [0.02, 0.02, 0.02]}], "cables": [cable(rng), cable(rng)]},
        });
        if built(&spec).is_some() {
            return spec;
        }
    }
}

fn built(spec: &Value) -> Option<Scene> {
    Scene::new(serde_json::from_value(spec.clone()).unwrap()).ok()
}

/// Whether motions between two positions are refused in both directions, also while the platform turns away from the first.
fn refused(scene: &Scene, at: &Point, other: &Point, by_all: bool) -> bool {
    let gjk = GjkEngine::new(scene, Interference::Exact).unwrap();
    let found = !gjk.motion_valid(at, other) && !gjk.motion_valid(other, at);
    if !by_all {
        return found;
    }
    let cspace = CspaceEngine::new(scene, Interference::Exact).unwrap();
    let turning = TurningEngine::new(scene, Arc::new(cspace.clone())).unwrap();
    let [from, to] = [(at, 0.0), (other, 0.1)].map(|(p, angle)| Pose::new(*p, Rotation::new(Vector::z() * angle)));
    found && !cspace.motion_valid(at, other) && !turning.motion_valid(&from, &to) && !turning.motion_valid(&to, &from)
}

/// Two positions, not far from each other, to which all cables lead, and one shape of each at the first.
fn drawn(rng: &mut ChaCha8Rng, scene: &Scene) -> Option<([Point; 2], Vec<Vec<Point>>)> {
    let at = Point::from(Vector::from_fn(|_, _| uniform(rng, -1.9, 1.9)));
    let cables = scene.robot().cables();
    let ends = [at, (at + direction(rng)).map(|x| x.clamp(-1.9, 1.9))];
    let leads = |cable: &cdpr_core::model::Cable| {
        ends.iter().all(|p| cable.departure(&(p + cable.attachment.coords)).is_some())
    };
    if !cables.iter().all(leads) {
        return None;
    }
    let shapes = (0..2).map(|k| shape(rng, scene, k, &(ends[0] + cables[k].attachment.coords))).collect();
    Some((ends, shapes))
}

/// A body is put so that one of its corners is a micrometre closer than the clearance to a random point of a random shape, beside,
/// below or above it, as an obstacle or a part of the platform.
#[test]
fn lowered_exits_reach_as_far_as_the_exits_and_each_of_them_lowered() {
    let mut rng = rng(31);
    let mut fewer = 0;
    for _ in 0..30 * effort() {
        let scene = hanging(&mut rng, Kind::default());
        for envelope in scene.envelopes().iter().flatten() {
            let Some(sag) = envelope.sag else { continue };
            let fall = uniform(&mut rng, 0.0, 0.5);
            let kept = envelope.exits_lowered(fall);
            let both = envelope.exits.iter().flat_map(|exit| [*exit, exit - sag.up * fall]).collect::<Vec<_>>();
            assert!(kept.iter().all(|exit| both.iter().any(|known| (exit - known).norm() < 1e-12)));
            fewer += usize::from(kept.len() < both.len());
            for _ in 0..200 {
                let along = direction(&mut rng);
                let reach = |points: &[Point]| points.iter().map(|p| along.dot(&p.coords)).fold(f64::MIN, f64::max);
                assert!((reach(&kept) - reach(&both)).abs() < 1e-9, "{} {}", kept.len(), both.len());
            }
        }
    }
    assert!(fewer > 20, "{fewer}");
}

#[test]
fn a_body_that_is_a_little_too_near_to_one_shape_is_refused() {
    let mut rng = rng(44);
    let mut tried = [0; 2];
    while tried.iter().sum::<u64>() < 300 * effort() {
        let mut spec = two_cables(&mut rng);
        let scene = built(&spec).unwrap();
        let Some(([at, other], shapes)) = drawn(&mut rng, &scene) else { continue };
        let points = &shapes[0];
        let k = [rng.random_range(1..points.len()), points.len() - 1][rng.random_range(0..2)];
        let along = (points[k] - points[k - 1]).normalize();
        let down = scene.gravity().normalize() * uniform(&mut rng, 0.0, 3.0);
        let aside = down + direction(&mut rng);
        let Some(aside) = (aside - along * along.dot(&aside)).try_normalize(0.1) else { continue };
        let clearance = [0.0, 0.01, 0.2][rng.random_range(0..3)];
        let gap = clearance + 0.5 * scene.robot().cables()[0].diameter;
        let turn = rotation(&mut rng);
        let size: [f64; 3] = std::array::from_fn(|_| [0.02, 0.3, 3.0][rng.random_range(0..3)]);
        let corner = |k: usize| turn * Vector::from_fn(|i, _| if k >> i & 1 == 1 { size[i] } else { -size[i] });
        let nearest = (0..8).map(corner).min_by(|a, b| aside.dot(a).total_cmp(&aside.dot(b))).unwrap();
        let shift = points[k] + aside * (gap - 1e-6) - nearest;
        let corners: Vec<Point> = (0..8).map(|k| shift + corner(k)).collect();
        let carries = |p: &Point| !Polytope::hull_of(&corners).unwrap().active_normals(p).is_empty();
        let of_platform = rng.random_bool(0.3) && size.iter().all(|side| *side < 1.0);
        spec["clearance"] = clearance.into();
        spec["ignore"] = json!([["platform", "body"]]);
        if of_platform {
            let seen: Vec<[f64; 3]> = corners.iter().map(|corner| (corner - at).into()).collect();
            spec["robot"]["platform"].as_array_mut().unwrap().push(json!({"vertices": seen}));
            spec["ignore"] = json!([]);
        } else {
            let corners: Vec<[f64; 3]> = corners.iter().map(|corner| (*corner).into()).collect();
            spec["obstacles"] = json!([{"name": "body", "vertices": corners}]);
        }
        let cable = &scene.robot().cables()[0];
        if carries(&cable.outlet) || (of_platform && carries(&(at + cable.attachment.coords))) {
            continue;
        }
        let Some(scene) = built(&spec) else { continue };
        tried[usize::from(of_platform)] += 1;
        let to = [at, other, other][rng.random_range(0..3)];
        assert!(refused(&scene, &at, &to, rng.random_bool(0.1)), "{k} of the shape at {at}, to {to}\n{spec}");
        spec["clearance"] = 0.0.into();
        let scene = built(&spec).unwrap();
        let found = GjkEngine::new(&scene, Interference::Exact).unwrap().clearance(&at, &to).unwrap().value;
        assert!(found <= clearance + 1e-9, "{found} reported at {at}, to {to}; {k} of the shape is nearer\n{spec}");
    }
    println!("obstacles and parts of the platform: {tried:?}");
    assert!(tried.iter().all(|count| *count > 20), "{tried:?}");
}

/// The clearance is what a random shape of each cable lacks a little of at one end of a motion.
#[test]
fn cables_of_which_two_shapes_are_a_little_too_near_are_refused() {
    /// More than the chords of sampled catenaries differ from them, m.
    const LITTLE: f64 = 2e-3;
    let mut rng = rng(45);
    let mut tried = 0;
    while tried < 300 * effort() {
        let mut spec = two_cables(&mut rng);
        let scene = built(&spec).unwrap();
        let Some(([at, other], shapes)) = drawn(&mut rng, &scene) else { continue };
        let near = |a: &[Point]| {
            let to = shapes[1].windows(2).map(|b| segment_segment::closest(&a[0], &a[1], &b[0], &b[1]).distance);
            to.fold(f64::INFINITY, f64::min)
        };
        let axes = shapes[0].windows(2).map(near).fold(f64::INFINITY, f64::min);
        let [i, j] = [0, 1].map(|k| &scene.robot().cables()[k]);
        let clearance = axes + LITTLE - 0.5 * (i.diameter + j.diameter);
        // What no position allows is not asked for.
        let [w, q] = [j.outlet - i.outlet, j.attachment - i.attachment].map(Point::from);
        let allowed = segment_segment::closest(&Point::origin(), &Point::origin(), &w, &q).distance;
        if clearance < 0.0 || axes + LITTLE > allowed {
            continue;
        }
        spec["clearances"] = json!({"cable_cable": clearance});
        let scene = built(&spec).unwrap();
        tried += 1;
        let to = [at, other, other][rng.random_range(0..3)];
        assert!(refused(&scene, &at, &to, rng.random_bool(0.1)), "at {at}, to {to}\n{spec}");
    }
}

/// A heavy cable is level above a light one, and hangs nearer to it the longer it is.
#[test]
fn two_cables_are_refused_where_only_the_end_of_a_motion_makes_one_hang_too_low() {
    for side in [-1.0, 1.0] {
        let cable = |height: f64, density: f64| {
            let ends = [0.0, 0.0, height];
            json!({"outlet": ends, "attachment": ends, "linear_density": density, "sag_tension": 100.0})
        };
        let mut spec = json!({
            "version": 1, "workspace": {"min": [-5, -1, -1], "max": [5, 1, 1]},
            "robot": {"platform": [{"vertices": [[0, 0, 0.1]]}], "cables": [cable(0.2, 0.3), cable(0.0, 0.0)]},
        });
        let hung = Hung { weight: 0.3 * 9.81, tension: 100.0, compliance: 0.0 };
        let lowest = hung.points(4.0, 0.0, 16)[8][1];
        let [near, far] = [2.0, 4.0].map(|x| Point::new(side * x, 0.0, 0.0));
        for (more, valid) in [(-5e-3, true), (1e-4, false)] {
            spec["clearances"] = json!({"cable_cable": 0.2 + lowest + more});
            let scene = built(&spec).unwrap();
            let gjk = GjkEngine::new(&scene, Interference::Exact).unwrap();
            assert!(gjk.motion_valid(&near, &near), "{side}");
            assert_eq!(gjk.motion_valid(&near, &far), valid, "{side} {more}");
            assert!(valid || refused(&scene, &far, &near, true), "{side}");
        }
    }
}

/// The scenes of built robots, with ropes: mass per length, kg/m, the tension kept, N, and the radius of the pulleys, m.
const ROPED: [(&str, f64, f64, f64); 4] = [
    ("cogiro", 0.06, 100.0, 0.05),
    ("caroca", 0.02, 50.0, 0.03),
    ("ipanema2", 0.01, 50.0, 0.03),
    ("forest", 0.006, 20.0, 0.03),
];

fn roped((name, density, tension, radius): (&str, f64, f64, f64)) -> Scene {
    let mut spec: SceneSpec = built_scene(name).spec().clone();
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("the robot is in the scene") };
    robot.cable = Some(CableDefaultsSpec {
        linear_density: Some(density),
        sag_tension: Some(tension),
        outlet_error: Some(0.003),
        pulley: Some(PulleySpec { radius, axis: [0.0, 0.0, 1.0] }),
        ..CableDefaultsSpec::default()
    });
    spec.wrench = None;
    Scene::new(spec).unwrap()
}

/// The least gap between many shapes of a cable and the obstacle or platform that it meets, m.
fn true_gap(rng: &mut ChaCha8Rng, scene: &Scene, culprits: &[String], position: &Point) -> f64 {
    let robot = scene.robot();
    let turn = scene.orientation();
    let cable = robot.cables().iter().position(|cable| culprits.contains(&cable.name)).expect("a cable");
    let radius = 0.5 * robot.cables()[cable].diameter;
    let end = position + turn * robot.cables()[cable].attachment.coords;
    let obstacle = scene.obstacles().iter().find(|obstacle| culprits.contains(&obstacle.name));
    let placed = |part: &Polytope| part.transformed(turn, &position.coords);
    let bodies: Vec<Polytope> =
        obstacle.map_or_else(|| robot.parts().iter().map(placed).collect(), |obstacle| obstacle.parts.to_vec());
    let gaps = (0..60).flat_map(|_| {
        let points = shape(rng, scene, cable, &end);
        let near = |ends: &[Point]| {
            let piece = Triangle::new(ends[0], ends[1], ends[1]);
            bodies.iter().map(|body| shape_distance(&piece, body).signed()).fold(f64::INFINITY, f64::min)
        };
        points.windows(2).map(near).collect::<Vec<_>>()
    });
    gaps.fold(f64::INFINITY, f64::min) - radius
}

/// Random positions at which a cable is refused, though none of many of its shapes comes too near: how many, and how much larger the
/// gap is than the one that counts.
#[test]
#[ignore = "takes long; `make long-test` runs it"]
fn what_is_refused_though_no_shape_comes_near_loses_little() {
    for robot in ROPED {
        let (name, scene) = (robot.0, roped(robot));
        let gjk = GjkEngine::new(&scene, Interference::Exact).unwrap();
        let space = TranslationSpace::of(gjk.conditions());
        let mut rng = rng(99);
        let (mut lost, mut refused) = (Vec::new(), 0);
        for _ in 0..400 * effort() {
            let p = space.sample(&mut rng).unwrap();
            let violations = gjk.violations(&p, &p);
            if !violations.iter().all(|v| v.shapes.is_some() && v.kind != cdpr_core::Kind::CableCable) {
                continue;
            }
            for violation in violations {
                let gap = true_gap(&mut rng, &scene, &violation.culprits, &p);
                refused += 1;
                if gap > violation.required.unwrap() {
                    lost.push(1e3 * (gap - violation.gap.unwrap()));
                }
            }
        }
        lost.sort_by(f64::total_cmp);
        let at = |share: f64| lost[((lost.len() - 1) as f64 * share) as usize];
        let (free, median, most) = (lost.len(), at(0.5), at(0.99));
        println!("{name}: {free} of {refused} refused though free, median {median:.1} mm, 99 % {most:.1} mm");
        assert!(refused > 100 && free * 3 < refused && median < 60.0, "{name}");
    }
}

/// Weight swivels the wheel where gravity is not in its plane: a shape leaves it there, 5 mm nearer to an obstacle than allowed if only its wrap were wider.
#[test]
fn a_cable_swivels_its_pulley_by_its_weight() {
    let spec = json!({
        "version": 1, "clearance": 0.01, "ignore": [["platform", "o"]],
        "workspace": {"min": [-3.0, -0.3, -1.0], "max": [3.0, 0.3, 1.0]},
        "robot": {"platform": [{"box": [1.4936606930656215, 0.09882267540261845, 0.20600543630815943]}], "cables": [{
            "outlet": [3.171930665519774, 0.31779453070412905, -2.4302488077555613],
            "attachment": [0.0, 0.0, -0.10300271815407971],
            "linear_density": 1.6128289704045122, "sag_tension": 673.6999954857689,
            "pulley": {"radius": 0.15, "axis": [0.7091494537006523, 0.6985016527410285, -0.09592962750953392]},
        }]},
        "obstacles": [{"name": "o", "vertices": [
            [2.93345892171486, 0.5380170579139985, -2.5545308418539503], [4.51314991685431, 0.2443305674672578, -3.7454651831189967],
            [2.9349250778957723, 0.7326380452945913, -2.600579964072037], [4.5146160730352225, 0.43895155484785076, -3.791514305337083],
            [3.0561113329622813, 0.5735157018922389, -2.4005950361072053], [4.6358023281017315, 0.27982921144549827, -3.591529377372251],
            [3.0575774891431937, 0.7681366892728319, -2.4466441583252916], [4.637268484282644, 0.4744501988260912, -3.637578499590338],
        ]}],
        "query": {"orientation": [0.9907746388907914, -0.005956507831569064, -0.0016258498551993468, 0.13537906617170437]},
    });
    let scene = built(&spec).unwrap();
    let at = Point::new(-2.26679654872912, 0.050873539384025675, -0.895198579601819);
    assert!(refused(&scene, &at, &at, false));
    assert!(!CspaceEngine::new(&scene, Interference::Exact).unwrap().state_valid(&at));
}
