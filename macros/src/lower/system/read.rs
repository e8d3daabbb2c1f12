//! A system as read, in the plane or in space.

use crate::errors::{Errors, silently};
use crate::lower::definitions::{Offer, REGRESSOR};
use crate::lower::description::{count_errors, outline};
use crate::model::{Outline, System, Unweighed, UnweighedBody, Workspace};
use crate::syntax;

use super::{lower_system, outline_system};

/// What is known of a system even if it has errors, and its meaning if it has none.
type Read = (Outline, Option<(System, Workspace)>);

/// Reads a system. One that is described in the plane without `motion: planar`, or in space with it,
/// has one error for that, if it has fewer errors the other way.
pub fn read_system(
    system: &mut syntax::System,
    offers: &[&'static Offer],
    errors: &mut Errors,
) -> Read {
    let before = errors.count();
    let found = read(system, offers, errors);
    let count = errors.count() - before;
    if count < 2 || system.file.is_some() || !system.shows(!system.is_planar) {
        return found;
    }
    let reported = usize::from(!system.has_wrong_motion());
    system.move_in(!system.is_planar);
    if count_errors(|errors| read(system, offers, errors)) + reported > count {
        system.move_in(!system.is_planar);
        return found;
    }
    errors.take_back(before);
    if !system.has_wrong_motion() {
        let name = &system.top.name;
        let message = if system.is_planar {
            format!("`{name}` is described in the plane: write `{name} {{ motion: planar, .. }}`")
        } else {
            format!("the rest of `{name}` is described in space: leave `motion` out")
        };
        errors.push(system.place_of_motion(), message);
    }
    read(system, offers, errors)
}

fn read(system: &syntax::System, offers: &[&'static Offer], errors: &mut Errors) -> Read {
    let read = |work: Workspace, errors: &mut Errors| {
        let mut outline = outline(&system.top, offers, errors);
        outline_system(system, &mut outline);
        let meaning = lower_system(system, &mut outline, work, errors);
        (outline, meaning)
    };
    let (outline, mut meaning) = read(Workspace::new(), errors);
    if let Some((known, _)) = &mut meaning
        && outline.asks_for(&[REGRESSOR])
    {
        known.unweighed = silently(|errors| {
            let (system, work) = read(Workspace::with_unknown_masses(), errors).1?;
            let bodies = system.bodies.iter().map(|body| {
                let loads = body.weights.iter().chain(&body.loads);
                UnweighedBody::new((&body.substance(), body.state.body), loads)
            });
            let bodies = bodies.collect();
            Some(Unweighed::shared(work, bodies))
        });
    }
    (outline, meaning)
}
