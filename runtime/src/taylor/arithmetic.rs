//! Multiplying and adding, by the instructions that the processor has.

/// Four products at once.
///
/// A value of a type is the proof that its instructions are there.
pub trait Arithmetic: Copy {
    /// `sums + left right`, of each.
    #[must_use]
    fn multiply_add(self, sums: [f64; 4], left: [f64; 4], right: [f64; 4]) -> [f64; 4];
}

/// By what every processor of the target has: product and sum are rounded each.
#[derive(Clone, Copy, Debug, Default)]
pub struct Plain;

impl Arithmetic for Plain {
    #[inline(always)]
    fn multiply_add(self, sums: [f64; 4], left: [f64; 4], right: [f64; 4]) -> [f64; 4] {
        core::array::from_fn(|k| sums[k] + left[k] * right[k])
    }
}

/// AVX2 with fused operations, rounded once.
#[cfg(all(feature = "dispatch", target_arch = "x86_64"))]
mod x86 {
    use pulp::bytemuck::cast;
    use pulp::x86::V3;

    impl super::Arithmetic for V3 {
        #[inline(always)]
        fn multiply_add(self, sums: [f64; 4], left: [f64; 4], right: [f64; 4]) -> [f64; 4] {
            cast(self.mul_add_f64x4(cast(left), cast(right), cast(sums)))
        }
    }
}
