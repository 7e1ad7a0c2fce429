//! Damaged mesh files: whatever is accepted has exactly the triangles that a plain reader finds.

use std::collections::BTreeMap;
use std::fs;

use cdpr_core::geometry::TriangleMesh;
use cdpr_files::load_mesh_file;
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Damaged files of each kind; `CDPR_FUZZ_CASES=N` makes N times as many.
const CASES: usize = 17_000;

type Corner = [f64; 3];

/// The corners of all faces, by a plain reader. These readers accept more than the program does: they are asked only
/// about files that the program accepts.
type Plain = fn(&[u8]) -> Option<Vec<Vec<Corner>>>;

/// The words of all lines, in Latin-1.
fn table(bytes: &[u8]) -> Vec<Vec<String>> {
    let text: String = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).iter().map(|b| *b as char).collect();
    let text = text.replace("\r\n", "\n").replace('\r', "\n").replace('\x0b', " ");
    text.split('\n').map(|line| line.split_ascii_whitespace().map(str::to_string).collect()).collect()
}

fn corner(words: &[String]) -> Option<Corner> {
    let numbers: Vec<f64> = words.iter().map(|word| word.parse().ok()).collect::<Option<_>>()?;
    numbers.try_into().ok()
}

/// Solids of facets of seven lines each.
fn plain_stl(bytes: &[u8]) -> Option<Vec<Vec<Corner>>> {
    if bytes.len() >= 84 {
        let told = u32::from_le_bytes(bytes[80..84].try_into().unwrap()) as usize;
        if 84 + 50 * told <= bytes.len() {
            let number = |k: usize| f64::from(f32::from_le_bytes(bytes[k..k + 4].try_into().unwrap()));
            let corner = |at: usize| [number(at), number(at + 4), number(at + 8)];
            return Some(
                (0..told).map(|k| 84 + 50 * k + 12).map(|k| vec![corner(k), corner(k + 12), corner(k + 24)]).collect(),
            );
        }
    }
    let mut lines = table(bytes).into_iter().filter(|line| !line.is_empty()).peekable();
    let mut found = Vec::new();
    while let Some(line) = lines.next() {
        line[0].eq_ignore_ascii_case("solid").then_some(())?;
        while lines.peek()?[0].eq_ignore_ascii_case("facet") {
            let facet: Vec<Vec<String>> = lines.by_ref().take(7).collect();
            let keywords: Vec<String> = facet.iter().map(|line| line[0].to_ascii_lowercase()).collect();
            (keywords == ["facet", "outer", "vertex", "vertex", "vertex", "endloop", "endfacet"]).then_some(())?;
            found.push(facet[2..5].iter().map(|line| corner(&line[1..])).collect::<Option<_>>()?);
        }
        lines.next()?[0].eq_ignore_ascii_case("endsolid").then_some(())?;
    }
    Some(found)
}

/// Joined lines, then vertices, then faces.
fn plain_obj(bytes: &[u8]) -> Option<Vec<Vec<Corner>>> {
    const NAMES: [&str; 8] = ["g", "o", "usemtl", "mtllib", "usemap", "maplib", "shadow_obj", "trace_obj"];
    let text: Vec<u8> = bytes.to_vec();
    let mut statements: Vec<Vec<String>> = Vec::new();
    let mut continues = false;
    for line in table(&text) {
        let comment = line.iter().position(|word| word.contains('#'));
        let mut words = line[..comment.map_or(line.len(), |k| k + 1)].to_vec();
        if let Some(last) = words.last_mut() {
            *last = last.split('#').next()?.to_string();
        }
        words.retain(|word| !word.is_empty());
        if continues {
            statements.last_mut()?.extend(words);
        } else {
            statements.push(words);
        }
        let whole = statements.last_mut()?;
        continues = whole.last().is_some_and(|w| w.ends_with('\\')) && !NAMES.contains(&whole[0].as_str());
        if continues {
            whole.last_mut()?.pop();
            whole.retain(|word| !word.is_empty());
        }
    }
    let is = |line: &&Vec<String>, keyword: &str| line.first().is_some_and(|word| word == keyword);
    let vertices: Vec<Corner> =
        statements.iter().filter(|s| is(s, "v")).map(|s| corner(s.get(1..4)?)).collect::<Option<_>>()?;
    let mut before = 0;
    let mut faces = Vec::new();
    for statement in &statements {
        before += usize::from(is(&statement, "v"));
        if is(&statement, "f") || is(&statement, "fo") {
            let place = |word: &String| {
                let index: i64 = word.split('/').next()?.parse().ok()?;
                let from_start = if index < 0 { before as i64 + index } else { index - 1 };
                vertices.get(usize::try_from(from_start).ok()?).copied()
            };
            faces.push(statement[1..].iter().map(place).collect::<Option<_>>()?);
        }
    }
    Some(faces)
}

/// Edges that belong to faces on one side only, with how often more in the one direction than in the other.
fn rims<'a>(faces: impl Iterator<Item = &'a [Corner]>) -> BTreeMap<[[u64; 3]; 2], i64> {
    let mut rims = BTreeMap::new();
    for face in faces {
        for k in 0..face.len() {
            let [a, b] = [face[k], face[(k + 1) % face.len()]].map(|p| p.map(|x| (x + 0.0).to_bits()));
            if a != b {
                *rims.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
            }
        }
    }
    rims.retain(|_, number| *number != 0);
    rims
}

/// Triangles as they are, and polygons filled: no edge is left within them.
fn assert_equal(mesh: &TriangleMesh, faces: &[Vec<Corner>]) {
    let triangles: Vec<Vec<Corner>> =
        mesh.triangles.iter().map(|t| t.iter().map(|i| mesh.vertices[*i].into()).collect()).collect();
    if faces.iter().all(|face| face.len() == 3) {
        assert_eq!(triangles, faces);
    }
    assert!(triangles.len() <= faces.iter().map(|face| face.len() - 2).sum());
    assert_eq!(rims(triangles.iter().map(Vec::as_slice)), rims(faces.iter().map(Vec::as_slice)));
}

/// Words that a damaged file may contain.
const WORDS: [&str; 40] = [
    "solid",
    "SOLID b",
    "endsolid",
    "endsolid\nsolid c",
    "facet normal 0 0 1",
    "outer loop",
    "vertex 1 2 3",
    "endloop",
    "endfacet",
    "Endfacet",
    "vertex",
    "v",
    "v 1 2 3",
    "v 1 2 3 1",
    "v 1 2 3 2",
    "v 1 2 3 0.5 0.5 0.5",
    "f",
    "f 1 2 3",
    "f 1 2 4 3",
    "f -1 -2 -3",
    "f 3/1 2//1 1/2/3",
    "fo 1 3 2",
    "l 1 2 3",
    "p 1",
    "surf 0 1 0 1 1 2 3 4",
    "call a.obj",
    "g a\\",
    "usemtl",
    "# a",
    "#",
    "\\\n",
    " \\\n ",
    "0",
    "-0",
    "1e9",
    "nan",
    "inf",
    "\u{feff}",
    "\u{e4}",
    "\t",
];

/// A file with some changes.
fn damaged(seed: &[u8], rng: &mut ChaCha8Rng) -> Vec<u8> {
    let mut bytes = seed.to_vec();
    for _ in 0..rng.random_range(1..4) {
        let at = rng.random_range(0..=bytes.len());
        let to = (at + rng.random_range(0..40)).min(bytes.len());
        let lines: Vec<usize> = (0..bytes.len()).filter(|k| bytes[*k] == b'\n').map(|k| k + 1).collect();
        let line = *lines.choose(rng).unwrap_or(&0);
        match rng.random_range(0..10) {
            0 if at < bytes.len() => bytes[at] = rng.random(),
            1 if at < bytes.len() => bytes[at] = *b"0123456789-./\\# \n\rfvlpgsoe".choose(rng).unwrap(),
            2 => drop(bytes.drain(at..to)),
            3 => bytes.truncate(at),
            4 => drop(bytes.splice(at..at, WORDS.choose(rng).unwrap().bytes())),
            5 => drop(bytes.splice(line..line, format!("{}\n", WORDS.choose(rng).unwrap()).into_bytes())),
            6 => {
                let copy = bytes[at..to].to_vec();
                let place = rng.random_range(0..=bytes.len());
                bytes.splice(place..place, copy);
            }
            7 => {
                let end = line + bytes[line..].iter().position(|b| *b == b'\n').map_or(bytes.len() - line, |k| k + 1);
                let whole = bytes.drain(line..end).collect::<Vec<u8>>();
                let place = if rng.random() { *lines.choose(rng).unwrap_or(&0) } else { bytes.len() };
                let place = place.min(bytes.len());
                let times = rng.random_range(0..3);
                bytes.splice(place..place, whole.repeat(times));
            }
            8 => bytes.extend(seed),
            _ => bytes[at..to].iter_mut().for_each(|b| *b = b.to_ascii_uppercase()),
        }
    }
    bytes
}

fn binary_seed(triangles: u32) -> Vec<u8> {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let mut bytes = [b"solid".to_vec(), vec![b' '; 75], triangles.to_le_bytes().to_vec()].concat();
    for _ in 0..triangles {
        bytes.extend((0..12).flat_map(|_| rng.random_range(-1.0..1.0f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

fn assert_agree(name: &str, seeds: &[Vec<u8>], plain: Plain) {
    let times: usize = std::env::var("CDPR_FUZZ_CASES").map_or(1, |times| times.parse().unwrap());
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    let mut accepted = 0;
    for case in 0..times * CASES {
        let mut rng = ChaCha8Rng::seed_from_u64(case as u64);
        let seed = seeds.choose(&mut rng).unwrap();
        let bytes = if case < seeds.len() { seeds[case].clone() } else { damaged(seed, &mut rng) };
        fs::write(&path, &bytes).unwrap();
        match load_mesh_file(&path) {
            Ok(file) => {
                accepted += 1;
                let faces = plain(&bytes).unwrap_or_else(|| panic!("{}", String::from_utf8_lossy(&bytes)));
                let same = std::panic::catch_unwind(|| assert_equal(&file.mesh, &faces));
                assert!(same.is_ok(), "case {case}: {}", String::from_utf8_lossy(&bytes));
            }
            Err(error) => {
                let message = error.to_string();
                assert!(
                    case >= seeds.len() && message.contains(" (line ") || message.contains("triangle"),
                    "{message}"
                );
            }
        }
    }
    assert!(10 * accepted > times * CASES, "{accepted}: too few are accepted to say anything");
}

#[test]
fn damaged_stl_files_match_a_plain_reader() {
    let facet = |a: &str| {
        format!(
            "facet normal 0 0 1\n outer loop\n  vertex 0 0 {a}\n  vertex 1 0 0\n  vertex 0 1.5 -2e-1\n endloop\nendfacet\n"
        )
    };
    let solid = |name: &str, facets: &[&str]| {
        format!("solid {name}\n{}endsolid {name}\n", facets.iter().map(|a| facet(a)).collect::<String>())
    };
    let one = solid("a", &["1", "2"]);
    let two = format!("{one}{}", solid("b c", &["3", "4", "5"]));
    let seeds = [one.clone(), two.clone(), two.to_uppercase(), one.replace('\n', "\r\n")].map(String::into_bytes);
    assert_agree("mesh.stl", &[&seeds[..], &[binary_seed(3)]].concat(), plain_stl);
}

#[test]
fn damaged_obj_files_match_a_plain_reader() {
    let corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
    let triangles = format!("# three\no a\n{corners}f 1 2 3\nf 4/1 5//2 6/3/4\nf -1 -2 -3\n");
    let polygons = format!("{corners}g sides\nusemtl red\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 \\\n 6 5\nfo 2 3 7 6\n");
    let moved = format!("{polygons}{}", polygons.replace("f 1 4 3 2", "f -8 -5 -6 -7").replace("v 1", "v 3"));
    let colours =
        format!("vt 0 1\nvn 0 0 1\n{}f 1 3 2 # first\nl 1 2\nf 4 6 8\n", corners.replace('\n', " 0.5 1 0.25\n"));
    let seeds = [triangles.clone(), polygons, moved, colours, triangles.replace('\n', "\r\n")].map(String::into_bytes);
    assert_agree("mesh.obj", &seeds, plain_obj);
}
