//! A cylinder on an incline, in both modes of contact: it starts sliding, and rolls once friction
//! has spun it up.
//!
//! World x points down the slope, y away from it. Each mode has its own description. In sticking,
//! the contact has zero velocity and friction is a second unknown; in slipping, friction is a given
//! multiple of the normal force. Both have the same state, so a program can change from one to the
//! other. Sticking needs friction within the cone, |T| <= mu N, and contact needs a normal force
//! that pushes, N > 0; `reactions` gives both.
//!
//! Asserts: accelerations and the time of sliding against their closed forms; the constraints after
//! 100 000 steps.

use newton_euler::{integrate, prelude::*};

rigid_body!(Sticking {
    doc: "A cylinder that rolls down an incline.",
    motion: planar,
    params: [radius = 0.22[m], slope = 0.3[rad]],
    mass: 8.5[kg],
    inertia: 0.75 * mass * radius.powi(2),
    points: [contact = G - radius * world(0, 1)],
    fields: [weight = mass * 9.80665[m / s ^ 2] * world(slope.sin(), -slope.cos())],
    constraints: [
        touching = position.in_world().y - radius,
        rolling = contact.velocity().in_world().x,
    ],
    reactions: [
        normal = world(0, _).at(contact),
        friction = world(_, 0).at(contact)
    ],
    outputs: [reactions, energy],
});

rigid_body!(Slipping {
    doc: "The same cylinder, sliding down.",
    motion: planar,
    params: [radius = 0.22[m], slope = 0.3[rad], mu = 0.2],
    mass: 8.5[kg],
    inertia: 0.75 * mass * radius.powi(2),
    points: [contact = G - radius * world(0, 1)],
    fields: [weight = mass * 9.80665[m / s ^ 2] * world(slope.sin(), -slope.cos())],
    constraints: [touching = position.in_world().y - radius],
    reactions: [
        normal = world(0, _).at(contact),
        friction = world(-mu * normal.in_world().y, 0).at(contact),
    ],
    outputs: [reactions, energy],
});

const MU: f64 = 0.2;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (sticking, slipping) = (Sticking::default(), Slipping::default());
    println!("{}\n", Slipping::EQUATIONS);
    let down = 9.80665 * 0.3_f64.sin();
    let across = 9.80665 * 0.3_f64.cos();

    // starts at 1.5 m/s without spin, a little too high: the projection moves it onto the slope
    let mut state = Planar {
        position: [0.0, 0.23].into(),
        velocity: [1.5, 0.0].into(),
        ..Planar::default()
    };
    let [touching] = slipping.violations(0.0, &state, &());
    println!(
        "`{}` is off by {:.3} m",
        touching.name,
        touching.position.unwrap_or(0.0)
    );
    slipping.project(0.0, &mut state, &())?;

    // it slides as long as the contact point moves: until v + r w = 0
    let loss = -(down - MU * across) + MU * across / 0.75;
    let sliding = 1.5 / loss;
    state = integrate::cf4_projected(&slipping, &state, &(), 0.0..sliding, 100)?;
    let slip = state.velocity.x + 0.22 * state.angular_velocity;
    println!("slides for {sliding:.6} s, and then slips by {slip:.1e} m/s");

    // it can stick if the required friction is within the cone
    let reactions = sticking.reactions(sliding, &state, &())?;
    let (normal, friction) = (reactions.normal.y, reactions.friction.x);
    println!(
        "sticking takes {:.6} N of {:.6} N: {}",
        friction.abs(),
        MU * normal,
        if friction.abs() <= MU * normal {
            "it rolls"
        } else {
            "it slides on"
        },
    );
    let least = 0.3_f64.tan() * 0.75 / 1.75;
    println!(
        "least mu {:.12}, in closed form {least:.12}",
        friction.abs() / normal
    );
    let acceleration = sticking.acceleration(sliding, &state, &()).linear.x;
    println!(
        "it rolls with {acceleration:.12} m/s², in closed form {:.12} m/s²",
        down / 1.75
    );

    let energy = |state: &Planar| {
        sticking.kinetic_energy(state) + sticking.potential_energy(0.0, state, &())
    };
    let before = energy(&state);
    let end = integrate::cf4_projected(&sticking, &state, &(), sliding..10.0, 100_000)?;
    println!(
        "\n             {:>12} {:>16} {:>12}",
        "distance/m", "energy/J", "speed/(m/s)"
    );
    for (name, state) in [("at first", &state), ("after 10 s", &end)] {
        println!(
            "  {name:<11}{:>12.6} {:>16.9} {:>12.6}",
            state.position.x,
            energy(state),
            state.velocity.x
        );
    }
    println!("energy changed by {:.1e} J", energy(&end) - before);
    for violation in sticking.violations(10.0, &end, &()) {
        let place = violation
            .position
            .map_or_else(|| "-".to_owned(), |gap| format!("{gap:.1e} m"));
        println!(
            "  {:<9} {place}, {:.1e} m/s",
            violation.name, violation.velocity
        );
    }
    Ok(())
}
