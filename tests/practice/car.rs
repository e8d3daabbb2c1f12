//! A car on two wheels, one at the front and one at the rear, with tires by H. Pacejka's formula.

use newton_euler::nalgebra::Matrix2;
use newton_euler::prelude::*;

rigid_body!(Car {
    doc: "A car of one track; its tires push sideways by the magic formula.",
    motion: planar,
    params: [front_arm = 1.2[m], rear_arm = 1.4[m], grip = 0.95],
    inputs: [steer[rad], drive[N]],
    mass: 1500[kg],
    inertia: 2400[kg * m ^ 2],
    points: [front = (front_arm, 0), rear = (-rear_arm, 0)],
    locals: [
        weight = mass * 9.81[m / s ^ 2],
        base = front_arm + rear_arm,
        at_front = front.velocity().in_body(),
        at_rear = rear.velocity().in_body(),
        front_slip = 9 * (at_front.y.atan2(at_front.x) - steer),
        rear_slip = 11 * at_rear.y.atan2(at_rear.x),
        front_bent = front_slip + 0.6 * (front_slip - front_slip.atan()),
        rear_bent = rear_slip + 0.6 * (rear_slip - rear_slip.atan()),
        front_side = -grip * weight * rear_arm / base * (1.4 * front_bent.atan()).sin(),
        rear_side = -grip * weight * front_arm / base * (1.4 * rear_bent.atan()).sin(),
    ],
    forces: [
        front_tire = (front_side * body(-steer.sin(), steer.cos())).at(front),
        rear_tire = body(drive, rear_side).at(rear),
    ],
    outputs: [linearization],
});

const MASS: f64 = 1500.0;
const INERTIA: f64 = 2400.0;
const FRONT: f64 = 1.2;
const REAR: f64 = 1.4;
const BASE: f64 = FRONT + REAR;

/// Of a tire with this stiffness factor under this share of the weight, by its slip angle.
fn side(factor: f64, share: f64, slip: f64) -> f64 {
    let x = factor * slip;
    let bent = x + 0.6 * (x - x.atan());
    -0.95 * MASS * 9.81 * share * (1.4 * bent.atan()).sin()
}

/// Where a function that falls is zero.
fn root(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    for _halving in 0..200 {
        let middle = f64::midpoint(low, high);
        if f(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    f64::midpoint(low, high)
}

/// A steady turn by hand: sideslip velocity, steer and drive of a speed ahead u and a rate r.
fn steady_turn(u: f64, r: f64) -> [f64; 3] {
    let across = MASS * r * u;
    // moments about the other axle
    let (at_front, at_rear) = (across * REAR / BASE, across * FRONT / BASE);
    let slip = root(-0.1, 0.1, |slip| side(11.0, FRONT / BASE, slip) - at_rear);
    let v = REAR * r + u * slip.tan();
    let heading = (v + FRONT * r).atan2(u);
    let front = |steer: f64| side(9.0, REAR / BASE, heading - steer);
    let steer = root(-0.3, 0.3, |steer| at_front - front(steer) * steer.cos());
    [v, steer, front(steer) * steer.sin() - MASS * r * v]
}

#[test]
fn a_steady_turn_is_that_by_hand() {
    let car = Car::default();
    let ahead = |u: f64| Planar {
        velocity: [u, 0.0].into(),
        ..Planar::default()
    };
    for (u, r) in [(5.0, 0.3), (20.0, 0.2), (25.0, -0.25), (30.0, 0.25)] {
        let [v, steer, drive] = steady_turn(u, r);
        // the heading is what is free: along the velocity that is given
        let speed = u.hypot(v);
        let search = car.trim(&ahead(speed)).turning([0.0, 0.0, r]);
        let search = search.free(["angle", "steer", "drive"]);
        let turn = search.solve().expect("it holds the road");
        let slip = -turn.state.angle;
        assert!((slip - v.atan2(u)).abs() < 1e-12, "{u} {r}: {slip}");
        assert!((turn.input.steer - steer).abs() < 1e-12, "{u} {r}");
        assert!((turn.input.drive - drive).abs() < 1e-8, "{u} {r}");
    }
}

/// Straight ahead: the equations of sideslip and rate that textbooks have, with the slope of the formula at zero.
#[test]
fn modes_are_those_of_the_linear_model() {
    let car = Car::default();
    for u in [10.0, 20.0, 40.0] {
        let stiffness = |factor: f64, share: f64| 0.95 * MASS * 9.81 * share * 1.4 * factor;
        let (front, rear) = (stiffness(9.0, REAR / BASE), stiffness(11.0, FRONT / BASE));
        let turn = FRONT * front - REAR * rear;
        let known = Matrix2::new(
            -(front + rear) / (MASS * u),
            -turn / (MASS * u) - u,
            -turn / (INERTIA * u),
            -(FRONT * FRONT * front + REAR * REAR * rear) / (INERTIA * u),
        );
        let state = Planar {
            velocity: [u, 0.0].into(),
            ..Planar::default()
        };
        let trimmed = car.trim(&state).free(["steer", "drive"]).solve();
        let modes = trimmed.expect("straight on").modes().expect("finite");
        let moving: Vec<_> = modes.iter().filter(|mode| !mode.is_neutral).collect();
        let product: f64 = if moving.len() == 1 {
            moving[0].natural_frequency().powi(2)
        } else {
            moving.iter().map(|mode| mode.natural_frequency()).product()
        };
        assert!((product / known.determinant() - 1.0).abs() < 1e-9, "{u}");
        assert!(modes.is_stable());
    }
}
