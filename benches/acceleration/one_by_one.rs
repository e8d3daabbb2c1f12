//! One body after another: generated code, compared with hand-written code.

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

use crate::bodies::{
    Free, FreePrincipal, General, GeneralInput, Plane, PlaneInput, Principal, PrincipalInput,
    Upright, UprightInput,
};
use crate::by_hand::{Flat, SineAndCosine, Space, Turning, Unturned, diagonal, full};
use crate::pair::{Pair, Side};
use crate::table::Table;

fn spatial(x: f64) -> (Spatial, Vector3<f64>) {
    let state = Spatial {
        attitude: UnitQuaternion::from_euler_angles(x, 2.0 * x, 3.0 * x),
        angular_velocity: Vector3::new(x.sin(), x.cos(), (2.0 * x).sin()),
        ..Spatial::default()
    };
    (state, state.angular_velocity * 3.0)
}

fn rotation(x: f64) -> (Rotation, ()) {
    let (state, _) = spatial(x);
    let rotation = Rotation {
        attitude: state.attitude,
        angular_velocity: state.angular_velocity,
    };
    (rotation, ())
}

fn planar(x: f64) -> (Planar, Vector3<f64>) {
    let state = Planar {
        angle: x,
        angular_velocity: x.sin(),
        ..Planar::default()
    };
    (state, Vector3::new(3.0, 1.0, 0.0) * x.sin())
}

fn planar_in_space(x: f64) -> (Spatial, Vector3<f64>) {
    let (flat, force) = planar(x);
    let state = Spatial {
        attitude: UnitQuaternion::from_euler_angles(0.0, 0.0, flat.angle),
        angular_velocity: Vector3::z() * flat.angular_velocity,
        ..Spatial::default()
    };
    (state, force)
}

fn apart(one: &SpatialAcceleration, other: &SpatialAcceleration) -> f64 {
    (one.linear - other.linear).norm() + (one.angular - other.angular).norm()
}

fn apart_in_space(one: &PlanarAcceleration, other: &SpatialAcceleration) -> f64 {
    let in_space = SpatialAcceleration {
        linear: one.linear.push(0.0),
        angular: Vector3::z() * one.angular,
    };
    apart(&in_space, other)
}

pub fn measure(table: &mut Table) {
    in_space(table);
    in_the_plane(table);
    free(table);
}

fn in_space(table: &mut Table) {
    let by_hand = |state: &mut Spatial, force: &mut Vector3<f64>, a: &SpatialAcceleration| {
        state.angular_velocity += a.angular * 1e-6;
        *force += a.linear * 1e-9;
    };

    let general = Side::new(General::<f64>::default(), |x| {
        let (state, force) = spatial(x);
        (state, GeneralInput { force })
    });
    let against = Side::new(Space::new(full()), spatial);
    let pair = Pair::checked("general body", &general, &against, apart);
    pair.independent(table, [Some(1.05), Some(1.1)]);
    let ours = |state: &mut Spatial, input: &mut GeneralInput<f64>, a: &SpatialAcceleration| {
        by_hand(state, &mut input.force, a);
    };
    pair.chain(table, Some(1.1), ours, by_hand);

    let principal = Side::new(Principal::default(), |x| {
        let (state, force) = spatial(x);
        (state, PrincipalInput { force })
    });
    let against = Side::new(Space::new(diagonal()), spatial);
    let pair = Pair::checked("principal axes", &principal, &against, apart);
    pair.independent(table, [Some(0.65), Some(0.6)]);
    let ours = |state: &mut Spatial, input: &mut PrincipalInput, a: &SpatialAcceleration| {
        by_hand(state, &mut input.force, a);
    };
    pair.chain(table, Some(0.75), ours, by_hand);
}

fn in_the_plane(table: &mut Table) {
    let plane = Side::new(Plane::default(), |x| {
        let (state, force) = planar(x);
        (state, PlaneInput { force: force.xy() })
    });
    let space = Side::new(Space::flat(), planar_in_space);
    let what = "planar body, against space";
    let pair = Pair::checked(what, &plane, &space, apart_in_space);
    pair.independent(table, [Some(0.35), Some(0.35)]);

    // how much of the time these two functions take
    let turned = Side::new(SineAndCosine, |x| (planar(x).0, ()));
    let what = "its sine and cosine alone, against space";
    let pair = Pair::checked(what, &turned, &space, |one, _| {
        (one.linear.norm() - 1.0).abs()
    });
    pair.independent(table, [None, None]);

    let upright = Side::new(Upright::default(), |x| {
        let ((state, force), moment) = (planar(x), x.cos());
        let force = force.xy();
        (state, UprightInput { force, moment })
    });
    let space = Side::new(Unturned(Space::flat()), |x| {
        let (state, force) = planar_in_space(x);
        (state, (force, Vector3::z() * x.cos()))
    });
    let what = "planar body, loads in world axes, against space";
    let pair = Pair::checked(what, &upright, &space, apart_in_space);
    pair.independent(table, [Some(0.35), Some(0.35)]);

    let flat = Side::new(Flat::new(), |x| {
        let (state, force) = planar(x);
        (state, force.xy())
    });
    let pair = Pair::checked("planar body, against plane", &plane, &flat, |one, other| {
        (one.linear - other.linear).norm() + (one.angular - other.angular).abs()
    });
    pair.independent(table, [None, None]);
    let by_hand =
        |state: &mut Planar, force: &mut nalgebra::Vector2<f64>, a: &PlanarAcceleration| {
            state.angle += a.angular * 1e-6;
            *force += a.linear * 1e-9;
        };
    let ours = |state: &mut Planar, input: &mut PlaneInput, a: &PlanarAcceleration| {
        by_hand(state, &mut input.force, a);
    };
    pair.chain(table, None, ours, by_hand);
}

fn free(table: &mut Table) {
    // without a force, a body in space rotates in the same way
    let unpushed = |x| (spatial(x).0, Vector3::zeros());
    let carry = |state: &mut Rotation, (): &mut (), angular: &Vector3<f64>| {
        state.angular_velocity += angular * 1e-6;
    };
    let angular = |one: &Vector3<f64>, other: &SpatialAcceleration| (one - other.angular).norm();
    let same = |one: &Vector3<f64>, other: &Vector3<f64>| (one - other).norm();

    let ours = Side::new(Free::default(), rotation);
    let space = Side::new(Space::new(full()), unpushed);
    let pair = Pair::checked("free rotation, against space", &ours, &space, angular);
    pair.independent(table, [Some(0.5), Some(0.5)]);
    let against = Side::new(Turning::new(full()), rotation);
    let pair = Pair::checked("free rotation, against rotation", &ours, &against, same);
    pair.independent(table, [None, None]);
    pair.chain(table, None, carry, carry);

    let ours = Side::new(FreePrincipal::default(), rotation);
    let against = Side::new(Turning::new(diagonal()), rotation);
    let what = "free rotation, principal axes, against rotation";
    let pair = Pair::checked(what, &ours, &against, same);
    pair.independent(table, [None, None]);
    pair.chain(table, None, carry, carry);
}
