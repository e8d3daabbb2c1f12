//! The counts on record.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;

const FILE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/benches/instructions/counts.txt"
);

/// The number of instructions of each body.
pub struct Record(BTreeMap<String, u32>);

impl<'a> FromIterator<(&'a str, u32)> for Record {
    fn from_iter<I: IntoIterator<Item = (&'a str, u32)>>(counts: I) -> Self {
        let counts = counts.into_iter();
        Self(
            counts
                .map(|(name, count)| (name.to_owned(), count))
                .collect(),
        )
    }
}

impl Record {
    /// The content of the file.
    pub fn read() -> Self {
        let text = fs::read_to_string(FILE).expect("the file of counts");
        let lines = text.lines().map(|line| {
            let (name, count) = line.split_once(' ').expect("a name and a count");
            (name, count.trim().parse().expect("a count"))
        });
        lines.collect()
    }

    pub fn write(&self) {
        let mut text = String::new();
        for (name, count) in &self.0 {
            writeln!(text, "{name:<28}{count:>6}").expect("a string takes all");
        }
        fs::write(FILE, text).expect("the file of counts can be written");
    }

    /// Prints these counts next to the recorded ones, and returns what is wrong with them.
    pub fn compare(&self, recorded: &Self) -> Vec<String> {
        println!(
            "instructions of one acceleration{:>9}{:>10}",
            "now", "recorded"
        );
        let mut faults = Vec::new();
        for (name, &now) in &self.0 {
            let Some(&before) = recorded.0.get(name) else {
                faults.push(format!("{name}: {now} instructions, none on record"));
                continue;
            };
            println!("{name:<32}{now:>9}{before:>10}");
            if now * 100 > before * 105 {
                faults.push(format!(
                    "{name}: {now} instructions, more than {before} + 5 %"
                ));
            }
        }
        for name in recorded.0.keys().filter(|name| !self.0.contains_key(*name)) {
            faults.push(format!("{name}: on record, and not counted"));
        }
        faults
    }
}
