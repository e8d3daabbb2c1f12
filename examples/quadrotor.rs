//! A quadrotor, the body of the documentation of `rigid_body!`: hover, and a turn about the
//! vertical.
//!
//! Body axes: x forward, y left, z up, from the center of mass G; world z is up. Thrusts act along
//! body z. Rotors 1 and 3 spin about -z, so the air turns the body about +z with them; their own
//! angular momentum is neglected.
//!
//! Asserts: at hover nothing accelerates; a turn with the weight fully carried follows the closed
//! form angle = ½ α t²; with the rotors off, energy and angular momentum are conserved.

use newton_euler::{integrate, prelude::*};

rigid_body!(Quadrotor {
    doc: "A quadrotor in a plus configuration; rotors 1 and 3 spin about -z.",
    motion: spatial,
    params: [arm = 0.17[m], drag_ratio = 0.016[m]],
    inputs: [thrust_1[N], thrust_2[N], thrust_3[N], thrust_4[N]],
    mass: 1.2[kg],
    inertia: principal(0.0123, 0.0123, 0.0224)[kg * m ^ 2],
    points: [
        front = (arm, 0, 0),
        left = (0, arm, 0),
        back = (-arm, 0, 0),
        right = (0, -arm, 0),
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        lift_1 = body(0, 0, thrust_1).at(front),
        lift_2 = body(0, 0, thrust_2).at(left),
        lift_3 = body(0, 0, thrust_3).at(back),
        lift_4 = body(0, 0, thrust_4).at(right),
    ],
    locals: [twist = thrust_1 - thrust_2 + thrust_3 - thrust_4],
    moments: [drag = body(0, 0, drag_ratio * twist)],
    outputs: [energy, momentum],
});

fn thrusts([thrust_1, thrust_2, thrust_3, thrust_4]: [f64; 4]) -> QuadrotorInput {
    QuadrotorInput {
        thrust_1,
        thrust_2,
        thrust_3,
        thrust_4,
    }
}

fn main() {
    let quadrotor = Quadrotor::default();
    let rest = Spatial::default();

    println!("{}\n", Quadrotor::EQUATIONS);

    let hover = 1.2 * 9.80665 / 4.0;
    let still = quadrotor.acceleration(0.0, &rest, &thrusts([hover; 4]));
    println!("hover: {hover:.6} N on each rotor");
    println!("  acceleration of G {:.1e} m/s²", still.linear.norm());
    println!("  angular           {:.1e} rad/s²", still.angular.norm());

    // More on 1 and 3, less on 2 and 4: the weight is still carried, but the rotor drag does not
    // balance.
    let (more, less) = (hover + 0.05, hover - 0.05);
    let input = thrusts([more, less, more, less]);
    let turned = integrate::cf4(&quadrotor, &rest, &input, 0.0..2.0, 200);
    let rate = 0.016 * 0.2 / 0.0224;
    let angle = turned.attitude.scaled_axis().z;
    println!("\nturn of 2 s with 0.05 N more on 1 and 3, less on 2 and 4");
    println!("  angle {angle:.15} rad, ½ α t² = {:.15}", 2.0 * rate);
    println!("  G has moved {:.1e} m", turned.position.norm());

    let thrown = Spatial {
        velocity: [2.0, 0.0, 5.0].into(),
        angular_velocity: [3.0, -1.0, 8.0].into(),
        ..rest
    };
    let off = QuadrotorInput::default();
    let caught = integrate::cf4(&quadrotor, &thrown, &off, 0.0..1.0, 1000);
    let energy = |state: &Spatial| {
        quadrotor.kinetic_energy(state) + quadrotor.potential_energy(0.0, state, &off)
    };
    let change = quadrotor.angular_momentum(&caught) - quadrotor.angular_momentum(&thrown);
    println!("\nthrown with the rotors off, after 1 s");
    println!("  energy           {:.9} J", energy(&caught));
    println!("  it was           {:.9} J", energy(&thrown));
    println!(
        "  angular momentum has changed by {:.1e} kg m²/s",
        change.norm()
    );

    println!("\noperations");
    for operations in Quadrotor::OPERATIONS {
        println!("  {operations}");
    }
    println!("skipped");
    for skipped in Quadrotor::SKIPPED {
        println!("  {skipped}");
    }
}
