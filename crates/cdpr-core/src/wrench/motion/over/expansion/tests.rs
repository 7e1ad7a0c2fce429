//! Each bound against what it bounds, exactly, at the worst places that a search finds in the box. Boxes reach up to half the shortest
//! cable's length. Some are thin, along a direction in which all but one of the remainders vanish.

use nalgebra::{Matrix6, Vector6};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::super::replaced;
use super::*;
use crate::geometry::{Point, Pulley, Rotation};
use crate::model::spec::{CableSpec, MarginSpec, PulleySpec, RobotSource, SceneSpec, WorkspaceSpec, WrenchSpec};
use crate::testing::{block, paper_robot, paper_scene, scene};
use crate::wrench::motion::measures;

/// Rounding errors of what is computed here.
const ROUNDING: f64 = 1e-11;

/// What of a robot's wrenches is measured: all, forces, moments, and all of a point mass.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Counted {
    All,
    Forces,
    Moments,
    PointMass,
}

/// A cable of a platform at the origin: direction, length, lever and tensions.
#[derive(Debug, Clone, Copy)]
struct Pull {
    unit: Vector,
    length: f64,
    arm: Vector,
    tension: [f64; 2],
    error: f64,
    /// The pulley that it leaves in this direction while the platform is at the origin, and its outlet.
    wheel: Option<(Pulley, Point)>,
}

/// A robot, a box round the origin, and the cables of a facet.
#[derive(Debug, Clone)]
struct Case {
    pulls: Vec<Pull>,
    counted: Counted,
    wrench: WrenchSpec,
    half: Vector,
    facet: u32,
}

impl Case {
    fn measure(&self) -> Measure {
        let cable = |pull: &Pull| CableSpec {
            outlet: pull.wheel.map_or(Point::from(pull.arm + pull.unit * pull.length), |(_, outlet)| outlet).into(),
            pulley: pull.wheel.map(|(Pulley { radius, axis }, _)| PulleySpec { radius, axis: axis.into() }),
            attachment: pull.arm.into(),
            tension: Some(pull.tension),
            outlet_error: (pull.error > 0.0).then_some(pull.error),
            ..CableSpec::default()
        };
        let mut robot = paper_robot();
        robot.platform = vec![block("body", [0.01; 3], [0.5, 0.4, 0.1])];
        robot.cables = self.pulls.iter().map(cable).collect();
        let mut wrench = self.wrench.clone();
        wrench.characteristic_length = Some(1.0);
        let apart = matches!(self.counted, Counted::Forces | Counted::Moments);
        wrench.margin = apart.then_some(MarginSpec::Projected);
        let mut found = measures(&scene(SceneSpec {
            gravity: Some([0.0; 3]),
            workspace: WorkspaceSpec { min: [-1.0; 3], max: [1.0; 3] },
            robot: RobotSource::Inline(robot),
            wrench: Some(wrench),
            query: None,
            ..paper_scene("bounds", Vec::new())
        }))
        .expect("a sound requirement");
        found.swap_remove(usize::from(self.counted == Counted::Moments))
    }

    fn positions(&self) -> Cuboid {
        Cuboid::new(Point::from(-self.half), Point::from(self.half))
    }

    /// The rows that count of a force and a moment.
    fn rows(&self, force: &Vector, moment: &Vector) -> Row {
        let [first, second] = match self.counted {
            Counted::All => [*force, *moment],
            Counted::Forces | Counted::PointMass => [*force, Vector::zeros()],
            Counted::Moments => [*moment, Vector::zeros()],
        };
        [first.x, first.y, first.z, second.x, second.y, second.z]
    }

    /// The column of a cable at an offset in half sides, with its outlet off by a vector.
    fn column(&self, pull: &Pull, x: &[f64; 3], off: &Vector) -> Row {
        let line = pull.unit * pull.length + off - self.half.component_mul(&Vector::from(*x));
        let unit = line.normalize();
        self.rows(&unit, &pull.arm.cross(&unit))
    }

    /// The true column, from where the cable leaves its pulley.
    fn true_column(&self, pull: &Pull, x: &[f64; 3], off: &Vector) -> Row {
        let Some((pulley, outlet)) = &pull.wheel else { return self.column(pull, x, off) };
        let attachment = Point::from(pull.arm + self.half.component_mul(&Vector::from(*x)));
        let unit = pulley.departure(&(outlet + off), &attachment).expect("bounded").pull;
        self.rows(&unit, &pull.arm.cross(&unit))
    }

    /// The normal of the facet at an offset, such that its product with the one at the centre is 1.
    fn normal(&self, center: &Row, x: &[f64; 3]) -> Row {
        let count = if self.counted == Counted::All { 6 } else { 3 };
        let mut matrix = Matrix6::identity();
        let mut row = 0;
        for (k, pull) in self.pulls.iter().enumerate() {
            if self.facet >> k & 1 == 1 {
                matrix.set_row(row, &Vector6::from(self.column(pull, x, &Vector::zeros())).transpose());
                row += 1;
            }
        }
        assert_eq!(row, count - 1);
        matrix.set_row(row, &Vector6::from(*center).transpose());
        let mut one = Vector6::zeros();
        one[row] = 1.0;
        matrix.lu().solve(&one).expect("independent columns").into()
    }

    /// The slack to the facet on a side times the length of the normal, at the given outlets or at the worst ones. `load` is the sum
    /// of all that must be balanced.
    fn slack(&self, c: &Row, sign: f64, load: &Row, x: &[f64; 3], errors: bool) -> f64 {
        let pulled = |pull: &Pull| {
            let at = |off: &Vector| {
                let along = sign * dot(c, &self.true_column(pull, x, off));
                (pull.tension[0] * along).max(pull.tension[1] * along)
            };
            if !errors || pull.error == 0.0 {
                return at(&Vector::zeros());
            }
            let axes = [Vector::x(), Vector::y(), Vector::z()];
            let step = 1e-6;
            let gradient: Vector = axes.iter().map(|axis| axis * (at(&(axis * step)) - at(&(-axis * step)))).sum();
            at(&gradient.try_normalize(0.0).map_or(Vector::zeros(), |steepest| -steepest * pull.error))
        };
        self.pulls.iter().map(pulled).sum::<f64>() - sign * dot(c, load)
    }

    /// Turned so that the box's third axis is along a direction, and thin along the others.
    fn turned(&self, along: &Vector) -> Option<Self> {
        let turn = Rotation::rotation_between(along, &Vector::z())?;
        let mut turned = self.clone();
        for pull in &mut turned.pulls {
            (pull.unit, pull.arm) = (turn * pull.unit, turn * pull.arm);
            let turned = |(Pulley { radius, axis }, outlet)| (Pulley { radius, axis: turn * axis }, turn * outlet);
            pull.wheel = pull.wheel.map(turned);
        }
        let reach = 0.999 * self.half.norm();
        turned.half = Vector::new(1e-4 * reach, 1e-4 * reach, reach);
        Some(turned)
    }
}

/// Random robots, boxes and facets.
struct Cases(ChaCha8Rng);

impl Cases {
    fn direction(&mut self) -> Vector {
        loop {
            let found = Vector::from_fn(|_, _| self.0.random_range(-1.0..1.0));
            if (0.1..1.0).contains(&found.norm()) {
                return found.normalize();
            }
        }
    }

    /// With a box that reaches as far as this share of the shortest cable's length.
    fn any(&mut self, reach: f64) -> Case {
        let counted = [Counted::All, Counted::Forces, Counted::Moments, Counted::PointMass][self.0.random_range(0..4)];
        let rows = if counted == Counted::All { 6 } else { 3 };
        let cables = rows + self.0.random_range(1..3);
        let near = self.0.random_range(0..cables);
        let far = self.0.random_bool(0.5);
        let levers = 10f64.powf(self.0.random_range(0.0f64..1.0) * self.0.random_range(0.0..1.0));
        let mut pulls = Vec::new();
        for k in 0..cables {
            let scale = if far && k != near && self.0.random_bool(0.8) { self.0.random_range(0.5..4.0) } else { 0.0 };
            let arm = if counted == Counted::PointMass { Vector::zeros() } else { self.direction() * levers };
            let greatest = self.0.random_range(1.0..2.0);
            pulls.push(Pull {
                unit: self.direction(),
                length: 10f64.powf(scale) * if k == near { 1.0 } else { self.0.random_range(1.0..1.5) },
                arm,
                tension: [greatest * self.0.random_range(0.01..0.99), greatest],
                error: 0.0,
                wheel: None,
            });
        }
        let frame = counted != Counted::PointMass && self.0.random_bool(0.15);
        if frame {
            pulls = self.in_a_frame();
        } else if self.0.random_bool(0.3) {
            let apart = 10f64.powf(self.0.random_range(-7.0..-1.0));
            let (of, other) = (self.0.random_range(0..cables), self.0.random_range(0..cables));
            pulls[other] = pulls[of];
            pulls[other].unit = (pulls[of].unit + self.direction() * apart).normalize();
            if counted != Counted::PointMass {
                pulls[other].arm += self.direction() * apart;
            }
        }
        let mut half = self.direction().abs();
        for axis in 0..3 {
            if self.0.random_bool(0.2) {
                half[axis] *= 1e-4;
            }
        }
        half *= reach * pulls.iter().map(|pull| pull.length).fold(f64::INFINITY, f64::min) / half.norm();
        let mut facet = 0u32;
        while facet.count_ones() < rows as u32 - 1 {
            facet |= 1 << self.0.random_range(0..pulls.len());
        }
        Case { pulls, counted, wrench: WrenchSpec::default(), half, facet }
    }

    /// A pulley that a cable leaves in its direction after any wrap.
    fn wheel(&mut self, pull: &Pull) -> (Pulley, Point) {
        let (along, radius) = (-pull.unit, 10f64.powf(self.0.random_range(-4.0..0.0)) * pull.length);
        let normal = self.direction().cross(&along).normalize();
        let (sine, cosine) = self.0.random_range(0.0..std::f64::consts::PI).sin_cos();
        let (side, axis) = (sine * along - cosine * normal, cosine * along + sine * normal);
        let outlet = pull.arm + pull.unit * pull.length - radius * (normal + side);
        (Pulley { radius, axis }, Point::from(outlet))
    }

    /// Eight cables from the corners of a frame, or from its upper corners in pairs, to those of a platform anywhere in it.
    fn in_a_frame(&mut self) -> Vec<Pull> {
        let place = Vector::from_fn(|_, _| self.0.random_range(-0.6..0.6));
        let (crossed, pairs) = (self.0.random_range(0..8), self.0.random_bool(0.5));
        let corner = |k: usize| Vector::from_fn(|axis, _| if k >> axis & 1 == 1 { 1.0 } else { -1.0 });
        let pull = |k: usize| {
            let arm = corner(k ^ crossed).component_mul(&Vector::new(0.3, 0.2, 0.1));
            let mut outlet = corner(k);
            if pairs {
                outlet.z = 1.0 + 0.05 * outlet.z;
            }
            let line = outlet - place - arm;
            Pull { unit: line.normalize(), length: line.norm(), arm, tension: [0.1, 2.0], error: 0.0, wheel: None }
        };
        (0..8).map(pull).collect()
    }

    /// One of these, or one that is turned so that nothing changes with the box's long axis but the direction of one facet's cable
    /// across the normal, or that of another cable.
    fn sharp(&mut self, reach: f64) -> Case {
        let case = self.any(reach);
        if self.0.random_bool(0.4) {
            return case;
        }
        let measure = case.measure();
        let cube = Cuboid::new(Point::from(-case.half * 1e-3), Point::from(case.half * 1e-3));
        let Some(expansion) = Expansion::new(&measure, &cube) else { return case };
        let Some(normal) = expansion.normal(case.facet) else { return case };
        let near = (0..case.pulls.len()).min_by(|a, b| case.pulls[*a].length.total_cmp(&case.pulls[*b].length));
        let near = near.expect("cables");
        let column = &expansion.columns[near];
        let weight = column.weight(&normal.center, expansion.counted);
        let across = if case.facet >> near & 1 == 1 {
            let k = (case.facet & ((1 << near) - 1)).count_ones() as usize;
            column.weight(&normal.duals[k], expansion.counted)
        } else {
            column.unit
        };
        let Some(across) = across.try_normalize(1e-9) else { return case };
        let mut along = weight - across * across.dot(&weight);
        if self.0.random_bool(0.3) {
            along += across * self.0.random_range(-1.0..1.0) * weight.norm();
        }
        case.turned(&along).unwrap_or(case)
    }

    /// A random required set and load.
    fn required(&mut self, case: &mut Case) {
        let mut random = |size: f64| self.0.random_range(-size..size);
        let mut load: [f64; 6] = std::array::from_fn(|_| random(1.0));
        let moments = !matches!(case.counted, Counted::PointMass);
        if !moments {
            load[3..].fill(0.0);
        }
        case.wrench.load = Some(load);
        if random(1.0) > 0.0 || matches!(case.counted, Counted::Forces | Counted::Moments) {
            case.wrench.force = Some(random(1.0).abs());
            case.wrench.moment = moments.then(|| random(1.0).abs());
        } else {
            let mut corner = || std::array::from_fn(|row| if row < 3 || moments { random(1.0) } else { 0.0 });
            case.wrench.vertices = Some((0..3).map(|_| corner()).collect());
        }
    }
}

fn value(of: &Quadratic, [x, y, z]: &[f64; 3]) -> f64 {
    let terms = [x * x, y * y, z * z, x * y, x * z, y * z];
    let linear: f64 = of.slope.iter().zip([x, y, z]).map(|(a, b)| a * b).sum();
    of.at_center + linear + of.curve.iter().zip(terms).map(|(a, b)| a * b).sum::<f64>()
}

/// How far a value is from a quadratic function, as a share of what that admits.
fn share(of: &Quadratic, x: &[f64; 3], exact: f64) -> f64 {
    let off = exact - value(of, x);
    if off > 0.0 { off / (of.above + ROUNDING) } else { -off / (of.below + ROUNDING) }
}

/// The largest value of a function in a box, by the best of its corners, the middles of its edges and faces, and the centre, and a
/// search from there.
fn worst(of: impl Fn(&[f64; 3]) -> f64) -> f64 {
    let (mut at, mut most) = ([0.0; 3], of(&[0.0; 3]));
    let mut tried = |x: [f64; 3], at: &mut [f64; 3]| {
        let found = of(&x);
        if found > most {
            (*at, most) = (x, found);
        }
    };
    for k in 0..27 {
        tried([k % 3, k / 3 % 3, k / 9].map(|k| f64::from(k) - 1.0), &mut at);
    }
    for step in [0.5, 0.25, 0.1, 0.03] {
        for (axis, way) in (0..3).flat_map(|axis| [(axis, step), (axis, -step)]) {
            let mut x = at;
            x[axis] = (x[axis] + way).clamp(-1.0, 1.0);
            tried(x, &mut at);
        }
    }
    most
}

/// Counts bounds by name, and how close what they bound comes to them.
#[derive(Default)]
struct Closest(std::collections::BTreeMap<&'static str, (usize, f64)>);

impl Closest {
    fn keep(&mut self, name: &'static str, case: &Case, share: f64) {
        assert!(share <= 1.0 + 1e-9, "{name}: {share} times the bound in {case:?}");
        let (count, most) = self.0.entry(name).or_default();
        (*count, *most) = (*count + 1, most.max(share));
    }

    fn reached(&self, expected: &[(&str, f64)]) {
        for (name, least) in expected {
            let (count, most) = self.0[name];
            assert!(count > 100 && most > *least, "{name}: {count} bounds, at most {most} of one");
        }
    }
}

/// Columns are as close to their linear and quadratic approximations as they claim, and some hardly closer.
#[test]
fn columns_keep_to_their_remainders() {
    let (mut cases, mut closest) = (Cases(ChaCha8Rng::seed_from_u64(1)), Closest::default());
    for round in 0..300 {
        let case = cases.any([0.49, 0.2, 0.01][round % 3]);
        let along = cases.direction();
        let case = if round % 2 == 0 { case.turned(&along).unwrap_or(case) } else { case };
        let measure = case.measure();
        let Some(expansion) = Expansion::new(&measure, &case.positions()) else { continue };
        for (k, pull) in case.pulls.iter().enumerate() {
            let column = &expansion.columns[k];
            let row = |row: usize| {
                let mut fixed = [0.0; ROWS];
                fixed[row] = 1.0;
                let (slope, curve) = expansion.moving(k, &fixed);
                Quadratic { at_center: column.center[row], slope, curve, ..Quadratic::default() }
            };
            let quadratic: [Quadratic; ROWS] =
                std::array::from_fn(|at| if at < expansion.rows { row(at) } else { Quadratic::default() });
            let linear = quadratic.map(|row| Quadratic { curve: [0.0; 6], ..row });
            let off = |near: &[Quadratic; ROWS], x: &[f64; 3]| {
                let exact = case.column(pull, x, &Vector::zeros());
                size(&std::array::from_fn(|row| exact[row] - value(&near[row], x)))
            };
            closest.keep("bend", &case, worst(|x| off(&linear, x)) / column.bend);
            closest.keep("third", &case, worst(|x| off(&quadratic, x)) / column.third);
        }
    }
    closest.reached(&[("bend", 0.95), ("third", 0.95)]);
}

/// Normals, their products with fixed vectors and with other columns, and the lengths of their parts.
#[test]
fn normals_keep_to_their_remainders() {
    let (mut cases, mut closest) = (Cases(ChaCha8Rng::seed_from_u64(2)), Closest::default());
    let mut combined = 0;
    for round in 0..1500 {
        let case = cases.sharp([0.45, 0.2, 0.05][round % 3]);
        let measure = case.measure();
        let Some(expansion) = Expansion::new(&measure, &case.positions()) else { continue };
        let Some(normal) = expansion.normal(case.facet) else { continue };
        let center = &normal.center;
        let exact = |x: &[f64; 3]| case.normal(center, x);
        let off = |x: &[f64; 3], linear: bool| -> f64 {
            let y = |k: usize| -> f64 { normal.slopes[k].iter().zip(x).map(|(a, b)| a * b).sum() };
            let (mut near, exact) = (*center, exact(x));
            for k in (0..normal.count).filter(|_| linear) {
                near.iter_mut().zip(&normal.duals[k]).for_each(|(near, u)| *near += y(k) * u);
            }
            let off: Row = std::array::from_fn(|row| exact[row] - near[row]);
            size(&off)
        };
        closest.keep("spread", &case, worst(|x| off(x, false)) / normal.spread);
        closest.keep("bent", &case, worst(|x| off(x, true)) / (normal.bent + ROUNDING));
        // Combinations of columns have products with one dual vector alone.
        let chosen: Vec<usize> = (0..case.pulls.len()).filter(|k| case.facet >> k & 1 == 1).collect();
        let axes = expansion.axes(&chosen);
        let sum = |k: usize| -> Row {
            std::array::from_fn(|row| {
                (0..normal.count).map(|i| axes[k][i] * expansion.columns[chosen[i]].center[row]).sum()
            })
        };
        let any = case.rows(&cases.direction(), &cases.direction());
        let columns = chosen.iter().map(|k| expansion.columns[*k].center);
        for fixed in (0..normal.count).map(sum).chain(columns).chain([any]) {
            let product = normal.product(&fixed);
            closest.keep("product", &case, worst(|x| share(&product, x, dot(&fixed, &exact(x)))));
        }
        for part in 0..2 {
            let support = normal.ball(1.0, part);
            let length = |c: &Row| Vector::new(c[3 * part], c[3 * part + 1], c[3 * part + 2]).norm();
            closest.keep("ball", &case, worst(|x| share(&support, x, length(&exact(x)))));
        }
        for (k, pull) in case.pulls.iter().enumerate().filter(|(k, _)| case.facet >> k & 1 == 0) {
            let height = expansion.height(k, &normal);
            let exact = |x: &[f64; 3]| dot(&exact(x), &case.column(pull, x, &Vector::zeros()));
            closest.keep("height", &case, worst(|x| share(&height, x, exact(x))));
        }
        let (_, plain) = expansion.duals(&chosen).expect("independent columns");
        let ones = std::array::from_fn(|j| std::array::from_fn(|k| f64::from(u8::from(j == k))));
        if expansion.turned(&chosen, center, plain, &ones).is_none() {
            combined += 1;
            for (j, k) in (0..normal.count).flat_map(|j| (0..normal.count).map(move |k| (j, k))) {
                let error = dot(&normal.duals[k], &sum(j)) - f64::from(u8::from(j == k));
                assert!(error.abs() <= SKEW * normal.sizes[k], "{error} of {case:?}");
                assert!(j == k || dot(&sum(j), &sum(k)).abs() < 1e-12, "{case:?}");
            }
        }
    }
    assert!(combined > 20, "{combined}");
    closest.reached(&[("spread", 0.95), ("bent", 0.95), ("product", 0.95), ("ball", 0.7), ("height", 0.9)]);
}

/// The slack to facets on both sides, less any required set, at the given outlets and at the worst ones.
#[test]
fn facets_keep_to_their_bounds() {
    let (mut cases, mut closest) = (Cases(ChaCha8Rng::seed_from_u64(3)), Closest::default());
    for round in 0..1500 {
        let mut case = cases.sharp([0.4, 0.1, 0.01, 1e-4][round % 4]);
        cases.required(&mut case);
        if round % 2 == 0 {
            case.pulls.iter_mut().for_each(|pull| pull.error = 10f64.powf(cases.0.random_range(-3.0..-1.0)));
        }
        let round_wheels = round % 3 == 0;
        for pull in case.pulls.iter_mut().filter(|_| round_wheels) {
            pull.wheel = cases.0.random_bool(0.7).then(|| cases.wheel(pull));
        }
        let measure = case.measure();
        let Some(expansion) = Expansion::new(&measure, &case.positions()) else { continue };
        if !expansion.strayed[0].is_finite() {
            continue; // at an outlet within the error, a cable may not leave its wheel
        }
        let Some(normal) = expansion.normal(case.facet) else { continue };
        let mut facets = Facets::default();
        assert!(expansion.facets(case.facet, &mut facets));
        let wrench = |w: &[f64; 6]| case.rows(&Vector::new(w[0], w[1], w[2]), &Vector::new(w[3], w[4], w[5]));
        let load = wrench(&case.wrench.load.expect("a load")).map(|w| -w);
        let corners: Vec<Row> = case.wrench.vertices.iter().flatten().map(wrench).collect();
        let [force, moment] = [case.wrench.force, case.wrench.moment].map(|radius| radius.unwrap_or(0.0));
        let support = |c: &Row| {
            let [a, b] = [Vector::new(c[0], c[1], c[2]).norm(), Vector::new(c[3], c[4], c[5]).norm()];
            if case.counted == Counted::Moments { moment * a } else { force * a + moment * b }
        };
        for (k, pull) in case.pulls.iter().enumerate().filter(|(k, _)| case.facet >> k & 1 == 0) {
            let height = |x: &[f64; 3]| dot(&case.normal(&normal.center, x), &case.column(pull, x, &Vector::zeros()));
            let (largest, keeps) = facets.products[k];
            closest.keep("largest", &case, worst(|x| height(x).abs()) / (largest + ROUNDING));
            assert!(!keeps || worst(height) < 0.0 || worst(|x| -height(x)) < 0.0, "{case:?}");
        }
        assert_eq!(facets.sides.len(), 2 * corners.len().max(1));
        for (k, side) in facets.sides.iter().enumerate() {
            let (sign, corner) = (SIDES[k % 2], corners.get(k / 2).copied().unwrap_or_default());
            let load: Row = std::array::from_fn(|row| load[row] + corner[row]);
            let exact = |x: &[f64; 3], errors: bool| {
                let c = case.normal(&normal.center, x);
                let reach = if corners.is_empty() { support(&c) } else { 0.0 };
                case.slack(&c, sign, &load, x, errors) - reach
            };
            let low = |x: &[f64; 3]| {
                let size = size(&case.normal(&normal.center, x));
                (value(side, x) - (exact(x, true) - measure.floor() * size)) / (side.below + ROUNDING)
            };
            let high = |x: &[f64; 3]| (exact(x, false) - value(side, x)) / (side.above + ROUNDING);
            let [below, above] = match (round_wheels, round % 2 == 0) {
                (true, true) => ["below with wheels and errors", "above with wheels"],
                (true, false) => ["below with wheels", "above with wheels"],
                (false, true) => ["below with errors", "above"],
                (false, false) => ["below", "above"],
            };
            closest.keep(below, &case, worst(low));
            closest.keep(above, &case, worst(high));
            let least = -worst(|x| -exact(x, true)) + ROUNDING;
            assert!(side.least() <= least && side.greatest() >= worst(|x| exact(x, false)) - ROUNDING, "{case:?}");
        }
    }
    closest.reached(&[("below", 0.6), ("above", 0.95), ("below with errors", 0.8), ("largest", 0.99)]);
    closest.reached(&[("below with wheels", 0.5), ("above with wheels", 0.5), ("below with wheels and errors", 0.5)]);
}

/// A load just beyond a facet, anywhere on it, is within no facets that replace it.
#[test]
fn replaced_facets_do_not_hide_that_they_are_exceeded() {
    let mut cases = Cases(ChaCha8Rng::seed_from_u64(4));
    let (mut compared, mut within) = (0, 0);
    for round in 0..3000 {
        let case = cases.any([1e-4, 0.03, 0.2][round % 3]);
        let measure = case.measure();
        let Some(expansion) = Expansion::new(&measure, &case.positions()) else { continue };
        let Some(normal) = expansion.normal(case.facet) else { continue };
        let x: [f64; 3] = std::array::from_fn(|_| cases.0.random_range(-1.5..1.5f64).clamp(-1.0, 1.0));
        let normal = case.normal(&normal.center, &x);
        // Half of the loads are well within the set.
        let sign = SIDES[round % 2];
        let beyond = if round % 4 < 2 { 1e-3 } else { -cases.0.random_range(0.0..2.0) };
        let mut load: Row = normal.map(|c| sign * c * beyond / dot(&normal, &normal));
        for (k, pull) in case.pulls.iter().enumerate() {
            let column = case.column(pull, &x, &Vector::zeros());
            let [least, greatest] = pull.tension;
            let tension = match sign * dot(&normal, &column) {
                _ if case.facet >> k & 1 == 1 => least + (greatest - least) * cases.0.random_range(0.0..1.0),
                along if along > 0.0 => greatest,
                _ => least,
            };
            (0..ROWS).for_each(|row| load[row] += tension * column[row]);
        }
        let exact = case.slack(&normal, sign, &load, &x, false);
        assert!((exact + beyond).abs() < 1e-9, "{exact} {beyond}");
        let [a, b, c, d, e, f] = load.map(|w| -w);
        let load = match case.counted {
            Counted::Moments => [0.0, 0.0, 0.0, a, b, c],
            _ => [a, b, c, d, e, f],
        };
        let wrench = WrenchSpec { load: Some(load), ..WrenchSpec::default() };
        let measure = Case { wrench, ..case.clone() }.measure();
        let expansion = Expansion::new(&measure, &case.positions()).expect("long cables");
        let Some(sides) = replaced(&expansion, case.facet) else { continue };
        let suffices = sides.iter().all(|side| value(side, &x) >= side.below);
        assert!(beyond < 0.0 || !suffices, "{case:?}");
        compared += usize::from(beyond > 0.0);
        within += usize::from(suffices);
    }
    assert!(compared > 300 && within > 20, "{compared} {within}");
}

/// Directions orthogonal to cables side by side do not divide the circle of normals.
#[test]
fn cables_side_by_side_replace_no_facet() {
    let pull = |x: f64, y: f64, z: f64| {
        let unit = Vector::new(x, y, z).normalize();
        Pull { unit, length: 2.0, arm: Vector::zeros(), tension: [0.5, 1.0], error: 0.0, wheel: None }
    };
    let one = pull(0.2, -0.4, 1.0);
    let has_replacement = |other: Pull| {
        let case = Case {
            pulls: vec![pull(1.0, 0.1, 0.0), pull(-0.3, 1.0, 0.2), one, other],
            counted: Counted::PointMass,
            wrench: WrenchSpec::default(),
            half: Vector::repeat(0.01),
            facet: 0b11,
        };
        let measure = case.measure();
        replaced(&Expansion::new(&measure, &case.positions()).expect("long cables"), case.facet).is_some()
    };
    assert!(!has_replacement(one) && has_replacement(pull(-0.5, -0.4, -1.0)));
}
