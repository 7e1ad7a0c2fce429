//! Segments against convex polyhedra, four planes at a time.
//!
//! The kernel is written over [`Lanes`], see [`crate::numerics::simd`].

use std::ops::Range;

use crate::geometry::{HalfSpace, Point};
use crate::numerics::simd::{Lanes, WIDTH};

/// Four half-spaces in structure-of-arrays order.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C, align(32))]
pub struct PlaneGroup {
    normal: [[f64; WIDTH]; 3],
    offset: [f64; WIDTH],
}

/// Four half-spaces in half the memory, each a little wider than the one it stands for: what is outside of it is outside of
/// that one.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C, align(64))]
pub struct CoarseGroup {
    normal: [[f32; WIDTH]; 3],
    offset: [f32; WIDTH],
}

impl CoarseGroup {
    /// Everything is outside of all four.
    pub const ALL_OUTSIDE: Self = CoarseGroup { normal: [[0.0; WIDTH]; 3], offset: [f32::NEG_INFINITY; WIDTH] };

    /// Puts a half-space into a lane, widened for positions whose coordinates are at most `largest`, m.
    pub fn set(&mut self, lane: usize, half_space: &HalfSpace, largest: f64) {
        for axis in 0..3 {
            self.normal[axis][lane] = half_space.normal[axis] as f32;
        }
        let rounding = 4.0 * f64::from(f32::EPSILON) * (largest + half_space.offset.abs());
        self.offset[lane] = (half_space.offset + rounding) as f32;
    }
}

/// Polyhedra as groups of planes in one array.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Planes {
    groups: Vec<PlaneGroup>,
}

impl Planes {
    /// Adds a polyhedron and says which groups it has. The last group is filled up with planes that have everything inside.
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

    /// Bytes held.
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

    /// Heights of an end over four planes.
    #[inline(always)]
    fn heights(&self, normal: &[L::Four; 3], offset: L::Four, end: &[L::Four; 3]) -> L::Four {
        let l = self.lanes;
        let xy = l.add(l.mul(normal[0], end[0]), l.mul(normal[1], end[1]));
        l.sub(l.add(xy, l.mul(normal[2], end[2])), offset)
    }

    /// Heights of both ends over the planes of a group.
    #[inline(always)]
    fn both_heights(&self, group: &PlaneGroup) -> [L::Four; 2] {
        let l = self.lanes;
        let [x, y, z] = &group.normal;
        let (normal, offset) = ([l.load(x), l.load(y), l.load(z)], l.load(&group.offset));
        [self.heights(&normal, offset, &self.from), self.heights(&normal, offset, &self.to)]
    }

    /// One bit for each half-space of a group that has the whole segment outside.
    #[inline(always)]
    pub fn outside(&self, group: &CoarseGroup) -> u32 {
        let l = self.lanes;
        let [x, y, z] = &group.normal;
        let (normal, offset) = ([l.widen(x), l.widen(y), l.widen(z)], l.widen(&group.offset));
        let (a, b) = (self.heights(&normal, offset, &self.from), self.heights(&normal, offset, &self.to));
        l.not_negative(l.min(a, b))
    }

    /// Whether one plane alone has the whole segment outside.
    #[inline(always)]
    pub fn apart(&self, polyhedron: &[PlaneGroup]) -> bool {
        for group in polyhedron {
            let [a, b] = self.both_heights(group);
            if self.lanes.not_negative(self.lanes.min(a, b)) != 0 {
                return true;
            }
        }
        false
    }

    /// Whether the segment meets the open polyhedron whose planes are moved outward by `widen`: the segment is clipped
    /// against one plane after the other, and something must be left.
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
                continue; // all of it is inside of these planes
            }
            let t = l.div(a, l.sub(a, b)); // where the segment passes the plane; anything where it does not
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
    use crate::numerics::simd::{Kernel, Portable, Task};
    use rand::{RngExt, SeedableRng};

    struct Both<'a> {
        polyhedron: &'a [PlaneGroup],
        p: Point,
        q: Point,
        widen: f64,
    }

    impl Task for Both<'_> {
        type Output = (bool, bool);

        #[inline(always)]
        fn run<L: Lanes>(self, lanes: L) -> (bool, bool) {
            let segment = Segment::new(lanes, &self.p, &self.q);
            (segment.apart(self.polyhedron), segment.meets(self.polyhedron, self.widen))
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
                let ask = |kernel: Kernel| kernel.run(Both { polyhedron: planes.of(&range), p, q, widen });
                assert_eq!(ask(Kernel::Portable), ask(Kernel::best()), "{p} {q} {widen}");
                met += usize::from(ask(Kernel::Portable).1);
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
}
