//! Foreign functions: defined outside the description, unknown here, each represented by a number.

/// A foreign function, or one of its derivatives.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Foreign(u32);

/// The bits that count how often the function is differentiated with respect to one argument.
const BITS: u32 = 4;
const MOST: u32 = (1 << BITS) - 1;

impl Foreign {
    /// The most arguments of a function.
    pub const ARGUMENTS: usize = 3;
    /// The most functions: limited by [`Self::word`].
    pub const COUNT: usize = 1 << (24 - 3 * BITS);

    /// The function with this index.
    pub fn new(number: usize) -> Self {
        Self(u32::try_from(number).unwrap_or(0) << (3 * BITS))
    }

    /// Its derivative with respect to one argument; the order of differentiations does not matter.
    /// Orders above `MOST` are not distinguished: derivatives of such orders are never given.
    pub fn by(self, argument: usize) -> Self {
        let place = BITS * u32::try_from(argument).unwrap_or(0);
        let is_full = self.0 >> place & MOST == MOST;
        Self(if is_full {
            self.0
        } else {
            self.0 + (1 << place)
        })
    }

    /// The function that it is a derivative of.
    pub fn without(self) -> Self {
        Self::new(self.number())
    }

    pub fn number(self) -> usize {
        (self.0 >> (3 * BITS)) as usize
    }

    /// How often it is differentiated with respect to each argument.
    pub fn orders(self) -> [u32; Self::ARGUMENTS] {
        [0, BITS, 2 * BITS].map(|place| self.0 >> place & MOST)
    }

    /// The function and its orders, in 24 bits.
    pub fn word(self) -> u32 {
        self.0
    }
}
