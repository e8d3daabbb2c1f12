//! The problems, each with the methods that are for it.

use nalgebra::Vector3;
use newton_euler::prelude::*;

use crate::by_hand::{self, Free, Load, Turning, Weight};
use crate::distance::Distance;
use crate::measure::{Care, Curve, measure};
use crate::method::Method;
use crate::problem::{Problem, flying, swinging, turning};
use crate::{bodies, ours, peers};

/// All of them, measured.
pub fn all(care: Care) -> Vec<Curve> {
    let curves = [
        closed(
            care,
            "symmetric_free",
            bodies::SymmetricFree::default(),
            [2.0, 2.0, 1.0],
            Free,
        ),
        closed(
            care,
            "asymmetric_free",
            bodies::AsymmetricFree::default(),
            [0.6, 0.8, 1.0],
            Free,
        ),
        closed(
            care,
            "dzhanibekov",
            bodies::Dzhanibekov::default(),
            [1.0, 2.0, 3.0],
            Free,
        ),
        closed(
            care,
            "lagrange_nutation",
            bodies::LagrangeTop::default(),
            [1.0, 1.0, 0.5],
            Weight(Vector3::z() * 5.0),
        ),
        heavy(
            care,
            "heavy_asym",
            bodies::HeavyTop::default(),
            [0.6, 0.8, 1.0],
            1.0,
        ),
        pendulum(care),
        heavy(
            care,
            "pendulum_planar",
            bodies::PendulumInSpace::default(),
            [0.3, 0.5, 0.4],
            -4.0,
        ),
        flight(
            care,
            "quadrotor",
            bodies::Quadrotor::default(),
            by_hand::Quadrotor,
        ),
        flight(
            care,
            "satellite",
            bodies::Satellite::default(),
            by_hand::Satellite,
        ),
    ];
    curves.into_iter().flatten().collect()
}

/// A body that turns, also in closed form.
fn closed<B, L>(care: Care, name: &'static str, body: B, moments: [f64; 3], load: L) -> Vec<Curve>
where
    B: Flow + Taylor<State = Rotation, Input = ()> + Integrate,
    L: Load,
{
    let problem = turning(name, body);
    let by_hand = by_hand_of(&problem, moments, load);
    let methods = [
        vec![ours::flow(&problem)],
        ours::smooth(&problem),
        peers::general::<7, _, _, _>(&problem, &by_hand),
        peers::turning(&by_hand),
    ];
    measured(care, &problem, methods)
}

/// A top, its weight times the distance from its support given \[N m\].
fn heavy<B>(care: Care, name: &'static str, body: B, moments: [f64; 3], weight: f64) -> Vec<Curve>
where
    B: Taylor<State = Rotation, Input = ()> + Integrate,
{
    let problem = turning(name, body);
    let by_hand = by_hand_of(&problem, moments, Weight(Vector3::z() * weight));
    let methods = [
        ours::smooth(&problem),
        peers::general::<7, _, _, _>(&problem, &by_hand),
        peers::turning(&by_hand),
    ];
    measured(care, &problem, methods)
}

fn by_hand_of<B: RigidBody<Scalar = f64, State = Rotation, Input = ()>, L: Load>(
    problem: &Problem<B>,
    moments: [f64; 3],
    load: L,
) -> Problem<Turning<L>> {
    problem.of(Turning {
        moments: moments.into(),
        load,
    })
}

fn pendulum(care: Care) -> Vec<Curve> {
    let problem = swinging("pendulum", bodies::Pendulum::default());
    let by_hand = problem.of(by_hand::Pendulum);
    let methods = [
        vec![ours::flow(&problem)],
        ours::smooth(&problem),
        peers::general::<2, _, _, _>(&problem, &by_hand),
    ];
    measured(care, &problem, methods)
}

fn flight<B, C>(care: Care, name: &'static str, body: B, by_hand: C) -> Vec<Curve>
where
    B: Taylor<State = Spatial, Input = ()> + Integrate,
    C: RigidBody<Scalar = f64, State = Spatial, Input = ()>,
{
    let problem = flying(name, body);
    let by_hand = problem.of(by_hand);
    let methods = [
        ours::smooth(&problem),
        peers::general::<13, _, _, _>(&problem, &by_hand),
    ];
    measured(care, &problem, methods)
}

/// All methods on a problem.
pub fn measured<'p, B, const N: usize>(
    care: Care,
    problem: &'p Problem<B>,
    methods: [Vec<Method<'p, B::State>>; N],
) -> Vec<Curve>
where
    B: RigidBody<State: Distance>,
{
    let methods: Vec<_> = methods.into_iter().flatten().collect();
    measure(care, problem.name, problem.seconds, &problem.end, &methods)
}
