//! Cables: they pull where they are taut, and have an energy.

use nalgebra::Vector3;
use newton_euler::prelude::*;

use crate::agree;
use crate::compare::{Jointed, Random, close, link, principal};
use crate::oracle::Kind;

rigid_system!(Moored {
    params: [stiffness = 40[N / m]],
    inputs: [winch[m]],
    bodies: [
        buoy {
            mass: 2[kg],
            inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2],
            points: [eye = (0.1, 0.2, 0.3)],
        },
        mast {
            mass: 0.6[kg],
            inertia: principal(0.05, 0.04, 0.03)[kg * m ^ 2],
            points: [foot = (0, 0.1, -0.3), top = (0.1, 0, 0.3)],
        },
    ],
    joints: [
        float = free(buoy),
        swing = spherical(buoy.eye, mast.foot),
        mooring = cable(world(0, 0, -2[m]), buoy.eye, winch, stiffness),
        stay = cable(mast.top, buoy.G, 0.7[m], 300[N / m]),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    outputs: [energy, momentum, reactions],
});

#[test]
fn tight_and_slack() {
    let links = [
        link(
            (2.0, principal(0.3, 0.4, 0.5)),
            None,
            [0.0; 3],
            [0.0; 3],
            Kind::Free,
        ),
        link(
            (0.6, principal(0.05, 0.04, 0.03)),
            Some(0),
            [0.1, 0.2, 0.3],
            [0.0, 0.1, -0.3],
            Kind::Spherical,
        ),
    ];
    let make = |numbers: &mut Random| {
        let params = MooredParams {
            stiffness: 40.0 + numbers.number(),
        };
        let input = MooredInput {
            winch: 4.0 + 3.0 * numbers.number(),
        };
        (Moored::new(params).unwrap(), input, links)
    };
    let counts = std::cell::Cell::new([0; 2]);
    agree!(Moored, make, [0.0, 0.0, -9.81], moving [float swing], held [1 swing], still [],
    |loads, system, input| {
        let (eye, ground) = ([0.1, 0.2, 0.3], [0.0, 0.0, -2.0]);
        let stretch = (loads.point(0, eye) - Vector3::from(ground)).norm() - input.winch;
        if stretch > 0.0 {
            loads.pull(system.params().stiffness * stretch, (0, eye), ground);
        }
        let top = [0.1, 0.0, 0.3];
        let stay = (loads.point(1, top) - loads.point(0, [0.0; 3])).norm() - 0.7;
        if stay > 0.0 {
            loads.tension(300.0 * stay, (1, top), (0, [0.0; 3]));
        }
        let [tight, slack] = counts.get();
        let is_tight = u32::from(stretch > 0.0) + u32::from(stay > 0.0);
        counts.set([tight + is_tight, slack + 2 - is_tight]);
    });
    assert!(counts.get().iter().all(|count| *count > 20), "{counts:?}");
}

#[test]
fn energy_is_kept() {
    let system = Moored::default();
    let mut numbers = Random::new(3);
    let input = MooredInput { winch: 1.5 };
    for _ in 0..5 {
        let state = MooredState {
            float: Jointed::random(&mut numbers),
            swing: Jointed::random(&mut numbers),
        };
        let energy = |state: &MooredState| {
            system.kinetic_energy(state) + system.potential_energy(0.0, state, &input)
        };
        let end = system
            .integrate(&state)
            .input(input)
            .tolerance(1e-13)
            .to(3.0)
            .unwrap();
        let size = system.kinetic_energy(&state) + energy(&state).abs();
        let drift = (energy(&end) - energy(&state)).abs();
        // a step over the place where a cable becomes tight is of a lower order
        assert!(drift <= 1e-9 * size, "{drift} of {size}");
    }
}

rigid_system!(Bungee {
    motion: planar,
    params: [length = 0[m]],
    bodies: [ball { mass: 2[kg] }],
    joints: [
        fall = translation(ball),
        rope = cable(world(1, 2), ball.G, length, 50[N / m])
    ],
    outputs: [energy],
});

#[test]
fn where_both_ends_meet() {
    for (length, distance) in [
        (0.0, 0.0),
        (0.5, 0.0),
        (0.5, 0.5),
        (0.5, 0.3),
        (0.5, 0.9),
        (0.0, 1e-300),
    ] {
        let system = Bungee::new(BungeeParams { length }).unwrap();
        let mut state = BungeeState::default();
        state.fall.position = [1.0 + distance, 2.0].into();
        let distance = state.fall.position.x - 1.0;
        let stretch = f64::max(distance - length, 0.0);
        let found = system.acceleration(0.0, &state, &());
        close(
            "force",
            &[2.0 * found.fall.x],
            &[-50.0 * stretch],
            0.0,
            1e-15,
        );
        close("force", &[found.fall.y], &[0.0], 0.0, 0.0);
        let energy = system.potential_energy(0.0, &state, &());
        close("energy", &[energy], &[25.0 * stretch * stretch], 0.0, 1e-15);
    }
}
