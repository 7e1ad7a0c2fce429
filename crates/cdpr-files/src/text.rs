//! Text files, TOML or JSON by extension; every error names the file.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use super::output::write_atomically;
use cdpr_core::certificate::{BoundCertificate, Certificate};
use cdpr_core::error::{Error, nearest_name};
use cdpr_core::fixed_length::FixedLength;
use cdpr_core::limits::{MOST_CERTIFICATE_BYTES, MOST_TABLE_BYTES, MOST_TEXT_BYTES};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Maximum number of files of a folder that are searched for a name similar to a missing one.
const MANY_FILES: usize = 10_000;

/// Maximum number of characters of a word or line in a message.
const MOST_SHOWN: usize = 40;

/// The two notations of structured files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Notation {
    /// `.toml`
    Toml,
    /// `.json`
    Json,
}

impl Notation {
    /// The notation for the file's extension.
    pub fn of(path: &Path) -> Result<Self, Error> {
        match extension(path).as_deref() {
            Some("toml") => Ok(Notation::Toml),
            Some("json") => Ok(Notation::Json),
            _ => Err(other_extension(path, ".toml or .json")),
        }
    }
}

/// The extension of a file name, in lower case.
pub fn extension(path: &Path) -> Option<String> {
    path.extension()?.to_str().map(str::to_ascii_lowercase)
}

/// The error for a file with an unknown extension.
pub fn other_extension(path: &Path, expected: &str) -> Error {
    let found = path.extension().map_or("(none)".to_string(), |e| format!(".{}", e.to_string_lossy()));
    Error::file(path, format!("found the extension {found}, expected {expected}"))
}

/// The whole file as text, up to [`MOST_TEXT_BYTES`].
///
/// # Errors
/// A file that cannot be read, is too large, is not a regular file, or is not text in UTF-8.
pub fn read(path: impl AsRef<Path>) -> Result<String, Error> {
    let path = path.as_ref();
    read_at_most(path, MOST_TEXT_BYTES)
}

/// The text of a file if it is a certificate, of either kind.
///
/// # Errors
/// A certificate that cannot be read or is larger than [`MOST_CERTIFICATE_BYTES`].
pub fn read_certificate(path: impl AsRef<Path>) -> Result<Option<String>, Error> {
    let path = path.as_ref();
    let mut beginning = String::new();
    let Ok(kind) = std::fs::metadata(path) else { return Ok(None) };
    if !kind.is_file() {
        return Ok(None); // a pipe can be read only once
    }
    let Ok(file) = File::open(path) else { return Ok(None) };
    let is_text = file.take(BEGINNING).read_to_string(&mut beginning).is_ok();
    if !is_text || !beginning.trim_start().starts_with('{') {
        return Ok(None);
    }
    if begins_like_certificate(&beginning) {
        return read_at_most(path, MOST_CERTIFICATE_BYTES).map(Some);
    }
    if kind.len() > MOST_CERTIFICATE_BYTES {
        return Ok(None);
    }
    let text = read_at_most(path, MOST_CERTIFICATE_BYTES)?;
    Ok(is_certificate(&text).then_some(text))
}

/// Bytes at the beginning of a certificate as written by cdpr that hold its format.
const BEGINNING: u64 = 256;

const CERTIFICATES: [&str; 2] = [Certificate::FORMAT, BoundCertificate::FORMAT];

/// Whether a text is JSON that says it is a certificate, of either kind; a damaged one that begins so counts, too.
pub fn is_certificate(text: &str) -> bool {
    begins_like_certificate(text) || is_of_format(text, &CERTIFICATES)
}

fn begins_like_certificate(text: &str) -> bool {
    let beginning: String = text.chars().take(BEGINNING as usize).collect();
    let named = |name: &str| beginning.contains(&format!("\"{name}\""));
    beginning.trim_start().starts_with('{') && CERTIFICATES.into_iter().any(named)
}

/// Whether a text is a JSON object whose key `format` has one of these values, wherever it stands.
pub fn is_of_format(text: &str, names: &[&str]) -> bool {
    #[derive(serde::Deserialize)]
    struct Head {
        format: String,
    }
    names.iter().any(|name| text.contains(name))
        && serde_json::from_str(text).is_ok_and(|Head { format }| names.contains(&format.as_str()))
}

/// The error for a file that cannot be read; for a missing file, it suggests a similar name in the same folder.
fn unreadable(path: &Path, error: std::io::Error) -> Error {
    if let (std::io::ErrorKind::NotFound, Ok(end)) = (error.kind(), std::fs::read_link(path)) {
        return Error::file(path, format!("cannot be read: it is a link to {}, which does not exist", end.display()));
    }
    let near = (error.kind() == std::io::ErrorKind::NotFound).then(|| near_file(path)).flatten();
    let near: Vec<String> =
        near.map(|name| format!("did you mean {}?", path.with_file_name(name).display())).into_iter().collect();
    Error::system(path, "cannot be read", error).with_hints(&near)
}

fn near_file(path: &Path) -> Option<String> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let names =
        std::fs::read_dir(folder).ok()?.take(MANY_FILES).filter_map(|entry| entry.ok()?.file_name().into_string().ok());
    let mut names: Vec<String> = names.filter(|name| !name.starts_with('.')).collect();
    names.sort();
    nearest_name(path.file_name()?.to_str()?, names.iter().map(String::as_str)).map(str::to_string)
}

/// The whole stream as text, up to [`MOST_TEXT_BYTES`]; messages call it `name`.
///
/// # Errors
/// A stream that cannot be read, is longer, or is not text in UTF-8.
pub fn read_stream(stream: impl Read, name: &Path) -> Result<String, Error> {
    text_of(bytes_of(stream, name, MOST_TEXT_BYTES)?, name)
}

/// The whole file as text; an error if it is larger than `most` bytes.
pub(super) fn read_at_most(path: &Path, most: u64) -> Result<String, Error> {
    text_of(read_bytes_at_most(path, most)?, path)
}

/// The whole file; an error if it is larger than `most` bytes, beyond which nothing is read.
pub(super) fn read_bytes_at_most(path: &Path, most: u64) -> Result<Vec<u8>, Error> {
    bytes_of(open(path)?, path, most)
}

fn bytes_of(stream: impl Read, name: &Path, most: u64) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    stream.take(most + 1).read_to_end(&mut bytes).map_err(|e| unreadable(name, e))?;
    if bytes.len() as u64 > most {
        return Err(too_large(name, most));
    }
    Ok(bytes)
}

/// Bytes as text, without the byte order mark that some editors add.
fn text_of(bytes: Vec<u8>, name: &Path) -> Result<String, Error> {
    let text = String::from_utf8(bytes).map_err(|_| Error::file(name, "is not text in UTF-8"))?;
    Ok(text.strip_prefix('\u{feff}').map(str::to_string).unwrap_or(text))
}

/// Opens a regular file. Anything else is rejected before it is opened: the program would wait forever for a pipe
/// without a writer or a terminal, and a device may have no end.
pub(super) fn open(path: &Path) -> Result<File, Error> {
    let kind = std::fs::metadata(path).map_err(|e| unreadable(path, e))?.file_type();
    if kind.is_dir() {
        return Err(Error::file(path, "is a folder, expected a file"));
    }
    if !kind.is_file() {
        return Err(Error::file(path, "is not a regular file (it is a pipe or a device), expected one"));
    }
    File::open(path).map_err(|e| unreadable(path, e))
}

/// Opens a table that is read row by row; an absurdly large one is rejected, since a row may be as long as the file.
///
/// # Errors
/// Not a regular file, a file that cannot be read, or one that is too large.
pub fn open_table(path: impl AsRef<Path>) -> Result<File, Error> {
    let path = path.as_ref();
    let file = open(path)?;
    if file.metadata().map_err(|e| unreadable(path, e))?.len() > MOST_TABLE_BYTES {
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
        Notation::Toml => parse_toml(text),
        Notation::Json => parse_json(text),
    }
}

/// Text of a file in a message.
pub(crate) fn quoted(text: &[u8]) -> String {
    let text = String::from_utf8_lossy(text);
    let shown: String = text.trim().chars().take(MOST_SHOWN).collect();
    let more = if shown.len() < text.trim().len() { "…" } else { "" };
    format!("\"{shown}{more}\"")
}

/// What the TOML reader says about anything that is no value, also where a comma is missing.
const UNQUOTED: &str = "string values must be quoted";

fn parse_toml<T: DeserializeOwned>(text: &str) -> Result<T, Error> {
    let lines_before = |at: usize| text.bytes().take(at).filter(|byte| *byte == b'\n').count();
    let place_of = |e: &toml::de::Error| e.span().map(|s| format!("line {}", 1 + lines_before(s.start)));
    let no_toml = |e: toml::de::Error| {
        let found = e.span().and_then(|span| text.get(span)).unwrap_or_default();
        let problem = match e.message() {
            "duplicate key" => format!("duplicate key `{found}`, expected it once"),
            bare if bare.starts_with(UNQUOTED) => format!(
                "found {}, expected one value: a number without a unit, true, false, or text in quotes; a comma between values",
                quoted(found.as_bytes())
            ),
            other => other.to_string(),
        };
        Error::invalid("", with_place(&problem, place_of(&e)))
    };
    let parser = toml::Deserializer::parse(text).map_err(no_toml)?;
    serde_path_to_error::deserialize(FixedLength(parser))
        .map_err(|e| keyed(e.path(), e.inner().message(), place_of(e.inner())))
}

fn parse_json<T: DeserializeOwned>(text: &str) -> Result<T, Error> {
    let mut parser = serde_json::Deserializer::from_str(text);
    let value = serde_path_to_error::deserialize(FixedLength(&mut parser)).map_err(|e| {
        let (message, place) = message_and_place(e.inner(), text);
        keyed(e.path(), &message, place)
    })?;
    parser.end().map_err(|e| {
        let (message, place) = message_and_place(&e, text);
        Error::invalid("", with_place(&message, place))
    })?;
    Ok(value)
}

/// The JSON reader's message and place. In a text of a single line only the column is informative, and only for syntax
/// errors; otherwise the key gives the place.
fn message_and_place(error: &serde_json::Error, text: &str) -> (String, Option<String>) {
    let (line, column) = (error.line(), error.column());
    let whole = error.to_string();
    let message = whole.strip_suffix(&format!(" at line {line} column {column}")).unwrap_or(&whole).to_string();
    let place = match (text.trim_end().contains('\n'), error.is_data()) {
        (_, false) => Some(format!("line {line}, column {column}")),
        (true, true) => Some(format!("line {line}")),
        (false, true) => None,
    };
    (message, place)
}

fn keyed(path: &serde_path_to_error::Path, message: &str, place: Option<String>) -> Error {
    let (path, message) = (path.to_string(), with_suggestion(&in_plain_words(message)));
    Error::invalid(if path == "." { "" } else { &path }, with_place(&message, place))
}

fn with_place(message: &str, place: Option<String>) -> String {
    place.map_or(message.to_string(), |place| format!("{message} ({place})"))
}

/// Rewords serde's "invalid type: string "a", expected f64" as "found the string "a", expected a number".
fn in_plain_words(message: &str) -> String {
    let mismatch = message.strip_prefix("invalid type: ").or_else(|| message.strip_prefix("invalid value: "));
    let Some((found, expected)) = mismatch.and_then(|rest| rest.rsplit_once(", expected ")) else {
        return message.to_string();
    };
    let bare = |kind: &str| found.strip_prefix(kind).map(|value| value.trim_matches('`').to_string());
    let found = match found {
        "map" => "a table".to_string(),
        "sequence" => "an array".to_string(),
        text if text.starts_with("string ") => format!("the {text}"),
        found => {
            let number = ["integer ", "floating point ", "boolean "].into_iter().find_map(bare);
            number.unwrap_or_else(|| found.to_string())
        }
    };
    let expected = match expected {
        "f64" => "a number",
        "usize" | "u64" | "u32" => "a whole number of at least 0",
        "a boolean" => "true or false",
        "a sequence" => "an array",
        "a map" => "a table",
        expected if expected.starts_with("struct ") => "a table",
        expected => expected,
    };
    format!("found {found}, expected {expected}")
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

/// The path of a file relative to the folder of `output`, as it is written in that file.
pub(super) fn relative(file: &Path, output: &Path) -> Result<String, Error> {
    let absolute =
        |path: &Path| std::path::absolute(path).map_err(|e| Error::file(path, format!("cannot be found: {e}")));
    let (file, output) = (absolute(file)?, absolute(output)?);
    let near = output.parent().and_then(|folder| pathdiff::diff_paths(&file, folder)).unwrap_or(file);
    Ok(near.to_string_lossy().replace(std::path::MAIN_SEPARATOR, "/"))
}

/// Writes data of a file format, such as a scene or a robot, in the notation given by the extension.
///
/// # Errors
/// An unknown extension, or a file that cannot be written; no partial file is left.
///
/// # Example
/// ```
/// use cdpr_core::testing;
/// use cdpr_files::{load_scene, save_table};
/// # let folder = tempfile::tempdir().unwrap();
/// # let path = folder.path().join("scene.toml");
/// let scene = testing::empty();
/// save_table(&path, scene.spec())?;
/// assert_eq!(load_scene(&path)?.spec(), scene.spec());
/// # Ok::<(), cdpr_core::Error>(())
/// ```
pub fn save_table(path: impl AsRef<Path>, table: &impl Serialize) -> Result<(), Error> {
    let path = path.as_ref();
    let text = match Notation::of(path)? {
        Notation::Toml => toml::to_string(table).expect("tables are finite"),
        Notation::Json => format!("{:#}\n", serde_json::json!(table)),
    };
    write_atomically(path, text.as_bytes())
}
