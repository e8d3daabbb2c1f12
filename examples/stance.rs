//! A walking quadruped on three feet: the torques of its joints and the ground forces.
//!
//! The feet stand on a ball, on a groove and on a plane, so the balances determine all forces: the
//! left fore foot is held in all directions, the right hind foot sideways and upwards, the right
//! fore foot upwards. Inverse dynamics gives the torques that keep it at rest. The same robot with
//! these torques as inputs does not move, and its reactions are the ground forces.
//!
//! Asserts: nothing accelerates; the ground forces carry the weight and nothing else; in
//! motions that the feet allow, the work of the torques is the gain of potential energy.

use newton_euler::prelude::*;

macro_rules! quadruped {
    ($name:ident, [$($torque:ident = $value:expr => $joint:ident),*], inputs: $inputs:tt, outputs: $outputs:tt) => {
        rigid_system!($name {
            inputs: $inputs,
            bodies: [
                trunk {
                    mass: 6[kg],
                    inertia: principal(0.02, 0.06, 0.07),
                    points: [fl = (0.19, 0.1, 0), fr = (0.19, -0.1, 0), hl = (-0.19, 0.1, 0), hr = (-0.19, -0.1, 0)],
                },
                thigh {
                    copies: [fl, fr, hl, hr], mass: 0.6[kg],
                    inertia: principal(2e-3, 2e-3, 3e-4),
                    points: [hip = (0, 0, 0.06), knee = (0, 0, -0.1)],
                },
                shank {
                    copies: [fl, fr, hl, hr], mass: 0.2[kg],
                    inertia: principal(6e-4, 6e-4, 4e-5),
                    points: [knee = (0, 0, 0.07), foot = (0, 0, -0.09)],
                },
            ],
            joints: [
                base = free(trunk),
                hip_fl = revolute(trunk.fl, thigh_fl.hip, body(0, 1, 0)),
                hip_fr = revolute(trunk.fr, thigh_fr.hip, body(0, 1, 0)),
                hip_hl = revolute(trunk.hl, thigh_hl.hip, body(0, 1, 0)),
                hip_hr = revolute(trunk.hr, thigh_hr.hip, body(0, 1, 0)),
                knee_fl = revolute(thigh_fl.knee, shank_fl.knee, body(0, 1, 0)),
                knee_fr = revolute(thigh_fr.knee, shank_fr.knee, body(0, 1, 0)),
                knee_hl = revolute(thigh_hl.knee, shank_hl.knee, body(0, 1, 0)),
                knee_hr = revolute(thigh_hr.knee, shank_hr.knee, body(0, 1, 0)),
            ],
            constraints: [
                fore_left = shank_fl.foot.position() - world(0.1, 0.1, 0),
                fore_right = shank_fr.foot.position().in_world().z,
                hind_across = shank_hr.foot.position().in_world().y + 0.1[m],
                hind_right = shank_hr.foot.position().in_world().z,
            ],
            drives: [$($torque = $value.on($joint)),*],
            fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
            outputs: $outputs,
        });
    };
}
quadruped!(
    Standing,
    [
        t1 = _ => hip_fl, t2 = _ => hip_fr, t3 = _ => hip_hl, t4 = _ => hip_hr,
        t5 = _ => knee_fl, t6 = _ => knee_fr, t7 = _ => knee_hl, t8 = _ => knee_hr
    ],
    inputs: [],
    outputs: [inverse, energy]
);
quadruped!(
    Driven,
    [
        t1 = u1 => hip_fl, t2 = u2 => hip_fr, t3 = u3 => hip_hl, t4 = u4 => hip_hr,
        t5 = u5 => knee_fl, t6 = u6 => knee_fr, t7 = u7 => knee_hl, t8 = u8 => knee_hr
    ],
    inputs: [u1[N * m], u2[N * m], u3[N * m], u4[N * m], u5[N * m], u6[N * m], u7[N * m], u8[N * m]],
    outputs: [reactions(fore_left_x, fore_left_y, fore_left_z, fore_right, hind_across, hind_right)]
);

/// Near the stance: thighs lean back and shanks forward, the left hind foot is lifted.
macro_rules! near {
    ($state:ty) => {{
        let mut rate = <$state as State>::Rate::default();
        rate.0[2] = 0.256;
        rate.0[6..14].copy_from_slice(&[0.9, 0.9, 0.9, 0.9, -1.1, -1.1, -1.6, -1.1]);
        <$state>::default().moved(&rate)
    }};
}

fn main() {
    let (standing, driven) = (Standing::default(), Driven::default());
    let mut state = near!(StandingState);
    standing
        .project(0.0, &mut state, &())
        .expect("the feet reach the ground");
    let found = standing.inverse(0.0, &state, &StandingAcceleration::default(), &());
    let torques = [
        found.t1, found.t2, found.t3, found.t4, found.t5, found.t6, found.t7, found.t8,
    ];
    println!("torques, N m      fore left  fore right   hind left  hind right");
    for (name, four) in ["hips", "knees"].into_iter().zip(torques.chunks(4)) {
        println!(
            "  {name:10} {:12.4}{:12.4}{:12.4}{:12.4}",
            four[0], four[1], four[2], four[3]
        );
    }

    let [u1, u2, u3, u4, u5, u6, u7, u8] = torques;
    let input = DrivenInput {
        u1,
        u2,
        u3,
        u4,
        u5,
        u6,
        u7,
        u8,
    };
    let mut same = near!(DrivenState);
    driven
        .project(0.0, &mut same, &input)
        .expect("the same feet");
    let moved = driven.acceleration(0.0, &same, &input);
    let fastest = same
        .rate(&moved)
        .0
        .into_iter()
        .fold(0.0, |worst: f64, one| worst.max(one.abs()));
    println!("accelerations: at most {fastest:.1e}");
    assert!(fastest < 1e-10);

    let ground = driven.reactions(0.0, &same, &input);
    let [fore_left, fore_right, hind_right] =
        [ground.fore_left_z, ground.fore_right, ground.hind_right];
    println!(
        "ground, N: fore left {fore_left:.4}, fore right {fore_right:.4}, hind right {hind_right:.4}"
    );
    let weight = (6.0 + 4.0 * (0.6 + 0.2)) * 9.81;
    assert!((fore_left + fore_right + hind_right - weight).abs() < 1e-11);
    assert!(
        ground
            .fore_left_x
            .abs()
            .max((ground.fore_left_y + ground.hind_across).abs())
            < 1e-11
    );

    // virtual work: along motions that the feet allow, each torque moves only its own joint
    let height = |state: &StandingState| standing.potential_energy(0.0, state, &());
    let mut worst = 0.0_f64;
    for joint in 0..8 {
        let nudged = |size: f64| {
            let mut rate = <StandingState as State>::Rate::default();
            rate.0[6 + joint] = size;
            let mut state = state.moved(&rate);
            standing.project(0.0, &mut state, &()).expect("near by");
            state
        };
        let (less, more) = (nudged(-1e-4), nudged(1e-4));
        let angles = |state: &StandingState| {
            let hips = [&state.hip_fl, &state.hip_fr, &state.hip_hl, &state.hip_hr];
            let knees = [
                &state.knee_fl,
                &state.knee_fr,
                &state.knee_hl,
                &state.knee_hr,
            ];
            [hips, knees]
                .concat()
                .into_iter()
                .map(|one| one.angle)
                .collect::<Vec<f64>>()
        };
        let turned = angles(&more).into_iter().zip(angles(&less));
        let work: f64 = turned
            .zip(torques)
            .map(|((more, less), torque)| torque * (more - less))
            .sum();
        worst = worst.max((work - height(&more) + height(&less)).abs() / 2e-4);
    }
    println!("virtual work and gain of energy differ by at most {worst:.1e} J per rad");
    assert!(worst < 1e-6);
}
