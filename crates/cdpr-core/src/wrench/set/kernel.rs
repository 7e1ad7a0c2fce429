//! Capacity margins of four positions at a time, for robots of six to eight cables.
//!
//! A facet's normal c is orthogonal to five columns of W, so v = Wᵀc vanishes on five cables. As an element of the row
//! space of W, v is orthogonal to its null space N. With eight cables (fewer are padded with zero columns) N has two
//! columns, and on the three remaining cables v is the cross product of their rows of N: 28 products of two give all 56
//! normals. Everything else follows from v, through P = W⁺ᵀ, c = P v:
//!
//! - the offset of the facet on both sides: Σ ρᵢ|vᵢ| ± Σ μᵢ vᵢ with μ, ρ the centre and half-width of the tensions;
//! - c·w_r = Σ vᵢ Pᵢ·w_r.
//!
//! N and P come from a QR factorisation of Wᵀ by Householder reflections, which needs no pivots, so lanes need not
//! branch. If a factor or a normal is too uncertain for this, `sure` becomes negative, and the position is left to
//! [`super::margins`].

use std::borrow::Cow;

use crate::geometry::{Placed, Point, Vector};
use crate::simd::{Lanes, Task, WIDTH};
use crate::tolerances::{KERNEL_CONDITION, KERNEL_NO_NORMAL, KERNEL_NORMAL, MIN_CABLE_LENGTH};
use crate::wrench::statics::Statics;

/// Number of cables of the kernel; fewer are padded.
pub const CABLES: usize = 8;

/// Components of a wrench.
const ROWS: usize = 6;

/// The three cables outside each facet: every choice of three of eight.
const TRIPLES: [[usize; 3]; 56] = triples();

const fn triples() -> [[usize; 3]; 56] {
    let (mut all, mut n, mut i) = ([[0; 3]; 56], 0, 0);
    while i < CABLES {
        let mut j = i + 1;
        while j < CABLES {
            let mut k = j + 1;
            while k < CABLES {
                all[n] = [i, j, k];
                n += 1;
                k += 1;
            }
            j += 1;
        }
        i += 1;
    }
    all
}

/// A number for each of four poses.
pub type Four = [f64; WIDTH];

/// A robot in the kernel's layout, at four poses.
#[derive(Debug, Clone, PartialEq)]
pub struct KernelRobot {
    /// Outlet minus arm of each cable, m; the cable vector is this minus the position.
    anchors: [[Four; 3]; CABLES],
    /// From the platform's origin to the attachment, divided by the characteristic length.
    arms: [[Four; 3]; CABLES],
    /// Centre and half-width of the tensions, N.
    middle: [f64; CABLES],
    half: [f64; CABLES],
    cables: usize,
    balance: [Four; ROWS],
    /// Radii of the required balls of [force; moment / ℓ], N.
    radii: [f64; 2],
}

impl KernelRobot {
    /// The robot for the kernel, with balls of these radii of [force; moment / ℓ]; `None` if its number of cables is
    /// not supported, or its platform is a point mass.
    pub fn new(statics: &Statics, radii: [f64; 2]) -> Option<Self> {
        let cables = statics.cables();
        if !(ROWS..=CABLES).contains(&cables.len()) || statics.point_mass() {
            return None;
        }
        let each = |number: &dyn Fn(&crate::wrench::StaticCable) -> f64| {
            std::array::from_fn(|k| cables.get(k).map_or(0.0, number))
        };
        let triple = |v: Vector| [[v.x; WIDTH], [v.y; WIDTH], [v.z; WIDTH]];
        let length = statics.characteristic_length();
        Some(KernelRobot {
            anchors: std::array::from_fn(|k| {
                cables.get(k).map_or([[0.0; WIDTH]; 3], |c| triple(c.outlet.coords - c.arm))
            }),
            arms: std::array::from_fn(|k| cables.get(k).map_or([[0.0; WIDTH]; 3], |c| triple(c.arm / length))),
            middle: each(&|c| 0.5 * (c.tension[0] + c.tension[1])),
            half: each(&|c| 0.5 * (c.tension[1] - c.tension[0])),
            cables: cables.len(),
            balance: std::array::from_fn(|row| [statics.balance()[row]; WIDTH]),
            radii,
        })
    }

    /// This robot at four orientations instead of that of `statics`, with the wrenches to balance there.
    pub fn at_orientations(&self, statics: &Statics, poses: &[Placed; WIDTH], balances: &[[f64; ROWS]; WIDTH]) -> Self {
        let mut robot = self.clone();
        let length = statics.characteristic_length();
        for (k, cable) in statics.cables().iter().enumerate() {
            for lane in 0..WIDTH {
                let arm = poses[lane].turned(&cable.arm);
                for axis in 0..3 {
                    robot.anchors[k][axis][lane] = cable.outlet[axis] - arm[axis];
                    robot.arms[k][axis][lane] = arm[axis] / length;
                }
            }
        }
        for row in 0..ROWS {
            for lane in 0..WIDTH {
                robot.balance[row][lane] = balances[lane][row];
            }
        }
        robot
    }

    /// This robot with cables that run round pulleys from where they leave them at these positions; NaN if they cannot.
    #[inline]
    pub fn at_exits(&self, statics: &Statics, positions: &[Point; WIDTH]) -> Cow<'_, Self> {
        if statics.has_pulleys() { Cow::Owned(self.around_pulleys(statics, positions)) } else { Cow::Borrowed(self) }
    }

    #[cold]
    fn around_pulleys(&self, statics: &Statics, positions: &[Point; WIDTH]) -> Self {
        let mut robot = self.clone();
        for (anchors, cable) in robot.anchors.iter_mut().zip(statics.cables()) {
            let Some(pulley) = &cable.pulley else { continue };
            for (lane, position) in positions.iter().enumerate() {
                let arm = cable.outlet - Point::new(anchors[0][lane], anchors[1][lane], anchors[2][lane]);
                let found = pulley.departure(&cable.outlet, &(position + arm));
                let exit = found.map_or(Point::from([f64::NAN; 3]), |found| found.exit);
                for axis in 0..3 {
                    anchors[axis][lane] = exit[axis] - arm[axis];
                }
            }
        }
        robot
    }
}

/// The margins of four positions, N; NaN where the kernel is not sure.
pub struct FourMargins<'a> {
    pub robot: &'a KernelRobot,
    pub positions: [Point; WIDTH],
}

impl Task for FourMargins<'_> {
    type Output = [f64; WIDTH];

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) -> [f64; WIDTH] {
        let mut sure = l.splat(1.0);
        let mut rows = transposed_wrench_matrix(l, self.robot, &self.positions, &mut sure);
        let factors = Factors::new(l, &mut rows, &mut sure);
        let margins = least_slack(l, self.robot, &factors, &mut sure);
        l.store(l.where_not_negative(sure, margins, l.splat(f64::NAN)))
    }
}

/// Number of pairs of parallel facets.
pub const FACETS: usize = TRIPLES.len();

/// Four positions, two wrenches [force; moment / ℓ] at each, N, and the capacity margins that the cables keep, N.
pub struct FourDemands<'a> {
    pub robot: &'a KernelRobot,
    pub positions: [Point; WIDTH],
    pub wrenches: [[[f64; ROWS]; 2]; WIDTH],
    pub margin: Four,
}

/// For each of the four positions, whether the kernel is sure of its result, and whether it found no negative slack at
/// rest; negative if not.
#[derive(Debug, Clone, Copy)]
pub struct FourSigns {
    pub sure: Four,
    pub held: Four,
}

/// A pair of parallel facets at four positions. All values scale with the norm of the normal, which is arbitrary.
#[derive(Debug, Clone, Copy, Default)]
pub struct FourFacets {
    /// Heights of two wrenches over the plane through the origin, in the direction of the first facet.
    pub heights: [Four; 2],
    /// The available wrench beyond the balance of the loads and the margin, in the directions of the first facet and of
    /// the second.
    pub slack: [Four; 2],
    /// Length of the normal; 0 if the facet does not exist.
    pub norm: Four,
}

/// The facets at four positions that may limit u w₀ + x w₁ with the two wrenches w and |u| ≤ `most[0]`, 0 ≤ x ≤
/// `most[1]`. The result is the number of facets written to `found`.
pub struct ReachedFacets<'a> {
    pub demands: FourDemands<'a>,
    pub most: [[f64; WIDTH]; 2],
    pub found: &'a mut [FourFacets; FACETS],
}

impl Task for ReachedFacets<'_> {
    type Output = (usize, FourSigns);

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) -> Self::Output {
        let mut at = Places::new(l, &self.demands);
        let [most_u, most_x] = [l.load(&self.most[0]), l.load(&self.most[1])];
        let mut count = 0;
        for triple in TRIPLES {
            let Facet { heights: [a, b], slack, norm, missing } = at.facet(l, triple);
            let (by_u, zero) = (l.mul(l.abs(a), most_u), l.splat(0.0));
            let out = l.sub(slack[0], l.add(by_u, l.mul(l.max(b, zero), most_x)));
            let back = l.sub(slack[1], l.add(by_u, l.mul(l.max(l.sub(zero, b), zero), most_x)));
            let beyond = (l.not_negative(out) & l.not_negative(back)) | l.not_negative(missing);
            if beyond != ALL {
                self.found[count] = FourFacets {
                    heights: [l.store(a), l.store(b)],
                    slack: [l.store(slack[0]), l.store(slack[1])],
                    norm: l.store(l.where_not_negative(missing, zero, norm)),
                };
                count += 1;
            }
        }
        (count, at.signs(l))
    }
}

/// One bit for each of the four positions.
const ALL: u32 = (1 << WIDTH) - 1;

/// The shares of the slack at four positions that each of two wrenches needs.
#[derive(Debug, Clone, Copy)]
pub struct FourShares {
    /// The largest share of the slack at rest.
    pub share: [Four; 2],
    /// The least slack that is left, N.
    pub slack: [Four; 2],
}

impl Task for FourDemands<'_> {
    type Output = (FourShares, FourSigns);

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) -> Self::Output {
        let mut at = Places::new(l, &self);
        let (zero, infinity) = (l.splat(0.0), l.splat(f64::INFINITY));
        let (mut share, mut least) = ([zero; 2], [infinity; 2]);
        for triple in TRIPLES {
            let Facet { heights, slack: [out, back], norm, missing } = at.facet(l, triple);
            for k in 0..2 {
                let opposite = l.sub(zero, heights[k]);
                let needed = l.max(l.div(heights[k], out), l.max(l.div(opposite, back), zero));
                share[k] = l.max(l.where_not_negative(missing, zero, needed), share[k]);
                let left = l.div(l.min(l.sub(out, heights[k]), l.sub(back, opposite)), norm);
                least[k] = l.min(l.where_not_negative(missing, infinity, left), least[k]);
            }
        }
        let four = |[a, b]: [L::Four; 2]| [l.store(a), l.store(b)];
        (FourShares { share: four(share), slack: four(least) }, at.signs(l))
    }
}

/// Intermediate results from which the facets at four positions are computed.
struct Places<L: Lanes> {
    factors: Factors<L>,
    sides: Sides<L>,
    wrenches: [[L::Four; ROWS]; 2],
    margin: L::Four,
    sure: L::Four,
    held: L::Four,
}

/// A pair of facets; see [`FourFacets`]. `missing` is nonnegative where it does not exist.
struct Facet<L: Lanes> {
    heights: [L::Four; 2],
    slack: [L::Four; 2],
    norm: L::Four,
    missing: L::Four,
}

impl<L: Lanes> Places<L> {
    #[inline(always)]
    fn new(l: L, demands: &FourDemands) -> Self {
        let (mut sure, held) = (l.splat(1.0), l.splat(1.0));
        let mut rows = transposed_wrench_matrix(l, demands.robot, &demands.positions, &mut sure);
        let factors = Factors::new(l, &mut rows, &mut sure);
        let [a, b, c, d] = &demands.wrenches;
        let mut wrenches = [[l.splat(0.0); ROWS]; 2];
        for k in 0..2 {
            for row in 0..ROWS {
                wrenches[k][row] = l.load(&[a[k][row], b[k][row], c[k][row], d[k][row]]);
            }
        }
        let (sides, margin) = (Sides::new(l, demands.robot, &factors), l.load(&demands.margin));
        Places { factors, sides, wrenches, margin, sure, held }
    }

    #[inline(always)]
    fn facet(&mut self, l: L, triple: [usize; 3]) -> Facet<L> {
        let ([i, j, k], dual) = (triple, &self.factors.dual);
        let v = self.sides.normal(l, triple);
        let mut c = [l.splat(0.0); ROWS];
        for r in 0..ROWS {
            c[r] = dot(l, &v, &[dual[i][r], dual[j][r], dual[k][r]]);
        }
        let ([out, off], norm) = (self.sides.reach(l, triple, &v), l.sqrt(dot(l, &c, &c)));
        let size = dot(l, &v, &v);
        let missing = l.sub(l.splat(KERNEL_NO_NORMAL * KERNEL_NO_NORMAL), size);
        let clear = l.sub(size, l.splat(KERNEL_NORMAL * KERNEL_NORMAL));
        self.sure = unless(l, l.max(missing, clear), self.sure);
        let kept = l.mul(self.margin, norm);
        let slack = [l.sub(l.sub(out, off), kept), l.sub(l.add(out, off), kept)];
        let held = l.where_not_negative(missing, l.splat(0.0), l.min(slack[0], slack[1]));
        self.held = unless(l, held, self.held);
        let heights = [dot(l, &c, &self.wrenches[0]), dot(l, &c, &self.wrenches[1])];
        Facet { heights, slack, norm, missing }
    }

    #[inline(always)]
    fn signs(&self, l: L) -> FourSigns {
        FourSigns { sure: l.store(self.sure), held: l.store(self.held) }
    }
}

/// Wᵀ, a row for each cable.
#[inline(always)]
fn transposed_wrench_matrix<L: Lanes>(
    l: L,
    robot: &KernelRobot,
    positions: &[Point; WIDTH],
    sure: &mut L::Four,
) -> [[L::Four; ROWS]; CABLES] {
    let mut at = [l.splat(0.0); 3];
    for axis in 0..3 {
        at[axis] = l.load(&[positions[0][axis], positions[1][axis], positions[2][axis], positions[3][axis]]);
    }
    let mut rows = [[l.splat(0.0); ROWS]; CABLES];
    for k in 0..robot.cables {
        let (anchor, arm) = (&robot.anchors[k], &robot.arms[k]);
        let mut u = [l.splat(0.0); 3];
        for axis in 0..3 {
            u[axis] = l.sub(l.load(&anchor[axis]), at[axis]);
        }
        let length = l.sqrt(dot(l, &u, &u));
        *sure = unless(l, l.sub(length, l.splat(MIN_CABLE_LENGTH)), *sure);
        let inverse = l.div(l.splat(1.0), length);
        for x in &mut u {
            *x = l.mul(*x, inverse);
        }
        let [ax, ay, az] = [l.load(&arm[0]), l.load(&arm[1]), l.load(&arm[2])];
        let [ux, uy, uz] = u;
        rows[k] = [
            ux,
            uy,
            uz,
            l.sub(l.mul(ay, uz), l.mul(az, uy)),
            l.sub(l.mul(az, ux), l.mul(ax, uz)),
            l.sub(l.mul(ax, uy), l.mul(ay, ux)),
        ];
    }
    rows
}

#[inline(always)]
fn dot<L: Lanes, const N: usize>(l: L, a: &[L::Four; N], b: &[L::Four; N]) -> L::Four {
    let mut sum = l.mul(a[0], b[0]);
    for k in 1..N {
        sum = l.add(sum, l.mul(a[k], b[k]));
    }
    sum
}

/// The matrices that the facets are computed from.
struct Factors<L: Lanes> {
    /// Orthonormal null space of W, a row for each cable.
    null: [[L::Four; 2]; CABLES],
    /// W⁺ᵀ, a column of six for each cable.
    dual: [[L::Four; ROWS]; CABLES],
}

impl<L: Lanes> Factors<L> {
    /// Factors Wᵀ = Q R in place. `sure` becomes negative where R is too badly conditioned.
    #[inline(always)]
    fn new(l: L, rows: &mut [[L::Four; ROWS]; CABLES], sure: &mut L::Four) -> Self {
        let mut diagonal = [l.splat(0.0); ROWS];
        let mut factor = [l.splat(0.0); ROWS];
        for k in 0..ROWS {
            (diagonal[k], factor[k]) = reflect(l, rows, k);
        }
        let (mut least, mut largest) = (l.abs(diagonal[0]), l.abs(diagonal[0]));
        for d in &diagonal[1..] {
            (least, largest) = (l.min(least, l.abs(*d)), l.max(largest, l.abs(*d)));
        }
        *sure = unless(l, l.sub(least, l.mul(largest, l.splat(KERNEL_CONDITION))), *sure);
        // Q = H₀ … H₅, applied to the columns of the identity, last reflection first.
        let mut q = [[l.splat(0.0); CABLES]; CABLES];
        for column in 0..CABLES {
            q[column][column] = l.splat(1.0);
            for k in (0..ROWS.min(column + 1)).rev() {
                let mut along = l.splat(0.0);
                for r in k..CABLES {
                    along = l.add(along, l.mul(rows[r][k], q[column][r]));
                }
                let along = l.mul(along, factor[k]);
                for r in k..CABLES {
                    q[column][r] = l.sub(q[column][r], l.mul(along, rows[r][k]));
                }
            }
        }
        let mut inverse = [l.splat(0.0); ROWS];
        for k in 0..ROWS {
            inverse[k] = l.div(l.splat(1.0), diagonal[k]);
        }
        let mut null = [[l.splat(0.0); 2]; CABLES];
        let mut dual = [[l.splat(0.0); ROWS]; CABLES];
        for cable in 0..CABLES {
            null[cable] = [q[ROWS][cable], q[ROWS + 1][cable]];
            // R x = Qᵀ e, from below; R is stored above the diagonal of `rows`.
            for k in (0..ROWS).rev() {
                let mut x = q[k][cable];
                for j in k + 1..ROWS {
                    x = l.sub(x, l.mul(rows[k][j], dual[cable][j]));
                }
                dual[cable][k] = l.mul(x, inverse[k]);
            }
        }
        Factors { null, dual }
    }
}

/// One Householder reflection, which clears column `k` below its diagonal: leaves its vector v in the column, from the
/// diagonal down, and returns the diagonal entry of R and 2 / v·v.
#[inline(always)]
fn reflect<L: Lanes>(l: L, rows: &mut [[L::Four; ROWS]; CABLES], k: usize) -> (L::Four, L::Four) {
    let mut squared = l.mul(rows[k][k], rows[k][k]);
    for r in k + 1..CABLES {
        squared = l.add(squared, l.mul(rows[r][k], rows[r][k]));
    }
    let norm = l.sqrt(squared);
    let head = rows[k][k];
    let signed = l.where_not_negative(head, norm, l.sub(l.splat(0.0), norm));
    rows[k][k] = l.add(head, signed);
    let factor = l.div(l.splat(1.0), l.add(squared, l.mul(l.abs(head), norm)));
    for j in k + 1..ROWS {
        let mut along = l.splat(0.0);
        for r in k..CABLES {
            along = l.add(along, l.mul(rows[r][k], rows[r][j]));
        }
        let along = l.mul(along, factor);
        for r in k..CABLES {
            rows[r][j] = l.sub(rows[r][j], l.mul(along, rows[r][k]));
        }
    }
    (l.sub(l.splat(0.0), signed), factor)
}

/// What all facets share, in the coordinates of v.
struct Sides<L: Lanes> {
    /// Per cable: the offset of the balancing wrench from the centre of the set.
    offset: [L::Four; CABLES],
    half: [L::Four; CABLES],
    /// Two by two minors of N: products of pairs of cables.
    minor: [[L::Four; CABLES]; CABLES],
}

impl<L: Lanes> Sides<L> {
    #[inline(always)]
    fn new(l: L, robot: &KernelRobot, Factors { null, dual }: &Factors<L>) -> Self {
        let zero = l.splat(0.0);
        let mut offset = [zero; CABLES];
        let mut half = [zero; CABLES];
        for k in 0..CABLES {
            let mut along = zero;
            for r in 0..ROWS {
                along = l.add(along, l.mul(dual[k][r], l.load(&robot.balance[r])));
            }
            offset[k] = l.sub(along, l.splat(robot.middle[k]));
            half[k] = l.splat(robot.half[k]);
        }
        let mut minor = [[zero; CABLES]; CABLES];
        for i in 0..CABLES {
            for j in i + 1..CABLES {
                minor[i][j] = l.sub(l.mul(null[i][0], null[j][1]), l.mul(null[i][1], null[j][0]));
            }
        }
        Sides { offset, half, minor }
    }

    /// The three entries of v that are not zero.
    #[inline(always)]
    fn normal(&self, l: L, [i, j, k]: [usize; 3]) -> [L::Four; 3] {
        [self.minor[j][k], l.sub(l.splat(0.0), self.minor[i][k]), self.minor[i][j]]
    }

    /// The distance of a facet from the centre of the set, and how far the balancing wrench is on the way to it.
    #[inline(always)]
    fn reach(&self, l: L, [i, j, k]: [usize; 3], v: &[L::Four; 3]) -> [L::Four; 2] {
        let out = dot(l, &[l.abs(v[0]), l.abs(v[1]), l.abs(v[2])], &[self.half[i], self.half[j], self.half[k]]);
        [out, dot(l, v, &[self.offset[i], self.offset[j], self.offset[k]])]
    }
}

/// The smallest slack over all facets.
#[inline(always)]
fn least_slack<L: Lanes>(l: L, robot: &KernelRobot, factors: &Factors<L>, sure: &mut L::Four) -> L::Four {
    let zero = l.splat(0.0);
    let Factors { dual, .. } = factors;
    let sides = Sides::new(l, robot, factors);
    let (force, moment) = (l.splat(robot.radii[0]), l.splat(robot.radii[1]));
    let mut least = l.splat(f64::INFINITY);
    for triple in TRIPLES {
        let [i, j, k] = triple;
        let v = sides.normal(l, triple);
        let mut c = [zero; ROWS];
        for r in 0..ROWS {
            c[r] = dot(l, &v, &[dual[i][r], dual[j][r], dual[k][r]]);
        }
        let [fx, fy, fz, mx, my, mz] = c;
        let (f2, m2) = (dot(l, &[fx, fy, fz], &[fx, fy, fz]), dot(l, &[mx, my, mz], &[mx, my, mz]));
        let [out, off] = sides.reach(l, triple, &v);
        let needed = l.add(l.abs(off), l.add(l.mul(force, l.sqrt(f2)), l.mul(moment, l.sqrt(m2))));
        let slack = l.div(l.sub(out, needed), l.sqrt(l.add(f2, m2)));
        let size = dot(l, &v, &v);
        let no_normal = l.sub(l.splat(KERNEL_NO_NORMAL * KERNEL_NO_NORMAL), size);
        let slack = l.where_not_negative(no_normal, l.splat(f64::INFINITY), slack);
        least = l.min(slack, least);
        let clear = l.sub(size, l.splat(KERNEL_NORMAL * KERNEL_NORMAL));
        *sure = unless(l, l.max(no_normal, clear), *sure);
        *sure = unless(l, l.mul(slack, slack), *sure); // NaN
    }
    least
}

/// `sure` where a check is nonnegative, otherwise -1; also -1 where the check is NaN.
#[inline(always)]
fn unless<L: Lanes>(l: L, check: L::Four, sure: L::Four) -> L::Four {
    l.where_not_negative(check, sure, l.splat(-1.0))
}
