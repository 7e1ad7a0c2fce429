//! Certificates of scenes whose cables run round pulleys: what rests on them is accepted, and refused for other pulleys or none.
//! What the checker calls forbidden, the engine refuses.

#[path = "support/shapes.rs"]
mod shapes;
mod support;

use std::io::Write;

use cdpr_certify::{check_bound, check_certificate};
use cdpr_core::Scene;
use cdpr_core::collision::Interference;
use cdpr_core::geometry::{Point, Vector};
use cdpr_core::limits::PROOF_EFFORT;
use cdpr_core::watch::Watch;
use rayon::prelude::*;
use serde_json::{Value, json};

use shapes::{EFFORT, build, checked, compiled, draw, proof_of, slit};
use support::Random;

/// The slit with a pulley of this radius, which the cable leaves at about the height of the slit, and other changes of the cable.
fn round(radius: f64, from: f64, height: f64, more: Value) -> Value {
    let mut cable = json!({"outlet": [0.0, 1.0, 1.0 - radius], "pulley": {"radius": radius, "axis": [0.0, 0.0, 1.0]}});
    cable.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
    slit(from, height, cable)
}

fn file(name: &str) -> Option<std::fs::File> {
    std::env::var(name).ok().map(|name| std::fs::File::create(name).unwrap())
}

/// Scenes that have no path because of where the cable can leave its pulley, and the same with smaller pulleys or none.
fn samples() -> Vec<(Value, Vec<Value>)> {
    let heavy = json!({"linear_density": 0.02, "tension": [25.0, 100.0]});
    let vague = json!({"outlet_error": 0.01});
    let straight = |more: &Value| slit(0.5, 0.01, more.clone());
    let none = json!({});
    vec![
        (round(0.2, 0.5, 0.01, none.clone()), vec![round(0.05, 0.5, 0.01, none.clone()), straight(&none)]),
        (round(0.15, 0.5, 0.01, heavy.clone()), vec![round(0.02, 0.5, 0.01, heavy.clone()), straight(&heavy)]),
        (round(0.15, 0.5, 0.012, vague.clone()), vec![round(0.02, 0.5, 0.012, vague.clone()), straight(&vague)]),
    ]
}

#[test]
fn what_rests_on_pulleys_is_accepted_and_needs_them() {
    let mut file = file("CDPR_PULLEYS");
    for (k, (spec, weaker)) in samples().into_iter().enumerate() {
        let certificate = proof_of(&build(&spec), PROOF_EFFORT).unwrap_or_else(|| panic!("{k}"));
        assert_eq!(certificate["format"], "cdpr-proof", "{k}");
        assert_eq!(checked(&build(&spec), &certificate), Ok(()), "{k}");
        for (number, weaker) in weaker.iter().enumerate() {
            assert_eq!(proof_of(&build(weaker), PROOF_EFFORT).unwrap()["format"], "cdpr-bound", "{k} {number}");
            let error = checked(&build(weaker), &certificate).unwrap_err();
            assert!(error.contains("expected it within the margin of where cable 0 and"), "{k} {number}: {error}");
        }
        let weaker: Vec<Value> = weaker.into_iter().map(|weaker| json!([weaker, false])).collect();
        if let Some(file) = file.as_mut() {
            writeln!(file, "{}", json!([spec, certificate, weaker])).unwrap();
        }
    }
}

/// Two cables round pulleys that cross above the platform, in a channel, where it passes between their outlets. `aside` moves one outlet
/// along the channel, and with it where they cross.
fn crossing(radius: f64, aside: f64) -> Value {
    let cable = |name: &str, side: f64, [y, z]: [f64; 2]| {
        let pulley = json!({"radius": radius, "axis": [0.0, 0.0, 1.0]});
        json!({
            "name": name, "outlet": [1.0 - side, y, z], "attachment": [0.2 * side, 0.0, 0.01], "diameter": 0.1, "pulley": pulley,
        })
    };
    json!({
        "version": 1, "workspace": {"min": [0.78, 0.0, 0.97], "max": [1.22, 2.0, 1.03]},
        "robot": {"platform": [{"box": [0.4, 0.02, 0.02]}], "cables": [cable("left", 1.0, [1.0, 1.2]), cable("right", -1.0, [1.0 + aside, 2.4])]},
        "query": {"start": [1.0, 0.1, 1.0], "goal": [1.0, 1.9, 1.0]},
    })
}

/// Positions in closed boxes of a certificate, at least its margin inside, are not valid.
fn assert_refused(scene: &Scene, certificate: &Value) {
    let (compiled, mut random) = (compiled(scene), Random(3));
    let closed = certificate["boxes"].as_array().unwrap().iter().filter(|cell| cell[6] == -2);
    for cell in closed {
        let side = |k: usize| cell[k].as_f64().unwrap();
        let at = Point::from(std::array::from_fn(|k| random.between(side(k) + 2e-6, side(k + 3) - 2e-6)));
        assert!(!compiled.level().state_valid(&at), "{at} {cell}");
    }
}

/// `CDPR_PULLEYS_PAIRS=file` writes what is judged, for the checker in Python.
#[test]
fn cables_that_cross_round_pulleys_bar_the_way() {
    let mut file = file("CDPR_PULLEYS_PAIRS");
    for radius in [0.02, 0.1] {
        let spec = crossing(radius, 0.0);
        let certificate = proof_of(&build(&spec), PROOF_EFFORT).unwrap();
        assert_eq!(certificate["format"], "cdpr-proof", "{radius}");
        assert!(certificate.to_string().contains(r#"["left","right"]"#), "{radius}");
        assert_eq!(checked(&build(&spec), &certificate), Ok(()), "{radius}");
        // Round large pulleys, cables are near each other also if an outlet is a little elsewhere.
        let others = [(radius, 0.0), (radius, 0.03), (radius, -0.3), (0.5 * radius, 0.0)].map(|(radius, aside)| {
            let other = crossing(radius, aside);
            let accepted = checked(&build(&other), &certificate).is_ok();
            assert!(!accepted || aside >= 0.0, "{radius} {aside}");
            if accepted {
                assert_refused(&build(&other), &certificate);
            }
            json!([other, accepted])
        });
        if let Some(file) = file.as_mut() {
            writeln!(file, "{}", json!([spec, certificate, others])).unwrap();
        }
    }
}

/// A mass on four cables round pulleys, and a wall so high that above it the cables are too flat to hold the mass; no cable can touch
/// it.
fn too_flat(radius: f64, most: f64) -> Value {
    let cable = |name: String, [x, y]: [f64; 2]| {
        let pulley = json!({"radius": radius, "axis": [0.0, 0.0, 1.0]});
        json!({"name": name, "outlet": [x, y, 2.0], "attachment": [0.0, 0.0, 0.0], "tension": [1.0, most], "pulley": pulley})
    };
    let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    let cables: Vec<Value> = corners.into_iter().enumerate().map(|(k, at)| cable(format!("cable {k}"), at)).collect();
    json!({
        "version": 1, "workspace": {"min": [0.4, 0.98, 0.9], "max": [1.6, 1.02, 1.9]}, "wrench": {"force": 1.0},
        "robot": {"platform": [{"vertices": [[0.0, 0.0, 0.0]]}], "mass": 1.0, "cables": cables},
        "obstacles": [{"name": "wall", "box": [0.3, 2.0, 1.8375], "position": [1.0, 1.0, 0.91875]}],
        "ignore": (0..4).map(|k| json!([format!("cable {k}"), "wall"])).collect::<Vec<_>>(),
        "query": {"start": [0.5, 1.0, 1.0], "goal": [1.5, 1.0, 1.0]},
    })
}

/// `CDPR_PULLEYS_WRENCHES=file` writes what is judged, for the checker in Python.
#[test]
fn cables_round_pulleys_that_are_too_weak_bar_the_way() {
    let mut file = file("CDPR_PULLEYS_WRENCHES");
    for (radius, weak) in [(0.002, 16.0), (0.03, 12.0)] {
        let spec = too_flat(radius, weak);
        let certificate = proof_of(&build(&spec), PROOF_EFFORT).unwrap();
        assert_eq!(certificate["format"], "cdpr-proof", "{radius}");
        assert!(certificate.to_string().contains(r#"["wrench","#), "{radius}");
        assert_eq!(checked(&build(&spec), &certificate), Ok(()), "{radius}");
        assert_refused(&build(&spec), &certificate);
        // Stronger cables hold the mass higher, and from larger wheels they may leave lower.
        let others =
            [(radius, 40.0), (4.0 * radius, weak), (0.5 * radius, weak), (radius, weak - 1.0)].map(|(radius, most)| {
                let other = too_flat(radius, most);
                let accepted = checked(&build(&other), &certificate).is_ok();
                assert!(!accepted || most < 18.0, "{radius} {most}");
                if accepted {
                    assert_refused(&build(&other), &certificate);
                }
                json!([other, accepted])
            });
        assert!(others.iter().any(|other| other[1] == true) && others.iter().any(|other| other[1] == false));
        if let Some(file) = file.as_mut() {
            writeln!(file, "{}", json!([spec, certificate, others])).unwrap();
        }
    }
}

#[test]
fn damaged_certificates_and_changed_pulleys_are_refused() {
    let spec = round(0.2, 0.5, 0.01, json!({}));
    let (scene, certificate) = (build(&spec), proof_of(&build(&spec), PROOF_EFFORT).unwrap());
    let refused = |what: &str, damage: &dyn Fn(&mut Value)| {
        let mut damaged = certificate.clone();
        damage(&mut damaged);
        assert!(damaged != certificate && checked(&scene, &damaged).is_err(), "{what}");
    };
    for (k, region) in certificate["regions"].as_array().unwrap().iter().enumerate() {
        refused("a region 2 cm wider", &|c| {
            for plane in c["regions"][k]["half_spaces"].as_array_mut().unwrap() {
                plane[3] = (plane[3].as_f64().unwrap() + 0.02).into();
            }
        });
        let other = if region["who"][1] == "upper" { "lower" } else { "upper" };
        refused("another obstacle", &|c| c["regions"][k]["who"][1] = other.into());
    }
    let boxes = certificate["boxes"].as_array().unwrap();
    for k in (0..boxes.len()).step_by(1 + boxes.len() / 40) {
        refused("a box less", &|c| drop(c["boxes"].as_array_mut().unwrap().remove(k)));
        refused("a box moved", &|c| c["boxes"][k][3] = (boxes[k][3].as_f64().unwrap() + 1e-6).into());
        if boxes[k][6] == -1 {
            refused("an open box in a region", &|c| c["boxes"][k][6] = 0.into());
        }
    }
    checked(&build(&smaller(&spec, 0.5)), &certificate).unwrap_err();
    let other = check_certificate(&build(&smaller(&spec, 0.999)), &certificate.to_string(), &Watch::NONE);
    assert!(other.unwrap_err().to_string().contains("found a proof for another scene"));
    let mut turned = spec.clone();
    turned["robot"]["cables"][0]["pulley"]["axis"] = json!([1.0, 0.0, 0.0]);
    checked(&build(&turned), &certificate).unwrap_err();
    turned["robot"]["cables"][0].as_object_mut().unwrap().remove("pulley");
    checked(&build(&turned), &certificate).unwrap_err();
}

/// The scene with wheels that are a share of their size.
fn smaller(spec: &Value, share: f64) -> Value {
    let mut smaller = spec.clone();
    for cable in smaller["robot"]["cables"].as_array_mut().unwrap() {
        if let Some(radius) = cable.get("pulley").map(|pulley| pulley["radius"].as_f64().unwrap()) {
            cable["pulley"]["radius"] = (radius * share).into();
        }
    }
    smaller
}

/// `CDPR_VERIFY=n` draws n times as many scenes. `CDPR_PULLEYS_RANDOM=file` writes them all, for the checker in Python.
#[test]
fn certificates_of_random_scenes_are_accepted() {
    let scale: usize = std::env::var("CDPR_VERIFY").map_or(1, |n| n.parse().expect("CDPR_VERIFY is a number"));
    let mut file = file("CDPR_PULLEYS_RANDOM");
    let judged = |seed: usize| {
        let (spec, scene) = draw(&mut Random(seed as u64), true)?;
        let certificate = proof_of(&scene, EFFORT)?;
        let error = checked(&scene, &certificate).err();
        let refused = error.map(|error| format!("seed {seed}: {error}\n{certificate:.0}"));
        let weaker = [1.0 - 1e-5, 0.9, 0.5].into_iter().filter_map(|share| {
            let weaker = smaller(&spec, share);
            let scene = Scene::new(serde_json::from_value(weaker.clone()).unwrap()).ok()?;
            let is_accepted = checked(&scene, &certificate).is_ok();
            Some(json!([weaker, is_accepted]))
        });
        let weaker: Vec<Value> = weaker.collect();
        Some((spec, certificate, weaker, refused))
    };
    let judged: Vec<_> = (0..50 * scale).into_par_iter().filter_map(judged).collect();
    let (mut proofs, mut bounds, mut needy) = (0, 0, [0, 0]);
    for (spec, certificate, weaker, _) in &judged {
        let is_proof = certificate["format"] == "cdpr-proof";
        *(if is_proof { &mut proofs } else { &mut bounds }) += 1;
        needy[usize::from(is_proof)] += usize::from(weaker.iter().any(|other| other[1] == false));
        if let Some(file) = file.as_mut() {
            writeln!(file, "{}", json!([spec, certificate, weaker])).unwrap();
        }
    }
    let refused: Vec<_> = judged.into_iter().filter_map(|(.., refused)| refused).collect();
    println!("{proofs} proofs, {bounds} bounds; refused for smaller pulleys: {needy:?}");
    refused.iter().for_each(|line| println!("{line:.300}"));
    assert!(refused.is_empty(), "{} refused", refused.len());
    assert!(proofs > 3 && bounds > 9 && needy.iter().all(|count| *count > 3), "{proofs} {bounds} {needy:?}");
}

/// Whether the checker accepts that two members forbid a position, with a cube of 2 µm around it.
fn forbids(scene: &Scene, who: [&str; 2], at: &Point) -> bool {
    let half = 1e-6;
    let plane = |k: usize| {
        let (axis, sign) = (k / 2, if k.is_multiple_of(2) { 1.0 } else { -1.0 });
        let normal: [f64; 3] = std::array::from_fn(|i| if i == axis { sign } else { 0.0 });
        [normal[0], normal[1], normal[2], sign * at[axis] + half]
    };
    let [start, goal] = [scene.start().unwrap(), scene.goal().unwrap()].map(|p| [p.x, p.y, p.z]);
    let text = json!({
        "format": "cdpr-bound", "version": 1, "scene": scene.fingerprint(), "margin": 1e-7, "length": 0.1,
        "orientation": cdpr_core::geometry::wxyz(scene.orientation()), "start": start, "goal": goal,
        "box": [[-9.0, -9.0, -9.0], [9.0, 9.0, 9.0]], "edges": [], "corners": [],
        "regions": [{"who": who, "half_spaces": std::array::from_fn::<_, 6, _>(plane)}],
    });
    match check_bound(scene, &text.to_string(), &Watch::NONE).map_err(|error| error.to_string()) {
        Err(error) if error.starts_with("regions[0]: found the position") => false,
        Err(error) if error.starts_with("regions[0]: found") && error.contains("forbid no positions") => false,
        Err(error) => {
            assert!(
                error.starts_with("regions[0]: found an edge") || error.starts_with("regions[0]: found a corner"),
                "{error}"
            );
            true
        }
        Ok(_) => true,
    }
}

/// Positions next to where a condition on a cable and a body begins to break: beside, the checker forbids none of them, and inside
/// nearly all. `CDPR_PULLEYS_POINTS=file` writes them, for the checker in Python.
#[test]
fn the_checker_forbids_what_the_engine_refuses() {
    let scale: usize = std::env::var("CDPR_VERIFY").map_or(1, |n| n.parse().expect("CDPR_VERIFY is a number"));
    let mut file = file("CDPR_PULLEYS_POINTS");
    let (mut allowed, mut forbidden, mut missed) = (0, 0, 0);
    for seed in 0..30 * scale {
        let mut random = Random(1_000_000 + seed as u64);
        let Some((spec, scene)) = draw(&mut random, true) else { continue };
        let compiled = compiled(&scene);
        let conditions = compiled.level().conditions();
        let mut points = Vec::new();
        let mut pairs: Vec<Vec<String>> =
            conditions.list.iter().map(|condition| conditions.culprits(condition)).collect();
        pairs.retain(
            |who| matches!(&who[..], [cable, body] if cable.starts_with("cable") && !body.starts_with("cable")),
        );
        pairs.sort();
        pairs.dedup();
        for who in &pairs {
            let own: Vec<_> = conditions
                .list
                .iter()
                .filter(|condition| {
                    conditions.culprits(condition) == *who && !condition.details().closes_seam(&conditions.bodies)
                })
                .collect();
            let breaks = |p: &Point| own.iter().any(|c| c.breaks(&conditions.bodies, Interference::Exact, p, p));
            for _ in 0..3 {
                let mut places = (0..60)
                    .map(|_| Point::from(std::array::from_fn(|_| random.between(0.0, 2.0))))
                    .collect::<Vec<_>>()
                    .into_iter();
                let first = places.next().unwrap();
                let Some(second) = places.find(|p| breaks(p) != breaks(&first)) else { break };
                let [mut free, mut taken] = if breaks(&first) { [second, first] } else { [first, second] };
                while (taken - free).norm() > 1e-6 {
                    let middle = free + (taken - free) * 0.5;
                    *(if breaks(&middle) { &mut taken } else { &mut free }) = middle;
                }
                let out = (free - taken).normalize();
                for far in [1e-4, 1e-3] {
                    for (at, broken) in [(free + out * far, false), (taken - out * far, true)] {
                        let steps = (0..6).map(|k| Vector::ith(k / 2, if k % 2 == 0 { far } else { -far }));
                        if !steps.chain([Vector::zeros()]).all(|step| breaks(&(at + step * 0.5)) == broken) {
                            continue; // too close to the surface to tell
                        }
                        let found = forbids(&scene, [&who[0], &who[1]], &at);
                        assert!(broken || !found, "seed {seed}: {who:?} {at}\n{spec}");
                        allowed += usize::from(!broken);
                        forbidden += usize::from(broken);
                        missed += usize::from(broken && !found);
                        points.push(json!([who, [at.x, at.y, at.z], found]));
                    }
                }
            }
        }
        if let Some(file) = file.as_mut() {
            let vertices = |exits: &[Point]| exits.iter().map(|v| [v.x, v.y, v.z]).collect::<Vec<_>>();
            let exits = scene.envelopes().iter().map(|envelope| envelope.as_ref().map(|e| vertices(&e.exits)));
            writeln!(file, "{}", json!([spec, points, exits.collect::<Vec<_>>()])).unwrap();
        }
    }
    println!("{allowed} allowed positions, {forbidden} forbidden ones, {missed} of these missed");
    assert!(allowed > 100 && forbidden > 100 && 20 * missed <= forbidden);
}
