//! Motions that are stiff, steep, tiny or noisy, and continue; motions that are steeper than the
//! tolerance; and what to write instead of a law that jumps.

use newton_euler::integrate::{Control, DormandPrince, Integration, Method, TaylorSeries};
use newton_euler::prelude::*;

use crate::{IS_FAST, ends, pushed, sliding, speed};

rigid_body!(Stiff {
    doc: "A point that follows another, which moves, at once; and friction that is smooth, but steep.",
    motion: planar_translation,
    mass: 1[kg],
    params: [damping = 1[N * s / m], friction = 0[N], width = 1[m / s]],
    locals: [slip = velocity - world((t / 1[s]).cos() * 1[m / s], 0)],
    forces: [
        follows = -damping * slip,
        rubs = -friction * velocity / (velocity.dot(velocity) + width.powi(2)).sqrt(),
    ],
    outputs: [taylor],
});

/// So many steps on the way to an end that is ever so far: the last state.
fn goes_on<M: Method<Stiff>, C>(motion: Integration<'_, Stiff, M, C>, steps: usize) -> f64
where
    C: Control<PlanarTranslation, ()>,
{
    let some = motion.steps(1e9).take(steps);
    let last = some.map(|step| step.expect("no end")).last();
    let (time, state) = last.map(|step| (step.time, step.state)).expect("a step");
    (state.velocity.x - time.cos()).abs()
}

/// Hundreds of thousands of steps, stiff and steep, and thousands of millions ahead.
#[test]
#[cfg_attr(debug_assertions, ignore = "of a release")]
fn what_is_stiff_goes_on() {
    let stiff = |damping: f64, friction: f64, width: f64| {
        let params = StiffParams {
            damping,
            friction,
            width,
        };
        Stiff::new(params).expect("a body")
    };
    let start = sliding([1.0, 0.0]);
    for damping in [1e3, 1e6, 1e9] {
        let follows = stiff(damping, 0.0, 1.0);
        for tolerance in [1e-3, 1e-6, 1e-9, 1e-12] {
            let limit = 100.0 * (tolerance + 1.0 / damping);
            let motion = follows.integrate(&start);
            let off = goes_on(motion.tolerance(tolerance), 140_000);
            assert!(off < limit, "{damping:e}, {tolerance:e}: {off:e}");
            let motion = follows.integrate(&start);
            let off = goes_on(motion.method(DormandPrince { tolerance }), 530_000);
            assert!(off < limit, "{damping:e}, {tolerance:e}: {off:e}");
        }
    }
    for (width, tolerance) in [(1e-3, 1e-9), (1e-5, 1e-6), (1e-6, 1e-6), (1e-6, 1e-9)] {
        let rubs = stiff(0.0, 2.0, width);
        let steep = rubs.integrate(&start);
        goes_on(steep.tolerance(tolerance), 140_000);
        let steep = rubs.integrate(&start);
        goes_on(steep.method(DormandPrince { tolerance }), 530_000);
    }
}

/// Steep only below the tolerance is a jump.
#[test]
#[cfg_attr(debug_assertions, ignore = "of a release")]
fn steeper_than_the_tolerance() {
    let rubs = Stiff::new(StiffParams {
        damping: 0.0,
        friction: 2.0,
        width: 1e-15,
    });
    let (rubs, start) = (rubs.expect("a body"), sliding([0.8, 0.3]));
    let method = DormandPrince { tolerance: 1e-9 };
    let end = rubs.integrate(&start).method(method).to(2.0);
    ends(end, 0.5 * start.velocity.norm(), speed, "steep");
}

/// What documents say to do instead: end by an event, or a law that is smooth at rest.
#[test]
fn what_to_do_instead() {
    let (body, start) = (pushed(0.0), sliding([0.8, 0.3]));
    let (tolerance, rest) = (1e-9, 0.5 * start.velocity.norm());
    let method = DormandPrince { tolerance };
    let slow = |_: f64, state: &PlanarTranslation| state.velocity.norm() - 1e-6;
    let [one, other] = [
        body.integrate(&start)
            .method(method)
            .events(2.0, slow)
            .next(),
        body.integrate(&start)
            .tolerance(tolerance)
            .events(2.0, slow)
            .next(),
    ];
    for event in [one, other] {
        let event = event.expect("an event").expect("it comes before rest");
        let off = event.time - (rest - 0.5e-6);
        assert!(off.abs() < 30.0 * tolerance, "{event:?}");
    }

    let width = 1e-4;
    let rubs = Stiff::new(StiffParams {
        damping: 0.0,
        friction: 2.0,
        width,
    });
    let rubs = rubs.expect("a body");
    let [one, other] = [
        rubs.integrate(&start).method(method).to(2.0),
        rubs.integrate(&start).tolerance(tolerance).to(2.0),
    ];
    // v dv = -2 v / sqrt(v^2 + w^2) dx
    let fast = start.velocity.norm();
    let way = 0.25 * (fast * fast.hypot(width) + width.powi(2) * (fast / width).asinh());
    let there = start.velocity * (way / fast);
    for end in [one, other] {
        let end = end.expect("an end");
        let off = (end.position - there).norm() + end.velocity.norm();
        assert!(off < 30.0 * tolerance, "{off:e}, {end:?}");
    }
}

rigid_body!(Noisy {
    doc: "A load that is noise, but in time.",
    motion: planar_translation,
    mass: 1[kg],
    params: [tick = 1[ms]],
    forces: [jerks = world((t / tick).powi(2).sin() * 1[N], 0)],
});

rigid_body!(Tiny {
    doc: "Nanometers, much below the tolerance.",
    motion: planar_translation,
    mass: 1[kg],
    forces: [spring = -1e12[N / m] * position],
    outputs: [taylor],
});

#[test]
fn what_is_noise_or_tiny_goes_on() {
    let method = DormandPrince { tolerance: 1e-9 };
    let rest = PlanarTranslation::default();
    for tick in [1e-3, 1e-13] {
        let noisy = Noisy::new(NoisyParams { tick }).expect("a body");
        let motion = noisy.integrate(&rest).method(method).steps(1e6);
        let some = motion.take(if IS_FAST { 530_000 } else { 10_000 });
        assert!(some.map(|step| step.expect("no end")).last().is_some());
    }
    let start = PlanarTranslation {
        position: [1e-9, 0.0].into(),
        ..rest
    };
    for tolerance in [1e-6, 1e-9] {
        let tiny = Tiny::default();
        let motion = tiny.integrate(&start).method(TaylorSeries { tolerance });
        let some = motion
            .steps(1e6)
            .take(if IS_FAST { 140_000 } else { 10_000 });
        assert!(some.map(|step| step.expect("no end")).last().is_some());
    }
}
