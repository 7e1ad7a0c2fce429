//! The requirement of a scene's `[wrench]` table as a constraint on states and motions.

use super::cells::FeasibleCells;
use super::certify::{certified, first_failure, least_slack};
use super::measure::Measure;
use super::over;
use crate::collision::{Conditions, Slack, Unproved, Violation, WrenchLimit};
use crate::error::Error;
use crate::geometry::{Cuboid, Point, Rotation, largest_distance};
use crate::limits::MOST_WRENCH_CABLES;
use crate::model::{MarginSpec, Robot, RuleSpec, Scene, WrenchSpec};
use crate::tolerances::DEPENDENT;
use crate::wrench::statics::{MORE_SPREAD, Origin, Statics};
use crate::wrench::{CapacityMargin, Required};

/// Default cell size of the grid rule, m.
pub const GRID: f64 = 0.05;

/// How a motion is judged.
#[derive(Debug, Clone)]
enum Rule {
    Certified,
    Grid(FeasibleCells),
}

/// Wrench feasibility as required by a scene.
#[derive(Debug, Clone)]
pub struct WrenchConstraint {
    measures: Vec<Measure>,
    rule: Rule,
    origins: Vec<Origin>,
}

/// The measures by which a scene judges wrench feasibility, for each of its load cases; empty if it requires none.
///
/// # Errors
/// A robot without mass or tension limits or with more than [`MOST_WRENCH_CABLES`] cables, a moment required of a point
/// mass.
pub fn measures(scene: &Scene) -> Result<Vec<Measure>, Error> {
    measures_at(scene, scene.orientation())
}

/// The measures by which a scene judges wrench feasibility at another orientation of the platform.
///
/// # Errors
/// The errors of [`measures`].
pub fn measures_at(scene: &Scene, orientation: &Rotation) -> Result<Vec<Measure>, Error> {
    let Some(spec) = scene.wrench() else { return Ok(Vec::new()) };
    few_cables(scene.robot())?;
    let (required, margin) = (required(spec)?, spec.margin.unwrap_or(MarginSpec::Capacity));
    let cases = Statics::cases(scene, orientation)?;
    let of_each: Result<Vec<_>, Error> = cases.iter().map(|statics| measures_by(statics, &required, margin)).collect();
    Ok(of_each?.into_iter().flatten().collect())
}

/// Refuses robots with more cables than facets can be computed for.
pub fn few_cables(robot: &Robot) -> Result<(), Error> {
    let cables = robot.cables().len();
    if cables > MOST_WRENCH_CABLES {
        let problem =
            format!("found {cables}, expected at most {MOST_WRENCH_CABLES} if wrench feasibility is required");
        return Err(Error::invalid("robot.cables", problem));
    }
    Ok(())
}

/// The measures of a requirement; the requirements of the projected margins are the radii of its balls.
///
/// # Errors
/// A moment required of a point mass, or a moment of its weight and load about the point where its cables meet.
pub fn measures_by(statics: &Statics, required: &Required, margin: MarginSpec) -> Result<Vec<Measure>, Error> {
    let capacity = CapacityMargin::new(statics.clone(), required.clone()).map_err(|e| e.under("wrench"))?;
    if let Some(moment) = statics.moment_on_point_mass() {
        let problem = format!(
            "found a moment of {moment:.3} N·m about the point where all cables meet, expected none: they can exert none; \
             move the centre of mass there, or change the load"
        );
        return Err(Error::invalid("robot.center_of_mass", problem));
    }
    let (force, moment) = match required {
        Required::Balls { force, moment } => (*force, *moment),
        Required::Polytope(_) => (0.0, 0.0),
    };
    Ok(match margin {
        MarginSpec::Capacity => vec![Measure::Capacity(Box::new(capacity))],
        MarginSpec::Projected if statics.point_mass() => vec![Measure::Force(statics.clone(), force)],
        MarginSpec::Projected => {
            vec![Measure::Force(statics.clone(), force), Measure::Moment(statics.clone(), moment)]
        }
    })
}

/// The required wrenches of a spec.
///
/// # Errors
/// A radius that is negative or not finite.
pub fn required(spec: &WrenchSpec) -> Result<Required, Error> {
    match &spec.vertices {
        Some(corners) => Ok(Required::Polytope(corners.iter().map(|corner| (*corner).into()).collect())),
        None => Required::balls(spec.force.unwrap_or(0.0), spec.moment.unwrap_or(0.0)),
    }
}

/// The required wrenches of a scene with other radii; without a requirement, only balance.
///
/// # Errors
/// A radius that is negative or not finite.
pub fn required_of(scene: &Scene, force: Option<f64>, moment: Option<f64>) -> Result<Required, Error> {
    let of_scene = scene.wrench().cloned().unwrap_or_default();
    if force.is_none() && moment.is_none() {
        return required(&of_scene);
    }
    Required::balls(force.or(of_scene.force).unwrap_or(0.0), moment.or(of_scene.moment).unwrap_or(0.0))
}

impl WrenchConstraint {
    /// The constraint of a scene, whose geometric conditions are `conditions`; `None` if the scene does not require
    /// one.
    ///
    /// # Errors
    /// The errors of [`measures`]; a grid with too many cells.
    pub fn of(scene: &Scene, conditions: &Conditions) -> Result<Option<Self>, Error> {
        let measures = measures(scene)?;
        let Some(spec) = scene.wrench() else { return Ok(None) };
        let rule = match spec.rule.unwrap_or(RuleSpec::Certified) {
            RuleSpec::Certified => Rule::Certified,
            RuleSpec::Grid => {
                let (size, membership) = (spec.grid.unwrap_or(GRID), spec.membership.unwrap_or_default());
                Rule::Grid(FeasibleCells::new(&measures, conditions.position_box(), size, membership)?)
            }
        };
        let origins =
            scene.robot().cables().iter().zip(&conditions.bodies.cables).map(|(cable, at)| match cable.pulley {
                None => Origin { middle: cable.outlet, spread: 0.0 },
                Some(_) => {
                    let middle = at.middle_exit();
                    Origin { middle, spread: largest_distance(at.exits(), &middle) + MORE_SPREAD }
                }
            });
        Ok(Some(WrenchConstraint { measures, rule, origins: origins.collect() }))
    }

    /// The measures of the requirement.
    pub fn measures(&self) -> &[Measure] {
        &self.measures
    }

    /// Whether a motion satisfies the requirement: certified at every point of it, or by the cells that it crosses.
    pub fn keeps(&self, from: &Point, to: &Point) -> bool {
        match &self.rule {
            Rule::Certified => self.measures.iter().all(|measure| certified(measure, from, to)),
            Rule::Grid(cells) => cells.first_infeasible(from, to).is_none(),
        }
    }

    /// A direction [force; moment] in which the cables provide less than required at all positions of a box, if a bound shows
    /// that there is one. Never by the rule of cells, which may accept such positions.
    pub fn lacking(&self, positions: &Cuboid) -> Option<[f64; 6]> {
        match self.rule {
            Rule::Certified => self.measures.iter().find_map(|measure| measure.lacking(positions, &self.origins)),
            Rule::Grid(_) => None,
        }
    }

    /// What remains unproved of the requirement in a box, by measure, if nothing but `known` is unproved in a box around it; `None` if
    /// no position of the box satisfies the requirement.
    pub fn over(&self, positions: &Cuboid, known: Option<&[Unproved]>) -> Option<Vec<Unproved>> {
        match &self.rule {
            Rule::Certified => {
                let unproved = |k: usize| known.map_or(&Unproved::All, |known| &known[k]);
                self.measures.iter().enumerate().map(|(k, of)| over::judged(of, positions, unproved(k))).collect()
            }
            Rule::Grid(cells) => match cells.over(positions) {
                Some(satisfied) => satisfied.then(Vec::new),
                None => Some(vec![Unproved::All]),
            },
        }
    }

    /// Where in a box the requirement is satisfied, if nothing but `known` is unproved in the box.
    pub fn slack(&self, positions: &Cuboid, known: Option<&[Unproved]>) -> Slack {
        if let Rule::Grid(_) = self.rule {
            return Slack::default();
        }
        let mut all = Slack { sides: Vec::new(), complete: true };
        for (k, measure) in self.measures.iter().enumerate() {
            let unproved = known.map_or(&Unproved::All, |known| &known[k]);
            all.complete &= over::sides(measure, positions, unproved, &mut all.sides);
        }
        all
    }

    /// The violation of a motion, if it does not satisfy the requirement; marked as unproved if no failure is known.
    pub fn violation(&self, from: &Point, to: &Point) -> Option<Violation> {
        let (at, limit) = match &self.rule {
            Rule::Certified => {
                let at = self.measures.iter().filter_map(|m| first_failure(m, from, to)).min_by(f64::total_cmp)?;
                let (measure, worst) = self.worst(from, to);
                (at, limit_at(measure, &(from + (to - from) * worst)))
            }
            Rule::Grid(cells) => {
                let (at, cell) = cells.first_infeasible(from, to)?;
                let points = cells.points(cell);
                let limits = self.measures.iter().flat_map(|m| points.iter().map(move |p| (limit_at(m, p), p)));
                let (limit, corner) = limits.min_by(|(a, _), (b, _)| a.order().total_cmp(&b.order()))?;
                (at, WrenchLimit { corner: Some((*corner).into()), ..limit })
            }
        };
        Some(Violation::of_wrench(at, limit))
    }

    /// The measure with the smallest slack on a motion, and the fraction at which it is smallest.
    fn worst(&self, from: &Point, to: &Point) -> (&Measure, f64) {
        let least = self.measures.iter().map(|measure| (measure, least_slack(measure, from, to)));
        let (measure, (_, at)) = least
            .min_by(|(_, (a, _)), (_, (b, _))| if a.is_nan() { std::cmp::Ordering::Less } else { a.total_cmp(b) })
            .expect("at least one measure");
        (measure, at)
    }
}

/// The facet that limits a robot at a position, by cable names.
pub fn limit_at(measure: &Measure, position: &Point) -> WrenchLimit {
    let (name, unit) = measure.name_and_unit();
    let mut found = WrenchLimit {
        wrench_margin: None,
        hold: None,
        corner: None,
        measure: name,
        unit,
        load_case: measure.statics().load_case(),
        at_greatest: Vec::new(),
        at_least: Vec::new(),
    };
    let statics = measure.statics();
    let (Some(limit), Some(columns)) = (measure.limit(position), statics.columns(position)) else { return found };
    found.wrench_margin = Some(limit.margin);
    found.hold = statics.hold(position);
    let heights: Vec<f64> = columns.iter().map(|column| limit.normal.dot(column)).collect();
    let in_facet = DEPENDENT.sqrt() * heights.iter().fold(0.0, |most: f64, height| most.max(height.abs()));
    for (cable, height) in statics.cables().iter().zip(heights) {
        match height {
            height if height > in_facet => found.at_greatest.push(cable.name.clone()),
            height if height < -in_facet => found.at_least.push(cable.name.clone()),
            _ => {}
        }
    }
    found
}
