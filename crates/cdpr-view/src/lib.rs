//! One self-contained HTML page that shows a scene with its path or its forbidden regions; it works offline.
//!
//! Additional contents are computed here: plots along the path, shadows, the wrench-feasible workspace. A part that
//! cannot be computed is omitted; callers have already checked path and scene.
//!
//! The page is a template, a style sheet and a script (sources in the folder `viewer`, drawn with three.js) around the
//! scene as JSON. The scene of a [`Form::Live`] page can be edited: it also contains the planner ([`live`]), compiled to WebAssembly by
//! the crate `cdpr-live`.

mod blocks;
mod extras;
pub mod live;
mod motion;
mod no_path;
mod trajectory;
mod workspace;

pub use live::Planning;

use std::sync::Arc;

use serde_json::{Value, json};

use cdpr_core::collision::path_check::PathViolation;
use cdpr_core::error::{Error, ErrorClass};
use cdpr_core::geometry::{Point, Polytope, Pose, Rotation, wxyz};
use cdpr_core::model::{Cable, Envelope, Obstacle, Scene};
use cdpr_core::path_file::PathFile;
use cdpr_core::regions::{NamedMesh, Regions};
use cdpr_core::trajectory_file::TrajectoryFile;
use cdpr_core::turning::turn_weight;
use cdpr_core::watch::Watch;
use cdpr_core::workspace::Workspace;

const TEMPLATE: &str = include_str!("assets/template.html");
const STYLE: &str = include_str!("assets/viewer.css");
const SCRIPT: &str = include_str!("assets/viewer.js");

/// Whether a page only shows its scene.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Form {
    /// The scene can be edited, and paths are planned in the page. This adds 1 MB.
    #[default]
    Live,
    /// The page only shows its contents.
    Static,
}

/// The contents of a page, besides the scene.
#[derive(Debug, Clone, Copy, Default)]
pub struct Contents<'a> {
    /// A path, or the answer that there is none.
    pub path: Option<&'a PathFile>,
    /// Planning data from the file of a loaded path; a path that was just planned contains them itself.
    pub planning: Option<&'a Planning>,
    /// Where the path is not valid.
    pub violations: &'a [PathViolation],
}

impl<'a> From<&'a PathFile> for Contents<'a> {
    fn from(path: &'a PathFile) -> Self {
        Contents { path: Some(path), ..Contents::default() }
    }
}

/// The page for a scene with its contents.
///
/// # Example
/// ```
/// use cdpr_view::{Contents, Form, page};
/// let page = page(&cdpr_core::testing::hard1(), Contents::default(), Form::Static);
/// assert!(page.starts_with("<!doctype html>") && page.contains("pillar"));
/// ```
pub fn page(scene: &Scene, contents: Contents, form: Form) -> String {
    page_within(scene, contents, form, &Watch::NONE).expect("nothing stops it")
}

/// The page for a scene with its contents, made within a watch.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn page_within(scene: &Scene, contents: Contents, form: Form, watch: &Watch) -> Result<String, Error> {
    let mut data = page_data(scene, contents, true, watch)?;
    if form == Form::Live {
        data["live"] = live::contents(scene, contents);
    }
    Ok(filled(scene, &data))
}

/// The data of the page as JSON. `extras` adds contents that do not depend on the path: shadows and the wrench-feasible
/// workspace.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn page_data(scene: &Scene, contents: Contents, extras: bool, watch: &Watch) -> Result<Value, Error> {
    let motion = |path: &PathFile| extra(path.path(scene).and_then(|path| motion::along_path(scene, &path, watch)));
    let motion = contents.path.map(motion).transpose()?.flatten();
    let mut data = data(scene, contents.path, contents.violations);
    data["motion"] = json!(motion);
    data["result"] = json!(contents.planning().map(|planning| planning.result));
    if extras { with_extras(scene, data, watch) } else { Ok(shortened(data)) }
}

impl Contents<'_> {
    fn planning(&self) -> Option<Planning> {
        let planned = || Planning::of(&json!(self.path.filter(|path| path.planned.is_some())?));
        self.planning.cloned().or_else(planned)
    }
}

/// The page that plays a trajectory in real time and plots it over time; `violations` are those between its samples, as
/// found by [`TrajectoryFile::violations`]. The trajectory has been checked and fits the scene.
///
/// # Errors
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn trajectory_page_within(
    scene: &Scene,
    trajectory: &TrajectoryFile,
    violations: &[PathViolation],
    watch: &Watch,
) -> Result<String, Error> {
    let poses = trajectory.poses();
    let pose_at = |time| trajectory::pose_at(trajectory, &poses, time);
    let motion = extra(motion::over_time(scene, trajectory.duration, pose_at, watch).map(Some))?;
    let mut data = data(scene, Some(&trajectory::path(trajectory)), &[]);
    data["motion"] = json!(motion);
    data["trajectory"] = json!(trajectory::shown(trajectory));
    data["violations"] = json!(trajectory::events(trajectory, violations));
    Ok(filled(scene, &with_extras(scene, data, watch)?))
}

/// Adds what does not depend on the path.
fn with_extras(scene: &Scene, data: Value, watch: &Watch) -> Result<Value, Error> {
    let mut data = shortened(data);
    data["regions"] = json!(extra(extras::shadows(scene, watch))?);
    data["feasible"] = json!(extra(extras::feasible(scene, watch))?);
    watch.check()?;
    Ok(data)
}

/// The data with plots and tree in fewer digits.
fn shortened(mut data: Value) -> Value {
    for place in ["/motion", "/path/tree"] {
        data.pointer_mut(place).into_iter().for_each(shorten);
    }
    data
}

/// Writes numbers that fit single precision with the fewest digits that identify them there, which halves their text.
fn shorten(value: &mut Value) {
    match value {
        Value::Array(items) => items.iter_mut().for_each(shorten),
        Value::Object(entries) => entries.values_mut().for_each(shorten),
        Value::Number(number) if number.is_f64() => {
            let short = number.as_f64().filter(|x| f64::from(*x as f32) == *x);
            if let Some(Ok(x)) = short.map(|x| (x as f32).to_string().parse::<f64>()) {
                *value = json!(x);
            }
        }
        _ => {}
    }
}

/// Additional contents, omitted if they cannot be computed; only an interruption or the deadline is an error.
fn extra<T>(found: Result<Option<T>, Error>) -> Result<Option<T>, Error> {
    match found {
        Err(error) if matches!(error.class(), ErrorClass::Interrupted | ErrorClass::OutOfTime) => Err(error),
        found => Ok(found.ok().flatten()),
    }
}

/// The page for a scene and its forbidden regions, which are translucent and can be switched on and off by cable.
///
/// # Example
/// ```
/// use cdpr_core::regions::{RegionOptions, regions};
/// let scene = cdpr_core::testing::hard1();
/// let page = cdpr_view::regions_page(&scene, &regions(&scene, &RegionOptions::default())?);
/// assert!(page.contains("cable 3 / pillar"));
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn regions_page(scene: &Scene, regions: &Regions) -> String {
    let mut data = data(scene, None, &[]);
    data["regions"] = extras::regions_value(regions, true);
    filled(scene, &data)
}

/// The page for a scene, at any orientation, and where its platform can be; the scene is drawn at the first orientation of the proof.
///
/// # Errors
/// A workspace of another scene, or a flat one, which has no surface.
///
/// # Example
/// ```
/// use cdpr_core::workspace::{WorkspaceOptions, workspace};
/// use cdpr_core::{CompiledScene, Watch, testing};
/// let scene = testing::hard1();
/// let compiled = CompiledScene::new(&scene, Default::default(), Default::default(), &Watch::NONE)?;
/// let found = workspace(&[&compiled], &WorkspaceOptions { resolution: Some(0.2), ..WorkspaceOptions::default() }, &Default::default())?;
/// assert!(cdpr_view::workspace_page(&scene, &found)?.contains("pillar"));
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn workspace_page(scene: &Scene, found: &Workspace) -> Result<String, Error> {
    let scene = scene.clone().turned(found.orientation.into())?;
    if found.scene.fingerprint != scene.fingerprint() {
        let problem = format!("found the workspace of {:?}, expected that of this scene", found.scene.name);
        return Err(Error::invalid("workspace", problem));
    }
    let mut data = data(&scene, None, &[]);
    data["proved_workspace"] = json!(workspace::shown(found)?);
    Ok(filled(&scene, &data))
}

fn filled(scene: &Scene, data: &Value) -> String {
    let [worker, module] = if data["live"].is_null() { ["", ""] } else { [live::WORKER, live::MODULE] };
    let data = inert(&data.to_string());
    let title = escaped(&format!("{} – cdpr", scene.name()));
    let parts = [
        ("/*{{style}}*/", STYLE),
        ("{{title}}", &title),
        ("{{data}}", &data),
        ("{{worker}}", worker),
        ("{{module}}", module),
        ("/*{{script}}*/", SCRIPT),
    ];
    fill(TEMPLATE, &parts)
}

fn data(scene: &Scene, path: Option<&PathFile>, violations: &[PathViolation]) -> Value {
    let [at_start, at_goal] = scene.end_orientations();
    let poses = path.and_then(|path| turning(scene, path));
    let ends =
        poses.as_deref().map(|poses| [poses.first(), poses.last()].map(|pose| pose.map(|pose| pose.orientation)));
    let [first, last] = ends.unwrap_or_default();
    let waypoints = path.map_or(&[][..], |path| &path.waypoints);
    let no_path = path.and_then(|path| path.no_path.as_deref());
    let asked = no_path.map(|no_path| [no_path.proof.start, no_path.proof.goal]);
    // The ends of a path or proof may differ from those of the scene.
    let end = |of_path: Option<&[f64; 3]>, asked: Option<Point>, own: Option<Point>| {
        of_path.copied().or(asked.or(own).as_ref().map(xyz))
    };
    let obstacle = |o: &Obstacle| json!({ "name": o.name, "parts": o.parts.iter().map(body).collect::<Vec<_>>() });
    json!({
        "version": 1,
        "title": scene.name(),
        "workspace": { "min": xyz(&scene.workspace().min), "max": xyz(&scene.workspace().max) },
        "orientation": wxyz(scene.orientation()),
        "platform": scene.robot().parts().iter().map(body).collect::<Vec<_>>(),
        "cables": cables(scene),
        "obstacles": scene.obstacles().iter().map(obstacle).collect::<Vec<_>>(),
        "start": end(waypoints.first(), asked.map(|ends| ends[0]), scene.start()),
        "goal": end(waypoints.last(), asked.map(|ends| ends[1]), scene.goal()),
        "start_orientation": wxyz(&first.unwrap_or(at_start)),
        "goal_orientation": wxyz(&last.unwrap_or(at_goal)),
        "path": path.map(|path| path_value(scene, path)),
        "no_path": no_path.map(no_path::shown),
        "violations": violations,
    })
}

/// The cables; those with a pulley or weight also say how they run and hang.
fn cables(scene: &Scene) -> Vec<Value> {
    let cable = |(cable, envelope): (&Cable, &Option<Arc<Envelope>>)| {
        let mut value = json!({
            "name": cable.name, "outlet": xyz(&cable.outlet), "attachment": xyz(&cable.attachment), "diameter": cable.diameter,
        });
        if let Some(bent) = bent(cable, envelope.as_deref()).as_object_mut() {
            value.as_object_mut().expect("an object").append(bent);
        }
        value
    };
    scene.robot().cables().iter().zip(scene.envelopes()).map(cable).collect()
}

/// What bends a cable, if anything: its pulley, and the parabola on which it hangs lowest. That is weight · factor · a · b /
/// (2 tension) below the chord, at the distances a and b from its ends.
///
/// # Example
/// ```
/// let scene = cdpr_core::testing::hard1();
/// assert_eq!(cdpr_view::bent(&scene.robot().cables()[0], scene.envelopes()[0].as_deref()), serde_json::json!({}));
/// ```
pub fn bent(cable: &Cable, envelope: Option<&Envelope>) -> Value {
    let mut value = json!({});
    if let Some(pulley) = cable.pulley.filter(|pulley| pulley.radius > 0.0) {
        value["pulley"] = json!({ "radius": pulley.radius, "axis": <[f64; 3]>::from(pulley.axis) });
    }
    if let Some(sag) = envelope.and_then(|envelope| envelope.sag) {
        let (up, factor) = (<[f64; 3]>::from(sag.up), 1.0 + 0.25 * sag.slackness());
        value["sag"] = json!({ "up": up, "weight": sag.weight, "tension": sag.tension, "factor": factor });
    }
    value
}

/// The poses of a path on which the platform turns.
fn turning(scene: &Scene, path: &PathFile) -> Option<Vec<Pose>> {
    let poses = || path.path(scene).ok().filter(|poses| !poses.is_empty());
    path.orientations.is_some().then(poses).flatten()
}

/// Quaternions of poses, with signs such that interpolation between them turns the same way as the platform.
fn quaternions(poses: &[Pose]) -> Vec<Rotation> {
    let mut all: Vec<Rotation> = poses.iter().take(1).map(|pose| pose.orientation).collect();
    for pair in poses.windows(2) {
        let motion = pair[0].toward(&pair[1]);
        let reached = Rotation::from_scaled_axis(motion.axis * motion.angle) * all[all.len() - 1];
        let same = reached.coords.dot(&pair[1].orientation.coords) >= 0.0;
        let digits = pair[1].orientation.into_inner();
        all.push(Rotation::new_unchecked(if same { digits } else { -digits }));
    }
    all
}

/// The keys of a path file that users write as well, and the search tree.
fn path_value(scene: &Scene, path: &PathFile) -> Value {
    let orientations: Option<Vec<[f64; 4]>> =
        turning(scene, path).map(|poses| quaternions(&poses).iter().map(wxyz).collect());
    let turns = orientations.is_some();
    let mut value = json!(PathFile { planned: None, orientations, ..path.clone() });
    if turns {
        value["turn_weight"] = json!(turn_weight(scene));
    }
    value["tree"] = json!(extras::tree(&path.tree));
    value
}

fn xyz(p: &Point) -> [f64; 3] {
    [p.x, p.y, p.z]
}

fn body(body: &Polytope) -> Value {
    let faces: Vec<&Vec<usize>> = body.facets().iter().map(|f| &f.corners).collect();
    json!({ "vertices": body.vertices().iter().map(xyz).collect::<Vec<_>>(), "faces": faces })
}

fn region(NamedMesh { name, kind, culprits, mesh }: &NamedMesh) -> Value {
    let vertices: Vec<[f32; 3]> = mesh.vertices.iter().map(|p| xyz(p).map(|x| x as f32)).collect();
    json!({ "name": name, "kind": kind, "culprits": culprits, "vertices": vertices, "triangles": mesh.triangles })
}

/// JSON that cannot end the enclosing script element.
fn inert(json: &str) -> String {
    let mut out = String::with_capacity(json.len());
    for c in json.chars() {
        match c {
            '<' | '>' | '&' | '\u{2028}' | '\u{2029}' => out.push_str(&format!("\\u{:04x}", c as u32)),
            _ => out.push(c),
        }
    }
    out
}

/// Text with the special characters of HTML escaped.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Replaces placeholders in one pass, so that nothing inside a replacement is treated as a placeholder.
fn fill(template: &str, parts: &[(&str, &str)]) -> String {
    let mut places: Vec<(usize, &str, &str)> = parts
        .iter()
        .map(|(mark, text)| (template.find(mark).expect("the template has every placeholder"), *mark, *text))
        .collect();
    places.sort_unstable();
    let mut out = String::new();
    let mut done = 0;
    for (at, mark, text) in places {
        out.push_str(&template[done..at]);
        out.push_str(text);
        done = at + mark.len();
    }
    out.push_str(&template[done..]);
    out
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use cdpr_core::geometry::Vector;
    use cdpr_core::model::{PulleySpec, RobotSource};
    use cdpr_core::regions::{RegionOptions, regions};
    use cdpr_core::testing::{block, hard1, paper_robot, paper_scene, scene};

    #[test]
    fn hostile_names_stay_data() {
        let name = "</script><script>alert(1)</script>{{title}}/*{{script}}*/";
        let scene = scene(paper_scene(name, vec![block(name, [0.1; 3], [1.0; 3])]));
        let page = page(&scene, Contents::default(), Form::Static);
        assert!(!page.contains("<script>alert(1)"));
        assert_eq!(page.matches(SCRIPT).count(), 1);
    }

    #[test]
    fn only_cables_that_bend_say_how() {
        let straight = data(&hard1(), None, &[]);
        let keys = |value: &Value| value.as_object().unwrap().keys().cloned().collect::<Vec<_>>();
        assert!(
            straight["cables"]
                .as_array()
                .unwrap()
                .iter()
                .all(|cable| { keys(cable) == ["attachment", "diameter", "name", "outlet"] })
        );
        let mut spec = paper_scene("bent", vec![]);
        let mut robot = paper_robot();
        (robot.cables[0].linear_density, robot.cables[0].sag_tension) = (Some(0.1), Some(100.0));
        robot.cables[1].pulley = Some(PulleySpec { radius: 0.05, axis: [0.0, 0.0, 2.0] });
        spec.robot = RobotSource::Inline(robot);
        spec.gravity = Some([0.0, -10.0, 0.0]);
        let scene = scene(spec);
        let bent = &data(&scene, None, &[])["cables"];
        let sag = scene.envelopes()[0].as_ref().unwrap().sag.unwrap();
        let expected = json!({ "up": [0.0, 1.0, 0.0], "weight": 1.0, "tension": sag.tension, "factor": 1.0 + sag.slackness() / 4.0 });
        assert_eq!((&bent[0]["sag"], &bent[0]["pulley"]), (&expected, &Value::Null));
        assert_eq!(
            (&bent[1]["sag"], &bent[1]["pulley"]),
            (&Value::Null, &json!({ "radius": 0.05, "axis": [0.0, 0.0, 1.0] }))
        );
        assert_eq!(bent[2], straight["cables"][2]);
    }

    #[test]
    fn quaternions_of_the_page_turn_as_the_platform_does() {
        let yaw = |angle: f64, sign: f64| {
            let turned = Rotation::from_scaled_axis(Vector::z() * angle).into_inner();
            Pose::new(Point::origin(), Rotation::new_unchecked(turned * sign))
        };
        let poses = [yaw(0.1, 1.0), yaw(3.0, -1.0), yaw(3.0 - PI, 1.0), yaw(-2.0, 1.0), yaw(2.0, -1.0)];
        let numbers = quaternions(&poses);
        for (k, pair) in poses.windows(2).enumerate() {
            let middle = Rotation::new_normalize(numbers[k].into_inner() + numbers[k + 1].into_inner());
            let expected = pair[0].toward(&pair[1]).at(0.5).orientation;
            assert!(middle.angle_to(&expected) < 1e-12, "{k}");
        }
    }

    #[test]
    fn regions_stand_in_the_data_by_name_and_space() {
        let name = "</script><script>alert(1)</script>";
        let scene = scene(paper_scene("regions", vec![block(name, [0.1; 3], [1.0; 3])]));
        let found = regions(&scene, &RegionOptions { all: true, ..RegionOptions::default() }).unwrap();
        let page = regions_page(&scene, &found);
        assert!(!page.contains("<script>alert(1)"));
        let (_, rest) = page.split_once("id=\"cdpr-data\">").unwrap();
        let data: Value = serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap();
        assert_eq!(data["regions"]["space"], "position");
        let meshes = data["regions"]["meshes"].as_array().unwrap();
        assert_eq!((meshes.len(), &meshes[0]["culprits"]), (found.meshes.len(), &json!(["platform", name])));
        assert_eq!(meshes[0]["triangles"], json!(found.meshes[0].mesh.triangles));
    }
}
