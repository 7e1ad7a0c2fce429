//! Facets of available wrenches that limit the demands of a motion: by the kernel, and by their definition.

use cdpr_core::geometry::{Point, Vector};
use cdpr_core::wrench::{Demand, DemandFacets, Statics};
use cdpr_tests::built_scene;
use nalgebra::Vector6;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

#[test]
fn kernel_facets_limit_demands_like_the_definition() {
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    for name in ["cogiro", "ipanema2", "acrobot"] {
        let statics = Statics::of(&built_scene(name)).unwrap();
        let kernel = DemandFacets::new(statics.clone(), 3.0);
        let defined = kernel.clone().by_definition();
        let demands = demands(&statics, &mut rng, [f64::INFINITY; 2]);
        let least = |facets: &DemandFacets| {
            let mut least = vec![[f64::INFINITY; 2]; demands.len()];
            let lacking = facets.for_each(&demands, None, |k, facet| {
                for side in 0..2 {
                    let height = if side == 0 { facet.heights[0] } else { -facet.heights[0] };
                    least[k][0] = least[k][0].min((facet.slack[side] - height) / facet.norm);
                    least[k][1] = least[k][1].min((facet.slack[side] + facet.heights[1].abs()) / facet.norm);
                }
            });
            (least, lacking)
        };
        let ((by_kernel, lacking), (by_definition, lacking_defined)) = (least(&kernel), least(&defined));
        assert_eq!(lacking, lacking_defined);
        for (a, b) in by_kernel.iter().flatten().zip(by_definition.iter().flatten()) {
            assert!((a - b).abs() <= 1e-7 * (1.0 + b.abs()), "{name}: {a} {b}");
        }
    }
}

/// Demands at positions between the outlets of a robot, at most so large.
fn demands(statics: &Statics, rng: &mut ChaCha8Rng, most: [f64; 2]) -> Vec<Demand> {
    let mut within = |least: f64, most: f64| rng.random_range(least..most);
    let demand = |_| {
        let weights: Vec<f64> = statics.cables().iter().map(|_| within(0.1, 1.0)).collect();
        let parts = statics.cables().iter().zip(&weights).map(|(cable, w)| cable.outlet.coords * *w);
        let at = parts.sum::<Vector>() / weights.iter().sum::<f64>() - Vector::z();
        let wrenches = [100.0, 10.0].map(|size| Vector6::from_fn(|_, _| within(-size, size)));
        Demand { position: Point::from(at), wrenches, most }
    };
    (0..203).map(demand).collect()
}

#[test]
fn omitted_facets_are_beyond_the_demands() {
    let mut rng = ChaCha8Rng::seed_from_u64(8);
    let most = [3.0, 2.0];
    for name in ["cogiro", "ipanema2"] {
        let statics = Statics::of(&built_scene(name)).unwrap();
        let near = demands(&statics, &mut rng, most);
        let all: Vec<Demand> = near.iter().map(|demand| Demand { most: [f64::INFINITY; 2], ..*demand }).collect();
        let facets = DemandFacets::new(statics, 3.0);
        // How many facets are visited, and how far each demand reaches beyond each side.
        let reached = |demands: &[Demand]| {
            let (mut visited, mut beyond) = (0, vec![Vec::new(); demands.len()]);
            let lacking = facets.for_each(demands, None, |k, facet| {
                visited += 1;
                for (sign, slack) in [1.0, -1.0].into_iter().zip(facet.slack) {
                    let [a, b] = facet.heights.map(|height| sign * height);
                    let over = a.abs() * most[0] + b.max(0.0) * most[1] - slack;
                    beyond[k].extend((over > 0.0).then_some(over));
                }
            });
            (visited, beyond, lacking)
        };
        let (few, all) = (reached(&near), reached(&all));
        assert_eq!((few.1, few.2), (all.1, all.2));
        assert!(few.0 < all.0, "{name}: {} of {} facets", few.0, all.0);
    }
}

#[test]
fn shares_by_the_kernel_are_those_of_all_facets() {
    let mut rng = ChaCha8Rng::seed_from_u64(9);
    let mut held = 0;
    for name in ["cogiro", "ipanema2", "acrobot"] {
        let statics = Statics::of(&built_scene(name)).unwrap();
        let kernel = DemandFacets::new(statics.clone(), 3.0);
        for demand in demands(&statics, &mut rng, [f64::INFINITY; 2]) {
            let (mut share, mut slack) = ([0.0_f64; 2], [f64::INFINITY; 2]);
            let lacking = kernel.clone().by_definition().for_each(&[demand], None, |_, facet| {
                for (side, k) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                    let height = if side == 0 { facet.heights[k] } else { -facet.heights[k] };
                    share[k] = share[k].max(height / facet.slack[side]);
                    slack[k] = slack[k].min((facet.slack[side] - height) / facet.norm);
                }
            });
            let found = kernel.shares(&[demand], None);
            assert_eq!(found, kernel.clone().portable().shares(&[demand], None));
            assert_eq!(found.as_ref().err(), lacking.as_ref());
            let Ok(found) = found else { continue };
            held += 1;
            for (found, (share, slack)) in found[0].iter().zip(share.into_iter().zip(slack)) {
                assert!((found.share - share).abs() <= 1e-7 * (1.0 + share.abs()), "{name}: {found:?} {share}");
                assert!((found.slack - slack).abs() <= 1e-7 * (1.0 + slack.abs()), "{name}: {found:?} {slack}");
            }
        }
    }
    assert!(held > 50, "{held} demands");
}
