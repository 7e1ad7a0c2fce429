use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::compiled::engine_for;
use crate::conditions::Condition;
use crate::geometry::{Apart, Pose, Rotation};
use crate::model::{BodySpec, CableSpec, RobotSource, RobotSpec, SceneSpec};
use crate::testing::{paper_robot, paper_scene};

/// Two cables to a small platform in a room of 2 m.
fn pair(rng: &mut ChaCha8Rng) -> Scene {
    let mut at = |low: f64, high: f64| std::array::from_fn(|_| rng.random_range(low..high));
    let cable = |outlet, attachment| CableSpec { outlet, attachment, ..CableSpec::default() };
    let cables = (0..2).map(|_| cable(at(0.0, 2.0), at(-0.3, 0.3))).collect();
    let platform = vec![BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() }];
    let robot = RobotSource::Inline(RobotSpec { platform, cables, ..paper_robot() });
    Scene::new(SceneSpec { robot, query: None, ..paper_scene("pair", Vec::new()) }).unwrap()
}

/// Where the four ends of the cables lie in one plane, the cables are apart, at every pose near a piece that keeps the condition.
#[test]
fn cables_that_are_kept_apart_near_a_turn_never_cross() {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let (mut kept, mut crossed) = (0, 0);
    for round in 0..20_000 {
        let scene = pair(&mut rng);
        let engine = engine_for(&scene, Default::default(), Default::default()).unwrap();
        let conditions = engine.conditions();
        let of_pair = |condition: &&Condition| matches!(condition, Condition::CableCable(_));
        let Some(condition) = conditions.list.iter().find(of_pair) else { continue };
        let size = 0.5_f64.powi(round / 2 % 5);
        let mut any = |most: f64| Vector::from_fn(|_, _| rng.random_range(-most..most));
        let from = Pose::new(Point::new(1.0, 1.0, 1.0) + any(0.8), Rotation::from_scaled_axis(any(0.3)));
        let turn = Rotation::from_scaled_axis(any(0.8 * size));
        let to = Pose::new(from.position + any(0.2 * size), turn * from.orientation);
        let apart = if round % 2 == 0 { 0.0 } else { rng.random_range(0.0..0.3) * size };
        let motion = from.toward(&to).relative_to(scene.orientation());
        let piece = motion.whole().within(Apart { position: apart, turned: 0.0 });
        let is_kept = condition.details().kept_during_turn(&conditions.bodies, &piece);
        let [i, j] = [0, 1].map(|k| &conditions.bodies.cables[k]);
        let mut crosses = false;
        for _ in 0..10 {
            let away = Vector::from_fn(|_, _| rng.random_range(-1.0..1.0_f64)).normalize() * apart;
            let ends = |t: f64| {
                let at = motion.at(t);
                [i, j].map(|cable| at.point(&cable.arm) + away)
            };
            let volume = |t: f64| {
                let [p, q] = ends(t);
                (p - i.outlet).dot(&(j.outlet - i.outlet).cross(&(q - p)))
            };
            for k in 0..20 {
                let [mut low, mut high] = [k, k + 1].map(|k| f64::from(k) / 20.0);
                if volume(low) * volume(high) > 0.0 {
                    continue;
                }
                let sign = volume(low);
                for _ in 0..50 {
                    let middle = 0.5 * (low + high);
                    if volume(middle) * sign > 0.0 { low = middle } else { high = middle }
                }
                let [p, q] = ends(low);
                crosses |= segment_segment::closest(&i.outlet, &p, &j.outlet, &q).distance < 1e-9;
            }
        }
        assert!(!(is_kept && crosses), "round {round}");
        kept += usize::from(is_kept);
        crossed += usize::from(crosses);
    }
    assert!(kept > 500 && crossed > 500, "{kept} {crossed}");
}
