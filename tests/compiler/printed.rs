//! The descriptions that files are turned into, as text. `BLESS=1` writes files that are compiled
//! again.

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{Item, ItemMacro};

use crate::from_root::{from_root, repository};
use crate::text;
use mounted::errors::Errors;
use mounted::syntax;

fn path(name: &str) -> PathBuf {
    repository().join("tests").join(name)
}

/// The macros in a file, in the order in which they stand there.
fn macros(path: &Path) -> Vec<ItemMacro> {
    let source = fs::read_to_string(path).expect("a file that can be read");
    let items = syn::parse_file(&source).expect("a file of Rust").items;
    let macros = items.into_iter().filter_map(|item| match item {
        Item::Macro(item) => Some(item),
        _ => None,
    });
    macros.collect()
}

/// The description of a file with all its values, under another name.
fn printed(description: &TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    let description = from_root(description.clone());
    let system = syntax::parse_system(quote!((::newton_euler) #description), &mut errors);
    assert!(errors.finish().is_none(), "{description}");
    let mut system = system.expect("a description without mistakes");
    system.top.name = format_ident!("{}Printed", system.top.name);
    text::system(&system)
}

/// The descriptions of a folder with a file, printed, are those that stand in `printed` there, each in
/// a file of its own.
fn check(folder: &str, key: &str) {
    let all = macros(&path(folder).join("described.rs"));
    let tokens = all.iter().map(|item| &item.mac.tokens);
    let of_files = tokens.filter(|tokens| tokens.to_string().contains(&format!("{key} :")));
    let found: Vec<TokenStream> = of_files.map(printed).collect();
    assert!(found.len() > 3);
    for one in found {
        let name = one.to_string();
        let name = name
            .split("Printed")
            .next()
            .unwrap_or_default()
            .to_lowercase();
        let target = path(folder).join("printed").join(name + ".rs");
        if std::env::var_os("BLESS").is_some() {
            let head = "//! The description of a file with all its values, as `describe` prints it.\n\n\
                        use newton_euler::prelude::*;\n";
            let whole = format!("{head}\nrigid_system!({one});\n");
            fs::write(&target, text::laid_out(&whole)).expect("a folder of tests");
        }
        let blessed = macros(&target);
        let blessed: Vec<String> = blessed.iter().map(|item| plain(&item.mac.tokens)).collect();
        assert_eq!(blessed, [plain(&one)]);
    }
}

/// Without the commas that a layout may have behind the last entry.
fn plain(tokens: &TokenStream) -> String {
    let text = tokens.to_string().replace(['\n', ' '], "");
    let ends = [",]", ",}", ",)"];
    ends.iter()
        .fold(text, |text, end| text.replace(end, &end[1..]))
}

#[test]
fn what_urdf_files_amount_to_is_printed() {
    check("urdf", "urdf");
}

#[test]
fn what_files_of_mujoco_amount_to_is_printed() {
    check("mjcf", "mjcf");
}
