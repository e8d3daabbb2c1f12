//! Bodies that are held, and inverse dynamics.

use nalgebra::{Vector2, Vector3, Vector6};
use newton_euler::prelude::*;

use crate::{Random, solve};

rigid_body!(InWater {
    motion: fixed_axis(hinge, body(0, 1, 0)),
    mass: 2[kg],
    inertia: cuboid(0.1, 0.1, 0.8),
    points: [hinge = (0, 0, 0.4), bob = (0.1, 0, -0.3)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [added = (-1.5[kg] * bob.acceleration()).at(bob)],
    moments: [turned = -0.02[kg * m ^ 2] * angular_acceleration],
    reactions: [
        bearing = body(_, _, _).at(hinge),
        couple = moment(body(_, 0, _))
    ],
    outputs: [reactions, balance],
});

#[test]
fn a_pendulum_in_water() {
    let body = InWater::default();
    let state = Hinge {
        angle: 0.4,
        angular_velocity: 1.7,
    };
    let found = body.acceleration(0.0, &state, &());
    // (J + m c^2 + 1.5 r^2 + 0.02) w' = -m g c sin
    let inertia = 2.0 * (0.01 + 0.64) / 12.0 + 2.0 * 0.16;
    let r = Vector2::new(0.1_f64, -0.7);
    let expected = -2.0 * 9.81 * 0.4 * 0.4_f64.sin() / (inertia + 1.5 * r.norm_squared() + 0.02);
    assert!((found - expected).abs() < 1e-14, "{found} {expected}");
    let carried = body.reactions(0.0, &state, &());
    let residual = body.residual(0.0, &state, &found, &carried, &());
    assert!(residual.force.amax() + residual.moment.amax() < 1e-13);
    // the bearing carries the water with the body
    let q = nalgebra::Rotation3::from_axis_angle(&Vector3::y_axis(), 0.4);
    let (w, rate) = (Vector3::y() * 1.7, Vector3::y() * found);
    let of = |r: Vector3<f64>| rate.cross(&r) + w.cross(&w.cross(&r));
    let (center, bob) = (
        q * Vector3::new(0.0, 0.0, -0.4),
        q * Vector3::new(0.1, 0.0, -0.7),
    );
    let expected = of(center) * 2.0 + of(bob) * 1.5 + Vector3::z() * 2.0 * 9.81;
    assert!((carried.bearing - expected).amax() < 1e-13);
}

rigid_body!(Bead {
    motion: translation,
    mass: 0.5[kg],
    inputs: [push = world(_, _, _)[N]],
    forces: [
        pushed = push,
        added = -0.3[kg] * acceleration,
        friction = -0.2 * normal.in_world().z * world(1, 0, 0),
    ],
    constraints: [table = position.in_world().z - 0.1 * position.in_world().x],
    reactions: [normal = world(0, 0, _)],
    outputs: [reactions, balance],
});

/// What keeps it, friction that follows that, and the water, all at once.
#[test]
fn under_constraints() {
    let (body, mut random) = (Bead::default(), Random(7));
    let push: Vector3<f64> = random.vector();
    let input = BeadInput { push };
    let state = Translation::default();
    let expected = solve(|x: &nalgebra::Vector4<f64>| {
        let (a, n) = (x.xyz(), x.w);
        let force = push - a * 0.3 + Vector3::new(-0.2 * n, 0.0, n) - a * 0.5;
        nalgebra::Vector4::new(force.x, force.y, force.z, a.z - 0.1 * a.x)
    });
    let found = body.acceleration(0.0, &state, &input);
    assert!((found - expected.xyz()).amax() < 1e-14);
    let carried = body.reactions(0.0, &state, &input).unwrap();
    assert!((carried.normal.z - expected.w).abs() < 1e-14);
    let residual = body.residual(0.0, &state, &found, &carried, &input);
    assert!(residual.force.amax() < 1e-14);
}

rigid_body!(Wired {
    motion: spatial,
    mass: 1.5[kg],
    inertia: principal(0.2, 0.3, 0.4)[kg * m ^ 2],
    points: [eye = (0.2, 0.1, -0.1)],
    forces: [
        pull = world(1[N], 2[N], 3[N]),
        added = -0.7[kg] * body(acceleration.in_body().x, 0, 2 * acceleration.in_body().z),
    ],
    moments: [turned = -0.1[kg * m ^ 2] * angular_acceleration],
    constraints: [wire = eye.position().in_world().y],
    reactions: [normal = world(0, _, 0).at(eye)],
    outputs: [reactions, balance],
});

#[test]
fn a_body_on_a_wire() {
    let (body, mut random) = (Wired::default(), Random(8));
    for _ in 0..20 {
        let state = random.spatial();
        let (q, w) = (state.attitude, state.angular_velocity);
        let inertia = nalgebra::Matrix3::from_diagonal(&Vector3::new(0.2, 0.3, 0.4));
        let eye = Vector3::new(0.2, 0.1, -0.1);
        let expected = solve(|x: &nalgebra::SVector<f64, 7>| {
            let (a, rate) = (
                x.fixed_rows::<3>(0).into_owned(),
                x.fixed_rows::<3>(3).into_owned(),
            );
            let in_body = q.inverse() * a;
            let added = q * (Vector3::new(in_body.x, 0.0, 2.0 * in_body.z) * -0.7);
            let normal = Vector3::y() * x[6];
            let p = Vector3::new(1.0, 2.0, 3.0) + added + normal - a * 1.5;
            let l = eye.cross(&(q.inverse() * normal))
                - rate * 0.1
                - inertia * rate
                - w.cross(&(inertia * w));
            let of_eye = a + q * (rate.cross(&eye) + w.cross(&w.cross(&eye)));
            nalgebra::SVector::<f64, 7>::from_column_slice(&[
                p.x, p.y, p.z, l.x, l.y, l.z, of_eye.y,
            ])
        });
        let found = body.acceleration(0.0, &state, &());
        assert!((found.linear - expected.fixed_rows::<3>(0)).amax() < 1e-13);
        assert!((found.angular - expected.fixed_rows::<3>(3)).amax() < 1e-13);
        let carried = body.reactions(0.0, &state, &()).unwrap();
        assert!((carried.normal.y - expected[6]).abs() < 1e-13);
    }
}

rigid_body!(Pole {
    motion: rod(body(1, 0, 0)),
    mass: 1.2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [end = (0.5, 0, 0)],
    forces: [
        pull = world(0.3[N], -1[N], 2[N]).at(end),
        added = (-0.4[kg] * end.acceleration()).at(end),
    ],
});

#[test]
fn a_rod_in_water() {
    let (body, mut random) = (Pole::default(), Random(9));
    for _ in 0..20 {
        let axis = nalgebra::Unit::new_normalize(random.vector::<3>());
        let rate = random.vector::<3>().cross(&axis);
        let state = Rod {
            axis,
            axis_rate: rate,
            position: random.vector(),
            velocity: random.vector(),
        };
        let (u, n) = (axis.into_inner(), rate.norm_squared());
        let pull = Vector3::new(0.3, -1.0, 2.0);
        let expected = solve(|x: &Vector6<f64>| {
            let (a, bent) = (
                x.fixed_rows::<3>(0).into_owned(),
                x.fixed_rows::<3>(3).into_owned(),
            );
            let force = pull - (a + bent * 0.5) * 0.4;
            let p = force - a * 1.2;
            let k = (u * 0.5).cross(&force);
            let l = k.cross(&u) / 0.1 - u * n - bent;
            Vector6::new(p.x, p.y, p.z, l.x, l.y, l.z)
        });
        let found = body.acceleration(0.0, &state, &());
        assert!((found.linear - expected.fixed_rows::<3>(0)).amax() < 1e-14);
        let size = 1.0 + expected.amax();
        assert!((found.axis - expected.fixed_rows::<3>(3)).amax() < 1e-14 * size);
    }
}

rigid_body!(Steered {
    motion: spatial,
    mass: 30.5[kg],
    inertia: principal(0.2, 3.4, 3.5)[kg * m ^ 2],
    forces: [
        hull = -body(0, 0, 35[kg] * acceleration.in_body().z) - 3[N * s / m] * velocity,
        thrust = body(_, _, _),
    ],
    moments: [
        water = -4.9[kg * m ^ 2] * angular_acceleration,
        torque = body(_, _, _),
    ],
    outputs: [inverse, balance],
});

/// The drives make the water follow, too.
#[test]
fn inverse_dynamics() {
    let (body, mut random) = (Steered::default(), Random(10));
    for _ in 0..20 {
        let state = random.spatial();
        let given = SpatialAcceleration {
            linear: random.vector(),
            angular: random.vector(),
        };
        let (q, w) = (state.attitude, state.angular_velocity);
        let a = q.inverse() * given.linear;
        let inertia = nalgebra::Matrix3::from_diagonal(&Vector3::new(0.2, 3.4, 3.5));
        let drives = body.inverse(0.0, &state, &given, &());
        let force = a * 30.5 + Vector3::z() * 35.0 * a.z + q.inverse() * state.velocity * 3.0;
        let moment = inertia * given.angular + w.cross(&(inertia * w)) + given.angular * 4.9;
        assert!((drives.thrust - force).amax() < 1e-13);
        assert!((drives.torque - moment).amax() < 1e-13);
    }
}
