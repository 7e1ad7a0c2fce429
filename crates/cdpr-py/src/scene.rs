//! The class `Scene`: validity, clearance, checks, tensions and planning.

use std::collections::HashSet;
use std::sync::Arc;

use cdpr_core::collision::many::{clearances, motions_valid, states_valid};
use cdpr_core::collision::{Conditions, Engine, Interference, Validity, check_path, nearest_valid};
use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::{Point, Pose, Rotation, rotation_as_written};
use cdpr_core::model::Station;
use cdpr_core::path::{self, length, tensions_along};
use cdpr_core::plan::{NoPath, PlanOptions, Post, Query, shorten};
use cdpr_core::proof::certificate_ends;
use cdpr_core::regions::{NamedMesh, RegionOptions, regions_within};
use cdpr_core::turning::turn_weight;
use cdpr_core::watch::{Interrupt, TimeUnit, Watch, time_budget};
use cdpr_core::wrench::{self as core_wrench, TensionRow};
use cdpr_core::{Choice, Error};
use cdpr_files::{Loader, PathFile, text::Notation};
use cdpr_view::{Contents, Form, Planning, page_within, regions_page};
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::bound::{Wanted, least_bound};
use crate::convert::{answer_array, named, point, quaternion, row, serialized, serialized_as_in_files, triples};
use crate::drawing::drawn;
use crate::engines::Engines;
use crate::errors::{abandonable, answered, interruptible, raised};
use crate::rewinding::{self, Tries};
use crate::search::{Tree, search_tree};
use crate::turning::{self, Orientation, PoseRows, Position, between, pose};

/// A checked scene and the engines compiled for it so far.
#[pyclass(frozen, module = "cdpr._core")]
pub struct Scene(pub cdpr_core::Scene, pub Engines);

impl Scene {
    pub fn of(scene: cdpr_core::Scene) -> Self {
        Scene(scene, Engines::default())
    }

    /// The scene compiled for an engine and a rule.
    pub fn compiled_for(&self, py: Python<'_>, kind: (Engine, Interference)) -> PyResult<Arc<CompiledScene>> {
        self.1.get(py, &self.0, kind)
    }

    /// The scene compiled for an engine.
    fn compiled(&self, py: Python<'_>, engine: &str, interference: &str) -> PyResult<Arc<CompiledScene>> {
        self.compiled_for(py, (named(engine)?, named(interference)?))
    }

    /// The scene compiled for the default engine, within a watch.
    pub fn compiled_within(&self, watch: &Watch) -> Result<Arc<CompiledScene>, Error> {
        self.1.compiled(&self.0, Default::default(), watch)
    }

    /// The scene compiled for the motions between some poses.
    fn ready_for(
        &self,
        py: Python<'_>,
        poses: &[Pose],
        engine: &str,
        interference: &str,
    ) -> PyResult<Arc<CompiledScene>> {
        let compiled = self.compiled(py, engine, interference)?;
        answered(|| compiled.ready_for(poses))?;
        Ok(compiled)
    }
}

#[pymethods]
impl Scene {
    /// Loads a scene file.
    #[staticmethod]
    fn load(py: Python<'_>, path: std::path::PathBuf) -> PyResult<Self> {
        interruptible(py, |stop| Loader::new(Watch::on(stop)).scene(&path)).map(Scene::of)
    }

    /// A scene from JSON text, with an inline robot.
    #[staticmethod]
    fn from_json(py: Python<'_>, text: &str) -> PyResult<Self> {
        interruptible(py, |stop| Loader::new(Watch::on(stop)).scene_from_text(text, Notation::Json, None))
            .map(Scene::of)
    }

    /// The scene as JSON text, with an inline robot.
    fn to_json(&self) -> String {
        serialized(self.0.written())
    }

    /// The scene as JSON without payloads and task: payloads are among the obstacles or the parts of the platform.
    fn plain(&self) -> String {
        serialized(self.0.spec())
    }

    /// The scene in which the platform carries a payload.
    fn carrying(&self, name: &str) -> PyResult<Scene> {
        answered(|| self.0.carrying(name)).map(Scene::of)
    }

    /// The scene in which a payload stands at a station or position.
    fn placed(&self, name: &str, at: Position) -> PyResult<Scene> {
        answered(|| self.0.placed(name, at.into())).map(Scene::of)
    }

    /// Writes a scene file with an inline robot.
    fn save(&self, path: std::path::PathBuf) -> PyResult<()> {
        answered(|| cdpr_files::save_table(&path, self.0.written()))
    }

    /// Identifies the scene for paths planned in it.
    fn fingerprint(&self) -> PyResult<String> {
        answered(|| Ok(self.0.fingerprint()))
    }

    /// Names and quaternions of the scene's orientations.
    fn orientations(&self) -> Vec<(String, [f64; 4])> {
        self.0.orientations().iter().map(|(name, turn)| (name.clone(), quaternion(turn))).collect()
    }

    /// The scene for a path with this orientation, if any, or with these at its waypoints, (k, 4) (`None` if it is the scene
    /// itself); a warning if the path was planned for another scene, given by name and fingerprint, or with `strict` an error
    /// instead; and whether the platform turns along the path.
    #[pyo3(signature = (orientation, orientation_name=None, planned_for=None, strict=false, turns=None))]
    fn for_path(
        &self,
        orientation: Option<[f64; 4]>,
        orientation_name: Option<&str>,
        planned_for: Option<(String, String)>,
        strict: bool,
        turns: Option<PyReadonlyArray2<'_, f64>>,
    ) -> PyResult<(Option<Scene>, Option<String>, bool)> {
        let id = planned_for.map(|(name, fingerprint)| cdpr_files::SceneId { name, fingerprint });
        let turns = turns.as_ref().map(|turns| turns.as_slice()).transpose()?.unwrap_or_default();
        let turns: Vec<Rotation> = turns.as_chunks().0.iter().map(|turn| rotation_as_written(*turn)).collect();
        let (scene, warning) = answered(|| {
            let said = orientation.map(Into::into).or_else(|| cdpr_files::said_by_turns(&self.0, &turns));
            cdpr_files::scene_for(&self.0, said, orientation_name, id.as_ref(), strict)
        })?;
        let turning = turns.iter().any(|turn| !scene.has_orientation(turn));
        Ok(((scene.orientation() != self.0.orientation()).then(|| Scene::of(scene)), warning, turning))
    }

    /// The scene at another orientation; errors call it `place`.
    fn at(&self, place: &str, orientation: Orientation) -> PyResult<Scene> {
        let source = orientation.source();
        let turned = || self.0.named_orientation(place, &source).and_then(|_| self.0.turned(source));
        Ok(Scene::of(answered(turned)?))
    }

    /// The scene with this start and goal instead of its own, as far as given.
    fn between(&self, start: Option<Position>, goal: Option<Position>) -> PyResult<Scene> {
        let own = self.0.spec().query.clone().unwrap_or_default();
        let ends = [start.map(Into::into).or(own.start), goal.map(Into::into).or(own.goal)];
        let scene = answered(|| between(&self.0, ends))?;
        let engines = if scene.orientation() == self.0.orientation() { self.1.clone() } else { Engines::default() };
        Ok(Scene(scene, engines))
    }

    /// The scene with an obstacle at another place.
    fn moved(&self, name: &str, position: [f64; 3]) -> PyResult<Scene> {
        Ok(Scene(answered(|| self.0.moved(name, position.into()))?, self.1.alike()))
    }

    /// The query as JSON, with positions and orientations in place of the names of stations.
    fn located_query(&self) -> String {
        serialized(&self.0.located_query().unwrap_or_default())
    }

    /// Names and positions of the stations, and their orientations, where they have one.
    fn stations(&self) -> Vec<(String, [f64; 3], Option<[f64; 4]>)> {
        let station = |s: &Station| (s.name.clone(), s.position.into(), s.orientation.as_ref().map(quaternion));
        self.0.stations().iter().map(station).collect()
    }

    /// Whether the scene lists several orientations and selects none.
    fn orientation_is_open(&self) -> bool {
        self.0.orientation_is_open()
    }

    /// Notes for the user about the scene.
    fn notes(&self, py: Python<'_>) -> PyResult<Vec<String>> {
        Ok(interruptible(py, |stop| Conditions::within(&self.0, &Watch::on(stop)))?.remarks())
    }

    /// The warnings to issue, except for notes that were already told: one in place of many notes that are alike.
    fn warnings(&self, py: Python<'_>, told: Vec<String>) -> PyResult<Vec<String>> {
        let known: HashSet<&String> = told.iter().chain(self.0.good_notes()).collect();
        let new: Vec<String> = self.notes(py)?.into_iter().filter(|note| !known.contains(note)).collect();
        Ok(self.0.in_brief(&new))
    }

    /// Whether each row of an (n, 3) array is a valid position, at the scene's orientation or that in the same row of an (n, 4)
    /// array.
    #[pyo3(signature = (positions, engine, interference, threads, orientations=None))]
    fn states_valid<'py>(
        &self,
        py: Python<'py>,
        positions: PyReadonlyArray2<'py, f64>,
        engine: &str,
        interference: &str,
        threads: Option<usize>,
        orientations: Option<PyReadonlyArray2<'py, f64>>,
    ) -> PyResult<Bound<'py, PyArray1<bool>>> {
        let (rows, compiled) = (positions.as_slice()?, self.compiled(py, engine, interference)?);
        let Some(turns) = &orientations else {
            return answer_array(py, rows.len() / 3, threads, |answers, options| {
                states_valid(compiled.level(), |k| row(rows, k), answers, options)
            });
        };
        answered(|| compiled.turning().map(drop))?;
        let poses = PoseRows::of(&self.0, rows, Some(turns.as_slice()?));
        answer_array(py, poses.count(), threads, |answers, options| {
            turning::motions_valid(&compiled, [poses; 2], answers, options)
        })
    }

    /// Whether each straight motion between rows of two (n, 3) arrays is valid, at the scene's orientation or from and to those in
    /// two (n, 4) arrays.
    #[allow(clippy::too_many_arguments)] // one per keyword of Scene.motions_valid
    #[pyo3(signature = (starts, ends, engine, interference, threads, orientations=None))]
    fn motions_valid<'py>(
        &self,
        py: Python<'py>,
        starts: PyReadonlyArray2<'py, f64>,
        ends: PyReadonlyArray2<'py, f64>,
        engine: &str,
        interference: &str,
        threads: Option<usize>,
        orientations: Option<(PyReadonlyArray2<'py, f64>, PyReadonlyArray2<'py, f64>)>,
    ) -> PyResult<Bound<'py, PyArray1<bool>>> {
        let (starts, ends) = (starts.as_slice()?, ends.as_slice()?);
        let compiled = self.compiled(py, engine, interference)?;
        let Some((first, last)) = &orientations else {
            return answer_array(py, starts.len() / 3, threads, |answers, options| {
                motions_valid(compiled.level(), |k| (row(starts, k), row(ends, k)), answers, options)
            });
        };
        answered(|| compiled.turning().map(drop))?;
        let starts = PoseRows::of(&self.0, starts, Some(first.as_slice()?));
        let ends = PoseRows::of(&self.0, ends, Some(last.as_slice()?));
        answer_array(py, starts.count(), threads, |answers, options| {
            turning::motions_valid(&compiled, [starts, ends], answers, options)
        })
    }

    /// Whether one straight motion is valid, at the scene's orientation or from one orientation to another.
    #[pyo3(signature = (start, end, engine, interference, orientations=None))]
    fn motion_valid(
        &self,
        py: Python<'_>,
        start: [f64; 3],
        end: [f64; 3],
        engine: &str,
        interference: &str,
        orientations: Option<([f64; 4], [f64; 4])>,
    ) -> PyResult<bool> {
        let (first, last) = orientations.unzip();
        let ends = [pose(&self.0, start, first), pose(&self.0, end, last)];
        let compiled = self.ready_for(py, &ends, engine, interference)?;
        answered(|| Ok(compiled.motion_valid(&ends[0], &ends[1])))
    }

    /// World-from-platform unit quaternion, w x y z.
    fn orientation(&self) -> [f64; 4] {
        quaternion(self.0.orientation())
    }

    /// Orientations at start and goal, w x y z.
    fn end_orientations(&self) -> [[f64; 4]; 2] {
        self.0.end_orientations().each_ref().map(quaternion)
    }

    /// Whether the platform may turn on its way from start to goal.
    fn turns(&self) -> bool {
        Query::of(&self.0).turns()
    }

    /// Length of a turn by one radian, m.
    fn turn_weight(&self) -> f64 {
        turn_weight(&self.0)
    }

    /// Smallest and largest coordinates of the positions at which the platform is inside the workspace.
    fn position_box(&self, py: Python<'_>) -> PyResult<([f64; 3], [f64; 3])> {
        let (min, max) = interruptible(py, |stop| Conditions::within(&self.0, &Watch::on(stop)))?.position_box();
        Ok((min.into(), max.into()))
    }

    /// The signed clearance of each row of an (n, 3) array, m, at the scene's orientation or that in the same row of an (n, 4)
    /// array.
    #[pyo3(signature = (positions, threads, orientations=None))]
    fn clearance<'py>(
        &self,
        py: Python<'py>,
        positions: PyReadonlyArray2<'py, f64>,
        threads: Option<usize>,
        orientations: Option<PyReadonlyArray2<'py, f64>>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let (rows, usual) = (positions.as_slice()?, (Engine::default().name(), Interference::default().name()));
        let compiled = self.compiled(py, usual.0, usual.1)?;
        let Some(turns) = &orientations else {
            return answer_array(py, rows.len() / 3, threads, |answers, options| {
                clearances(compiled.level(), |k| row(rows, k), answers, options)
            });
        };
        answered(|| compiled.turning().map(drop))?;
        let poses = PoseRows::of(&self.0, rows, Some(turns.as_slice()?));
        answer_array(py, poses.count(), threads, |answers, options| {
            turning::clearances(&compiled, poses, answers, options)
        })
    }

    /// The violations of a motion as JSON, in the order in which they begin; at the scene's orientation, or from one orientation to
    /// another.
    #[pyo3(signature = (start, end, engine, interference, orientations=None))]
    fn violations(
        &self,
        py: Python<'_>,
        start: [f64; 3],
        end: [f64; 3],
        engine: &str,
        interference: &str,
        orientations: Option<([f64; 4], [f64; 4])>,
    ) -> PyResult<String> {
        let (first, last) = orientations.unzip();
        let ends = [pose(&self.0, start, first), pose(&self.0, end, last)];
        let compiled = self.ready_for(py, &ends, engine, interference)?;
        abandonable(py, move |_| Ok(serialized(&compiled.violations(&ends[0], &ends[1]))))
    }

    /// A valid position near a position, `margin` metres inside the valid ones, at the scene's orientation or at another one; `None` if
    /// none was found.
    #[pyo3(signature = (position, margin, engine, interference, orientation=None))]
    fn nearest_valid(
        &self,
        py: Python<'_>,
        position: [f64; 3],
        margin: f64,
        engine: &str,
        interference: &str,
        orientation: Option<[f64; 4]>,
    ) -> PyResult<Option<[f64; 3]>> {
        let at = pose(&self.0, position, orientation);
        let compiled = self.ready_for(py, &[at], engine, interference)?;
        let valid = |place: &Point| compiled.state_valid(&Pose::new(*place, at.orientation));
        let found = interruptible(py, |stop| {
            nearest_valid(compiled.conditions().position_box(), &at.position, margin, valid, &Watch::on(stop))
        });
        Ok(found?.map(Into::into))
    }

    /// The report on a path as JSON, with the orientation at each waypoint if the platform turns.
    #[pyo3(signature = (waypoints, engine, interference, orientations=None))]
    fn check(
        &self,
        py: Python<'_>,
        waypoints: PyReadonlyArray2<'_, f64>,
        engine: &str,
        interference: &str,
        orientations: Option<PyReadonlyArray2<'_, f64>>,
    ) -> PyResult<String> {
        let path = self.path(&waypoints, orientations.as_ref())?;
        let compiled = self.ready_for(py, &path, engine, interference)?;
        let report = interruptible(py, |stop| path::check(&compiled, &path, &Watch::on(stop)))?;
        Ok(serialized(&report))
    }

    /// Distances, capacity, force and moment margins, (n,), positions, (n, 3), orientations, (n, 4), if the platform turns,
    /// lengths, tensions and, if known anywhere, commanded lengths, angles and torques, (n, m), at even steps along a path; NaN
    /// where there are none.
    #[pyo3(signature = (waypoints, step, reference, chosen, orientations=None))]
    fn tensions_along<'py>(
        &self,
        py: Python<'py>,
        waypoints: PyReadonlyArray2<'py, f64>,
        step: f64,
        reference: Option<Vec<f64>>,
        chosen: Option<&str>,
        orientations: Option<PyReadonlyArray2<'py, f64>>,
    ) -> PyResult<AlongPath<'py>> {
        let required = answered(|| core_wrench::constraint::required_of(&self.0, None, None))?;
        let scene = with_tensions(&self.0, chosen)?;
        let path = self.path(&waypoints, orientations.as_ref())?;
        let along =
            |stop: &Interrupt| tensions_along(&scene, &required, &path, step, reference.as_deref(), &Watch::on(stop));
        let rows = interruptible(py, along)?;
        let column = |value: fn(&TensionRow) -> f64| PyArray1::from_iter(py, rows.iter().map(value));
        let matrix = |width: usize, values: &dyn Fn(&TensionRow) -> Vec<f64>| {
            PyArray1::from_vec(py, rows.iter().flat_map(values).collect()).reshape([rows.len(), width])
        };
        let (count, turns) = (self.0.robot().cables().len(), rows.iter().any(|row| row.place.orientation.is_some()));
        let columns = [
            column(|row| row.place.s),
            column(|row| row.capacity_margin.unwrap_or(f64::NAN)),
            column(|row| row.force_margin.unwrap_or(f64::NAN)),
            column(|row| row.moment_margin.unwrap_or(f64::NAN)),
        ];
        let quaternions = || matrix(4, &|row| row.place.orientation.unwrap_or_default().to_vec());
        let positions = matrix(3, &|row| row.place.position.to_vec())?;
        let lengths = matrix(count, &|row| row.place.lengths.clone())?;
        let known = |of: fn(&TensionRow) -> &Option<Vec<f64>>| {
            matrix(count, &|row| of(row).clone().unwrap_or_else(|| vec![f64::NAN; count]))
        };
        let of_winches = |of: fn(&TensionRow) -> &Option<Vec<f64>>| {
            rows.iter().any(|row| of(row).is_some()).then(|| known(of)).transpose()
        };
        let winches = [
            of_winches(|row| &row.place.winches.commands)?,
            of_winches(|row| &row.place.winches.angles)?,
            of_winches(|row| &row.place.winches.torques)?,
        ];
        let cables = (lengths, known(|row| &row.tensions)?, winches);
        Ok((columns, positions, turns.then(quaternions).transpose()?, cables))
    }

    /// What the cables can balance at a position, as JSON.
    fn wrench_at(
        &self,
        position: [f64; 3],
        force: Option<f64>,
        moment: Option<f64>,
        chosen: Option<&str>,
    ) -> PyResult<String> {
        let scene = with_tensions(&self.0, chosen)?;
        answered(|| {
            let required = core_wrench::constraint::required_of(&scene, force, moment)?;
            Ok(serialized(&core_wrench::wrench_of_scene_at(&scene, &required, &point(position))?))
        })
    }

    /// Lower bound on the length of every path between two positions, m; with a gap or a budget, one close to a path that is
    /// searched for.
    fn lower_bound(
        &self,
        py: Python<'_>,
        gap: Option<f64>,
        budget: Option<f64>,
        certified: bool,
    ) -> PyResult<(f64, Option<String>)> {
        let [start, goal] = answered(|| Query::of(&self.0).ends())?;
        if gap.is_some() && Query::of(&self.0).turns() {
            let problem = "found one for a platform that may turn, whose bound is only the length of the straight motion; expected none";
            return Err(raised(Error::invalid("gap", problem)));
        }
        let budget = answered(|| budget.map(|seconds| time_budget("budget", seconds, TimeUnit::Second)).transpose())?;
        interruptible(py, |stop| least_bound(&self.0, [&start, &goal], Wanted { gap, budget, certified }, stop))
    }

    /// The shortened path, as JSON; with the orientation at each waypoint if the platform turns, which only string pulling
    /// shortens.
    #[allow(clippy::too_many_arguments)] // one per keyword of cdpr.rewind
    #[pyo3(signature = (waypoints, post, step, repeats, engine, interference, orientations=None))]
    fn shorten(
        &self,
        py: Python<'_>,
        waypoints: PyReadonlyArray2<'_, f64>,
        post: &str,
        step: f64,
        repeats: usize,
        engine: &str,
        interference: &str,
        orientations: Option<PyReadonlyArray2<'_, f64>>,
    ) -> PyResult<String> {
        let path = self.path(&waypoints, orientations.as_ref())?;
        let compiled = self.ready_for(py, &path, engine, interference)?;
        let post: Post = named(post)?;
        let processing = answered(|| post.processing(step, repeats))?;
        let shorter = interruptible(py, |stop| shorten(&compiled, &path, &processing, &Watch::on(stop)))?;
        Ok(serialized_as_in_files(&PathFile::of(&self.0, &shorter)))
    }

    /// The path after rewinding, and every motion checked: starts, ends, results.
    fn rewind_tries<'py>(
        &self,
        py: Python<'py>,
        waypoints: PyReadonlyArray2<'py, f64>,
        step: f64,
        order: &str,
    ) -> PyResult<Tries<'py>> {
        let compiled = self.compiled(py, Engine::default().name(), Interference::default().name())?;
        rewinding::tries(py, compiled.level(), waypoints.as_slice()?, (step, order))
    }

    /// Geometry for drawing, as JSON: obstacles by name, world; platform and attachments relative to the platform's
    /// origin, at the scene's orientation. Each part has vertices and faces, with corners counter-clockwise seen from
    /// outside.
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

    /// Writes forbidden regions in the format given by the extension.
    fn save_regions(
        &self,
        py: Python<'_>,
        path: std::path::PathBuf,
        space: Option<&str>,
        all: bool,
        cables: Vec<String>,
        obstacles: Vec<String>,
    ) -> PyResult<()> {
        answered(|| cdpr_files::RegionFormat::of(&path).and_then(|_| cdpr_files::check_target(&path)))?;
        let options = region_options(space, all, cables, obstacles)?;
        let found = interruptible(py, |stop| regions_within(&self.0, &options, &Watch::on(stop)))?;
        py.detach(|| answered(|| cdpr_files::save_regions(&path, &self.0, &found, regions_page)))
    }

    /// A self-contained page that shows the scene and, if given, a path: the JSON of a path file, and the search tree. With the
    /// certificate of a proof that there is no path, it shows why; this is decided anew.
    fn page(
        &self,
        py: Python<'_>,
        path: Option<&str>,
        tree: Option<Tree<'_>>,
        certificate: Option<&str>,
        interference: &str,
        live: bool,
    ) -> PyResult<String> {
        let form = if live { Form::Live } else { Form::Static };
        let Some(path) = path else {
            return interruptible(py, |stop| page_within(&self.0, Contents::default(), form, &Watch::on(stop)));
        };
        let file: PathFile = answered(|| cdpr_files::text::parse(path, Notation::Json))?;
        let planning = Planning::of_json(path);
        let tree = tree.map(search_tree).transpose()?.unwrap_or_default().into();
        let path = answered(|| file.path(&self.0))?;
        let compiled = self.ready_for(py, &path, Engine::default().name(), interference)?;
        let file = PathFile { cost: Some(length(&self.0, &path)), tree, ..file };
        let ends = answered(|| certificate.map(certificate_ends).transpose())?;
        let options = PlanOptions { interference: named(interference)?, ..PlanOptions::default() };
        interruptible(py, |stop| {
            let watch = Watch::on(stop);
            let decided = |[start, goal]: &[Point; 2]| {
                NoPath::decided(&self.0, compiled.level(), [start, goal], &options, &watch)
            };
            let no_path = ends.as_ref().map(decided).transpose()?.flatten();
            let file = PathFile { no_path: no_path.map(Arc::new), ..file };
            let violations = check_path(&*compiled, &path, &watch)?.violations;
            let contents = Contents { path: Some(&file), planning: planning.as_ref(), violations: &violations };
            page_within(&self.0, contents, form, &watch)
        })
    }
}

impl Scene {
    /// The path of an array of positions, with the orientations in an array if the platform turns.
    pub fn path(
        &self,
        waypoints: &PyReadonlyArray2<'_, f64>,
        orientations: Option<&PyReadonlyArray2<'_, f64>>,
    ) -> PyResult<Vec<Pose>> {
        let turns = orientations.map(|turns| turns.as_slice()).transpose()?;
        Ok(PoseRows::of(&self.0, waypoints.as_slice()?, turns).poses())
    }
}

type Matrix<'py> = Bound<'py, PyArray2<f64>>;
type AlongPath<'py> = ([Bound<'py, PyArray1<f64>>; 4], Matrix<'py>, Option<Matrix<'py>>, OfCables<'py>);
type OfCables<'py> = (Matrix<'py>, Matrix<'py>, [Option<Matrix<'py>>; 3]);

type Region<'py> = (String, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<i64>>);

fn region_options(
    space: Option<&str>,
    all: bool,
    cables: Vec<String>,
    obstacles: Vec<String>,
) -> PyResult<RegionOptions> {
    Ok(RegionOptions { space: space.map(named).transpose()?, all, cables, obstacles })
}

/// The scene with the tensions of a name, if it is given.
fn with_tensions(scene: &cdpr_core::Scene, chosen: Option<&str>) -> PyResult<cdpr_core::Scene> {
    let chosen = chosen.map(named).transpose()?;
    Ok(chosen.map_or_else(|| scene.clone(), |chosen| scene.with_tensions(chosen)))
}
