//! Mass, center of mass and inertia of what a closed surface of triangles holds.

extern crate std;

use alloc::collections::BTreeMap;
use core::fmt;
use std::io::{Read, Seek};

use nalgebra::{Matrix3, Vector3};

use super::matrix::of_second_moments;
use super::{InertiaTensor, InvalidInertia, MassProperties, invalid};

/// Why a surface holds no body.
#[derive(Debug)]
pub enum InvalidMesh {
    /// The file cannot be read, or is no STL.
    Unreadable(std::io::Error),
    /// There are no triangles, or they hold no volume.
    Empty,
    /// A coordinate, the density or the scale is not finite, or not positive where it has to be.
    NotFinite,
    /// A triangle has a vertex that is not there.
    NoVertex {
        /// Its number.
        vertex: usize,
    },
    /// An edge between these places has no second triangle, or one that runs the same way.
    Open {
        /// The ends of the edge, as they are in the mesh.
        edge: [Vector3<f64>; 2],
    },
    /// All triangles run clockwise, seen from outside.
    InsideOut,
    /// What is held is no body.
    Inertia(InvalidInertia),
}

impl fmt::Display for InvalidMesh {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreadable(error) => write!(f, "no STL: {error}"),
            Self::Empty => write!(f, "the triangles hold no volume"),
            Self::NotFinite => write!(f, "coordinates are finite, density and scale positive"),
            Self::NoVertex { vertex } => write!(f, "there is no vertex {vertex}"),
            Self::Open { edge: [from, to] } => write!(
                f,
                "the surface is not closed: triangles do not meet along the edge from ({}, {}, {}) to ({}, {}, {})",
                from.x, from.y, from.z, to.x, to.y, to.z
            ),
            Self::InsideOut => write!(f, "the surface is inside out: its triangles run clockwise"),
            Self::Inertia(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for InvalidMesh {}

/// How small a volume is nothing but rounding, over the cube of the size.
const NOTHING: f64 = 1e-13;

impl MassProperties {
    /// Of an STL file, text or binary, whose triangles run counterclockwise seen from outside; scale
    /// is metres per unit of the file, such as 1e-3, and density kg/m^3. Results are in the axes of the
    /// file, the center from its origin.
    ///
    /// Vertices that are in one place, to the bit, are one.
    ///
    /// # Errors
    /// [`InvalidMesh`], if the surface is open, inside out, empty or not finite, or the file no STL.
    pub fn from_stl(
        source: &mut (impl Read + Seek),
        scale: f64,
        density: f64,
    ) -> Result<Self, InvalidMesh> {
        let mesh = stl_io::read_stl(source).map_err(InvalidMesh::Unreadable)?;
        let vertices = mesh.vertices.iter();
        let vertices = vertices.map(|vertex| Vector3::from(vertex.0.map(f64::from)) * scale);
        let vertices: alloc::vec::Vec<Vector3<f64>> = vertices.collect();
        let triangles = mesh.faces.iter().map(|face| face.vertices);
        let triangles: alloc::vec::Vec<[usize; 3]> = triangles.collect();
        if !(scale > 0.0 && scale.is_finite()) {
            return Err(InvalidMesh::NotFinite);
        }
        Self::from_triangles(&vertices, &triangles, density)
    }

    /// Of a closed surface: vertices \[m\] in body axes from any origin, triangles by the numbers of
    /// their vertices, counterclockwise seen from outside; density in kg/m^3.
    ///
    /// Integrals over the tetrahedra between the triangles and a vertex, and again from the center of
    /// mass found (D. Eberly, Polyhedral Mass Properties (Revisited), has the same by the divergence
    /// theorem).
    ///
    /// # Errors
    /// [`InvalidMesh`], if the surface is open, inside out, empty or not finite.
    ///
    /// ```
    /// # use newton_euler::inertia::MassProperties;
    /// # use nalgebra::Vector3;
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
        let (mut volume, mut moment, mut size) = (0.0, Vector3::zeros(), 0.0_f64);
        for [a, b, c] in sides(first) {
            let part = a.dot(&b.cross(&c)) / 6.0;
            volume += part;
            moment += (a + b + c) * (part / 4.0);
            size = size.max(a.amax()).max(b.amax()).max(c.amax());
        }
        if volume.is_nan() || volume.abs() <= NOTHING * size * size * size {
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

/// Every edge is run along as often one way as the other.
fn check_closed(vertices: &[Vector3<f64>], triangles: &[[usize; 3]]) -> Result<(), InvalidMesh> {
    let mut edges: BTreeMap<[usize; 2], isize> = BTreeMap::new();
    for corners in triangles {
        if let Some(vertex) = corners.iter().find(|corner| **corner >= vertices.len()) {
            return Err(InvalidMesh::NoVertex { vertex: *vertex });
        }
        let [a, b, c] = *corners;
        for [from, to] in [[a, b], [b, c], [c, a]] {
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
