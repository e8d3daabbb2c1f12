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

fn by_midpoints(bits: &mut Bits, width: Width) {
    let body = Craft::<f64>::default();
    let mut numbers = Numbers(12);
    let mut ensemble = Ensemble::new(&body, (0..21).map(|_| numbers.state()));
    ensemble.set_width(width);
    let method = Fixed {
        method: Midpoint,
        step: 0.01,
    };
    ensemble.integrate().method(method).to(0.1).expect("an end");
    ensemble.states().iter().for_each(|state| bits.add(&state));
}

/// The same in each width that the processor has.
pub fn all() -> Vec<(Width, Bits)> {
    let there = Width::ALL.into_iter().filter(|width| width.is_there());
    let each = there.map(|width| {
        let mut bits = Bits::new();
        of(&mut bits, &Craft::<f64>::default(), width);
        by_midpoints(&mut bits, width);
        of(&mut bits, &Turning::<f64>::default(), width);
        of(&mut bits, &Top::<f64>::default(), width);
        of(&mut bits, &Wave::<f64>::default(), width);
        of(&mut bits, &Plank::<f64>::default(), width);
        of(&mut bits, &Pendulum::<f64>::default(), width);
        of(&mut bits, &Stick::<f64>::default(), width);
        (width, bits)
    });
    each.collect()
}

/// Systems, the same in each width that the processor has.
pub fn systems() -> Vec<(Width, Bits)> {
    let there = Width::ALL.into_iter().filter(|width| width.is_there());
    let each = there.map(|width| {
        let mut bits = Bits::new();
        of(&mut bits, &DoublePendulum::<f64>::default(), width);
        (width, bits)
    });
    each.collect()
}
