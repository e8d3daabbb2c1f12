//! How long descriptions take to expand, and how it grows with their size.
//!
//! The compiler is mounted here, since a proc-macro crate cannot be linked. Proc macros run unoptimised in every build of a
//! user's crate, so that is how this is to be run: `cargo test --bench expansion`, which is `cargo bench` without optimisation.
#![allow(dead_code)]

#[path = "../tests/compiler/descriptions.rs"]
mod descriptions;
#[path = "../macros/src/emit/mod.rs"]
mod emit;
#[path = "../macros/src/errors.rs"]
mod errors;
#[path = "../macros/src/expand.rs"]
mod expand;
#[path = "../macros/src/families.rs"]
mod families;
#[path = "../macros/src/fraction.rs"]
mod fraction;
#[path = "../macros/src/lower/mod.rs"]
mod lower;
#[path = "../macros/src/mechanics/mod.rs"]
mod mechanics;
#[path = "../macros/src/model/mod.rs"]
mod model;
#[path = "../macros/src/outputs/mod.rs"]
mod outputs;
#[path = "../macros/src/range.rs"]
mod range;
#[path = "../macros/src/symbolic/mod.rs"]
mod symbolic;
#[path = "../macros/src/syntax/mod.rs"]
mod syntax;

use std::time::Instant;

use descriptions::{many_forces, quadrotor};
use proc_macro2::TokenStream;
use quote::quote;

fn with_everything() -> TokenStream {
    quote!(Satellite {
        motion: spatial,
        params: [
            m = 3.21234567890123456[kg],
            arm = 0.17[m],
            k[N / m],
            area = 0.3
        ],
        inputs: [force = body(_, _, _)[N], wind = world(_, _, _)[m / s]],
        mass: m,
        inertia: products {
            xx: 1.3,
            yy: 1.7,
            zz: 2.1,
            xy: 0.12,
            yz: 0.05,
            zx: -0.07
        }[kg * m ^ 2]
            .about(drawn),
        points: [
            drawn = (arm, 0.1, -0.2),
            tip = (0, arm, 0.3),
            anchor = world(1, 2, 3)
        ],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
        locals: [
            air = tip.velocity() - wind,
            stretch = tip.position() - anchor.position()
        ],
        forces: [
            push = force.at(tip),
            drag = (-area * air.norm() * air).at(tip),
            spring = (-k * stretch).at(tip)
        ],
        pole: anchor,
        outputs: [energy, momentum, balance],
    })
}

fn main() {
    let unoptimised = cfg!(debug_assertions);
    println!(
        "expansion in ms, best of 5, and in thousands of characters, {}",
        if unoptimised {
            "unoptimised as for a user"
        } else {
            "optimised"
        }
    );
    let rows = [
        ("quadrotor", quadrotor()),
        ("every kind of load, all outputs", with_everything()),
        ("1 force", many_forces(1)),
        ("10 forces", many_forces(10)),
        ("100 forces", many_forces(100)),
        ("1000 forces", many_forces(1000)),
    ];
    for (name, description) in rows {
        let mut size = 0;
        let times = (0..5).map(|_| {
            let start = Instant::now();
            let tokens = expand::expand(quote!((::newton_euler) #description));
            let elapsed = start.elapsed().as_secs_f64() * 1e3;
            size = tokens.to_string().len();
            assert!(
                !tokens.to_string().contains("compile_error"),
                "{name}: {tokens}"
            );
            elapsed
        });
        let least = times.fold(f64::INFINITY, f64::min);
        println!("{name:<34} {least:>8.1} {:>8}", size / 1000);
    }
}
