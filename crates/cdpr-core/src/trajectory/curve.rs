//! The geometric curve that a trajectory follows: straight lines and bends, with continuous curvature. On a line, the platform
//! may turn as well, and on bends between such lines ([`TurningBend`]).

use super::attitude::Attitude;
use super::jet::Jet;
use super::turning_bend::TurningBend;
use crate::geometry::{Point, Rotation, Vector};

/// Degree of a bend.
const DEGREE: usize = 5;
/// Number of control points of a bend.
pub const CONTROL: usize = DEGREE + 1;

/// A piece of a curve: a polynomial in a parameter from 0 to `length`, m. The parameter of a line is its arc length, on which
/// the platform turns also a share of its turn; that of a bend differs from its arc length by a few per cent.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// The control points; see [`Piece::control`].
    control: Vec<Point>,
    /// Coefficients of the powers of the parameter divided by `length`.
    powers: [Vector; CONTROL],
    attitude: Attitude,
    turning: Option<TurningBend>,
    /// The range of the parameter, m.
    pub length: f64,
    /// Upper bounds of the norms of the first five derivatives with respect to the parameter.
    pub derivative_bounds: [f64; DEGREE],
}

impl Piece {
    /// A straight line between two different points.
    pub fn line(from: Point, to: Point) -> Self {
        let step = to - from;
        let length = step.norm();
        let mut powers = [Vector::zeros(); CONTROL];
        (powers[0], powers[1]) = (from.coords, step);
        let attitude = Attitude::held(Rotation::identity());
        let derivative_bounds = [1.0, 0.0, 0.0, 0.0, 0.0];
        Piece { control: vec![from, to], powers, attitude, turning: None, length, derivative_bounds }
    }

    /// A straight line on which the platform turns, both at constant rate; the ends may coincide. `length` is the range of the
    /// parameter, m; it must be positive.
    pub fn turning_line([from, to]: [Point; 2], attitude: Attitude, length: f64) -> Self {
        let step = to - from;
        let mut powers = [Vector::zeros(); CONTROL];
        (powers[0], powers[1]) = (from.coords, step);
        let derivative_bounds = [step.norm() / length, 0.0, 0.0, 0.0, 0.0];
        Piece { control: vec![from, to], powers, attitude, turning: None, length, derivative_bounds }
    }

    /// A bend between lines on which the platform may turn.
    pub fn turning_bend(bend: TurningBend) -> Self {
        let length = bend.length();
        let ends = [0.0, length].map(|s| bend.pose(s));
        let attitude = Attitude::between(ends[0].orientation, ends[1].orientation);
        Piece {
            control: ends.map(|end| end.position).to_vec(),
            powers: [Vector::zeros(); CONTROL],
            attitude,
            turning: Some(bend),
            length,
            derivative_bounds: bend.position_bounds(),
        }
    }

    /// The part of a line between two parameters.
    pub fn part_of_line(&self, [from, to]: [f64; 2]) -> Self {
        let [start, end] = [from, to].map(|s| self.at(s));
        let ends = [start.position, end.position];
        match self.turns() {
            true => Piece::turning_line(ends, Attitude::between(start.orientation, end.orientation), to - from),
            false => Piece::line(ends[0], ends[1]).held_at(start.orientation),
        }
    }

    /// This piece with the platform held at an orientation.
    pub fn held_at(self, orientation: Rotation) -> Self {
        Piece { attitude: Attitude::held(orientation), ..self }
    }

    /// The orientation of the platform; on a bend on which it turns, only the orientations at both ends.
    pub fn attitude(&self) -> &Attitude {
        &self.attitude
    }

    /// The bend, if the platform may turn on it.
    pub fn turning(&self) -> Option<&TurningBend> {
        self.turning.as_ref()
    }

    /// Whether the platform turns on the piece.
    pub fn turns(&self) -> bool {
        self.turning.is_some() || self.attitude.turns()
    }

    /// Angle of the turn per parameter of a line, rad/m.
    pub fn spin(&self) -> f64 {
        self.attitude.angle() / self.length
    }

    /// A bend with these control points. Its parameter is chosen so that it continues a line in the direction of its first
    /// two control points with continuous first and second derivatives, if the first three are evenly spaced.
    pub fn bend(control: [Point; CONTROL]) -> Self {
        let length = DEGREE as f64 * (control[1] - control[0]).norm();
        let mut differences = control.map(|p| p.coords);
        let (mut powers, mut derivative_bounds) = ([control[0].coords; CONTROL], [0.0; DEGREE]);
        // After k steps `differences` holds the k-th forward differences.
        let (mut binomial, mut falling) = (1.0, 1.0);
        for k in 1..=DEGREE {
            for i in 0..=DEGREE - k {
                differences[i] = differences[i + 1] - differences[i];
            }
            binomial *= (DEGREE + 1 - k) as f64 / k as f64;
            falling *= (DEGREE + 1 - k) as f64 / length;
            powers[k] = differences[0] * binomial;
            let most = differences[..=DEGREE - k].iter().map(Vector::norm).fold(0.0, f64::max);
            derivative_bounds[k - 1] = falling * most;
        }
        let attitude = Attitude::held(Rotation::identity());
        Piece { control: control.to_vec(), powers, attitude, turning: None, length, derivative_bounds }
    }

    /// Control points of the piece: two for a line, six for a bend; for a bend on which the platform turns, its two
    /// ends.
    pub fn control(&self) -> &[Point] {
        &self.control
    }

    /// Whether the piece is a line.
    pub fn is_line(&self) -> bool {
        self.control.len() == 2 && self.turning.is_none()
    }

    /// Position and derivatives at a parameter.
    pub fn at(&self, s: f64) -> Jet {
        if let Some(bend) = &self.turning {
            return bend.jet(s);
        }
        let scale = 1.0 / self.length;
        let u = s * scale;
        let (orientation, spin) = (self.attitude.at(u), self.attitude.axis() * self.spin());
        if self.is_line() {
            let position = Point::from(self.powers[0] + self.powers[1] * u);
            let first = self.powers[1] * scale;
            let zero = Vector::zeros();
            return Jet { position, orientation, first, second: zero, third: zero, spin, spin_change: zero };
        }
        let [mut value, mut first, mut second, mut third] = [Vector::zeros(); 4];
        for power in self.powers.iter().rev() {
            third = third * u + second;
            second = second * u + first;
            first = first * u + value;
            value = value * u + power;
        }
        // Horner's scheme leaves the derivatives divided by factorials.
        let (second, third) = (second * (2.0 * scale * scale), third * (6.0 * scale.powi(3)));
        let (position, first, spin_change) = (Point::from(value), first * scale, Vector::zeros());
        Jet { position, orientation, first, second, third, spin, spin_change }
    }
}

/// A curve of pieces that follow each other.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    pieces: Vec<Piece>,
    /// The parameter at which each piece starts, and the one at which the last piece ends, m.
    starts: Vec<f64>,
}

impl Curve {
    /// The curve of these pieces; at least one.
    pub fn new(pieces: Vec<Piece>) -> Self {
        let mut starts = vec![0.0];
        for piece in &pieces {
            starts.push(starts[starts.len() - 1] + piece.length);
        }
        Curve { pieces, starts }
    }

    /// This curve with the platform held at an orientation.
    pub fn held_at(self, orientation: Rotation) -> Self {
        Curve { pieces: self.pieces.into_iter().map(|piece| piece.held_at(orientation)).collect(), ..self }
    }

    /// Whether the platform turns anywhere on the curve.
    pub fn turns(&self) -> bool {
        self.pieces.iter().any(Piece::turns)
    }

    /// The pieces of the curve.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The parameter at which each piece starts, and the one at which the last piece ends, m.
    pub fn starts(&self) -> &[f64] {
        &self.starts
    }

    /// The largest parameter, m.
    pub fn end(&self) -> f64 {
        self.starts[self.pieces.len()]
    }

    /// The piece at a parameter; at a joint the later one.
    pub fn piece_at(&self, s: f64) -> usize {
        self.starts[1..self.pieces.len()].partition_point(|&start| start <= s)
    }

    /// The piece on which progress from one parameter arrives at another: at a joint the earlier one, unless it starts there.
    pub fn piece_reached(&self, from: f64, s: f64) -> usize {
        let piece = self.piece_at(s);
        if piece > 0 && from < s && s <= self.starts[piece] { piece - 1 } else { piece }
    }

    /// Position and derivatives at a parameter, on this piece.
    pub fn on_piece(&self, piece: usize, s: f64) -> Jet {
        let local = (s - self.starts[piece]).clamp(0.0, self.pieces[piece].length);
        self.pieces[piece].at(local)
    }

    /// Position and derivatives at a parameter; outside the curve, those at its nearest end.
    pub fn at(&self, s: f64) -> Jet {
        self.on_piece(self.piece_at(s), s)
    }

    /// Arc length of the curve, m.
    pub fn length(&self) -> f64 {
        self.pieces.iter().map(Piece::arc_length).sum()
    }
}

/// Nodes and weights of the five-point Gauss rule on [-1, 1].
const GAUSS: [(f64, f64); 5] = [
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
];
/// Parts into which a bend is divided to measure it.
const PARTS: usize = 8;

impl Piece {
    fn arc_length(&self) -> f64 {
        if self.is_line() {
            return if self.attitude.turns() { (self.control[1] - self.control[0]).norm() } else { self.length };
        }
        let half = 0.5 * self.length / PARTS as f64;
        let part = |k: usize| {
            let middle = half * (2 * k + 1) as f64;
            GAUSS.iter().map(|(node, weight)| weight * half * self.at(middle + half * node).first.norm()).sum::<f64>()
        };
        (0..PARTS).map(part).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quarter_turn() -> Curve {
        let corner = Point::new(1.0, 0.0, 0.0);
        let (a, b) = (Vector::x(), Vector::y());
        let h = 0.1;
        let control = [2.5, 1.5, 0.5].map(|k| corner - a * (k * h));
        let after = [0.5, 1.5, 2.5].map(|k| corner + b * (k * h));
        let control = [control[0], control[1], control[2], after[0], after[1], after[2]];
        let line = |from: [f64; 3], to: Point| Piece::line(from.into(), to);
        Curve::new(vec![
            line([0.0; 3], control[0]),
            Piece::bend(control),
            Piece::line(control[5], Point::new(1.0, 1.0, 0.0)),
        ])
    }

    #[test]
    fn first_and_second_derivatives_are_continuous_at_joints() {
        let curve = quarter_turn();
        for joint in 1..3 {
            let s = curve.starts()[joint];
            let (before, after) = (curve.on_piece(joint - 1, s), curve.on_piece(joint, s));
            assert!((before.position - after.position).norm() < 1e-15);
            assert!((before.first - after.first).norm() < 1e-14);
            assert!((before.second - after.second).norm() < 1e-12);
        }
    }

    #[test]
    fn derivatives_match_finite_differences_and_bounds() {
        let curve = quarter_turn();
        let step = 1e-5;
        for k in 0..400 {
            let s = curve.end() * (k as f64 + 0.5) / 400.0;
            let [before, here, after] = [s - step, s, s + step].map(|s| curve.at(s));
            let piece = curve.piece_at(s);
            if curve.piece_at(s - step) != curve.piece_at(s + step) {
                continue;
            }
            assert!(((after.position - before.position) / (2.0 * step) - here.first).norm() < 1e-7);
            assert!(((after.first - before.first) / (2.0 * step) - here.second).norm() < 1e-5);
            assert!(((after.second - before.second) / (2.0 * step) - here.third).norm() < 1e-2);
            let bounds = curve.pieces()[piece].derivative_bounds;
            let norms = [here.first.norm(), here.second.norm(), here.third.norm()];
            assert!(norms.iter().zip(bounds).all(|(norm, bound)| *norm <= bound * (1.0 + 1e-12)));
        }
    }

    #[test]
    fn a_bend_between_collinear_lines_is_straight() {
        let control: [Point; CONTROL] = std::array::from_fn(|k| Point::new(0.1 * k as f64, 0.0, 0.0));
        let bend = Piece::bend(control);
        assert!((bend.length - 0.5).abs() < 1e-15 && (bend.arc_length() - 0.5).abs() < 1e-14);
        assert!((bend.at(0.2).first - Vector::x()).norm() < 1e-14 && bend.at(0.2).second.norm() < 1e-13);
    }
}
