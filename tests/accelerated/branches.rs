//! Loads on so many branches that not all are tried: what is divided by is chosen as with few.

use newton_euler::prelude::*;

rigid_body!(Coupled {
    motion: planar_translation,
    mass: 1[kg],
    locals: [
        x = position.in_world().x / 1[m],
        y = position.in_world().y / 1[m],
        a = acceleration.in_world(),
        h = y.abs()
            + (x - 1).abs()
            + (x - 2).abs()
            + (x - 3).abs()
            + (x - 4).abs()
            + (x - 5).abs()
            + (x - 6).abs(),
    ],
    forces: [
        coupling = 1[kg] * world(x * a.x + h * a.y, x * a.y - h * a.x),
        push = world(1[N], 2[N]),
    ],
});

// the same with a coefficient that is zero, which is not proved
rigid_body!(Unproved {
    motion: planar_translation,
    mass: 1[kg],
    locals: [
        x = position.in_world().x / 1[m],
        y = position.in_world().y / 1[m],
        a = acceleration.in_world(),
        zero = (2 * x).sin() - 2 * x.sin() * x.cos(),
        h = 1
            + y.abs()
            + (x - 1).abs()
            + (x - 2).abs()
            + (x - 3).abs()
            + (x - 4).abs()
            + (x - 5).abs()
            + (x - 6).abs(),
    ],
    forces: [
        coupling = 1[kg] * world((1 + zero) * a.x + h * a.y, -h * a.x - zero * a.y),
        push = world(1[N], 2[N]),
    ],
});

fn places() -> impl Iterator<Item = (f64, f64, f64, PlanarTranslation)> {
    let places = [
        (1.0, 1.0),
        (1.0 + 1e-9, 1.0),
        (0.3, 0.7),
        (2.2, 0.4),
        (-1.5, -2.0),
        (8.0, 0.0),
    ];
    places.into_iter().map(|(x, y)| {
        let h = f64::abs(y) + (1..=6).map(|k| (x - f64::from(k)).abs()).sum::<f64>();
        let state = PlanarTranslation {
            position: [x, y].into(),
            ..PlanarTranslation::default()
        };
        (x, y, h, state)
    })
}

/// `(1 - x) a - h b = 1` and `h a + (1 - x) b = 2`, by Cramer's rule.
#[test]
fn a_coefficient_that_vanishes_in_a_state_is_no_divisor() {
    for (x, y, h, state) in places() {
        let (own, found) = (1.0 - x, Coupled::default().acceleration(0.0, &state, &()));
        let determinant = own * own + h * h;
        let expected = [own + 2.0 * h, 2.0 * own - h].map(|of| of / determinant);
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 4e-16, "at ({x}, {y}): {found}");
        }
    }
}

/// `-h b = 1` and `h a + b = 2`
#[test]
fn a_coefficient_that_is_rounding_is_no_divisor() {
    for (x, y, h, state) in places() {
        let h = 1.0 + h;
        let found = Unproved::default().acceleration(0.0, &state, &());
        let expected = [(2.0 + 1.0 / h) / h, -1.0 / h];
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-15, "at ({x}, {y}): {found}");
        }
    }
}
