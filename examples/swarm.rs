//! A thousand small satellites leave their deployer, each with its own mass distribution and
//! tumble, and rotate for ten minutes in the gravity gradient of the Earth.
//!
//! The body is generic over its scalar, so an ensemble computes as many of them at once as fit into
//! a register. Afterwards each member is identical to a body integrated alone, to the bit, and the
//! conserved quantity is unchanged: no torque acts along the orbit's normal.

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::integrate::{DormandPrince8, Fixed};
use newton_euler::{Dual, ensemble::Ensemble, prelude::*, state::generic};

rigid_body!(CubeSat::<T> {
    doc: "A 3U CubeSat in the gravity gradient of a circular orbit, against axes that do not turn.",
    motion: rotation,
    params: [
        // about the long axis x, and the asymmetry about it
        along = 0.007[kg * m ^ 2],
        uneven = 0.0004[kg * m ^ 2],
        // 3 GM / R^3 at 500 km
        gradient = 3.673e-6[1 / s ^ 2],
        // toward the Earth
        nadir = world(0, 0, -1),
    ],
    inertia: tensor {
        xx: along,
        yy: 0.041[kg * m ^ 2],
        zz: 0.042[kg * m ^ 2],
        xy: uneven,
        yz: 0,
        zx: 0,
    },
    locals: [
        down = nadir.in_body(),
        moment_x = along * down.x + uneven * down.y,
        moment_y = uneven * down.x + 0.041[kg * m ^ 2] * down.y,
        moment_z = 0.042[kg * m ^ 2] * down.z,
    ],
    moments: [gravity = gradient * nadir.cross(body(moment_x, moment_y, moment_z))],
    outputs: [energy, momentum],
});

/// Numbers spread evenly between -1 and 1.
fn spread(index: u32, irrational: f64) -> f64 {
    2.0 * (f64::from(index) * irrational).fract() - 1.0
}

fn main() {
    let member = |i: u32| {
        let params = CubeSatParams {
            along: 0.007 + 0.0005 * spread(i, 2.0_f64.sqrt()),
            uneven: 0.0008 * spread(i, 3.0_f64.sqrt()),
            ..CubeSatParams::default()
        };
        let tumble = [5.0, 7.0, 11.0].map(|square: f64| 0.05 * spread(i, square.sqrt()));
        let tilt = Vector3::new(0.0, 0.2 * spread(i, 13.0_f64.sqrt()), 0.0);
        let state = Rotation {
            attitude: UnitQuaternion::from_scaled_axis(tilt),
            angular_velocity: tumble.into(),
        };
        (params, state)
    };
    let mut swarm =
        Ensemble::<CubeSat<f64>>::with_params((0..1000).map(member)).expect("possible bodies");
    println!(
        "{} CubeSats, {} at a time",
        swarm.len(),
        swarm.width().lanes()
    );

    let duration = 600.0;
    let steps = Fixed {
        method: DormandPrince8,
        step: 1.0,
    };
    let arrived = swarm.integrate().method(steps).to(duration);
    arrived.expect("a tumble is finite");

    // identical to bodies integrated alone
    for index in [0, 1, 500, 999] {
        let (params, start) = member(index);
        let alone = CubeSat::new(params).expect("a possible body");
        let end = alone.integrate(&start).method(steps).to(duration);
        assert_eq!(Ok(swarm.state(index as usize)), end);
    }

    // the gradient has no moment about the vertical
    let mut worst = 0.0_f64;
    for index in 0..1000 {
        let (_, start) = member(index);
        let body = swarm.body(index as usize);
        let [before, after] =
            [start, swarm.state(index as usize)].map(|state| body.angular_momentum(&state));
        worst = worst.max((after.z - before.z).abs() / before.norm());
    }
    println!("angular momentum about the vertical: changed by at most {worst:.1e} of its size");
    assert!(worst < 1e-13);

    // the derivative of the first member's acceleration by a tilt, without finite differences
    let tilted = |angle: Dual<f64, 1>| {
        let half = angle * Dual::from(0.5);
        let (sine, cosine) = newton_euler::Scalar::sin_cos(half);
        let mut state = generic::Rotation::<Dual<f64, 1>>::default();
        let attitude = nalgebra::Quaternion::new(cosine, Dual::default(), sine, Dual::default());
        state.attitude = nalgebra::Unit::new_unchecked(attitude);
        CubeSat::<Dual<f64, 1>>::default().acceleration(Dual::default(), &state, &())
    };
    let stiffness = tilted(Dual::variable(0.0, 0)).y.derivatives[0];
    println!("stiffness of small tilts about y: {stiffness:.3e} /s^2");
    let expected = -3.673e-6 * (0.007 - 0.042) / 0.041;
    assert!((stiffness / expected - 1.0).abs() < 1e-2, "{expected}");
}
