//! Tops whose axis is no axis of coordinates, with parameters: that they are symmetric is proved for
//! all values.

use newton_euler::integrate::RungeKuttaPair;
use newton_euler::prelude::*;

macro_rules! top {
    ($name:ident $mass:expr, $inertia:expr, $tip:expr) => {
        rigid_body!($name {
            motion: fixed_point(tip),
            params: [k = 0.1],
            mass: $mass,
            inertia: $inertia,
            points: [tip = $tip],
            fields: [weight = mass * world(0, 0, -9.81)],
            outputs: [flow],
        });
    };
}
top!(Lever 1, principal(0.01, 0.01, 0.02).along(body(1, 0, 1)), (-k, 0, -k));
top!(Wide 1, principal(k, k, 0.02).along(body(1, 0, 1)), (-0.1, 0, -0.1));
top!(Disc k, disc(0.2[m]).along(body(1, 2, 2)), (-0.1, -0.2, -0.2));

#[test]
fn oblique_tops_have_closed_forms() {
    let start = Rotation {
        attitude: newton_euler::nalgebra::UnitQuaternion::from_euler_angles(0.3, -0.5, 0.7),
        angular_velocity: [0.4, -1.1, 3.0].into(),
    };
    macro_rules! check {
        ($name:ident) => {
            let top = $name::default();
            let closed = top.integrate(&start).to(1.5).unwrap();
            let stepped = top
                .integrate(&start)
                .method(RungeKuttaPair { tolerance: 1e-12 });
            let stepped = stepped.to(1.5).unwrap();
            let apart = (closed.attitude.coords - stepped.attitude.coords).amax();
            let rates = (closed.angular_velocity - stepped.angular_velocity).amax();
            assert!(
                apart < 1e-8 && rates < 1e-7,
                "{}: {apart}, {rates}",
                stringify!($name)
            );
        };
    }
    check!(Lever);
    check!(Wide);
    check!(Disc);
}
