//! Inputs that are given with their rate and acceleration: constraints follow them, and they
//! continue between two control steps.

use newton_euler::ensemble::Ensemble;
use newton_euler::integrate::{Classical4, Fixed, Projected, Verner, cf4_projected};
use newton_euler::{integrate, nalgebra::Vector2, prelude::*};

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
    outputs: [reactions],
});

rigid_body!(Written {
    doc: "The same, on a path that the description knows.",
    motion: planar,
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, 0.5)[m]],
    locals: [pivot = world(0.1[m] * (3[1 / s] * t).sin(), 0.2[m / s ^ 2] * t * t)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [held = pin.position() - pivot],
    reactions: [hinge = world(_, _).at(pin)],
    outputs: [reactions],
});

rigid_body!(Belt {
    doc: "A box on a belt, and a spring to a hook that moves.",
    motion: planar_translation,
    inputs: [speed[m / s].moving, hook[m].moving],
    mass: 2[kg],
    forces: [spring = world(0, -8[N / m] * (position.in_world().y - hook))],
    constraints: [pace = velocity.in_world().x - speed],
    reactions: [grip = world(_, 0)],
    outputs: [reactions],
});

/// The path of the pin.
fn path(time: f64) -> CarriedInput {
    let (sine, cosine) = (3.0 * time).sin_cos();
    CarriedInput {
        pivot: Vector2::new(0.1 * sine, 0.2 * time * time),
        pivot_rate: Vector2::new(0.3 * cosine, 0.4 * time),
        pivot_acceleration: Vector2::new(-0.9 * sine, 0.4),
    }
}

fn start() -> Planar {
    let angle = 0.4_f64;
    let arm = Vector2::new(angle.sin(), -angle.cos()) * 0.5;
    Planar {
        position: arm,
        angle,
        velocity: Vector2::new(0.3, 0.0),
        ..Planar::default()
    }
}

#[test]
fn as_if_the_path_were_written() {
    let (carried, written, start) = (Carried::default(), Written::default(), start());
    for time in [0.0, 0.7, 2.0] {
        let state = written.integrate(&start).tolerance(1e-13).to(time).unwrap();
        let (one, other) = (
            carried.acceleration(time, &state, &path(time)),
            written.acceleration(time, &state, &()),
        );
        assert!((one.linear - other.linear).norm() < 1e-12);
        assert!((one.angular - other.angular).abs() < 1e-12);
        let (one, other) = (
            carried.reactions(time, &state, &path(time)).unwrap().hinge,
            written.reactions(time, &state, &()).unwrap().hinge,
        );
        assert!((one - other).norm() < 1e-11);
    }
    // what is between two controls is of third order in their period
    let expected = written.integrate(&start).tolerance(1e-13).to(2.0).unwrap();
    let off = |period: f64| {
        let motion = carried.integrate(&start).tolerance(1e-13);
        let end = motion
            .control(period, |time, _| path(time))
            .to(2.0)
            .unwrap();
        let position = (end.position - expected.position).norm();
        position + (end.angle - expected.angle).abs()
    };
    let (coarse, fine) = (off(0.02), off(0.005));
    assert!(coarse < 1e-5 && fine < coarse / 8.0, "{coarse}, {fine}");
}

/// Uniformly accelerated, one input says all: between the controls too.
#[test]
fn goes_on_with_rate_and_acceleration() {
    let carried = Carried::default();
    let input = CarriedInput {
        pivot: Vector2::new(0.0, 0.0),
        pivot_rate: Vector2::new(0.3, 0.0),
        pivot_acceleration: Vector2::new(0.0, -9.80665),
    };
    // the pin falls as the body does: nothing holds or turns it
    let falls = |time: f64| start().position + Vector2::new(0.3, -4.903_325 * time) * time;
    let motion = || carried.integrate(&start()).input(input);
    let fixed = Projected(Fixed {
        method: Classical4,
        step: 0.01,
    });
    let ends = [
        motion().to(2.0).unwrap(),
        motion().method(fixed).to(2.0).unwrap(),
        motion().max_step(0.1).to(2.0).unwrap(),
        cf4_projected(&carried, &start(), &input, 0.0..2.0, 100).unwrap(),
    ];
    for end in ends {
        assert!((end.position - falls(2.0)).norm() < 1e-10, "{end:?}");
        assert!((end.angle - 0.4).abs() < 1e-12 && end.angular_velocity.abs() < 1e-10);
    }
    for sample in motion().samples(2.0, 0.3) {
        let integrate::Sample { time, state } = sample.unwrap();
        assert!((state.position - falls(time)).norm() < 1e-10);
    }
}

#[test]
fn paces_and_springs() {
    let input = BeltInput {
        speed: 1.0,
        speed_rate: 0.5,
        hook_rate: 0.25,
        ..BeltInput::default()
    };
    let start = PlanarTranslation {
        velocity: [1.0, 0.0].into(),
        ..PlanarTranslation::default()
    };
    let belt = Belt::default();
    let end = belt
        .integrate(&start)
        .input(input)
        .tolerance(1e-13)
        .to(3.0)
        .unwrap();
    assert!((end.position.x - (3.0 + 0.25 * 9.0)).abs() < 1e-12);
    // y'' = -4 (y - t/4)
    assert!((end.position.y - (0.75 - 0.125 * 6.0_f64.sin())).abs() < 1e-11);
    let grip = belt.reactions(0.0, &start, &input).unwrap().grip;
    assert!((grip.x - 1.0).abs() < 1e-14);
}

rigid_body!(Pulled::<T> {
    motion: planar_translation,
    inputs: [hook = world(_, _)[m].moving, stiffness[N / m]],
    mass: 2[kg],
    forces: [spring = -stiffness * (position - hook)],
});

#[test]
fn in_lanes_as_alone() {
    let input = |i: u32| PulledInput {
        hook: [0.1, 0.0].into(),
        hook_rate: [0.0, 0.1 * f64::from(i)].into(),
        hook_acceleration: [0.02, 0.0].into(),
        stiffness: 8.0,
    };
    let rest = PlanarTranslation::default();
    let mut all = Ensemble::new(&Pulled::<f64>::default(), [rest; 11]);
    for i in 0..11 {
        all.inputs_mut().set(i as usize, &input(i));
    }
    let mut each = all.clone();
    let fixed = Fixed {
        method: Classical4,
        step: 0.01,
    };
    all.integrate().method(fixed).to(1.0).unwrap();
    each.integrate().tolerance(1e-13).to(1.0).unwrap();
    for i in 0..11 {
        let body = Pulled::<f64>::default();
        let alone = body
            .integrate(&rest)
            .input(input(i))
            .method(fixed)
            .to(1.0)
            .unwrap();
        assert_eq!(all.state(i as usize), alone);
        assert!((alone.position - each.state(i as usize).position).norm() < 1e-9);
    }
}

rigid_body!(Tugged::<T> {
    doc: "Pulled along, with a spring that is switched on and off.",
    motion: planar_translation,
    params: [period = 0.1[s]],
    inputs: [hook = world(_, _)[m].moving],
    mass: 2[kg],
    forces: [spring = if t / period - (t / period).floor() < 0.5 {
        -8[N / m] * (position - hook)
    } else {
        world(0, 0)
    }],
});

/// Under a controller, and sampled between its instants.
#[test]
fn controlled_in_lanes_as_alone() {
    let input = |time: f64, i: usize| TuggedInput {
        hook: [0.1 * time, 0.0].into(),
        hook_rate: [
            0.1,
            if i.is_multiple_of(2) {
                0.2
            } else {
                -0.3 * time
            },
        ]
        .into(),
        hook_acceleration: [0.02, 0.0].into(),
    };
    let rest = PlanarTranslation::default();
    let params = (0..11_u8).map(|i| TuggedParams {
        period: 0.1 + 0.07 * f64::from(i),
    });
    let all = Ensemble::<Tugged<f64>>::with_params(params.map(|params| (params, rest))).unwrap();
    let fixed = Fixed {
        method: Classical4,
        step: 0.03,
    };
    let verner = Verner { tolerance: 1e-9 };
    let ends = [1.0, -1.0];
    /// Compares with a method.
    macro_rules! agree {
        ($method:expr) => {
            for end in ends {
                let mut all = all.clone();
                let motion = all.integrate().method($method);
                let motion = motion.control(0.17, |time, i, _| input(time, i));
                let samples: Vec<_> = motion.samples(end, 0.05).map(Result::unwrap).collect();
                for i in 0..all.len() {
                    let body = all.body(i);
                    let alone = body.integrate(&rest).method($method);
                    let alone = alone.control(0.17, |time, _| input(time, i));
                    for (sample, alone) in samples.iter().zip(alone.samples(end, 0.05)) {
                        let alone = alone.unwrap();
                        assert_eq!(sample.time.to_bits(), alone.time.to_bits());
                        assert_eq!(sample.state.get(i), alone.state, "{i} at {} s", alone.time);
                    }
                }
            }
        };
    }
    agree!(fixed);
    agree!(verner);
}
