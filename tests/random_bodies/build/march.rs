//! The function that moves a body with every method that it has: from lists of numbers to its own
//! types, and back.

use crate::answer::constructed;
use crate::description::moving::Moving;
use crate::description::written::described;

/// A module with the body and `pub fn march(..)`.
pub fn module(moving: &Moving, index: usize) -> String {
    let Moving { body, has_flow } = moving;
    let outputs: &[&str] = if *has_flow {
        &["taylor", "flow"]
    } else {
        &["taylor"]
    };
    let description = described(body, outputs);
    let (make, input) = constructed(body, "return");
    let closed = if *has_flow {
        "ends.tell(\"closed form\", motion().method(ClosedForm).steps(end));"
    } else {
        ""
    };
    format!(
        "pub mod moving_{index} {{
use super::*;
newton_euler::rigid_body!({description});
pub fn march(given: &Given, end: f64, ends: &mut Ends) {{
{make}
{input}
let start = state(given);
let motion = || body.integrate(&start).starting_at(given.time).input(input);
let end = given.time + end;
ends.tell(\"DOP853\", motion().method(DormandPrince::with_tolerance(1e-12)).steps(end));
ends.tell(\"DOP853, coarser\", motion().method(DormandPrince::with_tolerance(1e-9)).steps(end));
ends.tell(\"series\", motion().method(TaylorSeries::with_tolerance(1e-12)).steps(end));
{closed}
}}
}}
"
    )
}
