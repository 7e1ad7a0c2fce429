//! Wrenches of robots whose cables run round pulleys, and whose outlets are known only up to an error: against robots with fixed
//! outlets at the exits, against outlets within the error, and timed motions against differences.

use cdpr_core::Robot;
use cdpr_core::geometry::{Cuboid, Point, Pose, Rotation, Vector};
use cdpr_core::kinematics::{cable_lengths, wrench_matrix};
use cdpr_core::model::spec::{MotionSpec, PulleySpec, RobotSource, RobotSpec, SceneSpec, WrenchSpec};
use cdpr_core::model::{Cable, MarginSpec, Scene};
use cdpr_core::path::held;
use cdpr_core::trajectory::{Trajectory, Winches};
use cdpr_core::turning::TurningWrench;
use cdpr_core::watch::Watch;
use cdpr_core::wrench::{
    CapacityMargin, Demand, DemandFacets, Loads, Measure, Origin, Required, Statics, TensionQp, capacity_limit,
    certified, first_failure, force_limit, least_slack, moment_limit, slack_reaches,
};
use cdpr_tests::{built_robot, built_scene, compiled, direction, effort, rng};
use nalgebra::Vector6;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

type Box3 = [[f64; 2]; 3];

/// Existing robots with a box of positions and balls that leave slack.
const ROBOTS: [(&str, [f64; 2], Box3); 4] = [
    ("cogiro", [50.0, 10.0], [[-6.5, 6.5], [-5.0, 5.0], [0.5, 4.0]]),
    ("ipanema2", [5.0, 1.0], [[-3.5, 3.5], [-2.5, 2.5], [0.8, 4.5]]),
    ("caroca", [20.0, 5.0], [[-1.0, 1.0], [-2.5, 2.5], [0.3, 2.5]]),
    ("mpi_simulator", [200.0, 50.0], [[2.0, 10.0], [2.0, 13.0], [1.0, 7.0]]),
];

/// A robot with pulleys of up to this radius, m, and errors of outlets. Most cables arrive from below, some from anywhere.
fn changed(name: &str, radius: f64, error: f64, rng: &mut ChaCha8Rng) -> Robot {
    changed_spec(built_robot(name).spec().clone(), radius, error, rng).try_into().unwrap()
}

fn changed_spec(mut spec: RobotSpec, radius: f64, error: f64, rng: &mut ChaCha8Rng) -> RobotSpec {
    for cable in &mut spec.cables {
        cable.outlet_error = (error > 0.0).then_some(error);
        if radius > 0.0 {
            let axis = if rng.random_bool(0.8) { Vector::z() } else { direction(rng) };
            cable.pulley = Some(PulleySpec { radius: radius * rng.random_range(0.2..1.0), axis: axis.into() });
        }
    }
    spec
}

/// The same robot with other outlets, without errors; with pulleys only if asked.
fn with_outlets(robot: &Robot, outlets: &[Point], pulleys: bool) -> Robot {
    let mut spec = robot.spec().clone();
    for (cable, outlet) in spec.cables.iter_mut().zip(outlets) {
        (cable.outlet, cable.outlet_error) = ((*outlet).into(), None);
        if !pulleys {
            cable.pulley = None;
        }
    }
    spec.try_into().unwrap()
}

/// Outlets within the error, on the surface of the ball or anywhere in it.
fn true_outlets(robot: &Robot, rng: &mut ChaCha8Rng) -> Vec<Point> {
    let share = if rng.random_bool(0.7) { 1.0 } else { rng.random_range(0.0..1.0) };
    robot.cables().iter().map(|cable| cable.outlet + direction(rng) * cable.outlet_error * share).collect()
}

fn statics(robot: &Robot) -> Statics {
    Statics::new(robot, &Loads::default()).unwrap()
}

fn capacity(robot: &Robot, [force, moment]: [f64; 2]) -> Measure {
    Measure::Capacity(Box::new(CapacityMargin::new(statics(robot), Required::balls(force, moment).unwrap()).unwrap()))
}

fn within(rng: &mut ChaCha8Rng, box_: &Box3) -> Point {
    Point::from(box_.map(|[low, high]| rng.random_range(low..high)))
}

#[test]
fn wrench_margins_are_those_of_cables_from_their_exits() {
    let mut rng = rng(31);
    for (name, balls, box_) in ROBOTS {
        let mut compared = 0;
        for _ in 0..60 * effort() {
            let robot = changed(name, 0.3, 0.0, &mut rng);
            let at = within(&mut rng, &box_);
            let exits: Option<Vec<Point>> = (robot.cables().iter())
                .map(|cable| cable.departure(&(at + cable.attachment.coords)).map(|found| found.exit))
                .collect();
            let own = statics(&robot);
            let Some(exits) = exits else {
                assert!(own.columns(&at).is_none() && capacity(&robot, balls).slack(&at).is_nan());
                continue;
            };
            let fixed = with_outlets(&robot, &exits, false);
            let [a, b] = [&robot, &fixed].map(|robot| capacity(robot, balls));
            let scale = own.largest_tension();
            let near = |a: f64, b: f64| assert!((a - b).abs() <= 1e-9 * scale, "{name} at {at}: {a} {b}");
            near(a.slack(&at), b.slack(&at));
            near(a.limit(&at).unwrap().margin, b.limit(&at).unwrap().margin);
            near(a.slack_at_four(&[Point::origin(), at, at, at])[2], b.slack(&at));
            let other = statics(&fixed);
            near(force_limit(&own, &at).unwrap().margin, force_limit(&other, &at).unwrap().margin);
            near(moment_limit(&own, &at).unwrap().margin, moment_limit(&other, &at).unwrap().margin);
            let matrix = wrench_matrix(&robot, &Rotation::identity(), &at).unwrap();
            for (column, right) in own.columns(&at).unwrap().iter().zip(matrix.column_iter()) {
                assert!((column - right).norm() < 1e-15);
            }
            assert_eq!(own.lengths(&at), cable_lengths(&robot, &Rotation::identity(), &at));
            compared += 1;
        }
        assert!(compared > 30, "{compared}");
    }
}

#[test]
fn wrench_margins_hold_for_all_outlets_within_their_errors() {
    let mut rng = rng(32);
    for (name, balls, box_) in ROBOTS {
        for (radius, error) in [(0.0, 0.005), (0.0, 0.1), (0.1, 0.02)] {
            let (mut shares, mut bounded) = (Vec::new(), 0);
            for _ in 0..30 * effort() {
                let (robot, at) = (changed(name, radius, error, &mut rng), within(&mut rng, &box_));
                let own = statics(&robot);
                let required = Required::balls(balls[0], balls[1]).unwrap();
                let nominal: Vec<Point> = robot.cables().iter().map(|cable| cable.outlet).collect();
                let exact = statics(&with_outlets(&robot, &nominal, true));
                let margins = |statics: &Statics| {
                    let capacity = capacity_limit(statics, &required, &at)?.margin;
                    Some([capacity, force_limit(statics, &at)?.margin, moment_limit(statics, &at)?.margin])
                };
                let (Some(least), Some(given)) = (margins(&own), margins(&exact)) else { continue };
                let mut found = [f64::INFINITY; 3];
                // Where each outlet reduces what its cable adds in the limiting direction, and anywhere.
                let normal = capacity_limit(&own, &required, &at).expect("a limit").normal;
                let worst = |cable: &Cable| {
                    let arm = cable.attachment.coords;
                    let pull = cable.departure(&(at + arm)).expect("a direction").pull;
                    let turned = normal.fixed_rows::<3>(3) / own.characteristic_length();
                    let weight = normal.fixed_rows::<3>(0) + turned.cross(&arm);
                    cable.outlet - (weight - pull * pull.dot(&weight)).normalize() * cable.outlet_error
                };
                let worst: Vec<Point> = robot.cables().iter().map(worst).collect();
                for k in 0..40 {
                    let outlets = if k == 0 { worst.clone() } else { true_outlets(&robot, &mut rng) };
                    let real = statics(&with_outlets(&robot, &outlets, true));
                    let real = margins(&real).expect("a direction at every outlet");
                    found = std::array::from_fn(|k| found[k].min(real[k]));
                }
                for k in 0..3 {
                    if least[k] >= 0.0 || k > 0 {
                        assert!(found[k] >= least[k] - 1e-9 * own.largest_tension(), "{name}: {found:?} {least:?}");
                        bounded += 1;
                    }
                }
                if least[0] >= 0.0 {
                    shares.push((given[0] - found[0]) / (given[0] - least[0]));
                }
            }
            shares.sort_by(f64::total_cmp);
            if let (Some(loosest), Some(tightest)) = (shares.first(), shares.last()) {
                let median = shares[shares.len() / 2];
                println!(
                    "{name} {radius} m {error} m: of the bound {loosest:.2} to {tightest:.2} used, median {median:.2}"
                );
            }
            assert!(bounded > 40, "{name}: {bounded}");
        }
    }
}

/// The smallest slack at points of a motion, each with other outlets within the errors.
fn sampled(robot: &Robot, balls: [f64; 2], [from, to]: [&Point; 2], points: usize, rng: &mut ChaCha8Rng) -> f64 {
    let errors = robot.cables().iter().any(|cable| cable.outlet_error > 0.0);
    let sets = if errors { 6 } else { 1 };
    let mut least = f64::INFINITY;
    for _ in 0..sets {
        let measure = capacity(&with_outlets(robot, &true_outlets(robot, rng), true), balls);
        for four in 0..points / sets / 4 {
            let place = |k: usize| from + (to - from) * ((4 * four + k) as f64 / (points / sets - 1) as f64);
            for slack in measure.slack_at_four(&std::array::from_fn(place)) {
                least = if slack < least || slack.is_nan() { slack } else { least };
            }
        }
    }
    least
}

#[test]
fn certified_wrench_motions_hold_round_pulleys_and_at_all_outlets() {
    let mut rng = rng(33);
    for (name, balls, box_) in ROBOTS {
        for (radius, error) in [(0.1, 0.0), (0.0, 0.02), (0.1, 0.01), (0.5, 0.0)] {
            let (mut accepted, mut refused, mut possible) = (0, 0, 0);
            for tried in 0..150 * effort() as usize {
                let robot = changed(name, radius, error, &mut rng);
                let measure = capacity(&robot, balls);
                let from = within(&mut rng, &box_);
                let to = from + direction(&mut rng) * [0.1, 0.5, 2.0][tried % 3];
                let holds = certified(&measure, &from, &to);
                let least = sampled(&robot, balls, [&from, &to], 240, &mut rng);
                if holds {
                    accepted += 1;
                    assert!(least >= 0.0, "{name} {radius} {error}: {least} between {from} and {to}");
                } else {
                    refused += 1;
                    possible += usize::from(least >= 0.0);
                }
            }
            println!(
                "{name} {radius} m {error} m: {accepted} accepted, {refused} refused, {possible} of them without need"
            );
            assert!(accepted >= 5, "{name} {radius} {error}: {accepted} accepted, {refused} refused");
        }
    }
}

/// The largest slack that is proved along a motion is at most the smallest sampled one, and near to it.
#[test]
fn slack_proved_round_pulleys_is_there_and_no_more() {
    let mut rng = rng(39);
    let mut missed = Vec::new();
    for (name, balls, box_) in ROBOTS {
        for (radius, error) in [(0.03, 0.0), (0.5, 0.0), (0.1, 0.01)] {
            for tried in 0..48 * effort() as usize {
                let robot = changed(name, radius, error, &mut rng);
                let measure = capacity(&robot, balls);
                let from = within(&mut rng, &box_);
                let to = from + direction(&mut rng) * [0.1, 0.5, 2.0][tried % 3];
                if !slack_reaches(&measure, &from, &to, 0.0) {
                    continue;
                }
                let scale = measure.statics().largest_tension();
                let (mut proved, mut open) = (0.0, scale);
                while open - proved > 1e-9 * scale {
                    let middle = 0.5 * (proved + open);
                    let reached = slack_reaches(&measure, &from, &to, middle);
                    *(if reached { &mut proved } else { &mut open }) = middle;
                }
                // Slack at the given outlets counts what errors of outlets take off.
                let places = (0..=2000).map(|k| from + (to - from) * (f64::from(k) / 2000.0));
                let least = places.map(|at| measure.slack(&at)).fold(f64::INFINITY, f64::min);
                assert!(proved <= least + 1e-9 * scale, "{name} {radius} {error}: {proved} of {least} N");
                missed.push((least - proved) / scale);
            }
        }
    }
    missed.sort_by(f64::total_cmp);
    let [median, most] = [missed[missed.len() / 2], missed[missed.len() - 1]];
    println!("{} motions; of the largest tension, {median:.1e} missed in the median, {most:.1e} at most", missed.len());
    assert!(missed.len() > 60 && median < 1e-6, "{median}");
}

#[test]
fn wrench_failures_and_least_slack_are_found_round_pulleys() {
    let mut rng = rng(34);
    let mut told = 0;
    for (name, balls, box_) in ROBOTS {
        for _ in 0..10 * effort() {
            let robot = changed(name, 0.1, 0.0, &mut rng);
            let measure = capacity(&robot, balls);
            // From where the wrenches hold, if there is such a position, so that they may fail on the way.
            let starts: Vec<Point> = (0..50).map(|_| within(&mut rng, &box_)).collect();
            let from = *starts.iter().find(|p| measure.slack(p) > 0.0).unwrap_or(&starts[0]);
            let to = within(&mut rng, &box_);
            let scale = measure.statics().largest_tension();
            let brute = sampled(&robot, balls, [&from, &to], 2000, &mut rng);
            let failure = first_failure(&measure, &from, &to);
            assert_eq!(failure.is_none(), certified(&measure, &from, &to));
            assert!(brute >= 0.0 || failure.is_some());
            let (least, at) = least_slack(&measure, &from, &to);
            if brute.is_nan() {
                continue;
            }
            assert!((measure.slack(&(from + (to - from) * at)) - least).abs() <= measure.floor());
            if brute > 0.0 {
                assert!(least <= brute + 2e-3 * scale, "{least} {brute}");
                let reached = slack_reaches(&measure, &from, &to, 0.8 * least);
                assert!(!reached || brute >= 0.8 * least);
                assert!(!slack_reaches(&measure, &from, &to, least + 1e-5 * scale));
            }
            if let Some(at) = failure.filter(|at| *at > 1e-6 && brute < 0.0) {
                assert!(certified(&measure, &from, &(from + (to - from) * (at - 1e-6) * 0.9)));
                told += 1;
            }
        }
    }
    assert!(told >= 5, "{told} motions that fail on their way");
}

/// A scene of an existing robot with pulleys, errors and a requirement of wrenches, without its obstacles.
fn changed_scene(name: &str, [radius, error]: [f64; 2], wrench: Option<WrenchSpec>, rng: &mut ChaCha8Rng) -> Scene {
    let scene = built_scene(name);
    let mut spec = scene.spec().clone();
    spec.robot = RobotSource::Inline(changed_spec(scene.robot().spec().clone(), radius, error, rng));
    spec.obstacles.clear();
    spec.wrench = wrench;
    Scene::new(spec).unwrap()
}

#[test]
fn facets_of_wrench_demands_by_kernel_are_those_by_definition() {
    let mut rng = rng(37);
    for (name, _, box_) in ROBOTS {
        for (radius, error) in [(0.1, 0.0), (0.0, 0.002), (0.1, 0.002)] {
            let mut compared = 0;
            for _ in 0..10 * effort() {
                let own = statics(&changed(name, radius, error, &mut rng));
                let scale = own.largest_tension();
                let demand = |_| Demand {
                    position: within(&mut rng, &box_),
                    wrenches: [0, 1].map(|_| Vector6::from_fn(|_, _| rng.random_range(-0.01..0.01) * scale)),
                    most: [f64::INFINITY; 2],
                };
                let (demands, facets): (Vec<Demand>, _) = ((0..6).map(demand).collect(), DemandFacets::new(own, 0.0));
                for demand in &demands {
                    let of = |facets: &DemandFacets| facets.shares(&[*demand, demands[0]], None);
                    match (of(&facets), of(&facets.clone().by_definition())) {
                        (Ok(a), Ok(b)) => {
                            for (a, b) in a[0].iter().zip(&b[0]) {
                                assert!((a.slack - b.slack).abs() < 1e-9 * scale, "{a:?} {b:?}");
                            }
                            compared += 1;
                        }
                        (a, b) => assert_eq!(a.is_err(), b.is_err()),
                    }
                }
            }
            println!("{name} {radius} m {error} m: {compared} compared");
        }
    }
}

#[test]
fn boxes_that_lack_wrenches_are_told_for_given_outlets_only() {
    let mut rng = rng(38);
    let mut lacking = 0;
    for (name, balls, box_) in ROBOTS {
        for _ in 0..40 * effort() {
            let robot = changed(name, 0.0, 0.02, &mut rng);
            let outlets: Vec<Point> = robot.cables().iter().map(|cable| cable.outlet).collect();
            let given = capacity(&with_outlets(&robot, &outlets, true), balls);
            let center = within(&mut rng, &box_.map(|[low, high]| [1.5 * low - 0.5 * high, 1.5 * high - 0.5 * low]));
            let positions = Cuboid::new(center - Vector::repeat(0.05), center + Vector::repeat(0.05));
            let origins: Vec<_> = outlets.iter().map(|&middle| Origin { middle, spread: 0.0 }).collect();
            let found = capacity(&robot, balls).lacking(&positions, &origins);
            assert_eq!(found.is_some(), given.lacking(&positions, &origins).is_some(), "{name}");
            lacking += usize::from(found.is_some());
            for _ in 0..if found.is_some() { 20 } else { 0 } {
                assert!(given.slack(&(center + Vector::from_fn(|_, _| rng.random_range(-0.05..0.05)))) < 0.0);
            }
        }
    }
    assert!(lacking > 30, "{lacking}");
}

#[test]
fn turning_wrench_motions_hold_round_pulleys_and_at_all_outlets() {
    let mut rng = rng(35);
    for (name, [force, moment], box_) in [ROBOTS[1], ROBOTS[3]] {
        for (margin, change) in [
            (MarginSpec::Capacity, [0.1, 0.0]),
            (MarginSpec::Capacity, [0.0, 0.02]),
            (MarginSpec::Capacity, [0.1, 0.01]),
            (MarginSpec::Projected, [0.1, 0.01]),
        ] {
            let spec =
                WrenchSpec { force: Some(force), moment: Some(moment), margin: Some(margin), ..WrenchSpec::default() };
            let scene = changed_scene(name, change, Some(spec), &mut rng);
            let (wrench, robot) = (TurningWrench::of(&scene).unwrap().unwrap(), scene.robot());
            let tries = if margin == MarginSpec::Capacity { 30 } else { 4 } * effort();
            let mut kept = 0;
            for tried in 0..tries {
                let size = [0.02, 0.1, 0.3][tried as usize % 3];
                let from = Pose::new(within(&mut rng, &box_), Rotation::from_scaled_axis(direction(&mut rng) * 0.05));
                let turn = Rotation::from_scaled_axis(direction(&mut rng) * 0.3 * size);
                let to = Pose::new(from.position + direction(&mut rng) * size, turn * from.orientation);
                if !wrench.keeps(&from, &to) {
                    continue;
                }
                kept += 1;
                let motion = from.toward(&to);
                let real = with_outlets(robot, &true_outlets(robot, &mut rng), true);
                for k in 0..=40 {
                    let pose = motion.at(f64::from(k) / 40.0);
                    let statics = Statics::new(&real, &Loads::of(&scene).at(&pose.orientation)).unwrap();
                    let slack = match margin {
                        MarginSpec::Capacity => {
                            let required = Required::balls(force, moment).unwrap();
                            capacity_limit(&statics, &required, &pose.position).unwrap().margin
                        }
                        MarginSpec::Projected => {
                            let force = force_limit(&statics, &pose.position).unwrap().margin - force;
                            force.min(moment_limit(&statics, &pose.position).unwrap().margin - moment)
                        }
                    };
                    assert!(slack >= 0.0, "{name}: {slack} at {k}");
                }
            }
            println!("{name} {change:?}: {kept} of {tries} kept");
            assert!(kept > 0, "{name} {change:?}");
        }
    }
}

#[test]
fn timed_motions_to_where_a_cable_cannot_leave_its_pulley_are_refused() {
    let mut spec = built_scene("ipanema2").spec().clone();
    let mut robot = built_robot("ipanema2").spec().clone();
    robot.mass = None; // no tensions are asked for
    robot.cables[5].pulley = Some(PulleySpec { radius: 4.0, axis: [0.0, 0.0, 1.0] });
    (spec.robot, spec.wrench) = (RobotSource::Inline(robot), None);
    spec.obstacles.clear();
    let scene = Scene::new(spec).unwrap();
    let limits = MotionSpec { speed: Some(1.0), acceleration: Some(1.0), ..MotionSpec::default() };
    let path = held(&scene, &[Point::new(-2.0, 0.0, 2.5), Point::new(2.0, 1.0, 2.0)]);
    let refused = Trajectory::new(&compiled(&scene), &path, &limits, &Watch::NONE).unwrap_err().to_string();
    assert!(refused.contains("cable 5 breaks its length limits"), "{refused}");
}

#[test]
fn timed_motions_round_pulleys_agree_with_differences_and_keep_wrench_limits() {
    let mut rng = rng(36);
    let limits = [
        MotionSpec { speed: Some(1.0), acceleration: Some(1.0), cable_speed: Some(0.4), ..MotionSpec::default() },
        MotionSpec { speed: Some(1.0), cable_acceleration: Some(0.5), ..MotionSpec::default() },
        MotionSpec { speed: Some(2.0), jerk: Some(20.0), ..MotionSpec::default() },
    ];
    let [ipanema, simulator] = [ROBOTS[1], ROBOTS[3]];
    for ((name, _, box_), change) in [(ipanema, [0.1, 0.0]), (ipanema, [0.1, 0.002]), (simulator, [0.0, 0.005])] {
        for limits in &limits {
            let scene = changed_scene(name, change, None, &mut rng);
            let middle = Point::from(box_.map(|[low, high]| 0.5 * (low + high)));
            let path =
                held(&scene, &[middle, middle + Vector::new(0.5, 0.3, 0.1), middle + Vector::new(0.2, 0.8, -0.1)]);
            let motion = Trajectory::new(&compiled(&scene), &path, limits, &Watch::NONE).unwrap();
            let (mut solver, h) = (TensionQp::default(), 1e-5 * motion.duration());
            let bounds = motion.winches().tension_limits().expect("limited");
            let real: Vec<Winches> = (0..5)
                .map(|_| {
                    let robot = with_outlets(scene.robot(), &true_outlets(scene.robot(), &mut rng), true);
                    let spec = SceneSpec { robot: RobotSource::Inline(robot.spec().clone()), ..scene.spec().clone() };
                    Winches::of(&Scene::new(spec).unwrap(), limits, &path).unwrap()
                })
                .collect();
            for k in 0..=60 {
                let time = motion.duration() * f64::from(k) / 60.0;
                let now = motion.sample(&mut solver, time).unwrap();
                for winches in &real {
                    assert!(winches.tensions(&mut solver, &now.motion).unwrap().is_some());
                }
                let tensions = now.tensions.unwrap();
                assert!(tensions.iter().zip(bounds).all(|(t, [least, most])| t >= least && t <= most));
                let lengths = cable_lengths(scene.robot(), &now.motion.orientation, &now.motion.position);
                let [before, after] =
                    [time - h, time + h].map(|time| motion.sample(&mut solver, time).unwrap().windings);
                // The acceleration of the platform jumps where a phase begins.
                let smooth = (motion.at(time - h).acceleration - motion.at(time + h).acceleration).norm() < 1e-2;
                for (cable, winding) in now.windings.iter().enumerate() {
                    assert!((winding.length - lengths[cable]).abs() < 1e-12);
                    assert!(limits.cable_speed.is_none_or(|most| winding.speed.abs() <= most * (1.0 + 1e-9)));
                    assert!(
                        limits.cable_acceleration.is_none_or(|most| winding.acceleration.abs() <= most * (1.0 + 1e-9))
                    );
                    if smooth && time > h && time + h < motion.duration() {
                        let speed = (after[cable].length - before[cable].length) / (2.0 * h);
                        let acceleration = (after[cable].speed - before[cable].speed) / (2.0 * h);
                        assert!((speed - winding.speed).abs() < 1e-5, "{speed} {winding:?}");
                        assert!((acceleration - winding.acceleration).abs() < 2e-2, "{acceleration} {winding:?}");
                    }
                }
            }
        }
    }
}
