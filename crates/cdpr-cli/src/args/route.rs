//! The goals and the via points of `plan`: options that may be given several times, with a position each.

use cdpr_core::geometry::Point;
use cdpr_core::model::{PositionSource, body};
use cdpr_core::plan::Route;
use cdpr_core::{Error, Scene};
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches, value_parser};

use super::values::{POSITION, position};

/// Goals and via points, as the words of each. Derived arguments would lose which words belong together.
#[derive(Debug, Clone, Default)]
pub struct RouteArgs {
    pub goals: Vec<Vec<String>>,
    pub via: Vec<Vec<String>>,
    pub goal_box: Option<Vec<f64>>,
}

impl RouteArgs {
    /// The only goal, if there is one.
    pub fn goal(&self) -> Option<&[String]> {
        match &self.goals[..] {
            [goal] => Some(goal),
            _ => None,
        }
    }

    /// Whether there are no via points, and one goal.
    pub fn is_plain(&self) -> bool {
        self.via.is_empty() && self.goals.len() < 2 && self.goal_box.is_none()
    }

    /// What the path passes, and where it may end; a single goal is that of the scene by now.
    ///
    /// # Errors
    /// Anything but positions and stations of the scene; the option is named.
    pub fn route(&self, scene: &Scene) -> Result<Route, Error> {
        let known = |option: &str, words: &[String]| -> Result<PositionSource, Error> {
            let source = position(option, words)?;
            scene.named_position(option, &source)?;
            Ok(source)
        };
        let all = |option: &str, given: &[Vec<String>]| {
            given.iter().map(|words| known(option, words)).collect::<Result<Vec<_>, _>>()
        };
        let corner = |numbers: &[f64]| body::point("--goal-box", Point::from_slice(numbers).into());
        let goal_box = self.goal_box.as_ref().map(|numbers| Ok([corner(&numbers[..3])?, corner(&numbers[3..])?]));
        let goals = if self.goals.len() > 1 { all("--goal", &self.goals)? } else { Vec::new() };
        Ok(Route { via: all("--via", &self.via)?, goals, goal_box: goal_box.transpose()? })
    }
}

fn positions(id: &'static str, help: &'static str) -> Arg {
    Arg::new(id)
        .long(id)
        .num_args(1..=3)
        .action(ArgAction::Append)
        .value_name(POSITION)
        .allow_negative_numbers(true)
        .help(help)
}

impl Args for RouteArgs {
    fn augment_args(command: Command) -> Command {
        command
            .arg(positions(
                "goal",
                "Goal instead of the scene's: the name of a station, or a position, m. Given several times, the path leads to the one \
                 with the shortest path",
            ))
            .arg(positions(
                "via",
                "Pass this station or position, m; given several times, one after the other. --seed, --max-samples and --gap are \
                 for each leg, --budget-ms is for all of them",
            ))
            .arg(
                Arg::new("goal_box")
                    .long("goal-box")
                    .num_args(6)
                    .value_name("M")
                    .value_parser(value_parser!(f64))
                    .allow_negative_numbers(true)
                    .conflicts_with("goal")
                    .help("End anywhere in this box, where the path is shortest: least x, y and z, then largest, m"),
            )
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for RouteArgs {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let given = |id: &str| {
            let occurrences = matches.get_occurrences::<String>(id).into_iter().flatten();
            occurrences.map(|words| words.cloned().collect()).collect()
        };
        let goal_box = matches.get_many::<f64>("goal_box").map(|numbers| numbers.copied().collect());
        Ok(RouteArgs { goals: given("goal"), via: given("via"), goal_box })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}
