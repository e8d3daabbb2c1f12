//! Loads that depend linearly on accelerations, and the motion that is consistent with them.

use crate::description::body::Motion;
use crate::wide::Wide;

use super::law::{Motions, acceleration, angular_in_world, motion_of};
use super::loads::{Wrench, acting};
use super::number::Number;
use super::scene::Scene;
use super::unknowns::{inverted, open_loads};

/// What is given of all loads, in the accelerations that the scene has them follow.
pub fn driving(scene: &Scene<'_>) -> Wrench {
    let loads = scene.constants.body.loads.iter();
    let loads = loads.filter_map(|load| acting(scene, load));
    let applied = loads.fold(Wrench::ZERO, |all, one| all.and(one.wrench));
    let open = open_loads(scene, true);
    open.iter().fold(applied, |all, one| all.and(one.given))
}

/// Loads follow these accelerations from now on.
pub fn follow(scene: &Scene<'_>, motions: &Motions) {
    let turning = angular_in_world(scene, motions.angular);
    scene.follow([motions.linear, turning]);
}

/// The motion under the loads that follow it. These are affine in its coordinates x: of
/// `x = c + M x`, c and the columns of M are found by trying zero and units.
pub fn following(scene: &Scene<'_>) -> Motions {
    if !scene.constants.body.follows {
        return acceleration(scene, &driving(scene));
    }
    let count = scene.constants.body.freedoms();
    let tried = |numbers: &[Number]| {
        follow(scene, &motion_of(scene, numbers));
        coordinates(scene, &acceleration(scene, &driving(scene)))
    };
    let rest = tried(&vec![Number::ZERO; count]);
    let columns = (0..count).map(|column| {
        let mut unit = vec![Number::ZERO; count];
        unit[column] = Number::ONE;
        let found = tried(&unit).into_iter().zip(&rest);
        found.map(|(with, rest)| with.value - rest.value).collect()
    });
    let columns: Vec<Vec<Wide>> = columns.collect();
    let row = |i: usize| {
        let entry = |j: usize| if i == j { Wide::ONE } else { Wide::ZERO } - columns[j][i];
        (0..count).map(entry).collect()
    };
    let inverse = inverted((0..count).map(row).collect());
    let values: Vec<Wide> = inverse
        .iter()
        .map(|row| {
            row.iter()
                .zip(&rest)
                .map(|(share, rest)| *share * rest.value)
                .sum()
        })
        .collect();
    // what the terms of the equations leave, by the inverse
    let terms = (0..count).map(|i| {
        let moved = columns.iter().zip(&values);
        let moved = moved.map(|(column, value)| (column[i] * *value).high.abs());
        moved.fold(rest[i].span(), f64::max)
    });
    let terms: Vec<f64> = terms.collect();
    let solved = inverse.iter().zip(&values).map(|(row, value)| {
        let sizes = row
            .iter()
            .zip(&terms)
            .map(|(share, term)| share.high.abs() * term);
        Number::made(*value, sizes.fold(0.0, f64::max), false)
    });
    let solved: Vec<Number> = solved.collect();
    let motions = motion_of(scene, &solved);
    follow(scene, &motions);
    motions
}

/// In the order of the acceleration.
fn coordinates(scene: &Scene<'_>, Motions { linear, angular }: &Motions) -> Vec<Number> {
    let parts = |count: usize| (0..count).map(|i| linear.component(i)).collect::<Vec<_>>();
    let turns = |count: usize| (0..count).map(|i| angular.component(i)).collect::<Vec<_>>();
    match scene.constants.body.motion {
        Motion::Spatial | Motion::Rod(_) => [parts(3), turns(3)].concat(),
        Motion::Planar => [parts(2), turns(1)].concat(),
        Motion::Translation => parts(3),
        Motion::PlanarTranslation => parts(2),
        Motion::Rotation | Motion::FixedPoint(_) => turns(3),
        Motion::Pivot(_) | Motion::FixedAxis(..) => turns(1),
    }
}
