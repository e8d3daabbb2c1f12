//! The gallery of the guide: rustdoc shows the pictures in `docs` as embedded data.

use std::fmt::Write as _;
use std::fs;

const PICTURES: [&str; 4] = ["handle", "top", "glider", "double_pendulum"];

/// The definition of a link whose destination is the picture itself.
fn definition(name: &str) -> String {
    let svg = fs::read_to_string(format!("docs/{name}.svg")).expect("the picture is there");
    let mut text = format!("[{name}]: <data:image/svg+xml;charset=utf-8,");
    for byte in svg.trim_end().bytes() {
        match byte {
            b'%' | b'#' | b'<' | b'>' | b'"' | b'\n' | 128.. => write!(text, "%{byte:02X}"),
            _ => write!(text, "{}", char::from(byte)),
        }
        .expect("strings have no end");
    }
    text + ">\n"
}

/// After a change of a picture: `BLESS=1 cargo test --test pictures`.
#[test]
fn rustdoc_shows_the_pictures_of_the_repository() {
    let definitions = PICTURES.map(definition).concat();
    let path = "runtime/src/guide/gallery_data.md";
    if std::env::var_os("BLESS").is_some() {
        fs::write(path, &definitions).expect("the folder is there");
    }
    let written = fs::read_to_string(path).expect("the data are there");
    assert!(written == definitions, "{path} has other pictures");
    let chapter = include_str!("../../runtime/src/guide/gallery.md");
    for name in PICTURES {
        assert!(
            chapter.contains(&format!("][{name}]")),
            "{name} is not shown"
        );
    }
}
