//! Obstacles that have been checked: convex parts under one name.

use std::collections::HashSet;

use super::body;
use super::pairs::PairRules;
use super::robot::Robot;
use super::spec::{BodySpec, PLATFORM};
use crate::error::Error;
use crate::geometry::Polytope;
use crate::geometry::seam::{Seam, seams};
use crate::numerics::{LEAST_BODY, ON_SURFACE};

/// An obstacle: convex parts under one name, m, world.
#[derive(Debug, Clone, PartialEq)]
pub struct Obstacle {
    /// Name used in messages.
    pub name: String,
    /// Convex parts.
    pub parts: Vec<Polytope>,
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

/// Bodies that close the seams between parts, each between the indices of its obstacles.
///
/// A member that ignores an obstacle heeds only the seams between others. So where parts meet an obstacle that some member
/// ignores, there are also the seams that the others have without it.
pub(super) fn obstacle_seams(obstacles: &[Obstacle], pairs: &PairRules) -> Vec<Seam> {
    let parts: Vec<(usize, &Polytope)> =
        obstacles.iter().enumerate().flat_map(|(j, o)| o.parts.iter().map(move |part| (j, part))).collect();
    let mut found = seams_between(&parts);
    let identity = |Seam { body, between, .. }: &Seam| {
        let corners = body.vertices().iter().flat_map(|v| [v.x, v.y, v.z].map(f64::to_bits));
        (between.clone(), corners.collect::<Vec<u64>>())
    };
    let mut known: HashSet<_> = found.iter().map(identity).collect();
    for ignored in pairs.ignored_obstacles() {
        let meets = |part: &Polytope| {
            let others = ignored.iter().flat_map(|&j| &obstacles[j].parts);
            others.into_iter().any(|other| !part.aabb().apart_by(other.aabb(), ON_SURFACE))
        };
        let left = parts.iter().copied().filter(|(j, part)| !ignored.contains(j) && meets(part));
        let more = seams_between(&left.collect::<Vec<_>>());
        found.extend(more.into_iter().filter(|seam| known.insert(identity(seam))));
    }
    found
}

fn seams_between(parts: &[(usize, &Polytope)]) -> Vec<Seam> {
    let mut found = seams(&parts.iter().map(|(_, part)| *part).collect::<Vec<_>>());
    for Seam { between, .. } in &mut found {
        between.iter_mut().for_each(|k| *k = parts[*k].0);
        between.dedup();
    }
    found
}
