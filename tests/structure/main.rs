//! The compiler's claims about the structure of a body, compared with its accelerations.
#![allow(missing_docs)]

use nalgebra::{Matrix3, Vector3};
use newton_euler::structure::{Dependence, Structure, Symmetry};

mod bodies;
mod claims;
#[path = "../coordinates/mod.rs"]
mod coordinates;
mod jumps;

#[allow(clippy::wildcard_imports, reason = "all of them")]
use bodies::*;
use claims::Claims;
use coordinates::{Coordinates, Random};

const Z: Symmetry = Symmetry::About([0.0, 0.0, 1.0]);
const NOTHING: Dependence = Dependence::NOTHING;

/// Of a body in space on which nothing acts.
const FREE: Structure = Structure {
    linear: NOTHING,
    angular: Dependence {
        angular_velocity: true,
        body: Symmetry::None,
        ..NOTHING
    },
    is_force_free: true,
    is_torque_free: true,
    keeps_spin: false,
    planes: [true; 3],
};

fn no_input(_: &mut Random) {}

/// `J w' + w x J w`
fn euler(c: &Coordinates, angular: Vector3<f64>, inertia: &Matrix3<f64>) -> Vector3<f64> {
    let w = c.angular_velocity;
    inertia * angular + w.cross(&(inertia * w))
}

/// The same with principal moments of inertia.
macro_rules! principal {
    ($($moment:literal),*) => {
        |c, angular| euler(c, angular, &Matrix3::from_diagonal(&Vector3::new($($moment),*)))
    };
}

/// Of a rod along x of the attitude, over its moment of inertia: `u'' + u'^2 u`.
fn held(c: &Coordinates, axis: Vector3<f64>) -> Vector3<f64> {
    let rate = c.angular_velocity.cross(&Vector3::x());
    axis + c.attitude * Vector3::x() * rate.norm_squared()
}

/// Of what has one moment of inertia, or none.
fn whole(_: &Coordinates, angular: Vector3<f64>) -> Vector3<f64> {
    angular
}

#[test]
fn free_bodies() {
    let weight = Dependence {
        world: Z,
        ..NOTHING
    };
    Claims {
        body: Thrown {},
        input: no_input,
        moment: principal!(1.3, 1.7, 2.1),
    }
    .are(Structure {
        linear: weight,
        is_force_free: false,
        planes: [true, true, false],
        ..FREE
    });
    Claims {
        body: Probe {},
        input: |random| ProbeInput {
            thrust: random.number(),
        },
        moment: principal!(1.3, 1.3, 0.7),
    }
    .are(Structure {
        linear: Dependence {
            attitude: true,
            input: true,
            body: Z,
            ..weight
        },
        angular: Dependence {
            body: Z,
            ..FREE.angular
        },
        is_force_free: false,
        keeps_spin: true,
        planes: [true, true, false],
        ..FREE
    });
    Claims {
        body: Tilted {},
        input: no_input,
        moment: |c, angular| {
            let tensor = Matrix3::new(1.82, 0.0, -0.24, 0.0, 2.0, 0.0, -0.24, 0.0, 1.68);
            euler(c, angular, &tensor)
        },
    }
    .are(Structure {
        angular: Dependence {
            body: Symmetry::About([0.6, 0.0, 0.8]),
            ..FREE.angular
        },
        keeps_spin: true,
        planes: [false, true, false],
        ..FREE
    });
    Claims {
        body: Glider {},
        input: no_input,
        moment: whole,
    }
    .are(Structure {
        linear: Dependence {
            attitude: true,
            world: Z,
            body: Symmetry::None,
            ..NOTHING
        },
        angular: Dependence {
            world: Z,
            body: Z,
            ..NOTHING
        },
        is_force_free: false,
        keeps_spin: true,
        planes: [false; 3],
        ..FREE
    });
}

#[test]
fn moments_and_inputs() {
    let given = Dependence {
        input: true,
        ..FREE.angular
    };
    Claims {
        body: Satellite {},
        input: |random| SatelliteInput {
            torque: random.vector(1.0),
        },
        moment: principal!(1.3, 1.7, 2.1),
    }
    .are(Structure {
        angular: given,
        is_torque_free: false,
        planes: [false; 3],
        ..FREE
    });
    let all_but_time = Dependence {
        attitude: true,
        velocity: true,
        input: true,
        world: Symmetry::None,
        body: Symmetry::None,
        ..NOTHING
    };
    Claims {
        body: Sail {},
        input: |random| SailInput {
            wind: random.vector(5.0),
        },
        moment: principal!(1.3, 1.7, 2.1),
    }
    .are(Structure {
        linear: Dependence {
            attitude: false,
            body: Symmetry::Every,
            ..all_but_time
        },
        angular: Dependence {
            angular_velocity: true,
            ..all_but_time
        },
        is_force_free: false,
        is_torque_free: false,
        keeps_spin: false,
        planes: [false; 3],
    });
    // through the origin and the post
    let of_post = Symmetry::About([
        0.267_261_241_912_424_4,
        0.534_522_483_824_848_8,
        0.801_783_725_737_273_2,
    ]);
    Claims {
        body: General::<f64>::default(),
        input: |random| GeneralInput {
            push: random.vector(5.0),
        },
        moment: principal!(1.3, 1.3, 1.3),
    }
    .are(Structure {
        linear: Dependence {
            position: true,
            velocity: false,
            world: of_post,
            ..all_but_time
        },
        angular: Dependence {
            velocity: false,
            world: of_post,
            states: false,
            ..Dependence::ALL
        },
        ..Structure::GENERAL
    });
}

#[test]
fn heavy_bodies() {
    let top = Top::new(TopParams {
        m: 2.0,
        l: 0.3,
        across: 1.3,
        along: 0.7,
    });
    let heavy = Dependence {
        attitude: true,
        world: Z,
        body: Z,
        ..FREE.angular
    };
    Claims {
        body: top.unwrap(),
        input: no_input,
        moment: principal!(1.3, 1.3, 0.7),
    }
    .are(Structure {
        angular: heavy,
        is_torque_free: false,
        keeps_spin: true,
        ..FREE
    });
    Claims {
        body: Hanging {},
        input: no_input,
        moment: |c, angular| {
            // about the hook
            let arm = Vector3::new(0.1, 0.2, 0.3);
            let moved = Matrix3::identity() * arm.norm_squared() - arm * arm.transpose();
            let about_center = Matrix3::from_diagonal(&Vector3::new(1.3, 1.7, 2.1));
            euler(c, angular, &(about_center + moved * 2.0))
        },
    }
    .are(Structure {
        angular: Dependence {
            world: Symmetry::About([0.0, 0.6, -0.8]),
            body: Symmetry::None,
            ..heavy
        },
        is_torque_free: false,
        planes: [false; 3],
        ..FREE
    });
    Claims {
        body: Pendulum {},
        input: no_input,
        moment: whole,
    }
    .are(Structure {
        angular: Dependence {
            attitude: true,
            world: Symmetry::None,
            body: Symmetry::None,
            ..NOTHING
        },
        linear: Dependence {
            world: Symmetry::None,
            body: Symmetry::None,
            ..NOTHING
        },
        is_torque_free: false,
        planes: [false; 3],
        ..FREE
    });
}

#[test]
fn air_and_springs() {
    let drag = Dependence {
        velocity: true,
        ..NOTHING
    };
    Claims {
        body: Ball::default(),
        input: no_input,
        moment: principal!(1.3, 1.3, 1.3),
    }
    .are(Structure {
        linear: drag,
        angular: NOTHING,
        is_force_free: false,
        keeps_spin: true,
        ..FREE
    });
    let in_air = Dependence {
        attitude: true,
        angular_velocity: true,
        body: Z,
        ..drag
    };
    Claims {
        body: Dart::default(),
        input: no_input,
        moment: principal!(1.7, 1.7, 2.1),
    }
    .are(Structure {
        linear: in_air,
        angular: in_air,
        is_force_free: false,
        is_torque_free: false,
        keeps_spin: true,
        planes: [true, true, false],
    });
    Claims {
        body: Tethered {},
        input: no_input,
        moment: principal!(1.3, 1.7, 2.1),
    }
    .are(Structure {
        linear: Dependence {
            position: true,
            world: Z,
            ..NOTHING
        },
        is_force_free: false,
        planes: [true, true, false],
        ..FREE
    });
    Claims {
        body: Pellet {},
        input: no_input,
        moment: whole,
    }
    .are(Structure {
        linear: drag,
        angular: NOTHING,
        is_force_free: false,
        keeps_spin: true,
        ..FREE
    });
    Claims {
        body: Raft {},
        input: no_input,
        moment: whole,
    }
    .are(Structure {
        linear: Dependence {
            world: Symmetry::None,
            body: Z,
            ..NOTHING
        },
        angular: Dependence {
            attitude: true,
            world: Symmetry::None,
            body: Symmetry::None,
            ..NOTHING
        },
        is_force_free: false,
        is_torque_free: false,
        planes: [false; 3],
        ..FREE
    });
}

/// What decides between two branches has to turn with them.
#[test]
fn branches() {
    let lifted = Dependence {
        position: true,
        world: Z,
        ..NOTHING
    };
    Claims {
        body: Floating {},
        input: no_input,
        moment: principal!(1.3, 1.7, 2.1),
    }
    .are(Structure {
        linear: Dependence {
            time: true,
            ..lifted
        },
        is_force_free: false,
        planes: [true, true, false],
        ..FREE
    });
    Claims {
        body: Fenced {},
        input: no_input,
        moment: principal!(1.3, 1.7, 2.1),
    }
    .are(Structure {
        linear: Dependence {
            world: Symmetry::None,
            ..lifted
        },
        is_force_free: false,
        planes: [true, true, false],
        ..FREE
    });
    Claims {
        body: Puck {},
        input: no_input,
        moment: principal!(1.3, 1.7, 2.1),
    }
    .are(Structure {
        linear: Dependence {
            world: Symmetry::About([0.0, 1.0, 0.0]),
            ..NOTHING
        },
        is_force_free: false,
        planes: [true, false, true],
        ..FREE
    });
}

#[test]
fn rods() {
    let turning = Dependence {
        attitude: true,
        angular_velocity: true,
        body: Symmetry::None,
        ..NOTHING
    };
    let linear = Dependence {
        body: Symmetry::None,
        ..NOTHING
    };
    Claims {
        body: Drifting {},
        input: no_input,
        moment: held,
    }
    .are(Structure {
        linear,
        angular: turning,
        ..FREE
    });
    Claims {
        body: Compass {},
        input: no_input,
        moment: held,
    }
    .are(Structure {
        linear,
        angular: Dependence {
            world: Z,
            ..turning
        },
        is_torque_free: false,
        planes: [true, true, false],
        ..FREE
    });
}
