//! A planar body with an offset load, derived a second time by Lagrange's method, in the
//! coordinates of a point that is not the center of mass.

use nalgebra::Vector2;
use newton_euler::prelude::*;
use proptest::prelude::*;

use crate::dual::{Dual, lagrange};

mod hung {
    newton_euler::rigid_body!(Plate {
        motion: planar,
        params: [k = 40[N / m]],
        inputs: [push = body(_, _)[N], pull = world(_, _)[N], twist[N * m]],
        mass: 1.7[kg],
        inertia: 0.31[kg * m ^ 2],
        points: [
            hook = (0.4, -0.1),
            tip = (-0.5, 0.25),
            heel = (-0.2, -0.6),
            anchor = world(1.5, 2)[m],
        ],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
        forces: [
            spring = (k * (anchor.position() - hook.position())).at(hook),
            pushed = push.at(tip),
            pulled = pull.at(heel),
        ],
        moments: [twisted = twist],
    });
}

/// Coordinates: the point at (0.3, 0.2) of the plate in space, and the angle.
type Coordinates = [Dual; 3];

const ORIGIN: [f64; 2] = [0.3, 0.2];

/// Where the point at `r` from G is.
fn place(q: &Coordinates, r: [f64; 2]) -> [Dual; 2] {
    let [x, y] = [r[0] - ORIGIN[0], r[1] - ORIGIN[1]];
    let (cos, sin) = (q[2].cos(), q[2].sin());
    [q[0] + cos * x - sin * y, q[1] + sin * x + cos * y]
}

/// `½ m |v_G|² + ½ J θ'² - m g y_G - ½ k |r_hook - r_anchor|²`
fn lagrangian(q: &Coordinates, dq: &Coordinates) -> Dual {
    // v_G = v + θ' × (G - origin)
    let [x, y] = [-ORIGIN[0], -ORIGIN[1]];
    let (cos, sin) = (q[2].cos(), q[2].sin());
    let vx = dq[0] - dq[2] * (sin * x + cos * y);
    let vy = dq[1] + dq[2] * (cos * x - sin * y);
    let kinetic = (vx * vx + vy * vy) * (1.7 / 2.0) + dq[2] * dq[2] * (0.31 / 2.0);
    let height = place(q, [0.0, 0.0])[1];
    let hook = place(q, [0.4, -0.1]);
    let [dx, dy] = [hook[0] - Dual::from(1.5), hook[1] - Dual::from(2.0)];
    kinetic - height * (1.7 * 9.80665) - (dx * dx + dy * dy) * (40.0 / 2.0)
}

/// The rate at which coordinate `i` moves the point at `r`.
fn moved(q: [f64; 3], i: usize, r: [f64; 2]) -> Vector2<f64> {
    let mut varied = q.map(Dual::from);
    varied[i].first = 1.0;
    place(&varied, r).map(|c| c.first).into()
}

proptest! {
    #[test]
    fn lagrange_agrees(
        x in -2.0..2.0,
        y in -2.0..2.0,
        angle in -7.0..7.0,
        dq in prop::array::uniform3(-4.0..4.0),
        push in prop::array::uniform2(-20.0..20.0),
        pull in prop::array::uniform2(-20.0..20.0),
        twist in -10.0..10.0,
    ) {
        let q = [x, y, angle];
        let moving: [Dual; 3] = core::array::from_fn(|i| Dual::along(q[i], dq[i]));
        let g = place(&moving, [0.0, 0.0]);
        let state = Planar {
            position: g.map(|c| c.value).into(),
            angle,
            velocity: g.map(|c| c.first).into(),
            angular_velocity: dq[2],
        };
        let [push, pull] = [push, pull].map(Vector2::from);
        let input = hung::PlateInput { push, pull, twist };
        let computed = hung::Plate::default().acceleration(0.0, &state, &input);

        // a of the origin: a_G + α × r - ω² r, r = origin - G
        let r = Vector2::new(x, y) - state.position;
        let swung = Vector2::new(-r.y, r.x) * computed.angular;
        let a = computed.linear + swung - r * dq[2].powi(2);
        let left = lagrange(lagrangian, q, dq, [a.x, a.y, computed.angular]);

        let (sin, cos) = f64::sin_cos(angle);
        let pushed = Vector2::new(cos * push.x - sin * push.y, sin * push.x + cos * push.y);
        for i in 0..3 {
            let of_twist = if i == 2 { twist } else { 0.0 };
            let right = pushed.dot(&moved(q, i, [-0.5, 0.25]))
                + pull.dot(&moved(q, i, [-0.2, -0.6]))
                + of_twist;
            // Terms to 40 · 6 N and 240 N at 1 m, some fifty roundings.
            prop_assert!((left[i] - right).abs() <= 240.0 * 50.0 * 1.2e-16, "{i}: {left:?}, {right}");
        }
    }
}
