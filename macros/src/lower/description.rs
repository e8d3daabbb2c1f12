//! A description, read in order: its declarations, the body, its loads.

use proc_macro2::Ident;

use crate::errors::{Errors, every, silently, similar};
use crate::lower::definitions::{
    INVERSE, LINEARIZATION, Offer, REGRESSOR, check_changing, check_names, outline_under, unused,
};
use crate::lower::expressions::{
    Lowering, Members, Scope, is_drive, is_unknown, motion, written_motion,
};
use crate::lower::loads::check_states;
use crate::model::{
    Checks, Declared, Defaults, Drawn, ENTRIES, FIXED_POINT, Inertia, Labels, MOTIONS, Mass, Model,
    Motion, Outline, PIVOT, PLANAR, PLANAR_TRANSLATION, Reaction, SPATIAL, TRANSLATION, Unweighed,
    UnweighedBody, Workspace, state_symbols,
};
use crate::syntax::{self, Description};

/// What is known of a body even if it has errors, and its meaning if it has none.
pub type Read = (Outline, Option<(Model, Workspace)>);

/// Reads a body. One that is described in the plane under a motion in space, or the reverse, has
/// one error for that, if it has fewer errors under the other motion.
pub fn read_body(
    description: &Description,
    offers: &[&'static Offer],
    errors: &mut Errors,
) -> Read {
    let (outline, mut meaning) = read_in_its_space(description, offers, errors);
    if let Some((model, _)) = &mut meaning
        && outline.asks_for(&[REGRESSOR])
    {
        model.unweighed = silently(|errors| {
            let mut outline = outline_under(outline.motion, description, offers, errors);
            let work = Workspace::with_unknown_masses();
            let (model, work) = lower_description(description, &mut outline, work, errors)?;
            let body = (&model.substance(), model.state.body);
            let body = UnweighedBody::new(body, model.loads.iter());
            Some(Unweighed::shared(work, vec![body]))
        });
    }
    (outline, meaning)
}

fn read_in_its_space(
    description: &Description,
    offers: &[&'static Offer],
    errors: &mut Errors,
) -> Read {
    let before = errors.count();
    let outline = outline(description, offers, errors);
    let read = read_outline(description, outline, errors);
    let Some((word, other)) = other_motion(description) else {
        return read;
    };
    let read_other = |errors: &mut Errors| {
        let outline = outline_under(other, description, offers, errors);
        read_outline(description, outline, errors)
    };
    let count = errors.count() - before;
    if count < 2 || !description.shows(other.is_planar) || count_errors(read_other) >= count {
        return read;
    }
    errors.take_back(before);
    let place = if other.is_planar {
        "the plane"
    } else {
        "space"
    };
    let message = format!(
        "the rest of `{}` is described in {place}: write `motion: {}{}`",
        description.name,
        other.word,
        if other.is_supported() { "(..)" } else { "" }
    );
    errors.push(word.span(), message);
    read_other(errors)
}

fn read_outline(description: &Description, mut outline: Outline, errors: &mut Errors) -> Read {
    let model = lower_description(description, &mut outline, Workspace::new(), errors);
    (outline, model)
}

/// The word of the motion, and the motion of the same kind in space instead of the plane, or the
/// reverse.
fn other_motion(description: &Description) -> Option<(&Ident, Motion)> {
    let written = &description.motion.as_ref()?.word;
    let motion = written_motion(description)?;
    let pairs = [
        (&SPATIAL, &PLANAR),
        (&TRANSLATION, &PLANAR_TRANSLATION),
        (&FIXED_POINT, &PIVOT),
    ];
    pairs
        .into_iter()
        .find_map(|(in_space, in_plane)| match motion {
            _ if motion == in_space => Some((written, in_plane)),
            _ if motion == in_plane => Some((written, in_space)),
            _ => None,
        })
}

/// The number of errors that are found, without reporting them.
pub fn count_errors<T>(read: impl FnOnce(&mut Errors) -> T) -> usize {
    silently(|errors| {
        read(errors);
        errors.count()
    })
}

/// The outline of `description`. Without a valid motion, the most likely motion is assumed.
pub fn outline(
    description: &Description,
    offers: &[&'static Offer],
    errors: &mut Errors,
) -> Outline {
    let motion = written_motion(description)
        .or_else(|| similar_motion(description))
        .unwrap_or_else(|| likely_motion(description, offers));
    outline_under(motion, description, offers, errors)
}

/// The motion that a misspelt word means.
fn similar_motion(description: &Description) -> Option<Motion> {
    let word = description.motion.as_ref()?.word.to_string();
    similar(&word, MOTIONS.iter().map(|motion| motion.word)).and_then(motion)
}

/// The motion under which the rest of a description has the fewest errors, so that those that follow
/// from another motion are not reported.
fn likely_motion(description: &Description, offers: &[&'static Offer]) -> Motion {
    let mistakes = |motion: &Motion| {
        let count = count_errors(|errors| {
            let outline = outline_under(motion, description, offers, errors);
            read_outline(description, outline, errors)
        });
        (count, motion.word != SPATIAL.word)
    };
    let candidates = MOTIONS.into_iter();
    let candidates = candidates.filter(|motion| !motion.is_supported() && !motion.is_line());
    let likely = candidates.min_by_key(mistakes);
    likely.unwrap_or(&SPATIAL)
}

/// Gives a description its meaning. `None` if there was any error.
fn lower_description(
    description: &Description,
    outline: &mut Outline,
    mut work: Workspace,
    errors: &mut Errors,
) -> Option<(Model, Workspace)> {
    let repeated = check_names(description, errors);
    let mut state = state_symbols(outline.motion, &mut work);
    let mut scope = Scope::new(description, repeated);
    let names = outline.reactions.iter().map(|(name, _)| name.to_string());
    let mut lowering = Lowering {
        work: &mut work,
        scope: &mut scope,
        errors,
        motion: outline.motion,
        state: &mut state,
        composed: None,
        has_parts: description.composition.is_some(),
        drawn: Drawn::Alone,
        reactions: names.collect(),
        is_constrained: outline.is_constrained,
        members: &Members::default(),
        is_whole: false,
    };

    let defaults = lowering.declarations(description, outline);
    let (mass, inertia) = lowering.substance(description, outline, &defaults);
    let potentials = lowering.potentials(description);
    let [unknown, driving, known] = loads_by_kind(description);
    let (motion, is_inverse) = (outline.motion, outline.rank(INVERSE).is_some());
    let drives = driving.into_iter();
    let drives = every(drives.map(|load| lowering.drive(load, is_inverse)));
    let constraints = lowering.constraints(description, &outline.inputs);
    let states = lowering.states(description, &outline.states);
    let reactions = unknown.into_iter().enumerate();
    let reactions = reactions.map(|(index, load)| lowering.reaction(index, load));
    let reactions: Vec<_> = reactions.collect();
    lowering.name_reactions(description, &reactions);
    let loads = every(known.into_iter().map(|load| lowering.load(load)));
    let pole = lowering.pole(description.pole.as_ref());
    let checks = lowering.claims(description, &reactions);

    outline.unused = unused(description, &scope);
    let derivatives: Vec<usize> = outline.inputs.iter().map(Declared::derivatives).collect();
    let (constraints, states) = (constraints?, states?);
    check_states(&work, &constraints, &states, &derivatives, errors)?;
    let model = Model {
        derivatives,
        states,
        is_differentiated: outline.asks_for(&[LINEARIZATION]),
        has_idle_inertia: description.inertia.is_some() && !motion.has_attitude(),
        potentials: potentials?,
        reactions: every(reactions)?,
        drives: drives?,
        constraints,
        checks,
        defaults,
        ..Model::of(motion, state, (mass.known(), inertia?), loads?, pole?)
    };
    name_properties(&model, &mut work.labels);
    Some((model, work))
}

impl Lowering<'_> {
    /// The mass and the inertia. They may change with time and user-defined states only.
    fn substance(
        &mut self,
        description: &Description,
        outline: &Outline,
        defaults: &Defaults,
    ) -> (Mass, Option<Inertia>) {
        let mass = self.definitions(description, defaults);
        let inertia = self.inertia(description, mass, defaults);
        if let Some(inertia) = inertia {
            let mut known = inertia.distinct_entries();
            known.extend(mass.known());
            check_changing(self.work, &known, outline, self.errors);
        }
        (mass, inertia)
    }

    /// Claims about the motion, which may use all solved quantities.
    fn claims(&mut self, description: &Description, reactions: &[Option<Reaction>]) -> Checks {
        self.is_constrained = true;
        if !description.checks.is_empty() {
            self.name_reactions(description, reactions);
        }
        self.checks(description)
    }
}

/// The loads other than fields, in three lists: unknown reactions, unknown drives, and given loads.
fn loads_by_kind(description: &Description) -> [Vec<&syntax::Load>; 3] {
    let mut kinds = [Vec::new(), Vec::new(), Vec::new()];
    let loads = description.loads.iter();
    for load in loads.filter(|load| load.charges.is_none()) {
        let kind = match (is_unknown(load), is_drive(load)) {
            (true, _) => 0,
            (_, true) => 1,
            _ => 2,
        };
        kinds[kind].push(load);
    }
    kinds
}

/// Names the mass and the inertia where they are computed.
fn name_properties(model: &Model, labels: &mut Labels) {
    let entries = model.inertia_entries();
    let is_one = entries.len() == 1;
    for (id, (entry, ..)) in entries.into_iter().zip(ENTRIES) {
        let name = format!("inertia_{entry}");
        labels.name(id, if is_one { "inertia" } else { &name });
    }
    if let Some(mass) = model.mass {
        labels.name(mass, "mass");
    }
}
