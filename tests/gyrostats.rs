//! Systems in closed form: gyrostats, and parts that know nothing of each other, against the laws of Newton and Euler in 40-digit
//! arithmetic, conserved momenta, Taylor series, and bodies alone.

#[path = "reference/mod.rs"]
mod reference;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::exact::Path;
use newton_euler::integrate::TaylorSeries;
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;
use serde_json::Value;

rigid_system!(Boom {
    doc: "A dual-spin satellite with its rotor on a boom, and a motor that spins it up.",
    bodies: [
        hub {
            mass: 50[kg],
            inertia: principal(11.6, 11.6, 9),
            points: [end = (0, 0, 0.7)]
        },
        rotor {
            mass: 3[kg],
            inertia: principal(0.4, 0.4, 0.6)
        },
    ],
    joints: [
        orbit = free(hub),
        spin = revolute(hub.end, rotor.G, body(0, 0, 1))
    ],
    fields: [pull = mass * world(0, 0.5, -9.80665[m / s ^ 2])],
    drives: [motor = 0.02[N * m].on(spin)],
    outputs: [flow, taylor, momentum, energy],
});

rigid_system!(Free {
    bodies: [
        hub {
            mass: 8[kg],
            inertia: principal(0.5, 0.9, 0.9),
            points: [seat = (-0.2, 0, 0)]
        },
        rotor {
            mass: 2[kg],
            inertia: principal(0.03, 0.02, 0.02)
        },
    ],
    joints: [
        orbit = free(hub),
        spin = revolute(hub.seat, rotor.G, body(1, 0, 0))
    ],
    outputs: [flow, taylor, momentum, energy],
});

rigid_system!(Spun {
    doc: "A satellite that thrusters spin up while a motor spins its rotor down.",
    params: [thrust = 0.3[N * m]],
    bodies: [
        hub {
            mass: 5[kg],
            inertia: principal(2, 2, 1),
            moments: [thrusters = body(0, 0, thrust)]
        },
        rotor {
            mass: 3[kg],
            inertia: principal(0.4, 0.4, 0.6)
        },
    ],
    joints: [
        orbit = free(hub),
        spin = revolute(hub.G, rotor.G, body(0, 0, 1))
    ],
    drives: [motor = (-0.05[N * m]).on(spin)],
    outputs: [flow, taylor],
});

rigid_system!(Tilted {
    doc: "A ball with two rotors along a slant, one behind the other.",
    params: [moment = 0.75[kg * m ^ 2], speed_up = 0.001[N * m]],
    bodies: [
        hub {
            mass: 4[kg],
            inertia: principal(moment, moment, moment)
        },
        first {
            mass: 0.5[kg],
            inertia: cylinder(0.2, 0.01).along(body(0, 3, 4))
        },
        second {
            mass: 0.5[kg],
            inertia: cylinder(0.3, 0.02).along(body(0, 3, 4))
        },
    ],
    joints: [
        socket = rotation(hub),
        near = revolute(hub.G, first.G, body(0, 3, 4)),
        far = revolute(hub.G, second.G, body(0, 3, 4)),
    ],
    drives: [motor = speed_up.on(far)],
    outputs: [flow, taylor, momentum],
});

rigid_system!(Apart {
    doc: "Bodies that have nothing to do with each other.",
    params: [m = 2[kg]],
    bodies: [
        brick {
            mass: 2[kg],
            inertia: principal(0.01, 0.02, 0.026)
        },
        drum {
            mass: 2[kg],
            inertia: cylinder(0.1[m], 0.7[m]).along(body(0, 3, 4))
        },
        stage {
            mass: 5[kg],
            inertia: principal(2, 2, 1),
            moments: [motor = body(0, 0, 0.1[N * m])]
        },
        top {
            mass: m,
            inertia: principal(0.02, 0.02, 0.03),
            points: [tip = (0, 0, -0.3)]
        },
        bob {
            mass: m,
            inertia: principal(0.02, 0.02, 0.03),
            points: [hinge = (0, 0, 0.4)]
        },
        cart {
            mass: 3[kg],
            inertia: principal(1, 1, 1),
            forces: [push = world(6[N], 0, 0)]
        },
        nut {
            mass: 1[kg],
            inertia: principal(1e-3, 1e-3, 1e-3)
        },
    ],
    joints: [
        flight = free(brick),
        tumble = free(drum),
        spin_up = rotation(stage),
        foot = spherical(world(0, 0, 0), top.tip),
        swing = revolute(world(0, 0, 0), bob.hinge, world(0, 1, 0)),
        rail = prismatic(world(0, 0, 0), cart.G, world(1, 0, 0)),
        thread = screw(world(0, 0, 0), nut.G, world(0, 0, 1), 0.01[m / rad]),
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow, taylor],
});

rigid_body!(Brick {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(0.01, 0.02, 0.026),
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Drum {
    motion: spatial,
    mass: 2[kg],
    inertia: cylinder(0.1[m], 0.7[m]).along(body(0, 3, 4)),
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Stage {
    motion: rotation,
    inertia: principal(2, 2, 1),
    moments: [motor = body(0, 0, 0.1[N * m])],
    outputs: [flow],
});

rigid_body!(Top {
    motion: fixed_point(tip),
    params: [m = 2[kg]],
    mass: m,
    inertia: principal(0.02, 0.02, 0.03),
    points: [tip = (0, 0, -0.3)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_body!(Bob {
    motion: fixed_axis(hinge, world(0, 1, 0)),
    params: [m = 2[kg]],
    mass: m,
    inertia: principal(0.02, 0.02, 0.03),
    points: [hinge = (0, 0, 0.4)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

rigid_system!(Generic::<T> {
    doc: "Over any scalar: its closed form is that of `f64`. A panel is welded on beside the center.",
    params: [
        moment = 2[kg * m ^ 2],
        offset = 0.3[m],
        g = world(0, 0, -1.62)[m / s ^ 2]
    ],
    bodies: [
        hub {
            mass: 4[kg],
            inertia: principal(moment, 3, 1),
            points: [side = (offset, 0, 0)]
        },
        panel {
            mass: 1.5[kg],
            inertia: principal(0.1, 0.2, 0.3)
        },
    ],
    joints: [flight = free(hub), fixed = weld(hub.side, panel.G)],
    fields: [weight = mass * g],
    outputs: [flow, taylor],
});

rigid_system!(Flat {
    doc: "In the plane: a plate with a flywheel beside its center of mass, a pendulum and a sled.",
    motion: planar,
    bodies: [
        plate {
            mass: 2[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [seat = (0.2, 0.1)]
        },
        wheel {
            mass: 1[kg],
            inertia: 0.02[kg * m ^ 2]
        },
        bob {
            mass: 1[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [pin = (0, 0.5)]
        },
        sled {
            mass: 1[kg],
            inertia: 0.02[kg * m ^ 2]
        },
        ball { mass: 1[kg] },
    ],
    joints: [
        flight = free(plate),
        spin = revolute(plate.seat, wheel.G),
        swing = revolute(world(0, 0), bob.pin),
        slide = pin_in_slot(world(0, 0), sled.G, world(1, 1)),
        throw = translation(ball),
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    drives: [motor = 0.05[N * m].on(spin)],
    outputs: [flow, taylor],
});

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
    let file = include_str!("reference/systems/gyrostats.json");
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
