//! Functions with second derivatives: potentials and constraints that are linearized.

use newton_euler::prelude::*;

/// J, of m and a share: x^3 y + exp(x y), with all its derivatives.
mod bowl {
    pub fn value(x: f64, y: f64) -> f64 {
        x.powi(3) * y + (x * y).exp()
    }

    pub fn by_x(x: f64, y: f64) -> f64 {
        3.0 * x.powi(2) * y + y * (x * y).exp()
    }

    pub fn by_y(x: f64, y: f64) -> f64 {
        x.powi(3) + x * (x * y).exp()
    }

    pub fn by_xx(x: f64, y: f64) -> f64 {
        6.0 * x * y + y.powi(2) * (x * y).exp()
    }

    pub fn by_xy(x: f64, y: f64) -> f64 {
        3.0 * x.powi(2) + (1.0 + x * y) * (x * y).exp()
    }

    pub fn by_yy(x: f64, y: f64) -> f64 {
        x.powi(2) * (x * y).exp()
    }
}

rigid_body!(Marble {
    motion: translation,
    mass: 2[kg],
    functions: [bowl(x[m], y) = bowl::value[J].derivatives(
        bowl::by_x.derivatives(bowl::by_xx, _),
        // the mixed derivative is given once, and its place does not matter
        bowl::by_y.derivatives(bowl::by_xy, bowl::by_yy),
    ),],
    locals: [place = position.in_world()],
    potentials: [bowl = bowl(place.x, place.y / 1[m])],
    outputs: [linearization],
});

#[test]
fn a_potential_is_linearized() {
    let marble = Marble::new().unwrap();
    for (x, y) in [(0.4, -0.7), (1.1, 0.3), (-0.2, 1.9)] {
        let state = Translation {
            position: [x, y, 0.0].into(),
            ..Default::default()
        };
        let a = marble.linearize(0.0, &state, &()).a();
        let stiffness = [
            [bowl::by_xx(x, y), bowl::by_xy(x, y)],
            [bowl::by_xy(x, y), bowl::by_yy(x, y)],
        ];
        for (row, stiffness) in stiffness.into_iter().enumerate() {
            for (column, stiffness) in stiffness.into_iter().enumerate() {
                let error = a[(3 + row, column)] + stiffness / 2.0;
                assert!(error.abs() < 1e-15 * (1.0 + stiffness.abs()), "{error:e}");
            }
        }
    }
}

/// The height of a wire, and three derivatives.
mod wire {
    pub fn height(x: f64) -> f64 {
        (2.0 * x).sin() / 2.0
    }

    pub fn slope(x: f64) -> f64 {
        (2.0 * x).cos()
    }

    pub fn curve(x: f64) -> f64 {
        -2.0 * (2.0 * x).sin()
    }

    pub fn third(x: f64) -> f64 {
        -4.0 * (2.0 * x).cos()
    }
}

rigid_body!(Bead {
    motion: planar_translation,
    mass: 0.3[kg],
    functions: [
        height(x[m]) = wire::height[m]
            .derivatives(wire::slope.derivatives(wire::curve.derivatives(wire::third))),
        slope(x[m]) = wire::slope.derivatives(wire::curve),
    ],
    locals: [place = position.in_world()],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    constraints: [wire = place.y - height(place.x)],
    reactions: [normal = _ * world(-slope(place.x), 1)],
    outputs: [linearization],
});

#[test]
fn a_constraint_is_linearized() {
    let bead = Bead::new().unwrap();
    for (x, v) in [(0.4, -0.7), (1.1, 0.3), (-0.2, 1.9)] {
        let (slope, curve, third) = (wire::slope(x), wire::curve(x), wire::third(x));
        let state = PlanarTranslation {
            position: [x, wire::height(x)].into(),
            velocity: [v, slope * v].into(),
        };
        // x'' = -h' (g + h'' v^2) / (1 + h'^2)
        let (pull, share) = (9.81 + curve * v * v, 1.0 + slope * slope);
        let found = bead.acceleration(0.0, &state, &()).x;
        assert!((found + slope * pull / share).abs() < 1e-13);
        let by_x = 2.0 * slope * slope * curve * pull / share.powi(2)
            - (curve * pull + slope * third * v * v) / share;
        let by_v = -2.0 * slope * curve * v / share;
        let a = bead.linearize(0.0, &state, &()).a();
        assert!((a[(2, 0)] - by_x).abs() < 1e-13, "{} {by_x}", a[(2, 0)]);
        assert!((a[(2, 2)] - by_v).abs() < 1e-13, "{} {by_v}", a[(2, 2)]);
    }
}
