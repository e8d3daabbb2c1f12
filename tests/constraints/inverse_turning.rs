//! Inverse dynamics with drives whose directions rotate relative to the body. Vector code makes a
//! motion from the drives, and the drives are found again from the motion.
#![allow(missing_docs)]

use nalgebra::{Matrix3, UnitQuaternion, Vector2, Vector3};
use newton_euler::body::Singular;
use newton_euler::prelude::*;

rigid_body!(Jet {
    motion: planar,
    mass: 3[kg],
    inertia: 0.2[kg * m ^ 2],
    points: [tip = (0.3, 0.1)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    forces: [jet = world(0, _).at(tip)],
    outputs: [inverse],
});

rigid_body!(Along {
    motion: planar,
    mass: 3[kg],
    inertia: 0.2[kg * m ^ 2],
    points: [tip = (0.3, 0.1)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    forces: [jet = (_ * world(0, 1)).at(tip)],
    outputs: [inverse],
});

rigid_body!(Thruster {
    motion: planar,
    mass: 3[kg],
    inertia: 0.2[kg * m ^ 2],
    points: [tip = (0.3, 0.1)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    forces: [jet = body(_, 0).at(tip)],
    outputs: [inverse],
});

rigid_body!(Hoisted {
    motion: planar,
    params: [reach = 0.4[m]],
    mass: 3[kg],
    inertia: 0.2[kg * m ^ 2],
    points: [left = (-reach, 0.1), right = (0.5, 0.1)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    forces: [a = world(0, _).at(left), b = world(0, _).at(right)],
    outputs: [inverse],
});

rigid_body!(Mixed {
    motion: planar,
    mass: 3[kg],
    inertia: 0.2[kg * m ^ 2],
    points: [tip = (0.3, 0.1), anchor = world(2, 5)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    forces: [
        push = body(_, 0),
        rope = (_ * (anchor.position() - tip.position()).normalize()).at(tip)
    ],
    moments: [motor = _],
    outputs: [inverse],
});

rigid_body!(Lever {
    motion: pivot(pin),
    mass: 3[kg],
    inertia: 0.2[kg * m ^ 2],
    points: [pin = (0, 0.5), tip = (0, -0.7)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    forces: [hoist = world(0, _).at(tip)],
    outputs: [inverse],
});

rigid_body!(Crane {
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
    points: [
        hook = (0.3, -0.2, 0.5),
        hub = (-0.1, 0.4, 0.2),
        anchor = world(3, 2, 9)
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        crane = world(0, 0, _).at(hook),
        lift = body(0, 0, _).at(hub),
        rope = (_ * ((anchor.position() - hub.position()) / 1[m])).at(hub)
    ],
    moments: [wheels = body(_, _, _)],
    outputs: [inverse],
});

rigid_body!(Few {
    motion: spatial,
    mass: 3.2[kg],
    inertia: principal(1.3, 1.7, 2.1)[kg * m ^ 2],
    points: [hook = (0.3, -0.2, 0.5), hub = (-0.1, 0.4, 0.2)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        crane = world(_, 0, _).at(hook),
        lift = body(0, 0, _).at(hub)
    ],
    moments: [wheel = world(0, _, 0)],
    outputs: [inverse],
});

rigid_body!(Spun {
    motion: rotation,
    inertia: principal(1.3, 1.7, 2.1)[kg * m ^ 2],
    moments: [outer = world(0, 0, _), inner = body(_, 0, 0)],
    outputs: [inverse],
});

rigid_body!(Held {
    motion: fixed_point(o),
    mass: 3.2[kg],
    inertia: principal(1.3, 1.7, 2.1)[kg * m ^ 2],
    points: [o = (0, 0, -0.5), tip = (0.1, 0.2, 0.7)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [pull = world(_, _, 0).at(tip)],
    moments: [motor = body(0, 0, _)],
    reactions: [support = world(_, _, _).at(o)],
    outputs: [inverse, reactions],
});

rigid_body!(Shaft {
    motion: fixed_axis(o, body(0, 0, 1)),
    mass: 3.2[kg],
    inertia: principal(1.3, 1.7, 2.1)[kg * m ^ 2],
    points: [o = (0.1, 0, -0.5), rim = (0.6, 0.2, 0.7)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2], 0)],
    forces: [belt = world(0, _, 0).at(rim)],
    outputs: [inverse],
});

const G: f64 = 9.80665;

/// Numbers from -1 to 1 without a pattern.
fn spread(seed: u32, n: u32) -> f64 {
    (f64::from(seed * 31 + n).sin() * 43_758.545_3).fract()
}

fn turned(v: [f64; 2], angle: f64) -> Vector2<f64> {
    let (sine, cosine) = angle.sin_cos();
    Vector2::new(cosine * v[0] - sine * v[1], sine * v[0] + cosine * v[1])
}

fn planar(seed: u32) -> Planar {
    Planar {
        position: [spread(seed, 0), spread(seed, 1)].into(),
        velocity: [spread(seed, 2), spread(seed, 3)].into(),
        angle: 3.0 * spread(seed, 4),
        angular_velocity: 4.0 * spread(seed, 5),
    }
}

/// What forces, each at its arm from G, and a moment make of the bodies in the plane.
fn planar_motion(forces: &[(Vector2<f64>, Vector2<f64>)], moment: f64) -> PlanarAcceleration {
    let force: Vector2<f64> = forces.iter().map(|(force, _)| force).sum();
    let moments = forces.iter().map(|(force, arm)| arm.perp(force));
    PlanarAcceleration {
        linear: force / 3.0 - Vector2::new(0.0, G),
        angular: (moments.sum::<f64>() + moment) / 0.2,
    }
}

#[test]
fn in_the_plane() {
    for seed in 0..300 {
        let state = planar(seed);
        let [u, v, w] = [6, 7, 8].map(|n| 20.0 * spread(seed, n));
        let near = |found: f64, expected: f64, size: f64| {
            assert!(
                (found - expected).abs() < 1e-13 * size,
                "{seed}: {found} and {expected}"
            );
        };
        let tip = turned([0.3, 0.1], state.angle);
        let up = Vector2::y();

        let motion = planar_motion(&[(u * up, tip)], 0.0);
        let found = Jet::default()
            .inverse(0.0, &state, &motion, &())
            .expect("one drive");
        near(found.jet.y, u, 500.0);
        assert_eq!(found.jet.x.to_bits(), 0.0_f64.to_bits());
        let found = Along::default()
            .inverse(0.0, &state, &motion, &())
            .expect("one drive");
        near(found.jet.y, u, 500.0);

        let motion = planar_motion(&[(turned([u, 0.0], state.angle), tip)], 0.0);
        // constant in the axes of the body: nothing to guard
        let found: ThrusterDrives = Thruster::default().inverse(0.0, &state, &motion, &());
        near(found.jet.x, u, 500.0);

        let arms = [[-0.4, 0.1], [0.5, 0.1]].map(|arm| turned(arm, state.angle));
        let motion = planar_motion(&[(u * up, arms[0]), (v * up, arms[1])], 0.0);
        let found = Hoisted::default()
            .inverse(0.0, &state, &motion, &())
            .expect("level enough");
        let lost = 1.0 / state.angle.cos().abs();
        near(found.a.y, u, 500.0 * lost);
        near(found.b.y, v, 500.0 * lost);

        let rope = (Vector2::new(2.0, 5.0) - state.position - tip).normalize();
        let push = turned([v, 0.0], state.angle);
        let motion = planar_motion(&[(u * rope, tip), (push, Vector2::zeros())], w);
        let found = Mixed::default()
            .inverse(0.0, &state, &motion, &())
            .expect("two directions");
        let lost = 1.0 / rope.perp(&turned([1.0, 0.0], state.angle)).abs();
        near((found.rope - u * rope).norm(), 0.0, 500.0 * lost);
        near(found.push.x, v, 500.0 * lost);
        near(found.motor, w, 500.0 * lost);
    }
}

/// A lever that hangs straight down is not lifted by a force along it.
#[test]
fn singular_configurations() {
    for seed in 1..100 {
        let hinge = Hinge {
            angle: 3.0 * spread(seed, 0),
            angular_velocity: spread(seed, 1),
        };
        let force = 20.0 * spread(seed, 2);
        let inertia = 0.2 + 3.0 * 0.25;
        let arms = [-0.5, -1.2].map(|y| turned([0.0, y], hinge.angle).x);
        let angular = (force * arms[1] - 3.0 * G * arms[0]) / inertia;
        let found = Lever::default().inverse(0.0, &hinge, &angular, &());
        let hoist = found.expect("away from the vertical").hoist;
        assert!(
            (hoist.y - force).abs() < 1e-13 / arms[1].abs() * 100.0,
            "{seed}: {hoist}"
        );
    }
    let vertical = Hinge::default();
    let Err(Singular { unknown, .. }) = Lever::default().inverse(0.0, &vertical, &1.0, &()) else {
        panic!("singular");
    };
    assert_eq!(unknown, "Lever.hoist.y");
    let upright = Planar {
        angle: std::f64::consts::FRAC_PI_2,
        ..Planar::default()
    };
    let wanted = PlanarAcceleration {
        linear: [0.0, 1.0].into(),
        angular: 1.0,
    };
    assert!(
        Hoisted::default()
            .inverse(0.0, &upright, &wanted, &())
            .is_err()
    );
    let nearly = Planar {
        angle: std::f64::consts::FRAC_PI_2 - 1e-9,
        ..Planar::default()
    };
    assert!(
        Hoisted::default()
            .inverse(0.0, &nearly, &wanted, &())
            .is_ok()
    );
}

struct Space {
    state: Spatial,
    mass: f64,
    inertia: Matrix3<f64>,
}

impl Space {
    fn new(seed: u32, inertia: Matrix3<f64>) -> Self {
        let x = |n: u32| spread(seed, n);
        let state = Spatial {
            position: Vector3::new(x(0), x(1), x(2)),
            velocity: Vector3::new(x(3), x(4), x(5)),
            attitude: UnitQuaternion::from_euler_angles(3.0 * x(6), 1.5 * x(7), 3.0 * x(8)),
            angular_velocity: 3.0 * Vector3::new(x(9), x(10), x(11)),
        };
        let mass = 3.2;
        Self {
            state,
            mass,
            inertia,
        }
    }

    fn world(&self, v: [f64; 3]) -> Vector3<f64> {
        self.state.attitude * Vector3::from(v)
    }

    /// Forces at their arms from G, and a moment, world axes.
    fn motion(
        &self,
        forces: &[(Vector3<f64>, Vector3<f64>)],
        moment: Vector3<f64>,
    ) -> SpatialAcceleration {
        let force: Vector3<f64> = forces.iter().map(|(force, _)| force).sum();
        let moments: Vector3<f64> = forces.iter().map(|(force, arm)| arm.cross(force)).sum();
        let w = self.state.angular_velocity;
        let moment =
            self.state.attitude.inverse() * (moments + moment) - w.cross(&(self.inertia * w));
        SpatialAcceleration {
            linear: force / self.mass - Vector3::new(0.0, 0.0, G),
            angular: self.inertia.try_inverse().expect("an inertia") * moment,
        }
    }
}

#[test]
fn in_space() {
    let full = Matrix3::new(1.3, -0.12, 0.07, -0.12, 1.7, -0.05, 0.07, -0.05, 2.1);
    let principal = Matrix3::from_diagonal(&Vector3::new(1.3, 1.7, 2.1));
    for seed in 0..300 {
        let [u, v, w, r, s, t] = [12, 13, 14, 15, 16, 17].map(|n| 20.0 * spread(seed, n));
        let space = Space::new(seed, full);
        let (hook, hub) = (space.world([0.3, -0.2, 0.5]), space.world([-0.1, 0.4, 0.2]));
        let rope = Vector3::new(3.0, 2.0, 9.0) - space.state.position - hub;
        let lift = space.world([0.0, 0.0, v]);
        let motion = space.motion(
            &[
                (u * Vector3::z(), hook),
                (lift, hub),
                (w / 10.0 * rope, hub),
            ],
            space.world([r, s, t]),
        );
        let found = Crane::default().inverse(0.0, &space.state, &motion, &());
        let found = found.expect("three directions");
        let directions = Matrix3::from_columns(&[Vector3::z(), lift.normalize(), rope.normalize()]);
        let size = 3000.0 / directions.determinant().abs();
        for (found, expected) in [
            (found.crane, u * Vector3::z()),
            (found.lift, Vector3::new(0.0, 0.0, v)),
            (found.rope, w / 10.0 * rope),
            (found.wheels, Vector3::new(r, s, t)),
        ] {
            let error = (found - expected).norm();
            assert!(error < 1e-14 * size, "{seed}: {found} and {expected}");
        }

        let space = Space::new(seed, principal);
        let forces = [
            (Vector3::new(u, 0.0, r), hook),
            (space.world([0.0, 0.0, v]), hub),
        ];
        let motion = space.motion(&forces, Vector3::new(0.0, s, 0.0));
        let found = Few::default()
            .inverse(0.0, &space.state, &motion, &())
            .expect("four drives");
        for (found, expected) in [
            (found.crane, Vector3::new(u, 0.0, r)),
            (found.lift, Vector3::new(0.0, 0.0, v)),
            (found.wheel, Vector3::new(0.0, s, 0.0)),
        ] {
            assert!(
                (found - expected).norm() < 1e-9,
                "{seed}: {found} and {expected}"
            );
        }

        let rotation = Rotation {
            attitude: space.state.attitude,
            angular_velocity: space.state.angular_velocity,
        };
        let motion = space.motion(&[], Vector3::new(0.0, 0.0, u) + space.world([v, 0.0, 0.0]));
        let found = Spun::default().inverse(0.0, &rotation, &motion.angular, &());
        let found = found.expect("two directions");
        assert!(
            (found.outer.z - u).abs() + (found.inner.x - v).abs() < 1e-9,
            "{seed}"
        );

        // about the point that is held
        let inertia = principal + 3.2 * 0.25 * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 0.0));
        let about = Space { inertia, ..space };
        let weight = (
            Vector3::new(0.0, 0.0, -3.2 * G),
            about.world([0.0, 0.0, 0.5]),
        );
        let pull = (Vector3::new(u, v, 0.0), about.world([0.1, 0.2, 1.2]));
        let motion = about.motion(&[weight, pull], about.world([0.0, 0.0, w]));
        let found = Held::default().inverse(0.0, &rotation, &motion.angular, &());
        let found = found.expect("three directions");
        let lost = 1.0 / about.world([0.0, 0.0, 1.0]).z.abs();
        let error = (found.pull - pull.0).norm() + (found.motor.z - w).abs();
        assert!(error < 1e-11 * lost * lost, "{seed}: {found:?}");

        let hinge = Hinge {
            angle: 3.0 * spread(seed, 0),
            angular_velocity: spread(seed, 1),
        };
        let arms = [[-0.1, 0.0], [0.5, 0.2]].map(|arm| turned(arm, hinge.angle).x);
        let angular = (u * arms[1] - 3.2 * G * arms[0]) / (2.1 + 3.2 * 0.01);
        let found = Shaft::default().inverse(0.0, &hinge, &angular, &());
        let belt = found.expect("not in line").belt;
        assert!(
            (belt.y - u).abs() < 1e-13 / arms[1].abs() * 100.0,
            "{seed}: {belt}"
        );
    }
}

mod of_any_scalar {
    newton_euler::rigid_body!(Lever::<T> {
        motion: pivot(pin),
        mass: 3[kg],
        inertia: 0.2[kg * m ^ 2],
        points: [pin = (0, 0.5), tip = (0, -0.7)],
        forces: [hoist = (_ * world(3, 4)).at(tip)],
        outputs: [inverse],
    });
}

/// In single precision, and with the derivative of the drive by the acceleration.
#[test]
fn other_scalars() {
    use newton_euler::{Dual, state::generic};
    let hinge = generic::Hinge {
        angle: 0.6_f32,
        angular_velocity: 0.1,
    };
    let single = of_any_scalar::Lever::<f32>::default().inverse(0.0, &hinge, &2.0, &());
    let hinge = generic::Hinge {
        angle: Dual::from(0.6),
        angular_velocity: Dual::from(0.1),
    };
    let wanted = Dual::<f64, 1>::variable(2.0, 0);
    let lever = of_any_scalar::Lever::<Dual<f64, 1>>::default();
    let dual = lever.inverse(Dual::from(0.0), &hinge, &wanted, &());
    let (single, dual) = (
        single.expect("a moment").hoist,
        dual.expect("a moment").hoist,
    );
    let arm = turned([0.0, -1.2], 0.6);
    let expected = 2.0 * (0.2 + 3.0 * 0.25) / arm.perp(&Vector2::new(0.6, 0.8));
    assert!((f64::from(single.x) - 0.6 * expected).abs() < 1e-5);
    assert!((dual.y.value - 0.8 * expected).abs() < 1e-14);
    assert!((dual.y.derivatives[0] - 0.4 * expected).abs() < 1e-14);
}
