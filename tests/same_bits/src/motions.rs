//! The final states of bodies, with every method.

use newton_euler::Scalar;
use newton_euler::columns::{Columnar, Columns};
use newton_euler::integrate::{
    ClosedForm, DormandPrince, DormandPrince8, Fixed, Integrate, Method, Projected, RungeKutta,
    TaylorSeries, Verner, cf4, runge_kutta_step, taylor_step,
};
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;

use crate::bits::{Bits, Numbers};
use crate::kinds::*;
use crate::systems::{Assembly, Chain, ChainState, DoublePendulum};

/// A state that is columns, as those of all kinds are.
pub trait Kept:
    Coordinates<Scalar = f64, Acceleration: Columns<f64>> + Columns<f64> + Default
{
}
impl<S> Kept for S where
    S: Coordinates<Scalar = f64, Acceleration: Columns<f64>> + Columns<f64> + Default
{
}

/// The ends, the samples and the steps of some motions.
fn moved<B: Integrate<State: Kept>, M: Method<B>>(bits: &mut Bits, body: &B, method: M) {
    let mut numbers = Numbers(6);
    for end in [0.75, -0.25] {
        let state = numbers.state();
        let motion = || body.integrate(&state).starting_at(0.25).method(method);
        bits.add(&motion().to(end).expect("an end"));
        for sample in motion().samples(end, 0.1) {
            bits.add(&sample.expect("a sample").state);
        }
        for step in motion().steps(end) {
            let step = step.expect("a step");
            bits.all([step.time]);
            bits.add(&step.state);
        }
    }
}

/// Some bodies by a method that is for all of them.
macro_rules! some_kinds {
    ($method:expr) => {{
        let mut bits = Bits::new();
        moved(&mut bits, &Craft::<f64>::default(), $method);
        moved(&mut bits, &Plank::<f64>::default(), $method);
        moved(&mut bits, &Stick::<f64>::default(), $method);
        bits
    }};
}

/// All bodies by such a method.
macro_rules! every_kind {
    ($method:expr) => {{
        let mut bits = Bits::new();
        moved(&mut bits, &Craft::<f64>::default(), $method);
        moved(&mut bits, &Quadrotor::default(), $method);
        moved(&mut bits, &Turning::<f64>::default(), $method);
        moved(&mut bits, &Top::<f64>::default(), $method);
        moved(&mut bits, &Rotor::<f64>::default(), $method);
        moved(&mut bits, &Stone::default(), $method);
        moved(&mut bits, &Plank::<f64>::default(), $method);
        moved(&mut bits, &Slider::<f64>::default(), $method);
        moved(&mut bits, &Pendulum::<f64>::default(), $method);
        moved(&mut bits, &Stick::<f64>::default(), $method);
        moved(&mut bits, &Dipole::default(), $method);
        bits
    }};
}

pub fn fixed<M: RungeKutta>(method: M) -> Bits {
    some_kinds!(Fixed { method, step: 0.04 })
}

pub fn of_order_eight() -> Bits {
    let method = DormandPrince8;
    every_kind!(Fixed { method, step: 0.04 })
}

pub fn adaptive() -> Bits {
    every_kind!(DormandPrince { tolerance: 1e-9 })
}

pub fn of_order_nine() -> Bits {
    some_kinds!(Verner { tolerance: 1e-9 })
}

pub fn projected() -> Bits {
    let mut bits = Bits::new();
    let hanging = Planar {
        angular_velocity: 3.0,
        ..Planar::default()
    };
    let mut start = Planar {
        position: [0.0, -0.5].into(),
        velocity: [1.5, 0.0].into(),
        ..hanging
    };
    let bead = Bead::default();
    bead.project(0.0, &mut start, &()).expect("near by");
    for tolerance in [1e-6, 1e-10] {
        let method = Projected(DormandPrince { tolerance });
        for step in bead.integrate(&start).method(method).steps(2.0) {
            bits.add(&step.expect("a step").state);
        }
    }
    bits
}

/// Systems in equal steps, by tolerance and in closed form, over both scalars.
pub fn systems() -> Bits {
    let mut bits = Bits::new();
    let (pendulum, assembly) = (DoublePendulum::<f64>::default(), Assembly { spin: 0.3 });
    let fixed = Fixed {
        method: DormandPrince8,
        step: 0.04,
    };
    let adaptive = DormandPrince { tolerance: 1e-9 };
    moved(&mut bits, &pendulum, fixed);
    moved(&mut bits, &pendulum, adaptive);
    moved(&mut bits, &assembly, fixed);
    moved(&mut bits, &assembly, adaptive);
    moved(&mut bits, &Chain, fixed);
    steps(&mut bits, &pendulum);
    steps(&mut bits, &DoublePendulum::<f32>::default());
    steps(&mut bits, &Assembly::<f32> { spin: 0.25 });
    bits
}

pub fn series_of_a_system() -> Bits {
    let mut bits = Bits::new();
    let state: ChainState = Numbers(14).state();
    bits.add(&taylor_step::<_, 13>(&Chain, 0.25, &state, &(), 0.125));
    bits
}

/// Events, and inputs by a controller.
pub fn controlled() -> Bits {
    let mut bits = Bits::new();
    let (plank, start) = (
        Plank::<f64>::default(),
        Planar {
            angle: 0.3,
            ..Planar::default()
        },
    );
    let hover = |_: f64, state: &Planar| PlankInput {
        thrust: 60.0 - 30.0 * state.velocity.y,
    };
    let level = |_: f64, state: &Planar| state.angle.sin();
    for event in plank
        .integrate(&start)
        .control(0.05, hover)
        .events(3.0, level)
    {
        let event = event.expect("an event");
        bits.all([event.time]);
        bits.add(&event.state);
    }
    bits
}

pub fn closed_forms() -> Bits {
    let mut bits = Bits::new();
    moved(&mut bits, &Brick::default(), ClosedForm);
    moved(&mut bits, &Top::<f64>::default(), ClosedForm);
    moved(&mut bits, &Pendulum::<f64>::default(), ClosedForm);
    moved(&mut bits, &Needle::default(), ClosedForm);
    moved(&mut bits, &Stage::default(), ClosedForm);
    bits
}

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
        ball {
            mass: 3[kg],
            inertia: principal(0.4, 0.4, 0.4)
        },
        wheel {
            mass: 3[kg],
            inertia: principal(0.4, 0.6, 0.4)
        },
        rail {
            mass: 1[kg],
            inertia: principal(0.4, 0.4, 0.6)
        },
    ],
    joints: [
        orbit = free(hub),
        spin = revolute(hub.end, rotor.G, body(0, 0, 1)),
        flight = free(ball),
        turn = revolute(ball.G, wheel.G, body(0, 1, 0)),
        slide = cylindrical(world(0, 0, 0), rail.G, world(0, 0, 1)),
    ],
    drives: [motor = 0.02[N * m].on(turn)],
    outputs: [flow],
});

pub fn closed_forms_of_systems() -> Bits {
    let mut bits = Bits::new();
    moved(&mut bits, &Satellite::default(), ClosedForm);
    bits
}

/// Some steps over any scalar, on the group and in coordinates.
fn steps<T: Scalar, B: Columnar<T, State: Default>>(bits: &mut Bits, body: &B) {
    let mut numbers = Numbers(8);
    for _ in 0..10 {
        let (state, input) = (numbers.state(), Columns::read(&mut numbers));
        let [start, end] = [0.25_f32, 0.75].map(|time| T::default().constant(time.into(), time));
        bits.add(&cf4(body, &state, &input, start..end, 5));
        bits.add(&runge_kutta_step::<DormandPrince8, B>(
            body, start, &state, &input, end,
        ));
    }
}

pub fn steps_of<T: Scalar>() -> Bits {
    let mut bits = Bits::new();
    steps(&mut bits, &Craft::<T>::default());
    steps(&mut bits, &Turning::<T>::default());
    steps(&mut bits, &Wave::<T>::default());
    steps(&mut bits, &Plank::<T>::default());
    steps(&mut bits, &Slider::<T>::default());
    steps(&mut bits, &Pendulum::<T>::default());
    steps(&mut bits, &Stick::<T>::default());
    bits
}

/// One step along a series, which takes what every processor has.
pub fn series_steps() -> Bits {
    fn of<B: Taylor<State: Kept, Input: Default>>(bits: &mut Bits, body: &B) {
        let state = Numbers(9).state();
        bits.add(&taylor_step::<B, 13>(
            body,
            0.25,
            &state,
            &B::Input::default(),
            0.125,
        ));
        for row in body
            .series::<9>(0.25, &state, &B::Input::default())
            .coefficients()
        {
            bits.all(row.as_ref().iter().copied());
        }
    }
    let mut bits = Bits::new();
    of(&mut bits, &Quadrotor::default());
    of(&mut bits, &Brick::default());
    of(&mut bits, &Gyroscope::default());
    of(&mut bits, &Stone::default());
    of(&mut bits, &Swing::default());
    bits
}

/// Motions along series, which take fused operations where the processor has them.
pub fn series() -> Bits {
    let mut bits = Bits::new();
    for tolerance in [1e-5, 1e-8, 1e-12] {
        let method = TaylorSeries { tolerance };
        moved(&mut bits, &Quadrotor::default(), method);
        moved(&mut bits, &Brick::default(), method);
        moved(&mut bits, &Gyroscope::default(), method);
        moved(&mut bits, &Stone::default(), method);
        moved(&mut bits, &Swing::default(), method);
    }
    bits
}
