//! Scenes as compiled, when first needed, and kept.

use std::sync::{Arc, Mutex, PoisonError};

use cdpr_core::collision::{Engine, Interference};
use cdpr_core::compiled::CompiledScene;
use cdpr_core::watch::Watch;
use cdpr_core::{Error, Scene};
use pyo3::prelude::*;

use crate::errors::interruptible;

/// One scene, compiled for the engines requested so far; scenes that differ only in their query may share them.
#[derive(Clone, Default)]
pub struct Engines {
    own: Arc<Mutex<Vec<Known>>>,
    /// A scene that differs little from this one, as compiled.
    alike: Vec<Known>,
}

type Kind = (Engine, Interference);
type Known = (Kind, Arc<CompiledScene>);

impl Engines {
    /// The engines of a scene that differs little from the scene of these.
    pub fn alike(&self) -> Self {
        let own = self.own.lock().unwrap_or_else(PoisonError::into_inner);
        Engines { own: Arc::default(), alike: if own.is_empty() { self.alike.clone() } else { own.clone() } }
    }

    /// The scene compiled for an engine; Ctrl-C ends it.
    pub fn get(&self, py: Python<'_>, scene: &Scene, kind: Kind) -> PyResult<Arc<CompiledScene>> {
        match self.known(kind) {
            Some(compiled) => Ok(compiled),
            None => interruptible(py, |stop| self.compiled(scene, kind, &Watch::on(stop))),
        }
    }

    /// The scene compiled within a watch. Two threads may compile at the same time; neither waits for the other.
    pub fn compiled(&self, scene: &Scene, kind: Kind, watch: &Watch) -> Result<Arc<CompiledScene>, Error> {
        if let Some(compiled) = self.known(kind) {
            return Ok(compiled);
        }
        let compiled = match self.alike.iter().find(|(known, _)| *known == kind) {
            Some((_, alike)) => alike.recompiled(scene, watch)?,
            None => CompiledScene::new(scene, kind.0, kind.1, watch)?,
        };
        let compiled = Arc::new(compiled);
        self.own.lock().unwrap_or_else(PoisonError::into_inner).push((kind, compiled.clone()));
        Ok(compiled)
    }

    fn known(&self, wanted: Kind) -> Option<Arc<CompiledScene>> {
        let known = self.own.lock().unwrap_or_else(PoisonError::into_inner);
        known.iter().find(|(kind, _)| *kind == wanted).map(|(_, compiled)| compiled.clone())
    }
}
