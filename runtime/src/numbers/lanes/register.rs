//! Registers of doubles, and work compiled for one of them.

use pulp::{Simd, WithSimd};

/// A kind of register; a value of the type proves that the processor has it.
pub trait Register: Simd {
    /// Aligned memory for a register: data across two cache lines is read twice.
    type Aligned: Copy + Send + Sync + 'static;

    /// The proof, if the processor has it.
    fn detected() -> Option<Self>;
}

/// One double.
impl Register for pulp::Scalar {
    type Aligned = f64;

    fn detected() -> Option<Self> {
        Some(Self)
    }
}

/// Registers that pulp names, each with a type of its alignment.
#[cfg(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64"))]
macro_rules! registers {
    ($($register:ident $aligned:ident)*) => {$(
        impl super::Register for $register {
            type Aligned = $aligned;

            fn detected() -> Option<Self> {
                Self::try_new()
            }
        }
    )*};
}

/// Two, four and eight doubles: SSE4.2, AVX2, AVX-512.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod x86 {
    #[cfg(target_arch = "x86")]
    use core::arch::x86::{__m128d, __m256d, __m512d};
    #[cfg(target_arch = "x86_64")]
    use core::arch::x86_64::{__m128d, __m256d, __m512d};

    use pulp::x86::{V2, V3, V4};

    registers! { V2 __m128d V3 __m256d V4 __m512d }
}

/// Two doubles: NEON, which every processor of this kind has.
#[cfg(target_arch = "aarch64")]
mod aarch64 {
    use core::arch::aarch64::float64x2_t;

    use pulp::aarch64::Neon;

    registers! { Neon float64x2_t }
}

/// Work in lanes. Its function, and everything that it calls, must be inlined, so that it is
/// compiled for the register.
pub trait Work {
    /// The result.
    type Output;

    /// Runs the work.
    fn run<S: Register>(self, simd: S) -> Self::Output;
}

/// Runs some work in a register, in a separate function that is compiled for it.
pub(super) fn run_in<S: Register, W: Work>(simd: S, work: W) -> W::Output {
    simd.vectorize(Compiled(simd, work))
}

/// A part of such work in a separate function, for the same register. A closure of it must be
/// inlined there like all that it calls; this macro sees to that.
macro_rules! by_itself {
    ($simd:expr, $part:expr) => {
        $crate::numbers::lanes::in_function(
            $simd,
            #[cfg_attr(not(unoptimized), inline(always))]
            || $part,
        )
    };
}
pub(crate) use by_itself;

/// Runs a part of some work in a separate function. Called by [`by_itself`] only.
#[cfg_attr(not(unoptimized), inline(always))]
pub(crate) fn in_function<S: Register, R>(simd: S, part: impl FnOnce() -> R) -> R {
    simd.vectorize(Part(part))
}

/// A part of some work.
struct Part<F>(F);

impl<R, F: FnOnce() -> R> WithSimd for Part<F> {
    type Output = R;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn with_simd<Same: Simd>(self, _: Same) -> R {
        (self.0)()
    }
}

/// Work for a register.
struct Compiled<S, W>(S, W);

impl<S: Register, W: Work> WithSimd for Compiled<S, W> {
    type Output = W::Output;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn with_simd<Same: Simd>(self, _: Same) -> W::Output {
        self.1.run(self.0)
    }
}
