//! A system of one body on one joint has the same operations, and to rounding the same
//! accelerations, as the single body with the kind of motion that the joint gives it.

use nalgebra::{Quaternion, UnitQuaternion, Vector2, Vector3};
use newton_euler::operations::Operations;
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;

/// The same body twice: with this motion, and as a system with this joint.
macro_rules! twice {
    (
        $body:ident, $system:ident: $motion:ident $(($($held:tt)*))? = { $($joint:tt)* } { $($only:tt)* }
        { $($whole:tt)* } { $($own:tt)* } { $($mass:tt)* }
    ) => {
        rigid_body!($body {
            motion: $motion $(($($held)*))?,
            $($whole)*
            $($own)*
        });
        rigid_system!($system {
            $($only)*
            $($whole)*
            bodies: [b { $($mass)* $($own)* }],
            joints: [j = $($joint)*],
        });
    };
}

twice!(Flying, FlyingSystem: spatial = { free(b) } {} {
    params: [length = 0.3[m]],
    inputs: [push[N], twist[N * m]],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
} {
    mass: 2.5[kg],
    inertia: tensor { xx: 1.3, yy: 1.7, zz: 2.1, xy: -0.12, yz: -0.05, zx: 0.07 }[kg * m ^ 2],
    points: [tip = (length, 0.1, -0.2)],
    forces: [thrust = (push * body(0, 1, 0)).at(tip), wind = world(1, 2, 3)[N]],
    moments: [motor = twist * body(0, 0, 1)],
} {});

twice!(Principal, PrincipalSystem: spatial = { free(b) } {} {
    params: [length = 0.3[m]],
    inputs: [push[N], twist[N * m]],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
} {
    mass: 2.5[kg],
    inertia: principal(1.3, 1.7, 2.1)[kg * m ^ 2],
    points: [tip = (length, 0.1, -0.2)],
    forces: [thrust = (push * body(0, 1, 0)).at(tip)],
    moments: [motor = twist * body(0, 0, 1)],
} {});

twice!(Turning, TurningSystem: rotation = { rotation(b) } {} {
    inputs: [push[N], twist[N * m]],
} {
    inertia: tensor { xx: 1.3, yy: 1.7, zz: 2.1, xy: -0.12, yz: -0.05, zx: 0.07 }[kg * m ^ 2],
    moments: [motor = body(twist, 0, 0.3[m] * push)],
} { mass: 1[kg], });

twice!(Moving, MovingSystem: translation = { translation(b) } {} {
    params: [stiffness = 3[N / m]],
    inputs: [push[N], twist[N * m]],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
} {
    mass: 2[kg],
    inertia: principal(1, 1, 1)[kg * m ^ 2],
    forces: [spring = -stiffness * position, hand = world(push, 0, twist / 1[m])],
} {});

twice!(Top, TopSystem: fixed_point(foot) = { spherical(world(0, 0, 0), b.foot) } {} {
    params: [length = 0.1[m]],
    inputs: [push[N], twist[N * m]],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
} {
    mass: 0.3[kg],
    inertia: principal(0.002, 0.002, 0.001)[kg * m ^ 2],
    points: [foot = (0, 0, -length)],
    forces: [hand = world(push, 0, 0)],
    moments: [motor = twist * body(0, 0, 1)],
} {});

twice!(Held, HeldSystem: fixed_point(foot) = { spherical(world(0, 0, 0), b.foot) } {} {
    inputs: [push[N], twist[N * m]],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
} {
    mass: 0.3[kg],
    inertia: tensor { xx: 1.3, yy: 1.7, zz: 2.1, xy: -0.12, yz: -0.05, zx: 0.07 }[kg * m ^ 2],
    points: [foot = (0.1, 0.2, -0.3)[m]],
    forces: [hand = push * world(0, 1, 0)],
    moments: [motor = body(twist, 0, 0), brake = -0.1[N * m * s] * angular_velocity],
} {});

twice!(Door, DoorSystem: fixed_axis(hinge, world(0, 1, 0))
    = { revolute(world(0, 0, 0), b.hinge, world(0, 1, 0)) } {} {
    inputs: [push[N], twist[N * m]],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
} {
    mass: 12[kg],
    inertia: cuboid(0.8, 0.04, 2),
    points: [hinge = (-0.4, 0, 0.1), handle = (0.35, 0.02, 0)],
    forces: [hand = (push * body(0, 0, 1)).at(handle)],
    moments: [damping = -0.5[N * m * s] * angular_velocity, motor = world(0, twist, 0)],
} {});

twice!(Plank, PlankSystem: planar = { free(b) } { motion: planar, } {
    params: [length = 2[m]],
    inputs: [push[N], twist[N * m]],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
} {
    mass: 4[kg],
    inertia: mass * length.powi(2) / 12,
    points: [end = (1, 0)[m]],
    forces: [hand = (push * body(0.6, 1)).at(end)],
    moments: [motor = twist],
} {});

twice!(Pendulum, PendulumSystem: pivot(hinge) = { revolute(world(0, 0), b.hinge) } { motion: planar, } {
    inputs: [push[N], twist[N * m]],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
} {
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [hinge = (0, 0.5)],
    forces: [hand = body(push, 0)],
    moments: [motor = twist],
} {});

/// Of the acceleration: multiplications, additions, divisions, and sines and cosines.
fn counted(operations: &[Operations]) -> [u32; 4] {
    let mut rows = operations.iter();
    let row = rows.find(|row| row.function == "acceleration").unwrap();
    assert_eq!((row.sqrt, row.other), (0, 0));
    [row.mul, row.add, row.div, row.trig]
}

#[test]
fn one_body_takes_the_operations_of_that_body() {
    macro_rules! rows {
        ($($body:ident $system:ident $count:expr;)*) => {
            [$((stringify!($body), counted($body::OPERATIONS), counted($system::OPERATIONS), $count),)*]
        };
    }
    let rows = rows! {
        Flying FlyingSystem [35, 24, 0, 0];
        Principal PrincipalSystem [19, 8, 0, 0];
        Turning TurningSystem [24, 16, 0, 0];
        Moving MovingSystem [5, 3, 0, 0];
        Top TopSystem [19, 9, 0, 0];
        Held HeldSystem [55, 38, 0, 0];
        Door DoorSystem [5, 4, 0, 2];
        Plank PlankSystem [7, 4, 0, 2];
        Pendulum PendulumSystem [3, 2, 0, 1];
    };
    for (name, body, system, count) in rows {
        assert_eq!(system, body, "{name}");
        let is_few = system
            .iter()
            .zip(count)
            .all(|(found, bound)| *found <= bound);
        assert!(is_few, "{name}: {system:?}");
    }
}

/// States that look random, the same in each run.
struct Random(u64);

impl Random {
    #[allow(clippy::cast_precision_loss, reason = "53 bits are kept")]
    fn number(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> Vector3<f64> {
        [self.number(), self.number(), self.number()].into()
    }

    fn attitude(&mut self) -> UnitQuaternion<f64> {
        let numbers = [(); 4].map(|()| self.number());
        UnitQuaternion::new_normalize(Quaternion::from(numbers))
    }

    fn hinge(&mut self) -> Hinge {
        Hinge {
            angle: 3.0 * self.number(),
            angular_velocity: self.number(),
        }
    }

    fn rotation(&mut self) -> Rotation {
        Rotation {
            attitude: self.attitude(),
            angular_velocity: self.vector(),
        }
    }

    fn spatial(&mut self) -> Spatial {
        let Rotation {
            attitude,
            angular_velocity,
        } = self.rotation();
        Spatial {
            position: self.vector(),
            attitude,
            velocity: self.vector(),
            angular_velocity,
        }
    }

    fn translation(&mut self) -> Translation {
        Translation {
            position: self.vector(),
            velocity: self.vector(),
        }
    }

    fn planar(&mut self) -> Planar {
        let Hinge {
            angle,
            angular_velocity,
        } = self.hinge();
        Planar {
            position: Vector2::new(self.number(), self.number()),
            angle,
            velocity: Vector2::new(self.number(), self.number()),
            angular_velocity,
        }
    }
}

/// Both add the same terms, in another order.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

#[test]
fn one_body_accelerates_as_that_body() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    macro_rules! compare {
        ($($body:ident $input:ident, $system:ident $state:ident $of_system:ident: $draw:ident;)*) => {$(
            for _ in 0..100 {
                let (push, twist) = (9.0 * random.number(), random.number());
                let state = random.$draw();
                let body = $body::default().acceleration(0.0, &state, &$input { push, twist });
                let system = $system::default();
                let system = system.acceleration(
                    0.0,
                    &$state { j: state },
                    &$of_system { push, twist },
                );
                let [single, joined] = [body, system.j].map(|one| state.rates(&one));
                for (single, joined) in single.iter().zip(joined) {
                    let off = (single - joined).abs();
                    assert!(off <= ROUNDING * (1.0 + single.abs()), "{}: {off}", stringify!($body));
                }
            }
        )*};
    }
    compare! {
        Flying FlyingInput, FlyingSystem FlyingSystemState FlyingSystemInput: spatial;
        Principal PrincipalInput, PrincipalSystem PrincipalSystemState PrincipalSystemInput: spatial;
        Turning TurningInput, TurningSystem TurningSystemState TurningSystemInput: rotation;
        Moving MovingInput, MovingSystem MovingSystemState MovingSystemInput: translation;
        Top TopInput, TopSystem TopSystemState TopSystemInput: rotation;
        Held HeldInput, HeldSystem HeldSystemState HeldSystemInput: rotation;
        Door DoorInput, DoorSystem DoorSystemState DoorSystemInput: hinge;
        Plank PlankInput, PlankSystem PlankSystemState PlankSystemInput: planar;
        Pendulum PendulumInput, PendulumSystem PendulumSystemState PendulumSystemInput: hinge;
    }
}
