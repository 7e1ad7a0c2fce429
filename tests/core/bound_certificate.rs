//! Certificates of lower bounds: the checker accepts what is written, and nothing is proved that is not true.

use cdpr_certify::check_bound;
use cdpr_core::Scene;
use cdpr_core::certificate::BoundCertificate;
use cdpr_core::collision::{Engine, Interference};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::Point;
use cdpr_core::limits::QUICK_BOUND_EFFORT;
use cdpr_core::lower_bound::Forbidden;
use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::planning::Status;
use cdpr_core::testing::{empty, hard1, hard3};
use cdpr_core::watch::Watch;
use rayon::prelude::*;

use crate::anytime::random_scenes;

fn certificate(scene: &Scene, enough: f64) -> BoundCertificate {
    let engine = engine_for(scene, Engine::default(), Interference::Exact).unwrap();
    let ends: [Point; 2] = [scene.start().unwrap(), scene.goal().unwrap()];
    let forbidden = Forbidden::new(&*engine, ends.each_ref(), &Watch::NONE).unwrap();
    forbidden.certificate(scene, enough, QUICK_BOUND_EFFORT, &Watch::NONE).unwrap().expect("some bound")
}

/// The length that the checker accepts as proved.
fn checked(scene: &Scene, certificate: &BoundCertificate) -> f64 {
    let text = serde_json::to_string(certificate).unwrap();
    check_bound(scene, &text, &Watch::NONE).unwrap_or_else(|error| panic!("{error}: {text:.400}")).length
}

fn shortest(scene: &Scene, seeds: u64) -> f64 {
    let found =
        (0..seeds).map(|seed| plan(scene, &PlanOptions { seed, ..PlanOptions::default() }, &()).unwrap().result);
    found.filter(|found| found.status == Status::Solved).map(|found| found.cost).fold(f64::INFINITY, f64::min)
}

#[test]
fn a_thousandth_is_certified_on_the_scenes_of_the_paper() {
    for (scene, cost) in [(hard1(), 2.435167), (hard3(), 2.656138)] {
        let certificate = certificate(&scene, cost / 1.001);
        assert_eq!(checked(&scene, &certificate), cost / 1.001);
    }
}

#[test]
fn without_obstacles_the_straight_line_is_certified() {
    let scene = empty();
    let straight = (scene.goal().unwrap() - scene.start().unwrap()).norm();
    let proved = checked(&scene, &certificate(&scene, 2.0 * straight));
    assert!(proved <= straight && proved > straight - 1e-5, "{proved}");
}

#[test]
fn certificates_fall_back_to_the_straight_line() {
    let scene = hard1();
    let engine = engine_for(&scene, Engine::default(), Interference::Exact).unwrap();
    let ends: [Point; 2] = [scene.start().unwrap(), scene.goal().unwrap()];
    let forbidden = Forbidden::new(&*engine, ends.each_ref(), &Watch::NONE).unwrap();
    let accepted = |watch: &Watch, most: f64| {
        let accepts = |certificate: &BoundCertificate, _: &Watch| {
            certificate.length <= most && checked(&scene, certificate) > 0.0
        };
        forbidden.accepted_certificate(&scene, 2.41, &accepts, watch).unwrap().map(|certificate| certificate.length)
    };
    let straight = (ends[1] - ends[0]).norm();
    assert_eq!(accepted(&Watch::NONE, 2.5), Some(2.41));
    let less = accepted(&Watch::NONE, 2.4).unwrap();
    assert!(less > straight && less <= 2.4, "{less}");
    let least = accepted(&Watch::NONE, straight).unwrap();
    assert!(least < straight && least > straight - 1e-6, "{least}");
    assert_eq!(accepted(&Watch::NONE.with_budget(Some(std::time::Duration::ZERO)), 2.5), Some(least));
    assert_eq!(accepted(&Watch::NONE, 1.0), None);
}

#[test]
fn random_scenes_are_certified_and_never_beyond_a_path() {
    let all: Vec<(u64, f64, f64)> = (0..48u64)
        .into_par_iter()
        .filter_map(|seed| {
            let scene = random_scenes([1, 3, 3, 6][seed as usize % 4]).draw(900 + seed).unwrap();
            let cost = shortest(&scene, 4);
            if cost.is_infinite() {
                return None;
            }
            // First more than is true is requested, then a hundredth less than the best path.
            let beyond = checked(&scene, &certificate(&scene, 1.02 * cost));
            assert!(beyond <= cost + 1e-6, "{seed}: {beyond} certified, a path has {cost}");
            Some((seed, cost, checked(&scene, &certificate(&scene, cost / 1.01))))
        })
        .collect();
    let proved = all.iter().filter(|(_, cost, proved)| *proved >= cost / 1.01).count();
    assert!(all.len() > 30 && 10 * proved >= 9 * all.len(), "{proved} of {}", all.len());
}
