//! Pruning rules for what is described and requested: coordinates, outputs, parameters.

use crate::reference::{Body, Scene, Support, World, force, principal};
use crate::row;
use crate::table::Row;

row!(
    motion_in_the_plane,
    Glider,
    |_| (),
    |_, ()| Scene {
        support: Support::Axis([0.0; 3], [0.0, 0.0, 1.0]),
        mass: 2.0,
        inertia: principal([0.5; 3]),
        pushes: vec![
            force(Body, [3.0, 0.0, 0.0], [0.0; 3]),
            force(World, [0.0, -19.6, 0.0], [0.0; 3])
        ]
    },
    Row {
        rule: "R9",
        before: 226,
        after: [2, 1, 2],
        skipped: &["three equations out of the plane: the motion is planar"]
    }
);
row!(
    motion_without_turning,
    Slider,
    |random| crate::bodies::SliderInput {
        push: random.vector(3.0)
    },
    |_, input| Scene {
        support: Support::Guided,
        mass: 2.0,
        inertia: principal([1.0; 3]),
        pushes: vec![
            force(World, input.push.into(), [0.0; 3]),
            force(World, [0.0, 0.0, -19.6], [0.0; 3])
        ]
    },
    Row {
        rule: "R9",
        before: 185,
        after: [3, 1, 0],
        skipped: &["the moment balance: the body does not turn"]
    }
);
row!(
    attitude_that_nothing_reads,
    Thrown,
    |_| (),
    |_, ()| Scene {
        support: Support::Free,
        mass: 2.0,
        inertia: principal([1.3, 1.7, 2.1]),
        pushes: vec![force(World, [0.0, 0.0, -19.6], [0.0; 3])]
    },
    Row {
        rule: "R18",
        before: 217,
        after: [6, 0, 0],
        skipped: &["position, velocity, attitude: the accelerations do not \
                   depend on them"]
    }
);
row!(
    quadrature,
    Rocket,
    |_| (),
    |_, ()| Scene {
        support: Support::Free,
        mass: 2.0,
        inertia: principal([1.3, 1.7, 2.1]),
        pushes: vec![
            force(Body, [0.0, 0.0, 3.0], [0.1, 0.2, -0.3]),
            force(World, [0.0, 0.0, -19.6], [0.0; 3])
        ]
    },
    Row {
        rule: "R19",
        before: 253,
        after: [14, 6, 0],
        skipped: &["position, velocity: the accelerations do not depend on them"]
    }
);
row!(
    position_that_nothing_reads,
    Damped,
    |_| (),
    |c, ()| Scene {
        support: Support::Free,
        mass: 2.0,
        inertia: principal([1.3, 1.7, 2.1]),
        pushes: vec![force(World, (-0.5 * c.velocity).into(), [0.0; 3])]
    },
    Row {
        rule: "R20",
        before: 217,
        after: [9, 0, 0],
        skipped: &["position, attitude: the accelerations do not depend on them"]
    }
);
row!(
    outputs_that_nobody_asks_for,
    Rocket,
    |_| (),
    |_, ()| Scene {
        support: Support::Free,
        mass: 2.0,
        inertia: principal([1.3, 1.7, 2.1]),
        pushes: vec![
            force(Body, [0.0, 0.0, 3.0], [0.1, 0.2, -0.3]),
            force(World, [0.0, 0.0, -19.6], [0.0; 3])
        ]
    },
    Row {
        rule: "R21",
        before: 253,
        after: [14, 6, 0],
        skipped: &["energy, momentum, balance: not in `outputs`"]
    }
);
row!(
    one_equation_about_what_holds_the_body,
    Door,
    |random| crate::bodies::DoorInput {
        push: random.vector(3.0)
    },
    |_, input| Scene {
        support: Support::Axis([-0.4, 0.0, 0.0], [0.0, 0.0, 1.0]),
        mass: 2.0,
        inertia: [[1.3, 0.1, 0.12], [0.1, 1.7, -0.2], [0.12, -0.2, 2.1]],
        pushes: vec![force(Body, input.push.into(), [0.4, 0.1, 0.2])]
    },
    Row {
        rule: "R22, R25, R30",
        before: 175,
        after: [2, 1, 0],
        skipped: &["all balances but one: the reactions have no moment about \
                   the axis"]
    }
);
row!(
    reactions_that_nobody_asks_for,
    Door,
    |random| crate::bodies::DoorInput {
        push: random.vector(3.0)
    },
    |_, input| Scene {
        support: Support::Axis([-0.4, 0.0, 0.0], [0.0, 0.0, 1.0]),
        mass: 2.0,
        inertia: [[1.3, 0.1, 0.12], [0.1, 1.7, -0.2], [0.12, -0.2, 2.1]],
        pushes: vec![force(Body, input.push.into(), [0.4, 0.1, 0.2])]
    },
    Row {
        rule: "R26",
        before: 175,
        after: [2, 1, 0],
        skipped: &["energy, momentum, balance, reactions: not in `outputs`"]
    }
);
row!(
    one_sine_and_one_cosine,
    Sledge,
    |random| crate::bodies::SledgeInput {
        thrust: random.number()
    },
    |_, input| Scene {
        support: Support::Axis([0.0; 3], [0.0, 0.0, 1.0]),
        mass: 2.0,
        inertia: principal([0.5; 3]),
        pushes: vec![
            force(Body, [input.thrust, 1.0, 0.0], [-0.5, 0.2, 0.0]),
            force(World, [1.0, 2.0, 0.0], [0.6, 0.1, 0.0]),
            force(World, [3.0, -1.0, 0.0], [-0.5, 0.2, 0.0])
        ]
    },
    Row {
        rule: "R27",
        before: 277,
        after: [13, 13, 2],
        skipped: &[]
    }
);
row!(
    what_parameters_fix,
    Parametric,
    |random| crate::bodies::ParametricInput {
        push: random.vector(3.0)
    },
    |_, input| Scene {
        support: Support::Free,
        mass: 2.0,
        inertia: principal([1.3, 1.7, 2.1]),
        pushes: vec![
            force(Body, input.push.into(), [0.1, 0.2, -0.3]),
            force(World, [0.0, 0.0, -19.6], [0.0; 3])
        ]
    },
    Row {
        rule: "R29",
        before: 253,
        after: [33, 19, 0],
        skipped: &[]
    }
);
