//! How long descriptions take to expand, and how it grows with their size.
//!
//! The compiler is mounted here, since a proc-macro crate cannot be linked. Proc macros run unoptimised in every build of a
//! user's crate, so that is how this is to be run: `cargo test --bench expansion`, which is `cargo bench` without optimisation.
#![allow(dead_code)]

#[path = "../macros/src/emit/mod.rs"]
mod emit;
#[path = "../macros/src/errors.rs"]
mod errors;
#[path = "../macros/src/expand.rs"]
mod expand;
#[path = "../macros/src/mechanics/mod.rs"]
mod mechanics;
#[path = "../macros/src/model/mod.rs"]
mod model;
#[path = "../macros/src/symbolic/mod.rs"]
mod symbolic;
#[path = "../macros/src/syntax/mod.rs"]
mod syntax;

use std::time::Instant;

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

fn quadrotor() -> TokenStream {
    quote!(Quadrotor {
        motion: spatial,
        params: [arm = 0.17[m], drag_ratio = 0.016[m]],
        inputs: [thrust_1[N], thrust_2[N], thrust_3[N], thrust_4[N]],
        mass: 1.2[kg],
        inertia: principal(0.0123, 0.0123, 0.0224)[kg * m ^ 2],
        points: [
            front = (arm, 0, 0),
            left = (0, arm, 0),
            back = (-arm, 0, 0),
            right = (0, -arm, 0)
        ],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
        forces: [
            lift_1 = body(0, 0, thrust_1).at(front),
            lift_2 = body(0, 0, thrust_2).at(left),
            lift_3 = body(0, 0, thrust_3).at(back),
            lift_4 = body(0, 0, thrust_4).at(right),
        ],
        locals: [twist = thrust_1 - thrust_2 + thrust_3 - thrust_4],
        moments: [drag = body(0, 0, drag_ratio * twist)],
    })
}

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

/// A body with `count` forces at as many points.
fn many_forces(count: usize) -> TokenStream {
    let names: Vec<_> = (0..count).map(|i| format_ident!("force_{i}")).collect();
    let points: Vec<_> = (0..count).map(|i| format_ident!("point_{i}")).collect();
    let inputs: Vec<_> = (0..count).map(|i| format_ident!("input_{i}")).collect();
    let offsets = (1..=count).map(Literal::usize_unsuffixed);
    quote!(Many {
        motion: spatial,
        inputs: [#(#inputs[N]),*],
        mass: 3[kg],
        inertia: tensor { xx: 1.3, yy: 1.7, zz: 2.1, xy: -0.12, yz: -0.05, zx: 0.07 }[kg * m ^ 2],
        points: [#(#points = (0.01 * #offsets, 0.2, -0.1)),*],
        forces: [#(#names = body(#inputs, 0.5 * #inputs, 1).at(#points)),*],
    })
}

fn main() {
    let unoptimised = cfg!(debug_assertions);
    println!(
        "expansion in ms, best of 5, {}",
        if unoptimised {
            "unoptimised as for a user"
        } else {
            "optimised"
        }
    );
    let rows = [
        ("quadrotor", quadrotor()),
        ("every kind of load, all outputs", with_everything()),
        ("50 forces", many_forces(50)),
        ("200 forces", many_forces(200)),
        ("800 forces", many_forces(800)),
    ];
    for (name, description) in rows {
        let times = (0..5).map(|_| {
            let start = Instant::now();
            let tokens = expand::expand(quote!((::newton_euler) #description));
            let elapsed = start.elapsed().as_secs_f64() * 1e3;
            assert!(
                !tokens.to_string().contains("compile_error"),
                "{name}: {tokens}"
            );
            elapsed
        });
        println!("{name:<34} {:>8.1}", times.fold(f64::INFINITY, f64::min));
    }
}
