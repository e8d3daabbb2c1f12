//! Trees of bodies: from joints and loads to the accelerations of all joints.
//!
//! First comes the bias, from the ground to the tips: the motion with zero joint accelerations.
//! Then the articulated-body recursion (Featherstone, Rigid Body Dynamics Algorithms, 7.3), from
//! the tips to the ground and back, adds the joint accelerations. It has no bias terms itself. Each
//! pass is written out link by link in the graph, so that zeros, constants and shared terms drop
//! out.

mod alone;
mod articulated;
mod bias;
mod build;
mod joint_loads;
pub mod link;
mod mass_matrix;
pub mod properties;
mod recursion;
mod reductions;
mod regrouping;
pub mod spatial;
pub mod turning;

pub use alone::alone;
pub use bias::LinkMotion;
pub use build::{Built, build, wrench};
pub use joint_loads::{along_freedoms, from_world, in_world, joint_loads, lacking, lacks, motions};
pub use mass_matrix::MassMatrix;
pub use properties::Properties;
pub use recursion::{SolvedTree, derive_tree};
pub use regrouping::regroup;
pub use spatial::{SpatialInertia, SpatialVector};
