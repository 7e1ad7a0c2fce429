//! The gjk engine on whole scenes against slow exact tests that share no code with it, see `cdpr_tests::scenes`.

use cdpr_core::collision::{Checker, GjkEngine, Interference, Validity};
use cdpr_core::geometry::Point;
use cdpr_core::tolerances::GAP_TOLERANCE;
use cdpr_tests::scenes::{Kind, Oracle, Verdict, scene};
use cdpr_tests::{direction, effort, rng, uniform, vector};
use rand::RngExt;

#[test]
fn states_and_motions_agree_with_exact_tests() {
    let mut rng = rng(7);
    let (many, mut count) = (effort() as usize, [0; 3]);
    for case in 0..1_334 * many {
        let scene = scene(&mut rng, Kind::default());
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
    assert!(count[0] > 6_667 * many && count[1] > 1_667 * many);
}

#[test]
fn motion_clearance_is_that_of_its_nearest_state() {
    const SAMPLES: usize = 200;
    let mut rng = rng(8);
    let (mut near, mut far) = (0, 0);
    for case in 0..1_500 {
        let clearance = [0.0, 0.001, 0.05][case % 3];
        let diameter = [0.0, 0.01][case % 2];
        let scene = scene(&mut rng, Kind { clearance, diameter, ..Kind::default() });
        let engine = GjkEngine::new(&scene, Interference::Exact).unwrap();
        let exempt = !engine.conditions().exempt.is_empty();
        for _ in 0..4 {
            let p = Point::from(vector(&mut rng, 2.5));
            let q = p + direction(&mut rng) * 10f64.powf(uniform(&mut rng, -3.0, 0.0));
            let Some(found) = engine.clearance(&p, &q) else { continue };
            if found.value < -0.5 * diameter {
                continue; // overlap: the depth of the swept bodies differs from that of a state
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
                assert!(!kept || exempt, "case {case}: allowed although nearer than {clearance}: {found:?}");
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
