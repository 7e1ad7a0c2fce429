//! Random scenes: sizes and places as requested, start and goal free, the same for the same seed.

use cdpr_core::collision::{CspaceEngine, Interference, Validity};
use cdpr_core::geometry::Point;
use cdpr_core::model::Scene;
use cdpr_core::testing::{block, empty, hard1, paper_scene, scene};
use cdpr_study::{RandomScenes, RandomScenesSpec};

fn spec(text: &str) -> RandomScenesSpec {
    toml::from_str(text).unwrap()
}

fn scenes(base: Scene, text: &str) -> RandomScenes {
    RandomScenes::new(base, spec(text)).unwrap()
}

fn refused(base: Scene, text: &str) -> String {
    RandomScenes::new(base, spec(text)).unwrap_err().to_string()
}

/// Smallest and largest corner of every obstacle.
fn boxes(scene: &Scene) -> Vec<(Point, Point)> {
    let corners = |k: usize| scene.obstacles()[k].parts[0].vertices();
    let fold = |k: usize| corners(k).iter().fold((corners(k)[0], corners(k)[0]), |(lo, hi), v| (lo.inf(v), hi.sup(v)));
    (0..scene.obstacles().len()).map(fold).collect()
}

fn free(scene: &Scene) -> bool {
    let engine = CspaceEngine::new(scene, Interference::Exact).unwrap();
    engine.state_valid(&scene.start().unwrap()) && engine.state_valid(&scene.goal().unwrap())
}

#[test]
fn random_prisms_match_the_paper_and_keep_ends_free() {
    let scenes = scenes(empty(), "count = 3");
    let (mut widths, mut heights) = (Vec::new(), Vec::new());
    for seed in 0..200 {
        let scene = scenes.draw(seed).unwrap();
        assert!(free(&scene) && scene.obstacles().len() == 3);
        for (low, high) in boxes(&scene) {
            let size = high - low;
            assert!((size.x - size.y).abs() < 1e-12 && low.z.abs() < 1e-12);
            assert!(low.coords.min() > -1e-12 && high.coords.max() < 2.0 + 1e-12);
            widths.push(size.x);
            heights.push(size.z);
        }
    }
    for (sizes, least, largest) in [(widths, 0.1, 0.3), (heights, 0.5, 1.5)] {
        assert!(sizes.iter().all(|s| (least - 1e-12..=largest + 1e-12).contains(s)));
        // Low ones leave start and goal free more often, so the mean is below the middle; both ends of the interval
        // occur.
        let spread = 0.1 * (largest - least);
        assert!(sizes.iter().any(|s| *s < least + spread) && sizes.iter().any(|s| *s > largest - spread));
    }
}

#[test]
fn a_seed_has_its_scene() {
    let scenes = scenes(empty(), "count = 2");
    assert_eq!(scenes.draw(4).unwrap(), scenes.draw(4).unwrap());
    assert_ne!(scenes.draw(4).unwrap(), scenes.draw(5).unwrap());
}

#[test]
fn random_prisms_follow_the_specification() {
    let text = "count = 1\ncount_up_to = 4\nwidth = [0.05, 0.1]\ndepth = [0.2, 0.3]\nheight = [0.1, 0.2]\nturned = true\n\
                floating = true\nregion = { min = [0.5, 0.5, 0.8], max = [1.5, 1.5, 1.9] }";
    let scenes = scenes(empty(), text);
    let mut counts = std::collections::BTreeSet::new();
    for seed in 0..60 {
        let scene = scenes.draw(seed).unwrap();
        counts.insert(scene.obstacles().len());
        for (low, high) in boxes(&scene) {
            assert!(low.x > 0.5 - 1e-9 && low.y > 0.5 - 1e-9 && low.z > 0.8 - 1e-9);
            assert!(high.x < 1.5 + 1e-9 && high.y < 1.5 + 1e-9 && high.z < 1.9 + 1e-9);
        }
    }
    assert_eq!(counts.into_iter().collect::<Vec<_>>(), [1, 2, 3, 4]);
}

#[test]
fn obstacles_of_the_base_stay_and_keep_their_names() {
    let mut spec = paper_scene("named", vec![block("prism 0", [0.1, 0.1, 0.1], [1.0, 0.2, 0.05])]);
    spec.ignore = vec![["cable 0".to_string(), "prism 0".to_string()]];
    let drawn = scenes(scene(spec), "count = 2").draw(1).unwrap();
    let names: Vec<&str> = drawn.obstacles().iter().map(|o| o.name.as_str()).collect();
    assert_eq!(names, ["prism 0", "prism 1", "prism 2"]);
    assert_eq!(scenes(hard1(), "count = 0").draw(3).unwrap().obstacles().len(), 1);
}

#[test]
fn with_the_filter_no_scene_is_solved_by_a_straight_line() {
    let scenes = scenes(empty(), "count = 1\nredraw_straight = true");
    for seed in 0..30 {
        let scene = scenes.draw(seed).unwrap();
        let engine = CspaceEngine::new(&scene, Interference::Exact).unwrap();
        assert!(free(&scene) && !engine.motion_valid(&scene.start().unwrap(), &scene.goal().unwrap()));
    }
}

#[test]
fn impossible_random_scenes_end_with_a_reason() {
    // A prism as wide as the workspace covers everything.
    let scenes = scenes(empty(), "count = 1\nwidth = [2.0, 2.0]\nheight = [1.0, 1.0]\nattempts = 20");
    let told = scenes.draw(0).unwrap_err().to_string();
    assert!(told.contains("found no free scene in 20 draws") && told.contains("the start is not valid"), "{told}");
    let straight = self::scenes(empty(), "count = 0\nredraw_straight = true\nattempts = 5").draw(0).unwrap_err();
    assert!(straight.to_string().contains("the straight line from start to goal is free"));
}

#[test]
fn bad_questions_are_named() {
    for (text, message) in [
        ("count = 1\nwidth = [0.3, 0.1]", "width: found [0.3, 0.1] m"),
        ("count = 1\nwidth = [0.0, 0.1]", "width: found [0, 0.1] m"),
        ("count = 1\nheight = [0.5, 2.5]", "room in the region (2 m)"),
        ("count = 1\nwidth = [nan, 0.1]", "width: found [NaN"),
        ("count = 3\ncount_up_to = 2", "count_up_to: found 2"),
        ("count = 1\nregion = { min = [0.0, 0.0, inf], max = [1.0, 1.0, 1.0] }", "region.min"),
    ] {
        let told = refused(empty(), text);
        assert!(told.contains(message), "{told}");
    }
    let mut spec = paper_scene("no query", Vec::new());
    spec.query = None;
    assert!(refused(scene(spec), "count = 1").contains("query.start"));
    let mut spec = hard1().spec().clone();
    spec.query.as_mut().unwrap().start = Some([1.0, 1.0, 0.5].into());
    let told = refused(scene(spec), "count = 1");
    assert!(told.contains("the start is not valid") && told.contains("even before obstacles are drawn"), "{told}");
}
