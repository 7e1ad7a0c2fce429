//! Regions of positions in which the cables cannot exert a required wrench, by boxes with a direction each.
//!
//! In a box, the direction c of forces and moments is linear in the position p. With the vector l from the attachment of a cable to its
//! outlet, or to where it leaves its pulley at the centre of the box, q = c_f + c_m × arm and any r > 0, a unit of tension provides h = q·l / |l| = r q·l (1 + x)^(-1/2), where x = r² l² − 1. Up to
//! squares of x, the last factor is 1 − x/2 + 3x²/8, and the rest is at most 5/16 |x|³ / (1 − |x|)^(7/2). So h is a quadratic function
//! of p, up to a rest of third order; round a pulley, up to |q| times how much the cable's direction differs, too. The sum of max(t_min h, t_max h) must be less than c·w for a required wrench w, and may exceed it
//! where p is above the plane of the last half-space, by no more than a weight times the height.

use cdpr_core::Scene;
use cdpr_core::certificate::{Bounds, Region, WeakBox, WeakDirection};
use cdpr_core::error::Error;
use cdpr_core::geometry::Vector;
use cdpr_core::watch::Watch;

use crate::exact::{Exact, Exact3, cross, dot, exact, exact3, minus, nearest_square, plus, times, zeros};
use crate::forbidden::{Bodies, ROUNDING};
use crate::origins::{ABOVE, Origin};
use crate::polyhedron::{HalfSpace, Place};
use crate::question::{finite, positive};
use crate::tiling::{Tiling, middle};
use crate::wrench::requirement;

/// Largest |x| of a box.
const MOST_DEVIATION: f64 = 0.5;

/// A cable counts as pulling with its largest tension if what that provides at the centre is more than this share of the largest change
/// in the box.
const LEAN: f64 = 0.1;

/// Positions on paths from one end to another that are shorter than a length.
pub struct Reachable<'c> {
    /// Start and goal, m.
    pub ends: [&'c [f64; 3]; 2],
    /// The length, m.
    pub length: f64,
}

/// A function of the offset from the centre of a box, in half sides: a quadratic one, and a rest.
#[derive(Clone)]
struct Function {
    at_center: Exact,
    slope: Exact3,
    /// The coefficients of the products of two coordinates, a ≤ b.
    curve: [[Exact; 3]; 3],
    rest: Exact,
}

/// A direction [force, moment] at the centre of a box, and its changes over half sides.
struct Direction {
    at_center: [Exact3; 2],
    changes: [[Exact3; 2]; 3],
}

/// Fails unless the boxes of a region, with these corners in the box of positions, prove that wrenches lack at all of its positions that
/// are reachable.
///
/// # Errors
/// What is not proved; a scene without such a requirement, or with one that some direction does not concern;
/// [`Error::interrupted`], [`Error::out_of_time`].
pub fn all_lack(
    scene: &Scene,
    bodies: &Bodies,
    (region, corners): (&Region, &[Place]),
    reachable: &Reachable,
    watch: &Watch,
) -> Result<(), Error> {
    cover(&region.boxes, corners)?;
    let plane = region.half_spaces.last().ok_or_else(|| Error::invalid("half_spaces", "found none, expected some"))?;
    for (k, weak) in region.boxes.iter().enumerate() {
        watch.check()?;
        let place = format!("boxes[{k}]");
        let (is_proved, found) = match &weak.direction {
            None => (is_beyond(weak, plane, reachable), "found no direction, and positions that count"),
            Some(direction) => (
                lacks(scene, bodies, (weak, direction), plane).map_err(|e| e.under(&place))?,
                "found no proof that the cables are too weak in this direction",
            ),
        };
        if !is_proved {
            return Err(Error::invalid(place, format!("{found}; expected a proof")));
        }
    }
    Ok(())
}

/// Fails unless boxes tile a box that contains some positions.
fn cover(boxes: &[WeakBox], positions: &[Place]) -> Result<(), Error> {
    let tiles: Vec<Bounds> = boxes.iter().map(|weak| weak.bounds).collect();
    let Some(mut whole) = tiles.first().copied() else {
        return Err(Error::invalid("boxes", "found none, expected boxes that show that wrenches lack"));
    };
    for (k, tile) in tiles.iter().enumerate() {
        positive(&format!("boxes[{k}]"), tile)?;
        for axis in 0..3 {
            whole[0][axis] = whole[0][axis].min(tile[0][axis]);
            whole[1][axis] = whole[1][axis].max(tile[1][axis]);
        }
    }
    let [low, high] = whole.map(|corner| exact3(&corner.into()));
    let is_inside =
        |place: &Place| (0..3).all(|k| &low[k] * &place.scale <= place.at[k] && place.at[k] <= &high[k] * &place.scale);
    if let Some(outside) = positions.iter().find(|place| !is_inside(place)) {
        let p = outside.to_f64();
        let problem = format!("found the position {:?} of the region in none, expected all in them", [p.x, p.y, p.z]);
        return Err(Error::invalid("boxes", problem));
    }
    Tiling::of(&whole, &tiles)?;
    Ok(())
}

/// Whether a box is beyond the plane, or too far from both ends.
fn is_beyond(weak: &WeakBox, plane: &[f64; 4], reachable: &Reachable) -> bool {
    let [low, high] = weak.bounds.map(|corner| exact3(&corner.into()));
    let opposite = HalfSpace::of(&plane.map(|x| -x));
    let distance = |end: &[f64; 3]| {
        let end = exact3(&(*end).into());
        nearest_square(&minus(&low, &end), &minus(&high, &end)).root_below()
    };
    let [from, to] = reachable.ends.map(distance);
    opposite.contains(&[low, high]) || from + to >= exact(reachable.length)
}

/// Whether it is proved that the cables are too weak in a direction at all positions of a box below a plane.
fn lacks(
    scene: &Scene,
    bodies: &Bodies,
    (weak, given): (&WeakBox, &WeakDirection),
    plane: &[f64; 4],
) -> Result<bool, Error> {
    finite("", &given.at_center)?;
    finite("", given.slopes.as_flattened())?;
    finite("", &[given.weight])?;
    if given.weight < 0.0 {
        return Err(Error::invalid("", format!("found the weight {}, expected one of at least 0", given.weight)));
    }
    let center = middle(&weak.bounds);
    // Positions this far outside of the box of positions count, too.
    let half: Exact3 = std::array::from_fn(|k| {
        let [below, above] = [exact(center[k]) - exact(weak.bounds[0][k]), exact(weak.bounds[1][k]) - exact(center[k])];
        exact(ROUNDING) + if below > above { below } else { above }
    });
    let parts = |row: &[f64; 6]| [0, 3].map(|k| exact3(&Vector::from_column_slice(&row[k..k + 3])));
    let direction = Direction {
        at_center: parts(&given.at_center),
        changes: std::array::from_fn(|a| parts(&given.slopes[a]).map(|change| times(&half[a], &change))),
    };
    let has = |part: usize| {
        let all = direction.changes.iter().chain([&direction.at_center]);
        all.flat_map(|of| &of[part]).any(|x| !x.sign().is_eq())
    };
    let requirement = requirement(scene, bodies, [has(0), has(1)])?;
    let required = requirement.corner(&direction.at_center);
    let mut lack = Function::zero();
    let Some(radius) = dot(&half, &half).root_above().map(|radius| radius.to_f64() * ABOVE) else { return Ok(false) };
    for ((k, arm), [least, largest]) in bodies.arms.iter().enumerate().zip(&requirement.tensions) {
        let attachment = center + arm;
        let origin = Origin::of(scene, k, &attachment, radius);
        let line = (
            minus(&minus(&exact3(&origin.middle), &exact3(arm)), &exact3(&center)),
            1.0 / (origin.middle - attachment).norm(),
        );
        let arm = exact3(arm);
        let (Some(mut height), Some(most), Some(off)) =
            (height(&direction, &arm, line, &half), direction.largest(&arm), origin.astray(&attachment, radius))
        else {
            return Ok(false);
        };
        height.rest = height.rest + most * off;
        lack.pull([*least, *largest], &height);
    }
    let demand = |of: &[Exact3; 2]| dot(&of[0], &required[0]) + dot(&of[1], &required[1]);
    let [x, y, z, offset] = *plane;
    let normal = exact3(&Vector::new(x, y, z));
    let weight = exact(given.weight);
    let above = dot(&normal, &exact3(&center)) - exact(offset) - exact(2.0 * ROUNDING);
    lack.at_center = lack.at_center - demand(&direction.at_center) - &weight * &above;
    for a in 0..3 {
        let rise = &weight * &(&normal[a] * &half[a]);
        lack.slope[a] = &lack.slope[a] - &demand(&direction.changes[a]) - rise;
    }
    Ok(lack.greatest().sign().is_lt())
}

impl Direction {
    /// The most that a unit of tension can provide in it anywhere in the box; `None` beyond the range of `f64`.
    fn largest(&self, arm: &Exact3) -> Option<Exact> {
        let size = |of: &[Exact3; 2]| {
            let q = plus(&of[0], &cross(&of[1], arm));
            dot(&q, &q).root_above()
        };
        self.changes.iter().chain([&self.at_center]).map(size).sum()
    }
}

fn reach<'e>(coefficients: impl Iterator<Item = &'e Exact>) -> Exact {
    coefficients.map(Exact::abs).sum()
}

impl Function {
    fn zero() -> Self {
        Function { at_center: exact(0.0), slope: zeros(), curve: [zeros(), zeros(), zeros()], rest: exact(0.0) }
    }

    fn add(&mut self, factor: &Exact, other: &Function) {
        self.at_center = &self.at_center + factor * &other.at_center;
        for a in 0..3 {
            self.slope[a] = &self.slope[a] + factor * &other.slope[a];
            for b in a..3 {
                self.curve[a][b] = &self.curve[a][b] + factor * &other.curve[a][b];
            }
        }
        self.rest = &self.rest + factor.abs() * &other.rest;
    }

    /// Adds the most that a cable provides within its limits of tension, from what a unit of tension provides.
    fn pull(&mut self, [least, largest]: [f64; 2], height: &Function) {
        let way = reach(height.slope.iter()) + reach(height.curve.iter().flatten()) + &height.rest;
        let is_tight = height.at_center > exact(LEAN) * &way;
        self.add(&exact(if is_tight { largest } else { least }), height);
        // Where the other limit provides more, it does so by at most the height times the difference.
        let other = if is_tight { way - &height.at_center } else { way + &height.at_center };
        if other.sign().is_gt() {
            self.rest = &self.rest + (exact(largest) - exact(least)) * other;
        }
    }

    /// A bound of the function in the whole box: a square is at most its coefficient, or nothing; a product of two coordinates has
    /// either sign.
    fn greatest(&self) -> Exact {
        let squares = (0..3).map(|a| &self.curve[a][a]).filter(|square| square.sign().is_gt()).cloned();
        let mixed = [[0, 1], [0, 2], [1, 2]].map(|[a, b]| self.curve[a][b].abs());
        &self.at_center
            + reach(self.slope.iter())
            + squares.sum::<Exact>()
            + mixed.into_iter().sum::<Exact>()
            + &self.rest
    }
}

/// What a unit of tension of a cable provides in a direction, over a box around the place where the vector from the attachment to the
/// outlet is the given one. With it comes r, which may be any number; about the reciprocal of the length is best. `None` if the cable comes
/// close to its outlet.
fn height(direction: &Direction, arm: &Exact3, (line, r): (Exact3, f64), half: &Exact3) -> Option<Function> {
    if !(r > 0.0 && r.is_finite()) {
        return None;
    }
    let r = exact(r);
    let pull = |of: &[Exact3; 2]| plus(&of[0], &cross(&of[1], arm));
    let q = pull(&direction.at_center);
    let changes: [Exact3; 3] = std::array::from_fn(|a| pull(&direction.changes[a]));
    // q·l, where l = line − offset.
    let n0 = dot(&q, &line);
    let n1: Exact3 = std::array::from_fn(|a| dot(&changes[a], &line) - &half[a] * &q[a]);
    let n2: [[Exact; 3]; 3] = std::array::from_fn(|a| {
        std::array::from_fn(|b| {
            let one = &half[b] * &changes[a][b];
            match a.cmp(&b) {
                std::cmp::Ordering::Less => -&(one + &half[a] * &changes[b][a]),
                std::cmp::Ordering::Equal => -&one,
                std::cmp::Ordering::Greater => exact(0.0),
            }
        })
    });
    // x = x0 + x1 + x2.
    let r2 = &r * &r;
    let x0 = &r2 * &dot(&line, &line) - exact(1.0);
    let x1: Exact3 = std::array::from_fn(|a| exact(-2.0) * &r2 * &line[a] * &half[a]);
    let x2: Exact3 = std::array::from_fn(|a| &r2 * &(&half[a] * &half[a]));
    let (first, second) = (reach(x1.iter()), x2.iter().cloned().sum::<Exact>());
    let changed = &first + &second;
    let most = x0.abs() + &changed;
    if most > exact(MOST_DEVIATION) {
        return None;
    }
    // The factor is p0 + p1 (x1 + x2) + p2 (x1 + x2)², and the rest of the series.
    let p2 = exact(0.375);
    let p1 = exact(-0.5) + exact(0.75) * &x0;
    let p0 = exact(1.0) - exact(0.5) * &x0 + &p2 * &(&x0 * &x0);
    let series = series_rest(&most)?;
    let slope: Exact3 = std::array::from_fn(|a| &p0 * &n1[a] + &p1 * &n0 * &x1[a]);
    let curve: [[Exact; 3]; 3] = std::array::from_fn(|a| {
        std::array::from_fn(|b| {
            let square = &p2 * &n0 * &x1[a] * &x1[b];
            let steep = |a: usize, b: usize| &p1 * &n1[a] * &x1[b];
            match a.cmp(&b) {
                std::cmp::Ordering::Less => &p0 * &n2[a][b] + exact(2.0) * square + steep(a, b) + steep(b, a),
                std::cmp::Ordering::Equal => &p0 * &n2[a][a] + &p1 * &n0 * &x2[a] + square + steep(a, a),
                std::cmp::Ordering::Greater => exact(0.0),
            }
        })
    });
    let (r1, r2) = (reach(n1.iter()), reach(n2.iter().flatten()));
    let squared = &p2 * &(&changed * &changed);
    let rest = n0.abs() * (&p2 * &second * (exact(2.0) * &first + &second))
        + &r1 * &(p1.abs() * &second + &squared)
        + &r2 * &(p1.abs() * &changed + &squared)
        + (n0.abs() + &r1 + &r2) * series;
    let mut found = Function::zero();
    found.add(&r, &Function { at_center: p0 * n0, slope, curve, rest });
    Some(found)
}

/// The most by which 1 − x/2 + 3x²/8 differs from (1 + x)^(-1/2), for |x| up to a number below 1.
fn series_rest(most: &Exact) -> Option<Exact> {
    let left = exact(1.0) - most;
    let cubes = exact(0.3125) * most * most * most;
    cubes.quotient_above(&(&left * &left * &left * &left))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers from -1 to 1 that look random.
    struct Draw(u64);

    impl Draw {
        fn number(&mut self) -> f64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        }

        fn vector(&mut self) -> Vector {
            Vector::from_fn(|_, _| self.number())
        }
    }

    fn value(f: &Function, t: &Vector) -> f64 {
        let curved = |a: usize, b: usize| f.curve[a][b].to_f64() * t[a] * t[b];
        let pairs = (0..3).flat_map(|a| (a..3).map(move |b| (a, b)));
        f.at_center.to_f64()
            + (0..3).map(|a| f.slope[a].to_f64() * t[a]).sum::<f64>()
            + pairs.map(|(a, b)| curved(a, b)).sum::<f64>()
    }

    /// Corners, sides and centres of sides of a box, in half sides.
    fn offsets() -> impl Iterator<Item = Vector> {
        (0..27).map(|k| Vector::new(f64::from(k % 3) - 1.0, f64::from(k / 3 % 3) - 1.0, f64::from(k / 9) - 1.0))
    }

    fn function(draw: &mut Draw) -> Function {
        let mut number = |zero: bool| exact(if zero { 0.0 } else { draw.number() });
        let kinds: [bool; 4] = std::array::from_fn(|_| number(false).sign().is_lt());
        Function {
            at_center: number(kinds[0]),
            slope: std::array::from_fn(|_| number(kinds[1])),
            curve: std::array::from_fn(|a| std::array::from_fn(|b| number(b < a || kinds[if a == b { 2 } else { 3 }]))),
            rest: number(kinds[0]).abs(),
        }
    }

    #[test]
    fn no_value_of_a_function_exceeds_its_bound_and_some_reach_it() {
        let mut draw = Draw(2);
        let (mut reached, mut pulled) = (0, 0);
        for _ in 0..2000 {
            let mut found = function(&mut draw);
            let most =
                |f: &Function| offsets().map(|t| value(f, &t) + f.rest.to_f64()).fold(f64::NEG_INFINITY, f64::max);
            let (greatest, seen) = (found.greatest().to_f64(), most(&found));
            assert!(seen <= greatest + 1e-12, "{seen} {greatest}");
            reached += usize::from(seen > greatest - 1e-12);
            // The most within limits of tension, wherever the rest is.
            let (before, height) = (found.clone(), function(&mut draw));
            let limits = [0.5, 0.5 + draw.number().abs()];
            found.pull(limits, &height);
            let rest = height.rest.to_f64();
            let most = |h: f64| limits.iter().map(|limit| limit * h).fold(f64::NEG_INFINITY, f64::max);
            for t in offsets() {
                for off in [-rest, rest] {
                    let truly = value(&before, &t) + before.rest.to_f64() + most(value(&height, &t) + off);
                    let bound = value(&found, &t) + found.rest.to_f64();
                    assert!(truly <= bound + 1e-12, "{truly} {bound}");
                    pulled += usize::from(truly > bound - 1e-12);
                }
            }
        }
        assert!(reached > 100 && pulled > 100, "{reached} {pulled}");
    }

    #[test]
    fn the_rest_of_the_series_is_bounded_and_hardly_smaller() {
        for most in [1e-3, 0.01, 0.1, 0.3, 0.5] {
            let bound = series_rest(&exact(most)).unwrap().to_f64();
            let off = |x: f64| ((1.0 + x).powf(-0.5) - (1.0 - 0.5 * x + 0.375 * x * x)).abs();
            assert!(off(most) <= bound && off(-most) <= bound, "{most}");
            assert!(most > 0.01 || off(-most) > 0.95 * bound, "{most}: {} {bound}", off(-most));
        }
    }

    #[test]
    fn what_a_cable_provides_is_within_its_rest_and_often_near_it() {
        let mut draw = Draw(1);
        let mut shares = [0.0f64; 4];
        for round in 0..1200 {
            let line = draw.vector().normalize();
            let size = [0.02, 0.1, 0.2][round % 3];
            // Boxes long in one direction, along the cable or across it, or in no direction.
            let mut half = size * Vector::repeat(0.2 + draw.number().abs());
            if round % 5 < 3 {
                let long = half[round % 5];
                half = Vector::repeat(1e-6);
                half[round % 5] = long;
            }
            let kind = round / 3 % 4;
            // Directions that are constant, along the cable or not; that change; that are zero at the centre.
            let q = match kind {
                0 => line,
                1 | 2 => draw.vector(),
                _ => Vector::zeros(),
            };
            let mut changes = [Vector::zeros(); 3];
            if kind >= 2 {
                changes = [0; 3].map(|_| draw.vector());
            }
            if kind == 3 {
                // What is left is quadratic.
                changes = changes.map(|change| change - line * change.dot(&line));
            }
            let direction = Direction {
                at_center: [exact3(&q), zeros()],
                changes: changes.map(|change| [exact3(&change), zeros()]),
            };
            let Some(found) = height(&direction, &zeros(), (exact3(&line), 1.0), &exact3(&half)) else { continue };
            let rest = found.rest.to_f64();
            for t in offsets() {
                let l = line - half.component_mul(&t);
                let turned = q + changes[0] * t.x + changes[1] * t.y + changes[2] * t.z;
                let off = (turned.dot(&l) / l.norm() - value(&found, &t)).abs();
                assert!(off <= rest + 1e-14, "round {round}: {off} {rest}");
                if rest > 1e-9 {
                    shares[kind] = shares[kind].max(off / rest);
                }
            }
        }
        assert!(shares.iter().all(|share| *share > 0.3), "{shares:?}");
    }
}
