//! Many bodies at once: tops of an ensemble, each with a turn of its own, in one thread.

use std::hint::black_box;

use nalgebra::Vector3;
use newton_euler::ensemble::Ensemble;
use newton_euler::integrate::{
    self, Classical4, DormandPrince, DormandPrince8, Fixed, Tsitouras5, Verner, Verner9,
};
use newton_euler::prelude::*;

use crate::bodies::{self, many};
use crate::measure::{Care, Curve, measure};
use crate::method::Method;
use crate::problem::{Problem, turning};

/// The methods that ensembles have. The traits of members are not to be named, so this is no function.
macro_rules! methods {
    ($ensemble:expr, $seconds:expr) => {
        [
            Method::adaptive(
                format!("best for each, {}", $ensemble.len()),
                |tolerance| {
                    let mut moved = black_box(&$ensemble).clone();
                    let motion = moved.integrate().tolerance(tolerance);
                    motion.to($seconds).ok()?;
                    Some(moved.states().iter().collect())
                },
            ),
            methods!(@adaptive $ensemble, $seconds, "DOP853", DormandPrince),
            methods!(@adaptive $ensemble, $seconds, "Verner 9(8)", Verner),
            methods!(@steps $ensemble, $seconds, "Runge-Kutta 9", Verner9),
            methods!(@steps $ensemble, $seconds, "Runge-Kutta 8", DormandPrince8),
            methods!(@steps $ensemble, $seconds, "Runge-Kutta 5", Tsitouras5),
            methods!(@steps $ensemble, $seconds, "Runge-Kutta 4", Classical4),
        ]
    };
    (@adaptive $ensemble:expr, $seconds:expr, $name:literal, $method:ident) => {
        Method::adaptive(format!("{}, {} at once", $name, $ensemble.len()), |tolerance| {
            let mut moved = black_box(&$ensemble).clone();
            let motion = moved.integrate().method($method { tolerance });
            motion.to($seconds).ok()?;
            Some(moved.states().iter().collect())
        })
    };
    (@steps $ensemble:expr, $seconds:expr, $name:literal, $method:expr) => {
        Method::fixed(format!("{}, {} at once", $name, $ensemble.len()), |steps| {
            let mut moved = black_box(&$ensemble).clone();
            let (method, step) = ($method, $seconds / f64::from(steps));
            // what is not finite stays where it was, and counts as not arrived
            let _ = moved.integrate().method(Fixed { method, step }).to($seconds);
            moved.states().iter().collect()
        })
    };
}

/// The tops of both kinds, so many of them.
pub fn tops(care: Care, count: u32) -> Vec<Curve> {
    let problem = turning("lagrange_nutation", bodies::LagrangeTop::default());
    let (starts, ends) = members(&problem, count);
    let ensemble = Ensemble::new(&many::LagrangeTop::default(), starts);
    let methods = methods!(ensemble, problem.seconds);
    let mut curves = measured(care, &problem, &ends, &methods);

    let problem = turning("heavy_asym", bodies::HeavyTop::default());
    let (starts, ends) = members(&problem, count);
    let ensemble = Ensemble::new(&many::HeavyTop::default(), starts);
    let methods = methods!(ensemble, problem.seconds);
    curves.extend(measured(care, &problem, &ends, &methods));
    curves
}

/// Starts and ends: the k-th of n begins with an angular velocity that is greater by k/64n, so that the first is the
/// problem itself. Where the others end is known by [`integrate::taylor`] with a tolerance of rounding; what that leaves on the
/// first is in the table.
fn members<B>(problem: &Problem<B>, count: u32) -> (Vec<Rotation>, Vec<Rotation>)
where
    B: Taylor<State = Rotation, Input = ()>,
{
    let start = |k: u32| {
        let faster: Vector3<f64> =
            problem.start.angular_velocity * (1.0 + f64::from(k) / f64::from(count) / 64.0);
        Rotation {
            angular_velocity: faster,
            ..problem.start
        }
    };
    let end = |start: &Rotation| {
        integrate::taylor(&problem.body, start, &(), 0.0..problem.seconds, 1e-15)
            .expect("a regular motion")
    };
    let starts: Vec<Rotation> = (0..count).map(start).collect();
    let ends = starts.iter().map(end).collect();
    (starts, ends)
}

fn measured<B: RigidBody>(
    care: Care,
    problem: &Problem<B>,
    ends: &Vec<Rotation>,
    methods: &[Method<'_, Vec<Rotation>>],
) -> Vec<Curve> {
    let count = u32::try_from(ends.len()).expect("a count");
    let name = format!("{}, ensembles", problem.name);
    measure(
        care,
        &name,
        problem.seconds * f64::from(count),
        ends,
        methods,
    )
}
