//! Python bindings: numbers in, numbers out. Everything that reads like an interface is in the Python package around
//! it.

mod batch;
mod convert;
mod errors;
mod forked;
mod wrench;
mod wrench_map;

use std::sync::{Arc, Mutex, PoisonError};

use cdpr_core::collision::batch::{BatchOptions, clearances, motions_valid, states_valid};
use cdpr_core::collision::{Checker, Constraints, Engine, Interference, check_path};
use cdpr_core::geometry::{Point, Polytope, Rotation, Vector, distance};
use cdpr_core::io::{self, Loader, text::Notation};
use cdpr_core::plan::{
    Appraisal, PlanOptions, PlanResult, Post, appraise, check, engine_within, lower_bound, plan_choosing, plan_heard,
    shorten_path, trace_rewinding,
};
use cdpr_core::planning::{Listener, PlannerOptions, PlannerSettings, SearchTree};
use cdpr_core::regions::{NamedMesh, RegionOptions, regions_within};
use cdpr_core::view::{ShownPath, page_within};
use cdpr_core::watch::{Interrupt, TimeUnit, Watch, time_budget};
use cdpr_core::wrench as core_wrench;
use cdpr_core::{Choice, Error, ErrorClass};
use numpy::{PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use serde_json::{Value, json};

use convert::{point, points, row, triples};
use errors::{abandonable, answered, interruptible, interruptible_with_rest, raised};

/// A checked scene, with the engines compiled for it so far.
#[pyclass(frozen, module = "cdpr._core")]
struct Scene(cdpr_core::Scene, Mutex<Vec<Compiled>>);

type Compiled = ((Engine, Interference), Arc<dyn Checker>);

impl Scene {
    fn of(scene: cdpr_core::Scene) -> Self {
        Scene(scene, Mutex::default())
    }
}

/// The engine for a scene, compiled on first use and kept.
fn engine_of(py: Python<'_>, scene: &Scene, engine: &str, interference: &str) -> PyResult<Arc<dyn Checker>> {
    let wanted = (named(engine)?, named(interference)?);
    match known_engine(scene, wanted) {
        Some(engine) => Ok(engine),
        None => interruptible(py, |stop| compiled(scene, wanted, &Watch::on(stop))),
    }
}

fn known_engine(scene: &Scene, wanted: (Engine, Interference)) -> Option<Arc<dyn Checker>> {
    let known = scene.1.lock().unwrap_or_else(PoisonError::into_inner);
    known.iter().find(|(key, _)| *key == wanted).map(|(_, engine)| engine.clone())
}

/// The engine for a scene, within a watch. Two threads may compile it at the same time: none waits for the other.
fn compiled(scene: &Scene, wanted: (Engine, Interference), watch: &Watch) -> Result<Arc<dyn Checker>, Error> {
    if let Some(engine) = known_engine(scene, wanted) {
        return Ok(engine);
    }
    let engine: Arc<dyn Checker> = engine_within(&scene.0, wanted.0, wanted.1, watch)?.into();
    scene.1.lock().unwrap_or_else(PoisonError::into_inner).push((wanted, engine.clone()));
    Ok(engine)
}

fn named<T: Choice>(name: &str) -> PyResult<T> {
    answered(|| T::named(name))
}

fn serialized(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).expect("answers are finite")
}

#[pymethods]
impl Scene {
    /// Loads a scene file.
    #[staticmethod]
    fn load(py: Python<'_>, path: std::path::PathBuf) -> PyResult<Self> {
        interruptible(py, |stop| Loader::new(Watch::on(stop)).scene(&path)).map(Scene::of)
    }

    /// A scene from JSON text, the robot in place.
    #[staticmethod]
    fn from_json(py: Python<'_>, text: &str) -> PyResult<Self> {
        interruptible(py, |stop| Loader::new(Watch::on(stop)).scene_from_text(text, Notation::Json, None))
            .map(Scene::of)
    }

    /// The scene as JSON text, the robot in place.
    fn to_json(&self) -> String {
        serialized(self.0.spec())
    }

    /// Writes a scene file, the robot in place.
    fn save(&self, path: std::path::PathBuf) -> PyResult<()> {
        answered(|| io::save_table(&path, self.0.spec()))
    }

    /// Identifies what paths of this scene are planned against.
    fn fingerprint(&self) -> PyResult<String> {
        answered(|| Ok(self.0.fingerprint()))
    }

    /// Names and quaternions of the scene's orientations.
    fn orientations(&self) -> Vec<(String, [f64; 4])> {
        self.0.orientations().iter().map(|(name, turn)| (name.clone(), quaternion(turn))).collect()
    }

    /// The scene for a path that holds at this orientation, if it says one (none if it is the scene itself), and a warning
    /// if the path was planned for another scene, given by name and fingerprint; an error if that is asked for.
    #[pyo3(signature = (orientation, orientation_name=None, planned_for=None, strict=false))]
    fn for_path(
        &self,
        orientation: Option<[f64; 4]>,
        orientation_name: Option<&str>,
        planned_for: Option<(String, String)>,
        strict: bool,
    ) -> PyResult<(Option<Scene>, Option<String>)> {
        let id = planned_for.map(|(name, fingerprint)| io::SceneId { name, fingerprint });
        let (scene, warning) =
            answered(|| io::scene_for(&self.0, orientation.map(Into::into), orientation_name, id.as_ref(), strict))?;
        Ok(((scene.orientation() != self.0.orientation()).then(|| Scene::of(scene)), warning))
    }

    /// What is special about the scene.
    fn notes(&self, py: Python<'_>) -> PyResult<Vec<String>> {
        Ok(interruptible(py, |stop| Constraints::within(&self.0, &Watch::on(stop)))?.remarks())
    }

    /// Whether each row of an (n, 3) array is a valid position.
    fn states_valid<'py>(
        &self,
        py: Python<'py>,
        positions: PyReadonlyArray2<'py, f64>,
        engine: &str,
        interference: &str,
        threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyArray1<bool>>> {
        let engine = engine_of(py, self, engine, interference)?;
        let rows = positions.as_slice()?;
        let mut answers = vec![false; rows.len() / 3];
        interruptible(py, |interrupted| {
            let options = BatchOptions { threads, interrupted };
            states_valid(&*engine, |k| row(rows, k), &mut answers, &options)
        })?;
        Ok(PyArray1::from_vec(py, answers))
    }

    /// Whether each straight motion between rows of two (n, 3) arrays is valid.
    fn motions_valid<'py>(
        &self,
        py: Python<'py>,
        starts: PyReadonlyArray2<'py, f64>,
        ends: PyReadonlyArray2<'py, f64>,
        engine: &str,
        interference: &str,
        threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyArray1<bool>>> {
        let engine = engine_of(py, self, engine, interference)?;
        let (starts, ends) = (starts.as_slice()?, ends.as_slice()?);
        let mut answers = vec![false; starts.len() / 3];
        interruptible(py, |interrupted| {
            let options = BatchOptions { threads, interrupted };
            motions_valid(&*engine, |k| (row(starts, k), row(ends, k)), &mut answers, &options)
        })?;
        Ok(PyArray1::from_vec(py, answers))
    }

    /// Whether one straight motion is valid.
    fn motion_valid(
        &self,
        py: Python<'_>,
        start: [f64; 3],
        end: [f64; 3],
        engine: &str,
        interference: &str,
    ) -> PyResult<bool> {
        let engine = engine_of(py, self, engine, interference)?;
        answered(|| Ok(engine.motion_valid(&point(start), &point(end))))
    }

    /// World-from-platform unit quaternion, w x y z.
    fn orientation(&self) -> [f64; 4] {
        quaternion(self.0.orientation())
    }

    /// Least and greatest coordinates of the positions at which the platform is inside the workspace.
    fn position_box(&self, py: Python<'_>) -> PyResult<([f64; 3], [f64; 3])> {
        let (min, max) = interruptible(py, |stop| Constraints::within(&self.0, &Watch::on(stop)))?.position_box();
        Ok((min.into(), max.into()))
    }

    /// The signed clearance of each row of an (n, 3) array, m.
    fn clearance<'py>(
        &self,
        py: Python<'py>,
        positions: PyReadonlyArray2<'py, f64>,
        threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let engine = engine_of(py, self, Engine::default().name(), Interference::default().name())?;
        let rows = positions.as_slice()?;
        let mut answers = vec![0.0; rows.len() / 3];
        interruptible(py, |interrupted| {
            let options = BatchOptions { threads, interrupted };
            clearances(&*engine, |k| row(rows, k), &mut answers, &options)
        })?;
        Ok(PyArray1::from_vec(py, answers))
    }

    /// The violations of a motion as JSON, those that begin first first.
    fn violations(
        &self,
        py: Python<'_>,
        start: [f64; 3],
        end: [f64; 3],
        engine: &str,
        interference: &str,
    ) -> PyResult<String> {
        let engine = engine_of(py, self, engine, interference)?;
        answered(|| Ok(serialized(&engine.violations(&point(start), &point(end)))))
    }

    /// The report on a path as JSON.
    fn check(
        &self,
        py: Python<'_>,
        waypoints: PyReadonlyArray2<'_, f64>,
        engine: &str,
        interference: &str,
    ) -> PyResult<String> {
        let engine = engine_of(py, self, engine, interference)?;
        let waypoints = points(waypoints.as_slice()?);
        let report = interruptible(py, |stop| check(&self.0, &*engine, &waypoints, &Watch::on(stop)))?;
        Ok(serialized(&report))
    }

    /// Tensions and margins at even steps along a path, as JSON.
    fn tensions_along(
        &self,
        py: Python<'_>,
        waypoints: PyReadonlyArray2<'_, f64>,
        step: f64,
        reference: Option<Vec<f64>>,
    ) -> PyResult<String> {
        let statics = answered(|| core_wrench::Statics::of(&self.0))?;
        let required = answered(|| core_wrench::constraint::required_of(&self.0, None, None))?;
        let waypoints = points(waypoints.as_slice()?);
        let along = |stop: &Interrupt| {
            core_wrench::tensions_along(&statics, &required, &waypoints, step, reference.as_deref(), stop)
        };
        interruptible(py, along).map(|rows| serialized(&rows))
    }

    /// The result of planning as JSON, as in a path file, and its search tree: states (n, 3) and parents (n,).
    #[allow(clippy::too_many_arguments)] // one per keyword of cdpr.plan
    fn plan<'py>(
        &self,
        py: Python<'py>,
        planner: &str,
        engine: &str,
        interference: &str,
        seed: u64,
        start: Option<[f64; 3]>,
        goal: Option<[f64; 3]>,
        step: f64,
        post: Option<&str>,
        repeats: usize,
        budget: Option<f64>,
        settings: &str,
        on_improvement: Option<Py<PyAny>>,
    ) -> PyResult<Planned<'py>> {
        let settings: PlannerSettings = answered(|| io::text::parse(settings, Notation::Json))?;
        let planner = named(planner)?;
        let options = PlanOptions {
            planner: answered(|| PlannerOptions::new(planner, step, &settings))?,
            engine: named(engine)?,
            interference: named(interference)?,
            seed,
            start: start.map(point),
            goal: goal.map(point),
            step,
            post: post.map(named).transpose()?,
            repeats,
            budget: answered(|| budget.map(|seconds| time_budget("budget", seconds, TimeUnit::Second)).transpose())?,
        };
        let search = |stop: &Interrupt, tell: &Listener<Point>| {
            let watch = options.watch(stop);
            let (scene, engine, found) = match &self.0.choices()[..] {
                [_] => match compiled(self, (options.engine, options.interference), &watch) {
                    Err(error) if error.class() == ErrorClass::OutOfTime => {
                        (self.0.clone(), None, PlanResult::out_of_time())
                    }
                    engine => {
                        let engine = engine?;
                        let found = plan_heard(&*engine, &self.0, &options, &watch, tell)?;
                        (self.0.clone(), Some(engine), found)
                    }
                },
                _ => {
                    let planned = plan_choosing(&self.0, &options, stop, tell)?;
                    (planned.scene, planned.engine.map(Arc::from), planned.result)
                }
            };
            let appraise = |engine: Arc<dyn Checker>| appraise(&scene, &*engine, &found.waypoints, false, &watch);
            let appraisal = engine.map(appraise).transpose()?.unwrap_or_default();
            Ok((scene, found, appraisal))
        };
        let (scene, found, appraisal) = heard(py, on_improvement.as_ref(), search)?;
        let Appraisal { nearest, wrench, .. } = appraisal;
        let json = answered(|| Ok(io::plan_json(&scene, &options, &found, &nearest, wrench.as_ref())))?;
        Ok((json.to_string(), tree_arrays(py, &found.tree)?))
    }

    /// A length that no path between two positions falls below, m.
    fn lower_bound(&self, py: Python<'_>, start: Option<[f64; 3]>, goal: Option<[f64; 3]>) -> PyResult<f64> {
        let end = |key: &str, given: Option<[f64; 3]>, own: Option<Point>| {
            let missing = || raised(Error::invalid(format!("query.{key}"), "found none, expected a position"));
            given.map(point).or(own).ok_or_else(missing)
        };
        let (start, goal) = (end("start", start, self.0.start())?, end("goal", goal, self.0.goal())?);
        let bounds = |stop: &Interrupt| {
            let watch = Watch::on(stop);
            let bound = |scene: &cdpr_core::Scene| {
                let engine = engine_within(scene, Engine::default(), Interference::default(), &watch)?;
                lower_bound(&*engine, &start, &goal, &watch)
            };
            self.0.choices().iter().map(bound).collect::<Result<Vec<f64>, Error>>()
        };
        Ok(interruptible(py, bounds)?.into_iter().fold(f64::INFINITY, f64::min))
    }

    /// The path made shorter, as JSON.
    #[allow(clippy::too_many_arguments)] // one per keyword of cdpr.rewind
    fn shorten(
        &self,
        py: Python<'_>,
        waypoints: PyReadonlyArray2<'_, f64>,
        post: &str,
        step: f64,
        repeats: usize,
        engine: &str,
        interference: &str,
    ) -> PyResult<String> {
        let engine = engine_of(py, self, engine, interference)?;
        let waypoints = points(waypoints.as_slice()?);
        let post: Post = named(post)?;
        let processing = answered(|| post.processing(step, repeats))?;
        let shorter =
            interruptible(py, |interrupted| shorten_path(&*engine, &waypoints, &processing, &Watch::on(interrupted)))?;
        answered(|| Ok(io::path_json(&self.0, &shorter).to_string()))
    }

    /// The path rewound once, and every motion asked about: starts, ends, answers.
    fn rewind_tries<'py>(
        &self,
        py: Python<'py>,
        waypoints: PyReadonlyArray2<'py, f64>,
        step: f64,
        direction: &str,
    ) -> PyResult<Tries<'py>> {
        let engine = engine_of(py, self, Engine::default().name(), Interference::default().name())?;
        let (waypoints, direction) = (points(waypoints.as_slice()?), named(direction)?);
        let trace = interruptible(py, |interrupted| {
            trace_rewinding(&*engine, &waypoints, step, direction, &Watch::on(interrupted))
        })?;
        let rows = |list: &mut dyn Iterator<Item = Point>| triples(py, list.flat_map(|p| [p.x, p.y, p.z]).collect());
        Ok((
            rows(&mut trace.path.iter().copied())?,
            rows(&mut trace.tries.iter().map(|t| t.from))?,
            rows(&mut trace.tries.iter().map(|t| t.to))?,
            trace.tries.iter().map(|t| t.valid).collect(),
        ))
    }

    /// What there is to draw, as JSON: obstacles by name, world; platform and attachments around the platform's origin,
    /// turned as in the scene. Each part has vertices and faces, corners counter-clockwise seen from outside.
    fn bodies(&self) -> PyResult<String> {
        answered(|| Ok(drawn(&self.0)))
    }

    /// Each forbidden region as summary (JSON), vertices (n, 3) and triangles (m, 3).
    fn regions<'py>(
        &self,
        py: Python<'py>,
        space: Option<&str>,
        all: bool,
        cables: Vec<String>,
        obstacles: Vec<String>,
    ) -> PyResult<Vec<Region<'py>>> {
        let options = region_options(space, all, cables, obstacles)?;
        let found = interruptible(py, |stop| regions_within(&self.0, &options, &Watch::on(stop)))?;
        let arrays = |region: &NamedMesh| {
            let vertices = region.mesh.vertices.iter().flat_map(|v| [v.x, v.y, v.z]).collect();
            let triangles = region.mesh.triangles.iter().flatten().map(|i| *i as i64).collect();
            Ok((serialized(&region.summary()), triples(py, vertices)?, triples(py, triangles)?))
        };
        found.meshes.iter().map(arrays).collect()
    }

    /// Writes forbidden regions in the format that the extension names.
    fn save_regions(
        &self,
        py: Python<'_>,
        path: std::path::PathBuf,
        space: Option<&str>,
        all: bool,
        cables: Vec<String>,
        obstacles: Vec<String>,
    ) -> PyResult<()> {
        answered(|| io::RegionFormat::of(&path).and_then(|_| io::check_target(&path)))?;
        let options = region_options(space, all, cables, obstacles)?;
        let found = interruptible(py, |stop| regions_within(&self.0, &options, &Watch::on(stop)))?;
        py.detach(|| answered(|| io::save_regions(&path, &self.0, &found)))
    }

    /// A self-contained page that shows the scene and, if given, a path.
    #[allow(clippy::too_many_arguments)] // one per thing shown
    fn page(
        &self,
        py: Python<'_>,
        status: Option<String>,
        waypoints: Option<PyReadonlyArray2<'_, f64>>,
        cost: Option<f64>,
        raw_waypoints: Option<PyReadonlyArray2<'_, f64>>,
        raw_cost: Option<f64>,
        planner: Option<String>,
        tree: Option<Tree<'_>>,
        interference: &str,
    ) -> PyResult<String> {
        let list = |rows: Option<PyReadonlyArray2<'_, f64>>| {
            rows.map_or(Ok(Vec::new()), |rows| Ok::<_, PyErr>(points(rows.as_slice()?)))
        };
        let Some(waypoints) = waypoints else {
            return interruptible(py, |stop| page_within(&self.0, None, &[], &Watch::on(stop)));
        };
        let waypoints = points(waypoints.as_slice()?);
        let engine = engine_of(py, self, Engine::default().name(), interference)?;
        let raw_waypoints = list(raw_waypoints)?;
        let tree = tree.map(search_tree).transpose()?.unwrap_or_default().into();
        let shown = ShownPath { status, waypoints, cost, raw_waypoints, raw_cost, planner, tree };
        interruptible(py, |stop| {
            let watch = Watch::on(stop);
            let violations = check_path(&*engine, &shown.waypoints, &watch)?.violations;
            page_within(&self.0, Some(&shown), &violations, &watch)
        })
    }
}

type Planned<'py> = (String, TreeArrays<'py>);
type TreeArrays<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray1<i64>>);
type Tree<'py> = (PyReadonlyArray2<'py, f64>, PyReadonlyArray1<'py, i64>);

/// The states of a search tree as rows, and the parent of each.
fn tree_arrays<'py>(py: Python<'py>, tree: &SearchTree<Point>) -> PyResult<TreeArrays<'py>> {
    let states = tree.states.iter().flat_map(|state| [state.x, state.y, state.z]).collect();
    let parents = tree.parents.iter().map(|parent| *parent as i64).collect();
    Ok((triples(py, states)?, PyArray1::from_vec(py, parents)))
}

fn search_tree((states, parents): Tree) -> PyResult<SearchTree<Point>> {
    let states = points(states.as_slice()?);
    let known = |parent: &i64| usize::try_from(*parent).ok().filter(|parent| *parent < states.len());
    let found: Option<Vec<usize>> = parents.as_slice()?.iter().map(known).collect();
    let parents = found.filter(|parents| parents.len() == states.len()).ok_or_else(|| {
        raised(Error::invalid("tree.parents", "found others, expected for each state the index of its parent"))
    })?;
    Ok(SearchTree { states, parents })
}

/// Runs a search that tells of better paths; a Ctrl-C that comes when there is a path ends the search with it.
fn heard<T: Send>(
    py: Python<'_>,
    on_improvement: Option<&Py<PyAny>>,
    search: impl FnOnce(&Interrupt, &Listener<Point>) -> Result<T, Error> + Send,
) -> PyResult<T> {
    let failure: Mutex<Option<PyErr>> = Mutex::default();
    let failed = || failure.lock().unwrap_or_else(PoisonError::into_inner);
    let tell = |seconds: f64, cost: f64, path: &[Point]| {
        let Some(callback) = on_improvement else { return };
        let told = Python::attach(|py| {
            let waypoints = triples(py, path.iter().flat_map(|p| [p.x, p.y, p.z]).collect())?;
            callback.call1(py, (seconds, cost, waypoints)).map(drop)
        });
        *failed() = told.err();
    };
    let (found, signal) =
        interruptible_with_rest(py, |interrupted| search(&|| interrupted() || failed().is_some(), &tell));
    let stopped = |error: &PyErr| error.is_instance_of::<PyKeyboardInterrupt>(py);
    match (failed().take(), signal) {
        (Some(error), _) => Err(error),
        (None, Some(signal)) if !(stopped(&signal) && found.is_ok()) => Err(signal),
        _ => found.map_err(raised),
    }
}

type Tries<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>, Vec<bool>);
type Region<'py> = (String, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<i64>>);

fn region_options(
    space: Option<&str>,
    all: bool,
    cables: Vec<String>,
    obstacles: Vec<String>,
) -> PyResult<RegionOptions> {
    Ok(RegionOptions { space: space.map(named).transpose()?, all, cables, obstacles })
}

fn quaternion(turn: &Rotation) -> [f64; 4] {
    [turn.w, turn.i, turn.j, turn.k]
}

fn faces(body: &Polytope) -> Value {
    let vertices: Vec<[f64; 3]> = body.vertices().iter().map(|&v| v.into()).collect();
    json!({ "vertices": vertices, "faces": body.facets().iter().map(|f| &f.corners).collect::<Vec<_>>() })
}

/// What [`Scene::bodies`] answers.
fn drawn(scene: &cdpr_core::Scene) -> String {
    let turned = |part: &Polytope| part.transformed(scene.orientation(), &Vector::zeros());
    let cables = scene.robot().cables();
    json!({
        "obstacles": scene.obstacles().iter().map(|o| json!({
            "name": o.name,
            "parts": o.parts.iter().map(faces).collect::<Vec<_>>(),
        })).collect::<Vec<_>>(),
        "platform": scene.robot().parts().iter().map(|part| faces(&turned(part))).collect::<Vec<_>>(),
        "cables": cables.iter().map(|cable| json!({
            "name": cable.name,
            "outlet": <[f64; 3]>::from(cable.outlet),
            "attachment": <[f64; 3]>::from(scene.orientation() * cable.attachment),
        })).collect::<Vec<_>>(),
    })
    .to_string()
}

/// Checks a robot given as JSON text, and gives it back with its meshes as convex parts.
#[pyfunction]
fn check_robot(py: Python<'_>, text: &str) -> PyResult<String> {
    let robot = interruptible(py, |stop| Loader::new(Watch::on(stop)).robot_from_text(text, Notation::Json, None))?;
    Ok(serialized(robot.spec()))
}

/// Writes a robot file of a robot given as JSON text.
#[pyfunction]
fn save_robot(path: std::path::PathBuf, text: &str) -> PyResult<()> {
    answered(|| io::save_table(&path, io::robot_from_text(text, Notation::Json, None)?.spec()))
}

/// A robot of another program as JSON text, and what was not carried over.
#[pyfunction]
fn import_robot(
    py: Python<'_>,
    path: std::path::PathBuf,
    bodies: Option<std::path::PathBuf>,
    cable_set: Option<String>,
    platform: Option<std::path::PathBuf>,
    units: &str,
) -> PyResult<(String, Vec<String>)> {
    let units = named(units)?;
    let options = io::ImportOptions { bodies, cable_set, platform: platform.map(|mesh| (mesh, units)) };
    let found = interruptible(py, |stop| Loader::new(Watch::on(stop)).import(&path, &options))?;
    Ok((serialized(&found.whole), found.notes))
}

/// The robot of a robot file as JSON text.
#[pyfunction]
fn load_robot(py: Python<'_>, path: std::path::PathBuf) -> PyResult<String> {
    let robot = interruptible(py, |stop| Loader::new(Watch::on(stop)).robot(&path))?;
    Ok(serialized(robot.spec()))
}

/// Points whose hulls are made in well below a millisecond, less than a thread is worth.
const FEW_POINTS: usize = 200;

/// Distance of the convex hulls of two vertex lists, with nearest points and overlap depth.
#[pyfunction]
fn polytope_distance(
    py: Python<'_>,
    a: PyReadonlyArray2<'_, f64>,
    b: PyReadonlyArray2<'_, f64>,
) -> PyResult<(f64, [f64; 3], [f64; 3], f64)> {
    let hull = |place: &str, points: &[Point]| {
        Polytope::hull_of(points).map_err(|problem| Error::invalid(place, problem.to_string()))
    };
    let (a, b) = (points(a.as_slice()?), points(b.as_slice()?));
    let few = a.len() + b.len() <= FEW_POINTS;
    let answer = move || Ok(distance(&hull("a", &a)?, &hull("b", &b)?));
    let found = if few { answered(answer) } else { abandonable(py, answer) }?;
    Ok((found.distance, found.on_a.into(), found.on_b.into(), found.depth))
}

/// Waypoints, orientation, all that the file says as JSON, and a warning if it was planned for another scene.
type LoadedPath = (Vec<[f64; 3]>, Option<[f64; 4]>, String, Option<String>);

/// The waypoints of a path file as rows, and its orientation; strictly, a file of another scene is an error.
#[pyfunction]
fn load_path(path: std::path::PathBuf, scene: Option<&Scene>, strict: bool) -> PyResult<LoadedPath> {
    let (loaded, of_scene) = answered(|| {
        let loaded = io::load_waypoints(&path)?;
        let of_scene = scene.map(|scene| io::scene_of_path(&scene.0, &loaded, strict).map_err(|e| e.in_file(&path)));
        Ok((loaded, of_scene.transpose()?))
    })?;
    let (turned, warning) = of_scene.unzip();
    let said = loaded.file.as_ref().and_then(|file| file.orientation);
    let orientation = said.or(turned.map(|scene| quaternion(scene.orientation())));
    let json = loaded.file.map_or("{}".to_string(), |file| serialized(&file));
    Ok((loaded.waypoints.into_iter().map(Into::into).collect(), orientation, json, warning.flatten()))
}

/// Writes the JSON of a result as a path file, or its waypoints as CSV.
#[pyfunction]
fn save_path(path: std::path::PathBuf, json: &str) -> PyResult<()> {
    answered(|| io::save_path(&path, &io::text::parse(json, Notation::Json)?))
}

/// The JSON Schema of the scene, robot, path or experiment format as JSON text.
#[pyfunction]
fn schema(of: &str) -> PyResult<String> {
    answered(|| Ok(io::schema(Choice::named(of)?).to_string()))
}

/// Checks that a file can be written, before the work for it is done.
#[pyfunction]
fn check_target(path: std::path::PathBuf) -> PyResult<()> {
    answered(|| io::check_target(&path))
}

/// Writes a text file whole or not at all.
#[pyfunction]
fn save_text(path: std::path::PathBuf, text: &str) -> PyResult<()> {
    answered(|| io::write_atomically(&path, text.as_bytes()))
}

/// Fails as a bug would, on this thread or on another one, so that a test can see what becomes of it.
#[pyfunction]
fn panic(py: Python<'_>, thread: &str) -> PyResult<()> {
    let bug = || -> Result<(), Error> { panic!("this is a test") };
    match thread {
        "other" => interruptible(py, |_| bug()),
        "abandonable" => abandonable(py, bug),
        _ => answered(bug),
    }
}

#[pymodule(gil_used = false)]
mod _core {
    #[pymodule_export]
    use super::batch::Experiment;
    #[pymodule_export]
    use super::wrench::Statics;
    #[pymodule_export]
    use super::wrench_map::Map;
    use super::*;
    #[pymodule_export]
    use super::{
        Scene, check_robot, check_target, import_robot, load_path, load_robot, panic, polytope_distance, save_path,
        save_robot, save_text, schema,
    };

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        forked::loaded();
        module.add("MAX_COORDINATE", cdpr_core::numerics::MAX_COORDINATE)?;
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
