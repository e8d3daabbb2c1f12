//! A quadrotor that hovers by itself: motors with lag and a controller with integrators are
//! user-defined states, in addition to its motion.
//!
//! Body axes: x forward, y left, z up, from the center of mass G; world z is up. Thrusts act along
//! body z. Rotors 1 and 3 spin about -z, so the air turns the body about +z with them.
//!
//! Each thrust follows its command with the lag T. Moments and lift are commanded from the angles,
//! their rates and their integrals so that each of roll, pitch and height has four equal poles -p.
//! The motor lag permits only p = 1 / (4 T).
//!
//! Asserts: a small tilt φ₀ decays as φ₀ exp(-p t) (1 + p t + (p t)² / 2 - (p t)³ / 2), which
//! passes through zero once; in the end the integrators carry a camera hung on the front arm, and
//! the thrusts balance its moment.

use newton_euler::nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

rigid_body!(Hover {
    doc: "A quadrotor that holds a height, level; its motors lag, and its controller has integrators.",
    motion: spatial,
    params: [
        arm = 0.17[m],
        drag_ratio = 0.016[m],
        lag = 0.05[s],
        camera = 0[kg]
    ],
    inputs: [height[m]],
    states: [
        thrust_1[N],
        thrust_2[N],
        thrust_3[N],
        thrust_4[N],
        roll_sum[rad * s],
        pitch_sum[rad * s],
        height_sum[m * s],
    ],
    rates: [
        thrust_1 = (lift / 4 - across / 2 + twist - thrust_1) / lag,
        thrust_2 = (lift / 4 + along / 2 - twist - thrust_2) / lag,
        thrust_3 = (lift / 4 + across / 2 + twist - thrust_3) / lag,
        thrust_4 = (lift / 4 - along / 2 - twist - thrust_4) / lag,
        roll_sum = roll,
        pitch_sum = pitch,
        height_sum = above,
    ],
    mass: 1.2[kg],
    inertia: principal(0.0123, 0.0123, 0.0224)[kg * m ^ 2],
    points: [
        front = (arm, 0, 0),
        left = (0, arm, 0),
        back = (-arm, 0, 0),
        right = (0, -arm, 0),
    ],
    locals: [
        // for small tilts, the angles
        roll = body(0, 1, 0).in_world().z,
        pitch = -body(1, 0, 0).in_world().z,
        above = position.in_world().z - height,
        w = angular_velocity.in_body(),
        // (s + p)^4 = s^4 + 4 p s^3 + 6 p^2 s^2 + 4 p^3 s + p^4,  4 p = 1 / T
        pole = 1 / (4 * lag),
        gain = lag * pole.powi(2),
        fall = gain * (6 * velocity.in_world().z + 4 * pole * above + pole.powi(2) * height_sum),
        lift = mass * (9.80665[m / s ^ 2] - fall),
        stiff = 0.0123[kg * m ^ 2] / arm * gain,
        along = -stiff * (6 * w.x + 4 * pole * roll + pole.powi(2) * roll_sum),
        across = -stiff * (6 * w.y + 4 * pole * pitch + pole.powi(2) * pitch_sum),
        twist = -0.05[N * m * s] * w.z / (4 * drag_ratio),
    ],
    fields: [
        weight = mass * world(0, 0, -9.80665[m / s ^ 2]),
        hung = (camera * world(0, 0, -9.80665[m / s ^ 2])).at(front),
    ],
    forces: [
        lift_1 = body(0, 0, thrust_1).at(front),
        lift_2 = body(0, 0, thrust_2).at(left),
        lift_3 = body(0, 0, thrust_3).at(back),
        lift_4 = body(0, 0, thrust_4).at(right),
    ],
    moments: [drag = body(
        0,
        0,
        drag_ratio * (thrust_1 - thrust_2 + thrust_3 - thrust_4)
    )],
    outputs: [taylor],
});

const WEIGHT: f64 = 1.2 * 9.80665;

fn hovering() -> HoverState {
    let thrust = WEIGHT / 4.0;
    HoverState {
        thrust_1: thrust,
        thrust_2: thrust,
        thrust_3: thrust,
        thrust_4: thrust,
        ..HoverState::default()
    }
}

fn roll(state: &HoverState) -> f64 {
    (state.motion.attitude * Vector3::y()).z
}

fn main() {
    let drone = Hover::default();
    let rate = drone.acceleration(0.0, &hovering(), &HoverInput { height: 0.0 });
    println!("hover: {:.6} N on each rotor", WEIGHT / 4.0);
    println!(
        "  acceleration of G  {:.1e} m/s²",
        rate.motion.linear.norm()
    );
    println!("  rate of thrust 1   {:.1e} N/s", rate.thrust_1);

    let (tilt, pole) = (1e-4, 1.0 / (4.0 * drone.params().lag));
    let mut tilted = hovering();
    tilted.motion.attitude = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), tilt);
    println!("\ntilted by {tilt} rad about x, poles at -{pole} 1/s");
    println!("  t/s   roll/tilt    closed form");
    let motion = drone.integrate(&tilted).tolerance(1e-12);
    for sample in motion
        .samples(1.6, 0.2)
        .map(|sample| sample.expect("it levels"))
    {
        let s = pole * sample.time;
        let expected = (1.0 + s + s * s / 2.0 - s.powi(3) / 2.0) * (-s).exp();
        let found = roll(&sample.state) / tilt;
        println!("  {:.1}   {found:+.8}  {expected:+.8}", sample.time);
        assert!((found - expected).abs() < 1e-7);
    }

    let camera = 0.12;
    let laden = Hover::new(HoverParams {
        camera,
        ..*drone.params()
    });
    let laden = laden.expect("a body");
    println!("\na camera of {camera} kg is hung on the front arm");
    println!("  t/s   height/m     pitch/deg   front/N     back/N");
    let motion = laden.integrate(&hovering()).tolerance(1e-10);
    let mut end = hovering();
    for sample in motion
        .samples(8.0, 0.5)
        .map(|sample| sample.expect("it hovers"))
    {
        end = sample.state;
        let pitch = -(end.motion.attitude * Vector3::x()).z.asin().to_degrees();
        let height = end.motion.position.z;
        if sample.time < 2.1 || sample.time > 7.9 {
            let (front, back) = (end.thrust_1, end.thrust_3);
            println!(
                "  {:.1}   {height:+.6}    {pitch:+.6}   {front:.6}    {back:.6}",
                sample.time
            );
        }
    }
    let more = camera * 9.80665;
    let expected = [
        (WEIGHT + more) / 4.0 + more / 2.0,
        (WEIGHT + more) / 4.0 - more / 2.0,
    ];
    println!(
        "  at last             {:.6}    {:.6}",
        expected[0], expected[1]
    );
    let by_lever = 0.17 * more / (0.0123 * drone.params().lag * pole.powi(4));
    println!(
        "  integral of pitch   {:.6} rad s, by the lever {by_lever:.6}",
        end.pitch_sum
    );
    assert!((end.thrust_1 - expected[0]).abs() < 1e-6);
    assert!((end.thrust_3 - expected[1]).abs() < 1e-6);
    assert!((end.pitch_sum - by_lever).abs() < 1e-6);

    // the camera is released: integrators are plain fields, and their load goes with it
    let mut released = end;
    (released.pitch_sum, released.height_sum) = (0.0, 0.0);
    let highest = |state: &HoverState| {
        let motion = drone.integrate(state).samples(3.0, 0.01);
        let heights = motion.map(|sample| sample.expect("it hovers").state.motion.position.z);
        heights.fold(0.0, f64::max)
    };
    let (left, set_back) = (highest(&end), highest(&released));
    println!(
        "\nlet go: it rises by {:.1} mm, or by {:.1} mm",
        left * 1e3,
        set_back * 1e3
    );
    println!("  as its integrators are left as they are, or set back");
    assert!(set_back < 0.5 * left);
}
