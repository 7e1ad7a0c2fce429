//! The facets of the available wrenches at a position, as limits of further wrenches.

use std::borrow::Cow;

use nalgebra::{SVector, Vector6};

use super::kernel::{FACETS, FourDemands, FourFacets, KernelRobot, ReachedFacets};
use crate::geometry::{Placed, Point};
use crate::simd::{Kernel, WIDTH};
use crate::tolerances::BALANCE_RELATIVE;
use crate::wrench::statics::{Part, Statics};
use crate::wrench::zonotope::{Span, for_each_normal};

/// A pair of parallel facets with the normals c and −c. All values scale with |c|, which is arbitrary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FacetPair {
    /// The products c·w of two wrenches w.
    pub heights: [f64; 2],
    /// The available wrench beyond the balance of the loads, in directions c and −c; nonnegative if the cables hold the
    /// platform.
    pub slack: [f64; 2],
    /// The norm |c|.
    pub norm: f64,
}

/// Two wrenches w at a position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Demand {
    /// Position of the platform's origin, m.
    pub position: Point,
    /// The wrenches [force; moment / ℓ], N.
    pub wrenches: [Vector6<f64>; 2],
    /// Only u w₀ + x w₁ with |u| ≤ `most[0]`, 0 ≤ x ≤ `most[1]` matters; both may be infinite.
    pub most: [f64; 2],
}

/// How much of the available wrenches a wrench uses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TensionShare {
    /// The largest share of the slack at rest.
    pub share: f64,
    /// The least slack that is left, N.
    pub slack: f64,
}

impl TensionShare {
    /// The share of a zero wrench.
    pub const NOTHING: Self = TensionShare { share: 0.0, slack: f64::INFINITY };

    /// The larger share and the smaller slack of two.
    pub fn worse(self, other: Self) -> Self {
        TensionShare { share: self.share.max(other.share), slack: self.slack.min(other.slack) }
    }

    /// Takes into account a pair of facets above which the wrench has this height.
    fn and(self, height: f64, facets: &FacetPair) -> Self {
        let [out, back] = facets.slack;
        let share = self.share.max(height / out).max(-height / back);
        TensionShare { share, slack: self.slack.min((out - height).min(back + height) / facets.norm) }
    }
}

/// A turn of the platform from the orientation of the statics, and the wrench to balance there, [force; moment / ℓ], N.
pub type Turned = (Placed, Vector6<f64>);

/// The facets of the wrenches that a robot's cables can exert.
#[derive(Debug, Clone)]
pub struct DemandFacets {
    statics: Statics,
    robot: Option<KernelRobot>,
    kernel: Kernel,
    margin: f64,
}

impl DemandFacets {
    /// The facets of a robot, moved inward by a capacity margin, N.
    pub fn new(statics: Statics, margin: f64) -> Self {
        let robot = KernelRobot::new(&statics, [0.0; 2]);
        DemandFacets { statics, robot, kernel: Kernel::best(), margin }
    }

    /// These facets computed by definition instead of by the kernel, for comparison.
    pub fn by_definition(mut self) -> Self {
        self.robot = None;
        self
    }

    /// These facets computed without SIMD instructions, for comparison.
    pub fn portable(mut self) -> Self {
        self.kernel = Kernel::Portable;
        self
    }

    /// The statics of the robot.
    pub fn statics(&self) -> &Statics {
        &self.statics
    }

    /// Calls `visit` with the index of each demand and the facets at its position; facets that the demand does not
    /// reach may be omitted. For orientations other than that of the statics, `turned` has one turn for each demand.
    /// Returns the index of the first demand at whose position the cables cannot hold the platform.
    pub fn for_each(
        &self,
        demands: &[Demand],
        turned: Option<&[Turned]>,
        mut visit: impl FnMut(usize, &FacetPair),
    ) -> Option<usize> {
        let (mut lacking, mut found) = (Lacking(None), [FourFacets::default(); FACETS]);
        for (first, four, turns) in groups(demands, turned) {
            let most = [0, 1].map(|side| lanes(four, |demand| demand.most[side]));
            let facets = &mut found;
            let kernel = |demands: FourDemands| self.kernel.run(ReachedFacets { demands, most, found: facets });
            let sure = self.by_kernel(four, turns, kernel).map_or([-1.0; WIDTH], |(count, signs)| {
                for lane in (0..four.len()).filter(|lane| signs.sure[*lane] >= 0.0) {
                    lacking.unless(signs.held[lane], first + lane);
                    for facet in found[..count].iter().filter(|facet| facet.norm[lane] > 0.0) {
                        let (heights, slack) = (facet.heights.map(|h| h[lane]), facet.slack.map(|s| s[lane]));
                        visit(first + lane, &FacetPair { heights, slack, norm: facet.norm[lane] });
                    }
                }
                signs.sure
            });
            for lane in (0..four.len()).filter(|lane| !(sure[*lane] >= 0.0)) {
                let visit = |facet: &FacetPair| visit(first + lane, facet);
                lacking.unless(self.by_facets(&four[lane], turns.map(|turns| &turns[lane]), visit), first + lane);
            }
        }
        lacking.0
    }

    /// For each demand, the share of the slack at rest that each of its wrenches needs alone; arguments as in
    /// [`DemandFacets::for_each`]. An error is the index of the first demand at whose position the cables cannot hold
    /// the platform.
    pub fn shares(&self, demands: &[Demand], turned: Option<&[Turned]>) -> Result<Vec<[TensionShare; 2]>, usize> {
        let (mut lacking, mut shares) = (Lacking(None), vec![[TensionShare::NOTHING; 2]; demands.len()]);
        for (first, four, turns) in groups(demands, turned) {
            let own = &mut shares[first..first + four.len()];
            let kernel = |demands: FourDemands| self.kernel.run(demands);
            let sure = self.by_kernel(four, turns, kernel).map_or([-1.0; WIDTH], |(found, signs)| {
                for lane in (0..four.len()).filter(|lane| signs.sure[*lane] >= 0.0) {
                    lacking.unless(signs.held[lane], first + lane);
                    own[lane] =
                        [0, 1].map(|k| TensionShare { share: found.share[k][lane], slack: found.slack[k][lane] });
                }
                signs.sure
            });
            for lane in (0..four.len()).filter(|lane| !(sure[*lane] >= 0.0)) {
                let add = |facets: &FacetPair| {
                    own[lane] = [0, 1].map(|k| own[lane][k].and(facets.heights[k], facets));
                };
                lacking.unless(self.by_facets(&four[lane], turns.map(|turns| &turns[lane]), add), first + lane);
            }
        }
        lacking.0.map_or(Ok(shares), Err)
    }

    /// The result of a kernel for up to four demands; `None` for robots that it does not support.
    fn by_kernel<T>(&self, four: &[Demand], turns: Option<&[Turned]>, run: impl FnOnce(FourDemands) -> T) -> Option<T> {
        let robot = self.at_turns(self.robot.as_ref()?, turns);
        let positions = lanes(four, |demand| demand.position);
        let robot = robot.at_exits(&self.statics, &positions);
        let wrenches = lanes(four, |demand| demand.wrenches.map(Into::into));
        let mut margin = [self.margin; WIDTH];
        if self.statics.has_errors() {
            for (lane, margin) in margin.iter_mut().enumerate().take(four.len()) {
                *margin = self.kept(&self.at_turn(turns.map(|turns| &turns[lane])), &positions[lane]);
            }
        }
        Some(run(FourDemands { robot: &robot, positions, wrenches, margin }))
    }

    /// The margin to keep at the given outlets, so that the true ones keep that of the facets; NaN if a cable may have no direction.
    fn kept(&self, statics: &Statics, position: &Point) -> f64 {
        self.margin + statics.loss(position, Part::Whole).unwrap_or(f64::NAN)
    }

    fn at_turn(&self, turn: Option<&Turned>) -> Cow<'_, Statics> {
        turn.map_or(Cow::Borrowed(&self.statics), |(pose, balance)| Cow::Owned(self.statics.turned(pose, *balance)))
    }

    /// The robot at up to four turns.
    fn at_turns<'a>(&self, robot: &'a KernelRobot, turns: Option<&[Turned]>) -> Cow<'a, KernelRobot> {
        let Some(turns) = turns else { return Cow::Borrowed(robot) };
        let (poses, balances) = (lanes(turns, |turn| turn.0), lanes(turns, |turn| turn.1.into()));
        Cow::Owned(robot.at_orientations(&self.statics, &poses, &balances))
    }

    /// Visits all facets of a demand by definition. The result is nonnegative if the cables hold the platform there.
    fn by_facets(&self, demand: &Demand, turn: Option<&Turned>, mut visit: impl FnMut(&FacetPair)) -> f64 {
        let (mut least, statics) = (f64::INFINITY, self.at_turn(turn));
        let kept = self.kept(&statics, &demand.position);
        if kept.is_nan() {
            return f64::NAN;
        }
        let directed = self.defined(&statics, &demand.position, &demand.wrenches, &mut |facet| {
            let slack = facet.slack.map(|slack| slack - kept * facet.norm);
            least = least.min(slack[0]).min(slack[1]);
            visit(&FacetPair { slack, ..facet });
        });
        if directed { least } else { f64::NAN }
    }

    /// The facets at a position by definition; false if a cable has no direction.
    fn defined(
        &self,
        statics: &Statics,
        position: &Point,
        wrenches: &[Vector6<f64>; 2],
        see: &mut impl FnMut(FacetPair),
    ) -> bool {
        let Some(columns) = statics.columns(position) else { return false };
        if statics.point_mass() {
            let force = |w: &Vector6<f64>| -> SVector<f64, 3> { w.fixed_rows::<3>(0).into() };
            let forces: Vec<SVector<f64, 3>> = columns.iter().map(force).collect();
            self.facets(&forces, &force(statics.balance()), wrenches.each_ref().map(force), see);
        } else {
            self.facets(&columns, statics.balance(), *wrenches, see);
        }
        true
    }

    fn facets<const N: usize>(
        &self,
        generators: &[SVector<f64, N>],
        balance: &SVector<f64, N>,
        wrenches: [SVector<f64, N>; 2],
        see: &mut impl FnMut(FacetPair),
    ) {
        let span = Span::of(generators);
        let mut facets = |normal: &SVector<f64, N>, [out, back]: [f64; 2]| {
            let height = normal.dot(balance);
            let heights = wrenches.map(|wrench| normal.dot(&wrench));
            see(FacetPair { heights, slack: [out - height, back + height], norm: 1.0 });
        };
        for_each_normal(generators, &span, &mut |normal| {
            let mut ends = [0.0; 2];
            for (generator, cable) in generators.iter().zip(self.statics.cables()) {
                let height = normal.dot(generator);
                let pulls = cable.tension.map(|tension| tension * height);
                ends[0] += pulls[0].max(pulls[1]);
                ends[1] -= pulls[0].min(pulls[1]);
            }
            facets(normal, ends);
        });
        // Nothing is available in these directions; a demand within rounding errors does not count.
        let nothing = self.margin + BALANCE_RELATIVE * self.statics.largest_tension();
        for normal in span.left_null() {
            facets(normal, [nothing; 2]);
        }
    }
}

/// The first demand at whose position the cables cannot hold the platform.
struct Lacking(Option<usize>);

impl Lacking {
    /// Notes a demand unless a number is nonnegative.
    fn unless(&mut self, held: f64, demand: usize) {
        if !(held >= 0.0) {
            self.0 = Some(self.0.map_or(demand, |first| first.min(demand)));
        }
    }
}

/// Demands in groups of four with their turns; the first number is the index of the first of them.
fn groups<'a>(
    demands: &'a [Demand],
    turned: Option<&'a [Turned]>,
) -> impl Iterator<Item = (usize, &'a [Demand], Option<&'a [Turned]>)> {
    demands.chunks(WIDTH).enumerate().map(move |(group, four)| {
        let first = group * WIDTH;
        (first, four, turned.map(|turned| &turned[first..first + four.len()]))
    })
}

/// A quantity of up to four items, the last one repeated.
fn lanes<T, U>(items: &[T], of: impl Fn(&T) -> U) -> [U; WIDTH] {
    std::array::from_fn(|lane| of(&items[lane.min(items.len() - 1)]))
}
