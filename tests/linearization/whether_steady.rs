//! What counts as steady: unbalanced loads next to stiff ones, loads that cancel to rounding, masses
//! that vanish, and free quantities without effect at the start.

use core::f64::consts::FRAC_PI_2;

use newton_euler::linearization::TrimError;
use newton_euler::prelude::*;

rigid_body!(Stage {
    doc: "A stage on guides of any stiffness, along and across, with a push along.",
    motion: planar,
    params: [along = 0[N / m], across = 1e9[N / m], push = 0.5[N]],
    inputs: [hand[N]],
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    locals: [x = position.in_world().x, y = position.in_world().y],
    forces: [
        guide = world(-along * x, -across * y),
        wind = world(push, 0),
        other = world(0, hand)
    ],
    outputs: [linearization],
});

#[test]
fn a_stiff_spring_hides_no_load() {
    for stiffness in [1.0, 1e6, 1e9, 1e12] {
        for along in [0.0, stiffness] {
            let stage = Stage::new(StageParams {
                along,
                across: stiffness,
                ..StageParams::default()
            });
            let stage = stage.expect("parameters that are possible");
            let search = stage.trim(&Planar::default()).free(["hand"]);
            let error = search.solve().expect_err("it accelerates");
            let TrimError::Unbalanced { residual, held } = error else {
                panic!("{error}");
            };
            let off = residual[0].expect("something is off");
            assert_eq!((off.name, off.by), ("velocity_x", 0.5));
            assert_eq!(held[0], (along > 0.0).then_some("position_x"));
            // once it may yield, it does
            for start in [0.0, 1e-3, 1.0] {
                let mut at = Planar::default();
                at.position.x = start;
                let search = stage.trim(&at).free(["position_x"]);
                let found = search.solve();
                assert_eq!(found.is_ok(), along > 0.0);
                if let Ok(rest) = found {
                    assert!((rest.state.position.x * along / 0.5 - 1.0).abs() < 1e-13);
                }
            }
        }
    }
}

#[test]
fn a_position_is_known_to_rounding() {
    let stage = Stage::new(StageParams {
        along: 1e9,
        across: 1e9,
        push: 0.0,
    });
    let stage = stage.expect("parameters that are possible");
    let at = |x| {
        let mut at = Planar::default();
        at.position.x = x;
        stage.trim(&at).solve().is_ok()
    };
    assert!(at(0.1 + 0.2 - 0.3));
    assert!(!at(1e-12));
}

rigid_body!(Submarine {
    doc: "Neutrally buoyant: its weight and its buoyancy cancel, whatever the density.",
    motion: translation,
    params: [volume[m ^ 3], density = 1025[kg / m ^ 3]],
    inputs: [thrust[N]],
    mass: 12.3[kg],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [
        buoyancy = world(0, 0, density * volume * 9.81[m / s ^ 2]),
        engine = world(thrust, 0, 0),
        drag = world(-30[kg / m] * velocity.in_world().x * velocity.norm(), 0, 0),
    ],
    outputs: [linearization],
});

#[test]
fn loads_that_cancel_are_balanced_to_rounding() {
    for density in 950..1050 {
        let density = f64::from(density);
        let with = |mass: f64| {
            let volume = mass / density;
            let body = Submarine::new(SubmarineParams { volume, density });
            let body = body.expect("parameters that are possible");
            let search = body.trim(&Translation::default());
            search.free(["thrust"]).solve().is_ok()
        };
        assert!(with(12.3), "{density}");
        // a load of a millionth of the weight is one
        assert!(!with(12.3 * (1.0 + 1e-6)), "{density}");
    }
}

rigid_system!(Scales {
    doc: "A balance: equal masses on both arms, whose moments cancel; with a spring in its hinge.",
    motion: planar,
    params: [
        arm = 0.3[m],
        load = 0.7[kg],
        other = 0.7[kg],
        spring = 0[N * m]
    ],
    bodies: [
        beam {
            mass: 0.2[kg],
            inertia: 0.01[kg * m ^ 2],
            points: [left = (-arm, 0), right = (arm, 0)],
            forces: [pull = world(0, -other * 9.81[m / s ^ 2]).at(right)],
        },
        pan {
            mass: load,
            inertia: 1e-3[kg * m ^ 2]
        },
    ],
    joints: [
        hinge = revolute(world(0, 0), beam.G),
        hook = revolute(beam.left, pan.G)
    ],
    drives: [coil = (-spring * hinge.angle).on(hinge)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [linearization],
});

#[test]
fn moments_that_cancel_are_balanced_to_rounding() {
    for count in 0..100 {
        let load = 0.5 + 0.013 * f64::from(count);
        for spring in [0.0, 1e6] {
            let with = |other: f64| {
                let params = ScalesParams {
                    load,
                    other,
                    spring,
                    ..ScalesParams::default()
                };
                let scales = Scales::new(params).expect("parameters that are possible");
                scales.trim(&ScalesState::default()).solve().is_ok()
            };
            // a third of three times the load
            assert!(with((load + load + load) / 3.0), "{load}");
            assert!(!with(load * (1.0 + 1e-6)), "{load}");
        }
    }
}

rigid_body!(Lander {
    doc: "The fuel burns in proportion to the thrust.",
    motion: spatial,
    params: [empty = 10[kg]],
    inputs: [thrust[N]],
    states: [fuel[kg]],
    rates: [fuel = -0.01[kg / s / N] * thrust],
    mass: empty + fuel,
    inertia: sphere(0.5[m]),
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [engine = body(0, 0, thrust)],
    outputs: [linearization],
});

#[test]
fn no_mass_is_no_equilibrium() {
    for empty in [0.0, 10.0] {
        let lander = Lander::new(LanderParams { empty }).expect("parameters that are possible");
        for fuel in [1e-3, 5.0, 1e3] {
            let start = LanderState {
                fuel,
                ..LanderState::default()
            };
            let search = lander.trim(&start).free(["thrust", "fuel"]);
            let error = search.solve().expect_err("it burns fuel");
            let TrimError::Drifting { states, .. } = error else {
                panic!("{error}");
            };
            assert_eq!(states, [Some("fuel"), None, None]);
        }
    }
}

rigid_body!(Magnet {
    doc: "The lift of a current falls with the gap; the current also pulls it aside.",
    motion: translation,
    inputs: [current[A]],
    mass: 2[kg],
    locals: [gap = position.in_world().z],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [lift = world(-1[N / A] * current, 0, 1[N * m / A] * current / gap)],
    outputs: [linearization],
});

#[test]
fn no_gap_is_no_equilibrium() {
    let magnet = Magnet::default();
    for gap in [1.0, 5.0] {
        let mut start = Translation::default();
        start.position.z = gap;
        let search = magnet.trim(&start).free(["current", "position_z"]);
        let error = search.solve().expect_err("it is pulled aside");
        let TrimError::Singular { name, free } = error else {
            panic!("{error}");
        };
        assert_eq!((name, free.name), ("velocity_z", "position_z"));
        assert!(free.value.abs() < 1e-12);
        let text = error.to_string();
        let expected =
            "the search leads to where `velocity_z` changes without bound with `position_z`, near ";
        assert!(text.starts_with(expected), "{text}");
    }
}

rigid_body!(Rotorcraft {
    doc: "The lift of each rotor is proportional to the square of its speed.",
    motion: planar,
    inputs: [n_1[rad / s], n_2[rad / s]],
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [left = (-0.3, 0), right = (0.3, 0)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    forces: [
        lift_1 = body(0, 1e-4[kg * m] * n_1 * n_1).at(left),
        lift_2 = body(0, 1e-4[kg * m] * n_2 * n_2).at(right),
    ],
    outputs: [linearization],
});

#[test]
fn a_rotor_that_stands_has_no_effect() {
    let craft = Rotorcraft::default();
    let search = || craft.trim(&Planar::default()).free(["n_1", "n_2"]);
    let error = search().solve().expect_err("no slope tells the way");
    assert!(size_of_val(&error) <= 128);
    assert_eq!(
        error.to_string(),
        "not steady: `velocity_y` is off by -9.81 (SI units); `n_1` has no effect at 0, `n_2` has no effect at 0: start from other values"
    );
    let one = RotorcraftInput {
        n_1: 0.0,
        n_2: 10.0,
    };
    let error = search().input(&one).solve().expect_err("one does not do");
    let text = error.to_string();
    let expected = "; `n_1` has no effect at 0: start from another value";
    assert!(text.ends_with(expected), "{text}");
    for speed in [1e-6, 1.0, 100.0] {
        let input = RotorcraftInput {
            n_1: speed,
            n_2: speed,
        };
        let hover = search().input(&input).solve().expect("it hovers");
        let expected = (9.81_f64 / 1e-4).sqrt();
        assert!((hover.input.n_1 / expected - 1.0).abs() < 1e-14);
    }
    // an input that has no effect anywhere is not told to start elsewhere
    let stage = Stage::default();
    let error = stage.trim(&Planar::default()).free(["hand"]).solve();
    let error = error.expect_err("it accelerates");
    assert!(matches!(error, TrimError::Unbalanced { .. }), "{error}");
}

rigid_system!(Pendulums {
    doc: "An undamped double pendulum.",
    motion: planar,
    params: [length = 0.6[m], friction = 0[N * m * s]],
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [a = (-length / 2, 0), b = (length / 2, 0)],
        },
        lower {
            mass: 0.8[kg],
            inertia: 0.015[kg * m ^ 2],
            points: [a = (-0.22, 0)[m]]
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.a),
        elbow = revolute(upper.b, lower.a)
    ],
    drives: [rubbing = (-friction * elbow.angular_velocity).on(elbow)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    outputs: [linearization],
});

#[test]
fn an_undamped_pendulum_is_not_stable() {
    let mut hanging = PendulumsState::default();
    hanging.shoulder.angle = -FRAC_PI_2;
    for count in 0..100 {
        let length = 0.3 + 0.01 * f64::from(count);
        for friction in [0.0, 1e-9, -1e-9] {
            let body = Pendulums::new(PendulumsParams { length, friction });
            let body = body.expect("parameters that are possible");
            let rest = body.trim(&hanging).solve().expect("it hangs");
            let modes = rest.modes().expect("A is finite");
            assert_eq!((modes.len(), modes.neutral()), (2, 0));
            assert_eq!(modes.is_stable(), friction > 0.0, "{length} {friction}");
            let (half, double) = (friction > 0.0, friction < 0.0);
            for mode in modes.iter() {
                assert_eq!(mode.time_to_half().is_some(), half, "{mode:?}");
                assert_eq!(mode.time_to_double().is_some(), double, "{mode:?}");
            }
        }
    }
}

rigid_body!(Far {
    doc: "A body on a spring whose other end is far away, and a push.",
    motion: planar_translation,
    params: [push = 50[N]],
    mass: 1[kg],
    forces: [
        spring = -1e4[N / m] * (position - world(6.4e6, 0)[m]),
        pushed = world(push, 0),
    ],
    outputs: [linearization],
});

/// Terms that cancel to a part in 10⁹ of themselves hide no load that is far above their rounding.
#[test]
fn terms_that_cancel_hide_no_load() {
    let mut start = PlanarTranslation::default();
    start.position.x = 6.4e6;
    let found = Far::default().trim(&start).solve();
    let error = found.expect_err("it accelerates by 50 m/s²").to_string();
    assert!(error.contains("`velocity_x` is off by 50"), "{error}");
    let rest = Far::default().trim(&start).free(["position_x"]).solve();
    let rest = rest.expect("a rest nearby").state;
    assert!((rest.position.x - 6.4e6 - 0.005).abs() < 1e-8);
}
