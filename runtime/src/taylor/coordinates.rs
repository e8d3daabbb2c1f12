//! States as lists of numbers.

use core::ops::Range;

use nalgebra::{Quaternion, Unit, UnitQuaternion, Vector3, Vector4};

use crate::state::{Hinge, Planar, PlanarTranslation, Rod, Rotation, Spatial, State, Translation};

/// A state as a list of coordinates: position, attitude or angle or axis, velocity, and their rates, those that there are,
/// in this order; components x, y, z, of an attitude with the scalar last.
pub trait Coordinates: State<Scalar = f64> {
    /// `[f64; COUNT]`
    type Array: Copy + core::fmt::Debug + AsRef<[f64]> + AsMut<[f64]>;

    /// All coordinates zero.
    const ZERO: Self::Array;

    /// How many coordinates belong together: each group is of one unit.
    const GROUPS: &'static [usize];

    /// The coordinates of this state.
    fn coordinates(&self) -> Self::Array;

    /// The state with these coordinates, as they are: see [`keep`](Self::keep).
    fn from_coordinates(coordinates: &Self::Array) -> Self;

    /// Corrects a small change of coordinates, so that attitude and axis stay unit to rounding, and the rate of an axis across it.
    #[inline(always)]
    fn keep(_coordinates: &Self::Array, _change: &mut Self::Array) {}
}

/// The lists: the fields of a state one after another, and which of its coordinates are a unit vector.
macro_rules! plain {
    ($($state:ident: $count:literal, $groups:expr, $read:expr, $write:expr $(, unit $unit:expr $(, across $rate:expr)?)?;)*) => {$(
        impl Coordinates for $state {
            type Array = [f64; $count];
            const ZERO: Self::Array = [0.0; $count];
            const GROUPS: &'static [usize] = &$groups;

            #[inline(always)]
            fn coordinates(&self) -> Self::Array {
                let read: fn(&Self) -> Self::Array = $read;
                read(self)
            }

            #[inline(always)]
            fn from_coordinates(coordinates: &Self::Array) -> Self {
                let write: fn(Self::Array) -> Self = $write;
                write(*coordinates)
            }

            $(#[inline(always)]
            fn keep(coordinates: &Self::Array, change: &mut Self::Array) {
                shorten(&coordinates[$unit], &mut change[$unit]);
                $(level(coordinates, change, $unit, $rate);)?
            })?
        }
    )*};
}

plain! {
    Hinge: 2, [1, 1],
        |state| [state.angle, state.angular_velocity],
        |[angle, angular_velocity]| Self { angle, angular_velocity };
    PlanarTranslation: 4, [2, 2],
        |state| {
            let [p, v] = [state.position, state.velocity];
            [p.x, p.y, v.x, v.y]
        },
        |[x, y, vx, vy]| Self { position: [x, y].into(), velocity: [vx, vy].into() };
    Planar: 6, [2, 1, 2, 1],
        |state| {
            let [p, v] = [state.position, state.velocity];
            [p.x, p.y, state.angle, v.x, v.y, state.angular_velocity]
        },
        |[x, y, angle, vx, vy, angular_velocity]| Self {
            position: [x, y].into(),
            angle,
            velocity: [vx, vy].into(),
            angular_velocity,
        };
    Translation: 6, [3, 3],
        |state| {
            let [p, v] = [state.position, state.velocity];
            [p.x, p.y, p.z, v.x, v.y, v.z]
        },
        |[x, y, z, vx, vy, vz]| Self { position: [x, y, z].into(), velocity: [vx, vy, vz].into() };
    Rotation: 7, [4, 3],
        |state| {
            let ([x, y, z, w], r) = (state.attitude.coords.into(), state.angular_velocity);
            [x, y, z, w, r.x, r.y, r.z]
        },
        |[x, y, z, w, wx, wy, wz]| Self {
            attitude: unit([x, y, z, w]),
            angular_velocity: [wx, wy, wz].into(),
        },
        unit 0..4;
    Spatial: 13, [3, 4, 3, 3],
        |state| {
            let [p, v, r] = [state.position, state.velocity, state.angular_velocity];
            let [x, y, z, w] = state.attitude.coords.into();
            [p.x, p.y, p.z, x, y, z, w, v.x, v.y, v.z, r.x, r.y, r.z]
        },
        |[px, py, pz, x, y, z, w, vx, vy, vz, wx, wy, wz]| Self {
            position: [px, py, pz].into(),
            attitude: unit([x, y, z, w]),
            velocity: [vx, vy, vz].into(),
            angular_velocity: [wx, wy, wz].into(),
        },
        unit 3..7;
    Rod: 12, [3, 3, 3, 3],
        |state| {
            let [p, v, u, r] = [state.position, state.velocity, *state.axis, state.axis_rate];
            [p.x, p.y, p.z, u.x, u.y, u.z, v.x, v.y, v.z, r.x, r.y, r.z]
        },
        |[px, py, pz, ux, uy, uz, vx, vy, vz, rx, ry, rz]| {
            Self {
                position: [px, py, pz].into(),
                velocity: [vx, vy, vz].into(),
                axis: Unit::new_unchecked(Vector3::new(ux, uy, uz)),
                axis_rate: [rx, ry, rz].into(),
            }
        },
        unit 3..6, across 9..12;
}

#[inline(always)]
fn unit([x, y, z, w]: [f64; 4]) -> UnitQuaternion<f64> {
    UnitQuaternion::new_unchecked(Quaternion {
        coords: Vector4::new(x, y, z, w),
    })
}

/// Corrects the change of a unit vector by a Newton step.
#[inline(always)]
fn shorten(vector: &[f64], change: &mut [f64]) {
    let sums = vector.iter().zip(change.iter()).map(|(x, d)| x + d);
    let excess = sums.fold(-1.0, |square, sum| square + sum * sum);
    for (change, x) in change.iter_mut().zip(vector) {
        *change -= 0.5 * excess * (x + *change);
    }
}

/// Takes from a change of the rate of a unit vector what is along that vector.
#[inline(always)]
fn level(coordinates: &[f64], change: &mut [f64], unit: Range<usize>, rate: Range<usize>) {
    let sum = |k: usize, change: &[f64]| coordinates[k] + change[k];
    let pairs = unit.clone().zip(rate.clone());
    let along: f64 = pairs.map(|(u, r)| sum(u, change) * sum(r, change)).sum();
    for (u, r) in unit.zip(rate) {
        change[r] -= along * sum(u, change);
    }
}
