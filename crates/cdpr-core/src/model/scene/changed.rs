//! Scenes that differ in one respect from another one.

use std::sync::Arc;

use super::{Scene, outlets_outside};
use crate::error::Error;
use crate::geometry::{Point, Pose, wxyz};
use crate::model::body;
use crate::model::obstacle::{self, name_of};
use crate::model::obstacle_seams::obstacle_seams;
use crate::model::spec::{BodySpec, OrientationSource, SceneSpec};

impl Scene {
    /// The scene with an obstacle at another place: the first of its parts has this `position`, world, m, and its other parts
    /// move along. Nothing else is built anew.
    ///
    /// # Errors
    /// An unknown name, a position that is not finite or too far away, an outlet inside the obstacle.
    ///
    /// # Example
    /// ```
    /// let scene = cdpr_core::testing::hard3().moved("west", [0.5, 1.0, 0.8].into())?;
    /// assert_eq!(scene.place_of("west"), Some([0.5, 1.0, 0.8].into()));
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn moved(&self, name: &str, position: Point) -> Result<Scene, Error> {
        let to = body::point("position", position.into())?;
        if self.payloads.is_some() {
            // What a payload stands on may have moved.
            let mut spec = self.written().clone();
            if spec.payloads.iter().any(|payload| payload.name == name) {
                let problem =
                    format!("found \"{name}\", which is a payload; expected an obstacle: a payload is placed");
                return Err(Error::invalid("obstacles", problem));
            }
            move_to(&mut spec.obstacles, name, &to)?;
            return Ok(Scene::new(spec)?.with_notes_of(self));
        }
        let mut scene = self.clone();
        let spec = Arc::make_mut(&mut scene.spec);
        move_to(&mut spec.obstacles, name, &to)?;
        let index = self.obstacles.iter().position(|known| known.name == name).expect("it has a place");
        Arc::make_mut(&mut scene.obstacles)[index] = obstacle::obstacle(&spec.obstacles, name)?;
        scene.seams = obstacle_seams(&scene.obstacles, &scene.pairs).into();
        outlets_outside(&scene.robot, &scene.obstacles, &scene.seams)?;
        Ok(scene)
    }

    /// Where an obstacle is: the `position` of the first of its parts, world, m; `None` if there is no such obstacle.
    pub fn place_of(&self, name: &str) -> Option<Point> {
        place_of(&self.spec.obstacles, name)
    }

    /// The scene without an obstacle and the rules for its pairs.
    ///
    /// # Errors
    /// An unknown name.
    ///
    /// # Example
    /// ```
    /// let scene = cdpr_core::testing::hard3().without("west")?;
    /// assert_eq!(scene.obstacles().len(), 2);
    /// # Ok::<(), cdpr_core::Error>(())
    /// ```
    pub fn without(&self, obstacle: &str) -> Result<Scene, Error> {
        self.place_of(obstacle).ok_or_else(|| unknown(obstacle))?;
        let mut spec = (*self.spec).clone();
        for (k, body) in spec.obstacles.iter_mut().enumerate() {
            body.name = Some(name_of(k, body).into_owned());
        }
        spec.obstacles.retain(|body| body.name.as_deref() != Some(obstacle));
        let concerned = |pair: &[String; 2]| pair.iter().any(|name| name == obstacle);
        spec.ignore.retain(|pair| !concerned(pair));
        spec.touch.retain(|pair| !concerned(pair));
        if let Some(clearances) = &mut spec.clearances {
            clearances.pairs.retain(|rule| !concerned(&rule.between));
        }
        Scene::new(spec)
    }

    /// The scene with this start and goal in its query.
    ///
    /// # Errors
    /// Never for the ends of a query of this scene.
    pub fn with_ends(&self, [start, goal]: [Pose; 2]) -> Result<Scene, Error> {
        let mut spec = (*self.spec).clone();
        let query = spec.query.insert(self.located_query().unwrap_or_default());
        (query.start, query.goal) = (Some(start.position.into()), Some(goal.position.into()));
        let turned = |end: &Pose| Some(OrientationSource::Quaternion(wxyz(&end.orientation)));
        (query.start_orientation, query.goal_orientation) =
            if self.keeps_orientation(&[start, goal]) { (None, None) } else { (turned(&start), turned(&goal)) };
        Scene::new(spec)
    }

    /// The scene with this clearance, m, in place of its own; larger clearances of kinds and pairs are lowered to it.
    /// With 0, bodies may touch but not overlap.
    ///
    /// # Errors
    /// A clearance that is negative or too large.
    pub fn with_most_clearance(&self, most: f64) -> Result<Scene, Error> {
        let mut spec = SceneSpec { clearance: Some(most), ..(*self.spec).clone() };
        spec.clearances.iter_mut().for_each(|own| own.limit(most));
        Scene::new(spec)
    }

    /// This scene with another required clearance, m; the clearances in `[clearances]` remain.
    ///
    /// # Errors
    /// A clearance that is negative or too large.
    pub fn with_clearance(&self, clearance: f64) -> Result<Scene, Error> {
        Scene::new(SceneSpec { clearance: Some(clearance), ..(*self.spec).clone() })
    }
}

fn place_of(obstacles: &[BodySpec], name: &str) -> Option<Point> {
    let mut parts = obstacles.iter().enumerate();
    parts.find(|(k, body)| name_of(*k, body) == name).map(|(_, body)| body.position.unwrap_or_default().into())
}

/// Moves all parts of an obstacle so that the first is at a position.
fn move_to(obstacles: &mut [BodySpec], name: &str, to: &Point) -> Result<(), Error> {
    let from = place_of(obstacles, name).ok_or_else(|| unknown(name))?;
    let of_it = |(k, body): &(usize, &mut BodySpec)| name_of(*k, body) == name;
    for (part, (_, body)) in obstacles.iter_mut().enumerate().filter(of_it).enumerate() {
        let place = Point::from(body.position.unwrap_or_default()) + (to - from);
        body.position = Some(if part == 0 { (*to).into() } else { place.into() });
    }
    Ok(())
}

fn unknown(obstacle: &str) -> Error {
    Error::invalid("obstacles", format!("found none with the name \"{obstacle}\""))
}
