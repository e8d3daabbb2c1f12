//! The time that the expansion of descriptions takes, and how it grows with their size.
//!
//! Proc macros run unoptimized in every build of a user's crate, so this should run unoptimized,
//! too: `cargo test -p mounted --bench expansion`, which is `cargo bench` without optimization. Robot files,
//! whose root floats, are given as `-- robot.urdf:root_link`.

#[path = "../../compiler/descriptions.rs"]
mod descriptions;

use std::sync::LazyLock;
use std::time::Instant;

use descriptions::{many_forces, quadrotor};
use proc_macro2::{Group, Punct, Spacing, TokenStream, TokenTree};
use quote::{format_ident, quote};

/// The system with this name, as a test file describes it.
fn described(text: &str, name: &str) -> TokenStream {
    let file = syn::parse_file(text).expect("a file of Rust");
    let systems = file.items.into_iter().filter_map(|item| match item {
        syn::Item::Macro(item) => Some(item.mac.tokens),
        _ => None,
    });
    let mut named = systems.filter(|tokens| {
        let first = tokens.clone().into_iter().next();
        first.is_some_and(|first| first.to_string() == name)
    });
    named.next().expect("a system of this name")
}

/// The same description with only these outputs.
fn asking(description: TokenStream, outputs: &TokenStream) -> TokenStream {
    let asked = quote!(outputs: [#outputs]);
    let trees = description.into_iter().map(|tree| match tree {
        TokenTree::Group(keys) => {
            let mut kept = TokenStream::new();
            let mut is_outputs = false;
            for key in keys.stream() {
                is_outputs |= matches!(&key, TokenTree::Ident(word) if word == "outputs");
                if !is_outputs {
                    kept.extend([key]);
                }
            }
            let comma = Punct::new(',', Spacing::Alone);
            let ends = kept.clone().into_iter().last();
            let is_closed = matches!(ends, Some(TokenTree::Punct(last)) if last.as_char() == ',');
            let comma = (!is_closed).then_some(comma);
            TokenTree::Group(Group::new(keys.delimiter(), quote!(#kept #comma #asked)))
        }
        other => other,
    });
    trees.collect()
}

/// A robot from a file, with a floating root.
fn floating(argument: &str) -> TokenStream {
    let (file, root) = argument.split_once(':').expect("file.urdf:root_link");
    let root = format_ident!("{root}");
    quote!(Robot {
        urdf: #file,
        joints: [floating_root = free(#root)],
        fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
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

fn main() {
    let unoptimized = cfg!(debug_assertions);
    println!(
        "expansion in ms, best of 5, and in thousands of characters, {}",
        if unoptimized {
            "unoptimized as for a user"
        } else {
            "optimized"
        }
    );
    let (none, linearization) = (quote!(), quote!(linearization));
    let bodies = [
        ("quadrotor", quadrotor()),
        ("quadrotor, no output", asking(quadrotor(), &none)),
        (
            "quadrotor, linearization",
            asking(quadrotor(), &linearization),
        ),
        ("every kind of load, all outputs", with_everything()),
        ("1 force", many_forces(1)),
        ("10 forces", many_forces(10)),
        ("100 forces", many_forces(100)),
        ("1000 forces", many_forces(1000)),
    ];
    for (name, description) in bodies {
        row(name, || {
            mounted::expand::expand(quote!((::newton_euler) #description))
        });
    }
    let references = include_str!("../../systems/described.rs");
    let mut systems = vec![
        (
            "double pendulum".into(),
            described(references, "DoublePendulum"),
        ),
        (
            "satellite, three wheels".into(),
            described(references, "Satellite"),
        ),
        ("UR5".into(), described(references, "Ur5")),
        (
            "UR5, no output".into(),
            asking(described(references, "Ur5"), &none),
        ),
        (
            "UR5, linearization".into(),
            asking(described(references, "Ur5"), &linearization),
        ),
        (
            "quadruped, 18 freedoms".into(),
            described(include_str!("../../systems/large.rs"), "Quadruped"),
        ),
    ];
    for argument in std::env::args().skip(1).filter(|word| word.contains(':')) {
        systems.push((argument.clone(), floating(&argument)));
    }
    for (name, description) in systems {
        row(&name, || {
            mounted::expand::expand_system(quote!((::newton_euler) #description))
        });
    }
}

/// The seconds during which this thread has had a core, if the system tells, so that other work on
/// the machine does not count. Otherwise, the seconds that have passed.
fn processor_time() -> f64 {
    static BEGIN: LazyLock<Instant> = LazyLock::new(Instant::now);
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds: Option<f64> =
        told.and_then(|text| text.split_whitespace().next()?.parse().ok());
    nanoseconds.map_or_else(|| BEGIN.elapsed().as_secs_f64(), |time| time * 1e-9)
}

/// The shortest time of five.
fn row(name: &str, expanded: impl Fn() -> TokenStream) {
    let mut size = 0;
    let times = (0..5).map(|_| {
        let start = processor_time();
        let tokens = expanded();
        let elapsed = (processor_time() - start) * 1e3;
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
