//! The boxes by which a certificate shows that wrenches lack in a polyhedron.
//!
//! In each box, the cables are too weak in some direction of forces and moments. The direction is linear in the position, near the
//! normal of a facet of the available set, which turns with the position: what it then misses is of second order in the box.

use super::free_edges::Ellipsoid;
use super::lacking::lowered;
use crate::certificate::{WeakBox, WeakDirection};
use crate::collision::Checker;
use crate::error::Error;
use crate::geometry::quadratic::{add, product, reach};
use crate::geometry::{Cuboid, HalfSpace, Point, Quadratic, Vector};
use crate::limits::MOST_WEAK_BOXES;
use crate::model::{RuleSpec, Scene};
use crate::tolerances::WEAK_RESERVE;
use crate::watch::Watch;
use crate::wrench::{StaticCable, Statics};

/// Forces and moments.
type Wrench = [f64; 6];

/// Distance over which the change of a direction is measured, as a share of the size of the box.
const STEP: f64 = 1e-3;
/// A direction that changes by more than this share of itself in a box is taken to be that of another facet.
const MOST_TURN: f64 = 1.0;
/// A cable counts as pulling with its largest tension if what that provides at the centre is more than this share of the largest change
/// in the box. Where a cable spans the facet, it is zero up to rounding, and checkers have to decide alike.
const LEAN: f64 = 0.1;
/// Boxes that are further than this outside of what has to be proved need no proof, m.
const CLEAR: f64 = 1e-9;
/// The directions to points of a box deviate little enough from the direction to its centre if the squares of their distances deviate by
/// at most this share.
const MOST_DEVIATION: f64 = 0.5;

/// Finds boxes that prove what cables lack.
pub struct Weakness<'s> {
    checker: &'s dyn Checker,
    /// With the limits of tension as they are given.
    cables: Vec<StaticCable>,
    /// The required wrenches without the radii of the required forces and moments: what loads and weight leave to the cables.
    required: Vec<Wrench>,
    radii: [f64; 2],
}

/// A direction that is linear in the position: at the centre of a box, and its changes over half sides of the box.
struct Turning {
    center: [Vector; 2],
    changes: [[Vector; 2]; 3],
}

impl<'s> Weakness<'s> {
    /// What the scene of an engine requires of its cables; `None` if checkers of certificates do not know it.
    pub fn new(checker: &'s dyn Checker, scene: &Scene) -> Option<Self> {
        let spec = scene.wrench().filter(|spec| spec.rule != Some(RuleSpec::Grid))?;
        let robot = scene.robot();
        let mass = robot.mass()?;
        let (statics, given) = (Statics::of(scene).ok()?, robot.spec().cables.iter().map(|cable| cable.tension));
        let with =
            |(cable, tension): (&StaticCable, Option<_>)| Some(StaticCable { tension: tension?, ..cable.clone() });
        let cables = statics.cables().iter().zip(given).map(with).collect::<Option<Vec<_>>>()?;
        let arm = scene.orientation() * robot.center_of_mass().coords;
        let single = [spec.load.unwrap_or_default()];
        let (loads, vertices) = (spec.loads.as_deref().unwrap_or(&single), spec.vertices.as_deref());
        let mut required = Vec::new();
        for payload in [0.0, spec.payload.unwrap_or(0.0)] {
            let weight = scene.gravity() * (mass + payload);
            let moment = arm.cross(&weight);
            for load in loads {
                for beyond in vertices.unwrap_or(&[[0.0; 6]]) {
                    let weight = [weight.x, weight.y, weight.z, moment.x, moment.y, moment.z];
                    required.push(std::array::from_fn(|k| beyond[k] - load[k] - weight[k]));
                }
            }
        }
        let radii = [spec.force, spec.moment].map(|radius| radius.filter(|_| vertices.is_none()).unwrap_or(0.0));
        Some(Weakness { checker, cables, required, radii })
    }

    /// Boxes that tile a box and prove that wrenches lack in the part of it that is below a plane and within an ellipsoid; `None` if
    /// that is not proved by boxes of at least about half a size, m.
    ///
    /// # Errors
    /// [`Error::interrupted`], [`Error::out_of_time`].
    pub fn boxes(
        &self,
        positions: &Cuboid,
        (plane, least): (&HalfSpace, f64),
        within: &Ellipsoid,
        watch: &Watch,
    ) -> Result<Option<Vec<WeakBox>>, Error> {
        let (mut found, mut open) = (Vec::new(), vec![*positions]);
        while let Some(positions) = open.pop() {
            watch.check()?;
            let bounds = [positions.low.into(), positions.high.into()];
            let distance = |end: &Point| (positions.nearest_to(end) - end).norm();
            let is_outside = positions.lowest(plane) > CLEAR
                || distance(&within.start) + distance(&within.goal) > within.length + CLEAR;
            if is_outside {
                found.push(WeakBox { bounds, direction: None });
                continue;
            }
            let place = self.place(&positions, plane);
            match self.at(place) {
                None if plane.height(&place) < 0.0 && within.via(&place) < within.length => return Ok(None),
                None => {}
                Some(here) => {
                    let direction = self.direction(&positions, plane, (place, here));
                    if direction.is_some() {
                        found.push(WeakBox { bounds, direction });
                        continue;
                    }
                }
            }
            if positions.half.max() < least || found.len() + open.len() >= MOST_WEAK_BOXES {
                return Ok(None);
            }
            open.extend(halves(&positions));
        }
        Ok(Some(found))
    }

    /// The position of a box below a plane that is nearest to its centre; it may be above the plane if the plane cuts only a corner off.
    fn place(&self, positions: &Cuboid, plane: &HalfSpace) -> Point {
        let above = plane.height(&positions.center) + CLEAR;
        positions.nearest_to(&(positions.center - plane.normal * above.max(0.0)))
    }

    /// The direction in which most lacks at a position.
    fn at(&self, place: Point) -> Option<Wrench> {
        self.checker.lacking_wrench(&Cuboid::new(place, place))
    }

    /// A direction in which the cables are too weak in the part of a box below a plane.
    fn direction(
        &self,
        positions: &Cuboid,
        plane: &HalfSpace,
        (place, here): (Point, Wrench),
    ) -> Option<WeakDirection> {
        let turning = self.turning(positions, (place, here));
        let (lack, size) = self.lack(positions, &turning)?;
        // As checkers bound it, which is a little more than `Quadratic::greatest`.
        let most = |less: &Quadratic| {
            let squares = less.curve[..3].iter().map(|square| square.max(0.0)).sum::<f64>();
            less.at_center + reach(&less.slope) + squares + reach(&less.curve[3..]) + less.above
        };
        let reserve = |weight: f64| WEAK_RESERVE * (size + weight * positions.half.norm());
        // Far below the plane, the height counts for nothing.
        let mut each = std::iter::once((0.0, lack)).chain(lowered(&lack, positions, plane));
        let (weight, _) = each.find(|(weight, less)| most(less) < -reserve(*weight))?;
        let flat = |[force, moment]: [Vector; 2]| [force.x, force.y, force.z, moment.x, moment.y, moment.z];
        let per_metre = positions.half.map(|half| if half > 0.0 { 1.0 / half } else { 0.0 });
        let slope = |axis: usize| flat(turning.changes[axis].map(|change| change * per_metre[axis]));
        Some(WeakDirection { at_center: flat(turning.center), slopes: std::array::from_fn(slope), weight })
    }

    /// A direction over a box, from the one at a position in it, where most lacks, and its changes there.
    fn turning(&self, positions: &Cuboid, (place, here): (Point, Wrench)) -> Turning {
        let parts = |w: Wrench| [Vector::new(w[0], w[1], w[2]), Vector::new(w[3], w[4], w[5])];
        let size = |w: &Wrench| w.iter().map(|x| x * x).sum::<f64>().sqrt();
        let mut changes = [[Vector::zeros(); 2]; 3];
        for (axis, change) in changes.iter_mut().enumerate() {
            let found = [-STEP, STEP].into_iter().find_map(|step| {
                let there = self.at(place + Vector::ith(axis, step * positions.half[axis]))?;
                let change: Wrench = std::array::from_fn(|k| {
                    // What a direction leaves out altogether, it leaves out everywhere.
                    if here[k] == 0.0 { 0.0 } else { (there[k] - here[k]) / step }
                });
                (size(&change) <= MOST_TURN * size(&here)).then_some(change)
            });
            *change = parts(found.unwrap_or_default());
        }
        let mut center = parts(here);
        let away = positions.center - place;
        for (axis, change) in changes.iter().enumerate().filter(|(axis, _)| positions.half[*axis] > 0.0) {
            (0..2).for_each(|part| center[part] += change[part] * (away[axis] / positions.half[axis]));
        }
        Turning { center, changes }
    }

    /// A function over a box that exceeds what the cables provide in a direction, less what is required there, and the size of its
    /// terms; `None` if a cable comes close to its outlet.
    fn lack(&self, positions: &Cuboid, direction: &Turning) -> Option<(Quadratic, f64)> {
        let (mut sum, mut size) = (Quadratic::default(), 0.0);
        for cable in &self.cables {
            let height = height(cable, positions, direction)?;
            let [least, greatest] = cable.tension;
            let way = reach(&height.slope) + reach(&height.curve) + height.above;
            let is_tight = height.at_center > LEAN * way;
            sum.add(if is_tight { greatest } else { least }, &height);
            // Where the other limit provides more, it does so by at most the height times the difference.
            let other = if is_tight { way - height.at_center } else { way + height.at_center };
            sum.above += (greatest - least) * other.max(0.0);
            size += greatest * (height.at_center.abs() + way);
        }
        let along = |[force, moment]: &[Vector; 2], w: &Wrench| {
            force.dot(&Vector::new(w[0], w[1], w[2])) + moment.dot(&Vector::new(w[3], w[4], w[5]))
        };
        let balls = [0, 1].map(|part| direction.center[part].try_normalize(0.0).unwrap_or_default() * self.radii[part]);
        let demand = |turned: &[Vector; 2], w: &Wrench| {
            along(turned, w) + turned.iter().zip(&balls).map(|(c, ball)| c.dot(ball)).sum::<f64>()
        };
        let worst = self.required.iter().max_by(|a, b| {
            let [a, b] = [a, b].map(|w| along(&direction.center, w));
            a.total_cmp(&b)
        })?;
        sum.at_center -= demand(&direction.center, worst);
        (0..3).for_each(|axis| sum.slope[axis] -= demand(&direction.changes[axis], worst));
        let changes = direction.changes.iter().map(|change| demand(change, worst).abs()).sum::<f64>();
        Some((sum, size + demand(&direction.center, worst).abs() + changes))
    }
}

/// What a unit of a cable's tension provides in a direction: q·u, with q = c_f + c_m × arm, the vector l from the attachment to the
/// cable's origin, and u = l / |l|. With r = 1 / |l| at the centre and x = r² l² − 1, it is r q·l (1 − x/2 + 3x²/8 − ...).
fn height(cable: &StaticCable, positions: &Cuboid, direction: &Turning) -> Option<Quadratic> {
    let half = &positions.half;
    let (attachment, radius) = (positions.center + cable.arm, half.norm());
    let origin = cable.origin_near(&positions.center, radius)?;
    let line = origin.middle - attachment;
    let r = 1.0 / line.norm();
    let pull = |[force, moment]: &[Vector; 2]| force + moment.cross(&cable.arm);
    let (q, changes) = (pull(&direction.center), direction.changes.each_ref().map(pull));
    // q·l, and x.
    let along = q.dot(&line);
    let along_slope: [f64; 3] = std::array::from_fn(|a| changes[a].dot(&line) - half[a] * q[a]);
    let mixed = |a: usize, b: usize| -(half[b] * changes[a][b] + half[a] * changes[b][a]);
    let square = |a: usize| -half[a] * changes[a][a];
    let along_curve = [square(0), square(1), square(2), mixed(0, 1), mixed(0, 2), mixed(1, 2)];
    let x_slope: [f64; 3] = std::array::from_fn(|a| -2.0 * r * r * line[a] * half[a]);
    let [x, y, z] = [0, 1, 2].map(|a| (r * half[a]).powi(2));
    let x_curve = [x, y, z, 0.0, 0.0, 0.0];
    let (x1, x2) = (reach(&x_slope), reach(&x_curve));
    let most = x1 + x2;
    if !(most <= MOST_DEVIATION) {
        return None;
    }
    // The product of both series, up to squares; the rest is at most `left`.
    let mut found = Quadratic { at_center: along, slope: along_slope, curve: along_curve, ..Quadratic::default() };
    (0..3).for_each(|a| found.slope[a] -= 0.5 * along * x_slope[a]);
    add(&mut found.curve, -0.5 * along, &x_curve);
    add(&mut found.curve, 0.375 * along, &product(&x_slope, &x_slope));
    add(&mut found.curve, -0.5, &product(&along_slope, &x_slope));
    let (n1, n2) = (reach(&along_slope), reach(&along_curve));
    let cubes = 0.3125 * most.powi(3) / (1.0 - most).powi(4);
    let left = 0.375 * along.abs() * x2 * (2.0 * x1 + x2)
        + n1 * (0.5 * x2 + 0.375 * most * most)
        + n2 * (0.5 * most + 0.375 * most * most)
        + (along.abs() + n1 + n2) * cubes;
    (found.below, found.above) = (left, left);
    let mut scaled = Quadratic::default();
    scaled.add(r, &found);
    let largest = q.norm() + changes.iter().map(Vector::norm).sum::<f64>();
    let off = largest * origin.astray(&attachment, radius)?;
    (scaled.below, scaled.above) = (scaled.below + off, scaled.above + off);
    Some(scaled)
}

/// The halves of a box, across its longest axis.
fn halves(positions: &Cuboid) -> [Cuboid; 2] {
    let axis = positions.half.imax();
    let (mut low, mut high) = (positions.low, positions.high);
    (low[axis], high[axis]) = (positions.center[axis], positions.center[axis]);
    [Cuboid::new(positions.low, high), Cuboid::new(low, positions.high)]
}
