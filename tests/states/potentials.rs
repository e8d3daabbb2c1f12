//! Energies that depend on user-defined states: forces are their slopes with the state held, and
//! the energy changes by its slope along the state.

use newton_euler::prelude::*;

rigid_body!(Hoist {
    doc: "A load on a spring, of which the length is paid out.",
    motion: planar,
    inputs: [speed[m / s]],
    states: [length[m]],
    rates: [length = speed],
    mass: 3[kg],
    inertia: 0.2[kg * m ^ 2],
    points: [eye = (0.1, 0.3)],
    potentials: [rope = 0.5 * 40[N / m] * ((eye.position() - world(0, 2)).norm() - length).powi(2)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [energy],
});

rigid_system!(Coil {
    doc: "Two arms with a spring between, which is wound up.",
    motion: planar,
    inputs: [winding[rad / s]],
    states: [wound[rad]],
    rates: [wound = winding],
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]],
        },
        lower {
            mass: 0.8[kg],
            inertia: 0.015[kg * m ^ 2],
            points: [hinge = (-0.22, 0)[m]],
            potentials: [magnet = 0.3[J] * (attitude - wound).cos()],
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
    potentials: [coil = 0.5 * 2[N * m] * (elbow.angle - wound).powi(2)],
    outputs: [energy],
});

rigid_system!(Driven {
    doc: "The same, by loads that are written out.",
    motion: planar,
    inputs: [wound[rad]],
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]],
        },
        lower {
            mass: 0.8[kg],
            inertia: 0.015[kg * m ^ 2],
            points: [hinge = (-0.22, 0)[m]]
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
    drives: [coil = (-2[N * m] * (elbow.angle - wound)).on(elbow)],
    moments: [magnet = moment(0.3[J] * (lower.attitude - wound).sin()).on(lower)],
});

#[test]
fn a_rope_that_is_paid_out() {
    let hoist = Hoist::default();
    let (start, input) = (
        HoistState {
            motion: Planar {
                position: [0.2, 0.5].into(),
                angle: 0.4,
                velocity: [0.3, -0.2].into(),
                angular_velocity: 1.1,
            },
            length: 0.9,
        },
        HoistInput { speed: 0.35 },
    );
    // by hand: a force along the rope, at the eye
    let arm = nalgebra::Rotation2::new(0.4) * nalgebra::Vector2::new(0.1, 0.3);
    let rope = start.motion.position + arm - nalgebra::Vector2::new(0.0, 2.0);
    let force = rope.normalize() * (-40.0 * (rope.norm() - 0.9));
    let rate = hoist.acceleration(0.0, &start, &input);
    let linear = force / 3.0 - nalgebra::Vector2::new(0.0, 9.81);
    assert!((rate.motion.linear - linear).norm() < 1e-13);
    assert!((rate.motion.angular - arm.perp(&force) / 0.2).abs() < 1e-12);
    assert_eq!(rate.length, 0.35);
    // dE/dt = dU/dl l'
    let energy = |state: &HoistState| {
        hoist.kinetic_energy(state) + hoist.potential_energy(0.0, state, &input)
    };
    let step = 1e-4;
    let at = |time: f64| {
        let motion = hoist.integrate(&start).input(input).tolerance(1e-14);
        energy(&motion.to(time).unwrap())
    };
    let slope = (at(step) - at(-step)) / (2.0 * step);
    let expected = -40.0 * (rope.norm() - 0.9) * 0.35;
    assert!((slope - expected).abs() < 1e-5, "{slope} is {expected}");
}

#[test]
fn a_spring_that_is_wound_up() {
    let (coil, driven) = (Coil::default(), Driven::default());
    let hinge = |angle, angular_velocity| Hinge {
        angle,
        angular_velocity,
    };
    let state = CoilState {
        shoulder: hinge(0.4, 1.7),
        elbow: hinge(-0.9, -1.1),
        wound: 0.6,
    };
    let found = coil.acceleration(0.0, &state, &CoilInput { winding: 0.5 });
    let same = DrivenState {
        shoulder: state.shoulder,
        elbow: state.elbow,
    };
    let expected = driven.acceleration(0.0, &same, &DrivenInput { wound: 0.6 });
    assert!((found.shoulder - expected.shoulder).abs() < 1e-12);
    assert!((found.elbow - expected.elbow).abs() < 1e-12);
    assert_eq!(found.wound, 0.5);
}
