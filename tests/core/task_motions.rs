//! The timed motions of tasks: legs against motions in their scenes, the whole against its legs, and what cannot be timed.

use cdpr_core::compiled::CompiledScene;
use cdpr_core::error::ErrorClass;
use cdpr_core::model::{PositionSource, Scene, SceneSpec, TaskRowSpec};
use cdpr_core::task::{Task, TaskFile, TaskTiming, WholeMotion};
use cdpr_core::testing;
use cdpr_core::trajectory_file::{CornerKind, TrajectoryFile};
use cdpr_core::watch::Watch;
use cdpr_core::{MotionSpec, Recorded, Trajectory, TrajectoryRules, check_trajectory};

use crate::tasks::{NAMES, planned, rows, scene, spec};

fn timing() -> TaskTiming {
    let limits = MotionSpec { speed: Some(1.0), acceleration: Some(2.0), ..MotionSpec::default() };
    TaskTiming { limits, rate: None }
}

fn timed(scene: &Scene, timing: &TaskTiming) -> Task {
    planned(scene).timed(scene, timing, None, &|| false).unwrap()
}

fn whole(task: &Task) -> &WholeMotion {
    let motion = task.motion.as_ref().unwrap();
    motion
        .whole
        .as_ref()
        .unwrap_or_else(|| panic!("{:?}", motion.legs.iter().filter_map(|leg| leg.as_ref().err()).collect::<Vec<_>>()))
}

fn legs(task: &Task) -> Vec<&TrajectoryFile> {
    task.motion.as_ref().unwrap().legs.iter().map(|leg| leg.as_ref().unwrap()).collect()
}

#[test]
fn legs_are_timed_in_their_scenes_and_the_whole_is_one_after_another() {
    let scene = scene(spec());
    let task = timed(&scene, &timing());
    let (motions, all) = (legs(&task), whole(&task));
    let mut periods = 0;
    for (k, ((leg, plan), motion)) in task.legs.legs.iter().zip(&task.plans).zip(&motions).enumerate() {
        let compiled = CompiledScene::new(&leg.scene, Default::default(), Default::default(), &Watch::NONE).unwrap();
        let alone = Trajectory::new(&compiled, &plan.path, &timing().limits, &Watch::NONE).unwrap();
        assert_eq!(
            (motion.duration, motion.scene.fingerprint.as_str()),
            (alone.duration(), leg.scene.fingerprint().as_str())
        );
        let rules = TrajectoryRules { limits: timing().limits, ..TrajectoryRules::default() };
        let report = check_trajectory(&leg.scene, &Recorded::of(motion).unwrap(), &rules, &Watch::NONE).unwrap();
        assert!(report.valid && report.exact, "{k}: {:?}", report.faults);
        assert_eq!(all.starts[k], f64::from(periods) / 100.0);
        for (i, position) in motion.positions.iter().enumerate() {
            let at = periods as usize + i;
            // At a stop, the sample is the last one of the leg before.
            assert!((0..3).all(|axis| (all.file.positions[at][axis] - position[axis]).abs() < 1e-9));
            assert_eq!(all.file.times[at], at as f64 / 100.0);
        }
        periods += motion.times.len() as i32 - 1;
    }
    assert_eq!((all.file.times.len(), all.end), (periods as usize + 1, f64::from(periods) / 100.0));
    assert_eq!(all.file.duration, all.starts[6] + motions[6].duration);
    assert!((all.file.length - motions.iter().map(|motion| motion.length).sum::<f64>()).abs() < 1e-12);
    // It stops between legs, and says so.
    let stops: Vec<_> = all.file.corners.iter().filter(|corner| corner.kind == CornerKind::Stop).collect();
    for (leg, start) in task.legs.legs.iter().zip(&all.starts).skip(1) {
        let at = (start * 100.0).round() as usize;
        assert_eq!(all.file.velocities[at], [0.0; 3]);
        let here: [f64; 3] = leg.from.pose.position.into();
        assert!(stops.iter().any(|stop| all.file.waypoints[stop.waypoint] == here && stop.time <= *start), "{start}");
    }
    let most = motions.iter().map(|motion| motion.largest.unwrap().speed).fold(0.0, f64::max);
    assert_eq!(all.file.largest.unwrap().speed, most);
    let least = motions.iter().map(|motion| motion.nearest.as_ref().unwrap().value).fold(f64::INFINITY, f64::min);
    assert_eq!(all.file.nearest.as_ref().unwrap().value, least);
    assert!(all.file.curve.is_none() && all.file.tensions.is_none());
    // The file of the task says when.
    let file = TaskFile::of(&scene, &task, &NAMES);
    let keys = file.motion.unwrap();
    let when: Vec<(f64, Option<&str>)> = keys.actions.iter().map(|a| (a.time, a.pick.as_deref())).collect();
    let picked = [(1, Some("tower")), (2, None), (3, Some("crate")), (4, None), (5, Some("chest")), (6, None)];
    assert_eq!(when, picked.map(|(leg, pick)| (all.starts[leg], pick)));
    assert_eq!((keys.file.as_str(), keys.duration), ("motion.json", all.file.duration));
    let second = file.legs[1].motion.as_ref().unwrap();
    assert_eq!((second.start, second.end), (Some(all.starts[1]), Some(all.starts[1] + motions[1].duration)));
    assert_eq!((second.file.as_deref(), second.duration), (Some("leg-2-motion.json"), Some(motions[1].duration)));
}

#[test]
fn threads_change_nothing_and_an_interrupt_leaves_no_motion() {
    let scene = scene(spec());
    let file = |threads: usize| {
        let task = planned(&scene).timed(&scene, &timing(), Some(threads), &|| false).unwrap();
        serde_json::to_string(&whole(&task).file).unwrap()
    };
    assert_eq!(file(1), file(2));
    let stopped = planned(&scene).timed(&scene, &timing(), Some(1), &|| true).unwrap().motion.unwrap();
    assert!(stopped.whole.is_none() && stopped.legs.iter().all(|leg| leg == &Err("interrupted".to_string())));
}

#[test]
fn limits_of_the_scene_count_and_missing_ones_are_refused() {
    let mut own = spec();
    own.motion = Some(timing().limits);
    let (with, none) = (scene(own), TaskTiming::default());
    assert_eq!(whole(&timed(&with, &none)).file.times, whole(&timed(&scene(spec()), &timing())).file.times);
    let slower = TaskTiming { limits: MotionSpec { speed: Some(0.2), ..MotionSpec::default() }, rate: Some(50.0) };
    let slow = timed(&with, &slower);
    assert!(whole(&slow).file.duration > 40.0 && whole(&slow).file.rate == 50.0);
    let cell = scene(spec());
    let refused = |timing: TaskTiming| planned(&cell).timed(&cell, &timing, None, &|| false).unwrap_err();
    assert_eq!(refused(none).place(), Some("acceleration"));
    let wrong = |limits: MotionSpec, rate: Option<f64>| refused(TaskTiming { limits, rate });
    let negative = MotionSpec { speed: Some(-1.0), ..timing().limits };
    assert_eq!((wrong(negative, None).place(), wrong(negative, None).class()), (Some("speed"), ErrorClass::Input));
    assert_eq!(wrong(timing().limits, Some(1e9)).place(), Some("rate"));
    // Every leg has the rate that the one with the largest acceleration needs.
    let fast = MotionSpec { speed: Some(9.0), acceleration: Some(30.0), ..MotionSpec::default() };
    let fast = timed(&with, &TaskTiming { limits: fast, rate: None });
    assert!(legs(&fast).iter().all(|motion| motion.rate == 200.0) && whole(&fast).file.rate == 200.0);
}

#[test]
fn legs_without_a_path_have_no_motion_and_the_others_are_kept() {
    // Without a path there is no motion and no other reason.
    let direct = rows(&[("pick", "crate"), ("go", "table"), ("place", "crate"), ("go", "dock")]);
    let blocked = scene(SceneSpec { task: direct, ..spec() });
    let task = timed(&blocked, &timing());
    let motion = task.motion.as_ref().unwrap();
    let known: Vec<bool> = motion.legs.iter().map(Result::is_ok).collect();
    assert_eq!((known, motion.whole.is_none()), (vec![true, false, true], true));
    let file = TaskFile::of(&blocked, &task, &NAMES);
    assert!(file.motion.is_none() && file.legs[1].motion.as_ref().unwrap().reason.is_none());
    let first = file.legs[0].motion.as_ref().unwrap();
    assert!(first.file.is_some() && first.duration.is_some() && first.start.is_none());
}

#[test]
fn a_via_is_passed_without_a_stop_where_there_is_room_to_round_it() {
    let at = |place: [f64; 3]| Some(PositionSource::from(place));
    let row = TaskRowSpec::default();
    let task = vec![
        TaskRowSpec { go: at([0.5, 0.5, 1.0]), ..row.clone() },
        TaskRowSpec { via: at([1.0, 1.0, 1.0]), ..row.clone() },
        TaskRowSpec { go: at([1.5, 0.7, 1.0]), ..row },
    ];
    let scene = scene(SceneSpec { task, query: None, ..testing::empty().spec().clone() });
    let passing = |blend: f64| {
        let limits = MotionSpec { blend: Some(blend), ..timing().limits };
        let task = timed(&scene, &TaskTiming { limits, rate: None });
        let [leg] = legs(&task)[..] else { panic!("one leg") };
        (leg.corners[0].kind, leg.corners[0].deviation, leg.duration)
    };
    let (rounded, stopping) = (passing(0.05), passing(0.0));
    assert_eq!((rounded.0, stopping.0), (CornerKind::Rounded, CornerKind::Stop));
    assert!(rounded.1 <= 0.05 && rounded.2 < stopping.2);
}
