//! More links than are needed: the motion, and which loads are determined.

use nalgebra::Vector2;
use newton_euler::prelude::*;

use super::compare::{Random, close};

// a square with both diagonals, and a node on top of it
rigid_system!(Braced {
    motion: planar,
    inputs: [load_x[N], load_y[N]],
    bodies: [
        a {
            mass: 1[kg],
            inertia: 1[kg * m ^ 2]
        },
        b {
            mass: 2[kg],
            inertia: 1[kg * m ^ 2]
        },
        top {
            mass: 3[kg],
            inertia: 1[kg * m ^ 2],
            forces: [load = world(load_x, load_y)]
        },
    ],
    joints: [
        first = translation(a),
        second = translation(b),
        third = translation(top),
        left = link(world(0, 0), a.G, 3[m]),
        right = link(world(4, 0), b.G, 3[m]),
        bar = link(a.G, b.G, 4[m]),
        rising = link(world(0, 0), b.G, 5[m]),
        falling = link(world(4, 0), a.G, 5[m]),
        mast = link(a.G, top.G, 3[m]),
        stay = link(b.G, top.G, 5[m]),
    ],
    outputs: [reactions(mast, stay)],
});

#[test]
fn a_truss_with_one_bar_more() {
    let truss = Braced::default();
    let at = |x: f64, y: f64| PlanarTranslation {
        position: [x, y].into(),
        ..PlanarTranslation::default()
    };
    let mut state = BracedState {
        first: at(0.1, 2.9),
        second: at(4.05, 3.1),
        third: at(-0.1, 6.2),
    };
    let input = BracedInput::default();
    truss.project(0.0, &mut state, &input).unwrap();
    let (a, b, top) = (&state.first, &state.second, &state.third);
    close("a", a.position.as_slice(), &[0.0, 3.0], 5.0, 1e-14);
    close("b", b.position.as_slice(), &[4.0, 3.0], 5.0, 1e-14);
    close("top", top.position.as_slice(), &[0.0, 6.0], 5.0, 1e-14);
    let mut numbers = Random::new(5);
    for _ in 0..10 {
        let [load_x, load_y] = [0; 2].map(|_| 100.0 * numbers.number());
        let input = BracedInput { load_x, load_y };
        let found = truss.reactions(0.0, &state, &input);
        // at the top: the stay has the slope of 3 in 4, and the mast stands upright
        let stay = -load_x / 0.8;
        let tensions = [load_y - 0.6 * stay, stay];
        close("top", &[found.mast, found.stay], &tensions, 100.0, 1e-13);
        let found = truss.acceleration(0.0, &state, &input);
        let all = [found.first, found.second, found.third];
        let all = all.map(|one| one.norm());
        close("it stands", &all, &[0.0; 3], 100.0, 1e-13);
    }
}

#[test]
fn bars_that_do_not_fit_are_an_error() {
    let mut state = BracedState::default();
    state.second.position = [4.0, -3.0].into();
    state.first.position = [0.0, 3.0].into();
    let error = Braced::default().project(0.0, &mut state, &BracedInput::default());
    assert!(!error.unwrap_err().is_start);
}

// two ropes of one length side by side, and one of both
rigid_system!(Swing {
    motion: planar,
    params: [long = 0.8[m], stiffness = 3[N / m]],
    bodies: [bob {
        mass: 1.5[kg],
        inertia: 1[kg * m ^ 2]
    }],
    joints: [
        flight = translation(bob),
        rope = link(world(0, 1), bob.G, long),
        chain = link(world(0, 1), bob.G, long),
        wire = cable(world(0, 5), bob.G, long, stiffness),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
});

#[test]
fn a_pendulum_on_two_links() {
    let swing = Swing::new(SwingParams {
        long: 0.8,
        stiffness: 0.0,
    })
    .unwrap();
    let (angle, rate) = (0.7_f64, 2.5_f64);
    let (along, across) = (
        Vector2::new(angle.sin(), -angle.cos()),
        Vector2::new(angle.cos(), angle.sin()),
    );
    let start = SwingState {
        flight: PlanarTranslation {
            position: Vector2::new(0.0, 1.0) + 0.8 * along,
            velocity: 0.8 * rate * across,
        },
    };
    swing.check(0.0, &start, &()).unwrap();
    let found = swing.acceleration(0.0, &start, &()).flight;
    let expected = -9.81 * angle.sin() * across - 0.8 * rate * rate * along;
    let (found, expected) = (found.as_slice(), expected.as_slice());
    close("acceleration", found, expected, 10.0, 1e-14);
    let end = swing.integrate(&start).to(5.0).unwrap();
    let long = (end.flight.position - Vector2::new(0.0, 1.0)).norm();
    close("length", &[long], &[0.8], 1.0, 1e-15);
}

#[test]
fn links_and_cables_of_impossible_lengths() {
    let made = |long: f64, stiffness: f64| Swing::new(SwingParams { long, stiffness }).err();
    assert_eq!(made(0.3, 2.0), None);
    for long in [0.0, -0.8] {
        let error = made(long, 3.0).unwrap();
        let (of, property, value) = ("rope", "length", long);
        let expected = InvalidBody::Property {
            of,
            property,
            value,
        };
        assert_eq!(error, expected);
        let said = format!("the length of `rope` cannot be {long}");
        assert_eq!(error.to_string(), said);
    }
    let (of, property, value) = ("wire", "stiffness", -1.0);
    let expected = InvalidBody::Property {
        of,
        property,
        value,
    };
    assert_eq!(made(0.8, -1.0), Some(expected));
    assert!(matches!(
        made(f64::NAN, 3.0),
        Some(InvalidBody::NotFinite { name: "long", .. })
    ));
}
