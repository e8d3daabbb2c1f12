//! Operations of generated code, as exact counts: what EQUATIONS says can be reached is reached, and numbers
//! written into a description never cost more than the same numbers as parameters.
#![allow(missing_docs)]

use newton_euler::operations::{Operations, Stage};
use newton_euler::rigid_body;

/// Multiplications and additions of the acceleration; divisions and roots must not occur.
fn count(operations: &[Operations]) -> u32 {
    let row = row(operations, "acceleration");
    assert_eq!((row.div, row.sqrt, row.other), (0, 0, 0), "{row}");
    row.mul + row.add
}

fn row(operations: &[Operations], function: &str) -> Operations {
    let found = operations
        .iter()
        .find(|row| row.function == function && row.stage == Stage::State);
    *found.expect("every generated function has a row")
}

rigid_body!(GeneralParams {
    motion: spatial,
    params: [
        m[kg],
        xx,
        yy,
        zz,
        xy,
        yz,
        zx,
        px[m],
        py[m],
        pz[m],
        g[m / s ^ 2]
    ],
    inputs: [fx[N], fy[N], fz[N]],
    mass: m,
    inertia: tensor {
        xx,
        yy,
        zz,
        xy,
        yz,
        zx
    },
    points: [p = (px, py, pz)],
    fields: [weight = mass * world(0, 0, -g)],
    forces: [push = body(fx, fy, fz).at(p)],
});

rigid_body!(General {
    motion: spatial,
    inputs: [fx[N], fy[N], fz[N]],
    mass: 3.2[kg],
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: -0.12,
        yz: -0.05,
        zx: 0.07
    }[kg * m ^ 2],
    points: [p = (0.1, -0.2, 0.05)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [push = body(fx, fy, fz).at(p)],
});

rigid_body!(GeneralConstant {
    motion: spatial,
    mass: 3.2[kg],
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: -0.12,
        yz: -0.05,
        zx: 0.07
    }[kg * m ^ 2],
    points: [p = (0.1, -0.2, 0.05)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [push = body(4, -2.5, 10)[N].at(p)],
});

rigid_body!(Principal {
    motion: spatial,
    inputs: [fx[N], fy[N], fz[N]],
    mass: 3.2[kg],
    inertia: principal(1.3, 1.7, 2.1)[kg * m ^ 2],
    points: [p = (0.1, -0.2, 0.05)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [push = body(fx, fy, fz).at(p)],
});

rigid_body!(PrincipalConstant {
    motion: spatial,
    mass: 3.2[kg],
    inertia: principal(1.3, 1.7, 2.1)[kg * m ^ 2],
    points: [p = (0.1, -0.2, 0.05)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [push = body(4, -2.5, 10)[N].at(p)],
});

rigid_body!(PrincipalParams {
    motion: spatial,
    params: [m[kg], a, b, c, px[m], py[m], pz[m], g[m / s ^ 2]],
    inputs: [fx[N], fy[N], fz[N]],
    mass: m,
    inertia: principal(a, b, c),
    points: [p = (px, py, pz)],
    fields: [weight = mass * world(0, 0, -g)],
    forces: [push = body(fx, fy, fz).at(p)],
});

#[test]
fn general_body_with_an_input_force() {
    assert!(
        count(GeneralParams::OPERATIONS) <= 87,
        "{}",
        count(GeneralParams::OPERATIONS)
    );
    assert!(
        count(General::OPERATIONS) <= 85,
        "{}",
        count(General::OPERATIONS)
    );
    assert!(count(General::OPERATIONS) <= count(GeneralParams::OPERATIONS));
}

#[test]
fn general_body_with_a_constant_force() {
    assert!(
        count(GeneralConstant::OPERATIONS) <= 72,
        "{}",
        count(GeneralConstant::OPERATIONS)
    );
}

#[test]
fn principal_axes() {
    assert!(
        count(Principal::OPERATIONS) <= 52,
        "{}",
        count(Principal::OPERATIONS)
    );
    assert!(
        count(PrincipalConstant::OPERATIONS) <= 38,
        "{}",
        count(PrincipalConstant::OPERATIONS)
    );
    assert!(count(Principal::OPERATIONS) <= count(PrincipalParams::OPERATIONS));
}
