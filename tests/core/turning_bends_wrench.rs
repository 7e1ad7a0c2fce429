//! Bends on which the platform turns, in scenes that require wrenches: the cables provide them at every pose.

use cdpr_tests::compiled;
use std::sync::atomic::{AtomicUsize, Ordering};

use cdpr_core::geometry::{Pose, Vector, wxyz};
use cdpr_core::model::spec::{MarginSpec, MotionSpec, RobotSource, RuleSpec, WrenchSpec};
use cdpr_core::model::{Scene, SceneSpec};
use cdpr_core::testing::empty;
use cdpr_core::trajectory::Trajectory;
use cdpr_core::trajectory::turning_bend::TurningBend;
use cdpr_core::trajectory::turning_corners::TurningSpace;
use cdpr_core::trajectory_check::Recorded;
use cdpr_core::watch::Watch;
use cdpr_core::wrench::{Balance, FeasibilityLp, Measure, Required, measures, required};
use cdpr_tests::built_scene;
use nalgebra::{Matrix6xX, Vector6};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use super::turning_bends::{random_bend, stops};
use super::turning_motions::{FREE, at, check, excess, file, motion};

fn with_wrench(scene: &Scene, wrench: WrenchSpec) -> Scene {
    Scene::new(SceneSpec { wrench: Some(wrench), ..scene.spec().clone() }).unwrap()
}

/// A robot alone in its workspace, with other tension limits, N, and another mass, kg.
fn alone(name: &str, tension: [f64; 2], mass: f64) -> Scene {
    let mut spec = built_scene(name).spec().clone();
    spec.obstacles.clear();
    let RobotSource::Inline(robot) = &mut spec.robot else { panic!("the robot is part of the scene") };
    robot.mass = Some(mass);
    robot.cables.iter_mut().for_each(|cable| cable.tension = Some(tension));
    without_wrench(&Scene::new(spec).unwrap())
}

fn without_wrench(scene: &Scene) -> Scene {
    Scene::new(SceneSpec { wrench: None, ..scene.spec().clone() }).unwrap()
}

fn balls(force: f64, moment: f64, margin: MarginSpec) -> WrenchSpec {
    WrenchSpec { force: Some(force), moment: Some(moment), margin: Some(margin), ..WrenchSpec::default() }
}

/// The scene at the orientation of a pose.
fn turned(scene: &Scene, pose: &Pose) -> Scene {
    scene.turned(wxyz(&pose.orientation).into()).unwrap()
}

/// How much more than required the cables can exert at a pose, N or N·m, by definition at its own orientation.
fn slack(scene: &Scene, pose: &Pose) -> f64 {
    let measures = measures(&turned(scene, pose)).unwrap();
    let slacks = measures.iter().map(|measure| measure.limit(&pose.position).map_or(f64::NAN, |limit| limit.margin));
    slacks.fold(f64::INFINITY, |least, slack| if slack < least || slack.is_nan() { slack } else { least })
}

/// Whether linear programs find tensions for the required wrenches at a pose that are hardest to exert, and for some others.
fn provided(scene: &Scene, pose: &Pose, rng: &mut ChaCha8Rng) -> bool {
    let (there, mut lp) = (turned(scene, pose), FeasibilityLp::new());
    let required = required(scene.wrench().unwrap()).unwrap();
    measures(&there).unwrap().iter().all(|measure| {
        let (statics, hardest) = (measure.statics(), measure.limit(&pose.position).unwrap().normal);
        let rows = match measure {
            Measure::Capacity(_) => Vector6::repeat(1.0),
            Measure::Force(..) => Vector6::new(1.0, 1.0, 1.0, 0.0, 0.0, 0.0),
            Measure::Moment(..) => Vector6::new(0.0, 0.0, 0.0, 1.0, 1.0, 1.0),
        };
        let columns: Vec<_> = statics.columns(&pose.position).unwrap().iter().map(|w| w.component_mul(&rows)).collect();
        let limits: Vec<[f64; 2]> = statics.cables().iter().map(|cable| cable.tension).collect();
        let some = (0..6).map(|_| Vector6::from_fn(|_, _| rng.random_range(-1.0..1.0)));
        std::iter::once(hardest).chain(some).all(|c| {
            // A millionth less, since the programs have tolerances.
            let wrench = statics.balance() + farthest(&required, &c, statics.characteristic_length()) * (1.0 - 1e-6);
            let found = lp.solve(&Matrix6xX::from_columns(&columns), &limits, &wrench.component_mul(&rows)).unwrap();
            matches!(found, Balance::Feasible(_))
        })
    })
}

/// The required wrench that is farthest in a direction, [force; moment / ℓ].
fn farthest(required: &Required, c: &Vector6<f64>, length: f64) -> Vector6<f64> {
    let scaled = |w: &Vector6<f64>| Vector6::new(w[0], w[1], w[2], w[3] / length, w[4] / length, w[5] / length);
    match required {
        Required::Balls { force, moment } => {
            let part = |row: usize, radius: f64| {
                let part = Vector::from(c.fixed_rows::<3>(row));
                part.try_normalize(1e-12).map_or(part * 0.0, |unit| unit * radius)
            };
            let (f, m) = (part(0, *force), part(3, *moment / length));
            Vector6::new(f.x, f.y, f.z, m.x, m.y, m.z)
        }
        Required::Polytope(corners) => {
            corners.iter().map(scaled).max_by(|a, b| a.dot(c).total_cmp(&b.dot(c))).expect("corners")
        }
    }
}

/// Numbers of decisions about random bends.
#[derive(Debug, Default)]
struct Tally {
    accepted: AtomicUsize,
    refused: AtomicUsize,
    /// Accepted with slack below a thousandth of the largest tension.
    close: AtomicUsize,
    /// Accepted with less slack inside than at either end.
    inside: AtomicUsize,
    /// Refused because of wrenches with slack above a thousandth everywhere.
    wrongly: AtomicUsize,
}

const POSES: u32 = 200;

impl Tally {
    /// Decides about a bend and walks along it.
    fn judge(&self, scene: &Scene, bend: &TurningBend, rng: &mut ChaCha8Rng, name: &str) -> bool {
        let add = |counter: &AtomicUsize, counts: bool| counter.fetch_add(usize::from(counts), Ordering::Relaxed);
        let allowed = TurningSpace::of(scene, &Watch::NONE).unwrap().unwrap().allows(bend);
        let poses: Vec<Pose> =
            (0..=POSES).map(|k| bend.pose(bend.length() * f64::from(k) / f64::from(POSES))).collect();
        let slacks: Vec<f64> = poses.iter().map(|pose| slack(scene, pose)).collect();
        let (worst, least) = slacks.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1)).unwrap();
        let told = || format!("{name}: {least} N at {worst} of {POSES}, {:?}, {bend:?}", scene.wrench());
        assert!(!allowed || slacks.iter().all(|slack| *slack >= 0.0), "{}", told());
        assert!(!allowed || provided(scene, &poses[worst], rng), "no tensions, {}", told());
        let share = least / scene.robot().cables()[0].tension.unwrap()[1];
        add(&self.accepted, allowed);
        add(&self.refused, !allowed);
        add(&self.close, allowed && share < 1e-3);
        add(&self.inside, allowed && *least < slacks[0].min(slacks[POSES as usize]) - 1e-9);
        let free = || TurningSpace::of(&without_wrench(scene), &Watch::NONE).unwrap().unwrap().allows(bend);
        add(&self.wrongly, !allowed && share > 1e-3 && free());
        allowed
    }
}

/// A scene with the place and the turns of its bends, and its requirement as a function of its size, N.
type Case = (&'static str, Scene, [f64; 3], [f64; 2], fn(f64) -> WrenchSpec);

fn cases() -> Vec<Case> {
    let capacity: fn(f64) -> WrenchSpec = |size| balls(size, 0.2 * size, MarginSpec::Capacity);
    let projected: fn(f64) -> WrenchSpec = |size| balls(size, 0.1 * size, MarginSpec::Projected);
    let polytope: fn(f64) -> WrenchSpec = |size| {
        let corner = |k: usize| std::array::from_fn(|row| if row == k % 6 { size * [1.0, -0.4][k / 6] } else { 0.0 });
        let load = Some([10.0, -20.0, -30.0, 2.0, 3.0, -1.0]);
        let characteristic_length = Some(0.5);
        WrenchSpec {
            vertices: Some((0..12).map(corner).collect()),
            load,
            characteristic_length,
            ..WrenchSpec::default()
        }
    };
    let place = [0.0, 0.0, 2.2];
    vec![
        ("as built", alone("cogiro", [100.0, 5000.0], 91.0), place, [0.2, 1.0], capacity),
        ("heavy", alone("cogiro", [50.0, 5000.0], 900.0), place, [0.1, 0.6], capacity),
        ("narrow", alone("cogiro", [200.0, 700.0], 120.0), place, [0.05, 0.5], capacity),
        ("polytope", alone("cogiro", [100.0, 5000.0], 91.0), place, [0.2, 1.0], polytope),
        ("projected", alone("cogiro", [100.0, 5000.0], 91.0), place, [0.2, 1.0], projected),
        ("small", alone("ipanema2", [5.0, 200.0], 10.0), [0.0, 0.0, 2.5], [0.2, 1.5], capacity),
    ]
}

#[test]
fn accepted_bends_keep_required_wrenches_everywhere() {
    let count = std::env::var("RANDOM_BENDS").map_or(90, |count| count.parse().unwrap());
    let cases = cases();
    let tallies: Vec<Tally> = cases.iter().map(|_| Tally::default()).collect();
    (0..count).into_par_iter().for_each(|seed| {
        let case = seed as usize % cases.len();
        let (name, scene, place, turns, wrench) = &cases[case];
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let bend = random_bend(&mut rng, (*place).into(), *turns);
        let named = format!("{name} {seed}");
        let mut judge = |size: f64| tallies[case].judge(&with_wrench(scene, wrench(size)), &bend, &mut rng, &named);
        if !judge(1e-3) {
            return;
        }
        // The largest requirement that is proved.
        let [mut proved, mut refused] = [1e-3, 2.0 * scene.robot().cables()[0].tension.unwrap()[1]];
        for _ in 0..14 {
            let size = 0.5 * (proved + refused);
            if judge(size) { proved = size } else { refused = size }
        }
    });
    for ((name, ..), tally) in cases.iter().zip(tallies) {
        println!("{name}: {tally:?}");
        let Tally { accepted, refused, close, inside, wrongly } = tally;
        let [accepted, refused, close, inside, wrongly] =
            [accepted, refused, close, inside, wrongly].map(AtomicUsize::into_inner);
        assert!(accepted > 20 && refused > 20 && close > 5 && inside > 3 && wrongly <= refused / 100, "{name}");
    }
}

/// A way of CoGiRo with four turns, one of them on the spot.
fn way() -> [Pose; 6] {
    [
        at([-2.0, -1.0, 1.5], 0.0),
        at([-1.0, -1.0, 1.5], 0.0),
        at([0.2, 0.0, 2.0], 0.2),
        at([0.2, 0.0, 2.0], 0.1),
        at([1.0, 0.5, 2.0], 0.1),
        at([1.6, 0.5, 2.2], -0.1),
    ]
}

#[test]
fn cogiro_passes_the_ends_of_its_turns_with_required_wrenches() {
    for margin in [MarginSpec::Capacity, MarginSpec::Projected] {
        let scene = with_wrench(&alone("cogiro", [100.0, 5000.0], 91.0), balls(150.0, 30.0, margin));
        let [stopping, found] =
            [0.0, 0.1].map(|blend| motion(&scene, &way(), &MotionSpec { blend: Some(blend), ..FREE }));
        println!(
            "{margin:?}: {} stops, {} s; {} stops, {} s",
            stops(&stopping),
            stopping.duration(),
            stops(&found),
            found.duration()
        );
        assert!(stops(&stopping) == 4 && stops(&found) == 0 && found.duration() < 0.8 * stopping.duration());
        assert!(excess(&scene, &found, 2_000) <= 1e-9);
        let mut times = (0..=1000).map(|k| found.duration() * f64::from(k) / 1000.0);
        assert!(times.all(|time| {
            let now = found.at(time);
            slack(&scene, &Pose::new(now.position, now.orientation)) >= 0.0
        }));
        let file = file(&scene, &way(), &found, 100.0);
        let recorded = Recorded::of(&file).unwrap();
        let report = check(&scene, &recorded, &MotionSpec { blend: Some(0.1), ..FREE });
        assert!(report.valid && report.exact, "{:?}", report.faults);
    }
}

#[test]
fn no_turning_bends_under_the_grid_rule_or_for_point_masses() {
    let scene = alone("cogiro", [100.0, 5000.0], 91.0);
    let grid = WrenchSpec { rule: Some(RuleSpec::Grid), grid: Some(0.5), ..WrenchSpec::default() };
    let cells = with_wrench(&scene, grid);
    assert!(TurningSpace::of(&cells, &Watch::NONE).unwrap().is_none());
    // Not even lines on which the platform turns can be judged by cells.
    let limits = MotionSpec { blend: Some(0.1), ..FREE };
    let refused = Trajectory::new(&compiled(&cells), &way(), &limits, &Watch::NONE).unwrap_err().to_string();
    assert!(refused.contains("wrench.rule") && refused.contains("expected \"certified\" if the platform turns"));
    let mut spec = empty().spec().clone();
    let RobotSource::Inline(robot) = &mut spec.robot else { panic!("the robot is part of the scene") };
    robot.cables.drain(..4); // the lower ones
    robot.cables.iter_mut().for_each(|cable| cable.attachment = [0.0, 0.0, 0.025]);
    robot.center_of_mass = Some([0.0, 0.0, 0.025]);
    let point = with_wrench(&Scene::new(spec).unwrap(), WrenchSpec::default());
    assert!(TurningSpace::of(&point, &Watch::NONE).unwrap().is_none());
    let turn = [at([1.0; 3], 0.0), at([1.2, 1.0, 1.0], 0.0), at([1.2, 1.2, 1.0], 0.2)];
    assert_eq!(stops(&motion(&point, &turn, &limits)), 1);
}
