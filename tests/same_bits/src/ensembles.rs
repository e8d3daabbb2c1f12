//! Many bodies at once, in registers of every width.

use newton_euler::columns::{Columns, Generic};
use newton_euler::ensemble::{Ensemble, Together};
use newton_euler::integrate::{DormandPrince8, Fixed, Integrate, Midpoint};
use newton_euler::lanes::Width;

use crate::bits::{Bits, Numbers};
use crate::kinds::*;
use crate::motions::Kept;
use crate::systems::DoublePendulum;

fn of<B: Generic<State: Kept> + Integrate<Best: Together<B>>>(
    bits: &mut Bits,
    body: &B,
    width: Width,
) {
    let mut numbers = Numbers(10);
    let mut ensemble = Ensemble::new(body, (0..21).map(|_| numbers.state()));
    for index in 0..ensemble.len() {
        ensemble
            .inputs_mut()
            .set(index, &Columns::read(&mut numbers));
    }
    ensemble.set_width(width);
    ensemble
        .accelerations(0.25)
        .iter()
        .for_each(|acceleration| bits.add(&acceleration));
    ensemble.cf4(0.25..0.5, 5);
    let method = Fixed {
        method: DormandPrince8,
        step: 0.06,
    };
    ensemble.integrate().method(method).to(0.5).expect("an end");
    // each by the best method, with steps of its own
    ensemble.integrate().to(0.25).expect("an end");
    ensemble.states().iter().for_each(|state| bits.add(&state));
}

fn by_midpoints<B: Generic<State: Kept> + Integrate<Best: Together<B>>>(
    bits: &mut Bits,
    body: &B,
    width: Width,
) {
    let mut numbers = Numbers(12);
    let mut ensemble = Ensemble::new(body, (0..21).map(|_| numbers.state()));
    ensemble.set_width(width);
    let method = Fixed {
        method: Midpoint,
        step: 0.01,
    };
    ensemble.integrate().method(method).to(0.1).expect("an end");
    ensemble.states().iter().for_each(|state| bits.add(&state));
}

/// Otherwise nothing would be compared there.
#[cfg(target_arch = "aarch64")]
#[test]
fn two_lanes_are_there() {
    assert_eq!(Width::widest(), Width::Two);
}

/// A body by all methods, and others by the simplest, the same in each width that the processor has.
pub fn bodies() -> Vec<(Width, Bits)> {
    in_each_width(|bits, width| {
        of(bits, &Plank::<f64>::default(), width);
        by_midpoints(bits, &Craft::<f64>::default(), width);
        by_midpoints(bits, &DoublePendulum::<f64>::default(), width);
    })
}

/// More bodies by all methods, the same in each width that the processor has.
#[cfg(any(debug_assertions, feature = "whole"))]
pub fn further_bodies() -> Vec<(Width, Bits)> {
    in_each_width(|bits, width| {
        of(bits, &Craft::<f64>::default(), width);
        of(bits, &Turning::<f64>::default(), width);
        of(bits, &Top::<f64>::default(), width);
        of(bits, &Wave::<f64>::default(), width);
        of(bits, &Pendulum::<f64>::default(), width);
        of(bits, &Stick::<f64>::default(), width);
    })
}

/// Systems, the same in each width that the processor has.
#[cfg(any(debug_assertions, feature = "whole"))]
pub fn systems() -> Vec<(Width, Bits)> {
    in_each_width(|bits, width| of(bits, &DoublePendulum::<f64>::default(), width))
}

fn in_each_width(add: impl Fn(&mut Bits, Width)) -> Vec<(Width, Bits)> {
    let there = Width::ALL.into_iter().filter(|width| width.is_there());
    let each = there.map(|width| {
        let mut bits = Bits::new();
        add(&mut bits, width);
        (width, bits)
    });
    each.collect()
}
