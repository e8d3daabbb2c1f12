//! Arithmetic hazards in rigid-body dynamics, H1 to H20. For each, the error of the straightforward
//! formula, and that of the library through the macro and through the runtime.
//!
//! A hazard is a function that returns [`Record`]s. Each record must stay within its limit. Where
//! the straightforward formula is known to fail, it must fail; otherwise the case would test
//! nothing.
//!
//! ```text
//! cargo test --test hazards                                           # runs of up to 1e5 steps
//! HAZARDS=full cargo test --release --test hazards -- --nocapture     # runs of 1e6 steps, and the table of docs/trust.md
//! ```

mod constraints;
mod distances;
mod edges;
mod exact;
mod phase;
mod plates;
mod rotations;
mod runge_kutta;
mod scales;
mod separatrix;
mod spheres;
mod table;
mod thin;
mod tops;
mod world;
mod wrenches;

use std::sync::OnceLock;

use table::Record;

/// Whether runs are as long as those of `docs/trust.md`.
fn is_full() -> bool {
    std::env::var_os("HAZARDS").is_some()
}

/// This many steps, or a tenth of them.
fn steps(count: u32) -> u32 {
    if is_full() { count } else { count / 10 }
}

/// A test of each hazard, and the table of all.
macro_rules! hazards {
    ($($name:ident = $tried:path: $what:literal;)+) => {
        $(
            fn $name() -> &'static [Record] {
                static RECORDS: OnceLock<Vec<Record>> = OnceLock::new();
                RECORDS.get_or_init($tried)
            }
        )+

        mod holds {
            $(
                #[test]
                fn $name() {
                    for record in super::$name() {
                        record.check();
                    }
                }
            )+
        }

        #[test]
        fn table() {
            table::print(&[$((stringify!($name), $what, $name())),+]);
        }
    };
}

hazards! {
    h1 = thin::rods: "thin bodies; relative error of the acceleration, and what grows along an axis without a moment";
    h2 = edges::nearly_equal: "moments of nearly equal edges b, c; relative error of their difference";
    h3 = distances::parallel_axes: "parallel axes; relative error of the moments about G";
    h3b = distances::far_clouds: "mass points far from the origin; relative error of the tensor about G";
    h4 = rotations::norms: "norm of attitudes; largest deviation from a rotation in 1e5 steps of 0.1 rad";
    h5 = rotations::exponentials: "exponential; relative error of a component, angles 0 to π";
    h6 = rotations::logarithms: "logarithm; relative error of the angle";
    h7 = spheres::nearly: "nearly spherical bodies, J = 1 + ε S; relative error of the gyroscopic moment or acceleration";
    h8 = separatrix::periods: "periods near the separatrix, J = (1, 2, 3), ω = (d, 1, 2 d); relative error";
    h8b = separatrix::zeros: "zeros that stay zero, ω = (0, 1, 0); largest of the other components";
    h9 = world::far_bodies: "millimeters far from the world's origin; relative error of the moment, or change of ω̇";
    h9b = world::small_steps: "small steps far from the origin; error of the position [ulp]";
    h10 = scales::inertias: "inertias of any scale; relative error of J⁻¹ K";
    h11 = scales::single_precision: "single precision; relative error of what is conserved";
    h13 = wrenches::reductions: "reduction of wrenches; change of line and pitch with the scale, relative";
    h14 = wrenches::neutral_bodies: "uniform fields on bodies that are nearly neutral; relative error of the moment";
    h15 = constraints::drift: "constraints over time; largest gap of a joint [m]";
    h16 = tops::through_the_vertical: "tops through the vertical; relative error of the energy";
    h17 = constraints::toggles: "toggle positions; relative error of the reaction; where there is none, the force that is given [N]";
    h18 = constraints::mixed_scales: "mixed scales in one system of equations; relative error of the acceleration";
    h19 = phase::long_times: "phases after 1e9 s; error of the attitude or rate over eps Ω t";
    h20 = plates::plane_bodies: "plane bodies of decimal moments; share of those that exist and are refused, or the reverse";
}
