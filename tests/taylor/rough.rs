//! Motions that are not smooth, or not over the length of a step: walls, pulses, roots, powers and
//! angles at their singular points. Steps of series are checked against the equations; a step that
//! disagrees is shortened, and where there is no series, a Runge–Kutta step crosses the place.

use newton_euler::integrate::{
    DormandPrince, DormandPrince8, Fixed, IntegrationError, Motion, TaylorSeries,
};
use newton_euler::prelude::*;

/// Bodies of 1 kg along a line, under a force of x, its rate v and the time s.
macro_rules! along_x {
    ($($name:ident: [$($force:tt)*];)*) => {$(
        rigid_body!($name {
            motion: translation,
            mass: 1[kg],
            locals: [
                _s = t / 1[s],
                _x = position.in_world().x / 1[m],
                _v = velocity.in_world().x / 1[m / s],
            ],
            forces: [load = world(1[N] * ($($force)*), 0, 0)],
            outputs: [taylor],
        });
    )*};
}

along_x! {
    Wall: [-(100 * (_x - 5)).exp()];
    SoftWall: [-(3 * (_x - 50)).exp()];
    HardWall: [-(1e4 * (_x - 0.5)).exp()];
    Step: [-50 * (1 + ((_x - 5) / 0.05).tanh())];
    HighPower: [_s.powi(30)];
    Pulse: [5 * (-((_s - 10) / 0.1).powi(2)).exp()];
    Switched: [((_s - 10) / 0.05).tanh() - ((_s - 10.1) / 0.05).tanh()];
    Motor: [1 + ((_s - 10) / 0.05).tanh()];
    Root: [((_s - 1).powi(2)).sqrt()];
    LateRoot: [1e3 * ((_s - 1e3).powi(2)).sqrt()];
    Turning: [(_s - 1).atan2(1e-3 + 0 * _x)];
    Circling: [((_s - 3).cos()).atan2((_s - 3).sin())];
    Power: [-_x.powf(1.5)];
    RootSpring: [-_x.cbrt()];
    Length: [-(_x - 1).hypot(0 * _v)];
    Damped: [-_x - 0.3 * (_v * _v).sqrt() * _v];
}

/// Thrown up with quadratic drag, and falling.
macro_rules! stone {
    ($name:ident, $drag:literal) => {
        rigid_body!($name {
            motion: translation,
            mass: 1[kg],
            forces: [drag = -$drag[kg / m] * velocity.norm() * velocity],
            fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
            outputs: [taylor],
        });
    };
}

stone!(Stone, 0.1);
stone!(Feather, 20);
stone!(Shell, 1e-4);

fn at(position: [f64; 3], velocity: [f64; 3]) -> Translation {
    Translation {
        position: position.into(),
        velocity: velocity.into(),
    }
}

/// Series beside DOP853 at its tightest in both directions, as far off as `allowed` tolerances, or `floor`, which is what that is off.
fn check<B>(start: &Translation, end: f64, [allowed, floor]: [f64; 2])
where
    B: Taylor<State = Translation> + Integrate + Default,
    B::Input: Default,
{
    let body = B::default();
    let motion = |from: f64, to: f64, state: &Translation, tolerance: Option<f64>| {
        let motion = body.integrate(state).starting_at(from);
        match tolerance {
            Some(tolerance) => motion.method(TaylorSeries { tolerance }).to(to),
            None => motion.method(DormandPrince { tolerance: 1e-14 }).to(to),
        }
        .unwrap()
    };
    let far = motion(0.0, end, start, None);
    for tolerance in [1e-4, 1e-6, 1e-9, 1e-12] {
        for (from, to, begin, expected) in [(0.0, end, start, &far), (end, 0.0, &far, start)] {
            let found = motion(from, to, begin, Some(tolerance));
            let off = (found.position - expected.position).norm();
            let off = off.max((found.velocity - expected.velocity).norm());
            let sizes =
                [begin, expected].map(|state| state.velocity.norm().max(state.position.norm()));
            let size = sizes[0].max(sizes[1]).max(1.0);
            assert!(
                off <= (allowed * tolerance).max(floor) * size,
                "{}, from {from} s at {tolerance:e}: off by {off:e} of {size}",
                std::any::type_name::<B>()
            );
        }
    }
}

const REST: [f64; 3] = [0.0; 3];
const ALONG: [f64; 3] = [1.0, 0.0, 0.0];
const TOLERANCES: [f64; 4] = [1e-4, 1e-6, 1e-9, 1e-12];

/// Forwards and backwards, against x and its rate as functions of time.
fn check_form<B>(times: [f64; 2], form: fn(f64) -> [f64; 2], allowed: f64)
where
    B: Taylor<State = Translation> + Integrate + Default,
    B::Input: Default,
{
    let state = |time: f64| {
        let [x, v] = form(time);
        at([x, 0.0, 0.0], [v, 0.0, 0.0])
    };
    for tolerance in TOLERANCES {
        for [from, to] in [times, [times[1], times[0]]] {
            let body = B::default();
            let motion = body.integrate(&state(from)).starting_at(from);
            let end = motion.method(TaylorSeries { tolerance }).to(to).unwrap();
            let ([x, v], [begin, fast]) = (form(to), form(from));
            let off = (end.position.x - x).abs().max((end.velocity.x - v).abs());
            let size = [x, v, begin, fast]
                .map(f64::abs)
                .iter()
                .fold(1.0_f64, |a, b| a.max(*b));
            assert!(
                off <= (allowed * tolerance).max(1e-13) * size,
                "{}, from {from} s at {tolerance:e}: off by {off:e} of {size}",
                std::any::type_name::<B>()
            );
        }
    }
}

#[test]
fn walls_hold() {
    check::<Wall>(&at(REST, ALONG), 10.0, [50.0, 1e-12]);
    check::<SoftWall>(&at(REST, [10.0, 0.0, 0.0]), 10.0, [50.0, 1e-12]);
    check::<HardWall>(&at(REST, ALONG), 1.0, [50.0, 1e-10]);
    check::<Step>(&at(REST, ALONG), 10.0, [50.0, 1e-11]);
}

#[test]
fn what_begins_late() {
    check_form::<HighPower>(
        [0.0, 2.0],
        |t| [t.powi(32) / 992.0, t.powi(31) / 31.0],
        20.0,
    );
    check_form::<HighPower>(
        [-0.5, 0.8],
        |t| [t.powi(32) / 992.0, t.powi(31) / 31.0],
        20.0,
    );
    for end in [9.99, 10.02, 10.1] {
        check::<Pulse>(&at(REST, REST), end, [50.0, 1e-12]);
        check::<Switched>(&at(REST, ALONG), end, [50.0, 1e-12]);
    }
    for end in [10.1, 13.0, 20.0, 1000.0] {
        check::<Motor>(&at(REST, REST), end, [50.0, 2e-12]);
    }
}

/// |t - 1|, by a root.
#[test]
fn roots_of_squares() {
    let form = |t: f64| {
        let s = t - 1.0;
        [s * s * s.abs() / 6.0, s * s.abs() / 2.0]
    };
    for times in [[0.0, 3.0], [0.9, 50.0], [1.0, 2.0], [-1.0, 1.0]] {
        check_form::<Root>(times, form, 50.0);
    }
    let late = |t: f64| {
        let s = t - 1e3;
        [s * s * s.abs() / 6e-3, s * s.abs() / 2e-3]
    };
    check_form::<LateRoot>([999.0, 1002.0], late, 50.0);
    check::<Damped>(&at(ALONG, REST), 20.0, [300.0, 1e-11]);
}

#[test]
fn angles() {
    check::<Turning>(&at(REST, REST), 3.0, [100.0, 1e-12]);
    check::<Circling>(&at(REST, REST), 1.4, [100.0, 1e-12]);
    // of a turn, where the angle would be more than half of one
    let jump = |t: f64| {
        let (s, quarter) = (t - 3.0, std::f64::consts::FRAC_PI_2);
        let before = 4.0 * quarter * (s + quarter).min(0.0);
        [
            quarter * s * s / 2.0 - s * s * s / 6.0 - before * (s + quarter).min(0.0) / 2.0,
            quarter * s - s * s / 2.0 - before,
        ]
    };
    check_form::<Circling>([1.0, 5.0], jump, 100.0);
}

/// Where a power or a root has no series: from such a place, and over it.
#[test]
fn singular_points() {
    check::<Power>(&at(REST, ALONG), 0.5, [50.0, 1e-11]);
    check::<Length>(&at(REST, ALONG), 3.0, [50.0, 1e-12]);
    for start in [at(REST, ALONG), at(ALONG, REST), at([1e-5, 0.0, 0.0], REST)] {
        let energy = |state: &Translation| {
            0.5 * state.velocity.x.powi(2) + 0.75 * state.position.x.abs().powf(4.0 / 3.0)
        };
        for (tolerance, end) in TOLERANCES.into_iter().flat_map(|t| [(t, 10.0), (t, -10.0)]) {
            let body = RootSpring::default();
            let motion = body
                .integrate(&start)
                .method(TaylorSeries { tolerance })
                .to(end)
                .unwrap();
            let off = (energy(&motion) - energy(&start)).abs();
            assert!(off < 50.0 * tolerance, "{end} at {tolerance:e}: {off:e}");
        }
    }
}

const G: f64 = 9.80665;

/// Height and speed of a stone that is thrown up, drag over mass in 1/m.
fn thrown(drag: f64, up: f64, time: f64) -> [f64; 2] {
    let fastest = (G / drag).sqrt();
    let rising = fastest / G * (up / fastest).atan();
    let highest = fastest * fastest / G * (1.0 + (up / fastest).powi(2)).sqrt().ln();
    let angle = G * (rising - time) / fastest;
    if time < rising {
        let highest_left = fastest * fastest / G * angle.cos().ln();
        [highest + highest_left, fastest * angle.tan()]
    } else {
        let fallen = fastest * fastest / G * angle.cosh().ln();
        [highest - fallen, fastest * angle.tanh()]
    }
}

fn check_thrown<B>(drag: f64, up: f64, end: f64)
where
    B: Taylor<State = Translation> + Integrate + Default,
    B::Input: Default,
{
    let body = B::default();
    let start = at(REST, [0.0, 0.0, up]);
    for tolerance in TOLERANCES {
        let motion = || body.integrate(&start).method(TaylorSeries { tolerance });
        let size = up.abs().max(thrown(drag, up, end)[0].abs()).max(1.0);
        let mut samples = 0;
        for sample in motion().samples(end, end / 100.0) {
            let sample = sample.unwrap();
            let [height, speed] = thrown(drag, up, sample.time);
            let off = (sample.state.position.z - height).abs();
            let off = off.max((sample.state.velocity.z - speed).abs());
            assert!(
                off < (30.0 * tolerance).max(1e-13) * size,
                "{drag} {up}, {} s at {tolerance:e}: {off:e} of {size}",
                sample.time
            );
            samples += 1;
        }
        assert_eq!(samples, 101);
        let events = motion().events(end, |_, state| state.velocity.z);
        let highest: Vec<_> = events.map(|event| event.unwrap().time).collect();
        let fastest = (G / drag).sqrt();
        let rising = fastest / G * (up / fastest).atan();
        assert_eq!(highest.len(), usize::from(up > 0.0), "{drag} {up}");
        for time in highest {
            assert!(
                (time - rising).abs() < 30.0 * tolerance * size,
                "{time} for {rising}"
            );
        }
    }
}

/// Straight up, over the point at rest, and from rest.
#[test]
fn stones_with_drag() {
    for up in [20.0, 3.0, 0.01, 1e-6, 0.0] {
        check_thrown::<Stone>(0.1, up, 5.0);
        check_thrown::<Feather>(20.0, up, 0.5);
        check_thrown::<Shell>(1e-4, up, 10.0);
    }
    check_thrown::<Shell>(1e-4, 800.0, 70.0);
}

rigid_body!(Spinning {
    doc: "In axes that do not spin with it, from rest under drag.",
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 1, 2)[kg * m ^ 2],
    forces: [drag = -0.1[kg / m] * velocity.norm() * velocity],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [taylor],
});

#[test]
fn from_rest_in_axes_that_do_not_spin() {
    let [height, speed] = thrown(0.1, 0.0, 3.0);
    let spins = Spatial {
        angular_velocity: [0.3, 0.0, 2.0].into(),
        ..Spatial::default()
    };
    let body = Spinning::default();
    let method = Fixed {
        method: DormandPrince8,
        step: 1e-3,
    };
    let far = body.integrate(&spins).method(method).to(3.0).unwrap();
    for tolerance in TOLERANCES {
        let end = body
            .integrate(&spins)
            .method(TaylorSeries { tolerance })
            .to(3.0)
            .unwrap();
        let off = (end.position.z - height)
            .abs()
            .max((end.velocity.z - speed).abs());
        let turned = end.attitude.angle_to(&far.attitude);
        let rate = (end.angular_velocity - far.angular_velocity).norm();
        let worst = off.max(turned).max(rate);
        assert!(
            worst < (50.0 * tolerance).max(1e-12),
            "{tolerance:e}: {worst:e}"
        );
    }
}

/// A step says where the motion was within it, whatever took it.
#[test]
fn steps_over_a_place_tell_the_motion_within() {
    let body = Stone::default();
    let mut motion = Motion::<_, 13>::new(&body, 0.0, &Translation::default());
    let mut end = 0.0;
    while let Some(step) = motion.step_towards(-2.0, &(), 1e-9).unwrap() {
        assert!((step.start() - end).abs() < 1e-14);
        end = step.end();
        for k in 0..=20 {
            let time = step.start() + f64::from(k) / 20.0 * (step.end() - step.start());
            // backwards drag drives: v = g / w tan(w t), w = sqrt(g k)
            let w = (G * 0.1_f64).sqrt();
            let expected = -G / w * (w * time).tan();
            let found = step.at(time).velocity.z;
            let off = (found - expected).abs();
            assert!(
                time > -1.5 && off < 1e-6 * expected.abs().max(1.0),
                "{time}: {off:e}"
            );
        }
        if end < -1.4 {
            break;
        }
    }
}

/// What is no number from the start on, and what has an end, are errors still.
#[test]
fn what_cannot_be_passed() {
    along_x! {
        Nowhere: [(_x - 1).powf(1.5)];
        Drawn: [-1 / (_x * _x)];
    }
    let outside = Nowhere::default().integrate(&at(REST, ALONG)).to(3.0);
    assert!(
        matches!(outside, Err(IntegrationError::NotFinite { time: 0.0, .. })),
        "{outside:?}"
    );
    let drawn = Drawn::default()
        .integrate(&at(ALONG, REST))
        .to(3.0)
        .unwrap_err();
    // falls into the center after pi / (2 sqrt 2)
    assert!(
        (drawn.time() - std::f64::consts::PI / 8.0_f64.sqrt()).abs() < 1e-3,
        "{drawn:?}"
    );
}

stone!(Rest, 0.3);

along_x! {
    Idle: [-0.3 * (_v * _v).sqrt() * _v - _x];
    IdlePower: [-(_v * _v).powf(0.75)];
    IdleRoot: [_x.powf(0.5)];
}

/// What is at rest at a singular point stays there, however long, and comes to its end.
#[test]
fn at_rest_where_there_is_no_series() {
    for end in [0.3, 1.0, 7.7, 10.0, 1e3, -1.0, -10.0] {
        for tolerance in [1e-6, 1e-9, 1e-13] {
            let idle = Translation::default();
            let ends = [
                Idle::default()
                    .integrate(&idle)
                    .method(TaylorSeries { tolerance })
                    .to(end),
                IdlePower::default()
                    .integrate(&idle)
                    .method(TaylorSeries { tolerance })
                    .to(end),
                IdleRoot::default()
                    .integrate(&idle)
                    .method(TaylorSeries { tolerance })
                    .to(end),
            ];
            for found in ends {
                assert_eq!(found.expect("an end"), idle, "until {end}");
            }
        }
    }
    let fallen = Rest::default().integrate(&Translation::default()).to(10.0);
    assert!(fallen.expect("an end").velocity.z < -5.0);
}

rigid_body!(Parachute {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(0.1, 0.1, 0.2)[kg * m ^ 2],
    params: [gravity = 9.80665[m / s ^ 2]],
    inputs: [motor[N]],
    forces: [
        drag = -0.3[N * s ^ 2 / m ^ 2] * velocity.norm() * velocity,
        push = world(motor, 0, 0),
    ],
    moments: [brake = -0.02[N * m * s ^ 2] * angular_velocity.norm() * angular_velocity,],
    fields: [weight = mass * world(0, 0, -gravity)],
    outputs: [taylor],
});

/// Norms that are zero and stay so, beside others that are not, and one that a controller switches on.
#[test]
fn norms_that_stay_zero() {
    let thrown = |up: f64, spin: f64| Spatial {
        velocity: [0.0, 0.0, up].into(),
        angular_velocity: [0.0, 0.0, spin].into(),
        ..Spatial::default()
    };
    for gravity in [0.0, 9.80665] {
        let body = Parachute::new(ParachuteParams { gravity }).unwrap();
        for start in [
            thrown(0.0, 0.0),
            thrown(8.0, 0.0),
            thrown(0.0, 1.0),
            thrown(-3.0, 0.5),
        ] {
            for tolerance in [1e-6, 1e-9, 1e-12] {
                let series = body
                    .integrate(&start)
                    .method(TaylorSeries { tolerance })
                    .to(9.0);
                let series = series.expect("an end");
                let other = body
                    .integrate(&start)
                    .method(DormandPrince { tolerance: 1e-13 });
                let other = other.to(9.0).unwrap();
                let off = (series.velocity - other.velocity).norm()
                    + (series.angular_velocity - other.angular_velocity).norm();
                assert!(
                    off < 100.0 * tolerance,
                    "{gravity} {start:?} {tolerance}: {off}"
                );
            }
        }
        let motor = |time: f64, _: &Spatial| ParachuteInput {
            motor: if time < 1.0 { 0.0 } else { 1.0 },
        };
        let start = thrown(0.0, 0.0);
        let series = body.integrate(&start).control(0.25, motor).to(3.0);
        let other = body
            .integrate(&start)
            .method(DormandPrince { tolerance: 1e-13 });
        let other = other.control(0.25, motor).to(3.0).unwrap();
        assert!((series.expect("an end").velocity - other.velocity).norm() < 1e-7);
    }
}
