//! The facets of the measured set along a straight motion, each as a polynomial that is bounded from below.
//!
//! Without normalisation by its length, a cable's column is affine in the position. A facet's normal c is the cross
//! product of n − 1 of these columns, and c, c·wᵢ for every other column and c·w_r are polynomials of degree at most 3:
//! in axes whose first one is along the motion, only three of the six rows depend on the position. So their values at
//! four points determine them, and in Bernstein form their coefficients bound them. Only the lengths of the cables that
//! are not in the facet are not polynomials: their inverses are interpolated, with a bound of the error.
//! docs/understand/wrench.md has the proof.
//!
//! A cable with a pulley counts as coming from a point that moves evenly between its exits at both ends of the motion: its column
//! still is affine, and its true direction differs by a term of second order ([`Facets::loss`]). But columns that do not all change
//! by the same vector give polynomials of degree up to 6. Through four points of them goes a cubic all the same; it differs by
//! what only the exits' moves contribute to the fourth derivative.

use super::measure::Measure;
use crate::geometry::{Point, Vector};
use crate::limits::MOST_WRENCH_CABLES;
use crate::simd::{Kernel, Lanes, Task};
use crate::tolerances::{FACET_NO_NORMAL, FACET_ROUNDING, MIN_CABLE_LENGTH};
use crate::wrench::set::Required;
use crate::wrench::statics::{StaticCable, Statics};

/// Coefficients of a cubic in Bernstein form, or its values at 0, 1/3, 2/3 and 1.
type Cubic = [f64; 4];

/// Rows of a wrench.
pub(super) const ROWS: usize = 6;

/// Sets of rows as bit masks: for each set, a minor of the columns chosen so far.
const SETS: usize = 1 << ROWS;

/// A cable along a motion.
#[derive(Debug, Clone, Copy)]
struct Column {
    /// The column, without normalisation by the cable's length, at 0, 1/3, 2/3 and 1.
    places: [Cubic; ROWS],
    /// Maximum length of the cable.
    largest: f64,
    /// Outlet minus attachment at the start of the motion, and how much it decreases along it.
    line: [f64; 3],
    step: [f64; 3],
    tension: [f64; 2],
    /// The inverse of the cable's length along the whole motion.
    inverse: Inverse,
}

/// The inverse of a cable's length on a piece of the motion: a parabola in Bernstein form, and its maximum error.
#[derive(Debug, Clone, Copy, Default)]
struct Inverse {
    parabola: [f64; 3],
    error: f64,
}

/// A pair of parallel facets along a motion: the one with this normal, and the one with the opposite normal.
#[derive(Debug, Clone)]
pub struct FacetPair {
    /// The normal, not of unit length.
    normal: [Cubic; ROWS],
    /// Product of the normal with the wrench to be balanced.
    balance: Cubic,
    /// The cables that are not in the facet, and the products of their columns with the normal.
    others: [(usize, Cubic); MOST_WRENCH_CABLES],
    count: usize,
    /// Scale of rounding errors: the product of the lengths of the columns in the facet.
    scale: f64,
}

/// Bounds for a pair of facets on a piece of the motion.
#[derive(Debug, Clone, Copy)]
pub struct Bounds {
    /// Whether the slack to both facets is at least the requested value along the whole piece.
    pub holds: bool,
    /// The smaller slack of the two facets in the middle of the piece; `None` if the normal is too uncertain.
    pub middle: Option<f64>,
}

/// All facets of a measured set along a straight motion.
pub struct Facets<'a> {
    reach: Reach<'a>,
    columns: [Column; MOST_WRENCH_CABLES],
    cables: usize,
    /// Three rows (forces alone, moments alone, a point mass) or six.
    rows: usize,
    balance: [f64; ROWS],
    /// Maximum length of the edges of the measured set, and the wrench to be balanced, N or N·m.
    edge: f64,
    /// How much smaller the slack can be in the middle of the motion than if exits moved evenly.
    loss: f64,
    /// How far normals, and products of columns with them, can be from the cubics, as shares of the product of the columns' lengths.
    beside: [f64; 2],
    kernel: Kernel,
}

/// Support function of the required set.
pub(super) enum Reach<'a> {
    Balls([f64; 2]),
    Constant(f64),
    Polytope(&'a [nalgebra::Vector6<f64>], f64),
}

impl Reach<'_> {
    /// The support function's Lipschitz constant.
    fn most(&self) -> f64 {
        match self {
            Reach::Balls([force, moment]) => force + moment,
            Reach::Constant(radius) => *radius,
            Reach::Polytope(corners, length) => {
                let size = |w: &nalgebra::Vector6<f64>| {
                    w.fixed_rows::<3>(0).norm().hypot(w.fixed_rows::<3>(3).norm() / length)
                };
                corners.iter().map(size).fold(0.0, f64::max)
            }
        }
    }

    #[inline]
    fn of(&self, c: &[f64; ROWS], sign: f64) -> f64 {
        match self {
            Reach::Balls([force, moment]) => {
                let moments = if *moment == 0.0 { 0.0 } else { moment * norm(&[c[3], c[4], c[5]]) };
                let forces = if *force == 0.0 { 0.0 } else { force * norm(&[c[0], c[1], c[2]]) };
                forces + moments
            }
            Reach::Constant(radius) => radius * norm(&[c[0], c[1], c[2]]),
            Reach::Polytope(corners, length) => {
                let along = |w: &nalgebra::Vector6<f64>| {
                    let moment = (c[3] * w[3] + c[4] * w[4] + c[5] * w[5]) / length;
                    sign * (c[0] * w[0] + c[1] * w[1] + c[2] * w[2] + moment)
                };
                corners.iter().map(along).fold(f64::NEG_INFINITY, f64::max)
            }
        }
    }
}

#[inline]
fn norm(v: &[f64; 3]) -> f64 {
    (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt()
}

#[inline]
fn size(c: &[f64; ROWS]) -> f64 {
    c.iter().map(|x| x * x).sum::<f64>().sqrt()
}

impl<'a> Facets<'a> {
    /// The facets of a measure between two positions; `None` if there are too many cables, or if a cable comes too
    /// close to its outlet to have a direction.
    pub fn new(measure: &'a Measure, from: &Point, to: &Point) -> Option<Self> {
        let statics = measure.statics();
        let cables = statics.cables().len();
        if cables > MOST_WRENCH_CABLES {
            return None;
        }
        let (reach, rows, [force, moment]) = shape(measure, statics);
        let balance: [f64; ROWS] = (*statics.balance()).into();
        let [fx, fy, fz, mx, my, mz] = balance;
        // Forces first; moments alone occupy the first three rows, in N·m.
        let ell = statics.characteristic_length();
        let balance = match (force, rows) {
            (true, 3) => [fx, fy, fz, 0.0, 0.0, 0.0],
            (false, _) => [mx * ell, my * ell, mz * ell, 0.0, 0.0, 0.0],
            _ => balance,
        };
        let step = to - from;
        let none = Column {
            places: [[0.0; 4]; ROWS],
            largest: 0.0,
            line: [0.0; 3],
            step: [0.0; 3],
            tension: [0.0; 2],
            inverse: Inverse::default(),
        };
        let mut facets = Facets {
            reach,
            columns: [none; MOST_WRENCH_CABLES],
            cables,
            rows,
            balance,
            edge: measure.edge() + size(&balance),
            loss: if statics.has_pulleys() { measure.loss_of_even_exits(from, to) } else { 0.0 },
            beside: [0.0; 2],
            kernel: Kernel::best(),
        };
        if facets.loss == f64::INFINITY {
            return None;
        }
        let wrench = |cable: &StaticCable, line: &Vector| -> [f64; ROWS] {
            let turn = if moment { cable.arm.cross(line) / if force { ell } else { 1.0 } } else { line * 0.0 };
            let [first, last] = if force { [*line, turn] } else { [turn, line * 0.0] };
            [first.x, first.y, first.z, last.x, last.y, last.z]
        };
        // How far columns move at most, and how far exits move them, as shares of their lengths.
        let (mut moved, mut swayed) = (0.0f64, 0.0f64);
        for (column, cable) in facets.columns.iter_mut().zip(statics.cables()) {
            let exit = cable.exit(from)?;
            let sway = if cable.pulley.is_some() { cable.exit(to)? - exit } else { Vector::zeros() };
            let (start, own) = (exit - (from + cable.arm), step - sway);
            (column.line, column.step, column.tension) = (start.into(), own.into(), cable.tension);
            for k in 0..4 {
                let wrench = wrench(cable, &(start - own * (k as f64 / 3.0)));
                for row in 0..rows {
                    column.places[row][k] = wrench[row];
                }
                let squared: f64 = (0..rows).map(|row| column.places[row][k].powi(2)).sum();
                column.largest = column.largest.max(squared.sqrt());
            }
            moved = moved.max(size(&wrench(cable, &step)) / column.largest);
            swayed = swayed.max(size(&wrench(cable, &sway)) / column.largest);
        }
        if rows == ROWS && swayed > 0.0 {
            let more = (moved + swayed).powi(4) - moved.powi(4);
            facets.beside = [5.0, 15.0].map(|choices| choices * CUBIC * more);
        }
        for k in 0..cables {
            facets.columns[k].inverse = facets.inverse(k, 0.0, 1.0)?;
        }
        Some(facets)
    }

    /// How much smaller the slack at a fraction s of the motion can be, divided by 4 s (1 - s), than bounds of facets tell, because exits
    /// do not move evenly.
    pub fn loss(&self) -> f64 {
        self.loss
    }

    /// The inverse of a cable's length on a piece; `None` if it becomes too short there.
    ///
    /// On a line at unit speed the third derivative of 1/l is at most 6/l⁴, so the parabola through both ends and the
    /// middle of a piece of length s is off by at most √3/36 s³/l⁴ (l the least length on the piece).
    #[inline]
    fn inverse(&self, cable: usize, from: f64, to: f64) -> Option<Inverse> {
        let Column { line: [x, y, z], step: [dx, dy, dz], .. } = self.columns[cable];
        let length = |t: f64| norm(&[x - dx * t, y - dy * t, z - dz * t]);
        let squared = dx * dx + dy * dy + dz * dz;
        let foot = ((x * dx + y * dy + z * dz) / squared).clamp(from, to);
        let least = length(foot);
        if !(least >= MIN_CABLE_LENGTH) {
            return None;
        }
        let [first, middle, last] = [from, 0.5 * (from + to), to].map(|t| 1.0 / length(t));
        let way = (to - from) * squared.sqrt() / least;
        Some(Inverse {
            parabola: [first, 2.0 * middle - 0.5 * (first + last), last],
            error: INTERPOLATION * way * way * way / least + 1e-15 / least,
        })
    }

    /// Calls `visit` with every pair of facets until it returns false; also returns false if there is no facet at all.
    pub fn all(&self, visit: &mut dyn FnMut(&FacetPair) -> bool) -> bool {
        let mut pair = FacetPair {
            normal: [[0.0; 4]; ROWS],
            balance: [0.0; 4],
            others: [(0, [0.0; 4]); MOST_WRENCH_CABLES],
            count: 0,
            scale: 0.0,
        };
        let mut minors = [[[0.0; 4]; SETS]; ROWS];
        minors[0][0] = [1.0; 4];
        let mut any = false;
        let mut chosen = [0; ROWS];
        let mut ended = |pair: &FacetPair| {
            any = true;
            visit(pair)
        };
        let through = match self.rows {
            3 => self.descend::<3>(0, 0, &mut minors, 1.0, &mut chosen, &mut pair, &mut ended),
            _ => self.descend::<6>(0, 0, &mut minors, 1.0, &mut chosen, &mut pair, &mut ended),
        };
        through && any
    }

    /// Chooses columns from `next` on until there are N − 1; `minors` starts with those of the columns chosen so far.
    #[allow(clippy::too_many_arguments)]
    fn descend<const N: usize>(
        &self,
        level: usize,
        next: usize,
        minors: &mut [[Cubic; SETS]],
        scale: f64,
        chosen: &mut [usize; ROWS],
        pair: &mut FacetPair,
        visit: &mut dyn FnMut(&FacetPair) -> bool,
    ) -> bool {
        let (own, larger) = minors.split_first_mut().expect("a level for each column");
        if level == N - 1 {
            return !self.finish::<N>(own, scale, chosen, pair) || visit(pair);
        }
        for cable in next..(self.cables + 2 + level).saturating_sub(N) {
            let column = &self.columns[cable];
            self.expand::<N>(level + 1, own, &column.places, &mut larger[0]);
            chosen[level] = cable;
            if !self.descend::<N>(level + 1, cable + 1, larger, scale * column.largest, chosen, pair, visit) {
                return false;
            }
        }
        true
    }

    #[inline]
    fn expand<const N: usize>(
        &self,
        level: usize,
        minors: &[Cubic; SETS],
        column: &[Cubic; ROWS],
        larger: &mut [Cubic; SETS],
    ) {
        match level {
            1 => self.kernel.run(Expand::<N, 1> { minors, column, larger }),
            2 => self.kernel.run(Expand::<N, 2> { minors, column, larger }),
            3 => self.kernel.run(Expand::<N, 3> { minors, column, larger }),
            4 => self.kernel.run(Expand::<N, 4> { minors, column, larger }),
            _ => self.kernel.run(Expand::<N, 5> { minors, column, larger }),
        }
    }

    /// Whether some columns whose normal vanishes at 0, 1/3, 2/3 and 1 are dependent along the whole motion, although each moves in its own
    /// way: a polynomial of degree 5 that vanishes at two more points vanishes. The length of the normal is the product of those of
    /// the columns, each without its parts along those before it.
    fn dependent(&self, chosen: &[usize], scale: f64) -> bool {
        let normal = |s: f64| {
            let (mut units, mut volume) = ([[0.0; ROWS]; ROWS], 1.0);
            for (n, &cable) in chosen.iter().enumerate() {
                let mut own = self.columns[cable].places.map(|[a, .., b]| a + s * (b - a));
                for unit in &units[..n] {
                    let along: f64 = own.iter().zip(unit).map(|(a, b)| a * b).sum();
                    own.iter_mut().zip(unit).for_each(|(a, b)| *a -= along * b);
                }
                let length = size(&own);
                volume *= length;
                units[n] = own.map(|a| if length > 0.0 { a / length } else { 0.0 });
            }
            volume
        };
        [0.25, 0.75].into_iter().all(|s| normal(s) <= FACET_NO_NORMAL * scale)
    }

    /// The pair of facets of the chosen columns; false if they are dependent along the whole motion.
    fn finish<const N: usize>(
        &self,
        minors: &[Cubic; SETS],
        scale: f64,
        chosen: &[usize; ROWS],
        pair: &mut FacetPair,
    ) -> bool {
        let all = (1 << N) - 1;
        let mut largest = 0.0f64;
        for row in 0..N {
            let sign = if row % 2 == 0 { 1.0 } else { -1.0 };
            let minor = &minors[all ^ (1 << row)];
            for k in 0..4 {
                pair.normal[row][k] = sign * minor[k];
                largest = largest.max(minor[k].abs());
            }
        }
        if largest <= FACET_NO_NORMAL * scale
            && (N < ROWS || self.beside[0] == 0.0 || self.dependent(&chosen[..N - 1], scale))
        {
            return false;
        }
        pair.scale = scale;
        pair.count = 0;
        for cable in (0..self.cables).filter(|cable| !chosen[..N - 1].contains(cable)) {
            let places = &self.columns[cable].places;
            let mut height = [0.0; 4];
            for row in 0..N {
                for k in 0..4 {
                    height[k] += pair.normal[row][k] * places[row][k];
                }
            }
            pair.others[pair.count] = (cable, bernstein(&height));
            pair.count += 1;
        }
        let mut balance = [0.0; 4];
        for row in 0..N {
            for k in 0..4 {
                balance[k] += pair.normal[row][k] * self.balance[row];
            }
        }
        pair.balance = bernstein(&balance);
        for row in 0..N {
            pair.normal[row] = bernstein(&pair.normal[row]);
        }
        true
    }

    /// Whether the slack to both facets of a pair is at least `least` on a piece of the motion, between two fractions
    /// of it, and its value in the middle.
    pub fn bounds(&self, pair: &FacetPair, from: f64, to: f64, least: f64) -> Bounds {
        let whole = from == 0.0 && to == 1.0;
        let on_piece = |cubic: &Cubic| if whole { *cubic } else { restricted(cubic, from, to) };
        let mut normal = [[0.0; ROWS]; 4];
        for row in 0..self.rows {
            let cubic = on_piece(&pair.normal[row]);
            (0..4).for_each(|k| normal[k][row] = cubic[k]);
        }
        let sizes = normal.map(|c| size(&c));
        let largest = sizes.iter().fold(0.0, |a: f64, b| a.max(*b));
        let mut middle_normal = [0.0; ROWS];
        for row in 0..self.rows {
            middle_normal[row] = middle(&[normal[0][row], normal[1][row], normal[2][row], normal[3][row]]);
        }
        let middle_size = size(&middle_normal);
        let sure = middle_size > FACET_ROUNDING / FACET_CERTAIN * pair.scale;
        // The required value on each side: balance, support of the required set, and the requested slack.
        let balance = on_piece(&pair.balance);
        let middle_balance = middle(&balance);
        let asked = |k: usize| match least {
            // A norm is at least the part along any direction.
            least if least < 0.0 && middle_size > 0.0 => {
                least * normal[k].iter().zip(&middle_normal).map(|(a, b)| a * b).sum::<f64>() / middle_size
            }
            least => least.max(0.0) * sizes[k],
        };
        let mut needed = [[0.0; 4]; 2];
        let mut at_middle = [0.0; 2];
        for (side, sign) in SIDES {
            for k in 0..4 {
                needed[side][k] = sign * balance[k] + self.reach.of(&normal[k], sign) + asked(k);
            }
            at_middle[side] = -(sign * middle_balance + self.reach.of(&middle_normal, sign));
        }
        let mut available = needed.map(|cubic| elevated(&cubic).map(|x| -x));
        let [beside_normal, beside_product] = self.beside.map(|share| share * pair.scale);
        let rounding = FACET_ROUNDING * pair.count as f64 * self.edge * pair.scale;
        let mut lost = [rounding + beside_normal * (size(&self.balance) + self.reach.most() + least.abs()); 2];
        for (cable, height) in &pair.others[..pair.count] {
            let column = &self.columns[*cable];
            let height = on_piece(height);
            let inverse = if whole { Some(column.inverse) } else { self.inverse(*cable, from, to) };
            let Some(Inverse { parabola, error }) = inverse else { return Bounds { holds: false, middle: None } };
            let middle_height = middle(&height) * (0.25 * (parabola[0] + parabola[2]) + 0.5 * parabola[1]);
            let product = product(&height, &parabola);
            let highest = height.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
            let longest = parabola.iter().fold(0.0, |a: f64, b| a.max(*b)) + error;
            let [slackest, tautest] = column.tension;
            for (side, sign) in SIDES {
                // Any tension within the limits gives a bound; this one is exact in the middle.
                let tension = if sign * middle_height > 0.0 { tautest } else { slackest };
                for k in 0..6 {
                    available[side][k] += sign * tension * product[k];
                }
                lost[side] += tension * (error * highest + longest * beside_product * column.largest);
                at_middle[side] += sign * tension * middle_height;
            }
        }
        let floor = |side: usize| available[side].iter().fold(f64::INFINITY, |a: f64, b| a.min(*b)) - lost[side];
        let holds = largest > beside_normal && (0..2).all(|side| floor(side) >= 0.0);
        let middle = sure.then(|| at_middle[0].min(at_middle[1]) / middle_size);
        Bounds { holds, middle }
    }
}

/// √3/36, see [`Facets::inverse`].
const INTERPOLATION: f64 = 0.048_112_522_432_468_82;

/// A polynomial differs on [0, 1] from the cubic through its values at 0, 1/3, 2/3 and 1 by at most its largest fourth derivative times
/// max |s (s - 1/3) (s - 2/3) (s - 1)| / 4! = 1 / (81 · 24). That derivative of a determinant of affine columns is 4! times the sum over
/// all choices of four columns that are replaced by their rates; if all rates come from one vector, their rank is 3 and the sum zero.
const CUBIC: f64 = 1.0 / 81.0;

/// Relative accuracy of the slack in the middle of a piece, which decides what is examined next.
const FACET_CERTAIN: f64 = 1e-6;

/// Both sides of a pair of facets, with the sign of the normal.
const SIDES: [(usize, f64); 2] = [(0, 1.0), (1, -1.0)];

/// The requirement, the rows that count, and whether forces and moments are among them.
pub(super) fn shape<'a>(measure: &'a Measure, statics: &Statics) -> (Reach<'a>, usize, [bool; 2]) {
    let length = statics.characteristic_length();
    match measure {
        Measure::Capacity(margin) => {
            let reach = match margin.required() {
                Required::Balls { force, moment } => Reach::Balls([*force, moment / length]),
                Required::Polytope(corners) => Reach::Polytope(corners, length),
            };
            if statics.point_mass() { (reach, 3, [true, false]) } else { (reach, 6, [true, true]) }
        }
        Measure::Force(_, radius) => (Reach::Constant(*radius), 3, [true, false]),
        Measure::Moment(_, radius) => (Reach::Constant(*radius), 3, [false, true]),
    }
}

/// Minors of `LEVEL` columns of N rows, expanded along the last column from those of the columns before (Laplace).
struct Expand<'x, const N: usize, const LEVEL: usize> {
    minors: &'x [Cubic; SETS],
    column: &'x [Cubic; ROWS],
    larger: &'x mut [Cubic; SETS],
}

impl<const N: usize, const LEVEL: usize> Task for Expand<'_, N, LEVEL> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) {
        let mut column = [l.splat(0.0); ROWS];
        for row in 0..N {
            column[row] = l.load(&self.column[row]);
        }
        for (set, terms) in &EXPANSIONS[LEVEL] {
            if *set == 0 || *set as usize >= 1 << N {
                break;
            }
            let mut sum = l.splat(0.0);
            for k in 0..LEVEL {
                let [row, rest] = terms[k];
                let term = l.mul(column[row as usize % ROWS], l.load(&self.minors[rest as usize % SETS]));
                sum = if (k + LEVEL) % 2 == 1 { l.add(sum, term) } else { l.sub(sum, term) };
            }
            self.larger[*set as usize % SETS] = l.store(sum);
        }
    }
}

/// For each number of columns: the row sets of that size as masks, ascending, padded with zeros, each with its rows and
/// the masks without them.
const EXPANSIONS: [[(u8, [[u8; 2]; ROWS - 1]); 20]; ROWS] = expansions();

const fn expansions() -> [[(u8, [[u8; 2]; ROWS - 1]); 20]; ROWS] {
    let mut all = [[(0, [[0; 2]; ROWS - 1]); 20]; ROWS];
    let mut counts = [0; ROWS];
    let mut set = 1;
    while set < SETS - 1 {
        let level = set.count_ones() as usize;
        let (mut rows, mut k) = (set, 0);
        while rows != 0 {
            let row = rows.trailing_zeros();
            all[level][counts[level]].1[k] = [row as u8, (set ^ (1 << row)) as u8];
            rows &= rows - 1;
            k += 1;
        }
        all[level][counts[level]].0 = set as u8;
        counts[level] += 1;
        set += 1;
    }
    all
}

/// Bernstein coefficients of the cubic with these values at 0, 1/3, 2/3 and 1.
#[inline]
fn bernstein([a, b, c, d]: &Cubic) -> Cubic {
    [*a, (-5.0 * a + 18.0 * b - 9.0 * c + 2.0 * d) / 6.0, (2.0 * a - 9.0 * b + 18.0 * c - 5.0 * d) / 6.0, *d]
}

/// A cubic on a part of its interval: P. de Casteljau's algorithm as a blossom.
#[inline]
fn restricted(&[a, b, c, d]: &Cubic, from: f64, to: f64) -> Cubic {
    let at = |t: f64, a: f64, b: f64| a + t * (b - a);
    let once = |t: f64| [at(t, a, b), at(t, b, c), at(t, c, d)];
    let (low, high) = (once(from), once(to));
    let low_low = [at(from, low[0], low[1]), at(from, low[1], low[2])];
    let high_high = [at(to, high[0], high[1]), at(to, high[1], high[2])];
    [
        at(from, low_low[0], low_low[1]),
        at(to, low_low[0], low_low[1]),
        at(from, high_high[0], high_high[1]),
        at(to, high_high[0], high_high[1]),
    ]
}

/// The value in the middle.
#[inline]
fn middle([a, b, c, d]: &Cubic) -> f64 {
    0.125 * (a + d + 3.0 * (b + c))
}

/// A cubic as a quintic.
#[inline]
fn elevated([a, b, c, d]: &Cubic) -> [f64; 6] {
    [*a, 0.4 * a + 0.6 * b, 0.1 * a + 0.6 * b + 0.3 * c, 0.3 * b + 0.6 * c + 0.1 * d, 0.6 * c + 0.4 * d, *d]
}

/// A cubic times a parabola.
#[inline]
fn product([a, b, c, d]: &Cubic, [p, q, r]: &[f64; 3]) -> [f64; 6] {
    [
        a * p,
        0.4 * a * q + 0.6 * b * p,
        0.1 * a * r + 0.6 * b * q + 0.3 * c * p,
        0.3 * b * r + 0.6 * c * q + 0.1 * d * p,
        0.6 * c * r + 0.4 * d * q,
        d * r,
    ]
}

#[cfg(test)]
mod tests;
