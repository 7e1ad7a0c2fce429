//! Poses from cable lengths: those that caused the lengths, for all built robots, with and without pulleys, and what noise does
//! to them.

use std::cell::Cell;

use cdpr_core::geometry::{Point, Pose, Rotation, Vector};
use cdpr_core::kinematics::{ForwardKinematics, PoseEstimate, cable_lengths, wrench_matrix};
use cdpr_core::model::Robot;
use cdpr_core::model::spec::{CableDefaultsSpec, PulleySpec};
use cdpr_core::watch::Watch;
use cdpr_tests::{built_robot, built_scene, direction, effort, point_robot, rng, uniform, vector};
use nalgebra::{DVector, Matrix3, Matrix6, Vector6};
use rand::{Rng, RngExt};

/// The scenes of all built robots.
const SCENES: [&str; 7] = ["acrobot", "caroca", "cogiro", "ipanema2", "mpi_simulator", "hard1", "hard1_rank6"];

/// The robot with pulleys of 3 cm on upright axes.
fn with_pulleys(robot: &Robot) -> Robot {
    let mut spec = robot.spec().clone();
    let pulley = Some(PulleySpec { radius: 0.03, axis: [0.0, 0.0, 1.0] });
    spec.cable = Some(CableDefaultsSpec { pulley, ..spec.cable.unwrap_or_default() });
    Robot::try_from(spec).expect("a sound robot")
}

/// A pose in the middle three fifths of a workspace, turned by up to 30°.
fn random_pose(rng: &mut impl Rng, min: [f64; 3], max: [f64; 3]) -> Pose {
    let position = Point::from(std::array::from_fn(|k| min[k] + (max[k] - min[k]) * uniform(rng, 0.2, 0.8)));
    Pose::new(position, Rotation::from_scaled_axis(direction(rng) * uniform(rng, 0.0, 30_f64.to_radians())))
}

fn lengths_at(robot: &Robot, pose: &Pose) -> Option<Vec<f64>> {
    let lengths = cable_lengths(robot, &pose.orientation, &pose.position);
    lengths.iter().all(|length| length.is_finite()).then_some(lengths)
}

fn error(found: &Pose, right: &Pose) -> f64 {
    (found.position - right.position).norm().max(found.angle_to(right))
}

/// The residuals pull at the platform like tensions; at a minimum they are in balance. Their wrench, as a share of what they can exert.
fn imbalance(robot: &Robot, found: &PoseEstimate) -> f64 {
    let matrix = wrench_matrix(robot, &found.pose.orientation, &found.pose.position).unwrap();
    let wrench = &matrix * DVector::from_column_slice(&found.residuals);
    wrench.norm() / (matrix.norm().max(1.0) * found.fit() * 8_f64.sqrt())
}

/// The robots of all scenes, with and without pulleys, and for each so many poses in the scene's workspace with their lengths. A cable
/// cannot leave its pulley everywhere; such poses are left out.
fn for_all_robots(
    rng: &mut impl Rng,
    cases: u64,
    judge: impl Fn(&str, &Robot, &ForwardKinematics, &Pose, &[f64], &mut dyn FnMut() -> Pose),
) {
    for name in SCENES {
        let scene = built_scene(name);
        let workspace = &scene.spec().workspace;
        for robot in [scene.robot().clone(), with_pulleys(scene.robot())] {
            let solver = ForwardKinematics::new(&robot, None).unwrap();
            for _ in 0..cases {
                let (pose, lengths) = loop {
                    let pose = random_pose(rng, workspace.min, workspace.max);
                    if let Some(lengths) = lengths_at(&robot, &pose) {
                        break (pose, lengths);
                    }
                };
                let mut guess = || loop {
                    let turn = Rotation::from_scaled_axis(direction(rng) * 10_f64.to_radians());
                    let guess = Pose::new(pose.position + 0.2 * direction(rng), turn * pose.orientation);
                    if lengths_at(&robot, &guess).is_some() {
                        return guess;
                    }
                };
                judge(name, &robot, &solver, &pose, &lengths, &mut guess);
            }
        }
    }
}

/// Whether an error of a pose is one of rounding: below 1 nm, or where micrometres of a length are decimetres of the pose, what the
/// residuals become there.
fn is_rounding(found: &PoseEstimate, right: &Pose) -> bool {
    let off = error(&found.pose, right);
    let magnified = found.covariance.map_or(f64::INFINITY, |covariance| covariance.trace());
    off <= 1e-9 || (magnified > 1e10 && found.fit() <= 1e-14 && off <= 1e-5)
}

#[test]
fn poses_come_back_from_their_lengths() {
    let (cases, lost) = (200 * effort(), Cell::new(0));
    for_all_robots(&mut rng(1), cases, |name, robot, solver, pose, lengths, guess| {
        let found = solver.estimate(lengths, Some(&guess())).unwrap();
        let twin = || {
            let others = solver.others(lengths, &found).unwrap();
            found.fit() <= 1e-14 && others.iter().any(|other| is_rounding(other, pose))
        };
        if !is_rounding(&found, pose) && !twin() {
            // On the straight way to the pose, a cable may be unable to leave its pulley.
            assert!(robot.cable_with_pulley().is_some(), "{name}: {pose:?} {found:?}");
            lost.set(lost.get() + 1);
        }
    });
    assert!(lost.get() <= 1 + cases / 1000, "{} of {cases} of each robot", lost.get());
}

/// Beyond a fold, there is another pose with nearly the same lengths; from there, the first one is named.
#[test]
fn poses_with_the_same_lengths_name_each_other() {
    let named = Cell::new(0);
    for_all_robots(&mut rng(7), 40 * effort(), |name, _, solver, pose, lengths, _| {
        let found = solver.estimate(lengths, Some(pose)).unwrap();
        for other in solver.others(lengths, &found).unwrap() {
            let there = solver.estimate(lengths, Some(&other.pose)).unwrap();
            if is_rounding(&there, pose) {
                continue; // the other one fits worse and is so near a singular pose that it was not found from itself
            }
            assert!(error(&there.pose, &other.pose) <= 1e-6, "{name}: {other:?} {there:?}");
            let back = solver.others(lengths, &there).unwrap();
            let near = error(&other.pose, pose) < 0.1;
            assert!(!near || back.iter().any(|o| is_rounding(o, pose)), "{name}: {pose:?} {other:?} {back:?}");
            named.set(named.get() + u64::from(near));
        }
    });
    assert!(effort() < 20 || named.get() > 0);
}

/// From the pose of the row before, also where a straight motion crosses poses at which the Jacobian is singular.
#[test]
fn motions_come_back_from_rows_of_lengths() {
    let mut rng = rng(8);
    for name in SCENES {
        let scene = built_scene(name);
        let (robot, workspace) = (scene.robot(), &scene.spec().workspace);
        let solver = ForwardKinematics::new(robot, None).unwrap();
        for _ in 0..20 * effort() {
            let [from, to] = [0, 1].map(|_| random_pose(&mut rng, workspace.min, workspace.max));
            let turn = (to.orientation * from.orientation.inverse()).scaled_axis();
            let pose = |share: f64| {
                let position = from.position + share * (to.position - from.position);
                Pose::new(position, Rotation::from_scaled_axis(share * turn) * from.orientation)
            };
            let poses: Vec<Pose> = (0..200).map(|k| pose(f64::from(k) / 200.0)).collect();
            let rows: Vec<_> = poses.iter().map(|pose| lengths_at(robot, pose).unwrap()).collect();
            let found = solver.follow(rows.iter().map(Vec::as_slice), Some(from), |e, _| e, &Watch::NONE).unwrap();
            for (found, pose) in found.iter().zip(&poses) {
                // Where the motion crosses a singular pose, two poses differ by micrometres.
                assert!(error(&found.pose, pose) <= 1e-5, "{name}: {pose:?} {found:?}");
            }
        }
    }
}

#[test]
fn poses_come_back_from_lengths_alone() {
    let mut rng = rng(2);
    for name in SCENES {
        let scene = built_scene(name);
        let workspace = &scene.spec().workspace;
        let solver = ForwardKinematics::new(scene.robot(), None).unwrap();
        let cases = 100 * effort();
        let right = (0..cases).filter(|_| {
            let pose = random_pose(&mut rng, workspace.min, workspace.max);
            let lengths = lengths_at(scene.robot(), &pose).unwrap();
            error(&solver.estimate(&lengths, None).unwrap().pose, &pose) <= 1e-9
        });
        let right = right.count() as u64;
        assert!(right >= cases * 98 / 100, "{name}: {right} of {cases}");
    }
}

#[test]
fn positions_come_back_at_a_given_orientation_from_three_cables_on() {
    let mut rng = rng(3);
    for _ in 0..2000 * effort() {
        let count = rng.random_range(3..6);
        let ends: Vec<_> = (0..count)
            .map(|_| {
                let outlet = vector(&mut rng, 2.0) + Vector::new(0.0, 0.0, 4.0);
                (outlet.into(), vector(&mut rng, 0.2).into(), [1.0, 2.0])
            })
            .collect();
        let robot = point_robot(&ends, 1.0);
        let pose = Pose::new(Point::from(vector(&mut rng, 1.0)), Rotation::from_scaled_axis(vector(&mut rng, 1.0)));
        let lengths = lengths_at(&robot, &pose).unwrap();
        let solver = ForwardKinematics::new(&robot, Some(pose.orientation)).unwrap();
        let guess = Pose::new(pose.position + 0.1 * direction(&mut rng), Rotation::identity());
        let found = solver.estimate(&lengths, Some(&guess)).unwrap();
        let named = || solver.others(&lengths, &found).unwrap().into_iter().any(|o| error(&o.pose, &pose) < 1e-6);
        // Cables nearly in a plane leave the position nearly open, and the mirror image near.
        let close = !found.is_determined() || found.covariance.unwrap().trace() > 1e4;
        assert!(close || error(&found.pose, &pose) < 1e-9 || named(), "{robot:?} {pose:?} {found:?}");
    }
}

/// Eight outlets in one plane and eight attachments in another: reflecting the pose keeps all lengths.
#[test]
fn the_mirror_image_of_a_pose_is_named() {
    let mut rng = rng(4);
    let (mut named, cases) = (0, 200 * effort());
    for _ in 0..cases {
        let ends: Vec<_> = (0..8)
            .map(|k| {
                let angle = std::f64::consts::TAU * f64::from(k) / 8.0;
                let outlet = [2.0 * angle.cos() + uniform(&mut rng, -0.5, 0.5), 2.0 * angle.sin(), 2.0];
                let arm = [uniform(&mut rng, -0.5, 0.5), uniform(&mut rng, -0.5, 0.5), 0.0];
                (outlet, arm, [1.0, 2.0])
            })
            .collect();
        let robot = point_robot(&ends, 1.0);
        let pose = random_pose(&mut rng, [-0.5, -0.5, 0.0], [0.5, 0.5, 1.0]);
        let mirror = Matrix3::from_diagonal(&Vector::new(1.0, 1.0, -1.0));
        let turned = mirror * pose.orientation.to_rotation_matrix().matrix() * mirror;
        let image = Pose::new(
            Point::new(pose.position.x, pose.position.y, 4.0 - pose.position.z),
            Rotation::from_matrix_eps(&turned, 1e-15, 100, Rotation::identity()),
        );
        let lengths = lengths_at(&robot, &pose).unwrap();
        let solver = ForwardKinematics::new(&robot, None).unwrap();
        let guess = Pose::new(pose.position + 0.05 * direction(&mut rng), pose.orientation);
        let found = solver.estimate(&lengths, Some(&guess)).unwrap();
        assert!(found.fit() < 1e-9, "{found:?}");
        let others = solver.others(&lengths, &found).unwrap();
        assert!(others.iter().all(|other| other.fit() <= 1e-9 && error(&other.pose, &found.pose) > 1e-4));
        named += u64::from(others.iter().any(|other| error(&other.pose, &image) < 1e-7));
    }
    assert!(named >= cases * 95 / 100, "{named} of {cases}");
}

/// A normally distributed number, by Box and Muller.
fn normal(rng: &mut impl Rng) -> f64 {
    (-2.0 * (1.0 - rng.random::<f64>()).ln()).sqrt() * (std::f64::consts::TAU * rng.random::<f64>()).cos()
}

#[test]
fn noise_of_a_millimetre_has_the_predicted_covariance() {
    let mut rng = rng(5);
    for robot in [built_robot("cogiro"), with_pulleys(&built_robot("ipanema2"))] {
        let pose = Pose::new(Point::new(0.3, -0.4, 1.5), Rotation::from_scaled_axis(Vector::new(0.1, -0.05, 0.2)));
        let (lengths, solver) = (lengths_at(&robot, &pose).unwrap(), ForwardKinematics::new(&robot, None).unwrap());
        let draws = 4000 * effort();
        let mut found = Matrix6::zeros();
        for _ in 0..draws {
            let noisy: Vec<f64> = lengths.iter().map(|length| length + 1e-3 * normal(&mut rng)).collect();
            let estimate = solver.estimate(&noisy, Some(&pose)).unwrap().pose;
            let (moved, turned) =
                (estimate.position - pose.position, estimate.orientation * pose.orientation.inverse());
            let turned = turned.scaled_axis();
            let error = Vector6::new(moved.x, moved.y, moved.z, turned.x, turned.y, turned.z);
            found += error * error.transpose() / draws as f64;
        }
        let predicted = 1e-6 * solver.estimate(&lengths, Some(&pose)).unwrap().covariance.unwrap();
        // Each entry has a standard deviation of at most sqrt(2 / draws), as a share of the deviations of its row and column.
        let deviations = predicted.diagonal().map(f64::sqrt);
        let share = (found - predicted).component_div(&(deviations * deviations.transpose()));
        assert!(share.amax() < 5.0 * (2.0 / draws as f64).sqrt(), "{share}");
    }
}

/// Whatever the lengths, there is a minimum or an error that says how far the search got.
#[test]
fn hostile_lengths_give_a_minimum_or_an_error() {
    let mut rng = rng(6);
    let robots = ["cogiro", "ipanema2", "paper"].map(built_robot);
    for (low, high, least) in [(-1.0, 1.0, 0.6), (-12.0, 6.0, 0.05)] {
        let (mut found, cases) = (0.0, 300 * effort());
        for case in 0..cases {
            let robot = &robots[case as usize % 3];
            let lengths: Vec<f64> = (0..8).map(|_| 10_f64.powf(uniform(&mut rng, low, high))).collect();
            match ForwardKinematics::new(robot, None).unwrap().estimate(&lengths, None) {
                Ok(estimate) => {
                    found += 1.0;
                    assert!(
                        estimate.pose.is_finite() && imbalance(robot, &estimate) <= 1e-5,
                        "{lengths:?} {estimate:?}"
                    );
                }
                Err(error) => assert!(error.to_string().contains("found no pose after"), "{error}"),
            }
        }
        assert!(found >= least * cases as f64, "{low} {high}: {found}");
    }
}
