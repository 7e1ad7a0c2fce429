//! Scenes whose cables can take several shapes, and their certificates.

use std::sync::Arc;

use cdpr_certify::{Certificate, check_bound, check_certificate, is_bound};
use cdpr_core::Scene;
use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::Point;
use cdpr_core::lower_bound::Forbidden;
use cdpr_core::plan::{PlanOptions, Query, plan};
use cdpr_core::planning::Status;
use cdpr_core::proof::{Answer, decide};
use cdpr_core::watch::Watch;
use serde_json::{Value, json};

use super::support::Random;

pub fn build(spec: &Value) -> Scene {
    Scene::new(serde_json::from_value(spec.clone()).unwrap()).unwrap()
}

pub fn compiled(scene: &Scene) -> Arc<CompiledScene> {
    let options = PlanOptions::default();
    CompiledScene::new(scene, options.engine, options.interference, &Watch::NONE).unwrap().into()
}

/// Cells that a decision about a random scene may visit.
pub const EFFORT: usize = 40_000;

/// The certificate that a scene has no path, if it has none, or that no path is much shorter than the one that is found.
pub fn proof_of(scene: &Scene, effort: usize) -> Option<Value> {
    let ends = [scene.start().unwrap(), scene.goal().unwrap()];
    let ends = [&ends[0], &ends[1]];
    let compiled = compiled(scene);
    let engine = compiled.level();
    let mut planner = PlanOptions::default().planner;
    planner.limits.max_samples = 2_000;
    let options = PlanOptions { planner, proof: false, ..PlanOptions::default() };
    if let Answer::NoPath(found) = decide(engine, ends, effort, &Watch::NONE).unwrap() {
        return serde_json::to_value(Certificate::of(&found, scene, engine)).ok();
    }
    let result = plan(Query::of(scene).by(&compiled), &options, &()).unwrap().result;
    if result.status != Status::Solved {
        return None;
    }
    let forbidden = Forbidden::new(engine, ends, &Watch::NONE).unwrap();
    let found = forbidden.certificate(scene, 0.99 * result.cost, 5_000, &Watch::NONE).unwrap()?;
    serde_json::to_value(&found).ok()
}

/// Checks a certificate as one of another scene.
pub fn checked(scene: &Scene, certificate: &Value) -> Result<(), String> {
    let mut own = certificate.clone();
    own["scene"] = scene.fingerprint().into();
    let text = own.to_string();
    let found = match is_bound(&text) {
        true => check_bound(scene, &text, &Watch::NONE).map(drop),
        false => check_certificate(scene, &text, &Watch::NONE).map(drop),
    };
    found.map_err(|error| error.to_string())
}

/// Two blocks in the middle, with a slit between them from x = `from` on, as high as given: a cable passes it on the way from start to
/// goal, and is level there. `cable` changes the cable.
pub fn slit(from: f64, height: f64, cable: Value) -> Value {
    let size = if from < 0.01 { [0.01, 0.002] } else { [0.1, 0.1] };
    let block = |name: &str, low: f64, high: f64| {
        let position = [from + 0.5 * size[0], 1.0, 0.5 * (low + high)];
        json!({"name": name, "box": [size[0], size[1], high - low], "position": position})
    };
    let mut spec = json!({
        "version": 1, "workspace": {"min": [0.8, 0.0, 0.6], "max": [2.0, 2.0, 1.4]},
        "robot": {"platform": [{"vertices": [[0.0, 0.0, 0.0]]}], "cables": [
            {"outlet": [0.0, 1.0, 1.0], "attachment": [0.0, 0.0, 0.0]},
        ]},
        "obstacles": [block("lower", -3.0, 1.0 - 0.5 * height), block("upper", 1.0 + 0.5 * height, 5.0)],
        "query": {"start": [0.85, 0.05, 1.0], "goal": [0.85, 1.95, 1.0]},
    });
    for (key, value) in cable.as_object().unwrap() {
        spec["robot"]["cables"][0][key] = value.clone();
    }
    spec
}

impl Random {
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.below(1 << 30) as f64 / (1u64 << 30) as f64)
    }

    pub fn of<T: Clone>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())].clone()
    }
}

/// A scene whose cables hang or leave the frame near their outlets, some of them from obstacles, with start and goal; with `pulleys`,
/// most of them run round some.
pub fn draw(random: &mut Random, pulleys: bool) -> Option<(Value, Scene)> {
    let half: [f64; 3] = random.of(&[[0.0; 3], [0.125, 0.125, 0.0625], [0.25, 0.0625, 0.0625]]);
    let mut platform = vec![json!({"box": half.map(|h| 2.0 * h)})];
    if half == [0.0; 3] {
        platform = vec![json!({"vertices": [half]})];
    } else if random.below(2) == 0 {
        platform.push(json!({"box": [0.0625, 0.0625, 0.25], "position": [0.0, 0.0, half[2] + 0.125]})); // a mast
    }
    let all_round = random.below(3) > 0; // cables from every corner of the workspace, where few ways are open
    let mut obstacles = Vec::new();
    for k in 0..2 + random.below(if all_round { 2 } else { 4 }) {
        let low: [f64; 3] = std::array::from_fn(|_| 0.25 * random.below(7) as f64);
        let size: [f64; 3] = std::array::from_fn(|_| {
            random.of(if all_round { &[0.0625, 0.125, 0.25, 0.25] } else { &[0.125, 0.5, 1.0, 2.0] })
        });
        let position: [f64; 3] = std::array::from_fn(|i| low[i] + 0.5 * size[i]);
        let mut body =
            json!({"name": format!("wall {}", k - k % (1 + random.below(2))), "box": size, "position": position});
        if random.below(3) == 0 {
            body["rpy"] = json!([0.0, 0.0, random.between(0.0, 1.5)]);
        }
        if random.below(2) == 0 {
            body["box"][2] = 2.5.into(); // a pillar
        }
        obstacles.push(body);
    }
    let mut cables = Vec::new();
    for k in 0..if all_round { 8 } else { 1 + random.below(4) } {
        let corner: [f64; 3] = std::array::from_fn(|i| if k >> i & 1 == 1 { 1.0 } else { -1.0 });
        let mut outlet: [f64; 3] = [random.between(-0.5, 2.5), random.between(-0.5, 2.5), random.between(1.5, 2.75)];
        if all_round {
            outlet = corner.map(|side| 1.0 + side);
        } else if random.below(3) == 0 {
            // On a beam of its own: on a face, an edge or a corner.
            let at: [f64; 3] = std::array::from_fn(|_| random.of(&[-1.0, 0.0, 1.0, 1.0]));
            let beam: [f64; 3] = [1.0, 0.25, 0.125];
            obstacles.push(json!({"name": format!("beam {k}"), "box": beam, "position": outlet}));
            outlet = std::array::from_fn(|i| outlet[i] + 0.5 * at[i] * beam[i]);
        }
        let side = |random: &mut Random| random.of(&[-1.0, 0.0, 1.0]);
        let attachment = match all_round {
            true => std::array::from_fn(|i| corner[i] * half[i]),
            false => [side(random) * half[0], side(random) * half[1], half[2]],
        };
        let weight = 9.81 * random.of(&[0.0, 0.02, 0.2, 1.0]);
        cables.push(json!({
            "name": format!("cable {k}"), "outlet": outlet, "attachment": attachment,
            "linear_density": weight / 9.81, "sag_tension": 1.0 + weight * random.of(&[40.0, 60.0, 400.0]),
            "outlet_error": random.of(&[0.0, 0.01, 0.05]), "diameter": random.of(&[0.0, 0.01]),
        }));
        if pulleys && random.below(4) > 0 {
            let tilted = |random: &mut Random| std::array::from_fn(|_| random.between(-1.0, 1.0));
            let up: [f64; 3] = if random.below(2) == 0 { [0.0, 0.0, 1.0] } else { tilted(random) };
            // The cable arrives from outside, so that it can leave towards the workspace.
            let side = (0..3).map(|i| up[i] * (1.0 - outlet[i])).sum::<f64>().signum();
            let axis = up.map(|x| if random.below(4) > 0 { side * x } else { x });
            cables[k]["pulley"] = json!({"radius": random.of(&[0.02, 0.05, 0.1]), "axis": axis});
        }
    }
    let turn = random.between(-0.5, 0.5);
    let mut spec = json!({
        "version": 1, "workspace": {"min": [0.0, 0.0, 0.0], "max": [2.0, 2.0, 2.0]},
        "clearance": random.of(&[0.0, 0.0, 0.03125]),
        "gravity": random.of(&[[0.0, 0.0, -9.81], [0.0, 0.0, -9.81], [3.0, -2.0, -9.0]]),
        "robot": {"platform": platform, "cables": cables}, "obstacles": obstacles,
        "query": {"orientation": random.of(&[[1.0, 0.0, 0.0, 0.0], [turn.cos(), 0.6 * turn.sin(), 0.0, 0.8 * turn.sin()]])},
    });
    let scene = Scene::new(serde_json::from_value(spec.clone()).unwrap()).ok()?;
    let compiled = compiled(&scene);
    let engine = compiled.level();
    let mut places = (0..40).map(|_| Point::from(std::array::from_fn(|_| random.between(0.0, 2.0))));
    let (first, second) = (places.find(|p| engine.state_valid(p))?, places.find(|p| engine.state_valid(p))?);
    let apart = |p: &Point| matches!(decide(engine, [&first, p], EFFORT, &Watch::NONE).unwrap(), Answer::NoPath(_));
    let ends = [first, places.filter(|p| engine.state_valid(p)).take(2).find(apart).unwrap_or(second)];
    let ends = ends.map(|end| [end.x, end.y, end.z]);
    spec["query"]["start"] = json!(ends[0]);
    spec["query"]["goal"] = json!(ends[1]);
    let scene = build(&spec);
    Some((spec, scene))
}
