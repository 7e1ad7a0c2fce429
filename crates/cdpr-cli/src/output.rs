//! Printing: results to standard output, other messages to standard error, both in colour only on a terminal. A closed
//! pipe is not an error.

use std::io::Write;
use std::path::Path;

use anstyle::{AnsiColor, Style};
use cdpr_core::collision::Conditions;
use cdpr_core::error::printable;
use cdpr_core::geometry::{Point, Rotation, wxyz};
use cdpr_core::{Error, Scene};

pub use cdpr_core::words::{count, thousandths};

use crate::interruption::writing;

/// The file name that means standard input or output.
pub const STANDARD: &str = "-";
/// Other names of standard output. If opened as files, they would be overwritten instead of appended to.
const STANDARD_OUTPUTS: [&str; 3] = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

const GOOD: Style = AnsiColor::Green.on_default().bold();
const BAD: Style = AnsiColor::Red.on_default().bold();
const NOTE: Style = AnsiColor::Yellow.on_default();

/// How much is printed besides the result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Talk {
    /// Only errors.
    Quiet,
    /// Files written, remarks, next steps.
    Usual,
    /// Also files read and the progress of the search.
    Verbose,
}

/// Where a command prints.
#[derive(Debug, Clone, Copy)]
pub struct Console {
    talk: Talk,
    /// A file is written to standard output, so results go to standard error.
    taken: bool,
}

impl Console {
    /// A console that prints this much.
    pub fn new(talk: Talk) -> Self {
        Console { talk, taken: false }
    }

    /// This console for a command that writes to `output`, which may be standard output.
    pub fn beside(self, output: Option<&Path>) -> Self {
        Console { taken: self.taken || output.is_some_and(is_standard_output), ..self }
    }

    /// How much is printed.
    pub fn talk(&self) -> Talk {
        self.talk
    }

    /// Prints lines of the result.
    pub fn result(&self, text: &str) {
        self.print(&printable_lines(text));
    }

    /// Prints an answer, its first words in colour.
    pub fn verdict(&self, Verdict { good, words, rest }: &Verdict) {
        let style = if *good { GOOD } else { BAD };
        self.print(&format!("{style}{words}{style:#}{}", printable_lines(rest)));
    }

    fn print(&self, text: &str) {
        if self.taken {
            let _ = writeln!(anstream::stderr(), "{text}");
        } else {
            arrived(writeln!(anstream::stdout(), "{text}"));
        }
    }

    /// Prints a message that is not part of the result.
    pub fn say(&self, text: &str) {
        self.tell(Talk::Usual, &printable_lines(text));
    }

    /// Prints details, only with `--verbose`.
    pub fn detail(&self, text: &str) {
        self.tell(Talk::Verbose, &printable_lines(text));
    }

    /// Prints a remark.
    pub fn note(&self, text: &str) {
        self.tell(Talk::Usual, &format!("{NOTE}note:{NOTE:#} {}", printable_lines(text)));
    }

    fn tell(&self, from: Talk, text: &str) {
        if self.talk >= from {
            let _ = writeln!(anstream::stderr(), "{text}");
        }
    }

    /// Prints a warning that casts doubt on the result, even with `--quiet`.
    pub fn warning(&self, text: &str) {
        let _ = writeln!(anstream::stderr(), "{BAD}warning:{BAD:#} {}", printable(text));
    }

    /// Prints remarks about a scene, except those about pairs exempt from a clearance.
    pub fn notes(&self, scene: &Scene, conditions: &Conditions) {
        self.in_brief(scene, &conditions.notes).iter().for_each(|note| self.note(note));
    }

    /// Prints all remarks about a scene, for commands whose result does not list exempt pairs.
    pub fn remarks(&self, scene: &Scene, conditions: &Conditions) {
        self.in_brief(scene, &conditions.remarks()).iter().for_each(|note| self.note(note));
    }

    /// Notes as they are printed: with `--verbose` every one, otherwise one in place of many that are alike.
    pub fn in_brief(&self, scene: &Scene, notes: &[String]) -> Vec<String> {
        if self.talk == Talk::Verbose {
            return notes.to_vec();
        }
        let mut brief = scene.in_brief(notes);
        if brief.len() < notes.len() {
            brief.push(format!("{} notes in all; -v prints each", notes.len()));
        }
        brief
    }

    /// Prints an error, even with `--quiet`.
    pub fn error(&self, error: &Error) {
        let _ = writeln!(anstream::stderr(), "{BAD}cdpr:{BAD:#} {error}");
    }

    /// Writes a file, or to standard output, and reports it; `hint` is what to do with the file.
    pub fn write(&self, path: &Path, contents: &[u8], hint: &str) -> Result<(), Error> {
        if is_standard_output(path) {
            let mut out = std::io::stdout();
            arrived(out.write_all(contents).and_then(|()| out.flush()));
            return Ok(());
        }
        self.save(path, hint, || cdpr_files::write_atomically(path, contents))
    }

    /// Writes a file by a function, and reports it.
    pub fn save(&self, path: &Path, hint: &str, save: impl FnOnce() -> Result<(), Error>) -> Result<(), Error> {
        // Writing to a pipe may block, and no partial file is left there if the program ends meanwhile.
        let writing = (!cdpr_files::is_stream(path)).then(writing);
        save()?;
        drop(writing);
        let gap = if hint.is_empty() { "" } else { " " };
        self.say(&format!("wrote {}{gap}{hint}", path.display()));
        Ok(())
    }
}

/// Ends the program with an error if a result could not be written, but not if the reader closed the pipe.
fn arrived(written: std::io::Result<()>) {
    if let Err(error) = written
        && error.kind() != std::io::ErrorKind::BrokenPipe
    {
        Console::new(Talk::Quiet).error(&Error::invalid("standard output", format!("cannot be written: {error}")));
        std::process::exit(2);
    }
}

/// A path for JSON, which is limited to Unicode.
pub fn lossy(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}

/// Prints help or the version, with lines no wider than the terminal.
pub fn print_help(help: &clap::builder::StyledStr) {
    let lines = help.ansi().to_string();
    let text: String = lines.split_inclusive('\n').map(|line| wrapped(line, columns())).collect();
    arrived(write!(anstream::stdout(), "{text}").and_then(|()| std::io::stdout().flush()));
}

/// Width of the terminal as determined by clap, which does not wrap the usage line and option names.
fn columns() -> usize {
    let named = || std::env::var("COLUMNS").ok()?.parse().ok();
    let width = terminal_size::terminal_size().map(|(width, _)| usize::from(width.0));
    width.or_else(named).unwrap_or(100)
}

/// Wraps a line, possibly with colours, between words.
fn wrapped(line: &str, width: usize) -> String {
    let wide = |text: &str| anstream::adapter::strip_str(text).to_string().trim_end().chars().count();
    if wide(line) <= width {
        return line.to_string();
    }
    let indent = " ".repeat(line.len() - line.trim_start_matches(' ').len() + 2);
    let mut rows = vec![String::new()];
    for word in line.split_inclusive(' ') {
        let row = rows.last_mut().expect("there is one");
        let longer = format!("{row}{word}");
        if !row.trim().is_empty() && wide(&longer) > width.max(wide(row)) {
            rows.push(format!("{indent}{word}"));
        } else {
            *row = longer;
        }
    }
    rows.iter().map(|row| row.trim_end_matches(' ')).collect::<Vec<_>>().join("\n")
}

/// Whether this is `-`.
pub fn is_dash(path: &Path) -> bool {
    path.as_os_str() == STANDARD
}

/// Whether standard output is meant.
pub fn is_standard_output(path: &Path) -> bool {
    is_dash(path) || STANDARD_OUTPUTS.iter().any(|name| path.as_os_str() == *name)
}

/// Whether output goes to standard output, a pipe or a device, which have no extension to select the format.
pub fn is_stream(path: &Path) -> bool {
    is_standard_output(path) || (path.extension().is_none() && cdpr_files::is_stream(path))
}

/// Makes lines of text safe for a terminal, whatever names and paths they contain.
fn printable_lines(text: &str) -> String {
    let keep = |c: char| c == '\n' || c == '\t';
    text.split_inclusive(keep)
        .map(|line| match line.strip_suffix(keep) {
            Some(start) => format!("{}{}", printable(start), &line[start.len()..]),
            None => printable(line).into_owned(),
        })
        .collect()
}

/// An answer whose first words are coloured by yes or no.
pub struct Verdict {
    pub good: bool,
    pub words: &'static str,
    pub rest: String,
}

impl Verdict {
    pub fn yes(words: &'static str, rest: String) -> Self {
        Verdict { good: true, words, rest }
    }

    pub fn no(words: &'static str, rest: String) -> Self {
        Verdict { good: false, words, rest }
    }
}

/// A position as readable text.
pub fn position(p: &Point) -> String {
    format!("({}, {}, {})", short(p.x), short(p.y), short(p.z))
}

/// A length as readable text, m: up to four decimals, never minus zero.
pub fn short(number: f64) -> String {
    let text = format!("{number:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_string() } else { text.to_string() }
}

/// An angle as readable text.
pub fn degrees(angle: f64) -> String {
    format!("{:.1}°", angle.to_degrees())
}

/// An orientation of the scene as readable text: its name, or its quaternion.
pub fn orientation(scene: &Scene, orientation: &Rotation) -> String {
    let numbers = || wxyz(orientation).map(short).join(",");
    scene.name_of_orientation(orientation).map_or_else(numbers, |name| format!("{name:?}"))
}

/// One line about a scene.
pub fn scene_line(scene: &Scene) -> String {
    let turned = scene.orientation_name().map_or(String::new(), |name| format!(", at \"{name}\""));
    format!("{}{turned}", robot_line(scene))
}

/// One line about a scene without its orientation.
pub fn robot_line(scene: &Scene) -> String {
    let robot = scene.robot();
    format!(
        "{}: {} with {}, {}",
        scene.name(),
        robot.name(),
        count(robot.cables().len(), "cable"),
        count(scene.obstacles().len(), "obstacle")
    )
}
