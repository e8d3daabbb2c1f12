//! Generated bodies, built from arbitrary parameters.

use fastrand::Rng;
use newton_euler::prelude::*;

use super::inertia::entries;
use super::numbers::{all, any, either};
use super::{Verdict, compare, exact};

rigid_body!(Brick {
    doc: "A body in space whose mass and inertia are parameters, and a point of it.",
    motion: spatial,
    params: [m[kg], xx, yy, zz, xy, yz, zx, tip = body(_, _, _)[m]],
    inputs: [push = world(_, _, _)[N]],
    mass: m,
    inertia: tensor {
        xx: xx,
        yy: yy,
        zz: zz,
        xy: xy,
        yz: yz,
        zx: zx
    }[kg * m ^ 2],
    points: [hook = tip],
    forces: [pushed = push.at(hook)],
});

rigid_body!(Plate {
    doc: "A body in the plane whose mass and inertia are parameters.",
    motion: planar,
    params: [m[kg], j[kg * m ^ 2]],
    inputs: [push = world(_, _)[N], twist[N * m]],
    mass: m,
    inertia: j,
    forces: [pushed = push],
    moments: [twisted = twist],
});

pub fn build(rng: &mut Rng) {
    let [m, j] = all(rng, any);
    let can_be = if m > 0.0 && j > 0.0 {
        exact::finite(&[m, j])
    } else {
        Verdict::Impossible
    };
    compare(
        &[m, j],
        in_range(can_be, &[m, j]),
        &Plate::new(PlateParams { m, j }).map(|_| ()),
    );

    let [xx, yy, zz, xy, yz, zx] = entries(rng);
    let tensor = [xx, yy, zz, xy, yz, zx];
    let number = either(rng, 8);
    let [m, x, y, z] = all(rng, number);
    let mut verdict = exact::all([exact::finite(&[m, x, y, z]), exact::tensor(&tensor)]);
    if verdict != Verdict::Impossible {
        let largest = xx.max(yy).max(zz);
        if m <= 0.0 || !exact::turns(&tensor, 0.0) {
            verdict = Verdict::Impossible;
        } else if !exact::turns(&tensor, 64.0 * f64::EPSILON * largest) {
            verdict = Verdict::Marginal;
        }
    }
    let verdict = in_range(verdict, &[m, xx.max(yy).max(zz)]);
    let params = BrickParams {
        m,
        xx,
        yy,
        zz,
        xy,
        yz,
        zx,
        tip: [x, y, z].into(),
    };
    compare(
        &(m, tensor, [x, y, z]),
        verdict,
        &Brick::new(params).map(|_| ()),
    );
}

/// What is computed once from the parameters may leave the range of doubles where they are large or small.
fn in_range(verdict: Verdict, numbers: &[f64]) -> Verdict {
    let is_ordinary = numbers
        .iter()
        .all(|number| (1e-90..1e90).contains(&number.abs()));
    if verdict == Verdict::Possible && !is_ordinary {
        Verdict::Marginal
    } else {
        verdict
    }
}
