//! Segments against convex polyhedra, four planes at a time.
//!
//! The kernel is generic over [`Lanes`]; see [`crate::simd`].
//!
//! A plane with both ends of the segment outside rules the region out; otherwise the fraction of the segment inside
//! shrinks plane by plane (Cyrus and Beck). The inner polyhedron is tested only if the motion meets the outer one.

use std::ops::Range;

use crate::geometry::{HalfSpace, Point, Vector};
use crate::simd::{INTEGERS, Lanes, WIDTH};

/// Four half-spaces in structure-of-arrays order.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C, align(32))]
pub struct PlaneGroup {
    normal: [[f64; WIDTH]; 3],
    offset: [f64; WIDTH],
}

/// Eight half-spaces in few bits, each slightly wider than the original, so that a point outside one is outside the
/// original as well. Points and planes are relative to a cell, with its centre as the origin and its size as the unit
/// along each axis.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C, align(32))]
pub struct CoarseGroup {
    /// Normals along x and y.
    xy: [[i16; 2]; INTEGERS],
    /// Normals along z, and offsets.
    zd: [[i16; 2]; INTEGERS],
}

/// Integer steps per cell in the points of a [`CoarseGroup`].
const PLACES: f64 = 16384.0;

/// Integer steps per unit in the normals of a [`CoarseGroup`], whose largest component is 1.
const NORMALS: f64 = 8192.0;

/// How much a half-space is widened, in units of 1 / [`NORMALS`]: more than the rounding error of a height.
///
/// With coordinates of at most 1, rounding the three components of the normal adds at most 3 · ½. Truncating each
/// coordinate to 1 / [`PLACES`], half a unit, times a component of at most 1 adds 3 · ½ more, and truncating the offset
/// adds 1. The remaining unit far exceeds the floating-point rounding here; in metres, that rounding is covered by the
/// widening of every region.
const COARSE_ROUNDING: f64 = 5.0;

/// A half-space in the units of a [`CoarseGroup`], relative to any origin.
#[derive(Debug, Clone, Copy)]
pub struct CoarsePlane {
    normal: Vector,
    /// The normal, rounded to integers.
    rounded: [i16; 3],
    offset: f64,
}

impl CoarsePlane {
    /// The half-space with everything inside.
    pub const ALL_INSIDE: Self =
        CoarsePlane { normal: Vector::new(0.0, 0.0, 0.0), rounded: [0; 3], offset: f64::INFINITY };

    /// A half-space with lengths in cells. The normal may have any length; if it is zero, everything is inside.
    pub fn new(normal: &Vector, offset: f64) -> Self {
        let scale = NORMALS / normal.amax();
        if !scale.is_finite() {
            return Self::ALL_INSIDE;
        }
        let normal = normal * scale;
        CoarsePlane {
            normal,
            rounded: normal.map(|x| x.round() as i16).into(),
            offset: offset * scale + COARSE_ROUNDING,
        }
    }
}

impl CoarseGroup {
    /// Eight half-spaces with everything outside.
    pub const ALL_OUTSIDE: Self = CoarseGroup { xy: [[0; 2]; INTEGERS], zd: [[0, -1]; INTEGERS] };

    /// Stores a half-space in a lane, widened, for points around the centre of a cell.
    pub fn set(&mut self, lane: usize, plane: &CoarsePlane, middle: &Vector) {
        let [x, y, z] = plane.rounded;
        self.xy[lane] = [x, y];
        self.zd[lane] = [z, (plane.offset - plane.normal.dot(middle)) as i16];
    }
}

/// A point near a cell in the units of a [`CoarseGroup`].
#[derive(Debug, Clone, Copy)]
pub struct CoarsePlace {
    xy: [i16; 2],
    /// Coordinate along z, and the factor of the offsets.
    zd: [i16; 2],
}

impl CoarsePlace {
    /// A point that is, up to rounding, at most one cell away from the centre of a cell along each axis.
    #[inline(always)]
    pub fn new<L: Lanes>(lanes: L, from_middle: L::Four) -> Self {
        let [x, y, z, _] = lanes.truncated(lanes.mul(from_middle, lanes.splat(PLACES)));
        CoarsePlace { xy: [x as i16, y as i16], zd: [z as i16, -PLACES as i16] }
    }
}

/// One bit for each half-space of a group, 0 if both ends of a segment are outside. No sum overflows: each is at most
/// 3 · 2¹³ · 2¹⁴ for the point and 2¹⁵ · 2¹⁴ for the offset, plus a little for rounding.
#[inline(always)]
pub fn not_outside<L: Lanes>(lanes: L, group: &CoarseGroup, [from, to]: &[CoarsePlace; 2]) -> u32 {
    let a = lanes.plus(lanes.pair_products(&group.xy, from.xy), lanes.pair_products(&group.zd, from.zd));
    let b = lanes.plus(lanes.pair_products(&group.xy, to.xy), lanes.pair_products(&group.zd, to.zd));
    lanes.either_negative(a, b)
}

/// Polyhedra as groups of planes in one array.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Planes {
    groups: Vec<PlaneGroup>,
}

impl Planes {
    /// Adds a polyhedron and returns its range of groups. The last group is padded with planes that have everything
    /// inside.
    pub fn add(&mut self, half_spaces: &[HalfSpace]) -> Range<u32> {
        let first = self.groups.len() as u32;
        self.groups.extend(half_spaces.chunks(WIDTH).map(|chunk| {
            let normal = |axis: usize| std::array::from_fn(|k| chunk.get(k).map_or(0.0, |h| h.normal[axis]));
            PlaneGroup {
                normal: std::array::from_fn(normal),
                offset: std::array::from_fn(|k| chunk.get(k).map_or(f64::INFINITY, |h| h.offset)),
            }
        }));
        first..self.groups.len() as u32
    }

    /// The groups of a polyhedron.
    #[inline(always)]
    pub fn of(&self, range: &Range<u32>) -> &[PlaneGroup] {
        &self.groups[range.start as usize..range.end as usize]
    }

    /// Size of the planes in bytes.
    pub fn bytes(&self) -> usize {
        self.groups.capacity() * size_of::<PlaneGroup>()
    }
}

/// A segment, its coordinates spread over the lanes.
#[derive(Clone, Copy)]
pub struct Segment<L: Lanes> {
    lanes: L,
    from: [L::Four; 3],
    to: [L::Four; 3],
}

impl<L: Lanes> Segment<L> {
    #[inline(always)]
    pub fn new(lanes: L, from: &Point, to: &Point) -> Self {
        Segment {
            lanes,
            from: [lanes.splat(from.x), lanes.splat(from.y), lanes.splat(from.z)],
            to: [lanes.splat(to.x), lanes.splat(to.y), lanes.splat(to.z)],
        }
    }

    /// Heights of an end above four planes.
    #[inline(always)]
    fn heights(&self, normal: &[L::Four; 3], offset: L::Four, end: &[L::Four; 3]) -> L::Four {
        let l = self.lanes;
        let xy = l.add(l.mul(normal[0], end[0]), l.mul(normal[1], end[1]));
        l.sub(l.add(xy, l.mul(normal[2], end[2])), offset)
    }

    /// Heights of both ends above the planes of a group.
    #[inline(always)]
    fn both_heights(&self, group: &PlaneGroup) -> [L::Four; 2] {
        let l = self.lanes;
        let [x, y, z] = &group.normal;
        let (normal, offset) = ([l.load(x), l.load(y), l.load(z)], l.load(&group.offset));
        [self.heights(&normal, offset, &self.from), self.heights(&normal, offset, &self.to)]
    }

    /// Whether the segment meets the open polyhedron whose planes are moved outward by `widen`: the segment is clipped
    /// against one plane after another, and a part must remain.
    #[inline(always)]
    pub fn meets(&self, polyhedron: &[PlaneGroup], widen: f64) -> bool {
        let l = self.lanes;
        let by = l.splat(widen);
        let (mut low, mut high) = (l.splat(0.0), l.splat(1.0));
        for group in polyhedron {
            let [a, b] = self.both_heights(group);
            let (a, b) = (l.sub(a, by), l.sub(b, by));
            if l.not_negative(l.min(a, b)) != 0 {
                return false;
            }
            if l.not_negative(l.max(a, b)) == 0 {
                continue; // entirely inside these planes
            }
            let t = l.div(a, l.sub(a, b)); // where the segment crosses the plane; arbitrary if it does not
            low = l.where_not_negative(a, l.max(low, t), low);
            high = l.where_not_negative(b, l.min(high, t), high);
        }
        let ([a, b, c, d], [e, f, g, h]) = (l.store(low), l.store(high));
        a.max(b).max(c.max(d)) < e.min(f).min(g.min(h))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Polytope;
    use crate::simd::{Kernel, Portable, Task};
    use rand::{RngExt, SeedableRng};

    struct Meets<'a> {
        polyhedron: &'a [PlaneGroup],
        p: Point,
        q: Point,
        widen: f64,
    }

    impl Task for Meets<'_> {
        type Output = bool;

        #[inline(always)]
        fn run<L: Lanes>(self, lanes: L) -> bool {
            Segment::new(lanes, &self.p, &self.q).meets(self.polyhedron, self.widen)
        }
    }

    #[test]
    fn both_kernels_give_the_same_answers() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(3);
        let mut planes = Planes::default();
        let body = Polytope::cuboid([1.0, 0.5, 0.7]).unwrap();
        let range = planes.add(&body.half_spaces());
        let mut met = 0;
        for _ in 0..100_000 {
            let mut number = || (rng.random_range(-8..9) as f64) * 0.125 + [0.0, 1e-9][rng.random_range(0..2)];
            let [p, q]: [Point; 2] = std::array::from_fn(|_| Point::new(number(), number(), number()));
            for widen in [0.0, -1e-9, 0.125] {
                let ask = |kernel: Kernel| kernel.run(Meets { polyhedron: planes.of(&range), p, q, widen });
                assert_eq!(ask(Kernel::Portable), ask(Kernel::best()), "{p} {q} {widen}");
                met += usize::from(ask(Kernel::Portable));
            }
        }
        assert!(met > 10_000);
    }

    #[test]
    fn a_segment_along_a_face_is_outside_and_one_below_it_inside() {
        let mut planes = Planes::default();
        let range = planes.add(&Polytope::cuboid([2.0; 3]).unwrap().half_spaces());
        let meets = |p: [f64; 3], q: [f64; 3], widen| {
            Segment::new(Portable, &Point::from(p), &Point::from(q)).meets(planes.of(&range), widen)
        };
        assert!(!meets([-3.0, 0.0, 1.0], [3.0, 0.0, 1.0], 0.0));
        assert!(meets([-3.0, 0.0, 1.0], [3.0, 0.0, 1.0], 1e-9));
        assert!(meets([-3.0, 0.0, 0.999], [3.0, 0.0, 0.999], 0.0));
        assert!(meets([0.0; 3], [0.0; 3], 0.0)); // no motion, inside
        assert!(!meets([1.0, 0.0, 0.0], [1.0, 0.0, 0.0], 0.0)); // no motion, on a face
        assert!(!meets([-1.5, -0.6, 0.0], [-0.6, -1.5, 0.0], 0.0)); // passes a corner outside
    }

    struct NotOutside<'a> {
        group: &'a CoarseGroup,
        ends: [Vector; 2],
    }

    impl Task for NotOutside<'_> {
        type Output = u32;

        #[inline(always)]
        fn run<L: Lanes>(self, lanes: L) -> u32 {
            let [p, q] = self.ends;
            let place = [p, q].map(|p| CoarsePlace::new(lanes, lanes.load(&[p.x, p.y, p.z, 0.0])));
            not_outside(lanes, self.group, &place)
        }
    }

    #[test]
    fn coarse_planes_contain_their_half_spaces() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(5);
        let (mut outside, mut missed) = (0, 0);
        for case in 0..30_000 {
            let middle = Vector::from_fn(|_, _| rng.random_range(0.0..=32.0));
            let mut vector = || Vector::from_fn(|_, _| rng.random_range(-1.0..=1.0_f64));
            let mut corner = || vector().map(|x| if case % 3 == 0 { x.signum() } else { x });
            let ends = [corner(), corner()];
            let mut planes: Vec<(Vector, f64)> = (0..INTEGERS).map(|_| (corner(), 0.0)).collect();
            let mut group = CoarseGroup::ALL_OUTSIDE;
            for (lane, (normal, offset)) in planes.iter_mut().enumerate() {
                // Most planes pass through an end, or miss it slightly.
                let by = [0.0, 1e-12, 1e-5, 2e-4, 0.1, 3.0, 1e9][rng.random_range(0..7)];
                *offset = normal.dot(&ends[lane % 2]) + by * rng.random_range(-1.0..=1.0);
                let size = [1e-9, 0.05, 1.0, 1e3][rng.random_range(0..4)];
                let plane = CoarsePlane::new(&(*normal * size), (*offset + normal.dot(&middle)) * size);
                group.set(lane, &plane, &middle);
            }
            let open = [Kernel::Portable, Kernel::best()].map(|k| k.run(NotOutside { group: &group, ends }));
            assert_eq!(open[0], open[1]);
            for (lane, (normal, offset)) in planes.iter().enumerate() {
                let least = ends.map(|end| (normal.dot(&end) - offset) / normal.amax());
                let least = least[0].min(least[1]);
                if open[0] >> lane & 1 == 0 {
                    assert!(least > 0.0, "{normal} {offset} {ends:?}");
                    outside += 1;
                } else {
                    assert!(least < 10.0 / NORMALS, "{normal} {offset} {ends:?}");
                    missed += usize::from(least > 0.0);
                }
            }
        }
        assert!(outside > 10_000 && missed > 1000, "{outside} {missed}");
    }

    #[test]
    fn padding_planes_contain_all_and_empty_lanes_nothing() {
        let mut group = CoarseGroup::ALL_OUTSIDE;
        group.set(2, &CoarsePlane::ALL_INSIDE, &Vector::repeat(0.5));
        group.set(5, &CoarsePlane::new(&Vector::zeros(), -1.0), &Vector::repeat(0.5));
        for kernel in [Kernel::Portable, Kernel::best()] {
            for x in [-1.0, 0.0, 1.0] {
                assert_eq!(kernel.run(NotOutside { group: &group, ends: [Vector::repeat(x); 2] }), 1 << 2 | 1 << 5);
            }
        }
    }
}
