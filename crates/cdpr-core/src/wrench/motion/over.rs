//! The facets of the measured set over a box of positions, each between two affine functions of the position.
//!
//! A facet is spanned by n − 1 cables. Let w be the columns at the centre of the box, c⁰ the unit normal of the facet there and uᵏ
//! the vectors with uᵏ·wⱼ = δₖⱼ for the cables of the facet and uᵏ·c⁰ = 0. Elsewhere in the box, where the columns are w + δ, the
//! normal is c = c⁰ + Σ yₖ uᵏ with (1 + E) y = −e, eⱼ = c⁰·δⱼ, Eⱼₖ = uᵏ·δⱼ: to first order y = −e, and the rest is at most
//! |E||y|, with |y| ≤ |e| / (1 − |E|). The columns turn with the cables, whose second derivatives are bounded (`BEND`). So c·wᵢ, the
//! product with the balance and the support of the required set are affine in the position, up to bounds of second order. At any
//! tension t within the limits, t c·wᵢ is no more than what a cable provides; the tension that is exact at the centre remains so
//! where c·wᵢ keeps its sign.
//!
//! If all facets have sufficient slack at a position, so has the whole set: where one of them has, the columns have full rank, and
//! every facet of a set of full rank is spanned by n − 1 of them.

use super::facets::{ROWS, Reach, shape};
use super::measure::{BEND, Measure};
use crate::geometry::{Cuboid, HalfSpace, Vector};
use crate::tolerances::{FACET_DUAL, FACET_OVER_ROUNDING};

type Row = [f64; ROWS];

/// The slack to a facet, times the length of its normal, between two affine functions of the offset from the centre in half sides.
#[derive(Debug, Clone, Copy)]
struct FacetOver {
    /// The middle of the two at the centre, less what is required.
    at_center: f64,
    slope: [f64; 3],
    /// It is at most this much lower than the affine function, and at most this much higher.
    below: f64,
    above: f64,
}

impl FacetOver {
    fn sway(&self) -> f64 {
        self.slope.iter().map(|slope| slope.abs()).sum()
    }

    /// Whether the slack suffices in the whole box.
    fn suffices(&self) -> bool {
        self.at_center - self.sway() - self.below >= 0.0
    }

    /// Whether the slack is negative in the whole box.
    fn lacks(&self) -> bool {
        self.at_center + self.sway() + self.above < 0.0
    }

    /// An upper bound of the smallest slack to the facet in the box.
    fn lowest(&self) -> f64 {
        self.at_center - self.sway() + self.above
    }

    /// The positions of the box where the slack certainly suffices, as a half-space; `None` if that is all of them.
    fn sufficing(&self, positions: &Cuboid) -> Option<HalfSpace> {
        (!self.suffices()).then(|| self.half_space(positions, -1.0, self.at_center - self.below))
    }

    /// The positions of the box where the slack certainly is negative.
    fn lacking(&self, positions: &Cuboid) -> HalfSpace {
        self.half_space(positions, 1.0, -(self.at_center + self.above))
    }

    /// The offsets x, in half sides, with sign · slope·x < room.
    fn half_space(&self, positions: &Cuboid, sign: f64, room: f64) -> HalfSpace {
        let gradient = Vector::from_fn(|axis, _| sign * self.slope[axis] / positions.half[axis]);
        let steep = gradient.norm();
        match gradient.try_normalize(0.0) {
            Some(normal) => HalfSpace::through(&(positions.center + normal * (room / steep)), normal),
            // Constant: everywhere or nowhere.
            None => {
                let far = positions.half.norm() * if room > 0.0 { 2.0 } else { -2.0 };
                HalfSpace::through(&(positions.center + Vector::x() * far), Vector::x())
            }
        }
    }
}

/// A cable's column over a box.
struct Column {
    center: Row,
    /// Derivatives for half a side along each axis.
    slopes: [Row; 3],
    /// The most by which it deviates from its tangent, and its products with normals and dual vectors from their values there.
    bend: f64,
    tension: [f64; 2],
}

/// What all facets have in common.
struct Over<'a> {
    reach: Reach<'a>,
    rows: usize,
    columns: Vec<Column>,
    balance: Row,
    floor: f64,
    rounding: f64,
}

fn dot(a: &Row, b: &Row) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn size(a: &Row) -> f64 {
    dot(a, a).sqrt()
}

/// Whether a bound shows that the slack is at least the floor everywhere in a box.
pub fn suffices(measure: &Measure, positions: &Cuboid) -> bool {
    let slack = measure.slack(&positions.center);
    let reach = positions.half.norm();
    slack >= measure.floor()
        && (slack - reach * measure.steepness(&positions.center, reach) >= measure.floor()
            || !measure.statics().has_errors() && facets_suffice(measure, positions))
}

/// Whether all facets have sufficient slack everywhere in a box.
fn facets_suffice(measure: &Measure, positions: &Cuboid) -> bool {
    let all = facets_over(measure, positions, |facets| facets.sides.iter().all(FacetOver::suffices));
    all.and_then(|all| replaced(measure, &all)).is_some_and(|others| others.iter().all(FacetOver::suffices))
}

/// Whether a bound shows that the slack is negative everywhere in a box: tighter than [`Measure::lacking`], but no
/// certificate has it. The outlets are the given ones, which are among those within their errors.
pub fn lacks(measure: &Measure, positions: &Cuboid) -> bool {
    let mut found = false;
    if measure.slack(&positions.center) < 0.0 {
        facets_over(measure, positions, |facets| {
            found = facets.sides.iter().any(FacetOver::lacks);
            !found
        });
    }
    found
}

/// Half-spaces in whose intersection with a box the slack certainly suffices, if such are known, and one in which it certainly is
/// negative.
pub fn cuts(measure: &Measure, positions: &Cuboid) -> (Option<Vec<HalfSpace>>, Option<HalfSpace>) {
    let (mut sufficing, mut lowest): (Vec<HalfSpace>, Option<FacetOver>) = (Vec::new(), None);
    let all = facets_over(measure, positions, |facets| {
        for facet in &facets.sides {
            sufficing.extend(facet.sufficing(positions));
            if lowest.is_none_or(|known| facet.lowest() < known.lowest()) {
                lowest = Some(*facet);
            }
        }
        true
    });
    let others = all.filter(|_| !measure.statics().has_errors()).and_then(|all| replaced(measure, &all));
    let sufficing = others.map(|others| {
        sufficing.extend(others.iter().filter_map(|facet| facet.sufficing(positions)));
        sufficing
    });
    (sufficing, lowest.filter(|facet| facet.lowest() < 0.0).map(|facet| facet.lacking(positions)))
}

/// What some cables span over a box.
struct Spanned {
    /// The cables, as a bit mask.
    cables: u32,
    /// The facets on both sides; `None` if their normal may vanish in the box.
    facets: Option<Facets>,
}

/// The facets that some cables span over a box, on both sides.
struct Facets {
    /// One for each side and each corner of the required set.
    sides: Vec<FacetOver>,
    /// For each cable, the largest product of its column with the normal, and whether the product keeps its sign.
    products: Vec<(f64, bool)>,
}

/// All facets of a measure over a box, until `visit` returns false for one; `None` then, and for robots with pulleys. The outlets are
/// the given ones.
fn facets_over(measure: &Measure, positions: &Cuboid, mut visit: impl FnMut(&Facets) -> bool) -> Option<Vec<Spanned>> {
    let over = Over::new(measure, positions)?;
    let count = over.columns.len();
    if count + 1 < over.rows {
        return None;
    }
    let mut all = Vec::new();
    let mut chosen: Vec<usize> = (0..over.rows - 1).collect();
    loop {
        let facets = over.facets(&chosen);
        if !facets.as_ref().is_none_or(&mut visit) {
            return None;
        }
        all.push(Spanned { cables: chosen.iter().map(|cable| 1 << cable).sum(), facets });
        // The next choice, in lexicographic order.
        let Some(k) = (0..chosen.len()).rev().find(|&k| chosen[k] + chosen.len() - k < count) else { return Some(all) };
        chosen[k] += 1;
        (k + 1..chosen.len()).for_each(|next| chosen[next] = chosen[next - 1] + 1);
    }
}

/// Lower bounds that together replace the facets whose normal may vanish; `None` if some cannot be replaced.
///
/// Let the cables of such a facet without one of them, e, keep their rank. The normals orthogonal to them form a circle, and in it
/// the slack is concave between two directions orthogonal to a further cable, if the tension of e is fixed. So it is nowhere less than
/// at those directions, less what e provides there; the columns of two further cables must not have the same direction.
fn replaced(measure: &Measure, all: &[Spanned]) -> Option<Vec<FacetOver>> {
    let cables = measure.statics().cables();
    let of = |mask: u32| all.iter().find(|spanned| spanned.cables == mask)?.facets.as_ref();
    let without = |lost: &Spanned, e: usize| -> Option<Vec<FacetOver>> {
        let rest = lost.cables & !(1 << e);
        let further: Vec<usize> = (0..cables.len()).filter(|k| lost.cables >> k & 1 == 0).collect();
        let facets = further.iter().map(|k| of(rest | 1 << k)).collect::<Option<Vec<_>>>()?;
        let differ =
            |(k, facets): (&usize, &&Facets)| further.iter().any(|other| other != k && facets.products[*other].1);
        further.iter().zip(&facets).any(differ).then_some(())?;
        let [least, greatest] = cables[e].tension;
        let less = |facets: &&Facets| {
            let lost = (greatest - least) * facets.products[e].0;
            facets.sides.iter().map(move |side| FacetOver { below: side.below + lost, ..*side }).collect::<Vec<_>>()
        };
        Some(facets.iter().flat_map(less).collect())
    };
    let lowest = |facets: &Vec<FacetOver>| {
        facets.iter().map(|facet| facet.at_center - facet.sway() - facet.below).fold(f64::INFINITY, f64::min)
    };
    let best = |lost: &Spanned| {
        let each = (0..cables.len()).filter(|e| lost.cables >> e & 1 == 1).filter_map(|e| without(lost, e));
        each.max_by(|a, b| lowest(a).total_cmp(&lowest(b)))
    };
    let found = all.iter().filter(|spanned| spanned.facets.is_none()).map(best).collect::<Option<Vec<_>>>()?;
    Some(found.concat())
}

impl<'a> Over<'a> {
    fn new(measure: &'a Measure, positions: &Cuboid) -> Option<Self> {
        let statics = measure.statics();
        if statics.has_pulleys() {
            return None;
        }
        let (reach, rows, [force, moment]) = shape(measure, statics);
        let ell = if force { statics.characteristic_length() } else { 1.0 };
        let radius = positions.half.norm();
        let column = |cable: &crate::wrench::StaticCable| {
            let line = cable.outlet - (positions.center + cable.arm);
            let length = line.norm();
            let shortest = length - radius;
            if !(shortest > 0.5 * length) {
                return None;
            }
            let unit = line / length;
            let wrench = |v: &Vector| {
                let turn = cable.arm.cross(v) / ell;
                match (force, moment) {
                    (true, true) => [v.x, v.y, v.z, turn.x, turn.y, turn.z],
                    (true, false) => [v.x, v.y, v.z, 0.0, 0.0, 0.0],
                    (false, _) => [turn.x, turn.y, turn.z, 0.0, 0.0, 0.0],
                }
            };
            let slope = |axis: usize| {
                let step = Vector::ith(axis, positions.half[axis]);
                wrench(&((unit * unit.dot(&step) - step) / length))
            };
            let bend = 0.5 * BEND * (radius / shortest).powi(2) * measure.lever(cable) + 2.0 * FACET_DUAL;
            let slopes = [0, 1, 2].map(slope);
            Some(Column { center: wrench(&unit), slopes, bend, tension: cable.tension })
        };
        let columns = statics.cables().iter().map(column).collect::<Option<Vec<_>>>()?;
        let [fx, fy, fz, mx, my, mz]: Row = (*statics.balance()).into();
        let length = statics.characteristic_length();
        let balance = match (force, moment) {
            (true, true) => [fx, fy, fz, mx, my, mz],
            (true, false) => [fx, fy, fz, 0.0, 0.0, 0.0],
            (false, _) => [mx * length, my * length, mz * length, 0.0, 0.0, 0.0],
        };
        let rounding = FACET_OVER_ROUNDING * (measure.edge() * columns.len() as f64 + size(&balance));
        Some(Over { reach, rows, columns, balance, floor: measure.floor(), rounding })
    }

    /// The facets that some cables span; `None` if their normal may vanish.
    fn facets(&self, chosen: &[usize]) -> Option<Facets> {
        let (normal, duals) = self.duals(chosen)?;
        let n = chosen.len();
        let column = |k: usize| &self.columns[chosen[k]];
        // yₖ = −Σ firstₖ x ± restₖ, |yₖ| ≤ mostₖ.
        let mut first = [[0.0; 3]; ROWS];
        let mut turned = [0.0; ROWS];
        let mut row_sum: f64 = 0.0;
        let mut mixing = [[0.0; ROWS]; ROWS];
        for j in 0..n {
            first[j] = column(j).slopes.map(|slope| dot(&normal, &slope));
            turned[j] = first[j].iter().map(|x| x.abs()).sum::<f64>() + column(j).bend;
            for k in 0..n {
                let along: f64 = column(j).slopes.iter().map(|slope| dot(&duals[k], slope).abs()).sum();
                mixing[j][k] = along + size(&duals[k]) * column(j).bend;
            }
            row_sum = row_sum.max(mixing[j][..n].iter().sum());
        }
        if !(row_sum < 0.5) {
            return None;
        }
        let mut products = vec![(0.0, false); self.columns.len()];
        let largest = turned.iter().fold(0.0f64, |a, b| a.max(*b)) / (1.0 - row_sum);
        let (mut rest, mut most) = ([0.0; ROWS], [0.0; ROWS]);
        for j in 0..n {
            let mixed = mixing[j][..n].iter().sum::<f64>() * largest;
            rest[j] = column(j).bend + mixed;
            most[j] = turned[j] + mixed;
        }
        // A product of the normal with a fixed vector: at the centre, slopes, and what is left.
        let product = |fixed: &Row| {
            let along: [f64; ROWS] = std::array::from_fn(|k| if k < n { dot(&duals[k], fixed) } else { 0.0 });
            let slope: [f64; 3] = std::array::from_fn(|axis| -(0..n).map(|k| first[k][axis] * along[k]).sum::<f64>());
            (dot(&normal, fixed), slope, (0..n).map(|k| rest[k] * along[k].abs()).sum::<f64>())
        };
        let spread: f64 = (0..n).map(|k| most[k] * size(&duals[k])).sum();
        let balance = product(&self.balance);
        let mut both = [FacetOver { at_center: 0.0, slope: [0.0; 3], below: 0.0, above: 0.0 }; 2];
        for (facet, sign) in both.iter_mut().zip([1.0, -1.0]) {
            facet.at_center = -sign * balance.0 - self.floor * (1.0 + spread) - self.rounding;
            facet.slope = balance.1.map(|slope| -sign * slope);
            (facet.below, facet.above) = (balance.2, balance.2 + self.floor * (1.0 + spread) + 2.0 * self.rounding);
        }
        for (i, other) in self.columns.iter().enumerate().filter(|(i, _)| !chosen.contains(i)) {
            let (height, mut slope, mut left) = product(&other.center);
            for (axis, slope) in slope.iter_mut().enumerate() {
                *slope += dot(&normal, &other.slopes[axis]);
            }
            left += other.bend;
            for k in 0..n {
                let along: f64 = other.slopes.iter().map(|slope| dot(&duals[k], slope).abs()).sum();
                left += most[k] * (along + size(&duals[k]) * other.bend);
            }
            let [least, greatest] = other.tension;
            let reach = slope.iter().map(|x| x.abs()).sum::<f64>() + left;
            products[i] = (height.abs() + reach, height.abs() > reach);
            for (facet, sign) in both.iter_mut().zip([1.0, -1.0]) {
                let tension = if sign * height > 0.0 { greatest } else { least };
                facet.at_center += tension * sign * height;
                (0..3).for_each(|axis| facet.slope[axis] += tension * sign * slope[axis]);
                facet.below += tension * left;
                // Where the sign changes, the other limit provides more.
                facet.above += tension * left + (greatest - least) * (reach - height.abs()).max(0.0);
            }
        }
        let supports = self.supports(&normal, &duals[..n], &first, &rest, spread);
        let with = |facet: &FacetOver, sign: f64| {
            let each = supports.iter().map(move |(support, sided)| {
                let turn = if *sided { sign } else { 1.0 };
                FacetOver {
                    at_center: facet.at_center - turn * support.at_center,
                    slope: std::array::from_fn(|axis| facet.slope[axis] - turn * support.slope[axis]),
                    below: facet.below + support.above,
                    above: facet.above + support.below,
                }
            });
            each.collect::<Vec<_>>()
        };
        let sides = both.iter().zip([1.0, -1.0]).flat_map(|(facet, sign)| with(facet, sign)).collect();
        Some(Facets { sides, products })
    }

    /// The support of the required set in the direction of the normal: the largest of these, each with whether it changes sign with
    /// the normal.
    fn supports(
        &self,
        normal: &Row,
        duals: &[Row],
        first: &[[f64; 3]; ROWS],
        rest: &[f64; ROWS],
        spread: f64,
    ) -> Vec<(FacetOver, bool)> {
        let affine = |fixed: &Row| {
            let along: Vec<f64> = duals.iter().map(|dual| dot(dual, fixed)).collect();
            let slope = |axis: usize| -along.iter().zip(first).map(|(along, first)| first[axis] * along).sum::<f64>();
            let left = along.iter().zip(rest).map(|(along, rest)| rest * along.abs()).sum();
            FacetOver { at_center: dot(normal, fixed), slope: [0, 1, 2].map(slope), below: left, above: left }
        };
        let part = |from: usize| -> Row { std::array::from_fn(|row| if row / 3 == from { normal[row] } else { 0.0 }) };
        let ball = |radius: f64, from: usize| {
            let part = part(from);
            let length = size(&part);
            if radius == 0.0 || length <= spread {
                // It may be anything up to the length of the normal's part.
                let most = radius * (length + spread);
                return FacetOver { at_center: 0.0, slope: [0.0; 3], below: 0.0, above: most };
            }
            // A norm is at least its tangent, and above it by at most the square over twice the length.
            let mut found = affine(&part.map(|x| radius * x / length));
            found.at_center = radius * length;
            found.above += radius * spread * spread / (2.0 * length);
            found
        };
        match &self.reach {
            Reach::Balls([force, moment]) => {
                let [a, b] = [ball(*force, 0), ball(*moment, 1)];
                let both = FacetOver {
                    at_center: a.at_center + b.at_center,
                    slope: std::array::from_fn(|axis| a.slope[axis] + b.slope[axis]),
                    below: a.below + b.below,
                    above: a.above + b.above,
                };
                vec![(both, false)]
            }
            Reach::Constant(radius) => vec![(ball(*radius, 0), false)],
            Reach::Polytope(corners, length) => {
                let corner = |w: &nalgebra::Vector6<f64>| {
                    let fixed = [w[0], w[1], w[2], w[3] / length, w[4] / length, w[5] / length];
                    (affine(&if self.rows == 3 { [w[0], w[1], w[2], 0.0, 0.0, 0.0] } else { fixed }), true)
                };
                corners.iter().map(corner).collect()
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

/// A direction that no robot has on purpose.
const GENERIC: Row = [0.371, 0.613, 0.237, 0.491, 0.709, 0.533];
