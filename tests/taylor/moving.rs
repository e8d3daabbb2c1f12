//! Series of motions that `.moving` inputs drive: in closed form, and compared with DOP853.

use nalgebra::{Quaternion, Unit, Vector2, Vector3};
use newton_euler::integrate::{
    self, DormandPrince, Motion, Projected, Sample, TaylorSeries, taylor_step,
};
use newton_euler::prelude::*;

rigid_body!(Pulled {
    doc: "A stone on a spring whose other end moves.",
    motion: planar_translation,
    inputs: [hook = world(_, _)[m].moving, stiffness[N / m]],
    mass: 2[kg],
    forces: [spring = -stiffness * (position - hook)],
    outputs: [taylor],
});

/// From rest at the origin: `y'' = -4 (y - h)`, h being the hook.
fn pulled(time: f64, hook: [f64; 3]) -> f64 {
    let [place, rate, acceleration] = hook;
    let follows = place + rate * time + 0.5 * acceleration * time * time - 0.25 * acceleration;
    let (sine, cosine) = (2.0 * time).sin_cos();
    follows - (place - 0.25 * acceleration) * cosine - 0.5 * rate * sine
}

const HOOKS: [[f64; 3]; 2] = [[0.3, -0.7, 0.4], [0.0, 0.2, -0.1]];

fn hooks() -> PulledInput {
    let [x, y] = HOOKS;
    PulledInput {
        hook: [x[0], y[0]].into(),
        hook_rate: [x[1], y[1]].into(),
        hook_acceleration: [x[2], y[2]].into(),
        stiffness: 8.0,
    }
}

fn assert_pulled(state: &PlanarTranslation, time: f64) {
    let expected = Vector2::from(HOOKS.map(|hook| pulled(time, hook)));
    let off = (state.position - expected).norm();
    assert!(off < 1e-12, "{time}: {off}");
}

#[test]
fn a_spring_to_a_hook_in_closed_form() {
    let (body, rest) = (Pulled::default(), PlanarTranslation::default());
    let motion = || {
        body.integrate(&rest)
            .input(hooks())
            .method(TaylorSeries { tolerance: 1e-14 })
    };
    for time in [0.4, 5.0, -3.0] {
        assert_pulled(&motion().to(time).unwrap(), time);
        assert_pulled(&motion().max_step(0.3).to(time).unwrap(), time);
        let end = integrate::taylor(&body, &rest, &hooks(), 0.0..time, 1e-14).unwrap();
        assert_pulled(&end, time);
    }
    for sample in motion().samples(5.0, 0.7) {
        let Sample { time, state } = sample.unwrap();
        assert_pulled(&state, time);
    }
    assert_pulled(&taylor_step::<_, 25>(&body, 7.0, &rest, &hooks(), 0.5), 0.5);
    let series = body.series::<9>(3.0, &rest, &hooks());
    // y'' = 4 h, y''' = 4 h', y'''' = 4 (h'' - y'')
    let [_, _, second, third, fourth, ..] = series.coefficients();
    for (axis, [place, rate, acceleration]) in HOOKS.into_iter().enumerate() {
        assert!((second[axis] - 2.0 * place).abs() < 1e-15);
        assert!((third[axis] - 4.0 * rate / 6.0).abs() < 1e-15);
        let expected = 4.0 * (acceleration - 4.0 * place) / 24.0;
        assert!((fourth[axis] - expected).abs() < 1e-15);
    }
}

/// Who steps by hand gives the input of now, and it moves on from there.
#[test]
fn steps_by_hand_begin_with_the_input_of_now() {
    let (body, rest) = (Pulled::default(), PlanarTranslation::default());
    let mut motion = Motion::<_, 21>::new(&body, 0.0, &rest);
    let mut input = hooks();
    while motion.time() < 2.0 {
        let before = motion.time();
        if before < 1.0 {
            motion.step_towards(2.0, &input, 1e-14).unwrap();
        } else {
            motion.step(0.25_f64.min(2.0 - before), &input).unwrap();
        }
        input = body.input_after(&hooks(), motion.time()).unwrap();
        assert_pulled(&motion.state(), motion.time());
    }
}

rigid_body!(Carried {
    doc: "A pendulum whose pin is carried about.",
    motion: planar,
    inputs: [pivot = world(_, _)[m].moving],
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, 0.5)[m]],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [held = pin.position() - pivot],
    reactions: [hinge = world(_, _).at(pin)],
    outputs: [taylor],
});

#[test]
fn a_support_that_moves() {
    let body = Carried::default();
    let angle = 0.4_f64;
    let start = Planar {
        position: Vector2::new(angle.sin(), -angle.cos()) * 0.5,
        angle,
        velocity: Vector2::new(0.3, 0.1),
        ..Planar::default()
    };
    let input = |time: f64| CarriedInput {
        pivot: Vector2::new(0.3 * time, 0.1 * time + 0.4 * time * time),
        pivot_rate: Vector2::new(0.3, 0.1 + 0.8 * time),
        pivot_acceleration: Vector2::new(0.0, 0.8),
    };
    let series = || {
        body.integrate(&start)
            .method(TaylorSeries { tolerance: 1e-14 })
    };
    let steps = || series().method(Projected(DormandPrince { tolerance: 1e-14 }));
    for time in [0.9, 4.0, -2.0] {
        let held = [
            series().input(input(0.0)).to(time).unwrap(),
            steps().input(input(0.0)).to(time).unwrap(),
            series()
                .control(0.25, |now, _| input(now))
                .to(time)
                .unwrap(),
        ];
        for other in &held[1..] {
            assert!((held[0].position - other.position).norm() < 1e-11);
            assert!((held[0].angle - other.angle).abs() < 1e-11);
            assert!((held[0].velocity - other.velocity).norm() < 1e-11);
        }
    }
}

rigid_body!(Top {
    doc: "A slender top on a spring to a hand that moves, and a twin whose symmetry nobody sees.",
    motion: spatial,
    inputs: [hand = world(_, _, _)[m].moving],
    mass: 2[kg],
    inertia: principal(0.3, 0.3, 0.1)[kg * m ^ 2],
    points: [tip = (0, 0, 0.4)[m]],
    forces: [spring = (-6[N / m] * (tip.position() - hand)).at(tip)],
    outputs: [taylor],
});

#[test]
fn in_axes_that_do_not_spin() {
    let top = Top::default();
    let start = Spatial {
        attitude: Unit::new_normalize(Quaternion::new(0.9, 0.2, -0.3, 0.1)),
        velocity: [0.1, -0.2, 0.3].into(),
        angular_velocity: [0.5, -0.3, 9.0].into(),
        ..Spatial::default()
    };
    let input = TopInput {
        hand: [0.1, 0.2, 0.3].into(),
        hand_rate: [0.4, -0.3, 0.1].into(),
        hand_acceleration: [-0.3, 0.2, 0.1].into(),
    };
    let series = top
        .integrate(&start)
        .input(input)
        .method(TaylorSeries { tolerance: 1e-14 });
    let series = series.to(3.0).unwrap();
    let steps = top.integrate(&start).input(input);
    let steps = steps.method(DormandPrince { tolerance: 1e-14 });
    let steps = steps.to(3.0).unwrap();
    assert!((series.position - steps.position).norm() < 1e-11);
    assert!((series.angular_velocity - steps.angular_velocity).norm() < 1e-11);
    let one = series.attitude.transform_vector(&Vector3::x());
    let other = steps.attitude.transform_vector(&Vector3::x());
    assert!((one - other).norm() < 1e-11);
}

rigid_system!(Crane {
    doc: "A load on a jib: the trolley goes as it is told, and the jib leans by a function of an input.",
    motion: planar,
    inputs: [trolley[m].moving, lean[rad].moving, wind[N]],
    bodies: [
        jib {
            mass: 40[kg],
            inertia: 3[kg * m ^ 2]
        },
        cart {
            mass: 5[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [hook = (0, -0.1)[m]]
        },
        load {
            mass: 9[kg],
            inertia: 0.4[kg * m ^ 2],
            points: [eye = (0, 0.8)[m]],
            forces: [blow = world(wind, 0)],
        },
    ],
    joints: [
        root = revolute(world(0, 0), jib.G).driven(0.3[rad] * lean.sin()),
        rail = prismatic(jib.G, cart.G, body(1, 0)).driven(trolley),
        rope = revolute(cart.hook, load.eye),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [taylor],
});

#[test]
fn driven_joints_of_a_system() {
    let crane = Crane::default();
    let start = CraneState {
        rope: Hinge {
            angle: 0.3,
            angular_velocity: -0.2,
        },
    };
    let input = CraneInput {
        trolley: 0.5,
        trolley_rate: 0.6,
        trolley_acceleration: -0.2,
        lean: 0.2,
        lean_rate: -0.9,
        lean_acceleration: 0.7,
        wind: 3.0,
    };
    for time in [0.6, 3.0, -2.0] {
        let motion = || {
            crane
                .integrate(&start)
                .input(input)
                .method(TaylorSeries { tolerance: 1e-14 })
        };
        let series = motion().to(time).unwrap().rope;
        let steps = motion().method(DormandPrince { tolerance: 1e-14 });
        let steps = steps.to(time).unwrap().rope;
        assert!((series.angle - steps.angle).abs() < 1e-11);
        assert!((series.angular_velocity - steps.angular_velocity).abs() < 1e-11);
    }
}
