//! Bodies that are generic over their scalar: single precision, derivatives, constants.

mod another_crate;
mod derivatives;
mod single;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::state::generic;
use newton_euler::{Dual, Scalar, prelude::*};
use proptest::prelude::*;

rigid_body!(Craft::<T> {
    doc: "Everything that a generic body can have.",
    motion: spatial,
    params: [
        arm = 0.17[m],
        drag_ratio = 0.016[m],
        wind = world(2, 0.5, -0.3)[m / s]
    ],
    inputs: [thrust[N], tilt],
    mass: 1.2[kg],
    inertia: tensor {
        xx: 0.0123,
        yy: 0.0131,
        zz: 0.0224,
        xy: 0.0005,
        yz: -0.0004,
        zx: 0.0002,
    }[kg * m ^ 2],
    points: [front = (arm, 0, 0)],
    locals: [relative = velocity - wind],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        lift = body(0, thrust * tilt.sin(), thrust * tilt.cos()).at(front),
        drag = -0.03 * relative.norm() * relative,
        push = if position.in_world().z < 0 && thrust > 0 || thrust == 7 {
            world(0, 0, 5)
        } else {
            world(0, 0, 0.5)
        },
    ],
    moments: [twist = body(0, 0, drag_ratio * thrust.max(0.5))],
    outputs: [energy, momentum, balance],
});

/// A state by the numbers that it is made of.
fn state<T: Scalar>(numbers: [f64; 13]) -> generic::Spatial<T> {
    #[expect(clippy::cast_possible_truncation, reason = "to single precision")]
    let mut numbers = numbers
        .map(|x| T::default().constant(x, x as f32))
        .into_iter();
    let mut next = || numbers.next().expect("thirteen numbers");
    let mut vector = || Vector3::new(next(), next(), next());
    let [position, velocity, angular_velocity] = [vector(), vector(), vector()];
    let [x, y, z, w] = [next(), next(), next(), next()];
    let norm = (x * x + y * y + z * z + w * w).sqrt();
    generic::Spatial {
        position,
        velocity,
        angular_velocity,
        attitude: UnitQuaternion::new_unchecked(Quaternion::new(
            w / norm,
            x / norm,
            y / norm,
            z / norm,
        )),
    }
}

fn numbers() -> impl Strategy<Value = [f64; 13]> {
    prop::array::uniform13(-3.0..3.0_f64).prop_filter("a quaternion", |numbers| {
        numbers[9..].iter().map(|x| x * x).sum::<f64>() > 0.1
    })
}

/// A number with one derivative.
type Derived = Dual<f64, 1>;

rigid_body!(Ladder::<T> {
    motion: planar,
    params: [length = 3[m]],
    mass: 12[kg],
    inertia: mass * length.powi(2) / 12,
    points: [foot = (-length / 2, 0), head = (length / 2, 0)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [
        floor = foot.position().in_world().y,
        wall = head.position().in_world().x
    ],
    reactions: [up = world(0, _).at(foot), away = world(_, 0).at(head)],
    outputs: [energy, reactions],
});

/// A ladder against a wall: constraints in single precision, with derivatives, and kept in doubles.
#[test]
fn constraints() {
    let placed = |angle: f64| Planar {
        position: [-1.5 * angle.cos(), 1.5 * angle.sin()].into(),
        angle,
        ..Planar::default()
    };
    let double = Ladder::<f64>::default();
    let exact = double.acceleration(0.0, &placed(1.0), &());
    // closed form: (3 g / 2 l) cos, falling
    let expected = -1.5 * 9.80665 / 3.0 * 1.0_f64.cos();
    assert!((exact.angular - expected).abs() < 1e-12, "{exact:?}");

    let single = Ladder::<f32>::default();
    #[expect(clippy::cast_possible_truncation, reason = "to single precision")]
    let state = generic::Planar::<f32> {
        position: placed(1.0).position.map(|x| x as f32),
        angle: 1.0,
        ..generic::Planar::default()
    };
    let ours = single.acceleration(0.0, &state, &());
    assert!((f64::from(ours.angular) - expected).abs() < 1e-5);
    let forces = single.reactions(0.0, &state, &()).expect("both are needed");
    let exact = double
        .reactions(0.0, &placed(1.0), &())
        .expect("both are needed");
    assert!((f64::from(forces.up.y) - exact.up.y).abs() < 1e-4 * exact.up.y);

    // d/dangle of (3 g / 2 l) cos, along the constraints
    let angle = Derived::variable(1.0, 0);
    let along = generic::Planar {
        position: [
            angle.cos() * Dual::from(-1.5),
            angle.sin() * Dual::from(1.5),
        ]
        .into(),
        angle,
        ..generic::Planar::default()
    };
    let derived = Ladder::<Derived>::default().acceleration(Dual::from(0.0), &along, &());
    let slope = 1.5 * 9.80665 / 3.0 * 1.0_f64.sin();
    assert!((derived.angular.derivatives[0] - slope).abs() < 1e-12);

    let mut beside = placed(1.0);
    beside.position.x += 0.01;
    double
        .project(0.0, &mut beside, &())
        .expect("a ladder near by");
    let violations = double.violations(0.0, &beside, &());
    assert!(
        violations
            .iter()
            .all(|violation| violation.position.is_some_and(|g| g.abs() < 1e-14))
    );
}
