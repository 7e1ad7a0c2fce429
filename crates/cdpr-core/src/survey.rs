//! Facts about a scene before planning: sizes, ranks, special pairs, how much of the workspace is free.

use std::sync::Arc;

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use serde::Serialize;

use crate::collision::{Checker, Condition, Engine, Exemption, Interference, Violation};
use crate::compiled::engine_within;
use crate::error::Error;
use crate::geometry::{Departure, Point, Pose, Rotation, Vector, wxyz};
use crate::model::{Cable, Envelope, Obstacle, Scene};
use crate::planning::{StateSpace, TranslationSpace};
use crate::watch::Watch;
use crate::wrench::{Hold, Loads, Settling};

/// Facts about a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Survey {
    /// Name of the scene.
    pub name: String,
    /// Name of the robot.
    pub robot: String,
    /// Number of cables.
    pub cables: usize,
    /// Number of convex parts of the platform.
    pub platform_parts: usize,
    /// Number of obstacles.
    pub obstacles: usize,
    /// Number of convex parts of the obstacles.
    pub obstacle_parts: usize,
    /// World-from-platform quaternion of this survey, w x y z.
    pub orientation: [f64; 4],
    /// Name of the orientation, if it has one.
    pub orientation_name: Option<String>,
    /// Names of the scene's orientations.
    pub orientations: Vec<String>,
    /// Smallest and largest coordinates of the positions at which the platform is inside the workspace, m; `None` if it
    /// does not fit.
    pub position_box: Option<[[f64; 3]; 2]>,
    /// Smallest and largest length of each cable over these positions, m; empty if there are none.
    pub cable_lengths: Vec<LengthRange>,
    /// How far each cable can be from a straight line from its outlet; empty if none can.
    pub cable_shapes: Vec<CableShapes>,
    /// The axis-aligned box around each obstacle.
    pub obstacle_boxes: Vec<ObstacleBox>,
    /// Smallest and largest rank of the wrench matrix over sampled positions.
    pub wrench_rank: Option<[usize; 2]>,
    /// Which motions the cables resist where the rank is smallest.
    pub hold: Option<Hold>,
    /// Pairs of cables that share an outlet or an attachment.
    pub sharing_pairs: Vec<[String; 2]>,
    /// Pairs of cables that cross at every position of the platform.
    pub always_crossing_pairs: Vec<[String; 2]>,
    /// Cables that end on an obstacle.
    pub outlets_on_obstacles: Vec<[String; 2]>,
    /// Share of the positions without self-interference (cable–cable, cable–platform).
    pub interference_free: Option<f64>,
    /// Share of the positions that are valid.
    pub valid: Option<f64>,
    /// Number of positions sampled.
    pub samples: usize,
    /// Why the start is invalid, if it is.
    pub start: Option<Violation>,
    /// Why the goal is invalid, if it is.
    pub goal: Option<Violation>,
    /// The scene's stations.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub stations: Vec<StationState>,
    /// How far the platform settles at the start, in the first load case, if the winches are commanded the lengths of taut cables.
    pub settling: Option<Settling>,
    /// Pairs that are exempt from the clearance of their kind.
    pub exempt: Vec<Exemption>,
    /// Further remarks about the scene.
    pub notes: Vec<String>,
}

/// Whether the platform can be at a station.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StationState {
    /// Name of the station.
    pub station: String,
    /// Why it is invalid, if it is.
    pub violation: Option<Violation>,
}

/// Lengths of a cable.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LengthRange {
    /// Name of the cable.
    pub cable: String,
    /// Smallest and largest length, m.
    pub length: [f64; 2],
}

/// Shapes of a cable.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CableShapes {
    /// Name of the cable.
    pub cable: String,
    /// How much lower than its chord it can hang, m.
    pub sag: f64,
    /// How far from its outlet it can leave the frame, m.
    pub exit: f64,
    /// Weight of the longest cable as a share of its tension; at most [`MOST_SLACKNESS`](crate::limits::MOST_SLACKNESS).
    pub slackness: f64,
}

/// Place and size of an obstacle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ObstacleBox {
    /// Name of the obstacle.
    pub obstacle: String,
    /// Smallest coordinates, m, world.
    pub min: [f64; 3],
    /// Largest coordinates, m, world.
    pub max: [f64; 3],
}

/// Positions sampled: enough for shares to within half a per cent.
const SAMPLES: usize = 20_000;
/// Number of positions at which the rank is computed.
const RANK_SAMPLES: usize = 200;
/// Positions between two checks of the watch: about a millisecond in scenes of thousands of bodies.
const AT_A_TIME: usize = 32;

/// Surveys a scene.
///
/// # Errors
/// The errors of [`engine_within`].
pub fn survey(scene: &Scene, watch: &Watch) -> Result<Survey, Error> {
    let engine = engine_within(scene, Engine::default(), Interference::Exact, watch)?;
    let conditions = engine.conditions();
    let space = TranslationSpace::of(conditions);
    let mut rng = ChaCha8Rng::seed_from_u64(0);
    let positions: Vec<Point> = (0..SAMPLES).map_while(|_| space.sample(&mut rng)).collect();
    let share = |test: &(dyn Fn(&Point) -> bool + Sync)| {
        let count = |some: &[Point]| {
            watch.check()?;
            Ok(some.iter().filter(|p| test(p)).count())
        };
        let counts: Result<Vec<usize>, Error> = positions.par_chunks(AT_A_TIME).map(count).collect();
        let share = counts?.iter().sum::<usize>() as f64 / positions.len() as f64;
        Ok::<_, Error>((!positions.is_empty()).then_some(share))
    };
    let hold = |p: &Point| Hold::at(scene.robot(), scene.orientation(), p);
    let holds: Vec<Hold> = positions.iter().take(RANK_SAMPLES).filter_map(hold).collect();
    let [least, most] = [holds.iter().min_by_key(|hold| hold.rank), holds.iter().max_by_key(|hold| hold.rank)];
    let turn = scene.orientation();
    let at = |p: Option<Point>| p.and_then(|p| engine.explain(&p, &p));
    Ok(Survey {
        name: scene.name().to_string(),
        robot: scene.robot().name().to_string(),
        cables: scene.robot().cables().len(),
        platform_parts: scene.robot().parts().len(),
        obstacles: scene.obstacles().len(),
        obstacle_parts: scene.obstacles().iter().map(|o| o.parts.len()).sum(),
        orientation: wxyz(turn),
        orientation_name: scene.orientation_name().map(str::to_string),
        orientations: scene.orientations().iter().map(|(name, _)| name.clone()).collect(),
        position_box: (!positions.is_empty()).then(|| [space.min.into(), space.max.into()]),
        cable_lengths: if positions.is_empty() { Vec::new() } else { cable_lengths(scene, space.min, space.max) },
        cable_shapes: cable_shapes(scene),
        obstacle_boxes: scene.obstacles().iter().map(obstacle_box).collect(),
        wrench_rank: least.zip(most).map(|(low, high)| [low.rank, high.rank]),
        hold: least.cloned(),
        sharing_pairs: sharing_pairs(scene),
        always_crossing_pairs: always_crossing(engine.as_ref()),
        outlets_on_obstacles: outlets_on_obstacles(scene),
        interference_free: share(&|p| engine.free_of_interference(p))?,
        valid: share(&|p| engine.state_valid(p))?,
        samples: positions.len(),
        start: at(scene.start()),
        goal: at(scene.goal()),
        stations: stations(scene, &*engine, watch)?,
        settling: scene
            .start()
            .and_then(|start| Settling::of(scene.robot(), &Loads::of(scene), &Pose::new(start, *turn))),
        exempt: conditions.exempt.clone(),
        notes: conditions.notes.clone(),
    })
}

/// The stations, each at its own orientation or else that of the scene, which `engine` is for.
fn stations(scene: &Scene, engine: &dyn Checker, watch: &Watch) -> Result<Vec<StationState>, Error> {
    let mut turned: Vec<(Rotation, Arc<dyn Checker>)> = Vec::new();
    let mut states = Vec::new();
    for station in scene.stations() {
        let own = station.orientation.filter(|turn| !scene.has_orientation(turn));
        if let Some(turn) = own.filter(|turn| !turned.iter().any(|(known, _)| known == turn)) {
            let scene = scene.turned(wxyz(&turn).into())?;
            turned.push((turn, engine_within(&scene, Engine::default(), Interference::Exact, watch)?));
        }
        let judge =
            own.and_then(|turn| turned.iter().find(|(known, _)| *known == turn)).map_or(engine, |(_, judge)| &**judge);
        let violation = judge.explain(&station.position, &station.position);
        states.push(StationState { station: station.name.clone(), violation });
    }
    Ok(states)
}

/// Lengths over a box of positions: the attachment of a cable then moves in a box of the same size.
fn cable_lengths(scene: &Scene, min: Point, max: Point) -> Vec<LengthRange> {
    let range = |cable: &Cable| {
        let attachment = scene.orientation() * cable.attachment.coords;
        if cable.pulley.is_some() {
            let length = lengths_round_pulley(cable, [min, max].map(|corner| corner + attachment));
            return LengthRange { cable: cable.name.clone(), length };
        }
        let [low, high] = [min, max].map(|corner| corner + attachment - cable.outlet);
        let least = low.sup(&-high).sup(&Vector::zeros()).norm();
        LengthRange { cable: cable.name.clone(), length: [least, low.abs().sup(&high.abs()).norm()] }
    };
    scene.robot().cables().iter().map(range).collect()
}

/// Smallest and largest length of a cable round its pulley, to attachments in a box that it reaches; the length is convex, so the
/// largest one is at a corner, and descent finds the smallest one. NaN if it reaches no corner.
fn lengths_round_pulley(cable: &Cable, [min, max]: [Point; 2]) -> [f64; 2] {
    let corner = |k: usize| Point::from(Vector::from_fn(|i, _| if k >> i & 1 == 0 { min[i] } else { max[i] }));
    let reached = || (0..8).map(corner).filter(|p| cable.departure(p).is_some());
    let most = reached().map(|p| cable.length_to(&p)).fold(f64::NAN, f64::max);
    let descend = |mut at: Point| {
        let mut share = 1.0;
        for _ in 0..DESCENT_STEPS {
            // The Hessian is at most the inverse of the free length, which may become smaller on the way.
            let Some(Departure { pull, free, .. }) = cable.departure(&at) else { break };
            let next = Point::from((at + share * free * pull).coords.sup(&min.coords).inf(&max.coords));
            if cable.length_to(&next) < cable.length_to(&at) {
                at = next;
            } else {
                share *= 0.5;
            }
        }
        cable.length_to(&at)
    };
    [reached().map(descend).fold(f64::NAN, f64::min), most]
}

/// Steps of a descent to the smallest length of a cable.
const DESCENT_STEPS: usize = 100;

fn cable_shapes(scene: &Scene) -> Vec<CableShapes> {
    let shapes = |(cable, envelope): (&Cable, &Option<Arc<Envelope>>)| {
        let envelope = envelope.as_ref()?;
        Some(CableShapes {
            cable: cable.name.clone(),
            sag: envelope.deepest(),
            exit: envelope.exit_error,
            slackness: envelope.sag.map_or(0.0, |sag| sag.slackness()),
        })
    };
    scene.robot().cables().iter().zip(scene.envelopes()).filter_map(shapes).collect()
}

fn obstacle_box(obstacle: &Obstacle) -> ObstacleBox {
    let around = obstacle.aabb();
    ObstacleBox { obstacle: obstacle.name.clone(), min: around.min.into(), max: around.max.into() }
}

fn sharing_pairs(scene: &Scene) -> Vec<[String; 2]> {
    let cables = scene.robot().cables();
    let near = |a: &Point, b: &Point| (a - b).norm() <= crate::tolerances::ON_SURFACE;
    let mut pairs = Vec::new();
    for (i, a) in cables.iter().enumerate() {
        for b in &cables[i + 1..] {
            if near(&a.outlet, &b.outlet) || near(&a.attachment, &b.attachment) {
                pairs.push([a.name.clone(), b.name.clone()]);
            }
        }
    }
    pairs
}

fn always_crossing(engine: &dyn Checker) -> Vec<[String; 2]> {
    let conditions = engine.conditions();
    let name = |i: usize| conditions.bodies.cables[i].name.clone();
    let pair = |c: &Condition| match c {
        Condition::CableCable(pair) if pair.always_crossing() => Some([name(pair.first), name(pair.second)]),
        _ => None,
    };
    conditions.list.iter().filter_map(pair).collect()
}

fn outlets_on_obstacles(scene: &Scene) -> Vec<[String; 2]> {
    let on = |cable: &Cable, obstacle: &Obstacle| {
        obstacle.parts.iter().any(|part| !part.active_normals(&cable.outlet).is_empty())
    };
    let cables = scene.robot().cables().iter();
    let pairs = cables.flat_map(|c| scene.obstacles().iter().filter(move |o| on(c, o)).map(move |o| (c, o)));
    pairs.map(|(cable, obstacle)| [cable.name.clone(), obstacle.name.clone()]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Pulley;
    use crate::testing::{empty, hard1};
    use rand::RngExt;

    /// Lengths at sampled positions lie within the range, which the corners of the box and the positions nearest to the outlets reach.
    #[test]
    fn lengths_of_cables_span_those_at_all_positions() {
        for scene in
            [hard1(), empty(), hard1().turned([0.9238795325112867, 0.0, 0.0, 0.3826834323650898].into()).unwrap()]
        {
            let survey = survey(&scene, &Watch::NONE).unwrap();
            let [min, max] = survey.position_box.unwrap().map(Point::from);
            for (cable, range) in scene.robot().cables().iter().zip(&survey.cable_lengths) {
                let attachment = scene.orientation() * cable.attachment.coords;
                let length = |p: Point| (p + attachment - cable.outlet).norm();
                let corners =
                    (0..8).map(|k| Point::from(Vector::from_fn(|i, _| if k >> i & 1 == 0 { min[i] } else { max[i] })));
                let nearest = (cable.outlet - attachment).coords.sup(&min.coords).inf(&max.coords);
                let [least, most] = range.length;
                assert!((length(nearest.into()) - least).abs() < 1e-12 && range.cable == cable.name);
                assert!((corners.map(length).fold(0.0, f64::max) - most).abs() < 1e-12);
                for k in 0..1000 {
                    let share = |step: f64| (f64::from(k) * step).fract();
                    let at = Vector::new(share(0.618), share(0.414), share(0.732)).component_mul(&(max - min));
                    assert!((least - 1e-12..=most + 1e-12).contains(&length(min + at)));
                }
            }
        }
    }
    #[test]
    fn lengths_round_pulleys_span_those_at_all_positions() {
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        let mut any = |size: f64| Vector::from_fn(|_, _| rng.random_range(-size..size));
        for k in 0..200 {
            let pulley = Pulley { radius: 0.02 + any(0.3).x.abs(), axis: any(1.0).normalize() };
            let cable = Cable { pulley: Some(pulley), ..empty().robot().cables()[k % 8].clone() };
            let middle = cable.outlet + any(1.0).normalize() * 1.5;
            let half = any(0.5).abs();
            let [least, most] = lengths_round_pulley(&cable, [middle - half, middle + half]);
            let place = |_| middle + any(1.0).component_mul(&half);
            let lengths: Vec<f64> = (0..2000).map(place).map(|p| cable.length_to(&p)).collect();
            if lengths.iter().any(|length| length.is_nan()) {
                continue;
            }
            let [low, high] =
                [lengths.iter().copied().fold(f64::NAN, f64::min), lengths.into_iter().fold(0.0, f64::max)];
            assert!(
                least <= low + 1e-6 && least > low - 0.2 && high <= most + 1e-12 && high > most - 0.3,
                "{least} {low} {high} {most}"
            );
        }
    }
}
