//! Why no steady motion was found, and what to do.

use nalgebra::Vector3;

use super::conditions::Conditions;
use super::error::{FEW, Off, Quantity, TrimError};
use super::newton::{End, Newton, TURN};
use super::point::{Here, TOLERANCE, few};
use crate::bodies::linearization::coordinated::Coordinated;
use crate::bodies::linearization::matrices::Linearized;
use crate::bodies::linearization::tangent;

/// Why the steps ended, and what to do: free some inputs if that helps; otherwise let states change;
/// otherwise start elsewhere if free quantities have no effect here, or an acceleration no value;
/// otherwise what helps to first order. The residual of the start is used where that of the end is
/// not one.
pub fn lacking<B: Coordinated<N, M>, C, const N: usize, const M: usize>(
    newton: &mut Newton<'_, B, C, N, M>,
    start: [Option<Off>; FEW],
    end: &End<B, N, M>,
) -> TrimError
where
    C: Conditions<B::State, B::Input>,
{
    let here = &end.here;
    let residual = if end.singular.is_some() {
        start
    } else {
        here.residual()
    };
    let (idle, missing) = (idle(newton, here), missing(newton, here));
    let given = newton.free.input;
    newton.free.input.fill(1.0);
    let there = newton.end(newton.start());
    if there.is_steady() {
        let effects = there.here.effects();
        let inputs = <B::Linearization as Linearized<N, M>>::INPUTS;
        let changes = (0..M).map(|i| {
            let change = (there.here.input[i] - newton.input[i]).abs() * (1.0 - given[i]);
            (inputs[i], change * effects.input[i])
        });
        let held = few(changes);
        return TrimError::Unbalanced { residual, held };
    }
    if let Some(states) = drifting(newton) {
        return TrimError::Drifting { residual, states };
    }
    if let Some((name, column)) = end.singular {
        let free = quantity(here, column);
        return TrimError::Singular { name, free };
    }
    if idle[0].is_some() {
        let free = idle;
        return TrimError::NoEffect { residual, free };
    }
    missing
}

/// The names of the state and of the input.
fn names<L: Linearized<N, M>, const N: usize, const M: usize>() -> impl Iterator<Item = &'static str>
{
    L::STATES.into_iter().chain(L::INPUTS)
}

/// The name of a quantity, and its value.
fn quantity<B: Coordinated<N, M>, const N: usize, const M: usize>(
    here: &Here<B, N, M>,
    column: usize,
) -> Quantity {
    let name = names::<B::Linearization, N, M>().nth(column);
    let values = tangent::values::<_, N>(&here.state, &Vector3::zeros());
    let value = values.iter().chain(&here.input).nth(column);
    Quantity {
        name: name.unwrap_or_default(),
        value: value.copied().unwrap_or_default(),
    }
}

/// Free quantities on which nothing depends here to first order, although equations that are off
/// depend on them elsewhere.
fn idle<B: Coordinated<N, M>, C, const N: usize, const M: usize>(
    newton: &Newton<'_, B, C, N, M>,
    here: &Here<B, N, M>,
) -> [Option<Quantity>; 2] {
    let state = &<B::Linearization as Linearized<N, M>>::A_PATTERN;
    let input = &<B::Linearization as Linearized<N, M>>::B_PATTERN;
    let is_idle = |column: usize| {
        let has_slope =
            |row: usize| state[row].iter().chain(&input[row]).nth(column) == Some(&true);
        let rows = here.off().filter(|(_, off)| *off > TOLERANCE);
        let mut rows = rows.filter_map(|(row, _)| row.row);
        let slopes = here.about.rows.list().iter();
        let mut slopes = slopes.filter_map(|row| row.equation.by.iter().nth(column));
        rows.any(has_slope) && slopes.all(|slope| slope == 0.0)
    };
    let free = newton.free.iter().enumerate();
    let free = free.filter(|(column, free)| *free > 0.0 && is_idle(*column));
    let mut idle = free.map(|(column, _)| quantity(here, column));
    [idle.next(), idle.next()]
}

/// What the free quantities lack, to first order.
fn missing<B: Coordinated<N, M>, C, const N: usize, const M: usize>(
    newton: &Newton<'_, B, C, N, M>,
    here: &Here<B, N, M>,
) -> TrimError {
    let residual = here.residual();
    let least = here.least(&newton.free);
    // a solution that needs large rotations is not found
    let mut free = newton.free;
    for (place, kind) in B::PLACES.iter().enumerate() {
        if kind.is_angle() && least.change.state[place].abs() > 10.0 * TURN {
            free.state[place] = 0.0;
        }
    }
    let least = here.least(&free);
    if least.left < 0.1 * here.merit(&here.scales) {
        return TrimError::NotConverged { residual };
    }
    let is_held = newton.free.iter().map(|free| free == 0.0);
    let helps = least.helps.iter().zip(is_held);
    let helps = helps.map(|(help, is_held)| if is_held { help } else { 0.0 });
    let held = few(names::<B::Linearization, N, M>().zip(helps));
    TrimError::Unbalanced { residual, held }
}

/// The user-defined states without whose equations the motion is steady; all of these are needed.
/// Those that are held come first: nothing but their equations was asked of the free ones.
fn drifting<B: Coordinated<N, M>, C, const N: usize, const M: usize>(
    newton: &mut Newton<'_, B, C, N, M>,
) -> Option<[Option<&'static str>; FEW]>
where
    C: Conditions<B::State, B::Input>,
{
    let (free, changing) = (newton.free.state, newton.steady.changing);
    let own = |is_free: bool| {
        let rows = 2 * B::PLACES.len()..N;
        rows.filter(move |row| !changing[*row] && (free[*row] > 0.0) == is_free)
    };
    let own = own(true).chain(own(false));
    for row in own.clone() {
        newton.steady.changing[row] = true;
    }
    if !newton.is_solved() {
        return None;
    }
    let needed = own.filter(|row| {
        newton.steady.changing[*row] = false;
        newton.steady.changing[*row] = !newton.is_solved();
        newton.steady.changing[*row]
    });
    let states = <B::Linearization as Linearized<N, M>>::STATES;
    Some(few(needed.map(|row| (states[row], 1.0))))
}
