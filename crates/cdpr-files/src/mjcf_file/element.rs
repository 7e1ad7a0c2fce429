//! XML elements as text.

use std::fmt::{self, Display, Formatter};

/// An element of an XML document: a name, attributes, and elements and comments in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Element {
    name: &'static str,
    attributes: Vec<(&'static str, String)>,
    children: Vec<Node>,
}

#[derive(Debug, Clone, PartialEq)]
enum Node {
    Element(Element),
    Comment(&'static str),
}

impl Element {
    /// An element without attributes.
    pub fn new(name: &'static str) -> Self {
        Element { name, attributes: Vec::new(), children: Vec::new() }
    }

    /// The element with an attribute, which may contain any characters that XML allows.
    pub fn with(mut self, name: &'static str, value: impl Into<String>) -> Self {
        self.attributes.push((name, value.into()));
        self
    }

    /// The element with an attribute of numbers.
    pub fn with_numbers(self, name: &'static str, numbers: &[f64]) -> Self {
        self.with(name, written(numbers))
    }

    /// The element with another one at the end of its contents.
    pub fn with_child(mut self, child: Element) -> Self {
        self.push(child);
        self
    }

    /// The element with a comment, without `--` in it, at the end of its contents.
    pub fn with_comment(mut self, text: &'static str) -> Self {
        self.children.push(Node::Comment(text));
        self
    }

    /// Adds an element at the end of its contents.
    pub fn push(&mut self, child: Element) {
        self.children.push(Node::Element(child));
    }

    fn write(&self, f: &mut Formatter<'_>, depth: usize) -> fmt::Result {
        let indent = "  ".repeat(depth);
        write!(f, "{indent}<{}", self.name)?;
        for (name, value) in &self.attributes {
            write!(f, " {name}=\"{}\"", escaped(value))?;
        }
        if self.children.is_empty() {
            return writeln!(f, "/>");
        }
        writeln!(f, ">")?;
        for child in &self.children {
            match child {
                Node::Element(element) => element.write(f, depth + 1)?,
                Node::Comment(text) => writeln!(f, "{indent}  <!-- {text} -->")?,
            }
        }
        writeln!(f, "{indent}</{}>", self.name)
    }
}

impl Display for Element {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.write(f, 0)
    }
}

/// Numbers with spaces between them, each in the fewest digits that are read back as the same number.
pub fn written(numbers: &[f64]) -> String {
    let digits: Vec<String> = numbers.iter().map(|x| digits(x + 0.0)).collect(); // no -0
    digits.join(" ")
}

fn digits(x: f64) -> String {
    let text = format!("{x:?}");
    text.strip_suffix(".0").map(str::to_string).unwrap_or(text)
}

/// A text as the value of an attribute. White space other than blanks would be read as blanks.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\t' | '\n' | '\r' => escaped.push_str(&format!("&#{};", u32::from(c))),
            c => escaped.push(c),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn attributes_are_read_back_as_they_were() {
        let name = "\"a\" < 'b' & c > d\t&amp;\n é ☃";
        let text = Element::new("a").with("b", name).with_comment("a comment").to_string();
        let read = roxmltree::Document::parse(&text).unwrap();
        assert_eq!(read.root_element().attribute("b"), Some(name));
    }

    #[test]
    fn numbers_are_read_back_as_they_were() {
        let numbers = [0.1, -0.0, 1e-300, 1e22, 1.0 / 3.0, 5.0];
        let text = written(&numbers);
        assert_eq!(text, "0.1 0 1e-300 1e22 0.3333333333333333 5");
        let read: Vec<f64> = text.split(' ').map(|word| word.parse().unwrap()).collect();
        assert_eq!(read, numbers);
    }

    #[test]
    fn elements_are_indented() {
        let child = Element::new("b").with_child(Element::new("c").with_numbers("d", &[1.0, 2.5]));
        assert_eq!(Element::new("a").with_child(child).to_string(), "<a>\n  <b>\n    <c d=\"1 2.5\"/>\n  </b>\n</a>\n");
    }
}
