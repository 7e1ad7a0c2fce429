//! Robots of `cdpr`, the simulation of cable robots in Gazebo by Olivier Kermorgant
//! (<https://github.com/oKermorgant/cdpr>): one YAML file with `platform`, `points`, `joints` and `cable`.

use std::path::Path;

use serde::Deserialize;

use super::import_source::{Source, inertia_of, platform_of};
use super::text;
use cdpr_core::error::{Error, name_of_file};
use cdpr_core::fixed_length::FixedLength;
use cdpr_core::model::{BodySpec, CableSpec, RobotSpec};
use cdpr_core::numerics::MOST_XML_BYTES;

/// The parts of the file that are read; the rest is listed as not carried over.
#[derive(Deserialize)]
struct Model {
    platform: Platform,
    points: Vec<Points>,
    joints: Option<Joints>,
    cable: Option<Cable>,
    frame: Option<serde::de::IgnoredAny>,
}

#[derive(Deserialize)]
struct Platform {
    #[serde(rename = "type")]
    kind: Option<String>,
    size: Option<[f64; 3]>,
    mass: Option<f64>,
    /// Ixx, Iyy, Izz, Ixy, Ixz, Iyz, about the origin of the platform, which is its centre of mass.
    inertia: Option<[f64; 6]>,
    position: Option<Pose>,
}

#[derive(Deserialize)]
struct Pose {
    xyz: [f64; 3],
    rpy: [f64; 3],
}

#[derive(Deserialize)]
struct Points {
    frame: [f64; 3],
    platform: [f64; 3],
}

#[derive(Deserialize)]
struct Joints {
    actuated: Actuated,
}

#[derive(Deserialize)]
struct Actuated {
    min: Option<f64>,
    effort: f64,
}

#[derive(Deserialize)]
struct Cable {
    radius: Option<f64>,
}

pub(super) fn import(path: &Path) -> Result<Source, Error> {
    let text = text::read_at_most(path, MOST_XML_BYTES)?;
    let model = serde_saphyr::with_deserializer_from_str(&text, |yaml| Model::deserialize(FixedLength(yaml)));
    let model = model.map_err(|e| {
        let problem = e.to_string();
        Error::invalid("", problem.lines().next().unwrap_or("is not valid YAML")).in_file(path)
    })?;
    let tension = model.joints.as_ref().map(|j| [j.actuated.min.unwrap_or(0.0), j.actuated.effort]);
    let diameter = model.cable.as_ref().and_then(|c| c.radius).map(|radius| 2.0 * radius);
    let cable =
        |p: &Points| CableSpec { name: None, outlet: p.frame, attachment: p.platform, tension, diameter, length: None };
    let attachments: Vec<_> = model.points.iter().map(|p| p.platform).collect();
    let inertia = model.platform.inertia.map(inertia_of);
    let robot = RobotSpec {
        version: Some(cdpr_core::model::spec::FORMAT_VERSION),
        name: name_of_file(path),
        mass: model.platform.mass,
        center_of_mass: None,
        inertia: inertia.as_ref().and_then(|found| found.as_ref().ok()).copied(),
        platform: platform(&model.platform).unwrap_or_else(|| platform_of(&attachments)),
        cables: model.points.iter().map(cable).collect(),
    };
    let file = path.file_name().unwrap_or_default().to_string_lossy();
    let origin = format!("Imported from {file} (cdpr for Gazebo)");
    Ok(Source { robot, origin, notes: notes(&model, inertia.and_then(Result::err)) })
}

fn platform(platform: &Platform) -> Option<Vec<BodySpec>> {
    let size = platform.size.filter(|_| platform.kind.as_deref() == Some("box"))?;
    Some(vec![BodySpec { cuboid: Some(size), ..BodySpec::default() }])
}

fn notes(model: &Model, inertia: Option<String>) -> Vec<String> {
    let mut notes = Vec::new();
    if let Some(Pose { xyz, rpy }) = &model.platform.position {
        notes.push(format!(
            "initial position {xyz:?}, rpy {rpy:?}: start and orientation belong in the query of a scene"
        ));
    }
    if platform(&model.platform).is_none() {
        notes.push("the platform has no box with a size: the hull of the attachments is used".to_string());
    }
    notes.extend(inertia);
    notes.extend(model.frame.map(|_| "frame: its bars are not imported as obstacles".to_string()));
    notes.push("speeds and damping of joints, masses of cables, colours".to_string());
    notes
}
