//! Positions and rotations.

use core::fmt::Write;

use crate::syntax::xml::decimal::{Angle, Decimal};
use crate::syntax::xml::reader::Reader;

use super::classes::{Element, TURNS};
use super::settings::Settings;

/// A rotation about an axis, as written and as numbers.
pub struct Turn {
    /// `(x, y, z)`
    axis: String,
    angle: String,
    quaternion: [f64; 4],
}

/// `pos` and one of `quat`, `axisangle`, `euler`, `xyaxes` and `zaxis`; rotations in sequence.
pub struct Place {
    pub place: [Decimal; 3],
    pub turns: Vec<Turn>,
}

pub const PLACE: [&str; 6] = ["pos", TURNS[0], TURNS[1], TURNS[2], TURNS[3], TURNS[4]];
const UNITS: [&str; 3] = ["(1, 0, 0)", "(0, 1, 0)", "(0, 0, 1)"];

impl Turn {
    fn new(axis: String, of: [f64; 3], angle: String, value: f64) -> Self {
        let size = of.iter().map(|part| part * part).sum::<f64>().sqrt();
        let (sine, cosine) = (value / 2.0).sin_cos();
        let [x, y, z] = of.map(|part| part / size * sine);
        Self {
            axis,
            angle,
            quaternion: [cosine, x, y, z],
        }
    }

    fn about(axis: usize, angle: String, value: f64) -> Self {
        let mut of = [0.0; 3];
        of[axis] = 1.0;
        Self::new(UNITS[axis].to_owned(), of, angle, value)
    }
}

/// `(x, y, z)`
pub fn tuple(parts: &[Decimal]) -> String {
    let parts: Vec<String> = parts.iter().map(Decimal::literal).collect();
    format!("({})", parts.join(", "))
}

/// `.turned(body(x, y, z), angle)` for each rotation, in sequence.
pub fn turned(turns: &[Turn]) -> String {
    let mut text = String::new();
    for Turn { axis, angle, .. } in turns {
        let _ = write!(text, ".turned(body{axis}, {angle})");
    }
    text
}

/// The same for an inertia: its rotations come in the reverse order of those of its axes.
pub fn turned_inertia(turns: &[Turn]) -> String {
    let mut text = String::new();
    for Turn { axis, angle, .. } in turns.iter().rev() {
        let _ = write!(text, ".turned(body{axis}, {angle})");
    }
    text
}

/// The product `a * b` of two quaternions with the real part first.
pub fn product(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
    let [aw, ax, ay, az] = a;
    let [bw, bx, by, bz] = b;
    [
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    ]
}

pub fn inverse([w, x, y, z]: [f64; 4]) -> [f64; 4] {
    [w, -x, -y, -z]
}

pub fn rotate(q: [f64; 4], [x, y, z]: [f64; 3]) -> [f64; 3] {
    let [_, x, y, z] = product(product(q, [0.0, x, y, z]), inverse(q));
    [x, y, z]
}

impl Place {
    pub fn quaternion(&self) -> [f64; 4] {
        let all = self.turns.iter().map(|turn| turn.quaternion);
        all.fold([1.0, 0.0, 0.0, 0.0], product)
    }
}

/// The length of a vector, as an expression and as a number.
fn length(parts: &[Decimal]) -> (String, f64) {
    let squares = parts.iter().filter(|part| !part.is_zero());
    let squares: Vec<&Decimal> = squares.collect();
    let value = squares.iter().map(|part| part.value().powi(2)).sum::<f64>();
    if let [only] = squares.as_slice() {
        let text = only.literal();
        return (text.trim_start_matches('-').to_owned(), value.sqrt());
    }
    let squares: Vec<String> = squares
        .iter()
        .map(|part| format!("({}).powi(2)", part.literal()))
        .collect();
    (format!("({}).sqrt()", squares.join(" + ")), value.sqrt())
}

impl Reader<'_> {
    pub fn place(&mut self, element: &Element<'_, '_>, settings: &Settings) -> Place {
        let place = self.triple(element, "pos", "0 0 0");
        let given = TURNS.iter().filter(|name| element.has(name));
        let given: Vec<&str> = given.copied().collect();
        if let [_, second, ..] = given.as_slice() {
            let message = format!(
                "it is turned by `{}` already: leave `{second}` out",
                given[0]
            );
            self.report::<()>(element.node, message);
        }
        let turns = match given.first() {
            None => Vec::new(),
            Some(name) => self.turns(element, name, settings),
        };
        Place { place, turns }
    }

    fn turns(&mut self, element: &Element<'_, '_>, name: &str, settings: &Settings) -> Vec<Turn> {
        match name {
            "quat" => self.quaternion(element),
            "euler" => {
                let angles = self.triple(element, name, "0 0 0");
                let mut turns = Vec::new();
                for ((axis, is_fixed), angle) in settings.order.iter().zip(&angles) {
                    let turn = settings.angle(angle);
                    let turn = turn.map(|(text, value)| Turn::about(*axis, text, value));
                    // a rotation about a fixed axis precedes those about axes that it rotates
                    let place = if *is_fixed { 0 } else { turns.len() };
                    turns.splice(place..place, turn);
                }
                turns
            }
            "axisangle" => {
                let all = self.list(element, name, 4..=4, "0 0 1 0");
                let angle = settings.angle(&all[3]);
                if !self.has_direction(element, name, &all[..3]) {
                    return Vec::new();
                }
                let of = [0, 1, 2].map(|axis| all[axis].value());
                let turn = angle.map(|(text, value)| Turn::new(tuple(&all[..3]), of, text, value));
                turn.into_iter().collect()
            }
            "zaxis" => {
                let all = self.triple(element, name, "0 0 1");
                if self.has_direction(element, name, &all) {
                    shortest(&all).into_iter().collect()
                } else {
                    Vec::new()
                }
            }
            _ => {
                let all = self.list(element, name, 6..=6, "1 0 0 0 1 0");
                let is_plane = self.has_direction(element, name, &all[..3])
                    && self.has_direction(element, name, &all[3..])
                    && self.are_across(element, &all);
                if is_plane { axes(&all) } else { Vec::new() }
            }
        }
    }

    pub fn has_direction(&mut self, element: &Element<'_, '_>, name: &str, of: &[Decimal]) -> bool {
        let is_zero = of.iter().all(Decimal::is_zero);
        if is_zero {
            let message = format!("`{name}`: the zero vector has no direction");
            self.report::<()>(element.node, message);
        }
        !is_zero
    }

    /// Checks that two axes are not parallel.
    fn are_across(&mut self, element: &Element<'_, '_>, all: &[Decimal]) -> bool {
        let of = |place: usize| all[place].value();
        let [x, y, z] =
            [(1, 2), (2, 0), (0, 1)].map(|(a, b)| of(a) * of(b + 3) - of(b) * of(a + 3));
        let size = |start: usize| (0..3).map(|part| of(start + part).powi(2)).sum::<f64>();
        let is_sound = x * x + y * y + z * z > 1e-24 * size(0) * size(3);
        if !is_sound {
            self.report::<()>(element.node, "`xyaxes`: these axes are parallel");
        }
        is_sound
    }

    /// `quat="w x y z"`, of any nonzero length.
    fn quaternion(&mut self, element: &Element<'_, '_>) -> Vec<Turn> {
        let all = self.list(element, "quat", 4..=4, "1 0 0 0");
        if !self.has_direction(element, "quat", &all) {
            return Vec::new();
        }
        let (real, axis) = (&all[0], &all[1..]);
        if axis.iter().all(Decimal::is_zero) {
            return Vec::new();
        }
        let (text, size) = length(axis);
        let of = [0, 1, 2].map(|part| axis[part].value());
        let (angle, value) = if real.is_zero() {
            ("180[deg]".to_owned(), core::f64::consts::PI)
        } else if real.literal().trim_start_matches('-') == text {
            let quarters = if real.is_negative() { 3.0 } else { 1.0 };
            (
                format!("{}[deg]", 90.0 * quarters),
                core::f64::consts::FRAC_PI_2 * quarters,
            )
        } else {
            let angle = format!("2 * ({text}).atan2({})", real.literal());
            (angle, 2.0 * size.atan2(real.value()))
        };
        vec![Turn::new(tuple(axis), of, angle, value)]
    }
}

/// The rotation by the smallest angle that takes z to a direction.
pub fn shortest(to: &[Decimal]) -> Option<Turn> {
    let across = &to[..2];
    if across.iter().all(Decimal::is_zero) {
        let turn = || Turn::about(0, "180[deg]".to_owned(), core::f64::consts::PI);
        return to[2].is_negative().then(turn);
    }
    let (text, size) = length(across);
    let (x, y) = (&to[0], &to[1]);
    let axis = format!("({}, {}, 0)", y.negated().literal(), x.literal());
    let angle = if to[2].is_zero() {
        "90[deg]".to_owned()
    } else {
        format!("({text}).atan2({})", to[2].literal())
    };
    let of = [-y.value(), x.value(), 0.0];
    Some(Turn::new(axis, of, angle, size.atan2(to[2].value())))
}

/// Rotations about z, y and x. They take the x axis to the direction of the first three numbers,
/// and the y axis into the plane of both given vectors.
fn axes(all: &[Decimal]) -> Vec<Turn> {
    let [xx, xy, xz, yx, yy, yz] =
        [0, 1, 2, 3, 4, 5].map(|part| (all[part].literal(), all[part].value()));
    let mut turns = Vec::new();
    let (flat, flat_value) = length(&all[..2]);
    if all[..2].iter().all(Decimal::is_zero) {
        // x points along z; what remains is a rotation about x
        let up = if xz.1 > 0.0 { -1.0 } else { 1.0 };
        turns.push(Turn::about(
            1,
            format!("{}[deg]", 90.0 * up),
            core::f64::consts::FRAC_PI_2 * up,
        ));
        let angle = format!("({} * ({})).atan2({})", up, yx.0, yy.0);
        turns.push(Turn::about(0, angle, (up * yx.1).atan2(yy.1)));
        return turns;
    }
    if !all[1].is_zero() || all[0].is_negative() {
        turns.push(Turn::about(
            2,
            format!("({}).atan2({})", xy.0, xx.0),
            xy.1.atan2(xx.1),
        ));
    }
    if !all[2].is_zero() {
        turns.push(Turn::about(
            1,
            format!("-({}).atan2({flat})", xz.0),
            -xz.1.atan2(flat_value),
        ));
    }
    // the components of the given y along the rotated y and z axes, multiplied by lengths of x
    let (whole, whole_value) = length(&all[..3]);
    let second = format!(
        "(({}) * ({}) - ({}) * ({})) * {whole}",
        yy.0, xx.0, yx.0, xy.0
    );
    let third = format!(
        "{flat}.powi(2) * ({}) - ({}) * (({}) * ({}) + ({}) * ({}))",
        yz.0, xz.0, yx.0, xx.0, yy.0, xy.0
    );
    let second_value = (yy.1 * xx.1 - yx.1 * xy.1) * whole_value;
    let third_value = flat_value.powi(2) * yz.1 - xz.1 * (yx.1 * xx.1 + yy.1 * xy.1);
    turns.push(Turn::about(
        0,
        format!("({third}).atan2({second})"),
        third_value.atan2(second_value),
    ));
    turns
}

impl Settings {
    /// An angle as it is written here, and in radians; `None` if it is zero.
    pub fn angle(&self, angle: &Decimal) -> Option<(String, f64)> {
        let value = angle.value();
        if self.is_radian {
            return match angle.angle()? {
                Angle::Right(0, _) => None,
                Angle::Right(count, _) => Some((format!("{}[deg]", 90 * count), value)),
                Angle::General(_) => Some((angle.literal(), value)),
            };
        }
        let text = || format!("{}[deg]", angle.literal());
        (!angle.is_zero()).then(|| (text(), value.to_radians()))
    }
}
