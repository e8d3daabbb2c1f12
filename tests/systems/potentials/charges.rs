//! Uniform fields on the charges of bodies, compared with the same as forces, and with the energy
//! by hand.

use nalgebra::{UnitQuaternion, Vector2};
use newton_euler::prelude::*;

/// Two arms with charges at their ends, in a field that grows with time.
macro_rules! arms {
    ($name:ident, $key:ident, $fields:tt, $upper:tt, $lower:tt) => {
        rigid_system!($name {
            motion: planar,
            params: [strength = 3[V / m], q = 0.7[C]],
            bodies: [
                upper {
                    mass: 1.2[kg],
                    inertia: 0.04[kg * m ^ 2],
                    points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]],
                    $key: $upper,
                },
                lower {
                    mass: 0.8[kg],
                    inertia: 0.015[kg * m ^ 2],
                    points: [hinge = (-0.22, 0)[m], end = (0.1, 0.2)[m]],
                    $key: $lower,
                },
            ],
            joints: [
                shoulder = revolute(world(0, 0), upper.hinge),
                elbow = revolute(upper.tip, lower.hinge),
            ],
            fields: $fields,
            outputs: [energy, reactions, linearization],
        });
    };
}

arms!(
    Charged,
    fields,
    [e = world(strength, 2[V / m / s] * t).on([1[C].at(G)])],
    [f = world(strength, 0).on([q.at(tip), (-q).at(hinge)])],
    [f = world(0, strength).on([q.at(end), (2 * q).at(hinge)])]
);

arms!(
    Pushed,
    forces,
    [e = world(strength, 2[V / m / s] * t) * 1[C]],
    [
        f = (q * world(strength, 0)).at(tip),
        g = (-q * world(strength, 0)).at(hinge)
    ],
    [
        f = (q * world(0, strength)).at(end),
        g = (2 * q * world(0, strength)).at(hinge)
    ]
);

const POSES: [[f64; 4]; 3] = [
    [0.3, 1.0, 0.5, -2.0],
    [-2.0, 0.1, 3.0, 4.0],
    [1.7, -3.0, -0.9, 0.0],
];

fn hinge(angle: f64, angular_velocity: f64) -> Hinge {
    Hinge {
        angle,
        angular_velocity,
    }
}

#[test]
fn charges_are_pushed() {
    let (charged, pushed) = (Charged::default(), Pushed::default());
    for [a, u, b, v] in POSES {
        let state = ChargedState {
            shoulder: hinge(a, u),
            elbow: hinge(b, v),
        };
        let other = PushedState {
            shoulder: hinge(a, u),
            elbow: hinge(b, v),
        };
        for time in [0.0, 0.7] {
            let found = charged.acceleration(time, &state, &());
            let expected = pushed.acceleration(time, &other, &());
            assert!((found.shoulder - expected.shoulder).abs() < 1e-12);
            assert!((found.elbow - expected.elbow).abs() < 1e-12);
            let found = charged.reactions(time, &state, &());
            let expected = pushed.reactions(time, &other, &());
            assert!((found.elbow.force - expected.elbow.force).norm() < 1e-12);
            assert!((found.shoulder.force - expected.shoulder.force).norm() < 1e-12);
        }
    }
}

/// `-E . x` of all charges.
#[test]
fn charges_have_energy() {
    let charged = Charged::default();
    let (strength, q, time) = (3.0, 0.7, 0.7);
    for [a, u, b, v] in POSES {
        let turned = |angle: f64, x: f64, y: f64| {
            let (sine, cosine) = angle.sin_cos();
            Vector2::new(cosine * x - sine * y, sine * x + cosine * y)
        };
        let elbow = turned(a, 0.6, 0.0);
        let (upper, lower) = (turned(a, 0.28, 0.0), elbow + turned(a + b, 0.22, 0.0));
        let end = lower + turned(a + b, 0.1, 0.2);
        let everywhere = Vector2::new(strength, 2.0 * time);
        let expected = -everywhere.dot(&(upper + lower))
            - strength * q * elbow.x
            - strength * q * (end.y + 2.0 * elbow.y);
        let state = ChargedState {
            shoulder: hinge(a, u),
            elbow: hinge(b, v),
        };
        let found = charged.potential_energy(time, &state, &());
        assert!((found - expected).abs() < 1e-13, "{found} {expected}");
    }
}

rigid_body!(Alone {
    motion: spatial,
    mass: 2[kg],
    inertia: tensor {
        xx: 1,
        yy: 1.5,
        zz: 2,
        xy: 0.1,
        yz: -0.2,
        zx: 0.05
    }[kg * m ^ 2],
    points: [a = (0.1, 0.2, 0.3)[m], b = (-0.3, 0.1, 0)[m]],
    fields: [
        e = world(1, 2, 3)[V / m].on([2[C].at(a), -2[C].at(b)]),
        g = world(0, 1, 3)[V / m].on([0.3[C].at(a), 0.2[C].at(b)]),
    ],
    outputs: [energy],
});

rigid_system!(One {
    bodies: [one {
        mass: 2[kg],
        inertia: tensor {
            xx: 1,
            yy: 1.5,
            zz: 2,
            xy: 0.1,
            yz: -0.2,
            zx: 0.05
        }[kg * m ^ 2],
        points: [a = (0.1, 0.2, 0.3)[m], b = (-0.3, 0.1, 0)[m]],
        fields: [
            e = world(1, 2, 3)[V / m].on([2[C].at(a), -2[C].at(b)]),
            g = world(0, 1, 3)[V / m].on([0.3[C].at(a), 0.2[C].at(b)]),
        ],
    },],
    joints: [whole = free(one)],
    outputs: [energy],
});

/// Without a net charge, a couple is left.
#[test]
fn one_body_is_a_system() {
    let whole = Spatial {
        position: [0.3, -0.2, 1.0].into(),
        velocity: [1.0, 2.0, 3.0].into(),
        attitude: UnitQuaternion::from_euler_angles(0.3, 0.7, -1.1),
        angular_velocity: [0.3, 2.0, -1.0].into(),
    };
    let (alone, one) = (Alone::default(), One::default());
    let expected = alone.acceleration(0.0, &whole, &());
    let found = one.acceleration(0.0, &OneState { whole }, &()).whole;
    assert!((found.linear - expected.linear).norm() < 1e-14);
    assert!((found.angular - expected.angular).norm() < 1e-13);
    let expected = alone.potential_energy(0.0, &whole, &());
    let found = one.potential_energy(0.0, &OneState { whole }, &());
    assert!((found - expected).abs() < 1e-14);
}
