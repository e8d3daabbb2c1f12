//! If a motion is not finite, the error names the load that caused it.

use newton_euler::ensemble::Ensemble;
use newton_euler::integrate::{Classical4, DormandPrince, Fixed, IntegrationError, taylor};
use newton_euler::prelude::*;

rigid_body!(Ball::<T> {
    doc: "Drag along a direction that a body at rest does not have.",
    motion: translation,
    params: [drag = 0.1[N * s ^ 2 / m ^ 2]],
    inputs: [wind = world(_, _, _)[N], lamp[N]],
    mass: 2[kg],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        gust = wind + world(lamp, 0, 0),
        drag = -drag * velocity.norm_squared() * velocity / velocity.norm(),
        never = world(0, 0, 1[N]),
    ],
});

rigid_body!(Held {
    motion: planar,
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, 0.5)[m]],
    potentials: [well = 1[J * m] / (position - world(0, -0.5)[m]).norm()],
    moments: [coil = -1[N * m] * (attitude.ln() + 1)],
    constraints: [held = pin.position()],
    reactions: [hinge = world(_, _).at(pin)],
});

rigid_body!(Emptying {
    doc: "A tank that is empty after two seconds.",
    motion: translation,
    mass: 1[kg],
    forces: [jet = world(0, 0, ((2[s] - t) / 1[s]).sqrt() * 3[N])],
    outputs: [taylor],
});

/// What the error of a motion says.
fn blamed<S: core::fmt::Debug>(end: Result<S, IntegrationError<S>>) -> (f64, Option<&'static str>) {
    match end.unwrap_err() {
        IntegrationError::NotFinite { time, load, .. } => (time, load),
        other => panic!("{other}"),
    }
}

#[test]
fn at_the_start() {
    let (ball, rest) = (Ball::<f64>::default(), Translation::default());
    let end = ball.integrate(&rest).to(1.0);
    let said = end.as_ref().unwrap_err().to_string();
    assert_eq!(
        said,
        "the motion is not finite after 0 s: `drag` is not finite"
    );
    assert_eq!(blamed(end), (0.0, Some("drag")));
    let fixed = Fixed {
        method: Classical4,
        step: 0.1,
    };
    assert_eq!(
        blamed(ball.integrate(&rest).method(fixed).to(1.0)),
        (0.0, Some("drag"))
    );
    let mut all = Ensemble::new(&ball, [thrown(), rest, thrown()]);
    let in_own_steps = all.integrate().to(1.0).unwrap_err();
    let in_equal_steps = all.integrate().method(fixed).to(1.0).unwrap_err();
    for error in [in_own_steps, in_equal_steps] {
        let lost = error.member().unwrap();
        assert_eq!(
            (lost.index, blamed::<Translation>(Err(lost.error))),
            (1, (0.0, Some("drag")))
        );
    }
}

fn thrown() -> Translation {
    Translation {
        velocity: [3.0, 0.0, 4.0].into(),
        ..Translation::default()
    }
}

#[test]
fn of_an_input_and_later() {
    let ball = Ball::<f64>::default();
    let lost = |time: f64, _: &Translation| BallInput {
        lamp: if time < 0.45 { 1.0 } else { f64::NAN },
        ..BallInput::default()
    };
    let (time, load) = blamed(ball.integrate(&thrown()).control(0.1, lost).to(1.0));
    assert!((time - 0.5).abs() < 1e-12 && load == Some("gust"));
}

#[test]
fn potentials_and_moments() {
    let body = Held::default();
    let hung = Planar {
        position: [0.0, -0.5].into(),
        angle: 0.5,
        ..Planar::default()
    };
    assert_eq!(body.lost_load(0.0, &hung, &()), Some("well"));
    let turned = Planar {
        position: [0.5, 0.0].into(),
        angle: -1.5,
        ..Planar::default()
    };
    assert_eq!(body.lost_load(0.0, &turned, &()), Some("coil"));
    let there = Planar {
        angle: 1.5,
        ..turned
    };
    assert_eq!(body.lost_load(0.0, &there, &()), None);
}

/// The last state is good, and the next is not.
#[test]
fn just_behind() {
    let (tank, rest) = (Emptying::default(), Translation::default());
    let adaptive = DormandPrince { tolerance: 1e-9 };
    let fixed = Fixed {
        method: Classical4,
        step: 0.01,
    };
    let ends = [
        tank.integrate(&rest).to(3.0),
        tank.integrate(&rest).method(adaptive).to(3.0),
        tank.integrate(&rest).method(fixed).to(3.0),
        taylor(&tank, &rest, &(), 0.0..3.0, 1e-9),
    ];
    for end in ends {
        let (time, load) = blamed(end);
        assert!((time - 2.0).abs() < 1e-4 && load == Some("jet"));
    }
}
