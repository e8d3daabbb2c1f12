//! Mass, center of mass and inertia of the volume inside a closed triangle mesh.

extern crate std;

use alloc::collections::BTreeMap;
use core::fmt;
use std::io::{Read, Seek};

use nalgebra::{Matrix3, Vector3};

use super::matrix::of_second_moments;
use super::{InertiaTensor, InvalidInertia, MassProperties, invalid};
use crate::numbers::messages::{Number, debug_as_display};

/// Why a surface encloses no body.
pub enum InvalidMesh {
    /// The file cannot be read, or is not an STL file.
    Unreadable(std::io::Error),
    /// There are no triangles, or they enclose no volume.
    Empty,
    /// A coordinate, the density or the scale is not finite, or not positive where required.
    NotFinite,
    /// A triangle refers to a vertex that does not exist.
    NoVertex {
        /// The index of the vertex.
        vertex: usize,
    },
    /// An edge between these points has no second triangle, or one of the same orientation.
    Open {
        /// The ends of the edge, in mesh coordinates.
        edge: [Vector3<f64>; 2],
    },
    /// All triangles run clockwise, seen from outside.
    InsideOut,
    /// The volume is not a possible body.
    Inertia(InvalidInertia),
}

impl fmt::Display for InvalidMesh {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreadable(error) => write!(f, "no STL: {error}"),
            Self::Empty => write!(f, "the triangles hold no volume"),
            Self::NotFinite => write!(f, "coordinates are finite, density and scale positive"),
            Self::NoVertex { vertex } => write!(f, "there is no vertex {vertex}"),
            Self::Open { edge } => {
                let [[x, y, z], [to_x, to_y, to_z]] =
                    edge.map(|end| <[f64; 3]>::from(end).map(Number));
                write!(
                    f,
                    "the surface is not closed: triangles do not meet along the edge from ({x}, {y}, {z}) to ({to_x}, {to_y}, {to_z})"
                )
            }
            Self::InsideOut => write!(f, "the surface is inside out: its triangles run clockwise"),
            Self::Inertia(error) => error.fmt(f),
        }
    }
}

debug_as_display!(InvalidMesh);

impl core::error::Error for InvalidMesh {}

/// A volume below this fraction of the products that it is the sum of is rounding.
const NOTHING: f64 = 1e-14;

impl MassProperties {
    /// The mass properties from an STL file, text or binary, whose triangles are counterclockwise
    /// seen from outside. Scale is meters per unit of the file, such as 1e-3, and density is in
    /// kg/m^3. Results are in the axes of the file, the center from its origin.
    ///
    /// Vertices at identical positions are merged, and triangles with two of them have no area.
    ///
    /// # Errors
    /// [`InvalidMesh`], if the surface is open, inside out, empty or not finite, or the file is not
    /// an STL file.
    pub fn from_stl(
        source: &mut (impl Read + Seek),
        scale: f64,
        density: f64,
    ) -> Result<Self, InvalidMesh> {
        let mesh = stl_io::read_stl(source).map_err(InvalidMesh::Unreadable)?;
        let vertices = mesh.vertices.iter();
        let vertices = vertices.map(|vertex| Vector3::from(vertex.0.map(f64::from)) * scale);
        let vertices: alloc::vec::Vec<Vector3<f64>> = vertices.collect();
        let mut merged = BTreeMap::new();
        let first = mesh.vertices.iter().enumerate().map(|(index, vertex)| {
            // -0.0 + 0.0 is 0.0
            let position = vertex.0.map(|part| (part + 0.0).to_bits());
            *merged.entry(position).or_insert(index)
        });
        let first: alloc::vec::Vec<usize> = first.collect();
        let faces = mesh.faces.iter();
        let triangles = faces.map(|face| face.vertices.map(|vertex| first[vertex]));
        let triangles: alloc::vec::Vec<[usize; 3]> = triangles.collect();
        if !(scale > 0.0 && scale.is_finite()) {
            return Err(InvalidMesh::NotFinite);
        }
        Self::from_triangles(&vertices, &triangles, density)
    }

    /// The mass properties of a closed surface: vertices \[m\] in body axes from any origin,
    /// triangles by the indices of their vertices, counterclockwise seen from outside; density in
    /// kg/m^3.
    ///
    /// Integrates over the tetrahedra between the triangles and a vertex, and again from the
    /// resulting center of mass (D. Eberly, Polyhedral Mass Properties (Revisited), does the same
    /// by the divergence theorem).
    ///
    /// # Errors
    /// [`InvalidMesh`], if the surface is open, inside out, empty or not finite.
    ///
    /// ```
    /// use newton_euler::inertia::MassProperties;
    /// use newton_euler::nalgebra::Vector3;
    ///
    /// let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// let sides = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
    /// let whole = MassProperties::from_triangles(&corners.map(Vector3::from), &sides, 6.0)?;
    /// assert!((whole.mass - 1.0).abs() < 1e-15);
    /// assert!((whole.center.x - 0.25).abs() < 1e-15);
    /// # Ok::<(), newton_euler::inertia::InvalidMesh>(())
    /// ```
    pub fn from_triangles(
        vertices: &[Vector3<f64>],
        triangles: &[[usize; 3]],
        density: f64,
    ) -> Result<Self, InvalidMesh> {
        let is_finite = |vertex: &Vector3<f64>| vertex.iter().all(|part| part.is_finite());
        let is_given = vertices.iter().all(is_finite) && density.is_finite();
        if !is_given || density <= 0.0 {
            return Err(InvalidMesh::NotFinite);
        }
        check_closed(vertices, triangles)?;
        let Some(first) = triangles.first().map(|triangle| vertices[triangle[0]]) else {
            return Err(InvalidMesh::Empty);
        };
        let sides = |from: Vector3<f64>| {
            let corners = triangles.iter();
            corners.map(move |corners| corners.map(|corner| vertices[corner] - from))
        };
        let (mut volume, mut moment, mut size) = (0.0, Vector3::zeros(), 0.0);
        for [a, b, c] in sides(first) {
            let area = b.cross(&c);
            let part = a.dot(&area) / 6.0;
            volume += part;
            moment += (a + b + c) * (part / 4.0);
            size += a.norm() * area.norm();
        }
        if volume.is_nan() || volume.abs() <= NOTHING * size {
            return Err(InvalidMesh::Empty);
        }
        if volume < 0.0 {
            return Err(InvalidMesh::InsideOut);
        }
        let center = first + moment / volume;
        let second: Matrix3<f64> = sides(center)
            .map(|[a, b, c]| {
                let (part, sum) = (a.dot(&b.cross(&c)) / 120.0, a + b + c);
                let square = |v: Vector3<f64>| v * v.transpose();
                (square(a) + square(b) + square(c) + square(sum)) * (part * density)
            })
            .sum();
        let matrix = of_second_moments(&second);
        invalid::check(&matrix).map_err(InvalidMesh::Inertia)?;
        Ok(Self {
            mass: volume * density,
            center,
            inertia: InertiaTensor { matrix },
        })
    }
}

/// Checks that every edge occurs equally often in both directions. A triangle that has one vertex
/// twice is no surface.
fn check_closed(vertices: &[Vector3<f64>], triangles: &[[usize; 3]]) -> Result<(), InvalidMesh> {
    let mut edges: BTreeMap<[usize; 2], isize> = BTreeMap::new();
    for corners in triangles {
        if let Some(vertex) = corners.iter().find(|corner| **corner >= vertices.len()) {
            return Err(InvalidMesh::NoVertex { vertex: *vertex });
        }
        let [a, b, c] = *corners;
        for [from, to] in [[a, b], [b, c], [c, a]] {
            if from == to {
                continue;
            }
            let (edge, way) = if from < to {
                ([from, to], 1)
            } else {
                ([to, from], -1)
            };
            *edges.entry(edge).or_default() += way;
        }
    }
    match edges.iter().find(|(_, ways)| **ways != 0) {
        Some((edge, _)) => Err(InvalidMesh::Open {
            edge: edge.map(|end| vertices[end]),
        }),
        None => Ok(()),
    }
}
