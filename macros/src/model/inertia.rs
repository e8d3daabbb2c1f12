//! Inertia: from the words `principal`, `tensor` and `products` to the tensor about G, checked.

use proc_macro2::Ident;

use crate::errors::Extent;
use crate::symbolic::{Components, Id};
use crate::syntax::{Description, Expression, Kind};

use super::definitions::Mass;
use super::dimension::Dimension;
use super::draft::{Draft, Part};
use super::lower::Lowering;
use super::outline::written_motion;
use super::parameters::Defaults;
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

impl Lowering<'_> {
    /// Lowers the value of `inertia:` and checks it as far as it is known; `defaults` are the
    /// values of parameters that a body is built from when nothing else is said.
    pub fn inertia(
        &mut self,
        description: &Description,
        mass: Mass,
        defaults: &Defaults,
    ) -> Option<Inertia> {
        let name = &description.name;
        let Some(written) = &description.inertia else {
            if !self.motion.has_attitude() {
                return Some(Inertia::Absent);
            }
            written_motion(description)?;
            let form = if self.motion.is_planar() {
                "0.1[kg * m ^ 2]"
            } else {
                "principal(1, 2, 3)[kg * m ^ 2]"
            };
            return self.report(
                name.span(),
                format!("`{name}` turns and has no inertia: write `inertia: {form}`"),
            );
        };
        let value = written.value.as_ref()?;
        // what is not needed is read all the same, so that its mistakes are found
        let draft = self.draft(value, mass)?;
        let entries = draft.inertia.entries();
        if !entries.iter().all(|id| self.frames.graph.is_early(*id)) {
            let place = self.late_name(value);
            return self.report(
                place,
                "the inertia is constant in body axes: it cannot depend on the time, the state \
                 or an input",
            );
        }
        self.check_inertia(&draft, |id| defaults.get(&id).copied())?;
        Some(if self.motion.has_attitude() {
            draft.inertia
        } else {
            Inertia::Absent
        })
    }

    fn draft(&mut self, written: &Expression, mass: Mass) -> Option<Draft> {
        match &written.kind {
            Kind::Unit(inner, unit) if !is_scalar(inner) => {
                let draft = self.draft(inner, mass);
                let (factor, dimension) = lower_unit(unit, self.errors)?;
                let draft = draft?;
                if !dimension.fits(Dimension::INERTIA) {
                    let (expected, found) = (Dimension::INERTIA, dimension.described());
                    return self.report(
                        unit.extent,
                        format!("an inertia is in {expected}, and this is {found}"),
                    );
                }
                let factor = self.frames.graph.number(factor);
                Some(self.scale_draft(factor, draft))
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
            Kind::Poisoned => None,
            _ if self.motion.is_planar() => {
                let moment = self.scalar(written, Dimension::INERTIA, "the inertia about G")?;
                Some(Draft {
                    inertia: Inertia::Planar(moment),
                    parts: Vec::new(),
                    extent: written.extent,
                })
            }
            Kind::Call(word, _) if word == "tensor" || word == "products" => self.report(
                word.span(),
                format!("entries have names: write `{word} {{ xx: .., yy: .., zz: .. }}`"),
            ),
            Kind::Call(word, parts) => {
                self.visit(parts);
                self.report(
                    word.span(),
                    format!("`{word}` is no form of inertia: {FORMS}"),
                )
            }
            Kind::Chain(..) | Kind::Prefix(..) | Kind::Method(..) | Kind::Unit(..)
                if has_form(written) =>
            {
                self.report(
                    written.extent,
                    "an inertia stands alone, with one unit or `.about(P)` behind it: put \
                     factors into its numbers",
                )
            }
            _ => self.report(
                written.extent,
                format!("in space an inertia has more than one number: {FORMS}"),
            ),
        }
    }

    fn refuse_in_plane(&mut self, word: &Ident) -> Option<()> {
        if self.motion.is_planar() {
            return self.report(
                word.span(),
                "in the plane an inertia is one number, about the axis through G: write \
                 `inertia: 0.1[kg * m ^ 2]`",
            );
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
        let moments: Vec<Id> = moments.into_iter().collect::<Option<_>>()?;
        let mut rows = [self.frames.graph.zeros(); 3];
        for (i, moment) in moments.iter().enumerate() {
            rows[i][i] = *moment;
        }
        let parts = parts
            .iter()
            .zip(moments)
            .enumerate()
            .map(|(i, (part, moment))| Part::new(i, i, part, moment))
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
                format!("`{word}` is no form of inertia: {FORMS}"),
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
                        "no entry is called `{known}`; there are `xx`, `yy`, `zz`, `xy`, `yz` and `zx`{hint}"
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
            parts.push(Part::new(*row, *column, value, entry));
        }
        let missing: Vec<&str> = ["xx", "yy", "zz"]
            .into_iter()
            .filter(|diagonal| !fields.iter().any(|(name, _)| name == diagonal))
            .collect();
        if complete && !missing.is_empty() {
            let (missing, verb) = (
                missing.join("` and `"),
                if missing.len() == 1 { "is" } else { "are" },
            );
            self.errors.push(
                word.span(),
                format!("`{missing}` {verb} missing: all three moments of inertia are needed"),
            );
            complete = false;
        }
        complete.then_some(Draft {
            inertia: Inertia::Spatial(rows),
            parts,
            extent,
        })
    }

    fn scale_draft(&mut self, factor: Id, draft: Draft) -> Draft {
        let graph = &mut self.frames.graph;
        let inertia = match draft.inertia {
            Inertia::Absent => Inertia::Absent,
            Inertia::Planar(moment) => Inertia::Planar(graph.multiply(factor, moment)),
            Inertia::Spatial(rows) => {
                Inertia::Spatial(rows.map(|row| graph.scale_vector(factor, row)))
            }
        };
        let parts = draft.parts.into_iter().map(|part| Part {
            entry: graph.multiply(factor, part.entry),
            ..part
        });
        Draft {
            inertia,
            parts: parts.collect(),
            extent: draft.extent,
        }
    }

    /// The parallel-axis theorem, exactly: `J_G = J_P - m (r^2 1 - r r)`.
    fn moved_to_center(
        &mut self,
        draft: Draft,
        point: Point,
        mass: Mass,
        place: &Ident,
    ) -> Option<Draft> {
        let Point::Body(r) = point else {
            return self.report(
                place.span(),
                "the inertia is constant only about a point of the body, and this one is fixed \
                 in space",
            );
        };
        let mass = match mass {
            Mass::Known(mass) => mass,
            Mass::Reported => return None,
            Mass::Absent => {
                return self.report(
                    place.span(),
                    "`.about(P)` needs the mass of the body: write `mass: ..`",
                );
            }
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
}

const FORMS: &str = "write `principal(a, b, c)`, `tensor { xx, yy, zz, xy, yz, zx }` or \
                     `products { .. }`; tensor and products differ in the sign of the \
                     off-diagonals, so the word must be said";

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

/// Whether one of the forms of inertia stands somewhere in `expression`.
fn has_form(expression: &Expression) -> bool {
    let mut found = false;
    expression.visit(|part| {
        found |= match &part.kind {
            Kind::Call(word, _) => word == "principal",
            Kind::Record(..) => true,
            _ => false,
        };
    });
    found
}

fn is_scalar(expression: &Expression) -> bool {
    match &expression.kind {
        Kind::Call(..) | Kind::Record(..) => false,
        Kind::Method(inner, method, _) => method != "about" || is_scalar(inner),
        _ => true,
    }
}

impl Inertia {
    /// The one number, or all nine by rows.
    pub fn entries(self) -> Vec<Id> {
        match self {
            Self::Absent => Vec::new(),
            Self::Planar(moment) => vec![moment],
            Self::Spatial(rows) => rows.into_iter().flatten().collect(),
        }
    }
}

/// The six entries of a symmetric matrix, in the order xx, yy, zz, xy, yz, zx.
pub fn entries(rows: &[Components; 3]) -> [Id; 6] {
    ENTRIES.map(|(_, row, column)| rows[row][column])
}
