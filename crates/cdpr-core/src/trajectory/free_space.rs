//! Proves that bends are free: the curve as a whole, not samples of it.
//!
//! A bend stays in the convex hull of its control points. If the hull is on the free side of one plane of a forbidden
//! polyhedron, the bend misses the polyhedron; otherwise the bend is halved, and each half has its own control points. What
//! no polyhedron describes exactly, among them clearances, is bounded by distances, which change by at most the length of a
//! motion: a bend keeps a distance if its chord keeps it with as much to spare as the bend deviates from the chord.

use super::curve::{CONTROL, Piece as CurvePiece};
use crate::collision::{Checker, Conditions, Piece};
use crate::conditions::PhysicalCondition;
use crate::error::Error;
use crate::geometry::{Cuboid, HalfSpace, Point, path_length};
use crate::limits::BEND_HALVINGS;
use crate::model::{RuleSpec, Scene};
use crate::tolerances::{CHORD_OF_CELLS, TOUCH_DEPTH};
use crate::watch::Watch;
use crate::wrench::{Measure, measures, slack_reaches};
use std::sync::Arc;

/// The positions that the curve of a trajectory must avoid.
pub struct FreeSpace<'a> {
    checker: &'a dyn Checker,
    bounds: Cuboid,
    pieces: Arc<Vec<Piece>>,
    /// Conditions that forbid positions outside of all polyhedra.
    by_distance: Vec<usize>,
    wrench: Requirement,
}

/// How the wrench requirement of a scene is judged.
enum Requirement {
    /// By measures, everywhere; by none if the scene requires nothing.
    Everywhere(Vec<Measure>),
    /// By the cells of a grid that chords pass through.
    Cells,
}

impl<'a> FreeSpace<'a> {
    /// The forbidden positions of an engine for a scene.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn new(scene: &Scene, checker: &'a dyn Checker, watch: &Watch) -> Result<Self, Error> {
        let conditions = checker.conditions();
        let pieces = checker.pieces(watch)?;
        let mut has_piece = vec![false; conditions.list.len()];
        pieces.iter().for_each(|piece| has_piece[piece.condition] = true);
        let (low, high) = conditions.position_box();
        let exceeds = |index: &usize| !has_piece[*index] || conditions.list[*index].details().exceeds_pieces();
        let by_cells = scene.wrench().is_some_and(|spec| spec.rule == Some(RuleSpec::Grid));
        Ok(FreeSpace {
            checker,
            bounds: Cuboid::new(low, high),
            pieces,
            by_distance: (1..conditions.list.len()).filter(exceeds).collect(),
            wrench: if by_cells { Requirement::Cells } else { Requirement::Everywhere(measures(scene)?) },
        })
    }

    /// Whether a piece of a curve is certainly free.
    pub fn allows(&self, piece: &CurvePiece) -> bool {
        match piece.control() {
            [from, to] => self.checker.motion_valid(from, to),
            control => {
                let control: &[Point; CONTROL] = control.try_into().expect("a bend has six control points");
                let inside = |p: &Point| (p - self.bounds.low).inf(&(self.bounds.high - p)).min() >= -TOUCH_DEPTH;
                let near: Vec<usize> = (0..self.pieces.len()).collect();
                control.iter().all(inside) && self.bend(control, &near, &self.by_distance, BEND_HALVINGS)
            }
        }
    }

    /// Whether a bend misses these pieces and keeps these conditions and the wrench requirement.
    fn bend(&self, control: &[Point; CONTROL], near: &[usize], by_distance: &[usize], halvings: usize) -> bool {
        let hull = Cuboid::around(control);
        let Conditions { list, bodies, .. } = self.checker.conditions();
        let [from, to] = [&control[0], &control[CONTROL - 1]];
        let away = control.iter().map(|p| distance_from_segment(p, from, to)).fold(0.0, f64::max);
        let roomy = |condition: &dyn PhysicalCondition| {
            let spare = || condition.distance(bodies, from, to) - condition.required(bodies) - away;
            condition.is_rounded() && (spare() >= -TOUCH_DEPTH || condition.allows_all(bodies, &hull))
        };
        let mut left = Vec::new();
        let mut measured: Option<(usize, bool)> = None;
        for &index in near {
            let Piece { condition, ref outer, .. } = self.pieces[index];
            if separated(outer, control) {
                continue;
            }
            let keeps = match measured {
                Some((known, keeps)) if known == condition => keeps,
                _ => roomy(list[condition].details()),
            };
            measured = Some((condition, keeps));
            if !keeps {
                left.push(index);
            }
        }
        let undecided = |index: &&usize| {
            let condition = list[**index].details();
            !roomy(condition) && !condition.allows_all(bodies, &hull)
        };
        let by_distance: Vec<usize> = by_distance.iter().filter(undecided).copied().collect();
        if left.is_empty() && by_distance.is_empty() && self.balanced(control, away) {
            return true;
        }
        let broken = |p: &Point| !self.checker.state_valid(p);
        if halvings == 0 || broken(from) || broken(to) {
            return false;
        }
        halves(control).iter().all(|half| self.bend(half, &left, &by_distance, halvings - 1))
    }

    /// Whether the cables certainly provide the required wrenches along a bend: the slack on its chord exceeds what it can
    /// change over the distance `away` between the two.
    fn balanced(&self, control: &[Point; CONTROL], away: f64) -> bool {
        let [from, to] = [&control[0], &control[CONTROL - 1]];
        let reach = path_length(control);
        let holds = |measure: &Measure| slack_reaches(measure, from, to, away * measure.steepness(from, reach));
        match &self.wrench {
            Requirement::Everywhere(measures) => measures.iter().all(holds),
            Requirement::Cells => away <= CHORD_OF_CELLS && self.checker.motion_valid(from, to),
        }
    }
}

/// Whether all points are outside one of the half-spaces, or touch it.
fn separated(half_spaces: &[HalfSpace], points: &[Point]) -> bool {
    half_spaces.iter().any(|plane| points.iter().all(|p| plane.height(p) >= -TOUCH_DEPTH))
}

fn distance_from_segment(point: &Point, from: &Point, to: &Point) -> f64 {
    let step = to - from;
    let squared = step.norm_squared();
    let share = if squared > 0.0 { ((point - from).dot(&step) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (point - (from + step * share)).norm()
}

/// The control points of both halves of a bend, by de Casteljau's algorithm.
fn halves(control: &[Point; CONTROL]) -> [[Point; CONTROL]; 2] {
    let (mut level, mut first, mut second) = (*control, *control, *control);
    for k in 1..CONTROL {
        for i in 0..CONTROL - k {
            level[i] = nalgebra::center(&level[i], &level[i + 1]);
        }
        first[k] = level[0];
        second[CONTROL - 1 - k] = level[CONTROL - 1 - k];
    }
    [first, second]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector;

    #[test]
    fn halves_are_parts_of_the_same_curve() {
        let control: [Point; CONTROL] =
            std::array::from_fn(|k| Point::new(k as f64, (k * k) as f64, (k * k * k) as f64));
        let piece = CurvePiece::bend(control);
        let [first, second] = halves(&control).map(CurvePiece::bend);
        for k in 0..=10 {
            let u = f64::from(k) / 10.0;
            let whole = |u: f64| piece.at(u * piece.length).position;
            assert!((first.at(u * first.length).position - whole(0.5 * u)).norm() < 1e-12);
            assert!((second.at(u * second.length).position - whole(0.5 + 0.5 * u)).norm() < 1e-12);
        }
    }

    #[test]
    fn points_touching_a_plane_count_as_separated() {
        let box_of = |x: f64| HalfSpace { normal: Vector::x(), offset: x };
        let points = [Point::new(1.0, 0.0, 0.0), Point::new(2.0, 5.0, 0.0)];
        assert!(separated(&[box_of(1.0)], &points) && !separated(&[box_of(1.1)], &points));
    }
}
