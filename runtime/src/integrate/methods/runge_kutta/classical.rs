//! The classical method of order 4.

use super::{RungeKutta, change, moved, number, tableau};
use crate::bodies::body::RigidBody;
use crate::integrate::steps::equations::Equations;
use crate::numbers::scalar::Scalar;
use crate::state::Coordinates;

tableau! {
    /// The classical Runge–Kutta method, of order 4 with four evaluations (W. Kutta, Zeitschrift
    /// für Mathematik und Physik 46 (1901) 435).
    Classical4: order 4;
    stages {
        k1 at 0.0;
        k2 at 0.5 from 0.5 k1;
        k3 at 0.5 from 0.5 k2;
        k4 at 1.0 from 1.0 k3;
    }
    sum { 0.166_666_666_666_666_66 k1, 0.333_333_333_333_333_3 k2, 0.333_333_333_333_333_3 k3, 0.166_666_666_666_666_66 k4 }
}
