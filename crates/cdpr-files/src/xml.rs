//! XML of other programs, read without trust: size and number of elements are bounded, and a document type is skipped:
//! nothing that it names is fetched, and one that declares anything is refused.

use std::path::Path;

use roxmltree::{Document, Node, ParsingOptions};

use super::text;
use cdpr_core::error::Error;
use cdpr_core::numerics::{MOST_XML_BYTES, MOST_XML_NODES};

/// The text of an XML file with its document type blanked out, so that places stay where they are.
pub(super) fn read(path: &Path) -> Result<String, Error> {
    let text = text::read_at_most(path, MOST_XML_BYTES)?;
    let text = text.strip_prefix('\u{feff}').map(str::to_string).unwrap_or(text);
    without_document_type(text).map_err(|e| e.in_file(path))
}

/// The elements of a text from [`read`].
pub(super) fn parse(text: &str) -> Result<Document<'_>, Error> {
    let options = ParsingOptions { allow_dtd: false, nodes_limit: MOST_XML_NODES, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).map_err(|e| Error::invalid("", format!("is no sound XML: {e}")))
}

fn without_document_type(mut text: String) -> Result<String, Error> {
    let Some(start) = document_type(&text) else { return Ok(text) };
    let declares = || {
        let found = "found a document type with declarations of its own, expected at most the name of a DTD";
        Error::invalid("", format!("{found}; entities are not expanded"))
    };
    let end =
        start + text[start..].find(['>', '[']).ok_or_else(|| Error::invalid("", "the document type has no end"))?;
    if text.as_bytes()[end] == b'[' {
        return Err(declares());
    }
    let blank: String = text[start..=end].chars().map(|c| if c == '\n' { '\n' } else { ' ' }).collect();
    text.replace_range(start..=end, &blank);
    Ok(text)
}

/// Where the document type begins: after the XML declaration, comments and instructions, before the first element.
fn document_type(text: &str) -> Option<usize> {
    let mut at = 0;
    loop {
        at += text[at..].len() - text[at..].trim_start().len();
        let rest = &text[at..];
        let end = match () {
            () if rest.starts_with("<!DOCTYPE") => return Some(at),
            () if rest.starts_with("<?") => "?>",
            () if rest.starts_with("<!--") => "-->",
            () => return None,
        };
        at += rest.find(end)? + end.len();
    }
}

/// Child elements.
pub(super) fn children<'a, 'i>(node: Node<'a, 'i>) -> impl Iterator<Item = Node<'a, 'i>> {
    node.children().filter(Node::is_element)
}

/// The one child element of this name.
pub(super) fn child<'a, 'i>(node: Node<'a, 'i>, name: &str) -> Result<Node<'a, 'i>, Error> {
    let mut found = children(node).filter(|n| n.has_tag_name(name));
    match (found.next(), found.next()) {
        (Some(only), None) => Ok(only),
        (None, _) => Err(at(node, format!("found no <{name}>, expected one"))),
        (Some(_), Some(second)) => Err(at(second, format!("found a second <{name}>, expected one"))),
    }
}

/// The numbers of an element's text.
pub(super) fn numbers<const N: usize>(node: Node) -> Result<[f64; N], Error> {
    let text = node.text().unwrap_or_default();
    let words = text.split(|c: char| c.is_whitespace() || c == ',').filter(|w| !w.is_empty());
    let found: Option<Vec<f64>> = words.map(|w| w.parse().ok().filter(|x: &f64| x.is_finite())).collect();
    found.and_then(|list| list.try_into().ok()).ok_or_else(|| {
        let shown: String = text.trim().chars().take(60).collect();
        at(node, format!("found \"{shown}\", expected {N} finite number{}", if N == 1 { "" } else { "s" }))
    })
}

/// An attribute that must be there.
pub(super) fn attribute<'a>(node: Node<'a, '_>, name: &str) -> Result<&'a str, Error> {
    node.attribute(name).ok_or_else(|| at(node, format!("found no attribute {name}, expected one")))
}

/// Bad input at an element, with its line.
pub(super) fn at(node: Node, problem: impl std::fmt::Display) -> Error {
    let line = node.document().text_pos_at(node.range().start).row;
    Error::invalid(format!("<{}>", node.tag_name().name()), format!("{problem} (line {line})"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_document_type_is_skipped_and_places_stay() {
        let text =
            "<?xml version=\"1.0\"?>\n<!-- <!DOCTYPE x [ -->\n<!DOCTYPE a SYSTEM\n \"http://nowhere/a.dtd\">\n<a/>";
        let blanked = without_document_type(text.to_string()).unwrap();
        assert_eq!(blanked.len(), text.len());
        let document = parse(&blanked).unwrap();
        assert_eq!(document.text_pos_at(document.root_element().range().start).row, 5);
    }

    #[test]
    fn declarations_are_refused_and_unknown_entities_too() {
        let bomb = "<!DOCTYPE a [<!ENTITY b \"cc\">]><a>&b;</a>";
        assert!(without_document_type(bomb.to_string()).unwrap_err().to_string().contains("not expanded"));
        assert!(parse("<a>&b;</a>").is_err());
        assert!(parse("<!DOCTYPE a SYSTEM \"a.dtd\"><a/>").is_err());
    }

    #[test]
    fn numbers_are_as_many_as_expected_and_finite() {
        let text = "<a><b>1 2,  3</b><b>1 2</b><b>1 nan 3</b><b/><b>1 2 3 4</b></a>";
        let document = parse(text).unwrap();
        let found: Vec<_> = children(document.root_element()).map(|n| numbers::<3>(n).ok()).collect();
        assert_eq!(found, [Some([1.0, 2.0, 3.0]), None, None, None, None]);
    }
}
