//! The forbidden regions of a scene as closed triangle meshes, named after the pairs of bodies that collide in them.
//!
//! At a fixed orientation every pair of bodies forbids a region of space: a cable and an obstacle the shadow of the
//! obstacle seen from the outlet (the paper, Figure 3), obstacle and platform their Minkowski difference, a cable and
//! the platform a cone (a mirrored shadow, for parts to which the cable is not attached), two cables a pair of flat
//! wedges. Planning has to avoid their union.
//!
//! The meshes do not include clearances and cable diameters, with which the regions have round edges and are not
//! polyhedra, nor limits of cable length, nor the bodies that close seams, which are as thin as rounding errors.

use serde::Serialize;

use crate::choices;
use crate::collision::{Conditions, Kind};
use crate::error::{Error, nearest_name};
use crate::geometry::{Aabb, TriangleMesh, Vector};
use crate::model::Scene;
use crate::watch::Watch;

/// The space of a region.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Space {
    /// Where the cable's end on the platform cannot be; the shadow begins at the obstacle. Clipped to the workspace.
    #[default]
    Attachment,
    /// Where the platform's origin cannot be. Clipped to the positions at which the platform is inside the workspace.
    Position,
}

choices!(Space, "space", [
    Attachment = "attachment": "Where the cable's end cannot be; seen from the outlet, the shadow begins at the obstacle",
    Position = "position": "Where the platform's origin cannot be",
]);

/// Selects regions and their space.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RegionOptions {
    /// The space; by default [`Space::Attachment`] for shadows, [`Space::Position`] for all regions.
    pub space: Option<Space>,
    /// Include the regions of platform and obstacles, of cables and platform, and of pairs of cables, which exist only
    /// in the space of positions.
    pub all: bool,
    /// Only regions of these cables, by name; empty for all.
    pub cables: Vec<String>,
    /// Only regions of these obstacles, by name; empty for all.
    pub obstacles: Vec<String>,
}

/// A forbidden region.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedMesh {
    /// The names of the bodies, as in "cable 3 / pillar"; unique among the regions.
    pub name: String,
    /// The condition that is violated in the region.
    pub kind: Kind,
    /// The bodies that collide in the region.
    pub culprits: Vec<String>,
    /// Surface, world, m: one closed convex piece per convex part; pieces may overlap. The region of two cables is flat
    /// and has two sides.
    pub mesh: TriangleMesh,
}

/// Forbidden regions of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Regions {
    /// The space of the regions.
    pub space: Space,
    /// The box to which the regions are clipped, m.
    pub within: Aabb,
    /// The regions, in the order of the scene.
    pub meshes: Vec<NamedMesh>,
}

/// Summary of a region: everything except its shape.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RegionSummary<'a> {
    /// Name of the region; see [`NamedMesh::name`].
    pub name: &'a str,
    /// Kind of the violated condition; see [`NamedMesh::kind`].
    pub kind: Kind,
    /// Bodies that collide in the region; see [`NamedMesh::culprits`].
    pub culprits: &'a [String],
    /// Number of vertices.
    pub vertices: usize,
    /// Number of triangles.
    pub triangles: usize,
    /// Volume, m³; overlapping parts all count.
    pub volume: f64,
}

impl NamedMesh {
    /// The summary of the region.
    pub fn summary(&self) -> RegionSummary<'_> {
        let NamedMesh { name, kind, culprits, mesh } = self;
        let (vertices, triangles) = (mesh.vertices.len(), mesh.triangles.len());
        RegionSummary { name, kind: *kind, culprits, vertices, triangles, volume: mesh.volume() }
    }
}

/// The shadows of a scene's obstacles and, if requested, the other forbidden regions.
///
/// Pairs that the scene ignores have no region, and regions outside the box are left out.
///
/// # Errors
/// All regions requested in the space of attachments, a name that is not in the scene, and the errors of
/// [`Conditions::new`].
///
/// # Example
/// ```
/// use cdpr_core::regions::{RegionOptions, regions};
/// let found = regions(&cdpr_core::testing::hard1(), &RegionOptions::default())?;
/// assert_eq!((found.meshes.len(), found.meshes[3].name.as_str()), (8, "cable 3 / pillar"));
/// assert!(found.meshes.iter().all(|region| region.mesh.is_watertight()));
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn regions(scene: &Scene, options: &RegionOptions) -> Result<Regions, Error> {
    regions_within(scene, options, &Watch::NONE)
}

/// The forbidden regions of a scene, computed within a watch.
///
/// # Errors
/// The errors of [`regions`]; [`Error::interrupted`], [`Error::out_of_time`].
pub fn regions_within(scene: &Scene, options: &RegionOptions, watch: &Watch) -> Result<Regions, Error> {
    let space = options.checked(scene)?;
    let conditions = Conditions::within(scene, watch)?;
    let within = match space {
        Space::Attachment => *scene.workspace(),
        Space::Position => {
            let (min, max) = conditions.position_box();
            Aabb { min, max }
        }
    };
    let mut found = Regions { space, within, meshes: Vec::new() };
    for condition in &conditions.list {
        watch.check()?;
        let (details, bodies) = (condition.details(), &conditions.bodies);
        let (kind, culprits) = (details.kind(), conditions.culprits(condition));
        if !options.wants(kind, &culprits) || details.closes_seam(bodies) {
            continue;
        }
        let by = match space {
            Space::Attachment => details.attachment(bodies),
            Space::Position => Vector::zeros(),
        };
        let pieces = details.surfaces(bodies, &by, &within).ok_or_else(|| {
            Error::invalid(culprits.join(" and "), "the hull of their differences is too close to degenerate")
        })?;
        pieces.iter().for_each(|piece| found.add(kind, &culprits, piece));
    }
    Ok(found)
}

impl RegionOptions {
    /// The requested space, after checking that the names are in the scene.
    fn checked(&self, scene: &Scene) -> Result<Space, Error> {
        let cables: Vec<&str> = scene.robot().cables().iter().map(|c| c.name.as_str()).collect();
        let obstacles: Vec<&str> = scene.obstacles().iter().map(|o| o.name.as_str()).collect();
        self.cables.iter().try_for_each(|name| known("cable", name, &cables))?;
        self.obstacles.iter().try_for_each(|name| known("obstacle", name, &obstacles))?;
        match (self.space, self.all) {
            (Some(Space::Attachment), true) => Err(Error::invalid(
                "space",
                "found \"attachment\" with all regions, expected \"position\": each cable has a space \
                 of attachments of its own, and the platform none",
            )),
            (None, true) => Ok(Space::Position),
            (space, _) => Ok(space.unwrap_or_default()),
        }
    }

    fn wants(&self, kind: Kind, culprits: &[String]) -> bool {
        let among = |names: &[String]| names.is_empty() || culprits.iter().any(|c| names.contains(c));
        (self.all || kind == Kind::CableObstacle) && among(&self.cables) && among(&self.obstacles)
    }
}

fn known(what: &str, name: &str, names: &[&str]) -> Result<(), Error> {
    if names.contains(&name) {
        return Ok(());
    }
    let hint = nearest_name(name, names.iter().copied()).map(|n| format!("; did you mean \"{n}\"?"));
    let expected = if names.is_empty() { "none, the scene has none".to_string() } else { names.join(", ") };
    Err(Error::invalid(what, format!("found \"{name}\", expected one of {expected}{}", hint.unwrap_or_default())))
}

impl Regions {
    /// Adds a piece to the region of these bodies.
    fn add(&mut self, kind: Kind, culprits: &[String], piece: &TriangleMesh) {
        if let Some(region) = self.meshes.iter_mut().find(|r| r.kind == kind && r.culprits == culprits) {
            return region.mesh.append(piece);
        }
        let name = unused(&pair_name(culprits), ' ', |name| self.meshes.iter().any(|r| r.name == name));
        self.meshes.push(NamedMesh { name, kind, culprits: culprits.to_vec(), mesh: piece.clone() });
    }

    /// Volume of the box to which the regions are clipped, m³; 0 if it is empty.
    pub fn box_volume(&self) -> f64 {
        (self.within.max - self.within.min).iter().map(|side| side.max(0.0)).product()
    }
}

/// The names of bodies in one, as in "cable 3 / pillar".
pub fn pair_name(culprits: &[String]) -> String {
    culprits.join(" / ")
}

/// The name, followed by a number if it is already in use.
pub fn unused(name: &str, separator: char, in_use: impl Fn(&str) -> bool) -> String {
    let numbered = (2..).map(|k| format!("{name}{separator}{k}"));
    std::iter::once(name.to_string()).chain(numbered).find(|name| !in_use(name)).expect("names do not run out")
}
