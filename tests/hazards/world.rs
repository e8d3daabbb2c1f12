//! H9, H9b: small bodies far from the origin of the world.

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::integrate::{self, Classical4, Fixed, Motion};
use newton_euler::prelude::*;
use newton_euler::state::generic;

use crate::exact::{cross, off, to_f32, vector};
use crate::steps;
use crate::table::Record;

rigid_body!(Drone::<T> {
    motion: spatial,
    inputs: [push = world(_, _, _)[N]],
    mass: 0.02[kg],
    inertia: tensor {
        xx: 1.3e-5,
        yy: 1.7e-5,
        zz: 2.1e-5,
        xy: -1.2e-6,
        yz: -0.5e-6,
        zx: 0.7e-6
    },
    points: [tip = (1, -2, 0.5)[mm]],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [pushed = push.at(tip), lift = body(0, 0, 0.2[N]).at(tip)],
});

rigid_body!(Seen {
    doc: "The same, its moments written about the origin of the world.",
    motion: spatial,
    inputs: [push = world(_, _, _)[N]],
    mass: 0.02[kg],
    inertia: tensor {
        xx: 1.3e-5,
        yy: 1.7e-5,
        zz: 2.1e-5,
        xy: -1.2e-6,
        yz: -0.5e-6,
        zx: 0.7e-6
    },
    points: [tip = (1, -2, 0.5)[mm]],
    pole: world(0, 0, 0),
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [pushed = push.at(tip), lift = body(0, 0, 0.2[N]).at(tip)],
});

const PUSH: Vector3<f64> = Vector3::new(0.3, -0.7, 1.1);

pub fn far_bodies() -> Vec<Record> {
    let mut records = Vec::new();
    for far in [1e7, 1e9] {
        let position = Vector3::new(far, -far, 0.7 * far);
        let attitude = UnitQuaternion::from_euler_angles(0.3, 0.4, 0.5);
        let near = Spatial {
            attitude,
            angular_velocity: Vector3::new(1.0, -2.0, 0.5),
            ..Spatial::default()
        };
        let there = Spatial { position, ..near };
        let change = |of: &dyn Fn(&Spatial) -> Vector3<f64>| (of(&there) - of(&near)).amax();

        // the moment about G of what pushes at the tip
        let arm = attitude * Vector3::new(1e-3, -2e-3, 0.5e-3);
        let exact = cross(&vector(&arm), &vector(&PUSH));
        let tip = position + arm;
        let about_origin = off(&(tip.cross(&PUSH) - position.cross(&PUSH)), &exact);
        let from_center = off(&(tip - position).cross(&PUSH), &exact);

        let drone = |state: &Spatial| {
            Drone::<f64>::default()
                .acceleration(0.0, state, &DroneInput { push: PUSH })
                .angular
        };
        let seen = |state: &Spatial| {
            Seen {}
                .acceleration(0.0, state, &SeenInput { push: PUSH })
                .angular
        };
        records.extend([
            Record::fails(
                format!("ω̇ at {far:.0e} m, beside P × F - G × F"),
                about_origin,
                1e-8,
            )
            .ours(change(&drone), 0.0),
            Record::fails(
                format!("ω̇ at {far:.0e} m, pole in the world, beside (P - G) × F"),
                from_center,
                1e-8,
            )
            .ours(change(&seen), 0.0),
            Record::fails(
                format!("runtime, `Wrench::from_force_at` at {far:.0e} m"),
                about_origin,
                1e-8,
            )
            .ours(
                off(&Wrench::from_force_at(PUSH, arm).moment, &exact),
                4.0 * f64::EPSILON,
            ),
            in_single_precision(far),
        ]);
    }
    records
}

fn in_single_precision(far: f64) -> Record {
    let [far, push] = [Vector3::repeat(to_f32(far)), PUSH.map(to_f32)];
    let near = generic::Spatial::<f32> {
        angular_velocity: Vector3::new(1.0, -2.0, 0.5),
        ..generic::Spatial::default()
    };
    let there = generic::Spatial {
        position: far,
        ..near
    };
    let angular = |state| {
        Drone::<f32>::default()
            .acceleration(0.0, state, &DroneInput { push })
            .angular
    };
    let change = (angular(&there) - angular(&near)).amax();
    let arm = Vector3::new(1e-3_f32, -2e-3, 0.5e-3);
    let exact = cross(&vector(&arm.map(f64::from)), &vector(&push.map(f64::from)));
    let plain = ((far + arm) - far).cross(&push);
    let plain = off(&plain.map(f64::from), &exact);
    Record::fails(
        format!("ω̇ at {:.0e} m, f32, beside (P - G) × F", far.x),
        plain,
        0.9,
    )
    .ours(f64::from(change), 0.0)
}

rigid_body!(Probe {
    motion: translation,
    mass: 1[kg],
    outputs: [taylor],
});

/// At 1e7 m, 1e6 steps of 1e-10 m each: less than half a unit in the last place of the position.
pub fn small_steps() -> Vec<Record> {
    let count = steps(1_000_000);
    let (far, speed, h) = (1e7, 1e-4, 1e-6);
    let unit = f64::next_up(far) - far;
    let end = f64::from(count) * h;
    let moved = far + speed * end;
    let ulps = |x: f64| (x - moved).abs() / unit;
    let plain = (0..count).fold(far, |x, _| x + speed * h);
    let start = Translation {
        position: Vector3::new(far, -far, 0.0),
        velocity: Vector3::new(speed, -speed, 0.0),
    };
    let by = f64::from(count) * 1e-10 / unit * 0.9;
    let probe = Probe {};
    let fourth = probe
        .integrate(&start)
        .method(Fixed {
            method: Classical4,
            step: h,
        })
        .to(end);
    let many = usize::try_from(count).expect("a number of steps");
    let by_group = integrate::cf4(&probe, &start, &(), 0.0..end, many);
    let mut series = Motion::<_, 9>::new(&probe, 0.0, &start);
    for _ in 0..count {
        series.step(h, &()).expect("a motion");
    }
    vec![
        Record::fails(
            format!("`Fixed<Classical4>`, {count} steps of 1e-10 m"),
            ulps(plain),
            by,
        )
        .ours(ulps(fourth.expect("a motion").position.x), 1.0),
        Record::fails(
            format!("`TaylorSeries`, {count} steps of 1e-10 m"),
            ulps(plain),
            by,
        )
        .ours(ulps(series.state().position.x), 1.0),
        Record::holds("`cf4`, which does not compensate", ulps(plain))
            .ours(ulps(by_group.position.x), ulps(plain)),
    ]
}
