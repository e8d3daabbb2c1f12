//! Systems that do not move: overconstrained mechanisms, and structures.

use newton_euler::prelude::*;

use super::compare::close;

/// A plane four-bar in space stands on a foot, which carries what it weighs, whatever the hinges hold.
mod held {
    use newton_euler::prelude::*;

    rigid_system!(Standing {
        bodies: [
            base {
                mass: 2[kg],
                inertia: principal(1, 1, 1)[kg * m ^ 2],
                points: [side = (1, 0, 0)[m]],
            },
            crank {
                mass: 1[kg],
                inertia: principal(0.1, 0.2, 0.3)[kg * m ^ 2],
                points: [o = (0, 0, 0)[m], a = (0.3, 0.4, 0)[m]],
            },
            coupler {
                mass: 1.5[kg],
                inertia: principal(0.1, 0.2, 0.3)[kg * m ^ 2],
                points: [a = (0, 0, 0)[m], b = (0.6, 0.8, 0)[m]],
            },
            rocker {
                mass: 0.5[kg],
                inertia: principal(0.1, 0.2, 0.3)[kg * m ^ 2],
                points: [b = (0, 0, 0)[m], c = (0.1, -1.2, 0)[m]],
            },
        ],
        joints: [
            foot = weld(world(0, 0, 0), base.G),
            o = revolute(base.G, crank.o, body(0, 0, 1)),
            a = revolute(crank.a, coupler.a, body(0, 0, 1)),
            b = revolute(coupler.b, rocker.b, body(0, 0, 1)),
            c = revolute(base.side, rocker.c, body(0, 0, 1)),
        ],
        fields: [weight = mass * world(0, 0, -9.8[m / s ^ 2])],
        outputs: [reactions(foot)],
    });

    // statics: two bodies that three hinges hold, by the same joints
    rigid_system!(Arch {
        motion: planar,
        bodies: [
            left {
                mass: 1[kg],
                inertia: 1[kg * m ^ 2],
                points: [a = (0, 0)[m], c = (4, 3)[m], load = (1.5, 2)[m]],
                forces: [wind = world(6[N], -20[N]).at(load)],
            },
            right {
                mass: 1[kg],
                inertia: 1[kg * m ^ 2],
                points: [b = (2, -3)[m], c = (-2, 0)[m], load = (0, -0.8)[m]],
                forces: [snow = world(0, -30[N]).at(load)],
                moments: [couple = 5[N * m]],
            },
        ],
        joints: [
            a = revolute(world(0, 0), left.a),
            c = revolute(left.c, right.c),
            b = revolute(world(8, 0), right.b),
        ],
        outputs: [reactions],
    });
}

#[test]
fn what_is_held_too_much_gives_what_is_determined() {
    let standing = held::Standing::default();
    let mut state = held::StandingState::default();
    standing.project(0.0, &mut state, &()).unwrap();
    let foot = standing.reactions(0.0, &state, &()).foot;
    close(
        "foot",
        foot.force.as_slice(),
        &[0.0, 0.0, 5.0 * 9.8],
        10.0,
        1e-13,
    );
    let found = standing.acceleration(0.0, &state, &());
    assert!(
        [found.o, found.a, found.b]
            .iter()
            .all(|one| one.abs() < 1e-12)
    );
}

// reference/systems/three_hinged_arch.json: six balances, exact rationals
#[test]
fn an_arch_on_three_hinges() {
    let (arch, state) = (held::Arch::default(), held::ArchState::default());
    arch.check(0.0, &state, &()).unwrap();
    let found = arch.acceleration(0.0, &state, &());
    assert!(found.a.abs().max(found.c.abs()) < 1e-13);
    let loads = arch.reactions(0.0, &state, &());
    close(
        "a",
        loads.a.force.as_slice(),
        &[11.833_333_333_333_334, 22.875],
        10.0,
        1e-14,
    );
    close(
        "b",
        loads.b.force.as_slice(),
        &[-17.833_333_333_333_332, 27.125],
        10.0,
        1e-14,
    );
    close(
        "c",
        loads.c.force.as_slice(),
        &[17.833_333_333_333_332, 2.875],
        10.0,
        1e-14,
    );
}

/// A structure that is started with velocities stands still after projection, which `check` accepts.
#[test]
fn what_cannot_move_stops() {
    let arch = held::Arch::default();
    for speed in [0.1, 0.3, 7.0, 1e-120, 1e-200] {
        let mut state = held::ArchState::default();
        state.a.angular_velocity = speed;
        state.c.angular_velocity = -0.2 * speed;
        arch.project(0.0, &mut state, &()).unwrap();
        arch.check(0.0, &state, &()).unwrap();
        assert!(state.a.angular_velocity.abs() < 1e-138);
        let end = arch.integrate(&state).to(1.0).unwrap();
        assert!((end.a.angle - state.a.angle).abs() < 1e-12);
    }
}
