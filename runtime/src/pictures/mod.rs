//! Pictures of motions as self-contained files: plots in SVG, and pages with moving solids. They
//! contain no scripts and load nothing.
//!
//! ```no_run
//! use newton_euler::pictures::{Page, Plot, Solid};
//! use newton_euler::prelude::*;
//!
//! rigid_body!(Handle {
//!     doc: "A handle that flips over as it spins.",
//!     motion: spatial,
//!     mass: 0.3[kg],
//!     inertia: principal(1.2e-4, 3.4e-4, 4.1e-4)[kg * m ^ 2],
//! });
//!
//! let spin = [0.02, 9.0, 0.0].into();
//! let start = Spatial { angular_velocity: spin, ..Spatial::default() };
//! let handle = Handle::default();
//! let samples = handle.integrate(&start).samples(6.0, 0.02).collect::<Result<Vec<_>, _>>()?;
//!
//! Plot::of(&samples, &["angular_velocity"])?.write("spin.svg")?;
//! Page::of(&samples)
//!     .solid(Solid::cuboid([0.16, 0.04, 0.02]))
//!     .curves(&["angular_velocity"])?
//!     .write("handle.html")?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Numbers that are infinite or NaN leave a gap. Colors can be told apart by color-blind readers,
//! and follow the reader's choice of light or dark.

mod axis;
mod curve;
mod faces;
mod markup;
mod page;
mod plot;
mod pose;
mod solid;
mod stage;
mod view;

pub use curve::UnknownColumn;
pub use page::Page;
pub use plot::Plot;
pub use pose::{Pose, Posed};
pub use solid::Solid;
