//! Descriptions that several tests and the benchmark of the expansion use.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

pub fn quadrotor() -> TokenStream {
    quote!(Quadrotor {
        doc: "A quadrotor in a plus configuration; rotors 1 and 3 spin about -z.",
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

/// A body with `count` forces at as many points.
pub fn many_forces(count: usize) -> TokenStream {
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
