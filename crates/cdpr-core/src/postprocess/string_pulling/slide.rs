//! Bends that slide along their edges: the shortest path through a given sequence of lines.
//!
//! The length of a path is a convex function of the positions of its bends, so Newton's method finds their best
//! positions on their edges. The Hessian is tridiagonal, because a bend interacts only with its neighbours.

use super::Bend;
use crate::geometry::{Point, Vector};
use crate::tolerances::{SAME_POINT, TAUT};

/// Maximum number of Newton steps; three to six are typical.
const STEPS: usize = 30;
/// Maximum number of halvings of a Newton step.
const HALVINGS: usize = 20;
/// Added to the Hessian's diagonal, 1/m: an edge parallel to the path makes it singular.
const DAMPING: f64 = 1e-9;

/// How far each bend has to slide along its edge, m, within its range, to make the path shortest.
pub fn best_slides(path: &[Bend], ranges: &[[f64; 2]]) -> Vec<f64> {
    let mut slides = vec![0.0; path.len()];
    let mut length = slid_length(path, &slides);
    for _ in 0..STEPS {
        let step = newton_step(path, &slides, ranges);
        let tried = |share: f64| -> Vec<f64> {
            let moved = slides.iter().zip(&step).zip(ranges);
            moved.map(|((t, s), [low, high])| (t + share * s).clamp(*low, *high)).collect()
        };
        let shorter = (0..HALVINGS).map(|k| tried(0.5f64.powi(k as i32))).find_map(|slides| {
            let new = slid_length(path, &slides);
            (new < length).then_some((slides, new))
        });
        let Some((better, new)) = shorter else { break };
        let gain = length - new;
        (slides, length) = (better, new);
        if gain < 1e-3 * TAUT {
            break;
        }
    }
    slides
}

/// The bends after sliding along their edges.
pub fn slid(path: &[Bend], slides: &[f64], share: f64) -> Vec<Bend> {
    let moved = path.iter().zip(slides).map(|(bend, t)| Bend::new(place(bend, share * t), bend.edge));
    moved.collect()
}

fn place(bend: &Bend, slide: f64) -> Point {
    bend.edge.map_or(bend.place, |along| bend.place + along * slide)
}

fn slid_length(path: &[Bend], slides: &[f64]) -> f64 {
    let ends = |k: usize| place(&path[k + 1], slides[k + 1]) - place(&path[k], slides[k]);
    (0..path.len() - 1).map(|k| ends(k).norm()).sum()
}

/// The Newton step of the slides that are not at the end of their range.
fn newton_step(path: &[Bend], slides: &[f64], ranges: &[[f64; 2]]) -> Vec<f64> {
    let count = path.len();
    let (mut slope, mut diagonal, mut beside) = (vec![0.0; count], vec![DAMPING; count], vec![0.0; count]);
    for k in 0..count - 1 {
        let segment = place(&path[k + 1], slides[k + 1]) - place(&path[k], slides[k]);
        let length = segment.norm().max(SAME_POINT);
        let direction = segment / length;
        let across = |a: &Vector, b: &Vector| (a.dot(b) - direction.dot(a) * direction.dot(b)) / length;
        if let Some(along) = &path[k].edge {
            slope[k] -= direction.dot(along);
            diagonal[k] += across(along, along);
        }
        if let Some(along) = &path[k + 1].edge {
            slope[k + 1] += direction.dot(along);
            diagonal[k + 1] += across(along, along);
        }
        if let (Some(a), Some(b)) = (&path[k].edge, &path[k + 1].edge) {
            beside[k] = -across(a, b);
        }
    }
    for k in 0..count {
        let [low, high] = ranges[k];
        let held = (slides[k] <= low && slope[k] > 0.0) || (slides[k] >= high && slope[k] < 0.0);
        if path[k].edge.is_none() || held {
            (slope[k], diagonal[k], beside[k]) = (0.0, 1.0, 0.0);
            if k > 0 {
                beside[k - 1] = 0.0;
            }
        }
    }
    tridiagonal(&diagonal, &beside, &slope.iter().map(|g| -g).collect::<Vec<_>>())
}

/// Solves a symmetric tridiagonal system: L. H. Thomas's elimination.
fn tridiagonal(diagonal: &[f64], beside: &[f64], right: &[f64]) -> Vec<f64> {
    let count = diagonal.len();
    let (mut upper, mut x) = (vec![0.0; count], vec![0.0; count]);
    for k in 0..count {
        let before = if k > 0 { beside[k - 1] } else { 0.0 };
        let (last_upper, last_x) = if k > 0 { (upper[k - 1], x[k - 1]) } else { (0.0, 0.0) };
        let pivot = (diagonal[k] - before * last_upper).max(DAMPING);
        upper[k] = beside[k] / pivot;
        x[k] = (right[k] - before * last_x) / pivot;
    }
    for k in (0..count.saturating_sub(1)).rev() {
        x[k] -= upper[k] * x[k + 1];
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bend(place: [f64; 3], edge: Option<[f64; 3]>) -> Bend {
        Bend::new(Point::from(place), edge.map(|e| Vector::from(e).normalize()))
    }

    const FREE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

    #[test]
    fn a_bend_goes_where_the_unfolded_path_is_straight() {
        // Ends at 1 m and 3 m from a vertical edge, 4 m apart in height: unfolded, a line of slope 1 that meets it at
        // 1.
        let path =
            [bend([1.0, 0.0, 0.0], None), bend([0.0, 0.0, 3.5], Some([0.0, 0.0, 1.0])), bend([0.0, 3.0, 4.0], None)];
        let slides = best_slides(&path, &[FREE; 3]);
        assert!((slides[1] + 2.5).abs() < 1e-7, "{slides:?}"); // closer than this, lengths are equal up to rounding
        let held = best_slides(&path, &[FREE, [-1.0, 1.0], FREE]);
        assert_eq!(held[1], -1.0);
    }

    #[test]
    fn neighbours_slide_together() {
        // Two parallel edges: the unfolded path is straight over both.
        let up = Some([0.0, 0.0, 1.0]);
        let path = [
            bend([-1.0, 0.0, 0.0], None),
            bend([0.0, 0.0, 5.0], up),
            bend([0.0, 2.0, -4.0], up),
            bend([-3.0, 2.0, 6.0], None),
        ];
        let ends = slid(&path, &best_slides(&path, &[FREE; 4]), 1.0);
        assert!((ends[1].place.z - 1.0).abs() < 1e-7 && (ends[2].place.z - 3.0).abs() < 1e-7, "{ends:?}");
    }
}
