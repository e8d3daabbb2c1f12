//! The view of a scene: a parallel projection.

use nalgebra::{Matrix3, Vector3};

/// A direction to look from.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    /// Rows: to the right, up, towards the reader.
    rows: Matrix3<f64>,
}

impl View {
    /// From the front: x to the right, y up.
    pub(super) fn of_plane() -> Self {
        Self {
            rows: Matrix3::identity(),
        }
    }

    /// With z up, seen from an azimuth, counterclockwise from the x-axis, and an elevation above the
    /// horizon \[rad\].
    pub(super) fn from(azimuth: f64, elevation: f64) -> Self {
        let ((sa, ca), (se, ce)) = (azimuth.sin_cos(), elevation.sin_cos());
        Self {
            rows: Matrix3::new(-sa, ca, 0.0, -se * ca, -se * sa, ce, ce * ca, ce * sa, se),
        }
    }

    /// To the right, up, towards the reader.
    pub(super) fn seen(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        self.rows * vector
    }

    /// The CSS transform: to the right, down, towards the reader.
    pub(super) fn matrix(&self) -> std::string::String {
        let columns = self.rows.column_iter();
        let columns = columns.map(|column| {
            let [right, up, near] =
                [column[0], -column[1], column[2]].map(|number| super::markup::short(number, 5));
            std::format!("{right},{up},{near},0")
        });
        let columns: std::vec::Vec<_> = columns.collect();
        std::format!("matrix3d({},0,0,0,1)", columns.join(","))
    }
}
