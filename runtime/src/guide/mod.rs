//! A guide in chapters: the physics first, then the description, then numbers to check.
//!
//! Every program compiles unchanged, in a crate that depends on `newton-euler` alone (the
//! gallery needs the feature `pictures`), and asserts what the text says. The references of the language are
//! [`rigid_body!`](crate::rigid_body) and [`rigid_system!`](crate::rigid_system); [`recipes`] has
//! programs for common tasks.
//!
//! 1. [A falling plank](falling_plank): the two balances, and a first body.
//! 2. [Units and frames](units_and_frames): the units of numbers and the axes of vectors.
//! 3. [Tops](tops): free rotation, precession, the heavy top.
//! 4. [Reactions](reactions): the loads of supports.
//! 5. [Constraints](constraints): rolling, sliding, and contacts that end.
//! 6. [Systems](systems): several bodies, and closed loops.
//! 7. [Speed](speed): the cost of an evaluation, and how to reduce it.
//! 8. [Accuracy](accuracy): errors, their sources, and how to check them.
//! 9. [Gallery](gallery): pictures of motions, and the programs that draw them.
//!
//! To look things up: the [symbols] of formulas and of generated code, and the
//! [errors] that the compiler reports.
//!
//! [`recipes`]: crate::recipes

#[doc = include_str!("falling_plank.md")]
pub mod falling_plank {}

#[doc = include_str!("units_and_frames.md")]
pub mod units_and_frames {}

#[doc = include_str!("tops.md")]
pub mod tops {}

#[doc = include_str!("reactions.md")]
pub mod reactions {}

#[doc = include_str!("constraints.md")]
pub mod constraints {}

#[doc = include_str!("systems.md")]
pub mod systems {}

#[doc = include_str!("speed.md")]
pub mod speed {}

#[doc = include_str!("accuracy.md")]
pub mod accuracy {}

/// Pictures of motions, each with the program that draws it: with the feature `pictures`.
#[cfg(not(feature = "pictures"))]
pub mod gallery {}

// rustdoc copies no files next to its pages, so the page contains its pictures: of two definitions
// of a link, rustdoc takes the first, which is the picture
#[cfg(feature = "pictures")]
#[cfg_attr(doc, doc = include_str!("gallery_data.md"))]
#[doc = include_str!("gallery.md")]
pub mod gallery {}

#[doc = include_str!("symbols.md")]
pub mod symbols {}

#[doc = include_str!("errors.md")]
pub mod errors {}
