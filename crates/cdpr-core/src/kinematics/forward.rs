//! Forward kinematics: the pose of the platform from the lengths of its cables.
//!
//! The pose minimises the sum of squares of the residuals, given lengths minus lengths at the pose. A step is a
//! displacement d of the platform's origin and a turn by the rotation vector θ about it, in world axes. It changes the length
//! of cable i at the rate -uᵢ·d - (rᵢ × uᵢ)·θ, where uᵢ points from the attachment along the cable, also round a pulley, and rᵢ
//! from the origin to the attachment: the Jacobian of the lengths is minus the transpose of the wrench matrix. Turns are
//! measured as ρθ, in metres, with ρ the root mean square of |rᵢ|, so that all columns of the Jacobian are alike.
//!
//! The method is that of Levenberg and Marquardt: each step solves (JᵀJ + λ I) x = Jᵀ (residuals), and is taken if it
//! does not increase the sum. λ decreases after steps that gain about as much as they would if lengths were linear, and
//! increases after those that gain hardly anything; near a solution the steps become those of Gauss and Newton. Other minima of the sum
//! are looked for in [`folds`].
//!
//! Source: K. Levenberg 1944, D. Marquardt 1963; for cable robots A. Pott, *Cable-Driven Parallel Robots*, Springer 2018,
//! chapter 4. The first guess is trilateration: with qᵢ = bᵢ - rᵢ, differences of |p - qᵢ|² = lᵢ² are linear in p.

use nalgebra::{Matrix3, Matrix6, Vector6};

use super::{cable_lengths, meet_in_one_point, no_direction};
use crate::error::Error;
use crate::geometry::{Departure, Point, Pose, Rotation, Vector, turn_about};
use crate::limits::{MAX_COORDINATE, POSE_ITERATIONS, POSE_SLOW};
use crate::model::{Robot, body};
use crate::tolerances::{
    POSE_EXACT_RELATIVE, POSE_FIT_RELATIVE, POSE_RANK_RELATIVE, POSE_STEP, SAME_FIT, SAME_SOLUTION_RELATIVE,
};
use crate::watch::Watch;
use crate::words::{count, length};

mod folds;
mod sums;

use folds::FOLDS;
use sums::{LEAST_DAMPING, Sums, damping_change, least_eigenvalue};

/// Damping λ of the first step, as a share of the mean square of the Jacobian's columns.
const FIRST_DAMPING: f64 = 1e-4;
/// Step for second derivatives of lengths, as a share of their mean.
const BEND_STEP: f64 = 1e-3;
/// Finds poses of a robot from the lengths of its cables: position and orientation, or the position alone at a known
/// orientation.
///
/// # Example
/// ```
/// use cdpr_core::{Point, Rotation, kinematics::{ForwardKinematics, cable_lengths}, testing};
/// let scene = testing::empty();
/// let position = Point::new(0.7, 1.2, 0.9);
/// let lengths = cable_lengths(scene.robot(), &Rotation::identity(), &position);
/// let found = ForwardKinematics::new(scene.robot(), Some(Rotation::identity()))?.estimate(&lengths, None)?;
/// assert!((found.pose.position - position).norm() < 1e-9 && found.is_determined());
/// # Ok::<(), cdpr_core::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct ForwardKinematics<'a> {
    robot: &'a Robot,
    orientation: Option<Rotation>,
    /// Root mean square of the distances of the attachments from the platform's origin, m.
    reach: f64,
}

/// A pose found from the lengths of cables.
#[derive(Debug, Clone, PartialEq)]
pub struct PoseEstimate {
    /// The pose; its orientation is the given one if only the position was to be found.
    pub pose: Pose,
    /// For each cable, the given length minus that at the pose, m.
    pub residuals: Vec<f64>,
    /// Rank of the Jacobian of the lengths at the pose; singular values below [`POSE_RANK_RELATIVE`] of the largest
    /// count as zero.
    pub rank: usize,
    /// The rank at which the lengths determine the pose: 6, or 3 at a given orientation.
    pub full_rank: usize,
    /// Covariance of the position, m, and of the rotation vector of the orientation error, world axes, rad, if the lengths have
    /// independent errors of variance 1 m²: multiply by the variance of the lengths. The rows of a given orientation are zero;
    /// `None` if the rank is not full.
    pub covariance: Option<Matrix6<f64>>,
    /// Number of steps that were tried.
    pub iterations: usize,
}

impl PoseEstimate {
    /// Whether the lengths determine the pose: the rank is full.
    pub fn is_determined(&self) -> bool {
        self.rank == self.full_rank
    }

    /// The residual that is largest in absolute value, m, and the index of its cable.
    pub fn largest_residual(&self) -> (usize, f64) {
        let indexed = self.residuals.iter().copied().enumerate();
        indexed.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).expect("a robot has cables")
    }

    /// Whether the root mean square of the residuals is at most twice that of another pose, or hardly more.
    pub fn fits_as_well_as(&self, other: &PoseEstimate) -> bool {
        self.fit() <= 2.0 * other.fit() + SAME_FIT
    }

    /// Root mean square of the residuals, m.
    pub fn fit(&self) -> f64 {
        (self.residuals.iter().map(|r| r * r).sum::<f64>() / self.residuals.len() as f64).sqrt()
    }
}

impl<'a> ForwardKinematics<'a> {
    /// Prepares to find position and orientation, or only the position if the orientation is given.
    ///
    /// # Errors
    /// Fewer cables than unknowns; without an orientation also cables that meet in one point of the platform, whose
    /// lengths do not depend on how it turns about that point.
    pub fn new(robot: &'a Robot, orientation: Option<Rotation>) -> Result<Self, Error> {
        let cables = robot.cables();
        let unknowns = if orientation.is_some() { 3 } else { 6 };
        if cables.len() < unknowns {
            let (found, hint) = (count(cables.len(), "cable"), "; give the orientation to find the position alone");
            let (what, hint) = if unknowns == 6 { ("position and orientation", hint) } else { ("a position", "") };
            return Err(Error::invalid(
                "cables",
                format!("found {found}, expected at least {unknowns} to find {what}{hint}"),
            ));
        }
        let arms = || cables.iter().map(|cable| cable.attachment.coords);
        if unknowns == 6 && meet_in_one_point(arms()) {
            let problem = "found attachments at one point, so that the lengths do not determine the orientation; give the \
                           orientation to find the position alone";
            return Err(Error::invalid("cables", problem));
        }
        let reach = (arms().map(|arm| arm.norm_squared()).sum::<f64>() / cables.len() as f64).sqrt();
        Ok(ForwardKinematics { robot, orientation, reach })
    }

    /// The pose whose cable lengths are nearest to these, m, in the order of the cables: the minimum of the sum of squares of the
    /// residuals to which the search leads from `guess`. If residuals are left that rounding does not explain, the further starts of
    /// [`ForwardKinematics::others`] are tried: another minimum is better if it fits twice as well, and by a larger factor than that by
    /// which it is farther from the guess. So the pose of exact lengths is found behind others that only nearly have them, and noise
    /// does not lead away from a near guess.
    ///
    /// Without a guess, the search leads from [`ForwardKinematics::first_guess`] and starts around it, and the first minimum is kept
    /// unless another one fits twice as well.
    ///
    /// Residuals may be large: lengths that no pose has are no error.
    ///
    /// # Errors
    /// A wrong number of lengths; a length that is not positive or not finite; a guess that is not finite, or at which a cable cannot
    /// leave its pulley; no convergence.
    pub fn estimate(&self, lengths: &[f64], guess: Option<&Pose>) -> Result<PoseEstimate, Error> {
        self.checked(lengths)?;
        let Some(guess) = guess else { return self.estimate_from_anywhere(lengths) };
        body::coordinates("guess", guess.position.coords.as_slice())?;
        self.nearest(lengths, guess, true)
    }

    /// The poses for rows of lengths, each found from the one before, as encoders report them; the first one from `guess`. From a pose
    /// so near, only one further start is tried if residuals are left, unless the search does not converge: rows with noise take some
    /// four times as long as exact ones. `named` adds the place of a row to its error.
    ///
    /// # Errors
    /// The errors of [`ForwardKinematics::estimate`] and [`Watch::check`].
    pub fn follow<'r>(
        &self,
        rows: impl IntoIterator<Item = &'r [f64]>,
        guess: Option<Pose>,
        named: impl Fn(Error, usize) -> Error,
        watch: &Watch,
    ) -> Result<Vec<PoseEstimate>, Error> {
        let mut found: Vec<PoseEstimate> = Vec::new();
        for (k, lengths) in rows.into_iter().enumerate() {
            watch.check()?;
            let next = match found.last() {
                Some(last) => self.checked(lengths).and_then(|()| self.nearest(lengths, &last.pose, false)),
                None => self.estimate(lengths, guess.as_ref()),
            };
            found.push(next.map_err(|e| named(e, k))?);
        }
        Ok(found)
    }

    /// Other poses that have the same lengths: local minima with a root mean square of at most twice that of `found`, nearest
    /// first.
    ///
    /// The search begins beyond folds (where the lengths would be nearly the same again in one of the three directions in which they
    /// change least), and at `found` moved by the mean length of the cables to both sides along each world axis and, unless the
    /// orientation is given, turned by 90° to both sides about each. It does not find every solution. At a rank that is not full
    /// there is none to find: the poses nearby have nearly the same lengths.
    ///
    /// # Errors
    /// The errors of [`ForwardKinematics::estimate`] about the lengths.
    pub fn others(&self, lengths: &[f64], found: &PoseEstimate) -> Result<Vec<PoseEstimate>, Error> {
        self.checked(lengths)?;
        let mut others: Vec<PoseEstimate> = Vec::new();
        if !found.is_determined() {
            return Ok(others);
        }
        let apart = SAME_SOLUTION_RELATIVE * mean(lengths);
        let minima = self.minima_beyond(lengths, &found.pose).chain(self.minima_around(lengths, &found.pose));
        let fitting = minima.filter(|other| other.fits_as_well_as(found));
        for other in fitting {
            if [found].into_iter().chain(&others).all(|known| self.distance(&known.pose, &other.pose) > apart) {
                others.push(other);
            }
        }
        let away = |other: &PoseEstimate| self.distance(&found.pose, &other.pose);
        others.sort_by(|a, b| away(a).total_cmp(&away(b)));
        Ok(others)
    }

    /// A guess from lengths alone, by trilateration: at the given orientation or, if there is none, with the axes of the platform
    /// parallel to those of the world. If all outlets lie in a plane, relative to the attachments, the guess is below it.
    pub fn first_guess(&self, lengths: &[f64]) -> Pose {
        let orientation = self.orientation.unwrap_or_else(Rotation::identity);
        let cables = self.robot.cables();
        let ends: Vec<Vector> =
            cables.iter().map(|cable| cable.outlet.coords - orientation * cable.attachment.coords).collect();
        let share = 1.0 / ends.len() as f64;
        let centre = share * ends.iter().sum::<Vector>();
        let spread = share * ends.iter().map(|end| (end - centre).norm_squared()).sum::<f64>();
        let squares = share * lengths.iter().map(|length| length * length).sum::<f64>();
        let (mut matrix, mut right) = (Matrix3::zeros(), Vector::zeros());
        for (end, length) in ends.iter().map(|end| end - centre).zip(lengths) {
            matrix += end * end.transpose();
            right += 0.5 * (end.norm_squared() - spread - length * length + squares) * end;
        }
        // In the directions across all ends, only the distance from the centre is known.
        let axes = matrix.symmetric_eigen();
        let flat = POSE_RANK_RELATIVE * axes.eigenvalues.max();
        let (mut offset, mut across) = (Vector::zeros(), Vector::zeros());
        for (value, axis) in axes.eigenvalues.iter().zip(axes.eigenvectors.column_iter()) {
            match *value > flat {
                true => offset += axis * (axis.dot(&right) / value),
                false => across -= axis * if axis.z < 0.0 { -1.0 } else { 1.0 },
            }
        }
        let beyond = (squares - spread - offset.norm_squared()).max(0.0).sqrt();
        if let Some(across) = across.try_normalize(0.5) {
            offset += beyond * across;
        }
        Pose::new(Point::from(centre + offset), orientation)
    }

    /// The minimum found from the first guess, or one found from further starts that fits the lengths twice as well.
    fn estimate_from_anywhere(&self, lengths: &[f64]) -> Result<PoseEstimate, Error> {
        let guess = self.first_guess(lengths);
        let first = self.minimised(lengths, &guess);
        if first.as_ref().is_ok_and(|first| first.fit() <= SAME_FIT) {
            return first;
        }
        let best = self.minima_around(lengths, &guess).min_by(|a, b| a.fit().total_cmp(&b.fit()));
        match (first, best) {
            (Ok(first), Some(best)) if first.fits_as_well_as(&best) => Ok(first),
            (_, Some(best)) => Ok(best),
            (first, None) => first,
        }
    }

    /// The minimum to which the search leads from a guess, or a better one from further starts: all, or only few of them unless the guess
    /// may be `far` from the pose.
    fn nearest(&self, lengths: &[f64], guess: &Pose, far: bool) -> Result<PoseEstimate, Error> {
        let guess = Pose::new(guess.position, self.orientation.unwrap_or(guess.orientation));
        let exact = |found: &PoseEstimate| found.fit() <= POSE_EXACT_RELATIVE * mean(lengths);
        let mut best = self.minimised(lengths, &guess);
        if self.sums(lengths, &guess).is_none() {
            return best;
        }
        // Neither the noise of the lengths nor the error of the guess is known, but how two minima compare in both.
        let price = |found: &PoseEstimate| found.fit() * self.distance(&guess, &found.pose);
        let better =
            |other: &PoseEstimate, best: &PoseEstimate| 2.0 * other.fit() < best.fit() && price(other) < price(best);
        let improve = |best: &mut Result<PoseEstimate, Error>, others: &mut dyn Iterator<Item = PoseEstimate>| {
            while !best.as_ref().is_ok_and(exact) {
                let Some(other) = others.next() else { break };
                if best.as_ref().map_or(true, |best| better(&other, best)) {
                    *best = Ok(other);
                }
            }
        };
        if best.is_err() {
            improve(&mut best, &mut self.minima_around(lengths, &guess));
        }
        if let Ok(PoseEstimate { pose, .. }) = best {
            improve(&mut best, &mut self.minima_beyond(lengths, &pose).take(if far { FOLDS } else { 1 }));
            if far {
                improve(&mut best, &mut self.minima_around(lengths, &pose));
            }
        }
        best
    }

    /// Checks that there is one possible length for each cable.
    fn checked(&self, lengths: &[f64]) -> Result<(), Error> {
        let cables = self.robot.cables();
        if lengths.len() != cables.len() {
            let (found, expected) = (count(lengths.len(), "length"), cables.len());
            return Err(Error::invalid("", format!("found {found}, expected {expected}, one for each cable")));
        }
        match cables.iter().zip(lengths).find(|(_, length)| !(**length > 0.0 && **length <= MAX_COORDINATE)) {
            None => Ok(()),
            Some((cable, length)) => Err(Error::invalid(
                &cable.name,
                format!("found a length of {length} m, expected a positive number of at most {MAX_COORDINATE:e}"),
            )),
        }
    }

    /// The local minimum to which the search leads from a pose.
    fn minimised(&self, lengths: &[f64], guess: &Pose) -> Result<PoseEstimate, Error> {
        let orientation = self.orientation.unwrap_or(guess.orientation);
        let mut pose = Pose::new(guess.position, orientation);
        let mut here = self.sums(lengths, &pose).ok_or_else(|| self.out_of_reach(&pose))?;
        let [fitted, exact] = [POSE_FIT_RELATIVE, POSE_EXACT_RELATIVE]
            .map(|share| lengths.len() as f64 * (share * mean(lengths)).powi(2));
        let (mut damping, mut blocked) = (FIRST_DAMPING, false);
        for iterations in 0..=POSE_ITERATIONS {
            if here.squares <= fitted {
                return Ok(self.estimate_at(lengths, pose, &here, iterations));
            }
            // Where residuals times curvature are as large as the squares of the Jacobian, Gauss and Newton's steps are slow.
            let curved = if iterations < POSE_SLOW { None } else { self.curved(lengths, &pose, &here) };
            let model = curved.filter(|curved| curved.step(damping).is_some()).unwrap_or(here);
            let Some(step) = model.step(damping) else { break };
            let moved = self.moved(&pose, &step);
            let there = self.sums(lengths, &moved);
            blocked = there.is_none();
            let gain = there.as_ref().map_or(f64::NEG_INFINITY, |there| model.gain(there, &step, damping));
            // The gain of a step of rounding errors is due to rounding.
            let rounded = gain <= if here.squares <= exact { 0.5 } else { 0.0 };
            let settled = !blocked
                && step.norm() <= POSE_STEP
                && (model.is_settled() || rounded)
                && here.is_balanced(lengths.len());
            damping = (damping * damping_change(gain)).max(LEAST_DAMPING);
            if let Some(there) = there.filter(|_| gain >= 0.0) {
                (pose, here) = (moved, there);
            }
            if settled {
                return Ok(self.estimate_at(lengths, pose, &here, iterations + 1));
            }
        }
        Err(no_pose(&pose, (here.squares / lengths.len() as f64).sqrt(), blocked))
    }

    /// The error for a pose at which a cable has no direction.
    fn out_of_reach(&self, pose: &Pose) -> Error {
        let attachment = |arm: &Point| pose.position + pose.orientation * arm.coords;
        let attachments = self.robot.cables().iter().map(|cable| (cable, attachment(&cable.attachment)));
        let mut lost = attachments.filter(|(cable, attachment)| cable.departure(attachment).is_none());
        let (cable, attachment) = lost.next().expect("a cable without direction");
        no_direction(cable, &attachment).under("guess")
    }

    fn estimate_at(&self, lengths: &[f64], pose: Pose, here: &Sums, iterations: usize) -> PoseEstimate {
        let lengths_there = cable_lengths(self.robot, &pose.orientation, &pose.position);
        let residuals = lengths.iter().zip(lengths_there).map(|(given, there)| given - there).collect();
        let full_rank = self.unknowns();
        let axes = here.matrix.symmetric_eigen();
        let least = least_eigenvalue(&axes);
        let rank = axes.eigenvalues.iter().filter(|value| **value > least).count();
        let inverse = || {
            let spread = axes.eigenvalues.map(|value| if value > least { 1.0 / value } else { 0.0 });
            let metric = self.metric();
            metric * axes.eigenvectors * Matrix6::from_diagonal(&spread) * axes.eigenvectors.transpose() * metric
        };
        let covariance = (rank == full_rank).then(inverse);
        PoseEstimate { pose, residuals, rank, full_rank, covariance, iterations }
    }

    /// Converts steps to metres and radians.
    fn metric(&self) -> Matrix6<f64> {
        let turn = 1.0 / self.reach;
        let turn = if self.orientation.is_some() { 0.0 } else { turn };
        Matrix6::from_diagonal(&Vector6::new(1.0, 1.0, 1.0, turn, turn, turn))
    }

    fn moved(&self, pose: &Pose, step: &Vector6<f64>) -> Pose {
        let position = pose.position + step.fixed_rows::<3>(0);
        if self.orientation.is_some() {
            return Pose::new(position, pose.orientation);
        }
        let turn: Vector = step.fixed_rows::<3>(3) / self.reach;
        let angle = turn.norm();
        let turned = if angle > 0.0 { turn_about(&(turn / angle), angle) } else { Rotation::identity() };
        Pose::new(position, Rotation::new_normalize((turned * pose.orientation).into_inner()))
    }

    /// Distance of two poses, m: of their origins, plus the angle between them times the distance of the attachments.
    fn distance(&self, a: &Pose, b: &Pose) -> f64 {
        (a.position - b.position).norm() + self.reach * a.angle_to(b)
    }

    /// The sums with the second derivatives of half the sum of squares as matrix: differences of the gradient. `None` if a cable has no
    /// direction nearby.
    fn curved(&self, lengths: &[f64], pose: &Pose, here: &Sums) -> Option<Sums> {
        let size = BEND_STEP * mean(lengths);
        let mut matrix = Matrix6::zeros();
        for k in 0..self.unknowns() {
            let step = Vector6::ith(k, size);
            let [ahead, behind] = [step, -step].map(|step| self.sums(lengths, &self.moved(pose, &step)));
            matrix.set_column(k, &((behind?.right - ahead?.right) / (2.0 * size)));
        }
        Some(Sums { matrix: 0.5 * (matrix + matrix.transpose()), ..*here })
    }

    /// The rows of the Jacobian and the lengths at a pose, for each cable; `None` if it has no direction there.
    fn rows(&self, &pose: &Pose) -> impl Iterator<Item = Option<(Vector6<f64>, f64)>> {
        let turn = if self.orientation.is_some() { 0.0 } else { 1.0 / self.reach };
        self.robot.cables().iter().map(move |cable| {
            let arm = pose.orientation * cable.attachment.coords;
            let Departure { pull, length, .. } = cable.departure(&(pose.position + arm))?;
            let moment = arm.cross(&pull) * turn;
            Some((-Vector6::new(pull.x, pull.y, pull.z, moment.x, moment.y, moment.z), length))
        })
    }

    fn unknowns(&self) -> usize {
        if self.orientation.is_some() { 3 } else { 6 }
    }

    /// The sums of least squares at a pose; `None` if a cable has no direction there.
    fn sums(&self, lengths: &[f64], pose: &Pose) -> Option<Sums> {
        let mut sums = Sums { squares: 0.0, right: Vector6::zeros(), matrix: Matrix6::zeros() };
        for (row, given) in self.rows(pose).zip(lengths) {
            let (row, length) = row?;
            let residual = given - length;
            sums.squares += residual * residual;
            sums.right += residual * row;
            sums.matrix.syger(1.0, &row, &row, 1.0);
        }
        sums.matrix.fill_upper_triangle_with_lower_triangle();
        sums.squares.is_finite().then_some(sums)
    }
}

/// The error for a search that ended at this pose, with this root mean square of the residuals, m; `blocked` tells whether a cable
/// would have no direction beyond.
fn no_pose(pose: &Pose, fit: f64, blocked: bool) -> Error {
    let at = pose.position.coords.map(|x| format!("{x:.3}"));
    let beyond = if blocked { ", beyond which a cable has no direction" } else { "" };
    let problem = format!(
        "found no pose after {POSE_ITERATIONS} iterations: the root mean square of the residuals is {} at ({}, {}, {}) m{beyond}; \
         expected the lengths of one pose, or a guess nearer to it",
        length(fit),
        at.x,
        at.y,
        at.z,
    );
    Error::invalid("", problem)
}

fn mean(lengths: &[f64]) -> f64 {
    lengths.iter().sum::<f64>() / lengths.len() as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{CableSpec, RobotSpec};
    use crate::testing::{empty, paper_robot};

    /// A robot with cables from these outlets to these points of the platform.
    fn robot(cables: &[([f64; 3], [f64; 3])]) -> Robot {
        let cable = |(outlet, attachment): &([f64; 3], [f64; 3])| CableSpec {
            outlet: *outlet,
            attachment: *attachment,
            ..CableSpec::default()
        };
        let mut spec = RobotSpec { cables: cables.iter().map(cable).collect(), ..paper_robot() };
        spec.platform[0] = crate::model::BodySpec { vertices: Some(vec![[0.0; 3]]), ..Default::default() };
        Robot::try_from(spec).unwrap()
    }

    /// A point mass 4 m below four outlets, each 3 m aside: all cables are 5 m long.
    fn hanging_point() -> Robot {
        robot(&[[3.0, 0.0, 4.0], [-3.0, 0.0, 4.0], [0.0, 3.0, 4.0], [0.0, -3.0, 4.0]].map(|outlet| (outlet, [0.0; 3])))
    }

    #[test]
    fn a_triangle_of_3_4_and_5_has_a_known_position_covariance_and_mirror_image() {
        let robot = hanging_point();
        let solver = ForwardKinematics::new(&robot, Some(Rotation::identity())).unwrap();
        let lengths = [5.0; 4];
        assert!(solver.first_guess(&lengths).position.coords.norm() < 1e-12);
        let found =
            solver.estimate(&lengths, Some(&Pose::new(Point::new(1.0, -1.0, 1.0), Rotation::identity()))).unwrap();
        assert!(found.pose.position.coords.norm() < 1e-12, "{found:?}");
        assert_eq!((found.rank, found.full_rank), (3, 3));
        // The rows of the Jacobian are (±0.6, 0, 0.8) and (0, ±0.6, 0.8), so JᵀJ is diagonal: 0.72, 0.72, 2.56.
        let expected = Vector6::new(1.0 / 0.72, 1.0 / 0.72, 1.0 / 2.56, 0.0, 0.0, 0.0);
        assert!((found.covariance.unwrap() - Matrix6::from_diagonal(&expected)).norm() < 1e-12);
        let others = solver.others(&lengths, &found).unwrap();
        assert_eq!(others.len(), 1, "{others:?}");
        assert!((others[0].pose.position - Point::new(0.0, 0.0, 8.0)).norm() < 1e-12);
    }

    #[test]
    fn residuals_are_given_lengths_minus_those_at_the_pose() {
        let robot = hanging_point();
        let solver = ForwardKinematics::new(&robot, Some(Rotation::identity())).unwrap();
        // Opposite cables longer than the others: by symmetry the position stays on the axis, the residuals differ in sign.
        let found = solver.estimate(&[5.01, 5.01, 4.99, 4.99], None).unwrap();
        assert!((found.residuals[0] - 0.01).abs() < 1e-4 && (found.residuals[2] + 0.01).abs() < 1e-4, "{found:?}");
        assert!((found.fit() - 0.01).abs() < 1e-4 && found.largest_residual().1.abs() >= found.fit());
    }

    #[test]
    fn at_a_singular_pose_the_rank_is_reported_and_no_covariance() {
        let scene = empty(); // its middle leaves turns about z free
        let at = Point::new(1.0, 1.0, 1.0);
        let lengths = cable_lengths(scene.robot(), &Rotation::identity(), &at);
        let guess = Pose::new(Point::new(1.02, 0.97, 1.01), turn_about(&Vector::z(), 0.1));
        let found = ForwardKinematics::new(scene.robot(), None).unwrap().estimate(&lengths, Some(&guess)).unwrap();
        assert_eq!((found.rank, found.full_rank, found.covariance), (5, 6, None));
        assert!(!found.is_determined() && found.residuals.iter().all(|r| r.abs() < 1e-12), "{found:?}");
    }

    #[test]
    fn in_the_plane_of_the_outlets_the_position_is_found_to_first_order_only() {
        let robot = hanging_point();
        let solver = ForwardKinematics::new(&robot, Some(Rotation::identity())).unwrap();
        let guess = Pose::new(Point::new(0.2, 0.1, 3.8), Rotation::identity());
        let found = solver.estimate(&[3.0; 4], Some(&guess)).unwrap();
        assert_eq!((found.rank, found.covariance), (2, None));
        assert!((found.pose.position - Point::new(0.0, 0.0, 4.0)).norm() < 1e-6, "{found:?}");
    }

    #[test]
    fn too_few_cables_and_cables_that_meet_ask_for_the_orientation() {
        let said = |robot: &Robot, orientation| ForwardKinematics::new(robot, orientation).unwrap_err().to_string();
        let corner = |k: usize| [(k & 1) as f64, (k >> 1 & 1) as f64, 1.0 + (k >> 2) as f64];
        let five: Vec<_> = (0..5).map(|k| (corner(k), [0.1 * k as f64, 0.0, 0.0])).collect();
        assert_eq!(
            said(&robot(&five), None),
            "cables: found 5 cables, expected at least 6 to find position and orientation; give the orientation to find the \
             position alone"
        );
        let two = said(&robot(&five[..2]), Some(Rotation::identity()));
        assert_eq!(two, "cables: found 2 cables, expected at least 3 to find a position");
        let point: Vec<_> = (0..6).map(|k| (corner(k), [0.3; 3])).collect();
        assert!(said(&robot(&point), None).starts_with("cables: found attachments at one point, "));
        assert!(ForwardKinematics::new(&robot(&point), Some(Rotation::identity())).is_ok());
    }

    #[test]
    fn lengths_that_cannot_be_lengths_are_refused_by_the_name_of_the_cable() {
        let robot = hanging_point();
        let solver = ForwardKinematics::new(&robot, Some(Rotation::identity())).unwrap();
        assert_eq!(
            solver.estimate(&[5.0; 3], None).unwrap_err().to_string(),
            "found 3 lengths, expected 4, one for each cable"
        );
        for wrong in [0.0, -0.0, -5.0, f64::NAN, f64::INFINITY, 1.1e6] {
            let said = solver.estimate(&[5.0, 5.0, wrong, 5.0], None).unwrap_err().to_string();
            assert_eq!(
                said,
                format!("cable 2: found a length of {wrong} m, expected a positive number of at most 1e6")
            );
        }
        let rows: [&[f64]; 3] = [&[5.0; 4], &[5.1; 4], &[5.0, 0.0, 5.0, 5.0]];
        let named = |e: Error, k: usize| e.under(&format!("lengths[{k}]"));
        let said = solver.follow(rows, None, named, &Watch::NONE).unwrap_err().to_string();
        assert!(said.starts_with("lengths[2].cable 1: found a length of 0 m"), "{said}");
        let stop = || true;
        assert!(solver.follow(rows, None, |e, _| e, &Watch::on(&stop)).is_err());
    }

    #[test]
    fn guesses_that_are_no_poses_are_refused() {
        let robot = hanging_point();
        let solver = ForwardKinematics::new(&robot, Some(Rotation::identity())).unwrap();
        let said = |position: Point| {
            let guess = Pose::new(position, Rotation::identity());
            solver.estimate(&[5.0; 4], Some(&guess)).unwrap_err().to_string()
        };
        assert_eq!(said(Point::new(0.0, f64::NAN, 0.0)), "guess: found NaN, expected finite numbers");
        assert!(said(Point::new(0.0, 0.0, 1e200)).starts_with("guess: found 1000"));
        let at_an_outlet = said(Point::new(3.0, 0.0, 4.0));
        assert!(at_an_outlet.starts_with("guess.cable 0: has length 0.000e0 m at this position"), "{at_an_outlet}");
    }

    #[test]
    fn lengths_that_no_pose_has_give_large_residuals() {
        let robot = hanging_point();
        let solver = ForwardKinematics::new(&robot, Some(Rotation::identity())).unwrap();
        // Too short to meet: by symmetry on the axis, and nearest in the plane of the outlets.
        for short in [2.0, 1e-300] {
            let found = solver.estimate(&[short; 4], None).unwrap();
            assert!((found.pose.position - Point::new(0.0, 0.0, 4.0)).norm() < 1e-6, "{found:?}");
            assert!(found.residuals.iter().all(|r| (r - (short - 3.0)).abs() < 1e-9));
        }
    }
}
