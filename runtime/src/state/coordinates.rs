//! States as lists of numbers.

use core::fmt::Debug;
use core::ops::Range;

use nalgebra::{Quaternion, Unit, UnitQuaternion, Vector3, Vector4};

use super::generic;
use super::space::State;
use crate::mechanics::attitude::generic::kinematics;
use crate::numbers::scalar::Scalar;

/// A state as a list of coordinates: position, attitude or angle or axis, velocity, and their
/// rates, as far as they exist, in this order; components x, y, z, for an attitude with the scalar
/// last. For a system: all coordinates, joint by joint, and then all their rates; user-defined
/// states are last.
pub trait Coordinates: State<Scalar: Scalar> {
    /// `[Scalar; COUNT]`, for a system a [`List`](super::List).
    type Array: Copy + Debug + Default + Send + AsRef<[Self::Scalar]> + AsMut<[Self::Scalar]>;

    /// The sizes of groups of coordinates with the same unit. The second half of the
    /// groups are the rates of the first. For a user-defined state, whose rate comes from the
    /// equations, the first is empty.
    const GROUPS: &'static [usize];

    /// The places of an attitude quaternion and of the angular velocity in body axes,
    /// if there are such axes; for a system, if a single joint has them.
    const AXES: Option<[usize; 2]> = None;

    /// The coordinates of this state.
    fn coordinates(&self) -> Self::Array;

    /// The state with these coordinates, unchanged: see [`keep`](Self::keep).
    fn from_coordinates(coordinates: &Self::Array) -> Self;

    /// The derivatives of the coordinates with respect to time, given the acceleration in this
    /// state; for an attitude q the components of `q (0, ω) / 2`.
    fn rates(&self, acceleration: &Self::Acceleration) -> Self::Array;

    /// Corrects a small change of coordinates, so that attitude and axis stay unit to rounding, and
    /// the rate of an axis perpendicular to it.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn keep(_coordinates: &Self::Array, _change: &mut Self::Array) {}
}

/// The next numbers of a list, as many as a group has.
#[cfg_attr(not(unoptimized), inline(always))]
pub(crate) fn group<'l, T>(list: &mut &'l [T], count: usize) -> &'l [T] {
    let (group, rest) = list.split_at_checked(count).unwrap_or((*list, &[]));
    *list = rest;
    group
}

/// Implements the lists: the fields of a state one after another, its rates, and which of its
/// coordinates are a unit vector.
macro_rules! plain {
    ($(
        $state:ident: $count:literal, $groups:expr,
        |$this:ident| $read:expr,
        |$list:pat_param| $write:expr,
        |$moving:ident, $acceleration:ident| $rates:expr
        $(, unit $unit:expr $(, across $rate:expr)?)? $(, axes $axes:expr)?;
    )*) => {$(
        impl<T: Scalar> Coordinates for generic::$state<T> {
            type Array = [T; $count];
            const GROUPS: &'static [usize] = &$groups;
            $(const AXES: Option<[usize; 2]> = Some($axes);)?

            #[cfg_attr(not(unoptimized), inline(always))]
            fn coordinates(&self) -> Self::Array {
                let $this = self;
                $read
            }

            #[cfg_attr(not(unoptimized), inline(always))]
            fn from_coordinates(coordinates: &Self::Array) -> Self {
                let $list = *coordinates;
                $write
            }

            #[cfg_attr(not(unoptimized), inline(always))]
            fn rates(&self, acceleration: &Self::Acceleration) -> Self::Array {
                let ($moving, $acceleration) = (self, acceleration);
                $rates
            }

            $(#[cfg_attr(not(unoptimized), inline(always))]
            fn keep(coordinates: &Self::Array, change: &mut Self::Array) {
                shorten(&coordinates[$unit], &mut change[$unit]);
                $(level(coordinates, change, $unit, $rate);)?
            }
            )?
        }
    )*};
}

plain! {
    Hinge: 2, [1, 1],
        |state| [state.angle, state.angular_velocity],
        |[angle, angular_velocity]| Self { angle, angular_velocity },
        |state, angular| [state.angular_velocity, *angular];
    Slide: 2, [1, 1],
        |state| [state.position, state.velocity],
        |[position, velocity]| Self { position, velocity },
        |state, linear| [state.velocity, *linear];
    Cylinder: 4, [1, 1, 1, 1],
        |state| [state.position, state.angle, state.velocity, state.angular_velocity],
        |[position, angle, velocity, angular_velocity]| {
            Self { position, angle, velocity, angular_velocity }
        },
        |state, acceleration| {
            let [v, w] = [state.velocity, state.angular_velocity];
            [v, w, acceleration.linear, acceleration.angular]
        };
    Universal: 4, [1, 1, 1, 1],
        |state| {
            let [first, second] = [state.angular_velocity_1, state.angular_velocity_2];
            [state.angle_1, state.angle_2, first, second]
        },
        |[angle_1, angle_2, angular_velocity_1, angular_velocity_2]| {
            Self { angle_1, angle_2, angular_velocity_1, angular_velocity_2 }
        },
        |state, angular| {
            let [first, second] = [state.angular_velocity_1, state.angular_velocity_2];
            [first, second, angular.x, angular.y]
        };
    PlanarTranslation: 4, [2, 2],
        |state| {
            let [p, v] = [state.position, state.velocity];
            [p.x, p.y, v.x, v.y]
        },
        |[x, y, vx, vy]| Self { position: [x, y].into(), velocity: [vx, vy].into() },
        |state, linear| {
            let [v, a] = [state.velocity, *linear];
            [v.x, v.y, a.x, a.y]
        };
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
        },
        |state, acceleration| {
            let [v, a] = [state.velocity, acceleration.linear];
            [v.x, v.y, state.angular_velocity, a.x, a.y, acceleration.angular]
        };
    Translation: 6, [3, 3],
        |state| {
            let [p, v] = [state.position, state.velocity];
            [p.x, p.y, p.z, v.x, v.y, v.z]
        },
        |[x, y, z, vx, vy, vz]| Self { position: [x, y, z].into(), velocity: [vx, vy, vz].into() },
        |state, linear| {
            let [v, a] = [state.velocity, *linear];
            [v.x, v.y, v.z, a.x, a.y, a.z]
        };
    Rotation: 7, [4, 3],
        |state| {
            let ([x, y, z, w], r) = (state.attitude.coords.into(), state.angular_velocity);
            [x, y, z, w, r.x, r.y, r.z]
        },
        |[x, y, z, w, wx, wy, wz]| Self {
            attitude: unit([x, y, z, w]),
            angular_velocity: [wx, wy, wz].into(),
        },
        |state, angular| {
            let ([x, y, z, w], b) = (kinematics(&state.attitude, &state.angular_velocity).coords.into(), *angular);
            [x, y, z, w, b.x, b.y, b.z]
        },
        unit 0..4, axes [0, 4];
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
        |state, acceleration| {
            let [v, a, b] = [state.velocity, acceleration.linear, acceleration.angular];
            let [x, y, z, w] = kinematics(&state.attitude, &state.angular_velocity).coords.into();
            [v.x, v.y, v.z, x, y, z, w, a.x, a.y, a.z, b.x, b.y, b.z]
        },
        unit 3..7, axes [3, 10];
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
        |state, acceleration| {
            let [v, r, a, b] = [state.velocity, state.axis_rate, acceleration.linear, acceleration.axis];
            [v.x, v.y, v.z, r.x, r.y, r.z, a.x, a.y, a.z, b.x, b.y, b.z]
        },
        unit 3..6, across 9..12;
}

#[cfg_attr(not(unoptimized), inline(always))]
fn unit<T: Scalar>([x, y, z, w]: [T; 4]) -> UnitQuaternion<T> {
    UnitQuaternion::new_unchecked(Quaternion {
        coords: Vector4::new(x, y, z, w),
    })
}

/// Corrects the change of a unit vector by a Newton step.
#[cfg_attr(not(unoptimized), inline(always))]
fn shorten<T: Scalar>(vector: &[T], change: &mut [T]) {
    let (half, one) = (vector[0].constant(0.5, 0.5), vector[0].constant(1.0, 1.0));
    let mut excess = -one;
    for (x, d) in vector.iter().zip(change.iter()) {
        excess += (*x + *d) * (*x + *d);
    }
    for (change, x) in change.iter_mut().zip(vector) {
        *change -= half * excess * (*x + *change);
    }
}

/// Removes the component along a unit vector from a change of its rate.
#[cfg_attr(not(unoptimized), inline(always))]
fn level<T: Scalar>(coordinates: &[T], change: &mut [T], unit: Range<usize>, rate: Range<usize>) {
    let mut along = T::default();
    for (u, r) in unit.clone().zip(rate.clone()) {
        along += (coordinates[u] + change[u]) * (coordinates[r] + change[r]);
    }
    for (u, r) in unit.zip(rate) {
        change[r] -= along * (coordinates[u] + change[u]);
    }
}
