//! User-defined states with every kind of motion: the accelerations and other outputs are those of
//! the same body with the state as an input.

use newton_euler::prelude::*;

/// The same body twice, with a load that is a state, and with one that is an input.
macro_rules! kinds {
    ($($name:ident { $($key:ident: $value:tt $(($($more:tt)*))?,)* } $state:ty, $outputs:tt;)*) => {$(
        mod $name {
            use super::*;

            rigid_body!(Own {
                states: [load[N]],
                rates: [load = -load / 0.5[s]],
                $($key: $value $(($($more)*))?,)*
                outputs: $outputs,
            });

            rigid_body!(Given {
                inputs: [load[N]],
                $($key: $value $(($($more)*))?,)*
                outputs: $outputs,
            });

            #[test]
            fn beside_an_input() {
                let motion = <$state as Somewhere>::somewhere();
                let (own, given) = (Own::default(), Given::default());
                let (state, input) = (OwnState { motion, load: 1.7 }, GivenInput { load: 1.7 });
                let found = own.acceleration(0.0, &state, &());
                let same = given.acceleration(0.0, &motion, &input);
                assert_eq!(found, OwnAcceleration { motion: same, load: -3.4 });
                let residual = own.residual(0.0, &state, &found, &Default::default(), &());
                let expected = given.residual(0.0, &motion, &same, &Default::default(), &input);
                assert_eq!(residual, expected);
                assert_eq!(own.kinetic_energy(&state), given.kinetic_energy(&motion));
                let found = own.linearize(0.0, &state, &());
                assert_eq!(found.acceleration.motion, same);
                let (a, b) = (found.a(), given.linearize(0.0, &motion, &input).b());
                for row in 0..b.nrows() {
                    assert_eq!(a[(row, a.ncols() - 1)], b[(row, 0)]);
                }
                // along series and in steps
                let integrate = || own.integrate(&state);
                let series = integrate().tolerance(1e-13).to(0.4).unwrap();
                let method = newton_euler::integrate::DormandPrince { tolerance: 1e-14 };
                let steps = integrate().method(method).to(0.4).unwrap();
                let error = crate::distance(&series, &steps);
                assert!(error < 1e-11, "{error:e}");
                assert!((series.load - 1.7 * (-0.8_f64).exp()).abs() < 1e-12);
            }
        }
    )*};
}

trait Somewhere {
    fn somewhere() -> Self;
}

macro_rules! somewhere {
    ($($state:ident { $($field:ident: $value:expr),* })*) => {$(
        impl Somewhere for $state {
            fn somewhere() -> Self {
                Self { $($field: $value),* }
            }
        }
    )*};
}

fn attitude() -> nalgebra::UnitQuaternion<f64> {
    nalgebra::UnitQuaternion::from_euler_angles(0.3, -0.9, 1.4)
}

fn axis() -> nalgebra::UnitVector3<f64> {
    nalgebra::UnitVector3::new_normalize(nalgebra::Vector3::new(0.6, 0.0, 0.8))
}

somewhere! {
    Spatial {
        position: [0.4, -0.7, 1.1].into(),
        attitude: attitude(),
        velocity: [1.3, 2.1, -0.6].into(),
        angular_velocity: [0.5, -1.4, 0.8].into()
    }
    Rotation { attitude: attitude(), angular_velocity: [0.5, -1.4, 0.8].into() }
    Translation { position: [0.4, -0.7, 1.1].into(), velocity: [1.3, 2.1, -0.6].into() }
    Planar {
        position: [0.4, -0.7].into(),
        angle: 0.3,
        velocity: [1.3, 2.1].into(),
        angular_velocity: 0.7
    }
    PlanarTranslation { position: [0.4, -0.7].into(), velocity: [1.3, 2.1].into() }
    Hinge { angle: 0.4, angular_velocity: -0.9 }
    Rod {
        position: [0.4, -0.7, 1.1].into(),
        velocity: [1.3, 2.1, -0.6].into(),
        axis: axis(),
        axis_rate: [0.8, 0.5, -0.6].into()
    }
}

kinds! {
    spatial {
        motion: spatial,
        mass: 2,
        inertia: principal(1, 2, 2.5),
        points: [tip = (0.1, 0.2, 0.3)],
        forces: [push = body(load, 0, 2 * load).at(tip)],
    } Spatial, [energy, balance, taylor, linearization];
    rotation {
        motion: rotation,
        inertia: principal(2, 2, 2.5),
        moments: [push = body(0.1 * load, 0, 2 * load)],
    } Rotation, [energy, balance, taylor, linearization];
    translation {
        motion: translation,
        mass: 2,
        forces: [push = world(load, 0, 2 * load)],
    } Translation, [energy, balance, taylor, linearization];
    planar {
        motion: planar,
        mass: 2,
        inertia: 1.5,
        points: [tip = (0.1, 0.2)],
        forces: [push = body(load, 0).at(tip)],
    } Planar, [energy, balance, taylor, linearization];
    planar_translation {
        motion: planar_translation,
        mass: 2,
        forces: [push = world(load, 0.3 * load)],
    } PlanarTranslation, [energy, balance, taylor, linearization];
    pivot {
        motion: pivot(hinge),
        mass: 2,
        inertia: 1.5,
        points: [hinge = (0.1, 0.2), tip = (1, 0)],
        forces: [push = body(load, 0.3 * load).at(tip)],
        reactions: [pin = world(_, _).at(hinge)],
    } Hinge, [energy, balance, reactions, taylor, linearization];
    fixed_axis {
        motion: fixed_axis(hinge, world(0, 0, 1)),
        mass: 2,
        inertia: principal(1, 2, 2.5),
        points: [hinge = (0.1, 0.2, 0), tip = (1, 0, 0)],
        forces: [push = body(load, 0.3 * load, 0).at(tip)],
        reactions: [pin = world(_, _, _).at(hinge), couple = moment(body(_, _, 0))],
    } Hinge, [energy, balance, reactions, taylor, linearization];
    fixed_point {
        motion: fixed_point(hinge),
        mass: 2,
        inertia: principal(1, 2, 2.5),
        points: [hinge = (0.1, 0.2, 0), tip = (1, 0, 0)],
        forces: [push = world(load, 0.3 * load, 0).at(tip)],
        reactions: [pin = world(_, _, _).at(hinge)],
    } Rotation, [energy, balance, reactions, taylor, linearization];
    rod {
        motion: rod(body(1, 0, 0)),
        mass: 2,
        inertia: 1.5,
        points: [tip = (1, 0, 0)],
        forces: [push = world(load, 0.3 * load, 0).at(tip)],
    } Rod, [energy, balance, taylor, linearization];
}
