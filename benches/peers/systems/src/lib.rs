//! What `compare.py` times of our library and of a peer in Rust: C functions, each with a loop that
//! is timed inside.
//!
//! The numbers of a state are its coordinates: positions joint by joint, followed by the rates.

mod described;
mod dynibo;
mod ensembles;
mod robots;

use std::hint::black_box;
use std::slice;
use std::time::Instant;

use newton_euler::operations::Operations;
use newton_euler::prelude::*;
use newton_euler::state::{Coordinates, State};

/// A system of the table. Its input consists of the drives of the joints, in their order.
trait Case:
    Integrate + RigidBody<Scalar = f64, State: Coordinates + Default, Input: Clone> + Default
{
    const OPERATIONS: &'static [Operations];

    fn input(drives: &[f64]) -> Self::Input;
}

/// The systems, in the order in which `compare.py` numbers them, each with its input made from
/// drives.
macro_rules! cases {
    ($($place:literal: $system:path, |$drives:pat_param| $input:expr;)*) => {
        $(impl Case for $system {
            const OPERATIONS: &'static [Operations] = <$system>::OPERATIONS;

            fn input($drives: &[f64]) -> Self::Input {
                $input
            }
        })*

        /// The time in ns of this many rounds of accelerations in all states.
        ///
        /// # Safety
        /// The lists must be as long as the states and their coordinates and freedoms require.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn acceleration(
            case: usize,
            states: usize,
            coordinates: *const f64,
            drives: *const f64,
            found: *mut f64,
            rounds: usize,
        ) -> f64 {
            match case {
                // SAFETY: as above
                $($place => unsafe { timed::<$system>(states, coordinates, drives, found, rounds) },)*
                _ => f64::NAN,
            }
        }

        /// The time in ns of this many motions from the first state, with error control.
        ///
        /// # Safety
        /// The lists must be as long as the coordinates and freedoms of a state require.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn integrate(
            case: usize,
            coordinates: *const f64,
            drives: *const f64,
            rounds: usize,
        ) -> f64 {
            match case {
                // SAFETY: as above
                $($place => unsafe { moved::<$system>(coordinates, drives, rounds) },)*
                _ => f64::NAN,
            }
        }

        /// The multiplications, additions, divisions, roots, and sines and cosines of one
        /// acceleration.
        ///
        /// # Safety
        /// The list must have five places.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn operations(case: usize, counts: *mut u32) {
            let all = match case {
                $($place => <$system as Case>::OPERATIONS,)*
                _ => &[],
            };
            let row = all.iter().find(|row| row.function == "acceleration").expect("every system has one");
            let found = [row.mul, row.add, row.div, row.sqrt, row.trig];
            // SAFETY: as above
            unsafe { slice::from_raw_parts_mut(counts, 5) }.copy_from_slice(&found);
        }
    };
}

cases! {
    0: described::DoublePendulum, |_| ();
    1: described::Furuta, |drives| described::FurutaInput { torque: drives[0] };
    2: described::BallDouble, |_| ();
    3: described::Satellite, |drives| described::SatelliteInput {
        torque_x: drives[6],
        torque_y: drives[7],
        torque_z: drives[8],
    };
    4: described::Ur5, |drives| described::Ur5Input {
        drives_1: drives[0],
        drives_2: drives[1],
        drives_3: drives[2],
        drives_4: drives[3],
        drives_5: drives[4],
        drives_6: drives[5],
    };
    5: robots::Panda, |drives| robots::panda(drives);
    6: robots::Solo12, |drives| robots::solo(drives);
    7: robots::Anymal, |drives| robots::anymal(drives);
    8: robots::Chain, |_| ();
}

unsafe fn timed<B: Case>(
    states: usize,
    coordinates: *const f64,
    drives: *const f64,
    found: *mut f64,
    rounds: usize,
) -> f64 {
    let (count, freedoms) = sizes::<B>();
    // SAFETY: the caller's
    let [coordinates, drives] = unsafe {
        [
            slice::from_raw_parts(coordinates, states * count),
            slice::from_raw_parts(drives, states * freedoms),
        ]
    };
    // SAFETY: the caller's
    let found = unsafe { slice::from_raw_parts_mut(found, states * freedoms) };
    let cases: Vec<_> = coordinates
        .chunks(count)
        .zip(drives.chunks(freedoms))
        .map(|(numbers, drives)| case::<B>(numbers, drives))
        .collect();
    let body = black_box(B::default());
    let mut accelerations: Vec<_> = cases
        .iter()
        .map(|(state, input)| called(&body, state, input))
        .collect();
    let start = Instant::now();
    for _ in 0..rounds {
        for ((state, input), acceleration) in cases.iter().zip(&mut accelerations) {
            *acceleration = called(&body, state, input);
        }
        black_box(&mut accelerations);
    }
    let time = start.elapsed();
    for (((state, _), acceleration), found) in cases
        .iter()
        .zip(&accelerations)
        .zip(found.chunks_mut(freedoms))
    {
        let rates = state.rates(acceleration);
        found.copy_from_slice(&rates.as_ref()[count - freedoms..]);
    }
    time.as_secs_f64() * 1e9
}

unsafe fn moved<B: Case>(coordinates: *const f64, drives: *const f64, rounds: usize) -> f64 {
    let (count, freedoms) = sizes::<B>();
    // SAFETY: the caller's
    let (numbers, drives) = unsafe {
        (
            slice::from_raw_parts(coordinates, count),
            slice::from_raw_parts(drives, freedoms),
        )
    };
    let (state, input) = case::<B>(numbers, drives);
    let body = black_box(B::default());
    let start = Instant::now();
    for _ in 0..rounds {
        let motion = body.integrate(black_box(&state)).input(input.clone());
        black_box(motion.to(0.05).ok());
    }
    start.elapsed().as_secs_f64() * 1e9
}

/// The numbers of coordinates and of rates of a state.
fn sizes<B: Case>() -> (usize, usize) {
    let groups = B::State::GROUPS;
    let rates = &groups[groups.len() / 2..];
    (groups.iter().sum(), rates.iter().sum())
}

fn case<B: Case>(numbers: &[f64], drives: &[f64]) -> (B::State, B::Input) {
    let mut list = B::State::default().coordinates();
    list.as_mut().copy_from_slice(numbers);
    (B::State::from_coordinates(&list), B::input(drives))
}

/// A function that is called and not inlined, as those of the peers are.
#[inline(never)]
fn called<B: Case>(
    body: &B,
    state: &B::State,
    input: &B::Input,
) -> <B::State as State>::Acceleration {
    body.acceleration(0.0, state, input)
}
