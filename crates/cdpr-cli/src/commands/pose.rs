//! `cdpr pose`, and the start of a plan from cable lengths.

use cdpr_core::error::printable;
use cdpr_core::geometry::{Pose, Rotation, wxyz, wxyz_in_turn};
use cdpr_core::kinematics::{ForwardKinematics, PoseEstimate};
use cdpr_core::model::{Joints, OrientationSource};
use cdpr_core::tolerances::START_RESIDUAL;
use cdpr_core::watch::Watch;
use cdpr_core::words::small_length;
use cdpr_core::{Choice, Error, Robot, Scene};
use cdpr_files::{CableLengths, PathFile};
use serde_json::{Value, json};

use super::post::save_path;
use crate::Answer;
use crate::args::{Format, PlanArgs, PoseArgs, place};
use crate::input;
use crate::output::{Console, count, position, short};
use crate::progress::with_progress;

/// A pose, and other poses with the same lengths.
type Found = (PoseEstimate, Vec<PoseEstimate>);

pub fn run(args: &PoseArgs, out: &Console) -> Result<Answer, Error> {
    let out = &out.beside(args.output.as_deref());
    input::only_one_stream(("robot", &args.robot), ("lengths", &args.lengths))?;
    let robot = input::robot(&args.robot)?;
    let given = input::lengths(&args.lengths, &robot)?;
    let found = with_progress(out, "solving", |stop| solve(args, &robot, &given, &Watch::on(stop)))?;
    match args.format {
        Format::Json => out.result(&format!("{:#}", json(&robot, &given, &found))),
        Format::Text => lines(&robot, &given, &found).iter().for_each(|line| out.result(line)),
    }
    notes(&given, &found).iter().for_each(|note| out.note(note));
    if let Some(path) = &args.output {
        save_path(path, &path_of(&found), out)?;
    }
    Ok(if found.iter().all(|(pose, _)| pose.is_determined()) { Answer::Yes } else { Answer::No })
}

fn solve(args: &PoseArgs, robot: &Robot, given: &CableLengths, watch: &Watch) -> Result<Vec<Found>, Error> {
    let solver = ForwardKinematics::new(robot, args.orientation).map_err(|e| e.in_file(&args.robot))?;
    let level = args.orientation.unwrap_or_else(Rotation::identity);
    let guess = place("--guess", args.guess.as_deref())?.map(|position| Pose::new(position, level));
    let in_file = |e: Error| e.in_file(input::name_of(&args.lengths));
    let in_line = |e: Error, row: usize| {
        let line = format!("line {}", given.lines[row]);
        match e.place().map(|cable| format!("{line}, {}", printable(cable))) {
            Some(place) => e.at(&place),
            None => e.under(&line),
        }
    };
    let poses = solver.follow(given.rows.iter().map(Vec::as_slice), guess, in_line, watch).map_err(in_file)?;
    let with_others = |(pose, lengths): (PoseEstimate, &Vec<f64>)| {
        watch.check()?;
        let others = solver.others(lengths, &pose)?;
        Ok((pose, others))
    };
    poses.into_iter().zip(&given.rows).map(with_others).collect()
}

fn json(robot: &Robot, given: &CableLengths, found: &[Found]) -> Value {
    let pose = |estimate: &PoseEstimate| {
        let (position, orientation) = (estimate.pose.position.coords.as_slice(), wxyz(&estimate.pose.orientation));
        json!({ "position": position, "orientation": orientation, "residuals": estimate.residuals })
    };
    let whole = |((estimate, others), line): (&Found, &u64)| {
        let mut json = pose(estimate);
        let covariance = estimate.covariance.map(|c| c.row_iter().map(|row| row.iter().copied().collect()).collect());
        json["line"] = json!(line);
        json["rank"] = json!(estimate.rank);
        json["full_rank"] = json!(estimate.full_rank);
        json["covariance"] = json!(covariance.map(|rows: Vec<Vec<f64>>| rows));
        json["iterations"] = json!(estimate.iterations);
        json["others"] = others.iter().map(pose).collect();
        json
    };
    let poses: Vec<Value> = found.iter().zip(&given.lines).map(whole).collect();
    json!({ "robot": robot.name(), "cables": robot.cable_names(), "joints": given.source.name(), "poses": poses })
}

fn lines(robot: &Robot, given: &CableLengths, found: &[Found]) -> Vec<String> {
    let source = match given.source {
        Joints::Length => "",
        Joints::Command => ", lengths from commands",
        Joints::Angle => ", lengths from angles",
    };
    let first = format!("{}: {}{source}", robot.name(), count(robot.cables().len(), "cable"));
    let row = |((estimate, others), line): (&Found, &u64)| {
        let fit = format!("line {line}: {}, {}", pose_words(&estimate.pose), residual_words(robot, estimate));
        let other =
            |other: &PoseEstimate| format!("  also: {}, {}", pose_words(&other.pose), residual_words(robot, other));
        std::iter::once(fit).chain(others.iter().map(other)).collect::<Vec<_>>()
    };
    std::iter::once(first).chain(found.iter().zip(&given.lines).flat_map(row)).collect()
}

fn pose_words(pose: &Pose) -> String {
    format!("{} at {}", position(&pose.position), wxyz(&pose.orientation).map(short).join(","))
}

fn residual_words(robot: &Robot, estimate: &PoseEstimate) -> String {
    let (cable, residual) = estimate.largest_residual();
    format!("residuals up to {} ({})", small_length(residual.abs()), robot.cables()[cable].name)
}

/// What the lengths leave open, each said once with the first line that it concerns.
fn notes(given: &CableLengths, found: &[Found]) -> Vec<String> {
    let lines = |concerned: &dyn Fn(&Found) -> bool| {
        let mut lines = found.iter().zip(&given.lines).filter(|(found, _)| concerned(found)).map(|(_, line)| line);
        let first = lines.next()?;
        let more = lines.count();
        Some(if more > 0 { format!("line {first} and {}", count(more, "other")) } else { format!("line {first}") })
    };
    let open = found.iter().find(|(estimate, _)| !estimate.is_determined());
    let rank = lines(&|(estimate, _)| !estimate.is_determined()).zip(open).map(|(lines, (estimate, _))| {
        let (rank, full) = (estimate.rank, estimate.full_rank);
        format!("{lines}: rank {rank} of {full}, so the lengths do not determine the pose")
    });
    let several = lines(&|(_, others)| !others.is_empty())
        .map(|lines| format!("{lines}: other poses have the same lengths; --guess X Y Z selects the one nearby"));
    rank.into_iter().chain(several).collect()
}

/// The poses as a path.
fn path_of(found: &[Found]) -> PathFile {
    PathFile {
        waypoints: found.iter().map(|(estimate, _)| estimate.pose.position.into()).collect(),
        orientations: Some(wxyz_in_turn(found.iter().map(|(estimate, _)| &estimate.pose.orientation))),
        ..PathFile::default()
    }
}

/// The arguments with the start that `--start-lengths` gives, and the scene at the orientation of the platform there if it
/// leaves the orientation open.
pub fn start_from_lengths(args: &PlanArgs, scene: Scene, out: &Console) -> Result<(PlanArgs, Scene), Error> {
    let Some(file) = &args.start_lengths else { return Ok((args.clone(), scene)) };
    let given = input::lengths(file, scene.robot())?;
    let in_file = |e: Error| e.in_file(input::name_of(file));
    let [lengths] = &given.rows[..] else {
        let found = count(given.rows.len(), "row");
        return Err(in_file(Error::invalid("", format!("found {found}, expected one: the lengths at the start"))));
    };
    let turns = args.query(&scene)?.turns();
    let candidates = match &args.start_orientation {
        Some(source) => vec![(None, Some(scene.named_orientation("--start-orientation", source)?))],
        None if turns => vec![(None, None)],
        None if scene.orientation_is_open() => {
            scene.orientations().iter().map(|(name, orientation)| (Some(name.clone()), Some(*orientation))).collect()
        }
        None => vec![(None, Some(*scene.orientation()))],
    };
    let of_robot = |e: Error| e.under("robot").in_file(input::name_of(&args.scene.scene));
    let ((start, others), name) = best(&scene, lengths, candidates, of_robot).map_err(in_file)?;
    let scene = name.map_or_else(|| Ok(scene.clone()), |name| scene.turned(OrientationSource::Named(name)))?;
    usable(scene.robot(), &start).map_err(in_file)?;
    out.say(&format!("start from lengths: {}, {}", pose_words(&start.pose), residual_words(scene.robot(), &start)));
    others.iter().for_each(|other| {
        out.note(&format!("the lengths also fit {}; --start X Y Z selects a start", pose_words(&other.pose)))
    });
    let mut args = args.clone();
    let goal = scene.spec().query.as_ref().and_then(|query| query.goal.clone());
    let scene = scene.between([Some(start.pose.position.into()), goal])?;
    if turns && args.start_orientation.is_none() {
        args.start_orientation = Some(OrientationSource::Quaternion(wxyz(&start.pose.orientation)));
    }
    Ok((args, scene))
}

/// The pose that fits the lengths best among those at orientations of a scene, with the name of the orientation; for `None`, the
/// orientation is to be found as well. `of_robot` adds the place to errors about the robot.
fn best(
    scene: &Scene,
    lengths: &[f64],
    candidates: Vec<(Option<String>, Option<Rotation>)>,
    of_robot: impl Fn(Error) -> Error,
) -> Result<(Found, Option<String>), Error> {
    let at = |(name, orientation): (Option<String>, Option<Rotation>)| {
        let hint = orientation.is_none().then(|| "or pass --start-orientation".to_string());
        let solver = ForwardKinematics::new(scene.robot(), orientation);
        let solver = solver.map_err(|e| of_robot(e.with_hints(hint.as_slice())))?;
        let found = solver.estimate(lengths, None)?;
        let others = solver.others(lengths, &found)?;
        Ok(((found, others), name))
    };
    let mut found = candidates.into_iter().map(at).collect::<Result<Vec<_>, Error>>()?;
    found.sort_by(|((a, _), _), ((b, _), _)| a.fit().total_cmp(&b.fit()));
    let fitting = found.iter().filter(|((pose, _), _)| pose.fits_as_well_as(&found[0].0.0));
    let names: Vec<String> = fitting.filter_map(|(_, name)| Some(printable(name.as_ref()?).into_owned())).collect();
    if names.len() > 1 {
        let problem =
            format!("found lengths that fit at {}, expected one of these; use --orientation NAME", names.join(" and "));
        return Err(Error::invalid("--start-lengths", problem));
    }
    Ok(found.swap_remove(0))
}

/// Refuses a start that the lengths leave open or do not fit.
fn usable(robot: &Robot, start: &PoseEstimate) -> Result<(), Error> {
    if !start.is_determined() {
        let problem = format!(
            "found lengths that do not determine the start: rank {} of {} at {}; expected --start X Y Z instead",
            start.rank,
            start.full_rank,
            pose_words(&start.pose)
        );
        return Err(Error::invalid("--start-lengths", problem));
    }
    let (cable, residual) = start.largest_residual();
    if residual.abs() <= START_RESIDUAL {
        return Ok(());
    }
    let problem = format!(
        "found a length of {} that is {} too {} at the best pose, {}; expected at most {}",
        printable(&robot.cables()[cable].name),
        small_length(residual.abs()),
        if residual > 0.0 { "long" } else { "short" },
        pose_words(&start.pose),
        small_length(START_RESIDUAL)
    );
    Err(Error::invalid("--start-lengths", problem))
}
