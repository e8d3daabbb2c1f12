//! Linkages whose rows depend on each other in closed states alone.
#![allow(missing_docs)]

use newton_euler::integrate::IntegrationError;
use newton_euler::prelude::*;

rigid_system!(Cranks {
    motion: planar,
    params: [long = 1.2[m]],
    bodies: [
        first {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [o = (0, -0.5), a = (0, 0.5)]
        },
        coupler {
            mass: 2[kg],
            inertia: 0.8[kg * m ^ 2],
            points: [a = (-1, 0), b = (0, 0), c = (1, 0)]
        },
        second {
            mass: 1.5[kg],
            inertia: 0.2[kg * m ^ 2],
            points: [o = (0, -0.5), b = (0, 0.5)]
        },
        third {
            mass: 0.7[kg],
            inertia: 0.15[kg * m ^ 2],
            points: [o = (0, -0.5 * long), c = (0, 0.5 * long)]
        },
    ],
    joints: [
        o = revolute(world(0, 0), first.o),
        a = revolute(first.a, coupler.a),
        b = revolute(coupler.b, second.b),
        c = revolute(coupler.c, third.c),
        p = revolute(world(1, 0), second.o),
        q = revolute(world(2, 0), third.o),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [energy],
});

fn at(angle: f64, rate: f64) -> CranksState {
    let hinge = |angle, angular_velocity| Hinge {
        angle,
        angular_velocity,
    };
    CranksState {
        o: hinge(angle, rate),
        a: hinge(-angle, -rate),
        b: hinge(angle, rate),
        c: hinge(angle, rate),
    }
}

// the closed form moves: with numbers for which all cranks are parallel, no row tells how
#[test]
fn rows_that_depend_on_each_other_in_closed_states_give_no_number() {
    let cranks = Cranks::new(CranksParams { long: 1.0 }).unwrap();
    let is_none = |state: &CranksState| {
        let found = cranks.acceleration(0.0, state, &());
        let all = [found.o, found.a, found.b, found.c];
        assert!(all.iter().all(|one| one.is_nan()), "{state:?}: {found:?}");
    };
    for number in 0..200 {
        let angle = 0.05 + 0.03 * f64::from(number);
        // all in a line is a change point
        if angle.cos().abs() < 0.05 {
            continue;
        }
        for rate in [0.0, 1.3] {
            let mut state = at(angle, rate);
            cranks.check(0.0, &state, &()).unwrap();
            is_none(&state);
            state.a.angle += 1e-3;
            state.c.angular_velocity -= 0.01 * rate;
            cranks.project(0.0, &mut state, &()).unwrap();
            is_none(&state);
            let error = cranks.integrate(&state).to(1.0).unwrap_err();
            assert!(
                matches!(error, IntegrationError::NotFinite { .. }),
                "{error}"
            );
        }
    }
}
