//! Wrench maps: margins against the definition, summaries by hand, valid files read back bit for bit and invalid ones
//! rejected; wrench sets as surfaces against the exact volume and the margins.

use std::io::{Cursor, Read, Write};
use std::path::Path;
use std::sync::atomic::{AtomicI32, Ordering};

use cdpr_core::batch::BatchOptions;
use cdpr_core::error::ErrorClass;
use cdpr_core::geometry::{Aabb, Point, Vector};
use cdpr_core::model::Robot;
use cdpr_core::testing::paper_robot;
use cdpr_core::watch::Watch;
use cdpr_core::wrench::map::{Grid, Margins};
use cdpr_core::wrench::{
    CapacityMargin, Loads, MapIdentity, MapOptions, Required, Statics, WrenchMap, force_limit, force_set, moment_limit,
    moment_set,
};
use cdpr_files::{load_wrench_map, save_wrench_map};
use cdpr_tests::{built_robot, point_robot, rng};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use zip::write::SimpleFileOptions;

const QUIET: BatchOptions = BatchOptions { threads: None, watch: Watch::NONE };

fn cogiro() -> Statics {
    Statics::new(&built_robot("cogiro"), &Loads::default()).unwrap()
}

fn balls() -> Required {
    Required::balls(50.0, 5.0).unwrap()
}

fn around() -> Aabb {
    Aabb { min: Point::new(-3.0, -2.0, 0.0), max: Point::new(3.0, 2.1, 4.0) }
}

fn map(statics: &Statics, required: &Required, within: &Aabb, step: f64, projected: bool) -> WrenchMap {
    WrenchMap::new(statics, required, within, &MapOptions { step, projected }, &QUIET).unwrap()
}

/// A point on six cables along the axes, 0 to 10 N each: forces fill a cube around the origin.
fn orthogonal(far: f64) -> Statics {
    let axis = |k: usize| std::array::from_fn(|i| if i == k / 2 { far * [1.0, -1.0][k % 2] } else { 0.0 });
    Statics::new(
        &point_robot(&std::array::from_fn::<_, 6, _>(|k| (axis(k), [0.0; 3], [0.0, 10.0])), 0.4),
        &Loads::default(),
    )
    .unwrap()
}

fn random_robot(rng: &mut ChaCha8Rng, cables: usize) -> Robot {
    let mut cable = || {
        let outlet = std::array::from_fn(|_| rng.random_range(-3.0..3.0));
        let attachment = std::array::from_fn(|_| rng.random_range(-0.4..0.4));
        let least = rng.random_range(0.0..50.0);
        (outlet, attachment, [least, least + rng.random_range(1.0..2000.0)])
    };
    point_robot(&(0..cables).map(|_| cable()).collect::<Vec<_>>(), 0.4)
}

#[test]
fn nodes_have_the_margins_of_their_positions() {
    let (statics, required) = (cogiro(), balls());
    let capacity = CapacityMargin::new(statics.clone(), required.clone()).unwrap();
    let map = map(&statics, &required, &around(), 0.5, true);
    let grid = map.grid();
    assert_eq!(grid.counts, [13, 9, 9]); // the last node along y is 2.0, the last one below 2.1
    let Margins { capacity: found, force: Some(force), moment: Some(moment) } = map.margins() else { panic!() };
    for n in 0..grid.len() {
        let p = grid.position(n);
        assert_eq!(found[n].to_bits(), capacity.at(&p).to_bits());
        assert_eq!(force[n], force_limit(&statics, &p).unwrap().margin);
        assert_eq!(moment[n], moment_limit(&statics, &p).unwrap().margin);
    }
    let node = grid.index([2, 3, 4]);
    assert_eq!(grid.position(node), Point::new(-2.0, -0.5, 2.0));
}

#[test]
fn every_number_of_threads_gives_the_same_map() {
    let with = |threads| {
        let options = MapOptions { step: 0.3, projected: false };
        WrenchMap::new(&cogiro(), &balls(), &around(), &options, &BatchOptions { threads, ..QUIET }).unwrap()
    };
    assert_eq!(with(Some(1)), with(Some(2)));
    assert_eq!(with(Some(1)), with(None));
}

#[test]
fn the_feasible_region_of_a_point_between_far_outlets_is_known() {
    // Outlets so far away that directions hardly change: the margin is 10 N − 3.924 N − 2 N throughout a small box.
    let within = Aabb { min: Point::new(-0.2, -0.2, -0.2), max: Point::new(0.2, 0.2, 0.2) };
    let map = map(&orthogonal(1e5), &Required::balls(2.0, 0.0).unwrap(), &within, 0.1, true);
    let summary = map.summary();
    assert_eq!((summary.nodes, summary.feasible, summary.share), (125, 125, 1.0));
    assert!((summary.volume - 0.125).abs() < 1e-12);
    assert!((summary.least.unwrap().margin - 4.076).abs() < 1e-3);
    assert!((summary.greatest.unwrap().margin - 4.076).abs() < 1e-3);
    assert!(map.margins().moment.is_none(), "a point mass has no moments");
}

#[test]
fn no_feasible_nodes_without_yaw_and_none_on_an_outlet() {
    let statics = Statics::new(&Robot::try_from(paper_robot()).unwrap(), &Loads::default()).unwrap();
    let within = Aabb { min: Point::new(0.4, 0.4, 0.4), max: Point::new(1.6, 1.6, 1.6) };
    assert_eq!(map(&statics, &Required::default(), &within, 0.2, false).summary().feasible, 0);
    let at_outlets = Aabb { min: Point::new(-1.0, 0.0, 0.0), max: Point::new(1.0, 0.0, 0.0) };
    let map = map(&orthogonal(1.0), &Required::default(), &at_outlets, 0.25, true);
    assert_eq!(map.summary().undefined, 2);
    assert!(map.margins().force.as_ref().unwrap()[0].is_nan());
}

#[test]
fn invalid_maps_are_refused_and_long_ones_interruptible() {
    let ask = |required: &Required, step, batch: &BatchOptions| {
        WrenchMap::new(&orthogonal(5.0), required, &around(), &MapOptions { step, projected: false }, batch)
            .unwrap_err()
    };
    assert!(ask(&balls(), 0.1, &QUIET).to_string().starts_with("moment: found a required moment"));
    let force = Required::balls(1.0, 0.0).unwrap();
    assert!(ask(&force, 1e-5, &QUIET).to_string().starts_with("step: found 0.00001 m, which makes 9.8e16 nodes"));
    assert!(ask(&force, 0.1, &BatchOptions { threads: Some(0), ..QUIET }).to_string().starts_with("threads: found 0"));
    let asked = AtomicI32::new(0);
    let interrupted = || asked.fetch_add(1, Ordering::Relaxed) == 2;
    let error = ask(&force, 0.02, &BatchOptions { threads: None, watch: Watch::on(&interrupted) });
    assert_eq!((error.class(), asked.into_inner()), (ErrorClass::Interrupted, 3));
}

#[test]
fn a_map_needs_no_allocation_for_a_node() {
    let count = |step| {
        let batch = BatchOptions { threads: Some(1), ..QUIET };
        let (statics, required) = (cogiro(), balls());
        let options = MapOptions { step, projected: false };
        let work = || drop(WrenchMap::new(&statics, &required, &around(), &options, &batch).unwrap());
        allocation_counter::measure(work).count_total
    };
    assert_eq!(count(0.5), count(0.25));
}

fn extreme_map() -> WrenchMap {
    let mut rng = rng(3);
    let grid = Grid { origin: Point::new(0.1 + 0.2, -1e-7, 3.0), step: 0.1, counts: [3, 4, 5] };
    let mut numbers = || -> Vec<f64> {
        let mut numbers: Vec<f64> = (0..60).map(|_| f64::from_bits(rng.random())).collect();
        numbers[..5].copy_from_slice(&[f64::NAN, -0.0, f64::INFINITY, 5e-324, f64::MIN]);
        numbers
    };
    let margins = Margins { capacity: numbers(), force: Some(numbers()), moment: None };
    WrenchMap::from_parts(grid, MapIdentity::of(&cogiro(), &balls()), margins).unwrap()
}

fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|x| x.to_bits()).collect()
}

#[test]
fn a_map_comes_back_from_its_file_bit_for_bit() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.npz");
    let map = extreme_map();
    save_wrench_map(&path, &map).unwrap();
    let read = load_wrench_map(&path, Some(map.identity())).unwrap();
    assert_eq!((read.grid(), read.identity()), (map.grid(), map.identity()));
    assert_eq!(bits(&read.margins().capacity), bits(&map.margins().capacity));
    assert_eq!(bits(read.margins().force.as_ref().unwrap()), bits(map.margins().force.as_ref().unwrap()));
    assert!(read.margins().moment.is_none());
}

#[test]
fn a_map_of_another_robot_is_refused_with_the_difference() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.npz");
    save_wrench_map(&path, &extreme_map()).unwrap();
    let heavier = MapIdentity::of(&cogiro(), &Required::balls(60.0, 5.0).unwrap());
    let error = load_wrench_map(&path, Some(&heavier)).unwrap_err().to_string();
    assert!(error.contains("map.npz: identity: found a map of another robot, load or demand, with required wrenches"));
    assert!(error.contains("force: 50.0") && error.contains("force: 60.0"), "{error}");
    assert!(load_wrench_map(&path, None).is_ok());
}

#[test]
fn wrong_and_missing_map_files_are_named() {
    let message = |path: &str| load_wrench_map(Path::new(path), None).unwrap_err().to_string();
    assert_eq!(message("map.csv"), "map.csv: found the extension .csv, expected .npz or .vti");
    assert!(message("map.vti").contains("for ParaView only"));
    assert!(message("no/such/map.npz").starts_with("no/such/map.npz: cannot be read: "));
    assert!(save_wrench_map(Path::new("no/such/map.npz"), &extreme_map()).unwrap_err().to_string().contains("written"));
}

fn refusal(folder: &Path, bytes: &[u8]) -> String {
    let path = folder.join("broken.npz");
    std::fs::write(&path, bytes).unwrap();
    let error = load_wrench_map(&path, None).unwrap_err();
    assert_eq!(error.class(), ErrorClass::Input);
    error.to_string()
}

#[test]
fn a_file_cut_short_or_altered_anywhere_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.npz");
    save_wrench_map(&path, &extreme_map()).unwrap();
    let whole = std::fs::read(&path).unwrap();
    for end in (0..whole.len()).step_by(97) {
        assert!(refusal(folder.path(), &whole[..end]).contains("found an incomplete or invalid .npz file"));
    }
    assert!(
        refusal(folder.path(), b"PK, but no zip file").contains("broken.npz: found an incomplete or invalid .npz file")
    );
    let (mut refused, mut tried) = (0, 0);
    for at in (0..whole.len()).step_by(7) {
        let mut altered = whole.clone();
        altered[at] ^= 0x10;
        std::fs::write(folder.path().join("altered.npz"), &altered).unwrap();
        let read = load_wrench_map(folder.path().join("altered.npz"), None);
        tried += 1;
        refused += usize::from(read.is_err());
        if let Ok(read) = read {
            // Times and attributes of the archive's entries do not matter to a map; numbers are protected by checksums.
            assert_eq!(bits(&read.margins().capacity), bits(&extreme_map().margins().capacity), "byte {at}");
            assert_eq!((read.grid(), read.identity()), (extreme_map().grid(), extreme_map().identity()));
        }
    }
    assert!(refused * 10 > tried * 8, "{refused} of {tried}");
}

/// The file of a map with one array replaced, added or left out (no bytes).
fn with_array(folder: &Path, name: &str, array: &[u8]) -> Vec<u8> {
    let path = folder.join("map.npz");
    save_wrench_map(&path, &extreme_map()).unwrap();
    let mut from = zip::ZipArchive::new(std::fs::File::open(&path).unwrap()).unwrap();
    let mut to = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default();
    let file = format!("{name}.npy");
    for k in 0..from.len() {
        let mut entry = from.by_index(k).unwrap();
        let own = entry.name().unwrap().into_owned();
        if own != file {
            let mut bytes = Vec::new();
            entry.read_to_end(&mut bytes).unwrap();
            to.start_file(own, options).unwrap(); // compressed, as by `numpy.savez_compressed`
            to.write_all(&bytes).unwrap();
        }
    }
    if !array.is_empty() {
        to.start_file(file, options).unwrap();
        to.write_all(array).unwrap();
    }
    to.finish().unwrap().into_inner()
}

/// A .npy file with this header text.
fn npy(header: &str, data: &[u8]) -> Vec<u8> {
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(data);
    bytes
}

#[test]
fn invalid_map_arrays_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let header = |kind: &str, shape: &str| {
        npy(&format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}\n"), &[0; 480])
    };
    let cases: [(&str, Vec<u8>, &str); 13] = [
        ("step", Vec::new(), "step: cannot be found"),
        ("margin", Vec::new(), "margin: cannot be found"),
        ("margin", header("<f8", "(3, 20)"), "margin: found shape [3, 20]"),
        ("margin", header("<f4", "(3, 4, 5)"), "margin: "),
        ("margin", header("<f8", "(3, 4, 6)"), "margin: "), // shorter than its shape
        ("margin", header("<f8", "(3, 4, 4)"), "margin: found more numbers than its shape allows"),
        ("margin", header("<f8", "(0, 4, 5)"), "margin: found"),
        ("margin", header("<f8", "(9223372036854775807, 9223372036854775807, 4)"), "margin: found shape"),
        ("force_margin", header("<f8", "(5, 4, 3)"), "force_margin: found shape [5, 4, 3]"),
        ("step", npy("{'descr': '<f8', 'fortran_order': False, 'shape': (), }\n", &[0; 8]), "step: found 0, expected"),
        ("metadata", header("<U9000000000", "()"), "metadata: found shape []"),
        (
            "metadata",
            npy("{'descr': '<U2', 'fortran_order': False, 'shape': (), }\n", b"{\0\0\0}\0\0\0"),
            "found format null",
        ),
        ("origin", b"not an array".to_vec(), "origin: "),
    ];
    for (name, array, words) in cases {
        let message = refusal(folder.path(), &with_array(folder.path(), name, &array));
        assert!(message.contains(words), "{message}, expected {words}");
    }
    let compressed = folder.path().join("compressed.npz");
    std::fs::write(&compressed, with_array(folder.path(), "note", b"ignored")).unwrap();
    assert!(load_wrench_map(&compressed, None).is_ok());
}

#[test]
fn a_vti_file_has_grid_and_numbers_x_fastest() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.vti");
    let map = extreme_map();
    save_wrench_map(&path, &map).unwrap();
    let bytes = std::fs::read(&path).unwrap();
    let marker = b"encoding=\"raw\">\n_";
    let start = bytes.windows(marker.len()).position(|w| w == marker).unwrap() + marker.len();
    let head = String::from_utf8(bytes[..start].to_vec()).unwrap();
    assert!(
        head.contains(
            "WholeExtent=\"0 2 0 3 0 4\" Origin=\"0.30000000000000004 -0.0000001 3\" Spacing=\"0.1 0.1 0.1\""
        )
    );
    assert!(head.contains("Name=\"margin\" format=\"appended\" offset=\"0\"") && head.contains("offset=\"488\""));
    let number = |n: usize| u64::from_le_bytes(bytes[start + 8 * n..][..8].try_into().unwrap());
    assert_eq!((number(0), number(61)), (480, 480));
    let at = |i, j, k| map.margins().capacity[map.grid().index([i, j, k])].to_bits();
    assert_eq!((number(1), number(2), number(4), number(1 + 12)), (at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 1)));
}

/// Volume of {Σ tᵢ gᵢ}: the sum over all choices of three of |det| times the three ranges.
fn exact_volume(edges: &[Vector]) -> f64 {
    let mut volume = 0.0;
    for i in 0..edges.len() {
        for j in i + 1..edges.len() {
            let normal = edges[i].cross(&edges[j]);
            volume += edges[j + 1..].iter().map(|g| normal.dot(g).abs()).sum::<f64>();
        }
    }
    volume
}

#[test]
fn wrench_sets_have_the_exact_volume_and_margin() {
    let mut rng = rng(5);
    for round in 0..160 {
        let cables = 1 + round % 16;
        let statics = Statics::new(&random_robot(&mut rng, cables), &Loads::default()).unwrap();
        let p = Point::from(std::array::from_fn(|_| rng.random_range(-2.0..2.0)));
        let columns = statics.columns(&p).unwrap();
        let point_mass = statics.point_mass(); // a single cable
        for rows in if point_mass { 0..1 } else { 0..2 } {
            let set = if rows == 0 { force_set(&statics, &p) } else { moment_set(&statics, &p) }.unwrap();
            let limit = if rows == 0 { force_limit(&statics, &p) } else { moment_limit(&statics, &p) }.unwrap();
            let ranges = statics.cables().iter().map(|cable| cable.tension[1] - cable.tension[0]);
            let edges: Vec<Vector> =
                columns.iter().zip(ranges).map(|(w, range)| w.fixed_rows::<3>(3 * rows) * range).collect();
            assert_eq!((set.rank, set.margin), (cables.min(3), limit.margin));
            assert_eq!(set.ball(), (limit.margin > 0.0).then_some((set.balance, limit.margin)));
            if set.rank < 3 {
                assert_eq!(set.mesh.triangles.len(), [0, 0, 4][set.rank]);
                continue;
            }
            let volume = exact_volume(&edges);
            assert!(set.mesh.is_watertight());
            assert!((set.mesh.volume() - volume).abs() <= 1e-11 * volume, "{} and {volume}", set.mesh.volume());
            assert_eq!(set.mesh.vertices.len(), cables * (cables - 1) + 2); // in general position
            assert_eq!(set.mesh.triangles.len(), 2 * set.mesh.vertices.len() - 4); // Euler
        }
    }
}

#[test]
fn the_facets_of_a_set_are_those_of_the_margin() {
    let mut rng = rng(6);
    let robots = ["cogiro", "ipanema2", "caroca"].map(built_robot);
    let mut inside = 0;
    for round in 0..60 {
        let statics = Statics::new(&robots[round % 3], &Loads::default()).unwrap();
        let p = Point::from(std::array::from_fn(|_| rng.random_range(-0.8..0.8)));
        let Ok(set) = force_set(&statics, &p) else { continue };
        let scale = statics.largest_tension();
        assert!(set.rank == 3 && set.mesh.is_watertight());
        let slack = |t: &[usize; 3]| {
            let normal = set.mesh.normal(t).unwrap();
            let support = normal.dot(&set.mesh.vertices[t[0]].coords);
            let heights = set.mesh.vertices.iter().map(|v| normal.dot(&v.coords) - support);
            assert!(heights.fold(f64::NEG_INFINITY, f64::max) <= 1e-9 * scale, "outward, and the set below each facet");
            let available = |cable: &cdpr_core::wrench::StaticCable| {
                let height = normal.dot(&cable.column(&p, 1.0).fixed_rows::<3>(0));
                (cable.tension[0] * height).max(cable.tension[1] * height)
            };
            assert!((statics.cables().iter().map(available).sum::<f64>() - support).abs() <= 1e-9 * scale);
            support - normal.dot(&set.balance)
        };
        let least = set.mesh.triangles.iter().map(slack).fold(f64::INFINITY, f64::min);
        assert!((least - set.margin).abs() <= 1e-9 * scale, "{least} and {}", set.margin);
        inside += usize::from(set.ball().is_some());
    }
    assert!(inside > 5, "{inside}");
}

#[test]
fn wrench_sets_of_simple_robots_are_as_expected() {
    let cube = force_set(&orthogonal(5.0), &Point::origin()).unwrap();
    assert_eq!((cube.rank, cube.mesh.vertices.len()), (3, 8));
    assert!((cube.mesh.volume() - 8000.0).abs() < 1e-9);
    let planar = point_robot(
        &[
            ([1.0, 0.0, 1.0], [0.0; 3], [1.0, 9.0]),
            ([-1.0, 0.0, 1.0], [0.0; 3], [1.0, 9.0]),
            ([0.0, 0.0, -1.0], [0.0; 3], [1.0, 9.0]),
        ],
        0.4,
    );
    let planar = Statics::new(&planar, &Loads::default()).unwrap();
    let set = force_set(&planar, &Point::origin()).unwrap();
    assert_eq!((set.rank, set.mesh.vertices.len(), set.ball()), (2, 6, None));
    assert!(set.mesh.is_watertight());
    let error = moment_set(&planar, &Point::origin()).unwrap_err().to_string();
    assert!(error.contains("attachments coincide"));
    let error = force_set(&planar, &Point::new(1.0, 0.0, 1.0)).unwrap_err().to_string();
    assert_eq!(error, "position: found [1, 0, 1], where cable 0 has no direction");
}
