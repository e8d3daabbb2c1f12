//! The default method of bodies with series: the faster one at each tolerance, as measured
//! (`docs/performance.md`).

use newton_euler::integrate::{RungeKuttaPair, SeriesBelow, TaylorSeries};
use newton_euler::prelude::*;

rigid_body!(Free {
    motion: rotation,
    inertia: principal(0.6, 0.8, 1.0)[kg * m ^ 2],
    outputs: [taylor],
});

rigid_body!(Swing {
    motion: fixed_axis(hinge, body(0, 0, 1)),
    mass: 2[kg],
    inertia: principal(0.3, 0.5, 0.4)[kg * m ^ 2],
    points: [hinge = (0.0, 0.4, 0.0)[m]],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2], 0)],
    outputs: [taylor],
});

// its steps are long, because the axes of its series do not spin with it
rigid_body!(Shell {
    motion: spatial,
    mass: 40[kg],
    inertia: principal(0.3, 0.3, 0.1)[kg * m ^ 2],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [drag = -0.004[kg / m] * velocity.norm() * velocity],
    outputs: [taylor],
});

rigid_system!(Arms {
    params: [length = 1[m]],
    bodies: [
        upper {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [hinge = (0, 0.5 * length), tip = (0, -0.5 * length)]
        },
        lower {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [hinge = (0, 0.5 * length)]
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
    motion: planar,
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    outputs: [taylor],
});

rigid_body!(Orbit {
    motion: translation,
    mass: 100[kg],
    potentials: [earth = -3.986004418e14[m ^ 3 / s ^ 2] * mass / G.position().norm()],
    outputs: [taylor],
});

rigid_body!(Tethered {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(0.03, 0.02, 0.04)[kg * m ^ 2],
    points: [ring = (0.2, 0.1, 0)[m]],
    potentials: [
        tether = 20[N / m] * ((ring.position() - world(0, 0, 1)[m]).norm() - 0.3[m]).powi(2)
    ],
    outputs: [taylor],
});

#[test]
fn the_faster_method_is_the_default() {
    fn along_series<B: Integrate<Best = TaylorSeries>>() {}
    fn below<const N: u32, B: Integrate<Best = SeriesBelow<N>>>() {}
    fn by_pairs<B: Integrate<Best = RungeKuttaPair>>() {}
    along_series::<Shell>();
    along_series::<Swing>();
    below::<6, Free>();
    below::<4, Arms>();
    by_pairs::<Orbit>();
    by_pairs::<Tethered>();
    let state = Translation {
        position: [7e6, 0.0, 0.0].into(),
        velocity: [0.0, 8500.0, 1000.0].into(),
    };
    let orbit = Orbit::default();
    let pair = orbit.integrate(&state).tolerance(1e-11).to(6000.0).unwrap();
    let series = TaylorSeries { tolerance: 1e-11 };
    let series = orbit.integrate(&state).method(series).to(6000.0).unwrap();
    assert!((pair.position - series.position).norm() < 1e-2);
}

#[test]
fn the_tolerance_chooses_the_method() {
    let (body, start) = (
        Free::default(),
        Rotation {
            angular_velocity: [1.0, 2.0, 0.5].into(),
            ..Rotation::default()
        },
    );
    for tolerance in [1e-3, 1.1e-6, 1e-6, 1e-9] {
        let chosen = body.integrate(&start).tolerance(tolerance).to(3.0).unwrap();
        let motion = body.integrate(&start);
        let same = if tolerance > 1e-6 {
            motion.method(RungeKuttaPair { tolerance }).to(3.0)
        } else {
            motion.method(TaylorSeries { tolerance }).to(3.0)
        };
        assert_eq!(chosen, same.unwrap(), "{tolerance}");
    }
    // steps, samples and events come from the same motion
    let motion = body.integrate(&start).tolerance(1e-3);
    let mut turns = motion.events(30.0, |_, state: &Rotation| state.angular_velocity.y);
    let first = turns.next().unwrap().unwrap();
    assert!(first.state.angular_velocity.y.abs() < 1e-9);
}
