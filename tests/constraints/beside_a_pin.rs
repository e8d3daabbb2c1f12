//! Bodies whose mass lies on one line, held at a point beside it: about this point, all axes have an
//! inertia. Compared with Newton's law of each point mass. Parameters that leave no inertia are refused.

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::body::Impossible;
use newton_euler::inertia::InvalidInertia;
use newton_euler::prelude::*;

rigid_body!(TwoPoints {
    params: [second = 2[kg]],
    motion: fixed_point(pin),
    points: [pin = (0.1, 0, 0), a = (1, 0, 0), b = (0, 1, 0.5)],
    inertia: compose([point(1[kg]).at(a), point(second).at(b)]),
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    reactions: [bearing = world(_, _, _).at(pin)],
    outputs: [energy, momentum, reactions],
});

rigid_body!(Slanted {
    motion: fixed_point(pin),
    points: [pin = (0.5, 0, 0.1)],
    mass: 3[kg],
    inertia: rod(2[m]),
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
});

/// Point masses and their places from the pin.
type Points<'a> = &'a [(f64, Vector3<f64>)];

fn start() -> Rotation {
    Rotation {
        attitude: UnitQuaternion::new([0.3, -0.8, 0.4].into()),
        angular_velocity: [0.5, -1.0, 2.0].into(),
    }
}

/// The sums of `m (a - g)` and of its moments about the pin, in body axes.
fn inertial(state: &Rotation, rate: Vector3<f64>, points: Points<'_>) -> [Vector3<f64>; 2] {
    let w = state.angular_velocity;
    let gravity = state.attitude.inverse() * Vector3::new(0.0, 0.0, -9.81);
    let forces = points.iter().map(|(mass, r)| {
        let force = (rate.cross(r) + w.cross(&w.cross(r)) - gravity) * *mass;
        (force, r.cross(&force))
    });
    forces.fold([Vector3::zeros(); 2], |[force, moment], (f, m)| {
        [force + f, moment + m]
    })
}

#[test]
fn two_points() {
    let state = start();
    let pin = Vector3::new(0.1, 0.0, 0.0);
    for second in [2.0, 0.3] {
        let points = [
            (1.0, Vector3::new(1.0, 0.0, 0.0) - pin),
            (second, Vector3::new(0.0, 1.0, 0.5) - pin),
        ];
        let body = TwoPoints::new(TwoPointsParams { second }).unwrap();
        let rate = body.acceleration(0.0, &state, &());
        let [force, moment] = inertial(&state, rate, &points);
        assert!(moment.norm() < 1e-13, "{moment}");
        let bearing = body.reactions(0.0, &state, &()).bearing;
        assert!((state.attitude * force - bearing).norm() < 1e-13);
        let energy =
            |state: &Rotation| body.kinetic_energy(state) + body.potential_energy(0.0, state, &());
        let end = body.integrate(&state).to(3.0).unwrap();
        assert!((energy(&end) - energy(&state)).abs() < 1e-7);
    }
}

/// A rod has the inertia of two points at `l / sqrt 12` from its middle.
#[test]
fn a_rod() {
    let state = start();
    let pin = Vector3::new(0.5, 0.0, 0.1);
    let half = Vector3::new(0.0, 0.0, 2.0 / 12.0_f64.sqrt());
    let points = [(1.5, half - pin), (1.5, -half - pin)];
    let rate = Slanted::default().acceleration(0.0, &state, &());
    let [_, moment] = inertial(&state, rate, &points);
    assert!(moment.norm() < 1e-13, "{moment}");
}

rigid_system!(Hung {
    params: [x = 0.5[m]],
    bodies: [ball {
        mass: 1[kg],
        inertia: principal(0, 0, 0)[kg * m ^ 2],
        points: [pin = (x, 0, 0)]
    },],
    joints: [hinge = revolute(world(0, 0, 0), ball.pin, world(0, 1, 0))],
});

rigid_body!(Bob {
    params: [x = 0.5[m]],
    motion: fixed_axis(pin, body(0, 1, 0)),
    points: [pin = (x, 0, 0)],
    inertia: compose([point(3[kg])]),
});

#[test]
fn without_inertia_about_what_holds_it() {
    let singular = InvalidBody::Inertia(InvalidInertia::Singular);
    let found = TwoPoints::new(TwoPointsParams { second: 0.0 }).err();
    assert_eq!(found, Some(singular));
    let found = Bob::new(BobParams { x: 0.0 }).err();
    assert_eq!(found, Some(InvalidBody::PlanarInertia { value: 0.0 }));
    let impossible = Impossible::PlanarInertia(0.0);
    let body = "ball";
    let found = Hung::new(HungParams { x: 0.0 }).err();
    assert_eq!(found, Some(InvalidBody::Member { body, impossible }));
}
