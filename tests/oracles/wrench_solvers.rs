//! The wrench solvers against planted answers, optimality conditions and each other, on random and degenerate robots.

use cdpr_core::Error;
use cdpr_core::tolerances::BALANCE_RELATIVE;
use cdpr_core::wrench::{Balance, FeasibilityLp, LargestScale, QpMethod, ScaleLp, TensionQp};
use cdpr_tests::{direction, rng, uniform, vector};
use nalgebra::{DVector, Matrix6xX, Vector6};
use rand::{Rng, RngExt};

const ROBOTS: u64 = 150;

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Plain,
    /// All attachments in one point: no moments.
    PointMass,
    /// Rank 5: one row is a mixture of two others.
    Deficient,
    /// All cables in pairs side by side.
    Doubled,
}

fn robot(rng: &mut impl Rng, cables: usize, kind: Kind) -> (Matrix6xX<f64>, Vec<[f64; 2]>) {
    let column = |rng: &mut _| {
        let (unit, arm) = (direction(rng), if kind == Kind::PointMass { vector(rng, 0.0) } else { vector(rng, 0.5) });
        let moment = arm.cross(&unit);
        Vector6::new(unit.x, unit.y, unit.z, moment.x, moment.y, moment.z)
    };
    let mut columns: Vec<Vector6<f64>> = (0..cables).map(|_| column(rng)).collect();
    for i in 0..cables {
        match kind {
            Kind::Deficient => columns[i][5] = 0.3 * columns[i][3] - 0.7 * columns[i][1],
            Kind::Doubled if i % 2 == 1 => columns[i] = columns[i - 1],
            _ => {}
        }
    }
    let limits = (0..cables).map(|_| {
        let lo = uniform(rng, 0.0, 50.0);
        [lo, lo + uniform(rng, 10.0, 1000.0)]
    });
    (Matrix6xX::from_columns(&columns), limits.collect())
}

pub fn robots(mut each: impl FnMut(&mut rand_chacha::ChaCha8Rng, Matrix6xX<f64>, Vec<[f64; 2]>)) {
    for seed in 0..ROBOTS {
        for kind in [Kind::Plain, Kind::PointMass, Kind::Deficient, Kind::Doubled] {
            let mut rng = rng(seed);
            let cables = rng.random_range(1..=16);
            let (w, limits) = robot(&mut rng, cables, kind);
            each(&mut rng, w, limits);
        }
    }
}

pub fn drawn(rng: &mut impl Rng, limits: &[[f64; 2]]) -> DVector<f64> {
    DVector::from_iterator(limits.len(), limits.iter().map(|[lo, hi]| uniform(rng, *lo, *hi)))
}

/// Tensions, some at their limits, that give the wrench of the available set farthest along `c`, and that wrench.
fn farthest(w: &Matrix6xX<f64>, limits: &[[f64; 2]], c: &Vector6<f64>) -> (DVector<f64>, Vector6<f64>) {
    let along = w.tr_mul(c);
    let t = DVector::from_fn(limits.len(), |i, _| limits[i][usize::from(along[i] > 0.0)]);
    let wrench = w * &t;
    (t, wrench)
}

fn some_direction(rng: &mut impl Rng) -> Vector6<f64> {
    Vector6::from_fn(|_, _| uniform(rng, -1.0, 1.0)).normalize()
}

pub fn greatest(limits: &[[f64; 2]]) -> f64 {
    limits.iter().map(|l| l[1]).fold(0.0, f64::max)
}

#[track_caller]
pub fn assert_balances(
    w: &Matrix6xX<f64>,
    limits: &[[f64; 2]],
    wrench: &Vector6<f64>,
    balance: &Balance,
) -> DVector<f64> {
    let Balance::Feasible(t) = balance else { panic!("{balance:?} for a wrench that tensions balance") };
    let scale = wrench.norm().max(greatest(limits));
    assert!((w * t - wrench).norm() <= BALANCE_RELATIVE * scale, "off by {:e}", (w * t - wrench).norm() / scale);
    assert!(t.iter().zip(limits).all(|(t, [lo, hi])| lo <= t && t <= hi));
    t.clone()
}

struct Solvers {
    lp: FeasibilityLp,
    qps: [TensionQp; 2],
}

impl Solvers {
    fn new() -> Self {
        Self { lp: FeasibilityLp::new(), qps: [QpMethod::ActiveSet, QpMethod::InteriorPoint].map(TensionQp::new) }
    }

    fn all(&mut self, w: &Matrix6xX<f64>, limits: &[[f64; 2]], wrench: &Vector6<f64>) -> [Balance; 3] {
        let [a, b] = &mut self.qps;
        let qp = |qp: &mut TensionQp| qp.solve(w, limits, wrench, None).expect("sound");
        [self.lp.solve(w, limits, wrench).expect("sound"), qp(a), qp(b)]
    }
}

#[test]
fn wrenches_of_tensions_inside_are_balanced() {
    let mut solvers = Solvers::new();
    robots(|rng, w, limits| {
        let wrench = &w * drawn(rng, &limits);
        for balance in solvers.all(&w, &limits, &wrench) {
            assert_balances(&w, &limits, &wrench, &balance);
        }
    });
}

#[test]
fn wrenches_on_the_boundary_are_balanced() {
    let mut solvers = Solvers::new();
    robots(|rng, w, limits| {
        let (mut t, _) = farthest(&w, &limits, &some_direction(rng));
        if rng.random() {
            let free = rng.random_range(0..limits.len()); // inside an edge rather than at a corner
            t[free] = uniform(rng, limits[free][0], limits[free][1]);
        }
        let wrench = &w * t;
        for balance in solvers.all(&w, &limits, &wrench) {
            assert_balances(&w, &limits, &wrench, &balance);
        }
    });
}

#[test]
fn wrenches_beyond_a_supporting_plane_are_not() {
    let mut solvers = Solvers::new();
    for by in [1e-6, 1e-3, 1.0, 1e6] {
        robots(|rng, w, limits| {
            let c = some_direction(rng);
            let (_, wrench) = farthest(&w, &limits, &c);
            let wrench = wrench + c * by * greatest(&limits);
            let balances = solvers.all(&w, &limits, &wrench);
            assert!(balances.iter().all(|b| *b == Balance::Infeasible), "{by:e} beyond: {balances:?}");
        });
    }
}

#[test]
fn every_wrench_is_decided_and_alike() {
    let mut solvers = Solvers::new();
    let (mut yes, mut no) = (0, 0);
    robots(|rng, w, limits| {
        for _ in 0..5 {
            let middle = DVector::from_iterator(limits.len(), limits.iter().map(|[lo, hi]| 0.5 * (lo + hi)));
            let wrench = &w * (&middle + (drawn(rng, &limits) - &middle) * 1.4);
            let balances = solvers.all(&w, &limits, &wrench);
            let feasible = balances.each_ref().map(|b| b.tensions().is_some());
            assert!(!balances.contains(&Balance::Undecided) && feasible.iter().all(|f| *f == feasible[0]));
            if feasible[0] { yes += 1 } else { no += 1 }
        }
    });
    assert!(yes > 500 && no > 500, "{yes} feasible, {no} not");
}

/// Stationarity, signs and complementarity, without the solver's own multipliers: t − ref must be Wᵀλ plus outward
/// pulls of active limits, so its part on free cables must come from λ alone.
fn assert_nearest(w: &Matrix6xX<f64>, limits: &[[f64; 2]], reference: &DVector<f64>, t: &DVector<f64>) {
    let gradient = t - reference;
    let scale = greatest(limits);
    let at = |i: usize, side: usize| (t[i] - limits[i][side]).abs() <= 1e-9 * scale;
    // Among directions that keep the wrench and point inside, none descends: coordinate pairs are not enough for six
    // rows, so project the descent onto that cone by Dykstra's alternating projections.
    let range = w.clone().svd(true, true);
    let rank = range.singular_values.iter().filter(|s| **s > 1e-9 * range.singular_values.max()).count();
    let rows = range.v_t.expect("asked for").rows(0, rank).into_owned();
    let mut d = -&gradient;
    let mut kept = DVector::zeros(d.len());
    for _ in 0..200_000 {
        if (&rows * &d).norm() + d.norm() <= 1e-4 * scale {
            break; // convergence is slow where limits are nearly parallel
        }
        d -= rows.tr_mul(&(&rows * &d));
        let before = &d + &kept;
        d = DVector::from_fn(d.len(), |i, _| {
            let (low, high) = (at(i, 0), at(i, 1));
            before[i].clamp(if low { 0.0 } else { f64::MIN }, if high { 0.0 } else { f64::MAX })
        });
        kept = before - &d;
    }
    d -= rows.tr_mul(&(&rows * &d));
    assert!(d.norm() <= 1e-3 * scale, "descends by {:e}", d.norm() / scale);
}

#[test]
fn tensions_are_the_nearest_to_their_reference() {
    let mut solvers = Solvers::new();
    robots(|rng, w, limits| {
        if w.ncols() > 10 {
            return; // the projections converge slowly
        }
        let (wrench, reference) = (&w * drawn(rng, &limits), drawn(rng, &limits) * 1.5);
        let [a, b] = &mut solvers.qps;
        let ask = |qp: &mut TensionQp| {
            let balance = qp.solve(&w, &limits, &wrench, Some(reference.as_slice())).expect("sound");
            assert_balances(&w, &limits, &wrench, &balance)
        };
        let (one, other) = (ask(a), ask(b));
        assert!((&one - other).norm() <= 1e-8 * greatest(&limits), "the methods differ");
        assert_nearest(&w, &limits, &reference, &one);
        for _ in 0..20 {
            // No other balancing tensions are closer: t* is the projection, so (ref − t*)·(t − t*) <= 0.
            let other = DVector::from_fn(one.len(), |i, _| uniform(rng, limits[i][0], limits[i][1]));
            let elsewhere = ask_for(&w, &limits, &wrench, &other);
            assert!((&reference - &one).dot(&(elsewhere - &one)) <= 1e-7 * greatest(&limits).powi(2));
        }
    });
}

fn ask_for(w: &Matrix6xX<f64>, limits: &[[f64; 2]], wrench: &Vector6<f64>, reference: &DVector<f64>) -> DVector<f64> {
    let balance = TensionQp::default().solve(w, limits, wrench, Some(reference.as_slice())).expect("sound");
    assert_balances(w, limits, wrench, &balance)
}

#[test]
fn tensions_move_continuously_along_a_line_of_wrenches() {
    let mut qp = TensionQp::default();
    for seed in 0..40 {
        let mut rng = rng(seed);
        let (w, limits) = robot(&mut rng, 8, Kind::Plain);
        let (from, to) = (&w * drawn(&mut rng, &limits), &w * drawn(&mut rng, &limits));
        let mut largest = [0.0_f64; 2];
        for (level, steps) in [500, 5000].into_iter().enumerate() {
            let mut before: Option<DVector<f64>> = None;
            for k in 0..=steps {
                let wrench = from.lerp(&to, k as f64 / steps as f64);
                let balance = qp.solve(&w, &limits, &wrench, None).expect("sound");
                let t = assert_balances(&w, &limits, &wrench, &balance);
                largest[level] = largest[level].max(before.map_or(0.0, |b| (&t - b).norm()));
                before = Some(t);
            }
        }
        // Piecewise linear: a tenth except for pieces shorter than a step.
        assert!(largest[1] <= 0.5 * largest[0], "a tenth of the step moves {largest:?} N");
    }
}

#[test]
fn the_largest_scale_is_that_of_a_bisection() {
    let (mut scale, mut lp) = (ScaleLp::new(), FeasibilityLp::new());
    robots(|rng, w, limits| {
        let centre = &w * drawn(rng, &limits);
        let corners: Vec<_> =
            (0..4).map(|_| &w * DVector::from_fn(limits.len(), |_, _| uniform(rng, -1.0, 1.0))).collect();
        let LargestScale::Bounded(s) = scale.solve(&w, &limits, &centre, &corners).expect("sound") else {
            panic!("{:?}", scale.solve(&w, &limits, &centre, &corners))
        };
        let mut all = |s: f64| {
            corners.iter().all(|v| lp.solve(&w, &limits, &(centre + v * s)).expect("sound").tensions().is_some())
        };
        let (mut lo, mut hi) = (0.0, 1e5);
        for _ in 0..60 {
            let middle = 0.5 * (lo + hi);
            if all(middle) { lo = middle } else { hi = middle }
        }
        assert!((s - lo).abs() <= 1e-7 * greatest(&limits), "{s} but {lo} by bisection");
    });
}

#[test]
fn unbounded_and_infeasible_scales_are_distinguished() {
    let mut rng = rng(1);
    let (w, limits) = robot(&mut rng, 8, Kind::Plain);
    let centre = &w * drawn(&mut rng, &limits);
    let mut lp = ScaleLp::new();
    let mut ask =
        |centre: &Vector6<f64>, corners: &[Vector6<f64>]| lp.solve(&w, &limits, centre, corners).expect("sound");
    assert_eq!(ask(&centre, &[Vector6::zeros(); 3]), LargestScale::Unbounded);
    let c = some_direction(&mut rng);
    let (_, edge) = farthest(&w, &limits, &c);
    assert_eq!(ask(&(edge + c), &[c]), LargestScale::Infeasible);
    assert_eq!(ask(&(edge + c), &[Vector6::zeros()]), LargestScale::Infeasible);
    assert!(matches!(ask(&edge, &[c]), LargestScale::Bounded(s) if s < 1e-6)); // on the boundary and outward
    let (w, limits) = robot(&mut rng, 8, Kind::PointMass);
    let centre = &w * drawn(&mut rng, &limits);
    assert_eq!(lp.solve(&w, &limits, &centre, &[Vector6::ith(4, 1.0)]).expect("sound"), LargestScale::Bounded(0.0));
}

#[test]
fn a_moment_on_a_point_mass_is_never_balanced() {
    let mut solvers = Solvers::new();
    for seed in 0..50 {
        let mut rng = rng(seed);
        let (w, limits) = robot(&mut rng, 6, Kind::PointMass);
        let wrench = &w * drawn(&mut rng, &limits) + Vector6::ith(3, 1e-3 * greatest(&limits));
        assert!(solvers.all(&w, &limits, &wrench).iter().all(|b| *b == Balance::Infeasible));
    }
}

#[test]
fn given_tensions_are_kept() {
    let mut solvers = Solvers::new();
    for seed in 0..50 {
        let mut rng = rng(seed);
        let (w, mut limits) = robot(&mut rng, 9, Kind::Plain);
        limits[2][1] = limits[2][0];
        limits[7][0] = limits[7][1];
        let wrench = &w * drawn(&mut rng, &limits);
        for balance in solvers.all(&w, &limits, &wrench) {
            let t = assert_balances(&w, &limits, &wrench, &balance);
            assert_eq!((t[2], t[7]), (limits[2][0], limits[7][0]));
        }
        let all_given: Vec<_> = limits.iter().map(|[lo, _]| [*lo, *lo]).collect();
        let wrench = &w * DVector::from_iterator(9, limits.iter().map(|l| l[0]));
        assert!(solvers.all(&w, &all_given, &wrench).iter().all(|b| b.tensions().is_some()));
        let balances = solvers.all(&w, &all_given, &(wrench + Vector6::y()));
        assert!(balances.iter().all(|b| *b == Balance::Infeasible), "{balances:?}");
    }
}

#[test]
fn no_forces_at_all_need_no_more_than_a_zero_matrix() {
    let mut solvers = Solvers::new();
    let (w, limits) = (Matrix6xX::zeros(3), [[1.0, 2.0]; 3]);
    assert!(solvers.all(&w, &limits, &Vector6::zeros()).iter().all(|b| b.tensions().is_some()));
    assert!(solvers.all(&w, &limits, &Vector6::x()).iter().all(|b| *b == Balance::Infeasible));
}

#[test]
fn numbers_of_any_size_have_an_answer() {
    let mut solvers = Solvers::new();
    robots(|rng, w, limits| {
        for size in [1e-90, 1e-9, 1e9, 1e90] {
            let sized: Vec<_> = limits.iter().map(|[lo, hi]| [lo * size, hi * size]).collect();
            let wrench = &w * drawn(rng, &sized);
            for balance in solvers.all(&w, &sized, &wrench) {
                assert_balances(&w, &sized, &wrench, &balance);
            }
            let (_, edge) = farthest(&w, &sized, &Vector6::x());
            let balances = solvers.all(&w, &sized, &(edge + Vector6::x() * greatest(&sized)));
            assert!(balances.iter().all(|b| *b == Balance::Infeasible), "{size:e}: {balances:?}");
        }
    });
}

#[test]
fn ill_posed_questions_name_the_argument() {
    let w = Matrix6xX::from_element(2, 0.5);
    let (limits, zero, nan) = ([[0.0, 1.0]; 2], Vector6::zeros(), Vector6::repeat(f64::NAN));
    let named = |answer: Result<Balance, Error>, start: &str| {
        let text = answer.expect_err("ill-posed").to_string();
        assert!(text.starts_with(start), "{text}");
    };
    let mut lp = FeasibilityLp::new();
    named(lp.solve(&Matrix6xX::zeros(0), &[], &zero), "wrench_matrix: has no columns");
    named(lp.solve(&(&w * f64::INFINITY), &limits, &zero), "wrench_matrix: contains inf");
    named(lp.solve(&w, &limits[..1], &zero), "limits: has 1 pairs");
    named(lp.solve(&w, &[[0.0, 1.0], [0.0, f64::NAN]], &zero), "limits[1]: contains NaN");
    named(lp.solve(&w, &[[0.0, 1.0], [2.0, 1.0]], &zero), "limits[1]: found t_min = 2 above t_max = 1");
    named(lp.solve(&w, &limits, &nan), "wrench: contains NaN");
    named(lp.solve(&w, &limits, &Vector6::repeat(1e200)), "wrench: contains 1e200");
    let mut qp = TensionQp::default();
    named(qp.solve(&w, &limits, &nan, None), "wrench: contains NaN");
    named(qp.solve(&w, &limits, &zero, Some(&[0.5])), "reference: has 1 tensions");
    named(qp.solve(&w, &limits, &zero, Some(&[0.5, f64::NAN])), "reference: contains NaN");
    let mut scale = ScaleLp::new();
    let mut corner = |centre, corners: &[_]| scale.solve(&w, &limits, centre, corners).map(|_| Balance::Undecided);
    named(corner(&zero, &[]), "corners: is empty");
    named(corner(&zero, &[zero, nan]), "corners[1]: contains NaN");
    named(corner(&nan, &[zero]), "centre: contains NaN");
}

#[test]
fn solvers_may_move_between_threads() {
    fn assert_send<T: Send>() {}
    assert_send::<FeasibilityLp>();
    assert_send::<ScaleLp>();
    assert_send::<TensionQp>();
}
