//! Certificates of scenes whose cables sag, or leave the frame near their outlets: what rests on that is accepted, and refused for the
//! same scene with straighter cables.

#[path = "support/shapes.rs"]
mod shapes;
mod support;

use std::io::Write;

use cdpr_core::geometry::Point;
use cdpr_core::limits::PROOF_EFFORT;
use serde_json::{Value, json};

use shapes::{EFFORT, build, checked, compiled, draw, proof_of, slit};
use support::Random;

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
        let Some((spec, scene)) = draw(&mut Random(seed as u64), false) else { continue };
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
