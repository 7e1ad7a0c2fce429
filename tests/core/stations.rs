//! Stations: the same answers as with their coordinates, at their orientations.

use std::f64::consts::FRAC_PI_2;

use cdpr_core::Scene;
use cdpr_core::geometry::{Point, Rotation, Vector, wxyz};
use cdpr_core::model::{OrientationSource, PositionSource, QuerySpec, SceneSpec, StationSpec, WorkspaceSpec};
use cdpr_core::plan::{PlanOptions, Query, plan};
use cdpr_core::survey::survey;
use cdpr_core::testing::{self, block, paper_scene};
use cdpr_core::watch::Watch;

fn named(name: &str) -> Option<PositionSource> {
    Some(PositionSource::Named(name.to_string()))
}

fn station(name: &str, position: [f64; 3], orientation: Option<OrientationSource>) -> StationSpec {
    StationSpec { name: name.to_string(), position, orientation }
}

/// hard1 with stations at its start and goal, and one in between.
fn spec() -> SceneSpec {
    let stations = vec![
        station("dock", [0.3, 1.0, 0.3], None),
        station("rack", [1.7, 1.0, 1.7], None),
        station("pillar", [1.0, 1.0, 0.5], None),
    ];
    SceneSpec { stations, ..testing::hard1().spec().clone() }
}

fn between(spec: SceneSpec, start: &str, goal: &str) -> SceneSpec {
    let query = QuerySpec { start: named(start), goal: named(goal), ..spec.query.clone().unwrap_or_default() };
    SceneSpec { query: Some(query), ..spec }
}

fn yawed() -> Rotation {
    Rotation::from_scaled_axis(Vector::z() * FRAC_PI_2)
}

fn quaternion(turn: Rotation) -> Option<OrientationSource> {
    Some(wxyz(&turn).into())
}

fn refused(spec: SceneSpec) -> String {
    Scene::new(spec).unwrap_err().to_string()
}

#[test]
fn a_path_between_stations_is_that_between_their_coordinates() {
    let scene = Scene::new(between(spec(), "dock", "rack")).unwrap();
    let bare = testing::hard1();
    assert_eq!((scene.start(), scene.goal()), (bare.start(), bare.goal()));
    assert_eq!(scene.fingerprint(), bare.fingerprint(), "paths do not depend on stations");
    let [by_name, given] = [&scene, &bare].map(|scene| plan(scene, &PlanOptions::default(), &()).unwrap().result);
    assert_eq!(by_name.path, given.path);
    let there = scene.clone().between([named("rack"), named("dock")]).unwrap();
    assert_eq!((there.start(), there.goal()), (bare.goal(), bare.start()));
    assert_eq!(there.spec().query.as_ref().unwrap().start, named("rack"), "the name is kept");
    let written: SceneSpec = serde_json::from_str(&serde_json::to_string(there.spec()).unwrap()).unwrap();
    assert_eq!(Scene::new(written).unwrap(), there);
}

#[test]
fn unknown_and_repeated_names_are_refused() {
    let misspelt = refused(between(spec(), "dock", "rak"));
    assert_eq!(
        misspelt,
        "query.goal: found \"rak\", expected a position [x, y, z] or one of the scene's stations (dock, rack, pillar); \
         did you mean \"rack\"?"
    );
    assert!(
        refused(between(testing::hard1().spec().clone(), "a", "b")).ends_with("one of the scene's stations (none)")
    );
    let mut twice = spec();
    twice.stations.push(station("rack", [0.0; 3], None));
    assert_eq!(refused(twice), "stations[3].name: found \"rack\", expected a unique name");
    let mut nowhere = spec();
    nowhere.stations[1].position[2] = f64::NAN;
    assert!(refused(nowhere).starts_with("stations[1].position"));
    let mut unnamed = spec();
    unnamed.stations[0].name = " ".to_string();
    assert!(refused(unnamed).starts_with("stations[0].name"));
    let mut turned = spec();
    turned.stations[2].orientation = Some(OrientationSource::Named("level".to_string()));
    assert!(refused(turned).starts_with("stations[2].orientation: found \"level\""));
}

#[test]
fn stations_with_one_orientation_select_it() {
    let mut turned = spec();
    turned.stations[..2].iter_mut().for_each(|station| station.orientation = quaternion(yawed()));
    let scene = Scene::new(between(turned.clone(), "dock", "rack")).unwrap();
    assert!(scene.orientation_is_fixed() && !Query::of(&scene).turns());
    assert!(scene.has_orientation(&yawed()));
    let given = testing::hard1().turned(wxyz(&yawed()).into()).unwrap();
    let [by_name, at] = [&scene, &given].map(|scene| plan(scene, &PlanOptions::default(), &()).unwrap().result);
    assert_eq!((by_name.path, scene.fingerprint()), (at.path, given.fingerprint()));
    // The query as coordinates asks the same.
    let located = SceneSpec { query: scene.located_query(), ..turned.clone() };
    assert!(!Query::of(&Scene::new(located).unwrap()).turns());
    let asked = scene.with_ends(Query::of(&scene).poses().unwrap()).unwrap();
    assert_eq!(asked.orientation(), scene.orientation());

    // An orientation of the query, or a platform that may turn anyway, leaves it to the ends.
    let mut held = between(turned.clone(), "dock", "rack");
    held.query.as_mut().unwrap().orientation = quaternion(Rotation::identity());
    let scene = Scene::new(held).unwrap();
    assert!(Query::of(&scene).turns() && scene.end_orientations() == [yawed(); 2]);
    let free = SceneSpec { turning: Some(Default::default()), ..between(turned.clone(), "dock", "rack") };
    let scene = Scene::new(free).unwrap();
    assert!(scene.has_orientation(&Rotation::identity()) && scene.end_orientations() == [yawed(); 2]);

    // A station with an orientation and one without: the platform turns, unless a key says otherwise.
    let mut one = between(turned, "dock", "pillar");
    assert_eq!(Scene::new(one.clone()).unwrap().end_orientations(), [yawed(), Rotation::identity()]);
    one.query.as_mut().unwrap().start_orientation = quaternion(Rotation::identity());
    assert!(!Query::of(&Scene::new(one).unwrap()).turns());
}

#[test]
fn another_start_takes_the_orientation_of_its_station_along() {
    let mut turned = spec();
    turned.stations[0].orientation = quaternion(yawed());
    let scene = Scene::new(between(turned, "dock", "rack")).unwrap();
    assert_eq!(scene.end_orientations()[0], yawed());
    let elsewhere = scene.between([Some(Point::new(0.3, 1.0, 0.5).into()), named("rack")]).unwrap();
    assert_eq!(elsewhere.end_orientations(), [Rotation::identity(); 2]);
    assert!(!Query::of(&elsewhere).turns());
}

#[test]
fn a_survey_checks_each_station_at_its_orientation() {
    // A bar of 0.4 m along x between two walls that leave 0.3 m: it fits only along y.
    let mut walls = paper_scene("walls", Vec::new());
    let wall = |name: &str, x: f64| block(name, [0.2, 0.6, 1.0], [x, 1.0, 0.5]);
    walls.obstacles = vec![wall("left", 0.75), wall("right", 1.25)];
    let cdpr_core::model::RobotSource::Inline(robot) = &mut walls.robot else { unreachable!() };
    robot.platform = vec![block("bar", [0.4, 0.1, 0.05], [0.0; 3])];
    robot.cables.clear();
    let cable = |x: f64| cdpr_core::model::CableSpec {
        outlet: [x, 1.0, 2.0],
        attachment: [0.0, 0.0, 0.025],
        ..Default::default()
    };
    robot.cables = vec![cable(0.9), cable(1.1)];
    walls.workspace = WorkspaceSpec { min: [0.0; 3], max: [2.0; 3] };
    let stations = vec![
        station("level", [1.0, 1.0, 0.5], None),
        station("turned", [1.0, 1.0, 0.5], quaternion(yawed())),
        station("above", [1.0, 1.0, 1.5], None),
        station("outside", [1.0, 1.0, 2.5], quaternion(yawed())),
    ];
    let scene = Scene::new(SceneSpec { stations, ..walls }).unwrap();
    let states = survey(&scene, &Watch::NONE).unwrap().stations;
    let valid: Vec<(&str, bool)> = states.iter().map(|s| (s.station.as_str(), s.violation.is_none())).collect();
    assert_eq!(valid, [("level", false), ("turned", true), ("above", true), ("outside", false)]);
}
