//! The evaluation that is counted, and how it is counted.

use std::hint::black_box;
use std::process::Command;

use newton_euler::prelude::*;

use crate::somewhere::Somewhere;

type Acceleration<B> = <<B as RigidBody>::State as State>::Acceleration;

/// Evaluates a body once, with its default parameters and without input.
pub fn evaluate<B>()
where
    B: RigidBody<Scalar = f64, State: Somewhere> + Default,
{
    let (body, state, input) =
        black_box((B::default(), B::State::somewhere(), B::Input::default()));
    black_box(counted_acceleration(&body, &state, &input));
}

/// What is counted, including the elementary functions that it calls. Callgrind finds it by its
/// name.
#[inline(never)]
fn counted_acceleration<B: RigidBody<Scalar = f64>>(
    body: &B,
    state: &B::State,
    input: &B::Input,
) -> Acceleration<B> {
    body.acceleration(0.0, state, input)
}

/// Runs this program in callgrind, to evaluate one body.
pub fn count(name: &str) -> u32 {
    let program = std::env::current_exe().expect("this program");
    let run = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg("--toggle-collect=*counted_acceleration*")
        .arg(program)
        .arg(name)
        .output()
        .expect("valgrind is to be installed");
    let report = String::from_utf8_lossy(&run.stderr);
    assert!(run.status.success(), "{name}: {report}");
    let collected = report.lines().find_map(|line| {
        let (_, count) = line.split_once("Collected :")?;
        count.trim().parse().ok()
    });
    collected.unwrap_or_else(|| panic!("{name}: nothing was counted: {report}"))
}
