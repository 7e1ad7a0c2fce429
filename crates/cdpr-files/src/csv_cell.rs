//! Text in CSV files. A spreadsheet takes a cell that begins like a formula for one and runs it, wherever its text came
//! from; such text gets an apostrophe in front, which spreadsheets understand as "this is text".

use std::borrow::Cow;

/// What formulas begin with, and the apostrophe itself, so that what is quoted can be told from what is not.
const SPECIAL: [char; 7] = ['=', '+', '-', '@', '\t', '\r', '\''];

/// Text as a cell. Numbers are no text and need none of this.
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
