//! The largest tension that counts, where the limits of cables are hardly meant.

use super::robot::Robot;
use super::spec::{GRAVITY, SceneSpec};
use crate::geometry::Vector;
use crate::tolerances::PLENTY_OF_TENSION;

/// The largest tension that counts, N: [`PLENTY_OF_TENSION`] times the forces on the platform. `None` if its mass is not known.
pub(super) fn most_tension(spec: &SceneSpec, robot: &Robot) -> Option<f64> {
    let size = |w: &[f64; 6], length: f64| {
        Vector::new(w[0], w[1], w[2]).norm() + Vector::new(w[3], w[4], w[5]).norm() / length
    };
    let gravity = Vector::from(spec.gravity.unwrap_or(GRAVITY)).norm().max(Vector::from(GRAVITY).norm());
    let wrench = spec.wrench.clone().unwrap_or_default();
    let length = wrench.characteristic_length.unwrap_or(1.0).min(1.0);
    let corners = wrench.vertices.iter().flatten().map(|corner| size(corner, length)).fold(0.0, f64::max);
    let required = wrench.force.unwrap_or(0.0) + wrench.moment.unwrap_or(0.0) / length + corners;
    let load =
        wrench.load.iter().chain(wrench.loads.iter().flatten()).map(|load| size(load, length)).fold(0.0, f64::max);
    let margin = spec.motion.and_then(|motion| motion.wrench_margin).unwrap_or(0.0);
    let least = robot.cables().iter().filter_map(|cable| cable.tension).map(|[least, _]| least).fold(0.0, f64::max);
    let mass = robot.mass()? + wrench.payload.unwrap_or(0.0);
    Some(PLENTY_OF_TENSION * (mass * gravity + load + required + margin + least))
}

/// The note about cables whose tension limits are lowered.
pub(super) fn unlimited_note(cables: &[String], most: f64) -> Option<String> {
    let [first, others @ ..] = cables else { return None };
    let more = if others.is_empty() { String::new() } else { format!(" and of {} more cables", others.len()) };
    Some(format!(
        "the tension limit of {first}{more} counts as {most:.0} N: {PLENTY_OF_TENSION:.0} times the weight, load, required wrenches \
         and least tension; give the real limit, since margins and the middle of the limits depend on it"
    ))
}
