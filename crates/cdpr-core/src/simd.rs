//! Four floating-point numbers or eight integers at a time: a kernel is written once over [`Lanes`] and compiled twice,
//! portably and for AVX2 (selected at run time, through pulp).
//!
//! Both kernels perform the same operations on the same numbers in the same order, without fused operations, so their
//! results are equal to the last bit. Kernels use loops rather than closures: code that is not inlined is not compiled
//! for AVX2.

/// Numbers per group.
pub const WIDTH: usize = 4;

/// Integers per group.
pub const INTEGERS: usize = 8;

/// Four numbers or eight integers, and the operations that kernels need.
pub trait Lanes: Copy {
    /// Four numbers.
    type Four: Copy;
    /// Eight integers.
    type Integers: Copy;
    fn load(self, x: &[f64; WIDTH]) -> Self::Four;
    fn splat(self, x: f64) -> Self::Four;
    fn add(self, a: Self::Four, b: Self::Four) -> Self::Four;
    fn sub(self, a: Self::Four, b: Self::Four) -> Self::Four;
    fn mul(self, a: Self::Four, b: Self::Four) -> Self::Four;
    fn div(self, a: Self::Four, b: Self::Four) -> Self::Four;
    fn min(self, a: Self::Four, b: Self::Four) -> Self::Four;
    fn max(self, a: Self::Four, b: Self::Four) -> Self::Four;
    fn sqrt(self, a: Self::Four) -> Self::Four;
    fn abs(self, a: Self::Four) -> Self::Four;
    /// `a` where `sign` is nonnegative, otherwise `b`.
    fn where_not_negative(self, sign: Self::Four, a: Self::Four, b: Self::Four) -> Self::Four;
    /// One bit for each of the four that is nonnegative.
    fn not_negative(self, a: Self::Four) -> u32;
    fn store(self, a: Self::Four) -> [f64; WIDTH];
    /// The numbers, of magnitude below 2³¹, truncated to integers.
    fn truncated(self, a: Self::Four) -> [i32; WIDTH];
    /// The scalar products of eight pairs with one pair, which must not overflow.
    fn pair_products(self, pairs: &[[i16; 2]; INTEGERS], with: [i16; 2]) -> Self::Integers;
    /// Sums, which must not overflow.
    fn plus(self, a: Self::Integers, b: Self::Integers) -> Self::Integers;
    /// One bit for each of the eight that is negative in `a` or in `b`.
    fn either_negative(self, a: Self::Integers, b: Self::Integers) -> u32;
}

/// Lanes as plain arrays, for any machine.
#[derive(Debug, Clone, Copy)]
pub struct Portable;

impl Lanes for Portable {
    type Four = [f64; WIDTH];
    type Integers = [i32; INTEGERS];

    #[inline(always)]
    fn load(self, x: &[f64; WIDTH]) -> [f64; WIDTH] {
        *x
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
    fn sqrt(self, a: [f64; WIDTH]) -> [f64; WIDTH] {
        std::array::from_fn(|k| a[k].sqrt())
    }

    #[inline(always)]
    fn abs(self, a: [f64; WIDTH]) -> [f64; WIDTH] {
        std::array::from_fn(|k| a[k].abs())
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

    #[inline(always)]
    fn truncated(self, a: [f64; WIDTH]) -> [i32; WIDTH] {
        a.map(|x| x as i32)
    }

    #[inline(always)]
    fn pair_products(self, pairs: &[[i16; 2]; INTEGERS], [x, y]: [i16; 2]) -> [i32; INTEGERS] {
        std::array::from_fn(|k| i32::from(pairs[k][0]) * i32::from(x) + i32::from(pairs[k][1]) * i32::from(y))
    }

    #[inline(always)]
    fn plus(self, a: [i32; INTEGERS], b: [i32; INTEGERS]) -> [i32; INTEGERS] {
        std::array::from_fn(|k| a[k] + b[k])
    }

    #[inline(always)]
    fn either_negative(self, a: [i32; INTEGERS], b: [i32; INTEGERS]) -> u32 {
        let mut bits = 0;
        for k in 0..INTEGERS {
            bits |= u32::from((a[k] | b[k]) < 0) << k;
        }
        bits
    }
}

#[cfg(target_arch = "x86_64")]
mod avx2 {
    use super::{INTEGERS, Lanes, Task, WIDTH};
    use pulp::x86::V3;
    use pulp::{NullaryFnOnce, cast, f64x4};
    use std::arch::x86_64::{__m256d, __m256i};

    /// A task in the form that pulp requires.
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
        type Integers = __m256i;

        #[inline(always)]
        fn load(self, x: &[f64; WIDTH]) -> __m256d {
            cast(f64x4(x[0], x[1], x[2], x[3]))
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
        fn sqrt(self, a: __m256d) -> __m256d {
            self.avx._mm256_sqrt_pd(a)
        }

        #[inline(always)]
        fn abs(self, a: __m256d) -> __m256d {
            self.avx._mm256_andnot_pd(self.splat(-0.0), a)
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

        #[inline(always)]
        fn truncated(self, a: __m256d) -> [i32; WIDTH] {
            cast(self.avx._mm256_cvttpd_epi32(a))
        }

        #[inline(always)]
        fn pair_products(self, pairs: &[[i16; 2]; INTEGERS], with: [i16; 2]) -> __m256i {
            self.avx2._mm256_madd_epi16(cast(*pairs), self.avx._mm256_set1_epi32(cast(with)))
        }

        #[inline(always)]
        fn plus(self, a: __m256i, b: __m256i) -> __m256i {
            self.avx2._mm256_add_epi32(a, b)
        }

        #[inline(always)]
        fn either_negative(self, a: __m256i, b: __m256i) -> u32 {
            let either = self.avx2._mm256_or_si256(a, b);
            self.avx._mm256_movemask_ps(self.avx._mm256_castsi256_ps(either)) as u32
        }
    }
}

/// The compilation of the kernel to run.
#[derive(Debug, Clone, Copy)]
pub enum Kernel {
    /// For any machine.
    Portable,
    /// With AVX2.
    #[cfg(target_arch = "x86_64")]
    Avx2(pulp::x86::V3),
}

impl Kernel {
    /// The fastest one that this machine supports; the portable one if the environment variable `CDPR_PORTABLE` is set,
    /// for tests.
    pub fn best() -> Self {
        if std::env::var_os("CDPR_PORTABLE").is_some() {
            return Kernel::Portable;
        }
        #[cfg(target_arch = "x86_64")]
        if let Some(v3) = pulp::x86::V3::try_new() {
            return Kernel::Avx2(v3);
        }
        Kernel::Portable
    }
}

/// A task for a kernel.
pub trait Task {
    type Output;

    /// The task, over any lanes; it must be `#[inline(always)]`, as must everything that it calls on the way to the
    /// lanes.
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
