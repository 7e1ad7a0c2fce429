//! Many questions at once, on one thread or several, with the same answers.

use rayon::prelude::*;

use super::validity::Validity;
use crate::geometry::Point;

/// Questions handed to a thread at a time: enough to forget the cost of handing over.
const CHUNK: usize = 256;

/// Answers `question(k)` into `answers[k]`. Runs on the rayon pool it is called in; serially where that has one thread.
fn answer_all(answers: &mut [bool], question: impl Fn(usize) -> bool + Sync) {
    answers.par_chunks_mut(CHUNK).enumerate().for_each(|(chunk, answers)| {
        for (k, answer) in answers.iter_mut().enumerate() {
            *answer = question(chunk * CHUNK + k);
        }
    });
}

/// Whether each position is valid. `position(k)` gives the k-th one.
pub fn states_valid(validity: &dyn Validity, position: impl Fn(usize) -> Point + Sync, answers: &mut [bool]) {
    answer_all(answers, |k| validity.state_valid(&position(k)));
}

/// Whether each motion is valid. `motion(k)` gives both ends of the k-th one.
pub fn motions_valid(validity: &dyn Validity, motion: impl Fn(usize) -> (Point, Point) + Sync, answers: &mut [bool]) {
    answer_all(answers, |k| {
        let (from, to) = motion(k);
        validity.motion_valid(&from, &to)
    });
}
