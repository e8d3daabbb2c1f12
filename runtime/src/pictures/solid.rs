//! Solids, as polygons.

use std::vec::Vec;

use nalgebra::{UnitQuaternion, Vector3};

use super::pose::Pose;

/// The number of sides of a round solid.
const SIDES: u32 = 12;

/// A solid to be shown, in the axes of its body \[m\].
///
/// ```
/// use newton_euler::pictures::Solid;
///
/// let hammer = Solid::bar([0.0, 0.0, -0.3], [0.0, 0.0, 0.0], 0.02)
///     .and(Solid::cuboid([0.04, 0.12, 0.04]));
/// # let _ = hammer;
/// ```
#[derive(Clone, Debug)]
pub struct Solid {
    pub(super) faces: Vec<Vec<Vector3<f64>>>,
}

impl Solid {
    /// A cuboid about the origin, with the lengths of its edges along x, y and z.
    #[must_use]
    pub fn cuboid(lengths: [f64; 3]) -> Self {
        let half = Vector3::from(lengths) * 0.5;
        let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let sides = (0..3).flat_map(|axis| [-1.0, 1.0].map(|sign| (axis, sign)));
        let faces = sides.map(|(axis, sign)| {
            let corners = square.iter().map(|[first, second]| {
                let mut corner = Vector3::zeros();
                corner[axis] = sign;
                corner[(axis + 1) % 3] = sign * first;
                corner[(axis + 2) % 3] = *second;
                corner.component_mul(&half)
            });
            corners.collect()
        });
        Self {
            faces: faces.collect(),
        }
    }

    /// A cylinder about the origin, with its axis along z.
    #[must_use]
    pub fn cylinder(radius: f64, length: f64) -> Self {
        Self::turned_profile(&[
            [0.0, -0.5 * length],
            [radius, -0.5 * length],
            [radius, 0.5 * length],
            [0.0, 0.5 * length],
        ])
    }

    /// A cone about the origin, with its tip on the positive z-axis.
    #[must_use]
    pub fn cone(radius: f64, length: f64) -> Self {
        Self::turned_profile(&[
            [0.0, -0.5 * length],
            [radius, -0.5 * length],
            [0.0, 0.5 * length],
        ])
    }

    /// A ball about the origin.
    #[must_use]
    pub fn ball(radius: f64) -> Self {
        let parts = 6;
        let profile = (0..=parts).map(|k| {
            let (sine, cosine) =
                (core::f64::consts::PI * f64::from(k) / f64::from(parts)).sin_cos();
            [
                if k == 0 || k == parts {
                    0.0
                } else {
                    radius * sine
                },
                -radius * cosine,
            ]
        });
        Self::turned_profile(&profile.collect::<Vec<_>>())
    }

    /// A bar between two points, with a square section of this width.
    #[must_use]
    pub fn bar(from: [f64; 3], to: [f64; 3], width: f64) -> Self {
        let [from, to] = [from, to].map(Vector3::from);
        let along = to - from;
        let turn = UnitQuaternion::rotation_between(&Vector3::z(), &along);
        // opposite to z, a cuboid looks the same without a turn
        let turn = turn.unwrap_or_default();
        Self::cuboid([width, width, along.norm()]).moved(&Pose {
            position: (from + to) * 0.5,
            attitude: turn,
        })
    }

    /// The solid at another place in the body.
    #[must_use]
    pub fn at(self, place: [f64; 3]) -> Self {
        self.moved(&Pose {
            position: place.into(),
            attitude: UnitQuaternion::identity(),
        })
    }

    /// The solid turned and then moved in the body.
    #[must_use]
    pub fn moved(mut self, pose: &Pose) -> Self {
        for corner in self.faces.iter_mut().flatten() {
            *corner = pose.position + pose.attitude * *corner;
        }
        self
    }

    /// Both solids, as one.
    #[must_use]
    pub fn and(mut self, other: Self) -> Self {
        self.faces.extend(other.faces);
        self
    }

    /// The solid of revolution about z of a profile, a list of radii and heights, from bottom to
    /// top.
    fn turned_profile(profile: &[[f64; 2]]) -> Self {
        let at = |[radius, height]: [f64; 2], k: u32| {
            let (sine, cosine) =
                (core::f64::consts::TAU * f64::from(k) / f64::from(SIDES)).sin_cos();
            Vector3::new(radius * cosine, radius * sine, height)
        };
        let mut faces = Vec::new();
        for pair in profile.windows(2) {
            let [low, high] = [pair[0], pair[1]];
            if low[1].to_bits() == high[1].to_bits() {
                // a lid, seen from outside
                let circle = (0..SIDES).map(|k| at(if low[0] == 0.0 { high } else { low }, k));
                let mut circle: Vec<_> = circle.collect();
                if low[0] == 0.0 {
                    circle.reverse();
                }
                faces.push(circle);
                continue;
            }
            faces.extend((0..SIDES).map(|k| {
                let corners = [(low, k), (low, k + 1), (high, k + 1), (high, k)];
                let on_axis = |corner: &(([f64; 2], u32), usize)| {
                    // the tip once
                    corner.0.0[0] != 0.0 || corner.1.is_multiple_of(3)
                };
                let corners = corners.into_iter().zip(0_usize..).filter(on_axis);
                corners.map(|((point, k), _)| at(point, k)).collect()
            }));
        }
        Self { faces }
    }

    /// The largest distance of a corner from the origin.
    pub(super) fn radius(&self) -> f64 {
        let corners = self.faces.iter().flatten();
        corners.map(Vector3::norm).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The volume within some faces, positive if all are seen counterclockwise from outside.
    fn volume(solid: &Solid) -> f64 {
        let faces = solid.faces.iter();
        faces
            .map(|face| {
                let fans = face[1..].windows(2);
                fans.map(|pair| face[0].dot(&pair[0].cross(&pair[1])) / 6.0)
                    .sum::<f64>()
            })
            .sum()
    }

    #[test]
    fn solids_are_closed_and_turned_outwards() {
        let sector = f64::from(SIDES) / 2.0 * (core::f64::consts::TAU / f64::from(SIDES)).sin();
        let close = |solid: Solid, expected: f64| {
            let moved = solid.at([0.3, -2.0, 5.0]);
            assert!(
                (volume(&moved) - expected).abs() < 1e-9 * (1.0 + expected),
                "{moved:?}"
            );
        };
        close(Solid::cuboid([1.0, 2.0, 3.0]), 6.0);
        close(Solid::cylinder(2.0, 3.0), sector * 4.0 * 3.0);
        close(Solid::cone(2.0, 3.0), sector * 4.0);
        close(Solid::bar([0.0, 0.0, 1.0], [0.0, 0.0, -1.0], 0.5), 0.5);
        close(Solid::bar([1.0, 2.0, 3.0], [1.0, 5.0, 7.0], 0.1), 0.05);
        let ball = volume(&Solid::ball(1.0)) / (core::f64::consts::PI * 4.0 / 3.0);
        assert!((0.8..1.0).contains(&ball), "{ball}");
    }
}
