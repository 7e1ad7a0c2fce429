//! Maps of margins.

use cdpr_core::Error;
use cdpr_core::batch::BatchOptions;
use cdpr_core::collision::Conditions;
use cdpr_core::geometry::Aabb;
use cdpr_core::watch::Watch;
use cdpr_core::wrench::{MapIdentity, MapOptions, Statics, WrenchMap, constraint};
use numpy::{PyArray1, PyArray3, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::errors::{answered, interruptible};
use crate::scene::Scene;

/// A map of margins over the positions of a scene.
#[pyclass(frozen, module = "cdpr._core", name = "WrenchMap")]
pub struct Map(WrenchMap);

#[pymethods]
impl Map {
    /// The map of a scene.
    #[staticmethod]
    fn of(
        py: Python<'_>,
        scene: &Scene,
        step: f64,
        force: Option<f64>,
        moment: Option<f64>,
        projected: bool,
        threads: Option<usize>,
    ) -> PyResult<Self> {
        let scene = &scene.0;
        let statics = answered(|| Statics::only(scene, "a map"))?;
        let required = answered(|| constraint::required_of(scene, force, moment))?;
        let options = MapOptions { step, projected };
        interruptible(py, |interrupted| {
            let (min, max) = Conditions::within(scene, &Watch::on(interrupted))?.position_box();
            WrenchMap::new(
                &statics,
                &required,
                &Aabb { min, max },
                &options,
                &BatchOptions { threads, watch: Watch::on(interrupted) },
            )
        })
        .map(Map)
    }

    /// Loads a map; an error if it does not match this scene.
    #[staticmethod]
    fn load(
        path: std::path::PathBuf,
        scene: Option<&Scene>,
        force: Option<f64>,
        moment: Option<f64>,
    ) -> PyResult<Self> {
        let identity = |scene: &Scene| -> Result<MapIdentity, Error> {
            Ok(MapIdentity::of(&Statics::only(&scene.0, "a map")?, &constraint::required_of(&scene.0, force, moment)?))
        };
        answered(|| cdpr_files::load_wrench_map(&path, scene.map(identity).transpose()?.as_ref()).map(Map))
    }

    /// Writes a .npz or .vti file.
    fn save(&self, path: std::path::PathBuf) -> PyResult<()> {
        answered(|| cdpr_files::save_wrench_map(&path, &self.0))
    }

    /// The bytes of an .npz file.
    fn to_bytes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        Ok(PyBytes::new(py, &answered(|| Ok(cdpr_files::wrench_map_to_npz(&self.0)))?))
    }

    /// A map from the bytes of an .npz file.
    #[staticmethod]
    fn from_bytes(bytes: &[u8]) -> PyResult<Self> {
        answered(|| cdpr_files::wrench_map_from_npz(bytes).map(Map))
    }

    /// Capacity margins, (nx, ny, nz).
    fn capacity<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        shaped(py, &self.0, &self.0.margins().capacity)
    }

    /// Force margins, if computed.
    fn force<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyArray3<f64>>>> {
        self.0.margins().force.as_deref().map(|margins| shaped(py, &self.0, margins)).transpose()
    }

    /// Moment margins, if computed.
    fn moment<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyArray3<f64>>>> {
        self.0.margins().moment.as_deref().map(|margins| shaped(py, &self.0, margins)).transpose()
    }

    /// Origin and step of the grid; share, volume and, if there is one, extent of the feasible region.
    fn summary(&self) -> PyResult<Summary> {
        let found = answered(|| Ok(self.0.summary()))?;
        let extent = found.extent.map(|extent| [extent.min.into(), extent.max.into()]);
        Ok((found.grid.origin.into(), found.grid.step, found.share, found.volume, extent))
    }
}

type Summary = ([f64; 3], f64, f64, f64, Option<[[f64; 3]; 2]>);

fn shaped<'py>(py: Python<'py>, map: &WrenchMap, margins: &[f64]) -> PyResult<Bound<'py, PyArray3<f64>>> {
    PyArray1::from_slice(py, margins).reshape(map.grid().counts)
}
