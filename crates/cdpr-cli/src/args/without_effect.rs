//! Options that would have no effect beside the others are errors: no option is passed over. Rules that depend on the contents of
//! files are at the commands that read them and use [`GivenOptions::refuse`](super::given_options::GivenOptions::refuse).

use cdpr_core::plan::Post;
use cdpr_core::tour::By;
use cdpr_core::{Choice, Error};

use super::{CheckArgs, Command, ExportArgs, NewArgs, PlanArgs, PostArgs, TaskArgs, TourArgs, ViewArgs, WrenchArgs};

/// The limits of motions.
pub const LIMITS: [&str; 10] = [
    "--speed",
    "--acceleration",
    "--turn-speed",
    "--turn-acceleration",
    "--jerk",
    "--cable-speed",
    "--cable-acceleration",
    "--blend",
    "--motion-clearance",
    "--wrench-margin",
];
/// Options that say how motions are checked.
const CHECKER: [&str; 2] = ["--engine", "--interference"];

impl Command {
    /// Refuses options without effect.
    ///
    /// # Errors
    /// The first option without effect: what it was given with, and where it has an effect.
    pub fn check_effects(&self) -> Result<(), Error> {
        match self {
            Command::Plan(args) => plan(args),
            Command::Post(args) => post(args),
            Command::Check(args) => check(args),
            Command::Export(args) => export(args),
            Command::View(args) => view(args),
            Command::Wrench(args) => wrench(args),
            Command::New(args) => new(args),
            Command::Task(args) => task(args),
            Command::Tour(args) => tour(args),
            Command::Info(_)
            | Command::Trajectory(_)
            | Command::Import(_)
            | Command::Schema(_)
            | Command::Shadows(_)
            | Command::Workspace(_)
            | Command::Pose(_)
            | Command::Batch(_)
            | Command::Merge(_)
            | Command::Report(_)
            | Command::Man(_)
            | Command::Completions(_) => Ok(()),
        }
    }
}

fn plan(args: &PlanArgs) -> Result<(), Error> {
    let given = &args.given;
    if args.trajectory.is_none() {
        let options = [&["--rate", "--joints", "--effort", "--minimise"], &LIMITS[..]].concat();
        given.refuse(&options, "without --trajectory", "--trajectory FILE, to which the motion is written")?;
    }
    let options = args.options()?;
    let (planner, post) = (options.planner.planner().name(), options.post());
    let found = format!("with --planner {planner} and --post {}", post.name());
    if !post.rewinds() {
        given.refuse(&["--repeats"], &found, REWINDING)?;
    }
    if !options.uses_step(args.settings.extend_step.is_some()) {
        let expected = format!("{REWINDING}, or --planner rrt or rrt-star without --extend-step");
        given.refuse(&["--step"], &found, &expected)?;
    }
    Ok(())
}

fn task(args: &TaskArgs) -> Result<(), Error> {
    match args.trajectory {
        None => args.given.refuse(
            &[&["--rate", "--joints", "--effort"], &LIMITS[..]].concat(),
            "without --trajectory",
            "--trajectory NAME, to which the motion is written",
        ),
        Some(_) => Ok(()),
    }
}

fn tour(args: &TourArgs) -> Result<(), Error> {
    match args.by {
        By::Length => args.given.refuse(&LIMITS, "with --by length", "--by time"),
        By::Time => Ok(()),
    }
}

/// Where the options of rewinding have an effect.
const REWINDING: &str = "--post both, backward, forward, backward-only or forward-only";

fn post(args: &PostArgs) -> Result<(), Error> {
    match args.post {
        Post::StringPulling => args.given.refuse(&["--step", "--repeats"], "with --post taut", REWINDING),
        _ => Ok(()),
    }
}

fn check(args: &CheckArgs) -> Result<(), Error> {
    match args.path {
        None => args.given.refuse(
            &[&LIMITS[..], &["--strict", "--start", "--goal", "--tensions"]].concat(),
            "with --at",
            "a file to check",
        ),
        Some(_) => args.given.refuse(&["--margin"], "with a file", "--at"),
    }
}

fn export(args: &ExportArgs) -> Result<(), Error> {
    match args.motion {
        None => args.given.refuse(&["--strict"], "without a motion", "a trajectory"),
        Some(_) => Ok(()),
    }
}

fn view(args: &ViewArgs) -> Result<(), Error> {
    match args.path {
        None => args.given.refuse(&[&CHECKER[..], &["--strict"]].concat(), "without a path", "a path or a trajectory"),
        Some(_) => Ok(()),
    }
}

fn wrench(args: &WrenchArgs) -> Result<(), Error> {
    let what = if args.at.is_some() { "with --at" } else { "with --grid" };
    if args.along.is_none() {
        args.given.refuse(&["--step", "--strict"], what, "--along PATH")?;
    }
    if args.at.is_some() {
        args.given.refuse(&["--output"], what, "--grid STEP or --along PATH")?;
    }
    if args.grid.is_some() {
        args.given.refuse(&["--tensions"], what, "--at X Y Z or --along PATH")?;
    }
    if args.grid.is_none() {
        let what = if args.at.is_some() { "with --at" } else { "with --along" };
        args.given.refuse(&["--projected"], what, "--grid STEP")?;
    }
    Ok(())
}

fn new(args: &NewArgs) -> Result<(), Error> {
    match (&args.output, &args.example_files) {
        (None, None) => args.given.refuse(&["--force"], "without a file", "a file to write"),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use clap::{CommandFactory, Parser};

    use super::*;
    use crate::args::Cli;

    /// The error of the rules about a command line.
    fn said(line: &str) -> String {
        let cli = Cli::try_parse_from(line.split(' ')).unwrap_or_else(|e| panic!("{line}: {e}"));
        cli.command.check_effects().err().map_or(String::new(), |e| e.to_string())
    }

    #[test]
    fn options_without_effect_are_refused_and_the_others_are_not() {
        let refused = [
            (
                "plan s.toml --rate 100",
                "--rate: found without --trajectory, where it has no effect; expected --trajectory FILE",
            ),
            ("plan s.toml --blend 0", "--blend: found without --trajectory, "),
            ("plan s.toml --effort", "--effort: found without --trajectory, "),
            ("plan s.toml --joints angle", "--joints: found without --trajectory, "),
            (
                "plan s.toml --step 0.1",
                "--step: found with --planner anytime and --post none, where it has no effect; ",
            ),
            (
                "plan s.toml --planner two-trees --repeats 1",
                "--repeats: found with --planner two-trees and --post taut, ",
            ),
            (
                "plan s.toml --planner rrt --extend-step 1 --post none --step 1",
                "--step: found with --planner rrt and --post none",
            ),
            (
                "plan s.toml --planner rrt --post taut --repeats 2",
                "--repeats: found with --planner rrt and --post taut, ",
            ),
            (
                "post s.toml p.csv --post taut --step 1",
                "--step: found with --post taut, where it has no effect; expected --post both",
            ),
            (
                "check s.toml --at 0 0 0 --jerk 1",
                "--jerk: found with --at, where it has no effect; expected a file to check",
            ),
            ("check s.toml p.csv --margin 0", "--margin: found with a file, where it has no effect; expected --at"),
            (
                "view s.toml -o v.html --strict",
                "--strict: found without a path, where it has no effect; expected a path or",
            ),
            ("view s.toml -o v.html --engine cspace", "--engine: found without a path, "),
            (
                "wrench s.toml --at 0 0 0 -o t.csv",
                "--output: found with --at, where it has no effect; expected --grid STEP or",
            ),
            (
                "wrench s.toml --at 0 0 0 --step 1",
                "--step: found with --at, where it has no effect; expected --along PATH",
            ),
            ("wrench s.toml --grid 1 -o m.npz --strict", "--strict: found with --grid, "),
            (
                "wrench s.toml --along p.csv --projected",
                "--projected: found with --along, where it has no effect; expected --grid",
            ),
            (
                "task s.toml -o t --speed 1",
                "--speed: found without --trajectory, where it has no effect; expected --trajectory NAME",
            ),
            ("tour s.toml --jerk 1", "--jerk: found with --by length, where it has no effect; expected --by time"),
            ("task s.toml -o t --effort", "--effort: found without --trajectory, "),
            ("new --force", "--force: found without a file, "),
        ];
        for (line, expected) in refused {
            let found = said(&format!("cdpr {line}"));
            assert!(found.starts_with(expected), "{line}: {found}");
        }
        let accepted = [
            "plan s.toml --trajectory m.csv --rate 100 --blend 0",
            "plan s.toml --planner rrt --step 0.1 --post taut",
            "plan s.toml --planner rrt --extend-step 1 --step 0.1 --repeats 2",
            "plan s.toml --post both --step 0.1 --repeats 2",
            "post s.toml p.csv --step 0.1 --repeats 3",
            "view s.toml p.csv -o v.html --strict --engine gjk",
            "wrench s.toml --grid 1 -o m.npz --projected",
            "wrench s.toml --along p.csv --step 1 --strict -o t.csv",
            "tour s.toml --by time --jerk 1",
            "task s.toml -o t --trajectory m.csv --rate 100 --blend 0",
            "new s.toml --force",
            "new --example-files examples --force",
        ];
        for line in accepted {
            assert_eq!(said(&format!("cdpr {line}")), "", "{line}");
        }
    }

    #[test]
    fn rules_name_options_that_exist() {
        let command = Cli::command();
        let known = |option: &str| {
            let of = |command: &clap::Command| command.get_arguments().any(|a| a.get_long() == Some(&option[2..]));
            command.get_subcommands().any(of)
        };
        assert!(LIMITS.iter().chain(&CHECKER).all(|option| known(option)));
    }
}
