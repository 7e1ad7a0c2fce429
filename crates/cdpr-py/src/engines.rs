//! Engines, compiled when first needed and kept.

use std::sync::{Arc, Mutex, PoisonError};

use cdpr_core::collision::{Checker, Engine, Interference};
use cdpr_core::plan::engine_within;
use cdpr_core::turning::TurningEngine;
use cdpr_core::watch::Watch;
use cdpr_core::{Error, Scene};
use pyo3::prelude::*;

use crate::errors::interruptible;

/// The engines compiled for one scene so far.
#[derive(Default)]
pub struct Engines {
    level: Known<dyn Checker>,
    turning: Known<TurningEngine>,
}

type Kind = (Engine, Interference);
type Known<E> = Mutex<Vec<(Kind, Arc<E>)>>;

impl Engines {
    /// The engine for motions at the orientation of the scene.
    pub fn level(&self, py: Python<'_>, scene: &Scene, kind: Kind) -> PyResult<Arc<dyn Checker>> {
        match known(&self.level, kind) {
            Some(engine) => Ok(engine),
            None => interruptible(py, |stop| self.compiled(scene, kind, &Watch::on(stop))),
        }
    }

    /// The engine for motions from pose to pose.
    pub fn turning(&self, py: Python<'_>, scene: &Scene, kind: Kind) -> PyResult<Arc<TurningEngine>> {
        if let Some(engine) = known(&self.turning, kind) {
            return Ok(engine);
        }
        interruptible(py, |stop| {
            let level = self.compiled(scene, kind, &Watch::on(stop))?;
            Ok(kept(&self.turning, kind, TurningEngine::new(scene, level)?.into()))
        })
    }

    /// As [`Engines::level`], within a watch. Two threads may compile at the same time; neither waits for the other.
    pub fn compiled(&self, scene: &Scene, kind: Kind, watch: &Watch) -> Result<Arc<dyn Checker>, Error> {
        match known(&self.level, kind) {
            Some(engine) => Ok(engine),
            None => Ok(kept(&self.level, kind, engine_within(scene, kind.0, kind.1, watch)?)),
        }
    }
}

fn known<E: ?Sized>(engines: &Known<E>, wanted: Kind) -> Option<Arc<E>> {
    let known = engines.lock().unwrap_or_else(PoisonError::into_inner);
    known.iter().find(|(kind, _)| *kind == wanted).map(|(_, engine)| engine.clone())
}

fn kept<E: ?Sized>(engines: &Known<E>, kind: Kind, engine: Arc<E>) -> Arc<E> {
    engines.lock().unwrap_or_else(PoisonError::into_inner).push((kind, engine.clone()));
    engine
}
