//! The reference of descriptions, by topic.
//!
//! [`rigid_body!`](crate::rigid_body) and [`rigid_system!`](crate::rigid_system) list all keys and
//! outputs; these pages describe them. A program of the reference goes into a
//! `fn main() -> Result<(), Box<dyn std::error::Error>>` that ends with `Ok(())`, in a crate that
//! depends on `newton-euler` alone.
//!
//! - A body: [`motion`], [`inertia`], [`expressions`], [`loads`], [`reactions`], [`time`],
//!   [`outputs`], [`claims`].
//! - A system: [`joints`], [`systems`], [`files`].
//!
//! The [guide](crate::guide) explains the physics.

#[doc = include_str!("motion.md")]
pub mod motion {}

#[doc = include_str!("loads.md")]
pub mod loads {}

#[doc = include_str!("reactions.md")]
pub mod reactions {}

#[doc = include_str!("inertia.md")]
pub mod inertia {}

#[doc = include_str!("expressions.md")]
pub mod expressions {}

#[doc = include_str!("time.md")]
pub mod time {}

#[doc = include_str!("outputs.md")]
pub mod outputs {}

#[doc = include_str!("claims.md")]
pub mod claims {}

#[doc = include_str!("joints.md")]
pub mod joints {}

#[doc = include_str!("systems.md")]
pub mod systems {}

#[doc = include_str!("files.md")]
pub mod files {}
