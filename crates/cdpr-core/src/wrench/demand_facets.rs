//! The facets of the available wrenches at a position, as limits of further wrenches.

use std::borrow::Cow;

use nalgebra::{SVector, Vector6};

use super::kernel::{AllFacets, KernelRobot};
use super::statics::Statics;
use super::zonotope::{Span, for_each_normal};
use crate::geometry::{Placed, Point};
use crate::numerics::BALANCE_RELATIVE;
use crate::numerics::simd::{Kernel, WIDTH};

/// Two parallel facets, in units of their normal c, whose length is arbitrary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FacetPair {
    /// c·w of two wrenches w.
    pub heights: [f64; 2],
    /// What the cables provide in directions c and −c beyond the balance of the loads; nonnegative if they hold the platform.
    pub slack: [f64; 2],
    /// |c|.
    pub norm: f64,
}

/// A position and two wrenches [force; moment / ℓ], N.
pub type Demand = (Point, [Vector6<f64>; 2]);

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

    /// The same by definition instead of by the kernel, for comparison.
    pub fn by_definition(mut self) -> Self {
        self.robot = None;
        self
    }

    /// The robot.
    pub fn statics(&self) -> &Statics {
        &self.statics
    }

    /// Calls `visit` with the index of each demand and the facets at its position. Returns the index of the first demand at
    /// whose position the cables cannot hold the platform.
    pub fn for_each(&self, demands: &[Demand], visit: impl FnMut(usize, &FacetPair)) -> Option<usize> {
        self.visit(demands, None, visit)
    }

    /// As [`DemandFacets::for_each`] with another orientation at each position.
    pub fn for_each_turned(
        &self,
        demands: &[Demand],
        turned: &[Turned],
        visit: impl FnMut(usize, &FacetPair),
    ) -> Option<usize> {
        self.visit(demands, Some(turned), visit)
    }

    fn visit(
        &self,
        demands: &[Demand],
        turned: Option<&[Turned]>,
        mut visit: impl FnMut(usize, &FacetPair),
    ) -> Option<usize> {
        let mut lacking: Option<usize> = None;
        let mut see = |k: usize, facets: FacetPair| {
            let slack = facets.slack.map(|slack| slack - self.margin * facets.norm);
            if !(slack[0].min(slack[1]) >= 0.0) {
                lacking = Some(lacking.map_or(k, |first| first.min(k)));
            }
            visit(k, &FacetPair { slack, ..facets });
        };
        for (group, four) in demands.chunks(WIDTH).enumerate() {
            let first = group * WIDTH;
            let turns = turned.map(|turned| &turned[first..first + four.len()]);
            let robot = self.robot.as_ref().map(|robot| self.at_turns(robot, turns));
            let sure = robot.map_or([-1.0; WIDTH], |robot| self.by_kernel(&robot, first, four, &mut see));
            for (lane, (position, wrenches)) in four.iter().enumerate().filter(|(lane, _)| !(sure[*lane] >= 0.0)) {
                let statics = turns.map(|turns| self.statics.turned(&turns[lane].0, turns[lane].1));
                let statics = statics.as_ref().unwrap_or(&self.statics);
                if !self.defined(statics, position, wrenches, &mut |facets| see(first + lane, facets)) {
                    see(first + lane, FacetPair { heights: [0.0; 2], slack: [f64::NAN; 2], norm: 0.0 });
                }
            }
        }
        lacking
    }

    /// The robot at up to four turns.
    fn at_turns<'a>(&self, robot: &'a KernelRobot, turns: Option<&[Turned]>) -> Cow<'a, KernelRobot> {
        let Some(turns) = turns else { return Cow::Borrowed(robot) };
        let at = |lane: usize| &turns[lane.min(turns.len() - 1)];
        let (poses, balances) = (std::array::from_fn(|lane| at(lane).0), std::array::from_fn(|lane| at(lane).1.into()));
        Cow::Owned(robot.at_orientations(&self.statics, &poses, &balances))
    }

    /// The facets of up to four demands by the kernel, where it is sure.
    fn by_kernel(
        &self,
        robot: &KernelRobot,
        first: usize,
        four: &[Demand],
        see: &mut impl FnMut(usize, FacetPair),
    ) -> [f64; WIDTH] {
        let at = |lane: usize| &four[lane.min(four.len() - 1)];
        let positions = std::array::from_fn(|lane| at(lane).0);
        let wrenches = std::array::from_fn(|lane| at(lane).1.map(Into::into));
        let (facets, sure) = self.kernel.run(AllFacets { robot, positions, wrenches });
        for lane in (0..four.len()).filter(|lane| sure[*lane] >= 0.0) {
            for facet in facets.iter().filter(|facet| facet.norm[lane] > 0.0) {
                let (heights, slack) = (facet.heights.map(|h| h[lane]), facet.slack.map(|s| s[lane]));
                see(first + lane, FacetPair { heights, slack, norm: facet.norm[lane] });
            }
        }
        sure
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
        // Nothing is available in these directions; rounding errors are no demand.
        let nothing = self.margin + BALANCE_RELATIVE * self.statics.largest_tension();
        for normal in span.left_null() {
            facets(normal, [nothing; 2]);
        }
    }
}
