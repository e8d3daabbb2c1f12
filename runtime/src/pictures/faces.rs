//! Faces of solids, as elements of a page.

use std::fmt::Write as _;
use std::string::String;
use std::vec::Vec;

use nalgebra::Vector3;

use super::markup::{COLORS, short};

/// An element for each face: its plane, its outline and its shade. `scale` is in pixels per meter.
pub(super) fn elements(faces: &[Vec<Vector3<f64>>], color: usize, scale: f64) -> String {
    let mut out = String::new();
    for face in faces {
        let Some((corner, axes)) = plane(face) else {
            continue;
        };
        let flat: Vec<[f64; 2]> = face
            .iter()
            .map(|point| [0, 1].map(|axis| scale * axes[axis].dot(&(point - corner))))
            .collect();
        let low = [0, 1].map(|axis| flat.iter().map(|at| at[axis]).fold(f64::INFINITY, f64::min));
        let high = [0, 1].map(|axis| {
            let all = flat.iter().map(|at| at[axis]);
            all.fold(f64::NEG_INFINITY, f64::max)
        });
        let outline: Vec<_> = flat
            .iter()
            .map(|[x, y]| std::format!("{}px {}px", short(x - low[0], 1), short(y - low[1], 1)))
            .collect();
        let origin = corner * scale + axes[0] * low[0] + axes[1] * low[1];
        let column = |vector: &Vector3<f64>, decimals| {
            let numbers = vector.iter().map(|number| short(*number, decimals));
            numbers.collect::<Vec<_>>().join(",")
        };
        let _ = write!(
            out,
            "<i style=\"width:{}px;height:{}px;background:{};clip-path:polygon({});\
             transform:matrix3d({},0,{},0,{},0,{},1)\"></i>",
            short(high[0] - low[0], 1),
            short(high[1] - low[1], 1),
            shade(&axes[2], color),
            outline.join(","),
            column(&axes[0], 4),
            column(&axes[1], 4),
            column(&axes[2], 4),
            column(&origin, 1),
        );
    }
    out
}

/// A corner of a face, two axes in its plane and its normal; none if the face has no area.
fn plane(face: &[Vector3<f64>]) -> Option<(Vector3<f64>, [Vector3<f64>; 3])> {
    let (corner, rest) = face.split_first()?;
    let along = rest.first()? - corner;
    let mut normals = rest.iter().map(|other| along.cross(&(other - corner)));
    let normal = normals.find_map(|normal| normal.try_normalize(0.0))?;
    let along = along.try_normalize(0.0)?;
    Some((*corner, [along, normal.cross(&along), normal]))
}

/// A color in the light of a lamp that moves with the body.
fn shade(normal: &Vector3<f64>, color: usize) -> String {
    let light = normal.dot(&Vector3::new(0.35, -0.45, 0.82));
    let shaded = COLORS[color % COLORS.len()].map(|part| {
        let part = f64::from(part);
        let shaded = if light > 0.0 {
            part + (255.0 - part) * 0.45 * light
        } else {
            part * (1.0 + 0.4 * light)
        };
        std::format!("{shaded:.0}")
    });
    std::format!("rgb({})", shaded.join(","))
}
