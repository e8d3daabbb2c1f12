//! Rigid bodies from collections of integrator test problems, written as bodies and compared with
//! known end states.
//!
//! All of them are `y₁' = a y₂ y₃, y₂' = b y₃ y₁, y₃' = c y₁ y₂ + f(t)`. Few are Euler's equations
//! as they stand: a + b + c + a b c would have to be zero, and no coefficient larger than 1 in
//! magnitude. After a change of unit in each component all of them are, `yᵢ = sᵢ ωᵢ` for a body
//! with a = (J₂ - J₃) / J₁ · s₁ / (s₂ s₃) and so on:
//!
//! | problem | a, b, c | y(0) | J | s |
//! |---|---|---|---|---|
//! | DETEST B5 (T. E. Hull, W. H. Enright and others, SIAM J. Numer. Anal. 9 (1972) 603), to 20 | 1, -1, -0.51 | 0, 1, 1 | 25, 42, 18 | 5/9, 4/3, 2/5 |
//! | `prob_ode_rigidbody` of `ODEProblemLibrary`, to 20 | -2, 1.25, -0.5 | 1, 0, 0.9 | 2, 5, 6 | 4/5, 1/2, 2/5 |
//! | the rigid body of `SciMLBenchmarks`, f = ¼ sin² t, to 10 | the same | the same | the same | the same |
//! | EULR (E. Hairer, S. P. Nørsett, G. Wanner, Solving ODEs I, II.10), f only from 3π to 4π, to 20 | the same | the same | the same | the same |
//!
//! Asserts: B5 against `(sn t, cn t, dn t)` with k² = 0.51 and against the end in Algorithm 648 (W.
//! H. Enright, J. D. Pryce, ACM Trans. Math. Softw. 13 (1987) 28); the others, whose ends are not
//! published, against 40-digit arithmetic (`tests/reference/published.py`).
#![allow(
    clippy::unreadable_literal,
    clippy::excessive_precision,
    reason = "as published"
)]

use std::f64::consts::PI;

use newton_euler::integrate::{IntegrationError, TaylorSeries};
use newton_euler::nalgebra::Vector3;
use newton_euler::prelude::*;

rigid_body!(Detest {
    doc: "DETEST B5.",
    motion: rotation,
    inertia: principal(25, 42, 18)[kg * m ^ 2],
    outputs: [flow, taylor],
});

rigid_body!(Turning {
    doc: "Without load.",
    motion: rotation,
    inertia: principal(2, 5, 6)[kg * m ^ 2],
    outputs: [flow, taylor],
});

rigid_body!(Driven {
    doc: "Under a moment that is J₃ / s₃ = 15 times f, while `push` is 1.",
    motion: rotation,
    inputs: [push],
    inertia: principal(2, 5, 6)[kg * m ^ 2],
    moments: [drive = push * body(0, 0, 15 * 0.25 * (t * 1[rad / s]).sin().powi(2))],
    outputs: [taylor],
});

/// The y of a problem.
pub(crate) struct Scales(Vector3<f64>);

impl Scales {
    /// The units of DETEST B5.
    pub(crate) fn detest() -> Self {
        Self([5.0 / 9.0, 4.0 / 3.0, 2.0 / 5.0].into())
    }

    /// The units of the others.
    pub(crate) fn others() -> Self {
        Self([0.8, 0.5, 0.4].into())
    }

    /// The state of a given y.
    pub(crate) fn state(&self, y: [f64; 3]) -> Rotation {
        Rotation {
            angular_velocity: Vector3::from(y).component_div(&self.0),
            ..Rotation::default()
        }
    }

    /// y of a state.
    pub(crate) fn y(&self, state: &Rotation) -> [f64; 3] {
        state.angular_velocity.component_mul(&self.0).into()
    }
}

/// The start of B5.
pub(crate) const B5: [f64; 3] = [0.0, 1.0, 1.0];
/// The end of B5 from Algorithm 648.
pub(crate) const B5_END: [f64; 3] = [
    -9.396570798729192e-1,
    -3.421177754000779e-1,
    7.414126596199957e-1,
];
/// The end of B5 by sn, cn and dn in 25 digits.
pub(crate) const B5_EXACT: [f64; 3] = [
    -0.9396570798729203961884362,
    -0.3421177754000749065348221,
    0.7414126596199953007825587,
];
/// The end of the undriven body, in 40 digits, rounded.
pub(crate) const FREE_EXACT: [f64; 3] = [
    0.60620385396481222179,
    0.62874721045017797037,
    0.80738514857560257554,
];
/// The start of the others.
pub(crate) const Y: [f64; 3] = [1.0, 0.0, 0.9];

/// The end of a driven body, which is pushed and released in turns, from zero to each of the times
/// \[s\].
///
/// # Errors
/// None of this body.
pub(crate) fn driven(turns: &[(f64, f64)]) -> Result<Rotation, IntegrationError<Rotation>> {
    let body = Driven::default();
    let start = (0.0, Scales::others().state(Y));
    let end = turns
        .iter()
        .try_fold(start, |(time, state), &(push, until)| {
            let motion = body.integrate(&state).starting_at(time);
            let motion = motion.input(DrivenInput { push }).tolerance(1e-15);
            Ok((until, motion.to(until)?))
        });
    end.map(|(_, state)| state)
}

fn print(name: &str, ours: [f64; 3], known: [f64; 3]) {
    println!("  {name}");
    for (place, (ours, known)) in ours.iter().zip(known).enumerate() {
        let off = ours - known;
        println!(
            "    y{} {ours:>22.16} {known:>22.16} {off:>10.1e}",
            place + 1
        );
    }
}

fn main() -> Result<(), IntegrationError<Rotation>> {
    println!("ends: ours, known, difference");
    let (body, scales) = (Detest::default(), Scales::detest());
    let start = scales.state(B5);
    print(
        "DETEST B5, closed form; sn, cn, dn in 25 digits",
        scales.y(&body.flow(&start, 20.0)),
        B5_EXACT,
    );
    let series = body
        .integrate(&start)
        .method(TaylorSeries { tolerance: 1e-15 });
    let series = scales.y(&series.to(20.0)?);
    print("DETEST B5, Taylor series; the same", series, B5_EXACT);
    print(
        "DETEST B5, Taylor series; published, Algorithm 648",
        series,
        B5_END,
    );

    let (body, scales) = (Turning::default(), Scales::others());
    let start = scales.state(Y);
    print(
        "rigid body, closed form; 40 digits, rounded",
        scales.y(&body.flow(&start, 20.0)),
        FREE_EXACT,
    );
    print(
        "rigid body of SciMLBenchmarks, Taylor series; 40 digits, rounded",
        scales.y(&driven(&[(1.0, 10.0)])?),
        [
            -0.66886242298013430157,
            -0.58769840220406839503,
            2.0107773930736108212,
        ],
    );
    let turns = [(0.0, 3.0 * PI), (1.0, 4.0 * PI), (0.0, 20.0)];
    print(
        "EULR, Taylor series in three parts; 40 digits, rounded",
        scales.y(&driven(&turns)?),
        [
            0.98779456034043677012,
            0.12314094201829062261,
            1.2625251695848045456,
        ],
    );
    Ok(())
}
