//! Counts of the operations of generated code. They are no more than by hand, and numbers written
//! into a description never cost more than the same numbers as parameters.
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

/// Written by hand, these are 85 and 87, 72, 52, 38; under a constant force, principal axes save 7 more.
#[test]
fn whole_bodies() {
    assert_eq!(count(General::OPERATIONS), 83);
    assert_eq!(count(GeneralParams::OPERATIONS), 83);
    assert_eq!(count(GeneralConstant::OPERATIONS), 60);
    assert_eq!(count(Principal::OPERATIONS), 52);
    assert_eq!(count(PrincipalConstant::OPERATIONS), 36);
    assert_eq!(count(PrincipalParams::OPERATIONS), 52);
}

/// Cases whose code is known to the operation.
mod cases {
    use newton_euler::rigid_body;

    rigid_body!(OneProduct {
        motion: rotation,
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: 0.12
        },
    });
    rigid_body!(Full {
        motion: rotation,
        inputs: [couple = body(_, _, _)],
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: 0.1,
            yz: -0.2,
            zx: 0.12
        },
        moments: [driven = couple],
    });
    rigid_body!(Triaxial {
        motion: rotation,
        inertia: principal(1.3, 1.7, 2.1),
    });
    rigid_body!(TriaxialDriven {
        motion: rotation,
        inputs: [couple = body(_, _, _)],
        inertia: principal(1.3, 1.7, 2.1),
        moments: [driven = couple],
    });
    rigid_body!(Axisymmetric {
        motion: rotation,
        inertia: principal(1.7, 2.1, 1.7),
    });
    rigid_body!(Spherical {
        motion: spatial,
        mass: 2,
        inertia: principal(1.7, 1.7, 1.7),
        fields: [weight = mass * world(0, 0, -9.8)],
    });
    rigid_body!(Glider {
        motion: planar,
        mass: 2,
        inertia: 0.5,
        forces: [thrust = body(3, 0)],
        fields: [weight = mass * world(0, -9.8)],
    });
    rigid_body!(GliderDriven {
        motion: planar,
        inputs: [thrust],
        mass: 2,
        inertia: 0.5,
        forces: [engine = body(thrust, 0)],
        fields: [weight = mass * world(0, -9.8)],
    });
    rigid_body!(Rocket {
        motion: spatial,
        mass: 2,
        inertia: principal(1.3, 1.7, 2.1),
        points: [nozzle = (0.1, 0.2, -0.3)],
        forces: [thrust = body(0, 0, 3).at(nozzle)],
        fields: [weight = mass * world(0, 0, -9.8)],
    });
    rigid_body!(Dart {
        motion: spatial,
        params: [k = 0.1],
        mass: 2,
        inertia: principal(1.3, 1.7, 2.1),
        points: [fin = (0, 0, -0.3)],
        locals: [air = fin.velocity()],
        forces: [drag = (-k * air.norm_squared() * air).at(fin)],
    });
    rigid_body!(Pi {
        motion: planar_translation,
        mass: 1[kg],
        forces: [f = world(PI[N], 1[N] * PI[rad].cos())],
    });
    rigid_body!(Balanced {
        motion: planar_translation,
        mass: 1,
        forces: [
            pushed = world(5, 0),
            pulled = -(2[N / m] * position + world(3, 0))
        ],
    });
    rigid_body!(FreeRod {
        motion: rod(body(1, 0, 0)),
        mass: 2,
        inertia: 0.3,
        fields: [weight = mass * world(0, 0, -9.8)],
    });
    rigid_body!(PushedRod {
        motion: rod(body(1, 0, 0)),
        inputs: [push = world(_, _, _), thrust],
        mass: 2,
        inertia: 0.3,
        points: [tip = (0.5, 0, 0), tail = (-0.5, 0, 0)],
        forces: [pushed = push.at(tip), driven = body(thrust, 0, 0).at(tail)],
    });
    rigid_body!(HangingRod {
        motion: rod(body(0, 3, 4)),
        mass: 2,
        inertia: 0.3,
        points: [end = (0, 0.3, 0.4)],
        forces: [lift = world(0, 0, 19.6).at(end)],
        fields: [weight = mass * world(0, 0, -9.8)],
    });
    rigid_body!(DampedRod {
        motion: rod(body(1, 0, 0)),
        params: [c = 0.1],
        mass: 2,
        inertia: 0.3,
        moments: [damped = -c * angular_velocity],
    });
    rigid_body!(CompassRod {
        motion: rod(body(1, 0, 0)),
        mass: 2,
        inertia: 0.3,
        moments: [magnetic = axis.cross(world(0.2, 0, 0.1))],
    });
    rigid_body!(LeaningRod {
        motion: rod(body(1, 0, 0)),
        mass: 2,
        inertia: 0.3,
        potentials: [magnetic = -axis.dot(world(0.2, 0, 0.1))],
    });
}

/// Multiplications, additions and trigonometric functions of the acceleration.
fn counts(operations: &[Operations]) -> [u32; 3] {
    let row = row(operations, "acceleration");
    assert_eq!((row.div, row.sqrt, row.other), (0, 0, 0), "{row}");
    [row.mul, row.add, row.trig]
}

#[test]
fn one_product_of_inertia() {
    // to two principal axes and back, 2 + 2 each, and three products with a coefficient
    assert_eq!(counts(cases::OneProduct::OPERATIONS), [10, 4, 0]);
}

#[test]
fn rotations() {
    assert_eq!(counts(cases::Full::OPERATIONS), [23, 17, 0]);
    assert_eq!(counts(cases::Triaxial::OPERATIONS), [6, 0, 0]);
    assert_eq!(counts(cases::TriaxialDriven::OPERATIONS), [9, 3, 0]);
    assert_eq!(counts(cases::Axisymmetric::OPERATIONS), [3, 0, 0]);
    assert_eq!(counts(cases::Spherical::OPERATIONS), [0, 0, 0]);
}

#[test]
fn thrust_and_gravity() {
    assert_eq!(counts(cases::Glider::OPERATIONS), [2, 1, 2]);
    assert_eq!(counts(cases::GliderDriven::OPERATIONS), [3, 1, 2]);
    // one column of the rotation, and Euler's equations with a constant couple
    assert_eq!(counts(cases::Rocket::OPERATIONS), [14, 6, 0]);
}

#[test]
fn constants_of_one_sum_are_one_constant() {
    assert_eq!(counts(cases::Balanced::OPERATIONS), [2, 1, 0]);
}

#[test]
fn pi_takes_a_unit() {
    use newton_euler::prelude::*;
    let acceleration = cases::Pi::default().acceleration(0.0, &PlanarTranslation::default(), &());
    assert!(
        (acceleration.x - core::f64::consts::PI).abs() < 1e-15
            && (acceleration.y + 1.0).abs() < 1e-15
    );
}

/// What all components share is turned around: the velocity that the norm needs is turned once.
#[test]
fn drag_turns_its_velocity_once() {
    let [mul, add, trig] = counts(cases::Dart::OPERATIONS);
    assert!(mul + add <= 90 && trig == 0, "{mul} + {add}");
}

#[test]
fn a_parameter_is_finite() {
    use newton_euler::body::InvalidBody;
    for value in [f64::INFINITY, f64::NEG_INFINITY] {
        let error = cases::Dart::new(cases::DartParams { k: value }).err();
        assert_eq!(error, Some(InvalidBody::NotFinite { name: "k", value }));
    }
}

/// `-u'^2 u` is 6 + 2. Damping is 3 + 3 more; of a first moment over J, the projection is 3 + 2 and the sums 4, less the
/// components that it does not have.
#[test]
fn rods() {
    assert_eq!(counts(cases::FreeRod::OPERATIONS), [6, 2, 0]);
    assert_eq!(counts(cases::DampedRod::OPERATIONS), [9, 5, 0]);
    // B / J and the acceleration of G in 9 + 3; the thrust along the axis has no moment
    assert_eq!(counts(cases::PushedRod::OPERATIONS), [18, 11, 0]);
    assert_eq!(counts(cases::HangingRod::OPERATIONS), [7, 4, 0]);
    // the same, as a couple and by its potential
    assert_eq!(counts(cases::CompassRod::OPERATIONS), [8, 6, 0]);
    assert_eq!(counts(cases::LeaningRod::OPERATIONS), [8, 6, 0]);
}

/// Constant tensors whose principal axes are not those of the body.
mod principal_axes {
    use newton_euler::rigid_body;

    rigid_body!(Free {
        motion: rotation,
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: 0.1,
            yz: -0.2,
            zx: 0.12
        },
        outputs: [energy, momentum],
    });
    rigid_body!(FreeParams {
        motion: rotation,
        params: [xx, yy, zz, xy, yz, zx],
        inertia: tensor {
            xx,
            yy,
            zz,
            xy,
            yz,
            zx
        },
        outputs: [energy, momentum],
    });
    rigid_body!(Thrust {
        motion: rotation,
        inputs: [thrust],
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: 0.1,
            yz: -0.2,
            zx: 0.12
        },
        moments: [driven = body(0, 0, thrust)],
    });
    rigid_body!(Plane {
        motion: rotation,
        inputs: [couple = body(_, _, _)],
        inertia: tensor {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: 0.12
        },
        moments: [driven = couple],
    });
    rigid_body!(Tilted {
        motion: rotation,
        mass: 3[kg],
        inertia: cylinder(0.1[m], 0.7[m]).along(body(1, 2, 3)),
        outputs: [energy, momentum],
    });
    rigid_body!(TiltedDriven {
        motion: rotation,
        inputs: [couple = body(_, _, _)],
        mass: 3[kg],
        inertia: cylinder(0.1[m], 0.7[m]).along(body(1, 2, 3)),
        moments: [driven = couple],
    });
    rigid_body!(TiltedInPlane {
        motion: rotation,
        mass: 3[kg],
        inertia: cylinder(0.1[m], 0.7[m]).turned(body(0, 1, 0), 30[deg]),
    });
    rigid_body!(Diagonal {
        motion: rotation,
        mass: 3[kg],
        inertia: cylinder(0.1[m], 0.7[m]).along(body(1, 2, 2)),
    });
    rigid_body!(Cube {
        motion: rotation,
        mass: 3[kg],
        inertia: cuboid(0.1[m], 0.1[m], 0.1[m]).turned(body(1, 2, 3), 1[rad]),
    });
}

/// Multiplications and additions of one function.
fn of(operations: &[Operations], function: &str) -> [u32; 2] {
    let row = row(operations, function);
    assert_eq!(
        (row.div, row.sqrt, row.trig, row.other),
        (0, 0, 0, 0),
        "{row}"
    );
    [row.mul, row.add]
}

/// Three moments: there and back through axes scaled to hold a one, 6 + 6 each, and three products
/// with a coefficient; with a full couple the tensor is kept.
#[test]
fn three_principal_moments() {
    use principal_axes as bodies;
    assert_eq!(of(bodies::Free::OPERATIONS, "acceleration"), [18, 12]);
    assert_eq!(of(bodies::FreeParams::OPERATIONS, "acceleration"), [23, 14]);
    assert_eq!(of(bodies::Thrust::OPERATIONS, "acceleration"), [21, 15]);
    assert_eq!(of(bodies::Plane::OPERATIONS, "acceleration"), [13, 8]);
    for operations in [bodies::Free::OPERATIONS, bodies::FreeParams::OPERATIONS] {
        assert_eq!(of(operations, "kinetic_energy"), [10, 5]);
        assert_eq!(of(operations, "angular_momentum"), [27, 18]);
    }
}

/// Two equal moments about a tilted axis: `n.w`, `w x n` and a rate, 2 + 2, 4 + 3 and 1 + 3.
#[test]
fn an_axis_of_symmetry() {
    use principal_axes as bodies;
    assert_eq!(of(bodies::Tilted::OPERATIONS, "acceleration"), [10, 5]);
    // two components of the axis are equal
    assert_eq!(of(bodies::Diagonal::OPERATIONS, "acceleration"), [7, 5]);
    // one of them is zero
    assert_eq!(
        of(bodies::TiltedInPlane::OPERATIONS, "acceleration"),
        [6, 2]
    );
    assert_eq!(
        of(bodies::TiltedDriven::OPERATIONS, "acceleration"),
        [18, 13]
    );
    assert_eq!(of(bodies::Tilted::OPERATIONS, "kinetic_energy"), [8, 5]);
    assert_eq!(of(bodies::Tilted::OPERATIONS, "angular_momentum"), [26, 17]);
}

/// A cube has the same tensor in all axes.
#[test]
fn a_turned_cube_turns_like_a_ball() {
    assert_eq!(of(principal_axes::Cube::OPERATIONS, "acceleration"), [0, 0]);
}

/// The rate of an angle is the angular velocity, also where parameters say about which axis.
#[test]
fn a_driven_hinge_costs_the_same_about_any_axis() {
    rigid_body!(Leaning {
        motion: fixed_axis(hinge, world(lean, 0.3, 1)),
        params: [lean = 0.2],
        inertia: principal(0.5, 0.7, 0.4),
        mass: 3[kg],
        points: [hinge = (0.4, -0.1, 0.2)],
        constraints: [driven = attitude - 0.1 * (1[1 / s] * t).sin()],
        reactions: [motor = moment(_ * body(lean, 0.3, 1))],
    });
    rigid_body!(Upright {
        motion: fixed_axis(hinge, world(0, 0, 1)),
        inertia: principal(0.5, 0.7, 0.4),
        mass: 3[kg],
        points: [hinge = (0.4, -0.1, 0.2)],
        constraints: [driven = attitude - 0.1 * (1[1 / s] * t).sin()],
        reactions: [motor = moment(_ * body(0, 0, 1))],
    });
    let of = |operations| row(operations, "violations");
    assert_eq!(of(Leaning::OPERATIONS), of(Upright::OPERATIONS));
}
