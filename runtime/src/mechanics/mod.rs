//! Mechanics without bodies: inertia, loads and their resultants, attitudes.

pub mod attitude;
pub mod field;
pub mod gyroscopic;
pub mod inertia;
pub mod load;
pub mod principal;
pub mod wrench;
