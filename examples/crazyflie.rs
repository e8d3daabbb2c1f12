//! The Crazyflie 2.0 with its published full inertia: hover, then a yaw torque, which does not
//! cause yaw alone.
//!
//! Numbers: J. Förster, System identification of the Crazyflie 2.0 nano quadrocopter, bachelor's
//! thesis, ETH Zürich, 2015; the published off-diagonals are entries of the tensor. Mass and rotor
//! positions are those commonly used with it.
//!
//! Body axes: x forward, y left, z up, from G; world z is up. Rotors, seen from above: 1 front
//! right, 2 back right, 3 back left, 4 front left. Spin convention: 1 and 3 turn counterclockwise,
//! about +z, and the air turns the body about -z with their torque; 2 and 4 the other way. The
//! rotors' own angular momentum is neglected.
//!
//! Asserts: hover at m g / 4; a yaw torque causes roll and pitch too, by the inverse of the
//! published tensor; the energy gained is the work of the rotors; `residual` is zero on the motion.

use newton_euler::nalgebra::{Matrix3, Vector3};
use newton_euler::{integrate, prelude::*};

rigid_body!(Crazyflie {
    doc: "The Crazyflie 2.0; rotors 1 and 3 spin about +z.",
    motion: spatial,
    params: [torque_per_thrust = 0.005964552[m]],
    inputs: [thrust_1[N], thrust_2[N], thrust_3[N], thrust_4[N]],
    mass: 0.028[kg],
    inertia: tensor {
        xx: 1.657171e-5[kg * m ^ 2],
        yy: 1.6655602e-5[kg * m ^ 2],
        zz: 2.9261652e-5[kg * m ^ 2],
        xy: 8.30806e-7[kg * m ^ 2],
        yz: 1.800197e-6[kg * m ^ 2],
        zx: 7.18277e-7[kg * m ^ 2],
    },
    points: [
        front_right = (28.243, -28.325, 0)[mm],
        back_right = (-28.243, -28.325, 0)[mm],
        back_left = (-28.243, 28.325, 0)[mm],
        front_left = (28.243, 28.325, 0)[mm],
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        lift_1 = body(0, 0, thrust_1).at(front_right),
        lift_2 = body(0, 0, thrust_2).at(back_right),
        lift_3 = body(0, 0, thrust_3).at(back_left),
        lift_4 = body(0, 0, thrust_4).at(front_left),
    ],
    locals: [twist = thrust_2 + thrust_4 - thrust_1 - thrust_3],
    moments: [drag = body(0, 0, torque_per_thrust * twist)],
    outputs: [energy, balance],
});

const WEIGHT: f64 = 0.028 * 9.80665;

/// A quarter of the weight on each rotor, plus `more` on 2 and 4, minus `more` on 1 and 3.
fn yaw(more: f64) -> CrazyflieInput {
    let [less, more] = [WEIGHT / 4.0 - more, WEIGHT / 4.0 + more];
    CrazyflieInput {
        thrust_1: less,
        thrust_2: more,
        thrust_3: less,
        thrust_4: more,
    }
}

fn main() {
    let body = Crazyflie::default();
    let rest = Spatial::default();
    let still = body.acceleration(0.0, &rest, &yaw(0.0));
    println!("hover: {:.8} N on each rotor", WEIGHT / 4.0);
    println!("  acceleration of G {:.1e} m/s²", still.linear.norm());
    println!("  angular           {:.1e} rad/s²", still.angular.norm());

    let torque = body.params().torque_per_thrust * 4.0 * 0.005;
    let generated = body.acceleration(0.0, &rest, &yaw(0.005)).angular;
    #[rustfmt::skip]
    let published = Matrix3::new(
        16.57171, 0.830_806, 0.718_277,
        0.830_806, 16.655_602, 1.800_197,
        0.718_277, 1.800_197, 29.261_652,
    ) * 1e-6;
    let expected = published.try_inverse().expect("positive definite") * Vector3::z() * torque;
    println!("\nyaw torque of {:.5} mN m", torque * 1e3);
    println!("  generated   {generated:.9?} rad/s²");
    println!("  J⁻¹ M       {expected:.9?}");
    println!("  M_z / J_zz  {:.9}", torque / published.m33);

    let energy =
        |state: &Spatial| body.kinetic_energy(state) + body.potential_energy(0.0, state, &yaw(0.0));
    // The power of all loads except the weight.
    let rotors = |state: &Spatial, input: &CrazyflieInput| {
        let angular_velocity = state.attitude * state.angular_velocity;
        let all = body.applied(0.0, state, input);
        all.power(&state.velocity, &angular_velocity) + WEIGHT * state.velocity.z
    };
    println!("\nyaw for 0.5 s, back for 0.5 s, then hover thrust");
    println!("  t/s   yaw rate/(rad/s)  tilt/deg  energy/mJ      work of the rotors/mJ");
    let (mut state, mut work, mut largest, step) = (rest, 0.0, 0.0_f64, 1e-3);
    for k in 0..2000_u32 {
        let time = f64::from(k) * step;
        let input = yaw(match k {
            0..500 => 0.005,
            500..1000 => -0.005,
            _ => 0.0,
        });
        let acceleration = body.acceleration(time, &state, &input);
        let residual = body.residual(time, &state, &acceleration, &(), &input);
        largest = largest.max(residual.force.norm().max(residual.moment.norm()));

        let middle = integrate::cf4_step(&body, time, &state, &input, step / 2.0);
        let end = integrate::cf4_step(&body, time + step / 2.0, &middle, &input, step / 2.0);
        let [first, second, third] = [state, middle, end].map(|state| rotors(&state, &input));
        work += step / 6.0 * (first + 4.0 * second + third); // Simpson's rule
        state = end;
        if (k + 1) % 400 == 0 {
            let tilt = (state.attitude * Vector3::z()).z.acos().to_degrees();
            let (rate, energy, work) = (state.angular_velocity.z, energy(&state) * 1e3, work * 1e3);
            println!(
                "  {:.1}   {rate:+.9}      {tilt:7.4}   {energy:.9}    {work:.9}",
                time + step
            );
        }
    }
    println!("  largest residual of (1.3), (1.4): {largest:.1e} N or N m");
    println!("\n{}", Crazyflie::OPERATIONS[0]);
}
