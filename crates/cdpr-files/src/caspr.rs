//! Robots from CASPR (Lau et al., <https://github.com/darwinlau/CASPR>), whose models consist of a cables file and a
//! bodies file.
//!
//! Supported are a single rigid link that moves freely, and cables between the base and the link, from points or round
//! pulleys. Attachments are given relative to the joint or to the centre of mass; the platform frame here is that of the
//! joint. All lengths are metres, and forces newtons.
//!
//! **Pulleys** (`BaseRotatingPulleyAttachment`, CASPR issue 4): the cable meets the groove at `fixed_location`, running in
//! the direction of `cable_entry_vector`, about which the wheel swivels. That is the definition of [`PulleySpec`].
//!
//! **Stiffness** (`CableModelLinearSpring`): a cable of length L has the stiffness `K` / L, so `K` is E A. Cables of variable
//! stiffness (`CableModelVSD…`) have a spring in series, which stretches as well; `K_cable` alone would be too stiff.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::import_source::{ImportOptions, Source, inertia_of, platform_of};
use super::text::extension;
use super::xml::{Element, Read, parse, read};
use cdpr_core::error::{Error, nearest_name};
use cdpr_core::geometry::Vector;
use cdpr_core::model::{Cable, CableSpec, InertiaSpec, PulleySpec, RobotSpec};

/// Joints with which the link moves freely in space.
const FREE_JOINTS: [&str; 2] = ["SPATIAL_", "T_XYZ"];

/// Cables with a spring in series.
const VARIABLE_STIFFNESS: [&str; 3] = ["cable_vsd_torsion_spring", "cable_vsd_flexure_linear", "cable_vsd_polynomial"];

/// Imports a model from one of its two files, or from their folder.
pub(super) fn import(path: &Path, options: &ImportOptions) -> Result<Source, Error> {
    let (cables, bodies) = files(path, options.bodies.as_deref())?;
    let link_text = read(&bodies)?;
    let link = link(&link_text).map_err(|e| e.in_file(&bodies))?;
    let text = read(&cables)?;
    let set = cable_set(&text, options.cable_set.as_deref(), &link).map_err(|e| e.in_file(&cables))?;
    let model = stem(&cables).trim_end_matches(CABLES).to_string();
    let name = if set.others.is_empty() { model } else { format!("{model}, cable set {}", set.id) };
    let attachments: Vec<_> = set.cables.iter().map(|c| c.attachment).collect();
    let robot = RobotSpec {
        version: Some(cdpr_core::model::spec::FORMAT_VERSION),
        name: Some(name),
        mass: Some(link.mass),
        center_of_mass: Some(link.center_of_mass),
        inertia: link.inertia,
        platform: platform_of(&attachments),
        cables: set.cables,
        cable: None,
        tension_distribution: None,
    };
    let origin = format!("Imported from {} and {} (CASPR)", file_name(&cables), file_name(&bodies));
    Ok(Source { robot, origin, notes: link.notes.into_iter().chain(set.notes).collect() })
}

const CABLES: &str = "_cables";
const BODIES: &str = "_bodies";

fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// The cables file and the bodies file of a model, from either of them or their folder.
fn files(path: &Path, bodies: Option<&Path>) -> Result<(PathBuf, PathBuf), Error> {
    if path.is_dir() {
        return files(&only_cables_file(path)?, bodies);
    }
    let name = stem(path);
    let beside = |from: &str, to: &str| {
        let extension = path.extension().unwrap_or_default().to_string_lossy();
        let other = name.strip_suffix(from).map(|model| path.with_file_name(format!("{model}{to}.{extension}")));
        other.filter(|other| other.is_file())
    };
    if let Some(bodies) = bodies {
        return Ok((path.to_path_buf(), bodies.to_path_buf()));
    }
    if let Some(cables) = beside(BODIES, CABLES) {
        return Ok((cables, path.to_path_buf()));
    }
    let missing = || {
        Error::file(
            path,
            format!(
                "found no {BODIES}.xml beside it, expected NAME{CABLES}.xml and NAME{BODIES}.xml, or the name of the \
                 bodies file"
            ),
        )
    };
    Ok((path.to_path_buf(), beside(CABLES, BODIES).ok_or_else(missing)?))
}

fn only_cables_file(folder: &Path) -> Result<PathBuf, Error> {
    let unreadable = |e| Error::system(folder, "cannot be read", e);
    let entries = std::fs::read_dir(folder).map_err(unreadable)?;
    let paths = entries.filter_map(|entry| entry.ok().map(|e| e.path()));
    let mut found: Vec<PathBuf> =
        paths.filter(|p| extension(p).as_deref() == Some("xml") && stem(p).ends_with(CABLES)).collect();
    match (found.pop(), found.is_empty()) {
        (Some(only), true) => Ok(only),
        (last, _) => {
            let count = found.len() + usize::from(last.is_some());
            Err(Error::file(folder, format!("found {count} files NAME{CABLES}.xml in the folder, expected one")))
        }
    }
}

/// The platform: the only link of the bodies file.
struct Link {
    mass: f64,
    center_of_mass: [f64; 3],
    inertia: Option<InertiaSpec>,
    notes: Vec<String>,
}

fn link(text: &str) -> Result<Link, Error> {
    let (document, read) = (parse(text)?, Read::default());
    let root = Element::root(&document, &read, "bodies_system")?;
    let links = root.child("links")?;
    let mut all = links.children();
    let link = all.next().filter(|link| link.name() == "link_rigid");
    let link = link.ok_or_else(|| links.wrong("found no <link_rigid>, expected one"))?;
    if let Some(second) = all.next() {
        return Err(second.wrong("found a second link, expected a single rigid platform"));
    }
    if let Some(number) = link.optional_attribute("num").filter(|number| number.trim() != "1") {
        return Err(link.wrong(format!("found num \"{number}\", expected 1 for the platform")));
    }
    let joint = link.child("joint")?;
    let kind = joint.attribute("type")?;
    if !FREE_JOINTS.iter().any(|free| kind.starts_with(free)) {
        return Err(
            joint.wrong(format!("found a joint {kind}, expected a platform that moves freely (SPATIAL_… or T_XYZ)"))
        );
    }
    let physical = link.child("physical")?;
    let [mass] = physical.child("mass")?.numbers()?;
    let center_of_mass = physical.child("com_location")?.numbers()?;
    let mut notes = link_notes(link, joint, physical)?;
    let given = physical.optional("inertia")?.map(|node| inertia(node, mass, center_of_mass.into())).transpose()?;
    let inertia = given.and_then(|given| inertia_of(given).map_err(|note| notes.push(note)).ok());
    notes.extend(root.unread());
    Ok(Link { mass, center_of_mass, inertia, notes })
}

/// Moments and products of inertia about the centre of mass. CASPR gives them about that point or about the joint, and the
/// products as entries of the tensor (its `BodyModelRigid`).
fn inertia(node: Element, mass: f64, center: Vector) -> Result<[f64; 6], Error> {
    let mut entries = [0.0; 6];
    for (entry, name) in entries.iter_mut().zip(["Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"]) {
        [*entry] = node.child(name)?.numbers()?;
    }
    let [x, y, z] = center.into();
    // The parallel axis theorem.
    let of_the_mass =
        [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z].map(|product| mass * product);
    match node.attribute("ref")? {
        "com" => Ok(entries),
        "joint" => Ok(std::array::from_fn(|k| entries[k] - of_the_mass[k])),
        other => Err(node.wrong(format!("found ref \"{other}\", expected com or joint"))),
    }
}

fn link_notes(link: Element, joint: Element, physical: Element) -> Result<Vec<String>, Error> {
    let kind = joint.attribute("type")?;
    let ranges: Vec<String> = joint
        .attributes()
        .filter(|(name, _)| *name != "type")
        .map(|(name, value)| format!("{name} \"{value}\""))
        .collect();
    let mut notes =
        vec![format!("joint {kind}: {}", if ranges.is_empty() { "no ranges".into() } else { ranges.join(", ") })];
    if let Some(end) = physical.optional("end_location")? {
        let end: [f64; 3] = end.numbers()?;
        notes.extend((end != [0.0; 3]).then(|| format!("end_location {end:?}")));
    }
    if let Some(parent) = link.optional("parent")? {
        if let Some(number) = parent.optional("num")? {
            expect_link(number, 0.0)?;
        }
        let place: [f64; 3] = parent.child("location")?.numbers()?;
        let base = format!("location of the joint {place:?}: positions here are in the frame of the outlets");
        notes.extend((place != [0.0; 3]).then_some(base));
    }
    notes.extend(link.optional_attribute("name").map(|name| format!("name of the platform \"{name}\"")));
    Ok(notes)
}

/// A cable set, the names of the other sets in the file, and what is not carried over.
struct CableSet {
    id: String,
    others: Vec<String>,
    cables: Vec<CableSpec>,
    notes: Vec<String>,
}

fn cable_set(text: &str, wanted: Option<&str>, link: &Link) -> Result<CableSet, Error> {
    let (document, read) = (parse(text)?, Read::default());
    let root = Element::root(&document, &read, "cables")?;
    let sets: Vec<(&str, Element)> =
        root.named("cable_set").map(|set| Ok((set.attribute("id")?, set))).collect::<Result<_, Error>>()?;
    let named = root.optional_attribute("default_cable_set");
    let default = || named.or_else(|| sets.first().map(|(id, _)| *id));
    let id = wanted.or_else(default).ok_or_else(|| root.wrong("found no <cable_set>, expected at least one"))?;
    let Some((_, set)) = sets.iter().find(|(name, _)| *name == id) else {
        let names: Vec<&str> = sets.iter().map(|(name, _)| *name).collect();
        let hint = nearest_name(id, names.iter().copied()).map(|n| format!("; did you mean \"{n}\"?"));
        let problem = format!("found no cable set \"{id}\", expected one of {}", names.join(", "));
        return Err(root.wrong(problem + &hint.unwrap_or_default()));
    };
    let others: Vec<&(&str, Element)> = sets.iter().filter(|(name, _)| *name != id).collect();
    others.iter().for_each(|(_, other)| other.whole());
    if others.len() + 1 < sets.len() {
        return Err(set.wrong(format!("found several cable sets \"{id}\", expected one")));
    }
    let others: Vec<String> = others.iter().map(|(name, _)| name.to_string()).collect();
    let mut changed = BTreeSet::new();
    let mut cables = set.children().map(|c| cable(c, link, &mut changed)).collect::<Result<Vec<_>, _>>()?;
    let mut notes: Vec<String> = changed.into_iter().chain(root.unread()).collect();
    if !all_named_or_none(&cables) {
        cables.iter_mut().for_each(|c| c.name = None);
        notes.push("names of cables, since two are equal or one has none".to_string());
    }
    if !others.is_empty() {
        notes.push(format!("other cable sets: {}", others.join(", ")));
    }
    Ok(CableSet { id: id.to_string(), others, cables, notes })
}

/// Whether each cable has a name of its own, or none has one.
fn all_named_or_none(cables: &[CableSpec]) -> bool {
    let names: BTreeSet<_> = cables.iter().filter_map(|c| c.name.as_ref()).collect();
    names.len() == cables.len() || cables.iter().all(|c| c.name.is_none())
}

fn cable(node: Element, link: &Link, changed: &mut BTreeSet<String>) -> Result<CableSpec, Error> {
    let properties = node.child("properties")?;
    let stiffness = stiffness(node, properties, changed)?;
    let limit = |name: &str| properties.child(name).and_then(Element::numbers::<1>).map(|[x]| x);
    let diameter = properties.optional("diameter")?.map(Element::numbers::<1>).transpose()?.map(|[x]| x);
    let ends: Vec<Element> = node.child("attachments")?.children().collect();
    let [base, platform] = ends[..] else {
        return Err(node.wrong(format!("found {} attachments, expected two: base and platform", ends.len())));
    };
    let reference = match node.attribute("attachment_reference")? {
        "joint" => [0.0; 3],
        "com" => link.center_of_mass,
        other => {
            return Err(node.wrong(format!("found attachment_reference \"{other}\", expected joint or com")));
        }
    };
    let (outlet, pulley) = outlet(base)?;
    let own: [f64; 3] = attached_to(platform, 1.0)?;
    let cable = CableSpec {
        name: node.optional_attribute("name").map(cable_name),
        outlet,
        attachment: std::array::from_fn(|k| own[k] + reference[k]),
        tension: Some([limit("force_min")?, limit("force_max")?]),
        diameter,
        pulley,
        stiffness,
        ..CableSpec::default()
    };
    Cable::try_from(&cable).map_err(|error| node.wrong(error))?;
    Ok(cable)
}

/// The axial stiffness of a cable, N; `None` if it does not stretch, or is not known.
fn stiffness(node: Element, properties: Element, changed: &mut BTreeSet<String>) -> Result<Option<f64>, Error> {
    match node.name() {
        "cable_ideal" => Ok(None),
        "cable_linear_spring" => properties.child("K")?.numbers().map(|[k]| Some(k)),
        kind if VARIABLE_STIFFNESS.contains(&kind) => {
            changed.insert(format!("{kind}: its spring is left out, and so is the stiffness"));
            Ok(None)
        }
        "cable_passive_linear_spring" => Err(node.wrong("found a spring without a winch, expected cables only")),
        _ => Err(node.wrong(format!(
            "found this in <cable_set>, expected <cable_ideal>, <cable_linear_spring>, <{}>",
            VARIABLE_STIFFNESS.join(">, <")
        ))),
    }
}

/// A descriptive name: in CASPR it is often just a number.
fn cable_name(name: &str) -> String {
    if name.chars().all(|c| c.is_ascii_digit()) { format!("cable {name}") } else { name.to_string() }
}

fn attached_to(end: Element, number: f64) -> Result<[f64; 3], Error> {
    if end.name() != "attachment" {
        return Err(end.wrong("found this, expected <attachment>, or <base_rotating_pulley> for the base"));
    }
    expect_link(end.child("link")?, number)?;
    end.child("location")?.numbers()
}

fn expect_link(link: Element, number: f64) -> Result<(), Error> {
    let [found] = link.numbers::<1>()?;
    if found != number {
        return Err(link.wrong(format!("found link {found}, expected 0 for the base, then 1 for the platform")));
    }
    Ok(())
}

/// Where a cable leaves the frame, and its pulley.
fn outlet(base: Element) -> Result<([f64; 3], Option<PulleySpec>), Error> {
    if base.name() != "base_rotating_pulley" {
        return Ok((attached_to(base, 0.0)?, None));
    }
    let [radius] = base.child("pulley_radius")?.numbers()?;
    let axis = base.child("cable_entry_vector")?.numbers()?;
    Ok((base.child("fixed_location")?.numbers()?, Some(PulleySpec { radius, axis })))
}
