//! A bend on which the platform changes from one turn to another, as it does where a turn begins or ends.
//!
//! Two lines meet at a pose (P, Q). The first one arrives with the rates v₁ of the position and w₁ of the orientation per parameter,
//! the second one leaves with v₂ and w₂. Both w have axes that are fixed in the world, and are zero without a turn. With u from
//! −ℓ/2 to ℓ/2, the bend is
//!
//! > p = P + v₁ f₁ + v₂ f₂, R = exp(w₂ f₂) exp(w₁ f₁) Q,
//!
//! where f₂ rises from 0 with the slope f₂′ = 3t² − 2t³, t = u/ℓ + ½, and f₁ + f₂ = u. So f₁′ + f₂′ = 1: the motion along the first line
//! fades out while that along the second one fades in. Position and orientation join the lines with continuous first and second
//! derivatives. For positions alone this is the bend of fifth degree of other corners.
//!
//! **Angular rate.** Ω = w₂ g + G (1 − g) with g = f₂′ and G = exp(w₂ f₂) w₁. G has the derivatives g w₂ × G and so on, of which only the part
//! of w₁ across the axis of w₂ counts.
//!
//! **Bounds.** The norms of the derivatives of G are at most |w₁⊥| times those of the operator exp(w₂ f₂), which follow from the bounds of f₂
//! (Faà di Bruno). With H = w₂ − G, Ω = G + H g, so that |Ω⁽ᵏ⁾| ≤ |G⁽ᵏ⁾| + |H| |g⁽ᵏ⁾| + Σ C(k, j) |G⁽ʲ⁾| |g⁽ᵏ⁻ʲ⁾| over 0 < j < k, since 1 − g
//! is between 0 and 1. A unit vector of the platform has the first derivative Ω × a; the bounds of the others follow by the
//! product rule.

use super::jet::Jet;
use crate::geometry::{Apart, Point, Pose, Rotation, TurningPiece, Vector, turn_about};
use crate::turning::{Derivatives, PoseCurve};

/// A bend between two lines on which the platform may turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurningBend {
    corner: Pose,
    velocities: [Vector; 2],
    spins: [Vector; 2],
    /// Unit axes of the two turns; arbitrary without a turn.
    axes: [Vector; 2],
    /// Norms of the spins, rad/m.
    rates: [f64; 2],
    length: f64,
    bounds: TurnBounds,
}

/// Upper bounds of the norms of derivatives with respect to the parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurnBounds {
    /// Bounds for the angular rate Ω and its first four derivatives, rad/m to rad/m⁵.
    pub rate: [f64; 5],
    /// Bounds for the first five derivatives of a unit vector of the platform, 1/m to 1/m⁵.
    pub vector: [f64; 5],
}

/// f₂ and its first three derivatives at the share t of a bend.
#[derive(Debug, Clone, Copy)]
struct Fade([f64; 4]);

impl Fade {
    fn at(t: f64, length: f64) -> Self {
        Fade([
            length * t.powi(3) * (1.0 - 0.5 * t),
            t * t * (3.0 - 2.0 * t),
            6.0 * t * (1.0 - t) / length,
            6.0 * (1.0 - 2.0 * t) / (length * length),
        ])
    }

    /// The largest norms of the first five derivatives of f₂.
    fn largest(length: f64) -> [f64; 5] {
        [1.0, 1.5 / length, 6.0 / length.powi(2), 12.0 / length.powi(3), 0.0]
    }
}

/// f₂ at the middle of a bend, where the distance from the lines is largest, as a share of the length of the bend.
const MIDDLE: f64 = 0.09375;

impl TurningBend {
    /// The bend at a pose between lines with these rates of the position, m/m, and of the orientation, rad/m, world axes. `length`
    /// is the range of the parameter, m; half of it is cut off either line.
    pub fn new(corner: Pose, velocities: [Vector; 2], spins: [Vector; 2], length: f64) -> Self {
        let rates = spins.map(|spin| spin.norm());
        let axes = spins.map(|spin| spin.try_normalize(0.0).unwrap_or_else(Vector::x));
        let bounds = TurnBounds::of(spins, length);
        TurningBend { corner, velocities, spins, axes, rates, length, bounds }
    }

    /// The pose at which the two lines meet.
    pub fn corner(&self) -> &Pose {
        &self.corner
    }

    /// Rates of the position along both lines, m/m.
    pub fn velocities(&self) -> &[Vector; 2] {
        &self.velocities
    }

    /// Rates of the orientation along both lines, world axes, rad/m.
    pub fn spins(&self) -> &[Vector; 2] {
        &self.spins
    }

    /// The range of the parameter, m.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Bounds of how the platform turns.
    pub fn bounds(&self) -> &TurnBounds {
        &self.bounds
    }

    /// Bounds of the norms of the first five derivatives of the position.
    pub fn position_bounds(&self) -> [f64; 5] {
        let [first, second] = &self.velocities;
        let jump = (second - first).norm();
        let [_, rest @ ..] = Fade::largest(self.length).map(|f| jump * f);
        let [b2, b3, b4, b5] = rest;
        [first.norm().max(second.norm()), b2, b3, b4, b5]
    }

    /// The most by which a point of the platform at a distance of at most `reach`, m, from its origin passes beside the two lines, m.
    pub fn deviation(&self, reach: f64) -> f64 {
        MIDDLE * self.length * jump(&self.velocities, &self.spins, reach)
    }

    /// The length of the bend between such lines that deviates by this much, m.
    pub fn length_for(deviation: f64, velocities: &[Vector; 2], spins: &[Vector; 2], reach: f64) -> f64 {
        deviation / (MIDDLE * jump(velocities, spins, reach))
    }

    /// Both turns up to the share t, and how far the second one has faded in.
    fn turns(&self, t: f64) -> ([Rotation; 2], Fade) {
        let fade = Fade::at(t, self.length);
        let along = [self.length * (t - 0.5) - fade.0[0], fade.0[0]];
        let turn = |k: usize| turn_about(&self.axes[k], self.rates[k] * along[k]);
        ([turn(0), turn(1)], fade)
    }

    /// Position and orientation at a parameter, 0 to the length.
    pub fn pose(&self, s: f64) -> Pose {
        let t = s / self.length;
        let ([first, second], Fade([faded, ..])) = self.turns(t);
        let position = self.position(t, faded);
        Pose::new(position, second * (first * self.corner.orientation))
    }

    fn position(&self, t: f64, faded: f64) -> Point {
        let [before, after] = &self.velocities;
        self.corner.position + before * (self.length * (t - 0.5) - faded) + after * faded
    }

    /// Position, orientation and their derivatives at a parameter, 0 to the length.
    pub fn jet(&self, s: f64) -> Jet {
        let t = s / self.length;
        let ([first, second], Fade([faded, slope, bend, third])) = self.turns(t);
        let ([before, after], [spin_before, spin_after]) = (&self.velocities, &self.spins);
        let carried = second * spin_before;
        let drift = spin_after.cross(&carried) * (slope * (1.0 - slope));
        Jet {
            position: self.position(t, faded),
            orientation: second * (first * self.corner.orientation),
            first: before * (1.0 - slope) + after * slope,
            second: (after - before) * bend,
            third: (after - before) * third,
            spin: carried * (1.0 - slope) + spin_after * slope,
            spin_change: (spin_after - carried) * bend + drift,
        }
    }

    /// The motion at constant rates between two parameters, and how far the bend is from it, for bodies that are given at the
    /// orientation `reference`.
    ///
    /// Two curves with the same ends differ by at most h²/8 times the largest difference of their second derivatives.
    pub fn piece(&self, [from, to]: [f64; 2], reference: &Rotation) -> TurningPiece {
        let motion = self.pose(from).toward(&self.pose(to));
        let eighth = (to - from).powi(2) / 8.0;
        let [_, bending, ..] = self.position_bounds();
        let [_, turning, ..] = self.bounds.vector;
        let apart = Apart { position: eighth * bending, turned: eighth * turning + motion.angle.powi(2) / 8.0 };
        motion.relative_to(reference).whole().within(apart)
    }

    /// The most by which the angle between any line of the platform and this unit direction of the world exceeds that at the corner,
    /// rad. A rotation exp(w f) adds at most the angle by which it moves the direction itself, |w × n| |f|. Since f₂ is convex and
    /// f₁ = u − f₂ is never positive, |w₁ × n| |f₁| + |w₂ × n| f₂ is convex in u, and largest at an end, where one of them is zero.
    pub fn swing(&self, direction: &Vector) -> f64 {
        0.5 * self.length * self.spins.iter().map(|spin| spin.cross(direction).norm()).fold(0.0, f64::max)
    }
}

impl PoseCurve for TurningBend {
    fn pose_at(&self, share: f64) -> Pose {
        self.pose(share * self.length)
    }

    fn derivatives(&self, share: f64) -> Derivatives {
        let range = share * self.length;
        let [_, bending, ..] = self.position_bounds();
        let [swing, jolt, ..] = self.bounds.vector;
        Derivatives { position: range * range * bending, turned: [range * swing, range * range * jolt] }
    }
}

/// How much the motion changes between two lines: of the position, and of the orientation at a distance, m/m.
fn jump(velocities: &[Vector; 2], spins: &[Vector; 2], reach: f64) -> f64 {
    (velocities[1] - velocities[0]).norm() + reach * (spins[1] - spins[0]).norm()
}

/// Bounds of the first four derivatives of exp(w f) as an operator, with |w| = `rate`, given those of f.
fn operator([f1, f2, f3, f4, _]: &[f64; 5], rate: f64) -> [f64; 4] {
    let [r1, r2, r3, r4] = [1, 2, 3, 4].map(|k| rate.powi(k));
    [
        r1 * f1,
        r1 * f2 + r2 * f1 * f1,
        r1 * f3 + 3.0 * r2 * f1 * f2 + r3 * f1.powi(3),
        r1 * f4 + r2 * (4.0 * f1 * f3 + 3.0 * f2 * f2) + 6.0 * r3 * f1 * f1 * f2 + r4 * f1.powi(4),
    ]
}

impl TurnBounds {
    fn of([before, after]: [Vector; 2], length: f64) -> Self {
        let fades = Fade::largest(length);
        let [_, g1, g2, g3, g4] = fades;
        let rate = after.norm();
        // The part of the first spin that the second turn moves.
        let across = if rate > 0.0 { before.cross(&after).norm() / rate } else { 0.0 };
        let [n1, n2, n3, n4] = operator(&fades, rate).map(|norm| across * norm);
        let apart = (after - before).norm() + across * rate * 0.5 * length;
        let w = [
            before.norm().max(rate),
            n1 + apart * g1,
            n2 + apart * g2 + 2.0 * n1 * g1,
            n3 + apart * g3 + 3.0 * (n1 * g2 + n2 * g1),
            n4 + apart * g4 + 4.0 * (n1 * g3 + n3 * g1) + 6.0 * n2 * g2,
        ];
        // (Ω × a)⁽ᵏ⁾, with the derivatives of a so far.
        let d1 = w[0];
        let d2 = w[1] + w[0] * d1;
        let d3 = w[2] + 2.0 * w[1] * d1 + w[0] * d2;
        let d4 = w[3] + 3.0 * (w[2] * d1 + w[1] * d2) + w[0] * d3;
        let d5 = w[4] + 4.0 * (w[3] * d1 + w[1] * d3) + 6.0 * w[2] * d2 + w[0] * d4;
        TurnBounds { rate: w, vector: [d1, d2, d3, d4, d5] }
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::trajectory::Motion;
    use crate::trajectory::curve::{Curve, Piece};
    use crate::trajectory::motion::Rates;
    use crate::trajectory::timing::Phase;

    /// A bend between lines of any kind, among them such that hold the platform and such that turn it on the spot.
    fn random(rng: &mut ChaCha8Rng) -> TurningBend {
        let mut any = |most: f64| Vector::from_fn(|_, _| rng.random_range(-most..most));
        let corner = Pose::new(Point::from(any(1.0)), Rotation::from_scaled_axis(any(3.0)));
        let (mut velocities, mut spins) = ([any(1.0), any(1.0)], [any(4.0), any(4.0)]);
        if any(1.0).x > 0.0 {
            spins[0] = Vector::zeros();
        }
        if any(1.0).x > 0.3 {
            velocities[1] = Vector::zeros();
        }
        TurningBend::new(corner, velocities, spins, 0.05 + any(0.4).x.abs())
    }

    #[test]
    fn derivatives_are_those_of_differences_and_within_their_bounds() {
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        for _ in 0..200 {
            let bend = random(&mut rng);
            let (length, arm) = (bend.length(), Vector::new(0.3, -0.2, 0.1));
            let s = rng.random_range(0.01..0.99) * length;
            let h = 1e-5 * length;
            let point = |s: f64| {
                let pose = bend.pose(s);
                pose.position + pose.orientation * arm
            };
            let moved = |s: f64| bend.jet(s).of_point(&(bend.pose(s).orientation * arm));
            let [jet, pose] = [bend.jet(s), Jet { position: bend.pose(s).position, ..bend.jet(s) }];
            assert_eq!((jet, jet.orientation), (pose, bend.pose(s).orientation));
            let scale = 1.0 / length;
            let first = (point(s + h) - point(s - h)) / (2.0 * h);
            assert!((first - moved(s)[0]).norm() < 1e-7 * scale);
            let second = (moved(s + h)[0] - moved(s - h)[0]) / (2.0 * h);
            assert!((second - moved(s)[1]).norm() < 1e-5 * scale * scale);
            let change = (bend.jet(s + h).spin - bend.jet(s - h).spin) / (2.0 * h);
            assert!((change - jet.spin_change).norm() < 1e-5 * scale * scale);
            let third = (bend.jet(s + h).second - bend.jet(s - h).second) / (2.0 * h);
            assert!((third - jet.third).norm() < 1e-4 * scale.powi(3));
        }
    }

    #[test]
    fn bounds_hold_for_differences_of_any_order() {
        let mut rng = ChaCha8Rng::seed_from_u64(2);
        let mut tightest = [0.0_f64; 10];
        for _ in 0..300 {
            let bend = random(&mut rng);
            let (h, unit) = (bend.length() / 64.0, Vector::new(0.6, -0.48, 0.64));
            // The k-th difference over h^k is a mean of the k-th derivative.
            let mut spins: Vec<Vector> = (0..=64).map(|k| bend.jet(h * f64::from(k)).spin).collect();
            let mut arms: Vec<Vector> = (0..=64).map(|k| bend.jet(h * f64::from(k)).orientation * unit).collect();
            for order in 0..5 {
                let differences = |list: &[Vector]| list.windows(2).map(|pair| (pair[1] - pair[0]) / h).collect();
                arms = differences(&arms);
                for (list, bound, k) in
                    [(&spins, bend.bounds().rate[order], order), (&arms, bend.bounds().vector[order], order + 5)]
                {
                    let most = list.iter().map(Vector::norm).fold(0.0, f64::max);
                    let rounding = 1e-14 * (64.0 / bend.length()).powi(order as i32 + 1) * 100.0;
                    assert!(most <= bound * (1.0 + 1e-9) + rounding, "{order} {k}: {most} {bound}");
                    tightest[k] = tightest[k].max((most - rounding) / bound);
                }
                spins = differences(&spins);
            }
        }
        assert!(tightest.iter().all(|share| *share > 0.2), "{tightest:?}");
    }

    #[test]
    fn lines_continue_as_bends_with_both_derivatives_of_every_point() {
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        for _ in 0..100 {
            let bend = random(&mut rng);
            let half = 0.5 * bend.length();
            for (k, s) in [(0, 0.0), (1, bend.length())] {
                let (jet, along) = (bend.jet(s), if k == 0 { -half } else { half });
                let (velocity, spin) = (bend.velocities()[k], bend.spins()[k]);
                let turned = Rotation::from_scaled_axis(spin * along) * bend.corner().orientation;
                assert!((jet.position - (bend.corner().position + velocity * along)).norm() < 1e-14);
                assert!(jet.orientation.angle_to(&turned) < 1e-7);
                let line = Jet { first: velocity, second: Vector::zeros(), spin, spin_change: Vector::zeros(), ..jet };
                let arm = Vector::new(0.2, 0.5, -0.3);
                let apart: f64 = (0..2).map(|k| (jet.of_point(&arm)[k] - line.of_point(&arm)[k]).norm()).sum();
                assert!(apart < 1e-12, "{apart}");
            }
        }
    }

    #[test]
    fn bends_stay_near_their_lines_and_chords() {
        let mut rng = ChaCha8Rng::seed_from_u64(4);
        for _ in 0..100 {
            let bend = random(&mut rng);
            let (half, arm) = (0.5 * bend.length(), Vector::new(0.3, 0.4, 0.0));
            let place = |pose: &Pose| pose.position + pose.orientation * arm;
            for n in 0..=40 {
                let u = half * (f64::from(n) / 20.0 - 1.0);
                let (velocity, spin) = (bend.velocities()[usize::from(u > 0.0)], bend.spins()[usize::from(u > 0.0)]);
                let corner = bend.corner();
                let turned = Rotation::from_scaled_axis(spin * u) * corner.orientation;
                let line = Pose::new(corner.position + velocity * u, turned);
                let away = (place(&bend.pose(half + u)) - place(&line)).norm();
                assert!(away <= bend.deviation(0.5) + 1e-12);
            }
            let [from, to] = [rng.random_range(0.0..0.5), rng.random_range(0.5..1.0)].map(|t| t * 2.0 * half);
            let (piece, motion) =
                (bend.piece([from, to], &Rotation::identity()), bend.pose(from).toward(&bend.pose(to)));
            for n in 1..20 {
                let share = f64::from(n) / 20.0;
                let (there, near) = (bend.pose(from + share * (to - from)), motion.at(share));
                assert!((there.position - near.position).norm() <= piece.apart.position + 1e-12);
                let turned = (there.orientation * arm - near.orientation * arm).norm();
                assert!(turned <= piece.apart.turned * arm.norm() + 1e-12);
            }
        }
    }

    #[test]
    fn lines_of_the_platform_swing_as_bounded() {
        let mut rng = ChaCha8Rng::seed_from_u64(6);
        let mut closest = 0.0_f64;
        for _ in 0..300 {
            let bend = random(&mut rng);
            let line = Vector::from_fn(|_, _| rng.random_range(-1.0..1.0)).normalize();
            let angle = |pose: &Pose| (pose.orientation * line).angle(&line);
            let from = angle(bend.corner());
            for s in (0..=200).map(|k| bend.length() * f64::from(k) / 200.0) {
                let (swung, most) = (angle(&bend.pose(s)) - from, bend.swing(&line));
                assert!(swung <= most + 1e-7, "{swung} {most}");
                closest = closest.max(if most > 1e-3 { swung / most } else { 0.0 });
            }
        }
        assert!(closest > 0.9, "{closest}");
    }

    #[test]
    fn rates_in_time_bound_what_differences_show() {
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        for _ in 0..200 {
            let bend = random(&mut rng);
            let curve = Curve::new(vec![Piece::turning_bend(bend)]);
            let mut any = |most: f64| rng.random_range(-most..most);
            let speed = 0.2 + any(0.1);
            let phase = Phase { time: 0.0, s: 0.3 * bend.length(), speed, acceleration: any(1.0), jerk: any(5.0) };
            let time = 0.02;
            let at = |t: f64| Motion::on(&curve, 0, &phase.after(t));
            let rates = Rates::new(&curve.pieces()[0], &phase, &phase.after(time), time);
            let (turn, h) = (rates.turn(), 1e-4);
            for t in [0.002, 0.01, 0.018] {
                let [before, now, after] = [t - h, t, t + h].map(at);
                let jerk = (after.angular_acceleration - before.angular_acceleration) / (2.0 * h);
                let snap = (after.angular_acceleration - now.angular_acceleration * 2.0 + before.angular_acceleration)
                    / (h * h);
                let norms = [now.angular_velocity, now.angular_acceleration, jerk, snap].map(|v| v.norm());
                let holds = norms.iter().zip(turn).all(|(norm, bound)| *norm <= bound * (1.0 + 1e-3) + 1e-5);
                assert!(holds, "{norms:?} {turn:?}");
                let difference = (after.angular_velocity - before.angular_velocity) / (2.0 * h);
                assert!((difference - now.angular_acceleration).norm() < 1e-3 * (1.0 + turn[3]));
            }
        }
    }
}
