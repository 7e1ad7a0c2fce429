//! OBJ files: vertices and polygons. Names, normals, textures, materials and colours do not change the surface and are
//! not used. Statements of curved surfaces, and those that include other files, are refused.

use std::str;

use super::lines::{at, coordinate, lines, without_mark, words};
use super::triangulation::{fan, triangulation};
use super::{MeshFile, too_many};
use crate::text::quoted;
use cdpr_core::error::Error;
use cdpr_core::geometry::{Point, TriangleMesh};
use cdpr_core::limits::{MOST_POLYGON_CORNERS, MOST_TRIANGLES};
use cdpr_core::words::count;

/// Statements with names, which may end with a backslash of their own.
const NAMES: [&str; 8] = ["g", "o", "usemtl", "mtllib", "usemap", "maplib", "shadow_obj", "trace_obj"];

/// Further statements that do not change the surface.
const LOOKS: [&str; 9] = ["vt", "vn", "vp", "s", "mg", "bevel", "c_interp", "d_interp", "lod"];

/// Statements of curves and curved surfaces.
const CURVED: [&str; 21] = [
    "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp", "end", "con",
    "ctech", "stech", "bzp", "bsp", "cdc", "cdp", "res",
];

/// Statements that run commands or include files.
const OUTSIDE: [&str; 2] = ["call", "csh"];

/// Note about polygons without a triangulation.
const FAN: &str =
    "be filled by triangles, probably because sides cross: covered by a fan of triangles each, which may reach beyond";

/// Maximum number of vertices: as many as if no two triangles shared one.
const MOST_VERTICES: usize = 3 * MOST_TRIANGLES;

/// Reads a file.
pub(super) fn read(bytes: &[u8]) -> Result<MeshFile, Error> {
    let mut file = File::default();
    let mut lines = lines(without_mark(bytes)?);
    let mut statement = Vec::new();
    while let Some((line, text)) = lines.next() {
        statement.clear();
        statement.extend(words(without_comment(text)));
        while let Some(start) = before_backslash(&statement) {
            let Some((_, text)) = lines.next() else {
                return Err(at(line, "the file ends where the line after a backslash is expected; is it cut off?"));
            };
            if !start.is_empty() && text.first().is_some_and(|b| !b.is_ascii_whitespace()) {
                let problem = format!("found \"{}\\\", expected a blank before the backslash", lossy(start));
                return Err(at(line, problem));
            }
            statement.pop();
            statement.extend((!start.is_empty()).then_some(start));
            statement.extend(words(without_comment(text)));
        }
        if let [keyword, values @ ..] = &statement[..] {
            file.add(&lossy(keyword), values, line)?;
        }
    }
    file.mesh()
}

fn lossy(word: &[u8]) -> std::borrow::Cow<'_, str> {
    String::from_utf8_lossy(word)
}

fn without_comment(line: &[u8]) -> &[u8] {
    line.split(|b| *b == b'#').next().unwrap_or_default()
}

/// The last word of a statement that continues in the next line, without its backslash.
fn before_backslash<'a>(statement: &[&'a [u8]]) -> Option<&'a [u8]> {
    let is_name = |word: &&[u8]| NAMES.iter().any(|name| name.as_bytes() == *word);
    let last = statement.last().filter(|_| !statement.first().is_some_and(is_name))?;
    last.strip_suffix(b"\\")
}

/// What has been read so far.
#[derive(Default)]
struct File {
    vertices: Vec<Point>,
    /// The line of every vertex.
    lines: Vec<usize>,
    polygons: Vec<Polygon>,
    /// Number of triangles in all polygons.
    triangles: usize,
    /// Lines and points, which have no surface.
    without_surface: Named,
}

struct Polygon {
    line: usize,
    /// Indices of vertices, which may follow later in the file.
    corners: Vec<usize>,
}

impl File {
    fn add(&mut self, keyword: &str, values: &[&[u8]], line: usize) -> Result<(), Error> {
        let problem = match keyword {
            "v" => return self.add_vertex(values, line),
            "f" | "fo" => return self.add_polygon(values, line),
            "l" | "p" => {
                self.without_surface.add(line);
                return Ok(());
            }
            _ if NAMES.contains(&keyword) || LOOKS.contains(&keyword) => return Ok(()),
            _ if CURVED.contains(&keyword) => {
                "which belongs to a curve or a curved surface, expected polygons (f): export the model as a mesh"
            }
            _ if OUTSIDE.contains(&keyword) => "which refers to something outside, expected a file that is complete",
            _ => "expected a statement of an OBJ file, such as v or f",
        };
        Err(at(line, format!("found {}, {problem}", quoted(keyword.as_bytes()))))
    }

    /// A vertex: x y z, or with a weight or a colour x y z w or x y z r g b.
    fn add_vertex(&mut self, values: &[&[u8]], line: usize) -> Result<(), Error> {
        let numbers = values.iter().map(|word| coordinate(word, line)).collect::<Result<Vec<_>, _>>()?;
        let place = match numbers[..] {
            [x, y, z] | [x, y, z, 1.0] | [x, y, z, _, _, _] => Point::new(x, y, z),
            [_, _, _, w] => {
                let problem = format!("found a vertex with the weight {w}, expected 1 or none");
                return Err(at(line, format!("{problem}: weights belong to curves and curved surfaces")));
            }
            _ => {
                let found = count(numbers.len(), "number");
                return Err(at(line, format!("found a vertex with {found}, expected x y z, x y z w or x y z r g b")));
            }
        };
        if self.vertices.len() == MOST_VERTICES {
            let problem = format!("found more than {MOST_VERTICES} vertices, expected at most that many");
            return Err(at(line, format!("{problem} ({MOST_TRIANGLES} triangles); simplify the mesh")));
        }
        self.vertices.push(place);
        self.lines.push(line);
        Ok(())
    }

    fn add_polygon(&mut self, values: &[&[u8]], line: usize) -> Result<(), Error> {
        let refused = |expected: String| {
            at(line, format!("found a face with {}, expected {expected}", count(values.len(), "corner")))
        };
        if values.len() < 3 {
            return Err(refused("at least 3".to_string()));
        }
        if values.len() > MOST_POLYGON_CORNERS {
            return Err(refused(format!("at most {MOST_POLYGON_CORNERS}: triangulate it")));
        }
        self.triangles += values.len() - 2;
        if self.triangles > MOST_TRIANGLES {
            return Err(too_many(format!("more than {MOST_TRIANGLES}")));
        }
        let corners = values.iter().map(|word| self.corner(word).map_err(|problem| at(line, problem)));
        self.polygons.push(Polygon { line, corners: corners.collect::<Result<_, _>>()? });
        Ok(())
    }

    /// The index of a corner's vertex, counted from 0; the file counts from 1, or backward from the last vertex before.
    fn corner(&self, word: &[u8]) -> Result<usize, String> {
        let index =
            index(word).ok_or_else(|| format!("found {}, expected a corner such as 7, 7/1 or 7//1", quoted(word)))?;
        let (size, before) = (usize::try_from(index.unsigned_abs()).unwrap_or(usize::MAX), self.vertices.len());
        match index.signum() {
            1 => Ok(size - 1),
            0 => Err("found the index 0, but indices start at 1".to_string()),
            _ => before
                .checked_sub(size)
                .ok_or_else(|| format!("found the index {index}, but {before} vertices precede it")),
        }
    }

    /// The mesh of all polygons.
    fn mesh(self) -> Result<MeshFile, Error> {
        let mut is_used = vec![false; self.vertices.len()];
        let mut triangles = Vec::with_capacity(self.triangles);
        let mut fans = Named::default();
        for Polygon { line, corners } in &self.polygons {
            for index in corners {
                let used = is_used.get_mut(*index).ok_or_else(|| {
                    let found =
                        format!("found the index {}, but the file has {} vertices", index + 1, self.vertices.len());
                    at(*line, found)
                })?;
                *used = true;
            }
            match triangulation(corners, &self.vertices) {
                Some(filled) => triangles.extend(filled),
                None => {
                    fans.add(*line);
                    triangles.extend(fan(corners));
                }
            }
        }
        let mut unused = Named::default();
        self.lines.iter().zip(&is_used).filter(|(_, used)| !**used).for_each(|(line, _)| unused.add(*line));
        let notes = [
            self.without_surface.note("line or point has", "lines or points have", "no surface: not read"),
            unused.note("vertex belongs", "vertices belong", "to no face"),
            fans.note("polygon cannot", "polygons cannot", FAN),
        ];
        let mesh = TriangleMesh { vertices: self.vertices, triangles };
        Ok(MeshFile { mesh, notes: notes.into_iter().flatten().collect() })
    }
}

/// The vertex of a corner: the first number of `7`, `7/1`, `7//3` or `7/1/3`.
fn index(corner: &[u8]) -> Option<i64> {
    let mut numbers = str::from_utf8(corner).ok()?.split('/');
    let index = numbers.next()?.parse().ok()?;
    let others: Vec<&str> = numbers.collect();
    let is_sound = others.len() <= 2 && others.iter().all(|n| n.is_empty() || n.parse::<i64>().is_ok());
    is_sound.then_some(index)
}

/// Things that a note names: how many, and the line of the first.
#[derive(Default)]
struct Named {
    number: usize,
    first: usize,
}

impl Named {
    fn add(&mut self, line: usize) {
        self.first = if self.number == 0 { line } else { self.first };
        self.number += 1;
    }

    fn note(&self, one: &str, many: &str, what: &str) -> Option<String> {
        let place = match self.number {
            0 => return None,
            1 => format!("line {}", self.first),
            _ => format!("the first in line {}", self.first),
        };
        Some(format!("{} {} {what} ({place})", self.number, if self.number == 1 { one } else { many }))
    }
}
