//! The model: platform, obstacles, wheels, tendons, actuators.

use cdpr_core::geometry::{Point, Pose, Vector, wxyz};
use cdpr_core::model::{Cable, Member};
use cdpr_core::wrench::Loads;
use cdpr_core::{Error, Scene};
use nalgebra::{Matrix3, SymmetricEigen};

use super::Control;
use super::bodies::{HALF_THICKNESS, geom};
use super::element::Element;
use super::wheel::Wheel;

/// The longest step of the simulation, s.
const LONGEST_STEP: f64 = 1e-3;

/// The shortest step of the simulation, s.
const SHORTEST_STEP: f64 = 1e-5;

/// Angle of the fastest vibration of the platform on its elastic cables in a step of the simulation, rad; below 2, steps are stable.
const STEP_OF_VIBRATION: f64 = 0.3;

/// MuJoCo needs moments of inertia above 0, none larger than the sum of the others: moments of a thin body are increased by this
/// share of the largest.
const LEAST_SHARE: f64 = 1e-9;

/// Radius of gyration of a platform that is a point, m.
const GYRATION: f64 = 1e-3;

/// Largest force of a cable without tension limits, N.
const ANY_FORCE: f64 = 1e9;

/// Thickness at which cables without diameter are drawn, m.
const DRAWN: f64 = 0.004;

/// A scene as a model, at a pose of the platform.
pub struct Model<'a> {
    scene: &'a Scene,
    control: Control,
    start: Pose,
    mass: f64,
    inertia: Matrix3<f64>,
    timestep: f64,
    /// The constant load of the scene, N and N·m, world axes, about the platform's origin.
    load: Vec<f64>,
    /// Wheels of the pulleys, in the order of the cables.
    pub wheels: Vec<Wheel>,
    /// What the model leaves out or assumes.
    pub notes: Vec<String>,
}

impl<'a> Model<'a> {
    /// The model of a scene with the platform at a pose. `most` is the largest tension of a cable without limits, N.
    ///
    /// # Errors
    /// A platform without mass; lengths as controls of cables that do not stretch.
    pub fn new(scene: &'a Scene, control: Control, start: Pose, most: f64) -> Result<Self, Error> {
        let robot = scene.robot();
        let (Some(mass), Some(given)) = (robot.mass(), robot.inertia()) else {
            return Err(Error::invalid(
                "robot.mass",
                "found none, expected the mass of the platform, which is to move",
            ));
        };
        if let Some(rigid) = robot.cables().iter().find(|cable| cable.stiffness.is_infinite())
            && control == Control::Length
        {
            let problem =
                format!("found \"length\", but {} has no `stiffness`; expected that of all cables", rigid.name);
            return Err(Error::invalid("control", problem));
        }
        let mut model = Model {
            scene,
            control,
            start,
            mass,
            inertia: given,
            timestep: LONGEST_STEP,
            load: Loads::of(scene).load.as_slice().to_vec(),
            wheels: Vec::new(),
            notes: Vec::new(),
        };
        model.note(given);
        model.inertia = with_volume(given, mass);
        model.timestep = model.step();
        let wheel = |(k, cable): (usize, &Cable)| {
            let most = cable.tension.map_or(most, |[_, most]| most);
            Wheel::of(k, cable, &start.place(&cable.attachment), most, model.timestep)
        };
        model.wheels = robot.cables().iter().enumerate().filter_map(wheel).collect();
        if let Some(most) = model.wheels.iter().map(Wheel::inertia).max_by(f64::total_cmp) {
            let note = "the wheels of pulleys swivel with an inertia and a damping that the scene does not give: up to";
            model.notes.push(format!("{note} {most:.1e} kg·m²"));
        }
        Ok(model)
    }

    /// Notes on what the model leaves out or assumes.
    fn note(&mut self, given: Matrix3<f64>) {
        let robot = self.scene.robot();
        let some = |key: &str, has: &dyn Fn(&Cable) -> bool, what: &str| {
            robot.cables().iter().any(has).then(|| format!("`{key}` is not in the model: {what}"))
        };
        let wrench = self.scene.wrench();
        let no_stretch = self.control == Control::Tension;
        let notes = [
            some("linear_density", &|cable| cable.linear_density > 0.0, "cables hang straight, without weight"),
            some("outlet_error", &|cable| cable.outlet_error > 0.0, "outlets are where the scene says"),
            some("drum", &|cable| cable.drum.is_some_and(|_| no_stretch), "the controls are tensions"),
            some("drum", &|cable| cable.drum.is_some() && !no_stretch, "of it, only the `lead` is, in the stretch"),
            some("stiffness", &|cable| no_stretch && cable.stiffness.is_finite(), "the controls are tensions"),
            wrench
                .is_some_and(|wrench| wrench.payload.is_some())
                .then(|| "the platform carries no payload".to_string()),
            wrench
                .and_then(|wrench| wrench.loads.as_ref())
                .filter(|loads| loads.len() > 1)
                .map(|loads| format!("of {} loads, the first acts on the platform", loads.len())),
            robot
                .spec()
                .inertia
                .is_none()
                .then(|| "the robot gives no inertia: that of its parts at uniform density is assumed".to_string()),
            (with_volume(given, self.mass) != given && given.trace() == 0.0)
                .then(|| format!("a point has no inertia: that of a body of {} mm is assumed", 1e3 * GYRATION)),
            robot
                .parts()
                .iter()
                .any(|part| !part.has_volume())
                .then(|| format!("flat parts of the platform are {} mm thick", 2e3 * HALF_THICKNESS)),
        ];
        self.notes.extend(notes.into_iter().flatten());
    }

    /// The step of the simulation that follows the vibrations on elastic cables, s.
    fn step(&self) -> f64 {
        if self.control == Control::Tension {
            return LONGEST_STEP;
        }
        let robot = self.scene.robot();
        let least = SymmetricEigen::new(self.inertia).eigenvalues.min();
        let square = |cable: &Cable| {
            let length = cable.length_to(&self.start.place(&cable.attachment)) + lead(cable);
            let arm = (cable.attachment - robot.center_of_mass()).norm();
            cable.stiffness / length.max(HALF_THICKNESS) * (1.0 / self.mass + arm * arm / least)
        };
        let fastest = robot.cables().iter().map(square).sum::<f64>().sqrt();
        let mut step = LONGEST_STEP;
        while step * fastest > STEP_OF_VIBRATION && step > SHORTEST_STEP {
            step *= 0.5;
        }
        step
    }

    /// A note on wheels that their cables do not turn to the right angle at some of these poses.
    pub fn note_on_wheels(&self, poses: &[Pose]) -> Option<String> {
        let turns = |wheel: &Wheel| {
            let cable = &self.scene.robot().cables()[wheel.index];
            let departures = poses.iter().filter_map(|pose| cable.departure(&pose.place(&cable.attachment)));
            departures.into_iter().all(|departure| wheel.keeps_its_angle(&departure))
        };
        let still = self.wheels.iter().filter(|wheel| !turns(wheel));
        let names: Vec<&str> = still.map(|wheel| &*self.scene.robot().cables()[wheel.index].name).collect();
        let what = "wraps its wheel so little that it may not turn it: lengths may be off by a tenth of the radius";
        (!names.is_empty()).then(|| format!("{}: {what}", names.join(", ")))
    }

    /// By how much each tendon is longer than its cable, m.
    pub fn leads(&self) -> Vec<f64> {
        let mut leads = vec![0.0; self.scene.robot().cables().len()];
        self.wheels.iter().for_each(|wheel| leads[wheel.index] = wheel.lead());
        leads
    }

    /// Number of controls: one for each cable, and one without effect for the constant load, if there is one.
    pub fn controls(&self) -> usize {
        self.scene.robot().cables().len() + usize::from(self.has_load())
    }

    fn has_load(&self) -> bool {
        self.load.iter().any(|x| *x != 0.0)
    }

    /// The model as XML, with a keyframe if there is one.
    pub fn text(&self, key: Option<Element>) -> String {
        let mut names = Names::of(self.scene.obstacles().iter().map(|obstacle| obstacle.name.clone()));
        let mut meshes = Element::new("asset").with_child(sky());
        let mut world = Element::new("worldbody");
        world.push(self.platform(&mut meshes));
        self.obstacles(&mut names, &mut world, &mut meshes);
        let tendons = self.cables(&mut names, &mut world);
        let gravity = self.scene.gravity();
        let option = Element::new("option")
            .with_numbers("timestep", &[self.timestep])
            .with_numbers("gravity", gravity.as_slice())
            .with("integrator", "implicitfast");
        let mut root = Element::new("mujoco").with("model", self.scene.name());
        root = root.with_comment(match self.control {
            Control::Tension => "controls: tension of each cable, N",
            Control::Length => {
                "controls: for each cable 1 / (lead + commanded length), 1/m; lead: that of its drum, or 0"
            }
        });
        root = root.with_comment("lengths in m; cables meet no bodies: check that with cdpr");
        root.push(Element::new("compiler").with("angle", "radian").with("autolimits", "true"));
        root.push(option);
        let light = Element::new("headlight").with("ambient", "0.4 0.4 0.4").with("diffuse", "0.6 0.6 0.6");
        root.push(Element::new("visual").with_child(light));
        for part in [meshes, world, tendons, self.actuators()] {
            root.push(part);
        }
        key.into_iter().for_each(|key| root.push(Element::new("keyframe").with_child(key)));
        root.to_string()
    }

    fn platform(&self, meshes: &mut Element) -> Element {
        let robot = self.scene.robot();
        let place = |element: Element, point: &Point| element.with_numbers("pos", point.coords.as_slice());
        let [xx, yy, zz] = [0, 1, 2].map(|k| self.inertia[(k, k)]);
        let [xy, xz, yz] = [(0, 1), (0, 2), (1, 2)].map(|k| self.inertia[k]);
        let inertial = place(Element::new("inertial"), &robot.center_of_mass())
            .with_numbers("mass", &[self.mass])
            .with_numbers("fullinertia", &[xx, yy, zz, xy, xz, yz]);
        let mut platform = place(Element::new("body").with("name", PLATFORM), &self.start.position)
            .with_numbers("quat", &wxyz(&self.start.orientation))
            .with_child(Element::new("freejoint").with("name", PLATFORM))
            .with_child(inertial);
        for (k, part) in robot.parts().iter().enumerate() {
            let (geom, mesh) = geom(part, &format!("platform {k}"));
            mesh.into_iter().for_each(|mesh| meshes.push(mesh));
            platform.push(geom.with("rgba", "0.25 0.45 0.75 1"));
        }
        if self.has_load() {
            platform.push(Element::new("site").with("name", LOAD));
        }
        for cable in robot.cables() {
            let site = Element::new("site").with("name", format!("attachment {}", cable.name));
            platform.push(place(site, &cable.attachment).with_numbers("size", &[DRAWN]));
        }
        platform
    }

    fn obstacles(&self, names: &mut Names, world: &mut Element, meshes: &mut Element) {
        for (k, obstacle) in self.scene.obstacles().iter().enumerate() {
            let passable = self.scene.pairs().ignores(Member::Platform, Member::Obstacle(k));
            for (part, body) in obstacle.parts.iter().enumerate() {
                let name = match part {
                    0 => obstacle.name.clone(),
                    _ => names.unused(&format!("{} part {}", obstacle.name, part + 1)),
                };
                let (geom, mesh) = geom(body, &format!("obstacle {k} part {part}"));
                mesh.into_iter().for_each(|mesh| meshes.push(mesh));
                let mut geom = geom.with("name", name).with("rgba", "0.6 0.6 0.6 1");
                if passable {
                    geom = geom.with_numbers("contype", &[0.0]).with_numbers("conaffinity", &[0.0]);
                }
                world.push(geom);
            }
        }
    }

    /// The tendons; adds the outlets to the world.
    fn cables(&self, names: &mut Names, world: &mut Element) -> Element {
        let mut tendons = Element::new("tendon");
        if self.has_load() {
            world.push(Element::new("site").with("name", WORLD));
        }
        for (k, cable) in self.scene.robot().cables().iter().enumerate() {
            let site = |what: &str| format!("{what} {}", cable.name);
            let thickness = if cable.diameter > 0.0 { cable.diameter } else { DRAWN };
            let mut tendon =
                Element::new("spatial").with("name", &*cable.name).with_numbers("width", &[0.5 * thickness]);
            tendon = tendon.with("rgba", "0.15 0.15 0.15 1");
            tendon.push(Element::new("site").with("site", site("outlet")));
            match self.wheels.iter().find(|wheel| wheel.index == k) {
                Some(wheel) => {
                    let name = names.unused(&site("wheel"));
                    wheel.elements(&name).into_iter().for_each(|element| world.push(element));
                    tendon.push(wheel.wrap(&name));
                }
                None => {
                    let outlet = Element::new("site").with("name", site("outlet"));
                    world.push(
                        outlet.with_numbers("pos", cable.outlet.coords.as_slice()).with_numbers("size", &[DRAWN]),
                    );
                }
            }
            tendons.push(tendon.with_child(Element::new("site").with("site", site("attachment"))));
        }
        tendons
    }

    fn actuators(&self) -> Element {
        let mut actuators = Element::new("actuator");
        let mut names = Names::of(self.scene.robot().cables().iter().map(|cable| cable.name.clone()));
        for (cable, lead_of_tendon) in self.scene.robot().cables().iter().zip(self.leads()) {
            // A force of an actuator lengthens its tendon; with the gear -1 it is a tension.
            let named = |kind| Element::new(kind).with("name", &*cable.name).with("tendon", &*cable.name);
            let geared = |kind| named(kind).with_numbers("gear", &[-1.0]);
            actuators.push(match self.control {
                Control::Tension => {
                    let most = cable.tension.map_or(ANY_FORCE, |[_, most]| most);
                    geared("motor").with_numbers("ctrlrange", &[0.0, most])
                }
                // Tension E A ((lead + length) u - 1) with the control u = 1 / (lead + commanded length); the actuator's length is
                // minus that of the tendon.
                Control::Length => geared("general")
                    .with("gaintype", "affine")
                    .with_numbers("gainprm", &[cable.stiffness * (lead(cable) - lead_of_tendon), -cable.stiffness, 0.0])
                    .with("biastype", "affine")
                    .with_numbers("biasprm", &[-cable.stiffness, 0.0, 0.0])
                    .with_numbers("forcerange", &[0.0, ANY_FORCE]),
            });
        }
        if self.has_load() {
            actuators.push(
                Element::new("general")
                    .with("name", names.unused(LOAD))
                    .with("site", LOAD)
                    .with("refsite", WORLD)
                    .with_numbers("gear", &self.load)
                    .with_numbers("gainprm", &[0.0])
                    .with("biastype", "affine")
                    .with_numbers("biasprm", &[1.0, 0.0, 0.0]),
            );
        }
        actuators
    }
}

/// Names of the platform's body, of the site and the actuator of a constant load, and of the site at the world's origin.
const PLATFORM: &str = "platform";
const LOAD: &str = "load";
const WORLD: &str = "world";

/// A light background.
fn sky() -> Element {
    let colours = Element::new("texture").with("type", "skybox").with("builtin", "gradient");
    let colours = colours.with("rgb1", "1 1 1").with("rgb2", "0.8 0.85 0.9");
    colours.with_numbers("width", &[64.0]).with_numbers("height", &[384.0])
}

/// The cable between drum and outlet, m.
fn lead(cable: &Cable) -> f64 {
    cable.drum.map_or(0.0, |drum| drum.lead)
}

/// The inertia of a body, or for a body without volume that of one that is hardly thicker.
pub fn with_volume(inertia: Matrix3<f64>, mass: f64) -> Matrix3<f64> {
    let largest = inertia.trace();
    if !(largest > 0.0) {
        return Matrix3::identity() * (mass * GYRATION * GYRATION);
    }
    let moments = Matrix3::identity() * (0.5 * inertia.trace()) - inertia;
    let lacking = LEAST_SHARE * largest - SymmetricEigen::new(moments).eigenvalues.min();
    if lacking > 0.0 { inertia + Matrix3::identity() * (2.0 * lacking) } else { inertia }
}

/// Names that are taken.
struct Names(Vec<String>);

impl Names {
    fn of(taken: impl IntoIterator<Item = String>) -> Self {
        Names(taken.into_iter().collect())
    }

    /// This name, or if it is taken one with a number after it; it is taken from now on.
    fn unused(&mut self, name: &str) -> String {
        let numbered = (2..).map(|k| format!("{name} ({k})"));
        let mut all = std::iter::once(name.to_string()).chain(numbered);
        let free = all.find(|name| !self.0.contains(name)).expect("numbers do not end");
        self.0.push(free.clone());
        free
    }
}

/// The pose at which a scene without a motion is shown: its start, or the middle of its workspace.
pub fn start_of(scene: &Scene) -> Pose {
    let within = scene.workspace();
    let middle = || nalgebra::center(&within.min, &within.max);
    Pose::new(scene.start().unwrap_or_else(middle), scene.end_orientations()[0])
}

/// The velocity and the acceleration of a point at `arm` from the platform's origin, world axes.
pub fn rates_of(motion: &cdpr_core::trajectory::Motion, arm: &Vector) -> [Vector; 2] {
    let (spin, gain) = (motion.angular_velocity, motion.angular_acceleration);
    [motion.velocity + spin.cross(arm), motion.acceleration + gain.cross(arm) + spin.cross(&spin.cross(arm))]
}
