//! A crate that re-exports the library.
#![forbid(unsafe_code)]

pub use dynamics_underneath as mechanics;

/// Under another name still.
pub mod deeper {
    pub use dynamics_underneath::rigid_body as body;
}
