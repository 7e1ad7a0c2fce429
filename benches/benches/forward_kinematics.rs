//! Time of a pose from cable lengths: from a guess 0.2 m and 10° away, from the pose one sample earlier, and with other poses that
//! have the same lengths.

use std::path::Path;

use cdpr_core::geometry::{Point, Pose, Rotation, Vector};
use cdpr_core::kinematics::{ForwardKinematics, cable_lengths};
use cdpr_core::model::Robot;
use cdpr_core::model::spec::{CableDefaultsSpec, PulleySpec};
use cdpr_files::load_robot;
use criterion::{Criterion, criterion_group, criterion_main};

/// CoGiRo, and the same robot with pulleys of 5 cm.
fn robots() -> [(&'static str, Robot); 2] {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../testdata/robots/cogiro.toml");
    let robot = load_robot(file).expect("a sound robot");
    let mut spec = robot.spec().clone();
    let pulley = Some(PulleySpec { radius: 0.05, axis: [0.0, 0.0, 1.0] });
    spec.cable = Some(CableDefaultsSpec { pulley, ..CableDefaultsSpec::default() });
    [("CoGiRo", robot), ("CoGiRo with pulleys", Robot::try_from(spec).expect("a sound robot"))]
}

fn forward_kinematics(c: &mut Criterion) {
    let mut group = c.benchmark_group("forward kinematics");
    for (name, robot) in robots() {
        let solver = ForwardKinematics::new(&robot, None).expect("eight cables");
        let pose = Pose::new(Point::new(0.5, -0.4, 2.0), Rotation::from_scaled_axis(Vector::new(0.1, 0.05, -0.1)));
        let lengths = cable_lengths(&robot, &pose.orientation, &pose.position);
        let away = |distance: f64, angle: f64| {
            let turn = Rotation::from_scaled_axis(Vector::new(0.48, 0.6, 0.64) * angle.to_radians());
            Pose::new(pose.position + Vector::new(0.6, -0.48, 0.64) * distance, turn * pose.orientation)
        };
        for (start, guess) in [("0.2 m and 10° away", away(0.2, 10.0)), ("1 mm and 0.1° away", away(1e-3, 0.1))] {
            let solve = || solver.estimate(&lengths, Some(&guess)).expect("a pose");
            assert!((solve().pose.position - pose.position).norm() < 1e-9);
            group.bench_function(format!("{name}, {start}"), |b| b.iter(solve));
        }
        let found = solver.estimate(&lengths, Some(&pose)).expect("a pose");
        group.bench_function(format!("{name}, other poses"), |b| b.iter(|| solver.others(&lengths, &found)));
    }
    group.finish();
}

criterion_group!(benches, forward_kinematics);
criterion_main!(benches);
