//! What rustc prints about a file whose descriptions are invalid, without rustc: it underlines what
//! the compiler's own errors say.

use std::ops::Range;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use proc_macro2::{TokenStream, TokenTree};
use quote::quote;
use syn::{Item, LitStr, Macro};

/// What is printed about a file; `None` if something else than descriptions is compiled in it.
pub fn report(path: &str, source: &str) -> Option<String> {
    let file = syn::parse_file(source).ok()?;
    let mut errors = Vec::new();
    for item in file.items {
        match item {
            Item::Macro(item) if item.ident.is_none() => collect(expanded(item.mac), &mut errors),
            Item::Use(_) => {}
            Item::Fn(item) if item.block.stmts.is_empty() => {}
            _ => return None,
        }
    }
    let rendered = errors.iter().map(|error| error.rendered(path, source));
    let alone = file.attrs.is_empty();
    alone.then(|| rendered.collect::<Vec<_>>().join("\n\n") + "\n")
}

fn expanded(Macro { path, tokens, .. }: Macro) -> TokenStream {
    let description = quote!((::newton_euler) #tokens);
    if path.segments.last().unwrap().ident == "rigid_body" {
        mounted::expand::expand(description)
    } else {
        mounted::expand::expand_system(description)
    }
}

#[derive(PartialEq)]
struct Error {
    message: String,
    place: Range<usize>,
}

/// The `compile_error!`s in an expansion, each once, as rustc prints them.
fn collect(tokens: TokenStream, errors: &mut Vec<Error>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for window in tokens.windows(3) {
        if let [
            TokenTree::Ident(name),
            TokenTree::Punct(_),
            TokenTree::Group(argument),
        ] = window
            && name == "compile_error"
            && let Ok(message) = syn::parse2::<LitStr>(argument.stream())
        {
            let (first, last) = (name.span().byte_range(), argument.span().byte_range());
            let error = Error {
                message: message.value(),
                place: first.start..last.end,
            };
            if !errors.contains(&error) {
                errors.push(error);
            }
        }
    }
    for token in tokens {
        if let TokenTree::Group(group) = token {
            collect(group.stream(), errors);
        }
    }
}

impl Error {
    fn rendered(&self, path: &str, source: &str) -> String {
        let place = AnnotationKind::Primary.span(self.place.clone());
        let snippet = Snippet::source(source).path(path).annotation(place);
        let title = Level::ERROR.primary_title(self.message.as_str());
        Renderer::plain().render(&[title.element(snippet)])
    }
}
