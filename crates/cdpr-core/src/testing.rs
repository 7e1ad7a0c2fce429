//! The paper's robot and two scenes that replace its Figure 9, for examples and tests.
//!
//! Eight outlets at the corners of a cube of 2 m, each connected to the corresponding corner of the platform; a
//! platform of 0.15 × 0.15 × 0.05 m; start (0.3, 1, 0.3), goal (1.7, 1, 1.7) (the paper, Table 1; the paper prints
//! neither its cable layout nor the obstacles).

use crate::geometry::{Point, Vector};
use crate::model::spec::MotionSpec;
use crate::model::{BodySpec, Cable, CableSpec, QuerySpec, RobotSource, RobotSpec, Scene, SceneSpec, WorkspaceSpec};
use crate::path::held;
use crate::path_file::PathFile;
use crate::trajectory::Limit;
use crate::trajectory_file::{Limiting, TRAJECTORY_FORMAT, TRAJECTORY_VERSION, TrajectoryFile};

/// The paper's robot.
pub fn paper_robot() -> RobotSpec {
    let signs = |k: usize| std::array::from_fn(|axis| if k >> axis & 1 == 1 { 1.0 } else { -1.0 });
    let cable = |k: usize| {
        let [x, y, z]: [f64; 3] = signs(k);
        CableSpec {
            outlet: [1.0 + x, 1.0 + y, 1.0 + z],
            attachment: [0.075 * x, 0.075 * y, 0.025 * z],
            tension: Some([10.0, 1000.0]),
            ..CableSpec::default()
        }
    };
    RobotSpec {
        version: None,
        name: Some("paper".to_string()),
        mass: Some(10.0),
        center_of_mass: None,
        inertia: None,
        platform: vec![BodySpec { cuboid: Some([0.15, 0.15, 0.05]), ..BodySpec::default() }],
        cables: (0..8).map(cable).collect(),
        cable: None,
        tension_distribution: None,
    }
}

/// A box obstacle.
pub fn block(name: &str, sides: [f64; 3], position: [f64; 3]) -> BodySpec {
    BodySpec { name: Some(name.to_string()), cuboid: Some(sides), position: Some(position), ..BodySpec::default() }
}

/// The paper's robot in its workspace with these obstacles.
pub fn paper_scene(name: &str, obstacles: Vec<BodySpec>) -> SceneSpec {
    SceneSpec {
        version: 1,
        name: Some(name.to_string()),
        gravity: None,
        clearance: None,
        ignore: Vec::new(),
        touch: Vec::new(),
        clearances: None,
        orientations: Vec::new(),
        stations: Vec::new(),
        payloads: Vec::new(),
        task: Vec::new(),
        workspace: WorkspaceSpec { min: [0.0; 3], max: [2.0; 3] },
        robot: RobotSource::Inline(paper_robot()),
        obstacles,
        wrench: None,
        query: Some(QuerySpec::between([0.3, 1.0, 0.3], [1.7, 1.0, 1.7])),
        motion: None,
        turning: None,
    }
}

/// The paper's robot with one pillar of 0.3 × 0.3 × 1.5 m in the centre.
pub fn hard1() -> Scene {
    scene(paper_scene("hard1", vec![block("pillar", [0.3, 0.3, 1.5], [1.0, 1.0, 0.75])]))
}

/// The paper's robot with three pillars of 0.2 × 0.2 × 1.2 m.
pub fn hard3() -> Scene {
    let pillar = |name: &str, x: f64, y: f64| block(name, [0.2, 0.2, 1.2], [x, y, 0.6]);
    let pillars = vec![pillar("west", 0.7, 1.0), pillar("south", 1.3, 0.7), pillar("north", 1.3, 1.3)];
    scene(paper_scene("hard3", pillars))
}

/// The paper's platform on its four upper cables, and a wall across the workspace, 0.9 m high and 0.1 m thick. Over the wall
/// the centre of the platform is between 0.925 m and 0.025 m below the ceiling.
pub fn walled(ceiling: f64) -> SceneSpec {
    let mut robot = paper_robot();
    robot.cables.drain(..4);
    SceneSpec {
        robot: RobotSource::Inline(robot),
        workspace: WorkspaceSpec { min: [0.0; 3], max: [2.0, 2.0, ceiling] },
        query: Some(QuerySpec::between([0.3, 1.0, 0.3], [1.7, 1.0, 0.3])),
        ..paper_scene("walled", vec![block("wall", [0.1, 2.0, 0.9], [1.0, 1.0, 0.45])])
    }
}

/// A motion of 2 s along a straight line, in this many steps: constant acceleration, then the same to brake.
pub fn moving(scene: &Scene, from: Point, to: Point, steps: usize) -> TrajectoryFile {
    let path = PathFile::of(scene, &held(scene, &[from, to]));
    let cables = scene.robot().cables();
    let times: Vec<f64> = (0..=steps).map(|k| 2.0 * k as f64 / steps as f64).collect();
    let states: Vec<[Vector; 3]> = times.iter().map(|t| state(from, to, *t)).collect();
    let rows = |part: usize| states.iter().map(|state| state[part].into()).collect();
    let by_cable = |of: &dyn Fn(&Vector, &Vector) -> f64| {
        let line = |cable: &Cable, p: &Vector| cable.outlet.coords - p - scene.orientation() * cable.attachment.coords;
        states.iter().map(|[p, v, _]| cables.iter().map(|cable| of(&line(cable, p), v)).collect()).collect()
    };
    TrajectoryFile {
        format: TRAJECTORY_FORMAT.to_string(),
        version: TRAJECTORY_VERSION,
        scene: path.scene.expect("every path of a scene has it"),
        orientation: path.orientation.expect("every path of a scene has it"),
        orientation_name: scene.orientation_name().map(str::to_string),
        duration: 2.0,
        length: (to - from).norm(),
        rate: steps as f64 / 2.0,
        limits: MotionSpec { acceleration: Some((to - from).norm()), blend: Some(0.0), ..MotionSpec::default() },
        tension_limits: None,
        tension_distribution: None,
        waypoints: path.waypoints,
        waypoint_orientations: None,
        corners: Vec::new(),
        limiting: vec![Limiting { from: 0.0, to: 2.0, limit: Limit::Acceleration, cable: None }],
        largest: None,
        nearest: None,
        cables: cables.iter().map(|cable| cable.name.clone()).collect(),
        positions: rows(0),
        velocities: rows(1),
        accelerations: rows(2),
        orientations: None,
        angular_velocities: None,
        angular_accelerations: None,
        cable_lengths: by_cable(&|line, _| line.norm()),
        cable_speeds: by_cable(&|line, v| -line.normalize().dot(v)),
        times,
        tensions: None,
        commands: None,
        angles: None,
        torques: None,
        cable_accelerations: None,
        curve: None,
        timing: None,
    }
}

/// Position, velocity and acceleration at a time, for a motion of 2 s that accelerates and then brakes.
fn state(from: Point, to: Point, time: f64) -> [Vector; 3] {
    let (way, left) = (to - from, 2.0 - time);
    match time <= 1.0 {
        true => [from.coords + way * (time * time / 2.0), way * time, way],
        false => [to.coords - way * (left * left / 2.0), way * left, -way],
    }
}

/// The paper's robot without obstacles.
pub fn empty() -> Scene {
    scene(paper_scene("empty", Vec::new()))
}

/// A checked scene from a spec that is known to be valid.
pub fn scene(spec: SceneSpec) -> Scene {
    Scene::new(spec).expect("a sound scene")
}
