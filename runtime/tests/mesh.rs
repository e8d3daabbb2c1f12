//! Mass properties of closed meshes, beside those of the solids that they are.
#![allow(missing_docs)]

use std::fmt::Write;
use std::io::Cursor;

use nalgebra::{Matrix3, Vector3};
use newton_euler::inertia::{InvalidMesh, MassProperties};

type Mesh = (Vec<Vector3<f64>>, Vec<[usize; 3]>);

/// A cuboid from one corner to the opposite one.
fn cuboid(from: [f64; 3], to: [f64; 3]) -> Mesh {
    let corners = (0..8).map(|corner: usize| {
        let part = |axis: usize| {
            if corner >> axis & 1 == 0 {
                from[axis]
            } else {
                to[axis]
            }
        };
        Vector3::new(part(0), part(1), part(2))
    });
    let quads = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let halves = quads
        .iter()
        .flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]);
    (corners.collect(), halves.collect())
}

fn solid((vertices, triangles): &Mesh, density: f64) -> Result<MassProperties, InvalidMesh> {
    MassProperties::from_triangles(vertices, triangles, density)
}

fn matrix(properties: &MassProperties) -> Matrix3<f64> {
    let [xx, yy, zz] = properties.inertia.moments();
    let columns = [Vector3::x(), Vector3::y(), Vector3::z()];
    let columns = columns.map(|axis| properties.inertia.times(&axis));
    let whole = Matrix3::from_columns(&columns);
    assert!((whole.trace() - xx - yy - zz).abs() < 1e-12 * (xx + yy + zz));
    whole
}

fn of_cuboid(mass: f64, [a, b, c]: [f64; 3]) -> Matrix3<f64> {
    let [a, b, c] = [a * a, b * b, c * c];
    Matrix3::from_diagonal(&Vector3::new(b + c, a + c, a + b)) * (mass / 12.0)
}

/// By the theorem of parallel axes.
fn moved(inertia: Matrix3<f64>, mass: f64, arm: Vector3<f64>) -> Matrix3<f64> {
    inertia + (Matrix3::identity() * arm.norm_squared() - arm * arm.transpose()) * mass
}

#[test]
fn a_box_anywhere_is_the_solid() {
    for far in [0.0, 3.0, 1e6] {
        let box_ = cuboid([far - 0.2, 0.1, 0.3], [far + 0.2, 0.4, 0.35]);
        let found = solid(&box_, 700.0).unwrap();
        // what coordinates lose far from the origin
        let off = 1e-13 + 1e-15 * far;
        let mass = 700.0 * 0.4 * 0.3 * 0.05;
        assert!((found.mass - mass).abs() < 10.0 * off * mass);
        let center = Vector3::new(far, 0.25, 0.325);
        assert!((found.center - center).amax() < 1e-15 + 1e-15 * far);
        let expected = of_cuboid(mass, [0.4, 0.3, 0.05]);
        assert!((matrix(&found) - expected).amax() < 10.0 * off * expected.amax());
    }
}

#[test]
fn a_tetrahedron_has_its_moments() {
    // of legs a, b, c along the axes: xx = m (b^2 + c^2) 3 / 80, products m a b / 80
    let (a, b, c) = (0.3, 0.5, 0.7);
    let vertices = [[0.0; 3], [a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]].map(Vector3::from);
    let sides = vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
    let found = solid(&(vertices.to_vec(), sides), 100.0).unwrap();
    let mass = 100.0 * a * b * c / 6.0;
    assert!((found.mass - mass).abs() < 1e-15 * 10.0);
    assert!((found.center - Vector3::new(a, b, c) / 4.0).amax() < 1e-15);
    let expected = Matrix3::new(
        3.0 * (b * b + c * c),
        a * b,
        a * c,
        a * b,
        3.0 * (a * a + c * c),
        b * c,
        a * c,
        b * c,
        3.0 * (a * a + b * b),
    ) * (mass / 80.0);
    assert!((matrix(&found) - expected).amax() < 1e-15);
}

/// A sphere of so many rings, from an octahedron.
fn sphere(radius: f64, rings: usize) -> Mesh {
    let (mut vertices, mut triangles) = (vec![Vector3::z() * radius], Vec::new());
    let around = 2 * rings;
    for ring in 1..rings {
        for step in 0..around {
            #[allow(clippy::cast_precision_loss, reason = "small numbers")]
            let of = |part: usize, whole: usize| part as f64 / whole as f64;
            let (down, turn) = (
                std::f64::consts::PI * of(ring, rings),
                std::f64::consts::TAU * of(step, around),
            );
            let across = Vector3::new(turn.cos(), turn.sin(), 0.0) * down.sin();
            vertices.push((across + Vector3::z() * down.cos()) * radius);
        }
    }
    vertices.push(-Vector3::z() * radius);
    let last = vertices.len() - 1;
    let at = |ring: usize, step: usize| 1 + (ring - 1) * around + step % around;
    for step in 0..around {
        triangles.push([0, at(1, step), at(1, step + 1)]);
        triangles.push([last, at(rings - 1, step + 1), at(rings - 1, step)]);
        for ring in 1..rings - 1 {
            let [a, b] = [at(ring, step), at(ring, step + 1)];
            let [c, d] = [at(ring + 1, step), at(ring + 1, step + 1)];
            triangles.extend([[a, c, d], [a, d, b]]);
        }
    }
    (vertices, triangles)
}

#[test]
fn a_fine_sphere_comes_near_the_solid() {
    let errors = [40, 80].map(|rings| {
        let found = solid(&sphere(0.2, rings), 1000.0).unwrap();
        let mass = 1000.0 * 4.0 / 3.0 * std::f64::consts::PI * 0.008;
        let expected = 0.4 * mass * 0.04;
        assert!(found.center.amax() < 1e-14);
        let moments = found
            .inertia
            .moments()
            .map(|moment| (moment / expected - 1.0).abs());
        assert!((found.mass / mass - 1.0).abs() < 0.01);
        moments.into_iter().fold(0.0, f64::max)
    });
    // a quarter with twice the rings
    assert!(
        errors[1] < 3e-3 && (errors[0] / errors[1] - 4.0).abs() < 0.05,
        "{errors:?}"
    );
}

#[test]
fn an_angle_is_composed_of_two_boxes() {
    // an L of two boxes beside each other; where they touch, both have a side
    let (mut vertices, mut triangles) = cuboid([0.0, 0.0, 0.0], [1.0, 0.2, 0.3]);
    let (second, sides) = cuboid([0.0, 0.2, 0.0], [0.25, 0.9, 0.3]);
    let count = vertices.len();
    vertices.extend(second);
    triangles.extend(sides.iter().map(|side| side.map(|corner| corner + count)));
    let found = solid(&(vertices, triangles), 50.0).unwrap();
    let parts = [
        ([1.0, 0.2, 0.3], Vector3::new(0.5, 0.1, 0.15)),
        ([0.25, 0.7, 0.3], Vector3::new(0.125, 0.55, 0.15)),
    ];
    let masses = parts.map(|(size, _)| 50.0 * size.iter().product::<f64>());
    let mass = masses[0] + masses[1];
    let center = (parts[0].1 * masses[0] + parts[1].1 * masses[1]) / mass;
    let inertia = [0, 1].map(|part| {
        let (size, at) = parts[part];
        moved(of_cuboid(masses[part], size), masses[part], at - center)
    });
    assert!((found.mass - mass).abs() < 1e-14);
    assert!((found.center - center).amax() < 1e-15);
    assert!((matrix(&found) - inertia[0] - inertia[1]).amax() < 1e-14);
}

#[test]
fn what_holds_nothing_is_an_error() {
    let whole = cuboid([0.0; 3], [1.0, 2.0, 3.0]);
    let open = (whole.0.clone(), whole.1[1..].to_vec());
    assert!(matches!(solid(&open, 1.0), Err(InvalidMesh::Open { .. })));
    let mut one_turned = whole.clone();
    one_turned.1[3].swap(0, 1);
    assert!(matches!(
        solid(&one_turned, 1.0),
        Err(InvalidMesh::Open { .. })
    ));
    let mut inside_out = whole.clone();
    inside_out
        .1
        .iter_mut()
        .for_each(|corners| corners.swap(0, 1));
    assert!(matches!(
        solid(&inside_out, 1.0),
        Err(InvalidMesh::InsideOut)
    ));
    let flat = cuboid([0.0; 3], [1.0, 2.0, 0.0]);
    assert!(matches!(solid(&flat, 1.0), Err(InvalidMesh::Empty)));
    let none = (whole.0.clone(), Vec::new());
    assert!(matches!(solid(&none, 1.0), Err(InvalidMesh::Empty)));
    let mut unreal = whole.clone();
    unreal.0[2].y = f64::NAN;
    assert!(matches!(solid(&unreal, 1.0), Err(InvalidMesh::NotFinite)));
    for density in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            solid(&whole, density),
            Err(InvalidMesh::NotFinite)
        ));
    }
    let mut torn = whole;
    torn.1[0][0] = 9;
    assert!(matches!(
        solid(&torn, 1.0),
        Err(InvalidMesh::NoVertex { vertex: 9 })
    ));
}

/// As a text.
fn stl((vertices, triangles): &Mesh) -> String {
    let mut text = "solid part\n".to_owned();
    for corners in triangles {
        text.push_str("facet normal 0 0 0\nouter loop\n");
        for corner in corners {
            let at = vertices[*corner];
            writeln!(text, "vertex {} {} {}", at.x, at.y, at.z).unwrap();
        }
        text.push_str("endloop\nendfacet\n");
    }
    text + "endsolid part\n"
}

#[test]
fn files_are_read_in_their_unit() {
    let mesh = cuboid([0.0; 3], [100.0, 200.0, 50.0]);
    let text = stl(&mesh);
    let found = MassProperties::from_stl(&mut Cursor::new(&text), 1e-3, 1000.0).unwrap();
    assert!((found.mass - 1.0).abs() < 1e-14);
    assert!((found.center - Vector3::new(0.05, 0.1, 0.025)).amax() < 1e-16);
    let expected = of_cuboid(1.0, [0.1, 0.2, 0.05]);
    assert!((matrix(&found) - expected).amax() < 1e-16);
    for scale in [0.0, -1.0, f64::NAN] {
        let found = MassProperties::from_stl(&mut Cursor::new(&text), scale, 1000.0);
        assert!(matches!(found, Err(InvalidMesh::NotFinite)));
    }
    let cut = &text[..text.len() / 2];
    let found = MassProperties::from_stl(&mut Cursor::new(cut), 1.0, 1.0);
    assert!(found.is_err(), "{found:?}");
    let open = stl(&(mesh.0.clone(), mesh.1[2..].to_vec()));
    let found = MassProperties::from_stl(&mut Cursor::new(open), 1.0, 1.0);
    assert!(matches!(found, Err(InvalidMesh::Open { .. })), "{found:?}");
}

#[test]
fn triangles_without_area_change_nothing() {
    let mesh = cuboid([0.0; 3], [1.0, 2.0, 3.0]);
    let whole = solid(&mesh, 1.0).unwrap();
    let mut more = mesh.clone();
    more.1.extend([[0, 0, 1], [2, 2, 2], [0, 1, 1]]);
    let found = solid(&more, 1.0).unwrap();
    assert_eq!((found.mass, found.center), (whole.mass, whole.center));
    // the file has them as three positions, and both zeros
    let text = stl(&more).replacen("vertex 0 0 0", "vertex 0 -0 0", 1);
    let found = MassProperties::from_stl(&mut Cursor::new(text), 1.0, 1.0).unwrap();
    assert_eq!((found.mass, found.center), (whole.mass, whole.center));
}

#[test]
fn a_thin_wire_has_a_volume() {
    let wire = solid(&cuboid([0.0; 3], [1e3, 1e-4, 1e-4]), 1.0).unwrap();
    assert!((wire.mass / 1e-5 - 1.0).abs() < 1e-12, "{wire:?}");
    // a sheet that is folded on itself far from the origin
    let sheet = cuboid([1e6, 2e6, 3e6], [1e6 + 1.0, 2e6, 3e6 + 2.0]);
    assert!(matches!(solid(&sheet, 1.0), Err(InvalidMesh::Empty)));
}
