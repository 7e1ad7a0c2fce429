//! Which options the user gave, and the error for those that would have no effect.

use std::path::Path;

use cdpr_core::Error;
use clap::parser::ValueSource;
use clap::{ArgMatches, Args, Command, FromArgMatches};

/// The options on the command line, without defaults. In a struct of arguments, this is the first field: parsing takes the others
/// out.
#[derive(Debug, Clone, Default)]
pub struct GivenOptions(Vec<String>);

impl GivenOptions {
    /// Whether the option was given, such as `--step`.
    pub fn has(&self, option: &str) -> bool {
        let name = option.trim_start_matches('-').replace('-', "_");
        self.0.contains(&name)
    }

    /// Refuses options that would have no effect: `found` describes what they were given with, `expected` where they
    /// have an effect.
    ///
    /// # Errors
    /// The first of these options that was given.
    pub fn refuse(&self, options: &[&str], found: &str, expected: &str) -> Result<(), Error> {
        match options.iter().find(|option| self.has(option)) {
            Some(option) => {
                Err(Error::invalid(*option, format!("found {found}, where it has no effect; expected {expected}")))
            }
            None => Ok(()),
        }
    }
}

impl GivenOptions {
    /// The error with the name of the option that it concerns, if that was given, and otherwise with the file that
    /// contains the key.
    pub fn blamed(&self, error: Error, file: &Path) -> Error {
        match self.named(error) {
            (error, true) => error,
            (error, false) => error.in_file(file),
        }
    }

    /// The error with the name of the option that it concerns, and whether that option was given.
    pub fn named(&self, error: Error) -> (Error, bool) {
        let key = error.place().unwrap_or_default().trim_start_matches("--");
        let option = OTHER_NAMES.iter().find(|(other, _)| *other == key).map_or(key, |(_, option)| option);
        let option = format!("--{}", option.replace('_', "-"));
        let given = self.has(&option);
        (if given { error.at(&option) } else { error }, given)
    }
}

/// Keys whose option has another name.
const OTHER_NAMES: [(&str, &str); 2] = [("clearance", "motion_clearance"), ("tension_distribution", "tensions")];

impl FromArgMatches for GivenOptions {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let ids = matches.ids().map(clap::Id::as_str);
        let given = ids.filter(|id| matches.value_source(id) == Some(ValueSource::CommandLine));
        Ok(GivenOptions(given.map(str::to_string).collect()))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

impl Args for GivenOptions {
    fn augment_args(command: Command) -> Command {
        command
    }

    fn augment_args_for_update(command: Command) -> Command {
        command
    }
}
