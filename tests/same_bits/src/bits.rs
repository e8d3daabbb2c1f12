//! Combines many numbers into one, using all of their bits.

use newton_euler::Scalar;
use newton_euler::columns::{Columns, Sink, Source};
use newton_euler::state::Coordinates;

/// FNV-1a of 64 bits (G. Fowler, L. C. Noll, K.-P. Vo), byte by byte from the lowest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bits(pub u64);

impl Bits {
    pub const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    /// Adds what holds numbers.
    pub fn add<T: Scalar>(&mut self, what: &impl Columns<T>) {
        what.write(self);
    }

    /// Adds numbers.
    pub fn all<T: Scalar>(&mut self, numbers: impl IntoIterator<Item = T>) {
        for number in numbers {
            self.put(number);
        }
    }
}

/// Single precision counts as the double that it is.
impl<T: Scalar> Sink<T> for Bits {
    fn put(&mut self, scalar: T) {
        for lane in 0..T::LANES {
            let number = scalar.lane(lane);
            // the bits of what is no number are promised by nobody
            assert!(!number.is_nan(), "a number");
            for byte in number.to_bits().to_le_bytes() {
                self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
            }
        }
    }
}

/// Numbers between -1 and 1, the same at each run, exact in single precision.
pub struct Numbers(pub u64);

impl<T: Scalar> Source<T> for Numbers {
    fn take(&mut self) -> T {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        #[expect(clippy::cast_precision_loss, reason = "24 bits")]
        let number = (self.0 >> 40) as f32 / (1_u32 << 23) as f32 - 1.0;
        T::default().constant(f64::from(number), number)
    }
}

impl Numbers {
    /// A state: what a second and a half from the default one leads to, at some velocity and acceleration.
    pub fn state<T: Scalar, S>(&mut self) -> S
    where
        S: Coordinates<Scalar = T, Acceleration: Columns<T>> + Columns<T> + Default,
    {
        let rate = S::read(self).rate(&Columns::read(self));
        S::default().moved(&(rate * T::default().constant(1.5, 1.5)))
    }
}
