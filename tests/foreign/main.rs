//! Rust constants and functions in descriptions, compared with the same laws written by hand.

mod slopes;

use newton_euler::ensemble::Ensemble;
use newton_euler::integrate::{Classical4, Fixed};
use newton_euler::prelude::*;
use newton_euler::{Dual, Scalar};

mod curves {
    pub const AREA: f64 = 16.2;

    pub fn mass() -> f64 {
        1043.0
    }

    /// N, of m/s and a share.
    pub fn thrust(speed: f64, throttle: f64) -> f64 {
        throttle * (4000.0 - 20.0 * speed)
    }

    pub fn lift(alpha: f64) -> f64 {
        0.3 + 0.1 * alpha - 1e-4 * alpha.powi(3)
    }

    pub fn lift_slope(alpha: f64) -> f64 {
        0.1 - 3e-4 * alpha.powi(2)
    }
}

rigid_body!(Glider {
    motion: planar_translation,
    constants: [area = curves::AREA[m ^ 2], weight_of = curves::mass()[kg]],
    functions: [
        thrust(speed[m / s], throttle) = curves::thrust[N],
        lift(alpha[deg]) = curves::lift.derivatives(curves::lift_slope),
    ],
    inputs: [throttle, alpha[rad]],
    mass: weight_of,
    locals: [
        speed = velocity.norm(),
        pressure = 0.6[kg / m ^ 3] * speed.powi(2)
    ],
    forces: [
        engine = thrust(speed, throttle) * world(1, 0),
        wing = pressure * area * lift(alpha) * world(0, 1),
    ],
});

#[test]
fn a_body() {
    let glider = Glider::new().unwrap();
    let state = PlanarTranslation {
        velocity: [40.0, 30.0].into(),
        ..Default::default()
    };
    let input = GliderInput {
        throttle: 0.7,
        alpha: 0.05,
    };
    let found = glider.acceleration(0.0, &state, &input);
    let lift = curves::lift(0.05_f64.to_degrees());
    let expected = [0.7 * 3000.0, 0.6 * 2500.0 * 16.2 * lift].map(|force| force / 1043.0);
    assert!((found.x - expected[0]).abs() < 1e-13 * expected[0]);
    assert!((found.y - expected[1]).abs() < 1e-13 * expected[1]);
}

/// The energy of a spring that stiffens, and its slopes.
fn energy<T: Scalar>(stretch: T, stiffness: T) -> T {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "the nearest in single precision"
    )]
    let number = |value: f64| stretch.constant(value, value as f32);
    stiffness * (stretch.cosh() - number(1.0))
}

fn energy_by_stretch<T: Scalar>(stretch: T, stiffness: T) -> T {
    stiffness * stretch.sinh()
}

/// Of a wind that grows with height, a gust that is not smooth.
fn gust<T: Scalar>(height: T) -> T {
    height.abs().sqrt().min(height.constant(1.5, 1.5))
}

fn ballast<T: Scalar>(depth: T) -> T {
    depth + depth
}

const STIFFNESS: f64 = 3.0;

rigid_body!(Bead::<T> {
    motion: translation,
    constants: [stiffness = STIFFNESS[kN]],
    params: [depth = 0.4[m]],
    functions: [
        energy(stretch, stiffness) = energy[J].derivatives(energy_by_stretch, _),
        gust(height[m]) = gust[N],
        ballast(depth[m]) = ballast[kg],
    ],
    mass: 1[kg] + ballast(depth),
    potentials: [spring = energy(position.in_world().x / 2[m], stiffness / 1[N])],
    forces: [wind = gust(position.in_world().z) * world(0, 1, 0)],
    outputs: [energy],
});

fn bead() -> Bead<f64> {
    Bead::new(BeadParams::default()).unwrap()
}

fn at<T: Scalar>(x: T, z: T) -> newton_euler::state::generic::Translation<T> {
    newton_euler::state::generic::Translation {
        position: [x, T::default(), z].into(),
        ..Default::default()
    }
}

/// The force of a potential is its derivative, and units count in arguments and results.
#[test]
fn a_potential() {
    for (x, z) in [(0.7, 0.09), (-2.0, -0.5), (3.0, 7.0)] {
        let found = bead().acceleration(0.0, &at(x, z), &());
        let force = [
            -3000.0 * (x / 2.0_f64).sinh() / 2.0,
            z.abs().sqrt().min(1.5),
        ];
        assert!((found.x - force[0] / 1.8).abs() < 1e-12 * force[0].abs());
        assert!((found.y - force[1] / 1.8).abs() < 1e-15);
        let energy = bead().potential_energy(0.0, &at(x, z), &());
        let expected = 3000.0 * ((x / 2.0_f64).cosh() - 1.0);
        assert!((energy - expected).abs() < 1e-12 * expected);
    }
}

/// A function over any scalar is differentiated by dual numbers, whether a derivative is given or
/// not, and runs in single precision.
#[test]
fn other_scalars() {
    let dual = |value: f64| Dual {
        value,
        derivatives: [1.0],
    };
    let body = Bead::<Dual<f64, 1>>::new(BeadParams {
        depth: Dual {
            value: 0.4,
            derivatives: [0.0],
        },
    });
    let found = body
        .unwrap()
        .acceleration(dual(0.0), &at(dual(0.6), dual(0.25)), &());
    let by_x = -3000.0 * 0.3_f64.cosh() / 4.0 / 1.8;
    assert!((found.x.derivatives[0] - by_x).abs() < 1e-12 * by_x.abs());
    assert!((found.y.derivatives[0] - 1.0 / 1.8).abs() < 1e-15);

    let single = Bead::<f32>::new(BeadParams { depth: 0.4 }).unwrap();
    let found = f64::from(single.acceleration(0.0, &at(0.6, 0.25), &()).x);
    let expected = bead().acceleration(0.0, &at(0.6, 0.25), &()).x;
    assert!((found - expected).abs() < 1e-5 * expected.abs());
}

/// Each member of an ensemble, in its lane, moves as it would alone, to the bit.
#[test]
fn in_lanes() {
    let start = |n: i32| at(f64::from(n) * 0.1 - 0.7, f64::from(n) * 0.3);
    let method = Fixed {
        method: Classical4,
        step: 0.002,
    };
    let mut ensemble = Ensemble::new(&bead(), (0..13).map(start));
    ensemble.integrate().method(method).to(0.1).unwrap();
    for (n, state) in (0..13).zip(ensemble.states().iter()) {
        let alone = bead().integrate(&start(n)).method(method).to(0.1).unwrap();
        assert_eq!(state, alone);
    }
}

rigid_body!(Kite {
    motion: translation,
    constants: [mass_of = STIFFNESS[kg]],
    functions: [pull(x[m], speed[m / s]) = pull[N].derivatives(pull_by_x, pull_by_speed)],
    params: [gain = 2],
    inputs: [wind[m / s]],
    mass: mass_of,
    forces: [
        line = gain * pull(position.in_world().x, wind - velocity.in_world().x) * world(1, 0, 0)
    ],
    outputs: [linearization, sensitivity],
});

fn pull(x: f64, speed: f64) -> f64 {
    (x * speed).sin()
}

fn pull_by_x(x: f64, speed: f64) -> f64 {
    speed * (x * speed).cos()
}

fn pull_by_speed(x: f64, speed: f64) -> f64 {
    x * (x * speed).cos()
}

#[test]
fn given_derivatives_are_linearized() {
    let kite = Kite::new(KiteParams::default()).unwrap();
    let mut state = at(0.4, 0.0);
    state.velocity.x = 0.3;
    let input = KiteInput { wind: 2.0 };
    let blocks = kite.linearize(0.0, &state, &input);
    let share = 2.0 / 3.0 * (0.4 * 1.7_f64).cos();
    assert!((blocks.a()[(3, 0)] - share * 1.7).abs() < 1e-15);
    assert!((blocks.a()[(3, 3)] + share * 0.4).abs() < 1e-15);
    assert!((blocks.b()[(3, 0)] - share * 0.4).abs() < 1e-15);
    let by_gain = kite.sensitivity(0.0, &state, &input);
    let expected = (0.4 * 1.7_f64).sin() / 3.0;
    assert!((by_gain.linear_by_gain.x - expected).abs() < 1e-15);
}

rigid_system!(Pair {
    motion: planar,
    constants: [arm = 0.5 + 0.25],
    functions: [friction(rate[rad / s]) = f64::tanh[N * m]],
    bodies: [rod {
        mass: 2[kg],
        inertia: 0.3[kg * m ^ 2],
        points: [hinge = (-arm * 1[m], 0)]
    }],
    joints: [hinge = revolute(world(0, 0), rod.hinge)],
    drives: [drag = (-friction(hinge.angular_velocity)).on(hinge)],
});

#[test]
fn in_a_system() {
    let pair = Pair::new().unwrap();
    let state = PairState {
        hinge: Hinge {
            angle: 0.3,
            angular_velocity: 0.8,
        },
    };
    let found = pair.acceleration(0.0, &state, &()).hinge;
    let expected = -0.8_f64.tanh() / (0.3 + 2.0 * 0.75 * 0.75);
    assert!((found - expected).abs() < 1e-15);
}

const LOST: f64 = f64::NAN;

rigid_body!(Lost {
    motion: translation,
    mass: 1[kg],
    constants: [lost = LOST[N]],
    forces: [pull = lost * world(1, 0, 0)],
});

rigid_body!(Heavy {
    motion: translation,
    constants: [mass_of = -STIFFNESS[kg]],
    mass: mass_of,
});

#[test]
fn constants_are_checked_in_new() {
    assert!(matches!(
        Lost::new(),
        Err(InvalidBody::NotFinite { name: "lost", .. })
    ));
    assert!(matches!(Heavy::new(), Err(InvalidBody::Mass { .. })));
}

/// What stands in a function is seen by a description there.
#[test]
fn within_a_function() {
    fn slope(x: f64) -> f64 {
        2.0 * x
    }
    const GAIN: f64 = 5.0;
    rigid_body!(Local {
        motion: translation,
        mass: 1[kg],
        constants: [gain = GAIN[N]],
        functions: [slope(slope[s]) = slope],
        forces: [pull = gain * slope(t) * world(1, 0, 0)],
    });
    let found = Local::new()
        .unwrap()
        .acceleration(3.0, &Translation::default(), &());
    assert!((found.x - 30.0).abs() < 1e-14);
}
