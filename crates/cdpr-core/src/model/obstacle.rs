//! Obstacles that have been checked: convex parts under one name.

use super::body;
use super::robot::Robot;
use super::spec::{BodySpec, PLATFORM};
use crate::error::Error;
use crate::geometry::{Aabb, Polytope};
use crate::limits::LEAST_BODY;

/// An obstacle: convex parts under one name, m, world.
#[derive(Debug, Clone, PartialEq)]
pub struct Obstacle {
    /// Name used in messages.
    pub name: String,
    /// Convex parts of the obstacle, world, m.
    pub parts: Vec<Polytope>,
}

impl Obstacle {
    /// The axis-aligned box around the obstacle.
    pub fn aabb(&self) -> Aabb {
        let corners = self.parts.iter().flat_map(|part| [part.aabb().min, part.aabb().max]);
        Aabb::around(&corners.collect::<Vec<_>>())
    }
}

/// Obstacles from their specs: bodies of one name are parts of one obstacle.
pub(super) fn obstacles(specs: &[BodySpec], robot: &Robot) -> Result<Vec<Obstacle>, Error> {
    let (mut obstacles, mut places): (Vec<Obstacle>, Vec<String>) = (Vec::new(), Vec::new());
    for (k, spec) in specs.iter().enumerate() {
        let place = format!("obstacles[{k}]");
        body::optional_name(&format!("{place}.name"), spec.name.as_deref())?;
        let part = body::build(&place, spec)?;
        if !part.has_volume() {
            return Err(Error::invalid(
                place,
                "found a body without volume (flat within 1e-7 m), expected one with volume",
            ));
        }
        let name = spec.name.clone().unwrap_or_else(|| format!("obstacle {k}"));
        if name == PLATFORM || robot.cables().iter().any(|cable| cable.name == name) {
            return Err(Error::invalid(
                format!("{place}.name"),
                format!("found \"{name}\", which is already the name of something else"),
            ));
        }
        match obstacles.iter_mut().find(|o| o.name == name) {
            Some(body) => body.parts.push(part),
            None => {
                places.push(place);
                obstacles.push(Obstacle { name, parts: vec![part] });
            }
        }
    }
    for (place, obstacle) in places.iter().zip(&obstacles) {
        body::large_enough(place, "an obstacle", obstacle.parts.iter().flat_map(Polytope::vertices), LEAST_BODY)?;
    }
    Ok(obstacles)
}
