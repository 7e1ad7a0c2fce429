//! Robots from CASPR (Lau et al., <https://github.com/darwinlau/CASPR>), whose models consist of a cables file and a
//! bodies file.
//!
//! Supported are a single rigid link that moves freely and straight cables between the base and the link. Attachments
//! are given relative to the joint or to the centre of mass; the platform frame here is that of the joint.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use roxmltree::Node;

use super::import_source::{ImportOptions, Source, inertia_of, platform_of};
use super::text::extension;
use super::xml::{at, attribute, child, children, numbers, parse, read};
use cdpr_core::error::{Error, nearest_name};
use cdpr_core::geometry::Vector;
use cdpr_core::model::{CableSpec, InertiaSpec, RobotSpec};

/// Joints with which the link moves freely in space.
const FREE_JOINTS: [&str; 2] = ["SPATIAL_", "T_XYZ"];

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
    let document = parse(text)?;
    let root = rooted(document.root_element(), "bodies_system")?;
    let links = child(root, "links")?;
    let mut all = children(links);
    let link = all.next().filter(|n| n.has_tag_name("link_rigid"));
    let link = link.ok_or_else(|| at(links, "found no <link_rigid>, expected one"))?;
    if let Some(second) = all.next() {
        return Err(at(second, "found a second link, expected a single rigid platform"));
    }
    let joint = child(link, "joint")?;
    let kind = attribute(joint, "type")?;
    if !FREE_JOINTS.iter().any(|free| kind.starts_with(free)) {
        return Err(at(
            joint,
            format!("found a joint {kind}, expected a platform that moves freely (SPATIAL_… or T_XYZ)"),
        ));
    }
    let physical = child(link, "physical")?;
    let [mass] = numbers(child(physical, "mass")?)?;
    let center_of_mass = numbers(child(physical, "com_location")?)?;
    let mut notes = link_notes(links, link, joint, physical)?;
    let given = child(physical, "inertia").ok().map(|node| inertia(node, mass, center_of_mass.into())).transpose()?;
    let inertia = given.and_then(|given| inertia_of(given).map_err(|note| notes.push(note)).ok());
    Ok(Link { mass, center_of_mass, inertia, notes })
}

/// Moments and products of inertia about the centre of mass. CASPR gives them about that point or about the joint, and the
/// products as entries of the tensor (its `BodyModelRigid`).
fn inertia(node: Node, mass: f64, center: Vector) -> Result<[f64; 6], Error> {
    let mut entries = [0.0; 6];
    for (entry, name) in entries.iter_mut().zip(["Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"]) {
        [*entry] = numbers(child(node, name)?)?;
    }
    let [x, y, z] = center.into();
    // The parallel axis theorem.
    let of_the_mass =
        [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z].map(|product| mass * product);
    match attribute(node, "ref")? {
        "com" => Ok(entries),
        "joint" => Ok(std::array::from_fn(|k| entries[k] - of_the_mass[k])),
        other => Err(at(node, format!("found ref \"{other}\", expected com or joint"))),
    }
}

fn link_notes(links: Node, link: Node, joint: Node, physical: Node) -> Result<Vec<String>, Error> {
    let mut notes = Vec::new();
    let kind = attribute(joint, "type")?;
    let ranges: Vec<_> = joint.attributes().filter(|a| a.name() != "type").collect();
    let ranges: Vec<String> = ranges.iter().map(|a| format!("{} \"{}\"", a.name(), a.value())).collect();
    notes.push(format!("joint {kind}: {}", if ranges.is_empty() { "no ranges".into() } else { ranges.join(", ") }));
    if let Ok(end) = child(physical, "end_location") {
        let end: [f64; 3] = numbers(end)?;
        notes.extend((end != [0.0; 3]).then(|| format!("end_location {end:?}")));
    }
    if let Ok(parent) = child(link, "parent") {
        let place: [f64; 3] = numbers(child(parent, "location")?)?;
        let base = format!("location of the joint {place:?}: positions here are in the frame of the outlets");
        notes.extend((place != [0.0; 3]).then_some(base));
    }
    let known = ["mass", "com_location", "end_location", "inertia"];
    let unread = children(physical).filter(|n| !known.contains(&n.tag_name().name()));
    let outside = children(link).filter(|n| !["joint", "physical", "parent"].contains(&n.tag_name().name()));
    notes.extend(unread.chain(outside).map(|n| n.tag_name().name().to_string()));
    notes.extend(links.attributes().map(|a| a.name().to_string()));
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
    let document = parse(text)?;
    let root = rooted(document.root_element(), "cables")?;
    let sets: Vec<(&str, Node)> =
        children(root).map(|set| Ok((attribute(set, "id")?, set))).collect::<Result<_, Error>>()?;
    let default = || root.attribute("default_cable_set").or_else(|| sets.first().map(|(id, _)| *id));
    let id = wanted.or_else(default).ok_or_else(|| at(root, "found no <cable_set>, expected at least one"))?;
    let Some((_, set)) = sets.iter().find(|(name, _)| *name == id) else {
        let names: Vec<&str> = sets.iter().map(|(name, _)| *name).collect();
        let hint = nearest_name(id, names.iter().copied()).map(|n| format!("; did you mean \"{n}\"?"));
        let problem = format!("found no cable set \"{id}\", expected one of {}", names.join(", "));
        return Err(at(root, problem + &hint.unwrap_or_default()));
    };
    let mut unread = BTreeSet::new();
    let mut cables = children(*set).map(|c| cable(c, link, &mut unread)).collect::<Result<Vec<_>, _>>()?;
    let mut notes: Vec<String> = unread.into_iter().collect();
    if repeated_names(&cables) {
        cables.iter_mut().for_each(|c| c.name = None);
        notes.push("names of cables, since two are equal".to_string());
    }
    let others: Vec<String> = sets.iter().map(|(name, _)| name.to_string()).filter(|name| name != id).collect();
    if !others.is_empty() {
        notes.push(format!("other cable sets: {}", others.join(", ")));
    }
    Ok(CableSet { id: id.to_string(), others, cables, notes })
}

fn repeated_names(cables: &[CableSpec]) -> bool {
    let names: BTreeSet<_> = cables.iter().map(|c| &c.name).collect();
    names.len() < cables.len()
}

fn rooted<'a, 'i>(root: Node<'a, 'i>, name: &str) -> Result<Node<'a, 'i>, Error> {
    if root.has_tag_name(name) {
        return Ok(root);
    }
    Err(at(root, format!("found this at the top, expected <{name}>")))
}

fn cable(node: Node, link: &Link, unread: &mut BTreeSet<String>) -> Result<CableSpec, Error> {
    let properties = child(node, "properties")?;
    let limit = |name: &str| child(properties, name).and_then(numbers::<1>).map(|[x]| x);
    let known = ["force_min", "force_max"];
    let others = children(properties).filter(|n| !known.contains(&n.tag_name().name()));
    unread.extend(others.map(|n| format!("{} of cables", n.tag_name().name())));
    if !node.has_tag_name("cable_ideal") {
        unread.insert(format!("{}: treated as an ideal cable", node.tag_name().name()));
    }
    let ends: Vec<Node> = children(child(node, "attachments")?).collect();
    let [base, platform] = ends[..] else {
        return Err(at(node, format!("found {} attachments, expected two: base and platform", ends.len())));
    };
    let reference = match node.attribute("attachment_reference") {
        Some("joint") | None => [0.0; 3],
        Some("com") => link.center_of_mass,
        Some(other) => return Err(at(node, format!("found attachment_reference \"{other}\", expected joint or com"))),
    };
    let own: [f64; 3] = attached_to(platform, 1.0)?;
    Ok(CableSpec {
        name: node.attribute("name").map(cable_name),
        outlet: outlet(base, unread)?,
        attachment: std::array::from_fn(|k| own[k] + reference[k]),
        tension: Some([limit("force_min")?, limit("force_max")?]),
        diameter: None,
        length: None,
    })
}

/// A descriptive name: in CASPR it is often just a number.
fn cable_name(name: &str) -> String {
    if name.chars().all(|c| c.is_ascii_digit()) { format!("cable {name}") } else { name.to_string() }
}

fn attached_to(end: Node, number: f64) -> Result<[f64; 3], Error> {
    let link = child(end, "link")?;
    let [found] = numbers::<1>(link)?;
    if found != number {
        return Err(at(link, format!("found link {found}, expected 0 for the base, then 1 for the platform")));
    }
    numbers(child(end, "location")?)
}

fn outlet(base: Node, unread: &mut BTreeSet<String>) -> Result<[f64; 3], Error> {
    if !base.has_tag_name("base_rotating_pulley") {
        return attached_to(base, 0.0);
    }
    let [radius] = numbers::<1>(child(base, "pulley_radius")?)?;
    unread.insert(format!(
        "rotating pulleys of radius {radius} m: cables start at fixed_location, which is up to {} m off",
        2.0 * radius
    ));
    numbers(child(base, "fixed_location")?)
}
