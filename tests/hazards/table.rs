//! The records of the hazards, and how they are printed.

/// What the straightforward formula does in a case.
pub enum Straightforward {
    /// Its error, and how large it is at least: NaN is larger than anything.
    Fails { error: f64, by: f64 },
    /// Its error, of which nothing is claimed.
    Holds(f64),
    /// There is none.
    None,
}

/// A case of a hazard.
pub struct Record {
    pub case: String,
    pub straightforward: Straightforward,
    pub ours: f64,
    pub limit: f64,
}

impl Record {
    /// A case in which the straightforward formula has this error, which is at least `by`.
    pub fn fails(case: impl Into<String>, error: f64, by: f64) -> Case {
        Case(case.into(), Straightforward::Fails { error, by })
    }

    /// A case in which the straightforward formula may hold.
    pub fn holds(case: impl Into<String>, error: f64) -> Case {
        Case(case.into(), Straightforward::Holds(error))
    }

    /// A case that only the library has.
    pub fn alone(case: impl Into<String>) -> Case {
        Case(case.into(), Straightforward::None)
    }

    pub fn check(&self) {
        let Self {
            case, ours, limit, ..
        } = self;
        assert!(
            ours <= limit,
            "{case}: an error of {ours:e}, above {limit:e}"
        );
        if let Straightforward::Fails { error, by } = self.straightforward {
            let is_wrong = error.is_nan() || error >= by;
            assert!(
                is_wrong,
                "{case}: the straightforward formula is off by {error:e}, not {by:e}"
            );
        }
    }
}

/// A case without what the library makes of it.
pub struct Case(String, Straightforward);

impl Case {
    /// With the library's error, and what it is at most.
    pub fn ours(self, ours: f64, limit: f64) -> Record {
        let Self(case, straightforward) = self;
        Record {
            case,
            straightforward,
            ours,
            limit,
        }
    }
}

/// Prints all records, as Markdown.
pub fn print(hazards: &[(&str, &str, &[Record])]) {
    println!("\n| | case | straightforward | here | limit |\n|---|---|---|---|---|");
    for (name, what, records) in hazards {
        println!("| **{}** | **{what}** | | | |", name.replacen('h', "H", 1));
        for record in *records {
            let straightforward = match record.straightforward {
                Straightforward::Fails { error, .. } | Straightforward::Holds(error) => {
                    shown(error)
                }
                Straightforward::None => String::from("-"),
            };
            let [ours, limit] = [record.ours, record.limit].map(shown);
            println!(
                "| | {} | {straightforward} | {ours} | {limit} |",
                record.case
            );
        }
    }
}

fn shown(error: f64) -> String {
    if error == 0.0 {
        String::from("0")
    } else if error.is_nan() || error.is_infinite() {
        format!("{error}")
    } else {
        format!("{error:.1e}")
    }
}
