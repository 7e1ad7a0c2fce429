//! Payloads: an obstacle while they stand, a part of the platform and of its mass while they are carried.
//!
//! A scene with payloads is made of a scene without them, to which each is added where it is: its bodies to the obstacles, moved to
//! where it stands, or to the platform. So everything that knows obstacles and platforms knows payloads. A carried payload adds its
//! mass to that of the platform, at its own centre of mass, and its inertia as that of its body at uniform density about there. If
//! the mass of the robot is not known, neither is the sum.

use super::obstacle::{name_of, solid};
use super::query::{Names, new_name, unknown};
use super::robot::Robot;
use super::spec::{
    BodySpec, InertiaSpec, OrientationSource, PLATFORM, PayloadSpec, PositionSource, RobotSource, RobotSpec, SceneSpec,
};
use super::{body, inertia};
use crate::error::Error;
use crate::geometry::{Point, Polytope, Pose, Rotation, Vector, gjk::overlap, wxyz};
use crate::limits::{LEAST_BODY, MOST_BODIES};
use crate::tolerances::TOUCH_DEPTH;

/// Something that the platform can carry.
#[derive(Debug, Clone, PartialEq)]
pub struct Payload {
    /// Name of the payload, as an obstacle and as a part of the platform.
    pub name: String,
    /// Convex parts as it is carried, platform frame, m.
    pub parts: Vec<Polytope>,
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass as it is carried, platform frame, m.
    pub center_of_mass: Point,
    /// It stands where it would be carried if the platform were here; `None` while it is carried.
    pub stands: Option<Pose>,
}

impl Payload {
    /// Whether two payloads cannot be carried together, because their bodies overlap.
    pub(super) fn overlaps(&self, other: &Payload) -> bool {
        self.parts.iter().any(|part| other.parts.iter().any(|another| overlap(part, another, TOUCH_DEPTH)))
    }
}

/// The payload of this name; an error is at `place`.
pub(crate) fn index(place: &str, name: &str, payloads: &[Payload]) -> Result<usize, Error> {
    payloads.iter().position(|payload| payload.name == name).ok_or_else(|| {
        let names: Vec<&str> = payloads.iter().map(|payload| payload.name.as_str()).collect();
        unknown(place, name, "one of the scene's payloads", &names)
    })
}

/// The scene without payloads and task in which those of the list that stand are obstacles.
pub(super) fn with_bodies(written: &SceneSpec, list: &[Payload], robot: RobotSource) -> SceneSpec {
    let mut spec = SceneSpec { payloads: Vec::new(), task: Vec::new(), robot, ..written.clone() };
    for (payload, own) in list.iter().zip(&written.payloads) {
        let stands = payload.stands.iter().flat_map(|pose| own.body.iter().map(move |body| moved(body, pose)));
        spec.obstacles.extend(stands.map(|body| BodySpec { name: Some(payload.name.clone()), ..body }));
    }
    let stands = |name: &String| list.iter().any(|payload| payload.name == *name && payload.stands.is_some());
    let absent = |name: &String| written.payloads.iter().any(|payload| payload.name == *name) && !stands(name);
    let kept = |pair: &[String; 2]| !pair.iter().any(absent);
    spec.ignore.retain(kept);
    spec.touch.retain(kept);
    if let Some(clearances) = &mut spec.clearances {
        clearances.pairs.retain(|rule| kept(&rule.between));
    }
    spec
}

/// A body of the platform's frame in the world.
fn moved(body: &BodySpec, pose: &Pose) -> BodySpec {
    let position = Point::from(body.position.unwrap_or_default());
    if pose.orientation == Rotation::identity() {
        return BodySpec { position: Some((position + pose.position.coords).into()), ..body.clone() };
    }
    let turn = body::Turn { rpy: body.rpy, rpy_degrees: body.rpy_degrees, quaternion: body.quaternion };
    let own = body::turn("", &turn).expect("it was checked with the payload");
    BodySpec {
        position: Some(pose.place(&position).into()),
        rpy: None,
        rpy_degrees: None,
        quaternion: Some(wxyz(&(pose.orientation * own))),
        ..body.clone()
    }
}

/// The robot that carries some of the payloads.
pub(super) fn loaded(robot: &Robot, specs: &[PayloadSpec], list: &[Payload], carried: &[usize]) -> RobotSpec {
    let mut spec = robot.spec().clone();
    for &k in carried {
        let named = |body: &BodySpec| BodySpec { name: Some(list[k].name.clone()), ..body.clone() };
        spec.platform.extend(specs[k].body.iter().map(named));
    }
    let (Some(mass), Some(own), false) = (robot.mass(), robot.inertia(), carried.is_empty()) else { return spec };
    let carried = || carried.iter().map(|k| &list[*k]);
    let total = carried().fold(mass, |sum, payload| sum + payload.mass);
    let moment = carried()
        .fold(robot.center_of_mass().coords * mass, |sum, payload| sum + payload.center_of_mass.coords * payload.mass);
    let center = moment / total;
    let about = |tensor, mass, point: Point| tensor + inertia::of_point(mass, &(point.coords - center));
    let tensor = carried().fold(about(own, mass, robot.center_of_mass()), |sum, payload| {
        sum + about(inertia::uniform(payload.mass, &payload.parts), payload.mass, payload.center_of_mass)
    });
    spec.mass = Some(total);
    spec.center_of_mass = Some(center.into());
    spec.inertia = Some(InertiaSpec::Tensor([0, 1, 2].map(|row| [0, 1, 2].map(|column| tensor[(row, column)]))));
    spec
}

/// Checks a payload by itself, beside those before it.
pub(super) fn checked(
    place: &str,
    spec: &PayloadSpec,
    (written, robot, names): (&SceneSpec, &Robot, &Names),
    before: &[Payload],
) -> Result<Payload, Error> {
    new_name(place, &spec.name, before.iter().map(|known| &known.name))?;
    let mut obstacles = written.obstacles.iter().enumerate().map(|(k, body)| name_of(k, body));
    let taken = robot.cables().iter().any(|cable| cable.name == spec.name);
    if spec.name == PLATFORM || taken || obstacles.any(|name| name == spec.name) {
        let problem = format!("found \"{}\", which is already the name of something else", spec.name);
        return Err(Error::invalid(format!("{place}.name"), problem));
    }
    let parts = parts(&format!("{place}.body"), &spec.body)?;
    let mass = body::positive(&format!("{place}.mass"), spec.mass)?;
    let center = spec.center_of_mass.map(|given| body::point(&format!("{place}.center_of_mass"), given)).transpose()?;
    let center_of_mass = center.unwrap_or_else(|| center_of_volume(&spec.body, &parts));
    let payload = Payload {
        name: spec.name.clone(),
        parts,
        mass,
        center_of_mass,
        stands: stands(place, spec, (written, names))?,
    };
    let alone = loaded(robot, std::slice::from_ref(spec), std::slice::from_ref(&payload), &[0]);
    Robot::try_from(alone).map_err(|e| {
        Error::invalid(format!("{place}.body"), format!("found a payload that the robot cannot carry: {e}"))
    })?;
    let carried = |other: &&Payload| payload.stands.is_none() && other.stands.is_none();
    if let Some(other) = before.iter().filter(carried).find(|other| payload.overlaps(other)) {
        return Err(Error::invalid(place, overlap_words(&payload, other)));
    }
    Ok(payload)
}

/// The problem that a payload cannot be carried together with another one.
pub(super) fn overlap_words(payload: &Payload, carried: &Payload) -> String {
    format!("found \"{}\", whose body overlaps that of \"{}\", which is carried too", payload.name, carried.name)
}

fn parts(place: &str, specs: &[BodySpec]) -> Result<Vec<Polytope>, Error> {
    if specs.is_empty() {
        return Err(Error::invalid(place, "found no bodies, expected at least one"));
    }
    body::at_most(place, specs.len(), MOST_BODIES)?;
    let several = specs.len() > 1;
    let mut parts = Vec::new();
    for (k, spec) in specs.iter().enumerate() {
        let place = if several { format!("{place}[{k}]") } else { place.to_string() };
        if spec.name.is_some() {
            return Err(Error::invalid(format!("{place}.name"), "found a name, expected none: the payload has one"));
        }
        parts.push(solid(&place, spec)?);
    }
    body::large_enough(place, "a payload", parts.iter().flat_map(Polytope::vertices), LEAST_BODY)?;
    Ok(parts)
}

/// The centre of the volume of bodies; for a box, exactly where it is placed.
fn center_of_volume(specs: &[BodySpec], parts: &[Polytope]) -> Point {
    let centers = specs.iter().zip(parts).map(|(spec, part)| match spec.cuboid {
        Some(_) => spec.position.unwrap_or_default().into(),
        None => inertia::center_of_volume(part),
    });
    let centers: Vec<Point> = centers.collect();
    if let [only] = centers[..] {
        return only;
    }
    let total: f64 = parts.iter().map(Polytope::volume).sum();
    let moment =
        centers.iter().zip(parts).fold(Vector::zeros(), |sum, (center, part)| sum + center.coords * part.volume());
    (moment / total).into()
}

/// Where a payload stands, if it is not carried.
fn stands(place: &str, spec: &PayloadSpec, scene: (&SceneSpec, &Names)) -> Result<Option<Pose>, Error> {
    match (&spec.at, spec.carried) {
        (Some(at), false) => pose(&format!("{place}.at"), at, spec.orientation.as_ref(), scene).map(Some),
        (None, true) if spec.orientation.is_none() => Ok(None),
        (None, true) => {
            Err(Error::invalid(format!("{place}.orientation"), "found one, but it is carried; expected none"))
        }
        (Some(_), true) => Err(Error::invalid(format!("{place}.at"), "found one, but it is carried; expected none")),
        (None, false) => {
            let problem = "found none, expected the station where it stands, or carried = true";
            Err(Error::invalid(format!("{place}.at"), problem))
        }
    }
}

/// The pose of the platform at a station or position: at an orientation given beside it, that of the station, or that which the scene
/// selects, whatever its start and goal.
pub(super) fn pose(
    place: &str,
    at: &PositionSource,
    own: Option<&OrientationSource>,
    (written, names): (&SceneSpec, &Names),
) -> Result<Pose, Error> {
    let (position, of_station) = names.position(place, at)?;
    if let Some(own) = own {
        let key = place.strip_suffix("at").map_or(place.to_string(), |start| format!("{start}orientation"));
        return Ok(Pose::new(position, names.orientation(&key, own)?));
    }
    if let Some(turn) = of_station {
        return Ok(Pose::new(position, turn));
    }
    let selected = written.query.as_ref().and_then(|query| query.orientation.as_ref());
    let turn = match (selected, &names.orientations[..]) {
        (Some(selected), _) => names.orientation("query.orientation", selected)?,
        (None, []) => Rotation::identity(),
        (None, [(_, only)]) => *only,
        (None, _) => {
            let problem = "found a place without an orientation in a scene that selects none of its orientations; expected a \
                           station with an orientation, or query.orientation";
            return Err(Error::invalid(place, problem));
        }
    };
    Ok(Pose::new(position, turn))
}
