//! All shapes that a cable can take, as the scene defines them: which points bound it near a body. Every bound on the sag is taken a
//! little smaller than it is, so that rounding proves less.

use cdpr_core::geometry::Vector;
use cdpr_core::model::{Sag, Scene};

/// By how much a bound on the sag is lowered, as a share, and m: more than rounding errors, and far less than the margin.
const LOWERED: (f64, f64) = (1e-12, 1e-12);
/// The sag at an obstacle is bounded by its largest value there if the obstacle is farther from the exits than this multiple.
const NEAR: f64 = 2.0;
/// Where the distance and that multiple are this close, m, rounding might choose the wrong bound, and only the chord counts.
const TIE: f64 = 1e-9;

/// The shapes of one cable.
pub struct Hanging {
    /// Corners of the convex set of points where the cable can leave the frame.
    exits: Vec<Vector>,
    sag: Option<Sag>,
}

/// What bounds the shapes of a cable near an obstacle.
pub struct Near {
    /// Corners of the set where the cable leaves the frame.
    pub exits: Vec<Vector>,
    /// The attachment also counts moved by this.
    pub lowered: Vector,
    /// The obstacle also counts moved by this.
    pub raised: Vector,
}

impl Hanging {
    /// The shapes of a cable of a scene, by its index.
    pub fn of(scene: &Scene, cable: usize) -> Self {
        let outlet = scene.robot().cables()[cable].outlet.coords;
        match &scene.envelopes()[cable] {
            None => Hanging { exits: vec![outlet], sag: None },
            Some(envelope) => {
                Hanging { exits: envelope.exits.vertices().iter().map(|v| v.coords).collect(), sag: envelope.sag }
            }
        }
    }

    /// How much lower than its chord the cable can leave one end, at the other end.
    pub fn leaving(&self) -> Vector {
        self.sag.map_or(Vector::zeros(), |sag| -sag.up * little_less(sag.at_end()))
    }

    /// Points whose hull with the attachment contains all shapes of the cable.
    pub fn lowered_exits(&self) -> Vec<Vector> {
        with_copies(&self.exits, &self.leaving())
    }

    /// What bounds the cable near an obstacle part from which it must keep a gap, m.
    pub fn near(&self, part: &[Vector], gap: f64) -> Near {
        let bound = |lowered: Vector, raised: Vector| Near { exits: self.exits.clone(), lowered, raised };
        let Some(sag) = &self.sag else { return bound(Vector::zeros(), Vector::zeros()) };
        let whole = with_copies(part, &(sag.up * sag.deepest()));
        let near = boxes_apart(&self.exits, &whole) - gap;
        let reaches = self.exits.iter().flat_map(|exit| part.iter().map(move |v| (v - exit).norm()));
        let far = reaches.fold(0.0, f64::max) + sag.deepest() + gap;
        let deepest = sag.between([near, far]);
        let room = near - NEAR * deepest;
        if room.abs() <= TIE {
            bound(Vector::zeros(), Vector::zeros())
        } else if room > 0.0 {
            bound(Vector::zeros(), sag.up * little_less(deepest))
        } else {
            bound(self.leaving(), Vector::zeros())
        }
    }
}

fn little_less(bound: f64) -> f64 {
    (bound * (1.0 - LOWERED.0) - LOWERED.1).max(0.0)
}

/// The points and, unless `by` is zero, the same points moved by it.
pub fn with_copies(points: &[Vector], by: &Vector) -> Vec<Vector> {
    let copies = points.iter().filter(|_| *by != Vector::zeros()).map(|p| p + by);
    points.iter().copied().chain(copies).collect()
}

/// The distance of the boxes around two sets of points, m.
fn boxes_apart(a: &[Vector], b: &[Vector]) -> f64 {
    let least = |points: &[Vector]| points.iter().copied().reduce(|p, q| p.inf(&q)).expect("a body has corners");
    let most = |points: &[Vector]| points.iter().copied().reduce(|p, q| p.sup(&q)).expect("a body has corners");
    (least(a) - most(b)).sup(&(least(b) - most(a))).sup(&Vector::zeros()).norm()
}
