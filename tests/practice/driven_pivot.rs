//! A pendulum whose pivot is shaken. If it is shaken fast enough, it stands upside down (P. L.
//! Kapitza, 1951).

use newton_euler::prelude::*;

rigid_system!(Shaken {
    doc: "A rod on a pivot that goes up and down.",
    motion: planar,
    params: [amplitude = 0.02[m], pace = 150[rad / s]],
    bodies: [
        pivot { mass: 0[kg] },
        rod {
            mass: 0.3[kg],
            inertia: rod(0.4[m]),
            points: [foot = (0, -0.2)[m]],
        },
    ],
    joints: [
        shaker = prismatic(world(0, 0), pivot.G, body(0, 1)).driven(amplitude * (pace * t).sin()),
        hinge = revolute(pivot.G, rod.foot),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [energy, reactions],
});

/// The equation of textbooks, `4/3 l a'' = (g + y'') sin a` with l half the length, by Runge and Kutta.
fn by_hand(angle: f64, pace: f64, time: f64) -> [f64; 2] {
    let steps = 40_000;
    let h = time / f64::from(steps);
    let rate = |t: f64, [a, w]: [f64; 2]| {
        let lift = -0.02 * pace * pace * (pace * t).sin();
        [w, (9.81 + lift) * a.sin() / (4.0 / 3.0 * 0.2)]
    };
    let mut y = [angle, 0.0];
    for step in 0..steps {
        let t = f64::from(step) * h;
        let plus = |k: [f64; 2], part: f64| [y[0] + part * h * k[0], y[1] + part * h * k[1]];
        let one = rate(t, y);
        let two = rate(t + h / 2.0, plus(one, 0.5));
        let three = rate(t + h / 2.0, plus(two, 0.5));
        let four = rate(t + h, plus(three, 1.0));
        y = [0, 1].map(|i| y[i] + h / 6.0 * (one[i] + 2.0 * (two[i] + three[i]) + four[i]));
    }
    y
}

fn leaning(angle: f64) -> ShakenState {
    let hinge = Hinge {
        angle,
        angular_velocity: 0.0,
    };
    ShakenState { hinge }
}

#[test]
fn moves_as_by_hand() {
    for pace in [40.0, 150.0] {
        let params = ShakenParams {
            pace,
            ..ShakenParams::default()
        };
        let shaken = Shaken::new(params).expect("a possible body");
        let end = shaken.integrate(&leaning(0.15)).tolerance(1e-12).to(1.0);
        let end = end.expect("smooth").hinge;
        let [angle, rate] = by_hand(0.15, pace, 1.0);
        assert!((end.angle - angle).abs() < 1e-8, "{end:?} {angle}");
        assert!((end.angular_velocity - rate).abs() < 1e-6, "{end:?} {rate}");
    }
}

/// It stands where `(amplitude pace)^2 > 2 g l` with l = J / (m half), that is above 114 rad/s.
#[test]
fn stands_upside_down_if_shaken_fast_enough() {
    let farthest = |pace: f64| {
        let params = ShakenParams {
            pace,
            ..ShakenParams::default()
        };
        let shaken = Shaken::new(params).expect("a possible body");
        let start = leaning(0.05);
        let samples = shaken.integrate(&start).samples(10.0, 0.01);
        samples.fold(0.0_f64, |most, sample| {
            most.max(sample.expect("smooth").state.hinge.angle.abs())
        })
    };
    let critical = (2.0 * 9.81 * 4.0 / 3.0 * 0.2_f64).sqrt() / 0.02;
    assert!((critical - 114.37).abs() < 0.01);
    assert!(farthest(1.15 * critical) < 0.5);
    assert!(farthest(0.85 * critical) > 3.0);
}

/// Upright and at rest in its hinge, the rod is as heavy as the lift makes it; the drive carries it.
#[test]
fn the_shaker_carries_it() {
    let shaken = Shaken::default();
    let time = 0.013;
    let found = shaken.reactions(time, &leaning(0.0), &());
    let known = 0.3 * (9.81 - 0.02 * 150.0 * 150.0 * (150.0_f64 * time).sin());
    assert!((found.shaker_drive - known).abs() < 1e-12, "{found:?}");
    assert!((found.hinge.force.y - known).abs() < 1e-12);
}
