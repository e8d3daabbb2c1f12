//! Solids about their centers of mass, given by their dimensions.

use proc_macro2::Ident;

/// A solid about its center of mass, in its principal axes; z is the axis of symmetry.
pub struct Solid {
    pub word: &'static str,
    /// The names of its dimensions.
    pub lengths: &'static [&'static str],
    /// For the moments about x, y and z, per mass: the factors of the squares of the dimensions.
    pub moments: [&'static [(i64, u64)]; 3],
    /// The dimension that must be smaller than another one, and why.
    pub smaller: Option<(usize, usize, &'static str)>,
}

/// All solids. Those without a thickness argument are thin.
pub const SOLIDS: [Solid; 10] = [
    Solid {
        word: "cuboid",
        lengths: &["a", "b", "c"],
        moments: [
            &[(0, 1), (1, 12), (1, 12)],
            &[(1, 12), (0, 1), (1, 12)],
            &[(1, 12), (1, 12), (0, 1)],
        ],
        smaller: None,
    },
    Solid {
        word: "sphere",
        lengths: &["r"],
        moments: [&[(2, 5)]; 3],
        smaller: None,
    },
    Solid {
        word: "shell",
        lengths: &["r"],
        moments: [&[(2, 3)]; 3],
        smaller: None,
    },
    Solid {
        word: "cylinder",
        lengths: &["r", "h"],
        moments: [&[(1, 4), (1, 12)], &[(1, 4), (1, 12)], &[(1, 2), (0, 1)]],
        smaller: None,
    },
    Solid {
        word: "tube",
        lengths: &["r1", "r2", "h"],
        moments: [
            &[(1, 4), (1, 4), (1, 12)],
            &[(1, 4), (1, 4), (1, 12)],
            &[(1, 2), (1, 2), (0, 1)],
        ],
        smaller: Some((0, 1, "the inner radius comes first and is the smaller one")),
    },
    Solid {
        word: "cone",
        lengths: &["r", "h"],
        moments: [&[(3, 20), (3, 80)], &[(3, 20), (3, 80)], &[(3, 10), (0, 1)]],
        smaller: None,
    },
    Solid {
        word: "ellipsoid",
        lengths: &["a", "b", "c"],
        moments: [
            &[(0, 1), (1, 5), (1, 5)],
            &[(1, 5), (0, 1), (1, 5)],
            &[(1, 5), (1, 5), (0, 1)],
        ],
        smaller: None,
    },
    Solid {
        word: "rod",
        lengths: &["l"],
        moments: [&[(1, 12)], &[(1, 12)], &[(0, 1)]],
        smaller: None,
    },
    Solid {
        word: "disc",
        lengths: &["r"],
        moments: [&[(1, 4)], &[(1, 4)], &[(1, 2)]],
        smaller: None,
    },
    Solid {
        word: "torus",
        lengths: &["R", "r"],
        moments: [&[(1, 2), (5, 8)], &[(1, 2), (5, 8)], &[(1, 1), (3, 4)]],
        smaller: Some((
            1,
            0,
            "the radius of the ring comes first, that of its tube is smaller",
        )),
    },
];

/// The words of all solids.
pub fn words() -> impl Iterator<Item = &'static str> {
    SOLIDS.iter().map(|solid| solid.word)
}

pub fn is_solid(word: &Ident) -> bool {
    words().any(|solid| word == solid)
}
