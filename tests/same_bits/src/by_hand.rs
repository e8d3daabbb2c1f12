//! The parts of the runtime that users call directly.

use newton_euler::columns::Columns;
use newton_euler::exact::{Jacobi, r_j};
use newton_euler::inertia::InertiaTensor;
use newton_euler::nalgebra::Vector3;
use newton_euler::prelude::*;
use newton_euler::wrench::Reduction;
use newton_euler::{attitude, gyroscopic};

use crate::bits::{Bits, Numbers};

pub fn inertia() -> Bits {
    let (mut bits, mut numbers) = (Bits::new(), Numbers(11));
    for _ in 0..50 {
        let [a, b, c]: [f64; 3] = core::array::from_fn(|_| Columns::read(&mut numbers));
        let tensor = InertiaTensor::tensor(2.0 + a, 2.2 + b, 2.1 + c, 0.1 * a, 0.2 * b, 0.1 * c);
        let Ok(tensor) = tensor else { continue };
        let w = Columns::read(&mut numbers);
        bits.add(&tensor.times(&w));
        bits.add(&gyroscopic::torque(&tensor, &w));
        let principal = tensor.principal_axes();
        bits.add(&principal.moments);
        bits.add(&principal.axes);
        bits.all(tensor.rotated(&attitude::exp(&w)).moments());
        bits.all(tensor.inverse().expect("invertible").iter().copied());
    }
    bits
}

pub fn attitudes() -> Bits {
    let (mut bits, mut numbers) = (Bits::new(), Numbers(12));
    for size in [1e-9, 0.01, 1.0, 3.0, 100.0] {
        for _ in 0..20 {
            let rotation: Vector3<f64> = Columns::read(&mut numbers);
            let attitude = attitude::exp(&(rotation * size));
            bits.add(&attitude);
            bits.add(&attitude::log(&attitude));
        }
    }
    bits
}

pub fn wrenches() -> Bits {
    let (mut bits, mut numbers) = (Bits::new(), Numbers(13));
    for _ in 0..50 {
        let [force, moment] = core::array::from_fn(|_| Columns::read(&mut numbers));
        if let Reduction::Screw { line, pitch, .. } = (Wrench { force, moment }).reduce() {
            bits.add(&line.point);
            bits.add(&line.direction);
            bits.all([pitch]);
        }
    }
    bits
}

pub fn elliptic() -> Bits {
    let mut bits = Bits::new();
    for complement in [1.0, 0.5, 1e-3, 1e-12, 0.0] {
        let jacobi = Jacobi::new(complement);
        for argument in [1e-9, 0.3, 2.0, 50.0, 1e6] {
            let elliptic = jacobi.at(argument);
            bits.all([elliptic.sn, elliptic.cn, elliptic.dn]);
            bits.all([r_j(complement, argument, 2.0, 3.0)]);
        }
    }
    bits
}
