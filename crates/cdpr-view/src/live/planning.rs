//! The planning data in the JSON of a planned path, in the form of a request to plan it again.

use serde_json::{Map, Value, json};

/// The planning data in the JSON of a planned path, for the card on top of the page and for planning again.
#[derive(Debug, Clone, PartialEq)]
pub struct Planning {
    /// Seed, time, bound and length of the path, and why an end is not valid.
    pub(crate) result: Value,
    /// The options in the form of a request to the planner, without a time limit.
    pub(crate) options: Value,
}

/// Keys of `options` in a path file that are not settings of the planner.
const NO_SETTINGS: [&str; 5] = ["step", "post", "repeats", "budget_ms", "proof"];

impl Planning {
    /// The planning data of a path; `None` for a path that no planner wrote.
    pub fn of_json(json: &str) -> Option<Self> {
        Self::of(&serde_json::from_str(json).ok()?)
    }

    pub(crate) fn of(path: &Value) -> Option<Self> {
        path["status"].as_str()?;
        Some(Planning { result: result(path), options: options(path) })
    }
}

fn result(path: &Value) -> Value {
    let seconds = |key: &str| path["stats"][key].as_f64().unwrap_or(0.0);
    let mut result =
        picked(path, &["reason", "reasons", "nearest_valid", "opening_below", "seed", "lower_bound", "cost", "route"]);
    result.insert("seconds".to_string(), json!(seconds("planning_seconds") + seconds("post_seconds")));
    Value::Object(result)
}

fn options(path: &Value) -> Value {
    let mut options = picked(path, &["planner", "seed", "engine", "interference"]);
    options.append(&mut picked(&path["options"], &["step", "post", "repeats", "proof"]));
    let settings = path["options"].as_object().cloned().unwrap_or_default();
    let settings: Map<_, _> = settings.into_iter().filter(|(key, _)| !NO_SETTINGS.contains(&key.as_str())).collect();
    options.insert("settings".to_string(), Value::Object(settings));
    Value::Object(options)
}

/// The given keys, as far as the value has them.
fn picked(value: &Value, keys: &[&str]) -> Map<String, Value> {
    keys.iter().filter_map(|key| Some((key.to_string(), value.get(key)?.clone()))).collect()
}
