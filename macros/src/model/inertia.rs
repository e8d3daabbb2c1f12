//! Inertia: from the words `principal`, `tensor` and `products` to the tensor about G, checked.
//!
//! A tensor is possible if it is symmetric and half its trace minus itself is positive
//! semidefinite, which is the triangle inequality in every frame (EQUATIONS.md, F08). Literals are
//! checked exactly; equality, a flat body, is allowed.

use proc_macro2::Ident;

use crate::errors::Extent;
use crate::symbolic::{Components, Graph, Id, Number};
use crate::syntax::{Expression, Kind};

use super::dimension::Dimension;
use super::lower::Lowering;
use super::unit::lower_unit;
use super::value::Point;

/// Entries of a symmetric matrix, by row and column.
const ENTRIES: [(&str, usize, usize); 6] = [
    ("xx", 0, 0),
    ("yy", 1, 1),
    ("zz", 2, 2),
    ("xy", 0, 1),
    ("yz", 1, 2),
    ("zx", 2, 0),
];

/// Names of the axes in messages.
const AXES: [&str; 3] = ["x", "y", "z"];

/// The inertia of a body about G, in body axes.
#[derive(Clone, Copy, Debug)]
pub enum Inertia {
    /// The body does not turn, or nothing was said.
    Absent,
    /// About the axis through G normal to the plane.
    Planar(Id),
    /// The tensor, by rows.
    Spatial([Components; 3]),
}

/// An inertia as it was written, with the places to blame.
struct Draft {
    inertia: Inertia,
    /// Entries, the expression of each, and whether it is a plain literal that can be mended.
    parts: Vec<Part>,
    extent: Extent,
}

struct Part {
    row: usize,
    column: usize,
    extent: Extent,
    literal: Option<Number>,
    digits: String,
}

impl Lowering<'_> {
    /// Lowers the value of `inertia:` and checks it as far as it is known; `defaults` are the
    /// values of parameters that a body is built from when nothing else is said.
    pub fn inertia(
        &mut self,
        written: &Expression,
        mass: Option<Id>,
        defaults: impl Fn(Id) -> Option<Id>,
    ) -> Option<Inertia> {
        let draft = self.draft(written, mass)?;
        self.check_inertia(&draft, defaults)?;
        Some(draft.inertia)
    }

    fn draft(&mut self, written: &Expression, mass: Option<Id>) -> Option<Draft> {
        match &written.kind {
            Kind::Unit(inner, unit) if !is_scalar(inner) => {
                let draft = self.draft(inner, mass);
                let (factor, dimension) = lower_unit(unit, self.errors)?;
                let draft = draft?;
                if !dimension.fits(Dimension::INERTIA) {
                    return self.report(
                        unit.extent,
                        format!(
                            "an inertia is in {}, and this is {dimension}",
                            Dimension::INERTIA
                        ),
                    );
                }
                let factor = self.frames.graph.number(factor);
                Some(Draft {
                    inertia: self.scaled_inertia(factor, draft.inertia),
                    ..draft
                })
            }
            Kind::Method(inner, method, arguments) if method == "about" => {
                let draft = self.draft(inner, mass);
                let [point] = arguments.as_slice() else {
                    return self
                        .report(method.span(), "`.about` takes one point: write `.about(P)`");
                };
                let point = self.point(point)?;
                self.moved_to_center(draft?, point, mass, method)
            }
            Kind::Call(word, parts) if word == "principal" => {
                self.principal(word, parts, written.extent)
            }
            Kind::Record(word, fields) => self.record(word, fields, written.extent),
            Kind::Call(word, _) if SOLIDS.contains(&word.to_string().as_str()) => self.report(
                word.span(),
                format!(
                    "`{word}(..)` is part of the language, but this version does not have it yet"
                ),
            ),
            _ if self.motion.is_planar() => {
                let moment = self.scalar(written, Dimension::INERTIA, "the inertia about G")?;
                let part = Part {
                    row: 2,
                    column: 2,
                    extent: written.extent,
                    literal: None,
                    digits: String::new(),
                };
                Some(Draft {
                    inertia: Inertia::Planar(moment),
                    parts: vec![part],
                    extent: written.extent,
                })
            }
            Kind::Call(word, _) => self.report(
                word.span(),
                format!("unknown form of inertia `{word}`: {FORMS}"),
            ),
            _ => self.report(written.extent, FORMS),
        }
    }

    fn refuse_in_plane(&mut self, word: &Ident) -> Option<()> {
        if self.motion.is_planar() {
            return self.report(word.span(), "in the plane an inertia is one number, about the axis through G: write `inertia: 0.1[kg * m ^ 2]`");
        }
        Some(())
    }

    fn principal(&mut self, word: &Ident, parts: &[Expression], extent: Extent) -> Option<Draft> {
        self.refuse_in_plane(word)?;
        if parts.len() != 3 {
            return self.report(
                word.span(),
                format!(
                    "`principal` takes three moments of inertia, and this has {}",
                    parts.len()
                ),
            );
        }
        let moments: Vec<Option<Id>> = parts
            .iter()
            .map(|part| self.scalar(part, Dimension::INERTIA, "a moment of inertia"))
            .collect();
        let mut rows = [self.frames.graph.zeros(); 3];
        for (i, moment) in moments.into_iter().enumerate() {
            rows[i][i] = moment?;
        }
        let parts = parts
            .iter()
            .enumerate()
            .map(|(i, part)| Part::new(i, i, part))
            .collect();
        Some(Draft {
            inertia: Inertia::Spatial(rows),
            parts,
            extent,
        })
    }

    /// `tensor { .. }` has the entries of the tensor, `products { .. }` the products of inertia
    /// `J_xy = +integral of x y dm`: their off-diagonals differ in sign (E3).
    fn record(
        &mut self,
        word: &Ident,
        fields: &[(Ident, Expression)],
        extent: Extent,
    ) -> Option<Draft> {
        if word != "tensor" && word != "products" {
            return self.report(
                word.span(),
                format!("unknown form of inertia `{word}`: {FORMS}"),
            );
        }
        self.refuse_in_plane(word)?;
        let mut rows = [self.frames.graph.zeros(); 3];
        let mut parts = Vec::new();
        let mut complete = true;
        for (index, (name, value)) in fields.iter().enumerate() {
            let known = name.to_string();
            let Some((_, row, column)) = ENTRIES.iter().find(|(entry, ..)| *entry == known) else {
                let reversed: String = known.chars().rev().collect();
                let hint = if ENTRIES.iter().any(|(entry, ..)| *entry == reversed) {
                    format!(": the matrix is symmetric, write `{reversed}`")
                } else {
                    String::new()
                };
                self.errors.push(
                    name.span(),
                    format!(
                        "no entry `{known}`; there are `xx`, `yy`, `zz`, `xy`, `yz` and `zx`{hint}"
                    ),
                );
                complete = false;
                continue;
            };
            if fields[..index].iter().any(|(other, _)| other == name) {
                self.errors
                    .push(name.span(), format!("`{known}` is given twice"));
                complete = false;
            }
            let Some(entry) = self.scalar(value, Dimension::INERTIA, "an entry of the inertia")
            else {
                complete = false;
                continue;
            };
            let entry = if word == "products" && row != column {
                self.frames.graph.negate(entry)
            } else {
                entry
            };
            rows[*row][*column] = entry;
            rows[*column][*row] = entry;
            parts.push(Part::new(*row, *column, value));
        }
        for diagonal in ["xx", "yy", "zz"] {
            if complete && !fields.iter().any(|(name, _)| name == diagonal) {
                self.errors.push(
                    word.span(),
                    format!("`{diagonal}` is missing: all three moments of inertia are needed"),
                );
                complete = false;
            }
        }
        complete.then_some(Draft {
            inertia: Inertia::Spatial(rows),
            parts,
            extent,
        })
    }

    fn scaled_inertia(&mut self, factor: Id, inertia: Inertia) -> Inertia {
        let graph = &mut self.frames.graph;
        match inertia {
            Inertia::Absent => Inertia::Absent,
            Inertia::Planar(moment) => Inertia::Planar(graph.multiply(factor, moment)),
            Inertia::Spatial(rows) => {
                Inertia::Spatial(rows.map(|row| graph.scale_vector(factor, row)))
            }
        }
    }

    /// The parallel-axis theorem, exactly: `J_G = J_P - m (r^2 1 - r r)`.
    fn moved_to_center(
        &mut self,
        draft: Draft,
        point: Point,
        mass: Option<Id>,
        place: &Ident,
    ) -> Option<Draft> {
        let Point::Body(r) = point else {
            return self.report(place.span(), "the inertia is constant only about a point of the body, and this one is fixed in space");
        };
        let Some(mass) = mass else {
            return self.report(
                place.span(),
                "`.about(P)` needs the mass of the body: write `mass: ..`",
            );
        };
        let graph = &mut self.frames.graph;
        let square = graph.norm_squared(r);
        let minus_mass = graph.negate(mass);
        let mut change = |i: usize, j: usize, entry: Id| {
            let product = graph.multiply(r[i], r[j]);
            let lever = if i == j {
                graph.subtract(square, product)
            } else {
                graph.negate(product)
            };
            let change = graph.multiply(minus_mass, lever);
            graph.add(entry, change)
        };
        let inertia = match draft.inertia {
            Inertia::Absent => Inertia::Absent,
            Inertia::Planar(moment) => Inertia::Planar(change(2, 2, moment)),
            Inertia::Spatial(rows) => {
                Inertia::Spatial([0, 1, 2].map(|i| [0, 1, 2].map(|j| change(i, j, rows[i][j]))))
            }
        };
        Some(Draft { inertia, ..draft })
    }

    fn check_inertia(&mut self, draft: &Draft, defaults: impl Fn(Id) -> Option<Id>) -> Option<()> {
        let graph = &mut self.frames.graph;
        match draft.inertia {
            Inertia::Absent => Some(()),
            Inertia::Planar(moment) => {
                let known = graph.substitute(&[moment], defaults);
                match graph.as_number(known[0]) {
                    Some(number) if !number.is_positive() => {
                        let value = number.to_f64();
                        self.report(
                            draft.extent,
                            format!(
                                "the inertia of a body that turns is positive, and J_G = {value}"
                            ),
                        )
                    }
                    _ => Some(()),
                }
            }
            Inertia::Spatial(rows) => {
                let entries: Vec<Id> = rows.into_iter().flatten().collect();
                let known = graph.substitute(&entries, defaults);
                let numbers: Option<Vec<Number>> = known
                    .iter()
                    .map(|id| graph.as_number(*id).cloned())
                    .collect();
                let Some(numbers) = numbers else {
                    return Some(());
                };
                let matrix: [[Number; 3]; 3] =
                    core::array::from_fn(|i| core::array::from_fn(|j| numbers[3 * i + j].clone()));
                let Some(violation) = Violation::find(&matrix) else {
                    return Some(());
                };
                self.report_violation(draft, &violation, &matrix)
            }
        }
    }

    fn report_violation(
        &mut self,
        draft: &Draft,
        violation: &Violation,
        matrix: &[[Number; 3]; 3],
    ) -> Option<()> {
        let blamed = draft
            .parts
            .iter()
            .find(|part| violation.concerns(part.row, part.column));
        let message = format!("no body has this inertia: {}", violation.message);
        match mend(draft, matrix) {
            Some((part, mended)) => self.report(part.extent, format!("{message}; is a decimal point out of place? `{mended}` instead of `{}` would do", part.digits)),
            None => self.report(blamed.map_or(draft.extent, |part| part.extent), message),
        }
    }
}

const FORMS: &str = "write `principal(a, b, c)`, `tensor { xx, yy, zz, xy, yz, zx }` or `products { .. }`; tensor and products differ in the sign of the off-diagonals, so the word must be said";

/// Solids of a later version.
const SOLIDS: [&str; 11] = [
    "cuboid",
    "box",
    "sphere",
    "shell",
    "cylinder",
    "tube",
    "cone",
    "ellipsoid",
    "disc",
    "torus",
    "compose",
];

fn is_scalar(expression: &Expression) -> bool {
    match &expression.kind {
        Kind::Call(..) | Kind::Record(..) => false,
        Kind::Method(inner, method, _) => method != "about" || is_scalar(inner),
        _ => true,
    }
}

impl Part {
    fn new(row: usize, column: usize, value: &Expression) -> Self {
        let literal = match &value.kind {
            Kind::Number(digits) => Some(digits),
            Kind::Unit(inner, _) => match &inner.kind {
                Kind::Number(digits) => Some(digits),
                _ => None,
            },
            _ => None,
        };
        Self {
            row,
            column,
            extent: value.extent,
            literal: literal.and_then(|digits| Number::parse(digits)),
            digits: literal.cloned().unwrap_or_default(),
        }
    }
}

/// A condition that a matrix violates, and the entry to blame.
struct Violation {
    row: usize,
    column: usize,
    message: String,
}

impl Violation {
    fn concerns(&self, row: usize, column: usize) -> bool {
        (self.row, self.column) == (row, column) || (self.column, self.row) == (row, column)
    }

    /// The first violated condition, from the simplest to the most general.
    fn find(j: &[[Number; 3]; 3]) -> Option<Self> {
        for (i, axis) in AXES.iter().enumerate() {
            if !j[i][i].is_positive() {
                let value = j[i][i].to_f64();
                return Some(Self {
                    row: i,
                    column: i,
                    message: format!(
                        "its moment about {axis} is {value}, and moments of inertia are positive"
                    ),
                });
            }
        }
        let half = Number::ratio(1, 2);
        let trace = j[0][0].clone() + j[1][1].clone() + j[2][2].clone();
        let sigma = |i: usize, k: usize| {
            if i == k {
                half.clone() * trace.clone() - j[i][i].clone()
            } else {
                -j[i][k].clone()
            }
        };
        for (i, axis) in AXES.iter().enumerate() {
            let (k, l) = ((i + 1) % 3, (i + 2) % 3);
            if sigma(i, i).is_negative() {
                let (largest, sum) = (
                    j[i][i].to_f64(),
                    (j[k][k].clone() + j[l][l].clone()).to_f64(),
                );
                let message = format!(
                    "its moment about {axis} is larger than the other two together ({largest:e} > {sum:e})"
                );
                return Some(Self {
                    row: i,
                    column: i,
                    message,
                });
            }
        }
        for (i, k) in [(0, 1), (1, 2), (2, 0)] {
            if (sigma(i, i) * sigma(k, k) - sigma(i, k) * sigma(i, k)).is_negative() {
                let message = format!(
                    "the product of inertia in {}{} is too large for its moments of inertia",
                    AXES[i], AXES[k]
                );
                return Some(Self {
                    row: i,
                    column: k,
                    message,
                });
            }
        }
        let whole = |row: &'static str| {
            Some(Self {
                row: 3,
                column: 3,
                message: row.to_owned(),
            })
        };
        if determinant(&sigma).is_negative() {
            return whole(
                "turned to its principal axes, one moment is larger than the other two together",
            );
        }
        if !determinant(&|i, k| j[i][k].clone()).is_positive() {
            return whole("turned to its principal axes, one moment is not positive");
        }
        None
    }
}

fn determinant(m: &impl Fn(usize, usize) -> Number) -> Number {
    let minor = |i: usize, k: usize| m(1, i) * m(2, k) - m(1, k) * m(2, i);
    m(0, 0) * minor(1, 2) - m(0, 1) * minor(0, 2) + m(0, 2) * minor(0, 1)
}

/// The one literal, if there is only one, that a moved decimal point turns into a possible inertia.
fn mend<'d>(draft: &'d Draft, matrix: &[[Number; 3]; 3]) -> Option<(&'d Part, String)> {
    for shift in 1..=3 {
        let mut found = Vec::new();
        for part in &draft.parts {
            let Some(literal) = &part.literal else {
                continue;
            };
            for power in [shift, -shift] {
                let factor = Number::power_of_ten(power);
                let mut mended = matrix.clone();
                mended[part.row][part.column] =
                    mended[part.row][part.column].clone() * factor.clone();
                mended[part.column][part.row] = mended[part.row][part.column].clone();
                if Violation::find(&mended).is_none() {
                    found.push((part, format!("{}", (literal.clone() * factor).to_f64())));
                }
            }
        }
        match found.len() {
            0 => {}
            1 => return found.pop(),
            _ => return None,
        }
    }
    None
}

/// The six entries of a symmetric matrix, in the order xx, yy, zz, xy, yz, zx.
pub fn entries(_: &Graph, rows: &[Components; 3]) -> [Id; 6] {
    ENTRIES.map(|(_, row, column)| rows[row][column])
}
