//! Boxes of positions in which the cables cannot exert a required wrench.

use cdpr_core::certificate::Bounds;
use cdpr_core::error::Error;
use cdpr_core::geometry::Vector;
use cdpr_core::model::{Cable, MarginSpec, RuleSpec, Scene, WrenchSpec};

use crate::exact::{Exact, Exact3, cross, dot, exact, exact3, minus, nearest_square, plus, times, zeros};
use crate::forbidden::{Bodies, SAME_END};
use crate::origins::{ABOVE, Origin};
use crate::tiling::middle;

/// Whether it is proved for every position in a box that the cables fall short of a required wrench in the direction
/// `[c_f; c_m]` of forces and moments: sum of max(t_min h, t_max h) < c·w, with h = c_f·u + c_m·(arm × u) = q·u,
/// q = c_f + c_m × arm, for the unit vector u from the attachment to the outlet of each cable, or to where it can leave its pulley.
///
/// # Errors
/// A scene without such a requirement, or with one that this direction does not concern.
pub fn too_weak(scene: &Scene, bodies: &Bodies, direction: &[f64; 6], cell: &Bounds) -> Result<bool, Error> {
    let [force, moment] = [0, 3].map(|k| exact3(&Vector::from_column_slice(&direction[k..k + 3])));
    let has = [&force, &moment].map(|part| part.iter().any(|x| !x.sign().is_eq()));
    let requirement = requirement(scene, bodies, has)?;
    let demand = requirement.demand(&force, &moment);
    let center = middle(cell);
    let (low, high) = (exact3(&cell[0].into()), exact3(&cell[1].into()));
    // The larger of the distances from the middle to the two faces, along each axis.
    let [below, above] = [minus(&exact3(&center), &low), minus(&high, &exact3(&center))];
    let half: Exact3 = std::array::from_fn(|k| if below[k] > above[k] { below[k].clone() } else { above[k].clone() });
    let Some(radius) = dot(&half, &half).root_above() else { return Ok(false) };
    let mut supply = exact(0.0);
    for ((k, [least, largest]), arm) in requirement.tensions.iter().enumerate().zip(&bodies.arms) {
        let Origin { middle, spread } = Origin::of(scene, k, &(center + arm), radius.to_f64() * ABOVE);
        let arm = exact3(arm);
        let pull = plus(&force, &cross(&moment, &arm));
        let line = minus(&minus(&exact3(&middle), &arm), &exact3(&center));
        let reach = &radius + exact(spread);
        let Some(height) = largest_height(&pull, &line, &(&reach * &reach)) else { return Ok(false) };
        let tension = if height.sign().is_gt() { largest } else { least };
        supply = supply + exact(*tension) * height;
    }
    Ok(supply < demand)
}

fn refused<T>(found: &str) -> Result<T, Error> {
    let problem = format!("found the reason \"wrench\" for {found}; it proves nothing there");
    Err(Error::invalid("", problem))
}

/// What a scene requires of its cables.
pub struct Requirement<'s> {
    spec: &'s WrenchSpec,
    /// The weight of the platform, without and with payload, as force and moment.
    weights: [[Exact3; 2]; 2],
    /// The limits as they are given, not as they count: a limit that stands for none closes nothing.
    pub tensions: Vec<[f64; 2]>,
}

/// What a scene requires, for directions that have forces or moments.
///
/// # Errors
/// A scene without such a requirement, or with one that such directions do not concern.
pub fn requirement<'s>(
    scene: &'s Scene,
    bodies: &Bodies,
    [has_force, has_moment]: [bool; 2],
) -> Result<Requirement<'s>, Error> {
    let robot = scene.robot();
    let Some(spec) = scene.wrench() else { return refused("a scene without requirements on wrenches") };
    let Some(mass) = robot.mass() else { return refused("a robot without mass") };
    if spec.rule == Some(RuleSpec::Grid) {
        return refused("the rule \"grid\", which looks at some positions only");
    }
    if spec.margin == Some(MarginSpec::Projected) && has_force && has_moment {
        return refused("the margin \"projected\", with a direction of both forces and moments");
    }
    if bodies.arms.iter().all(|arm| (arm - bodies.arms[0]).norm() <= SAME_END) && has_moment {
        return refused("cables that meet in one point, with a direction of moments");
    }
    let Some(tensions) = robot.spec().cables.iter().map(|cable| cable.tension).collect() else {
        return refused("a cable without tension limits");
    };
    let to_center = exact3(&(scene.orientation() * robot.center_of_mass().coords));
    let weights = [0.0, spec.payload.unwrap_or(0.0)].map(|payload| {
        let weight = times(&(exact(mass) + exact(payload)), &exact3(&scene.gravity()));
        let moment = cross(&to_center, &weight);
        [weight, moment]
    });
    Ok(Requirement { spec, weights, tensions })
}

impl Requirement<'_> {
    /// The required wrench that is largest in a direction, or a little less: what the cables have to exert at least there.
    pub fn corner(&self, direction: &[Exact3; 2]) -> [Exact3; 2] {
        let spec = self.spec;
        let largest = |all: Vec<[Exact3; 2]>| {
            let height = |w: &[Exact3; 2]| dot(&direction[0], &w[0]) + dot(&direction[1], &w[1]);
            all.into_iter().reduce(|a, b| if height(&b) > height(&a) { b } else { a }).unwrap_or([zeros(), zeros()])
        };
        let parts = |w: &[f64; 6], sign: f64| [0, 3].map(|k| exact3(&(sign * Vector::from_column_slice(&w[k..k + 3]))));
        let beyond = match &spec.vertices {
            Some(vertices) => vertices.iter().map(|w| parts(w, 1.0)).collect(),
            None => vec![[along(spec.force, &direction[0]), along(spec.moment, &direction[1])]],
        };
        // What loads and weight leave to the cables.
        let single = [spec.load.unwrap_or_default()];
        let loads = spec.loads.as_deref().unwrap_or(&single).iter().map(|load| parts(load, -1.0)).collect();
        let weights = self.weights.iter().map(|[force, moment]| [force, moment].map(|part| minus(&zeros(), part)));
        let sum = |a: [Exact3; 2], b: [Exact3; 2]| [plus(&a[0], &b[0]), plus(&a[1], &b[1])];
        sum(sum(largest(beyond), largest(loads)), largest(weights.collect()))
    }

    /// The largest c·w over the required wrenches w, or a little less.
    fn demand(&self, force: &Exact3, moment: &Exact3) -> Exact {
        let worst = self.corner(&[force.clone(), moment.clone()]);
        dot(force, &worst[0]) + dot(moment, &worst[1])
    }
}

/// A vector along another one, of at most a length.
fn along(length: Option<f64>, direction: &Exact3) -> Exact3 {
    let rough = Vector::from_fn(|k, _| direction[k].to_f64());
    let unit = rough.try_normalize(0.0).filter(|unit| unit.iter().all(|x| x.is_finite())).unwrap_or_default();
    let unit = exact3(&(unit * (1.0 - SHORTER)));
    if dot(&unit, &unit) <= exact(1.0) { times(&exact(length.unwrap_or(0.0)), &unit) } else { zeros() }
}

/// Unit vectors are made shorter by this share, so that they are no longer than 1.
const SHORTER: f64 = 1e-15;

/// An upper bound of q·l / |l| over all l within a distance of a vector, given its square: |q| cos(angle between q and
/// the vector, less the angle at which the distance is seen). `None` beyond the range of `f64`.
///
/// With the vector d, the distance r and cos a = sqrt(d² - r²) / |d|, sin a = r / |d|: if q is in the cone of all l, or
/// zero is among them, the bound is |q|; otherwise it is (q·d sqrt(d² - r²) + |q × d| r) / d².
fn largest_height(q: &Exact3, d: &Exact3, r2: &Exact) -> Option<Exact> {
    let (along, across, d2) = (dot(q, d), cross(q, d), dot(d, d));
    let rest = &d2 - r2;
    let in_cone = along.sign().is_gt() && &along * &along >= dot(q, q) * &rest;
    if rest.sign().is_le() || in_cone {
        return dot(q, q).root_above();
    }
    let root = if along.sign().is_gt() { rest.root_above()? } else { rest.root_below() };
    let bound = along * root + (dot(&across, &across) * r2).root_above()?;
    bound.quotient_above(&d2)
}

/// Whether it is proved that a cable breaks its limits of length, up to `margin`, at every position in a box: it is too
/// short at all corners (where a distance is largest), or too long at the nearest point of the box. Round a pulley, it is longer than
/// the straight line from the outlet by at most [`DETOUR`] radii.
pub fn wrong_length(cable: &Cable, arm: &Vector, cell: &Bounds, margin: &Exact) -> bool {
    is_straight_line_outside(cable, arm, cell, margin, [detour(cable), exact(0.0)])
}

/// Whether a cable is at a limit of its length, up to `margin`, at a position, or may be, if it runs round a pulley.
pub fn may_be_at_limit(cable: &Cable, arm: &Vector, at: &[f64; 3], margin: &Exact) -> bool {
    is_straight_line_outside(cable, arm, &[*at, *at], margin, [exact(0.0), detour(cable)])
}

/// How much longer than the straight line from the outlet a cable can be, m.
fn detour(cable: &Cable) -> Exact {
    cable.pulley.map_or(exact(0.0), |pulley| exact(DETOUR) * exact(pulley.radius))
}

/// Whether the straight line from the outlet is shorter or longer than the limits of the cable's length at every position in a box, by
/// less than `margin` and more than the two numbers `by`, m.
fn is_straight_line_outside(cable: &Cable, arm: &Vector, cell: &Bounds, margin: &Exact, by: [Exact; 2]) -> bool {
    let [shorter, longer] = by;
    let limits = cable.length;
    let hook = minus(&exact3(&cable.outlet.coords), &exact3(arm));
    let (low, high) = (minus(&exact3(&cell[0].into()), &hook), minus(&exact3(&cell[1].into()), &hook));
    let farther = |k: usize| if low[k].abs() > high[k].abs() { &low[k] } else { &high[k] };
    let far = (0..3).map(|k| farther(k) * farther(k)).sum::<Exact>();
    let near = nearest_square(&low, &high);
    let short = exact(limits.map_or(0.0, |[least, _]| least).max(SHORTEST)) + margin - shorter;
    let long = limits.map(|[_, most]| exact(most) - margin - longer);
    short.sign().is_ge() && far <= &short * &short
        || long.is_some_and(|long| long.sign().is_le() || near >= &long * &long)
}

/// A shorter cable has no direction, m.
const SHORTEST: f64 = 1e-7;
/// A little more than half a turn and the width of a wheel: π + 2, in radii.
const DETOUR: f64 = 5.141_592_654;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_vector_near_another_exceeds_the_largest_height() {
        let spiral = |k: usize, turns: f64| {
            let (angle, z) = (turns * k as f64, 1.0 - (2 * k + 1) as f64 / 400.0);
            let across = (1.0 - z * z).sqrt();
            Vector::new(across * angle.cos(), across * angle.sin(), z)
        };
        let d = Vector::new(0.5, -0.3, 2.0);
        for radius in [0.0, 0.1, 0.7, 2.0, 2.2] {
            for q in (0..400).map(|k| 3.0 * spiral(k, 2.4)) {
                let largest = largest_height(&exact3(&q), &exact3(&d), &exact(radius * radius)).unwrap().to_f64();
                let seen = (0..400).map(|k| q.dot(&(d + radius * spiral(k, 0.618)).normalize())).fold(-3.0, f64::max);
                assert!(seen <= largest + 1e-12 && largest <= 3.0 + 1e-12, "{radius} {q} {seen} {largest}");
                assert!(radius > 2.0 || largest <= seen + 0.1 * radius + 1e-12, "{radius} {q} {seen} {largest}");
            }
        }
    }
}
