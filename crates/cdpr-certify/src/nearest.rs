//! Nearest points of two convex hulls: in floating point, a guess that others verify exactly, and exactly, where the guess proves
//! nothing. Needles and thin plates mislead the guess.

use cdpr_core::geometry::Vector;
use nalgebra::Matrix3;

use crate::exact::{Exact, Exact3, dot, exact, exact3, minus, plus, times};

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
            // The point moves from the weights towards the goal, as far as none becomes negative.
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

/// The vector from the second to the first of the points with these weights.
pub fn between([a, b]: [&[Vector]; 2], [in_a, in_b]: &[Vec<f64>; 2]) -> Vector {
    let at = |points: &[Vector], weights: &[f64]| -> Vector { points.iter().zip(weights).map(|(p, w)| p * *w).sum() };
    at(a, in_a) - at(b, in_b)
}

/// Largest error of a distance, as a share of the largest coordinate: a few times that of a scalar product.
const DISTANCE_ROUNDING: f64 = 1e-14;

/// The distance of two hulls, up to rounding errors.
pub fn distance(a: &[Vector], b: &[Vector]) -> f64 {
    let gap = between([a, b], &nearest(a, b));
    let size = a.iter().chain(b).map(|p| p.amax()).fold(0.0, f64::max);
    let lowest = |points: &[Vector], direction: &Vector| {
        points.iter().map(|p| p.dot(direction)).min_by(f64::total_cmp).expect("a body has corners")
    };
    // The hulls are no nearer than the two planes across the gap.
    let found = gap.norm();
    let apart = (lowest(a, &gap) + lowest(b, &-gap)) / found;
    if found <= DISTANCE_ROUNDING * size || found - apart <= DISTANCE_ROUNDING * size {
        return found;
    }
    let finite = |points: &[Vector]| points.iter().all(|p| p.iter().all(|x| x.is_finite()));
    if !(finite(a) && finite(b)) {
        return found;
    }
    let [a, b] = [a, b].map(|points| points.iter().map(exact3).collect::<Vec<_>>());
    let (square, whole) = squared_distance(&a, &b);
    square.over(&(&whole * &whole)).max(0.0).sqrt()
}

/// The distance of two hulls, exactly: |x|² and s, for the distance |x| / s.
///
/// Wolfe's algorithm. In exact arithmetic it ends, because the distance decreases from one simplex to the next.
pub fn squared_distance(a: &[Exact3], b: &[Exact3]) -> (Exact, Exact) {
    let lowest = |points: &[Exact3], direction: &Exact3| {
        let heights: Vec<Exact> = points.iter().map(|p| dot(p, direction)).collect();
        let less = |i: usize, j: usize| if heights[j] < heights[i] { j } else { i };
        (0..points.len()).reduce(less).expect("a body has corners")
    };
    let at = |i: usize, j: usize| minus(&a[i], &b[j]);
    // A simplex of differences, and a weight of each: the point of least norm, times the sum of the weights.
    let mut simplex = vec![at(0, 0)];
    let mut weights = vec![exact(1.0)];
    loop {
        let zero = exact3(&Vector::zeros());
        let best = simplex.iter().zip(&weights).fold(zero, |sum, (p, weight)| plus(&sum, &times(weight, p)));
        let whole: Exact = weights.iter().cloned().sum();
        let square = dot(&best, &best);
        let lower = at(lowest(a, &best), lowest(b, &minus(&exact3(&Vector::zeros()), &best)));
        if square <= &whole * &dot(&best, &lower) {
            return (square, whole);
        }
        simplex.push(lower);
        weights.push(exact(0.0));
        loop {
            let goal = flat_weights(&simplex);
            let sums: [Exact; 2] = [&weights, &goal].map(|all| all.iter().cloned().sum());
            // The point moves from the weights towards the goal, as far as none becomes negative: by the share `part` /
            // `of`.
            let mut share: Option<(Exact, Exact)> = None;
            for (weight, goal) in weights.iter().zip(&goal).filter(|(_, goal)| goal.sign().is_lt()) {
                let part = weight * &sums[1];
                let of = &part - &(goal * &sums[0]);
                if share.as_ref().is_none_or(|(p, o)| &part * o < p * &of) {
                    share = Some((part, of));
                }
            }
            let is_goal = share.is_none();
            if let Some((part, of)) = share {
                let moved =
                    |(weight, goal): (&Exact, &Exact)| weight * &sums[1] * (&of - &part) + goal * &sums[0] * &part;
                weights = weights.iter().zip(&goal).map(moved).collect();
            } else {
                weights = goal;
            }
            let kept: Vec<bool> = weights.iter().map(|weight| weight.sign().is_gt()).collect();
            let mut keep = kept.iter();
            simplex.retain(|_| *keep.next().expect("a weight for each corner"));
            let mut keep = kept.iter();
            weights.retain(|_| *keep.next().expect("a weight for each corner"));
            if is_goal {
                break;
            }
        }
    }
}

/// Weights (of any sign, with a positive sum) of one to four points that do not depend on each other, in the point of least norm
/// on the line, plane or space through them: by Cramer's rule from the scalar products of the edges.
fn flat_weights(points: &[Exact3]) -> Vec<Exact> {
    let edges: Vec<Exact3> = points[1..].iter().map(|p| minus(p, &points[0])).collect();
    let products = |column: &dyn Fn(usize, usize) -> Exact| -> Vec<Vec<Exact>> {
        (0..edges.len()).map(|i| (0..edges.len()).map(|j| column(i, j)).collect()).collect()
    };
    let own = |i: usize, j: usize| dot(&edges[i], &edges[j]);
    let down = |i: usize| dot(&edges[i], &minus(&exact3(&Vector::zeros()), &points[0]));
    let whole = determinant(&products(&own));
    let others: Vec<Exact> =
        (0..edges.len()).map(|k| determinant(&products(&|i, j| if j == k { down(i) } else { own(i, j) }))).collect();
    let first = others.iter().fold(whole, |rest, other| rest - other);
    std::iter::once(first).chain(others).collect()
}

fn determinant(rows: &[Vec<Exact>]) -> Exact {
    let minor = |i: usize, j: usize, k: usize, l: usize| &rows[i][k] * &rows[j][l] - &rows[i][l] * &rows[j][k];
    match rows.len() {
        0 => exact(1.0),
        1 => rows[0][0].clone(),
        2 => minor(0, 1, 0, 1),
        _ => &rows[0][0] * minor(1, 2, 1, 2) - &rows[0][1] * minor(1, 2, 0, 2) + &rows[0][2] * minor(1, 2, 0, 1),
    }
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
    fn distance_of_cubes_is_exact() {
        assert!((distance(&cube(0.0, 1.0), &cube(2.0, 1.0)) - 3f64.sqrt()).abs() < 1e-14);
        assert!(distance(&cube(0.0, 1.0), &cube(0.3, 0.2)) < 1e-14);
        let needle = [Vector::new(0.5, 0.5, 1.25), Vector::new(9.0, 9.0, 9.0)];
        assert!((distance(&cube(0.0, 1.0), &needle) - 0.25).abs() < 1e-14);
    }

    /// A plate of a micrometre beside a needle that hardly misses it: the guess stalls on its way.
    #[test]
    fn distance_of_needles_and_thin_plates_is_exact() {
        let mut state = 1u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let mut stalled = 0;
        for _ in 0..300 {
            let half = Vector::new(10f64.powf(-6.0 + 3.0 * random()), 10f64.powf(-6.0 + 3.0 * random()), 0.5);
            let turn = nalgebra::Rotation3::from_euler_angles(6.0 * random(), 6.0 * random(), 6.0 * random());
            let center = Vector::new(1.0 + random(), 1.0 + random(), 1.0 + random());
            let corner = |k: usize| Vector::from_fn(|axis, _| half[axis] * if k >> axis & 1 == 1 { 1.0 } else { -1.0 });
            let plate: Vec<Vector> = (0..8).map(|k| center + turn * corner(k)).collect();
            let aim = plate[0] + (plate[4] - plate[0]) * random() + Vector::repeat(1e-8 * random());
            let needle = [Vector::zeros(), aim * (1.0 + random())];
            let found = distance(&needle, &plate);
            let exactly = |points: &[Vector]| points.iter().map(exact3).collect::<Vec<_>>();
            let (square, whole) = squared_distance(&exactly(&needle), &exactly(&plate));
            let exact_distance = square.over(&(&whole * &whole)).sqrt();
            assert!((found - exact_distance).abs() <= 1e-13, "{found} {exact_distance}");
            let guess = between([&needle, &plate], &nearest(&needle, &plate)).norm();
            stalled += usize::from(guess > exact_distance + 1e-13);
        }
        assert!(stalled > 0, "no case needs the exact search");
    }

    #[test]
    fn numbers_beyond_all_bounds_end() {
        for huge in [1e308, f64::INFINITY, f64::NAN, 5e-324] {
            let [a, b] = nearest(&cube(huge, huge), &cube(0.0, 1.0));
            assert_eq!((a.len(), b.len()), (8, 8));
        }
    }
}
