//! Reads the files of certificates, without checking what they say.

use cdpr_core::certificate::VERSION;
use cdpr_core::error::Error;

/// Reads a file of a format of this version.
pub(crate) fn parsed<T: serde::de::DeserializeOwned>(text: &str, format: &str) -> Result<T, Error> {
    let mut reader = serde_json::Deserializer::from_str(text);
    let parsed: Result<T, _> = serde_path_to_error::deserialize(&mut reader);
    let certificate = parsed.map_err(|error| {
        let place = error.path().to_string();
        let place = place.trim_end_matches(['.', '?']).to_string(); // unknown parts of the path
        let problem = error.into_inner().to_string();
        let told = if problem.starts_with("found") { problem } else { format!("found no certificate: {problem}") };
        other_format(text, format).unwrap_or_else(|| Error::invalid(place, told))
    })?;
    reader.end().map_err(|error| Error::invalid("", format!("found more than a certificate: {error}")))?;
    other_format(text, format).map_or(Ok(certificate), Err)
}

/// The error about a text of another format or version, whatever the rest of it contains.
fn other_format(text: &str, format: &str) -> Option<Error> {
    #[derive(serde::Deserialize)]
    struct Head {
        format: Option<serde_json::Value>,
        version: Option<serde_json::Value>,
    }
    let head: Head = serde_json::from_str(text).ok()?;
    let other = |place: &str, found: Option<serde_json::Value>, expected: serde_json::Value| {
        let found = found.filter(|found| *found != expected)?;
        Some(Error::invalid(place, format!("found {found}, expected {expected}")))
    };
    other("format", head.format, format.into()).or_else(|| other("version", head.version, VERSION.into()))
}
