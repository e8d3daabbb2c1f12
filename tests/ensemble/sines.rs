//! Sines and cosines in lanes have the same bits as those computed alone, at every angle.

use std::f64::consts::FRAC_PI_4;

use newton_euler::columns::Source;
use newton_euler::ensemble::Ensemble;
use newton_euler::lanes::Width;
use newton_euler::prelude::*;

use crate::Numbers;

rigid_body!(Circle::<T> {
    motion: planar_translation,
    params: [force = 1[N]],
    inputs: [angle],
    mass: 1[kg],
    forces: [radius = force * world(angle.cos(), angle.sin())],
});

/// Compares with each angle alone, in every register that is there.
fn as_alone(angles: &[f64]) {
    let (body, rest) = (Circle::default(), PlanarTranslation::default());
    let mut members = Ensemble::new(&body, angles.iter().map(|_| rest));
    for (index, &angle) in angles.iter().enumerate() {
        members.inputs_mut().set(index, &CircleInput { angle });
    }
    let alone: Vec<_> = angles
        .iter()
        .map(|&angle| body.acceleration(0.0, &rest, &CircleInput { angle }))
        .collect();
    for width in Width::ALL.into_iter().filter(|width| width.is_there()) {
        members.set_width(width);
        let accelerations = members.accelerations(0.0);
        for (index, (angle, alone)) in angles.iter().zip(&alone).enumerate() {
            let found = accelerations.get(index);
            let same = |x: f64, y: f64| x.to_bits() == y.to_bits() || x.is_nan() && y.is_nan();
            assert!(
                same(found.x, alone.x) && same(found.y, alone.y),
                "{angle:e} in {width:?}: {found:?}, alone {alone:?}"
            );
        }
    }
}

#[test]
fn of_angles_of_every_size() {
    let mut numbers = Numbers(1);
    let exponents = (0..2048_u64).flat_map(|exponent| {
        let mut mantissa = || numbers.take().to_bits() & ((1 << 52) - 1);
        [0, 1, (1 << 52) - 1, mantissa(), mantissa(), mantissa()]
            .map(|mantissa| f64::from_bits(exponent << 52 | mantissa))
    });
    let angles: Vec<f64> = exponents.flat_map(|angle| [angle, -angle]).collect();
    as_alone(&angles);
}

#[test]
fn of_angles_of_use() {
    let mut numbers = Numbers(2);
    for size in [1.0, 10.0, 100.0, 1e4, 2e6] {
        as_alone(
            &(0..20_000)
                .map(|_| size * numbers.take())
                .collect::<Vec<_>>(),
        );
    }
}

/// Where the number of quarter turns changes, and where little is left of the angle.
#[test]
fn of_angles_about_eighths_of_a_turn() {
    let mut numbers = Numbers(3);
    let about = |eighths: i32| {
        let angle = f64::from(eighths) * FRAC_PI_4;
        let aside = 1.0 + 1e-5 * numbers.take();
        let neighbors = (0..34).flat_map(move |power| {
            [
                angle.to_bits() + (1 << power),
                angle.to_bits() - (1 << power),
            ]
            .map(f64::from_bits)
        });
        neighbors.chain([angle, angle * aside])
    };
    let few = (1..=40).chain([101, 1000, 1001, 65_536, 65_537, 1_000_001]);
    let angles: Vec<f64> = few
        .flat_map(about)
        .flat_map(|angle| [angle, -angle])
        .collect();
    as_alone(&angles);
}

/// Lanes that libm does and lanes that it does not, in one register.
#[test]
fn of_lanes_of_every_kind() {
    let kinds = [
        0.0,
        -0.0,
        f64::NAN,
        1.0,
        f64::INFINITY,
        1e300,
        FRAC_PI_4,
        -5e-324,
        3.0,
    ];
    let angles: Vec<f64> = (0..720).map(|k| kinds[k * k / 3 % kinds.len()]).collect();
    as_alone(&angles);
}
