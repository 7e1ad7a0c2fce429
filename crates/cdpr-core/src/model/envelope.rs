//! All shapes that a real cable can take: it leaves the frame near its outlet rather than exactly there, and hangs below the
//! straight line to its attachment.
//!
//! # Sag
//!
//! A cable of weight w per length that pulls with the tension T in its middle hangs below its chord by w a b / (2 T), measured
//! along gravity, where a and b are the distances along the chord from both ends. That is the parabola of a taut cable (Irvine
//! 1981). The catenary hangs lower, by a factor of at most 1 + q/4 for q = w L / T up to [`MOST_SLACKNESS`] and slopes up to 85°
//! (`tests/oracles/cable_shapes.rs` integrates catenaries). The tension at the platform is kept at or above `sag_tension`. Along a
//! hanging cable it grows by w times the height, so that in the middle it is larger by w/2 times the height of the outlet over
//! the attachment, or smaller if the outlet is lower.
//!
//! Lengths and heights are those of the whole workspace: every corner of the platform stays in it, so an attachment is never
//! farther outside than it is from the platform. The bounds hold at all positions and orientations.

use std::sync::Arc;

use crate::error::Error;
use crate::geometry::gjk::shape_distance;
use crate::geometry::{Aabb, Point, Polytope, Triangle, Vector, largest_distance};
use crate::limits::MOST_SLACKNESS;
use crate::tolerances::{PARALLEL, THICKENED};
use crate::words::small_length;

use super::robot::{Cable, Robot};

/// All shapes that a cable can take, in place of the straight line from its outlet.
#[derive(Debug, Clone, PartialEq)]
pub struct Envelope {
    /// Points whose hull contains those where the cable can leave the frame, world.
    pub exits: Arc<[Point]>,
    /// The mean of these points.
    pub middle: Point,
    /// The exits that are corners of the hull of all exits and the same moved along gravity: as they are, and moved.
    kept: [Vec<Point>; 2],
    /// How it hangs, if it has weight.
    pub sag: Option<Sag>,
    /// Convex set of points: each shape of the cable lies in the hull of this set and its attachment.
    pub lowered_exits: Arc<Polytope>,
    /// Greatest distance of a point where the cable can leave the frame from its outlet, m.
    pub exit_error: f64,
    /// A box that contains all chords, world.
    pub chords: Aabb,
}

/// Bounds on how far a cable hangs below its chord.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sag {
    /// Unit vector against gravity, world.
    pub up: Vector,
    /// Weight per length, N/m.
    pub weight: f64,
    /// Least tension in the middle of the cable, N.
    pub tension: f64,
    /// Greatest length of the chord, m.
    pub longest: f64,
}

impl Sag {
    /// The weight of the longest cable as a share of its tension.
    pub fn slackness(&self) -> f64 {
        self.weight * self.longest / self.tension
    }

    /// w / (2 T), enlarged from parabola to catenary, 1/m.
    fn curvature(&self) -> f64 {
        0.5 * self.weight / self.tension * (1.0 + 0.25 * self.slackness())
    }

    /// Greatest sag of any point of the cable, m.
    pub fn deepest(&self) -> f64 {
        self.deepest_of(self.longest)
    }

    /// Greatest sag of any point of the cable where its chord is no longer than this, m.
    pub fn deepest_of(&self, chord: f64) -> f64 {
        let chord = chord.min(self.longest);
        self.curvature() * 0.25 * chord * chord
    }

    /// Greatest sag of points whose distance along a chord of at most this length from where the cable leaves the frame is in this
    /// interval, m.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::Vector;
    /// use cdpr_core::model::Sag;
    /// let sag = Sag { up: Vector::z(), weight: 1.0, tension: 100.0, longest: 10.0 };
    /// assert!((sag.deepest() - 0.125 * 1.025).abs() < 1e-12); // w L² / (8 T), and q/4 = 0.025
    /// assert_eq!(sag.between(10.0, [0.0, 10.0]), sag.deepest());
    /// assert!((sag.between(10.0, [0.0, 1.0]) - 0.045 * 1.025).abs() < 1e-12); // near an end there is little: w 1 9 / (2 T)
    /// ```
    pub fn between(&self, chord: f64, [near, far]: [f64; 2]) -> f64 {
        let chord = chord.min(self.longest);
        let at = (0.5 * chord).clamp(near.max(0.0), far.max(near.max(0.0))).min(chord);
        self.curvature() * at * (chord - at)
    }

    /// How much lower one end must count for the line from there to the other end to be below the cable up to this distance
    /// along the chord, m: lowered by κ r L, the line at the distance a is lower than the chord by κ r L b / (a + b), at least κ a b.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::Vector;
    /// use cdpr_core::model::Sag;
    /// let sag = Sag { up: Vector::z(), weight: 1.0, tension: 100.0, longest: 10.0 };
    /// let at = |a: f64, length: f64| sag.lowering(2.0) * (length - a) / length; // below a chord of this length
    /// assert!(at(2.0, 10.0) >= sag.between(10.0, [2.0, 2.0]) - 1e-12);
    /// assert!(at(2.0, 5.0) > 0.005 * 1.025 * 2.0 * 3.0); // w a b / (2 T)
    /// ```
    pub fn lowering(&self, reach: f64) -> f64 {
        self.curvature() * reach.clamp(0.0, self.longest) * self.longest
    }
}

impl Envelope {
    /// Greatest sag anywhere, m.
    pub fn deepest(&self) -> f64 {
        self.sag.map_or(0.0, |sag| sag.deepest())
    }

    /// Corners of the hull of the exits and of those lowered by `fall` metres along gravity.
    pub fn exits_lowered(&self, fall: f64) -> Arc<[Point]> {
        let down = self.sag.map_or(Vector::zeros(), |sag| -sag.up * fall);
        let [still, moved] = &self.kept;
        still.iter().copied().chain(moved.iter().map(|exit| exit + down)).collect()
    }
}

/// The envelopes of the cables of a robot; `None` for cables that are straight lines from their outlets.
///
/// # Errors
/// A cable that has weight but no positive least tension, or hangs so deep that it is not nearly straight.
pub(super) fn envelopes(robot: &Robot, workspace: &Aabb, gravity: &Vector) -> Result<Vec<Option<Envelope>>, Error> {
    let of =
        |(k, cable)| envelope(cable, robot, workspace, gravity).map_err(|e| e.under(&format!("robot.cables[{k}]")));
    robot.cables().iter().enumerate().map(of).collect()
}

fn envelope(cable: &Cable, robot: &Robot, workspace: &Aabb, gravity: &Vector) -> Result<Option<Envelope>, Error> {
    let weight = cable.linear_density * gravity.norm();
    if weight == 0.0 && cable.outlet_error == 0.0 && cable.pulley.is_none() {
        return Ok(None);
    }
    let attachments = attachments(cable, robot, workspace);
    let of = |exits: Polytope, lowered_exits: Option<Polytope>, sag: Option<Sag>| {
        let exit_error = largest_distance(exits.vertices(), &cable.outlet);
        let chords = attachments.around_both(exits.aabb());
        let kept = swept_corners(&exits, &-gravity);
        let (corners, middle) = (exits.vertices().into(), exits.centroid());
        let lowered_exits = Arc::new(lowered_exits.unwrap_or(exits));
        Some(Envelope { exits: corners, middle, kept, sag, lowered_exits, exit_error, chords })
    };
    if weight == 0.0 {
        return Ok(of(exits(cable, &attachments)?, None, None));
    }
    // Where the cable leaves its pulley depends on the sag, and the greatest length on where it leaves. At its exit, the cable runs
    // in the direction of a taut one to a point below the attachment, no lower than the line from there to the other end.
    let up = -gravity.normalize();
    let aimed_at = |fall: f64| attachments.swept(&Vector::zeros(), &(-up * fall));
    let reach = attachments.farthest(&Aabb::around(&[cable.outlet])) + cable.outlet_error;
    let reach = reach + cable.pulley.map_or(0.0, |pulley| 2.0 * pulley.radius);
    let slackest = Sag { up, weight: MOST_SLACKNESS, tension: reach, longest: reach };
    let widest = exits(cable, &aimed_at(slackest.lowering(reach)))?;
    let sag = sag(cable, weight, &widest, &attachments, &up)?;
    let exits = if cable.pulley.is_some() { exits(cable, &aimed_at(sag.lowering(sag.longest)))? } else { widest };
    let lowered_exits = lowered(&exits, &(sag.up * sag.lowering(sag.longest)))?;
    Ok(of(exits, Some(lowered_exits), Some(sag)))
}

/// The hull of points and the same points moved by `-by`.
fn lowered(points: &Polytope, by: &Vector) -> Result<Polytope, Error> {
    hull(&points.vertices().iter().flat_map(|point| [*point, point - by]).collect::<Vec<_>>())
}

/// The corners of a body that are corners of what it sweeps while it moves against `up`: before it moves, and after. A corner
/// is one before if some direction in which it is the farthest point of the body has a part of `up`.
fn swept_corners(body: &Polytope, up: &Vector) -> [Vec<Point>; 2] {
    let corners = |along: Vector| {
        let faces: Vec<bool> = body.facets().iter().map(|f| f.normal.dot(&along) > -PARALLEL * up.norm()).collect();
        let is_one = |k: usize| body.facets().iter().zip(&faces).any(|(f, faces)| *faces && f.corners.contains(&k));
        let all = body.vertices().iter().enumerate();
        all.filter(|(k, _)| !body.has_volume() || is_one(*k)).map(|(_, corner)| *corner).collect()
    };
    [corners(*up), corners(-up)]
}

/// Convex set of the points where a cable can leave the frame, taut, to attachments in a box. From an outlet that is not known
/// exactly, the attachments are elsewhere by the same error.
fn exits(cable: &Cable, attachments: &Aabb) -> Result<Polytope, Error> {
    let error = cable.outlet_error;
    let exact = match &cable.pulley {
        None => vec![cable.outlet],
        Some(pulley) => pulley.exits(&cable.outlet, &attachments.widened(error)).ok_or_else(|| {
            let problem = "found one that the cable cannot leave towards any point of the workspace, expected an `axis` along which \
                           the cable arrives at the outlet, with the wheel on the side of the platform";
            Error::invalid("pulley", problem)
        })?,
    };
    let known = hull(&exact)?;
    if error == 0.0 {
        return Ok(known);
    }
    let cube = Polytope::cuboid([2.0 * error; 3]).expect("finite sides");
    let moved = exact.iter().flat_map(|exit| cube.vertices().iter().map(move |corner| exit + corner.coords));
    known.sum(&cube).or_else(|_| hull(&moved.collect::<Vec<_>>()))
}

/// The hull of points or, if they are too close to degenerate for one, of a tiny cube around each, or a box around all.
fn hull(points: &[Point]) -> Result<Polytope, Error> {
    let thick = |_| {
        let corner = |k: usize| Vector::from_fn(|axis, _| if k >> axis & 1 == 1 { THICKENED } else { -THICKENED });
        Polytope::hull_of(&points.iter().flat_map(|p| (0..8).map(move |k| p + corner(k))).collect::<Vec<_>>())
    };
    let around = |_| {
        let Aabb { min, max } = Aabb::around(points);
        let sides = max - min + Vector::repeat(2.0 * THICKENED);
        let moved = |cuboid: Polytope| cuboid.transformed(&Default::default(), &nalgebra::center(&min, &max).coords);
        Polytope::cuboid(sides.into()).map(moved)
    };
    Polytope::hull_of(points).or_else(thick).or_else(around).map_err(|e| Error::invalid("pulley", e.to_string()))
}

/// A box that contains the attachment of a cable at every pose with the platform in the workspace.
fn attachments(cable: &Cable, robot: &Robot, workspace: &Aabb) -> Aabb {
    let attachment = Triangle::new(cable.attachment, cable.attachment, cable.attachment);
    let outside =
        robot.parts().iter().map(|part| shape_distance(&attachment, part).distance).fold(f64::INFINITY, f64::min);
    let beyond = Vector::repeat(outside);
    Aabb { min: workspace.min - beyond, max: workspace.max + beyond }
}

fn sag(cable: &Cable, weight: f64, exits: &Polytope, attachments: &Aabb, up: &Vector) -> Result<Sag, Error> {
    let Some(kept) = cable.sag_tension else {
        let problem = "found a cable with weight and without tension, expected `sag_tension`, or a minimum `tension`: they limit \
                       the sag";
        return Err(Error::invalid("linear_density", problem));
    };
    if kept == 0.0 {
        let problem = "found a cable with weight and a minimum tension of 0 N, at which it hangs loose; expected a positive \
                       minimum `tension`, or the `sag_tension` that the controller keeps";
        return Err(Error::invalid("linear_density", problem));
    }
    let corner = |k: usize| {
        let side = |axis: usize| if k >> axis & 1 == 1 { attachments.max[axis] } else { attachments.min[axis] };
        Point::new(side(0), side(1), side(2))
    };
    let corners: [Point; 8] = std::array::from_fn(corner);
    let lengths = exits.vertices().iter().flat_map(|exit| corners.iter().map(move |corner| (corner - exit).norm()));
    let longest = lengths.fold(0.0, f64::max);
    let height = |p: &Point| up.dot(&p.coords);
    let lowest_exit = exits.vertices().iter().map(height).fold(f64::INFINITY, f64::min);
    let highest = corners.iter().map(height).fold(f64::NEG_INFINITY, f64::max);
    let tension = kept + 0.5 * weight * (lowest_exit - highest);
    let sag = Sag { up: *up, weight, tension, longest };
    if tension > 0.0 && sag.slackness() <= MOST_SLACKNESS {
        return Ok(sag);
    }
    let needed = weight * longest / MOST_SLACKNESS - (tension - kept);
    let problem = format!(
        "found {:.3} N of weight on {} at a tension of {kept} N, expected at most {MOST_SLACKNESS} of the tension in the middle, \
         since the cable is not nearly straight; expected a tension of at least {needed:.0} N (`sag_tension`, or the minimum \
         `tension`), a lighter cable, or a smaller workspace",
        weight * longest,
        small_length(longest)
    );
    Err(Error::invalid("linear_density", problem))
}
