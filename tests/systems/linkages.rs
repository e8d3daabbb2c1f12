//! Six-bar linkages: counts of operations.
#![allow(unused_variables, reason = "each linkage uses some of the points")]

use newton_euler::operations::Operations;
use newton_euler::prelude::*;

macro_rules! linkage {
    ($name:ident, [$($joint:ident = $kind:expr),* $(,)?]) => {
        rigid_system!($name {
            motion: planar,
            bodies: [
                a { mass: 0.4[kg], inertia: 4e-4[kg * m ^ 2], points: [p = (-0.05, 0), q = (0.05, 0), r = (0.01, 0.04)] },
                b { mass: 0.5[kg], inertia: 5e-4[kg * m ^ 2], points: [p = (-0.1, 0), q = (0.1, 0), r = (0.02, 0.06)] },
                c { mass: 0.6[kg], inertia: 6e-4[kg * m ^ 2], points: [p = (-0.09, 0), q = (0.09, 0), r = (0.03, 0.05)] },
                d { mass: 0.7[kg], inertia: 7e-4[kg * m ^ 2], points: [p = (-0.08, 0), q = (0.08, 0)] },
                e { mass: 0.8[kg], inertia: 8e-4[kg * m ^ 2], points: [p = (-0.07, 0), q = (0.07, 0)] },
            ],
            joints: [$($joint = $kind),*],
            fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
        });
    };
}
linkage!(
    Watt1,
    [
        o = revolute(world(0, 0), a.p),
        ab = revolute(a.q, b.p),
        bc = revolute(b.q, c.p),
        g = revolute(world(0.3, 0), c.q),
        bd = revolute(b.r, d.p),
        ce = revolute(c.r, e.p),
        de = revolute(d.q, e.q),
    ]
);
linkage!(
    Watt2,
    [
        o = revolute(world(0, 0), a.p),
        ab = revolute(a.q, b.p),
        bc = revolute(b.q, c.p),
        g = revolute(world(0.3, 0), c.q),
        cd = revolute(c.r, d.p),
        de = revolute(d.q, e.p),
        h = revolute(world(0.5, 0.1), e.q),
    ]
);
linkage!(
    Stephenson3,
    [
        o = revolute(world(0, 0), a.p),
        ab = revolute(a.q, b.p),
        bc = revolute(b.q, c.p),
        g = revolute(world(0.3, 0), c.q),
        bd = revolute(b.r, d.p),
        de = revolute(d.q, e.p),
        h = revolute(world(0.5, 0.1), e.q),
    ]
);
linkage!(
    Stephenson2,
    [
        o = revolute(world(0, 0), a.p),
        ab = revolute(a.q, b.p),
        ac = revolute(a.r, c.p),
        bd = revolute(b.q, d.p),
        cd = revolute(c.q, d.q),
        ce = revolute(c.r, e.p),
        h = revolute(world(0.5, 0.1), e.q),
    ]
);
linkage!(
    Stephenson1,
    [
        o = revolute(world(0, 0), a.p),
        g = revolute(world(0.3, 0), b.p),
        ac = revolute(a.q, c.p),
        ad = revolute(a.r, d.p),
        bc = revolute(b.q, c.q),
        be = revolute(b.r, e.p),
        de = revolute(d.q, e.q),
    ]
);
fn count(operations: &[Operations]) -> u32 {
    let mut rows = operations.iter();
    let row = rows.find(|row| row.function == "acceleration").unwrap();
    row.mul + row.add + row.div
}

#[test]
fn operations_stay_few() {
    let bounds = [
        (count(Watt1::OPERATIONS), 268),
        (count(Watt2::OPERATIONS), 222),
        (count(Stephenson1::OPERATIONS), 237),
        (count(Stephenson2::OPERATIONS), 259),
        (count(Stephenson3::OPERATIONS), 202),
    ];
    let found = bounds.map(|(found, _)| found);
    assert!(
        bounds.iter().all(|(found, bound)| found <= bound),
        "{found:?}"
    );
}
