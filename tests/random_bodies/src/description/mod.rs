//! Descriptions of bodies as data: drawn at random, and written in the language of `rigid_body!`.

pub mod body;
pub mod constraints;
pub mod draw;
pub mod expression;
mod following;
pub mod gates;
pub mod inertia;
pub mod literal;
pub mod loads;
pub mod moving;
pub mod reactions;
mod rich;
pub mod terms;
pub mod written;
