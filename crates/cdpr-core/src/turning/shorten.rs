//! Shortens paths of poses: waypoints are left out, moved towards the straight motion between their neighbours, and corners cut
//! off, as long as all motions stay valid.

use rand::Rng;

use super::pose_space::PoseSpace;
use crate::collision::Validity;
use crate::error::Error;
use crate::geometry::Pose;
use crate::lower_bound::Bound;
use crate::planning::{PathOptimizer, StateSpace};
use crate::watch::Watch;

/// Shortens paths in a space of poses.
pub struct PoseShortener<'a> {
    space: &'a PoseSpace,
    validity: &'a dyn Validity<Pose>,
}

/// Rounds that shorten the path by less than this share are the last.
const WORTH: f64 = 1e-4;
/// Maximum number of rounds, for any path and for those worth the effort.
const ROUNDS: [usize; 2] = [6, 40];
/// A corner is cut off if that shortens the path by more than this share of the whole, so that a curve along a contact gets few
/// waypoints.
const CORNER_WORTH: f64 = 1e-5;
/// Shares of the way to the straight motion that are tried for a waypoint, and of the sides of a corner that is cut off.
const SHARES: [f64; 7] = [1.0, 0.75, 0.5, 0.25, 0.125, 0.03125, 0.0078125];

impl<'a> PoseShortener<'a> {
    /// Shortens paths that are valid according to `validity`.
    pub fn new(space: &'a PoseSpace, validity: &'a dyn Validity<Pose>) -> Self {
        PoseShortener { space, validity }
    }

    fn valid(&self, from: &Pose, to: &Pose) -> bool {
        self.validity.motion_valid(from, to)
    }

    fn rounds(&self, path: &[Pose], most: usize, watch: &Watch) -> Result<Vec<Pose>, Error> {
        let mut path = path.to_vec();
        let mut length = self.space.length(&path);
        for _ in 0..most {
            for round in [Self::without_detours, Self::drawn_in, Self::corners_cut] {
                if watch.expired()? {
                    return Ok(path);
                }
                path = round(self, path);
            }
            let shorter = self.space.length(&path);
            if path.len() == 2 || shorter > length * (1.0 - WORTH) {
                break;
            }
            length = shorter;
        }
        Ok(path)
    }

    /// From each waypoint on to the farthest one that can be reached directly.
    fn without_detours(&self, path: Vec<Pose>) -> Vec<Pose> {
        let mut kept = vec![path[0]];
        let mut at = 0;
        while at + 1 < path.len() {
            let mut next = at + 1;
            for far in (at + 2..path.len()).rev() {
                let way = self.space.length(&path[at..=far]);
                if self.space.distance(&path[at], &path[far]) <= way && self.valid(&path[at], &path[far]) {
                    next = far;
                    break;
                }
            }
            kept.push(path[next]);
            at = next;
        }
        kept
    }

    /// Each waypoint moved towards the straight motion between its neighbours: as a whole, only its position, or only its
    /// orientation.
    fn drawn_in(&self, mut path: Vec<Pose>) -> Vec<Pose> {
        for k in 1..path.len() - 1 {
            let [before, here, after] = [path[k - 1], path[k], path[k + 1]];
            let way = |pose: &Pose| self.space.distance(&before, pose) + self.space.distance(pose, &after);
            let first = self.space.distance(&before, &here);
            let straight = before.toward(&after).at(first / way(&here).max(f64::MIN_POSITIVE));
            let there = here.toward(&straight);
            let tries = SHARES.iter().flat_map(|&share| {
                let moved = there.at(share);
                [moved, Pose::new(moved.position, here.orientation), Pose::new(here.position, moved.orientation)]
            });
            let shorter = |pose: &Pose| way(pose) < way(&here) * (1.0 - 1e-9);
            let better = tries.filter(shorter).find(|pose| self.valid(&before, pose) && self.valid(pose, &after));
            path[k] = better.unwrap_or(here);
        }
        path
    }

    /// Each corner replaced by two, as far from it as possible.
    fn corners_cut(&self, path: Vec<Pose>) -> Vec<Pose> {
        let mut cut = vec![path[0]];
        let least = CORNER_WORTH * self.space.length(&path);
        for k in 1..path.len() - 1 {
            let [before, here, after] = [*cut.last().expect("the start"), path[k], path[k + 1]];
            let found = SHARES[1..].iter().find_map(|&share| {
                let [from, to] = [&before, &after].map(|end| here.toward(end).at(0.5 * share));
                let saved = self.space.distance(&from, &here) + self.space.distance(&here, &to)
                    - self.space.distance(&from, &to);
                (saved > least && self.valid(&from, &to)).then_some([from, to])
            });
            // What remains of both sides is part of valid motions, but its ends are rounded, so it is checked again.
            match found.filter(|[from, to]| self.valid(&before, from) && self.valid(to, &after)) {
                Some(corner) => cut.extend(corner),
                None => cut.push(here),
            }
        }
        cut.push(path[path.len() - 1]);
        cut
    }
}

impl PathOptimizer<Pose> for PoseShortener<'_> {
    fn shortened(&self, path: &[Pose], _: f64, watch: &Watch) -> Result<Vec<Pose>, Error> {
        if path.len() < 3 { Ok(path.to_vec()) } else { self.rounds(path, ROUNDS[0], watch) }
    }

    fn polished(&self, path: &[Pose], watch: &Watch) -> Result<Vec<Pose>, Error> {
        if path.len() < 3 { Ok(path.to_vec()) } else { self.rounds(path, ROUNDS[1], watch) }
    }

    fn lower_bound(&self, [from, to]: [&Pose; 2], _: f64, _: usize, _: &Watch) -> Result<Bound<Pose>, Error> {
        Ok(Bound { length: self.space.distance(from, to), way: Vec::new() })
    }

    fn sample(&self, _: &dyn Fn(&Pose) -> bool, _: &mut dyn Rng, _: &Watch) -> Result<Option<Pose>, Error> {
        Ok(None)
    }
}
