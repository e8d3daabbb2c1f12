//! Tables in descriptions: at, between and beyond their grid points, with one argument and with
//! two.

mod files;

use nalgebra::Vector3;
use newton_euler::ensemble::Ensemble;
use newton_euler::integrate::{Classical4, Fixed};
use newton_euler::prelude::*;
use newton_euler::structure::Structured;

rigid_body!(Read::<T> {
    motion: translation,
    mass: 1[kg],
    inputs: [x[rad]],
    forces: [
        line = world(
            table(x, [-20, 0, 10, 30][deg], [-1.5, 0.25, 1, 0.5][N]),
            0,
            0
        ),
        smooth = world(
            0,
            table(x, [-20, 0, 10, 30][deg], [-1.5, 0.25, 1, 0.5][N], cubic),
            0
        ),
        beyond = world(
            0,
            0,
            table(
                x,
                [-20, 0, 10, 30][deg],
                [-1.5, 0.25, 1, 0.5][N],
                cubic,
                extrapolated
            )
        ),
    ],
});

/// The knots of all of them, in radians.
fn knots() -> [(f64, f64); 4] {
    [(-20.0, -1.5), (0.0, 0.25), (10.0, 1.0), (30.0, 0.5)]
        .map(|(x, y): (f64, f64)| (x.to_radians(), y))
}

fn read(x: f64) -> Vector3<f64> {
    let input = ReadInput { x };
    Read::<f64>::default().acceleration(0.0, &Translation::default(), &input)
}

#[test]
fn at_the_places_it_has_the_values() {
    for (x, y) in knots() {
        assert!((read(x) - Vector3::repeat(y)).amax() < 1e-15, "{}", read(x));
    }
}

#[test]
fn between_them_it_is_a_line() {
    for pair in knots().windows(2) {
        let [(a, p), (b, q)] = [pair[0], pair[1]];
        for share in [0.1, 0.4, 0.9] {
            let found = read(a + share * (b - a)).x;
            assert!((found - (p + share * (q - p))).abs() < 1e-15);
        }
    }
}

/// Beyond the ends the values stay, or the polynomials go on.
#[test]
#[allow(clippy::float_cmp, reason = "a value that is held is the value")]
fn beyond_them() {
    let [first, .., last] = knots();
    assert_eq!([read(-3.0).x, read(-3.0).y], [first.1; 2]);
    assert_eq!([read(3.0).x, read(3.0).y], [last.1; 2]);
    // a cubic has no fourth difference
    let h = 0.1;
    let values = [0.0, 1.0, 2.0, 3.0, 4.0].map(|n| read(last.0 + 0.01 + n * h).z);
    let [a, b, c, d, e] = values;
    assert!((a - 4.0 * b + 6.0 * c - 4.0 * d + e).abs() < 1e-12);
    assert!((values[4] - last.1).abs() > 0.1);
    assert!(read(f64::NAN).iter().all(|part| part.is_nan()));
}

/// It rises where the values do, and its slope has no jumps.
#[test]
fn a_cubic_is_monotone_and_smooth() {
    let slope = |x: f64| (read(x + 1e-6).y - read(x - 1e-6).y) / 2e-6;
    for pair in knots().windows(2) {
        let [(a, p), (b, q)] = [pair[0], pair[1]];
        let at = |n: i32| read(a + f64::from(n) / 100.0 * (b - a)).y;
        for n in 0..100 {
            assert!((at(n + 1) - at(n)) * (q - p).signum() >= -1e-15);
        }
        let (before, after) = (slope(b - 1e-5), slope(b + 1e-5));
        assert!((before - after).abs() < 1e-2 || b > 0.5, "{before} {after}");
    }
    // the slope at 0: that of the parabola through three knots
    let (h, k) = (20_f64.to_radians(), 10_f64.to_radians());
    let (d, e) = (1.75 / h, 0.75 / k);
    assert!((slope(0.0) - (k * d + h * e) / (h + k)).abs() < 1e-4);
    // and none at the highest value
    assert!(slope(10_f64.to_radians()).abs() < 1e-4);
}

rigid_body!(Field {
    motion: translation,
    mass: 2[kg],
    params: [set = 0.3],
    inputs: [a[rad], v[m / s]],
    locals: [
        lift = table(
            a,
            v,
            [0, 0.1, 0.3],
            [10, 20][m / s],
            [[0, 0], [1, 3], [2, 7]][N]
        ),
        fixed = table(0.25, [0, 1], [4, 8][N]),
        early = table(set, [0, 1], [4, 8][N]),
        twice = table(a, [0, 1], [4, 8][N]) - table(a, [0, 1], [4, 8][N]),
    ],
    forces: [all = world(lift, fixed, early), none = world(twice, 0, 0)],
});

#[test]
fn of_two_scalars() {
    let at = |a: f64, v: f64| {
        let input = FieldInput { a, v };
        Field::default().acceleration(0.0, &Translation::default(), &input)
    };
    assert!((at(0.1, 10.0).x - 0.5).abs() < 1e-15);
    assert!((at(0.05, 15.0).x - 0.5 * 0.5 * (0.5 + 1.5)).abs() < 1e-15);
    assert!(
        (at(0.25, 12.0).x - 0.5 * (0.25 * (0.8 + 0.2 * 3.0) + 0.75 * (2.0 * 0.8 + 0.2 * 7.0)))
            .abs()
            < 1e-15
    );
    assert!((at(9.0, 99.0).x - 3.5).abs() < 1e-15);
    let found = at(0.1, 10.0);
    assert!((found.y - 2.5).abs() < 1e-15 && (found.z - 0.5 * 5.2).abs() < 1e-15);
}

rigid_body!(Bowl {
    motion: translation,
    mass: 1[kg],
    potentials: [bowl = table(position.in_world().x, [-1, 0, 2][m], [3, 0, 8][J], cubic)],
    outputs: [energy, linearization],
});

/// A force is what the table changes by, and so are blocks of a linearization.
#[test]
fn derivatives_go_piece_by_piece() {
    let bowl = Bowl::default();
    for x in [-0.7, -0.2, 0.3, 1.4] {
        let at = |x: f64| Translation {
            position: Vector3::x() * x,
            ..Translation::default()
        };
        let energy = |x: f64| bowl.potential_energy(0.0, &at(x), &());
        let force = |x: f64| bowl.acceleration(0.0, &at(x), &()).x;
        let h = 1e-5;
        assert!((force(x) + (energy(x + h) - energy(x - h)) / (2.0 * h)).abs() < 1e-8);
        let by_place = bowl.linearize(0.0, &at(x), &()).a()[(3, 0)];
        assert!((by_place - (force(x + h) - force(x - h)) / (2.0 * h)).abs() < 1e-8);
    }
    let structure = Bowl::STRUCTURE;
    assert!(!structure.is_force_free && structure.linear.position);
}

#[test]
fn in_single_precision_and_in_lanes() {
    let input = |x: f32| ReadInput { x };
    let state = newton_euler::state::generic::Translation::<f32>::default();
    let body = Read::<f32>::default();
    for x in [-0.3_f32, 0.1, 0.2, 0.9] {
        let found = body.acceleration(0.0, &state, &input(x));
        let expected = read(f64::from(x));
        assert!((f64::from(found.x) - expected.x).abs() < 1e-6);
        assert!((f64::from(found.y) - expected.y).abs() < 1e-6);
    }
}

rigid_body!(Cable::<T> {
    motion: translation,
    mass: 1[kg],
    locals: [x = position.in_world().x],
    forces: [pull = world(-table(x, [-1, 0, 0.5, 2][m], [-3, 0, 1, 8][N], cubic), 0, 0)],
});

/// Each member of an ensemble reads its table as it would alone, to the bit.
#[test]
fn in_lanes() {
    let body = Cable::<f64>::default();
    let start = |n: i32| Translation {
        position: Vector3::x() * (f64::from(n) * 0.37 - 2.0),
        ..Translation::default()
    };
    let mut ensemble = Ensemble::new(&body, (0..13).map(start));
    let method = Fixed {
        method: Classical4,
        step: 0.05,
    };
    ensemble
        .integrate()
        .method(method)
        .to(1.0)
        .expect("it is smooth enough");
    for (n, state) in (0..13).zip(ensemble.states().iter()) {
        let alone = body.integrate(&start(n)).method(method).to(1.0).unwrap();
        assert_eq!(state.position, alone.position);
    }
}
