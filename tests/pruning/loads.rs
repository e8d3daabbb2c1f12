//! Pruning rules for the loads.

use crate::AT_G;
use crate::reference::{Body, Scene, Support, World, force, moment, principal};
use crate::row;
use crate::table::Row;

row!(
    merged_loads,
    FourJets,
    |_| (),
    |_, ()| Scene {
        support: Support::Free,
        mass: 2.0,
        inertia: principal([1.3, 1.7, 2.1]),
        pushes: vec![
            force(Body, [1.5, 2.2, 3.0], [0.1, 0.2, -0.3]),
            force(Body, [-2.0, 1.0, 0.5], [0.4, 0.0, 0.1]),
            force(Body, [0.0, 0.5, -1.0], [-0.2, 0.3, 0.0]),
            force(Body, [3.0, -1.0, 2.0], [0.0, -0.5, 0.2])
        ]
    },
    Row {
        rule: "R10",
        before: 310,
        after: [21, 15, 0],
        skipped: &["4 loads one by one: constant in body axes, they are one \
                   force and one moment"]
    }
);
row!(
    constant_moment,
    Turned,
    |_| (),
    |_, ()| Scene {
        support: AT_G,
        mass: 1.0,
        inertia: principal([1.3, 1.7, 2.1]),
        pushes: vec![moment(Body, [0.3, -0.2, 0.5])]
    },
    Row {
        rule: "R11",
        before: 202,
        after: [6, 3, 0],
        skipped: &["constant moments in the balance: over the inertia they \
                   are constants"]
    }
);
row!(
    forces_through_g,
    Central,
    |random| crate::bodies::CentralInput {
        push: random.vector(3.0),
        thrust: random.number()
    },
    |_, input| Scene {
        support: Support::Free,
        mass: 2.0,
        inertia: principal([1.3, 1.7, 2.1]),
        pushes: vec![
            force(World, input.push.into(), [0.0; 3]),
            force(Body, [input.thrust, 0.0, 0.0], [0.3, 0.0, 0.0])
        ]
    },
    Row {
        rule: "R12",
        before: 253,
        after: [19, 7, 0],
        skipped: &[
            "the moment of `pushed`: it acts at G",
            "the moment of `engine`: it acts along a line through G"
        ]
    }
);
row!(
    weight,
    Thrown,
    |_| (),
    |_, ()| Scene {
        support: Support::Free,
        mass: 2.0,
        inertia: principal([1.3, 1.7, 2.1]),
        pushes: vec![force(World, [0.0, 0.0, -19.6], [0.0; 3])]
    },
    Row {
        rule: "R13",
        before: 217,
        after: [6, 0, 0],
        skipped: &[
            "the moment of `weight`: it acts at G",
            "the mass: it cancels in the accelerations"
        ]
    }
);
row!(
    charges,
    Charged,
    |_| (),
    |_, ()| Scene {
        support: Support::Free,
        mass: 2.0,
        inertia: principal([1.3, 1.7, 2.1]),
        pushes: vec![
            force(World, [1.25, -0.625, 2.375], [0.1, 0.2, -0.3]),
            force(World, [-0.5, 0.25, -0.95], [0.4, -0.1, 0.25]),
            force(World, [1.125, -0.5625, 2.1375], [-0.15, 0.05, 0.35])
        ]
    },
    Row {
        rule: "R14",
        before: 319,
        after: [27, 18, 0],
        skipped: &["the 3 charges of `electric` one by one: they are one \
                   charge and one dipole"]
    }
);
row!(
    one_row_of_the_rotation,
    Top,
    |_| (),
    |_, ()| Scene {
        support: Support::Point([0.0, 0.0, -0.3]),
        mass: 2.0,
        inertia: principal([1.12, 1.12, 0.7]),
        pushes: vec![force(World, [0.0, 0.0, -19.6], [0.0; 3])]
    },
    Row {
        rule: "R15",
        before: 217,
        after: [9, 4, 0],
        skipped: &["two rows of the rotation: what turns is along z in world \
                   axes"]
    }
);
row!(
    one_column_of_the_rotation,
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
        rule: "R16",
        before: 253,
        after: [14, 6, 0],
        skipped: &["two columns of the rotation: what turns is along z in \
                   body axes"]
    }
);
row!(
    weight_alone,
    Pendulum,
    |_| (),
    |_, ()| Scene {
        support: Support::Axis([0.0, 0.4, 0.0], [0.0, 0.0, 1.0]),
        mass: 2.0,
        inertia: principal([0.32 / 3.0; 3]),
        pushes: vec![force(World, [0.0, -19.6, 0.0], [0.0; 3])]
    },
    Row {
        rule: "R28",
        before: 190,
        after: [1, 0, 1],
        skipped: &["the mass: it cancels in the accelerations"]
    }
);
row!(
    couple,
    Couple,
    |_| (),
    |_, ()| Scene {
        support: Support::Free,
        mass: 2.0,
        inertia: principal([1.3, 1.7, 2.1]),
        pushes: vec![
            force(Body, [0.0, 3.0, 1.0], [-0.3, 0.0, 0.1]),
            force(Body, [0.0, -3.0, -1.0], [0.3, 0.2, 0.0])
        ]
    },
    Row {
        rule: "R32",
        before: 238,
        after: [6, 3, 0],
        skipped: &["the acceleration of G: the sum of the forces is zero"]
    }
);
