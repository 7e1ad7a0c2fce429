//! Bodies built from their specs, and checks of numbers shared by robots and scenes.

use super::spec::{BodySpec, MarginSpec, MeshSource, MotionSpec, PrismSpec, TurningAxis, TurningSpec, WrenchSpec};
use crate::error::{Error, unprintable};
use crate::geometry::{Point, Polytope, Rotation, Vector, from_roll_pitch_yaw};
use crate::limits::{MAX_COORDINATE, MOST_CORNERS, MOST_LOADS};
use crate::tolerances::{GAP_TOLERANCE, PARALLEL, UNIT_QUATERNION};

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

/// Checks a point, m.
pub fn point(place: &str, numbers: [f64; 3]) -> Result<Point, Error> {
    coordinates(place, &numbers)?;
    Ok(Point::from(numbers))
}

/// Checks a name: since it appears in messages and tables, it must be text on a single line and not empty.
pub fn name(place: &str, name: &str) -> Result<(), Error> {
    if name.trim().is_empty() || name.contains(unprintable) {
        return Err(Error::invalid(place, format!("found {name:?}, expected a name on one line")));
    }
    Ok(())
}

/// Checks an optional name.
pub fn optional_name(place: &str, given: Option<&str>) -> Result<(), Error> {
    given.map_or(Ok(()), |given| name(place, given))
}

/// Checks that the extent of these points is large enough for the tolerances of this program, or zero.
pub fn large_enough<'a>(
    place: &str,
    what: &str,
    points: impl IntoIterator<Item = &'a Point>,
    least: f64,
) -> Result<(), Error> {
    let (low, high) = points
        .into_iter()
        .fold((Vector::repeat(f64::INFINITY), Vector::repeat(f64::NEG_INFINITY)), |(low, high), p| {
            (low.inf(&p.coords), high.sup(&p.coords))
        });
    let extent = (high - low).max();
    if !(extent > 0.0 && extent < least) {
        return Ok(());
    }
    let problem = format!(
        "found {what} of {extent:e} m, expected at least {least:e} m: distances are accurate to {GAP_TOLERANCE:e} m, which is \
         too coarse for less; lengths are metres, so check the units, or scale all lengths of the scene up"
    );
    Err(Error::invalid(place, problem))
}

/// Checks that a list is not too long.
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

/// Checks a wrench, N and N·m.
pub fn wrench(place: &str, numbers: &[f64; 6]) -> Result<(), Error> {
    const PARTS: [&str; 6] = ["fx", "fy", "fz", "mx", "my", "mz"];
    match numbers.iter().position(|x| !x.is_finite()) {
        None => Ok(()),
        Some(k) => {
            let problem =
                format!("found {} = {}, expected six finite numbers, {}", PARTS[k], numbers[k], PARTS.join(" "));
            Err(Error::invalid(place, problem))
        }
    }
}

/// Checks the values of a `[turning]` table.
///
/// # Errors
/// An axis that is zero, a tilt that is not from 0 to 180 degrees, a weight that is not positive.
pub fn sound_turns(spec: &TurningSpec) -> Result<(), Error> {
    if let Some(TurningAxis::Fixed(axis)) = &spec.axis {
        coordinates("axis", axis)?;
        if !(Vector::from(*axis).norm() > PARALLEL) {
            return Err(Error::invalid(
                "axis",
                format!("found {axis:?}, expected \"free\" or an axis that is not zero"),
            ));
        }
    }
    if let Some(tilt) = spec.max_tilt.filter(|tilt| !(0.0..=180.0).contains(tilt)) {
        return Err(Error::invalid("max_tilt", format!("found {tilt}, expected an angle from 0 to 180 degrees")));
    }
    spec.weight.map_or(Ok(()), |weight| positive("weight", weight).map(drop))
}

/// Checks the values of a `[motion]` table.
///
/// # Errors
/// A limit that is not positive (`blend`, `clearance` and `wrench_margin`: negative) or not finite.
pub fn sound_motion(mut spec: MotionSpec) -> Result<(), Error> {
    for (key, limit) in spec.entries() {
        let sound = if ["blend", "clearance", "wrench_margin"].contains(&key) { not_negative } else { positive };
        limit.map(|limit| sound(key, limit)).transpose()?;
    }
    Ok(())
}

/// Checks the numbers of `[wrench]`.
pub fn sound_wrench(spec: &WrenchSpec) -> Result<(), Error> {
    for (key, radius) in [("force", spec.force), ("moment", spec.moment)] {
        not_negative(key, radius.unwrap_or(0.0))?;
    }
    for (key, length) in [("grid", spec.grid), ("characteristic_length", spec.characteristic_length)] {
        positive(key, length.unwrap_or(1.0))?;
    }
    wrench("load", &spec.load.unwrap_or_default())?;
    positive("payload", spec.payload.unwrap_or(1.0))?;
    if let Some(loads) = &spec.loads {
        if spec.load.is_some() {
            return Err(Error::invalid("loads", "found together with load, expected one of them"));
        }
        if !(1..=MOST_LOADS).contains(&loads.len()) {
            let problem = format!("found {}, expected 1 to {MOST_LOADS} loads", loads.len());
            return Err(Error::invalid("loads", problem));
        }
        loads.iter().enumerate().try_for_each(|(k, load)| wrench(&format!("loads[{k}]"), load))?;
    }
    let Some(corners) = &spec.vertices else { return Ok(()) };
    if spec.force.is_some() || spec.moment.is_some() {
        return Err(Error::invalid(
            "vertices",
            "found together with force or moment, expected either vertices or balls",
        ));
    }
    if spec.margin == Some(MarginSpec::Projected) {
        return Err(Error::invalid("margin", "found \"projected\" beside vertices, expected \"capacity\""));
    }
    if corners.is_empty() {
        return Err(Error::invalid("vertices", "found none, expected at least one wrench"));
    }
    corners.iter().enumerate().try_for_each(|(k, corner)| wrench(&format!("vertices[{k}]"), corner))
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

/// Builds a convex body at the place given by its spec. Flat bodies are allowed here.
pub fn build(place: &str, spec: &BodySpec) -> Result<Polytope, Error> {
    one_shape(place, spec)?;
    if let Some(MeshSource::File(path)) = &spec.mesh {
        let problem = format!(
            "found the path \"{path}\"; load the scene or robot from its file, so that the path can be followed"
        );
        return Err(Error::invalid(format!("{place}.mesh"), problem));
    }
    let shape = match (&spec.cuboid, &spec.vertices, &spec.prism) {
        (Some(sides), None, None) => cuboid(&format!("{place}.box"), *sides),
        (None, Some(vertices), None) => from_vertices(&format!("{place}.vertices"), vertices),
        (None, None, Some(prism)) => upright_prism(&format!("{place}.prism"), prism),
        _ => Err(Error::invalid(format!("{place}.mesh"), "found a mesh, expected its convex parts")),
    }?;
    let rotation = turn(place, &Turn { rpy: spec.rpy, rpy_degrees: spec.rpy_degrees, quaternion: spec.quaternion })?;
    let position = point(&format!("{place}.position"), spec.position.unwrap_or_default())?;
    let body = shape.transformed(&rotation, &position.coords);
    let numbers: Vec<f64> = body.vertices().iter().flat_map(|v| [v.x, v.y, v.z]).collect();
    coordinates(place, &numbers)?;
    Ok(body)
}

/// Checks that a body has exactly one shape, and keys for meshes only with a mesh.
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
        Some((key, _)) => {
            Err(Error::invalid(format!("{place}.{key}"), "found without a mesh; this key applies only to meshes"))
        }
        None => Ok(()),
    }
}

/// The ways to specify a rotation; at most one may be used.
#[derive(Debug, Clone, Copy, Default)]
pub struct Turn {
    /// Roll, pitch and yaw, rad.
    pub rpy: Option<[f64; 3]>,
    /// Roll, pitch and yaw, degrees.
    pub rpy_degrees: Option<[f64; 3]>,
    /// Unit quaternion, w x y z.
    pub quaternion: Option<[f64; 4]>,
}

/// A rotation specified in one of three ways, or the identity.
pub fn turn(place: &str, given: &Turn) -> Result<Rotation, Error> {
    let euler = |key: &str, [roll, pitch, yaw]: [f64; 3], radians: f64| {
        coordinates(&format!("{place}.{key}"), &[roll, pitch, yaw])?;
        Ok(from_roll_pitch_yaw([roll, pitch, yaw].map(|angle| angle * radians)))
    };
    match (given.rpy, given.rpy_degrees, given.quaternion) {
        (None, None, None) => Ok(Rotation::identity()),
        (Some(rpy), None, None) => euler("rpy", rpy, 1.0),
        (None, Some(rpy), None) => euler("rpy_degrees", rpy, 1f64.to_radians()),
        (None, None, Some(quaternion)) => unit_quaternion(&format!("{place}.quaternion"), quaternion),
        _ => {
            let keys = [given.rpy.map(|_| "rpy"), given.rpy_degrees.map(|_| "rpy_degrees")];
            let keys: Vec<&str> = keys.into_iter().chain([given.quaternion.map(|_| "quaternion")]).flatten().collect();
            Err(Error::invalid(place, format!("found both {} and {}, expected one of them", keys[0], keys[1])))
        }
    }
}

/// A hint if an angle in radians exceeds a full turn: it is probably in degrees.
pub fn degrees_hint(place: &str, rpy: Option<[f64; 3]>) -> Option<String> {
    let large = rpy?.into_iter().find(|angle| angle.abs() > std::f64::consts::TAU)?;
    Some(format!("{place}.rpy: found {large} rad, more than a full turn; did you mean rpy_degrees?"))
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
    // A corner strictly inside the polygon of the base does not lie strictly inside the prism, so it is checked here.
    let lifted: Vec<Point> = polygon.vertices().iter().flat_map(|v| [*v, v + Vector::z() * prism.height]).collect();
    let body = hull(place, Polytope::hull_of(&lifted))?;
    let middle = |v: &Point| v + Vector::z() * (0.5 * prism.height);
    match floor.iter().position(|v| body.depth_of(&middle(v)) > crate::tolerances::ON_SURFACE.min(0.4 * prism.height)) {
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
