//! An underwater vehicle with its added mass, a full 6 x 6, and the moments that belong to it.
//!
//! Body x is forward, y left, z up, from the center of mass G; world z is up. The hull gives the
//! water a momentum p and a moment of momentum l about G, linear in velocity v and angular velocity
//! w of the body: (p, l) = A (v, w). The water pushes back with their rates (G. Kirchhoff, "Über
//! die Bewegung eines Rotationskörpers in einer Flüssigkeit", 1870), in body axes
//!
//! ```text
//! force -(p' + w x p)        moment -(l' + w x l + v x p)
//! ```
//!
//! The term v x p is Munk's moment, which turns a slender hull broadside. Numbers: those of
//! REMUS (T. Prestero, "Verification of a six-degree of freedom simulation model for the REMUS
//! autonomous underwater vehicle", 2001), taken about G; neutrally buoyant, without fins.
//!
//! Asserts: the speed follows U tanh(t / T); Munk's moment; without drag, energy and
//! momentum of body and water together are conserved.

use newton_euler::nalgebra::{Matrix6, Vector3, Vector6};
use newton_euler::prelude::*;

rigid_body!(Auv {
    doc: "A torpedo-shaped vehicle under water, its hull without fins.",
    motion: spatial,
    params: [
        surge = 0.93[kg],
        sway = 35.5[kg],
        roll = 0.0704[kg * m ^ 2],
        yaw = 4.88[kg * m ^ 2],
        across = 1.93[kg * m],
        drag = 1.62[kg / m],
    ],
    inputs: [thrust[N]],
    mass: 30.48[kg],
    inertia: principal(0.177, 3.45, 3.45)[kg * m ^ 2],
    locals: [
        v = velocity.in_body(),
        w = angular_velocity.in_body(),
        // the rates of both in body axes
        a = (acceleration - angular_velocity.cross(velocity)).in_body(),
        e = angular_acceleration.in_body(),
        p = body(surge * v.x, 0, 0) + sway * body(0, v.y, v.z) + across * body(0, -w.z, w.y),
        l = body(roll * w.x, 0, 0) + yaw * body(0, w.y, w.z) + across * body(0, v.z, -v.y),
        p_rate = body(surge * a.x, 0, 0) + sway * body(0, a.y, a.z) + across * body(0, -e.z, e.y),
        l_rate = body(roll * e.x, 0, 0) + yaw * body(0, e.y, e.z) + across * body(0, a.z, -a.y),
    ],
    forces: [
        propeller = body(thrust, 0, 0),
        hull = body(-drag * v.x * v.x.abs(), 0, 0),
        water = -(p_rate + angular_velocity.cross(p)),
    ],
    moments: [water_turns = -(l_rate + angular_velocity.cross(l) + velocity.cross(p))],
});

/// Energy of body and water, and their momentum in world axes.
fn whole(auv: &Auv, state: &Spatial) -> (f64, Vector3<f64>) {
    let across = auv.params().across;
    let own = Matrix6::from_diagonal(&[30.48, 30.48, 30.48, 0.177, 3.45, 3.45].into());
    let mut water = Matrix6::from_diagonal(&[0.93, 35.5, 35.5, 0.0704, 4.88, 4.88].into());
    for (row, column, coupling) in [(1, 5, -across), (2, 4, across)] {
        water[(row, column)] = coupling;
        water[(column, row)] = coupling;
    }
    let v = state.attitude.inverse() * state.velocity;
    let w = state.angular_velocity;
    let rates = Vector6::new(v.x, v.y, v.z, w.x, w.y, w.z);
    let momentum = (own + water) * rates;
    let linear = state.attitude * momentum.fixed_rows::<3>(0).into_owned();
    (0.5 * rates.dot(&momentum), linear)
}

/// Terminal speed, the moment of Munk, and the conserved quantities.
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let auv = Auv::default();
    println!("{}\n", Auv::EQUATIONS);

    let thrust = 3.86;
    let terminal = f64::sqrt(thrust / 1.62);
    let slow = (30.48 + 0.93) / f64::sqrt(thrust * 1.62);
    println!("  t/s   speed/(m/s)   U tanh(t / T), U = {terminal:.4} m/s, T = {slow:.3} s");
    for time in [5.0, 15.0, 45.0, 120.0] {
        let end = auv
            .integrate(&Spatial::default())
            .input(AuvInput { thrust })
            .to(time)?;
        let known = terminal * (time / slow).tanh();
        println!("  {time:5.1}   {:.9}   {known:.9}", end.velocity.x);
        assert!((end.velocity.x - known).abs() < 1e-8);
    }

    // (m + b) w' + c q' = 0, (J + d) q' + c w' = (b - a) u w: it pitches down, away from its
    // direction of motion
    let (ahead, up) = (1.5, 0.1);
    let drifting = Spatial {
        velocity: [ahead, 0.0, up].into(),
        ..Spatial::default()
    };
    let munk = (35.5 - 0.93) * ahead * up;
    let known = munk / (3.45 + 4.88 - 1.93 * 1.93 / (30.48 + 35.5));
    let found = auv
        .acceleration(0.0, &drifting, &AuvInput { thrust })
        .angular
        .y;
    println!(
        "\nat {ahead} m/s ahead, {up} m/s up: Munk {munk:.4} N m, q' {found:.6}, by hand {known:.6} rad/s^2"
    );
    assert!((found - known).abs() < 1e-14);

    let free = Auv::new(AuvParams {
        drag: 0.0,
        ..*auv.params()
    })?;
    let tumbling = Spatial {
        angular_velocity: [0.4, 0.1, -0.2].into(),
        ..drifting
    };
    let end = free.integrate(&tumbling).tolerance(1e-12).to(60.0)?;
    let [(before, way), (after, there)] = [&tumbling, &end].map(|state| whole(&free, state));
    let [energy, momentum] = [
        (after / before - 1.0).abs(),
        (there - way).norm() / way.norm(),
    ];
    println!(
        "a minute of tumbling changes energy by {energy:.0e}, momentum by {momentum:.0e} of it"
    );
    assert!(energy < 1e-9 && momentum < 1e-9);
    Ok(())
}
