//! Steady motions and equilibria, compared with those found by hand.

use nalgebra::{UnitQuaternion, Vector2, Vector3};
use newton_euler::linearization::TrimError;
use newton_euler::prelude::*;

const G: f64 = 9.80665;

rigid_body!(Quadrotor {
    motion: spatial,
    inputs: [thrust_1[N], thrust_2[N], thrust_3[N], thrust_4[N]],
    mass: 0.5[kg],
    inertia: principal(2.3e-3, 2.3e-3, 4e-3)[kg * m ^ 2],
    points: [
        front = (0.17, 0, 0),
        left = (0, 0.17, 0),
        back = (-0.17, 0, 0),
        right = (0, -0.17, 0)
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        lift_1 = body(0, 0, thrust_1).at(front),
        lift_2 = body(0, 0, thrust_2).at(left),
        lift_3 = body(0, 0, thrust_3).at(back),
        lift_4 = body(0, 0, thrust_4).at(right),
        drag = -0.1[kg / s] * velocity,
    ],
    moments: [swirl = body(0, 0, 0.016[m] * (thrust_1 - thrust_2 + thrust_3 - thrust_4))],
    outputs: [linearization],
});

const THRUSTS: [&str; 4] = ["thrust_1", "thrust_2", "thrust_3", "thrust_4"];

fn thrusts(input: &QuadrotorInput) -> [f64; 4] {
    [
        input.thrust_1,
        input.thrust_2,
        input.thrust_3,
        input.thrust_4,
    ]
}

#[test]
fn a_quadrotor_hovers_on_a_quarter_of_its_weight_each() {
    let quadrotor = Quadrotor::default();
    let search = quadrotor.trim(&Spatial::default()).free(THRUSTS);
    let hover = search.solve().expect("it can hover");
    for thrust in thrusts(&hover.input) {
        assert!((thrust - 0.5 * G / 4.0).abs() < 2e-15, "{thrust}");
    }
    assert_eq!(hover.undetermined, 0);
    assert!(hover.drift().amax() < 1e-14);
    // three velocities are slowed down by drag, all else is neutral
    let modes = hover.modes().expect("A is finite");
    assert_eq!((modes.len(), modes.neutral()), (12, 9));
    for mode in &modes[..3] {
        assert!((mode.eigenvalue.re + 0.1 / 0.5).abs() < 1e-15);
    }
}

#[test]
fn a_quadrotor_leans_into_the_wind_that_it_makes() {
    let quadrotor = Quadrotor::default();
    let state = Spatial {
        velocity: Vector3::new(8.0, 6.0, 1.0),
        ..Spatial::default()
    };
    // about which axis it leans is known, about the vertical it may be turned: least change
    let search = quadrotor.trim(&state).free(THRUSTS).free(["attitude"]);
    let cruise = search.solve().expect("it can fly");
    let lift = Vector3::new(0.8, 0.6, 0.1 + 0.5 * G);
    for thrust in thrusts(&cruise.input) {
        assert!((thrust - lift.norm() / 4.0).abs() < 1e-14);
    }
    let up = cruise.state.attitude * Vector3::z();
    assert!((up - lift.normalize()).norm() < 1e-14);
    assert_eq!(cruise.undetermined, 1);
    let twist = cruise.state.attitude.scaled_axis().z;
    assert!(twist.abs() < 0.02, "{twist}");
}

#[test]
fn a_quadrotor_flies_in_circles() {
    let quadrotor = Quadrotor::default();
    let (speed, rate) = (6.0, 0.8);
    let state = Spatial {
        velocity: Vector3::new(speed, 0.0, 0.0),
        ..Spatial::default()
    };
    let search = quadrotor.trim(&state).turning([0.0, 0.0, rate]);
    let search = search.free(THRUSTS).free(["attitude"]);
    // the nose along the way
    let ahead = |state: &Spatial, _: &QuadrotorInput| (state.attitude * Vector3::x()).y;
    let turn = search.hold("heading", ahead).solve().expect("it can turn");
    let lift = 0.5 * Vector3::new(0.0, speed * rate, G) + Vector3::new(0.1 * speed, 0.0, 0.0);
    let up = turn.state.attitude * Vector3::z();
    assert!((up - lift.normalize()).norm() < 1e-14);
    assert!(((turn.state.attitude * Vector3::x()).y).abs() < 1e-14);
    let in_body = turn.state.attitude.inverse() * Vector3::new(0.0, 0.0, rate);
    assert!((turn.state.angular_velocity - in_body).norm() < 1e-14);
    let total: f64 = thrusts(&turn.input).iter().sum();
    assert!((total - lift.norm()).abs() < 1e-13);
    assert!(turn.drift().amax() < 1e-12);
    assert_eq!(turn.undetermined, 0);
    // what is steady stays so: a turn later it is where it was
    let flight = Held(quadrotor, turn.input);
    let period = core::f64::consts::TAU / rate;
    let later = flight.integrate(&turn.state).to(period).expect("it flies");
    assert!((later.position - turn.state.position).norm() < 1e-7);
    assert!((later.velocity - turn.state.velocity).norm() < 1e-7);
}

/// With the input held.
struct Held(Quadrotor, QuadrotorInput);

impl RigidBody for Held {
    type Scalar = f64;
    type State = Spatial;
    type Input = ();

    fn acceleration(&self, time: f64, state: &Spatial, (): &()) -> SpatialAcceleration {
        self.0.acceleration(time, state, &self.1)
    }
}

impl Integrate for Held {
    type Best = newton_euler::integrate::DormandPrince;
}

#[test]
fn what_is_missing_is_told() {
    let quadrotor = Quadrotor::default();
    let start = Spatial::default();
    let error = quadrotor.trim(&start).free(["thrust_5"]).solve();
    assert_eq!(error.unwrap_err(), TrimError::Unknown { name: "thrust_5" });
    // nothing is free
    let error = quadrotor.trim(&start).solve().unwrap_err();
    let TrimError::Unbalanced { residual, held } = error else {
        panic!("{error:?}");
    };
    let off = residual.into_iter().flatten().collect::<Vec<_>>();
    assert_eq!((off.len(), off[0].name), (1, "velocity_z"));
    assert!((off[0].by + G).abs() < 1e-15);
    let held: Vec<_> = held.into_iter().flatten().collect();
    assert_eq!(held, ["thrust_1", "thrust_2", "thrust_3"]);
    assert!(size_of_val(&error) <= 128);
    let text = error.to_string();
    assert!(
        text.starts_with(
            "not steady: `velocity_z` is off by -9.80665 (SI units); free also some of `thrust"
        ),
        "{text}"
    );
    // one rotor turns it over
    let error = quadrotor.trim(&start).free(["thrust_1"]).solve();
    assert!(matches!(error, Err(TrimError::Unbalanced { .. })));
    // numbers that are none, also where nothing depends on them
    let none = Vector3::new(f64::NAN, 0.0, 0.0);
    let moving = Spatial {
        velocity: none,
        ..start
    };
    let nowhere = Spatial {
        position: none,
        ..start
    };
    let pushed = QuadrotorInput {
        thrust_3: f64::NAN,
        ..QuadrotorInput::default()
    };
    let search = |state| quadrotor.trim(state).free(THRUSTS);
    for (search, name) in [
        (search(&moving), "velocity_x"),
        (search(&nowhere), "position_x"),
        (search(&start).input(&pushed), "thrust_3"),
        (search(&start).turning(none), "turning"),
        (search(&start).at(f64::INFINITY), "time"),
    ] {
        let error = search.solve().unwrap_err();
        assert_eq!(error, TrimError::NotFinite { name: Some(name) });
    }
    let held = search(&start).hold("slip", |state, _| 0.0 / state.velocity.x);
    let error = held.solve().unwrap_err();
    let text = "the start, or the acceleration there, is not finite: `slip`";
    assert_eq!(error.to_string(), text);
}

rigid_body!(Pendulum {
    motion: pivot(hinge),
    inputs: [torque[N * m]],
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [hinge = (0, 0.5)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    moments: [motor = torque, damper = -0.3[N * m * s] * angular_velocity],
    outputs: [linearization],
});

#[test]
fn a_pendulum_hangs_or_stands() {
    let pendulum = Pendulum::default();
    let at = |angle| Hinge {
        angle,
        angular_velocity: 0.0,
    };
    let stiffness = 2.0 * G * 0.5 / 0.6;
    let damping = 0.3 / 0.6;
    for (start, end, sign) in [(0.9, 0.0, 1.0), (2.2, core::f64::consts::PI, -1.0)] {
        let found = pendulum.trim(&at(start)).free(["angle"]).solve();
        let found = found.expect("it is near");
        assert!((found.state.angle - end).abs() < 1e-15);
        let modes = found.modes().expect("A is finite");
        if sign > 0.0 {
            assert_eq!(modes.len(), 1);
            assert!((modes[0].natural_frequency() - stiffness.sqrt()).abs() < 1e-14);
            let ratio = damping / 2.0 / stiffness.sqrt();
            assert!((modes[0].damping_ratio() - ratio).abs() < 1e-15);
            assert!(modes.is_stable());
        } else {
            let root = (damping * damping / 4.0 + stiffness).sqrt();
            let rates = modes.iter().map(|mode| mode.eigenvalue.re);
            let rates: Vec<f64> = rates.collect();
            assert_eq!(rates.len(), 2);
            assert!((rates[0] + damping / 2.0 + root).abs() < 1e-14);
            assert!((rates[1] + damping / 2.0 - root).abs() < 1e-14);
            let doubling = modes[1].time_to_double().expect("it falls");
            assert!((doubling * (root - damping / 2.0) - 2_f64.ln()).abs() < 1e-14);
            assert!(!modes.is_stable());
        }
    }
    // held aside by its motor, which is changed least where it need not be changed at all
    let aside = pendulum.trim(&at(0.5)).free(["torque"]).solve();
    let aside = aside.expect("the motor is strong");
    assert!((aside.input.torque - 2.0 * G * 0.5 * 0.5_f64.sin()).abs() < 1e-14);
    let turning = pendulum.trim(&at(0.5)).turning([0.0, 0.0, 1.0]).solve();
    assert_eq!(turning.unwrap_err(), TrimError::NothingTurns);
    // more than its motor is asked for, and then what comes of it
    let strong = PendulumInput { torque: 20.0 };
    let search = pendulum.trim(&at(0.5)).input(&strong);
    let error = search.free(["angle"]).solve();
    assert!(
        matches!(error, Err(TrimError::Unbalanced { .. })),
        "{error:?}"
    );
}

rigid_body!(Car {
    motion: planar,
    inputs: [steer[rad], pull[N]],
    mass: 1200[kg],
    inertia: 1500[kg * m ^ 2],
    points: [front = (1.2, 0), rear = (-1.4, 0)],
    locals: [
        slip_front =
            (front.velocity().dot(body(0, 1)) / front.velocity().dot(body(1, 0))).atan() - steer,
        slip_rear = (rear.velocity().dot(body(0, 1)) / rear.velocity().dot(body(1, 0))).atan(),
    ],
    forces: [
        grip_front = body(0, -60000[N] * slip_front).at(front),
        grip_rear = body(0, -70000[N] * slip_rear).at(rear),
        engine = body(pull, 0),
    ],
    outputs: [linearization],
});

#[test]
fn a_car_turns_steadily() {
    let car = Car::default();
    let (speed, rate) = (15.0, 0.2);
    let state = Planar {
        velocity: Vector2::new(speed, 0.0),
        ..Planar::default()
    };
    let search = car.trim(&state).turning([0.0, 0.0, rate]);
    let turn = search
        .free(["angle", "steer", "pull"])
        .solve()
        .expect("it turns");
    assert!((turn.state.angular_velocity - rate).abs() < 1e-15);
    // the two axles carry the centripetal force as levers
    let force = 1200.0 * speed * rate;
    let [u, v] = {
        let (sin, cos) = turn.state.angle.sin_cos();
        [speed * cos, -speed * sin]
    };
    let rear = ((v - 1.4 * rate) / u).atan();
    let front = ((v + 1.2 * rate) / u).atan() - turn.input.steer;
    let along = turn.state.angle.cos() * force;
    assert!((70000.0 * -rear - along * 1.2 / 2.6).abs() < 1e-8);
    assert!((60000.0 * -front - along * 1.4 / 2.6).abs() < 1e-8);
    assert!((turn.input.pull + turn.state.angle.sin() * -force).abs() < 1e-8);
    assert!(turn.drift().amax() < 1e-9);
}

rigid_body!(Glider {
    motion: rod(body(1, 0, 0)),
    inputs: [hold = world(_, _, _)[N]],
    mass: 0.8[kg],
    inertia: 0.42[kg * m ^ 2],
    points: [tail = (-0.6, 0, 0)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        drag = (-0.1[kg / s] * tail.velocity()).at(tail),
        hand = hold
    ],
    outputs: [linearization],
});

#[test]
fn a_rod_that_falls() {
    let rod = Glider::default();
    let start = Rod {
        axis: nalgebra::Unit::new_normalize(Vector3::new(0.3, 0.1, 1.0)),
        ..Rod::default()
    };
    let search = rod.trim(&start).free(["velocity", "axis"]);
    let falling = search.solve().expect("it falls at last");
    assert!((falling.state.velocity.z + 0.8 * G / 0.1).abs() < 1e-12);
    assert!((falling.state.axis.z.abs() - 1.0).abs() < 1e-15);
    assert_eq!(falling.undetermined, 0);
    // ten coordinates are there, of twelve numbers; three positions are neutral
    let modes = falling.modes().expect("A is finite");
    let count: usize = modes
        .iter()
        .map(|mode| 1 + usize::from(mode.eigenvalue.im > 0.0))
        .sum();
    assert_eq!((count, modes.neutral()), (10, 3), "{modes:?}");
}

#[test]
fn a_start_far_away() {
    let quadrotor = Quadrotor::default();
    let state = Spatial {
        attitude: UnitQuaternion::from_euler_angles(0.9, -0.7, 2.0),
        ..Spatial::default()
    };
    let search = quadrotor.trim(&state).free(THRUSTS).free(["attitude"]);
    let hover = search.solve().expect("it can hover");
    let up = hover.state.attitude * Vector3::z();
    assert!((up - Vector3::z()).norm() < 1e-14, "{up}");
}

rigid_body!(Plane {
    motion: planar,
    inputs: [thrust[N], elevator[rad]],
    mass: 1100[kg],
    inertia: 1800[kg * m ^ 2],
    locals: [
        u = velocity.dot(body(1, 0)),
        w = velocity.dot(body(0, 1)),
        alpha = -(w / u).atan(),
        load = 9.8[kg / m] * velocity.norm_squared(),
        lift = load * (0.4 + 5 * alpha + 0.3 * elevator),
        drag = 0.05 * load,
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    forces: [
        air = body(
            lift * alpha.sin() - drag * alpha.cos(),
            lift * alpha.cos() + drag * alpha.sin()
        ),
        propeller = body(thrust, 0),
    ],
    moments: [tail = load * 1.6[m] * (0.05 - 0.8 * alpha - 1.1 * elevator)],
    outputs: [linearization],
});

#[test]
fn a_fixed_wing_is_trimmed_as_by_hand() {
    let (speed, climb) = (48.0, 0.06_f64);
    let state = Planar {
        velocity: Vector2::new(speed * climb.cos(), speed * climb.sin()),
        ..Planar::default()
    };
    let plane = Plane::default();
    let search = plane.trim(&state);
    let found = search.free(["angle", "thrust", "elevator"]).solve();
    let found = found.expect("it climbs");
    // across the way the angle of attack, by halving, along it the thrust
    let load = 9.8 * speed * speed;
    let elevator = |alpha: f64| (0.05 - 0.8 * alpha) / 1.1;
    let thrust = |alpha: f64| (0.05 * load + 1100.0 * G * climb.sin()) / alpha.cos();
    let (mut low, mut high) = (-0.2_f64, 0.3_f64);
    for _ in 0..100 {
        let alpha = 0.5 * (low + high);
        let lift = load * (0.4 + 5.0 * alpha + 0.3 * elevator(alpha));
        if lift + thrust(alpha) * alpha.sin() < 1100.0 * G * climb.cos() {
            low = alpha;
        } else {
            high = alpha;
        }
    }
    assert!((found.state.angle - climb - low).abs() < 1e-15);
    assert!((found.input.elevator - elevator(low)).abs() < 1e-15);
    assert!((found.input.thrust / thrust(low) - 1.0).abs() < 1e-14);
    assert_eq!((found.undetermined, found.drift().amax() < 1e-9), (0, true));
}

#[test]
fn a_motion_in_the_plane_turns_about_z() {
    let ahead = Planar {
        velocity: Vector2::new(48.0, 0.0),
        ..Planar::default()
    };
    let plane = Plane::default();
    for axis in [[0.1, 0.0, 0.0], [0.0, 0.1, 0.2]] {
        let search = plane.trim(&ahead).turning(axis);
        let found = search.free(["angle", "thrust", "elevator"]).solve();
        assert_eq!(found.unwrap_err(), TrimError::OutOfPlane);
    }
}
