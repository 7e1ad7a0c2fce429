//! The wheels of pulleys. A wheel is a body on a hinge through the outlet, about the axis of its pulley, with a ball that the
//! tendon wraps. The tendon begins on the axis, far before the outlet, where it touches the ball.
//!
//! **At its right angle**, the hinge holds the ball's centre in the plane through the axis and the attachment. The shortest way round
//! a ball stays in the plane of its ends and the centre, so there it is that of a cable in the groove of the wheel: the
//! tendon is longer than the cable by the distance between its beginning and the outlet.
//!
//! **The cable turns the hinge to its right angle**, where the tendon is shortest: at an angle δ from it, it is longer by about
//! r sin φ δ²/2, with φ the wrap. This takes a wrap of a few degrees ([`Wheel::keeps_its_angle`]), so that the ball's centre is
//! clearly aside of the line from the beginning of the tendon to the attachment. A cylinder would not do: on it a tendon may run
//! sideways as a helix, so that it is longest at the right angle.

use cdpr_core::geometry::{Departure, Point, Vector};
use cdpr_core::model::Cable;

use super::element::Element;

/// Distance from the beginning of a tendon to the outlet, in radii of the wheel.
const LEAD: f64 = 20.0;

/// Largest angle by which a wheel that swings freely about its right angle moves in a step of the simulation, as share of the
/// largest deviation: below 2, steps are stable.
const STEP: f64 = 0.5;

/// Share of the critical damping of a wheel at the largest tension.
const DAMPING: f64 = 0.05;

/// The wheel of a pulley.
#[derive(Debug, Clone, PartialEq)]
pub struct Wheel {
    /// Name of the cable.
    cable: String,
    /// The cable, counting from 0.
    pub index: usize,
    outlet: Point,
    radius: f64,
    axis: Vector,
    /// Unit vectors across the axis: towards the wheel's centre at the angle 0 of the hinge, and at a quarter turn.
    across: [Vector; 2],
    /// Inertia about the axis, kg·m², and damping, N·m·s/rad.
    swing: [f64; 2],
}

impl Wheel {
    /// The wheel of a cable, if it has one, towards an attachment in the world at the angle 0; for tensions up to `most`, N, and
    /// steps of the simulation, s.
    pub fn of(index: usize, cable: &Cable, attachment: &Point, most: f64, timestep: f64) -> Option<Self> {
        let pulley = cable.pulley.as_ref().filter(|pulley| pulley.radius > 0.0)?;
        let (axis, line) = (pulley.axis, attachment - cable.outlet);
        let towards = (line - axis * axis.dot(&line)).try_normalize(f64::EPSILON * line.norm());
        let other = || Vector::ith(axis.iamin(), 1.0).cross(&axis).normalize(); // all are right for a cable along the axis
        let first = towards.unwrap_or_else(other);
        // The arm of the cable is at most about the radius.
        let stiffness = 2.0 * pulley.radius * most;
        let inertia = stiffness * (timestep / STEP).powi(2);
        Some(Wheel {
            cable: cable.name.clone(),
            index,
            outlet: cable.outlet,
            radius: pulley.radius,
            axis,
            across: [first, axis.cross(&first)],
            swing: [inertia, 2.0 * DAMPING * (stiffness * inertia).sqrt()],
        })
    }

    /// Whether the cable turns the wheel to its right angle where it departs like this: if it wraps more than the angles under
    /// which the radius is seen from both ends of the tendon.
    pub fn keeps_its_angle(&self, departure: &Departure) -> bool {
        departure.wrap >= 1.0 / LEAD + self.radius / departure.free
    }

    /// By how much the tendon is longer than the cable, m.
    pub fn lead(&self) -> f64 {
        LEAD * self.radius
    }

    /// Inertia about the axis, kg·m².
    pub fn inertia(&self) -> f64 {
        self.swing[0]
    }

    /// The body of the wheel, and the site where the tendon begins. The geom has the name `geom`.
    pub fn elements(&self, geom: &str) -> [Element; 2] {
        let Wheel { cable, radius, axis, across: [first, second], swing: [inertia, damping], .. } = self;
        let at = |element: Element, place: Vector| element.with_numbers("pos", place.as_slice());
        let named = |kind: &'static str, name: String| Element::new(kind).with("name", name);
        let inertial = at(Element::new("inertial"), Vector::zeros());
        let hinge = named("joint", format!("swivel {cable}"))
            .with("type", "hinge")
            .with_numbers("axis", axis.as_slice())
            .with_numbers("armature", &[*inertia])
            .with_numbers("damping", &[*damping]);
        let light = |element: Element| {
            let massless = element.with_numbers("mass", &[0.0]);
            massless.with_numbers("contype", &[0.0]).with_numbers("conaffinity", &[0.0])
        };
        let ball = at(named("geom", geom.to_string()).with("type", "sphere"), first * *radius)
            .with_numbers("size", &[*radius]);
        let ball = light(ball).with("group", "4"); // viewers hide it and draw a wheel
        let drawn = at(Element::new("geom").with("type", "cylinder"), first * *radius)
            .with_numbers("zaxis", second.as_slice())
            .with_numbers("size", &[*radius, radius / 5.0]);
        let drawn = light(drawn).with("rgba", "0.35 0.35 0.35 1");
        // Beyond the wheel as the cable arrives: the tendon passes the wheel there.
        let side = at(named("site", format!("side {cable}")), first * *radius + axis * (2.0 * radius));
        let side = side.with_numbers("size", &[radius / 10.0]).with("rgba", "0 0 0 0");
        let body = named("body", format!("wheel {cable}")).with_numbers("pos", self.outlet.coords.as_slice());
        let body = body
            .with_child(inertial.with_numbers("mass", &[TINY]).with_numbers("diaginertia", &[TINY; 3]))
            .with_child(hinge)
            .with_child(ball)
            .with_child(drawn)
            .with_child(side);
        let begin = at(named("site", format!("outlet {cable}")), self.outlet.coords - axis * self.lead());
        [body, begin.with_numbers("size", &[radius / 5.0])]
    }

    /// The part of the tendon on the wheel.
    pub fn wrap(&self, geom: &str) -> Element {
        Element::new("geom").with("geom", geom).with("sidesite", format!("side {}", self.cable))
    }

    /// The angle of the hinge, rad, nearest to `near`, and its first and second derivative, while the attachment in the world has
    /// this position, velocity and acceleration. On the axis every angle is right.
    pub fn angle(&self, attachment: &Point, [velocity, acceleration]: [&Vector; 2], near: f64) -> [f64; 3] {
        let flat = |v: &Vector| self.across.map(|axis| axis.dot(v));
        let [[x, y], [vx, vy], [ax, ay]] = [flat(&(attachment - self.outlet)), flat(velocity), flat(acceleration)];
        let square = x * x + y * y;
        if !(square > 0.0) {
            return [near, 0.0, 0.0];
        }
        let turn = std::f64::consts::TAU;
        let angle = y.atan2(x);
        let speed = (x * vy - y * vx) / square;
        let gain = (x * ay - y * ax) / square - 2.0 * speed * (x * vx + y * vy) / square;
        [angle + turn * ((near - angle) / turn).round(), speed, gain]
    }
}

/// Mass, kg, and inertia, kg·m², of a wheel's body beside the inertia about its axis: MuJoCo needs some.
const TINY: f64 = 1e-9;

#[cfg(test)]
mod tests {
    use super::*;
    use cdpr_core::geometry::Pulley;

    #[test]
    fn rates_of_the_angle_are_its_derivatives() {
        let pulley = Pulley { radius: 0.05, axis: Vector::new(0.1, -0.2, 0.9).normalize() };
        let scene = cdpr_core::testing::empty();
        let cable = Cable { pulley: Some(pulley), ..scene.robot().cables()[0].clone() };
        let begin = Point::new(1.0, 1.2, 0.3);
        let wheel = Wheel::of(0, &cable, &begin, 100.0, 1e-3).unwrap();
        let (velocity, acceleration) = (Vector::new(0.4, -0.7, 0.2), Vector::new(-1.0, 0.5, 0.3));
        let at = |t: f64| {
            let place = begin + velocity * t + acceleration * (0.5 * t * t);
            wheel.angle(&place, [&(velocity + acceleration * t), &acceleration], 0.0)
        };
        assert!(at(0.0)[0].abs() < 1e-15);
        let (h, [_, speed, gain]) = (1e-4, at(0.3));
        let [[before, slower, _], [after, faster, _]] = [at(0.3 - h), at(0.3 + h)];
        assert!(((after - before) / (2.0 * h) - speed).abs() < 1e-6);
        assert!(((faster - slower) / (2.0 * h) - gain).abs() < 1e-6);
        assert!((wheel.angle(&begin, [&velocity, &velocity], 12.0)[0] - 4.0 * std::f64::consts::PI).abs() < 1e-12);
        let fixed = Cable { pulley: None, ..cable };
        assert_eq!(Wheel::of(0, &fixed, &begin, 100.0, 1e-3), None);
    }
}
