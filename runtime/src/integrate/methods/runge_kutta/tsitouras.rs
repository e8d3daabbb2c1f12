//! The method of order 5 of Ch. Tsitouras.

use super::{RungeKutta, change, moved, number, tableau};
use crate::bodies::body::RigidBody;
use crate::integrate::steps::equations::Equations;
use crate::numbers::scalar::Scalar;
use crate::state::Coordinates;

tableau! {
    /// The method of order 5 with six evaluations of Ch. Tsitouras, Runge–Kutta pairs of order 5(4)
    /// satisfying only the first column simplifying assumption, Computers and Mathematics with
    /// Applications 62 (2011) 770.
    Tsitouras5: order 5;
    stages {
        k1 at 0.0;
        k2 at 0.161 from 0.161 k1;
        k3 at 0.327 from -0.008_480_655_492_356_989 k1, 0.335_480_655_492_357 k2;
        k4 at 0.9 from 2.897_153_057_105_493_5 k1, -6.359_448_489_975_075 k2, 4.362_295_432_869_581_5 k3;
        k5 at 0.980_025_540_904_509_7 from 5.325_864_828_439_257 k1, -11.748_883_564_062_828 k2, 7.495_539_342_889_836_5 k3, -0.092_495_066_361_755_25 k4;
        k6 at 1.0 from 5.861_455_442_946_42 k1, -12.920_969_317_847_11 k2, 8.159_367_898_576_159 k3, -0.071_584_973_281_401 k4, -0.028_269_050_394_068_383 k5;
    }
    sum { 0.096_460_766_818_065_23 k1, 0.01 k2, 0.479_889_650_414_499_6 k3, 1.379_008_574_103_742 k4, -3.290_069_515_436_081 k5, 2.324_710_524_099_774 k6 }
}
