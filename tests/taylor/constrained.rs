//! Series under constraints, compared with closed forms and with Runge–Kutta steps.

use newton_euler::integrate::{DormandPrince, Projected};
use newton_euler::prelude::*;

// a pendulum whose rod is a constraint, and the same one with a pin
rigid_body!(Bob {
    motion: planar_translation,
    mass: 1.3[kg],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [rod = position.norm() - 0.8[m]],
    reactions: [tension = _ * position.normalize()],
    outputs: [taylor, energy],
});

rigid_body!(Pinned {
    motion: pivot(pin),
    mass: 1.3[kg],
    inertia: 0[kg * m ^ 2],
    points: [pin = (0, 0.8[m])],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

#[test]
fn a_pendulum_by_its_rod() {
    for (angle, rate) in [(0.3, 0.0), (2.5, 1.0), (-1.0, 7.0), (3.0, 0.2)] {
        let (sine, cosine) = f64::sin_cos(angle);
        let start = PlanarTranslation {
            position: [0.8 * sine, -0.8 * cosine].into(),
            velocity: [0.8 * rate * cosine, 0.8 * rate * sine].into(),
        };
        let pinned = Pinned::default();
        let hinge = Hinge {
            angle,
            angular_velocity: rate,
        };
        let end = pinned.integrate(&hinge).to(7.0).unwrap();
        let bob = Bob::default();
        for tolerance in [1e-6, 1e-9, 1e-12] {
            let series = bob.integrate(&start).tolerance(tolerance).to(7.0).unwrap();
            let expected = [0.8 * end.angle.sin(), -0.8 * end.angle.cos()];
            let off = (series.position - nalgebra::Vector2::from(expected)).norm();
            assert!(off < 3e4 * tolerance, "{angle} {rate} {tolerance}: {off}");
            for violation in bob.violations(7.0, &series, &()) {
                assert!(violation.position.unwrap().abs() < 1e-15);
                assert!(violation.velocity.abs() < 1e-14);
            }
        }
    }
}

// a skate on a slope turns and drifts across it; the reaction is sideways, and drag slows it
rigid_body!(Skate {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    inputs: [steering[N * m]],
    points: [blade = (0.1[m], 0)],
    fields: [weight = mass * world(0, -3.2[m / s ^ 2])],
    forces: [drag = -0.4[kg / s] * velocity],
    moments: [rudder = steering],
    constraints: [edge = blade.velocity().in_body().y],
    reactions: [side = body(0, _).at(blade)],
    outputs: [taylor],
});

// a top that leans on the ground: a body with products of inertia, five constraints' worth of scene in three
rigid_body!(Tripod {
    motion: spatial,
    mass: 1.7[kg],
    inertia: tensor {
        xx: 0.21,
        yy: 0.3,
        zz: 0.12,
        xy: 0.01,
        yz: -0.02,
        zx: 0.015
    }[kg * m ^ 2],
    points: [tip = (0.05, -0.1, -0.4)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    constraints: [held = tip.position()],
    reactions: [ground = world(_, _, _).at(tip)],
    outputs: [taylor, energy],
});

#[test]
fn beside_runge_kutta_steps() {
    let skate = Skate::default();
    let start = Planar {
        velocity: [1.0, 0.0].into(),
        ..Planar::default()
    };
    let steer = |time: f64, _: &Planar| SkateInput {
        steering: 0.3 - 0.2 * time,
    };
    let other = skate.integrate(&start);
    let other = other.method(Projected(DormandPrince { tolerance: 1e-13 }));
    let other = other.control(0.5, steer).to(6.0).unwrap();
    let series = skate.integrate(&start).tolerance(1e-12);
    let series = series.control(0.5, steer).to(6.0).unwrap();
    assert!((series.position - other.position).norm() < 1e-10);
    assert!((series.angle - other.angle).abs() < 1e-10);

    let tripod = Tripod::default();
    let mut start = Spatial {
        attitude: nalgebra::UnitQuaternion::from_scaled_axis([0.38, 0.11, 0.04].into()),
        angular_velocity: [0.5, -0.3, 9.0].into(),
        ..Spatial::default()
    };
    tripod.project(0.0, &mut start, &()).unwrap();
    let other = tripod.integrate(&start);
    let other = other.method(Projected(DormandPrince { tolerance: 1e-13 }));
    let other = other.to(3.0).unwrap();
    for (tolerance, limit) in [(1e-7, 1e-4), (1e-12, 3e-10)] {
        let series = tripod
            .integrate(&start)
            .tolerance(tolerance)
            .to(3.0)
            .unwrap();
        let off =
            (series.position - other.position).norm() + series.attitude.angle_to(&other.attitude);
        assert!(off < limit, "{tolerance}: {off}");
        let energy = |state: &Spatial| {
            tripod.kinetic_energy(state) + tripod.potential_energy(0.0, state, &())
        };
        let lost = (energy(&series) - energy(&start)).abs();
        assert!(lost < 100.0 * limit, "{tolerance}: {lost}");
    }
}

// a gyroscope on a rope: reactions whose series are sums of many products, some of them followed by a load
macro_rules! on_a_rope {
    ($name:ident, $height:expr, [$($loads:tt)*]) => {
        rigid_body!($name {
            motion: fixed_point(foot),
            mass: 0.9[kg],
            inertia: principal(0.05, 0.06, 0.02)[kg * m ^ 2],
            points: [foot = (0, 0, -0.2), tip = (0, 0, 0.25), hook = world(0.3, 0.2, 1)],
            constraints: [rope = $height],
            $($loads)*
            outputs: [taylor],
        });

        impl $name {
            /// The largest difference between the slope of the series and the accelerations, of
            /// both in size, at some times.
            fn off() -> f64 {
                let (body, start) = (Self::default(), Rotation {
                    attitude: nalgebra::UnitQuaternion::from_scaled_axis([0.3, 0.2, 0.1].into()),
                    angular_velocity: [0.1, 0.5, 2.0].into(),
                });
                let series = body.series::<14>(0.0, &start, &());
                let coefficients = series.coefficients();
                let off = [-0.02, 0.01, 0.03].map(|time| {
                    let found = body.acceleration(time, &series.after(time), &());
                    let slope = [4, 5, 6].map(|place| {
                        let powers = coefficients.iter().enumerate().skip(1).rev();
                        powers.fold(0.0, |sum, (order, row)| {
                            sum * time + order as f64 * row.as_ref()[place]
                        })
                    });
                    (found - nalgebra::Vector3::from(slope)).norm() / found.norm()
                });
                off.into_iter().fold(0.0, f64::max)
            }
        }
    };
}

on_a_rope!(Followed, (tip.position() - hook.position()).norm() - 0.7[m], [
    reactions: [pull = (_ * (tip.position() - hook.position()).normalize()).at(tip)],
    forces: [drag = 0.1 * pull],
]);
on_a_rope!(Crossed, (tip.position() - hook.position()).norm() - 0.7[m], [
    reactions: [pull = (_ * (tip.position() - hook.position()).normalize()).at(tip)],
    forces: [drag = (0.1 * pull.cross(world(0, 0, 1))).at(tip)],
]);
on_a_rope!(Squared, (tip.position() - hook.position()).norm_squared() - 0.49[m ^ 2], [
    reactions: [pull = (_ * (tip.position() - world(0, 0, 1)).normalize()).at(tip)],
]);
on_a_rope!(OnATable, tip.position().in_world().z - 0.4[m], [
    reactions: [pull = (_ * (tip.position() - hook.position()).normalize()).at(tip)],
    moments: [drag = 0.02[m] * pull.in_world().z * angular_velocity.normalize()],
]);

#[test]
fn sums_of_many_products() {
    for (name, off) in [
        ("Followed", Followed::off()),
        ("Crossed", Crossed::off()),
        ("Squared", Squared::off()),
        ("OnATable", OnATable::off()),
    ] {
        assert!(off < 1e-11, "{name}: {off:e}");
    }
}
