//! Systems in closed form: gyrostats, and parts that do not affect each other. They are compared
//! with Newton's and Euler's laws in 40-digit arithmetic, conserved momenta, Taylor series, and
//! single bodies.

#[path = "../reference/mod.rs"]
mod reference;
mod scenes;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::ensemble::Ensemble;
use newton_euler::exact::Path;
use newton_euler::integrate::TaylorSeries;
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;
use scenes::*;
use serde_json::Value;

/// The largest difference of two states, over the largest number of the second one.
fn apart<S: Coordinates<Scalar = f64>>(a: &S, b: &S) -> f64 {
    let (a, b) = (a.coordinates(), b.coordinates());
    let pairs = a.as_ref().iter().zip(b.as_ref());
    let largest = b
        .as_ref()
        .iter()
        .fold(1.0, |largest, b| b.abs().max(largest));
    let differences = pairs.map(|(a, b)| (a - b).abs() / largest);
    differences.fold(0.0, f64::max)
}

/// The state of a hub and a rotor, from (r, q, v, w, angle, rate), the scalar of q first.
fn listed(list: &Value) -> (Spatial, Hinge) {
    let list: [f64; 15] = reference::numbers(list);
    let [x, y, z, s, i, j, k, vx, vy, vz, wx, wy, wz, angle, rate] = list;
    let hub = Spatial {
        position: [x, y, z].into(),
        attitude: UnitQuaternion::new_unchecked(Quaternion::new(s, i, j, k)),
        velocity: [vx, vy, vz].into(),
        angular_velocity: [wx, wy, wz].into(),
    };
    let rotor = Hinge {
        angle,
        angular_velocity: rate,
    };
    (hub, rotor)
}

fn problem(name: &str) -> ((Spatial, Hinge), (Spatial, Hinge), f64) {
    let file = include_str!("../reference/systems/gyrostats.json");
    let file: Value = serde_json::from_str(file).unwrap();
    let problem = &file[name];
    let time = problem["time"].as_f64().unwrap();
    (listed(&problem["start"]), listed(&problem["end"]), time)
}

/// Each body by itself, in 40-digit arithmetic.
#[test]
fn laws_of_newton_and_euler() {
    let ((orbit, spin), (hub, rotor), time) = problem("boom");
    let end = Boom::default().flow(&BoomState { orbit, spin }, time);
    assert!(
        apart(&end.orbit, &hub) < 1e-15,
        "{:e}",
        apart(&end.orbit, &hub)
    );
    assert!(
        apart(&end.spin, &rotor) < 1e-15,
        "{:e}",
        apart(&end.spin, &rotor)
    );

    let ((orbit, spin), (hub, rotor), time) = problem("free");
    let end = Free::default().flow(&FreeState { orbit, spin }, time);
    assert!(
        apart(&end.orbit, &hub) < 1e-15,
        "{:e}",
        apart(&end.orbit, &hub)
    );
    assert!(
        apart(&end.spin, &rotor) < 1e-15,
        "{:e}",
        apart(&end.spin, &rotor)
    );
}

/// What is kept: after 1e6 s, and a million radians of precession, momenta in world axes are where they were.
#[test]
fn momenta_are_kept() {
    let ((mut orbit, spin), ..) = problem("free");
    // the center of mass rests
    let arm = Vector3::new(-0.04, 0.0, 0.0);
    orbit.position = Vector3::zeros();
    orbit.velocity = -(orbit.attitude * orbit.angular_velocity.cross(&arm));
    let (free, start) = (Free::default(), FreeState { orbit, spin });
    let motion = free.path(&start);
    for time in TIMES {
        let both = [start, motion.at(time)];
        is_kept(time, both.map(|state| free.angular_momentum(&state)));
        let momentum = free.linear_momentum(&both[1]);
        assert!(momentum.norm() < 1e-14, "{momentum}");
        let [before, after] = both.map(|state| free.kinetic_energy(&state));
        assert!((after / before - 1.0).abs() < 1e-14);
    }

    let ball = Tilted::new(TiltedParams {
        speed_up: 0.0,
        ..TiltedParams::default()
    })
    .unwrap();
    let start = tilted();
    let motion = ball.path(&start);
    for time in TIMES {
        is_kept(
            time,
            [start, motion.at(time)].map(|state| ball.angular_momentum(&state)),
        );
    }
}

const TIMES: [f64; 3] = [1.0, -1e3, 1e6];

fn is_kept(time: f64, [before, after]: [Vector3<f64>; 2]) {
    let change = (after - before).norm() / before.norm();
    assert!(change < 4e-16 * (10.0 + time.abs()), "{time} s: {change:e}");
}

fn hinge(angle: f64, angular_velocity: f64) -> Hinge {
    Hinge {
        angle,
        angular_velocity,
    }
}

fn tilted() -> TiltedState {
    TiltedState {
        socket: Rotation {
            attitude: UnitQuaternion::new(Vector3::new(0.3, -0.2, 0.5)),
            angular_velocity: Vector3::new(0.4, -0.3, 0.7),
        },
        near: hinge(0.2, 5.0),
        far: hinge(-1.0, -3.0),
    }
}

/// Steps along Taylor series, forwards and backwards in time.
fn follows_series<B>(system: &B, start: &B::State)
where
    B: Flow<Scalar = f64, State: Coordinates, Input = ()> + Taylor + Integrate,
{
    let method = TaylorSeries { tolerance: 1e-16 };
    for time in [0.25, 3.0, -2.0] {
        let end = system.integrate(start).method(method).to(time).ok();
        let found = system.flow(start, time);
        let error = apart(&found, &end.expect("it goes on"));
        assert!(error < 3e-14, "{time} s: {error:e}");
        // the best method is this one
        let best = system.integrate(start).to(time).ok();
        assert_eq!(
            best.expect("it goes on").coordinates().as_ref(),
            found.coordinates().as_ref()
        );
    }
}

#[test]
fn series() {
    let ((orbit, spin), ..) = problem("boom");
    follows_series(&Boom::default(), &BoomState { orbit, spin });
    follows_series(&Free::default(), &FreeState { orbit, spin });
    for thrust in [0.3, -0.3, 1e-9] {
        let spun = Spun::new(SpunParams { thrust }).unwrap();
        follows_series(&spun, &SpunState { orbit, spin });
    }
    follows_series(&Tilted::default(), &tilted());
    follows_series(&Apart::default(), &parts());
    let start = FlatState {
        flight: Planar {
            position: [1.0, 2.0].into(),
            angle: 0.3,
            velocity: [0.5, 1.0].into(),
            angular_velocity: 0.7,
        },
        spin: hinge(0.5, -4.0),
        swing: hinge(1.0, 0.2),
        slide: Cylinder {
            velocity: 1.0,
            angular_velocity: -2.0,
            ..Cylinder::default()
        },
        throw: PlanarTranslation {
            velocity: [0.5, 1.0].into(),
            ..PlanarTranslation::default()
        },
    };
    follows_series(&Flat::default(), &start);
    let flight = parts().flight;
    follows_series(&Generic::default(), &GenericState { flight });
}

/// Rotors whose axes are written in other ways: in params, on what is welded on, behind turns.
#[test]
fn axes_of_rotors() {
    let TiltedState { socket, near, .. } = tilted();
    let aimed = AimedState { socket, spin: near };
    for axis in [[1.0, 0.0], [0.0, 1.0], [0.6, -0.8]] {
        let [a, b] = axis;
        let ball = Aimed::new(AimedParams { a, b }).expect("each axis is one");
        follows_series(&ball, &aimed);
    }
    let ((orbit, spin), ..) = problem("free");
    let roll = hinge(0.7, 3.0);
    follows_series(&Bolted::default(), &BoltedState { orbit, spin, roll });
    follows_series(&Leaned::default(), &LeanedState { orbit, spin });
}

/// A wheel on a body that swings keeps its attitude.
#[test]
fn wheels_on_pendulums() {
    let flight = Planar {
        position: [1.0, 2.0].into(),
        angle: 0.3,
        velocity: [0.5, 1.0].into(),
        angular_velocity: 0.7,
    };
    let spin = hinge(0.5, -4.0);
    follows_series(&Pulled::default(), &PulledState { flight, spin });
    let start = ClockState {
        swing: hinge(0.6, 1.0),
        hang: hinge(0.5, -4.0),
        back: hinge(-0.2, 3.0),
    };
    follows_series(&Clock::default(), &start);
}

/// The axis of a pendulum is any.
#[test]
fn a_slanted_pendulum() {
    let swing = hinge(0.5, 1.0);
    for time in [0.1, 7.0, -300.0] {
        let end = Slanted::default().flow(&SlantedState { swing }, time);
        let alone = Leaning::default().flow(&swing, time);
        let error = apart(&end.swing, &alone);
        assert!(error < 1e-13, "{time} s: {error:e}");
    }
}

fn parts() -> ApartState {
    let attitude = UnitQuaternion::new(Vector3::new(0.3, -0.2, 0.5));
    let flying = |angular_velocity: [f64; 3]| Spatial {
        position: Vector3::new(1.0, 2.0, -3.0),
        attitude,
        velocity: Vector3::new(0.2, -0.1, 4.0),
        angular_velocity: angular_velocity.into(),
    };
    let turning = |angular_velocity: [f64; 3]| Rotation {
        attitude,
        angular_velocity: angular_velocity.into(),
    };
    ApartState {
        flight: flying([0.4, 3.0, 0.1]),
        tumble: flying([2.0, -1.0, 0.5]),
        spin_up: turning([0.3, 0.2, 0.5]),
        foot: turning([0.3, 0.2, 20.0]),
        swing: hinge(0.5, 1.0),
        rail: Slide {
            position: 1.0,
            velocity: -2.0,
        },
        thread: hinge(0.5, 1.0),
    }
}

/// Each part moves as the body does that it is.
#[test]
fn parts_move_as_alone() {
    let start = parts();
    for time in [0.1, 7.0, -300.0] {
        let end = Apart::default().flow(&start, time);
        let same = |a: f64| assert!(a < 1e-15, "{time} s: {a:e}");
        same(apart(
            &end.flight,
            &Brick::default().flow(&start.flight, time),
        ));
        same(apart(
            &end.tumble,
            &Drum::default().flow(&start.tumble, time),
        ));
        same(apart(
            &end.spin_up,
            &Stage::default().flow(&start.spin_up, time),
        ));
        same(apart(&end.foot, &Top::default().flow(&start.foot, time)));
        same(apart(&end.swing, &Bob::default().flow(&start.swing, time)));
        let rail = 1.0 - 2.0 * time + time * time;
        assert!((end.rail.position - rail).abs() <= 1e-15 * rail.abs());
    }
}

/// What is found along a path: a wheel that passes a mark, at times that are known.
#[test]
fn events() {
    let ((orbit, spin), ..) = problem("free");
    let free = Free::default();
    let motion = free.integrate(&FreeState { orbit, spin });
    let marks = motion.events(500.0, |_, state| state.orbit.angular_velocity.y);
    let times: Vec<f64> = marks.map(|mark| mark.unwrap().time).collect();
    let path = free.path(&FreeState { orbit, spin });
    assert_eq!(times.len(), 2);
    for time in times {
        assert!(path.at(time).orbit.angular_velocity.y.abs() < 1e-15);
    }
}

/// Members of an ensemble take their paths.
#[test]
fn ensembles() {
    let flights = [0.1, 0.7, -2.0].map(|rate| {
        let mut flight = parts().flight;
        flight.angular_velocity.x = rate;
        GenericState { flight }
    });
    let body = Generic::default();
    let mut ensemble = Ensemble::new(&body, flights);
    ensemble.integrate().to(5.0).unwrap();
    for (end, start) in ensemble.states().iter().zip(&flights) {
        assert!(end == body.flow(start, 5.0));
    }
}
