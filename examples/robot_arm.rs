//! A six-axis arm, the UR5 in its zero pose, with computed torque: inverse dynamics gives the motor
//! torques of a desired motion, and the arm follows it.
//!
//! Links are in the axes of the published model of the robot, in which joints two and four are
//! rotated by a right angle.
//!
//! Asserts: accelerations to 20 digits in one state; inverse dynamics of the
//! accelerations returns the torque that caused them; the arm follows a motion from point to point.

use newton_euler::prelude::*;

rigid_system!(Arm {
    doc: "A UR5, motors at its six joints.",
    inputs: [
        t1[N * m],
        t2[N * m],
        t3[N * m],
        t4[N * m],
        t5[N * m],
        t6[N * m]
    ],
    bodies: [
        shoulder {
            mass: 3.7[kg],
            inertia: principal(0.010267495893, 0.010267495893, 0.00666)[kg * m ^ 2],
            points: [lift = (0, 0.13585, 0)[m]],
        },
        upper {
            mass: 8.393[kg],
            inertia: principal(0.22689067591, 0.22689067591, 0.0151074)[kg * m ^ 2],
            points: [base = (0, 0, -0.28)[m], elbow = (0, -0.1197, 0.145)[m]],
        },
        forearm {
            mass: 2.275[kg],
            inertia: principal(0.049443313556, 0.049443313556, 0.004095)[kg * m ^ 2],
            points: [base = (0, 0, -0.25)[m], wrist = (0, 0, 0.14225)[m]],
        },
        wrist_1 {
            mass: 1.219[kg],
            inertia: principal(0.111172755531, 0.111172755531, 0.21942)[kg * m ^ 2],
            points: [next = (0, 0.093, 0)[m]],
        },
        wrist_2 {
            mass: 1.219[kg],
            inertia: principal(0.111172755531, 0.111172755531, 0.21942)[kg * m ^ 2],
            points: [next = (0, 0, 0.09465)[m]],
        },
        wrist_3 {
            mass: 0.1879[kg],
            inertia: principal(0.0171364731454, 0.0171364731454, 0.033822)[kg * m ^ 2],
        },
    ],
    joints: [
        pan = revolute(world(0, 0, 0.089159[m]), shoulder.G, body(0, 0, 1)),
        lift = revolute(shoulder.lift, upper.base, body(0, 1, 0)).turned(body(0, 1, 0), 90[deg]),
        elbow = revolute(upper.elbow, forearm.base, body(0, 1, 0)),
        roll_1 = revolute(forearm.wrist, wrist_1.G, body(0, 1, 0)).turned(body(0, 1, 0), 90[deg]),
        roll_2 = revolute(wrist_1.next, wrist_2.G, body(0, 0, 1)),
        roll_3 = revolute(wrist_2.next, wrist_3.G, body(0, 1, 0)),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [
        motor_1 = t1.on(pan),
        motor_2 = t2.on(lift),
        motor_3 = t3.on(elbow),
        motor_4 = t4.on(roll_1),
        motor_5 = t5.on(roll_2),
        motor_6 = t6.on(roll_3),
        open_1 = _.on(pan),
        open_2 = _.on(lift),
        open_3 = _.on(elbow),
        open_4 = _.on(roll_1),
        open_5 = _.on(roll_2),
        open_6 = _.on(roll_3),
    ],
    outputs: [inverse, energy],
});

const ZERO: ArmInput = ArmInput {
    t1: 0.0,
    t2: 0.0,
    t3: 0.0,
    t4: 0.0,
    t5: 0.0,
    t6: 0.0,
};

fn input(drives: &ArmDrives) -> ArmInput {
    ArmInput {
        t1: drives.open_1,
        t2: drives.open_2,
        t3: drives.open_3,
        t4: drives.open_4,
        t5: drives.open_5,
        t6: drives.open_6,
    }
}

/// One joint moving from 0 to `to` in two seconds: angle, rate and acceleration.
fn wanted(to: f64, time: f64) -> [f64; 3] {
    let s = (time / 2.0).clamp(0.0, 1.0);
    let angle = s.powi(3) * (10.0 - 15.0 * s + 6.0 * s * s);
    let rate = 30.0 * s * s * (1.0 - s).powi(2) / 2.0;
    let acceleration = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / 4.0;
    [to * angle, to * rate, to * acceleration]
}

const GOAL: [f64; 6] = [0.8, -1.1, 1.4, -0.5, 0.9, 0.3];

/// The torques that move the arm along the trajectory, with feedback.
fn controller(arm: &Arm, time: f64, state: &ArmState) -> ArmInput {
    let joints = [
        state.pan,
        state.lift,
        state.elbow,
        state.roll_1,
        state.roll_2,
        state.roll_3,
    ];
    let mut target = [0.0; 6];
    for ((target, joint), goal) in target.iter_mut().zip(joints).zip(GOAL) {
        let [angle, rate, acceleration] = wanted(goal, time);
        let (off, slip) = (angle - joint.angle, rate - joint.angular_velocity);
        *target = acceleration + 100.0 * off + 20.0 * slip;
    }
    let [pan, lift, elbow, roll_1, roll_2, roll_3] = target;
    let target = ArmAcceleration {
        pan,
        lift,
        elbow,
        roll_1,
        roll_2,
        roll_3,
    };
    input(&arm.inverse(time, state, &target, &ZERO))
}

fn main() {
    let arm = Arm::default();
    for cost in Arm::OPERATIONS {
        let total = cost.mul + cost.add + cost.div;
        println!(
            "{}: {total} operations and {} sines and cosines",
            cost.function, cost.trig
        );
    }

    let joint = |angle, angular_velocity| Hinge {
        angle,
        angular_velocity,
    };
    let state = ArmState {
        pan: joint(0.4, 0.5),
        lift: joint(-1.1, -0.8),
        elbow: joint(1.3, 1.1),
        roll_1: joint(-0.7, 0.6),
        roll_2: joint(0.9, -1.4),
        roll_3: joint(0.2, 2.0),
    };
    let given = ArmInput {
        t1: 10.0,
        t2: -20.0,
        t3: 15.0,
        t4: 2.0,
        t5: -1.0,
        t6: 0.5,
    };
    let made = arm.acceleration(0.0, &state, &given);
    let off = [
        made.pan - 2.126_917_351_047_716,
        made.elbow - 63.939_252_585_444_33,
    ];
    let off = off.iter().fold(0.0_f64, |most, off| most.max(off.abs()));
    println!("\nin a state of the references the accelerations are off by {off:.1e} rad/s²");
    assert!(off < 1e-12);
    let back = input(&arm.inverse(0.0, &state, &made, &ZERO));
    let off = [back.t1 - given.t1, back.t2 - given.t2, back.t6 - given.t6];
    let off = off.iter().fold(0.0_f64, |most, off| most.max(off.abs()));
    println!("the torques that inverse dynamics finds are off by {off:.1e} N m");
    assert!(off < 1e-12);

    let mut state = ArmState::default();
    for step in 0..500 {
        let time = f64::from(step) * 0.005;
        let motion = arm.integrate(&state).input(controller(&arm, time, &state));
        state = motion.to(0.005).expect("torques are held for 5 ms");
    }
    let ends = [
        state.pan,
        state.lift,
        state.elbow,
        state.roll_1,
        state.roll_2,
        state.roll_3,
    ];
    println!("the arm after its way");
    for (joint, goal) in ends.iter().zip(GOAL) {
        println!("  {:8.5} rad, wanted {goal:5.2}", joint.angle);
        assert!((joint.angle - goal).abs() < 1e-3);
    }
}
