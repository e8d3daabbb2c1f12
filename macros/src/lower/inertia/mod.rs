//! The inertia, in every form in which it may be written.

mod across_axis;
mod composition;
mod draft;
mod entries;
mod form;
mod parallel_axis;
mod possible;
mod solid;
mod turned;
