//! The error type of the crate. An error means that the query was ill-posed; the ways in which a well-posed query can
//! end are not errors, see [`crate::planning::Status`].

use std::borrow::Cow;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

/// An error: what was found, where, and what was expected instead.
#[derive(Debug)]
pub struct Error {
    kind: Kind,
    file: Option<PathBuf>,
    source: Option<Box<dyn std::error::Error + Send + Sync>>,
}

#[derive(Debug)]
enum Kind {
    /// An invalid value; `place` is a key path such as `robot.cables[3].outlet`.
    Invalid { place: String, problem: String },
    /// A file that cannot be read or written.
    File { problem: String },
    /// The caller asked to stop.
    Interrupted,
    /// The time budget ran out before there was a result.
    OutOfTime,
    /// The program itself failed.
    Internal { problem: String },
}

/// Broad classes of errors, for callers that map them to exit statuses or exception types.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ErrorClass {
    /// Bad input: a value, a key, a shape.
    Input,
    /// A file could not be read or written.
    File,
    /// Stopped on request.
    Interrupted,
    /// The time budget ran out before there was a result.
    OutOfTime,
    /// A bug in the program, not in the input.
    Internal,
}

impl Error {
    fn of(kind: Kind) -> Self {
        Self { kind, file: None, source: None }
    }

    /// Bad input at `place` (a key path); `problem` states what was found and what is expected.
    pub fn invalid(place: impl Into<String>, problem: impl Into<String>) -> Self {
        let (place, problem) = (place.into(), problem.into());
        Self::of(Kind::Invalid { place, problem })
    }

    /// A file that cannot be read or written.
    pub fn file(path: &Path, problem: impl Into<String>) -> Self {
        Self { file: Some(path.to_path_buf()), ..Self::of(Kind::File { problem: problem.into() }) }
    }

    /// A file that the system refuses to read or write: `what` fails ("cannot be read"), and `cause` says why.
    pub fn system(path: &Path, what: &str, cause: std::io::Error) -> Self {
        let error = Self::file(path, format!("{what}: {cause}"));
        Self { source: Some(Box::new(cause)), ..error }
    }

    /// The caller asked to stop.
    pub fn interrupted() -> Self {
        Self::of(Kind::Interrupted)
    }

    /// The time budget ran out before there was a result.
    pub fn out_of_time() -> Self {
        Self::of(Kind::OutOfTime)
    }

    /// The program itself failed.
    pub fn internal(problem: impl Into<String>) -> Self {
        Self::of(Kind::Internal { problem: problem.into() })
    }

    /// Adds the name of the file with the bad input; keeps a file name that is already there. An interruption is in no file.
    pub fn in_file(mut self, path: &Path) -> Self {
        if self.class() != ErrorClass::Interrupted {
            self.file.get_or_insert_with(|| path.to_path_buf());
        }
        self
    }

    /// Replaces the place of a bad input, for example by the option that gave it.
    pub fn at(mut self, other: &str) -> Self {
        if let Kind::Invalid { place, .. } = &mut self.kind {
            *place = other.to_string();
        }
        self
    }

    /// Adds hints to the message for bad input.
    pub fn with_hints(mut self, hints: &[String]) -> Self {
        if let Kind::Invalid { problem, .. } | Kind::File { problem } = &mut self.kind {
            hints.iter().for_each(|hint| *problem += &format!("; {hint}"));
        }
        self
    }

    /// Prefixes the place of bad input: `robot` and `cables[3]` give `robot.cables[3]`.
    pub fn under(mut self, prefix: &str) -> Self {
        if let Kind::Invalid { place, .. } = &mut self.kind
            && self.file.is_none()
        {
            *place = if place.is_empty() { prefix.to_string() } else { format!("{prefix}.{place}") };
        }
        self
    }

    /// Takes a prefix off the place of bad input: `query.start` below `query` is `start`.
    pub fn below(mut self, prefix: &str) -> Self {
        if let Kind::Invalid { place, .. } = &mut self.kind
            && let Some(rest) = place.strip_prefix(prefix).and_then(|rest| rest.strip_prefix('.'))
        {
            *place = rest.to_string();
        }
        self
    }

    /// The key path of bad input, if it is known.
    pub fn place(&self) -> Option<&str> {
        match &self.kind {
            Kind::Invalid { place, .. } if !place.is_empty() => Some(place),
            _ => None,
        }
    }

    /// The broad class of this error.
    pub fn class(&self) -> ErrorClass {
        match self.kind {
            Kind::Invalid { .. } => ErrorClass::Input,
            Kind::File { .. } => ErrorClass::File,
            Kind::Interrupted => ErrorClass::Interrupted,
            Kind::OutOfTime => ErrorClass::OutOfTime,
            Kind::Internal { .. } => ErrorClass::Internal,
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(file) = &self.file {
            write!(f, "{}: ", printable(&file.to_string_lossy()))?;
        }
        match &self.kind {
            Kind::Invalid { place, problem } if place.is_empty() => f.write_str(&printable(problem)),
            Kind::Invalid { place, problem } => write!(f, "{}: {}", printable(place), printable(problem)),
            Kind::File { problem } => f.write_str(&printable(problem)),
            Kind::Interrupted => f.write_str("interrupted"),
            Kind::OutOfTime => f.write_str("the time budget ran out before there was a result"),
            Kind::Internal { problem } => {
                let version = env!("CARGO_PKG_VERSION");
                write!(f, "internal error: {}; this is a bug in cdpr, not in your files: ", printable(problem))?;
                write!(f, "please report it with this message, the command or call, and the version, {version}")
            }
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        self.source.as_deref().map(|source| source as _)
    }
}

/// Runs work and converts a panic in it to an error. Values that the work was modifying must not be used afterwards.
///
/// # Errors
/// Errors of the work; [`ErrorClass::Internal`] for a panic.
///
/// # Example
/// ```
/// use cdpr_core::{Error, ErrorClass, error::caught};
/// assert_eq!(caught(|| Ok::<_, Error>(1))?, 1);
/// let failed = caught(|| -> Result<(), Error> { panic!("index out of range") }).unwrap_err();
/// assert_eq!(failed.class(), ErrorClass::Internal);
/// # Ok::<(), Error>(())
/// ```
pub fn caught<T>(work: impl FnOnce() -> Result<T, Error>) -> Result<T, Error> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<&str>().map(|text| (*text).to_string());
        let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
        Err(Error::internal(text.unwrap_or_else(|| "panic".to_string())))
    })
}

/// Makes text from a file or a command line safe for a terminal: characters that could move the cursor, change colours
/// or reverse the writing direction are escaped as in JSON.
///
/// # Example
/// ```
/// use cdpr_core::error::printable;
/// assert_eq!(printable("a\u{1b}[2Jb\n"), "a\\u001b[2Jb\\u000a");
/// assert_eq!(printable("Säule 3"), "Säule 3");
/// ```
pub fn printable(text: &str) -> Cow<'_, str> {
    if !text.contains(unprintable) {
        return Cow::Borrowed(text);
    }
    let escaped = |c: char| if unprintable(c) { format!("\\u{:04x}", c as u32) } else { c.to_string() };
    Cow::Owned(text.chars().map(escaped).collect())
}

/// Control characters, line and paragraph separators, and marks that change the writing direction.
pub fn unprintable(c: char) -> bool {
    let turns = matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    c.is_control() || turns || matches!(c, '\u{2028}' | '\u{2029}')
}

/// The stem of a file name, made safe for messages.
pub fn name_of_file(path: &Path) -> Option<String> {
    let stem = path.file_stem()?.to_string_lossy().replace(unprintable, " ");
    Some(stem).filter(|stem| !stem.trim().is_empty())
}

/// Longest name for which typos are looked up: comparing takes quadratic time and memory.
const LONGEST_NAME: usize = 100;

/// The known name nearest to `found`, if it is near enough for `found` to be a typo.
pub fn nearest_name<'a>(found: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = found.chars().take(LONGEST_NAME + 1).count();
    known
        .into_iter()
        .filter(|name| length <= LONGEST_NAME && name.len() <= LONGEST_NAME)
        .map(|name| (strsim::damerau_levenshtein(found, name), name))
        .filter(|(distance, name)| *distance <= 2.max(name.chars().count() / 3))
        .min()
        .map(|(_, name)| name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_prefixed_from_outside_in() {
        let error = Error::invalid("outlet", "found NaN").under("cables[3]").under("robot");
        assert_eq!(error.to_string(), "robot.cables[3].outlet: found NaN");
        let error = error.in_file(Path::new("a.toml")).in_file(Path::new("b.toml"));
        assert_eq!(error.to_string(), "a.toml: robot.cables[3].outlet: found NaN");
    }

    #[test]
    fn system_errors_keep_their_source() {
        let refused = std::fs::File::open("no/such/file").unwrap_err();
        let error = Error::system(Path::new("no/such/file"), "cannot be read", refused);
        assert!(error.to_string().starts_with("no/such/file: cannot be read: "));
        let source = std::error::Error::source(&error).and_then(|source| source.downcast_ref::<std::io::Error>());
        assert_eq!(source.map(std::io::Error::kind), Some(std::io::ErrorKind::NotFound));
    }

    #[test]
    fn typos_get_suggestions_and_unknown_names_do_not() {
        assert_eq!(nearest_name("pilar", ["column", "pillar"]), Some("pillar"));
        assert_eq!(nearest_name("zebra", ["column", "pillar"]), None);
    }
}
