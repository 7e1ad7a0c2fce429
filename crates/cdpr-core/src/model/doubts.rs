//! Notes on values that are allowed but hardly meant: obstacles in another unit or far away, a clearance in the wrong table.

use super::obstacle::Obstacle;
use super::robot::Cable;
use super::scene::Scene;
use super::spec::SceneSpec;
use crate::geometry::Aabb;
use crate::words::small_length;

/// An obstacle is doubted if it is farther from the box around workspace and outlets than this multiple of its diagonal.
const FAR: f64 = 2.0;
/// An obstacle is doubted if it is smaller than this share of the box around workspace and outlets, as a mesh in metres is that
/// is read in millimetres.
const TINY: f64 = 1e-3;

/// Notes on obstacles that are far away or tiny compared with the box around workspace and outlets, and on a clearance of
/// motions that paths do not keep; on tensions that the sag of cables depends on, if nothing proves that the cables can have them; and on
/// drums that not all cables have.
pub fn doubts(scene: &Scene) -> Vec<String> {
    let others = motion_clearance(scene.spec()).into_iter().chain(unproved_tensions(scene)).chain(missing_drums(scene));
    misplaced(scene).into_iter().chain(others).collect()
}

/// A note on drums that some cables have and others do not: angles and torques are computed for all cables or none.
fn missing_drums(scene: &Scene) -> Option<String> {
    let (with, without): (Vec<&Cable>, Vec<&Cable>) =
        scene.robot().cables().iter().partition(|cable| cable.drum.is_some());
    let (with, without) = (with.first()?, without.first()?);
    Some(format!(
        "{} has a `drum` and {} has none: angles and torques of motors are computed only if all cables have one",
        with.name, without.name
    ))
}

fn unproved_tensions(scene: &Scene) -> Option<String> {
    let cables = scene.robot().cables().iter();
    let hanging = cables.zip(scene.envelopes()).filter(|(_, shape)| shape.as_ref().is_some_and(|s| s.sag.is_some()));
    let kept = |cable: &Cable| cable.sag_tension.expect("cables that sag have one");
    let proved =
        |cable: &Cable| scene.wrench().is_some() && cable.tension.is_some_and(|[least, _]| least >= kept(cable));
    let unproved: Vec<&Cable> = hanging.map(|(cable, _)| cable).filter(|cable| !proved(cable)).collect();
    let least = unproved.iter().map(|cable| kept(cable)).fold(f64::INFINITY, f64::min);
    let (first, others) = unproved.split_first()?;
    let more = if others.is_empty() { String::new() } else { format!(" and {} more", others.len()) };
    let remedy = if scene.wrench().is_some() { "their minimum `tension` is lower" } else { "[wrench] would" };
    Some(format!(
        "the sag of {}{more} assumes that the controller keeps at least {least} N in them; nothing here proves that the cables can \
         have these tensions ({remedy})",
        first.name
    ))
}

fn misplaced(scene: &Scene) -> Vec<String> {
    let workspace = scene.workspace();
    let outlets = scene.robot().cables().iter().map(|cable| cable.outlet);
    let room = Aabb::around(&[workspace.min, workspace.max].into_iter().chain(outlets).collect::<Vec<_>>());
    let size = |aabb: &Aabb| (aabb.max - aabb.min).norm();
    let (mut far, mut tiny) = (Vec::new(), Vec::new());
    for obstacle in scene.obstacles() {
        let around = obstacle.aabb();
        let (distance, extent) = (around.distance(&room), size(&around));
        if distance > FAR * size(&room) {
            far.push((obstacle, distance));
        } else if extent < TINY * size(&room) {
            tiny.push((obstacle, extent));
        }
    }
    let notes =
        [(far, "away from workspace and cables; check its position and units"), (tiny, "large; check its units")];
    notes.into_iter().filter_map(|(found, words)| note(&found, words)).collect()
}

fn note(found: &[(&Obstacle, f64)], words: &str) -> Option<String> {
    let [(first, length), others @ ..] = found else { return None };
    let more = if others.is_empty() { String::new() } else { format!(" (and {} more obstacles alike)", others.len()) };
    Some(format!("obstacle {} is {} {words}{more}", first.name, small_length(*length)))
}

fn motion_clearance(spec: &SceneSpec) -> Option<String> {
    let asked = spec.motion.and_then(|motion| motion.clearance)?;
    let kept = exceeded_clearance(spec, asked)?;
    Some(format!(
        "`clearance = {asked}` in [motion] is for timed motions only, paths keep {kept} m; for both, write it above the first table of \
         the scene"
    ))
}

/// The clearance of a scene, m, if motions are asked to keep more and not all kinds of pairs have clearances of their own.
pub fn exceeded_clearance(spec: &SceneSpec, asked: f64) -> Option<f64> {
    let kept = spec.clearance.unwrap_or(0.0);
    let all_own = spec.clearances.as_ref().is_some_and(|own| {
        [own.platform_obstacle, own.cable_obstacle, own.cable_platform, own.cable_cable].iter().all(Option::is_some)
    });
    (asked > kept && !all_own).then_some(kept)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::spec::{
        BodySpec, CableDefaultsSpec, ClearancesSpec, DrumSpec, MotionSpec, RobotSource, WrenchSpec,
    };
    use crate::testing::{empty, hard1};

    fn notes(size: f64, x: f64) -> Vec<String> {
        let body = BodySpec {
            name: Some("machine".to_string()),
            cuboid: Some([size; 3]),
            position: Some([1.0 + x, 1.0, 1.0]),
            ..BodySpec::default()
        };
        let scene = Scene::new(SceneSpec { obstacles: vec![body], ..empty().spec().clone() }).unwrap();
        doubts(&scene)
    }

    #[test]
    fn an_obstacle_of_usual_size_in_or_near_the_workspace_is_not_doubted() {
        for (size, x) in [(0.3, 0.0), (0.01, 0.0), (10.0, 8.0), (0.3, 5.0)] {
            assert!(notes(size, x).is_empty(), "{size} {x}: {:?}", notes(size, x));
        }
    }

    #[test]
    fn an_obstacle_that_is_tiny_or_far_away_is_noted() {
        let one = |size, x| notes(size, x).concat();
        assert!(one(0.3, 300.0).ends_with("check its position and units"), "{}", one(0.3, 300.0));
        assert!(one(1e-3, 0.0).ends_with("large; check its units"), "{}", one(1e-3, 0.0));
    }

    #[test]
    fn tensions_that_sag_depends_on_are_noted_unless_they_are_proved() {
        let with = |wrench: bool, cable: CableDefaultsSpec| {
            let mut spec = empty().spec().clone();
            let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("the robot is in the scene") };
            robot.cable = Some(cable);
            spec.wrench = wrench.then(WrenchSpec::default);
            doubts(&Scene::new(spec).unwrap()).concat()
        };
        let sagging = CableDefaultsSpec { linear_density: Some(0.003), ..CableDefaultsSpec::default() };
        let above = CableDefaultsSpec { sag_tension: Some(20.0), ..sagging.clone() };
        assert!(
            with(false, sagging.clone()).contains("cable 0 and 7 more assumes that the controller keeps at least 10 N")
        );
        assert_eq!(with(true, sagging), "");
        assert!(with(true, above).contains("their minimum `tension` is lower"));
    }

    #[test]
    fn drums_of_some_cables_are_noted() {
        let with = |drums: usize| {
            let mut spec = empty().spec().clone();
            let RobotSource::Inline(robot) = &mut spec.robot else { unreachable!("the robot is in the scene") };
            let drum = DrumSpec { radius: 0.1, gear: None, zero: None, lead: None };
            robot.cables[8 - drums..].iter_mut().for_each(|cable| cable.drum = Some(drum));
            doubts(&Scene::new(spec).unwrap()).concat()
        };
        assert!(with(1).starts_with("cable 7 has a `drum` and cable 0 has none"), "{}", with(1));
        assert_eq!([with(0), with(8)], ["", ""]);
    }

    #[test]
    fn a_clearance_of_motions_that_paths_do_not_keep_is_noted() {
        let with = |clearance, clearances, motion| {
            let motion = MotionSpec { clearance: Some(motion), ..MotionSpec::default() };
            let spec = SceneSpec { clearance, clearances, motion: Some(motion), ..hard1().spec().clone() };
            doubts(&Scene::new(spec).unwrap()).len()
        };
        let noted = [with(None, None, 0.05), with(Some(0.01), None, 0.05)];
        let kept = [with(Some(0.05), None, 0.05), with(Some(0.05), None, 0.01)];
        assert_eq!((noted, kept), ([1, 1], [0, 0]));
        let wide = Some(0.1);
        let kinds = ClearancesSpec {
            platform_obstacle: wide,
            cable_obstacle: wide,
            cable_platform: wide,
            ..Default::default()
        };
        let all = ClearancesSpec { cable_cable: wide, ..kinds.clone() };
        assert_eq!([with(None, Some(kinds), 0.05), with(None, Some(all), 0.05)], [1, 0]);
    }
}
