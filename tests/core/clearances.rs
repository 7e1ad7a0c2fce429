//! Clearances by kind and by pair, pairs that may touch, and exempt pairs: requirements, measurements and lists.

use std::sync::Arc;

use cdpr_core::collision::path_check::{Nearest, nearest};
use cdpr_core::collision::{Checker, Conditions, Engine, Interference, Kind, Reason, check_path};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::{Cuboid, Point, Vector};
use cdpr_core::model::{ClearancesSpec, PairClearanceSpec, RobotSource, Scene, SceneSpec};
use cdpr_core::plan::{PlanOptions, lower_bound, plan};
use cdpr_core::planning::Status;
use cdpr_core::testing::{block, hard1, paper_scene, scene};
use cdpr_core::tolerances::TOUCH_DEPTH;
use cdpr_core::watch::Watch;
use cdpr_files::scene_from_text;
use cdpr_files::text::Notation;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const PATH: [Point; 3] = [Point::new(0.3, 1.0, 0.3), Point::new(0.3, 1.0, 1.8), Point::new(1.7, 1.0, 1.8)];

fn pillar() -> SceneSpec {
    paper_scene("pillar", vec![block("pillar", [0.3, 0.3, 1.5], [1.0, 1.0, 0.75])])
}

fn both(spec: &SceneSpec) -> [Arc<dyn Checker>; 2] {
    let scene = scene(spec.clone());
    [Engine::Cspace, Engine::Gjk].map(|engine| engine_for(&scene, engine, Interference::Exact).unwrap())
}

fn of_path(spec: &SceneSpec, path: &[Point]) -> Nearest {
    nearest(&*both(spec)[0], path, &Watch::NONE).unwrap()
}

fn between(a: &str, b: &str) -> [String; 2] {
    [a.to_string(), b.to_string()]
}

fn pair(a: &str, b: &str, clearance: f64) -> PairClearanceSpec {
    PairClearanceSpec { between: between(a, b), clearance }
}

fn with(clearances: ClearancesSpec) -> SceneSpec {
    SceneSpec { clearances: Some(clearances), ..pillar() }
}

/// The paper's robot with thick cables: for some pairs, the distance of their attachments is the largest possible.
fn thick(diameter: f64, clearance: f64) -> SceneSpec {
    let mut spec = SceneSpec { clearance: Some(clearance), ..paper_scene("thick", Vec::new()) };
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("the paper's robot stands in the scene") };
    robot.cables.iter_mut().for_each(|cable| cable.diameter = Some(diameter));
    spec
}

#[test]
fn a_demand_that_no_position_keeps_hides_no_gap() {
    let free = of_path(&thick(0.0, 0.0), &PATH);
    assert!(free.exempt.is_empty() && free.min_clearance_not_exempt.is_none());
    let least = free.min_clearance.unwrap();
    for clearance in [0.01, 0.2, 3.0] {
        let found = of_path(&thick(0.0, clearance), &PATH);
        let measured = found.min_clearance.unwrap();
        assert_eq!((measured.value, &measured.culprits), (least.value, &least.culprits), "{clearance}");
        if clearance == 0.01 {
            assert!(found.exempt.is_empty() && measured.required == 0.01);
            continue;
        }
        assert!(!found.exempt.is_empty());
        for exempt in &found.exempt {
            let (exemption, gap) = (&exempt.exemption, exempt.gap.unwrap());
            assert_eq!((exemption.reason, exemption.demanded), (Reason::Unattainable, clearance));
            assert!(gap >= least.value - 1e-12 && gap <= exemption.attainable.unwrap() + 1e-12);
            assert!(exemption.attainable.unwrap() < clearance);
        }
        assert_eq!(found.exempt.iter().filter_map(|e| e.gap).fold(f64::INFINITY, f64::min), least.value);
        let others = found.min_clearance_not_exempt;
        assert!(others.is_none_or(|others| others.value >= least.value));
    }
}

#[test]
fn exempt_cables_must_still_not_touch() {
    // The cables are at most 50 mm apart; at this diameter they always overlap.
    for (diameter, overlaps) in [(0.03, false), (0.06, true)] {
        let mut spec = thick(diameter, 0.3);
        let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("the paper's robot stands in the scene") };
        robot.cables[4].outlet = [0.0, 0.0, 0.3];
        let [cspace, gjk] = both(&spec);
        let exempt = &cspace.conditions().exempt;
        let vertical = exempt.iter().find(|e| e.pair == ["cable 0", "cable 4"]).unwrap();
        assert_eq!(vertical.attainable.unwrap() < 0.0, overlaps, "{vertical:?}");
        assert!((vertical.attainable.unwrap() - (0.05 - diameter)).abs() < 1e-9);
        assert_eq!(vertical.sentence().contains("must still not touch"), !overlaps, "{}", vertical.sentence());
        let index = vertical.conditions[0];
        let mut refused = [0, 0];
        for k in 0..1000 {
            let p = {
                let at = |step: usize| 0.1 + 0.0018 * ((k * step) % 1000) as f64;
                Point::new(at(1), at(13), at(7))
            };
            let near = cspace.conditions().list[index].clone();
            let cdpr_core::collision::Condition::CableCable(near) = near else { unreachable!("a pair of cables") };
            let gap = near.nearest(&p).distance - diameter;
            for (engine, refused) in [&cspace, &gjk].into_iter().zip(&mut refused) {
                let breaks = engine.breaks(index, &p, &p);
                *refused += usize::from(breaks);
                assert!(overlaps || gap.abs() < 1e-7 || breaks == (gap < 0.0), "{p}: {gap}");
            }
        }
        assert!(refused[0] == refused[1] && (overlaps == (refused[0] == 0)), "{refused:?}");
    }
}

#[test]
fn a_pair_comes_before_its_kind_and_a_kind_before_the_default() {
    let clearances = ClearancesSpec {
        platform_obstacle: Some(0.2),
        cable_cable: Some(0.0),
        pairs: vec![pair("pillar", "cable 3", 0.07), pair("cable 0", "cable 4", 0.001)],
        ..ClearancesSpec::default()
    };
    let spec = SceneSpec { clearance: Some(0.01), ..with(clearances) };
    let [engine, _] = both(&spec);
    let conditions = engine.conditions();
    for condition in &conditions.list {
        let Some(required) = conditions.required(condition) else { continue };
        let culprits = conditions.culprits(condition);
        let expected = match (conditions.kind(condition), [&*culprits[0], &*culprits[1]]) {
            (Kind::PlatformObstacle, _) => 0.2,
            (Kind::CableObstacle, ["cable 3", "pillar"]) => 0.07,
            (Kind::CableCable, ["cable 0", "cable 4"]) => 0.001,
            (Kind::CableCable, _) => 0.0,
            _ => 0.01,
        };
        assert_eq!(required, expected, "{culprits:?}");
    }
    // A planned path keeps all of them, and is not shorter than its bound.
    let scene = scene(spec);
    let found = plan(&scene, &PlanOptions::default(), &|| false).unwrap().result;
    assert_eq!(found.status, Status::Solved);
    for engine in both(scene.spec()) {
        assert!(check_path(&*engine, &found.waypoints(), &Watch::NONE).unwrap().valid);
        let (from, to) = (found.waypoints()[0], *found.waypoints().last().unwrap());
        let bound = lower_bound(&*engine, &from, &to, &Watch::NONE).unwrap();
        assert!(bound <= found.cost + 1e-9 && found.cost > 2.5, "{bound} {}", found.cost);
        let conditions = engine.conditions();
        for (k, condition) in conditions.list.iter().enumerate() {
            let Some(required) = conditions.required(condition) else { continue };
            let gap = cdpr_core::collision::path_check::nearest_of(&*engine, &[k], &found.waypoints(), &Watch::NONE);
            assert!(gap.unwrap().unwrap().value >= required - 1e-7, "{:?}", conditions.culprits(condition));
        }
    }
    // 0.2 m from the platform alone increase the length more than 0.01 m from everything.
    let narrow =
        plan(&self::scene(SceneSpec { clearance: Some(0.01), ..pillar() }), &PlanOptions::default(), &|| false);
    assert!(narrow.unwrap().result.cost < found.cost - 0.05);
}

/// A platform 0.05 m high that starts on a conveyor 0.2 m high.
fn conveyor() -> SceneSpec {
    let mut spec = paper_scene("conveyor", vec![block("conveyor", [0.5, 2.0, 0.2], [0.3, 1.0, 0.1])]);
    spec.query.as_mut().unwrap().start = Some([0.3, 1.0, 0.225].into());
    let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("the paper's robot stands in the scene") };
    robot.cables.drain(..4); // those from below
    SceneSpec { clearance: Some(0.02), ..spec }
}

#[test]
fn a_pair_that_may_touch_touches_but_does_not_enter() {
    let at = |z: f64| Point::new(0.3, 1.0, z);
    let touching = SceneSpec { touch: vec![between("platform", "conveyor")], ..conveyor() };
    for engine in both(&conveyor()) {
        assert!(!engine.state_valid(&at(0.225)) && engine.state_valid(&at(0.2451)));
    }
    for engine in both(&touching) {
        for (depth, valid) in [(-0.001, true), (0.0, true), (5e-10, true), (1e-7, false), (0.001, false)] {
            assert_eq!(engine.state_valid(&at(0.225 - depth)), valid, "{depth}");
            assert_eq!(engine.motion_valid(&at(0.4), &at(0.225 - depth)), valid, "{depth}");
        }
        // Along the conveyor, down to it and up again.
        let along = [Point::new(0.3, 0.6, 0.225), Point::new(0.3, 1.4, 0.225)];
        assert!(engine.motion_valid(&along[0], &along[1]));
        assert!(!engine.motion_valid(&along[0], &(along[1] - cdpr_core::geometry::Vector::z() * 1e-6)));
        // The cables still keep their distance from it.
        let demands = engine.conditions().list.iter().filter(|c| engine.conditions().kind(c) == Kind::CableObstacle);
        assert!(demands.clone().count() > 0 && demands.clone().all(|c| engine.conditions().required(c) == Some(0.02)));
    }
    let planned = plan(&scene(touching.clone()), &PlanOptions::default(), &|| false).unwrap().result;
    assert_eq!(planned.status, Status::Solved, "{:?}", planned.reasons);
    let found = of_path(&touching, &planned.waypoints());
    let [exempt] = &found.exempt[..] else { panic!("{:?}", found.exempt) };
    assert_eq!((exempt.exemption.reason, exempt.exemption.demanded), (Reason::Touch, 0.02));
    assert_eq!(exempt.exemption.pair, ["platform", "conveyor"]);
    assert!(exempt.gap.unwrap().abs() < 1e-9 && found.min_clearance.unwrap().value.abs() < 1e-9);
    assert!(found.min_clearance_not_exempt.unwrap().value >= 0.02 - 1e-7);
    // `ignore` permits it, and is listed.
    let ignoring = SceneSpec { ignore: vec![between("platform", "conveyor")], ..conveyor() };
    let unchecked = |engine: &dyn Checker| {
        let conditions = engine.conditions();
        conditions.list.iter().all(|condition| conditions.kind(condition) != Kind::PlatformObstacle)
    };
    assert!(both(&ignoring).iter().all(|engine| unchecked(&**engine)));
    let [exempt] = &of_path(&ignoring, &PATH).exempt[..] else { panic!("one is listed") };
    assert_eq!((exempt.exemption.reason, exempt.gap), (Reason::Ignore, None));
}

#[test]
fn an_outlet_nearer_than_the_clearance_needs_one_of_its_own() {
    // The outlet of cable 0 is 10 mm from a mast.
    let mast = SceneSpec {
        clearance: Some(0.03),
        ..paper_scene("mast", vec![block("mast", [0.1, 0.1, 1.0], [-0.06, 0.0, 0.0])])
    };
    let at = Point::new(1.0, 1.0, 1.0);
    let [engine, _] = both(&mast);
    assert!(!engine.state_valid(&at));
    let note = &engine.conditions().notes[0];
    assert!(note.contains("[[clearances.pairs]]") && note.contains("touch = [[\"cable 0\", \"mast\"]]"), "{note}");
    let pairs = vec![pair("cable 0", "mast", 0.009)];
    let own = SceneSpec { clearances: Some(ClearancesSpec { pairs, ..ClearancesSpec::default() }), ..mast.clone() };
    let touch = SceneSpec { touch: vec![between("mast", "cable 0")], ..mast };
    for spec in [own, touch] {
        for engine in both(&spec) {
            assert!(engine.state_valid(&at) && engine.conditions().notes.is_empty());
        }
    }
}

#[test]
fn clearance_tables_are_read_and_typos_reported() {
    let text = |more: &str| {
        let tables_from = ["[[clearances", "[clearances"].iter().filter_map(|table| more.find(table)).min();
        let (keys, tables) = more.split_at(tables_from.unwrap_or(more.len()));
        let scene = toml::to_string(&pillar()).unwrap().replace("version = 1\n", &format!("version = 1\n{keys}\n"));
        scene_from_text(&format!("{scene}\n{tables}"), Notation::Toml, None)
    };
    let good = "touch = [[\"platform\", \"pillar\"]]\n[clearances]\ncable_cable = 0.02\n[[clearances.pairs]]\nbetween = [\"cable 1\", \"pillar\"]\nclearance = 0.05";
    let scene: Scene = text(good).unwrap();
    let again = Scene::new(serde_json::from_str(&serde_json::to_string(scene.spec()).unwrap()).unwrap()).unwrap();
    assert_eq!((&again, again.fingerprint()), (&scene, scene.fingerprint()));
    assert_ne!(scene.fingerprint(), text("").unwrap().fingerprint());
    let named = |pairs: &str| format!("[clearances]\n{pairs}");
    let two = "[[clearances.pairs]]\nbetween = [\"cable 1\", \"pillar\"]\nclearance = 0.05\n[[clearances.pairs]]\nbetween = [\"pillar\", \"cable 1\"]\nclearance = 0.06";
    for (more, words) in [
        (named("cabel_cable = 0.02"), vec!["clearances", "cabel_cable", "cable_cable"]),
        (named("cable_cable = -0.02"), vec!["clearances.cable_cable", "-0.02"]),
        (named("cable_cable = nan"), vec!["clearances.cable_cable", "NaN"]),
        (
            "[[clearances.pairs]]\nbetween = [\"cabel 1\", \"pillar\"]\nclearance = 0.1".to_string(),
            vec!["clearances.pairs[0].between", "did you mean \"cable 1\""],
        ),
        (
            "[[clearances.pairs]]\nbetween = [\"pillar\", \"pillar\"]\nclearance = 0.1".to_string(),
            vec!["clearances.pairs[0].between", "different"],
        ),
        (
            "[[clearances.pairs]]\nbetween = [\"cable 1\", \"pillar\"]".to_string(),
            vec!["clearances.pairs[0]", "clearance"],
        ),
        (
            "[[clearances.pairs]]\nbetween = [\"cable 1\", \"pillar\"]\nclearance = inf".to_string(),
            vec!["clearances.pairs[0].clearance", "inf"],
        ),
        (two.to_string(), vec!["clearances.pairs[1].between", "has a clearance of 0.05 m already"]),
        ("touch = [[\"platform\", \"piller\"]]".to_string(), vec!["touch[0]", "did you mean \"pillar\""]),
        (
            "touch = [[\"platform\", \"pillar\"]]\nignore = [[\"pillar\", \"platform\"]]".to_string(),
            vec!["touch[0]", "is listed in ignore already"],
        ),
    ] {
        let told = text(&more).unwrap_err().to_string();
        assert!(words.iter().all(|word| told.contains(word)), "{words:?} in {told}");
    }
}

#[test]
fn a_cable_entering_its_own_part_reports_axis_depth() {
    for diameter in [0.0, 0.02] {
        let mut spec = paper_scene("own part", Vec::new());
        let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("the paper's robot stands in the scene") };
        robot.cables.truncate(1);
        robot.cables[0].diameter = Some(diameter);
        robot.cables[0].attachment = [0.0, 0.0, 0.025]; // on top of the platform, above the outlet
        for engine in both(&spec) {
            let above = Point::new(0.1, 0.1, 1.0);
            let found = engine.explain(&above, &above).unwrap();
            assert_eq!(found.kind, Kind::CablePlatform);
            let [gap, required, margin] = [found.gap, found.required, found.margin].map(Option::unwrap);
            assert_eq!(required.to_bits(), 0.0_f64.to_bits(), "{required}");
            assert!((gap + 0.05).abs() < 1e-9 && gap == margin, "{diameter}: {gap} {margin}"); // the platform's height
        }
    }
}

/// A bound for all positions of a box, against positions in it; also where the attachments are as far apart as demanded, which
/// no position changes.
#[test]
fn boxes_certainly_kept_by_two_cables_are_valid() {
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let mut held = [0; 2];
    for gap in [0.02, 0.05] {
        let conditions = Conditions::new(&hard1().with_clearance(gap).unwrap()).unwrap();
        let pairs = conditions.list.iter().filter(|condition| condition.details().kind() == Kind::CableCable);
        let pairs: Vec<_> = pairs.map(|condition| condition.details()).collect();
        for _ in 0..4000 {
            let pair = pairs[rng.random_range(0..pairs.len())];
            let center = Point::from(Vector::from_fn(|_, _| rng.random_range(0.1..1.9)));
            let half = Vector::from_fn(|_, _| 10.0_f64.powf(rng.random_range(-5.0..-0.5)));
            let cuboid = Cuboid::new(center - half, center + half);
            if !pair.allows_all(&conditions.bodies, &cuboid) {
                continue;
            }
            held[usize::from(pair.slack(&conditions.bodies, &center) < half.norm())] += 1;
            let corners = cuboid.corners();
            let inside = (0..40).map(|_| center + half.map(|x| x * rng.random_range(-1.0..1.0)));
            for place in corners.iter().copied().chain(inside) {
                let slack = pair.slack(&conditions.bodies, &place);
                assert!(slack >= -TOUCH_DEPTH, "{slack:e} at {place}, {cuboid:?}");
            }
        }
    }
    assert!(held[0] > 1000 && held[1] > 100, "{held:?}");
}
