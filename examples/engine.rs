//! A slider-crank engine: the forces in its bearings over one turn.
//!
//! A `driven` joint turns the crank at constant speed; the guide of the piston closes
//! the loop of ground, crank, rod and piston. At each angle `project` closes the loop, and the
//! balances give the forces of all bearings and the torque on the crank.
//!
//! Asserts: the work of the torque is the energy gained by the engine, to rounding; over a
//! whole turn without gas it is zero; the position of the piston agrees with geometry.

use newton_euler::prelude::*;

rigid_system!(Engine {
    doc: "Crank, rod and piston; angles counterclockwise, the piston moves along x.",
    motion: planar,
    params: [speed = 300[rad / s], gas = 1500[N]],
    bodies: [
        crank {
            mass: 1.8[kg],
            inertia: 0.0025[kg * m ^ 2],
            points: [main = (-0.015, 0)[m], pin = (0.035, 0)[m]],
        },
        rod {
            mass: 0.9[kg],
            inertia: 0.0031[kg * m ^ 2],
            points: [big_end = (-0.045, 0)[m], small_end = (0.115, 0)[m]],
        },
        piston {
            mass: 0.65[kg],
            inertia: 0.001[kg * m ^ 2],
            forces: [pressure = world(-gas, 0)],
        },
    ],
    joints: [
        main = revolute(world(0, 0), crank.main).driven(speed * t),
        big_end = revolute(crank.pin, rod.big_end),
        small_end = revolute(rod.small_end, piston.G),
        guide = prismatic(world(0, 0), piston.G, body(1, 0)),
    ],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    outputs: [reactions, energy],
});

const CRANK: f64 = 0.05;
const ROD: f64 = 0.16;

/// The state in which the rod points to the piston at this time, by geometry.
fn assembled(engine: &Engine, time: f64) -> EngineState {
    let (angle, rate) = (engine.params().speed * time, engine.params().speed);
    let lean = -(CRANK * angle.sin() / ROD).asin();
    let lean_rate = -CRANK * angle.cos() * rate / (ROD * lean.cos());
    EngineState {
        big_end: Hinge {
            angle: lean - angle,
            angular_velocity: lean_rate - rate,
        },
        small_end: Hinge {
            angle: -lean,
            angular_velocity: -lean_rate,
        },
    }
}

fn main() {
    let engine = Engine::default();
    let turn = core::f64::consts::TAU / engine.params().speed;
    println!("at 300 rad/s, a gas force of 1500 N: N, N m");
    println!("  crank    main bearing      big end   small end       guide      torque");
    let mut state = assembled(&engine, 0.0);
    for step in 0..=12 {
        let time = turn * f64::from(step) / 12.0;
        // from the last state, which is a twelfth of a turn away
        engine
            .project(time, &mut state, &())
            .expect("the loop closes at each angle");
        let exact = assembled(&engine, time);
        let off = (state.small_end.angle.sin() - exact.small_end.angle.sin()).abs();
        assert!(off < 1e-12, "{off:e}");
        let found = engine.reactions(time, &state, &());
        println!(
            "  {:4}°  {:12.1} {:12.1} {:11.1} {:11.1} {:11.2}",
            30 * step,
            found.main.force.norm(),
            found.big_end.force.norm(),
            found.small_end.force.norm(),
            found.guide.force.y,
            found.main_drive
        );
    }

    // the power of the torque and of the gas is the rate of energy
    let energy = |time: f64, state: &EngineState| {
        engine.kinetic_energy(time, state, &()) + engine.potential_energy(time, state, &())
    };
    let mut worst: f64 = 0.0;
    for step in 0..24 {
        let (time, short) = (turn * f64::from(step) / 24.0, 1e-7);
        let [before, now, after] =
            [time - short, time, time + short].map(|time| assembled(&engine, time));
        let gained = (energy(time + short, &after) - energy(time - short, &before)) / (2.0 * short);
        let torque = engine.reactions(time, &now, &()).main_drive;
        let place = |state: &EngineState, time: f64| {
            let angle = engine.params().speed * time;
            let lean = -state.small_end.angle;
            CRANK * angle.cos() + ROD * lean.cos()
        };
        let piston = (place(&after, time + short) - place(&before, time - short)) / (2.0 * short);
        let power = torque * engine.params().speed - engine.params().gas * piston;
        worst = worst.max((power - gained).abs());
    }
    println!("\npower and gain of energy differ by at most {worst:.1e} W of some 5e4 W");
    assert!(worst < 0.1);

    // without gas and weight a turn takes no work
    let idle = Engine::new(EngineParams {
        gas: 0.0,
        ..EngineParams::default()
    })
    .expect("a valid engine");
    let count = 720;
    let work: f64 = (0..count)
        .map(|step| {
            let time = turn * f64::from(step) / f64::from(count);
            let torque = idle
                .reactions(time, &assembled(&idle, time), &())
                .main_drive;
            torque * core::f64::consts::TAU / f64::from(count)
        })
        .sum();
    println!("work of a turn without gas: {work:.1e} J");
    assert!(work.abs() < 1e-9);
}
