//! Pulleys: where a cable leaves its last pulley, its length and direction, and a polytope around all exit points.
//!
//! The wheel has radius r. The cable meets its groove at the outlet, running in the direction of the axis, and goes
//! round the wheel from there; the wheel swivels about the axis through the outlet, its centre always on the side of
//! the attachment. In the swivel plane, with ρ the distance from the axis and h the height along it above the outlet,
//! the wheel's centre is at (r, 0). After a wrap angle w
//!
//! - the exit is at r (1 - cos w, sin w), where the outward normal of the wheel is n = (-cos w, sin w), and
//! - the cable runs in direction t = (sin w, cos w) to the attachment (ρ, h) = exit + f t, f being the free length.
//!
//! Hence f² = ρ (ρ - 2r) + h². From h + f = 2 cos²(w/2) (r tan(w/2) + f) and ρ = tan(w/2) (h + f) follows
//! tan(w/2) = ρ / (h + f) = (f - h) / (ρ - 2r), of which one form has no cancellation. With w from 0 to π this covers
//! all attachments outside the wheel, except those below the outlet (h < 0) that are closer to the axis than 2r: there
//! the cable would pull the platform away from the axis.
//!
//! **Gradient.** With dn = t dw and dt = -n dw, the exit moves by r t dw and the attachment by d = r t dw + t df - f n
//! dw. So w changes by dw = -n·d / f, and the length r w + f by r dw + df = t·d. Swivelling does not change it, so its
//! gradient is t: minus the unit vector from the attachment to the exit.
//!
//! **Convexity.** Along any segment on which the cable can leave the wheel, its length is a convex function of the
//! attachment. Its Hessian in the swivel plane is that of t, which changes by -n dw = n (n·d) / f: it is n nᵀ / f.
//! Across the plane it is (∂length/∂ρ) / ρ = sin w / ρ >= 0. On the axis, where ρ = 0, the gradient is continuous.
//!
//! Source: A. Pott, *Influence of pulley kinematics on cable-driven parallel robots*, Latest Advances in Robot
//! Kinematics, 2012. The convexity and the bounds are ours.

mod exits;

use nalgebra::Matrix3;

use crate::geometry::{Point, Vector};
use crate::tolerances::MIN_CABLE_LENGTH;

/// The last pulley of a cable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pulley {
    /// Radius at which the cable runs, m; not negative.
    pub radius: f64,
    /// Unit vector about which the pulley swivels, world axes: the direction in which the cable arrives at the outlet.
    pub axis: Vector,
}

/// How a taut cable leaves its pulley.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Departure {
    /// Where the cable leaves the wheel, world, m.
    pub exit: Point,
    /// Unit vector in which the cable pulls at the attachment, world axes: towards the exit. The gradient of the length
    /// with respect to the attachment is its negative.
    pub pull: Vector,
    /// Distance from the exit to the attachment, m.
    pub free: f64,
    /// Angle that the cable touches the wheel, from the outlet on, rad; from 0 to π.
    pub wrap: f64,
    /// Length of the cable from the outlet to the attachment: radius times wrap, plus free length, m.
    pub length: f64,
}

impl Pulley {
    /// How the taut cable to `attachment` leaves this pulley at `outlet`, both in the world, m.
    ///
    /// `None` if it cannot: the attachment is inside the wheel or closer to the exit than [`MIN_CABLE_LENGTH`]; or it
    /// is below the outlet and closer to the axis than twice the radius, so that the wrap would exceed π. An attachment
    /// on the axis above the outlet has a straight cable.
    ///
    /// # Source
    /// Pott 2012; the formulas are at the head of this module.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{Point, geometry::Vector, geometry::Pulley};
    /// let pulley = Pulley { radius: 1.0, axis: Vector::z() };
    /// let cable = pulley.departure(&Point::origin(), &Point::new(0.0, 2.0, 2.0)).unwrap();
    /// assert!((cable.exit - Point::new(0.0, 0.4, 0.8)).norm() < 1e-12); // a 3-4-5 triangle
    /// assert!((cable.pull - Vector::new(0.0, -0.8, -0.6)).norm() < 1e-12);
    /// assert!((cable.length - (2.0 * 0.5_f64.atan() + 2.0)).abs() < 1e-12);
    /// ```
    pub fn departure(&self, outlet: &Point, attachment: &Point) -> Option<Departure> {
        let Leaving { exit, pull, free, half: [x, y] } = self.leaving(outlet, attachment)?;
        let wrap = 2.0 * libm::atan2(y, x);
        Some(Departure { exit, pull, free, wrap, length: self.radius * wrap + free })
    }

    /// Where the taut cable to `attachment` leaves this pulley, and the unit vector in which it pulls: `exit` and `pull` of
    /// [`departure`](Self::departure), without the wrap angle.
    pub fn exit_and_pull(&self, outlet: &Point, attachment: &Point) -> Option<(Point, Vector)> {
        self.leaving(outlet, attachment).map(|found| (found.exit, found.pull))
    }

    fn leaving(&self, outlet: &Point, attachment: &Point) -> Option<Leaving> {
        let line = attachment - outlet;
        let height = self.axis.dot(&line);
        let across = line - height * self.axis;
        let distance = across.norm();
        let Tangent { free, half: [x, y] } = self.tangent([distance, height])?;
        if !(free >= MIN_CABLE_LENGTH) {
            return None;
        }
        // On the axis both components across it are zero.
        let side = if distance > 0.0 { across / distance } else { Vector::zeros() };
        let share = 1.0 / (x * x + y * y);
        let (sine, cosine, versine) = (2.0 * x * y * share, (x - y) * (x + y) * share, 2.0 * y * y * share);
        let exit = outlet + self.radius * (versine * side + sine * self.axis);
        Some(Leaving { exit, pull: -(sine * side + cosine * self.axis), free, half: [x, y] })
    }

    /// Second derivative of the length while the attachment moves with this velocity, as if it moved on a line, m/s². The length
    /// changes at the rate of minus the pull times the velocity.
    ///
    /// # Example
    /// ```
    /// use cdpr_core::{Point, geometry::Vector, geometry::Pulley};
    /// let pulley = Pulley { radius: 1.0, axis: Vector::z() };
    /// let (outlet, attachment) = (Point::origin(), Point::new(0.0, 3.0, 1.0)); // a quarter turn, and 2 m along y
    /// assert!((pulley.bend(&outlet, &attachment, &Vector::z()) - 1.0 / 2.0).abs() < 1e-12); // up, the wheel turns
    /// assert!((pulley.bend(&outlet, &attachment, &Vector::x()) - 1.0 / 3.0).abs() < 1e-12); // aside, it swivels
    /// ```
    pub fn bend(&self, outlet: &Point, attachment: &Point, velocity: &Vector) -> f64 {
        let Some(bends) = self.bends(outlet, attachment) else { return f64::NAN };
        bends.iter().map(|(direction, bend)| bend * direction.dot(velocity).powi(2)).sum()
    }

    /// Second derivative of the length with respect to the attachment, 1/m.
    pub fn hessian(&self, outlet: &Point, attachment: &Point) -> Matrix3<f64> {
        let Some(bends) = self.bends(outlet, attachment) else { return Matrix3::from_element(f64::NAN) };
        bends.iter().map(|(direction, bend)| *bend * direction * direction.transpose()).sum()
    }

    /// The two directions across the cable that bend its length, in the swivel plane and across it, and its second derivatives along
    /// them, 1/m; there is none along the cable.
    fn bends(&self, outlet: &Point, attachment: &Point) -> Option<[(Vector, f64); 2]> {
        let Departure { pull, free, .. } = self.departure(outlet, attachment)?;
        let line = attachment - outlet;
        let height = self.axis.dot(&line);
        let across = line - height * self.axis;
        let distance = across.norm();
        let Tangent { half: [x, y], .. } = self.tangent([distance, height])?;
        // The sine of the wrap angle over the distance, which is y above the outlet.
        let product = match height >= 0.0 {
            true => x,
            false => y * if distance > 0.0 { x / distance } else { 1.0 },
        };
        let swivel = 2.0 * product / (x * x + y * y);
        // On the axis both directions have the same bend.
        let any = || self.axis.cross(&Vector::ith(self.axis.iamin(), 1.0)).normalize();
        let aside = self.axis.cross(&across).try_normalize(0.0).unwrap_or_else(any);
        Some([(aside.cross(&pull), 1.0 / free), (aside, swivel)])
    }

    /// The taut cable to an attachment at a distance from the axis and a height above the outlet; `None` if the
    /// attachment is inside the wheel, or the wrap exceeds π.
    fn tangent(&self, [distance, height]: [f64; 2]) -> Option<Tangent> {
        let beyond = distance - 2.0 * self.radius;
        let free_squared = distance * beyond + height * height;
        if !(free_squared >= 0.0) || (height < 0.0 && beyond < 0.0) {
            return None;
        }
        let free = free_squared.sqrt();
        let half = if height >= 0.0 { [height + free, distance] } else { [beyond, free - height] };
        Some(Tangent { free, half })
    }
}

/// How a taut cable leaves its pulley, without its angles.
struct Leaving {
    exit: Point,
    pull: Vector,
    free: f64,
    /// A vector (x, y), at half the wrap angle from the x axis.
    half: [f64; 2],
}

/// A taut cable in the swivel plane.
struct Tangent {
    /// Free length, m.
    free: f64,
    /// A vector (x, y), at half the wrap angle from the x axis.
    half: [f64; 2],
}

impl Tangent {
    fn wrap(&self) -> f64 {
        2.0 * libm::atan2(self.half[1], self.half[0])
    }
}

#[cfg(test)]
mod tests {
    use super::exits::Frame;
    use super::*;
    use crate::geometry::Aabb;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;
    use std::f64::consts::{FRAC_PI_2, PI, TAU};

    pub const UPRIGHT: Pulley = Pulley { radius: 1.0, axis: Vector::new(0.0, 0.0, 1.0) };

    pub fn random_vector(rng: &mut ChaCha8Rng, size: f64) -> Vector {
        Vector::from_fn(|_, _| rng.random_range(-size..size))
    }

    /// A number between 10^low and 10^high.
    pub fn magnitude(rng: &mut ChaCha8Rng, low: f64, high: f64) -> f64 {
        10.0_f64.powf(rng.random_range(low..high))
    }

    /// A pulley with a radius from 1 µm to 10 m and its outlet, in every third case along a coordinate axis.
    pub fn random_pulley(rng: &mut ChaCha8Rng) -> (Pulley, Point) {
        let axis = match rng.random_range(0..6) {
            0 => Vector::z(),
            1 => -Vector::y(),
            _ => random_vector(rng, 1.0).normalize(),
        };
        (Pulley { radius: magnitude(rng, -6.0, 1.0), axis }, Point::from(random_vector(rng, 10.0)))
    }

    /// Where the attachment is after a wrap and a free length, in the direction `angle` about the axis.
    fn attachment(pulley: &Pulley, outlet: &Point, [wrap, free, angle]: [f64; 3]) -> Point {
        let (sine, cosine) = wrap.sin_cos();
        let [rho, height] = [pulley.radius * (1.0 - cosine) + free * sine, pulley.radius * sine + free * cosine];
        Frame::new(outlet, &pulley.axis).world(&[rho * angle.cos(), rho * angle.sin(), height])
    }

    fn departure(attachment: [f64; 3]) -> Option<[f64; 5]> {
        let Departure { exit, free, wrap, length, .. } =
            UPRIGHT.departure(&Point::origin(), &Point::from(attachment))?;
        Some([exit.x, exit.z, free, wrap, length])
    }

    #[test]
    fn quarter_half_and_no_turn_and_a_triangle_of_3_4_and_5() {
        let near = |found: Option<[f64; 5]>, right: [f64; 5]| {
            let found = found.unwrap();
            assert!(found.iter().zip(right).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?} {right:?}");
        };
        near(departure([3.0, 0.0, 1.0]), [1.0, 1.0, 2.0, FRAC_PI_2, FRAC_PI_2 + 2.0]);
        near(departure([2.0, 0.0, -7.0]), [2.0, 0.0, 7.0, PI, PI + 7.0]);
        near(departure([0.0, 0.0, 5.0]), [0.0, 0.0, 5.0, 0.0, 5.0]);
        let wrap = 0.8_f64.asin();
        near(departure([2.0, 0.0, 2.0]), [0.4, 0.8, 2.0, wrap, wrap + 2.0]);
        near(departure([3.0, 0.0, 0.5]), {
            let (wheel, free) = (0.25_f64.atan2(1.0) + (1.0_f64 / 4.25_f64.sqrt()).acos(), 3.25_f64.sqrt());
            [1.0 + wheel.cos(), wheel.sin(), free, PI - wheel, PI - wheel + free]
        });
    }

    #[test]
    fn no_cable_into_the_wheel_nor_below_the_outlet_near_the_axis() {
        for inside in [[1.0, 0.0, 0.0], [0.5, 0.0, 0.5], [0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 0.0, 1.0 + 1e-15]] {
            assert_eq!(departure(inside), None, "{inside:?}");
        }
        for below in [[0.0, 0.0, -1.0], [1.9, 0.0, -5.0], [f64::NAN, 0.0, 1.0], [1.0, 0.0, f64::NAN]] {
            assert_eq!(departure(below), None, "{below:?}");
        }
        assert!(departure([2.1, 0.0, -5.0]).is_some());
    }

    #[test]
    fn beside_the_axis_the_cable_is_that_on_the_axis() {
        let on = departure([0.0, 0.0, 5.0]).unwrap();
        for beside in [1e-300, 1e-17, 1e-12] {
            let found = departure([beside, 0.0, 5.0]).unwrap();
            assert!(found.iter().zip(on).all(|(a, b)| (a - b).abs() <= beside), "{found:?}");
        }
    }

    #[test]
    fn a_pulley_without_radius_is_a_fixed_outlet() {
        let (pulley, outlet) = (Pulley { radius: 0.0, axis: Vector::z() }, Point::new(1.0, 2.0, 3.0));
        let cable = pulley.departure(&outlet, &Point::new(1.0, 5.0, -1.0)).unwrap();
        assert_eq!((cable.exit, cable.free, cable.length), (outlet, 5.0, 5.0));
        assert!((cable.pull - Vector::new(0.0, -0.6, 0.8)).norm() < 1e-15);
        let room = Aabb { min: Point::new(-9.0, -9.0, -9.0), max: Point::new(9.0, 9.0, 2.0) };
        assert_eq!(pulley.exits(&outlet, &room), Some(vec![outlet]));
    }

    #[test]
    fn wraps_and_free_lengths_come_back_from_the_attachments_that_they_cause() {
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        for _ in 0..100_000 {
            let (pulley, outlet) = random_pulley(&mut rng);
            let (wrap, free) = (rng.random_range(1e-4..PI - 1e-4), magnitude(&mut rng, -3.0, 3.0));
            let at = attachment(&pulley, &outlet, [wrap, free, rng.random_range(0.0..TAU)]);
            let cable = pulley.departure(&outlet, &at).unwrap();
            assert!((cable.length - (pulley.radius * wrap + free)).abs() < 1e-11, "{pulley:?} {cable:?}");
            assert!(
                (cable.free - free).abs() < 1e-9 && (cable.wrap - wrap).abs() < 1e-9,
                "{pulley:?} {wrap} {cable:?}"
            );
            assert!((cable.exit - at - cable.free * cable.pull).norm() < 1e-11, "{pulley:?} {cable:?}");
        }
    }

    #[test]
    fn lengths_agree_with_the_angles_of_centre_and_tangent() {
        let mut rng = ChaCha8Rng::seed_from_u64(2);
        let mut left = 0;
        for _ in 0..100_000 {
            let (pulley, outlet) = random_pulley(&mut rng);
            let size = magnitude(&mut rng, -1.0, 3.0);
            let at = outlet + random_vector(&mut rng, size);
            let Some(cable) = pulley.departure(&outlet, &at) else { continue };
            left += 1;
            let height = (at - outlet).dot(&pulley.axis);
            let rho = (at - outlet).cross(&pulley.axis).norm();
            let to_centre = (rho - pulley.radius).hypot(height);
            let wheel = height.atan2(rho - pulley.radius) + (pulley.radius / to_centre).acos();
            let free = to_centre * (1.0 - (pulley.radius / to_centre).powi(2)).sqrt();
            let length = pulley.radius * (PI - wheel).rem_euclid(TAU) + free;
            assert!((cable.length - length).abs() < 1e-9, "{pulley:?} {at} {cable:?} {length}");
        }
        assert!(left > 50_000, "{left}");
    }

    #[test]
    fn the_gradient_of_the_length_is_minus_the_pull() {
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        for _ in 0..10_000 {
            let (pulley, outlet) = random_pulley(&mut rng);
            let (wrap, free) = (rng.random_range(0.01..PI - 0.01), magnitude(&mut rng, -0.5, 1.0));
            let at = attachment(&pulley, &outlet, [wrap, free, rng.random_range(0.0..TAU)]);
            let length = |d: Vector| pulley.departure(&outlet, &(at + d)).unwrap().length;
            let step = 1e-5;
            let gradient = Vector::from_fn(|i, _| {
                let d = step * Vector::ith(i, 1.0);
                (length(d) - length(-d)) / (2.0 * step)
            });
            let pull = pulley.departure(&outlet, &at).unwrap().pull;
            assert!((gradient + pull).norm() < 1e-7, "{pulley:?} {wrap} {free} {gradient} {pull}");
        }
    }

    #[test]
    fn the_hessian_of_the_length_is_how_the_pull_changes() {
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        for k in 0..10_000 {
            let (pulley, outlet) = random_pulley(&mut rng);
            let (wrap, free) = (rng.random_range(0.01..PI - 0.01), magnitude(&mut rng, -0.5, 1.0));
            let beside = attachment(&pulley, &outlet, [wrap, free, rng.random_range(0.0..TAU)]);
            let at = if k % 10 == 0 { outlet + free * pulley.axis } else { beside };
            let (step, hessian) = (1e-7, pulley.hessian(&outlet, &at)); // third derivatives jump on the axis
            for i in 0..3 {
                let pull =
                    |share: f64| pulley.departure(&outlet, &(at + share * step * Vector::ith(i, 1.0))).unwrap().pull;
                let change = (pull(-1.0) - pull(1.0)) / (2.0 * step);
                assert!((hessian.column(i) - change).norm() < 1e-5, "{pulley:?} {at} {i} {hessian} {change}");
            }
        }
    }

    #[test]
    fn the_length_is_convex_along_segments_on_which_the_cable_can_leave_the_wheel() {
        let mut rng = ChaCha8Rng::seed_from_u64(4);
        let mut segments = 0;
        for _ in 0..20_000 {
            let (pulley, outlet) = random_pulley(&mut rng);
            let size = pulley.radius * magnitude(&mut rng, 0.0, 2.0);
            let [from, to] = [(); 2].map(|()| outlet + random_vector(&mut rng, size));
            let lengths: Option<Vec<f64>> = (0..=32)
                .map(|k| Some(pulley.departure(&outlet, &from.lerp(&to, f64::from(k) / 32.0))?.length))
                .collect();
            let Some(lengths) = lengths else { continue };
            segments += 1;
            let rounding = 1e-14 * (10.0 + size);
            let convex = lengths.windows(3).all(|l| l[0] + l[2] - 2.0 * l[1] > -rounding);
            assert!(convex, "{pulley:?} {from} {to} {lengths:?}");
        }
        assert!(segments > 5_000, "{segments}");
    }
}
