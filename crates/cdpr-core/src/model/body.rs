//! Bodies from their specs, and the checks of numbers that robots and scenes share.

use super::spec::{BodySpec, MarginSpec, MeshSource, PrismSpec, WrenchSpec};
use crate::error::Error;
use crate::geometry::{Point, Polytope, Rotation, Vector};
use crate::numerics::{MAX_COORDINATE, MOST_CORNERS, UNIT_QUATERNION};

/// Checks that every number is finite and within [`MAX_COORDINATE`].
pub fn coordinates(place: &str, numbers: &[f64]) -> Result<(), Error> {
    match numbers.iter().find(|x| !(x.abs() <= MAX_COORDINATE)) {
        None => Ok(()),
        Some(x) if x.is_finite() => {
            Err(Error::invalid(place, format!("found {x} m, expected coordinates up to {MAX_COORDINATE:e} m")))
        }
        Some(x) => Err(Error::invalid(place, format!("found {x}, expected finite numbers"))),
    }
}

/// Checks a place in space, m.
pub fn point(place: &str, numbers: [f64; 3]) -> Result<Point, Error> {
    coordinates(place, &numbers)?;
    Ok(Point::from(numbers))
}

/// Checks that a list is not longer than can be dealt with.
pub fn at_most(place: &str, count: usize, most: usize) -> Result<(), Error> {
    if count <= most {
        return Ok(());
    }
    Err(Error::invalid(place, format!("found {count}, expected at most {most}")))
}

/// Checks a number that must be finite and not negative.
pub fn not_negative(place: &str, number: f64) -> Result<f64, Error> {
    if number >= 0.0 && number.is_finite() {
        return Ok(number);
    }
    Err(Error::invalid(place, format!("found {number}, expected a finite number of at least 0")))
}

/// Checks a number that must be finite and positive.
pub fn positive(place: &str, number: f64) -> Result<f64, Error> {
    if number > 0.0 && number.is_finite() {
        return Ok(number);
    }
    Err(Error::invalid(place, format!("found {number}, expected a finite positive number")))
}

/// Checks that every number is finite.
pub fn finite(place: &str, numbers: &[f64]) -> Result<(), Error> {
    match numbers.iter().position(|x| !x.is_finite()) {
        None => Ok(()),
        Some(k) => {
            Err(Error::invalid(format!("{place}[{k}]"), format!("found {}, expected a finite number", numbers[k])))
        }
    }
}

/// Checks the numbers of a demand of wrench feasibility.
pub fn sound_wrench(spec: &WrenchSpec) -> Result<(), Error> {
    for (key, radius) in [("force", spec.force), ("moment", spec.moment)] {
        not_negative(key, radius.unwrap_or(0.0))?;
    }
    for (key, length) in [("grid", spec.grid), ("characteristic_length", spec.characteristic_length)] {
        positive(key, length.unwrap_or(1.0))?;
    }
    finite("load", &spec.load.unwrap_or_default())?;
    let Some(corners) = &spec.vertices else { return Ok(()) };
    if spec.force.is_some() || spec.moment.is_some() {
        return Err(Error::invalid("vertices", "found beside force or moment, expected either vertices or balls"));
    }
    if spec.margin == Some(MarginSpec::Projected) {
        return Err(Error::invalid("margin", "found \"projected\" beside vertices, expected \"capacity\""));
    }
    if corners.is_empty() {
        return Err(Error::invalid("vertices", "found none, expected at least one wrench"));
    }
    corners.iter().enumerate().try_for_each(|(k, corner)| finite(&format!("vertices[{k}]"), corner))
}

/// Checks an interval `0 <= least <= largest`.
pub fn interval(place: &str, [least, largest]: [f64; 2]) -> Result<[f64; 2], Error> {
    if least >= 0.0 && least <= largest && largest.is_finite() {
        return Ok([least, largest]);
    }
    Err(Error::invalid(place, format!("found [{least}, {largest}], expected [min, max] with 0 <= min <= max")))
}

/// Checks a unit quaternion w x y z.
pub fn unit_quaternion(place: &str, [w, x, y, z]: [f64; 4]) -> Result<Rotation, Error> {
    let quaternion = nalgebra::Quaternion::new(w, x, y, z);
    if (quaternion.norm() - 1.0).abs() <= UNIT_QUATERNION {
        return Ok(Rotation::from_quaternion(quaternion));
    }
    Err(Error::invalid(
        place,
        format!(
            "found a quaternion of length {}, expected length 1 within {UNIT_QUATERNION:e} (w x y z)",
            quaternion.norm()
        ),
    ))
}

/// Builds a convex body where its spec puts it. Flat bodies are allowed here.
pub fn build(place: &str, spec: &BodySpec) -> Result<Polytope, Error> {
    one_shape(place, spec)?;
    if let Some(MeshSource::File(path)) = &spec.mesh {
        let problem = format!("found the path \"{path}\"; load the scene or robot from its file to have it read");
        return Err(Error::invalid(format!("{place}.mesh"), problem));
    }
    let shape = match (&spec.cuboid, &spec.vertices, &spec.prism) {
        (Some(sides), None, None) => cuboid(&format!("{place}.box"), *sides),
        (None, Some(vertices), None) => from_vertices(&format!("{place}.vertices"), vertices),
        (None, None, Some(prism)) => upright_prism(&format!("{place}.prism"), prism),
        _ => Err(Error::invalid(format!("{place}.mesh"), "found a mesh in place of the convex parts it stands for")),
    }?;
    let rotation = turn(place, spec.rpy, spec.quaternion)?;
    let position = point(&format!("{place}.position"), spec.position.unwrap_or_default())?;
    let body = shape.transformed(&rotation, &position.coords);
    let numbers: Vec<f64> = body.vertices().iter().flat_map(|v| [v.x, v.y, v.z]).collect();
    coordinates(place, &numbers)?;
    Ok(body)
}

/// Checks that a body has exactly one shape, and what belongs to a mesh only with one.
pub fn one_shape(place: &str, spec: &BodySpec) -> Result<(), Error> {
    let shapes = [spec.cuboid.is_some(), spec.vertices.is_some(), spec.prism.is_some(), spec.mesh.is_some()];
    match shapes.iter().filter(|given| **given).count() {
        0 => return Err(Error::invalid(place, "found no shape, expected one of box, vertices, prism, mesh")),
        1 => {}
        _ => {
            let problem = "found several shapes, expected exactly one of box, vertices, prism, mesh";
            return Err(Error::invalid(place, problem));
        }
    }
    let of_mesh =
        [("units", spec.units.is_some()), ("scale", spec.scale.is_some()), ("tolerance", spec.tolerance.is_some())];
    match of_mesh.iter().find(|(_, given)| *given && spec.mesh.is_none()) {
        Some((key, _)) => Err(Error::invalid(format!("{place}.{key}"), "found it without a mesh, which it is for")),
        None => Ok(()),
    }
}

/// A turn given in one of two ways, or none.
pub fn turn(place: &str, rpy: Option<[f64; 3]>, quaternion: Option<[f64; 4]>) -> Result<Rotation, Error> {
    match (rpy, quaternion) {
        (None, None) => Ok(Rotation::identity()),
        (Some(rpy), None) => {
            coordinates(&format!("{place}.rpy"), &rpy)?;
            let [roll, pitch, yaw] = rpy;
            Ok(Rotation::from_euler_angles(roll, pitch, yaw))
        }
        (None, Some(quaternion)) => unit_quaternion(&format!("{place}.quaternion"), quaternion),
        (Some(_), Some(_)) => Err(Error::invalid(place, "found both rpy and quaternion, expected one of them")),
    }
}

fn cuboid(place: &str, sides: [f64; 3]) -> Result<Polytope, Error> {
    coordinates(place, &sides)?;
    if let Some(side) = sides.iter().find(|side| **side < 0.0) {
        return Err(Error::invalid(
            place,
            format!("found a side of {side} m, expected full side lengths of at least 0"),
        ));
    }
    hull(place, Polytope::cuboid(sides))
}

fn from_vertices(place: &str, vertices: &[[f64; 3]]) -> Result<Polytope, Error> {
    at_most(place, vertices.len(), MOST_CORNERS)?;
    let vertices: Vec<Point> =
        vertices.iter().enumerate().map(|(k, v)| point(&format!("{place}[{k}]"), *v)).collect::<Result<_, _>>()?;
    hull(place, Polytope::from_vertices(&vertices))
}

fn upright_prism(place: &str, prism: &PrismSpec) -> Result<Polytope, Error> {
    coordinates(&format!("{place}.height"), &[prism.height])?;
    if !(prism.height > 0.0) {
        let problem = format!("found {} m, expected a positive height", prism.height);
        return Err(Error::invalid(format!("{place}.height"), problem));
    }
    let base = format!("{place}.base");
    at_most(&base, prism.base.len(), MOST_CORNERS)?;
    let floor: Vec<Point> = prism
        .base
        .iter()
        .enumerate()
        .map(|(k, [x, y])| point(&format!("{base}[{k}]"), [*x, *y, 0.0]))
        .collect::<Result<_, _>>()?;
    let polygon = hull(&base, Polytope::hull_of(&floor))?;
    if polygon.dimension() != 2 {
        return Err(Error::invalid(base, "found no area, expected at least three corners that are not on one line"));
    }
    // A corner of the base strictly inside the polygon is strictly inside the side of no prism: look for it here.
    let lifted: Vec<Point> = polygon.vertices().iter().flat_map(|v| [*v, v + Vector::z() * prism.height]).collect();
    let body = hull(place, Polytope::hull_of(&lifted))?;
    let middle = |v: &Point| v + Vector::z() * (0.5 * prism.height);
    match floor.iter().position(|v| body.depth_of(&middle(v)) > crate::numerics::ON_SURFACE.min(0.4 * prism.height)) {
        Some(k) => Err(Error::invalid(
            format!("{base}[{k}]"),
            "lies inside the hull of the others, expected the corners of a convex polygon",
        )),
        None => Ok(body),
    }
}

fn hull(place: &str, result: Result<Polytope, crate::geometry::PolytopeError>) -> Result<Polytope, Error> {
    result.map_err(|problem| Error::invalid(place, problem.to_string()))
}
