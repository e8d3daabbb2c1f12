//! The memory bandwidth of the machine, with which the bytes that are moved can be compared.

use std::hint::black_box;

use newton_euler::lanes::{Register, Width, Work};

use crate::paired::alone;

/// `a = b + 3 c`, the triad of the STREAM benchmark.
struct Triad<'a> {
    sums: &'a mut [f64],
    terms: [&'a [f64]; 2],
}

impl Work for Triad<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Register>(self, _: S) {
        let [first, second] = self.terms;
        for ((sum, b), c) in self.sums.iter_mut().zip(first).zip(second) {
            *sum = b + 3.0 * c;
        }
    }
}

/// Bytes per ns that a triad moves, in one thread and in the widest registers, over arrays with
/// this many bytes in total.
///
/// Two arrays are read and one is written. That a cache line is read before it is written is not
/// counted, here or for bodies.
pub fn bandwidth(bytes: usize) -> f64 {
    let length = u32::try_from(bytes / 24).expect("arrays of less than 4 G numbers");
    let mut arrays = [0.0, 1.0, 2.0].map(|number| vec![number; bytes / 24]);
    let per_number = alone(length, || {
        let [sums, b, c] = black_box(&mut arrays);
        let terms = [&**b, &**c];
        Width::widest().run(Triad { sums, terms });
        black_box(sums);
    });
    24.0 / per_number
}
