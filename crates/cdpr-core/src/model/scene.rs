//! A checked scene: robot, obstacles, workspace and planning query.

mod changed;

use std::sync::Arc;

use std::collections::{HashMap, HashSet};

use super::body;
use super::envelope::{Envelope, envelopes};
use super::load_case;
use super::most_tension::{most_tension, unlimited_note};
use super::obstacle::{Obstacle, obstacles};
use super::obstacle_seams::obstacle_seams;
use super::pairs::{Member, PairRules};
use super::payloads::Payloads;
use super::query::{Asked, Names, Station};
use super::robot::Robot;
use super::spec::{
    BodySpec, Distribution, FORMAT_VERSION, GRAVITY, OrientationSource, PLATFORM, PositionSource, QuerySpec,
    RobotSource, SceneSpec, TurningSpec, WrenchSpec,
};
use crate::error::Error;
use crate::fingerprint::fingerprint_of;
use crate::geometry::seam::Seam;
use crate::geometry::{Aabb, Point, Pose, Rotation, Vector, wxyz};
use crate::limits::{LEAST_EXTENT, MOST_BODIES};
use crate::tolerances::{ON_SURFACE, SAME_TURN};
use crate::words::small_length;

/// A checked scene. Immutable; made by [`Scene::new`].
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    spec: Arc<SceneSpec>,
    pub(super) payloads: Option<Arc<Payloads>>,
    robot: Arc<Robot>,
    obstacles: Arc<[Obstacle]>,
    seams: Arc<[Seam]>,
    workspace: Aabb,
    envelopes: Arc<[Option<Arc<Envelope>>]>,
    asked: Asked,
    pairs: Arc<PairRules>,
    notes: Vec<String>,
    good_notes: Vec<String>,
    alike: Vec<AlikeNotes>,
}

/// Notes of one kind, about many bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct AlikeNotes {
    /// The sentence printed in place of the notes.
    pub sentence: String,
    /// The notes that the sentence replaces.
    pub notes: Vec<String>,
}

impl Scene {
    /// Checks a scene with an inline robot.
    ///
    /// # Errors
    /// Invalid values; the error names the key, what was found and what was expected. A start or goal in collision is
    /// not an error: only planning checks the query.
    pub fn new(spec: SceneSpec) -> Result<Self, Error> {
        if spec.payloads.is_empty() && spec.task.is_empty() {
            return Scene::of_bodies(spec);
        }
        let (payloads, plain) = Payloads::of(spec.clone(), &robot_of(&spec)?)?;
        Ok(Scene { payloads: Some(payloads.into()), ..Scene::of_bodies(plain)? })
    }

    /// Checks a scene without payloads.
    fn of_bodies(spec: SceneSpec) -> Result<Self, Error> {
        let robot = robot_of(&spec)?;
        body::optional_name("name", spec.name.as_deref())?;
        body::coordinates("gravity", &spec.gravity.unwrap_or_default())?;
        if let Some(wrench) = &spec.wrench {
            body::sound_wrench(wrench).map_err(|e| e.under("wrench"))?;
        }
        if let Some(turning) = &spec.turning {
            body::sound_turns(turning).map_err(|e| e.under("turning"))?;
        }
        if let Some(motion) = &spec.motion {
            body::sound_motion(*motion).map_err(|e| e.under("motion"))?;
        }
        let workspace = workspace(&spec)?;
        body::at_most("obstacles", spec.obstacles.len(), MOST_BODIES)?;
        let obstacles = obstacles(&spec.obstacles, &robot)?;
        let pairs = PairRules::new(&spec, &robot, &obstacles)?;
        let seams = obstacle_seams(&obstacles, &pairs);
        outlets_outside(&robot, &obstacles, &seams)?;
        let envelopes = envelopes(&robot, &workspace, &spec.gravity.unwrap_or(GRAVITY).into())?;
        let names = Arc::new(Names::new(&spec)?);
        let asked = Asked::new(spec.query.as_ref(), spec.turning.is_some(), names)?;
        let mut notes = degrees_hints(&spec, &robot);
        let (robot, unlimited) = match most_tension(&spec, &robot) {
            Some(most) => {
                let (robot, lowered) = robot.with_most_tension(most);
                (robot, unlimited_note(&lowered, most))
            }
            None => (robot, None),
        };
        notes.extend(unlimited);
        notes.extend(spec.wrench.as_ref().and_then(load_case::note));
        Ok(Scene {
            spec: spec.into(),
            payloads: None,
            robot: robot.into(),
            obstacles: obstacles.into(),
            seams: seams.into(),
            workspace,
            envelopes: envelopes.into_iter().map(|envelope| envelope.map(Arc::new)).collect(),
            asked,
            pairs: pairs.into(),
            notes,
            good_notes: Vec::new(),
            alike: Vec::new(),
        })
    }

    /// This scene with additional notes.
    pub fn with_notes(mut self, notes: Vec<String>) -> Self {
        self.notes.extend(notes);
        self
    }

    /// This scene with additional notes that need no warning.
    pub fn with_good_notes(mut self, notes: Vec<String>) -> Self {
        self.good_notes.extend(notes);
        self
    }

    /// A copy of the scene in which these notes are printed as one sentence each.
    pub fn with_alike(mut self, alike: Vec<AlikeNotes>) -> Self {
        self.alike.extend(alike);
        self
    }

    /// A copy of the scene with the notes of another one, from which it was made.
    pub fn with_notes_of(self, other: &Scene) -> Self {
        let Scene { notes, good_notes, alike, .. } = other.clone();
        Scene { notes, good_notes, alike, ..self }
    }

    /// Notes as they are printed: one sentence in place of all that are alike, if all of these are among them.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::model::AlikeNotes;
    /// let [notes, others] = [["a.stl: open", "b.stl: open"], ["a.stl: open", "far"]].map(|notes| notes.map(String::from));
    /// let alike = AlikeNotes { sentence: "2 meshes are open".to_string(), notes: notes.to_vec() };
    /// let scene = cdpr_core::testing::empty().with_alike(vec![alike]);
    /// assert_eq!(scene.in_brief(&notes), ["2 meshes are open"]);
    /// assert_eq!(scene.in_brief(&others), others);
    /// ```
    pub fn in_brief(&self, notes: &[String]) -> Vec<String> {
        let given: HashSet<&String> = notes.iter().collect();
        let whole = self.alike.iter().filter(|alike| alike.notes.iter().all(|note| given.contains(note)));
        let kinds: HashMap<&String, &AlikeNotes> =
            whole.flat_map(|alike| alike.notes.iter().map(move |note| (note, alike))).collect();
        let printed = notes.iter().filter_map(|note| match kinds.get(note) {
            None => Some(note),
            Some(alike) => (alike.notes[0] == *note).then_some(&alike.sentence),
        });
        printed.cloned().collect()
    }

    /// The notes that need no warning.
    pub fn good_notes(&self) -> &[String] {
        &self.good_notes
    }

    /// Notes for the user on how the scene was read: defects of meshes, and how far the convex parts that replace a
    /// mesh extend beyond it.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// The scene as plain data with an inline robot; payloads are among the obstacles or the parts of the platform.
    pub fn spec(&self) -> &SceneSpec {
        &self.spec
    }

    /// The name of the scene, or "scene".
    pub fn name(&self) -> &str {
        self.spec.name.as_deref().unwrap_or("scene")
    }

    /// The robot of the scene.
    pub fn robot(&self) -> &Robot {
        &self.robot
    }

    /// Obstacles by name, in order of first appearance.
    pub fn obstacles(&self) -> &[Obstacle] {
        &self.obstacles
    }

    /// Bodies that close the seams between obstacle parts, of the same obstacle or of several; the field `between` of
    /// each lists the obstacles.
    pub fn seams(&self) -> &[Seam] {
        &self.seams
    }

    /// The box in which every platform vertex must stay.
    pub fn workspace(&self) -> &Aabb {
        &self.workspace
    }

    /// For each cable all shapes that it can take, if it is not a straight line from its outlet.
    pub fn envelopes(&self) -> &[Option<Arc<Envelope>>] {
        &self.envelopes
    }

    /// World-from-platform rotation: the one selected by the query, else the first of the named orientations, else the
    /// identity.
    pub fn orientation(&self) -> &Rotation {
        &self.asked.orientation
    }

    /// Whether an orientation equals that of the scene.
    pub fn has_orientation(&self, orientation: &Rotation) -> bool {
        orientation.angle_to(&self.asked.orientation) <= SAME_TURN
    }

    /// Whether all these poses have the orientation of the scene.
    pub fn keeps_orientation(&self, poses: &[Pose]) -> bool {
        poses.iter().all(|pose| self.has_orientation(&pose.orientation))
    }

    /// The name of the scene's orientation, if it is one of the named orientations.
    pub fn orientation_name(&self) -> Option<&str> {
        self.name_of_orientation(&self.asked.orientation)
    }

    /// The name of an orientation, if it is one of the named orientations.
    pub fn name_of_orientation(&self, orientation: &Rotation) -> Option<&str> {
        let same = |other: &Rotation| orientation.angle_to(other) <= SAME_TURN;
        self.asked.names.orientations.iter().find(|(_, other)| same(other)).map(|(name, _)| name.as_str())
    }

    /// The named orientations.
    pub fn orientations(&self) -> &[(String, Rotation)] {
        &self.asked.names.orientations
    }

    /// Whether the orientation is fixed: the query or its stations select one, or there is only one named orientation.
    pub fn orientation_is_fixed(&self) -> bool {
        self.asked.names.orientations.len() == 1 || self.asked.selects
    }

    /// This scene at another orientation.
    ///
    /// # Errors
    /// An unknown name, or a quaternion that does not have length 1.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::model::OrientationSource;
    /// let upside_down = cdpr_core::testing::hard1().turned([0.0, 1.0, 0.0, 0.0].into())?;
    /// assert!((upside_down.orientation().angle() - std::f64::consts::PI).abs() < 1e-12);
    /// let unknown = OrientationSource::Named("tilted".to_string());
    /// assert!(upside_down.turned(unknown).unwrap_err().to_string().contains("found \"tilted\""));
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn turned(&self, source: OrientationSource) -> Result<Scene, Error> {
        self.asked.names.orientation("orientation", &source)?;
        self.clone().asking(|query| query.orientation = Some(source))
    }

    /// This scene with another query. What stands where, and where a task begins, may depend on it.
    fn asking(mut self, change: impl FnOnce(&mut QuerySpec)) -> Result<Scene, Error> {
        if self.payloads.is_some() {
            let mut spec = self.written().clone();
            change(spec.query.get_or_insert_default());
            return Ok(Scene::new(spec)?.with_notes_of(&self));
        }
        let spec = Arc::make_mut(&mut self.spec);
        change(spec.query.get_or_insert_default());
        self.asked = Asked::new(spec.query.as_ref(), spec.turning.is_some(), self.asked.names)?;
        Ok(self)
    }

    /// This scene with other tensions of its robot; it has the same fingerprint.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::model::Distribution;
    /// let scene = cdpr_core::testing::empty();
    /// let least = scene.with_tensions(Distribution::Least);
    /// assert_eq!(least.robot().distribution(), Distribution::Least);
    /// assert_eq!(least.fingerprint(), scene.fingerprint());
    /// ```
    pub fn with_tensions(&self, chosen: Distribution) -> Scene {
        let mut scene = self.clone();
        scene.robot = Arc::new((*self.robot).clone().with_tensions(chosen));
        let written = scene.payloads.as_mut().map(|payloads| &mut Arc::make_mut(payloads).spec);
        for spec in [Arc::make_mut(&mut scene.spec)].into_iter().chain(written) {
            if let RobotSource::Inline(robot) = &mut spec.robot {
                robot.tension_distribution = Some(chosen);
            }
        }
        scene
    }

    /// This scene with another start and goal, or without them.
    ///
    /// # Errors
    /// A position that is not finite, or an unknown station.
    pub fn between(self, [start, goal]: [Option<PositionSource>; 2]) -> Result<Scene, Error> {
        self.asking(|query| (query.start, query.goal) = (start, goal))
    }

    /// The named positions of the platform.
    pub fn stations(&self) -> &[Station] {
        &self.asked.names.stations
    }

    /// A position from the name of a station, with the orientation there, or from coordinates.
    ///
    /// # Errors
    /// An unknown name, or coordinates that are not finite; the error is at `place`.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::model::{PositionSource, Scene, SceneSpec, StationSpec};
    /// let rack = StationSpec { name: "rack".to_string(), position: [1.7, 1.0, 0.5], orientation: None };
    /// let scene = Scene::new(SceneSpec { stations: vec![rack], ..cdpr_core::testing::hard1().spec().clone() })?;
    /// let (at, _) = scene.named_position("goal", &PositionSource::Named("rack".to_string()))?;
    /// assert_eq!(at.x, 1.7);
    /// let unknown = scene.named_position("goal", &PositionSource::Named("reck".to_string())).unwrap_err();
    /// assert!(unknown.to_string().ends_with("(rack); did you mean \"rack\"?"));
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn named_position(&self, place: &str, source: &PositionSource) -> Result<(Point, Option<Rotation>), Error> {
        self.asked.names.position(place, source)
    }

    /// The query with positions and orientations in place of the names of stations.
    pub fn located_query(&self) -> Option<QuerySpec> {
        self.asked.spec(self.spec.query.as_ref())
    }

    /// Whether the scene lists several orientations and selects none.
    pub fn orientation_is_open(&self) -> bool {
        !self.orientation_is_fixed() && !self.asked.names.orientations.is_empty()
    }

    /// Whether the orientation of another scene is that of this one or, if this one selects none, one of its named
    /// orientations.
    pub fn has_orientation_of(&self, other: &Scene) -> bool {
        let same = |turn: &Rotation| other.asked.orientation.angle_to(turn) <= SAME_TURN;
        same(&self.asked.orientation)
            || (!self.orientation_is_fixed() && self.asked.names.orientations.iter().any(|(_, turn)| same(turn)))
    }

    /// The scene for a path with the given orientation, if any. If the scene selects none, the result is at the path's
    /// orientation.
    ///
    /// # Errors
    /// The scene selects a different orientation, or neither path nor scene selects one although the scene lists some.
    pub fn for_path_at(&self, said: Option<OrientationSource>) -> Result<Scene, Error> {
        let Some(said) = said else { return self.for_bare_path() };
        if !self.orientation_is_fixed() {
            return self.turned(said);
        }
        let turn = self.asked.names.orientation("orientation", &said)?;
        if self.has_orientation(&turn) {
            return Ok(self.clone());
        }
        let words = |q: &Rotation| format!("{:?}", wxyz(q));
        let problem =
            format!("found a path at {}, but the scene is at {}", words(&turn), words(&self.asked.orientation));
        Err(Error::invalid("orientation", format!("{problem}; expected the same orientation")))
    }

    fn for_bare_path(&self) -> Result<Scene, Error> {
        if !self.orientation_is_open() {
            return Ok(self.clone());
        }
        let names: Vec<&str> = self.asked.names.orientations.iter().map(|(name, _)| name.as_str()).collect();
        let problem =
            format!("found none with the path, and the scene selects none of {}; select one", names.join(", "));
        Err(Error::invalid("orientation", problem))
    }

    /// The scene at each orientation among which planning may choose: all named ones if the query selects none, else
    /// its own.
    pub fn choices(&self) -> Vec<Scene> {
        if !self.orientation_is_open() {
            return vec![self.clone()];
        }
        let names = self.asked.names.orientations.iter().map(|(name, _)| OrientationSource::Named(name.clone()));
        names.map(|name| self.turned(name).expect("one of its own orientations")).collect()
    }

    /// The rules for pairs of bodies.
    pub fn pairs(&self) -> &PairRules {
        &self.pairs
    }

    /// Gravity, world axes, m/s².
    pub fn gravity(&self) -> Vector {
        self.spec.gravity.unwrap_or(GRAVITY).into()
    }

    /// Start of the query, if given.
    pub fn start(&self) -> Option<Point> {
        self.asked.start
    }

    /// Goal of the query, if given.
    pub fn goal(&self) -> Option<Point> {
        self.asked.goal
    }

    /// The orientations at the start and at the goal of the query: their own, or that of the scene.
    pub fn end_orientations(&self) -> [Rotation; 2] {
        self.asked.at_ends.map(|own| own.unwrap_or(self.asked.orientation))
    }

    /// How the platform may turn on its way, if the scene says so.
    pub fn turning(&self) -> Option<&TurningSpec> {
        self.spec.turning.as_ref()
    }

    /// An orientation from its name or quaternion.
    ///
    /// # Errors
    /// An unknown name, or a quaternion that does not have length 1; the error is at `place`.
    pub fn named_orientation(&self, place: &str, source: &OrientationSource) -> Result<Rotation, Error> {
        self.asked.names.orientation(place, source)
    }

    /// The requirements on wrench feasibility, if given.
    pub fn wrench(&self) -> Option<&WrenchSpec> {
        self.spec.wrench.as_ref()
    }

    /// The name of a member, as in messages.
    pub fn member_name(&self, member: Member) -> &str {
        match member {
            Member::Cable(i) => &self.robot.cables()[i].name,
            Member::Platform => PLATFORM,
            Member::Obstacle(j) => &self.obstacles[j].name,
        }
    }

    /// Identifies the scene of a path: covers everything except name, start, goal, stations, the names of orientations,
    /// and the choice of tensions, which no path depends on.
    pub fn fingerprint(&self) -> String {
        let mut spec = (*self.spec).clone();
        (spec.name, spec.query, spec.motion) = (None, None, None);
        (spec.orientations, spec.stations) = (Vec::new(), Vec::new());
        if let RobotSource::Inline(robot) = &mut spec.robot {
            robot.tension_distribution = None;
        }
        let turn = rounded(&self.asked.orientation);
        if turn != [1.0, 0.0, 0.0, 0.0] {
            spec.query = Some(QuerySpec { orientation: Some(turn.into()), ..QuerySpec::default() });
        }
        let text = serde_json::to_string(&spec).expect("specs of checked scenes are finite");
        fingerprint_of(&text)
    }
}

/// The robot of a scene, whose version must be known.
fn robot_of(spec: &SceneSpec) -> Result<Robot, Error> {
    if spec.version != FORMAT_VERSION {
        return Err(Error::invalid("version", format!("found {}, expected {FORMAT_VERSION}", spec.version)));
    }
    match &spec.robot {
        RobotSource::Inline(robot) => Robot::try_from(robot.clone()).map_err(|e| e.under("robot")),
        RobotSource::File(path) => {
            let problem =
                format!("found the path \"{path}\"; load the scene from its file, so that the path can be followed");
            Err(Error::invalid("robot", problem))
        }
    }
}

/// Hints at angles that are probably in degrees. The parts of a mesh share their rotation and give one hint.
fn degrees_hints(spec: &SceneSpec, robot: &Robot) -> Vec<String> {
    let bodies = |list: &str, bodies: &[BodySpec]| -> Vec<String> {
        let hint = |(k, body): (usize, &BodySpec)| body::degrees_hint(&format!("{list}[{k}]"), body.rpy);
        let mut hints: Vec<(Option<String>, String)> =
            bodies.iter().enumerate().filter_map(|at| Some((at.1.name.clone(), hint(at)?))).collect();
        hints.dedup_by(|a, b| a.0.is_some() && a.0 == b.0);
        hints.into_iter().map(|(_, hint)| hint).collect()
    };
    let orientations = spec.orientations.iter().enumerate();
    let orientations = orientations.filter_map(|(k, o)| body::degrees_hint(&format!("orientations[{k}]"), o.rpy));
    let platform = bodies("robot.platform", &robot.spec().platform);
    platform.into_iter().chain(bodies("obstacles", &spec.obstacles)).chain(orientations).collect()
}

/// A rotation in digits that do not depend on how it was specified.
fn rounded(rotation: &Rotation) -> [f64; 4] {
    let digits = wxyz(rotation).map(|x| (x / SAME_TURN).round() * SAME_TURN);
    let first = digits.iter().find(|x| **x != 0.0).copied().unwrap_or(1.0);
    digits.map(|x| first.signum() * x + 0.0) // q and -q are the same rotation
}

fn workspace(spec: &SceneSpec) -> Result<Aabb, Error> {
    let min = body::point("workspace.min", spec.workspace.min)?;
    let max = body::point("workspace.max", spec.workspace.max)?;
    if let Some(axis) = (0..3).find(|&k| !(min[k] < max[k])) {
        let problem = format!(
            "found min {} and max {} along {}, expected min < max",
            min[axis],
            max[axis],
            ["x", "y", "z"][axis]
        );
        return Err(Error::invalid("workspace", problem));
    }
    body::large_enough("workspace", "a workspace", [&min, &max], LEAST_EXTENT)?;
    Ok(Aabb { min, max })
}

fn outlets_outside(robot: &Robot, obstacles: &[Obstacle], seams: &[Seam]) -> Result<(), Error> {
    let parts = || obstacles.iter().flat_map(|o| o.parts.iter().map(|part| (&o.name, part)));
    let seams = || seams.iter().map(|s| (&obstacles[s.between[0]].name, &s.body));
    for (i, cable) in robot.cables().iter().enumerate() {
        for (name, body) in parts().chain(seams()) {
            let depth = body.depth_of(&cable.outlet);
            if depth > ON_SURFACE {
                let problem = format!(
                    "found a point {} inside obstacle \"{name}\", expected one outside or on its surface; \
                     move one of them",
                    small_length(depth)
                );
                return Err(Error::invalid(format!("robot.cables[{i}].outlet"), problem));
            }
        }
    }
    Ok(())
}
