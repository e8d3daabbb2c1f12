//! The inertia, in all its written forms.

mod across_axis;
mod composition;
mod draft;
mod entries;
mod form;
mod parallel_axis;
mod possible;
mod solid;
mod turned;

pub use turned::rotation;
