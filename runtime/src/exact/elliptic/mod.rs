//! Elliptic functions and integrals.

pub(super) mod carlson;
pub(super) mod jacobi;
pub(super) mod phase;
pub(super) mod third_kind;
