//! Robots from the package example-robot-data, and a chain, from files that `compare.py` puts under
//! `target/peers`.

use newton_euler::prelude::*;

rigid_system!(Panda {
    urdf: "../../../target/peers/robot_panda.urdf",
    locked: [panda_finger_joint1 = 0, panda_finger_joint2 = 0],
    inputs: [
        t1[N * m],
        t2[N * m],
        t3[N * m],
        t4[N * m],
        t5[N * m],
        t6[N * m],
        t7[N * m]
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    drives: [
        m1 = t1.on(panda_joint1),
        m2 = t2.on(panda_joint2),
        m3 = t3.on(panda_joint3),
        m4 = t4.on(panda_joint4),
        m5 = t5.on(panda_joint5),
        m6 = t6.on(panda_joint6),
        m7 = t7.on(panda_joint7)
    ],
});

/// The input, from the drives of all freedoms.
pub fn panda(drives: &[f64]) -> PandaInput {
    let [t1, t2, t3, t4, t5, t6, t7] = *drives.as_array().expect("as many as joints");
    PandaInput {
        t1,
        t2,
        t3,
        t4,
        t5,
        t6,
        t7,
    }
}

rigid_system!(Solo12 {
    urdf: "../../../target/peers/robot_solo12.urdf",
    joints: [root = free(base_link)],
    inputs: [
        t1[N * m],
        t2[N * m],
        t3[N * m],
        t4[N * m],
        t5[N * m],
        t6[N * m],
        t7[N * m],
        t8[N * m],
        t9[N * m],
        t10[N * m],
        t11[N * m],
        t12[N * m]
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    drives: [
        m1 = t1.on(FL_HAA),
        m2 = t2.on(FL_HFE),
        m3 = t3.on(FL_KFE),
        m4 = t4.on(FR_HAA),
        m5 = t5.on(FR_HFE),
        m6 = t6.on(FR_KFE),
        m7 = t7.on(HL_HAA),
        m8 = t8.on(HL_HFE),
        m9 = t9.on(HL_KFE),
        m10 = t10.on(HR_HAA),
        m11 = t11.on(HR_HFE),
        m12 = t12.on(HR_KFE)
    ],
});

/// The input, from the drives of all freedoms.
pub fn solo(drives: &[f64]) -> Solo12Input {
    let [t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12] =
        *drives[..12].as_array().expect("as many as joints");
    Solo12Input {
        t1,
        t2,
        t3,
        t4,
        t5,
        t6,
        t7,
        t8,
        t9,
        t10,
        t11,
        t12,
    }
}

rigid_system!(Anymal {
    urdf: "../../../target/peers/robot_anymal.urdf",
    joints: [root = free(base)],
    inputs: [
        t1[N * m],
        t2[N * m],
        t3[N * m],
        t4[N * m],
        t5[N * m],
        t6[N * m],
        t7[N * m],
        t8[N * m],
        t9[N * m],
        t10[N * m],
        t11[N * m],
        t12[N * m]
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    drives: [
        m1 = t1.on(LF_HAA),
        m2 = t2.on(LF_HFE),
        m3 = t3.on(LF_KFE),
        m4 = t4.on(RF_HAA),
        m5 = t5.on(RF_HFE),
        m6 = t6.on(RF_KFE),
        m7 = t7.on(LH_HAA),
        m8 = t8.on(LH_HFE),
        m9 = t9.on(LH_KFE),
        m10 = t10.on(RH_HAA),
        m11 = t11.on(RH_HFE),
        m12 = t12.on(RH_KFE)
    ],
});

/// The input, from the drives of all freedoms.
pub fn anymal(drives: &[f64]) -> AnymalInput {
    let [t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12] =
        *drives[..12].as_array().expect("as many as joints");
    AnymalInput {
        t1,
        t2,
        t3,
        t4,
        t5,
        t6,
        t7,
        t8,
        t9,
        t10,
        t11,
        t12,
    }
}

rigid_system!(Chain {
    doc: "Sixty general bodies, each turning about another axis.",
    urdf: "../../../target/peers/chain60.urdf",
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
});
