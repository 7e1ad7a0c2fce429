//! Text files: reading with the file named in every error, writing beside and renaming, TOML or JSON by extension.

use std::ffi::OsStr;
use std::fs::File;
use std::io::{Read, Write};
use std::path::Path;

use serde::Serialize;
use serde::de::DeserializeOwned;
use tempfile::NamedTempFile;

use crate::error::{Error, nearest_name};
use crate::numerics::{MOST_TABLE_BYTES, MOST_TEXT_BYTES};

/// How many files of a folder are looked at for a name like that of a missing one.
const MANY_FILES: usize = 10_000;

/// What the names of temporary files begin with.
const TEMPORARY: &str = ".cdpr-";

/// The two notations of structured files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Notation {
    /// `.toml`
    Toml,
    /// `.json`
    Json,
}

impl Notation {
    /// By the file's extension.
    pub fn of(path: &Path) -> Result<Self, Error> {
        match path.extension().and_then(|e| e.to_str()) {
            Some("toml") => Ok(Notation::Toml),
            Some("json") => Ok(Notation::Json),
            other => Err(Error::file(path, format!("found the extension {}, expected .toml or .json", shown(other)))),
        }
    }
}

/// An extension as it reads in a message.
pub(super) fn shown(extension: Option<&str>) -> String {
    extension.map_or("(none)".to_string(), |e| format!(".{e}"))
}

/// The whole file as text, up to [`MOST_TEXT_BYTES`].
///
/// # Errors
/// A file that cannot be read, is larger, no ordinary file, or no text in UTF-8.
pub fn read(path: &Path) -> Result<String, Error> {
    read_at_most(path, MOST_TEXT_BYTES)
}

/// What to say of a file that cannot be read; of one that is missing, which name beside it is near.
fn unreadable(path: &Path, error: &std::io::Error) -> Error {
    let near = (error.kind() == std::io::ErrorKind::NotFound).then(|| near_file(path)).flatten();
    let hint = near.map(|name| format!("; did you mean {}?", path.with_file_name(name).display())).unwrap_or_default();
    Error::file(path, format!("cannot be read: {error}{hint}"))
}

fn near_file(path: &Path) -> Option<String> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let names =
        std::fs::read_dir(folder).ok()?.take(MANY_FILES).filter_map(|entry| entry.ok()?.file_name().into_string().ok());
    let mut names: Vec<String> = names.filter(|name| !name.starts_with('.')).collect();
    names.sort();
    nearest_name(path.file_name()?.to_str()?, names.iter().map(String::as_str)).map(str::to_string)
}

/// All of a stream as text, up to [`MOST_TEXT_BYTES`]; `name` stands for it in messages.
///
/// # Errors
/// A stream that cannot be read, holds more, or no text in UTF-8.
pub fn read_stream(stream: impl Read, name: &Path) -> Result<String, Error> {
    text_of(bytes_of(stream, name, MOST_TEXT_BYTES)?, name)
}

/// The whole file as text, refused if it is larger than `most` bytes.
pub(super) fn read_at_most(path: &Path, most: u64) -> Result<String, Error> {
    text_of(read_bytes_at_most(path, most)?, path)
}

/// The whole file, refused if it is larger than `most` bytes; what stands beyond is never read.
pub(super) fn read_bytes_at_most(path: &Path, most: u64) -> Result<Vec<u8>, Error> {
    bytes_of(open(path)?, path, most)
}

fn bytes_of(stream: impl Read, name: &Path, most: u64) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    stream.take(most + 1).read_to_end(&mut bytes).map_err(|e| unreadable(name, &e))?;
    if bytes.len() as u64 > most {
        return Err(too_large(name, most));
    }
    Ok(bytes)
}

fn text_of(bytes: Vec<u8>, name: &Path) -> Result<String, Error> {
    String::from_utf8(bytes).map_err(|_| Error::file(name, "is no text in UTF-8"))
}

/// Opens an ordinary file. Another kind is refused before it is opened: a pipe without a writer, or a terminal, would
/// let the program wait for ever, and a device may have no end.
pub(super) fn open(path: &Path) -> Result<File, Error> {
    let kind = std::fs::metadata(path).map_err(|e| unreadable(path, &e))?.file_type();
    if kind.is_dir() {
        return Err(Error::file(path, "is a folder, expected a file"));
    }
    if !kind.is_file() {
        return Err(Error::file(path, "is no ordinary file (a pipe or a device), expected one"));
    }
    File::open(path).map_err(|e| unreadable(path, &e))
}

/// Opens a table that is read row by row; one beyond any use is refused, since a row may be as long as the file.
pub(super) fn open_table(path: &Path) -> Result<File, Error> {
    let file = open(path)?;
    if file.metadata().map_err(|e| unreadable(path, &e))?.len() > MOST_TABLE_BYTES {
        return Err(too_large(path, MOST_TABLE_BYTES));
    }
    Ok(file)
}

fn too_large(path: &Path, most: u64) -> Error {
    Error::file(path, format!("is larger than {} MB, expected at most that", most / 1_000_000))
}

/// Parses text; errors name the key path, what was found, what was expected, and the line.
pub fn parse<T: DeserializeOwned>(text: &str, notation: Notation) -> Result<T, Error> {
    match notation {
        Notation::Toml => {
            let lines_before = |at: usize| text.bytes().take(at).filter(|byte| *byte == b'\n').count();
            let line_of = |e: &toml::de::Error| e.span().map(|s| 1 + lines_before(s.start));
            let whole = |e: toml::de::Error| Error::invalid("", at_line(e.message(), line_of(&e)));
            let parser = toml::Deserializer::parse(text).map_err(whole)?;
            serde_path_to_error::deserialize(parser).map_err(|e| {
                let line = line_of(e.inner());
                keyed(&e.path().to_string(), e.inner().message(), line)
            })
        }
        Notation::Json => {
            let mut parser = serde_json::Deserializer::from_str(text);
            let value = serde_path_to_error::deserialize(&mut parser)
                .map_err(|e| keyed(&e.path().to_string(), &e.inner().to_string(), None))?;
            parser.end().map_err(|e| Error::invalid("", e.to_string()))?;
            Ok(value)
        }
    }
}

fn keyed(path: &str, message: &str, line: Option<usize>) -> Error {
    let place = if path == "." { "" } else { path };
    Error::invalid(place, at_line(&with_suggestion(message), line))
}

fn at_line(message: &str, line: Option<usize>) -> String {
    line.map_or(message.to_string(), |line| format!("{message} (line {line})"))
}

/// Adds "did you mean" to serde's "unknown field `x`, expected one of `a`, `b`".
fn with_suggestion(message: &str) -> String {
    let mut quoted = message.split('`').skip(1).step_by(2);
    match (message.starts_with("unknown"), quoted.next()) {
        (true, Some(found)) => match nearest_name(found, quoted) {
            Some(name) => format!("{message}; did you mean `{name}`?"),
            None => message.to_string(),
        },
        _ => message.to_string(),
    }
}

/// A file as another file names it, relative to its folder.
pub(super) fn relative(file: &Path, output: &Path) -> Result<String, Error> {
    let absolute =
        |path: &Path| std::path::absolute(path).map_err(|e| Error::file(path, format!("no such place: {e}")));
    let (file, output) = (absolute(file)?, absolute(output)?);
    let near = output.parent().and_then(|folder| pathdiff::diff_paths(&file, folder)).unwrap_or(file);
    Ok(near.to_string_lossy().replace(std::path::MAIN_SEPARATOR, "/"))
}

/// Writes a table of the file formats, such as a scene's or a robot's, in the notation that the extension names.
///
/// # Errors
/// Another extension, or a file that cannot be written; nothing half-written is left.
///
/// # Example
/// ```
/// use cdpr_core::{io, testing};
/// # let folder = tempfile::tempdir().unwrap();
/// # let path = folder.path().join("scene.toml");
/// let scene = testing::empty();
/// io::save_table(&path, scene.spec())?;
/// assert_eq!(io::load_scene(&path)?.spec(), scene.spec());
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn save_table(path: &Path, table: &impl Serialize) -> Result<(), Error> {
    let text = match Notation::of(path)? {
        Notation::Toml => toml::to_string(table).expect("tables are finite"),
        Notation::Json => format!("{:#}\n", serde_json::json!(table)),
    };
    write_atomically(path, text.as_bytes())
}

/// Writes a file whole or not at all: beside it first, then renamed over it.
pub fn write_atomically(path: &Path, contents: &[u8]) -> Result<(), Error> {
    let mut file = temporary_beside(path)?;
    file.write_all(contents).map_err(|e| unwritable(path, &e))?;
    rename_into_place(file, path)
}

/// A file in the same folder, to be renamed when it is complete.
pub(super) fn temporary_beside(path: &Path) -> Result<NamedTempFile, Error> {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    tempfile::Builder::new().prefix(TEMPORARY).tempfile_in(folder).map_err(|e| unwritable(path, &e))
}

/// Whether a file of this name is a temporary one, left behind by a process that was killed.
pub(super) fn is_temporary(name: &OsStr) -> bool {
    name.as_encoded_bytes().starts_with(TEMPORARY.as_bytes())
}

/// Makes a temporary file the one of this name.
pub(super) fn rename_into_place(file: NamedTempFile, path: &Path) -> Result<(), Error> {
    file.as_file().sync_all().map_err(|e| unwritable(path, &e))?;
    set_ordinary_permissions(file.path()).map_err(|e| unwritable(path, &e))?;
    file.persist(path).map_err(|e| unwritable(path, &e.error))?;
    Ok(())
}

fn unwritable(path: &Path, error: &std::io::Error) -> Error {
    Error::file(path, format!("cannot be written: {error}"))
}

/// Temporary files are private; results are ordinary files.
#[cfg(unix)]
fn set_ordinary_permissions(path: &Path) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    std::fs::set_permissions(path, std::fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn set_ordinary_permissions(_: &Path) -> std::io::Result<()> {
    Ok(())
}
