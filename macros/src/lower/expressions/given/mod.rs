//! Functions that a user gives: by values, and in Rust.

mod csv;
mod foreign;
mod grid;
mod tables;
