//! The hash of nodes. Keys are short and numerous. Collisions are no danger: users who provoke them
//! only slow down their own builds.

use core::hash::{BuildHasherDefault, Hasher};
use std::collections::HashMap;

/// A map of short keys: nodes, or their words.
pub type ShortMap<K, V> = HashMap<K, V, BuildHasherDefault<WordHasher>>;

/// Rotates and multiplies, word by word.
#[derive(Clone, Copy, Default)]
pub struct WordHasher(u64);

/// 2^64 divided by the golden ratio: odd, and its bits have no pattern.
const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;

impl Hasher for WordHasher {
    fn write(&mut self, bytes: &[u8]) {
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.write_u64(u64::from_le_bytes(word));
        }
    }

    fn write_u32(&mut self, word: u32) {
        self.write_u64(u64::from(word));
    }

    fn write_u64(&mut self, word: u64) {
        self.0 = (self.0.rotate_left(23) ^ word).wrapping_mul(FACTOR);
    }

    fn write_u128(&mut self, word: u128) {
        #[expect(clippy::cast_possible_truncation, reason = "both halves are hashed")]
        let halves = [word as u64, (word >> 64) as u64];
        self.write_u64(halves[0]);
        self.write_u64(halves[1]);
    }

    fn write_usize(&mut self, word: usize) {
        self.write_u64(word as u64);
    }

    fn write_isize(&mut self, word: isize) {
        self.write_usize(word.cast_unsigned());
    }

    fn finish(&self) -> u64 {
        self.0 ^ self.0 >> 32
    }
}
