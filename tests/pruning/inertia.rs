//! Pruning rules for the inertia.

use crate::AT_G;
use crate::reference::{Body, Scene, World, moment, principal};
use crate::row;
use crate::table::Row;

row!(
    principal_axes_of_its_own,
    Tilted,
    |_| (),
    |_, ()| Scene {
        support: AT_G,
        mass: 1.0,
        inertia: [[1.3, 0.1, 0.12], [0.1, 1.7, -0.2], [0.12, -0.2, 2.1]],
        pushes: vec![]
    },
    Row {
        rule: "R1",
        before: 166,
        after: [18, 12, 0],
        skipped: &["products of inertia: in the principal axes there are none"]
    }
);
row!(
    spherical_gauge,
    Full,
    |random| crate::bodies::FullInput {
        couple: random.vector(3.0)
    },
    |_, input| Scene {
        support: AT_G,
        mass: 1.0,
        inertia: [[1.3, 0.1, 0.12], [0.1, 1.7, -0.2], [0.12, -0.2, 2.1]],
        pushes: vec![moment(Body, input.couple.into())]
    },
    Row {
        rule: "R2",
        before: 202,
        after: [23, 17, 0],
        skipped: &["lambda w of J w: it is along w, and not in w x J w"]
    }
);
row!(
    products_that_are_zero,
    OneProduct,
    |_| (),
    |_, ()| Scene {
        support: AT_G,
        mass: 1.0,
        inertia: [[1.3, 0.12, 0.0], [0.12, 1.7, 0.0], [0.0, 0.0, 2.1]],
        pushes: vec![]
    },
    Row {
        rule: "R3",
        before: 166,
        after: [10, 4, 0],
        skipped: &["terms of J_yz: it is zero", "terms of J_zx: it is zero"]
    }
);
row!(
    principal_axes,
    Driven,
    |random| crate::bodies::DrivenInput {
        couple: random.vector(3.0)
    },
    |_, input| Scene {
        support: AT_G,
        mass: 1.0,
        inertia: principal([1.3, 1.7, 2.1]),
        pushes: vec![moment(Body, input.couple.into())]
    },
    Row {
        rule: "R4",
        before: 202,
        after: [9, 3, 0],
        skipped: &["products of inertia: the axes are principal"]
    }
);
row!(
    symmetric_body,
    Symmetric,
    |_| (),
    |_, ()| Scene {
        support: AT_G,
        mass: 1.0,
        inertia: principal([1.7, 2.1, 1.7]),
        pushes: vec![]
    },
    Row {
        rule: "R6",
        before: 166,
        after: [3, 0, 0],
        skipped: &[
            "(w x J w)_y: the other two moments of inertia are equal",
            "the angular acceleration about y: nothing turns the body \
                   about its axis of symmetry"
        ]
    }
);
row!(
    spherical_body,
    Ball,
    |random| crate::bodies::BallInput {
        couple: random.vector(3.0)
    },
    |_, input| Scene {
        support: AT_G,
        mass: 1.0,
        inertia: principal([2.0; 3]),
        pushes: vec![moment(World, input.couple.into())]
    },
    Row {
        rule: "R8",
        before: 217,
        after: [21, 12, 0],
        skipped: &["w x J w: all moments of inertia are equal"]
    }
);
