//! A short fuzz without instrumentation: seeds with a few changes, always the same ones. `CDPR_FUZZ_CASES=N` makes N
//! times as many. A failure is shrunk to the fewest changes and saved as a file.

use std::fs;

use cdpr_fuzz::{MEMORY, Memory, READERS, inputs, read_in_time, reader};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::test_runner::{Config, RngSeed, TestError, TestRunner};

#[global_allocator]
static ALLOCATOR: Memory = Memory::new(std::alloc::System, MEMORY);

/// Cases per reader: some seconds for all of them.
const CASES: u32 = 500;

/// Cases for readers whose results take long to use: meshes are decomposed, tables of runs described.
const FEW_CASES: u32 = 100;
const SLOW: [&str; 5] = ["mesh_stl", "mesh_obj", "parts_json", "summary_json", "trials_csv"];

/// Unusual numbers.
const NUMBERS: [&str; 18] = [
    "0",
    "-0.0",
    "-1",
    "0.5",
    "1e-7",
    "1e-9",
    "5e-324",
    "1e6",
    "1e19",
    "1e100",
    "1e308",
    "-1e308",
    "1e999",
    "nan",
    "-inf",
    "4294967296",
    "9223372036854775807",
    "18446744073709551615",
];

/// Keywords of the formats.
const WORDS: [&str; 28] = [
    "[",
    "[[",
    "]",
    "{",
    "}",
    "\"",
    "'''",
    "<",
    "</",
    "<!DOCTYPE a [<!ENTITY b \"b\">]>",
    "&amp;",
    "&b;",
    "<![CDATA[",
    "#",
    "\n",
    "\n---\n",
    "&a [*a, *a]",
    "null",
    "true",
    "= ",
    ": ",
    ",",
    ",,,",
    "/",
    "f -1 1 2\n",
    "v 1 2\n",
    "\u{fffd}",
    "solid",
];

/// A change to a file.
#[derive(Debug, Clone)]
enum Change {
    Byte(Index, u8),
    Number(Index, &'static str),
    Insert(Index, &'static str),
    Remove(Index, usize),
    Repeat(Index, usize, usize),
    Copy(Index, Index, usize),
    Cut(Index),
}

fn change() -> impl Strategy<Value = Change> {
    let at = any::<Index>;
    prop_oneof![
        3 => (at(), any::<u8>()).prop_map(|(at, byte)| Change::Byte(at, byte)),
        8 => (at(), select(&NUMBERS[..])).prop_map(|(at, number)| Change::Number(at, number)),
        3 => (at(), select(&WORDS[..])).prop_map(|(at, word)| Change::Insert(at, word)),
        3 => (at(), 1..60_usize).prop_map(|(at, length)| Change::Remove(at, length)),
        1 => (at(), 1..200_usize, 2..200_usize).prop_map(|(at, length, times)| Change::Repeat(at, length, times)),
        4 => (at(), at(), 1..200_usize).prop_map(|(from, to, length)| Change::Copy(from, to, length)),
        1 => at().prop_map(Change::Cut),
    ]
}

impl Change {
    fn apply(&self, bytes: &mut Vec<u8>) {
        let place = |at: &Index| at.index(bytes.len() + 1);
        let piece = |at: &Index, length: usize| place(at)..(place(at) + length).min(bytes.len());
        match self {
            Change::Byte(at, byte) if !bytes.is_empty() => {
                let at = at.index(bytes.len());
                bytes[at] = *byte;
            }
            Change::Byte(..) => {}
            Change::Number(at, number) => {
                let numbers = numbers(bytes);
                if !numbers.is_empty() {
                    bytes.splice(at.get(&numbers).clone(), number.bytes());
                }
            }
            Change::Insert(at, word) => drop(bytes.splice(place(at)..place(at), word.bytes())),
            Change::Remove(at, length) => drop(bytes.drain(piece(at, *length))),
            Change::Repeat(at, length, times) => {
                let piece = piece(at, *length);
                let copies = bytes[piece.clone()].repeat(*times);
                bytes.splice(piece, copies);
            }
            Change::Copy(from, to, length) => {
                let (copy, to) = (bytes[piece(from, *length)].to_vec(), place(to));
                bytes.splice(to..to, copy);
            }
            Change::Cut(at) => bytes.truncate(place(at)),
        }
    }
}

/// The positions of the numbers in a text.
fn numbers(bytes: &[u8]) -> Vec<std::ops::Range<usize>> {
    let of_number = |byte: &u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'-');
    let runs = bytes.chunk_by(|a, b| of_number(a) == of_number(b));
    let places = runs.scan(0, |at, run| {
        *at += run.len();
        Some((*at - run.len()..*at, of_number(&run[0])))
    });
    places.filter_map(|(place, is_number)| is_number.then_some(place)).collect()
}

fn fuzz(name: &str) {
    let reader = reader(name);
    let folder = inputs("seeds").join(name);
    let mut paths: Vec<_> = fs::read_dir(folder).unwrap().map(|file| file.unwrap().path()).collect();
    paths.sort();
    let seeds: Vec<Vec<u8>> = paths.iter().map(|path| fs::read(path).unwrap()).collect();
    let times: u32 = std::env::var("CDPR_FUZZ_CASES").map_or(1, |times| times.parse().unwrap());
    let config = Config {
        cases: times * if SLOW.contains(&name) { FEW_CASES } else { CASES },
        rng_seed: RngSeed::Fixed(1),
        failure_persistence: None,
        max_shrink_time: 60_000,
        ..Config::default()
    };
    let inputs = (select(seeds), vec(change(), 1..6)).prop_map(|(mut bytes, changes)| {
        changes.iter().for_each(|change| change.apply(&mut bytes));
        bytes
    });
    let result = TestRunner::new(config).run(&inputs, |input| {
        read_in_time(reader, input);
        Ok(())
    });
    if let Err(TestError::Fail(reason, input)) = result {
        let kept = std::env::temp_dir().join(format!("cdpr-fuzz-{name}"));
        fs::write(&kept, input).unwrap();
        panic!("{reason}; the input is kept in {}", kept.display());
    }
    result.unwrap();
}

macro_rules! each {
    ($($name:ident)*) => {
        $(#[test] fn $name() { fuzz(stringify!($name)); })*
        #[test]
        fn no_reader_is_left_out() {
            assert_eq!(READERS.map(|reader| reader.name), [$(stringify!($name)),*]);
        }
    };
}

each!(scene_toml scene_json robot_toml path_json path_csv task_json lengths_csv trajectory_json trajectory_csv experiment_toml caspr_cables caspr_bodies
    gazebo_yaml mesh_stl mesh_obj parts_json wrench_map_npz run_json rows_csv summary_json trials_csv);
