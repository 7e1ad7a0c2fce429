//! Definitions of the margins, for any robot: how far the required wrenches are from the facets of the available wrench
//! set.
//!
//! [`CapacityMargin`](crate::wrench::CapacityMargin) computes the same numbers faster where the four-position kernel applies.

use nalgebra::{SVector, Vector3, Vector6};

use crate::error::Error;
use crate::geometry::{Point, SupportMap, proximity};
use crate::model::body;
use crate::wrench::statics::{Part, Statics};
use crate::wrench::zonotope::{Span, for_each_normal};

/// The wrenches that the cables must be able to exert, around the one that balances the loads.
#[derive(Debug, Clone, PartialEq)]
pub enum Required {
    /// Any force up to `force` N together with any moment up to `moment` N·m.
    Balls {
        /// Radius of the force ball, N.
        force: f64,
        /// Radius of the moment ball, N·m.
        moment: f64,
    },
    /// The hull of these wrenches, each [force; moment] in N and N·m.
    Polytope(Vec<Vector6<f64>>),
}

impl Default for Required {
    fn default() -> Self {
        Required::Balls { force: 0.0, moment: 0.0 }
    }
}

impl Required {
    /// Balls of these radii, N and N·m.
    ///
    /// # Errors
    /// A radius that is negative or not finite.
    pub fn balls(force: f64, moment: f64) -> Result<Self, Error> {
        Ok(Required::Balls {
            force: body::not_negative("force", force)?,
            moment: body::not_negative("moment", moment)?,
        })
    }

    /// Whether a moment is required.
    pub fn needs_moment(&self) -> bool {
        match self {
            Required::Balls { moment, .. } => *moment > 0.0,
            Required::Polytope(corners) => corners.iter().any(|w| w.fixed_rows::<3>(3).norm() > 0.0),
        }
    }

    /// Support function of the required wrenches in a direction of [force; moment / length].
    fn reach(&self, direction: &Vector6<f64>, length: f64) -> f64 {
        let (force, moment) = (direction.fixed_rows::<3>(0), direction.fixed_rows::<3>(3) / length);
        match self {
            Required::Balls { force: f, moment: m } => f * force.norm() + m * moment.norm(),
            Required::Polytope(corners) => {
                let reach = |w: &Vector6<f64>| force.dot(&w.fixed_rows::<3>(0)) + moment.dot(&w.fixed_rows::<3>(3));
                corners.iter().map(reach).fold(f64::NEG_INFINITY, f64::max)
            }
        }
    }
}

/// A margin, and the direction in which it is attained.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BindingFacet<const N: usize> {
    /// Slack in the direction `normal`, N (N·m for moments); negative if a required wrench is not available.
    pub margin: f64,
    /// Outward unit normal of the nearest facet; for [`force_limit`] and [`moment_limit`] outside the set, the
    /// direction from its nearest point to the balancing force or moment.
    pub normal: SVector<f64, N>,
}

/// The facet of {Σ tᵢ gᵢ : t in the limits} nearest to the set around `center` with support function `reach(c)`.
///
/// A set of lower rank is flat: the directions orthogonal to it count as well, with nothing available in them,
/// including the one in which `center` is farthest from the set's span. A set without any facet is a point.
fn nearest_facet<const N: usize>(
    generators: &[SVector<f64, N>],
    statics: &Statics,
    center: &SVector<f64, N>,
    reach: impl Fn(&SVector<f64, N>) -> f64,
) -> BindingFacet<N> {
    let span = Span::of(generators);
    let mut nearest = BindingFacet { margin: f64::INFINITY, normal: SVector::zeros() };
    let mut consider = |margin: f64, normal: SVector<f64, N>| {
        if margin < nearest.margin {
            nearest = BindingFacet { margin, normal };
        }
    };
    let mut any = false;
    for_each_normal(generators, &span, &mut |normal| {
        any = true;
        for normal in [*normal, -normal] {
            let available = |(g, cable): (&SVector<f64, N>, &crate::wrench::StaticCable)| {
                let height = normal.dot(g);
                (cable.tension[0] * height).max(cable.tension[1] * height)
            };
            let out: f64 = generators.iter().zip(statics.cables()).map(available).sum();
            consider(out - normal.dot(center) - reach(&normal), normal);
        }
    });
    for across in span.left_null() {
        for normal in [*across, -across] {
            consider(-normal.dot(center) - reach(&normal), normal);
        }
    }
    let missed: SVector<f64, N> = span.left_null().iter().map(|n| n * n.dot(center)).sum();
    match missed.try_normalize(0.0) {
        Some(normal) => consider(-missed.norm() - reach(&normal), normal),
        None if !any => consider(0.0, SVector::zeros()),
        None => {}
    }
    nearest
}

/// Capacity margin: the smallest slack between the available wrench set and the required one, over all facets, N, with
/// the facet. For a point mass the three force rows count. `None` if a cable has no direction.
///
/// In the coordinates [f; m/ℓ], with a facet c·w ≤ h and the balancing wrench w_r, the slack is
/// h − c·w_r − r_F |c_f| − r_M |c_m| / ℓ. If it is nonnegative, all required wrenches are available.
///
/// If outlets have errors, all margins are those at the given outlets minus what the errors can change them by: if this is
/// nonnegative, it is a lower bound of the margins at the true ones.
///
/// # Source
/// Guay, Cardou, Cruz-Ruiz and Caro, "Measuring how well a structure supports varying external wrenches", New Advances
/// in Mechanisms, Transmissions and Applications, 2014, doi:10.1007/978-94-007-7485-8_47.
pub fn capacity_limit(statics: &Statics, required: &Required, position: &Point) -> Option<BindingFacet<6>> {
    let (columns, lost) = (statics.columns(position)?, statics.loss(position, Part::Whole)?);
    let length = statics.characteristic_length();
    if statics.point_mass() {
        let forces: Vec<Vector3<f64>> = columns.iter().map(force_part).collect();
        let reach = |c: &Vector3<f64>| required.reach(&Vector6::new(c.x, c.y, c.z, 0.0, 0.0, 0.0), length);
        let BindingFacet { margin, normal } = nearest_facet(&forces, statics, &force_part(statics.balance()), reach);
        let normal = Vector6::new(normal.x, normal.y, normal.z, 0.0, 0.0, 0.0);
        return Some(BindingFacet { margin: margin - lost, normal });
    }
    let facet = nearest_facet(&columns, statics, statics.balance(), |c| required.reach(c, length));
    Some(BindingFacet { margin: facet.margin - lost, ..facet })
}

/// Force margin: signed distance from the balancing force to the boundary of the set of forces that the cables can
/// exert, N, regardless of the moment. If it is positive, it is the radius of the largest ball of forces around the
/// balancing force (the paper's effective set); if it is negative, minus the smallest missing force. `None` if a cable
/// has no direction.
///
/// It is the smallest slack h(c) − c·f over *all* unit directions c, where h is the set's support function and f the
/// balancing force: inside the set the worst direction is a facet's normal, outside it is the direction from the set's
/// nearest point.
pub fn force_limit(statics: &Statics, position: &Point) -> Option<BindingFacet<3>> {
    let forces: Vec<Vector3<f64>> = statics.columns(position)?.iter().map(force_part).collect();
    let facet = signed_distance(&forces, statics, &force_part(statics.balance()));
    Some(BindingFacet { margin: facet.margin - statics.loss(position, Part::Force)?, ..facet })
}

/// Moment margin: like [`force_limit`], for moments about the platform's origin, N·m, regardless of the force. `None`
/// if a cable has no direction, and for a point mass, which has no moments.
pub fn moment_limit(statics: &Statics, position: &Point) -> Option<BindingFacet<3>> {
    if statics.point_mass() {
        return None;
    }
    let length = statics.characteristic_length();
    let moment_part = |w: &Vector6<f64>| Vector3::new(w[3], w[4], w[5]) * length;
    let moments: Vec<Vector3<f64>> = statics.columns(position)?.iter().map(moment_part).collect();
    let facet = signed_distance(&moments, statics, &moment_part(statics.balance()));
    Some(BindingFacet { margin: facet.margin - statics.loss(position, Part::Moment)?, ..facet })
}

/// Signed distance of a point to the boundary of {Σ tᵢ gᵢ : t in the limits}, negative outside.
fn signed_distance(generators: &[Vector3<f64>], statics: &Statics, point: &Vector3<f64>) -> BindingFacet<3> {
    let facet = nearest_facet(generators, statics, point, |_| 0.0);
    if facet.margin >= 0.0 {
        return facet;
    }
    let limits: Vec<[f64; 2]> = statics.cables().iter().map(|cable| cable.tension).collect();
    let reach: f64 = generators.iter().zip(&limits).map(|(g, limit)| g.norm() * limit[1]).sum();
    let set = Scaled { generators, limits: &limits, unit: reach.max(point.norm()) };
    let found = proximity(&set, &Point::from(point / set.unit), f64::INFINITY, -1.0);
    let margin = -found.lower * set.unit;
    // Because of rounding, GJK may find a smaller distance than the facet proves.
    if margin < facet.margin { BindingFacet { margin, normal: found.axis } } else { facet }
}

/// {Σ tᵢ gᵢ : t in the limits}, scaled to about unit size so that GJK's tolerances are small in comparison.
struct Scaled<'a> {
    generators: &'a [Vector3<f64>],
    limits: &'a [[f64; 2]],
    unit: f64,
}

impl Scaled<'_> {
    fn sum(&self, tension: impl Fn(&Vector3<f64>, &[f64; 2]) -> f64) -> Point {
        let forces = self.generators.iter().zip(self.limits).map(|(g, limits)| g * tension(g, limits));
        Point::from(forces.sum::<Vector3<f64>>() / self.unit)
    }
}

impl SupportMap for Scaled<'_> {
    fn support(&self, direction: &Vector3<f64>) -> Point {
        self.sum(|g, limits| limits[usize::from(g.dot(direction) > 0.0)])
    }

    fn center(&self) -> Point {
        self.sum(|_, limits| 0.5 * (limits[0] + limits[1]))
    }
}

fn force_part(w: &Vector6<f64>) -> Vector3<f64> {
    Vector3::new(w[0], w[1], w[2])
}
