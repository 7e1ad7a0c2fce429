//! Bodies fattened by a distance, as polyhedra that contain all points closer than that.

use std::borrow::Cow;
use std::sync::OnceLock;

use super::bodies::Bodies;
use crate::geometry::{HalfSpace, Point, Polytope, Vector};
use crate::tolerances::{FATTENED, INSIDE, PARALLEL, RIGHT_ANGLE};

/// Obstacles fattened by the required clearances of cables, computed on first use and shared by all cables.
#[derive(Debug, Default)]
pub struct Fattened {
    /// For each obstacle, the required distances and the fattened bodies; `None` if the body has no hull.
    bodies: Vec<Vec<(f64, OnceLock<Option<Polytope>>)>>,
    /// The [`directions`] of each obstacle.
    directions: Vec<OnceLock<Vec<Vector>>>,
    /// Whether the fattened bodies contain only what is closer than the distance, instead of all of it.
    inside: bool,
}

impl Fattened {
    /// An empty cache for the obstacles and distances that the conditions of a scene need.
    pub fn of(bodies: &Bodies, wanted: impl Iterator<Item = (usize, f64)>) -> Self {
        let mut gaps: Vec<Vec<f64>> = vec![Vec::new(); bodies.obstacles.len()];
        for (body, gap) in wanted {
            gaps[body].extend([gap, gap.max(FATTENED)]);
        }
        let room = |mut gaps: Vec<f64>| {
            gaps.sort_by(f64::total_cmp);
            gaps.dedup();
            gaps.into_iter().map(|gap| (gap, OnceLock::new())).collect()
        };
        let directions = bodies.obstacles.iter().map(|_| OnceLock::new()).collect();
        Fattened { bodies: gaps.into_iter().map(room).collect(), directions, inside: false }
    }

    /// This cache, still empty, for bodies that contain only what is closer than the distance.
    pub fn from_inside(self) -> Self {
        Fattened { inside: true, ..self }
    }

    /// Whether the fattened bodies contain only what is closer than the distance.
    pub fn is_inside(&self) -> bool {
        self.inside
    }

    fn fatten<'a>(&self, body: &'a Polytope, gap: f64) -> Option<Cow<'a, Polytope>> {
        if self.inside { fattened_inside(body, gap).map(Cow::Owned) } else { fattened(body, gap) }
    }

    /// An obstacle fattened by a distance; `None` if it has no hull.
    pub fn obstacle<'a>(&'a self, bodies: &'a Bodies, body: usize, gap: f64) -> Option<Cow<'a, Polytope>> {
        let obstacle = &bodies.obstacles[body].body;
        match self.bodies.get(body).and_then(|gaps| gaps.iter().find(|(known, _)| *known == gap)) {
            Some((_, known)) => {
                known.get_or_init(|| self.fatten(obstacle, gap).map(Cow::into_owned)).as_ref().map(Cow::Borrowed)
            }
            None => self.fatten(obstacle, gap),
        }
    }

    /// The [`directions`] of an obstacle.
    pub fn directions(&self, bodies: &Bodies, body: usize) -> Cow<'_, [Vector]> {
        let obstacle = &bodies.obstacles[body].body;
        match self.directions.get(body) {
            Some(known) => Cow::Borrowed(known.get_or_init(|| directions(obstacle))),
            None => Cow::Owned(directions(obstacle)),
        }
    }
}

/// Half-spaces that contain everything closer than `gap` to a body with volume: its own, moved outward, and those of a
/// box, to limit the extent at sharp edges.
pub fn around(body: &Polytope, gap: f64) -> Vec<HalfSpace> {
    let mut half_spaces: Vec<HalfSpace> = body.half_spaces().iter().map(|h| h.widened(gap)).collect();
    if gap > 0.0 {
        for k in 0..6 {
            let normal = Vector::ith(k / 2, if k % 2 == 0 { 1.0 } else { -1.0 });
            if !half_spaces.iter().any(|h| h.normal.dot(&normal) >= 1.0) {
                half_spaces.push(HalfSpace::around(body.vertices(), normal).widened(gap));
            }
        }
    }
    half_spaces
}

/// A body that contains everything closer than `gap` to another: a box is enlarged, other bodies are summed with a cube
/// around the ball. `None` if it has no hull.
pub fn fattened(body: &Polytope, gap: f64) -> Option<Cow<'_, Polytope>> {
    if gap == 0.0 {
        return Some(Cow::Borrowed(body));
    }
    if is_box(body) {
        return body.with_planes_moved(gap).map(Cow::Owned);
    }
    body.sum(&Polytope::cuboid([2.0 * gap; 3]).ok()?).ok().map(Cow::Owned)
}

/// A body that contains only points closer than `gap` to another: its sum with the hull of points on a sphere, in the directions of the
/// body's facets. More directions would round its edges better, but polyhedra with more edges take longer to search than that is worth.
/// `None` if it has no hull.
fn fattened_inside(body: &Polytope, gap: f64) -> Option<Polytope> {
    let on_sphere: Vec<Point> = body.facets().iter().map(|facet| (facet.normal * (gap - INSIDE)).into()).collect();
    body.sum(&Polytope::from_vertices(&on_sphere).ok()?).ok()
}

/// Whether a body is a box of any orientation.
fn is_box(body: &Polytope) -> bool {
    let axes = body.normal_axes();
    let square = |k: usize| axes[k].dot(&axes[(k + 1) % 3]).abs() <= RIGHT_ANGLE;
    body.facets().len() == 6 && body.vertices().len() == 8 && axes.len() == 3 && (0..3).all(square)
}

/// Largest angle between the normals of neighbouring bevels, rad; a rounded edge is then exceeded by 3.5 % of its
/// radius.
const BEVEL: f64 = std::f64::consts::FRAC_PI_6;

/// Outward normals of a body's facets, of bevels of its edges, and of its corners.
pub fn directions(body: &Polytope) -> Vec<Vector> {
    let facets = body.facets();
    let mut all: Vec<Vector> = facets.iter().map(|f| f.normal).collect();
    for (k, a) in facets.iter().enumerate() {
        for b in &facets[k + 1..] {
            if a.corners.iter().filter(|corner| b.corners.contains(corner)).count() >= 2 {
                all.extend(between(&a.normal, &b.normal));
            }
        }
    }
    let at =
        |corner: usize| facets.iter().filter(move |f| f.corners.contains(&corner)).map(|f| f.normal).sum::<Vector>();
    all.extend((0..body.vertices().len()).filter_map(|corner| at(corner).try_normalize(PARALLEL)));
    all
}

/// Unit vectors from `a` to `b` in even steps of at most `BEVEL`, excluding both.
pub fn between(a: &Vector, b: &Vector) -> Vec<Vector> {
    let steps = (a.angle(b) / BEVEL).ceil().max(1.0) as usize;
    let at = |k: usize| a.slerp(b, k as f64 / steps as f64);
    (1..steps).map(at).collect()
}
