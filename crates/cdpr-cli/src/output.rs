//! Printing: results to standard output, talk to standard error, both without colours unless they are terminals. A reader
//! that has gone away is no error.

use std::io::Write;
use std::path::Path;

use anstyle::{AnsiColor, Style};
use cdpr_core::collision::Constraints;
use cdpr_core::geometry::Point;
use cdpr_core::{Error, Scene, io};

use crate::progress::writing;

/// What stands for standard input or output in the place of a file.
pub const STANDARD: &str = "-";

const GOOD: Style = AnsiColor::Green.on_default().bold();
const BAD: Style = AnsiColor::Red.on_default().bold();
const NOTE: Style = AnsiColor::Yellow.on_default();

/// How much is said beside the result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Talk {
    /// Nothing but errors.
    Quiet,
    /// What was written, what is special, what to do next.
    Usual,
    /// Also what was read, and how a search got on.
    Verbose,
}

/// Where a command prints.
#[derive(Debug, Clone, Copy)]
pub struct Console {
    talk: Talk,
    /// Standard output is taken by a file; results go where talk goes.
    taken: bool,
}

impl Console {
    /// With so much talk.
    pub fn new(talk: Talk) -> Self {
        Console { talk, taken: false }
    }

    /// The same, where this file may be standard output.
    pub fn beside(self, output: Option<&Path>) -> Self {
        Console { taken: self.taken || output.is_some_and(is_standard), ..self }
    }

    /// How much is said.
    pub fn talk(&self) -> Talk {
        self.talk
    }

    /// Prints a line of the result.
    pub fn result(&self, text: &str) {
        if self.taken {
            let _ = writeln!(anstream::stderr(), "{text}");
        } else {
            arrived(writeln!(anstream::stdout(), "{text}"));
        }
    }

    /// Says something that is not part of the result.
    pub fn say(&self, text: &str) {
        if self.talk >= Talk::Usual {
            let _ = writeln!(anstream::stderr(), "{text}");
        }
    }

    /// Says what only the curious want to know.
    pub fn detail(&self, text: &str) {
        if self.talk >= Talk::Verbose {
            let _ = writeln!(anstream::stderr(), "{text}");
        }
    }

    /// Says what is special.
    pub fn note(&self, text: &str) {
        self.say(&format!("{NOTE}note:{NOTE:#} {text}"));
    }

    /// Says what is special about a scene.
    pub fn notes(&self, constraints: &Constraints) {
        constraints.notes.iter().for_each(|note| self.note(note));
    }

    /// Says what went wrong; also where all else is quiet.
    pub fn error(&self, error: &Error) {
        let _ = writeln!(anstream::stderr(), "{BAD}cdpr:{BAD:#} {error}");
    }

    /// Writes a file, or standard output, and says so; `hint` is what to do with it.
    pub fn write(&self, path: &Path, contents: &[u8], hint: &str) -> Result<(), Error> {
        if is_standard(path) {
            let mut out = std::io::stdout();
            arrived(out.write_all(contents).and_then(|()| out.flush()));
            return Ok(());
        }
        let writing = writing();
        io::write_atomically(path, contents)?;
        drop(writing);
        self.wrote(path, hint);
        Ok(())
    }

    /// Says that a file was written.
    pub fn wrote(&self, path: &Path, hint: &str) {
        let gap = if hint.is_empty() { "" } else { " " };
        self.say(&format!("wrote {}{gap}{hint}", path.display()));
    }
}

/// Ends the program where a result was lost; but a reader that has gone away has seen enough.
fn arrived(written: std::io::Result<()>) {
    if let Err(error) = written
        && error.kind() != std::io::ErrorKind::BrokenPipe
    {
        Console::new(Talk::Quiet).error(&Error::invalid("standard output", format!("cannot be written: {error}")));
        std::process::exit(2);
    }
}

/// Whether standard input or output is meant.
pub fn is_standard(path: &Path) -> bool {
    path.as_os_str() == STANDARD
}

/// A word that means yes.
pub fn good(word: &str) -> String {
    format!("{GOOD}{word}{GOOD:#}")
}

/// A word that means no.
pub fn bad(word: &str) -> String {
    format!("{BAD}{word}{BAD:#}")
}

/// "1 obstacle", "3 obstacles".
pub fn count(number: usize, thing: &str) -> String {
    format!("{number} {thing}{}", if number == 1 { "" } else { "s" })
}

/// A position for people.
pub fn position(p: &Point) -> String {
    format!("({}, {}, {})", short(p.x), short(p.y), short(p.z))
}

/// A length for people, m: up to four decimals.
pub fn short(number: f64) -> String {
    let text = format!("{number:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

/// A force or moment for people, three decimals, never minus zero.
pub fn thousandths(number: f64) -> String {
    format!("{:.3}", (number * 1e3).round() / 1e3 + 0.0)
}

/// One line about a scene.
pub fn scene_line(scene: &Scene) -> String {
    let robot = scene.robot();
    let turned = scene.orientation_name().map_or(String::new(), |name| format!(", at \"{name}\""));
    format!(
        "{}: {} with {}, {}{turned}",
        scene.name(),
        robot.name(),
        count(robot.cables().len(), "cable"),
        count(scene.obstacles().len(), "obstacle")
    )
}
