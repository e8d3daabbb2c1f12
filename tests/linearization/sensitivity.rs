//! Derivatives with respect to parameters, compared with dual numbers.

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::columns::{Columns, Generic, Sink, Source};
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;

use crate::oracle::{Derived, unmoved};

rigid_body!(Glider::<T> {
    motion: spatial,
    params: [
        load = 2.5[kg],
        width = 0.6[m],
        twist = 0.02[kg * m ^ 2],
        stiffness = 40[N / m],
        drag = 0.3[kg / m],
        hook = body(0.4, 0.1, -0.05)[m],
        pull = world(0.3, -0.2, -9.7)[m / s ^ 2],
    ],
    inputs: [flap[rad]],
    mass: load,
    inertia: tensor {
        xx: load * width.powi(2),
        yy: 2 * load * width.powi(2),
        zz: 2.5 * load * width.powi(2),
        xy: twist,
        yz: -twist,
        zx: 0.01[kg * m ^ 2]
    },
    points: [nose = hook, tail = (-0.7, 0, 0.1)],
    fields: [weight = mass * pull],
    forces: [
        air = (-drag * tail.velocity().norm() * tail.velocity()).at(tail),
        lift = body(0, 0, 3[N] * flap.sin()).at(nose),
    ],
    potentials: [rope = 0.5 * stiffness * (nose.position() - world(1, 2, 3)).norm_squared()],
    outputs: [sensitivity],
});

rigid_body!(Door::<T> {
    motion: fixed_axis(hinge, world(1, 2, 2)),
    params: [breadth = 0.8[m], friction = 0.5[N * m * s], arm = 0.35[m]],
    inputs: [push[N]],
    mass: 12[kg],
    inertia: cuboid(breadth, 0.04, 2),
    points: [hinge = (-0.5 * breadth, 0, 0), handle = (arm, 0.02, 0)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [hand = (push * body(0, 1, 0)).at(handle)],
    moments: [damping = -friction * angular_velocity],
    outputs: [sensitivity],
});

rigid_system!(Hanging::<T> {
    params: [
        reach = 0.3[m],
        load = 0.8[kg],
        bend = 0.4[rad],
        stiffness = 20[N / m],
        turn = 0.006[kg * m ^ 2]
    ],
    inputs: [torque[N * m]],
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: principal(0.04, 0.045, 0.012)[kg * m ^ 2],
            points: [top = (0, 0, 0.3), end = (0.1, 0, -reach)]
        },
        lower {
            mass: load,
            inertia: principal(0.02[kg * m ^ 2], 0.022[kg * m ^ 2], turn),
            points: [top = (0, 0, 0.25)]
        },
        slider {
            mass: 0.3[kg],
            inertia: principal(0.001, 0.001, 0.0006)[kg * m ^ 2]
        },
    ],
    joints: [
        first = spherical(world(0, 0, 0), upper.top),
        second = revolute(upper.end, lower.top, body(0, 1, 0)).turned(body(1, 0, 0), bend),
        along = cylindrical(lower.G, slider.G, body(0, 0, 1)),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [
        motor = torque.on(second),
        spring = (-stiffness * along.position).on(along.position)
    ],
    outputs: [sensitivity],
});

rigid_system!(FourBar::<T> {
    motion: planar,
    params: [long = 0.16[m], load = 1.1[kg], friction = 0.6[N * m * s]],
    inputs: [torque[N * m]],
    bodies: [
        crank {
            mass: 0.4[kg],
            inertia: 4e-4[kg * m ^ 2],
            points: [o = (-0.04, 0), a = (0.06, 0)]
        },
        coupler {
            mass: load,
            inertia: 0.012[kg * m ^ 2],
            points: [a = (-long, 0), b = (0.19, 0)]
        },
        rocker {
            mass: 0.8[kg],
            inertia: 4.5e-3[kg * m ^ 2],
            points: [c = (-0.11, 0), b = (0.14, 0)]
        },
    ],
    joints: [
        o = revolute(world(0, 0), crank.o),
        a = revolute(crank.a, coupler.a),
        b = revolute(coupler.b, rocker.b),
        c = revolute(world(0.3, 0), rocker.c),
    ],
    drives: [motor = torque.on(o)],
    moments: [load_of_rocker = moment(-friction * rocker.angular_velocity).on(rocker)],
    outputs: [sensitivity],
});

/// A list of numbers, to be read or written.
#[derive(Default)]
pub struct Numbers<T>(pub Vec<T>, pub usize);

impl<T: Copy> Source<T> for Numbers<T> {
    fn take(&mut self) -> T {
        self.1 += 1;
        self.0[self.1 - 1]
    }
}

impl<T> Sink<T> for Numbers<T> {
    fn put(&mut self, scalar: T) {
        self.0.push(scalar);
    }
}

pub fn numbers<T: newton_euler::Scalar>(columns: &impl Columns<T>) -> Vec<T> {
    let mut list = Numbers(Vec::new(), 0);
    columns.write(&mut list);
    list.0
}

/// Holds the columns of a sensitivity, in the order of the parameters, beside dual numbers: of the
/// accelerations of a body that is built from dual parameters.
pub fn hold<B, D>(
    body: &B,
    state: &B::State,
    accelerations: impl Fn(Vec<Derived>, &D) -> Vec<Derived>,
    found: &[Vec<f64>],
    bound: f64,
) where
    B: Generic<State: Coordinates>,
    D: Coordinates<Scalar = Derived>,
{
    let params = numbers(&body.parameters());
    assert_eq!(params.len(), found.len());
    let at: D = unmoved(state);
    for (number, column) in found.iter().enumerate() {
        let dual = params.iter().enumerate().map(|(other, value)| {
            if other == number {
                Derived::variable(*value, 0)
            } else {
                Derived::from(*value)
            }
        });
        let expected = accelerations(dual.collect(), &at);
        assert_eq!(expected.len(), column.len());
        let expected = expected.iter().map(|one| one.derivatives[0]);
        let expected: Vec<f64> = expected.collect();
        let size = expected
            .iter()
            .fold(1e-3_f64, |size, one| size.max(one.abs()));
        for (entry, expected) in column.iter().zip(&expected) {
            let off = (entry - expected).abs();
            assert!(off <= bound * size, "{number}: {entry} is {expected}");
        }
    }
}

fn column(parts: &[&[f64]]) -> Vec<f64> {
    parts.concat()
}

#[test]
fn a_free_body() {
    let state = Spatial {
        position: Vector3::new(0.4, -0.7, 1.1),
        attitude: UnitQuaternion::from_euler_angles(0.3, -0.9, 1.4),
        velocity: Vector3::new(1.3, 2.1, -0.6),
        angular_velocity: Vector3::new(0.5, -1.4, 0.8),
    };
    let glider = Glider::<f64>::default();
    let found = glider.sensitivity(0.3, &state, &GliderInput { flap: 0.2 });
    let none = [0.0; 3];
    let mut columns = vec![
        column(&[
            found.linear_by_load.as_slice(),
            found.angular_by_load.as_slice(),
        ]),
        column(&[&none, found.angular_by_width.as_slice()]),
        column(&[&none, found.angular_by_twist.as_slice()]),
        column(&[
            found.linear_by_stiffness.as_slice(),
            found.angular_by_stiffness.as_slice(),
        ]),
        column(&[
            found.linear_by_drag.as_slice(),
            found.angular_by_drag.as_slice(),
        ]),
    ];
    for part in 0..3 {
        columns.push(column(&[
            found.linear_by_hook.column(part).as_slice(),
            found.angular_by_hook.column(part).as_slice(),
        ]));
    }
    for part in 0..3 {
        // gravity does not turn a body
        columns.push(column(&[
            found.linear_by_pull.column(part).as_slice(),
            &none,
        ]));
    }
    let accelerations = |params: Vec<Derived>, state: &_| {
        let params = Columns::read(&mut Numbers(params, 0));
        let body = Glider::<Derived>::new(params).expect("a possible body");
        let input = GliderInput {
            flap: Derived::from(0.2),
        };
        numbers(&body.acceleration(Derived::from(0.3), state, &input))
    };
    hold(&glider, &state, accelerations, &columns, 1e-14);
    let direct = glider.acceleration(0.3, &state, &GliderInput { flap: 0.2 });
    assert!((found.acceleration.linear - direct.linear).norm() < 1e-14);
}

#[test]
fn a_body_on_a_hinge() {
    let state = Hinge {
        angle: 0.7,
        angular_velocity: 2.1,
    };
    let door = Door::<f64>::default();
    let found = door.sensitivity(0.0, &state, &DoorInput { push: 3.0 });
    let columns = [
        vec![found.angular_by_breadth],
        vec![found.angular_by_friction],
        vec![found.angular_by_arm],
    ];
    let accelerations = |params: Vec<Derived>, state: &_| {
        let params = Columns::read(&mut Numbers(params, 0));
        let body = Door::<Derived>::new(params).expect("a possible body");
        let push = Derived::from(3.0);
        vec![body.acceleration(Derived::from(0.0), state, &DoorInput { push })]
    };
    // what the breadth does to the moment and to the inertia cancels but for a part
    hold(&door, &state, accelerations, &columns, 1e-13);
}

#[test]
fn a_tree() {
    let state = HangingState {
        first: Rotation {
            attitude: UnitQuaternion::from_euler_angles(0.3, -0.9, 1.4),
            angular_velocity: Vector3::new(0.5, -1.4, 0.8),
        },
        second: Hinge {
            angle: 0.9,
            angular_velocity: -1.3,
        },
        along: Cylinder {
            position: 0.1,
            angle: 0.3,
            velocity: -0.4,
            angular_velocity: 2.0,
        },
    };
    let body = Hanging::<f64>::default();
    let found = body.sensitivity(0.0, &state, &HangingInput { torque: 0.7 });
    macro_rules! column {
        ($first:ident $second:ident $linear:ident $angular:ident) => {
            column(&[
                found.$first.as_slice(),
                &[found.$second, found.$linear, found.$angular],
            ])
        };
    }
    let columns = [
        column!(first_angular_by_reach second_angular_by_reach along_linear_by_reach along_angular_by_reach),
        column!(first_angular_by_load second_angular_by_load along_linear_by_load along_angular_by_load),
        column!(first_angular_by_bend second_angular_by_bend along_linear_by_bend along_angular_by_bend),
        column!(first_angular_by_stiffness second_angular_by_stiffness along_linear_by_stiffness along_angular_by_stiffness),
        column!(first_angular_by_turn second_angular_by_turn along_linear_by_turn along_angular_by_turn),
    ];
    let accelerations = |params: Vec<Derived>, state: &_| {
        let params = Columns::read(&mut Numbers(params, 0));
        let body = Hanging::<Derived>::new(params).expect("a possible body");
        let torque = Derived::from(0.7);
        numbers(&body.acceleration(Derived::from(0.0), state, &HangingInput { torque }))
    };
    hold(&body, &state, accelerations, &columns, 1e-13);
}

#[test]
fn a_loop() {
    let hinge = |angle, angular_velocity| Hinge {
        angle,
        angular_velocity,
    };
    let mut state = FourBarState {
        o: hinge(0.7, 12.0),
        a: hinge(0.513_679 - 0.7, -2.653_551_9 - 12.0),
        b: hinge(1.239_513_4 - 0.513_679, 1.339_603_5 + 2.653_551_9),
    };
    let body = FourBar::<f64>::default();
    let input = FourBarInput { torque: 0.4 };
    body.project(0.0, &mut state, &input).expect("it closes");
    let found = body.sensitivity(0.0, &state, &input);
    let columns = [
        vec![
            found.o_angular_by_long,
            found.a_angular_by_long,
            found.b_angular_by_long,
        ],
        vec![
            found.o_angular_by_load,
            found.a_angular_by_load,
            found.b_angular_by_load,
        ],
        vec![
            found.o_angular_by_friction,
            found.a_angular_by_friction,
            found.b_angular_by_friction,
        ],
    ];
    let accelerations = |params: Vec<Derived>, state: &_| {
        let params = Columns::read(&mut Numbers(params, 0));
        let body = FourBar::<Derived>::new(params).expect("a possible body");
        let torque = Derived::from(0.4);
        numbers(&body.acceleration(Derived::from(0.0), state, &FourBarInput { torque }))
    };
    hold(&body, &state, accelerations, &columns, 1e-12);
}

rigid_body!(Motor {
    motion: pivot(hinge),
    params: [lag = 0.08[s], friction = 0.3[N * m * s]],
    inputs: [command[N * m]],
    states: [torque[N * m]],
    rates: [torque = (command - torque) / lag],
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [hinge = (0, 0.5)],
    moments: [drive = torque - friction * angular_velocity],
    outputs: [sensitivity],
});

#[test]
fn states_of_ones_own() {
    let state = MotorState {
        motion: Hinge {
            angle: 0.3,
            angular_velocity: 2.0,
        },
        torque: 1.5,
    };
    let found = Motor::default().sensitivity(0.0, &state, &MotorInput { command: 4.0 });
    assert!((found.torque_rate_by_lag + 2.5 / 0.0064).abs() < 1e-11);
    assert!((found.angular_by_friction + 2.0 / 0.6).abs() < 1e-14);
}

rigid_body!(Damped {
    motion: planar_translation,
    params: [n = 2],
    mass: 2[kg],
    forces: [drag = world(-3[N] * (velocity.norm() / 1[m / s]).powf(n), 0)],
    outputs: [sensitivity, linearization],
});

#[test]
fn powers_of_zero() {
    let rest = PlanarTranslation::default();
    for n in [0.0, 1.0, 2.0, 2.5] {
        let body = Damped::new(DampedParams { n }).expect("finite");
        let slopes = body.linearize(0.0, &rest, &()).a();
        assert!(slopes.iter().all(|slope| slope.is_finite()), "{n} {slopes}");
        assert_eq!([slopes[(2, 2)], slopes[(2, 3)]], [0.0, 0.0], "{n}");
        let by_n = body.sensitivity(0.0, &rest, &()).linear_by_n.x;
        // 0^n falls from one to zero at n = 0
        let expected = if n > 0.0 { 0.0 } else { f64::INFINITY };
        assert_eq!(by_n, expected, "{n}");
        // where the speed is not zero, by hand
        let moving = PlanarTranslation {
            velocity: [0.3, 0.4].into(),
            ..rest
        };
        let by_n = body.sensitivity(0.0, &moving, &()).linear_by_n.x;
        let expected = -1.5 * 0.5_f64.powf(n) * 0.5_f64.ln();
        assert!((by_n - expected).abs() < 1e-15, "{n}");
        let slope = body.linearize(0.0, &moving, &()).a()[(2, 2)];
        let expected = -1.5 * n * 0.5_f64.powf(n - 1.0) * 0.6;
        assert!((slope - expected).abs() < 1e-15, "{n}");
    }
}
