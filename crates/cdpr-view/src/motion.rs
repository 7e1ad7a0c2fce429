//! The plots along a path or over time: cable lengths, clearances, wrench margins and tensions.

use serde::Serialize;

use super::extras::too_many_margins;
use super::xyz;
use cdpr_core::Choice;
use cdpr_core::batch::each;
use cdpr_core::collision::{
    Clearance, Condition, Conditions, Tightest, WrenchLimit, path_clearance, tightest_at_pose, tightest_of,
};
use cdpr_core::error::Error;
use cdpr_core::geometry::{Placed, Point, Pose};
use cdpr_core::model::{Distribution, Scene};
use cdpr_core::path::{self, length, positions};
use cdpr_core::tolerances::TOUCH_DEPTH;
use cdpr_core::turning::{pose_distance, turn_weight};
use cdpr_core::watch::Watch;
use cdpr_core::wrench::constraint::{limit_at, measures_at};
use cdpr_core::wrench::{Loads, Measure, Statics, TensionQp, measures};

/// Number of steps of the plots along a path: about one per pixel.
const STEPS: f64 = 300.0;

/// Numbers along a path or over time, one column per plot, rounded to a few more digits than a plot can show.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Motion {
    /// Distance along the path, m; for a trajectory, time, s.
    s: Vec<f32>,
    /// Length of each cable, m.
    lengths: Vec<Vec<f32>>,
    /// The tightest pairs of each group; groups without pairs are omitted.
    approaches: Vec<Approach>,
    /// Tension of each cable at rest, N, `None` where the loads cannot be balanced; empty for a trajectory, and if the
    /// robot has no mass or no tension limits.
    tensions: Vec<Vec<Option<f32>>>,
    /// Minimum and maximum tension of each cable, N.
    tension_limits: Vec<[f64; 2]>,
    /// Which tensions these are, unless they are those nearest to the middle.
    #[serde(skip_serializing_if = "Option::is_none")]
    distribution: Option<&'static str>,
    /// One per measure of a scene with `[wrench]`; empty for robots with so many cables that it would take too long.
    margins: Vec<Margins>,
}

impl Motion {
    /// The cable lengths alone, m, one row for each place.
    fn of_lengths(s: Vec<f32>, rows: Vec<Vec<f32>>) -> Self {
        Motion {
            s,
            lengths: by_cable(rows),
            approaches: Vec::new(),
            tensions: Vec::new(),
            tension_limits: Vec::new(),
            distribution: None,
            margins: Vec::new(),
        }
    }
}

/// Whether a condition belongs to a group.
type Belongs = fn(&Condition) -> bool;

/// The groups of pairs that are plotted apart: what can come near obstacles, and the robot's own neighbours.
const GROUPS: [(&str, Belongs); 2] = [
    ("obstacles", |condition| !condition.details().within_robot()),
    ("robot", |condition| condition.details().within_robot()),
];

/// The pair of a group with the smallest slack beyond its required gap, at each place.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Approach {
    of: &'static str,
    /// Gap of the tightest pair at each place, m.
    gap: Vec<f32>,
    /// Required gap of the tightest pair at each place, m.
    required: Vec<f32>,
    /// The tightest pair at each place, as an index into `pairs`.
    tightest: Vec<usize>,
    /// Names of the pairs that have the smallest slack somewhere.
    pairs: Vec<Vec<String>>,
    /// x, y, z of the nearest points of the pair's two members, one after the other, m; NaN where unknown.
    points: Vec<f32>,
}

/// A coordinate with the six digits that a picture needs, which keeps pages small.
fn short(x: f64) -> f32 {
    let unit = 10f64.powi(5 - x.abs().max(1e-30).log10().floor() as i32);
    ((x * unit).round() / unit) as f32
}

impl Approach {
    fn of(of: &'static str, found: Vec<Tightest>) -> Self {
        let mut approach =
            Approach { of, gap: vec![], required: vec![], tightest: vec![], pairs: vec![], points: vec![] };
        for Tightest { clearance: Clearance { value, required, culprits, .. }, points } in found {
            let known = approach.pairs.iter().position(|pair| *pair == culprits);
            // A gap that is kept to within the tolerance of the engines must not look violated.
            let kept = value >= required - TOUCH_DEPTH;
            approach.gap.push(if kept { value.max(required) } else { value } as f32);
            approach.required.push(required as f32);
            approach.tightest.push(known.unwrap_or(approach.pairs.len()));
            if known.is_none() {
                approach.pairs.push(culprits);
            }
            let ends = points.unwrap_or([Point::from([f64::NAN; 3]); 2]);
            approach.points.extend(ends.iter().flat_map(|p| xyz(p).map(short)));
        }
        approach
    }
}

/// Wrench margins along a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Margins {
    measure: &'static str,
    unit: &'static str,
    /// Margin beyond the required one, `None` where a cable has no direction.
    values: Vec<Option<f32>>,
}

/// The plots along a path; `None` for a path of length zero.
///
/// # Errors
/// The errors of [`Conditions::within`]; a tension solver that could not decide; [`Error::interrupted`], [`Error::out_of_time`].
pub(super) fn along_path(scene: &Scene, path: &[Pose], watch: &Watch) -> Result<Option<Motion>, Error> {
    let length = length(scene, path);
    if !(length > 0.0) {
        return Ok(None);
    }
    let (s, poses): (Vec<f32>, Vec<Pose>) = match scene.keeps_orientation(path) {
        true => places(scene, path, length, watch)?.into_iter().unzip(),
        false => turning_places(scene, path, length).into_iter().unzip(),
    };
    let mut motion = plots(scene, s, &poses, watch)?;
    // A robot without mass or tension limits has no tensions.
    if let Ok(statics) = Statics::of(scene) {
        motion.tensions = tensions(scene, &poses, watch)?;
        motion.tension_limits = statics.limits();
        motion.distribution = unusual(scene.robot().distribution());
    }
    Ok(Some(motion))
}

/// The name of tensions that are not the usual ones.
pub(super) fn unusual(distribution: Distribution) -> Option<&'static str> {
    (distribution != Distribution::default()).then(|| distribution.name())
}

/// The plots of a trajectory over time, without tensions, which the trajectory has itself.
///
/// # Errors
/// The errors of [`Conditions::within`]; [`Error::interrupted`], [`Error::out_of_time`].
pub(super) fn over_time(
    scene: &Scene,
    duration: f64,
    pose_at: impl Fn(f64) -> Pose,
    watch: &Watch,
) -> Result<Motion, Error> {
    let times = (0..=STEPS as usize).map(|k| duration * k as f64 / STEPS);
    let (s, poses): (Vec<f32>, Vec<Pose>) = times.map(|time| (time as f32, pose_at(time))).unzip();
    plots(scene, s, &poses, watch)
}

/// Places nearer to each other than this share of the path are plotted as one.
const SAME_PLACE: f64 = 1e-6;

/// The places at which a path without turns is plotted: at even steps, at its waypoints, and where the pairs of each
/// group come nearest to each other.
fn places(scene: &Scene, path: &[Pose], length: f64, watch: &Watch) -> Result<Vec<(f32, Pose)>, Error> {
    let mut starts = vec![0.0];
    starts.extend(path.windows(2).scan(0.0, |way, pair| {
        *way += (pair[1].position - pair[0].position).norm();
        Some(*way)
    }));
    // With a rank: of two at the same place the lower one is kept.
    let mut all: Vec<(f64, u8, Pose)> = Vec::new();
    for (segment, at) in nearest_places(scene, &positions(path), watch)? {
        let along = (path[segment + 1].position - path[segment].position) * at;
        all.push((starts[segment] + along.norm(), 0, path[segment].toward(&path[segment + 1]).at(at)));
    }
    all.extend(starts.iter().zip(path).map(|(s, pose)| (*s, 1, *pose)));
    all.extend(path::places(scene, path, length / STEPS)?.iter().map(|place| (place.s, 2, place.pose)));
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut kept: Vec<(f64, u8, Pose)> = Vec::new();
    for place in all {
        match kept.last_mut().filter(|last| place.0 - last.0 <= SAME_PLACE * length) {
            Some(last) if place.1 < last.1 => *last = place,
            Some(_) => {}
            None => kept.push(place),
        }
    }
    let last = kept.len() - 1;
    (kept[0].0, kept[last].0) = (0.0, length);
    Ok(kept.into_iter().map(|(s, _, pose)| (s as f32, pose)).collect())
}

/// The segment of the nearest approach of each group of pairs, and the fraction of it.
fn nearest_places(scene: &Scene, waypoints: &[Point], watch: &Watch) -> Result<Vec<(usize, f64)>, Error> {
    let conditions = Conditions::within(scene, watch)?;
    let mut found = Vec::new();
    for (_, of) in GROUPS {
        let within = |index: &usize| of(&conditions.list[*index]);
        let indices: Vec<usize> = (0..conditions.list.len()).filter(within).collect();
        let nearest = path_clearance(&conditions, &indices, waypoints, watch)?;
        found.extend(nearest.map(|(segment, clearance)| (segment, clearance.at)));
    }
    Ok(found)
}

/// The pairs of each group that come nearest at each pose.
fn approaches(scene: &Scene, poses: &[Pose], watch: &Watch) -> Result<Vec<Approach>, Error> {
    let conditions = Conditions::within(scene, watch)?;
    let held = scene.keeps_orientation(poses);
    let mut approaches = Vec::new();
    for (name, of) in GROUPS {
        let found = each(poses.len(), 0, &|(), k| {
            watch.check()?;
            Ok(match held {
                true => tightest_of(&conditions, &poses[k].position, of),
                false => tightest_at_pose(&conditions, &Placed::new(&poses[k], scene.orientation()), of),
            })
        })?;
        let found: Option<Vec<_>> = found.into_iter().collect();
        approaches.extend(found.filter(|found| !found.is_empty()).map(|found| Approach::of(name, found)));
    }
    Ok(approaches)
}

/// The places at which a path with turns is plotted: at even steps along each segment, waypoints included, with the
/// distance along the path, m.
fn turning_places(scene: &Scene, path: &[Pose], whole: f64) -> Vec<(f32, Pose)> {
    let (mut places, mut before) = (vec![(0.0, path[0])], 0.0);
    for pair in path.windows(2) {
        let (motion, length) = (pair[0].toward(&pair[1]), pose_distance(turn_weight(scene), &pair[0], &pair[1]));
        let steps = (length / whole * STEPS).ceil();
        let shares = (1..=steps as usize).map(|k| k as f64 / steps);
        places.extend(shares.map(|share| ((before + share * length) as f32, motion.at(share))));
        before += length;
    }
    places
}

/// Everything but tensions at these poses.
fn plots(scene: &Scene, s: Vec<f32>, poses: &[Pose], watch: &Watch) -> Result<Motion, Error> {
    let mut motion = Motion::of_lengths(s, poses.iter().map(|pose| lengths(scene, pose)).collect());
    motion.approaches = approaches(scene, poses, watch)?;
    motion.margins = margins(scene, poses, watch)?;
    Ok(motion)
}

/// The tensions of each cable at rest at poses.
fn tensions(scene: &Scene, poses: &[Pose], watch: &Watch) -> Result<Vec<Vec<Option<f32>>>, Error> {
    let (loads, held) = (Loads::of(scene), Statics::of(scene)?);
    let keeps = scene.keeps_orientation(poses);
    let found = each(poses.len(), 0, &|solver: &mut TensionQp, k| {
        watch.check()?;
        match keeps {
            true => held.tensions(solver, &poses[k].position, None),
            false => {
                let statics = Statics::new(scene.robot(), &loads.at(&poses[k].orientation))?;
                statics.tensions(solver, &poses[k].position, None)
            }
        }
    })?;
    Ok(tension_columns(scene.robot().cables().len(), found))
}

/// Tensions at each place as columns, one for each cable.
fn tension_columns(cables: usize, found: Vec<Option<Vec<f64>>>) -> Vec<Vec<Option<f32>>> {
    let row = |tensions: Option<Vec<f64>>| match tensions {
        Some(tensions) => tensions.into_iter().map(|tension| Some(tension as f32)).collect(),
        None => vec![None; cables],
    };
    by_cable(found.into_iter().map(row).collect())
}

/// A margin as plotted.
fn plotted(slack: f64) -> Option<f32> {
    Some(slack as f32).filter(|slack| slack.is_finite())
}

/// The margins at poses; `None` where a cable has no direction, or the loads turn a platform whose cables meet in one point.
fn margins(scene: &Scene, poses: &[Pose], watch: &Watch) -> Result<Vec<Margins>, Error> {
    let held = measures(scene)?;
    if too_many_margins(scene, poses.len()) {
        return Ok(Vec::new());
    }
    let keeps = scene.keeps_orientation(poses);
    let slacks = |measures: &[Measure], pose: &Pose| -> Vec<Option<f32>> {
        measures.iter().map(|measure| plotted(measure.slack(&pose.position))).collect()
    };
    let rows: Vec<Vec<Option<f32>>> = each(poses.len(), 0, &|(), k| {
        watch.check()?;
        Ok(match keeps {
            true => slacks(&held, &poses[k]),
            false => slacks(&measures_at(scene, &poses[k].orientation).unwrap_or_default(), &poses[k]),
        })
    })?;
    let along = |(k, measure): (usize, &Measure)| {
        let WrenchLimit { measure, unit, .. } = limit_at(measure, &poses[0].position);
        Margins { measure, unit, values: rows.iter().map(|row| row.get(k).copied().flatten()).collect() }
    };
    Ok(least_of_each(held.iter().enumerate().map(along)))
}

/// The margins of each measure, the smallest of all load cases.
fn least_of_each(all: impl IntoIterator<Item = Margins>) -> Vec<Margins> {
    let mut kept: Vec<Margins> = Vec::new();
    for margins in all {
        let Some(known) = kept.iter_mut().find(|known| known.measure == margins.measure) else {
            kept.push(margins);
            continue;
        };
        for (least, value) in known.values.iter_mut().zip(margins.values) {
            *least = least.zip(value).map(|(a, b)| a.min(b));
        }
    }
    kept
}

fn lengths(scene: &Scene, pose: &Pose) -> Vec<f32> {
    let length = |cable: &cdpr_core::model::Cable| {
        cable.length_to(&(pose.position + pose.orientation * cable.attachment.coords)) as f32
    };
    scene.robot().cables().iter().map(length).collect()
}

/// Rows with a number for each cable as columns.
fn by_cable<T: Clone>(rows: Vec<Vec<T>>) -> Vec<Vec<T>> {
    let cables = rows.first().map_or(0, Vec::len);
    (0..cables).map(|cable| rows.iter().map(|row| row[cable].clone()).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use cdpr_core::testing::hard1;

    /// The plots along a path at the orientation of a scene.
    fn motion(scene: &Scene, path: &[Point], watch: &Watch) -> Result<Option<Motion>, Error> {
        along_path(scene, &path::held(scene, path), watch)
    }

    #[test]
    fn plots_name_the_nearest_pair_and_end_with_the_path() {
        let found =
            motion(&hard1(), &[Point::new(0.3, 1.0, 0.3), Point::new(0.3, 1.0, 1.3)], &Watch::NONE).unwrap().unwrap();
        let count = found.s.len();
        assert!((301..=303).contains(&count) && found.s[count - 1] == 1.0 && found.s.is_sorted_by(|a, b| a < b));
        assert_eq!((found.lengths.len(), found.lengths[0].len()), (8, count));
        assert_eq!(found.approaches.iter().map(|approach| approach.of).collect::<Vec<_>>(), ["obstacles", "robot"]);
        for approach in &found.approaches {
            assert_eq!((approach.gap.len(), approach.points.len()), (count, 6 * count));
            assert!(approach.tightest.iter().all(|&k| approach.pairs[k].len() == 2));
            assert!(approach.required.iter().all(|&required| required == 0.0));
            for (gap, ends) in approach.gap.iter().zip(approach.points.chunks(6)) {
                let apart = (0..3).map(|k| (ends[k] - ends[k + 3]).powi(2)).sum::<f32>().sqrt();
                assert!((gap - apart).abs() < 2e-5, "{gap} {apart}");
            }
        }
        let (first, end) = (Point::new(0.225, 0.925, 0.275), found.lengths[0][0]);
        assert!((f64::from(end) - first.coords.norm()).abs() < 1e-6);
        assert!(found.tensions.iter().all(|cable| cable.iter().flatten().all(|t| (9.9..1000.1).contains(t))));
    }

    #[test]
    fn plots_show_gap_and_required_gap_of_the_tightest_pair() {
        use cdpr_core::model::{ClearancesSpec, PairClearanceSpec};
        let mut spec = hard1().spec().clone();
        spec.clearance = Some(0.02);
        let pair = PairClearanceSpec { between: ["cable 3".into(), "pillar".into()], clearance: 0.08 };
        spec.clearances = Some(ClearancesSpec { pairs: vec![pair], ..ClearancesSpec::default() });
        let path = [Point::new(0.3, 1.0, 0.3), Point::new(0.6, 1.0, 1.7)];
        let found = motion(&Scene::new(spec).unwrap(), &path, &Watch::NONE).unwrap().unwrap();
        let near = &found.approaches[0];
        let named = |k: usize| near.pairs[near.tightest[k]] == ["cable 3", "pillar"];
        for k in 0..found.s.len() {
            assert_eq!(near.required[k], if named(k) { 0.08 } else { 0.02 });
        }
        assert!((0..found.s.len()).any(named));
        assert!(found.approaches[1].required.iter().all(|required| *required == 0.02));
    }

    #[test]
    fn plots_with_turns_match_each_fixed_orientation() {
        use cdpr_core::geometry::{Rotation, Vector};
        let mut spec = hard1().spec().clone();
        spec.wrench = Some(cdpr_core::model::WrenchSpec::default());
        let scene = Scene::new(spec).unwrap();
        let yaw = |angle: f64| Rotation::from_scaled_axis(Vector::z() * angle);
        let poses =
            [(0.3, 0.0), (0.9, 0.3), (1.3, -0.1)].map(|(z, angle)| Pose::new(Point::new(0.3, 1.0, z), yaw(angle)));
        let found = along_path(&scene, &poses, &Watch::NONE).unwrap().unwrap();
        let places = turning_places(&scene, &poses, length(&scene, &poses));
        let count = places.len();
        let near = &found.approaches[0];
        assert_eq!((found.s.len(), near.gap.len(), found.tensions[7].len()), (count, count, count));
        assert!(poses.iter().all(|pose| places.iter().any(|(_, place)| place == pose)));
        for (k, (_, pose)) in places.iter().enumerate().step_by(25) {
            let digits = cdpr_core::geometry::wxyz(&pose.orientation);
            let turned = scene.turned(digits.into()).unwrap();
            let near_obstacles = GROUPS[0].1;
            let there = tightest_of(&Conditions::new(&turned).unwrap(), &pose.position, near_obstacles).unwrap();
            assert!((f64::from(near.gap[k]) - there.clearance.value).abs() < 1e-6);
            // Cables above each other come equally near to an upright pillar.
            assert_eq!(near.pairs[near.tightest[k]][1], there.clearance.culprits[1]);
            let slack = measures(&turned).unwrap()[0].slack(&pose.position);
            assert!((f64::from(found.margins[0].values[k].unwrap()) - slack).abs() < 1e-3);
            let statics = Statics::of(&turned).unwrap();
            let tensions = statics.tensions(&mut TensionQp::default(), &pose.position, None).unwrap();
            let (shown, tension) = (found.tensions[2][k], tensions.map(|tensions| tensions[2]));
            assert_eq!(shown.is_some(), tension.is_some());
            assert!(shown.zip(tension).is_none_or(|(a, b)| (f64::from(a) - b).abs() < 1e-3));
        }
        assert!(found.tensions[2].iter().flatten().count() > 0);
        assert_eq!(along_path(&scene, &poses[..1], &Watch::NONE).unwrap(), None);
    }

    #[test]
    fn a_zero_length_path_has_no_plots() {
        assert_eq!(motion(&hard1(), &[Point::origin(), Point::origin()], &Watch::NONE).unwrap(), None);
        assert_eq!(motion(&hard1(), &[], &Watch::NONE).unwrap(), None);
    }

    #[test]
    fn wrench_margins_are_plotted_where_they_are_demanded() {
        let path = [Point::new(0.3, 1.0, 0.3), Point::new(0.3, 1.0, 1.3)];
        assert_eq!(motion(&hard1(), &path, &Watch::NONE).unwrap().unwrap().margins, []);
        let mut spec = hard1().spec().clone();
        spec.wrench = Some(cdpr_core::model::WrenchSpec::default());
        let demanding = Scene::new(spec).unwrap();
        let [found] = &motion(&demanding, &path, &Watch::NONE).unwrap().unwrap().margins[..] else {
            panic!("one measure")
        };
        let [measure] = &measures(&demanding).unwrap()[..] else { panic!("one measure") };
        assert_eq!((found.measure, found.unit), ("capacity", "N"));
        assert_eq!(found.values[0], Some(measure.slack(&path[0]) as f32));
        assert_eq!(found.values.last(), Some(&Some(measure.slack(&path[1]) as f32)));
    }
}
