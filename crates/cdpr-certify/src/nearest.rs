//! Nearest points of two convex hulls, in floating point: a guess that others verify exactly.

use cdpr_core::geometry::Vector;
use nalgebra::Matrix3;

/// Weights of the corners of both hulls (each at least 0, their sum about 1) in the nearest points of the two.
///
/// Wolfe's algorithm for the point of least norm in the hull of all differences a - b, with the corners of a simplex of
/// at most four differences as its only state.
///
/// # Source
/// P. Wolfe, "Finding the nearest point in a polytope", Mathematical Programming 11, 1976.
pub fn nearest(a: &[Vector], b: &[Vector]) -> [Vec<f64>; 2] {
    let lowest = |points: &[Vector], direction: &Vector| {
        let height = |k: &usize| points[*k].dot(direction);
        (0..points.len()).min_by(|i, j| height(i).total_cmp(&height(j))).expect("a body has corners")
    };
    let size = a.iter().chain(b).map(|p| p.amax()).fold(0.0, f64::max);
    let mut simplex = vec![(0, 0)];
    let mut weights = vec![1.0];
    for _ in 0..200 {
        let at = |&(i, j): &(usize, usize)| a[i] - b[j];
        let best: Vector = simplex.iter().zip(&weights).map(|(pair, weight)| at(pair) * *weight).sum();
        let lower = (lowest(a, &best), lowest(b, &-best));
        let gain = best.dot(&(best - at(&lower)));
        if !(gain > 1e-15 * size * best.norm()) || simplex.contains(&lower) || simplex.len() == 4 {
            break;
        }
        simplex.push(lower);
        weights.push(0.0);
        loop {
            let goal = flat_nearest(&simplex.iter().map(at).collect::<Vec<_>>());
            // From the weights towards the goal, as far as none becomes negative.
            let until = |k: usize| if goal[k] < 0.0 { weights[k] / (weights[k] - goal[k]) } else { 1.0 };
            let step = (0..goal.len()).map(until).fold(1.0, f64::min);
            weights.iter_mut().zip(&goal).for_each(|(weight, goal)| *weight += step * (goal - *weight));
            if step >= 1.0 || simplex.len() == 1 {
                break;
            }
            let least = (0..goal.len()).filter(|k| goal[*k] < 0.0).min_by(|i, j| weights[*i].total_cmp(&weights[*j]));
            let least = least.expect("a step below 1 has a reason");
            simplex.remove(least);
            weights.remove(least);
        }
    }
    let mut all = [vec![0.0; a.len()], vec![0.0; b.len()]];
    for ((i, j), weight) in simplex.into_iter().zip(weights) {
        all[0][i] += weight.max(0.0);
        all[1][j] += weight.max(0.0);
    }
    all
}

/// The distance of two hulls.
pub fn distance(a: &[Vector], b: &[Vector]) -> f64 {
    let [in_a, in_b] = nearest(a, b);
    let at = |points: &[Vector], weights: &[f64]| -> Vector { points.iter().zip(weights).map(|(p, w)| p * *w).sum() };
    (at(a, &in_a) - at(b, &in_b)).norm()
}

/// Weights (of any sign, with the sum 1) of at most four points in the point of least norm on the line, plane or space
/// through them.
fn flat_nearest(points: &[Vector]) -> Vec<f64> {
    let column = |k: usize| points.get(k).map_or(Vector::zeros(), |p| p - points[0]);
    let edges = Matrix3::from_columns(&[column(1), column(2), column(3)]);
    let longest = edges.amax();
    let svd = edges.try_svd(true, true, f64::EPSILON, 100);
    let found = svd.and_then(|svd| svd.solve(&-points[0], 1e-14 * longest).ok()).unwrap_or_default();
    let others = &found.as_slice()[..points.len() - 1];
    std::iter::once(1.0 - others.iter().sum::<f64>()).chain(others.iter().copied()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube(low: f64, side: f64) -> Vec<Vector> {
        (0..8).map(|k| Vector::from_fn(|axis, _| low + side * f64::from(k >> axis & 1))).collect()
    }

    #[test]
    fn cubes_are_as_far_apart_as_they_look() {
        assert!((distance(&cube(0.0, 1.0), &cube(2.0, 1.0)) - 3f64.sqrt()).abs() < 1e-14);
        assert!(distance(&cube(0.0, 1.0), &cube(0.3, 0.2)) < 1e-14);
        let needle = [Vector::new(0.5, 0.5, 1.25), Vector::new(9.0, 9.0, 9.0)];
        assert!((distance(&cube(0.0, 1.0), &needle) - 0.25).abs() < 1e-14);
    }

    #[test]
    fn numbers_beyond_all_bounds_end() {
        for huge in [1e308, f64::INFINITY, f64::NAN, 5e-324] {
            let [a, b] = nearest(&cube(huge, huge), &cube(0.0, 1.0));
            assert_eq!((a.len(), b.len()), (8, 8));
        }
    }
}
