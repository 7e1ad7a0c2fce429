//! Small scenes in which each kind of proof is known: one slab between start and goal is closed for a reason, or the
//! region between them.

use cdpr_certify::check_certificate;
use cdpr_core::Scene;
use cdpr_core::watch::Watch;
use serde_json::{Value, json};

/// A scene of a small platform in a workspace from (-1, -1, -1) to (3, 1, 1), with the given keys changed.
fn scene(changes: Value) -> Scene {
    let mut spec = json!({
        "version": 1, "workspace": {"min": [-1.0, -1.0, -1.0], "max": [3.0, 1.0, 1.0]},
        "robot": {"mass": 1.0, "platform": [{"vertices": [[0.0, 0.0, 0.0]]}], "cables": [
            {"outlet": [0.0, 0.0, 2.0], "attachment": [0.0, 0.0, 0.0], "tension": [1.0, 100.0]},
        ]},
    });
    merge(&mut spec, changes);
    Scene::new(serde_json::from_value(spec).unwrap()).unwrap()
}

fn merge(into: &mut Value, changes: Value) {
    match (into, changes) {
        (Value::Object(into), Value::Object(changes)) => {
            changes.into_iter().for_each(|(key, value)| merge(into.entry(key).or_insert(Value::Null), value));
        }
        (into, value) => *into = value,
    }
}

/// A certificate whose boxes are cut at two x: the middle one is closed.
fn certificate(scene: &Scene, cuts: [f64; 2], half_spaces: Option<Value>, reason: &Value) -> String {
    let (min, max) = (scene.workspace().min, scene.workspace().max);
    let row = |from: f64, to: f64, status: &[Value]| {
        let mut row = vec![json!(from), json!(min.y), json!(min.z), json!(to), json!(max.y), json!(max.z)];
        row.extend(status.iter().cloned());
        Value::from(row)
    };
    let status = if half_spaces.is_some() { vec![json!(0)] } else { vec![json!(-2), reason.clone()] };
    let regions: Vec<Value> =
        half_spaces.into_iter().map(|planes| json!({"who": reason, "half_spaces": planes})).collect();
    let middle = |from: f64, to: f64| [0.5 * (from + to), 0.5 * (min.y + max.y), 0.5 * (min.z + max.z)];
    json!({
        "format": "cdpr-proof", "version": 1, "scene": scene.fingerprint(), "orientation": [1.0, 0.0, 0.0, 0.0],
        "margin": 1e-6, "start": middle(min.x, cuts[0]), "goal": middle(cuts[1], max.x),
        "box": [[min.x, min.y, min.z], [max.x, max.y, max.z]], "regions": regions,
        "boxes": [row(min.x, cuts[0], &[json!(-1)]), row(cuts[0], cuts[1], &status), row(cuts[1], max.x, &[json!(-1)])],
    })
    .to_string()
}

fn slab(scene: &Scene, cuts: [f64; 2], reason: Value) -> Result<(), String> {
    let text = certificate(scene, cuts, None, &reason);
    check_certificate(scene, &text, &Watch::NONE).map(|_| ()).map_err(|error| error.to_string())
}

/// A slab in the region from x = `from` to x = `to`.
fn region(scene: &Scene, [from, to]: [f64; 2], who: Value) -> Result<(), String> {
    let half_spaces = json!([[-1.0, 0.0, 0.0, -from], [1.0, 0.0, 0.0, to]]);
    let text = certificate(scene, [from + 1e-9, to - 1e-9], Some(half_spaces), &who);
    check_certificate(scene, &text, &Watch::NONE).map(|_| ()).map_err(|error| error.to_string())
}

/// Checks that the slab from x = 0.5 to x = 1 is accepted, and refused if it is 2 µm or 0.1 m wider to one side.
fn exactly(check: impl Fn([f64; 2]) -> Result<(), String>, [from, to]: [f64; 2]) {
    assert_eq!(check([from, to]), Ok(()));
    for wider in [2e-6, 0.1] {
        assert!(check([from - wider, to]).is_err() && check([from, to + wider]).is_err());
    }
}

fn wall(from: f64, to: f64) -> Value {
    json!({"name": "wall", "box": [to - from, 4.0, 4.0], "position": [0.5 * (from + to), 0.0, 0.0]})
}

#[test]
fn a_platform_keeps_its_clearance_from_an_obstacle() {
    let cube = json!({"platform": [{"box": [0.2, 0.2, 0.2]}], "cables": [
        {"outlet": [0.0, 0.0, 2.0], "attachment": [0.0, 0.0, 0.1]},
    ]});
    let own = |more: Value| {
        let mut changes = json!({
            "workspace": {"min": [-1.1, -1.1, -1.1], "max": [3.1, 1.1, 1.1]},
            "robot": cube, "obstacles": [wall(0.6, 0.9)],
        });
        merge(&mut changes, more);
        scene(changes)
    };
    // The box of positions is smaller than the workspace by half of the platform: `certificate` takes too large a box,
    // which is allowed.
    for (more, gap) in [
        (json!({}), 0.0),
        (json!({"clearance": 0.25}), 0.25),
        (json!({"clearance": 0.25, "clearances": {"platform_obstacle": 0.5}}), 0.5),
        (json!({"clearances": {"pairs": [{"between": ["wall", "platform"], "clearance": 0.125}]}}), 0.125),
        (json!({"clearance": 0.25, "touch": [["platform", "wall"]]}), 0.0),
    ] {
        let (scene, cuts) = (own(more), [0.5 - gap, 1.0 + gap]);
        exactly(|cuts| slab(&scene, cuts, json!(["platform", "wall"])), cuts);
        exactly(|cuts| region(&scene, cuts, json!(["wall", "platform"])), cuts);
    }
    let ignored = own(json!({"ignore": [["platform", "wall"]]}));
    let error = slab(&ignored, [0.7, 0.8], json!(["platform", "wall"])).unwrap_err();
    assert!(error.contains("forbid no positions in this scene"), "{error}");
}

/// The cable hangs from (0, 0, 2) into a slot; behind the wall it cannot be straight.
#[test]
fn a_cable_does_not_pass_through_an_obstacle() {
    let high = |more: Value| {
        let mut changes =
            json!({"obstacles": [{"name": "wall", "box": [0.5, 4.0, 6.0], "position": [0.75, 0.0, 0.0]}]});
        merge(&mut changes, more);
        scene(changes)
    };
    for x in [0.5, 0.9, 2.0] {
        assert_eq!(region(&high(json!({})), [x, 2.5], json!(["cable 0", "wall"])), Ok(()), "{x}");
    }
    assert!(region(&high(json!({})), [0.5 - 2e-6, 2.5], json!(["cable 0", "wall"])).is_err());
    let thick = json!({"clearance": 0.125, "robot": {"cables": [
        {"outlet": [0.0, 0.0, 2.0], "attachment": [0.0, 0.0, 0.0], "diameter": 0.25},
    ]}});
    assert_eq!(region(&high(thick.clone()), [0.25, 2.5], json!(["wall", "cable 0"])), Ok(()));
    assert!(region(&high(thick), [0.25 - 2e-6, 2.5], json!(["cable 0", "wall"])).is_err());
}

/// A gap to the cable's middle shrinks half as fast as the platform moves.
#[test]
fn the_margin_is_a_distance_of_positions() {
    let knife = json!({"obstacles": [
        {"name": "wall", "vertices": [
            [0.5, -4.0, 1.0], [0.5, 4.0, 1.0], [9.0, -4.0, 1.0], [9.0, 4.0, 1.0],
            [0.5, -4.0, 1.5], [0.5, 4.0, 1.5], [9.0, -4.0, 1.5], [9.0, 4.0, 1.5],
        ]},
    ]});
    // In the plane z = 0 the shadow of the edge at (0.5, z = 1) is x > 1; elsewhere it is x > 1 - z.
    let planes = |moved: f64| json!([[-1.0, 0.0, -0.5, -1.0 + moved], [1.0, 0.0, 0.0, 2.75]]);
    let scene = scene(knife);
    let check = |moved: f64| {
        let text = certificate(&scene, [2.0, 2.5], Some(planes(moved)), &json!(["cable 0", "wall"]));
        check_certificate(&scene, &text, &Watch::NONE)
    };
    assert!(check(0.99e-6).is_ok());
    assert!(check(1.5e-6).is_err()); // the gap is 0.75 µm
}

/// The platform is a wall between two outlets and the cable's attachment is on one side of it, at some distance.
#[test]
fn a_cable_does_not_pass_through_the_platform() {
    let lever = |attachment: f64| {
        scene(json!({"robot": {
            "platform": [{"box": [0.1, 0.5, 0.5]}],
            "cables": [{"outlet": [0.75, 0.0, 0.0], "attachment": [attachment, 0.0, 0.0]}],
        }, "workspace": {"min": [-1.05, -0.275, -0.275], "max": [3.05, 0.275, 0.275]}}))
    };
    // Attached 0.25 m behind the origin, the cable passes through the plate where the platform is left of the outlet.
    let who = || json!(["cable 0", "platform"]);
    assert_eq!(slab(&lever(-0.25), [0.3, 0.6], who()), Ok(()));
    assert_eq!(region(&lever(-0.25), [0.3, 0.6], who()), Ok(()));
    assert!(slab(&lever(-0.25), [0.9, 1.0], who()).is_err());
    // Attached on the face at -0.05, it enters the plate wherever the outlet is right of that face.
    assert_eq!(slab(&lever(-0.05), [0.3, 0.8], who()), Ok(()));
    assert!(slab(&lever(-0.05), [0.3, 0.8 + 2e-6], who()).is_err());
    assert!(slab(&lever(0.05), [0.3, 0.6], who()).is_err());
}

/// The cable is attached 0.1 m from the platform's other part: in doubles, 0.15 - 0.05 is a little less. A cable that leads
/// away from that part keeps the clearance, one that leads towards it does not.
#[test]
fn a_clearance_that_is_just_attainable_is_required() {
    let beside = |clearance: f64| {
        scene(json!({"clearance": clearance, "robot": {
            "platform": [{"vertices": [[0.15, 0.0, 0.0]]}, {"box": [0.1, 0.5, 0.5]}],
            "cables": [{"outlet": [0.75, 0.0, 0.0], "attachment": [0.15, 0.0, 0.0]}],
        }, "workspace": {"min": [-1.05, -0.3, -0.3], "max": [3.15, 0.3, 0.3]}}))
    };
    let who = || json!(["cable 0", "platform"]);
    assert_eq!(slab(&beside(0.1), [0.7, 1.0], who()), Ok(()));
    assert!(slab(&beside(0.1), [0.5, 1.0], who()).is_err());
    assert!(slab(&beside(0.1 + 1e-8), [0.7, 0.8], who()).is_err()); // not attainable: only contact is forbidden
}

/// Ends up to 1e-7 m apart are one point: the cables exert no moments there.
#[test]
fn cables_whose_ends_nearly_coincide_meet_in_one_point() {
    let check = |apart: f64| {
        let cable = |x: f64| json!({"outlet": [0.0, 0.0, 2.0], "attachment": [x, 0.0, 0.0], "tension": [1.0, 100.0]});
        let more = json!({"wrench": {"force": 200.0}, "robot": {"cables": [cable(0.0), cable(apart)]}});
        slab(&scene(more), [-0.5, 0.5], json!(["wrench", 0, 0, 1, 0, 0, 1]))
    };
    assert!(check(0.99e-7).unwrap_err().contains("meet in one point"));
    assert_eq!(check(1.01e-7), Ok(()));
}

#[test]
fn a_flat_part_forbids_nothing_to_a_cable_on_it() {
    let plate = scene(json!({"robot": {
        "platform": [{"box": [0.0, 0.5, 0.5]}], "cables": [{"outlet": [0.75, 0.0, 0.0], "attachment": [0.0, 0.0, 0.0]}],
    }}));
    let error = slab(&plate, [0.3, 0.6], json!(["cable 0", "platform"])).unwrap_err();
    assert!(error.contains("forbid no positions"), "{error}");
}

/// An outlet on a wall: positions on the wall's side are forbidden. An outlet that lies a little below the surface, as
/// rounding may have it, forbids no more: the cone of directions from there to the wall is all of space.
#[test]
fn an_outlet_on_an_obstacle_forbids_the_cone_below_its_faces() {
    for depth in [0.0, 1e-16, 5e-8, -5e-8] {
        let mounted = scene(json!({
            "obstacles": [wall(0.5, 1.5)],
            "robot": {"cables": [{"outlet": [0.5 + depth, 0.25, 0.25], "attachment": [0.0, 0.0, 0.0]}]},
        }));
        for check in [slab, region] {
            assert_eq!(check(&mounted, [0.5 + depth, 0.8], json!(["cable 0", "wall"])), Ok(()), "{depth}");
            assert!(check(&mounted, [0.5 + depth - 2e-6, 0.8], json!(["cable 0", "wall"])).is_err(), "{depth}");
            assert!(check(&mounted, [-0.3, 0.3], json!(["cable 0", "wall"])).is_err(), "{depth}");
        }
    }
}

/// At an edge of the wall a cable has to be below both faces.
#[test]
fn an_outlet_on_an_edge_forbids_the_cone_below_two_faces() {
    let block = json!({"name": "wall", "box": [1.0, 4.0, 2.0], "position": [1.0, 0.0, 0.0]});
    let mounted = scene(json!({
        "obstacles": [block],
        "robot": {"cables": [{"outlet": [0.5, 0.25, 1.0], "attachment": [0.0, 0.0, 0.0]}]},
    }));
    assert_eq!(region(&mounted, [0.5, 0.8], json!(["cable 0", "wall"])), Ok(()));
    let beside = scene(json!({
        "workspace": {"max": [3.0, 1.0, 1.1]},
        "obstacles": [{"name": "wall", "box": [1.0, 4.0, 2.0], "position": [1.0, 0.0, 0.0]}],
        "robot": {"cables": [{"outlet": [0.5, 0.25, 1.0], "attachment": [0.0, 0.0, 0.0]}]},
    }));
    assert!(region(&beside, [0.5, 0.8], json!(["cable 0", "wall"])).is_err());
}

/// Two cables to the ends of a bar cross left of the left outlet.
#[test]
fn two_cables_keep_their_clearance() {
    let until = |clearance: f64, arm: f64, most: f64| {
        scene(json!({
            "clearance": clearance, "workspace": {"min": [-3.5, -0.05, 1.8], "max": [most, 0.05, 1.9]},
            "robot": {"cables": [
                {"outlet": [-2.0, 0.0, 2.0], "attachment": [-arm, 0.0, 0.0]},
                {"outlet": [2.0, 0.0, 2.0], "attachment": [arm, 0.0, 0.0]},
            ]},
        }))
    };
    let bar = |clearance: f64, arm: f64| until(clearance, arm, 0.0);
    let (who, cuts) = (|| json!(["cable 1", "cable 0"]), [-3.0, -2.6]);
    assert_eq!(slab(&bar(0.3, 0.2), cuts, who()), Ok(()));
    // A clearance that is attainable somewhere is required, even if neither start nor goal attains it.
    assert_eq!(slab(&until(0.3, 0.2, -2.3), cuts, who()), Ok(()));
    assert!(slab(&bar(0.01, 0.2), cuts, who()).is_err());
    assert!(slab(&bar(0.3, 0.2), [-1.5, -1.0], who()).is_err());
    assert!(slab(&bar(0.5, 0.2), cuts, who()).is_err()); // nowhere attainable: 0 is required
    assert!(slab(&bar(0.3, 0.0), cuts, who()).unwrap_err().contains("no proof")); // they share an end
    assert!(region(&bar(0.3, 0.2), cuts, who()).unwrap_err().contains("found two cables"));
}

/// A proof is about paths at one orientation; whether there are paths with turns is another question.
#[test]
fn scenes_whose_platform_may_turn_are_refused() {
    let held = |more: Value| {
        let mut changes = json!({"obstacles": [wall(0.5, 1.0)]});
        merge(&mut changes, more);
        slab(&scene(changes), [0.5, 1.0], json!(["platform", "wall"]))
    };
    assert_eq!(held(json!({})), Ok(()));
    assert_eq!(held(json!({"query": {"start_orientation": [1.0, 0.0, 0.0, 0.0]}})), Ok(()));
    for more in [json!({"turning": {}}), json!({"query": {"goal_orientation": [0.0, 0.0, 0.0, 1.0]}})] {
        assert!(held(more).unwrap_err().contains("scene: found a scene whose platform may turn"));
    }
}

#[test]
fn a_cable_keeps_its_limits_of_length() {
    let limited = |length: [f64; 2]| {
        scene(json!({"robot": {"cables": [
            {"outlet": [-1.0, 0.0, 0.0], "attachment": [0.0, 0.0, 0.0], "length": length},
        ]}}))
    };
    assert_eq!(slab(&limited([0.0, 1.5]), [0.5, 0.75], json!(["cable 0"])), Ok(()));
    assert!(slab(&limited([0.0, 1.5]), [0.5 - 2e-6, 0.75], json!(["cable 0"])).is_err());
    assert_eq!(slab(&limited([1.5, 9.0]), [-0.75, -0.5], json!(["cable 0"])), Ok(())); // sqrt(0.5² + 1 + 1) = 1.5
    assert!(slab(&limited([1.5, 9.0]), [-0.75, -0.5 + 4e-6], json!(["cable 0"])).is_err());
    assert!(slab(&limited([0.0, 1.5]), [0.5, 0.75], json!(["platform"])).unwrap_err().contains("expected a cable"));
}

/// Round a pulley, a cable is longer than the straight line from the outlet, by up to half a turn and the width of the wheel.
#[test]
fn a_cable_round_a_pulley_is_longer_than_a_straight_one() {
    let limited = |length: [f64; 2]| {
        scene(json!({"robot": {"cables": [{
            "outlet": [-1.5, 0.0, 0.0], "attachment": [0.0, 0.0, 0.0], "length": length,
            "pulley": {"radius": 0.1, "axis": [1.0, 0.0, 0.0]},
        }]}}))
    };
    let who = || json!(["cable 0"]);
    assert_eq!(slab(&limited([0.0, 2.0]), [0.5, 0.75], who()), Ok(()));
    assert!(slab(&limited([0.0, 2.0]), [0.5 - 2e-6, 0.75], who()).is_err());
    let longest = 3.0_f64.sqrt() + 0.1 * (std::f64::consts::PI + 2.0); // to the corner of the slab at 1 m along each axis
    assert_eq!(slab(&limited([longest, 9.0]), [-0.75, -0.5], who()), Ok(()));
    assert!(slab(&limited([longest, 9.0]), [-0.75, -0.5 + 4e-6], who()).is_err());
}

/// Cables round pulleys pull along straight lines from their exits: wrenches lack if they do from wherever a cable can leave its pulley
/// while the platform is in the box. A pair of cables counts if straight cables from some of all their exits are too close.
#[test]
fn round_pulleys_wrenches_and_pairs_of_cables_count_from_exits() {
    let check_at = |cuts: [f64; 2], pulley: Value, reason: Value| {
        slab(
            &scene(json!({
                "clearance": 0.3, "workspace": {"min": [-3.5, -0.05, 1.8], "max": [0.0, 0.05, 1.9]}, "wrench": {"force": 500.0},
                "robot": {"cable": {"pulley": pulley}, "cables": [
                    {"outlet": [-2.0, 0.0, 2.0], "attachment": [-0.2, 0.0, 0.0], "tension": [1.0, 100.0]},
                    {"outlet": [2.0, 0.0, 2.0], "attachment": [0.2, 0.0, 0.0], "tension": [1.0, 100.0]},
                ]},
            })),
            cuts,
            reason,
        )
    };
    let check = |pulley: Value, reason: Value| check_at([-3.0, -2.6], pulley, reason);
    let wheel = || json!({"radius": 0.001, "axis": [0.0, 0.0, -1.0]});
    let (pair, weak) = (json!(["cable 1", "cable 0"]), json!(["wrench", 0, 0, 1, 0, 0, 0]));
    assert_eq!(check(Value::Null, pair.clone()), Ok(()));
    assert_eq!(check(Value::Null, weak.clone()), Ok(()));
    assert_eq!(check(wheel(), pair.clone()), Ok(()));
    assert!(
        check_at([-1.9, -1.5], wheel(), pair).unwrap_err().contains("no proof that cable 1 and cable 0 are too close")
    );
    assert_eq!(check(wheel(), weak), Ok(()));
    // In the middle, both cables together pull to no side; in the box, one on a large wheel may pull farther aside.
    let aside = json!(["wrench", 0, 1, 0, 0, 0, 0]);
    let weak_aside = |force: f64, radius: f64| {
        let pulley = if radius > 0.0 { json!({"radius": radius, "axis": [0.0, 0.0, -1.0]}) } else { Value::Null };
        let cable =
            |x: f64| json!({"outlet": [x, 0.0, 2.0], "attachment": [0.1 * x, 0.0, 0.0], "tension": [1.0, 100.0]});
        slab(
            &scene(json!({
                "workspace": {"min": [-1.0, -0.01, 1.0], "max": [1.0, 0.01, 1.02]}, "wrench": {"force": force},
                "robot": {"cable": {"pulley": pulley}, "cables": [cable(-2.0), cable(2.0)]},
            })),
            [-0.01, 0.01],
            aside.clone(),
        )
    };
    assert_eq!(weak_aside(1.8, 0.0), Ok(()));
    assert!(weak_aside(2.1, 0.3).is_err());
    assert_eq!(weak_aside(2.2, 0.3), Ok(()));
}

/// The only cable hangs from (0, 0, 2): at x > 0 it pulls to the left.
#[test]
fn a_cable_that_pulls_to_the_left_cannot_balance() {
    let check = |wrench: Value, cuts: [f64; 2], c: [f64; 6]| {
        let reason: Vec<Value> = std::iter::once(json!("wrench")).chain(c.iter().map(|x| json!(x))).collect();
        slab(&scene(json!({"wrench": wrench})), cuts, reason.into())
    };
    let (right, up) = ([1.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    assert_eq!(check(json!({}), [2.0, 2.5], right), Ok(()));
    assert!(check(json!({}), [2.0, 2.5], right.map(|x| -x)).is_err());
    assert!(check(json!({}), [2.0, 2.5], up).is_err());
    assert!(check(json!({}), [-0.5, 0.5], right).is_err());
    assert_eq!(check(json!({"force": 200.0}), [-0.5, 0.5], up), Ok(()));
    assert_eq!(check(json!({"vertices": [[0, 0, 0, 0, 0, 0], [0, 0, 200, 0, 0, 0]]}), [-0.5, 0.5], up), Ok(()));
    assert_eq!(check(json!({"load": [0, 0, -200, 0, 0, 0]}), [-0.5, 0.5], up), Ok(()));
    assert!(check(json!({"load": [0, 0, 200, 0, 0, 0]}), [-0.5, 0.5], up).is_err());
    // Of several load cases one is enough, whichever it is: what lifts 20 kg does not count beside a payload or another load.
    let loads = |others: &[i32]| others.iter().map(|z| json!([0, 0, z, 0, 0, 0])).collect::<Value>();
    assert!(check(json!({"loads": loads(&[0, 200])}), [-0.5, 0.5], up).is_err());
    assert_eq!(check(json!({"loads": loads(&[200, -200])}), [-0.5, 0.5], up), Ok(()));
    assert!(check(json!({"payload": 1.0}), [-0.5, 0.5], up).is_err());
    assert_eq!(check(json!({"payload": 20.0}), [-0.5, 0.5], up), Ok(()));
    assert!(check(json!({"payload": 20.0, "loads": loads(&[250])}), [-0.5, 0.5], up).is_err());
    assert_eq!(check(json!({"payload": 20.0, "loads": loads(&[250, 0])}), [-0.5, 0.5], up), Ok(()));
    let moment = [0.0, 0.0, 1.0, 0.0, 0.0, 1.0];
    assert!(check(json!({"force": 200.0}), [-0.5, 0.5], moment).unwrap_err().contains("meet in one point"));
    assert!(check(json!({"force": 200.0, "rule": "grid"}), [-0.5, 0.5], up).unwrap_err().contains("grid"));
    let error = slab(&scene(json!({})), [2.0, 2.5], json!(["wrench", 1, 0, 0, 0, 0, 0])).unwrap_err();
    assert!(error.contains("without requirements on wrenches"), "{error}");
}

/// A cable of 1 N/m at 100 N in a scene with gravity against x, and the greatest length of its straight line, m.
fn sagging(outlet: [f64; 3], attachment: [f64; 3], error: f64, more: Value) -> (Scene, f64) {
    let mut changes = json!({
        "gravity": [-10.0, 0.0, 0.0],
        "robot": {"cables": [{
            "outlet": outlet, "attachment": attachment, "linear_density": 0.1, "sag_tension": 100.0, "outlet_error": error,
        }]},
    });
    merge(&mut changes, more);
    let far = |k: usize| (outlet[k] + 1.0).abs().max((outlet[k] - [3.0, 1.0, 1.0][k]).abs()) + error;
    (scene(changes), (0..3).map(|k| far(k).powi(2)).sum::<f64>().sqrt())
}

/// w / (2 T) (1 + q/4), 1/m: T is the tension in the middle, half of the cable's weight less than at the platform.
fn curvature(outlet: [f64; 3], error: f64, longest: f64) -> f64 {
    let tension = 100.0 + 0.5 * (outlet[0] - error - 3.0);
    0.5 / tension * (1.0 + 0.25 * longest / tension)
}

/// Checks that a region from `from` to about x = `to` is accepted, and one that is 2 µm wider to that side is not.
fn ends_at(scene: &Scene, [from, to]: [f64; 2], who: Value) {
    let outward = 1e-6 * (to - from).signum();
    let cut = |by: f64| if to > from { [from, to + by * outward] } else { [to + by * outward, from] };
    assert_eq!(region(scene, cut(0.99), who.clone()), Ok(()));
    assert!(region(scene, cut(1.01), who).is_err());
}

#[test]
fn a_cable_that_sags_enters_the_bodies_that_it_ends_on() {
    let outlet = [0.5, 0.0, 0.0];
    let plate = json!({"obstacles": [{"name": "plate", "box": [0.5, 8.0, 8.0], "position": [0.25, 0.0, 0.0]}]});
    for error in [0.0, 0.01] {
        let (scene, longest) = sagging(outlet, [0.0; 3], error, plate.clone());
        let rise = curvature(outlet, error, longest) * longest * longest;
        assert!(0.02 < rise && rise < 0.1, "{rise}");
        ends_at(&scene, [-0.9, 0.5 + rise], json!(["cable 0", "plate"]));
    }
    // At the platform, also the outlet's error counts. The attachment is 0.1 m above the origin, and not beyond a part.
    let outlet = [2.0, 0.0, 0.0];
    for error in [0.0, 0.01] {
        let part = json!({"robot": {"platform": [{"box": [0.2, 0.2, 0.2]}]}});
        let (scene, longest) = sagging(outlet, [0.1, 0.0, 0.0], error, part);
        let lowest = 2.0 - error - curvature(outlet, error, longest) * longest * longest;
        ends_at(&scene, [2.9, lowest - 0.1], json!(["platform", "cable 0"]));
    }
}

/// A cable passes a wall from z = -4.1 to z = -1.1, as far as 4.9 m along z, 2 m down and 1 m aside from its outlet at z = -6. The line
/// from the outlet lowered as far as the wall needs to the lowest attachment, at z = -1, is 0.62 of that below the outlet at z = -4.1.
#[test]
fn a_cable_that_sags_keeps_above_a_wall() {
    let (outlet, top) = ([1.0, 0.0, -6.0], 0.8);
    let wall = |by: f64| {
        let top = top + by;
        json!({"obstacles": [{"name": "wall", "box": [6.0, 8.0, 3.0], "position": [top - 3.0, 0.0, -2.6]}]})
    };
    let (_, longest) = sagging(outlet, [0.0; 3], 0.0, json!({}));
    let lowering = curvature(outlet, 0.0, longest) * f64::sqrt(4.9 * 4.9 + 2.0 * 2.0 + 1.0) * longest;
    assert!(0.1 < lowering && lowering < 0.3, "{lowering}");
    let below = 0.62 * lowering;
    let (scene, _) = sagging(outlet, [0.0; 3], 0.0, wall(1.0 - below - top));
    let who = || json!(["cable 0", "wall"]);
    assert_eq!(region(&scene, [-0.9, 1.0 + 0.99e-6], who()), Ok(()));
    assert!(region(&scene, [-0.9, 1.0 + 1e-5], who()).is_err());
    let (lower, _) = sagging(outlet, [0.0; 3], 0.0, wall(1.0 - below - top - 1e-5));
    assert!(region(&lower, [-0.9, 1.0], who()).is_err());
}
