//! The order in which definitions can be read: each after its dependencies.

use std::collections::{BTreeSet, HashMap, HashSet};

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::syntax::{Description, Expression};

/// A definition that may refer to others.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Definition {
    Mass,
    Point(usize),
    Local(usize),
}

/// The most members of a cycle that a message shows.
const SHOWN: usize = 6;

/// Definitions and their references to each other.
struct References<'d> {
    definitions: Vec<(String, Definition)>,
    /// For each definition, those that it depends on, each with the name that refers to it.
    uses: Vec<Vec<(usize, &'d Ident)>>,
}

/// The points, locals and the mass in an order in which they can be read, and those that cannot be
/// read because they depend on a cycle.
pub fn definition_order(description: &Description) -> (Vec<Definition>, Vec<Definition>) {
    let references = References::find(description);
    let (order, left) = references.sort();
    let definition = |index: usize| references.definitions[index].1;
    (
        order.into_iter().map(definition).collect(),
        left.into_iter().map(definition).collect(),
    )
}

/// Reports each cycle of definitions once, unless a name in it is ambiguous and may not mean this
/// definition.
pub fn check_circles(
    description: &Description,
    is_ambiguous: impl Fn(&str) -> bool,
    errors: &mut Errors,
) {
    let references = References::find(description);
    let (_, mut left) = references.sort();
    while let Some(circle) = references.circle(&left) {
        let mut mentions = circle.iter().map(|(_, mention)| mention.to_string());
        if !mentions.any(|mention| is_ambiguous(&mention)) {
            references.report(&circle, errors);
        }
        for (index, _) in circle {
            left.remove(&index);
        }
    }
}

impl Definition {
    /// Its name and its value.
    pub fn of(self, description: &Description) -> (String, Option<&Expression>) {
        match self {
            Self::Mass => {
                let value = description
                    .mass
                    .as_ref()
                    .and_then(|mass| mass.value.as_ref());
                ("mass".to_owned(), value)
            }
            Self::Point(index) => {
                let point = &description.points[index];
                (point.name.to_string(), point.value.as_ref())
            }
            Self::Local(index) => {
                let local = &description.locals[index];
                (local.name.to_string(), local.value.as_ref())
            }
        }
    }
}

/// Splits an order of definitions into those that the support needs, and the others, which may
/// depend on the motion that the support allows.
pub fn split_at_support(
    description: &Description,
    order: &[Definition],
) -> (Vec<Definition>, Vec<Definition>) {
    let mut needed = names_in_motion(description);
    if let Some(composition) = &description.composition {
        // offsets from G are known only after the parts are
        needed.insert("mass".to_owned());
        needed.extend(composition.expressions().flat_map(names));
    }
    split(description, order, needed)
}

/// Splits an order of definitions into those that any point or the mass needs, and the others,
/// which may depend on the motion of a system.
pub fn split_at_points(
    description: &Description,
    order: &[Definition],
) -> (Vec<Definition>, Vec<Definition>) {
    let points = description
        .points
        .iter()
        .map(|point| point.name.to_string());
    let mut needed: HashSet<String> = points.chain(["mass".to_owned()]).collect();
    if let Some(composition) = &description.composition {
        needed.extend(composition.expressions().flat_map(names));
    }
    split(description, order, needed)
}

/// Splits an order of definitions into those that the direction of a rod needs, and the others.
pub fn split_at_axis(
    description: &Description,
    order: &[Definition],
) -> (Vec<Definition>, Vec<Definition>) {
    split(description, order, names_in_motion(description))
}

fn names(value: &Expression) -> Vec<String> {
    value.names().into_iter().map(ToString::to_string).collect()
}

/// The names in the arguments of `motion`.
fn names_in_motion(description: &Description) -> HashSet<String> {
    let support = description.motion.iter().flat_map(|motion| &motion.support);
    let written = support.flat_map(|support| support.arguments.iter().chain(&support.anchor));
    written.flatten().flat_map(names).collect()
}

/// Splits off the needed definitions and everything that they depend on.
fn split(
    description: &Description,
    order: &[Definition],
    mut needed: HashSet<String>,
) -> (Vec<Definition>, Vec<Definition>) {
    for definition in order.iter().rev() {
        let (name, value) = definition.of(description);
        if needed.contains(&name) {
            needed.extend(value.into_iter().flat_map(names));
        }
    }
    order
        .iter()
        .partition(|definition| needed.contains(&definition.of(description).0))
}

impl<'d> References<'d> {
    fn find(description: &'d Description) -> Self {
        let mut definitions = Vec::new();
        let mut values: Vec<Vec<&Expression>> = Vec::new();
        // `mass` and `G` are known only once the parts are composed
        let mut composed = HashMap::new();
        if let Some(composition) = &description.composition {
            composed.extend(["mass", "G"].map(|name| (name.to_owned(), definitions.len())));
            definitions.push((composition.word.to_string(), Definition::Mass));
            values.push(composition.expressions().collect());
        } else if let Some(mass) = &description.mass {
            definitions.push(("mass".to_owned(), Definition::Mass));
            values.push(mass.value.iter().collect());
        }
        for (index, point) in description.points.iter().enumerate() {
            definitions.push((point.name.to_string(), Definition::Point(index)));
            values.push(point.value.iter().collect());
        }
        for (index, local) in description.locals.iter().enumerate() {
            definitions.push((local.name.to_string(), Definition::Local(index)));
            values.push(local.value.iter().collect());
        }
        // if two definitions have the same name, the first one counts
        let index: HashMap<String, usize> = definitions
            .iter()
            .enumerate()
            .rev()
            .map(|(index, (name, _))| (name.clone(), index))
            .chain(composed)
            .collect();
        let uses = values.into_iter().map(|value| {
            let names = value.into_iter().flat_map(Expression::names);
            let used = names.filter_map(|name| Some((*index.get(&name.to_string())?, name)));
            used.collect()
        });
        Self {
            uses: uses.collect(),
            definitions,
        }
    }

    /// The definitions that can be read, in order, and the others.
    fn sort(&self) -> (Vec<usize>, BTreeSet<usize>) {
        let mut waiting: Vec<usize> = self.uses.iter().map(Vec::len).collect();
        let mut users: Vec<Vec<usize>> = vec![Vec::new(); waiting.len()];
        for (user, uses) in self.uses.iter().enumerate() {
            for (used, _) in uses {
                users[*used].push(user);
            }
        }
        let all = 0..waiting.len();
        let mut ready: BTreeSet<usize> = all.clone().filter(|index| waiting[*index] == 0).collect();
        let mut order = Vec::new();
        while let Some(next) = ready.pop_first() {
            order.push(next);
            for &user in &users[next] {
                waiting[user] -= 1;
                if waiting[user] == 0 {
                    ready.insert(user);
                }
            }
        }
        (order, all.filter(|index| waiting[*index] > 0).collect())
    }

    /// A cycle among `left`: each member with the name by which it refers to the next.
    fn circle(&self, left: &BTreeSet<usize>) -> Option<Vec<(usize, &'d Ident)>> {
        let mut finished: BTreeSet<usize> = BTreeSet::new();
        for &start in left {
            // the path from `start`: each member, and how many of its references were followed
            let mut way: Vec<(usize, usize)> = vec![(start, 0)];
            let mut on_way: BTreeSet<usize> = BTreeSet::from([start]);
            while let Some((current, followed)) = way.last_mut() {
                let Some((used, _)) = self.uses[*current].get(*followed) else {
                    finished.insert(*current);
                    on_way.remove(current);
                    way.pop();
                    continue;
                };
                *followed += 1;
                if on_way.contains(used) {
                    let first = way.iter().position(|(member, _)| member == used)?;
                    let member = |(member, followed): &(usize, usize)| {
                        (*member, self.uses[*member][followed - 1].1)
                    };
                    return Some(way[first..].iter().map(member).collect());
                }
                if left.contains(used) && !finished.contains(used) {
                    on_way.insert(*used);
                    way.push((*used, 0));
                }
            }
        }
        None
    }

    fn report(&self, circle: &[(usize, &Ident)], errors: &mut Errors) {
        let Some((first, mention)) = circle.first() else {
            return;
        };
        let (name, definition) = &self.definitions[*first];
        let message = if circle.len() == 1 && *definition == Definition::Mass && *mention != name {
            format!("`{mention}` follows from the parts: no part can refer to it")
        } else if circle.len() == 1 {
            format!("`{name}` cannot be defined by itself")
        } else {
            let members = circle.iter().map(|(_, mention)| format!("`{mention}`"));
            let mut way: Vec<String> = members.collect();
            if way.len() > SHOWN {
                way.splice(SHOWN / 2..way.len() - SHOWN / 2, ["..".to_owned()]);
            }
            let way = way.join(", which needs ");
            format!("these definitions are circular: `{name}` needs {way}")
        };
        errors.push(mention.span(), message);
    }
}
