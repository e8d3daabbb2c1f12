//! Bodies with every kind of motion: rows times parameters are the loads that Newton's and Euler's
//! laws require, at random states and accelerations.

use nalgebra::{Matrix3, SVector, UnitQuaternion, Vector2, Vector3};
use newton_euler::prelude::*;

use super::close;
use super::coordinates::Random;

rigid_body!(Craft {
    motion: spatial,
    params: [pull = world(0.3, -0.2, -9.7)[m / s ^ 2], load = 3.2[kg]],
    inputs: [thrust[N]],
    mass: load,
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: -0.12,
        yz: -0.05,
        zx: 0.07
    }[kg * m ^ 2],
    points: [nozzle = (-0.4, 0.1, 0)],
    fields: [weight = mass * pull],
    forces: [
        engine = body(thrust, 0, 0.5 * thrust).at(nozzle),
        drag = -0.2[kg / s] * velocity
    ],
    outputs: [regressor],
});

rigid_body!(Ball {
    motion: fixed_point(socket),
    inputs: [twist[N * m]],
    mass: 2[kg],
    inertia: tensor {
        xx: 0.3,
        yy: 0.5,
        zz: 0.4,
        xy: 0.02,
        yz: -0.03,
        zx: 0.04
    }[kg * m ^ 2],
    points: [socket = (0.1, -0.2, 0.4)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    moments: [motor = body(twist, 0, -twist)],
    outputs: [regressor],
});

rigid_body!(Door {
    motion: fixed_axis(hinge, world(1, 2, 2)),
    inputs: [push[N]],
    mass: 12[kg],
    inertia: cuboid(0.8, 0.04, 2),
    points: [hinge = (-0.4, 0, 0), handle = (0.35, 0.02, 0)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [hand = (push * body(0, 1, 0)).at(handle)],
    outputs: [regressor],
});

rigid_body!(Gyro {
    motion: rotation,
    inputs: [twist[N * m]],
    inertia: tensor {
        xx: 1,
        yy: 1.1,
        zz: 0.9,
        xy: 0.02,
        yz: -0.05,
        zx: 0.07
    }[kg * m ^ 2],
    moments: [motor = body(0, twist, 0)],
    outputs: [regressor],
});

rigid_body!(Plate {
    motion: planar,
    inputs: [push[N]],
    mass: 1.5[kg],
    inertia: 0.2[kg * m ^ 2],
    points: [corner = (0.3, 0.2)],
    fields: [
        weight = mass * world(0, -9.81[m / s ^ 2]),
        wind = mass * world(1[m / s ^ 3] * t, 0)
    ],
    forces: [hand = (push * body(1, 2)).at(corner)],
    outputs: [regressor],
});

rigid_body!(Bead {
    motion: translation,
    inputs: [push[N]],
    mass: 0.7[kg],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [hand = push * world(1, 2, 2)],
    outputs: [regressor],
});

rigid_body!(Stick {
    motion: rod(body(1, 0, 0)),
    inputs: [push[N]],
    mass: 0.7[kg],
    inertia: 0.05[kg * m ^ 2],
    points: [tip = (0.4, 0, 0)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [hand = (push * world(1, 2, 2)).at(tip)],
    outputs: [regressor],
});

fn tensor(entries: &[f64]) -> Matrix3<f64> {
    let [xx, yy, zz, xy, yz, zx] = entries else {
        panic!("six entries");
    };
    Matrix3::new(*xx, *xy, *zx, *xy, *yy, *yz, *zx, *yz, *zz)
}

/// `J w' + w x J w`
fn change(j: &Matrix3<f64>, w: Vector3<f64>, rate: Vector3<f64>) -> Vector3<f64> {
    j * rate + w.cross(&(j * w))
}

/// Force and moment about a point whose acceleration less that of free fall is `a`, body axes: with the
/// center of mass at c, and J about the point.
fn taken(
    parameters: &SVector<f64, 10>,
    a: Vector3<f64>,
    w: Vector3<f64>,
    rate: Vector3<f64>,
) -> [f64; 6] {
    let mass = parameters[0];
    let c = parameters.fixed_rows::<3>(1) / mass;
    let center = a + rate.cross(&c) + w.cross(&w.cross(&c));
    let about = tensor(&parameters.as_slice()[4..]);
    let j = about - mass * (c.norm_squared() * Matrix3::identity() - c * c.transpose());
    let (f, moment) = (mass * center, change(&j, w, rate));
    let n = moment + c.cross(&f);
    [f.x, f.y, f.z, n.x, n.y, n.z]
}

fn parameters(random: &mut Random) -> SVector<f64, 10> {
    let mut parameters = SVector::from_fn(|_, _| random.number());
    parameters[0] += 2.0;
    parameters
}

#[test]
fn in_space_the_columns_are_those_of_newton_and_euler() {
    let mut random = Random(1);
    for _ in 0..200 {
        let place = random.coordinates();
        let state = Spatial {
            position: place.position,
            attitude: place.attitude,
            velocity: place.velocity,
            angular_velocity: place.angular_velocity,
        };
        let given = SpatialAcceleration {
            linear: random.vector(5.0),
            angular: random.vector(5.0),
        };
        let input = CraftInput { thrust: 3.0 };
        let craft = Craft::default();
        let rows = craft.regressor(0.0, &state, &given, &input);
        // any mass properties, not those of the description alone
        let any = parameters(&mut random);
        let fall = Vector3::new(0.3, -0.2, -9.7);
        let a = state.attitude.inverse() * (given.linear - fall);
        let expected = taken(&any, a, state.angular_velocity, given.angular);
        close((rows * any).as_slice(), &expected, 1e-13);
        // and the loads, on a true motion
        let motion = craft.acceleration(0.0, &state, &input);
        let rows = craft.regressor(0.0, &state, &motion, &input);
        let found = rows * craft.inertial_parameters();
        let drag = state.attitude.inverse() * (-0.2 * state.velocity);
        let engine = Vector3::new(3.0, 0.0, 1.5);
        let n = Vector3::new(-0.4, 0.1, 0.0).cross(&engine);
        let f = engine + drag;
        close(found.as_slice(), &[f.x, f.y, f.z, n.x, n.y, n.z], 1e-13);
    }
    let own = Craft::default().inertial_parameters();
    let expected = [3.2, 0.0, 0.0, 0.0, 1.3, 1.7, 2.1, -0.12, -0.05, 0.07];
    assert_eq!(own.as_slice(), expected);
    let names = [
        "m", "m c_x", "m c_y", "m c_z", "J_xx", "J_yy", "J_zz", "J_xy", "J_yz", "J_zx",
    ];
    assert_eq!(Craft::PARAMETERS, names);
}

#[test]
fn about_a_point_that_is_held() {
    let mut random = Random(2);
    let down = Vector3::new(0.0, 0.0, -9.81);
    for _ in 0..200 {
        let place = random.coordinates();
        let (attitude, w) = (place.attitude, place.angular_velocity);
        let state = Rotation {
            attitude,
            angular_velocity: w,
        };
        let any = parameters(&mut random);
        let given = random.vector(5.0);
        let input = BallInput { twist: 1.4 };
        let ball = Ball::default();
        let rows = ball.regressor(0.0, &state, &given, &input);
        let expected = taken(&any, attitude.inverse() * -down, w, given);
        close((rows * any).as_slice(), &expected[3..], 1e-13);
        let motion = ball.acceleration(0.0, &state, &input);
        let rows = ball.regressor(0.0, &state, &motion, &input);
        close(
            (rows * ball.inertial_parameters()).as_slice(),
            &[1.4, 0.0, -1.4],
            1e-13,
        );
        let rows = Gyro::default().regressor(0.0, &state, &given, &GyroInput { twist: 1.0 });
        let six: SVector<f64, 6> = any.fixed_rows::<6>(4).into();
        let expected = change(&tensor(six.as_slice()), w, given);
        close((rows * six).as_slice(), expected.as_slice(), 1e-13);
    }
    let own = Ball::default().inertial_parameters();
    let c = [-0.1, 0.2, -0.4];
    close(&own.as_slice()[1..4], &c.map(|part| 2.0 * part), 1e-15);
    // the parallel axis theorem
    assert!((own[4] - (0.3 + 2.0 * (0.04 + 0.16))).abs() < 1e-15);
    assert!((own[7] - (0.02 + 2.0 * 0.1 * 0.2)).abs() < 1e-15);
    assert_eq!(
        Gyro::PARAMETERS,
        ["J_xx", "J_yy", "J_zz", "J_xy", "J_yz", "J_zx"]
    );
}

#[test]
fn about_a_hinge() {
    let mut random = Random(3);
    let axis = Vector3::new(1.0, 2.0, 2.0) / 3.0;
    let down = Vector3::new(0.0, 0.0, -9.80665);
    for _ in 0..200 {
        let place = random.coordinates();
        let state = Hinge {
            angle: place.angle,
            angular_velocity: place.velocity.x,
        };
        let any = parameters(&mut random);
        let rate = 5.0 * random.number();
        let input = DoorInput { push: 7.0 };
        let door = Door::default();
        let rows = door.regressor(0.0, &state, &rate, &input);
        let attitude = UnitQuaternion::from_scaled_axis(axis * state.angle);
        let w = axis * state.angular_velocity;
        let expected = taken(&any, attitude.inverse() * -down, w, axis * rate);
        let along = axis.dot(&Vector3::new(expected[3], expected[4], expected[5]));
        close((rows * any).as_slice(), &[along], 1e-13);
        let motion = door.acceleration(0.0, &state, &input);
        let rows = door.regressor(0.0, &state, &motion, &input);
        let pushed = Vector3::new(0.75, 0.02, 0.0).cross(&Vector3::new(0.0, 7.0, 0.0));
        let found = rows * door.inertial_parameters();
        close(found.as_slice(), &[axis.dot(&pushed)], 1e-13);
    }
}

#[test]
fn in_the_plane() {
    let mut random = Random(4);
    let plate = Plate::default();
    for _ in 0..200 {
        let place = random.coordinates();
        let state = Planar {
            position: place.position.xy(),
            angle: place.angle,
            velocity: place.velocity.xy(),
            angular_velocity: place.angular_velocity.z,
        };
        let given = PlanarAcceleration {
            linear: random.vector(5.0).xy(),
            angular: 2.0,
        };
        let (time, input) = (0.6, PlateInput { push: 1.3 });
        let rows = plate.regressor(time, &state, &given, &input);
        let turn = nalgebra::Rotation2::new(state.angle);
        let a = turn.inverse() * (given.linear - Vector2::new(time, -9.81));
        let (m, h, j) = (1.7, Vector2::new(0.4, -0.3), 0.9);
        let across = |v: Vector2<f64>| Vector2::new(-v.y, v.x);
        let f = m * a + across(h) * given.angular - h * state.angular_velocity.powi(2);
        let n = j * given.angular + h.perp(&a);
        let found = rows * SVector::from([m, h.x, h.y, j]);
        close(found.as_slice(), &[f.x, f.y, n], 1e-13);
        let motion = plate.acceleration(time, &state, &input);
        let rows = plate.regressor(time, &state, &motion, &input);
        let found = rows * plate.inertial_parameters();
        close(found.as_slice(), &[1.3, 2.6, 0.3 * 2.6 - 0.2 * 1.3], 1e-13);
    }
    assert_eq!(Plate::PARAMETERS, ["m", "m c_x", "m c_y", "J_zz"]);
}

#[test]
fn what_does_not_turn_and_what_is_thin() {
    let bead = Bead::default();
    let (state, input) = (Translation::default(), BeadInput { push: 1.2 });
    let motion = bead.acceleration(0.0, &state, &input);
    let rows = bead.regressor(0.0, &state, &motion, &input);
    let found = rows * bead.inertial_parameters();
    close(found.as_slice(), &[1.2, 2.4, 2.4], 1e-14);
    assert_eq!(Bead::PARAMETERS, ["m"]);

    let mut random = Random(5);
    let stick = Stick::default();
    for _ in 0..100 {
        let place = random.coordinates();
        let axis = place.attitude * Vector3::x_axis();
        let state = Rod {
            position: place.position,
            velocity: place.velocity,
            axis,
            axis_rate: axis.cross(&place.angular_velocity),
        };
        let input = StickInput { push: 1.2 };
        let motion = stick.acceleration(0.0, &state, &input);
        let rows = stick.regressor(0.0, &state, &motion, &input);
        let f = Vector3::new(1.2, 2.4, 2.4);
        let n = axis.cross(&f) * 0.4;
        let found = rows * stick.inertial_parameters();
        close(found.as_slice(), &[f.x, f.y, f.z, n.x, n.y, n.z], 1e-13);
        // with its center of mass at s along the axis: the law of that point
        let (m, s, j) = (1.3, 0.25, 0.3);
        let given = RodAcceleration {
            linear: random.vector(4.0),
            axis: axis.cross(&random.vector(3.0)) - *axis * state.axis_rate.norm_squared(),
        };
        let rows = stick.regressor(0.0, &state, &given, &input);
        let fall = Vector3::new(0.0, 0.0, -9.81);
        let f = m * (given.linear + s * given.axis - fall);
        let n = axis.cross(&(s * f)) + (j - m * s * s) * axis.cross(&given.axis);
        let found = rows * Vector3::new(m, m * s, j);
        close(found.as_slice(), &[f.x, f.y, f.z, n.x, n.y, n.z], 1e-13);
    }
    assert_eq!(Stick::PARAMETERS, ["m", "m c", "J"]);
}
