//! Tops: how symmetric bodies precess.

pub mod precession;
pub mod top;
