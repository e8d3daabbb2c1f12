//! A crank-rocker that passes close to a dead point twice per revolution: its energy and its branch
//! over a million steps, or ten thousand without optimization.
#![allow(missing_docs)]

use newton_euler::integrate::{DormandPrince8, Fixed, Projected};
use newton_euler::prelude::*;

// ground and coupler 2 m, rocker 1 m: with a crank of 1 m it would fold
rigid_system!(CrankRocker {
    motion: planar,
    bodies: [
        crank {
            mass: 3[kg],
            inertia: 0.4[kg * m ^ 2],
            points: [o = (-0.499, 0), a = (0.499, 0)]
        },
        coupler {
            mass: 1[kg],
            inertia: 0.3[kg * m ^ 2],
            points: [a = (-1, 0), b = (1, 0)]
        },
        rocker {
            mass: 2[kg],
            inertia: 0.2[kg * m ^ 2],
            points: [c = (-0.5, 0), b = (0.5, 0)]
        },
    ],
    joints: [
        o = revolute(world(0, 0), crank.o),
        a = revolute(crank.a, coupler.a),
        b = revolute(coupler.b, rocker.b),
        c = revolute(world(2, 0), rocker.c),
    ],
    fields: [weight = mass * world(0, -0.3[m / s ^ 2])],
    outputs: [energy],
});

const STEPS: u32 = if cfg!(debug_assertions) {
    10_000
} else {
    1_000_000
};
const STEP: f64 = 0.001;

#[test]
fn energy_and_branch_of_a_crank_rocker() {
    let linkage = CrankRocker::default();
    let mut start = CrankRockerState {
        o: Hinge {
            angle: 1.2,
            angular_velocity: 2.0,
        },
        a: Hinge {
            angle: -1.0,
            angular_velocity: 0.0,
        },
        b: Hinge {
            angle: 1.0,
            angular_velocity: 0.0,
        },
    };
    linkage
        .project(0.0, &mut start, &())
        .expect("it closes near by");
    let energy = |state: &CrankRockerState| {
        linkage.kinetic_energy(state) + linkage.potential_energy(0.0, state, &())
    };
    let (first, kinetic) = (energy(&start), linkage.kinetic_energy(&start));
    let side = |state: &CrankRockerState| state.b.angle.sin() > 0.0;
    let method = Projected(Fixed {
        method: DormandPrince8,
        step: STEP,
    });
    let (mut worst, mut nearest) = (0.0_f64, f64::INFINITY);
    let end = f64::from(STEPS) * STEP;
    for step in linkage.integrate(&start).method(method).steps(end) {
        let state = step.expect("no dead point").state;
        worst = worst.max((energy(&state) - first).abs() / kinetic);
        nearest = nearest.min(state.b.angle.sin().abs());
        assert_eq!(side(&state), side(&start), "the branch has changed");
    }
    assert!(nearest < 0.1, "close by a dead point: {nearest}");
    assert!(worst < 1e-9, "{worst:e}");
}
