//! F04: an isolated body under eight families of loads, described in three ways and about three
//! poles.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use nalgebra::Vector2;
use newton_euler::prelude::*;

use crate::reference::{number, planar, statement};

/// Numbers, points of the body, pole G.
mod baked {
    newton_euler::rigid_body!(Isolated {
        motion: planar,
        mass: 4.5[kg],
        inertia: 0.62[kg * m ^ 2],
        points: [
            pin = (-0.71, 0.27),
            joint = (0.34, 0.37),
            tip = (-0.21, -0.33)
        ],
        reactions: [
            support = body(12.5, -3.25)[N].at(pin),
            clamp = moment(0.75[N * m]),
        ],
        joint_forces: [link = world(-7.75, 18.5)[N].at(joint)],
        joint_moments: [hinge = -1.125[N * m]],
        forces: [push = body(2.125, 5.5)[N].at(tip)],
        moments: [motor = 2.25[N * m]],
        fields: [
            weight = mass * world(0, -9.80665[m / s ^ 2]),
            magnet = moment(-0.03125[N * m]),
        ],
        outputs: [balance],
    });
}

/// Parameters, points in space, pole at the world origin.
mod parametric {
    newton_euler::rigid_body!(Isolated {
        motion: planar,
        params: [
            m = 4.5[kg],
            j = 0.62[kg * m ^ 2],
            r_v = world(12.5, -3.25)[N],
            m_v = 0.75[N * m],
            f_s = world(-7.75, 18.5)[N],
            m_s = -1.125[N * m],
            f_ext = body(2.125, 5.5)[N],
            m_ext = 2.25[N * m],
            g = world(0, -9.80665)[m / s ^ 2],
            m_f = -0.03125[N * m],
            pin = world(-0.4, 0.1)[m],
        ],
        mass: m,
        inertia: j,
        points: [joint = world(0.65, 0.2), tip = world(0.1, -0.5)],
        reactions: [support = r_v.at(pin), clamp = moment(m_v)],
        joint_forces: [link = f_s.at(joint)],
        joint_moments: [hinge = m_s],
        forces: [push = f_ext.at(tip)],
        moments: [motor = m_ext],
        fields: [weight = (mass * g).at(G), magnet = moment(m_f)],
        pole: world(0, 0),
        outputs: [balance],
    });
}

/// Inputs, far pole.
mod driven {
    newton_euler::rigid_body!(Isolated {
        motion: planar,
        inputs: [
            r_v = world(_, _)[N],
            m_v[N * m],
            f_s = world(_, _)[N],
            m_s[N * m],
            f_ext = body(_, _)[N],
            m_ext[N * m],
            f_f = world(_, _)[N],
            m_f[N * m],
        ],
        mass: 4.5[kg],
        inertia: 0.62[kg * m ^ 2],
        points: [
            pin = (-0.71, 0.27),
            joint = world(0.65, 0.2),
            tip = (-0.21, -0.33),
            far = world(1e6, -2.5e6),
        ],
        reactions: [support = r_v.at(pin), clamp = moment(m_v)],
        joint_forces: [link = f_s.at(joint)],
        joint_moments: [hinge = m_s],
        forces: [push = f_ext.at(tip)],
        moments: [motor = m_ext],
        fields: [weight = f_f, magnet = moment(m_f)],
        pole: far,
        outputs: [balance],
    });
}

fn input() -> driven::IsolatedInput {
    let given = statement("F04 planar residuals (1.3),(1.4)");
    let [f, k] = [&given["forces(F;P)"], &given["torques"]];
    driven::IsolatedInput {
        r_v: planar(&f["Rv"][0]),
        m_v: number(&k["Mv"]),
        f_s: planar(&f["Fs"][0]),
        m_s: number(&k["Ms"]),
        f_ext: planar(&f["Fext"][0]),
        m_ext: number(&k["Mext"]),
        f_f: planar(&f["Ff"][0]),
        m_f: number(&k["Mf"]),
    }
}

fn state() -> Planar {
    Planar {
        position: Vector2::new(0.31, -0.17),
        angle: 0.0,
        velocity: Vector2::new(4.0, 5.0),
        angular_velocity: -7.0,
    }
}

fn given_motion() -> PlanarAcceleration {
    PlanarAcceleration {
        linear: Vector2::new(1.3, -2.2),
        angular: 3.4,
    }
}

/// The residual of each body, in the order G, origin, far pole.
fn residuals(acceleration: &PlanarAcceleration) -> [PlanarWrench; 3] {
    [
        baked::Isolated {}.residual(0.0, &state(), acceleration, &(), &()),
        parametric::Isolated::default().residual(0.0, &state(), acceleration, &(), &()),
        driven::Isolated {}.residual(0.0, &state(), acceleration, &(), &input()),
    ]
}

#[test]
fn residuals_about_three_poles() {
    let expected = statement("F04 planar residuals (1.3),(1.4)");
    let names = [
        "M about G",
        "M about origin",
        "M about far pole (1e6,-2.5e6)",
    ];
    // 1e-13 of the largest term: forces to 44 N, moments to 44 N at 1 m, or at 2.5e6 m.
    let largest = [44.0, 44.0, 44.0 * 2.5e6];
    let force = planar(&expected["R"]);
    for ((wrench, name), largest) in residuals(&given_motion()).iter().zip(names).zip(largest) {
        assert!((wrench.force - force).amax() <= 1e-13 * 44.0, "{wrench:?}");
        let moment = number(&expected[name]);
        assert!(
            (wrench.moment - moment).abs() <= 1e-13 * largest,
            "{name}: {wrench:?}"
        );
    }
}

#[test]
fn pole_law() {
    let [about_g, about_origin, about_far] = residuals(&given_motion());
    let [g, origin, far] =
        [[0.31, -0.17], [0.0, 0.0], [1e6, -2.5e6]].map(|pair: [f64; 2]| Vector2::from(pair));
    // M_O' = M_O + (O - O') x R
    let to_origin = about_g.moment + (g - origin).perp(&about_g.force);
    assert!((about_origin.moment - to_origin).abs() <= 1e-13 * 44.0);
    let to_far = about_origin.moment + (origin - far).perp(&about_origin.force);
    assert!((about_far.moment - to_far).abs() <= 1e-13 * 44.0 * 2.5e6);
}

#[test]
fn the_true_motion_balances_about_every_pole() {
    let a = baked::Isolated {}.acceleration(0.0, &state(), &());
    let of_params = parametric::Isolated::default().acceleration(0.0, &state(), &());
    let of_inputs = driven::Isolated {}.acceleration(0.0, &state(), &input());
    // From the residual R = ΣF - m a of the given motion.
    let linear = Vector2::new(1.025, -13.479_925) / 4.5 + given_motion().linear;
    let angular = 7.372 / 0.62 + given_motion().angular;
    for a in [a, of_params, of_inputs] {
        assert!((a.linear - linear).amax() <= 1e-13 * 44.0 / 4.5, "{a:?}");
        assert!((a.angular - angular).abs() <= 1e-13 * 44.0 / 0.62, "{a:?}");
        for (wrench, arm) in residuals(&a).iter().zip([1.0, 1.0, 2.5e6]) {
            assert!(wrench.force.amax() <= 1e-13 * 44.0, "{wrench:?}");
            assert!(wrench.moment.abs() <= 1e-13 * 44.0 * arm, "{wrench:?}");
        }
    }
}

#[test]
fn each_load_by_its_family() {
    let given = statement("F04 planar residuals (1.3),(1.4)");
    let forces = [
        ("support", "Rv"),
        ("link", "Fs"),
        ("push", "Fext"),
        ("weight", "Ff"),
    ];
    let moments = [
        ("clamp", "Mv"),
        ("hinge", "Ms"),
        ("motor", "Mext"),
        ("magnet", "Mf"),
    ];
    let family = |name: &str| match name {
        "support" | "clamp" => Family::Reaction,
        "link" | "hinge" => Family::Joint,
        "push" | "motor" => Family::External,
        _ => Family::Field,
    };
    for loads in [
        baked::Isolated {}.loads(0.0, &state(), &()),
        parametric::Isolated::default().loads(0.0, &state(), &()),
        driven::Isolated {}.loads(0.0, &state(), &input()),
    ] {
        assert_eq!(loads.len(), 8);
        let find = |name| loads.iter().find(|load| load.name == name).unwrap();
        for (name, key) in forces {
            let load = find(name);
            assert_eq!(load.family, family(name));
            let [force, point] = [0, 1].map(|i| planar(&given["forces(F;P)"][key][i]));
            // One rounding of the mass times gravity, and of G plus an offset.
            assert!((load.force - force).amax() <= 1e-14, "{load:?}");
            assert!((load.point - point).amax() <= 1e-15, "{load:?}");
            assert_eq!(load.moment, 0.0);
        }
        for (name, key) in moments {
            let load = find(name);
            assert_eq!(load.family, family(name));
            assert_eq!(load.force, Vector2::zeros());
            assert_eq!(load.moment, number(&given["torques"][key]));
        }
    }
}

#[test]
fn applied_is_the_resultant_about_the_center() {
    let given = statement("F04 planar residuals (1.3),(1.4)");
    let g = state().position;
    let (mut force, mut moment) = (Vector2::zeros(), 0.0);
    for key in ["Rv", "Fs", "Fext", "Ff"] {
        let [f, p] = [0, 1].map(|i| planar(&given["forces(F;P)"][key][i]));
        force += f;
        moment += (p - g).perp(&f);
    }
    for key in ["Mv", "Ms", "Mext", "Mf"] {
        moment += number(&given["torques"][key]);
    }
    for wrench in [
        baked::Isolated {}.applied(0.0, &state(), &()),
        parametric::Isolated::default().applied(0.0, &state(), &()),
        driven::Isolated {}.applied(0.0, &state(), &input()),
    ] {
        assert!((wrench.force - force).amax() <= 1e-13 * 44.0, "{wrench:?}");
        assert!((wrench.moment - moment).abs() <= 1e-13 * 44.0, "{wrench:?}");
    }
}
