//! A description of a system, read in order: what it declares, the points of its bodies, the
//! joints, and then all that depends on how it moves.

mod axes;
mod between;
mod body;
mod drives;
mod joints;
mod motion;
mod names;
mod outline;
mod reader;
mod told;
mod tree;

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::lower::definitions::{INVERSE, check_names};
use crate::lower::expressions::{Members, Scope};
use crate::model::{
    Declared, Defaults, Meaning, Member, Outline, PLANAR, SPATIAL, System, TreeJoint, Workspace,
};
use crate::symbolic::Stage;
use crate::syntax;

use body::Draft;
use names::{check_members, declared, for_copy, late_locals};
use reader::Reader;

pub use outline::outline_system;

/// Gives a description of a system its meaning. `None` if anything was wrong with it.
pub fn lower_system(
    system: &syntax::System,
    outline: &mut Outline,
    errors: &mut Errors,
) -> Option<(System, Workspace)> {
    let mut repeated = check_names(&system.top, errors);
    repeated.extend(check_members(system, errors));
    let mut work = Workspace::new();
    let time = work.symbol(Stage::State, Meaning::Time);
    let mut reader = Reader {
        system,
        work,
        scope: Scope::new(&system.top, repeated),
        members: Members {
            declared: declared(system),
            late: late_locals(system),
            ..Members::default()
        },
        is_inverse: outline.rank(INVERSE).is_some(),
        turning: vec![false; system.bodies.len()],
        motion: if system.is_planar { &PLANAR } else { &SPATIAL },
        time,
        defaults: Defaults::new(),
    };
    reader.defaults = reader.at_top(errors, |lowering| {
        lowering.declarations(&system.top, outline)
    });
    reader.locals(errors, false);
    let mut drafts: Vec<Draft<'_>> = Vec::new();
    let mut wrong = HashSet::new();
    for (number, body) in system.bodies.iter().enumerate() {
        let draft = for_copy(
            system.firsts[number],
            number,
            &mut wrong,
            errors,
            |errors| reader.points(body, errors),
        );
        drafts.push(draft);
    }
    let joints = reader.joints(errors);
    reader.check_held(&joints, errors);
    let order = reader.tree(&joints, errors);
    let joints = reader.motions(order, joints, &mut drafts);
    reader.members.are_moving = true;
    reader.locals(errors, true);
    let bodies = reader.bodies(&mut drafts, &mut wrong, errors);
    let joints = reader.drives(joints, errors);
    let loads = reader.loads_between(errors);
    outline.unused = reader.unused(&drafts);
    let (mut bodies, joints) = (bodies?, joints?);
    for (body, load) in loads? {
        bodies[body].loads.push(load);
    }
    let Reader {
        mut work, defaults, ..
    } = reader;
    let gravity = body::common_gravity(&mut work, &mut bodies, system.top.loads.len());
    let (bodies, joints) = carriers_first(bodies, joints)?;
    for known in &mut outline.joints {
        let joint = joints.iter().find(|joint| joint.name == known.name);
        known.frame = joint.and_then(|joint| joint.frames.last().copied());
    }
    let system = System {
        is_planar: system.is_planar,
        bodies,
        joints,
        gravity,
        derivatives: outline.inputs.iter().map(Declared::derivatives).collect(),
        defaults,
    };
    if errors.is_empty() && outline.joints.is_empty() {
        let message = "nothing moves: all joints are welds";
        errors.push(outline.name.span(), message);
    }
    errors.is_empty().then_some((system, work))
}

/// Each body with the joint that carries it, after its carrier.
fn carriers_first(
    bodies: Vec<Member>,
    mut joints: Vec<TreeJoint>,
) -> Option<(Vec<Member>, Vec<TreeJoint>)> {
    let place = |body: usize| joints.iter().position(|joint| joint.carried == body);
    let mut numbered: Vec<_> = bodies.into_iter().enumerate().collect();
    numbered.sort_by_key(|(body, _)| place(*body));
    let old: Vec<usize> = numbered.iter().map(|(body, _)| *body).collect();
    let new = |body: usize| old.iter().position(|other| *other == body);
    for joint in &mut joints {
        joint.carrier = joint.carrier.and_then(new);
        joint.carried = new(joint.carried)?;
    }
    let bodies = numbered.into_iter().map(|(_, body)| body).collect();
    Some((bodies, joints))
}

impl Reader<'_> {
    /// The names of the system that nothing refers to.
    fn unused(&self, drafts: &[Draft<'_>]) -> Vec<Ident> {
        let top = &self.system.top;
        let inputs = top.inputs.iter().filter(|input| input.order == 0);
        let declared = top.params.iter().chain(inputs).map(|one| &one.name);
        let names = declared.chain(top.locals.iter().map(|local| &local.name));
        let unused = names.filter(|name| !self.scope.is_used(name)).cloned();
        unused.chain(self.unused_of_bodies(drafts)).collect()
    }

    /// The points and locals of bodies that nothing refers to, of copies no copy.
    fn unused_of_bodies(&self, drafts: &[Draft<'_>]) -> Vec<Ident> {
        let used = self.members.used.borrow();
        let is_used = |number: usize, name: &Ident| {
            let of_others = used.contains(&(number, name.to_string()));
            of_others || drafts[number].scope.is_used(name)
        };
        let mut unused = Vec::new();
        for (first, draft) in drafts.iter().enumerate() {
            if self.system.firsts[first] != first {
                continue;
            }
            let copies: Vec<usize> = (0..drafts.len())
                .filter(|number| self.system.firsts[*number] == first)
                .collect();
            let own = draft
                .description
                .points
                .iter()
                .chain(&draft.description.locals);
            let own = own.map(|definition| &definition.name);
            let given = &draft.description.given;
            let own = own.filter(|name| !given.contains(&name.to_string()));
            let left = own.filter(|name| !copies.iter().any(|copy| is_used(*copy, name)));
            unused.extend(left.cloned());
        }
        unused
    }
}
