//! Certificates of bounds are accepted; with any damage they are refused.

mod support;

use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use cdpr_certify::{BoundCertificate, Check, check_bound};
use cdpr_core::ErrorClass;
use cdpr_core::model::Scene;
use cdpr_core::watch::Watch;
use rayon::prelude::*;

use support::{Random, scenes};

struct Sample {
    scene: Scene,
    /// The scene without start and goal.
    unasked: Scene,
    text: &'static str,
    certificate: BoundCertificate,
    /// Length of a path.
    path: f64,
}

macro_rules! sample {
    ($name:literal, $path:literal) => {{
        let text = include_str!(concat!("data/bound-", $name, ".json"));
        let [scene, unasked] = scenes(include_str!(concat!("data/bound-", $name, ".scene.json")));
        let certificate = BoundCertificate::parse(text).unwrap();
        Sample { scene, unasked, text, certificate, path: $path }
    }};
}

fn samples() -> [Sample; 2] {
    [sample!("3-1", 2.5918), sample!("hard3", 2.6562)]
}

#[test]
fn samples_are_accepted() {
    for sample in samples() {
        let summary = check_bound(&sample.scene, sample.text, &Watch::NONE).unwrap();
        assert_eq!((summary.length, summary.margin), (sample.certificate.length, 1e-7));
        assert!(summary.length < sample.path && summary.length > sample.path / 1.011);
        assert_eq!(sample.certificate.check(&sample.unasked, &Watch::NONE).unwrap(), summary);
    }
}

/// Edges that have to be listed, found by leaving out each.
fn needed(sample: &Sample) -> Vec<usize> {
    let without = |k: &usize| {
        let mut fewer = sample.certificate.clone();
        fewer.edges.remove(*k);
        fewer.check(&sample.scene, &Watch::NONE)
    };
    (0..sample.certificate.edges.len()).into_par_iter().filter(|k| without(k).is_err()).collect()
}

/// Damages of each sample; all kinds in turn. `CDPR_VERIFY=n` makes n times as many; optimised code judges three times as many.
fn rounds() -> usize {
    let few = if cfg!(debug_assertions) { 11 } else { 66 };
    few * std::env::var("CDPR_VERIFY").map_or(1, |n| n.parse::<usize>().expect("CDPR_VERIFY is a number"))
}

/// Each damage leaves no true proof, by construction: lengths beyond a known path, edges that have to be listed but are not
/// or not whole, regions that are not forbidden, other questions.
#[test]
fn every_damage_is_refused() {
    let mut random = Random(1);
    let mut counts = [0usize; 11];
    for sample in samples() {
        let sound = &sample.certificate;
        let needed = needed(&sample);
        assert!(needed.len() > 5, "{}", needed.len());
        for round in 0..rounds() {
            let way = round % counts.len();
            let mut damaged = sound.clone();
            let mut scene = &sample.scene;
            let k = needed[random.below(needed.len())];
            let [region, row] = [random.below(sound.regions.len()), random.below(4)];
            match way {
                0 => damaged.length = sample.path + 1e-4 * (1 + random.below(1000)) as f64,
                1 => drop(damaged.edges.remove(k)),
                2 => {
                    // The edge is listed up to somewhere before its end only.
                    let (edge, share) = (&mut damaged.edges[k], 0.2 + 0.006 * random.below(100) as f64);
                    let length = (0..3).map(|k| (edge.ends[1][k] - edge.ends[0][k]).abs()).fold(0.0, f64::max);
                    if length < 1e-6 {
                        // Most of a short edge may be covered, so that a shorter part proves as much: the edge is moved
                        // instead.
                        edge.ends.iter_mut().for_each(|end| end[random.below(3)] += 0.1);
                    } else {
                        let side = random.below(2);
                        for k in 0..3 {
                            edge.ends[side][k] =
                                edge.ends[1 - side][k] + share * (edge.ends[side][k] - edge.ends[1 - side][k]);
                        }
                    }
                }
                3 => damaged.edges[k].ends[random.below(2)][random.below(3)] += 1e-3,
                4 => {
                    let halves = &mut damaged.regions[region].half_spaces;
                    halves.iter_mut().for_each(|half| half[3] += 1e-5);
                }
                5 => {
                    // Without this region the path is shorter, or an edge names one that is not there.
                    damaged.regions.truncate(sound.edges.iter().map(|edge| edge.region).max().unwrap());
                }
                6 => {
                    // All labels and the length are raised: then those after the start are too large.
                    let more = sample.path - sound.length + 0.01;
                    damaged.length += more;
                    damaged.edges.iter_mut().flat_map(|edge| &mut edge.pieces).for_each(|piece| {
                        piece[1] += more;
                        piece[2] += more;
                    });
                }
                7 => {
                    let end = if random.below(2) == 0 { &mut damaged.start } else { &mut damaged.goal };
                    end[random.below(3)] += 1e-6;
                }
                8 => {
                    // The ends are much nearer to each other than the length.
                    damaged.goal = damaged.start;
                    damaged.goal[random.below(3)] += 0.01;
                    scene = &sample.unasked;
                }
                9 => damaged.margin = [1e-9, 2e-6, -1.0, f64::NAN][random.below(4)],
                _ => damaged.regions[region].half_spaces[row % 3][random.below(3)] += 0.1,
            }
            let result = damaged.check(scene, &Watch::NONE);
            assert!(result.is_err(), "accepted in round {round}, way {way}: {result:?}");
            counts[way] += 1;
        }
    }
    assert!(counts.iter().all(|count| *count >= rounds() / counts.len()), "{counts:?}");
}

/// A label that is the only reason why another one is not lower cannot be raised; a true bound may survive damage of
/// any other label. So every accepted certificate must be true.
#[test]
fn certificates_accepted_with_changed_labels_are_true() {
    let mut random = Random(2);
    let mut refused = 0;
    for sample in samples() {
        for _ in 0..rounds() {
            let mut changed = sample.certificate.clone();
            changed.length += 1e-3 * random.below(60) as f64;
            let edges = changed.edges.len();
            for _ in 0..3 {
                let edge = &mut changed.edges[random.below(edges)];
                let piece = random.below(edge.pieces.len());
                edge.pieces[piece][1 + random.below(2)] += 0.1 * random.below(10) as f64;
            }
            match changed.check(&sample.scene, &Watch::NONE) {
                Ok(summary) => assert!(summary.length < sample.path, "{}", summary.length),
                Err(_) => refused += 1,
            }
        }
    }
    assert!(refused > rounds(), "{refused}");
}

#[test]
fn refusals_name_the_place() {
    let [sample, _] = samples();
    let told = |change: &dyn Fn(&mut BoundCertificate)| {
        let mut damaged = sample.certificate.clone();
        change(&mut damaged);
        damaged.check(&sample.scene, &Watch::NONE).unwrap_err().to_string()
    };
    let is = |text: String, start: &str| assert!(text.starts_with(start), "{text}");
    is(told(&|c| c.scene = "0123456789abcdef".into()), "scene: found a proof for another scene");
    is(told(&|c| c.start[0] += 0.1), "start: found a proof for another question");
    is(told(&|c| c.orientation = [0.0, 1.0, 0.0, 0.0]), "orientation: found");
    is(told(&|c| c.bounds[0][2] += 2e-6), "box: found ");
    is(told(&|c| c.margin = 0.01), "margin: found 0.01, expected 1e-8 to 1e-6 m");
    is(told(&|c| c.length = f64::INFINITY), "length: found inf, expected numbers up to 1000");
    let unlisted = |text: String| {
        assert!(text.starts_with("regions[") && text.contains("]: found an edge that is free from"), "{text}")
    };
    unlisted(told(&|c| c.length = 3.0)); // that was too far away before
    let raise = |c: &mut BoundCertificate| {
        c.edges.iter_mut().flat_map(|edge| &mut edge.pieces).for_each(|piece| piece[1] += 1.0)
    };
    is(told(&raise), "edges: found the label");
    unlisted(told(&|c| c.edges.clear()));
    is(told(&|c| c.edges[0].region = 99), "edges[0]: found half-spaces");
    is(told(&|c| c.edges[0].planes[1] = 99), "edges[0]: found half-spaces");
    is(told(&|c| c.edges[0].pieces.clear()), "edges[0]: found pieces that do not end one after another");
    is(told(&|c| c.edges[0].pieces[0][1] = f64::NAN), "edges[0]: found NaN");
    is(told(&|c| c.regions[1].who[0] = "cable 9".into()), "regions[1]: found \"cable 9\", expected the name");
    is(
        told(&|c| c.regions[0].half_spaces.clear()),
        "edges[0]: found half-spaces 0 and 1 of region 0, expected indices",
    );
    let widen = |c: &mut BoundCertificate| c.regions[0].half_spaces.iter_mut().for_each(|half| half[3] += 0.01);
    is(told(&widen), "regions[0]: found the position [");
    is(told(&|c| c.regions[0].half_spaces[0][0] = 2.0), "regions[0].half_spaces[0]: found a normal of length");
}

#[test]
fn bad_text_is_an_error_in_bounded_time() {
    let [sample, _] = samples();
    let told = |text: &str| check_bound(&sample.scene, text, &Watch::NONE).unwrap_err().to_string();
    let is = |text: String, start: &str| assert!(text.starts_with(start), "{text}");
    is(told(&sample.text.replacen("\"version\":1", "\"version\":2", 1)), "version: found 2, expected 1");
    is(told(&sample.text.replacen("cdpr-bound", "cdpr-proof", 1)), "format: found \"cdpr-proof\", expected");
    is(told(&sample.text.replacen("\"margin\":1e-7", "\"margin\":NaN", 1)), "margin: found no certificate");
    is(
        told(&sample.text.replacen("\"length\"", "\"more\":1,\"length\"", 1)),
        "more: found no certificate: unknown field",
    );
    is(told(&(sample.text.to_string() + "0")), "found more than a certificate");
    for end in (0..sample.text.len()).step_by(397) {
        told(&sample.text[..end]);
    }
    let rows = "[0.5,0,0],".repeat(10_000_000);
    let (head, tail) = sample.text.split_once("\"pieces\":[").unwrap();
    is(told(&format!("{head}\"pieces\":[{rows}{tail}")), "edges[0].pieces: found 1000000");
    let corners = "[0,0,0,0],".repeat(100_000);
    let (head, _) = sample.text.split_once("\"corners\":[").unwrap();
    is(told(&format!("{head}\"corners\":[{corners}[0,0,0,0]]}}")), "corners: found 100001, expected at most 10000");
}

#[test]
fn an_interrupted_check_stops_and_accepts_nothing() {
    let [_, sample] = samples();
    for polls in [0, 1, 5, 20] {
        let left = AtomicUsize::new(polls);
        let stop = || left.fetch_update(Relaxed, Relaxed, |left| left.checked_sub(1)).is_err();
        let found = check_bound(&sample.scene, sample.text, &Watch::on(&stop));
        assert_eq!(found.unwrap_err().class(), ErrorClass::Interrupted, "{polls}");
    }
}
