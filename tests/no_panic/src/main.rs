//! Functions that cannot panic: `cargo run --profile proof -p newton-euler-no-panic --features
//! proof`.
//!
//! The crate `no-panic` puts a guard into each of the following functions. On unwinding, the guard
//! calls a nonexistent symbol, so this links if and only if the optimizer has removed every path on
//! which a function could panic. `docs/trust.md` lists what is left out, and why.

#![allow(clippy::result_large_err, reason = "errors hold a state")]

mod by_hand;
mod ensembles;
mod evaluations;
#[path = "../../kinds/mod.rs"]
mod kinds;
mod motions;
#[path = "../../handwritten/mod.rs"]
mod systems;

/// Functions that cannot panic, and a function that has all of them linked and says how many they are.
macro_rules! cannot_panic {
    ($(fn $name:ident($($argument:ident: $kind:ty),* $(,)?) -> $result:ty $body:block)*) => {
        $(
            #[cfg_attr(feature = "proof", no_panic::no_panic)]
            #[inline(never)]
            fn $name($($argument: $kind),*) -> $result $body
        )*

        pub fn link() -> usize {
            $(core::hint::black_box::<fn($($kind),*) -> $result>($name);)*
            [$(stringify!($name)),*].len()
        }
    };
}
use cannot_panic;

#[cfg(feature = "broken")]
mod broken {
    crate::cannot_panic! {
        fn broken(list: &[f64], place: usize) -> f64 {
            list[place]
        }
    }
}

fn main() {
    let count = evaluations::link() + motions::link() + by_hand::link() + ensembles::link();
    #[cfg(feature = "broken")]
    let count = count + broken::link();
    println!("{count} functions");
}
