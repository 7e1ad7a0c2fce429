//! The part of a certificate that both kinds share: scene, orientation, ends, margin and box.

use cdpr_core::Scene;
use cdpr_core::certificate::{Bounds, Region};
use cdpr_core::error::Error;
use cdpr_core::geometry::wxyz;

use crate::exact::exact;
use crate::forbidden::{Bodies, ROUNDING};
use crate::polyhedron::{HalfSpace, Place};

/// Largest number of a certificate.
const MOST: f64 = 1e12;
const AXES: [&str; 3] = ["x", "y", "z"];

/// Scene, orientation, ends, margin and box of a certificate.
pub struct Question<'c> {
    /// The scene's fingerprint.
    pub scene: &'c str,
    /// A unit quaternion w x y z.
    pub orientation: &'c [f64; 4],
    /// How close to forbidden positions a path may come, m.
    pub margin: f64,
    /// Start and goal, m.
    pub ends: [&'c [f64; 3]; 2],
    /// The box of positions, m.
    pub bounds: &'c Bounds,
}

/// Fails if numbers are not finite, or huge.
pub fn finite(place: &str, numbers: &[f64]) -> Result<(), Error> {
    match numbers.iter().find(|x| !(x.abs() <= MOST)) {
        Some(x) => Err(Error::invalid(place, format!("found {x}, expected finite numbers up to {MOST:e}"))),
        None => Ok(()),
    }
}

/// Fails if a box has no volume.
pub fn positive(place: &str, bounds: &Bounds) -> Result<(), Error> {
    finite(place, bounds.as_flattened())?;
    match (0..3).find(|k| !(bounds[0][*k] < bounds[1][*k])) {
        Some(k) => Err(Error::invalid(
            place,
            format!(
                "found a box from {} to {} along {}, expected a positive size",
                bounds[0][k], bounds[1][k], AXES[k]
            ),
        )),
        None => Ok(()),
    }
}

/// Fails if regions have numbers that are not finite, or huge.
pub fn regions_are_finite(regions: &[Region]) -> Result<(), Error> {
    let mut all = regions.iter().enumerate();
    all.try_for_each(|(k, region)| finite(&format!("regions[{k}].half_spaces"), region.half_spaces.as_flattened()))
}

impl Question<'_> {
    /// Fails if numbers are out of range.
    pub fn numbers_are_sound(&self) -> Result<(), Error> {
        if !(1e-8..=1e-6).contains(&self.margin) {
            return Err(Error::invalid("margin", format!("found {}, expected 1e-8 to 1e-6 m", self.margin)));
        }
        finite("orientation", self.orientation)?;
        finite("start", self.ends[0])?;
        finite("goal", self.ends[1])?;
        positive("box", self.bounds)
    }

    /// Checks that orientation, scene, query and the box of positions are those of a scene.
    pub fn is_of(&self, scene: &Scene) -> Result<(), Error> {
        let turn = scene.orientation();
        let own = wxyz(turn);
        let same = |sign: f64| own.iter().zip(self.orientation).all(|(a, b)| (a - sign * b).abs() <= 1e-9);
        if !same(1.0) && !same(-1.0) {
            let problem = format!("found {:?}, but the scene is at {own:?}; expected the same", self.orientation);
            return Err(Error::invalid("orientation", problem));
        }
        let fingerprint = scene.fingerprint();
        if self.scene != fingerprint {
            let problem = format!("found a proof for another scene, {}, expected one for {fingerprint}", self.scene);
            return Err(Error::invalid("scene", problem));
        }
        let turns = scene.turning().is_some() || !scene.end_orientations().iter().all(|end| scene.has_orientation(end));
        if turns {
            let problem = "found a scene whose platform may turn; a proof holds for one orientation only";
            return Err(Error::invalid("scene", problem));
        }
        for (place, found, asked) in [("start", self.ends[0], scene.start()), ("goal", self.ends[1], scene.goal())] {
            if let Some(asked) = asked.map(|p| -> [f64; 3] { p.coords.into() }).filter(|asked| asked != found) {
                let problem =
                    format!("found a proof for another question, from or to {found:?}; the scene asks {asked:?}");
                return Err(Error::invalid(place, problem));
            }
        }
        let bodies = Bodies::of(scene);
        let platform = || bodies.platform.iter().flatten();
        for k in 0..3 {
            let reach = |pick: fn(f64, f64) -> f64, from: f64| exact(platform().map(|v| v[k]).fold(from, pick));
            let low = exact(scene.workspace().min[k]) - reach(f64::min, f64::INFINITY);
            let high = exact(scene.workspace().max[k]) - reach(f64::max, f64::NEG_INFINITY);
            let [from, to] = [0, 1].map(|side| exact(self.bounds[side][k]));
            if from > &low + exact(ROUNDING) || to < &high - exact(ROUNDING) {
                let (from, to, low, high) = (from.to_f64(), to.to_f64(), low.to_f64(), high.to_f64());
                let problem = format!("found {from} to {to} along {}, expected at least {low} to {high}", AXES[k]);
                return Err(Error::invalid("box", problem));
            }
        }
        Ok(())
    }

    fn named_ends(&self) -> [(&str, &[f64; 3]); 2] {
        [("start", self.ends[0]), ("goal", self.ends[1])]
    }

    /// Checks that start and goal are in the box: about paths between other positions, any claim is true.
    pub fn ends_are_in_box(&self) -> Result<(), Error> {
        for (name, end) in self.named_ends() {
            if let Some(k) = (0..3).find(|k| !(self.bounds[0][*k] <= end[*k] && end[*k] <= self.bounds[1][*k])) {
                let (from, to) = (self.bounds[0][k], self.bounds[1][k]);
                let problem = format!("found {} along {}, expected it in the box, {from} to {to}", end[k], AXES[k]);
                return Err(Error::invalid(name, problem));
            }
        }
        Ok(())
    }

    /// Checks that start and goal are in no region: about paths between other positions, any claim is true.
    pub fn ends_are_outside(&self, regions: &[Region]) -> Result<(), Error> {
        for (name, end) in self.named_ends() {
            let place = Place::of(&(*end).into());
            let inside = |row: &[f64; 4]| HalfSpace::of(row).height(&place) < exact(-ROUNDING);
            if let Some(k) = regions.iter().position(|region| region.half_spaces.iter().all(inside)) {
                return Err(Error::invalid(name, format!("found it inside regions[{k}], expected it in no region")));
            }
        }
        Ok(())
    }
}
