//! Closed-form margins against linear programs, support functions and random samples, on existing robots and random
//! ones of 3 to 12 cables: point masses, layouts of lower rank, poses on the boundary, any load, mass off the origin,
//! polytopes and balls.
//!
//! A program's "yes" counts only with its tensions, which are checked here, and a margin's "no" only with its plane,
//! whose height is recomputed. `CDPR_VERIFY=n` runs n times as many poses (`make verify`).

use cdpr_core::geometry::{Point, Rotation, TriangleMesh, Vector};
use cdpr_core::model::{BodySpec, CableSpec, Robot, RobotSpec};
use cdpr_core::testing::paper_robot;
use cdpr_core::wrench::{
    AvailableSet, Balance, BindingFacet, CapacityMargin, FeasibilityLp, LargestScale, Loads, Required, ScaleLp,
    Statics, capacity_limit, force_limit, force_set, moment_limit, moment_set,
};
use cdpr_tests::{built_robot, direction, effort, rng, rotation, uniform, vector};
use nalgebra::{Matrix6xX, SVector, Vector3, Vector6};
use parry3d_f64::query::PointQuery;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Margins beyond this share of the largest tension must agree in sign with the programs.
const CLEAR: f64 = 1e-7;

/// Rounding error of a height above a plane, as a share of the largest tension times the longest column.
const ROUNDING: f64 = 1e-11;

/// Balance error of reported tensions, as a share of the larger of the wrench and the largest tension times the longest
/// column (of moments over a short characteristic length).
const BALANCE: f64 = 1e-9;

const BUILT: [&str; 5] = ["acrobot", "caroca", "cogiro", "ipanema2", "mpi_simulator"];

/// A robot under loads at a position, with its wrench matrix.
struct Pose {
    robot: Robot,
    loads: Loads,
    statics: Statics,
    position: Point,
    columns: Vec<Vector6<f64>>,
}

impl Pose {
    fn new(robot: Robot, loads: Loads, position: Point) -> Option<Self> {
        let statics = Statics::new(&robot, &loads).unwrap();
        let columns = statics.columns(&position)?;
        Some(Pose { robot, loads, statics, position, columns })
    }

    /// This pose with a load that these cables balance by tensions at most `reach` half ranges from the middle of their
    /// limits.
    fn balanced(self, rng: &mut ChaCha8Rng, reach: f64) -> Self {
        let tension = |[lo, hi]: [f64; 2]| 0.5 * (lo + hi) + 0.5 * (hi - lo) * reach * uniform(rng, -1.0, 1.0);
        let tensions: Vec<f64> = self.statics.cables().iter().map(|c| c.tension).map(tension).collect();
        let wrench: Vector6<f64> = self.columns.iter().zip(&tensions).map(|(w, t)| w * *t).sum();
        let missing = self.statics.balance() - wrench;
        let unit = Vector6::new(1.0, 1.0, 1.0, self.length(), self.length(), self.length());
        let loads = Loads { load: self.loads.load + missing.component_mul(&unit), ..self.loads };
        Pose::new(self.robot, loads, self.position).unwrap()
    }

    fn length(&self) -> f64 {
        self.statics.characteristic_length()
    }

    fn scale(&self) -> f64 {
        self.statics.largest_tension()
    }

    fn limits(&self) -> Vec<[f64; 2]> {
        self.statics.cables().iter().map(|cable| cable.tension).collect()
    }

    /// The relevant rows of a wrench: a point mass has no moments.
    fn counted(&self, w: &Vector6<f64>) -> Vector6<f64> {
        if self.statics.point_mass() { Vector6::new(w[0], w[1], w[2], 0.0, 0.0, 0.0) } else { *w }
    }

    fn matrix(&self) -> Matrix6xX<f64> {
        Matrix6xX::from_columns(&self.columns.iter().map(|w| self.counted(w)).collect::<Vec<_>>())
    }

    /// A wrench of [N, N·m] in the coordinates of the margins.
    fn measured(&self, w: &Vector6<f64>) -> Vector6<f64> {
        let (f, m) = (w.fixed_rows::<3>(0), w.fixed_rows::<3>(3) / self.length());
        Vector6::new(f.x, f.y, f.z, m.x, m.y, m.z)
    }

    fn required_centre(&self) -> Vector6<f64> {
        self.counted(self.statics.balance())
    }

    fn limit(&self, required: &Required) -> BindingFacet<6> {
        capacity_limit(&self.statics, required, &self.position).unwrap()
    }

    fn slack(&self, c: &Vector6<f64>, required: &Required) -> f64 {
        let columns: Vec<_> = self.columns.iter().map(|w| self.counted(w)).collect();
        support(&columns, &self.limits(), c) - c.dot(&self.required_centre()) - reach(required, c, self.length())
    }

    /// Rounding error of slack here.
    fn rounding(&self) -> f64 {
        let longest = self.columns.iter().map(|w| w.norm()).fold(1.0, f64::max);
        ROUNDING * longest * self.scale().max(self.required_centre().norm())
    }

    fn told(&self) -> String {
        format!("{:?} under {:?} at {}", self.robot.spec(), self.loads, self.position)
    }
}

/// How far the wrenches of tensions within limits extend in a direction.
fn support<const N: usize>(columns: &[SVector<f64, N>], limits: &[[f64; 2]], c: &SVector<f64, N>) -> f64 {
    columns.iter().zip(limits).map(|(w, [lo, hi])| w.dot(c) * if w.dot(c) > 0.0 { hi } else { lo }).sum()
}

/// How far required wrenches extend in a direction of [force; moment / length].
fn reach(required: &Required, c: &Vector6<f64>, length: f64) -> f64 {
    let (f, m) = (c.fixed_rows::<3>(0).norm(), c.fixed_rows::<3>(3).norm() / length);
    let scaled = Vector6::new(c[0], c[1], c[2], c[3] / length, c[4] / length, c[5] / length);
    match required {
        Required::Balls { force, moment } => force * f + moment * m,
        Required::Polytope(corners) => corners.iter().map(|w| w.dot(&scaled)).fold(f64::NEG_INFINITY, f64::max),
    }
}

fn random_robot(rng: &mut ChaCha8Rng, cables: usize, point_mass: bool) -> Robot {
    let size = 10f64.powi(rng.random_range(-1..2)); // size of the frame, m
    let strength = 10f64.powi(rng.random_range(0..5));
    let point = vector(rng, 0.1 * size);
    let cable = |_| {
        let least = if rng.random_bool(0.3) { 0.0 } else { uniform(rng, 0.0, 0.1) };
        let attachment = if point_mass { point } else { vector(rng, 0.2 * size) };
        CableSpec {
            outlet: vector(rng, size).into(),
            attachment: attachment.into(),
            tension: Some([least * strength, (least + uniform(rng, 0.01, 1.0)) * strength]),
            ..CableSpec::default()
        }
    };
    let cables: Vec<_> = (0..cables).map(cable).collect();
    let platform = vec![BodySpec { vertices: Some(vec![[0.0, 0.0, -9.0 * size]]), ..BodySpec::default() }];
    let center_of_mass = rng.random_bool(0.5).then(|| vector(rng, 0.1 * size).into());
    let mass = Some(uniform(rng, 0.0, 0.1) * strength);
    Robot::try_from(RobotSpec {
        version: None,
        name: None,
        mass,
        center_of_mass,
        inertia: None,
        platform,
        cables,
        cable: None,
        tension_distribution: None,
    })
    .unwrap()
}

/// Between the outlets, or slightly beyond them.
fn some_position(rng: &mut ChaCha8Rng, robot: &Robot) -> Point {
    let outlets = || robot.cables().iter().map(|cable| cable.outlet.coords);
    let (low, high) = (outlets().reduce(|a, b| a.inf(&b)).unwrap(), outlets().reduce(|a, b| a.sup(&b)).unwrap());
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    let drop = if half.z < 0.1 * half.x { half.x * uniform(rng, 0.0, 1.0) } else { 0.0 }; // suspended
    Point::from(middle + vector(rng, 1.05).component_mul(&half) - Vector::z() * drop)
}

fn some_loads(rng: &mut ChaCha8Rng, robot: &Robot, turned: bool) -> Loads {
    let scale = robot.cables().iter().map(|c| c.tension.unwrap()[1]).fold(0.0, f64::max);
    let length = [1e-2, 0.1, 1.0, 1.0, 10.0][rng.random_range(0..5)];
    let (f, m) = (vector(rng, 0.1 * scale), vector(rng, 0.02 * scale));
    let loaded = rng.random_bool(0.5);
    Loads {
        orientation: if turned { rotation(rng) } else { Rotation::identity() },
        load: if loaded { Vector6::new(f.x, f.y, f.z, m.x, m.y, m.z) } else { Vector6::zeros() },
        characteristic_length: length,
        ..Loads::default()
    }
}

/// Calls `each` for about this many poses of all kinds of robots.
fn poses(seed: u64, count: u64, mut each: impl FnMut(&mut ChaCha8Rng, Pose)) {
    let mut rng = rng(seed);
    let built = BUILT.map(built_robot);
    let paper = Robot::try_from(paper_robot()).unwrap();
    for round in 0..count {
        let kind = round % 12;
        let robot = match kind {
            0..5 => built[kind as usize].clone(),
            5 => paper.clone(),
            6 | 7 => {
                let cables = rng.random_range(3..=12);
                random_robot(&mut rng, cables, true)
            }
            8 => {
                let cables = rng.random_range(3..6);
                random_robot(&mut rng, cables, false)
            }
            _ => {
                let cables = [6, 7, 8, 8, 9, 10, 12][rng.random_range(0..7)];
                random_robot(&mut rng, cables, false)
            }
        };
        let loads = match kind < 6 && rng.random_bool(0.4) {
            true => Loads::default(),
            false => some_loads(&mut rng, &robot, kind >= 6),
        };
        let position = some_position(&mut rng, &robot);
        let Some(pose) = Pose::new(robot, loads, position) else { continue };
        // Random robots seldom carry their load; most of them get a load near the limit of what they can carry.
        let pose = if kind >= 5 && rng.random_bool(0.8) { pose.balanced(&mut rng, 1.3) } else { pose };
        each(&mut rng, pose);
    }
}

/// Whether tensions within limits balance a wrench; reported tensions are checked.
#[track_caller]
fn feasible(lp: &mut FeasibilityLp, matrix: &Matrix6xX<f64>, limits: &[[f64; 2]], wrench: &Vector6<f64>) -> bool {
    let longest = matrix.column_iter().map(|w| w.norm()).fold(1.0, f64::max);
    let scale = limits.iter().map(|l| longest * l[1]).fold(wrench.norm(), f64::max);
    match lp.solve(matrix, limits, wrench).unwrap() {
        Balance::Feasible(t) => {
            let off = (matrix * &t - wrench).norm();
            assert!(off <= BALANCE * scale, "off by {off} of {scale}");
            assert!(t.iter().zip(limits).all(|(t, [lo, hi])| (lo..=hi).contains(&t)));
            true
        }
        Balance::Infeasible => false,
        Balance::Undecided => panic!("undecided"),
    }
}

/// How often "yes", "no" and "too close to call" were right.
#[derive(Debug, Default)]
struct Tally {
    yes: usize,
    no: usize,
    near: usize,
    wrong: usize,
}

impl Tally {
    /// Compares a margin with a linear program and prints differences.
    fn compare(&mut self, margin: f64, clear: f64, yes: bool, told: impl FnOnce() -> String) {
        match margin {
            m if m.abs() <= clear => self.near += 1,
            m if (m > 0.0) != yes => {
                println!("margin {m} of {clear}, but the program says {yes}: {}", told());
                self.wrong += 1;
            }
            m if m > 0.0 => self.yes += 1,
            _ => self.no += 1,
        }
    }

    #[track_caller]
    fn done(&self, name: &str, least: usize) {
        println!("{name}: {self:?}");
        assert_eq!(self.wrong, 0);
        assert!(self.yes >= least && self.no >= least);
    }
}

#[test]
fn margins_and_programs_agree_on_every_pose() {
    let (mut lp, mut tally) = (FeasibilityLp::new(), Tally::default());
    poses(1, 12_000 * effort(), |_, pose| {
        let required = Required::default();
        let BindingFacet { margin, normal } = pose.limit(&required);
        let fast = CapacityMargin::new(pose.statics.clone(), required.clone()).unwrap().at(&pose.position);
        assert!((fast - margin).abs() <= 100.0 * pose.rounding(), "{fast} by the kernel, {margin}: {}", pose.told());
        // The reported plane has that slack.
        let by_plane = pose.slack(&normal, &required);
        assert!((by_plane - margin).abs() <= pose.rounding(), "{by_plane} for {margin}: {}", pose.told());
        let yes = feasible(&mut lp, &pose.matrix(), &pose.limits(), &pose.required_centre());
        tally.compare(margin, CLEAR * pose.scale(), yes, || pose.told());
    });
    tally.done("weight and load", 2000);
}

#[test]
fn margins_and_programs_agree_where_the_boundary_is_crossed() {
    let (mut lp, mut tally) = (FeasibilityLp::new(), Tally::default());
    poses(2, 3_000 * effort(), |rng, pose| {
        let required = Required::default();
        let to = some_position(rng, &pose.robot);
        let margin = |t: f64| {
            let p = pose.position + (to - pose.position) * t;
            capacity_limit(&pose.statics, &required, &p).map_or(f64::NAN, |limit| limit.margin)
        };
        let (mut low, mut high) = (0.0, 1.0);
        if (margin(low) > 0.0) == (margin(high) > 0.0) {
            return;
        }
        let first = margin(low) > 0.0;
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if (margin(middle) > 0.0) == first { low = middle } else { high = middle }
        }
        for step in [0.0, 1e-9, 1e-7, 1e-5, 1e-3] {
            for t in [low - step, high + step] {
                let Some(columns) = pose.statics.columns(&(pose.position + (to - pose.position) * t)) else { continue };
                let matrix = Matrix6xX::from_columns(&columns.iter().map(|w| pose.counted(w)).collect::<Vec<_>>());
                let yes = feasible(&mut lp, &matrix, &pose.limits(), &pose.required_centre());
                tally.compare(margin(t), CLEAR * pose.scale(), yes, || format!("{t} to {to} of {}", pose.told()));
            }
        }
    });
    tally.done("across the boundary", 500);
}

/// The wrench farthest along a direction, and its tensions, with those of cables in the facet in the middle.
fn farthest(pose: &Pose, c: &Vector6<f64>) -> Vector6<f64> {
    let tension = |w: &Vector6<f64>, [lo, hi]: [f64; 2]| match w.dot(c) {
        height if height.abs() < 1e-9 * w.norm() => 0.5 * (lo + hi),
        height => {
            if height > 0.0 {
                hi
            } else {
                lo
            }
        }
    };
    let columns = pose.columns.iter().map(|w| pose.counted(w));
    columns.zip(pose.limits()).map(|(w, limits)| w * tension(&w, limits)).sum()
}

#[test]
fn a_facet_is_where_the_set_ends() {
    let (mut lp, mut inside) = (FeasibilityLp::new(), 0);
    poses(3, 2_000 * effort(), |_, pose| {
        let BindingFacet { normal, .. } = pose.limit(&Required::default());
        if normal.norm() < 0.5 {
            return; // there is no facet at all
        }
        let (matrix, limits) = (pose.matrix(), pose.limits());
        let edge = farthest(&pose, &normal);
        let beyond = CLEAR * pose.scale().max(edge.norm());
        assert!(feasible(&mut lp, &matrix, &limits, &edge), "{}", pose.told());
        assert!(!feasible(&mut lp, &matrix, &limits, &(edge + normal * beyond)), "{}", pose.told());
        inside += 1;
    });
    assert!(inside > 1000);
}

#[test]
fn a_positive_margin_is_the_least_slack_over_all_directions() {
    let mut positive = 0;
    poses(4, 4_000 * effort(), |rng, pose| {
        let ball = if pose.statics.point_mass() { 0.0 } else { 0.01 * pose.scale() };
        let required = Required::balls(uniform(rng, 0.0, 0.05) * pose.scale(), uniform(rng, 0.0, ball)).unwrap();
        let BindingFacet { margin, normal } = pose.limit(&required);
        if margin <= 0.0 {
            return;
        }
        positive += 1;
        assert!((pose.slack(&normal, &required) - margin).abs() <= pose.rounding());
        for k in 0..200 {
            let (f, m) = (direction(rng), direction(rng));
            let blend = uniform(rng, 0.0, 1.0);
            let random = Vector6::new(f.x, f.y, f.z, blend * m.x, blend * m.y, blend * m.z);
            // Half of them near the reported normal.
            let c = if k % 2 == 0 { random } else { normal + random * 10f64.powi(-rng.random_range(1..8)) };
            let c = pose.counted(&c).normalize();
            let slack = pose.slack(&c, &required);
            assert!(slack >= margin - pose.rounding(), "{slack} along {c}, told {margin}: {}", pose.told());
        }
    });
    assert!(positive > 300, "{positive}");
}

/// A polytope of [N, N·m] around a centre, or away from it.
fn some_polytope(rng: &mut ChaCha8Rng, pose: &Pose, around: bool) -> Vec<Vector6<f64>> {
    let size = pose.scale() * 10f64.powf(uniform(rng, -3.0, 0.0));
    let reach = pose.robot.cables().iter().map(|c| c.attachment.coords.norm()).fold(0.0, f64::max);
    let count = rng.random_range(1..9);
    let corner = |_| {
        let (f, m) = (vector(rng, size), vector(rng, size * 0.3 * reach));
        if pose.statics.point_mass() {
            f.push(0.0).push(0.0).push(0.0)
        } else {
            Vector6::new(f.x, f.y, f.z, m.x, m.y, m.z)
        }
    };
    let corners: Vec<Vector6<f64>> = (0..count).map(corner).collect();
    if around { corners.iter().flat_map(|w| [*w, w * -0.5]).collect() } else { corners }
}

#[test]
fn a_polytope_is_available_iff_its_corners_are() {
    let (mut lp, mut scale_lp) = (FeasibilityLp::new(), ScaleLp::new());
    let (mut tally, mut scales, mut undecided) = (Tally::default(), Tally::default(), 0);
    poses(5, 4_000 * effort(), |rng, pose| {
        let around = rng.random_bool(0.6);
        let corners = some_polytope(rng, &pose, around);
        let (matrix, limits, centre) = (pose.matrix(), pose.limits(), pose.required_centre());
        let measured: Vec<_> = corners.iter().map(|w| pose.measured(w)).collect();
        let BindingFacet { margin, normal } = pose.limit(&Required::Polytope(corners.clone()));
        let by_plane = pose.slack(&normal, &Required::Polytope(corners));
        assert!((by_plane - margin).abs() <= pose.rounding() || normal.norm() < 0.5, "{by_plane} for {margin}");
        let clear = CLEAR * pose.scale();
        let all = measured.iter().all(|w| feasible(&mut lp, &matrix, &limits, &(centre + w)));
        tally.compare(margin, clear, all, || pose.told());
        if around {
            let grown = match scale_lp.solve(&matrix, &limits, &centre, &measured).unwrap() {
                LargestScale::Bounded(s) => s >= 1.0,
                LargestScale::Infeasible => false,
                LargestScale::Unbounded => panic!("unbounded: {}", pose.told()),
                LargestScale::Undecided => {
                    println!("undecided: {}", pose.told());
                    undecided += 1;
                    return;
                }
            };
            scales.compare(margin, clear, grown, || pose.told());
        }
    });
    tally.done("polytopes", 300);
    scales.done("polytopes by scale", 200);
    assert_eq!(undecided, 0);
}

#[test]
fn balls_are_available_iff_all_their_wrenches_are() {
    let (mut lp, mut tally) = (FeasibilityLp::new(), Tally::default());
    poses(6, 3_000 * effort(), |rng, pose| {
        let size = pose.scale() * 10f64.powf(uniform(rng, -4.0, -0.5));
        let arm = pose.robot.cables().iter().map(|c| c.attachment.coords.norm()).fold(0.0, f64::max);
        let (force, moment) = (size, if pose.statics.point_mass() { 0.0 } else { size * 0.3 * arm });
        let required = Required::balls(force, moment).unwrap();
        let BindingFacet { margin, normal } = pose.limit(&required);
        let fast = CapacityMargin::new(pose.statics.clone(), required).unwrap().at(&pose.position);
        assert!((fast - margin).abs() <= 100.0 * pose.rounding(), "{fast} by the kernel, {margin}: {}", pose.told());
        let (matrix, limits, centre) = (pose.matrix(), pose.limits(), pose.required_centre());
        let part = |c: Vector3<f64>, radius: f64| c.try_normalize(1e-12).map_or(c * 0.0, |c| c * radius);
        let worst = |c: &Vector6<f64>| {
            let (f, m) = (part(c.fixed_rows::<3>(0).into(), force), part(c.fixed_rows::<3>(3).into(), moment));
            pose.measured(&Vector6::new(f.x, f.y, f.z, m.x, m.y, m.z))
        };
        if margin > 0.0 {
            for _ in 0..20 {
                let (f, m) = (direction(rng), direction(rng));
                let w = centre + worst(&Vector6::new(f.x, f.y, f.z, m.x, m.y, m.z));
                assert!(feasible(&mut lp, &matrix, &limits, &w), "{margin}: {}", pose.told());
            }
        }
        let at_worst = feasible(&mut lp, &matrix, &limits, &(centre + worst(&normal)));
        tally.compare(margin, CLEAR * pose.scale(), at_worst, || pose.told());
        if margin > CLEAR * pose.scale() {
            // Along the reported normal, no more than the margin fits.
            let beyond = centre + worst(&normal) + normal * (margin + CLEAR * pose.scale().max(centre.norm()));
            assert!(!feasible(&mut lp, &matrix, &limits, &beyond), "{}", pose.told());
        }
    });
    tally.done("balls", 200);
}

/// A set of three rows as six: the others are zero.
fn padded(columns: &[Vector3<f64>]) -> Matrix6xX<f64> {
    Matrix6xX::from_columns(&columns.iter().map(|w| w.push(0.0).push(0.0).push(0.0)).collect::<Vec<_>>())
}

/// Distance of a point to a surface, triangle by triangle.
fn distance_to(mesh: &TriangleMesh, point: &Vector3<f64>) -> f64 {
    let glam = |p: &Vector3<f64>| parry3d_f64::math::Vector::new(p.x, p.y, p.z);
    let to_triangle = |corners: &[usize; 3]| {
        let [a, b, c] = corners.map(|k| glam(&mesh.vertices[k].coords));
        parry3d_f64::shape::Triangle::new(a, b, c).distance_to_local_point(glam(point), true)
    };
    mesh.triangles.iter().map(to_triangle).fold(f64::INFINITY, f64::min)
}

#[test]
fn forces_and_moments_alone_agree_with_programs() {
    let (mut lp, mut forces, mut moments) = (FeasibilityLp::new(), Tally::default(), Tally::default());
    poses(7, 4_000 * effort(), |rng, pose| {
        let mut check = |tally: &mut Tally, limit: BindingFacet<3>, set: AvailableSet, first: usize, factor: f64| {
            let part = |w: &Vector6<f64>| Vector3::from(w.fixed_rows::<3>(first)) * factor;
            let columns: Vec<_> = pose.columns.iter().map(part).collect();
            let (limits, centre) = (pose.limits(), part(pose.statics.balance()));
            let longest = columns.iter().map(|w| w.norm()).fold(0.0, f64::max);
            let size = (longest * pose.scale()).max(centre.norm());
            let rounding = ROUNDING * size;
            let slack = |c: &Vector3<f64>| support(&columns, &limits, c) - c.dot(&centre);
            assert!((slack(&limit.normal) - limit.margin).abs() <= rounding, "{}", pose.told());
            for _ in 0..20 {
                assert!(slack(&direction(rng)) >= limit.margin - rounding, "{}", pose.told());
            }
            if limit.margin < -rounding && !set.mesh.triangles.is_empty() {
                let distance = distance_to(&set.mesh, &centre);
                assert!((distance + limit.margin).abs() <= 1e-9 * size, "{distance}, {}", pose.told());
            }
            let yes = feasible(&mut lp, &padded(&columns), &limits, &centre.push(0.0).push(0.0).push(0.0));
            tally.compare(limit.margin, CLEAR * (longest * pose.scale()).max(centre.norm()), yes, || pose.told());
        };
        let set = force_set(&pose.statics, &pose.position).unwrap();
        check(&mut forces, force_limit(&pose.statics, &pose.position).unwrap(), set, 0, 1.0);
        if let Some(limit) = moment_limit(&pose.statics, &pose.position) {
            let set = moment_set(&pose.statics, &pose.position).unwrap();
            check(&mut moments, limit, set, 3, pose.length());
        }
    });
    forces.done("forces", 500);
    moments.done("moments", 300);
}
