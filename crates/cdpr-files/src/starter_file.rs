//! Writes a new, commented scene around a robot file and meshes, with relative paths to these files.

use std::path::{Path, PathBuf};

use super::scene_file::in_place;
use super::text::{Notation, relative};
use cdpr_core::error::{Error, name_of_file};
use cdpr_core::geometry::Point;
use cdpr_core::limits::MAX_COORDINATE;
use cdpr_core::model::spec::{FORMAT_VERSION, MotionSpec};
use cdpr_core::model::{
    BodySpec, MeshSource, QuerySpec, RobotSource, Scene, SceneSpec, Unit, WorkspaceSpec, WrenchSpec,
};
use cdpr_core::new_scene::{self, Proposal};
use cdpr_core::watch::Watch;

/// The contents of a new scene.
#[derive(Debug, Clone)]
pub struct Starter {
    /// Robot file.
    pub robot: PathBuf,
    /// Mesh files, one obstacle each.
    pub obstacles: Vec<PathBuf>,
    /// Unit of the meshes.
    pub units: Unit,
    /// Start, m; if omitted, a suitable one is chosen.
    pub start: Option<Point>,
    /// Goal, m; if omitted, a suitable one is chosen.
    pub goal: Option<Point>,
}

/// A new scene.
#[derive(Debug, Clone)]
pub struct NewScene {
    /// The scene as plain data, with paths relative to its file.
    pub spec: SceneSpec,
    /// The checked scene.
    pub scene: Scene,
    /// Why the scene does not require that the cables hold the platform, although their forces are known.
    pub unheld: Option<String>,
    /// Why there is no start and goal with a path between them, if there is none.
    pub lacking: Option<String>,
}

/// Makes a scene to be written to `output`: the workspace of [`new_scene::workspace`], start and goal as given or from
/// [`new_scene::query`], and `[wrench]` if the robot has a mass and tension limits and [`new_scene::unheld`] has no objection.
///
/// # Errors
/// The errors of [`super::load_scene`]; [`Error::interrupted`].
pub fn starter_scene(starter: &Starter, output: impl AsRef<Path>, watch: &Watch) -> Result<NewScene, Error> {
    let output = output.as_ref();
    let mut spec = outline(starter, output)?;
    let folder = output.parent();
    // Without gravity, cables with weight can be as long as a workspace without limits requires.
    let dense = in_place(SceneSpec { gravity: Some([0.0; 3]), ..spec.clone() }, folder, watch)?;
    let around = new_scene::workspace(&dense);
    spec.workspace = WorkspaceSpec { min: around.min.into(), max: around.max.into() };
    // The meshes have already been replaced by convex parts.
    let with = |wrench: Option<WrenchSpec>, query: Option<QuerySpec>| {
        let SceneSpec { gravity, workspace, .. } = spec.clone();
        Scene::new(SceneSpec { gravity, workspace, wrench, query, ..dense.spec().clone() })
    };
    let given = || spec.query.clone();
    let (mut wrench, mut unheld) = (None, None);
    if dense.robot().knows_its_forces() {
        let required = Some(WrenchSpec::default());
        unheld = new_scene::unheld(&with(required.clone(), given())?, watch)?;
        wrench = required.filter(|_| unheld.is_none());
    }
    let (query, lacking) = match new_scene::query(&with(wrench.clone(), given())?, watch)? {
        Proposal::Lacking(reason) => (given(), Some(reason)),
        Proposal::Query([start, goal]) => {
            let ends = QuerySpec::between(start, goal);
            (Some(ends), None)
        }
    };
    let scene = with(wrench.clone(), query.clone())?.with_notes_of(&dense);
    Ok(NewScene { spec: SceneSpec { wrench, query, ..spec }, scene, unheld, lacking })
}

/// The scene without workspace, wrench and missing start or goal.
fn outline(starter: &Starter, output: &Path) -> Result<SceneSpec, Error> {
    let whole_world = [MAX_COORDINATE; 3];
    let given = starter.start.is_some() || starter.goal.is_some();
    Ok(SceneSpec {
        version: FORMAT_VERSION,
        name: name_of_file(output),
        gravity: None,
        clearance: None,
        ignore: Vec::new(),
        touch: Vec::new(),
        clearances: None,
        orientations: Vec::new(),
        stations: Vec::new(),
        payloads: Vec::new(),
        task: Vec::new(),
        workspace: WorkspaceSpec { min: whole_world.map(|x| -x), max: whole_world },
        robot: RobotSource::File(relative(&starter.robot, output)?),
        obstacles: obstacles(starter, output)?,
        wrench: None,
        motion: Some(MotionSpec { speed: Some(SPEED), acceleration: Some(ACCELERATION), ..MotionSpec::default() }),
        turning: None,
        query: given.then(|| QuerySpec {
            start: starter.start.map(Into::into),
            goal: starter.goal.map(Into::into),
            ..QuerySpec::default()
        }),
    })
}

/// Limits of motions in new scenes, slow for a robot in a hall: m/s, m/s².
const SPEED: f64 = 0.5;
const ACCELERATION: f64 = 1.0;

fn obstacles(starter: &Starter, output: &Path) -> Result<Vec<BodySpec>, Error> {
    let mut bodies: Vec<BodySpec> = Vec::new();
    for mesh in &starter.obstacles {
        let stem = name_of_file(mesh).unwrap_or("obstacle".to_string());
        let taken = |name: &str| bodies.iter().any(|body| body.name.as_deref() == Some(name));
        let more = (2..).map(|k| format!("{stem} {k}"));
        let name = std::iter::once(stem.clone()).chain(more).find(|name| !taken(name));
        let units = Some(starter.units).filter(|unit| *unit != Unit::M);
        let mesh = Some(MeshSource::File(relative(mesh, output)?));
        bodies.push(BodySpec { name, mesh, units, ..BodySpec::default() });
    }
    Ok(bodies)
}

/// The scene file, commented in TOML.
///
/// # Errors
/// A scene that cannot be written in the notation (no such scene is known).
pub fn starter_text(new: &NewScene, notation: Notation) -> Result<String, Error> {
    let unwritable = |e: toml::ser::Error| Error::invalid("", e.to_string());
    let toml = match notation {
        Notation::Json => return Ok(format!("{:#}\n", serde_json::json!(new.spec))),
        Notation::Toml => toml::to_string(&new.spec).map_err(unwritable)?,
    };
    let mut text = HEAD.to_string();
    let mut comments = COMMENTS.to_vec();
    for line in toml.lines() {
        text.extend(comments.extract_if(.., |(table, _)| *table == line).map(|(_, comment)| comment));
        text.push_str(line);
        text.push('\n');
    }
    let one_line = |text: &str| text.replace(char::is_control, " ");
    let reason = |reason: &String, table: &str| format!("\n# {}.\n{table}", one_line(reason));
    text.extend(new.unheld.iter().map(|why| reason(why, NO_WRENCH)));
    let complete = new.scene.start().is_some() && new.scene.goal().is_some();
    text.extend(new.lacking.iter().map(|why| reason(why, if complete { "" } else { NO_QUERY })));
    Ok(text)
}

const HEAD: &str = "\
# A scene for cdpr. Plan it with:  cdpr plan THIS_FILE -o path.json --html view.html
# Lengths are metres, angles radians, forces newtons; z points up. Files are relative to this one.
# Optional, here above the first table: the distance (m) to keep between everything that must not touch.
# clearance = 0.01
";

const COMMENTS: &[(&str, &str)] = &[
    (
        "[workspace]",
        "# The box that every corner of the platform must stay in: around outlets and obstacles, down to the floor, and wide \
         enough for the platform.\n",
    ),
    (
        "[[obstacles]]",
        "# Optional: units, scale, position = [x, y, z], rpy_degrees = [roll, pitch, yaw], tolerance of its convex parts.\n",
    ),
    (
        "[wrench]",
        "# The cables must be able to hold the platform along the whole path; optional, in addition: force (N), moment (N m), \
         load.\n",
    ),
    (
        "[motion]",
        "# Limits of timed motions: put in what your winches reach; also: cable_speed, cable_acceleration, jerk, blend (m). A clearance \
         here\n# is kept by motions only, instead of the scene's.\n",
    ),
    ("[query]", "# Positions of the platform's origin.\n"),
];

const NO_WRENCH: &str = "\
# So this scene does not require that the cables hold the platform. To require it:
# [wrench]
";

const NO_QUERY: &str = "\
# Put start and goal here, under [query], or use --start and --goal:
# [query]
# start = [x, y, z]
# goal = [x, y, z]
";
