//! An arm from a URDF file holds a weight. The description adds the weight in the grip, gravity and
//! the motors to the file, and locks the finger.
//!
//! Asserts: the torques that hold the arm, reaching out, are the moments of the weights about its
//! joints; with these torques it stays at rest, as long as nothing disturbs it; the joint at the
//! base carries the whole weight.

use newton_euler::prelude::*;

rigid_system!(Arm {
    urdf: "examples/urdf_arm.urdf",
    locked: [finger = 20[mm]],
    inputs: [t1[N * m], t2[N * m], t3[N * m], t4[N * m]],
    bodies: [load {
        mass: 1.5[kg],
        inertia: sphere(0.04[m])
    }],
    joints: [hold = weld(grip.origin, load.G)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [
        motor_1 = t1.on(pan),
        motor_2 = t2.on(lift),
        motor_3 = t3.on(elbow),
        motor_4 = t4.on(roll),
        open_1 = _.on(pan),
        open_2 = _.on(lift),
        open_3 = _.on(elbow),
        open_4 = _.on(roll),
    ],
    outputs: [inverse, reactions(pan), energy],
});

/// The weights that act about the lifting joints, with the mass of each part and its position along
/// x.
fn moments() -> [f64; 2] {
    let (elbow, hand) = (0.4, 0.4 + 0.35);
    let parts = [
        (2.4, 0.21),
        (1.3, elbow + 0.16),
        (0.5, hand + 0.05),
        (0.08, hand + 0.1),
        (1.5, hand + 0.13),
    ];
    let about = |x: f64, parts: &[(f64, f64)]| {
        let moments = parts.iter().map(|(mass, place)| 9.81 * mass * (place - x));
        moments.sum()
    };
    [about(0.0, &parts), about(elbow, &parts[1..])]
}

fn main() {
    for line in Arm::SKIPPED {
        println!("not in the equations: {line}");
    }
    let (arm, still) = (Arm::default(), ArmState::default());
    let none = ArmInput {
        t1: 0.0,
        t2: 0.0,
        t3: 0.0,
        t4: 0.0,
    };
    let held = arm.inverse(0.0, &still, &ArmAcceleration::default(), &none);
    let expected = moments();
    println!(
        "\nreaching out, lift {:.3} N m and elbow {:.3} N m",
        held.open_2, held.open_3
    );
    assert!((held.open_1).abs() < 1e-12);
    assert!((held.open_2 + expected[0]).abs() < 1e-12);
    assert!((held.open_3 + expected[1]).abs() < 1e-12);

    let input = ArmInput {
        t1: held.open_1,
        t2: held.open_2,
        t3: held.open_3,
        t4: held.open_4,
    };
    let end = arm.integrate(&still).input(input).to(1.0);
    let end = end.expect("the arm rests");
    let moved = [end.pan, end.lift, end.elbow, end.roll];
    let moved = moved
        .iter()
        .fold(0.0_f64, |most, joint| most.max(joint.angle.abs()));
    println!("after one second it has turned by {moved:.1e} rad");
    assert!(moved < 1e-10);

    let reactions = arm.reactions(0.0, &still, &input);
    let weight = 9.81 * (3.2 + 2.4 + 1.3 + 0.5 + 0.08 + 1.5);
    println!(
        "the base carries {:.3} N, the arm weighs {weight:.3} N",
        reactions.pan.force.z
    );
    assert!((reactions.pan.force.z - weight).abs() < 1e-10);
}
