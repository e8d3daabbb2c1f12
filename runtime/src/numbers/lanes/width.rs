//! The width of registers, and its detection.

#[cfg(target_arch = "aarch64")]
use pulp::aarch64::Neon;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use pulp::x86::{V2, V3, V4};

use super::register::{Register, Work, run_in};

/// Widths of registers, by the number of doubles.
///
/// ```
/// use newton_euler::lanes::Width;
///
/// assert!(Width::One.is_there());
/// assert!(
///     Width::ALL
///         .into_iter()
///         .filter(|width| width.is_there())
///         .all(|width| width <= Width::widest())
/// );
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Width {
    /// No lanes.
    One,
    /// SSE4.2, or NEON on 64-bit ARM.
    Two,
    /// AVX2.
    Four,
    /// AVX-512.
    Eight,
}

impl Width {
    /// From the narrowest to the widest.
    pub const ALL: [Self; 4] = [Self::One, Self::Two, Self::Four, Self::Eight];

    /// The widest of the processor.
    #[must_use]
    pub fn widest() -> Self {
        let mut widths = Self::ALL.into_iter().rev();
        widths.find(|width| width.is_there()).unwrap_or(Self::One)
    }

    /// Whether the processor has this width.
    #[must_use]
    pub fn is_there(self) -> bool {
        self.run(Count) == self.lanes()
    }

    /// The number of doubles.
    #[must_use]
    pub fn lanes(self) -> usize {
        match self {
            Self::One => 1,
            Self::Two => 2,
            Self::Four => 4,
            Self::Eight => 8,
        }
    }

    /// Runs some work in registers of this width; scalar if the processor lacks them.
    pub fn run<W: Work>(self, work: W) -> W::Output {
        match self {
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Self::Eight => run_if(V4::detected(), work),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Self::Four => run_if(V3::detected(), work),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Self::Two => run_if(V2::detected(), work),
            #[cfg(target_arch = "aarch64")]
            Self::Two => run_if(Neon::detected(), work),
            _ => run_in(pulp::Scalar, work),
        }
    }
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64"))]
fn run_if<S: Register, W: Work>(simd: Option<S>, work: W) -> W::Output {
    match simd {
        Some(simd) => run_in(simd, work),
        None => run_in(pulp::Scalar, work),
    }
}

/// Counts the lanes.
struct Count;

impl Work for Count {
    type Output = usize;

    fn run<S: Register>(self, _: S) -> usize {
        S::F64_LANES
    }
}
