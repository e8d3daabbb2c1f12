//! Lagrange's top with its tip on the ground: steady precession, slow and fast, and the nutation of
//! a released top.
//!
//! Asserts: both steady motions agree with their closed form, and so does the force on the tip,
//! which is the weight plus `m l sin θ Ω²` towards the axis of precession. A released top nutates
//! between its first angle and the other root of a cubic for cos θ; the period is an elliptic
//! integral. Energy and the angular momenta about both axes are conserved.

use newton_euler::nalgebra::{UnitQuaternion, Vector3};
use newton_euler::top::{HeavyTop, SymmetricTop};
use newton_euler::{integrate, prelude::*};

const G: f64 = 9.80665;
const TILT: f64 = 0.6;
const SPIN: f64 = 180.0;

rigid_body!(Top {
    doc: "A symmetric top on its tip; z along its axis, moments of inertia about the tip.",
    motion: fixed_point(tip),
    params: [
        length = 0.06[m],
        across = 0.0021[kg * m ^ 2],
        along = 0.0009[kg * m ^ 2]
    ],
    mass: 0.4[kg],
    inertia: principal(across, across, along).about(tip),
    points: [tip = (0, 0, -length)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    reactions: [ground = world(_, _, _).at(tip)],
    outputs: [energy, momentum, reactions],
});

fn tilt(state: &Rotation) -> f64 {
    (state.attitude * Vector3::z()).z.acos()
}

/// Half the period of the nutation and the other angle, from `u = cos θ`: `u'² = (u₀ - u) (b (1 -
/// u²) - a² (u₀ - u))`, with `a = J₃ ω₃ / J₁` and `b = 2 m g l / J₁`, of a top let go at u₀.
fn nutation(a: f64, b: f64) -> (f64, f64) {
    let start = TILT.cos();
    // the roots of b (1 - u²) - a² (u₀ - u): one between -1 and 1, the other above 1
    let root = (a.powi(4) + 4.0 * b * (b - a * a * start)).sqrt();
    let (end, outer) = (
        2.0 * (a * a * start - b) / (a * a + root),
        (a * a + root) / (2.0 * b),
    );
    // 2 / √(b (outer - end)) K(k) with k² = (u₀ - end) / (outer - end)
    let (mut mean, mut other) = (1.0, ((outer - start) / (outer - end)).sqrt());
    for _ in 0..6 {
        (mean, other) = (f64::midpoint(mean, other), (mean * other).sqrt());
    }
    let half = std::f64::consts::PI / mean / (b * (outer - end)).sqrt();
    (half, end.acos())
}

fn main() {
    let top = Top::default();
    let TopParams {
        length,
        across,
        along,
    } = *top.params();
    let mass = 0.4;
    let about_tip = SymmetricTop::new(across, along).expect("moments of a top");
    let heavy = HeavyTop::new(about_tip, mass * G * length);
    let steady = heavy.steady_rates(TILT, SPIN).expect("fast enough");

    println!("spin {SPIN} rad/s, {TILT} rad from the vertical\n");
    println!(
        "precession/(rad/s)  angle after 1 s/rad   attitude off by  force on the tip/N: up, inwards (expected)"
    );
    for rate in [steady.slow, steady.fast.expect("not level")] {
        let motion = heavy.steady(TILT, SPIN, rate);
        let end = integrate::cf4(&top, &motion.at(0.0), &(), 0.0..1.0, 50_000);
        let error = motion.at(1.0).attitude.angle_to(&end.attitude);
        let force = top.reactions(1.0, &end, &()).ground;
        let outwards = end.attitude * Vector3::z() - Vector3::z() * TILT.cos();
        let inwards = -force.dot(&outwards.normalize());
        println!(
            "{rate:15.9}     {:.12}        {error:.1e}          {:.8}, {inwards:.8} ({:.8})",
            tilt(&end),
            force.z,
            mass * length * TILT.sin() * rate.powi(2)
        );
    }

    let start = Rotation {
        attitude: UnitQuaternion::from_axis_angle(&Vector3::x_axis(), TILT),
        angular_velocity: Vector3::new(0.0, 0.0, SPIN),
    };
    let (half, other) = nutation(along * SPIN / across, 2.0 * mass * G * length / across);
    println!("\nlet go: it nods to {other:.12} rad in {half:.12} s, and back (closed form)");
    let mut state = start;
    for half_periods in 1..=4 {
        state = integrate::cf4(&top, &state, &(), 0.0..half, 2000);
        let force = top.reactions(0.0, &state, &()).ground;
        println!(
            "  {half_periods} halves: {:.12} rad, force on the tip {:.6} N up",
            tilt(&state),
            force.z
        );
    }
    let energy = |state| top.kinetic_energy(state) + top.potential_energy(0.0, state, &());
    let arm = |state: &Rotation| state.attitude * Vector3::new(0.0, 0.0, length);
    let vertical = |state: &Rotation| {
        (top.angular_momentum(state) + arm(state).cross(&top.linear_momentum(state))).z
    };
    println!(
        "energy gained {:.1e} J, spin {:.1e} rad/s,",
        energy(&state) - energy(&start),
        state.angular_velocity.z - SPIN
    );
    println!(
        "vertical angular momentum {:.1e} J s\n\n{}",
        vertical(&state) - vertical(&start),
        Top::EQUATIONS
    );
}
