//! Poses from cable lengths: those that caused the lengths, for all built robots, with and without pulleys, and what noise does
//! to them.

use cdpr_core::geometry::{Point, Pose, Rotation, Vector};
use cdpr_core::kinematics::{ForwardKinematics, PoseEstimate, cable_lengths, wrench_matrix};
use cdpr_core::model::Robot;
use cdpr_core::model::spec::{CableDefaultsSpec, PulleySpec};
use cdpr_tests::{built_robot, built_scene, direction, effort, point_robot, rng, uniform, vector};
use nalgebra::{DVector, Matrix3, Matrix6, Vector6};
use rand::{Rng, RngExt};

/// The scenes of all built robots, and the largest share of poses from which the search goes to another local minimum: the
/// lengths of these two robots differ by micrometres between poses some 10° apart.
const SCENES: [(&str, f64); 7] = [
    ("acrobot", 0.1),
    ("caroca", 0.01),
    ("cogiro", 0.01),
    ("ipanema2", 0.0),
    ("mpi_simulator", 0.0),
    ("hard1", 0.2),
    ("hard1_rank6", 0.0),
];

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

#[test]
fn poses_come_back_from_their_lengths() {
    let mut rng = rng(1);
    for (name, most_elsewhere) in SCENES {
        let scene = built_scene(name);
        let workspace = &scene.spec().workspace;
        for robot in [scene.robot().clone(), with_pulleys(scene.robot())] {
            let solver = ForwardKinematics::new(&robot, None).unwrap();
            let cases = 720 * effort();
            let (mut judged, mut lost, mut elsewhere, mut unnamed, mut stalled) = (0.0, 0.0, 0.0, 0.0, 0.0);
            for _ in 0..cases {
                let pose = random_pose(&mut rng, workspace.min, workspace.max);
                let turn = Rotation::from_scaled_axis(direction(&mut rng) * 10_f64.to_radians());
                let guess = Pose::new(pose.position + 0.2 * direction(&mut rng), turn * pose.orientation);
                // A cable cannot leave its pulley everywhere.
                let (Some(lengths), Some(_)) = (lengths_at(&robot, &pose), lengths_at(&robot, &guess)) else {
                    continue;
                };
                judged += 1.0;
                // Where a cable cannot leave its pulley, the search ends. In a flat valley it may be too slow.
                let Ok(found) = solver.estimate(&lengths, Some(&guess)) else {
                    stalled += if robot.cable_with_pulley().is_some() { 0.0 } else { 1.0 };
                    elsewhere += 1.0;
                    continue;
                };
                if error(&found.pose, &pose) <= 1e-9 {
                    continue;
                }
                // Where micrometres of a length are millimetres of the pose, its digits are lost to rounding; so far as the residuals
                // that are left explain it, the error is no other minimum.
                let off = error(&found.pose, &pose);
                let explained = |trace: f64| trace > 1e6 || off <= 10.0 * found.fit() * trace.sqrt();
                if found.fit() <= 1e-9 && found.covariance.is_none_or(|covariance| explained(covariance.trace())) {
                    lost += 1.0;
                    continue;
                }
                // Another pose with these lengths, or a minimum with residuals in balance; the right pose is among the others.
                elsewhere += 1.0;
                assert!(found.fit() <= 1e-9 || imbalance(&robot, &found) <= 1e-6, "{name}: {off} {found:?}");
                let others = solver.others(&lengths, &found).unwrap();
                unnamed += if others.iter().any(|other| error(&other.pose, &pose) <= 1e-9) { 0.0 } else { 1.0 };
            }
            assert!(stalled <= 0.001 * judged, "{name}: {stalled} of {judged} without an answer");
            assert!(lost <= 0.01 * judged, "{name}: {lost} of {judged} too loose");
            assert!(judged > 0.98 * cases as f64, "{name}: {judged}");
            assert!(elsewhere <= most_elsewhere * judged, "{name}: {elsewhere} of {judged} elsewhere");
            assert!(unnamed <= 0.005 * judged, "{name}: {unnamed} of {judged} neither found nor named");
        }
    }
}

#[test]
fn poses_come_back_from_lengths_alone() {
    let mut rng = rng(2);
    for (name, _) in SCENES {
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
