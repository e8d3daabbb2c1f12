//! The guard of the crate `no-panic`: on unwinding, it calls a symbol that does not exist.

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
