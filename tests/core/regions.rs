//! Forbidden regions against the gjk engine: a position is in the mesh of a pair exactly where the engine names that
//! pair.

use std::collections::BTreeSet;
use std::path::PathBuf;

use cdpr_core::collision::{Conditions, GjkEngine, Interference, Kind, Validity};
use cdpr_core::geometry::{Aabb, Point, Rotation, TriangleMesh};
use cdpr_core::model::{BodySpec, RobotSource};
use cdpr_core::regions::{NamedMesh, RegionOptions, Space, regions, regions_within};
use cdpr_core::survey::survey;
use cdpr_core::testing::{block, hard1, hard3, paper_robot, paper_scene, scene};
use cdpr_core::watch::Watch;
use cdpr_core::{ErrorClass, Scene};
use cdpr_files::load_scene;
use cdpr_tests::{encloses, uniform};
use cdpr_view::{Contents, Form, page_within};
use rand::Rng;

fn testdata(name: &str) -> Scene {
    load_scene(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../testdata").join(name)).unwrap()
}

fn all() -> RegionOptions {
    RegionOptions { all: true, ..RegionOptions::default() }
}

fn inside(rng: &mut impl Rng, within: &Aabb) -> Point {
    Point::from(std::array::from_fn(|k| uniform(rng, within.min[k], within.max[k])))
}

/// Compares engine and meshes at random positions; returns the kinds of regions that were hit.
fn assert_same_as_engine(scene: &Scene) -> BTreeSet<Kind> {
    let engine = GjkEngine::new(scene, Interference::Exact).unwrap();
    let found = regions(scene, &all()).unwrap();
    assert_eq!(found.space, Space::Position);
    assert!(
        found.meshes.iter().all(|r| r.mesh.is_watertight() && (r.kind == Kind::CableCable || r.mesh.volume() > 0.0))
    );
    let solid: Vec<&NamedMesh> = found.meshes.iter().filter(|r| r.kind != Kind::CableCable).collect();
    let (mut rng, mut hit) = (cdpr_tests::rng(1), BTreeSet::new());
    for _ in 0..2000 {
        let p = inside(&mut rng, &found.within);
        let named = engine.violations(&p, &p).into_iter().map(|v| (v.kind, v.culprits));
        let drawn = solid.iter().filter(|r| encloses(&r.mesh, &p)).map(|r| (r.kind, r.culprits.clone()));
        let (named, drawn): (BTreeSet<_>, BTreeSet<_>) = (named.collect(), drawn.collect());
        assert_eq!(named, drawn, "{} at {p}", scene.name());
        hit.extend(named.into_iter().map(|(kind, _)| kind));
    }
    hit
}

#[test]
fn region_meshes_agree_with_the_engine() {
    let mut hit = BTreeSet::new();
    for scene in [
        hard1(),
        hard3(),
        testdata("scenes/concave.toml"),
        testdata("cases/own_platform.toml"),
        testdata("cases/outlet_on_column.toml"),
        testdata("cases/abutting.toml"),
        turned_with_a_mast(),
    ] {
        hit.extend(assert_same_as_engine(&scene));
    }
    assert_eq!(hit, BTreeSet::from([Kind::CablePlatform, Kind::PlatformObstacle, Kind::CableObstacle]));
}

/// The paper's robot, rotated, with a mast and a fin without volume on the platform, between two obstacles.
fn turned_with_a_mast() -> Scene {
    let mut robot = paper_robot();
    robot.platform.push(block("mast", [0.05, 0.05, 0.3], [0.0, 0.0, 0.175]));
    robot.platform.push(BodySpec {
        cuboid: Some([0.0, 0.1, 0.2]),
        position: Some([0.0, 0.0, -0.15]),
        ..BodySpec::default()
    });
    let obstacles =
        vec![block("post", [0.2, 0.3, 0.9], [0.6, 1.1, 0.45]), block("beam", [1.5, 0.1, 0.1], [1.0, 1.4, 1.3])];
    let mut spec = paper_scene("turned", obstacles);
    spec.robot = RobotSource::Inline(robot);
    let turn = Rotation::from_euler_angles(0.1, -0.2, 0.4);
    spec.query.as_mut().unwrap().orientation = Some([turn.w, turn.i, turn.j, turn.k].into());
    scene(spec)
}

#[test]
fn position_shadows_are_shifted_attachment_shadows() {
    let scene = turned_with_a_mast();
    let at = |space| regions(&scene, &RegionOptions { space: Some(space), ..RegionOptions::default() }).unwrap();
    let (attachment, position) = (at(Space::Attachment), at(Space::Position));
    let conditions = Conditions::new(&scene).unwrap();
    let mut rng = cdpr_tests::rng(2);
    for region in &position.meshes {
        let same = attachment.meshes.iter().find(|r| r.name == region.name).unwrap();
        let arm = conditions.bodies.cables.iter().find(|c| c.name == region.culprits[0]).unwrap().arm;
        for _ in 0..300 {
            let p = inside(&mut rng, &position.within);
            assert_eq!(encloses(&region.mesh, &p), encloses(&same.mesh, &(p + arm)), "{} at {p}", region.name);
        }
    }
}

#[test]
fn the_shadow_of_the_pillar_has_the_volume_of_its_columns() {
    // Over each point of the floor, seen from a corner of the floor: nothing is hidden beside the pillar [0.85, 1.15]²
    // or in front of it; behind it, everything below the ray over its near upper edge, which is 1.5 m high.
    let found = regions(&hard1(), &RegionOptions::default()).unwrap();
    let n = 2000;
    let (low, side) = (0.85 / 1.15, 2.0 / f64::from(n));
    let centres = || (0..n).map(|k| (f64::from(k) + 0.5) * side);
    let column = |x: f64, y: f64| {
        let hidden = y > low * x && x > low * y && x > 0.85 && y > 0.85;
        if hidden { (1.5 * x.min(y) / 0.85).min(2.0) } else { 0.0 }
    };
    let expected: f64 = centres().flat_map(|x| centres().map(move |y| column(x, y))).sum::<f64>() * side * side;
    let volume = found.meshes[0].mesh.volume();
    assert!((volume - expected).abs() < 1e-3 * expected, "{volume} {expected}");
}

#[test]
fn shadows_are_the_default_regions() {
    let found = regions(&hard3(), &RegionOptions::default()).unwrap();
    assert_eq!((found.space, found.meshes.len()), (Space::Attachment, 24));
    assert_eq!(found.meshes[5].name, "cable 1 / north");
    assert!(found.meshes.iter().all(|r| r.kind == Kind::CableObstacle));
    let every = regions(&hard3(), &all()).unwrap();
    let count = |kind| every.meshes.iter().filter(|r| r.kind == kind).count();
    assert_eq!((count(Kind::CableObstacle), count(Kind::PlatformObstacle)), (24, 3));
}

#[test]
fn parts_of_one_obstacle_are_pieces_of_one_mesh() {
    let concave = testdata("scenes/concave.toml");
    let found = regions(&concave, &RegionOptions::default()).unwrap();
    assert_eq!(found.meshes.iter().filter(|r| r.culprits[0] == "cable 0").count(), 2);
    let pieces = |mesh: &TriangleMesh| {
        let edges = mesh.edges().collect::<Vec<_>>();
        let mut label: Vec<usize> = (0..mesh.vertices.len()).collect();
        while let Some([i, j]) = edges.iter().find(|[i, j]| label[*i] != label[*j]) {
            let (old, new) = (label[*i].max(label[*j]), label[*i].min(label[*j]));
            label.iter_mut().filter(|l| **l == old).for_each(|l| *l = new);
        }
        label.into_iter().collect::<BTreeSet<_>>().len()
    };
    let table = found.meshes.iter().find(|r| r.name == "cable 7 / table").unwrap();
    assert_eq!(pieces(&table.mesh), 5);
}

#[test]
fn filters_select_by_name_and_report_typos() {
    let named = |cables: &[&str], obstacles: &[&str]| RegionOptions {
        cables: cables.iter().map(|s| s.to_string()).collect(),
        obstacles: obstacles.iter().map(|s| s.to_string()).collect(),
        ..all()
    };
    let names = |options: &RegionOptions| -> Vec<String> {
        regions(&hard3(), options).unwrap().meshes.into_iter().map(|r| r.name).collect()
    };
    assert_eq!(names(&named(&["cable 2"], &["west", "south"])), ["cable 2 / west", "cable 2 / south"]);
    let of_west = names(&named(&[], &["west"]));
    assert_eq!((of_west.len(), of_west[0].as_str()), (9, "platform / west"));
    for (options, words) in [
        (named(&["cable 9"], &[]), "cable: found \"cable 9\", expected one of cable 0, cable 1"),
        (named(&[], &["wets"]), "expected one of west, south, north; did you mean \"west\"?"),
        (RegionOptions { space: Some(Space::Attachment), ..all() }, "space: found \"attachment\" with all regions"),
    ] {
        let error = regions(&hard3(), &options).unwrap_err().to_string();
        assert!(error.contains(words), "{error}");
    }
}

#[test]
fn an_allowed_contact_forbids_nothing() {
    let mut spec = hard1().spec().clone();
    spec.ignore = vec![["cable 3".to_string(), "pillar".to_string()], ["platform".to_string(), "pillar".to_string()]];
    let found = regions(&scene(spec), &all()).unwrap();
    assert_eq!(found.meshes.iter().filter(|r| r.kind == Kind::CableObstacle).count(), 7);
    assert!(!found.meshes.iter().any(|r| r.name == "cable 3 / pillar" || r.name == "platform / pillar"));
}

#[test]
fn a_platform_that_does_not_fit_has_no_positions_to_forbid() {
    let mut spec = hard1().spec().clone();
    spec.workspace.max = [2.0, 0.1, 2.0];
    let found = regions(&scene(spec), &all()).unwrap();
    assert_eq!((found.meshes.len(), found.box_volume()), (0, 0.0));
}

#[test]
fn cables_cross_in_two_flat_wedges() {
    let crossing = testdata("cases/crossing.toml");
    let found = regions(&crossing, &all()).unwrap();
    let flat: Vec<_> = found.meshes.iter().filter(|r| r.kind == Kind::CableCable).collect();
    assert!(!flat.is_empty() && flat.iter().all(|r| r.mesh.is_watertight() && r.mesh.area() > 0.01));
    // Within the wedges, a small step across them makes the cables cross.
    let engine = GjkEngine::new(&crossing, Interference::Exact).unwrap();
    for region in flat {
        for t in &region.mesh.triangles {
            let [a, b, c] = t.map(|i| region.mesh.vertices[i]);
            let (centre, normal) =
                (Point::from((a.coords + b.coords + c.coords) / 3.0), (b - a).cross(&(c - a)).normalize());
            let pairs = engine.violations(&(centre - normal * 1e-3), &(centre + normal * 1e-3));
            assert!(pairs.iter().any(|v| v.culprits == region.culprits), "{} at {centre}", region.name);
        }
    }
}

#[test]
fn who_stops_is_answered_at_once() {
    let (stop, scene) = (|| true, hard3());
    let watch = Watch::on(&stop);
    let interrupted = |error: Option<cdpr_core::Error>| error.unwrap().class() == ErrorClass::Interrupted;
    assert!(interrupted(survey(&scene, &watch).err()));
    assert!(interrupted(regions_within(&scene, &all(), &watch).err()));
    assert!(interrupted(page_within(&scene, Contents::default(), Form::Live, &watch).err()));
    assert!(interrupted(Conditions::within(&scene, &watch).err()));
    assert!(survey(&scene, &Watch::NONE).unwrap().valid.is_some_and(|share| (0.01..0.99).contains(&share)));
    assert_eq!(regions_within(&scene, &all(), &Watch::NONE).unwrap(), regions(&scene, &all()).unwrap());
}
