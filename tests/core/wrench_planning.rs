//! Planning and checking on scenes with [wrench].

use cdpr_core::collision::{Checker, Conditions, Engine, Interference, Kind, check_path};
use cdpr_core::compiled::engine_for;
use cdpr_core::geometry::{Point, Vector};
use cdpr_core::model::spec::MotionSpec;
use cdpr_core::model::{
    BodySpec, CableSpec, MarginSpec, MembershipSpec, QuerySpec, RobotSource, RuleSpec, Scene, SceneSpec, WorkspaceSpec,
    WrenchSpec,
};
use cdpr_core::plan::{PlanOptions, plan};
use cdpr_core::planning::Status;
use cdpr_core::testing::{block, paper_scene};
use cdpr_core::trajectory::Trajectory;
use cdpr_core::watch::Watch;
use cdpr_core::wrench::{
    Measure, Required, Statics, TensionQp, WrenchConstraint, certified, constraint, first_failure, least_slack,
    measures, wrench_at,
};
use cdpr_files::scene_from_text;
use cdpr_files::text::Notation;
use cdpr_tests::compiled;
use cdpr_tests::{built_robot, built_scene, rng};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// CoGiRo in its hall with two pillars, from one side to the other.
fn cogiro(wrench: WrenchSpec) -> Scene {
    let pillars: Vec<BodySpec> =
        vec![block("west", [0.6, 0.6, 1.6], [-2.0, 0.5, 0.8]), block("east", [0.6, 0.6, 1.6], [2.0, -0.5, 0.8])];
    let spec = SceneSpec {
        robot: RobotSource::Inline(built_robot("cogiro").spec().clone()),
        workspace: WorkspaceSpec { min: [-7.0, -5.0, 0.0], max: [7.0, 5.0, 5.3] },
        query: Some(QuerySpec::between([-4.0, 0.0, 0.5], [4.0, 0.0, 0.5])),
        wrench: Some(wrench),
        ..paper_scene("cogiro hall", pillars)
    };
    Scene::new(SceneSpec { version: 1, ..spec }).expect("a sound scene")
}

fn balls(force: f64, moment: f64) -> WrenchSpec {
    WrenchSpec { force: Some(force), moment: Some(moment), ..WrenchSpec::default() }
}

fn slack_along(measures: &[Measure], path: &[Point]) -> f64 {
    let points = |pair: &[Point]| -> Vec<Point> {
        (0..=200).map(|k| pair[0] + (pair[1] - pair[0]) * (f64::from(k) / 200.0)).collect()
    };
    let all = path.windows(2).flat_map(points);
    all.flat_map(|p| measures.iter().map(move |m| m.slack(&p))).fold(f64::INFINITY, f64::min)
}

#[test]
fn planned_paths_keep_the_demand_under_both_rules_and_engines() {
    for rule in [RuleSpec::Certified, RuleSpec::Grid] {
        let scene = cogiro(WrenchSpec { rule: Some(rule), grid: Some(0.25), ..balls(40.0, 10.0) });
        for (engine, seed) in [(Engine::Cspace, 0), (Engine::Cspace, 1), (Engine::Gjk, 0)] {
            let result = plan(&scene, &PlanOptions { engine, seed, ..PlanOptions::paper() }, &|| false).unwrap().result;
            assert_eq!(result.status, Status::Solved);
            let slack = slack_along(&measures(&scene).unwrap(), &result.waypoints());
            assert!(slack >= 0.0 || rule == RuleSpec::Grid && slack > -20.0, "{slack}");
        }
    }
}

#[test]
fn an_infeasible_start_names_the_limiting_cables() {
    let scene = cogiro(balls(5000.0, 30.0));
    let result = plan(&scene, &PlanOptions::default(), &|| false).unwrap().result;
    assert_eq!(result.status, Status::StartInvalid);
    let reason = result.reason().expect("a reason").clone();
    let limit = reason.wrench.clone().expect("a wrench limit");
    assert_eq!((reason.kind, reason.margin), (Kind::Wrench, None));
    assert!(limit.wrench_margin.unwrap() < -1000.0);
    assert_eq!(limit.at_greatest.len() + limit.at_least.len(), 3); // eight cables minus the five that span the facet
    assert_eq!(reason.culprits.len(), 3);
    assert!(
        reason.sentence().starts_with("the cables cannot balance the required wrenches by "),
        "{}",
        reason.sentence()
    );
}

#[test]
fn the_grid_rule_tells_the_corner_that_it_refuses_for() {
    let scene = cogiro(WrenchSpec { rule: Some(RuleSpec::Grid), grid: Some(0.25), ..balls(60.0, 10.0) });
    let engine = engine_for(&scene, Engine::Cspace, Interference::Exact).unwrap();
    let start = Point::new(-4.0, 0.0, 0.5);
    assert!(measures(&scene).unwrap()[0].slack(&start) > 0.0); // the position itself is feasible
    let violation = engine.explain(&start, &start).expect("refused");
    let limit = violation.wrench.clone().unwrap();
    let corner = Point::from(limit.corner.unwrap());
    assert!((corner - start).abs().max() <= 0.25 && limit.wrench_margin.unwrap() < 0.0);
    assert!(violation.sentence().contains(") that decides there, with "), "{}", violation.sentence());
}

#[test]
fn with_nearest_membership_the_nearest_node_decides() {
    let grid = 0.5;
    let papers = WrenchSpec {
        rule: Some(RuleSpec::Grid),
        margin: Some(MarginSpec::Projected),
        membership: Some(MembershipSpec::Nearest),
        grid: Some(grid),
        ..balls(200.0, 10.0)
    };
    let corners = WrenchSpec { membership: None, ..papers.clone() };
    let [papers, corners] = [papers, corners].map(|wrench| {
        let scene = cogiro(wrench);
        let conditions = Conditions::new(&scene).unwrap();
        let (low, high) = conditions.position_box();
        (WrenchConstraint::of(&scene, &conditions).unwrap().unwrap(), measures(&scene).unwrap(), low, high)
    });
    let (rule, measures, low, high) = &papers;
    let nearest = |p: &Point| low + ((p - low) / grid).map(f64::round) * grid;
    let feasible = |p: &Point| measures.iter().all(|m| m.slack(&nearest(p)) >= m.floor());
    let mut rng = rng(9);
    let mut place = || Point::from(Vector::from_fn(|k, _| rng.random_range(low[k]..=high[k])));
    let (mut kept, mut stricter) = (0, 0);
    for _ in 0..2000 {
        let from = place();
        assert_eq!(rule.keeps(&from, &from), feasible(&from), "{from}");
        let to = from + (place() - from) * 0.2;
        let along = (0..=400).all(|k| feasible(&(from + (to - from) * (f64::from(k) / 400.0))));
        assert!(along || !rule.keeps(&from, &to), "{from} to {to}");
        if let Some(violation) = rule.violation(&from, &to) {
            let decides = Point::from(violation.wrench.unwrap().corner.unwrap());
            assert!(
                (nearest(&(from + (to - from) * violation.at)) - decides).norm() <= 1.001 * grid && !feasible(&decides)
            );
        }
        kept += usize::from(rule.keeps(&from, &to));
        stricter += usize::from(rule.keeps(&from, &to) && !corners.0.keeps(&from, &to));
    }
    assert!(kept > 200 && kept < 1800 && stricter > 20, "{kept} kept, {stricter} of them refused by all corners");
}

#[test]
fn the_papers_robot_is_reported_rank_deficient() {
    let spec = SceneSpec { wrench: Some(balls(1.0, 1.0)), ..paper_scene("symmetric", Vec::new()) };
    let result = plan(&Scene::new(spec).unwrap(), &PlanOptions::default(), &|| false).unwrap().result;
    let words = "rank 5 of 6, underconstrained: no tensions resist turning about z";
    let reason = result.reason().unwrap().clone();
    assert!(reason.sentence().contains(words), "{}", reason.sentence());
    let json = serde_json::json!(reason);
    assert_eq!((&json["rank"], &json["holding"]), (&5.into(), &"underconstrained".into()));
}

#[test]
fn a_position_is_feasible_where_planning_allows_it() {
    let four = |attachments: [[f64; 3]; 4]| {
        let outlets = [[0.0, 0.0, 3.0], [6.0, 0.0, 3.0], [6.0, 4.0, 3.0], [0.0, 4.0, 3.0]];
        let cable = |k: usize| CableSpec {
            outlet: outlets[k],
            attachment: attachments[k],
            tension: Some([5.0, 500.0]),
            ..CableSpec::default()
        };
        let mut spec = cogiro(balls(0.0, 0.0)).spec().clone();
        let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!() };
        (robot.cables, robot.mass, robot.center_of_mass) = ((0..4).map(cable).collect(), Some(20.0), None);
        robot.platform = vec![BodySpec { cuboid: Some([0.4, 0.4, 0.2]), ..BodySpec::default() }];
        (spec.obstacles, spec.query) = (Vec::new(), None);
        Scene::new(spec).unwrap()
    };
    let corners = four([[-0.2, -0.2, 0.1], [0.2, -0.2, 0.1], [0.2, 0.2, 0.1], [-0.2, 0.2, 0.1]]);
    let scenes = [cogiro(balls(60.0, 10.0)), corners, four([[0.0, 0.0, 0.1]; 4])];
    let mut feasible = [0; 3];
    for (scene, feasible) in scenes.iter().zip(&mut feasible) {
        let engine = engine_for(scene, Engine::Cspace, Interference::Exact).unwrap();
        let statics = Statics::of(scene).unwrap();
        let required = constraint::required_of(scene, None, None).unwrap();
        for k in 0..60 {
            let at = Point::new(0.5 + f64::from(k % 4), 1.0 + f64::from(k / 4 % 3), 0.6 + 0.4 * f64::from(k / 12));
            let report = wrench_at(&statics, &required, MarginSpec::Capacity, &at).unwrap();
            let refused = engine.violations(&at, &at).iter().any(|violation| violation.kind == Kind::Wrench);
            assert_eq!(report.feasible, !refused, "{} at {at}", scene.robot().name());
            assert!(report.balanced || !report.feasible);
            *feasible += i32::from(report.feasible);
        }
    }
    assert!(feasible[0] > 0 && feasible[1] == 0 && feasible[2] > 0, "{feasible:?}");
    // In the middle, the four cables carry exactly the weight.
    let statics = Statics::of(&scenes[1]).unwrap();
    let middle = Point::new(3.0, 2.0, 1.0);
    let report = wrench_at(&statics, &Required::default(), MarginSpec::Capacity, &middle).unwrap();
    assert!(report.balanced && !report.feasible && report.hold.rank == 4);
}

#[test]
fn wrench_violations_state_where_a_path_fails() {
    let scene = cogiro(balls(60.0, 10.0));
    let engine = engine_for(&scene, Engine::Cspace, Interference::Exact).unwrap();
    // Towards the wall, near the floor.
    let path = [Point::new(-4.0, 0.0, 0.5), Point::new(-6.4, 0.0, 0.5), Point::new(-4.0, 0.0, 0.5)];
    let report = check_path(&*engine, &path, &Watch::NONE).unwrap();
    let wrench: Vec<_> = report.violations.iter().filter(|v| v.violation.kind == Kind::Wrench).collect();
    assert_eq!(wrench.iter().map(|v| v.segment).collect::<Vec<_>>(), [0, 1]);
    let up = &wrench[0].violation;
    let edge = path[0] + (path[1] - path[0]) * up.at;
    let slack = measures(&scene).unwrap()[0].slack(&edge);
    assert!(slack.abs() < 1e-3, "{slack}");
    assert_eq!(wrench[1].violation.at, 0.0);
    assert_eq!(serde_json::json!(wrench[0])["margin"], serde_json::Value::Null);
    assert!(serde_json::json!(wrench[0])["wrench_margin"].as_f64().unwrap() < 0.0);
}

#[test]
fn missing_mass_or_limits_are_named() {
    let without = |change: &dyn Fn(&mut SceneSpec)| {
        let mut spec = cogiro(balls(1.0, 1.0)).spec().clone();
        change(&mut spec);
        match Scene::new(spec) {
            Ok(scene) => engine_for(&scene, Engine::Cspace, Interference::Exact).err().expect("an error").to_string(),
            Err(error) => error.to_string(),
        }
    };
    let robot = |change: fn(&mut cdpr_core::model::RobotSpec)| {
        without(&|spec| match &mut spec.robot {
            RobotSource::Inline(robot) => change(robot),
            RobotSource::File(_) => unreachable!(),
        })
    };
    let wrench = |change: fn(&mut WrenchSpec)| without(&|spec| change(spec.wrench.as_mut().unwrap()));
    assert!(robot(|r| r.mass = None).starts_with("robot.mass: found none"));
    assert!(robot(|r| r.cables[3].tension = None).starts_with("robot.cables[3].tension: found none"));
    assert!(robot(|r| r.cables[3].tension = Some([5.0, 1.0])).starts_with("robot.cables[3].tension: found [5, 1]"));
    let together = robot(|r| r.cables.iter_mut().for_each(|cable| cable.attachment = [0.6, 0.0, 0.0]));
    assert!(together.starts_with("wrench.moment: found a required moment"), "{together}");
    assert!(wrench(|w| w.force = Some(-1.0)).starts_with("wrench.force: found -1"));
    assert!(wrench(|w| w.moment = Some(f64::NAN)).starts_with("wrench.moment: found NaN"));
    let load = wrench(|w| w.load = Some([0.0, 0.0, f64::INFINITY, 0.0, 0.0, 0.0]));
    assert!(load.starts_with("wrench.load: found fz = inf"), "{load}");
    assert!(wrench(|w| w.characteristic_length = Some(0.0)).starts_with("wrench.characteristic_length: found 0"));
    assert!(wrench(|w| w.vertices = Some(vec![[0.0; 6]])).starts_with("wrench.vertices: found together with force"));
    let fine = wrench(|w| (w.rule, w.grid) = (Some(RuleSpec::Grid), Some(1e-3)));
    assert!(fine.starts_with("wrench.grid: found 0.001 m, which makes"), "{fine}");
}

fn nine_cables() -> Scene {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../testdata/cases/nine_cables.json");
    cdpr_files::load_scene(&path).expect("a sound scene")
}

#[test]
fn motions_are_certified_with_nine_cables_and_short_lengths() {
    let scene = nine_cables();
    let engine = engine_for(&scene, Engine::Cspace, Interference::Exact).unwrap();
    let from = Point::new(0.5774323780167936, 1.5622352012666123, 0.24382217475722873);
    let to = Point::new(1.206660607603306, 0.6870908608852255, -0.2258442046841302);
    let measure = &measures(&scene).unwrap()[0];
    assert!((slack_along(std::slice::from_ref(measure), &[from, to]) - 8.927).abs() < 0.01);
    assert!((least_slack(measure, &from, &to).0 - 8.927).abs() < 0.01);
    assert!(engine.motion_valid(&from, &to) && engine.explain(&from, &to).is_none());
    let mut rng = rng(5);
    let (mut accepted, mut tried) = (0, 0);
    while accepted < 40 && tried < 20_000 {
        tried += 1;
        let (from, to) = (within(&mut rng, &*engine), within(&mut rng, &*engine));
        let to = from + (to - from) * 0.3;
        if [from, from + (to - from) * 0.4, to].iter().any(|place| measure.slack(place) < 0.0) {
            continue;
        }
        let least = slack_along(std::slice::from_ref(measure), &[from, to]);
        if least > 0.0 {
            assert!(certified(measure, &from, &to), "{from} to {to}: {least}");
            accepted += 1;
        }
    }
    assert!(accepted == 40, "{accepted} of {tried}");
}

fn within(rng: &mut ChaCha8Rng, engine: &dyn Checker) -> Point {
    let (low, high) = engine.conditions().position_box();
    Point::from(Vector::from_fn(|axis, _| rng.random_range(low[axis]..=high[axis])))
}

#[test]
fn a_motion_is_valid_iff_it_has_no_wrench_violation() {
    let mut rng = rng(6);
    let (mut valid, mut refused, mut near) = (0, 0, 0);
    for scene in
        ["cogiro", "caroca", "ipanema2", "acrobot", "mpi_simulator"].map(built_scene).into_iter().chain([nine_cables()])
    {
        let engine = engine_for(&scene, Engine::Cspace, Interference::Exact).unwrap();
        let all = measures(&scene).unwrap();
        let mut judge = |from: &Point, to: &Point| {
            let violations = engine.violations(from, to);
            assert_eq!(engine.motion_valid(from, to), violations.is_empty(), "{from} to {to}: {violations:?}");
            for violation in violations.iter().filter(|violation| violation.kind == Kind::Wrench) {
                let limit = violation.wrench.as_ref().expect("a limit");
                assert_eq!(
                    violation.unproved,
                    limit.wrench_margin.is_some_and(|margin| margin >= 0.0),
                    "{violation:?}"
                );
            }
            if violations.is_empty() { valid += 1 } else { refused += 1 }
        };
        for _ in 0..60 {
            let (from, to) = (within(&mut rng, &*engine), within(&mut rng, &*engine));
            judge(&from, &to);
            let Some(at) = first_failure(&all[0], &from, &to).filter(|at| *at > 0.0) else { continue };
            // To the feasible limit, and slightly less or more; along the boundary and back.
            for share in [-1e-4, -1e-7, -1e-9, -1e-12, 0.0, 1e-12, 1e-9, 1e-7] {
                let end = from + (to - from) * (at + share).clamp(0.0, 1.0);
                judge(&from, &end);
                judge(&end, &end);
                judge(&end, &from);
                near += 1;
            }
        }
    }
    assert!(valid > 100 && refused > 1000 && near > 500, "{valid} valid, {refused} refused, {near} near the limit");
}

#[test]
fn tiny_slack_is_distinguished_from_a_shortfall() {
    let here = Point::new(0.5, 1.0, 2.0);
    // Slack falls as the requirement grows (up to rounding), so some requirement leaves a slack between zero and the
    // floor.
    let (mut low, mut high) = (0.0, 1e4);
    let slack = |force: f64| {
        let measure = &measures(&cogiro(balls(force, 10.0))).unwrap()[0];
        (measure.slack(&here), measure.floor())
    };
    let demand = loop {
        let middle = 0.5 * (low + high);
        match slack(middle) {
            (slack, _) if slack < 0.0 => high = middle,
            (slack, floor) if slack >= 0.5 * floor => low = middle,
            _ => break middle,
        }
    };
    let engine = engine_for(&cogiro(balls(demand, 10.0)), Engine::Cspace, Interference::Exact).unwrap();
    let violation = engine.explain(&here, &here).expect("refused");
    assert!(violation.unproved && !engine.state_valid(&here));
    let sentence = violation.sentence();
    assert!(
        sentence.starts_with("it could not be proved that the cables balance the required wrenches: "),
        "{sentence}"
    );
    assert_eq!(serde_json::json!(violation)["unproved"], true);
    let lacking = engine_for(&cogiro(balls(demand + 1.0, 10.0)), Engine::Cspace, Interference::Exact).unwrap();
    let violation = lacking.explain(&here, &here).expect("refused");
    assert!(!violation.unproved && violation.sentence().starts_with("the cables cannot balance"));
    assert_eq!(serde_json::json!(violation).get("unproved"), None);
}

/// CASPR's NIST RoboCrane with six suspended cables: a platform of 1 kg, whose tensions are unique.
fn robocrane(most: f64) -> Scene {
    let text = format!(
        "version = 1\n[workspace]\nmin = [-3, -3, 0]\nmax = [3, 3.5, 3]\n[query]\nstart = [0, 0, 1.5]\ngoal = [0.1, 0, 1.4]\n\
         [wrench]\nforce = 1\n[robot]\nmass = 1\nplatform = [{{ vertices = [[0, -0.866, 0], [-0.75, 0.433, 0], [0.75, 0.433, 0]] }}]\n\
         cables = [{}]",
        [
            ([-3.0, -1.7321], [0.0, -0.866]),
            ([-3.0, -1.7321], [-0.75, 0.433]),
            ([3.0, -1.7321], [0.0, -0.866]),
            ([3.0, -1.7321], [0.75, 0.433]),
            ([0.0, 3.4642], [-0.75, 0.433]),
            ([0.0, 3.4642], [0.75, 0.433]),
        ]
        .map(|([x, y], [a, b])| format!(
            "{{ outlet = [{x}, {y}, 3], attachment = [{a}, {b}, 0], tension = [0, {most:?}] }}"
        ))
        .join(", ")
    );
    scene_from_text(&text, Notation::Toml, None).unwrap()
}

#[test]
fn huge_tension_limits_change_nothing() {
    for most in [1e3, 3.7e4, 1e5, 3e9, 9_999_999_999.0] {
        let scene = robocrane(most);
        assert_eq!(scene.notes().len(), usize::from(most > 2e4), "{most}: {:?}", scene.notes());
        let found = plan(&scene, &PlanOptions::default(), &()).unwrap().result;
        assert_eq!(found.status, Status::Solved, "{most}");
        let least = measures(&scene).unwrap()[0].slack(found.waypoints().last().unwrap());
        assert!((least - 2.738).abs() < 1e-3, "{most}: {least}");
        let limits = MotionSpec { speed: Some(1.0), acceleration: Some(2.0), ..MotionSpec::default() };
        let motion = Trajectory::new(&compiled(&scene), &found.path, &limits, &Watch::NONE).unwrap();
        assert!((motion.duration() - 0.5318).abs() < 1e-4, "{most}: {}", motion.duration());
        let tensions = motion.sample(&mut TensionQp::default(), 0.0).unwrap().tensions.unwrap();
        assert!(tensions.iter().all(|t| *t > 1.0 && *t < 10.0), "{most}: {tensions:?}");
    }
}
