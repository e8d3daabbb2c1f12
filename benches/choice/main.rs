//! The time of series divided by that of the faster Runge–Kutta pair, and which of the two is the
//! default.
//!
//! For each, the shortest time of many runs is taken, at equal tolerances. A star marks series that
//! are the default. Run `cargo bench --bench choice`.

mod bodies;
#[path = "../../examples/work_precision/systems/described.rs"]
#[allow(dead_code, reason = "the arm has no series")]
mod described;
#[path = "../../examples/work_precision/problem.rs"]
#[allow(dead_code, reason = "nothing is compared with other bodies")]
mod problem;
#[path = "../../examples/work_precision/bodies.rs"]
#[allow(dead_code, reason = "generic bodies are for ensembles")]
mod problems;
#[path = "../../tests/reference/mod.rs"]
mod reference;
#[path = "../../examples/work_precision/systems/starts.rs"]
mod starts;

use std::any::type_name;
use std::hint::black_box;
use std::time::Instant;

use nalgebra::UnitQuaternion;
use newton_euler::integrate::{DormandPrince, Method, TaylorSeries, Tolerant, Verner};
use newton_euler::prelude::*;

use problem::{flying, swinging, turning};
use reference::{number, system};

const TOLERANCES: [f64; 6] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13];
const RUNS: usize = 200;

fn main() {
    println!(
        "{:24}{}",
        "",
        TOLERANCES.map(|one| format!("{one:>8.0e}")).concat()
    );
    of_the_diagram();
    of_systems();
    of_none();
}

fn of_the_diagram() {
    macro_rules! rows {
        ($($from:ident $name:literal $body:ident,)*) => {
            $({
                let problem = $from($name, problems::$body::default());
                row($name, &problem.body, &problem.start, problem.seconds);
            })*
        };
    }
    rows! {
        turning "symmetric_free" SymmetricFree,
        turning "asymmetric_free" AsymmetricFree,
        turning "dzhanibekov" Dzhanibekov,
        turning "lagrange_nutation" LagrangeTop,
        turning "heavy_asym" HeavyTop,
        swinging "pendulum" Pendulum,
        turning "pendulum_planar" PendulumInSpace,
        flying "quadrotor" Quadrotor,
        flying "satellite" Satellite,
    }
}

fn of_systems() {
    let file = system("double_pendulum");
    let start = starts::swinging(&file);
    let seconds = number(&file["trajectory"]["T"]);
    row(
        "double_pendulum",
        &described::DoublePendulum::default(),
        &start,
        seconds,
    );
    let file = system("satellite3w");
    let start = starts::flying(&file);
    let seconds = number(&file["trajectory"]["T"]);
    row(
        "satellite_wheels",
        &described::Wheels::default(),
        &start,
        seconds,
    );
}

fn of_none() {
    let attitude = UnitQuaternion::from_euler_angles(0.1, 0.2, 0.3);
    let spatial = |velocity: [f64; 3], spin: [f64; 3]| Spatial {
        attitude,
        velocity: velocity.into(),
        angular_velocity: spin.into(),
        ..Spatial::default()
    };
    let shot = spatial([300.0, 0.0, 300.0], [0.5, 0.2, 60.0]);
    row("shell", &bodies::Shell::default(), &shot, 10.0);
    let pushed = spatial([1.0, 0.0, 0.5], [0.5, 2.0, 1.0]);
    row("hammock", &bodies::Hammock::default(), &pushed, 10.0);
    row("hung", &bodies::Hung::default(), &pushed, 10.0);
    let thrown = spatial([20.0, 0.0, 0.5], [0.0, 0.2, 0.1]);
    row("glider", &bodies::Glider::default(), &thrown, 10.0);
    let drifting = Planar {
        velocity: [1.0, 2.0].into(),
        angular_velocity: 0.5,
        ..Planar::default()
    };
    row(
        "hovercraft",
        &bodies::Hovercraft::default(),
        &drifting,
        20.0,
    );
    let above = Translation {
        position: [7e6, 0.0, 0.0].into(),
        velocity: [0.0, 8500.0, 1000.0].into(),
    };
    row("orbit", &bodies::Orbit::default(), &above, 6000.0);
    let turning = Rotation {
        attitude,
        angular_velocity: [0.5, 1.0, 0.7].into(),
    };
    row("shaken", &bodies::Shaken::default(), &turning, 10.0);
    row("damped", &bodies::Damped::default(), &turning, 10.0);
}

/// The ratios of a body.
fn row<B: Taylor<Input = ()> + Integrate>(name: &str, body: &B, start: &B::State, seconds: f64) {
    let coarsest = coarsest_with_series(type_name::<B::Best>());
    let ratios = TOLERANCES.map(|tolerance| {
        let motion = (body, start, seconds);
        let series = shortest(motion, TaylorSeries { tolerance });
        let pairs = [
            shortest(motion, DormandPrince { tolerance }),
            shortest(motion, Verner { tolerance }),
        ];
        let ratio = series / pairs[0].min(pairs[1]);
        let is_default = tolerance <= coarsest;
        format!("{ratio:>7.2}{}", if is_default { '*' } else { ' ' })
    });
    println!("{name:24}{}", ratios.concat());
}

/// The largest tolerance for which a default method takes series, by its name.
fn coarsest_with_series(method: &str) -> f64 {
    let exponent = method.split_once("SeriesBelow<");
    let exponent = exponent.and_then(|(_, rest)| rest.strip_suffix('>')?.parse().ok());
    match exponent {
        Some(exponent) => 0.1_f64.powi(exponent) * 1.01,
        None if method == type_name::<TaylorSeries>() => f64::INFINITY,
        None => 0.0,
    }
}

/// The shortest time of a motion \[s\].
fn shortest<B, M>((body, start, seconds): (&B, &B::State, f64), method: M) -> f64
where
    B: Integrate<Input = ()>,
    M: Method<B> + Tolerant + Copy,
{
    let runs = (0..RUNS).map(|_| {
        let begun = Instant::now();
        let end = body.integrate(black_box(start)).method(method).to(seconds);
        black_box(end.is_ok());
        begun.elapsed().as_secs_f64()
    });
    runs.fold(f64::INFINITY, f64::min)
}
