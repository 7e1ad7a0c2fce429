//! Lines and words of text in any encoding that extends ASCII.

use std::str;

use crate::text::quoted;
use cdpr_core::error::Error;

/// The bytes of a text without the byte order mark that some editors add.
pub(super) fn without_mark(bytes: &[u8]) -> Result<&[u8], Error> {
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return Err(Error::invalid("", "is text in UTF-16, expected ASCII or UTF-8"));
    }
    Ok(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes))
}

/// The lines of a text with their numbers, from 1 on. A line ends with LF, CR or both.
pub(super) fn lines(text: &[u8]) -> impl Iterator<Item = (usize, &[u8])> {
    let mut rest = Some(text);
    let next = move || {
        let text = rest?;
        let Some(end) = text.iter().position(|b| matches!(b, b'\n' | b'\r')) else { return rest.take() };
        let both = text[end..].starts_with(b"\r\n");
        rest = Some(&text[end + if both { 2 } else { 1 }..]);
        Some(&text[..end])
    };
    (1..).zip(std::iter::from_fn(next))
}

/// The words of a line, between blanks.
pub(super) fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(|b| b.is_ascii_whitespace() || *b == b'\x0b').filter(|word| !word.is_empty())
}

/// A coordinate.
pub(super) fn coordinate(word: &[u8], line: usize) -> Result<f64, Error> {
    let found: Option<f64> = str::from_utf8(word).ok().and_then(|word| word.parse().ok());
    match found {
        Some(x) if x.is_finite() => Ok(x + 0.0), // no negative zero
        Some(_) => Err(at(line, format!("found {}, which is not finite, expected a finite number", quoted(word)))),
        None => Err(at(line, format!("found {}, expected a number", quoted(word)))),
    }
}

/// Bad input in a line.
pub(super) fn at(line: usize, problem: impl std::fmt::Display) -> Error {
    Error::invalid("", format!("{problem} (line {line})"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_with_any_line_end_and_are_counted() {
        let found: Vec<_> = lines(b"a\nb\r\nc\rd\n\n\re").collect();
        let expected: [&[u8]; 7] = [b"a", b"b", b"c", b"d", b"", b"", b"e"];
        assert_eq!(found, (1..).zip(expected).collect::<Vec<_>>());
    }

    #[test]
    fn long_text_is_shortened_in_messages() {
        assert_eq!(quoted(b" ab\xff "), "\"ab\u{fffd}\"");
        assert_eq!(quoted("ä".repeat(50).as_bytes()), format!("\"{}…\"", "ä".repeat(40)));
    }
}
