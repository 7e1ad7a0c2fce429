//! Bounds between two instants for cables that run round pulleys, and for all outlets within their errors: by how fast directions
//! turn at most ([`crate::geometry::Leeway`]), since cable vectors are not those to fixed outlets.

use nalgebra::{DMatrix, SVector, Vector6};

use super::{CableBounds, MovingMass, Span};
use crate::geometry::TurnBounds;
use crate::wrench::{Part, StaticCable};

impl MovingMass {
    /// Whether these bounds are needed.
    pub(super) fn of_any_outlet(&self) -> bool {
        self.statics.has_pulleys() || self.statics.has_errors()
    }

    /// The cables, their bounds, and how fast they turn; `None` for one that may lose its direction.
    fn turning_cables<'a>(
        &'a self,
        Span { ends, rates, time }: &'a Span,
    ) -> impl Iterator<Item = (&'a StaticCable, CableBounds, Option<TurnBounds>)> + 'a {
        let [first, last] = ends.each_ref().map(|motion| (motion.position, self.arms(&motion.orientation)));
        let arms = first.1.zip(last.1);
        self.statics.cables().iter().zip(self.bounds(&ends[0], rates)).zip(arms).map(move |((cable, bounds), arms)| {
            let at = |position, arm| StaticCable { arm, ..cable.clone() }.leeway(position);
            let leeway = at(&first.0, arms.0).between(at(&last.0, arms.1), bounds.attachment[0] * time);
            (cable, bounds, leeway.within(cable.outlet_error).turning())
        })
    }

    /// [`MovingMass::sag`] for any outlet.
    pub(super) fn sag_of_any(&self, span: &Span) -> f64 {
        let time = span.time;
        let of = |(cable, bounds, turning): (&StaticCable, CableBounds, Option<TurnBounds>)| {
            let Some(turning) = turning else { return f64::INFINITY };
            let ([speed, acceleration], [swing, jolt]) = (bounds.attachment, bounds.arm);
            let turn = speed * turning.first;
            let bend = acceleration * turning.first + speed * speed * turning.second;
            let [least, largest] = cable.tension;
            let first = bounds.lever * (turn * time).min(2.0) + swing * time;
            let second = bounds.lever * bend + jolt + 2.0 * swing * turn;
            0.25 * (largest - least) * first + 0.125 * largest * time * time * second
        };
        let cables: f64 = self.turning_cables(span).map(of).sum();
        cables + time * time / 8.0 * self.second_derivative(&span.ends[0], span.rates)
    }

    /// [`MovingMass::spare`] for any outlet: the smallest singular value of the wrench matrix at the first instant, minus what the
    /// columns can change by.
    pub(super) fn spare_of_any(&self, span: &Span) -> f64 {
        let start = &span.ends[0];
        let statics = self.statics_at(&start.orientation);
        let Some(columns) = statics.columns(&start.position) else { return 0.0 };
        let of = |((_, bounds, turning), at): ((&StaticCable, CableBounds, Option<TurnBounds>), &StaticCable)| {
            let astray = at.leeway(&start.position).astray(at.outlet_error)?;
            let turned = (bounds.attachment[0] * turning?.first * span.time).min(2.0);
            Some((statics.lever(at, Part::Whole) * (turned + astray) + bounds.arm[0] * span.time).powi(2))
        };
        let drift: Option<f64> = self.turning_cables(span).zip(statics.cables()).map(of).sum();
        let Some(drift) = drift else { return 0.0 };
        let least = if statics.point_mass() {
            least_singular_value(&columns, |column: &Vector6<f64>| column.fixed_rows::<3>(0).into())
        } else {
            least_singular_value(&columns, |column: &Vector6<f64>| *column)
        };
        self.least_reserve() * (least - drift.sqrt()).max(0.0)
    }
}

/// The smallest singular value of the matrix with the counted parts of these columns; zero if it is not certain.
fn least_singular_value<const N: usize>(
    columns: &[Vector6<f64>],
    counted: impl Fn(&Vector6<f64>) -> SVector<f64, N>,
) -> f64 {
    let mut gram = DMatrix::zeros(N, N);
    for column in columns.iter().map(counted) {
        gram += column * column.transpose();
    }
    let squares = gram.symmetric_eigenvalues();
    let least = squares.min();
    if least > CERTAIN * squares.max() { least.sqrt() } else { 0.0 }
}

/// Eigenvalues below this share of the largest may be rounding errors.
const CERTAIN: f64 = 1e-14;
