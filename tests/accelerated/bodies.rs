//! Bodies that move freely.

use nalgebra::{Matrix3, Matrix6, Vector2, Vector3, Vector6};
use newton_euler::integrate::DormandPrince;
use newton_euler::prelude::*;
use newton_euler::structure::Structured;

use crate::{Random, solve};

rigid_body!(Auv {
    motion: spatial,
    mass: 30.5[kg],
    inertia: tensor {
        xx: 0.177,
        yy: 3.45,
        zz: 3.45,
        xy: 0.01,
        yz: 0,
        zx: -0.02
    }[kg * m ^ 2],
    params: [surge = 0.93[kg], sway = 35.5[kg], roll = 0.0704[kg * m ^ 2]],
    inputs: [thrust[N], fin[N * m]],
    locals: [
        a = acceleration.in_body(),
        rate = angular_acceleration.in_body()
    ],
    forces: [
        propeller = body(thrust, 0, 0),
        buoyancy = world(0, 0, 2[N]),
        added_mass = -body(surge * a.x, sway * a.y, sway * a.z),
    ],
    moments: [
        steering = body(0, 0, fin),
        added_inertia = -body(
            roll * rate.x,
            4.88[kg * m ^ 2] * rate.y,
            4.88[kg * m ^ 2] * rate.z
        ),
    ],
    outputs: [balance, energy, taylor],
});

/// Fossen, (6.1): `(M_RB + M_A) v' = tau`, of a diagonal `M_A` in the axes of the body.
#[test]
fn a_diagonal_added_mass_is_added() {
    let (body, mut random) = (Auv::default(), Random(1));
    for _ in 0..50 {
        let (state, input) = (
            random.spatial(),
            AuvInput {
                thrust: 9.0,
                fin: 0.4,
            },
        );
        let found = body.acceleration(0.0, &state, &input);
        let (q, w) = (state.attitude, state.angular_velocity);
        let force = Vector3::x() * 9.0 + q.inverse() * Vector3::z() * 2.0;
        let expected = force.component_div(&Vector3::new(30.5 + 0.93, 66.0, 66.0));
        assert!((found.linear - q * expected).amax() < 1e-15);
        let inertia = Matrix3::new(0.177, 0.01, -0.02, 0.01, 3.45, 0.0, -0.02, 0.0, 3.45);
        let moment = Vector3::z() * 0.4 - w.cross(&(inertia * w));
        let added = Matrix3::from_diagonal(&Vector3::new(0.0704, 4.88, 4.88));
        let expected = (inertia + added).lu().solve(&moment).unwrap();
        assert!(
            (found.angular - expected).amax() < 1e-14 * (1.0 + expected.amax()),
            "{}",
            found.angular - expected
        );
        let residual = body.residual(0.0, &state, &found, &(), &input);
        assert!(residual.force.amax() + residual.moment.amax() < 1e-13);
        // a load that follows the acceleration is what it is in the motion that it makes
        let in_body = q.inverse() * found.linear;
        let list = body.loads(0.0, &state, &input);
        let added = list.iter().find(|load| load.name == "added_mass").unwrap();
        let expected = -in_body.component_mul(&Vector3::new(0.93, 35.5, 35.5));
        assert!((q.inverse() * added.force - expected).amax() < 1e-13);
    }
}

#[test]
fn series_and_runge_kutta_agree() {
    let (body, mut random) = (Whirl::default(), Random(2));
    let start = Rotation {
        angular_velocity: random.vector(),
        ..Rotation::default()
    };
    let by_series = body.integrate(&start).to(3.0).unwrap();
    let method = DormandPrince { tolerance: 1e-12 };
    let by_steps = body.integrate(&start).method(method).to(3.0).unwrap();
    let apart = by_series.angular_velocity - by_steps.angular_velocity;
    assert!(apart.amax() < 1e-10, "{apart}");
    assert!(by_series.attitude.angle_to(&by_steps.attitude) < 1e-10);
}

rigid_body!(Coupled {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(0.3, 0.5, 0.4)[kg * m ^ 2],
    points: [fin = (0.3, -0.2, 0.1)],
    params: [c = 1],
    locals: [
        a = acceleration.in_body(),
        r = angular_acceleration.in_body() * 1[m],
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [
        drag = -0.4[N * s / m] * velocity,
        // six columns of a matrix that is not symmetric
        first = -1[kg]
            * body(
                0.3 * a.x + 0.1 * a.y - 0.2 * a.z + 0.05 * r.x + 0.3 * r.y - 0.1 * r.z,
                0.2 * a.x + 0.7 * a.y + 0.1 * a.z - 0.4 * r.x + 0.1 * r.y + 0.2 * r.z,
                c * 0.1 * a.x - 0.3 * a.y + 0.9 * a.z + 0.2 * r.x - 0.2 * r.y + 0.1 * r.z
            ),
        at_fin = (-0.6[kg] * fin.acceleration()).at(fin),
    ],
    moments: [second = -1[kg * m]
        * body(
            0.05 * a.x + 0.2 * a.y + 0.1 * a.z + 0.6 * r.x - 0.1 * r.y + 0.05 * r.z,
            -0.3 * a.x + 0.1 * a.y + 0.2 * a.z + 0.1 * r.x + 0.8 * r.y + 0.1 * r.z,
            0.1 * a.x - 0.2 * a.y + 0.1 * a.z + c * 0.2 * r.x - 0.1 * r.y + 0.7 * r.z
        ),],
    outputs: [balance],
});

#[test]
fn a_full_matrix_and_a_point() {
    let added = Matrix6::new(
        0.3, 0.1, -0.2, 0.05, 0.3, -0.1, //
        0.2, 0.7, 0.1, -0.4, 0.1, 0.2, //
        0.1, -0.3, 0.9, 0.2, -0.2, 0.1, //
        0.05, 0.2, 0.1, 0.6, -0.1, 0.05, //
        -0.3, 0.1, 0.2, 0.1, 0.8, 0.1, //
        0.1, -0.2, 0.1, 0.2, -0.1, 0.7,
    );
    let (body, mut random) = (Coupled::default(), Random(3));
    for _ in 0..50 {
        let state = random.spatial();
        let (q, w) = (state.attitude, state.angular_velocity);
        let inertia = Matrix3::from_diagonal(&Vector3::new(0.3, 0.5, 0.4));
        let fin = Vector3::new(0.3, -0.2, 0.1);
        let expected = solve(|x: &Vector6<f64>| {
            let (a, rate) = (
                x.fixed_rows::<3>(0).into_owned(),
                x.fixed_rows::<3>(3).into_owned(),
            );
            let of_matrix = -added * x;
            let of_fin = (a + rate.cross(&fin) + w.cross(&w.cross(&fin))) * -0.6;
            let given = q.inverse() * (Vector3::z() * -2.0 * 9.81 - state.velocity * 0.4);
            let force = given + of_fin + of_matrix.fixed_rows::<3>(0);
            let moment = fin.cross(&of_fin) + of_matrix.fixed_rows::<3>(3);
            let (p, l) = (
                force - a * 2.0,
                moment - inertia * rate - w.cross(&(inertia * w)),
            );
            Vector6::new(p.x, p.y, p.z, l.x, l.y, l.z)
        });
        let found = body.acceleration(0.0, &state, &());
        let linear = q.inverse() * found.linear;
        assert!((linear - expected.fixed_rows::<3>(0)).amax() < 2e-13);
        assert!((found.angular - expected.fixed_rows::<3>(3)).amax() < 2e-13);
        let residual = body.residual(0.0, &state, &found, &(), &());
        assert!(residual.force.amax() + residual.moment.amax() < 1e-13);
    }
}

rigid_body!(Aircraft {
    motion: spatial,
    mass: 12[kg],
    inertia: tensor {
        xx: 0.8,
        yy: 1.1,
        zz: 1.7,
        xy: 0,
        yz: 0,
        zx: 0.12
    }[kg * m ^ 2],
    params: [lag = 0.6[N * s], damping = 0.9[N * m * s]],
    locals: [
        air = velocity.in_body(),
        slip = (acceleration - angular_velocity.cross(velocity)).in_body(),
        alpha = air.z.atan2(air.x),
        alpha_rate = (air.x * slip.z - air.z * slip.x) / (air.x.powi(2) + air.z.powi(2)),
    ],
    forces: [lift = body(0, 0, -20[N] * alpha - lag * alpha_rate)],
    moments: [pitching = body(0, -3[N * m] * alpha - damping * alpha_rate, 0)],
    outputs: [balance, energy, linearization],
});

#[test]
fn the_rate_of_the_angle_of_attack() {
    let (body, mut random) = (Aircraft::default(), Random(4));
    for _ in 0..50 {
        let state = random.spatial();
        let (q, w, v) = (state.attitude, state.angular_velocity, state.velocity);
        let inertia = Matrix3::new(0.8, 0.0, 0.12, 0.0, 1.1, 0.0, 0.12, 0.0, 1.7);
        let air = q.inverse() * v;
        let alpha = air.z.atan2(air.x);
        let expected = solve(|x: &Vector6<f64>| {
            let (a, rate) = (
                x.fixed_rows::<3>(0).into_owned(),
                x.fixed_rows::<3>(3).into_owned(),
            );
            let slip = a - w.cross(&air);
            let by = (air.x * slip.z - air.z * slip.x) / (air.x * air.x + air.z * air.z);
            let p = Vector3::z() * (-20.0 * alpha - 0.6 * by) - a * 12.0;
            let moment = Vector3::y() * (-3.0 * alpha - 0.9 * by);
            let l = moment - inertia * rate - w.cross(&(inertia * w));
            Vector6::new(p.x, p.y, p.z, l.x, l.y, l.z)
        });
        let found = body.acceleration(0.0, &state, &());
        let linear = q.inverse() * found.linear;
        assert!((linear - expected.fixed_rows::<3>(0)).amax() < 1e-12);
        assert!((found.angular - expected.fixed_rows::<3>(3)).amax() < 1e-12);
    }
}

rigid_body!(Bubble {
    motion: translation,
    mass: 0.001[kg],
    forces: [lift = world(0, 0, 12[N]), added = -0.6[kg] * acceleration,],
});

rigid_body!(Puck {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    points: [edge = (0.2, 0.1)],
    forces: [
        push = body(1[N], 2[N]),
        dragged = (-0.5[kg] * edge.acceleration()).at(edge),
    ],
    moments: [twisted = -0.2[kg * m ^ 2] * angular_acceleration],
});

#[test]
fn without_attitude_and_in_the_plane() {
    let found = Bubble::default().acceleration(0.0, &Translation::default(), &());
    assert!((found - Vector3::z() * (12.0 / 0.601)).amax() < 1e-14);

    let (body, mut random) = (Puck::default(), Random(5));
    for _ in 0..20 {
        let state = Planar {
            position: random.vector(),
            angle: random.next(),
            velocity: random.vector(),
            angular_velocity: random.next(),
        };
        let (w, turned) = (
            state.angular_velocity,
            nalgebra::Rotation2::new(state.angle),
        );
        let edge = turned * Vector2::new(0.2, 0.1);
        let expected = solve(|x: &Vector3<f64>| {
            let of_edge = Vector2::new(x.x - x.z * edge.y, x.y + x.z * edge.x) - edge * w * w;
            let dragged = of_edge * -0.5;
            let force = turned * Vector2::new(1.0, 2.0) + dragged - x.xy() * 2.0;
            let moment = edge.perp(&dragged) - 0.2 * x.z - 0.3 * x.z;
            Vector3::new(force.x, force.y, moment)
        });
        let found = body.acceleration(0.0, &state, &());
        assert!((found.linear - expected.xy()).amax() < 1e-14);
        assert!((found.angular - expected.z).abs() < 1e-14);
    }
}

rigid_body!(Whirl {
    motion: rotation,
    inertia: principal(2, 2, 3)[kg * m ^ 2],
    moments: [following = -0.5[kg * m ^ 2] * angular_acceleration],
    outputs: [energy, taylor],
});

/// A moment that follows the acceleration is one: nothing is claimed of free rotation.
#[test]
fn claims() {
    let whirl = Whirl::STRUCTURE;
    assert!(!whirl.is_torque_free);
    let (body, state) = (
        Whirl::default(),
        Rotation {
            angular_velocity: Vector3::new(0.4, -0.3, 2.0),
            ..Rotation::default()
        },
    );
    let found = body.acceleration(0.0, &state, &());
    // (2 + 0.5) w_x' = (2 - 3) w_y w_z
    let by_hand = Vector3::new(-1.0 * -0.3 * 2.0, 2.0 * 0.4, 0.0) / 2.5;
    assert!((found - by_hand).amax() < 1e-15);
}
