//! Pictures, read as markup: what is drawn, where, and with which words.

mod gallery;
mod page;
mod plot;

use newton_euler::integrate::Sample;
use newton_euler::prelude::*;
use roxmltree::{Document, Node, ParsingOptions};

/// Samples of a hinge every tenth of a second.
fn hinge(count: u32, angle: impl Fn(f64) -> f64) -> Vec<Sample<Hinge>> {
    let times = (0..count).map(|k| 0.1 * f64::from(k));
    times
        .map(|time| Sample {
            time,
            state: Hinge {
                angle: angle(time),
                angular_velocity: time,
            },
        })
        .collect()
}

/// Markup as a tree; it is well formed.
fn parsed(markup: &str) -> Document<'_> {
    let options = ParsingOptions {
        allow_dtd: true,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(markup, options).expect("well formed")
}

/// The elements of a class, in order.
fn of_class<'d>(tree: &'d Document<'d>, class: &str) -> Vec<Node<'d, 'd>> {
    let has_class = |node: &Node<'_, '_>| {
        let classes = node.attribute("class").unwrap_or_default();
        classes.split(' ').any(|other| other == class)
    };
    tree.descendants().filter(has_class).collect()
}

/// All texts, in order.
fn texts(tree: &Document<'_>) -> Vec<String> {
    let nodes = tree
        .descendants()
        .filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "text")));
    nodes
        .filter_map(|node| node.text().map(String::from))
        .collect()
}
