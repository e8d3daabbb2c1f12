//! A body composed of parts: its mass, its center of mass, and its inertia about that.
//!
//! Parts and points are relative to one drawing origin. No inertia is moved to G by a subtraction:
//! offsets are measured from the first part, then from G, and the inertia is summed about G
//! (`docs/trust.md`, H3).

use crate::errors::every;
use crate::lower::expressions::{Lowering, base, is_of_solid};
use crate::model::{Composed, Defaults, Dimension, Inertia, Mass, Origin, shown};
use crate::symbolic::{Components, Id};
use crate::syntax::{Composition, Expression, Kind, Part};

use super::draft::Context;

const NO_MASS: &str = "this part has no mass: write `.mass(1[kg])` behind it";
const HOLE: &str = "a part of negative mass is a hole, and a hole is a solid or a point: write \
                    `cylinder(r, h).mass(..)`";

/// A part that is read.
struct Member {
    mass: Id,
    is_hole: bool,
    /// The inertia about its own center of mass.
    inertia: Inertia,
    /// The place of its center of mass, from the drawing origin.
    point: Components,
}

impl Lowering<'_> {
    /// Reads the parts. From here on, points are offsets from G.
    pub fn compose(&mut self, written: &Composition, defaults: &Defaults) -> Option<Composed> {
        let parts = written.parts.iter();
        let members = every(parts.map(|part| self.member(part.as_ref()?, defaults)))?;
        let masses: Vec<Id> = members.iter().map(|member| member.mass).collect();
        let mass = self.work.graph.sum(&masses);
        match self.known(mass, defaults) {
            Some(number) if !number.is_positive() => {
                let number = shown(&number);
                let place = written.parts.first()?.as_ref()?.form.extent;
                return self.report(
                    place.underlining(written.word.span()),
                    format!(
                        "the mass of a body that moves is positive, and that of these parts \
                         together is {number}"
                    ),
                );
            }
            _ => {}
        }
        let graph = &mut self.work.graph;
        let first = members.first()?.point;
        let offsets: Vec<Components> = members
            .iter()
            .map(|member| graph.subtract_vectors(member.point, first))
            .collect();
        self.check_on_one_line(written, &offsets)?;
        let graph = &mut self.work.graph;
        let center = [0, 1, 2].map(|axis| {
            let moments = masses.iter().zip(&offsets);
            let moments: Vec<Id> = moments
                .map(|(mass, offset)| graph.multiply(*mass, offset[axis]))
                .collect();
            let moment = graph.sum(&moments);
            let center = graph.divide(moment, mass);
            graph.quantity(center)
        });
        self.check_center(written, &masses, center)?;
        let labels = &mut self.work.labels;
        labels.describe("center", "G, from where the first part is");
        labels.vector("center", center);
        let mut inertia = self.of_a_point();
        for (member, offset) in members.iter().zip(offsets) {
            let graph = &mut self.work.graph;
            let from_center = graph.subtract_vectors(offset, center);
            let about_center = member.inertia.displaced(graph, member.mass, from_center);
            inertia = inertia.plus(graph, about_center);
        }
        Some(Composed {
            mass: self.work.graph.positive_quantity(mass),
            inertia: inertia.positive(&mut self.work.graph),
            has_holes: members.iter().any(|member| member.is_hole),
            origin: Origin { first, center },
        })
    }

    /// Checks that G stays fixed in the body, because points are relative to it.
    fn check_center(
        &mut self,
        written: &Composition,
        masses: &[Id],
        center: Components,
    ) -> Option<()> {
        let graph = &self.work.graph;
        if graph.are_early(&center) {
            return Some(());
        }
        let mut parts = written.parts.iter().flatten().zip(masses);
        let late = parts.find(|(_, mass)| !graph.is_early(**mass));
        let place = late.map_or_else(
            || written.word.span().into(),
            |(part, _)| match &part.mass {
                Some(Some(mass)) => mass.extent,
                _ => part.form.extent,
            },
        );
        self.report(
            place,
            "as this changes, G moves in the body, and points are relative to G: place the changing parts so that \
             G stays fixed",
        )
    }

    /// Checks that the parts of a rod lie along its axis; offsets are measured from the first part.
    fn check_on_one_line(&mut self, written: &Composition, offsets: &[Components]) -> Option<()> {
        let mut is_right = true;
        for (part, offset) in written.parts.iter().flatten().zip(offsets) {
            if !self.is_along_axis(*offset) {
                let place = part.point.iter().flatten().next();
                let place = place.map_or(part.form.extent, |point| point.extent);
                self.errors.push(
                    place,
                    "the parts of a rod lie on one line, along its axis, and this one is beside the \
                     line through the first part",
                );
                is_right = false;
            }
        }
        is_right.then_some(())
    }

    fn member(&mut self, part: &Part, defaults: &Defaults) -> Option<Member> {
        let point = match &part.point {
            None => Some(self.work.graph.zeros()),
            Some(point) => point.as_ref().and_then(|point| self.place(point)),
        };
        let (mass, inertia) = match &part.form.kind {
            Kind::Call(word, arguments) if word == "point" => {
                if let Some(Some(mass)) = &part.mass {
                    return self.report(
                        mass.extent,
                        "the mass of a point belongs in its parentheses: leave `.mass(..)` out",
                    );
                }
                let [mass] = arguments.as_slice() else {
                    return self.report(
                        word.span(),
                        "a point is known by its mass: write `point(1[kg]).at(P)`",
                    );
                };
                (self.part_mass(mass, defaults), Some(self.of_a_point()))
            }
            _ => {
                let mass = self.mass_of(part, defaults);
                (mass, self.inertia_of(part, mass, defaults))
            }
        };
        let (mass, is_hole) = mass?;
        Some(Member {
            mass,
            is_hole,
            inertia: inertia?,
            point: point?,
        })
    }

    /// The mass of a part that is more than a point, and whether it is a hole.
    fn mass_of(&mut self, part: &Part, defaults: &Defaults) -> Option<(Id, bool)> {
        if let Some(mass) = &part.mass {
            return self.part_mass(mass.as_ref()?, defaults);
        }
        let form = base(&part.form);
        match &form.kind {
            Kind::Poisoned => None,
            // its error, reported elsewhere, is that forms cannot be added or multiplied
            Kind::Chain(..) | Kind::Prefix(..) if !self.motion.has_one_moment() => None,
            Kind::Call(word, _) | Kind::Record(word, _) => self.report(word.span(), NO_MASS),
            _ => self.report(form.extent, NO_MASS),
        }
    }

    /// The inertia of a point about itself, which is zero.
    fn of_a_point(&mut self) -> Inertia {
        let graph = &mut self.work.graph;
        if self.motion.has_one_moment() {
            Inertia::Scalar(graph.zero())
        } else {
            Inertia::Spatial([graph.zeros(); 3])
        }
    }

    /// The inertia of a part about its own center of mass.
    fn inertia_of(
        &mut self,
        part: &Part,
        mass: Option<(Id, bool)>,
        defaults: &Defaults,
    ) -> Option<Inertia> {
        let context = Context {
            mass: mass.map_or(Mass::Reported, |(mass, _)| Mass::Known(mass)),
            defaults,
        };
        let draft = self.form(&part.form, context)?;
        if !is_of_solid(&part.form) {
            if let (Some((_, true)), Some(Some(written))) = (mass, &part.mass) {
                return self.report(written.extent, HOLE);
            }
            self.check_inertia(&draft, defaults)?;
        }
        Some(draft.inertia)
    }

    fn part_mass(&mut self, written: &Expression, defaults: &Defaults) -> Option<(Id, bool)> {
        let mass = self.scalar(written, Dimension::MASS, "a mass")?;
        self.check_course(written, &[mass], "the mass is constant")?;
        if self.work.graph.is_zero(mass) {
            return self.report(
                written.extent,
                "a part without mass changes nothing: leave it out",
            );
        }
        let known = self.known(mass, defaults);
        Some((mass, known.is_some_and(|known| known.is_negative())))
    }

    /// The place of a part.
    fn place(&mut self, written: &Expression) -> Option<Components> {
        self.body_point(written, |place| {
            format!("a part is fixed in the body, and this point is {place}")
        })
    }
}
