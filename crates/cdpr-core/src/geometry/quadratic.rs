//! Bounds of a function over a box of positions: it is near a quadratic function of the offset from the centre, in half sides.

use super::{Cuboid, HalfSpace, Vector};

/// The coefficients of x², y², z², xy, xz and yz.
pub type Curve = [f64; 6];

/// The axes of the products in a [`Curve`].
const MIXED: [[usize; 2]; 3] = [[0, 1], [0, 2], [1, 2]];

/// Uncertainty, as a share of the change in a box, that counts as small.
const SHARP: f64 = 0.05;

/// A function over a box, near a quadratic one.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Quadratic {
    pub at_center: f64,
    pub slope: [f64; 3],
    pub curve: Curve,
    /// It is at most this much lower than the quadratic function, and at most this much higher.
    pub below: f64,
    pub above: f64,
}

/// A function over a box, near an affine one.
#[derive(Debug, Clone, Copy)]
pub struct Affine {
    at_center: f64,
    slope: [f64; 3],
    below: f64,
    above: f64,
}

/// The product of two linear functions.
pub fn product(a: &[f64; 3], b: &[f64; 3]) -> Curve {
    let mixed = MIXED.map(|[i, j]| a[i] * b[j] + a[j] * b[i]);
    [a[0] * b[0], a[1] * b[1], a[2] * b[2], mixed[0], mixed[1], mixed[2]]
}

/// Adds a multiple of a curve to another.
pub fn add(to: &mut Curve, factor: f64, curve: &Curve) {
    to.iter_mut().zip(curve).for_each(|(to, c)| *to += factor * c);
}

/// The most by which the values of a linear or quadratic form in a box differ from zero.
pub fn reach(coefficients: &[f64]) -> f64 {
    coefficients.iter().map(|c| c.abs()).sum()
}

impl Quadratic {
    /// Adds a multiple of another function.
    pub fn add(&mut self, factor: f64, other: &Quadratic) {
        self.at_center += factor * other.at_center;
        (0..3).for_each(|axis| self.slope[axis] += factor * other.slope[axis]);
        add(&mut self.curve, factor, &other.curve);
        let [down, up] = if factor > 0.0 { [other.below, other.above] } else { [other.above, other.below] };
        self.below += factor.abs() * down;
        self.above += factor.abs() * up;
    }

    /// A lower bound of the function in the whole box.
    pub fn least(&self) -> f64 {
        let along = |axis: usize| lowest(self.slope[axis].abs(), self.curve[axis]);
        self.at_center + (0..3).map(along).sum::<f64>() - reach(&self.curve[3..]) - self.below
    }

    /// An upper bound of the function in the whole box.
    pub fn greatest(&self) -> f64 {
        let along = |axis: usize| lowest(self.slope[axis].abs(), -self.curve[axis]);
        self.at_center - (0..3).map(along).sum::<f64>() + reach(&self.curve[3..]) + self.above
    }

    /// The function over a box within the box: from its centre, in its half sides.
    pub fn within(&self, whole: &Cuboid, part: &Cuboid) -> Self {
        let share = |a: f64, b: f64| if b > 0.0 { a / b } else { 0.0 };
        let at: [f64; 3] = std::array::from_fn(|axis| share(part.center[axis] - whole.center[axis], whole.half[axis]));
        let scale: [f64; 3] = std::array::from_fn(|axis| share(part.half[axis], whole.half[axis]));
        let mut found = *self;
        for axis in 0..3 {
            let square = self.curve[axis] * at[axis];
            found.at_center += at[axis] * (self.slope[axis] + square);
            found.slope[axis] += 2.0 * square;
            found.curve[axis] *= scale[axis] * scale[axis];
        }
        for (k, [i, j]) in (3..).zip(MIXED) {
            found.at_center += self.curve[k] * at[i] * at[j];
            found.slope[i] += self.curve[k] * at[j];
            found.slope[j] += self.curve[k] * at[i];
            found.curve[k] *= scale[i] * scale[j];
        }
        (0..3).for_each(|axis| found.slope[axis] *= scale[axis]);
        found
    }

    /// How much more the function may bend down than the quadratic one, compared with how much that one changes in the box.
    pub fn staleness(&self) -> f64 {
        self.below / (reach(&self.slope) + reach(&self.curve))
    }

    /// Whether the function is known much less well than it is near an affine one that changes in the box.
    pub fn is_loose(&self) -> bool {
        !(self.below + self.above <= reach(&self.curve) + SHARP * reach(&self.slope))
    }

    /// The function as near an affine one, in the middle between the bounds of the squares.
    pub fn affine(&self) -> Affine {
        let bend = 0.5 * reach(&self.curve[..3]) + reach(&self.curve[3..]);
        Affine {
            at_center: self.at_center + 0.5 * self.curve[..3].iter().sum::<f64>(),
            slope: self.slope,
            below: self.below + bend,
            above: self.above + bend,
        }
    }
}

/// The smallest value of c t² − s t for t from −1 to 1, where s is not negative.
fn lowest(s: f64, c: f64) -> f64 {
    if 2.0 * c > s { -0.25 * s * s / c } else { c - s }
}

impl Affine {
    /// The smallest value of the affine function in the box.
    fn lowest(&self) -> f64 {
        self.at_center - reach(&self.slope)
    }

    /// The positions of the box where the function certainly is not negative, as a half-space; `None` if that is all of them.
    pub fn sufficing(&self, positions: &Cuboid) -> Option<HalfSpace> {
        (self.lowest() < self.below).then(|| self.half_space(positions, -1.0, self.at_center - self.below))
    }

    /// The positions of the box where the function certainly is negative; `None` if no such positions are known.
    pub fn lacking(&self, positions: &Cuboid) -> Option<HalfSpace> {
        (self.lowest() + self.above < 0.0).then(|| self.half_space(positions, 1.0, -(self.at_center + self.above)))
    }

    /// The offsets x, in half sides, with sign · slope·x < room.
    fn half_space(&self, positions: &Cuboid, sign: f64, room: f64) -> HalfSpace {
        let gradient = Vector::from_fn(|axis, _| sign * self.slope[axis] / positions.half[axis]);
        let steep = gradient.norm();
        // Beyond the box, the plane may be anywhere; if the function is constant, it is on one side of the box.
        let far = 2.0 * positions.half.norm();
        let (normal, at) = match gradient.try_normalize(0.0) {
            Some(normal) => (normal, (room / steep).clamp(-far, far)),
            None => (Vector::x(), if room > 0.0 { far } else { -far }),
        };
        HalfSpace::through(&(positions.center + normal * at), normal)
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::geometry::Point;

    fn value(of: &Quadratic, x: &[f64; 3]) -> f64 {
        let curve: f64 = of.curve.iter().zip(product(x, x)).map(|(c, x)| c * x).sum();
        let mixed: f64 = of.curve[3..].iter().zip(&product(x, x)[3..]).map(|(c, x)| c * x).sum();
        // A product of a form with itself has its mixed terms twice.
        of.at_center + (0..3).map(|axis| of.slope[axis] * x[axis]).sum::<f64>() + curve - 0.5 * mixed
    }

    /// Of random functions over random boxes, flat ones among them, at random places.
    #[test]
    fn bounds_hold_at_random_places_and_in_parts() {
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        let mut counts = [0; 4];
        for round in 0..10_000 {
            let mut random = |size: f64| rng.random_range(-size..size);
            let function = Quadratic {
                at_center: random(1.0),
                slope: std::array::from_fn(|_| random(1.0)),
                curve: std::array::from_fn(|_| random(1.0)),
                below: random(0.2).abs(),
                above: random(0.2).abs(),
            };
            let flat = round % 10 == 0;
            let half = Vector::from_fn(|axis, _| if flat && axis == 1 { 0.0 } else { random(1.0).abs() + 1e-3 });
            let center = Point::new(random(9.0), random(9.0), random(9.0));
            let whole = Cuboid::new(center - half, center + half);
            let scale = random(1.0).abs();
            let shift = Vector::from_fn(|axis, _| half[axis] * (1.0 - scale) * random(1.0));
            let part = Cuboid::new(center + shift - half * scale, center + shift + half * scale);
            let within = function.within(&whole, &part);
            let (affine, bounds) = (within.affine(), [within.least(), within.greatest()]);
            for _ in 0..10 {
                let x: [f64; 3] = std::array::from_fn(|_| random(1.5).clamp(-1.0, 1.0));
                let place = part.center + part.half.component_mul(&Vector::from(x));
                let share = |axis: usize| {
                    if half[axis] > 0.0 { (place[axis] - whole.center[axis]) / whole.half[axis] } else { 0.0 }
                };
                let (inner, outer) = (value(&within, &x), value(&function, &[0, 1, 2].map(share)));
                if !flat {
                    assert!((inner - outer).abs() < 1e-9, "{inner} {outer}");
                }
                let [least, greatest] = [inner - within.below, inner + within.above];
                assert!(bounds[0] <= least + 1e-12 && greatest <= bounds[1] + 1e-12, "{within:?} at {x:?}");
                if flat {
                    continue;
                }
                let [sufficing, lacking] = [affine.sufficing(&part), affine.lacking(&part)];
                let claims = [
                    sufficing.is_none_or(|plane| plane.height(&place) < -1e-9),
                    lacking.is_some_and(|plane| plane.height(&place) < -1e-9),
                ];
                assert!(!claims[0] || least >= 0.0, "{within:?} at {x:?}");
                assert!(!claims[1] || greatest < 0.0, "{within:?} at {x:?}");
                let all = [claims[0], claims[1], bounds[0] >= 0.0, bounds[1] < 0.0];
                counts.iter_mut().zip(all).for_each(|(count, claimed)| *count += usize::from(claimed));
            }
        }
        assert!(counts.iter().all(|count| *count > 1000), "{counts:?}");
    }
}
