//! Constraints, cables and loops on bodies whose mass changes: at every instant, the system moves
//! like the same system with the mass as a parameter.

use newton_euler::prelude::*;

use super::compare::Random;

// the same description twice: what `fuel` is called is all that differs
macro_rules! twice {
    ($changing:ident $constant:ident { $($all:tt)* }) => {
        rigid_system!($changing { states: [fuel[kg]], rates: [fuel = -0.3[kg / s]], $($all)* });
        rigid_system!($constant { params: [fuel = 1[kg]], $($all)* });
    };
}

twice!(FourBar FixedFourBar {
    motion: planar,
    bodies: [
        crank {
            mass: 0.5[kg] + fuel,
            inertia: 0.1[m ^ 2] * mass,
            points: [a = (-0.2, 0.01), b = (0.2, 0)],
        },
        coupler {
            mass: 2[kg] + 0.5 * fuel,
            inertia: 0.3[kg * m ^ 2],
            points: [b = (-0.5, 0), c = (0.5, 0.1)],
        },
        rocker { mass: 3 * fuel, inertia: 0.2[m ^ 2] * fuel, points: [c = (0, 0.4), d = (0, -0.35)] },
    ],
    joints: [
        one = revolute(world(0, 0), crank.a),
        two = revolute(crank.b, coupler.b),
        three = revolute(coupler.c, rocker.c),
        four = revolute(world(0.9, 0), rocker.d),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    drives: [spring = (-2[N * m] * one.angle).on(one)],
    outputs: [reactions, energy],
});

twice!(Held FixedHeld {
    bodies: [
        frame {
            mass: 1[kg] + fuel,
            inertia: principal(0.5[m ^ 2] * mass, 0.6[m ^ 2] * mass, 0.7[m ^ 2] * mass),
            points: [p = (0.3, 0.1, 0)],
        },
        rotor { mass: fuel, inertia: principal(0.1, 0.1, 0.2)[kg * m ^ 2], points: [rim = (0.2, 0, 0.1)] },
    ],
    joints: [orbit = free(frame), axle = revolute(frame.p, rotor.G, body(0, 0, 1))],
    constraints: [guide = rotor.rim.position().in_world().z, table = (frame.position - rotor.position).in_world().x],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    outputs: [reactions, momentum],
});

twice!(Arm FixedArm {
    bodies: [
        upper { mass: 2[kg], inertia: principal(0.2, 0.3, 0.3)[kg * m ^ 2], points: [a = (-0.4, 0, 0), b = (0.4, 0, 0)] },
        lower {
            mass: 0.2[kg] + fuel,
            inertia: principal(0.1, 0.2, 0.2)[kg * m ^ 2],
            points: [b = (-0.3, 0, 0)],
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0, 0), upper.a, world(0, 1, 0)),
        elbow = revolute(upper.b, lower.b, body(0, 0.6, 0.8)),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [first = _.on(shoulder), second = _.on(elbow)],
    outputs: [inverse, mass_matrix],
});

/// Of a hinge.
fn hinge(numbers: &mut Random) -> Hinge {
    Hinge {
        angle: numbers.number(),
        angular_velocity: numbers.number(),
    }
}

#[track_caller]
fn same(found: &[f64], expected: &[f64]) {
    let size = expected
        .iter()
        .fold(1.0, |size: f64, one| size.max(one.abs()));
    for (one, other) in found.iter().zip(expected) {
        assert!(
            (one - other).abs() < 1e-12 * size,
            "{found:?}, {expected:?}"
        );
    }
}

#[test]
fn a_four_bar() {
    let mut numbers = Random::new(3);
    for _ in 0..50 {
        let fuel = 1.5 + numbers.number();
        let fixed = FixedFourBar::new(FixedFourBarParams { fuel }).unwrap();
        let [one, two, three] = [0; 3].map(|_| hinge(&mut numbers));
        let state = FourBarState {
            one,
            two,
            three,
            fuel,
        };
        let other = FixedFourBarState { one, two, three };
        let system = FourBar::default();
        let found = system.acceleration(0.0, &state, &());
        let expected = fixed.acceleration(0.0, &other, &());
        same(
            &[found.one, found.two, found.three],
            &[expected.one, expected.two, expected.three],
        );
        let found = system.reactions(0.0, &state, &()).four.force;
        let expected = fixed.reactions(0.0, &other, &()).four.force;
        same(found.as_slice(), expected.as_slice());
        same(
            &[system.kinetic_energy(&state)],
            &[fixed.kinetic_energy(&other)],
        );
    }
    let empty = FourBarState::default();
    assert!(
        FourBar::default()
            .acceleration(0.0, &empty, &())
            .one
            .is_nan()
    );
}

#[test]
fn under_constraints() {
    let mut numbers = Random::new(4);
    for _ in 0..50 {
        let fuel = 1.5 + numbers.number();
        let fixed = FixedHeld::new(FixedHeldParams { fuel }).unwrap();
        let (orbit, axle) = (
            super::compare::Jointed::random(&mut numbers),
            hinge(&mut numbers),
        );
        let state = HeldState { orbit, axle, fuel };
        let other = FixedHeldState { orbit, axle };
        let found = Held::default().acceleration(0.0, &state, &());
        let expected = fixed.acceleration(0.0, &other, &());
        same(
            &[
                found.orbit.linear.as_slice(),
                found.orbit.angular.as_slice(),
                &[found.axle],
            ]
            .concat(),
            &[
                expected.orbit.linear.as_slice(),
                expected.orbit.angular.as_slice(),
                &[expected.axle],
            ]
            .concat(),
        );
        let found = Held::default().reactions(0.0, &state, &());
        let expected = fixed.reactions(0.0, &other, &());
        same(
            &[found.guide, found.table],
            &[expected.guide, expected.table],
        );
    }
}

#[test]
fn drives_and_the_mass_matrix() {
    let mut numbers = Random::new(5);
    for _ in 0..50 {
        let fuel = 1.5 + numbers.number();
        let fixed = FixedArm::new(FixedArmParams { fuel }).unwrap();
        let (shoulder, elbow) = (hinge(&mut numbers), hinge(&mut numbers));
        let state = ArmState {
            shoulder,
            elbow,
            fuel,
        };
        let other = FixedArmState { shoulder, elbow };
        let [a, b] = [numbers.number(), numbers.number()];
        let asked = ArmAcceleration {
            shoulder: a,
            elbow: b,
            ..ArmAcceleration::default()
        };
        let found = Arm::default().inverse(0.0, &state, &asked, &());
        let expected = FixedArmAcceleration {
            shoulder: a,
            elbow: b,
        };
        let expected = fixed.inverse(0.0, &other, &expected, &());
        same(
            &[found.first, found.second],
            &[expected.first, expected.second],
        );
        let found = Arm::default().mass_matrix(0.0, &state, &());
        let expected = fixed.mass_matrix(0.0, &other, &());
        same(found.as_slice(), expected.as_slice());
    }
}
