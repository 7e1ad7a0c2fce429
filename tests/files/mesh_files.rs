//! Mesh files as programs write them: each is read whole, or refused with its line.

use std::fs;

use cdpr_core::Error;
use cdpr_files::{MeshFile, load_mesh_file};

/// The expected result of reading a file.
enum Expected {
    /// This many triangles and these beginnings of notes.
    Read(usize, &'static [&'static str]),
    /// An error that contains this.
    Refused(&'static str),
}
use Expected::{Read, Refused};

fn read(name: &str, bytes: &[u8]) -> Result<MeshFile, Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    fs::write(&path, bytes).unwrap();
    load_mesh_file(&path)
}

fn assert_all(extension: &str, cases: Vec<(&str, Vec<u8>, Expected)>) {
    for (what, bytes, expected) in cases {
        match (read(&format!("mesh.{extension}"), &bytes), expected) {
            (Ok(MeshFile { mesh, notes }), Read(triangles, beginnings)) => {
                assert_eq!(mesh.triangles.len(), triangles, "{what}");
                assert_eq!(notes.len(), beginnings.len(), "{what}: {notes:?}");
                for (note, beginning) in notes.iter().zip(beginnings) {
                    assert!(note.starts_with(beginning), "{what}: {note}");
                }
            }
            (Err(error), Refused(part)) => {
                let message = error.to_string();
                assert!(message.contains(part) && message.contains("mesh."), "{what}: \"{part}\" is not in: {message}");
            }
            (Ok(file), Refused(part)) => panic!("{what}: read {file:?}, expected \"{part}\""),
            (Err(error), Read(..)) => panic!("{what}: {error}"),
        }
    }
}

/// A box as a list of triangles, outward.
fn sides([x, y, z]: [f64; 3], [a, b, c]: [f64; 3]) -> Vec<[[f64; 3]; 3]> {
    let corner =
        |k: usize| [if k & 1 == 0 { x } else { a }, if k & 2 == 0 { y } else { b }, if k & 4 == 0 { z } else { c }];
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    quads.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).map(|t| t.map(corner)).collect()
}

/// A mast of 12 triangles, and a base beside it.
fn mast() -> Vec<[[f64; 3]; 3]> {
    sides([0.9, 0.9, 0.0], [1.1, 1.1, 0.6])
}

fn base() -> Vec<[[f64; 3]; 3]> {
    sides([0.2, 0.9, 0.0], [0.4, 1.1, 0.1])
}

fn facets(triangles: &[[[f64; 3]; 3]], normal: &str) -> String {
    let vertex = |[x, y, z]: &[f64; 3]| format!("      vertex {x} {y} {z}\n");
    let facet = |t: &[[f64; 3]; 3]| {
        let corners: String = t.iter().map(vertex).collect();
        format!("  facet normal {normal}\n    outer loop\n{corners}    endloop\n  endfacet\n")
    };
    triangles.iter().map(facet).collect()
}

fn solid(name: &str, triangles: &[[[f64; 3]; 3]]) -> String {
    format!("solid {name}\n{}endsolid {name}\n", facets(triangles, "0 0 1"))
}

fn binary(header: &str, told: u32, triangles: &[[[f64; 3]; 3]], tail: &[u8]) -> Vec<u8> {
    let mut bytes = format!("{header:80}").into_bytes();
    bytes.extend(told.to_le_bytes());
    for triangle in triangles {
        let numbers = [0.0, 0.0, 1.0].into_iter().chain(triangle.iter().flatten().copied());
        bytes.extend(numbers.flat_map(|x| (x as f32).to_le_bytes()));
        bytes.extend([0x1f, 0x80]); // a colour
    }
    [bytes, tail.to_vec()].concat()
}

fn text(text: impl Into<String>) -> Vec<u8> {
    text.into().into_bytes()
}

#[test]
fn all_solids_of_a_text_stl_file_are_read() {
    let (one, two) = (solid("base", &base()), solid("mast", &mast()));
    assert_all(
        "stl",
        vec![
            ("two solids", text(one.clone() + &two), Read(24, &[])),
            (
                "two solids without names",
                text((one.clone() + &two).replace(" base", "").replace(" mast", "")),
                Read(24, &[]),
            ),
            ("a second solid in capitals", text(one.clone() + &two.to_uppercase()), Read(24, &[])),
            ("blank lines between solids", text(format!("{one}\n \t\n\n{two}\n\n")), Read(24, &[])),
            ("an empty solid between", text(format!("{one}solid nothing\nendsolid nothing\n{two}")), Read(24, &[])),
            (
                "a comment between solids",
                text(format!("{one}# the mast\n{two}")),
                Refused("found \"# the mast\", expected solid, or the end of the file (line 87)"),
            ),
            (
                "facets without solid after a solid",
                text(one.clone() + &facets(&mast(), "0 0 1")),
                Refused("found \"facet normal 0 0 1\", expected solid, or the end of the file (line 87)"),
            ),
            (
                "facets alone",
                text(facets(&mast(), "0 0 1")),
                Refused("expected solid, or the end of the file (line 1)"),
            ),
            (
                "a second solid cut off in a facet",
                text(one.clone() + &two[..two.len() / 2]),
                Refused("is it cut off? (line 12"),
            ),
            (
                "a second solid cut off before endsolid",
                text(one.clone() + two.trim_end().trim_end_matches("endsolid mast")),
                Refused("the file ends where facet or endsolid is expected; is it cut off? (line 171)"),
            ),
            (
                "no endsolid between solids",
                text(one.replace("endsolid base\n", "") + &two),
                Refused("found \"solid mast\", expected facet or endsolid (line 86)"),
            ),
            (
                "a zero byte at the end",
                text(one.clone() + "\0"),
                Refused("expected solid, or the end of the file (line 87)"),
            ),
            ("other text at the end", text(one.clone() + "bye"), Refused("found \"bye\", expected solid")),
            (
                "a facet in the line of a name",
                text(one.replacen("solid base\n", "solid base", 1)),
                Refused("found a facet in the line of a name, expected it in a line of its own (line 1)"),
            ),
        ],
    );
}

#[test]
fn stl_files_are_read_as_programs_write_them() {
    let plain = solid("mast", &mast());
    let with = |from: &str, to: &str| text(plain.replace(from, to));
    let named = |name: &[u8]| [b"solid ", name, &plain.as_bytes()[10..]].concat();
    let line = |number: usize, text: &str| {
        let mut lines: Vec<&str> = plain.lines().collect();
        lines[number - 1] = text;
        lines.join("\n").into_bytes()
    };
    let not_finite = [&mast()[..5], &[[[0.0, f64::INFINITY, 0.0]; 3]]].concat();
    assert_all(
        "stl",
        vec![
            ("plain", text(plain.clone()), Read(12, &[])),
            ("capitals", text(plain.to_uppercase()), Read(12, &[])),
            ("capitals at some places", with("solid", "Solid"), Read(12, &[])),
            ("a byte order mark", text(format!("\u{feff}{plain}")), Read(12, &[])),
            ("leading blanks and lines", text(format!("\n\r\n  \t {plain}")), Read(12, &[])),
            ("lines that end with CR LF", with("\n", "\r\n"), Read(12, &[])),
            ("lines that end with CR", with("\n", "\r"), Read(12, &[])),
            ("no line end at the end", text(plain.trim_end()), Read(12, &[])),
            ("tabs and no indents", with("      ", "\t"), Read(12, &[])),
            ("a name in Latin-1", named(b"M\xe4st \xdf"), Read(12, &[])),
            ("a name in Shift JIS", named(b"\x83\x5c\x95\x5c"), Read(12, &[])),
            ("a long name", named("solid endsolid facet of a mast ".repeat(30).as_bytes()), Read(12, &[])),
            (
                "normals that are not numbers",
                text(format!("solid\n{}endsolid", facets(&mast(), "NaN -nan 1.#QNAN"))),
                Read(12, &[]),
            ),
            ("numbers in many forms", with("vertex 0.9 0.9 0\n", "vertex +9E-1 .9 -0.\n"), Read(12, &[])),
            (
                "end solid",
                with("endsolid", "end solid"),
                Refused("found \"end solid mast\", expected facet or endsolid (line 86)"),
            ),
            ("end loop", with("endloop", "end loop"), Refused("found \"end loop\", expected endloop (line 7)")),
            (
                "a normal of two numbers",
                line(2, "facet normal 0 1"),
                Refused("expected facet normal and three numbers (line 2)"),
            ),
            ("a facet in one line", line(2, "facet normal 0 0 1 outer loop"), Refused("three numbers (line 2)")),
            (
                "a vertex of two numbers",
                line(4, "vertex 0 1"),
                Refused("found \"vertex 0 1\", expected vertex and three numbers (line 4)"),
            ),
            (
                "a vertex of four numbers",
                line(4, "vertex 0 1 2 3"),
                Refused("expected vertex and three numbers (line 4)"),
            ),
            ("two vertices", line(6, ""), Refused("found \"endloop\", expected vertex (line 7)")),
            (
                "four vertices",
                line(6, "vertex 0 0 0\nvertex 1 0 0"),
                Refused("found \"vertex 1 0 0\", expected endloop (line 7)"),
            ),
            ("a comma in a number", line(4, "vertex 0,5 1 2"), Refused("found \"0,5\", expected a number (line 4)")),
            ("an infinite number", line(4, "vertex 0 -inf 2"), Refused("found \"-inf\", which is not finite")),
            (
                "a number too large",
                line(4, "vertex 0 1e999 2"),
                Refused("found \"1e999\", which is not finite, expected a finite number (line 4)"),
            ),
            ("a colour", line(7, "endloop\ncolor 1 0 0"), Refused("found \"color 1 0 0\", expected endfacet (line 8)")),
            (
                "UTF-16",
                plain.encode_utf16().fold(vec![0xff, 0xfe], |b, c| [b, c.to_le_bytes().to_vec()].concat()),
                Refused("is text in UTF-16"),
            ),
            (
                "a picture",
                text("\u{89}PNG\r\n\u{1a}\n".repeat(30)),
                Refused("expected solid, or the end of the file (line 1)"),
            ),
            ("binary", binary("a mast", 12, &mast(), b""), Read(12, &[])),
            ("binary that begins with solid", binary("solid mast", 12, &mast(), b""), Read(12, &[])),
            (
                "binary with a tail",
                binary("a mast", 12, &mast(), &[7; 92]),
                Read(12, &["92 bytes after the 12 triangles are not read"]),
            ),
            (
                "binary that begins with solid, with a tail",
                binary("solid mast", 12, &mast(), &[7; 92]),
                Read(12, &["92 bytes after the 12 triangles are not read"]),
            ),
            (
                "binary that counts none",
                binary("a mast", 0, &mast(), b""),
                Refused("the header says 0 triangles, the file has room for 12"),
            ),
            (
                "binary that counts none, with a tail",
                binary("", 0, &mast(), &[0; 9]),
                Refused("the header says 0 triangles, the file has room for 12"),
            ),
            (
                "binary that counts too few",
                binary("solid mast", 7, &mast(), b""),
                Refused("the header says 7 triangles, the file has room for 12"),
            ),
            (
                "binary that counts too many",
                binary("a mast", 13, &mast(), &[7; 49]),
                Refused("ends after 12 of 13 triangles"),
            ),
            (
                "binary that begins with solid, cut off",
                binary("solid mast", 13, &mast(), b""),
                Refused("ends after 12 of 13 triangles"),
            ),
            (
                "two binary files in one",
                [binary("base", 12, &base(), b""), binary("mast", 12, &mast(), b"")].concat(),
                Refused("found a second binary file of 12 triangles after the first"),
            ),
            (
                "binary with an infinite number",
                binary("", 6, &not_finite, b""),
                Refused("triangle 5 has a coordinate that is not finite"),
            ),
            ("a header only", binary("", 0, &[], b""), Refused("found no triangles")),
            ("nothing", Vec::new(), Refused("found no triangles")),
        ],
    );
}

/// The corners of a box by the numbers of its corners.
const CORNERS: &str = "\
v 0.9 0.9 0\nv 1.1 0.9 0\nv 1.1 1.1 0\nv 0.9 1.1 0\nv 0.9 0.9 0.6\nv 1.1 0.9 0.6\nv 1.1 1.1 0.6\nv 0.9 1.1 0.6\n";
const FACES: &str = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

#[test]
fn obj_files_are_read_as_programs_write_them() {
    let whole = format!("{CORNERS}{FACES}");
    let faces = |from: &str, to: &str| text(format!("{CORNERS}{}", FACES.replace(from, to)));
    let beside = |line: &str| text(format!("{line}\n{CORNERS}{line}\n{FACES}{line}\n"));
    let around = |corners: &str| {
        let attributes = |word: &str| if word == "f" { "f".to_string() } else { corners.replace('i', word) };
        let face = |line: &str| line.split(' ').map(attributes).collect::<Vec<_>>().join(" ") + "\n";
        text(CORNERS.to_string() + &FACES.lines().map(face).collect::<String>())
    };
    let backward: String =
        (1..=8).fold(FACES.to_string(), |text, k| text.replace(&format!(" {k}"), &format!(" -{}", 9 - k)));
    let moved = CORNERS.replace("v 0.9", "v 0.2").replace("v 1.1", "v 0.4");
    assert_all(
        "obj",
        vec![
            ("plain", text(whole.clone()), Read(12, &[])),
            ("lines that end with CR LF", text(whole.replace('\n', "\r\n")), Read(12, &[])),
            ("lines that end with CR", text(whole.replace('\n', "\r")), Read(12, &[])),
            ("a byte order mark", text(format!("\u{feff}{whole}")), Read(12, &[])),
            ("no line end at the end", text(whole.trim_end()), Read(12, &[])),
            ("blanks and tabs", text(whole.replace(' ', " \t ").replace('\n', "  \n\n")), Read(12, &[])),
            ("corners 7/", around("i/"), Read(12, &[])),
            ("corners 7/1", around("i/1"), Read(12, &[])),
            ("corners 7/1/", around("i/1/"), Read(12, &[])),
            ("corners 7//3", around("i//3"), Read(12, &[])),
            ("corners 7/1/3", around("i/1/-3"), Read(12, &[])),
            (
                "corners 7/1/3/4",
                around("i/1/3/4"),
                Refused("found \"1/1/3/4\", expected a corner such as 7, 7/1 or 7//1 (line 9)"),
            ),
            ("corners 7/x", around("i/x"), Refused("found \"1/x\", expected a corner")),
            ("corners that count backward", text(format!("{CORNERS}{backward}")), Read(12, &[])),
            ("bodies one after the other", text(format!("{moved}{backward}{CORNERS}{backward}")), Read(24, &[])),
            ("faces before vertices", text(format!("{FACES}{CORNERS}")), Read(12, &[])),
            ("continued faces", faces(" 4 ", " \\\n4 \\\r\n"), Read(12, &[])),
            ("continued vertices", text(whole.replace(" 0.9 0", " \\\n 0.9 \\ \n0")), Read(12, &[])),
            ("a backslash at a word", faces("f 1 4", "f 1\\\n 4"), Read(12, &[])),
            (
                "a backslash between digits",
                faces("f 1 4", "f 1\\\n4"),
                Refused("found \"1\\\", expected a blank before the backslash (line 9)"),
            ),
            (
                "a backslash at the end",
                text(format!("{whole}f 1 2 3 \\")),
                Refused("line after a backslash is expected; is it cut off? (line 15)"),
            ),
            (
                "an error in a continued line",
                faces("f 5 6 7", "f 5 \\\n \\\n6 x 7"),
                Refused("found \"x\", expected a corner such as 7, 7/1 or 7//1 (line 10)"),
            ),
            (
                "an error after a continued line",
                faces("f 1 4 3 2\nf 5 6", "f 1 4 \\\n3 2\nf 5 x"),
                Refused("(line 11)"),
            ),
            ("comments", text(format!("# a # b\n{}", whole.replace('\n', " # comment\n"))), Read(12, &[])),
            ("comments without a blank", text(whole.replace('\n', "#1 2\n")), Read(12, &[])),
            ("a comment with a backslash at its end", beside("# from C:\\models\\"), Read(12, &[])),
            ("a comment with a backslash after a face", faces("\n", " # a\\\n"), Read(12, &[])),
            ("usemtl without a name", beside("usemtl"), Read(12, &[])),
            ("a missing material library", beside("mtllib no such file.mtl"), Read(12, &[])),
            ("a name with a backslash at its end", beside("g C:\\models\\"), Read(12, &[])),
            (
                "a name in Shift JIS, which contains a backslash",
                [b"g \x83\x5c\n", whole.as_bytes()].concat(),
                Read(12, &[]),
            ),
            ("a name in Latin-1", [b"o M\xe4st\n", whole.as_bytes()].concat(), Read(12, &[])),
            ("groups", text(whole.replace("f ", "g side\nusemtl red\ns off\nf ")), Read(12, &[])),
            (
                "looks",
                beside(
                    "vt 0 1\nvn 0 0 1\nvp 1 2\ns 1\nmg 1 2\nbevel on\nlod 3\nc_interp on\nd_interp on\nshadow_obj a.obj\ntrace_obj b.obj",
                ),
                Read(12, &[]),
            ),
            ("colours of vertices", text(CORNERS.replace('\n', " 0.5 1 0\n") + FACES), Read(12, &[])),
            ("weights of 1", text(CORNERS.replace('\n', " 1.0\n") + FACES), Read(12, &[])),
            (
                "weights",
                text(CORNERS.replace('\n', " 2\n") + FACES),
                Refused(
                    "found a vertex with the weight 2, expected 1 or none: weights belong to curves and curved surfaces (line 1)",
                ),
            ),
            (
                "a vertex of two numbers",
                text(format!("v 1 2\n{whole}")),
                Refused("found a vertex with 2 numbers, expected x y z, x y z w or x y z r g b (line 1)"),
            ),
            (
                "a vertex of five numbers",
                text(format!("v 1 2 3 4 5\n{whole}")),
                Refused("found a vertex with 5 numbers"),
            ),
            (
                "a comma in a number",
                text(whole.replace("0.6", "0,6")),
                Refused("found \"0,6\", expected a number (line 5)"),
            ),
            (
                "an infinite number",
                text(whole.replace("0.6", "inf")),
                Refused("found \"inf\", which is not finite, expected a finite number (line 5)"),
            ),
            ("faces in the old way", faces("f ", "fo "), Read(12, &[])),
            (
                "lines",
                text(format!("{whole}l 1 2 3\nl 1 7\np 1\n")),
                Read(12, &["3 lines or points have no surface: not read (the first in line 15)"]),
            ),
            (
                "only a line",
                text(format!("{CORNERS}l 1 2 3\n")),
                Refused(
                    "found no triangles, expected at least one; 1 line or point has no surface: not read (line 9); 8 vertices belong to no face (the first in line 1)",
                ),
            ),
            (
                "a vertex without a face",
                text(format!("{CORNERS}v 9 9 9\n{FACES}")),
                Read(12, &["1 vertex belongs to no face (line 9)"]),
            ),
            (
                "a face with two corners",
                text(format!("{whole}f 1 2\n")),
                Refused("found a face with 2 corners, expected at least 3 (line 15)"),
            ),
            (
                "a face without corners",
                text(format!("{whole}f\n")),
                Refused("found a face with 0 corners, expected at least 3 (line 15)"),
            ),
            (
                "indices from 0",
                text(format!("{CORNERS}f 0 1 2\n")),
                Refused("found the index 0, but indices start at 1 (line 9)"),
            ),
            (
                "an index too large",
                text(format!("{CORNERS}f 1 2 3\nf 1 2 9\n")),
                Refused("found the index 9, but the file has 8 vertices (line 10)"),
            ),
            (
                "an index too far back",
                text(format!("f 1 2 -9\n{CORNERS}")),
                Refused("found the index -9, but 0 vertices precede it (line 1)"),
            ),
            (
                "a number as a corner",
                text(format!("{CORNERS}f 1 2 3.0\n")),
                Refused("found \"3.0\", expected a corner such as 7, 7/1 or 7//1 (line 9)"),
            ),
            (
                "a misspelt statement",
                text(format!("{whole}face 1 2 3\n")),
                Refused("found \"face\", expected a statement of an OBJ file, such as v or f (line 15)"),
            ),
            (
                "a statement in capitals",
                text(whole.replace("f 3", "F 3")),
                Refused("found \"F\", expected a statement of an OBJ file, such as v or f (line 13)"),
            ),
            (
                "a statement from another file",
                beside("call mast.obj"),
                Refused("found \"call\", which refers to something outside, expected a file that is complete (line 1)"),
            ),
            ("a command", beside("csh ls"), Refused("found \"csh\"")),
            (
                "a name in two lines",
                text(format!("g a \\\nb\n{whole}")),
                Refused("found \"b\", expected a statement of an OBJ file"),
            ),
            (
                "UTF-16",
                whole.encode_utf16().fold(vec![0xff, 0xfe], |b, c| [b, c.to_le_bytes().to_vec()].concat()),
                Refused("is text in UTF-16"),
            ),
            (
                "a polygon that crosses itself",
                text(format!("{CORNERS}f 1 2 6 5\nf 1 2 4 3\nf 5 7 8\nf 5 6 8 7\n")),
                Read(
                    7,
                    &[
                        "2 polygons cannot be filled by triangles, probably because sides cross: covered by a fan of triangles each, which may reach beyond (the first in line 10)",
                    ],
                ),
            ),
            (
                "a polygon without area",
                text("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nf 1 2 3 4\nf 1 4 5\n"),
                Read(3, &["1 polygon cannot be filled by triangles"]),
            ),
            (
                "polygons with corners between their neighbours",
                text("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 2 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n"),
                Read(4, &[]),
            ),
        ],
    );
    let curved = [
        "cstype bezier",
        "deg 3",
        "bmat u 1",
        "step 1",
        "curv 0 1 1 2",
        "curv2 1 2",
        "surf 0 1 0 1 1 2 3 4",
        "parm u 0 1",
        "trim 0 1 1",
        "hole 0 1 1",
        "scrv 0 1 1",
        "sp 1",
        "end",
        "con 1 0 1 1 2 0 1 1",
        "ctech curv 1 1",
        "stech curv 1 1",
        "bzp 1 2 3 4",
        "bsp 1 2 3",
        "cdc 1 2 3",
        "cdp 1 2 3",
        "res 3 3",
    ];
    for statement in curved {
        let message = read("mesh.obj", &text(format!("{CORNERS}{statement}\n{FACES}"))).unwrap_err().to_string();
        let keyword = statement.split(' ').next().unwrap();
        let expected = format!(
            "found \"{keyword}\", which belongs to a curve or a curved surface, expected polygons (f): export the model as a mesh (line 9)"
        );
        assert!(message.contains(&expected), "{message}");
    }
}

#[test]
fn coordinates_are_read_as_they_are_written() {
    let mesh = read("mesh.stl", &text(solid("", &[[[0.1, 1e-9, 123456789.123], [1.0, 0.0, -0.0], [0.3, 7.0, 1.0]]])))
        .unwrap()
        .mesh;
    assert_eq!(mesh.vertices[0].coords.as_slice(), [0.1, 1e-9, 123456789.123]);
    let mesh = read("mesh.stl", &binary("", 12, &mast(), b"")).unwrap().mesh;
    assert_eq!(mesh.vertices.len(), 8, "corners at equal coordinates are one");
    assert!(mesh.vertices.iter().all(|v| v.x == f64::from(0.9f32) || v.x == f64::from(1.1f32)));
}
