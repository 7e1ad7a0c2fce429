//! A requirement on the wrenches of a robot as one number: the slack (margin minus requirement) at positions, and a
//! lower bound of it between them.

use nalgebra::Vector6;

use crate::geometry::{Cuboid, Point, Vector};
use crate::simd::WIDTH;
use crate::tolerances::SLACK_RELATIVE;
use crate::wrench::set::{BindingFacet, CapacityMargin, force_limit, moment_limit};
use crate::wrench::statics::{Origin, Part, StaticCable, Statics};

/// Result for a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MotionVerdict {
    /// The slack is at least the measure's floor everywhere.
    Holds,
    /// The slack is too small at this fraction of the motion.
    Fails(f64),
    /// The slack suffices up to this fraction; beyond it, neither result could be proved.
    Undecided(f64),
}

/// The margin by which a requirement is judged.
#[derive(Debug, Clone)]
pub enum Measure {
    /// The capacity margin: forces and moments together.
    Capacity(Box<CapacityMargin>),
    /// Forces alone: a ball of this radius, N.
    Force(Statics, f64),
    /// Moments alone: a ball of this radius, N·m.
    Moment(Statics, f64),
}

impl Measure {
    /// The statics of the robot.
    pub fn statics(&self) -> &Statics {
        match self {
            Measure::Capacity(margin) => margin.statics(),
            Measure::Force(statics, _) | Measure::Moment(statics, _) => statics,
        }
    }

    /// Name and unit of the measure.
    pub fn name_and_unit(&self) -> (&'static str, &'static str) {
        match self {
            Measure::Capacity(_) => ("capacity", "N"),
            Measure::Force(..) => ("force", "N"),
            Measure::Moment(..) => ("moment", "N·m"),
        }
    }

    /// Slack at four positions: margin minus requirement; NaN where a cable has no direction.
    pub fn slack_at_four(&self, positions: &[Point; WIDTH]) -> [f64; WIDTH] {
        match self {
            Measure::Capacity(margin) => margin.at_four(positions),
            Measure::Force(..) | Measure::Moment(..) => {
                positions.map(|p| self.limit(&p).map_or(f64::NAN, |limit| limit.margin))
            }
        }
    }

    /// Slack at a position; NaN where a cable has no direction.
    pub fn slack(&self, position: &Point) -> f64 {
        match self {
            Measure::Capacity(margin) => margin.at(position),
            Measure::Force(..) | Measure::Moment(..) => self.limit(position).map_or(f64::NAN, |limit| limit.margin),
        }
    }

    /// The nearest facet and its slack; `None` if a cable has no direction.
    pub fn limit(&self, position: &Point) -> Option<BindingFacet<6>> {
        match self {
            Measure::Capacity(margin) => margin.limit(position),
            Measure::Force(statics, radius) => {
                let BindingFacet { margin, normal: c } = force_limit(statics, position)?;
                Some(BindingFacet { margin: margin - radius, normal: Vector6::new(c.x, c.y, c.z, 0.0, 0.0, 0.0) })
            }
            Measure::Moment(statics, radius) => {
                let BindingFacet { margin, normal: c } = moment_limit(statics, position)?;
                Some(BindingFacet { margin: margin - radius, normal: Vector6::new(0.0, 0.0, 0.0, c.x, c.y, c.z) })
            }
        }
    }

    /// The smallest slack that counts: below it rounding could decide. A share of the longest edge of the measured set.
    pub fn floor(&self) -> f64 {
        SLACK_RELATIVE * self.edge()
    }

    /// The maximum length of the edges of the measured set.
    pub fn edge(&self) -> f64 {
        let edge = |cable: &StaticCable| cable.tension[1] * self.lever(cable);
        self.statics().cables().iter().map(edge).fold(0.0, f64::max)
    }

    /// Whether slack is computed for four positions at a time, in about the time of two.
    pub fn by_kernel(&self) -> bool {
        matches!(self, Measure::Capacity(margin) if margin.by_kernel())
    }

    /// The maximum number of pairs of facets of the measured set.
    pub fn facets(&self) -> usize {
        let statics = self.statics();
        let m = statics.cables().len();
        (0..self.rows() - 1).fold(1, |n, k| n * m.saturating_sub(k) / (k + 1))
    }

    /// Number of rows of a wrench that count.
    pub fn rows(&self) -> usize {
        if matches!(self, Measure::Capacity(_)) && !self.statics().point_mass() { 6 } else { 3 }
    }

    /// The part of wrenches that counts.
    fn part(&self) -> Part {
        match self {
            Measure::Capacity(_) => Part::Whole,
            Measure::Force(..) => Part::Force,
            Measure::Moment(..) => Part::Moment,
        }
    }

    /// Lipschitz constant of a cable's column of the measured set with respect to the cable's direction.
    pub(super) fn lever(&self, cable: &StaticCable) -> f64 {
        self.statics().lever(cable, self.part())
    }

    /// How much smaller the slack at the true outlets can be on a straight piece than at the given ones.
    pub fn loss(&self, from: &Point, to: &Point) -> f64 {
        self.statics().loss_between(from, to, self.part())
    }

    /// How much smaller the slack can be in the middle of a straight piece than if exits moved evenly.
    pub fn loss_of_even_exits(&self, from: &Point, to: &Point) -> f64 {
        self.statics().loss_of_even_exits(from, to, self.part())
    }

    /// How much smaller the slack at the true outlets can be than at the given ones, at most this far from a position; infinite if a
    /// cable may have no direction.
    pub fn loss_within(&self, position: &Point, reach: f64) -> f64 {
        self.statics().loss_within(position, reach, self.part())
    }

    /// The most by which slack that is not negative can drop per metre within `reach`, m, of a position: a cable turns by at most the
    /// inverse of its length. Infinite if a cable may lose its direction there.
    pub fn steepness(&self, position: &Point, reach: f64) -> f64 {
        let near = |cable: &StaticCable| {
            let bounds = cable.leeway(position).within(reach + cable.outlet_error).turning();
            bounds.map_or(f64::INFINITY, |bounds| cable.tension[1] * self.lever(cable) * bounds.first)
        };
        let statics = self.statics();
        if statics.has_pulleys() || statics.has_errors() {
            return statics.cables().iter().map(near).sum();
        }
        let change = |cable: &StaticCable| {
            let shortest = (cable.outlet - (position + cable.arm)).norm() - reach;
            if shortest > 0.0 { cable.tension[1] * self.lever(cable) / shortest } else { f64::INFINITY }
        };
        statics.cables().iter().map(change).sum()
    }

    /// By how much more than [`steepness`](Self::steepness) slack can drop if the platform also turns: per metre that a turn moves a
    /// point at the distance `reach`, m, at least that of all attachments. The centre of mass is in the platform's frame, m.
    ///
    /// An attachment that moves by d relative to the origin changes the moment of its cable by at most d t_max; a turn by an angle
    /// changes the moment of a weight m g at the distance c by at most m g c times the angle.
    pub fn steepness_of_turns(&self, center_of_mass: Point, reach: f64) -> f64 {
        let statics = self.statics();
        let pulls: f64 = statics.cables().iter().map(|cable| cable.tension[1]).sum();
        let weight = statics.balance().fixed_rows::<3>(0).norm();
        let change = pulls + weight * center_of_mass.coords.norm() / reach;
        match self.part() {
            Part::Whole => change / statics.characteristic_length(),
            Part::Force => 0.0,
            Part::Moment => change,
        }
    }

    /// The normal [force; moment] of the facet that limits most at the centre of a box, if it shows that the slack is negative
    /// everywhere in the box, where the cables come from somewhere within `origins`.
    ///
    /// In a fixed direction c a cable adds φ(q·u), where u is its unit direction, q = c_f + c_m × arm / ℓ, and φ grows with its
    /// argument. In the box u differs from the direction between the centre and the middle of the origin by at most the angle whose
    /// sine is half the diagonal and the spread together over the distance.
    ///
    /// The outlets are the given ones, which are among those within their errors.
    pub fn lacking(&self, positions: &Cuboid, origins: &[Origin]) -> Option<[f64; 6]> {
        let statics = self.statics();
        let BindingFacet { margin, normal } = self.limit(&positions.center)?;
        let margin = margin + statics.loss(&positions.center, self.part())?;
        let (force, moment) = (normal.fixed_rows::<3>(0), normal.fixed_rows::<3>(3) / statics.characteristic_length());
        let reach = positions.half.norm();
        let gain = |(cable, anywhere): (&StaticCable, &Origin)| {
            let near = cable.origin_near(&positions.center, reach).filter(|near| near.spread < anywhere.spread);
            let (origin, weight) = (near.as_ref().unwrap_or(anywhere), force + moment.cross(&cable.arm));
            let highest = origin.largest(&weight, &(positions.center + cable.arm), reach);
            let pull = |along: f64| (cable.tension[0] * along).max(cable.tension[1] * along);
            pull(highest) - pull(weight.dot(&cable.column(&positions.center, 1.0).fixed_rows::<3>(0)))
        };
        let most = margin + statics.cables().iter().zip(origins).map(gain).sum::<f64>();
        let direction = [force.x, force.y, force.z, moment.x, moment.y, moment.z];
        (most < -self.floor()).then_some(direction)
    }

    /// How far slack can drop below its chord in the middle of a straight piece; see [`sagging`].
    pub fn sag(&self, from: &Point, to: &Point) -> f64 {
        let step = to - from;
        let squared = step.norm_squared();
        if self.statics().has_pulleys() || self.statics().has_errors() {
            return if squared == 0.0 { 0.0 } else { self.sag_of_any(from, to) };
        }
        let sag = |cable: &StaticCable| {
            let line = cable.outlet - (from + cable.arm);
            let foot = (line.dot(&step) / squared).clamp(0.0, 1.0);
            let nearest = (line - step * foot).norm_squared();
            let across = (line.norm_squared() - line.dot(&step).powi(2) / squared).max(0.0);
            // The direction turns by |step| D / l² along the piece, D the distance of the outlet from the infinite
            // line.
            let turn = ((squared * across).sqrt() / nearest).min(2.0);
            let bend = squared * BEND / nearest;
            let [least, largest] = cable.tension;
            self.lever(cable) * (0.25 * (largest - least) * turn + 0.125 * largest * bend)
        };
        if squared == 0.0 { 0.0 } else { self.statics().cables().iter().map(sag).sum() }
    }

    /// [`sag`](Self::sag) for all outlets within their errors, and for pulleys: with the changes of the columns themselves, and
    /// the bounds of [`crate::geometry::Leeway`] on how directions turn. Seen from another outlet, a direction turns by at most
    /// the error times the second derivative more.
    fn sag_of_any(&self, from: &Point, to: &Point) -> f64 {
        let (way, statics) = ((to - from).norm(), self.statics());
        let mut changes = Vec::with_capacity(statics.cables().len());
        let mut bent = 0.0;
        for cable in statics.cables() {
            let leeway = cable.leeway(from).between(cable.leeway(to), way).within(cable.outlet_error);
            let Some(bounds) = leeway.turning() else { return f64::INFINITY };
            let ([least, largest], lever) = (cable.tension, self.lever(cable));
            let quarter = 0.25 * (largest - least);
            bent += lever * way * bounds.second * (0.125 * largest * way + quarter * cable.outlet_error);
            changes.push((self.counted(cable, to) - self.counted(cable, from)) * quarter);
        }
        largest_sum(&changes) + bent
    }

    /// The part that counts of a cable's column.
    fn counted(&self, cable: &StaticCable, position: &Point) -> Vector6<f64> {
        let (part, statics) = (self.part(), self.statics());
        let length = if part == Part::Moment { 1.0 } else { statics.characteristic_length() };
        let mut column = cable.column(position, length);
        match part {
            Part::Whole if !statics.point_mass() => {}
            Part::Moment => column.fixed_rows_mut::<3>(0).fill(0.0),
            Part::Whole | Part::Force => column.fixed_rows_mut::<3>(3).fill(0.0),
        }
        column
    }
}

impl Origin {
    /// The largest product of a vector with the unit directions from attachments at most `reach`, m, from a point to here.
    fn largest(&self, vector: &Vector, attachment: &Point, reach: f64) -> f64 {
        let line = self.middle - attachment;
        let (length, most) = (line.norm(), vector.norm());
        let along = vector.dot(&line) / length;
        let across = (most * most - along * along).max(0.0).sqrt();
        let sine = (reach + self.spread) / length;
        let cosine = (1.0 - sine * sine).max(0.0).sqrt();
        // Beyond the angle between the two, the largest value is the length of the vector.
        if !(sine < 1.0) || along >= most * cosine { most } else { along * cosine + across * sine }
    }
}

/// An upper bound of Σ |c·aᵢ| over all unit directions c. It is the length of the longest sum of the aᵢ with signs, so its
/// square is at most the sum of all |aᵢ·aⱼ|.
pub fn largest_sum(vectors: &[Vector6<f64>]) -> f64 {
    let products = |k: usize| {
        let others: f64 = vectors[..k].iter().map(|other| other.dot(&vectors[k]).abs()).sum();
        vectors[k].norm_squared() + 2.0 * others
    };
    (0..vectors.len()).map(products).sum::<f64>().sqrt()
}

/// Maximum second derivative of a direction to a fixed point at distance l, times l², along a line at unit speed: with
/// x the sine of the angle between the two, x √(4 − 3x²) is largest at x² = 2/3.
pub const BEND: f64 = 1.154_700_538_379_251_5;

/// Lower bound of the slack on a straight piece between two positions with slack `a` and `b` (both nonnegative), where
/// `sag` is [`Measure::sag`] of the piece.
///
/// For each unit direction c the slack is Σ φᵢ(c·wᵢ) minus constants, with φᵢ(x) = μᵢ x + ρᵢ |x|, and the slack is the
/// minimum over all c. Between the ends, c·wᵢ deviates from its chord by a second-order term, and |x| of a linear x is
/// below its chord only where x changes sign, by at most 2λ(1−λ)|Δx|. So at fraction λ the slack is at least (1−λ) a +
/// λ b − 4λ(1−λ) sag, a parabola; this function returns its minimum.
pub fn sagging(a: f64, b: f64, sag: f64) -> f64 {
    let rise = b - a;
    if rise.abs() >= 4.0 * sag {
        return a.min(b);
    }
    a - (4.0 * sag - rise).powi(2) / (16.0 * sag)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Aabb, Pulley, largest_distance};
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    /// The bound on the direction of a cable holds at every position nearby, and is nearly attained.
    #[test]
    fn no_direction_near_a_position_exceeds_the_largest() {
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        let mut vector = |size: f64| Vector::from_fn(|_, _| rng.random_range(-size..size));
        let (mut seen, mut counted) = (0.0, 0);
        for number in 0..2000 {
            let radius = if number % 3 == 0 { 0.0 } else { 0.1 };
            let pulley = (radius > 0.0).then(|| Pulley { radius, axis: vector(1.0).normalize() });
            let (outlet, arm, position) = (Point::from(vector(1.0)), vector(0.3), Point::from(vector(4.0)));
            let cable =
                StaticCable { outlet, arm, tension: [1.0, 2.0], name: String::new(), pulley, outlet_error: 0.0 };
            let reach = 0.05;
            let around = position + arm;
            let Some(exits) = (match pulley {
                None => Some(vec![outlet]),
                Some(pulley) => pulley.exits(&outlet, &Aabb::around(&[around]).widened(reach)),
            }) else {
                continue;
            };
            if cable.leeway(&position).within(reach).turning().is_none() {
                continue; // so near to the wheel that the cable may not leave it
            }
            let middle = Point::from(exits.iter().map(|exit| exit.coords).sum::<Vector>() / exits.len() as f64);
            let origin = Origin { middle, spread: largest_distance(&exits, &middle) };
            // Across the cable, where a turn counts most.
            let pull = cable.column(&position, 1.0).fixed_rows::<3>(0).cross(&vector(1.0)).normalize();
            let bound = origin.largest(&pull, &around, reach);
            let along = |at: Point| pull.dot(&cable.column(&at, 1.0).fixed_rows::<3>(0));
            let ways = (0..20).map(|_| vector(1.0).normalize()).chain([pull, -pull]);
            let found = ways.map(|way| along(position + way * reach)).fold(-1.0, f64::max);
            counted += 1;
            assert!(found <= bound + 1e-12, "{found} {bound} {cable:?} {position}");
            seen = f64::max(seen, found / bound);
        }
        assert!(counted > 1000 && seen > 0.99, "{counted} {seen}");
    }
}
