//! STL files, text or binary. Normals, names and the attributes of binary triangles are not used.

use std::collections::HashMap;

use super::lines::{at, coordinate, lines, without_mark, words};
use super::{MeshFile, too_many};
use crate::text::quoted;
use cdpr_core::error::Error;
use cdpr_core::geometry::{Point, TriangleMesh};
use cdpr_core::limits::MOST_TRIANGLES;
use cdpr_core::words::count;

/// Bytes of a binary file before its triangles, the last four of which count them, and bytes of each triangle.
const HEADER: usize = 84;
const TRIANGLE: usize = 50;

/// Reads a text or binary file. The contents decide which, not the first word: four bytes of text, read as a number of
/// triangles, exceed the room in any file, and the header of a binary file contains a zero byte.
pub(super) fn read(bytes: &[u8]) -> Result<MeshFile, Error> {
    match Binary::of(bytes) {
        Some(file) if file.stated <= file.room => binary(&file),
        Some(Binary { stated, room, .. }) if bytes[..HEADER].contains(&0) => {
            without_mark(bytes)?; // text in UTF-16 contains zero bytes, too
            Err(Error::invalid("", format!("ends after {room} of {stated} triangles, or is not an STL file")))
        }
        _ => text(bytes),
    }
}

fn is(word: &[u8], keyword: &str) -> bool {
    word.eq_ignore_ascii_case(keyword.as_bytes())
}

/// A file read as binary: the number of triangles that its header states, and for how many there is room.
struct Binary<'a> {
    stated: usize,
    room: usize,
    triangles: &'a [u8],
}

impl<'a> Binary<'a> {
    fn of(bytes: &'a [u8]) -> Option<Self> {
        let (header, triangles) = bytes.split_at_checked(HEADER)?;
        let stated = u32::from_le_bytes(header[HEADER - 4..].try_into().expect("four bytes"));
        Some(Binary { stated: stated as usize, room: triangles.len() / TRIANGLE, triangles })
    }
}

fn binary(Binary { stated, room, triangles }: &Binary) -> Result<MeshFile, Error> {
    if *stated > MOST_TRIANGLES {
        return Err(too_many(stated));
    }
    let (triangles, tail) = triangles.split_at(stated * TRIANGLE);
    let more = !tail.is_empty() && tail.len().is_multiple_of(TRIANGLE);
    if more || (*stated == 0 && *room > 0) {
        let problem = format!("the header says {}, the file has room for {room}", count(*stated, "triangle"));
        return Err(Error::invalid("", format!("{problem}; expected the same number")));
    }
    if let Some(next) = Binary::of(tail).filter(|next| next.stated * TRIANGLE == next.triangles.len()) {
        let problem = format!("found a second binary file of {} after the first", count(next.stated, "triangle"));
        return Err(Error::invalid("", format!("{problem} ({stated}), expected one; save them as separate files")));
    }
    let mut corners = Corners::default();
    for triangle in triangles.chunks_exact(TRIANGLE) {
        let single = |k: usize| f32::from_le_bytes(triangle[k..k + 4].try_into().expect("four bytes"));
        let corner = |k: usize| [0, 4, 8].map(|j| f64::from(single(12 + 12 * k + j)) + 0.0); // no negative zero
        corners.add([0, 1, 2].map(corner));
    }
    let note = format!("{} after the {} are not read", count(tail.len(), "byte"), count(*stated, "triangle"));
    Ok(MeshFile { mesh: corners.mesh, notes: if tail.is_empty() { Vec::new() } else { vec![note] } })
}

/// The mesh of triangles given by coordinates: equal corners become one.
#[derive(Default)]
struct Corners {
    mesh: TriangleMesh,
    places: HashMap<[u64; 3], usize>,
}

impl Corners {
    fn add(&mut self, triangle: [[f64; 3]; 3]) {
        let TriangleMesh { vertices, triangles } = &mut self.mesh;
        triangles.push(triangle.map(|corner| {
            *self.places.entry(corner.map(f64::to_bits)).or_insert_with(|| {
                vertices.push(Point::from(corner));
                vertices.len() - 1
            })
        }));
    }
}

/// The statement that must follow in a text file.
#[derive(Clone, Copy)]
enum Next {
    Solid,
    Facet,
    Loop,
    /// A vertex, after this many.
    Vertex(usize),
    EndLoop,
    EndFacet,
}

impl Next {
    fn expected(self) -> &'static str {
        match self {
            Next::Solid => "solid, or the end of the file",
            Next::Facet => "facet or endsolid",
            Next::Loop => "outer loop",
            Next::Vertex(_) => "vertex",
            Next::EndLoop => "endloop",
            Next::EndFacet => "endfacet",
        }
    }
}

/// Reads text: any number of solids, one statement a line, keywords in capitals or not.
fn text(bytes: &[u8]) -> Result<MeshFile, Error> {
    let mut found = Corners::default();
    let mut triangle = [[0.0; 3]; 3];
    let (mut next, mut last) = (Next::Solid, 1);
    for (number, line) in lines(without_mark(bytes)?) {
        let mut rest = words(line);
        let Some(keyword) = rest.next() else { continue };
        last = number;
        let unexpected = || at(number, format!("found {}, expected {}", quoted(line), next.expected()));
        next = match next {
            Next::Solid if is(keyword, "solid") => named(rest, number).map(|()| Next::Facet)?,
            Next::Facet if is(keyword, "endsolid") => named(rest, number).map(|()| Next::Solid)?,
            Next::Facet if is(keyword, "facet") => {
                let is_normal = rest.next().is_some_and(|word| is(word, "normal")) && rest.count() == 3;
                let problem = || format!("found {}, expected facet normal and three numbers", quoted(line));
                is_normal.then_some(Next::Loop).ok_or_else(|| at(number, problem()))?
            }
            Next::Loop
                if is(keyword, "outer") && rest.next().is_some_and(|w| is(w, "loop")) && rest.next().is_none() =>
            {
                Next::Vertex(0)
            }
            Next::Vertex(k) if is(keyword, "vertex") => {
                for x in &mut triangle[k] {
                    let word = rest.next().ok_or_else(|| three_numbers(line, number))?;
                    *x = coordinate(word, number)?;
                }
                if rest.next().is_some() {
                    return Err(three_numbers(line, number));
                }
                if k < 2 { Next::Vertex(k + 1) } else { Next::EndLoop }
            }
            Next::EndLoop if is(keyword, "endloop") && rest.next().is_none() => Next::EndFacet,
            Next::EndFacet if is(keyword, "endfacet") && rest.next().is_none() => {
                found.add(triangle);
                if found.mesh.triangles.len() > MOST_TRIANGLES {
                    return Err(too_many(format!("more than {MOST_TRIANGLES}")));
                }
                Next::Facet
            }
            _ => return Err(unexpected()),
        };
    }
    match next {
        Next::Solid => Ok(MeshFile { mesh: found.mesh, notes: Vec::new() }),
        next => {
            let problem = format!("the file ends where {} is expected; is it cut off?", next.expected());
            Err(at(last, problem))
        }
    }
}

fn three_numbers(line: &[u8], number: usize) -> Error {
    at(number, format!("found {}, expected vertex and three numbers", quoted(line)))
}

/// A name may be any text, but a facet in its line would be lost.
fn named<'a>(mut name: impl Iterator<Item = &'a [u8]>, line: usize) -> Result<(), Error> {
    let mut after_facet = false;
    let has_facet = name.any(|word| std::mem::replace(&mut after_facet, is(word, "facet")) && is(word, "normal"));
    let problem = "found a facet in the line of a name, expected it in a line of its own";
    if has_facet { Err(at(line, problem)) } else { Ok(()) }
}
