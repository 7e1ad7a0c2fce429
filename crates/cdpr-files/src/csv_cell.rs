//! Text and numbers in CSV files. A spreadsheet evaluates a cell that begins like a formula, wherever its text came from. Such text
//! is preceded by an apostrophe, which spreadsheets understand as "this is text".

use std::borrow::Cow;

use cdpr_core::error::{Error, printable};

/// Characters with which formulas begin, and the apostrophe itself, so that quoting is unambiguous.
const SPECIAL: [char; 7] = ['=', '+', '-', '@', '\t', '\r', '\''];

/// Text as a cell. Numbers need no quoting.
pub fn cell(text: &str) -> Cow<'_, str> {
    if text.starts_with(SPECIAL) { Cow::Owned(format!("'{text}")) } else { Cow::Borrowed(text) }
}

/// The text of a cell.
pub fn text_of(cell: &str) -> &str {
    match cell.strip_prefix('\'') {
        Some(text) if text.starts_with(SPECIAL) => text,
        _ => cell,
    }
}

/// The finite number in a cell; `place` names it in the error.
pub(crate) fn number(text: &str, place: impl Fn() -> String) -> Result<f64, Error> {
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => {
            let problem = format!("found \"{}\", expected a number with a decimal point", printable(text));
            Err(Error::invalid(place(), problem))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_become_text_and_come_back() {
        for text in ["=1+1", "+1", "-cable", "@SUM(A1)", "\tx", "\rx", "'=1", "'", ""] {
            let quoted = cell(text);
            assert!(text.is_empty() || quoted.starts_with('\''), "{text:?}");
            assert_eq!(text_of(&quoted), text);
        }
        for text in ["cable 3", "a=b", "Säule", "1 - 2"] {
            assert_eq!((&*cell(text), text_of(text)), (text, text));
        }
    }
}
