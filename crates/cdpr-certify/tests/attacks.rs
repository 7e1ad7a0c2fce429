//! Certificates of bounds made by hand: a true one is accepted, and the slightest exaggeration is refused.

use cdpr_certify::check_bound;
use cdpr_core::Scene;
use cdpr_core::watch::Watch;
use serde_json::{Value, json};

/// A point in a workspace from (-1, -1, -1) to (3, 1, 1), and boxes that reach from the floor to the ceiling: x and y of each.
fn scene(boxes: &[[f64; 4]]) -> Scene {
    let obstacle = |(k, [x0, x1, y0, y1]): (usize, &[f64; 4])| {
        let [x, y] = [0.5 * (x0 + x1), 0.5 * (y0 + y1)];
        json!({"name": format!("wall {k}"), "box": [x1 - x0, y1 - y0, 4.0], "position": [x, y, 0.0]})
    };
    let spec = json!({
        "version": 1, "workspace": {"min": [-1.0, -1.0, -1.0], "max": [3.0, 1.0, 1.0]},
        "robot": {"mass": 1.0, "platform": [{"vertices": [[0.0, 0.0, 0.0]]}], "cables": [
            {"outlet": [0.0, 0.0, 2.0], "attachment": [0.0, 0.0, 0.0]},
        ]},
        "obstacles": boxes.iter().enumerate().map(obstacle).collect::<Vec<_>>(),
    });
    Scene::new(serde_json::from_value(spec).unwrap()).unwrap()
}

/// A certificate with a region for each box. Edges: the region, x and y (0 or 1: the smaller or larger one), and a constant label.
fn certificate(boxes: &[[f64; 4]], start: [f64; 3], length: f64, edges: &[(usize, [usize; 2], f64)]) -> Value {
    let region = |(k, [x0, x1, y0, y1]): (usize, &[f64; 4])| {
        let planes = [[-1.0, 0.0, 0.0, -x0], [1.0, 0.0, 0.0, *x1], [0.0, -1.0, 0.0, -y0], [0.0, 1.0, 0.0, *y1]];
        json!({"who": ["platform", format!("wall {k}")], "half_spaces": planes})
    };
    let edge = |(region, [x, y], label): &(usize, [usize; 2], f64)| {
        let at = [boxes[*region][*x], boxes[*region][2 + y]];
        let ends = [[at[0], at[1], -1.0], [at[0], at[1], 1.0]];
        json!({"region": region, "planes": [*x, 2 + y], "ends": ends, "pieces": [[1.0, label, label]]})
    };
    json!({
        "format": "cdpr-bound", "version": 1, "scene": scene(boxes).fingerprint(), "orientation": [1.0, 0.0, 0.0, 0.0],
        "margin": 1e-7, "start": start, "goal": [2.0, 0.0, 0.0], "length": length,
        "box": [[-1.0, -1.0, -1.0], [3.0, 1.0, 1.0]], "corners": [],
        "regions": boxes.iter().enumerate().map(region).collect::<Vec<_>>(),
        "edges": edges.iter().map(edge).collect::<Vec<_>>(),
    })
}

fn check(boxes: &[[f64; 4]], certificate: &Value) -> Result<f64, String> {
    check_bound(&scene(boxes), &certificate.to_string(), &Watch::NONE)
        .map(|found| found.length)
        .map_err(|error| error.to_string())
}

const WALL: [[f64; 4]; 1] = [[0.5, 1.0, -0.5, 0.5]];
const START: [f64; 3] = [0.0; 3];

/// Around the wall: to its first edge, along it, and to the goal.
fn around() -> [f64; 3] {
    [0.5f64.sqrt(), 0.5f64.sqrt() + 0.5, 0.5f64.sqrt() + 0.5 + 1.25f64.sqrt()]
}

fn edges([near, far]: [f64; 2]) -> [(usize, [usize; 2], f64); 4] {
    [(0, [0, 0], near), (0, [0, 1], near), (0, [1, 0], far), (0, [1, 1], far)]
}

#[test]
fn a_bound_by_hand_is_exact_but_for_the_reserve() {
    let [near, far, length] = around();
    let with = |length: f64, labels: [f64; 2]| check(&WALL, &certificate(&WALL, START, length, &edges(labels)));
    assert_eq!(with(length - 2e-7, [near, far]), Ok(length - 2e-7));
    assert!(with(length + 1e-9, [near, far]).is_err());
    for more in [3e-8, 1e-6, 1.0] {
        assert!(with(length - 2e-7, [near + more, far]).is_err(), "{more}");
        assert!(with(length + 1e-9, [near, far + more]).is_err(), "{more}");
        assert!(with(length + more, [near + more, far + more]).is_err(), "{more}");
    }
    // Labels may fall short by up to the reserve, but none proves more than the shortest path.
    assert!(with(length + 1e-9, [near + 1.9e-8, far + 3.8e-8]).is_err());
}

#[test]
fn a_missing_edge_is_refused() {
    let [near, far, length] = around();
    for k in 0..4 {
        let mut fewer = edges([near, far]).to_vec();
        fewer.remove(k);
        assert!(
            check(&WALL, &certificate(&WALL, START, length - 2e-7, &fewer))
                .unwrap_err()
                .contains("an edge that is free")
        );
    }
    // Listing another edge twice, or one that lies elsewhere, does not help.
    let mut twice = edges([near, far]);
    twice[3] = twice[2];
    assert!(check(&WALL, &certificate(&WALL, START, length - 2e-7, &twice)).is_err());
}

#[test]
fn a_path_may_pass_between_boxes_that_touch_only_along_an_edge() {
    let boxes = [[0.5, 1.0, 0.0, 1.0], [1.0, 1.5, -1.0, 0.0]];
    for label in [0.0, 1.0, 1.5] {
        let all = [(0, [0, 0], label), (0, [1, 0], label), (1, [0, 1], label), (1, [1, 1], label)];
        assert!(check(&boxes, &certificate(&boxes, START, 2.0 + 1e-6, &all)).is_err());
    }
    assert_eq!(check(&boxes, &certificate(&boxes, START, 1.9, &[])), Ok(1.9));
}

/// Contact at the start alone is allowed everywhere, so a region of such a pair may not reach beyond the forbidden
/// positions.
#[test]
fn contact_at_one_end_is_allowed_everywhere() {
    let wider = |by: f64| [[0.5 - by, 1.0 + by, -0.5 - by, 0.5 + by]];
    let with = |start: [f64; 3], by: f64| {
        let mut found = certificate(&wider(by), start, 0.5, &[]);
        found["scene"] = scene(&WALL).fingerprint().into();
        check(&WALL, &found)
    };
    let touching = [0.5, 0.0, 0.0];
    assert_eq!(with(START, 5e-8), Ok(0.5));
    assert_eq!(with(touching, 0.0), Ok(0.5));
    assert!(with(touching, 5e-8).unwrap_err().contains("too close"));
    assert!(with(START, 2e-7).unwrap_err().contains("too close"));
}

/// Of paths between ends outside the box or inside a region, any bound would be true.
#[test]
fn ends_are_in_the_box_and_in_no_region() {
    let with = |start: [f64; 3], low: f64, region: Option<[[f64; 4]; 2]>| {
        let mut found = certificate(&WALL, start, 999.0, &[]);
        found["margin"] = 1e-6.into();
        found["box"][0][2] = low.into();
        if let Some(planes) = region {
            found["regions"][0]["half_spaces"] = json!(planes);
        }
        check(&WALL, &found)
    };
    // The box may be smaller by rounding errors: then the floor is outside of it, and so is this region.
    let on_the_floor = [0.0, 0.0, -1.0];
    let under = [[0.0, 0.0, 1.0, -1.0 + 0.4e-12], [0.0, 0.0, -1.0, 1.1]];
    let refused = with(on_the_floor, -1.0 + 0.9e-12, Some(under)).unwrap_err();
    assert!(refused.contains("start: found -1 along z, expected it in the box, -0.9999999999991 to 1"), "{refused}");
    let refused = with([0.0; 3], -1.0 + 0.9e-12, Some(under)).unwrap_err();
    assert!(refused.contains("regions[0].half_spaces: found no position of the box in them"), "{refused}");
    // Not by more than that: below the wall there may be a slit as wide as the missing part of the box, out of which
    // the region reaches into the box.
    let refused = with([0.0; 3], -1.0 + 0.9e-6, Some(under)).unwrap_err();
    assert!(refused.contains("box: found -0.9999991 to 1 along z, expected at least -1 to 1"), "{refused}");
    let refused = with([0.75, 0.0, 0.0], -1.0, None).unwrap_err();
    assert!(refused.contains("start: found it inside regions[0], expected it in no region"), "{refused}");
    let refused = with([0.5 + 1e-9, 0.0, 0.0], -1.0, None).unwrap_err();
    assert!(refused.contains("start: found it inside regions[0], expected it in no region"), "{refused}");
}

/// Below the wall there is a slit wider than the margin, but narrower than the margin plus the part that the box may
/// lack.
#[test]
fn a_path_below_the_box_of_a_certificate_counts() {
    let slit = 1.8e-6;
    let spec = json!({
        "version": 1, "workspace": {"min": [-1.0, -1.0, -1.0], "max": [3.0, 1.0, 1.0]},
        "robot": {"mass": 1.0, "platform": [{"vertices": [[0.0, 0.0, 0.0]]}], "cables": [
            {"outlet": [0.0, 0.0, 2.0], "attachment": [0.0, 0.0, 0.0]},
        ]},
        "obstacles": [{"name": "wall 0", "box": [0.5, 4.0, 4.0], "position": [0.75, 0.0, 1.0 + slit]}],
    });
    let scene = Scene::new(serde_json::from_value(spec).unwrap()).unwrap();
    let planes = [[-1.0, 0.0, 0.0, -0.5], [1.0, 0.0, 0.0, 1.0], [0.0, 0.0, -1.0, 1.0 - slit + 0.95e-6]];
    let mut found = certificate(&WALL, START, 900.0, &[]);
    found["scene"] = scene.fingerprint().into();
    found["margin"] = 1e-6.into();
    found["regions"][0]["half_spaces"] = json!(planes);
    for (lacks, problem) in [(0.0, "an edge that is free"), (0.9e-6, "box: found")] {
        found["box"][0][2] = (-1.0 + lacks).into();
        let refused = check_bound(&scene, &found.to_string(), &Watch::NONE).unwrap_err().to_string();
        assert!(refused.contains(problem), "{refused}");
    }
}
