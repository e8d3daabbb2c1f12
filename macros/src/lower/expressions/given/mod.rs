//! Functions that a user gives: by values, and in Rust.

mod foreign;
mod tables;
