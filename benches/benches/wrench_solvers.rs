//! Time of one wrench query on a reused solver: random robots, with a different wrench matrix for each query.

use cdpr_core::Choice;
use cdpr_core::model::Distribution;
use cdpr_core::wrench::{FeasibilityLp, QpMethod, ScaleLp, TensionQp};
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main, measurement::WallTime};
use nalgebra::{DVector, Matrix6xX, Vector3, Vector6};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const QUESTIONS: usize = 500;
const LIMITS: [f64; 2] = [10.0, 1000.0];

struct Question {
    wrench_matrix: Matrix6xX<f64>,
    limits: Vec<[f64; 2]>,
    wrench: Vector6<f64>,
}

/// Wrenches of random tensions within limits that are widened by `reach` about their middle; with `hard`, only those
/// that neither the least-squares tensions nor the plane across them decide.
fn questions(cables: usize, reach: f64, hard: bool) -> Vec<Question> {
    let mut rng = ChaCha8Rng::seed_from_u64(cables as u64);
    let mut draw = move |half: f64| half * (2.0 * rng.random::<f64>() - 1.0);
    let mut questions = Vec::with_capacity(QUESTIONS);
    while questions.len() < QUESTIONS {
        let columns: Vec<_> = (0..cables).map(|_| column(&mut draw)).collect();
        let wrench_matrix = Matrix6xX::from_columns(&columns);
        let (middle, half) = (0.5 * (LIMITS[0] + LIMITS[1]), 0.5 * (LIMITS[1] - LIMITS[0]));
        let x = DVector::from_fn(cables, |_, _| draw(reach));
        if hard && easy(&wrench_matrix, &x) {
            continue;
        }
        let wrench = &wrench_matrix * x.map(|x| middle + half * x);
        questions.push(Question { wrench_matrix, limits: vec![LIMITS; cables], wrench });
    }
    questions
}

fn column(draw: &mut impl FnMut(f64) -> f64) -> Vector6<f64> {
    let mut vector = |half| Vector3::from_fn(|_, _| draw(half));
    let (unit, arm) = (vector(1.0).normalize(), vector(0.5));
    let moment = arm.cross(&unit);
    Vector6::new(unit.x, unit.y, unit.z, moment.x, moment.y, moment.z)
}

fn easy(wrench_matrix: &Matrix6xX<f64>, x: &DVector<f64>) -> bool {
    let inverse = wrench_matrix.clone().pseudo_inverse(1e-9).expect("a positive tolerance");
    let shortest = inverse * (wrench_matrix * x);
    shortest.amax() <= 1.0 || shortest.norm_squared() > shortest.lp_norm(1)
}

fn measure(group: &mut BenchmarkGroup<WallTime>, label: &str, questions: &[Question], mut ask: impl FnMut(&Question)) {
    group.throughput(Throughput::Elements(questions.len() as u64));
    group.bench_function(label, |b| b.iter(|| questions.iter().for_each(&mut ask)));
}

fn wrench_solvers(c: &mut Criterion) {
    let mut group = c.benchmark_group("wrench solvers");
    for cables in [4, 8, 12] {
        for (kind, reach, hard) in [("inside", 1.0, false), ("around", 1.3, false), ("hard", 1.2, true)] {
            let drawn = questions(cables, reach, hard && cables > 6);
            ask_all(&mut group, &format!("{cables} cables, {kind}"), &drawn);
        }
    }
    scale(&mut group, &questions(8, 0.3, false));
}

fn ask_all(group: &mut BenchmarkGroup<WallTime>, kind: &str, questions: &[Question]) {
    let mut lp = FeasibilityLp::new();
    measure(group, &format!("lp, {kind}"), questions, |q| {
        std::hint::black_box(lp.solve(&q.wrench_matrix, &q.limits, &q.wrench).expect("sound"));
    });
    for (name, method) in [("active set", QpMethod::ActiveSet), ("interior point", QpMethod::InteriorPoint)] {
        let mut qp = TensionQp::new(method);
        measure(group, &format!("qp by {name}, {kind}"), questions, |q| {
            std::hint::black_box(qp.solve(&q.wrench_matrix, &q.limits, &q.wrench, None).expect("sound"));
        });
    }
    for (chosen, name, _) in &Distribution::ALL[1..] {
        let mut qp = TensionQp::default();
        measure(group, &format!("{name}, {kind}"), questions, |q| {
            std::hint::black_box(qp.distribute(*chosen, &q.wrench_matrix, &q.limits, &q.wrench).expect("sound"));
        });
    }
}

/// The cube of 64 corners around a wrench.
fn scale(group: &mut BenchmarkGroup<WallTime>, questions: &[Question]) {
    let corner = |k: usize| Vector6::from_fn(|i, _| if k >> i & 1 == 1 { 1.0 } else { -1.0 });
    let corners: Vec<_> = (0..64).map(corner).collect();
    let mut lp = ScaleLp::new();
    for count in [1, 8, 64] {
        measure(group, &format!("scale lp, 8 cables, {count} corners"), questions, |q| {
            let answer = lp.solve(&q.wrench_matrix, &q.limits, &q.wrench, &corners[..count]);
            std::hint::black_box(answer.expect("sound"));
        });
    }
}

criterion_group!(benches, wrench_solvers);
criterion_main!(benches);
