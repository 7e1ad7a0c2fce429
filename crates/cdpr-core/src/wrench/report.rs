//! Tensions and margins of a robot, at a position and along a path.

use nalgebra::Matrix6xX;
use serde::Serialize;

use super::zonotope::Span;
use super::{CapacityMargin, Required, StaticCable, Statics, capacity_limit, force_limit, moment_limit};
use crate::collision::WrenchLimit;
use crate::error::Error;
use crate::geometry::{Point, Pose};
use crate::model::{Commands, Distribution, MarginSpec, Scene};
use crate::tolerances::{MIN_CABLE_LENGTH, STEP_COUNT};
use crate::wrench::motion::constraint::{limit_at, measures_by};
use crate::wrench::motion::{Measure, certified};
use crate::wrench::settling::Settling;
use crate::wrench::statics::{Hold, Loads};
use crate::wrench::tensions::{Balance, FeasibilityLp, TensionQp};

impl Statics {
    /// Minimum and maximum tension of each cable, N.
    pub fn limits(&self) -> Vec<[f64; 2]> {
        self.cables().iter().map(|cable| cable.tension).collect()
    }

    /// Length of each cable at a position, round its pulley if it has one, m; NaN if it cannot leave the pulley.
    pub fn lengths(&self, position: &Point) -> Vec<f64> {
        self.cables().iter().map(|cable| cable.length(position)).collect()
    }

    /// The tensions that balance the loads at a position, N: those that the robot keeps ([`Statics::distribution`]), or the
    /// nearest to a `reference`. `None` if no tensions within the limits balance the loads, if those in closed form exceed
    /// a limit, or if a cable has no direction. The solver is reused from one position to the next.
    ///
    /// # Errors
    /// A reference of the wrong length; a solver that reached no answer.
    pub fn tensions(
        &self,
        solver: &mut TensionQp,
        position: &Point,
        reference: Option<&[f64]>,
    ) -> Result<Option<Vec<f64>>, Error> {
        let Some(columns) = self.columns(position) else { return Ok(None) };
        let (columns, limits) = (Matrix6xX::from_columns(&columns), self.limits());
        let found = match reference {
            Some(_) => solver.solve(&columns, &limits, self.balance(), reference),
            None => solver.distribute(self.distribution(), &columns, &limits, self.balance()),
        };
        match found? {
            Balance::Feasible(tensions) => Ok(Some(tensions.as_slice().to_vec())),
            Balance::Infeasible => Ok(None),
            Balance::Undecided => Err(undecided(position)),
        }
    }

    /// Whether any tensions within the limits balance the loads, by linear program.
    ///
    /// # Errors
    /// A solver that reached no answer.
    pub fn balanced(&self, solver: &mut FeasibilityLp, position: &Point) -> Result<bool, Error> {
        let Some(columns) = self.columns(position) else { return Ok(false) };
        match solver.solve(&Matrix6xX::from_columns(&columns), &self.limits(), self.balance())? {
            Balance::Feasible(_) => Ok(true),
            Balance::Infeasible => Ok(false),
            Balance::Undecided => Err(undecided(position)),
        }
    }
}

fn undecided(position: &Point) -> Error {
    let at = [position.x, position.y, position.z];
    Error::invalid("", format!("the solver could not decide at {at:?}; please report this with the robot"))
}

/// Everything about the wrenches of a robot at one position; see [`wrench_at`].
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WrenchReport {
    /// Whether planning with the same requirement accepts the position: full rank, and all required wrenches are
    /// available.
    pub feasible: bool,
    /// Whether tensions within the limits balance the loads alone. At a lower rank this is possible, but the cables
    /// then resist no disturbance along a free motion.
    pub balanced: bool,
    /// How the cables constrain the platform regardless of tension limits: the rank and its consequences.
    #[serde(flatten)]
    pub hold: Hold,
    /// The wrench matrix, six rows; the last three in metres.
    pub wrench_matrix: Vec<Vec<f64>>,
    /// Force margin, N; see [`force_limit`].
    pub force_margin: f64,
    /// Moment margin, N·m; `None` for a point mass; see [`moment_limit`].
    pub moment_margin: Option<f64>,
    /// Capacity margin, N; see [`capacity_limit`].
    pub capacity_margin: f64,
    /// The facet that limits the capacity.
    pub limit: WrenchLimit,
    /// Names of the cables, in the order of `tensions` and `lengths`.
    pub cables: Vec<String>,
    /// Which of all tensions that balance the loads are chosen.
    pub tension_distribution: Distribution,
    /// The chosen tensions that balance the loads, N; `None` if there are none.
    pub tensions: Option<Vec<f64>>,
    /// Length of each cable, m.
    pub lengths: Vec<f64>,
    /// How far the platform settles if the winches are commanded these lengths, without the stretch; see [`Settling::of`].
    pub settling: Option<Settling>,
}

/// Tensions, margins and rank of the cables of a robot at a position, judged by `margin`. How far the platform settles is not computed.
///
/// # Errors
/// A position where a cable has no direction; a moment required of a point mass, or a moment of its weight; a solver
/// that reached no answer.
///
/// # Example
/// ```
/// use cdpr_core::{Point, model::MarginSpec, testing};
/// use cdpr_core::{Required, wrench::{Loads, Statics, wrench_at}};
/// let statics = Statics::new(testing::empty().robot(), &Loads::default())?;
/// let at = Point::new(1.0, 1.0, 1.0);
/// let report = wrench_at(&statics, &Required::default(), MarginSpec::Capacity, &at)?;
/// assert!(report.balanced && !report.feasible); // the weight can be carried, but any moment about z turns the platform:
/// assert_eq!(report.hold.sentence(), "rank 5 of 6, underconstrained: no tensions resist turning about z");
/// let tensions = report.tensions.unwrap();
/// assert!(tensions[4] > tensions[0]); // cables to the ceiling pull more
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn wrench_at(
    statics: &Statics,
    required: &Required,
    margin: MarginSpec,
    position: &Point,
) -> Result<WrenchReport, Error> {
    let measures = measures_by(statics, required, margin)?;
    let capacity = CapacityMargin::new(statics.clone(), required.clone())?;
    let (Some(hold), Some(limit)) = (statics.hold(position), capacity_limit(statics, required, position)) else {
        let lost = |cable: &&StaticCable| {
            !cable.column(position, 1.0).x.is_finite() || cable.leeway(position).astray(cable.outlet_error).is_none()
        };
        let short = statics.cables().iter().find(lost);
        let name = short.map_or("a cable", |cable| &cable.name);
        let mut problem =
            format!("has no direction at this position, expected a length of at least {MIN_CABLE_LENGTH:e} m");
        if statics.has_pulleys() || statics.has_errors() {
            problem += " at every outlet within `outlet_error`, and an attachment that its pulley does not hide";
        }
        return Err(Error::invalid(name, problem));
    };
    let margin = |limit: Option<super::BindingFacet<3>>| limit.map(|limit| limit.margin);
    let mut solver = TensionQp::default();
    let tensions = statics.tensions(&mut solver, position, None)?;
    // The closed form may exceed limits where other tensions keep them.
    let balanced = tensions.is_some()
        || statics.distribution() == Distribution::ClosedForm
            && statics.tensions(&mut solver, position, Some(&vec![0.0; statics.cables().len()]))?.is_some();
    Ok(WrenchReport {
        feasible: measures.iter().all(|measure| certified(measure, position, position)),
        balanced,
        hold,
        wrench_matrix: (0..6).map(|row| metric_row(statics, position, row)).collect(),
        force_margin: margin(force_limit(statics, position)).unwrap_or(f64::NAN),
        moment_margin: margin(moment_limit(statics, position)),
        capacity_margin: limit.margin,
        limit: limit_at(&Measure::Capacity(Box::new(capacity)), position),
        cables: statics.cables().iter().map(|cable| cable.name.clone()).collect(),
        tension_distribution: statics.distribution(),
        tensions,
        lengths: statics.lengths(position),
        settling: None,
    })
}

/// Tensions, margins and rank of the cables of a scene's robot at a position in the least favourable of its load cases:
/// the one with the smallest capacity margin. The position is feasible, and the loads are balanced, if they are so in
/// every case.
///
/// # Errors
/// A robot without mass or tension limits; a position where a cable has no direction; a moment required of a point mass, or a moment
/// of its weight; a solver that reached no answer.
pub fn wrench_of_scene_at(scene: &Scene, required: &Required, position: &Point) -> Result<WrenchReport, Error> {
    let margin = scene.wrench().and_then(|wrench| wrench.margin).unwrap_or(MarginSpec::Capacity);
    let cases = Statics::cases(scene, scene.orientation())?;
    let reports: Result<Vec<_>, Error> =
        cases.iter().map(|statics| wrench_at(statics, required, margin, position)).collect();
    let reports = reports?;
    let (feasible, balanced) = (reports.iter().all(|case| case.feasible), reports.iter().all(|case| case.balanced));
    let reports = reports.into_iter().zip(Loads::cases(scene));
    let worst = reports.min_by(|(a, _), (b, _)| a.capacity_margin.total_cmp(&b.capacity_margin));
    let (worst, loads) = worst.expect("a scene has a load case");
    let settling = Settling::of(scene.robot(), &loads, &Pose::new(*position, *scene.orientation()));
    Ok(WrenchReport { feasible, balanced, settling, ..worst })
}

/// A row of the wrench matrix with moments in metres.
fn metric_row(statics: &Statics, position: &Point, row: usize) -> Vec<f64> {
    statics.cables().iter().map(|cable| cable.column(position, 1.0)[row]).collect()
}

/// The lengths of the cables at one point of a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LengthRow {
    /// Distance along the path, m.
    pub s: f64,
    /// Index of the segment.
    pub segment: usize,
    /// Fraction of the segment, 0 to 1.
    pub at: f64,
    /// Position of the platform's origin, world, m.
    pub position: [f64; 3],
    /// Orientation of the platform as a quaternion w x y z, if it turns on its way.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub orientation: Option<[f64; 4]>,
    /// Length of each cable, m.
    pub lengths: Vec<f64>,
    /// What the winches are commanded.
    #[serde(flatten)]
    pub winches: Commands,
}

/// The cables at one point of a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TensionRow {
    /// Position and lengths.
    #[serde(flatten)]
    pub place: LengthRow,
    /// Rank of the wrench matrix; 0 if a cable has no direction.
    pub rank: usize,
    /// Tension of each cable, N; `None` if the loads cannot be balanced.
    pub tensions: Option<Vec<f64>>,
    /// Capacity margin, N; `None` if a cable has no direction; see [`capacity_limit`].
    pub capacity_margin: Option<f64>,
    /// Force margin, N; see [`force_limit`].
    pub force_margin: Option<f64>,
    /// Moment margin, N·m; see [`moment_limit`].
    pub moment_margin: Option<f64>,
}

impl TensionRow {
    /// The row of a place; statics and capacity margin must be those at the orientation of the platform there.
    ///
    /// # Errors
    /// The errors of [`Statics::tensions`].
    pub fn of(capacity: &CapacityMargin, place: LengthRow, reference: Option<&[f64]>) -> Result<Self, Error> {
        let (statics, position) = (capacity.statics(), Point::from(place.position));
        let finite = |margin: f64| margin.is_finite().then_some(margin);
        Ok(TensionRow {
            rank: statics.columns(&position).map_or(0, |columns| Span::of(&columns).rank()),
            tensions: statics.tensions(&mut TensionQp::default(), &position, reference)?,
            capacity_margin: finite(capacity.at(&position)),
            force_margin: force_limit(statics, &position).map(|limit| limit.margin),
            moment_margin: moment_limit(statics, &position).map(|limit| limit.margin),
            place,
        })
    }
}

/// Maximum number of rows along a path; more are probably due to a wrong unit.
const MOST_ROWS: f64 = 1e7;

/// A distance along a path, m, and the fraction of a segment where it is.
pub struct Mark {
    /// Distance along the path, m.
    pub s: f64,
    /// Index of the segment.
    pub segment: usize,
    /// Fraction of the segment, 0 to 1.
    pub at: f64,
}

/// Marks at even steps along segments of these lengths, m, and at their end.
///
/// # Errors
/// A step that is not positive or gives too many marks.
pub fn even_marks(lengths: &[f64], step: f64) -> Result<Vec<Mark>, Error> {
    let step = crate::model::body::positive("step", step)?;
    let mut starts = vec![0.0];
    for length in lengths {
        starts.push(starts[starts.len() - 1] + length);
    }
    let length = starts[starts.len() - 1];
    if length / step > MOST_ROWS {
        let problem = format!("found {step} m on a path of {length} m, which makes more than {MOST_ROWS:e} rows");
        return Err(Error::invalid("step", problem));
    }
    let whole = (length / step * (1.0 + STEP_COUNT)).floor() as usize;
    let mut ways: Vec<f64> = (0..=whole).map(|k| (k as f64 * step).min(length)).collect();
    if length - ways[whole] > step * STEP_COUNT {
        ways.push(length);
    }
    let mark = |s: f64| {
        let segment = starts[1..].partition_point(|&end| end < s).min(lengths.len().saturating_sub(1));
        let length = lengths.get(segment).copied().unwrap_or(0.0);
        let at = ((s - starts[segment]) / length).clamp(0.0, 1.0);
        Mark { s, segment, at: if at.is_nan() { 0.0 } else { at } }
    };
    Ok(ways.into_iter().map(mark).collect())
}

/// The smallest wrench margin along a path, and the range of tensions.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PathWrench {
    /// The smallest slack.
    pub min_wrench_margin: MarginPlace,
    /// Minimum and maximum, over all load cases, of the tensions that the robot keeps; `None` if there are none somewhere.
    pub tension_range: Option<TensionRange>,
}

/// The smallest slack on a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MarginPlace {
    /// Margin minus requirement, in the unit of its measure; `None` if a cable has no direction.
    pub value: Option<f64>,
    /// Index of the segment.
    pub segment: usize,
    /// Fraction of the segment, 0 to 1.
    pub at: f64,
    /// The limiting facet at this place.
    #[serde(flatten)]
    pub limit: WrenchLimit,
}

/// Minimum and maximum tension on a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TensionRange {
    /// The minimum tension.
    pub min: TensionPlace,
    /// The maximum tension.
    pub max: TensionPlace,
}

/// A tension on a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TensionPlace {
    /// The tension, N.
    pub value: f64,
    /// Name of the cable.
    pub cable: String,
    /// Index of the segment.
    pub segment: usize,
    /// Fraction of the segment, 0 to 1.
    pub at: f64,
}

impl TensionRange {
    /// The range of tensions at some places, given by segment and fraction; `None` if they are unknown at one of them.
    pub fn of(statics: &Statics, places: impl IntoIterator<Item = ((usize, f64), Option<Vec<f64>>)>) -> Option<Self> {
        let mut all = Vec::new();
        for ((segment, at), tensions) in places {
            let told = |(cable, value): (usize, f64)| (segment, at, cable, value);
            all.extend(tensions?.into_iter().enumerate().map(told));
        }
        let told = |&(segment, at, cable, value): &(usize, f64, usize, f64)| TensionPlace {
            value,
            cable: statics.cables()[cable].name.clone(),
            segment,
            at,
        };
        let min = all.iter().min_by(|a, b| a.3.total_cmp(&b.3)).map(told)?;
        let max = all.iter().max_by(|a, b| a.3.total_cmp(&b.3)).map(told)?;
        Some(TensionRange { min, max })
    }
}
