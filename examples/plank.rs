//! A thrown plank in its plane: three equations, and a closed form for all of them.
//!
//! World x is horizontal, y up; the angle is counterclockwise from world x to the plank's x axis,
//! which is along it. A uniform bar of length 2.4 m and height 0.2 m; no air, so the weight is the
//! only load.
//!
//! Asserts: G moves on a parabola while the plank rotates uniformly; energy and the angular
//! momentum about G are conserved; about the hand that threw it, dL/dt is the moment of the weight.

use newton_euler::nalgebra::{Rotation2, Vector2};
use newton_euler::{integrate, prelude::*};

rigid_body!(Plank {
    doc: "A plank thrown in its plane.",
    motion: planar,
    params: [length = 2.4[m], height = 0.2[m]],
    mass: 6[kg],
    inertia: mass * (length.powi(2) + height.powi(2)) / 12,
    points: [hand = world(0, 1.5)[m]],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    pole: hand,
    outputs: [energy, momentum, balance],
});

fn main() {
    let plank = Plank::default();
    let start = Planar {
        position: Vector2::new(0.0, 1.5),
        angle: 0.3,
        velocity: Vector2::new(4.0, 7.0),
        angular_velocity: -5.0,
    };
    println!("{}\n", Plank::EQUATIONS);
    for skipped in Plank::SKIPPED {
        println!("skipped: {skipped}");
    }

    println!(
        "\n  t/s   x/m       y/m       angle/rad  end of the plank/m    off the closed form/m"
    );
    let tip = Vector2::new(1.2, 0.0);
    let mut state = start;
    for k in 1..=6_u32 {
        let time = f64::from(k) * 0.25;
        state = integrate::cf4(&plank, &state, &(), time - 0.25..time, 25);
        let end = state.position + Rotation2::new(state.angle) * tip;

        let fallen = Vector2::new(0.0, -9.80665) * (0.5 * time * time);
        let parabola = start.position + start.velocity * time + fallen;
        let expected = parabola + Rotation2::new(0.3 - 5.0 * time) * tip;
        println!(
            "  {time:.2}  {:.6}  {:.6}  {:+.6}  {:+.6} {:+.6}   {:.1e}",
            state.position.x,
            state.position.y,
            state.angle,
            end.x,
            end.y,
            (end - expected).norm(),
        );
    }

    let energy =
        |state: &Planar| plank.kinetic_energy(state) + plank.potential_energy(0.0, state, &());
    println!("\n                               at the start     after 1.5 s");
    println!(
        "energy / J                     {:.9}    {:.9}",
        energy(&start),
        energy(&state)
    );
    println!(
        "angular momentum about G       {:.9}    {:.9}",
        plank.angular_momentum(&start),
        plank.angular_momentum(&state),
    );

    // About the fixed hand: L(t) - L(0) = ∫ -m g (x - x_hand) dt = -m g v_x t² / 2.
    let about_hand = |state: &Planar| plank.angular_momentum_about_pole(0.0, state);
    println!(
        "about the hand it changes by   {:.9}, moment of the weight times time {:.9}",
        about_hand(&state) - about_hand(&start),
        -6.0 * 9.80665 * 4.0 * 1.5 * 1.5 / 2.0,
    );
    let residual = plank.residual(1.5, &state, &plank.acceleration(1.5, &state, &()), &(), &());
    println!(
        "residual of (1.3) and (1.4)    {:.1e} N, {:.1e} N m",
        residual.force.norm(),
        residual.moment.abs()
    );
}
