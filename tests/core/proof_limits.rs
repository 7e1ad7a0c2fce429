//! Openings a little wider and a little narrower than a limit worked out by hand: a path, and a proof that there is none.

use std::sync::Arc;

use cdpr_certify::{Cell, Status, Summary, check_certificate};
use cdpr_core::Error;
use cdpr_core::collision::{Checker, Interference};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::Point;
use cdpr_core::limits::PROOF_EFFORT;
use cdpr_core::model::{
    BodySpec, ClearancesSpec, MeshSource, MeshSpec, OrientationSource, QuerySpec, Scene, SceneSpec,
};
use cdpr_core::proof::{Answer, Certificate, Content, Proof, ProofBox, decide, no_bounded_path};
use cdpr_core::testing::{scene, walled};
use cdpr_core::watch::Watch;
use cdpr_core::wrench::measures;
use cdpr_files::Loader;
use cdpr_tests::{built_scene, meshes};
use serde_json::{Value, json};

/// The proof for the narrow scene, after checking that the wide one has a path, that the independent checker accepts the
/// proof, and that it refuses the proof for the wide scene and after damage.
fn between(wide: &Scene, narrow: &Scene) -> Proof {
    let engine = engine_of(wide);
    let path = match answer(wide, &*engine) {
        Answer::Path(path) => path,
        other => panic!("the wide scene has a path, found {other:?}"),
    };
    assert!(path.windows(2).all(|pair| engine.motion_valid(&pair[0], &pair[1])));
    let engine = engine_of(narrow);
    let proof = match answer(narrow, &*engine) {
        Answer::NoPath(proof) => *proof,
        other => panic!("the narrow scene has no path, found {other:?}"),
    };
    let certificate = Certificate::of(&proof, narrow, &*engine);
    check(narrow, &certificate).unwrap();
    refused(wide, &Certificate { scene: wide.fingerprint(), ..certificate.clone() });
    for &condition in &proof.conditions {
        refused(narrow, &without(condition, &proof, &certificate));
    }
    for free in free_boxes_closed(&proof, &certificate, &*engine) {
        refused(narrow, &free);
    }
    proof
}

fn engine_of(scene: &Scene) -> Arc<dyn Checker> {
    engine_for(scene, Default::default(), Interference::Exact).unwrap()
}

fn answer(scene: &Scene, engine: &dyn Checker) -> Answer {
    let ends = [scene.start().unwrap(), scene.goal().unwrap()];
    assert!(ends.iter().all(|end| engine.state_valid(end)));
    decide(engine, ends.each_ref(), PROOF_EFFORT, &Watch::NONE).unwrap()
}

/// Bounds of the length promise a smaller margin than proofs that there is no path: between the two, a bound stays finite.
#[test]
fn slits_between_the_two_margins_have_no_path_but_bounds() {
    // A frame around a window that is larger than the platform by a slit on every side.
    let window = |slit: f64| {
        let [y, z] = [0.08 + slit, 0.05 + slit];
        let bar = |name: &str, [width, height]: [f64; 2], [y, z]: [f64; 2]| {
            let size = [0.2, width, height];
            json!({"name": name, "box": size, "position": [0.0, y, z]})
        };
        let spec = json!({
            "version": 1, "workspace": {"min": [-0.45, -0.45, -0.45], "max": [0.45, 0.45, 0.45]},
            "robot": {
                "platform": [{"box": [0.2, 0.16, 0.1]}],
                "cables": [{"name": "cable", "outlet": [0.0, 0.0, 5.0], "attachment": [0.0, 0.0, 0.05]}],
            },
            "obstacles": [
                bar("left", [0.6, 4.0], [-y - 0.3, 0.0]), bar("right", [0.6, 4.0], [y + 0.3, 0.0]),
                bar("below", [2.0 * y, 0.6], [0.0, -z - 0.3]), bar("above", [2.0 * y, 0.6], [0.0, z + 0.3]),
            ],
            "ignore": [["cable", "left"], ["cable", "right"], ["cable", "below"], ["cable", "above"]],
            "query": {"start": [-0.32, 0.01, 0.02], "goal": [0.32, -0.02, 0.01]},
        });
        Scene::new(serde_json::from_value(spec).unwrap()).unwrap()
    };
    for (slit, bounded) in [(2e-7, true), (2e-8, false)] {
        let scene = window(slit);
        let engine = engine_of(&scene);
        let [before, after] = [-0.32, 0.32].map(|x| Point::new(x, 0.0, 0.0));
        assert!(engine.motion_valid(&before, &after), "{slit}");
        assert!(matches!(answer(&scene, &*engine), Answer::NoPath(_)), "{slit}");
        let ends = [scene.start().unwrap(), scene.goal().unwrap()];
        assert_eq!(no_bounded_path(&*engine, ends.each_ref(), &Watch::NONE).unwrap(), !bounded, "{slit}");
    }
}

fn check(scene: &Scene, certificate: &Certificate) -> Result<Summary, Error> {
    check_certificate(scene, &serde_json::to_string(certificate).unwrap(), &Watch::NONE)
}

fn refused(scene: &Scene, certificate: &Certificate) {
    let found = check(scene, certificate);
    assert!(found.is_err(), "accepted: {found:?}");
}

/// The certificate with all boxes opened that one condition closes; none of the conditions can be left out.
fn without(condition: usize, proof: &Proof, certificate: &Certificate) -> Certificate {
    let mut opened = certificate.clone();
    for (cell, ProofBox { content, .. }) in opened.boxes.iter_mut().zip(&proof.boxes) {
        let by = match *content {
            Content::Open => None,
            Content::Region(region) => Some(proof.regions[region].condition),
            Content::Bound(condition) => Some(condition),
        };
        if by == Some(condition) {
            cell.status = Status::Open;
        }
    }
    opened
}

/// Certificates that also close a large box with a valid centre, each for one of the reasons that close others.
fn free_boxes_closed(proof: &Proof, certificate: &Certificate, engine: &dyn Checker) -> Vec<Certificate> {
    let size = |k: &usize| proof.boxes[*k].positions.volume();
    let free = |k: &usize| {
        let ProofBox { positions, content } = &proof.boxes[*k];
        *content == Content::Open && engine.state_valid(&positions.center)
    };
    let largest = (0..proof.boxes.len()).filter(free).max_by(|a, b| size(a).total_cmp(&size(b))).expect("a free box");
    let close = |status: &Status| {
        let mut closed = certificate.clone();
        closed.boxes[largest].status = status.clone();
        closed
    };
    let regions = (0..certificate.regions.len()).map(|region| close(&Status::Within(region)));
    let mut reasons: Vec<&Status> = Vec::new();
    for Cell { status, .. } in &certificate.boxes {
        if matches!(status, Status::Broken(_) | Status::TooWeak(_)) && !reasons.contains(&status) && reasons.len() < 10
        {
            reasons.push(status);
        }
    }
    regions.chain(reasons.into_iter().map(close)).collect()
}

/// A scene of a platform that is a point.
fn point_scene(space: [[f64; 3]; 2], cables: Value, obstacles: Value, ends: [[f64; 3]; 2], more: Value) -> Scene {
    let mut spec = json!({
        "version": 1, "workspace": {"min": space[0], "max": space[1]}, "obstacles": obstacles,
        "robot": {"platform": [{"vertices": [[0.0, 0.0, 0.0]]}], "cables": cables},
        "query": {"start": ends[0], "goal": ends[1]},
    });
    for (key, value) in more.as_object().expect("keys of a scene") {
        match (key.as_str(), value) {
            ("mass", mass) => spec["robot"]["mass"] = mass.clone(),
            _ => spec[key] = value.clone(),
        }
    }
    Scene::new(serde_json::from_value(spec).unwrap()).unwrap()
}

#[test]
fn a_thick_cable_needs_a_slot_as_wide_as_its_diameter() {
    // The cable hangs from above a wall, 1 m high, with a slot of 10 cm; the platform is a point that stays below 0.8 m.
    // So the cable passes the wall in the slot, with half of the slot at most on either side of its axis.
    let slotted = |diameter: f64| {
        let half = |name: &str, y: f64| json!({"name": name, "box": [0.1, 0.95, 1.0], "position": [1.0, y, 0.5]});
        let cables = json!([{"outlet": [1.0, 1.0, 2.0], "attachment": [0.0, 0.0, 0.0], "diameter": diameter}]);
        let (space, ends) = ([[0.0; 3], [2.0, 2.0, 0.8]], [[0.3, 1.0, 0.3], [1.7, 1.0, 0.3]]);
        point_scene(space, cables, json!([half("left", 0.475), half("right", 1.525)]), ends, json!({}))
    };
    assert_eq!(between(&slotted(0.098), &slotted(0.102)).blocking, [0, 1]);
}

#[test]
fn cables_that_would_cross_close_the_way() {
    // Outlets (0, 1, 2) and (0.5, 1, 2); the second cable ends 0.2 m below the first. Where the platform (x, 1, z) is in the
    // plane of the outlets with x > 0.5, the cables cross. With x < 0.5 the end of the first one is nearest to the second,
    // whose vector is (x - 0.5, 0, z - 2.2): with e = 0.5 - x and h = 2.2 - z, they are 0.2 e / √(e² + h²) apart. In the
    // box of positions, this is largest at x = 0.2 and z = 1.8: 0.2 · 0.3 / 0.5 = 0.12 m.
    let beside = |diameter: f64| {
        let cable =
            |x: f64, z: f64| json!({"outlet": [x, 1.0, 2.0], "attachment": [0.0, 0.0, z], "diameter": diameter});
        let ignored = json!({"ignore": [["cable 0", "platform"], ["cable 1", "platform"]]});
        let (space, ends) = ([[0.2, 0.0, 0.4], [1.5, 2.0, 1.8]], [[0.3, 0.2, 1.7], [0.3, 1.8, 1.7]]);
        point_scene(space, json!([cable(0.0, 0.0), cable(0.5, -0.2)]), json!([]), ends, ignored)
    };
    let found = between(&beside(0.118), &beside(0.122));
    assert_eq!((found.blocking, found.conditions.len()), (vec![], 1));
}

#[test]
fn a_tilted_platform_needs_more_height() {
    // Turned by 30° about y, the platform of 0.15 × 0.05 m is 0.15 sin 30° + 0.05 cos 30° high.
    let half = 15_f64.to_radians();
    let tilted = |more: f64| {
        let mut spec = walled(0.9 + 0.15 * (2.0 * half).sin() + 0.05 * (2.0 * half).cos() + more);
        spec.query = Some(QuerySpec {
            start: Some([0.3, 1.0, 0.5].into()), // where no cable meets the wall
            goal: Some([1.7, 1.0, 0.5].into()),
            orientation: Some(OrientationSource::Quaternion([half.cos(), 0.0, half.sin(), 0.0])),
            ..QuerySpec::default()
        });
        scene(spec)
    };
    assert_eq!(between(&tilted(2e-3), &tilted(-2e-3)).blocking, [0]);
}

#[test]
fn a_notch_in_a_mesh_is_passed_where_wide_enough() {
    // The wall is one mesh, 0.9 m high with a notch: its height there is 0.7 m + |y - 1|. The platform, 0.15 m wide, stays
    // above 0.7 m + 0.075 m and needs another 0.05 m for its height; over the rest of the wall there is no room.
    let outline = [[0.0, 0.0], [2.0, 0.0], [2.0, 0.9], [1.2, 0.9], [1.0, 0.7], [0.8, 0.9], [0.0, 0.9]];
    let caps = [[0, 1, 4], [1, 2, 3], [1, 3, 4], [0, 4, 5], [0, 5, 6]];
    let mesh = meshes::prism(&outline, -0.05, 0.05, &caps);
    let wall = BodySpec {
        name: Some("wall".to_string()),
        mesh: Some(MeshSource::Inline(MeshSpec {
            vertices: mesh.vertices.iter().map(|p| (*p).into()).collect(),
            triangles: mesh.triangles,
        })),
        tolerance: Some(1e-4),
        quaternion: Some([0.5; 4]), // x, y, z of the mesh become y, z, x
        position: Some([1.0, 0.0, 0.0]),
        ..BodySpec::default()
    };
    let notched = |more: f64| {
        let spec = SceneSpec { obstacles: vec![wall.clone()], ..walled(0.7 + 0.075 + 0.05 + more) };
        Loader::new(Watch::NONE).scene_from_spec(spec, None).unwrap()
    };
    let (wide, narrow) = (notched(2e-3), notched(-2e-3));
    assert!(narrow.obstacles()[0].parts.len() > 1);
    assert_eq!(between(&wide, &narrow).blocking, [0]);
}

#[test]
fn a_platform_too_weak_to_pass_a_ridge_has_no_path() {
    // Four cables from (±1.44, ±1.92, 2) hold a point of 11.2 kg with at most 100 N each; g = 10 m/s². The wall's ridge is
    // above the y axis. By symmetry, cables on both sides of the plane x = 0 pull alike there. At (0, y, 2 - h) the nearer
    // pair pulls with all it has and the other one balances it along y: together they lift 4 · 1.92 h · 100 N / ((1.92 +
    // y) L), where L is the length of the nearer cables. This falls with y, and at y = 0 it is 400 N h / √(2.4² + h²):
    // the 112 N needed for h = 0.7 m (L = 2.5 m). So the ridge must be lower than 1.3 m.
    let ridge = |height: f64| {
        let corner = [[-0.5, 0.0], [0.5, 0.0], [0.0, height]];
        let corners: Vec<[f64; 3]> = corner.iter().flat_map(|[x, z]| [[*x, -1.9, *z], [*x, 1.9, *z]]).collect();
        let outlet = |k: usize| [[-1.44, 1.44][k % 2], [-1.92, 1.92][k / 2], 2.0];
        let cable = |k| json!({"outlet": outlet(k), "attachment": [0.0, 0.0, 0.0], "tension": [1.0, 100.0]});
        let more = json!({
            "wrench": {}, "gravity": [0.0, 0.0, -10.0], "mass": 11.2,
            "ignore": (0..4).map(|k| [format!("cable {k}"), "ridge".to_string()]).collect::<Vec<_>>(),
        });
        let (space, ends) = ([[-1.4, -1.9, 0.0], [1.4, 1.9, 1.9]], [[-0.7, 0.0, 0.3], [0.7, 0.0, 0.3]]);
        let obstacles = json!([{"name": "ridge", "vertices": corners}]);
        point_scene(space, (0..4).map(cable).collect(), obstacles, ends, more)
    };
    let found = between(&ridge(1.25), &ridge(1.35));
    assert_eq!((found.blocking, found.conditions.len()), (vec![0], 2)); // the ridge and the wrenches
}

#[test]
fn a_clearance_narrows_an_opening_by_as_much() {
    // Between the wall and the ceiling there are 5 cm more than the platform needs.
    let kept = |clearance: f64| {
        let clearances = ClearancesSpec { platform_obstacle: Some(clearance), ..ClearancesSpec::default() };
        scene(SceneSpec { clearances: Some(clearances), ..walled(1.0) })
    };
    assert_eq!(between(&kept(0.04), &kept(0.06)).blocking, [0]);
}

#[test]
fn a_ridge_above_cogiros_feasible_height_blocks() {
    let ridge = |height: f64| {
        let mut spec = built_scene("cogiro").spec().clone();
        let corners = [[-0.5, 0.0], [0.5, 0.0], [0.0, height]];
        let corners = corners.iter().flat_map(|[x, z]| [[*x, -5.0, *z], [*x, 5.0, *z]]).collect();
        spec.obstacles =
            vec![BodySpec { name: Some("ridge".to_string()), vertices: Some(corners), ..BodySpec::default() }];
        spec.ignore = (0..8).map(|k| [format!("cable {k}"), "ridge".to_string()]).collect();
        spec.query = Some(QuerySpec::between([-2.0, 0.0, 1.0], [2.0, 0.0, 1.0]));
        scene(spec)
    };
    // The wrenches suffice up to some height, by samples along the ridge; the outlets are at 5.4 m, the ceiling is at 6
    // m.
    let measures = measures(&ridge(1.0)).unwrap();
    let suffice = |y: f64, z: f64| measures.iter().all(|measure| measure.slack(&Point::new(0.0, y, z)) >= 0.0);
    let highest = |k: i32| (0..500).map(|j| 0.01 * f64::from(j)).rfind(|&z| suffice(0.1 * f64::from(k), z));
    let limit = (-45..=45).filter_map(highest).fold(0.0, f64::max);
    assert!(limit > 4.5 && limit < 4.8, "{limit}");
    let found = between(&ridge(limit - 0.2), &ridge(limit + 0.2));
    assert_eq!((found.blocking, found.conditions.len()), (vec![0], 2));
}

#[test]
fn a_clearance_that_is_just_attainable_is_kept() {
    // The cable is attached 0.1 m beside a mast on the platform; in doubles, 0.15 - 0.05 is a little less. Where the platform
    // passes the end of the wall, beyond y = 1.5, the cable leans towards the mast: its outlet is at y = 1.
    let beside = |clearance: f64| {
        let spec = json!({
            "version": 1, "workspace": {"min": [0.0, 0.0, 0.0], "max": [2.0, 2.0, 1.0]},
            "clearances": {"cable_platform": clearance}, "ignore": [["cable 0", "wall"]],
            "robot": {
                "platform": [
                    {"box": [0.3125, 0.3125, 0.0625]}, {"box": [0.1, 0.1, 0.25], "position": [0.0, 0.0, 0.15625]},
                ],
                "cables": [{"outlet": [1.0, 1.0, 3.0], "attachment": [0.0, 0.15, 0.03125]}],
            },
            "obstacles": [{"name": "wall", "box": [0.1, 1.5, 2.0], "position": [1.0, 0.75, 1.0]}],
            "query": {"start": [0.5, 0.5, 0.3], "goal": [1.5, 0.5, 0.3]},
        });
        Scene::new(serde_json::from_value(spec).unwrap()).unwrap()
    };
    let narrow = beside(0.1);
    let exempt = |scene: &Scene| engine_of(scene).conditions().exempt.len();
    assert_eq!((exempt(&narrow), exempt(&beside(0.1 + 1e-8))), (1, 2)); // cable and wall, which are ignored, and this pair
    assert_eq!(between(&beside(0.0), &narrow).blocking, [0]);
}
