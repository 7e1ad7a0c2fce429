//! Robots of `cdpr`, the simulation of cable robots in Gazebo by Olivier Kermorgant
//! (<https://github.com/oKermorgant/cdpr>): one YAML file with `platform`, `points`, `joints` and `cable`, at the top or
//! under `model`.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::path::Path;

use serde_json::{Map, Value};

use super::import_source::{Source, inertia_of, platform_of};
use super::text;
use cdpr_core::error::{Error, name_of_file};
use cdpr_core::limits::MOST_XML_BYTES;
use cdpr_core::model::{BodySpec, CableSpec, RobotSpec};

/// The keys of a robot, which stand either at the top or under `model`.
const KEYS: [&str; 5] = ["platform", "points", "joints", "cable", "frame"];

pub(super) fn import(path: &Path) -> Result<Source, Error> {
    let text = text::read_at_most(path, MOST_XML_BYTES)?;
    let (robot, notes) = robot(&text).map_err(|e| e.in_file(path))?;
    let robot = RobotSpec { name: name_of_file(path), ..robot };
    let file = path.file_name().unwrap_or_default().to_string_lossy();
    Ok(Source { robot, origin: format!("Imported from {file} (cdpr for Gazebo)"), notes })
}

/// The robot in the text of a file, and notes.
fn robot(text: &str) -> Result<(RobotSpec, Vec<String>), Error> {
    let document: Value = serde_saphyr::from_str(text).map_err(|e| {
        let problem = e.to_string();
        let first = problem.lines().next().unwrap_or_default().trim_start_matches("error: ");
        Error::invalid("", format!("is not valid YAML: {first}"))
    })?;
    let file = Table::of(String::new(), &document)?;
    let nested = file.table("model")?;
    if let (Some(_), Some(key)) = (&nested, KEYS.iter().find(|key| file.entries.contains_key(**key))) {
        return Err(Error::invalid(*key, "found beside model, expected under model"));
    }
    let model = nested.as_ref().unwrap_or(&file);
    let mut unread = BTreeSet::new();
    let mut notes = Vec::new();

    let cables = cables(model, &mut unread, &mut notes)?;
    let platform = model.table("platform")?;
    let platform =
        platform.ok_or_else(|| model.missing("platform", "a table with the mass and shape of the platform"))?;
    let body = cuboid(&platform)?;
    if body.is_none() {
        let shape = match platform.text("type")? {
            Some(other) if other != "box" => format!("platform.type is {other}, not box"),
            _ => "the platform has no box with a size".to_string(),
        };
        notes.push(format!("{shape}: the hull of the attachments is used"));
    }
    if let Some(position) = platform.table("position")? {
        let [xyz, rpy] = [position.required::<3>("xyz")?, position.required::<3>("rpy")?];
        notes.push(format!(
            "initial position {xyz:?}, rpy {rpy:?}: start and orientation belong in the query of a scene"
        ));
        unread.extend(position.unread());
    }
    let inertia = inertia(&platform, &mut unread)?;
    let inertia = inertia.and_then(|given| inertia_of(given).map_err(|note| notes.push(note)).ok());
    if model.get("frame").is_some() {
        notes.push("frame: its bars are not imported as obstacles".to_string());
    }
    let attachments: Vec<_> = cables.iter().map(|cable| cable.attachment).collect();
    let robot = RobotSpec {
        version: Some(cdpr_core::model::spec::FORMAT_VERSION),
        name: None,
        mass: platform.number("mass")?,
        center_of_mass: None,
        inertia,
        platform: body.map_or_else(|| platform_of(&attachments), |body| vec![body]),
        cables,
        cable: None,
        tension_distribution: None,
    };
    unread.extend([&platform, model, &file].into_iter().flat_map(Table::unread));
    notes.extend((!unread.is_empty()).then(|| unread.into_iter().collect::<Vec<_>>().join(", ")));
    Ok((robot, notes))
}

fn cables(model: &Table, unread: &mut BTreeSet<String>, notes: &mut Vec<String>) -> Result<Vec<CableSpec>, Error> {
    let tension = match model.table("joints")? {
        None => None,
        Some(joints) => {
            let missing = || joints.missing("actuated", "a table with the tension limits effort and min");
            let actuated = joints.table("actuated")?.ok_or_else(missing)?;
            let [most] = actuated.required("effort")?;
            let least = actuated.number("min")?.unwrap_or(0.0);
            unread.extend(joints.unread().chain(actuated.unread()));
            Some([least, most])
        }
    };
    let diameter = match model.table("cable")? {
        None => None,
        Some(cable) => {
            let radius = cable.number("radius")?;
            notes.extend(cable.number("mass")?.map(|mass| {
                format!(
                    "{} {mass}: that of a bar whose length is not the cable's; linear_density is mass per metre",
                    cable.place_of("mass")
                )
            }));
            unread.extend(cable.unread());
            radius.map(|radius| 2.0 * radius)
        }
    };
    let missing = || model.missing("points", "a list of cables, each with frame and platform");
    let Value::Array(points) = model.get("points").ok_or_else(missing)? else { return Err(missing()) };
    let cable = |(k, point): (usize, &Value)| {
        let place = model.place_of("points");
        let point = Table::of(format!("{place}[{k}]"), point)?;
        let [outlet, attachment] = [point.required("frame")?, point.required("platform")?];
        unread.extend(point.unread().map(|key| key.replace(&format!("{place}[{k}]"), &place)));
        Ok(CableSpec { outlet, attachment, tension, diameter, ..CableSpec::default() })
    };
    points.iter().enumerate().map(cable).collect()
}

/// The box of the platform: its size around the origin, or its corners.
fn cuboid(platform: &Table) -> Result<Option<BodySpec>, Error> {
    let corners = [platform.numbers::<3>("lower")?, platform.numbers::<3>("upper")?];
    let (sides, center) = match (platform.numbers("size")?, corners) {
        (None, [None, None]) => return Ok(None),
        (Some(size), [None, None]) => (size, None),
        (None, [Some(lower), Some(upper)]) => {
            if (0..3).any(|k| lower[k] >= upper[k]) {
                let problem = format!("found {lower:?}, expected numbers below those of upper, {upper:?}");
                return Err(Error::invalid(platform.place_of("lower"), problem));
            }
            let center: [f64; 3] = std::array::from_fn(|k| 0.5 * (lower[k] + upper[k]));
            let sides = std::array::from_fn(|k| upper[k] - lower[k]);
            (sides, Some(center).filter(|center| *center != [0.0; 3]))
        }
        _ => {
            return Err(Error::invalid(&platform.place, "expected either size, or lower and upper, to give the box"));
        }
    };
    match platform.text("type")? {
        Some("box") => Ok(Some(BodySpec { cuboid: Some(sides), position: center, ..BodySpec::default() })),
        Some(_) => Ok(None),
        None => Err(platform.missing("type", "box, since the size of one is given")),
    }
}

/// Ixx, Iyy, Izz, Ixy, Ixz, Iyz, about the origin of the platform, which is its centre of mass.
fn inertia(platform: &Table, unread: &mut BTreeSet<String>) -> Result<Option<[f64; 6]>, Error> {
    match (platform.numbers("inertia")?, platform.table("inertial")?) {
        (listed, None) => Ok(listed),
        (None, Some(table)) => {
            let mut entries = [0.0; 6];
            for (entry, key) in entries.iter_mut().zip(["xx", "yy", "zz", "xy", "xz", "yz"]) {
                [*entry] = table.required(key)?;
            }
            unread.extend(table.unread());
            Ok(Some(entries))
        }
        (Some(_), Some(_)) => {
            Err(Error::invalid(platform.place_of("inertial"), "found beside inertia, expected one of them"))
        }
    }
}

/// A table of the file that remembers which of its keys are read.
struct Table<'a> {
    place: String,
    entries: &'a Map<String, Value>,
    read: RefCell<BTreeSet<String>>,
}

impl<'a> Table<'a> {
    fn of(place: String, value: &'a Value) -> Result<Self, Error> {
        let Value::Object(entries) = value else {
            return Err(Error::invalid(place, format!("found {}, expected a table", found(value))));
        };
        Ok(Table { place, entries, read: RefCell::default() })
    }

    fn place_of(&self, key: &str) -> String {
        if self.place.is_empty() { key.to_string() } else { format!("{}.{key}", self.place) }
    }

    fn get(&self, key: &str) -> Option<&'a Value> {
        self.read.borrow_mut().insert(key.to_string());
        self.entries.get(key)
    }

    fn missing(&self, key: &str, expected: &str) -> Error {
        Error::invalid(self.place_of(key), format!("found none, expected {expected}"))
    }

    fn wrong(&self, key: &str, value: &Value, expected: &str) -> Error {
        Error::invalid(self.place_of(key), format!("found {}, expected {expected}", found(value)))
    }

    fn table(&self, key: &str) -> Result<Option<Table<'a>>, Error> {
        self.get(key).map(|value| Table::of(self.place_of(key), value)).transpose()
    }

    fn text(&self, key: &str) -> Result<Option<&'a str>, Error> {
        self.get(key).map(|value| value.as_str().ok_or_else(|| self.wrong(key, value, "a word"))).transpose()
    }

    fn number(&self, key: &str) -> Result<Option<f64>, Error> {
        self.get(key).map(|value| value.as_f64().ok_or_else(|| self.wrong(key, value, "a finite number"))).transpose()
    }

    /// A list of numbers.
    fn numbers<const N: usize>(&self, key: &str) -> Result<Option<[f64; N]>, Error> {
        let Some(value) = self.get(key) else { return Ok(None) };
        let list = value.as_array().and_then(|list| list.iter().map(Value::as_f64).collect::<Option<Vec<f64>>>());
        let numbers = list.and_then(|list| list.try_into().ok());
        numbers.map(Some).ok_or_else(|| self.wrong(key, value, &format!("{N} finite numbers")))
    }

    /// A number, or a list of several.
    fn required<const N: usize>(&self, key: &str) -> Result<[f64; N], Error> {
        let (numbers, expected) = match N {
            1 => (self.number(key)?.map(|number| [number; N]), "a number".to_string()),
            _ => (self.numbers(key)?, format!("{N} numbers")),
        };
        numbers.ok_or_else(|| self.missing(key, &expected))
    }

    /// Places of the keys that were not read.
    fn unread(&self) -> impl Iterator<Item = String> {
        let read = self.read.borrow();
        let keys: Vec<String> =
            self.entries.keys().filter(|key| !read.contains(*key)).map(|key| self.place_of(key)).collect();
        keys.into_iter()
    }
}

/// A value in a message.
fn found(value: &Value) -> String {
    match value {
        Value::Null => "nothing".to_string(),
        Value::Object(_) => "a table".to_string(),
        other => other.to_string().chars().take(60).collect(),
    }
}
