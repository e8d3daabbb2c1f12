//! Users may choose any names: bodies, parameters, inputs and points with names that generated code
//! uses internally, and with names of items next to a description.
#![deny(warnings, missing_docs, clippy::pedantic)]
#![forbid(unsafe_code)]

/// Names that clash with nothing although generated code may use them too.
pub mod names {
    newton_euler::rigid_body!(Spatial {
        doc: "A body called as a state is.",
        motion: spatial,
        params: [
            J = 1.5,
            j = 1,
            self_mass = 2.5,
            Params = body(0.1, 0.2, 0.3)
        ],
        inputs: [
            state,
            input,
            time,
            x,
            qw,
            acceleration,
            w_x = body(_, _, _),
            reactions,
            private,
        ],
        mass: self_mass,
        inertia: principal(J, J, 2),
        points: [
            force = (state_0, 0, 0),
            moment = Params,
            angular = world(1, 2, 3)
        ],
        locals: [
            state_0 = 0.25,
            linear = time * state,
            torque = w_x * x,
            params = input + qw * j
        ],
        forces: [
            force = body(linear, acceleration, params).at(moment),
            residual = torque.at(force),
            v = (angular.position() - position) * reactions,
        ],
        moments: [moment = world(0, 0, private)],
        fields: [weight = mass * world(0, 0, -9.80665)],
        pole: angular,
        outputs: [energy, momentum, balance],
    });

    newton_euler::rigid_body!(Load {
        motion: planar,
        params: [self_ = 1, f64 = 2, Self_ = 3],
        inputs: [sin, cos, angle, math = world(_, _)],
        mass: self_ + f64,
        inertia: Self_,
        points: [Vector2 = (0.1, 0.2)],
        forces: [applied = (math + body(sin, cos)).at(Vector2)],
        moments: [turning = angle],
        outputs: [energy, momentum, balance],
    });

    newton_euler::rigid_body!(Balance {
        motion: rotation,
        params: [Vec = 1, Box = 1.5],
        inputs: [String, Self_],
        inertia: principal(Vec, Box, 2),
        moments: [twist = body(String, Self_, String * Self_)],
        outputs: [energy, momentum, balance],
    });

    newton_euler::rigid_body!(Momentum {
        motion: translation,
        params: [Default = 1],
        inputs: [kinetic, potential],
        mass: Default,
        forces: [driven = world(kinetic, potential, kinetic)],
        outputs: [energy, momentum, balance],
    });

    newton_euler::rigid_body!(Acceleration::<State> {
        motion: planar,
        inputs: [command, parts],
        states: [
            state,
            acceleration,
            x,
            J,
            time,
            rate,
            any,
            field,
            angle,
            self_
        ],
        rates: [
            state = acceleration,
            acceleration = x * rate,
            x = command - parts,
            J = time,
            time = 1,
            rate = J.sin(),
            any = field,
            field = any,
            angle = self_ + angle,
            self_ = velocity.in_world().x,
        ],
        mass: 2,
        inertia: 3,
        forces: [push = world(state, J)],
        moments: [turn = angle],
        outputs: [energy, taylor],
    });
}

/// Standard names, modules and constants of the user's own beside a description.
pub mod shadowed {
    #![allow(dead_code, reason = "these only stand in the way")]

    type Result<T> = core::result::Result<T, String>;
    type Option = ();
    type Vector3 = ();
    const J: f64 = 0.5;
    const G_X: f64 = 0.5;
    trait Default {}
    trait Clone {}
    trait RigidBody {}
    mod core_of_the_user {}
    mod std {}
    mod nalgebra {}

    newton_euler::rigid_body!(Craft {
        motion: spatial,
        params: [m = 2.5, J = 3],
        inputs: [push = body(_, _, _), G_X],
        mass: m,
        inertia: principal(1, 2, J),
        forces: [pushed = (G_X * push).at((0.1, 0.2, 0.3))],
        outputs: [energy, momentum, balance],
    });

    /// A function of the user's, whose result is not the standard one.
    ///
    /// # Errors
    /// Never.
    pub fn fallible() -> Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;
    use newton_euler::body::{Energy, RigidBody};
    use newton_euler::state::{Planar, Spatial};

    use super::{names, shadowed};

    #[test]
    fn names_of_the_user_are_the_users() {
        let body = names::Spatial::default();
        let [state, input, time, x, qw] = [1.0, 2.0, 3.0, 4.0, 5.0];
        let w_x = Vector3::new(7.0, 8.0, 9.0);
        let [acceleration, reactions, private] = [6.0, 10.0, 11.0];
        let all = names::SpatialInput {
            state,
            input,
            time,
            x,
            qw,
            acceleration,
            w_x,
            reactions,
            private,
        };
        let at = Spatial {
            angular_velocity: Vector3::new(0.5, -1.0, 2.0),
            ..Spatial::default()
        };
        let computed = body.acceleration(0.0, &at, &all);
        // At identity: (time · state, acceleration, input + qw) + w_x · x + (1, 2, 3) · reactions + weight
        let first = Vector3::new(time * state, acceleration, input + qw);
        let (second, third) = (w_x * x, Vector3::new(1.0, 2.0, 3.0) * reactions);
        let expected = (first + second + third) / 2.5 - Vector3::z() * 9.80665;
        // Terms to 36 N over 2.5 kg, a few roundings.
        assert!((computed.linear - expected).amax() < 1e-13);
        let k = Vector3::new(0.1, 0.2, 0.3).cross(&first)
            + Vector3::new(0.25, 0.0, 0.0).cross(&second)
            + Vector3::new(0.0, 0.0, private);
        let j = Vector3::new(1.5, 1.5, 2.0);
        let w = at.angular_velocity;
        let expected = (k - w.cross(&j.component_mul(&w))).component_div(&j);
        assert!((computed.angular - expected).amax() < 1e-13); // terms to 11 N m over 1.5 kg m²

        let rate = names::Acceleration::default().acceleration(
            0.0,
            &names::AccelerationState {
                motion: Planar::default(),
                state: 2.0,
                acceleration: 4.0,
                J: 6.0,
                angle: 9.0,
                ..names::AccelerationState::default()
            },
            &names::AccelerationInput {
                command: 5.0,
                parts: 1.0,
            },
        );
        assert_eq!(rate.motion.linear, nalgebra::Vector2::new(1.0, 3.0));
        let found = Vector3::new(rate.state, rate.x, rate.angle);
        assert_eq!(found, Vector3::new(4.0, 4.0, 9.0));

        let plate = names::Load::default();
        assert!(
            (plate.kinetic_energy(&Planar {
                angular_velocity: 2.0,
                ..Planar::default()
            }) - 6.0)
                .abs()
                < 1e-15
        );
    }

    #[test]
    fn constants_of_the_user_are_not_the_bodys() {
        shadowed::fallible().unwrap();
        let body = shadowed::Craft::default();
        assert_eq!(body.params().J.to_bits(), 3.0_f64.to_bits());
        let input = shadowed::CraftInput {
            push: Vector3::x(),
            G_X: 5.0,
        };
        let computed = body.acceleration(0.0, &Spatial::default(), &input);
        assert_eq!(computed.linear, Vector3::new(2.0, 0.0, 0.0));
        // (0.1, 0.2, 0.3) × (5, 0, 0) = (0, 1.5, -1)
        let expected = Vector3::new(0.0, 0.75, -1.0 / 3.0);
        assert!((computed.angular - expected).amax() < 1e-15); // two roundings
    }
}

/// Descriptions whose parts another macro passes on, as fragments of all kinds.
mod fragments {
    use newton_euler::prelude::*;

    macro_rules! block {
        ($v:vis $name:ident $exponent:literal $unit:expr, $mass:expr) => {
            rigid_body!($v $name {
                doc: "A block that falls.",
                motion: translation,
                mass: $mass * 1[$unit],
                fields: [weight = mass * world(0, 0, -9.81[m / s ^ $exponent])],
            });
        };
    }
    block!(Block 2 kg, 1 + 2);

    macro_rules! arm {
        ($name:ident $joint:expr, $inertia:expr, $point:expr) => {
            rigid_system!($name {
                doc: "An arm.",
                motion: planar,
                bodies: [arm {
                    inertia: $inertia,
                    points: [o = $point]
                }],
                joints: [hinge = revolute(world(0, 0), arm.o)],
                drives: [motor = 4[N * m].on($joint)],
                outputs: [reactions($joint)],
            });
        };
    }
    arm!(Arm hinge, compose([point(1[kg]).at((2, 0)[m])]), (0, 0));

    #[test]
    fn are_as_if_written() {
        let found = Block::default().acceleration(0.0, &Translation::default(), &());
        assert_eq!(found.z.to_bits(), (-9.81_f64).to_bits());
        let found = Arm::default().acceleration(0.0, &ArmState::default(), &());
        assert_eq!(found.hinge.to_bits(), 1.0_f64.to_bits());
    }
}
