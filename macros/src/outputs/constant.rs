//! `constant`: the accelerations as a `const fn`, for claims in the user's code.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::code::{Method, Site, Source, Told, Writer};
use crate::emit::items::Addition;
use crate::lower::Offer;
use crate::model::{Meaning, Outline, Workspace};
use crate::symbolic::{Id, Node};

use super::output::{Basis, Output};
use super::subject::Subject;

const OFFER: Offer = Offer {
    is_of_motion: true,
    ..Offer::new("constant")
};

/// The accelerations, with every parameter at its default.
#[derive(Default)]
pub struct Constant(Option<Vec<Id>>);

impl<S: Subject> Output<S> for Constant {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, S>) -> Option<()> {
        let (model, outline) = (basis.model, basis.outline);
        let equated = model.equated(outline, basis.equations);
        let defaults = model.defaults();
        let graph = &mut basis.work.graph;
        let known = graph.substitute(&equated.accelerations, |id| defaults.get(&id).copied());
        let place = outline.place(OFFER.word)?;
        let obstacles = obstacles(basis.work, outline, &known);
        for obstacle in &obstacles {
            basis.errors.push(place, obstacle);
        }
        self.0 = Some(known);
        obstacles.is_empty().then_some(())
    }

    fn roots(&self) -> Vec<Id> {
        self.0.iter().flatten().copied().collect()
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let (site, outline) = (site.double(), site.outline);
        let method = site.method(self.0.as_ref(), |writer, accelerations| {
            let writer = Writer {
                told: Told::Arrays,
                is_whole: true,
                ..writer.clone()
            };
            Method::write(&writer, accelerations, |values| {
                let values: Vec<&TokenStream> = values.collect();
                quote!([#(#values),*])
            })
        });
        let state = outline.numbers_of_state();
        let input = outline.numbers_of_input().into_iter().map(|(name, _)| name);
        let input: Vec<String> = input.collect();
        let found = outline.accelerations().iter().map(|group| group.size).sum();
        let array = |count: usize| {
            let count = Literal::usize_unsuffixed(count);
            quote!([f64; #count])
        };
        let [given, controls, result] = [state.len(), input.len(), found].map(array);
        let sources = [Source::Time, Source::State, Source::Input];
        let names = sources.into_iter().zip(["time", "state", "input"]);
        let names: Vec<_> = names
            .map(|(one, name)| method.argument(one, name))
            .collect();
        let [time, state_name, input_name] = &names[..] else {
            return Addition::default();
        };
        let docs = [
            " The accelerations, for use in constants, with the defaults of all params.".to_owned(),
            String::new(),
            format!(" State: {}.", listed(&state)),
            format!(" Input: {}.", listed(&input)),
        ];
        let (body, applied) = (&outline.name, site.shapes.scalar.applied());
        let (lints, mut content) = (method.lints(), method.body.clone());
        if self.0.is_none() {
            // a stub for an invalid description
            content = quote!([0.0; #found]);
        }
        Addition {
            implementations: quote! {
                impl #body #applied {
                    #(#[doc = #docs])*
                    #[must_use]
                    #[allow(dead_code)]
                    #lints
                    pub const fn accelerations(
                        #time: f64,
                        #state_name: #given,
                        #input_name: #controls,
                    ) -> #result {
                        #content
                    }
                }
            },
            ..Addition::default()
        }
    }
}

/// `x`, `y`
fn listed(names: &[String]) -> String {
    if names.is_empty() {
        return "nothing".to_owned();
    }
    let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    names.join(", ")
}

/// What prevents evaluation in a constant, each obstacle once.
fn obstacles(work: &Workspace, outline: &Outline, roots: &[Id]) -> Vec<String> {
    let graph = &work.graph;
    let mut found: Vec<String> = Vec::new();
    for id in graph.nodes_of(roots) {
        let what = match *graph.node(id) {
            Node::Unary(function, _) | Node::Binary(function, ..) => {
                format!("in a `const fn` there is no `{}`", function.name())
            }
            Node::Foreign(function, _) => {
                let name = &work.functions[function.number()].name;
                format!("`{name}` is a function of Rust, and none that is known to be `const`")
            }
            Node::Pivot(..) => {
                "a divisor is guarded that may vanish, and not in a `const fn`".to_owned()
            }
            Node::Positive(_) => {
                "mass or inertia change, and are not looked at in a `const fn`".to_owned()
            }
            Node::Symbol(_) => match work.meaning(id) {
                Some(Meaning::Param(number, _)) => {
                    let name = &outline.params[number].name;
                    format!("`{name}` has no default: write `{name} = ..`")
                }
                Some(Meaning::Constant(number)) => {
                    let name = &work.constants[number].name;
                    format!("the value of `{name}`, a constant of Rust, is not known here")
                }
                _ => continue,
            },
            _ => continue,
        };
        let message = format!("the accelerations are no `constant`: {what}");
        if !found.contains(&message) {
            found.push(message);
        }
    }
    found
}
