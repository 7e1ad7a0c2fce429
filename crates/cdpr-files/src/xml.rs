//! Reads untrusted XML: size and number of elements are limited. A document type is skipped, so that nothing it refers
//! to is fetched, and rejected if it declares entities or default values. Elements remember what is read of them, so that
//! the rest can be named.

use std::cell::RefCell;
use std::collections::HashSet;
use std::path::Path;

use roxmltree::{Document, Node, NodeId, ParsingOptions};

use super::text;
use cdpr_core::error::Error;
use cdpr_core::limits::{MOST_XML_BYTES, MOST_XML_NODES};

/// The text of an XML file with its document type replaced by blanks, so that positions do not change.
pub(super) fn read(path: &Path) -> Result<String, Error> {
    let text = text::read_at_most(path, MOST_XML_BYTES)?;
    let text = text.strip_prefix('\u{feff}').map(str::to_string).unwrap_or(text);
    without_document_type(text).map_err(|e| e.in_file(path))
}

/// The elements of a text from [`read`].
pub(super) fn parse(text: &str) -> Result<Document<'_>, Error> {
    let options = ParsingOptions { allow_dtd: false, nodes_limit: MOST_XML_NODES, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).map_err(|e| Error::invalid("", format!("is not valid XML: {e}")))
}

fn without_document_type(mut text: String) -> Result<String, Error> {
    let Some(start) = document_type(&text) else { return Ok(text) };
    let end = end_of_document_type(&text, start)?;
    let blank: String = text[start..end].chars().map(|c| if c == '\n' { '\n' } else { ' ' }).collect();
    text.replace_range(start..end, &blank);
    Ok(text)
}

/// Where a document type ends. It may declare elements and attributes, but nothing that changes what the document contains.
fn end_of_document_type(text: &str, start: usize) -> Result<usize, Error> {
    let (mut at, mut in_brackets, mut declaration) = (start + "<!DOCTYPE".len(), false, None);
    loop {
        let rest = &text[at..];
        let refused = |what: &str| {
            let line = 1 + text[..at].matches('\n').count();
            Error::invalid("", format!("found {what} in the document type, expected none (line {line})"))
        };
        let not_closed = || Error::invalid("", "the document type declaration is not closed");
        let until = |end: &str| rest[1..].find(end).map(|k| 1 + k + end.len()).ok_or_else(not_closed);
        at += match rest.chars().next().ok_or_else(not_closed)? {
            _ if rest.starts_with("<!--") => until("-->")?,
            _ if rest.starts_with("<?") => until("?>")?,
            _ if rest.starts_with("<!ENTITY") => return Err(refused("an entity, which is not expanded,")),
            '%' => return Err(refused("a parameter entity (%), which is not expanded,")),
            '"' | '\'' if declaration == Some("<!ATTLIST") => return Err(refused("a default value of an attribute")),
            quote @ ('"' | '\'') => until(&quote.to_string())?,
            '<' => {
                declaration = rest.split(char::is_whitespace).next();
                1
            }
            '>' if declaration.take().is_none() && !in_brackets => return Ok(at + 1),
            bracket @ ('[' | ']') if declaration.is_none() => {
                in_brackets = bracket == '[';
                1
            }
            other => other.len_utf8(),
        };
    }
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

/// What has been read of a document.
#[derive(Default)]
pub(super) struct Read {
    /// Elements whose attributes and children are read one by one.
    elements: RefCell<HashSet<NodeId>>,
    /// Elements that are read as a whole.
    wholes: RefCell<HashSet<NodeId>>,
    attributes: RefCell<HashSet<(NodeId, String)>>,
}

/// An element that remembers what is read of it.
#[derive(Clone, Copy)]
pub(super) struct Element<'a> {
    node: Node<'a, 'a>,
    read: &'a Read,
}

impl<'a> Element<'a> {
    /// The first element of a document, which has this name.
    pub(super) fn root(document: &'a Document<'a>, read: &'a Read, name: &str) -> Result<Self, Error> {
        let root = Element { node: document.root_element(), read };
        if root.name() != name {
            return Err(root.wrong(format!("found this at the top, expected <{name}>")));
        }
        Ok(root.seen())
    }

    fn seen(self) -> Self {
        self.read.elements.borrow_mut().insert(self.node.id());
        self
    }

    /// Counts everything in this element as read.
    pub(super) fn whole(self) {
        self.read.wholes.borrow_mut().insert(self.seen().node.id());
    }

    pub(super) fn name(self) -> &'a str {
        self.node.tag_name().name()
    }

    /// All child elements.
    pub(super) fn children(self) -> impl Iterator<Item = Self> {
        self.unseen_children().map(Self::seen)
    }

    /// The child elements with this name.
    pub(super) fn named(self, name: &str) -> impl Iterator<Item = Self> {
        self.unseen_children().filter(move |child| child.name() == name).map(Self::seen)
    }

    fn unseen_children(self) -> impl Iterator<Item = Self> {
        self.node.children().filter(Node::is_element).map(move |node| Element { node, ..self })
    }

    /// The only child element with this name.
    pub(super) fn child(self, name: &str) -> Result<Self, Error> {
        self.optional(name)?.ok_or_else(|| self.wrong(format!("found no <{name}>, expected one")))
    }

    /// The only child element with this name, if there is one.
    pub(super) fn optional(self, name: &str) -> Result<Option<Self>, Error> {
        let mut found = self.named(name);
        match (found.next(), found.next()) {
            (_, Some(second)) => Err(second.wrong(format!("found a second <{name}>, expected one"))),
            (first, None) => Ok(first),
        }
    }

    /// The numbers of the element's text.
    pub(super) fn numbers<const N: usize>(self) -> Result<[f64; N], Error> {
        if let Some(child) = self.unseen_children().next() {
            return Err(child.wrong(format!("found this in <{}>, expected numbers only", self.name())));
        }
        self.whole();
        let text: String = self.node.children().filter_map(|node| node.text().filter(|_| node.is_text())).collect();
        let words = text.split(|c: char| c.is_whitespace() || c == ',').filter(|w| !w.is_empty());
        let found: Option<Vec<f64>> = words.map(|w| w.parse().ok().filter(|x: &f64| x.is_finite())).collect();
        found.and_then(|list| list.try_into().ok()).ok_or_else(|| {
            let shown: String = text.trim().chars().take(60).collect();
            self.wrong(format!("found \"{shown}\", expected {N} finite number{}", if N == 1 { "" } else { "s" }))
        })
    }

    /// A required attribute.
    pub(super) fn attribute(self, name: &str) -> Result<&'a str, Error> {
        self.optional_attribute(name).ok_or_else(|| self.wrong(format!("found no attribute {name}, expected one")))
    }

    /// An attribute, if there is one.
    pub(super) fn optional_attribute(self, name: &str) -> Option<&'a str> {
        self.read.attributes.borrow_mut().insert((self.node.id(), name.to_string()));
        self.node.attribute(name)
    }

    /// All attributes with their values.
    pub(super) fn attributes(self) -> impl Iterator<Item = (&'a str, &'a str)> {
        let names: Vec<&str> = self.node.attributes().map(|a| a.name()).collect();
        names.into_iter().filter_map(move |name| Some((name, self.optional_attribute(name)?)))
    }

    /// Bad input at this element, with its line.
    pub(super) fn wrong(self, problem: impl std::fmt::Display) -> Error {
        Error::invalid(format!("<{}>", self.name()), format!("{problem} (line {})", self.line()))
    }

    fn line(self) -> u32 {
        self.node.document().text_pos_at(self.node.range().start).row
    }

    /// The unread parts of this element and those within, with lines: elements, attributes and text.
    pub(super) fn unread(self) -> Vec<String> {
        let mut found = Vec::new();
        self.collect_unread(&mut found);
        let mut notes: Vec<(String, usize, u32)> = Vec::new();
        for (what, line) in found {
            match notes.iter_mut().find(|(same, ..)| *same == what) {
                Some((_, number, _)) => *number += 1,
                None => notes.push((what, 1, line)),
            }
        }
        let note = |(what, number, line)| match number {
            1 => format!("{what} (line {line})"),
            number => format!("{what} ({number} times, the first in line {line})"),
        };
        notes.into_iter().map(note).collect()
    }

    fn collect_unread(self, found: &mut Vec<(String, u32)>) {
        let Read { elements, wholes, attributes } = self.read;
        let (id, name) = (self.node.id(), self.name());
        for attribute in self.node.attributes() {
            if !attributes.borrow().contains(&(id, attribute.name().to_string())) {
                found.push((format!("{} of <{name}>", attribute.name()), self.line()));
            }
        }
        if wholes.borrow().contains(&id) {
            return;
        }
        if self.node.children().any(|node| node.is_text() && node.text().is_some_and(|text| !text.trim().is_empty())) {
            found.push((format!("text in <{name}>"), self.line()));
        }
        for child in self.unseen_children() {
            if elements.borrow().contains(&child.node.id()) {
                child.collect_unread(found);
            } else {
                found.push((format!("<{}> of <{name}>", child.name()), child.line()));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The text without its document type.
    fn read_text(text: &str) -> Result<String, String> {
        without_document_type(text.to_string()).map_err(|error| error.to_string())
    }

    #[test]
    fn a_document_type_is_skipped_and_places_stay() {
        let text =
            "<?xml version=\"1.0\"?>\n<!-- <!DOCTYPE x [ -->\n<!DOCTYPE a SYSTEM\n \"http://nowhere/a.dtd\">\n<a/>";
        let blanked = read_text(text).unwrap();
        assert_eq!(blanked.len(), text.len());
        let document = parse(&blanked).unwrap();
        assert_eq!(document.text_pos_at(document.root_element().range().start).row, 5);
    }

    #[test]
    fn a_document_type_may_declare_elements_and_attributes() {
        for declarations in [
            "<!ATTLIST a b ID #REQUIRED>",
            "<!ELEMENT a (b | c)*>\n<!ATTLIST a\n b (x | y) #IMPLIED >",
            "<!-- 50 % \" <!ENTITY x 'y'> ]> -->",
            "<?php \"'%\" ]> ?>",
            "<!NOTATION n SYSTEM \"]>%\">",
            "",
        ] {
            for head in ["a", "a SYSTEM \"[x]>.dtd\"", "a PUBLIC '-//%' \"'\""] {
                let text = format!("<!DOCTYPE {head} [\n{declarations}\n] >\n<a/>");
                let blanked = read_text(&text).unwrap_or_else(|error| panic!("{error} in {text}"));
                assert_eq!(blanked.trim(), "<a/>");
                assert_eq!(blanked.lines().count(), text.lines().count());
            }
        }
    }

    #[test]
    fn whatever_would_change_the_document_is_refused_with_its_line() {
        for (declarations, expected) in [
            (
                "<!ENTITY b \"cc\">",
                "found an entity, which is not expanded, in the document type, expected none (line 2)",
            ),
            (
                "<!ELEMENT a ANY>\n<!ENTITY % b SYSTEM \"x\">",
                "found an entity, which is not expanded, in the document type, expected none (line 3)",
            ),
            (
                "%b;",
                "found a parameter entity (%), which is not expanded, in the document type, expected none (line 2)",
            ),
            ("<!ELEMENT a (%b;)>", "found a parameter entity (%)"),
            (
                "<!ATTLIST a b CDATA \"c\">",
                "found a default value of an attribute in the document type, expected none (line 2)",
            ),
            ("<!ATTLIST a b CDATA #FIXED 'c'>", "found a default value of an attribute"),
            ("<!-- ", "is not closed"),
            ("<!ELEMENT a", "is not closed"),
        ] {
            let message = read_text(&format!("<!DOCTYPE a [\n{declarations}\n]><a>&b;</a>")).unwrap_err();
            assert!(message.contains(expected), "{message}");
        }
        assert!(parse("<a>&b;</a>").is_err());
        assert!(parse("<!DOCTYPE a SYSTEM \"a.dtd\"><a/>").is_err());
    }

    #[test]
    fn numbers_are_as_many_as_expected_and_finite() {
        let text =
            "<a><b>1 2,  3</b><b>1 2</b><b>1 nan 3</b><b/><b>1 2 3 4</b><b>1 2<!-- 9 --> 3</b><b>1 2 3<c/></b></a>";
        let (document, read) = (parse(text).unwrap(), Read::default());
        let root = Element::root(&document, &read, "a").unwrap();
        let found: Vec<_> = root.children().map(|n| n.numbers::<3>().ok()).collect();
        let three = Some([1.0, 2.0, 3.0]);
        assert_eq!(found, [three, None, None, None, None, three, None]);
    }

    #[test]
    fn what_is_not_read_is_listed() {
        let text =
            "<a b=\"1\" c=\"2\">\n<d>1</d>\n<e><f/><f g=\"3\"/></e> stray\n<e h=\"4\"/>\n<i/><i/><j><k/></j>\n</a>";
        let (document, read) = (parse(text).unwrap(), Read::default());
        let root = Element::root(&document, &read, "a").unwrap();
        root.attribute("b").unwrap();
        root.child("d").unwrap().numbers::<1>().unwrap();
        root.named("e").next().unwrap().children().for_each(drop);
        root.child("j").unwrap().whole();
        let expected = [
            "c of <a> (line 1)",
            "text in <a> (line 1)",
            "g of <f> (line 3)",
            "<e> of <a> (line 4)",
            "<i> of <a> (2 times, the first in line 5)",
        ];
        assert_eq!(root.unread(), expected);
        assert!(root.optional("e").is_err());
    }
}
