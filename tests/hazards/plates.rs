//! H20: flat bodies with decimal moments, of which the largest is the sum of the other two.

use nalgebra::Vector3;
use newton_euler::prelude::*;

use crate::exact::{ULP, to_f32};
use crate::table::Record;

rigid_body!(Plate::<T> {
    motion: rotation,
    params: [x, y, z],
    inertia: principal(x, y, z),
});

mod written {
    newton_euler::rigid_body!(Plate {
        motion: rotation,
        inertia: principal(0.7, 0.1, 0.8),
    });
}

fn turning() -> Rotation {
    Rotation {
        angular_velocity: Vector3::new(1.0, 1.0, 0.0),
        ..Rotation::default()
    }
}

/// The sides of the triangle inequality as they come.
fn is_triangle([x, y, z]: [f64; 3]) -> bool {
    x <= y + z && y <= z + x && z <= x + y
}

/// The share of all triples that a check finds otherwise than it should.
fn share(all: &[[f64; 3]], is_wrong: impl Fn(&[f64; 3]) -> bool) -> f64 {
    let wrong = all.iter().filter(|moments| is_wrong(moments)).count();
    f64::from(u32::try_from(wrong).expect("a few"))
        / f64::from(u32::try_from(all.len()).expect("some"))
}

/// a and b of two decimals each, and a + b times a factor, in all cyclic orders.
fn plates(factor: f64) -> Vec<[f64; 3]> {
    let hundredths = |k: u32| f64::from(k) / 100.0;
    let pairs = (1..40).flat_map(|i| (1..40).map(move |k| (i, k)));
    let plates = pairs.flat_map(|(i, k)| {
        let [a, b, c] = [hundredths(i), hundredths(k), hundredths(i + k) * factor];
        [[a, b, c], [b, c, a], [c, a, b]]
    });
    plates.collect()
}

pub fn plane_bodies() -> Vec<Record> {
    let single = |[x, y, z]: [f64; 3]| {
        Plate::new(PlateParams {
            x: to_f32(x),
            y: to_f32(y),
            z: to_f32(z),
        })
    };
    let double = |[x, y, z]: [f64; 3]| Plate::new(PlateParams { x, y, z });
    let runtime = |[x, y, z]: [f64; 3]| InertiaTensor::principal(x, y, z);

    let possible = plates(1.0);
    let refused = share(&possible, |moments| !is_triangle(*moments));
    let mut records = vec![
        Record::fails("runtime, plane", refused, 0.05)
            .ours(share(&possible, |moments| runtime(*moments).is_err()), 0.0),
        Record::fails("params, plane", refused, 0.05)
            .ours(share(&possible, |moments| double(*moments).is_err()), 0.0),
        Record::alone("params, plane, f32")
            .ours(share(&possible, |moments| single(*moments).is_err()), 0.0),
    ];
    let impossible = plates(1.0 + 1e-14);
    let accepted = share(&impossible, |moments| is_triangle(*moments));
    records.extend([
        Record::holds("runtime, above by 1e-14", accepted)
            .ours(share(&impossible, |moments| runtime(*moments).is_ok()), 0.0),
        Record::holds("params, above by 1e-14", accepted)
            .ours(share(&impossible, |moments| double(*moments).is_ok()), 0.0),
    ]);
    let impossible = plates(1.0 + 1e-5);
    records.push(
        Record::alone("params, above by 1e-5, f32")
            .ours(share(&impossible, |moments| single(*moments).is_ok()), 0.0),
    );
    // written: the coupling (J_x - J_y)/J_z of a plate, which is no body in doubles
    let coupling = written::Plate {}.acceleration(0.0, &turning(), &()).z;
    let plain = f64::from(u8::from(!is_triangle([0.7, 0.1, 0.8])));
    records.push(
        Record::fails(
            "numbers, (0.7, 0.1, 0.8): refused, or error of its coupling",
            plain,
            1.0,
        )
        .ours((coupling - 0.75).abs(), ULP),
    );
    // with products: |Jxy| above half of Jzz
    let accepted = InertiaTensor::products(1.0, 1.0, 1.0, 0.6, 0.0, 0.0).is_ok();
    records.push(
        Record::alone("runtime, Jxy = 0.6 of J = 1").ours(f64::from(u8::from(accepted)), 0.0),
    );
    records
}
