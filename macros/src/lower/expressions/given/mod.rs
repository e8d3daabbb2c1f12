//! Functions given by the user: tables and Rust functions.

mod csv;
mod foreign;
mod grid;
mod tables;
