//! A checked robot: platform parts, cables, and values derived from them.

use nalgebra::Matrix3;

use super::drum::Drum;
use super::spec::{
    CableDefaultsSpec, CableSpec, Distribution, DrumSpec, FORMAT_VERSION, PLATFORM, PulleySpec, RobotSpec,
};
use super::{body, inertia};
use crate::error::Error;
use crate::geometry::seam::{Seam, seams};
use crate::geometry::{Departure, Point, Polytope, Pulley, Vector};
use crate::limits::{LEAST_BODY, LEAST_EXTENT, MOST_BODIES, MOST_CABLES, MOST_GEAR};
use crate::tolerances::{MIN_CABLE_LENGTH, ON_SURFACE, PARALLEL};
use crate::words::small_length;

/// A cable from an outlet to the platform.
#[derive(Debug, Clone, PartialEq)]
pub struct Cable {
    /// Name of the cable in messages.
    pub name: String,
    /// Where the cable leaves the frame, world, m.
    pub outlet: Point,
    /// Where the cable is attached to the platform, platform frame, m.
    pub attachment: Point,
    /// Minimum and maximum tension of the cable, N.
    pub tension: Option<[f64; 2]>,
    /// Diameter of the cable, m.
    pub diameter: f64,
    /// Minimum and maximum length of the cable, m.
    pub length: Option<[f64; 2]>,
    /// Mass per length, kg/m.
    pub linear_density: f64,
    /// The tension at the platform that the controller keeps at least, N, if known.
    pub sag_tension: Option<f64>,
    /// The true outlet is at most this far from `outlet`, m.
    pub outlet_error: f64,
    /// The last pulley; `None` if the outlet is a fixed point.
    pub pulley: Option<Pulley>,
    /// Axial stiffness E A, N; infinite if the cable does not stretch.
    pub stiffness: f64,
    /// The drum of the winch, if known.
    pub drum: Option<Drum>,
}

impl Cable {
    /// Where the cable leaves the frame, how it pulls and how long it is, with its attachment at a point of the world; `None` if
    /// it is shorter than [`MIN_CABLE_LENGTH`], or cannot leave its pulley in that direction.
    pub fn departure(&self, attachment: &Point) -> Option<Departure> {
        if let Some(pulley) = &self.pulley {
            return pulley.departure(&self.outlet, attachment);
        }
        let line = self.outlet - attachment;
        let length = line.norm();
        (length >= MIN_CABLE_LENGTH).then(|| Departure {
            exit: self.outlet,
            pull: line.normalize(),
            free: length,
            wrap: 0.0,
            length,
        })
    }

    /// Length of the cable to an attachment, round its pulley if it has one, m; NaN if it cannot leave the pulley.
    pub fn length_to(&self, attachment: &Point) -> f64 {
        match &self.pulley {
            None => (self.outlet - attachment).norm(),
            Some(pulley) => pulley.departure(&self.outlet, attachment).map_or(f64::NAN, |found| found.length),
        }
    }
}

/// A cable robot: a platform of convex parts that hangs on cables. Immutable; made by [`Robot::try_from`].
#[derive(Debug, Clone, PartialEq)]
pub struct Robot {
    spec: RobotSpec,
    cables: Vec<Cable>,
    parts: Vec<Polytope>,
    seams: Vec<Seam>,
    center_of_mass: Point,
    inertia: Option<Matrix3<f64>>,
}

impl TryFrom<RobotSpec> for Robot {
    type Error = Error;

    /// Checks a robot: finite numbers, unique names, tension and length limits in order, no attachment inside a part.
    fn try_from(spec: RobotSpec) -> Result<Self, Error> {
        if let Some(version) = spec.version.filter(|v| *v != FORMAT_VERSION) {
            return Err(Error::invalid("version", format!("found {version}, expected {FORMAT_VERSION}")));
        }
        body::optional_name("name", spec.name.as_deref())?;
        for (k, part) in spec.platform.iter().enumerate() {
            body::optional_name(&format!("platform[{k}].name"), part.name.as_deref())?;
        }
        if spec.platform.is_empty() {
            return Err(Error::invalid("platform", "found no parts, expected at least one (a point is enough)"));
        }
        if spec.cables.is_empty() {
            return Err(Error::invalid("cables", "found none, expected at least one"));
        }
        body::at_most("cables", spec.cables.len(), MOST_CABLES)?;
        body::at_most("platform", spec.platform.len(), MOST_BODIES)?;
        if let Some(mass) = spec.mass {
            body::not_negative("mass", mass)?;
        }
        let center_of_mass = body::point("center_of_mass", spec.center_of_mass.unwrap_or_default())?;
        let inertia = spec.inertia.as_ref().map(|given| inertia::checked("inertia", given)).transpose()?;
        let parts = (spec.platform.iter().enumerate())
            .map(|(k, part)| body::build(&format!("platform[{k}]"), part))
            .collect::<Result<Vec<_>, _>>()?;
        let common = spec.cable.clone().unwrap_or_default();
        let cables = (spec.cables.iter().enumerate())
            .map(|(k, cable)| checked_cable(k, cable, &common).map_err(|e| e.under(&format!("cables[{k}]"))))
            .collect::<Result<Vec<_>, _>>()?;
        body::large_enough("platform", "a platform", parts.iter().flat_map(Polytope::vertices), LEAST_BODY)?;
        body::large_enough("cables", "outlets within a box", cables.iter().map(|c| &c.outlet), LEAST_EXTENT)?;
        let seams = seams(&parts.iter().collect::<Vec<_>>());
        unique_names(&cables)?;
        attachments_outside(&cables, &parts, &seams)?;
        Ok(Robot { spec, cables, parts, seams, center_of_mass, inertia })
    }
}

impl Robot {
    /// The robot with tension limits of at most this, N, and the names of the cables whose limits were larger.
    pub(super) fn with_most_tension(mut self, most: f64) -> (Self, Vec<String>) {
        let mut lowered = Vec::new();
        for cable in &mut self.cables {
            if let Some([least, largest]) = &mut cable.tension
                && *largest > most.max(*least)
            {
                *largest = most.max(*least);
                lowered.push(cable.name.clone());
            }
        }
        (self, lowered)
    }

    /// The robot with other tensions.
    pub(super) fn with_tensions(mut self, chosen: Distribution) -> Self {
        self.spec.tension_distribution = Some(chosen);
        self
    }

    /// Which of all tensions that balance the loads its controller keeps.
    pub fn distribution(&self) -> Distribution {
        self.spec.tension_distribution.unwrap_or_default()
    }

    /// The robot as plain data.
    pub fn spec(&self) -> &RobotSpec {
        &self.spec
    }

    /// The name of the robot, or "robot".
    pub fn name(&self) -> &str {
        self.spec.name.as_deref().unwrap_or("robot")
    }

    /// Cables, in the order of the file, counting from 0.
    pub fn cables(&self) -> &[Cable] {
        &self.cables
    }

    /// The first cable that runs round a pulley, if one does.
    pub fn cable_with_pulley(&self) -> Option<&Cable> {
        self.cables.iter().find(|cable| cable.pulley.is_some())
    }

    /// Names of the cables, in the order of the file.
    pub fn cable_names(&self) -> Vec<&str> {
        self.cables.iter().map(|cable| cable.name.as_str()).collect()
    }

    /// Whether the mass and all tension limits are known, which wrenches and tensions require.
    pub fn knows_its_forces(&self) -> bool {
        self.mass().is_some() && self.cables.iter().all(|cable| cable.tension.is_some())
    }

    /// Convex parts of the platform, platform frame.
    pub fn parts(&self) -> &[Polytope] {
        &self.parts
    }

    /// Bodies that close the seams between parts, platform frame; see [`crate::geometry::seam`].
    pub fn seams(&self) -> &[Seam] {
        &self.seams
    }

    /// Mass of the platform, kg, if given.
    pub fn mass(&self) -> Option<f64> {
        self.spec.mass
    }

    /// Centre of mass, platform frame, m.
    pub fn center_of_mass(&self) -> Point {
        self.center_of_mass
    }

    /// Inertia about the centre of mass, platform axes, kg·m²: as given or, if only the mass is, that of the parts at uniform
    /// density about their common centre; `None` without a mass.
    pub fn inertia(&self) -> Option<Matrix3<f64>> {
        let mass = self.mass()?;
        Some(self.inertia.unwrap_or_else(|| inertia::uniform(mass, &self.parts)))
    }
}

impl TryFrom<&CableSpec> for Cable {
    type Error = Error;

    /// Checks a cable by itself: finite numbers in their ranges. Without a name it is "cable 0".
    fn try_from(spec: &CableSpec) -> Result<Self, Error> {
        checked_cable(0, spec, &CableDefaultsSpec::default())
    }
}

fn checked_cable(index: usize, spec: &CableSpec, common: &CableDefaultsSpec) -> Result<Cable, Error> {
    body::optional_name("name", spec.name.as_deref())?;
    let tension = spec.tension.map(|t| body::interval("tension", t)).transpose()?;
    let linear_density =
        body::not_negative("linear_density", spec.linear_density.or(common.linear_density).unwrap_or(0.0))?;
    let kept = spec.sag_tension.or(common.sag_tension).map(|kept| body::positive("sag_tension", kept)).transpose()?;
    if let (Some(kept), Some([_, most])) = (kept, tension)
        && kept > most
    {
        return Err(Error::invalid(
            "sag_tension",
            format!("found {kept} N, expected at most the maximum tension, {most} N"),
        ));
    }
    Ok(Cable {
        name: spec.name.clone().unwrap_or_else(|| format!("cable {index}")),
        outlet: body::point("outlet", spec.outlet)?,
        attachment: body::point("attachment", spec.attachment)?,
        tension,
        diameter: body::not_negative("diameter", spec.diameter.unwrap_or(0.0))?,
        length: spec.length.map(|l| body::interval("length", l)).transpose()?,
        linear_density,
        sag_tension: kept.or(tension.map(|[least, _]| least)),
        outlet_error: body::not_negative("outlet_error", spec.outlet_error.or(common.outlet_error).unwrap_or(0.0))?,
        pulley: (spec.pulley.or(common.pulley).as_ref())
            .map(|p| pulley(p).map_err(|e| e.under("pulley")))
            .transpose()?,
        stiffness: match spec.stiffness.or(common.stiffness) {
            None => f64::INFINITY,
            Some(stiffness) => body::positive("stiffness", stiffness)?,
        },
        drum: spec.drum.or(common.drum).as_ref().map(|d| drum(d).map_err(|e| e.under("drum"))).transpose()?,
    })
}

fn pulley(spec: &PulleySpec) -> Result<Pulley, Error> {
    let radius = body::positive("radius", spec.radius)?;
    body::coordinates("axis", &spec.axis)?;
    body::coordinates("radius", &[radius])?;
    let axis = Vector::from(spec.axis).try_normalize(PARALLEL).ok_or_else(|| {
        Error::invalid("axis", format!("found {:?}, expected the direction in which the cable arrives", spec.axis))
    })?;
    Ok(Pulley { radius, axis })
}

fn drum(spec: &DrumSpec) -> Result<Drum, Error> {
    let (gear, zero) = (spec.gear.unwrap_or(1.0), spec.zero.unwrap_or(0.0));
    let lead = body::not_negative("lead", spec.lead.unwrap_or(0.0))?;
    for (key, length) in [("radius", spec.radius), ("zero", zero), ("lead", lead)] {
        body::coordinates(key, &[length])?;
    }
    if !(spec.radius >= LEAST_BODY) {
        return Err(Error::invalid("radius", format!("found {} m, expected at least {LEAST_BODY:e} m", spec.radius)));
    }
    if !(MOST_GEAR.recip()..=MOST_GEAR).contains(&gear.abs()) {
        let problem = format!("found {gear}, expected turns of the motor for one of the drum, at most {MOST_GEAR:e}");
        return Err(Error::invalid("gear", format!("{problem}, and not 0")));
    }
    Ok(Drum { radius: spec.radius, gear, zero, lead })
}

fn unique_names(cables: &[Cable]) -> Result<(), Error> {
    for (k, cable) in cables.iter().enumerate() {
        if let Some(first) = cables[..k].iter().position(|c| c.name == cable.name) {
            let problem = format!(
                "found \"{}\", which is already the name of cables[{first}]; expected unique names",
                cable.name
            );
            return Err(Error::invalid(format!("cables[{k}].name"), problem));
        }
        if cable.name == PLATFORM {
            return Err(Error::invalid(
                format!("cables[{k}].name"),
                "found \"platform\", which is reserved for the platform itself",
            ));
        }
    }
    Ok(())
}

fn attachments_outside(cables: &[Cable], parts: &[Polytope], seams: &[Seam]) -> Result<(), Error> {
    for (i, cable) in cables.iter().enumerate() {
        let depths = parts.iter().chain(seams.iter().map(|s| &s.body)).map(|part| part.depth_of(&cable.attachment));
        if let Some((k, depth)) = depths.enumerate().find(|(_, depth)| *depth > ON_SURFACE) {
            let place = if k < parts.len() { format!("platform[{k}]") } else { "several abutting parts".to_string() };
            let problem = format!(
                "found a point {} inside {place}, expected one on the surface or outside; move it to the surface",
                small_length(depth)
            );
            return Err(Error::invalid(format!("cables[{i}].attachment"), problem));
        }
    }
    Ok(())
}
