//! Exact arithmetic: numbers m · 2^e with an integer m of any size. Every finite `f64` is such a number, and so are
//! sums, differences and products; nothing here rounds except [`Exact::to_f64`].

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use cdpr_core::geometry::Vector;
use num_bigint::{BigInt, Sign};

/// The number `mantissa` · 2^`exponent`.
#[derive(Debug, Clone)]
pub struct Exact {
    mantissa: BigInt,
    exponent: i64,
}

/// A finite `f64`, exactly.
pub fn exact(x: f64) -> Exact {
    assert!(x.is_finite(), "{x} is not a number");
    let bits = x.to_bits();
    let (biased, fraction) = ((bits >> 52 & 0x7ff) as i64, bits & ((1 << 52) - 1));
    let (magnitude, exponent) = if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) };
    let zeros = if magnitude == 0 { 0 } else { magnitude.trailing_zeros() };
    let shortest = (magnitude >> zeros) as i64;
    let mantissa = BigInt::from(if x < 0.0 { -shortest } else { shortest });
    Exact { mantissa, exponent: exponent + i64::from(zeros) }
}

impl Exact {
    /// How the number compares with zero.
    pub fn sign(&self) -> Ordering {
        match self.mantissa.sign() {
            Sign::Minus => Ordering::Less,
            Sign::NoSign => Ordering::Equal,
            Sign::Plus => Ordering::Greater,
        }
    }

    /// The absolute value.
    pub fn abs(&self) -> Exact {
        if self.sign().is_lt() { -self } else { self.clone() }
    }

    /// About the same number; infinite or zero beyond the range of `f64`.
    pub fn to_f64(&self) -> f64 {
        let surplus = self.mantissa.bits().saturating_sub(62);
        let leading = i64::try_from(&self.mantissa >> surplus).expect("62 bits") as f64;
        let power = self.exponent + surplus as i64;
        let part = |power: i64| 2f64.powi(power.clamp(-1000, 1000) as i32);
        leading * part(power / 2) * part(power - power / 2) // 2^power itself may be out of range
    }

    /// About this number divided by another one that is not zero, even if both are beyond the range of `f64`.
    pub fn over(&self, divisor: &Exact) -> f64 {
        let leading = |x: &Exact| {
            let bits = x.mantissa.bits().max(1) as i64;
            (Exact { mantissa: x.mantissa.clone(), exponent: -bits }.to_f64(), x.exponent.saturating_add(bits))
        };
        let ((a, a_power), (b, b_power)) = (leading(self), leading(divisor));
        let power = a_power.saturating_sub(b_power).clamp(-2000, 2000) as i32;
        a / b * 2f64.powi(power / 2) * 2f64.powi(power - power / 2) // 2^power itself may be out of range
    }

    /// An `f64` whose square is at least this number, and hardly more; `None` beyond the range of `f64`.
    pub fn root_above(&self) -> Option<Exact> {
        self.f64_above(self.to_f64().sqrt(), |root| root * root)
    }

    /// A number that is not negative and whose square is at most this number, and hardly less.
    pub fn root_below(&self) -> Exact {
        let mut root = self.to_f64().max(0.0).sqrt().min(f64::MAX);
        while root > 0.0 && exact(root) * exact(root) > *self {
            root = root.next_down();
        }
        exact(root)
    }

    /// An `f64` that is at least this number divided by a positive one, and hardly more; `None` beyond the range.
    pub fn quotient_above(&self, divisor: &Exact) -> Option<Exact> {
        self.f64_above(self.to_f64() / divisor.to_f64(), |quotient| quotient * divisor)
    }

    /// The first `f64` from a guess upwards whose image is at least this number; `None` if the guess is far too low.
    fn f64_above(&self, mut guess: f64, image: impl Fn(&Exact) -> Exact) -> Option<Exact> {
        for _ in 0..16 {
            if !guess.is_finite() {
                return None;
            }
            if image(&exact(guess)) >= *self {
                return Some(exact(guess));
            }
            guess = guess.next_up();
        }
        None
    }

    /// Both mantissas for the smaller one of the two exponents.
    fn aligned(&self, other: &Exact) -> (BigInt, BigInt, i64) {
        let exponent = self.exponent.min(other.exponent);
        let shifted = |x: &Exact| &x.mantissa << (x.exponent - exponent) as u64;
        (shifted(self), shifted(other), exponent)
    }
}

impl Add for &Exact {
    type Output = Exact;

    fn add(self, other: &Exact) -> Exact {
        let (a, b, exponent) = self.aligned(other);
        Exact { mantissa: a + b, exponent }
    }
}

impl Mul for &Exact {
    type Output = Exact;

    fn mul(self, other: &Exact) -> Exact {
        Exact { mantissa: &self.mantissa * &other.mantissa, exponent: self.exponent + other.exponent }
    }
}

impl Neg for &Exact {
    type Output = Exact;

    fn neg(self) -> Exact {
        Exact { mantissa: -&self.mantissa, exponent: self.exponent }
    }
}

impl Sub for &Exact {
    type Output = Exact;

    fn sub(self, other: &Exact) -> Exact {
        self + &-other
    }
}

/// Implements the operators of [`Exact`] for owned numbers.
macro_rules! owned {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for Exact {
            type Output = Exact;
            fn $method(self, other: Exact) -> Exact { (&self).$method(&other) }
        }
        impl $operator<&Exact> for Exact {
            type Output = Exact;
            fn $method(self, other: &Exact) -> Exact { (&self).$method(other) }
        }
        impl $operator<Exact> for &Exact {
            type Output = Exact;
            fn $method(self, other: Exact) -> Exact { self.$method(&other) }
        }
    )*};
}
owned!(Add add, Sub sub, Mul mul);

impl std::iter::Sum for Exact {
    fn sum<I: Iterator<Item = Exact>>(numbers: I) -> Exact {
        numbers.fold(exact(0.0), |sum, x| sum + x)
    }
}

impl PartialEq for Exact {
    fn eq(&self, other: &Exact) -> bool {
        (self - other).sign().is_eq()
    }
}

impl PartialOrd for Exact {
    fn partial_cmp(&self, other: &Exact) -> Option<Ordering> {
        Some((self - other).sign())
    }
}

/// Three exact coordinates.
pub type Exact3 = [Exact; 3];

/// A vector of finite `f64`, exactly.
pub fn exact3(v: &Vector) -> Exact3 {
    [exact(v.x), exact(v.y), exact(v.z)]
}

/// The zero vector.
pub fn zeros() -> Exact3 {
    [exact(0.0), exact(0.0), exact(0.0)]
}

/// The sum of two vectors.
pub fn plus(a: &Exact3, b: &Exact3) -> Exact3 {
    [&a[0] + &b[0], &a[1] + &b[1], &a[2] + &b[2]]
}

/// The difference of two vectors.
pub fn minus(a: &Exact3, b: &Exact3) -> Exact3 {
    [&a[0] - &b[0], &a[1] - &b[1], &a[2] - &b[2]]
}

/// A multiple of a vector.
pub fn times(factor: &Exact, v: &Exact3) -> Exact3 {
    [factor * &v[0], factor * &v[1], factor * &v[2]]
}

/// The squared distance of a box from zero, given its least and its largest coordinates.
pub fn nearest_square(low: &Exact3, high: &Exact3) -> Exact {
    let away = |k: usize| match (low[k].sign(), high[k].sign()) {
        (Ordering::Greater, _) => &low[k] * &low[k],
        (_, Ordering::Less) => &high[k] * &high[k],
        _ => exact(0.0),
    };
    (0..3).map(away).sum()
}

/// The scalar product.
pub fn dot(a: &Exact3, b: &Exact3) -> Exact {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// The vector product.
pub fn cross(a: &Exact3, b: &Exact3) -> Exact3 {
    let minor = |j: usize, k: usize| &a[j] * &b[k] - &a[k] * &b[j];
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extreme_numbers_are_exact() {
        let (large, small) = (exact(f64::MAX), exact(5e-324));
        let sum = &large + &small;
        assert!(sum > large && &sum - &large == small && sum.clone() - sum == exact(0.0));
        assert!((exact(0.1) + exact(0.2)) != exact(0.3)); // as the doubles are
        assert_eq!((exact(0.5) * exact(-6.0)).to_f64(), -3.0);
    }

    #[test]
    fn quotients_of_numbers_beyond_f64_range_are_correct() {
        let tiny = exact(1e-300) * exact(1e-300);
        assert_eq!((exact(3.0) * &tiny).over(&tiny), 3.0);
        assert_eq!(exact(-0.75).over(&exact(0.25)), -3.0);
        assert_eq!(exact(0.0).over(&tiny), 0.0);
        assert!(tiny.over(&exact(1.0)) == 0.0 && exact(-1.0).over(&tiny) == f64::NEG_INFINITY);
        let huge = exact(1e300) * exact(1e300);
        assert_eq!((&huge * &exact(0.1)).over(&huge), 0.1);
    }

    #[test]
    fn roots_and_quotients_round_to_the_safe_side() {
        for x in [2.0, 1e-300, 0.0, 1e-5, 3e200, 9.0] {
            let (above, below) = (exact(x).root_above().unwrap(), exact(x).root_below());
            assert!(&above * &above >= exact(x) && &below * &below <= exact(x));
            assert!((above.to_f64() - below.to_f64()) <= 4.0 * f64::EPSILON * above.to_f64(), "{x}");
        }
        for x in [1.0, -1.0, 7.0] {
            let quotient = exact(x).quotient_above(&exact(3.0)).unwrap();
            assert!(&quotient * &exact(3.0) >= exact(x) && (quotient.to_f64() - x / 3.0).abs() < 1e-15);
        }
    }
}
