//! `cdpr check` of the motions of a task: each in the scene of its leg, and the one through all of them.

use std::path::{Path, PathBuf};

use cdpr_core::geometry::Pose;
use cdpr_core::model::spec::MotionSpec;
use cdpr_core::task::{ActionKeys, LegKeys, LegMotionKeys, TaskFile, WholeMotion, WholeMotionKeys, same_pose};
use cdpr_core::trajectory_check::{Recorded, TrajectoryReport, TrajectoryRules, check_trajectory};
use cdpr_core::trajectory_file::TrajectoryFile;
use cdpr_core::watch::{Interrupt, Watch};
use cdpr_core::{Error, Scene};
use cdpr_files::{check_whole, load_trajectory, scene_of_loaded};

use crate::args::CheckArgs;
use crate::output::Console;
use crate::progress::with_progress;

/// The motion of a leg and its report.
pub type LegMotion = (TrajectoryFile, TrajectoryReport);

/// Checks the motion of a leg, if it has one, under these limits. `path` is the path of the leg, and `place` its place in the task's file.
pub fn of_leg(
    (args, task): (&CheckArgs, &Path),
    limits: MotionSpec,
    (scene, path): (&Scene, &[Pose]),
    (place, keys): (&str, &LegKeys),
    out: &Console,
) -> Result<Option<LegMotion>, Error> {
    let Some(name) = keys.motion.as_ref().and_then(|motion| motion.file.as_ref()) else { return Ok(None) };
    let wrong = |problem: String| Err(Error::invalid(format!("{place}.motion.file"), problem).in_file(task));
    let file = beside(task, name);
    let loaded = load_trajectory(&file)?;
    let Some(contents) = &loaded.file else {
        return wrong(format!("found {name}, expected a trajectory as JSON"));
    };
    if !follows(contents, path) {
        return wrong(format!("found {name}, whose motion follows another path than that of the leg"));
    }
    let in_file = |e: Error| e.in_file(&file);
    let (scene, motion, warning) = scene_of_loaded(scene, &loaded, args.strict.strict).map_err(in_file)?;
    warning.iter().for_each(|warning| out.warning(&format!("{}: {warning}", file.display())));
    let named = args.tensions.tensions.or(motion.tension_distribution);
    let motion = Recorded { tension_distribution: named, ..motion };
    let rules = TrajectoryRules { limits, engine: args.checker.engine, interference: args.checker.interference };
    let check = |stop: &Interrupt| check_trajectory(&scene, &motion, &rules, &Watch::on(stop));
    let report = with_progress(out, "checking", check).map_err(|e| args.given.blamed(e, &file))?;
    Ok(Some((contents.clone(), report)))
}

fn beside(task: &Path, name: &str) -> PathBuf {
    task.parent().unwrap_or(Path::new("")).join(name)
}

/// Whether a motion says that it follows this path, and begins and ends where that does.
fn follows(motion: &TrajectoryFile, path: &[Pose]) -> bool {
    let told = motion.path();
    let poses = motion.poses();
    let [first, last] = [0, poses.len() - 1].map(|k| poses[k]);
    told.len() == path.len()
        && told.iter().zip(path).all(|(a, b)| same_pose(a, b))
        && same_pose(&first, &path[0])
        && same_pose(&last, &path[path.len() - 1])
}

/// Checks that the times in a task's file and the file of the motion through all legs follow from the motions of its legs.
pub fn of_whole(scene: &Scene, task: &Path, file: &TaskFile, legs: &[Option<LegMotion>]) -> Result<(), Error> {
    let complete: Option<Vec<&TrajectoryFile>> = legs.iter().map(|leg| leg.as_ref().map(|(file, _)| file)).collect();
    let whole = complete.map(|legs| WholeMotion::of(scene, &legs)).transpose().map_err(|e| e.in_file(task))?;
    let differs = |place: String, found: String, expected: String| {
        let problem = format!("found {found}, expected {expected} from the motions of the legs");
        Err(Error::invalid(place, problem).in_file(task))
    };
    match (&file.motion, &whole) {
        (Some(_), None) => {
            return differs("motion".to_string(), "one".to_string(), "none, since a leg has none,".to_string());
        }
        (None, Some(_)) => return differs("motion".to_string(), "none".to_string(), "one".to_string()),
        _ => {}
    }
    for (k, (keys, leg)) in file.legs.iter().zip(legs).enumerate() {
        let (Some(told), Some((motion, _))) = (&keys.motion, leg) else { continue };
        let start = whole.as_ref().map(|whole| whole.starts[k]);
        let expected = LegMotionKeys {
            file: told.file.clone(),
            reason: None,
            duration: Some(motion.duration),
            start,
            end: start.map(|start| start + motion.duration),
        };
        if *told != expected {
            return differs(format!("legs[{k}].motion"), json(told), json(&expected));
        }
    }
    let (Some(told), Some(whole)) = (&file.motion, whole) else { return Ok(()) };
    let before: Vec<Vec<ActionKeys>> = file.legs.iter().map(|leg| leg.before.clone()).collect();
    let expected = WholeMotionKeys::of(&whole, &told.file, &before, &file.after);
    if *told != expected {
        return differs("motion".to_string(), json(told), json(&expected));
    }
    check_whole(beside(task, &told.file), &whole.file)
}

fn json(keys: &impl serde::Serialize) -> String {
    serde_json::json!(keys).to_string()
}
