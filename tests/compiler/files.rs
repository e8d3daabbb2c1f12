//! Files that are wrong in many ways: they cause errors, and never a panic.

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::TokenStream;
use quote::quote;

use crate::from_root::repository;
use crate::text;
use mounted::errors::Errors;
use mounted::expand::expand_system;
use mounted::syntax;

/// Numbers that look random, the same in each run.
pub struct Random(pub u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 >> 33).unwrap_or(0) % bound.max(1)
    }
}

fn folder() -> PathBuf {
    repository().join("tests/urdf")
}

/// What is made of a file with this text; without mistakes, what is printed of it has none.
fn expanded(name: &str, text: &[u8]) -> TokenStream {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(&path, text).expect("a folder for tests");
    let path = path.to_str().expect("a path in UTF-8");
    let description = quote!((::newton_euler) Robot {
        urdf: #path,
        fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    });
    let tokens = expand_system(description.clone());
    if errors(&tokens) == 0 {
        let mut none = Errors::default();
        let system = syntax::parse_system(description, &mut none).expect("it was read");
        assert!(none.finish().is_none());
        let printed = text::system(&system);
        let again = expand_system(quote!((::newton_euler) #printed));
        assert_eq!(errors(&again), 0, "{printed}");
    }
    tokens
}

pub fn errors(tokens: &TokenStream) -> usize {
    tokens.to_string().matches("compile_error").count()
}

/// Words that make a file another one.
const WORDS: [&str; 24] = [
    "",
    "0",
    "-1",
    "1e400",
    "1e-400",
    "nan",
    "inf",
    "1.5707963",
    "0 0 0",
    "1 1",
    "<",
    "/>",
    "<link name=\"x\"/>",
    "<inertial/>",
    "floating",
    "planar",
    "prismatic",
    "fixed",
    "world",
    "palm",
    "&amp;",
    "\"",
    "\u{e9}",
    "1e99999999999999999999",
];

pub fn mutant(text: &str, random: &mut Random) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..=random.below(3) {
        let place = random.below(bytes.len());
        let end = (place + 1 + random.below(40)).min(bytes.len());
        match random.below(6) {
            0 => bytes[place] = u8::try_from(random.below(256)).unwrap_or(0),
            1 => drop(bytes.drain(place..end)),
            2 => {
                let part = bytes[place..end].to_vec();
                let to = random.below(bytes.len());
                bytes.splice(to..to, part);
            }
            // the text of an attribute
            _ => {
                let mut quotes = (place..bytes.len()).filter(|at| bytes[*at] == b'"');
                if let (Some(first), Some(second)) = (quotes.next(), quotes.next()) {
                    let word = WORDS[random.below(WORDS.len())];
                    bytes.splice(first + 1..second, word.bytes());
                }
            }
        }
        if bytes.is_empty() {
            break;
        }
    }
    bytes
}

#[test]
fn no_file_makes_the_compiler_panic() {
    let text = fs::read_to_string(folder().join("small.urdf")).expect("the file is there");
    assert_eq!(errors(&expanded("small.urdf", text.as_bytes())), 0);
    let (mut random, mut refused) = (Random(0x9e37_79b9_7f4a_7c15), 0);
    for _ in 0..1000 {
        let bytes = mutant(&text, &mut random);
        refused += usize::from(errors(&expanded("mutant.urdf", &bytes)) > 0);
    }
    assert!((400..1000).contains(&refused), "{refused}");
}
