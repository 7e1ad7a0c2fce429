//! Which of a scene's load cases is meant.

use std::fmt;

use serde::{Serialize, Serializer};

use super::spec::WrenchSpec;

/// One of several load cases of a scene: one of its loads, with or without its payload.
///
/// # Example
/// ```
/// use cdpr_core::{Scene, SceneSpec, WrenchSpec, testing, wrench::Loads};
/// let wrench = WrenchSpec { payload: Some(5.0), ..WrenchSpec::default() };
/// let scene = Scene::new(SceneSpec { wrench: Some(wrench), ..testing::empty().spec().clone() })?;
/// let cases = Loads::cases(&scene).into_iter().filter_map(|loads| loads.case);
/// assert_eq!(cases.map(|case| case.to_string()).collect::<Vec<_>>(), ["without the payload", "with the payload"]);
/// # Ok::<(), cdpr_core::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LoadCase {
    /// Which of the loads, counted from 1, and how many there are, if there are several.
    pub load: Option<[usize; 2]>,
    /// Whether the payload is carried, if there is one.
    pub payload: Option<bool>,
}

impl fmt::Display for LoadCase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let load = self.load.map(|[k, of]| format!("load {k} of {of}"));
        let payload = self.payload.map(|carried| if carried { "with the payload" } else { "without the payload" });
        let parts: Vec<&str> = load.as_deref().into_iter().chain(payload).collect();
        f.write_str(&parts.join(" "))
    }
}

impl Serialize for LoadCase {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// The note about the loads for which wrenches are certified.
pub fn note(wrench: &WrenchSpec) -> Option<String> {
    let several = wrench.payload.is_some() || wrench.loads.as_ref().is_some_and(|loads| loads.len() > 1);
    if several {
        let first = match (&wrench.loads, wrench.payload) {
            (None, _) => "without the payload",
            (Some(_), None) => "for the first of `loads`",
            (Some(_), Some(_)) => "for the first of `loads` without the payload",
        };
        return Some(format!("wrenches are certified for every load case; rows of tensions are those {first}"));
    }
    let loaded = wrench.load.is_some_and(|load| load != [0.0; 6]);
    loaded.then(|| {
        "wrenches are certified with `load` only: if the platform also moves without it, list both as `loads`"
            .to_string()
    })
}
