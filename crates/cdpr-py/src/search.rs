//! Searches: improvements found on the way, and search trees as arrays.

use cdpr_core::Error;
use cdpr_core::geometry::Point;
use cdpr_core::plan::Observer;
use cdpr_core::planning::SearchTree;
use cdpr_core::watch::Interrupt;
use numpy::{PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::convert::{points, triples};
use crate::errors::{Failure, kept_on_interrupt, raised};

pub type TreeArrays<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray1<i64>>);
pub type Tree<'py> = (PyReadonlyArray2<'py, f64>, PyReadonlyArray1<'py, i64>);

/// The states of a search tree as rows, and the parent of each.
pub fn tree_arrays<'py>(py: Python<'py>, tree: &SearchTree<Point>) -> PyResult<TreeArrays<'py>> {
    let states = tree.states.iter().flat_map(|state| [state.x, state.y, state.z]).collect();
    let parents = tree.parents.iter().map(|parent| *parent as i64).collect();
    Ok((triples(py, states)?, PyArray1::from_vec(py, parents)))
}

pub fn search_tree((states, parents): Tree) -> PyResult<SearchTree<Point>> {
    let states = points(states.as_slice()?);
    let known = |parent: &i64| usize::try_from(*parent).ok().filter(|parent| *parent < states.len());
    let found: Option<Vec<usize>> = parents.as_slice()?.iter().map(known).collect();
    let parents = found.filter(|parents| parents.len() == states.len()).ok_or_else(|| {
        raised(Error::invalid("tree.parents", "found wrong indices, expected for each state the index of its parent"))
    })?;
    Ok(SearchTree { states, parents })
}

/// Runs a search with a callback for every better path; on Ctrl-C, the search ends with its best path, if it has one.
pub fn observed<T: Send>(
    py: Python<'_>,
    on_improvement: Option<&Py<PyAny>>,
    search: impl FnOnce(&dyn Observer) -> Result<T, Error> + Send,
) -> PyResult<T> {
    kept_on_interrupt(py, Failure::default(), |stop, failure| {
        search(&Callback { stop, function: on_improvement, failure })
    })
}

/// Calls a Python function with every better path. An exception in it ends the search.
struct Callback<'a> {
    stop: &'a Interrupt<'a>,
    function: Option<&'a Py<PyAny>>,
    failure: &'a Failure,
}

impl Observer for Callback<'_> {
    fn interrupted(&self) -> bool {
        (self.stop)() || self.failure.is_set()
    }

    fn improved(&self, seconds: f64, cost: f64, path: &[Point]) {
        let Some(function) = self.function.filter(|_| !self.failure.is_set()) else { return };
        let called = Python::attach(|py| {
            let waypoints = triples(py, path.iter().flat_map(|p| [p.x, p.y, p.z]).collect())?;
            function.call1(py, (seconds, cost, waypoints)).map(drop)
        });
        self.failure.keep(called);
    }
}
