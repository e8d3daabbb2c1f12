//! What the machine can move, as a scale for what is moved.

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

/// Bytes per ns, one thread, in the widest registers, of a triad over arrays of so many bytes together.
///
/// Two are read and one is written; that a written line is read before is not counted, neither here nor for bodies.
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
