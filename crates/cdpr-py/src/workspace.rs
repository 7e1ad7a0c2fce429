//! Proved workspaces.

use std::path::PathBuf;
use std::sync::Arc;

use cdpr_core::Choice;
use cdpr_core::CompiledScene;
use cdpr_core::batch::BatchOptions;
use cdpr_core::watch::{TimeUnit, Watch, time_budget};
use cdpr_core::workspace::{ValidAt, Workspace as Found, WorkspaceOptions, orientations_for, workspace};
use cdpr_files::{WorkspaceFormat, check_target, workspace_bytes, workspace_from_json, write_atomically};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::convert::triples;
use crate::errors::{Failure, answered, kept_on_interrupt};
use crate::scene::Scene;

/// A proved workspace of a scene.
#[pyclass(frozen, module = "cdpr._core")]
pub struct Workspace(Found);

type Corners<'py> = Bound<'py, PyArray2<f64>>;
type Indices<'py> = Bound<'py, PyArray1<i64>>;

#[pymethods]
impl Workspace {
    /// The workspace of a scene at the orientations of these copies of it, or during the turns between them. On Ctrl-C, the rest is
    /// undecided.
    #[staticmethod]
    fn of(
        py: Python<'_>,
        scenes: Vec<Py<Scene>>,
        valid_at: &str,
        resolution: Option<f64>,
        budget: Option<f64>,
        threads: Option<usize>,
    ) -> PyResult<Self> {
        let valid_at = answered(|| ValidAt::named(valid_at))?;
        let budget = answered(|| budget.map(|seconds| time_budget("budget", seconds, TimeUnit::Second)).transpose())?;
        kept_on_interrupt(py, Failure::default(), |stop, _| {
            let watch = Watch::on(stop).with_budget(budget);
            let compiled: Vec<Arc<CompiledScene>> = if valid_at == ValidAt::Turns {
                let given: Vec<_> = scenes.iter().map(|scene| scene.get().0.clone()).collect();
                let at =
                    |scene| CompiledScene::new(scene, Default::default(), Default::default(), &watch).map(Arc::new);
                orientations_for(&given, valid_at)?.iter().map(at).collect::<Result<_, _>>()?
            } else {
                scenes.iter().map(|scene| scene.get().compiled_within(&watch)).collect::<Result<_, _>>()?
            };
            let options = WorkspaceOptions { resolution, valid_at };
            workspace(&compiled.iter().map(|at| &**at).collect::<Vec<_>>(), &options, &BatchOptions { threads, watch })
                .map(Workspace)
        })
    }

    /// All but the boxes, as JSON.
    fn report(&self) -> PyResult<String> {
        answered(|| Ok(self.0.summary().to_string()))
    }

    /// The boxes: smallest and largest coordinates, verdicts, parts, causes.
    fn boxes<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Corners<'py>, Corners<'py>, Indices<'py>, Indices<'py>, Indices<'py>)> {
        let boxes = &self.0.boxes;
        let corners = |corners: &[[f64; 3]]| triples(py, corners.as_flattened().to_vec());
        let indices = |indices: &[i64]| PyArray1::from_slice(py, indices);
        let (lower, upper) = (corners(&boxes.lower)?, corners(&boxes.upper)?);
        Ok((lower, upper, indices(&boxes.verdict), indices(&boxes.part), indices(&boxes.cause)))
    }

    /// A self-contained page that shows it in its scene.
    fn page(&self, py: Python<'_>, scene: &Scene) -> PyResult<String> {
        py.detach(|| answered(|| cdpr_view::workspace_page(&scene.0, &self.0)))
    }

    /// Writes a file in the format given by the extension.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        answered(|| {
            let format = WorkspaceFormat::of(&path)?;
            check_target(&path)?;
            write_atomically(&path, &workspace_bytes(format, &self.0).map_err(|e| e.at("path"))?)
        })
    }

    /// The bytes of a .json file.
    fn to_bytes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        Ok(PyBytes::new(py, &answered(|| workspace_bytes(WorkspaceFormat::Json, &self.0))?))
    }

    /// A workspace from the bytes of a .json file.
    #[staticmethod]
    fn from_bytes(bytes: &[u8]) -> PyResult<Self> {
        answered(|| workspace_from_json(bytes).map(Workspace))
    }
}
