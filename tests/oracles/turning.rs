//! Motions with a turn: a motion that the engine calls free is walked in steps so small that no contact deeper than 1
//! µm is missed. Some poses are judged by the engine for translations at their own orientations, which shares only the
//! list of conditions with it. A motion that the engine refuses must come close to contact.
//!
//! `CDPR_VERIFY=n` runs n times as many cases (`make verify`).

use cdpr_core::collision::{Checker, Conditions, GjkEngine, Interference, Kind as Broken, Validity, Violation};
use cdpr_core::compiled::CompiledScene;
use cdpr_core::geometry::{Pose, PoseMotion, Rotation, Vector};
use cdpr_core::model::{MarginSpec, OrientationSource, SceneSpec, WrenchSpec};
use cdpr_core::planning::{StateSpace, TranslationSpace};
use cdpr_core::tolerances::GAP_TOLERANCE;
use cdpr_core::turning::TurningWrench;
use cdpr_core::wrench::measures;
use cdpr_core::{Scene, testing};
use cdpr_tests::scenes::{Kind, scene};
use cdpr_tests::{built_scene, compiled, direction, effort, rng, uniform};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// Largest gap at which a motion of at most 0.1 m and 5° may be refused although it is free, m.
const NEAR: f64 = 1e-4;

fn turned(scene: &Scene, orientation: &Rotation) -> GjkEngine {
    let quaternion = [orientation.w, orientation.i, orientation.j, orientation.k];
    let scene = scene.turned(OrientationSource::Quaternion(quaternion)).unwrap();
    GjkEngine::new(&scene, Interference::Exact).unwrap()
}

/// What a pose breaks by more than the tolerance, judged at its own orientation. Cables that cannot keep their distance at the
/// orientation of the scene need not keep it at others.
fn broken(scene: &Scene, engine: &CompiledScene, pose: &Pose) -> Vec<Violation> {
    let required = |found: &Violation| {
        let same = engine.conditions().list.iter().filter(|condition| {
            engine.conditions().kind(condition) == found.kind
                && engine.conditions().culprits(condition) == found.culprits
        });
        same.map(|condition| engine.conditions().required(condition).unwrap_or(0.0)).fold(f64::INFINITY, f64::min)
    };
    let found = turned(scene, &pose.orientation).violations(&pose.position, &pose.position).into_iter();
    let found = found.filter(|violation| match violation.kind {
        Broken::CableCable => violation.gap.unwrap() < required(violation) - 1e-6,
        _ => violation.margin.unwrap() < -1e-6,
    });
    found.collect()
}

/// Whether two cables have changed sides between two poses: the volume that they span changes its sign where they cross.
fn crossed(scene: &Scene, from: &Pose, to: &Pose) -> Option<[usize; 2]> {
    let cables = scene.robot().cables();
    let spanned = |pose: &Pose, i: usize, j: usize| {
        let [a, b] = [i, j].map(|k| pose.position + pose.orientation * cables[k].attachment.coords);
        let (p, q, w) = (a - cables[i].outlet, b - cables[j].outlet, cables[j].outlet - cables[i].outlet);
        let normal = p.cross(&q);
        let area = normal.norm_squared();
        // Where the lines come nearest, as shares of the cables.
        let [s, r] = [w.cross(&q).dot(&normal) / area, w.cross(&p).dot(&normal) / area];
        (w.dot(&normal), [s, r].iter().all(|share| (0.01..0.99).contains(share)))
    };
    let pairs = (0..cables.len()).flat_map(|i| (i + 1..cables.len()).map(move |j| [i, j]));
    let mut pairs = pairs.filter(|[i, j]| {
        let apart = |p: &nalgebra::Point3<f64>, q: &nalgebra::Point3<f64>| (p - q).norm() > 1e-6;
        apart(&cables[*i].outlet, &cables[*j].outlet) && apart(&cables[*i].attachment, &cables[*j].attachment)
    });
    pairs.find(|[i, j]| {
        let [(a, inside_a), (b, inside_b)] = [from, to].map(|pose| spanned(pose, *i, *j));
        a * b < 0.0 && inside_a && inside_b
    })
}

/// Deepest contact that a [`walk`] may step over, m.
const DEEPEST_MISSED: f64 = 1e-6;
/// Poses after which a walk along a contact gives up.
const MOST_POSES: usize = 5000;

/// Poses of a motion, so close to each other that nothing meets by more than [`DEEPEST_MISSED`] in between: what keeps a
/// distance stays apart until both bodies have moved by half of it. `None` after [`MOST_POSES`].
fn walk(engine: &CompiledScene, motion: &PoseMotion) -> Option<Vec<Walked>> {
    let Conditions { list, bodies, .. } = engine.conditions();
    let seen = motion.relative_to(engine.scene().orientation());
    let travel = (motion.to.position - motion.from.position).norm() + motion.angle * bodies.reach();
    let (mut walked, mut at) = (Vec::new(), 0.0);
    while at < 1.0 {
        let placed = seen.at(at);
        let room =
            list.iter().map(|condition| condition.details().slack_at(bodies, &placed)).fold(f64::INFINITY, f64::min);
        walked.push(Walked { pose: motion.at(at), room });
        at += 0.5 * (room.max(0.0) + DEEPEST_MISSED) / travel;
        if walked.len() == MOST_POSES {
            return None;
        }
    }
    walked.push(Walked { pose: motion.to, room: f64::INFINITY });
    Some(walked)
}

/// A pose of a [`walk`] and its smallest slack, m.
struct Walked {
    pose: Pose,
    room: f64,
}

/// Poses of a motion, besides the tightest, that are judged at their own orientations.
const JUDGED: u8 = 24;

/// Walks a motion that was called free, and judges its tightest pose and others at their own orientations. Whether the walk was
/// finished.
fn assert_free(scene: &Scene, engine: &CompiledScene, from: &Pose, to: &Pose, seed: u64) -> bool {
    let motion = from.toward(to);
    let free = |pose: &Pose| {
        let found = broken(scene, engine, pose);
        assert!(found.is_empty(), "seed {seed}: {from:?} to {to:?} is called free, but at {pose:?}: {found:?}");
    };
    (0..=JUDGED).for_each(|k| free(&motion.at(f64::from(k) / f64::from(JUDGED))));
    let Some(walked) = walk(engine, &motion) else { return false };
    let tightest = walked.iter().min_by(|a, b| a.room.total_cmp(&b.room)).unwrap();
    let room = tightest.room;
    assert!(room > -DEEPEST_MISSED, "seed {seed}: {from:?} to {to:?} is called free, but keeps {room}");
    free(&tightest.pose);
    for pair in walked.windows(2) {
        let crossing = crossed(scene, &pair[0].pose, &pair[1].pose);
        assert!(crossing.is_none(), "seed {seed}: {from:?} to {to:?} is called free, but cables {crossing:?} cross");
    }
    true
}

fn any_turn(rng: &mut ChaCha8Rng, angle: f64) -> Rotation {
    let axis = match rng.random_range(0..3) {
        0 => Vector::ith(rng.random_range(0..3), 1.0),
        _ => direction(rng),
    };
    Rotation::from_scaled_axis(axis * angle)
}

/// A pose that is valid, at the orientation of the scene or up to 30° from it; `None` if there seems to be none.
fn place(engine: &CompiledScene, rng: &mut ChaCha8Rng) -> Option<Pose> {
    let space = TranslationSpace::of(engine.conditions());
    (0..60).find_map(|_| {
        let angle = [0.0, uniform(rng, 0.0, 0.5)][rng.random_range(0..2)];
        let pose = Pose::new(space.sample(rng)?, any_turn(rng, angle) * engine.scene().orientation());
        engine.state_valid(&pose).then_some(pose)
    })
}

/// How many motions were judged.
#[derive(Debug, Default)]
struct Count {
    free: usize,
    /// Free, but along a contact: not walked to the end.
    unfinished: usize,
    refused: usize,
    /// Refused at more than [`NEAR`] among those of at most 0.1 m and 5°.
    far: usize,
}

impl Count {
    fn and(self, other: Count) -> Count {
        Count {
            free: self.free + other.free,
            unfinished: self.unfinished + other.unfinished,
            refused: self.refused + other.refused,
            far: self.far + other.far,
        }
    }
}

fn judged(scene: &Scene, seed: u64, motions: usize) -> Count {
    let mut rng = rng(seed);
    let engine = compiled(scene);
    let mut count = Count::default();
    for _ in 0..motions {
        let Some(from) = place(&engine, &mut rng) else { return count };
        let (length, angle) = (10f64.powf(uniform(&mut rng, -6.0, 0.0)), 10f64.powf(uniform(&mut rng, -6.0, 0.45)));
        let mut to =
            Pose::new(from.position + direction(&mut rng) * length, any_turn(&mut rng, angle) * from.orientation);
        if rng.random_bool(0.1) {
            to.orientation = Rotation::new_unchecked(-to.orientation.into_inner());
        }
        let mut valid = engine.motion_valid(&from, &to);
        assert_eq!(valid, engine.motion_valid(&to, &from), "seed {seed}: {from:?} to {to:?}: the way back differs");
        assert_eq!(valid, engine.violations(&from, &to).is_empty(), "seed {seed}: the explanation contradicts");
        if !valid && rng.random_bool(0.5) {
            // The longest free part: it ends next to contact.
            let whole = from.toward(&to);
            let (mut free, mut refused) = (0.0, 1.0);
            for _ in 0..30 {
                let middle = 0.5 * (free + refused);
                let part = engine.motion_valid(&from, &whole.at(middle));
                *(if part { &mut free } else { &mut refused }) = middle;
            }
            let (shorter, longer) = (whole.at(free), whole.at(refused));
            count.far += usize::from(refused_far_from_contact(&engine, &from, &longer));
            (to, valid) = (shorter, engine.motion_valid(&from, &shorter));
        }
        if valid {
            count.free += 1;
            count.unfinished += usize::from(!assert_free(scene, &engine, &from, &to, seed));
        } else {
            count.refused += 1;
            count.far += usize::from(refused_far_from_contact(&engine, &from, &to));
        }
    }
    count
}

/// Whether a short motion that was refused stays clear of contact.
fn refused_far_from_contact(engine: &CompiledScene, from: &Pose, to: &Pose) -> bool {
    let short = (to.position - from.position).norm() <= 0.1 && from.angle_to(to) <= 5f64.to_radians();
    let found = engine.violations(from, to);
    let clear = found.iter().all(|violation| violation.gap.unwrap() - violation.required.unwrap() > NEAR);
    short && clear && !found.is_empty()
}

/// Judges motions in so many scenes; at least so many of them must be free, and so many refused.
fn judge(first: u64, scenes: u64, motions: usize, [free, refused]: [usize; 2], scene: impl Fn(u64) -> Scene + Sync) {
    let one = |seed: u64| judged(&scene(first + seed), first + seed, motions);
    let count = (0..scenes * effort()).into_par_iter().map(one).reduce(Count::default, Count::and);
    eprintln!("{count:?}");
    assert!(count.free > free && count.refused > refused && count.far == 0, "{count:?}");
    assert!(count.unfinished * 1000 < count.free, "{count:?}");
}

#[test]
fn free_motions_meet_nothing() {
    judge(7 << 40, 200, 30, [200, 200], |seed| scene(&mut rng(seed), Kind::default()));
}

#[test]
fn free_motions_keep_clearances_and_limits() {
    judge(8 << 40, 200, 30, [200, 200], |seed| {
        let clearance = [0.001, 0.02, 0.1, 0.0][seed as usize % 4];
        let diameter = [0.0, 0.01, 0.05][seed as usize % 3];
        let kind = Kind { clearance, diameter, special: seed % 2 == 0, mixed: seed % 5 == 0 };
        scene(&mut rng(seed), kind)
    });
}

#[test]
fn free_motions_of_built_robots_meet_nothing() {
    let scenes = [testing::hard1(), testing::hard3(), built_scene("cogiro"), built_scene("forest")];
    let bare = scenes.map(|scene| Scene::new(SceneSpec { wrench: None, ..scene.spec().clone() }).unwrap());
    judge(0, 24, 10, [200, 10], |seed| bare[seed as usize % 4].clone());
}

#[test]
fn a_motion_without_a_turn_is_judged_alike_at_any_orientation() {
    for seed in 0..20 {
        let mut rng = rng(9 << 40 | seed);
        let scene = scene(&mut rng, Kind::default());
        let engine = compiled(&scene);
        let orientation = any_turn(&mut rng, 0.4) * engine.scene().orientation();
        let there = turned(&scene, &orientation);
        let space = TranslationSpace::of(there.conditions());
        for _ in 0..50 {
            let Some(ends) = space.sample(&mut rng).zip(space.sample(&mut rng)) else { break };
            let [from, to] = [ends.0, ends.1].map(|position| Pose::new(position, orientation));
            let (valid, exact) = (engine.motion_valid(&from, &to), there.motion_valid(&ends.0, &ends.1));
            assert!(exact || !valid, "seed {seed}: {from:?} to {to:?} is called free");
            if exact && !valid {
                let margins = engine.violations(&from, &to).iter().map(|v| v.margin.unwrap()).fold(0.0, f64::min);
                let near = engine.violations(&from, &to).iter().any(|v| v.gap.unwrap() - v.required.unwrap() < NEAR);
                assert!(near && margins > -GAP_TOLERANCE, "seed {seed}: {from:?} to {to:?} is refused");
            }
        }
    }
}

/// How much more than required the cables can exert at a pose, N, by definition at its own orientation.
fn slack(scene: &Scene, pose: &Pose) -> f64 {
    let quaternion = [pose.orientation.w, pose.orientation.i, pose.orientation.j, pose.orientation.k];
    let scene = scene.turned(OrientationSource::Quaternion(quaternion)).unwrap();
    let limits = measures(&scene).unwrap().into_iter().map(|measure| measure.limit(&pose.position).unwrap().margin);
    limits.fold(f64::INFINITY, f64::min)
}

#[test]
fn required_wrenches_are_kept_all_along_a_free_motion() {
    let cogiro = built_scene("cogiro");
    let projected = WrenchSpec { margin: Some(MarginSpec::Projected), ..cogiro.wrench().unwrap().clone() };
    let projected = Scene::new(SceneSpec { wrench: Some(projected), ..cogiro.spec().clone() }).unwrap();
    let mut count = [0; 2];
    for (scene, motions) in [(&cogiro, 150), (&projected, 20)] {
        let mut rng = rng(11);
        let wrench = TurningWrench::of(scene).unwrap().unwrap();
        let space = TranslationSpace::of(compiled(scene).conditions());
        for _ in 0..motions * effort() {
            let from = Pose::new(space.sample(&mut rng).unwrap(), any_turn(&mut rng, 0.1) * scene.orientation());
            let (length, angle) = (10f64.powf(uniform(&mut rng, -3.0, 0.5)), 10f64.powf(uniform(&mut rng, -3.0, 0.0)));
            let to =
                Pose::new(from.position + direction(&mut rng) * length, any_turn(&mut rng, angle) * from.orientation);
            let (kept, motion) = (wrench.keeps(&from, &to), from.toward(&to));
            let least = (0..=40).map(|k| slack(scene, &motion.at(f64::from(k) / 40.0))).fold(f64::INFINITY, f64::min);
            assert!(!kept || least > -1e-6, "{from:?} to {to:?} is called feasible, but lacks {least} N");
            assert!(kept || least < 10.0, "{from:?} to {to:?} is refused, but keeps {least} N");
            assert_eq!(kept, wrench.violation(&from, &to).is_none());
            count[usize::from(kept)] += 1;
        }
    }
    assert!(count.iter().all(|count| *count > 20), "{count:?}");
}
