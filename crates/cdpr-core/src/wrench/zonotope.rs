//! Facets of a zonotope {W t : t_min ≤ t ≤ t_max} in N dimensions, by hyperplane shifting.
//!
//! A facet of a set of rank n is spanned by n − 1 generators (columns of W), so every choice of n − 1 independent ones
//! gives a normal, and the other generators determine the offsets of its two parallel facets. The choices are visited
//! as a tree: each level keeps an orthonormal basis of the space orthogonal to the generators chosen so far, one vector
//! fewer each time, until only the normal is left. Dependent choices span no facet and are skipped. If W does not have
//! full rank, the tree starts from a basis of its column space, and the set is flat in the remaining directions.
//!
//! Source: hyperplane shifting after Gouttefarde and Krut, "Characterization of parallel manipulator available wrench
//! set facets", Advances in Robot Kinematics, 2010, doi:10.1007/978-90-481-9262-5_51.

use nalgebra::SVector;

use crate::tolerances::{DEPENDENT, RANK_RELATIVE};

/// An orthonormal basis of N dimensions, split: the first `rank` vectors span the generators, the others are orthogonal
/// to all of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span<const N: usize> {
    basis: [SVector<f64, N>; N],
    rank: usize,
}

impl<const N: usize> Span<N> {
    /// The span of generators; components below [`RANK_RELATIVE`] of the longest one count as zero.
    pub fn of(generators: &[SVector<f64, N>]) -> Self {
        let scale = largest(generators);
        let mut basis = [SVector::zeros(); N];
        let mut rank = 0;
        while rank < N {
            let residual = |v: &SVector<f64, N>| across(v, &basis[..rank]);
            let longest = generators.iter().map(residual).max_by(|a, b| a.norm().total_cmp(&b.norm()));
            let Some(next) = longest.filter(|v| v.norm() > RANK_RELATIVE * scale) else { break };
            basis[rank] = across(&next.normalize(), &basis[..rank]).normalize();
            rank += 1;
        }
        for k in rank..N {
            let axes = (0..N).map(|axis| SVector::from_fn(|row, _| f64::from(row == axis)));
            let farthest = axes.map(|v| across(&v, &basis[..k])).max_by(|a, b| a.norm().total_cmp(&b.norm()));
            let next = farthest.expect("N is positive").normalize();
            basis[k] = across(&next, &basis[..k]).normalize();
        }
        Span { basis, rank }
    }

    /// The rank of the generators.
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// Orthonormal vectors orthogonal to all generators: the left null space of W.
    pub fn left_null(&self) -> &[SVector<f64, N>] {
        &self.basis[self.rank..]
    }
}

/// The component of a vector orthogonal to orthonormal vectors.
fn across<const N: usize>(v: &SVector<f64, N>, basis: &[SVector<f64, N>]) -> SVector<f64, N> {
    basis.iter().fold(*v, |rest, b| rest - b * b.dot(&rest))
}

fn largest<const N: usize>(generators: &[SVector<f64, N>]) -> f64 {
    generators.iter().map(|g| g.norm()).fold(0.0, f64::max)
}

/// Calls `visit` with a unit normal of each pair of parallel facets; some normals occur more than once.
///
/// # Example
/// ```
/// use cdpr_core::wrench::zonotope::{for_each_normal, Span};
/// use nalgebra::Vector3;
/// let edges = [Vector3::x(), Vector3::y(), Vector3::z()]; // a cube has three pairs of faces
/// let mut normals = Vec::new();
/// for_each_normal(&edges, &Span::of(&edges), &mut |normal| normals.push(*normal));
/// assert_eq!(normals.len(), 3);
/// ```
pub fn for_each_normal<const N: usize>(
    generators: &[SVector<f64, N>],
    span: &Span<N>,
    visit: &mut impl FnMut(&SVector<f64, N>),
) {
    descend(generators, &span.basis, span.rank, DEPENDENT * largest(generators), visit);
}

/// Chooses among `generators` until one vector of the first `left` of the basis remains.
fn descend<const N: usize>(
    generators: &[SVector<f64, N>],
    basis: &[SVector<f64, N>; N],
    left: usize,
    negligible: f64,
    visit: &mut impl FnMut(&SVector<f64, N>),
) {
    if left == 1 {
        return visit(&basis[0]);
    }
    for (k, generator) in generators.iter().enumerate() {
        if generators.len() - k < left.saturating_sub(1) || left == 0 {
            return;
        }
        if let Some(rest) = without(basis, left, generator, negligible) {
            descend(&generators[k + 1..], &rest, left - 1, negligible, visit);
        }
    }
}

/// An orthonormal basis of the vectors orthogonal to a generator within the first `left` vectors of a basis: they are
/// reflected so that the last of them points along the generator, and that one is dropped. `None` if the generator is
/// orthogonal to them all.
fn without<const N: usize>(
    basis: &[SVector<f64, N>; N],
    left: usize,
    generator: &SVector<f64, N>,
    negligible: f64,
) -> Option<[SVector<f64, N>; N]> {
    let mut mirror = SVector::<f64, N>::zeros();
    for (k, b) in basis[..left].iter().enumerate() {
        mirror[k] = b.dot(generator);
    }
    let norm = mirror.norm();
    if !(norm > negligible) {
        return None;
    }
    mirror /= norm;
    mirror[left - 1] += if mirror[left - 1] < 0.0 { -1.0 } else { 1.0 };
    let along: SVector<f64, N> = basis[..left].iter().zip(mirror.iter()).map(|(b, m)| b * *m).sum();
    let along = along * (2.0 / mirror.norm_squared());
    let mut rest = *basis;
    for (r, m) in rest[..left - 1].iter_mut().zip(mirror.iter()) {
        *r -= along * *m;
    }
    Some(rest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Vector3, Vector6};

    fn count<const N: usize>(generators: &[SVector<f64, N>]) -> usize {
        let mut count = 0;
        for_each_normal(generators, &Span::of(generators), &mut |_| count += 1);
        count
    }

    #[test]
    fn eight_generic_generators_have_56_facet_pairs() {
        let generic = |k: usize| Vector6::from_fn(|r, _| (((k * 6 + r) * (k * 6 + r)) as f64 * 0.7).sin());
        let generators: Vec<_> = (0..8).map(generic).collect();
        assert_eq!(Span::of(&generators).rank(), 6);
        let mut least = f64::INFINITY;
        for_each_normal(&generators, &Span::of(&generators), &mut |normal| {
            let mut heights: Vec<f64> = generators.iter().map(|g| g.dot(normal).abs()).collect();
            heights.sort_by(f64::total_cmp);
            assert!(heights[4] < 1e-14 && (normal.norm() - 1.0).abs() < 1e-14); // five generators lie in the facet
            least = least.min(heights[5]);
        });
        assert_eq!(count(&generators), 56);
        assert!(least > 1e-6);
    }

    #[test]
    fn flat_sets_have_facets_in_their_plane() {
        let (x, y) = (Vector3::x(), Vector3::y());
        assert_eq!(count(&[x, x * 2.0, y]), 3); // x, x, y alone, each an edge of a parallelogram
        let span = Span::of(&[x, y, x + y]);
        assert_eq!((span.rank(), span.left_null()), (2, [Vector3::z()].as_slice()));
        assert_eq!(count(&[x, x, x, Vector3::z()]), 4);
        assert_eq!(count(&[Vector3::zeros()]), 0);
    }
}
