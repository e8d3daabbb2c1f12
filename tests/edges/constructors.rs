//! Params whose values no motion allows: what `new` says of the values that it computes from them.

use newton_euler::body::InvalidBody;
use newton_euler::prelude::*;

rigid_body!(Door {
    motion: fixed_axis(lower, world(0, 0, 1)),
    params: [span = 1[m]],
    mass: 12[kg],
    inertia: cuboid(0.8, 0.04, 2),
    points: [lower = (-0.4, 0, 0), upper = (-0.4, 0, span)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    reactions: [
        bearing = world(_, _, _).at(lower),
        guide = world(_, _, 0).at(upper)
    ],
    outputs: [reactions],
});

rigid_body!(Carried {
    motion: planar_translation,
    params: [k = 1[kg], load = 2[kg], push = world(1, 0)[N]],
    mass: load,
    forces: [follows = k * acceleration, given = push],
});

rigid_body!(Any::<T> {
    motion: planar_translation,
    params: [k = 1[kg]],
    mass: 2[kg],
    forces: [follows = k * acceleration, given = world(1[N], 0)],
});

// each carries a part of the other
rigid_system!(Two {
    motion: planar,
    params: [k = 0.5[kg]],
    bodies: [
        a {
            mass: 1[kg],
            forces: [pull = k * b.G.acceleration()]
        },
        b {
            mass: 1[kg],
            forces: [push = k * a.G.acceleration()]
        },
    ],
    joints: [
        one = prismatic(world(0, 0), a.G, world(1, 0)),
        two = prismatic(world(0, 0), b.G, world(1, 0)),
    ],
    fields: [weight = mass * world(1[m / s ^ 2], 0)],
});

rigid_system!(Loose {
    motion: planar,
    params: [k = 0.5[kg]],
    bodies: [
        a {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            forces: [pull = k * b.acceleration]
        },
        b {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            forces: [push = k * a.acceleration]
        },
    ],
    joints: [one = free(a), two = free(b)],
    fields: [weight = mass * world(1[m / s ^ 2], 0)],
});

rigid_body!(Many {
    motion: planar_translation,
    params: [a = 1[N], b = 1[N], c = 1[N], d = 1[N], e = 1[N]],
    mass: 1[kg],
    forces: [all = world(a * b * c * d * e / 1[N ^ 4], 0)],
});

/// What `new` says.
fn told<B>(made: Result<B, InvalidBody>) -> String {
    made.err().expect("no body has these params").to_string()
}

#[test]
fn what_is_computed_names_its_params() {
    assert!(matches!(
        Door::new(DoorParams { span: 0.0 }),
        Err(InvalidBody::Derived {
            from: "`span`",
            value: f64::NEG_INFINITY
        })
    ));
    let door = told(Door::new(DoorParams { span: 0.0 }));
    assert_eq!(door, "a value computed from `span` must be finite, is -inf");
    assert!(Door::new(DoorParams { span: 1e-3 }).is_ok());
    let params = CarriedParams {
        k: 2.0,
        ..*Carried::default().params()
    };
    assert_eq!(
        told(Carried::new(params)),
        "a value computed from `k`, `load`, `push` must be finite, is inf"
    );
    assert_eq!(
        told(Any::<f32>::new(AnyParams { k: 2.0 })),
        "a value computed from `k` must be finite, is inf"
    );
    let many = ManyParams {
        a: 1e200,
        b: 1e200,
        ..*Many::default().params()
    };
    assert_eq!(
        told(Many::new(many)),
        "a value computed from `a`, `b`, `c`, `d`, .. must be finite, is inf"
    );
}

#[test]
fn loads_that_cancel_the_inertia_of_a_system() {
    // what is left depends on the param alone: `new` checks it
    assert_eq!(
        told(Two::new(TwoParams { k: 1.0 })),
        "a value computed from `k` must be finite, is inf"
    );
    // it depends on the state, too
    let loose = Loose::new(LooseParams { k: 1.0 }).unwrap();
    let found = loose.acceleration(0.0, &LooseState::default(), &());
    assert!(found.one.linear.x.is_nan() && found.two.linear.x.is_nan());
    let end = loose.integrate(&LooseState::default()).to(1.0);
    assert!(end.is_err());
    let found = Loose::default().acceleration(0.0, &LooseState::default(), &());
    assert!((found.one.linear.x - 2.0).abs() < 1e-14);
}
