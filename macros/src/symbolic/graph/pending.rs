//! What a walk from the roots down has still to visit.

/// A set of numbers, one bit each. Children precede their parents, so a walk that takes the last
/// number first visits each node once, and needs no sorting.
#[derive(Default)]
pub(super) struct Pending(Vec<u64>);

impl Pending {
    pub fn insert(&mut self, number: u32) {
        let word = (number / u64::BITS) as usize;
        if word >= self.0.len() {
            self.0.resize(word + 1, 0);
        }
        self.0[word] |= 1 << (number % u64::BITS);
    }

    pub fn take_last(&mut self) -> Option<u32> {
        loop {
            let before = u32::try_from(self.0.len()).unwrap_or(u32::MAX);
            let last = self.0.last_mut()?;
            if let Some(bit) = last.checked_ilog2() {
                *last ^= 1 << bit;
                return Some((before - 1) * u64::BITS + bit);
            }
            self.0.pop();
        }
    }
}
