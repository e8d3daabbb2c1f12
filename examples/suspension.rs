//! Half a car on its suspension: two wheels on slides, springs and dampers, and tires pushed by the
//! road.
//!
//! World x is forward, y up. Springs and dampers act between the body and the wheels; a tire is a
//! stiff spring to the road, which has one bump.
//!
//! Asserts: at rest the tires carry the weight, each by its lever arm; energy lost in the
//! dampers brings the car back to rest after the bump.

use newton_euler::prelude::*;

rigid_system!(Car {
    doc: "Half a car in the plane, on two wheels.",
    motion: planar,
    params: [
        spring = 22000[N / m],
        damper = 1500[N * s / m],
        tire = 180000[N / m],
        length = 0.55[m],
    ],
    inputs: [road_front[m], road_rear[m]],
    bodies: [
        cart {
            mass: 1[kg],
            inertia: 1[kg * m ^ 2]
        },
        chassis {
            mass: 575[kg],
            inertia: 800[kg * m ^ 2],
            points: [front = (1.2, 0)[m], rear = (-1.4, 0)[m]],
        },
        front {
            mass: 32[kg],
            inertia: 0.9[kg * m ^ 2],
            forces: [tire_front = world(0, tire * (road_front - position.in_world().y))],
        },
        rear {
            mass: 32[kg],
            inertia: 0.9[kg * m ^ 2],
            forces: [tire_rear = world(0, tire * (road_rear - position.in_world().y))],
        },
    ],
    joints: [
        heave = prismatic(world(0, 0.55[m]), cart.G, body(0, 1)),
        pitch = revolute(cart.G, chassis.G),
        strut_front = prismatic(chassis.front, front.G, body(0, -1)),
        strut_rear = prismatic(chassis.rear, rear.G, body(0, -1)),
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    drives: [
        spring_front = (spring * (length - strut_front.position) - damper * strut_front.velocity)
            .on(strut_front),
        spring_rear =
            (spring * (length - strut_rear.position) - damper * strut_rear.velocity).on(strut_rear),
    ],
    outputs: [energy, reactions],
});

fn main() {
    let car = Car::default();
    let flat = CarInput::default();
    let low = CarState {
        strut_front: Slide {
            position: 0.4,
            velocity: 0.0,
        },
        strut_rear: Slide {
            position: 0.4,
            velocity: 0.0,
        },
        ..CarState::default()
    };
    let rest = car
        .integrate(&low)
        .input(flat)
        .to(60.0)
        .expect("the car settles");
    let axle = |strut: &Slide, lever: f64| {
        let (sine, cosine) = rest.pitch.angle.sin_cos();
        rest.heave.position + 0.55 + lever * sine - strut.position * cosine
    };
    let tire = |height: f64| -180_000.0 * height;
    let (front, rear) = (
        tire(axle(&rest.strut_front, 1.2)),
        tire(axle(&rest.strut_rear, -1.4)),
    );
    println!(
        "at rest: front tire {front:.1} N, rear tire {rear:.1} N, pitch {:.5} rad",
        rest.pitch.angle
    );
    let weight = (1.0 + 575.0 + 32.0 + 32.0) * 9.80665;
    assert!(
        (front + rear - weight).abs() < 1e-6 * weight,
        "{} {weight}",
        front + rear
    );

    let moving = car.integrate(&rest).input(CarInput {
        road_front: 0.05,
        road_rear: 0.0,
    });
    let bumped = moving.to(0.08).expect("the front wheel is on the bump");
    println!(
        "80 ms on a bump of 5 cm: the front strut is at {:.4} m",
        bumped.strut_front.position
    );
    let after = car
        .integrate(&bumped)
        .input(flat)
        .to(20.0)
        .expect("the car settles");
    println!(
        "20 s later:              the front strut is at {:.4} m",
        after.strut_front.position
    );
    assert!((after.strut_front.position - rest.strut_front.position).abs() < 1e-6);
}
