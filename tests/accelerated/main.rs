//! Loads that depend on the acceleration that they cause: added mass, rates of flow angles,
//! feedthrough.

mod added;
mod bodies;
mod branches;
mod held;
mod systems;

use nalgebra::SVector;
use newton_euler::prelude::Spatial;

/// What makes a residual zero that is linear in it, by what it is at the unit vectors.
fn solve<const N: usize>(
    residual: impl Fn(&SVector<f64, N>) -> SVector<f64, N>,
) -> SVector<f64, N> {
    let rest = residual(&SVector::zeros());
    let mut matrix = nalgebra::SMatrix::<f64, N, N>::zeros();
    for column in 0..N {
        let mut unit = SVector::zeros();
        unit[column] = 1.0;
        matrix.set_column(column, &(residual(&unit) - rest));
    }
    let mut right = -rest;
    for k in 0..N {
        let pivot = (k..N).max_by(|a, b| matrix[(*a, k)].abs().total_cmp(&matrix[(*b, k)].abs()));
        let pivot = pivot.expect("a row is left");
        matrix.swap_rows(k, pivot);
        right.swap_rows(k, pivot);
        for row in (0..N).filter(|row| *row != k) {
            let factor = matrix[(row, k)] / matrix[(k, k)];
            for column in 0..N {
                matrix[(row, column)] -= factor * matrix[(k, column)];
            }
            right[row] -= factor * right[k];
        }
    }
    SVector::from_fn(|row, _| right[row] / matrix[(row, row)])
}

/// Numbers between -1 and 1, always the same.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let high = u32::try_from(self.0 >> 32).expect("it has 32 bits");
        f64::from(high) / f64::from(u32::MAX) * 2.0 - 1.0
    }

    fn vector<const N: usize>(&mut self) -> SVector<f64, N> {
        SVector::from_fn(|_, _| self.next())
    }

    fn attitude(&mut self) -> nalgebra::UnitQuaternion<f64> {
        let [w, i, j, k] = [self.next(), self.next(), self.next(), self.next()];
        nalgebra::UnitQuaternion::new_normalize(nalgebra::Quaternion::new(w, i, j, k))
    }

    fn spatial(&mut self) -> Spatial {
        Spatial {
            position: self.vector(),
            velocity: self.vector(),
            attitude: self.attitude(),
            angular_velocity: self.vector(),
        }
    }
}
