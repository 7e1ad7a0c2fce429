//! Trials of planners that the caller brings. The caller plans in [`trial_scene`](crate::trial_scene) with the trial's
//! [`trial_seed`]; the path is checked, processed and measured here like that of any other method.

use super::batch_tables::lines;
use super::experiment::Experiment;
use super::run::{Row, TrialRow, TrialStatus, decided_within, parts, row, trial_seed};
use cdpr_core::collision::Checker;
use cdpr_core::collision::path_check::{first_invalid_segment, path_length};
use cdpr_core::compiled::CompiledScene;
use cdpr_core::error::Error;
use cdpr_core::geometry::Point;
use cdpr_core::path::held;
use cdpr_core::plan::{PlanResult, Query, Route, Stats, post_process};
use cdpr_core::planning::{Milestone, Status};
use cdpr_core::proof::Answer;
use cdpr_core::tolerances::SAME_POINT;
use cdpr_core::watch::Watch;

/// What a planner has answered.
#[derive(Debug, Clone, PartialEq)]
pub struct Answered {
    /// How it ended.
    pub status: TrialStatus,
    /// The path of a solved trial, at least two positions, m.
    pub path: Vec<Point>,
    /// Time of the planner, s, if it ran.
    pub seconds: Option<f64>,
    /// When its path improved, if known.
    pub history: Vec<Milestone>,
}

/// The status of a trial whose planner need not run, as for the planners of cdpr: start or goal is not valid, or the scene
/// has no path and the method asks for this decision.
///
/// # Errors
/// No start or goal; the errors of the watch.
pub fn foregone(
    experiment: &Experiment,
    group: usize,
    compiled: &CompiledScene,
    watch: &Watch,
) -> Result<Option<Status>, Error> {
    let (scene, engine) = (compiled.scene(), compiled.level());
    let ends = Query::of(scene).ends()?;
    for (end, status) in ends.iter().zip([Status::StartInvalid, Status::GoalInvalid]) {
        if !engine.state_valid(end) {
            return Ok(Some(status));
        }
    }
    let proof = parts(experiment, group).2.options.proof;
    let answer = if proof { decided_within(scene, &Route::default(), engine, watch)? } else { None };
    Ok(matches!(answer, Some(Answer::NoPath(_))).then_some(Status::NoPath))
}

/// The rows of a trial as lines, and why its path is not valid, if it is not.
///
/// # Errors
/// [`Error::interrupted`]; a processed path that is not valid, which would be a bug in this program.
pub fn external_rows(
    experiment: &Experiment,
    (group, trial): (usize, usize),
    compiled: &CompiledScene,
    answered: &Answered,
    watch: &Watch,
) -> Result<(Vec<u8>, Option<String>), Error> {
    let (_, scenario, method) = parts(experiment, group);
    let Answered { status, path, seconds, history } = answered;
    let solved = *status == TrialStatus::Ended(Status::Solved);
    let problem = if solved { problem_of(compiled, path)? } else { None };
    let status = if problem.is_some() { TrialStatus::InvalidPath } else { *status };
    let planned = match status {
        TrialStatus::Ended(Status::Solved) => PlanResult {
            status: Status::Solved,
            raw_cost: path_length(path),
            raw_path: held(compiled.scene(), path),
            stats: Stats { planning_seconds: seconds.unwrap_or(0.0), ..Stats::default() },
            ..PlanResult::out_of_time()
        },
        _ => PlanResult::out_of_time(),
    };
    let mut rows = Vec::new();
    for (name, processing) in &method.variants {
        let found = post_process(compiled, &planned, processing, watch)?;
        let row = row(&scenario.name, name, trial, trial_seed(experiment, group, trial), &found);
        let result = TrialRow { status, nodes: None, motion_checks: None, ..row.result };
        rows.push(Row { result, planning_seconds: *seconds, ..row });
    }
    if experiment.layout.history && problem.is_none() {
        rows[0].history = history.clone();
    }
    Ok((lines(&rows)?, problem))
}

/// Why a path does not solve the trial, if it does not.
fn problem_of(compiled: &CompiledScene, path: &[Point]) -> Result<Option<String>, Error> {
    let [first, .., last] = path else {
        return Err(Error::invalid("waypoints", format!("found {}, expected at least two", path.len())));
    };
    let [start, goal] = Query::of(compiled.scene()).ends()?;
    for (what, end, wanted) in [("starts", first, start), ("ends", last, goal)] {
        if (end - wanted).norm() > SAME_POINT {
            let [found, wanted] = [end, &wanted].map(|p| format!("[{}, {}, {}]", p.x, p.y, p.z));
            return Ok(Some(format!("the path {what} at {found}, expected {wanted}")));
        }
    }
    let engine: &dyn Checker = compiled.level();
    Ok(first_invalid_segment(engine, path).map(|segment| {
        let reason = engine.explain(&path[segment], &path[segment + 1]);
        let why = reason.map(|violation| format!(": {}", violation.sentence())).unwrap_or_default();
        format!("segment {segment} of the path is not valid{why}")
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BatchFolder, BatchRows, RunOptions, experiment_from_text, trial_scene};
    use cdpr_files::text::Notation;

    const TEXT: &str = r#"{"version": 1, "trials": 2,
        "scenarios": [{"name": "hard1", "scene": "../../testdata/scenes/hard1.toml"}],
        "methods": [{"name": "mine", "planner": "python:module.plan", "post": "both"}, {"name": "modified RRT"}]}"#;

    #[test]
    fn paths_of_the_caller_fill_the_rows_that_a_run_leaves_empty() {
        let experiment = experiment_from_text(TEXT, Notation::Json, None).unwrap();
        let options = RunOptions { threads: Some(1), interrupted: &|| false, progress: &mut |_| {} };
        let mut groups = BatchRows::run(&experiment, 0..2, options).unwrap().into_groups();
        assert!(groups[0].is_empty() && !groups[1].is_empty());
        let scene = trial_scene(&experiment, 0, 0, &Watch::NONE).unwrap();
        let compiled = CompiledScene::new(&scene, Default::default(), Default::default(), &Watch::NONE).unwrap();
        assert_eq!(foregone(&experiment, 0, &compiled, &Watch::NONE).unwrap(), None);
        let [start, goal] = Query::of(&scene).ends().unwrap();
        let over = Point::new(0.52, 1.0, 1.78);
        for (trial, path) in [vec![start, goal], vec![start, over, goal]].into_iter().enumerate() {
            let answered =
                Answered { status: TrialStatus::Ended(Status::Solved), path, seconds: Some(1.0), history: Vec::new() };
            let (lines, problem) = external_rows(&experiment, (0, trial), &compiled, &answered, &Watch::NONE).unwrap();
            assert_eq!(problem.is_some(), trial == 0, "{problem:?}");
            groups[0].extend(lines);
        }
        let tables = BatchRows::new(&experiment, 0..2, groups).unwrap().tables().unwrap();
        let [mine, _] = &tables.summary.methods[..] else { panic!("{:?}", tables.summary.methods) };
        assert_eq!((mine.n, mine.solved, mine.statuses["invalid_path"]), (2, 1, 1));
        assert!(mine.cost.mean < mine.raw_cost.mean && mine.motion_checks.mean.is_none());
        assert_eq!(tables.summary.rules[0].planner, "module.plan");
    }

    #[test]
    fn a_folder_is_for_planners_of_cdpr() {
        let experiment = experiment_from_text(TEXT, Notation::Json, None).unwrap();
        let refused = BatchFolder::open("nowhere", &experiment, 0..2, false).unwrap_err().to_string();
        assert!(refused.contains("methods[0].planner: found the function \"module.plan\""), "{refused}");
    }

    #[test]
    fn statuses_have_names() {
        for status in
            [TrialStatus::Failed, TrialStatus::Unsolved, TrialStatus::InvalidPath, TrialStatus::Ended(Status::Solved)]
        {
            assert_eq!(TrialStatus::named(status.name()).unwrap(), status);
        }
        assert!(TrialStatus::named("solve").unwrap_err().to_string().contains("did you mean \"solved\""));
    }
}
