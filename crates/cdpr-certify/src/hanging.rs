//! All shapes that a cable can take, as the scene defines them: which points bound it near a body. Every bound on the sag is taken a
//! little smaller than it is, so that rounding proves less.

use cdpr_core::geometry::Vector;
use cdpr_core::model::{Sag, Scene};

/// By how much a bound on the sag is lowered, as a share, and m: more than rounding errors, and far less than the margin.
const LOWERED: (f64, f64) = (1e-12, 1e-12);
/// The exits count lowered if the obstacle is farther from them than this multiple of it; otherwise the attachment does.
const NEAR: f64 = 2.0;
/// Where the distance and that multiple are this close, m, rounding might choose the wrong bound, and only the chord counts.
const TIE: f64 = 1e-9;

/// The shapes of one cable.
pub struct Hanging {
    /// Corners of the convex set of points where the cable can leave the frame.
    exits: Vec<Vector>,
    sag: Option<Sag>,
    /// Corners of a box that contains all chords.
    chords: [Vector; 2],
}

/// What bounds the shapes of a cable near an obstacle.
pub struct Near {
    /// Corners of the set where the cable counts as leaving the frame.
    pub exits: Vec<Vector>,
    /// The attachment also counts moved by this.
    pub lowered: Vector,
}

impl Hanging {
    /// The shapes of a cable of a scene, by its index.
    pub fn of(scene: &Scene, cable: usize) -> Self {
        let outlet = scene.robot().cables()[cable].outlet.coords;
        match &scene.envelopes()[cable] {
            None => Hanging { exits: vec![outlet], sag: None, chords: [outlet; 2] },
            Some(envelope) => Hanging {
                exits: envelope.exits.iter().map(|v| v.coords).collect(),
                sag: envelope.sag,
                chords: [envelope.chords.min.coords, envelope.chords.max.coords],
            },
        }
    }

    /// Corners of the convex set of points where the cable can leave the frame.
    pub fn exits(&self) -> &[Vector] {
        &self.exits
    }

    /// How much lower than its chord the cable can leave one end, at the other end.
    pub fn leaving(&self) -> Vector {
        self.sag.map_or(Vector::zeros(), |sag| -sag.up * little_less(sag.lowering(sag.longest)))
    }

    /// Points whose hull with the attachment contains all shapes of the cable.
    pub fn lowered_exits(&self) -> Vec<Vector> {
        with_copies(&self.exits, &self.leaving())
    }

    /// What bounds the cable near an obstacle part from which it must keep a gap, m; if the obstacle carries its outlet, it leaves the
    /// frame there.
    pub fn near(&self, part: &[Vector], gap: f64, mounted: Option<Vector>) -> Near {
        let exits = mounted.map_or_else(|| self.exits.clone(), |outlet| vec![outlet]);
        let Some(sag) = &self.sag else { return Near { exits, lowered: Vector::zeros() } };
        let whole = with_copies(part, &(sag.up * sag.deepest()));
        let near = boxes_apart(&exits, &whole) - gap;
        let reaches = exits.iter().flat_map(|exit| part.iter().map(move |v| (v - exit).norm()));
        let reach = reaches.fold(0.0, f64::max) + sag.deepest() + gap;
        let ([low, high], [first, last]) = (corners(&whole), corners(&exits));
        let (low, high) = ((low.add_scalar(-gap)).sup(&self.chords[0]), (high.add_scalar(gap)).inf(&self.chords[1]));
        let fall = match (0..3).all(|axis| low[axis] <= high[axis]) {
            true => sag.lowering((high - first).sup(&(last - low)).norm().min(reach)),
            false => 0.0,
        };
        let room = near - NEAR * fall;
        if room.abs() <= TIE && mounted.is_none() {
            Near { exits, lowered: Vector::zeros() }
        } else if room > 0.0 && mounted.is_none() {
            Near { exits: with_copies(&exits, &(-sag.up * little_less(fall))), lowered: Vector::zeros() }
        } else {
            Near { exits, lowered: -sag.up * little_less(sag.lowering(sag.longest - near)) }
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
    let ([low, high], [first, last]) = (corners(a), corners(b));
    (low - last).sup(&(first - high)).sup(&Vector::zeros()).norm()
}

/// The lowest and the highest corner of the box around points.
fn corners(points: &[Vector]) -> [Vector; 2] {
    let least = points.iter().copied().reduce(|p, q| p.inf(&q)).expect("a body has corners");
    let most = points.iter().copied().reduce(|p, q| p.sup(&q)).expect("a body has corners");
    [least, most]
}
