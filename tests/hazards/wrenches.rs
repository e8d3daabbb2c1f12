//! H13, H14: the reduction of a system of forces, and uniform fields on charges that cancel.

use dashu_ratio::RBig;
use nalgebra::Vector3;
use newton_euler::field::Charges;
use newton_euler::prelude::*;
use newton_euler::wrench::Reduction;

use crate::exact::{Exact, ULP, cross, dot, off, rational, relative, vector, worse};
use crate::table::Record;

rigid_body!(Driven {
    motion: spatial,
    inputs: [push = body(_, _, _)[N], twist = body(_, _, _)[N * m]],
    mass: 1[kg],
    inertia: principal(1, 2, 3),
    forces: [pushed = push],
    moments: [twisted = twist],
    outputs: [balance],
});

/// `F × K/F²` and `F·K/F²`.
fn straightforward_screw(wrench: &Wrench) -> (Vector3<f64>, f64) {
    let Wrench { force, moment } = wrench;
    let square = force.norm_squared();
    (force.cross(moment) / square, force.dot(moment) / square)
}

fn screw(wrench: &Wrench) -> (Vector3<f64>, f64) {
    match wrench.reduce() {
        Reduction::Screw { line, pitch, .. } => (line.point, pitch),
        _ => (Vector3::repeat(f64::NAN), f64::NAN),
    }
}

fn exact_screw(wrench: &Wrench) -> (Exact, RBig) {
    let [force, moment] = [wrench.force, wrench.moment].map(|v| vector(&v));
    let square = dot(&force, &force);
    (
        cross(&force, &moment).map(|component| component / &square),
        dot(&force, &moment) / &square,
    )
}

pub fn reductions() -> Vec<Record> {
    let one = Wrench {
        force: Vector3::new(0.5, 1.0, 1.75),
        moment: Vector3::new(0.225, -1.325, 2.05),
    };
    let scaled = |factor: f64| Wrench {
        force: one.force * factor,
        moment: one.moment * factor,
    };
    // through a body: the loads as it applies them
    let applied = |wrench: &Wrench| {
        let (push, twist) = (wrench.force, wrench.moment);
        let input = DrivenInput { push, twist };
        Driven {}.applied(0.0, &Spatial::default(), &input)
    };
    let mut records = Vec::new();
    for decade in [-200, -160, 160, 200] {
        let wrench = scaled(10_f64.powi(decade));
        let exact = exact_screw(&wrench);
        let error = |(point, pitch): (Vector3<f64>, f64)| {
            worse(off(&point, &exact.0), relative(pitch, &exact.1))
        };
        let plain = error(straightforward_screw(&wrench));
        let ours = worse(error(screw(&applied(&wrench))), error(screw(&wrench)));
        let case = format!("macro and runtime, 1e{decade}");
        records.push(Record::fails(case, plain, 1e-5).ours(ours, 4.0 * ULP));
    }
    for power in [-664, 664] {
        let wrench = scaled(2_f64.powi(power));
        let change = |(point, pitch): (Vector3<f64>, f64), (same, like): (Vector3<f64>, f64)| {
            worse((point - same).amax(), (pitch - like).abs())
        };
        let plain = change(straightforward_screw(&wrench), straightforward_screw(&one));
        let [written, runtime] =
            [applied(&wrench), wrench].map(|wrench| change(screw(&wrench), screw(&one)));
        let case = format!("macro and runtime, 2^{power}, to the bit");
        records.push(Record::fails(case, plain, 1.0).ours(worse(written, runtime), 0.0));
    }
    records
}

rigid_body!(Needle {
    motion: rotation,
    params: [first, second],
    inertia: principal(1, 1, 1),
    points: [head = (0.3, -0.1, 0.2), tail = (-0.3, 0.1, -0.2)],
    fields: [electric = world(150, -40, 310).on([first.at(head), second.at(tail)])],
});

const FIELD: Vector3<f64> = Vector3::new(150.0, -40.0, 310.0);

fn exact_moment(charges: &[(f64, Vector3<f64>)]) -> Exact {
    let dipole = [0, 1, 2].map(|axis| {
        charges.iter().fold(RBig::ZERO, |sum, (charge, at)| {
            sum + rational(*charge) * rational(at[axis])
        })
    });
    cross(&dipole, &vector(&FIELD))
}

/// `r₀ × F`, with `r₀ = Σ e r / Σ e` and `F = E Σ e`.
fn straightforward_moment(charges: &[(f64, Vector3<f64>)]) -> Vector3<f64> {
    let net: f64 = charges.iter().map(|(charge, _)| charge).sum();
    let dipole: Vector3<f64> = charges.iter().map(|(charge, at)| at * *charge).sum();
    (dipole / net).cross(&(FIELD * net))
}

pub fn neutral_bodies() -> Vec<Record> {
    let arm = Vector3::new(0.3, -0.1, 0.2);
    let mut records = Vec::new();
    for excess in [1e-3, 1e-9, f64::EPSILON, 0.0] {
        let charges = [(1.0 + excess, arm), (-1.0, -arm)];
        let exact = exact_moment(&charges);
        let plain = off(&straightforward_moment(&charges), &exact);
        let needle = Needle::new(NeedleParams {
            first: 1.0 + excess,
            second: -1.0,
        })
        .expect("a body");
        let written = needle.acceleration(0.0, &Rotation::default(), &());
        let runtime = Charges::from_points(charges).moment(&FIELD);
        let ours = worse(off(&written, &exact), off(&runtime, &exact));
        let case = format!("macro and runtime, Σe = {excess:.0e}");
        let record = if excess == 0.0 {
            Record::fails(case, plain, 1.0)
        } else {
            Record::holds(case, plain)
        };
        records.push(record.ours(ours, 4.0 * ULP));
    }
    // from an origin far away, where the products are large and their sum is not
    let far = Vector3::new(1.0, -1.0, 1.0) * 1_048_576.0;
    let arm = arm.map(|x| (x * 1024.0).round() / 1024.0);
    let charges = [(0.1, far + arm), (0.2, far - arm), (-0.1 - 0.2, far)];
    let exact = exact_moment(&charges);
    let plain = off(&straightforward_moment(&charges), &exact);
    let ours = Charges::from_points(charges).moment(&FIELD);
    records.push(
        Record::fails("runtime, Σe = 3e-17, origin 1e6 m away", plain, 1e-10)
            .ours(off(&ours, &exact), 4.0 * ULP),
    );
    records
}
