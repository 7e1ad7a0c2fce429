//! The cspace engine against the gjk engine and against exact tests, on random and degenerate states and motions of
//! random scenes: rotated general polytopes, platforms of several parts, flat ones, attachments off a part, outlets on
//! obstacles, abutting parts, cable length limits, clearances, diameters, small and large workspaces.
//!
//! `CDPR_VERIFY=n` runs n times as many cases (`make verify`).

use cdpr_core::Scene;
use cdpr_core::collision::{Checker, CspaceEngine, GjkEngine, Interference, Kind as ViolationKind, Validity};
use cdpr_core::geometry::Point;
use cdpr_core::planning::{StateSpace, TranslationSpace};
use cdpr_core::tolerances::GAP_TOLERANCE;
use cdpr_tests::scenes::{Kind, Oracle, Verdict, scene};
use cdpr_tests::{direction, effort, rng, uniform};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// Factor on the everyday number of cases.
struct Engines {
    gjk: GjkEngine,
    cspace: CspaceEngine,
    space: TranslationSpace,
}

impl Engines {
    fn of(scene: &Scene, interference: Interference) -> Self {
        let gjk = GjkEngine::new(scene, interference).unwrap();
        let space = TranslationSpace::of(gjk.conditions());
        Engines { cspace: CspaceEngine::new(scene, interference).unwrap(), gjk, space }
    }

    /// A position where validity changes, to the last bit, or a random position.
    fn contact(&self, rng: &mut ChaCha8Rng) -> Point {
        let mut ends = [self.space.sample(rng).unwrap(), self.space.sample(rng).unwrap()];
        let valid = ends.map(|p| self.gjk.state_valid(&p));
        if valid[0] == valid[1] {
            return ends[0];
        }
        for _ in 0..60 {
            let middle = ends[0] + (ends[1] - ends[0]) * 0.5;
            ends[usize::from(self.gjk.state_valid(&middle) != valid[0])] = middle;
        }
        ends[rng.random_range(0..2)]
    }

    /// A state or a motion: anywhere, tiny, along an axis, at a contact, nearly along the surface there.
    fn motion(&self, rng: &mut ChaCha8Rng) -> (Point, Point) {
        let from = if rng.random_bool(0.4) { self.contact(rng) } else { self.space.sample(rng).unwrap() };
        let length = 10f64.powf(uniform(rng, -9.5, 0.3));
        let to = match rng.random_range(0..6) {
            0 => from,
            1 => self.contact(rng),
            2 => from + cdpr_core::geometry::Vector::ith(rng.random_range(0..3), length),
            3 => self.space.sample(rng).unwrap(),
            _ => from + direction(rng) * length,
        };
        (from, to)
    }

    /// Whether the engines may differ on a motion: no gap is violated by more than the tolerance.
    fn may_differ(&self, (p, q): (Point, Point), rng: &mut ChaCha8Rng) -> bool {
        let by_little = |margin: f64| margin.abs() <= GAP_TOLERANCE;
        let told = [self.gjk.violations(&p, &q), self.cspace.violations(&p, &q)];
        // The margin of a crossing is always 0, so there the answer must change when the motion is shifted.
        let crossing = told.iter().flatten().any(|v| v.kind == ViolationKind::CableCable);
        told.iter().flatten().all(|v| v.margin.is_some_and(by_little)) && (!crossing || self.on_an_edge(&p, &q, rng))
    }

    /// Whether the answer of the gjk engine depends on a shift by twice the tolerance.
    fn on_an_edge(&self, p: &Point, q: &Point, rng: &mut ChaCha8Rng) -> bool {
        let valid = self.gjk.motion_valid(p, q);
        (0..64).any(|_| {
            let shift = direction(rng) * (2.0 * GAP_TOLERANCE);
            self.gjk.motion_valid(&(p + shift), &(q + shift)) != valid
        })
    }
}

fn agree_on(seed: u64, kind: Kind, interference: Interference, motions: usize) -> [usize; 2] {
    let mut rng = rng(seed);
    let scene = scene(&mut rng, kind);
    let engines = Engines::of(&scene, interference);
    let oracle = (kind.clearance + kind.diameter == 0.0 && !kind.special).then(|| Oracle::of(&scene));
    if (engines.space.max - engines.space.min).min() < 0.0 {
        return [0, 0];
    }
    let mut count = [0, 0];
    for _ in 0..motions {
        let (p, q) = engines.motion(&mut rng);
        let valid = engines.cspace.motion_valid(&p, &q);
        count[usize::from(valid)] += 1;
        if valid != engines.gjk.motion_valid(&p, &q) {
            let (a, b) = (engines.cspace.violations(&p, &q), engines.gjk.violations(&p, &q));
            eprintln!("seed {seed}, {kind:?}: {p:?} to {q:?}: cspace {a:?}, gjk {b:?}");
            assert!(engines.may_differ((p, q), &mut rng), "the engines differ by more than the tolerance");
        }
        if let Some(oracle) = oracle.as_ref().filter(|_| interference == Interference::Exact) {
            let verdict = oracle.judge(&p, &q);
            let room = p.iter().chain(q.iter()).all(|x| x.abs() < 9.0);
            assert!(
                !room || verdict == Verdict::Either || valid == (verdict == Verdict::Free),
                "seed {seed}: {p:?} to {q:?}: cspace {valid}, exact test {verdict:?}"
            );
        }
        if rng.random_bool(0.2) {
            let told = engines.cspace.violations(&p, &q).is_empty();
            assert_eq!(valid, told, "seed {seed}: {p:?} to {q:?}: the explanation contradicts");
        }
    }
    count
}

/// Each scene has its own seed, so that any printed case can be reproduced.
fn agree(first_seed: u64, scenes: u64, motions: usize, kind: impl Fn(u64) -> (Kind, Interference) + Sync) {
    let one = |seed: u64| {
        let (kind, interference) = kind(seed);
        agree_on(first_seed + seed, kind, interference, motions)
    };
    let counts: Vec<[usize; 2]> = (0..scenes * effort()).into_par_iter().map(one).collect();
    let [hits, free] = [0, 1].map(|k| counts.iter().map(|c| c[k]).sum::<usize>());
    eprintln!("{hits} refused, {free} free");
    assert!(hits > 500 && free > 500);
}

#[test]
fn plain_scenes() {
    agree(0, 150, 60, |_| (Kind::default(), Interference::Exact));
}

#[test]
fn special_scenes() {
    agree(1 << 40, 150, 60, |_| (Kind { special: true, ..Kind::default() }, Interference::Exact));
}

#[test]
fn scenes_with_clearance_and_thick_cables() {
    agree(2 << 40, 150, 60, |seed| {
        let clearance = [0.001, 0.02, 0.1, 0.0][seed as usize % 4];
        let diameter = [0.0, 0.01, 0.05][seed as usize % 3];
        (Kind { clearance, diameter, special: seed % 2 == 0, mixed: false }, Interference::Exact)
    });
}

#[test]
fn scenes_with_a_clearance_for_each_pair() {
    agree(4 << 40, 200, 60, |seed| {
        let diameter = [0.0, 0.0, 0.02][seed as usize % 3];
        let interference = if seed % 8 == 0 { Interference::Swept } else { Interference::Exact };
        (Kind { clearance: 0.01, diameter, special: seed % 2 == 0, mixed: true }, interference)
    });
}

#[test]
fn the_swept_rule() {
    agree(3 << 40, 100, 60, |seed| {
        let clearance = [0.0, 0.05][seed as usize % 2];
        (Kind { special: seed % 4 < 2, clearance, ..Kind::default() }, Interference::Swept)
    });
}
