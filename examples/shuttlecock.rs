//! A shuttlecock in a side wind: drag behind the center of mass turns it cork first.
//!
//! Numbers: C. Cohen, B. Darbois Texier, D. Quéré, C. Clanet, The physics of badminton, New Journal
//! of Physics 17 (2015) 063001: 5 g, section 28 cm², drag coefficient 0.6, center of pressure about
//! 3 cm behind G. The inertia is an estimate from a cork of 3 g and a skirt of 2 g, 5 cm apart.
//!
//! Body x points from the skirt to the cork, with its origin in G; world z is up. The wind is the
//! velocity of the air in world axes. The drag acts at one point, against its velocity through the
//! air, at any attitude.
//!
//! Asserts: it ends cork down, moving with the wind and falling at √(2 m g / (ρ S C)); the energy
//! lost is the work of the drag; the drag acts on the axis and has no moment about it, so the spin
//! about it is constant.

use newton_euler::nalgebra::{UnitQuaternion, Vector3};
use newton_euler::{integrate, prelude::*};

rigid_body!(Shuttlecock {
    doc: "A shuttlecock, drag at its center of pressure; x points to the cork.",
    motion: spatial,
    params: [
        density = 1.2[kg / m ^ 3],
        section = 28[cm ^ 2],
        coefficient = 0.6
    ],
    inputs: [wind = world(_, _, _)[m / s]],
    mass: 5[g],
    inertia: principal(1.2e-6, 3.0e-6, 3.0e-6)[kg * m ^ 2],
    points: [pressure = (-30, 0, 0)[mm]],
    locals: [
        through_air = pressure.velocity() - wind,
        factor = density * section * coefficient / 2,
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [drag = (-factor * through_air.norm() * through_air).at(pressure)],
    outputs: [energy, balance],
});

/// Power of the drag, from the list of loads.
fn drag_power(body: &Shuttlecock, state: &Spatial, input: &ShuttlecockInput) -> f64 {
    let angular_velocity = state.attitude * state.angular_velocity;
    let loads = body.loads(0.0, state, input);
    let drag = loads
        .iter()
        .find(|load| load.name == "drag")
        .expect("it is declared");
    Wrench::from_force_at(drag.force, drag.point - state.position)
        .power(&state.velocity, &angular_velocity)
}

fn main() {
    let body = Shuttlecock::default();
    let input = ShuttlecockInput {
        wind: Vector3::new(2.0, 0.0, 0.0),
    };
    // Starts with the cork nearly up, the unstable attitude, spinning at 15 rad/s about its axis.
    let start = Spatial {
        position: Vector3::new(0.0, 0.0, 40.0),
        attitude: UnitQuaternion::from_scaled_axis(Vector3::new(0.0, -1.4, 0.0)),
        angular_velocity: Vector3::new(15.0, 0.0, 0.0),
        ..Spatial::default()
    };
    let energy =
        |state: &Spatial| body.kinetic_energy(state) + body.potential_energy(0.0, state, &input);

    println!(
        "  t/s   cork from straight down/deg   speed x, z/(m/s)      energy lost/J   taken by the drag/J"
    );
    let (mut state, mut work, step) = (start, 0.0, 2e-4);
    for k in 1..=25_000_u32 {
        let middle = integrate::cf4_step(&body, 0.0, &state, &input, step / 2.0);
        let end = integrate::cf4_step(&body, 0.0, &middle, &input, step / 2.0);
        let power = [state, middle, end].map(|state| drag_power(&body, &state, &input));
        work += step / 6.0 * (power[0] + 4.0 * power[1] + power[2]); // Simpson's rule
        state = end;
        if k % 2500 == 0 {
            let cork = state.attitude * Vector3::x();
            println!(
                "  {:.1}   {:26.4}   {:+.6} {:+.6}   {:.12}  {:.12}",
                f64::from(k) * step,
                (-cork.z).acos().to_degrees(),
                state.velocity.x,
                state.velocity.z,
                energy(&start) - energy(&state),
                -work,
            );
        }
    }
    let ShuttlecockParams {
        density,
        section,
        coefficient,
    } = *body.params();
    let terminal = (2.0 * 0.005 * 9.80665 / (density * section * coefficient)).sqrt();
    println!("\nterminal speed √(2 m g / (ρ S C)) = {terminal:.6} m/s, wind 2 m/s");
    println!(
        "spin about the axis: {:.12} rad/s at the start, {:.12} now",
        start.angular_velocity.x, state.angular_velocity.x
    );

    println!("\n{}\n", Shuttlecock::EQUATIONS);
    for operations in Shuttlecock::OPERATIONS {
        println!("{operations}");
    }
}
