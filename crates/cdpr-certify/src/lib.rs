//! Checks certificates that a cable robot has no path, or that every path has at least a certain length ([`check_bound`]). The
//! checker shares with the program that writes certificates only the scene and the definition of the file: it derives from the scene what is forbidden, and decides
//! everything in exact arithmetic, except that lengths of bent paths are compared in double precision, with tolerances far above
//! the rounding errors.
//!
//! # What a certificate that there is no path proves
//!
//! Every path from start to goal (a continuous curve of the platform's origin, at one orientation, in the scene's box
//! of positions) contains a position where some gap is at most `margin` larger than the scene requires, or where the
//! cables lack a required wrench. Pairs whose gap is that small at both start and goal count only where they break the
//! condition: what the platform touches at both ends it may touch on the way.
//!
//! # Why
//!
//! A certificate lists boxes, open and closed. [`Certificate::check`] proves:
//!
//! 1. The boxes tile the box of positions (`tiling`), which is the scene's up to rounding errors on each side. What it lacks
//!    is taken from the margin.
//! 2. No chain of open boxes, each touching the next, leads from the start to the goal (`tiling`). So on every path
//!    there is a position that lies in no open box of the start's chain, but arbitrarily close to that chain, and thus
//!    in a closed box.
//! 3. Each closed box lies in a region, or is closed by a bound.
//! 4. Each region, cut to the box of positions, is the convex hull of its corners (`polyhedron`). All of its corners
//!    have too small a gap between one pair of convex bodies, and hence the whole region has (`forbidden`).
//! 5. A bound holds in the whole box: by convexity again, for a pair of cables by an affine function of the position,
//!    for tensions by the largest angle that a cable turns (`wrench`).
//!
//! In regions of certificates of bounds, wrenches may lack, which boxes with directions show (`weak`).
//!
//! All of this is decided by integers of any size (`exact`): the numbers of the file, of the scene, and of the bodies
//! at the certificate's orientation are taken as exactly what they are in double precision. Floating point only
//! guesses, such as where two bodies are nearest (`nearest`); a wrong guess can only refuse a certificate. Some
//! choices are made in floating point, as in the definition of the scene: whether a cable's end lies on a body (within
//! 1e-7 m), which clearance is attainable at all, and how far a cable hangs down at most (`hanging`), rounded down by 1e-12 of it
//! and 1e-12 m.

mod bends;
mod bound;
mod bound_certificate;
mod certificate;
mod cone;
mod exact;
mod forbidden;
mod hanging;
mod labels;
mod nearest;
mod origins;
mod polyhedron;
mod question;
mod tiling;
mod weak;
mod wrench;

use std::collections::BTreeMap;

use cdpr_core::Scene;
use cdpr_core::certificate::{Bounds, WRENCH};
use cdpr_core::error::Error;
use cdpr_core::model::Member;
use cdpr_core::watch::Watch;

pub use bound::{BoundSummary, check_bound};
pub use bound_certificate::is_bound;
pub use cdpr_core::certificate::{BoundCertificate, Cell, Certificate, EdgeRow, Region, Status};

use exact::{Exact, exact, exact3};
use forbidden::{Bodies, ForbiddenSet};
use polyhedron::{HalfSpace, Place, box_corners, corners};
use question::{Question, finite, positive, regions_are_finite};
use tiling::{Tiling, middle, point, touch};

/// The size of a certificate that was accepted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Summary {
    /// The number of boxes.
    pub boxes: usize,
    /// The number of closed boxes.
    pub closed: usize,
    /// The number of regions.
    pub regions: usize,
    /// Every path comes at least this close to forbidden positions, m.
    pub margin: f64,
}

/// Checks the text of a certificate for a scene at its orientation.
///
/// # Errors
/// A defect of the certificate, and where it is: the certificate then proves nothing; [`Error::interrupted`],
/// [`Error::out_of_time`].
///
/// # Example
/// ```
/// use cdpr_core::Watch;
/// let scene = cdpr_core::testing::empty();
/// let error = cdpr_certify::check_certificate(&scene, "{", &Watch::NONE).unwrap_err();
/// assert!(error.to_string().starts_with("found no certificate: EOF"));
/// ```
pub fn check_certificate(scene: &Scene, text: &str, watch: &Watch) -> Result<Summary, Error> {
    Certificate::parse(text)?.check(scene, watch)
}

/// A certificate that can be read and checked.
pub trait Check: Sized {
    /// The size of what was accepted.
    type Summary;

    /// Reads a certificate, without checking what it says.
    ///
    /// # Errors
    /// Text that is not a certificate of this version, or a longer one than this program checks.
    ///
    /// # Example
    /// ```
    /// use cdpr_certify::{Certificate, Check};
    /// let error = Certificate::parse(r#"{"format": "cdpr-proof", "version": 2}"#).unwrap_err();
    /// assert_eq!(error.to_string(), "version: found 2, expected 1");
    /// ```
    fn parse(text: &str) -> Result<Self, Error>;

    /// Checks the certificate for a scene at the certificate's orientation.
    ///
    /// # Errors
    /// What is wrong with the certificate, and where: then it proves nothing; [`Error::interrupted`], [`Error::out_of_time`].
    fn check(&self, scene: &Scene, watch: &Watch) -> Result<Self::Summary, Error>;
}

impl Check for Certificate {
    type Summary = Summary;

    fn parse(text: &str) -> Result<Self, Error> {
        certificate::parsed(text, Certificate::FORMAT)
    }

    fn check(&self, scene: &Scene, watch: &Watch) -> Result<Summary, Error> {
        numbers_are_sound(self)?;
        question(self).is_of(scene)?;
        let boxes: Vec<Bounds> = self.boxes.iter().map(|cell| cell.bounds).collect();
        separates(self, &boxes)?;
        boxes_lie_in_their_regions(self)?;
        let ends = [&self.start, &self.goal];
        let mut proofs = Proofs::of(scene, ends, self.margin, None);
        for (k, region) in self.regions.iter().enumerate() {
            watch.check()?;
            proofs.region(region, &self.bounds, watch).map_err(|e| e.under(&format!("regions[{k}]")))?;
        }
        for (k, cell) in self.boxes.iter().enumerate() {
            watch.check()?;
            proofs.bound(cell).map_err(|e| e.under(&format!("boxes[{k}]")))?;
        }
        for (end, place) in [(0, "start"), (1, "goal")] {
            if proofs.is_touched_only_at(end) {
                is_open_around(self, place, [&self.start, &self.goal][end])?;
            }
        }
        let closed = self.boxes.iter().filter(|cell| cell.status != Status::Open).count();
        Ok(Summary { boxes: boxes.len(), closed, regions: self.regions.len(), margin: self.margin })
    }
}

/// What it is about.
fn question(certificate: &Certificate) -> Question<'_> {
    Question {
        scene: &certificate.scene,
        orientation: &certificate.orientation,
        margin: certificate.margin,
        ends: [&certificate.start, &certificate.goal],
        bounds: &certificate.bounds,
    }
}

fn numbers_are_sound(certificate: &Certificate) -> Result<(), Error> {
    question(certificate).numbers_are_sound()?;
    regions_are_finite(&certificate.regions)?;
    for (k, cell) in certificate.boxes.iter().enumerate() {
        positive(&format!("boxes[{k}]"), &cell.bounds)?;
        if let Status::TooWeak(direction) = &cell.status {
            finite(&format!("boxes[{k}]"), direction)?;
        }
    }
    Ok(())
}

/// No closed box is near an end.
fn is_open_around(certificate: &Certificate, place: &str, end: &[f64; 3]) -> Result<(), Error> {
    let around = [end.map(|x| x - NEAR_END), end.map(|x| x + NEAR_END)];
    let near = |cell: &Cell| (0..3).all(|k| cell.bounds[0][k] < around[1][k] && around[0][k] < cell.bounds[1][k]);
    match certificate.boxes.iter().position(|cell| cell.status != Status::Open && near(cell)) {
        None => Ok(()),
        Some(k) => {
            let problem = format!("found contact there, and boxes[{k}] closed beside it, expected it open for 1 mm");
            Err(Error::invalid(place, problem))
        }
    }
}

/// The boxes tile the box of positions, and open ones do not lead from the start to the goal.
fn separates(certificate: &Certificate, boxes: &[Bounds]) -> Result<(), Error> {
    let open = |k: usize| certificate.boxes[k].status == Status::Open;
    let holds = |k: &usize, p: &[f64; 3]| touch(&boxes[*k], &point(p));
    let tiling = Tiling::of(&certificate.bounds, boxes)?;
    for (place, p) in [("start", &certificate.start), ("goal", &certificate.goal)] {
        if !(0..boxes.len()).any(|k| open(k) && holds(&k, p)) {
            return Err(Error::invalid(place, format!("found {p:?} in no open box, expected it in at least one")));
        }
    }
    match tiling.connected(&certificate.start, open).into_iter().find(|k| holds(k, &certificate.goal)) {
        None => Ok(()),
        Some(k) => {
            let problem = "found a chain of open boxes from the start to this box, which contains the goal; \
                           expected closed boxes between them";
            Err(Error::invalid(format!("boxes[{k}]"), problem))
        }
    }
}

fn boxes_lie_in_their_regions(certificate: &Certificate) -> Result<(), Error> {
    let half_spaces: Vec<Vec<HalfSpace>> =
        certificate.regions.iter().map(|region| region.half_spaces.iter().map(HalfSpace::of).collect()).collect();
    for (k, cell) in certificate.boxes.iter().enumerate() {
        let Status::Within(region) = cell.status else { continue };
        let problem = match half_spaces.get(region) {
            None => format!("found region {region}, expected one of the {} regions", certificate.regions.len()),
            Some(half_spaces) => {
                let bounds = cell.bounds.map(|corner| exact3(&corner.into()));
                match half_spaces.iter().position(|half| !half.contains(&bounds)) {
                    None => continue,
                    Some(h) => {
                        format!("found a corner beyond half-space {h} of region {region}, expected the box inside")
                    }
                }
            }
        };
        return Err(Error::invalid(format!("boxes[{k}]"), problem));
    }
    Ok(())
}
/// Nothing this near to an end (along each axis) is closed if that end touches something that the other does not, m.
const NEAR_END: f64 = 0.999e-3;

/// Proofs that positions are forbidden.
struct Proofs<'a> {
    scene: &'a Scene,
    bodies: Bodies<'a>,
    ends: [Place; 2],
    /// Gap beyond the required one up to which an end counts as touching, m.
    touch: Exact,
    /// Maximum distance of closed positions from forbidden ones, m: less than the margin, so that positions beyond the
    /// sides of the box, which may lack [`forbidden::ROUNDING`] along each axis, are within it too.
    margin: Exact,
    /// The sets that each pair forbids, for the pairs examined so far.
    known: BTreeMap<[Member; 2], Vec<ForbiddenSet>>,
    /// Whether contact at one end is enough for contact to be allowed everywhere.
    at_one_end: bool,
    /// The positions of the paths that count, if they are not all.
    reachable: Option<weak::Reachable<'a>>,
    /// For each cable whose length is a reason, whether it is at a limit of its length at the start and at the goal.
    at_limit: Vec<[bool; 2]>,
}

impl<'a> Proofs<'a> {
    /// With a length, the proofs are about paths that are shorter.
    fn of(scene: &'a Scene, ends: [&'a [f64; 3]; 2], margin: f64, length: Option<f64>) -> Self {
        Proofs {
            reachable: length.map(|length| weak::Reachable { ends, length }),
            at_one_end: length.is_some(),
            bodies: Bodies::of(scene),
            scene,
            ends: ends.map(|end| Place::of(&(*end).into())),
            touch: exact(margin),
            margin: exact(margin) - exact(2.0 * forbidden::ROUNDING),
            known: BTreeMap::new(),
            at_limit: Vec::new(),
        }
    }

    /// Checks that all corners of a region are near one forbidden set, or that wrenches lack in its boxes.
    fn region(&mut self, region: &Region, bounds: &Bounds, watch: &Watch) -> Result<(), Error> {
        let corners = corners(bounds, &region.half_spaces);
        if corners.is_empty() {
            return Err(Error::invalid("half_spaces", "found no position of the box in them, expected some"));
        }
        match (&region.who[..], &self.reachable) {
            ([first, second], _) if region.boxes.is_empty() => {
                let pair = self.pair([first, second])?;
                if let [Member::Cable(_), Member::Cable(_)] = pair {
                    let problem = "found two cables, expected a pair with a body: cables forbid no region";
                    return Err(Error::invalid("who", problem));
                }
                self.all_near(pair, &corners)
            }
            ([only], Some(reachable)) if only == WRENCH => {
                weak::all_lack(self.scene, &self.bodies, (region, &corners), reachable, watch)
            }
            ([only], None) if only == WRENCH => {
                Err(Error::invalid("who", "found \"wrench\", expected a pair; boxes have it as a reason"))
            }
            _ => {
                let problem = "found other names, or boxes for them; expected two names, or \"wrench\" and boxes";
                Err(Error::invalid("who", problem))
            }
        }
    }

    /// Checks that all positions of a box are forbidden for its reason.
    fn bound(&mut self, cell: &Cell) -> Result<(), Error> {
        let contact = exact(-forbidden::TOUCHING);
        let places: Vec<Place> = box_corners(&cell.bounds).iter().map(Place::of).collect();
        let names = match &cell.status {
            Status::Open | Status::Within(_) => return Ok(()),
            Status::TooWeak(direction) => {
                let proved = wrench::too_weak(self.scene, &self.bodies, direction, &cell.bounds)?;
                return expect(proved, || "found no proof that the cables are too weak in this direction".to_string());
            }
            Status::Broken(names) => names,
        };
        if let [name] = &names[..] {
            let Member::Cable(i) = self.bodies.member(name)? else {
                return Err(Error::invalid(
                    "",
                    format!("found \"{name}\" alone, expected a cable because of its length"),
                ));
            };
            let cable = &self.scene.robot().cables()[i];
            let arm = &self.bodies.arms[i];
            let at_limit =
                self.ends.each_ref().map(|end| wrench::may_be_at_limit(cable, arm, &end.to_f64().into(), &self.touch));
            let margin = if at_limit == [true; 2] { &contact } else { &self.margin };
            let proved = wrench::wrong_length(cable, arm, &cell.bounds, margin);
            self.at_limit.push(at_limit);
            return expect(proved, || format!("found no proof that {name} is too short or too long"));
        }
        let [first, second] = &names[..] else {
            return Err(Error::invalid("", "found no names, expected one or two"));
        };
        let pair = self.pair([first, second])?;
        let [Member::Cable(_), Member::Cable(_)] = pair else { return self.all_near(pair, &places) };
        self.know(pair)?;
        let near = |set: &ForbiddenSet| {
            let (weights, margin) = (set.nearest_at(&middle(&cell.bounds)), self.margin_for(set));
            places.iter().all(|place| set.is_near_at(&weights, place, &margin))
        };
        expect(self.known[&pair].iter().any(near), || {
            format!("found no proof that {} and {} are too close", names[0], names[1])
        })
    }

    fn all_near(&mut self, pair: [Member; 2], places: &[Place]) -> Result<(), Error> {
        let names = pair.map(|member| self.scene.member_name(member).to_string());
        self.know(pair)?;
        let far = |set: &ForbiddenSet| {
            let margin = self.margin_for(set);
            places.iter().find(|place| !set.is_near(place, &margin))
        };
        let mut missed = None;
        for set in &self.known[&pair] {
            match far(set) {
                None => return Ok(()),
                Some(place) => missed = Some(place.to_f64()),
            }
        }
        let problem = match missed {
            Some(p) => format!(
                "found the position {:?}, expected it within the margin of where {} and {} are too close",
                [p.x, p.y, p.z],
                names[0],
                names[1]
            ),
            None => format!("found {} and {}, which forbid no positions in this scene", names[0], names[1]),
        };
        Err(Error::invalid("", problem))
    }

    /// Whether an end touches something that the other end does not.
    fn is_touched_only_at(&self, end: usize) -> bool {
        let sets = self.known.values().flatten();
        let mut touched = sets.map(|set| self.ends.each_ref().map(|end| set.is_near(end, &self.touch)));
        touched.any(|at| at[end] && !at[1 - end]) || self.at_limit.iter().any(|at| at[end] && !at[1 - end])
    }

    fn pair(&self, [first, second]: [&String; 2]) -> Result<[Member; 2], Error> {
        Ok([self.bodies.member(first)?, self.bodies.member(second)?])
    }

    /// Finds the sets that a pair forbids, once.
    fn know(&mut self, pair: [Member; 2]) -> Result<(), Error> {
        if !self.known.contains_key(&pair) {
            self.known.insert(pair, self.bodies.forbidden(pair)?);
        }
        Ok(())
    }

    /// The margin by which a region may reach beyond a set.
    fn margin_for(&self, set: &ForbiddenSet) -> Exact {
        let mut near = self.ends.iter().map(|end| set.is_near(end, &self.touch));
        let touched = if self.at_one_end { near.any(|near| near) } else { near.all(|near| near) };
        if touched { set.contact() } else { self.margin.clone() }
    }
}

/// Fails unless something is proved.
fn expect(proved: bool, problem: impl Fn() -> String) -> Result<(), Error> {
    if proved { Ok(()) } else { Err(Error::invalid("", format!("{}; expected one", problem()))) }
}
