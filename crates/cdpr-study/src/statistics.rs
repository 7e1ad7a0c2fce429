//! Means, quantiles, confidence intervals and two-sample t-tests; the distribution comes from `statrs`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use statrs::distribution::{ContinuousCDF, StudentsT};

/// Size, mean and variance of a sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moments {
    /// Number of values.
    pub n: usize,
    /// Mean; NaN without values.
    pub mean: f64,
    /// Variance with n - 1 in the denominator; NaN for fewer than two values.
    pub variance: f64,
}

impl Moments {
    /// Computes the summary of these values in two passes.
    pub fn of(values: &[f64]) -> Self {
        let n = values.len();
        let mean = values.iter().sum::<f64>() / n as f64;
        let squares: f64 = values.iter().map(|x| (x - mean) * (x - mean)).sum();
        let variance = if n < 2 { f64::NAN } else { squares / (n - 1) as f64 };
        Moments { n, mean, variance }
    }

    /// Standard deviation.
    pub fn sd(&self) -> f64 {
        self.variance.sqrt()
    }

    /// Student's confidence interval of the mean at this level; NaN for fewer than two values.
    ///
    /// # Example
    /// ```
    /// use cdpr_study::Moments;
    /// // t(0.975, 4 degrees of freedom) = 2.776445...
    /// let [low, high] = Moments::of(&[1.0, 2.0, 3.0, 4.0, 5.0]).confidence_interval(0.95);
    /// assert!((high - 3.0 - 2.776445105 * 0.5f64.sqrt()).abs() < 1e-8 && (low + high - 6.0).abs() < 1e-12);
    /// ```
    pub fn confidence_interval(&self, level: f64) -> [f64; 2] {
        let half = student(self.n as f64 - 1.0).map_or(f64::NAN, |t| t.inverse_cdf(0.5 + 0.5 * level))
            * (self.variance / self.n as f64).sqrt();
        [self.mean - half, self.mean + half]
    }
}

fn student(df: f64) -> Option<StudentsT> {
    StudentsT::new(0.0, 1.0, df).ok().filter(|_| df.is_finite())
}

/// Quantile of sorted values, linear between neighbours (type 7 of Hyndman and Fan, 1996); NaN without values.
pub fn quantile(sorted: &[f64], p: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else { return f64::NAN };
    let at = p.clamp(0.0, 1.0) * last as f64;
    let below = at.floor() as usize;
    let (low, high) = (sorted[below], sorted[(below + 1).min(last)]);
    low + (high - low) * (at - below as f64)
}

/// How the variances of two samples are treated.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Comparison {
    /// Separate variances (Welch, 1947).
    #[default]
    Welch,
    /// A common variance, estimated from both samples (Student).
    Pooled,
}

/// A two-sample t-test of equal means, two-sided.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TTest {
    /// The statistic: mean of a minus mean of b, divided by its standard error.
    pub t: f64,
    /// Degrees of freedom.
    pub df: f64,
    /// Probability of a statistic at least as far from 0 if the means are equal.
    pub p: f64,
}

/// Compares the means of two samples; all results are NaN if a sample has fewer than two values or neither has any
/// variance.
///
/// # Example
/// ```
/// use cdpr_study::{Comparison, Moments, t_test};
/// let (a, b) = (Moments::of(&[1.0, 2.0, 3.0, 4.0]), Moments::of(&[3.0, 5.0, 7.0]));
/// let test = t_test(&a, &b, Comparison::Welch); // as scipy.stats.ttest_ind(a, b, equal_var=False)
/// assert!((test.t + 1.889822365).abs() < 1e-8 && (test.df - 3.234718826).abs() < 1e-8, "{test:?}");
/// ```
pub fn t_test(a: &Moments, b: &Moments, comparison: Comparison) -> TTest {
    let (na, nb) = (a.n as f64, b.n as f64);
    let (error, df) = match comparison {
        Comparison::Welch => {
            let (va, vb) = (a.variance / na, b.variance / nb);
            ((va + vb).sqrt(), (va + vb).powi(2) / (va * va / (na - 1.0) + vb * vb / (nb - 1.0)))
        }
        Comparison::Pooled => {
            let df = na + nb - 2.0;
            let pooled = ((na - 1.0) * a.variance + (nb - 1.0) * b.variance) / df;
            ((pooled * (1.0 / na + 1.0 / nb)).sqrt(), df)
        }
    };
    two_sided((a.mean - b.mean) / error, df)
}

/// Compares values that belong together in pairs, by the summary of their differences; all results are NaN for fewer than two
/// pairs or differences without any variance.
///
/// # Example
/// ```
/// use cdpr_study::{Moments, paired_t_test};
/// let test = paired_t_test(&Moments::of(&[-1.0, -2.0, -4.0])); // as scipy.stats.ttest_rel(a, b)
/// assert!((test.t + 2.645751311).abs() < 1e-8 && test.df == 2.0, "{test:?}");
/// ```
pub fn paired_t_test(differences: &Moments) -> TTest {
    let df = differences.n as f64 - 1.0;
    two_sided(differences.mean / (differences.variance / differences.n as f64).sqrt(), df)
}

fn two_sided(t: f64, df: f64) -> TTest {
    match student(df) {
        Some(student) if t.is_finite() => TTest { t, df, p: (2.0 * student.sf(t.abs())).min(1.0) },
        _ => TTest { t: f64::NAN, df: f64::NAN, p: f64::NAN },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_interpolate_and_ends_are_ends() {
        let sorted = [1.0, 2.0, 4.0, 8.0];
        assert_eq!([0.0, 0.5, 0.25, 1.0].map(|p| quantile(&sorted, p)), [1.0, 3.0, 1.75, 8.0]);
        assert!(quantile(&[], 0.5).is_nan());
        assert_eq!(quantile(&[3.0], 0.9), 3.0);
    }

    #[test]
    fn t_tests_are_those_of_scipy() {
        // scipy.stats.ttest_ind: t, df, p with equal_var=False, then with True. Student's sleep data (1908) among them.
        let sleep = [
            vec![0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0],
            vec![1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4],
        ];
        let far = [
            (0..200).map(|i| f64::from(i) / 100.0).collect(),
            (0..150).map(|i| 2.0 + f64::from(i * i) / 10_000.0).collect(),
        ];
        for ([a, b], welch, pooled) in [
            (
                [vec![1.0, 2.0, 3.0, 4.0], vec![3.0, 5.0, 7.0]],
                [-1.889822365046136, 3.234718826405868, 0.1484713470268853],
                [-2.029994857352875, 5.0, 0.09811182125573019],
            ),
            (
                sleep,
                [-1.8608134674868526, 17.776473516178488, 0.0793941401873583],
                [-1.8608134674868524, 18.0, 0.07918671421593822],
            ),
            (
                far,
                [-25.606619508577552, 293.94426741588904, 7.85176241062742e-77],
                [-26.139021814563677, 348.0, 4.257679032881024e-84],
            ),
        ] {
            let (a, b) = (Moments::of(&a), Moments::of(&b));
            for (comparison, expected) in [(Comparison::Welch, welch), (Comparison::Pooled, pooled)] {
                let TTest { t, df, p } = t_test(&a, &b, comparison);
                let near = |(found, known): (f64, f64)| (found / known - 1.0).abs() < 1e-9;
                assert!([t, df, p].into_iter().zip(expected).all(near), "{comparison:?}: {t} {df} {p}");
            }
        }
    }

    #[test]
    fn paired_tests_are_those_of_scipy() {
        // scipy.stats.ttest_rel of Student's sleep data (1908).
        let first = [0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0];
        let second = [1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4];
        let differences: Vec<f64> = first.iter().zip(second).map(|(a, b)| a - b).collect();
        let TTest { t, df, p } = paired_t_test(&Moments::of(&differences));
        assert!((t + 4.062127683382037).abs() < 1e-9 && df == 9.0 && (p - 0.00283289019738427).abs() < 1e-9, "{t} {p}");
        for few in [&[][..], &[1.0], &[2.0, 2.0]] {
            assert!(paired_t_test(&Moments::of(few)).p.is_nan(), "{few:?}");
        }
    }

    #[test]
    fn too_little_to_compare_has_no_answer() {
        let one = Moments::of(&[1.0]);
        let same = Moments::of(&[2.0, 2.0, 2.0]);
        let other = Moments::of(&[1.0, 2.0, 3.0]);
        for (a, b) in [(one, other), (other, one), (same, same), (Moments::of(&[]), other)] {
            for comparison in [Comparison::Welch, Comparison::Pooled] {
                let test = t_test(&a, &b, comparison);
                assert!(test.p.is_nan() || a.n + b.n == 4, "{test:?}");
            }
        }
        assert_eq!(t_test(&other, &other, Comparison::Welch).p, 1.0);
        assert!(one.confidence_interval(0.95)[0].is_nan());
    }
}
