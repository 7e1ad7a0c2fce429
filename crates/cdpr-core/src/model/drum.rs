//! The drum of a winch: the angle of its motor and the torque about it.

/// The drum of a winch and the gear between drum and motor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drum {
    /// Radius from the axis of the drum to the middle of the cable, m.
    pub radius: f64,
    /// Turns of the motor for one turn of the drum; negative if positive angles of the motor wind the cable in.
    pub gear: f64,
    /// Length of the cable at which the motor's angle is 0, m.
    pub zero: f64,
    /// Length of the cable between drum and outlet, m.
    pub lead: f64,
}

impl Drum {
    /// Angle of the motor at a commanded length, m, in rad from that at `zero`. With a positive gear it grows while the cable is let
    /// out.
    pub fn angle(&self, command: f64) -> f64 {
        self.gear * (command - self.zero) / self.radius
    }

    /// The commanded length, m, at an angle of the motor, rad: the inverse of [`Drum::angle`].
    pub fn command(&self, angle: f64) -> f64 {
        self.zero + angle * self.radius / self.gear
    }

    /// Torque of a tension, N, about the axis of the motor, N·m, which the motor balances at rest. It drives the motor in the
    /// direction that lets the cable out.
    pub fn torque(&self, tension: f64) -> f64 {
        tension * self.radius / self.gear
    }
}
