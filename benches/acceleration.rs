//! Generated accelerations against hand-written nalgebra for the same body.
//!
//! Both run in turn on one core; what is printed is the ratio of their times, generated over
//! hand-written, as the median over all rounds. `cargo bench --bench acceleration`

use std::hint::black_box;
use std::time::Instant;

use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use newton_euler::prelude::*;
use newton_euler::rigid_body;

rigid_body!(General {
    doc: "A full inertia tensor, a force at a point of the body, and weight.",
    motion: spatial,
    inputs: [force = body(_, _, _)[N]],
    mass: 3.2[kg],
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: -0.12,
        yz: -0.05,
        zx: 0.07
    }[kg * m ^ 2],
    points: [nozzle = (0.1, -0.2, 0.05)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [thrust = force.at(nozzle)],
});

rigid_body!(Principal {
    doc: "The same with principal axes.",
    motion: spatial,
    inputs: [force = body(_, _, _)[N]],
    mass: 3.2[kg],
    inertia: principal(1.3, 1.7, 2.1)[kg * m ^ 2],
    points: [nozzle = (0.1, -0.2, 0.05)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [thrust = force.at(nozzle)],
});

rigid_body!(Plane {
    doc: "A planar body with a force at a point.",
    motion: planar,
    inputs: [force = body(_, _)[N]],
    mass: 3.2[kg],
    inertia: 2.1[kg * m ^ 2],
    points: [nozzle = (0.1, -0.2)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    forces: [thrust = force.at(nozzle)],
});

/// What one writes without the macro: vectors, a stored inertia and its stored inverse.
struct ByHand {
    inverse_mass: f64,
    inertia: Matrix3<f64>,
    inverse_inertia: Matrix3<f64>,
    nozzle: Vector3<f64>,
    gravity: Vector3<f64>,
}

impl ByHand {
    fn new(inertia: Matrix3<f64>) -> Self {
        Self {
            inverse_mass: 1.0 / 3.2,
            inertia,
            inverse_inertia: inertia.try_inverse().expect("an invertible inertia"),
            nozzle: Vector3::new(0.1, -0.2, 0.05),
            gravity: Vector3::new(0.0, 0.0, -9.80665),
        }
    }

    #[inline]
    fn acceleration(&self, state: &Spatial, force: &Vector3<f64>) -> SpatialAcceleration {
        let w = state.angular_velocity;
        let moment = self.nozzle.cross(force);
        SpatialAcceleration {
            linear: state.attitude * (force * self.inverse_mass) + self.gravity,
            angular: self.inverse_inertia * (moment - w.cross(&(self.inertia * w))),
        }
    }
}

/// Calls `a` and `b` in turn and returns the median of the ratio of their times, and of its quartiles.
fn paired(mut a: impl FnMut(), mut b: impl FnMut()) -> [f64; 3] {
    let time = |run: &mut dyn FnMut()| {
        let start = Instant::now();
        for _ in 0..200 {
            run();
        }
        start.elapsed().as_secs_f64()
    };
    let mut ratios: Vec<f64> = (0..101)
        .map(|round| {
            if round % 2 == 0 {
                let first = time(&mut a);
                first / time(&mut b)
            } else {
                let second = time(&mut b);
                time(&mut a) / second
            }
        })
        .skip(1)
        .collect();
    ratios.sort_by(f64::total_cmp);
    [ratios[25], ratios[50], ratios[75]]
}

/// Independent evaluations over many states.
fn throughput(
    states: &[Spatial],
    forces: &[Vector3<f64>],
    evaluate: impl Fn(&Spatial, &Vector3<f64>) -> SpatialAcceleration,
) {
    let mut total = Vector3::zeros();
    for (state, force) in black_box(states).iter().zip(black_box(forces)) {
        let acceleration = evaluate(state, force);
        total += acceleration.linear + acceleration.angular;
    }
    black_box(total);
}

/// Each evaluation needs the one before it.
fn chain(
    state: &Spatial,
    force: &Vector3<f64>,
    evaluate: impl Fn(&Spatial, &Vector3<f64>) -> SpatialAcceleration,
) {
    let (mut state, mut force) = (*black_box(state), *black_box(force));
    for _ in 0..256 {
        let acceleration = evaluate(&state, &force);
        state.angular_velocity += acceleration.angular * 1e-6;
        force += acceleration.linear * 1e-9;
    }
    black_box((state, force));
}

fn compare(
    name: &str,
    by_hand: &ByHand,
    generated: impl Fn(&Spatial, &Vector3<f64>) -> SpatialAcceleration,
) {
    let states: Vec<Spatial> = (0..256_u32)
        .map(|i| {
            let x = f64::from(i) * 0.37;
            Spatial {
                attitude: UnitQuaternion::from_euler_angles(x, 2.0 * x, 3.0 * x),
                angular_velocity: Vector3::new(x.sin(), x.cos(), (2.0 * x).sin()),
                ..Spatial::default()
            }
        })
        .collect();
    let forces: Vec<Vector3<f64>> = states
        .iter()
        .map(|state| state.angular_velocity * 3.0)
        .collect();
    for (state, force) in states.iter().zip(&forces) {
        let (ours, theirs) = (generated(state, force), by_hand.acceleration(state, force));
        let difference =
            (ours.linear - theirs.linear).norm() + (ours.angular - theirs.angular).norm();
        assert!(
            difference < 1e-13,
            "{name}: the two differ by {difference:e}"
        );
    }
    let hand = |state: &Spatial, force: &Vector3<f64>| by_hand.acceleration(state, force);
    let rows = [
        (
            "throughput",
            paired(
                || throughput(&states, &forces, &generated),
                || throughput(&states, &forces, hand),
            ),
        ),
        (
            "dependent chain",
            paired(
                || chain(&states[1], &forces[1], &generated),
                || chain(&states[1], &forces[1], hand),
            ),
        ),
    ];
    for (kind, [low, median, high]) in rows {
        println!("{name:<28} {kind:<16} {median:.3}   quartiles {low:.3} to {high:.3}");
    }
}

fn main() {
    println!("time of generated code over hand-written nalgebra, medians of 100 paired rounds");
    let full = Matrix3::new(1.3, -0.12, 0.07, -0.12, 1.7, -0.05, 0.07, -0.05, 2.1);
    let diagonal = Matrix3::from_diagonal(&Vector3::new(1.3, 1.7, 2.1));
    let general = General::default();
    compare("general body", &ByHand::new(full), |state, force| {
        general.acceleration(0.0, state, &GeneralInput { force: *force })
    });
    let principal = Principal::default();
    compare("principal axes", &ByHand::new(diagonal), |state, force| {
        principal.acceleration(0.0, state, &PrincipalInput { force: *force })
    });
    compare_planar(&ByHand::new(diagonal));
}

/// A planar body against the same body in space.
fn compare_planar(by_hand: &ByHand) {
    let plane = Plane::default();
    let (mut flat, mut space) = (Vec::new(), Vec::new());
    for i in 0..256_u32 {
        let x = f64::from(i) * 0.37;
        flat.push(Planar {
            angle: x,
            angular_velocity: x.sin(),
            ..Planar::default()
        });
        space.push(Spatial {
            attitude: UnitQuaternion::from_euler_angles(0.0, 0.0, x),
            angular_velocity: Vector3::new(0.0, 0.0, x.sin()),
            ..Spatial::default()
        });
    }
    let forces: Vec<Vector3<f64>> = space
        .iter()
        .map(|state| Vector3::new(3.0, 1.0, 0.0) * state.angular_velocity.z)
        .collect();
    let ours = || {
        let mut total = 0.0;
        for (state, force) in black_box(&flat).iter().zip(black_box(&forces)) {
            let acceleration = plane.acceleration(0.0, state, &PlaneInput { force: force.xy() });
            total += acceleration.linear.x + acceleration.linear.y + acceleration.angular;
        }
        black_box(total);
    };
    let theirs = || {
        throughput(&space, &forces, |state, force| {
            by_hand.acceleration(state, force)
        });
    };
    let [low, median, high] = paired(ours, theirs);
    println!(
        "{:<28} {:<16} {median:.3}   quartiles {low:.3} to {high:.3}",
        "planar body against space", "throughput"
    );
}
