//! Where cables leave the frame: round their pulleys, and at outlets that are not exactly where they should be.
//!
//! If the direction of cable i differs by δᵢ, its column differs by at most δᵢ times its lever, and the slack in any direction by at
//! most Σ t_max,i leverᵢ |δᵢ|. So a nonnegative margin at the given outlets minus this is a lower bound of the margins at all
//! outlets within the errors; a negative one means that the requirement is not known to be met.

use super::{StaticCable, Statics};
use crate::geometry::{Departure, Leeway, Point};

/// The part of wrenches that a margin counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// Forces and moments.
    Whole,
    /// Forces alone.
    Force,
    /// Moments alone, N·m.
    Moment,
}

/// Where a cable comes from: its outlet, or its pulley. Its line passes the middle of the points where it can leave it at a distance of at
/// most `spread`, m.
#[derive(Debug, Clone, Copy)]
pub struct Origin {
    /// Middle of the points, world, m.
    pub middle: Point,
    /// The largest distance of a line from the middle, m.
    pub spread: f64,
}

/// Added to the spread of cables with pulleys, m: more than checkers of certificates add.
pub const MORE_SPREAD: f64 = 1e-6;

impl Origin {
    /// How much directions to here from points up to `reach`, m, from one differ at most, as the length of a vector, from those of the cable;
    /// `None` if there may be none.
    pub fn astray(&self, attachment: &Point, reach: f64) -> Option<f64> {
        Leeway::of(None, &self.middle, attachment).within(reach).astray(self.spread)
    }
}

impl StaticCable {
    /// How the cable leaves its pulley with the platform at a position; `None` if it cannot, or has no pulley.
    pub fn departure(&self, position: &Point) -> Option<Departure> {
        self.pulley?.departure(&self.outlet, &(position + self.arm))
    }

    /// Length at a position, round the pulley if there is one, m; NaN if the cable cannot leave it.
    pub fn length(&self, position: &Point) -> f64 {
        match self.pulley {
            None => (self.outlet - (position + self.arm)).norm(),
            Some(_) => self.departure(position).map_or(f64::NAN, |found| found.length),
        }
    }

    /// Where the cable leaves its pulley with the platform at a position, or its outlet; `None` if it cannot leave its pulley.
    pub fn exit(&self, position: &Point) -> Option<Point> {
        match &self.pulley {
            None => Some(self.outlet),
            Some(pulley) => pulley.exit_and_pull(&self.outlet, &(position + self.arm)).map(|(exit, _)| exit),
        }
    }

    /// Where the cable comes from at positions up to `reach`, m, from one: where it leaves its pulley there; `None` if it may have no
    /// direction.
    pub fn origin_near(&self, position: &Point, reach: f64) -> Option<Origin> {
        let Some(pulley) = &self.pulley else { return Some(Origin { middle: self.outlet, spread: 0.0 }) };
        let exit = self.exit(position)?;
        let missed = self.leeway(position).missed((exit - self.outlet).cross(&pulley.axis).norm(), reach)?;
        Some(Origin { middle: exit, spread: missed + MORE_SPREAD })
    }

    /// How far the attachment is from where the cable loses its direction, at the given outlet.
    pub fn leeway(&self, position: &Point) -> Leeway {
        Leeway::of(self.pulley.as_ref(), &self.outlet, &(position + self.arm))
    }
}

impl Statics {
    /// Whether a cable has a pulley.
    pub fn has_pulleys(&self) -> bool {
        self.pulleys
    }

    /// Whether a true outlet may differ from the given one.
    pub fn has_errors(&self) -> bool {
        self.errors
    }

    /// Lipschitz constant of a cable's column with respect to the cable's direction.
    pub fn lever(&self, cable: &StaticCable, part: Part) -> f64 {
        match part {
            Part::Whole if self.point_mass => 1.0,
            Part::Whole => (cable.arm / self.length).norm().hypot(1.0),
            Part::Force => 1.0,
            Part::Moment => cable.arm.norm(),
        }
    }

    /// How much smaller the slack at the true outlets can be than at the given ones, N or N·m; `None` if a cable may have no
    /// direction.
    pub fn loss(&self, position: &Point, part: Part) -> Option<f64> {
        if !self.errors {
            return Some(0.0);
        }
        self.loss_by(part, |cable| cable.leeway(position))
    }

    /// The largest [`loss`](Self::loss) on a straight piece; infinite if a cable may have no direction there.
    pub fn loss_between(&self, from: &Point, to: &Point, part: Part) -> f64 {
        if !self.errors {
            return 0.0;
        }
        let way = (to - from).norm();
        self.loss_by(part, |cable| cable.leeway(from).between(cable.leeway(to), way)).unwrap_or(f64::INFINITY)
    }

    /// How much smaller the slack can be in the middle of a straight piece than if each cable came from a point that moves evenly between
    /// where it leaves its pulley at the ends; infinite if a cable may have no direction there.
    pub fn loss_of_even_exits(&self, from: &Point, to: &Point, part: Part) -> f64 {
        let way = (to - from).norm();
        let lost = |cable: &StaticCable| {
            if cable.pulley.is_none() {
                return Some(0.0);
            }
            let turned = cable.leeway(from).between(cable.leeway(to), way).turned_from_even(way)?;
            Some(cable.tension[1] * self.lever(cable, part) * turned)
        };
        self.cables.iter().map(lost).sum::<Option<f64>>().unwrap_or(f64::INFINITY)
    }

    /// The largest [`loss`](Self::loss) at most this far from a position; infinite if a cable may have no direction there.
    pub fn loss_within(&self, position: &Point, reach: f64, part: Part) -> f64 {
        if !self.errors {
            return 0.0;
        }
        self.loss_by(part, |cable| cable.leeway(position).within(reach)).unwrap_or(f64::INFINITY)
    }

    fn loss_by(&self, part: Part, leeway: impl Fn(&StaticCable) -> Leeway) -> Option<f64> {
        let lost = |cable: &StaticCable| {
            Some(cable.tension[1] * self.lever(cable, part) * leeway(cable).astray(cable.outlet_error)?)
        };
        self.cables.iter().map(lost).sum()
    }
}
