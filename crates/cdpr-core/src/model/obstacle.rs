//! Obstacles that have been checked: convex parts under one name.

use std::borrow::Cow;

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
        let part = solid(&place, spec)?;
        let name = name_of(k, spec).into_owned();
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
        large_enough(place, obstacle)?;
    }
    Ok(obstacles)
}

/// The obstacle of a name, from specs that contain it.
pub(super) fn obstacle(specs: &[BodySpec], name: &str) -> Result<Obstacle, Error> {
    let own: Vec<(usize, &BodySpec)> = specs.iter().enumerate().filter(|(k, spec)| name_of(*k, spec) == name).collect();
    let place = |k: usize| format!("obstacles[{k}]");
    let parts = own.iter().map(|(k, spec)| solid(&place(*k), spec)).collect::<Result<_, _>>()?;
    let obstacle = Obstacle { name: name.to_string(), parts };
    large_enough(&place(own.first().map_or(0, |(k, _)| *k)), &obstacle)?;
    Ok(obstacle)
}

/// The name of the obstacle that the k-th body belongs to.
pub fn name_of(k: usize, spec: &BodySpec) -> Cow<'_, str> {
    spec.name.as_deref().map_or_else(|| format!("obstacle {k}").into(), Cow::from)
}

/// A convex part that has a volume.
pub(super) fn solid(place: &str, spec: &BodySpec) -> Result<Polytope, Error> {
    let part = body::build(place, spec)?;
    if !part.has_volume() {
        return Err(Error::invalid(
            place,
            "found a body without volume (flat within 1e-7 m), expected one with volume",
        ));
    }
    Ok(part)
}

fn large_enough(place: &str, obstacle: &Obstacle) -> Result<(), Error> {
    body::large_enough(place, "an obstacle", obstacle.parts.iter().flat_map(Polytope::vertices), LEAST_BODY)
}
