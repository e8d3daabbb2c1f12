//! The evaluations of bodies.

use newton_euler::body::Singular;
use newton_euler::constrained::{Inconsistent, Violation};
use newton_euler::load::{Load, PlanarLoad};
use newton_euler::nalgebra::{Vector2, Vector3};
use newton_euler::prelude::*;
use newton_euler::scalar::Dual;
use newton_euler::state::{Coordinates, generic};

use crate::kinds::*;

/// A body's acceleration, and the rates of its coordinates.
macro_rules! accelerations {
    ($($name:ident: $body:ty;)*) => {
        $(mod $name {
            use super::*;

            type State = <$body as RigidBody>::State;
            type Input = <$body as RigidBody>::Input;
            type Real = <$body as RigidBody>::Scalar;

            cannot_panic! {
                fn acceleration(body: &$body, time: Real, state: &State, input: &Input)
                -> <State as newton_euler::state::State>::Acceleration {
                    body.acceleration(time, state, input)
                }

                fn rates(body: &$body, time: Real, state: &State, input: &Input)
                -> <State as Coordinates>::Array {
                    state.rates(&body.acceleration(time, state, input))
                }
            }
        })*

        fn link_accelerations() -> usize {
            [$($name::link()),*].iter().sum()
        }
    };
}

/// Both energies.
macro_rules! energies {
    ($($name:ident: $body:ty;)*) => {
        $(mod $name {
            use super::*;

            type State = <$body as RigidBody>::State;
            type Input = <$body as RigidBody>::Input;
            type Real = <$body as RigidBody>::Scalar;

            cannot_panic! {
                fn kinetic_energy(body: &$body, state: &State) -> Real {
                    body.kinetic_energy(state)
                }

                fn potential_energy(body: &$body, time: Real, state: &State, input: &Input) -> Real {
                    body.potential_energy(time, state, input)
                }
            }
        })*

        fn link_energies() -> usize {
            [$($name::link()),*].iter().sum()
        }
    };
}

accelerations! {
    craft: Craft<f64>;
    craft_single: Craft<f32>;
    craft_dual: Craft<Dual<f64, 6>>;
    quadrotor: Quadrotor;
    brick: Brick;
    turning: Turning<f64>;
    turning_single: Turning<f32>;
    top: Top<f64>;
    top_single: Top<f32>;
    gyroscope: Gyroscope;
    rotor: Rotor<f64>;
    rotor_single: Rotor<f32>;
    wave: Wave<f64>;
    wave_single: Wave<f32>;
    wave_dual: Wave<Dual<f64, 2>>;
    stone: Stone;
    plank: Plank<f64>;
    plank_single: Plank<f32>;
    slider: Slider<f64>;
    slider_single: Slider<f32>;
    pendulum: Pendulum<f64>;
    pendulum_single: Pendulum<f32>;
    swing: Swing;
    stick: Stick<f64>;
    stick_single: Stick<f32>;
    needle: Needle;
    dipole: Dipole;
    bead: Bead;
    tethered: Tethered;
}

energies! {
    energy_of_craft: Craft<f64>;
    energy_of_craft_single: Craft<f32>;
    energy_of_quadrotor: Quadrotor;
    energy_of_brick: Brick;
    energy_of_turning: Turning<f64>;
    energy_of_top: Top<f64>;
    energy_of_rotor: Rotor<f64>;
    energy_of_plank: Plank<f64>;
    energy_of_plank_single: Plank<f32>;
    energy_of_pendulum: Pendulum<f64>;
    energy_of_stick: Stick<f64>;
    energy_of_dipole: Dipole;
    energy_of_bead: Bead;
}

mod others {
    use super::*;

    cannot_panic! {
        fn momenta(body: &Craft<f64>, time: f64, state: &Spatial) -> [Vector3<f64>; 3] {
            [
                body.linear_momentum(state),
                body.angular_momentum(state),
                body.angular_momentum_about_pole(time, state),
            ]
        }

        fn momenta_single(body: &Craft<f32>, time: f32, state: &generic::Spatial<f32>) -> [Vector3<f32>; 3] {
            [
                body.linear_momentum(state),
                body.angular_momentum(state),
                body.angular_momentum_about_pole(time, state),
            ]
        }

        fn momenta_in_the_plane(body: &Plank<f64>, time: f64, state: &Planar) -> (Vector2<f64>, [f64; 2]) {
            let about_pole = body.angular_momentum_about_pole(time, state);
            (body.linear_momentum(state), [body.angular_momentum(state), about_pole])
        }

        fn momenta_of_a_rod(body: &Stick<f64>, state: &Rod) -> [Vector3<f64>; 2] {
            [body.linear_momentum(state), body.angular_momentum(state)]
        }

        fn applied(body: &Craft<f64>, time: f64, state: &Spatial, input: &CraftInput<f64>) -> Wrench {
            body.applied(time, state, input)
        }

        fn residual(
            body: &Craft<f64>,
            time: f64,
            state: &Spatial,
            acceleration: &SpatialAcceleration,
            input: &CraftInput<f64>,
        ) -> Wrench {
            body.residual(time, state, acceleration, &(), input)
        }

        fn loads(body: &Craft<f64>, time: f64, state: &Spatial, input: &CraftInput<f64>) -> [Load; 5] {
            body.loads(time, state, input)
        }

        fn loads_in_the_plane(body: &Plank<f64>, time: f64, state: &Planar, input: &PlankInput<f64>) -> [PlanarLoad; 2] {
            body.loads(time, state, input)
        }

        fn force_on_a_foot(body: &Top<f64>, time: f64, state: &Rotation) -> Vector3<f64> {
            body.reactions(time, state, &()).ground
        }

        fn force_on_a_pin(body: &Pendulum<f64>, time: f64, state: &Hinge) -> Vector2<f64> {
            body.reactions(time, state, &()).hold
        }

        fn loads_of_bearings(body: &Rotor<f64>, time: f64, state: &Hinge, input: &RotorInput<f64>) -> [Vector3<f64>; 2] {
            let loads = body.reactions(time, state, input);
            [loads.below, loads.beside]
        }

        fn inverse(
            body: &Quadrotor,
            time: f64,
            state: &Spatial,
            acceleration: &SpatialAcceleration,
        ) -> [Vector3<f64>; 2] {
            let drives = body.inverse(time, state, acceleration, &());
            [drives.thrust, drives.rotors]
        }

        fn reactions_of_constraints(body: &Bead, time: f64, state: &Planar) -> Result<Vector2<f64>, Singular> {
            body.reactions(time, state, &()).map(|reactions| reactions.hinge)
        }

        fn tension(body: &Tethered, time: f64, state: &Translation, input: &TetheredInput) -> Result<Vector3<f64>, Singular> {
            body.reactions(time, state, input).map(|reactions| reactions.string)
        }

        fn violations(body: &Bead, time: f64, state: &Planar) -> [Violation; 2] {
            body.violations(time, state, &())
        }

        fn check(body: &Bead, time: f64, state: &Planar) -> Result<(), Inconsistent> {
            body.check(time, state, &())
        }

        fn project(body: &Bead, time: f64, state: &mut Planar) -> Result<(), Inconsistent> {
            body.project(time, state, &())
        }

        fn project_to_a_length(
            body: &Tethered,
            time: f64,
            state: &mut Translation,
            input: &TetheredInput,
        ) -> Result<(), Inconsistent> {
            body.project(time, state, input)
        }
    }
}

pub fn link() -> usize {
    link_accelerations() + link_energies() + others::link()
}
