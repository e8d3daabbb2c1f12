//! Ways to go on, in steps of equal length.

use newton_euler::integrate::{self, Fixed, Method, Motion, Run, RungeKutta};
use newton_euler::prelude::*;

/// Takes so many steps more, and says where the motion is.
pub type March<'b> = Box<dyn FnMut(u64) -> Rotation + 'b>;

/// A method, with the law by which its errors should grow.
pub struct Way<'b, B> {
    pub name: &'static str,
    /// Of a body of a few radians a second \[s\].
    pub step: f64,
    /// The exponents of [`QUANTITIES`](crate::problem::QUANTITIES).
    pub expected: [f64; 3],
    begin: fn(&'b B, &Rotation, f64) -> March<'b>,
}

impl<'b, B> Way<'b, B> {
    pub fn begin(&self, body: &'b B, start: &Rotation, step: f64) -> March<'b> {
        (self.begin)(body, start, step)
    }
}

/// What rounding alone leaves: a random walk, and what follows from it in the angle.
const ROUNDING: [f64; 3] = [0.5, 0.5, 1.5];
/// What truncation leaves: energy and momentum lost at a rate, so that the angle is off by the square of time.
const DRIFT: [f64; 3] = [1.0, 1.0, 2.0];
/// Energy is kept but for rounding, the direction of the momentum nearly; the pace is not quite right.
const BOUNDED: [f64; 3] = [0.5, 0.0, 1.0];

/// All methods.
pub fn all<'b, B: Taylor<State = Rotation, Input = ()>>() -> Vec<Way<'b, B>> {
    let way = |name, step, expected, begin| Way {
        name,
        step,
        expected,
        begin,
    };
    vec![
        way("Taylor 16", 1.0 / 8.0, ROUNDING, series),
        way("Runge-Kutta 8", 1.0 / 16.0, DRIFT, |body, start, step| {
            steps(body, start, step, integrate::DormandPrince8)
        }),
        way("Runge-Kutta 5", 1.0 / 32.0, DRIFT, |body, start, step| {
            steps(body, start, step, integrate::Tsitouras5)
        }),
        way("Runge-Kutta 4", 1.0 / 64.0, DRIFT, |body, start, step| {
            steps(body, start, step, integrate::Classical4)
        }),
        way("midpoint rule", 1.0 / 64.0, BOUNDED, |body, start, step| {
            steps(body, start, step, integrate::Midpoint)
        }),
    ]
}

fn series<'b, B: Taylor<State = Rotation, Input = ()>>(
    body: &'b B,
    start: &Rotation,
    step: f64,
) -> March<'b> {
    let mut motion = Motion::<B, 17>::new(body, 0.0, start);
    Box::new(move |steps| {
        for _ in 0..steps {
            motion.step(step, &()).expect("finite");
        }
        motion.state()
    })
}

#[expect(clippy::cast_precision_loss, reason = "below 2⁵³")]
fn steps<'b, B, M>(body: &'b B, start: &Rotation, step: f64, method: M) -> March<'b>
where
    B: RigidBody<Scalar = f64, State = Rotation, Input = ()>,
    M: RungeKutta + 'b,
{
    let mut run = Fixed { method, step }.start(body, 0.0, start);
    Box::new(move |steps| {
        let end = run.time() + steps as f64 * step;
        run.seek(body, end, end, &()).expect("finite");
        run.state()
    })
}
