//! What the midpoint rule conserves over a hundred thousand frames, in steps that are not small.

use newton_euler::integrate::{
    Classical4, DormandPrince8, Fixed, IntegrationError, Midpoint, RungeKutta,
};
use newton_euler::prelude::*;

use crate::scenes::{Collapse, FreeBody, HeavyTop, ends};

const FRAME: f64 = 1.0 / 30.0;

#[test]
fn energy_and_angular_momentum_of_a_free_body() {
    let (body, [start, _]) = (FreeBody::default(), ends("asymmetric_free"));
    let end = body
        .integrate(&start)
        .method(Fixed {
            method: Midpoint,
            step: FRAME,
        })
        .to(1e5 * FRAME)
        .unwrap();
    let size = |state| body.angular_momentum(state).norm();
    let energy = body.kinetic_energy(&end) / body.kinetic_energy(&start) - 1.0;
    let momentum = size(&end) / size(&start) - 1.0;
    assert!(
        energy.abs() < 1e-15 && momentum.abs() < 1e-15,
        "{energy:e} {momentum:e}"
    );
    assert!((end.attitude.norm() - 1.0).abs() < 1e-15);
}

/// Of a quaternion, the height of a point of the body is a quadratic function.
#[test]
fn energy_of_a_heavy_top() {
    let (top, [start, _]) = (HeavyTop::default(), ends("heavy_asym"));
    let energy = |state: &Rotation| {
        let w = state.angular_velocity;
        let kinetic = 0.5 * (0.6 * w.x * w.x + 0.8 * w.y * w.y + w.z * w.z);
        kinetic + (state.attitude * nalgebra::Vector3::z()).z
    };
    let method = Fixed {
        method: Midpoint,
        step: FRAME,
    };
    let end = top
        .integrate(&start)
        .method(method)
        .to(1e5 * FRAME)
        .unwrap();
    let change = energy(&end) / energy(&start) - 1.0;
    assert!(change.abs() < 1e-15, "{change:e}");

    let coarse = Fixed {
        method: Classical4,
        step: 0.2,
    };
    let end = top
        .integrate(&start)
        .method(coarse)
        .to(1e5 * FRAME)
        .unwrap();
    assert!((energy(&end) / energy(&start) - 1.0).abs() > 0.01);
}

/// Of a planet, it is not: the error of the energy is bounded by that of the first rounds, over thousands of them.
#[test]
fn energy_of_a_planet_is_bounded() {
    let start = Translation {
        position: [1.0, 0.0, 0.0].into(),
        velocity: [0.0, 1.1, 0.1].into(),
    };
    let energy =
        |state: &Translation| 0.5 * state.velocity.norm_squared() - 1.0 / state.position.norm();
    let planet = Collapse::default();
    let worst = |from: f64, to: f64| {
        let method = Fixed {
            method: Midpoint,
            step: 0.05,
        };
        let samples = planet.integrate(&start).method(method).samples(to, 0.35);
        let late = samples
            .map(Result::unwrap)
            .filter(|sample| sample.time >= from);
        late.map(|sample| (energy(&sample.state) - energy(&start)).abs())
            .fold(0.0, f64::max)
    };
    let (early, late) = (worst(0.0, 50.0), worst(19_000.0, 20_000.0));
    assert!(1e-6 < early && early < 1e-3, "{early:e}");
    assert!(late < 1.01 * early, "{early:e} {late:e}");
}

/// Where the search for the midpoint does not come to rest, the motion ends with an error that says so; what is no number is another.
#[test]
fn too_long_a_step() {
    let [start, _] = ends("heavy_asym");
    let top = HeavyTop::default();
    for (speed, step) in [(1e3, 0.5), (1.0, 20.0), (1e6, 1e-4), (1e-3, 1e4)] {
        let fast = Rotation {
            angular_velocity: start.angular_velocity * speed,
            ..start
        };
        let method = Fixed {
            method: Midpoint,
            step,
        };
        let ended = top.integrate(&fast).method(method).to(100.0 * step);
        let Err(IntegrationError::StepTooLong { step: taken, .. }) = ended else {
            panic!("{speed} {step}: {ended:?}");
        };
        assert_eq!(taken, step);
        let text = ended.unwrap_err().to_string();
        assert!(
            text.contains("too long") && text.contains("shorter"),
            "{text}"
        );
    }
    let nowhere = Rotation {
        angular_velocity: start.angular_velocity * f64::NAN,
        ..start
    };
    let method = Fixed {
        method: Midpoint,
        step: 0.1,
    };
    let ended = top.integrate(&nowhere).method(method).to(1.0);
    assert!(matches!(
        ended,
        Err(IntegrationError::InvalidSetting { .. })
    ));
}

rigid_body!(Draining {
    motion: planar_translation,
    mass: 1[kg],
    forces: [
        pull = world(-1[N], 0),
        jet = world(0, 1[N] * (position.in_world().x / 1[m]).sqrt()),
    ],
});

/// A motion in such steps says which load has no value.
fn names_the_jet<M: RungeKutta>(method: M, step: f64, full: &PlanarTranslation) {
    let draining = Draining::default();
    let end = 3.0_f64.copysign(step);
    let step = f64::abs(step);
    let method = Fixed { method, step };
    let error = draining.integrate(full).method(method).to(end);
    let text = error.unwrap_err().to_string();
    assert!(text.ends_with("`jet` is not finite"), "{step}: {text}");
}

/// A load without a value on the way is the reason why a step is not solved, not its length.
#[test]
fn a_load_without_a_value_within_a_step() {
    let full = PlanarTranslation {
        position: [0.5, 0.0].into(),
        ..PlanarTranslation::default()
    };
    for step in [0.3, 0.07, 1e-3, -1e-3, -0.07] {
        names_the_jet(Midpoint, step, &full);
        names_the_jet(Classical4, step, &full);
        names_the_jet(DormandPrince8, step, &full);
    }
}
