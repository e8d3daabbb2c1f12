//! A T-handle that flips about its intermediate axis: the effect seen by V. A. Dzhanibekov in orbit
//! in 1985.
//!
//! The handle consists of two thin rods: the stem along x, about which it is spun, and the bar
//! across its end along y. The origin is G; there is no load, so `motion: rotation` suffices. It is
//! flat, so the moment about z is the sum of the other two; the one about the stem is the
//! intermediate one.
//!
//! Asserts: half-turns follow each other at half the period of Jacobi's elliptic functions, from
//! Euler's solution with the arithmetic-geometric mean; the same formula gives the published
//! 39.105734197268720854 for J = (1, 2, 3), ω = (0.01, 1, 0.01). `outputs: [flow]` gives the whole
//! motion in closed form, at the ends of steps and at any other time.
//!
//! `cargo run --release --example t_handle -- motion.html` makes a page that shows the motion.

use std::f64::consts::PI;

use newton_euler::nalgebra::Vector3;
use newton_euler::pictures::{Page, Solid};
use newton_euler::{integrate, prelude::*};

rigid_body!(Handle {
    doc: "A T-handle of two thin rods, from its measures; x along the stem.",
    motion: rotation,
    params: [
        bar = 0.060[kg],
        stem = 0.030[kg],
        bar_length = 100[mm],
        stem_length = 60[mm],
    ],
    locals: [
        reduced = bar * stem / (bar + stem),
        about_x = bar * bar_length.powi(2) / 12,
        about_y = stem * stem_length.powi(2) / 12 + reduced * (stem_length / 2).powi(2),
    ],
    inertia: principal(about_x, about_y, about_x + about_y),
    outputs: [energy, momentum, flow],
});

/// The period of ω in body axes: 4 K(k) over the rate of the elliptic argument, from Euler's
/// solution (Landau & Lifshitz, § 37). Moments ascending. The solution uses the square of the
/// angular momentum minus twice the energy times a moment, which is summed without cancellation.
fn period(moments: [f64; 3], angular_velocity: [f64; 3]) -> f64 {
    let excess = |i: usize| -> f64 {
        let terms = moments.iter().zip(&angular_velocity);
        terms.map(|(j, w)| j * (j - moments[i]) * w * w).sum()
    };
    // the axis that ω circles is that of the largest or of the smallest moment
    let (from, to) = if excess(1) > 0.0 { (0, 2) } else { (2, 0) };
    let scale = (moments[to] - moments[1]) * excess(from);
    let complement = (moments[to] - moments[from]) * excess(1) / scale; // 1 - k²
    let (mut mean, mut other) = (1.0, complement.sqrt());
    for _ in 0..8 {
        (mean, other) = (f64::midpoint(mean, other), (mean * other).sqrt());
    }
    // K = π / (2 agm(1, √(1 - k²)))
    2.0 * PI / mean * (moments.iter().product::<f64>() / scale).sqrt()
}

fn main() {
    let textbook = period([1.0, 2.0, 3.0], [0.01, 1.0, 0.01]);
    println!("J = (1, 2, 3), ω = (0.01, 1, 0.01): period {textbook:.13} s");
    println!("published (40-digit arithmetic):           39.1057341972687 s");

    let handle = Handle::default();
    let HandleParams {
        bar,
        stem,
        bar_length,
        stem_length,
    } = *handle.params();
    let about_stem = bar * bar_length.powi(2) / 12.0;
    let about_bar = stem * stem_length.powi(2) * (1.0 / 3.0 - stem / (4.0 * (bar + stem)));
    let moments = [about_bar, about_stem, about_bar + about_stem];
    let half = period(moments, [0.05, 12.0, 0.05]) / 2.0;
    println!("\nT-handle, 12 rad/s about its stem; J / kg m²:");
    println!(
        "  {about_stem:.3e} about it, {about_bar:.3e} the bar, {:.3e} z",
        moments[2]
    );
    println!("half of the period {half:.9} s\n\n  flip at/s    after the one before/s");

    let start = Rotation {
        angular_velocity: Vector3::new(12.0, 0.05, 0.05),
        ..Rotation::default()
    };
    let (mut state, mut last, step) = (start, f64::NAN, 1e-3);
    for k in 0..10_000_u32 {
        let time = f64::from(k) * step;
        let next = integrate::cf4_step(&handle, time, &state, &(), step);
        if state.angular_velocity.x * next.angular_velocity.x < 0.0 {
            // the spin passes through zero within this step: Newton's method
            let mut ahead = 0.5 * step;
            for _ in 0..4 {
                let there = integrate::cf4_step(&handle, time, &state, &(), ahead);
                let rate = handle.acceleration(time, &there, &()).x;
                ahead -= there.angular_velocity.x / rate;
            }
            let flip = time + ahead;
            if last.is_nan() {
                println!("  {flip:.9}");
            } else {
                println!("  {flip:.9}  {:.9}", flip - last);
            }
            last = flip;
        }
        state = next;
    }
    let path = handle.path(&start);
    let exact = path.at(10.0);
    let apart = (state.angular_velocity - exact.angular_velocity).norm() / 12.0;
    let turned = state.attitude.angle_to(&exact.attitude);
    println!(
        "\nclosed form: half of the period {:.9} s",
        path.period().unwrap() / 2.0
    );
    println!("after 10 s the steps are off it by {apart:.1e} in ω, {turned:.1e} rad in attitude");
    let century = path.at(3.156e9).angular_velocity;
    println!(
        "after a hundred years ω = ({:.3}, {:.3}, {:.3}) rad/s",
        century.x, century.y, century.z
    );

    let energy = handle.kinetic_energy(&state) / handle.kinetic_energy(&start) - 1.0;
    let [before, after] = [start, state].map(|state| handle.angular_momentum(&state));
    let turned = (after - before).norm() / before.norm();
    println!("\nrelative change in 10 s: energy {energy:.1e}, angular momentum {turned:.1e}");
    println!("\n{}", Handle::EQUATIONS);
    println!("\nWithout the products of ω, as (1.9) is printed, principal axes leave J ω̇ = 0:");
    println!("ω would keep its components in the body for ever, and the handle never flip.");

    if let Some(file) = std::env::args().nth(1) {
        let samples: Vec<_> = handle
            .integrate(&start)
            .samples(6.0, 0.02)
            .flatten()
            .collect();
        // the stem is half as heavy as the bar: G is a third of the way along it
        let [near, far] = [-stem_length / 6.0, stem_length * 5.0 / 6.0];
        let stem = Solid::bar([near, 0.0, 0.0], [far, 0.0, 0.0], 8e-3);
        let half = bar_length / 2.0;
        let bar = Solid::bar([near, -half, 0.0], [near, half, 0.0], 8e-3);
        let page = Page::of(&samples)
            .title("A T-handle that flips")
            .solid(stem.and(bar))
            .curves(&["angular_velocity"])
            .expect("a column of a rotation");
        page.speed(0.5).write(file).expect("a path to write to");
    }
}
