//! Certificates of scenes whose cables sag, or leave the frame near their outlets: what rests on that is accepted, and refused for the
//! same scene with straighter cables.

mod support;

use std::io::Write;
use std::sync::Arc;

use cdpr_certify::{Certificate, check_bound, check_certificate, is_bound};
use cdpr_core::Scene;
use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::Point;
use cdpr_core::limits::PROOF_EFFORT;
use cdpr_core::lower_bound::Forbidden;
use cdpr_core::plan::{PlanOptions, Query, plan};
use cdpr_core::planning::Status;
use cdpr_core::proof::{Answer, decide};
use cdpr_core::watch::Watch;
use serde_json::{Value, json};

use support::Random;

fn build(spec: &Value) -> Scene {
    Scene::new(serde_json::from_value(spec.clone()).unwrap()).unwrap()
}

fn compiled(scene: &Scene) -> Arc<CompiledScene> {
    let options = PlanOptions::default();
    CompiledScene::new(scene, options.engine, options.interference, &Watch::NONE).unwrap().into()
}

/// Cells that a decision about a random scene may visit.
const EFFORT: usize = 40_000;

/// The certificate that a scene has no path, if it has none, or that no path is much shorter than the one that is found.
fn proof_of(scene: &Scene, effort: usize) -> Option<Value> {
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
fn checked(scene: &Scene, certificate: &Value) -> Result<(), String> {
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
fn slit(from: f64, height: f64, cable: Value) -> Value {
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

/// Scenes that have no path because of how the cable hangs or leaves the frame, and the same with less of that.
fn samples() -> Vec<(Value, Value)> {
    let heavy = |density: f64| json!({"linear_density": density, "tension": [25.0, 100.0]});
    let vague = |error: f64| json!({"outlet_error": error});
    let both = |density: f64, error: f64| json!({"linear_density": density, "sag_tension": 25.0, "outlet_error": error, "diameter": 0.001});
    vec![
        (slit(0.5, 0.01, heavy(0.1)), slit(0.5, 0.01, heavy(0.02))),
        (slit(0.5, 0.01, heavy(0.1)), slit(0.5, 0.01, json!({}))),
        (slit(0.002, 0.0005, heavy(0.1)), slit(0.002, 0.0005, heavy(0.01))),
        (slit(0.5, 0.01, vague(0.02)), slit(0.5, 0.01, vague(0.005))),
        (slit(0.5, 0.012, both(0.06, 0.014)), slit(0.5, 0.012, both(0.06, 0.0))),
        (slit(0.5, 0.012, both(0.06, 0.014)), slit(0.5, 0.012, both(0.0, 0.014))),
    ]
}

#[test]
fn what_rests_on_sag_or_the_outlets_error_is_accepted_and_needs_them() {
    let file = std::env::var("CDPR_HANGING").ok().map(|name| std::fs::File::create(name).unwrap());
    for (k, (spec, weaker)) in samples().into_iter().enumerate() {
        let (scene, straighter) = (build(&spec), build(&weaker));
        let certificate = proof_of(&scene, PROOF_EFFORT).unwrap_or_else(|| panic!("{k}"));
        assert_eq!(certificate["format"], "cdpr-proof", "{k}");
        assert_eq!(checked(&scene, &certificate), Ok(()), "{k}");
        assert_eq!(proof_of(&straighter, PROOF_EFFORT).unwrap()["format"], "cdpr-bound", "{k}");
        let error = checked(&straighter, &certificate).unwrap_err();
        assert!(error.contains("expected it within the margin of where cable 0 and"), "{k}: {error}");
        if let Some(mut file) = file.as_ref() {
            writeln!(file, "{}", json!([spec, certificate, [[weaker, false]]])).unwrap();
        }
    }
}

#[test]
fn pulleys_are_refused() {
    let spec = slit(0.5, 0.01, json!({"outlet_error": 0.01}));
    let certificate = proof_of(&build(&spec), PROOF_EFFORT).unwrap();
    for own in [true, false] {
        let mut turned = spec.clone();
        let place = if own { &mut turned["robot"]["cables"][0] } else { &mut turned["robot"]["cable"] };
        place["pulley"] = json!({"radius": 0.01, "axis": [0.0, 0.0, 1.0]});
        let scene = build(&turned);
        let error = checked(&scene, &certificate).unwrap_err();
        assert!(error.starts_with("scene: found cable 0, which runs round a pulley"), "{error}");
        let compiled = compiled(&scene);
        let ends = [scene.start().unwrap(), scene.goal().unwrap()];
        let forbidden = Forbidden::new(compiled.level(), [&ends[0], &ends[1]], &Watch::NONE).unwrap();
        assert_eq!(forbidden.accepted_certificate(&scene, 2.0, &|_, _| true, &Watch::NONE).unwrap(), None);
    }
}

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.below(1 << 30) as f64 / (1u64 << 30) as f64)
    }

    fn of<T: Clone>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())].clone()
    }
}

/// A scene whose cables hang or leave the frame near their outlets, some of them from obstacles, with start and goal.
fn draw(random: &mut Random) -> Option<(Value, Scene)> {
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

/// The scene with cables that hang and err less, as shares.
fn straighter(spec: &Value, [sag, error]: [f64; 2]) -> Value {
    let mut straighter = spec.clone();
    for cable in straighter["robot"]["cables"].as_array_mut().unwrap() {
        for (key, share) in [("linear_density", sag), ("outlet_error", error)] {
            cable[key] = (cable[key].as_f64().unwrap() * share).into();
        }
    }
    straighter
}

/// `CDPR_VERIFY=n` draws n times as many scenes. `CDPR_HANGING_RANDOM=file` writes them all, for the checker in Python.
#[test]
fn certificates_of_random_scenes_are_accepted() {
    let scale: usize = std::env::var("CDPR_VERIFY").map_or(1, |n| n.parse().expect("CDPR_VERIFY is a number"));
    let file = std::env::var("CDPR_HANGING_RANDOM").ok().map(|name| std::fs::File::create(name).unwrap());
    let (mut proofs, mut bounds, mut needy) = (0, 0, [0, 0]);
    let mut refused = Vec::new();
    for seed in 0..40 * scale {
        let Some((spec, scene)) = draw(&mut Random(seed as u64)) else { continue };
        let Some(certificate) = proof_of(&scene, EFFORT) else { continue };
        let is_proof = certificate["format"] == "cdpr-proof";
        *(if is_proof { &mut proofs } else { &mut bounds }) += 1;
        if let Err(error) = checked(&scene, &certificate) {
            refused.push(format!("seed {seed}: {error}\n{certificate:.0}"));
        }
        let shares = [[0.0, 0.0], [0.9, 1.0], [1.0, 0.9], [1.0 - 1e-5, 1.0], [1.0, 1.0 - 1e-4]];
        let judged = shares[..if file.is_some() { shares.len() } else { 1 }].iter().map(|shares| {
            let weaker = straighter(&spec, *shares);
            let is_accepted = checked(&build(&weaker), &certificate).is_ok();
            json!([weaker, is_accepted])
        });
        let weaker: Vec<Value> = judged.collect();
        needy[usize::from(is_proof)] += usize::from(weaker[0][1] == false);
        if let Some(mut file) = file.as_ref() {
            writeln!(file, "{}", json!([spec, certificate, weaker])).unwrap();
        }
    }
    println!("{proofs} proofs, {bounds} bounds; refused for straight cables: {needy:?}");
    refused.iter().for_each(|line| println!("{line:.300}"));
    assert!(refused.is_empty(), "{} refused", refused.len());
    assert!(proofs > 3 && bounds > 9 && needy.iter().all(|count| *count > 3));
}

/// The engine finds how heavy the cable is when the slit becomes too low for it. What is proved just above that is refused just below.
#[test]
fn a_hundredth_of_the_sag_more_than_there_is_proves_nothing() {
    let hung = |density: f64| build(&slit(0.5, 0.01, json!({"linear_density": density, "tension": [25.0, 100.0]})));
    let passes = |density: f64| {
        let compiled = compiled(&hung(density));
        let at = |y: f64, height: f64| Point::new(0.8, y, height);
        // It has the most room at the end of the workspace that is nearest to the outlet.
        let heights = (0..300).map(|k| 0.995 + 1e-4 * f64::from(k));
        heights.into_iter().any(|height| compiled.level().motion_valid(&at(0.9, height), &at(1.1, height)))
    };
    let (mut light, mut heavy) = (0.07, 0.08);
    assert!(passes(light) && !passes(heavy));
    while heavy - light > 1e-4 {
        let middle = 0.5 * (light + heavy);
        *(if passes(middle) { &mut light } else { &mut heavy }) = middle;
    }
    let certificate = proof_of(&hung(1.005 * heavy), PROOF_EFFORT).unwrap();
    assert_eq!(checked(&hung(1.005 * heavy), &certificate), Ok(()));
    checked(&hung(light), &certificate).unwrap_err();
}
