//! Bodies that are generic over their scalar: single precision, derivatives, constants.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::state::generic;
use newton_euler::{Dual, Scalar, integrate, prelude::*};
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

proptest! {
    /// Results in single precision are those of doubles to a few units in the last place of the largest term.
    #[test]
    fn single_precision(numbers in numbers(), thrust in -5.0..9.0_f64, tilt in -1.0..1.0_f64) {
        // the same inputs to both
        #[expect(clippy::cast_possible_truncation, reason = "to single precision")]
        let numbers = numbers.map(|x| f64::from(x as f32));
        #[expect(clippy::cast_possible_truncation, reason = "to single precision")]
        let (thrust, tilt) = (thrust as f32, tilt as f32);
        let single = Craft::<f32>::default();
        let double = Craft::<f64>::default();
        let input = CraftInput { thrust: f64::from(thrust), tilt: f64::from(tilt) };
        let ours = single.acceleration(0.0, &state(numbers), &CraftInput { thrust, tilt });
        let exact = double.acceleration(0.0, &state(numbers), &input);
        let terms = 9.9 + f64::from(thrust.abs()) + 10.0;
        let close = |a: Vector3<f32>, b: Vector3<f64>, size: f64| (a.map(f64::from) - b).amax() <= 32.0 * f64::from(f32::EPSILON) * size;
        prop_assert!(close(ours.linear, exact.linear, terms), "{ours:?} {exact:?}");
        // over the smallest moment of inertia, and w x J w
        let terms = (0.17 * f64::from(thrust.abs()) + 0.3) / 0.012;
        prop_assert!(close(ours.angular, exact.angular, terms), "{ours:?} {exact:?}");
        let energy = single.kinetic_energy(&state(numbers));
        let exact = double.kinetic_energy(&state(numbers));
        prop_assert!((f64::from(energy) - exact).abs() <= 16.0 * f64::from(f32::EPSILON) * exact);
    }

    /// Derivatives by dual numbers are the limits of differences.
    #[test]
    fn derivatives(numbers in numbers(), thrust in 0.6..6.0_f64, tilt in -1.0..1.0_f64, variable in 0_usize..9) {
        let evaluate = |change: f64| {
            let mut numbers = numbers;
            numbers[variable] += change;
            Craft::<f64>::default().acceleration(0.0, &state(numbers), &CraftInput { thrust, tilt })
        };
        let step = 1e-6;
        prop_assume!(variable != 2 || numbers[2].abs() > 2.0 * step);
        let difference = (evaluate(step).linear - evaluate(-step).linear) / (2.0 * step);
        let turning = (evaluate(step).angular - evaluate(-step).angular) / (2.0 * step);

        let mut state = state::<Derived>(numbers);
        let part = match variable / 3 {
            0 => &mut state.position,
            1 => &mut state.velocity,
            _ => &mut state.angular_velocity,
        };
        part[variable % 3] = Dual::variable(numbers[variable], 0);
        let input = CraftInput { thrust: thrust.into(), tilt: tilt.into() };
        let derived = Craft::<Derived>::default().acceleration(0.0.into(), &state, &input);
        let linear = derived.linear.map(|component| component.derivatives[0]);
        let angular = derived.angular.map(|component| component.derivatives[0]);
        prop_assert!((linear - difference).amax() < 1e-7, "{linear} {difference}");
        prop_assert!((angular - turning).amax() < 1e-6, "{angular} {turning}");
        let plain = evaluate(0.0);
        prop_assert_eq!(derived.linear.map(|component| component.value), plain.linear);
        prop_assert_eq!(derived.angular.map(|component| component.value), plain.angular);
    }
}

rigid_body!(Tie::<T> {
    motion: translation,
    mass: 1[kg],
    // 2^-24 + 1e-20 above one: a double takes it for the middle between two numbers of single precision
    forces: [push = world(1.00000005960464478540, 0, 1e300)],
});

#[test]
fn constants_are_rounded_once() {
    let single = Tie::<f32>::default().acceleration(0.0, &generic::Translation::default(), &());
    assert_eq!(single, Vector3::new(1.0 + f32::EPSILON, 0.0, f32::INFINITY));
    let double = Tie::<f64>::default().acceleration(0.0, &Translation::default(), &());
    assert_eq!(double, Vector3::new(1.0 + 2.0_f64.powi(-24), 0.0, 1e300));
}

rigid_body!(Handle::<T> {
    motion: rotation,
    inertia: principal(1, 2, 3)[kg * m ^ 2],
    outputs: [energy, momentum],
});

/// Round-off in single precision grows with the square root of the steps.
#[test]
fn flips_in_single_precision() {
    let start = generic::Rotation::<f32> {
        angular_velocity: Vector3::new(0.01, 1.0, 0.01),
        ..generic::Rotation::default()
    };
    let handle = Handle::<f32>::default();
    let steps = 4000_u16;
    let end = integrate::cf4(&handle, &start, &(), 0.0..20.0, usize::from(steps));
    assert!(end.angular_velocity.y < -0.9, "it has flipped: {end:?}");
    let bound = 50.0 * f32::EPSILON * f32::from(steps).sqrt();
    let [before, after] = [start, end].map(|state| handle.kinetic_energy(&state));
    assert!((after / before - 1.0).abs() <= bound);
    let [before, after] = [start, end].map(|state| handle.angular_momentum(&state));
    assert!((after - before).amax() <= bound * before.amax());
    let q = end.attitude.as_ref().coords;
    assert!((q.dot(&q) - 1.0).abs() <= 4.0 * f32::EPSILON);
}

rigid_body!(Scaled::<T> {
    motion: rotation,
    params: [scale],
    inertia: tensor {
        xx: 1.3 * scale,
        yy: 1.7 * scale,
        zz: 2.1 * scale,
        xy: -0.12 * scale,
        yz: -0.05 * scale,
        zx: 0.07 * scale,
    },
    inputs: [torque = body(_, _, _)[N * m]],
    moments: [drive = torque],
});

/// The inverse of a tensor at any scale, to 1e-6 in single precision.
#[test]
fn inertias_of_any_scale() {
    let exact = {
        let body = Scaled::new(ScaledParams { scale: 1.0_f64 }).expect("a possible body");
        let torque = Vector3::new(0.3, -0.5, 0.7);
        body.acceleration(0.0, &Rotation::default(), &ScaledInput { torque })
    };
    for scale in [1e-30_f32, 1e-20, 1e-15, 1.0, 1e24, 1e30] {
        let body = Scaled::new(ScaledParams { scale }).expect("a possible body");
        let torque = Vector3::new(0.3, -0.5, 0.7) * scale;
        let still = generic::Rotation::default();
        let ours = body.acceleration(0.0, &still, &ScaledInput { torque });
        let error = (ours.map(f64::from) - exact).amax();
        assert!(error <= 1e-6 * exact.amax(), "{scale:e}: {error:e}");
    }
    let flat = Scaled::new(ScaledParams { scale: 0.0_f32 });
    assert!(flat.is_err() && Scaled::new(ScaledParams { scale: f32::NAN }).is_err());
}

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

/// Elementary functions of dual numbers, by their differences.
#[test]
fn slopes_of_functions() {
    type D = Derived;
    type Function = (fn(D) -> D, fn(f64) -> f64);
    type Pair = (
        fn(Dual<f64, 2>, Dual<f64, 2>) -> Dual<f64, 2>,
        fn(f64, f64) -> f64,
    );
    let functions: [Function; 15] = [
        (D::sin, f64::sin),
        (D::cos, f64::cos),
        (D::tan, f64::tan),
        (D::asin, f64::asin),
        (D::acos, f64::acos),
        (D::atan, f64::atan),
        (D::sinh, f64::sinh),
        (D::cosh, f64::cosh),
        (D::tanh, f64::tanh),
        (D::exp, f64::exp),
        (D::ln, f64::ln),
        (D::sqrt, f64::sqrt),
        (D::cbrt, f64::cbrt),
        (|x| -x.abs() / (x + D::from(2.0)), |x| -x.abs() / (x + 2.0)),
        (
            |x| x.floor() * x.ceil() * x.signum() * x,
            |x| x.floor() * x.ceil() * x,
        ),
    ];
    let step = 1e-6;
    for (index, (ours, plain)) in functions.into_iter().enumerate() {
        for x in [0.1, 0.35, 0.8] {
            let slope = (plain(x + step) - plain(x - step)) / (2.0 * step);
            let dual = ours(D::variable(x, 0));
            assert!((dual.value - plain(x)).abs() < 1e-15, "{index} at {x}");
            assert!(
                (dual.derivatives[0] - slope).abs() < 1e-8,
                "{index} at {x}: {slope}"
            );
        }
    }
    let pairs: [Pair; 5] = [
        (Dual::atan2, f64::atan2),
        (Dual::powf, f64::powf),
        (Dual::hypot, f64::hypot),
        (Dual::min, f64::min),
        (Dual::max, f64::max),
    ];
    for (index, (ours, plain)) in pairs.into_iter().enumerate() {
        for (x, y) in [(0.3, 0.8), (2.5, -1.5)] {
            let dual = ours(Dual::variable(x, 0), Dual::variable(y, 1));
            let slopes = [
                (plain(x + step, y) - plain(x - step, y)) / (2.0 * step),
                (plain(x, y + step) - plain(x, y - step)) / (2.0 * step),
            ];
            for (slope, derivative) in slopes.into_iter().zip(dual.derivatives) {
                assert!(
                    (derivative - slope).abs() < 1e-8,
                    "{index} at {x}, {y}: {slope}"
                );
            }
        }
    }
    // a negative base under a constant exponent
    let cube = D::variable(-2.0, 0).powf(D::from(3.0));
    assert!((cube.derivatives[0] - 12.0).abs() < 1e-14);
}

/// Derivatives of derivatives.
#[test]
fn second_derivatives() {
    type Second = Dual<Dual<f64, 1>, 1>;
    let x = Second {
        value: Dual::variable(0.7, 0),
        derivatives: [Dual::from(1.0)],
    };
    let cube = (x * x * x).derivatives[0].derivatives[0];
    assert!((cube - 6.0 * 0.7).abs() < 1e-15);
    // (1 + u^2)^(3/2) at the bottom, by power and by root
    let u = Second {
        value: Dual::variable(0.0, 0),
        derivatives: [Dual::from(1.0)],
    };
    let one = Second::from(Dual::from(1.0));
    let (square, power) = (one + u * u, Second::from(Dual::from(1.5)));
    for bowl in [square.powf(power), square * square.sqrt()] {
        assert!(
            (bowl.derivatives[0].derivatives[0] - 3.0).abs() < 1e-15,
            "{bowl:?}"
        );
    }
}

/// Quadratic drag has no slope at rest, and a length of nothing none either.
#[test]
fn derivatives_at_rest() {
    let still = generic::Spatial::<Derived> {
        velocity: Vector3::new(
            Dual::from(2.0) + Derived::variable(0.0, 0),
            Dual::from(0.5),
            Dual::from(-0.3),
        ),
        ..generic::Spatial::default()
    };
    let input = CraftInput {
        thrust: 1.0.into(),
        tilt: 0.0.into(),
    };
    let acceleration = Craft::default().acceleration(0.0.into(), &still, &input);
    assert_eq!(
        acceleration.linear.map(|a| a.derivatives[0]),
        Vector3::zeros()
    );
    let [zero, length] = [
        Derived::from(0.0),
        Derived::from(0.0).hypot(Derived::from(0.0)),
    ];
    assert_eq!([zero.sqrt().derivatives, length.derivatives], [[0.0]; 2]);
}

/// The numbers of another crate give the derivatives of ours, and second ones that ours give when nested.
#[test]
fn numbers_of_num_dual() {
    use newton_euler::scalar::NumDual;
    use num_dual::{Dual2_64, Dual64};

    /// Lists the numbers of an acceleration.
    fn list<T: Scalar>(acceleration: generic::SpatialAcceleration<T>) -> [T; 6] {
        let ([a, b, c], [x, y, z]) = (acceleration.linear.into(), acceleration.angular.into());
        [a, b, c, x, y, z]
    }

    /// The acceleration of a craft whose first velocity and tilt are given.
    fn accelerated<T: Scalar>(speed: T, tilt: T, time: T) -> [T; 6] {
        let mut state = state::<T>([
            0.3, -0.2, -0.4, 0.0, 0.7, -1.1, 0.4, 0.2, -0.6, 0.1, 0.5, -0.3, 0.8,
        ]);
        state.velocity.x = speed;
        let thrust = time.constant(4.0, 4.0);
        list(Craft::<T>::default().acceleration(time, &state, &CraftInput { thrust, tilt }))
    }

    type Twice = Dual<Dual<f64, 1>, 1>;
    let close = |one: f64, other: f64| (one - other).abs() <= 1e-13 * (1.0 + other.abs());
    let theirs = accelerated(
        NumDual(Dual64::from_re(1.3).derivative()),
        NumDual(Dual64::from(0.4)),
        NumDual::default(),
    );
    let ours = accelerated::<Derived>(Dual::variable(1.3, 0), Dual::from(0.4), Dual::from(0.0));
    for (theirs, ours) in theirs.iter().zip(ours) {
        assert!(close(theirs.0.re, ours.value) && close(theirs.0.eps, ours.derivatives[0]));
    }
    let second = accelerated(
        NumDual(Dual2_64::from_re(1.3).derivative()),
        NumDual(Dual2_64::from(0.4)),
        NumDual::default(),
    );
    let mut speed = Twice::variable(Dual::variable(1.3, 0), 0);
    speed.derivatives[0] = Dual::from(1.0);
    let ours = accelerated::<Twice>(speed, Dual::from(Dual::from(0.4)), Dual::default());
    for (theirs, ours) in second.iter().zip(ours) {
        assert!(
            close(theirs.0.v2, ours.derivatives[0].derivatives[0]),
            "{theirs:?} {ours:?}"
        );
    }
    // the functions that are not that crate's own
    let x = |value: f64| NumDual(Dual64::from_re(value).derivative());
    let parts = |number: NumDual<Dual64>| (number.0.re, number.0.eps);
    assert_eq!(parts(x(-2.0).abs()), (2.0, -1.0));
    assert_eq!(parts(x(-2.5).floor()), (-3.0, 0.0));
    assert_eq!(parts(x(-2.5).signum()), (-1.0, 0.0));
    for size in [1.0, 1e200] {
        let (length, slope) = parts(x(3.0 * size).hypot(NumDual(Dual64::from(4.0 * size))));
        assert!(close(length / size, 5.0) && close(slope, 0.6));
    }
    assert_eq!(
        parts(x(-2.0).powf(NumDual(Dual64::from(3.0)))),
        (-8.0, 12.0)
    );
    assert_eq!(parts(x(2.0).min(NumDual(Dual64::from(3.0)))), (2.0, 1.0));
    assert_eq!(parts(x(2.0).max(NumDual(Dual64::from(3.0)))), (3.0, 0.0));
    assert_eq!(
        parts(x(f64::NAN).max(NumDual(Dual64::from(3.0)))),
        (3.0, 0.0)
    );
}

/// The error of a result in single precision, in units of the last place of the exact one.
fn units_off(result: f32, exact: f64) -> f64 {
    #[expect(clippy::cast_possible_truncation, reason = "to single precision")]
    let near = (exact as f32).abs();
    let unit = f64::from(near.next_up()) - f64::from(near);
    (f64::from(result) - exact).abs() / unit
}

/// Sine and cosine in single precision are own code, without doubles: compared with those of doubles at angles of all sizes.
#[test]
fn sines_in_single_precision() {
    let mut worst = [0.0_f64; 3];
    let mut check = |place: usize, angle: f32| {
        let (sine, cosine) = Scalar::sin_cos(angle);
        let exact = f64::from(angle).sin_cos();
        let off = units_off(sine, exact.0).max(units_off(cosine, exact.1));
        worst[place] = worst[place].max(off);
        assert_eq!((Scalar::sin(angle), Scalar::cos(angle)), (sine, cosine));
        let opposite = Scalar::sin_cos(-angle);
        assert_eq!(
            (opposite.0.to_bits(), opposite.1),
            ((-sine).to_bits(), cosine),
            "{angle}"
        );
    };
    for bits in (0..100_f32.to_bits()).step_by(2003) {
        check(0, f32::from_bits(bits));
    }
    for bits in (100_f32.to_bits()..f32::INFINITY.to_bits()).step_by(2003) {
        check(1, f32::from_bits(bits));
    }
    // next to multiples of a quarter turn, where next to nothing is left
    for turns in (1..10_000_u32).chain((0..10_000).map(|k| 400_000 * k + 10_000)) {
        let exact = f64::from(turns) * std::f64::consts::FRAC_PI_2;
        #[expect(clippy::cast_possible_truncation, reason = "to single precision")]
        let near = exact as f32;
        for angle in [near.next_down(), near, near.next_up()] {
            check(2, angle);
        }
    }
    assert!(
        worst[0] < 0.8 && worst[1] < 0.85 && worst[2] < 0.85,
        "{worst:?}"
    );
    for angle in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let (sine, cosine) = Scalar::sin_cos(angle);
        assert!(sine.is_nan() && cosine.is_nan());
    }
}
