//! Bodies whose mass changes: members are refused where they would be alone.

use newton_euler::ensemble::Ensemble;
use newton_euler::integrate::{DormandPrince, DormandPrince8, Fixed, IntegrationError, Verner};
use newton_euler::lanes::Width;
use newton_euler::prelude::*;

// the mass cancels in the motion of both, so no acceleration shows that it is impossible
rigid_body!(Emptied::<T> {
    motion: translation,
    params: [leak = 0.5[kg / s]],
    mass: 1[kg] - leak * t,
    fields: [weight = mass * world(0, 0, -9.8[m / s ^ 2])],
});
rigid_body!(Breathing::<T> {
    motion: translation,
    params: [least = 0.5],
    mass: 1[kg] * (least + (1[rad / s] * t).cos()),
    fields: [weight = mass * world(0, 0, -9.8[m / s ^ 2])],
});

/// Compares the members of an ensemble with motions alone, to the bit, in every width, with and
/// without a controller.
macro_rules! agree {
    ($kind:ident: $bodies:expr, $method:expr, $times:expr) => {
        let there = Width::ALL.into_iter().filter(|width| width.is_there());
        for (width, period) in there.flat_map(|width| [(width, None), (width, Some(0.37))]) {
            let bodies = $bodies;
            let (start, end) = $times;
            let rest = bodies.iter().map(|_| Translation::default());
            let params = bodies.iter().map(|body| *body.params());
            let mut ensemble = Ensemble::<$kind<f64>>::with_params(params.zip(rest)).unwrap();
            ensemble.set_width(width);
            let motion = ensemble.integrate().method($method).starting_at(start);
            let lost = match period {
                None => motion.each_to(end),
                Some(period) => motion.control(period, |_, _, _| ()).each_to(end),
            };
            let lost = lost.unwrap();
            for (index, body) in bodies.iter().enumerate() {
                let alone = body.integrate(&Translation::default()).method($method);
                let alone = alone.starting_at(start);
                let alone = match period {
                    None => alone.to(end),
                    Some(period) => alone.control(period, |_, _| ()).to(end),
                };
                let error = lost.iter().find(|one| one.index == index);
                let error = error.map(|one| &one.error);
                assert_eq!(alone.as_ref().err(), error, "{index} {width:?} {period:?}");
                let moved = ensemble.states().get(index);
                let last = alone.unwrap_or_else(|error| *error.state());
                assert_eq!(moved, last, "{index} {width:?} {period:?}");
            }
        }
    };
}

fn emptied() -> Vec<Emptied<f64>> {
    let leaks = [0.5, 0.1, 0.2, 0.9, 0.3, 0.0, 0.35, 0.7, 0.01, 1.2, 0.25];
    let bodies = leaks.map(|leak| Emptied::new(EmptiedParams { leak }).unwrap());
    bodies.into()
}

fn breathing() -> Vec<Breathing<f64>> {
    let least = [0.5, 1.1, 2.0, 0.9, 1.001];
    let bodies = least.map(|least| Breathing::new(BreathingParams { least }).unwrap());
    bodies.into()
}

#[test]
fn members_are_refused_as_they_would_be_alone() {
    let fixed = Fixed {
        method: DormandPrince8,
        step: 0.1,
    };
    for times in [(0.0, 3.0), (3.0, 0.0), (0.0, 1.0)] {
        agree!(Emptied: emptied(), Verner { tolerance: 1e-9 }, times);
        agree!(Emptied: emptied(), DormandPrince { tolerance: 1e-6 }, times);
        agree!(Emptied: emptied(), fixed, times);
    }
    agree!(Breathing: breathing(), Verner { tolerance: 1e-9 }, (0.0, 6.25));
    agree!(Breathing: breathing(), fixed, (0.0, 6.25));
    let alone = emptied()[0].integrate(&Translation::default()).to(3.0);
    assert!(matches!(alone, Err(IntegrationError::InvalidBody { .. })));
}
