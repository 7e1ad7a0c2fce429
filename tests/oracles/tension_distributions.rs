//! The choices of tensions against Clarabel's cone programs, optimality conditions, hand-worked examples and each other.

use cdpr_core::geometry::Point;
use cdpr_core::model::Distribution;
use cdpr_core::wrench::{Balance, CapacityMargin, Required, Statics, TensionQp};
use cdpr_tests::{built_scene, rng, uniform};

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};
use nalgebra::{DMatrix, DVector, Matrix6xX, Vector6};
use rand::RngExt;

use super::wrench_solvers::{assert_balances, drawn, greatest, robots};

const BUILT: [&str; 5] = ["cogiro", "ipanema2", "caroca", "acrobot", "mpi_simulator"];

const OPTIMAL: [(Distribution, i32); 4] =
    [(Distribution::Middle, 2), (Distribution::Least, 2), (Distribution::P4, 4), (Distribution::P8, 8)];

fn reference(chosen: Distribution, limits: &[[f64; 2]]) -> DVector<f64> {
    let of_all = if chosen == Distribution::Least { 0.0 } else { 0.5 };
    DVector::from_iterator(limits.len(), limits.iter().map(|[lo, hi]| of_all * (lo + hi)))
}

/// The p-norm of the deviations from the reference, N.
fn norm(t: &DVector<f64>, reference: &DVector<f64>, p: i32) -> f64 {
    let scale = (t - reference).amax();
    if scale == 0.0 { 0.0 } else { scale * (t - reference).map(|x| (x / scale).powi(p)).sum().powf(1.0 / f64::from(p)) }
}

/// The smallest p-norm by Clarabel: for p = 2 a quadratic program, else with cones `z ≥ x²` (and `v ≥ z²`) of second order.
/// `None` if Clarabel does not reach its tolerances.
fn by_clarabel(
    w: &Matrix6xX<f64>,
    limits: &[[f64; 2]],
    wrench: &Vector6<f64>,
    reference: &DVector<f64>,
    p: i32,
) -> Option<f64> {
    let m = limits.len();
    let unit = limits.iter().fold(0.0_f64, |most, [lo, hi]| most.max((hi - lo) / 2.0)).max(1e-9);
    let layers = [2, 4, 8].iter().position(|q| *q == p).expect("a power of two");
    let columns = m * (layers + 1);
    let (mut rows, mut bounds): (Vec<Vec<f64>>, Vec<f64>) = Default::default();
    let mut row = |entries: &[(usize, f64)], bound: f64| {
        let mut row = vec![0.0; columns];
        entries.iter().for_each(|(j, value)| row[*j] = *value);
        rows.push(row);
        bounds.push(bound);
    };
    let needed = (wrench - w * reference) / unit;
    for i in 0..6 {
        row(&(0..m).map(|j| (j, w[(i, j)])).collect::<Vec<_>>(), needed[i]);
    }
    for (i, [lo, hi]) in limits.iter().enumerate() {
        row(&[(i, 1.0)], (hi - reference[i]) / unit);
        row(&[(i, -1.0)], (reference[i] - lo) / unit);
    }
    let mut cones = vec![SupportedConeT::ZeroConeT(6), SupportedConeT::NonnegativeConeT(2 * m)];
    for k in 0..layers * m {
        row(&[(k + m, -1.0)], 1.0);
        row(&[(k, -2.0)], 0.0);
        row(&[(k + m, -1.0)], -1.0);
        cones.push(SupportedConeT::SecondOrderConeT(3));
    }
    let dense = |matrix: DMatrix<f64>| {
        let starts = (0..=matrix.ncols()).map(|j| j * matrix.nrows()).collect();
        let places = (0..matrix.ncols()).flat_map(|_| 0..matrix.nrows()).collect();
        CscMatrix::new(matrix.nrows(), matrix.ncols(), starts, places, matrix.as_slice().to_vec())
    };
    let last = columns - m;
    let hessian = CscMatrix::new(
        columns,
        columns,
        (0..=columns).map(|j| j.saturating_sub(last)).collect(),
        (last..columns).collect(),
        vec![2.0; m],
    );
    let matrix = dense(DMatrix::from_fn(rows.len(), columns, |i, j| rows[i][j]));
    let settings = DefaultSettings {
        verbose: false,
        tol_gap_abs: 1e-12,
        tol_gap_rel: 1e-11,
        tol_feas: 1e-11,
        direct_solve_method: "qdldl".into(),
        ..DefaultSettings::default()
    };
    let mut solver = DefaultSolver::new(&hessian, &vec![0.0; columns], &matrix, &bounds, &cones, settings).ok()?;
    solver.solve();
    let solved = solver.solution.status == SolverStatus::Solved;
    solved.then(|| unit * solver.solution.obj_val.max(0.0).powf(1.0 / f64::from(p)))
}

/// A proof, by duality, of how far the sum of powers at t can be above the least one, as a share of it: for multipliers λ of the
/// balance, Σ gᵢ (tᵢ − sᵢ) is at most Σ max over sᵢ of (g − Wᵀ λ)ᵢ (tᵢ − sᵢ). λ makes this zero at tensions inside their limits.
fn optimality_gap(w: &Matrix6xX<f64>, limits: &[[f64; 2]], t: &DVector<f64>, reference: &DVector<f64>, p: i32) -> f64 {
    let scale = (t - reference).amax();
    if scale == 0.0 {
        return 0.0;
    }
    let x = (t - reference) / scale;
    let gradient = x.map(|x| f64::from(p) * x.powi(p - 1));
    let inside: Vec<usize> = (0..t.len()).filter(|i| limits[*i][0] < t[*i] && t[*i] < limits[*i][1]).collect();
    let columns = Matrix6xX::from_fn(inside.len(), |i, j| w[(i, inside[j])]);
    let wanted = DVector::from_iterator(inside.len(), inside.iter().map(|i| gradient[*i]));
    let rows = DMatrix::from_iterator(6, inside.len(), columns.iter().copied()).transpose();
    let multipliers =
        if inside.is_empty() { DVector::zeros(6) } else { rows.svd(true, true).solve(&wanted, 1e-9).unwrap() };
    let left = &gradient - w.tr_mul(&Vector6::from_iterator(multipliers.iter().copied()));
    let gap = |i: usize| {
        let to = |s: f64| left[i] * (t[i] - s) / scale;
        to(limits[i][0]).max(to(limits[i][1]))
    };
    (0..t.len()).map(gap).sum::<f64>() / x.map(|x| x.powi(p)).sum()
}

#[test]
fn each_distribution_is_least_by_duality_and_by_clarabel() {
    let mut qp = TensionQp::default();
    let (mut asked, mut compared, mut proved, mut worst) = (0, 0, 0, [0.0_f64; 2]);
    robots(|rng, w, mut limits| {
        if rng.random_range(0..4) == 0 {
            let given = rng.random_range(0..limits.len());
            limits[given][1] = limits[given][0]; // a tension that is given
        }
        let middle = reference(Distribution::Middle, &limits);
        let wrench = &w * (&middle + (drawn(rng, &limits) - &middle) * 1.2);
        let exists = qp.solve(&w, &limits, &wrench, None).unwrap();
        for (chosen, p) in OPTIMAL {
            asked += 1;
            let found = qp.distribute(chosen, &w, &limits, &wrench).unwrap();
            if exists == Balance::Infeasible {
                assert_eq!(found, Balance::Infeasible, "{chosen:?}");
                continue;
            }
            let t = assert_balances(&w, &limits, &wrench, &found);
            let about = reference(chosen, &limits);
            let own = norm(&t, &about, p);
            let gap = optimality_gap(&w, &limits, &t, &about, p);
            proved += usize::from(gap < 1e-9);
            if let Some(least) = by_clarabel(&w, &limits, &wrench, &about, p) {
                compared += 1;
                // Clarabel's answer may miss limits and balance by its tolerance.
                let more = (own - least) / greatest(&limits);
                worst = [worst[0].max(more), worst[1].max(-more)];
                assert!(more.abs() <= 1e-5 && more <= 1e-6, "{chosen:?}: {own} {least}, gap {gap:e}");
            }
        }
    });
    println!("{asked} asked, {compared} compared with Clarabel, {proved} proved by duality; above and below {worst:?}");
}

#[test]
fn the_closed_form_is_that_of_a_hand_worked_example_and_the_middle_where_it_keeps_the_limits() {
    // One cable to the right, two to the left: t = m + (w − Σ ±m) / 3 (1, −1, −1), with m = (55, 55, 15).
    let mut w = Matrix6xX::zeros(3);
    (w[(0, 0)], w[(0, 1)], w[(0, 2)]) = (1.0, -1.0, -1.0);
    let limits = [[10.0, 100.0], [10.0, 100.0], [10.0, 20.0]];
    let mut qp = TensionQp::default();
    let mut found = |chosen, force: f64| qp.distribute(chosen, &w, &limits, &(Vector6::x() * force)).unwrap();
    let near = |found: Balance, expected: [f64; 3]| {
        let t = found.tensions().unwrap().clone();
        assert!((&t - DVector::from_row_slice(&expected)).amax() < 1e-9, "{t}");
    };
    near(found(Distribution::ClosedForm, -3.0), [59.0, 51.0, 11.0]);
    assert_eq!(found(Distribution::ClosedForm, 3.0), Balance::Infeasible); // (61, 49, 9)
    near(found(Distribution::Middle, 3.0), [61.5, 48.5, 10.0]);
    near(found(Distribution::Least, 3.0), [23.0, 10.0, 10.0]);
    // Deviations x, −x' and −5 with x + x' = 13: the fourth powers are least for equal ones.
    near(found(Distribution::P4, 3.0), [61.5, 48.5, 10.0]);

    let (mut within, mut beyond) = (0, 0);
    robots(|rng, w, limits| {
        let wrench = &w * drawn(rng, &limits);
        let middle = qp.distribute(Distribution::Middle, &w, &limits, &wrench).unwrap();
        match qp.distribute(Distribution::ClosedForm, &w, &limits, &wrench).unwrap() {
            Balance::Infeasible => beyond += 1,
            found => {
                assert_eq!(found, middle);
                within += 1;
            }
        }
    });
    assert!(within > 100 && beyond > 50, "{within} {beyond}");
}

#[test]
fn given_tensions_huge_limits_and_sets_of_one_point_have_tensions() {
    let mut qp = TensionQp::default();
    robots(|rng, w, limits| {
        // All tensions given; the largest wrench along a direction, whose tensions are at their limits.
        let given: Vec<[f64; 2]> = limits.iter().map(|[lo, _]| [*lo; 2]).collect();
        let corner = DVector::from_fn(limits.len(), |i, _| limits[i][rng.random_range(0..2)]);
        let huge: Vec<[f64; 2]> = limits.iter().map(|[lo, _]| [*lo, 9_999_999.0]).collect();
        let inside = drawn(rng, &limits);
        for (chosen, _) in OPTIMAL {
            let mut balanced = |limits: &[[f64; 2]], t: &DVector<f64>| {
                let wrench = &w * t;
                assert_balances(&w, limits, &wrench, &qp.distribute(chosen, &w, limits, &wrench).unwrap())
            };
            let lower = DVector::from_iterator(limits.len(), limits.iter().map(|[lo, _]| *lo));
            assert_eq!(balanced(&given, &lower), lower);
            balanced(&limits, &corner);
            let t = balanced(&huge, &inside);
            assert!(chosen != Distribution::Least || t.norm() <= inside.norm() + 1e-2);
        }
    });
}

/// Wherever tensions inside the limits balance the loads, no distribution jumps: in a sixteenth of the step, tensions change by
/// less than a fifth as much, also where cables reach or leave limits.
#[test]
fn tensions_are_continuous_along_lines_with_a_margin() {
    let mut qp = TensionQp::default();
    let (mut lines, mut switches) = (0, 0);
    for name in BUILT {
        let scene = built_scene(name);
        let statics = Statics::of(&scene).unwrap();
        let margin = CapacityMargin::new(statics.clone(), Required::default()).unwrap();
        let (min, max) = (scene.workspace().min, scene.workspace().max);
        let mut rng = rng(7);
        let mut of_robot = 0;
        for _ in 0..400 {
            let mut place = || Point::from(min + (max - min).map(|side| side * uniform(&mut rng, 0.0, 1.0)));
            let (from, to) = (place(), place());
            let least = 1e-3 * statics.largest_tension();
            let at = |share: f64| from + (to - from) * share;
            if of_robot == 12 || !(0..=50).all(|k| margin.at(&at(f64::from(k) / 50.0)) > least) {
                continue;
            }
            of_robot += 1;
            for (chosen, _) in OPTIMAL {
                let chosen = statics.with_tensions(chosen);
                let mut largest_step = |steps: usize| {
                    let mut before: Option<Vec<f64>> = None;
                    let mut largest = 0.0_f64;
                    for k in 0..=steps {
                        let t =
                            chosen.tensions(&mut qp, &at(k as f64 / steps as f64), None).unwrap().expect("a margin");
                        let limits = chosen.limits();
                        let free =
                            |t: &[f64]| t.iter().zip(&limits).map(|(t, [lo, hi])| lo < t && t < hi).collect::<Vec<_>>();
                        if let Some(before) = &before {
                            largest = before.iter().zip(&t).fold(largest, |most, (a, b)| most.max((a - b).abs()));
                            switches += usize::from(free(before) != free(&t));
                        }
                        before = Some(t);
                    }
                    largest
                };
                let (coarse, fine) = (largest_step(100), largest_step(1600));
                let rounding = 1e-6 * statics.largest_tension();
                assert!(fine <= 0.2 * coarse + rounding, "{name} {:?}: {coarse} N, {fine} N", chosen.distribution());
            }
        }
        lines += of_robot;
        println!("{name}: {of_robot} lines");
    }
    assert!(lines > 30 && switches > 100, "{lines} lines, {switches} changes of the active set");
}

/// Why the improved closed form is not offered: at a wrench where two cables exceed their limits by the same amount, its tensions
/// jump, and those nearest to the middle do not.
#[test]
#[ignore = "takes long; `make long-test` runs it"]
fn the_improved_closed_form_jumps() {
    let mut qp = TensionQp::default();
    let (mut jumps, mut largest) = (0, 0.0_f64);
    robots(|rng, w, limits| {
        if w.ncols() < 8 || jumps == 1 {
            return;
        }
        let (from, to) = (&w * drawn(rng, &limits), &w * drawn(rng, &limits));
        let at = |share: f64| from + (to - from) * share;
        let apart = |[a, b]: [f64; 2], by: &mut dyn FnMut(f64) -> Option<DVector<f64>>| Some((by(a)? - by(b)?).amax());
        let mut improved = |share: f64| improved_closed_form(&w, &limits, &at(share));
        let mut before = f64::INFINITY;
        for k in 0..500 {
            let mut pair = [k, k + 1].map(|k| f64::from(k) / 500.0);
            let step = apart(pair, &mut improved).unwrap_or(f64::INFINITY);
            let jumps_perhaps = step.is_finite() && step > 1.2 * before;
            before = step;
            if !jumps_perhaps {
                continue;
            }
            for _ in 0..36 {
                let middle = 0.5 * (pair[0] + pair[1]);
                let halves = [[pair[0], middle], [middle, pair[1]]];
                let [first, second] = halves.map(|half| apart(half, &mut improved));
                let (Some(first), Some(second)) = (first, second) else { break };
                pair = halves[usize::from(second > first)];
            }
            let Some(jump) = apart(pair, &mut improved).filter(|jump| *jump > 1.0 && pair[1] - pair[0] < 1e-12) else {
                continue;
            };
            let mut nearest = |share| qp.solve(&w, &limits, &at(share), None).unwrap().tensions().cloned();
            assert!(apart(pair, &mut nearest).is_some_and(|step| step < 1e-6));
            (jumps, largest) = (jumps + 1, largest.max(jump));
        }
    });
    println!("{jumps} jumps, the largest of {largest:.1} N");
    assert!(jumps > 0);
}

/// A. Pott, "An improved force distribution algorithm for over-constrained cable-driven parallel robots", Computational
/// Kinematics, 2014: as long as a cable exceeds a limit, the one that does by most is fixed at it.
fn improved_closed_form(w: &Matrix6xX<f64>, limits: &[[f64; 2]], wrench: &Vector6<f64>) -> Option<DVector<f64>> {
    let mut t = DVector::from_iterator(limits.len(), limits.iter().map(|[lo, hi]| 0.5 * (lo + hi)));
    let mut free: Vec<usize> = (0..limits.len()).collect();
    while free.len() >= 6 {
        let columns = DMatrix::from_fn(6, free.len(), |i, j| w[(i, free[j])]);
        let change =
            columns.svd(true, true).solve(&DVector::from_iterator(6, (wrench - w * &t).iter().copied()), 1e-12).ok()?;
        let mut found = t.clone();
        free.iter().zip(&change).for_each(|(&i, change)| found[i] += change);
        if (w * &found - wrench).norm() > 1e-6 * wrench.norm() {
            return None;
        }
        let by = |i: usize| (limits[i][0] - found[i]).max(found[i] - limits[i][1]);
        let worst = (0..free.len()).max_by(|a, b| by(free[*a]).total_cmp(&by(free[*b]))).unwrap();
        if by(free[worst]) <= 0.0 {
            return Some(found);
        }
        let fixed = free.remove(worst);
        t[fixed] = found[fixed].clamp(limits[fixed][0], limits[fixed][1]);
    }
    None
}
