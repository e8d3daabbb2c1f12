//! Steps and motions, by every method.

use newton_euler::integrate::{
    Classical4, ClosedForm, DormandPrince, DormandPrince8, Event, Fixed, IntegrationError, Method,
    Midpoint, Projected, Run, RungeKuttaPair, Sample, TaylorSeries, Tsitouras5, Verner, Verner9,
    cf4_step, runge_kutta_step, taylor_step,
};
use newton_euler::prelude::*;

use crate::kinds::*;
use crate::systems::{Assembly, Chain, DoublePendulum, Geared};

/// What ends a motion of a body.
type Ended<B> = IntegrationError<<B as RigidBody>::State>;

/// Single steps of a body over any scalar.
macro_rules! steps {
    ($($name:ident: $body:ty;)*) => {
        $(mod $name {
            use super::*;

            type State = <$body as RigidBody>::State;
            type Input = <$body as RigidBody>::Input;
            type Real = <$body as RigidBody>::Scalar;

            cannot_panic! {
                fn midpoint(body: &$body, time: Real, state: &State, input: &Input, step: Real) -> State {
                    runge_kutta_step::<Midpoint, _>(body, time, state, input, step)
                }

                fn classical(body: &$body, time: Real, state: &State, input: &Input, step: Real) -> State {
                    runge_kutta_step::<Classical4, _>(body, time, state, input, step)
                }

                fn tsitouras(body: &$body, time: Real, state: &State, input: &Input, step: Real) -> State {
                    runge_kutta_step::<Tsitouras5, _>(body, time, state, input, step)
                }

                fn dormand_prince(body: &$body, time: Real, state: &State, input: &Input, step: Real) -> State {
                    runge_kutta_step::<DormandPrince8, _>(body, time, state, input, step)
                }

                fn commutator_free(body: &$body, time: Real, state: &State, input: &Input, step: Real) -> State {
                    cf4_step(body, time, state, input, step)
                }
            }
        })*

        fn link_steps() -> usize {
            [$($name::link()),*].iter().sum()
        }
    };
}

/// Whole motions of a body by a method: to an end, by steps, samples and events.
macro_rules! motions {
    ($($name:ident: $body:ty, $method:ty;)*) => {
        $(mod $name {
            use super::*;

            type State = <$body as RigidBody>::State;
            type Input = <$body as RigidBody>::Input;

            cannot_panic! {
                fn advance(
                    run: &mut <$method as Method<$body>>::Run,
                    body: &$body,
                    end: f64,
                    input: &Input,
                ) -> Result<(), Ended<$body>> {
                    run.advance(body, end, input)
                }

                fn to(body: &$body, state: &State, method: $method, end: f64) -> Result<State, Ended<$body>> {
                    body.integrate(state).method(method).to(end)
                }

                fn second_sample(
                    body: &$body,
                    state: &State,
                    method: $method,
                    end: f64,
                    period: f64,
                ) -> Option<Result<Sample<State>, Ended<$body>>> {
                    body.integrate(state).method(method).samples(end, period).nth(1)
                }

                fn last_step(
                    body: &$body,
                    state: &State,
                    method: $method,
                    end: f64,
                ) -> Option<Result<Sample<State>, Ended<$body>>> {
                    body.integrate(state).method(method).steps(end).last()
                }

                fn event(
                    body: &$body,
                    state: &State,
                    method: $method,
                    end: f64,
                ) -> Option<Result<Event<State>, Ended<$body>>> {
                    body.integrate(state).method(method).events(end, |time, _| time - 0.5).next()
                }
            }
        })*

        fn link_motions() -> usize {
            [$($name::link()),*].iter().sum()
        }
    };
}

steps! {
    craft: Craft<f64>;
    craft_single: Craft<f32>;
    turning: Turning<f64>;
    turning_single: Turning<f32>;
    rotor: Rotor<f64>;
    wave: Wave<f64>;
    plank: Plank<f64>;
    plank_single: Plank<f32>;
    slider: Slider<f64>;
    stick: Stick<f64>;
    stick_single: Stick<f32>;
    double_pendulum: DoublePendulum<f64>;
    double_pendulum_single: DoublePendulum<f32>;
    assembly: Assembly<f64>;
    assembly_single: Assembly<f32>;
}

motions! {
    midpoint: Craft<f64>, Fixed<Midpoint>;
    classical: Craft<f64>, Fixed<Classical4>;
    tsitouras: Craft<f64>, Fixed<Tsitouras5>;
    dormand_prince: Craft<f64>, Fixed<DormandPrince8>;
    verner: Craft<f64>, Fixed<Verner9>;
    craft_adaptive: Craft<f64>, DormandPrince;
    turning_adaptive: Turning<f64>, DormandPrince;
    rotor_adaptive: Rotor<f64>, DormandPrince;
    wave_adaptive: Wave<f64>, DormandPrince;
    craft_by_verner: Craft<f64>, Verner;
    rotor_by_either: Rotor<f64>, RungeKuttaPair;
    plank_adaptive: Plank<f64>, DormandPrince;
    slider_adaptive: Slider<f64>, DormandPrince;
    stick_adaptive: Stick<f64>, DormandPrince;
    dipole_adaptive: Dipole, DormandPrince;
    bead_projected: Bead, Projected<DormandPrince>;
    bead_in_equal_steps: Bead, Projected<Fixed<Classical4>>;
    tethered_projected: Tethered, Projected<DormandPrince>;
    brick_exact: Brick, ClosedForm;
    top_exact: Top<f64>, ClosedForm;
    pendulum_exact: Pendulum<f64>, ClosedForm;
    needle_exact: Needle, ClosedForm;
    quadrotor_series: Quadrotor, TaylorSeries;
    brick_series: Brick, TaylorSeries;
    gyroscope_series: Gyroscope, TaylorSeries;
    stone_series: Stone, TaylorSeries;
    swing_series: Swing, TaylorSeries;
    double_pendulum_in_equal_steps: DoublePendulum<f64>, Fixed<DormandPrince8>;
    double_pendulum_adaptive: DoublePendulum<f64>, DormandPrince;
    assembly_adaptive: Assembly<f64>, DormandPrince;
    chain_exact: Chain, ClosedForm;
    chain_series: Chain, TaylorSeries;
    geared_projected: Geared, Projected<DormandPrince>;
}

mod others {
    use super::*;

    rigid_system!(Satellite {
        bodies: [
            hub {
                mass: 50[kg],
                inertia: principal(11.6, 11.6, 9),
                points: [end = (0, 0, 0.7)],
                moments: [thrusters = body(0, 0, 0.1[N * m])],
            },
            rotor {
                mass: 3[kg],
                inertia: principal(0.4, 0.4, 0.6)
            },
            rail {
                mass: 1[kg],
                inertia: principal(0.4, 0.4, 0.6)
            },
        ],
        joints: [
            orbit = free(hub),
            spin = revolute(hub.end, rotor.G, body(0, 0, 1)),
            slide = cylindrical(world(0, 0, 0), rail.G, world(0, 0, 1)),
        ],
        outputs: [flow],
    });

    cannot_panic! {
        fn flow_of_a_gyrostat(system: &Satellite, state: &SatelliteState, time: f64) -> SatelliteState {
            system.flow(state, time)
        }

        fn motion_of_a_gyrostat(system: &Satellite, state: &SatelliteState, end: f64) -> Result<SatelliteState, Ended<Satellite>> {
            system.integrate(state).to(end)
        }

        fn flow(body: &Brick, state: &Spatial, time: f64) -> Spatial {
            body.flow(state, time)
        }

        fn flow_of_a_top(body: &Top<f64>, state: &Rotation, time: f64) -> Rotation {
            body.flow(state, time)
        }

        fn flow_of_a_pendulum(body: &Pendulum<f64>, state: &Hinge, time: f64) -> Hinge {
            body.flow(state, time)
        }

        fn flow_of_a_rod(body: &Needle, state: &Rod, time: f64) -> Rod {
            body.flow(state, time)
        }

        fn series(body: &Quadrotor, time: f64, state: &Spatial, step: f64) -> Spatial {
            taylor_step::<_, 13>(body, time, state, &(), step)
        }

        fn series_of_a_top(body: &Gyroscope, time: f64, state: &Rotation, step: f64) -> Rotation {
            taylor_step::<_, 21>(body, time, state, &(), step)
        }

        fn controlled(body: &Plank<f64>, state: &Planar, period: f64, end: f64) -> Result<Planar, Ended<Plank<f64>>> {
            let control = |_: f64, state: &Planar| PlankInput { thrust: -state.velocity.y };
            body.integrate(state).control(period, control).to(end)
        }
    }
}

pub fn link() -> usize {
    link_steps() + link_motions() + others::link()
}
