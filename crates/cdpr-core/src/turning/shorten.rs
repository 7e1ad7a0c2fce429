//! Shortens paths of poses: waypoints are left out, moved towards the straight motion between their neighbours, and corners cut
//! off, as long as all motions stay valid. In the end, waypoints that shorten the path by hardly anything are joined.

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

/// A round that shortens the path by less than this share is the last one.
const WORTH: f64 = 1e-4;
/// Maximum number of rounds, for any path and for those worth the effort.
const ROUNDS: [usize; 2] = [6, 40];
/// A corner is cut off if that shortens the path by more than this share of the whole, so that a curve along a contact gets few
/// waypoints.
const CORNER_WORTH: f64 = 1e-5;
/// Shares of the way to the straight motion that are tried for a waypoint, and of the sides of a corner that is cut off.
const SHARES: [f64; 7] = [1.0, 0.75, 0.5, 0.25, 0.125, 0.03125, 0.0078125];

/// A path may become longer by this share in exchange for fewer waypoints.
const FEWER_WORTH: f64 = 1e-3;
/// Where one waypoint is tried in place of two: beyond the first one or before the second one, as multiples of the distance between
/// them.
const BEYOND: [f64; 6] = [0.1, 0.25, 0.5, 1.0, 2.0, 4.0];

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

    /// Connects each waypoint to the farthest one that can be reached from it directly.
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

    /// The path as short as it can be made, and then with fewer waypoints: two are replaced by one where that hardly makes it longer,
    /// and not longer than `longest`.
    ///
    /// # Errors
    /// [`Error::interrupted`] if the watch requests it; a deadline ends it early.
    pub fn simplified(&self, path: &[Pose], longest: f64, watch: &Watch) -> Result<Vec<Pose>, Error> {
        if path.len() < 3 {
            return Ok(path.to_vec());
        }
        let mut path = self.rounds(path, ROUNDS[1], watch)?;
        let shortest = self.space.length(&path);
        let longest = longest.clamp(shortest, shortest * (1.0 + FEWER_WORTH));
        loop {
            let count = path.len();
            let mut k = 1;
            while k + 2 < path.len() {
                if watch.expired()? {
                    return Ok(path);
                }
                let longer = longest - self.space.length(&path);
                match self.in_place_of_two(&path[k - 1..k + 3], longer) {
                    Some(pose) => {
                        path.splice(k..k + 2, [pose]);
                        k = (k - 1).max(1);
                    }
                    None => k += 1,
                }
            }
            path = self.drawn_in(path);
            if path.len() == count {
                return Ok(path);
            }
        }
    }

    /// The pose that replaces the middle two of four with the least increase of the length, which must not exceed
    /// `longer`.
    fn in_place_of_two(&self, four: &[Pose], longer: f64) -> Option<Pose> {
        let [before, first, second, after] = four else { unreachable!("four poses") };
        let (length, apart) = (self.space.length(four), self.space.distance(first, second));
        let beyond = |start: &Pose, through: &Pose, share: f64| {
            let side = self.space.distance(start, through);
            start.toward(through).beyond(1.0 + share * apart / side.max(f64::MIN_POSITIVE))
        };
        let tries = BEYOND.iter().flat_map(|&share| {
            let ends = [beyond(before, first, share), beyond(after, second, share)];
            [ends[0], ends[1], ends[0].toward(&ends[1]).at(0.5)]
        });
        let longer_by = |pose: &Pose| self.space.distance(before, pose) + self.space.distance(pose, after) - length;
        let mut fitting: Vec<(Pose, f64)> =
            tries.map(|pose| (pose, longer_by(&pose))).filter(|(_, by)| *by <= longer).collect();
        fitting.sort_by(|(_, a), (_, b)| a.total_cmp(b));
        let valid = |pose: &Pose| self.valid(before, pose) && self.valid(pose, after);
        fitting.into_iter().map(|(pose, _)| pose).find(valid)
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
            // The rest of both sides is part of valid motions, but its ends are rounded, so it is checked again.
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
