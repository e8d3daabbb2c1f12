//! A massless link: a rod between two bodies that keeps the distance of its ends.

use crate::errors::Extent;
use crate::lower::expressions::{Lowering, Value};
use crate::model::{Dimension, Frame, Meaning, Vector};
use crate::symbolic::{Id, Number};
use crate::syntax::{Expression, Kind, LINK, call};

const FORM: &str = "link(P, Q, length)";

/// The body of an end, unless it is the ground, and the place of the end.
type End = (Option<usize>, Vector);

/// Whether it is written as a link.
pub fn is_link(written: &Expression) -> bool {
    call(written).is_some_and(|((word, _), _)| word == LINK)
}

impl Lowering<'_> {
    /// For `link(P, Q, length)`, the scalar in m that it keeps at zero, if it is a link:
    ///
    /// ```text
    /// (length^2 - PQ^2) / (2 length)
    /// ```
    ///
    /// Its gradient with respect to Q has the size 1 and points to P, so the load that keeps it at
    /// zero is the tension.
    #[allow(clippy::option_option, reason = "outer: not a link; inner: reported")]
    pub fn link(&mut self, written: &Expression) -> Option<Option<Id>> {
        let ((word, arguments), methods) = call(written)?;
        if word != LINK || !self.is_whole {
            return None;
        }
        Some(self.read_link((word.span().into(), arguments), &methods))
    }

    fn read_link(
        &mut self,
        (word, arguments): (Extent, &[Expression]),
        methods: &[(&proc_macro2::Ident, &[Expression])],
    ) -> Option<Id> {
        if let Some((method, _)) = methods.first() {
            return self.report(method.span(), format!("nothing follows `{FORM}`"));
        }
        let [p, q, length] = arguments else {
            let excess = arguments.get(3).map_or(word, |extra| extra.extent);
            let count = arguments.len();
            return self.report(
                excess,
                format!("`{FORM}` takes 3 arguments, and this has {count}"),
            );
        };
        let ends = [p, q].map(|end| self.end_of_link(end));
        let what = "the length of a link";
        let size = self.property(length, Dimension::LENGTH, what);
        let ([Some((first, start)), Some((second, end))], size) = (ends, size?) else {
            return None;
        };
        if first == second {
            return self.report(
                q.extent,
                "a link is between two bodies, or a body and the ground: these points keep their distance anyway",
            );
        }
        if self.work.graph.is_zero(size) {
            return self.report(
                length.extent,
                "a link has a length: what holds two points together is a joint, `spherical(P, Q)`, in the \
                 plane `revolute(P, Q)`",
            );
        }
        let back = self.work.negate(start);
        let line = self.work.add(end, back);
        let line = self.work.components(line, Frame::WORLD);
        let graph = &mut self.work.graph;
        let line = graph.quantities(line);
        let square = graph.dot(line, line);
        let whole = graph.multiply(size, size);
        let lacking = graph.subtract(whole, square);
        let two = graph.number(Number::ratio(2, 1));
        let twice = graph.multiply(two, size);
        Some(graph.divide(lacking, twice))
    }

    fn end_of_link(&mut self, written: &Expression) -> Option<End> {
        if let Kind::Name(name) = &written.kind
            && let Some(body) = self.members.body(&name.to_string())
        {
            let points = &self.members.bodies[body].points;
            let point = points.first().map_or("G", |(point, _)| point.as_str());
            let message =
                format!("`{name}` is a body: write one of its points, such as `{name}.{point}`");
            return self.report(name.span(), message);
        }
        match self.value(written)? {
            Value::Carried(body, offset) => {
                let known = &self.members.bodies[body];
                if !self.work.is_in(offset, known.frame) {
                    let message =
                        "expected a point that is fixed in its body, and this one moves in it";
                    return self.report(written.extent, message);
                }
                // an error in the joint of the body is reported, so its motion is unknown
                let position = known.motion?.position;
                Some((Some(body), self.work.add(position, offset)))
            }
            Value::Vector(vector, found) if self.work.is_in(vector, Frame::WORLD) => {
                if !found.fits(Dimension::LENGTH) {
                    let found = found.described();
                    let message = format!("a point is in m, and this is {found}");
                    return self.report(written.extent, message);
                }
                let place = self.work.part(vector, Frame::WORLD);
                self.check_early(written, &place, "a point of the ground is fixed")?;
                Some((None, vector))
            }
            _ => self.report(
                written.extent,
                "expected a point of a body, such as `arm.tip`, or of the ground, `world(..)`",
            ),
        }
    }

    /// A property of a link or a cable: a nonnegative number that does not depend on the state.
    pub fn property(
        &mut self,
        written: &Expression,
        dimension: Dimension,
        what: &str,
    ) -> Option<Id> {
        let value = self.scalar(written, dimension, what)?;
        let is_negative = |number: &Number| !number.is_zero() && !number.is_positive();
        let graph = &self.work.graph;
        if graph.as_number(value).is_some_and(is_negative) {
            return self.report(written.extent, format!("{what} is not negative"));
        }
        let work = &*self.work;
        let of_state = |id| matches!(work.meaning(id), Some(Meaning::Of(..)));
        if graph.depends_on(&[value], of_state) {
            let place = self.late_name(written);
            let message = format!(
                "{what} does not depend on the state: write `tension.between(P, Q)` in `forces` for what does"
            );
            return self.report(place, message);
        }
        Some(value)
    }
}
