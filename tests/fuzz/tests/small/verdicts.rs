//! What counts as an answer of the expander, and what counts as a failure.

use fuzz::flat::{Token, flatten, unflatten};
use fuzz::verdict::{Answer, Failure, answer, keep_panics, minimized};
use proc_macro2::TokenStream;
use quote::quote;

fn verdict(expansion: impl FnOnce() -> TokenStream) -> Result<Answer, Failure> {
    answer(expansion).map(|(answer, _)| answer)
}

#[test]
fn bodies_and_errors_are_answers() {
    let body = || quote!(pub struct Body {} impl Body {});
    assert_eq!(verdict(body), Ok(Answer::Accepted));
    let error = || quote!(::core::compile_error! { "a mass is positive" } pub struct Body {});
    assert_eq!(verdict(error), Ok(Answer::Rejected));
    let second = || quote! { pub struct Body {} ::core::compile_error! { "`w` is not known" } };
    assert_eq!(verdict(second), Ok(Answer::Rejected));
}

#[test]
fn all_else_is_a_failure() {
    keep_panics();
    let Err(Failure::Panicked(message)) = verdict(|| panic!("no such node")) else {
        panic!("a panic is a failure");
    };
    assert!(message.contains("no such node"), "{message}");
    assert_eq!(verdict(TokenStream::new), Err(Failure::Silent));
    for words in ["", "  "] {
        let error = || quote!(::core::compile_error! { #words } pub struct Body {});
        assert_eq!(verdict(error), Err(Failure::Wordless));
    }
    let nothing = || quote!(::core::compile_error! {});
    assert_eq!(verdict(nothing), Err(Failure::Wordless));
    let unread = || {
        quote! {
            impl Body {
                fn sum(self) -> f64 {
                    let [a, a_1]: [f64; 2] = self.parts();
                    let b = a * 2.0;
                    b + self.c
                }
            }
        }
    };
    assert_eq!(verdict(unread), Err(Failure::Unread("a_1".to_owned())));
    for broken in [
        quote!(pub struct Body),
        quote!(let x = 1;),
        quote!(1.0 + 2.0),
    ] {
        let verdict = verdict(|| broken);
        assert!(
            matches!(verdict, Err(Failure::Unparsable(_))),
            "{verdict:?}"
        );
    }
}

#[test]
fn failures_are_made_small() {
    let tokens = flatten(quote!(a, b, (c, needle, d), e));
    let fails = |tokens: &[Token]| unflatten(tokens).to_string().contains("needle");
    let least = unflatten(&minimized(&tokens, fails));
    assert_eq!(least.to_string(), "needle");
}
