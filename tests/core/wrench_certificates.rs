//! Certificates of lower bounds where required wrenches close the shorter paths: the checker accepts what is written, and whatever it
//! accepts is true.

use cdpr_certify::check_bound;
use cdpr_core::certificate::{BoundCertificate, Region, WRENCH, WeakBox, WeakDirection};
use cdpr_core::geometry::{Point, Vector};
use cdpr_core::lower_bound::Forbidden;
use cdpr_core::model::{MarginSpec, Scene};
use cdpr_core::testing::scene;
use cdpr_core::watch::Watch;
use cdpr_core::wrench::{Measure, measures};
use cdpr_tests::with_pulleys;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::wrench_bounds::{EFFORT, engine, example};

/// A scene, the length of its best known path, m, and the gap to be certified.
const EXAMPLES: [(&str, f64, f64); 4] =
    [("cogiro", 11.6052, 0.06), ("caroca", 6.3960, 0.03), ("mpi_simulator", 7.9956, 0.02), ("ipanema2", 3.9891, 0.005)];

fn certificate(scene: &Scene, enough: f64) -> BoundCertificate {
    let (engine, ends) = (engine(scene), [scene.start().unwrap(), scene.goal().unwrap()]);
    let forbidden = Forbidden::new(&*engine, ends.each_ref(), &Watch::NONE).unwrap();
    forbidden.certificate(scene, enough, EFFORT, &Watch::NONE).unwrap().expect("a certificate")
}

fn checked(scene: &Scene, certificate: &BoundCertificate) -> Result<f64, String> {
    let text = serde_json::to_string(certificate).unwrap();
    check_bound(scene, &text, &Watch::NONE).map(|summary| summary.length).map_err(|error| error.to_string())
}

#[test]
fn gaps_of_built_robots_are_certified() {
    for (name, cost, gap) in EXAMPLES {
        let scene = example(name);
        let certificate = certificate(&scene, cost / (1.0 + gap));
        assert!(certificate.regions.iter().any(|region| !region.boxes.is_empty()), "{name}");
        let proved = checked(&scene, &certificate).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(proved > cost / (1.0 + gap) - 1e-3 && proved < cost, "{name}: {proved}");
    }
}

#[test]
fn wrenches_round_pulleys_are_certified() {
    for (name, enough, least) in [("cogiro", 10.5, 10.3), ("mpi_simulator", 7.6, 7.4), ("ipanema2", 3.96, 3.9)] {
        for radius in [1e-3, 0.05] {
            let scene = with_pulleys(&example(name), radius);
            let found = accepted(&scene, enough, &|_| true);
            println!("{name} {radius}: {} with wrenches: {}", found.length, counts_wrenches(&found));
            assert!(found.length > least && counts_wrenches(&found), "{name} {radius}: {}", found.length);
        }
    }
}

/// The certificate that is written for at most a length, if it also passes another test.
fn accepted(scene: &Scene, enough: f64, passes: &dyn Fn(&BoundCertificate) -> bool) -> BoundCertificate {
    let (engine, ends) = (engine(scene), [scene.start().unwrap(), scene.goal().unwrap()]);
    let forbidden = Forbidden::new(&*engine, ends.each_ref(), &Watch::NONE).unwrap();
    let accepts =
        |certificate: &BoundCertificate, _: &Watch| passes(certificate) && checked(scene, certificate).is_ok();
    forbidden.accepted_certificate(scene, enough, &accepts, &Watch::NONE).unwrap().expect("a certificate")
}

fn counts_wrenches(certificate: &BoundCertificate) -> bool {
    certificate.regions.iter().any(|region| !region.boxes.is_empty())
}

#[test]
fn accepted_certificates_prove_with_wrenches_or_without() {
    let scene = example("mpi_simulator");
    let found = accepted(&scene, 7.8388, &|_| true);
    assert!(found.length > 7.83 && counts_wrenches(&found), "{}", found.length);
    // What collisions alone prove, if no certificate with wrenches is accepted.
    let without = accepted(&scene, 7.8388, &|certificate| !counts_wrenches(certificate));
    assert!(without.length > 7.0 && without.length < 7.1, "{}", without.length);
}

#[test]
fn clearances_are_left_out_and_wrenches_count() {
    let mut spec = example("mpi_simulator").spec().clone();
    spec.clearance = Some(0.05);
    let found = accepted(&scene(spec), 8.2255, &|_| true);
    assert!(found.length > 7.5 && found.length < 7.9956 && counts_wrenches(&found), "{}", found.length);
}

/// A certificate with one region: a box, cut by a plane. It is about paths no longer than the straight line, so that nothing else matters.
fn of_one(whole: &BoundCertificate, weak: &WeakBox, plane: &[f64; 4]) -> BoundCertificate {
    let side = |axis: usize, sign: f64, end: f64| {
        let normal = Vector::ith(axis, sign);
        [normal.x, normal.y, normal.z, sign * end]
    };
    let [low, high] = weak.bounds;
    let sides = (0..3).flat_map(|axis| [side(axis, -1.0, low[axis]), side(axis, 1.0, high[axis])]);
    let half_spaces = sides.chain([*plane]).collect();
    let [from, to] = [whole.start, whole.goal].map(Vector::from);
    BoundCertificate {
        length: (to - from).norm() - 1e-5,
        regions: vec![Region { who: vec![WRENCH.to_string()], half_spaces, boxes: vec![weak.clone()] }],
        edges: Vec::new(),
        corners: Vec::new(),
        ..whole.clone()
    }
}

/// Positions of a box below a plane, from all of it and from near its corners.
fn positions(weak: &WeakBox, plane: &[f64; 4], rng: &mut ChaCha8Rng) -> Vec<Point> {
    let [low, high] = weak.bounds.map(Point::from);
    let share = |rng: &mut ChaCha8Rng| match rng.random_range(0..3) {
        0 => 1e-6,
        1 => 1.0 - 1e-6,
        _ => rng.random_range(0.0..1.0),
    };
    let place = |_| low + (high - low).component_mul(&Vector::from_fn(|_, _| share(rng)));
    let [x, y, z, offset] = *plane;
    (0..120).map(place).filter(|place| Vector::new(x, y, z).dot(&place.coords) < offset).collect()
}

/// Changes a claim, by an amount from 0, which changes nothing.
fn damaged(kind: usize, by: f64, (weak, plane): (&WeakBox, &[f64; 4]), way: &[f64; 18]) -> (WeakBox, [f64; 4]) {
    let (mut weak, mut plane) = (weak.clone(), *plane);
    let [low, high] = weak.bounds;
    let center: [f64; 3] = std::array::from_fn(|k| 0.5 * (low[k] + high[k]));
    let direction = weak.direction.as_mut().expect("a direction");
    let WeakDirection { at_center, slopes, weight } = direction;
    match kind {
        // Larger boxes, on all sides or one; moved boxes, with the direction at their own centres.
        0 | 1 => {
            for axis in 0..3 {
                let grown = by * (high[axis] - low[axis]);
                let [down, up] = if kind == 0 { [1.0, 1.0] } else { [way[axis].max(0.0), way[axis + 3].max(0.0)] };
                weak.bounds[0][axis] -= down * grown;
                weak.bounds[1][axis] += up * grown;
            }
            for (axis, slope) in slopes.iter().enumerate() {
                let moved = 0.5 * (weak.bounds[0][axis] + weak.bounds[1][axis]) - center[axis];
                (0..6).for_each(|k| at_center[k] += moved * slope[k]);
            }
        }
        2 => {
            for (axis, way) in way.iter().enumerate().take(3) {
                let moved = by * way * (high[axis] - low[axis]);
                (weak.bounds[0][axis], weak.bounds[1][axis]) = (low[axis] + moved, high[axis] + moved);
            }
        }
        // The plane outward, or turned.
        3 => plane[3] += by * Vector::from_fn(|k, _| high[k] - low[k]).norm(),
        4 => {
            let turned =
                (Vector::new(plane[0], plane[1], plane[2]) + by * Vector::new(way[0], way[1], way[2])).normalize();
            let height = Vector::new(plane[0], plane[1], plane[2]).dot(&Vector::from(center)) - plane[3];
            plane = [turned.x, turned.y, turned.z, turned.dot(&Vector::from(center)) - height];
        }
        // Other directions, changes of it, weights.
        5 => (0..6).for_each(|k| at_center[k] += by * way[k]),
        6 => slopes.as_flattened_mut().iter_mut().zip(way).for_each(|(slope, way)| *slope += by * way),
        7 => slopes.as_flattened_mut().iter_mut().for_each(|slope| *slope *= 1.0 - by),
        8 => at_center.iter_mut().chain(slopes.as_flattened_mut()).for_each(|x| *x *= 1.0 - 2.0 * by),
        _ => *weight += by * way[0].abs() * 1e3,
    }
    (weak, plane)
}

const KINDS: usize = 10;

/// Damages claims as far as they are still accepted, and tries what is claimed then; returns how many were accepted and refused.
fn tried(scene: &Scene, whole: &BoundCertificate, seed: u64, rounds: usize) -> [usize; 2] {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let measures: Vec<Measure> = measures(scene).unwrap();
    let regions = whole.regions.iter().filter(|region| !region.boxes.is_empty());
    let claims: Vec<(&WeakBox, &[f64; 4])> = regions
        .flat_map(|region| region.boxes.iter().map(|weak| (weak, region.half_spaces.last().unwrap())))
        .filter(|(weak, _)| weak.direction.is_some())
        .collect();
    assert!(!claims.is_empty(), "{}", scene.name());
    let [mut accepted, mut refused] = [0, 0];
    for round in 0..rounds {
        let claim = claims[rng.random_range(0..claims.len())];
        let way: [f64; 18] = std::array::from_fn(|_| rng.random_range(-1.0..1.0));
        let at = |by: f64| damaged(round % KINDS, by, claim, &way);
        let is_accepted = |by: f64| {
            let (weak, plane) = at(by);
            !checked(scene, &of_one(whole, &weak, &plane)).is_err_and(|error| error.starts_with("regions[0]"))
        };
        // A box above the plane or beyond the box of positions claims nothing.
        if !is_accepted(0.0) {
            continue;
        }
        let (mut least, mut most) = (0.0, 2.0);
        for _ in 0..7 {
            let by = if least == 0.0 { most / 4.0 } else { 0.5 * (least + most) };
            if is_accepted(by) {
                (least, accepted) = (by, accepted + 1);
            } else {
                (most, refused) = (by, refused + 1);
            }
        }
        let (weak, plane) = at(least);
        for place in positions(&weak, &plane, &mut rng) {
            let lacks = measures.iter().any(|measure| measure.slack(&place) < measure.floor());
            assert!(
                lacks,
                "{}: wrenches suffice at {place}, kind {}, by {least}: {weak:?}",
                scene.name(),
                round % KINDS
            );
        }
    }
    [accepted, refused]
}

/// `CDPR_VERIFY=n` makes n times as many.
#[test]
fn whatever_is_accepted_of_damaged_claims_is_true() {
    let more = std::env::var("CDPR_VERIFY").map_or(1, |n| n.parse::<usize>().expect("CDPR_VERIFY is a number"));
    let [mut accepted, mut refused] = [0, 0];
    let mut all = |scene: &Scene, enough: f64, seed: u64| {
        let found = tried(scene, &certificate(scene, enough), seed, 40 * more);
        (accepted, refused) = (accepted + found[0], refused + found[1]);
    };
    for (seed, (name, cost, gap)) in (0..).zip(EXAMPLES) {
        all(&example(name), cost / (1.0 + 2.0 * gap), seed);
    }
    // Two load cases, and the projected margins.
    let mut spec = example("mpi_simulator").spec().clone();
    let weight = 0.02 * example("mpi_simulator").robot().mass().unwrap() * 9.81;
    spec.wrench.as_mut().unwrap().loads = Some(vec![[0.0; 6], [weight, 0.0, 0.0, 0.0, 0.0, 0.0]]);
    all(&scene(spec), 7.8, 5);
    let mut spec = example("caroca").spec().clone();
    spec.wrench.as_mut().unwrap().margin = Some(MarginSpec::Projected);
    all(&scene(spec), 5.5, 6);
    for (seed, radius) in [(7, 0.02), (8, 0.1)] {
        all(&with_pulleys(&example("mpi_simulator"), radius), 7.6, seed);
    }
    assert!(accepted > 100 && refused > 400, "{accepted} {refused}");
}

/// Each box without its direction, and the tiling without a box, are refused.
#[test]
fn boxes_that_prove_nothing_are_refused() {
    let scene = example("mpi_simulator");
    let whole = certificate(&scene, 7.8);
    let region = whole.regions.iter().position(|region| !region.boxes.is_empty()).unwrap();
    let ends = [whole.start, whole.goal].map(Vector::from);
    let mut refused = 0;
    for k in (0..whole.regions[region].boxes.len()).step_by(17) {
        let weak = &whole.regions[region].boxes[k];
        let center = Vector::from_fn(|axis, _| 0.5 * (weak.bounds[0][axis] + weak.bounds[1][axis]));
        let [x, y, z, offset] = *whole.regions[region].half_spaces.last().unwrap();
        let counts = Vector::new(x, y, z).dot(&center) < offset
            && ends.iter().map(|end| (center - end).norm()).sum::<f64>() < whole.length;
        if !counts || weak.direction.is_none() {
            continue;
        }
        let mut fewer = whole.clone();
        fewer.regions[region].boxes.remove(k);
        let error = checked(&scene, &fewer).unwrap_err();
        assert!(error.starts_with(&format!("regions[{region}].boxes")), "{error}");
        let mut without = whole.clone();
        without.regions[region].boxes[k].direction = None;
        let error = checked(&scene, &without).unwrap_err();
        assert!(error.contains(&format!("regions[{region}].boxes[{k}]: found no direction")), "{error}");
        let mut negative = whole.clone();
        negative.regions[region].boxes[k].direction.as_mut().unwrap().weight = -1e6;
        assert!(checked(&scene, &negative).unwrap_err().contains("found the weight"));
        refused += 1;
    }
    // A larger region than its boxes cover.
    for side in 0..whole.regions[region].half_spaces.len() - 1 {
        let mut larger = whole.clone();
        larger.regions[region].half_spaces[side][3] += 0.5;
        let is_in_box = (0..3).all(|axis| {
            let row = larger.regions[region].half_spaces[side];
            let (normal, offset) = (row[axis], row[3]);
            normal == 0.0 || offset < if normal > 0.0 { whole.bounds[1][axis] } else { -whole.bounds[0][axis] }
        });
        if is_in_box {
            let error = checked(&scene, &larger).unwrap_err();
            assert!(error.contains("boxes: found the position"), "{error}");
        }
    }
    assert!(refused > 5, "{refused}");
}

#[test]
fn claims_about_other_scenes_are_refused() {
    let original = example("mpi_simulator");
    let whole = certificate(&original, 7.6);
    let refused = |change: &dyn Fn(&mut cdpr_core::model::SceneSpec), reason: &str| {
        let mut spec = original.spec().clone();
        change(&mut spec);
        let changed = scene(spec);
        let error = checked(&changed, &BoundCertificate { scene: changed.fingerprint(), ..whole.clone() }).unwrap_err();
        assert!(error.starts_with("regions[") && error.contains(reason), "{error}");
    };
    refused(&|spec| spec.wrench = None, "without requirements");
    refused(&|spec| spec.wrench.as_mut().unwrap().rule = Some(cdpr_core::model::RuleSpec::Grid), "grid");
    refused(&|spec| spec.wrench.as_mut().unwrap().force = Some(0.0), "too weak");
    let mut other = whole.clone();
    other.regions.iter_mut().filter(|region| !region.boxes.is_empty()).for_each(|region| region.boxes.clear());
    assert!(checked(&original, &other).unwrap_err().contains("boxes"));
    let pair = whole.regions.iter().find(|region| region.boxes.is_empty()).unwrap().who.clone();
    let mut other = whole.clone();
    other.regions.iter_mut().filter(|region| !region.boxes.is_empty()).for_each(|region| region.who = pair.clone());
    assert!(checked(&original, &other).unwrap_err().contains("who"));
}
