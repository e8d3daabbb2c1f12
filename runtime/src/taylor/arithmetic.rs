//! Multiplication and addition, by the instructions of the processor.

/// Many products at once.
///
/// A value of such a type proves that its instructions are available.
pub trait Arithmetic: Copy + Send {
    /// `sums + left right`, element by element.
    #[must_use]
    fn multiply_add<const COUNT: usize>(
        self,
        sums: [f64; COUNT],
        left: [f64; COUNT],
        right: [f64; COUNT],
    ) -> [f64; COUNT];
}

/// With the baseline instructions of the target: product and sum are rounded separately.
#[derive(Clone, Copy, Debug, Default)]
pub struct Plain;

impl Arithmetic for Plain {
    #[cfg_attr(not(unoptimized), inline(always))]
    fn multiply_add<const COUNT: usize>(
        self,
        mut sums: [f64; COUNT],
        left: [f64; COUNT],
        right: [f64; COUNT],
    ) -> [f64; COUNT] {
        for k in 0..COUNT {
            sums[k] += left[k] * right[k];
        }
        sums
    }
}

/// Fused operations, rounded once: four at once by AVX2, eight by AVX-512.
#[cfg(all(feature = "dispatch", target_arch = "x86_64"))]
mod x86 {
    use pulp::bytemuck::cast;
    use pulp::x86::{V3, V4};

    use super::Arithmetic;

    impl Arithmetic for V3 {
        #[cfg_attr(not(unoptimized), inline(always))]
        fn multiply_add<const COUNT: usize>(
            self,
            mut sums: [f64; COUNT],
            left: [f64; COUNT],
            right: [f64; COUNT],
        ) -> [f64; COUNT] {
            let mut place = 0;
            while place + 4 <= COUNT {
                let (a, b) = (part::<4>(&left, place), part::<4>(&right, place));
                let sum = part::<4>(&sums, place);
                let sum: [f64; 4] = cast(self.mul_add_f64x4(cast(a), cast(b), cast(sum)));
                sums[place..place + 4].copy_from_slice(&sum);
                place += 4;
            }
            rest(sums, left, right, place)
        }
    }

    impl Arithmetic for V4 {
        #[cfg_attr(not(unoptimized), inline(always))]
        fn multiply_add<const COUNT: usize>(
            self,
            mut sums: [f64; COUNT],
            left: [f64; COUNT],
            right: [f64; COUNT],
        ) -> [f64; COUNT] {
            let mut place = 0;
            while place + 8 <= COUNT {
                let (a, b) = (part::<8>(&left, place), part::<8>(&right, place));
                let sum = part::<8>(&sums, place);
                let sum: [f64; 8] = cast(self.mul_add_f64x8(cast(a), cast(b), cast(sum)));
                sums[place..place + 8].copy_from_slice(&sum);
                place += 8;
            }
            while place + 4 <= COUNT {
                let (a, b) = (part::<4>(&left, place), part::<4>(&right, place));
                let sum = part::<4>(&sums, place);
                let sum: [f64; 4] = cast(self.mul_add_f64x4(cast(a), cast(b), cast(sum)));
                sums[place..place + 4].copy_from_slice(&sum);
                place += 4;
            }
            rest(sums, left, right, place)
        }
    }

    /// The elements that fill no register.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn rest<const COUNT: usize>(
        mut sums: [f64; COUNT],
        left: [f64; COUNT],
        right: [f64; COUNT],
        place: usize,
    ) -> [f64; COUNT] {
        for k in place..COUNT {
            sums[k] += left[k] * right[k];
        }
        sums
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn part<const SOME: usize>(of: &[f64], place: usize) -> [f64; SOME] {
        let mut part = [0.0; SOME];
        part.copy_from_slice(&of[place..place + SOME]);
        part
    }
}
