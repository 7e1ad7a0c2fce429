//! The facets of the measured set over a box of positions, each near a quadratic function of the position.
//!
//! A facet is spanned by n − 1 cables. Let w be their columns at the centre of the box, c⁰ the unit normal of the facet there and uᵏ
//! the vectors with uᵏ·wⱼ = δₖⱼ and uᵏ·c⁰ = 0. Elsewhere in the box, the columns have the directions of w + δ, where δ is linear in
//! the position (the cables are then not normalised), and the normal is c = c⁰ + Σ yₖ uᵏ with (1 + E) y = −e, eⱼ = c⁰·δⱼ,
//! Eⱼₖ = uᵏ·δⱼ. So y = −e + E e + E E y, and |y| ≤ z for any z with |e| + |E| z ≤ z (`majorant`). Instead of the columns, sums of
//! them with fixed coefficients serve as well, orthogonal ones where columns are nearly dependent in the same way at all positions.
//!
//! The columns wᵢ of the other cables are quadratic in the position, up to bounds on the third derivatives of directions. So are
//! c·wᵢ, the product with the balance and the support of the required set, up to bounds of third order. At any tension t within the
//! limits, t c·wᵢ is no more than what a cable provides; the tension that is exact at the centre remains so where c·wᵢ keeps its sign.

use crate::geometry::quadratic::{Curve, add, product, reach};
use crate::geometry::{Cuboid, Quadratic, Vector};
use crate::limits::MOST_WRENCH_CABLES;
use crate::tolerances::{FACET_DUAL, FACET_OVER_ROUNDING, MIN_CABLE_LENGTH};
use crate::wrench::motion::facets::{ROWS, Reach, shape};
use crate::wrench::motion::measure::{BEND, Measure};

type Row = [f64; ROWS];

/// A cable's column over a box.
struct Column {
    center: Row,
    /// Direction and length of the cable at the centre, and its lever, as a share of the characteristic length.
    unit: Vector,
    length: f64,
    arm: Vector,
    /// The most by which it deviates from its linear approximation, and from its quadratic one; and its products with normals and
    /// dual vectors from their values at the centre.
    bend: f64,
    third: f64,
    tension: [f64; 2],
}

/// What all facets over a box have in common.
pub struct Expansion<'a> {
    reach: Reach<'a>,
    rows: usize,
    counted: [bool; 2],
    half: Vector,
    columns: Vec<Column>,
    balance: Row,
    floor: f64,
    /// How much the slack can be smaller, and larger, than if each cable came from a fixed point: smaller also because the true outlets
    /// are not exactly the given ones.
    strayed: [f64; 2],
    rounding: f64,
}

/// The facets that some cables span over a box, on both sides.
#[derive(Debug, Clone)]
pub struct Facets {
    /// The slack times the length of the normal, less what is required: one for each side and each corner of the required set.
    pub sides: Vec<Quadratic>,
    /// For each cable, the largest product of its column with the normal, and whether the product keeps its sign.
    pub products: [(f64, bool); MOST_WRENCH_CABLES],
}

impl Default for Facets {
    fn default() -> Self {
        Facets { sides: Vec::new(), products: [(0.0, false); MOST_WRENCH_CABLES] }
    }
}

/// The normal of a facet over a box: c⁰ + Σ yₖ uᵏ.
struct Normal {
    center: Row,
    /// The number of cables of the facet.
    count: usize,
    duals: [Row; ROWS],
    /// Lengths of the dual vectors.
    sizes: Row,
    /// The coefficients yₖ without what is of higher order.
    slopes: [[f64; 3]; ROWS],
    curves: [Curve; ROWS],
    /// The most by which yₖ deviates from its quadratic and from its linear part.
    third: Row,
    second: Row,
    /// The most by which the normal deviates from its value at the centre, and from its linear part.
    spread: f64,
    bent: f64,
}

fn dot(a: &Row, b: &Row) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn size(a: &Row) -> f64 {
    dot(a, a).sqrt()
}

/// A bound of all y with |y| ≤ t + M |y|, where M and t have no negative elements: any z with t + M z ≤ z, if t is positive; `None` if
/// none is found.
fn majorant(matrix: &[Row; ROWS], least: &Row) -> Option<Row> {
    let next = |z: &Row| -> Row { std::array::from_fn(|j| least[j] + dot(&matrix[j], z)) };
    let mut z = *least;
    for _ in 0..MAJORANTS {
        let wider = next(&z).map(|z| z * (1.0 + WIDER));
        if next(&wider).iter().zip(&wider).all(|(next, z)| next <= z) {
            return Some(wider);
        }
        z = next(&next(&wider));
    }
    None
}

/// Attempts to find a majorant, and the factor, less one, by which each is widened: enough if each power of the matrix is a fifth
/// smaller than the one before.
const MAJORANTS: usize = 6;
const WIDER: f64 = 0.1;

/// Bound of the errors of the products of a normal and dual vectors with combinations of their columns.
const SKEW: f64 = 2.0 * ROWS as f64 * FACET_DUAL;

/// Number of times that each pair of combinations is made orthogonal: enough to be so up to rounding.
const SWEEPS: usize = 6;

impl Column {
    /// The product of the column with a fixed vector, as a function of the direction: m, such that it is m·u.
    fn weight(&self, fixed: &Row, [force, moment]: [bool; 2]) -> Vector {
        let [a, b] = [Vector::new(fixed[0], fixed[1], fixed[2]), Vector::new(fixed[3], fixed[4], fixed[5])];
        match (force, moment) {
            (true, true) => a + b.cross(&self.arm),
            (true, false) => a,
            (false, _) => a.cross(&self.arm),
        }
    }

    /// The linear part of m·u.
    fn slope(&self, m: &Vector, half: &Vector) -> [f64; 3] {
        let along = m.dot(&self.unit);
        std::array::from_fn(|a| half[a] * (along * self.unit[a] - m[a]) / self.length)
    }

    /// The quadratic part of m·u.
    fn curve(&self, m: &Vector, half: &Vector) -> Curve {
        let (u, along) = (&self.unit, m.dot(&self.unit));
        let step = half / self.length;
        let square = |a: usize| step[a] * step[a] * (along * (1.5 * u[a] * u[a] - 0.5) - m[a] * u[a]);
        let mixed = |a: usize, b: usize| step[a] * step[b] * (3.0 * along * u[a] * u[b] - m[a] * u[b] - m[b] * u[a]);
        [square(0), square(1), square(2), mixed(0, 1), mixed(0, 2), mixed(1, 2)]
    }
}

impl<'a> Expansion<'a> {
    /// The columns over a box; `None` if a cable comes close to its outlet. A cable with a pulley counts as coming from where it leaves
    /// its wheel at the centre.
    pub fn new(measure: &'a Measure, positions: &Cuboid) -> Option<Self> {
        let statics = measure.statics();
        let (reach, rows, counted) = shape(measure, statics);
        let ell = if counted[0] { statics.characteristic_length() } else { 1.0 };
        let radius = positions.half.norm();
        let mut turned = 0.0;
        let column = |cable: &crate::wrench::StaticCable| {
            let (origin, attachment) = (cable.origin_near(&positions.center, radius)?, positions.center + cable.arm);
            let line = origin.middle - attachment;
            let length = line.norm();
            let shortest = length - radius;
            if !(shortest > 0.5 * length && shortest >= MIN_CABLE_LENGTH) {
                return None;
            }
            let (unit, arm) = (line / length, cable.arm / ell);
            let turn = arm.cross(&unit);
            let center = match counted {
                [true, true] => [unit.x, unit.y, unit.z, turn.x, turn.y, turn.z],
                [true, false] => [unit.x, unit.y, unit.z, 0.0, 0.0, 0.0],
                [false, _] => [turn.x, turn.y, turn.z, 0.0, 0.0, 0.0],
            };
            let (way, lever) = (radius / shortest, measure.lever(cable));
            turned += cable.tension[1] * lever * origin.astray(&attachment, radius)?;
            let bend = 0.5 * BEND * way.powi(2) * lever + 2.0 * FACET_DUAL;
            let third = THIRD / 6.0 * way.powi(3) * lever + 2.0 * FACET_DUAL;
            Some(Column { center, unit, length, arm, bend, third, tension: cable.tension })
        };
        let columns = statics.cables().iter().map(column).collect::<Option<Vec<_>>>()?;
        let [fx, fy, fz, mx, my, mz]: Row = (*statics.balance()).into();
        let length = statics.characteristic_length();
        let balance = match counted {
            [true, true] => [fx, fy, fz, mx, my, mz],
            [true, false] => [fx, fy, fz, 0.0, 0.0, 0.0],
            [false, _] => [mx * length, my * length, mz * length, 0.0, 0.0, 0.0],
        };
        let rounding = FACET_OVER_ROUNDING * (measure.edge() * columns.len() as f64 + size(&balance));
        let strayed = [turned + measure.loss_within(&positions.center, radius), turned];
        let floor = measure.floor();
        Some(Expansion { reach, rows, counted, half: positions.half, columns, balance, floor, strayed, rounding })
    }

    /// Number of cables.
    pub fn cables(&self) -> usize {
        self.columns.len()
    }

    /// The least and the greatest tension of a cable.
    pub fn tension(&self, cable: usize) -> [f64; 2] {
        self.columns[cable].tension
    }

    /// The product of a cable's column with a fixed vector: its slope and curve.
    fn moving(&self, cable: usize, fixed: &Row) -> ([f64; 3], Curve) {
        let column = &self.columns[cable];
        let m = column.weight(fixed, self.counted);
        (column.slope(&m, &self.half), column.curve(&m, &self.half))
    }

    /// The facets that the cables of a bit mask span; false if their normal may vanish in the box.
    pub fn facets(&self, cables: u32, found: &mut Facets) -> bool {
        let Some(normal) = self.normal(cables) else { return false };
        let balance = normal.product(&self.balance);
        let required = self.floor * (1.0 + normal.spread);
        let mut both = [Quadratic::default(); 2];
        for (facet, sign) in both.iter_mut().zip(SIDES) {
            facet.add(-sign, &balance);
            facet.at_center -= required + self.rounding;
            facet.below += self.strayed[0] * (1.0 + normal.spread);
            facet.above += self.strayed[1] * (1.0 + normal.spread) + required + 2.0 * self.rounding;
        }
        for (i, other) in self.columns.iter().enumerate() {
            if cables >> i & 1 == 1 {
                found.products[i] = (0.0, false);
                continue;
            }
            let height = self.height(i, &normal);
            let [least, greatest] = other.tension;
            let way = reach(&height.slope) + reach(&height.curve) + height.above;
            let middle = height.at_center.abs();
            found.products[i] = (middle + way, middle > way);
            for (facet, sign) in both.iter_mut().zip(SIDES) {
                facet.add(sign * if sign * height.at_center > 0.0 { greatest } else { least }, &height);
                // Where the sign changes, the other limit provides more.
                facet.above += (greatest - least) * (way - middle).max(0.0);
            }
        }
        found.sides.clear();
        self.less_required(&normal, &both, &mut found.sides);
        true
    }

    /// The product of a normal with the column of another cable.
    fn height(&self, cable: usize, normal: &Normal) -> Quadratic {
        let other = &self.columns[cable];
        let mut height = normal.product(&other.center);
        let (slope, curve) = self.moving(cable, &normal.center);
        (0..3).for_each(|axis| height.slope[axis] += slope[axis]);
        add(&mut height.curve, 1.0, &curve);
        let mut left = other.third;
        for k in 0..normal.count {
            let m = other.weight(&normal.duals[k], self.counted);
            let along = other.slope(&m, &self.half);
            add(&mut height.curve, 1.0, &product(&normal.slopes[k], &along));
            let bend = normal.sizes[k] * other.bend;
            left += normal.second[k] * (reach(&along) + bend) + reach(&normal.slopes[k]) * bend;
        }
        height.below += left;
        height.above += left;
        height
    }

    /// The normal that some cables span; `None` if it may vanish.
    fn normal(&self, cables: u32) -> Option<Normal> {
        let mut chosen = [0; ROWS];
        let mut count = 0;
        for cable in (0..self.columns.len()).filter(|cable| cables >> cable & 1 == 1) {
            chosen[count] = cable;
            count += 1;
        }
        let chosen = &chosen[..count];
        let (center, duals) = self.duals(chosen)?;
        let plain = std::array::from_fn(|j| std::array::from_fn(|k| f64::from(u8::from(j == k))));
        self.turned(chosen, &center, duals, &plain).or_else(|| {
            let axes = self.axes(chosen);
            let sum = |k: usize| -> Row {
                std::array::from_fn(|row| (0..count).map(|i| axes[k][i] * duals[i][row]).sum::<f64>())
            };
            let duals = std::array::from_fn(|k| if k < count { sum(k) } else { [0.0; ROWS] });
            self.turned(chosen, &center, duals, &axes)
        })
    }

    /// The normal by combinations of columns, orthogonal to each other as sums with the coefficients in a row of `combined`, and the
    /// dual vectors of these; `None` if it may vanish.
    fn turned(&self, chosen: &[usize], center: &Row, duals: [Row; ROWS], combined: &[Row; ROWS]) -> Option<Normal> {
        let count = chosen.len();
        let sizes = duals.map(|dual| size(&dual));
        let zero = [0.0; ROWS];
        // The slope of the product of a fixed vector with each combination.
        let slopes = |fixed: &Row| -> [[f64; 3]; ROWS] {
            let mut each = [[0.0; 3]; ROWS];
            for (i, of) in chosen.iter().enumerate() {
                let column = &self.columns[*of];
                let m = column.weight(fixed, self.counted);
                let slope: [f64; 3] = std::array::from_fn(|axis| -self.half[axis] * m[axis] / column.length);
                for (j, sum) in each.iter_mut().enumerate().take(count) {
                    (0..3).for_each(|axis| sum[axis] += combined[j][i] * slope[axis]);
                }
            }
            each
        };
        let first = slopes(center);
        let mut turned = zero;
        (0..count).for_each(|j| turned[j] = reach(&first[j]) + SKEW);
        // Eⱼₖ: its slope by k and j, and its largest value by j and k.
        let (mut mix, mut mixing) = ([[[0.0; 3]; ROWS]; ROWS], [zero; ROWS]);
        for k in 0..count {
            mix[k] = slopes(&duals[k]);
            (0..count).for_each(|j| mixing[j][k] = reach(&mix[k][j]) + sizes[k] * SKEW);
        }
        let most = majorant(&mixing, &turned)?;
        let mixed = mixing.map(|row| dot(&row, &most));
        let (mut curves, mut third, mut second) = ([[0.0; 6]; ROWS], zero, zero);
        for j in 0..count {
            second[j] = SKEW + mixed[j];
            third[j] = SKEW;
            for k in 0..count {
                add(&mut curves[j], 1.0, &product(&mix[k][j], &first[k]));
                third[j] += sizes[k] * SKEW * turned[k] + mixing[j][k] * (SKEW + mixed[k]);
            }
        }
        let slopes = first.map(|slope| slope.map(|x| -x));
        let [spread, bent] = [&most, &second].map(|parts| dot(parts, &sizes));
        Some(Normal { center: *center, count, duals, sizes, slopes, curves, third, second, spread, bent })
    }

    /// The directions in which some cables' columns extend most and least: rows of coefficients of their sums, orthogonal to each other
    /// (C. G. J. Jacobi, 1846).
    fn axes(&self, chosen: &[usize]) -> [Row; ROWS] {
        let n = chosen.len();
        let column = |k: usize| &self.columns[chosen[k]].center;
        let mut products = [[0.0; ROWS]; ROWS];
        let mut axes = [[0.0; ROWS]; ROWS];
        for j in 0..n {
            axes[j][j] = 1.0;
            (0..n).for_each(|k| products[j][k] = dot(column(j), column(k)));
        }
        for (p, q) in (0..SWEEPS).flat_map(|_| (0..n).flat_map(|p| (p + 1..n).map(move |q| (p, q)))) {
            let across = products[p][q];
            if across == 0.0 {
                continue;
            }
            let ratio = (products[q][q] - products[p][p]) / (2.0 * across);
            let tangent = 1.0f64.copysign(ratio) / (ratio.abs() + (1.0 + ratio * ratio).sqrt());
            let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
            let sine = tangent * cosine;
            let turn = |a: &mut f64, b: &mut f64| (*a, *b) = (cosine * *a - sine * *b, sine * *a + cosine * *b);
            for row in products.iter_mut() {
                let [mut a, mut b] = [row[p], row[q]];
                turn(&mut a, &mut b);
                (row[p], row[q]) = (a, b);
            }
            for matrix in [&mut products, &mut axes] {
                for k in 0..n {
                    let [mut a, mut b] = [matrix[p][k], matrix[q][k]];
                    turn(&mut a, &mut b);
                    (matrix[p][k], matrix[q][k]) = (a, b);
                }
            }
        }
        axes
    }

    /// Both facets, less the support of the required set in the direction of the normal: one for each of its corners.
    fn less_required(&self, normal: &Normal, both: &[Quadratic; 2], sides: &mut Vec<Quadratic>) {
        let mut with = |support: &Quadratic, turns: bool| {
            for (facet, sign) in both.iter().zip(SIDES) {
                let mut side = *facet;
                side.add(if turns { -sign } else { -1.0 }, support);
                sides.push(side);
            }
        };
        match &self.reach {
            Reach::Balls([force, moment]) => {
                let mut support = normal.ball(*force, 0);
                support.add(1.0, &normal.ball(*moment, 1));
                with(&support, false);
            }
            Reach::Constant(radius) => with(&normal.ball(*radius, 0), false),
            Reach::Polytope(corners, length) => {
                for w in corners.iter() {
                    let fixed = [w[0], w[1], w[2], w[3] / length, w[4] / length, w[5] / length];
                    let fixed = if self.rows == 3 { [w[0], w[1], w[2], 0.0, 0.0, 0.0] } else { fixed };
                    with(&normal.product(&fixed), true);
                }
            }
        }
    }

    /// The unit normal of a facet at the centre, and the dual vectors of its columns; `None` if they are almost dependent.
    fn duals(&self, chosen: &[usize]) -> Option<(Row, [Row; ROWS])> {
        let n = self.rows;
        let mut matrix = [[0.0; 2 * ROWS]; ROWS];
        for (row, entries) in matrix.iter_mut().enumerate().take(n) {
            match chosen.get(row) {
                Some(cable) => entries[..n].copy_from_slice(&self.columns[*cable].center[..n]),
                None => entries[..n].copy_from_slice(&GENERIC[..n]),
            }
            entries[n + row] = 1.0;
        }
        // The inverse by Gauss and Jordan; its columns are the dual vectors of the rows.
        for pivot in 0..n {
            let best = (pivot..n).max_by(|a, b| matrix[*a][pivot].abs().total_cmp(&matrix[*b][pivot].abs()))?;
            matrix.swap(pivot, best);
            let scale = matrix[pivot][pivot];
            if !(scale.abs() > FACET_DUAL) {
                return None;
            }
            matrix[pivot].iter_mut().for_each(|x| *x /= scale);
            let line = matrix[pivot];
            for (row, entries) in matrix.iter_mut().enumerate().take(n) {
                let factor = entries[pivot];
                if row != pivot && factor != 0.0 {
                    entries.iter_mut().zip(&line).for_each(|(x, y)| *x -= factor * y);
                }
            }
        }
        let dual = |k: usize| -> Row { std::array::from_fn(|row| if row < n { matrix[row][n + k] } else { 0.0 }) };
        let last = dual(n - 1);
        let length = size(&last);
        let normal = last.map(|x| x / length);
        let mut duals = [[0.0; ROWS]; ROWS];
        for (k, found) in duals.iter_mut().enumerate().take(n - 1) {
            let raw = dual(k);
            let along = dot(&raw, &normal);
            *found = std::array::from_fn(|row| raw[row] - along * normal[row]);
        }
        let exact = (0..n - 1).all(|j| {
            let column = &self.columns[chosen[j]].center;
            let product = |k: usize| dot(&duals[k], column) - if j == k { 1.0 } else { 0.0 };
            let small = |k: usize| product(k).abs() <= FACET_DUAL * size(&duals[k]).min(1.0);
            dot(&normal, column).abs() <= FACET_DUAL && (0..n - 1).all(small)
        });
        (exact && length.is_finite()).then_some((normal, duals))
    }
}

impl Normal {
    /// The product with a fixed vector.
    fn product(&self, fixed: &Row) -> Quadratic {
        let mut found = Quadratic { at_center: dot(&self.center, fixed), ..Quadratic::default() };
        for k in 0..self.count {
            let along = dot(&self.duals[k], fixed);
            (0..3).for_each(|axis| found.slope[axis] += along * self.slopes[k][axis]);
            add(&mut found.curve, along, &self.curves[k]);
            found.below += self.third[k] * along.abs();
        }
        found.above = found.below;
        found
    }

    /// The length of a part of the normal, times a radius: of the first or the last three rows.
    ///
    /// Let a be the part at the centre and b its change. The length of a + b is |a| + b·a/|a| + b⊥²/(2|a|), where b⊥ is across a;
    /// the third derivative of a length l along a line is at most `BEND`/l².
    fn ball(&self, radius: f64, part: usize) -> Quadratic {
        let of = |row: &Row| Vector::new(row[3 * part], row[3 * part + 1], row[3 * part + 2]);
        let a = of(&self.center);
        let length = a.norm();
        if radius == 0.0 || !(length > 2.0 * self.spread) {
            // It may be anything up to the length of the normal's part.
            return Quadratic { above: radius * (length + self.spread), ..Quadratic::default() };
        }
        let unit = a / length;
        let fixed: Row = std::array::from_fn(|row| if row / 3 == part { unit[row % 3] } else { 0.0 });
        let mut found = self.product(&fixed);
        let change = |axis: usize| {
            let b: Vector = (0..self.count).map(|k| of(&self.duals[k]) * self.slopes[k][axis]).sum();
            (b - unit * unit.dot(&b)) / (2.0 * length).sqrt()
        };
        let across = [0, 1, 2].map(change);
        for row in 0..3 {
            let b = across.map(|across| across[row]);
            add(&mut found.curve, 1.0, &product(&b, &b));
        }
        let left = self.bent * (2.0 * self.spread + self.bent) / (2.0 * length)
            + BEND / 6.0 * self.spread.powi(3) / (length - self.spread).powi(2);
        found.below += left;
        found.above += left;
        let mut scaled = Quadratic::default();
        scaled.add(radius, &found);
        scaled
    }
}

/// Maximum third derivative of a direction to a fixed point at distance l, times l³, along a line at unit speed: with x the cosine
/// of the angle between line and direction's normal, x √(36 − 72 x² + 45 x⁴) is largest at x = 1.
const THIRD: f64 = 3.0;

/// The signs of the normal on both sides.
const SIDES: [f64; 2] = [1.0, -1.0];

/// A direction that no robot has on purpose.
const GENERIC: Row = [0.371, 0.613, 0.237, 0.491, 0.709, 0.533];

#[cfg(test)]
mod tests;
