//! Models for MuJoCo: a scene as MJCF, and a motion as arrays for the model.
//!
//! The platform is a free body with the mass, centre of mass and inertia of the robot; obstacles are geoms of the world. Each cable
//! is a spatial tendon with an actuator, both with its name; a pulley is a body that swivels (`wheel`). A constant load of the
//! scene is an actuator of its own, after those of the cables. Cables meet no bodies in MuJoCo.
//!
//! The controls are tensions, N, or for elastic cables the reciprocals of unstretched lengths: the tension of a cable of length l
//! with a lead of a and a commanded length of c is E A ((a + l) / (a + c) − 1), which is linear in 1 / (a + c), and a linear
//! function of a control with factors linear in the length is what an actuator of MuJoCo computes.
//!
//! The arrays, in an .npz file with rows by time: `t`, s; `positions`, m, and `quaternions`, w x y z, of the platform; `lengths`,
//! m, `speeds`, m/s, `tensions`, N, and if they are known `commands`, m, of the cables; `qpos`, `qvel`, `qacc` and `ctrl` of
//! the model, with the platform first, then the wheels. Then `tendon_leads`, m, by which each tendon is longer than its cable,
//! and the names of the `cables`.

mod bodies;
mod element;
mod model;
mod wheel;

use std::path::{Path, PathBuf};

use cdpr_core::geometry::{Point, Pose, Vector, wxyz_in_turn};
use cdpr_core::model::Cable;
use cdpr_core::trajectory::Motion;
use cdpr_core::{Error, Recorded, Scene, choices};

use super::npz::Npz;
use super::output::{check_target, write_atomically};
use super::text::{extension, other_extension};
use element::Element;
use model::{Model, rates_of, start_of};

/// What the controls of a model are.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Control {
    /// Tensions, N.
    #[default]
    Tension,
    /// Reciprocals of unstretched lengths, 1/m.
    Length,
}

choices!(Control, "control", [
    Tension = "tension": "the tension of each cable, N",
    Length = "length": "for each cable 1 / (lead + commanded length), 1/m; it stretches by its `stiffness`",
]);

/// A model for MuJoCo.
#[derive(Debug, Clone, PartialEq)]
pub struct Mjcf {
    /// The model as XML.
    pub model: String,
    /// The motion as the bytes of an .npz file.
    pub motion: Option<Vec<u8>>,
    /// Number of wheels.
    pub wheels: usize,
    /// What the model leaves out or assumes.
    pub notes: Vec<String>,
}

/// A scene, at its orientation, as a model for MuJoCo; and a motion, which must have tensions, with its cables in the order of the
/// robot. The model begins where the motion does, or at the start of the scene.
///
/// # Errors
/// A platform without mass, a motion without tensions, lengths as controls of cables that do not stretch.
///
/// # Example
/// ```
/// use cdpr_core::testing;
/// use cdpr_files::{Control, mjcf};
/// let made = mjcf(&testing::empty(), None, Control::Tension)?;
/// assert!(made.model.contains("<spatial name=\"cable 7\"") && made.motion.is_none());
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn mjcf(scene: &Scene, motion: Option<&Recorded>, control: Control) -> Result<Mjcf, Error> {
    let tensions = match motion.map(|motion| &motion.tensions) {
        Some(None) => {
            let problem = "found none in the motion, expected that of each cable";
            let hint = "give the robot its `mass` and each cable its `tension`, and time the path again".to_string();
            return Err(Error::invalid("tension", problem).with_hints(&[hint]));
        }
        Some(Some(tensions)) => Some(tensions),
        None => None,
    };
    let start = motion.map_or_else(|| start_of(scene), |motion| motion.poses(scene.orientation())[0]);
    let weight = scene.robot().mass().unwrap_or_default() * scene.gravity().norm();
    let most = tensions.into_iter().flatten().flatten().fold(weight, |most, tension| most.max(*tension));
    let mut model = Model::new(scene, control, start, most)?;
    let poses = motion.map_or_else(|| vec![start], |motion| motion.poses(scene.orientation()));
    model.notes.extend(model.note_on_wheels(&poses));
    let rows = motion.zip(tensions).map(|(motion, tensions)| Rows::of(scene, &model, motion, tensions, control));
    let rows = rows.transpose()?;
    let text = model.text(rows.as_ref().map(Rows::key));
    let motion = rows.map(|rows| rows.npz(scene, &model)).transpose();
    let motion = motion.map_err(|e| Error::internal(format!("an .npz file in memory: {e}")))?;
    Ok(Mjcf { model: text, motion, wheels: model.wheels.len(), notes: model.notes })
}

/// The file of the motion of a model: of the same name, with the extension `.npz`.
///
/// # Example
/// ```
/// assert_eq!(cdpr_files::motion_of_mjcf("a/model.xml").to_str(), Some("a/model.npz"));
/// ```
pub fn motion_of_mjcf(path: impl AsRef<Path>) -> PathBuf {
    path.as_ref().with_extension("npz")
}

/// Checks the extension of a model; call this before doing any work.
///
/// # Errors
/// Another extension than `.xml`.
pub fn check_mjcf_name(path: impl AsRef<Path>) -> Result<(), Error> {
    let path = path.as_ref();
    match extension(path).as_deref() {
        Some("xml") => Ok(()),
        _ => Err(other_extension(path, ".xml")),
    }
}

/// Writes a model, and its motion beside it ([`motion_of_mjcf`]).
///
/// # Errors
/// Another extension than `.xml`, or a file that cannot be written; then neither is.
pub fn save_mjcf(path: impl AsRef<Path>, mjcf: &Mjcf) -> Result<(), Error> {
    let path = path.as_ref();
    check_mjcf_name(path)?;
    check_target(path)?;
    if let Some(motion) = &mjcf.motion {
        write_atomically(motion_of_mjcf(path), motion)?;
    }
    write_atomically(path, mjcf.model.as_bytes())
}

/// A motion as rows for a model, one for each time.
struct Rows {
    times: Vec<f64>,
    poses: Vec<Pose>,
    lengths: Vec<Vec<f64>>,
    speeds: Vec<Vec<f64>>,
    tensions: Vec<Vec<f64>>,
    commands: Option<Vec<Vec<f64>>>,
    /// Joints of the model: positions, velocities, accelerations.
    joints: [Vec<Vec<f64>>; 3],
    controls: Vec<Vec<f64>>,
}

impl Rows {
    fn of(
        scene: &Scene,
        model: &Model,
        motion: &Recorded,
        tensions: &[Vec<f64>],
        control: Control,
    ) -> Result<Self, Error> {
        let robot = scene.robot();
        let motions = motion.motions(scene.orientation());
        let computed =
            |of: &dyn Fn(&Motion) -> Result<Vec<f64>, Error>| motions.iter().map(of).collect::<Result<Vec<_>, _>>();
        let windings = |now: &Motion, of: fn(f64, &Vector, &Vector) -> f64| -> Result<Vec<f64>, Error> {
            let winding = |cable: &Cable| {
                let arm = now.orientation * cable.attachment.coords;
                let found =
                    cable.departure(&(now.position + arm)).map(|to| of(to.length, &to.pull, &rates_of(now, &arm)[0]));
                let problem = || format!("{}: found an attachment that its pulley cannot reach", cable.name);
                found.ok_or_else(|| Error::invalid("length", problem()))
            };
            robot.cables().iter().map(winding).collect()
        };
        let lengths = match &motion.cable_lengths {
            Some(lengths) => lengths.clone(),
            None => computed(&|now| windings(now, |length, _, _| length))?,
        };
        let speeds = match &motion.cable_speeds {
            Some(speeds) => speeds.clone(),
            None => computed(&|now| windings(now, |_, pull, velocity| -pull.dot(velocity)))?,
        };
        let commands = motion.winches.commands.clone();
        let commands = commands.or_else(|| robot.commands_at_each(&lengths, Some(tensions)).commands);
        let controls: Vec<Vec<f64>> = match (control, &commands) {
            (Control::Length, Some(commands)) => {
                let leads = robot.cables().iter().map(|cable| cable.drum.map_or(0.0, |drum| drum.lead));
                let leads: Vec<f64> = leads.collect();
                let row =
                    |row: &Vec<f64>| row.iter().zip(&leads).map(|(command, lead)| 1.0 / (lead + command)).collect();
                commands.iter().map(row).collect()
            }
            _ => tensions.to_vec(),
        };
        let filled = |mut row: Vec<f64>| {
            row.resize(model.controls(), 0.0);
            row
        };
        Ok(Rows {
            times: motion.times.clone(),
            poses: motion.poses(scene.orientation()),
            lengths,
            speeds,
            tensions: tensions.to_vec(),
            commands,
            joints: joints(scene, model, &motions),
            controls: controls.into_iter().map(filled).collect(),
        })
    }

    /// The keyframe of the first row.
    fn key(&self) -> Element {
        let [positions, velocities, _] = &self.joints;
        Element::new("key")
            .with("name", "start")
            .with_numbers("qpos", &positions[0])
            .with_numbers("qvel", &velocities[0])
            .with_numbers("ctrl", &self.controls[0])
    }

    fn npz(&self, scene: &Scene, model: &Model) -> std::io::Result<Vec<u8>> {
        let mut npz = Npz::new();
        let n = self.times.len() as u64;
        let mut table = |name: &str, rows: &[Vec<f64>]| npz.numbers(name, &[n, rows[0].len() as u64], &rows.concat());
        let of_poses = |of: fn(&Pose) -> Vec<f64>| self.poses.iter().map(of).collect::<Vec<_>>();
        table("positions", &of_poses(|pose| pose.position.coords.as_slice().to_vec()))?;
        let turns: Vec<Vec<f64>> = self.joints[0].iter().map(|row| row[3..7].to_vec()).collect();
        table("quaternions", &turns)?;
        table("lengths", &self.lengths)?;
        table("speeds", &self.speeds)?;
        table("tensions", &self.tensions)?;
        if let Some(commands) = &self.commands {
            table("commands", commands)?;
        }
        for (name, rows) in ["qpos", "qvel", "qacc"].iter().zip(&self.joints) {
            table(name, rows)?;
        }
        table("ctrl", &self.controls)?;
        npz.numbers("t", &[n], &self.times)?;
        let leads = model.leads();
        npz.numbers("tendon_leads", &[leads.len() as u64], &leads)?;
        let cables = scene.robot().cable_names();
        npz.texts("cables", &[cables.len() as u64], &cables)?;
        npz.finish()
    }
}

/// Positions, velocities and accelerations of the joints of the model: the platform's origin, in world axes, and its rotation, as a
/// quaternion and as rates in its own axes; then the angles of the wheels.
fn joints(scene: &Scene, model: &Model, motions: &[Motion]) -> [Vec<Vec<f64>>; 3] {
    let cables = scene.robot().cables();
    let mut angles = vec![0.0; model.wheels.len()];
    let mut rows: [Vec<Vec<f64>>; 3] = Default::default();
    let turns = wxyz_in_turn(motions.iter().map(|now| &now.orientation));
    for (now, turn) in motions.iter().zip(&turns) {
        let own = |v: &Vector| now.orientation.inverse_transform_vector(v);
        let platform = |linear: &Vector, turning: Vector| [linear.as_slice(), turning.as_slice()].concat();
        let mut row = [
            [now.position.coords.as_slice(), turn].concat(),
            platform(&now.velocity, own(&now.angular_velocity)),
            platform(&now.acceleration, own(&now.angular_acceleration)),
        ];
        for (wheel, angle) in model.wheels.iter().zip(&mut angles) {
            let arm = now.orientation * cables[wheel.index].attachment.coords;
            let [velocity, acceleration] = rates_of(now, &arm);
            let place: Point = now.position + arm;
            let found = wheel.angle(&place, [&velocity, &acceleration], *angle);
            *angle = found[0];
            row.iter_mut().zip(found).for_each(|(row, x)| row.push(x));
        }
        rows.iter_mut().zip(row).for_each(|(rows, row)| rows.push(row));
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use cdpr_core::geometry::Rotation;
    use cdpr_core::model::spec::{
        BodySpec, CableSpec, DrumSpec, InertiaSpec, PulleySpec, RobotSource, RobotSpec, SceneSpec,
    };
    use cdpr_core::testing::{hard1, moving};
    use model::with_volume;
    use nalgebra::Matrix3;
    use roxmltree::Document;

    /// A scene, and a motion in it with a tension of 7 N in each cable.
    fn given() -> (Scene, Recorded) {
        let scene = hard1();
        let motion = moving(&scene, Point::new(0.3, 1.0, 0.3), Point::new(0.3, 1.0, 1.3), 4);
        let mut motion = Recorded::of(&motion).unwrap();
        motion.tensions = Some(vec![vec![7.0; scene.robot().cables().len()]; motion.times.len()]);
        (scene, motion)
    }

    #[test]
    fn cables_and_obstacles_have_their_names() {
        let (scene, motion) = given();
        let made = mjcf(&scene, Some(&motion), Control::Tension).unwrap();
        let document = Document::parse(&made.model).unwrap();
        let named = |kind: &str, key: &str| -> Vec<&str> {
            document
                .descendants()
                .filter(|node| node.has_tag_name(kind))
                .filter_map(|node| node.attribute(key))
                .collect()
        };
        assert_eq!(named("spatial", "name"), scene.robot().cable_names());
        assert_eq!(named("motor", "tendon"), scene.robot().cable_names());
        let obstacles: Vec<&str> = scene.obstacles().iter().map(|obstacle| &*obstacle.name).collect();
        assert_eq!(named("geom", "name"), obstacles);
        assert_eq!(named("body", "pos"), ["0.3 1 0.3"]);
        assert_eq!(named("key", "ctrl"), ["7 7 7 7 7 7 7 7"]);
        assert_eq!((made.wheels, named("inertial", "mass")), (0, vec!["10"]));
    }

    #[test]
    fn a_model_begins_at_the_start_of_the_scene_without_a_motion() {
        let (scene, _) = given();
        let made = mjcf(&scene, None, Control::Tension).unwrap();
        assert_eq!(made.motion, None);
        assert!(made.model.contains("<body name=\"platform\" pos=\"0.3 1 0.3\""), "{}", made.model);
        assert!(!made.model.contains("<key"));
    }

    #[test]
    fn what_is_missing_is_named() {
        let (scene, mut motion) = given();
        let said = |scene, motion, control| mjcf(scene, motion, control).unwrap_err().to_string();
        assert!(said(&scene, None, Control::Length).contains("cable 0 has no `stiffness`"));
        motion.tensions = None;
        assert!(said(&scene, Some(&motion), Control::Tension).contains("tension: found none in the motion"));
        let robot = RobotSpec { mass: None, ..scene.robot().spec().clone() };
        let light = Scene::new(SceneSpec { robot: RobotSource::Inline(robot), ..scene.spec().clone() }).unwrap();
        assert!(said(&light, None, Control::Tension).contains("robot.mass: found none"));
    }

    /// A scene with cables that stretch, drums with leads, pulleys from the third cable on, an inertia with products, and an obstacle that
    /// the platform may pass through; and a turning motion of 0.2 ms, whose rates are constant accelerations, with 7 N to 14 N.
    fn elastic() -> (Scene, Recorded) {
        let (scene, mut motion) = given();
        let mut robot = scene.robot().spec().clone();
        for (k, cable) in robot.cables.iter_mut().enumerate() {
            cable.stiffness = Some(1e4 * (1.0 + k as f64));
            cable.drum = Some(DrumSpec { radius: 0.05, gear: None, zero: None, lead: Some(0.5 + 0.1 * k as f64) });
            cable.pulley = (k >= 2).then_some(PulleySpec { radius: 0.03, axis: [0.0, 0.0, 1.0] });
        }
        robot.inertia = Some(InertiaSpec::Tensor([[0.3, 0.01, 0.02], [0.01, 0.4, 0.03], [0.02, 0.03, 0.5]]));
        let ignore = vec![["platform".to_string(), "pillar".to_string()]];
        let spec = SceneSpec { robot: RobotSource::Inline(robot), ignore, ..scene.spec().clone() };
        let scene = Scene::new(spec).unwrap();
        let axis = Vector::new(0.36, 0.48, 0.8);
        let (velocity, gain) = (Vector::new(0.3, -0.2, 0.5), Vector::new(1.0, 2.0, -1.0));
        motion.times = (0..3).map(|k| 1e-4 * f64::from(k)).collect();
        let rows = |of: &dyn Fn(f64) -> Vector| motion.times.iter().map(|t| of(*t)).collect::<Vec<_>>();
        let positions = rows(&|t| Vector::new(0.3, 1.0, 0.8) + velocity * t + gain * (0.5 * t * t));
        let turns = rows(&|t| axis * (0.4 + 0.7 * t + 0.75 * t * t));
        motion.velocities = Some(rows(&|t| velocity + gain * t));
        motion.accelerations = Some(rows(&|_| gain));
        motion.angular_velocities = Some(rows(&|t| axis * (0.7 + 1.5 * t)));
        motion.angular_accelerations = Some(rows(&|_| axis * 1.5));
        // The motion begins turned about another axis, so that its own axes are not those of the world.
        let first = Rotation::from_scaled_axis(Vector::new(0.5, 0.0, -0.3));
        motion.positions = positions.into_iter().map(Point::from).collect();
        motion.orientations = Some(turns.into_iter().map(|turn| Rotation::from_scaled_axis(turn) * first).collect());
        (motion.cable_lengths, motion.cable_speeds, motion.cable_accelerations) = (None, None, None);
        motion.tensions = Some(vec![(0..8).map(|k| 7.0 + f64::from(k)).collect(); 3]);
        (scene, motion)
    }

    fn rows(scene: &Scene, motion: &Recorded, control: Control) -> (String, Vec<f64>, Rows) {
        let model = Model::new(scene, control, motion.poses(scene.orientation())[0], 0.0).unwrap();
        let rows = Rows::of(scene, &model, motion, motion.tensions.as_ref().unwrap(), control).unwrap();
        (model.text(None), model.leads(), rows)
    }

    fn numbers(node: &roxmltree::Node, name: &str) -> Vec<f64> {
        node.attribute(name).unwrap().split(' ').map(|number| number.parse().unwrap()).collect()
    }

    #[test]
    fn actuators_pull_with_the_tensions_of_the_motion() {
        let (scene, motion) = elastic();
        let (text, leads, rows) = rows(&scene, &motion, Control::Length);
        let document = Document::parse(&text).unwrap();
        let actuators = document.descendants().filter(|node| node.has_tag_name("general"));
        assert_eq!(actuators.clone().count(), 8);
        for (k, actuator) in actuators.enumerate() {
            let [gear, gain, bias] = ["gear", "gainprm", "biasprm"].map(|name| numbers(&actuator, name));
            let length = gear[0] * (rows.lengths[1][k] + leads[k]);
            let force = (gain[0] + gain[1] * length) * rows.controls[1][k] + bias[0] + bias[1] * length;
            // MuJoCo's forces lengthen a tendon.
            assert!((-gear[0] * force - rows.tensions[1][k]).abs() < 1e-9, "{k}: {force}");
        }
        // With tensions as controls, the limits are those of the cables.
        let text = mjcf(&scene, None, Control::Tension).unwrap().model;
        let document = Document::parse(&text).unwrap();
        for (motor, cable) in
            document.descendants().filter(|node| node.has_tag_name("motor")).zip(scene.robot().cables())
        {
            assert_eq!(
                (numbers(&motor, "gear"), numbers(&motor, "ctrlrange")),
                (vec![-1.0], vec![0.0, cable.tension.unwrap()[1]])
            );
        }
    }

    #[test]
    fn rates_are_derivatives() {
        let (scene, motion) = elastic();
        let (_, leads, rows) = rows(&scene, &motion, Control::Tension);
        assert_eq!(
            leads.iter().map(|lead| *lead > 0.0).collect::<Vec<_>>(),
            [false, false, true, true, true, true, true, true]
        );
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-5 * (1.0 + b.abs()), "{a} {b}");
        let slope = |rows: &[Vec<f64>], j: usize| (rows[2][j] - rows[0][j]) / 2e-4;
        for j in 0..8 {
            near(rows.speeds[1][j], slope(&rows.lengths, j));
        }
        let [qpos, qvel, qacc] = &rows.joints;
        assert_eq!((qpos[0].len(), qvel[0].len(), qacc[0].len()), (13, 12, 12));
        for j in (0..3).chain(6..12) {
            near(qvel[1][j], slope(qpos, if j < 3 { j } else { j + 1 }));
        }
        for j in 0..12 {
            near(qacc[1][j], slope(qvel, j));
        }
        let turn = motion.orientations.as_ref().unwrap();
        let own = (turn[0].inverse() * turn[2]).scaled_axis() / 2e-4;
        (0..3).for_each(|j| near(qvel[1][3 + j], own[j]));
    }

    #[test]
    fn the_platform_has_the_inertia_of_the_robot_and_passes_what_it_may() {
        let (scene, motion) = elastic();
        let text = mjcf(&scene, Some(&motion), Control::Length).unwrap().model;
        let document = Document::parse(&text).unwrap();
        let first = |name: &str| document.descendants().find(|node| node.has_tag_name(name)).unwrap();
        assert_eq!(numbers(&first("inertial"), "fullinertia"), [0.3, 0.4, 0.5, 0.01, 0.02, 0.03]);
        let geom = |text: &str| {
            let document = Document::parse(text).unwrap();
            let geom = document.descendants().find(|node| node.attribute("name") == Some("pillar")).unwrap();
            geom.attribute("contype").map(str::to_string)
        };
        assert_eq!(
            (geom(&text).as_deref(), geom(&mjcf(&hard1(), None, Control::Tension).unwrap().model)),
            (Some("0"), None)
        );
    }

    #[test]
    fn a_step_turns_the_fastest_vibration_by_at_most_three_tenths() {
        // A point mass of 2 kg in the middle of the workspace, with four cables of 5 m and leads of 1 m: its stiffness is at most the
        // sum, 4 E A / 6 m, and turns of a body of 1 mm add none at its centre.
        for (stiffness, steps) in [(3e4, 1), (3e5, 2), (3e6, 4)] {
            let cable = |outlet: [f64; 3]| CableSpec {
                outlet,
                stiffness: Some(stiffness),
                drum: Some(DrumSpec { radius: 0.05, gear: None, zero: None, lead: Some(1.0) }),
                tension: Some([1.0, 1e4]),
                ..CableSpec::default()
            };
            let outlets = [[6.0, 1.0, 1.0], [-4.0, 1.0, 1.0], [1.0, 4.0, 5.0], [1.0, -2.0, 5.0]];
            let mut robot = hard1().robot().spec().clone();
            robot.cables = outlets.map(cable).to_vec();
            robot.platform = vec![BodySpec { vertices: Some(vec![[0.0; 3]]), ..BodySpec::default() }];
            robot.mass = Some(2.0);
            let spec = SceneSpec {
                robot: RobotSource::Inline(robot),
                obstacles: Vec::new(),
                query: None,
                ..hard1().spec().clone()
            };
            let model = mjcf(&Scene::new(spec).unwrap(), None, Control::Length).unwrap().model;
            let document = Document::parse(&model).unwrap();
            let option = document.descendants().find(|node| node.has_tag_name("option")).unwrap();
            let step = numbers(&option, "timestep")[0];
            assert_eq!(step, 1e-3 / f64::from(steps), "{stiffness}: {}", step * (4.0 * stiffness / 6.0 / 2.0).sqrt());
        }
    }

    #[test]
    fn flat_bodies_get_moments_that_mujoco_accepts() {
        let flat = Matrix3::from_diagonal(&Vector::new(1.0, 2.0, 3.0));
        let found = with_volume(flat, 1.0);
        let [x, y, z] = [0, 1, 2].map(|k| found[(k, k)]);
        assert!(x + y > z && (found - flat).norm() < 1e-7, "{found}");
        let thick = Matrix3::from_diagonal(&Vector::new(2.0, 2.0, 3.0));
        assert_eq!(with_volume(thick, 1.0), thick);
        assert_eq!(with_volume(Matrix3::zeros(), 2.0), Matrix3::identity() * 2e-6);
    }
}
