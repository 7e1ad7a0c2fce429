//! Segments against convex polyhedra, four planes at a time.
//!
//! One kernel, written once over [`Lanes`], compiled twice: portable, and with AVX2 (chosen at run time, through pulp).
//! Both do the same operations on the same numbers in the same order, without fused ones, so their answers are the same
//! to the last bit. Inside the kernel stand loops, not closures: what is not inlined is not compiled for AVX2.

use std::ops::Range;

use crate::geometry::{HalfSpace, Point};

/// Planes to a group.
pub const WIDTH: usize = 4;

/// One bit for each lane.
pub const ALL_LANES: u32 = (1 << WIDTH) - 1;

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

/// Four numbers at a time, and what the kernel does with them.
pub trait Lanes: Copy {
    /// Four numbers.
    type Four: Copy;
    fn load(self, x: &[f64; WIDTH]) -> Self::Four;
    fn widen(self, x: &[f32; WIDTH]) -> Self::Four;
    fn splat(self, x: f64) -> Self::Four;
    fn add(self, a: Self::Four, b: Self::Four) -> Self::Four;
    fn sub(self, a: Self::Four, b: Self::Four) -> Self::Four;
    fn mul(self, a: Self::Four, b: Self::Four) -> Self::Four;
    fn div(self, a: Self::Four, b: Self::Four) -> Self::Four;
    fn min(self, a: Self::Four, b: Self::Four) -> Self::Four;
    fn max(self, a: Self::Four, b: Self::Four) -> Self::Four;
    /// `a` where `sign` is not negative, else `b`.
    fn where_not_negative(self, sign: Self::Four, a: Self::Four, b: Self::Four) -> Self::Four;
    /// One bit for each of the four that is not negative.
    fn not_negative(self, a: Self::Four) -> u32;
    fn store(self, a: Self::Four) -> [f64; WIDTH];
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

/// Lanes as plain arrays, for any machine.
#[derive(Debug, Clone, Copy)]
pub struct Portable;

impl Lanes for Portable {
    type Four = [f64; WIDTH];

    #[inline(always)]
    fn load(self, x: &[f64; WIDTH]) -> [f64; WIDTH] {
        *x
    }

    #[inline(always)]
    fn widen(self, x: &[f32; WIDTH]) -> [f64; WIDTH] {
        x.map(f64::from)
    }

    #[inline(always)]
    fn splat(self, x: f64) -> [f64; WIDTH] {
        [x; WIDTH]
    }

    #[inline(always)]
    fn add(self, a: [f64; WIDTH], b: [f64; WIDTH]) -> [f64; WIDTH] {
        std::array::from_fn(|k| a[k] + b[k])
    }

    #[inline(always)]
    fn sub(self, a: [f64; WIDTH], b: [f64; WIDTH]) -> [f64; WIDTH] {
        std::array::from_fn(|k| a[k] - b[k])
    }

    #[inline(always)]
    fn mul(self, a: [f64; WIDTH], b: [f64; WIDTH]) -> [f64; WIDTH] {
        std::array::from_fn(|k| a[k] * b[k])
    }

    #[inline(always)]
    fn div(self, a: [f64; WIDTH], b: [f64; WIDTH]) -> [f64; WIDTH] {
        std::array::from_fn(|k| a[k] / b[k])
    }

    #[inline(always)]
    fn min(self, a: [f64; WIDTH], b: [f64; WIDTH]) -> [f64; WIDTH] {
        std::array::from_fn(|k| if a[k] < b[k] { a[k] } else { b[k] })
    }

    #[inline(always)]
    fn max(self, a: [f64; WIDTH], b: [f64; WIDTH]) -> [f64; WIDTH] {
        std::array::from_fn(|k| if a[k] > b[k] { a[k] } else { b[k] })
    }

    #[inline(always)]
    fn where_not_negative(self, sign: [f64; WIDTH], a: [f64; WIDTH], b: [f64; WIDTH]) -> [f64; WIDTH] {
        std::array::from_fn(|k| if sign[k] >= 0.0 { a[k] } else { b[k] })
    }

    #[inline(always)]
    fn not_negative(self, [a, b, c, d]: [f64; WIDTH]) -> u32 {
        u32::from(a >= 0.0) | u32::from(b >= 0.0) << 1 | u32::from(c >= 0.0) << 2 | u32::from(d >= 0.0) << 3
    }

    #[inline(always)]
    fn store(self, a: [f64; WIDTH]) -> [f64; WIDTH] {
        a
    }
}

#[cfg(target_arch = "x86_64")]
mod avx2 {
    use super::{Lanes, Task, WIDTH};
    use pulp::x86::V3;
    use pulp::{NullaryFnOnce, cast, f32x4, f64x4};
    use std::arch::x86_64::__m256d;

    /// A task as pulp takes it.
    pub struct OnLanes<T> {
        pub task: T,
        pub v3: V3,
    }

    impl<T: Task> NullaryFnOnce for OnLanes<T> {
        type Output = T::Output;

        #[inline(always)]
        fn call(self) -> T::Output {
            self.task.run(self.v3)
        }
    }

    impl Lanes for V3 {
        type Four = __m256d;

        #[inline(always)]
        fn load(self, x: &[f64; WIDTH]) -> __m256d {
            cast(f64x4(x[0], x[1], x[2], x[3]))
        }

        #[inline(always)]
        fn widen(self, x: &[f32; WIDTH]) -> __m256d {
            self.avx._mm256_cvtps_pd(cast(f32x4(x[0], x[1], x[2], x[3])))
        }

        #[inline(always)]
        fn splat(self, x: f64) -> __m256d {
            self.avx._mm256_set1_pd(x)
        }

        #[inline(always)]
        fn add(self, a: __m256d, b: __m256d) -> __m256d {
            self.avx._mm256_add_pd(a, b)
        }

        #[inline(always)]
        fn sub(self, a: __m256d, b: __m256d) -> __m256d {
            self.avx._mm256_sub_pd(a, b)
        }

        #[inline(always)]
        fn mul(self, a: __m256d, b: __m256d) -> __m256d {
            self.avx._mm256_mul_pd(a, b)
        }

        #[inline(always)]
        fn div(self, a: __m256d, b: __m256d) -> __m256d {
            self.avx._mm256_div_pd(a, b)
        }

        #[inline(always)]
        fn min(self, a: __m256d, b: __m256d) -> __m256d {
            self.avx._mm256_min_pd(a, b)
        }

        #[inline(always)]
        fn max(self, a: __m256d, b: __m256d) -> __m256d {
            self.avx._mm256_max_pd(a, b)
        }

        #[inline(always)]
        fn where_not_negative(self, sign: __m256d, a: __m256d, b: __m256d) -> __m256d {
            let mask = self.avx._mm256_cmp_pd::<{ std::arch::x86_64::_CMP_GE_OQ }>(sign, self.splat(0.0));
            self.avx._mm256_blendv_pd(b, a, mask)
        }

        #[inline(always)]
        fn not_negative(self, a: __m256d) -> u32 {
            let mask = self.avx._mm256_cmp_pd::<{ std::arch::x86_64::_CMP_GE_OQ }>(a, self.splat(0.0));
            self.avx._mm256_movemask_pd(mask) as u32
        }

        #[inline(always)]
        fn store(self, a: __m256d) -> [f64; WIDTH] {
            let f64x4(x, y, z, w) = cast(a);
            [x, y, z, w]
        }
    }
}

/// Which compilation of the kernel runs.
#[derive(Debug, Clone, Copy)]
pub enum Kernel {
    /// For any machine.
    Portable,
    /// With AVX2.
    #[cfg(target_arch = "x86_64")]
    Avx2(pulp::x86::V3),
}

impl Kernel {
    /// The best that this machine has.
    pub fn best() -> Self {
        #[cfg(target_arch = "x86_64")]
        if let Some(v3) = pulp::x86::V3::try_new() {
            return Kernel::Avx2(v3);
        }
        Kernel::Portable
    }
}

/// Work that a kernel does.
pub trait Task {
    type Output;

    /// The work, over any lanes; it must be `#[inline(always)]`, with all that it calls on the way to the lanes.
    fn run<L: Lanes>(self, lanes: L) -> Self::Output;
}

impl Kernel {
    /// Runs a task compiled for this kernel.
    #[inline(always)]
    pub fn run<T: Task>(self, task: T) -> T::Output {
        match self {
            Kernel::Portable => task.run(Portable),
            #[cfg(target_arch = "x86_64")]
            Kernel::Avx2(v3) => v3.vectorize(avx2::OnLanes { task, v3 }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Polytope;
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
